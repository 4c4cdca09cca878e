//! Geometric elements fitted to points: least squares of orthogonal distances, with uncertainty.
//!
//! Every fit goes the same way: points are checked, shifted to their centroid and scaled; a start is found from the
//! points alone; the orthogonal distances are minimised with exact derivatives; the answer ([`Fit`]) carries what is
//! left, its covariance, condition, and how the solver ended. A closed solution is used where there is one (plane,
//! line, rigid transform). Nothing here knows a file.

mod axis;
mod ball;
mod circle2d;
mod circle3d;
mod cloud;
mod cone;
mod coverage;
mod cylinder;
mod descend;
mod double_double;
mod element;
mod enclosing;
mod f64x8;
mod line;
mod plane;
mod probe;
mod result;
mod rigid;
mod search;
mod sphere;
mod stream;
mod surface;
mod torus;
mod zone;

pub use circle2d::{circle2d, circle2d_with};
pub use circle3d::{circle3d, circle3d_with};
pub use cone::{cone, cone_with};
pub use cylinder::{cylinder, cylinder_with};
pub use element::{CircleMethod, Element, Settings};
pub use enclosing::{Enclosing, enclosing_circle, enclosing_sphere};
pub use line::{line, line_with, line2d, line2d_with};
pub use plane::{plane, plane_with};
pub use probe::{Compensation, Probe, Side};
pub use result::{Covariance, Fit, QUANTITIES, Residuals, StandardUncertainty};
pub use rigid::{RigidFit, rigid, rigid_weighted};
pub use sphere::{sphere, sphere_with};
pub use torus::{torus, torus_with};
pub use zone::{MinimumZone, minimum_zone, minimum_zone_circle2d, minimum_zone_line2d, minimum_zone_plane};

use crate::base::message::Result;
use crate::base::pose::Vector;

/// Fits any element; of a line or circle in the plane, z of the points is not looked at.
pub fn element(element: Element, points: &[Vector], settings: &Settings) -> Result<Fit> {
    let flat = || points.iter().map(|p| [p[0], p[1]]).collect::<Vec<_>>();
    match element {
        Element::Line2d => line2d_with(&flat(), settings),
        Element::Line => line_with(points, settings),
        Element::Plane => plane_with(points, settings),
        Element::Circle2d => circle2d_with(&flat(), settings),
        Element::Circle3d => circle3d_with(points, settings),
        Element::Sphere => sphere_with(points, settings),
        Element::Cylinder => cylinder_with(points, settings),
        Element::Cone => cone_with(points, settings),
        Element::Torus => torus_with(points, settings),
    }
}
