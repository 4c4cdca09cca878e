//! The report, made from the documents alone: one page that needs no network, the same typeset to be signed, and its tables
//! as a workbook.
//!
//! `html`, `pdf` and `workbook` are pure functions: they read nothing but their argument and write the same bytes for the
//! same documents.

mod arrows;
mod axis;
pub mod branding;
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
mod part;
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

use crate::base::message::{Message, Result};
use crate::document::{
    AccuracyDocument, CampaignSummary, Characteristics, FeaturesDocument, FramesDocument, GeometricDocument,
    ImportDocument, ParametersDocument, PointError, Provenance, WorldFrame,
};
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
    /// Characteristics of ISO 9283, where the campaign tests any.
    pub tested: &'a Characteristics,
}

/// What the report of a test by ISO 9283 alone tells.
pub struct TestReport<'a> {
    /// What the campaign says about itself.
    pub campaign: &'a CampaignSummary,
    /// What was read and refused.
    pub import: &'a ImportDocument,
    /// Fitted elements.
    pub features: &'a FeaturesDocument,
    /// Frames made from them.
    pub frames: &'a FramesDocument,
    /// Its characteristics.
    pub tested: &'a Characteristics,
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
    compliance: Vec<part::Part>,
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

/// All files of the report of a test by ISO 9283.
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
        facts: facts::facts(report.campaign, report.tested, words),
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
        iso9283: report.tested.poses.as_ref().map(|i| iso9283::section(i, words)),
        compliance: iso9283::compliance(report.tested.compliance.as_ref(), words),
        streams: report.tested.streams.as_ref().map(|s| streams::sections(s, words)).unwrap_or_default(),
        undrawn: report.errors.len() - points::drawable(report.errors).len(),
    };
    templates::render("report.html", presentation, words, page)
}

/// What the template of a test by ISO 9283 sees.
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
    sentences: Vec<String>,
    title: String,
    iso9283: Option<iso9283::Section<'a>>,
    compliance: Vec<part::Part>,
    streams: Vec<streams::Section<'a>>,
}

/// The report of a test by ISO 9283 alone as one HTML page.
pub fn test_html(report: &TestReport) -> Result<String> {
    let presentation = &report.campaign.report;
    let words = &Words::of(presentation.language)?;
    let iso9283::Verdict { class, sentences } = iso9283::verdict(report.tested, words);
    let page = TestPage {
        campaign: report.campaign,
        facts: facts::facts(report.campaign, report.tested, words),
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
        sentences,
        title: iso9283::title(report.tested, words),
        iso9283: report.tested.poses.as_ref().map(|i| iso9283::section(i, words)),
        compliance: iso9283::compliance(report.tested.compliance.as_ref(), words),
        streams: report.tested.streams.as_ref().map(|s| streams::sections(s, words)).unwrap_or_default(),
    };
    templates::render("repeatability.html", presentation, words, page)
}

fn messages<'a>(report: &Report<'a>) -> Vec<&'a Message> {
    let geometric = report.geometric.iter().flat_map(|g| &g.messages);
    let all = report.parameters.messages.iter().chain(&report.import.messages);
    all.chain(geometric).chain(report.tested.messages()).collect()
}

fn test_messages<'a>(report: &TestReport<'a>) -> Vec<&'a Message> {
    report.import.messages.iter().chain(report.tested.messages()).collect()
}
