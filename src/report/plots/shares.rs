//! Contributions of the sources to the variance of each parameter, as bars.

use super::intervals::shortened;
use super::layer::*;
use etalon_documents::{ParameterEntry, ParametersDocument};

/// Maximum number of parameters; base and targets are first in the list, and many.
const MOST: usize = 40;
/// Smallest share whose number is shown.
const WRITTEN: f64 = 0.08;

/// One bar for each parameter, `None` with a single source.
pub(crate) fn picture(document: &ParametersDocument, words: &Words) -> Option<Figure> {
    let sources: Vec<_> = document.budget.iter().map(|s| (words.tr(&names::source(s.source)), s)).collect();
    let all: Vec<(usize, &ParameterEntry)> = document.identified().enumerate().collect();
    let all = &all[all.len().saturating_sub(MOST)..];
    if sources.len() < 2 || sources.len() > COLOURS.len() || all.is_empty() {
        return None;
    }
    let labels = all.iter().enumerate().map(|(i, (_, p))| (i as f64, shortened(&p.name))).collect();
    let axes = [Axis::linear(0.0, 100.0), Axis::rows(all.len(), labels, 0.5)];
    let mut chart = Chart::new(WIDE, axes, ["%", ""]);
    for (i, (k, p)) in all.iter().enumerate() {
        let square = |j: usize| sources[j].1.standard_uncertainties.get(*k).map_or(0.0, |u| u * u);
        let whole: f64 = (0..sources.len()).map(square).sum();
        let mut from = 0.0;
        for j in (0..sources.len()).filter(|j| square(*j) > 0.0) {
            let share = square(j) / whole;
            let (middle, right) = (from + 50.0 * share, from + 100.0 * share);
            let percent = format!("{:.0} %", 100.0 * share);
            let tip = format!("{}: {} {percent}", p.name, sources[j].0);
            chart.bar_along(Look::colour(COLOURS[j]), i, [from, right], &tip);
            if share >= WRITTEN {
                let (x, y) = chart.at(middle, i as f64);
                chart.svg.text("over mid", (x, y + 4.0), &percent);
            }
            from = right;
        }
    }
    for (j, (name, _)) in sources.iter().enumerate() {
        chart.svg.legend(Look::colour(COLOURS[j]), name);
    }
    let title = tr!(words, "budget-shares-title");
    let description = tr!(words, "budget-shares-description");
    let caption = tr!(words, "budget-shares-order");
    Some(Figure { caption, ..chart.figure("shares", title, description) })
}
