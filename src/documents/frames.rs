//! `features.json` and `frames.json`: fitted elements, and the world frame.

use etalon_base::message::Message;
use etalon_base::pose::Vector;
use etalon_base::pose_name::PoseName;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Fitted elements.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FeaturesDocument {
    /// `etalon/features/1`
    pub schema: String,
    /// One per feature of the campaign.
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
    /// A point of the element: centroid, or centre of the circle.
    pub point_mm: Vector,
    /// Normal of a plane or circle, axis of a line or cylinder; a unit vector.
    pub direction: Vector,
    /// Radius of a circle or cylinder.
    pub radius_mm: Option<f64>,
    /// Root mean square of the orthogonal distances.
    pub rms_mm: f64,
    /// Largest orthogonal distance.
    pub max_mm: f64,
    /// Standard uncertainty of the radius, or of the point along the normal of a plane, from the residuals.
    pub standard_uncertainty_mm: Option<f64>,
}

/// Frames made from features and targets.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FramesDocument {
    /// `etalon/frames/1`
    pub schema: String,
    /// The world frame; `export_T_world` for every pose where it is measured again at each.
    pub world: WorldFrame,
    /// What no reading of the campaign can show, with the keys that would control it.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub not_controlled: Vec<Uncontrolled>,
}

/// An error that no reading would show.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Uncontrolled {
    /// The error, in words.
    pub what: String,
    /// Labels, features or targets that it is of; empty where it is of all readings.
    pub points: Vec<String>,
    /// Keys that would control it.
    pub keys: Vec<String>,
}

/// The world frame in the coordinates of the exports.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WorldFrame {
    /// How it is defined, in words.
    pub definition: String,
    /// Drop z: observations are projected into the xy plane of the world.
    pub planar: bool,
    /// One entry for all poses (without `pose` and `cycle`), or one for each pose and cycle.
    pub poses: Vec<FramePose>,
    /// What the covariances of all poses have in common, where the frame is measured again at each: that of the mean places of the
    /// targets, which define it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub common_covariance: Option<[[f64; 6]; 6]>,
    /// Root mean square distance of the targets from their best-fit places; absent for 3-2-1 frames.
    pub rms_mm: Option<f64>,
    /// Largest such distance.
    pub max_mm: Option<f64>,
    /// Best-fit places of the targets in the world, in the order of the definition.
    pub reference_mm: Vec<Vector>,
}

/// Pose of a frame in the coordinates of the exports.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FramePose {
    /// Name of the pose; absent where the frame holds for all.
    pub pose: Option<PoseName>,
    /// Cycle number; absent where the frame holds for all.
    pub cycle: Option<i64>,
    /// `export_T_world`.
    pub export_T_world: etalon_base::pose::Pose,
    /// Covariance, from the uncertainty of the points that make the frame, of a small shift along (mm) and then a small rotation about
    /// (rad) the axes of the world; of a planar world the shift is that at the height of the targets. Absent where the exports state
    /// the frame.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub covariance: Option<[[f64; 6]; 6]>,
}
