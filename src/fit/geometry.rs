//! Position, direction and size of an element.

use etalon_base::pose::Vector;

/// Position, direction and size of an element.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ElementGeometry {
    /// Centre of a circle, sphere or torus; centroid of the points for a plane or line; foot of the
    /// centroid on the axis for a cylinder or cone. In the middle of a minimum zone.
    pub point_mm: Vector,
    /// Unit normal of a plane, circle or torus (largest component positive); unit direction of a
    /// line (from the first point to the last); unit axis of a cylinder (largest component
    /// positive) or cone (towards larger radii).
    pub direction: Option<Vector>,
    /// Radius of a circle, sphere or cylinder; radius of the section of a cone at `point_mm`
    /// (perpendicular to the axis); radius of the centre line of a torus. In the middle of a
    /// minimum zone.
    pub radius_mm: Option<f64>,
    /// Radius of the tube of a torus.
    pub minor_radius_mm: Option<f64>,
    /// Full apex angle of a cone.
    pub apex_angle_rad: Option<f64>,
}

impl ElementGeometry {
    /// Apex of a cone; `None` for other elements.
    pub fn apex_mm(&self) -> Option<Vector> {
        let (d, r, angle) = (self.direction?, self.radius_mm?, self.apex_angle_rad?);
        let back = r / (angle / 2.0).tan();
        let p = self.point_mm;
        back.is_finite().then(|| [p[0] - back * d[0], p[1] - back * d[1], p[2] - back * d[2]])
    }
}
