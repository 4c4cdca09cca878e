//! Residuals between model and measurement, as a least-squares problem in the free parameters.

use crate::model::elimination::Layout;
use crate::model::kinds::{Condition, Known, has_length};
use crate::model::prior::Nominal;
use crate::model::rigid_part::{At, Shape};
use crate::model::size::Size;
use crate::model::weights::Weights;
use crate::{Error, Result};
use crate::{Observation, Settings};
use etalon_base::pose::Vector;
use etalon_base::pose_name::PoseName;
use etalon_base::{error, phrase};
use etalon_math::statistics::median;
use etalon_math::{Blocks, Problem, Rows, Solution};
use etalon_robots::{FreeBase, Loads, Parametrised, Platform, Robot, State};
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::sync::Arc;

/// Quantity that is compared.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ResidualKind {
    /// Coordinates of each target, weighted by the instrument's uncertainty.
    #[default]
    Targets,
    /// x, y and theta of the platform (eq. 3.26): a radian has the weight of a millimetre. Planar
    /// robots only.
    Pose,
}

const CHUNK: usize = 32;
/// Step (mm or rad) of differences with respect to joint values.
const JOINT_STEP: f64 = 1e-5;
/// Standard deviation of normal residuals over their median size.
pub const OF_MEDIAN: f64 = 1.4826;

/// Residuals of the observations as a function of the free parameters.
pub(crate) struct Residuals<'a> {
    pub robot: &'a dyn Robot,
    pub free: Vec<usize>,
    observations: &'a [Observation],
    /// Loads at each observation; empty if bending is not modelled.
    loads: Arc<[Vec<f64>]>,
    platform: Option<&'a dyn Platform>,
    /// Whitening of residuals with a common error.
    pub common: Option<Common>,
    /// Uncertainties stated for single readings.
    weights: Option<Weights>,
    /// Conditions; their rows follow those of the observations.
    conditions: &'a [Condition],
    /// Stated shapes of rigid parts; their rows follow the measured ones.
    shapes: Vec<Shape>,
    /// Knowledge of fixed points; its rows follow the shapes.
    known: &'a [Known],
    /// Nominal values; their rows come last.
    nominals: Vec<Nominal>,
    /// Scale (mm) of the residuals.
    pub unit: f64,
    /// Standard deviation of a scaled residual according to the instrument.
    stated_noise: Option<f64>,
    values: Vec<f64>,
    rows: Vec<usize>,
    /// Standard deviation of a row of a nominal value.
    prior_weight: f64,
    /// Size (mm) of the robot to which gaps refer, where the observations contain no length.
    reference_mm: Option<f64>,
    /// Unknowns on which few residuals depend.
    pub layout: Option<Layout>,
    /// Scaled errors of the rows after the coordinates; empty if none are drawn.
    pub drawn: Vec<f64>,
}

impl<'a> Residuals<'a> {
    pub fn new(
        robot: &'a dyn Robot,
        observations: &'a [Observation],
        settings: &'a Settings,
        free: &[usize],
        values: &[f64],
    ) -> Result<Self> {
        let all = |loads: Loads| observations.par_iter().with_min_len(CHUNK).map(|o| loads(&o.joints)).collect();
        let loads: Vec<Vec<f64>> = robot.loads().map_or_else(Vec::new, all);
        Ok(Self::unloaded(robot, observations, settings, free, values)?.under(loads.into()))
    }

    /// Returns these residuals with other values of the parameters that are not free; nominal
    /// values are unchanged.
    pub fn holding(mut self, values: &[f64]) -> Self {
        self.values = values.to_vec();
        self.reference_mm = self.size(values).map(|size| size.mm);
        self
    }

    /// Residuals of these observations with another set of free parameters.
    pub fn with_free_parameters(&self, settings: &'a Settings, free: &[usize], values: &[f64]) -> Result<Self> {
        Ok(Self::unloaded(self.robot, self.observations, settings, free, values)?.under(self.loads.clone()))
    }

    /// Returns these residuals with `loads` at each observation.
    fn under(self, loads: Arc<[Vec<f64>]>) -> Self {
        Self { loads, ..self }
    }

    fn unloaded(
        robot: &'a dyn Robot,
        observations: &'a [Observation],
        settings: &'a Settings,
        free: &[usize],
        values: &[f64],
    ) -> Result<Self> {
        if free.is_empty() {
            return Err(error!("nothing-to-identify", cause = "none").hint(phrase!("hold-fewer-parameters")).into());
        }
        let platform = match settings.kind {
            ResidualKind::Targets => None,
            ResidualKind::Pose => {
                Some(robot.platform().ok_or_else(|| Error::NotPlanar { model: robot.model().to_owned() })?)
            }
        };
        let rows = observations.iter().map(|o| {
            let measured = o.targets.iter().flatten().count();
            if platform.is_some() { 3 * usize::from(measured == 2) } else { robot.dimension() * measured }
        });
        let unit = if platform.is_some() { 1.0 } else { settings.standard_uncertainty_mm.unwrap_or(1.0) };
        let layout = Layout::new(robot, free, observations, settings).filter(|_| platform.is_none());
        let is_relative = layout.is_none() && !settings.conditions.is_empty() && !has_length(observations, settings);
        let size = is_relative.then(|| Size::new(robot, &settings.conditions, values)).flatten();
        Ok(Self {
            robot,
            reference_mm: size.map(|size| size.mm),
            layout,
            free: free.to_vec(),
            observations,
            loads: Arc::new([]),
            platform,
            weights: Weights::new(observations, robot.dimension(), unit)
                .filter(|_| platform.is_none() && settings.standard_uncertainty_mm.is_some()),
            common: Common::new(observations, settings, robot.dimension()),
            conditions: &settings.conditions,
            known: &settings.known,
            nominals: Nominal::rows(robot, settings.prior, free, values),
            shapes: match platform {
                None => settings.rigid.iter().filter_map(|part| Shape::new(robot, part)).collect(),
                Some(_) => Vec::new(),
            },
            unit,
            stated_noise: settings.standard_uncertainty_mm.map(|u| u / unit),
            values: values.to_vec(),
            rows: rows.collect(),
            prior_weight: settings.prior.weight(),
            drawn: Vec::new(),
        })
    }

    /// Standard deviations of the rows after the coordinates: conditions, stated shapes, known
    /// points and nominal values.
    pub fn stated(&self) -> Vec<f64> {
        let first = self.coordinate_count();
        let mut stated = vec![1.0; self.residual_count() - first];
        self.shapes().for_each(|(row, shape)| stated[row - first..][..shape.rows()].fill(shape.variance().sqrt()));
        self.nominal_rows().for_each(|row| stated[row - first] = self.prior_weight);
        stated
    }

    /// Number of residuals of measured coordinates; those of conditions follow.
    pub fn coordinate_count(&self) -> usize {
        self.rows.iter().sum()
    }

    /// Number of residuals of coordinates and conditions; those of stated shapes and known points
    /// follow.
    pub fn measured_count(&self) -> usize {
        self.coordinate_count() + self.conditions.iter().map(|c| c.kind.rows()).sum::<usize>()
    }

    /// Factor from scaled residuals to lengths; `None` for angles.
    pub fn sizes(&self) -> impl Iterator<Item = Option<f64>> {
        let of = |c: &Condition| {
            let size = (!c.kind.is_angle()).then_some(c.standard_uncertainty / self.unit);
            std::iter::repeat_n(size, c.kind.rows())
        };
        std::iter::repeat_n(Some(1.0), self.coordinate_count()).chain(self.conditions.iter().flat_map(of))
    }

    /// The stated shapes, each with its first row.
    pub fn shapes(&self) -> impl Iterator<Item = (usize, &Shape)> {
        let mut row = self.measured_count();
        self.shapes.iter().map(move |shape| {
            row += shape.rows();
            (row - shape.rows(), shape)
        })
    }

    /// All parameters of the robot with the free ones at `x`.
    pub fn all(&self, x: &[f64]) -> Vec<f64> {
        let mut values = self.values.clone();
        for (&i, &x) in self.free.iter().zip(x) {
            values[i] = x;
        }
        values
    }

    /// Standard deviation of a residual: the stated one, or that of most residuals of `solution` if
    /// it is larger (from their median size, which a few wrong readings do not affect); 0 if
    /// neither is known.
    pub fn noise(&self, solution: Option<&Solution>) -> f64 {
        let shown = |s: &Solution| {
            let (dof, equations) = (self.degrees_of_freedom(s), self.nominal_rows().start as f64);
            let median = median(s.residuals.iter().take(self.measured_count()).map(|r| r.abs())).unwrap_or(0.0);
            if dof >= 1.0 { OF_MEDIAN * median * (equations / dof).sqrt() } else { 0.0 }
        };
        self.stated_noise.unwrap_or(0.0).max(solution.map_or(0.0, shown))
    }

    /// Pose, cycle and joints of every observation, with the number of its residuals.
    fn seen(&self) -> impl Iterator<Item = Seen<'_>> {
        let of = |(o, &rows): (&'a Observation, &usize)| Seen { pose: o.pose, cycle: o.cycle, joints: &o.joints, rows };
        let conditions = self.conditions.iter().map(|c| Seen {
            pose: c.pose,
            cycle: c.cycle,
            joints: &c.joints,
            rows: c.kind.rows(),
        });
        self.observations.iter().zip(&self.rows).map(of).chain(conditions)
    }

    /// Joint values of every observation and condition.
    pub fn joints(&self) -> impl Iterator<Item = &[f64]> {
        self.seen().map(|s| s.joints)
    }

    /// Targets that are observed relative to targets of another branch, and those.
    pub fn related_targets(&self) -> BTreeSet<usize> {
        let related = |c: &Condition| c.kind.other_target().map(|other| [c.target, other]);
        self.conditions.iter().filter_map(related).flatten().collect()
    }

    /// Size of the robot at `values`, where the observations contain no length.
    pub fn size(&self, values: &[f64]) -> Option<Size> {
        self.reference_mm.and_then(|_| Size::new(self.robot, self.conditions, values))
    }

    /// `true` if all residuals except those of stated values are coordinates of targets.
    pub fn is_coordinates(&self) -> bool {
        self.platform.is_none() && self.conditions.is_empty()
    }

    /// Pose and joints of every observation and condition, with the number of its residuals.
    pub fn pose_rows(&self) -> impl Iterator<Item = (PoseName, &[f64], usize)> {
        self.seen().map(|s| (s.pose, s.joints, s.rows))
    }

    /// The pose of each residual.
    pub fn poses(&self) -> Vec<PoseName> {
        self.seen().flat_map(|s| std::iter::repeat_n(s.pose, s.rows)).collect()
    }

    /// Cluster to which the error of each residual belongs: a reading common to several residuals,
    /// or the pose.
    pub fn clusters(&self) -> Vec<PoseName> {
        match &self.common {
            Some(common) => common.numbers(self.measured_count()),
            None => self.poses(),
        }
    }

    /// The robot with all parameters `values`.
    pub fn at<'v>(&'v self, values: &'v [f64]) -> At<'v> {
        let joints = self.seen().next().map_or(&[][..], |s| s.joints);
        At { robot: self.robot, values, free: &self.free, joints }
    }

    /// `true` if residuals and Jacobian are whitened, so that an element no longer belongs to one
    /// observation.
    pub fn is_whitened(&self) -> bool {
        self.common.is_some()
    }

    /// `true` if some readings have their own covariance.
    pub fn is_weighted(&self) -> bool {
        self.weights.is_some()
    }

    /// Pose and cycle of each observation and condition, with the number of its residuals.
    pub fn counts(&self) -> impl Iterator<Item = ((PoseName, i64), usize)> {
        self.seen().map(|s| ((s.pose, s.cycle), s.rows)).filter(|count| count.1 > 0)
    }

    /// Poses with at least one residual, each as often as it was repeated.
    pub fn observation_count(&self) -> usize {
        let coordinates = self.rows.iter().filter(|&&rows| rows > 0).count();
        if self.conditions.is_empty() {
            return coordinates;
        }
        self.counts().map(|count| count.0).collect::<BTreeSet<_>>().len()
    }

    /// Residuals of the conditions or, for a given `width`, their derivatives, over chunks of
    /// conditions.
    fn fill_condition_rows(&self, all: &[f64], out: &mut [f64], width: usize, write: impl Fn(&Met, &mut [f64]) + Sync) {
        let mut parts = Vec::new();
        let (mut out, mut row) = (out, self.coordinate_count());
        for conditions in self.conditions.chunks(CHUNK) {
            let rows: usize = conditions.iter().map(|c| c.kind.rows()).sum();
            let (part, rest) = out.split_at_mut(rows * width);
            parts.push((conditions, row, part));
            (out, row) = (rest, row + rows);
        }
        let arm = self.robot.free_base();
        parts.into_par_iter().for_each(|(conditions, mut row, mut out)| {
            for condition in conditions {
                let position = self.robot.position(all, &condition.joints, condition.target);
                let (here, rest) = out.split_at_mut(condition.kind.rows() * width);
                write(&Met { condition, arm, position, row }, here);
                (out, row) = (rest, row + condition.kind.rows());
            }
        });
    }

    /// Derivatives of the conditions with respect to the free parameters.
    fn condition_jacobian(&self, all: &[f64], out: &mut [f64]) {
        let (n, width) = (all.len(), self.width());
        let (robot, loads) = (self.robot.parametrised(all), self.robot.loads());
        self.fill_condition_rows(all, out, width, |met, out| {
            let (condition, dimension) = (met.condition, self.robot.dimension());
            let mut moved = vec![0.0; dimension * n];
            if condition.kind.equation().depends_on_target() {
                let state = State {
                    joints: &condition.joints,
                    loads: &loads.as_ref().map_or_else(Vec::new, |at| at(&condition.joints)),
                };
                robot.target_derivatives(state, &[condition.target], &mut |_, j, by| {
                    (0..dimension).for_each(|i| moved[i * n + j] += by[i]);
                });
            }
            let mut full = vec![0.0; condition.kind.rows() * n];
            condition.jacobian(&condition.at(met.arm, all, met.position), &moved, &mut full);
            for (i, (row, out)) in full.chunks_exact(n).zip(out.chunks_exact_mut(width)).enumerate() {
                self.take(met.row + i, |parameter| row[parameter], out);
            }
        });
    }

    /// Number of elements of a row of the Jacobian.
    pub fn width(&self) -> usize {
        self.layout.as_ref().map_or(self.free.len(), |layout| layout.blocks.width())
    }

    /// The Jacobian at `x`, in the layout of [`Problem::jacobian`].
    pub fn jacobian_at(&self, x: &[f64]) -> Vec<f64> {
        let mut jacobian = vec![0.0; self.residual_count() * self.width()];
        self.jacobian(x, &mut jacobian);
        jacobian
    }

    /// A Jacobian with its columns.
    pub fn jacobian_rows<'j>(&'j self, jacobian: &'j [f64]) -> Rows<'j> {
        Rows { numbers: jacobian, n: self.free.len(), blocks: Problem::blocks(self) }
    }

    /// Writes the derivatives with respect to the free parameters into a row.
    fn take(&self, row: usize, derivative: impl Fn(usize) -> f64, out: &mut [f64]) {
        let Some(layout) = &self.layout else {
            return self.free.iter().zip(out).for_each(|(&i, out)| *out = derivative(i));
        };
        out.fill(0.0);
        self.free.iter().for_each(|&i| layout.add(layout.blocks.of_row[row], i, derivative(i), out));
    }

    /// Knowledge of fixed points, each with its first row.
    pub fn known(&self) -> impl Iterator<Item = (usize, &Known)> {
        let mut row = self.measured_count() + self.shapes.iter().map(Shape::rows).sum::<usize>();
        self.known.iter().map(move |known| {
            row += known.rows();
            (row - known.rows(), known)
        })
    }

    /// First row of the nominal values, which are the last rows.
    pub fn nominal_rows(&self) -> Range<usize> {
        let all = self.residual_count();
        all - self.nominals.len()..all
    }

    /// Variance of a row of a nominal value.
    pub fn nominal_variance(&self) -> f64 {
        self.prior_weight.powi(2)
    }

    /// Number of parameters that the data leave undetermined, from zero to all with a nominal
    /// value: Σ (u/s)² with u from data and nominal values, s from nominal values alone. `solution`
    /// is a solution of these residuals.
    pub fn undetermined(&self, solution: &Solution) -> f64 {
        let factor = solution.factor.as_ref().filter(|_| !self.nominals.is_empty());
        let Some((common, inverse)) = factor.and_then(|f| Some((f.common(), f.common_inverse()?))) else { return 0.0 };
        // eliminated unknowns are measured directly: the rows of `nominals` are in the order of the
        // columns
        let open = |(k, &j): (usize, &usize)| {
            let derivative = self.nominals[j].derivative() / solution.scale[j];
            (derivative.powi(2) * inverse[k * common.len() + k]).clamp(0.0, 1.0)
        };
        common.iter().enumerate().map(open).sum()
    }

    /// Degrees of freedom without nominal values: equations minus parameters, where undetermined
    /// parameters do not count.
    pub fn degrees_of_freedom(&self, solution: &Solution) -> f64 {
        let equations = self.residual_count() - self.nominals.len();
        (equations as f64 - solution.x.len() as f64 + self.undetermined(solution)).max(0.0)
    }

    /// Sum of squares without nominal values.
    pub fn squares(&self, solution: &Solution) -> f64 {
        solution.residuals[..self.nominal_rows().start].iter().map(|r| r * r).sum()
    }

    /// Each observation of a range with its state.
    fn observed(&self, range: Range<usize>) -> impl Iterator<Item = (&'a Observation, State<'_>)> + Send {
        range.map(|k| {
            let o = &self.observations[k];
            (o, State { joints: &o.joints, loads: self.loads.get(k).map_or(&[][..], Vec::as_slice) })
        })
    }

    /// Cuts `out` (`width` numbers a row) into the parts of each chunk of observations.
    fn chunks<'o>(
        &self,
        mut out: &'o mut [f64],
        width: usize,
    ) -> Vec<(impl Iterator<Item = (&'a Observation, State<'_>)> + Send, &'o mut [f64])> {
        let mut parts = Vec::new();
        for (k, rows) in self.rows.chunks(CHUNK).enumerate() {
            let (part, rest) = out.split_at_mut(rows.iter().sum::<usize>() * width);
            out = rest;
            parts.push((self.observed(k * CHUNK..k * CHUNK + rows.len()), part));
        }
        parts
    }

    /// For pose residuals: sensitivity of each residual to the coordinates of both targets, three
    /// rows of four per pose.
    pub fn target_sensitivities(&self, x: &[f64]) -> Option<Vec<[[f64; 4]; 3]>> {
        let platform = self.platform?;
        let all = self.all(x);
        let of = |o: &Observation| both(o).map(|pair| platform.pose_error_by_targets(&all, pair));
        Some(self.observations.iter().filter_map(of).collect())
    }

    /// Derivatives of the predicted values with respect to the joint values at `x`, whitened like
    /// the residuals: rows of all joints. Derivatives of conditions are central differences.
    pub fn joint_jacobian(&self, x: &[f64]) -> Vec<f64> {
        let (all, dimension) = (self.all(x), self.robot.dimension());
        let n = self.robot.joints().len();
        let mut rows = Vec::with_capacity(self.residual_count() * n);
        let mut at = vec![0.0; dimension * self.robot.targets().len()];
        let mut full = vec![0.0; at.len() * n];
        let robot = self.robot.parametrised(&all);
        for (o, state) in self.observed(0..self.observations.len()) {
            robot.joint_jacobian(state, &mut at, &mut full);
            for (here, _) in full.chunks_exact(dimension * n).zip(&o.targets).filter(|(_, at)| at.is_some()) {
                rows.extend(here.iter().map(|v| v / self.unit));
            }
        }
        self.whiten(&mut rows, n);
        for c in self.conditions {
            let mut columns = vec![0.0; c.kind.rows() * n];
            for j in 0..n {
                let residuals = |by: f64| {
                    let mut moved = c.clone();
                    moved.joints[j] += by;
                    let position = self.robot.position(&all, &moved.joints, c.target);
                    let mut r = vec![0.0; c.kind.rows()];
                    moved.residuals(&moved.at(self.robot.free_base(), &all, position), &mut r);
                    r
                };
                let (ahead, behind) = (residuals(JOINT_STEP), residuals(-JOINT_STEP));
                for (i, (a, b)) in ahead.iter().zip(&behind).enumerate() {
                    columns[i * n + j] = (a - b) / (2.0 * JOINT_STEP);
                }
            }
            rows.extend(columns);
        }
        rows
    }

    /// Derivatives of the residuals at `x`, whitened, with respect to a small shift (mm) and
    /// rotation (rad) of the frame of the observations of `pose` and cycle, or of all: rows of six.
    pub fn frame_jacobian(&self, x: &[f64], pose: Option<(PoseName, i64)>) -> Vec<f64> {
        // a point p of a frame that shifts by t and turns by w is measured t + w × p less
        let mut rows = self.displaced::<6>(x, pose, |p| {
            let lever = [[0.0, p[2], -p[1]], [-p[2], 0.0, p[0]], [p[1], -p[0], 0.0]];
            let axis =
                |i: usize| std::array::from_fn(|c| if c < 3 { f64::from(u8::from(c == i)) } else { lever[i][c - 3] });
            [0, 1, 2].map(axis)
        });
        for c in self.conditions {
            // an orientation that turns by w is observed w less; other conditions are met in the
            // robot's own world, or in the frame of a station that is identified
            let turned = c.kind.is_world_orientation() && pose.is_none_or(|key| key == (c.pose, c.cycle));
            let one = if turned { 1.0 / c.standard_uncertainty } else { 0.0 };
            let row = |i: usize| (0..6).map(move |k| if k == 3 + i { one } else { 0.0 });
            rows.extend((0..c.kind.rows()).flat_map(row));
        }
        rows
    }

    /// Derivatives of the residuals of coordinates at `x`, whitened, with respect to a common
    /// relative error of all measured lengths.
    pub fn scale_jacobian(&self, x: &[f64]) -> Vec<f64> {
        let mut rows = self.displaced(x, None, |p| p.map(|v| [-v]));
        let all = self.all(x);
        for c in self.conditions {
            let change = c.kind.equation().by_scale(&all);
            rows.extend(change[..c.kind.rows()].iter().map(|v| v / c.standard_uncertainty));
        }
        rows
    }

    /// Derivatives of the residuals of coordinates at `x`, whitened, with respect to N errors that
    /// change a point of `pose` and cycle, or of all, by `moved`: rows of N.
    fn displaced<const N: usize>(
        &self,
        x: &[f64],
        pose: Option<(PoseName, i64)>,
        moved: impl Fn(&Vector) -> [[f64; N]; 3],
    ) -> Vec<f64> {
        let sensitivities = self.target_sensitivities(x);
        let mut poses = sensitivities.iter().flatten();
        let mut rows: Vec<f64> = Vec::with_capacity(N * self.residual_count());
        for o in self.observations {
            let placed = pose.is_none_or(|key| key == (o.pose, o.cycle));
            let moved = |p: &Vector| if placed { moved(p) } else { [[0.0; N]; 3] };
            match self.platform {
                Some(_) => {
                    let [Some(k), Some(l)] = &o.targets[..] else { continue };
                    let coordinates = [moved(k)[0], moved(k)[1], moved(l)[0], moved(l)[1]];
                    let Some(sensitivity) = poses.next() else { continue };
                    for row in sensitivity {
                        rows.extend((0..N).map(|c| -(0..4).map(|i| row[i] * coordinates[i][c]).sum::<f64>()));
                    }
                }
                None => {
                    for measured in o.targets.iter().flatten() {
                        let axes = moved(measured);
                        rows.extend(axes[..self.robot.dimension()].iter().flatten().map(|v| v / self.unit));
                    }
                }
            }
        }
        self.whiten(&mut rows, N);
        rows
    }

    /// Makes rows of `width` numbers, divided by the unit, independent and of equal variance.
    pub fn whiten(&self, rows: &mut [f64], width: usize) {
        if let Some(common) = &self.common {
            common.whiten(rows, width);
        }
        if let Some(weights) = &self.weights {
            weights.whiten(rows, width);
        }
    }

    /// Residuals before whitening.
    pub fn plain_residuals(&self, x: &[f64], r: &mut [f64]) {
        let all = self.all(x);
        self.fill_condition_rows(&all, &mut r[self.coordinate_count()..], 1, |met, out| {
            met.condition.residuals(&met.condition.at(met.arm, &all, met.position), out);
        });
        if let (Some(size), Some(reference_mm)) = (self.size(&all), self.reference_mm) {
            self.gaps(&mut r[self.coordinate_count()..], 1).for_each(|gap| gap[0] *= reference_mm / size.mm);
        }
        let (dimension, robot) = (self.robot.dimension(), self.robot.parametrised(&all));
        self.chunks(r, 1).into_par_iter().for_each(|(observations, mut r)| {
            let mut predicted = vec![0.0; dimension * self.robot.targets().len()];
            for (o, state) in observations {
                if let Some(platform) = self.platform {
                    if let Some(pair) = both(o) {
                        let (here, rest) = r.split_at_mut(3);
                        here.copy_from_slice(&platform.pose_error(&all, &o.joints, pair));
                        r = rest;
                    }
                    continue;
                }
                robot.positions(state, &mut predicted);
                for (predicted, measured) in predicted.chunks_exact(dimension).zip(&o.targets) {
                    let Some(measured) = measured else { continue };
                    let (here, rest) = r.split_at_mut(dimension);
                    for ((r, p), m) in here.iter_mut().zip(predicted).zip(measured) {
                        *r = (p - m) / self.unit;
                    }
                    r = rest;
                }
            }
        });
    }

    /// Jacobian before whitening.
    pub fn plain_jacobian(&self, x: &[f64], jacobian: &mut [f64]) {
        let all = self.all(x);
        let (n, free, dimension) = (all.len(), &self.free, self.robot.dimension());
        self.condition_jacobian(&all, &mut jacobian[self.coordinate_count() * self.width()..]);
        self.relate(x, jacobian);
        let robot = self.robot.parametrised(&all);
        if self.robot.free_base().is_some() {
            return self.coordinate_jacobian(robot.as_ref(), jacobian);
        }
        self.chunks(jacobian, free.len()).into_par_iter().for_each(|(observations, mut out)| {
            let mut full = vec![0.0; dimension * self.robot.targets().len() * n];
            let take = |rows: &[f64], out: &mut [f64]| {
                for (row, out) in rows.chunks_exact(n).zip(out.chunks_exact_mut(free.len())) {
                    for (&i, out) in free.iter().zip(out) {
                        *out = row[i] / self.unit;
                    }
                }
            };
            for (o, state) in observations {
                if let Some(platform) = self.platform {
                    if let Some(pair) = both(o) {
                        let (here, rest) = out.split_at_mut(3 * free.len());
                        take(&platform.pose_error_jacobian(&all, &o.joints, pair), here);
                        out = rest;
                    }
                    continue;
                }
                robot.jacobian(state, &mut full);
                for (rows, measured) in full.chunks_exact(dimension * n).zip(&o.targets) {
                    if measured.is_some() {
                        let (here, rest) = out.split_at_mut(dimension * free.len());
                        take(rows, here);
                        out = rest;
                    }
                }
            }
        });
    }
}

impl Residuals<'_> {
    /// Rows of the conditions that are lengths, of `width` numbers each.
    fn gaps<'r>(&self, rows: &'r mut [f64], width: usize) -> impl Iterator<Item = &'r mut [f64]> {
        let is_length: Vec<bool> =
            self.conditions.iter().flat_map(|c| std::iter::repeat_n(!c.kind.is_angle(), c.kind.rows())).collect();
        rows.chunks_exact_mut(width).zip(is_length).filter(|(_, is_length)| *is_length).map(|(row, _)| row)
    }

    /// Turns the derivatives of gaps into those of gaps relative to the size of the robot.
    fn relate(&self, x: &[f64], jacobian: &mut [f64]) {
        let all = self.all(x);
        let (Some(size), Some(reference_mm)) = (self.size(&all), self.reference_mm) else { return };
        let mut left = vec![0.0; self.residual_count()];
        self.plain_residuals(x, &mut left);
        let (first, width) = (self.coordinate_count(), self.width());
        let mut left = left.split_off(first);
        let gaps = self.gaps(&mut jacobian[first * width..], width);
        for (row, left) in gaps.zip(self.gaps(&mut left, 1)) {
            for (derivative, &i) in row.iter_mut().zip(&self.free) {
                *derivative = *derivative * reference_mm / size.mm - left[0] * size.relative[i];
            }
        }
    }

    /// Derivatives of the coordinates of targets of a spatial robot.
    fn coordinate_jacobian(&self, robot: &dyn Parametrised, jacobian: &mut [f64]) {
        let (width, mut places) = (self.width(), vec![None; self.robot.parameters().len()]);
        for (column, &i) in self.free.iter().enumerate() {
            places[i] = self.layout.as_ref().map_or(Some(column), |layout| Some(layout.places[i]?.1));
        }
        self.chunks(jacobian, width).into_par_iter().for_each(|(observations, mut out)| {
            out.fill(0.0);
            let mut first = vec![0; self.robot.targets().len()];
            for (o, state) in observations {
                let measured: Vec<usize> = (0..o.targets.len()).filter(|&k| o.targets[k].is_some()).collect();
                measured.iter().enumerate().for_each(|(k, &target)| first[target] = 3 * k * width);
                let (here, rest) = out.split_at_mut(3 * measured.len() * width);
                robot.target_derivatives(state, &measured, &mut |target, parameter, moved| {
                    let Some(place) = places[parameter] else { return };
                    let (x, rest) = here[first[target]..].split_at_mut(width);
                    let (y, z) = rest.split_at_mut(width);
                    x[place] += moved[0] / self.unit;
                    y[place] += moved[1] / self.unit;
                    z[place] += moved[2] / self.unit;
                });
                out = rest;
            }
        });
    }
}

/// Measurements at a pose.
struct Seen<'a> {
    pose: PoseName,
    cycle: i64,
    joints: &'a [f64],
    rows: usize,
}

/// A condition, with the robot's arm and the current position of the target.
struct Met<'a> {
    condition: &'a Condition,
    arm: Option<&'a dyn FreeBase>,
    position: Vector,
    /// Its first residual.
    row: usize,
}

/// Both targets in the plane, if both were measured.
fn both(o: &Observation) -> Option<[[f64; 2]; 2]> {
    match o.targets[..] {
        [Some(k), Some(l)] => Some([[k[0], k[1]], [l[0], l[1]]]),
        _ => None,
    }
}

impl Problem for Residuals<'_> {
    fn residual_count(&self) -> usize {
        self.measured_count() + self.prior_count()
    }

    fn prior_count(&self) -> usize {
        let shapes = self.shapes.iter().map(Shape::rows).sum::<usize>();
        shapes + self.known.iter().map(Known::rows).sum::<usize>() + self.nominals.len()
    }

    fn residuals(&self, x: &[f64], r: &mut [f64]) {
        self.plain_residuals(x, r);
        self.whiten(r, 1);
        let all = self.all(x);
        for (row, shape) in self.shapes() {
            shape.residuals(&self.at(&all), &mut r[row..][..shape.rows()]);
        }
        for (row, known) in self.known() {
            known.residuals(&all, &mut r[row..][..known.rows()]);
        }
        let nominals = self.nominal_rows();
        r[nominals].iter_mut().zip(&self.nominals).for_each(|(r, nominal)| *r = nominal.residual(&all));
        r[self.coordinate_count()..].iter_mut().zip(&self.drawn).for_each(|(row, error)| *row -= error);
    }

    fn jacobian(&self, x: &[f64], jacobian: &mut [f64]) {
        self.plain_jacobian(x, jacobian);
        self.whiten(jacobian, self.width());
        let (n, width, all) = (self.free.len(), self.width(), self.all(x));
        for (row, shape) in self.shapes() {
            shape.jacobian(&self.at(&all), &mut jacobian[row * n..][..shape.rows() * n]);
        }
        for (row, known) in self.known() {
            let mut full = vec![0.0; known.rows() * all.len()];
            known.jacobian(&all, &mut full);
            let out = jacobian[row * width..][..known.rows() * width].chunks_exact_mut(width);
            for (i, (full, out)) in full.chunks_exact(all.len()).zip(out).enumerate() {
                self.take(row + i, |parameter| full[parameter], out);
            }
        }
        for (row, nominal) in self.nominal_rows().zip(&self.nominals) {
            let by = |parameter| if parameter == nominal.parameter { nominal.derivative() } else { 0.0 };
            self.take(row, by, &mut jacobian[row * width..][..width]);
        }
    }

    fn blocks(&self) -> Option<&Blocks> {
        self.layout.as_ref().map(|layout| &layout.blocks)
    }
}

/// Residuals whose measured positions are one reading, and their whitening.
///
/// k residuals of a coordinate have the covariance u² I + c² 11ᵀ, with u independent and c common.
/// Divided by u, what whitens them is I + (λ − 1) 11ᵀ/k, λ = u / √(u² + k c²): their mean shrinks,
/// differences from it stay.
#[derive(Clone, Debug)]
pub(crate) struct Common {
    /// First row of each residual of one reading, and λ − 1.
    readings: Vec<(Vec<usize>, f64)>,
    dimension: usize,
}

impl Common {
    /// Readings of `observations` (`dimension` rows per measured target): positions with the very
    /// same coordinates are one reading. `None` where the settings state no common uncertainty.
    fn new(observations: &[Observation], settings: &Settings, dimension: usize) -> Option<Self> {
        let (u, c) = (settings.standard_uncertainty_mm?, settings.common_uncertainty_mm?);
        let mut readings: BTreeMap<(usize, [u64; 3]), Vec<usize>> = BTreeMap::new();
        let mut row = 0;
        for observation in observations {
            for (target, at) in observation.targets.iter().enumerate() {
                let Some(at) = at else { continue };
                readings.entry((target, at.map(f64::to_bits))).or_default().push(row);
                row += dimension;
            }
        }
        let shrinks = |rows: Vec<usize>| {
            let shrunk = u / (u * u + rows.len() as f64 * c * c).sqrt();
            (rows, shrunk - 1.0)
        };
        Some(Self { readings: readings.into_values().map(shrinks).collect(), dimension })
    }

    /// Whitens rows of `width` numbers that were divided by u.
    pub fn whiten(&self, rows: &mut [f64], width: usize) {
        let length = self.dimension * width;
        let mut common = vec![0.0; length];
        for (reading, shrink) in &self.readings {
            common.fill(0.0);
            for row in reading {
                common.iter_mut().zip(&rows[row * width..][..length]).for_each(|(sum, v)| *sum += v);
            }
            common.iter_mut().for_each(|sum| *sum = shrink * (*sum / reading.len() as f64));
            for row in reading {
                rows[row * width..][..length].iter_mut().zip(&common).for_each(|(v, common)| *v += common);
            }
        }
    }

    /// For each of `count` rows the number of its reading.
    fn numbers(&self, count: usize) -> Vec<PoseName> {
        let mut numbers = vec![PoseName::default(); count];
        for (number, (reading, _)) in self.readings.iter().enumerate() {
            for row in reading {
                numbers[*row..][..self.dimension].fill((number as i64).into());
            }
        }
        numbers
    }
}
