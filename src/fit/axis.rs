//! What circle, cylinder, cone and torus share: an axis through a point, in a local chart.
//!
//! The axis is d0 + u e1 + v e2 with (e1, e2, d0) a right-handed frame, so u = v = 0 is the middle of the chart and
//! no direction is singular; when the solver has moved away, the chart is laid again about where it ended
//! (Shakarji 1998, J. Res. NIST 103, 633, uses the same local freedom: two for a direction, two for its place).

use super::cloud::Cloud;
use super::result::QUANTITIES;
use super::surface::{Refined, Surface, refine};
use crate::pose::{Vector, cross, dot, minus, unit};
use crate::solve::Options;

/// A right-handed frame about a direction.
#[derive(Clone, Copy)]
pub(super) struct Chart {
    /// The direction in the middle of the chart.
    pub d0: Vector,
    pub e1: Vector,
    pub e2: Vector,
}

/// Where a point lies about an axis, with derivatives by (a, b, h, u, v).
pub(super) struct Cylindrical {
    /// Distance from the axis.
    pub rho: f64,
    /// Height along the axis.
    pub t: f64,
    pub d_rho: [f64; 5],
    pub d_t: [f64; 5],
}

impl Chart {
    /// A frame about `d`, which must have a direction; z without one.
    pub fn new(d: Vector) -> Self {
        let d0 = unit(d).unwrap_or([0.0, 0.0, 1.0]);
        // the coordinate axis that lies farthest from d0
        let k = (0..3).min_by(|&i, &j| d0[i].abs().total_cmp(&d0[j].abs())).unwrap_or(0);
        let mut far = [0.0; 3];
        far[k] = 1.0;
        let e1 = unit(cross(d0, far)).unwrap_or([1.0, 0.0, 0.0]);
        Self { d0, e1, e2: cross(d0, e1) }
    }

    /// The point a e1 + b e2 + h d0.
    pub fn point(&self, a: f64, b: f64, h: f64) -> Vector {
        [0, 1, 2].map(|i| a * self.e1[i] + b * self.e2[i] + h * self.d0[i])
    }

    /// Coordinates of a point or direction along e1, e2 and d0.
    pub fn coordinates(&self, p: Vector) -> [f64; 3] {
        [dot(p, self.e1), dot(p, self.e2), dot(p, self.d0)]
    }

    /// The unit axis at (u, v), and the length that it was divided by.
    pub fn axis(&self, u: f64, v: f64) -> (Vector, f64) {
        let length = (1.0 + u * u + v * v).sqrt();
        (self.point(u, v, 1.0).map(|x| x / length), length)
    }

    /// Distance from the axis and height along it, of q, for the axis x = (a, b, h, u, v).
    pub fn cylindrical(&self, x: [f64; 5], q: Vector) -> Cylindrical {
        let [a, b, h, u, v] = x;
        let (d, length) = self.axis(u, v);
        let w = minus(q, self.point(a, b, h));
        let t = dot(w, d);
        let across = [w[0] - t * d[0], w[1] - t * d[1], w[2] - t * d[2]];
        let rho = dot(across, across).sqrt();
        // on the axis itself the distance has no derivative; zero keeps the step finite
        let g = if rho > 0.0 { across.map(|c| c / rho) } else { [0.0; 3] };
        let (g, w, d) = (self.coordinates(g), self.coordinates(w), self.coordinates(d));
        Cylindrical {
            rho,
            t,
            // d rho = -g dp - t g dd, d t = -d dp + w dd, and dd/du = (e1 - (e1 d) d) / length
            d_rho: [-g[0], -g[1], -g[2], -t * g[0] / length, -t * g[1] / length],
            d_t: [-d[0], -d[1], -d[2], (w[0] - t * d[0]) / length, (w[1] - t * d[1]) / length],
        }
    }

    /// How point and direction move with (a, b, h, u, v) in the middle of the chart.
    pub fn quantities<const N: usize>(&self) -> [[f64; QUANTITIES]; N] {
        let mut by_parameter = [[0.0; QUANTITIES]; N];
        let moves = [(self.e1, 0), (self.e2, 0), (self.d0, 0), (self.e1, 3), (self.e2, 3)];
        for (row, (direction, first)) in by_parameter.iter_mut().zip(moves) {
            row[first..first + 3].copy_from_slice(&direction);
        }
        by_parameter
    }
}

/// A surface about an axis, its first parameters (a, b, h, u, v).
pub(super) trait Axial<const N: usize, const K: usize>: Surface<N, K> + Sized {
    /// The chart that the parameters are in.
    fn chart(&self) -> &Chart;

    /// The same element in another chart; `foot` is the foot of the centroid on the axis.
    fn with_chart(&self, chart: Chart) -> Self;

    /// The other parameters after the point moved by `slid` along the axis to the foot of the centroid.
    fn slide(_x: &mut [f64; N], _slid: f64) {}

    /// Whether the point may slide along the axis, and is kept at the foot of the centroid.
    const SLIDES: bool;

    /// Starts that are looked at in the search.
    const STARTS: usize = 8;

    /// The same element in the chart about its own axis.
    fn recharted(&self, x: &[f64; N]) -> (Self, [f64; N]) {
        let old = self.chart();
        let (d, _) = old.axis(x[3], x[4]);
        let point = old.point(x[0], x[1], x[2]);
        let chart = Chart::new(d);
        let mut x = *x;
        let [a, b, h] = chart.coordinates(point);
        x[..5].copy_from_slice(&[a, b, h, 0.0, 0.0]);
        if Self::SLIDES {
            Self::slide(&mut x, -h);
            x[2] = 0.0;
        }
        (self.with_chart(chart), x)
    }
}

/// [`refine`], with the chart laid again until its middle is the answer.
pub(super) fn refine_axis<S: Axial<N, K>, const N: usize, const K: usize>(
    mut surface: S,
    cloud: &Cloud,
    mut start: [f64; N],
    free: [bool; N],
    options: Options,
) -> (S, Refined<N, K>) {
    let mut iterations = 0;
    let mut round = 0;
    loop {
        let mut refined = refine(&surface, cloud, start, free, options);
        iterations += refined.iterations;
        round += 1;
        let tilt = refined.x[3].hypot(refined.x[4]);
        if !refined.termination.is_success() || tilt < 1e-7 || round == 8 {
            refined.iterations = iterations;
            return (surface, refined);
        }
        (surface, start) = surface.recharted(&refined.x);
    }
}

/// Length of (x, y) in normalised coordinates: nothing overflows, and hypot would be slow.
pub(super) fn length(x: f64, y: f64) -> f64 {
    (x * x + y * y).sqrt()
}

/// Angles of the points about the axis through `point`, for the coverage of an arc.
pub(super) fn angles_about(points: &[Vector], chart: &Chart, point: Vector) -> Vec<f64> {
    let angle = |&q: &Vector| {
        let [x, y, _] = chart.coordinates(minus(q, point));
        y.atan2(x)
    };
    points.iter().map(angle).collect()
}
