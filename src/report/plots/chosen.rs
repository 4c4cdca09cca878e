//! The map of candidates and chosen positions (figure 4.7).

use super::plane::{Plane, WIDTH};
use super::svg::{Shape, Svg};
use crate::model::Figure;
use crate::number;
use crate::words::Words;
use etalon_documents::{CandidatePlace, PlanDocument};

/// Places beyond this are not places of a robot, mm.
const DRAWABLE_MM: f64 = 1e7;
/// More marks than this hide each other.
const LIMIT: usize = 2000;

/// Candidates, and those chosen with the number of their pose; `None` where no candidate has a place.
pub(crate) fn map(plan: &PlanDocument, words: &Words) -> Option<Figure> {
    let whole = |p: &&CandidatePlace| p.at_mm.iter().all(|v| v.abs() < DRAWABLE_MM);
    let all: Vec<&CandidatePlace> = plan.places.iter().filter(whole).collect();
    let stride = all.len().div_ceil(LIMIT).max(1);
    let drawn: Vec<&CandidatePlace> =
        all.iter().enumerate().filter(|(i, p)| i.is_multiple_of(stride) || p.chosen).map(|(_, p)| *p).collect();
    if drawn.is_empty() {
        return None;
    }
    let plane = Plane::around((0, 1), &drawn.iter().map(|p| p.at_mm).collect::<Vec<_>>());
    let title = words.say("Candidates and chosen positions");
    let description = words.say("Hollow marks: candidates; filled marks with the number of their pose: chosen.");
    let mut svg = Svg::new("chosen", WIDTH, plane.height() + 26.0, &title, &description);
    plane.draw(&mut svg, words);
    let tip = |p: &CandidatePlace| {
        let [x, y, _] = p.at_mm.map(|v| number::fixed(v, 1));
        let values: [&dyn std::fmt::Display; 4] = [&p.pose, &p.configurations, &x, &y];
        match p.chosen {
            true => words.fill("pose {0}, {1} configurations, chosen: x {2}, y {3} mm", &values),
            false => words.fill("pose {0}, {1} configurations: x {2}, y {3} mm", &values),
        }
    };
    let radius = |p: &CandidatePlace| 1.6 + 0.7 * (p.configurations.min(6) as f64);
    for p in drawn.iter().filter(|p| !p.chosen) {
        svg.mark(Shape::Circle, "before", plane.at(p.at_mm), radius(p), "", &tip(p));
    }
    for p in drawn.iter().filter(|p| p.chosen) {
        let (x, y) = plane.at(p.at_mm);
        svg.mark(Shape::Circle, "cal", (x, y), radius(p) + 1.2, "", &tip(p));
        svg.text("mid over", (x, y - radius(p) - 5.0), &p.pose.to_string());
    }
    let mut counts: Vec<usize> = drawn.iter().map(|p| p.configurations).collect();
    counts.sort_unstable();
    counts.dedup();
    for (i, count) in counts.iter().take(4).enumerate() {
        let x = 30.0 + 84.0 * i as f64;
        let size = 1.6 + 0.7 * (*count).min(6) as f64;
        svg.mark(Shape::Circle, "before", (x, plane.height() + 12.0), size, "", "");
        svg.text(
            "start",
            (x + 10.0, plane.height() + 16.0),
            &match count {
                1 => words.say("1 mode"),
                count => words.fill("{0} modes", &[count]),
            },
        );
    }
    Some(Figure {
        title,
        svg: svg.finish(),
        caption: words.fill(
            "{0} of {1} candidates are chosen; the larger a mark, the more configurations reach it.",
            &[&plan.chosen.len(), &plan.candidates],
        ),
        ..Figure::default()
    })
}
