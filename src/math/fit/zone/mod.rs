//! Minimum zone: the line, plane or circle between whose two parallels all points lie closest together (ISO 1101 form).
//!
//! Not least squares: four points at most hold the zone, and a single wrong point moves it. Each answer is held by its
//! contact points, and says whether it was proved that no other place is narrower.

mod chebyshev;
mod circle;
mod hull;
mod line;
mod plane;

pub use circle::minimum_zone_circle2d;
pub use line::minimum_zone_line2d;
pub use plane::minimum_zone_plane;

use super::element::{Element, refuse};
use crate::base::message::Result;
use crate::base::pose::Vector;

/// A minimum zone and what holds it.
#[derive(Clone, Debug, PartialEq)]
pub struct MinimumZone {
    /// Line in the plane, plane, or circle in the plane.
    pub element: Element,
    /// Centre of the circle; for a line or plane the foot of the centroid. It lies in the middle of the zone.
    pub point_mm: Vector,
    /// Unit direction of the line, unit normal of the plane (largest component positive).
    pub direction: Option<Vector>,
    /// Mean of the radii of both circles.
    pub radius_mm: Option<f64>,
    /// Width of the zone.
    pub form_mm: f64,
    /// Distance of each point from the middle of the zone: positive on the side of the normal, to the left of the
    /// line, outside the circle.
    pub residuals_mm: Vec<f64>,
    /// Indices of the points that hold the upper or outer side, ascending.
    pub upper: Vec<usize>,
    /// Indices of the points that hold the lower or inner side, ascending.
    pub lower: Vec<usize>,
    /// Whether it was proved, to rounding, that no other line, plane or circle has a narrower zone. Otherwise the zone
    /// is the narrowest of its neighbourhood at least, where the contact points fulfil their condition.
    pub verified: bool,
    /// Zones that were looked at on the way.
    pub iterations: usize,
}

/// The minimum zone of an element; of a line or circle in the plane, z of the points is not looked at.
///
/// An error for other elements than line2d, plane and circle2d, and for points that do not determine them.
pub fn minimum_zone(element: Element, points: &[Vector]) -> Result<MinimumZone> {
    let flat = || points.iter().map(|p| [p[0], p[1]]).collect::<Vec<_>>();
    match element {
        Element::Line2d => minimum_zone_line2d(&flat()),
        Element::Plane => minimum_zone_plane(points),
        Element::Circle2d => minimum_zone_circle2d(&flat()),
        _ => Err(refuse(
            format!("there is no minimum zone of a {element}"),
            "line2d, plane or circle2d",
            "leave --minimum-zone out: the fit is by least squares then",
        )),
    }
}

/// Distance from a side of the zone, as part of the size of the points or the radius, within which a point holds it:
/// rounding.
const CONTACT: f64 = 1e-14;
/// What a proof may miss, as part of the size of the points: rounding of the bounds.
const SLACK: f64 = 1e-13;

impl MinimumZone {
    /// The zone of points at these distances, in units of `scale_mm`, and the distance of its middle. Its place, and whether it
    /// is the narrowest, are still to be told.
    fn between(element: Element, distances: &[f64], scale_mm: f64) -> (Self, f64) {
        let (low, high, lower, upper) = sides(distances);
        let middle = 0.5 * (low + high);
        let zone = Self {
            element,
            point_mm: [0.0; 3],
            direction: None,
            radius_mm: None,
            form_mm: (high - low) * scale_mm,
            residuals_mm: distances.iter().map(|d| (d - middle) * scale_mm).collect(),
            upper,
            lower,
            verified: false,
            iterations: 0,
        };
        (zone, middle)
    }
}

/// Smallest and largest value, and the indices of those within rounding of either.
fn sides(values: &[f64]) -> (f64, f64, Vec<usize>, Vec<usize>) {
    let (low, high) = values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(*v), h.max(*v)));
    let near = |side: f64| {
        (0..values.len()).filter(|&i| (values[i] - side).abs() <= CONTACT * side.abs().max(1.0)).collect::<Vec<_>>()
    };
    (low, high, near(low), near(high))
}
