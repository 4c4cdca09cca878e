//! What every minimum zone answers.

use super::element::Element;
use etalon_base::pose::Vector;

/// A minimum zone and what holds it.
#[derive(Clone, Debug, PartialEq)]
pub struct MinimumZone {
    /// Line in the plane, plane, circle, sphere, cylinder or cone.
    pub element: Element,
    /// Centre of a circle or sphere; of the others the foot of the centroid. It lies in the middle of the zone, for a
    /// cylinder or cone on its axis.
    pub point_mm: Vector,
    /// Unit direction of a line or axis, unit normal of a plane (largest component positive; the axis of a cone towards
    /// increasing radius).
    pub direction: Option<Vector>,
    /// Mean of the radii of both circles, spheres or cylinders; of a cone at its point, in the middle of the zone.
    pub radius_mm: Option<f64>,
    /// Full angle of a cone, in radians.
    pub apex_angle_rad: Option<f64>,
    /// Width of the zone.
    pub form_mm: f64,
    /// Distance of each point from the middle of the zone: positive on the side of the normal, to the left of the
    /// line, outside a circle, sphere, cylinder or cone.
    pub residuals_mm: Vec<f64>,
    /// Indices of the points that hold the upper or outer side, ascending.
    pub upper: Vec<usize>,
    /// Indices of the points that hold the lower or inner side, ascending.
    pub lower: Vec<usize>,
    /// Whether it was proved, to rounding, that no other element of the kind has a narrower zone. Otherwise the zone
    /// is the narrowest of its neighbourhood at least, where the contact points fulfil their condition.
    pub verified: bool,
    /// Of a sphere, cylinder or cone: what proves that every neighbour of it has a wider zone.
    pub multipliers: Option<Multipliers>,
    /// Of a circle in space: the minimum zone of the plane that the circle lies in. Its width is the flatness.
    pub plane: Option<Box<MinimumZone>>,
    /// Zones that were looked at on the way.
    pub iterations: usize,
}

/// Lagrange multipliers of the contact points: positive, one in sum on each side, with equal mean gradients of the
/// distance by the parameters of the element on both sides (Karush-Kuhn-Tucker), so that the zone grows in every direction.
#[derive(Clone, Debug, PartialEq)]
pub struct Multipliers {
    /// Of `upper`, in its order; zero for a contact that is not needed.
    pub upper: Vec<f64>,
    /// Of `lower`, in its order.
    pub lower: Vec<f64>,
}

/// Distance from a side of the zone, as part of the size of the points or the radius, within which a point holds it:
/// rounding.
const CONTACT: f64 = 1e-14;
/// What a proof may miss, as part of the size of the points: rounding of the bounds.
pub(super) const SLACK: f64 = 1e-13;
/// Centres farther away, in sizes of the points, are not looked for: such an arc is straight to a ten-thousandth, and the
/// rounding of its radius shows in its form.
pub(super) const FARTHEST: f64 = 1e4;

impl MinimumZone {
    /// Apex of a cone.
    pub fn apex_mm(&self) -> Option<Vector> {
        let (axis, tangent) = (self.direction?, (0.5 * self.apex_angle_rad?).tan());
        let height = self.radius_mm? / tangent;
        height.is_finite().then(|| [0, 1, 2].map(|k| self.point_mm[k] - height * axis[k]))
    }

    /// The zone of points at these distances, in units of `scale_mm`, and the distance of its middle; without its place yet,
    /// and not verified.
    pub(super) fn between(element: Element, distances: &[f64], scale_mm: f64) -> (Self, f64) {
        let (low, high, lower, upper) = sides(distances);
        let middle = 0.5 * (low + high);
        let zone = Self {
            element,
            point_mm: [0.0; 3],
            direction: None,
            radius_mm: None,
            apex_angle_rad: None,
            form_mm: (high - low) * scale_mm,
            residuals_mm: distances.iter().map(|d| (d - middle) * scale_mm).collect(),
            upper,
            lower,
            verified: false,
            multipliers: None,
            plane: None,
            iterations: 0,
        };
        (zone, middle)
    }
}

/// Smallest and largest value, and the indices of those within rounding of either.
pub(super) fn sides(values: &[f64]) -> (f64, f64, Vec<usize>, Vec<usize>) {
    let (low, high) = values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(*v), h.max(*v)));
    let near = |side: f64| {
        (0..values.len()).filter(|&i| (values[i] - side).abs() <= CONTACT * side.abs().max(1.0)).collect::<Vec<_>>()
    };
    (low, high, near(low), near(high))
}
