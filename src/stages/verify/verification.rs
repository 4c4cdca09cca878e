//! Verification: test of previously identified parameters on a few observations.

use crate::stages::kinds::Observed;
use crate::stages::observe::repeats::stale;
use crate::stages::remedies::remedied;
use crate::stages::uncertainty::bounds::significant;
use crate::stages::verify::earlier_parameters::{
    PoseErrors, other_nominal, parameters_from_document, worse_than_nominal,
};
use crate::stages::verify::expected_deviation::ExpectedDeviation;
use etalon_base::catalogue::Phrase;
use etalon_base::message::{Message, Result};
use etalon_base::pose::{Vector, minus, norm};
use etalon_base::pose_name::PoseName;
use etalon_base::{error, phrase, warning};
use etalon_documents::*;
use etalon_identify::{
    Comparison, Detectable, EXPLAINED, Explanation, Extent, IdentifiedParameters, Misfit, Moved, NAMING, Observation,
    POWER, SIGNIFICANCE, Settings, UncertaintyBound, Variance, Verification, set_up_contradicted, set_up_far,
};
use etalon_robots::{Parameter, Quantity, Robot, Role};
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

/// A calibration under test: the robot, its identified parameters, and the uncertainty of predicted
/// coordinates.
pub struct EarlierCalibration<'r> {
    robot: &'r mut dyn Robot,
    parameters: IdentifiedParameters,
    noise: ExpectedDeviation,
    /// Nominal parameters, with the base and targets that were fitted to them.
    nominal: Vec<f64>,
    /// Given bound of the smallest changes that chosen poses have to detect.
    bound: UncertaintyBound,
    messages: Vec<Message>,
}

impl<'r> EarlierCalibration<'r> {
    /// The calibration in a document. `stated_mm` is the standard uncertainty of a coordinate if it
    /// is not the one of the calibration.
    ///
    /// # Errors
    /// Fails if the document is of another robot, or if the residuals of the calibration yield no
    /// standard deviation.
    pub fn new(robot: &'r mut dyn Robot, document: &ParametersDocument, stated_mm: Option<f64>) -> Result<Self> {
        let parameters = parameters_from_document(robot, document)?;
        let noise = ExpectedDeviation::from_document(robot, document, stated_mm)?;
        let messages = other_nominal(robot, document).into_iter().collect();
        let entry = |p: &Parameter| document.parameters.iter().find(|entry| entry.name == p.name);
        let before = |(i, p): (usize, &Parameter)| match (entry(p), p.role) {
            (Some(entry), Role::Robot) => p.quantity.inward(entry.nominal),
            (Some(entry), _) => p.quantity.inward(entry.before),
            (None, _) => parameters.values[i],
        };
        let nominal = robot.parameters().iter().enumerate().map(before).collect();
        Ok(Self { robot, parameters, noise, nominal, bound: UncertaintyBound::default(), messages })
    }

    /// Returns the calibration with a bound of the smallest changes that chosen poses have to
    /// detect.
    #[must_use]
    pub fn with_bound(self, bound: UncertaintyBound) -> Self {
        Self { bound, ..self }
    }
}

/// Verdict of a test for changes.
fn verdict(found: &Verification) -> VerificationVerdict {
    match found.cause().map(|cause| cause.moved) {
        _ if !found.is_changed() => VerificationVerdict::Valid,
        Some(Moved::Base) => VerificationVerdict::BaseMoved,
        Some(Moved::Joint(_)) => VerificationVerdict::Joint,
        Some(Moved::Target(_)) | None => VerificationVerdict::Other,
    }
}

/// Returns the meaning, as uncertain if a change is significant at a low level alone.
fn doubted(found: &Verification, meaning: Phrase) -> Phrase {
    let percent = 100.0 * found.p_value;
    let is_doubtful = found.is_changed() && found.p_value > DOUBTFUL;
    if is_doubtful { phrase!("perhaps-changed", percent, meaning) } else { meaning }
}

/// Compares observations with the parameters of a calibration; `inputs` are the files and their
/// SHA-256.
pub fn verify(
    calibration: EarlierCalibration,
    observed: Observed,
    inputs: BTreeMap<String, String>,
) -> Result<VerificationDocument> {
    let EarlierCalibration { robot, parameters, noise, nominal, mut messages, .. } = calibration;
    let poses = observed.poses();
    let Observed { observations, settings } = observed;
    if poses.is_empty() {
        return Err(error!("verify-without-observations").into());
    }
    messages.extend(stale(robot, &observations));
    let positions = Settings { standard_uncertainty_mm: Some(noise.total_mm()), ..settings.clone() };
    let conditions = noise.conditions(robot, &parameters.values, &settings.conditions);
    let (misfit, settings) = (noise.misfit(&settings.conditions), noise.applied(settings));
    let comparison = Comparison {
        robot: &*robot,
        observations: &observations,
        settings: &settings,
        given: &parameters,
        misfit: &misfit,
    };
    let tested = comparison.verify(noise.variance).map_err(remedied);
    let is_unexplained = tested.as_ref().is_ok_and(|found| found.is_changed() && found.cause().is_none());
    let valid = |is_left_out: &dyn Fn(PoseName, usize) -> bool| {
        p_value_without(comparison, noise.variance, is_left_out).is_some_and(|p| p >= SIGNIFICANCE)
    };
    let deviating = if is_unexplained { wrong_pose(&poses, valid) } else { None };
    messages.extend(deviating.map(|pose| wrong_reading(comparison, pose, valid)));
    // what the calibrated robot cannot be is a wrong set-up, wherever its base is; values of joints
    // refer to the nominal robot, and are compared before
    robot.definition_mut().set_nominal(&parameters.values);
    let robot: &dyn Robot = robot;
    if let Some(problem) = set_up_far(robot, &observations, &positions) {
        return Err(warning_message(&problem).into());
    }
    let found = tested?;
    if is_unexplained {
        if let Some(exchanged) = exchanged_targets(robot, &parameters.values, &observations, &found) {
            return Err(exchanged.into());
        }
        if deviating.is_none() {
            messages.extend(set_up_contradicted(robot, &observations, &positions).map(|w| warning_message(&w)));
        }
    }
    let alike = alike(&found, robot);
    messages.extend(alike_message(&alike));
    if !found.is_changed() {
        let (errors, readings) = by_pose(robot, &observations, [&nominal, &parameters.values]);
        messages.extend(worse_than_nominal(&errors, readings));
    }
    let (verdict, of_position) = (verdict(&found), (robot.dimension() as f64).sqrt());
    let meaning = match deviating {
        Some(pose) => phrase!("one-pose-deviates", pose),
        None => meaning(robot, &found, verdict),
    };
    Ok(VerificationDocument {
        schema: "etalon/verification/1".to_owned(),
        robot: robot.model().to_owned(),
        calibration: None,
        meaning: doubted(&found, meaning).into(),
        verdict,
        evidence: evidence(robot, &found, alike),
        residuals: VerifiedResiduals {
            poses: poses.len(),
            points: observations.iter().map(|o| o.targets.iter().flatten().count()).sum(),
            copies: 0,
            rms_mm: found.rms_mm,
            expected_rms_mm: found.expected_rms_mm,
            position_rms_mm: of_position * found.rms_mm,
            expected_position_rms_mm: of_position * found.expected_rms_mm,
            conditions,
            standard_uncertainty_mm: noise.measured_mm,
            model_mm: noise.model_mm,
        },
        messages,
        provenance: Provenance { version: env!("CARGO_PKG_VERSION").to_owned(), inputs, seed: None },
    })
}

/// Test for changes as its document has it; `alike` are the names of motions that explain as much
/// as the cause.
fn evidence(robot: &dyn Robot, found: &Verification, alike: Vec<String>) -> ChangeEvidence {
    let whole = found.of_changes.sum + found.of_rest.sum;
    let movement = |e: &Explanation| movement(robot, e, whole);
    ChangeEvidence {
        p_value: found.p_value,
        significance: SIGNIFICANCE,
        moved: found.cause().map(movement),
        alike,
        explanations: found.explanations.iter().map(movement).collect(),
        power: DetectionPower {
            probability: POWER,
            naming: NAMING,
            least: found.detectable.iter().flat_map(|d| least(robot, d)).collect(),
        },
        of_changes: sum_of_squares(&found.of_changes),
        of_rest: sum_of_squares(&found.of_rest),
    }
}

/// P value of a comparison without the readings of some poses and targets; `None` if the others
/// cannot be compared.
fn p_value_without(all: Comparison, variance: Variance, is_left_out: &dyn Fn(PoseName, usize) -> bool) -> Option<f64> {
    let mut observations = all.observations.to_vec();
    for o in &mut observations {
        let pose = o.pose;
        let left_out = o.targets.iter_mut().enumerate().filter(|(target, _)| is_left_out(pose, *target));
        left_out.for_each(|(_, at)| *at = None);
    }
    observations.retain(|o| o.targets.iter().any(Option::is_some));
    let kept = all.settings.conditions.iter().zip(&all.misfit.conditions);
    let kept = kept.filter(|(c, _)| !is_left_out(c.pose, c.target));
    let (conditions, sizes) = kept.map(|(c, size)| (c.clone(), *size)).unzip();
    let settings = Settings { conditions, ..all.settings.clone() };
    let misfit = Misfit { conditions: sizes, ..all.misfit.clone() };
    let kept = Comparison { observations: &observations, settings: &settings, misfit: &misfit, ..all };
    kept.p_value(variance).ok()
}

/// Squared position errors by pose with nominal and with given parameters, and their number.
fn by_pose(robot: &dyn Robot, observations: &[Observation], values: [&Vec<f64>; 2]) -> (PoseErrors, usize) {
    let (mut all, mut readings) = (PoseErrors::new(), 0);
    for o in observations {
        for (k, at) in o.targets.iter().enumerate().filter_map(|(k, at)| Some((k, (*at)?))) {
            let squares = values.map(|values| norm(minus(at, robot.position(values, &o.joints, k))).powi(2));
            let of_pose = all.entry(o.pose).or_default();
            (0..2).for_each(|i| of_pose[i] += squares[i]);
            readings += 1;
        }
    }
    (all, readings)
}

/// Chooses `count` of the candidate poses for a calibration and its uncertainty: one by one, the
/// pose with the smallest product of two changes: the smallest detectable one, and the smallest one
/// that is attributed to a joint. Then each pose is swapped for a better one (Fedorov 1972).
pub fn plan(
    calibration: EarlierCalibration,
    mut candidates: Vec<Observation>,
    count: usize,
    inputs: BTreeMap<String, String>,
    progress: &mut dyn FnMut(usize, usize),
) -> Result<VerificationPlanDocument> {
    let EarlierCalibration { robot, parameters, noise, bound, mut messages, .. } = calibration;
    let robot: &dyn Robot = robot;
    for o in &mut candidates {
        let at = |k: usize| robot.position(&parameters.values, &o.joints, k);
        o.targets = o.targets.iter().enumerate().map(|(k, seen)| seen.map(|_| at(k))).collect();
    }
    let (misfit, settings) = (noise.misfit(&[]), noise.applied(Settings::default()));
    let poses: Vec<PoseName> = candidates.iter().map(|o| o.pose).collect::<BTreeSet<_>>().into_iter().collect();
    if !(1..=poses.len()).contains(&count) {
        return Err(error!("candidate-poses-too-few", wanted = count, count = poses.len()).into());
    }
    let detectable = |chosen: &[PoseName]| {
        let of_pose = |pose: &PoseName| candidates.iter().filter(move |o| o.pose == *pose).cloned().collect::<Vec<_>>();
        let observations: Vec<Observation> = chosen.iter().flat_map(of_pose).collect();
        let observed =
            Comparison { robot, observations: &observations, settings: &settings, given: &parameters, misfit: &misfit };
        observed.detectable(noise.variance)
    };
    // sum of logarithms; an invisible change counts as the largest
    let score = |chosen: &[PoseName]| {
        let all = |d: &Detectable| d.change.iter().copied().chain(d.named).collect::<Vec<f64>>();
        let found = detectable(chosen).ok()?;
        Some(found.iter().flat_map(all).map(|change| change.min(UNSEEN).ln()).sum::<f64>())
    };
    let best = |others: &[PoseName]| {
        let of = |pose: &PoseName| Some((score(&[others, &[*pose]].concat())?, *pose));
        let all: Vec<(f64, PoseName)> = poses.par_iter().filter(|pose| !others.contains(pose)).filter_map(of).collect();
        all.into_iter().min_by(|a, b| a.0.total_cmp(&b.0))
    };
    let mut chosen: Vec<PoseName> = Vec::new();
    for k in 0..2 * count {
        // the first round adds, the second swaps
        let others: Vec<PoseName> =
            chosen.iter().enumerate().filter(|(i, _)| k < count || *i != k - count).map(|(_, p)| *p).collect();
        let Some((_, pose)) = best(&others) else { break };
        match k < count {
            true => chosen.push(pose),
            false => chosen[k - count] = pose,
        }
        progress(k + 1, 2 * count);
    }
    if let (Ok(by_chosen), Ok(by_all)) = (detectable(&chosen), detectable(&poses)) {
        let points: Vec<Vector> = candidates.iter().flat_map(|o| o.targets.iter().flatten().copied()).collect();
        let extent = Extent::from_points(&points, noise.total_mm());
        messages.extend(undetected(robot, bound, &extent, [&by_chosen, &by_all]));
    }
    let step = |k: usize| {
        let least = detectable(&chosen[..=k]).map_err(remedied)?.iter().flat_map(|d| least(robot, d)).collect();
        Ok(VerificationStep { pose: chosen[k], least })
    };
    Ok(VerificationPlanDocument {
        schema: "etalon/verification-plan/1".to_owned(),
        robot: robot.model().to_owned(),
        probability: POWER,
        naming: NAMING,
        steps: (0..chosen.len()).map(step).collect::<Result<_>>()?,
        standard_uncertainty_mm: noise.measured_mm,
        model_mm: noise.model_mm,
        messages,
        provenance: Provenance { version: env!("CARGO_PKG_VERSION").to_owned(), inputs, seed: None },
    })
}

/// Error about the changes beyond their bound that the chosen poses do not detect. Changes that no
/// candidate shows are omitted: the targets do not move with them.
fn undetected(
    robot: &dyn Robot,
    bound: UncertaintyBound,
    extent: &Extent,
    [by_chosen, by_all]: [&[Detectable]; 2],
) -> Option<Message> {
    let shown =
        |d: &Detectable| by_all.iter().any(|all| all.moved == d.moved && all.change.iter().all(|v| v.is_finite()));
    let judged = by_chosen.iter().filter(|d| d.moved == Moved::Base || shown(d));
    let limit = |quantity: Quantity| bound.bound(quantity, extent).0;
    let beyond = judged.flat_map(|d| {
        let quantities = match d.moved {
            Moved::Base => {
                vec![("base shift".to_owned(), Quantity::Length), ("base rotation".to_owned(), Quantity::Angle)]
            }
            moved => components(robot, moved),
        };
        quantities.into_iter().zip(d.change.clone()).filter(|((_, quantity), change)| *change > limit(*quantity))
    });
    let text = |((name, quantity), change): ((String, Quantity), f64)| {
        let [change, bound] = [change, limit(quantity)].map(|v| significant(quantity.outward(v)));
        phrase!("change-beyond-bound", name, change, bound, unit = quantity.unit())
    };
    let all: Vec<Phrase> = beyond.map(text).collect();
    (!all.is_empty()).then(|| error!("changes-undetected", count = all.len(), changes = all))
}

/// Assumed size (mm or rad) of a change that the chosen poses do not detect.
const UNSEEN: f64 = 1e3;

/// Maximum number of targets whose names are permuted; of more, two are swapped.
const PERMUTED: usize = 5;

/// Returns an error if the targets fit the parameters with other names.
fn exchanged_targets(
    robot: &dyn Robot,
    values: &[f64],
    observations: &[Observation],
    found: &Verification,
) -> Option<Message> {
    let rms = |order: &[usize]| {
        let miss = |o: &Observation| {
            let seen = o.targets.iter().enumerate().filter_map(|(k, at)| Some((order[k], (*at)?)));
            seen.map(|(k, at)| norm(minus(at, robot.position(values, &o.joints, k))).powi(2)).collect::<Vec<_>>()
        };
        let all: Vec<f64> = observations.iter().flat_map(miss).collect();
        (all.iter().sum::<f64>() / (robot.dimension() * all.len()) as f64).sqrt()
    };
    if observations.is_empty() {
        return None;
    }
    let best = orders(robot.targets().len()).into_iter().map(|order| (rms(&order), order));
    let (left_mm, order) = best.min_by(|x, y| x.0.total_cmp(&y.0))?;
    let [before_mm, left_mm] = [found.rms_mm, left_mm].map(|mm| (robot.dimension() as f64).sqrt() * mm);
    if left_mm >= 0.1 * before_mm {
        return None;
    }
    let names = robot.targets();
    let changed: Vec<usize> = (0..order.len()).filter(|k| order[*k] != *k).collect();
    Some(match changed[..] {
        [a, b] => error!("target-names-exchanged", first = names[a], second = names[b], before_mm, left_mm),
        _ => {
            let names: Vec<String> = changed.iter().map(|k| format!("{} → {}", names[*k], names[order[*k]])).collect();
            error!("target-names-permuted", names, before_mm, left_mm)
        }
    })
}

/// Other orders of some targets: all orders of a few targets, otherwise orders with two targets
/// swapped.
fn orders(count: usize) -> Vec<Vec<usize>> {
    let usual: Vec<usize> = (0..count).collect();
    if count > PERMUTED {
        let pairs = (0..count).flat_map(|a| (a + 1..count).map(move |b| (a, b)));
        let exchanged = |(a, b)| {
            let mut order = usual.clone();
            order.swap(a, b);
            order
        };
        return pairs.map(exchanged).collect();
    }
    let mut all: Vec<Vec<usize>> = vec![Vec::new()];
    for _ in 0..count {
        let longer = |order: Vec<usize>| {
            let next = (0..count).filter(|k| !order.contains(k)).collect::<Vec<_>>();
            next.into_iter().map(move |k| [&order[..], &[k]].concat()).collect::<Vec<_>>()
        };
        all = all.into_iter().flat_map(longer).collect();
    }
    all.retain(|order| *order != usual);
    all
}

/// Maximum number of poses that are excluded in turn.
const MOST_POSES: usize = 100;

/// The only pose without which the parameters are valid.
fn wrong_pose(
    poses: &BTreeSet<PoseName>,
    valid: impl Fn(&dyn Fn(PoseName, usize) -> bool) -> bool,
) -> Option<PoseName> {
    if !(3..=MOST_POSES).contains(&poses.len()) {
        return None;
    }
    let all: Vec<&PoseName> = poses.iter().filter(|wrong| valid(&|pose, _| pose == **wrong)).collect();
    if let [pose] = all[..] { Some(*pose) } else { None }
}

/// Warning about the only reading of a pose without which the parameters are valid, or about the
/// pose.
fn wrong_reading(all: Comparison, pose: PoseName, valid: impl Fn(&dyn Fn(PoseName, usize) -> bool) -> bool) -> Message {
    let Comparison { robot, observations, settings, .. } = all;
    let at_pose = settings.conditions.iter().filter(|c| c.pose == pose);
    let mut targets: BTreeSet<usize> = at_pose.map(|c| c.target).collect();
    let measured = |o: &Observation, target: usize| o.pose == pose && o.targets[target].is_some();
    targets.extend((0..robot.targets().len()).filter(|target| observations.iter().any(|o| measured(o, *target))));
    let without = |target: &&usize| valid(&|of, reading| of == pose && reading == **target);
    let wrong: Vec<&usize> = targets.iter().filter(without).collect();
    match wrong[..] {
        [target] if targets.len() > 1 => warning!("one-reading-contradicts", target = robot.targets()[*target], pose),
        _ => warning!("one-pose-contradicts", pose),
    }
}

fn sum_of_squares(test: &etalon_identify::Test) -> SumOfSquares {
    SumOfSquares { value: test.sum, degrees_of_freedom: test.degrees_of_freedom, p_value: test.p_value }
}

/// Names and quantities of the values of a motion.
fn components(robot: &dyn Robot, moved: Moved) -> Vec<(String, Quantity)> {
    let of = |names: &[&str], quantity| names.iter().map(|n| ((*n).to_owned(), quantity)).collect::<Vec<_>>();
    match moved {
        Moved::Base if robot.dimension() == 2 => {
            [of(&["x", "y"], Quantity::Length), of(&["rz"], Quantity::Angle)].concat()
        }
        Moved::Base => [of(&["x", "y", "z"], Quantity::Length), of(&["rx", "ry", "rz"], Quantity::Angle)].concat(),
        Moved::Joint(j) => vec![(robot.joints()[j].name.clone(), robot.joints()[j].quantity)],
        Moved::Target(_) => of(&["x", "y", "z"], Quantity::Length),
    }
}

/// Probability of the residuals of an unchanged robot above which a rejection calls for another
/// measurement.
const DOUBTFUL: f64 = 0.01;
/// Difference of the explained sums of squares that decides between two motions: a ratio of
/// likelihoods of 20.
const DECISIVE: f64 = 6.0;

/// Minimum share of the excess of squares at which a motion that does not explain everything is
/// named.
const DOMINANT: f64 = 0.5;

/// The significant motion that explains most of the deviation beyond the parameters and their
/// uncertainty, with its share; `None` if no motion explains half of it.
fn dominant(found: &Verification) -> Option<(&Explanation, f64)> {
    let (changes, rest) = (&found.of_changes, &found.of_rest);
    let excess = changes.sum + rest.sum - (changes.degrees_of_freedom + rest.degrees_of_freedom) as f64;
    let share = |e: &Explanation| (e.explained - e.change.len() as f64) / excess;
    let significant = found.explanations.iter().filter(|e| e.is_significant());
    let best = significant.max_by(|a, b| share(a).total_cmp(&share(b)))?;
    (excess > 0.0 && share(best) >= DOMINANT).then(|| (best, share(best).min(1.0)))
}

fn movement(robot: &dyn Robot, found: &Explanation, whole: f64) -> Movement {
    let numbers = found.change.iter().zip(&found.standard_uncertainty);
    let by =
        components(robot, found.moved).into_iter().zip(numbers).map(|((name, quantity), (value, u))| MovementValue {
            name,
            unit: quantity.unit().to_owned(),
            value: quantity.outward(*value),
            standard_uncertainty: Some(quantity.outward(*u)).filter(|u| u.is_finite()),
        });
    let (kind, name) = match found.moved {
        Moved::Base => (MovementKind::Base, "base".to_owned()),
        Moved::Joint(j) => (MovementKind::Joint, robot.joints()[j].name.clone()),
        Moved::Target(k) => (MovementKind::Target, robot.targets()[k].clone()),
    };
    let explained_share = if whole > 0.0 { (found.explained / whole).clamp(0.0, 1.0) } else { 0.0 };
    Movement { name, kind, by: by.collect(), p_left: found.p_left, explained_share }
}

fn least(robot: &dyn Robot, detectable: &Detectable) -> Vec<LeastDetectable> {
    let names = match detectable.moved {
        Moved::Base => vec![("base shift".to_owned(), Quantity::Length), ("base rotation".to_owned(), Quantity::Angle)],
        moved => components(robot, moved),
    };
    let of = |((name, quantity), value): ((String, Quantity), &f64)| LeastDetectable {
        name,
        unit: quantity.unit().to_owned(),
        value: Some(quantity.outward(*value)).filter(|v| v.is_finite()),
        named: detectable.named.map(|v| quantity.outward(v)).filter(|v| v.is_finite()),
    };
    names.into_iter().zip(&detectable.change).map(of).collect()
}

/// Answer in words.
fn meaning(robot: &dyn Robot, found: &Verification, verdict: VerificationVerdict) -> Phrase {
    let moved = found.cause().map(|cause| movement(robot, cause, 0.0));
    let numbers = |m: &Movement| m.by.iter().map(number).collect::<Vec<_>>().join(", ");
    let by = moved.as_ref().map(numbers).unwrap_or_default();
    let name = moved.as_ref().map(|m| m.name.as_str()).unwrap_or_default();
    match (verdict, &moved) {
        (VerificationVerdict::Valid, _) => phrase!("parameters-still-valid"),
        (VerificationVerdict::BaseMoved, _) => phrase!("base-moved", by),
        (VerificationVerdict::Joint, _) => {
            phrase!("joint-zero-moved", joint = name, by = by.trim_start_matches(name).trim_start())
        }
        (VerificationVerdict::Other, Some(_)) => phrase!("target-moved", target = name, by),
        (VerificationVerdict::Other, None) => match dominant(found) {
            Some((e, share)) => {
                let m = movement(robot, e, 0.0);
                partly_explained(&m, numbers(&m), share)
            }
            None if found.of_changes.p_value >= SIGNIFICANCE => {
                phrase!("readings-scatter-more", ratio = found.of_rest.mean_square().sqrt())
            }
            None => phrase!("parameters-no-longer-valid"),
        },
    }
}

/// Statement about a motion that explains most of a deviation, with its share.
fn partly_explained(m: &Movement, by: String, share: f64) -> Phrase {
    let percent = (100.0 * share).round();
    match m.kind {
        MovementKind::Base => phrase!("base-motion-explains-most", by, percent),
        MovementKind::Joint => phrase!("joint-motion-explains-most", joint = m.name, by, percent),
        MovementKind::Target => phrase!("target-motion-explains-most", target = m.name, by, percent),
    }
}

/// A number with its expanded uncertainty.
fn number(v: &MovementValue) -> String {
    let digits = v.standard_uncertainty.map_or(3, |u| (1.0 - (2.0 * u).log10().floor()).clamp(0.0, 6.0) as usize);
    let u = v.standard_uncertainty.map(|u| format!(" ± {:.digits$}", 2.0 * u)).unwrap_or_default();
    format!("{} {:+.digits$}{u} {}", v.name, v.value, v.unit)
}

/// Names of the other motions that explain the residuals about as well as the cause.
fn alike(found: &Verification, robot: &dyn Robot) -> Vec<String> {
    let Some(cause) = found.cause() else { return Vec::new() };
    let is_near = |e: &Explanation| e.p_left > EXPLAINED && cause.explained - e.explained < DECISIVE;
    let as_well = |e: &&Explanation| *e != cause && (e.suffices() || is_near(e));
    found.explanations.iter().filter(as_well).map(|e| movement(robot, e, 0.0).name).collect()
}

/// Warning that motions explain the residuals as well as the cause.
fn alike_message(motions: &[String]) -> Option<Message> {
    (!motions.is_empty()).then(|| warning!("motions-alike", count = motions.len(), motions))
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_identify::Test;
    use etalon_robots::Prexyt;

    /// Chi-square of a zero of one joint, and of two others: one explains nearly as much, the other
    /// clearly less.
    #[test]
    fn motions_that_explain_nearly_as_much_are_named() {
        let robot = Prexyt::default();
        let explains = |joint: usize, explained: f64, p_change: f64| Explanation {
            moved: Moved::Joint(joint),
            change: vec![0.01],
            standard_uncertainty: vec![0.003],
            p_left: 0.2,
            explained,
            p_change,
        };
        let all = Test { sum: 12.0, degrees_of_freedom: 3, p_value: 0.02 };
        let found = Verification {
            of_changes: all,
            of_rest: all,
            p_value: 0.02,
            rms_mm: 0.01,
            expected_rms_mm: 0.008,
            explanations: vec![explains(0, 12.0, 0.01), explains(1, 9.0, 0.08), explains(2, 2.0, 0.9)],
            detectable: Vec::new(),
        };
        let message = alike_message(&alike(&found, &robot)).expect("alike");
        let names = [robot.joints()[1].name.as_str()];
        assert!(message.is("motions-alike", &[("count", &1), ("motions", &names)]), "{message:?}");
    }
}
