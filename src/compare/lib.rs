//! Comparison of several campaigns of one robot: significant changes and chance.
//!
//! The input consists of documents ([`Compared`]), the output is a single document. The mathematics
//! is in [`significance`].

mod characteristics;
mod errors;
mod parameters;
mod paths;
pub mod significance;
mod trend;

use etalon_base::catalogue::Phrase;
use etalon_base::message::{Message, Problems, Result, one_line};
use etalon_base::worded::Worded;
use etalon_base::{error, phrase, warning};
use etalon_documents::*;
use std::collections::{BTreeMap, BTreeSet};
use trend::judge;

/// Contents of a campaign's output folder.
#[derive(Clone, Debug)]
pub struct Compared {
    /// Folder, as the user named it.
    pub folder: String,
    /// Administrative data of the campaign.
    pub campaign: CampaignSummary,
    /// Parameters with the errors before and after calibration, if identified.
    pub identified: Option<(ParametersDocument, AccuracyDocument)>,
    /// Characteristics of poses, if tested.
    pub iso9283: Option<Iso9283Document>,
    /// Recorded motions, if any.
    pub streams: Option<Iso9283StreamsDocument>,
    /// SHA-256 of the documents, by name.
    pub inputs: BTreeMap<String, String>,
    /// SHA-256 of the readings, if the folder contains a file of them.
    pub readings: Option<String>,
}

/// Compares at least two campaigns, the oldest first.
pub fn compare(all: &[Compared]) -> Result<CompareDocument> {
    refuse(all)?;
    let mut messages = Vec::new();
    let mut trends = Vec::new();
    let mut together = Vec::new();
    let mut between_series = Vec::new();
    let identified: Vec<_> = all.iter().filter_map(|c| c.identified.as_ref()).collect();
    let tested: Vec<_> = all.iter().filter_map(|c| c.iso9283.as_ref()).collect();
    if identified.len() == all.len() {
        trends.extend(parameters::trends(&identified, &mut messages));
        trends.extend(errors::trends(&identified));
        let names: Vec<&str> = all.iter().map(|c| c.folder.as_str()).collect();
        let (of_pairs, message) = parameters::without_evidence(&identified, &mut trends, &names);
        messages.extend(message);
        between_series = of_pairs;
        together = parameters::together(&identified, &trends);
    }
    if tested.len() == all.len() {
        trends.extend(characteristics::trends(&tested, &mut messages));
    }
    let recorded: Vec<_> = all.iter().filter_map(|c| c.streams.as_ref()).collect();
    if recorded.len() == all.len() {
        trends.extend(paths::trends(&recorded, &mut messages));
    }
    messages.extend(left_out(all, "parameters.json", |c| c.identified.is_some()));
    messages.extend(left_out(all, "iso9283.json", |c| c.iso9283.is_some()));
    messages.extend(left_out(all, "iso9283-streams.json", |c| c.streams.is_some()));
    if trends.is_empty() {
        return Err(error!("nothing-to-compare").into());
    }
    judge(&mut trends, |names, pair| Some(parameters::change(&identified, names, pair)?.correlation()));
    messages.extend(copied(all));
    messages.extend(disorder(all));
    messages.extend(paths::doubt(&trends));
    let conventions = conventions(all, &trends, !between_series.is_empty());
    Ok(CompareDocument {
        schema: "etalon/compare/1".to_owned(),
        robot: identified.first().map(|i| i.0.robot.clone()),
        conventions: conventions.into_iter().map(Worded::from).collect(),
        campaigns: all.iter().map(campaign).collect(),
        trends,
        together,
        between_series,
        messages,
        provenance: Provenance {
            version: env!("CARGO_PKG_VERSION").to_owned(),
            inputs: all.iter().flat_map(|c| c.inputs.clone()).collect(),
            seed: None,
        },
    })
}

/// Rejects campaigns that cannot be compared, with all reasons at once.
fn refuse(all: &[Compared]) -> Result<()> {
    if all.len() < 2 {
        return Err(error!("one-campaign").into());
    }
    let mut problems = Problems::default();
    let mut folders = BTreeSet::new();
    for c in all.iter().filter(|c| !folders.insert(&c.folder)) {
        problems.0.push(error!("campaign-twice", folder = c.folder));
    }
    let first = &all[0];
    for c in &all[1..] {
        let named = |c: &Compared| c.campaign.robot.clone();
        if let (Some(this), Some(that)) = (named(first), named(c))
            && this != that
        {
            problems.0.push(error!(
                "robots-differ",
                first = first.folder,
                first_robot = this,
                second = c.folder,
                second_robot = that,
            ));
        }
        let (Some((this, _)), Some((that, _))) = (&first.identified, &c.identified) else { continue };
        if this.robot != that.robot {
            problems.0.push(error!(
                "models-differ",
                first = first.folder,
                first_model = this.robot,
                second = c.folder,
                second_model = that.robot,
            ));
            continue;
        }
        let names = |d: &ParametersDocument| d.parameters.iter().map(|p| p.name.clone()).collect::<BTreeSet<_>>();
        let other: Vec<String> = names(this).symmetric_difference(&names(that)).cloned().collect();
        if !other.is_empty() {
            let message = error!("parameters-differ", first = first.folder, second = c.folder, parameters = other);
            problems.0.push(message);
        }
    }
    problems.check().map(|_| ())
}

/// Warning about folders with the same readings: a copy of a campaign shows no change.
fn copied(all: &[Compared]) -> Option<Message> {
    let same = |(k, later): (usize, &Compared)| {
        let earlier = all[..k].iter().find(|c| c.readings.is_some() && c.readings == later.readings)?;
        Some(phrase!("same-readings", first = earlier.folder, second = later.folder))
    };
    let pairs: Vec<Phrase> = all.iter().enumerate().filter_map(same).collect();
    (!pairs.is_empty()).then(|| warning!("campaigns-with-same-readings", count = pairs.len(), pairs).to_decide())
}

/// Warning if dates in the form year-month-day are not ascending.
fn disorder(all: &[Compared]) -> Option<Message> {
    let figures = |part: &str, count: usize| part.len() == count && part.bytes().all(|b| b.is_ascii_digit());
    let stated = |d: &String| {
        let parts: Vec<&str> = d.split('-').collect();
        matches!(parts[..], [y, m, d] if figures(y, 4) && figures(m, 2) && figures(d, 2))
    };
    let date = |c: &Compared| c.campaign.measurements.date.clone().filter(stated);
    let falls = |pair: &&[Compared]| matches!((date(&pair[0]), date(&pair[1])), (Some(a), Some(b)) if a > b);
    let pair = all.windows(2).find(falls)?;
    Some(warning!("campaigns-out-of-order", first = pair[0].folder, second = pair[1].folder))
}

fn left_out(all: &[Compared], name: &str, there: fn(&Compared) -> bool) -> Option<Message> {
    let (with, without): (Vec<&Compared>, Vec<&Compared>) = all.iter().partition(|c| there(c));
    if with.is_empty() || without.is_empty() {
        return None;
    }
    let folders: Vec<String> = without.iter().map(|c| format!("`{}`", c.folder)).collect();
    Some(warning!("document-not-in-all", document = name, folders))
}

fn campaign(c: &Compared) -> ComparedCampaign {
    let summary = &c.campaign;
    ComparedCampaign {
        folder: c.folder.clone(),
        name: summary.name.clone(),
        robot: summary.robot.clone(),
        date: summary.measurements.date.clone(),
        conditions: summary.conditions.clone(),
        identified: c.identified.iter().flat_map(|i| i.0.identified().map(|p| p.name.clone())).collect(),
        instrument: summary.instrument.name.clone(),
        expanded_uncertainty_um: summary.instrument.expanded_uncertainty_um,
        coverage_factor: summary.instrument.coverage_factor,
        synthetic: summary.measurements.synthetic.clone(),
        uncertainties_from: c.identified.as_ref().map(|i| i.0.residuals.uncertainties_from),
        degrees_of_freedom: c.identified.as_ref().map(|i| parameters::degrees(&i.0)).filter(|d| d.is_finite()),
    }
}

fn conventions(all: &[Compared], trends: &[CompareTrend], between: bool) -> Vec<Phrase> {
    let there = |family| trends.iter().any(|t| t.family == family);
    let mut said = vec![phrase!("convention-significance"), phrase!("convention-compared-with")];
    if there(CompareFamily::Robot) || there(CompareFamily::SetUp) {
        said.push(phrase!("convention-change-of-parameters"));
        said.push(phrase!("convention-set-up"));
    }
    if between {
        said.push(phrase!("convention-birge"));
    }
    if all.iter().filter_map(|c| c.identified.as_ref()).any(|i| parameters::degrees(&i.0).is_finite()) {
        said.push(phrase!("convention-f-test"));
    }
    if there(CompareFamily::MeanError) {
        said.push(phrase!("convention-mean-errors"));
    }
    if there(CompareFamily::PoseRepeatability) {
        said.push(phrase!("convention-rp-ratio"));
    }
    if there(CompareFamily::PoseAccuracy) {
        said.push(phrase!("convention-ap-interval"));
    }
    if there(CompareFamily::MeanPosition) {
        said.push(phrase!("convention-mean-positions"));
    }
    if there(CompareFamily::PathAccuracy) || there(CompareFamily::PathRepeatability) {
        said.push(phrase!("convention-at-rt"));
    }
    said.push(shared_instrument(all));
    said
}

/// Effect of a shared instrument, or of different instruments, on changes.
fn shared_instrument(all: &[Compared]) -> Phrase {
    let names: BTreeSet<Option<&str>> = all.iter().map(|c| c.campaign.instrument.name.as_deref()).collect();
    match (names.len(), names.first()) {
        (1, Some(Some(name))) => phrase!("convention-shared-instrument", instrument = one_line(name)),
        _ => phrase!("convention-different-instruments"),
    }
}
