//! Excitation: parameters that need motion of the joints.

use crate::model::residuals::Residuals;
use crate::{Observation, Prior, Result, Settings, wanted_parameters};
use etalon_base::noise::Noise;
use etalon_math::{covariance, factor_at};
use etalon_robots::{Quantity, Robot};

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
