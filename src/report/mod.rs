//! The report: one page that needs no network, made from the documents alone.
//!
//! `html` is a pure function: it reads nothing but its argument and writes the same bytes for the same documents.

mod arrows;
mod axis;
mod by_pose;
#[cfg(test)]
mod demo;
mod geometric;
mod histogram;
mod map;
mod number;
mod parameters;
mod plan;
mod plane;
mod points;
mod svg;
mod tables;
#[cfg(test)]
mod tests;
mod verdict;

pub use plan::html as plan_html;

use crate::document::{
    AccuracyDocument, CampaignSummary, FeaturesDocument, FramesDocument, GeometricDocument, ImportDocument,
    ParametersDocument, PointError, WorldFrame,
};
use crate::message::one_line;
use crate::message::{Message, Result};
use minijinja::syntax::SyntaxConfig;
use minijinja::value::Serde;
use minijinja::{Environment, UndefinedBehavior};
use serde::Serialize;

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
}

/// What the template sees: documents as they are, and what was computed from them.
#[derive(Serialize)]
struct Page<'a> {
    campaign: &'a CampaignSummary,
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
    pictures: Vec<points::Picture>,
    geometric: Option<geometric::Section<'a>>,
    /// errors that are not finite
    undrawn: usize,
}

/// The report as one HTML page.
pub fn html(report: &Report) -> Result<String> {
    let fail = |e: minijinja::Error| Message::error(format!("cannot write the report: {e:#}"));
    let mut environment = environment().map_err(fail)?;
    let page = Page {
        campaign: report.campaign,
        import: report.import,
        features: report.features,
        world: &report.frames.world,
        fit: report.parameters,
        messages: messages(report),
        verdict: verdict::verdict(report),
        definition: &report.accuracy.definition,
        sets: tables::sets(report.accuracy),
        poses: tables::poses(report.errors),
        parameters: parameters::rows(&report.parameters.parameters),
        pictures: pictures(report),
        geometric: report.geometric.map(geometric::section),
        undrawn: report.errors.len() - points::drawable(report.errors).len(),
    };
    // the name's ending turns escaping on
    environment.add_template("report.html", include_str!("report.html")).map_err(fail)?;
    let template = environment.get_template("report.html").map_err(fail)?;
    Ok(template.render(Serde(page)).map_err(fail)?)
}

/// Templates with their filters and the style that they share.
fn environment() -> std::result::Result<Environment<'static>, minijinja::Error> {
    let mut environment = Environment::new();
    environment.set_undefined_behavior(UndefinedBehavior::Strict);
    environment.set_syntax(SyntaxConfig::builder().trim_blocks(true).lstrip_blocks(true).build()?);
    environment.add_filter("significant", |value: f64, digits: usize| number::significant(value, digits));
    environment.add_filter("fixed", |value: f64, decimals: usize| number::fixed(value, decimals));
    environment
        .add_filter("stated", |value: f64| if value.is_finite() { value.to_string() } else { "not a number".into() });
    environment.add_filter("one_line", |text: String| one_line(&text));
    environment.add_template("style.html", include_str!("style.html"))?;
    Ok(environment)
}

fn messages<'a>(report: &Report<'a>) -> Vec<&'a Message> {
    let geometric = report.geometric.iter().flat_map(|g| &g.messages);
    report.parameters.messages.iter().chain(&report.import.messages).chain(geometric).collect()
}

fn pictures(report: &Report) -> Vec<points::Picture> {
    let errors = points::drawable(report.errors);
    if errors.is_empty() {
        return vec![];
    }
    let flat = |p: &&PointError| p.at_mm[2] == 0.0 && p.before_mm[2] == 0.0 && p.after_mm[2] == 0.0;
    let planar = report.frames.world.planar || errors.iter().all(flat);
    let mut pictures = map::maps(&errors, planar);
    pictures.extend(arrows::arrows(&errors, planar));
    pictures.extend(histogram::histogram(&errors));
    pictures.extend(by_pose::pictures(&errors));
    pictures
}
