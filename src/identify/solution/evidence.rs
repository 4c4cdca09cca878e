//! Scale of tolerances and standard deviation of measurements that maximise the probability of the
//! measurements.

use crate::model::prior::{Nominal, Prior};
use crate::model::residuals::Residuals;
use etalon_math::{Problem, Solution, linearised_at};
use nalgebra::{Cholesky, DMatrix, DVector};

/// Candidate scales: 1, 1/√2, 1/2 ... 1/64.
const STEPS: i32 = 13;
/// Candidate standard deviations: of the residuals, 1/2 of it ... 1/4096.
const HALVES: i32 = 13;
/// Rise of −2 ln L within one standard deviation of the most probable scale: chi-square of one
/// parameter.
const AS_PROBABLE: f64 = 1.0;

/// Values that maximise the probability of the measurements.
pub(crate) struct MostProbable {
    /// Scale of the default tolerances, at most 1: the largest one compatible with the most
    /// probable scale, so that nominal values do not outweigh few poses.
    pub scale: f64,
    /// Standard deviation of a residual, at most the one of all residuals.
    pub noise: f64,
}

/// A problem linearised at a solution: columns are divided by their norms.
struct Linearised {
    /// Triangular factor of the common columns, its right-hand side, and the sum of squares that no
    /// step changes.
    r: DMatrix<f64>,
    right: DVector<f64>,
    rest: f64,
    /// JᵀJ and Jᵀr.
    normal: DMatrix<f64>,
    gradient: DVector<f64>,
    residuals: f64,
    /// 1/s of each nominal value, and the distance of the solution from it.
    derivatives: DVector<f64>,
    off: DVector<f64>,
    scales: Vec<bool>,
}

impl Linearised {
    /// Evidence of residuals without nominal values at a solution with them; `start` are expected
    /// values of unknowns without tolerance.
    fn new(data: &Residuals, solution: &Solution, start: &[f64]) -> Self {
        let x = &solution.x;
        let rows = Nominal::rows(data.robot, Prior::TOLERANCES, &data.free, start);
        let (factor, norms) = match &solution.measured {
            Some(factor) if data.prior_count() == 0 => (factor.clone(), solution.scale.clone()),
            _ => {
                let mut residuals = vec![0.0; data.residual_count()];
                data.residuals(x, &mut residuals);
                linearised_at(data, x, &residuals)
            }
        };
        let common = factor.common();
        let n = common.len();
        let r = DMatrix::from_fn(n, n, |i, k| if i <= k { factor.r(i, k) } else { 0.0 });
        let right = DVector::from_column_slice(&factor.qtb[factor.columns() - n..]);
        Self {
            rest: factor.rest,
            normal: r.tr_mul(&r),
            gradient: r.tr_mul(&right),
            residuals: data.residual_count() as f64,
            derivatives: DVector::from_fn(n, |k, _| rows[common[k]].derivative() / norms[common[k]]),
            off: DVector::from_fn(n, |k, _| (x[common[k]] - rows[common[k]].value) * norms[common[k]]),
            scales: common.iter().map(|&j| data.robot.parameters()[data.free[j]].scales()).collect(),
            r,
            right,
        }
    }

    /// −2 ln of the marginal likelihood of a scale of tolerances and a standard deviation of a
    /// residual (MacKay 1992, Bayesian interpolation, eq. 2.7), without a constant.
    fn improbability(&self, scale: f64, noise: f64) -> Option<f64> {
        let by = |k: usize| noise * self.derivatives[k] / if self.scales[k] { scale } else { 1.0 };
        let d = DVector::from_fn(self.scales.len(), |k, _| by(k).powi(2));
        let root = Cholesky::new(&self.normal + DMatrix::from_diagonal(&d))?;
        let step = -root.solve(&(&self.gradient + d.component_mul(&self.off)));
        let left = (&self.r * &step + &self.right).norm_squared() + self.rest;
        let moved = &step + &self.off;
        let cost = left + (0..d.len()).map(|k| d[k] * moved[k] * moved[k]).sum::<f64>();
        let determinant = 2.0 * root.l_dirty().diagonal().iter().map(|v| v.ln()).sum::<f64>();
        let own: f64 = d.iter().map(|d| d.ln()).sum();
        let improbability = cost / noise.powi(2) + 2.0 * self.residuals * noise.ln() + determinant - own;
        Some(improbability).filter(|v| v.is_finite())
    }
}

/// Values that maximise the probability of the measurements. `data` are the residuals without
/// nominal values at the `solution`, `start` the expected values of unknowns without tolerance,
/// `shown` the standard deviation of the residuals. If nominal values determine much, smaller
/// standard deviations down to `least` are tried, because nominal values may keep the residuals
/// large.
pub(crate) fn most_probable(
    data: &Residuals,
    start: &[f64],
    solution: &Solution,
    [least, shown]: [f64; 2],
    by_nominal: bool,
) -> MostProbable {
    let problem = Linearised::new(data, solution, start);
    let steps = if problem.scales.contains(&true) { STEPS } else { 1 };
    let scales = |noise: f64| -> Vec<(f64, f64)> {
        let tried = (0..steps).map(|k| 0.5f64.powf(0.5 * f64::from(k)));
        tried.filter_map(|scale| Some((scale, problem.improbability(scale, noise)?))).collect()
    };
    let best = |judged: &[(f64, f64)]| judged.iter().map(|scale| scale.1).fold(f64::INFINITY, f64::min);
    let halves = if by_nominal { HALVES } else { 1 };
    let noises = (0..halves).map(|k| (shown * 0.5f64.powi(k)).max(least));
    let tried = noises.map(|noise| (noise, scales(noise))).map(|(noise, judged)| (noise, best(&judged), judged));
    let Some((noise, least, judged)) = tried.reduce(|a, b| if b.1 < a.1 { b } else { a }) else {
        return MostProbable { scale: 1.0, noise: shown };
    };
    let scale = judged.iter().find(|scale| scale.1 <= least + AS_PROBABLE).map_or(1.0, |scale| scale.0);
    MostProbable { scale, noise }
}
