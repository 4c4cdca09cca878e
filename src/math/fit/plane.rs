//! Plane: through the centroid, normal to the direction of least spread.

use super::axis::Chart;
use super::cloud::{Cloud, Source};
use super::element::{Element, Settings};
use super::f64x8::along;
use super::result::{Fit, Residuals, largest_component_positive};
use super::surface::propagate;
use crate::base::message::Result;
use crate::base::pose::Vector;

/// Fits a plane to at least three points that are not on one line.
///
/// The normal is the principal direction of least spread of the centred points (Shakarji 1998, 3.2).
pub fn plane(points: &[Vector]) -> Result<Fit> {
    plane_with(points, &Settings::default())
}

/// [`plane`] with weights or a held normal.
pub fn plane_with(points: &[Vector], settings: &Settings) -> Result<Fit> {
    let held = settings.check(Element::Plane)?;
    let cloud = Cloud::new(Element::Plane, Source::Space(points.into()), settings)?;
    let normal = largest_component_positive(held.unwrap_or(cloud.axes[2]));
    let residuals = Residuals::of(&cloud, |q| [along(q, normal)]);
    let (chart, variances) = plane_variances(&cloud, normal, held.is_some(), residuals.squares);
    let degrees_of_freedom = points.len() - if held.is_some() { 1 } else { 3 };
    let mut fit = Fit::new(Element::Plane, &cloud, [0.0; 3], residuals);
    fit.direction = Some(normal);
    fit.degrees_of_freedom = degrees_of_freedom;
    fit.condition = if held.is_some() { 1.0 } else { cloud.spread[0] / cloud.spread[1] };
    fit.covariance = variances.map(|diagonal| {
        // only the height moves the plane: sideways its point may slide
        propagate(&diagonal_matrix(diagonal), &chart.quantities::<5>(), cloud.scale_mm)
    });
    Ok(fit.compensated(settings.probe)?.with_warnings())
}

/// Variances of (a, b, h, u, v) of the plane, in a chart along the principal axes of the points: with uncorrelated
/// columns (1, x, y) they are σ²/n, σ²/Σx² and σ²/Σy². `None` without redundancy. `squares` is the weighted sum of
/// squares of the distances.
pub(super) fn plane_variances(cloud: &Cloud, normal: Vector, held: bool, squares: f64) -> (Chart, Option<[f64; 5]>) {
    let free = if held { 1 } else { 3 };
    let n = cloud.len();
    let chart = if held {
        Chart::new(normal)
    } else {
        Chart { d0: normal, e1: cloud.axes[0], e2: crate::base::pose::cross(normal, cloud.axes[0]) }
    };
    let variances = (n > free).then(|| {
        let variance = squares / (n - free) as f64;
        let tilt = |spread: f64| if held { 0.0 } else { variance / (spread * spread) };
        [0.0, 0.0, variance / n as f64, tilt(cloud.spread[0]), tilt(cloud.spread[1])]
    });
    (chart, variances)
}

pub(super) fn diagonal_matrix<const N: usize>(diagonal: [f64; N]) -> [[f64; N]; N] {
    let mut matrix = [[0.0; N]; N];
    for (i, (row, d)) in matrix.iter_mut().zip(diagonal).enumerate() {
        row[i] = d;
    }
    matrix
}
