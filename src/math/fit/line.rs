//! Straight line, in space and in the plane: through the centroid, along the direction of largest spread.

use super::axis::Chart;
use super::cloud::{Cloud, Source};
use super::element::{Element, Settings};
use super::plane::diagonal_matrix;
use super::result::{Fit, Residuals, largest_component_positive};
use super::surface::propagate;
use crate::base::message::Result;
use crate::base::pose::{Vector, dot, minus};

/// Fits a straight line in space to at least two different points; it runs from the first point to the last.
///
/// The direction is the principal direction of largest spread of the centred points (Shakarji 1998, 3.1).
pub fn line(points: &[Vector]) -> Result<Fit> {
    line_with(points, &Settings::default())
}

/// [`line()`] with weights or a held direction.
pub fn line_with(points: &[Vector], settings: &Settings) -> Result<Fit> {
    fit(Element::Line, Source::Space(points.into()), settings)
}

/// Fits a straight line in the plane; z of its point and direction is zero.
pub fn line2d(points: &[[f64; 2]]) -> Result<Fit> {
    line2d_with(points, &Settings::default())
}

/// [`line2d`] with weights.
pub fn line2d_with(points: &[[f64; 2]], settings: &Settings) -> Result<Fit> {
    fit(Element::Line2d, Source::Plane(points), settings)
}

fn fit(element: Element, points: Source, settings: &Settings) -> Result<Fit> {
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
    let residuals = Residuals::of(&cloud, |q| {
        let [x, y, _] = chart.seen(q, [0.0; 3]);
        [if flat { y } else { (x * x + y * y).sqrt() }]
    });
    let (n, squares) = (cloud.len(), residuals.squares);
    let equations = if flat { n } else { 2 * n };
    let parameters = (if flat { 1 } else { 2 }) * (if held.is_some() { 1 } else { 2 });
    let degrees_of_freedom = equations - parameters;
    let mut fit = Fit::new(element, &cloud, [0.0; 3], residuals);
    fit.direction = Some(direction);
    fit.degrees_of_freedom = degrees_of_freedom;
    if degrees_of_freedom > 0 {
        let variance = squares / degrees_of_freedom as f64;
        let place = variance / n as f64;
        let tilt = if held.is_some() { 0.0 } else { variance / (cloud.spread[0] * cloud.spread[0]) };
        // in the plane nothing moves along e1 = z
        let diagonal = if flat { [0.0, place, 0.0, 0.0, tilt] } else { [place, place, 0.0, tilt, tilt] };
        fit.covariance = Some(propagate(&diagonal_matrix(diagonal), &chart.quantities::<5>(), cloud.scale_mm));
    }
    Ok(fit.compensated(settings.probe)?.with_warnings())
}

/// `d` or its opposite, so that it runs from the first point to the last.
pub(super) fn from_first_to_last(cloud: &Cloud, d: Vector) -> Vector {
    let along = dot(minus(cloud.point(cloud.len() - 1), cloud.point(0)), d);
    // a closed walk says nothing about the direction
    if along.abs() < 1e-9 {
        largest_component_positive(d)
    } else if along < 0.0 {
        d.map(|x| -x)
    } else {
        d
    }
}
