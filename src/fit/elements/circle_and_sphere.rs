//! Circle in the plane, circle in space, and sphere; the residual is the distance from the centre
//! minus the radius.

use crate::chart::Chart;
use crate::cloud::{Cloud, Gather, SAMPLE, Source};
use crate::coverage::{Arc, Cap};
use crate::element::{CircleMethod, Element, FitSettings};
use crate::f64x8::{F64x8, Points, along, less, square};
use crate::line_and_plane::{diagonal_matrix, normal_uncertainty, plane_variances};
use crate::result::{ElementCovariance, Fit, QUANTITIES, Residuals, largest_component_positive, propagate};
use crate::solver::{Refined, Surface, refine};
use etalon_base::message::Result;
use etalon_base::phrase;
use etalon_base::pose::Vector;
use etalon_math::{smallest_eigenvector, symmetric_eigen};

/// Fits a circle in the plane to at least three non-collinear points; z of its centre is zero.
///
/// Minimises orthogonal distances from Taubin's solution (Chernov 2010, "Circular and linear
/// regression", 4 and 5).
///
/// # Examples
///
/// ```
/// use etalon_fit::{FitSettings, circle2d};
///
/// // corners of a rectangle of 6 mm by 8 mm: the diagonal, 10 mm, is the diameter of their circle
/// let corners_mm = [[0.0, 0.0], [6.0, 0.0], [6.0, 8.0], [0.0, 8.0]];
/// let fit = circle2d(&corners_mm, &FitSettings::default())?;
///
/// let [x_mm, y_mm, _] = fit.geometry.point_mm;
/// assert!((x_mm - 3.0).abs() < 1e-12 && (y_mm - 4.0).abs() < 1e-12);
/// assert!((fit.geometry.radius_mm.expect("a circle has a radius") - 5.0).abs() < 1e-12);
/// # Ok::<(), etalon_base::message::Problems>(())
/// ```
pub fn circle2d(points: &[[f64; 2]], settings: &FitSettings) -> Result<Fit> {
    settings.check(Element::Circle2d)?;
    let cloud = Cloud::new(Element::Circle2d, Source::Plane(points), settings)?;
    let chart = Chart { d0: [0.0, 0.0, 1.0], e1: [1.0, 0.0, 0.0], e2: [0.0, 1.0, 0.0] };
    let refined = refine_circle(&cloud, chart, settings);
    let [x, y, radius] = refined.x;
    let mut fit = refined.to_fit(Element::Circle2d, &cloud, [x, y, 0.0], Arc::about(&chart, [x, y, 0.0]))?;
    fit.geometry.radius_mm = Some(radius * cloud.scale_mm);
    fit.finished(settings)
}

/// Circle through the points of `cloud`, projected along the axis of `chart`.
fn refine_circle(cloud: &Cloud, chart: Chart, settings: &FitSettings) -> Refined<Disc, 3> {
    let few: Vec<Vector> = cloud.thinned(SAMPLE).points().map(|q| chart.flat(q)).collect();
    let (centre, radius) = taubin::<3>(&few);
    let held = settings.held_radius_mm().map(|r| r / cloud.scale_mm);
    let start = [centre[0], centre[1], held.unwrap_or(radius)];
    refine(Disc { chart }, cloud, start, [true, true, held.is_none()])
}

/// Circle in the plane of `chart`, for points projected along its axis. Parameters: centre (a, b)
/// and radius.
#[derive(Clone, Copy)]
pub(crate) struct Disc {
    pub chart: Chart,
}

impl Surface<3, 1> for Disc {
    #[inline(always)]
    fn distances(&self, x: &[f64; 3], q: Points) -> [(F64x8, [F64x8; 3]); 1] {
        let [u, v, _] = self.chart.seen(q, [x[0], x[1], 0.0]);
        let (rho, inverse) = (u * u).plus(v, v).roots(x[2]);
        [(rho - x[2], [-(u * inverse), -(v * inverse), F64x8::all(-1.0)])]
    }

    fn recharted(&self, x: &[f64; 3]) -> (Self, [f64; 3]) {
        (*self, *x)
    }

    fn quantities(&self, _x: &[f64; 3]) -> [[f64; QUANTITIES]; 3] {
        one_to_one([0, 1, 6])
    }
}

/// Fits a circle in space to at least three non-collinear points, by either of its two definitions.
///
/// NIST's reference pairs and most CMM software fit a plane, project the points onto it and fit the
/// circle in the plane. The full orthogonal distance to the curve gives a different result: 0.9
/// µrad in the normal for NIST's set 25.
pub fn circle3d(points: &[Vector], settings: &FitSettings) -> Result<Fit> {
    fit_circle3d(points.into(), settings)
}

pub(crate) fn fit_circle3d(points: Source, settings: &FitSettings) -> Result<Fit> {
    let held = settings.check(Element::Circle3d)?;
    let cloud = Cloud::new(Element::Circle3d, points, settings)?;
    let normal = largest_component_positive(held.unwrap_or(cloud.axes[2]));
    let heights = Residuals::from_distances(&cloud, |q| along(q, normal));
    let (chart, variances) = plane_variances(&cloud, normal, held.is_some(), heights.squares);
    let circle = refine_circle(&cloud, chart, settings);
    let [a, b, radius] = circle.x;
    if settings.circle == CircleMethod::Orthogonal {
        return orthogonal(&cloud, chart, [a, b, 0.0, 0.0, 0.0, radius], held.is_some(), settings);
    }
    let centre = chart.point(a, b, 0.0);
    let mut fit = circle.to_fit(Element::Circle3d, &cloud, centre, Arc::about(&chart, centre))?;
    let variance = cloud.variance(circle.cost, fit.precision.degrees_of_freedom);
    let local = variance.and_then(|variance| circle.covariance(variance));
    fit.precision.covariance =
        variances.zip(local).map(|(plane, circle)| both(&chart, plane, circle, [a, b], cloud.scale_mm));
    fit.out_of_plane_rms_mm = Some(heights.rms * cloud.scale_mm);
    fit.solver.method = phrase!("method-circle-in-plane");
    fit.precision.principal_rad = normal_uncertainty(&cloud).filter(|_| held.is_none());
    fit.geometry.direction = Some(normal);
    fit.geometry.radius_mm = Some(radius * cloud.scale_mm);
    fit.finished(settings)
}

/// Combined covariance of a plane (a, b, h, u, v) and of a circle (a, b, r) about `centre` in it,
/// which share no residual.
fn both(chart: &Chart, plane: [f64; 5], circle: [[f64; 3]; 3], centre: [f64; 2], scale_mm: f64) -> ElementCovariance {
    let mut local = [[0.0; 6]; 6];
    for (row, p) in local.iter_mut().zip(diagonal_matrix(plane)) {
        row[..5].copy_from_slice(&p);
    }
    for (i, k) in [(0, 0), (1, 1), (2, 5)] {
        for (j, l) in [(0, 0), (1, 1), (2, 5)] {
            local[k][l] = circle[i][j];
        }
    }
    let mut by_parameter = chart.quantities::<6>();
    by_parameter[5][6] = 1.0;
    // the plane t = h − u x − v y moves the centre (a, b)
    for (row, along) in [(3, centre[0]), (4, centre[1])] {
        for (quantity, d) in by_parameter[row].iter_mut().zip(chart.d0) {
            *quantity -= along * d;
        }
    }
    propagate(&local, &by_parameter, scale_mm)
}

/// Circle in space. Parameters: axis (a, b, h, u, v) and radius; two distances per point: in the
/// plane and from the plane.
#[derive(Clone, Copy)]
pub(crate) struct Ring {
    pub(crate) chart: Chart,
}

impl Surface<6, 2> for Ring {
    #[inline(always)]
    fn distances(&self, x: &[f64; 6], q: Points) -> [(F64x8, [F64x8; 6]); 2] {
        let at = self.chart.cylindrical([x[0], x[1], x[2]], x[5], q);
        let widen = |d: [F64x8; 5], radius: f64| [d[0], d[1], d[2], d[3], d[4], F64x8::all(radius)];
        [(at.rho - x[5], widen(at.d_rho, -1.0)), (at.t, widen(at.d_t, 0.0))]
    }

    #[inline(always)]
    fn residual([within, above]: [F64x8; 2]) -> F64x8 {
        (within * within + above * above).sqrt()
    }

    fn recharted(&self, x: &[f64; 6]) -> (Self, [f64; 6]) {
        let (chart, x) = self.chart.moved(x);
        (Self { chart }, x)
    }

    fn quantities(&self, _x: &[f64; 6]) -> [[f64; QUANTITIES]; 6] {
        let mut by_parameter = self.chart.quantities::<6>();
        by_parameter[5][6] = 1.0;
        by_parameter
    }
}

fn orthogonal(cloud: &Cloud, chart: Chart, start: [f64; 6], axis_held: bool, settings: &FitSettings) -> Result<Fit> {
    let mut start = start;
    if let Some(radius) = settings.held_radius_mm() {
        start[5] = radius / cloud.scale_mm;
    }
    let free = [true, true, true, !axis_held, !axis_held, settings.radius_mm.is_none()];
    let refined = refine(Ring { chart }, cloud, start, free);
    let chart = refined.surface.chart;
    let [a, b, h, _, _, radius] = refined.x;
    let centre = chart.point(a, b, h);
    let mut fit = refined.to_fit(Element::Circle3d, cloud, centre, Arc::about(&chart, centre))?;
    // largest component positive, independent of the orientation of the chart
    fit.point_along(chart.d0, largest_component_positive(chart.d0));
    let heights = Residuals::from_distances(cloud, |q| chart.seen(q, [a, b, h])[2]);
    fit.circle = CircleMethod::Orthogonal;
    fit.precision.principal_rad = normal_uncertainty(cloud).filter(|_| !axis_held);
    fit.out_of_plane_rms_mm = Some(heights.rms * cloud.scale_mm);
    fit.geometry.radius_mm = Some(radius * cloud.scale_mm);
    fit.finished(settings)
}

/// Fits a sphere to at least four non-coplanar points.
///
/// Minimises orthogonal distances (Shakarji 1998, 3.3) from Taubin's solution.
///
/// # Examples
///
/// ```
/// use etalon_fit::{FitSettings, Probe, Side, sphere};
///
/// // centres of a probe of radius 2 mm that touched a ball at the origin from five sides
/// let a = 12.0;
/// let centres_mm = [[a, 0.0, 0.0], [-a, 0.0, 0.0], [0.0, a, 0.0], [0.0, -a, 0.0], [0.0, 0.0, a]];
/// let probe = Some(Probe { radius_mm: 2.0, side: Side::Outside });
/// let ball = sphere(&centres_mm, &FitSettings { probe, ..FitSettings::default() })?;
///
/// assert!((ball.geometry.radius_mm.expect("a sphere has a radius") - 10.0).abs() < 1e-12);
/// assert!(ball.max_mm() < 1e-12);
/// # Ok::<(), etalon_base::message::Problems>(())
/// ```
pub fn sphere(points: &[Vector], settings: &FitSettings) -> Result<Fit> {
    fit_sphere(points.into(), settings)
}

pub(crate) fn fit_sphere(points: Source, settings: &FitSettings) -> Result<Fit> {
    settings.check(Element::Sphere)?;
    let cloud = Cloud::new(Element::Sphere, points, settings)?;
    let (start, radius) = taubin::<4>(&cloud.thinned(SAMPLE).points().collect::<Vec<_>>());
    let held = settings.held_radius_mm().map(|r| r / cloud.scale_mm);
    let start = [start[0], start[1], start[2], held.unwrap_or(radius)];
    let refined = refine(Ball, &cloud, start, [true, true, true, held.is_none()]);
    let [x, y, z, radius] = refined.x;
    // derivatives with respect to the centre are unit vectors, with respect to the radius one, both
    // with negative sign
    let [mean_x, mean_y, mean_z, _] = refined.products.map(|row| row[3]);
    let cap = Cap::about([x, y, z], radius, [mean_x, mean_y, mean_z]);
    let mut fit = refined.to_fit(Element::Sphere, &cloud, [x, y, z], cap)?;
    fit.geometry.radius_mm = Some(radius * cloud.scale_mm);
    fit.finished(settings)
}

/// Sphere. Parameters: centre (x, y, z) and radius.
#[derive(Clone, Copy)]
pub(crate) struct Ball;

impl Surface<4, 1> for Ball {
    #[inline(always)]
    fn distances(&self, x: &[f64; 4], q: Points) -> [(F64x8, [F64x8; 4]); 1] {
        let w = less(q, [x[0], x[1], x[2]]);
        let (rho, inverse) = square(w).roots(x[3]);
        let [gx, gy, gz] = [w[0] * inverse, w[1] * inverse, w[2] * inverse];
        [(rho - x[3], [-gx, -gy, -gz, F64x8::all(-1.0)])]
    }

    fn recharted(&self, x: &[f64; 4]) -> (Self, [f64; 4]) {
        (*self, *x)
    }

    fn quantities(&self, _x: &[f64; 4]) -> [[f64; QUANTITIES]; 4] {
        one_to_one([0, 1, 2, 6])
    }
}

fn one_to_one<const N: usize>(quantities: [usize; N]) -> [[f64; QUANTITIES]; N] {
    quantities.map(|quantity| {
        let mut row = [0.0; QUANTITIES];
        row[quantity] = 1.0;
        row
    })
}

/// Taubin's algebraic circle (`M` = 3) or sphere (`M` = 4): centre and radius.
///
/// Taubin 1991, IEEE Trans. PAMI 13, 1115, in the form of Chernov 2010, "Circular and linear
/// regression", 5.9-5.10: the smallest eigenvector of the moments of ((z − z̄)/(2√z̄), x, y), where
/// z = x² + y². In contrast to Kasa's fit, the bias on short arcs is small.
pub(crate) fn taubin<const M: usize>(points: &[Vector]) -> (Vector, f64) {
    let count = points.len().max(1) as f64;
    let (sum, _) = Cloud::about([0.0; 3], points).gather(Sums::<M>::default());
    let centre = sum.map(|s| s / count);
    let centred = Cloud::about(centre, points);
    let mean = centred.gather(Sums::<M>::default()).1 / count;
    if mean <= 0.0 || mean.is_nan() {
        return (centre, 0.0);
    }
    let moments = centred.gather(Moments::<M> { mean, sums: [[F64x8::default(); M]; M] });
    let v: [f64; M] = if M == 3 {
        let v = smallest_eigenvector([0, 1, 2].map(|i| [0, 1, 2].map(|j| moments[i][j])));
        std::array::from_fn(|i| v[i])
    } else {
        symmetric_eigen(moments).1[0]
    };
    let normal = v[1..].iter().map(|x| x * x).sum::<f64>().sqrt();
    // collinear points have curvature zero: start with a radius of 1e6 sizes
    let least = 1e-6 * normal.max(1e-6);
    let curvature = v[0] / (2.0 * mean.sqrt());
    let curvature = if curvature.abs() < least { least.copysign(curvature) } else { curvature };
    let mut middle = centre;
    for (c, x) in middle.iter_mut().zip(&v[1..]) {
        *c -= x / (2.0 * curvature);
    }
    let radius = (normal * normal + 4.0 * mean * curvature * curvature).sqrt() / (2.0 * curvature.abs());
    (middle, radius)
}

/// Sums of the first `M` − 1 coordinates and of squared distances in these coordinates.
#[derive(Clone, Default)]
struct Sums<const M: usize> {
    coordinates: Points,
    squares: F64x8,
}

impl<const M: usize> Gather for Sums<M> {
    type Sum = (Vector, f64);

    #[inline(always)]
    fn take(&mut self, q: Points, w: F64x8) {
        for (sum, q) in self.coordinates.iter_mut().zip(q).take(M - 1) {
            *sum = sum.plus(w, q);
            self.squares = self.squares.plus(w * q, q);
        }
    }

    fn close(self) -> Self::Sum {
        (self.coordinates.map(F64x8::sum), self.squares.sum())
    }

    fn join(a: Self::Sum, b: Self::Sum) -> Self::Sum {
        ([0, 1, 2].map(|k| a.0[k] + b.0[k]), a.1 + b.1)
    }
}

/// Products of ((z - z̄)/(2√z̄), x, y, ...).
#[derive(Clone)]
struct Moments<const M: usize> {
    mean: f64,
    sums: [[F64x8; M]; M],
}

impl<const M: usize> Gather for Moments<M> {
    type Sum = [[f64; M]; M];

    #[inline(always)]
    fn take(&mut self, q: Points, w: F64x8) {
        let mut row = [F64x8::default(); M];
        row[1..].copy_from_slice(&q[..M - 1]);
        let z = row[1..].iter().fold(F64x8::default(), |sum, x| sum.plus(*x, *x));
        row[0] = (z - self.mean) * (0.5 / self.mean.sqrt());
        for (line, x) in self.sums.iter_mut().zip(row) {
            for (sum, y) in line.iter_mut().zip(row) {
                *sum = sum.plus(w * x, y);
            }
        }
    }

    fn close(self) -> Self::Sum {
        self.sums.map(|line| line.map(F64x8::sum))
    }

    fn join(mut a: Self::Sum, b: Self::Sum) -> Self::Sum {
        for (a, b) in a.iter_mut().flatten().zip(b.iter().flatten()) {
            *a += b;
        }
        a
    }
}
