//! A robot with a residual field.

use super::JointField;
use etalon_robots::{Correction, Definition, JointRange, Platform, Robot};

/// Robot whose positions have the errors of a field. Derivatives are taken at the corrected
/// parameters and joint values, because the field varies slowly.
pub struct Corrected<'a> {
    robot: &'a dyn Robot,
    field: &'a JointField,
    definition: Definition,
}

impl<'a> Corrected<'a> {
    /// A robot with the errors of a field.
    pub fn new(robot: &'a dyn Robot, field: &'a JointField) -> Self {
        Self { robot, field, definition: robot.definition().clone() }
    }
}

impl Robot for Corrected<'_> {
    fn definition(&self) -> &Definition {
        &self.definition
    }

    fn definition_mut(&mut self) -> &mut Definition {
        &mut self.definition
    }

    fn positions(&self, parameters: &[f64], joints: &[f64], out: &mut [f64]) {
        let (parameters, joints) = self.field.applied(parameters, joints);
        self.robot.positions(&parameters, &joints, out);
    }

    fn jacobian(&self, parameters: &[f64], joints: &[f64], out: &mut [f64]) {
        let (parameters, joints) = self.field.applied(parameters, joints);
        self.robot.jacobian(&parameters, &joints, out);
    }

    fn joint_jacobian(&self, parameters: &[f64], joints: &[f64], out: &mut [f64]) {
        let (parameters, joints) = self.field.applied(parameters, joints);
        self.robot.joint_jacobian(&parameters, &joints, out);
    }

    fn has_assembly_modes(&self) -> bool {
        self.robot.has_assembly_modes()
    }

    fn approached(&self) -> &[usize] {
        self.robot.approached()
    }

    fn joints_of_base(&self) -> &[String] {
        self.robot.joints_of_base()
    }

    fn joint_range(&self, joint: usize) -> JointRange {
        self.robot.joint_range(joint)
    }

    fn platform(&self) -> Option<&dyn Platform> {
        self.robot.platform()
    }
}
