//! Judgement of a set-up before an identification, and mistakes that the data do not show.

use crate::stages::truncated;
use etalon_base::message::{Message, Result};
use etalon_base::{phrase, warning};
use etalon_documents::warning_message;
use etalon_identify::{Observation, Settings, Untested, set_up_problem};
use etalon_robots::Robot;

/// Maximum number of named changes.
const NAMED: usize = 8;

/// Warnings about mistakes that the data do not show.
///
/// # Errors
/// Fails if the measurements contradict the set-up.
pub(crate) fn check_set_up(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
) -> Result<Vec<Message>> {
    let (problem, judged) = set_up_problem(robot, observations, settings);
    match problem {
        Some(problem) => Err(warning_message(&problem).into()),
        None => Ok(untested(&judged.untested).into_iter().collect()),
    }
}

/// Returns a warning about mistakes of the set-up that the data do not show.
pub(super) fn untested(mistakes: &[Untested]) -> Option<Message> {
    let change = |untested: &Untested| {
        let ([stated_mm, changed_mm], (flange_mm, rad)) = (untested.residuals_mm, untested.differs);
        let (change, flange_deg) = (untested.change.clone(), rad.to_degrees());
        phrase!("untested-change", change, changed_mm, stated_mm, flange_mm, flange_deg)
    };
    let changes = mistakes.iter().map(change);
    (!mistakes.is_empty()).then(|| warning!("set-up-untested", changes = truncated(changes, NAMED)).to_decide())
}
