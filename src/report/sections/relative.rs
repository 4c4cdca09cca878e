//! Relative accuracy: errors of the distances between poses.

use crate::model::{Block, Columns, Figure, Section, Table};
use crate::plots::distances;
use crate::words::{Words, tr};
use etalon_base::catalogue::Phrase;
use etalon_base::phrase;
use etalon_documents::{DistanceStatistics, RelativeAccuracy};

/// Adds table and figure of the errors of distances, folded.
pub(super) fn push(section: &mut Section, relative: &RelativeAccuracy, words: &Words) {
    let set = words.tr(&relative.set.phrase());
    let mut blocks = vec![Block::note(tr!(words, "relative-accuracy-note"))];
    if relative.all.pairs < relative.available {
        let (pairs, available) = (relative.all.pairs, relative.available);
        blocks.push(Block::note(tr!(words, "relative-accuracy-selection", pairs, available)));
    }
    blocks.push(Block::Table(table(relative, words)));
    let figures: Vec<Figure> = distances::picture(relative, words).into_iter().collect();
    blocks.extend((!figures.is_empty()).then_some(Block::Figures { figures }));
    section.push(Block::Aside { title: tr!(words, "relative-accuracy", set), blocks });
}

/// All distances, then each step.
fn table(relative: &RelativeAccuracy, words: &Words) -> Table {
    let rows = std::iter::once(&relative.all).chain(&relative.steps);
    let range = move |s: &DistanceStatistics| match std::ptr::eq(s, &relative.all) {
        true => tr!(words, "all-distances"),
        false => tr!(words, "distances-from-to", from = s.from_mm, to = s.to_mm),
    };
    let expanded = |figure: Phrase| phrase!("expanded-of", figure);
    let columns = Columns::<DistanceStatistics>::new()
        .page(phrase!("distance-in-mm"), "", range)
        .sheet(phrase!("from-distance"), "mm", |s| s.from_mm)
        .sheet(phrase!("to-distance"), "mm", |s| s.to_mm)
        .both(phrase!("pairs"), "", |s| s.pairs)
        .micrometres(phrase!("rms"), |s| s.before.rms)
        .micrometres("95 %", |s| s.before.p95)
        .micrometres(phrase!("max"), |s| s.before.max)
        .below(3, phrase!("before"))
        .micrometres(phrase!("rms"), |s| s.after.rms)
        .micrometres(expanded(phrase!("rms")), |s| s.expanded_rms_mm)
        .micrometres("95 %", |s| s.after.p95)
        .micrometres(expanded(phrase!("quantile-95")), |s| s.expanded_p95_mm)
        .micrometres(phrase!("max"), |s| s.after.max)
        .micrometres(expanded(phrase!("max")), |s| s.expanded_max_mm)
        .below(6, phrase!("after"));
    Table::new(words, rows, columns).without_empty_columns().on(phrase!("sheet-relative-accuracy")).detail()
}
