//! Candidates: configurations that may be measured, within the reach of the robot.

use crate::Observation;
use crate::Result;
use etalon_base::catalogue::{Argument, IntoArgument, Phrase};
use etalon_base::message::Message;
use etalon_base::pose_name::PoseName;
use etalon_base::{error, phrase, warning};
use etalon_robots::Robot;
use std::collections::BTreeMap;

/// Configurations that may be measured.
#[derive(Clone, Debug)]
pub struct Candidates {
    /// Configurations in the order of the table; the configurations of one pose are consecutive.
    pub observations: Vec<Observation>,
    /// Message for candidates that violate a limit of the nominal robot
    /// ([`Robot::limit_violation`]).
    pub limit_violations: Option<Message>,
}

/// The configurations within reach of the nominal robot, with numbered poses.
pub fn within_limits(robot: &dyn Robot, all: Vec<Observation>) -> Result<Candidates> {
    let nominal = robot.nominal();
    let mut violations = Vec::new();
    let mut by_pose: BTreeMap<PoseName, Vec<Observation>> = BTreeMap::new();
    for o in all {
        match robot.limit_violation(&nominal, &o.joints) {
            Some(reason) => violations.push((o.pose, reason)),
            None => by_pose.entry(o.pose).or_default().push(o),
        }
    }
    if by_pose.is_empty() {
        let unreachable = |(pose, reason): &(PoseName, Phrase)| error!("candidates-unreachable", pose, reason);
        return Err(violations.first().map_or_else(|| error!("no-candidates"), unreachable).into());
    }
    let number = |(k, o): (usize, Observation)| Observation { cycle: k as i64 + 1, ..o };
    let observations = by_pose.into_values().flat_map(|of_pose| of_pose.into_iter().enumerate().map(number)).collect();
    Ok(Candidates { observations, limit_violations: violation_message(&violations) })
}

fn violation_message(violations: &[(PoseName, Phrase)]) -> Option<Message> {
    const SHOWN: usize = 5;
    let shown = violations.iter().take(SHOWN);
    let mut candidates: Vec<Argument> =
        shown.map(|(pose, reason)| phrase!("candidate-violation", pose, reason).argument()).collect();
    if violations.len() > SHOWN {
        candidates.push("...".argument());
    }
    (!violations.is_empty()).then(|| warning!("candidates-left-out", count = violations.len(), candidates))
}
