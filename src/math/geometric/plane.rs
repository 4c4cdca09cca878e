//! The plane of the robot, into which all measurements are projected (thesis 2.6.1), and circles in it.

use super::uncertain::{Flat, Point, Readings, Scatter, Uncertain, shifts, values};
use crate::base::message::Result;
use crate::base::pose::{Vector, cross, dot, minus};
use crate::base::scalar::Scalar;
use crate::math::fit;

/// A plane through points, with axes in it that are fixed but arbitrary.
#[derive(Clone, Debug)]
pub struct Plane {
    /// Centroid of its points.
    pub point_mm: Vector,
    /// Two directions in the plane and its normal, right-handed.
    pub axes: [Vector; 3],
    /// Tilts of the normal towards the first and the second direction, in rad; their values are zero.
    tilt: [Uncertain; 2],
    /// Distances of the points from it.
    pub scatter: Scatter,
}

impl Plane {
    /// The plane of least squares through three points or more; `up` decides which way the normal points.
    pub fn through(readings: &mut Readings, points: &[Point], up: impl Fn(Vector) -> bool) -> Result<Self> {
        let p = values(points);
        let fitted = fit::plane(&p, &fit::Settings::default())?;
        let found = fitted.direction.unwrap_or([0.0, 0.0, 1.0]);
        let normal = if up(found) { found } else { found.map(|v| -v) };
        let side = if normal[0].abs() < 0.9 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
        let e2 = crate::base::pose::unit(cross(normal, side)).unwrap_or([0.0, 1.0, 0.0]);
        let e1 = cross(e2, normal);
        let offsets: Vec<Vector> = p.iter().map(|&p| minus(p, fitted.point_mm)).collect();
        let rows: Vec<[f64; 3]> = offsets.iter().map(|&w| [-1.0, dot(w, e1), dot(w, e2)]).collect();
        let moves: Vec<Uncertain> = points.iter().map(|p| Uncertain::linear(0.0, normal.into_iter().zip(p))).collect();
        let distances: Vec<f64> = offsets.iter().map(|&w| dot(w, normal)).collect();
        let [_, t1, t2] = shifts(&rows, &moves)?;
        let scatter = readings.judge(&distances, &moves, 3, points);
        Ok(Self { point_mm: fitted.point_mm, axes: [e1, e2, normal], tilt: [t1, t2], scatter })
    }

    /// A point projected into the plane, along its two directions from the centroid (mm).
    pub fn project(&self, p: &Point) -> Flat {
        let [e1, e2, e3] = self.axes;
        let c = self.point_mm;
        Uncertain::of([&p[0], &p[1], &p[2], &self.tilt[0], &self.tilt[1]], |[x, y, z, t1, t2]| {
            let w = [x + (-c[0]), y + (-c[1]), z + (-c[2])];
            let along = |e: Vector| w[0] * e[0] + w[1] * e[1] + w[2] * e[2];
            let (a, b, h) = (along(e1), along(e2), along(e3));
            // turned so that its third axis is the tilted normal
            let (s1, c1) = t1.sin_cos();
            let (s2, c2) = t2.sin_cos();
            let (a, h) = (a * c1 + h * (-s1), a * s1 + h * c1);
            [a, b * c2 + h * (-s2)]
        })
    }
}

/// A circular arc and its centre.
#[derive(Clone, Debug)]
pub struct Circle {
    /// Centre.
    pub centre: Flat,
    /// Radius.
    pub radius: Uncertain,
    /// How much of the turn has points.
    pub coverage_deg: f64,
    /// Radial residuals (thesis 2.6.1 gives their largest and their norm).
    pub scatter: Scatter,
}

impl Circle {
    /// The circle of least squares through `flat`, which come from `points`.
    pub fn through(readings: &mut Readings, flat: &[Flat], points: &[Point]) -> Result<Self> {
        let p = values(flat);
        let fitted = fit::circle2d(&p, &fit::Settings::default())?;
        let [x, y, _] = fitted.point_mm;
        let radial = |p: &[f64; 2]| {
            let (dx, dy) = (p[0] - x, p[1] - y);
            let length = dx.hypot(dy);
            [dx / length, dy / length]
        };
        let rows: Vec<[f64; 3]> = p.iter().map(radial).map(|[gx, gy]| [-gx, -gy, -1.0]).collect();
        let moves: Vec<Uncertain> =
            flat.iter().zip(&p).map(|(f, p)| Uncertain::linear(0.0, radial(p).into_iter().zip(f))).collect();
        let [dx, dy, dr] = shifts(&rows, &moves)?;
        let radius = fitted.radius_mm.unwrap_or_default();
        let residuals: Vec<f64> = p.iter().map(|p| (p[0] - x).hypot(p[1] - y) - radius).collect();
        let scatter = readings.judge(&residuals, &moves, 3, points);
        Ok(Self {
            centre: [dx.at(x), dy.at(y)],
            radius: dr.at(radius),
            coverage_deg: fitted.coverage_deg().unwrap_or_default(),
            scatter,
        })
    }
}
