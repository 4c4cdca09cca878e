//! Uncertainty of figures made of errors: mean, root mean square and maximum of the errors of a
//! robot whose parameters are given (GUM 5.1.2, 5.2.2).
//!
//! The parameters of the robot are judged and contribute nothing. Base, targets and fixtures belong
//! to the measurement: they were fitted to calibration readings, with the errors of these.

use super::budget::{Contributions, Figure, Observed, Systematic, UncertaintySource as Source};
use crate::{Between, Condition, Covariance, Kind, Observation, Prior, ResidualKind, Result, Separation, Settings};
use etalon_base::pose_name::PoseName;
use etalon_math::Problem;
use etalon_math::statistics::rms;
use etalon_robots::Robot;
use nalgebra::{DMatrix, DVector, Matrix6, SymmetricEigen, Vector3, Vector6};
use std::collections::BTreeMap;
use std::ops::Range;

/// Quantity of an error.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum ErrorKind {
    /// Position of a target, or of the centre of a platform: size of the vector.
    Position,
    /// Position along x, y or z (0, 1 or 2).
    Axis(usize),
    /// Distance of a target from a fixed point.
    Distance,
    /// Distance of a target from a plane, line or sphere, along its normals.
    Surface,
    /// Position of a target relative to the socket that it touches: size of the vector.
    Contact,
    /// One coordinate of a target, measured without the others.
    Coordinate,
}

impl Kind {
    /// Returns the quantity of the error of this kind; `None` for orientations and joint values.
    pub fn error_kind(&self) -> Option<ErrorKind> {
        match self {
            Self::Seen(_) => Some(ErrorKind::Position),
            Self::Distance(_) => Some(ErrorKind::Distance),
            Self::On(_) => Some(ErrorKind::Surface),
            Self::Contact(_) | Self::Between(Between { apart: Separation::Touching, .. }) => Some(ErrorKind::Contact),
            Self::Between(_) => Some(ErrorKind::Distance),
            Self::Coordinate(_) => Some(ErrorKind::Coordinate),
            Self::Orientation(_) | Self::Joint(_) => None,
        }
    }

    /// Source of the uncertainty of the observed value.
    pub(crate) fn source(&self) -> Source {
        match self {
            Self::Contact(_) | Self::On(_) | Self::Between(Between { apart: Separation::Touching, .. }) => {
                Source::Contact
            }
            Self::Coordinate(_) => Source::SingleCoordinates,
            Self::Joint(_) => Source::Encoders,
            Self::Seen(_) | Self::Distance(_) | Self::Between(_) | Self::Orientation(_) => Source::Instrument,
        }
    }
}

/// Quantity of an observed value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum ReadingKind {
    /// Orientation of a body.
    Orientation,
    /// Quantity of an error.
    Error(ErrorKind),
    /// Value of a revolute joint.
    JointAngle,
    /// Value of a prismatic joint.
    JointLength,
}

impl ReadingKind {
    /// `true` for values of joints, which have no error at a pose.
    pub fn is_joint(self) -> bool {
        matches!(self, Self::JointAngle | Self::JointLength)
    }

    /// `true` if the values are angles.
    pub fn is_angle(self) -> bool {
        matches!(self, Self::JointAngle | Self::Orientation)
    }
}

impl Kind {
    /// Quantity of the observed value.
    fn reading_kind(&self) -> ReadingKind {
        match (self.error_kind(), self) {
            (Some(kind), _) => ReadingKind::Error(kind),
            (None, Self::Joint(joint)) if joint.is_angle => ReadingKind::JointAngle,
            (None, Self::Joint(_)) => ReadingKind::JointLength,
            (None, _) => ReadingKind::Orientation,
        }
    }
}

/// Residuals of the observations of one quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConditionResiduals {
    /// Quantity.
    pub kind: ReadingKind,
    /// Number of residuals.
    pub count: usize,
    /// Root mean square of the residuals (mm or rad).
    pub rms: f64,
    /// Root mean square of the standard uncertainties of the observed values (mm or rad).
    pub standard_uncertainty: f64,
}

impl ConditionResiduals {
    /// Residuals of each quantity at `values`.
    pub fn all(robot: &dyn Robot, values: &[f64], conditions: &[Condition]) -> Vec<Self> {
        let mut all: BTreeMap<ReadingKind, [f64; 3]> = BTreeMap::new();
        for c in conditions {
            let rows = c.kind.rows() as f64;
            let squares: f64 = c.error(robot, values).iter().map(|e| e * e).sum();
            let sums = all.entry(c.kind.reading_kind()).or_default();
            let more = [rows, squares, rows * c.standard_uncertainty.powi(2)];
            sums.iter_mut().zip(more).for_each(|(sum, more)| *sum += more);
        }
        let of_sums = |(kind, [count, squares, variances]): (ReadingKind, [f64; 3])| Self {
            kind,
            count: count as usize,
            rms: (squares / count).sqrt(),
            standard_uncertainty: (variances / count).sqrt(),
        };
        all.into_iter().map(of_sums).collect()
    }
}

/// Variance (mm²) that each source contributes to a figure.
#[derive(Clone, Debug, PartialEq)]
pub struct FigureUncertainty {
    /// Quantity of the errors.
    pub kind: ErrorKind,
    /// Figure.
    pub figure: Figure,
    /// Contributions.
    pub contributions: Contributions,
}

/// Readings whose errors are judged, and the readings to which base, targets and fixtures were
/// fitted.
#[derive(Clone, Copy)]
pub struct JudgedErrors<'a> {
    /// Robot.
    pub robot: &'a dyn Robot,
    /// All parameters (mm, rad, 1).
    pub values: &'a [f64],
    /// Indices of the parameters of base, targets and fixtures that were fitted.
    pub set_up: &'a [usize],
    /// Positions to which base, targets and fixtures were fitted; further readings are in the
    /// settings.
    pub calibration: &'a [Observation],
    /// Positions whose errors are judged.
    pub observations: &'a [Observation],
    /// Further readings whose errors are judged.
    pub conditions: &'a [Condition],
    /// Standard uncertainty (mm) of a position, if it does not follow from the uncertainty of a
    /// coordinate.
    pub position_mm: Option<f64>,
}

/// Maximum number of fitted parameters whose response is computed.
const MOST_FITTED: usize = 400;
/// Eigenvalues of a normal matrix below this, relative to the largest, count as zero.
const RANK: f64 = 1e-12;

/// Pose and cycle of a reading.
type Key = (PoseName, i64);

/// One judged reading: the residuals that form its error.
struct Reading {
    kind: ErrorKind,
    first: usize,
    rows: usize,
    /// Covariance of its own, or standard uncertainty of each residual.
    own: Option<Covariance>,
    u_mm: f64,
    /// Source of this uncertainty.
    source: Source,
    /// Number of the measured point, if its error is common to several readings.
    point: Option<usize>,
}

/// Everything on which a figure depends, in linear approximation.
pub(super) struct Propagation {
    readings: Vec<Reading>,
    residuals: Vec<f64>,
    /// Sensitivities of a platform's pose to the coordinates of its two targets.
    platform: Option<Vec<[[f64; 4]; 3]>>,
    /// Standard uncertainty (mm) of a coordinate, and the part that readings of one point share.
    u_mm: f64,
    common_mm: f64,
    frames: BTreeMap<Key, Matrix6<f64>>,
    /// Pose of each residual, and its derivatives with respect to a shift and rotation of the
    /// frame; empty if no pose has a frame of its own.
    keys: Vec<Option<Key>>,
    by_frame: Vec<f64>,
    common: Vec<(Source, Vec<f64>)>,
    set_up: Option<SetUp>,
}

/// Response of base, targets and fixtures to the errors of the readings to which they were fitted.
struct SetUp {
    /// Derivatives of the judged residuals.
    judged: DMatrix<f64>,
    /// Derivatives of the whitened calibration residuals, and the inverse of their normal matrix.
    fitted: DMatrix<f64>,
    inverse: DMatrix<f64>,
    /// Rows of each source, with their variance.
    sources: Vec<(Source, Range<usize>, f64)>,
    /// Response to the own errors of readings that share the error of a point.
    own: Option<DMatrix<f64>>,
    keys: Vec<Option<Key>>,
    by_frame: Vec<f64>,
    /// Response to one standard uncertainty of each common error.
    common: Vec<DVector<f64>>,
}

impl JudgedErrors<'_> {
    /// Variances of the mean, root mean square and maximum of each kind of error, and of the
    /// largest error along each axis; empty if no uncertainty is given.
    ///
    /// # Errors
    /// Fails if residuals cannot be evaluated.
    pub fn figures(&self, settings: &Settings, systematic: &Systematic) -> Result<Vec<FigureUncertainty>> {
        let positions = self.observations.iter().any(|o| o.targets.iter().any(Option::is_some));
        if settings.standard_uncertainty_mm.is_none() || (!positions && self.conditions.is_empty()) {
            return Ok(Vec::new());
        }
        let propagation = self.propagation(settings, systematic)?;
        let mut all = Vec::new();
        let mut kinds: Vec<ErrorKind> = propagation.readings.iter().map(|r| r.kind).collect();
        kinds.sort_unstable();
        kinds.dedup();
        let axes = if kinds.contains(&ErrorKind::Position) { self.robot.dimension() } else { 0 };
        kinds.extend((0..axes).map(ErrorKind::Axis));
        for kind in kinds {
            let figures = match kind {
                ErrorKind::Axis(_) => &[Figure::Max][..],
                _ => &[Figure::Mean, Figure::Rms, Figure::Max],
            };
            for &figure in figures {
                let Some(by) = propagation.derivatives(kind, figure) else { continue };
                all.push(FigureUncertainty { kind, figure, contributions: propagation.variances(&by) });
            }
        }
        Ok(all)
    }

    /// Response of the judged residuals to every error of the measurement.
    pub(super) fn propagation(&self, settings: &Settings, systematic: &Systematic) -> Result<Propagation> {
        let robot = self.robot;
        let is_platform = robot.platform().is_some();
        let free = if self.set_up.is_empty() { &[0][..] } else { self.set_up };
        let plain = |o: &Observation| Observation { covariances_mm2: Vec::new(), ..o.clone() };
        let observations: Vec<Observation> = self.observations.iter().map(plain).collect();
        let unit = |c: &Condition| Condition { standard_uncertainty: 1.0, ..c.clone() };
        let of_judged = Settings {
            kind: if is_platform { ResidualKind::Pose } else { ResidualKind::Targets },
            standard_uncertainty_mm: Some(1.0),
            hold: settings.hold.clone(),
            conditions: self.conditions.iter().map(unit).collect(),
            ..Settings::default()
        };
        let observed = Observed { robot, observations: &observations, settings: &of_judged, free, values: self.values };
        let (problem, x) = (observed.problem()?, observed.x());
        let mut residuals = vec![0.0; problem.residual_count()];
        problem.residuals(&x, &mut residuals);
        let u_mm = settings.coordinate_uncertainty_mm();
        let of_pose = |f: &crate::FrameError| Some((f.pose?, Matrix6::from_fn(|i, j| f.covariance[i][j])));
        let common = systematic.errors(&observed)?;
        let frames: BTreeMap<Key, Matrix6<f64>> = systematic.frames.iter().filter_map(of_pose).collect();
        let fitted = (!self.set_up.is_empty() && self.set_up.len() <= MOST_FITTED).then_some(self.calibration);
        let judged = || matrix(&problem.jacobian_rows(&problem.jacobian_at(&x)).dense(), free.len());
        Ok(Propagation {
            readings: self.readings(settings),
            platform: problem.target_sensitivities(&x),
            u_mm,
            common_mm: settings.common_uncertainty_mm.unwrap_or(0.0),
            keys: keys(robot, self.observations, is_platform),
            by_frame: if frames.is_empty() { Vec::new() } else { problem.frame_jacobian(&x, None) },
            frames,
            set_up: fitted.map(|of| self.set_up(of, settings, systematic, judged())).transpose()?,
            common,
            residuals,
        })
    }

    /// Judged readings in the order of their residuals.
    fn readings(&self, settings: &Settings) -> Vec<Reading> {
        let (dimension, is_platform) = (self.robot.dimension(), self.robot.platform().is_some());
        let u_mm = settings.coordinate_uncertainty_mm();
        let position = |first, rows| Reading {
            kind: ErrorKind::Position,
            first,
            rows,
            own: None,
            u_mm,
            source: Source::Instrument,
            point: None,
        };
        // of readings that share the error of a point, the rest is the error of the contact
        let contact_mm = settings.common_uncertainty_mm.and(settings.standard_uncertainty_mm);
        let mut points = BTreeMap::new();
        let mut all = Vec::new();
        let mut row = 0;
        for o in self.observations {
            if is_platform {
                if o.targets.iter().flatten().count() == 2 {
                    all.push(position(row, 2));
                    row += 3;
                }
                continue;
            }
            for (k, at) in o.targets.iter().enumerate().filter_map(|(k, at)| Some((k, (*at)?))) {
                let next = points.len();
                let point = *points.entry((k, at.map(f64::to_bits))).or_insert(next);
                let own = o.covariances_mm2.get(k).copied().flatten();
                let reading = Reading { own, ..position(row, dimension) };
                all.push(match contact_mm {
                    Some(u_mm) => Reading { u_mm, source: Source::Contact, point: Some(point), ..reading },
                    None => Reading { u_mm: self.position_mm.unwrap_or(u_mm), ..reading },
                });
                row += dimension;
            }
        }
        for c in self.conditions {
            let rows = c.kind.rows();
            if let Some(kind) = c.kind.error_kind() {
                let u_mm = match kind {
                    ErrorKind::Position => self.position_mm.unwrap_or(c.standard_uncertainty),
                    _ => c.standard_uncertainty,
                };
                all.push(Reading { kind, source: c.kind.source(), u_mm, ..position(row, rows) });
            }
            row += rows;
        }
        all
    }

    fn set_up(
        &self,
        calibration: &[Observation],
        settings: &Settings,
        systematic: &Systematic,
        judged: DMatrix<f64>,
    ) -> Result<SetUp> {
        let robot = self.robot;
        let settings = Settings { kind: ResidualKind::Targets, prior: Prior::None, ..settings.clone() };
        let observed =
            Observed { robot, observations: calibration, settings: &settings, free: self.set_up, values: self.values };
        let (problem, x) = (observed.problem()?, observed.x());
        let fitted = matrix(&problem.jacobian_rows(&problem.jacobian_at(&x)).dense(), self.set_up.len());
        let inverse = pseudo_inverse(fitted.tr_mul(&fitted));
        let response = |(_, change): (Source, Vec<f64>)| {
            let rows = change.len().min(fitted.nrows());
            -(&inverse * fitted.rows(0, rows).tr_mul(&DVector::from_column_slice(&change[..rows])))
        };
        let common = systematic.errors(&observed)?.into_iter().map(response).collect();
        let keys = keys(robot, calibration, false);
        let of_poses = systematic.frames.iter().any(|frame| frame.pose.is_some());
        let by_frame = if of_poses { problem.frame_jacobian(&x, None) } else { Vec::new() };
        let source = |kind: Option<&Kind>| kind.map_or(Source::Instrument, Kind::source);
        let measured = problem.measured_rows().map(|(kind, rows)| (source(kind), rows, 1.0));
        let shapes = problem.shapes().map(|(row, s)| (Source::RigidParts, row..row + s.rows(), s.variance()));
        let known = problem.known().map(|(row, k)| (Source::KnownPoints, row..row + k.rows(), 1.0));
        let sources = measured.chain(shapes).chain(known).collect();
        let own = problem.is_whitened().then(|| {
            let mut rows = fitted.transpose().as_slice().to_vec();
            problem.whiten(&mut rows, fitted.ncols());
            matrix(&rows, fitted.ncols())
        });
        Ok(SetUp { judged, inverse, sources, own, keys, by_frame, common, fitted })
    }
}

impl Propagation {
    /// Number of judged residuals.
    pub(super) fn residual_count(&self) -> usize {
        self.residuals.len()
    }

    /// Derivatives of a figure with respect to the judged residuals (mm); `None` without such
    /// errors.
    fn derivatives(&self, kind: ErrorKind, figure: Figure) -> Option<Vec<f64>> {
        let of_kind = |r: &&Reading| match kind {
            ErrorKind::Axis(axis) => r.kind == ErrorKind::Position && axis < r.rows,
            _ => r.kind == kind,
        };
        let part = |r: &Reading| match kind {
            ErrorKind::Axis(axis) => r.first + axis..r.first + axis + 1,
            _ => r.first..r.first + r.rows,
        };
        let readings: Vec<&Reading> = self.readings.iter().filter(of_kind).collect();
        let size = |r: &&Reading| self.residuals[part(r)].iter().map(|v| v * v).sum::<f64>().sqrt();
        let sizes: Vec<f64> = readings.iter().map(size).collect();
        let (count, all) = (sizes.len() as f64, rms(sizes.iter().copied()));
        let largest = sizes.iter().copied().max_by(f64::total_cmp)?;
        let mut by = vec![0.0; self.residuals.len()];
        let mut found = false;
        for (reading, s) in readings.into_iter().zip(sizes) {
            let weight = match figure {
                _ if s == 0.0 => continue,
                Figure::Mean => 1.0 / (s * count),
                Figure::Rms => 1.0 / (all * count),
                Figure::Max if s < largest || found => continue,
                Figure::Max => 1.0 / s,
            };
            found = true;
            part(reading).for_each(|row| by[row] = self.residuals[row] * weight);
        }
        Some(by)
    }

    /// Variance of each source.
    pub(super) fn variances(&self, by: &[f64]) -> Contributions {
        let mut all: BTreeMap<Source, f64> = BTreeMap::new();
        let mut add = |source, variance: f64| *all.entry(source).or_default() += variance.max(0.0);
        self.noise(by).into_iter().for_each(|(source, variance)| add(source, variance));
        add(Source::FrameOfPoses, frame_variance(&self.frames, &self.keys, &self.by_frame, by));
        let by_vector = DVector::from_column_slice(by);
        // gradient by the fitted parameters, and what it makes of the readings they were fitted to
        let set_up = self.set_up.as_ref().map(|s| (s, s.judged.tr_mul(&by_vector)));
        if let Some((s, gradient)) = &set_up {
            let answer = &s.inverse * gradient;
            let by_readings = &s.fitted * &answer;
            s.noise(&answer, &by_readings).into_iter().for_each(|(source, variance)| add(source, variance));
            add(Source::FrameOfPoses, frame_variance(&self.frames, &s.keys, &s.by_frame, by_readings.as_slice()));
        }
        for (e, (source, change)) in self.common.iter().enumerate() {
            let direct: f64 = change.iter().zip(by).map(|(a, b)| a * b).sum();
            let fitted = set_up.as_ref().map_or(0.0, |(s, gradient)| gradient.dot(&s.common[e]));
            add(*source, (direct + fitted).powi(2));
        }
        let least = 1e-16 * all.values().sum::<f64>();
        all.into_iter().filter(|(_, variance)| *variance > least).collect()
    }

    /// Variance from the noise of the judged readings, by its source.
    fn noise(&self, by: &[f64]) -> Contributions {
        if let Some(all) = &self.platform {
            let of_pose = |(s, by): (&[[f64; 4]; 3], &[f64])| -> f64 {
                (0..4).map(|c| (0..2).map(|i| s[i][c] * by[i]).sum::<f64>().powi(2)).sum()
            };
            let variance = self.u_mm * self.u_mm * all.iter().zip(by.chunks_exact(3)).map(of_pose).sum::<f64>();
            return vec![(Source::Instrument, variance)];
        }
        let of_reading = |r: &Reading| -> f64 {
            let by = &by[r.first..r.first + r.rows];
            let squares: f64 = by.iter().map(|b| b * b).sum();
            match &r.own {
                Some(c) => (0..r.rows).map(|i| by[i] * (0..r.rows).map(|j| c[i][j] * by[j]).sum::<f64>()).sum(),
                None => r.u_mm * r.u_mm * squares,
            }
        };
        // readings of one point have its error in common: their derivatives are summed first
        let mut points: BTreeMap<usize, Vector3<f64>> = BTreeMap::new();
        for (r, point) in self.readings.iter().filter_map(|r| Some((r, r.point?))) {
            let sum = points.entry(point).or_default();
            by[r.first..r.first + r.rows].iter().zip(sum.iter_mut()).for_each(|(by, sum)| *sum += by);
        }
        let shared = self.common_mm.powi(2) * points.values().map(Vector3::norm_squared).sum::<f64>();
        let own = self.readings.iter().map(|r| (r.source, of_reading(r)));
        own.chain([(Source::Instrument, shared)]).collect()
    }
}

impl SetUp {
    /// Variance from the readings to which base, targets and fixtures were fitted, by its source.
    /// `answer` is the response of a figure to the fitted parameters, `by_readings` to the whitened
    /// readings.
    fn noise(&self, answer: &DVector<f64>, by_readings: &DVector<f64>) -> Contributions {
        let of_rows = |(source, rows, variance): &(Source, Range<usize>, f64)| {
            (*source, variance * by_readings.rows(rows.start, rows.len()).norm_squared())
        };
        let mut all: Contributions = self.sources.iter().map(of_rows).collect();
        if let (Some(own), Some((_, whole))) = (&self.own, all.first_mut()) {
            // the coordinates are first
            let contact = (own * answer).norm_squared().min(*whole);
            *whole -= contact;
            all.push((Source::Contact, contact));
        }
        all
    }
}

/// Variance from the frames of single poses: their derivatives are summed over the residuals of a
/// pose.
fn frame_variance(frames: &BTreeMap<Key, Matrix6<f64>>, keys: &[Option<Key>], by_frame: &[f64], by: &[f64]) -> f64 {
    if frames.is_empty() {
        return 0.0;
    }
    let mut sums: BTreeMap<Key, Vector6<f64>> = BTreeMap::new();
    let mut rows = by_frame.chunks_exact(6).zip(by);
    // residuals of a pose follow each other
    for same in keys.chunk_by(|a, b| a == b) {
        let rows = rows.by_ref().take(same.len()).filter(|(_, by)| **by != 0.0);
        let sum: Vector6<f64> = rows.map(|(row, by)| Vector6::from_column_slice(row) * *by).sum();
        if let Some(key) = same[0].filter(|_| sum != Vector6::zeros()) {
            *sums.entry(key).or_default() += sum;
        }
    }
    sums.iter().filter_map(|(key, s)| Some(s.dot(&(frames.get(key)? * s)))).sum()
}

/// Pose and cycle of each residual of a coordinate.
fn keys(robot: &dyn Robot, observations: &[Observation], is_platform: bool) -> Vec<Option<Key>> {
    let of = |o: &Observation| {
        let measured = o.targets.iter().flatten().count();
        let rows = if is_platform { 3 * usize::from(measured == 2) } else { robot.dimension() * measured };
        std::iter::repeat_n(Some((o.pose, o.cycle)), rows)
    };
    observations.iter().flat_map(of).collect()
}

fn matrix(rows: &[f64], columns: usize) -> DMatrix<f64> {
    DMatrix::from_row_slice(rows.len() / columns.max(1), columns, rows)
}

/// Inverse of a normal matrix; directions that the readings do not determine are omitted.
fn pseudo_inverse(normal: DMatrix<f64>) -> DMatrix<f64> {
    let n = normal.nrows();
    if n == 0 {
        return normal;
    }
    let scale: Vec<f64> = (0..n).map(|i| normal[(i, i)].sqrt()).map(|s| if s > 0.0 { 1.0 / s } else { 0.0 }).collect();
    let scaled = DMatrix::from_fn(n, n, |i, j| normal[(i, j)] * scale[i] * scale[j]);
    let SymmetricEigen { eigenvectors, eigenvalues } = SymmetricEigen::new(scaled);
    let largest = eigenvalues.iter().copied().fold(0.0, f64::max);
    let inverse = eigenvalues.map(|v| if v > RANK * largest { 1.0 / v } else { 0.0 });
    let plain = &eigenvectors * DMatrix::from_diagonal(&inverse) * eigenvectors.transpose();
    DMatrix::from_fn(n, n, |i, j| plain[(i, j)] * scale[i] * scale[j])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn residuals_of_a_frame_are_summed_in_any_order() {
        let [a, b, c] = [1, 2, 3].map(|pose: i64| (PoseName::from(pose), 1));
        let frames: BTreeMap<Key, Matrix6<f64>> =
            [(a, Matrix6::identity()), (b, Matrix6::identity() * 2.0)].into_iter().collect();
        let keys = [Some(a), Some(a), Some(b), None, Some(c), Some(a)];
        let by_frame: Vec<f64> = (0..36).map(f64::from).collect();
        let by = [1.0, 0.0, -1.0, 5.0, 7.0, 2.0];
        // row 0 and twice row 5 of the first pose, row 2 of the second; the third has no frame
        let of_a: f64 = (0..6).map(|k| (f64::from(k) + 2.0 * f64::from(30 + k)).powi(2)).sum();
        let of_b: f64 = (0..6).map(|k| 2.0 * f64::from(12 + k).powi(2)).sum();
        assert_eq!(frame_variance(&frames, &keys, &by_frame, &by), of_a + of_b);
    }
}
