//! Result of a fit: element, residuals, uncertainty and termination of the solver. If the points
//! are centres of a probe, the result is the touched element.
//!
//! The centres of a probe that touches a surface lie on its parallel surface x + r n (do Carmo
//! 1976, "Differential geometry of curves and surfaces", section 3.5, exercise 11). Orthogonal
//! distances to parallel surfaces differ by the constant r. The element is therefore fitted to the
//! centres as measured and then offset by r. No point is moved, residuals and their variance are
//! unchanged, and the result equals a fit to the contact points.

use super::cloud::{Cloud, Gather};
use super::element::{CircleMethod, Element, FitSettings, Probe, Side};
use super::f64x8::{F64x8, Points};
use super::geometry::ElementGeometry;
use etalon_base::catalogue::{IntoArgument, Phrase};
use etalon_base::message::{Message, Problems, Result};
use etalon_base::pose::{Vector, cross, dot, minus, norm, unit};
use etalon_base::{error, phrase, warning};
use etalon_math::{Termination, symmetric_eigen};
use statrs::distribution::{ContinuousCDF, StudentsT};

/// Number of quantities in an [`ElementCovariance`].
pub const QUANTITIES: usize = 9;

/// Covariance of point (x, y, z, mm), direction (x, y, z), radius (mm), minor radius (mm) and apex
/// angle (rad), in this order. Rows and columns of absent or held quantities are zero.
///
/// First-order propagation of σ² (JᵀJ)⁻¹, where σ² is the stated variance of a distance, or the
/// variance of the residuals.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ElementCovariance(pub [[f64; QUANTITIES]; QUANTITIES]);

/// G C Gᵀ, with lengths converted from normalised units to mm (JCGM 102:2011, 6.2.1.3).
pub(super) fn propagate<const N: usize>(
    local: &[[f64; N]; N],
    by_parameter: &[[f64; QUANTITIES]; N],
    scale_mm: f64,
) -> ElementCovariance {
    let unit = |q: usize| if q < 3 || q == 6 || q == 7 { scale_mm } else { 1.0 };
    let mut covariance = [[0.0; QUANTITIES]; QUANTITIES];
    for (i, gi) in by_parameter.iter().enumerate() {
        for (j, gj) in by_parameter.iter().enumerate() {
            for (p, row) in covariance.iter_mut().enumerate() {
                for (q, c) in row.iter_mut().enumerate() {
                    *c += gi[p] * unit(p) * local[i][j] * gj[q] * unit(q);
                }
            }
        }
    }
    ElementCovariance(covariance)
}

/// Standard uncertainties: square roots of the diagonal of an [`ElementCovariance`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StandardUncertainty {
    /// Standard uncertainty of each coordinate of the point.
    pub point_mm: Vector,
    /// Standard uncertainty of the point in its most uncertain direction.
    pub point_largest_mm: f64,
    /// Standard uncertainty of the direction about its most uncertain axis.
    pub direction_rad: Option<f64>,
    /// Standard uncertainty of the radius.
    pub radius_mm: Option<f64>,
    /// Standard uncertainty of the minor radius of a torus.
    pub minor_radius_mm: Option<f64>,
    /// Standard uncertainty of the full apex angle of a cone.
    pub apex_angle_rad: Option<f64>,
}

/// Statistics of the residuals (mm).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Residuals {
    /// Root mean square.
    pub rms: f64,
    /// Smallest residual.
    pub least: f64,
    /// Largest residual.
    pub most: f64,
    /// Weighted sum of squares over all equations.
    pub squares: f64,
}

impl Residuals {
    /// Residuals of all points from their distances.
    pub(super) fn from_distances(cloud: &Cloud, distance: impl Fn(Points) -> F64x8 + Sync) -> Self {
        Self::and(
            cloud,
            #[inline(always)]
            |q| {
                let distance = distance(q);
                (distance, [distance])
            },
            (),
        )
        .0
    }

    /// Residuals of all points, whose `K` minimised distances are beside the residual, and another
    /// accumulator in one pass over the points.
    pub(super) fn and<const K: usize, G: Gather>(
        cloud: &Cloud,
        distances: impl Fn(Points) -> (F64x8, [F64x8; K]) + Sync,
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

/// Accumulates weighted squares of all distances of a point, and squares, minimum and maximum of
/// its residual.
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

impl<const K: usize, F: Fn(Points) -> (F64x8, [F64x8; K]) + Sync> Gather for Remaining<'_, F> {
    type Sum = [f64; 4];

    #[inline(always)]
    fn take(&mut self, q: Points, w: F64x8) {
        let (residual, distances) = (self.distances)(q);
        for d in distances {
            self.squares = self.squares.plus(w * d, d);
        }
        self.plain = self.plain.plus(w.presence() * residual, residual);
        self.least = self.least.min(residual);
        self.most = self.most.max(residual);
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
    /// Fitted element.
    pub element: Element,
    /// Method of a circle in space, which determines its residuals.
    pub circle: CircleMethod,
    /// Position, direction and size.
    pub geometry: ElementGeometry,
    /// Number of points.
    pub points: usize,
    /// Orthogonal distances of all points; [`Fit::residual_mm`] returns the distance of a single
    /// point.
    pub residuals: Residuals,
    /// For a circle in space: root mean square distance of the points from its plane.
    pub out_of_plane_rms_mm: Option<f64>,
    /// Redundancy, and uncertainty of the geometry.
    pub precision: FitPrecision,
    /// Covered part of the circumference: full turn minus the largest gap; for a sphere the full
    /// angle of the cap that contains the points.
    pub coverage_rad: Option<f64>,
    /// Condition number of the Jacobian with columns scaled to unit length.
    pub condition: f64,
    /// Fit to the probe centres before compensation, if the points are probe centres.
    pub compensation: Option<Compensation>,
    /// Method and its end.
    pub solver: FitSolver,
    /// Warnings for users of the numbers.
    pub warnings: Vec<Message>,
}

/// Redundancy of a fit, and uncertainty of its geometry.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FitPrecision {
    /// Number of equations minus number of parameters.
    pub degrees_of_freedom: usize,
    /// Covariance of the quantities; `None` without redundancy, unless the uncertainty of the
    /// points is stated.
    pub covariance: Option<ElementCovariance>,
    /// Variance (mm²) of the distance of a point of mean weight, from which the covariance follows.
    pub variance_mm2: Option<f64>,
    /// `true` if the uncertainty of the points is stated.
    pub is_stated: bool,
    /// Standard uncertainty (rad) of a direction that is a principal direction of the points, by
    /// [`principal_uncertainty`].
    pub(super) principal_rad: Option<f64>,
}

impl FitPrecision {
    /// Redundancy of a fit to the points of `cloud`, with the variance of a distance in normalised
    /// units.
    pub(super) fn new(cloud: &Cloud, degrees_of_freedom: usize, variance: Option<f64>) -> Self {
        Self {
            degrees_of_freedom,
            variance_mm2: variance.map(|v| v * cloud.scale_mm * cloud.scale_mm),
            is_stated: cloud.standard_uncertainty_mm.is_some(),
            ..Self::default()
        }
    }

    /// Coverage factor of an expanded uncertainty with a probability of 95.45 %: Student's t with
    /// the degrees of freedom (GUM G.3), 2 for a stated uncertainty; `None` without uncertainty.
    pub fn coverage_factor(&self) -> Option<f64> {
        self.covariance?;
        if self.is_stated {
            return Some(STATED_FACTOR);
        }
        let (degrees, z) = (self.degrees_of_freedom as f64, STATED_FACTOR);
        if self.degrees_of_freedom > MANY {
            // Abramowitz & Stegun 26.7.5
            return Some(z + (z.powi(3) + z) / (4.0 * degrees));
        }
        let student = StudentsT::new(0.0, 1.0, degrees).ok()?;
        Some(student.inverse_cdf(0.5 * (1.0 + COVERAGE)))
    }

    /// Ratio of the residuals to the stated uncertainty of the points, if it is significant.
    /// `squares` is the weighted sum of squares (mm²). By the cube root of chi-square over its
    /// degrees of freedom, which is nearly normal (Wilson & Hilferty 1931).
    fn excess(&self, squares: f64) -> Option<f64> {
        let degrees = Some(self.degrees_of_freedom as f64).filter(|nu| self.is_stated && *nu > 0.0)?;
        let ratio = squares / (degrees * self.variance_mm2?);
        let spread = 2.0 / (9.0 * degrees);
        (ratio.cbrt() > 1.0 - spread + SIGNIFICANT * spread.sqrt()).then(|| ratio.sqrt())
    }
}

/// Probability of the interval of value ± expanded uncertainty; of a normal distribution, two
/// standard deviations.
const COVERAGE: f64 = 0.954_499_736_103_642;
/// Coverage factor for a stated uncertainty.
const STATED_FACTOR: f64 = 2.0;
/// Number of degrees of freedom beyond which a series gives Student's quantile to 1e-6.
const MANY: usize = 2000;
/// Normal quantile of a probability of 0.1 % that residuals exceed the stated uncertainty by
/// chance.
const SIGNIFICANT: f64 = 3.0902;

/// Method of a fit, and how it ended.
#[derive(Clone, Debug, PartialEq)]
pub struct FitSolver {
    /// Name of the method.
    pub method: Phrase,
    /// Number of steps; zero for closed-form solutions.
    pub iterations: usize,
    /// Reason of the termination.
    pub termination: Termination,
}

/// Standard uncertainty (rad) of the direction that separates two principal spreads of points:
/// √(ρ/ν) / (ρ − 1) for the ratio ρ of their squares and ν degrees of freedom of the smaller one
/// (Anderson 1963, Ann. Math. Statist. 34, 122, 2.11). As ln ρ has the standard uncertainty 2/√ν,
/// it is the relative uncertainty of the ratio over twice its distance from one, and infinite where
/// both spreads are alike. `None` without redundancy.
pub(super) fn principal_uncertainty(larger: f64, smaller: f64, degrees_of_freedom: usize) -> Option<f64> {
    let apart = (larger - smaller) * (larger + smaller);
    let root = (degrees_of_freedom as f64).sqrt();
    (degrees_of_freedom > 0).then(|| if apart > 0.0 { larger * smaller / (root * apart) } else { f64::INFINITY })
}

/// Standard uncertainty (rad) of a principal direction from which the ratio of both spreads is not
/// distinguishable from one (k = 2).
const ALIKE: f64 = 0.25;
/// Maximum expanded uncertainty (95 %) of a radius, relative to the radius, and of a direction
/// (rad) without a warning.
const UNRELIABLE: f64 = 0.1;

impl Fit {
    /// Creates a closed-form fit with its point only; `residuals` are in normalised units.
    pub(super) fn new(element: Element, cloud: &Cloud, point: Vector, residuals: Residuals) -> Self {
        Self {
            element,
            circle: CircleMethod::Projected,
            geometry: ElementGeometry { point_mm: cloud.to_mm(point), ..ElementGeometry::default() },
            points: cloud.len(),
            residuals: residuals.scaled(cloud.scale_mm),
            out_of_plane_rms_mm: None,
            precision: FitPrecision::default(),
            coverage_rad: None,
            condition: 1.0,
            compensation: None,
            solver: FitSolver {
                method: phrase!("method-principal-directions"),
                iterations: 0,
                termination: Termination::StepVanished,
            },
            warnings: Vec::new(),
        }
    }

    /// Orthogonal distance of a point: positive outside (circle, sphere, cylinder, cone, torus), on
    /// the side of the normal (plane), or to the left (line in the plane); unsigned for a line in
    /// space. For a circle in space, the distance within its plane from the circle; if it was
    /// fitted by orthogonal distances, the unsigned distance from the curve. In the plane z is
    /// ignored. For a compensated fit, the distance from the touched surface.
    pub fn residual_mm(&self, point_mm: Vector) -> f64 {
        let mut w = minus(point_mm, self.geometry.point_mm);
        if matches!(self.element, Element::Line2d | Element::Circle2d) {
            w[2] = 0.0;
        }
        let d = self.geometry.direction.unwrap_or([0.0, 0.0, 1.0]);
        let (rho, t) = (norm(cross(d, w)), dot(w, d));
        let radius = self.geometry.radius_mm.unwrap_or(0.0);
        match self.element {
            Element::Line2d => d[0] * w[1] - d[1] * w[0],
            Element::Plane => t,
            Element::Sphere => norm(w) - radius,
            Element::Circle3d if self.circle == CircleMethod::Orthogonal => (rho - radius).hypot(t),
            Element::Line | Element::Circle2d | Element::Circle3d | Element::Cylinder => rho - radius,
            Element::Cone => {
                let (sin, cos) = (self.geometry.apex_angle_rad.unwrap_or(0.0) / 2.0).sin_cos();
                (rho - radius) * cos - t * sin
            }
            Element::Torus => (rho - radius).hypot(t) - self.geometry.minor_radius_mm.unwrap_or(0.0),
        }
    }

    /// Root mean square of the residuals.
    pub fn rms_mm(&self) -> f64 {
        self.residuals.rms
    }

    /// Largest absolute residual.
    pub fn max_mm(&self) -> f64 {
        self.residuals.most.max(-self.residuals.least)
    }

    /// Form deviation, peak to valley: largest minus smallest residual; for a line in space, or a
    /// circle by orthogonal distances, the diameter of the enclosing tube about it.
    pub fn form_mm(&self) -> f64 {
        let unsigned = self.element == Element::Circle3d && self.circle == CircleMethod::Orthogonal;
        if self.element == Element::Line || unsigned {
            return 2.0 * self.max_mm();
        }
        self.residuals.most - self.residuals.least
    }

    /// Covered part of the circumference (degrees).
    pub fn coverage_deg(&self) -> Option<f64> {
        self.coverage_rad.map(f64::to_degrees)
    }

    /// Standard uncertainties; `None` without redundancy.
    pub fn standard_uncertainty(&self) -> Option<StandardUncertainty> {
        let c = &self.precision.covariance?.0;
        let root = |i: usize| c.get(i).and_then(|row| row.get(i)).map_or(0.0, |v| v.max(0.0).sqrt());
        let block = |k: usize| {
            let block = [0, 1, 2].map(|i| [0, 1, 2].map(|j| c[k + i][k + j]));
            let (values, _) = symmetric_eigen(block);
            values.iter().fold(0.0f64, |m, v| m.max(*v)).sqrt()
        };
        Some(StandardUncertainty {
            point_mm: [root(0), root(1), root(2)],
            point_largest_mm: block(0),
            direction_rad: self.geometry.direction.map(|_| block(3)),
            radius_mm: self.geometry.radius_mm.map(|_| root(6)),
            minor_radius_mm: self.geometry.minor_radius_mm.map(|_| root(7)),
            apex_angle_rad: self.geometry.apex_angle_rad.map(|_| root(8)),
        })
    }

    /// Sets the direction to `wanted`, which is `axis` or its opposite; the covariance belongs to
    /// `axis`.
    pub(super) fn point_along(&mut self, axis: Vector, wanted: Vector) {
        self.geometry.direction = Some(wanted);
        let turned = self.precision.covariance.iter_mut().filter(|_| dot(axis, wanted) < 0.0);
        for (i, row) in turned.flat_map(|c| c.0.iter_mut().enumerate()) {
            for (j, v) in row.iter_mut().enumerate() {
                if (3..6).contains(&i) != (3..6).contains(&j) {
                    *v = -*v;
                }
            }
        }
    }

    /// Completes the result: compensates for the probe, if any, and adds warnings.
    pub(super) fn finished(self, settings: &FitSettings) -> Result<Self> {
        Ok(self.compensated(settings.probe)?.with_warnings())
    }

    /// Adds warnings about redundancy and the uncertainties of radius and direction.
    fn with_warnings(mut self) -> Self {
        let element = self.element;
        if self.precision.degrees_of_freedom == 0 {
            self.warnings.push(warning!("element-without-redundancy", element));
        }
        if let Some(times) = self.precision.excess(self.residuals.squares) {
            self.warnings.push(warning!("residuals-exceed-points", element, times));
        }
        let uncertainty = self.standard_uncertainty();
        let k = self.precision.coverage_factor().unwrap_or(STATED_FACTOR);
        let direction = self.precision.principal_rad.or_else(|| uncertainty.as_ref().and_then(|u| u.direction_rad));
        let expanded_deg = k * direction.unwrap_or_default().to_degrees();
        if self.precision.principal_rad.is_some_and(|u| u >= ALIKE) {
            self.warnings.push(warning!("element-ambiguous", element));
        } else if expanded_deg.to_radians() > UNRELIABLE {
            self.warnings.push(warning!("element-direction-uncertain", element, expanded_deg));
        }
        let uncertain = uncertainty.and_then(|u| Some((u.radius_mm?, self.geometry.radius_mm?)));
        if let Some((u, radius)) = uncertain.filter(|(u, radius)| k * u > UNRELIABLE * radius) {
            let covered_deg = self.coverage_deg().map_or("none".argument(), |d| d.round().argument());
            self.warnings.push(warning!(
                "radius-uncertain",
                element,
                radius_mm = radius,
                expanded_mm = k * u,
                covered_deg,
            ));
        }
        self
    }
}

/// Returns `d` or its opposite, so that its largest component is positive.
pub(super) fn largest_component_positive(d: Vector) -> Vector {
    let largest = d.iter().fold(0.0f64, |m, x| if x.abs() > m.abs() + 1e-9 { *x } else { m });
    if largest < 0.0 { d.map(|x| -x) } else { d }
}

/// Fit to the probe centres before compensation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Compensation {
    /// Probe.
    pub probe: Probe,
    /// Point of the uncompensated fit.
    pub point_mm: Vector,
    /// Radius of the uncompensated fit.
    pub radius_mm: Option<f64>,
    /// Minor radius of the uncompensated fit.
    pub minor_radius_mm: Option<f64>,
}

/// Sine of the smallest angle (5 degrees) between the given direction and a plane or line at which
/// the direction tells the side of the probe.
const LEAST_SINE: f64 = 0.087;

impl Fit {
    /// Compensates a fit to probe centres: returns the touched element, or the fit unchanged
    /// without a probe.
    ///
    /// # Errors
    ///
    /// Fails if the side does not apply to the element, or if the probe does not fit inside it.
    pub fn compensated(mut self, probe: Option<Probe>) -> Result<Self> {
        let Some(probe) = probe else { return Ok(self) };
        probe.check(self.element)?;
        if self.compensation.is_some() {
            return Err(error!("compensated-twice").into());
        }
        let (point_mm, radius_mm, minor_radius_mm) =
            (self.geometry.point_mm, self.geometry.radius_mm, self.geometry.minor_radius_mm);
        let moves = self.moves(&probe)?;
        if let Some(ElementCovariance(c)) = &mut self.precision.covariance {
            *c = product(&moves, &product(c, &transposed(&moves)));
        }
        self.compensation = Some(Compensation { probe, point_mm, radius_mm, minor_radius_mm });
        Ok(self)
    }

    /// Offsets the element by the probe; returns the derivatives of its quantities with respect to
    /// the values of the uncompensated fit.
    fn moves(&mut self, probe: &Probe) -> Result<[[f64; QUANTITIES]; QUANTITIES]> {
        let mut derivative = identity();
        let outwards = probe.outwards_mm();
        match (self.element, probe.side, self.geometry.direction) {
            (Element::Plane, Side::Towards(to), Some(normal)) => {
                let along = unit(to).map_or(0.0, |to| dot(to, normal));
                if along.abs() < LEAST_SINE {
                    return Err(no_side(self.element, to));
                }
                // p′ = p − r n, with the normal towards the probe
                let back = -probe.radius_mm.copysign(along);
                for k in 0..3 {
                    self.geometry.point_mm[k] += back * normal[k];
                    derivative[k][3 + k] += back;
                }
            }
            (Element::Line | Element::Line2d, Side::Towards(to), Some(d)) => {
                let to = if self.element == Element::Line2d { [to[0], to[1], 0.0] } else { to };
                let to = unit(to).unwrap_or_default();
                let along = dot(to, d);
                let across: Vector = std::array::from_fn(|k| to[k] - along * d[k]);
                let sine = norm(across);
                if sine < LEAST_SINE {
                    return Err(no_side(self.element, to));
                }
                // p′ = p − r w, where w is the component of the direction perpendicular to the
                // line: dw = −(1 − w wᵀ)((d to) dd + d (to dd)) / |across|
                let w = across.map(|x| x / sine);
                for k in 0..3 {
                    self.geometry.point_mm[k] -= probe.radius_mm * w[k];
                    for (j, column) in (3..6).enumerate() {
                        let square = f64::from(k == j) - w[k] * w[j];
                        derivative[k][column] += probe.radius_mm * (along * square + d[k] * to[j]) / sine;
                    }
                }
            }
            (Element::Cone, _, Some(d)) => {
                // the apex moves by r / sin ψ, the point to the foot of the contact points, where
                // the radius is R − r cos ψ
                let (sin, cos) = (self.geometry.apex_angle_rad.unwrap_or_default() / 2.0).sin_cos();
                for k in 0..3 {
                    self.geometry.point_mm[k] += outwards * sin * d[k];
                    derivative[k][3 + k] += outwards * sin;
                    derivative[k][8] += 0.5 * outwards * cos * d[k];
                }
                self.geometry.radius_mm =
                    Some(larger_than_nothing(self.element, probe, self.geometry.radius_mm, outwards * cos)?);
                derivative[6][8] += 0.5 * outwards * sin;
            }
            (Element::Torus, ..) => {
                self.geometry.minor_radius_mm =
                    Some(larger_than_nothing(self.element, probe, self.geometry.minor_radius_mm, outwards)?);
            }
            _ => {
                self.geometry.radius_mm =
                    Some(larger_than_nothing(self.element, probe, self.geometry.radius_mm, outwards)?)
            }
        }
        Ok(derivative)
    }
}

/// Radius minus the contribution of the probe; fails if the result is not positive.
fn larger_than_nothing(element: Element, probe: &Probe, radius_mm: Option<f64>, less_mm: f64) -> Result<f64> {
    let centres = radius_mm.unwrap_or_default();
    let radius = centres - less_mm;
    if radius > 0.0 {
        return Ok(radius);
    }
    let probe_mm = probe.radius_mm;
    Err(error!("probe-larger-than-element", element, probe_mm, centres_mm = centres).into())
}

fn no_side(element: Element, to: Vector) -> Problems {
    error!("probe-direction-along-element", element, direction = format!("{to:?}")).into()
}

type Matrix = [[f64; QUANTITIES]; QUANTITIES];

fn identity() -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| f64::from(i == j)))
}

fn transposed(a: &Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| a[j][i]))
}

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..QUANTITIES).map(|k| a[i][k] * b[k][j]).sum()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{circle2d, line, plane};
    use etalon_base::noise::Noise;

    fn with(standard_uncertainty_mm: f64) -> FitSettings<'static> {
        FitSettings { standard_uncertainty_mm: Some(standard_uncertainty_mm), ..FitSettings::default() }
    }

    /// GUM, table G.2, p = 95.45 %.
    #[test]
    fn coverage_factors_of_few_degrees_of_freedom_are_those_of_the_gum() {
        let factor = |degrees_of_freedom: usize, is_stated: bool| {
            let covariance = Some(ElementCovariance([[0.0; QUANTITIES]; QUANTITIES]));
            let precision = FitPrecision { degrees_of_freedom, covariance, is_stated, ..FitPrecision::default() };
            precision.coverage_factor().unwrap()
        };
        for (degrees, expected) in [(1, 13.97), (2, 4.53), (3, 3.31), (5, 2.65), (10, 2.28), (20, 2.13), (50, 2.05)] {
            assert!((factor(degrees, false) - expected).abs() < 0.0051, "{degrees}: {}", factor(degrees, false));
        }
        assert!((factor(1_000_000, false) - 2.0).abs() < 1e-5);
        // the series follows the quantile
        assert!((factor(MANY, false) - factor(MANY + 1, false)).abs() < 1e-5);
        assert_eq!(factor(1, true), 2.0);
        assert_eq!(FitPrecision::default().coverage_factor(), None);
    }

    #[test]
    fn a_stated_uncertainty_replaces_the_residuals() {
        // normal matrix diag(2, 2, 4) of centre and radius, by hand
        let circle = circle2d(&[[10.0, 0.0], [0.0, 10.0], [-10.0, 0.0], [0.0, -10.0]], &with(0.02)).unwrap();
        let u = circle.standard_uncertainty().unwrap();
        assert!((u.point_largest_mm - 0.02 / 2f64.sqrt()).abs() < 1e-12, "{u:?}");
        assert!((u.radius_mm.unwrap() - 0.01).abs() < 1e-12, "{u:?}");
        assert_eq!((circle.precision.degrees_of_freedom, circle.precision.coverage_factor()), (1, Some(2.0)));
        // no redundancy: two ends of 100 mm, each off by σ across
        let edge = line(&[[0.0, 0.0, 0.0], [100.0, 0.0, 0.0]], &with(0.02)).unwrap();
        let u = edge.standard_uncertainty().unwrap();
        assert!((u.direction_rad.unwrap() - 2f64.sqrt() * 0.02 / 100.0).abs() < 1e-12, "{u:?}");
        assert!(line(&[[0.0; 3], [100.0, 0.0, 0.0]], &FitSettings::default()).unwrap().precision.covariance.is_none());
        // three points: the height of their centroid is known to σ / √3
        let face = plane(&[[0.0, 0.0, 0.0], [100.0, 0.0, 0.0], [0.0, 100.0, 0.0]], &with(0.03)).unwrap();
        let u = face.standard_uncertainty().unwrap();
        assert!((u.point_largest_mm - 0.03 / 3f64.sqrt()).abs() < 1e-12, "{u:?}");
        for wrong in [0.0, -1.0, f64::NAN] {
            let refused = circle2d(&[[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0]], &with(wrong)).unwrap_err();
            assert!(refused.0[0].is("point-uncertainty-not-positive", &[]), "{refused:?}");
        }
    }

    #[test]
    fn residuals_beyond_the_stated_uncertainty_are_named() {
        let mut noise = Noise::new(4, 0);
        let mut point = |i: usize| {
            let (s, c) = (0.3 * i as f64).sin_cos();
            let radius = 20.0 + noise.gaussian(0.01);
            [radius * c, radius * s]
        };
        let points: Vec<[f64; 2]> = (0..20).map(&mut point).collect();
        let warned = |u_mm: f64| {
            let fit = circle2d(&points, &with(u_mm)).unwrap();
            fit.warnings.iter().any(|message| message.is("residuals-exceed-points", &[]))
        };
        assert_eq!([0.003, 0.01, 0.1].map(warned), [true, false, false]);
        // the uncertainty is the stated one
        let u = |fit: Fit| fit.standard_uncertainty().unwrap().point_largest_mm;
        let [small, large] = [0.003, 0.03].map(|u_mm| u(circle2d(&points, &with(u_mm)).unwrap()));
        assert!((large / small - 10.0).abs() < 1e-9);
    }
}
