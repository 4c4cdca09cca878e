//! Straight line (in space and in the plane) and plane, through the centroid along principal
//! directions of the points.

use crate::chart::Chart;
use crate::cloud::{Cloud, Source};
use crate::element::{Element, FitSettings};
use crate::f64x8::along;
use crate::result::{Fit, FitPrecision, Residuals, largest_component_positive, principal_uncertainty, propagate};
use etalon_base::message::Result;
use etalon_base::pose::{Vector, cross, dot, minus};

/// Fits a straight line in space to at least two distinct points, directed from the first point to
/// the last.
///
/// The direction is the principal direction of largest spread of the centred points (Shakarji 1998,
/// 3.1).
pub fn line(points: &[Vector], settings: &FitSettings) -> Result<Fit> {
    fit(Element::Line, points.into(), settings)
}

/// Fits a straight line in the plane; z of its point and direction is zero.
pub fn line2d(points: &[[f64; 2]], settings: &FitSettings) -> Result<Fit> {
    fit(Element::Line2d, Source::Plane(points), settings)
}

pub(crate) fn fit(element: Element, points: Source, settings: &FitSettings) -> Result<Fit> {
    let held = settings.check(element)?;
    let cloud = Cloud::new(element, points, settings)?;
    let direction = from_first_to_last(&cloud, held.unwrap_or(cloud.axes[0]));
    let flat = element == Element::Line2d;
    // right-handed with z up in the plane: e2 points to the left of the line
    let chart = if flat {
        Chart { d0: direction, e1: [0.0, 0.0, 1.0], e2: [-direction[1], direction[0], 0.0] }
    } else {
        Chart::new(direction)
    };
    let residuals = Residuals::from_distances(&cloud, |q| {
        let [x, y, _] = chart.seen(q, [0.0; 3]);
        if flat { y } else { (x * x + y * y).sqrt() }
    });
    let (n, squares) = (cloud.len(), residuals.squares);
    let equations = if flat { n } else { 2 * n };
    let parameters = (if flat { 1 } else { 2 }) * (if held.is_some() { 1 } else { 2 });
    let degrees_of_freedom = equations - parameters;
    let [longest, across, _] = cloud.spread;
    let mut fit = Fit::new(element, &cloud, [0.0; 3], residuals);
    fit.geometry.direction = Some(direction);
    let variance = cloud.variance(squares, degrees_of_freedom);
    fit.precision = FitPrecision::new(&cloud, degrees_of_freedom, variance);
    fit.precision.principal_rad = principal_uncertainty(longest, across, n - 2).filter(|_| held.is_none());
    if let Some(variance) = variance {
        let place = variance / n as f64;
        let tilt = if held.is_some() { 0.0 } else { variance / (longest * longest) };
        // in the plane nothing moves along e1 = z
        let diagonal = if flat { [0.0, place, 0.0, 0.0, tilt] } else { [place, place, 0.0, tilt, tilt] };
        fit.precision.covariance =
            Some(propagate(&diagonal_matrix(diagonal), &chart.quantities::<5>(), cloud.scale_mm));
    }
    fit.finished(settings)
}

/// Returns `d` or its opposite, so that it runs from the first point to the last.
pub(crate) fn from_first_to_last(cloud: &Cloud, d: Vector) -> Vector {
    let along = dot(minus(cloud.point(cloud.len() - 1), cloud.point(0)), d);
    // a closed path has no direction
    if along.abs() < 1e-9 {
        largest_component_positive(d)
    } else if along < 0.0 {
        d.map(|x| -x)
    } else {
        d
    }
}

/// Fits a plane to at least three non-collinear points.
///
/// The normal is the principal direction of smallest spread of the centred points (Shakarji 1998,
/// 3.2).
///
/// # Examples
///
/// ```
/// use etalon_fit::{FitSettings, plane};
///
/// // corners of a plate of 100 mm at z = 50 mm, by turns 0.01 mm below and above
/// let (low, high) = (49.99, 50.01);
/// let corners_mm = [[0.0, 0.0, low], [100.0, 0.0, high], [100.0, 100.0, low], [0.0, 100.0, high]];
/// let fit = plane(&corners_mm, &FitSettings::default())?;
///
/// let [_, _, z] = fit.geometry.direction.expect("a plane has a normal");
/// assert!((z - 1.0).abs() < 1e-12);
/// assert!((fit.form_mm() - 0.02).abs() < 1e-12);
/// # Ok::<(), etalon_base::message::Problems>(())
/// ```
pub fn plane(points: &[Vector], settings: &FitSettings) -> Result<Fit> {
    fit_plane(points.into(), settings)
}

pub(crate) fn fit_plane(points: Source, settings: &FitSettings) -> Result<Fit> {
    let held = settings.check(Element::Plane)?;
    let cloud = Cloud::new(Element::Plane, points, settings)?;
    let normal = largest_component_positive(held.unwrap_or(cloud.axes[2]));
    let residuals = Residuals::from_distances(&cloud, |q| along(q, normal));
    let (chart, variances) = plane_variances(&cloud, normal, held.is_some(), residuals.squares);
    let degrees_of_freedom = cloud.len() - if held.is_some() { 1 } else { 3 };
    let mut fit = Fit::new(Element::Plane, &cloud, [0.0; 3], residuals);
    fit.geometry.direction = Some(normal);
    let variance = cloud.variance(residuals.squares, degrees_of_freedom);
    fit.precision = FitPrecision::new(&cloud, degrees_of_freedom, variance);
    fit.condition = if held.is_some() { 1.0 } else { cloud.spread[0] / cloud.spread[1] };
    fit.precision.principal_rad = normal_uncertainty(&cloud).filter(|_| held.is_none());
    fit.precision.covariance = variances.map(|diagonal| {
        // only height moves the plane; its point may slide sideways
        propagate(&diagonal_matrix(diagonal), &chart.quantities::<5>(), cloud.scale_mm)
    });
    fit.finished(settings)
}

/// Standard uncertainty (rad) of the normal that separates the two smallest spreads of points;
/// `None` without redundancy.
pub(crate) fn normal_uncertainty(cloud: &Cloud) -> Option<f64> {
    let [_, across, height] = cloud.spread;
    principal_uncertainty(across, height, cloud.len().saturating_sub(3))
}

/// Variances of (a, b, h, u, v) of a plane in a chart along the principal axes of the points. As
/// the columns (1, x, y) are uncorrelated, they are σ²/n, σ²/Σx² and σ²/Σy². `None` without
/// redundancy, unless the variance is stated. `squares` is the weighted sum of squared distances.
pub(crate) fn plane_variances(cloud: &Cloud, normal: Vector, held: bool, squares: f64) -> (Chart, Option<[f64; 5]>) {
    let free = if held { 1 } else { 3 };
    let n = cloud.len();
    let chart = if held {
        Chart::new(normal)
    } else {
        Chart { d0: normal, e1: cloud.axes[0], e2: cross(normal, cloud.axes[0]) }
    };
    let variances = cloud.variance(squares, n.saturating_sub(free)).map(|variance| {
        let tilt = |spread: f64| if held { 0.0 } else { variance / (spread * spread) };
        [0.0, 0.0, variance / n as f64, tilt(cloud.spread[0]), tilt(cloud.spread[1])]
    });
    (chart, variances)
}

pub(crate) fn diagonal_matrix<const N: usize>(diagonal: [f64; N]) -> [[f64; N]; N] {
    let mut matrix = [[0.0; N]; N];
    for (i, (row, d)) in matrix.iter_mut().zip(diagonal).enumerate() {
        row[i] = d;
    }
    matrix
}
