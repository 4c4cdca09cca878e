//! Index and condition number over the number of configurations (figure 4.6).

use super::axis::{Axis, range};
use super::svg::{Shape, Svg};
use crate::model::Figure;
use crate::number;
use crate::words::Words;
use etalon_documents::PlanDocument;

const WIDTH: f64 = 380.0;
const HEIGHT: f64 = 340.0;
const LEFT: f64 = 52.0;
const RIGHT: f64 = 328.0;
const TOP: f64 = 36.0;
const BOTTOM: f64 = 296.0;

/// The curve of the thesis' way; `None` where it has no two points.
pub(crate) fn curve(plan: &PlanDocument, words: &Words) -> Option<Figure> {
    let points: Vec<_> = plan.greedy.curve.iter().filter(|p| p.value.is_finite() && p.condition.is_finite()).collect();
    let (first, last) = range(points.iter().map(|p| p.configurations as f64)).filter(|_| points.len() > 1)?;
    let title = words.fill("{0} and condition number while positions are added", &[&plan.index]);
    let description = words.say("Circles: index, left axis. Diamonds: condition number, right axis.");
    let mut svg = Svg::new("curve", WIDTH, HEIGHT, &title, &description);
    let across = Axis::linear(first, last, LEFT + 8.0, RIGHT - 8.0);
    let (low, high) = range(points.iter().map(|p| p.value))?;
    let margin = 0.1 * (high - low).max(1e-9 * high.abs());
    let index = Axis::linear(low - margin, high + margin, BOTTOM, TOP);
    let condition = Axis::from_zero(range(points.iter().map(|p| p.condition))?.1, BOTTOM, TOP);
    for (value, label) in index.ticks(5) {
        svg.line("grid", (LEFT, index.at(value)), (RIGHT, index.at(value)));
        svg.text("end", (LEFT - 5.0, index.at(value) + 4.0), &label);
    }
    for (value, label) in condition.ticks(5) {
        svg.text("start", (RIGHT + 5.0, condition.at(value) + 4.0), &label);
    }
    for (value, label) in across.ticks(6) {
        svg.line("axis", (across.at(value), BOTTOM), (across.at(value), BOTTOM + 4.0));
        svg.text("mid", (across.at(value), BOTTOM + 17.0), &label);
    }
    svg.line("axis", (LEFT, BOTTOM), (RIGHT, BOTTOM));
    svg.line("axis", (LEFT, TOP), (LEFT, BOTTOM));
    svg.line("axis", (RIGHT, TOP), (RIGHT, BOTTOM));
    svg.text("mid", ((LEFT + RIGHT) / 2.0, BOTTOM + 36.0), &words.say("configurations"));
    svg.text_upwards((12.0, (TOP + BOTTOM) / 2.0), &plan.index);
    svg.text_upwards((WIDTH - 6.0, (TOP + BOTTOM) / 2.0), &words.say("condition number"));
    if let Some(knee) = plan.greedy.knee_configurations {
        let x = across.at(knee as f64);
        svg.line("knee", (x, TOP), (x, BOTTOM));
        svg.text("mid", (x, TOP - 20.0), &words.fill("knee: {0}", &[&knee]));
    }
    for (shape, class, arrow, axis, of) in [
        (Shape::Diamond, "val", "arrow-val", &condition, (|p| p.condition) as fn(&etalon_documents::CurvePoint) -> f64),
        (Shape::Circle, "cal", "arrow-cal", &index, |p| p.value),
    ] {
        let at = |p: &etalon_documents::CurvePoint| (across.at(p.configurations as f64), axis.at(of(p)));
        for pair in points.windows(2) {
            svg.line(arrow, at(pair[0]), at(pair[1]));
        }
        for p in &points {
            let (value, condition) = (number::significant(p.value, 4), number::significant(p.condition, 3));
            let values: [&dyn std::fmt::Display; 5] =
                [&p.positions, &p.configurations, &plan.index, &value, &condition];
            let tip = words.fill("{0} positions, {1} configurations: {2} {3}, condition {4}", &values);
            svg.mark(shape, class, at(p), 3.6, "", &tip);
        }
    }
    svg.mark(Shape::Circle, "cal", (LEFT + 8.0, TOP - 8.0), 4.0, "", "");
    svg.text("start", (LEFT + 18.0, TOP - 4.0), &plan.index);
    svg.mark(Shape::Diamond, "val", (LEFT + 78.0, TOP - 8.0), 4.0, "", "");
    svg.text("start", (LEFT + 88.0, TOP - 4.0), &words.say("condition number"));
    let row = |p: &&etalon_documents::CurvePoint| {
        let (value, condition) = (number::significant(p.value, 5), number::significant(p.condition, 4));
        vec![p.positions.to_string(), p.configurations.to_string(), value, condition]
    };
    Some(Figure {
        title,
        svg: svg.finish(),
        caption: words.say("One after the other, the best position with all its configurations.")
            + " "
            + &words.say("The knee is where the index lies farthest above the line from its first to its last value."),
        table_title: words.say("Numbers of the curve"),
        header: vec![words.say("positions"), words.say("configurations"), plan.index.clone(), words.say("condition")],
        rows: points.iter().map(row).collect(),
        ..Figure::default()
    })
}
