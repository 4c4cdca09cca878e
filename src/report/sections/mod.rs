//! The sections of a report, one a file: what each contains, and nothing of how it is drawn.

pub(super) mod accuracy;
pub(super) mod changes;
mod compliance;
mod conditions;
pub(super) mod drift;
mod errors;
pub(super) mod fit;
mod frames;
mod geometric;
mod import;
mod limits;
pub(super) mod messages;
pub(super) mod parameters;
pub(super) mod plan;
pub(super) mod provenance;
mod repeatability;
mod streams;
pub(super) mod verdict;

use super::Report;
use super::model::Section;
use super::words::Words;
use crate::document::Characteristics;

/// A section from the documents; `None` where they have nothing of it.
type Make = fn(&Report, &Words) -> Option<Section>;

/// In the order of reading.
const ALL: [Make; 16] = [
    conditions::section,
    limits::section,
    messages::section,
    errors::section,
    errors::pictures,
    |report, words| accuracy::section(report.tested, words),
    |report, words| repeatability::section(report.tested, words),
    |report, words| drift::section(report.tested, words),
    |report, words| streams::section(report.tested, words),
    |report, words| compliance::section(report.tested, words),
    parameters::section,
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

/// The sections of a test by ISO 9283 alone.
pub(super) fn tested(tested: &Characteristics, words: &Words) -> Vec<Section> {
    let all = [accuracy::section, repeatability::section, drift::section, streams::section, compliance::section];
    all.iter().filter_map(|make| make(tested, words)).collect()
}
