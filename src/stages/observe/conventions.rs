//! Conventions of orientations. A table states orientations in a unit, an order, a handedness and a
//! direction; each may differ from the columns. A slip is named if its correction brings the
//! observed orientations to those of the nominal robot located by positions.

use crate::stages::orientations::{AngleOrder, Form, Written};
use etalon_base::catalogue::Phrase;
use etalon_base::message::Message;
use etalon_base::pose::{Pose, Vector, norm};
use etalon_base::{error, phrase};
use etalon_identify::{Condition, Kind, Observation, Orientation, Settings, fit_frames, mounted_misfits_rad};
use etalon_math::statistics::median;
use etalon_robots::Robot;

/// Number of poses at which conventions are tried.
const SUBSET: usize = 48;
/// Median angle (rad) between observed and nominal orientations below which no slip is searched
/// for: joints of robots have errors of this size.
const RIGHT: f64 = 3.0 * DEG;
/// Maximum share of the angles after correction of a slip, relative to the angles as stated and to
/// the rotations of the robot.
const LEFT: f64 = 0.2;
/// Slips whose angles are at most this multiple of the smallest are named beside it.
const AS_GOOD: f64 = 1.5;
/// Maximum number of named slips.
const NAMED: usize = 3;
const DEG: f64 = std::f64::consts::PI / 180.0;

/// A slip, the corrected orientations, and the reversed joint.
struct Slip {
    what: Phrase,
    bodies: Vec<Option<Pose>>,
    reversed: Option<usize>,
}

/// Returns an error that names the slip with which observed orientations fit the robot, where they
/// are far from it as stated. `written` are the orientations of the table that are in the world, in
/// the order of the conditions.
pub fn wrong(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    written: &[Written],
) -> Option<Message> {
    let conditions: Vec<&Condition> = settings.conditions.iter().filter(|c| c.kind.is_world_orientation()).collect();
    if conditions.is_empty() || conditions.len() != written.len() || observations.is_empty() {
        return None;
    }
    let every = |count: usize| count.div_ceil(SUBSET).max(1);
    let some = every(conditions.len());
    let conditions: Vec<&Condition> = conditions.into_iter().step_by(some).collect();
    let written: Vec<Written> = written.iter().step_by(some).copied().collect();
    let positions: Vec<Observation> = observations.iter().step_by(every(observations.len())).cloned().collect();
    let trial = Trial { robot, conditions, positions, settings };
    let stated: Vec<Option<Pose>> = written.iter().map(|row| row.pose(None).ok()).collect();
    let placed = trial.placed(None)?;
    let stated_rad = trial.misfit_rad(&stated, None, &placed)?;
    let still = vec![Some(Pose::identity()); written.len()];
    let turns_rad = trial.misfit_rad(&still, None, &placed)?;
    if stated_rad < RIGHT {
        return None;
    }
    let joints = (0..robot.joints().len()).map(|joint| Slip {
        what: phrase!("orientation-slip", slip = "joint", name = robot.joints()[joint].name),
        bodies: stated.clone(),
        reversed: Some(joint),
    });
    let slips = slips(&written, &stated).into_iter().chain(joints);
    let judged = |slip: Slip| {
        let values = slip.reversed.map(|joint| trial.placed(Some(joint)));
        let values = values.unwrap_or_else(|| Some(placed.clone()))?;
        Some((trial.misfit_rad(&slip.bodies, slip.reversed, &values)?, slip.what))
    };
    let mut explaining: Vec<(f64, Phrase)> =
        slips.filter_map(judged).filter(|(left, _)| *left < LEFT * stated_rad.min(turns_rad)).collect();
    explaining.sort_by(|a, b| a.0.total_cmp(&b.0));
    let least = explaining.first()?.0;
    let near = explaining.iter().take_while(|(left, _)| *left <= AS_GOOD * least).take(NAMED);
    let slip = |(left, slip): &(f64, Phrase)| phrase!("slip-leaves", slip, left_deg = left.to_degrees());
    let slips: Vec<Phrase> = near.map(slip).collect();
    let message = error!("orientations-off", robot = "nominal", median_deg = stated_rad.to_degrees());
    Some(message.hint(phrase!("check-slips", slips)))
}

/// Observed orientations for the search for slips.
struct Trial<'a> {
    robot: &'a dyn Robot,
    /// Conditions of orientations.
    conditions: Vec<&'a Condition>,
    positions: Vec<Observation>,
    settings: &'a Settings,
}

impl Trial<'_> {
    /// Parameters of the nominal robot located by positions.
    fn placed(&self, reversed: Option<usize>) -> Option<Vec<f64>> {
        let settings = Settings { conditions: Vec::new(), known: Vec::new(), ..self.settings.clone() };
        let mut positions = self.positions.clone();
        if let Some(joint) = reversed {
            positions.iter_mut().for_each(|o| o.joints[joint] = -o.joints[joint]);
        }
        fit_frames(self.robot, &positions, &settings).ok()
    }

    /// Median angle between these orientations and those of the robot with `values`, rad.
    fn misfit_rad(&self, bodies: &[Option<Pose>], reversed: Option<usize>, values: &[f64]) -> Option<f64> {
        let condition = |(c, body): (&&Condition, &Option<Pose>)| {
            let Kind::Orientation(observed) = c.kind else { return None };
            let mut joints = c.joints.clone();
            reversed.into_iter().for_each(|joint| joints[joint] = -joints[joint]);
            let kind = Kind::Orientation(Orientation { frame_T_body: (*body)?, ..observed });
            Some(Condition { kind, joints, ..(*c).clone() })
        };
        let conditions: Vec<Condition> = self.conditions.iter().zip(bodies).filter_map(condition).collect();
        if conditions.len() < self.conditions.len() {
            return None;
        }
        median(mounted_misfits_rad(self.robot, &conditions, values)).filter(|angle| angle.is_finite())
    }
}

/// The orientations of a table with one slip corrected, for each slip.
fn slips(written: &[Written], stated: &[Option<Pose>]) -> Vec<Slip> {
    let mut all = Vec::new();
    let mut add = |slip: &str, name: &str, bodies: Vec<Option<Pose>>| {
        all.push(Slip { what: phrase!("orientation-slip", slip, name), bodies, reversed: None });
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
