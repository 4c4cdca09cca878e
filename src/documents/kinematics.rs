//! What `etalon kinematics` answers.

use etalon_base::pose_name::PoseName;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Poses and joint values that belong together.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct KinematicsDocument {
    /// `etalon/kinematics/1`
    pub schema: String,
    /// Model of the robot.
    pub robot: String,
    /// Names of the columns of joints: with their units, and the assembly mode where there are several.
    pub joints: Vec<String>,
    /// One for each row of the table, or for each solution.
    pub poses: Vec<KinematicsEntry>,
    /// Poses that the robot does not reach.
    pub unreachable: Vec<UnreachablePose>,
}

/// A pose of the tool in the base frame with joint values.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct KinematicsEntry {
    /// Name of the pose.
    pub pose: PoseName,
    /// Joint values in mm and deg, in the order of the columns.
    pub joints: Vec<f64>,
    /// Position, mm.
    pub xyz_mm: [f64; 3],
    /// Orientation: unit quaternion w, x, y, z.
    pub quaternion: [f64; 4],
}

/// A pose that no joint values lead to.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct UnreachablePose {
    /// Name of the pose.
    pub pose: PoseName,
    /// Which limit forbids it, or that it is out of reach.
    pub reason: String,
}
