//! `accuracy.json`: errors before and after calibration, and limits.

use super::LimitVerdict;
use super::{
    CampaignReference, Effect, FieldSummary, Figure, Provenance, ReadingReliability, ReadingValues, RelativeAccuracy,
    ToolFrame, UncertaintySource,
};
use crate::worded::worded;
use etalon_base::catalogue::Phrase;
use etalon_base::phrase;
use etalon_base::pose::Vector;
use etalon_base::pose_name::PoseName;
use etalon_base::worded::Worded;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Errors before and after calibration, separately for calibration and validation poses.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AccuracyDocument {
    /// Schema and version: `etalon/accuracy/1`.
    pub schema: String,
    /// Campaign whose data judge given parameters; absent in the output folder of a run.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub campaign: Option<CampaignReference>,
    /// Origin of the numbers of given parameters; absent in the output folder of a run.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub provenance: Option<Provenance>,
    /// Definition of "before" and of "error" in this document, in words.
    #[serde(flatten, with = "AccuracyDefinition")]
    pub definition: Worded,
    /// Point whose errors are in `sets`, in words.
    #[serde(flatten, with = "AccuracyPoint")]
    pub point: Worded,
    /// Joints of the robot, named as columns: `q1_deg`.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub joints: Vec<String>,
    /// One entry per set of poses: `calibration`, `validation`.
    pub sets: Vec<AccuracySet>,
    /// Distances of the validation poses from the calibration poses. The errors apply within the
    /// region that these poses cover.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub validation_distance: Option<ValidationDistance>,
    /// Errors of the distances between poses, independent of the base. Absent without two poses of
    /// one target.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub relative: Option<RelativeAccuracy>,
    /// Targets and fixtures that no calibration pose shows. They are placed by their own readings
    /// at validation poses, with all identified parameters held.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub placed_apart: Vec<SelfLocated>,
    /// Effects of the robot that are proved by poses excluded from the identification: effects
    /// chosen by `effects = "proven"`, and effects that are not identified.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub effects: Vec<EffectProof>,
    /// Errors at calibration poses that are excluded from the identification, with nominal and with
    /// identified parameters; absent with fewer than three poses, or without measured positions.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub left_out: Option<LeftOutErrors>,
    /// Standard uncertainties of the limited errors after calibration: of the validation poses, or
    /// of the calibration poses in a campaign without validation. The parameters are under test and
    /// contribute nothing. Empty if no uncertainty is given.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub budget: Vec<FigureBudget>,
    /// Standard uncertainty of an orientation error, by source; absent if no orientation was
    /// measured or its uncertainty is unknown.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub orientation_budget: Option<OrientationBudget>,
    /// Dependence of the mean errors of the calibration poses after identification on joints, reach
    /// and time; empty with fewer than ten poses.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub trends: Vec<ResidualTrend>,
    /// Effects of the identified parameters of the robot at the measured points, the largest change
    /// first.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub parameter_influences: Vec<ParameterInfluence>,
    /// Limits that the campaign contains, with their verdicts.
    pub limits: Vec<LimitVerdict>,
    /// Expected error at the tool point; absent without a tool point or a covariance.
    #[serde(default)]
    pub tool: Option<ToolAccuracy>,
    /// Expected error at the tool point over the workspace. Absent without `tool`, without inverse
    /// kinematics, or if the robot reaches too few places between the poses.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub map: Option<PredictionMap>,
    /// Search for a residual field; absent if the campaign asks for none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub field: Option<FieldSummary>,
    /// Origin and judgement of parameters that were given instead of being identified from these
    /// data.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub given: Option<ParameterJudgement>,
}

worded! {
    /// Definition of "before" and of "error" in this document, in words.
    text AccuracyDefinition: definition, definition_phrase
}

worded! {
    /// Point whose errors are in `sets`, in words.
    text or empty AccuracyPoint: point, point_phrase
}

/// A target or fixture that is placed by its own readings at validation poses. The placement
/// reduces the errors of these readings, so that each is divided by √r in the statistics; without
/// redundancy it does not count.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "PlacedApart")]
pub struct SelfLocated {
    /// Name of the target or fixture.
    pub name: String,
    /// Number of readings that locate the target.
    pub readings: usize,
    /// Mean redundancy number r of the readings: the share of an error that its reading shows. For
    /// n positions of a target, r = 1 − 1/n.
    pub redundancy: f64,
    /// `true` if errors of the readings count: r is at least 0.1 for at least one reading.
    pub is_assessed: bool,
}

/// Position errors (mm) at calibration poses, each predicted from the other folds: one value for
/// each pose, the root mean square over its readings.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LeftOutErrors {
    /// Number of poses, at most 200.
    pub poses: usize,
    /// Number of folds; each is predicted from the others.
    pub folds: usize,
    /// Errors with nominal parameters; base and targets are fitted.
    pub nominal: Statistics,
    /// Errors with the identified parameters.
    pub identified: Statistics,
}

/// Benefit of an effect of the robot at calibration poses that are excluded from the
/// identification.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct EffectProof {
    /// Effect.
    pub effect: Effect,
    /// Joints of the effect's parameters.
    pub joints: Vec<String>,
    /// `true` if the effect is identified; `false` if its benefit is proved, but it is not
    /// identified.
    pub is_identified: bool,
    /// Line of robot.toml that describes the effect; absent if robot.toml contains it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub robot_key: Option<String>,
    /// Line of `[identify]` that adds the effect to the identified ones; absent if the effect is
    /// identified, or if robot.toml does not contain it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub campaign_line: Option<String>,
    /// Root-mean-square position error at poses that were excluded, without the effect (mm).
    pub without_mm: f64,
    /// Root-mean-square position error at poses that were excluded, with the effect (mm).
    pub with_mm: f64,
    /// Decrease of the mean square error over its standard uncertainty.
    pub gain_over_u: Option<f64>,
    /// Probability of the F statistic of the effect.
    pub p_value: Option<f64>,
}

/// Effect of a parameter at the measured point that it moves most, with all other parameters, base
/// and targets unchanged.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ParameterInfluence {
    /// Name of the parameter.
    pub name: String,
    /// Pose of the point.
    pub pose: PoseName,
    /// Displacement of the point by identified minus nominal value (mm), with the sign of the
    /// change.
    pub change_mm: f64,
    /// Displacement of the point by the standard uncertainty of the parameter (mm, k = 1).
    pub standard_uncertainty_mm: Option<f64>,
    /// Displacement of the point by the given tolerance of the parameter (mm).
    pub tolerance_mm: Option<f64>,
}

/// F test of a trend in the errors after identification: a parabola in one quantity against a
/// constant. All coordinates of the poses' mean errors are tested together.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ResidualTrend {
    /// Independent quantity: a joint by the name of its column, `reach_mm` (distance from the base)
    /// or `order` (of the measurement).
    pub against: String,
    /// Root mean square of the errors that the parabola explains (mm).
    pub explained_mm: f64,
    /// F statistic.
    pub f: f64,
    /// Probability of such a trend if the model is right, corrected for the number of tests (Holm
    /// 1979).
    pub p_value: f64,
}

/// Standard uncertainty of a figure, and its contributions (GUM 5.1.2).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FigureBudget {
    /// Quantity of the errors.
    #[serde(default)]
    #[schemars(with = "String")]
    pub quantity: ErrorQuantity,
    /// Figure.
    pub figure: Figure,
    /// Standard uncertainty of the figure (mm, k = 1).
    pub standard_uncertainty_mm: f64,
    /// Contribution of each source; the squares add up.
    pub contributions: Vec<FigureContribution>,
}

/// Contribution of one source to the standard uncertainty of a figure.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FigureContribution {
    /// Source.
    pub source: UncertaintySource,
    /// Contribution (mm).
    pub standard_uncertainty_mm: f64,
}

/// Standard uncertainty of an orientation error.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct OrientationBudget {
    /// Standard uncertainty (deg, k = 1).
    pub standard_uncertainty_deg: f64,
    /// Contribution of each source; the squares add up.
    pub contributions: Vec<OrientationContribution>,
}

/// Contribution of one source to the standard uncertainty of an orientation error.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct OrientationContribution {
    /// Source.
    pub source: UncertaintySource,
    /// Contribution (deg).
    pub standard_uncertainty_deg: f64,
}

/// Judgement of given parameters.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "GivenSummary")]
pub struct ParameterJudgement {
    /// Origin of base and targets.
    pub frames: FrameOrigin,
    /// Probability of errors at least this large if the given parameters, base and targets are
    /// right within their uncertainty and the uncertainty of the measurement. Absent if base and
    /// targets were fitted.
    pub p_value: Option<f64>,
    /// `true` if the parameters must not be used on this robot: errors with them are larger than
    /// with nominal parameters by more than noise, or they were identified with other nominal
    /// values.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub refused: bool,
}

/// Origin of base and targets when parameters that were identified elsewhere are judged.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema, clap::ValueEnum)]
#[serde(rename_all = "snake_case")]
#[schemars(rename = "GivenFrames")]
pub enum FrameOrigin {
    /// From the parameters: errors are absolute, in the world frame of the campaign.
    Given,
    /// Fitted to the calibration poses of the campaign.
    #[default]
    Refit,
    /// Most probable values by the parameters with their covariance and by the calibration poses.
    Prior,
}

/// Error of the controller at the tool point: true position in the base frame minus the position
/// predicted by the parameters.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ToolAccuracy {
    /// Definition of "before" and "after" in this object, in words.
    #[serde(flatten, with = "ToolAccuracyDefinition")]
    pub definition: Worded,
    /// Position of the point in `frame`.
    pub point_mm: Vector,
    /// Part to which the point is attached.
    pub frame: ToolFrame,
    /// Set of poses: `validation`, or `calibration` in a campaign without validation poses.
    #[schemars(with = "String")]
    pub set: PoseSet,
    /// Number of poses.
    pub poses: usize,
    /// Position predicted with the parameters before calibration minus position predicted with the
    /// identified parameters (mm).
    pub before: Statistics,
    /// Expected error with the identified parameters (mm, k = 1).
    pub after: Statistics,
    /// Largest expected error with the identified parameters (mm, k = 2).
    pub expanded_max_mm: f64,
    /// Contribution of the parameters' covariance, root mean square (mm).
    pub parameters_mm: f64,
    /// Contribution of the tolerances of parameters that are held because the data do not determine
    /// them, root mean square (mm).
    pub held_mm: f64,
    /// Contribution of effects outside the model: measured errors beyond the instrument's
    /// uncertainty, root mean square (mm).
    pub model_mm: f64,
    /// Contribution of the uncertainty of the point's position on the tool (mm).
    pub place_mm: f64,
}

worded! {
    /// Definition of "before" and "after" in this object, in words.
    text ToolAccuracyDefinition: definition, definition_phrase
}

/// Expected error at the tool point with the identified parameters, on a grid. The grid covers
/// places between the calibration poses that the robot reaches without a joint leaving its range in
/// the calibration.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PredictionMap {
    /// Definition of the numbers of a node, in words.
    pub definition: String,
    /// Position of the point in `frame`.
    pub point_mm: Vector,
    /// Part to which the point is attached.
    pub frame: ToolFrame,
    /// Distance between neighbouring nodes (mm).
    pub spacing_mm: f64,
    /// Nodes in the order of x, y and z.
    pub nodes: Vec<MapNode>,
}

/// Expected error at one node of the grid.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MapNode {
    /// Position of the node in the base frame.
    pub at_mm: Vector,
    /// Joint values at the node (mm or deg) in the order of [`AccuracyDocument::joints`], for the
    /// orientation of the nearest calibration pose.
    pub joints: Vec<f64>,
    /// Size of the error before calibration: position predicted with the parameters before
    /// calibration minus position predicted with the identified parameters (mm).
    pub before_mm: f64,
    /// Standard uncertainty of the predicted position due to the identified parameters (mm, k = 1).
    pub parameters_mm: f64,
    /// Expected size of the error from all sources, root mean square (mm).
    pub standard_uncertainty_mm: f64,
    /// Expected size of the error with the residual field, root mean square (mm); absent without a
    /// field.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub with_field_mm: Option<f64>,
    /// 95th percentile of the size of the error (mm).
    pub p95_mm: f64,
}

/// Distances from the validation poses to their nearest calibration poses, relative to the spacing
/// of the calibration poses (median distance to the nearest neighbour). A distance is the root of
/// the sum of squared differences of joint values, each divided by the range of the joint in the
/// calibration.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ValidationDistance {
    /// Median; about 1 if both sets cover the same region equally.
    pub median: f64,
    /// Largest relative distance.
    pub largest: f64,
    /// Number of validation poses; repeated joint values count once.
    pub poses: usize,
    /// Number of validation poses with a joint outside its range in the calibration.
    pub outside: usize,
}

impl ValidationDistance {
    /// Distance, in spacings, beyond which calibration poses do not represent the errors of the
    /// robot.
    pub const BEYOND: f64 = 3.0;

    /// `true` if all validation poses are near calibration poses, and all their joint values within
    /// the ranges of the calibration.
    pub fn is_within(&self) -> bool {
        self.largest <= Self::BEYOND && self.outside == 0
    }
}

/// Set of poses of a campaign.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, strum::Display, strum::IntoStaticStr,
)]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "snake_case")]
pub enum PoseSet {
    /// Poses from which parameters are identified.
    Calibration,
    /// Poses that judge the identified parameters.
    Validation,
}

impl PoseSet {
    /// Both sets, calibration first.
    pub const ALL: [Self; 2] = [Self::Calibration, Self::Validation];

    /// Text of the catalogue.
    pub fn phrase(self) -> Phrase {
        match self {
            Self::Calibration => phrase!("calibration"),
            Self::Validation => phrase!("validation"),
        }
    }

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
    /// Number of poses.
    pub poses: usize,
    /// Number of points or poses whose errors are counted.
    pub count: usize,
    /// One per quantity that was measured: position, x, y, z, orientation; distance, surface,
    /// contact, coordinate.
    pub errors: Vec<ErrorStatistics>,
    /// Values of the readings in addition to joint values, one entry per column; empty if the robot
    /// has no effects of load, torques or temperature.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub readings: Vec<ReadingValues>,
}

/// Quantity whose errors are counted.
#[derive(
    Clone,
    Copy,
    Debug,
    Default,
    PartialEq,
    Eq,
    PartialOrd,
    Ord,
    Serialize,
    Deserialize,
    strum::AsRefStr,
    strum::Display,
    strum::EnumString,
)]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "snake_case")]
pub enum ErrorQuantity {
    /// Size of the position error.
    #[default]
    Position,
    /// Position error along x.
    X,
    /// Position error along y.
    Y,
    /// Position error along z.
    Z,
    /// Orientation error.
    Orientation,
    /// Error of a distance between a target and a fixed point.
    Distance,
    /// Distance of a target from the plane, line or sphere that it touches.
    Surface,
    /// Distance of a target from the socket that it touches.
    Contact,
    /// Error of one coordinate that was measured singly.
    Coordinate,
    /// Value of a joint, from a second encoder or a home switch. Only in residuals.
    Joint,
}

impl ErrorQuantity {
    /// Text of the catalogue.
    pub fn phrase(self) -> Phrase {
        match self {
            Self::Position => phrase!("position"),
            Self::X => phrase!("axis-x"),
            Self::Y => phrase!("axis-y"),
            Self::Z => phrase!("axis-z"),
            Self::Orientation => phrase!("orientation"),
            Self::Distance => phrase!("distance"),
            Self::Surface => phrase!("surface"),
            Self::Contact => phrase!("contact"),
            Self::Coordinate => phrase!("coordinate"),
            Self::Joint => phrase!("joint-value"),
        }
    }

    /// Coordinates, in order.
    pub const AXES: [Self; 3] = [Self::X, Self::Y, Self::Z];
    /// Quantities of single errors that are no position.
    pub const OTHERS: [Self; 4] = [Self::Distance, Self::Surface, Self::Contact, Self::Coordinate];
}

impl From<etalon_identify::ErrorKind> for ErrorQuantity {
    fn from(kind: etalon_identify::ErrorKind) -> Self {
        use etalon_identify::ErrorKind;
        match kind {
            ErrorKind::Position => Self::Position,
            ErrorKind::Axis(axis) => Self::AXES[axis.min(2)],
            ErrorKind::Distance => Self::Distance,
            ErrorKind::Surface => Self::Surface,
            ErrorKind::Contact => Self::Contact,
            ErrorKind::Coordinate => Self::Coordinate,
        }
    }
}

/// Statistics of one error before and after calibration.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ErrorStatistics {
    /// `position`, `x`, `y`, `z`, `orientation`, `distance`, `surface`, `contact` or `coordinate`.
    #[schemars(with = "String")]
    pub quantity: ErrorQuantity,
    /// Number of errors.
    #[serde(default)]
    pub count: usize,
    /// Number of poses with such an error; 0 in documents of earlier versions.
    #[serde(default)]
    pub poses: usize,
    /// `mm` or `deg`.
    pub unit: String,
    /// Errors with nominal parameters; only base and targets are fitted.
    pub before: Statistics,
    /// Errors with the identified parameters.
    pub after: Statistics,
    /// Expanded uncertainty (k = 2) of the largest error after calibration, by instrument and
    /// frames; absent if unknown.
    #[serde(default)]
    pub expanded_uncertainty: Option<f64>,
}

impl AccuracySet {
    /// Returns the number of poses with an error of a quantity of this set, and number of further
    /// errors (0 if each pose has one).
    pub fn counts(&self, errors: &ErrorStatistics) -> [usize; 2] {
        let poses = if errors.poses > 0 { errors.poses } else { self.poses };
        [poses, if errors.count == poses { 0 } else { errors.count }]
    }

    /// Statistics of one quantity, if its errors are counted.
    pub fn error_statistics(&self, quantity: ErrorQuantity) -> Option<&ErrorStatistics> {
        self.errors.iter().find(|e| e.quantity == quantity)
    }

    /// Statistics of the leading quantity: position if it was measured, otherwise the first other
    /// length.
    pub fn leading(&self) -> Option<&ErrorStatistics> {
        self.error_statistics(ErrorQuantity::Position).or_else(|| self.errors.iter().find(|e| e.unit == "mm"))
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
    /// 95th percentile.
    pub p95: f64,
    /// Largest size.
    pub max: f64,
}

/// Error of one point before and after calibration, for the figures of a report.
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
    /// Quantity of the error: `position`, `distance`, `surface`, `contact` or `coordinate`.
    #[serde(default)]
    #[schemars(with = "String")]
    pub quantity: ErrorQuantity,
    /// Measured position: a target in the world frame, or `C` in the base frame with the identified
    /// parameters.
    pub at_mm: Vector,
    /// Measured minus predicted position before calibration; of a distance a vector along it, of a
    /// surface along its normal.
    pub before_mm: Vector,
    /// Measured minus predicted position after calibration.
    pub after_mm: Vector,
    /// Orientation error before calibration, if measured.
    pub before_deg: Option<f64>,
    /// Orientation error after calibration, if measured.
    pub after_deg: Option<f64>,
    /// Joint values (mm or deg) in the order of [`AccuracyDocument::joints`], then the time (s) if
    /// known.
    #[serde(default)]
    pub joints: Vec<f64>,
    /// Control of the reading by other readings.
    #[serde(flatten)]
    pub control: ReadingControl,
}

/// Control of a reading by other readings.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ReadingControl {
    /// Reliability of the reading, as controlled by the other readings of the calibration; absent
    /// for validation poses.
    #[serde(default)]
    pub reliability: Option<ReadingReliability>,
    /// Redundancy number of a reading that locates its own target or fixture, which has no
    /// calibration reading; absent for all other readings.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub own_redundancy: Option<f64>,
}

/// Redundancy number below which a reading is uncontrolled (Förstner 1987, Reliability analysis of
/// parameter estimation).
const UNCONTROLLED: f64 = 0.1;

/// Returns the divisor √r in statistics of the error of a reading that places its own target with
/// this redundancy number; `None` if the reading is uncontrolled.
pub fn counted_share(redundancy: f64) -> Option<f64> {
    (redundancy >= UNCONTROLLED).then(|| redundancy.sqrt())
}

impl PointError {
    /// Divisor of the error in statistics: 1, or [`counted_share`] if the reading places its own
    /// target.
    pub fn statistics_divisor(&self) -> Option<f64> {
        self.control.own_redundancy.map_or(Some(1.0), counted_share)
    }
}
