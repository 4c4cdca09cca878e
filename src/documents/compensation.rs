//! Answer of `etalon compensate`.

use crate::worded::worded;
use etalon_base::worded::Worded;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Commands with which the identified robot reaches its targets although its controller computes
/// with nominal geometry.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CompensationDocument {
    /// Schema and version: `etalon/compensation/1`.
    pub schema: String,
    /// Model of the robot.
    pub robot: String,
    /// Column names of the joints with their units, and of the assembly mode if there are several.
    pub joints: Vec<String>,
    /// One entry for each reachable target.
    pub targets: Vec<CompensatedTarget>,
    /// Targets that are out of reach or beyond a limit.
    pub unreachable: Vec<UnreachableTarget>,
    /// Number of targets of a program that are joint values; they are left unchanged.
    pub joint_targets: usize,
}

/// A target and the command that reaches it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CompensatedTarget {
    /// Name of the target.
    pub target: String,
    /// Desired position (mm).
    pub xyz_mm: [f64; 3],
    /// Desired orientation: unit quaternion w, x, y, z.
    pub quaternion: [f64; 4],
    /// Position to command (mm).
    pub command_xyz_mm: [f64; 3],
    /// Orientation to command: unit quaternion w, x, y, z.
    pub command_quaternion: [f64; 4],
    /// Joint values of the command (mm or deg), in the order of the columns.
    pub joints: Vec<f64>,
    /// Remaining position error (mm): position of the identified robot with the command as written
    /// minus the desired position.
    pub residual_mm: f64,
    /// Remaining orientation error (deg).
    pub residual_deg: f64,
    /// `true` if the command has the configuration of the uncompensated target: working mode,
    /// assembly mode or configuration data.
    pub same_configuration: bool,
}

/// A target that cannot be commanded.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct UnreachableTarget {
    /// Name of the target.
    pub target: String,
    /// Limit that forbids the target, or that the target is out of reach.
    #[serde(flatten, with = "UnreachableTargetReason")]
    pub reason: Worded,
}

worded! {
    /// Limit that forbids the target, or that the target is out of reach.
    text UnreachableTargetReason: reason, reason_phrase
}
