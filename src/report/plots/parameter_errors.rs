//! Errors of identified parameters after a simulated calibration (thesis, fig. 4.8).

use super::layer::*;
use crate::number::DisplayUnit;
use etalon_documents::{StudiedParameter, StudyDocument};

/// Maximum number of legible names.
const NAMED: usize = 16;

/// One figure for each unit.
pub(crate) fn pictures(study: &StudyDocument, words: &Words) -> Vec<Figure> {
    ["mm", "deg", "1"].into_iter().filter_map(|unit| picture(study, unit, words)).collect()
}

fn picture(study: &StudyDocument, unit: &str, words: &Words) -> Option<Figure> {
    let off = |p: &StudiedParameter| p.identified - p.actual;
    let all: Vec<_> = study.parameters.iter().filter(|p| p.unit == unit && off(p).is_finite()).collect();
    let largest = range(all.iter().map(|p| off(p).abs()))?[1];
    // errors of angles are about 1e-4 deg: 10⁻³ deg leaves room for the labels
    let shown = match unit {
        "deg" if largest < 0.05 => DisplayUnit { unit: "10⁻³ deg", factor: 1000.0 },
        _ => number::display_unit(unit, largest),
    };
    let named = if all.len() > NAMED { &[][..] } else { &all[..] };
    let labels = named.iter().enumerate().map(|(i, p)| (i as f64, p.name.clone())).collect();
    let (across, up) = (Axis::rows(all.len(), labels, 0.5), Axis::both_ways(shown, largest));
    let mut chart =
        Chart::new(words, NARROW, [across, up], ["", &tr!(words, "identified-minus-true-in", unit = shown.unit)]);
    let wide = (0.6 * (chart.frame.right - chart.frame.left) / all.len() as f64).min(28.0);
    for (i, p) in all.iter().enumerate() {
        let tip = format!("{}: {} {}", p.name, words.significant(off(p) * shown.factor, 3), shown.unit);
        let x = chart.at(i as f64, 0.0).0;
        chart.bar_up(CALIBRATION, (x - 0.5 * wide, wide), off(p), &tip);
    }
    chart.level("axis", 0.0);
    let title = tr!(words, "parameter-errors-title", unit = shown.unit);
    let description = tr!(words, "parameter-errors-description");
    let caption = tr!(words, "mean-of-identifications", runs = study.runs);
    Some(Figure { caption, ..chart.figure(&format!("off-{unit}"), title, description) })
}
