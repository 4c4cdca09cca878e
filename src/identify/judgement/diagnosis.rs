//! Diagnosis: the cause of a missing result, and outliers, the largest residuals of a robust fit.

use crate::judge::{MOST_PARAMETERS, is_possible_misfit, jacobian_with_misfit, reading_slips, set_up_error};
use crate::judgement::figures::ErrorKind;
use crate::judgement::regional::SHOWN;
use crate::judgement::robust::CAUCHY;
use crate::model::observation::misplaced;
use crate::model::residuals::{OF_MEDIAN, Residuals};
use crate::solution::estimation::Estimation;
use crate::solution::identifiability::Analysis;
use crate::{Cause, Condition, Error, Identification, Kind, Observation, ResidualKind, Settings, unseen_by};
use etalon_base::pose::{Vector, minus, norm};
use etalon_base::pose_name::PoseName;
use etalon_math::statistics::{mean, median, rms};
use etalon_math::{Loss, Options, Problem, Termination};
use etalon_robots::{Robot, Role};
use nalgebra::{Cholesky, DMatrix, DVector};
use std::collections::{BTreeMap, BTreeSet};

/// Maximum ratio of the extents of measured and predicted positions in the same unit.
const SAME_UNIT: f64 = 3.0;

/// Error after the solver ended with `termination`, started from `start` (all parameters of the
/// robot).
pub(crate) fn diagnose_failure(estimation: &Estimation, start: &[f64], termination: Termination) -> Error {
    let Estimation { robot, observations, settings, wanted } = *estimation;
    if matches!(termination, Termination::RankDeficient | Termination::TooFewEquations)
        && let Ok(all) = Residuals::new(robot, observations, settings, wanted, start)
    {
        return too_little(robot, observations, &all, start);
    }
    let cause = cause(robot, observations, start);
    // a few readings that the others contradict explain an extent, and no set-up; a mode that fits
    // explains the readings
    let is_mode = matches!(cause, Some(Cause::AssemblyMode { .. }));
    if let Some(readings) = wrong_readings(robot, observations, settings, wanted, start).filter(|_| !is_mode) {
        return Error::Failed { termination, cause: Some(readings), set_up: None };
    }
    Error::Failed { termination, cause, set_up: set_up_error(robot, observations, settings) }
}

/// Maximum share of readings that are wrong among correct ones.
const FEW: f64 = 0.2;

/// Readings that most others contradict, by a robust fit from `start` that can be the robot.
fn wrong_readings(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    free: &[usize],
    start: &[f64],
) -> Option<Cause> {
    let robust = RobustFit::from_start(robot, observations, settings, free, start)?;
    let poses: BTreeSet<PoseName> = robust.outliers().iter().map(|reading| reading.pose).collect();
    let few = robust.outliers().len() as f64 <= FEW * robust.readings.len() as f64;
    let slips = reading_slips(robot, observations, &settings.conditions, &robust);
    let is_possible = robust.is_possible(robot, observations, settings);
    (few && is_possible && !poses.is_empty()).then_some(Cause::Readings { poses, slips })
}

/// Error if no position of base and targets gives finite residuals.
pub(crate) fn not_located(robot: &dyn Robot, observations: &[Observation]) -> Error {
    let cause = cause(robot, observations, &robot.nominal());
    Error::Failed { termination: Termination::NotANumber, cause, set_up: None }
}

/// Error if no parameter is left: all are held, or the data do not depend on the free ones at
/// `start`.
pub(crate) fn nothing_left(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    start: &[f64],
) -> Error {
    let cause = cause(robot, observations, start);
    let set_up = cause.as_ref().and_then(|_| set_up_error(robot, observations, settings));
    Error::NothingLeft { cause, set_up }
}

/// Parameters that too few poses leave undetermined, group by group.
fn too_little(robot: &dyn Robot, observations: &[Observation], all: &Residuals, start: &[f64]) -> Error {
    let poses: BTreeSet<PoseName> = observations.iter().map(|o| o.pose).collect();
    let groups = Analysis::at(all, start, 0.0).groups;
    let name = |i: usize| robot.parameters()[i].name.clone();
    Error::Undetermined {
        counts: [all.residual_count(), poses.len(), all.free.len() - groups.len(), all.free.len()],
        groups: groups.iter().map(|g| (name(g.held), g.with.iter().map(|&i| name(i)).collect())).collect(),
    }
}

/// The cause that the observations show for the robot at `start`.
fn cause(robot: &dyn Robot, observations: &[Observation], start: &[f64]) -> Option<Cause> {
    let (mut measured, mut predicted) = (Vec::<Vector>::new(), Vec::<Vector>::new());
    let mut unreachable = BTreeSet::new();
    for o in observations {
        for (k, target) in o.targets.iter().enumerate() {
            let Some(target) = target else { continue };
            let place = robot.position(start, &o.joints, k);
            measured.push(*target);
            match place.iter().all(|v| v.is_finite()) {
                true => predicted.push(place),
                false => drop(unreachable.insert(o.pose)),
            }
        }
    }
    if !unreachable.is_empty() {
        return Some(Cause::Unreachable(unreachable));
    }
    let (measured_mm, model_mm) = (extent(&measured), extent(&predicted));
    if measured_mm > SAME_UNIT * model_mm || model_mm > SAME_UNIT * measured_mm {
        return Some(Cause::Extent { measured_mm, model_mm });
    }
    let wrong = misplaced(robot, observations, start);
    let (worst, left) = wrong.first()?;
    Some(Cause::AssemblyMode {
        poses: wrong.iter().map(|(o, _)| o.pose).collect(),
        worst: worst.pose,
        mode: *worst.joints.last()?,
        left_mm: [left.0, left.1],
    })
}

/// Diagonal (mm) of the smallest box around points.
fn extent(points: &[Vector]) -> f64 {
    let end = |pick: fn(f64, f64) -> f64| {
        points.iter().copied().reduce(|a, b| [0, 1, 2].map(|i| pick(a[i], b[i]))).unwrap_or_default()
    };
    norm(minus(end(f64::max), end(f64::min)))
}

/// Minimum outlier limit in robust standard deviations of a coordinate: with three coordinates,
/// fewer than one of ten million normal errors exceeds it.
pub const OUTLIER: f64 = 6.0;
/// Size of a reading in standard deviations that no misfit of a model leaves.
pub const GROSS: f64 = 20.0;
/// Share of sound campaigns whose misfit has a larger residual than the outlier limit.
const CHANCE: f64 = 1e-3;
/// Minimum number of readings of a quantity whose misfit has a known tail.
const FEWEST_OF_TAIL: usize = 15;
/// Ratio of a scatter to the given uncertainty from which a model is incomplete.
const MISFIT: f64 = 1.5;
/// Errors that a model lacks, in standard deviations of the lengths with the largest ones: lengths
/// of each kind may have such errors, also if those of most poses are smaller.
const COMMON: f64 = 3.0;
/// Share of the poses that show the region of the measured joint values.
const MOST_OF_REGION: f64 = 0.9;
/// Number of fits, each with the scale of the previous one.
const FITS: usize = 12;
/// Maximum number of fits without the outliers of the previous one.
const REFITS: usize = 5;
/// A scatter below this share of another one belongs to a better fit.
const BELOW: f64 = 0.9;
/// Minimum number of observations in the part with which the fit from the nominal parameters
/// begins.
const PART: usize = 60;
/// Minimum scale (mm, rad) of residuals: no instrument resolves less.
pub const LEAST_RESIDUAL: f64 = 1e-6;

/// Residual of every reading after a robust fit. Each quantity is judged by its own scatter: that
/// of a model that is incomplete is not the instrument's.
#[derive(Clone, Debug)]
pub struct RobustFit {
    /// The largest first, relative to its outlier limit.
    pub readings: Vec<Reading>,
    /// Standard deviation (mm, rad) of the residuals of each quantity: by the majority of them, or
    /// the stated one if that is larger. `None` stands for orientations.
    pub scales: BTreeMap<Option<ErrorKind>, f64>,
    /// All parameters of the robust fit.
    pub values: Vec<f64>,
    /// Numbers of observations and of conditions in the fit.
    fitted: [usize; 2],
}

/// Place of a reading among the data.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum ReadingSource {
    /// Position of a target in the observation with this index.
    Position(usize),
    /// Condition with this index.
    Condition(usize),
}

/// Residual of a reading.
#[derive(Clone, Debug)]
pub struct Reading {
    /// Its place among the data.
    pub source: ReadingSource,
    /// Its quantity; `None` for an orientation.
    pub quantity: Option<ErrorKind>,
    /// Index of its target.
    pub target: usize,
    /// Name of the pose.
    pub pose: PoseName,
    /// Number of the repeat.
    pub cycle: i64,
    /// Size of the residual: distance (mm), or angle (rad) of an orientation.
    pub left: f64,
    /// Standard deviation (mm, rad) of one of its residuals: of its quantity, or the one that the
    /// reading itself states if that is larger, with the uncertainty of the prediction by the other
    /// readings.
    pub(crate) deviation: f64,
    /// Residual over its standard deviation beyond which it is an outlier.
    pub(crate) limit: f64,
}

impl Reading {
    /// Residual over its standard deviation.
    pub fn over_deviation(&self) -> f64 {
        self.left / self.deviation
    }

    /// Residual over the outlier limit.
    fn over_limit(&self) -> f64 {
        self.over_deviation() / self.limit
    }

    fn is_judged(&self, conditions: &[Condition]) -> bool {
        !matches!(self.source, ReadingSource::Condition(i) if !is_judged(&conditions[i]))
    }
}

/// All readings at `values`, with the standard deviations that they state themselves, and the
/// number of residuals of each.
fn readings(
    robot: &dyn Robot,
    observations: &[Observation],
    conditions: &[Condition],
    values: &[f64],
) -> Vec<(Reading, usize)> {
    let (dimension, mut all) = (robot.dimension(), Vec::new());
    for (index, o) in observations.iter().enumerate() {
        let own: BTreeMap<usize, f64> = o.uncertainties_mm(dimension).collect();
        let position = |(target, miss): (usize, Vector)| Reading {
            source: ReadingSource::Position(index),
            quantity: Some(ErrorKind::Position),
            target,
            pose: o.pose,
            cycle: o.cycle,
            left: norm(miss),
            deviation: own.get(&target).copied().unwrap_or(0.0),
            limit: OUTLIER,
        };
        all.extend(o.misses(robot, values).map(|miss| (position(miss), dimension)));
    }
    let condition = |(index, c): (usize, &Condition)| Reading {
        source: ReadingSource::Condition(index),
        quantity: c.kind.error_kind(),
        target: c.target,
        pose: c.pose,
        cycle: c.cycle,
        left: norm(c.error(robot, values)),
        deviation: c.standard_uncertainty,
        limit: OUTLIER,
    };
    all.extend(conditions.iter().enumerate().map(|all| (condition(all), all.1.kind.rows())));
    all
}

impl RobustFit {
    /// Robust fit to the residuals of a least-squares solution; `None` if it fails.
    pub fn new(
        robot: &dyn Robot,
        observations: &[Observation],
        settings: &Settings,
        found: &Identification,
    ) -> Option<Self> {
        Self::from_start(robot, observations, settings, &found.free, &found.values)
    }

    /// Robust fit of the parameters `free` from `start` (all parameters); `None` if it fails.
    pub(crate) fn from_start(
        robot: &dyn Robot,
        observations: &[Observation],
        settings: &Settings,
        free: &[usize],
        start: &[f64],
    ) -> Option<Self> {
        let unseen = unseen_by(robot, settings.kind).filter(|i| !free.contains(i));
        let free: Vec<usize> = free.iter().copied().chain(unseen).collect();
        let fit = robust(robot, observations, settings, &free, start)?;
        let mut found = Self::measured(robot, observations, settings, &free, fit);
        // the Cauchy loss enlarges residuals where the model is incomplete and poses are few:
        // outliers are readings that least squares without them does not explain (reweighted least
        // squares, Rousseeuw & Leroy 1987, 1.2)
        for _ in 0..REFITS {
            let before = found.outlying();
            if before.is_empty() || before.len() as f64 > FEW * found.readings.len() as f64 {
                break;
            }
            let fit = Fit::without(robot, observations, settings, &free, &found)?;
            found = Self::measured(robot, observations, settings, &free, fit);
            if found.outlying() == before {
                break;
            }
        }
        found.compare_with_usual_misfit(robot, observations, settings, &free);
        Some(found)
    }

    /// Enlarges the limit of outliers that are none beside the misfit that robots usually have: a
    /// model without it leaves more at the edge of the poses.
    fn compare_with_usual_misfit(
        &mut self,
        robot: &dyn Robot,
        observations: &[Observation],
        settings: &Settings,
        free: &[usize],
    ) {
        if self.outliers().is_empty() {
            return;
        }
        let scatter = Scatter(self.scales.iter().map(|(quantity, scale)| (*quantity, (*scale, 0))).collect());
        let scaled = scatter.weighted(settings);
        let predicted = comparison(robot, observations, &scaled, free, &self.values)
            .and_then(|(problem, x)| predictions(&problem, &x, jacobian_with_misfit(&problem, &x)))
            .unwrap_or_default();
        let sizes = predicted.iter().map(|p| p.left.abs() / p.redundancy.max(SHOWN).sqrt());
        let Some(deviation) = median(sizes).map(|size| OF_MEDIAN * size) else { return };
        let (mut limits, mut rows) = (BTreeMap::new(), predicted.into_iter());
        for (reading, count) in readings(robot, observations, &settings.conditions, &self.values) {
            let own: Vec<Predicted> = rows.by_ref().take(count).collect();
            let size = own.iter().map(|p| p.left.powi(2)).sum::<f64>().sqrt();
            let variance = deviation.powi(2) * (1.0 + mean(own.iter().map(|p| p.variance)));
            limits.insert((reading.source, reading.target), OUTLIER * variance.sqrt() / size);
        }
        let scales = &self.scales;
        for reading in self.readings.iter_mut().filter(|r| is_incomplete(scales, settings, r.quantity)) {
            let limit = limits.get(&(reading.source, reading.target)).copied().unwrap_or(0.0);
            reading.limit = reading.limit.max(limit * reading.over_deviation());
        }
        self.readings.sort_by(|a, b| b.over_limit().total_cmp(&a.over_limit()));
    }

    /// Sources and targets of the outliers.
    fn outlying(&self) -> BTreeSet<(ReadingSource, usize)> {
        self.outliers().iter().map(|reading| (reading.source, reading.target)).collect()
    }

    /// Readings of a fit.
    fn measured(
        robot: &dyn Robot,
        observations: &[Observation],
        settings: &Settings,
        free: &[usize],
        Fit { values, scatter }: Fit,
    ) -> Self {
        let scaled = scatter.weighted(settings);
        let predicted = comparison(robot, observations, &scaled, free, &values)
            .and_then(|(problem, x)| predictions(&problem, &x, problem.matrix_at(&x)));
        let mut factors = predicted.into_iter().flatten().map(|p| (1.0 + p.variance).sqrt());
        let scale = |(&quantity, (scale, _)): (&Option<ErrorKind>, &(f64, usize))| {
            (quantity, scale.max(stated_deviation(settings, quantity)))
        };
        let scales: BTreeMap<_, _> = scatter.0.iter().map(scale).collect();
        let deviating = |(mut reading, rows): (Reading, usize)| {
            let factor = mean((0..rows).map(|_| factors.next().unwrap_or(1.0)));
            let least = scales.get(&reading.quantity).copied().unwrap_or(LEAST_RESIDUAL);
            reading.deviation = factor * reading.deviation.max(least);
            reading
        };
        let all = readings(robot, observations, &settings.conditions, &values);
        let mut readings: Vec<Reading> = all.into_iter().map(deviating).collect();
        readings.retain(|reading| reading.is_judged(&settings.conditions));
        let region = Region::new(robot, observations, &settings.conditions);
        let lengths = scales.iter().filter(|(of, scale)| of.is_some() && shows_misfit(**scale, **of, settings));
        let largest_mm = lengths.map(|(_, scale)| *scale).fold(0.0, f64::max);
        for &quantity in scales.keys().filter(|quantity| is_incomplete(&scales, settings, **quantity)) {
            let limit = outlier_limit(&readings, quantity);
            for reading in readings.iter_mut().filter(|r| r.quantity == quantity) {
                let joints = match reading.source {
                    ReadingSource::Position(i) => &observations[i].joints,
                    ReadingSource::Condition(i) => &settings.conditions[i].joints,
                };
                let own = limit * region.distance(joints).max(1.0).powi(2);
                let common = quantity.map_or(0.0, |_| COMMON * largest_mm / reading.deviation);
                reading.limit = own.max(common);
            }
        }
        let fitted = [observations.len(), settings.conditions.len()];
        Self { readings, scales, values, fitted }.sorted()
    }

    fn sorted(mut self) -> Self {
        self.readings.sort_by(|a, b| b.over_limit().total_cmp(&a.over_limit()));
        self
    }

    /// Smallest outlier limit of a quantity, in standard deviations.
    pub fn limit(&self, quantity: Option<ErrorKind>) -> f64 {
        let limits = self.readings.iter().filter(|r| r.quantity == quantity).map(|r| r.limit);
        limits.reduce(f64::min).unwrap_or(OUTLIER)
    }

    /// `true` if every outlier is this many times as far as any other reading, relative to their
    /// outlier limits.
    pub fn is_separated(&self, times: f64) -> bool {
        let (outliers, others) = self.readings.split_at(self.outliers().len());
        let least = outliers.last().map_or(f64::INFINITY, Reading::over_limit);
        others.first().is_none_or(|other| least > times * other.over_limit())
    }

    /// Adds the readings of the observations and conditions that follow the fitted ones. They have
    /// the standard deviations of the fitted readings.
    pub fn with_others(mut self, robot: &dyn Robot, observations: &[Observation], conditions: &[Condition]) -> Self {
        let fitted = self.fitted;
        let is_other = |source: ReadingSource| match source {
            ReadingSource::Position(i) => i >= fitted[0],
            ReadingSource::Condition(i) => i >= fitted[1],
        };
        for (mut reading, _) in readings(robot, observations, conditions, &self.values) {
            let scale = self.scales.get(&reading.quantity);
            if let Some(scale) = scale.filter(|_| is_other(reading.source) && reading.is_judged(conditions)) {
                reading.deviation = reading.deviation.max(*scale);
                reading.limit = self.limit(reading.quantity);
                self.readings.push(reading);
            }
        }
        self.sorted()
    }

    /// `true` if a robot can leave such residuals: the outliers are readings, not the model.
    pub fn is_possible(&self, robot: &dyn Robot, observations: &[Observation], settings: &Settings) -> bool {
        let scale = |(quantity, scale): (&Option<ErrorKind>, &f64)| (quantity.is_none(), *scale);
        is_possible_misfit(robot, observations, settings, &self.values, self.scales.iter().map(scale))
    }

    /// Outlying readings, the largest first.
    pub fn outliers(&self) -> &[Reading] {
        let beyond = self.readings.iter().take_while(|r| r.over_limit() > 1.0);
        &self.readings[..beyond.count()]
    }
}

/// Outlier limit of a quantity (standard deviations) by the tail of its residuals: the misfit of a
/// model is larger at some poses than at others. A Weibull distribution through the median and the
/// largest residual of the most readings that are right gives the largest residual by chance.
fn outlier_limit(readings: &[Reading], quantity: Option<ErrorKind>) -> f64 {
    let mut sizes: Vec<f64> = readings.iter().filter(|r| r.quantity == quantity).map(Reading::over_deviation).collect();
    sizes.sort_by(f64::total_cmp);
    let at = |share: f64| sizes[((sizes.len() - 1) as f64 * share).round() as usize];
    if sizes.len() < FEWEST_OF_TAIL || at(0.5) <= 0.0 {
        return OUTLIER;
    }
    let of_share = |share: f64| -(1.0 - share).ln();
    let most = 1.0 - FEW;
    let shape = (of_share(most) / of_share(0.5)).ln() / (at(most) / at(0.5)).ln();
    let largest = at(0.5) * ((readings.len() as f64 / CHANCE).ln() / of_share(0.5)).powf(1.0 / shape);
    largest.clamp(OUTLIER, GROSS)
}

/// Middle of the measured values of each joint, and the distance from it within which the values of
/// most poses are, extended to all of a uniform distribution.
struct Region(Vec<(f64, f64)>);

impl Region {
    fn new(robot: &dyn Robot, observations: &[Observation], conditions: &[Condition]) -> Self {
        let seen = || observations.iter().map(|o| &o.joints).chain(conditions.iter().map(|c| &c.joints));
        let joint = |j: usize| {
            let middle = median(seen().map(|q| q[j])).unwrap_or_default();
            let mut distances: Vec<f64> = seen().map(|q| (q[j] - middle).abs()).collect();
            distances.sort_by(f64::total_cmp);
            let most = (distances.len().max(1) - 1) as f64 * MOST_OF_REGION;
            (middle, distances.get(most.round() as usize).map_or(0.0, |most| most / MOST_OF_REGION))
        };
        Self((0..robot.joints().len()).map(joint).collect())
    }

    /// Distance of joint values from the middle; 1 is the edge.
    fn distance(&self, joints: &[f64]) -> f64 {
        let moving = self.0.iter().zip(joints).filter(|((_, edge), _)| *edge > 0.0);
        moving.map(|((middle, edge), q)| (q - middle).abs() / edge).fold(0.0, f64::max)
    }
}

/// Smallest standard uncertainty (mm, rad) that is given for a quantity; infinite without one.
fn stated_deviation(settings: &Settings, quantity: Option<ErrorKind>) -> f64 {
    let conditions = settings.conditions.iter().filter(|c| is_judged(c) && c.kind.error_kind() == quantity);
    let least = conditions.map(|c| c.standard_uncertainty).fold(f64::INFINITY, f64::min);
    if quantity == Some(ErrorKind::Position) { least.min(settings.coordinate_uncertainty_mm()) } else { least }
}

/// `true` if the scatter of a quantity shows that the model is incomplete.
fn shows_misfit(scale: f64, quantity: Option<ErrorKind>, settings: &Settings) -> bool {
    let stated = stated_deviation(settings, quantity);
    stated > 0.0 && scale > MISFIT * stated
}

/// `true` if the scatter of any quantity shows that the model is incomplete, or if none is given to
/// compare the scatter of this quantity with. Errors that a model lacks are common to all
/// quantities.
fn is_incomplete(scales: &BTreeMap<Option<ErrorKind>, f64>, settings: &Settings, quantity: Option<ErrorKind>) -> bool {
    let stated = stated_deviation(settings, quantity);
    scales.iter().any(|(of, scale)| shows_misfit(*scale, *of, settings)) || stated <= 0.0 || !stated.is_finite()
}

/// `true` if the residuals of a condition are judged: observed joint values are inputs of the
/// model.
fn is_judged(c: &Condition) -> bool {
    !matches!(c.kind, Kind::Joint(_))
}

/// A residual about its prediction by the fit with the Cauchy loss.
struct Predicted {
    left: f64,
    /// Variance of the prediction, J C Jᵀ: a pose far from the others is predicted less
    /// accurately.
    variance: f64,
    /// Share of the error that the residual shows.
    redundancy: f64,
}

/// Residuals at all parameters `values`, and the free parameters, for a comparison of readings.
fn comparison<'a>(
    robot: &'a dyn Robot,
    observations: &'a [Observation],
    scaled: &'a Settings,
    free: &[usize],
    values: &[f64],
) -> Option<(Residuals<'a>, Vec<f64>)> {
    let mut problem = Residuals::new(robot, observations, scaled, free, values).ok()?;
    problem.layout = None;
    (free.len() <= MOST_PARAMETERS).then(|| (problem, free.iter().map(|&i| values[i]).collect()))
}

/// Predictions of the residuals, in their units, by a fit with these rows of the Jacobian.
fn predictions(problem: &Residuals, x: &[f64], rows: DMatrix<f64>) -> Option<Vec<Predicted>> {
    let (m, n) = rows.shape();
    let mut residuals = vec![0.0; m];
    problem.residuals(x, &mut residuals);
    let norms: Vec<f64> = rows.column_iter().map(|c| c.norm().max(f64::MIN_POSITIVE)).collect();
    let rows = rows * DMatrix::from_diagonal(&DVector::from_iterator(n, norms.iter().map(|v| 1.0 / v)));
    let weights: Vec<f64> = residuals.iter().map(|r| 1.0 / (1.0 + (r / CAUCHY).powi(2))).collect();
    let weighted = DMatrix::from_fn(m, n, |i, j| weights[i].sqrt() * rows[(i, j)]);
    let right = DVector::from_fn(m, |i, _| weights[i].sqrt() * residuals[i]);
    let normal = weighted.tr_mul(&weighted) + DMatrix::identity(n, n) * 1e-12;
    let inverse = Cholesky::new(normal)?.inverse();
    let change = &rows * (&inverse * weighted.tr_mul(&right));
    let spread = &rows * inverse;
    let one = |i: usize| {
        let variance = spread.row(i).dot(&rows.row(i));
        Predicted { left: residuals[i] - change[i], variance, redundancy: 1.0 - weights[i] * variance }
    };
    Some((0..problem.measured_count()).map(one).collect())
}

/// Standard deviation (mm, rad) of the residuals of each quantity, from their median size, and
/// their number.
#[derive(Clone, Debug)]
struct Scatter(BTreeMap<Option<ErrorKind>, (f64, usize)>);

impl Scatter {
    /// Scatter of most residuals at `values`; `None` without residuals, or if one is not a number.
    fn new(robot: &dyn Robot, observations: &[Observation], conditions: &[Condition], values: &[f64]) -> Option<Self> {
        let of_most = |sizes: Vec<f64>| Some(OF_MEDIAN * median(sizes.into_iter().map(f64::abs))?);
        Self::by(robot, observations, conditions, values, of_most)
    }

    /// Scatter by a standard deviation of residuals.
    fn by(
        robot: &dyn Robot,
        observations: &[Observation],
        conditions: &[Condition],
        values: &[f64],
        deviation: impl Fn(Vec<f64>) -> Option<f64>,
    ) -> Option<Self> {
        let mut sizes: BTreeMap<Option<ErrorKind>, Vec<f64>> = BTreeMap::new();
        for o in observations {
            let position = sizes.entry(Some(ErrorKind::Position)).or_default();
            o.misses(robot, values).for_each(|(_, miss)| position.extend(&miss[..robot.dimension()]));
        }
        for c in conditions.iter().filter(|c| is_judged(c)) {
            let (residuals, rows) = c.residuals_at(robot, values);
            sizes.entry(c.kind.error_kind()).or_default().extend(&residuals[..rows]);
        }
        sizes.retain(|_, sizes| !sizes.is_empty());
        let scale = |(quantity, sizes): (Option<ErrorKind>, Vec<f64>)| {
            let count = sizes.len();
            let scale = deviation(sizes)?;
            scale.is_finite().then_some((quantity, (scale.max(LEAST_RESIDUAL), count)))
        };
        let finite = sizes.values().flatten().all(|v| v.is_finite());
        let scales = sizes.into_iter().map(scale).collect::<Option<_>>().filter(|_| finite)?;
        Some(Self(scales)).filter(|scatter| !scatter.0.is_empty())
    }

    fn scale(&self, quantity: Option<ErrorKind>) -> f64 {
        self.0.get(&quantity).map_or(LEAST_RESIDUAL, |(scale, _)| *scale)
    }

    /// Geometric mean over all residuals.
    fn mean(&self) -> f64 {
        let count: usize = self.0.values().map(|(_, count)| count).sum();
        (self.0.values().map(|(scale, n)| *n as f64 * scale.ln()).sum::<f64>() / count as f64).exp()
    }

    /// Settings that weight each quantity by its scatter.
    fn weighted(&self, settings: &Settings) -> Settings {
        let mut scaled = Settings {
            kind: ResidualKind::Targets,
            standard_uncertainty_mm: Some(self.scale(Some(ErrorKind::Position))),
            common_uncertainty_mm: None,
            hold: Vec::new(),
            ..settings.clone()
        };
        for c in &mut scaled.conditions {
            if is_judged(c) {
                c.standard_uncertainty = c.standard_uncertainty.max(self.scale(c.kind.error_kind()));
            }
        }
        scaled
    }
}

/// A robust fit.
struct Fit {
    /// All parameters.
    values: Vec<f64>,
    scatter: Scatter,
}

impl Fit {
    /// Least squares without the outliers of a fit. Their scatter is the root mean square.
    fn without(
        robot: &dyn Robot,
        observations: &[Observation],
        settings: &Settings,
        free: &[usize],
        found: &RobustFit,
    ) -> Option<Self> {
        let outlying = found.outlying();
        let mut kept: Vec<Observation> = Vec::new();
        for (i, o) in observations.iter().enumerate() {
            let mut o = Observation { covariances_mm2: Vec::new(), ..o.clone() };
            let targets = o.targets.iter_mut().enumerate();
            let outliers = targets.filter(|(k, _)| outlying.contains(&(ReadingSource::Position(i), *k)));
            outliers.for_each(|(_, at)| *at = None);
            kept.extend(Some(o).filter(|o| o.targets.iter().any(Option::is_some)));
        }
        let conditions = settings.conditions.iter().enumerate();
        let conditions: Vec<Condition> = conditions
            .filter(|(i, c)| !outlying.contains(&(ReadingSource::Condition(*i), c.target)))
            .map(|(_, c)| c.clone())
            .collect();
        let settings = Settings { conditions, ..settings.clone() };
        let scatter = |values: &[f64]| {
            let deviation = |sizes: Vec<f64>| Some(rms(sizes));
            Scatter::by(robot, &kept, &settings.conditions, values, deviation)
        };
        let scaled = scatter(&found.values)?.weighted(&settings);
        let problem = Residuals::new(robot, &kept, &scaled, free, &found.values).ok()?;
        let x: Vec<f64> = free.iter().map(|&i| found.values[i]).collect();
        let options = Options { iterations: 50, step: 1e-6, ..Options::default() };
        let values = problem.all(&etalon_math::solve(&problem, &x, options).x);
        Some(Self { scatter: scatter(&values)?, values })
    }

    /// Fits with the Cauchy loss from `values`, whose scales follow the median residuals down.
    fn new(
        robot: &dyn Robot,
        observations: &[Observation],
        settings: &Settings,
        free: &[usize],
        values: Vec<f64>,
    ) -> Option<Self> {
        let scatter = |values: &[f64]| Scatter::new(robot, observations, &settings.conditions, values);
        let mut best = Self { scatter: scatter(&values)?, values };
        for _ in 0..FITS {
            let scaled = best.scatter.weighted(settings);
            let problem = Residuals::new(robot, observations, &scaled, free, &best.values).ok()?;
            let x: Vec<f64> = free.iter().map(|&i| best.values[i]).collect();
            let options = Options { iterations: 50, step: 1e-6, loss: Loss::Cauchy(CAUCHY), ..Options::default() };
            let values = problem.all(&etalon_math::solve(&problem, &x, options).x);
            let next = Self { scatter: scatter(&values)?, values };
            let settled = next.scatter.mean() > BELOW * best.scatter.mean();
            if next.scatter.mean() < best.scatter.mean() {
                best = next;
            }
            if settled {
                break;
            }
        }
        Some(best)
    }
}

/// Parameters that fit the majority of the measurements best: fits from the identified and from the
/// nominal parameters. Fits from the nominal parameters use a part of many observations, and all of
/// them only if this reduces the scatter.
fn robust(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    free: &[usize],
    found: &[f64],
) -> Option<Fit> {
    let unweighted = |o: &Observation| Observation { covariances_mm2: Vec::new(), ..o.clone() };
    let all = &observations.iter().map(unweighted).collect::<Vec<_>>()[..];
    let mut nominal = found.to_vec();
    for &i in free.iter().filter(|&&i| robot.parameters()[i].role == Role::Robot) {
        nominal[i] = robot.parameters()[i].nominal;
    }
    let best = Fit::new(robot, all, settings, free, found.to_vec());
    let below = |scatter: &Scatter| best.as_ref().is_none_or(|best| scatter.mean() < BELOW * best.scatter.mean());
    let every = (all.len() + settings.conditions.len()) / PART;
    let other = if every > 1 {
        let part: Vec<Observation> = all.iter().step_by(every).cloned().collect();
        let conditions = settings.conditions.iter().step_by(every).cloned().collect();
        let some = Settings { conditions, ..settings.clone() };
        Fit::new(robot, &part, &some, free, nominal)
            .filter(|fit| Scatter::new(robot, all, &settings.conditions, &fit.values).is_some_and(|s| below(&s)))
            .and_then(|fit| Fit::new(robot, all, settings, free, fit.values))
    } else {
        Fit::new(robot, all, settings, free, nominal)
    };
    [best, other].into_iter().flatten().min_by(|a, b| a.scatter.mean().total_cmp(&b.scatter.mean()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_robots::Prexyt;

    /// Values from 0 to 10 have the middle 5, and nine of ten are within 5 of it: the edge is
    /// 5/0.9. A joint that does not move has no edge.
    #[test]
    fn the_region_of_the_joint_values_by_hand() {
        let joints = |q: f64| vec![q, 3.0, 2.0 * q];
        let pose = |q: u32| Observation { joints: joints(f64::from(q)), ..Observation::default() };
        let observations: Vec<Observation> = (0..=10).map(pose).collect();
        let region = Region::new(&Prexyt::default(), &observations, &[]);
        for (q, distance) in [(5.0, 0.0), (10.0, 0.9), (5.0 - 10.0 / 0.9, 2.0)] {
            assert!((region.distance(&joints(q)) - distance).abs() < 1e-12, "{q}: {}", region.distance(&joints(q)));
        }
        assert!((region.distance(&[5.0, 90.0, 10.0])).abs() < 1e-12);
    }
}
