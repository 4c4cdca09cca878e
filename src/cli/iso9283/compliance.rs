//! `etalon iso9283 --compliance`

use super::super::table_file::TableFile;
use super::super::{Verdict, print, say};
use crate::document::Iso9283ComplianceDocument;
use crate::run::output;
use crate::stages::iso9283::load::evaluate;
use std::fmt::Write;
use std::path::Path;

pub(super) fn run(path: &Path, json: bool) -> anyhow::Result<Verdict> {
    let table = TableFile::read(path)?;
    let document = evaluate(table.named()).map_err(|p| table.place(p))?;
    for message in &document.messages {
        say(format_args!("{message}\n"));
    }
    print(if json { output::to_json(&document)? } else { as_text(&document).into_bytes() })?;
    Ok(Verdict::Met)
}

/// A line for each direction.
pub(in super::super) fn as_text(document: &Iso9283ComplianceDocument) -> String {
    let mut text = String::new();
    for d in &document.directions {
        let u = d.standard_uncertainty_mm_n.map(|u| format!(" (u = {u:.1e})")).unwrap_or_default();
        let _ = writeln!(
            text,
            "{}: {:.6} mm/N{u} up to {} N, off the line {:.4} mm, {} readings in {} cycles",
            d.direction, d.compliance_mm_n, d.force_n, d.off_line_mm, d.readings, d.cycles
        );
    }
    text
}
