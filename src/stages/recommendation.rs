//! Recommend: which effects the data prove by the poses that are left out, and which parameters deserve to be loaded.
//!
//! The calibration poses are cut into folds, each predicted from the others (Stone 1974); of the effects that are left the one that
//! predicts them best is added while its gain exceeds its standard uncertainty and the F test of nested models does not reject it. Parameters
//! are chosen within every fold again, so that the error stated for the choice has not seen the poses that it is of (Hastie, Tibshirani &
//! Friedman, 7.10.2). What is not stable is found once, by all poses, and held in every fold.

use super::evaluate::{self, Sets, summarise};
use super::identification::{Selected, check_set_up};
use crate::stages::remedies::remedied;
use etalon_base::message::{Message, Result, count};
use etalon_base::noise::Noise;
use etalon_base::pose::norm;
use etalon_base::pose_name::PoseName;
use etalon_documents::parameters_document;
use etalon_documents::*;
use etalon_identify::{Effects, Identification, Observation, Settings, Stability, Status, Variance, effects};
use etalon_math::statistics::{mean, variance};
use etalon_robots::{Effect, Robot};
use nalgebra::{Cholesky, DMatrix, DVector};
use rayon::prelude::*;
use statrs::distribution::{ContinuousCDF, Normal, StudentsT};
use std::collections::{BTreeMap, BTreeSet};

/// Parts into which the poses are cut.
const FOLDS: usize = 5;
/// How often they are cut: once where they are many, at most three times.
fn repeats(poses: usize) -> usize {
    (300 / poses).clamp(1, 3)
}

/// Seed of the parts.
const SEED: u64 = 4;
/// Significance of a parameter's change, corrected for their number, and of an effect.
const SIGNIFICANCE: f64 = 0.05;

/// Judges what is identified from the `selected` observations of a campaign; `inputs` are the files
/// and their SHA-256, and `report` is called with the choices of parameters that were tried and the
/// most that may be.
pub fn recommend(
    robot: &dyn Robot,
    selected: Selected,
    inputs: &BTreeMap<String, String>,
    report: &mut dyn FnMut(usize, usize),
) -> Result<RecommendationDocument> {
    let Selected { sets, settings, messages, .. } = selected.leave_unplaced_out(robot)?;
    if !settings.conditions.is_empty() {
        let message = Message::error("parameters are recommended from measured positions alone");
        return Err(message.hint("leave rows of other kinds out").into());
    }
    check_set_up(robot, &sets.calibration, &settings)?;
    Study::new(robot, &sets.calibration, settings)?.document(inputs, messages, report)
}

/// What is tried on which poses.
struct Study<'a> {
    robot: &'a dyn Robot,
    observations: &'a [Observation],
    settings: Settings,
    effects: Vec<Option<Effect>>,
    /// base and targets alone, fitted to all poses
    before: Vec<f64>,
    /// poses that are left out together
    folds: Vec<BTreeSet<PoseName>>,
    poses: usize,
}

/// Settings from what those before have identified.
type Again<'a> = &'a (dyn Fn(&Identification) -> Settings + Sync);

/// What a choice of parameters leaves.
struct Tried {
    found: Identification,
    /// squared errors at poses that were left out: mean of each pose, mm²
    left_out: BTreeMap<PoseName, f64>,
}

impl<'a> Study<'a> {
    fn new(robot: &'a dyn Robot, observations: &'a [Observation], settings: Settings) -> Result<Self> {
        let mut names: Vec<PoseName> =
            observations.iter().map(|o| o.pose).collect::<BTreeSet<_>>().into_iter().collect();
        let (poses, parts) = (names.len(), FOLDS.min(names.len()));
        if parts < 3 {
            let message = Message::error(format!("{} are too few to leave some out", count(poses, "calibration pose")));
            return Err(message.hint("measure more, or name more in `calibration`").into());
        }
        let mut folds = Vec::new();
        for repeat in 0..repeats(poses) {
            Noise::new(SEED, repeat as u64).shuffle(&mut names);
            folds.extend((0..parts).map(|part| names.iter().copied().skip(part).step_by(parts).collect()));
        }
        // which effects are identified is what is asked
        let settings = Settings { effects: Effects::All, ..settings };
        let before = etalon_identify::fit_frames(robot, observations, &settings).map_err(remedied)?;
        Ok(Self { robot, observations, effects: effects(robot, observations), before, folds, poses, settings })
    }

    /// The settings that identify these effects, or these parameters, and base and targets.
    fn settings(&self, identified: impl Fn(usize) -> bool) -> Settings {
        let mut settings = self.settings.clone();
        let held = self.effects.iter().enumerate().filter(|(i, effect)| effect.is_some() && !identified(*i));
        settings.hold.extend(held.map(|(i, _)| self.robot.parameters()[i].name.clone()));
        settings
    }

    fn of_effects(&self, chosen: &[Effect]) -> Settings {
        self.settings(|i| self.effects[i].is_some_and(|effect| chosen.contains(&effect)))
    }

    /// Identifies from some of the poses, from where base and targets are.
    fn identify(&self, observations: &[Observation], settings: &Settings) -> Result<Identification> {
        etalon_identify::identify_from(self.robot, observations, settings, &self.before).map_err(remedied)
    }

    /// Tries a choice of parameters, which may be made anew in each fold from what that identifies.
    fn tried(&self, settings: &Settings, again: Option<Again>) -> Result<Tried> {
        let choose = |observations: &[Observation]| -> Result<Identification> {
            let found = self.identify(observations, settings)?;
            match again {
                Some(again) => self.identify(observations, &again(&found)),
                None => Ok(found),
            }
        };
        let of_fold = |fold: &BTreeSet<PoseName>| -> Result<_> {
            let (out, used): (Vec<_>, Vec<_>) = self.observations.iter().cloned().partition(|o| fold.contains(&o.pose));
            Ok(self.squared_errors(out, &choose(&used)?.values))
        };
        let mut left_out: BTreeMap<PoseName, Vec<f64>> = BTreeMap::new();
        for errors in self.folds.par_iter().map(of_fold).collect::<Result<Vec<_>>>()? {
            errors.into_iter().for_each(|(pose, squared)| left_out.entry(pose).or_default().push(squared));
        }
        let left_out = left_out.into_iter().map(|(pose, all)| (pose, mean(all))).collect();
        Ok(Tried { found: choose(self.observations)?, left_out })
    }

    /// Squared position errors at poses that were left out, mm².
    fn squared_errors(&self, out: Vec<Observation>, values: &[f64]) -> Vec<(PoseName, f64)> {
        let sets = Sets { validation: out, ..Sets::default() };
        let errors = evaluate::errors(self.robot, &sets, &self.before, values);
        errors.iter().map(|e| (e.pose, norm(e.after_mm).powi(2))).collect()
    }

    fn document(
        &self,
        inputs: &BTreeMap<String, String>,
        mut messages: Vec<Message>,
        report: &mut dyn FnMut(usize, usize),
    ) -> Result<RecommendationDocument> {
        let effects = ALL.into_iter().filter(|effect| self.effects.contains(&Some(*effect))).count();
        // none, all, the recommended, and every sequence of effects
        let (mut ended, most) = (0, 3 + effects * (effects + 1) / 2);
        let mut one_more = || {
            ended += 1;
            report(ended.min(most - 1), most);
        };
        let none = self.tried(&self.of_effects(&[]), None)?;
        one_more();
        let (steps, chosen) = self.steps(&none, &mut one_more)?;
        let all = self.tried(&self.of_effects(&ALL), None)?;
        one_more();
        let model = self.of_effects(&chosen);
        let full = self.identify(self.observations, &model)?;
        let stability = self.stability(&model, &full)?;
        let choose = |found: &Identification| {
            let load = self.load(found, &stability);
            self.settings(move |i| load.contains(&i))
        };
        let recommended = self.tried(&model, Some(&choose))?;
        report(most, most);
        let held_out =
            HeldOutErrors { none: none.statistics(), all: all.statistics(), recommended: recommended.statistics() };
        let parameters = self.verdicts(&all.found, &full, &stability)?;
        messages.extend(self.unstable(&stability));
        let settings = choose(&full);
        let document = parameters_document(self.robot, &settings, &self.before, &recommended.found, inputs);
        messages
            .extend(document.messages.iter().filter(|m| m.severity == etalon_base::message::Severity::Error).cloned());
        Ok(RecommendationDocument {
            schema: "etalon/recommendation/1".to_owned(),
            robot: self.robot.model().to_owned(),
            meaning: meaning(&chosen, &parameters, &held_out),
            poses: self.poses,
            folds: self.folds.len() / repeats(self.poses),
            repeats: repeats(self.poses),
            steps,
            parameters,
            held_out,
            recommended: document,
            messages,
        })
    }

    /// Adds effects one by one, the best of those that are left first, while the poses that were left out become better.
    fn steps(&self, none: &Tried, one_more: &mut dyn FnMut()) -> Result<(Vec<EffectStep>, Vec<Effect>)> {
        let mut steps = vec![none.step(None, None, true)];
        let mut chosen: Vec<Effect> = Vec::new();
        let mut last: Option<Tried> = None;
        loop {
            let before = last.as_ref().unwrap_or(none);
            let left =
                ALL.into_iter().filter(|effect| !chosen.contains(effect) && self.effects.contains(&Some(*effect)));
            let mut tried = Vec::new();
            for effect in left {
                // an effect that these poses do not suffice to identify is not tried
                if let Ok(found) = self.tried(&self.of_effects(&[&chosen[..], &[effect]].concat()), None) {
                    tried.push((effect, found));
                }
                one_more();
            }
            tried.sort_by(|a, b| a.1.mean_square().total_cmp(&b.1.mean_square()));
            let accepted = tried.first().is_some_and(|(_, best)| best.improves(before));
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

    /// Parameters of the robot itself whose change from nominal is proven: each by itself, and of the others those without which the rest
    /// is not proven together. Correlated parameters may each be unproven, and matter.
    fn proven(&self, found: &Identification) -> Vec<usize> {
        let changes = self.changes(found);
        let (load, held): (Vec<&Change>, Vec<&Change>) = changes.iter().partition(|c| c.p_value < SIGNIFICANCE);
        let mut load: Vec<usize> = load.iter().map(|c| c.index).collect();
        let mut held: Vec<usize> = held.iter().map(|c| c.index).collect();
        let together = |held: &[usize]| self.together(found, held);
        while !held.is_empty() && together(&held).is_some_and(|[_, p]| p < SIGNIFICANCE) {
            let without = |k: usize| -> Vec<usize> { held.iter().copied().filter(|&i| i != held[k]).collect() };
            let left = |k: usize| together(&without(k)).map_or(0.0, |[sum, _]| sum);
            let Some(k) = (0..held.len()).min_by(|&a, &b| left(a).total_cmp(&left(b))) else { break };
            load.push(held.remove(k));
        }
        load
    }

    /// How much the parameters of the robot itself depend on which poses they are identified from: without each part of the first cut, and
    /// from each half of the measurement.
    fn stability(&self, model: &Settings, found: &Identification) -> Result<Vec<Stability>> {
        let of_robot: Vec<usize> = found.free.iter().copied().filter(|&i| self.effects[i].is_some()).collect();
        let mut left_out = self.folds[..self.folds.len() / repeats(self.poses)].to_vec();
        left_out.extend(etalon_identify::halves(self.observations));
        etalon_identify::stability(self.robot, self.observations, model, found, (&of_robot, &left_out))
            .map_err(remedied)
    }

    /// Parameters that are proven and stable.
    fn load(&self, found: &Identification, stability: &[Stability]) -> Vec<usize> {
        let unstable = |i: &usize| stability.iter().any(|s| s.parameter == *i && !s.is_stable());
        self.proven(found).into_iter().filter(|i| !unstable(i)).collect()
    }

    /// A warning that names the parameters that are not stable.
    fn unstable(&self, stability: &[Stability]) -> Option<Message> {
        let of = |s: &Stability| {
            let name = &self.robot.parameters()[s.parameter].name;
            format!("`{name}` ({:.1}, limit {:.1})", s.over_sd, s.limit)
        };
        let all: Vec<String> = stability.iter().filter(|s| !s.is_stable()).map(of).collect();
        let what = format!(
            "not stable, and held: values by part of the poses differ from those by all, over the standard deviation of the difference: {}",
            all.join(", ")
        );
        let hint = "look for what changed during the measurement (temperature, a target that moved, a joint homed again), and at the residuals";
        (!all.is_empty()).then(|| Message::warning(what).hint(hint))
    }

    /// Changes of several parameters together over their covariance, as a sum of squares, and its p value.
    fn together(&self, found: &Identification, indices: &[usize]) -> Option<[f64; 2]> {
        let places: Vec<usize> =
            indices.iter().map(|i| found.free.iter().position(|f| f == i)).collect::<Option<_>>()?;
        let (n, covariance) = (found.free.len(), found.covariance.as_ref()?);
        let u = |k: usize| covariance[places[k] * n + places[k]].sqrt();
        let correlation =
            DMatrix::from_fn(places.len(), places.len(), |i, j| covariance[places[i] * n + places[j]] / (u(i) * u(j)));
        let change = |k: usize| (found.values[indices[k]] - self.robot.parameters()[indices[k]].nominal) / u(k);
        let change = DVector::from_fn(places.len(), |k, _| change(k));
        let sum = change.dot(&Cholesky::new(correlation)?.solve(&change));
        let degrees = indices.iter().filter_map(|&i| found.degrees_of_freedom(i)).reduce(f64::min);
        let variance = degrees.map_or(Variance::Stated, Variance::Estimated);
        Some([sum, variance.exceedance(sum, places.len())])
    }

    /// Changes of the parameters of the robot itself from nominal.
    fn changes(&self, found: &Identification) -> Vec<Change> {
        let identified = found.free.iter().copied().filter(|&i| self.effects[i].is_some());
        let change = |index: usize| {
            let change = found.values[index] - self.robot.parameters()[index].nominal;
            let u = found.standard_uncertainty(index)?;
            let t = (change / u).abs();
            let p_value = match found.degrees_of_freedom(index).map(|nu| StudentsT::new(0.0, 1.0, nu)) {
                Some(Ok(student)) => 2.0 * student.sf(t),
                _ => 2.0 * Normal::standard().sf(t),
            };
            Some(Change { index, change, u, p_value })
        };
        let mut changes: Vec<Change> = identified.filter_map(change).collect();
        let corrected = etalon_identify::holm(&changes.iter().map(|c| c.p_value).collect::<Vec<_>>());
        changes.iter_mut().zip(corrected).for_each(|(c, p)| c.p_value = p);
        changes
    }

    /// The verdict on each parameter that can be identified; those of the model that is recommended are judged in it.
    fn verdicts(
        &self,
        all: &Identification,
        model: &Identification,
        stability: &[Stability],
    ) -> Result<Vec<ParameterVerdict>> {
        let (of_all, of_model, load) = (self.changes(all), self.changes(model), self.load(model, stability));
        let settings = self.settings(|i| all.status[i] == Status::Identified);
        // of the first cut alone: every pose is left out once
        let mut folds = Vec::new();
        for fold in &self.folds[..self.folds.len() / repeats(self.poses)] {
            let used: Vec<_> = self.observations.iter().filter(|o| !fold.contains(&o.pose)).cloned().collect();
            folds.push(self.identify(&used, &settings)?);
        }
        let verdict = |c: &Change| {
            let (p, effect) = (&self.robot.parameters()[c.index], self.effects[c.index]?);
            let stability = stability.iter().find(|s| s.parameter == c.index);
            let judged = of_model.iter().find(|m| m.index == c.index).unwrap_or(c);
            let values: Vec<f64> = folds.iter().map(|found| found.values[c.index]).collect();
            let variance = variance(&values);
            // two folds share all but two parts of their poses: their values differ by less than independent ones
            let u_fold = judged.u * ((values.len() as f64) / (values.len() as f64 - 1.0)).sqrt();
            Some(ParameterVerdict {
                name: p.name.clone(),
                unit: p.quantity.unit().to_owned(),
                effect: effect.into(),
                change: p.quantity.outward(judged.change),
                change_over_u: (judged.change / judged.u).abs(),
                p_value: judged.p_value,
                fold_sd_over_u: variance.sqrt() / u_fold,
                part_change_over_sd: stability.map(|s| s.over_sd),
                part_change_limit: stability.map(|s| s.limit),
                verdict: if load.contains(&c.index) { LoadVerdict::Load } else { LoadVerdict::Hold },
            })
        };
        Ok(of_all.iter().filter_map(verdict).collect())
    }
}

/// A change from nominal (mm, rad, 1).
struct Change {
    index: usize,
    change: f64,
    u: f64,
    p_value: f64,
}

/// All effects, the plainer first.
const ALL: [Effect; 7] = [
    Effect::Zeros,
    Effect::Geometry,
    Effect::Gains,
    Effect::Harmonics,
    Effect::Backlash,
    Effect::Coupling,
    Effect::Bending,
];

impl Tried {
    fn mean_square(&self) -> f64 {
        mean(self.left_out.values().copied())
    }

    /// By how much the mean square at poses that were left out is smaller than `before`, and its standard uncertainty, from the poses.
    fn gain(&self, before: &Self) -> [f64; 2] {
        let of = |(pose, squared): (&PoseName, &f64)| before.left_out.get(pose).map_or(0.0, |b| b - squared);
        let gains: Vec<f64> = self.left_out.iter().map(of).collect();
        [mean(gains.iter().copied()), (variance(&gains) / gains.len() as f64).sqrt()]
    }

    /// F of what this explains more, and its p value.
    fn f_test(&self, before: &Self) -> Option<[f64; 2]> {
        let squares = |found: &Identification| {
            let n = found.degrees_of_freedom + found.free.len();
            found.chi_square.unwrap_or(found.rms.powi(2) * n as f64)
        };
        let more = self.found.free.len().checked_sub(before.found.free.len()).filter(|k| *k > 0)?;
        let dof = self.found.degrees_of_freedom as f64;
        let f = (squares(&before.found) - squares(&self.found)) / more as f64 / (squares(&self.found) / dof);
        Some([f, Variance::Estimated(dof).exceedance(more as f64 * f, more)])
    }

    fn improves(&self, before: &Self) -> bool {
        let [gain, u] = self.gain(before);
        gain > u && self.f_test(before).is_some_and(|[_, p]| p < SIGNIFICANCE)
    }

    fn step(&self, effect: Option<Effect>, before: Option<&Self>, accepted: bool) -> EffectStep {
        let test = before.and_then(|before| self.f_test(before));
        let gain = before.map(|before| self.gain(before));
        EffectStep {
            effect: effect.map(Into::into),
            identified: self.found.free.len(),
            rms_mm: self.found.rms,
            f: test.map(|t| t[0]),
            p_value: test.map(|t| t[1]),
            held_out_rms_mm: self.mean_square().sqrt(),
            gain_over_u: gain.map(|[gain, u]| gain / u).filter(|v| v.is_finite()),
            accepted,
        }
    }

    fn statistics(&self) -> Statistics {
        summarise(self.left_out.values().map(|squared| squared.sqrt()).collect())
    }
}

/// The recommendation in sentences.
fn meaning(chosen: &[Effect], parameters: &[ParameterVerdict], errors: &HeldOutErrors) -> Vec<String> {
    let word = |effect: &Effect| match effect {
        Effect::Zeros => "zeros of the joints",
        Effect::Geometry => "geometry",
        Effect::Gains => "gains",
        Effect::Harmonics => "harmonics of the transmissions",
        Effect::Backlash => "backlash",
        Effect::Coupling => "coupling",
        Effect::Bending => "bending",
    };
    let words: Vec<&str> = chosen.iter().map(word).collect();
    let load = parameters.iter().filter(|p| p.verdict == LoadVerdict::Load).count();
    let first = match words[..] {
        [] => "no effect makes poses better that were left out: load nothing".to_owned(),
        _ => format!("identify {}: each makes poses better that were left out", words.join(", ")),
    };
    let rms = |s: &Statistics| format!("{:.4}", s.rms);
    vec![
        first,
        format!(
            "load {load} of {}: their change from nominal is proven, alone or together",
            count(parameters.len(), "parameter")
        ),
        format!(
            "error at poses that were left out (root mean square): {} mm with nominal parameters, {} mm with all, {} mm with those recommended",
            rms(&errors.none),
            rms(&errors.all),
            rms(&errors.recommended)
        ),
    ]
}
