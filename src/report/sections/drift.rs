//! Changes in the course of a test: characteristics by set of cycles, and targets that should be
//! stationary.

use crate::model::{Block, Cell, Columns, Figure, Section, Table, Text, um};
use crate::number::{self, DisplayUnit};
use crate::plots::curves::{Curve, Curves};
use crate::words::{Words, tr};
use etalon_base::phrase;
use etalon_documents::{Characteristics, Iso9283Document, Iso9283Drift, Iso9283Epoch};

pub(super) fn section(tested: &Characteristics, words: &Words) -> Option<Section> {
    let document = tested.poses.as_ref()?;
    let mut section = Section::new("drift", tr!(words, "drift"));
    let note = tr!(words, "definition-drift");
    section.table(tr!(words, "drift-title"), note, drifts(&document.drifts, words));
    section.table("", "", sets(document, words));
    let (title, caption) = (tr!(words, "ap-by-set"), tr!(words, "accuracy-over-cycles"));
    let accuracy = by_set("AP", &document.drifts, |d| &d.ap_mm, words);
    let accuracy = Curves { title, caption, ..accuracy }.picture(words);
    let (title, caption) = (tr!(words, "rp-by-set"), tr!(words, "repeatability-over-cycles"));
    let repeatability = by_set("RP", &document.drifts, |d| &d.rp_mm, words);
    let repeatability = Curves { title, caption, ..repeatability }.picture(words);
    section.figures(accuracy);
    let figures = repeatability.into_iter().collect();
    section.push(Block::Aside { title: tr!(words, "rp-by-set"), blocks: vec![Block::Figures { figures }] });
    if !document.recorded.reference.is_empty() {
        section.blocks.extend(corrected(&document.recorded.reference, words).map(Block::text));
        let note = tr!(words, "definition-target-displacement");
        let mut blocks = vec![Block::note(note), Block::Table(reference(&document.recorded.reference, words))];
        let figures: Vec<Figure> = moved(&document.recorded.reference, words).into_iter().collect();
        blocks.push(Block::Figures { figures });
        section.push(Block::Aside { title: tr!(words, "movement-of-the-set-up"), blocks });
    }
    section.on_terminal().whole()
}

/// Sentence on the corrected movement of the set-up: its size, its steps and what remains.
fn corrected(epochs: &[Iso9283Epoch], words: &Words) -> Option<String> {
    let largest = |value: fn(&Iso9283Epoch) -> f64| epochs.iter().map(value).fold(0.0, f64::max);
    let length = |mm: f64| {
        let DisplayUnit { unit, factor } = number::display_unit("mm", mm);
        format!("{} {unit}", number::significant(mm * factor, 3))
    };
    let steps = epochs.len().checked_sub(1).filter(|steps| *steps > 0)?;
    let (moved, left) = (length(largest(|e| e.moved_mm)), length(largest(|e| e.rms_mm)));
    Some(tr!(words, "set-up-corrected", moved, steps, left))
}

fn drifts(drifts: &[Iso9283Drift], words: &Words) -> Table {
    let columns = Columns::<Iso9283Drift>::new()
        .page(phrase!("pose"), "", |d| d.pose)
        .page(phrase!("sets"), "", |d| d.ap_mm.len())
        .page(phrase!("first-set", symbol = "AP"), "µm", |d| um(d.ap_mm.first().copied()))
        .page(phrase!("last-set", symbol = "AP"), "µm", |d| um(d.ap_mm.last().copied()))
        .page("dAP", "µm", |d| um(d.dap_mm))
        .page("U (95 %)", "µm", |d| um(d.dap_expanded_uncertainty_mm))
        .page(phrase!("first-set", symbol = "RP"), "µm", |d| um(d.rp_mm.first().copied()))
        .page(phrase!("last-set", symbol = "RP"), "µm", |d| um(d.rp_mm.last().copied()))
        .page("dRP", "µm", |d| um(d.drp_mm))
        .page(phrase!("settled-after-set"), "", |d| {
            d.settled_after.map_or_else(|| Cell::from(Text::from("–")), Into::into)
        });
    Table::new(words, drifts, columns)
}

/// Cycles of a set at a pose.
struct Set<'a> {
    of: &'a Iso9283Drift,
    i: usize,
}

fn sets<'a>(document: &'a Iso9283Document, words: &Words) -> Table {
    let sets = |of: &'a Iso9283Drift| (0..of.ap_mm.len().max(of.rp_mm.len())).map(move |i| Set { of, i });
    let rows: Vec<Set> = document.drifts.iter().flat_map(sets).collect();
    let columns = Columns::<Set>::new()
        .sheet(phrase!("pose"), "", |s| s.of.pose)
        .sheet(phrase!("set"), "", |s| s.i + 1)
        .sheet("AP", "mm", |s| s.of.ap_mm.get(s.i).copied())
        .sheet("RP", "mm", |s| s.of.rp_mm.get(s.i).copied())
        .sheet("dAP", "mm", |s| s.of.dap_mm)
        .sheet("U (95 %)", "mm", |s| s.of.dap_expanded_uncertainty_mm)
        .sheet("dRP", "mm", |s| s.of.drp_mm)
        .sheet(phrase!("settled-after-set"), "", |s| s.of.settled_after);
    Table::new(words, &rows, columns).on(phrase!("sheet-iso9283-drift"))
}

/// Curves of a characteristic by set of cycles for each pose, without title and caption.
fn by_set(quantity: &str, drifts: &[Iso9283Drift], values: fn(&Iso9283Drift) -> &[f64], words: &Words) -> Curves {
    let curve = |d: &Iso9283Drift| Curve {
        name: tr!(words, "pose-named", pose = d.pose),
        points: values(d).iter().enumerate().map(|(i, v)| (i as f64 + 1.0, 1e3 * v)).collect(),
    };
    let (across, up) = (tr!(words, "set-of-cycles"), tr!(words, "quantity-in-unit", quantity, unit = "µm"));
    let curves = drifts.iter().map(curve).collect();
    let id = format!("drift-{}", quantity.to_lowercase());
    Curves { id, title: String::new(), caption: String::new(), across, up, curves, marks: vec![] }
}

fn reference(epochs: &[Iso9283Epoch], words: &Words) -> Table {
    let columns = Columns::<Iso9283Epoch>::new()
        .both(phrase!("from-cycle-on"), "", |e| e.cycle)
        .micrometres(phrase!("moved"), |e| e.moved_mm)
        .micrometres(phrase!("left-rms"), |e| e.rms_mm);
    Table::new(words, epochs, columns).on(phrase!("sheet-iso9283-reference-targets"))
}

fn moved(epochs: &[Iso9283Epoch], words: &Words) -> Option<Figure> {
    let curve = |name: String, value: fn(&Iso9283Epoch) -> f64| Curve {
        name,
        points: epochs.iter().map(|e| (e.cycle as f64, 1e3 * value(e))).collect(),
    };
    Curves {
        id: "reference".to_owned(),
        title: tr!(words, "reference-targets"),
        caption: tr!(words, "target-movement-caption"),
        across: tr!(words, "cycle"),
        up: tr!(words, "quantity-in-unit", quantity = tr!(words, "movement"), unit = "µm"),
        curves: vec![curve(tr!(words, "moved"), |e| e.moved_mm), curve(tr!(words, "left"), |e| e.rms_mm)],
        marks: vec![],
    }
    .picture(words)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::demo_iso9283::whole;

    /// The demo moves by 12 µm before cycle 11 and by 19 µm before cycle 21; a tenth remains.
    #[test]
    fn the_corrected_movement_of_the_set_up_has_size_steps_and_remainder() {
        let (tested, words) = (whole(), Words::default());
        let text = serde_json::to_string(&section(&tested, &words).unwrap()).unwrap();
        let expected = tr!(words, "set-up-corrected", moved = "19.0 µm", steps = 2, left = "1.90 µm");
        assert!(text.contains(&expected), "{text}");
        // a single measurement corrects nothing
        assert_eq!(corrected(&tested.poses.unwrap().recorded.reference[..1], &words), None);
    }
}
