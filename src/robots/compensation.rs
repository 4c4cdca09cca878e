//! Compensation of a controller that computes with nominal geometry (thesis, 1.2.4.4). The pose to
//! command is the pose of the nominal robot at the joint values that bring the identified robot to
//! the target.

use super::{Kinematics, Quantity};
use etalon_base::catalogue::Phrase;
use etalon_base::phrase;
use etalon_base::pose::{Pose, Vector, minus};
use nalgebra::{DMatrix, DVector};

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
    /// `true` if no singularity separates `joints` from the joint values of the uncompensated
    /// target.
    pub same_configuration: bool,
}

/// Largest change of a joint by compensation within the same configuration (rad).
const SAME_RAD: f64 = 0.5;

/// Fixed-point corrections of joint values end if the last correction is below this (mm or rad), or
/// after the maximum number. Each correction removes the effect of the robot's errors on the
/// previous one.
const LAST_CORRECTION: f64 = 1e-12;
const MOST_CORRECTIONS: usize = 50;
/// Largest remaining position error after the corrections (mm).
const LARGEST_LEFT_MM: f64 = 1e-6;

impl Calibrated<'_> {
    /// Joint values nearest to `near` by which the controller reaches a target without
    /// compensation. For a target that only the identified robot reaches, the joint values of the
    /// identified robot.
    ///
    /// # Errors
    ///
    /// Describes the limit that forbids the target.
    pub fn uncompensated(&self, target: &Pose, near: &[f64]) -> Result<Vec<f64>, Phrase> {
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
        let turned = |i: usize| (joints[i] - uncompensated[i]).abs() > SAME_RAD;
        let angles = self.arm.joints().iter().enumerate().filter(|(_, joint)| joint.quantity == Quantity::Angle);
        let branch = |q: &[f64]| self.arm.branch(&self.nominal, q);
        let same_configuration =
            !angles.into_iter().any(|(i, _)| turned(i)) && branch(&joints) == branch(uncompensated);
        Ok(Compensated { joints, command, same_configuration })
    }

    /// Joint values nearest to `near` that bring the identified robot with its field to a pose.
    fn solved(&self, target: &Pose, near: &[f64]) -> Result<Vec<f64>, Phrase> {
        let mut joints = self.arm.nearest_joints(&self.identified, target, near)?;
        let Some(field) = self.field else { return Ok(joints) };
        // q + δq(q) is solved for; δq varies slowly
        for _ in 0..MOST_CORRECTIONS {
            let (parameters, moved) = field.applied(&self.identified, &joints);
            let wanted = self.arm.nearest_joints(&parameters, target, &moved)?;
            let step: Vec<f64> = wanted.iter().zip(&moved).map(|(wanted, moved)| wanted - moved).collect();
            joints.iter_mut().zip(&step).for_each(|(q, step)| *q += step);
            if step.iter().all(|step| step.abs() < LAST_CORRECTION) {
                break;
            }
        }
        Ok(joints)
    }

    /// Pose that the identified robot attains when the controller, at joint values near `near`, is
    /// commanded a pose.
    ///
    /// # Errors
    ///
    /// Describes the limit that forbids the command.
    pub fn attained(&self, command: &Pose, near: &[f64]) -> Result<Pose, Phrase> {
        let joints = self.arm.nearest_joints(&self.nominal, command, near)?;
        self.at_joints(&joints)
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
