//! The elements that points are fitted by, and what may be held or compensated while fitting.

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
    /// Every element.
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

    /// The name on the command line and in documents.
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

    /// Points without which the element is not determined (ISO/TS 15530 practice: the mathematical minimum).
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

    /// Dimensions that the points must span: 1 not identical, 2 not on a line, 3 not in a plane.
    pub(super) fn span(self) -> usize {
        match self {
            Self::Line2d | Self::Line => 1,
            Self::Plane | Self::Circle2d | Self::Circle3d => 2,
            Self::Sphere | Self::Cylinder | Self::Cone | Self::Torus => 3,
        }
    }

    /// Dimensions that a sample must span for centroid and size to be good enough: of an element whose answer does not
    /// depend on them.
    pub(super) fn rough(self) -> Option<usize> {
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
pub(super) fn name(name: &str) -> Phrase {
    phrase!("element", name)
}

impl FromStr for Element {
    type Err = Problems;

    fn from_str(name: &str) -> Result<Self> {
        let known = Self::ALL.into_iter().find(|e| e.name() == name);
        known.ok_or_else(|| error!("element-unknown", name).hint_names(name, Self::ALL.map(Self::name)).into())
    }
}

/// How a circle in space is fitted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum CircleMethod {
    /// Least-squares plane, projection onto it, circle in it: as NIST's reference pairs and most CMM software.
    #[default]
    Projected,
    /// Full orthogonal distance to the curve in space.
    Orthogonal,
}

/// A probe whose centre was measured instead of what it touched.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Probe {
    /// Effective (qualified) radius of the ball.
    pub radius_mm: f64,
    /// Where the ball was.
    pub side: Side,
}

/// The side of the element on which the probe was.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Side {
    /// Within a circle, sphere, cylinder, cone or the tube of a torus: a bore.
    Inside,
    /// Around it: a shaft, a ball.
    Outside,
    /// For a plane or line: the direction from what was touched to the probe. Of a plane only its sign counts, of a
    /// line what is square to it.
    Towards(Vector),
}

impl Probe {
    /// Refuses a radius that is none, and a side that `element` does not have.
    pub(super) fn check(&self, element: Element) -> Result<()> {
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

    /// How far the centres lie outside: the radius, negative for a probe inside.
    pub(super) fn outwards_mm(&self) -> f64 {
        if self.side == Side::Inside { -self.radius_mm } else { self.radius_mm }
    }
}

/// What may be chosen or held while fitting; the default holds nothing.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FitSettings<'a> {
    /// One positive weight a point, in inverse proportion to its variance; only their ratios count.
    pub weights: Option<&'a [f64]>,
    /// Holds the radius of a circle, sphere or cylinder.
    pub radius_mm: Option<f64>,
    /// Holds the direction: the normal of a plane, circle or torus, the axis of a line, cylinder or cone.
    pub axis: Option<Vector>,
    /// How a circle in space is fitted.
    pub circle: CircleMethod,
    /// The points are centres of this probe: the answer is what it touched, and so is a held radius.
    pub probe: Option<Probe>,
}

impl FitSettings<'_> {
    /// Refuses what `element` cannot hold; gives the held axis with length one.
    pub(super) fn check(&self, element: Element) -> Result<Option<Vector>> {
        self.probe.map_or(Ok(()), |probe| probe.check(element))?;
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

    /// The radius to hold in a fit of the points as they are: that of the probe centres where there is a probe.
    pub(super) fn held_radius_mm(&self) -> Option<f64> {
        self.radius_mm.map(|r| r + self.probe.map_or(0.0, |p| p.outwards_mm()))
    }
}
