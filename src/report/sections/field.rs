//! Residual field: its gain at held-out poses, and where it holds.

use crate::model::{Block, Cell, Columns, Section, Table, Text, significant};
use crate::number;
use crate::plots::held_out;
use crate::words::{Words, tr};
use etalon_base::phrase;
use etalon_base::worded::Worded;
use etalon_documents::{FieldDependence, FieldHeldOut, FieldRange, FieldSummary, Results};

pub(super) fn section(results: &Results, words: &Words) -> Option<Section> {
    section_from_summary(results.identified.as_ref()?.accuracy.field.as_ref()?, words)
}

/// Section of a search for a field, or of a field that was given for a validation.
pub(crate) fn section_from_summary(field: &FieldSummary, words: &Words) -> Option<Section> {
    let mut section = Section::new("field", tr!(words, "residual-field"));
    if let Some(reason) = field.reason.as_ref().and_then(Worded::phrase) {
        section.push(Block::text(tr!(words, "field-refused-because", reason = words.tr(reason))));
    }
    let is_used = !field.components.is_empty();
    let figures = is_used.then(|| match field.held_out {
        Some(_) => tr!(words, "figures-without-field"),
        None => tr!(words, "figures-with-field"),
    });
    let sentences: Vec<String> = field.held_out.iter().map(|held| gain(held, words)).chain(figures).collect();
    if !sentences.is_empty() {
        section.push(Block::text(sentences.join(" ")));
    }
    if let Some(held) = &field.held_out {
        section.figures(held_out::picture(held, words));
    }
    if is_used {
        let about = field.held_out.as_ref().map(|held| Block::text(uncertainty(held, words)));
        let mut blocks: Vec<Block> = about.into_iter().chain([Block::note(tr!(words, "field-note"))]).collect();
        blocks.push(Block::Table(components(&field.components, words)));
        section.push(Block::Aside { title: tr!(words, "field-components"), blocks });
    }
    section.on_terminal().whole()
}

/// Gain at held-out poses in sentences.
fn gain(held: &FieldHeldOut, words: &Words) -> String {
    let um = |mm: f64| number::significant(1e3 * mm, 3);
    // share of the mean square error
    let share = 100.0 * (1.0 - (held.with_mm / held.without_mm).powi(2));
    tr!(
        words,
        "field-gain",
        without = um(held.without_mm),
        with = um(held.with_mm),
        share = number::fixed(share, 0),
        gain = number::fixed(held.gain_over_u, 1)
    )
}

/// Predicted uncertainty compared with the errors of held-out poses.
fn uncertainty(held: &FieldHeldOut, words: &Words) -> String {
    let coverage = number::fixed(100.0 * held.coverage, 1);
    tr!(words, "field-uncertainty", coverage, factor = number::fixed(held.factor, 2))
}

fn components(all: &[FieldDependence], words: &Words) -> Table {
    let joint = |column: &str| -> Cell { Text::name(column.rsplit_once('_').map_or(column, |(name, _)| name)).into() };
    let range = |r: &FieldRange| {
        let (name, unit) = r.joint.rsplit_once('_').unwrap_or((&r.joint, ""));
        let [low, high] = r.range.map(|v| number::significant(v, 3));
        format!("{name}: {low} – {high} {unit}")
    };
    let inputs = |c: &FieldDependence| c.inputs.iter().map(range).collect::<Vec<_>>().join(", ");
    let unit = |c: &FieldDependence| c.joint.rsplit_once('_').map_or("", |(_, unit)| unit).to_owned();
    let columns = Columns::<FieldDependence>::new()
        .both(phrase!("joints"), "", move |c| joint(&c.joint))
        .both(phrase!("field-inputs"), "", inputs)
        .both(phrase!("field-deviation"), "", |c| significant(c.prior, 2))
        .both(phrase!("unit"), "", unit);
    Table::new(words, all, columns).on(phrase!("residual-field"))
}
