//! Recommendation: the effects that the data prove at left-out poses, and the parameters that
//! deserve to be loaded.
//!
//! Parameters are chosen within every fold of the cross-validation again, so that the error stated
//! for the choice has not seen the poses that it is of (Hastie, Tibshirani & Friedman, 7.10.2).
//! What is not stable is found once, by all poses, and held in every fold.

use crate::stages::calibrate::cross_validation::{SIGNIFICANCE, Study, Tried};
use crate::stages::calibrate::identification::state_positions;
use crate::stages::calibrate::selection::Selected;
use crate::stages::calibrate::solution::Basis;
use crate::stages::judge::set_up::check_set_up;
use crate::stages::remedies::remedied;
use etalon_base::catalogue::Phrase;
use etalon_base::message::{Message, Result};
use etalon_base::worded::Worded;
use etalon_base::{phrase, warning};
use etalon_documents::parameters_document;
use etalon_documents::*;
use etalon_identify::{Identification, Settings, Stability, StabilityTest, Status, Variance};
use etalon_math::statistics::variance;
use etalon_robots::{Effect, Robot};
use nalgebra::{Cholesky, DMatrix, DVector};
use statrs::distribution::{ContinuousCDF, Normal, StudentsT};
use std::collections::BTreeMap;

/// Judges the identification from the `selected` observations of a campaign; `inputs` are the files
/// and their SHA-256, and `report` is called with the number of choices of parameters tried and
/// their maximum.
pub fn recommend(
    robot: &dyn Robot,
    selected: Selected,
    inputs: &BTreeMap<String, String>,
    report: &mut dyn FnMut(usize, usize),
) -> Result<RecommendationDocument> {
    let Selected { basis: Basis { sets, settings, .. }, mut messages, .. } = selected;
    messages.extend(check_set_up(robot, &sets.calibration, &settings)?);
    let study = Study::new(robot, &sets, settings)?;
    Recommendation { study: &study }.document(inputs, messages, report)
}

/// Maximum ratio of the error at left-out poses with the proven parameters alone to that with all
/// parameters.
const COSTS: f64 = 1.05;

/// Rule for loading parameters of the accepted effects.
#[derive(Clone, Copy)]
enum Choice {
    /// Parameters with a proven change from nominal that are stable.
    Proven,
    /// Stable parameters.
    Stable,
}

/// Recommendation of a study.
struct Recommendation<'a> {
    study: &'a Study<'a>,
}

impl Recommendation<'_> {
    fn document(
        &self,
        inputs: &BTreeMap<String, String>,
        mut messages: Vec<Message>,
        report: &mut dyn FnMut(usize, usize),
    ) -> Result<RecommendationDocument> {
        let study = self.study;
        let effects = Effect::ALL.into_iter().filter(|effect| study.effects.contains(&Some(*effect))).count();
        // none, all, the recommended, and every sequence of effects
        let (mut ended, most) = (0, 3 + effects * (effects + 1) / 2);
        let mut one_more = || {
            ended += 1;
            report(ended.min(most - 1), most);
        };
        let none = study.tried(&study.settings_with_effects(&[]), None)?;
        one_more();
        let (steps, mut chosen) = study.steps(&none, &mut one_more)?;
        let all = study.tried(&study.settings_with_effects(&Effect::ALL), None)?;
        one_more();
        // one effect may explain little without the others
        let left_mm = steps.iter().rfind(|step| step.accepted).map(|step| step.held_out_rms_mm);
        let together = left_mm.is_some_and(|left_mm| left_mm > COSTS * all.statistics().rms);
        if together {
            chosen = Effect::ALL.into_iter().filter(|effect| study.effects.contains(&Some(*effect))).collect();
        }
        let model = study.settings_with_effects(&chosen);
        let full = study.identify(&model)?;
        let stability = self.stability(&model, &full)?;
        let choose = |choice: Choice, found: &Identification| {
            let load = self.load(found, &stability, choice);
            study.held(move |i| load.contains(&i))
        };
        let tried = |choice: Choice| study.tried(&model, Some(&|found: &Identification| choose(choice, found)));
        let (mut choice, mut recommended) = (Choice::Proven, tried(Choice::Proven)?);
        let error_mm = |tried: &Tried| tried.statistics().rms;
        if error_mm(&recommended) > COSTS * error_mm(&all) {
            let stable = tried(Choice::Stable)?;
            if error_mm(&stable) < error_mm(&recommended) {
                (choice, recommended) = (Choice::Stable, stable);
            }
        }
        report(most, most);
        let held_out =
            HeldOutErrors { none: none.statistics(), all: all.statistics(), recommended: recommended.statistics() };
        let parameters = self.verdicts([&all.found, &full], &stability, choice)?;
        messages.extend(self.unstable(&stability));
        let settings = study.holding(choose(choice, &full));
        let mut document = parameters_document(study.robot, &settings, &study.before, &recommended.found, inputs);
        let after = &recommended.found.values;
        state_positions(&mut document, study.robot, &study.sets.calibration, [&study.before, after]);
        messages
            .extend(document.messages.iter().filter(|m| m.severity == etalon_base::message::Severity::Error).cloned());
        let meaning = meaning(&chosen, together, choice, &parameters, &held_out);
        Ok(RecommendationDocument {
            schema: "etalon/recommendation/1".to_owned(),
            robot: study.robot.model().to_owned(),
            campaign: None,
            meaning: meaning.into_iter().map(Worded::from).collect(),
            poses: study.poses,
            folds: study.first_cut().len(),
            repeats: study.folds.len() / study.first_cut().len(),
            steps,
            parameters,
            held_out,
            recommended: document,
            messages,
        })
    }

    /// Parameters of the robot itself whose change from nominal is proven: each by itself, and of
    /// the others those without which the rest is not proven together. Correlated parameters may
    /// each be unproven and still matter.
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

    /// Dependence of the parameters of the robot itself on the poses: identified without each part
    /// of the first division, and from each half of the measurement.
    fn stability(&self, model: &Settings, found: &Identification) -> Result<Vec<Stability>> {
        let (study, calibration) = (self.study, &self.study.sets.calibration);
        let of_robot: Vec<usize> = found.free.iter().copied().filter(|&i| study.effects[i].is_some()).collect();
        let mut left_out = study.first_cut().to_vec();
        left_out.extend(etalon_identify::halves(calibration, &model.conditions));
        let test = StabilityTest { parameters: &of_robot, left_out: &left_out };
        etalon_identify::stability(study.robot, calibration, model, found, test).map_err(remedied)
    }

    /// Parameters to load: stable, and proven if the choice asks for it.
    fn load(&self, found: &Identification, stability: &[Stability], choice: Choice) -> Vec<usize> {
        let unstable = |i: &usize| stability.iter().any(|s| s.parameter == *i && !s.is_stable());
        let of_robot = || found.free.iter().copied().filter(|&i| self.study.effects[i].is_some());
        let wanted = match choice {
            Choice::Proven => self.proven(found),
            Choice::Stable => of_robot().collect(),
        };
        wanted.into_iter().filter(|i| !unstable(i)).collect()
    }

    /// Returns a warning that names the unstable parameters.
    fn unstable(&self, stability: &[Stability]) -> Option<Message> {
        let of = |s: &Stability| {
            let parameter = &self.study.robot.parameters()[s.parameter].name;
            phrase!("unstable-parameter", parameter, over_sd = s.over_sd, limit = s.limit)
        };
        let parameters: Vec<_> = stability.iter().filter(|s| !s.is_stable()).map(of).collect();
        (!parameters.is_empty()).then(|| warning!("parameters-unstable", parameters))
    }

    /// Changes of several parameters together over their covariance, as a sum of squares, and its p
    /// value.
    fn together(&self, found: &Identification, indices: &[usize]) -> Option<[f64; 2]> {
        let places: Vec<usize> =
            indices.iter().map(|i| found.free.iter().position(|f| f == i)).collect::<Option<_>>()?;
        let (n, covariance) = (found.free.len(), found.uncertainty.covariance.as_ref()?);
        let u = |k: usize| covariance[places[k] * n + places[k]].sqrt();
        let correlation =
            DMatrix::from_fn(places.len(), places.len(), |i, j| covariance[places[i] * n + places[j]] / (u(i) * u(j)));
        let change = |k: usize| (found.values[indices[k]] - self.study.robot.parameters()[indices[k]].nominal) / u(k);
        let change = DVector::from_fn(places.len(), |k, _| change(k));
        let sum = change.dot(&Cholesky::new(correlation)?.solve(&change));
        let degrees = indices.iter().filter_map(|&i| found.degrees_of_freedom(i)).reduce(f64::min);
        let variance = degrees.map_or(Variance::Stated, Variance::Estimated);
        Some([sum, variance.exceedance(sum, places.len())])
    }

    /// Changes of the parameters of the robot itself from nominal.
    fn changes(&self, found: &Identification) -> Vec<Change> {
        let identified = found.free.iter().copied().filter(|&i| self.study.effects[i].is_some());
        let change = |index: usize| {
            let change = found.values[index] - self.study.robot.parameters()[index].nominal;
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

    /// The verdict on each identifiable parameter; those of the recommended model are judged in it.
    fn verdicts(
        &self,
        [all, model]: [&Identification; 2],
        stability: &[Stability],
        choice: Choice,
    ) -> Result<Vec<ParameterVerdict>> {
        let (of_all, of_model, load) = (self.changes(all), self.changes(model), self.load(model, stability, choice));
        let study = self.study;
        let settings = study.holding(study.held(|i| all.status[i] == Status::Identified));
        // of the first cut alone: every pose is left out once
        let folds = study.first_cut().iter().map(|fold| study.without(fold, &settings)).collect::<Result<Vec<_>>>()?;
        let verdict = |c: &Change| {
            let (p, effect) = (&study.robot.parameters()[c.index], study.effects[c.index]?);
            let stability = stability.iter().find(|s| s.parameter == c.index);
            let judged = of_model.iter().find(|m| m.index == c.index).unwrap_or(c);
            let values: Vec<f64> = folds.iter().map(|found| found.values[c.index]).collect();
            let variance = variance(&values);
            // two folds share all but two parts of their poses: their values differ by less than
            // independent ones
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

/// The recommendation in sentences; `together` if the chosen effects are proven only together.
fn meaning(
    chosen: &[Effect],
    together: bool,
    choice: Choice,
    parameters: &[ParameterVerdict],
    errors: &HeldOutErrors,
) -> Vec<Phrase> {
    let name = |effect: &Effect| etalon_documents::Effect::from(*effect).phrase();
    let effects: Vec<Phrase> = chosen.iter().map(name).collect();
    let (load, count) = (parameters.iter().filter(|p| p.verdict == LoadVerdict::Load).count(), parameters.len());
    let first = match effects[..] {
        [] => phrase!("identify-nothing"),
        _ if together => phrase!("identify-together", effects),
        _ => phrase!("identify-each", effects),
    };
    let loaded = match choice {
        Choice::Proven => phrase!("load-proven", load, count),
        Choice::Stable => phrase!("load-stable", load, count),
    };
    let rms = |s: &Statistics| format!("{:.4}", s.rms);
    let [nominal, all, recommended] = [&errors.none, &errors.all, &errors.recommended].map(rms);
    vec![first, loaded, phrase!("error-left-out", nominal, all, recommended)]
}
