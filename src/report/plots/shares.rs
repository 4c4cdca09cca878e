//! Shares of the sources in the variance of each parameter, as bars.

use super::intervals::{LETTERS, shortened};
use super::svg::{COLOURS, Svg};
use crate::model::Figure;
use crate::words::Words;
use etalon_documents::{ParameterEntry, ParametersDocument, UncertaintySource};

const WIDTH: f64 = 780.0;
const TOP: f64 = 14.0;
const ROW: f64 = 18.0;
/// Parameters that are drawn: base and targets are first in the list, and many.
const MOST: usize = 40;
/// A share in which its number is written.
const WRITTEN: f64 = 0.08;

/// One bar for each parameter, its sources by their names; none where there is one source alone.
pub(crate) fn picture(
    document: &ParametersDocument,
    name_of: fn(UncertaintySource) -> &'static str,
    words: &Words,
) -> Option<Figure> {
    let sources = &document.budget;
    let all: Vec<(usize, &ParameterEntry)> = document.identified().enumerate().collect();
    let all = &all[all.len().saturating_sub(MOST)..];
    if sources.len() < 2 || sources.len() > COLOURS.len() || all.is_empty() {
        return None;
    }
    let title = words.say("Shares of the sources in the variance");
    let description = words.say("One bar for each parameter, of the squares of the contributions in percent.");
    let left = 16.0 + 7.2 * LETTERS as f64;
    let legend = TOP + ROW * all.len() as f64 + 24.0;
    let mut svg = Svg::new("shares", WIDTH, legend + 14.0, &title, &description);
    let along = |share: f64| left + (WIDTH - left - 8.0) * share;
    for (i, (k, p)) in all.iter().enumerate() {
        let y = TOP + ROW * i as f64;
        svg.text("end", (left - 8.0, y + 12.0), &shortened(&p.name));
        let squares: Vec<f64> =
            sources.iter().map(|s| s.standard_uncertainties.get(*k).map_or(0.0, |u| u * u)).collect();
        let whole: f64 = squares.iter().sum();
        let mut from = 0.0;
        for (j, square) in squares.iter().enumerate().filter(|(_, square)| **square > 0.0) {
            let share = square / whole;
            let percent = format!("{:.0} %", 100.0 * share);
            let source = words.say(name_of(sources[j].source));
            let size = (along(from + share) - along(from), ROW - 4.0);
            svg.bar((along(from), y), size, COLOURS[j], &format!("{}: {source} {percent}", p.name));
            if share >= WRITTEN {
                svg.text("over mid", (along(from + 0.5 * share), y + 11.5), &percent);
            }
            from += share;
        }
    }
    let mut x = left;
    for (j, source) in sources.iter().enumerate() {
        let name = words.say(name_of(source.source));
        svg.bar((x, legend - 10.0), (12.0, 12.0), COLOURS[j], "");
        svg.text("", (x + 17.0, legend), &name);
        x += 30.0 + 7.2 * name.chars().count() as f64;
    }
    Some(Figure {
        title,
        svg: svg.finish(),
        caption: words.say("In the order of the columns of the table above, from left to right."),
        wide: true,
        ..Figure::default()
    })
}
