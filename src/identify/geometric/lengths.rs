//! Lengths: the lead error of an actuator, travel of a ball on its carriage against the commanded
//! displacement (thesis 2.5), the instrument's error on a scale bar (thesis 2.6), the distance s
//! from the axis of a shaft in two positions (thesis 2.6.3), and the offsets d1 and d3 from one
//! displacement of actuator 1 (thesis 2.6.4).

use super::frames::Base;
use super::uncertain::{Flat, Readings, Scatter, Uncertain, mean_and_sd, shifts, values};
use etalon_base::error;
use etalon_base::message::Result;
use etalon_base::pose::{Vector, centroid, cross, dot, minus, norm, unit};
use etalon_math::statistics::mean;

/// A ball on a carriage.
#[derive(Clone, Debug, Default)]
pub struct LeadMeasurements {
    /// Commanded displacement of each reading, in mm.
    pub commanded_mm: Vec<f64>,
    /// Position of the ball (mm).
    pub points: Vec<Vector>,
}

/// Actual over commanded displacement of one actuator.
#[derive(Clone, Debug)]
pub struct Lead {
    /// The coefficient δ of eq. 3.7.
    pub ratio: Uncertain,
    /// Each commanded displacement, and the mean deviation there from linear travel along the
    /// ball's own line, in mm.
    pub linearity: Vec<(f64, f64)>,
    /// Deviations along the line.
    pub scatter: Scatter,
}

impl Lead {
    /// The regression p = a + ρ g of the position of the ball on the commanded displacement ρ: δ is
    /// the length of g.
    pub fn determine(readings: &mut Readings, measured: &LeadMeasurements) -> Result<Self> {
        let points = readings.add(&measured.points);
        let (p, rho) = (values(&points), &measured.commanded_mm);
        let n = p.len().min(rho.len());
        let mean_rho = rho.iter().sum::<f64>() / n.max(1) as f64;
        let spread: f64 = rho.iter().map(|r| (r - mean_rho).powi(2)).sum();
        let centre = centroid(&p).unwrap_or_default();
        let mut g = [0.0; 3];
        for (p, r) in p.iter().zip(rho) {
            for (g, w) in g.iter_mut().zip(minus(*p, centre)) {
                *g += (r - mean_rho) * w / spread;
            }
        }
        let ratio = norm(g);
        if n < 3 || !(ratio.is_finite() && ratio > 0.0) {
            return Err(error!("lead-undetermined").into());
        }
        let along = g.map(|v| v / ratio);
        let rows: Vec<[f64; 2]> = rho.iter().map(|r| [-1.0, -(r - mean_rho)]).collect();
        let moves: Vec<Uncertain> = points.iter().map(|p| Uncertain::linear(0.0, along.into_iter().zip(p))).collect();
        let deviations: Vec<f64> =
            p.iter().zip(rho).map(|(p, r)| dot(minus(*p, centre), along) - ratio * (r - mean_rho)).collect();
        let [_, slope] = shifts(&rows, &moves)?;
        let scatter = readings.judge(&deviations, &moves, 2, &points);
        let mut positions: Vec<f64> = rho.clone();
        positions.sort_by(f64::total_cmp);
        positions.dedup();
        let mean_at = |position: f64| {
            let here: Vec<f64> = deviations.iter().zip(rho).filter(|(_, r)| **r == position).map(|(d, _)| *d).collect();
            (position, mean(here))
        };
        Ok(Self { ratio: slope.at(ratio), linearity: positions.into_iter().map(mean_at).collect(), scatter })
    }

    /// Lead error: excess of the travel per commanded millimetre.
    pub fn error(&self) -> f64 {
        self.ratio.value - 1.0
    }
}

/// Distance errors of a scale bar in one position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScaleBar {
    /// Number of distances.
    pub count: usize,
    /// Mean of measured minus nominal distance, in mm.
    pub mean_error_mm: f64,
    /// Standard deviation of the distances, in mm; zero for a single one.
    pub standard_deviation_mm: f64,
}

/// Distances of the two balls of a bar of `length_mm`, each pair measured together; `None` without
/// pairs.
pub fn scale_bar(length_mm: f64, pairs: &[[Vector; 2]]) -> Option<ScaleBar> {
    let errors: Vec<f64> = pairs.iter().map(|[a, b]| norm(minus(*b, *a)) - length_mm).collect();
    let (mean_error_mm, standard_deviation_mm) = mean_and_sd(&errors)?;
    Some(ScaleBar { count: errors.len(), mean_error_mm, standard_deviation_mm })
}

/// The shaft probed around its circumference, before and after actuator 2 alone has moved.
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
    /// Distances of the points from the cylinder.
    pub scatter: Scatter,
}

/// Minimum angle between two axes that intersect: 0.1 degrees.
const PARALLEL: f64 = 1.7e-3;

impl Shaft {
    /// The cylinder through points that were probed on the shaft.
    pub fn through(readings: &mut Readings, base: &Base, probed: &[Vector]) -> Result<Self> {
        let points = readings.add(probed);
        let fitted = etalon_fit::cylinder(probed, &etalon_fit::FitSettings::default())?;
        let foot = fitted.geometry.point_mm;
        let d = fitted.geometry.direction.unwrap_or([1.0, 0.0, 0.0]);
        let side = if d[2].abs() < 0.9 { [0.0, 0.0, 1.0] } else { [1.0, 0.0, 0.0] };
        let e1 = unit(cross(side, d)).unwrap_or([1.0, 0.0, 0.0]);
        let e2 = cross(d, e1);
        // distances about the axis (foot + a e1 + b e2, d + u e1 + v e2) at zero, and how they move
        // with the points
        let (mut rows, mut moves, mut residuals, mut reach) = (Vec::new(), Vec::new(), Vec::new(), 0.0f64);
        let radius = fitted.geometry.radius_mm.unwrap_or_default();
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
        let [a, b, u, v, _] = shifts(&rows, &moves)?;
        let scatter = readings.judge(&residuals, &moves, 5, &points);
        let at = |t: f64| {
            let point = [0, 1, 2].map(|k| {
                Uncertain::linear(foot[k] + t * d[k], [(e1[k], &a), (e2[k], &b), (t * e1[k], &u), (t * e2[k], &v)])
            });
            base.locate(&point)
        };
        Ok(Self { axis: [at(-reach), at(reach)], scatter })
    }
}

/// Intersection of the axes of two shafts in the base frame: on the axis of revolute joint 3.
pub fn intersection(first: &Shaft, second: &Shaft) -> Result<Flat> {
    let ([a, b], [c, d]) = (&first.axis, &second.axis);
    let direction = |from: &Flat, to: &Flat| (to[1].value - from[1].value).atan2(to[0].value - from[0].value);
    let between = (direction(a, b) - direction(c, d)).sin().abs();
    if between.is_nan() || between < PARALLEL {
        return Err(error!("shaft-positions-parallel").into());
    }
    Ok(Uncertain::propagate(
        [&a[0], &a[1], &b[0], &b[1], &c[0], &c[1], &d[0], &d[1]],
        |[ax, ay, bx, by, cx, cy, dx, dy]| {
            let (ux, uy, vx, vy) = (bx - ax, by - ay, dx - cx, dy - cy);
            let along = ((cx - ax) * vy - (cy - ay) * vx) / (ux * vy - uy * vx);
            [ax + along * ux, ay + along * uy]
        },
    ))
}

/// Balls K and L after homing and moving actuators 2 and 3 to mid-travel, and K after actuator 1
/// went to its end.
#[derive(Clone, Copy, Debug)]
pub struct OffsetMeasurements {
    /// Commanded displacement of actuator 2, in mm.
    pub rho2_mm: f64,
    /// Commanded displacement of actuator 3, in mm.
    pub rho3_mm: f64,
    /// Ball K with actuator 1 homed.
    pub k: Vector,
    /// Ball L with actuator 1 homed.
    pub l: Vector,
    /// Ball K with actuator 1 at its end.
    pub k_end: Vector,
}

impl OffsetMeasurements {
    /// The balls K and L, and K with actuator 1 at its end, projected into the plane of the base
    /// frame.
    pub fn project(&self, readings: &mut Readings, base: &Base) -> [Flat; 3] {
        [self.k, self.l, self.k_end].map(|p| base.plane.project(&readings.add_one(p)))
    }

    /// d3 of one homing, from the displacement of ball K from position `from` to position `to` in
    /// the base frame.
    ///
    /// Eq. 2.11 takes actuators 2 and 3 as displaced equally; what their `leads` make of the
    /// commanded displacements is taken off: d3 = s Δy/Δx − (δ3 ρ3 − δ2 ρ2).
    pub fn d3(&self, from: &Flat, to: &Flat, s: &Uncertain, leads: [&Uncertain; 2]) -> Result<Uncertain> {
        let travelled = (to[0].value - from[0].value).abs();
        if travelled.is_nan() || travelled < 1.0 {
            return Err(error!("ball-unmoved", ball = "K", actuator = 1).into());
        }
        let (rho2, rho3) = (self.rho2_mm, self.rho3_mm);
        let inputs = [s, &from[0], &from[1], &to[0], &to[1], leads[0], leads[1]];
        let [d3] = Uncertain::propagate(inputs, |[s, x0, y0, x1, y1, delta2, delta3]| {
            [s * ((y1 - y0) / (x1 - x0)) - (delta3 * rho3 - delta2 * rho2)] // eq. 2.11
        });
        Ok(d3)
    }
}
