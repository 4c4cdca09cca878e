//! Commands on tables in memory.

use crate::errors::{failed, json};
use crate::robot::Robot;
use etalon::cli::in_memory::{self, Table};
use etalon::run::documents::parse_parameters;
use pyo3::prelude::*;

/// Name and CSV text of a table.
type Named = (String, String);

/// `parameters.json` identified from a table of observations.
#[pyfunction]
pub fn identify(py: Python<'_>, robot: &Robot, observations: Named, options: Vec<String>) -> PyResult<String> {
    let given = robot.given(table(&observations));
    json(&py.detach(|| in_memory::identify(&given, &options)).map_err(failed)?)
}

/// The poses to measure among candidates.
#[pyfunction]
pub fn plan(py: Python<'_>, robot: &Robot, candidates: Named, options: Vec<String>) -> PyResult<String> {
    let given = robot.given(table(&candidates));
    json(&py.detach(|| in_memory::plan(&given, &options)).map_err(failed)?)
}

/// Whether parameters still hold.
#[pyfunction]
pub fn verify(
    py: Python<'_>,
    robot: &Robot,
    parameters: &str,
    observations: Named,
    options: Vec<String>,
) -> PyResult<String> {
    let given = robot.given(table(&observations));
    let verified = py.detach(|| {
        let parameters = parse_parameters("parameters", parameters)?;
        in_memory::verify(&given, &parameters, &options)
    });
    json(&verified.map_err(failed)?)
}

/// Axes of joints from sweeps of one joint at a time.
#[pyfunction]
pub fn axes(py: Python<'_>, table: Named, options: Vec<String>) -> PyResult<String> {
    let table = self::table(&table);
    json(&py.detach(|| in_memory::axes(&table, &options)).map_err(failed)?)
}

/// Tool, object, hand and eye, or an external axis.
#[pyfunction]
pub fn cell(py: Python<'_>, table: Named, options: Vec<String>) -> PyResult<String> {
    let table = self::table(&table);
    json(&py.detach(|| in_memory::cell(&table, &options)).map_err(failed)?)
}

/// Runs a command with `--json` if it has this option: exit code, stdout, stderr, and messages as
/// JSON.
#[pyfunction]
pub fn command(py: Python<'_>, words: Vec<String>) -> PyResult<(u8, String, String, String)> {
    let mut words: Vec<String> = ["etalon".to_owned()].into_iter().chain(words).collect();
    let answer = py.detach(|| {
        if in_memory::has_json(&words) && !words.iter().any(|word| word == "--json") {
            words.push("--json".to_owned());
        }
        in_memory::answer(words.into_iter().map(Into::into))
    });
    let text = String::from_utf8(answer.stdout)?;
    Ok((answer.code, text, answer.stderr, json(&answer.messages)?))
}

/// Characteristics of poses by ISO 9283, from attained poses, commanded ones and reference targets.
#[pyfunction]
pub fn iso9283(py: Python<'_>, tables: [Option<Named>; 3], options: Vec<String>) -> PyResult<String> {
    let [attained, commanded, reference] = tables.each_ref().map(|given| given.as_ref().map(table));
    let tables = [attained.as_ref(), commanded.as_ref(), reference.as_ref()];
    json(&py.detach(|| in_memory::iso9283(tables, &options)).map_err(failed)?)
}

/// Characteristics of a motion by ISO 9283, from a recording, commanded poses and a commanded path.
#[pyfunction]
pub fn iso9283_path(py: Python<'_>, tables: [Option<Named>; 3], options: Vec<String>) -> PyResult<String> {
    let [recording, commanded, path] = tables.each_ref().map(|given| given.as_ref().map(table));
    let tables = [recording.as_ref(), commanded.as_ref(), path.as_ref()];
    json(&py.detach(|| in_memory::iso9283_path(tables, &options)).map_err(failed)?)
}

/// Positioning of a linear axis by ISO 230-2.
#[pyfunction]
pub fn iso230(py: Python<'_>, table: Named) -> PyResult<String> {
    json(&py.detach(|| in_memory::iso230(&self::table(&table))).map_err(failed)?)
}

fn table((name, text): &Named) -> Table<'_> {
    Table { name, text }
}
