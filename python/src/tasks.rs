//! Tasks on tables in memory. Options are a JSON object.

use crate::errors::{failed, json, refused};
use crate::robot::Robot;
use etalon::cli;
use etalon::run::documents::parse_parameters;
use etalon::tasks::{self, RecordingTables, Table, TableFormat, TestTables, parse_options};
use pyo3::prelude::*;

/// Name and CSV text of a table.
type Named = (String, String);

/// `parameters.json` identified from a table of observations.
#[pyfunction]
pub fn identify(py: Python<'_>, robot: &Robot, observations: Named, options: &str) -> PyResult<String> {
    let (inputs, options) = (robot.inputs(table(&observations)), parse_options(options).map_err(refused)?);
    json(&py.detach(|| tasks::identify(&inputs, &options)).map_err(failed)?)
}

/// The poses to measure among candidates.
#[pyfunction]
pub fn plan(py: Python<'_>, robot: &Robot, candidates: Named, options: &str) -> PyResult<String> {
    let (inputs, options) = (robot.inputs(table(&candidates)), parse_options(options).map_err(refused)?);
    json(&py.detach(|| tasks::plan(&inputs, &options, &|_, _| {})).map_err(failed)?)
}

/// Verdict on whether parameters still apply.
#[pyfunction]
pub fn verify(py: Python<'_>, robot: &Robot, parameters: &str, observations: Named, options: &str) -> PyResult<String> {
    let (inputs, options) = (robot.inputs(table(&observations)), parse_options(options).map_err(refused)?);
    let verified = py.detach(|| {
        let parameters = parse_parameters("parameters", parameters)?;
        tasks::verify(&inputs, &parameters, &options)
    });
    json(&verified.map_err(refused)?)
}

/// Axes of joints from sweeps of one joint at a time.
#[pyfunction]
pub fn axes(py: Python<'_>, table: Named, options: &str) -> PyResult<String> {
    let options = parse_options(options).map_err(refused)?;
    json(&py.detach(|| tasks::axes(self::table(&table), &options)).map_err(refused)?)
}

/// Tool, object, hand and eye, or an external axis.
#[pyfunction]
pub fn cell(py: Python<'_>, table: Named, options: &str) -> PyResult<String> {
    let options = parse_options(options).map_err(refused)?;
    json(&py.detach(|| tasks::cell(self::table(&table), &options)).map_err(refused)?)
}

/// Runs a command with `--json` if it has this option: exit code, stdout, stderr, and messages as
/// JSON.
#[pyfunction]
pub fn command(py: Python<'_>, words: Vec<String>) -> PyResult<(u8, String, String, String)> {
    let words = ["etalon".to_owned()].into_iter().chain(words).collect();
    let answer = py.detach(|| cli::answer_in_json(words));
    let text = String::from_utf8(answer.stdout)?;
    Ok((answer.code, text, answer.stderr, json(&answer.messages)?))
}

/// Characteristics of poses by ISO 9283, from attained poses, commanded ones and reference targets.
#[pyfunction]
pub fn iso9283(
    py: Python<'_>,
    attained: Named,
    beside: [Option<Named>; 2],
    options: &str,
    seed: u64,
) -> PyResult<String> {
    let options = parse_options(options).map_err(refused)?;
    let [commanded, reference] = beside.each_ref().map(|stated| stated.as_ref().map(table));
    let tables = TestTables { attained: table(&attained), commanded, reference };
    json(&py.detach(|| tasks::iso9283(&tables, &TableFormat::default(), &options, seed)).map_err(refused)?)
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
    let [commanded, path] = beside.each_ref().map(|stated| stated.as_ref().map(table));
    let tables = RecordingTables { recording: table(&recording), commanded, path };
    json(&py.detach(|| tasks::iso9283_path(&tables, &options, seed)).map_err(refused)?)
}

/// Positioning of a linear axis by ISO 230-2.
#[pyfunction]
pub fn iso230(py: Python<'_>, table: Named) -> PyResult<String> {
    json(&py.detach(|| tasks::iso230(self::table(&table))).map_err(refused)?)
}

fn table((name, text): &Named) -> Table<'_> {
    Table::Text { name, text }
}
