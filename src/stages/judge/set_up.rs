//! Judgement of a set-up before an identification.

use etalon_base::message::Result;
use etalon_identify::{Observation, Settings};
use etalon_robots::Robot;

/// Returns an error if the nominal robot is far from the measurements.
pub(crate) fn check_set_up(robot: &dyn Robot, observations: &[Observation], settings: &Settings) -> Result<()> {
    let problem = || etalon_identify::set_up_problem(robot, observations, settings.coordinate_uncertainty_mm());
    let problem = if observations.is_empty() { None } else { problem() };
    problem.map_or(Ok(()), |problem| Err(etalon_documents::warning_message(&problem).into()))
}
