//! Minimum zones of sphere, cylinder and cone: the smallest distance between two concentric or
//! coaxial elements that enclose all points (ISO 1101:2017, 17; cylindricity ISO 12180-1).
//!
//! For sphere and cylinder the width is the difference of two radii; for a cone it is the distance
//! between two coaxial cones of equal, free angle. Each iteration solves the problem linearised in
//! the parameters ([`best_step`]) and takes the step as far as the zone narrows, until no step
//! narrows it. Then the number of contact points is two more than the number of parameters, and
//! their multipliers prove the zone to be locally narrowest. A zone of a sphere is also proved to
//! be globally narrowest by the inequality used for circles. R² − r² is a linear problem in the
//! centre, which grows by at least κ per unit length, and R + r by at most 2; if κ ≥ 2 (R − r), no
//! other centre has a narrower zone.

use crate::chart::{Chart, length};
use crate::circle_and_sphere::taubin;
use crate::cloud::{Cloud, SAMPLE, Source};
use crate::cone::cone;
use crate::cylinder::cylinder;
use crate::element::{Element, FitSettings};
use crate::minimax::{Certificate, Row, best_step, certificate};
use crate::result::largest_component_positive;
use crate::zone::{FARTHEST, MinimumZone, Multipliers, SLACK, sides};
use etalon_base::error;
use etalon_base::message::{Problems, Result};
use etalon_base::pose::{Vector, minus, norm};

/// Element with distances that depend on `N` parameters. A constant common to all distances (the
/// radius) is no parameter.
trait Round<const N: usize>: Sized {
    /// Distance of a point, and its gradient with respect to the parameters.
    fn row(&self, q: Vector) -> Row<N>;

    /// The element after a step of its parameters; `None` if it is out of range.
    fn moved(&self, step: [f64; N]) -> Option<Self>;

    fn rows(&self, points: &[Vector]) -> Vec<Row<N>> {
        points.iter().map(|&q| self.row(q)).collect()
    }
}

/// Centre of a sphere.
#[derive(Clone, Copy)]
struct Centre(Vector);

impl Round<3> for Centre {
    fn row(&self, q: Vector) -> Row<3> {
        let w = minus(q, self.0);
        let d = norm(w);
        (w.map(|x| if d > 0.0 { -x / d } else { 0.0 }), d)
    }

    fn moved(&self, step: [f64; 3]) -> Option<Self> {
        let centre = [0, 1, 2].map(|k| self.0[k] + step[k]);
        (norm(centre) < FARTHEST).then_some(Self(centre))
    }
}

/// Axis of a cylinder through (a, b, 0) of the chart, along d0; parameters a, b, u, v.
#[derive(Clone, Copy)]
struct Axis {
    chart: Chart,
    a: f64,
    b: f64,
}

impl Axis {
    fn through(point: Vector, direction: Vector) -> Self {
        let chart = Chart::new(direction);
        let [a, b, _] = chart.coordinates(point);
        Self { chart, a, b }
    }

    /// Distance of a point from the axis and height along it, with gradients with respect to a, b,
    /// u, v.
    fn cylindrical(&self, q: Vector) -> ([f64; 4], f64, [f64; 4], f64) {
        let [x, y, t] = self.chart.coordinates(q);
        let (x, y) = (x - self.a, y - self.b);
        let rho = length(x, y);
        let (gx, gy) = if rho > 0.0 { (x / rho, y / rho) } else { (0.0, 0.0) };
        ([-gx, -gy, -(t * gx), -(t * gy)], rho, [0.0, 0.0, x, y], t)
    }
}

impl Round<4> for Axis {
    fn row(&self, q: Vector) -> Row<4> {
        let (gradient, rho, _, _) = self.cylindrical(q);
        (gradient, rho)
    }

    fn moved(&self, [a, b, u, v]: [f64; 4]) -> Option<Self> {
        let (chart, [a, b, ..]) = self.chart.moved(&[self.a + a, self.b + b, 0.0, u, v]);
        (a.hypot(b) < FARTHEST).then_some(Self { chart, a, b })
    }
}

/// Axis of a cone and its half-angle ψ; the distance of a point is ρ cos ψ − t sin ψ, minus a
/// constant.
#[derive(Clone, Copy)]
struct Funnel {
    axis: Axis,
    half_angle: f64,
}

impl Round<5> for Funnel {
    fn row(&self, q: Vector) -> Row<5> {
        let (by_rho, rho, by_t, t) = self.axis.cylindrical(q);
        let (sin, cos) = self.half_angle.sin_cos();
        let [a, b, u, v] = [0, 1, 2, 3].map(|k| by_rho[k] * cos - by_t[k] * sin);
        ([a, b, u, v, -(rho * sin + t * cos)], rho * cos - t * sin)
    }

    fn moved(&self, [a, b, u, v, turn]: [f64; 5]) -> Option<Self> {
        let half_angle = self.half_angle + turn;
        let axis = self.axis.moved([a, b, u, v])?;
        (half_angle.abs() < std::f64::consts::FRAC_PI_2).then_some(Self { axis, half_angle })
    }
}

/// Maximum number of steps; about ten suffice in practice.
const STEPS: usize = 300;
/// Maximum initial step, relative to the size of the points.
const REACH: f64 = 0.25;

fn spread<const N: usize>(rows: &[Row<N>]) -> f64 {
    let (low, high) = rows.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), r| (l.min(r.1), h.max(r.1)));
    high - low
}

/// Solves successive linear problems until no step narrows the zone; the reach shrinks when the
/// zone does not. Also returns the number of steps.
fn narrowest<const N: usize, R: Round<N>>(points: &[Vector], start: R) -> (R, usize) {
    let (mut here, mut reach) = (start, REACH);
    let mut rows = here.rows(points);
    for step in 0..STEPS {
        let width = spread(&rows);
        let Some(best) = best_step(&rows, reach) else { return (here, step) };
        let next = here.moved(best.step).map(|next| (next.rows(points), next));
        let largest = best.step.iter().fold(0.0f64, |m, s| m.max(s.abs()));
        match next.filter(|(rows, _)| spread(rows) < width) {
            Some((narrower, next)) => {
                // the zone narrowed by half of the linear prediction or less, which does not hold
                // as far as this
                let kept = width - spread(&narrower) > 0.5 * (width - best.spread);
                reach = if kept { (2.0 * reach).min(1.0) } else { 0.5 * largest };
                (rows, here) = (narrower, next);
            }
            None if largest < 1e-15 || reach < 1e-16 => return (here, step),
            None => reach = 0.25 * largest,
        }
    }
    (here, STEPS)
}

/// Zone about the final element without its position, with multipliers if they prove the zone.
fn held<const N: usize, R: Round<N>>(
    element: Element,
    cloud: &Cloud,
    found: &R,
    points: &[Vector],
) -> (MinimumZone, f64) {
    let rows = found.rows(points);
    let distances: Vec<f64> = rows.iter().map(|row| row.1).collect();
    let (mut zone, middle) = MinimumZone::between(element, &distances, cloud.scale_mm);
    let gradients = |side: &[usize]| side.iter().map(|&i| rows[i].0).collect::<Vec<_>>();
    let proof = certificate(&gradients(&zone.upper), &gradients(&zone.lower));
    zone.multipliers = proof.map(|Certificate { upper, lower, .. }| Multipliers { upper, lower });
    // no zone is narrower than one of zero width
    zone.verified = zone.form_mm <= SLACK * cloud.scale_mm;
    (zone, middle)
}

pub(crate) fn too_flat(element: Element) -> Problems {
    error!("zone-flat", element).into()
}

/// Minimum zone of a sphere from at least four non-coplanar points.
///
/// At least five points are in contact. Fails if the centre is at infinity.
pub(crate) fn sphere(points: &[Vector]) -> Result<MinimumZone> {
    let cloud = Cloud::new(Element::Sphere, Source::Space(points.into()), &FitSettings::default())?;
    let normalised: Vec<Vector> = cloud.points().collect();
    let (start, _) = taubin::<4>(&cloud.thinned(SAMPLE).points().collect::<Vec<_>>());
    let start = if norm(start) < FARTHEST { start } else { [0.0; 3] };
    let (found, iterations) = narrowest(&normalised, Centre(start));
    let (mut zone, middle) = held(Element::Sphere, &cloud, &found, &normalised);
    if norm(found.0) > 0.5 * FARTHEST {
        return Err(too_flat(Element::Sphere));
    }
    let width = zone.form_mm / cloud.scale_mm;
    zone.verified |= least_area_growth(&normalised, &found.0) >= 2.0 * width;
    zone.geometry.point_mm = cloud.to_mm(found.0);
    zone.geometry.radius_mm = Some(middle * cloud.scale_mm);
    zone.iterations = iterations;
    Ok(zone)
}

/// Smallest growth of R² − r² per unit distance from a centre; zero if unknown.
fn least_area_growth(points: &[Vector], centre: &Vector) -> f64 {
    let from: Vec<Vector> = points.iter().map(|&q| minus(q, *centre)).collect();
    let (_, _, lower, upper) = sides(&from.iter().map(|&w| norm(w)).collect::<Vec<_>>());
    let gradients = |side: &[usize]| side.iter().map(|&i| from[i].map(|x| -2.0 * x)).collect::<Vec<_>>();
    certificate(&gradients(&upper), &gradients(&lower)).map_or(0.0, |proof| proof.growth)
}

/// Minimum zone of a cylinder from at least five non-coplanar points, starting at the least-squares
/// cylinder.
///
/// At least six points are in contact. The zone is proved to be locally narrowest.
pub(crate) fn cylinder_zone(points: &[Vector]) -> Result<MinimumZone> {
    let fit = cylinder(points, &FitSettings::default())?;
    let cloud = Cloud::new(Element::Cylinder, Source::Space(points.into()), &FitSettings::default())?;
    let normalised: Vec<Vector> = cloud.points().collect();
    let start = Axis::through(from_mm(&cloud, fit.geometry.point_mm), fit.geometry.direction.unwrap_or(cloud.axes[0]));
    let (found, iterations) = narrowest(&normalised, start);
    let (mut zone, middle) = held(Element::Cylinder, &cloud, &found, &normalised);
    if found.a.hypot(found.b) > 0.5 * FARTHEST {
        return Err(too_flat(Element::Cylinder));
    }
    zone.geometry.point_mm = cloud.to_mm(found.chart.point(found.a, found.b, 0.0));
    zone.geometry.direction = Some(largest_component_positive(found.chart.d0));
    zone.geometry.radius_mm = Some(middle * cloud.scale_mm);
    zone.iterations = iterations;
    Ok(zone)
}

/// Minimum zone of a cone with free angle from at least six non-coplanar points, starting at the
/// least-squares cone.
///
/// At least seven points are in contact. The zone is proved to be locally narrowest.
pub(crate) fn cone_zone(points: &[Vector]) -> Result<MinimumZone> {
    let fit = cone(points, &FitSettings::default())?;
    let cloud = Cloud::new(Element::Cone, Source::Space(points.into()), &FitSettings::default())?;
    let normalised: Vec<Vector> = cloud.points().collect();
    let axis = Axis::through(from_mm(&cloud, fit.geometry.point_mm), fit.geometry.direction.unwrap_or(cloud.axes[0]));
    let start = Funnel { axis, half_angle: 0.5 * fit.geometry.apex_angle_rad.unwrap_or(0.0) };
    let (found, iterations) = narrowest(&normalised, start);
    let (mut zone, middle) = held(Element::Cone, &cloud, &found, &normalised);
    let Funnel { axis, half_angle } = found;
    if axis.a.hypot(axis.b) > 0.5 * FARTHEST {
        return Err(too_flat(Element::Cone));
    }
    zone.geometry.point_mm = cloud.to_mm(axis.chart.point(axis.a, axis.b, 0.0));
    zone.geometry.direction = Some(if half_angle < 0.0 { axis.chart.d0.map(|x| -x) } else { axis.chart.d0 });
    zone.geometry.radius_mm = Some(middle / half_angle.cos() * cloud.scale_mm);
    zone.geometry.apex_angle_rad = Some(2.0 * half_angle.abs());
    zone.iterations = iterations;
    Ok(zone)
}

fn from_mm(cloud: &Cloud, p: Vector) -> Vector {
    [0, 1, 2].map(|k| (p[k] - cloud.centre_mm[k]) / cloud.scale_mm)
}
