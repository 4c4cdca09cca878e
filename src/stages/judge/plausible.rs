//! Plausibility of a result: errors of a result that no real robot can have. Such a result must not
//! reach a controller.

use crate::stages::calibrate::solution::{Basis, Solution};
use crate::stages::judge::circumstances::{exchanged_torques, torque_signs};
use crate::stages::judge::readings::RobustReadings;
use crate::stages::judge::set_up::untested;
use crate::stages::judge::undescribed::{CalibrationFit, undescribed};
use crate::stages::remedies::reading;
use crate::stages::truncated;
use etalon_base::catalogue::Phrase;
use etalon_base::message::{Message, Severity};
use etalon_base::pose::norm;
use etalon_base::pose_name::PoseName;
use etalon_base::{error, phrase, warning};
use etalon_documents::{PointError, PoseSet, set_up_hint, warning_message};
use etalon_formats::tables::joints::PAYLOAD;
use etalon_identify::{
    Identification, Judgement, LEAST_RESIDUAL, LoadSlip, OUTLIER, Observation, Prior, Settings, Untested, allowed_mm,
    chi_square_exceeds, far_problem, judge, load_slips, moved_between, observed_noise_mm, untested_changes,
};
use etalon_math::statistics::{mean, median, rms, standard_deviation};
use etalon_robots::{Effect, Parameter, Quantity, Robot, Role};
use statrs::distribution::{ContinuousCDF, Normal, StudentsT};
use std::collections::BTreeSet;

/// Coverage factor of a value that contradicts a tolerance, where a single parameter is judged.
const EXPANDED: f64 = 2.0;
/// Maximum number of parameters beyond their tolerance in a message.
const NAMED: usize = 5;
/// Validation errors beyond this multiple of their median are named: one in 60,000 normal errors in
/// the plane exceeds it (Rayleigh).
const FAR: f64 = 4.0;
/// Limit for errors along one direction (distances and planes): one in 19,000 normal errors exceeds
/// it.
const FAR_ALONG: f64 = 6.0;
/// Residuals beyond this multiple of the root mean square are examined as outliers if no
/// uncertainty is given.
const SPIKE: f64 = 5.0;
/// Minimum number of parameters with a common factor.
const FEWEST_SCALED: usize = 4;
/// Minimum nominal value (mm, 1) for a factor.
const LEAST_NOMINAL: f64 = 0.5;
/// Minimum common factor: smaller ones are within the errors of instruments and drawings.
const LEAST_SCALE: f64 = 2e-4;
/// Standard uncertainties below zero at which a value is negative.
const SIGNIFICANT: f64 = 3.0;
/// Deviation of the gain of a revolute joint that harmonics of its transmission can cause over part
/// of a turn.
const ENCODER_GAIN: f64 = 2e-3;
/// Maximum deviation (rad) of the zero of a revolute joint by mastering: 1 deg.
const ENCODER_ZERO_RAD: f64 = std::f64::consts::PI / 180.0;
/// Significance level of a common factor.
const CHANCE: f64 = 1e-3;
/// Maximum ratio of errors after to errors before that noise of an already good robot can cause.
const WORSE: f64 = 1.1;

/// Judgement of the set-up of a solution; if balls are swapped, nothing else is judged.
fn judge_set_up(robot: &dyn Robot, solution: &Solution) -> Judgement {
    let Solution { basis: Basis { sets, settings, .. }, found, .. } = solution;
    match exchanged(robot, &found.values) {
        Some(_) => Judgement::default(),
        None => judge(robot, &sets.calibration, settings, &[]),
    }
}

/// Messages about a solution, and the mistakes of its set-up that the data do not show.
pub(crate) struct Plausibility {
    /// Errors if the result cannot be a robot, and the observations to check first if they do not
    /// fit.
    pub messages: Vec<Message>,
    pub untested: Vec<Untested>,
}

/// Judges the identified parameters and their errors.
pub(crate) fn plausibility(
    robot: &dyn Robot,
    solution: &Solution,
    errors: &[PointError],
    readings: Option<&RobustReadings>,
) -> Plausibility {
    let Solution { basis: Basis { sets, settings, .. }, found, .. } = solution;
    let observations = &sets.calibration[..];
    let unchecked = undetermined(robot, observations, settings, found);
    let mut messages = implausible(robot, found, errors, unchecked.is_some());
    messages.extend(unchecked);
    let misfit = match found.residuals.chi_square {
        Some(chi_square) => chi_square_exceeds(chi_square, found.residuals.degrees_of_freedom),
        None => !messages.is_empty() || found.residuals.max > SPIKE * found.residuals.rms.max(LEAST_RESIDUAL),
    };
    // a robot within its tolerances, with residuals of the size of the instrument's uncertainty,
    // explains the data
    let explains = found.residuals.chi_square.is_some() && !misfit && messages.iter().all(is_no_error);
    // no change is named if the set-up as given explains the data
    let mistakes = if explains {
        let mistakes = untested_changes(robot, observations, settings);
        messages.extend(untested(&mistakes));
        mistakes
    } else {
        let judged = judge_set_up(robot, solution);
        messages.extend(untested(&judged.untested));
        contradict(far_before(robot, solution, errors), &judged, &mut messages);
        judged.untested
    };
    if let Some(turned) = orientations_turned(settings, errors) {
        messages.insert(0, turned);
    }
    messages.extend(common_factor(robot, found));
    messages.extend(beyond_encoders(robot, observations, settings, found));
    messages.extend(negative_compliance(robot, found));
    messages.extend(negative_backlash(robot, found));
    messages.extend(wrong_loads(robot, observations, settings, found));
    messages.extend(torque_signs(robot, found));
    if misfit {
        messages.extend(exchanged_torques(robot, observations, settings, found));
    }
    messages.extend(validation_outliers(settings, errors));
    if misfit || found.residuals.chi_square.is_none() {
        let outlying = readings.map(|readings| &readings.fit).filter(|fit| !fit.outliers().is_empty());
        let values = outlying.map_or(&found.values, |fit| &fit.values);
        messages.extend(moved_between(robot, observations, settings, found, values));
    }
    if let Some(readings) = readings {
        readings.add_to(&mut messages, robot);
    }
    Plausibility { messages, untested: mistakes }
}

/// `true` if errors of a solution give reason to look for wrong readings: residuals exceed the
/// uncertainty of the instrument, one of them is a spike, or validation readings are far from the
/// others.
pub(crate) fn is_suspect(settings: &Settings, found: &Identification, errors: &[PointError]) -> bool {
    let spike_mm = match settings.standard_uncertainty_mm {
        Some(u_mm) if found.residuals.chi_square.is_some() => OUTLIER * u_mm,
        _ => SPIKE * found.residuals.rms.max(LEAST_RESIDUAL),
    };
    let degrees = found.residuals.degrees_of_freedom;
    let exceeds = found.residuals.chi_square.is_some_and(|chi_square| chi_square_exceeds(chi_square, degrees));
    exceeds || found.residuals.max > spike_mm || validation_outliers(settings, errors).is_some()
}

/// Returns a message if the poses have no more coordinates than identified parameters, so that the
/// parameters are unchecked: an error if parameters rest on the poses alone, a warning with nominal
/// values.
fn undetermined(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    found: &Identification,
) -> Option<Message> {
    let targets =
        |o: &Observation| (0..o.targets.len()).filter(|&k| o.targets[k].is_some()).map(|k| (o.pose, k)).collect();
    let distinct: BTreeSet<(PoseName, usize)> = observations.iter().flat_map(|o| -> Vec<_> { targets(o) }).collect();
    let conditions: usize = settings.conditions.iter().map(|c| c.kind.rows()).sum();
    let coordinates = robot.dimension() * distinct.len() + conditions;
    let determined = found.identifiability.determined.round() as usize;
    let message = match settings.prior {
        Prior::None => error!("no-coordinates-to-check", count = coordinates, parameters = determined),
        Prior::Tolerances { .. } => {
            warning!("no-coordinates-to-check", count = coordinates, parameters = determined).to_decide()
        }
    };
    (coordinates <= determined).then_some(message)
}

/// Median angle between observed and predicted orientations beyond which these are of another
/// convention: errors of joints are a few degrees at most.
const TURNED_DEG: f64 = 10.0;

/// Returns an error if observed orientations are far from the orientations of the identified robot.
fn orientations_turned(settings: &Settings, errors: &[PointError]) -> Option<Message> {
    if !settings.conditions.iter().any(|c| c.kind.is_orientation()) {
        return None;
    }
    let calibration = errors.iter().filter(|e| e.set == PoseSet::Calibration);
    let median_deg = median(calibration.filter_map(|e| e.after_deg)).filter(|deg| *deg > TURNED_DEG)?;
    Some(error!("orientations-off", robot = "identified", median_deg))
}

/// Returns a warning about validation readings far from the others; their errors contribute to the
/// accuracy.
fn validation_outliers(settings: &Settings, errors: &[PointError]) -> Option<Message> {
    let is_along = settings.conditions.iter().any(|c| c.kind.rows() == 1);
    let far_times = if is_along { FAR_ALONG } else { FAR };
    let of: Vec<&PointError> = errors.iter().filter(|e| e.set == PoseSet::Validation).collect();
    let median_mm = median(of.iter().map(|e| norm(e.after_mm)))?;
    let far: Vec<&&PointError> = of.iter().filter(|e| norm(e.after_mm) > far_times * median_mm).collect();
    if far.is_empty() || 10 * far.len() > of.len() {
        return None;
    }
    let (count, total, limit_mm) = (far.len(), of.len(), far_times * median_mm);
    let readings = far.iter().map(|e| reading(norm(e.after_mm), &e.target, e.pose, e.cycle));
    let message = warning!(
        "validation-outliers",
        count,
        total,
        times = far_times,
        limit_mm,
        readings = truncated(readings, NAMED)
    );
    Some(message.to_decide().hint(phrase!("check-readings")))
}

/// Returns a warning if lengths, or gains of prismatic joints, all deviate by one factor: the scale
/// of the measuring system, or a unit.
fn common_factor(robot: &dyn Robot, found: &Identification) -> Option<Message> {
    let sliding = robot.joints().iter().all(|j| j.quantity == Quantity::Length);
    let of = |quantity: Quantity| -> Vec<usize> {
        let fits = |&&i: &&usize| {
            let p = &robot.parameters()[i];
            p.role == Role::Robot && p.quantity == quantity && p.nominal.abs() > LEAST_NOMINAL
        };
        found.free.iter().filter(fits).copied().collect()
    };
    let all = [of(Quantity::Length), if sliding { of(Quantity::Ratio) } else { Vec::new() }].concat();
    if all.len() < FEWEST_SCALED {
        return None;
    }
    // relative deviations, and their scatter about the mean
    let off: Vec<f64> = all.iter().map(|&i| found.values[i] / robot.parameters()[i].nominal - 1.0).collect();
    let n = off.len() as f64;
    let (mean, deviation) = (mean(off.iter().copied()), standard_deviation(&off));
    let quantile = StudentsT::new(0.0, 1.0, n - 1.0).ok()?.inverse_cdf(1.0 - 0.5 * CHANCE);
    (mean.abs() > LEAST_SCALE && mean.abs() > quantile * deviation / n.sqrt()).then(|| {
        let names: Vec<String> = all.iter().map(|&i| format!("`{}`", robot.parameters()[i].name)).collect();
        warning!("common-scale", count = all.len(), parameters = names, factor = 1.0 + mean).to_decide()
    })
}

/// Returns a warning about gains and zeros of revolute joints that are significantly larger than
/// encoders and homing leave.
///
/// The encoder of a revolute joint counts whole turns, so that its gain is known; the contribution
/// of harmonics over part of a turn is below [`ENCODER_GAIN`]. A zero beyond [`ENCODER_ZERO_RAD`]
/// is a mistake of mastering, or of a log. The data cannot tell them from a mistake in the columns
/// of the joint.
fn beyond_encoders(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    found: &Identification,
) -> Option<Message> {
    let conditions = settings.conditions.iter().map(|c| c.joints.as_slice());
    let joints = observations.iter().map(|o| o.joints.as_slice()).chain(conditions);
    let effects = etalon_identify::effects(robot, joints);
    let limit = |i: usize| {
        let p = &robot.parameters()[i];
        let turns =
            p.joint.is_some_and(|joint| robot.joints().get(joint).is_some_and(|j| j.quantity == Quantity::Angle));
        match effects[i].filter(|_| !p.tolerance_is_stated)? {
            Effect::Gains if turns && p.by.is_none() => Some(ENCODER_GAIN),
            Effect::Zeros if p.quantity == Quantity::Angle => Some(ENCODER_ZERO_RAD),
            _ => None,
        }
    };
    let judged: Vec<(usize, f64, f64)> =
        found.free.iter().filter_map(|&i| Some((i, limit(i)?, found.standard_uncertainty(i)?))).collect();
    let k = coverage_factor(judged.len());
    let off = |i: usize| (found.values[i] - robot.parameters()[i].nominal).abs();
    let beyond = judged.iter().filter(|(i, limit, u)| off(*i) > limit + k * u);
    let text = |&(i, _, u): &(usize, f64, f64)| {
        let (parameter, value, unit) = outward(&robot.parameters()[i], found.values[i]);
        let nominal = robot.parameters()[i].quantity.outward(robot.parameters()[i].nominal);
        phrase!("value-beyond-encoder", parameter, value, unit, nominal, times = (off(i) / u).round())
    };
    let all: Vec<Phrase> = beyond.map(text).collect();
    (!all.is_empty())
        .then(|| warning!("encoder-implausible", count = all.len(), parameters = truncated(all, NAMED)).to_decide())
}

/// Name, value and unit of the first parameter of a kind whose value is significantly negative.
fn negative<'r>(
    robot: &'r dyn Robot,
    found: &Identification,
    is_meant: fn(&Parameter) -> bool,
) -> Option<(&'r str, f64, String)> {
    let is_negative = |&&i: &&usize| {
        let u = found.standard_uncertainty(i).unwrap_or(f64::INFINITY);
        is_meant(&robot.parameters()[i]) && found.values[i] < -SIGNIFICANT * u
    };
    let &i = found.free.iter().find(is_negative)?;
    let parameter = &robot.parameters()[i];
    let (name, value, _) = outward(parameter, found.values[i]);
    Some((name, value, parameter.printed_unit()))
}

/// Returns a warning if a joint bends against its own torque: gravity or an axis has the wrong
/// direction.
fn negative_compliance(robot: &dyn Robot, found: &Identification) -> Option<Message> {
    let of_one_joint = |p: &Parameter| {
        let bends = matches!(p.effect, Effect::Bending | Effect::Payload) && p.by.is_some() && p.by == p.joint;
        bends || p.effect == Effect::Lateral
    };
    let (parameter, value, unit) = negative(robot, found, of_one_joint)?;
    Some(warning!("compliance-negative", parameter, value, unit).to_decide())
}

/// Returns a warning if a joint is ahead of its motor: the directions of approach have the wrong
/// sign.
fn negative_backlash(robot: &dyn Robot, found: &Identification) -> Option<Message> {
    let (parameter, value, unit) = negative(robot, found, |p| p.effect == Effect::Backlash)?;
    Some(warning!("backlash-negative", parameter, value, unit).to_decide())
}

/// Returns a warning if the data reject the given centres of mass, and a change of their columns
/// explains the data.
fn wrong_loads(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    found: &Identification,
) -> Option<Message> {
    let contradiction = load_slips(robot, observations, settings, found).ok()??;
    let column = |k: usize| PAYLOAD[k + 1];
    let change = |slip: &LoadSlip| match *slip {
        LoadSlip::Exchanged([a, b]) => phrase!("load-change-exchanged", first = column(a), second = column(b)),
        LoadSlip::Sign(k) => phrase!("load-change-sign", column = column(k)),
        LoadSlip::Unit(mm) => phrase!("load-change-unit", unit = if mm > 100.0 { "m" } else { "inch" }),
    };
    let changes: Vec<Phrase> = contradiction.slips.iter().map(change).collect();
    let over_u = contradiction.over_u;
    Some(warning!("load-columns-slip", count = changes.len(), over_u, changes).to_decide())
}

/// Name, value and unit of a parameter.
fn outward(p: &Parameter, value: f64) -> (&str, f64, &'static str) {
    (&p.name, p.quantity.outward(value), p.quantity.unit())
}

/// Adds the contradiction of the set-up to the messages: an error if the nominal robot is farther
/// from most measurements (`far_mm`) than its tolerances allow, and no robot within them fits the
/// measurements; or the change that explains the measurements, as the hint of the first error.
fn contradict(far_mm: Option<[f64; 2]>, judged: &Judgement, messages: &mut Vec<Message>) {
    if let Some(far) = far_mm.and_then(|far_mm| far_problem(far_mm, judged)) {
        messages.insert(0, warning_message(&far));
        return;
    }
    let Some(found) = &judged.named else { return };
    if messages.iter().all(is_no_error) {
        messages.insert(0, error!("set-up-contradicted"));
    }
    if let Some(first) = messages.iter_mut().find(|message| message.severity == Severity::Error) {
        first.hint = Some(set_up_hint(found));
    }
}

fn is_no_error(message: &Message) -> bool {
    message.severity != Severity::Error
}

/// Distance (mm) of the nominal robot from the measurements, and the one that its tolerances allow,
/// if most measurements are farther. Few poses in a small volume determine the positions of base
/// and targets of the nominal robot poorly.
fn far_before(robot: &dyn Robot, solution: &Solution, errors: &[PointError]) -> Option<[f64; 2]> {
    let Solution { basis: Basis { sets, settings, .. }, before, .. } = solution;
    let observations = &sets.calibration[..];
    if observations.is_empty() {
        // what tolerances allow is known of positions
        return None;
    }
    let calibration = errors.iter().filter(|e| e.set == PoseSet::Calibration);
    let left: Vec<f64> = calibration.map(|e| norm(e.before_mm)).collect();
    let noise_mm = observed_noise_mm(robot, observations, settings.coordinate_uncertainty_mm());
    let allowed_mm = allowed_mm(robot, observations, before, noise_mm)?;
    let rms_mm = rms(left.iter().copied());
    (median(left)? > allowed_mm).then_some([rms_mm, allowed_mm])
}

/// Errors about the identified parameters and their residuals; empty if the result is plausible.
fn implausible(robot: &dyn Robot, found: &Identification, errors: &[PointError], unchecked: bool) -> Vec<Message> {
    let mut messages = Vec::new();
    if let Some((p, value)) = exchanged(robot, &found.values) {
        return vec![error!("ball-names-exchanged", parameter = p.name, value, unit = p.quantity.unit())];
    }
    messages.extend(beyond_tolerance(robot, found));
    let mut calibration = CalibrationFit::Unknown;
    for set in PoseSet::ALL {
        let of = || errors.iter().filter(|e| e.set == set);
        let (before_mm, after_mm) = (rms(of().map(|e| norm(e.before_mm))), rms(of().map(|e| norm(e.after_mm))));
        let undescribed = undescribed(set, errors, calibration);
        calibration = match undescribed.is_none() && of().count() > 1 {
            true if unchecked => CalibrationFit::Unchecked,
            true => CalibrationFit::Fits,
            false => CalibrationFit::Unknown,
        };
        if undescribed.is_none() && after_mm > WORSE * before_mm {
            messages.push(error!("identified-worse-than-nominal", set = set.name(), before_mm, after_mm));
        }
        messages.extend(undescribed);
    }
    messages
}

/// Returns an error about parameters that the data alone put beyond their tolerance, by more than
/// their uncertainty.
fn beyond_tolerance(robot: &dyn Robot, found: &Identification) -> Option<Message> {
    let by_data = |i: usize| match found.uncertainty.covariance {
        Some(_) => found.without_nominal(robot, i),
        None => Some((found.values[i], 0.0)),
    };
    let of = |(i, p)| Some((p, found.values[i], by_data(i).filter(|_| found.values[i].is_finite())));
    let all: Vec<_> = robot.parameters().iter().enumerate().filter_map(of).collect();
    let is_judged =
        |(p, _, by_data): &&(&Parameter, f64, Option<(f64, f64)>)| p.tolerance.is_finite() && by_data.is_some();
    let k = coverage_factor(all.iter().filter(is_judged).count());
    let beyond = |(p, value, by_data): &(&Parameter, f64, Option<(f64, f64)>)| {
        let contradicts = |(value, u): (f64, f64)| (value - p.nominal).abs() > p.tolerance + k * u;
        value.is_nan() || by_data.is_some_and(contradicts)
    };
    let wrong: Vec<_> = all.into_iter().filter(beyond).collect();
    let text = |(p, value, by_data): &(&Parameter, f64, Option<(f64, f64)>)| {
        let round = |v: f64| (1e6 * p.quantity.outward(v)).round() / 1e6;
        let (parameter, value, unit) = outward(p, by_data.map_or(*value, |by_data| by_data.0));
        let (nominal, tolerance) = (round(p.nominal), p.quantity.outward(p.tolerance));
        phrase!("value-beyond-tolerance", parameter, value, unit, nominal, tolerance)
    };
    (!wrong.is_empty()).then(|| {
        error!("tolerance-exceeded", count = wrong.len(), parameters = truncated(wrong.iter().map(text), NAMED))
    })
}

/// Coverage factor at which one of `count` correct values lies beyond its tolerance as rarely as a
/// single value at [`EXPANDED`] (Bonferroni). Without it, one in twenty poorly determined values is
/// beyond its tolerance by chance.
fn coverage_factor(count: usize) -> f64 {
    let normal = Normal::standard();
    -normal.inverse_cdf(normal.cdf(-EXPANDED) / count.max(1) as f64)
}

/// The distance of K and L if it is negative: each ball was measured under the name of the other.
fn exchanged<'r>(robot: &'r dyn Robot, values: &[f64]) -> Option<(&'r Parameter, f64)> {
    let i = robot.platform()?.target_distance();
    let p = &robot.parameters()[i];
    (values[i] * p.nominal < 0.0).then_some((p, values[i]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_base::catalogue::Argument;
    use etalon_base::noise::Noise;
    use etalon_identify::identify;
    use etalon_robots::Prexyt;

    #[test]
    fn many_parameters_contradict_their_tolerances_by_chance_as_seldom_as_one() {
        assert!((coverage_factor(1) - 2.0).abs() < 1e-9 && coverage_factor(0) == coverage_factor(1));
        // normal quantile of 1 − 0.02275/30 (NIST/SEMATECH e-Handbook 1.3.6.7.1: 0.99924 at 3.17)
        assert!((coverage_factor(30) - 3.17).abs() < 5e-3);
    }

    /// Returns a message about a common factor if all measured points are scaled by `factor`, and
    /// the robot's parameters deviate from nominal by up to `off_mm`.
    fn said(factor: f64, off_mm: f64) -> Option<Message> {
        let (robot, mut noise) = (Prexyt::default(), Noise::new(16, 5));
        let own = |p: &Parameter| p.role == Role::Robot && p.quantity == Quantity::Length && p.nominal != 0.0;
        let truth: Vec<f64> =
            robot.parameters().iter().map(|p| p.nominal + if own(p) { noise.uniform(off_mm) } else { 0.0 }).collect();
        let pose = |i: i64| {
            let joints = vec![85.0 + noise.uniform(80.0), 150.0 + noise.uniform(100.0), 150.0 + noise.uniform(100.0)];
            let mut seen = |at: [f64; 2]| at.map(|v| factor * v + noise.gaussian(0.003));
            let targets = robot
                .balls(&truth, &joints)
                .map(|at| {
                    let [x, y] = seen(at);
                    Some([x, y, 0.0])
                })
                .to_vec();
            Observation { pose: i.into(), cycle: 1, joints, targets, ..Observation::default() }
        };
        let observations: Vec<Observation> = (1..=40).map(pose).collect();
        let settings = Settings { standard_uncertainty_mm: Some(0.003), ..Settings::default() };
        let found = identify(&robot, &observations, &settings).expect("identified");
        common_factor(&robot, &found)
    }

    #[test]
    fn a_factor_common_to_all_lengths_and_gains_is_a_scale_error() {
        for factor in [1.001, 0.9995] {
            let message = said(factor, 0.0).expect("a factor");
            let Some(Argument::Number(found)) = message.arguments.get("factor") else { panic!("{message}") };
            assert!(message.is("common-scale", &[]) && (found - factor).abs() < 5e-5, "{message}");
        }
        assert_eq!(said(1.0, 0.0), None);
        // parts that are off by themselves share none
        assert_eq!(said(1.0, 0.5), None);
    }
}
