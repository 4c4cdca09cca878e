//! The search for a residual field after an identification.

use super::evaluate::Sets;
use etalon_base::catalogue::Phrase;
use etalon_base::message::Severity;
use etalon_base::{phrase, warning};
use etalon_documents::{AccuracyDocument, FieldSummary};
use etalon_identify::{Identification, JointField, Settings, field_of};
use etalon_robots::Robot;

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
            let trial = field_of(robot, &sets.calibration, settings, found);
            let summary = FieldSummary::new(robot, &trial);
            (trial.field, summary)
        }
    };
    if let Some(reason) = &summary.reason_phrase {
        found.warnings.push(warning!("field-refused", reason).routine().into());
    }
    accuracy.field = Some(summary);
    field
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
