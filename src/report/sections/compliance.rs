//! Compliance of a robot under load.

use crate::model::{Block, Columns, Section, Table, Text, shown};
use crate::number::significant;
use crate::words::Words;
use etalon_documents::{Characteristics, Iso9283Compliance};

pub(super) fn section(tested: &Characteristics, words: &Words) -> Option<Section> {
    let document = tested.compliance.as_ref()?;
    let per_newton = |mm: Option<f64>| shown(mm, |mm| significant(1e3 * mm, 3));
    let columns = Columns::<Iso9283Compliance>::new()
        .both("direction", "", |d| d.direction.as_str())
        .both("compliance", "mm/N", move |d| per_newton(Some(d.compliance_mm_n)))
        .shown_in("µm/N")
        .both("u (k = 1)", "mm/N", move |d| per_newton(d.standard_uncertainty_mm_n))
        .shown_in("µm/N")
        .both("force up to", "N", |d| shown(d.force_n, |v| v.to_string()))
        .micrometres("displacement up to", |d| d.largest_mm)
        .micrometres("off the line", |d| d.off_line_mm)
        .both("readings", "", |d| d.readings)
        .both("cycles", "", |d| d.cycles);
    let note = words.say(
        "Displacement along the force by force, as a line through the unloaded position fits it (ISO 9283:1998, 10).",
    );
    let table = Table::of(words, &document.directions, columns).on("ISO 9283 compliance").without_empty_columns();
    let mut section = Section::new("compliance", words.say("Static compliance"));
    section.table("", note, table);
    section.push(Block::note(Text::conventions(&document.conventions, words)));
    section.on_terminal().whole()
}
