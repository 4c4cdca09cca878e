//! Compliance of a robot under load.

use crate::model::{Block, Columns, Section, Table, Text, number_cell};
use crate::number::significant;
use crate::words::{Words, tr};
use etalon_base::phrase;
use etalon_documents::{Characteristics, Iso9283Compliance};

pub(super) fn section(tested: &Characteristics, words: &Words) -> Option<Section> {
    let document = tested.compliance.as_ref()?;
    let per_newton = |mm: Option<f64>| number_cell(mm, |mm| significant(1e3 * mm, 3));
    let columns = Columns::<Iso9283Compliance>::new()
        .both(phrase!("direction"), "", |d| d.direction.as_str())
        .both(phrase!("compliance"), "mm/N", move |d| per_newton(Some(d.compliance_mm_n)))
        .in_unit("µm/N")
        .both("U (k = 2)", "mm/N", move |d| per_newton(d.standard_uncertainty_mm_n.map(|u| 2.0 * u)))
        .in_unit("µm/N")
        .both(phrase!("force-up-to"), "N", |d| number_cell(d.force_n, |v| v.to_string()))
        .micrometres(phrase!("displacement-up-to"), |d| d.largest_mm)
        .micrometres(phrase!("off-the-line"), |d| d.off_line_mm)
        .both(phrase!("readings"), "", |d| d.readings)
        .both(phrase!("cycles"), "", |d| d.cycles);
    let note = tr!(words, "definition-compliance");
    let table = Table::new(words, &document.directions, columns)
        .on(phrase!("sheet-iso9283-compliance"))
        .without_empty_columns();
    let mut section = Section::new("compliance", tr!(words, "static-compliance"));
    section.table("", note, table);
    section.push(Block::note(Text::conventions(&document.conventions, words)));
    section.on_terminal().whole()
}
