//! Diagnosis: the cause of a missing result, and outliers, the largest residuals of a robust fit.

use crate::judge::{exchanged_poses, set_up_error};
use crate::judgement::robust::CAUCHY;
use crate::model::observation::misplaced;
use crate::model::residuals::{OF_MEDIAN, Residuals};
use crate::solution::estimation::Estimation;
use crate::solution::identifiability::Analysis;
use crate::{Cause, Error, Identification, Observation, ResidualKind, Settings, unseen_by};
use etalon_base::pose::{Vector, minus, norm};
use etalon_base::pose_name::PoseName;
use etalon_math::statistics::median;
use etalon_math::{Loss, Options, Problem, Termination};
use etalon_robots::{Robot, Role};
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
    let (cause, set_up) = (cause(robot, observations, start), set_up_error(robot, observations, settings));
    let cause = cause.or_else(|| wrong_readings(robot, observations, settings, wanted, start));
    Error::Failed { termination, cause, set_up }
}

/// Largest share of readings that are wrong among correct ones.
const FEW: f64 = 0.2;

/// Readings that most others contradict, by a robust fit from `start`.
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
    let exchanged = exchanged_poses(robot, observations, &robust);
    (few && !poses.is_empty()).then_some(Cause::Readings { poses, exchanged })
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

/// Outlier limit in robust standard deviations of a coordinate: with three coordinates, fewer than
/// one of ten million normal errors exceeds it.
pub const OUTLIER: f64 = 6.0;
/// Number of fits, each with the scale of the previous one.
const FITS: usize = 12;
/// A median residual below this share of another one belongs to a better fit.
const BELOW: f64 = 0.9;
/// Minimum number of observations in the part with which the fit from the nominal parameters
/// begins.
const PART: usize = 60;
/// Minimum scale (mm) of residuals: no instrument resolves less.
pub const LEAST_MM: f64 = 1e-6;

/// Residual of every reading after a robust fit.
#[derive(Clone, Debug)]
pub struct RobustFit {
    /// The largest first.
    pub readings: Vec<Reading>,
    /// Standard deviation (mm) of a coordinate: by the majority of the residuals, or the given one
    /// if that is larger.
    pub scale_mm: f64,
    /// All parameters of the robust fit.
    pub values: Vec<f64>,
}

/// Residual of a measured target.
#[derive(Clone, Debug)]
pub struct Reading {
    /// Index of its observation.
    pub observation: usize,
    /// Index of its target.
    pub target: usize,
    /// Name of the pose.
    pub pose: PoseName,
    /// Number of the repeat.
    pub cycle: i64,
    /// Distance, mm.
    pub left_mm: f64,
    /// Standard uncertainty (mm) of a coordinate that the reading itself gives; 0 without.
    own_mm: f64,
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
        let values = robust(robot, observations, settings, &free, start)?;
        let scale_mm = OF_MEDIAN * median_mm(robot, observations, &values)?;
        let scale_mm = scale_mm.max(settings.coordinate_uncertainty_mm()).max(LEAST_MM);
        let mut readings = Vec::new();
        for (observation, o) in observations.iter().enumerate() {
            let own: BTreeMap<usize, f64> = o.uncertainties_mm(robot.dimension()).collect();
            readings.extend(o.misses(robot, &values).map(|(target, miss)| Reading {
                observation,
                target,
                pose: o.pose,
                cycle: o.cycle,
                left_mm: norm(miss),
                own_mm: own.get(&target).copied().unwrap_or(0.0),
            }));
        }
        let beyond = |r: &Reading| r.left_mm / r.own_mm.max(scale_mm);
        readings.sort_by(|a, b| beyond(b).total_cmp(&beyond(a)));
        Some(Self { readings, scale_mm, values })
    }

    /// Outlying readings, the largest first.
    pub fn outliers(&self) -> &[Reading] {
        let beyond = self.readings.iter().take_while(|r| r.left_mm > OUTLIER * r.own_mm.max(self.scale_mm));
        &self.readings[..beyond.count()]
    }
}

/// Parameters that fit the majority of the measurements best: fits with the Cauchy loss, whose
/// scale follows the median residual down, from the identified and from the nominal parameters.
/// Fits from the nominal parameters use a part of many observations, and all of them only if this
/// reduces the scale.
fn robust(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    free: &[usize],
    found: &[f64],
) -> Option<Vec<f64>> {
    let unweighted = |o: &Observation| Observation { covariances_mm2: Vec::new(), ..o.clone() };
    let all = &observations.iter().map(unweighted).collect::<Vec<_>>()[..];
    let start = |observations: &[Observation], values: Vec<f64>| {
        let mut best = (median_mm(robot, observations, &values)?, values);
        for _ in 0..FITS {
            let scaled = Settings {
                kind: ResidualKind::Targets,
                standard_uncertainty_mm: Some((OF_MEDIAN * best.0).max(LEAST_MM)),
                common_uncertainty_mm: None,
                hold: Vec::new(),
                ..settings.clone()
            };
            let problem = Residuals::new(robot, observations, &scaled, free, &best.1).ok()?;
            let x: Vec<f64> = free.iter().map(|&i| best.1[i]).collect();
            let options = Options { iterations: 50, step: 1e-6, loss: Loss::Cauchy(CAUCHY), ..Options::default() };
            let values = problem.all(&etalon_math::solve(&problem, &x, options).x);
            let median = median_mm(robot, observations, &values)?;
            let settled = median > BELOW * best.0;
            if median < best.0 {
                best = (median, values);
            }
            if settled {
                break;
            }
        }
        Some(best)
    };
    let mut nominal = found.to_vec();
    for &i in free.iter().filter(|&&i| robot.parameters()[i].role == Role::Robot) {
        nominal[i] = robot.parameters()[i].nominal;
    }
    let best = start(all, found.to_vec());
    let below = |median_mm: f64| best.as_ref().is_none_or(|best| median_mm < BELOW * best.0);
    let every = all.len() / PART;
    let other = if every > 1 {
        let part: Vec<Observation> = all.iter().step_by(every).cloned().collect();
        start(&part, nominal)
            .filter(|(_, values)| median_mm(robot, all, values).is_some_and(below))
            .and_then(|(_, values)| start(all, values))
    } else {
        start(all, nominal)
    };
    [best, other].into_iter().flatten().min_by(|a, b| a.0.total_cmp(&b.0)).map(|best| best.1)
}

/// Median size (mm) of the differences of coordinates; `None` if one is not a number.
fn median_mm(robot: &dyn Robot, observations: &[Observation], values: &[f64]) -> Option<f64> {
    let mut sizes = Vec::new();
    for o in observations {
        for (k, measured) in o.targets.iter().enumerate() {
            let Some(measured) = measured else { continue };
            let predicted = robot.position(values, &o.joints, k);
            sizes.extend((0..robot.dimension()).map(|i| (measured[i] - predicted[i]).abs()));
        }
    }
    sizes.iter().all(|s| s.is_finite()).then(|| median(sizes))?
}
