//! The types behind every JSON document. A report can be made again from these alone.
//!
//! Angles are in degrees, lengths in millimetres; every name carries its unit, every parameter its own.

mod answer;
mod characteristics;
mod compare;
mod conditions;
mod fit;
mod geometric;
mod iso9283;
mod iso9283_plan;
mod iso9283_stream;
mod observability;
mod plan;
mod presentation;
mod refit;
pub mod schema;
mod standstill;
mod stated;
mod study;

pub use answer::{CheckDocument, Finding, FormatsDocument, Reading, WrittenDocument};
pub use characteristics::Characteristics;
pub use compare::*;
pub use conditions::Conditions;
pub use fit::{FitContacts, FitDocument, FitSolver, FitUncertainty};
pub use geometric::*;
pub use iso9283::*;
pub use iso9283_plan::*;
pub use iso9283_stream::*;
pub use observability::{ObservabilitySummary, SingularValueEntry};
pub use plan::{
    ComparedPoses, CurvePoint, GreedySummary, PlanDocument, PlannedParameter, PlannedPose, WorkspaceUncertainty,
};
pub use presentation::{Language, Presentation};
pub use refit::{FitProbe, FitStated};
pub use standstill::{StandingInterval, StandingJoint};
pub use stated::{CampaignSummary, ContactSummary, ResidualSummary};
pub use study::{CandidatePlace, StudiedParameter, StudiedPlace, StudyDocument, StudyStep};

use crate::base::message::Message;
use crate::base::pose::Vector;
pub use crate::math::identify::{ResidualKind, UncertaintyFrom};
pub use crate::math::solve::Termination;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What was read, what was refused and why.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ImportDocument {
    /// `etalon/import/1`
    pub schema: String,
    /// Name of the campaign.
    pub campaign: String,
    /// Every file that was read.
    pub sources: Vec<Source>,
    /// What blunder rules found, and other messages.
    pub messages: Vec<Message>,
    /// Rows that the join of points and logs found no partner for, or more than one.
    #[serde(default)]
    pub unmatched: Vec<Unmatched>,
}

/// A row without a partner in the join, or with more than one.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Unmatched {
    /// Its file, as the campaign names it.
    pub file: String,
    /// Line in the file, from 1.
    pub line: usize,
    /// Its key in words: pose and cycle, row, or time.
    pub key: String,
    /// What it has no partner in, or how many partners it has.
    pub reason: String,
}

/// One file that was read.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Source {
    /// File as the campaign names it.
    pub file: String,
    /// SHA-256 of its bytes, as `sha256sum` prints it.
    pub sha256: String,
    /// Its size.
    pub bytes: usize,
    /// `export`, `log`, `campaign` or `robot`.
    pub kind: String,
    /// How it was read: format, delimiter, decimal mark, unit.
    pub dialect: String,
    /// Rows that hold data.
    pub rows_read: usize,
    /// Rows that were refused.
    pub refused: Vec<Refused>,
    /// Of a log recorded while the robot moved: where it stood, one row of the joint values each.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub standstills: Vec<StandingInterval>,
}

/// A row that was refused.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Refused {
    /// Line in the file, from 1.
    pub line: usize,
    /// The line itself.
    pub text: String,
    /// The rule that refused it.
    pub reason: String,
}

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
    /// Pose number; absent where the frame holds for all.
    pub pose: Option<i64>,
    /// Cycle number; absent where the frame holds for all.
    pub cycle: Option<i64>,
    /// `export_T_world`.
    pub export_T_world: crate::base::pose::Pose,
}

/// Identified parameters with all that is needed to trust them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ParametersDocument {
    /// `etalon/parameters/1`
    pub schema: String,
    /// Model of the robot.
    pub robot: String,
    /// All parameters of the model.
    pub parameters: Vec<ParameterEntry>,
    /// Covariance of the identified parameters, in their order and units; empty where nothing tells it.
    pub covariance: Vec<Vec<f64>>,
    /// How well they fit.
    pub residuals: ResidualSummary,
    /// What the poses can tell; absent where it is not a number.
    pub observability: Option<ObservabilitySummary>,
    /// How the solver ended.
    pub solver: SolverSummary,
    /// Rules and remarks that a reader must know: which parameters were held and why, warnings with remedies.
    pub messages: Vec<Message>,
    /// Where the numbers come from.
    pub provenance: Provenance,
}

/// One parameter.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ParameterEntry {
    /// Name as in the thesis.
    pub name: String,
    /// `mm`, `deg` or `1`.
    pub unit: String,
    /// Nominal value.
    pub nominal: f64,
    /// Value with only base and targets fitted: the robot before its calibration.
    pub before: f64,
    /// Identified value, or the value at which it is held.
    pub value: f64,
    /// Standard uncertainty (k = 1); absent where not identified.
    pub standard_uncertainty: Option<f64>,
    /// Identified, fixed or not identifiable.
    pub status: ParameterStatus,
    /// Parameters that the data cannot tell apart from this one.
    pub confounded_with: Vec<String>,
}

/// Why a parameter has its value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ParameterStatus {
    /// Found by least squares.
    Identified,
    /// Held by the campaign, or not part of the model.
    Fixed,
    /// Held because the data cannot tell it apart.
    NotIdentifiable,
}

/// How the solver ended.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SolverSummary {
    /// Algorithm.
    pub method: String,
    /// Steps taken.
    pub iterations: usize,
    /// Why it stopped.
    pub termination: Termination,
    /// The same in words.
    pub meaning: String,
}

/// Where numbers come from.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Provenance {
    /// Version of etalon.
    pub version: String,
    /// SHA-256 of every input, by name.
    pub inputs: std::collections::BTreeMap<String, String>,
    /// Seed of random numbers, where any were drawn.
    pub seed: Option<u64>,
}

/// Errors before and after, on calibration and validation poses apart.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AccuracyDocument {
    /// `etalon/accuracy/1`
    pub schema: String,
    /// What "before" and "error" mean here, in words.
    pub definition: String,
    /// One per set of poses: `calibration`, `validation`.
    pub sets: Vec<AccuracySet>,
    /// Limits that the campaign states, and whether they are met.
    pub limits: Vec<LimitVerdict>,
}

/// Errors over one set of poses.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AccuracySet {
    /// `calibration` or `validation`.
    pub name: String,
    /// Poses in it.
    pub poses: usize,
    /// Points or poses whose errors are counted.
    pub count: usize,
    /// One per quantity: position, x, y, z, orientation.
    pub errors: Vec<ErrorStatistics>,
}

/// Statistics of one error before and after.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ErrorStatistics {
    /// `position`, `x`, `y`, `z` or `orientation`.
    pub quantity: String,
    /// `mm` or `deg`.
    pub unit: String,
    /// With nominal parameters and only base and targets fitted.
    pub before: Statistics,
    /// With the identified parameters.
    pub after: Statistics,
}

/// Statistics of errors by size.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Statistics {
    /// Mean size.
    pub mean: f64,
    /// Root mean square.
    pub rms: f64,
    /// 95 % of the errors are at most this.
    pub p95: f64,
    /// Largest.
    pub max: f64,
}

/// One limit of the campaign.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LimitVerdict {
    /// Name of the limit in the campaign.
    pub name: String,
    /// Unit of both numbers.
    pub unit: String,
    /// What the campaign allows.
    pub limit: f64,
    /// What was reached, on the validation poses if there are any.
    pub value: f64,
    /// Whether the value is within the limit.
    pub met: bool,
}

/// One error, before or after: what the pictures of a report show.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PointError {
    /// `calibration` or `validation`.
    pub set: String,
    /// Pose number.
    pub pose: i64,
    /// Cycle number.
    pub cycle: i64,
    /// Target, or `C` for the centre of a planar platform.
    pub target: String,
    /// Where it was measured: a target in the world, or `C` in the base frame with the identified parameters.
    pub at_mm: Vector,
    /// Measured minus predicted, before.
    pub before_mm: Vector,
    /// Measured minus predicted, after.
    pub after_mm: Vector,
    /// Orientation error before, where there is one.
    pub before_deg: Option<f64>,
    /// Orientation error after.
    pub after_deg: Option<f64>,
}
