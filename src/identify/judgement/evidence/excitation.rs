//! Excitation: parameters that need motion of the joints.

use crate::judge::tolerance_effect_mm;
use crate::model::residuals::Residuals;
use crate::solution::scatter::observed_noise_mm;
use crate::{Observation, Prior, Result, Settings, wanted_parameters};
use etalon_base::noise::Noise;
use etalon_base::pose::{Vector, centroid, minus, norm};
use etalon_math::statistics::rms;
use etalon_math::{covariance, factor_at};
use etalon_robots::{Quantity, Robot, Role};

/// Maximum determined share of a parameter that the data leave to its tolerance; two parameters
/// with the same effect have a half each.
const BY_TOLERANCE: f64 = 0.7;
/// Minimum determined share if the joint moved.
const BY_DATA: f64 = 0.9;
/// Test motion (rad) of a revolute joint.
const MOVED_RAD: f64 = 0.5;
/// Test motion (mm) of a prismatic joint.
const MOVED_MM: f64 = 100.0;
/// Seed of the test motions.
const SEED: u64 = 50;
/// Maximum range (rad) of a revolute joint that hardly moves.
const STILL_RAD: f64 = 0.5 * std::f64::consts::PI / 180.0;
/// Maximum range (mm) of a prismatic joint that hardly moves.
const STILL_MM: f64 = 0.5;
/// Maximum scatter of measured positions, relative to the scatter of the predicted positions and of
/// the noise, if joints hardly move.
const FARTHER: f64 = 3.0;
/// Change of a joint value (mm or rad) by rounding.
const ROUNDING: f64 = 1e-9;

/// Observations that show no parameter of the robot because no joint moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unmoved {
    /// Number of observations and conditions.
    pub rows: usize,
    /// Largest range of a revolute joint.
    pub range_deg: f64,
    /// Largest range of a prismatic joint.
    pub range_mm: f64,
    /// Root mean square distance of measured positions from the mean of their target.
    pub scatter_mm: f64,
}

/// Observations whose joints do not move: all values are equal, or, with `values` of all parameters
/// and base and targets located, hardly move and the effect of the robot's tolerances is below the
/// noise. `None` if the observations show parameters of the robot, or none is free.
///
/// # Errors
/// Fails if settings and observations do not match.
pub fn unmoved(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    values: Option<&[f64]>,
) -> Result<Option<Unmoved>> {
    let joints = || observations.iter().map(|o| &o.joints).chain(settings.conditions.iter().map(|c| &c.joints));
    let rows = joints().count();
    let range = |k: usize| {
        let of = || joints().filter_map(|q| q.get(k).copied());
        of().fold(f64::NEG_INFINITY, f64::max) - of().fold(f64::INFINITY, f64::min)
    };
    let largest = |quantity: Quantity| {
        let of = robot.joints().iter().enumerate().filter(|(_, j)| j.quantity == quantity);
        of.map(|(k, _)| range(k)).filter(|r| *r > ROUNDING).fold(0.0, f64::max)
    };
    let (range_rad, range_mm) = (largest(Quantity::Angle), largest(Quantity::Length));
    // directions of approach, loads and temperatures follow the joints
    let columns = joints().map(Vec::len).max().unwrap_or_default();
    let others = (robot.joints().len()..columns).any(|k| range(k) > ROUNDING);
    let parameters = robot.parameters();
    let is_free = || {
        wanted_parameters(robot, observations, settings).map(|w| w.iter().any(|&i| parameters[i].role == Role::Robot))
    };
    if rows < 2 || others || range_rad >= STILL_RAD || range_mm >= STILL_MM || !is_free()? {
        return Ok(None);
    }
    let scatter_mm = target_scatter_mm(robot, observations, &|o, k| o.targets.get(k).copied().flatten());
    let is_hidden = |values: &[f64]| {
        let noise_mm = observed_noise_mm(robot, observations, settings.coordinate_uncertainty_mm());
        let noise_mm = noise_mm * (robot.dimension() as f64).sqrt();
        let predicted_mm = target_scatter_mm(robot, observations, &|o, k| {
            o.targets.get(k).copied().flatten().map(|_| robot.position(values, &o.joints, k))
        });
        // points that move while no joint does show joint values in another unit or of another file
        settings.conditions.is_empty()
            && scatter_mm <= FARTHER * predicted_mm.hypot(noise_mm)
            && tolerance_effect_mm(robot, observations, values).is_some_and(|effect_mm| effect_mm <= noise_mm)
    };
    let is_unmoved = range_rad.max(range_mm) == 0.0 || values.is_some_and(is_hidden);
    let range_deg = range_rad.to_degrees();
    Ok(is_unmoved.then_some(Unmoved { rows, range_deg, range_mm, scatter_mm }))
}

/// Root mean square distance of positions from the mean of their target.
fn target_scatter_mm(
    robot: &dyn Robot,
    observations: &[Observation],
    position: &dyn Fn(&Observation, usize) -> Option<Vector>,
) -> f64 {
    let off = |k: usize| {
        let points: Vec<Vector> = observations.iter().filter_map(|o| position(o, k)).collect();
        let mean = centroid(&points).unwrap_or_default();
        points.into_iter().map(|p| norm(minus(p, mean))).collect::<Vec<f64>>()
    };
    let all: Vec<f64> = (0..robot.targets().len()).flat_map(off).collect();
    if all.is_empty() { 0.0 } else { rms(all) }
}

/// Indices of the parameters that the data leave to their tolerances because `joint` does not move:
/// if it moved, the data would determine them. `values` are all parameters with base and targets
/// located.
///
/// # Errors
/// Fails if settings and observations do not match.
pub fn left_to_tolerances(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    values: &[f64],
    joint: usize,
) -> Result<Vec<usize>> {
    let wanted = wanted_parameters(robot, observations, settings)?;
    let settings = Settings { prior: Prior::TOLERANCES, ..settings.clone() };
    let shares = |settings: &Settings, observations: &[Observation]| -> Result<Vec<Option<f64>>> {
        let problem = Residuals::new(robot, observations, settings, &wanted, values)?;
        let x: Vec<f64> = wanted.iter().map(|&i| values[i]).collect();
        let (factor, norms) = factor_at(&problem, &x);
        let covariance = covariance(&factor, &norms).unwrap_or_default();
        let share = |(k, &i): (usize, &usize)| {
            let variance = covariance.get(k * wanted.len() + k)?;
            Some(1.0 - variance / settings.prior.uncertainty(robot, i)?.powi(2))
        };
        Ok(wanted.iter().enumerate().map(share).collect())
    };
    let as_measured = shares(&settings, observations)?;
    let mut noise = Noise::new(SEED, joint as u64);
    let most = if robot.joints()[joint].quantity == Quantity::Angle { MOVED_RAD } else { MOVED_MM };
    let (mut moved, mut conditions) = (observations.to_vec(), settings.conditions.clone());
    moved.iter_mut().for_each(|o| o.joints[joint] += noise.uniform(most));
    conditions.iter_mut().for_each(|c| c.joints[joint] += noise.uniform(most));
    let if_moved = shares(&Settings { conditions, ..settings.clone() }, &moved)?;
    let gained = |(now, then): (&Option<f64>, &Option<f64>)| {
        now.is_some_and(|share| share < BY_TOLERANCE) && then.is_some_and(|share| share > BY_DATA)
    };
    let all = wanted.iter().zip(as_measured.iter().zip(&if_moved));
    Ok(all.filter(|(_, shares)| gained(*shares)).map(|(&i, _)| i).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_robots::Prexyt;

    /// Thirty poses of two targets within `range` of each joint, whose values are read times
    /// `factor`.
    fn measured(robot: &Prexyt, range: f64, factor: f64) -> Vec<Observation> {
        let (nominal, mut noise) = (robot.nominal(), Noise::new(16, 9));
        let pose = |i: i64| {
            let joints = [85.0, 150.0, 150.0].map(|q| q + noise.uniform(range)).to_vec();
            let mut seen = |[x, y]: [f64; 2]| Some([x + noise.gaussian(0.015), y + noise.gaussian(0.015), 0.0]);
            let targets = robot.balls(&nominal, &joints).map(&mut seen).to_vec();
            let joints = joints.into_iter().map(|q| q * factor).collect();
            Observation { pose: i.into(), cycle: 1, joints, targets, ..Observation::default() }
        };
        (1..=30).map(pose).collect()
    }

    /// Joints that do not move are named with the scatter of the points; joints that move, and
    /// joints in metres read as millimetres, are not.
    #[test]
    fn joints_that_do_not_move_are_named() {
        let robot = Prexyt::default();
        let nominal = robot.nominal();
        let settings = Settings::default();
        for (range, factor, expected) in [(0.0, 1.0, true), (0.005, 1.0, true), (80.0, 1.0, false), (80.0, 1e-3, false)]
        {
            let observations = measured(&robot, range, factor);
            let found = unmoved(&robot, &observations, &settings, Some(&nominal)).unwrap();
            assert_eq!(found.is_some(), expected, "{range} {factor}: {found:?}");
            if let Some(found) = found {
                assert!(found.rows == 30 && (0.012..0.03).contains(&found.scatter_mm), "{found:?}");
                assert_eq!(found.range_mm > 0.0, range > 0.0);
            }
            // without a placed robot, only joints at rest are known
            let found = unmoved(&robot, &observations, &settings, None).unwrap();
            assert_eq!(found.is_some(), range == 0.0, "{range}");
        }
        // nothing of the robot is free: repeats of one pose place base and targets
        let held = Settings { hold: vec!["*".to_owned()], ..Settings::default() };
        assert_eq!(unmoved(&robot, &measured(&robot, 0.0, 1.0), &held, Some(&nominal)).unwrap(), None);
    }
}
