//! Common result of all minimum zones.

use crate::element::Element;
use crate::geometry::ElementGeometry;
use etalon_base::message::Message;

/// A minimum zone and its contact points.
#[derive(Clone, Debug, PartialEq)]
pub struct MinimumZone {
    /// Line in the plane, plane, circle, sphere, cylinder or cone.
    pub element: Element,
    /// Position, direction and size, in the middle of the zone. The point of a line, plane,
    /// cylinder or cone is the foot of the centroid.
    pub geometry: ElementGeometry,
    /// Width of the zone.
    pub form_mm: f64,
    /// Distance of each point from the middle of the zone: positive on the side of the normal, to
    /// the left of the line, or outside a circle, sphere, cylinder or cone.
    pub residuals_mm: Vec<f64>,
    /// Indices of the contact points on the upper or outer side, ascending.
    pub upper: Vec<usize>,
    /// Indices of the contact points on the lower or inner side, ascending.
    pub lower: Vec<usize>,
    /// `true` if it was proved, to rounding, that no other element of the kind has a narrower zone.
    /// Otherwise the zone is locally narrowest, provided that the contact points fulfil their
    /// condition.
    pub verified: bool,
    /// For a sphere, cylinder or cone: proof that every neighbouring zone is wider.
    pub multipliers: Option<Multipliers>,
    /// For a circle in space: minimum zone of its plane, the width of which is the flatness.
    pub plane: Option<Box<MinimumZone>>,
    /// Number of zones examined.
    pub iterations: usize,
    /// Warnings about the points and the element, as of a least-squares fit.
    pub warnings: Vec<Message>,
}

/// Lagrange multipliers of the contact points: non-negative with sum one on each side, and with
/// equal weighted gradients of the distance with respect to the element's parameters on both sides
/// (Karush-Kuhn-Tucker). The zone therefore grows in every direction.
#[derive(Clone, Debug, PartialEq)]
pub struct Multipliers {
    /// Multipliers of `upper`, in its order; zero for a redundant contact.
    pub upper: Vec<f64>,
    /// Multipliers of `lower`, in its order.
    pub lower: Vec<f64>,
}

/// Maximum distance of a contact point from a side of the zone, relative to the size of the points
/// or the radius: rounding.
const CONTACT: f64 = 1e-14;
/// Tolerance of a proof, relative to the size of the points: rounding of the bounds.
pub(crate) const SLACK: f64 = 1e-13;
/// Maximum distance of a centre, relative to the size of the points. Beyond it an arc is straight
/// to 1e-4, and the rounding of its radius affects its form.
pub(crate) const FARTHEST: f64 = 1e4;

impl MinimumZone {
    /// Returns the zone of points at these distances, in units of `scale_mm`, and distance of its
    /// middle; without position and unverified.
    pub(crate) fn between(element: Element, distances: &[f64], scale_mm: f64) -> (Self, f64) {
        let (low, high, lower, upper) = sides(distances);
        let middle = 0.5 * (low + high);
        let zone = Self {
            element,
            geometry: ElementGeometry::default(),
            form_mm: (high - low) * scale_mm,
            residuals_mm: distances.iter().map(|d| (d - middle) * scale_mm).collect(),
            upper,
            lower,
            verified: false,
            multipliers: None,
            plane: None,
            iterations: 0,
            warnings: Vec::new(),
        };
        (zone, middle)
    }
}

/// Smallest and largest value, and indices of the values within rounding of either.
pub(crate) fn sides(values: &[f64]) -> (f64, f64, Vec<usize>, Vec<usize>) {
    let (low, high) = values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(*v), h.max(*v)));
    let near = |side: f64| {
        (0..values.len()).filter(|&i| (values[i] - side).abs() <= CONTACT * side.abs().max(1.0)).collect::<Vec<_>>()
    };
    (low, high, near(low), near(high))
}
