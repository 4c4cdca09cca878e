//! Cross-validation of effects: the calibration poses are cut into folds, each predicted from the
//! others (Stone 1974). The remaining effect that predicts them best is added, while its gain
//! exceeds its standard uncertainty and the F test of nested models does not reject it. All errors
//! are sizes of position errors: each pose counts once, by their mean square.

use crate::stages::calibrate::validation_targets::ValidationTargets;
use crate::stages::evaluate::accuracy::summarise;
use crate::stages::evaluate::errors::PointErrors;
use crate::stages::evaluate::sets::Sets;
use crate::stages::judge::circumstances::temperature;
use crate::stages::remedies::remedied;
use etalon_base::error;
use etalon_base::message::{Problems, Result};
use etalon_base::noise::Noise;
use etalon_base::pattern::matches_pattern;
use etalon_base::pose::norm;
use etalon_base::pose_name::PoseName;
use etalon_documents::{EffectProof, EffectStep, LeftOutErrors, ParameterEntry, Statistics};
use etalon_identify::{
    Condition, Effects, Fitted, Identification, NestedFit, Observation, Settings, Status, Variance, effects,
};
use etalon_math::statistics::{mean, variance};
use etalon_robots::{Effect, Robot};
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

/// Minimum number of parts into which poses are divided; all poses, if they are fewer.
const FOLDS: usize = 5;
/// Minimum number of poses to divide.
const FEWEST: usize = 3;
/// Maximum number of poses times parts, if the parts are more than [`FOLDS`].
const FITTED_POSES: usize = 240;

/// Returns the number of parts for this number of poses. Few poses hardly exceed the parameters:
/// without a fifth of them, a fit says nothing about a fit to all of them, and the parts are
/// smaller, down to one pose.
fn parts(poses: usize) -> usize {
    (FITTED_POSES / poses.max(1)).clamp(FOLDS.min(poses), poses)
}

/// Returns the number of divisions for this number of poses: one if the poses or the parts are
/// many, at most three.
fn repeats(poses: usize) -> usize {
    let parts = parts(poses);
    if parts > FOLDS || parts == poses { 1 } else { (300 / poses).clamp(1, 3) }
}

/// Seed of the division.
const SEED: u64 = 4;
/// Significance level of a parameter's change, corrected for the number of parameters, and of an
/// effect.
pub(crate) const SIGNIFICANCE: f64 = 0.05;
/// Minimum gain of an effect that is advised, in standard uncertainties: of ten effects without a
/// gain, one exceeds a single standard uncertainty by chance.
const ADVISED: f64 = 2.0;
/// Maximum number of poses on which effects that are not identified are tried.
const TRIED_POSES: usize = 200;

/// Cross-validation of effects on the poses of a set.
pub(crate) struct Study<'a> {
    pub robot: &'a dyn Robot,
    /// Readings of the calibration.
    pub sets: &'a Sets,
    settings: Settings,
    /// Effect of each parameter; `None` for base and targets.
    pub effects: Vec<Option<Effect>>,
    /// Base and targets alone, fitted to all poses.
    pub before: Vec<f64>,
    /// Poses that are excluded together.
    pub folds: Vec<BTreeSet<PoseName>>,
    /// Poses of neighbouring temperatures; empty if readings state none.
    blocks: Vec<BTreeSet<PoseName>>,
    pub poses: usize,
}

/// Squared position errors of poses: mean of each, mm².
pub(crate) type Squares = BTreeMap<PoseName, f64>;

/// Errors with a choice of parameters.
pub(crate) struct Tried {
    /// Fit to all poses.
    fit: ModelFit,
    /// Number of identified parameters.
    identified: usize,
    /// At held-out poses.
    left_out: Squares,
    /// At held-out poses of neighbouring temperatures.
    by_block: Squares,
    /// At all poses, from which the parameters were identified.
    fitted: Squares,
}

impl<'a> Study<'a> {
    /// Study of the calibration readings of `sets`; `settings` have their conditions.
    ///
    /// # Errors
    /// Fails with too few poses, with readings that have no length, or if the fit of base and
    /// targets fails.
    pub fn new(robot: &'a dyn Robot, sets: &'a Sets, settings: Settings) -> Result<Self> {
        let names = poses(&sets.calibration, &settings.conditions);
        if names.len() < FEWEST {
            return Err(error!("few-poses-to-leave-out", count = names.len(), least = FEWEST).into());
        }
        // the study decides which effects are identified
        let settings = Settings { effects: Effects::All, ..settings };
        let before = etalon_identify::fit_frames(robot, &sets.calibration, &settings).map_err(remedied)?;
        let effects = effects(robot, joints(&sets.calibration, &settings.conditions));
        let (poses, folds) = (names.len(), folds(names));
        let blocks = temperature_blocks(robot, &sets.calibration, &settings.conditions);
        let study = Self { robot, sets, effects, before, folds, blocks, poses, settings };
        if study.squares_at(&sets.calibration, &study.settings.conditions, &study.before).is_empty() {
            return Err(error!("nothing-to-judge").into());
        }
        Ok(study)
    }

    /// Folds of the first division, in which every pose is omitted once.
    pub fn first_cut(&self) -> &[BTreeSet<PoseName>] {
        &self.folds[..self.folds.len() / repeats(self.poses)]
    }

    /// Names of the parameters of the robot itself that are not `identified`.
    pub fn held(&self, identified: impl Fn(usize) -> bool) -> Vec<String> {
        let held = self.effects.iter().enumerate().filter(|(i, effect)| effect.is_some() && !identified(*i));
        held.map(|(i, _)| self.robot.parameters()[i].name.clone()).collect()
    }

    /// Returns the settings with these parameters also held.
    pub fn holding(&self, names: Vec<String>) -> Settings {
        with_held(&self.settings, names)
    }

    /// Returns the settings that identify these effects, and base and targets.
    pub fn settings_with_effects(&self, chosen: &[Effect]) -> Settings {
        self.holding(self.held(|i| self.effects[i].is_some_and(|effect| chosen.contains(&effect))))
    }

    /// Identifies from all poses, starting from base and targets.
    pub fn identify(&self, settings: &Settings) -> Result<Identification> {
        self.identify_from(&self.sets.calibration, settings)
    }

    /// Identifies from all poses except these.
    pub fn without(&self, fold: &BTreeSet<PoseName>, settings: &Settings) -> Result<Identification> {
        let (sets, settings) = split(self.robot, self.sets, settings, fold);
        self.identify_from(&sets.calibration, &settings)
    }

    fn identify_from(&self, observations: &[Observation], settings: &Settings) -> Result<Identification> {
        etalon_identify::identify_from(self.robot, observations, settings, &self.before).map_err(remedied)
    }

    /// Tries a choice of parameters. A trial needs no uncertainties.
    pub fn tried(&self, settings: &Settings) -> Result<Tried> {
        let observations = &self.sets.calibration;
        let (found, residuals) =
            NestedFit::with_residuals(self.robot, observations, settings, &self.before).map_err(remedied)?;
        // the parameters of a fold are near the parameters of all poses
        let values = |observations: &[Observation], settings: &Settings| -> Result<Vec<f64>> {
            match found.again(self.robot, observations, settings) {
                Some(values) => Ok(values),
                None => {
                    Ok(Fitted::from_start(self.robot, observations, settings, &self.before).map_err(remedied)?.values)
                }
            }
        };
        let squares = |folds: &[BTreeSet<PoseName>]| left_out_squares(self.robot, self.sets, settings, folds, values);
        let (left_out, by_block) = (squares(&self.folds)?, squares(&self.blocks)?);
        let fitted = self.squares_at(observations, &self.settings.conditions, &found.values);
        let degrees_of_freedom = residuals.degrees_of_freedom as f64;
        let equations = degrees_of_freedom + found.determined;
        let squares = residuals.chi_square.unwrap_or(residuals.rms.powi(2) * equations);
        let fit = ModelFit { squares, degrees_of_freedom, parameters: found.determined };
        Ok(Tried { fit, identified: found.count(), left_out, by_block, fitted })
    }

    fn squares_at(&self, observations: &[Observation], conditions: &[Condition], values: &[f64]) -> Squares {
        squares_at(self.robot, observations, conditions, values)
    }

    /// Adds effects one by one, the best of the remaining ones first, while errors at held-out
    /// poses decrease.
    pub fn steps(&self, none: &Tried, one_more: &mut dyn FnMut()) -> Result<(Vec<EffectStep>, Vec<Effect>)> {
        let mut steps = vec![none.step(None, None, true)];
        let mut chosen: Vec<Effect> = Vec::new();
        let mut last: Option<Tried> = None;
        loop {
            let before = last.as_ref().unwrap_or(none);
            let mut left: Vec<Effect> = Effect::ALL.to_vec();
            left.retain(|effect| !chosen.contains(effect) && self.effects.contains(&Some(*effect)));
            // an effect that these poses do not suffice to identify is not tried
            let try_one = |effect: &Effect| {
                let settings = self.settings_with_effects(&[&chosen[..], &[*effect]].concat());
                Some((*effect, self.tried(&settings).ok()?))
            };
            let mut tried: Vec<(Effect, Tried)> = left.par_iter().filter_map(try_one).collect();
            left.iter().for_each(|_| one_more());
            // effects of the temperature that other temperatures do not confirm come last
            let unconfirmed = |(effect, of): &(Effect, Tried)| effect.is_thermal() && !of.holds_by_block(before);
            let order = |of: &(Effect, Tried)| (unconfirmed(of), of.1.mean_square());
            tried.sort_by(|a, b| {
                let (a, b) = (order(a), order(b));
                a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
            });
            let accepted = tried.first().is_some_and(|best| !unconfirmed(best) && best.1.improves(before));
            for (i, (effect, found)) in tried.iter().enumerate().filter(|(i, _)| !accepted || *i == 0) {
                steps.push(found.step(Some(*effect), Some(before), accepted && i == 0));
            }
            if !accepted {
                return Ok((steps, chosen));
            }
            let (effect, best) = tried.swap_remove(0);
            chosen.push(effect);
            last = Some(best);
        }
    }
}

/// Returns the settings with these parameters also held.
fn with_held(settings: &Settings, names: Vec<String>) -> Settings {
    let mut settings = settings.clone();
    settings.hold.extend(names);
    settings
}

/// The poses of readings, in order.
fn poses(observations: &[Observation], conditions: &[Condition]) -> Vec<PoseName> {
    let all = observations.iter().map(|o| o.pose).chain(conditions.iter().map(|c| c.pose));
    all.collect::<BTreeSet<_>>().into_iter().collect()
}

/// Joint values of readings.
fn joints<'r>(observations: &'r [Observation], conditions: &'r [Condition]) -> impl Iterator<Item = &'r [f64]> {
    observations.iter().map(|o| o.joints.as_slice()).chain(conditions.iter().map(|c| c.joints.as_slice()))
}

/// The poses in random parts, for each division.
fn folds(mut names: Vec<PoseName>) -> Vec<BTreeSet<PoseName>> {
    let (parts, mut folds) = (parts(names.len()), Vec::new());
    for repeat in 0..repeats(names.len()) {
        Noise::new(SEED, repeat as u64).shuffle(&mut names);
        folds.extend((0..parts).map(|part| names.iter().copied().skip(part).step_by(parts).collect()));
    }
    folds
}

/// The poses in parts of neighbouring temperatures, so that a drift in time is judged at other
/// temperatures than in the identification; empty if readings have no temperature.
fn temperature_blocks(
    robot: &dyn Robot,
    observations: &[Observation],
    conditions: &[Condition],
) -> Vec<BTreeSet<PoseName>> {
    let readings = observations.iter().map(|o| (o.pose, &o.joints));
    let readings = readings.chain(conditions.iter().map(|c| (c.pose, &c.joints)));
    let mut by_pose: BTreeMap<PoseName, Vec<f64>> = BTreeMap::new();
    for (pose, joints) in readings {
        if let Some(temperature_c) = temperature(robot, joints) {
            by_pose.entry(pose).or_default().push(temperature_c);
        }
    }
    let mut poses: Vec<(f64, PoseName)> = by_pose.into_iter().map(|(pose, all)| (mean(all), pose)).collect();
    poses.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    poses.chunks(poses.len().div_ceil(FOLDS).max(1)).map(|part| part.iter().map(|(_, pose)| *pose).collect()).collect()
}

/// Returns the readings for identification (all poses except the poses of a fold) and the readings
/// for testing (the poses of the fold, with targets and fixtures that occur in the other poses).
fn split(robot: &dyn Robot, all: &Sets, settings: &Settings, fold: &BTreeSet<PoseName>) -> (Sets, Settings) {
    let (validation, calibration) = all.calibration.iter().cloned().partition(|o| fold.contains(&o.pose));
    let (validation_conditions, conditions): (_, Vec<Condition>) =
        settings.conditions.iter().cloned().partition(|c| fold.contains(&c.pose));
    let calibration_conditions = conditions.clone();
    let mut sets = Sets { calibration, validation, calibration_conditions, validation_conditions };
    let mut settings = Settings { conditions, ..settings.clone() };
    ValidationTargets::take(robot, &mut sets, &mut settings);
    (sets, settings)
}

/// Returns the mean square position error of each pose of these readings, mm².
fn squares_at(robot: &dyn Robot, observations: &[Observation], conditions: &[Condition], values: &[f64]) -> Squares {
    let (validation, validation_conditions) = (observations.to_vec(), conditions.to_vec());
    let sets = Sets { validation, validation_conditions, ..Sets::default() };
    let mut all: BTreeMap<PoseName, Vec<f64>> = BTreeMap::new();
    for (pose, error_mm) in PointErrors::new(robot, &sets).with(values) {
        all.entry(pose).or_default().push(norm(error_mm).powi(2));
    }
    all.into_iter().map(|(pose, squares)| (pose, mean(squares))).collect()
}

/// Means over the divisions.
fn mean_squares(folds: Vec<Squares>) -> Squares {
    let mut all: BTreeMap<PoseName, Vec<f64>> = BTreeMap::new();
    folds.into_iter().flatten().for_each(|(pose, squared)| all.entry(pose).or_default().push(squared));
    all.into_iter().map(|(pose, squares)| (pose, mean(squares))).collect()
}

/// Returns the decrease of the mean square error, and its standard uncertainty, from the poses.
pub(crate) fn gain(before: &Squares, after: &Squares) -> [f64; 2] {
    let gains: Vec<f64> = after.iter().filter_map(|(pose, squared)| Some(before.get(pose)? - squared)).collect();
    [mean(gains.iter().copied()), (variance(&gains) / gains.len() as f64).sqrt()]
}

fn rms(squares: &Squares) -> f64 {
    mean(squares.values().copied()).sqrt()
}

/// Fit of a model.
#[derive(Clone, Copy)]
struct ModelFit {
    /// Sum of squares.
    squares: f64,
    degrees_of_freedom: f64,
    /// Number of parameters that the data determine.
    parameters: f64,
}

/// Returns the F statistic of the further variance that `after` explains, and its p value.
fn f_test(before: ModelFit, after: ModelFit) -> [f64; 2] {
    let more = (after.parameters - before.parameters).round().max(1.0);
    let f = (before.squares - after.squares) / more / (after.squares / after.degrees_of_freedom);
    [f, Variance::Estimated(after.degrees_of_freedom).exceedance(more * f, more as usize)]
}

impl Tried {
    fn mean_square(&self) -> f64 {
        mean(self.left_out.values().copied())
    }

    /// F statistic of the further explained variance, and its p value.
    fn f_test(&self, before: &Self) -> Option<[f64; 2]> {
        (self.identified > before.identified).then(|| f_test(before.fit, self.fit))
    }

    fn improves(&self, before: &Self) -> bool {
        let [gain, u] = gain(&before.left_out, &self.left_out);
        gain > u && self.f_test(before).is_some_and(|[_, p]| p < SIGNIFICANCE)
    }

    /// `true` if errors decrease at held-out poses of other temperatures too.
    fn holds_by_block(&self, before: &Self) -> bool {
        let [gain, u] = gain(&before.by_block, &self.by_block);
        gain > u
    }

    fn step(&self, effect: Option<Effect>, before: Option<&Self>, accepted: bool) -> EffectStep {
        let test = before.and_then(|before| self.f_test(before));
        let gain = before.map(|before| gain(&before.left_out, &self.left_out));
        EffectStep {
            effect: effect.map(Into::into),
            identified: self.identified,
            rms_mm: rms(&self.fitted),
            f: test.map(|t| t[0]),
            p_value: test.map(|t| t[1]),
            held_out_rms_mm: self.mean_square().sqrt(),
            gain_over_u: gain.map(|[gain, u]| gain / u).filter(|v| v.is_finite()),
            accepted,
        }
    }

    /// Statistics of the errors at held-out poses.
    pub fn statistics(&self) -> Statistics {
        summarise(self.left_out.values().map(|squared| squared.sqrt()).collect())
    }
}

/// The effects that held-out poses prove, and the benefit of each.
///
/// # Errors
/// Fails like [`Study::new`], or if the identification fails.
pub(crate) fn proven(robot: &dyn Robot, sets: &Sets, settings: &Settings) -> Result<(Vec<Effect>, Vec<EffectProof>)> {
    let study = Study::new(robot, sets, settings.clone())?;
    let none = study.tried(&study.settings_with_effects(&[]))?;
    let (steps, chosen) = study.steps(&none, &mut || ())?;
    let accepted: Vec<&EffectStep> = steps.iter().filter(|step| step.accepted).collect();
    let proof = |pair: &[&EffectStep]| {
        let effect = pair[1].effect?;
        let of_effect = |i: usize| study.effects[i].is_some_and(|own| effect == own.into());
        Some(EffectProof {
            effect,
            joints: joint_names(robot, of_effect),
            is_identified: true,
            robot_key: None,
            campaign_line: None,
            without_mm: pair[0].held_out_rms_mm,
            with_mm: pair[1].held_out_rms_mm,
            gain_over_u: pair[1].gain_over_u,
            p_value: pair[1].p_value,
        })
    };
    let proofs = accepted.windows(2).filter_map(proof).collect();
    Ok((chosen, proofs))
}

/// Keeps the joints of the proved effects for which the data determine a parameter of the effect.
pub(crate) fn keep_determined_joints(
    proofs: &mut [EffectProof],
    robot: &dyn Robot,
    calibration: &[Observation],
    settings: &Settings,
    found: &Identification,
) {
    let effects = effects(robot, joints(calibration, &settings.conditions));
    let is_determined = |i: usize| {
        let share = found.determined(robot, i);
        found.free.contains(&i) && share.is_none_or(|share| share >= ParameterEntry::DETERMINED)
    };
    for proof in proofs {
        let of_effect = |i: usize| effects[i].is_some_and(|own| proof.effect == own.into());
        proof.joints = joint_names(robot, |i| of_effect(i) && is_determined(i));
    }
}

/// Name of an effect in `effects` of `[identify]`.
fn effect_key(effect: Effect) -> String {
    format!("{effect:?}").to_lowercase()
}

/// Names of the joints of some parameters of the robot itself.
fn joint_names(robot: &dyn Robot, chosen: impl Fn(usize) -> bool) -> Vec<String> {
    let parameters = robot.parameters().iter().enumerate().filter(|(i, _)| chosen(*i));
    let joints: BTreeSet<usize> = parameters.filter_map(|(_, p)| p.joint).collect();
    joints.into_iter().filter_map(|joint| Some(robot.joints().get(joint)?.name.clone())).collect()
}

/// Errors of a solution at held-out calibration poses, at most 200.
pub struct LeftOut {
    pub(crate) sets: Sets,
    pub(crate) settings: Settings,
    folds: Vec<BTreeSet<PoseName>>,
    pub(crate) identified: CrossValidated,
}

impl LeftOut {
    /// Fits near a solution again, without the poses of each fold; `None` with too few poses, or if
    /// a fit fails.
    pub fn new(robot: &dyn Robot, sets: &Sets, settings: &Settings, found: &Identification) -> Option<Self> {
        let (sets, settings, folds) = sampled(sets, settings)?;
        let trial = Trial { robot, sets: &sets, start: &found.values, folds: &folds };
        let identified = trial.cross_validate(&settings)?;
        Some(Self { sets, settings, folds, identified })
    }

    /// Fits that start at these values.
    pub(crate) fn trial<'a>(&'a self, robot: &'a dyn Robot, start: &'a [f64]) -> Trial<'a> {
        Trial { robot, sets: &self.sets, start, folds: &self.folds }
    }

    /// Errors with nominal parameters, which are in `before` with base and targets fitted, and with
    /// the identified parameters; `None` if no position is measured.
    pub fn errors(&self, robot: &dyn Robot, before: &[f64]) -> Option<LeftOutErrors> {
        let effects = effects(robot, joints(&self.sets.calibration, &self.settings.conditions));
        let robot_itself = effects.iter().enumerate().filter(|(_, effect)| effect.is_some());
        let held = robot_itself.map(|(i, _)| robot.parameters()[i].name.clone()).collect();
        let nominal = self.trial(robot, before).cross_validate(&with_held(&self.settings, held))?;
        let poses = self.identified.left_out.len();
        let statistics = |of: &CrossValidated| summarise(of.left_out.values().map(|squared| squared.sqrt()).collect());
        let [nominal, identified] = [&nominal, &self.identified].map(statistics);
        (poses > 0).then_some(LeftOutErrors { poses, folds: self.folds.len(), nominal, identified })
    }

    /// Effects that the solution does not identify and that are significant, each in addition to
    /// the identified ones. Fits start at `found`.
    pub fn unused(&self, robot: &dyn Robot, found: &Identification) -> Vec<EffectProof> {
        let effects = effects(robot, joints(&self.sets.calibration, &self.settings.conditions));
        let stated = |i: usize| {
            let name = &robot.parameters()[i].name;
            self.settings.hold.iter().any(|pattern| matches_pattern(pattern, name))
        };
        // what the rule of effects alone holds
        let unused: Vec<usize> = (0..effects.len())
            .filter(|&i| effects[i].is_some() && found.status[i] == Status::Fixed && !stated(i))
            .collect();
        if unused.is_empty() {
            return Vec::new();
        }
        let trial = self.trial(robot, &found.values);
        let is_in_use =
            |effect: Effect| (0..effects.len()).any(|i| effects[i] == Some(effect) && found.status[i] != Status::Fixed);
        let with = |effect: Effect| -> Vec<Effect> {
            Effect::ALL.into_iter().filter(|other| *other == effect || is_in_use(*other)).collect()
        };
        // the settings of the line that is advised
        let settings = |effect| Settings { effects: Effects::These(with(effect)), ..self.settings.clone() };
        let blocks = temperature_blocks(robot, &self.sets.calibration, &self.settings.conditions);
        let by_block = Trial { folds: &blocks, ..trial };
        let holds = |effect: Effect| {
            let errors = |settings: &Settings| Some(by_block.cross_validate(settings)?.left_out);
            let gains = || Some(gain(&errors(&self.settings)?, &errors(&settings(effect))?));
            !effect.is_thermal() || gains().is_some_and(|[gain, u]| gain > u)
        };
        let candidates = Effect::ALL.into_iter().filter(|effect| unused.iter().any(|&i| effects[i] == Some(*effect)));
        let proof = |effect: Effect| {
            let more = settings(effect);
            let joints = joint_names(robot, |i| unused.contains(&i) && effects[i] == Some(effect));
            let identified = || Some([trial.identify(&self.settings)?, trial.identify(&more)?]);
            let proof = would_prove([&self.identified, &trial.cross_validate(&more)?], identified, effect, joints)?;
            let names: Vec<String> = with(effect).iter().map(|effect| format!("\"{}\"", effect_key(*effect))).collect();
            Some(EffectProof { campaign_line: Some(format!("effects = [{}]", names.join(", "))), ..proof })
        };
        candidates.filter(|effect| holds(*effect)).filter_map(proof).collect()
    }
}

/// Some calibration poses, settings with their conditions, and folds of them; `None` if they are
/// too few.
fn sampled(sets: &Sets, settings: &Settings) -> Option<(Sets, Settings, Vec<BTreeSet<PoseName>>)> {
    let all = poses(&sets.calibration, &settings.conditions);
    if all.len() < FEWEST {
        return None;
    }
    let names: Vec<PoseName> = all.iter().copied().step_by(all.len().div_ceil(TRIED_POSES)).collect();
    let kept: BTreeSet<PoseName> = names.iter().copied().collect();
    let calibration = sets.calibration.iter().filter(|o| kept.contains(&o.pose)).cloned().collect();
    let conditions = settings.conditions.iter().filter(|c| kept.contains(&c.pose)).cloned().collect();
    let parts = parts(names.len());
    let mut folds = folds(names);
    folds.truncate(parts);
    Some((Sets { calibration, ..Sets::default() }, Settings { conditions, ..settings.clone() }, folds))
}

/// Returns the gain of an effect that is not identified, if the effect is significant: by fits near
/// the solution without it and with it, and then by identifications at held-out poses, as a run
/// with the effect identifies.
pub(crate) fn would_prove(
    [without, with]: [&CrossValidated; 2],
    identified: impl Fn() -> Option<[Squares; 2]>,
    effect: Effect,
    joints: Vec<String>,
) -> Option<EffectProof> {
    let [near, u_near] = gain(&without.left_out, &with.left_out);
    let [_, p] = f_test(without.fit, with.fit);
    if !(near > u_near && p < SIGNIFICANCE) {
        return None;
    }
    let [without, with] = identified()?;
    let [gain, u] = gain(&without, &with);
    (gain > ADVISED * u).then(|| EffectProof {
        effect: effect.into(),
        joints,
        is_identified: false,
        robot_key: None,
        campaign_line: None,
        without_mm: rms(&without),
        with_mm: rms(&with),
        gain_over_u: Some(gain / u).filter(|v| v.is_finite()),
        p_value: Some(p),
    })
}

/// Fit to all poses, and errors at held-out poses.
pub(crate) struct CrossValidated {
    fit: ModelFit,
    /// Mean square of the errors of each pose.
    pub(crate) left_out: Squares,
}

/// Fits near a solution, without their uncertainties.
#[derive(Clone, Copy)]
pub(crate) struct Trial<'a> {
    robot: &'a dyn Robot,
    sets: &'a Sets,
    start: &'a [f64],
    folds: &'a [BTreeSet<PoseName>],
}

impl Trial<'_> {
    /// Fits to all poses, and to all but the poses of each fold.
    pub(crate) fn cross_validate(&self, settings: &Settings) -> Option<CrossValidated> {
        let fit = NestedFit::new(self.robot, &self.sets.calibration, settings, self.start).ok()?;
        let again = |observations: &[Observation], settings: &Settings| {
            fit.again(self.robot, observations, settings).ok_or_else(Problems::default)
        };
        let left_out = left_out_squares(self.robot, self.sets, settings, self.folds, again).ok()?;
        let quality =
            ModelFit { squares: fit.squares, degrees_of_freedom: fit.degrees_of_freedom, parameters: fit.determined };
        Some(CrossValidated { fit: quality, left_out })
    }

    /// Errors at the poses of each fold by an identification from all other poses.
    pub(crate) fn identify(&self, settings: &Settings) -> Option<Squares> {
        let identify = |observations: &[Observation], settings: &Settings| -> Result<Vec<f64>> {
            let before = etalon_identify::fit_frames(self.robot, observations, settings).map_err(remedied)?;
            Ok(Fitted::from_start(self.robot, observations, settings, &before).map_err(remedied)?.values)
        };
        left_out_squares(self.robot, self.sets, settings, self.folds, identify).ok()
    }
}

/// Errors at the poses of each fold with the values that `fitted` finds from all other poses.
fn left_out_squares(
    robot: &dyn Robot,
    sets: &Sets,
    settings: &Settings,
    folds: &[BTreeSet<PoseName>],
    fitted: impl Fn(&[Observation], &Settings) -> Result<Vec<f64>> + Sync,
) -> Result<Squares> {
    let of_fold = |fold: &BTreeSet<PoseName>| {
        let (sets, settings) = split(robot, sets, settings, fold);
        let values = fitted(&sets.calibration, &settings)?;
        Ok(squares_at(robot, &sets.validation, &sets.validation_conditions, &values))
    };
    Ok(mean_squares(folds.par_iter().map(of_fold).collect::<Result<Vec<_>>>()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn few_poses_are_left_out_one_by_one() {
        let counted = |poses: usize| (parts(poses), repeats(poses));
        // 240 poses are fitted, in at least five parts
        assert_eq!([0, 3, 12, 16, 20, 40].map(counted), [(0, 1), (3, 1), (12, 1), (15, 1), (12, 1), (6, 1)]);
        assert_eq!([49, 100, 200, 1000].map(counted), [(5, 3), (5, 3), (5, 1), (5, 1)]);
        for poses in [3i64, 12, 20, 50] {
            let all = folds((1..=poses).map(PoseName::from).collect());
            let left_out: usize = all.iter().map(BTreeSet::len).sum();
            let count = poses as usize;
            assert_eq!(left_out, repeats(count) * count, "each pose once in each division");
        }
    }
}
