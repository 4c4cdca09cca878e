//! Campaigns in folders.

use crate::computing::{compute, compute_long};
use crate::errors::{failed, json, refused};
use crate::tables::columns;
use etalon::run::documents::Documents;
use etalon::run::pipeline::Wanted;
use etalon::run::{batch as batches, validation};
use etalon::stages::evaluate::error_table::to_table;
use etalon::stages::uncertainty::monte_carlo::Draws;
use etalon::tasks::{self, Document, GivenParameters, Ran, parse_options};
use etalon_base::message::Problems;
use etalon_campaign::Campaign;
use etalon_documents::AccuracyDocument;
use pyo3::prelude::*;
use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Runs a campaign; returns whether every limit is met, the output folder, and the messages as JSON.
#[pyfunction]
pub fn run(py: Python<'_>, folder: PathBuf, reports: bool) -> PyResult<(bool, PathBuf, String)> {
    let wanted = if reports { Wanted::Reports } else { Wanted::Documents };
    let ran = compute_long(py, None, |_| tasks::run(&Campaign::read(&folder)?, wanted));
    let Ran { folder, results, messages, .. } = ran?.map_err(refused)?;
    Ok((results.verdict.passes(), folder, json(&messages)?))
}

/// Errors of the readings of a run as columns, from its output folder.
#[pyfunction]
pub fn residuals(py: Python<'_>, folder: PathBuf) -> PyResult<String> {
    let table = compute(py, || {
        let documents = Documents::open(&folder)?;
        let accuracy: AccuracyDocument = documents.json("accuracy.json")?;
        Ok::<_, Problems>(to_table(&documents.errors(&accuracy)?, &accuracy.joints))
    });
    columns(table?.map_err(refused)?)
}

/// Everything that is wrong with a campaign.
#[pyfunction]
pub fn check(py: Python<'_>, folder: PathBuf) -> PyResult<String> {
    json(&compute_long(py, None, |_| tasks::check(&folder))?)
}

/// Given parameters on the data of a campaign, with a residual field if there is one; nominal ones
/// without.
#[pyfunction]
pub fn validate(
    py: Python<'_>,
    folder: PathBuf,
    parameters: Option<&str>,
    field: Option<&str>,
    options: &str,
) -> PyResult<String> {
    let options = parse_options(options).map_err(refused)?;
    let field = field.map(|text| Document::Text { name: "field", text });
    let given = parameters.map(|text| Document::Text { name: "parameters", text });
    let given = given.map(|parameters| GivenParameters { parameters, field });
    let validated = compute_long(py, None, |_| tasks::validate(&Campaign::read(&folder)?, given, &options));
    json(&validated?.map_err(refused)?.accuracy)
}

/// Which parameters deserve to be loaded. `progress` is called with what is done and the whole.
#[pyfunction]
pub fn recommend(py: Python<'_>, folder: PathBuf, progress: Option<Py<PyAny>>) -> PyResult<String> {
    let found = compute_long(py, progress, |progress| {
        validation::recommend(&Campaign::read(&folder)?, &mut |done, whole| progress.report(done, whole))
    });
    json(&found?.map_err(refused)?)
}

/// Numbers of draws, a dictionary in Python.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Drawn {
    /// Maximum number of draws.
    draws: usize,
    /// Number of resamples.
    resamples: usize,
    /// Seed of the draws.
    seed: u64,
}

/// Distributions of the results by Monte Carlo and bootstrap.
#[pyfunction]
pub fn uncertainty(py: Python<'_>, folder: PathBuf, drawn: Drawn, progress: Option<Py<PyAny>>) -> PyResult<String> {
    let draws = Draws { most: drawn.draws, resamples: drawn.resamples, seed: drawn.seed };
    let found = compute_long(py, progress, |progress| {
        let mut report = |done, whole| progress.report(done, whole);
        validation::uncertainty(&Campaign::read(&folder)?, draws, &mut report)
    });
    json(&found?.map_err(refused)?)
}

/// Runs campaigns on all cores. Results are written to `batch.parquet` and `batch.html` by the command alone.
#[pyfunction]
pub fn batch(py: Python<'_>, folders: Vec<PathBuf>, reports: bool, progress: Option<Py<PyAny>>) -> PyResult<String> {
    let wanted = if reports { Wanted::Reports } else { Wanted::Documents };
    let document = compute_long(py, progress, |progress| {
        let campaigns = batches::folders(&folders)?;
        let ended = AtomicUsize::new(0);
        let said = |_: &etalon_documents::BatchEntry| {
            progress.report(ended.fetch_add(1, Ordering::Relaxed) + 1, campaigns.len());
        };
        Ok::<_, anyhow::Error>(batches::batch(&campaigns, wanted, None, std::io::sink(), said)?.document)
    });
    json(&document?.map_err(failed)?)
}
