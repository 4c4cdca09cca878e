//! Map of candidates and chosen positions (thesis, fig. 4.7).

use super::layer::*;
use etalon_documents::{CandidatePlace, PlanDocument};
use std::collections::BTreeSet;

/// Maximum plausible coordinate (mm).
const DRAWABLE_MM: f64 = 1e7;
/// Maximum number of legible marks.
const LIMIT: usize = 2000;
const CANDIDATE: Look<'static> = Look { class: "before", ..CALIBRATION };

/// Candidates, and chosen positions with the number of their pose; `None` if no candidate has a
/// position.
pub(crate) fn map(plan: &PlanDocument, words: &Words) -> Option<Figure> {
    let whole = |p: &&CandidatePlace| p.at_mm.iter().all(|v| v.abs() < DRAWABLE_MM);
    let all: Vec<&CandidatePlace> = plan.places.iter().filter(whole).collect();
    let stride = all.len().div_ceil(LIMIT).max(1);
    let drawn: Vec<&CandidatePlace> =
        all.iter().enumerate().filter(|(i, p)| i.is_multiple_of(stride) || p.chosen).map(|(_, p)| *p).collect();
    if drawn.is_empty() {
        return None;
    }
    let mut map = Workspace::new(XY, &drawn.iter().map(|p| p.at_mm).collect::<Vec<_>>(), words);
    let tip = |p: &CandidatePlace| {
        let [x, y, _] = p.at_mm.map(|v| number::fixed(v, 1));
        match p.chosen {
            true => tr!(words, "chosen-candidate-tooltip", pose = p.pose, configurations = p.configurations, x, y),
            false => tr!(words, "candidate-tooltip", pose = p.pose, configurations = p.configurations, x, y),
        }
    };
    let radius = |configurations: usize| 1.6 + 0.7 * (configurations.min(6) as f64);
    let (chosen, others): (Vec<&CandidatePlace>, Vec<_>) = drawn.iter().partition(|p| p.chosen);
    for p in others {
        map.svg.mark(CANDIDATE, map.at(p.at_mm), radius(p.configurations), &tip(p));
    }
    for p in chosen {
        let (spot, radius) = (map.at(p.at_mm), radius(p.configurations));
        map.svg.mark(CALIBRATION, spot, radius + 1.2, &tip(p));
        map.svg.text("mid over", spot.beside(0.0, -radius - 5.0), &p.pose.to_string());
    }
    let counts: BTreeSet<usize> = drawn.iter().map(|p| p.configurations).collect();
    for count in counts.into_iter().take(4) {
        let name = tr!(words, "mode-count", count);
        map.svg.legend_mark(CANDIDATE, radius(count), &name);
    }
    let title = tr!(words, "candidates-and-chosen-positions");
    let description = tr!(words, "chosen-candidates-marks");
    let caption =
        tr!(words, "candidates-chosen", chosen = plan.choice.chosen.len(), candidates = plan.choice.candidates);
    Some(Figure { caption, ..map.figure("chosen", title, description) })
}
