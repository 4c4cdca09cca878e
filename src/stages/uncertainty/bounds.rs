//! Messages about components whose uncertainty exceeds its bound: such an answer must not be
//! loaded.

use crate::stages::truncated;
use etalon_base::catalogue::Phrase;
use etalon_base::message::Message;
use etalon_base::pose::{minus, unit};
use etalon_base::{error, phrase};
use etalon_documents::ParametersDocument;
use etalon_identify::{Excess, Extent, Identification, Observation, OpenMotion, OpenSetUp, Settings, UncertaintyBound};
use etalon_robots::{Kinematics, Quantity, Robot, Role};

/// Name and quantity of a component of an answer.
pub(crate) type Component = (Phrase, Quantity);

/// Maximum number of components of an open combination in a message.
const NAMED: usize = 5;

/// Error about the component that exceeds its bound most; `None` if all are within it. `covariance`
/// contains the components (mm, rad, 1), row by row. Three lengths, or three lengths and three
/// angles, are a point or a frame.
pub(crate) fn beyond_bound(
    bound: UncertaintyBound,
    extent: &Extent,
    components: &[Component],
    covariance: &[f64],
    hint: Phrase,
) -> Option<Message> {
    let quantities: Vec<Quantity> = components.iter().map(|c| c.1).collect();
    let excess = bound.exceeded(&quantities, covariance, extent)?;
    let is_frame = matches!(
        quantities[..],
        [Quantity::Length, Quantity::Length, Quantity::Length]
            | [Quantity::Length, Quantity::Length, Quantity::Length, Quantity::Angle, Quantity::Angle, Quantity::Angle]
    );
    let cause = if is_frame { open_motion(&excess) } else { open_combination(&excess, components) };
    Some(message(&excess, components, extent, cause).hint(hint))
}

/// Error about parameters of base and targets, or without tolerances of the robot, that the data
/// leave open beyond the bound.
pub(crate) fn open_set_up(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    found: &Identification,
    bound: UncertaintyBound,
) -> Option<Message> {
    let OpenSetUp { parameters, excess, extent } = found.open_set_up(robot, observations, settings, bound)?;
    let component = |i: &usize| {
        let p = &robot.parameters()[*i];
        (phrase!("bound-parameter", parameter = p.name), p.quantity)
    };
    let components: Vec<Component> = parameters.iter().map(component).collect();
    let of_set_up = excess.involved.iter().all(|k| robot.parameters()[parameters[*k]].role != Role::Robot);
    let case = if of_set_up { "base" } else { "robot" };
    let cause = base_rotation(robot, &parameters, &excess).unwrap_or_else(|| open_combination(&excess, &components));
    let message = message(&excess, &components, &extent, cause);
    Some(message.hint(phrase!("bound-remedy", case)))
}

/// Rotation of the base in the open combination, by its direction in the world: balls of a world
/// frame on a line leave it open. `None` if no angle of the base is involved.
fn base_rotation(robot: &dyn Robot, parameters: &[usize], excess: &Excess) -> Option<Phrase> {
    let angle = |k: usize| {
        let p = &robot.parameters()[parameters[k]];
        p.axis.filter(|_| p.role == Role::Base && p.quantity == Quantity::Angle)
    };
    excess.involved.iter().find_map(|k| angle(*k))?;
    let mut turn = [0.0; 3];
    for (k, open) in excess.open.iter().enumerate() {
        if let Some(part) = angle(k).and_then(|axis| turn.get_mut(axis)) {
            *part += open;
        }
    }
    let direction = unit(turn)?.map(|v| format!("{:.3}", (1e3 * v).round() / 1e3 + 0.0)).join(" ");
    Some(phrase!("bound-open-rotation", direction))
}

/// Step of a parameter, in standard uncertainties, in numeric derivatives of a pose.
const STEP: f64 = 0.1;
/// Minimum share of a parameter that the data determine: others keep to their tolerance.
const DETERMINED: f64 = 0.5;

/// Error about the pose of an identified robot with the largest uncertainty relative to its bound,
/// among these joint values (mm or rad); the positions and the base are the extent.
///
/// Contains the uncertainties that the data leave of the robot's parameters. Parameters that rest
/// on their tolerances are the same with nominal values.
pub(crate) fn poses_beyond_bound(
    arm: &dyn Kinematics,
    document: &ParametersDocument,
    values: &[f64],
    joints: &[(String, Vec<f64>)],
    bound: UncertaintyBound,
) -> Option<Message> {
    let free: Vec<(usize, usize, f64)> = document
        .identified()
        .enumerate()
        .filter_map(|(k, entry)| {
            let i = arm.index(&entry.name)?;
            let counts =
                entry.determined.is_none_or(|share| share >= DETERMINED) && arm.parameters()[i].role == Role::Robot;
            counts.then_some((k, i, arm.parameters()[i].quantity.inward(1.0)))
        })
        .collect();
    let covariance =
        |a: &(usize, usize, f64), b: &(usize, usize, f64)| Some(document.covariance.get(a.0)?.get(b.0)? * a.2 * b.2);
    let places = joints.iter().filter_map(|(_, q)| Some(arm.tool_pose(values, q)?.translation_mm));
    let extent = Extent::from_points(&places.chain([[0.0; 3]]).collect::<Vec<_>>(), document.residuals.rms);
    let of_pose = |(name, q): &(String, Vec<f64>)| {
        let columns: Vec<[f64; 6]> =
            free.iter().map(|f| derivative(arm, values, q, f.1, covariance(f, f)?.sqrt())).collect::<Option<_>>()?;
        let mut all = [[0.0; 6]; 6];
        for (a, left) in free.iter().zip(&columns) {
            for (b, right) in free.iter().zip(&columns) {
                let c = covariance(a, b)?;
                (0..36).for_each(|at| all[at / 6][at % 6] += left[at / 6] * c * right[at % 6]);
            }
        }
        let excess = bound.frame_exceeded(&all, &extent)?;
        Some((excess.expanded / excess.bound, name.clone(), all))
    };
    let (_, name, covariance) = joints.iter().filter_map(of_pose).max_by(|a, b| a.0.total_cmp(&b.0))?;
    let axes = || ["x", "y", "z"].into_iter();
    let positions = axes().map(|axis| (phrase!("bound-position", axis, name = name), Quantity::Length));
    let rotations = axes().map(|axis| (phrase!("bound-rotation", axis, name), Quantity::Angle));
    let components: Vec<Component> = positions.chain(rotations).collect();
    beyond_bound(bound, &extent, &components, covariance.as_flattened(), phrase!("bound-remedy", case = "region"))
}

/// Numeric derivative of position (mm) and small rotation (rad) of a pose by the parameter `i` with
/// the standard uncertainty `u`; `None` if a pose does not exist.
fn derivative(arm: &dyn Kinematics, values: &[f64], q: &[f64], i: usize, u: f64) -> Option<[f64; 6]> {
    let step = if u > 0.0 { STEP * u } else { return Some([0.0; 6]) };
    let moved = |by: f64| {
        let mut values = values.to_vec();
        values[i] += by;
        arm.tool_pose(&values, q)
    };
    let (up, down) = (moved(step)?, moved(-step)?);
    let shift = minus(up.translation_mm, down.translation_mm);
    let turn = up.then(&down.inverse()).rotation_vector_rad();
    Some(std::array::from_fn(|k| if k < 3 { shift[k] } else { turn[k - 3] }).map(|v| v / (2.0 * step)))
}

/// The error, with its cause.
fn message(excess: &Excess, components: &[Component], extent: &Extent, cause: Phrase) -> Message {
    let (component, quantity) = &components[excess.component];
    let outward = |value: f64| significant(quantity.outward(value));
    let source = if excess.is_stated { "stated" } else { "default" };
    error!(
        "uncertainty-beyond-bound",
        component,
        expanded = outward(excess.expanded),
        bound = outward(excess.bound),
        unit = quantity.unit(),
        source,
        extent_mm = significant(extent.length_mm),
        cause
    )
}

/// Three significant digits.
pub(crate) fn significant(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return value.to_string();
    }
    let decimals = (2.0 - value.abs().log10().floor()).clamp(0.0, 9.0) as usize;
    format!("{value:.decimals$}")
}

fn open_motion(excess: &Excess) -> Phrase {
    let text =
        |v: [f64; 3], decimals: usize| v.map(|v| format!("{:.decimals$}", (1e3 * v).round() / 1e3 + 0.0)).join(" ");
    match excess.motion() {
        OpenMotion::Rotation(direction) => phrase!("bound-open-rotation", direction = text(direction, 3)),
        OpenMotion::Translation(direction) => phrase!("bound-open-translation", direction = text(direction, 3)),
    }
}

fn open_combination(excess: &Excess, components: &[Component]) -> Phrase {
    let mut names: Vec<Phrase> = excess.involved.iter().map(|i| components[*i].0.clone()).collect();
    names.dedup();
    match names.len() {
        0 | 1 => phrase!("bound-open-alone"),
        _ => phrase!("bound-open-combination", names = truncated(names, NAMED)),
    }
}
