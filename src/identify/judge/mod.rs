//! Judge of a set-up. It compares the given set-up with typical mistakes.
//!
//! [`changes`] lists the mistakes. Each is a hypothesis: the data without it, with base, targets
//! and fixtures located again by most of the readings, and with all parameters fitted. All
//! hypotheses, and the set-up as given, are compared by one measure: the residuals at poses that
//! are excluded from the fit, relative to the size of the robot and with their own misfit
//! ([`fit`]).

mod changes;
mod data;
mod elsewhere;
mod fit;
mod hypotheses;
mod moved;
mod place;
mod readings;

pub use changes::Reading as OrientationReading;
pub(crate) use moved::jacobian_with_misfit;
pub use moved::moved_between;
pub use readings::{ReadingSlips, WrongCoordinate, nominal_reading_slips, reading_slips};

use crate::judgement::chi_square::exceeds;
use crate::model::residuals::Residuals;
use crate::solution::placing::{PLAIN, UNEXPLAINED, measured_parameters, spread_mm, spread_over, with_few_targets};
use crate::solution::scatter::observed_noise_mm;
use crate::warning::{SetUpError, Subject, Warning};
use crate::{Observation, Settings};
use changes::Listing;
use data::Data;
use elsewhere::Elsewhere;
use etalon_base::catalogue::Phrase;
use etalon_base::error;
use etalon_base::message::Message;
use etalon_base::pose::norm;
use etalon_math::factor_at;
use etalon_math::statistics::{median, rms};
use etalon_robots::{Robot, Role};
use fit::Fitted;
pub(crate) use fit::MOST_PARAMETERS;
use hypotheses::{Case, Slip, Table, wrong_nominal};
use place::{locate, planar_distances};
use rayon::prelude::*;

/// Number of poses on which the nominal robot is compared.
const SUBSET: usize = 32;
/// Minimum number of poses: many changes explain fewer poses.
const FEWEST: usize = 4;
/// Number of changes that are fitted with all parameters: the changes with which the nominal robot
/// is nearest to the measurements.
const FITS: usize = 24;
/// Maximum number of changes that are fitted if more of them bring the nominal robot as near to the
/// measurements.
const MOST_FITS: usize = 40;
/// Ratio of standard deviations by which a change must explain the data better than the set-up as
/// given.
const CLEAR: f64 = 2.0;
/// Ratio of standard deviations by which a change explains the data worse than the given set-up, so
/// that the data exclude the change.
const WORSE: f64 = 1.5;
/// Ratio of the standard deviation that a change leaves near its start to the one that the nominal
/// robot leaves of the set-up as given, beyond which the change is not fitted to its end. It is
/// applied if a robot within its tolerances explains the set-up as given, so that its fit leaves
/// less still.
const HOPELESS: f64 = 20.0;
/// Share of the residuals with the given set-up that a single change leaves if there is no second
/// mistake. With more, pairs are compared too.
const RESIDUE: f64 = 0.02;
/// Minimum decrease of the cost, so that few poses name nothing by chance.
const FALLS_BY: f64 = 10.0;
/// Ratio of standard deviations at which a change that is fitted to the data must be better than
/// the changes that are not.
const FITTED: f64 = 1.4;
/// Maximum standard deviation that the model of a robot leaves: relative to the spread of the
/// positions, and of angles (rad).
const MISFIT: [f64; 2] = [0.02, 0.035];
/// Deviation of a parameter from nominal, in standard uncertainties of its tolerance, that no robot
/// has: 2.3 tolerances.
const OFF: f64 = 4.0;
/// A tolerance in its standard uncertainties, and the ratio by which the parameters of a published
/// robot must be nearer to nominal than the parameters of a robot beyond its tolerances.
const TOLERANCE: f64 = 1.74;
const NEARER: f64 = 5.0;
/// Differences (mm, rad) of the flange up to which two robots are the same.
const SAME_MM: f64 = 5.0;
const SAME_RAD: f64 = 0.02;
/// Maximum residual of one coordinate attributed to noise if poses are few, in standard
/// uncertainties of a coordinate.
const NOISE_COORDINATE: f64 = 3.0;
/// Maximum number of named changes.
const NAMED: usize = 4;

/// Replaces the hint of a message by the change of the set-up that explains it, if there is one.
pub(crate) fn explained(
    message: Message,
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
) -> Warning {
    hinted(message, set_up_error(robot, observations, settings))
}

/// Replaces the hint of a message by a change of the set-up.
fn hinted(message: Message, found: Option<SetUpError>) -> Warning {
    let Some(found) = found else { return message.into() };
    let hint = found.to_check(|_| None);
    Warning { message: message.hint(hint), subject: Subject::SetUp(found) }
}

/// Root mean square error (mm) of a nominal robot whose parameters deviate from nominal as their
/// tolerances, taken as half-widths of rectangular distributions (GUM 4.3.7), allow; base and
/// targets, at `values`, absorb as much as they can.
///
/// `noise_mm` is the given standard uncertainty of a coordinate; the noise that the observations
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
    // the part of a column that base and targets do not absorb lies below their rows
    let common = factor.common();
    let first = common.iter().take_while(|&&j| j < places.len()).count();
    let left = |k: usize| (first..=k).map(|i| factor.r(i, k).powi(2)).sum::<f64>() * norms[common[k]].powi(2);
    let variance = |k: usize| left(k) * robot.parameters()[free[common[k]]].tolerance.powi(2) / 3.0;
    let points = observations.iter().flat_map(|o| o.targets.iter().flatten()).count();
    let sum: f64 = (first..common.len()).map(variance).sum();
    Some((sum / points.max(1) as f64).sqrt())
}

/// Returns the judgement of a set-up, and an error if the measurements contradict it: no position
/// of base and targets brings the nominal robot as near to them as its tolerances allow, and no
/// robot within the tolerances explains them, or a change explains them clearly better.
///
/// A few wrong readings are no wrong set-up: half of all readings must be as far.
pub fn set_up_problem(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
) -> (Option<Warning>, Judgement) {
    let judged = judge(robot, observations, settings, &[]);
    let far = far_mm(robot, observations, settings).and_then(|far_mm| far_problem(far_mm, &judged));
    let problem = far.or_else(|| contradicted(&judged));
    // few readings beyond the unknown places, or readings without a length, refute nothing that an
    // identification explains
    (problem.filter(|_| !is_explained(robot, observations, settings)), judged)
}

/// `true` if a robot within its tolerances explains the observations within the uncertainty of the
/// instrument.
fn is_explained(robot: &dyn Robot, observations: &[Observation], settings: &Settings) -> bool {
    let Ok(found) = crate::identify(robot, observations, settings) else { return false };
    let parameters = robot.parameters();
    let is_near = |&i: &usize| fit::deviation(&parameters[i], found.values[i]) <= OFF;
    let residuals = &found.residuals;
    let is_noise = residuals.chi_square.is_some_and(|chi_square| !exceeds(chi_square, residuals.degrees_of_freedom));
    is_noise && found.free.iter().filter(|&&i| parameters[i].tolerance.is_finite()).all(is_near)
}

/// Error that a change of the set-up explains the measurements, and the set-up as given does not.
pub fn set_up_contradicted(robot: &dyn Robot, observations: &[Observation], settings: &Settings) -> Option<Warning> {
    contradicted(&judge(robot, observations, settings, &[]))
}

fn contradicted(judged: &Judgement) -> Option<Warning> {
    judged.named.clone().map(|found| hinted(error!("set-up-contradicted"), Some(found)))
}

/// Error if the nominal robot is farther from the measurements than its tolerances allow, and no
/// robot within them explains the measurements.
pub fn set_up_far(robot: &dyn Robot, observations: &[Observation], settings: &Settings) -> Option<Warning> {
    far_problem(far_mm(robot, observations, settings)?, &judge(robot, observations, settings, &[]))
}

/// Error that the nominal robot is farther from the measurements (mm) than its tolerances allow
/// (mm), with the change that explains them, unless a robot within the tolerances does.
pub fn far_problem(far_mm: [f64; 2], judged: &Judgement) -> Option<Warning> {
    let is_refuted = !judged.is_possible || judged.named.is_some();
    is_refuted.then(|| hinted(far_message(far_mm), judged.named.clone()))
}

/// Distance (mm) of the nominal robot from the measurements, and the one that its tolerances allow,
/// if most of the measurements are farther.
fn far_mm(robot: &dyn Robot, observations: &[Observation], settings: &Settings) -> Option<[f64; 2]> {
    let subset = Some(spread_over(observations, SUBSET)).filter(|subset| !subset.is_empty())?;
    let distances = distances(robot, &subset, settings).unwrap_or_else(|| vec![f64::INFINITY]);
    let (stated_mm, median_mm) = (rms(distances.iter().copied()), median(distances)?);
    // all observations show the noise; a few of them have no repeats
    let noise_mm = observed_noise_mm(robot, observations, settings.coordinate_uncertainty_mm());
    let allowed_mm = allowed_mm(robot, &subset, &robot.nominal(), noise_mm)?;
    (median_mm > allowed_mm).then_some([stated_mm, allowed_mm])
}

/// Distances (mm) of the nominal robot from the measured positions, with base and targets located.
fn distances(robot: &dyn Robot, observations: &[Observation], settings: &Settings) -> Option<Vec<f64>> {
    if robot.free_base().is_none() {
        return planar_distances(robot, observations);
    }
    let settings = Settings { conditions: Vec::new(), known: Vec::new(), ..settings.clone() };
    let (data, values) = locate(robot, Data::new(robot, observations, &settings), false)?;
    let misses = data.observations.iter().flat_map(|o| o.misses(robot, &values));
    let distances: Vec<f64> = misses.map(|(_, miss)| norm(miss)).collect();
    distances.iter().all(|d| d.is_finite()).then_some(distances)
}

/// Error that the nominal robot misses the measurements by more than its tolerances allow (mm).
pub(crate) fn far_from_nominal(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    far_mm: [f64; 2],
) -> Warning {
    explained(far_message(far_mm), robot, observations, settings)
}

/// Error that the nominal robot is `left_mm` from the measurements where its tolerances allow
/// `allowed_mm`.
fn far_message([left_mm, allowed_mm]: [f64; 2]) -> Message {
    match left_mm.is_finite() {
        true => error!("nominal-robot-far", left_mm, allowed_mm),
        false => error!("nominal-robot-not-at-joints"),
    }
}

/// The change of the set-up that explains the measurements, if they cannot be explained without a
/// change.
pub fn set_up_error(robot: &dyn Robot, observations: &[Observation], settings: &Settings) -> Option<SetUpError> {
    judge(robot, observations, settings, &[]).named
}

/// Judgement of a set-up.
#[derive(Clone, Debug, Default)]
pub struct Judgement {
    /// The change that explains the data clearly better than the set-up as given, and those that
    /// explain them as well.
    pub named: Option<SetUpError>,
    /// Mistakes that these data do not show: with each of these changes a robot within its
    /// tolerances explains them, or nearly so.
    pub untested: Vec<Untested>,
    /// `true` if a robot within its tolerances can have residuals as small as the given set-up.
    pub is_possible: bool,
}

/// A mistake that the data do not show.
#[derive(Clone, Debug, PartialEq)]
pub struct Untested {
    /// The change.
    pub change: Phrase,
    /// Standard deviation (mm) of the residuals of a length as given, and with the change.
    pub residuals_mm: [f64; 2],
    /// Largest difference of the flange between both at poses around the measured ones: its
    /// position (mm) and its orientation (rad), beyond the difference that is common to all poses.
    pub differs: (f64, f64),
}

/// Judges the set-up of observations of any kind; `readings` are other ways of reading their
/// orientations.
pub fn judge(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    readings: &[OrientationReading],
) -> Judgement {
    let data = Data::new(robot, observations, settings);
    let judged = judge_by(robot, &data, readings, 1);
    let single = judged.named.as_ref().map(|single| (single.stated_mm, single.changed_mm));
    if judged.is_possible || single.is_some_and(|(stated_mm, changed_mm)| changed_mm < RESIDUE * stated_mm) {
        return judged;
    }
    // the pairs of all changes are many: one target is enough to try them
    let pair = judge_by(robot, &data.with_one_target(robot), readings, 2).named;
    let pair = pair.filter(|pair| single.is_none_or(|(_, changed_mm)| CLEAR.powi(2) * pair.changed_mm < changed_mm));
    Judgement { named: pair.or(judged.named), ..judged }
}

/// Mistakes that these data do not show, as [`judge`] lists them: sufficient for a set-up that
/// explains its data, of which no change is named. Changes that are never listed are not fitted.
pub fn untested_changes(robot: &dyn Robot, observations: &[Observation], settings: &Settings) -> Vec<Untested> {
    // changes are listed by the place of the flange
    if robot.free_base().is_none() {
        return Vec::new();
    }
    let data = Data::new(robot, observations, settings);
    let Some(stated) = Stated::new(robot, &data, &[]) else { return Vec::new() };
    if !stated.is_possible() {
        return Vec::new();
    }
    let tried = stated.fitted(stated.table().single(), stated.as_near(), |slip| slip.listing != Listing::Never);
    stated.verdict().judgement(robot, tried, 1).untested
}

/// Returns the judgement by hypotheses with this number of mistakes, one or two.
fn judge_by(robot: &dyn Robot, data: &Data, readings: &[OrientationReading], mistakes: u8) -> Judgement {
    let Some(stated) = Stated::new(robot, data, readings) else { return Judgement::default() };
    let mut tried = match mistakes {
        1 => stated.fitted(stated.table().single(), stated.as_near(), |_| true),
        _ => stated.fitted(stated.table().pairs(), f64::NEG_INFINITY, |_| true),
    };
    if let Some(case) = stated.case.as_ref().filter(|_| mistakes == 1) {
        tried.extend(wrong_nominal(robot, case));
        tried.extend(stated.fitted(stated.table().without_readings(), f64::INFINITY, |_| true));
    }
    stated.verdict().judgement(robot, tried, mistakes)
}

/// A set-up as given, with the data on which its changes are tried.
struct Stated<'a> {
    robot: &'a dyn Robot,
    data: &'a Data,
    readings: &'a [OrientationReading],
    subset: Data,
    /// Poses elsewhere.
    probes: Data,
    /// `None` if the nominal robot has no pose at the joint values.
    case: Option<Case>,
    fit: Option<Fitted>,
}

impl<'a> Stated<'a> {
    /// Fits the set-up as given; `None` if the data cannot be judged.
    fn new(robot: &'a dyn Robot, data: &'a Data, readings: &'a [OrientationReading]) -> Option<Self> {
        let subset = data.subset(robot);
        if data.poses().len() < FEWEST || !data.has_places() || fit::free_parameters(robot, &subset).is_none() {
            return None;
        }
        let case = Case::located(robot, subset.clone(), false);
        let fit = case.as_ref().and_then(|case| case.fit(robot));
        let probes = subset.elsewhere(robot);
        Some(Self { robot, data, readings, subset, probes, case, fit })
    }

    fn table(&self) -> Table<'_> {
        let Self { robot, data, readings, subset, probes, .. } = self;
        Table { robot: *robot, data, tried: [subset, probes], readings }
    }

    /// `true` if a robot within its tolerances explains the set-up as given.
    fn is_possible(&self) -> bool {
        self.fit.as_ref().is_some_and(is_possible)
    }

    /// Cost below which the data may not distinguish a change from the set-up as given.
    fn as_near(&self) -> f64 {
        self.case.as_ref().map_or(f64::NEG_INFINITY, |case| case.near + WORSE.ln())
    }

    /// Fits of the hypotheses that bring the nominal robot nearest, and of those nearer than
    /// `as_near`, as far as they are `wanted`; hopeless ones are given up. Of several ways to make
    /// the same data, only the first is fitted.
    fn fitted(&self, mut all: Vec<Slip>, as_near: f64, wanted: impl Fn(&Slip) -> bool) -> Vec<(Slip, Fitted)> {
        let explained = self.case.as_ref().filter(|_| self.is_possible());
        let limit = explained.map(|case| case.near + HOPELESS.ln());
        nearest(&mut all, as_near);
        all.retain(wanted);
        fits(self.robot, all, limit)
    }

    fn verdict(&self) -> Verdict<'_> {
        let case = self.case.as_ref();
        let elsewhere =
            case.map(|case| Elsewhere { robot: self.robot, data: &case.data, joints: self.probes.joints() });
        Verdict { as_stated: self.fit.as_ref(), elsewhere }
    }
}

/// Keeps the hypotheses that bring the nominal robot nearest, and the hypotheses nearer than
/// `as_near`.
fn nearest(all: &mut Vec<Slip>, as_near: f64) {
    all.sort_by(|a, b| a.case.near.total_cmp(&b.case.near));
    all.dedup_by(|later, first| later.is_same(first));
    let alike = all.iter().take_while(|slip| slip.case.near < as_near).count();
    all.truncate(alike.clamp(FITS, MOST_FITS));
}

/// Fits of hypotheses; hypotheses beyond `limit` are given up.
fn fits(robot: &dyn Robot, all: Vec<Slip>, limit: Option<f64>) -> Vec<(Slip, Fitted)> {
    let fitted = |slip: Slip| slip.case.fit_within(slip.robot(robot), limit).map(|fitted| (slip, fitted));
    all.into_par_iter().filter_map(fitted).collect()
}

/// Comparison with the set-up as given.
struct Verdict<'a> {
    as_stated: Option<&'a Fitted>,
    elsewhere: Option<Elsewhere<'a>>,
}

impl Verdict<'_> {
    /// Returns the judgement by fits of hypotheses with this number of mistakes.
    fn judgement(&self, robot: &dyn Robot, mut tried: Vec<(Slip, Fitted)>, mistakes: u8) -> Judgement {
        if let Some(elsewhere) = &self.elsewhere {
            tried.retain(|(slip, fitted)| !elsewhere.is_absorbed(slip, &fitted.values));
        }
        let mut listed: Vec<&(Slip, Fitted)> = tried.iter().collect();
        listed.sort_by_key(|(slip, _)| slip.listing);
        let untested = listed.into_iter().filter_map(|(slip, fitted)| self.untested(slip, fitted)).collect();
        let (mut explaining, others): (Vec<_>, Vec<_>) =
            tried.into_iter().partition(|(slip, fitted)| self.is_named(slip, fitted, mistakes));
        // a value found from the data must explain clearly more than a change that has none
        let changes = explaining.iter().filter(|(slip, _)| slip.is_change());
        let best = changes.map(|e| e.1.per_row()).fold(f64::INFINITY, f64::min);
        explaining.retain(|(slip, fitted)| slip.is_change() || fitted.per_row() < best - FITTED.ln());
        explaining.sort_by(|a, b| a.1.per_row().total_cmp(&b.1.per_row()));
        let least = explaining.first().map(|(_, fitted)| fitted.clone());
        // a wrong reading that explains as much would accuse the set-up
        let is_reading = |least: &Fitted| {
            let rivals = others.iter().filter(|(slip, fitted)| slip.is_reading && is_possible(fitted));
            rivals.map(|(_, fitted)| least.gain_over(fitted)).any(explains_as_well)
        };
        let named = least.filter(|least| !is_reading(least)).map(|least| {
            let near = explaining.iter().filter(|e| explains_as_well(least.gain_over(&e.1)));
            SetUpError {
                changes: near.take(NAMED).map(|(slip, fitted)| (slip.phrase(robot, fitted), slip.origin)).collect(),
                stated_mm: self.as_stated.map_or(f64::INFINITY, Fitted::length_mm),
                changed_mm: least.length_mm(),
                angles_rad: [self.as_stated.map_or(0.0, Fitted::angle_rad), least.angle_rad()],
            }
        });
        Judgement { named, untested, is_possible: self.as_stated.is_some_and(is_possible) }
    }

    /// The change, if the set-up as given is possible and not clearly better, and the flange is
    /// elsewhere with the change.
    fn untested(&self, slip: &Slip, fitted: &Fitted) -> Option<Untested> {
        let stated = self.as_stated.filter(|stated| is_possible(stated))?;
        let alike = is_possible(fitted) && explains_as_well(stated.gain_over(fitted));
        if !alike || slip.listing == Listing::Never || self.is_named(slip, fitted, 1) {
            return None;
        }
        let differs = self.elsewhere.as_ref()?.flange_difference(slip, [&stated.values, &fitted.values])?;
        (differs.1 > SAME_RAD || differs.0 > SAME_MM).then(|| Untested {
            change: slip.what.clone(),
            residuals_mm: [stated.length_mm(), fitted.length_mm()],
            differs,
        })
    }

    /// `true` if a hypothesis explains the data and the set-up as given does not: its residuals are
    /// as small as a robot's, and each of its mistakes makes them clearly smaller, or the given
    /// set-up needs parameters that no robot has. A published robot is named if it explains the
    /// data as well, near its nominal values, where the given robot is beyond its tolerances. A
    /// reading that is left out always leaves less: it is named if no robot explains it.
    fn is_named(&self, slip: &Slip, fitted: &Fitted, mistakes: u8) -> bool {
        let Some(stated) = self.as_stated else { return is_possible(fitted) };
        if slip.is_reading && is_possible(stated) {
            return false;
        }
        let (gain, redundant) = (fitted.gain_over(stated), fitted.redundant);
        let is_only = mistakes == 1 && stated.off > OFF && is_more_probable(gain, redundant);
        let is_nearer = stated.off > TOLERANCE && NEARER * fitted.off < stated.off;
        let is_published = slip.is_other_robot() && is_nearer && explains_as_well(stated.gain_over(fitted));
        is_possible(fitted) && (is_only || is_published || explains_better(gain, redundant, mistakes))
    }
}

/// `true` if a change of so many mistakes explains the data clearly better than the set-up as
/// stated: by the logarithm of the ratio of their standard deviations, and the number of residuals
/// that decide.
pub(crate) fn explains_better(gain: f64, redundant: f64, mistakes: u8) -> bool {
    gain > f64::from(mistakes) * CLEAR.ln() && is_more_probable(gain, redundant)
}

/// `true` if chance is no cause of the gain.
fn is_more_probable(gain: f64, redundant: f64) -> bool {
    gain * redundant > FALLS_BY
}

/// `true` if data do not decide against a change that explains them worse by this logarithm of the
/// ratio of standard deviations.
pub(crate) fn explains_as_well(worse: f64) -> bool {
    worse < WORSE.ln()
}

/// `true` if a robot with these parameters can leave residuals of these standard deviations: of
/// angles (rad), or of lengths (mm).
pub(crate) fn is_possible_misfit(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    values: &[f64],
    mut scales: impl Iterator<Item = (bool, f64)>,
) -> bool {
    let spread_mm = fit::spread_mm(robot, &Data::new(robot, observations, settings), values);
    scales.all(|(is_angle, scale)| scale < if is_angle { MISFIT[1] } else { MISFIT[0] * spread_mm })
}

/// `true` if a robot can leave such residuals.
fn is_possible(fitted: &Fitted) -> bool {
    fitted.share < MISFIT[0] && fitted.angle_rad() < MISFIT[1] && fitted.off <= OFF
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_base::noise::Noise;
    use etalon_base::phrase;
    use etalon_robots::{Prexyt, Quantity, Serial, SerialJoint};
    use std::f64::consts::{FRAC_PI_2, PI};

    fn stated(standard_uncertainty_mm: f64) -> Settings {
        let stated = Some(standard_uncertainty_mm).filter(|u_mm| *u_mm > 0.0);
        Settings { standard_uncertainty_mm: stated, ..Settings::default() }
    }

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

    /// One of two exports in inches is named, with its target alone; correct data and data that no
    /// unit explains are not accused.
    #[test]
    fn the_unit_of_one_target_is_named_alone() {
        let robot = Prexyt::default();
        for (target, factor, slip) in [(0, 1.0 / 25.4, "inch-mm"), (1, 25.4, "mm-inch"), (1, 1e-3, "m-mm")] {
            let mut observations = measured(&robot, 0.0);
            for p in observations.iter_mut().filter_map(|o| o.targets[target].as_mut()) {
                *p = p.map(|v| v * factor);
            }
            let found = set_up_error(&robot, &observations, &stated(0.003)).expect("a slip");
            let targets = vec![format!("`{}`", robot.targets()[target])];
            assert_eq!(found.changes[0].0, phrase!("slip-unit-of-targets", targets, slip), "{found:?}");
            assert_eq!(found.changes.len(), 1, "{found:?}");
        }
        let (mut observations, mut noise) = (measured(&robot, 0.0), Noise::new(16, 7));
        for p in observations.iter_mut().filter_map(|o| o.targets[1].as_mut()) {
            *p = [noise.uniform(200.0), noise.uniform(200.0), 0.0];
        }
        assert_eq!(set_up_error(&robot, &observations, &stated(0.003)), None);
    }

    /// Forty poses with points in inches, from a frame that lies elsewhere.
    #[test]
    fn a_unit_is_named_and_sound_data_have_no_slip() {
        let robot = Prexyt::default();
        let mut observations = measured(&robot, 0.0);
        assert_eq!(set_up_error(&robot, &observations, &stated(0.003)), None);
        for p in observations.iter_mut().flat_map(|o| o.targets.iter_mut().flatten()) {
            *p = [25.4 * p[0] + 900.0, 25.4 * p[1] - 700.0, 0.0];
        }
        let found = set_up_error(&robot, &observations, &stated(0.003)).expect("a slip");
        assert_eq!(found.changes[0].0, phrase!("slip-unit", quantity = "points", slip = "mm-inch"));
        assert!(found.changed_mm < 0.01 && found.stated_mm > 1.0, "{found:?}");
        // joints of another robot, and points that nothing explains
        let mut noise = Noise::new(16, 6);
        for p in observations.iter_mut().flat_map(|o| o.targets.iter_mut().flatten()) {
            *p = [noise.uniform(200.0), noise.uniform(200.0), 0.0];
        }
        assert_eq!(set_up_error(&robot, &observations, &stated(0.003)), None);
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
            assert_eq!(set_up_problem(&robot, &observations, &stated(0.0)).0, None, "{range}");
            assert_eq!(set_up_error(&robot, &observations, &stated(0.0)), None, "{range}");
            for p in observations.iter_mut().flat_map(|o| o.targets.iter_mut().flatten()) {
                *p = p.map(|v| v * 1e-3);
            }
            if range > 1.0 {
                let found = set_up_error(&robot, &observations, &stated(0.0)).expect("a slip");
                assert_eq!(found.changes[0].0, phrase!("slip-unit", quantity = "points", slip = "m-mm"));
                assert!(set_up_problem(&robot, &observations, &stated(0.0)).0.is_some());
            }
        }
    }

    /// Rows (alpha, a, theta, d) of a six-axis arm.
    const ROWS: [[f64; 4]; 6] = [
        [0.0, 0.0, 0.0, 290.0],
        [-FRAC_PI_2, 0.0, -FRAC_PI_2, 0.0],
        [0.0, 270.0, 0.0, 0.0],
        [-FRAC_PI_2, 70.0, 0.0, 302.0],
        [FRAC_PI_2, 0.0, 0.0, 0.0],
        [-FRAC_PI_2, 0.0, PI, 72.0],
    ];

    /// Parameters near nominal, with base and target anywhere.
    fn drawn(robot: &dyn Robot, noise: &mut Noise) -> Vec<f64> {
        let value = |p: &etalon_robots::Parameter| match (p.role, p.quantity) {
            (Role::Base, Quantity::Length) => noise.uniform(1500.0),
            (Role::Base, _) => noise.uniform(1.0),
            (Role::Target, _) => 40.0 + noise.uniform(60.0),
            (_, Quantity::Length) => p.nominal + noise.uniform(0.5),
            (_, Quantity::Angle) => p.nominal + noise.uniform(2e-3),
            _ => p.nominal,
        };
        robot.parameters().iter().map(value).collect()
    }

    /// Position of the target, with errors of the joints of up to 0.5 mrad that repeat with their
    /// turn.
    fn seen(robot: &dyn Robot, truth: &[f64], joints: &[f64], noise: &mut Noise) -> [f64; 3] {
        let bent: Vec<f64> = joints.iter().map(|q| q + 5e-4 * (2.0 * q + 0.6).sin()).collect();
        robot.position(truth, &bent, 0).map(|v| v + noise.gaussian(0.02))
    }

    /// A six-axis arm whose joints err by up to 0.5 mrad with their turn, which its model lacks,
    /// and its true parameters. Every 23rd pose may be outside the joint values of the others.
    fn arm_with_truth(seed: u64, poses: i64) -> (Serial, Vec<f64>, Vec<Observation>) {
        let joint = |[alpha_rad, a_mm, theta_rad, d_mm]: [f64; 4]| SerialJoint {
            alpha_rad,
            a_mm,
            theta_rad,
            d_mm,
            prismatic: false,
            parallel: a_mm > 200.0,
        };
        let robot = Serial::new(&ROWS.map(joint), &["T".to_owned()], [0.0, 0.0, -1.0], &[], &[]);
        let mut noise = Noise::new(62, seed);
        let truth = drawn(&robot, &mut noise);
        let observation = |pose: i64| {
            let range = if pose % 23 == 0 { 3.0 } else { 1.5 };
            let joints: Vec<f64> = (0..6).map(|_| noise.uniform(range)).collect();
            let at = seen(&robot, &truth, &joints, &mut noise);
            Observation { pose: pose.into(), cycle: 1, joints, targets: vec![Some(at)], ..Observation::default() }
        };
        let observations = (1..=poses).map(observation).collect();
        (robot, truth, observations)
    }

    fn arm(seed: u64, poses: i64) -> (Serial, Vec<Observation>) {
        let (robot, _, observations) = arm_with_truth(seed, poses);
        (robot, observations)
    }

    /// Settings of the measurements of the arm.
    fn usual() -> Settings {
        Settings { prior: crate::Prior::TOLERANCES, effects: crate::Effects::Usual, ..stated(0.02) }
    }

    /// The columns of four joints are shifted against the others.
    #[test]
    fn shifted_columns_of_some_joints_are_named() {
        let (robot, mut observations) = arm(1, 40);
        observations.iter_mut().for_each(|o| o.joints[1..5].rotate_left(1));
        let found = set_up_error(&robot, &observations, &usual()).expect("a change");
        let block = phrase!("slip-joint-block", first = "`q2`", last = "`q5`", order = "right");
        assert_eq!(found.changes.iter().map(|(what, _)| what).collect::<Vec<_>>(), [&block]);
    }

    /// Every pair of reversed joints is tried, also if neither of them alone brings the robot
    /// nearer.
    #[test]
    fn all_pairs_of_reversed_joints_are_tried() {
        let (robot, observations) = arm(1, 6);
        let data = Data::new(&robot, &observations, &usual());
        let pairs = changes::reversed_pairs(&robot, &data);
        assert_eq!(pairs.len(), 15);
        let [first, second] = ["`q2`", "`q5`"].map(|joint| phrase!("slip-reversed", joint));
        let pair =
            pairs.iter().find(|pair| pair.what == phrase!("slip-pair", first = first.clone(), second = second.clone()));
        let [q, changed] = [&data, &pair.expect("a pair").data].map(|data| &data.observations[0].joints);
        assert_eq!(*changed, [q[0], -q[1], q[2], q[3], -q[4], q[5]]);
    }

    /// Zeros of 3.3 deg add up along an arm of screw axes (`poe`), whose places are absolute: no
    /// sign of a joint and no single value is the cause.
    #[test]
    fn zeros_that_add_up_along_screw_axes_accuse_nothing_else() {
        let mut home = etalon_base::pose::Pose::identity();
        let axis = |[alpha_rad, a_mm, theta_rad, d_mm]: [f64; 4]| {
            home = home.turn_x(alpha_rad).shift(0, a_mm).turn_z(theta_rad).shift(2, d_mm);
            etalon_robots::AxisLine { direction: home.axis(2), point_mm: home.translation_mm, prismatic: false }
        };
        let axes = ROWS.map(axis);
        let robot = Serial::from_axes(&axes, &home, &["T".to_owned()]);
        let mut noise = Noise::new(62, 1);
        let truth = drawn(&robot, &mut noise);
        let observation = |pose: i64| {
            let joints: Vec<f64> = (0..6).map(|_| noise.uniform(1.2)).collect();
            let mut turned = joints.clone();
            turned[1..5].iter_mut().for_each(|q| *q += 3.3f64.to_radians());
            let at = robot.position(&truth, &turned, 0).map(|v| v + noise.gaussian(0.02));
            Observation { pose: pose.into(), cycle: 1, joints, targets: vec![Some(at)], ..Observation::default() }
        };
        let observations: Vec<Observation> = (1..=40).map(observation).collect();
        assert_eq!(set_up_error(&robot, &observations, &usual()), None);
    }

    /// Errors that a model lacks are common to all lengths: a coordinate is no outlier because
    /// those at other poses have smaller errors. One that is off by 3 mm is the only outlier.
    #[test]
    fn the_misfit_of_one_length_is_that_of_the_others() {
        for seed in 1..=3 {
            let (robot, truth, observations) = arm_with_truth(seed, 70);
            let mut noise = Noise::new(63, seed);
            let mut settings = usual();
            // the joints err by nothing at these joint values, but for the last pose
            for pose in 101..=131 {
                let range = if pose == 131 { 1.5 } else { 0.02 };
                let joints: Vec<f64> = (0..6).map(|_| noise.uniform(range) - 0.3).collect();
                let at_mm = seen(&robot, &truth, &joints, &mut noise)[0];
                let kind = crate::Kind::Coordinate(crate::Coordinate { axis: 0, at_mm });
                let (pose, standard_uncertainty) = (i64::from(pose).into(), 0.02);
                settings.conditions.push(crate::Condition {
                    pose,
                    cycle: 1,
                    joints,
                    target: 0,
                    kind,
                    standard_uncertainty,
                });
            }
            let outliers = |settings: &Settings| {
                let found = crate::identify(&robot, &observations, settings).expect("identified");
                let fit = crate::RobustFit::new(&robot, &observations, settings, &found).expect("a fit");
                fit.outliers().iter().map(|reading| reading.pose).collect::<Vec<_>>()
            };
            let none = outliers(&settings);
            assert!(none.is_empty(), "{seed}: {none:?}");
            let wrong = &mut settings.conditions[4];
            let pose = wrong.pose;
            let crate::Kind::Coordinate(coordinate) = &mut wrong.kind else { panic!("a coordinate") };
            coordinate.at_mm += 3.0;
            assert_eq!(outliers(&settings), [pose], "{seed}");
        }
    }

    /// Few poses determine some parameters almost alone, so that the others predict anything.
    /// Correct data are not accused, and a reversed joint is noticed.
    #[test]
    fn few_poses_of_an_incomplete_model_accuse_nothing() {
        let stated = usual();
        for seed in 1..=3 {
            let (robot, mut observations) = arm(seed, 10);
            let judged = judge(&robot, &observations, &stated, &[]);
            assert!(judged.is_possible && judged.named.is_none(), "{seed}: {:?}", judged.named);
            observations.iter_mut().for_each(|o| o.joints[2] = -o.joints[2]);
            assert!(!judge(&robot, &observations, &stated, &[]).is_possible, "{seed}");
        }
    }

    /// Errors that repeat with the turn of the joints are no outliers, and a pose outside the joint
    /// values of the others may be farther off. A reading that is 3 mm off is the only outlier.
    #[test]
    fn the_usual_misfit_is_no_outlier() {
        let stated = usual();
        for seed in 1..=4 {
            let (robot, mut observations) = arm(seed, 70);
            let robust = |observations: &[Observation]| {
                let found = crate::identify(&robot, observations, &stated).expect("identified");
                crate::RobustFit::new(&robot, observations, &stated, &found).expect("a fit")
            };
            let sound = robust(&observations);
            assert!(sound.outliers().is_empty(), "{seed}: {:?}", sound.outliers());
            let far = sound.readings.iter().filter(|reading| observations[45].pose == reading.pose);
            let least = sound.limit(Some(crate::ErrorKind::Position));
            assert!(far.clone().count() == 1 && far.map(|reading| reading.limit).all(|limit| limit > 1.2 * least));
            observations[30].targets[0].as_mut().expect("measured")[1] += 3.0;
            let poses: Vec<_> = robust(&observations).outliers().iter().map(|reading| reading.pose).collect();
            assert_eq!(poses, [observations[30].pose], "{seed}");
        }
    }

    /// A target on the axis of the last joint does not show its sign. The list of a set-up that
    /// explains its data is the list of the whole judgement, which names nothing.
    #[test]
    fn changes_that_the_data_do_not_show_are_listed_without_the_others() {
        let (robot, _) = arm(1, 1);
        let (nominal, mut noise) = (robot.nominal(), Noise::new(67, 1));
        let pose = |pose: i64| {
            let joints = [1.5, 1.5, 1.5, 1.5, 2e-3, 1.5].map(|range| noise.uniform(range)).to_vec();
            let at = robot.position(&nominal, &joints, 0).map(|v| v + noise.gaussian(0.02));
            Observation { pose: pose.into(), cycle: 1, joints, targets: vec![Some(at)], ..Observation::default() }
        };
        let observations: Vec<Observation> = (1..=40).map(pose).collect();
        let settings = Settings { prior: crate::Prior::TOLERANCES, ..stated(0.02) };
        let judged = judge(&robot, &observations, &settings, &[]);
        let reversed = phrase!("slip-reversed", joint = format!("`{}`", robot.joints()[5].name));
        assert!(judged.named.is_none() && judged.untested.iter().any(|u| u.change == reversed), "{judged:?}");
        assert_eq!(untested_changes(&robot, &observations, &settings), judged.untested);
    }

    /// A change that is given up would neither be named nor be listed as untested.
    #[test]
    fn changes_that_are_given_up_explain_nothing() {
        let robot = Prexyt::default();
        let (observations, settings) = (measured(&robot, 0.0), stated(0.003));
        let data = Data::new(&robot, &observations, &settings);
        let stated = Stated::new(&robot, &data, &[]).expect("judged");
        let as_stated = stated.fit.as_ref().expect("fitted");
        let tried = |limit: Option<f64>| {
            let mut all = stated.table().single();
            nearest(&mut all, f64::NEG_INFINITY);
            fits(&robot, all, limit)
        };
        let all = tried(None);
        let kept = tried(stated.case.as_ref().map(|case| case.near + HOPELESS.ln()));
        let is_kept = |slip: &Slip| kept.iter().any(|(other, _)| other.what == slip.what);
        let given_up: Vec<&(Slip, Fitted)> = all.iter().filter(|(slip, _)| !is_kept(slip)).collect();
        assert!(stated.is_possible() && given_up.len() > all.len() / 2, "{} of {}", given_up.len(), all.len());
        for (slip, fitted) in given_up {
            let worse = as_stated.gain_over(fitted);
            assert!(!is_possible(fitted) || worse > 2.0 * WORSE.ln(), "{:?}: {worse}", slip.what);
        }
    }

    /// A joint that lost its zero is named. A turned base explains another zero of the first joint,
    /// and both are named.
    #[test]
    fn a_lost_zero_is_found_where_it_happens() {
        for (joint, id) in [(0, "reference-moved"), (2, "joint-zero-shifted"), (4, "joint-zero-shifted")] {
            let (robot, mut observations) = arm(3, 60);
            let settings = Settings { prior: crate::Prior::TOLERANCES, ..stated(0.02) };
            observations[25..].iter_mut().for_each(|o| o.joints[joint] -= 0.01);
            let found = crate::identify(&robot, &observations, &settings).expect("identified");
            let found = moved_between(&robot, &observations, &settings, &found, &found.values).expect("changed");
            let [pose, previous] = [25, 24].map(|k: usize| observations[k].pose);
            assert!(found.is(id, &[("pose", &pose), ("previous", &previous)]), "{joint}: {found:?}");
            let name = format!("joint `{}`", robot.joints()[joint].name);
            assert!(found.what.contains(&name), "{joint}: {found:?}");
            if let Some(etalon_base::catalogue::Argument::Number(change)) = found.arguments.get("change") {
                assert!((change - 0.01f64.to_degrees()).abs() < 0.02, "{found:?}");
            }
        }
    }

    #[test]
    fn a_move_is_found_where_it_happens_and_nowhere_else() {
        let robot = Prexyt::default();
        let moved = |observations: &[Observation]| {
            let settings = Settings { prior: crate::Prior::TOLERANCES, ..stated(0.003) };
            let found = crate::identify(&robot, observations, &settings).expect("identified");
            moved_between(&robot, observations, &settings, &found, &found.values)
        };
        let found = moved(&measured(&robot, 0.05)).expect("moved");
        assert!(found.is("reference-moved", &[("pose", &"22"), ("previous", &"21")]), "{found:?}");
        assert!(found.what.contains("by 0.05") && found.what.contains("(0.05"), "{}", found.what);
        assert_eq!(moved(&measured(&robot, 0.0)), None);
        // a single wrong reading, at an end or between others, is not a move
        for wrong in [0, 20, 39] {
            let mut observations = measured(&robot, 0.0);
            observations[wrong].targets[0].as_mut().unwrap()[0] += 0.5;
            assert_eq!(moved(&observations), None, "{wrong}");
        }
    }
}
