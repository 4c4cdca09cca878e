//! Answers of `etalon benchmark`: predicted measurements, and their scores against measured values.

use super::{Provenance, Statistics};
use etalon_base::pose::Vector;
use etalon_base::pose_name::PoseName;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Measurements that identified parameters predict.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PredictionsDocument {
    /// Schema and version: `etalon/predictions/1`.
    pub schema: String,
    /// Model of the robot.
    pub robot: String,
    /// One entry for each row of the table of joint values.
    pub predictions: Vec<PredictedMeasurement>,
    /// Origin of the numbers.
    pub provenance: Provenance,
}

/// Predicted measurement of a target.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PredictedMeasurement {
    /// Name of the pose.
    pub pose: PoseName,
    /// Name of the target.
    pub target: String,
    /// Position (mm) in the world.
    pub xyz_mm: Vector,
    /// Covariance (mm²) of the difference from a measured position: parameters, model and
    /// instrument.
    pub covariance_mm2: [[f64; 3]; 3],
    /// Orientation of the body that carries the target; absent if the calibration observed none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub orientation: Option<PredictedBody>,
}

/// Predicted orientation of the body that carries a target.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PredictedBody {
    /// Orientation in the world: unit quaternion w, x, y, z.
    pub quaternion: [f64; 4],
    /// Standard uncertainty (deg) of the difference from a measured orientation about any axis.
    pub standard_uncertainty_deg: f64,
}

/// Score of predicted measurements against measured values.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BenchmarkScoreDocument {
    /// Schema and version: `etalon/benchmark-score/1`.
    pub schema: String,
    /// Number of poses.
    pub poses: usize,
    /// Number of measured rows.
    pub rows: usize,
    /// Score of the positions.
    pub position: QuantityScore,
    /// Score of the orientations; absent if no orientation is measured and predicted.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub orientation: Option<QuantityScore>,
    /// Origin of the numbers.
    pub provenance: Provenance,
}

/// Score of the predicted positions or orientations.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct QuantityScore {
    /// Unit of errors and widths: mm or deg.
    pub unit: String,
    /// Distances of predicted from measured positions, or angles between orientations.
    pub errors: Statistics,
    /// Intervals of coordinates, or of rotations about the axes of the world; absent if the
    /// predictions give none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub intervals: Option<IntervalScore>,
    /// Share of positions within the ellipsoid of `probability`; absent without covariances that
    /// are positive definite.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ellipsoid_coverage: Option<f64>,
}

/// Score of prediction intervals.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct IntervalScore {
    /// Probability of the intervals.
    pub probability: f64,
    /// Number of intervals.
    pub count: usize,
    /// Share of measured values within their intervals.
    pub coverage: f64,
    /// Standard uncertainty of the coverage from the scatter between poses; absent with fewer than
    /// two poses.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub coverage_standard_uncertainty: Option<f64>,
    /// Exact interval of the coverage at the same probability (Clopper & Pearson 1934). Each pose
    /// counts as one trial: the values of one pose share its error.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub coverage_interval: Option<[f64; 2]>,
    /// Mean width.
    pub mean_width: f64,
    /// Mean interval score (Gneiting & Raftery 2007, eq. 43): width, and 2 / α times the distance
    /// of a value outside. A smaller score is better.
    pub mean_score: f64,
}
