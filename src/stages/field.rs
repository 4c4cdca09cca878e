//! The search for a residual field after an identification.

use super::evaluate::Sets;
use etalon_base::catalogue::Phrase;
use etalon_base::message::{Message, Severity};
use etalon_base::{phrase, warning};
use etalon_documents::{AccuracyDocument, FieldSummary};
use etalon_identify::{Identification, JointField, Observation, Settings, search_field};
use etalon_math::statistics::rank_correlation;
use etalon_robots::Robot;
use std::collections::BTreeSet;

/// Rank correlation of joint values with the order of the poses beyond which a drift looks like an
/// error that depends on the joint. Of 20 poses in random order it is three standard deviations.
const IN_ORDER: f64 = 0.7;

/// Searches the residuals of the calibration for a field, and states the result in `accuracy`; the
/// reason of a refusal is among the warnings.
pub(super) fn search(
    robot: &dyn Robot,
    sets: &Sets,
    settings: &Settings,
    (found, accuracy): (&mut Identification, &mut AccuracyDocument),
) -> Option<JointField> {
    let (field, summary) = match obstacle(robot, found) {
        Some(reason) => (None, FieldSummary::refused(reason)),
        None => {
            let trial = search_field(robot, &sets.calibration, settings, found);
            let summary = FieldSummary::new(robot, &trial);
            (trial.field, summary)
        }
    };
    if let Some(reason) = &summary.reason_phrase {
        found.warnings.push(warning!("field-refused", reason).routine().into());
    }
    accuracy.field = Some(summary);
    let follows = |field: &JointField| follows_order(robot, field, &sets.calibration);
    found.warnings.extend(field.as_ref().and_then(follows).map(Into::into));
    field
}

/// Warning about the joint on which the field depends and whose values follow the order of the
/// poses most; `None` below the limit.
fn follows_order(robot: &dyn Robot, field: &JointField, observations: &[Observation]) -> Option<Message> {
    let joints: BTreeSet<usize> = field.components.iter().flat_map(|c| c.inputs.iter().map(|i| i.joint)).collect();
    let order: Vec<f64> = (0..observations.len()).map(|i| i as f64).collect();
    let correlation = |joint: usize| {
        let values: Vec<f64> = observations.iter().filter_map(|o| o.joints.get(joint).copied()).collect();
        (joint, rank_correlation(&values, &order))
    };
    let all = joints.into_iter().map(correlation).filter(|(_, correlation)| correlation.abs() >= IN_ORDER);
    let (joint, correlation) = all.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))?;
    Some(warning!("field-follows-order", joint = robot.joints()[joint].name, correlation))
}

/// Reason for not searching a field, such as an error of the identification: a field must not
/// absorb a wrong set-up.
fn obstacle(robot: &dyn Robot, found: &Identification) -> Option<Phrase> {
    if robot.platform().is_some() {
        return Some(phrase!("field-needs-positions"));
    }
    let is_wrong = found.warnings.iter().any(|warning| warning.message.severity == Severity::Error);
    is_wrong.then(|| phrase!("field-parameters-wrong"))
}
