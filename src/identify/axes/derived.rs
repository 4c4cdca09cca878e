//! A robot from its axes alone: axes at joint values zero, base from axes 1 and 2, flange on the
//! last axis, targets, and the uncertainty of predictions.

use super::JointAxis;
use etalon_base::pose::{Pose, Vector, cross, dot, minus, norm, unit};
use etalon_robots::{AxisLine, NEAR_PARALLEL_RAD, frame, modified_table};
use nalgebra::{DMatrix, DVector};

/// Steps of numeric derivatives (rad, mm).
const STEPS: [f64; 2] = [1e-6, 1e-4];

/// Distance of two axes (mm) below which their common normal is no direction for the base.
const MEET_MM: f64 = 1.0;

/// Rule by which the first two axes determine the base; its z axis is axis 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BaseRule {
    /// x along the common normal from axis 1 to axis 2, origin at its foot on axis 1.
    CommonNormal,
    /// The axes intersect: x perpendicular to both, with the sign of z1 × z2; origin at the
    /// intersection.
    Meeting,
    /// The axes are parallel: x towards axis 2; origin on axis 1, nearest to the centroid of the
    /// first sweep.
    Parallel,
    /// Axis 2 is prismatic: x along its component perpendicular to axis 1; origin nearest to the
    /// first target.
    Sliding,
    /// No second direction exists: x towards the first target.
    Target,
}

/// Robot derived from sweeps.
#[derive(Clone, Debug)]
pub struct AxesModel {
    /// Axes as measured, in the order of the joints.
    pub measured: Vec<JointAxis>,
    /// Sweep and path that determine each target; `None` for a target in no sweep.
    sources: Vec<(usize, usize)>,
    /// Rule of the base.
    pub rule: BaseRule,
    /// Base in the frame of the measurements.
    pub world_T_base: Pose,
    /// Axes at joint values zero in the base frame.
    pub axes: Vec<AxisLine>,
    /// Flange at joint values zero in the base frame: the frame of the last joint in modified
    /// Denavit-Hartenberg parameters.
    pub flange: Pose,
    /// Targets in the frame of the flange (mm), by index.
    pub targets_mm: Vec<Vector>,
    /// Standard uncertainties of axes in the base frame: direction (rad) and point (mm), each as
    /// the root of the sum of squares of its components.
    pub uncertainties: Vec<[f64; 2]>,
    /// Standard uncertainties of the targets (mm), by component.
    pub target_uncertainties_mm: Vec<Vector>,
}

/// Predicted position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Predicted {
    /// Position in the frame of the measurements (mm).
    pub position_mm: Vector,
    /// Covariance of it (mm²), by the axes.
    pub covariance_mm2: [[f64; 3]; 3],
}

/// Axes and targets at joint values zero in the frame of the measurements.
#[derive(Clone)]
struct AtZero {
    axes: Vec<AxisLine>,
    targets: Vec<Vector>,
}

impl AtZero {
    fn pose(&self, joints: &[f64]) -> Pose {
        self.axes.iter().zip(joints).fold(Pose::identity(), |pose, (axis, q)| pose.then(&axis.motion(*q)))
    }

    fn position(&self, joints: &[f64], target: usize) -> Vector {
        self.pose(joints).apply(self.targets[target])
    }
}

impl AxesModel {
    /// Derives the robot. `measured` has one axis for each joint, in their order; `targets` is the
    /// number of targets. `None` if a target is in no sweep.
    pub fn new(measured: Vec<JointAxis>, targets: usize) -> Option<Self> {
        let source = |t: usize| (0..measured.len()).rev().find_map(|j| Some((j, measured[j].fit.path(t)?)));
        let sources: Vec<(usize, usize)> = (0..targets).map(source).collect::<Option<_>>()?;
        if measured.is_empty() || sources.is_empty() {
            return None;
        }
        let mut model = Self {
            measured,
            sources,
            rule: BaseRule::Target,
            world_T_base: Pose::identity(),
            axes: Vec::new(),
            flange: Pose::identity(),
            targets_mm: Vec::new(),
            uncertainties: Vec::new(),
            target_uncertainties_mm: Vec::new(),
        };
        let zero = model.at_zero(&model.unchanged());
        model.rule = rule(&zero.axes);
        let in_base = model.in_base(&zero);
        (model.world_T_base, model.axes, model.flange, model.targets_mm) = in_base;
        model.set_uncertainties();
        Some(model)
    }

    /// Number of parameters of all sweeps.
    fn sizes(&self) -> Vec<usize> {
        self.measured.iter().map(|m| m.covariance.nrows()).collect()
    }

    /// No change of any parameter.
    fn unchanged(&self) -> Vec<Vec<f64>> {
        self.sizes().iter().map(|n| vec![0.0; *n]).collect()
    }

    /// Axes and targets at joint values zero, after changes of the parameters of each sweep.
    fn at_zero(&self, changes: &[Vec<f64>]) -> AtZero {
        let mut axes: Vec<AxisLine> = Vec::new();
        let n = self.measured.len();
        let value = |rest: &[f64], j: usize| rest.get(j).copied().unwrap_or_default();
        for (m, change) in self.measured.iter().zip(changes) {
            let pose = m.fit.frame_changed(&change[..m.fit.axis_parameter_count()]);
            let axis = AxisLine { direction: pose.axis(2), point_mm: pose.translation_mm, prismatic: m.fit.prismatic };
            // the joints before it were not at zero
            let before = axes.iter().enumerate();
            let rest = before.fold(Pose::identity(), |p, (j, a)| p.then(&a.motion(value(&m.rest, j))));
            axes.push(axis.moved(&rest.inverse()));
        }
        let targets = self.sources.iter().map(|&(sweep, path)| {
            let (m, change) = (&self.measured[sweep], &changes[sweep]);
            let pose = m.fit.frame_changed(&change[..m.fit.axis_parameter_count()]);
            let at = m.fit.axis_parameter_count() + 2 * path;
            let phase = m.phases[path] + change[m.fit.cofactors.nrows() + path];
            let p = &m.fit.paths[path];
            let local = match m.fit.prismatic {
                true => [p.across_mm[0] + change[at], p.across_mm[1] + change[at + 1], phase],
                false => {
                    let (sin, cos) = phase.sin_cos();
                    let radius = p.radius_mm + change[at];
                    [radius * cos, radius * sin, p.height_mm + change[at + 1]]
                }
            };
            let joints: Vec<f64> = (0..n).map(|j| if j == sweep { 0.0 } else { value(&m.rest, j) }).collect();
            let rest = axes.iter().zip(&joints).fold(Pose::identity(), |p, (a, q)| p.then(&a.motion(*q)));
            rest.inverse().apply(pose.apply(local))
        });
        let targets = targets.collect();
        AtZero { axes, targets }
    }

    /// Base in the world, axes and flange in the base, and targets in the flange.
    fn in_base(&self, zero: &AtZero) -> (Pose, Vec<AxisLine>, Pose, Vec<Vector>) {
        let base = base(self.rule, zero, self.measured[0].fit.frame.translation_mm);
        let inverse = base.inverse();
        let mut axes: Vec<AxisLine> = zero.axes.iter().map(|axis| axis.moved(&inverse)).collect();
        // a sliding axis may be anywhere: at the origin
        axes.iter_mut().filter(|a| a.prismatic).for_each(|a| a.point_mm = [0.0; 3]);
        axes.iter_mut().filter(|a| !a.prismatic).for_each(|a| a.point_mm = a.foot([0.0; 3]));
        let targets: Vec<Vector> = zero.targets.iter().map(|t| inverse.apply(*t)).collect();
        let flange = flange(&axes, targets[0]);
        let back = flange.inverse();
        (base, axes, flange, targets.iter().map(|t| back.apply(*t)).collect())
    }

    /// Derivatives of a function of axes and targets with respect to the parameters of all sweeps,
    /// and its covariance.
    fn covariance(&self, f: &dyn Fn(&AtZero) -> Vec<f64>) -> DMatrix<f64> {
        let mut changes = self.unchanged();
        let count = f(&self.at_zero(&changes)).len();
        let mut all = DMatrix::zeros(count, count);
        for (s, m) in self.measured.iter().enumerate() {
            let n = m.covariance.nrows();
            let mut jacobian = DMatrix::zeros(count, n);
            for k in 0..n {
                let angle = k < 2 || k >= m.fit.cofactors.nrows() && !m.fit.prismatic;
                let step = STEPS[usize::from(!angle)];
                let mut at = |sign: f64| {
                    changes[s][k] = sign * step;
                    let value = f(&self.at_zero(&changes));
                    changes[s][k] = 0.0;
                    DVector::from_vec(value)
                };
                jacobian.set_column(k, &((at(1.0) - at(-1.0)) / (2.0 * step)));
            }
            all += &jacobian * &m.covariance * jacobian.transpose();
        }
        all
    }

    /// Covariance of a function of the axes and the flange in the base.
    pub(super) fn covariance_of_axes(&self, f: &dyn Fn(&[AxisLine], &Pose) -> Vec<f64>) -> DMatrix<f64> {
        self.covariance(&|zero| {
            let (_, axes, flange, _) = self.in_base(zero);
            f(&axes, &flange)
        })
    }

    fn set_uncertainties(&mut self) {
        let cells = |zero: &AtZero| {
            let (_, axes, _, targets) = self.in_base(zero);
            let axes = axes.iter().flat_map(|a| a.direction.into_iter().chain(a.point_mm));
            axes.chain(targets.into_iter().flatten()).collect::<Vec<f64>>()
        };
        let all = self.covariance(&cells);
        let u = |k: usize| all[(k, k)].max(0.0).sqrt();
        let length = |k: usize| (0..3).map(|i| u(k + i).powi(2)).sum::<f64>().sqrt();
        let n = self.axes.len();
        let axes = (0..n).map(|j| [length(6 * j), length(6 * j + 3)]).collect();
        let targets = (0..self.targets_mm.len()).map(|t| [0, 1, 2].map(|i| u(6 * n + 3 * t + i))).collect();
        self.uncertainties = axes;
        self.target_uncertainties_mm = targets;
    }

    /// Position of a target at joint values.
    pub fn position(&self, joints: &[f64], target: usize) -> Vector {
        self.at_zero(&self.unchanged()).position(joints, target)
    }

    /// Position of a target at joint values, with its uncertainty due to the axes.
    pub fn predict(&self, joints: &[f64], target: usize) -> Predicted {
        let all = self.covariance(&|zero| zero.position(joints, target).to_vec());
        Predicted {
            position_mm: self.position(joints, target),
            covariance_mm2: std::array::from_fn(|i| std::array::from_fn(|j| all[(i, j)])),
        }
    }
}

/// Returns the rule of the base for these axes.
fn rule(axes: &[AxisLine]) -> BaseRule {
    let [first, second, ..] = axes else { return BaseRule::Target };
    let normal = cross(first.direction, second.direction);
    let parallel = norm(normal) < NEAR_PARALLEL_RAD.sin();
    match (second.prismatic || first.prismatic, parallel) {
        (true, false) => BaseRule::Sliding,
        (true, true) => BaseRule::Target,
        (false, true) => BaseRule::Parallel,
        (false, false) => {
            let distance = dot(minus(second.point_mm, first.point_mm), normal) / norm(normal);
            if distance.abs() < MEET_MM { BaseRule::Meeting } else { BaseRule::CommonNormal }
        }
    }
}

/// Base from the first two axes; `beside` is the centroid of the first sweep.
fn base(rule: BaseRule, zero: &AtZero, beside: Vector) -> Pose {
    let first = zero.axes[0];
    let z = first.direction;
    let second = zero.axes.get(1).copied().unwrap_or(first);
    let across = |v: Vector| unit([0, 1, 2].map(|i| v[i] - dot(v, z) * z[i]));
    let target = zero.targets[0];
    let on_axis = |p: Vector| if first.prismatic { p } else { first.foot(p) };
    let (x, origin) = match rule {
        BaseRule::CommonNormal | BaseRule::Meeting => {
            let normal = cross(z, second.direction);
            let between = minus(second.point_mm, first.point_mm);
            let along = dot(cross(between, second.direction), normal) / dot(normal, normal);
            let sign = if rule == BaseRule::CommonNormal && dot(between, normal) < 0.0 { -1.0 } else { 1.0 };
            let origin = [0, 1, 2].map(|i| first.point_mm[i] + along * z[i]);
            (unit(normal.map(|v| v * sign)), origin)
        }
        BaseRule::Parallel => {
            let origin = first.foot(beside);
            (across(minus(second.foot(origin), origin)), origin)
        }
        BaseRule::Sliding => {
            let direction = across(second.direction);
            (direction, on_axis(target))
        }
        BaseRule::Target => {
            let towards = minus(target, first.point_mm);
            let x = if first.prismatic { None } else { across(towards) };
            (x, on_axis(target))
        }
    };
    let x = x.or_else(|| across([1.0, 0.0, 0.0])).or_else(|| across([0.0, 1.0, 0.0])).unwrap_or([1.0, 0.0, 0.0]);
    frame(x, z, origin)
}

/// Flange on the last axis, as the frame of the last joint in modified Denavit-Hartenberg
/// parameters with its last row zero.
fn flange(axes: &[AxisLine], target: Vector) -> Pose {
    let Some(last) = axes.last() else { return Pose::identity() };
    if last.prismatic {
        let x = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].into_iter().find(|x| dot(*x, last.direction).abs() < 0.9);
        let x = x.unwrap_or([1.0, 0.0, 0.0]);
        let x = unit([0, 1, 2].map(|i| x[i] - dot(x, last.direction) * last.direction[i])).unwrap_or(x);
        return frame(x, last.direction, target);
    }
    // any flange on the axis has the frame before it
    let start = frame_across(last);
    let table = modified_table(axes, &start);
    match table.joints.last() {
        None => start,
        Some(row) => start.turn_z(-row.theta_rad).shift(2, -row.d_mm),
    }
}

/// Frame on an axis with any x axis.
fn frame_across(axis: &AxisLine) -> Pose {
    let z = axis.direction;
    let k = (0..3).min_by(|a, b| z[*a].abs().total_cmp(&z[*b].abs())).unwrap_or_default();
    let mut e = [0.0; 3];
    e[k] = 1.0;
    frame(unit(cross(z, e)).unwrap_or([1.0, 0.0, 0.0]), z, axis.point_mm)
}
