//! A quantity over campaigns, with its intervals.

use super::layer::*;
use crate::words::comparison::{self, quantity};
use etalon_documents::{CompareTrend, CompareValue};

/// Label of a campaign: its date if short enough.
pub(crate) type Label = String;

/// Maximum number of campaigns with legible labels.
const LABELLED: usize = 4;
/// Maximum number of campaign numbers along the axis.
const NUMBERED: usize = 6;

/// Figure of a trend; `None` if fewer than two campaigns have the quantity.
pub(crate) fn picture(trend: &CompareTrend, index: usize, labels: &[Label], words: &Words) -> Option<Figure> {
    let known = |v: &CompareValue| v.value.filter(|v| drawable(*v));
    let points: Vec<(usize, f64, &CompareValue)> =
        trend.values.iter().enumerate().filter_map(|(i, v)| Some((i, known(v)?, v))).collect();
    if points.len() < 2 {
        return None;
    }
    let ends = |v: &CompareValue| [v.low, v.high].into_iter().flatten().filter(|e| drawable(*e));
    let up = Axis::over(&trend.unit, range(points.iter().flat_map(|(_, value, v)| ends(v).chain([*value])))?, 0.08);
    let name = match up.display_unit().unit {
        "" => tr!(words, "ratio"),
        unit => tr!(words, "quantity-in-unit", quantity = tr!(words, "value"), unit),
    };
    let numbers = (0..labels.len()).step_by(labels.len().div_ceil(NUMBERED)).map(|i| (i as f64, (i + 1).to_string()));
    let across = Axis::rows(labels.len(), numbers.collect(), 0.5);
    let mut chart = Chart::new(words, NARROW, [across, up], [tr!(words, "campaign"), name]);
    let places: Vec<_> = points.iter().map(|(i, value, _)| chart.at(*i as f64, *value)).collect();
    chart.svg.lines("leader", &places);
    for ((i, value, v), at) in points.iter().zip(places) {
        let ends: Vec<_> = ends(v).map(|end| chart.at(*i as f64, end)).collect();
        chart.svg.interval("arrow-cal", at, ends);
        let (look, radius) = if changed(trend, *i) { (VALIDATION, 5.0) } else { (CALIBRATION, 4.0) };
        let shown = number::with_uncertainty(*value, comparison::half(v));
        let tip = tr!(words, "campaign-value", campaign = (i + 1), value = shown, unit = comparison::unit(&trend.unit));
        chart.svg.mark(look, at, radius, &tip);
    }
    if labels.len() <= LABELLED {
        let y = chart.svg.row();
        for (i, label) in labels.iter().enumerate() {
            chart.svg.text("mid", (chart.at(i as f64, 0.0).0, y), label);
        }
    }
    let description = tr!(words, "trend-description");
    let caption = format!("{} {}", tr!(words, "intervals-of-95"), sentence(trend, words));
    Some(Figure { caption, ..chart.figure(&format!("trend-{index}"), quantity(trend, words), description) })
}

/// `true` if a campaign changed significantly, from the first or the previous campaign.
fn changed(trend: &CompareTrend, campaign: usize) -> bool {
    trend.changes.iter().any(|c| c.to == campaign + 1 && c.significant == Some(true))
}

fn sentence(trend: &CompareTrend, words: &Words) -> String {
    let changed: Vec<String> =
        trend.changes.iter().filter(|c| c.significant == Some(true)).map(|c| comparison::pair(c, words)).collect();
    match changed.is_empty() {
        true if trend.changes.iter().all(|c| c.significant.is_none()) => {
            let known = trend.changes.iter().any(|c| c.low.is_some());
            if known { tr!(words, "not-judged-by-misfit") } else { tr!(words, "no-uncertainty-is-known") }
        }
        true => tr!(words, "no-significant-change-sentence"),
        false => tr!(words, "significant-changes", campaigns = changed.join(", ")),
    }
}
