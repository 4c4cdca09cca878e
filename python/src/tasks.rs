//! Tasks on tables in memory. Options are a JSON object.

use crate::computing::compute_long;
use crate::errors::{failed, json, refused};
use crate::robot::Robot;
use crate::tables::columns;
use etalon::cli;
use etalon::run::documents::parse_parameters;
use etalon::stages::evaluate::error_table::to_table;
use etalon::tasks::{self, RecordingTables, Table, TableFormat, TestTables, parse_options};
use pyo3::prelude::*;
use std::path::Path;

/// A table: its path, or its name and CSV text.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Named {
    /// Path, or name for messages.
    name: String,
    /// CSV text of a table in memory.
    text: Option<String>,
    /// Sheet of a workbook, if it is that of this file alone.
    sheet: Option<String>,
    /// Headings of this table alone, `NAME=HEADING`.
    columns: Vec<String>,
}

impl Named {
    /// The table without the headings of its own.
    fn table(&self) -> Table<'_> {
        match (&self.text, &self.sheet) {
            (Some(text), _) => Table::Text { name: &self.name, text },
            (None, Some(sheet)) => Table::Sheet { path: Path::new(&self.name), sheet },
            (None, None) => Table::File(Path::new(&self.name)),
        }
    }

    /// A table with the headings of its own.
    fn headed<'a>(&'a self, table: &'a Table<'a>) -> Table<'a> {
        match &self.columns[..] {
            [] => *table,
            columns => Table::Headed { table, columns },
        }
    }
}

/// `parameters.json` identified from a table of observations, and the errors of its readings as
/// columns.
#[pyfunction]
pub fn identify(py: Python<'_>, robot: &Robot, observations: Named, options: &str) -> PyResult<(String, String)> {
    let (inputs, options) = (robot.inputs(observations.table()), parse_options(options).map_err(refused)?);
    let found = compute_long(py, None, |_| tasks::identify(&inputs, &options))?.map_err(failed)?;
    let errors = to_table(&found.errors, &robot.joints()?);
    Ok((json(&found.document)?, columns(errors)?))
}

/// The poses to measure among candidates.
#[pyfunction]
pub fn plan(
    py: Python<'_>,
    robot: &Robot,
    candidates: Named,
    options: &str,
    progress: Option<Py<PyAny>>,
) -> PyResult<String> {
    let (inputs, options) = (robot.inputs(candidates.table()), parse_options(options).map_err(refused)?);
    let planned = compute_long(py, progress, |progress| {
        tasks::plan(&inputs, &options, &|done, whole| progress.report(done, whole))
    });
    json(&planned?.map_err(failed)?)
}

/// Verdict on whether parameters still apply.
#[pyfunction]
pub fn verify(py: Python<'_>, robot: &Robot, parameters: &str, observations: Named, options: &str) -> PyResult<String> {
    let (inputs, options) = (robot.inputs(observations.table()), parse_options(options).map_err(refused)?);
    let verified = compute_long(py, None, |_| {
        let parameters = parse_parameters("parameters", parameters)?;
        tasks::verify(&inputs, &parameters, &options)
    });
    json(&verified?.map_err(refused)?)
}

/// Axes of joints from sweeps of one joint at a time.
#[pyfunction]
pub fn axes(py: Python<'_>, table: Named, options: &str) -> PyResult<String> {
    let options = parse_options(options).map_err(refused)?;
    json(&compute_long(py, None, |_| tasks::axes(table.table(), &options))?.map_err(refused)?)
}

/// Tool, object, hand and eye, or an external axis.
#[pyfunction]
pub fn cell(py: Python<'_>, table: Named, options: &str) -> PyResult<String> {
    let options = parse_options(options).map_err(refused)?;
    json(&compute_long(py, None, |_| tasks::cell(table.table(), &options))?.map_err(refused)?)
}

/// Explanation of the message with this id, or of all messages.
#[pyfunction]
pub fn explain(id: Option<&str>) -> PyResult<String> {
    json(&tasks::explain(id).map_err(refused)?)
}

/// JSON Schema of an input file or of a document.
#[pyfunction]
pub fn schema(name: &str) -> PyResult<&'static str> {
    tasks::schema(name).map_err(refused)
}

/// Runs a command with `--json` if it has this option: exit code, stdout, stderr, and messages as
/// JSON.
#[pyfunction]
pub fn command(py: Python<'_>, words: Vec<String>) -> PyResult<(u8, String, String, String)> {
    let words = ["etalon".to_owned()].into_iter().chain(words).collect();
    let answer = compute_long(py, None, |_| cli::answer_in_json(words))?;
    let text = String::from_utf8(answer.stdout)?;
    Ok((answer.code, text, answer.stderr, json(&answer.messages)?))
}

/// Characteristics of poses by ISO 9283, from attained poses, commanded ones and reference targets.
#[pyfunction]
pub fn iso9283(
    py: Python<'_>,
    attained: Named,
    beside: [Option<Named>; 2],
    options: [String; 2],
    seed: u64,
) -> PyResult<String> {
    let [options, format] = options;
    let (options, format) = (parse_options(&options).map_err(refused)?, reading(&format)?);
    let (first, others) = (attained.table(), beside.each_ref().map(|stated| stated.as_ref().map(Named::table)));
    let [commanded, reference] = [0, 1].map(|i| Some(beside[i].as_ref()?.headed(others[i].as_ref()?)));
    let tables = TestTables { attained: attained.headed(&first), commanded, reference };
    json(&compute_long(py, None, |_| tasks::iso9283(&tables, &format, &options, seed))?.map_err(refused)?)
}

/// Characteristics of a motion by ISO 9283, from a recording, commanded poses and a commanded path.
#[pyfunction]
pub fn iso9283_path(
    py: Python<'_>,
    recording: Named,
    beside: [Option<Named>; 2],
    options: &str,
    seed: u64,
) -> PyResult<String> {
    let options = parse_options(options).map_err(refused)?;
    let (first, others) = (recording.table(), beside.each_ref().map(|stated| stated.as_ref().map(Named::table)));
    let [commanded, path] = [0, 1].map(|i| Some(beside[i].as_ref()?.headed(others[i].as_ref()?)));
    let tables = RecordingTables { recording: recording.headed(&first), commanded, path };
    json(&compute_long(py, None, |_| tasks::iso9283_path(&tables, &options, seed))?.map_err(refused)?)
}

/// Positioning of a linear axis by ISO 230-2.
#[pyfunction]
pub fn iso230(py: Python<'_>, table: Named, format: &str) -> PyResult<String> {
    let format = reading(format)?;
    json(&compute_long(py, None, |_| tasks::iso230(table.table(), &format))?.map_err(refused)?)
}

/// Options for the reading of tables.
fn reading(options: &str) -> PyResult<TableFormat> {
    parse_options(options).map_err(refused)
}
