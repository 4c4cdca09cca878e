//! The keys of `robot.toml`, and the robot they describe.

use crate::message::{Message, Result};
use crate::robots::{Prexyt, Robot, Serial, SerialJoint};
use serde::Deserialize;
use std::collections::BTreeMap;

/// Axes whose twist is below this are near-parallel: d is replaced by Hayati's beta (3 degrees).
const NEAR_PARALLEL_RAD: f64 = 0.052;

/// `robot.toml`.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RobotFile {
    /// Name for the report.
    pub name: Option<String>,
    /// The kinematic model.
    pub model: Model,
    /// Nominal values by name, in mm, deg and 1; those not given are the model's own.
    #[serde(default)]
    pub nominal: BTreeMap<String, f64>,
    /// Joints of a serial arm, from the base.
    #[serde(default, rename = "joint")]
    pub joints: Vec<JointDefinition>,
    /// Direction of gravity in the base of a serial arm.
    #[serde(default = "down")]
    pub gravity: [f64; 3],
    /// Joints of a serial arm that bend under gravity, from 1.
    #[serde(default)]
    pub bending: Vec<usize>,
    /// Pairs (joint, by which joint) of a coupled wrist, from 1.
    #[serde(default)]
    pub coupling: Vec<(usize, usize)>,
    /// base_rx, base_ry, base_rz are counted after this turn about the world's y axis.
    #[serde(default)]
    pub base_turn_y_deg: f64,
}

fn down() -> [f64; 3] {
    [0.0, 0.0, -1.0]
}

/// A kinematic model.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Model {
    /// PreXYT with 13 parameters.
    Prexyt,
    /// PreXYT before the reduction of section 3.4.
    PrexytFull,
    /// Serial arm.
    Serial,
}

/// Nominal modified Denavit-Hartenberg parameters of a joint (Craig).
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct JointDefinition {
    /// Twist of the link before the joint.
    pub alpha_deg: f64,
    /// Length of the link before the joint.
    pub a_mm: f64,
    /// Joint offset.
    pub theta_deg: f64,
    /// Link offset.
    pub d_mm: f64,
    /// The joint slides instead of turning.
    #[serde(default)]
    pub prismatic: bool,
    /// Near-parallel to the axis before: beta replaces d. By default decided by alpha.
    pub parallel: Option<bool>,
}

impl RobotFile {
    /// The robot with these targets (serial arms; others have their own).
    pub fn build(&self, targets: &[String]) -> Result<Box<dyn Robot>> {
        let robot: Box<dyn Robot> = match self.model {
            Model::Prexyt | Model::PrexytFull => {
                let robot = Prexyt::new(self.model == Model::PrexytFull);
                let nominal = self.nominal_of(&robot)?;
                Box::new(robot.with_nominal(&nominal))
            }
            Model::Serial => {
                let robot = self.serial(targets)?;
                let nominal = self.nominal_of(&robot)?;
                Box::new(robot.with_nominal(&nominal))
            }
        };
        Ok(robot)
    }

    fn serial(&self, targets: &[String]) -> Result<Serial> {
        let n = self.joints.len();
        if n == 0 {
            return Err(Message::error("a serial arm needs its joints")
                .hint("add one [[joint]] with alpha_deg, a_mm, theta_deg, d_mm per joint, from the base")
                .into());
        }
        let numbers = self.bending.iter().copied().chain(self.coupling.iter().flat_map(|&(a, b)| [a, b]));
        if let Some(wrong) = numbers.into_iter().find(|&j| j == 0 || j > n) {
            return Err(Message::error(format!("there is no joint {wrong}")).expected(format!("1 to {n}")).into());
        }
        if targets.is_empty() {
            return Err(Message::error("a serial arm needs at least one target").into());
        }
        let joints: Vec<SerialJoint> = self
            .joints
            .iter()
            .enumerate()
            .map(|(i, j)| {
                let alpha_rad = j.alpha_deg.to_radians();
                let near = i > 0 && alpha_rad.sin().abs() < NEAR_PARALLEL_RAD && !j.prismatic;
                SerialJoint {
                    alpha_rad,
                    a_mm: j.a_mm,
                    theta_rad: j.theta_deg.to_radians(),
                    d_mm: j.d_mm,
                    prismatic: j.prismatic,
                    parallel: j.parallel.unwrap_or(near),
                }
            })
            .collect();
        let gravity = crate::pose::unit(self.gravity).ok_or_else(|| {
            Message::error("`gravity` has no direction").expected("a direction in the base, e.g. [0, 0, -1]")
        })?;
        let serial = Serial::new(&joints, targets, gravity, &self.bending, &self.coupling);
        Ok(serial.with_base_turn_y(self.base_turn_y_deg.to_radians()))
    }

    /// Nominal values of `robot` with those of the file in their places.
    fn nominal_of(&self, robot: &dyn Robot) -> Result<Vec<f64>> {
        let mut values = robot.nominal();
        for (name, value) in &self.nominal {
            let Some(i) = robot.index(name) else {
                let names = robot.parameters().iter().map(|p| p.name.as_str());
                let what = format!("[nominal] names `{name}`, which is no parameter of this robot");
                return Err(Message::error(what).hint_names(name, names).into());
            };
            values[i] = robot.parameters()[i].quantity.inward(*value);
        }
        Ok(values)
    }
}
