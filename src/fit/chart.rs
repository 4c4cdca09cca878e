//! Local chart of an axis through a point, common to circle, cylinder, cone and torus.
//!
//! The axis is d0 + u e1 + v e2, where (e1, e2, d0) is a right-handed frame. The chart is centred
//! at u = v = 0, so no direction is singular. After each step the chart is centred again on the new
//! axis. Shakarji 1998, J. Res. NIST 103, 633, uses the same local degrees of freedom: two for the
//! direction, two for the position.

use super::f64x8::{F64x8, Points, along};
use super::result::QUANTITIES;
use etalon_base::pose::{Vector, cross, dot, unit};

/// Right-handed frame about a direction.
#[derive(Clone, Copy)]
pub(super) struct Chart {
    /// Direction at the centre of the chart.
    pub d0: Vector,
    pub e1: Vector,
    pub e2: Vector,
}

/// Cylindrical coordinates of points about an axis, with derivatives with respect to (a, b, h, u,
/// v) at the centre of the chart.
pub(super) struct Cylindrical {
    /// Distance from the axis.
    pub rho: F64x8,
    /// Height along the axis.
    pub t: F64x8,
    pub d_rho: [F64x8; 5],
    pub d_t: [F64x8; 5],
}

impl Chart {
    /// Creates a frame about `d`, or about z if `d` has zero length.
    pub fn new(d: Vector) -> Self {
        let d0 = unit(d).unwrap_or([0.0, 0.0, 1.0]);
        // coordinate axis that is farthest from d0
        let k = (0..3).min_by(|&i, &j| d0[i].abs().total_cmp(&d0[j].abs())).unwrap_or(0);
        let mut far = [0.0; 3];
        far[k] = 1.0;
        let e1 = unit(cross(d0, far)).unwrap_or([1.0, 0.0, 0.0]);
        Self { d0, e1, e2: cross(d0, e1) }
    }

    /// Point a e1 + b e2 + h d0.
    pub fn point(&self, a: f64, b: f64, h: f64) -> Vector {
        [0, 1, 2].map(|i| a * self.e1[i] + b * self.e2[i] + h * self.d0[i])
    }

    /// Coordinates of a point or direction along e1, e2 and d0.
    pub fn coordinates(&self, p: Vector) -> [f64; 3] {
        [dot(p, self.e1), dot(p, self.e2), dot(p, self.d0)]
    }

    /// Projection of a point along d0.
    pub fn flat(&self, p: Vector) -> Vector {
        [dot(p, self.e1), dot(p, self.e2), 0.0]
    }

    /// Coordinates of points along e1, e2 and d0, relative to (a, b, h).
    #[inline(always)]
    pub fn seen(&self, q: Points, [a, b, h]: Vector) -> Points {
        [along(q, self.e1) - a, along(q, self.e2) - b, along(q, self.d0) - h]
    }

    /// Distances of points from the axis through (a, b, h), and heights along it; most distances
    /// are close to `near`.
    #[inline(always)]
    pub fn cylindrical(&self, point: Vector, near: f64, q: Points) -> Cylindrical {
        let [x, y, t] = self.seen(q, point);
        let (rho, inverse) = (x * x).plus(y, y).roots(near);
        let (gx, gy) = (x * inverse, y * inverse);
        let (zero, less) = (F64x8::default(), F64x8::all(-1.0));
        // d rho = −g dp − t g dd, d t = −d dp + w dd, where dd = e1 du + e2 dv
        Cylindrical { rho, t, d_rho: [-gx, -gy, zero, -(t * gx), -(t * gy)], d_t: [zero, zero, less, x, y] }
    }

    /// Chart centred on the axis x = (a, b, h, u, v, ...), and x in that chart.
    pub fn moved<const N: usize>(&self, x: &[f64; N]) -> (Self, [f64; N]) {
        let mut x = *x;
        if x[3] == 0.0 && x[4] == 0.0 {
            return (*self, x);
        }
        let chart = Self::new(self.point(x[3], x[4], 1.0));
        let [a, b, h] = chart.coordinates(self.point(x[0], x[1], x[2]));
        x[..5].copy_from_slice(&[a, b, h, 0.0, 0.0]);
        (chart, x)
    }

    /// Derivatives of point and direction with respect to (a, b, h, u, v) at the centre of the
    /// chart.
    pub fn quantities<const N: usize>(&self) -> [[f64; QUANTITIES]; N] {
        let mut by_parameter = [[0.0; QUANTITIES]; N];
        let moves = [(self.e1, 0), (self.e2, 0), (self.d0, 0), (self.e1, 3), (self.e2, 3)];
        for (row, (direction, first)) in by_parameter.iter_mut().zip(moves) {
            row[first..first + 3].copy_from_slice(&direction);
        }
        by_parameter
    }
}

/// Length of (x, y) in normalised coordinates, which cannot overflow; `hypot` would be slow.
pub(super) fn length(x: f64, y: f64) -> f64 {
    (x * x + y * y).sqrt()
}
