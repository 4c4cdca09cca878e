//! The pipeline as far as the observations, to judge given parameters on them.

use super::check::{Prepared, check};
use crate::base::message::{Message, Place, Result};
use crate::campaign::Campaign;
use crate::document::{GivenFrames, ParametersDocument};
use crate::stages::frames;
use crate::stages::join;
use crate::stages::validation::{self, Validated};

/// Judges the parameters of a document, or nominal ones, on the data of a campaign. Nothing is written.
pub fn validate(campaign: &Campaign, document: Option<&ParametersDocument>, given: GivenFrames) -> Result<Validated> {
    let Some(stated) = &campaign.file.identify else {
        let message = Message::error("the campaign has no [identify]: nothing names the poses to judge parameters on");
        return Err(message
            .at(Place::file(campaign.path.as_str()))
            .hint("state `calibration` and `validation` in [identify]")
            .into());
    };
    let Prepared { mut gathered, mut robot, .. } = check(campaign)?;
    let features = frames::fit_features(campaign, &gathered.points)?;
    let frames = frames::make_frames(campaign, &gathered.points, &features, robot.dimension() == 2)?;
    gathered.document.messages.extend(features.messages);
    let joined = join::joined(campaign, &gathered, &frames, robot.as_ref())?;
    let mut found = validation::validate(campaign, stated, robot.as_mut(), &joined, document, given)?;
    found.messages.splice(0..0, gathered.document.messages.into_iter().chain(joined.messages));
    Ok(found)
}
