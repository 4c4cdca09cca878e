//! The pipeline as far as the observations, to judge parameters on them.

use super::check::{Prepared, check};
use crate::stages::join::{self, Joined};
use crate::stages::monte_carlo::{self, Draws};
use crate::stages::validation::{self, Validated};
use crate::stages::{frames, recommendation};
use etalon_base::message::{Message, Place, Result};
use etalon_campaign::{Campaign, Identify};
use etalon_documents::{FramesDocument, GivenFrames, ParametersDocument, RecommendationDocument, UncertaintyDocument};
use etalon_formats::Point;
use etalon_robots::Robot;
use std::collections::BTreeMap;

/// Judges the parameters of a document, or nominal ones, on the data of a campaign. Nothing is written.
pub fn validate(campaign: &Campaign, document: Option<&ParametersDocument>, given: GivenFrames) -> Result<Validated> {
    let Observed { stated, mut robot, joined, messages, .. } = observed(campaign)?;
    let mut found = validation::validate(campaign, stated, robot.as_mut(), &joined, document, given)?;
    found.messages.splice(0..0, messages);
    Ok(found)
}

/// Judges which parameters of a campaign deserve to be loaded; `report` is called with the choices that were tried and the most that may be.
/// Nothing is written.
pub fn recommend(campaign: &Campaign, report: &mut dyn FnMut(usize, usize)) -> Result<RecommendationDocument> {
    let Observed { stated, mut robot, joined, messages, inputs, .. } = observed(campaign)?;
    let mut found = recommendation::recommend(campaign, stated, robot.as_mut(), &joined, &inputs, report)?;
    found.messages.splice(0..0, messages);
    Ok(found)
}

/// Distributions of the results of a campaign; `report` is called with the draws made and the most that may be. Nothing is written.
pub fn uncertainty(
    campaign: &Campaign,
    draws: Draws,
    report: &mut dyn FnMut(usize, usize),
) -> Result<UncertaintyDocument> {
    let Observed { stated, mut robot, joined, messages, inputs, points, frames } = observed(campaign)?;
    let measured = (&points[..], &frames);
    let mut found = monte_carlo::distributions(campaign, stated, robot.as_mut(), &joined, measured, draws, report)?;
    found.provenance.inputs = inputs;
    found.messages.splice(0..0, messages);
    Ok(found)
}

/// A campaign as far as its observations.
struct Observed<'a> {
    stated: &'a Identify,
    robot: Box<dyn Robot>,
    joined: Joined,
    messages: Vec<Message>,
    inputs: BTreeMap<String, String>,
    points: Vec<Point>,
    frames: FramesDocument,
}

fn observed(campaign: &Campaign) -> Result<Observed<'_>> {
    let Some(stated) = &campaign.file.identify else {
        let message = Message::error("the campaign has no [identify]: nothing names the poses to judge parameters on");
        let message = message.at(Place::file(campaign.path.as_str()));
        return Err(message.hint("state `calibration` and `validation` in [identify]").into());
    };
    let Prepared { gathered, robot, .. } = check(campaign)?;
    let features = frames::fit_features(campaign, &gathered.points)?;
    let frames = frames::make_frames(campaign, &gathered.points, &features, robot.dimension() == 2)?;
    let joined = join::joined(campaign, &gathered, &frames, robot.as_ref())?;
    let inputs = gathered.document.inputs();
    let messages = [gathered.document.messages, features.messages, joined.messages.clone()].concat();
    Ok(Observed { stated, robot, joined, messages, inputs, points: gathered.points, frames })
}
