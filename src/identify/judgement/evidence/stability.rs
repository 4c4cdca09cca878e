//! Stability: comparison of parameters from part of the poses with parameters from all poses
//! (Hausman 1978, Specification tests in econometrics).

use crate::Result;
use crate::judgement::robust::quantile;
use crate::model::residuals::Residuals;
use crate::{Condition, Identification, Observation, Settings};
use etalon_base::pose_name::PoseName;
use etalon_math::{Problem, covariance, linearised_at};
use etalon_robots::Robot;
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

/// Significance level for calling a parameter of a correct model unstable, for all parameters and
/// parts together.
const SIGNIFICANCE: f64 = 0.01;
/// Minimum ratio of the variance from a part to that from all poses that differs from 1.
const LEAST_RATIO: f64 = 1.001;
/// Maximum ratio at which the part determines the parameter.
const LARGEST_RATIO: f64 = 100.0;

/// Dependence of a parameter on the poses from which it is identified.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stability {
    /// Index of the parameter.
    pub parameter: usize,
    /// Largest absolute value of (value from a part of the poses minus value from all), over its
    /// standard deviation √(u_part² − u_all²).
    pub over_sd: f64,
    /// Largest difference by chance, with a probability of 99 % for all parameters together.
    pub limit: f64,
}

impl Stability {
    /// `true` if the difference is within chance.
    pub fn is_stable(&self) -> bool {
        self.over_sd <= self.limit
    }
}

/// Test of the stability of parameters.
#[derive(Clone, Copy, Debug)]
pub struct StabilityTest<'a> {
    /// Indices of the parameters.
    pub parameters: &'a [usize],
    /// Sets of poses, of which one is omitted at a time.
    pub left_out: &'a [BTreeSet<PoseName>],
}

/// The poses of the first and of the second half of the observations, in their order: a drift shows
/// as a difference between these.
pub fn halves(observations: &[Observation], conditions: &[Condition]) -> Vec<BTreeSet<PoseName>> {
    let mut seen = BTreeSet::new();
    let all = observations.iter().map(|o| o.pose).chain(conditions.iter().map(|c| c.pose));
    let order: Vec<PoseName> = all.filter(|pose| seen.insert(*pose)).collect();
    let (first, second) = order.split_at(order.len() / 2);
    [first, second].into_iter().filter(|half| !half.is_empty()).map(|half| half.iter().copied().collect()).collect()
}

/// Stability of the identified parameters among the parameters of the test, each time without one
/// set of poses; parameters that no part determines are missing.
///
/// By all poses they are efficient, so that the variance of the difference is u_part² − u_all². The
/// design gives the ratio of u_part² to u_all²: (J_partᵀ J_part)⁻¹ over (JᵀJ)⁻¹, because few poses
/// have no scatter to estimate u_part from.
///
/// # Errors
/// Fails if settings and observations do not match.
pub fn stability(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    found: &Identification,
    test: StabilityTest,
) -> Result<Vec<Stability>> {
    let StabilityTest { parameters, left_out } = test;
    let Some(whole) = Linear::new(robot, observations, settings, found)? else { return Ok(Vec::new()) };
    let of_part = |out: &BTreeSet<PoseName>| -> Result<Vec<(usize, f64)>> {
        let part: Vec<Observation> = observations.iter().filter(|o| !out.contains(&o.pose)).cloned().collect();
        let conditions = settings.conditions.iter().filter(|c| !out.contains(&c.pose)).cloned().collect();
        let settings = &Settings { conditions, ..settings.clone() };
        let Some(less) = Linear::new(robot, &part, settings, found)? else { return Ok(Vec::new()) };
        let change = |&i: &usize| {
            let k = found.free.iter().position(|&free| free == i)?;
            let ratio = less.variances[k] / whole.variances[k];
            let sd = found.standard_uncertainty(i)? * (ratio - 1.0).max(0.0).sqrt();
            let over_sd = ((less.step[k] - whole.step[k]) / sd).abs();
            ((LEAST_RATIO..LARGEST_RATIO).contains(&ratio) && over_sd.is_finite()).then_some((i, over_sd))
        };
        Ok(parameters.iter().filter_map(change).collect())
    };
    let parts = left_out.par_iter().map(of_part).collect::<Result<Vec<_>>>()?;
    let mut largest: BTreeMap<usize, f64> = BTreeMap::new();
    for (i, over_sd) in parts.into_iter().flatten() {
        let kept = largest.entry(i).or_insert(0.0);
        *kept = kept.max(over_sd);
    }
    let tests = largest.len() * left_out.len();
    let of = |(parameter, over_sd)| Stability {
        parameter,
        over_sd,
        limit: quantile(SIGNIFICANCE, tests, found.degrees_of_freedom(parameter)),
    };
    Ok(largest.into_iter().map(of).collect())
}

/// The parameters from some of the observations, to first order about those from all: a new
/// identification from few poses moves far along poorly determined directions, for which a standard
/// deviation has no meaning.
struct Linear {
    /// Step from the parameters of all observations to the parameters of these observations.
    step: Vec<f64>,
    /// Variances with residuals of unit variance.
    variances: Vec<f64>,
}

impl Linear {
    /// Stability of the identified parameters; `None` if the observations do not determine all.
    fn new(
        robot: &dyn Robot,
        observations: &[Observation],
        settings: &Settings,
        found: &Identification,
    ) -> Result<Option<Self>> {
        let settings = &settings.as_found(found);
        let problem = Residuals::new(robot, observations, settings, &found.free, &found.values)?;
        let n = found.free.len();
        if problem.residual_count() <= n {
            return Ok(None);
        }
        let x: Vec<f64> = found.free.iter().map(|&i| found.values[i]).collect();
        let mut residuals = vec![0.0; problem.residual_count()];
        problem.residuals(&x, &mut residuals);
        residuals.iter_mut().for_each(|r| *r = -*r);
        let (factor, norms) = linearised_at(&problem, &x, &residuals);
        let Some(covariance) = covariance(&factor, &norms) else { return Ok(None) };
        let step = factor.solve().map(|step| step.iter().zip(&norms).map(|(s, norm)| s / norm).collect());
        Ok(step.map(|step| Self { step, variances: (0..n).map(|k| covariance[k * n + k]).collect() }))
    }
}
