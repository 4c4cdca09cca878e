//! The report as PDF: what the HTML page tells, in the order of a document that is signed, typeset by typst.
//!
//! PDF/A-3 (ISO 19005-3), tagged, fonts embedded, pictures as vectors, the documents that it is made from attached.

mod annex;
mod calibration;
mod compare;
mod fit;
mod geometric;
mod iso9283;
mod paper;
mod places;
mod printable;
mod stated;
mod streams;
mod test;
#[cfg(test)]
mod tests;
mod world;

use super::Report;
use super::templates::TYPESET;
use super::words::Words;
use crate::base::message::{Message, Result};
use crate::document::{Characteristics, CompareDocument, Presentation};
use crate::report::branding::logo_file;
use crate::run::output::to_json;
use paper::Paper;
use serde::Serialize;
use typst::foundations::Bytes;
use world::Desk;

/// Date of a PDF whose campaign states none: the first that a ZIP file can state.
const UNDATED: (i32, u8, u8) = (1980, 1, 1);

/// A document that goes with the report.
#[derive(Serialize)]
struct Attachment {
    name: &'static str,
    /// how it stands to the report (ISO 19005-3, 6.8)
    relationship: &'static str,
    description: &'static str,
    text: String,
}

/// The report of a campaign.
pub fn pdf(report: &Report) -> Result<Vec<u8>> {
    let presentation = &report.campaign.report;
    let words = &Words::of(presentation.language)?;
    let mut attachments = Vec::new();
    if let Some(i) = &report.identified {
        attachments.push(attachment(
            "parameters.json",
            "data",
            "Identified parameters, covariance, provenance",
            i.parameters,
        )?);
        attachments.push(attachment("accuracy.json", "data", "Errors before and after", i.accuracy)?);
        if let Some(document) = i.geometric {
            attachments.push(attachment("geometric.json", "data", "Geometric calibration", document)?);
        }
    }
    attachments.extend(tested(report.tested)?);
    attachments.push(attachment("campaign.json", "source", "What the campaign states", report.campaign)?);
    let paper = match &report.identified {
        Some(identified) => calibration::paper(report, identified, words),
        None => test::paper(report, words),
    };
    typeset(&paper, &attachments, presentation)
}

/// The report of a comparison of campaigns.
pub(super) fn compare_pdf(document: &CompareDocument, presentation: &Presentation) -> Result<Vec<u8>> {
    let attachments = [attachment("compare.json", "data", "What changed between campaigns", document)?];
    typeset(&compare::paper(document, presentation, &Words::of(presentation.language)?), &attachments, presentation)
}

/// Whether a laboratory's template reads, without a report to lay out.
pub(super) fn check(template: &str) -> Result<()> {
    let files = [(TYPESET.0.to_owned(), Bytes::from_string(template.to_owned()))];
    Desk::new(files.into(), UNDATED)?.check(TYPESET.0)
}

fn tested(found: &Characteristics) -> Result<Vec<Attachment>> {
    let poses = found.poses.as_ref().map(|d| attachment("iso9283.json", "data", "Characteristics of ISO 9283", d));
    let streams = found.streams.as_ref().map(|d| attachment("iso9283-streams.json", "data", "Recorded motions", d));
    let loads =
        found.compliance.as_ref().map(|d| attachment("iso9283-compliance.json", "data", "Static compliance", d));
    [poses, streams, loads].into_iter().flatten().collect()
}

fn attachment<T: Serialize>(
    name: &'static str,
    relationship: &'static str,
    description: &'static str,
    document: &T,
) -> Result<Attachment> {
    let text = String::from_utf8_lossy(&to_json(document)?).into_owned();
    Ok(Attachment { name, relationship, description, text })
}

/// Names reach the template as data, never as markup.
fn typeset(paper: &Paper, attachments: &[Attachment], dressed: &Presentation) -> Result<Vec<u8>> {
    let fail = |e: serde_json::Error| Message::error(format!("cannot typeset report.pdf: {e}"));
    let mut data = serde_json::to_value(paper).map_err(fail)?;
    printable::printable(&mut data);
    let own = dressed.templates.get(TYPESET.0).cloned();
    let mut files = vec![
        (TYPESET.0, Bytes::from_string(own.unwrap_or_else(|| TYPESET.1.to_owned()))),
        ("report.json", Bytes::new(serde_json::to_vec(&data).map_err(fail)?)),
        ("attachments.json", Bytes::new(serde_json::to_vec(attachments).map_err(fail)?)),
    ];
    if let Some((_, logo)) = dressed.logo.as_deref().and_then(logo_file) {
        files.push(("logo", Bytes::new(logo)));
    }
    let files = files.into_iter().map(|(name, bytes)| (name.to_owned(), bytes)).collect();
    let date = paper.date.as_deref().and_then(day).unwrap_or(UNDATED);
    Desk::new(files, date)?.pdf(&paper.title)
}

/// Year, month and day of a text that starts with a date of ISO 8601.
fn day(text: &str) -> Option<(i32, u8, u8)> {
    let mut parts = text.get(..10)?.split('-');
    let (year, month, day) = (parts.next()?, parts.next()?, parts.next()?);
    let date: (i32, u8, u8) = (year.parse().ok()?, month.parse().ok()?, day.parse().ok()?);
    typst::foundations::Datetime::from_ymd(date.0, date.1, date.2).filter(|_| date.0 >= 1583).map(|_| date)
}
