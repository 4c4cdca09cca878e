//! Torques of joints that hold links and payload against gravity.

use super::truth::Payload;
use super::{Scene, Turn};
use etalon_base::bounds::{MOST, at_most};
use etalon_base::noise::Noise;
use etalon_base::pose::{Pose, Vector, cross, dot, minus};
use etalon_robots::{Circumstance, Robot};
use schemars::JsonSchema;
use serde::Deserialize;

/// Stream of what friction adds to torques.
const FRICTION: u64 = 1 << 38;
/// Standard gravity (3rd CGPM 1901), in N·m for a mass of 1 kg on a lever of 1 mm.
const GRAVITY: f64 = 9.806_65e-3;
/// Direction of gravity in the base.
const DOWN: Vector = [0.0, 0.0, -1.0];

/// Torques of joints, as a controller logs them: torques of the drives, which hold the masses
/// against gravity along −z of the base.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Torques {
    /// Masses of the links.
    #[serde(default, rename = "mass")]
    pub masses: Vec<Mass>,
    /// Standard deviation of what friction adds to a logged torque.
    #[serde(default)]
    pub friction_nm: f64,
}

impl Scene<'_> {
    /// Payload, torques with friction, and temperature that stand behind the joint values of a
    /// measurement; the same for all its targets.
    pub(super) fn stated(&self, turn: Turn, joints: &[f64]) -> Vec<f64> {
        let mut friction = Noise::new(self.truth.seed, FRICTION + turn.number as u64);
        let stated = self.robot.circumstances().iter().zip(joints.iter().skip(self.robot.joints().len()));
        let value = |(what, value): (&Circumstance, &f64)| match what {
            Circumstance::Torque(_) => value + friction.gaussian(self.truth.torques.friction_nm),
            _ => *value,
        };
        stated.map(value).collect()
    }
}

/// Mass of a link.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Mass {
    /// Joint that moves the link, from 1.
    #[serde(deserialize_with = "at_most::<_, _, MOST>")]
    pub joint: usize,
    /// Mass.
    pub kg: f64,
    /// Centre of mass in the base at joint values zero.
    pub at_mm: Vector,
}

impl Torques {
    /// Torque of each joint (N·m) at joint values, with a payload in the flange; zero for robots
    /// that are no single chain.
    pub(super) fn at(&self, robot: &dyn Robot, joints: &[f64], load: Payload) -> Vec<f64> {
        let Some(chain) = robot.joint_chain(&robot.nominal()) else { return vec![0.0; robot.joints().len()] };
        let (mut here, mut zero) = (Pose::identity(), Pose::identity());
        // frames of the joints, each with its frame at joint values zero
        let mut frames = Vec::new();
        for (joint, q) in chain.joints.iter().zip(joints) {
            zero = zero.then(&joint.origin);
            let moved = joint.gain * q;
            here = here.then(&joint.origin);
            here = if joint.prismatic { here.shift(2, moved) } else { here.turn_z(moved) };
            frames.push((here, zero));
        }
        let flange = here.then(&chain.flange);
        let of_link = |mass: &Mass| {
            let k = mass.joint.saturating_sub(1).min(frames.len().saturating_sub(1));
            let (here, zero) = frames.get(k)?;
            Some((k, mass.kg, here.apply(zero.inverse().apply(mass.at_mm))))
        };
        let payload = (frames.len().saturating_sub(1), load.kg, flange.apply(load.xyz_mm));
        let all: Vec<(usize, f64, Vector)> = self.masses.iter().filter_map(of_link).chain([payload]).collect();
        let torque = |(j, (frame, _)): (usize, &(Pose, Pose))| {
            let beyond = all.iter().filter(|(k, ..)| *k >= j);
            let moment = beyond
                .map(|(_, kg, at)| dot(frame.axis(2), cross(minus(*at, frame.translation_mm), DOWN)) * kg * GRAVITY);
            -moment.sum::<f64>()
        };
        frames.iter().enumerate().map(torque).collect()
    }
}
