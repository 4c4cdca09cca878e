//! The distance s: two positions of the shaft, their axes intersected (thesis 2.6.3).

use super::base::Base;
use super::uncertain::{Flat, Readings, Scatter, Uncertain, shifts, values};
use crate::base::message::{Message, Result};
use crate::base::pose::{Vector, cross, dot, minus, norm, unit};
use crate::math::fit;

/// The shaft probed all round, before and after actuator 2 alone has moved.
#[derive(Clone, Debug, Default)]
pub struct ShaftMeasurements {
    /// Points on the shaft in the two positions, in mm.
    pub positions: [Vec<Vector>; 2],
}

/// The axis of a shaft.
#[derive(Clone, Debug)]
pub struct Shaft {
    /// Two points of its axis, projected into the base frame.
    pub axis: [Flat; 2],
    /// Radius.
    pub radius: Uncertain,
    /// Distances of the points from the cylinder.
    pub scatter: Scatter,
}

/// Directions of two axes closer than this do not intersect anywhere: 0.1 degrees.
const PARALLEL: f64 = 1.7e-3;

impl Shaft {
    /// The cylinder through points that were probed on the shaft.
    pub fn through(readings: &mut Readings, base: &Base, probed: &[Vector]) -> Result<Self> {
        let points = readings.add(probed);
        let fitted = fit::cylinder(probed, &fit::Settings::default())?;
        let foot = fitted.point_mm;
        let d = fitted.direction.unwrap_or([1.0, 0.0, 0.0]);
        let side = if d[2].abs() < 0.9 { [0.0, 0.0, 1.0] } else { [1.0, 0.0, 0.0] };
        let e1 = unit(cross(side, d)).unwrap_or([1.0, 0.0, 0.0]);
        let e2 = cross(d, e1);
        // distances about the axis (foot + a e1 + b e2, d + u e1 + v e2) at zero, and how they move with the points
        let (mut rows, mut moves, mut residuals, mut reach) = (Vec::new(), Vec::new(), Vec::new(), 0.0f64);
        let radius = fitted.radius_mm.unwrap_or_default();
        for (p, q) in values(&points).into_iter().zip(&points) {
            let w = minus(p, foot);
            let t = dot(w, d);
            let across = minus(w, d.map(|d| t * d));
            let g = unit(across).unwrap_or_default();
            let (g1, g2) = (dot(g, e1), dot(g, e2));
            rows.push([-g1, -g2, -t * g1, -t * g2, -1.0]);
            moves.push(Uncertain::linear(0.0, g.into_iter().zip(q)));
            residuals.push(norm(across) - radius);
            reach = reach.max(norm(w));
        }
        let [a, b, u, v, r] = shifts(&rows, &moves)?;
        let scatter = readings.judge(&residuals, &moves, 5, &points);
        let at = |t: f64| {
            let point = [0, 1, 2].map(|k| {
                Uncertain::linear(foot[k] + t * d[k], [(e1[k], &a), (e2[k], &b), (t * e1[k], &u), (t * e2[k], &v)])
            });
            base.locate(&point)
        };
        Ok(Self { axis: [at(-reach), at(reach)], radius: r.at(radius), scatter })
    }
}

/// Where the axes of two shafts intersect, in the base frame: on the axis of revolute joint 3.
pub fn intersection(first: &Shaft, second: &Shaft) -> Result<Flat> {
    let ([a, b], [c, d]) = (&first.axis, &second.axis);
    let direction = |from: &Flat, to: &Flat| (to[1].value - from[1].value).atan2(to[0].value - from[0].value);
    let between = (direction(a, b) - direction(c, d)).sin().abs();
    if between.is_nan() || between < PARALLEL {
        return Err(Message::error("the two positions of the shaft are parallel: their axes do not intersect")
            .hint("move actuator 2 alone between them, as far as it goes")
            .into());
    }
    Ok(Uncertain::of([&a[0], &a[1], &b[0], &b[1], &c[0], &c[1], &d[0], &d[1]], |[ax, ay, bx, by, cx, cy, dx, dy]| {
        let (ux, uy, vx, vy) = (bx - ax, by - ay, dx - cx, dy - cy);
        let along = ((cx - ax) * vy - (cy - ay) * vx) / (ux * vy - uy * vx);
        [ax + along * ux, ay + along * uy]
    }))
}
