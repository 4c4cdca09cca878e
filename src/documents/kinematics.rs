//! Answer of `etalon kinematics`.

use crate::worded::worded;
use etalon_base::catalogue::Phrase;
use etalon_base::pose_name::PoseName;
use etalon_base::worded::Worded;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Poses with their joint values.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct KinematicsDocument {
    /// Schema and version: `etalon/kinematics/1`.
    pub schema: String,
    /// Model of the robot.
    pub robot: String,
    /// Column names of the joints with their units, and of the assembly mode if there are several.
    pub joints: Vec<String>,
    /// One entry for each row of the table, or for each solution.
    pub poses: Vec<KinematicsEntry>,
    /// Poses that the robot cannot reach.
    pub unreachable: Vec<UnreachablePose>,
}

/// A pose of the tool in the base frame with joint values.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct KinematicsEntry {
    /// Name of the pose.
    pub pose: PoseName,
    /// Joint values (mm or deg), in the order of the columns.
    pub joints: Vec<f64>,
    /// Position (mm).
    pub xyz_mm: [f64; 3],
    /// Orientation: unit quaternion w, x, y, z.
    pub quaternion: [f64; 4],
    /// Joints that can move without moving the tool, at a singular pose; of all solutions, the
    /// joint values are then the nearest to the start.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub free_joints: Vec<String>,
}

/// A pose without solution.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct UnreachablePose {
    /// Name of the pose.
    pub pose: PoseName,
    /// Limit that forbids the pose, or that the pose is out of reach.
    #[serde(flatten, with = "UnreachablePoseReason")]
    pub reason: Worded,
}

worded! {
    /// Limit that forbids the pose, or that the pose is out of reach.
    text UnreachablePoseReason: reason, reason_phrase
}

impl UnreachablePose {
    /// A pose without solution.
    pub fn new(pose: PoseName, reason: Phrase) -> Self {
        Self { pose, reason: reason.into() }
    }
}
