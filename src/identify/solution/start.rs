//! Starting values: a tracker may be anywhere, so base and targets of an arm are computed from the
//! observations.

use crate::Result;
use crate::judgement::diagnosis::not_located;
use crate::solution::fixtures::place_fixtures;
use crate::solution::placing::{
    MOST_TARGETS, Placed, UNEXPLAINED, place, place_targets, readings, spread_mm, spread_over,
};
use crate::solution::scatter::observed_noise_mm;
use crate::solution::set_up::{explained, far_from_nominal};
use crate::{Observation, Settings};
use etalon_base::error;
use etalon_base::pose::shortest;
use etalon_robots::{FreeBase, Robot, Role};
use std::collections::BTreeSet;

const SUBSET: usize = 24;
/// Largest root mean square distance attributed to noise of three coordinates, in standard
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
    let nominal = robot.nominal();
    let Some(arm) = robot.free_base() else { return Ok(nominal) };
    let has_points = observations.iter().any(|o| o.targets.iter().any(Option::is_some));
    let mut values = if has_points {
        by_points(robot, arm, observations, wanted, settings.coordinate_uncertainty_mm())?
    } else {
        nominal
    };
    if !settings.conditions.is_empty() {
        place_fixtures(arm, observations, settings, wanted, &mut values);
    }
    Ok(values)
}

/// Starting values from positions of targets alone.
fn by_points(
    robot: &dyn Robot,
    arm: &dyn FreeBase,
    observations: &[Observation],
    wanted: &[usize],
    noise_mm: f64,
) -> Result<Vec<f64>> {
    let nominal = robot.nominal();
    let places: Vec<usize> = wanted.iter().copied().filter(|&i| robot.parameters()[i].role != Role::Robot).collect();
    let subset = spread_over(observations, SUBSET);
    let there = |o: &Observation| {
        let measured = (0..o.targets.len()).filter(|&k| o.targets[k].is_some());
        let mut places = measured.flat_map(|k| arm.flange(&nominal, &o.joints, k).translation_mm);
        places.all(f64::is_finite)
    };
    let Placed { rms_mm, mut values } = place(robot, arm, &subset, &nominal, &places)?.ok_or_else(|| {
        if !subset.iter().all(there) {
            return far_from_nominal(robot, observations, [f64::INFINITY, 0.0], noise_mm).into();
        }
        not_located(robot, observations)
    })?;
    let all: BTreeSet<usize> = readings(robot, observations).into_iter().map(|t| t.0).collect();
    if all.len() > MOST_TARGETS {
        let shown = readings(robot, &subset);
        let others = all.into_iter().filter(|k| shown.iter().all(|t| t.0 != *k)).collect();
        place_targets(arm, observations, &others, &mut values);
    }
    let spread = spread_mm(&subset);
    // where poses are near each other, noise is a large share of their spread
    if rms_mm > (UNEXPLAINED * spread).max(NOISE_DISTANCE * observed_noise_mm(robot, observations, noise_mm)) {
        let message = error!("placement-unexplained", left_mm = rms_mm, spread_mm = spread);
        return Err(explained(message, robot, observations, noise_mm).into());
    }
    if (3..6).all(|i| places.contains(&i)) {
        let turn = shortest([values[3], values[4], values[5]]);
        values[3..6].copy_from_slice(&turn);
    }
    Ok(values)
}
