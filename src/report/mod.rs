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
    ImportDocument, LimitVerdict, ParametersDocument, PointError, Provenance, WorldFrame,
};
use pictures::pictures;
use serde::Serialize;
use words::Words;

/// The documents that a report is made from.
pub struct Report<'a> {
    /// What the campaign says about itself.
    pub campaign: &'a CampaignSummary,
    /// What was read and refused.
    pub import: &'a ImportDocument,
    /// Fitted elements.
    pub features: &'a FeaturesDocument,
    /// Frames made from them.
    pub frames: &'a FramesDocument,
    /// What was identified; absent where a campaign only tests by ISO 9283.
    pub identified: Option<Identified<'a>>,
    /// Characteristics of ISO 9283, where the campaign tests any.
    pub tested: &'a Characteristics,
}

/// The documents of an identification.
#[derive(Clone, Copy)]
pub struct Identified<'a> {
    /// Identified parameters.
    pub parameters: &'a ParametersDocument,
    /// Errors before and after.
    pub accuracy: &'a AccuracyDocument,
    /// The errors that the pictures show.
    pub errors: &'a [PointError],
    /// What geometry alone found, where the campaign asks for it.
    pub geometric: Option<&'a GeometricDocument>,
}

impl<'a> Report<'a> {
    /// Every warning and error of its documents.
    fn messages(&self) -> Vec<&'a Message> {
        let identified = self.identified.iter().flat_map(|i| &i.parameters.messages);
        let geometric = self.identified.iter().filter_map(|i| i.geometric).flat_map(|g| &g.messages);
        identified.chain(&self.import.messages).chain(geometric).chain(self.tested.messages()).collect()
    }

    /// Every limit that the campaign states, judged.
    fn limits(&self) -> Vec<&'a LimitVerdict> {
        self.identified.iter().flat_map(|i| &i.accuracy.limits).chain(self.tested.limits()).collect()
    }

    /// Whether every limit is met, and the result can be that of a robot.
    pub fn is_met(&self) -> bool {
        let plausible = self.identified.is_none_or(|i| i.parameters.is_plausible());
        plausible && self.limits().iter().all(|l| l.met)
    }
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

/// All files of a report.
pub fn files(report: &Report) -> Result<Vec<File>> {
    Ok(vec![
        ("report.html", html(report)?.into_bytes()),
        #[cfg(feature = "pdf")]
        ("report.pdf", pdf::pdf(report)?),
        ("report.xlsx", workbook::workbook(report)?),
    ])
}

/// The report as one HTML page.
pub fn html(report: &Report) -> Result<String> {
    let presentation = &report.campaign.report;
    let words = &Words::of(presentation.language)?;
    let Some(identified) = &report.identified else { return test_html(report, words) };
    let drawn = pictures(report, identified, words);
    let page = Page {
        campaign: report.campaign,
        facts: facts::facts(report.campaign, report.tested, words),
        import: report.import,
        features: report.features,
        world: &report.frames.world,
        fit: identified.parameters,
        messages: report.messages(),
        verdict: verdict::verdict(report, identified, words),
        definition: &identified.accuracy.definition,
        sets: tables::sets(identified.accuracy, words),
        poses: tables::poses(identified.errors, words),
        parameters: parameters::rows(&identified.parameters.parameters, words),
        parameter_pictures: drawn.parameters,
        pictures: drawn.errors,
        residual_pictures: drawn.residuals,
        observability_pictures: drawn.observability,
        geometric: identified.geometric.map(|g| geometric::section(g, words)),
        iso9283: report.tested.poses.as_ref().map(|i| iso9283::section(i, words)),
        compliance: iso9283::compliance(report.tested.compliance.as_ref(), words),
        streams: report.tested.streams.as_ref().map(|s| streams::sections(s, words)).unwrap_or_default(),
        undrawn: identified.errors.len() - points::drawable(identified.errors).len(),
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
fn test_html(report: &Report, words: &Words) -> Result<String> {
    let presentation = &report.campaign.report;
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
        messages: report.messages(),
        class,
        sentences,
        title: iso9283::title(report.tested, words),
        iso9283: report.tested.poses.as_ref().map(|i| iso9283::section(i, words)),
        compliance: iso9283::compliance(report.tested.compliance.as_ref(), words),
        streams: report.tested.streams.as_ref().map(|s| streams::sections(s, words)).unwrap_or_default(),
    };
    templates::render("repeatability.html", presentation, words, page)
}
