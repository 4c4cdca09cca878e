//! `accuracy.json`: errors before and after calibration, and limits.

use super::LimitVerdict;
use super::{Effect, Figure, ReadingReliability, ToolFrame, UncertaintySource};
use etalon_base::pose::Vector;
use etalon_base::pose_name::PoseName;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Errors before and after, on calibration and validation poses apart.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AccuracyDocument {
    /// `etalon/accuracy/1`
    pub schema: String,
    /// What "before" and "error" mean here, in words.
    pub definition: String,
    /// The point whose errors `sets` holds, in words.
    #[serde(default)]
    pub point: String,
    /// Joints of the robot as columns name them: `q1_deg`.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub joints: Vec<String>,
    /// One per set of poses: `calibration`, `validation`.
    pub sets: Vec<AccuracySet>,
    /// How far the validation poses lie from those of the calibration: the errors hold among poses like these.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub validation_distance: Option<ValidationDistance>,
    /// Targets and fixtures that no calibration pose shows: placed by their own readings at validation poses, with all identified parameters
    /// held.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub placed_apart: Vec<PlacedApart>,
    /// Effects of the robot that poses prove which were left out: those chosen by `effects = "proven"`, and those that are not identified.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub effects: Vec<EffectProof>,
    /// Standard uncertainties of the position errors of the validation poses after calibration; empty without a validation or a covariance.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub budget: Vec<FigureBudget>,
    /// How the mean errors of the calibration poses after identification depend on joints, reach and time; empty with fewer than ten poses.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub trends: Vec<ResidualTrend>,
    /// Limits that the campaign states, and whether they are met.
    pub limits: Vec<LimitVerdict>,
    /// The error to expect at the tool point; absent where there is none, or no covariance.
    #[serde(default)]
    pub tool: Option<ToolAccuracy>,
    /// The same over the workspace; absent also where the model has no inverse kinematics, or few places between the poses are reached.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub map: Option<PredictionMap>,
    /// What is given, where the parameters were not identified from these data.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub given: Option<GivenSummary>,
}

/// A target or fixture that its own readings at validation poses place. Each error of such a reading counts in the statistics over √r, because
/// the placement makes it smaller; without redundancy it does not count.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PlacedApart {
    /// Its name.
    pub name: String,
    /// Readings that place it.
    pub readings: usize,
    /// Mean redundancy number r of these: the share of its error that a reading shows. n positions of a target have r = 1 − 1/n.
    pub redundancy: f64,
    /// `true` if errors of its readings are counted: r is at least 0.1 for one of them.
    pub is_assessed: bool,
}

/// What an effect of the robot is worth at calibration poses that are left out of the identification.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct EffectProof {
    /// The effect.
    pub effect: Effect,
    /// Joints of its parameters.
    pub joints: Vec<String>,
    /// `true` if it is identified; `false` if it would prove itself and is not.
    pub is_identified: bool,
    /// Line of robot.toml that describes it; absent if robot.toml does so already.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub robot_key: Option<String>,
    /// Root mean square position error at poses that were left out, without the effect, mm.
    pub without_mm: f64,
    /// The same with the effect, mm.
    pub with_mm: f64,
    /// By how much the mean square becomes smaller, over its standard uncertainty.
    pub gain_over_u: Option<f64>,
    /// p value of the F test of what the effect explains.
    pub p_value: Option<f64>,
}

/// An F test of errors after identification: of a parabola of one quantity against a constant, all coordinates of the poses' means together.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ResidualTrend {
    /// The quantity: a joint as columns name it, `reach_mm` (distance from the base) or `order` (of the measurement).
    pub against: String,
    /// Root mean square of what the parabola explains, mm.
    pub explained_mm: f64,
    /// F statistic.
    pub f: f64,
    /// Probability of such a trend of a right model, corrected for the number of tests (Holm 1979).
    pub p_value: f64,
}

/// The standard uncertainty of a figure, and what it is made of (GUM 5.1.2).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FigureBudget {
    /// Which.
    pub figure: Figure,
    /// Its standard uncertainty (k = 1), mm.
    pub standard_uncertainty_mm: f64,
    /// What each source contributes: squares add up.
    pub contributions: Vec<FigureContribution>,
}

/// What a source contributes to the standard uncertainty of a figure.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FigureContribution {
    /// The source.
    pub source: UncertaintySource,
    /// Its contribution, mm.
    pub standard_uncertainty_mm: f64,
}

/// How given parameters were judged.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GivenSummary {
    /// Whether base and targets were given too.
    pub frames: GivenFrames,
    /// Probability of errors as large as these, if parameters, base and targets are what they were given as, within their uncertainty and
    /// that of the measurement; absent where base and targets were fitted.
    pub p_value: Option<f64>,
}

/// Where base and targets come from when parameters are judged that were identified elsewhere.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema, clap::ValueEnum)]
#[serde(rename_all = "snake_case")]
pub enum GivenFrames {
    /// From the parameters: errors in the absolute sense, in the world frame of the campaign
    Given,
    /// Fitted to the calibration poses of the campaign
    #[default]
    Refit,
    /// From the parameters with their covariance, and from the calibration poses: the most probable ones by both
    Prior,
}

/// The error that the controller will make at the tool point: its true place in the base frame minus the one that the parameters predict.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ToolAccuracy {
    /// What "before" and "after" mean here, in words.
    pub definition: String,
    /// Place of the point in `frame`.
    pub point_mm: Vector,
    /// The part in whose frame it is stated.
    pub frame: ToolFrame,
    /// The poses: `validation`, or `calibration` where there are no others.
    #[schemars(with = "String")]
    pub set: PoseSet,
    /// How many.
    pub poses: usize,
    /// Predicted with the parameters before minus predicted with the identified ones, mm.
    pub before: Statistics,
    /// Expected with the identified parameters (k = 1), mm.
    pub after: Statistics,
    /// The largest of these with k = 2, mm.
    pub expanded_max_mm: f64,
    /// Share of the parameters' covariance, root mean square, mm.
    pub parameters_mm: f64,
    /// Share of parameters that are held because the data do not determine them, with their tolerances, root mean square, mm.
    pub held_mm: f64,
    /// Share of what the model leaves out: measured errors beyond what the instrument explains, root mean square, mm.
    pub model_mm: f64,
    /// Share of the uncertainty of the point's place on the tool, mm.
    pub place_mm: f64,
}

/// The error to expect at the tool point with the identified parameters, on a grid of the workspace that the calibration poses span:
/// places between theirs at which no joint leaves its range in the calibration.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PredictionMap {
    /// What the numbers of a node mean, in words.
    pub definition: String,
    /// Place of the point in `frame`.
    pub point_mm: Vector,
    /// The part in whose frame it is stated.
    pub frame: ToolFrame,
    /// Distance of neighbouring nodes, mm.
    pub spacing_mm: f64,
    /// The nodes by x, y and z.
    pub nodes: Vec<MapNode>,
}

/// The error to expect at one place.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MapNode {
    /// The place in the base frame.
    pub at_mm: Vector,
    /// Values of the joints there in mm or deg, as [`AccuracyDocument::joints`] names them: in the orientation of the nearest calibration pose.
    pub joints: Vec<f64>,
    /// Size of the error before: predicted with the parameters before minus predicted with the identified ones, mm.
    pub before_mm: f64,
    /// Standard uncertainty (k = 1) of the predicted position by the identified parameters, mm.
    pub parameters_mm: f64,
    /// The same with all else that contributes: the expected size of the error (root mean square), mm.
    pub standard_uncertainty_mm: f64,
    /// 95 % of the errors are at most this, mm.
    pub p95_mm: f64,
}

/// Distances from validation poses to the nearest calibration pose, over the calibration poses' spacing: the median of their distances to
/// the nearest of each other. Distances are those of joint values, each over its range in the calibration (root of the sum of squares).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ValidationDistance {
    /// Of half of the validation poses at most this: about 1 where both sets are spread alike.
    pub median: f64,
    /// Of all validation poses at most this.
    pub largest: f64,
    /// Validation poses, each set of joint values counted once.
    pub poses: usize,
    /// Those with a joint outside of its range in the calibration.
    pub outside: usize,
}

/// Set of poses of a campaign.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, strum::Display, strum::IntoStaticStr,
)]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "snake_case")]
pub enum PoseSet {
    /// Poses that parameters are identified from.
    Calibration,
    /// Poses that judge the parameters.
    Validation,
}

impl PoseSet {
    /// Both sets in their order.
    pub const ALL: [Self; 2] = [Self::Calibration, Self::Validation];

    /// Name of the set.
    pub fn name(self) -> &'static str {
        self.into()
    }
}

/// Errors over one set of poses.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AccuracySet {
    /// `calibration` or `validation`.
    #[schemars(with = "String")]
    pub name: PoseSet,
    /// Poses in it.
    pub poses: usize,
    /// Points or poses whose errors are counted.
    pub count: usize,
    /// One per quantity: position, x, y, z, orientation.
    pub errors: Vec<ErrorStatistics>,
}

/// Quantity of which errors are counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, strum::AsRefStr, strum::Display)]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "snake_case")]
pub enum ErrorQuantity {
    /// Size of the position error.
    Position,
    /// Position error along x.
    X,
    /// Position error along y.
    Y,
    /// Position error along z.
    Z,
    /// Orientation error.
    Orientation,
}

impl ErrorQuantity {
    /// Coordinates in their order.
    pub const AXES: [Self; 3] = [Self::X, Self::Y, Self::Z];
}

/// Statistics of one error before and after.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ErrorStatistics {
    /// `position`, `x`, `y`, `z` or `orientation`.
    #[schemars(with = "String")]
    pub quantity: ErrorQuantity,
    /// `mm` or `deg`.
    pub unit: String,
    /// With nominal parameters and only base and targets fitted.
    pub before: Statistics,
    /// With the identified parameters.
    pub after: Statistics,
    /// Expanded uncertainty (k = 2) of one error, by what the instrument measures; absent where it is not known.
    #[serde(default)]
    pub expanded_uncertainty: Option<f64>,
}

impl AccuracySet {
    /// Statistics of one quantity, where its errors are counted.
    pub fn of(&self, quantity: ErrorQuantity) -> Option<&ErrorStatistics> {
        self.errors.iter().find(|e| e.quantity == quantity)
    }
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

/// One error, before or after: what the pictures of a report show.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PointError {
    /// `calibration` or `validation`.
    #[schemars(with = "String")]
    pub set: PoseSet,
    /// Pose number.
    pub pose: PoseName,
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
    /// Values of the joints in mm or deg and, where it is known, the time in s, as [`AccuracyDocument::joints`] names them.
    #[serde(default)]
    pub joints: Vec<f64>,
    /// How well the other readings of the calibration control it; absent of validation poses.
    #[serde(default)]
    pub reliability: Option<ReadingReliability>,
    /// Redundancy number of a reading that places its own target or fixture, which no calibration pose shows; absent of all others.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub own_redundancy: Option<f64>,
}

/// Redundancy number below which nothing controls a reading (Förstner 1987, Reliability analysis of parameter estimation).
const UNCONTROLLED: f64 = 0.1;

/// What an error is divided by in statistics whose reading places its own target with this redundancy number: √r; `None` where nothing
/// controls the reading.
pub fn counted_share(redundancy: f64) -> Option<f64> {
    (redundancy >= UNCONTROLLED).then(|| redundancy.sqrt())
}

impl PointError {
    /// What the error is divided by in statistics: 1, or [`counted_share`] where the reading places its own target.
    pub fn own_share(&self) -> Option<f64> {
        self.own_redundancy.map_or(Some(1.0), counted_share)
    }
}
