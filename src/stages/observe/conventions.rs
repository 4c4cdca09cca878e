//! Conventions of orientations. A table contains orientations in a unit, an order, a handedness and
//! a direction; each may differ from the columns. The judge of the set-up compares every way of
//! reading them.

use crate::stages::orientations::{AngleOrder, Form, Written};
use etalon_base::message::Message;
use etalon_base::pose::{Pose, Vector, norm};
use etalon_base::{error, phrase};
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
    let stated: Vec<Option<Pose>> = written.iter().map(|row| row.pose(None).ok()).collect();
    let mut readings = readings(written, &stated);
    // in the order of all conditions
    for reading in &mut readings {
        let mut bodies = std::mem::take(&mut reading.bodies).into_iter();
        let body = |c: &Condition| if is_in_world(&c) { bodies.next().flatten() } else { None };
        reading.bodies = settings.conditions.iter().map(body).collect();
    }
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

/// Other ways of reading the orientations of a table.
fn readings(written: &[Written], stated: &[Option<Pose>]) -> Vec<OrientationReading> {
    let mut all = Vec::new();
    let mut add = |slip: &str, name: &str, bodies: Vec<Option<Pose>>| {
        all.push(OrientationReading { what: phrase!("orientation-slip", slip, name), bodies });
    };
    let numbers = |how: &dyn Fn([f64; 9]) -> Option<Pose>| written.iter().map(|row| how(row.numbers)).collect();
    let form = written[0].form;
    let three = |n: [f64; 9]| [n[0], n[1], n[2]];
    match form {
        Form::Quaternion => {
            let by = |at: [usize; 4]| numbers(&|n| quaternion(at.map(|k| n[k])));
            add("scalar-last", "", by([3, 0, 1, 2]));
            add("scalar-first", "", by([1, 2, 3, 0]));
            let inverse = |at: [usize; 4]| numbers(&|n| Some(quaternion(at.map(|k| n[k]))?.inverse()));
            add("scalar-last-inverse", "", inverse([3, 0, 1, 2]));
        }
        Form::Angles => {
            let is_other = |other: &AngleOrder| written.iter().any(|row| row.order != Some(*other));
            for other in AngleOrder::all().into_iter().filter(is_other) {
                add("order", &other.to_string(), numbers(&|n| Some(other.pose(three(n)))));
            }
            add("vectors", "", numbers(&|n| Some(Pose::from_rotation_vector(three(n)))));
            let negated = |row: &Written| Written { numbers: row.numbers.map(|v| -v), ..*row }.pose(None).ok();
            add("negated", "", written.iter().map(negated).collect());
        }
        Form::Vector => {
            for order in AngleOrder::all() {
                add("order-of-vectors", &order.to_string(), numbers(&|n| Some(order.pose(three(n)))));
            }
        }
        Form::None | Form::Matrix => {}
    }
    if matches!(form, Form::Angles | Form::Vector) {
        for (factor, unit) in [(1.0 / DEG, "radians"), (DEG, "degrees")] {
            let scaled = |row: &Written| Written { numbers: row.numbers.map(|v| factor * v), ..*row }.pose(None).ok();
            add(unit, "", written.iter().map(scaled).collect());
        }
    }
    let turned = |how: &dyn Fn(Vector) -> Vector| {
        let turn = |body: &Option<Pose>| Some(Pose::from_rotation_vector(how(body.as_ref()?.rotation_vector_rad())));
        stated.iter().map(turn).collect()
    };
    add("inverse", "", turned(&|v| v.map(|v| -v)));
    // a mirror turns the axis of a rotation over, and keeps its part along the normal
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        let mirrored = |v: Vector| [0, 1, 2].map(|i| if i == axis { v[i] } else { -v[i] });
        add("left-handed", name, turned(&mirrored));
    }
    all
}

/// The rotation of a quaternion, the scalar first; `None` if its length is zero.
fn quaternion(numbers: [f64; 4]) -> Option<Pose> {
    let length = norm([numbers[1], numbers[2], numbers[3]]).hypot(numbers[0]);
    (length > 0.5).then(|| Pose::from_quaternion(numbers))
}
