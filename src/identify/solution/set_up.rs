//! Errors of the set-up: a reversed joint, a unit, exchanged columns, a convention. The changes
//! that bring the nominal robot nearest to the measurements, with base and targets located again,
//! are hypotheses. A hypothesis is named if it explains the measurements and they cannot be
//! explained without it.

use crate::Observation;
use crate::model::residuals::Residuals;
use crate::solution::hypotheses::{Fitted, Hypothesis, LEAST_MM};
use crate::solution::placing::{
    PLAIN, UNEXPLAINED, measured_parameters, place, spread_mm, spread_over, with_few_targets,
};
use crate::solution::scatter::observed_noise_mm;
use crate::solution::slips::{Change, changes, shifted};
use crate::warning::{Origin, SetUpError, Subject, Warning};
use etalon_base::catalogue::Phrase;
use etalon_base::message::Message;
use etalon_base::pose::{Vector, centroid, minus, norm};
use etalon_base::pose_name::PoseName;
use etalon_base::{error, phrase, warning};
use etalon_math::statistics::{median, rms};
use etalon_math::{Options, factor_at};
use etalon_robots::{Quantity, Robot, Role};
use rayon::prelude::*;

/// Number of poses on which changes are tried.
const SUBSET: usize = 32;
/// Number of changes that are fitted with all parameters: those that bring the nominal robot
/// nearest.
const FITS: usize = 12;
/// Number of nominal values that are fitted with all parameters.
const FITTED_VALUES: usize = 3;
/// Maximum sum of squares, relative to that of other changes, at which a change by a value fitted
/// to the data is named.
const FITTED: f64 = 0.5;
/// Maximum ratio of sums of squares at which further changes are named beside the best one.
const AS_GOOD: f64 = 1.2;
/// Largest residual of one coordinate attributed to noise if poses are few, in standard
/// uncertainties of a coordinate.
const NOISE_COORDINATE: f64 = 3.0;
/// Maximum number of named changes.
const NAMED: usize = 3;

/// Replaces the hint of a message by the change of the set-up that explains it, if there is one.
pub(crate) fn explained(message: Message, robot: &dyn Robot, observations: &[Observation], noise_mm: f64) -> Warning {
    let Some(found) = set_up_error(robot, observations, noise_mm) else { return message.into() };
    Warning {
        message: {
            let hint = found.to_check(|_| None);
            message.hint(hint)
        },
        subject: Subject::SetUp(found),
    }
}

/// Root mean square error (mm) of a nominal robot whose parameters deviate from nominal as their
/// tolerances, taken as half-widths of rectangular distributions (GUM 4.3.7), allow; base and
/// targets, at `values`, absorb as much as they can.
///
/// `noise_mm` is the stated standard uncertainty of a coordinate; the noise that the observations
/// show counts if it is larger. What is allowed is never more than a
/// tenth of the spread of the measurements: with nominal values that are wrong themselves the
/// Jacobian allows anything.
pub fn allowed_mm(robot: &dyn Robot, observations: &[Observation], values: &[f64], noise_mm: f64) -> Option<f64> {
    let effect_mm = tolerance_effect_mm(robot, observations, values)?;
    let noise_mm = observed_noise_mm(robot, observations, noise_mm);
    let noise = robot.dimension() as f64 * (NOISE_COORDINATE * noise_mm).powi(2);
    let most = (UNEXPLAINED * spread_mm(observations)).max(noise.sqrt());
    Some((effect_mm.powi(2) + noise).sqrt().min(most)).filter(|v| v.is_finite())
}

/// Root mean square effect (mm) on the positions of parameters that deviate from nominal as their
/// tolerances allow, as far as base and targets, at `values`, do not absorb it; NaN where the robot
/// cannot be at the joint values.
pub fn tolerance_effect_mm(robot: &dyn Robot, observations: &[Observation], values: &[f64]) -> Option<f64> {
    let few = with_few_targets(robot, observations);
    let observations = few.as_ref().map_or(observations, |few| &few.0);
    let shown = measured_parameters(robot, observations);
    let (own, places): (Vec<usize>, _) = shown.iter().partition(|&&i| robot.parameters()[i].role == Role::Robot);
    let free = [places.as_slice(), &own].concat();
    let problem = Residuals::new(robot, observations, &PLAIN, &free, values).ok()?;
    let x: Vec<f64> = free.iter().map(|&i| values[i]).collect();
    let (factor, norms) = factor_at(&problem, &x);
    // what of a column base and targets do not take up lies below their rows
    let common = factor.common();
    let first = common.iter().take_while(|&&j| j < places.len()).count();
    let left = |k: usize| (first..=k).map(|i| factor.r(i, k).powi(2)).sum::<f64>() * norms[common[k]].powi(2);
    let variance = |k: usize| left(k) * robot.parameters()[free[common[k]]].tolerance.powi(2) / 3.0;
    let points = observations.iter().flat_map(|o| o.targets.iter().flatten()).count();
    let sum: f64 = (first..common.len()).map(variance).sum();
    Some((sum / points.max(1) as f64).sqrt())
}

/// Returns an error if no position of base and targets brings the nominal robot as near to the
/// measurements as its tolerances allow, with the change of the set-up that would.
///
/// A few wrong readings are no wrong set-up: half of all readings must be as far.
pub fn set_up_problem(robot: &dyn Robot, observations: &[Observation], noise_mm: f64) -> Option<Warning> {
    let subset = spread_over(observations, SUBSET);
    let nominal = robot.nominal();
    let stated = misfit(robot, &subset, &nominal, false);
    let [stated_mm, median_mm] = stated.map_or([f64::INFINITY; 2], |m| [m.rms_mm, m.median_mm]);
    // all observations show the noise; a few of them have no repeats
    let allowed_mm = allowed_mm(robot, &subset, &nominal, observed_noise_mm(robot, observations, noise_mm))?;
    (median_mm > allowed_mm).then(|| far_from_nominal(robot, observations, [stated_mm, allowed_mm], noise_mm))
}

/// Error that the nominal robot misses the measurements by more than its tolerances allow (mm).
pub fn far_from_nominal(
    robot: &dyn Robot,
    observations: &[Observation],
    [left_mm, allowed_mm]: [f64; 2],
    noise_mm: f64,
) -> Warning {
    let message = match left_mm.is_finite() {
        true => error!("nominal-robot-far", left_mm, allowed_mm),
        false => error!("nominal-robot-not-at-joints"),
    };
    explained(message, robot, observations, noise_mm)
}

/// The change of the set-up that explains the measurements, if they cannot be explained without a
/// change.
///
/// Each hypothesis is fitted separately, to some of the poses and of many targets. Its criterion is
/// the sum of squares of standardised residuals and of deviations from nominal over tolerances. The
/// standard deviation of a coordinate is the smallest of all fits, and at least `noise_mm`.
pub fn set_up_error(robot: &dyn Robot, observations: &[Observation], noise_mm: f64) -> Option<SetUpError> {
    if observations.is_empty() {
        return None;
    }
    let few = with_few_targets(robot, observations);
    let observations = few.as_ref().map_or(observations, |few| &few.0);
    let subset = spread_over(observations, SUBSET);
    let least_mm = observed_noise_mm(robot, observations, noise_mm).max(LEAST_MM);
    let stated = Case::placed(robot, &subset, false);
    let stated_mm = stated.as_ref().map_or(f64::INFINITY, |case| case.left_mm);
    let as_stated = stated.as_ref().and_then(|case| case.fit(robot, least_mm, None));
    if as_stated.as_ref().is_some_and(Fitted::explains) {
        return None;
    }
    let cases = Slip::all(robot, observations, &subset, stated_mm);
    let fitted = |slip: Slip| slip.case.fit(slip.robot(robot), least_mm, None).map(|fitted| (slip, fitted));
    let mut cases: Vec<(Slip, Fitted)> = cases.into_par_iter().filter_map(fitted).collect();
    if stated_mm.is_finite() {
        cases.extend(wrong_nominal(robot, stated.as_ref()?, least_mm));
    }
    // one standard deviation for all
    let sigma_mm = cases.iter().map(|(_, fitted)| fitted).chain(&as_stated).filter(|fitted| fitted.shows_noise());
    let sigma_mm = sigma_mm.map(|fitted| fitted.noise_mm).fold(f64::INFINITY, f64::min);
    let sigma_mm = if sigma_mm.is_finite() { sigma_mm.max(least_mm) } else { least_mm };
    let unchanged = stated.as_ref().and_then(|case| case.fit(robot, sigma_mm, as_stated.as_ref()));
    let judged = |(slip, near): (Slip, Fitted)| {
        let fitted = slip.case.fit(slip.robot(robot), sigma_mm, Some(&near))?;
        let beside = match &slip.beside {
            None => unchanged.as_ref().map(|stated| fitted.explains_what(stated)),
            Some(same) => same.fit(robot, sigma_mm, None).map(|stated| fitted.explains_what(&stated)),
        };
        beside.unwrap_or_else(|| fitted.explains()).then_some((slip, fitted))
    };
    let mut explaining: Vec<(Slip, Fitted)> = cases.into_par_iter().filter_map(judged).collect();
    // a value found from the data must explain clearly more than a change that has none
    let by_change = |(slip, _): &&(Slip, Fitted)| slip.case.loose.is_none() && slip.origin != Origin::WorldFrame;
    let best = explaining.iter().filter(by_change).map(|e| e.1.per_row()).fold(f64::INFINITY, f64::min);
    explaining.retain(|e| by_change(&e) || e.1.per_row() < FITTED * best);
    explaining.sort_by(|a, b| a.1.per_row().total_cmp(&b.1.per_row()));
    let (least, changed_mm) = explaining.first().map(|(_, fitted)| (fitted.per_row(), fitted.left_mm))?;
    let near = explaining.iter().take_while(|e| e.1.per_row() <= AS_GOOD * least).take(NAMED);
    let changes = near.map(|(slip, fitted)| (slip.phrase(robot, fitted), slip.origin)).collect();
    Some(SetUpError { changes, stated_mm: unchanged.map_or(f64::INFINITY, |fitted| fitted.left_mm), changed_mm })
}

/// Observations with base and targets located.
struct Case {
    observations: Vec<Observation>,
    /// All parameters.
    values: Vec<f64>,
    /// Root mean square distance of the nominal robot, mm.
    left_mm: f64,
    /// Parameter without a nominal value.
    loose: Option<usize>,
}

impl Case {
    /// Locates base and targets; `None` if the nominal robot has no pose at the joint values.
    fn placed(robot: &dyn Robot, observations: &[Observation], anywhere: bool) -> Option<Self> {
        let nominal = robot.nominal();
        let found = misfit(robot, observations, &nominal, anywhere)?;
        let mut observations = observations.to_vec();
        if let Some(fit) = &found.planar {
            fit.bring_near(robot, &nominal, anywhere, &mut observations);
        }
        Some(Self { observations, values: found.values, left_mm: found.rms_mm, loose: None })
    }

    fn fit(&self, robot: &dyn Robot, sigma_mm: f64, near: Option<&Fitted>) -> Option<Fitted> {
        let (placed, start) = (self.values.clone(), near.map(|fitted| &fitted.values[..]));
        Hypothesis { robot, observations: &self.observations, placed, start, loose: self.loose }.fit(sigma_mm)
    }
}

/// A change of the set-up.
struct Slip {
    what: Phrase,
    origin: Origin,
    /// The robot in another convention.
    other: Option<Box<dyn Robot>>,
    case: Case,
    /// The observations without the change, if they differ from those of all changes.
    beside: Option<Case>,
}

impl Slip {
    fn robot<'a>(&'a self, robot: &'a dyn Robot) -> &'a dyn Robot {
        self.other.as_deref().unwrap_or(robot)
    }

    /// The change with the fitted value.
    fn phrase(&self, robot: &dyn Robot, fitted: &Fitted) -> Phrase {
        let Some(i) = self.case.loose else { return self.what.clone() };
        let p = &robot.parameters()[i];
        let (found, nominal) = (p.quantity.outward(fitted.values[i]), p.quantity.outward(p.nominal));
        phrase!("slip-nominal", parameter = p.name, found, unit = p.quantity.unit(), nominal)
    }

    /// Changes that bring the nominal robot nearest to the measurements; without a change its error
    /// is `stated_mm`.
    fn all(robot: &dyn Robot, observations: &[Observation], subset: &[Observation], stated_mm: f64) -> Vec<Self> {
        let mut all: Vec<Self> = Vec::new();
        let new = |what, origin, case| Self { what, origin, other: None, case, beside: None };
        let placed = |change: Change| {
            let case = Case::placed(robot, &change.observations, change.anywhere)?;
            Some(new(change.what, change.origin, case))
        };
        let of_changes: Vec<Self> = changes(robot, subset).into_par_iter().filter_map(placed).collect();
        all.extend(of_changes);
        for (shift, neighbour) in [(-1, "previous"), (1, "next")] {
            // the first or last pose has no neighbour: it must not be what was wrong
            let shifted = spread_over(&shifted(observations, shift), SUBSET);
            let is_same =
                |s: &Observation, o: &Observation| o.pose == s.pose && o.cycle == s.cycle && o.targets == s.targets;
            let same = shifted.iter().filter_map(|s| observations.iter().find(|o| is_same(s, o))).cloned();
            let beside = Case::placed(robot, &same.collect::<Vec<_>>(), false);
            let what = phrase!("slip-neighbour", neighbour);
            let case = Case::placed(robot, &shifted, false).map(|case| new(what, Origin::Named, case));
            all.extend(case.map(|slip| Self { beside, ..slip }));
        }
        for (convention, other) in robot.other_conventions() {
            let case = Case::placed(other.as_ref(), subset, false);
            all.extend(case.map(|case| Self {
                other: Some(other),
                ..new(phrase!("slip-convention", convention), Origin::Named, case)
            }));
        }
        let elsewhere = robot.free_base().is_none().then(|| elsewhere(robot, subset)).flatten();
        all.extend(elsewhere.map(|(what, case)| new(what, Origin::WorldFrame, case)));
        all.retain(|slip| slip.case.left_mm < stated_mm);
        all.sort_by(|a, b| a.case.left_mm.total_cmp(&b.case.left_mm));
        all.truncate(FITS);
        all
    }
}

/// Base of a planar robot at the position given by the measurements.
fn elsewhere(robot: &dyn Robot, observations: &[Observation]) -> Option<(Phrase, Case)> {
    let case = Case::placed(robot, observations, true)?;
    let (fit, _) = planar_fit(robot, observations, &robot.nominal(), &ANYWHERE)?;
    let (angle_deg, [x_mm, y_mm]) = (fit.angle.to_degrees(), fit.shift);
    Some((phrase!("slip-world-frame", angle_deg, x_mm, y_mm), case))
}

/// Residuals of the nominal robot.
struct Misfit {
    /// Root mean square of the distances.
    rms_mm: f64,
    /// Median of the distances.
    median_mm: f64,
    values: Vec<f64>,
    /// Pose of a planar robot.
    planar: Option<Similarity>,
}

/// Base and targets located by the measurements, and the residuals; `None` if the robot has no pose
/// at the joint values. With `anywhere`, the base of a planar robot may be beyond its tolerances.
fn misfit(robot: &dyn Robot, observations: &[Observation], nominal: &[f64], anywhere: bool) -> Option<Misfit> {
    if let Some(arm) = robot.free_base() {
        let places: Vec<usize> = (0..nominal.len()).filter(|&i| robot.parameters()[i].role != Role::Robot).collect();
        let placed = place(robot, arm, observations, nominal, &places).ok()??;
        let misses = observations.iter().flat_map(|o| o.misses(robot, &placed.values));
        let left: Vec<f64> = misses.map(|(_, miss)| norm(miss)).collect();
        let found = Misfit {
            rms_mm: placed.rms_mm,
            median_mm: median(left).unwrap_or(0.0),
            values: placed.values,
            planar: None,
        };
        return Some(found).filter(|m| m.rms_mm.is_finite());
    }
    planar_misfit(robot, observations, nominal, anywhere)
}

/// Misfit in the plane: predicted positions are fitted to the measured ones by a shift, and by a
/// rotation if the base has an angle, both within the tolerances of the base; the nearer assembly
/// mode is used.
fn planar_misfit(robot: &dyn Robot, observations: &[Observation], nominal: &[f64], anywhere: bool) -> Option<Misfit> {
    let tolerance = |quantity: Quantity| {
        let base = robot.parameters().iter().filter(|p| p.role == Role::Base && p.quantity == quantity);
        base.map(|p| p.tolerance).fold(0.0, f64::max)
    };
    let within = Similarity { angle: tolerance(Quantity::Angle), shift: [tolerance(Quantity::Length); 2] };
    let most = if anywhere { ANYWHERE } else { within };
    let (fit, left) = planar_fit(robot, observations, nominal, &most)?;
    let (rms_mm, median_mm) = (rms(left.iter().copied()), median(left).unwrap_or(0.0));
    Some(Misfit { rms_mm, median_mm, values: nominal.to_vec(), planar: Some(fit) })
}

/// Shift and rotation that fit predicted positions to the measured ones, no larger than `most`, and
/// the residual distances (mm).
fn planar_fit(
    robot: &dyn Robot,
    observations: &[Observation],
    nominal: &[f64],
    most: &Similarity,
) -> Option<(Similarity, Vec<f64>)> {
    let modes: &[Option<f64>] = if robot.has_assembly_modes() { &[Some(1.0), Some(-1.0)] } else { &[None] };
    let mut fit = Similarity::default();
    let mut left = Vec::new();
    for _ in 0..if modes.len() > 1 { 4 } else { 1 } {
        let mut pairs: Vec<[[f64; 2]; 2]> = Vec::new();
        for o in observations {
            let mut joints = o.joints.clone();
            let of = |mode: &Option<f64>| {
                if let (Some(mode), Some(last)) = (mode, joints.last_mut()) {
                    *last = *mode;
                }
                let mut pairs = Vec::new();
                for (k, measured) in o.targets.iter().enumerate() {
                    let (Some(m), p) = (measured, robot.position(nominal, &joints, k)) else { continue };
                    pairs.push([[p[0], p[1]], [m[0], m[1]]]);
                }
                pairs
            };
            let all = modes.iter().map(of).filter(|pairs| pairs.iter().flatten().flatten().all(|v| v.is_finite()));
            pairs.extend(all.min_by(|a, b| fit.cost(a).total_cmp(&fit.cost(b)))?);
        }
        fit = Similarity::between(&pairs, most)?;
        left = pairs.iter().map(|pair| fit.cost(std::slice::from_ref(pair)).sqrt()).collect();
    }
    Some((fit, left))
}

const ANYWHERE: Similarity = Similarity { angle: f64::INFINITY, shift: [f64::INFINITY; 2] };

/// A shift of the plane, with or without a rotation.
#[derive(Default)]
struct Similarity {
    angle: f64,
    shift: [f64; 2],
}

impl Similarity {
    /// Motion from the first to the second point of each pair, by least squares, no larger than
    /// `most`.
    fn between(pairs: &[[[f64; 2]; 2]], most: &Self) -> Option<Self> {
        let n = Some(pairs.len() as f64).filter(|n| *n > 0.0)?;
        let mean = |side: usize| [0, 1].map(|i| pairs.iter().map(|p| p[side][i]).sum::<f64>() / n);
        let (from, to) = (mean(0), mean(1));
        let (mut along, mut across) = (0.0, 0.0);
        for [p, m] in pairs {
            let (p, m) = ([p[0] - from[0], p[1] - from[1]], [m[0] - to[0], m[1] - to[1]]);
            along += p[0] * m[0] + p[1] * m[1];
            across += p[0] * m[1] - p[1] * m[0];
        }
        let angle = Some(across.atan2(along)).filter(|angle| angle.abs() <= most.angle).unwrap_or(0.0);
        let turned = Self { angle, shift: [0.0; 2] };
        // what the base is off by: the turn is about its origin
        let moved = turned.apply(from);
        let within = |i: usize| (to[i] - moved[i]).clamp(-most.shift[i], most.shift[i]);
        Some(Self { shift: [within(0), within(1)], ..turned })
    }

    fn apply(&self, p: [f64; 2]) -> [f64; 2] {
        let (sin, cos) = self.angle.sin_cos();
        [cos * p[0] - sin * p[1] + self.shift[0], sin * p[0] + cos * p[1] + self.shift[1]]
    }

    /// Sets the nearer assembly mode of observations, and moves them by `back` into the frame in
    /// which the base is nominal.
    fn bring_near(&self, robot: &dyn Robot, nominal: &[f64], back: bool, observations: &mut [Observation]) {
        for o in observations {
            let pairs = |joints: &[f64]| -> Vec<[[f64; 2]; 2]> {
                let seen = o.targets.iter().enumerate().filter_map(|(k, at)| Some((k, (*at)?)));
                let place = |(k, m): (usize, Vector)| {
                    let p = robot.position(nominal, joints, k);
                    [[p[0], p[1]], [m[0], m[1]]]
                };
                seen.map(place).collect()
            };
            if robot.has_assembly_modes() {
                let [here, mut other] = [&o.joints, &o.joints].map(Clone::clone);
                other.iter_mut().next_back().into_iter().for_each(|mode| *mode = -*mode);
                let [cost, other_cost] = [&here, &other].map(|joints| self.cost(&pairs(joints)));
                if other_cost < cost || cost.is_nan() {
                    o.joints = other;
                }
            }
            if back {
                o.targets.iter_mut().flatten().for_each(|p| *p = self.undo(*p));
            }
        }
    }

    /// The point that is moved to `p`.
    fn undo(&self, p: Vector) -> Vector {
        let (sin, cos) = self.angle.sin_cos();
        let [x, y] = [p[0] - self.shift[0], p[1] - self.shift[1]];
        [cos * x + sin * y, cos * y - sin * x, p[2]]
    }

    /// Sum of squared distances.
    fn cost(&self, pairs: &[[[f64; 2]; 2]]) -> f64 {
        let distance = |[p, m]: &[[f64; 2]; 2]| {
            let q = self.apply(*p);
            (q[0] - m[0]).powi(2) + (q[1] - m[1]).powi(2)
        };
        pairs.iter().map(distance).sum()
    }
}

/// Pose from which on measured positions are shifted relative to the robot at `values`: base or
/// measuring system has moved. Returns a warning if one shift explains most of the residuals beyond
/// chance.
pub fn moved_between(robot: &dyn Robot, observations: &[Observation], values: &[f64]) -> Option<Message> {
    let left = |o: &Observation| centroid(&o.misses(robot, values).map(|(_, miss)| miss).collect::<Vec<_>>());
    let all: Vec<(PoseName, Vector)> = observations.iter().filter_map(|o| Some((o.pose, left(o)?))).collect();
    let n = all.len();
    let sum = all.iter().fold([0.0; 3], |s, (_, r)| [0, 1, 2].map(|i| s[i] + r[i]));
    let middle = sum.map(|s| s / n as f64);
    let total: f64 = all.iter().map(|(_, r)| norm(minus(*r, middle)).powi(2)).sum();
    let (mut first, mut best) = ([0.0; 3], (0.0, 0, [0.0; 3]));
    for k in 1..n {
        first = [0, 1, 2].map(|i| first[i] + all[k - 1].1[i]);
        if k < FEWEST_ASIDE || n - k < FEWEST_ASIDE || all[k - 1].0 == all[k].0 {
            continue;
        }
        let (before, after) = (first.map(|s| s / k as f64), [0, 1, 2].map(|i| (sum[i] - first[i]) / (n - k) as f64));
        let shift = minus(after, before);
        let explained = (k * (n - k)) as f64 / n as f64 * norm(shift).powi(2) / total;
        if explained > best.0 {
            best = (explained, k, shift);
        }
    }
    let (explained, k, shift) = best;
    (explained > MOVED_SHARE).then(|| {
        let (pose, previous) = (all[k].0, all[k - 1].0);
        let vector_mm = shift.map(|v| (1e3 * v).round() / 1e3);
        let (shift_mm, share_percent) = (norm(shift), 100.0 * explained);
        warning!("reference-moved", pose, previous, shift_mm, vector_mm, share_percent).to_decide()
    })
}

/// Minimum number of observations on either side of a move.
const FEWEST_ASIDE: usize = 5;
/// Minimum share of the residual sum of squares that one move must explain; for errors without
/// order it is a few percent.
const MOVED_SHARE: f64 = 0.4;

/// Slips in one nominal value: each length and angle of the robot that the measurements put beyond
/// its tolerance if it is free, with its fit.
fn wrong_nominal(robot: &dyn Robot, stated: &Case, sigma_mm: f64) -> Vec<(Slip, Fitted)> {
    let (parameters, placed) = (robot.parameters(), &stated.values);
    let places =
        || (0..placed.len()).filter(|&i| parameters[i].role == Role::Base || parameters[i].tolerance.is_infinite());
    let with = |i: usize| {
        let mut free: Vec<usize> = places().chain([i]).collect();
        free.sort_unstable();
        let problem = Residuals::new(robot, &stated.observations, &PLAIN, &free, placed).ok()?;
        let x: Vec<f64> = free.iter().map(|&i| placed[i]).collect();
        let solution = etalon_math::solve(&problem, &x, Options { iterations: 30, step: 1e-6, ..Options::default() });
        Some((solution.cost, i, problem.all(&solution.x)))
    };
    let is_nominal = |&i: &usize| {
        let p = &parameters[i];
        p.role == Role::Robot && p.quantity != Quantity::Ratio && p.tolerance.is_finite()
    };
    let mut all: Vec<(f64, usize, Vec<f64>)> = (0..placed.len()).filter(is_nominal).filter_map(with).collect();
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    all.truncate(FITTED_VALUES);
    let judged = |(_, i, values): (f64, usize, Vec<f64>)| {
        let observations = stated.observations.clone();
        let case = Case { observations, values, left_mm: stated.left_mm, loose: Some(i) };
        let fitted = case.fit(robot, sigma_mm, None)?;
        let p = &parameters[i];
        let beyond = (fitted.values[i] - p.nominal).abs() > p.tolerance;
        let slip = Slip { what: Phrase::new("slip-nominal"), origin: Origin::Named, other: None, case, beside: None };
        beyond.then_some((slip, fitted))
    };
    all.into_iter().filter_map(judged).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_base::noise::Noise;
    use etalon_robots::Prexyt;

    /// Forty poses, measured with 3 µm, shifted from pose 22 on.
    fn measured(robot: &Prexyt, shift_mm: f64) -> Vec<Observation> {
        let (nominal, mut noise) = (robot.nominal(), Noise::new(16, 4));
        let pose = |i: i64| {
            let joints = vec![85.0 + noise.uniform(80.0), 150.0 + noise.uniform(100.0), 150.0 + noise.uniform(100.0)];
            let by = if i < 22 { 0.0 } else { shift_mm };
            let mut seen = |[x, y]: [f64; 2]| Some([x + by + noise.gaussian(0.003), y + noise.gaussian(0.003), 0.0]);
            let targets = robot.balls(&nominal, &joints).map(&mut seen).to_vec();
            Observation { pose: i.into(), cycle: 1, joints, targets, ..Observation::default() }
        };
        (1..=40).map(pose).collect()
    }

    /// One of two exports in inches is named, with its target alone; sound data and data that no
    /// unit explains are not accused.
    #[test]
    fn the_unit_of_one_target_is_named_alone() {
        let robot = Prexyt::default();
        for (target, factor, slip) in [(0, 1.0 / 25.4, "inch-mm"), (1, 25.4, "mm-inch"), (1, 1e-3, "m-mm")] {
            let mut observations = measured(&robot, 0.0);
            for p in observations.iter_mut().filter_map(|o| o.targets[target].as_mut()) {
                *p = p.map(|v| v * factor);
            }
            let found = set_up_error(&robot, &observations, 0.003).expect("a slip");
            let targets = vec![format!("`{}`", robot.targets()[target])];
            assert_eq!(found.changes[0].0, phrase!("slip-unit-of-targets", targets, slip), "{found:?}");
            assert_eq!(found.changes.len(), 1, "{found:?}");
        }
        let (mut observations, mut noise) = (measured(&robot, 0.0), Noise::new(16, 7));
        for p in observations.iter_mut().filter_map(|o| o.targets[1].as_mut()) {
            *p = [noise.uniform(200.0), noise.uniform(200.0), 0.0];
        }
        assert_eq!(set_up_error(&robot, &observations, 0.003), None);
    }

    /// Forty poses with points in inches, from a frame that lies elsewhere.
    #[test]
    fn a_unit_is_named_and_sound_data_have_no_slip() {
        let robot = Prexyt::default();
        let mut observations = measured(&robot, 0.0);
        assert_eq!(set_up_error(&robot, &observations, 0.003), None);
        for p in observations.iter_mut().flat_map(|o| o.targets.iter_mut().flatten()) {
            *p = [25.4 * p[0] + 900.0, 25.4 * p[1] - 700.0, 0.0];
        }
        let found = set_up_error(&robot, &observations, 0.003).expect("a slip");
        assert_eq!(found.changes[0].0, phrase!("slip-unit", quantity = "points", slip = "mm-inch"));
        assert!(found.changed_mm < 0.01 && found.stated_mm > 1.0, "{found:?}");
        // joints of another robot, and points that nothing explains
        let mut noise = Noise::new(16, 6);
        for p in observations.iter_mut().flat_map(|o| o.targets.iter_mut().flatten()) {
            *p = [noise.uniform(200.0), noise.uniform(200.0), 0.0];
        }
        assert_eq!(set_up_error(&robot, &observations, 0.003), None);
    }

    /// Thirty repeats of one pose, or poses within a few micrometres, are noise about any robot: no
    /// unit, sign or order explains them, and the nominal robot is not far from them. The same
    /// robot in the wrong unit over its full range is named, with repeats that show the noise.
    #[test]
    fn noise_is_no_misfit_and_no_unit_explains_it() {
        let robot = Prexyt::default();
        let nominal = robot.nominal();
        for range in [0.0, 0.005, 80.0] {
            let mut noise = Noise::new(16, 9);
            let mut joints = |i: i64| (i, [85.0, 150.0, 150.0].map(|q| q + noise.uniform(range)).to_vec());
            let poses: Vec<(i64, Vec<f64>)> = (1..=30).map(&mut joints).collect();
            let observe = |(i, joints): &(i64, Vec<f64>), cycle: i64, noise: &mut Noise| {
                let mut seen = |[x, y]: [f64; 2]| Some([x + noise.gaussian(0.015), y + noise.gaussian(0.015), 0.0]);
                let targets = robot.balls(&nominal, joints).map(&mut seen).to_vec();
                Observation { pose: (*i).into(), cycle, joints: joints.clone(), targets, ..Observation::default() }
            };
            let mut observations: Vec<Observation> = (1..=2)
                .flat_map(|cycle| poses.iter().map(|p| observe(p, cycle, &mut noise)).collect::<Vec<_>>())
                .collect();
            assert_eq!(set_up_problem(&robot, &observations, 0.0), None, "{range}");
            assert_eq!(set_up_error(&robot, &observations, 0.0), None, "{range}");
            for p in observations.iter_mut().flat_map(|o| o.targets.iter_mut().flatten()) {
                *p = p.map(|v| v * 1e-3);
            }
            if range > 1.0 {
                let found = set_up_error(&robot, &observations, 0.0).expect("a slip");
                assert_eq!(found.changes[0].0, phrase!("slip-unit", quantity = "points", slip = "m-mm"));
                assert!(set_up_problem(&robot, &observations, 0.0).is_some());
            }
        }
    }

    #[test]
    fn a_move_is_found_where_it_happens_and_nowhere_else() {
        let robot = Prexyt::default();
        let moved = moved_between(&robot, &measured(&robot, 0.05), &robot.nominal()).expect("moved");
        assert!(moved.is("reference-moved", &[("pose", &"22"), ("previous", &"21")]), "{moved:?}");
        assert!(moved.what.contains("by 0.05") && moved.what.contains("(0.05"), "{}", moved.what);
        assert_eq!(moved_between(&robot, &measured(&robot, 0.0), &robot.nominal()), None);
        // a single wrong reading, at an end or between others, is not a move
        for wrong in [0, 20, 39] {
            let mut observations = measured(&robot, 0.0);
            observations[wrong].targets[0].as_mut().unwrap()[0] += 0.5;
            assert_eq!(moved_between(&robot, &observations, &robot.nominal()), None, "{wrong}");
        }
    }
}
