//! Report as a PDF with the contents of the HTML page, in the order of a document to be signed,
//! typeset by typst.
//!
//! PDF/A-3 (ISO 19005-3), tagged, with embedded fonts, vector figures, and the source documents as
//! attachments.

mod printable;
#[cfg(test)]
mod tests;
mod world;

use super::branding::logo_file;
use super::model::Contents;
use super::words::{Words, tr};
use super::{Attachment, TYPESET};
use etalon_base::date::{Date, date};
use etalon_base::error;
use etalon_base::message::{Problems, Result};
use etalon_base::template::{check_brackets, supervised};
use etalon_documents::Presentation;
use printable::{Letters, printable, printable_picture};
use serde_json::{Value, json};
use typst::foundations::Bytes;
use world::Desk;

/// Date in the metadata of a PDF if neither the campaign nor `SOURCE_DATE_EPOCH` gives one: PDF/A
/// requires a date, and each page says that none is given. The earliest date of a ZIP file.
const UNDATED: Date = Date { year: 1980, month: 1, day: 1 };
/// Maximum number of warnings before the results; further warnings are in an annex.
const NOTICES: usize = 6;

/// Checks the syntax of a laboratory's template without a report.
pub(super) fn check(template: &str) -> Result<()> {
    let files = [(TYPESET.0.to_owned(), Bytes::from_string(template.to_owned()))];
    Desk::new(files.into(), UNDATED)?.check(TYPESET.0)
}

/// Typesets the report. Names reach the template as data, never as markup. A name that cannot be
/// typeset is replaced by its plain letters.
pub(super) fn pdf(
    contents: &Contents,
    attachments: &[Attachment],
    presentation: &Presentation,
    words: &Words,
) -> Result<Vec<u8>> {
    let fail = |e: serde_json::Error| error!("typesetting-failed", reason = e.to_string());
    let data = paper(contents, presentation, words).map_err(fail)?;
    let own = presentation.templates.get(TYPESET.0).cloned();
    own.iter().try_for_each(|text| check_brackets(TYPESET.0, text))?;
    let is_own = own.is_some();
    let template = Bytes::from_string(own.unwrap_or_else(|| TYPESET.1.to_owned()));
    let attached = Bytes::new(serde_json::to_vec(attachments).map_err(fail)?);
    let stated = [&contents.dates.issued, &contents.dates.date];
    let stated = stated.into_iter().flatten().find_map(|date| day(date));
    let date = stated.or(contents.dates.built).unwrap_or(UNDATED);
    let typeset = |letters| {
        let mut data = data.clone();
        printable(&mut data, letters);
        let report = Bytes::new(serde_json::to_vec(&data).map_err(fail)?);
        let mut files =
            vec![(TYPESET.0, template.clone()), ("report.json", report), ("attachments.json", attached.clone())];
        if let Some((ending, logo)) = presentation.logo.as_deref().and_then(logo_file) {
            files.push(("logo", Bytes::new(if ending == "svg" { printable_picture(logo, letters) } else { logo })));
        }
        let files = files.into_iter().map(|(name, bytes)| (name.to_owned(), bytes)).collect();
        let title = contents.title.clone();
        let made = move || Desk::new(files, date)?.pdf(&title);
        if is_own { supervised(TYPESET.0, made) } else { made() }
    };
    typeset(Letters::Known).or_else(|problems| match is_own {
        true => Err(problems),
        false => typeset(Letters::Single).map_err(|_: Problems| problems),
    })
}

/// Contents for typesetting: optional reading is in annexes after the signatures.
fn paper(contents: &Contents, presentation: &Presentation, words: &Words) -> serde_json::Result<Value> {
    let mut data = serde_json::to_value(contents)?;
    let mut annexes = Vec::new();
    for section in data["sections"].as_array_mut().into_iter().flatten() {
        let Value::Array(blocks) = section["blocks"].take() else { continue };
        let (mut kept, mut notices) = (Vec::new(), Vec::new());
        for block in blocks {
            match block["kind"].as_str() {
                Some("aside") => annexes.push(block),
                Some("notice") if kept.len() >= NOTICES => notices.push(block),
                _ => kept.push(block),
            }
        }
        if !notices.is_empty() {
            let more = [json!({ "text": tr!(words, "more-in-annex", count = notices.len()), "mark": "own" })];
            kept.push(json!({ "kind": "text", "tone": "plain", "text": more }));
            annexes.push(json!({ "title": tr!(words, "more-warnings-and-remarks"), "blocks": notices }));
        }
        section["blocks"] = kept.into();
    }
    if let Some(sections) = data["sections"].as_array_mut() {
        let (mut behind, before): (Vec<Value>, Vec<Value>) =
            sections.drain(..).partition(|section| section["annex"] == true);
        *sections = before;
        behind.append(&mut annexes);
        annexes = behind;
    }
    data["annexes"] = annexes.into();
    data["labels"] = labels(presentation, words);
    Ok(data)
}

/// Texts of the layout itself, and language.
fn labels(presentation: &Presentation, words: &Words) -> Value {
    let note = tr!(words, "texts-of-campaign-note");
    let lang = presentation.language.code();
    json!({
        "lang": lang,
        "synthetic": tr!(words, "synthetic-data-label"),
        "page": tr!(words, "page-of", page = "{0}", total = "{1}"),
        "left_out": tr!(words, "rows-in-workbook", count = "{0}"),
        "logo": presentation.logo.as_ref().map(|_| tr!(words, "logo-of-the-laboratory")),
        "end": tr!(words, "end-of-report"),
        "undated": tr!(words, "date-not-stated"),
        "signatures": tr!(words, "signatures"),
        "steps": tr!(words, "next-steps"),
        "signs": [tr!(words, "tested-by"), tr!(words, "approved-by")],
        "line": tr!(words, "name-date-signature"),
        "note": if lang == "en" { String::new() } else { note },
    })
}

/// Date at the start of a text in ISO 8601, which starts in 1583.
fn day(text: &str) -> Option<Date> {
    date(text).filter(|date| date.year >= 1583)
}
