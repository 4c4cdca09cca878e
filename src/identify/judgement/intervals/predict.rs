//! The uncertainty of an identification from planned observations, before any measurement.

use crate::judgement::uncertainty::held_messages;
use crate::model::prior::Prior;
use crate::model::residuals::Residuals;
use crate::solution::identifiability::{Analysis, Group, RANK_TOLERANCE};
use crate::solution::observability::{Observability, WeakGroup, observe, weak_message};
use crate::{Error, Result};
use crate::{Observation, Settings, Warning, wanted_parameters};
use etalon_base::error;
use etalon_base::message::Message;
use etalon_base::pose_name::PoseName;
use etalon_math::{Factor, Problem, column_norms, covariance, factor_at, svd};
use etalon_robots::Robot;
use std::collections::BTreeSet;

/// Identifiable parameters, and the derivatives of the targets with respect to them, at nominal
/// values.
#[derive(Clone, Debug)]
pub struct Sensitivity {
    /// Indices of the parameters that are separately identifiable.
    pub free: Vec<usize>,
    /// Sets of parameters that are not separately identifiable.
    pub groups: Vec<Group>,
    /// d positions / d free parameters (mm per mm, rad and 1), row by row.
    pub jacobian: Vec<f64>,
    /// Rows of each observation.
    pub rows: Vec<usize>,
    /// The undetermined groups in words.
    pub messages: Vec<Warning>,
}

/// Predicted result of an identification.
#[derive(Clone, Debug)]
pub struct Prediction {
    /// O1 to O5 and the condition number; `None` if they are not numbers.
    pub observability: Option<Observability>,
    /// Sets of parameters that are weakly identifiable.
    pub weak: Vec<WeakGroup>,
    /// Covariance of the free parameters, row by row (mm, rad, 1).
    pub covariance: Vec<f64>,
    /// The weak groups in words.
    pub messages: Vec<Message>,
}

/// Derivatives of `observations` with respect to the separately identifiable parameters; measured
/// positions do not matter.
pub fn sensitivity(robot: &dyn Robot, observations: &[Observation], settings: &Settings) -> Result<Sensitivity> {
    let (wanted, prior) = (wanted_parameters(robot, observations, settings)?, settings.prior);
    let nominal = robot.nominal();
    let settings = &settings.without_prior();
    let all = Residuals::new(robot, observations, settings, &wanted, &nominal)?;
    let groups = match prior {
        Prior::None => Analysis::at(&all, &nominal, all.noise(None)).groups,
        Prior::Tolerances { .. } => Analysis::by_prior(&all, &nominal).groups,
    };
    let free: Vec<usize> = wanted.into_iter().filter(|i| groups.iter().all(|g| g.held != *i)).collect();
    let problem = Residuals::new(robot, observations, settings, &free, &nominal)?;
    let mut jacobian = jacobian_at_nominal(&problem, &nominal);
    if jacobian.iter().any(|j| !j.is_finite()) {
        return Err(error!("robot-not-at-joints", parameters = "nominal").into());
    }
    jacobian.iter_mut().for_each(|j| *j *= problem.unit);
    let rows = observations.iter().map(|o| robot.dimension() * o.targets.iter().flatten().count()).collect();
    let messages = held_messages(robot, &groups);
    Ok(Sensitivity { free, groups, jacobian, rows, messages })
}

/// Predicted result of an identification of the parameters `free` from `observations`; an error if
/// they do not suffice.
pub fn predict(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    free: &[usize],
) -> Result<Prediction> {
    let nominal = robot.nominal();
    let problem = Residuals::new(robot, observations, settings, free, &nominal)?;
    let jacobian = jacobian_at_nominal(&problem, &nominal);
    let scale = column_norms(&jacobian, free.len());
    let x: Vec<f64> = free.iter().map(|&i| nominal[i]).collect();
    let factor = Factor::new(&jacobian, &vec![0.0; problem.residual_count()], &scale);
    let regular = svd(&factor).rank(RANK_TOLERANCE) == free.len() && problem.residual_count() >= free.len();
    let covariance = covariance(&factor, &scale).filter(|_| regular);
    let covariance = covariance.ok_or_else(|| {
        let poses: BTreeSet<PoseName> = observations.iter().map(|o| o.pose).collect();
        Error::TooFewPoses { poses: poses.len(), parameters: free.len() }
    })?;
    let observed = match settings.prior {
        Prior::None => observe(&problem, &x, &factor, &scale, Some(&covariance)),
        Prior::Tolerances { .. } => {
            let plain = settings.without_prior();
            let data = Residuals::new(robot, observations, &plain, free, &nominal)?;
            let (factor, scale) = factor_at(&data, &x);
            observe(&data, &x, &factor, &scale, Some(&covariance))
        }
    };
    let (observability, weak) = observed.map_or((None, Vec::new()), |(o, w)| (Some(o), w));
    let messages = weak_message(robot, &weak).into_iter().collect();
    Ok(Prediction { observability, weak, covariance, messages })
}

fn jacobian_at_nominal(problem: &Residuals, nominal: &[f64]) -> Vec<f64> {
    let x: Vec<f64> = problem.free.iter().map(|&i| nominal[i]).collect();
    problem.jacobian_rows(&problem.jacobian_at(&x)).dense()
}
