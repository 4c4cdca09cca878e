//! Candidates: configurations that may be measured, as far as the robot reaches them.

use crate::Observation;
use crate::Result;
use etalon_base::message::{Message, count};
use etalon_base::pose_name::PoseName;
use etalon_robots::Robot;
use std::collections::BTreeMap;

/// Configurations that may be measured.
#[derive(Clone, Debug)]
pub struct Candidates {
    /// In the order of the table; those of one pose stand together.
    pub observations: Vec<Observation>,
    /// Which are left out because they are out of reach with nominal parameters ([`Robot::limit_violation`]).
    pub beyond: Option<Message>,
}

/// The configurations that are within reach of the nominal robot, those of one pose numbered.
pub fn within_reach(robot: &dyn Robot, all: Vec<Observation>) -> Result<Candidates> {
    let nominal = robot.nominal();
    let mut beyond = Vec::new();
    let mut by_pose: BTreeMap<PoseName, Vec<Observation>> = BTreeMap::new();
    for o in all {
        match robot.limit_violation(&nominal, &o.joints) {
            Some(why) => beyond.push(format!("pose {} ({why})", o.pose)),
            None => by_pose.entry(o.pose).or_default().push(o),
        }
    }
    if by_pose.is_empty() {
        let mut message = Message::error("there are no candidates");
        if let Some(first) = beyond.first() {
            message = Message::error(format!("no candidate is within reach: {first}"));
        }
        return Err(message.into());
    }
    let number = |(k, o): (usize, Observation)| Observation { cycle: k as i64 + 1, ..o };
    let observations = by_pose.into_values().flat_map(|of_pose| of_pose.into_iter().enumerate().map(number)).collect();
    Ok(Candidates { observations, beyond: out_of_reach(&beyond) })
}

fn out_of_reach(beyond: &[String]) -> Option<Message> {
    const SHOWN: usize = 5;
    let more = if beyond.len() > SHOWN { ", ..." } else { "" };
    let shown = beyond.iter().take(SHOWN).cloned().collect::<Vec<_>>().join(", ");
    let what = format!("{} out of reach, never chosen: {shown}{more}", count(beyond.len(), "configuration"));
    (!beyond.is_empty()).then(|| Message::warning(what))
}
