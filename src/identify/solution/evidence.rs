//! How much better a robot is made than by the usual tolerances: the scale of these that makes the measurements most probable.

use crate::model::prior::{Nominal, Prior};
use crate::model::residuals::Residuals;
use etalon_math::{Problem, linearised_at};
use nalgebra::{Cholesky, DMatrix, DVector};

/// Scales that are tried: 1, 1/√2, 1/2 ... 1/64.
const STEPS: i32 = 13;

/// The scale of tolerances that nobody stated, at most 1, at which the measurements are most probable: the largest marginal likelihood
/// of the problem linearised at `x` (MacKay 1992, Bayesian interpolation, eq. 2.7). `data` are the residuals without nominal values,
/// `start` the values at which unknowns without tolerance are expected.
pub(crate) fn most_probable_scale(data: &Residuals, x: &[f64], start: &[f64], weight: f64) -> f64 {
    let rows = Nominal::rows(data.robot, Prior::Tolerances { weight, scale: 1.0 }, &data.free, start);
    let mut residuals = vec![0.0; data.residual_count()];
    data.residuals(x, &mut residuals);
    let (factor, norms) = linearised_at(data, x, &residuals);
    let common = factor.common();
    let n = common.len();
    let scales = |k: usize| data.robot.parameters()[data.free[common[k]]].scales();
    if !(0..n).any(scales) {
        return 1.0;
    }
    let r = DMatrix::from_fn(n, n, |i, k| if i <= k { factor.r(i, k) } else { 0.0 });
    let right = DVector::from_column_slice(&factor.qtb[factor.columns() - n..]);
    let (normal, gradient) = (r.tr_mul(&r), r.tr_mul(&right));
    // in columns that are divided by their norms
    let derivatives = DVector::from_fn(n, |k, _| rows[common[k]].derivative() / norms[common[k]]);
    let off = DVector::from_fn(n, |k, _| (x[common[k]] - rows[common[k]].value) * norms[common[k]]);
    let improbability = |scale: f64| {
        let by = |k: usize| derivatives[k] / if scales(k) { scale } else { 1.0 };
        let d = DVector::from_fn(n, |k, _| by(k).powi(2));
        let root = Cholesky::new(&normal + DMatrix::from_diagonal(&d))?;
        let step = -root.solve(&(&gradient + d.component_mul(&off)));
        let left = (&r * &step + &right).norm_squared();
        let moved = &step + &off;
        let cost = left + (0..n).map(|k| d[k] * moved[k] * moved[k]).sum::<f64>();
        let determinant = 2.0 * (0..n).map(|k| root.l_dirty()[(k, k)].ln()).sum::<f64>();
        let own: f64 = (0..n).filter(|&k| scales(k)).map(|k| d[k].ln()).sum();
        Some(cost / weight.powi(2) + determinant - own).filter(|v| v.is_finite())
    };
    let tried = (0..STEPS).map(|k| 0.5f64.powf(0.5 * f64::from(k)));
    let judged = tried.filter_map(|scale| Some((scale, improbability(scale)?)));
    judged.reduce(|best, next| if next.1 < best.1 { next } else { best }).map_or(1.0, |best| best.0)
}
