//! Axis of one joint from the paths of targets while that joint alone moves.
//!
//! Targets of a revolute joint move on coaxial circles, targets of a sliding joint on parallel
//! lines. All paths are fitted together by orthogonal distances (Gauss-Newton; the circle in space
//! of Forbes, NPL report DITC 140/89, with one axis for all circles).

use super::SweepReading;
use etalon_base::noise::Noise;
use etalon_base::pose::{Pose, Vector, cross, dot, minus, norm, unit};
use etalon_math::statistics::median;
use etalon_robots::{AxisLine, frame};
use nalgebra::{DMatrix, DVector};
use std::f64::consts::SQRT_2;

/// Steps of Gauss-Newton.
const STEPS: usize = 60;
/// Convergence tolerance: step in standard uncertainties of a reading.
const CONVERGED: f64 = 1e-10;
/// Number of triples of readings for the search for a start.
const STARTS: u64 = 60;
/// Expected number of correct readings that are excluded in a whole sweep.
const LOST: f64 = 0.01;
/// Minimum number of readings of a sweep at which outliers can be detected.
const FEWEST_TO_JUDGE: usize = 8;
/// Ratio of the standard deviation of the nearest three quarters of residuals to the standard
/// deviation of all: of a component, where lengths have two, √(1 − (ln 4)/3).
const OF_NEAREST: f64 = 0.733;
/// Ratio of the differences of neighbours to the differences of independent readings below which
/// deviations are smooth.
const SMOOTH: f64 = 0.6;
/// Maximum step of a smooth deviation, in medians of all: of waves with several harmonics.
const USUAL_STEPS: f64 = 5.0;
/// Residuals below this share of the size are rounding.
const ROUNDING: f64 = 1e-12;

/// Path of a target about or along the axis of a sweep.
#[derive(Clone, Debug, PartialEq)]
pub struct Path {
    /// Index of the target.
    pub target: usize,
    /// Readings of the path that are used.
    pub readings: usize,
    /// Radius (mm); 0 for a sliding joint.
    pub radius_mm: f64,
    /// Height relative to the point of the axis (mm); 0 for a prismatic joint.
    pub height_mm: f64,
    /// Position across the axis of a prismatic joint (mm).
    pub across_mm: [f64; 2],
    /// Covered arc (rad) or length (mm).
    pub span: f64,
}

impl Path {
    /// Coordinates across the axis that the path holds constant: radius and height, or x and y.
    fn constants(&self, prismatic: bool) -> [f64; 2] {
        if prismatic { self.across_mm } else { [self.radius_mm, self.height_mm] }
    }
}

/// Axis fitted to a sweep, with the quantities that its paths share.
#[derive(Clone, Debug)]
pub struct SweepFit {
    /// Frame of the fit: z along the axis, origin at the point of the axis nearest to the centroid
    /// of the paths.
    pub frame: Pose,
    /// `true` if the joint slides.
    pub prismatic: bool,
    /// Paths of the targets.
    pub paths: Vec<Path>,
    /// Cofactor matrix of the parameters: tilts of the axis about −y and x (rad), for a revolute
    /// joint its shifts along x and y (mm), then two of each path: radius and height, or the place
    /// across the axis (mm).
    pub cofactors: DMatrix<f64>,
    /// Orthogonal residuals of all readings (mm): radial and axial, or along x and y.
    pub residuals_mm: Vec<[f64; 2]>,
    /// `false` for readings that are excluded.
    pub used: Vec<bool>,
    /// Equations minus parameters.
    pub degrees_of_freedom: usize,
    /// Standard deviation of a residual (mm); 0 without redundancy.
    pub deviation_mm: f64,
}

/// Parameters of a path across the axis.
const OF_PATH: usize = 2;

impl SweepFit {
    /// Number of parameters of the axis.
    pub fn axis_parameter_count(&self) -> usize {
        if self.prismatic { 2 } else { 4 }
    }

    /// The axis.
    pub fn axis(&self) -> AxisLine {
        AxisLine { direction: self.frame.axis(2), point_mm: self.frame.translation_mm, prismatic: self.prismatic }
    }

    /// Frame of the fit after small changes of the parameters of the axis.
    pub fn frame_changed(&self, change: &[f64]) -> Pose {
        let shift = if self.prismatic { [0.0; 3] } else { [change[2], change[3], 0.0] };
        let turn = Pose::from_rotation_vector([-change[1], change[0], 0.0]);
        self.frame.then(&Pose { translation_mm: shift, ..turn })
    }

    /// Reverses the axis.
    pub fn reverse(&mut self) {
        // half a turn about x: y and z change sign, and with them tilts, shifts, heights, places
        let [x, z] = [self.frame.axis(0), self.frame.axis(2).map(|v| -v)];
        self.frame = frame(x, z, self.frame.translation_mm);
        let mut sign = vec![-1.0, 1.0];
        if self.prismatic {
            self.paths.iter().for_each(|_| sign.extend([1.0, -1.0]));
        } else {
            sign.extend([1.0, -1.0]);
            self.paths.iter().for_each(|_| sign.extend([1.0, -1.0]));
        }
        let n = self.cofactors.nrows();
        self.cofactors = DMatrix::from_fn(n, n, |i, j| self.cofactors[(i, j)] * sign[i] * sign[j]);
        for path in &mut self.paths {
            path.height_mm = -path.height_mm;
            path.across_mm[1] = -path.across_mm[1];
        }
        self.residuals_mm.iter_mut().for_each(|r| r[1] = -r[1]);
    }

    /// Coefficients of the trend of a component of the residuals of a path (0 or 1), as functions
    /// of the parameters of [`SweepFit::cofactors`].
    pub(super) fn trend_rows(&self, path: usize, component: usize) -> DMatrix<f64> {
        let (of_axis, own) = (self.axis_parameter_count(), self.axis_parameter_count() + OF_PATH * path + component);
        let columns = if self.prismatic { 2 } else { 3 };
        let mut rows = DMatrix::zeros(columns, self.cofactors.nrows());
        let p = &self.paths[path];
        match (self.prismatic, component) {
            (true, k) => rows[(0, k)] = 1.0,
            (false, 0) => {
                for k in 0..2 {
                    rows[(k, k)] = p.height_mm;
                    rows[(k, of_axis - 2 + k)] = 1.0;
                }
            }
            (false, _) => (0..2).for_each(|k| rows[(k, k)] = -p.radius_mm),
        }
        rows[(columns - 1, own)] = 1.0;
        rows
    }

    /// The fit after changes of its parameters.
    pub(super) fn adjusted(&self, readings: &[SweepReading], change: &[f64]) -> Self {
        let targets: Vec<usize> = self.paths.iter().map(|path| path.target).collect();
        let fit = Fit { readings, targets: &targets, prismatic: self.prismatic };
        let mut next = fit.fit(self.frame_changed(&change[..self.axis_parameter_count()]), &self.used);
        next.cofactors = self.cofactors.clone();
        for (k, path) in next.paths.iter_mut().enumerate() {
            let at = self.axis_parameter_count() + OF_PATH * k;
            let before = self.paths[k].constants(self.prismatic);
            let mean = path.constants(self.prismatic);
            let own = [before[0] + change[at], before[1] + change[at + 1]];
            if self.prismatic {
                path.across_mm = own;
            } else {
                [path.radius_mm, path.height_mm] = own;
            }
            let residuals = readings.iter().zip(&mut next.residuals_mm).filter(|(r, _)| r.target == path.target);
            residuals.for_each(|(_, residual)| (0..2).for_each(|i| residual[i] += mean[i] - own[i]));
        }
        next
    }

    /// Returns the fit of all readings, from this fit.
    pub(super) fn again(&self, readings: &[SweepReading]) -> Option<Self> {
        let targets = targets(readings);
        let fit = Fit { readings, targets: &targets, prismatic: self.prismatic };
        fit.solve(self.frame, &vec![true; readings.len()]).ok()
    }

    /// Index of the path of a target.
    pub fn path(&self, target: usize) -> Option<usize> {
        self.paths.iter().position(|path| path.target == target)
    }

    /// Angle about the axis from its x axis (rad), or distance along the axis (mm), in a frame of
    /// the fit.
    pub fn travel(&self, frame: &Pose, position: Vector) -> f64 {
        let p = frame.inverse().apply(position);
        if self.prismatic { p[2] } else { p[1].atan2(p[0]) }
    }
}

/// Indices of the targets of readings.
fn targets(readings: &[SweepReading]) -> Vec<usize> {
    let mut targets: Vec<usize> = readings.iter().map(|r| r.target).collect();
    targets.sort_unstable();
    targets.dedup();
    targets
}

/// Reason why a sweep has no axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SweepFault {
    /// Fewer readings than parameters.
    TooFew {
        /// Minimum number of readings.
        needed: usize,
        /// Number of readings.
        readings: usize,
    },
    /// The paths do not determine an axis: the target hardly moves, or moves along a line.
    Undetermined,
}

/// Fits the axis of a sweep. Readings far from the path of all others are excluded.
pub fn fit_sweep(readings: &[SweepReading], prismatic: bool) -> Result<SweepFit, SweepFault> {
    let targets = targets(readings);
    let parameters = if prismatic { 2 } else { 4 } + OF_PATH * targets.len();
    let needed = parameters.div_ceil(2).max(if prismatic { 2 } else { 3 });
    if readings.len() < needed {
        return Err(SweepFault::TooFew { needed, readings: readings.len() });
    }
    let start = start(readings, &targets, prismatic).ok_or(SweepFault::Undetermined)?;
    let mut used = nearest(&deviations(readings, &targets, &start, prismatic), readings.len() * 3 / 4, needed);
    if readings.len() < FEWEST_TO_JUDGE {
        used = vec![true; readings.len()];
    }
    let mut fit = Fit { readings, targets: &targets, prismatic }.solve(start, &used)?;
    let mut reduced = OF_NEAREST;
    for _ in 0..STEPS {
        if readings.len() < FEWEST_TO_JUDGE {
            break;
        }
        let next = fit.joined(readings, fit.near(reduced));
        reduced = 1.0;
        if next == used {
            break;
        }
        let again = Fit { readings, targets: &targets, prismatic }.solve(fit.frame, &next)?;
        (fit, used) = (again, next);
    }
    Ok(fit)
}

impl SweepFit {
    /// Readings that noise explains, by the standard deviation of those that are used, which is
    /// `reduced` where only the nearest ones are.
    ///
    /// The tail of t with ν degrees of freedom is below (1 + k²/ν)^(−(ν + 1)/2), that of a normal
    /// distribution, and of the length of two such components, below exp(−k²/2).
    fn near(&self, reduced: f64) -> Vec<bool> {
        let lengths = self.residuals_mm.iter().map(|[a, b]| a.hypot(*b));
        let size = norm(self.frame.translation_mm).max(1.0);
        let square = 2.0 * (self.used.len() as f64 / LOST).ln();
        let dof = self.degrees_of_freedom.max(1) as f64;
        let largest = (dof * ((square / (dof + 1.0)).exp() - 1.0)).sqrt() * self.deviation_mm / reduced;
        lengths.map(|length| length <= largest.max(ROUNDING * size)).collect()
    }
}

impl SweepFit {
    /// Readings that are `near`, and those that steps of the usual size join to them along their
    /// path: a smooth deviation leaves the path without a jump, a reading that does not belong to
    /// the path with one.
    ///
    /// Steps are usual where neighbours differ by much less than the readings deviate; otherwise
    /// deviations are noise, and no reading is joined.
    fn joined(&self, readings: &[SweepReading], near: Vec<bool>) -> Vec<bool> {
        let length = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
        let residual = |i: usize| self.residuals_mm[i];
        let rows = |path: &Path| {
            let target = path.target;
            (0..readings.len()).filter(move |&i| readings[i].target == target).collect::<Vec<_>>()
        };
        let steps =
            |path: &Path| rows(path).windows(2).map(|w| length(residual(w[0]), residual(w[1]))).collect::<Vec<_>>();
        let step = median(self.paths.iter().flat_map(steps)).unwrap_or_default();
        let deviation = median(self.residuals_mm.iter().map(|r| length(*r, [0.0; 2]))).unwrap_or_default();
        let mut joined = near;
        if step > SMOOTH * SQRT_2 * deviation {
            return joined;
        }
        for path in &self.paths {
            let rows = rows(path);
            let mut join = |from: usize, to: usize| {
                joined[to] |= joined[from] && length(residual(from), residual(to)) < USUAL_STEPS * step;
            };
            rows.windows(2).for_each(|w| join(w[0], w[1]));
            rows.windows(2).rev().for_each(|w| join(w[1], w[0]));
        }
        joined
    }
}

/// `true` for the `count` smallest deviations, at least `needed`.
fn nearest(deviations: &[f64], count: usize, needed: usize) -> Vec<bool> {
    let mut order: Vec<usize> = (0..deviations.len()).collect();
    order.sort_by(|a, b| deviations[*a].total_cmp(&deviations[*b]));
    let mut used = vec![false; deviations.len()];
    order.iter().take(count.max(needed)).for_each(|i| used[*i] = true);
    used
}

/// Starting frame of an axis: the best of those through a few readings, by the median deviation of
/// all.
fn start(readings: &[SweepReading], targets: &[usize], prismatic: bool) -> Option<Pose> {
    let count = |t: &usize| readings.iter().filter(|r| r.target == *t).count();
    let most = targets.iter().copied().max_by_key(count)?;
    let all: Vec<Vector> = readings.iter().filter(|r| r.target == most).map(|r| r.position_mm).collect();
    let mut best: Option<(f64, Pose)> = None;
    for trial in 0..STARTS {
        let mut noise = Noise::new(45, trial);
        let mut order: Vec<usize> = (0..all.len()).collect();
        noise.shuffle(&mut order);
        let p = |i: usize| all[order[i]];
        let pose = match prismatic {
            true if all.len() >= 2 => along(p(0), p(1)),
            false if all.len() >= 3 => about(p(0), p(1), p(2)),
            _ => None,
        };
        let Some(pose) = pose else { continue };
        let deviation = median(deviations(readings, targets, &pose, prismatic)).unwrap_or(f64::INFINITY);
        if best.as_ref().is_none_or(|(least, _)| deviation < *least) {
            best = Some((deviation, pose));
        }
    }
    Some(best?.1)
}

/// Frame with its z axis along the line through two points.
fn along(a: Vector, b: Vector) -> Option<Pose> {
    let z = unit(minus(b, a))?;
    Some(frame(any_across(z), z, a))
}

/// Frame with its z axis through the centre of a circle through three points.
fn about(a: Vector, b: Vector, c: Vector) -> Option<Pose> {
    let (ab, ac) = (minus(b, a), minus(c, a));
    let normal = cross(ab, ac);
    let square = dot(normal, normal);
    if square < 1e-12 * dot(ab, ab) * dot(ac, ac) {
        return None;
    }
    let z = unit(normal)?;
    let (first, second) = (cross(normal, ab), cross(ac, normal));
    let center = [0, 1, 2].map(|i| a[i] + (first[i] * dot(ac, ac) + second[i] * dot(ab, ab)) / (2.0 * square));
    Some(frame(any_across(z), z, center))
}

/// Any direction across a direction.
fn any_across(z: Vector) -> Vector {
    let k = (0..3).min_by(|a, b| z[*a].abs().total_cmp(&z[*b].abs())).unwrap_or_default();
    let mut e = [0.0; 3];
    e[k] = 1.0;
    unit(cross(z, e)).unwrap_or([1.0, 0.0, 0.0])
}

/// Coordinates across the axis that a path holds constant: radius and height, or x and y.
fn constants(p: Vector, prismatic: bool) -> [f64; 2] {
    if prismatic { [p[0], p[1]] } else { [p[0].hypot(p[1]), p[2]] }
}

/// Distances of readings from the median path of their target about a frame.
fn deviations(readings: &[SweepReading], targets: &[usize], pose: &Pose, prismatic: bool) -> Vec<f64> {
    let inverse = pose.inverse();
    let held: Vec<[f64; 2]> = readings.iter().map(|r| constants(inverse.apply(r.position_mm), prismatic)).collect();
    let of_target = |t: usize| {
        [0, 1].map(|k| {
            median(readings.iter().zip(&held).filter(|(r, _)| r.target == t).map(|(_, h)| h[k])).unwrap_or_default()
        })
    };
    let medians: Vec<[f64; 2]> = targets.iter().map(|t| of_target(*t)).collect();
    let deviation = |(r, h): (&SweepReading, &[f64; 2])| {
        let m = medians[targets.iter().position(|t| *t == r.target).unwrap_or_default()];
        (h[0] - m[0]).hypot(h[1] - m[1])
    };
    readings.iter().zip(&held).map(deviation).collect()
}

/// Gauss-Newton of one sweep.
struct Fit<'a> {
    readings: &'a [SweepReading],
    targets: &'a [usize],
    prismatic: bool,
}

impl Fit<'_> {
    /// Parameters of the axis.
    fn axis_parameter_count(&self) -> usize {
        if self.prismatic { 2 } else { 4 }
    }

    /// Means of radius and height, or of the place, of each path in a frame.
    fn means(&self, inverse: &Pose, used: &[bool]) -> Vec<[f64; 2]> {
        let mean = |t: &usize| {
            let of = self.readings.iter().zip(used).filter(|(r, used)| **used && r.target == *t);
            let all: Vec<[f64; 2]> = of.map(|(r, _)| constants(inverse.apply(r.position_mm), self.prismatic)).collect();
            [0, 1].map(|k| all.iter().map(|h| h[k]).sum::<f64>() / all.len().max(1) as f64)
        };
        self.targets.iter().map(mean).collect()
    }

    /// Rows of a reading: residuals and derivatives.
    fn rows(&self, p: Vector, mean: [f64; 2], at: usize, n: usize) -> [(f64, DVector<f64>); 2] {
        let mut rows = [DVector::zeros(n), DVector::zeros(n)];
        let held = constants(p, self.prismatic);
        if self.prismatic {
            rows[0][0] = -p[2];
            rows[1][1] = -p[2];
        } else {
            let rho = held[0].max(f64::MIN_POSITIVE);
            let (cos, sin) = (p[0] / rho, p[1] / rho);
            rows[0].as_mut_slice()[..4].copy_from_slice(&[-p[2] * cos, -p[2] * sin, -cos, -sin]);
            rows[1].as_mut_slice()[..2].copy_from_slice(&[p[0], p[1]]);
        }
        let [first, second] = rows;
        let mut rows = [(held[0] - mean[0], first), (held[1] - mean[1], second)];
        for (k, row) in rows.iter_mut().enumerate() {
            row.1[at + k] = -1.0;
        }
        rows
    }

    fn solve(&self, start: Pose, used: &[bool]) -> Result<SweepFit, SweepFault> {
        let mut frame = self.recentred(start, used);
        let n = self.axis_parameter_count() + OF_PATH * self.targets.len();
        let needed = used.iter().filter(|u| **u).count();
        if 2 * needed < n {
            return Err(SweepFault::TooFew { needed: n.div_ceil(2), readings: needed });
        }
        let mut last = f64::INFINITY;
        for _ in 0..STEPS {
            let (normal, right, squares) = self.normal(&frame, used);
            let step = solve_scaled(&normal, &right).ok_or(SweepFault::Undetermined)?;
            // length of the step in the metric of the readings
            let size = (&normal * &step).dot(&step).max(0.0).sqrt();
            let fit = self.fit(frame, used);
            let mut change = step.as_slice()[..self.axis_parameter_count()].to_vec();
            // a step that tilts by more than this leaves the linear model
            let tilt = change[0].hypot(change[1]);
            if tilt > 0.3 {
                change.iter_mut().for_each(|c| *c *= 0.3 / tilt);
            }
            frame = self.recentred(fit.frame_changed(&change), used);
            let scale = (squares / needed as f64).sqrt();
            if size <= CONVERGED * scale.max(1e-9) || (size >= last && size < 1e-6 * scale) {
                break;
            }
            last = size;
        }
        let (normal, ..) = self.normal(&frame, used);
        let mut fit = self.fit(frame, used);
        fit.cofactors = invert_scaled(&normal).ok_or(SweepFault::Undetermined)?;
        Ok(fit)
    }

    /// The frame moved along its axis to the centroid of the paths.
    fn recentred(&self, frame: Pose, used: &[bool]) -> Pose {
        let inverse = frame.inverse();
        let all = self.readings.iter().zip(used).filter(|(_, used)| **used);
        let points: Vec<Vector> = all.map(|(r, _)| inverse.apply(r.position_mm)).collect();
        let mean = |k: usize| points.iter().map(|p| p[k]).sum::<f64>() / points.len().max(1) as f64;
        let shift = if self.prismatic { [mean(0), mean(1), mean(2)] } else { [0.0, 0.0, mean(2)] };
        frame.then(&Pose { translation_mm: shift, ..Pose::identity() })
    }

    /// Normal matrix, right side and sum of squares.
    fn normal(&self, frame: &Pose, used: &[bool]) -> (DMatrix<f64>, DVector<f64>, f64) {
        let n = self.axis_parameter_count() + OF_PATH * self.targets.len();
        let inverse = frame.inverse();
        let means = self.means(&inverse, used);
        let (mut normal, mut right, mut squares) = (DMatrix::zeros(n, n), DVector::zeros(n), 0.0);
        for (r, _) in self.readings.iter().zip(used).filter(|(_, used)| **used) {
            let t = self.targets.iter().position(|t| *t == r.target).unwrap_or_default();
            for (residual, row) in
                self.rows(inverse.apply(r.position_mm), means[t], self.axis_parameter_count() + OF_PATH * t, n)
            {
                normal.ger(1.0, &row, &row, 1.0);
                right.axpy(-residual, &row, 1.0);
                squares += residual * residual;
            }
        }
        (normal, right, squares)
    }

    /// The fit in a frame, without cofactors.
    fn fit(&self, frame: Pose, used: &[bool]) -> SweepFit {
        let inverse = frame.inverse();
        let means = self.means(&inverse, used);
        let index = |t: usize| self.targets.iter().position(|known| *known == t).unwrap_or_default();
        let residual = |r: &SweepReading| {
            let held = constants(inverse.apply(r.position_mm), self.prismatic);
            [0, 1].map(|k| held[k] - means[index(r.target)][k])
        };
        let residuals_mm: Vec<[f64; 2]> = self.readings.iter().map(residual).collect();
        let n = self.axis_parameter_count() + OF_PATH * self.targets.len();
        let count = used.iter().filter(|u| **u).count();
        let degrees_of_freedom = (2 * count).saturating_sub(n);
        let squares: f64 =
            residuals_mm.iter().zip(used).filter(|(_, used)| **used).map(|([a, b], _)| a * a + b * b).sum();
        let path = |(t, mean): (&usize, &[f64; 2])| {
            let of: Vec<Vector> = self
                .readings
                .iter()
                .zip(used)
                .filter(|(r, used)| **used && r.target == *t)
                .map(|(r, _)| inverse.apply(r.position_mm))
                .collect();
            Path {
                target: *t,
                readings: of.len(),
                radius_mm: if self.prismatic { 0.0 } else { mean[0] },
                height_mm: if self.prismatic { 0.0 } else { mean[1] },
                across_mm: if self.prismatic { *mean } else { [0.0; 2] },
                span: if self.prismatic { extent(&of) } else { arc(&of) },
            }
        };
        SweepFit {
            frame,
            prismatic: self.prismatic,
            paths: self.targets.iter().zip(&means).map(path).collect(),
            cofactors: DMatrix::zeros(n, n),
            residuals_mm,
            used: used.to_vec(),
            degrees_of_freedom,
            deviation_mm: if degrees_of_freedom == 0 { 0.0 } else { (squares / degrees_of_freedom as f64).sqrt() },
        }
    }
}

/// Length of a path along z (mm).
fn extent(points: &[Vector]) -> f64 {
    let ends = points.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], p| [a.min(p[2]), b.max(p[2])]);
    (ends[1] - ends[0]).max(0.0)
}

/// Arc about z that points cover (rad): full turn minus its largest gap.
fn arc(points: &[Vector]) -> f64 {
    let mut angles: Vec<f64> = points.iter().map(|p| p[1].atan2(p[0])).collect();
    angles.sort_by(f64::total_cmp);
    let turn = std::f64::consts::TAU;
    let Some(wrap) = angles.first().zip(angles.last()).map(|(a, b)| a + turn - b) else { return 0.0 };
    turn - angles.windows(2).map(|w| w[1] - w[0]).fold(wrap, f64::max)
}

/// Scales of rows and columns that make the diagonal one.
fn scales(normal: &DMatrix<f64>) -> Option<DVector<f64>> {
    let diagonal = normal.diagonal();
    let regular = diagonal.iter().all(|d| *d > 0.0 && d.is_finite());
    regular.then(|| diagonal.map(|d| 1.0 / d.sqrt()))
}

fn scaled(normal: &DMatrix<f64>, scale: &DVector<f64>) -> DMatrix<f64> {
    DMatrix::from_fn(normal.nrows(), normal.ncols(), |i, j| normal[(i, j)] * scale[i] * scale[j])
}

/// Minimum share of its length by which a column must differ from the span of the others.
const LEAST_PIVOT: f64 = 1e-6;

fn cholesky(normal: &DMatrix<f64>) -> Option<(nalgebra::Cholesky<f64, nalgebra::Dyn>, DVector<f64>)> {
    let scale = scales(normal)?;
    let factor = scaled(normal, &scale).cholesky()?;
    (factor.l_dirty().diagonal().min() > LEAST_PIVOT).then_some((factor, scale))
}

fn solve_scaled(normal: &DMatrix<f64>, right: &DVector<f64>) -> Option<DVector<f64>> {
    let (factor, scale) = cholesky(normal)?;
    Some(factor.solve(&right.component_mul(&scale)).component_mul(&scale))
}

/// Inverse of a normal matrix; `None` if it is singular.
pub(super) fn invert_scaled(normal: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    let (factor, scale) = cholesky(normal)?;
    Some(scaled(&factor.inverse(), &scale))
}

/// Maximum radius (mm) of a path that counts as a circle.
const LARGEST_RADIUS_MM: f64 = 50_000.0;

/// Fits circles or lines: lines if circles do not leave smaller residuals, or leave smaller ones
/// only with an implausible radius.
pub(super) fn fit_any(readings: &[SweepReading]) -> Result<SweepFit, SweepFault> {
    let Ok(line) = fit_sweep(readings, true) else { return fit_sweep(readings, false) };
    // too few readings for a circle do not make a line
    let circle = match fit_sweep(readings, false) {
        Ok(circle) => circle,
        Err(SweepFault::Undetermined) => return Ok(line),
        Err(few) => return Err(few),
    };
    let large = circle.paths.iter().any(|path| path.radius_mm > LARGEST_RADIUS_MM);
    let [of_line, of_circle] = [&line, &circle].map(|fit| {
        let lengths = fit.residuals_mm.iter().map(|[a, b]| a.hypot(*b));
        median(lengths).unwrap_or_default() * (1.0 + 1.0 / fit.degrees_of_freedom.max(1) as f64)
    });
    Ok(if large || of_line <= 1.5 * of_circle { line } else { circle })
}
