//! The value of a joint from a home switch or a second encoder.

use super::{At, Equation};

/// Independently measured value of a joint. Residual: the joint value by the model (the logged
/// value with gain, offset and other errors) minus the measured one (mm or rad).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointValue {
    /// Index of the joint.
    pub joint: usize,
    /// The value.
    pub value: f64,
    /// `true` if the value is an angle.
    pub is_angle: bool,
}

impl Equation for JointValue {
    fn residuals(&self, at: &At, out: &mut [f64]) {
        let model = at.arm.and_then(|arm| arm.joint_value(at.values, at.joints, self.joint, &mut |_, _| ()));
        out[0] = model.unwrap_or(f64::NAN) - self.value;
    }

    fn jacobian(&self, at: &At, _: &[f64], out: &mut [f64]) {
        let Some(arm) = at.arm else { return };
        arm.joint_value(at.values, at.joints, self.joint, &mut |parameter, by| out[parameter] += by);
    }

    fn is_angle(&self) -> bool {
        self.is_angle
    }

    fn has_length(&self) -> bool {
        !self.is_angle
    }

    fn depends_on_target(&self) -> bool {
        false
    }

    fn moving(&self, _: usize) -> Option<usize> {
        None
    }
}
