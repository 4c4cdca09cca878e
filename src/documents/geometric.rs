//! `geometric.json`: results of the geometric method, compared with the identification of the same
//! campaign.

use crate::worded::worded;
use etalon_base::message::Message;
use etalon_base::pose::Vector;
use etalon_base::pose_name::PoseName;
use etalon_base::worded::Worded;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Geometric calibration (thesis, chapter 2).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GeometricDocument {
    /// Schema and version: `etalon/geometric/1`.
    pub schema: String,
    /// Assignment of the measured features to geometric quantities, in words.
    #[serde(flatten, with = "GeometricDefinition")]
    pub definition: Worded,
    /// One entry per quantity, with the identified value of the same parameter.
    pub quantities: Vec<GeometricQuantity>,
    /// Covariance of the values of all quantities, in their order and units.
    pub covariance: Vec<Vec<f64>>,
    /// Residuals of all fits.
    pub steps: Vec<GeometricStep>,
    /// Leads of the screws.
    pub leads: Vec<LeadResult>,
    /// Scale bars.
    pub scale_bars: Vec<ScaleBarResult>,
    /// Single balls, measured repeatedly.
    pub balls: Vec<BallResult>,
    /// Mean errors by pose.
    pub tables: Vec<PoseTable>,
    /// Largest mean errors over all tables, by method.
    pub methods: Vec<MethodErrors>,
    /// Regions of the workspace, with the geometric parameters.
    pub workspace: Vec<Region>,
    /// Remarks and warnings for the reader.
    pub messages: Vec<Message>,
}

worded! {
    /// Assignment of the measured features to geometric quantities, in words.
    text GeometricDefinition: definition, definition_phrase
}

/// One quantity, determined from points that were measured for it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GeometricQuantity {
    /// Name of the parameter.
    pub name: String,
    /// `mm` or `1`.
    pub unit: String,
    /// Nominal value.
    pub nominal: f64,
    /// Measured value; the mean of repeats.
    pub value: f64,
    /// Standard uncertainty of `value` (k = 1), including frames and `uncertainty_by_angles`.
    pub standard_uncertainty: f64,
    /// Part of the standard uncertainty by `beta`, `gamma` and `epsilon_theta`, which are taken as
    /// zero: their identified values, or stated tolerances. Absent if these are unknown (the part
    /// is then missing), and for quantities that do not depend on them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub uncertainty_by_angles: Option<f64>,
    /// Scatter of repeats, if there are any.
    pub repeats: Option<RepeatStatistics>,
    /// Value from the identification of the same campaign, if available.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub identified: Option<f64>,
    /// Standard uncertainty of the identified value; absent if the parameter was held.
    pub identified_standard_uncertainty: Option<f64>,
}

/// Scatter of repeated determinations.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RepeatStatistics {
    /// Number of determinations.
    pub count: usize,
    /// Standard deviation of one determination.
    pub standard_deviation: f64,
    /// Standard deviation expected from the points' uncertainties. Frames that all repeats share
    /// cancel.
    pub expected: f64,
    /// `true` if the repeats scatter more than expected (chi-square test at 0.1 %), so that the
    /// uncertainty was increased.
    pub enlarged: bool,
}

/// Residuals of one fit.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GeometricStep {
    /// Fitted feature.
    #[serde(flatten, with = "GeometricStepName")]
    pub name: Worded,
    /// Number of residuals.
    pub count: usize,
    /// Standard deviation of a residual.
    pub standard_deviation_mm: f64,
    /// Standard deviation expected from the instrument's given uncertainty.
    pub expected_mm: f64,
    /// Largest residual.
    pub max_mm: f64,
    /// Root of the sum of squared residuals.
    pub norm_mm: f64,
    /// Factor by which the points' uncertainties were increased because residuals scatter more than
    /// expected; otherwise 1.
    pub enlarged_by: f64,
    /// For a circle: arc that is covered by points.
    pub coverage_deg: Option<f64>,
}

worded! {
    /// Fitted feature.
    text GeometricStepName: name, name_phrase
}

/// Lead of an actuator.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LeadResult {
    /// Number of the actuator.
    pub actuator: usize,
    /// Nominal lead of its screw.
    pub nominal_lead_mm: f64,
    /// Actual lead.
    pub actual_lead_mm: f64,
    /// Actual displacement over nominal displacement, minus one.
    pub error: f64,
    /// Standard uncertainty of `error`.
    pub standard_uncertainty: f64,
    /// Mean deviation from linear travel at each position.
    pub linearity: Vec<Linearity>,
}

/// Deviation from linear travel at one position.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Linearity {
    /// Commanded displacement.
    pub commanded_mm: f64,
    /// Mean deviation of all passes.
    pub deviation_mm: f64,
}

/// Distance errors of a scale bar.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ScaleBarResult {
    /// Name of the bar's position.
    pub name: String,
    /// Calibrated length.
    pub length_mm: f64,
    /// Number of measured distances.
    pub count: usize,
    /// Mean of measured minus calibrated length.
    pub mean_error_mm: f64,
    /// Standard deviation of the distances.
    pub standard_deviation_mm: f64,
    /// Largest error of a single distance.
    pub largest_error_mm: f64,
    /// Expanded uncertainty (k = 2) of the calibrated length, from the certificate.
    pub length_uncertainty_mm: Option<f64>,
    /// Maximum permissible error of the instrument for this distance. By default the largest of the
    /// distances exceeds it with a probability of 5 %.
    pub permissible_error_mm: f64,
    /// Maximum permissible error over the certificate's uncertainty; at least 4 is required.
    pub uncertainty_ratio: Option<f64>,
    /// Verdict on the instrument.
    pub verdict: BarVerdict,
}

/// Verdict of a scale bar on the instrument.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum BarVerdict {
    /// Every distance is within the permissible error.
    Conforming,
    /// At least one distance exceeds the permissible error.
    NotConforming,
    /// The certificate's uncertainty is more than a quarter of the permissible error.
    BarTooUncertain,
    /// The campaign contains no uncertainty of the length.
    NoCertificate,
}

/// A stationary ball that is measured repeatedly: distances of the readings from their mean
/// (thesis, eq. 2.7 to 2.10).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BallResult {
    /// Name of the ball.
    pub name: String,
    /// Number of readings.
    pub count: usize,
    /// Mean distance.
    pub mean_mm: f64,
    /// Standard deviation of the distance.
    pub standard_deviation_mm: f64,
    /// Mean plus three standard deviations.
    pub repeatability_mm: f64,
}

/// Mean errors of some poses (thesis, tables 2.2 to 2.4).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PoseTable {
    /// Title.
    pub title: String,
    /// One row per pose.
    pub rows: Vec<PoseRow>,
}

/// Mean errors of one pose.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PoseRow {
    /// Name of the pose.
    pub pose: PoseName,
    /// Commanded position of C in the base frame: prediction of the nominal model from the joints.
    pub command_mm: [f64; 2],
    /// Commanded orientation.
    pub command_deg: f64,
    /// Number of repeats.
    pub count: usize,
    /// Error with nominal parameters in the geometric base frame.
    pub nominal: MeanError,
    /// Error with the geometric parameters.
    pub geometric: MeanError,
    /// Error with the identified parameters.
    pub identified: MeanError,
    /// Standard deviation over the repeats: the larger of x and y.
    pub standard_deviation_mm: f64,
}

/// Mean error of a pose: measured minus predicted.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MeanError {
    /// Error along x.
    pub x_mm: f64,
    /// Error along y.
    pub y_mm: f64,
    /// Size of the position error.
    pub position_mm: f64,
    /// Orientation error.
    pub orientation_deg: f64,
}

/// Largest and root-mean-square mean errors.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MethodErrors {
    /// `nominal`, `geometric` or `identified`.
    pub name: String,
    /// Largest position error.
    pub position_max_mm: f64,
    /// Root mean square position error.
    pub position_rms_mm: f64,
    /// Largest orientation error.
    pub orientation_max_deg: f64,
}

/// A region of the workspace.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Region {
    /// Name of the region.
    #[serde(flatten, with = "RegionName")]
    pub name: Worded,
    /// Area of the region.
    pub area_mm2: f64,
    /// Corners of the region in the base frame, counterclockwise; z is zero.
    pub corners_mm: Vec<Vector>,
}

worded! {
    /// Name of the region.
    text RegionName: name, name_phrase
}
