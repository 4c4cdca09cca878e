//! Physical effects of the parameters of a robot: from their columns of the Jacobian, or from the
//! model if the columns do not show the effect.

use etalon_robots::{Effect, Parameter, Quantity, Robot, Role};

/// Minimum cosine between two columns of the Jacobian that count as one motion.
const PARALLEL: f64 = 1e-9;
/// Number of poses that is sufficient for the decision.
const POSES: usize = 24;
/// Place (mm) in the flange of a target without a nominal place. At the origin of the flange, which
/// may be on the axis of a joint, a target does not show the motion of this joint.
const PLACE_MM: [f64; 3] = [97.0, 61.0, 43.0];

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

/// Nominal values, with places of targets that have none.
fn with_places(robot: &dyn Robot) -> Vec<f64> {
    let place = |p: &Parameter| {
        let is_free = p.role == Role::Target && p.quantity == Quantity::Length && !p.tolerance.is_finite();
        p.axis.filter(|_| is_free).and_then(|axis| PLACE_MM.get(axis)).copied().unwrap_or(0.0)
    };
    robot.nominal().iter().zip(robot.parameters()).map(|(value, p)| value + place(p)).collect()
}

fn effects_at(robot: &dyn Robot, poses: &[&[f64]]) -> Vec<Option<Effect>> {
    let (n, joints) = (robot.parameters().len(), robot.joints().len());
    let rows = robot.dimension() * robot.targets().len();
    let nominal = with_places(robot);
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

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_robots::{Serial, SerialJoint};
    use std::f64::consts::FRAC_PI_2;

    /// At its origin, the flange of this arm is on axis 5, and the length along this axis moves it
    /// as joint 4 does.
    #[test]
    fn zeros_are_found_if_the_flange_is_on_the_axis_of_a_joint() {
        let joint = |(quarters, a_mm, theta_rad, d_mm): (f64, f64, f64, f64)| SerialJoint {
            alpha_rad: quarters * FRAC_PI_2,
            a_mm,
            theta_rad,
            d_mm,
            prismatic: false,
            parallel: quarters == 0.0,
        };
        let rows = [
            (0.0, 0.0, FRAC_PI_2, 424.0),
            (1.0, 0.0, FRAC_PI_2, 0.0),
            (0.0, 56.0, 0.0, 0.0),
            (-1.0, 130.0, FRAC_PI_2, 225.0),
            (-1.0, 183.0, -FRAC_PI_2, 0.0),
            (1.0, 0.0, 0.0, 0.0),
        ];
        let robot = Serial::new(&rows.map(joint), &["ball".to_owned()], [0.0, 0.0, -1.0], &[], &[]);
        let poses: Vec<Vec<f64>> = (0..8).map(|i| (0..6).map(|j| f64::from(3 * i + 5 * j).sin()).collect()).collect();
        let found = effects(&robot, poses.iter().map(Vec::as_slice));
        let effect = |name: &str| found[robot.index(name).unwrap()];
        for joint in 1..=6 {
            assert_eq!(effect(&format!("theta_{joint}")), Some(Effect::Zeros), "joint {joint}");
        }
        assert_eq!(effect("d_5"), Some(Effect::Geometry));
    }
}
