//! Conventions of orientations. A table contains orientations in a unit, an order, a handedness and
//! a direction; each may differ from the columns. The judge of the set-up compares every way of
//! reading them.

use crate::stages::orientations::{Written, mirrored, readings};
use etalon_base::catalogue::Phrase;
use etalon_base::error;
use etalon_base::message::Message;
use etalon_base::pose::Pose;
use etalon_documents::set_up_hint;
use etalon_identify::{Condition, Observation, OrientationReading, Settings, fit_frames, judge, mounted_misfits_rad};
use etalon_math::statistics::median;
use etalon_robots::Robot;

/// Number of poses that show how far orientations are off.
const SUBSET: usize = 48;
/// Median angle (rad) between observed and nominal orientations that joints of robots do not
/// explain.
const RIGHT: f64 = 3.0 * DEG;
const DEG: f64 = std::f64::consts::PI / 180.0;

/// Returns an error that names the change with which observed orientations fit the robot, where
/// they contradict it as given. `written` are the orientations of the table that are in the world,
/// in the order of the conditions.
pub fn wrong(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    written: &[Written],
) -> Option<Message> {
    let is_in_world = |c: &&Condition| c.kind.is_world_orientation();
    let count = settings.conditions.iter().filter(is_in_world).count();
    if count == 0 || count != written.len() || observations.is_empty() {
        return None;
    }
    // in the order of all conditions
    let of_conditions = |(what, bodies): (Phrase, Vec<Option<Pose>>)| {
        let mut bodies = bodies.into_iter();
        let body = |c: &Condition| if is_in_world(&c) { bodies.next().flatten() } else { None };
        OrientationReading { what, bodies: settings.conditions.iter().map(body).collect() }
    };
    let readings: Vec<OrientationReading> =
        readings(written, None).into_iter().chain(mirrored(written)).map(of_conditions).collect();
    let found = judge(robot, observations, settings, &readings).named?;
    let is_reading = readings.iter().any(|reading| found.changes.iter().any(|(what, _)| *what == reading.what));
    let off_rad = off_rad(robot, observations, settings)?;
    (is_reading || off_rad > RIGHT).then(|| {
        let message = error!("orientations-off", robot = "nominal", median_deg = off_rad.to_degrees());
        Message { hint: Some(set_up_hint(&found)), ..message }
    })
}

/// Median angle (rad) between observed orientations and the orientations of the nominal robot
/// located by positions.
fn off_rad(robot: &dyn Robot, observations: &[Observation], settings: &Settings) -> Option<f64> {
    let every = |count: usize| count.div_ceil(SUBSET).max(1);
    let positions: Vec<Observation> = observations.iter().step_by(every(observations.len())).cloned().collect();
    let without = Settings { conditions: Vec::new(), known: Vec::new(), ..settings.clone() };
    let values = fit_frames(robot, &positions, &without).ok()?;
    let conditions: Vec<Condition> =
        settings.conditions.iter().filter(|c| c.kind.is_world_orientation()).cloned().collect();
    let some: Vec<Condition> = conditions.iter().step_by(every(conditions.len())).cloned().collect();
    median(mounted_misfits_rad(robot, &some, &values)).filter(|angle| angle.is_finite())
}
