//! The uncertainty budget of an identification: the contribution of each source to the variance of
//! a parameter, or of a figure that depends on parameters and readings (GUM 5.1.2, 5.2.2; a table
//! as in GUM H.1).

use crate::Result;
use crate::judgement::significance::Variance;
use crate::model::frame_error::{FrameError, carry, response};
use crate::model::residuals::Residuals;
use crate::model::rigid_part::Shape;
use crate::model::solved::Solved;
use crate::{Kind, Observation, Settings};
use UncertaintySource as Source;
use etalon_base::pose_name::PoseName;
use etalon_math::Problem;
use etalon_math::statistics::mean;
use etalon_robots::Robot;
use nalgebra::{DMatrix, Matrix6, SymmetricEigen};
use std::collections::{BTreeMap, BTreeSet};

/// A source of uncertainty.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum UncertaintySource {
    /// The instrument: its given uncertainty, or the uncertainties given for single readings.
    Instrument,
    /// Contact with a socket, a surface or a measured point: its stated uncertainty.
    Contact,
    /// Readings of single coordinates, for example of a dial gauge.
    SingleCoordinates,
    /// Readings of encoders at the links.
    Encoders,
    /// Stated shapes of rigid parts.
    RigidParts,
    /// Given positions and lengths of sockets and other fixed points.
    KnownPoints,
    /// Nominal values, by their tolerances.
    NominalValues,
    /// Scatter of repeats of a pose beyond the instrument's uncertainty.
    Repeatability,
    /// Excess of the residuals over all other sources: errors of the robot that the model does not
    /// describe.
    Model,
    /// Residuals, if no uncertainty is given.
    Residuals,
    /// The world frame, common to all poses.
    Frame,
    /// The frame that is measured again at each pose.
    FrameOfPoses,
    /// The scale of the measuring system, common to all lengths.
    Scale,
    /// The temperature, by the expansion of robot and part.
    Temperature,
    /// The joint values set by homing, common to the campaign.
    Homing,
}

/// Contributions of sources to a variance, in its unit.
pub type Contributions = Vec<(UncertaintySource, f64)>;

/// Errors common to all readings of a campaign, by their standard uncertainties (GUM 5.2.4,
/// F.1.2.3).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Systematic {
    /// Frames that place the observations.
    pub frames: Vec<FrameError>,
    /// Relative standard uncertainty of all measured lengths from the scale of the measuring
    /// system.
    pub scale: f64,
    /// Relative standard uncertainty of all measured lengths from the temperature.
    pub expansion: f64,
    /// Standard uncertainties of the joint values set by homing (mm or rad), in the order of the
    /// joints; empty if none is given.
    pub homing: Vec<f64>,
}

impl Systematic {
    /// `true` if an error common to all readings is given, in addition to the errors of frames.
    pub fn is_stated(&self) -> bool {
        self.scale > 0.0 || self.expansion > 0.0 || self.homing.iter().any(|u| *u > 0.0)
    }
}

/// Sources of the uncertainty of an identification.
#[derive(Clone, Debug, Default)]
pub struct Budget {
    /// Covariances of the identified parameters by source of the uncertainties of single readings;
    /// empty if none is given.
    stated: Vec<(Source, Vec<f64>)>,
    /// Covariance of the parameters from all evidence of single readings and poses.
    readings: Vec<f64>,
    /// Variance of repeats beyond the instrument over the variance of the instrument.
    repeats: f64,
    /// The frames of single poses, if `readings` do not contain them.
    of_poses: Vec<f64>,
    /// Response of the parameters to one standard uncertainty of each common error.
    common: Vec<(Source, Vec<f64>)>,
}

/// Scatter of repeats compared with the rest of the residuals (Draper & Smith, Applied Regression
/// Analysis, 2.1).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Replicates {
    /// Standard deviation of a coordinate among repeats of a pose, mm.
    pub repeats_mm: f64,
    /// Degrees of freedom of this standard deviation.
    pub degrees_of_freedom: usize,
    /// Standard deviation (mm) of the model error of a coordinate at a pose, without the scatter of
    /// repeats.
    pub lack_of_fit_mm: f64,
    /// Probability of residuals this large if the model is correct (F test of lack of fit).
    pub p_value: f64,
}

/// Maximum share of a variance that is attributed to rounding.
const ROUNDING: f64 = 1e-9;
/// Joint values of repeats differ by less than this, mm or rad.
const SAME_JOINTS: f64 = 0.005;

impl Systematic {
    /// Change of the whitened residuals for one standard uncertainty of each independent common
    /// error.
    pub(crate) fn errors(&self, observed: &Observed) -> Result<Vec<(Source, Vec<f64>)>> {
        let (problem, x) = (&observed.problem()?, &observed.x());
        let mut errors = Vec::new();
        for frame in self.frames.iter().filter(|f| f.pose.is_none()) {
            let by_frame = problem.frame_jacobian(x, None);
            let covariance = Matrix6::from_fn(|i, j| frame.covariance[i][j]);
            let SymmetricEigen { eigenvectors, eigenvalues } = SymmetricEigen::new(covariance);
            for (k, value) in eigenvalues.iter().enumerate().filter(|(_, value)| **value > 0.0) {
                let along = eigenvectors.column(k) * value.sqrt();
                let change = by_frame.chunks_exact(6).map(|row| row.iter().zip(&along).map(|(r, a)| r * a).sum());
                errors.push((Source::Frame, change.collect()));
            }
        }
        let scales = [(Source::Scale, self.scale), (Source::Temperature, self.expansion)];
        for (source, relative) in scales.into_iter().filter(|(_, relative)| *relative > 0.0) {
            let by_scale = problem.scale_jacobian(x);
            errors.push((source, by_scale.iter().map(|r| r * relative).collect()));
        }
        for (joint, &u) in self.homing.iter().enumerate().filter(|(_, u)| **u > 0.0) {
            // Z = (f(x + u) − f(x − u)) / 2, GUM 5.1.3 note 2
            let (up, down) = (observed.with_joint(joint, u)?, observed.with_joint(joint, -u)?);
            errors.push((Source::Homing, up.iter().zip(&down).map(|(up, down)| 0.5 * (up - down)).collect()));
        }
        Ok(errors)
    }
}

/// Observations with the parameters that are identified from them.
pub(crate) struct Observed<'a> {
    pub robot: &'a dyn Robot,
    pub observations: &'a [Observation],
    pub settings: &'a Settings,
    pub free: &'a [usize],
    pub values: &'a [f64],
}

impl<'a> Observed<'a> {
    pub fn problem(&self) -> Result<Residuals<'a>> {
        Residuals::new(self.robot, self.observations, self.settings, self.free, self.values)
    }

    pub fn x(&self) -> Vec<f64> {
        self.free.iter().map(|&i| self.values[i]).collect()
    }

    /// Residuals with a joint's values shifted.
    fn with_joint(&self, joint: usize, by: f64) -> Result<Vec<f64>> {
        let (mut observations, mut settings) = (self.observations.to_vec(), self.settings.clone());
        let shifted = observations.iter_mut().map(|o| &mut o.joints);
        shifted.chain(settings.conditions.iter_mut().map(|c| &mut c.joints)).for_each(|joints| joints[joint] += by);
        let problem = Residuals::new(self.robot, &observations, &settings, self.free, self.values)?;
        let mut residuals = vec![0.0; problem.residual_count()];
        problem.residuals(&self.x(), &mut residuals);
        Ok(residuals)
    }
}

impl Budget {
    /// Budget of readings with the covariance `readings`; `instrument` is the covariance from the
    /// given uncertainty. `None` if nothing is given.
    pub(crate) fn new(
        solved: Solved,
        instrument: Option<&[f64]>,
        readings: &[f64],
        settings: &Settings,
        replicates: Option<&Replicates>,
    ) -> Self {
        // of points that are many the covariance is too large to keep it source by source
        if solved.problem.layout.is_some() {
            return Self::default();
        }
        let stated = instrument.map(|all| by_rows(solved, all)).unwrap_or_default();
        let beyond = |r: &Replicates| settings.standard_uncertainty_mm.map(|u| (r.repeats_mm / u).powi(2) - 1.0);
        Self {
            stated,
            readings: readings.to_vec(),
            repeats: replicates.and_then(beyond).unwrap_or(0.0).max(0.0),
            ..Self::default()
        }
    }

    /// Adds the contribution of frames to `covariance`; of single poses, if the residuals do not
    /// contain them (`unseen`).
    pub(crate) fn carry_frames(&mut self, frames: &[FrameError], solved: Solved, unseen: bool, covariance: &mut [f64]) {
        let (common, of_poses): (Vec<_>, Vec<_>) = frames.iter().partition(|f| f.pose.is_none());
        carry(common.into_iter(), solved, covariance);
        if unseen && !of_poses.is_empty() {
            self.of_poses = vec![0.0; covariance.len()];
            carry(of_poses.into_iter(), solved, &mut self.of_poses);
            covariance.iter_mut().zip(&self.of_poses).for_each(|(total, more)| *total += more);
        }
    }

    /// Adds the errors common to all readings, each by the change of the residuals, and their
    /// contribution to `covariance`, which already contains the contribution of the frames.
    pub(crate) fn carry(&mut self, errors: Vec<(Source, Vec<f64>)>, solved: Solved, covariance: &mut [f64]) {
        let n = solved.solution.x.len();
        let Some(inverse) = solved.solution.covariance() else { return };
        for (source, change) in errors {
            // S = -(JᵀJ)⁻¹ Jᵀ D
            let answers = response::<1>(&inverse, solved.rows(), &change);
            let answers: Vec<f64> = answers.iter().map(|[s]| -s).collect();
            let rows = covariance.chunks_exact_mut(n).zip(&answers).filter(|_| source != Source::Frame);
            rows.for_each(|(row, a)| row.iter_mut().zip(&answers).for_each(|(c, b)| *c += a * b));
            self.common.push((source, answers));
        }
    }

    /// Contribution of each source to the variance of an identified parameter, by its index among
    /// the identified ones; empty if points were eliminated.
    pub fn parameter_contributions(&self, k: usize) -> Contributions {
        if self.readings.is_empty() {
            return Vec::new();
        }
        let n = self.readings.len().isqrt();
        self.contributions(|covariance| covariance[k * n + k], |e| self.common[e].1[k])
    }

    /// Root L of the covariance of the parameters beyond the given uncertainties of readings, row
    /// by row: the model error, and the scatter of repeats. `None` without such a part.
    pub fn model_root(&self) -> Option<Vec<f64>> {
        let n = Some(self.readings.len().isqrt()).filter(|n| *n > 0)?;
        let mut rest = DMatrix::from_row_slice(n, n, &self.readings);
        for (_, covariance) in &self.stated {
            rest -= DMatrix::from_row_slice(n, n, covariance);
        }
        // parameters in units of their standard uncertainties
        let scale: Vec<f64> = (0..n).map(|k| self.readings[k * n + k].sqrt()).collect();
        let scaled = DMatrix::from_fn(n, n, |i, j| match scale[i] * scale[j] {
            0.0 => 0.0,
            s => 0.5 * (rest[(i, j)] + rest[(j, i)]) / s,
        });
        let SymmetricEigen { mut eigenvectors, eigenvalues } = SymmetricEigen::new(scaled);
        if eigenvalues.iter().all(|value| *value <= ROUNDING) {
            return None;
        }
        for (mut column, value) in eigenvectors.column_iter_mut().zip(eigenvalues.iter()) {
            column *= value.max(0.0).sqrt();
        }
        eigenvectors.row_iter_mut().zip(&scale).for_each(|(mut row, s)| row *= *s);
        Some(eigenvectors.transpose().as_slice().to_vec())
    }

    /// Contributions by `form`, the variance from a covariance of the parameters, and by
    /// `response`, the derivative of the figure with respect to each common error.
    fn contributions(&self, form: impl Fn(&[f64]) -> f64, response: impl Fn(usize) -> f64) -> Contributions {
        let mut all: BTreeMap<Source, f64> = BTreeMap::new();
        let mut add = |source, variance: f64| *all.entry(source).or_default() += variance.max(0.0);
        let mut rest = form(&self.readings);
        let mut of_instrument = 0.0;
        for (source, covariance) in &self.stated {
            let variance = form(covariance).min(rest.max(0.0));
            rest -= variance;
            of_instrument += variance;
            add(*source, variance);
        }
        // what is left of small differences of equal numbers is nothing
        let rest = if rest > ROUNDING * of_instrument { rest } else { 0.0 };
        let repeats = (of_instrument * self.repeats).min(rest);
        if self.stated.is_empty() {
            add(Source::Residuals, rest);
        } else {
            add(Source::Repeatability, repeats);
            add(Source::Model, rest - repeats);
        }
        if !self.of_poses.is_empty() {
            add(Source::FrameOfPoses, form(&self.of_poses));
        }
        self.common.iter().enumerate().for_each(|(e, (source, _))| add(*source, response(e).powi(2)));
        // what cancels leaves the noise of its differences
        let least = 1e-16 * all.values().sum::<f64>();
        all.into_iter().filter(|(_, variance)| *variance > least).collect()
    }
}

/// The given covariance, split into the contributions of the rows of each source.
fn by_rows(solved: Solved, all: &[f64]) -> Vec<(Source, Vec<f64>)> {
    let Solved { problem, solution, jacobian } = solved;
    let whole = || vec![(Source::Instrument, all.to_vec())];
    let nominal = problem.nominal_rows();
    let priors = problem.shapes().next().is_some() || problem.known().next().is_some() || !nominal.is_empty();
    let source = |kind: Option<&Kind>| kind.map_or(Source::Instrument, Kind::source);
    let one_source = problem.measured_rows().all(|(kind, _)| source(kind) == Source::Instrument);
    if !priors && one_source && !problem.is_whitened() {
        return whole();
    }
    let n = solution.x.len();
    let Some(inverse) = solution.covariance() else { return whole() };
    let measured = problem.measured_count();
    let spread = |rows: &[f64], weight: f64| {
        let step =
            DMatrix::from_row_slice(n, n, &inverse) * DMatrix::from_row_slice(rows.len() / n, n, rows).transpose();
        (&step * step.transpose() * weight).as_slice().to_vec()
    };
    let of = |row: usize, count: usize, weight: f64| spread(&jacobian[row * n..(row + count) * n], weight);
    let sum = |a: Vec<f64>, b: Vec<f64>| if a.is_empty() { b } else { a.iter().zip(b).map(|(a, b)| a + b).collect() };
    let shapes = problem.shapes().map(|(row, shape): (usize, &Shape)| of(row, shape.rows(), shape.variance()));
    let known = problem.known().map(|(row, known)| of(row, known.rows(), 1.0));
    let (shapes, known) = (shapes.fold(Vec::new(), sum), known.fold(Vec::new(), sum));
    let nominal = match nominal.is_empty() {
        true => Vec::new(),
        false => of(nominal.start, nominal.len(), problem.nominal_variance()),
    };
    let mut parts = Vec::new();
    if problem.is_whitened() {
        let readings: Vec<f64> = of(0, measured, 1.0);
        // what whitens u² I + c² 11ᵀ is symmetric: once more it gives the response to each
        // reading's own error
        let mut own = jacobian[..measured * n].to_vec();
        problem.whiten(&mut own, n);
        let own: Vec<f64> = spread(&own, 1.0);
        let common = readings.iter().zip(&own).map(|(all, own)| all - own).collect();
        parts.extend([(Source::Instrument, common), (Source::Contact, own)]);
    } else {
        let mut by_source: BTreeMap<Source, Vec<f64>> = BTreeMap::new();
        for (kind, rows) in problem.measured_rows() {
            let covariance = by_source.entry(source(kind)).or_default();
            *covariance = sum(std::mem::take(covariance), of(rows.start, rows.len(), 1.0));
        }
        parts.extend(by_source);
    }
    parts.extend([(Source::RigidParts, shapes), (Source::KnownPoints, known), (Source::NominalValues, nominal)]);
    parts.retain(|(_, covariance)| !covariance.is_empty());
    parts
}

/// A figure computed from errors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Figure {
    /// Their mean size.
    Mean,
    /// Their root mean square.
    Rms,
    /// The largest.
    Max,
}

/// Scatter of repeats compared with the rest of the residuals; `None` if no pose was repeated.
pub(crate) fn replicates(
    robot: &dyn Robot,
    observations: &[Observation],
    values: &[f64],
    degrees_of_freedom: usize,
) -> Option<Replicates> {
    type Missed<'a> = (&'a [f64], [f64; 3]);
    let poses: BTreeSet<PoseName> = observations.iter().map(|o| o.pose).collect();
    if poses.len() == observations.len() {
        return None;
    }
    let mut groups: BTreeMap<(PoseName, usize), Vec<Missed>> = BTreeMap::new();
    for o in observations {
        for (target, miss) in o.misses(robot, values) {
            groups.entry((o.pose, target)).or_default().push((&o.joints, miss));
        }
    }
    let (mut squares, mut within, mut degrees, mut repeated) = (0.0, 0.0, 0usize, 0usize);
    let dimension = robot.dimension();
    for of_pose in groups.values() {
        squares += of_pose.iter().flat_map(|(_, miss)| &miss[..dimension]).map(|v| v * v).sum::<f64>();
        let first = of_pose[0].0;
        let same = |q: &[f64]| q.iter().zip(first).all(|(a, b)| (a - b).abs() < SAME_JOINTS);
        if of_pose.len() < 2 || !of_pose.iter().all(|(q, _)| same(q)) {
            continue;
        }
        for axis in 0..dimension {
            let mean = mean(of_pose.iter().map(|(_, miss)| miss[axis]));
            within += of_pose.iter().map(|(_, miss)| (miss[axis] - mean).powi(2)).sum::<f64>();
        }
        degrees += dimension * (of_pose.len() - 1);
        repeated += of_pose.len();
    }
    let rest = degrees_of_freedom.checked_sub(degrees).filter(|rest| *rest > 0 && degrees > 0)?;
    let (pure, lack) = (within / degrees as f64, (squares - within) / rest as f64);
    // readings of a pose and target, in the mean
    let each = repeated as f64 / (repeated - degrees / dimension).max(1) as f64;
    Some(Replicates {
        repeats_mm: pure.sqrt(),
        degrees_of_freedom: degrees,
        lack_of_fit_mm: ((lack - pure).max(0.0) / each).sqrt(),
        p_value: Variance::Estimated(degrees as f64).exceedance(lack / pure * rest as f64, rest),
    })
}
