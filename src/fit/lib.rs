//! Geometric elements fitted to points by least squares of orthogonal distances, with uncertainty.
//!
//! All fits have the same steps: points are checked, shifted to their centroid and scaled; a start
//! is found from the points alone; orthogonal distances are minimised with exact derivatives. The
//! result ([`Fit`]) holds residuals, covariance, condition number and termination of the solver.
//! Plane, line and rigid transform have closed-form solutions. No function reads files.
#![allow(non_snake_case)] // frames in names, such as `world_T_base`

mod chart;
mod cloud;
mod coverage;
mod elements;
mod geometry;
mod numbers;
mod prediction;
mod result;
mod rigid;
mod robust;
mod solver;
mod zones;

use elements::{circle_and_sphere, cone, cylinder, element, line_and_plane, torus};
use numbers::{double_double, f64x8, packed};
use zones::{chebyshev, enclosing, growth, minimax, minimum_zone, round_zone, search, zone};

pub use circle_and_sphere::{circle2d, circle3d, sphere};
pub use cloud::Source;
pub use cone::cone;
pub use cylinder::cylinder;
pub use element::{CircleMethod, Element, FitSettings, Probe, Side};
pub use enclosing::{Enclosing, enclosing_circle, enclosing_sphere};
pub use geometry::ElementGeometry;
pub use line_and_plane::{line, line2d, plane};
pub use minimum_zone::minimum_zone;
pub use packed::PackedPoints;
pub use result::{
    Compensation, ElementCovariance, Fit, FitPrecision, FitSolver, QUANTITIES, Residuals, StandardUncertainty,
};
pub use rigid::{RigidFit, rigid, rotation_onto};
pub use robust::{OutlyingPoints, RobustElement, outlying_points, robust_element, warnings};
pub use torus::torus;
pub use zone::{MinimumZone, Multipliers};

use etalon_base::message::Result;

/// Fits any element; for a line or circle in the plane, z of the points is ignored.
pub fn element<'a>(element: Element, points: impl Into<Source<'a>>, settings: &FitSettings) -> Result<Fit> {
    let points = points.into();
    let flat = || (0..points.len()).map(|i| points.at(i)).map(|[x, y, _]| [x, y]).collect::<Vec<_>>();
    match element {
        Element::Line2d => line2d(&flat(), settings),
        Element::Line => line_and_plane::fit(element, points, settings),
        Element::Plane => line_and_plane::fit_plane(points, settings),
        Element::Circle2d => circle2d(&flat(), settings),
        Element::Circle3d => circle_and_sphere::fit_circle3d(points, settings),
        Element::Sphere => circle_and_sphere::fit_sphere(points, settings),
        Element::Cylinder => cylinder::fit_cylinder(points, settings),
        Element::Cone => cone::fit_cone(points, settings),
        Element::Torus => torus::fit_torus(points, settings),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chart::Chart;
    use crate::circle_and_sphere::{Ball, Disc, Ring};
    use crate::cone::Funnel;
    use crate::cylinder::Tube;
    use crate::f64x8::F64x8;
    use crate::solver::Surface;
    use crate::torus::Bend;

    /// Compares every derivative with a fourth-order central difference through a new chart, except
    /// for held parameters.
    fn derivatives_agree<S: Surface<N, K>, const N: usize, const K: usize>(
        name: &str,
        surface: &S,
        x: [f64; N],
        held: &[usize],
    ) {
        for q in [[0.7, -0.4, 0.9], [-0.2, 0.8, -0.6], [0.31, 0.17, 0.05]] {
            let q = q.map(F64x8::all);
            let analytic = surface.distances(&x, q);
            for j in (0..N).filter(|j| !held.contains(j)) {
                let h = 1e-3;
                let shifted = |k: f64| {
                    let mut x = x;
                    x[j] += k * h;
                    let (surface, x) = surface.recharted(&x);
                    surface.distances(&x, q).map(|(distance, _)| distance.0[0])
                };
                let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(shifted);
                for k in 0..K {
                    let numeric = (a[k] - 8.0 * b[k] + 8.0 * c[k] - d[k]) / (12.0 * h);
                    let analytic = analytic[k].1[j].0[0];
                    assert!(
                        (analytic - numeric).abs() < 1e-9,
                        "{name}: row {k} parameter {j}: {analytic} and {numeric}"
                    );
                }
            }
        }
    }

    #[test]
    fn jacobians_are_the_numeric_derivatives() {
        let chart = Chart::new([0.3, -0.5, 0.8]);
        derivatives_agree("ball", &Ball, [0.1, -0.2, 0.3, 0.8], &[]);
        derivatives_agree("circle", &Disc { chart }, [0.1, -0.2, 0.8], &[]);
        derivatives_agree("circle in space", &Ring { chart }, [0.1, -0.2, 0.05, 0.0, 0.0, 0.8], &[]);
        // the point of cylinder and cone is kept at the foot of the centroid
        derivatives_agree("cylinder", &Tube { chart }, [0.1, -0.2, 0.0, 0.0, 0.0, 0.8], &[2]);
        derivatives_agree("cone", &Funnel { chart }, [0.1, -0.2, 0.0, 0.0, 0.0, 0.8, 0.4], &[2]);
        derivatives_agree("torus", &Bend { chart }, [0.1, -0.2, 0.05, 0.0, 0.0, 0.8, 0.3], &[]);
    }

    /// Compares derivatives of the reported quantities with differences through a new chart about
    /// the moved axis.
    #[test]
    fn quantities_move_as_stated() {
        let chart = Chart::new([0.3, -0.5, 0.8]);
        let reported = |surface: &Funnel, x: &[f64; 7]| {
            let (moved, y) = surface.recharted(x);
            let p = moved.chart.point(y[0], y[1], y[2]);
            let d = moved.chart.d0;
            [p[0], p[1], p[2], d[0], d[1], d[2], y[5] / y[6].cos(), 0.0, 2.0 * y[6]]
        };
        let (surface, x) = (Funnel { chart }, [0.1, -0.2, 0.0, 0.0, 0.0, 0.8, 0.4]);
        let stated = surface.quantities(&x);
        for j in [0, 1, 3, 4, 5, 6] {
            let shifted = |h: f64| {
                let mut x = x;
                x[j] += h;
                reported(&surface, &x)
            };
            let (less, more) = (shifted(-1e-5), shifted(1e-5));
            for q in 0..QUANTITIES {
                let numeric = (more[q] - less[q]) / 2e-5;
                assert!(
                    (numeric - stated[j][q]).abs() < 1e-9,
                    "parameter {j} quantity {q}: {numeric} {}",
                    stated[j][q]
                );
            }
        }
    }
}
