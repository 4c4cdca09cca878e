//! What `etalon compensate` answers.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What to command so that the identified robot comes to its targets although its controller computes with nominal geometry.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CompensationDocument {
    /// `etalon/compensation/1`
    pub schema: String,
    /// Model of the robot.
    pub robot: String,
    /// Names of the columns of joints: with their units, and the assembly mode where there are several.
    pub joints: Vec<String>,
    /// One for each target that can be commanded.
    pub targets: Vec<CompensatedTarget>,
    /// Targets that are out of reach, or that a limit forbids.
    pub unreachable: Vec<UnreachableTarget>,
    /// Targets of a program that are joint values: they stay as they are.
    pub joint_targets: usize,
}

/// A target and what to command for it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CompensatedTarget {
    /// Name of the target.
    pub target: String,
    /// Position that is wanted, mm.
    pub xyz_mm: [f64; 3],
    /// Orientation that is wanted: unit quaternion w, x, y, z.
    pub quaternion: [f64; 4],
    /// Position to command, mm.
    pub command_xyz_mm: [f64; 3],
    /// Orientation to command: unit quaternion w, x, y, z.
    pub command_quaternion: [f64; 4],
    /// Joint values of the command in mm and deg, in the order of the columns.
    pub joints: Vec<f64>,
    /// Position of the identified robot there, with the command as it is written, minus the one that is wanted, mm.
    pub residual_mm: f64,
    /// Angle of its orientation from the one that is wanted, deg.
    pub residual_deg: f64,
    /// The command is in the configuration (working mode, assembly mode, configuration data) that the target has without compensation.
    pub same_configuration: bool,
}

/// A target that cannot be commanded.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct UnreachableTarget {
    /// Name of the target.
    pub target: String,
    /// Which limit forbids it, or that it is out of reach.
    pub reason: String,
}
