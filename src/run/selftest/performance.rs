//! Performance qualification: a laboratory's own frozen campaign is run again, and each number is
//! compared with the stored document.

use crate::run::documents::read_parameters;
use crate::run::pipeline::evaluate;
use etalon_base::message::{Place, Result};
use etalon_base::worded::Worded;
use etalon_base::{error, phrase};
use etalon_campaign::Campaign;
use etalon_documents::{MovedValue, ParameterEntry, ParametersDocument, SelftestPerformance};
use std::path::Path;

/// Permissible difference of a value, in its standard uncertainty.
pub const OF_UNCERTAINTY: f64 = 1e-6;
/// Permissible relative difference of a value without uncertainty, and of an uncertainty itself.
pub const RELATIVE: f64 = 1e-9;

/// Runs a campaign and compares its parameters with a stored document. Nothing is written.
///
/// # Errors
/// Fails if the campaign cannot be run or identifies nothing, or if the document cannot be read.
pub fn performance(folder: &Path, expected: &Path) -> Result<SelftestPerformance> {
    let campaign = Campaign::read(folder)?;
    let stored = read_parameters(expected)?;
    let Some(identified) = evaluate(&campaign)?.results.identified else {
        return Err(error!("identify-missing").at(Place::file(campaign.path.as_str())).into());
    };
    let found = identified.parameters;
    let moved = moved(&stored, &found);
    let causes = causes(&stored, &found);
    Ok(SelftestPerformance {
        campaign: campaign.file.name.clone(),
        expected: expected.display().to_string(),
        compared: found.parameters.len(),
        tolerance_of_uncertainty: OF_UNCERTAINTY,
        relative_tolerance: RELATIVE,
        pass: moved.is_empty(),
        moved,
        causes: causes.into_iter().map(Worded::from).collect(),
    })
}

/// Values and uncertainties that differ by more than rounding, and parameters of one document
/// alone.
fn moved(stored: &ParametersDocument, found: &ParametersDocument) -> Vec<MovedValue> {
    let mut all = Vec::new();
    let of =
        |document: &'_ ParametersDocument, name: &str| document.parameters.iter().find(|p| p.name == name).cloned();
    for before in &stored.parameters {
        match of(found, &before.name) {
            Some(after) => all.extend(differences(before, &after)),
            None => all.push(one(before, "value", [Some(before.value), None], None)),
        }
    }
    let new = found.parameters.iter().filter(|p| of(stored, &p.name).is_none());
    all.extend(new.map(|after| one(after, "value", [None, Some(after.value)], None)));
    let (before, after) = (&stored.residuals, &found.residuals);
    if !same(before.rms, after.rms) {
        all.push(MovedValue {
            parameter: String::new(),
            quantity: "rms".to_owned(),
            unit: "mm".to_owned(),
            before: Some(before.rms),
            after: Some(after.rms),
            over_uncertainty: None,
        });
    }
    all
}

/// Differences of one parameter.
fn differences(before: &ParameterEntry, after: &ParameterEntry) -> Vec<MovedValue> {
    let mut all = Vec::new();
    let u = before.standard_uncertainty.filter(|u| *u > 0.0);
    let ratio = u.map(|u| (after.value - before.value).abs() / u);
    if ratio.map_or_else(|| !same(before.value, after.value), |ratio| ratio.is_nan() || ratio > OF_UNCERTAINTY) {
        all.push(one(after, "value", [Some(before.value), Some(after.value)], ratio));
    }
    let pair = [before.standard_uncertainty, after.standard_uncertainty];
    let differs = match pair {
        [Some(a), Some(b)] => !same_uncertainty(a, b),
        [a, b] => a.is_some() != b.is_some(),
    };
    if differs {
        all.push(one(after, "standard_uncertainty", pair, None));
    }
    all
}

fn one(entry: &ParameterEntry, quantity: &str, [before, after]: [Option<f64>; 2], over: Option<f64>) -> MovedValue {
    MovedValue {
        parameter: entry.name.clone(),
        quantity: quantity.to_owned(),
        unit: entry.unit.clone(),
        before,
        after,
        over_uncertainty: over,
    }
}

/// `true` if two numbers differ by rounding only.
fn same(a: f64, b: f64) -> bool {
    (a - b).abs() <= RELATIVE * a.abs().max(b.abs()).max(1e-12)
}

/// `true` if two uncertainties differ by rounding only: they are sums of many terms.
fn same_uncertainty(a: f64, b: f64) -> bool {
    (a - b).abs() <= OF_UNCERTAINTY * a.abs().max(b.abs())
}

/// Known differences between the documents that may explain other numbers.
fn causes(stored: &ParametersDocument, found: &ParametersDocument) -> Vec<etalon_base::catalogue::Phrase> {
    let mut all = Vec::new();
    let (before, after) = (&stored.provenance, &found.provenance);
    if before.version != after.version {
        all.push(phrase!("selftest-other-version", before = before.version, after = after.version));
    }
    for (file, hash) in &after.inputs {
        match before.inputs.get(file) {
            Some(stored) if stored != hash => all.push(phrase!("selftest-other-input", file)),
            None => all.push(phrase!("selftest-new-input", file)),
            _ => {}
        }
    }
    let gone = before.inputs.keys().filter(|file| !after.inputs.contains_key(*file));
    all.extend(gone.map(|file| phrase!("selftest-missing-input", file)));
    if stored.robot != found.robot {
        all.push(phrase!("selftest-other-model", before = stored.robot, after = found.robot));
    }
    all
}
