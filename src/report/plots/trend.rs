//! One quantity over the campaigns, with its intervals.

use super::axis::{Axis, left_margin, range};
use super::svg::{Shape, Svg};
use crate::model::Figure;
use crate::number;
use crate::words::Words;
use crate::words::comparison::{self, quantity};
use etalon_documents::{CompareTrend, CompareValue};

const WIDTH: f64 = 380.0;
const HEIGHT: f64 = 258.0;
const RIGHT: f64 = 368.0;
const TOP: f64 = 20.0;
const BOTTOM: f64 = 206.0;
/// Values beyond this are blunders that no picture can show.
const DRAWABLE: f64 = 1e12;

/// The label of a campaign: its number, and its date where it is short enough.
pub(crate) type Label = String;

/// `None` where fewer than two campaigns have it.
pub(crate) fn picture(trend: &CompareTrend, index: usize, labels: &[Label], words: &Words) -> Option<Figure> {
    let known = |v: &CompareValue| v.value.filter(|v| v.abs() < DRAWABLE);
    let points: Vec<(usize, f64, &CompareValue)> =
        trend.values.iter().enumerate().filter_map(|(i, v)| Some((i, known(v)?, v))).collect();
    if points.len() < 2 {
        return None;
    }
    let ends = |v: &CompareValue| [v.low, v.high].into_iter().flatten().filter(|e| e.abs() < DRAWABLE);
    let (low, high) = range(points.iter().flat_map(|(_, value, v)| ends(v).chain([*value])))?;
    let shown = number::shown(&trend.unit, low.abs().max(high.abs()));
    let margin = 0.08 * (high - low).max(1e-9 * high.abs().max(low.abs()));
    let axis = Axis::linear((low - margin) * shown.factor, (high + margin) * shown.factor, BOTTOM, TOP);
    let ticks = axis.ticks(5);
    let left = left_margin(&ticks);
    let across = Axis::linear(-0.5, labels.len() as f64 - 0.5, left, RIGHT);
    let title = quantity(trend, words);
    let description =
        words.say("One mark for each campaign with its interval of 95 %; diamonds changed significantly.");
    let mut svg = Svg::new(&format!("trend-{index}"), WIDTH, HEIGHT, &title, &description);
    for (value, label) in &ticks {
        svg.line("grid", (left, axis.at(*value)), (RIGHT, axis.at(*value)));
        svg.text("end", (left - 5.0, axis.at(*value) + 4.0), label);
    }
    // more labels than have room run into each other
    let every = labels.len().div_ceil(6);
    for (i, label) in labels.iter().enumerate().step_by(every) {
        let x = across.at(i as f64);
        svg.line("axis", (x, BOTTOM), (x, BOTTOM + 4.0));
        svg.text("mid", (x, BOTTOM + 17.0), &(i + 1).to_string());
        if every == 1 && labels.len() < 5 {
            svg.text("mid", (x, BOTTOM + 33.0), label);
        }
    }
    svg.line("axis", (left, BOTTOM), (RIGHT, BOTTOM));
    svg.line("axis", (left, TOP), (left, BOTTOM));
    svg.text("mid", ((left + RIGHT) / 2.0, BOTTOM + 47.0), &words.say("campaign"));
    let up = if shown.unit.is_empty() {
        words.say("ratio")
    } else {
        words.fill("{0} in {1}", &[&words.say("value"), &shown.unit])
    };
    svg.text_upwards((12.0, (TOP + BOTTOM) / 2.0), &up);
    let at = |i: usize, value: f64| (across.at(i as f64), axis.at(value * shown.factor));
    for pair in points.windows(2) {
        svg.line("grid", at(pair[0].0, pair[0].1), at(pair[1].0, pair[1].1));
    }
    for (i, value, v) in &points {
        for end in ends(v) {
            let (x, y) = at(*i, end);
            svg.line("arrow-cal", at(*i, *value), (x, y));
            svg.line("arrow-cal", (x - 4.0, y), (x + 4.0, y));
        }
        let shown = number::with_uncertainty(*value, comparison::half(v));
        let tip = words.fill("campaign {0}: {1} {2}", &[&(i + 1), &shown, &comparison::unit(&trend.unit)]);
        match changed(trend, *i) {
            true => svg.mark(Shape::Diamond, "val", at(*i, *value), 5.0, "", &tip),
            false => svg.mark(Shape::Circle, "cal", at(*i, *value), 4.0, "", &tip),
        }
    }
    Some(Figure {
        title,
        svg: svg.finish(),
        caption: format!("{} {}", words.say("Intervals of 95 %."), sentence(trend, words)),
        ..Figure::default()
    })
}

/// Whether a campaign changed significantly, from the first or from the one before.
fn changed(trend: &CompareTrend, campaign: usize) -> bool {
    trend.changes.iter().any(|c| c.to == campaign + 1 && c.significant == Some(true))
}

fn sentence(trend: &CompareTrend, words: &Words) -> String {
    let changed: Vec<String> =
        trend.changes.iter().filter(|c| c.significant == Some(true)).map(|c| comparison::pair(c, words)).collect();
    match changed.is_empty() {
        true if trend.changes.iter().all(|c| c.significant.is_none()) => words.say("no uncertainty is known"),
        true => words.say("No significant change."),
        false => words.fill("Significant: {0}.", &[&changed.join(", ")]),
    }
}
