//! What quantities and families are called. Documents name them in English; names of parameters and streams stay.

use super::super::words::Words;
use crate::base::message::one_line;
use crate::document::{CompareFamily, CompareTrend};

/// A family in words.
pub(crate) fn family(family: CompareFamily, words: &Words) -> String {
    match family {
        CompareFamily::Robot => words.say("Parameters of the robot"),
        CompareFamily::SetUp => words.say("Parameters of base and targets"),
        CompareFamily::MeanError => words.say("Accuracy"),
        CompareFamily::PoseAccuracy => words.say("Pose accuracy AP"),
        CompareFamily::MeanPosition => words.say("Mean positions"),
        CompareFamily::PoseRepeatability => words.say("Pose repeatability RP"),
        CompareFamily::PathAccuracy => words.say("Path accuracy AT"),
        CompareFamily::PathRepeatability => words.say("Path repeatability RT"),
    }
}

/// What a picture or a row is of.
pub(super) fn quantity(trend: &CompareTrend, words: &Words) -> String {
    let name = &one_line(&trend.name);
    let told = match trend.family {
        CompareFamily::Robot => Some(words.fill("Parameter {0}", &[name])),
        CompareFamily::SetUp => Some(words.fill("Parameter {0} (base or target)", &[name])),
        CompareFamily::MeanError => error(name, words),
        CompareFamily::PoseAccuracy | CompareFamily::MeanPosition | CompareFamily::PoseRepeatability => {
            of_pose(name, words)
        }
        CompareFamily::PathAccuracy | CompareFamily::PathRepeatability => None,
    };
    told.unwrap_or_else(|| name.clone())
}

/// `position of calibration poses, before`
fn error(name: &str, words: &Words) -> Option<String> {
    let (quantity, rest) = name.split_once(" of ")?;
    let (set, when) = rest.rsplit_once(" poses, ")?;
    Some(words.fill("Mean error: {0} of {1} poses, {2}", &[&words.say(quantity), &words.say(set), &words.say(when)]))
}

/// `AP, pose 3`, `mean x, pose 3` or `RP, homing`
fn of_pose(name: &str, words: &Words) -> Option<String> {
    let (what, place) = name.split_once(", ")?;
    let what = match what.strip_prefix("mean ") {
        Some(axis) => words.fill("mean {0}", &[&axis]),
        None => what.to_owned(),
    };
    let place = match place.strip_prefix("pose ") {
        Some(pose) => words.fill("pose {0}", &[&pose]),
        None => words.say(place),
    };
    Some(format!("{what}, {place}"))
}
