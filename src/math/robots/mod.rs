//! Robots as functions of their parameters: direct and inverse kinematics, exact Jacobians.
//!
//! Each model is written once, generic over the [`Scalar`](crate::base::scalar::Scalar); nothing here knows a file.
//! Lengths are in millimetres, angles in radians.

mod definition;
mod five_bar;
mod five_bar_reach;
mod prexyt;
mod serial;
mod serial_chain;

pub use definition::{Definition, Joint, Parameter, Quantity, Role};
pub use five_bar::{FiveBar, Linkage, WORKING_MODES};
pub use five_bar_reach::{Configuration, Reach, SingularityDistance};
pub use prexyt::{PlanarPose, Prexyt};
pub use serial::{Serial, SerialJoint};

use crate::base::pose::Vector;

/// A robot whose targets are seen by a measuring system.
pub trait Robot: Send + Sync {
    /// Short name of the model: `prexyt`, `five_bar`, `serial` ...
    fn model(&self) -> &'static str;

    /// Parameters, joints and targets.
    fn definition(&self) -> &Definition;

    /// The parameters, in the order in which every slice of parameters comes.
    fn parameters(&self) -> &[Parameter] {
        &self.definition().parameters
    }

    /// The joints, in the order in which every slice of joint values comes.
    fn joints(&self) -> &[Joint] {
        &self.definition().joints
    }

    /// Names of the targets on the moving part.
    fn targets(&self) -> &[String] {
        &self.definition().targets
    }

    /// Coordinates measured per target: 2 for planar robots (x, y), 3 in space.
    fn dimension(&self) -> usize;

    /// Writes the positions of all targets in the world (mm), `dimension` values each.
    fn positions(&self, parameters: &[f64], joints: &[f64], out: &mut [f64]);

    /// Writes d positions / d parameters, row by row: (targets × dimension) × parameters.
    fn jacobian(&self, parameters: &[f64], joints: &[f64], out: &mut [f64]);

    /// Whether joint values leave two positions: the assembly mode, +1 or -1, then stands behind the joints in every slice
    /// of joint values.
    fn has_assembly_modes(&self) -> bool {
        false
    }

    /// Joint values of every way to bring the only target to a position in the world, where the model knows.
    fn configurations(&self, _parameters: &[f64], _position: Vector) -> Vec<Vec<f64>> {
        Vec::new()
    }

    /// Joint values (and the assembly mode behind them) that bring the only target to a position in the world, the way that
    /// is nearest to the joint values `near`; `None` where it is out of reach or the model does not know.
    fn reach(&self, _parameters: &[f64], _near: &[f64], _position: Vector) -> Option<Vec<f64>> {
        None
    }

    /// Why the robot cannot go to joint values (and the assembly mode behind them), where limits are stated and they are beyond.
    fn beyond(&self, _parameters: &[f64], _joints: &[f64]) -> Option<String> {
        None
    }

    /// The planar model, for robots that have one: pose residuals (eq. 3.26) and orientation errors need it.
    fn planar(&self) -> Option<&Prexyt> {
        None
    }

    /// The serial model, for robots that are serial: base and targets are searched from anywhere.
    fn serial(&self) -> Option<&Serial> {
        None
    }

    /// What to measure so that these parameters can be told apart, where the model knows.
    fn remedy(&self, _names: &[&str]) -> Option<&'static str> {
        None
    }

    /// Index of a parameter by name.
    fn index(&self, name: &str) -> Option<usize> {
        self.parameters().iter().position(|p| p.name == name)
    }

    /// Nominal values of all parameters.
    fn nominal(&self) -> Vec<f64> {
        self.parameters().iter().map(|p| p.nominal).collect()
    }

    /// The position of one target as a point in space; planar robots have z = 0.
    fn position(&self, parameters: &[f64], joints: &[f64], target: usize) -> Vector {
        let d = self.dimension();
        let mut all = vec![0.0; d * self.targets().len()];
        self.positions(parameters, joints, &mut all);
        let mut p = [0.0; 3];
        p[..d].copy_from_slice(&all[target * d..][..d]);
        p
    }
}
