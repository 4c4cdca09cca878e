//! A circle through points in the plane, with the uncertainty of its centre.

use super::readings::{Flat, Point, Readings, Scatter, shifts, values};
use super::uncertain::Uncertain;
use crate::base::message::Result;
use crate::math::fit;

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
        let fitted = fit::circle2d(&p)?;
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
