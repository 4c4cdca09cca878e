//! `features.json` and `frames.json`: fitted elements, and the world frame.

use crate::worded::worded;
use etalon_base::message::Message;
use etalon_base::pose::Vector;
use etalon_base::pose_name::PoseName;
use etalon_base::worded::Worded;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Fitted elements.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FeaturesDocument {
    /// Schema and version: `etalon/features/1`.
    pub schema: String,
    /// One entry per feature of the campaign.
    pub features: Vec<Feature>,
    /// Warnings of the fits.
    pub messages: Vec<Message>,
}

/// One fitted element, in the coordinates of the exports.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Feature {
    /// Name in the campaign.
    pub name: String,
    /// `plane`, `line`, `circle` or `cylinder`.
    pub element: String,
    /// Labels of its points.
    pub labels: Vec<String>,
    /// Number of points.
    pub points: usize,
    /// Point of the element: centroid, or centre of a circle.
    pub point_mm: Vector,
    /// Normal of a plane or circle, axis of a line or cylinder; a unit vector.
    pub direction: Vector,
    /// Radius of a circle or cylinder.
    pub radius_mm: Option<f64>,
    /// Root mean square of the orthogonal distances.
    pub rms_mm: f64,
    /// Largest orthogonal distance.
    pub max_mm: f64,
    /// Standard uncertainty from the residuals: of the radius, or of the point along the normal of
    /// a plane.
    pub standard_uncertainty_mm: Option<f64>,
}

/// Frames made from features and targets.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FramesDocument {
    /// Schema and version: `etalon/frames/1`.
    pub schema: String,
    /// World frame. If the frame is measured again at each pose, `export_T_world` is given for
    /// every pose.
    pub world: WorldFrame,
    /// Errors that no reading of the campaign can show, with the keys of measurements that can show
    /// them.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub not_controlled: Vec<Uncontrolled>,
}

/// An error that no reading can show.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Uncontrolled {
    /// Description of the error.
    #[serde(flatten, with = "UncontrolledWhat")]
    pub what: Worded,
    /// Labels, features or targets with the error; empty if it concerns all readings.
    pub points: Vec<String>,
    /// Keys of measurements that can show the error.
    pub keys: Vec<String>,
}

worded! {
    /// Description of the error.
    text UncontrolledWhat: what, what_phrase
}

/// The world frame in the coordinates of the exports.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WorldFrame {
    /// Definition of the frame, in words.
    #[serde(flatten, with = "WorldFrameDefinition")]
    pub definition: Worded,
    /// `true` if z is dropped: observations are projected onto the xy plane of the world.
    pub planar: bool,
    /// One entry for all poses (without `pose` and `cycle`), or one entry per pose and cycle.
    pub poses: Vec<FramePose>,
    /// Covariance common to all poses if the frame is measured again at each pose: the covariance
    /// of the mean positions of the targets, which define the frame.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub common_covariance: Option<[[f64; 6]; 6]>,
    /// Root mean square distance of the targets from their best-fit positions; absent for 3-2-1
    /// frames, and for targets that were measured once.
    pub rms_mm: Option<f64>,
    /// Largest distance of a target from its best-fit position.
    pub max_mm: Option<f64>,
    /// Best-fit positions of the targets in the world, in the order of the definition.
    pub reference_mm: Vec<Vector>,
}

worded! {
    /// Definition of the frame, in words.
    text WorldFrameDefinition: definition, definition_phrase
}

/// Pose of a frame in the coordinates of the exports.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FramePose {
    /// Name of the pose; absent if the frame applies to all poses.
    pub pose: Option<PoseName>,
    /// Cycle number; absent if the frame applies to all cycles.
    pub cycle: Option<i64>,
    /// Pose of the world in the coordinates of the exports.
    pub export_T_world: etalon_base::pose::Pose,
    /// Covariance from the uncertainty of the points that define the frame: of a small shift along
    /// the axes of the world (mm), followed by a small rotation about them (rad). In a planar world
    /// the shift is that at the height of the targets. Absent if the exports contain the frame.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub covariance: Option<[[f64; 6]; 6]>,
}
