//! What the parameters of a robot describe: by their columns of the Jacobian where that shows it, else as the model has it.

use crate::Observation;
use etalon_robots::{Effect, Quantity, Robot, Role};

/// How nearly parallel two columns of the Jacobian are that are one and the same motion.
const PARALLEL: f64 = 1e-9;
/// Poses that are enough to tell.
const POSES: usize = 24;

/// The effect of each parameter; `None` of base and targets.
pub fn effects(robot: &dyn Robot, observations: &[Observation]) -> Vec<Option<Effect>> {
    let (n, joints) = (robot.parameters().len(), robot.joints().len());
    let rows = robot.dimension() * robot.targets().len();
    let nominal = robot.nominal();
    let (mut by_parameter, mut by_joint) = (vec![0.0; rows * n], vec![0.0; rows * joints]);
    // sums of products over all poses: parameter with parameter, joint with joint, parameter with joint
    let (mut own, mut other, mut mixed) = (vec![0.0; n], vec![0.0; joints], vec![0.0; n * joints]);
    for o in observations.iter().step_by(observations.len().div_ceil(POSES).max(1)) {
        robot.jacobian(&nominal, &o.joints, &mut by_parameter);
        robot.joint_jacobian(&nominal, &o.joints, &mut by_joint);
        for (p, q) in by_parameter.chunks_exact(n).zip(by_joint.chunks_exact(joints)) {
            for (i, p) in p.iter().enumerate() {
                own[i] += p * p;
                q.iter().enumerate().for_each(|(j, q)| mixed[i * joints + j] += p * q);
            }
            q.iter().zip(&mut other).for_each(|(q, sum)| *sum += q * q);
        }
    }
    let is_zero = |i: usize| {
        let apart = |j: usize| 1.0 - mixed[i * joints + j].powi(2) / (own[i] * other[j]);
        (0..joints).any(|j| apart(j).abs() < PARALLEL)
    };
    let of = |i: usize| {
        let p = &robot.parameters()[i];
        match p.effect {
            _ if p.role != Role::Robot => None,
            Effect::Geometry if p.quantity != Quantity::Ratio && is_zero(i) => Some(Effect::Zeros),
            effect => Some(effect),
        }
    };
    (0..n).map(of).collect()
}
