//! Requirements on all kinds of reports: required contents, unusual input, forbidden contents.

#[cfg(test)]
mod answer;
mod comparison;
pub(super) mod demo;
pub(super) mod demo_iso9283;
mod demo_streams;
pub(super) mod page;
mod terminal;
mod workbook;

use etalon_base::catalogue::Phrase;

/// English texts of the report, and in another language.
fn report_texts(language: etalon_documents::Language) -> impl Iterator<Item = (String, String)> {
    let texts = etalon_base::catalogue::entries().into_iter().filter(|entry| entry.file == "report");
    texts.map(|entry| Phrase::new(entry.id)).map(move |phrase| (phrase.text("en"), phrase.text(language.code())))
}
