//! Elements that can be fitted to points, and quantities that may be held or compensated.

use etalon_base::catalogue::{Argument, IntoArgument, Phrase};
use etalon_base::message::{Problems, Result};
use etalon_base::pose::{Vector, unit};
use etalon_base::{error, phrase};
use std::fmt;
use std::str::FromStr;

/// A geometric element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Element {
    /// Straight line in the plane.
    Line2d,
    /// Straight line in space.
    Line,
    /// Plane.
    Plane,
    /// Circle in the plane.
    Circle2d,
    /// Circle in space.
    Circle3d,
    /// Sphere.
    Sphere,
    /// Circular cylinder.
    Cylinder,
    /// Circular cone, one nappe.
    Cone,
    /// Torus.
    Torus,
}

impl Element {
    /// All elements.
    pub const ALL: [Self; 9] = [
        Self::Line2d,
        Self::Line,
        Self::Plane,
        Self::Circle2d,
        Self::Circle3d,
        Self::Sphere,
        Self::Cylinder,
        Self::Cone,
        Self::Torus,
    ];

    /// Name on the command line and in documents.
    pub fn name(self) -> &'static str {
        match self {
            Self::Line2d => "line2d",
            Self::Line => "line",
            Self::Plane => "plane",
            Self::Circle2d => "circle2d",
            Self::Circle3d => "circle3d",
            Self::Sphere => "sphere",
            Self::Cylinder => "cylinder",
            Self::Cone => "cone",
            Self::Torus => "torus",
        }
    }

    /// Minimum number of points (ISO/TS 15530 practice: the mathematical minimum).
    pub fn minimum_points(self) -> usize {
        match self {
            Self::Line2d | Self::Line => 2,
            Self::Plane | Self::Circle2d | Self::Circle3d => 3,
            Self::Sphere => 4,
            Self::Cylinder => 5,
            Self::Cone => 6,
            Self::Torus => 7,
        }
    }

    /// Number of dimensions that the points must span: 1 not identical, 2 not collinear, 3 not
    /// coplanar.
    pub(crate) fn span(self) -> usize {
        match self {
            Self::Line2d | Self::Line => 1,
            Self::Plane | Self::Circle2d | Self::Circle3d => 2,
            Self::Sphere | Self::Cylinder | Self::Cone | Self::Torus => 3,
        }
    }

    /// Number of dimensions that a sample must span for its centroid and size to suffice, for
    /// elements whose result does not depend on them.
    pub(crate) fn rough(self) -> Option<usize> {
        matches!(self, Self::Circle2d | Self::Sphere).then_some(self.span())
    }

    /// `true` if [`minimum_zone`](crate::minimum_zone) fits the element.
    pub fn has_minimum_zone(self) -> bool {
        !matches!(self, Self::Line | Self::Torus)
    }

    fn has_radius(self) -> bool {
        matches!(self, Self::Circle2d | Self::Circle3d | Self::Sphere | Self::Cylinder)
    }

    fn has_direction(self) -> bool {
        !matches!(self, Self::Line2d | Self::Circle2d | Self::Sphere)
    }
}

impl fmt::Display for Element {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl IntoArgument for Element {
    fn argument(&self) -> Argument {
        name(self.name()).argument()
    }
}

/// Name of an element in the language of a text.
pub(crate) fn name(name: &str) -> Phrase {
    phrase!("element", name)
}

impl FromStr for Element {
    type Err = Problems;

    fn from_str(name: &str) -> Result<Self> {
        let known = Self::ALL.into_iter().find(|e| e.name() == name);
        known.ok_or_else(|| error!("element-unknown", name).hint_names(name, Self::ALL.map(Self::name)).into())
    }
}

/// Method of fitting a circle in space.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum CircleMethod {
    /// Least-squares plane, projection onto it, and circle in the plane, as in NIST's reference
    /// pairs and most CMM software.
    #[default]
    Projected,
    /// Orthogonal distance to the curve in space.
    Orthogonal,
}

/// A probe whose centres were measured instead of the contact points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Probe {
    /// Effective (qualified) radius of the probe tip.
    pub radius_mm: f64,
    /// Side of the element on which the probe was.
    pub side: Side,
}

/// The side of the element on which the probe was.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Side {
    /// Inside a circle, sphere, cylinder, cone or the tube of a torus: a bore.
    Inside,
    /// Outside the element: a shaft, a ball.
    Outside,
    /// For a plane or line: direction from the element to the probe. For a plane only its sign
    /// matters, for a line the component perpendicular to it.
    Towards(Vector),
}

impl Probe {
    /// Rejects a non-positive radius, and a side that `element` does not have.
    pub(crate) fn check(&self, element: Element) -> Result<()> {
        let radius = self.radius_mm;
        if !(radius.is_finite() && radius > 0.0) {
            return Err(error!("probe-radius-not-positive", radius).into());
        }
        let straight = matches!(element, Element::Plane | Element::Line | Element::Line2d);
        match self.side {
            Side::Inside | Side::Outside if straight => Err(error!("probe-side-needs-direction", element).into()),
            Side::Towards(_) if !straight => Err(error!("probe-side-needs-inside", element).into()),
            Side::Towards(d) if unit(d).is_none() => {
                Err(error!("probe-direction-zero", direction = format!("{d:?}")).into())
            }
            _ => Ok(()),
        }
    }

    /// Outward offset of the centres: the radius, or minus the radius for a probe inside.
    pub(crate) fn outwards_mm(&self) -> f64 {
        if self.side == Side::Inside { -self.radius_mm } else { self.radius_mm }
    }
}

/// Options of a fit; the default holds nothing.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FitSettings<'a> {
    /// One positive weight per point, inversely proportional to its variance; only ratios matter.
    pub weights: Option<&'a [f64]>,
    /// Held radius of a circle, sphere or cylinder.
    pub radius_mm: Option<f64>,
    /// Held direction: normal of a plane, circle or torus, axis of a line, cylinder or cone.
    pub axis: Option<Vector>,
    /// Method of fitting a circle in space.
    pub circle: CircleMethod,
    /// Probe whose centres are the points. The result, and a held radius, apply to the contact
    /// surface.
    pub probe: Option<Probe>,
    /// Standard uncertainty (k = 1) of the distance of a point of mean weight from the element; by
    /// default estimated from the residuals.
    pub standard_uncertainty_mm: Option<f64>,
}

impl FitSettings<'_> {
    /// Rejects options that do not apply to `element`; returns the held axis as a unit vector.
    pub(crate) fn check(&self, element: Element) -> Result<Option<Vector>> {
        self.probe.map_or(Ok(()), |probe| probe.check(element))?;
        if let Some(uncertainty_mm) = self.standard_uncertainty_mm.filter(|u| !(u.is_finite() && *u > 0.0)) {
            return Err(error!("point-uncertainty-not-positive", uncertainty_mm).into());
        }
        if let Some(radius) = self.radius_mm {
            if !element.has_radius() {
                return Err(error!("held-radius-unsupported", element).into());
            }
            if !(radius.is_finite() && radius > 0.0) {
                return Err(error!("held-radius-not-positive", radius).into());
            }
            if let Some(centres) = self.held_radius_mm().filter(|centres| *centres <= 0.0) {
                return Err(error!("held-radius-below-probe", element, radius, centres).into());
            }
        }
        let Some(axis) = self.axis else { return Ok(None) };
        if !element.has_direction() {
            return Err(error!("held-axis-unsupported", element).into());
        }
        unit(axis).map(Some).ok_or_else(|| error!("held-axis-zero", axis = format!("{axis:?}")).into())
    }

    /// Held radius for a fit of the points as measured: for a probe, of its centres.
    pub(crate) fn held_radius_mm(&self) -> Option<f64> {
        self.radius_mm.map(|r| r + self.probe.map_or(0.0, |p| p.outwards_mm()))
    }
}
