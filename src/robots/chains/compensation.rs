//! Compensation of a controller that computes with nominal geometry (thesis, 1.2.4.4). The pose to
//! command is the pose of the nominal robot at the joint values that bring the identified robot to
//! the target.

use crate::{JointRange, Kinematics, Quantity};
use etalon_base::catalogue::Phrase;
use etalon_base::phrase;
use etalon_base::pose::{Pose, Vector, minus, norm};
use nalgebra::{DMatrix, DVector};
use std::f64::consts::TAU;

/// Errors of joints that the parameters do not describe.
pub trait Correction: Send + Sync {
    /// Share of the correction at joint values: 1 where it was measured, 0 far beyond.
    fn share(&self, joints: &[f64]) -> f64;

    /// Parameters and joint values with which the model has the position of the robot.
    fn applied(&self, parameters: &[f64], joints: &[f64]) -> (Vec<f64>, Vec<f64>);
}

/// A robot with nominal and identified parameters.
pub struct Calibrated<'a> {
    /// Kinematics of the robot.
    pub arm: &'a dyn Kinematics,
    /// Parameters of the controller (mm, rad).
    pub nominal: Vec<f64>,
    /// Identified parameters (mm, rad).
    pub identified: Vec<f64>,
    /// Errors that the identified parameters do not describe.
    pub field: Option<&'a dyn Correction>,
}

/// Command for a target.
#[derive(Clone, Debug, PartialEq)]
pub struct Compensated {
    /// Joint values, followed by the assembly mode, that bring the identified robot to the target
    /// (mm, rad).
    pub joints: Vec<f64>,
    /// Pose to command: the pose of the nominal robot at `joints`.
    pub command: Pose,
}

/// Maximum change of a joint by compensation within the same configuration (rad).
const SAME_RAD: f64 = 0.5;
/// Number of points between two configurations at which a singularity is looked for.
const BETWEEN: i32 = 16;
/// Measures of singularity below this are zero.
const SINGULAR: f64 = 1e-9;
/// Maximum distance (mm) and angle (rad) of the pose at given joint values from its target if the
/// joint values belong to the target, and do not only select a configuration.
const STATED: [f64; 2] = [1.0, 1e-3];

/// Fixed-point corrections of joint values end if the last correction is below this (mm or rad), or
/// after the maximum number. Each correction removes the effect of the robot's errors on the
/// previous one.
const LAST_CORRECTION: f64 = 1e-12;
const MOST_CORRECTIONS: usize = 50;
/// Maximum remaining position error after the corrections (mm).
const LARGEST_LEFT_MM: f64 = 1e-6;

impl Calibrated<'_> {
    /// Joint values nearest to `near` by which the controller reaches a target without
    /// compensation: `near` if they reach the target. For a target that only the identified
    /// robot reaches, the joint values of the identified robot.
    ///
    /// # Errors
    ///
    /// Describes the limit that forbids the target.
    pub fn uncompensated(&self, target: &Pose, near: &[f64]) -> Result<Vec<f64>, Phrase> {
        let [away_mm, turned_rad] = STATED;
        let complete = near.len() >= self.arm.joints().len() + usize::from(self.arm.has_assembly_modes());
        let there = complete.then(|| self.arm.tool_pose(&self.nominal, near)).flatten();
        let is_there = there.is_some_and(|there| {
            let off_mm = norm(minus(there.translation_mm, target.translation_mm));
            off_mm <= away_mm && there.inverse().then(target).angle_rad() <= turned_rad
        });
        if is_there && self.arm.limit_violation(&self.nominal, near).is_none() {
            return Ok(near.to_vec());
        }
        let nominal = self.arm.nearest_joints(&self.nominal, target, near);
        nominal.or_else(|_| self.arm.nearest_joints(&self.identified, target, near))
    }

    /// Pose to command for a target that the controller reaches at the joint values
    /// `uncompensated`.
    ///
    /// # Errors
    ///
    /// Describes the limit that forbids the target.
    pub fn compensate(&self, target: &Pose, uncompensated: &[f64]) -> Result<Compensated, Phrase> {
        let joints = self.solved(target, uncompensated)?;
        let command = self.arm.tool_pose(&self.nominal, &joints).ok_or_else(|| phrase!("out-of-nominal-reach"))?;
        if let Some(why) = self.arm.limit_violation(&self.nominal, &joints) {
            return Err(phrase!("command-refused", reason = why));
        }
        Ok(Compensated { joints, command })
    }

    /// `true` if the nominal robot goes from joint values to others without a long motion, and
    /// without crossing a singularity.
    pub fn same_configuration(&self, from: &[f64], to: &[f64]) -> bool {
        let angles = self.arm.joints().iter().zip(from.iter().zip(to));
        let mut angles = angles.filter(|(joint, _)| joint.quantity == Quantity::Angle);
        if angles.any(|(_, (a, b))| (a - b).abs() > SAME_RAD) || from.len() != to.len() {
            return false;
        }
        let mut signs: Vec<f64> = Vec::new();
        (0..=BETWEEN).all(|k| {
            let share = f64::from(k) / f64::from(BETWEEN);
            let q: Vec<f64> = from.iter().zip(to).map(|(a, b)| a + share * (b - a)).collect();
            let measures = self.arm.singularity_measures(&self.nominal, &q);
            signs.resize(measures.len(), 0.0);
            signs.iter_mut().zip(measures).filter(|(_, measure)| measure.abs() > SINGULAR).all(|(sign, measure)| {
                let same = *sign * measure >= 0.0;
                *sign = measure;
                same
            })
        })
    }

    /// Joint values nearest to `near` that bring the robot to a pose, without the full turns by
    /// which a joint without limits would leave `near`.
    fn continued(&self, parameters: &[f64], target: &Pose, near: &[f64]) -> Result<Vec<f64>, Phrase> {
        let joints = self.arm.nearest_joints(parameters, target, near)?;
        let mut turned = joints.clone();
        for (i, (q, near)) in turned.iter_mut().zip(near).enumerate().take(self.arm.joints().len()) {
            let limited = matches!(self.arm.joint_range(i), JointRange::Limits(_));
            if self.arm.joints()[i].quantity == Quantity::Angle && !limited {
                let turn = TAU / self.arm.nominal_gain(i).abs();
                *q -= ((*q - near) / turn).round() * turn;
            }
        }
        if turned == joints { Ok(joints) } else { self.arm.nearest_joints(parameters, target, &turned) }
    }

    /// Joint values nearest to `near` that bring the identified robot with its field to a pose.
    fn solved(&self, target: &Pose, near: &[f64]) -> Result<Vec<f64>, Phrase> {
        let mut joints = self.continued(&self.identified, target, near)?;
        let Some(field) = self.field else { return Ok(joints) };
        // q + δq(q) is solved for; δq varies slowly
        for _ in 0..MOST_CORRECTIONS {
            let (parameters, moved) = field.applied(&self.identified, &joints);
            let wanted = self.continued(&parameters, target, &moved)?;
            let step: Vec<f64> = wanted.iter().zip(&moved).map(|(wanted, moved)| wanted - moved).collect();
            joints.iter_mut().zip(&step).for_each(|(q, step)| *q += step);
            if step.iter().all(|step| step.abs() < LAST_CORRECTION) {
                break;
            }
        }
        Ok(joints)
    }

    /// Joint values of the controller, at joint values near `near`, when it is commanded a pose.
    ///
    /// # Errors
    ///
    /// Describes the limit that forbids the command.
    pub fn commanded(&self, command: &Pose, near: &[f64]) -> Result<Vec<f64>, Phrase> {
        self.continued(&self.nominal, command, near)
    }

    /// Pose of the identified robot at joint values.
    ///
    /// # Errors
    ///
    /// Fails if the joint values admit no pose.
    pub fn at_joints(&self, joints: &[f64]) -> Result<Pose, Phrase> {
        let pose = match self.field {
            Some(field) => {
                let (parameters, joints) = field.applied(&self.identified, joints);
                self.arm.tool_pose(&parameters, &joints)
            }
            None => self.arm.tool_pose(&self.identified, joints),
        };
        pose.ok_or_else(|| phrase!("joints-admit-no-pose"))
    }

    /// Deviation along x, y or z (`axes`) of a robot that is commanded positions (mm): desired
    /// position minus the position to command, zero along other axes. The other coordinates of
    /// `wanted` are kept. `near` holds the joint values before the motion and is replaced by those
    /// after it.
    ///
    /// # Errors
    ///
    /// Describes the limit that forbids a command.
    pub fn position_deviation(&self, wanted: &Pose, axes: &[usize], near: &mut Vec<f64>) -> Result<Vector, Phrase> {
        let (mut command, mut left_mm) = (*wanted, 0.0);
        for _ in 0..MOST_CORRECTIONS {
            near.clone_from(&self.arm.nearest_joints(&self.nominal, &command, near)?);
            let off = minus(self.at_joints(near)?.translation_mm, wanted.translation_mm);
            axes.iter().for_each(|&axis| command.translation_mm[axis] -= off[axis]);
            left_mm = axes.iter().fold(0.0, |most: f64, &axis| most.max(off[axis].abs()));
            if left_mm < LAST_CORRECTION {
                break;
            }
        }
        if left_mm > LARGEST_LEFT_MM {
            return Err(phrase!("no-command-leads-there", left_mm));
        }
        Ok(minus(wanted.translation_mm, command.translation_mm))
    }

    /// Deviation of a joint by its own errors (mm or rad): commanded value minus the value at which
    /// the joint moves by the commanded amount. `None` for a joint without its own errors.
    pub fn joint_deviation(&self, commanded: &[f64], joint: usize) -> Option<f64> {
        let mut q = commanded.to_vec();
        for _ in 0..MOST_CORRECTIONS {
            let deviation = self.arm.joint_travel(&self.identified, &q, joint)? - commanded[joint];
            q[joint] -= deviation;
            if deviation.abs() < LAST_CORRECTION {
                break;
            }
        }
        Some(commanded[joint] - q[joint])
    }

    /// Deviations of several joints together (mm or rad): commanded values minus the values at
    /// which the first target of the identified robot is nearest to its position on the nominal
    /// robot. `None` if the joints cannot move the target independently.
    pub fn joint_deviations(&self, commanded: &[f64], joints: &[usize]) -> Option<Vec<f64>> {
        let (arm, d, all) = (self.arm, self.arm.dimension(), self.arm.joints().len());
        let wanted = arm.position(&self.nominal, commanded, 0);
        let (mut q, mut jacobian) = (commanded.to_vec(), vec![0.0; d * arm.targets().len() * all]);
        for _ in 0..MOST_CORRECTIONS {
            let at = arm.position(&self.identified, &q, 0);
            arm.joint_jacobian(&self.identified, &q, &mut jacobian);
            let moves = DMatrix::from_fn(d, joints.len(), |row, column| jacobian[row * all + joints[column]]);
            let off = DVector::from_fn(d, |row, _| at[row] - wanted[row]);
            let step = (moves.transpose() * &moves).cholesky()?.solve(&(moves.transpose() * off));
            joints.iter().zip(&step).for_each(|(&joint, step)| q[joint] -= step);
            if step.amax() < LAST_CORRECTION {
                break;
            }
        }
        Some(joints.iter().map(|&joint| commanded[joint] - q[joint]).collect())
    }
}
