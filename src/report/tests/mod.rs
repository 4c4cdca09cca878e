//! Requirements on all kinds of reports: required contents, unusual input, forbidden contents.

#[cfg(test)]
mod answer;
mod comparison;
pub(super) mod demo;
pub(super) mod demo_iso9283;
pub(super) mod demo_streams;
pub(super) mod page;
mod terminal;
mod workbook;

use etalon_base::catalogue::Phrase;

/// English texts of the report, and in another language.
fn report_texts(language: etalon_documents::Language) -> impl Iterator<Item = (String, String)> {
    let texts = etalon_base::catalogue::entries().into_iter().filter(|entry| entry.file == "report");
    texts.map(|entry| Phrase::new(entry.id)).map(move |phrase| (phrase.text("en"), phrase.text(language.code())))
}

/// Relative luminance of a colour, 0 to 255 for each of red, green and blue (WCAG 2.2).
pub(crate) fn luminance(rgb: &[f64; 3]) -> f64 {
    let linear = |c: f64| if c <= 10.0 { c / 255.0 / 12.92 } else { ((c / 255.0 + 0.055) / 1.055).powf(2.4) };
    0.2126 * linear(rgb[0]) + 0.7152 * linear(rgb[1]) + 0.0722 * linear(rgb[2])
}
