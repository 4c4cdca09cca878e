//! Circular cone, one nappe.

use crate::chart::{Chart, length};
use crate::cloud::{Cloud, Source};
use crate::coverage::Arc;
use crate::element::{Element, FitSettings};
use crate::f64x8::{F64x8, Points, along};
use crate::result::{Fit, QUANTITIES, Residuals};
use crate::search::{Axial, no_start, rival_warning, search};
use crate::solver::{ITERATIONS, Refined, Surface, descend, refine};
use etalon_base::message::Result;
use etalon_base::pose::Vector;
use etalon_base::warning;
use nalgebra::{Matrix5, Vector5};
use std::f64::consts::{FRAC_PI_2, PI};

/// Fits a cone to at least six non-coplanar points.
///
/// Distances to the surface are parametrised at the centroid instead of the apex, so that slim
/// cones are not singular (Shakarji 1998, 3.5). Starts are searched over the hemisphere of axes;
/// the best starts are refined.
pub fn cone(points: &[Vector], settings: &FitSettings) -> Result<Fit> {
    fit_cone(points.into(), settings)
}

pub(crate) fn fit_cone(points: Source, settings: &FitSettings) -> Result<Fit> {
    let held = settings.check(Element::Cone)?;
    let cloud = Cloud::new(Element::Cone, points, settings)?;
    let free = [true, true, false, held.is_none(), held.is_none(), true, true];
    let upright = |funnel, x| Some(widening(funnel, x)).filter(|(_, x): &(Funnel, [f64; 7])| x[5] > 0.0);
    let found = search(&cloud, held, free, |few, chart| vec![cone_along(few, chart)], upright);
    let found = found.ok_or_else(|| no_start(Element::Cone))?;
    let mut refined = refine(found.surface, &cloud, found.start, free);
    if !(0.0..=FRAC_PI_2).contains(&refined.x[6]) {
        // a cone close to a plane or cylinder has widened or narrowed beyond it
        let (funnel, x) = widening(refined.surface, refined.x);
        refined = descend(funnel, &cloud, x, free, ITERATIONS);
    }
    if refined.x[5] <= 0.0 {
        return Err(no_start(Element::Cone));
    }
    let mut fit = finished(&cloud, &refined, settings)?;
    fit.warnings.extend(found.rival.then(|| rival_warning(Element::Cone)));
    Ok(fit)
}

/// Fall of the sum of squares, over the variance, from a plane to the best cone, that noise exceeds
/// in one of a hundred planes: chi-square of the six parameters of a cone.
const BY_NOISE: f64 = 16.81;

fn finished(cloud: &Cloud, refined: &Refined<Funnel, 7>, settings: &FitSettings) -> Result<Fit> {
    let chart = refined.surface.chart;
    let [a, b, h, _, _, distance, half_angle] = refined.x;
    let foot = chart.point(a, b, h);
    let mut fit = refined.to_fit(Element::Cone, cloud, foot, Arc::about(&chart, foot))?;
    fit.point_along(chart.d0, if half_angle < 0.0 { chart.d0.map(|x| -x) } else { chart.d0 });
    fit.geometry.radius_mm = Some(distance / half_angle.cos() * cloud.scale_mm);
    fit.geometry.apex_angle_rad = Some(2.0 * half_angle.abs());
    let uncertain = fit.standard_uncertainty().and_then(|u| u.apex_angle_rad);
    if uncertain.is_some_and(|u| u > half_angle.abs()) {
        fit.warnings.push(warning!("cone-is-cylinder"));
    }
    // of a plane the apex is anywhere: its best place makes a cone of noise, which the uncertainty
    // of the angle at that place does not show
    let heights = Residuals::from_distances(cloud, |q| along(q, cloud.axes[2]));
    let improvement =
        fit.precision.degrees_of_freedom as f64 * ((heights.rms * cloud.scale_mm / fit.rms_mm()).powi(2) - 1.0);
    if improvement < BY_NOISE || uncertain.is_some_and(|u| u > FRAC_PI_2 - half_angle.abs()) {
        fit.warnings.push(warning!("cone-is-plane"));
    }
    fit.finished(settings)
}

/// Orients a cone so that its axis points towards larger radii and its half-angle is between 0 and
/// a right angle.
fn widening(mut funnel: Funnel, mut x: [f64; 7]) -> (Funnel, [f64; 7]) {
    // ψ − π is the same surface with reversed sign of the distance s
    let half_turns = (x[6] / PI).round();
    x[6] -= half_turns * PI;
    if half_turns.rem_euclid(2.0) == 1.0 {
        x[5] = -x[5];
    }
    if x[6] < 0.0 {
        let foot = funnel.chart.point(x[0], x[1], x[2]);
        let chart = Chart::new(funnel.chart.d0.map(|d| -d));
        x[..3].copy_from_slice(&chart.coordinates(foot));
        x[6] = -x[6];
        funnel = Funnel { chart };
    }
    (funnel, x)
}

/// Cone about a given axis: x² + y² = 2 p x + 2 q y + k0 + k1 t + k2 t², linear in all five
/// coefficients. The half-angle follows from a regression of the radii about (p, q) on the height.
fn cone_along(points: &[Vector], chart: Chart) -> (f64, [f64; 7]) {
    let points: Vec<[f64; 3]> = points.iter().map(|&q| chart.coordinates(q)).collect();
    let (mut sums, mut right) = ([[0.0; 5]; 5], [0.0; 5]);
    for &[x, y, t] in &points {
        let row = [2.0 * x, 2.0 * y, 1.0, t, t * t];
        for (i, factor) in row.iter().enumerate() {
            right[i] += factor * (x * x + y * y);
            for (s, other) in sums[i].iter_mut().zip(&row) {
                *s += factor * other;
            }
        }
    }
    let (mut normal, right) = (Matrix5::from(sums), Vector5::from(right));
    // with only two heights, t² depends linearly on 1 and t: slight damping selects a solution
    normal += Matrix5::identity() * (1e-10 * normal.trace());
    let Some(solved) = normal.cholesky().map(|c| c.solve(&right)) else { return (f64::INFINITY, [0.0; 7]) };
    let (p, q) = (solved[0], solved[1]);
    let radii: Vec<(f64, f64)> = points.iter().map(|&[x, y, t]| (length(x - p, y - q), t)).collect();
    let (slope, at_zero) = regression(&radii);
    let cost: f64 = radii.iter().map(|(rho, t)| (rho - at_zero - slope * t).powi(2)).sum();
    let half_angle = slope.atan();
    (cost / (1.0 + slope * slope), [p, q, 0.0, 0.0, 0.0, at_zero * half_angle.cos(), half_angle])
}

/// Slope and intercept of a regression of the first component of each pair on the second.
fn regression(pairs: &[(f64, f64)]) -> (f64, f64) {
    let n = pairs.len().max(1) as f64;
    let (y, x) = pairs.iter().fold((0.0, 0.0), |(sy, sx), (y, x)| (sy + y / n, sx + x / n));
    let (xy, xx) = pairs.iter().fold((0.0, 0.0), |(xy, xx), p| (xy + (p.1 - x) * (p.0 - y), xx + (p.1 - x).powi(2)));
    let slope = if xx > 0.0 { xy / xx } else { 0.0 };
    (slope, y - slope * x)
}

/// Cone. Parameters: axis (a, b, h, u, v) with h held at the foot of the centroid, distance s of
/// the foot from the surface, and half-angle ψ. The distance of a point is ρ cos ψ − t sin ψ − s
/// (Shakarji 1998, 3.5).
#[derive(Clone, Copy)]
pub(crate) struct Funnel {
    pub(crate) chart: Chart,
}

impl Surface<7, 1> for Funnel {
    const IDLE: usize = 2;

    #[inline(always)]
    fn distances(&self, x: &[f64; 7], q: Points) -> [(F64x8, [F64x8; 7]); 1] {
        let at = self.chart.cylindrical([x[0], x[1], x[2]], 0.0, q);
        let (sin, cos) = x[6].sin_cos();
        let mut d = at.d_rho;
        for (rho, t) in d.iter_mut().zip(at.d_t) {
            *rho = *rho * cos - t * sin;
        }
        let [a, b, h, u, v] = d;
        let turn = -(at.rho * sin + at.t * cos);
        [(at.rho * cos - at.t * sin - x[5], [a, b, h, u, v, F64x8::all(-1.0), turn])]
    }

    fn recharted(&self, x: &[f64; 7]) -> (Self, [f64; 7]) {
        let (chart, mut x) = self.chart.moved(x);
        // moving the point along the axis changes its distance from the surface by the growth of
        // the radius
        x[5] -= x[2] * x[6].sin();
        x[2] = 0.0;
        (Self { chart }, x)
    }

    fn quantities(&self, x: &[f64; 7]) -> [[f64; QUANTITIES]; 7] {
        let mut by_parameter = self.chart.quantities::<7>();
        let (sin, cos) = x[6].sin_cos();
        // radius = s / cos ψ
        by_parameter[5][6] = 1.0 / cos;
        by_parameter[6][6] = x[5] * sin / (cos * cos);
        by_parameter[6][8] = 2.0 * if x[6] < 0.0 { -1.0 } else { 1.0 };
        // the foot of the centroid stays perpendicular to the axis, and the radius there changes as
        // it slides
        for (row, along) in [(3, x[0]), (4, x[1])] {
            for (quantity, d) in by_parameter[row].iter_mut().zip(self.chart.d0) {
                *quantity -= along * d;
            }
            by_parameter[row][6] -= along * sin / cos;
        }
        by_parameter
    }
}

impl Axial<7, 1> for Funnel {
    fn on(chart: Chart) -> Self {
        Self { chart }
    }

    fn chart(&self) -> &Chart {
        &self.chart
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cone_turned_to_widen_is_the_same_cone() {
        let funnel = Funnel { chart: Chart::new([0.3, -0.5, 0.8]) };
        let q = [0.4, -0.7, 0.9].map(F64x8::all);
        for half_angle in [0.4, -0.4, PI - 0.4, PI + 0.4, FRAC_PI_2 - 0.1] {
            let x = [0.1, 0.2, 0.0, 0.05, -0.03, 0.6, half_angle];
            let (upright, y) = funnel.recharted(&x);
            let (turned, y) = widening(upright, y);
            assert!(y[6] > 0.0 && y[6] < FRAC_PI_2, "{half_angle}: {y:?}");
            let (chart_about_it, z) = funnel.recharted(&x);
            let (was, is) = (chart_about_it.distances(&z, q)[0].0.0[0], turned.distances(&y, q)[0].0.0[0]);
            assert!((was.abs() - is.abs()).abs() < 1e-14, "{half_angle}: {was} {is}");
        }
    }
}
