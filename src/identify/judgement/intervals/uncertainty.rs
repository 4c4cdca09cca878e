//! Uncertainty of the parameters: covariance and chi-square.

use crate::Result;
use crate::error::quoted;
use crate::judgement::beyond::{Extrapolation, extrapolations};
use crate::judgement::budget::{self, Budget, Observed, Systematic};
use crate::judgement::chi_square::{exceeds, falls_short};
use crate::judgement::clusters::ByCluster;
use crate::judgement::figures::{ConditionResiduals, ErrorKind, ReadingKind};
use crate::judgement::regional::{BetweenSeries, Regional};
use crate::model::elimination::{Remaining, carried, root};
use crate::model::frame_error::FrameError;
use crate::model::prior::Prior;
use crate::model::residuals::Residuals;
use crate::model::rigid_part::{Contradicted, Shape};
use crate::model::solved::Solved;
use crate::solution::estimation::Estimation;
use crate::solution::observability::{Observability, WeakGroup, held_singular_values, observe, weak_message};
use crate::solution::solver::Identifiable;
use crate::{
    Group, Identifiability, Identification, Observation, ParameterUncertainty, ResidualKind, ResidualStatistics,
    Settings, Status, Subject, Warning,
};
use etalon_base::message::Message;
use etalon_base::pose_name::PoseName;
use etalon_base::{phrase, warning};
use etalon_math::statistics::{median, rms};
use etalon_math::{Factor, Problem, Solution, column_norms, factor_at};
use etalon_robots::{Robot, Role};
use nalgebra::{DMatrix, DVector, Matrix3x4};
use std::collections::{BTreeMap, BTreeSet};

/// Source of the standard uncertainties.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UncertaintyFrom {
    /// Given uncertainty of the instrument; chi-square does not reject the model.
    Instrument,
    /// Residuals, taken as independent.
    Residuals,
    /// Residuals, grouped by pose: errors of the robot are common to all targets and repeats of a
    /// pose (cluster-robust covariance, Liang & Zeger 1986).
    ResidualsByPose,
    /// Residuals, grouped by region of joint space, because the model error is alike at
    /// neighbouring poses: uncertainty of effective parameters (delete-a-group jackknife, Bell &
    /// McCaffrey 2002).
    ResidualsByRegion,
    /// No source: there are as many equations as parameters, and no uncertainty is given.
    Nothing,
}

/// Parameters of a group that a message names.
const NAMED: usize = 40;

/// Creates the identification of a solution, with its uncertainty.
pub(crate) fn with_uncertainty(
    estimation: Estimation,
    systematic: &Systematic,
    found: Identifiable,
) -> Result<Identification> {
    let Estimation { robot, observations, settings, wanted } = estimation;
    let settings = &Settings { prior: found.prior, ..settings.with_weight(found.weight) };
    let problem = &Residuals::new(robot, observations, settings, &found.free, &found.values)?;
    let Identifiable { values, groups, by_nominal, solution, iterations, weight, .. } = found;
    let solution = &solution;
    let n = problem.free.len();
    let dof = problem.degrees_of_freedom(solution).round() as usize;
    let solved = Solved { problem, solution, jacobian: &solution.jacobian };

    let frames = &systematic.frames;
    let placed: BTreeMap<(PoseName, i64), &FrameError> = frames.iter().filter_map(|f| Some((f.pose?, f))).collect();
    let stated = from_instrument(solved, settings, &placed);
    let chi_square = stated.as_ref().map(|s| s.1).filter(|_| dof > 0);
    let instrument = stated.map(|s| s.0);
    let rejected = chi_square.filter(|&chi| exceeds(chi, dof));
    let apart = settings.kind == ResidualKind::Targets && placed.is_empty() && !problem.is_whitened();
    let found = match &instrument {
        Some(instrument) if rejected.is_none() => {
            let clusters = (apart && dof > 0).then(|| shared(solved, &settings.series)).flatten();
            clusters.unwrap_or_else(|| Found::new(UncertaintyFrom::Instrument, Some(instrument.clone())))
        }
        _ => from_residuals(solved, &settings.series, instrument.as_deref(), chi_square),
    };
    let (between_series, unseen) = found.between_series(&settings.series);
    let Found { mut covariance, from, degrees: effective_degrees, warning, extrapolations, .. } = found;
    let mut warnings: Vec<Warning> = warning.into_iter().chain(unseen).map(Into::into).collect();
    let replicates = || budget::replicates(robot, observations, &values, dof);
    let replicates = (apart && settings.conditions.is_empty()).then(replicates).flatten();
    let mut budget = Budget::default();
    if let Some(total) = &mut covariance {
        budget = Budget::new(solved, instrument.as_deref(), total, settings, replicates.as_ref());
        // what is wrong with the frame of one pose shows in its residuals, and is in the noise
        // above
        let unseen = problem.is_whitened() && from == UncertaintyFrom::Instrument;
        let observed = Observed { robot, observations, settings, free: &problem.free, values: &values };
        budget.carry_frames(frames, solved, unseen, total);
        budget.carry(systematic.errors(&observed)?, solved, total);
    }
    let plain = instrument.or_else(|| independent(problem, solution));
    let inflation_factor = inflation(plain.as_deref(), covariance.as_deref(), n);
    let verdict = chi_square.and_then(|chi| judge_chi_square(chi, dof, inflation_factor, from));
    warnings.extend(verdict.map(Into::into));

    let lengths = lengths(problem, solution);
    let own = solution.factor.as_ref().map(|f| f.block_columns()).unwrap_or_default();
    let separable = Separable::new(problem, solution, &by_nominal, covariance.as_deref());
    let (observability, weak) = observability(problem, solution, settings, wanted, &separable)?;
    warnings.extend(contradictions(problem, solution, &values, covariance.as_deref()));
    warnings.extend(held_messages(robot, &groups));
    warnings.extend(weak_message(robot, &weak).map(Into::into));
    Ok(Identification {
        status: (0..values.len()).map(|i| status(&problem.free, wanted, i)).collect(),
        residuals: ResidualStatistics {
            rms: rms(lengths.iter().copied()) * problem.unit,
            max: lengths.iter().fold(0.0f64, |w, r| w.max(r.abs())) * problem.unit,
            count: problem.measured_count(),
            stated: problem.nominal_rows().start - problem.measured_count(),
            degrees_of_freedom: dof,
            effective_degrees: dof as f64 * square_degrees(problem, solution),
            chi_square,
            coordinates: coordinates(problem, &lengths, observations, settings),
            conditions: ConditionResiduals::all(robot, &values, &settings.conditions),
            replicates,
            between_series,
            extrapolations,
        },
        values,
        free: problem.free.clone(),
        uncertainty: ParameterUncertainty { covariance, from, effective_degrees, inflation_factor, budget },
        identifiability: Identifiability {
            groups,
            weak,
            observability,
            eliminated: own.into_iter().map(|j| problem.free[j]).collect(),
            determined: n as f64 - problem.undetermined(solution),
        },
        weight,
        prior: settings.prior,
        iterations,
        termination: solution.termination,
        warnings,
    })
}

/// Status of a parameter, from the lists of identified parameters and of parameters to identify.
fn status(free: &[usize], wanted: &[usize], index: usize) -> Status {
    match () {
        () if free.contains(&index) => Status::Identified,
        () if wanted.contains(&index) => Status::NotIdentifiable,
        () => Status::Fixed,
    }
}

/// Free parameters that the data determine separately: all but those that only nominal values
/// separate from others.
struct Separable {
    free: Vec<usize>,
    x: Vec<f64>,
    covariance: Option<Vec<f64>>,
}

impl Separable {
    fn new(problem: &Residuals, solution: &Solution, by_nominal: &[usize], covariance: Option<&[f64]>) -> Self {
        let n = problem.free.len();
        let kept: Vec<usize> = (0..n).filter(|&k| !by_nominal.contains(&problem.free[k])).collect();
        let of = |all: &[f64]| {
            kept.iter().flat_map(|i| kept.iter().map(move |j| (i, j))).map(|(i, j)| all[i * n + j]).collect()
        };
        Self {
            free: kept.iter().map(|&k| problem.free[k]).collect(),
            x: kept.iter().map(|&k| solution.x[k]).collect(),
            covariance: covariance.map(of),
        }
    }
}

/// Observability by the measurements alone, and the weakly determined parameters.
fn observability(
    problem: &Residuals,
    solution: &Solution,
    settings: &Settings,
    wanted: &[usize],
    separable: &Separable,
) -> Result<(Option<Observability>, Vec<WeakGroup>)> {
    let values = problem.all(&solution.x);
    let plain = settings.without_prior();
    let observed = match (settings.prior, &solution.factor) {
        (Prior::None, factor) => {
            let covariance = separable.covariance.as_deref();
            factor.as_ref().and_then(|f| observe(problem, &solution.x, f, &solution.scale, covariance))
        }
        // nominal values are not observed
        (Prior::Tolerances { .. }, _) if separable.free.is_empty() => None,
        (Prior::Tolerances { .. }, _) => {
            let data = problem.with_free_parameters(&plain, &separable.free, &values)?;
            let whole = solution.measured.as_ref().filter(|_| data.prior_count() == 0 && data.free == problem.free);
            let (factor, scale) = match whole {
                Some(factor) => {
                    let (factor, norms) = factor.clone().normalised();
                    (factor, norms.iter().zip(&solution.scale).map(|(norm, scale)| norm * scale).collect())
                }
                None => factor_at(&data, &separable.x),
            };
            observe(&data, &separable.x, &factor, &scale, separable.covariance.as_deref())
        }
    };
    let (mut observability, weak) = observed.map_or((None, Vec::new()), |(o, w)| (Some(o), w));
    if let Some(o) = &mut observability {
        let all = problem.with_free_parameters(&plain, wanted, &values)?;
        o.held_singular_values = held_singular_values(&all, &values, o);
    }
    Ok((observability, weak))
}

/// Root mean square (mm) of the measured residuals that are lengths.
pub(crate) fn rms_mm(problem: &Residuals, solution: &Solution) -> f64 {
    rms(lengths(problem, solution)) * problem.unit
}

/// The measured residuals that are lengths, in the unit of the residuals.
fn lengths(problem: &Residuals, solution: &Solution) -> Vec<f64> {
    let mut plain = vec![0.0; problem.measured_count()];
    problem.plain_residuals(&solution.x, &mut plain);
    plain.iter().zip(problem.sizes()).filter_map(|(r, size)| Some(r * size?)).collect()
}

/// Residuals of the coordinates of targets, which are the first `lengths`, and their stated
/// uncertainty; `None` without coordinates or a stated uncertainty, and for residuals of a pose.
fn coordinates(
    problem: &Residuals,
    lengths: &[f64],
    observations: &[Observation],
    settings: &Settings,
) -> Option<ConditionResiduals> {
    let (count, dimension) = (problem.coordinate_count(), problem.robot.dimension());
    settings.standard_uncertainty_mm.filter(|_| count > 0 && settings.kind == ResidualKind::Targets)?;
    let own = observations.iter().flat_map(|o| o.uncertainties_mm(dimension)).map(|(_, u)| u * u);
    let (weighted, variances) = own.fold((0, 0.0), |(count, sum), square| (count + 1, sum + square));
    let readings = count / dimension;
    let others = readings.saturating_sub(weighted) as f64 * settings.coordinate_uncertainty_mm().powi(2);
    Some(ConditionResiduals {
        kind: ReadingKind::Error(ErrorKind::Position),
        count,
        rms: rms(lengths[..count].iter().copied()) * problem.unit,
        standard_uncertainty: ((variances + others) / readings as f64).sqrt(),
    })
}

/// Effective degrees of freedom of the square of a residual, at most 1: of the sum s of the n
/// squares of a pose, 2 E(s)²/Var(s) is n times this number (Satterthwaite). 1 if the residuals
/// belong to several poses.
fn square_degrees(problem: &Residuals, solution: &Solution) -> f64 {
    if problem.is_whitened() {
        return 1.0;
    }
    let mut by_pose: BTreeMap<PoseName, (f64, f64)> = BTreeMap::new();
    for (pose, r) in problem.poses().into_iter().zip(&solution.residuals) {
        let (squares, count) = by_pose.entry(pose).or_default();
        (*squares, *count) = (*squares + r * r, *count + 1.0);
    }
    let (squares, count) = by_pose.values().fold((0.0, 0.0), |sum, one| (sum.0 + one.0, sum.1 + one.1));
    let variance = squares / count;
    let scatter: f64 = by_pose.values().map(|(squares, count)| (squares - count * variance).powi(2)).sum();
    let share = 2.0 * variance.powi(2) * count / scatter;
    if share.is_finite() { share.min(1.0) } else { 1.0 }
}

/// Ratio (median) of the standard uncertainties of two covariances.
fn inflation(before: Option<&[f64]>, after: Option<&[f64]>, n: usize) -> f64 {
    let (Some(before), Some(after)) = (before, after) else { return 1.0 };
    median((0..n).map(|k| (after[k * n + k] / before[k * n + k]).sqrt())).unwrap_or(1.0)
}

/// Verdict on chi-square.
fn judge_chi_square(chi: f64, dof: usize, inflation_factor: f64, from: UncertaintyFrom) -> Option<Message> {
    match () {
        () if exceeds(chi, dof) => Some(rejection(chi, dof, inflation_factor, from)),
        () if falls_short(chi, dof) => Some(shortfall(chi, dof)),
        () => None,
    }
}

/// A covariance and its source.
pub(crate) struct Found {
    from: UncertaintyFrom,
    covariance: Option<Vec<f64>>,
    degrees: Vec<f64>,
    warning: Option<Message>,
    between_series: Option<BetweenSeries>,
    extrapolations: Vec<Extrapolation>,
}

impl Found {
    fn new(from: UncertaintyFrom, covariance: Option<Vec<f64>>) -> Self {
        Self { from, covariance, degrees: Vec::new(), warning: None, between_series: None, extrapolations: Vec::new() }
    }

    /// Scatter between these series, none where the instrument explains all residuals; a warning if
    /// it is unknown.
    fn between_series(&self, series: &[Vec<PoseName>]) -> (Option<BetweenSeries>, Option<Message>) {
        let count = series.iter().filter(|poses| !poses.is_empty()).count();
        if count < 2 {
            return (None, None);
        }
        let explained = self.from == UncertaintyFrom::Instrument;
        let found = self.between_series.or_else(|| explained.then_some(BetweenSeries { series: count, share: 0.0 }));
        (found, found.is_none().then(|| warning!("series-not-estimated")))
    }

    /// Variance of a parameter.
    #[cfg(test)]
    pub fn variance(&self, k: usize) -> f64 {
        self.covariance.as_ref().map_or(f64::NAN, |c| c[k * c.len().isqrt() + k])
    }
}

/// Chi-square by the given uncertainty of the instrument; `None` without a given uncertainty or
/// without redundancy.
pub(crate) fn chi_square(solved: Solved, settings: &Settings) -> Option<f64> {
    let is_redundant = solved.problem.degrees_of_freedom(solved.solution).round() > 0.0;
    from_instrument(solved, settings, &BTreeMap::new()).map(|stated| stated.1).filter(|_| is_redundant)
}

/// Covariance and chi-square from the given uncertainty of the instrument, and of the frames of
/// single poses.
fn from_instrument(
    solved: Solved,
    settings: &Settings,
    placed: &BTreeMap<(PoseName, i64), &FrameError>,
) -> Option<(Vec<f64>, f64)> {
    let Solved { problem, solution, .. } = solved;
    let u = settings.standard_uncertainty_mm?;
    if settings.kind == ResidualKind::Targets && (placed.is_empty() || problem.is_whitened()) {
        // rows of given shapes count with their own uncertainty
        let more = |(row, shape): (usize, &Shape)| -> f64 {
            let squares = solution.residuals[row..][..shape.rows()].iter().map(|r| r * r).sum::<f64>();
            squares * (1.0 - 1.0 / shape.variance())
        };
        return Some((solution.covariance()?, problem.squares(solution) - problem.shapes().map(more).sum::<f64>()));
    }
    noise_covariance(solution, &solved.rows().dense(), &noise(problem, solution, u, placed)?)
}

/// Covariance from residuals that the instrument's uncertainty does not explain, or without a
/// given uncertainty.
fn from_residuals(
    solved: Solved,
    series: &[Vec<PoseName>],
    instrument: Option<&[f64]>,
    chi_square: Option<f64>,
) -> Found {
    let Solved { problem, solution, .. } = solved;
    let n = solution.x.len();
    let dof = problem.degrees_of_freedom(solution).round() as usize;
    if dof == 0 {
        return Found {
            warning: Some(warning!("no-redundant-observations")),
            ..Found::new(UncertaintyFrom::Nothing, None)
        };
    }
    let found = by_region(solved, series);
    if let Some(found) = found.or_else(|| Some(by_cluster(solved)?.0)) {
        return found;
    }
    let scaled = match (instrument, chi_square) {
        (Some(instrument), Some(chi)) => Some(instrument.iter().map(|v| v * chi / dof as f64).collect()),
        _ => independent(problem, solution),
    };
    Found { degrees: vec![dof as f64; n], ..Found::new(UncertaintyFrom::Residuals, scaled) }
}

/// Covariance from residuals that are taken as independent; `None` without redundancy.
fn independent(problem: &Residuals, solution: &Solution) -> Option<Vec<f64>> {
    let dof = Some(problem.degrees_of_freedom(solution).round()).filter(|dof| *dof > 0.0)?;
    let variance = problem.squares(solution) / dof;
    Some(solution.covariance()?.into_iter().map(|v| v * variance).collect())
}

/// Covariance from the scatter of poses whose readings share errors. Shared errors may be too small
/// for chi-square and still affect every reading.
fn shared(solved: Solved, series: &[Vec<PoseName>]) -> Option<Found> {
    let (found, clusters) = by_cluster(solved).filter(|found| found.1.exceeds())?;
    let warning = warning!("pose-residuals-correlated", ratio = clusters.ratio.sqrt());
    let found = by_region(solved, series).unwrap_or(found);
    Some(Found { warning: Some(warning), ..found })
}

/// Covariance from the scatter between regions of joint space; `None` with few poses.
fn by_region(solved: Solved, series: &[Vec<PoseName>]) -> Option<Found> {
    let Solved { problem, solution, .. } = solved;
    let remaining = Remaining::new(&problem.poses(), solution, solved.rows())?;
    let regional = Regional::new(problem, &remaining, series)?;
    let (covariance, degrees) = regional.covariance(&remaining.root);
    let (covariance, degrees) = completed(problem, solution, &remaining, covariance, degrees)?;
    Some(Found {
        degrees,
        between_series: regional.between,
        extrapolations: extrapolations(problem, &remaining),
        ..Found::new(UncertaintyFrom::ResidualsByRegion, Some(covariance))
    })
}

/// Covariance from the scatter of poses, or of readings common to several poses; `None` if there
/// are too few.
///
/// Of points that are eliminated the readings have the variance of all residuals, and the other
/// parameters' covariance comes on top.
pub(crate) fn by_cluster(solved: Solved) -> Option<(Found, ByCluster)> {
    let Solved { problem, solution, .. } = solved;
    let numbers = problem.clusters();
    let remaining = Remaining::new(&numbers, solution, solved.rows())?;
    let Remaining { jacobian, residuals, root } = &remaining;
    let clusters = ByCluster::new(&numbers, root, residuals, jacobian).filter(ByCluster::is_usable)?;
    let (covariance, degrees) = (clusters.covariance.clone(), clusters.degrees_of_freedom.clone());
    let (covariance, degrees) = completed(problem, solution, &remaining, covariance, degrees)?;
    Some((Found { degrees, ..Found::new(UncertaintyFrom::ResidualsByPose, Some(covariance)) }, clusters))
}

/// Covariance and degrees of freedom of all parameters, from the covariance and the degrees of
/// freedom of the parameters that remain after elimination.
fn completed(
    problem: &Residuals,
    solution: &Solution,
    Remaining { jacobian, root, .. }: &Remaining,
    mut covariance: Vec<f64>,
    mut degrees: Vec<f64>,
) -> Option<(Vec<f64>, Vec<f64>)> {
    let factor = solution.factor.as_ref()?;
    let (common, all) = (factor.common(), factor.columns());
    let n = common.len();
    // a given shape or place is one reading: its rows have the variance that is given, not the
    // scatter of one
    let shapes = problem.shapes().map(|(row, shape)| (row, shape.rows(), shape.variance()));
    let known = problem.known().map(|(row, known)| (row, known.rows(), 1.0));
    let nominal = Some(problem.nominal_rows()).filter(|rows| !rows.is_empty());
    let nominal = nominal.map(|rows| (rows.start, rows.len(), problem.nominal_variance()));
    for (row, count, variance) in shapes.chain(known).chain(nominal) {
        let rows = DMatrix::from_row_slice(count, n, &jacobian[row * n..][..count * n]);
        let step = rows * root;
        let more = carried(root, &(step.tr_mul(&step) * variance));
        covariance.iter_mut().zip(more.iter()).for_each(|(c, more)| *c += more);
    }
    if n < all {
        let scale = |k: usize| solution.scale[common[k]];
        covariance.iter_mut().enumerate().for_each(|(k, c)| *c *= scale(k / n) * scale(k % n));
        let dof = problem.degrees_of_freedom(solution).max(1.0);
        covariance = factor.covariance_with(covariance, problem.squares(solution) / dof)?;
        covariance.iter_mut().enumerate().for_each(|(k, c)| *c /= solution.scale[k / all] * solution.scale[k % all]);
        let mut of_all = vec![degrees.iter().copied().fold(f64::INFINITY, f64::min); all];
        common.iter().zip(&degrees).for_each(|(&j, d)| of_all[j] = *d);
        degrees = of_all;
    }
    Some((covariance, degrees))
}

/// Messages about given shapes that contradict the measurements.
fn contradictions(
    problem: &Residuals,
    solution: &Solution,
    values: &[f64],
    covariance: Option<&[f64]>,
) -> Vec<Warning> {
    let (Some(inverse), Some(covariance)) = (solution.covariance(), covariance) else { return Vec::new() };
    let of = |(_, shape): (_, &Shape)| shape.contradiction(&problem.at(values), &inverse, covariance);
    let warning =
        |c: Contradicted| Warning { message: c.message(&phrase!("stated-positions")), subject: Subject::Shape(c) };
    problem.shapes().filter_map(of).map(warning).collect()
}

fn shortfall(chi_square: f64, degrees: usize) -> Message {
    let ratio = (chi_square / degrees as f64).sqrt();
    warning!("instrument-uncertainty-too-large", ratio, chi_square, degrees)
}

fn rejection(chi_square: f64, degrees: usize, inflation: f64, from: UncertaintyFrom) -> Message {
    let from = match from {
        UncertaintyFrom::ResidualsByPose => "poses",
        UncertaintyFrom::ResidualsByRegion => "regions",
        _ => "residuals",
    };
    let ratio = (chi_square / degrees as f64).sqrt();
    warning!("residuals-exceed-uncertainty", ratio, chi_square, degrees, from, inflation)
}

/// Messages for held parameters; parameters fixed by the choice of base and targets share one, and
/// so do targets without a nominal position that the base replaces.
pub(crate) fn held_messages(robot: &dyn Robot, groups: &[Group]) -> Vec<Warning> {
    let parameters = robot.parameters();
    let of_robot = |i: usize| parameters[i].role == Role::Robot;
    let is_placed_by_base = |g: &&Group| {
        let held = &parameters[g.held];
        held.role == Role::Target
            && held.tolerance.is_infinite()
            && g.useless_uncertainty.is_none()
            && g.with.iter().any(|&i| parameters[i].role == Role::Base)
    };
    let (placed, groups): (Vec<&Group>, Vec<&Group>) = groups.iter().partition(is_placed_by_base);
    let placed: Vec<&str> = placed.iter().map(|g| parameters[g.held].name.as_str()).collect();
    let placed = (!placed.is_empty()).then(|| warning!("target-place-free", parameters = quoted(&placed)).into());
    let by_frames =
        |g: &&Group| g.useless_uncertainty.is_none() && of_robot(g.held) && g.with.iter().any(|&i| !of_robot(i));
    let (frames, others): (Vec<&Group>, Vec<&Group>) = groups.into_iter().partition(by_frames);
    let joined = match &frames[..] {
        [] => None,
        [one] => Some(held_message(robot, one)),
        several => {
            let held: BTreeSet<usize> = several.iter().map(|g| g.held).collect();
            let names: Vec<&str> = held.into_iter().map(|i| parameters[i].name.as_str()).collect();
            Some(warning!("parameters-fixed-by-frames", count = names.len(), parameters = quoted(&names)))
        }
    };
    let joined = joined.map(|message| Warning { message: message.routine(), subject: Subject::HeldByFrames });
    let others = others.into_iter().map(|g| held_message(robot, g).into());
    joined.into_iter().chain(placed).chain(others).collect()
}

fn held_message(robot: &dyn Robot, group: &Group) -> Message {
    let held = &robot.parameters()[group.held];
    let names: Vec<&str> = group.with.iter().take(NAMED).map(|&i| robot.parameters()[i].name.as_str()).collect();
    let (parameter, mut others) = (&held.name, quoted(&names));
    if group.with.len() > NAMED {
        others.push("...".to_owned());
    }
    match group.useless_uncertainty {
        _ if others.is_empty() => warning!("parameter-held-without-effect", parameter),
        None => {
            let message = warning!("parameter-held-inseparable", parameter, others);
            let all: Vec<usize> = group.with.iter().copied().chain([group.held]).collect();
            match robot.remedy(&all) {
                Some(hint) => message.hint(hint),
                None => message,
            }
        }
        Some(u) => {
            let (uncertainty, unit) = (held.quantity.outward(u), held.quantity.unit());
            let held = if held.tolerance.is_infinite() { "placed" } else { "nominal" };
            warning!("parameter-separable-poorly", parameter, others, uncertainty, unit, held)
        }
    }
}

/// Covariance of the residuals of each observation, by its square root from below: the instrument's
/// noise, the noise of the balls for pose residuals, and the uncertainty of the frame that places
/// it. `None` where one is not positive definite.
fn noise(
    problem: &Residuals,
    solution: &Solution,
    u: f64,
    frames: &BTreeMap<(PoseName, i64), &FrameError>,
) -> Option<Vec<DMatrix<f64>>> {
    let sensitivities = problem.target_sensitivities(&solution.x);
    let by_frame = problem.frame_jacobian(&solution.x, None);
    let mut rows = by_frame.chunks_exact(6);
    let root = |(i, (key, count)): (usize, ((PoseName, i64), usize))| {
        let mut noise = match &sensitivities {
            Some(all) => {
                let s = u * Matrix3x4::from_fn(|k, j| all[i][k][j]);
                DMatrix::from_fn(3, 3, |k, j| (s * s.transpose())[(k, j)])
            }
            None => DMatrix::identity(count, count),
        };
        let moved: Vec<f64> = rows.by_ref().take(count).flatten().copied().collect();
        if let Some(frame) = frames.get(&key) {
            let moved = DMatrix::from_row_slice(count, 6, &moved);
            let covariance = DMatrix::from_fn(6, 6, |k, j| frame.covariance[k][j]);
            noise += &moved * covariance * moved.transpose();
        }
        Some(noise.cholesky()?.unpack())
    };
    let shapes = problem.shapes().map(|(_, s)| Some(DMatrix::identity(s.rows(), s.rows()) * s.variance().sqrt()));
    let known = problem.known().map(|(_, known)| Some(DMatrix::identity(known.rows(), known.rows())));
    let nominal = problem.nominal_rows().map(|_| Some(DMatrix::identity(1, 1) * problem.nominal_variance().sqrt()));
    problem.counts().enumerate().map(root).chain(shapes).chain(known).chain(nominal).collect()
}

/// Covariance of unweighted residuals with noise V = L Lᵀ, given by L: A⁻¹ (Σ Jᵀ V J) A⁻¹ with A =
/// JᵀJ, from F with F Fᵀ = A⁻¹; and the least chi-square that the linear model reaches with the
/// residuals weighted by V⁻¹.
fn noise_covariance(solution: &Solution, jacobian: &[f64], noise: &[DMatrix<f64>]) -> Option<(Vec<f64>, f64)> {
    let n = solution.x.len();
    // of points that are eliminated the root is not at hand
    let whole = solution.factor.as_ref()?.block_columns().is_empty();
    let root = if whole {
        root(solution)?
    } else {
        DMatrix::from_row_slice(n, n, &solution.covariance()?).cholesky()?.unpack()
    };
    let mut middle = DMatrix::zeros(n, n);
    let (mut white_rows, mut white_residuals) = (Vec::new(), Vec::new());
    let (mut rows, mut residuals) = (jacobian, &solution.residuals[..]);
    for lower in noise {
        let (here, rest) = rows.split_at_checked(lower.nrows() * n)?;
        let (r, after) = residuals.split_at_checked(lower.nrows())?;
        (rows, residuals) = (rest, after);
        let here = DMatrix::from_row_slice(lower.nrows(), n, here);
        let noisy = lower.tr_mul(&here) * &root; // Lᵀ J F
        middle += noisy.tr_mul(&noisy);
        let white = lower.solve_lower_triangular(&here)?;
        white_rows.extend(white.row_iter().flat_map(|row| row.iter().copied().collect::<Vec<_>>()));
        white_residuals.extend_from_slice(lower.solve_lower_triangular(&DVector::from_column_slice(r))?.as_slice());
    }
    let covariance = carried(&root, &middle);
    let chi_square = Factor::new(&white_rows, &white_residuals, &column_norms(&white_rows, n)).rest;
    Some((covariance.as_slice().to_vec(), chi_square))
}
