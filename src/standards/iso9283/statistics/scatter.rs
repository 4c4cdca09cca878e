//! Scatter of attained positions along its principal axes, the basis of intervals.

use crate::iso9283::statistics::sample::covariance;
use etalon_base::pose::{Vector, dot, norm};
use etalon_math::symmetric_eigen;

/// Principal variances and axes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scatter {
    /// Observed variances (mm²), ascending.
    pub found: Vector,
    /// Shrunk variances, as the variances of a sample differ more than the true ones.
    pub drawn_together: Vector,
    /// Unit axes, one per row.
    pub axes: [Vector; 3],
}

impl Scatter {
    /// Evaluates at least three positions.
    pub fn new(attained_mm: &[Vector]) -> Self {
        let (variances, axes) = symmetric_eigen(covariance(attained_mm));
        let found = variances.map(|v| v.max(0.0));
        Self { found, drawn_together: drawn_together(found, attained_mm.len() as f64 - 1.0), axes }
    }

    /// Components of a vector along the axes.
    pub fn along(&self, d: Vector) -> Vector {
        self.axes.map(|axis| dot(axis, d))
    }

    /// Plausible barycentre, along the axes, that is nearest to `mean` among those at equal
    /// distance from the commanded position: towards that position for `w` > 0, away from it for
    /// `w` < 0 (Lagrange's condition; distances in units of the scatter).
    pub fn plausible(&self, mean: Vector, w: f64) -> Vector {
        let largest = self.found[2].max(f64::MIN_POSITIVE);
        [0, 1, 2].map(|k| mean[k] / (1.0 + w.exp_m1() * self.found[k] / largest))
    }
}

/// Maximum useful |w|, beyond which [`Scatter::plausible`] is constant.
pub(crate) const FARTHEST: f64 = 40.0;

/// Effective number of directions with equal scatter: (Σv)² / Σv².
pub(crate) fn dimensions(variances: Vector) -> f64 {
    let trace: f64 = variances.iter().sum();
    trace.powi(2) / variances.iter().map(|v| v * v).sum::<f64>()
}

/// Shrinks variances towards their mean so that Σv and Σv² are unbiased (moments of the Wishart
/// distribution).
pub(crate) fn drawn_together(found: Vector, degrees: f64) -> Vector {
    let largest = found[2];
    let is_there = |v: f64| v > 1e-12 * largest;
    let count = found.iter().filter(|&&v| is_there(v)).count() as f64;
    if count < 2.0 {
        return found;
    }
    let trace: f64 = found.iter().sum();
    let squares = norm(found).powi(2);
    let unbiased = degrees.powi(2) / ((degrees - 1.0) * (degrees + 2.0)) * (squares - trace.powi(2) / degrees);
    let mean = trace / count;
    let apart = |squares: f64, trace_squared: f64| (squares / trace_squared - 1.0 / count).max(0.0);
    let share = (apart(unbiased, trace.powi(2) - 2.0 * unbiased / degrees) / apart(squares, trace.powi(2))).sqrt();
    // equal variances give 0/0
    let share = if share.is_finite() { share.min(1.0) } else { 0.0 };
    found.map(|v| if is_there(v) { mean + share * (v - mean) } else { v })
}
