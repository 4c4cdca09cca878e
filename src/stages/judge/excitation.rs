//! Excitation: the range of each joint in the calibration poses, and the parameters that remain at
//! their tolerances.

use crate::stages::remedies::remedied;
use crate::stages::truncated;
use etalon_base::angle::Turn;
use etalon_base::message::{Message, Result};
use etalon_base::{error, phrase, warning};
use etalon_documents::JointTravel;
use etalon_identify::{Observation, Settings, Unmoved, fit_frames, left_to_tolerances};
use etalon_robots::{Quantity, Robot};

/// Minimum motion (rad) of a revolute joint.
const STILL_RAD: f64 = 0.5 * std::f64::consts::PI / 180.0;
/// Minimum motion (mm) of a prismatic joint.
const STILL_MM: f64 = 0.5;
/// Number of poses for finding undetermined parameters.
const SUBSET: usize = 96;
/// Maximum number of parameters in a message.
const NAMED: usize = 8;

/// Ranges of all joints, mm or deg.
pub(crate) fn travels(robot: &dyn Robot, observations: &[Observation], settings: &Settings) -> Vec<JointTravel> {
    let travel = |(k, joint): (usize, &etalon_robots::Joint)| {
        let [lowest, highest] = ends(observations, settings, k)?.map(|value| joint.quantity.outward(value));
        Some(JointTravel { column: joint.column(), lowest, highest })
    };
    robot.joints().iter().enumerate().filter_map(travel).collect()
}

/// Smallest and largest value of a joint (mm or rad).
fn ends(observations: &[Observation], settings: &Settings, joint: usize) -> Option<[f64; 2]> {
    let poses = observations.iter().map(|o| &o.joints).chain(settings.conditions.iter().map(|c| &c.joints));
    poses.map(|joints| [joints[joint]; 2]).reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])])
}

/// Returns an error if no joint moves and the observations therefore show no parameter of the
/// robot. Without `values`, base and targets located, only joints at rest are known to show none.
pub(crate) fn unmoved(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    values: Option<&[f64]>,
) -> Result<()> {
    let Some(Unmoved { rows, range_deg, range_mm, scatter_mm }) =
        etalon_identify::unmoved(robot, observations, settings, values).map_err(remedied)?
    else {
        return Ok(());
    };
    let motion = match (range_deg > 0.0, range_mm > 0.0) {
        (false, false) => phrase!("motion-none"),
        (true, false) => phrase!("motion-within-angle", range_deg),
        (false, true) => phrase!("motion-within-length", range_mm),
        (true, true) => phrase!("motion-within-both", range_deg, range_mm),
    };
    let points: usize = observations.iter().map(|o| o.targets.iter().flatten().count()).sum();
    Err(error!("joints-do-not-move", rows, motion, points, scatter_mm).into())
}

/// Range of a joint (mm or rad): of an angle the arc, because whole turns move nothing.
fn range(robot: &dyn Robot, observations: &[Observation], settings: &Settings, joint: usize) -> Option<f64> {
    if robot.joints()[joint].quantity == Quantity::Angle {
        let poses = observations.iter().map(|o| &o.joints).chain(settings.conditions.iter().map(|c| &c.joints));
        let angles: Vec<f64> = poses.map(|joints| joints[joint]).collect();
        return (!angles.is_empty()).then(|| Turn::RADIANS.arc(&angles));
    }
    ends(observations, settings, joint).map(|[lowest, highest]| highest - lowest)
}

/// Warnings about joints that do not move, if parameters then remain at their tolerances.
pub(crate) fn still_joints(robot: &dyn Robot, observations: &[Observation], settings: &Settings) -> Vec<Message> {
    let still = |&joint: &usize| {
        let least = if robot.joints()[joint].quantity == Quantity::Angle { STILL_RAD } else { STILL_MM };
        range(robot, observations, settings, joint).is_some_and(|range| range < least)
    };
    let still: Vec<usize> = (0..robot.joints().len()).filter(still).collect();
    if still.is_empty() {
        return Vec::new();
    }
    let some = |count: usize| count.div_ceil(SUBSET).max(1);
    let subset: Vec<Observation> = observations.iter().step_by(some(observations.len())).cloned().collect();
    let conditions = settings.conditions.iter().step_by(some(settings.conditions.len())).cloned().collect();
    let settings = Settings { conditions, ..settings.clone() };
    let Ok(values) = fit_frames(robot, &subset, &settings) else { return Vec::new() };
    let message = |&joint: &usize| {
        let left = left_to_tolerances(robot, &subset, &settings, &values, joint).ok()?;
        let first = *left.first()?;
        let names: Vec<String> = left.iter().map(|&i| format!("`{}`", robot.parameters()[i].name)).collect();
        let (joint, first) = (&robot.joints()[joint].name, &robot.parameters()[first].name);
        Some(warning!("joint-does-not-move", joint, count = left.len(), parameters = truncated(names, NAMED), first))
    };
    still.iter().filter_map(message).collect()
}
