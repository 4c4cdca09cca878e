//! How a robot gives way under load.

use super::um;
use crate::document::{Iso9283Compliance, Iso9283ComplianceDocument};
use crate::report::number::significant;
use crate::report::part::{Part, number, text};
use crate::report::words::Words;

/// Nothing where no load was tested.
pub(in crate::report) fn compliance(document: Option<&Iso9283ComplianceDocument>, words: &Words) -> Vec<Part> {
    let Some(document) = document else { return Vec::new() };
    let row = |d: &Iso9283Compliance| {
        let per_newton = |mm: f64| significant(1e3 * mm, 3);
        vec![
            d.direction.clone(),
            per_newton(d.compliance_mm_n),
            d.standard_uncertainty_mm_n.map_or_else(String::new, per_newton),
            d.force_n.to_string(),
            um(Some(d.largest_mm)),
            um(Some(d.off_line_mm)),
            d.readings.to_string(),
            d.cycles.to_string(),
        ]
    };
    let titles = [
        words.say("compliance, µm/N"),
        words.say("u (k = 1), µm/N"),
        words.say("force up to, N"),
        words.say("displacement up to, µm"),
        words.say("off the line, µm"),
        words.say("readings"),
        words.say("cycles"),
    ];
    let columns = [text(words.say("direction"))].into_iter().chain(titles.map(number)).collect();
    let note = words.say(
        "Displacement along the force by force, as a line through the unloaded position fits it (ISO 9283:1998, 10).",
    );
    let part = Part::table(String::new(), note, columns, document.directions.iter().map(row).collect());
    vec![Part { conventions: document.conventions.clone(), ..part.without_empty_columns() }]
}
