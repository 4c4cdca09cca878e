//! Sections of a report, one per file: their contents, independent of rendering.

pub(super) mod accuracy;
mod budget;
pub(super) mod cell;
pub(super) mod certificate;
pub(super) mod changes;
pub(super) mod checklist;
mod checks;
mod clauses;
mod compliance;
pub(super) mod conditions;
mod controllers;
pub(super) mod distributions;
pub(super) mod drift;
pub(super) mod effects;
pub(super) mod errors;
pub(super) mod field;
pub(super) mod fit;
mod frames;
mod geometric;
mod import;
pub(super) mod limits;
pub(super) mod messages;
mod operator_sheet;
pub(super) mod page_one;
pub(super) mod parameters;
pub(super) mod plan;
pub(super) mod provenance;
mod region;
mod relative;
mod repeatability;
pub(super) mod selftest;
mod streams;
mod test_poses;
pub(super) mod validity;
pub(super) mod verdict;
mod way_back;

use super::model::{Block, Section};
use super::words::{Words, tr};
use etalon_documents::{Characteristics, Results};

/// Creates a section from the documents; `None` if they contain nothing for it.
type Make = fn(&Results, &Words) -> Option<Section>;

/// Evidence before and after the characteristics of ISO 9283, in the order of reading.
const BEFORE: [Make; 4] = [conditions::section, limits::section, errors::section, errors::pictures];
const AFTER: [Make; 3] = [field::section, effects::section, budget::section];
/// Annexes behind the evidence.
const ANNEXES: [Make; 12] = [
    way_back::section,
    errors::other_sets,
    messages::section,
    checklist::section,
    parameters::section,
    controllers::section,
    certificate::files_section,
    checks::section,
    fit::section,
    frames::section,
    import::section,
    provenance::section,
];

/// Identifiers of characteristics that are annexes to AP, RP, drift and recorded motions.
const DETAILS: [&str; 5] = ["poses", "distances", "exchangeability", "compliance", "posing"];

/// Identifiers of characteristics of recorded motions.
const RECORDED: [&str; 4] = ["stabilisation", "streams", "posing", "weaving"];

/// Characteristics in the order of ISO 9283:1998, by their clauses.
const CHARACTERISTICS: [fn(&Characteristics, &Words) -> Option<Section>; 11] = [
    test_poses::section,       // 6
    accuracy::section,         // 7.2.1
    repeatability::section,    // 7.2.2, 7.2.3
    accuracy::distances,       // 7.3
    streams::stabilisation,    // 7.4, 7.5
    drift::section,            // 7.6
    accuracy::exchangeability, // 7.7
    streams::section,          // 8
    streams::posing,           // 9
    compliance::section,       // 10
    streams::weaving,          // 11
];

/// Sections of all documents: evidence, then annexes.
pub(super) fn all(results: &Results, words: &Words) -> Vec<Section> {
    let made = |all: &[Make]| all.iter().filter_map(|make| make(results, words)).collect::<Vec<_>>();
    let mut sections = made(&BEFORE);
    sections.splice(0..0, clauses::section(&results.tested, words));
    let of_test = characteristics(&results.tested, words);
    sections.extend(of_test.map(|section| with_measurement_point(section, results, words)));
    sections.extend(made(&AFTER));
    // the geometric method is the evidence of a campaign that identifies nothing else
    let geometric = geometric::section(results, words);
    sections.extend(geometric.map(|s| if results.identified.is_some() { s.annex() } else { s }));
    sections.extend(made(&ANNEXES).into_iter().map(Section::annex));
    sections.sort_by_key(|section| section.annex);
    sections
}

/// A section of characteristics, with the name of the measured point (ISO 9283:1998, 12).
fn with_measurement_point(mut section: Section, results: &Results, words: &Words) -> Section {
    let stated = &results.campaign.conditions.measurement_point;
    let point = stated.clone().unwrap_or_else(|| tr!(words, "not-stated"));
    let conditions = &results.campaign.conditions;
    let listed = |all: &Vec<f64>, unit: &str| {
        format!("{} {unit}", all.iter().map(f64::to_string).collect::<Vec<_>>().join(", "))
    };
    let load = conditions.motion.load_kg.map(|kg| tr!(words, "load-sentence", load = kg));
    let percent = conditions.motion.velocities_percent.as_ref();
    let percent = percent.map(|all| tr!(words, "percent-of-rated", percent = listed(all, "").trim_end()));
    let velocity = conditions.motion.velocities_mm_s.as_ref().map(|all| listed(all, "mm/s")).or(percent);
    let recorded = results.tested.streams.as_ref().filter(|_| RECORDED.contains(&section.id.as_str()));
    let velocity = recorded.and_then(|document| streams::velocities(document, words)).or(velocity);
    // a loaded robot stands
    let velocity = velocity.filter(|_| section.id != "compliance");
    let velocity = velocity.map(|velocity| tr!(words, "velocity-sentence", velocity));
    let point = tr!(words, "figures-of-measurement-point", point);
    let frame = frame(&section.id, &results.tested, words).map(|frame| tr!(words, "frame-sentence", frame));
    let sentences: Vec<String> = [Some(point), frame, load, velocity].into_iter().flatten().collect();
    section.begin(Block::note(sentences.join(" ")));
    section
}

/// Frame of the positions in a section of characteristics; `None` if it is unknown.
fn frame(section: &str, tested: &Characteristics, words: &Words) -> Option<String> {
    if RECORDED.contains(&section) {
        return Some(tr!(words, "frame-of-recording"));
    }
    let of_poses = tested.poses.as_ref().and_then(|document| document.frame.as_ref());
    match section {
        "compliance" => Some(tr!(words, "frame-of-tables")),
        _ => of_poses.map(|frame| words.worded(frame)),
    }
}

/// Sections of a test to ISO 9283 alone.
pub(super) fn tested(tested: &Characteristics, words: &Words) -> Vec<Section> {
    clauses::section(tested, words).into_iter().chain(characteristics(tested, words)).collect()
}

/// Sections of the characteristics of ISO 9283.
fn characteristics(tested: &Characteristics, words: &Words) -> impl Iterator<Item = Section> {
    let details = |s: Section| if DETAILS.contains(&s.id.as_str()) { s.annex() } else { s };
    CHARACTERISTICS.iter().filter_map(move |make| make(tested, words)).map(details)
}
