//! Identification: from observations to parameters, and errors before and after.

use crate::stages::calibrate::cross_validation::proven;
use crate::stages::calibrate::evaluation::{Controls, Evaluation, Judgement, LocatedSolution, Prediction};
use crate::stages::calibrate::findings::Findings;
use crate::stages::calibrate::log_comparison::compare_logs;
use crate::stages::calibrate::selection::{CampaignData, Selected, select};
use crate::stages::calibrate::solution::{Basis, Solution};
use crate::stages::calibrate::validation_targets::{TargetLocations, ValidationTargets};
use crate::stages::evaluate::accuracy::{self, ErrorUncertainty, Judged};
use crate::stages::evaluate::errors::{point_errors, position_rms_mm, within_poses_rms_mm};
use crate::stages::evaluate::influence::influences;
use crate::stages::evaluate::sets::Sets;
use crate::stages::judge::checks::{reliability_summary, robust_summary, trends, with_reliability};
use crate::stages::judge::commanded::commanded;
use crate::stages::judge::set_up::check_set_up;
use crate::stages::remedies::remedied;
use etalon_base::message::{Message, Result};
use etalon_campaign::{Campaign, EffectRule, Identify, NamedEffects, OutlierRule};
use etalon_documents::{
    AccuracyDocument, EffectProof, FieldDocument, IdentifiedDocuments, ParametersDocument, PointError,
};
use etalon_documents::{parameters_document, untested_mistakes, warning_messages};
use etalon_identify::{Effects, Identification, Observation, Settings, Systematic, Warning};
use etalon_robots::Robot;
use std::collections::BTreeMap;

/// Result of the identification of a campaign.
#[derive(Clone, Debug)]
pub struct Identified {
    /// Parameters, errors before and after, and the residual field; the hash of the parameters is
    /// filled in when they are written.
    pub documents: IdentifiedDocuments,
    /// Solution that the documents describe.
    pub solution: IdentifiedSolution,
}

/// Solution of an identification, with its input.
#[derive(Clone, Debug)]
pub struct IdentifiedSolution {
    /// Observations used.
    pub sets: Sets,
    /// Settings and weights of the identification.
    pub settings: Settings,
    /// Result of the solver.
    pub found: Identification,
    /// Input for another identification.
    pub again: Again,
}

/// Input for another identification from the same observations.
#[derive(Clone, Debug)]
pub struct Again {
    systematic: Systematic,
    /// Nominal parameters with base and targets fitted.
    pub before: Vec<f64>,
    targets: ValidationTargets,
}

impl IdentifiedSolution {
    /// Statistics of the errors with other values of the parameters, and the verdicts on their
    /// limits.
    ///
    /// # Errors
    /// Fails if targets cannot be placed.
    pub fn accuracy_with(&self, campaign: &Campaign, robot: &dyn Robot, values: &[f64]) -> Result<AccuracyDocument> {
        let Again { targets, before, systematic } = &self.again;
        let mut errors = point_errors(robot, &self.sets, before, values);
        let (mut before, mut values) = (before.clone(), values.to_vec());
        let locations = targets.locate(robot, &mut before, &mut values)?;
        errors.extend(targets.errors(robot, &before, &values, &locations));
        let (all, set_up) = (targets.with_readings(&self.sets), self.found.set_up_parameters(robot));
        let judged = Judged { robot, values: &values, set_up: &set_up, sets: &all, settings: &self.settings };
        let uncertainty = ErrorUncertainty::new(campaign, judged, systematic)?;
        Ok(accuracy::evaluate(robot, &errors, &campaign.file.limits, uncertainty))
    }

    /// Identifies again with these parameters held at their nominal values.
    ///
    /// # Errors
    /// Fails if the solver fails.
    pub fn without(&self, robot: &dyn Robot, held: &[String]) -> Result<Identification> {
        let hold = self.settings.hold.iter().chain(held).cloned().collect();
        let settings = Settings { hold, ..self.settings.clone() };
        let Again { systematic, before, .. } = &self.again;
        etalon_identify::identify_with(robot, &self.sets.calibration, &settings, before, systematic).map_err(remedied)
    }

    /// Fits base and targets again to a robot with these parameters.
    ///
    /// # Errors
    /// Fails if the solver fails.
    pub fn with_frames(&self, robot: &dyn Robot, values: &[f64]) -> Result<Vec<f64>> {
        etalon_identify::refit_frames(robot, &self.sets.calibration, &self.settings, values).map_err(remedied)
    }
}

/// Identifies the robot from the observations of the first log; other logs are compared with it.
/// The parameters state no input files.
///
/// # Errors
/// Fails if the observations contradict their selection, or if a step cannot be computed.
pub fn identify(data: CampaignData, robot: &mut dyn Robot) -> Result<Identified> {
    let selected = select(data, robot)?;
    identify_selected(data, robot, selected)
}

/// Like [`identify`], for a chosen set of parameters: these are held at their nominal values, and
/// all others are free, independent of the effects in the campaign.
///
/// # Errors
/// Fails like [`identify`].
pub fn identify_chosen(
    data: CampaignData,
    robot: &mut dyn Robot,
    held: impl Iterator<Item = String>,
) -> Result<Identified> {
    let mut selected = select(data, robot)?;
    selected.basis.settings.hold.extend(held);
    selected.basis.settings.effects = Effects::All;
    let stated = Identify { effects: EffectRule::Named(NamedEffects::All), ..data.stated.clone() };
    identify_selected(CampaignData { stated: &stated, ..data }, robot, selected)
}

/// Identifies the robot from selected observations: the method. Each step takes what earlier steps
/// return, and its messages go to one place, which orders them.
fn identify_selected(data: CampaignData, robot: &dyn Robot, selected: Selected) -> Result<Identified> {
    let Selected { basis, targets, division, messages: selection } = selected;
    // from observations to a solution
    let Solved { solution, outliers, proofs } = solve(robot, data.stated, basis)?;
    let logs = compare_logs(data, robot, &division, &solution)?;
    let commanded = commanded_positions(data.campaign, robot, &solution);
    let (solution, locations) = locate(robot, &targets, solution)?;
    let all = targets.with_readings(&solution.basis.sets);
    let located =
        LocatedSolution { data, robot, solution: &solution, targets: &targets, locations: &locations, all: &all };
    // from the solution to errors, verdicts and predictions
    let validation_only = locations.message(robot, &solution.basis.sets)?;
    let Judgement { errors, plausibility, untested } = located.judge();
    let bound = located.exceeded_bound()?;
    let evaluation = located.evaluate(errors, proofs)?;
    let observations = [selection, outliers, logs.observations].concat();
    let observations = observations.into_iter().chain(commanded).chain(validation_only).collect();
    let mut findings = Findings { bound, plausibility, observations, logs: logs.correlations, ..Findings::default() };
    findings.evaluation.clone_from(&evaluation.messages);
    let prediction = located.predict(&evaluation.accuracy, findings.has_error(&solution.found.warnings))?;
    findings.field = prediction.field.iter().flat_map(|field| field.messages.clone()).collect();
    let controls = located.control()?;
    findings.robust.clone_from(&controls.robust_message);
    // from all of them to documents
    let warnings = findings.ordered(&solution.found.warnings);
    let mut documents = documents(located, evaluation, prediction, controls, &warnings);
    documents.parameters.untested = untested_mistakes(&untested);
    let Solution { basis: Basis { sets, settings, systematic }, before, found } = solution;
    let found = Identification { warnings, ..found };
    let again = Again { systematic, before, targets };
    Ok(Identified { documents, solution: IdentifiedSolution { sets, settings, found, again } })
}

/// Solution of the selected observations.
struct Solved {
    solution: Solution,
    /// Excluded outliers.
    outliers: Vec<Message>,
    /// Gain of each effect; `None` if the campaign lists the effects.
    proofs: Option<Vec<EffectProof>>,
}

/// Selects effects, solves, and excludes outliers, as the campaign asks for it.
fn solve(robot: &dyn Robot, stated: &Identify, basis: Basis) -> Result<Solved> {
    let Proven { basis, proofs } = prove_effects(robot, stated, basis)?;
    let solution = Solution::new(robot, basis)?;
    let (solution, outliers) = exclude_outliers(robot, stated.outliers, solution)?;
    Ok(Solved { solution, outliers, proofs })
}

/// An identification with its errors, whose result is not judged.
#[derive(Clone, Debug)]
pub(crate) struct Unjudged {
    /// Parameters before and after.
    pub solution: Solution,
    /// All observations, with the readings of the targets of validation poses.
    pub all: Sets,
    /// Errors of all observations.
    pub errors: Vec<PointError>,
    /// Statistics of the errors, and the verdicts on their limits.
    pub accuracy: AccuracyDocument,
    /// Messages of the selection.
    pub messages: Vec<Message>,
}

/// Identifies like [`identify`] as far as the errors and their limits: a part of its steps, within
/// milliseconds.
///
/// # Errors
/// Fails like [`identify`].
pub(crate) fn identify_unjudged(data: CampaignData, robot: &mut dyn Robot) -> Result<Unjudged> {
    let Selected { basis, targets, mut messages, .. } = select(data, robot)?;
    let robot: &dyn Robot = robot;
    let Solved { solution, outliers, .. } = solve(robot, data.stated, basis)?;
    messages.extend(outliers);
    let (solution, locations) = locate(robot, &targets, solution)?;
    let all = targets.with_readings(&solution.basis.sets);
    let located =
        LocatedSolution { data, robot, solution: &solution, targets: &targets, locations: &locations, all: &all };
    let errors = point_errors(robot, &solution.basis.sets, &solution.before, &solution.found.values);
    let (accuracy, errors) = located.accuracy(errors)?;
    Ok(Unjudged { solution, all, errors, accuracy, messages })
}

/// Basis of an identification with the effects that are identified.
struct Proven {
    basis: Basis,
    /// Gain of each effect; `None` if the campaign lists the effects.
    proofs: Option<Vec<EffectProof>>,
}

/// Sets the effects that the data prove, if the campaign asks for them.
fn prove_effects(robot: &dyn Robot, stated: &Identify, basis: Basis) -> Result<Proven> {
    if stated.effects != EffectRule::Named(NamedEffects::Proven) {
        return Ok(Proven { basis, proofs: None });
    }
    let Basis { sets, settings, systematic } = basis;
    check_set_up(robot, &sets.calibration, &settings)?;
    let (chosen, proofs) = proven(robot, &sets, &settings)?;
    let settings = Settings { effects: Effects::These(chosen), ..settings };
    Ok(Proven { basis: Basis { sets, settings, systematic }, proofs: Some(proofs) })
}

/// Excludes outliers, if the campaign asks for it, and names them.
fn exclude_outliers(robot: &dyn Robot, rule: OutlierRule, solution: Solution) -> Result<(Solution, Vec<Message>)> {
    if rule == OutlierRule::Exclude { solution.without_outliers(robot) } else { Ok((solution, Vec::new())) }
}

/// Error about commanded positions instead of measured ones; simulated positions are commanded.
fn commanded_positions(campaign: &Campaign, robot: &dyn Robot, solution: &Solution) -> Option<Message> {
    let is_measured = campaign.file.synthetic.is_none();
    is_measured.then(|| commanded(robot, &solution.before, &solution.basis.sets.calibration)).flatten()
}

/// Locates the targets of validation poses with the solution.
fn locate(
    robot: &dyn Robot,
    targets: &ValidationTargets,
    mut solution: Solution,
) -> Result<(Solution, TargetLocations)> {
    let locations = targets.locate(robot, &mut solution.before, &mut solution.found.values)?;
    Ok((solution, locations))
}

/// Creates the document of a solution with the results of all steps, and with `warnings` as its
/// messages.
fn documents(
    located: LocatedSolution,
    evaluation: Evaluation,
    prediction: Prediction,
    controls: Controls,
    warnings: &[Warning],
) -> IdentifiedDocuments {
    let LocatedSolution { data: CampaignData { campaign, .. }, robot, locations, all, .. } = located;
    let Solution { basis: Basis { sets, settings, .. }, before, found } = located.solution;
    let Evaluation { mut accuracy, mut errors, .. } = evaluation;
    let mut parameters = parameters_document(robot, settings, before, found, &BTreeMap::new());
    parameters.messages = warning_messages(warnings);
    state_positions(&mut parameters, robot, &sets.calibration, [before, &found.values]);
    parameters.valid_until = campaign.file.valid_until();
    parameters.links = campaign.robot.links(robot);
    parameters.synthetic = campaign.file.synthetic.clone();
    locations.mark(robot, found, &mut parameters);
    parameters.robust = controls.robust.map(|robust| robust_summary(robot, &robust));
    if let Some(reliability) = controls.reliability {
        with_reliability(robot, &reliability, &mut errors);
        parameters.reliability = reliability_summary(robot, &reliability);
    }
    let (field, summary) = prediction.field.map_or((None, None), |search| (search.field, Some(search.summary)));
    (accuracy.field, accuracy.tool, accuracy.map) = (summary, prediction.tool, prediction.map);
    accuracy.parameter_influences = influences(robot, all, &found.values, &parameters);
    let base = robot.kinematics().and_then(|k| k.base_in_world(&found.values)).filter(|_| robot.platform().is_none());
    accuracy.trends = trends(&errors, &accuracy.joints, base.map_or([0.0; 3], |base| base.translation_mm));
    let field = field.map(|field| FieldDocument::new(robot, &found.values, &field, String::new()));
    IdentifiedDocuments { parameters, accuracy, errors, field }
}

/// Writes the position residuals before and after identification into the document.
pub fn state_positions(
    document: &mut ParametersDocument,
    robot: &dyn Robot,
    observed: &[Observation],
    [before, after]: [&[f64]; 2],
) {
    let residuals = &mut document.residuals;
    if residuals.kind == etalon_documents::ResidualKind::Targets {
        let known = residuals.position.position_rms_mm;
        residuals.position.position_rms_mm = known.or_else(|| position_rms_mm(robot, observed, after));
        residuals.position.position_rms_before_mm = position_rms_mm(robot, observed, before);
        residuals.position.within_poses_rms_mm = within_poses_rms_mm(robot, observed, after);
    }
}
