//! Circle in space, by either of its two definitions.
//!
//! NIST's reference pairs and most CMM software fit the plane, project the points onto it and fit the circle there.
//! The full orthogonal distance to the curve differs: by 0.9 µrad in the normal on NIST's own set 25.

use super::axis::{Axial, Chart, angles_about, refine_axis};
use super::ball::Ball;
use super::circle2d::refine_circle;
use super::cloud::Cloud;
use super::element::{CircleMethod, Element, Settings};
use super::plane::{diagonal_matrix, plane_variances};
use super::result::{Covariance, Fit, QUANTITIES, arc_coverage, largest_component_positive};
use super::surface::{Surface, propagate};
use crate::message::Result;
use crate::pose::Vector;
use crate::solve::Options;

/// Fits a circle in space to at least three points that are not on one line: plane, projection, circle.
pub fn circle3d(points: &[Vector]) -> Result<Fit> {
    circle3d_with(points, &Settings::default())
}

/// [`circle3d`] with weights, a held radius or normal, or by full orthogonal distance.
pub fn circle3d_with(points: &[Vector], settings: &Settings) -> Result<Fit> {
    let held = settings.check(Element::Circle3d)?;
    let cloud = Cloud::new(Element::Circle3d, points, settings)?;
    let normal = largest_component_positive(held.unwrap_or(cloud.axes[2]));
    let (chart, variances) = plane_variances(&cloud, normal, held.is_some());
    let inside = Cloud {
        points: cloud.points.iter().map(|&q| chart.coordinates(q)).map(|[x, y, _]| [x, y, 0.0]).collect(),
        roots: cloud.roots.clone(),
        ..cloud
    };
    let circle = refine_circle(&inside, settings);
    if settings.circle == CircleMethod::Orthogonal {
        let [a, b, _, radius] = circle.x;
        return orthogonal(&cloud, chart, [a, b, 0.0, 0.0, 0.0, radius], held.is_some(), settings);
    }
    let [a, b, _, radius] = circle.x;
    let local = circle.covariance;
    let centre = chart.point(a, b, 0.0);
    let mut fit = circle.into_fit(Element::Circle3d, &Ball, &inside, centre)?;
    fit.covariance = variances.zip(local).map(|(plane, circle)| both(&chart, plane, circle, a, b, cloud.scale_mm));
    fit.out_of_plane_mm = cloud.points.iter().map(|&q| chart.coordinates(q)[2] * cloud.scale_mm).collect();
    fit.method = "least-squares plane, projection, circle in the plane by orthogonal distance";
    fit.direction = Some(normal);
    Ok(finished(fit, &cloud, &chart, centre, radius))
}

/// Covariance of plane (a, b, h, u, v) and circle (x, y, z, r), which share no residual, taken together.
fn both(chart: &Chart, plane: [f64; 5], circle: [[f64; 4]; 4], a: f64, b: f64, scale_mm: f64) -> Covariance {
    let mut local = [[0.0; 6]; 6];
    for (row, p) in local.iter_mut().zip(diagonal_matrix(plane)) {
        row[..5].copy_from_slice(&p);
    }
    for (i, k) in [(0, 0), (1, 1), (3, 5)] {
        for (j, l) in [(0, 0), (1, 1), (3, 5)] {
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
pub(super) struct Ring {
    pub(super) chart: Chart,
}

impl Surface<6, 2> for Ring {
    fn distances(&self, x: &[f64; 6], q: Vector) -> [(f64, [f64; 6]); 2] {
        let at = self.chart.cylindrical([x[0], x[1], x[2], x[3], x[4]], q);
        let widen = |d: [f64; 5], radius: f64| [d[0], d[1], d[2], d[3], d[4], radius];
        [(at.rho - x[5], widen(at.d_rho, -1.0)), (at.t, widen(at.d_t, 0.0))]
    }

    fn quantities(&self, _x: &[f64; 6]) -> [[f64; QUANTITIES]; 6] {
        let mut by_parameter = self.chart.quantities::<6>();
        by_parameter[5][6] = 1.0;
        by_parameter
    }
}

impl Axial<6, 2> for Ring {
    const SLIDES: bool = false;

    fn chart(&self) -> &Chart {
        &self.chart
    }

    fn with_chart(&self, chart: Chart) -> Self {
        Self { chart }
    }
}

fn orthogonal(cloud: &Cloud, chart: Chart, start: [f64; 6], axis_held: bool, settings: &Settings) -> Result<Fit> {
    let mut start = start;
    if let Some(radius) = settings.radius_mm {
        start[5] = radius / cloud.scale_mm;
    }
    let free = [true, true, true, !axis_held, !axis_held, settings.radius_mm.is_none()];
    let (ring, refined) = refine_axis(Ring { chart }, cloud, start, free, Options::default());
    let [a, b, h, u, v, radius] = refined.x;
    let (axis, _) = ring.chart.axis(u, v);
    let centre = ring.chart.point(a, b, h);
    let heights: Vec<f64> = refined.distances.iter().map(|d| d[1]).collect();
    let mut fit = refined.into_fit(Element::Circle3d, &ring, cloud, centre)?;
    // the largest component positive, whichever way the chart lies
    let normal = largest_component_positive(axis);
    fit.point_along(axis, normal);
    let turned = crate::pose::dot(normal, axis);
    fit.out_of_plane_mm = heights.iter().map(|t| t * turned.signum() * cloud.scale_mm).collect();
    Ok(finished(fit, cloud, &Chart::new(normal), centre, radius))
}

fn finished(mut fit: Fit, cloud: &Cloud, chart: &Chart, centre: Vector, radius: f64) -> Fit {
    fit.radius_mm = Some(radius * cloud.scale_mm);
    fit.coverage_rad = Some(arc_coverage(angles_about(&cloud.points, chart, centre)));
    fit.with_warnings()
}
