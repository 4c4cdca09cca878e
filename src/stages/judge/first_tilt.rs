//! Tilt of the base of an arm, and tilt of its first joint across the axis: each may explain the
//! same errors as the other.

use crate::stages::calibrate::solution::{Basis, Solution};
use etalon_base::message::Message;
use etalon_base::warning;
use etalon_campaign::RobotFile;
use etalon_identify::{Effects, Settings, identify_from};
use etalon_robots::{Effect, Parameter, Robot, Role};
use std::collections::BTreeSet;

/// Maximum difference of chi-square at which both tilts explain the data alike: three standard
/// deviations.
const ALIKE: f64 = 9.0;

/// Remark that the identified tilt of the base may be a tilt of the first joint, or the reverse;
/// `None` if the data distinguish them, or if both or neither are identified.
pub(crate) fn ambiguity(robot_file: &RobotFile, robot: &dyn Robot, solution: &Solution) -> Option<Message> {
    let Solution { basis: Basis { sets, settings, .. }, found, .. } = solution;
    let is_base = |p: &Parameter| p.effect == Effect::Pedestal;
    let is_first = |p: &Parameter| p.effect == Effect::Lateral && p.joint == Some(0);
    let free: Vec<&Parameter> = found.free.iter().map(|&i| &robot.parameters()[i]).collect();
    let of_base = free.iter().any(|p| is_base(p));
    if of_base == free.iter().any(|p| is_first(p)) {
        return None;
    }
    let joint = &robot.joints().first()?.name;
    let other = robot_file.build_first_tilt(joint, !of_base, robot.targets())?;
    let value = |p: &Parameter| robot.index(&p.name).map_or(p.nominal, |i| found.values[i]);
    let start: Vec<f64> = other.parameters().iter().map(value).collect();
    // the same parameters beside the other tilt
    let names: BTreeSet<&str> = free.iter().map(|p| p.name.as_str()).collect();
    let is_held = |p: &&Parameter| p.role == Role::Robot && !(is_base(p) || is_first(p) || names.contains(&*p.name));
    let mut settings = Settings { effects: Effects::All, ..settings.clone() };
    settings.hold.extend(other.parameters().iter().filter(is_held).map(|p| p.name.clone()));
    let with = identify_from(other.as_ref(), &sets.calibration, &settings, &start).ok()?;
    let (chi_square, of_other) = (found.residuals.chi_square?, with.residuals.chi_square?);
    // residuals beyond the given uncertainty tell less
    let scale = (chi_square / found.residuals.degrees_of_freedom.max(1) as f64).max(1.0);
    let stated = if of_base { "pedestal" } else { "lateral" };
    let message = warning!("tilt-of-base-or-joint", stated, joint, chi_square, of_other);
    (of_other < chi_square + ALIKE * scale).then(|| message.routine())
}
