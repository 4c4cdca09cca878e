//! Compensation of a controller that computes with nominal geometry (thesis, 1.2.4.4): the pose to command is where the nominal robot
//! is at the joint values that bring the identified robot to the target.

use super::{Kinematics, Quantity};
use crate::base::pose::Pose;

/// A robot as its controller has it, and as it is.
pub struct Calibrated<'a> {
    /// The robot.
    pub arm: &'a dyn Kinematics,
    /// Parameters that the controller computes with, mm and rad.
    pub nominal: Vec<f64>,
    /// Identified parameters, mm and rad.
    pub identified: Vec<f64>,
}

/// What to command for a target.
#[derive(Clone, Debug, PartialEq)]
pub struct Compensated {
    /// Joint values (and the assembly mode behind them) that bring the identified robot to the target, mm and rad.
    pub joints: Vec<f64>,
    /// The pose to command: that of the nominal robot there.
    pub command: Pose,
    /// No singularity is between these joint values and those of the target without compensation.
    pub same_configuration: bool,
}

/// Compensation turns no joint further than this in the same configuration, rad.
const SAME_RAD: f64 = 0.5;

impl Calibrated<'_> {
    /// Joint values by which the controller reaches a target without compensation: those nearest to `near`. A target that only the
    /// identified robot reaches has those of that.
    ///
    /// # Errors
    /// What forbids the target.
    pub fn uncompensated(&self, target: &Pose, near: &[f64]) -> Result<Vec<f64>, String> {
        let nominal = self.arm.nearest_joints(&self.nominal, target, near);
        nominal.or_else(|_| self.arm.nearest_joints(&self.identified, target, near))
    }

    /// The pose to command for a target that the controller reaches at the joint values `uncompensated`.
    ///
    /// # Errors
    /// What forbids the target.
    pub fn compensate(&self, target: &Pose, uncompensated: &[f64]) -> Result<Compensated, String> {
        let joints = self.arm.nearest_joints(&self.identified, target, uncompensated)?;
        let command = self.arm.tool_pose(&self.nominal, &joints).ok_or("out of reach of the nominal robot")?;
        if let Some(why) = self.arm.limit_violation(&self.nominal, &joints) {
            return Err(format!("the controller refuses its command: {why}"));
        }
        let turned = |i: usize| (joints[i] - uncompensated[i]).abs() > SAME_RAD;
        let angles = self.arm.joints().iter().enumerate().filter(|(_, joint)| joint.quantity == Quantity::Angle);
        let branch = |q: &[f64]| self.arm.branch(&self.nominal, q);
        let same_configuration =
            !angles.into_iter().any(|(i, _)| turned(i)) && branch(&joints) == branch(uncompensated);
        Ok(Compensated { joints, command, same_configuration })
    }

    /// Where the identified robot is when the controller, at joint values near `near`, is commanded a pose.
    ///
    /// # Errors
    /// What forbids the command.
    pub fn attained(&self, command: &Pose, near: &[f64]) -> Result<Pose, String> {
        let joints = self.arm.nearest_joints(&self.nominal, command, near)?;
        self.at_joints(&joints)
    }

    /// Where the identified robot is at joint values.
    ///
    /// # Errors
    /// It cannot be there.
    pub fn at_joints(&self, joints: &[f64]) -> Result<Pose, String> {
        let pose = self.arm.tool_pose(&self.identified, joints);
        pose.ok_or_else(|| "the robot cannot be where the joints put it".to_owned())
    }
}
