//! Evaluation of a solution: judgement, errors before and after, predictions and controls. Each
//! step returns what it adds.

use crate::stages::calibrate::cross_validation::{LeftOut, keep_determined_joints};
use crate::stages::calibrate::selection::CampaignData;
use crate::stages::calibrate::solution::{Basis, Solution};
use crate::stages::calibrate::undescribed_effects::{Undescribed, best_alone};
use crate::stages::calibrate::validation_targets::{TargetLocations, ValidationTargets};
use crate::stages::evaluate::accuracy::{self, ErrorUncertainty, Judged, RobotValues};
use crate::stages::evaluate::errors::{point_errors, with_times};
use crate::stages::evaluate::field::{self, FieldSearch};
use crate::stages::evaluate::sets::Sets;
use crate::stages::evaluate::tool::Expected;
use crate::stages::judge::checks::{far_targets, robust_message};
use crate::stages::judge::circumstances::reading_values;
use crate::stages::judge::first_tilt;
use crate::stages::judge::frame_checks::base_elsewhere;
use crate::stages::judge::plausible::{Plausibility, is_suspect, plausibility};
use crate::stages::judge::readings::RobustReadings;
use crate::stages::judge::validation_distance::{far_or_near, validation_distance};
use crate::stages::remedies::remedied;
use crate::stages::uncertainty::bounds::open_set_up;
use etalon_base::message::{Message, Problems, Result};
use etalon_base::{phrase, warning};
use etalon_documents::{
    AccuracyDocument, Conformity, EffectProof, LimitVerdict, PointError, PredictionMap, ToolAccuracy,
};
use etalon_formats::table;
use etalon_identify::{Reliability, RobustComparison, ToolPoint, ToolPrediction, Untested};
use etalon_robots::Robot;

/// Solution of a campaign, with the targets of validation poses located.
#[derive(Clone, Copy)]
pub(crate) struct LocatedSolution<'a> {
    pub data: CampaignData<'a>,
    pub robot: &'a dyn Robot,
    pub solution: &'a Solution,
    pub targets: &'a ValidationTargets,
    pub locations: &'a TargetLocations,
    /// All observations, with the readings of the targets of validation poses.
    pub all: &'a Sets,
}

/// Judgement of a solution by its errors.
pub struct Judgement {
    /// Errors of the observations of both sets.
    pub errors: Vec<PointError>,
    /// Implausible parameters, and readings to check first.
    pub plausibility: Vec<Message>,
    /// Mistakes of the set-up that the data do not show.
    pub untested: Vec<Untested>,
}

impl Judgement {
    /// Judges a solution.
    pub fn new(robot: &dyn Robot, solution: &Solution) -> Self {
        let of = |s: &Solution| point_errors(robot, &s.basis.sets, &s.before, &s.found.values);
        let errors = of(solution);
        let Solution { basis: Basis { settings, .. }, found, .. } = solution;
        let readings = is_suspect(settings, found, &errors).then(|| RobustReadings::new(robot, solution)).flatten();
        // readings that decide a solution decide nothing about the set-up and the model
        let settled = readings.as_ref().and_then(|readings| readings.settled(robot, solution));
        let (judged_solution, errors_judged) = match &settled {
            Some(settled) => (&settled.solution, &of(&settled.solution)),
            None => (solution, &errors),
        };
        let Plausibility { mut messages, untested } =
            plausibility(robot, judged_solution, errors_judged, readings.as_ref());
        messages.extend(far_targets(robot, &judged_solution.found));
        messages.splice(0..0, settled.map(|settled| settled.message)).for_each(drop);
        Self { errors, plausibility: messages, untested }
    }
}

/// Errors before and after, with the verdicts on their limits.
pub(crate) struct Evaluation {
    pub accuracy: AccuracyDocument,
    pub errors: Vec<PointError>,
    pub messages: Vec<Message>,
}

/// Predictions of the identified robot.
pub(crate) struct Prediction {
    /// Search for a residual field, if the campaign asks for it.
    pub field: Option<FieldSearch>,
    pub tool: Option<ToolAccuracy>,
    pub map: Option<PredictionMap>,
}

/// Controls of the solution by its residuals.
pub(crate) struct Controls {
    pub robust: Option<RobustComparison>,
    pub robust_message: Option<Message>,
    pub reliability: Option<Reliability>,
}

impl LocatedSolution<'_> {
    /// Judges the solution by the readings that located no target of validation poses.
    pub fn judge(self) -> Judgement {
        Judgement::new(self.robot, self.solution)
    }

    /// Error about an uncertainty beyond the bound of the campaign.
    pub fn exceeded_bound(self) -> Result<Option<Message>> {
        let Solution { basis: Basis { sets, settings, .. }, found, .. } = self.solution;
        let bound = self.data.campaign.uncertainty_bound()?;
        Ok(open_set_up(self.robot, &sets.calibration, settings, found, bound))
    }

    /// Statistics of the `errors` of a judgement and of the readings that located targets, with the
    /// verdicts on their limits; and all these errors.
    pub fn accuracy(self, mut errors: Vec<PointError>) -> Result<(AccuracyDocument, Vec<PointError>)> {
        let Self { data: CampaignData { campaign, .. }, robot, all, .. } = self;
        let Solution { basis: Basis { settings, systematic, .. }, before, found } = self.solution;
        errors.extend(self.targets.errors(robot, before, &found.values, self.locations));
        let set_up = found.set_up_parameters(robot);
        let judged = Judged { robot, values: &found.values, set_up: &set_up, sets: all, settings };
        let uncertainty = ErrorUncertainty::new(campaign, judged, systematic)?;
        Ok((accuracy::evaluate(robot, &errors, &campaign.file.limits, uncertainty), errors))
    }

    /// Evaluates the `errors` of a judgement. `proofs` support the identified effects, if the data
    /// chose them.
    pub fn evaluate(self, errors: Vec<PointError>, proofs: Option<Vec<EffectProof>>) -> Result<Evaluation> {
        let Self { data: CampaignData { campaign, joined, .. }, robot, all, .. } = self;
        let Solution { basis: Basis { sets, settings, systematic }, before, found } = self.solution;
        let (mut accuracy, mut errors) = self.accuracy(errors)?;
        let set_up = found.set_up_parameters(robot);
        let judged = Judged { robot, values: &found.values, set_up: &set_up, sets: all, settings };
        accuracy.placed_apart = self.locations.documents(robot);
        // targets that are located by these poses would have too small errors
        let without_located = Judged { sets, ..judged };
        let nominal = RobotValues { robot, values: before };
        accuracy.relative = accuracy::relative(campaign, without_located, nominal, systematic)?;
        let left_out = LeftOut::new(robot, sets, settings, found);
        accuracy.left_out = left_out.as_ref().and_then(|left_out| left_out.errors(robot, before));
        let unused = || left_out.as_ref().map_or_else(Vec::new, |left_out| left_out.unused(robot, found));
        let determined = |mut proofs: Vec<EffectProof>| {
            keep_determined_joints(&mut proofs, robot, &sets.calibration, settings, found);
            proofs
        };
        accuracy.effects = proofs.map(determined).unwrap_or_else(unused);
        let undescribed = |left_out| Undescribed { robot_file: &campaign.robot, robot, left_out, found }.effects();
        accuracy.effects.extend(left_out.as_ref().map(undescribed).unwrap_or_default());
        best_alone(&mut accuracy.effects);
        accuracy.validation_distance = validation_distance(robot, all);
        for set in &mut accuracy.sets {
            set.readings = reading_values(robot, all, set.name);
        }
        if with_times(&mut errors, &joined.observations[0].1.times()?) {
            accuracy.joints.push(table::TIME.to_owned());
        }
        let mut messages: Vec<Message> = accuracy.limits.iter().filter_map(not_assessable).collect();
        messages.extend(accuracy.effects.iter().filter_map(would_prove));
        messages.extend(base_elsewhere(campaign, robot, &found.values));
        messages.extend(first_tilt::ambiguity(&campaign.robot, robot, self.solution));
        messages.extend(accuracy.validation_distance.as_ref().and_then(far_or_near));
        Ok(Evaluation { accuracy, errors, messages })
    }

    /// Predicts errors at the tool point, with a residual field if the campaign asks for it;
    /// `is_wrong` if an earlier step reports an error.
    pub fn predict(self, accuracy: &AccuracyDocument, is_wrong: bool) -> Result<Prediction> {
        let Self { data: CampaignData { campaign, stated, .. }, robot, all, .. } = self;
        let Solution { basis: Basis { sets, settings, .. }, before, found } = self.solution;
        let field = stated.field.then(|| field::search(robot, self.solution, is_wrong));
        let tool = campaign.file.tool.map(|tool| tool.point());
        let at_tool = |problems: Problems| problems.at(&campaign.key_place(&["tool"]));
        let point = tool.or_else(|| ToolPoint::centre(robot)).unwrap_or(ToolPoint::FIRST_TARGET);
        let held = etalon_identify::held(robot, &sets.calibration, settings, found).map_err(remedied)?;
        let prediction = ToolPrediction { robot, point, before, found, held };
        let expected = Expected::new(prediction, settings, accuracy).with_field(field.as_ref());
        let (mut tool_accuracy, mut map) = (None, None);
        if tool.is_some() || robot.platform().is_some() {
            tool_accuracy = expected.accuracy(all, accuracy).map_err(at_tool)?;
            map = expected.map(sets).map_err(at_tool)?;
        }
        Ok(Prediction { tool: tool_accuracy, map, field })
    }

    /// Controls the solution by a robust fit, and by the redundancy of its readings.
    pub fn control(self) -> Result<Controls> {
        let Self { robot, solution: Solution { basis: Basis { sets, settings, .. }, found, .. }, .. } = self;
        let calibration = &sets.calibration;
        let robust = etalon_identify::robust_comparison(robot, calibration, settings, found).map_err(remedied)?;
        let robust_message = robust.as_ref().and_then(|robust| robust_message(robot, robust));
        let reliability = etalon_identify::reliability(robot, calibration, settings, found).map_err(remedied)?;
        Ok(Controls { robust, robust_message, reliability })
    }
}

/// Warning about a limit whose quantity the poses that decide do not show.
fn not_assessable(limit: &LimitVerdict) -> Option<Message> {
    (limit.conformity == Conformity::NotAssessable)
        .then(|| warning!("limit-not-assessable", limit = limit.name.to_string()))
}

/// Returns a remark on an effect that is not identified but significant.
fn would_prove(proof: &EffectProof) -> Option<Message> {
    let EffectProof { joints, without_mm, with_mm, is_identified, robot_key, campaign_line, .. } = proof;
    if *is_identified {
        return None;
    }
    let effect = format!("{:?}", proof.effect).to_lowercase();
    let message = warning!("effect-would-prove", effect, count = joints.len(), joints, without_mm, with_mm);
    Some(match (robot_key, campaign_line) {
        (Some(line), _) => message.hint(phrase!("add-lines", lines = [format!("`{line}`")])),
        (None, Some(line)) => message.hint(phrase!("action-prove-effects", line)),
        (None, None) => message,
    })
}
