//! Recommendation: the answer of a run to what a controller should load, and its evidence: the
//! effects that the data prove at held-out poses, and the change of each parameter.

use crate::stages::calibrate::cross_validation::Study;
use crate::stages::calibrate::identification::state_positions;
use crate::stages::calibrate::selection::Selected;
use crate::stages::calibrate::solution::Basis;
use crate::stages::remedies::remedied;
use etalon_base::catalogue::Phrase;
use etalon_base::message::{Message, Result};
use etalon_base::worded::Worded;
use etalon_base::{error, phrase, warning};
use etalon_documents::parameters_document;
use etalon_documents::*;
use etalon_identify::{Identification, Settings, Stability, StabilityTest, Status};
use etalon_math::statistics::variance;
use etalon_robots::{Effect, Robot};
use statrs::distribution::{ContinuousCDF, Normal, StudentsT};

/// Explains the answer of a `run` from the `selected` observations of its campaign; `report` is
/// called with the number of choices of parameters tried and their maximum. The document lists the
/// input files of the run.
pub fn recommend(
    robot: &dyn Robot,
    selected: Selected,
    run: &Results,
    report: &mut dyn FnMut(usize, usize),
) -> Result<RecommendationDocument> {
    let Selected { basis: Basis { sets, settings, .. }, messages, .. } = selected;
    let study = Study::new(robot, &sets, settings)?;
    let answer = run.identified.as_ref().zip(run.verdict.loading.as_ref());
    let (identified, loading) = answer.ok_or_else(|| error!("nothing-to-judge"))?;
    Recommendation { study: &study, identified, loading }.document(messages, report)
}

/// Recommendation of a study.
struct Recommendation<'a> {
    study: &'a Study<'a>,
    /// Parameters of the run.
    identified: &'a IdentifiedDocuments,
    /// Answer of the run.
    loading: &'a Loading,
}

impl Recommendation<'_> {
    fn document(
        &self,
        mut messages: Vec<Message>,
        report: &mut dyn FnMut(usize, usize),
    ) -> Result<RecommendationDocument> {
        let study = self.study;
        let effects = Effect::ALL.into_iter().filter(|effect| study.effects.contains(&Some(*effect))).count();
        // no effects, the effects of the run, the answer, and every sequence of effects
        let (mut ended, most) = (0, 3 + effects * (effects + 1) / 2);
        let mut one_more = || {
            ended += 1;
            report(ended.min(most - 1), most);
        };
        let none = study.tried(&study.settings_with_effects(&[]))?;
        one_more();
        let (mut steps, _) = study.steps(&none, &mut one_more)?;
        let of_run = self.run_parameters();
        let answer: Vec<usize> = (0..study.effects.len())
            .filter(|i| study.effects[*i].is_some_and(|effect| self.is_answered(of_run.contains(i), effect)))
            .collect();
        let holding = |free: &[usize]| study.holding(study.held(|i| free.contains(&i)));
        let all = study.tried(&holding(&of_run))?;
        one_more();
        let model = holding(&answer);
        let other = if answer == of_run { None } else { Some(study.tried(&model)?) };
        let recommended = other.as_ref().unwrap_or(&all);
        report(most, most);
        let held_out =
            HeldOutErrors { none: none.statistics(), all: all.statistics(), recommended: recommended.statistics() };
        for step in &mut steps {
            let is_loaded = |effect| answer.iter().any(|i| study.effects[*i].is_some_and(|own| effect == own.into()));
            step.accepted &= step.effect.is_none_or(is_loaded);
        }
        let everything = study.identify(&study.settings_with_effects(&Effect::ALL))?;
        let identified = study.identify(&holding(&of_run))?;
        let stability = self.stability(&holding(&of_run), &identified)?;
        let parameters = self.verdicts(&everything, &stability)?;
        messages.extend(self.unstable(&stability));
        let document = match self.loading.answer {
            LoadAnswer::Load | LoadAnswer::Resolve => self.identified.parameters.clone(),
            LoadAnswer::IdentifyFurther | LoadAnswer::KeepNominal => {
                let found = if answer == of_run { identified } else { study.identify(&model)? };
                self.conditioned(&model, &found)
            }
        };
        messages
            .extend(document.messages.iter().filter(|m| m.severity == etalon_base::message::Severity::Error).cloned());
        let meaning = self.meaning(&steps, &parameters, &held_out);
        Ok(RecommendationDocument {
            schema: "etalon/recommendation/1".to_owned(),
            robot: study.robot.model().to_owned(),
            campaign: None,
            loading: Some(self.loading.clone()),
            meaning: meaning.into_iter().map(Worded::from).collect(),
            extent: CrossValidationExtent {
                poses: study.poses,
                folds: study.first_cut().len(),
                repeats: study.folds.len() / study.first_cut().len(),
            },
            steps,
            parameters,
            held_out,
            recommended: document,
            messages,
        })
    }

    /// Parameters of the robot itself that the run identified.
    fn run_parameters(&self) -> Vec<usize> {
        let study = self.study;
        let identified = |i: &usize| {
            let name = &study.robot.parameters()[*i].name;
            let entry = self.identified.parameters.parameters.iter().find(|p| p.name == *name);
            entry.is_some_and(|p| p.status != ParameterStatus::Fixed)
        };
        (0..study.effects.len()).filter(|&i| study.effects[i].is_some()).filter(identified).collect()
    }

    /// `true` if a parameter of an effect is part of the answer; `is_of_run` if the run has it.
    fn is_answered(&self, is_of_run: bool, effect: Effect) -> bool {
        let further = || self.loading.effects.contains(&effect.into());
        self.loading.answer != LoadAnswer::KeepNominal && (is_of_run || further())
    }

    /// Document of parameters that differ from the parameters of the run.
    fn conditioned(&self, model: &Settings, found: &Identification) -> ParametersDocument {
        let study = self.study;
        let inputs = &self.identified.parameters.provenance.inputs;
        let mut document = parameters_document(study.robot, model, &study.before, found, inputs);
        state_positions(&mut document, study.robot, &study.sets.calibration, [&study.before, &found.values]);
        document
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

    /// Returns a warning that names the unstable parameters.
    fn unstable(&self, stability: &[Stability]) -> Option<Message> {
        let of = |s: &Stability| {
            let parameter = &self.study.robot.parameters()[s.parameter].name;
            phrase!("unstable-parameter", parameter, over_sd = s.over_sd, limit = s.limit)
        };
        let parameters: Vec<_> = stability.iter().filter(|s| !s.is_stable()).map(of).collect();
        (!parameters.is_empty()).then(|| warning!("parameters-unstable", parameters))
    }

    /// Changes of the parameters of the robot itself from nominal.
    fn changes(&self, found: &Identification) -> Vec<Change> {
        let identified = found.free.iter().copied().filter(|&i| self.study.effects[i].is_some());
        let change = |index: usize| {
            let change = found.values[index] - self.study.robot.parameters()[index].nominal;
            Some(Change::new(index, change, found.standard_uncertainty(index)?, found.degrees_of_freedom(index)))
        };
        corrected(identified.filter_map(change).collect())
    }

    /// Changes of the identified parameters of the run, as its parameters.json contains them.
    fn run_changes(&self) -> Vec<Change> {
        let robot = self.study.robot;
        let change = |p: &ParameterEntry| {
            let index = robot.index(&p.name).filter(|i| self.study.effects[*i].is_some())?;
            let quantity = robot.parameters()[index].quantity;
            let change = quantity.inward(p.value - p.nominal);
            Some(Change::new(index, change, quantity.inward(p.standard_uncertainty?), p.degrees_of_freedom))
        };
        corrected(self.identified.parameters.identified().filter_map(change).collect())
    }

    /// Evidence for each parameter that the run identified, and for each that it would identify
    /// with `all` effects.
    fn verdicts(&self, all: &Identification, stability: &[Stability]) -> Result<Vec<ParameterVerdict>> {
        let of_run = self.run_changes();
        let is_of_run = |c: &Change| of_run.iter().any(|other| other.index == c.index);
        let further: Vec<Change> = self.changes(all).into_iter().filter(|c| !is_of_run(c)).collect();
        let mut changes: Vec<&Change> = of_run.iter().chain(&further).collect();
        changes.sort_by_key(|c| c.index);
        let influences = &self.identified.accuracy.parameter_influences;
        let study = self.study;
        // of the first cut alone: every pose is omitted once
        let folds = |is_free: &dyn Fn(usize) -> bool| {
            let settings = study.holding(study.held(is_free));
            study.first_cut().iter().map(|fold| study.without(fold, &settings)).collect::<Result<Vec<_>>>()
        };
        let of_run_folds = folds(&|i| of_run.iter().any(|c| c.index == i))?;
        let is_more = !further.is_empty();
        let further_folds = if is_more { folds(&|i| all.status[i] == Status::Identified)? } else { Vec::new() };
        let verdict = |c: &Change| {
            let (p, effect) = (&study.robot.parameters()[c.index], study.effects[c.index]?);
            let stability = stability.iter().find(|s| s.parameter == c.index);
            let folds = if is_of_run(c) { &of_run_folds } else { &further_folds };
            let values: Vec<f64> = folds.iter().map(|found| found.values[c.index]).collect();
            let variance = variance(&values);
            // two folds share all but two parts of their poses: their values differ by less than
            // independent ones
            let u_fold = c.u * ((values.len() as f64) / (values.len() as f64 - 1.0)).sqrt();
            Some(ParameterVerdict {
                name: p.name.clone(),
                unit: p.quantity.unit().to_owned(),
                effect: effect.into(),
                change: p.quantity.outward(c.change),
                displacement_mm: influences.iter().find(|of| of.name == p.name).map(|of| of.change_mm),
                change_over_u: (c.change / c.u).abs(),
                p_value: c.p_value,
                fold_sd_over_u: variance.sqrt() / u_fold,
                part_change_over_sd: stability.map(|s| s.over_sd),
                part_change_limit: stability.map(|s| s.limit),
                verdict: if self.is_answered(is_of_run(c), effect) { LoadVerdict::Load } else { LoadVerdict::Hold },
            })
        };
        Ok(changes.into_iter().filter_map(verdict).collect())
    }

    /// The recommendation in sentences.
    fn meaning(&self, steps: &[EffectStep], parameters: &[ParameterVerdict], errors: &HeldOutErrors) -> Vec<Phrase> {
        let loading = self.loading;
        let (load, count) = (parameters.iter().filter(|p| p.verdict == LoadVerdict::Load).count(), parameters.len());
        let answer = loading.withheld().unwrap_or_else(|| match &loading.file {
            Some(file) => phrase!("recommend-file", file, load, count),
            None => phrase!("recommend-parameters", load, count),
        });
        let effects: Vec<Phrase> =
            steps.iter().filter(|s| s.accepted).filter_map(|s| Some(s.effect?.phrase())).collect();
        let proven = (!effects.is_empty()).then(|| phrase!("effects-reduce-errors", effects));
        let rms = |s: &Statistics| format!("{:.4}", s.rms);
        let [nominal, all, recommended] = [&errors.none, &errors.all, &errors.recommended].map(rms);
        let shown = phrase!("error-left-out", nominal, all, recommended);
        [Some(answer), proven, Some(shown)].into_iter().flatten().collect()
    }
}

/// A change from nominal (mm, rad, 1).
struct Change {
    index: usize,
    change: f64,
    u: f64,
    p_value: f64,
}

impl Change {
    /// A change with its standard uncertainty and the degrees of freedom of that, and the
    /// probability of a larger one by chance.
    fn new(index: usize, change: f64, u: f64, degrees_of_freedom: Option<f64>) -> Self {
        let t = (change / u).abs();
        let p_value = match degrees_of_freedom.map(|nu| StudentsT::new(0.0, 1.0, nu)) {
            Some(Ok(student)) => 2.0 * student.sf(t),
            _ => 2.0 * Normal::standard().sf(t),
        };
        Self { index, change, u, p_value }
    }
}

/// Changes with probabilities corrected for their number (Holm 1979).
fn corrected(mut changes: Vec<Change>) -> Vec<Change> {
    let corrected = etalon_identify::holm(&changes.iter().map(|c| c.p_value).collect::<Vec<_>>());
    changes.iter_mut().zip(corrected).for_each(|(c, p)| c.p_value = p);
    changes
}
