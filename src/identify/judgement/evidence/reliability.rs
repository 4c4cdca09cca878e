//! Mutual control of residuals: redundancy and least detectable error of every reading (Baarda
//! 1968, A testing procedure for use in geodetic networks), and influence of every pose on the
//! parameters (Cook 1977).

use crate::Result;
use crate::judgement::uncertainty::UncertaintyFrom;
use crate::model::residuals::{ResidualKind, Residuals};
use crate::{Identification, Observation, Settings};
use etalon_base::pose_name::PoseName;
use etalon_math::{Problem, covariance, factor_at};
use etalon_robots::Robot;
use nalgebra::{Cholesky, DMatrix, DVector};
use rayon::prelude::*;
use statrs::distribution::{ContinuousCDF, FisherSnedecor};
use std::collections::BTreeMap;

/// Significance level of the test of one residual (Baarda 1968).
pub const ALPHA_0: f64 = 0.001;
/// Power with which the least detectable error is detected (Baarda 1968).
pub const BETA_0: f64 = 0.8;
/// A residual over its standard deviation beyond which it is an outlier: the quantile of the normal
/// distribution for [`ALPHA_0`].
pub const CRITICAL_W: f64 = 3.290_526_731_491_9;
/// Standard deviations by which a reading must be wrong so that its test detects it with
/// [`BETA_0`]: that quantile and the one of the power.
const DELTA_0: f64 = CRITICAL_W + 0.841_621_233_572_914;

/// Control of a reading by the others, for its worst coordinate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ReadingReliability {
    /// Redundancy number r = 1 - h, from 0 (nothing controls it) to 1: the share of an error that
    /// its residual shows.
    pub redundancy: f64,
    /// Largest residual over its standard deviation σ √r.
    pub w: f64,
    /// Smallest error (mm) of a coordinate that is detected with a power of 80 % (significance
    /// level 0.1 %): 4.13 σ / √r.
    pub detectable_mm: f64,
}

/// Change of the identification without a pose.
#[derive(Clone, Debug, PartialEq)]
pub struct PoseInfluence {
    /// The pose.
    pub pose: PoseName,
    /// Cook's distance of all rows of the pose: the squared change of the parameters over n times
    /// their covariance by the residuals; infinite if the other poses do not determine all
    /// parameters.
    pub cooks_distance: f64,
    /// Index of the parameter that changes most over its standard uncertainty by the residuals.
    pub parameter: usize,
    /// Change of this parameter over its standard uncertainty.
    pub change_over_u: f64,
}

/// Reliability of an identification from equally weighted positions.
#[derive(Clone, Debug, PartialEq)]
pub struct Reliability {
    /// One for each measured target, in the order of the observations and their targets.
    pub readings: Vec<Vec<Option<ReadingReliability>>>,
    /// The most influential first.
    pub poses: Vec<PoseInfluence>,
    /// Cook's distance beyond which a pose is influential: the median of F with n and m - n degrees
    /// of freedom (Cook 1977).
    pub influential: f64,
    /// Standard deviation (mm) of a coordinate: the given one if it explains the residuals,
    /// otherwise the one from the residuals.
    pub sigma_mm: f64,
}

/// Reliability of the readings of an identification; `None` if they are weighted by their own
/// covariances, have errors in common, are poses instead of positions, or if many points are
/// unknown.
pub fn reliability(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    found: &Identification,
) -> Result<Option<Reliability>> {
    let settings = &settings.as_found(found);
    let problem = Residuals::new(robot, observations, settings, &found.free, &found.values)?;
    let plain = settings.kind == ResidualKind::Targets && !problem.is_whitened() && !problem.is_weighted();
    let (n, dof) = (found.free.len(), found.residuals.degrees_of_freedom);
    if !plain || problem.layout.is_some() || dof == 0 {
        return Ok(None);
    }
    let x: Vec<f64> = found.free.iter().map(|&i| found.values[i]).collect();
    let (factor, norms) = factor_at(&problem, &x);
    let Some(root) = covariance(&factor, &norms).and_then(|c| Cholesky::new(DMatrix::from_row_slice(n, n, &c))) else {
        return Ok(None);
    };
    let root = root.unpack(); // F, with F Fᵀ = A⁻¹
    let mut residuals = vec![0.0; problem.residual_count()];
    problem.residuals(&x, &mut residuals);
    let variance = match found.uncertainty.from {
        UncertaintyFrom::Instrument => 1.0,
        _ => residuals[..problem.nominal_rows().start].iter().map(|r| r * r).sum::<f64>() / dof as f64,
    };
    let sigma = variance.sqrt();
    let jacobian = problem.jacobian_at(&x);
    let seen = |rows: &[usize]| DMatrix::from_fn(rows.len(), n, |i, j| jacobian[rows[i] * n + j]) * &root; // K = J F
    let dimension = robot.dimension();
    let mut row = 0;
    let mut reading = |measured: bool| {
        measured.then(|| {
            let rows: Vec<usize> = (row..row + dimension).collect();
            row += dimension;
            let k = seen(&rows);
            let mut worst = ReadingReliability { redundancy: 1.0, w: 0.0, detectable_mm: 0.0 };
            for (i, &row) in rows.iter().enumerate() {
                let redundancy = (1.0 - k.row(i).norm_squared()).clamp(0.0, 1.0);
                let spread = sigma * redundancy.sqrt();
                worst.redundancy = worst.redundancy.min(redundancy);
                worst.w = if spread > NOTHING * sigma { worst.w.max(residuals[row].abs() / spread) } else { worst.w };
                worst.detectable_mm = worst.detectable_mm.max(DELTA_0 * sigma * problem.unit / redundancy.sqrt());
            }
            worst
        })
    };
    let readings = observations.iter().map(|o| o.targets.iter().map(|t| reading(t.is_some())).collect()).collect();
    let mut of_pose: BTreeMap<PoseName, Vec<usize>> = BTreeMap::new();
    problem.poses().into_iter().enumerate().for_each(|(row, pose)| of_pose.entry(pose).or_default().push(row));
    let u: Vec<f64> = (0..n).map(|k| sigma * root.row(k).norm()).collect();
    let influence = |(&pose, rows): (&PoseName, &Vec<usize>)| {
        let r = DVector::from_fn(rows.len(), |i, _| residuals[rows[i]]);
        let mut influence =
            PoseInfluence { pose, cooks_distance: f64::INFINITY, parameter: found.free[0], change_over_u: 0.0 };
        let Some(z) = without(&seen(rows), &r) else { return influence };
        influence.cooks_distance = z.norm_squared() / (n as f64 * variance);
        let change = &root * z;
        let over_u = |k: usize| change[k] / u[k];
        if let Some(k) = (0..n).max_by(|&a, &b| over_u(a).abs().total_cmp(&over_u(b).abs())) {
            (influence.parameter, influence.change_over_u) = (found.free[k], over_u(k).abs());
        }
        influence
    };
    let mut poses: Vec<PoseInfluence> = of_pose.par_iter().map(influence).collect();
    poses.sort_by(|a, b| b.cooks_distance.total_cmp(&a.cooks_distance).then(a.pose.cmp(&b.pose)));
    let influential = FisherSnedecor::new(n as f64, dof as f64).map_or(1.0, |f| f.inverse_cdf(0.5));
    Ok(Some(Reliability { readings, poses, influential, sigma_mm: sigma * problem.unit }))
}

/// Redundancy numbers below this squared are rounding errors and count as zero.
const NOTHING: f64 = 1e-6;

/// Kᵀ (I − K Kᵀ)⁻¹ r: the step of the parameters, over F, if the rows K with residuals r are
/// omitted; `None` if the others do not determine all parameters.
fn without(k: &DMatrix<f64>, r: &DVector<f64>) -> Option<DVector<f64>> {
    let (m, n) = k.shape();
    let least = |rest: &Cholesky<f64, nalgebra::Dyn>| rest.l_dirty().diagonal().min() > NOTHING;
    if m <= n {
        let rest = Cholesky::new(DMatrix::identity(m, m) - k * k.transpose()).filter(least)?;
        return Some(k.tr_mul(&rest.solve(r)));
    }
    let rest = Cholesky::new(DMatrix::identity(n, n) - k.tr_mul(k)).filter(least)?;
    Some(rest.solve(&k.tr_mul(r)))
}
