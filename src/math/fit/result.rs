//! What every fit answers: the element, its residuals, how well it is known and how the solver ended.

use super::cloud::Cloud;
use super::element::Element;
use super::f64x8::{F64x8, Points};
use super::probe::Compensation;
use super::stream::Gather;
use crate::base::message::Message;
use crate::base::pose::{Vector, cross, dot, minus, norm};
use crate::math::solve::Termination;

/// Number of quantities in a [`Covariance`].
pub const QUANTITIES: usize = 9;

/// Covariance of point (x, y, z, mm), direction (x, y, z), radius (mm), minor radius (mm) and apex angle (rad), in
/// this order; rows and columns of what an element does not have, or what was held, are zero.
///
/// It is propagated to first order from σ² (JᵀJ)⁻¹, with σ² the variance of the residuals.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Covariance(pub [[f64; QUANTITIES]; QUANTITIES]);

/// Standard uncertainties, the square roots of the diagonal of a [`Covariance`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StandardUncertainty {
    /// Of each coordinate of the point.
    pub point_mm: Vector,
    /// Of the point in its most uncertain direction.
    pub point_largest_mm: f64,
    /// Of the direction, the angle about its most uncertain axis.
    pub direction_rad: Option<f64>,
    /// Of the radius.
    pub radius_mm: Option<f64>,
    /// Of the minor radius of a torus.
    pub minor_radius_mm: Option<f64>,
    /// Of the full apex angle of a cone.
    pub apex_angle_rad: Option<f64>,
}

/// What is left of the points, in mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Residuals {
    /// Root of the mean square.
    pub rms: f64,
    /// Smallest.
    pub least: f64,
    /// Largest.
    pub most: f64,
    /// Weighted sum of squares, over all equations.
    pub squares: f64,
}

impl Residuals {
    /// Of all points, by their `K` distances; the first of these is the residual.
    pub(super) fn of<const K: usize>(cloud: &Cloud, distances: impl Fn(Points) -> [F64x8; K] + Sync) -> Self {
        Self::and(cloud, distances, ()).0
    }

    /// [`Residuals::of`], and in the same look at the points something else.
    pub(super) fn and<const K: usize, G: Gather>(
        cloud: &Cloud,
        distances: impl Fn(Points) -> [F64x8; K] + Sync,
        other: G,
    ) -> (Self, G::Sum) {
        let (zero, least, most) = (F64x8::default(), F64x8::all(f64::INFINITY), F64x8::all(f64::NEG_INFINITY));
        let remaining = Remaining { distances: &distances, squares: zero, plain: zero, least, most };
        let ([squares, plain, least, most], other) = cloud.gather((remaining, other));
        (Self { rms: (plain / cloud.len() as f64).sqrt(), least, most, squares }, other)
    }

    fn scaled(self, scale: f64) -> Self {
        Self {
            rms: self.rms * scale,
            least: self.least * scale,
            most: self.most * scale,
            squares: self.squares * scale * scale,
        }
    }
}

/// Weighted squares of all distances of a point, and squares, smallest and largest of the first.
struct Remaining<'a, F> {
    distances: &'a F,
    squares: F64x8,
    plain: F64x8,
    least: F64x8,
    most: F64x8,
}

impl<F> Clone for Remaining<'_, F> {
    fn clone(&self) -> Self {
        Self { ..*self }
    }
}

impl<const K: usize, F: Fn(Points) -> [F64x8; K] + Sync> Gather for Remaining<'_, F> {
    type Sum = [f64; 4];

    #[inline(always)]
    fn take(&mut self, q: Points, w: F64x8) {
        let distances = (self.distances)(q);
        for d in distances {
            self.squares = self.squares.plus(w * d, d);
        }
        self.plain = self.plain.plus(w.presence() * distances[0], distances[0]);
        self.least = self.least.min(distances[0]);
        self.most = self.most.max(distances[0]);
    }

    fn close(self) -> [f64; 4] {
        [self.squares.sum(), self.plain.sum(), self.least.least(), self.most.most()]
    }

    fn join(a: [f64; 4], b: [f64; 4]) -> [f64; 4] {
        [a[0] + b[0], a[1] + b[1], a[2].min(b[2]), a[3].max(b[3])]
    }
}

/// An element fitted to points by least squares of orthogonal distances.
#[derive(Clone, Debug, PartialEq)]
pub struct Fit {
    /// Which element.
    pub element: Element,
    /// Centre of a circle, sphere or torus; for a plane or line the centroid of the points; for a cylinder or cone
    /// the foot of that centroid on the axis.
    pub point_mm: Vector,
    /// Unit normal of a plane, circle or torus (its largest component is positive); unit direction of a line (from
    /// the first point to the last); unit axis of a cylinder (largest component positive) or cone (to larger radii).
    pub direction: Option<Vector>,
    /// Radius of a circle, sphere or cylinder; of a cone the radius of its section at `point_mm` (square to the
    /// axis); of a torus the radius of the circle that its tube is bent along.
    pub radius_mm: Option<f64>,
    /// Radius of the tube of a torus.
    pub minor_radius_mm: Option<f64>,
    /// Full apex angle of a cone.
    pub apex_angle_rad: Option<f64>,
    /// Number of points.
    pub points: usize,
    /// What is left: the orthogonal distances of the points ([`Fit::residual_mm`] gives that of one).
    pub residuals: Residuals,
    /// For a circle in space the root of the mean square of the distances from its plane.
    pub out_of_plane_rms_mm: Option<f64>,
    /// Equations less parameters.
    pub degrees_of_freedom: usize,
    /// How well the quantities are known; `None` without redundancy.
    pub covariance: Option<Covariance>,
    /// How much of the circumference has points: the full turn less the largest gap; for a sphere the full angle of
    /// the cap that holds the points.
    pub coverage_rad: Option<f64>,
    /// Largest over smallest singular value of the Jacobian with columns of length one.
    pub condition: f64,
    /// Where the points are probe centres: what was fitted to them, before it was moved to what the probe touched.
    pub compensation: Option<Compensation>,
    /// Name of the method.
    pub method: &'static str,
    /// Steps of the solver; zero where the solution is closed.
    pub iterations: usize,
    /// Why the solver stopped.
    pub termination: Termination,
    /// What a person must know before using the numbers.
    pub warnings: Vec<Message>,
}

impl Fit {
    /// A fit with closed solution and nothing but its point; `residuals` in normalised units.
    pub(super) fn new(element: Element, cloud: &Cloud, point: Vector, residuals: Residuals) -> Self {
        Self {
            element,
            point_mm: cloud.to_mm(point),
            direction: None,
            radius_mm: None,
            minor_radius_mm: None,
            apex_angle_rad: None,
            points: cloud.len(),
            residuals: residuals.scaled(cloud.scale_mm),
            out_of_plane_rms_mm: None,
            degrees_of_freedom: 0,
            covariance: None,
            coverage_rad: None,
            condition: 1.0,
            compensation: None,
            method: "principal directions of the centred points",
            iterations: 0,
            termination: Termination::StepVanished,
            warnings: Vec::new(),
        }
    }

    /// Orthogonal distance of a point, positive outside (circle, sphere, cylinder, cone, torus), on the side of
    /// the normal (plane) or to the left (line in the plane); a line in space has distances without sign. For a
    /// circle in space the distance from the circle within its plane; in the plane z is not looked at. Of a
    /// compensated fit it is the distance from what the probe touched.
    pub fn residual_mm(&self, point_mm: Vector) -> f64 {
        let mut w = minus(point_mm, self.point_mm);
        if matches!(self.element, Element::Line2d | Element::Circle2d) {
            w[2] = 0.0;
        }
        let d = self.direction.unwrap_or([0.0, 0.0, 1.0]);
        let (rho, t) = (norm(cross(d, w)), dot(w, d));
        let radius = self.radius_mm.unwrap_or(0.0);
        match self.element {
            Element::Line2d => d[0] * w[1] - d[1] * w[0],
            Element::Plane => t,
            Element::Sphere => norm(w) - radius,
            Element::Line | Element::Circle2d | Element::Circle3d | Element::Cylinder => rho - radius,
            Element::Cone => {
                let (sin, cos) = (self.apex_angle_rad.unwrap_or(0.0) / 2.0).sin_cos();
                (rho - radius) * cos - t * sin
            }
            Element::Torus => (rho - radius).hypot(t) - self.minor_radius_mm.unwrap_or(0.0),
        }
    }

    /// Root of the mean square of the residuals.
    pub fn rms_mm(&self) -> f64 {
        self.residuals.rms
    }

    /// Largest residual without its sign.
    pub fn max_mm(&self) -> f64 {
        self.residuals.most.max(-self.residuals.least)
    }

    /// Form deviation, peak to valley: largest less smallest residual; for a line in space the diameter about it.
    pub fn form_mm(&self) -> f64 {
        if self.element == Element::Line {
            return 2.0 * self.max_mm();
        }
        self.residuals.most - self.residuals.least
    }

    /// How much of the circumference has points, in degrees.
    pub fn coverage_deg(&self) -> Option<f64> {
        self.coverage_rad.map(f64::to_degrees)
    }

    /// Apex of a cone; `None` for other elements.
    pub fn apex_mm(&self) -> Option<Vector> {
        let (d, r, angle) = (self.direction?, self.radius_mm?, self.apex_angle_rad?);
        let back = r / (angle / 2.0).tan();
        let p = self.point_mm;
        back.is_finite().then(|| [p[0] - back * d[0], p[1] - back * d[1], p[2] - back * d[2]])
    }

    /// Standard uncertainties; `None` without redundancy.
    pub fn standard_uncertainty(&self) -> Option<StandardUncertainty> {
        let c = &self.covariance?.0;
        let root = |i: usize| c.get(i).and_then(|row| row.get(i)).map_or(0.0, |v| v.max(0.0).sqrt());
        let block = |k: usize| {
            let block = [0, 1, 2].map(|i| [0, 1, 2].map(|j| c[k + i][k + j]));
            let (values, _) = crate::math::solve::symmetric_eigen(block);
            values.iter().fold(0.0f64, |m, v| m.max(*v)).sqrt()
        };
        Some(StandardUncertainty {
            point_mm: [root(0), root(1), root(2)],
            point_largest_mm: block(0),
            direction_rad: self.direction.map(|_| block(3)),
            radius_mm: self.radius_mm.map(|_| root(6)),
            minor_radius_mm: self.minor_radius_mm.map(|_| root(7)),
            apex_angle_rad: self.apex_angle_rad.map(|_| root(8)),
        })
    }

    /// Sets the direction to `wanted`, which is `axis` or its opposite; the covariance was found for `axis`.
    pub(super) fn point_along(&mut self, axis: Vector, wanted: Vector) {
        self.direction = Some(wanted);
        let turned = self.covariance.iter_mut().filter(|_| dot(axis, wanted) < 0.0);
        for (i, row) in turned.flat_map(|c| c.0.iter_mut().enumerate()) {
            for (j, v) in row.iter_mut().enumerate() {
                if (3..6).contains(&i) != (3..6).contains(&j) {
                    *v = -*v;
                }
            }
        }
    }

    /// Adds the warnings that follow from redundancy and from how well the radius is known.
    pub(super) fn with_warnings(mut self) -> Self {
        if self.degrees_of_freedom == 0 {
            let what = format!(
                "the {} has no redundant point: residuals are zero and no uncertainty can be stated",
                self.element
            );
            self.warnings.push(Message::warning(what).hint("measure more points than the minimum"));
        }
        let uncertain = self.standard_uncertainty().and_then(|u| Some((u.radius_mm?, self.radius_mm?)));
        // k = 2 (95 %) above a tenth of the radius: the size is a guess
        if let Some((u, radius)) = uncertain.filter(|(u, radius)| 2.0 * u > 0.1 * radius) {
            let covered = self.coverage_deg().map_or(String::new(), |d| format!(" over {d:.0} degrees"));
            let what = format!(
                "the radius {radius:.6} mm of the {} has an expanded uncertainty of {:.2e} mm (k = 2){covered}",
                self.element,
                2.0 * u
            );
            let hint = "measure a longer arc, or hold the radius at its nominal value";
            self.warnings.push(Message::warning(what).hint(hint));
        }
        self
    }
}

/// `d` or its opposite, so that its largest component is positive.
pub(super) fn largest_component_positive(d: Vector) -> Vector {
    let largest = d.iter().fold(0.0f64, |m, x| if x.abs() > m.abs() + 1e-9 { *x } else { m });
    if largest < 0.0 { d.map(|x| -x) } else { d }
}
