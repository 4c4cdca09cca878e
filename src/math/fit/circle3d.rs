//! Circle in space, by either of its two definitions.
//!
//! NIST's reference pairs and most CMM software fit the plane, project the points onto it and fit the circle there.
//! The full orthogonal distance to the curve differs: by 0.9 µrad in the normal on NIST's own set 25.

use super::axis::Chart;
use super::circle2d::refine_circle;
use super::cloud::{Cloud, Source};
use super::coverage::Arc;
use super::descend::refine;
use super::element::{CircleMethod, Element, Settings};
use super::f64x8::{F64x8, Points, along};
use super::plane::{diagonal_matrix, plane_variances};
use super::result::{Covariance, Fit, QUANTITIES, Residuals, largest_component_positive};
use super::surface::{Surface, propagate};
use crate::base::message::Result;
use crate::base::pose::Vector;

/// Fits a circle in space to at least three points that are not on one line: plane, projection, circle.
pub fn circle3d(points: &[Vector]) -> Result<Fit> {
    circle3d_with(points, &Settings::default())
}

/// [`circle3d`] with weights, a held radius or normal, or by full orthogonal distance.
pub fn circle3d_with(points: &[Vector], settings: &Settings) -> Result<Fit> {
    let held = settings.check(Element::Circle3d)?;
    let cloud = Cloud::new(Element::Circle3d, Source::Space(points.into()), settings)?;
    let normal = largest_component_positive(held.unwrap_or(cloud.axes[2]));
    let heights = Residuals::of(&cloud, |q| [along(q, normal)]);
    let (chart, variances) = plane_variances(&cloud, normal, held.is_some(), heights.squares);
    let circle = refine_circle(&cloud, chart, settings);
    let [a, b, radius] = circle.x;
    if settings.circle == CircleMethod::Orthogonal {
        return orthogonal(&cloud, chart, [a, b, 0.0, 0.0, 0.0, radius], held.is_some(), settings);
    }
    let centre = chart.point(a, b, 0.0);
    let mut fit = circle.to_fit(Element::Circle3d, &cloud, centre, Arc::about(&chart, centre))?;
    let local = circle.covariance(fit.degrees_of_freedom);
    fit.covariance = variances.zip(local).map(|(plane, circle)| both(&chart, plane, circle, a, b, cloud.scale_mm));
    fit.out_of_plane_rms_mm = Some(heights.rms * cloud.scale_mm);
    fit.method = "least-squares plane, projection, circle in the plane by orthogonal distance";
    fit.direction = Some(normal);
    finished(fit, &cloud, radius, settings)
}

/// Covariance of plane (a, b, h, u, v) and circle (a, b, r), which share no residual, taken together.
fn both(chart: &Chart, plane: [f64; 5], circle: [[f64; 3]; 3], a: f64, b: f64, scale_mm: f64) -> Covariance {
    let mut local = [[0.0; 6]; 6];
    for (row, p) in local.iter_mut().zip(diagonal_matrix(plane)) {
        row[..5].copy_from_slice(&p);
    }
    for (i, k) in [(0, 0), (1, 1), (2, 5)] {
        for (j, l) in [(0, 0), (1, 1), (2, 5)] {
            local[k][l] = circle[i][j];
        }
    }
    let mut by_parameter = chart.quantities::<6>();
    by_parameter[5][6] = 1.0;
    // the plane t = h - u x - v y carries the centre (a, b) with it
    for (row, along) in [(3, a), (4, b)] {
        for (quantity, d) in by_parameter[row].iter_mut().zip(chart.d0) {
            *quantity -= along * d;
        }
    }
    propagate(&local, &by_parameter, scale_mm)
}

/// Parameters a, b, h, u, v of the axis and the radius; two distances a point: in the plane and from it.
#[derive(Clone, Copy)]
pub(super) struct Ring {
    pub(super) chart: Chart,
}

impl Surface<6, 2> for Ring {
    #[inline(always)]
    fn distances(&self, x: &[f64; 6], q: Points) -> [(F64x8, [F64x8; 6]); 2] {
        let at = self.chart.cylindrical([x[0], x[1], x[2]], x[5], q);
        let widen = |d: [F64x8; 5], radius: f64| [d[0], d[1], d[2], d[3], d[4], F64x8::all(radius)];
        [(at.rho - x[5], widen(at.d_rho, -1.0)), (at.t, widen(at.d_t, 0.0))]
    }

    fn recharted(&self, x: &[f64; 6]) -> (Self, [f64; 6]) {
        let (chart, x) = self.chart.moved(x);
        (Self { chart }, x)
    }

    fn quantities(&self, _x: &[f64; 6]) -> [[f64; QUANTITIES]; 6] {
        let mut by_parameter = self.chart.quantities::<6>();
        by_parameter[5][6] = 1.0;
        by_parameter
    }
}

fn orthogonal(cloud: &Cloud, chart: Chart, start: [f64; 6], axis_held: bool, settings: &Settings) -> Result<Fit> {
    let mut start = start;
    if let Some(radius) = settings.held_radius_mm() {
        start[5] = radius / cloud.scale_mm;
    }
    let free = [true, true, true, !axis_held, !axis_held, settings.radius_mm.is_none()];
    let refined = refine(Ring { chart }, cloud, start, free);
    let chart = refined.surface.chart;
    let [a, b, h, _, _, radius] = refined.x;
    let centre = chart.point(a, b, h);
    let mut fit = refined.to_fit(Element::Circle3d, cloud, centre, Arc::about(&chart, centre))?;
    // the largest component positive, whichever way the chart lies
    fit.point_along(chart.d0, largest_component_positive(chart.d0));
    let heights = Residuals::of(cloud, |q| [chart.seen(q, [a, b, h])[2]]);
    fit.out_of_plane_rms_mm = Some(heights.rms * cloud.scale_mm);
    finished(fit, cloud, radius, settings)
}

fn finished(mut fit: Fit, cloud: &Cloud, radius: f64, settings: &Settings) -> Result<Fit> {
    fit.radius_mm = Some(radius * cloud.scale_mm);
    Ok(fit.compensated(settings.probe)?.with_warnings())
}
