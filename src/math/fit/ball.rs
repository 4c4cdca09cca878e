//! Circle in the plane and sphere: the distance of a point from a centre, less the radius.

use super::axis::Chart;
use super::cloud::Cloud;
use super::f64x8::{F64x8, Points, less, square};
use super::result::QUANTITIES;
use super::stream::Gather;
use super::surface::Surface;
use crate::base::pose::Vector;
use crate::math::solve::symmetric_eigen;

/// Sphere: parameters x, y, z of the centre and the radius.
#[derive(Clone, Copy)]
pub(super) struct Ball;

impl Surface<4, 1> for Ball {
    #[inline(always)]
    fn distances(&self, x: &[f64; 4], q: Points) -> [(F64x8, [F64x8; 4]); 1] {
        let w = less(q, [x[0], x[1], x[2]]);
        let (rho, inverse) = square(w).roots(x[3]);
        let [gx, gy, gz] = [w[0] * inverse, w[1] * inverse, w[2] * inverse];
        [(rho - x[3], [-gx, -gy, -gz, F64x8::all(-1.0)])]
    }

    fn recharted(&self, x: &[f64; 4]) -> (Self, [f64; 4]) {
        (*self, *x)
    }

    fn quantities(&self, _x: &[f64; 4]) -> [[f64; QUANTITIES]; 4] {
        one_to_one([0, 1, 2, 6])
    }
}

/// Circle in the plane of `chart`, that is of points seen along its axis: parameters a, b of the centre and the radius.
#[derive(Clone, Copy)]
pub(super) struct Disc {
    pub chart: Chart,
}

impl Surface<3, 1> for Disc {
    #[inline(always)]
    fn distances(&self, x: &[f64; 3], q: Points) -> [(F64x8, [F64x8; 3]); 1] {
        let [u, v, _] = self.chart.seen(q, [x[0], x[1], 0.0]);
        let (rho, inverse) = (u * u).plus(v, v).roots(x[2]);
        [(rho - x[2], [-(u * inverse), -(v * inverse), F64x8::all(-1.0)])]
    }

    fn recharted(&self, x: &[f64; 3]) -> (Self, [f64; 3]) {
        (*self, *x)
    }

    fn quantities(&self, _x: &[f64; 3]) -> [[f64; QUANTITIES]; 3] {
        one_to_one([0, 1, 6])
    }
}

fn one_to_one<const N: usize>(quantities: [usize; N]) -> [[f64; QUANTITIES]; N] {
    quantities.map(|quantity| {
        let mut row = [0.0; QUANTITIES];
        row[quantity] = 1.0;
        row
    })
}

/// Taubin's algebraic circle (`M` = 3) or sphere (`M` = 4): centre and radius.
///
/// Taubin 1991, IEEE Trans. PAMI 13, 1115, in the form of Chernov 2010, "Circular and linear regression", 5.9-5.10:
/// the smallest eigenvector of the moments of ((z - z̄)/(2√z̄), x, y), z = x² + y². Unlike Kasa's it is hardly biased on
/// short arcs.
pub(super) fn taubin<const M: usize>(points: &[Vector]) -> (Vector, f64) {
    let count = points.len().max(1) as f64;
    let (sum, _) = Cloud::about([0.0; 3], points).gather(Sums::<M>::default());
    let centre = sum.map(|s| s / count);
    let centred = Cloud::about(centre, points);
    let mean = centred.gather(Sums::<M>::default()).1 / count;
    if mean <= 0.0 || mean.is_nan() {
        return (centre, 0.0);
    }
    let moments = centred.gather(Moments::<M> { mean, sums: [[F64x8::default(); M]; M] });
    let (_, vectors) = symmetric_eigen(moments);
    let v = vectors[0];
    let normal = v[1..].iter().map(|x| x * x).sum::<f64>().sqrt();
    // a straight row of points has curvature zero: begin with a radius of 1e6 sizes
    let least = 1e-6 * normal.max(1e-6);
    let curvature = v[0] / (2.0 * mean.sqrt());
    let curvature = if curvature.abs() < least { least.copysign(curvature) } else { curvature };
    let mut middle = centre;
    for (c, x) in middle.iter_mut().zip(&v[1..]) {
        *c -= x / (2.0 * curvature);
    }
    let radius = (normal * normal + 4.0 * mean * curvature * curvature).sqrt() / (2.0 * curvature.abs());
    (middle, radius)
}

/// Sums of the first `M` - 1 coordinates and of the squares of distances in them.
#[derive(Clone, Default)]
struct Sums<const M: usize> {
    coordinates: Points,
    squares: F64x8,
}

impl<const M: usize> Gather for Sums<M> {
    type Sum = (Vector, f64);

    #[inline(always)]
    fn take(&mut self, q: Points, w: F64x8) {
        for (sum, q) in self.coordinates.iter_mut().zip(q).take(M - 1) {
            *sum = sum.plus(w, q);
            self.squares = self.squares.plus(w * q, q);
        }
    }

    fn close(self) -> Self::Sum {
        (self.coordinates.map(F64x8::sum), self.squares.sum())
    }

    fn join(a: Self::Sum, b: Self::Sum) -> Self::Sum {
        ([0, 1, 2].map(|k| a.0[k] + b.0[k]), a.1 + b.1)
    }
}

/// Products of ((z - z̄)/(2√z̄), x, y, ...).
#[derive(Clone)]
struct Moments<const M: usize> {
    mean: f64,
    sums: [[F64x8; M]; M],
}

impl<const M: usize> Gather for Moments<M> {
    type Sum = [[f64; M]; M];

    #[inline(always)]
    fn take(&mut self, q: Points, w: F64x8) {
        let mut row = [F64x8::default(); M];
        row[1..].copy_from_slice(&q[..M - 1]);
        let z = row[1..].iter().fold(F64x8::default(), |sum, x| sum.plus(*x, *x));
        row[0] = (z - self.mean) * (0.5 / self.mean.sqrt());
        for (line, x) in self.sums.iter_mut().zip(row) {
            for (sum, y) in line.iter_mut().zip(row) {
                *sum = sum.plus(w * x, y);
            }
        }
    }

    fn close(self) -> Self::Sum {
        self.sums.map(|line| line.map(F64x8::sum))
    }

    fn join(mut a: Self::Sum, b: Self::Sum) -> Self::Sum {
        for (a, b) in a.iter_mut().flatten().zip(b.iter().flatten()) {
            *a += b;
        }
        a
    }
}
