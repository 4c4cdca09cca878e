//! The search for a residual field after an identification.

use crate::stages::calibrate::solution::{Basis, Solution};
use etalon_base::catalogue::Phrase;
use etalon_base::message::Message;
use etalon_base::{phrase, warning};
use etalon_documents::FieldSummary;
use etalon_identify::{JointField, Observation, search_field};
use etalon_math::statistics::rank_correlation;
use etalon_robots::Robot;
use std::collections::BTreeSet;

/// Rank correlation of joint values with the order of the poses beyond which a drift looks like an
/// error that depends on the joint. Of 20 poses in random order it is three standard deviations.
const IN_ORDER: f64 = 0.7;

/// Result of a search for a residual field.
#[derive(Clone, Debug)]
pub struct FieldSearch {
    /// The field, if it is proved.
    pub field: Option<JointField>,
    /// Entry of `accuracy.json`.
    pub summary: FieldSummary,
    /// Warnings: the reason of a refusal, or a field that follows the order of the poses.
    pub messages: Vec<Message>,
}

/// Searches the residuals of the calibration for a field; `is_wrong` if an earlier step reports an
/// error.
pub(crate) fn search(robot: &dyn Robot, solution: &Solution, is_wrong: bool) -> FieldSearch {
    let Solution { basis: Basis { sets, settings, .. }, found, .. } = solution;
    let (field, summary) = match obstacle(robot, is_wrong) {
        Some(reason) => (None, FieldSummary::refused(reason)),
        None => {
            let trial = search_field(robot, &sets.calibration, settings, found);
            let summary = FieldSummary::new(robot, &trial);
            (trial.field, summary)
        }
    };
    let refusal = summary.reason.as_ref().map(|reason| warning!("field-refused", reason).routine());
    let follows = field.as_ref().and_then(|field| follows_order(robot, field, &sets.calibration));
    FieldSearch { messages: refusal.into_iter().chain(follows).collect(), field, summary }
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
fn obstacle(robot: &dyn Robot, is_wrong: bool) -> Option<Phrase> {
    if robot.platform().is_some() {
        return Some(phrase!("field-needs-positions"));
    }
    is_wrong.then(|| phrase!("field-parameters-wrong"))
}
