//! Starting values: a tracker may be anywhere, so base and targets of an arm are computed from the
//! observations.

use crate::Result;
use crate::judge::{explained, far_from_nominal};
use crate::judgement::diagnosis::not_located;
use crate::solution::fixtures::place_fixtures;
use crate::solution::placing::{
    MOST_TARGETS, Placed, UNEXPLAINED, place, place_targets, readings, spread_mm, spread_over,
};
use crate::solution::scatter::observed_noise_mm;
use crate::{Observation, Settings};
use etalon_base::error;
use etalon_base::pose::shortest;
use etalon_robots::{FreeBase, Robot, Role};
use std::collections::BTreeSet;

const SUBSET: usize = 24;
/// Maximum root mean square distance attributed to noise of three coordinates, in standard
/// uncertainties of a coordinate: twice √3.
pub const NOISE_DISTANCE: f64 = 3.5;

/// Starting values of all parameters: nominal; for robots with a free base, the free (`wanted`)
/// parameters of base, targets and fixtures are computed from the observations.
pub(crate) fn start(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    wanted: &[usize],
) -> Result<Vec<f64>> {
    let Some(arm) = robot.free_base() else { return Ok(robot.nominal()) };
    let Some(Placed { left_mm, values }) = located(robot, arm, observations, settings, wanted)? else {
        return Err(match spread_over(observations, SUBSET).iter().all(|o| is_there(robot, arm, o)) {
            true => not_located(robot, observations),
            false => far_from_nominal(robot, observations, settings, [f64::INFINITY, 0.0]).into(),
        });
    };
    let spread = spread_mm(&spread_over(observations, SUBSET));
    let noise_mm = observed_noise_mm(robot, observations, settings.coordinate_uncertainty_mm());
    // where poses are near each other, noise is a large share of their spread
    if left_mm > (UNEXPLAINED * spread).max(NOISE_DISTANCE * noise_mm) {
        let message = error!("placement-unexplained", left_mm, spread_mm = spread);
        return Err(explained(message, robot, observations, settings).into());
    }
    Ok(values)
}

/// Base, targets and fixtures by the observations, wherever they are; `None` if no solution is
/// found.
pub(crate) fn located(
    robot: &dyn Robot,
    arm: &dyn FreeBase,
    observations: &[Observation],
    settings: &Settings,
    wanted: &[usize],
) -> Result<Option<Placed>> {
    let has_points = observations.iter().any(|o| o.targets.iter().any(Option::is_some));
    let mut placed = match has_points {
        true => by_points(robot, arm, observations, wanted)?,
        false => Some(Placed { left_mm: 0.0, values: robot.nominal() }),
    };
    if let Some(placed) = placed.as_mut().filter(|_| !settings.conditions.is_empty()) {
        place_fixtures(arm, observations, settings, wanted, &mut placed.values);
    }
    Ok(placed)
}

/// `true` if the nominal robot can be at the joint values of an observation.
fn is_there(robot: &dyn Robot, arm: &dyn FreeBase, o: &Observation) -> bool {
    let nominal = robot.nominal();
    let measured = (0..o.targets.len()).filter(|&k| o.targets[k].is_some());
    let mut places = measured.flat_map(|k| arm.flange(&nominal, &o.joints, k).translation_mm);
    places.all(f64::is_finite)
}

/// Base and targets from positions alone.
fn by_points(
    robot: &dyn Robot,
    arm: &dyn FreeBase,
    observations: &[Observation],
    wanted: &[usize],
) -> Result<Option<Placed>> {
    let places: Vec<usize> = wanted.iter().copied().filter(|&i| robot.parameters()[i].role != Role::Robot).collect();
    let subset = spread_over(observations, SUBSET);
    let Some(mut placed) = place(robot, arm, &subset, &robot.nominal(), &places)? else { return Ok(None) };
    let values = &mut placed.values;
    let all: BTreeSet<usize> = readings(robot, observations).into_iter().map(|t| t.0).collect();
    if all.len() > MOST_TARGETS {
        let shown = readings(robot, &subset);
        let others = all.into_iter().filter(|k| shown.iter().all(|t| t.0 != *k)).collect();
        place_targets(arm, observations, &others, values);
    }
    if (3..6).all(|i| places.contains(&i)) {
        let turn = shortest([values[3], values[4], values[5]]);
        values[3..6].copy_from_slice(&turn);
    }
    Ok(Some(placed))
}
