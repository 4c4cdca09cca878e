//! Previously identified parameters, for comparison with new observations.

use crate::stages::truncated;
use etalon_base::message::{Message, Result};
use etalon_base::pose_name::PoseName;
use etalon_base::{error, phrase, warning};
use etalon_documents::{ParameterEntry, ParameterStatus, ParametersDocument};
use etalon_identify::IdentifiedParameters;
use etalon_robots::{Effect, Parameter, Robot, Role, reference_poses};
use std::collections::BTreeMap;

/// The parameters of `robot` in a document, without the parameters of other targets.
///
/// # Errors
/// Fails if the document is of another robot, or lacks a parameter of this robot.
pub fn parameters_from_document(robot: &dyn Robot, document: &ParametersDocument) -> Result<IdentifiedParameters> {
    check_described(robot, document)?;
    check_geometry(robot, document)?;
    let mut values = robot.nominal();
    let (mut missing, mut places, mut free) = (Vec::new(), Vec::new(), Vec::new());
    for (i, p) in robot.parameters().iter().enumerate() {
        match entry(document, p) {
            Some(entry) => values[i] = p.quantity.inward(entry.value),
            None => missing.push(p),
        }
        // where it is in the covariance; what that leaves out has an uncertainty by itself
        let place = document.identified().position(|entry| entry.name == p.name);
        if place.is_some() || document.covariance_without.contains(&p.name) {
            places.push(place);
            free.push(i);
        }
    }
    if document.robot != robot.model() || !missing.is_empty() {
        return Err(other_robot_message(robot, document, &missing).into());
    }
    if document.covariance.is_empty() && document.parameters.iter().any(|p| p.status == ParameterStatus::Identified) {
        return Err(error!("given-without-covariance").into());
    }
    let inward = |k: usize| robot.parameters()[free[k]].quantity.inward(1.0);
    let n = places.len();
    let own = |i: usize| entry(document, &robot.parameters()[free[i]])?.standard_uncertainty;
    let covariance = (0..n * n).map(|at| {
        let (i, j) = (at / n, at % n);
        let outward = match (places[i], places[j]) {
            (Some(k), Some(l)) => document.covariance[k][l],
            _ if i == j => own(i).unwrap_or(0.0).powi(2),
            _ => 0.0,
        };
        outward * inward(i) * inward(j)
    });
    Ok(IdentifiedParameters { values, covariance: covariance.collect(), free })
}

fn entry<'d>(document: &'d ParametersDocument, p: &Parameter) -> Option<&'d ParameterEntry> {
    document.parameters.iter().find(|entry| entry.name == p.name && entry.unit == p.quantity.unit())
}

fn other_robot_message(robot: &dyn Robot, document: &ParametersDocument, missing: &[&Parameter]) -> Message {
    let names = truncated(missing.iter().map(|p| format!("`{}`", p.name)), NAMED);
    if document.robot == robot.model() && missing.iter().all(|p| p.role != Role::Robot) {
        let message = error!("calibrated-targets-missing", names);
        let target = |name: &'_ str| name.rsplit_once('_').map(|(target, _)| target.to_owned());
        let missing = missing.iter().filter(|p| p.role == Role::Target).find_map(|p| target(&p.name));
        let of_targets = document.parameters.iter().filter(|entry| entry.role == etalon_documents::Role::Target);
        let mut targets: Vec<String> = of_targets.filter_map(|entry| target(&entry.name)).collect();
        targets.dedup();
        return match missing {
            Some(target) if !targets.is_empty() => message.hint_names(&target, targets.iter().map(String::as_str)),
            _ => message,
        };
    }
    let message = error!("parameters-of-other-robot", identified = document.robot, stated = robot.model());
    if names.is_empty() { message } else { message.hint(phrase!("parameters-lacking", names)) }
}

/// Rejects parameters of the robot that its description does not have: their values would be
/// ignored. Parameters without effect, at a nominal zero, may be missing.
///
/// # Errors
/// Reports the names of these parameters, with the lines that robot.toml needs.
pub fn check_described(robot: &dyn Robot, document: &ParametersDocument) -> Result<()> {
    let lacks = |entry: &&ParameterEntry| {
        let own = robot.parameters().iter().any(|p| p.name == entry.name && entry.unit == p.quantity.unit());
        entry.role == etalon_documents::Role::Robot && !own && (entry.value != 0.0 || entry.nominal != 0.0)
    };
    let lacking: Vec<&str> = document.parameters.iter().filter(lacks).map(|entry| entry.name.as_str()).collect();
    if lacking.is_empty() || document.robot != robot.model() {
        return Ok(());
    }
    let names = truncated(lacking.iter().map(|name| format!("`{name}`")), NAMED);
    let message = error!("parameters-undescribed", names);
    let lines = needed_lines(robot, &lacking);
    Err(if lines.is_empty() { message } else { message.hint(phrase!("add-lines", lines)) }.into())
}

/// Maximum distance (mm) of flanges that counts as rounding.
const SAME_MM: f64 = 1e-6;

/// Rejects a robot whose geometry differs from the geometry of the identification even with the
/// same nominal values: parameters of screw axes (`poe`) are deviations, whose nominal values are
/// zero.
///
/// # Errors
/// Reports the distance between the flanges of both robots.
pub fn check_geometry(robot: &dyn Robot, document: &ParametersDocument) -> Result<()> {
    let distance_mm = document.geometry_distance_mm(robot).filter(|_| document.robot == robot.model());
    match distance_mm {
        Some(distance_mm) if distance_mm > SAME_MM => {
            let case = if distance_mm.is_finite() { "apart" } else { "other" };
            // three digits
            let unit = 10f64.powf(distance_mm.min(1e300).log10().floor() - 2.0);
            let distance_mm = if distance_mm.is_finite() { (distance_mm / unit).round() * unit } else { 0.0 };
            Err(error!("robot-geometry-changed", case, distance_mm).into())
        }
        _ => Ok(()),
    }
}

/// Returns a warning if a document without geometry was identified with another robot file;
/// `sha256` is the hash of the robot file.
pub fn unknown_geometry(document: &ParametersDocument, sha256: &str) -> Option<Message> {
    let inputs = &document.provenance.inputs;
    let unknown = document.reference_poses.is_empty() && !inputs.is_empty();
    (unknown && inputs.values().all(|known| known != sha256)).then(|| warning!("robot-geometry-unknown"))
}

/// Maximum number of parameters in a message.
const NAMED: usize = 5;

/// Lines of robot.toml that add these parameters to the parameters of the robot.
fn needed_lines(robot: &dyn Robot, lacking: &[&str]) -> Vec<String> {
    let mut keys: BTreeMap<&str, (bool, Vec<Vec<String>>)> = BTreeMap::new();
    let optional = robot.optional_parameters();
    for p in &optional {
        if lacking.contains(&p.name.as_str()) || robot.index(&p.name).is_some() {
            let pair = p.is_pair.then(|| p.joints.clone());
            let joints = pair.map_or_else(|| p.joints.iter().map(|j| vec![j.clone()]).collect(), |pair| vec![pair]);
            keys.entry(p.key).or_insert((p.is_pair, Vec::new())).1.extend(joints);
        }
    }
    let is_needed = |key: &str| optional.iter().any(|p| p.key == key && lacking.contains(&p.name.as_str()));
    let word = |joint: &String| if joint.parse::<u64>().is_ok() { joint.clone() } else { format!("\"{joint}\"") };
    let line = |(key, (is_pair, mut joints)): (&str, (bool, Vec<Vec<String>>))| {
        joints.sort_by_key(|of| of.iter().map(|joint| (joint.len(), joint.clone())).collect::<Vec<_>>());
        joints.dedup();
        let one = |of: &Vec<String>| {
            let words = of.iter().map(word).collect::<Vec<_>>().join(", ");
            if is_pair { format!("[{words}]") } else { words }
        };
        format!("`{key} = [{}]`", joints.iter().map(one).collect::<Vec<_>>().join(", "))
    };
    keys.into_iter().filter(|(key, _)| is_needed(key)).map(line).collect()
}

/// Returns nominal values, with the document's values for parameters of these roles: all parameters
/// of the robot itself, and the others that the document has.
///
/// # Errors
/// Fails if the document is of another robot.
pub fn robot_values(robot: &dyn Robot, document: &ParametersDocument, roles: &[Role]) -> Result<Vec<f64>> {
    check_described(robot, document)?;
    check_geometry(robot, document)?;
    let mut values = robot.nominal();
    let mut missing = Vec::new();
    for (value, p) in values.iter_mut().zip(robot.parameters()).filter(|(_, p)| roles.contains(&p.role)) {
        match entry(document, p) {
            Some(entry) => *value = p.quantity.inward(entry.value),
            None if p.role == Role::Robot => missing.push(p),
            None => {}
        }
    }
    if document.robot != robot.model() || !missing.is_empty() {
        return Err(other_robot_message(robot, document, &missing).into());
    }
    Ok(values)
}

/// Subtracts the joint zeros that a controller has loaded as mastering values from the identified
/// zeros: the joint values of the controller contain them. A transmission ratio next to 1 makes no
/// difference to zeros of this size.
pub fn mastered(mut robot: Box<dyn Robot>, document: &mut ParametersDocument, loaded: &ParametersDocument) {
    // the zero of the last joint moves no target on its axis
    let at = |p: &Parameter| if p.role == Role::Target { p.nominal + OFF_AXIS_MM } else { p.nominal };
    let values: Vec<f64> = robot.parameters().iter().map(at).collect();
    robot.definition_mut().set_nominal(&values);
    let poses = reference_poses(robot.as_ref(), &values);
    let effects = etalon_identify::effects(robot.as_ref(), poses.iter().map(|pose| &pose.joints[..]));
    for (zero, _) in robot.parameters().iter().zip(effects).filter(|(_, effect)| *effect == Some(Effect::Zeros)) {
        let Some(loaded) = entry(loaded, zero) else { continue };
        let change = loaded.value - loaded.nominal;
        let own = document.parameters.iter_mut().find(|p| p.name == loaded.name && p.unit == loaded.unit);
        if let Some(p) = own {
            p.value -= change;
        }
    }
}

/// Distance (mm) along each axis from the flange to a target that all joints move.
const OFF_AXIS_MM: f64 = 100.0;

/// Returns an error if a nominal value of the robot differs from its value in the identification:
/// the parameters belong to another robot.
pub fn other_nominal(robot: &dyn Robot, document: &ParametersDocument) -> Option<Message> {
    let differs = |p: &&Parameter| {
        let stated = p.quantity.outward(p.nominal);
        let then = entry(document, p).map_or(stated, |entry| entry.nominal);
        p.role == Role::Robot && (then - stated).abs() > 1e-9 * stated.abs().max(1.0)
    };
    let p = robot.parameters().iter().find(differs)?;
    let then = entry(document, p)?.nominal;
    let stated = p.quantity.outward(p.nominal);
    Some(error!("nominal-value-changed", parameter = p.name, stated, unit = p.quantity.unit(), identified = then))
}

/// Sums of squared errors (mm²) of the readings of a pose, with nominal and with given parameters.
pub type PoseErrors = BTreeMap<PoseName, [f64; 2]>;

/// Message that errors with the given parameters are larger than with nominal ones: an error if the
/// difference exceeds the noise from pose to pose, otherwise a warning.
pub fn worse_than_nominal(errors: &PoseErrors, readings: usize) -> Option<Message> {
    let rms = |k: usize| (errors.values().map(|squares| squares[k]).sum::<f64>() / readings.max(1) as f64).sqrt();
    let [nominal_mm, given_mm] = [rms(0), rms(1)];
    let differences: Vec<f64> = errors.values().map(|[nominal, given]| given - nominal).collect();
    let message = match etalon_identify::exceeds_zero(&differences) {
        true => error!("given-parameters-worse", given_mm, nominal_mm),
        false => warning!("given-parameters-worse", given_mm, nominal_mm),
    };
    (given_mm > nominal_mm).then(|| message.to_decide())
}
