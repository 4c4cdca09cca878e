//! Physical effects of the parameters of a robot: from their columns of the Jacobian, or from the
//! model if the columns do not show the effect.

use etalon_robots::{Effect, Parameter, Quantity, Robot, Role};

/// Minimum cosine between two columns of the Jacobian that count as one motion.
const PARALLEL: f64 = 1e-9;
/// Number of poses that is sufficient for the decision.
const POSES: usize = 24;

/// Effects of the robot itself that are identified.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Effects {
    /// All effects of the model.
    #[default]
    All,
    /// All effects except the transmission ratios of revolute joints of arms, whose encoders count
    /// whole turns and therefore have no unknown ratio, and except effects that depend on other
    /// values of a reading, which are identified only on request.
    Usual,
    /// These effects.
    These(Vec<Effect>),
}

impl Effects {
    /// For each parameter of `robot`, `true` if it is identified at these joint values; always
    /// `true` for base, targets and fixtures.
    pub(crate) fn include<'j>(&self, robot: &dyn Robot, joints: impl Iterator<Item = &'j [f64]>) -> Vec<bool> {
        let parameters = robot.parameters();
        match self {
            Self::All => vec![true; parameters.len()],
            Self::Usual => {
                let arm = robot.free_base().is_some();
                let turning = |joint: usize| robot.joints()[joint].quantity == Quantity::Angle;
                let ratio = |p: &Parameter| arm && p.effect == Effect::Gains && p.joint.is_some_and(turning);
                parameters.iter().map(|p| p.role != Role::Robot || !(ratio(p) || p.effect.needs_proof())).collect()
            }
            Self::These(chosen) => {
                let is_chosen = |effect: Option<Effect>| effect.is_none_or(|effect| chosen.contains(&effect));
                effects_at(robot, &joints.collect::<Vec<_>>()).into_iter().map(is_chosen).collect()
            }
        }
    }
}

/// Returns the effect of each parameter at poses with these joint values; `None` for base and
/// targets.
pub fn effects<'j>(robot: &dyn Robot, joints: impl Iterator<Item = &'j [f64]>) -> Vec<Option<Effect>> {
    effects_at(robot, &joints.collect::<Vec<_>>())
}

fn effects_at(robot: &dyn Robot, poses: &[&[f64]]) -> Vec<Option<Effect>> {
    let (n, joints) = (robot.parameters().len(), robot.joints().len());
    let rows = robot.dimension() * robot.targets().len();
    let nominal = robot.nominal();
    let (mut by_parameter, mut by_joint) = (vec![0.0; rows * n], vec![0.0; rows * joints]);
    // sums of products over all poses: parameter with parameter, joint with joint, parameter with
    // joint
    let (mut own, mut other, mut mixed) = (vec![0.0; n], vec![0.0; joints], vec![0.0; n * joints]);
    for q in poses.iter().step_by(poses.len().div_ceil(POSES).max(1)) {
        robot.jacobian(&nominal, q, &mut by_parameter);
        robot.joint_jacobian(&nominal, q, &mut by_joint);
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
