//! The sections of a report, one a file: what each contains, and nothing of how it is drawn.

pub(super) mod accuracy;
mod budget;
pub(super) mod certificate;
pub(super) mod changes;
mod compliance;
pub(super) mod conditions;
pub(super) mod distributions;
pub(super) mod drift;
pub(super) mod errors;
pub(super) mod fit;
mod frames;
mod geometric;
pub(super) mod given;
mod import;
pub(super) mod limits;
pub(super) mod messages;
pub(super) mod parameters;
pub(super) mod plan;
pub(super) mod provenance;
mod repeatability;
mod streams;
pub(super) mod verdict;

use super::Report;
use super::model::{Block, Section};
use super::words::Words;
use crate::document::Characteristics;

/// A section from the documents; `None` where they have nothing of it.
type Make = fn(&Report, &Words) -> Option<Section>;

/// In the order of reading.
const ALL: [Make; 17] = [
    conditions::section,
    limits::section,
    messages::section,
    errors::section,
    errors::pictures,
    |report, words| of_point(accuracy::section(report.tested, words), report, words),
    |report, words| of_point(repeatability::section(report.tested, words), report, words),
    |report, words| of_point(drift::section(report.tested, words), report, words),
    |report, words| of_point(streams::section(report.tested, words), report, words),
    |report, words| compliance::section(report.tested, words),
    parameters::section,
    budget::section,
    geometric::section,
    fit::section,
    frames::section,
    import::section,
    provenance::section,
];

/// Every section that the documents have.
pub(super) fn all(report: &Report, words: &Words) -> Vec<Section> {
    ALL.iter().filter_map(|make| make(report, words)).collect()
}

/// A section of characteristics, which names the point that they are of (ISO 9283:1998, 12).
fn of_point(section: Option<Section>, report: &Report, words: &Words) -> Option<Section> {
    let stated = &report.campaign.conditions.measurement_point;
    let point = stated.clone().unwrap_or_else(|| words.say("not stated"));
    let conditions = &report.campaign.conditions;
    let mut section = section?;
    let listed = |all: &Vec<f64>, unit: &str| {
        format!("{} {unit}", all.iter().map(f64::to_string).collect::<Vec<_>>().join(", "))
    };
    let load = conditions.load_kg.map(|kg| words.fill("Load: {0} kg.", &[&kg]));
    let percent = conditions.velocities_percent.as_ref().map(|all| listed(all, "%"));
    let velocity = conditions.velocities_mm_s.as_ref().map(|all| listed(all, "mm/s")).or(percent);
    let velocity = velocity.map(|velocity| words.fill("Velocity: {0}.", &[&velocity]));
    let point = words.fill("Figures are those of the measurement point: {0}.", &[&point]);
    let sentences: Vec<String> = [Some(point), load, velocity].into_iter().flatten().collect();
    section.begin(Block::note(sentences.join(" ")));
    Some(section)
}

/// The sections of a test by ISO 9283 alone.
pub(super) fn tested(tested: &Characteristics, words: &Words) -> Vec<Section> {
    let all = [accuracy::section, repeatability::section, drift::section, streams::section, compliance::section];
    all.iter().filter_map(|make| make(tested, words)).collect()
}
