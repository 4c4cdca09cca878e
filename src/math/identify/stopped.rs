//! Why an identification ended without a result, as the observations show it.

use super::assembly::misplaced;
use super::identifiability::{Analysis, Group};
use super::residuals::Residuals;
use super::{Observation, Settings};
use crate::base::message::{Message, Problems};
use crate::base::pose::{Vector, minus, norm};
use crate::math::robots::Robot;
use crate::math::solve::{Problem, Termination};
use std::collections::BTreeSet;

/// Measured and predicted positions whose extents differ by more than this are not in the same unit.
const SAME_UNIT: f64 = 3.0;
/// Poses that a message names.
const NAMED: usize = 8;

/// What to say when the solver ended with `termination` on its way from `start` (all parameters of the robot).
pub(super) fn stopped(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    wanted: &[usize],
    start: &[f64],
    termination: Termination,
) -> Problems {
    if matches!(termination, Termination::RankDeficient | Termination::TooFewEquations)
        && let Ok(all) = Residuals::new(robot, observations, settings, wanted, start)
    {
        return too_little(robot, observations, &all, start);
    }
    let ended = "the identification ended without a result";
    match cause(robot, observations, start) {
        Some((what, hint)) => Message::error(format!("{ended}: {what}")).hint(hint),
        None => Message::error(format!("{ended}: {termination}"))
            .hint("check units, order and signs of the joints and the nominal parameters; `hold` in [identify] holds parameters"),
    }
    .into()
}

/// What to say when no parameter is left: all are held, or those that are wanted tell nothing at `start`.
pub(super) fn nothing_left(robot: &dyn Robot, observations: &[Observation], start: &[f64]) -> Message {
    let what = "no parameter is left to identify";
    match cause(robot, observations, start) {
        Some((why, hint)) => Message::error(format!("{what}: {why}")).hint(hint),
        None => Message::error(what).hint("hold fewer parameters, and measure more poses"),
    }
}

/// The parameters that too few poses leave untold, group by group.
fn too_little(robot: &dyn Robot, observations: &[Observation], all: &Residuals, start: &[f64]) -> Problems {
    let poses: BTreeSet<i64> = observations.iter().map(|o| o.pose).collect();
    let groups = Analysis::at(all, start, 0.0).groups;
    let count = |n: usize, what: &str| format!("{n} {what}{}", if n == 1 { "" } else { "s" });
    let message = Message::error(format!(
        "{} from {}, {} of them independent, cannot tell {}",
        count(all.residual_count(), "residual"),
        count(poses.len(), "pose"),
        all.free.len() - groups.len(),
        count(all.free.len(), "parameter"),
    ))
    .hint("measure more poses (repeats of a pose tell nothing new), or hold parameters with `hold` in [identify] or --hold");
    let name = |i: usize| format!("`{}`", robot.parameters()[i].name);
    let group = |g: &Group| match &g.with[..] {
        [] => format!("the data do not see {}", name(g.held)),
        with => {
            let with: Vec<String> = with.iter().map(|&i| name(i)).collect();
            format!("{} cannot be told apart from {}", name(g.held), with.join(", "))
        }
    };
    let mut problems = vec![message];
    problems.extend(groups.iter().map(|g| Message::error(group(g))));
    Problems(problems)
}

/// What is wrong with the observations beside the robot at `start`, and what to do about it.
fn cause(robot: &dyn Robot, observations: &[Observation], start: &[f64]) -> Option<(String, String)> {
    let (mut measured, mut predicted) = (Vec::<Vector>::new(), Vec::<Vector>::new());
    let mut unreachable = BTreeSet::new();
    for o in observations {
        for (k, target) in o.targets.iter().enumerate() {
            let Some(target) = target else { continue };
            let place = robot.position(start, &o.joints, k);
            measured.push(*target);
            match place.iter().all(|v| v.is_finite()) {
                true => predicted.push(place),
                false => drop(unreachable.insert(o.pose)),
            }
        }
    }
    if !unreachable.is_empty() {
        let what = format!("the nominal robot cannot be where the joints put it in {}", poses(&unreachable));
        return Some((
            what,
            "check unit (degrees or radians), sign and offset of the joints, and the nominal parameters".into(),
        ));
    }
    let (there, here) = (extent(&measured), extent(&predicted));
    if there > SAME_UNIT * here || here > SAME_UNIT * there {
        let what = format!("measured points spread over {there:.0} mm, the model's over {here:.0} mm");
        return Some((
            what,
            "check `unit` of the exports, the units of the joints in the log, and the lengths of the robot".into(),
        ));
    }
    let wrong = misplaced(robot, observations, start);
    let (worst, other) = wrong.first()?;
    let of: BTreeSet<i64> = wrong.iter().map(|(o, _)| o.pose).collect();
    let mode = worst.joints.last()?;
    let what = format!(
        "the tool is not where the assembly mode puts it in {}: pose {} is stated in mode {mode:+}, where the model is {:.1} mm \
         from the measured position, in mode {:+} {:.1} mm",
        poses(&of),
        worst.pose,
        other.0,
        -mode,
        other.1
    );
    Some((
        what,
        "correct the column `assembly` of these poses, or leave it empty: the mode is then taken from the measurement"
            .into(),
    ))
}

/// Diagonal of the smallest box around points, mm.
fn extent(points: &[Vector]) -> f64 {
    let end = |pick: fn(f64, f64) -> f64| {
        points.iter().copied().reduce(|a, b| [0, 1, 2].map(|i| pick(a[i], b[i]))).unwrap_or_default()
    };
    norm(minus(end(f64::max), end(f64::min)))
}

fn poses(numbers: &BTreeSet<i64>) -> String {
    let shown: Vec<String> = numbers.iter().take(NAMED).map(i64::to_string).collect();
    match numbers.len() {
        1 => format!("pose {}", shown.join("")),
        n if n > NAMED => format!("{n} poses ({}, ...)", shown.join(", ")),
        n => format!("{n} poses ({})", shown.join(", ")),
    }
}
