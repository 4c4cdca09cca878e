//! The report, made from the documents alone: one page that needs no network, the same typeset to be signed, and its tables
//! as a workbook.
//!
//! `html`, `pdf` and `workbook` are pure functions: they read nothing but their argument and write the same bytes for the
//! same documents.

mod arrows;
mod axis;
mod by_pose;
pub(crate) mod compare;
mod correlation;
#[cfg(test)]
mod demo;
#[cfg(test)]
mod demo_iso9283;
#[cfg(test)]
mod demo_streams;
mod facts;
mod geometric;
mod histogram;
mod intervals;
mod iso9283;
mod map;
pub(crate) mod number;
mod parameters;
#[cfg(feature = "pdf")]
mod pdf;
mod pictures;
mod plan;
mod plane;
mod points;
mod residuals;
mod singular;
mod streams;
mod svg;
mod tables;
pub mod templates;
#[cfg(test)]
mod tests;
mod verdict;
pub(crate) mod words;
mod workbook;

pub use plan::html as plan_html;

use crate::document::{
    AccuracyDocument, CampaignSummary, FeaturesDocument, FramesDocument, GeometricDocument, ImportDocument,
    Iso9283Document, Iso9283StreamsDocument, ParametersDocument, PointError, Provenance, WorldFrame,
};
use crate::message::{Message, Result};
use pictures::pictures;
use serde::Serialize;
use words::Words;

/// Everything that a report tells.
pub struct Report<'a> {
    /// What the campaign says about itself.
    pub campaign: &'a CampaignSummary,
    /// What was read and refused.
    pub import: &'a ImportDocument,
    /// Fitted elements.
    pub features: &'a FeaturesDocument,
    /// Frames made from them.
    pub frames: &'a FramesDocument,
    /// Identified parameters.
    pub parameters: &'a ParametersDocument,
    /// Errors before and after.
    pub accuracy: &'a AccuracyDocument,
    /// The errors that the pictures show.
    pub errors: &'a [PointError],
    /// What geometry alone found, where the campaign asks for it.
    pub geometric: Option<&'a GeometricDocument>,
    /// Repeatability, where the campaign tests it.
    pub iso9283: Option<&'a Iso9283Document>,
    /// Recorded motions, where the campaign has any.
    pub streams: Option<&'a Iso9283StreamsDocument>,
}

/// What the report of a test of repeatability alone tells.
pub struct TestReport<'a> {
    /// What the campaign says about itself.
    pub campaign: &'a CampaignSummary,
    /// What was read and refused.
    pub import: &'a ImportDocument,
    /// Fitted elements.
    pub features: &'a FeaturesDocument,
    /// Frames made from them.
    pub frames: &'a FramesDocument,
    /// Repeatability.
    pub iso9283: &'a Iso9283Document,
    /// Recorded motions, where the campaign has any.
    pub streams: Option<&'a Iso9283StreamsDocument>,
}

/// What the template sees: documents as they are, and what was computed from them.
#[derive(Serialize)]
struct Page<'a> {
    campaign: &'a CampaignSummary,
    facts: Vec<facts::Fact>,
    import: &'a ImportDocument,
    features: &'a FeaturesDocument,
    world: &'a WorldFrame,
    fit: &'a ParametersDocument,
    messages: Vec<&'a Message>,
    verdict: verdict::Verdict,
    definition: &'a str,
    sets: Vec<tables::Set>,
    poses: tables::Poses,
    parameters: Vec<parameters::Row>,
    parameter_pictures: Vec<points::Picture>,
    pictures: Vec<points::Picture>,
    residual_pictures: Vec<points::Picture>,
    observability_pictures: Vec<points::Picture>,
    geometric: Option<geometric::Section<'a>>,
    iso9283: Option<iso9283::Section<'a>>,
    streams: Vec<streams::Section<'a>>,
    /// errors that are not finite
    undrawn: usize,
}

/// A file of a report: its name and its bytes.
pub type File = (&'static str, Vec<u8>);

/// All files of the report of a calibration.
pub fn files(report: &Report) -> Result<Vec<File>> {
    Ok(vec![
        ("report.html", html(report)?.into_bytes()),
        #[cfg(feature = "pdf")]
        ("report.pdf", pdf::pdf(report)?),
        ("report.xlsx", workbook::workbook(report)?),
    ])
}

/// All files of the report of a test of repeatability.
pub fn test_files(report: &TestReport) -> Result<Vec<File>> {
    Ok(vec![
        ("report.html", test_html(report)?.into_bytes()),
        #[cfg(feature = "pdf")]
        ("report.pdf", pdf::test_pdf(report)?),
        ("report.xlsx", workbook::test_workbook(report)?),
    ])
}

/// The report as one HTML page.
pub fn html(report: &Report) -> Result<String> {
    let presentation = &report.campaign.report;
    let words = &Words::of(presentation.language)?;
    let drawn = pictures(report, words);
    let page = Page {
        campaign: report.campaign,
        facts: facts::facts(report.campaign, report.iso9283, words),
        import: report.import,
        features: report.features,
        world: &report.frames.world,
        fit: report.parameters,
        messages: messages(report),
        verdict: verdict::verdict(report, words),
        definition: &report.accuracy.definition,
        sets: tables::sets(report.accuracy, words),
        poses: tables::poses(report.errors, words),
        parameters: parameters::rows(&report.parameters.parameters, words),
        parameter_pictures: drawn.parameters,
        pictures: drawn.errors,
        residual_pictures: drawn.residuals,
        observability_pictures: drawn.observability,
        geometric: report.geometric.map(|g| geometric::section(g, words)),
        iso9283: report.iso9283.map(|i| iso9283::section(i, words)),
        streams: report.streams.map(|s| streams::sections(s, words)).unwrap_or_default(),
        undrawn: report.errors.len() - points::drawable(report.errors).len(),
    };
    templates::render("report.html", presentation, words, page)
}

/// What the template of a test of repeatability sees.
#[derive(Serialize)]
struct TestPage<'a> {
    campaign: &'a CampaignSummary,
    facts: Vec<facts::Fact>,
    import: &'a ImportDocument,
    features: &'a FeaturesDocument,
    world: &'a WorldFrame,
    provenance: Provenance,
    messages: Vec<&'a Message>,
    class: &'static str,
    sentence: String,
    iso9283: iso9283::Section<'a>,
    streams: Vec<streams::Section<'a>>,
}

/// The report of a test of repeatability alone as one HTML page.
pub fn test_html(report: &TestReport) -> Result<String> {
    let presentation = &report.campaign.report;
    let words = &Words::of(presentation.language)?;
    let (class, sentence) = iso9283::verdict(report.iso9283, words);
    let page = TestPage {
        campaign: report.campaign,
        facts: facts::facts(report.campaign, Some(report.iso9283), words),
        import: report.import,
        features: report.features,
        world: &report.frames.world,
        provenance: Provenance {
            version: env!("CARGO_PKG_VERSION").to_owned(),
            inputs: report.import.inputs(),
            seed: None,
        },
        messages: test_messages(report),
        class,
        sentence,
        iso9283: iso9283::section(report.iso9283, words),
        streams: report.streams.map(|s| streams::sections(s, words)).unwrap_or_default(),
    };
    templates::render("repeatability.html", presentation, words, page)
}

fn messages<'a>(report: &Report<'a>) -> Vec<&'a Message> {
    let geometric = report.geometric.iter().flat_map(|g| &g.messages);
    let iso9283 = report.iso9283.iter().flat_map(|i| &i.messages);
    let streams = report.streams.iter().flat_map(|s| s.messages());
    let all = report.parameters.messages.iter().chain(&report.import.messages);
    all.chain(geometric).chain(iso9283).chain(streams).collect()
}

fn test_messages<'a>(report: &TestReport<'a>) -> Vec<&'a Message> {
    let tested = report.import.messages.iter().chain(&report.iso9283.messages);
    tested.chain(report.streams.iter().flat_map(|s| s.messages())).collect()
}
