//! What geometry alone found, beside the identification of the same campaign.

use etalon_base::message::Message;
use etalon_base::pose::Vector;
use etalon_base::pose_name::PoseName;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The geometric calibration (thesis, chapter 2).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GeometricDocument {
    /// `etalon/geometric/1`
    pub schema: String,
    /// What was taken for what, in words.
    pub definition: String,
    /// One per quantity, with the identified value of the same parameter.
    pub quantities: Vec<GeometricQuantity>,
    /// Covariance of `value` of all quantities, in their order and units.
    pub covariance: Vec<Vec<f64>>,
    /// Residuals of every fit.
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
    /// What a reader must know.
    pub messages: Vec<Message>,
}

/// One quantity, found from points that were measured for it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GeometricQuantity {
    /// Name of the parameter.
    pub name: String,
    /// `mm` or `1`.
    pub unit: String,
    /// Nominal value.
    pub nominal: f64,
    /// Value found; the mean of repeats.
    pub value: f64,
    /// Standard uncertainty (k = 1) of `value`, frames included.
    pub standard_uncertainty: f64,
    /// How repeats scatter, where there are any.
    pub repeats: Option<RepeatStatistics>,
    /// Value that the identification of the same campaign found, where there is one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub identified: Option<f64>,
    /// Its standard uncertainty; absent where it was held.
    pub identified_standard_uncertainty: Option<f64>,
}

/// Scatter of repeated determinations.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RepeatStatistics {
    /// Their number.
    pub count: usize,
    /// Standard deviation of one determination.
    pub standard_deviation: f64,
    /// What the points' own uncertainties make of it; frames that all repeats share cancel.
    pub expected: f64,
    /// Whether the repeats scatter more than that (chi-square, once in a thousand), and enlarged the uncertainty.
    pub enlarged: bool,
}

/// Residuals of one fit.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GeometricStep {
    /// What was fitted.
    pub name: String,
    /// Residuals.
    pub count: usize,
    /// Standard deviation of a residual.
    pub standard_deviation_mm: f64,
    /// What the instrument's stated uncertainty makes of it.
    pub expected_mm: f64,
    /// Largest residual.
    pub max_mm: f64,
    /// Root of the sum of squares.
    pub norm_mm: f64,
    /// By how much points' uncertainties were enlarged because residuals scatter more than expected; else 1.
    pub enlarged_by: f64,
    /// Arc that has points, of circles.
    pub coverage_deg: Option<f64>,
}

/// The lead of an actuator.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LeadResult {
    /// Number of the actuator.
    pub actuator: usize,
    /// Nominal lead of its screw.
    pub nominal_lead_mm: f64,
    /// Actual lead.
    pub actual_lead_mm: f64,
    /// Actual over nominal displacement, less one.
    pub error: f64,
    /// Standard uncertainty of `error`.
    pub standard_uncertainty: f64,
    /// Mean deviation from linear travel, by position.
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
    /// Name of its position.
    pub name: String,
    /// Calibrated length.
    pub length_mm: f64,
    /// Distances measured.
    pub count: usize,
    /// Mean of measured minus calibrated length.
    pub mean_error_mm: f64,
    /// Standard deviation of the distances.
    pub standard_deviation_mm: f64,
    /// Largest error of a single distance.
    pub largest_error_mm: f64,
    /// Expanded uncertainty (k = 2) of the calibrated length, from the certificate.
    pub length_uncertainty_mm: Option<f64>,
    /// Largest error of a distance that the instrument may have.
    pub permissible_error_mm: f64,
    /// That over the certificate's uncertainty; at least 4 is asked for.
    pub uncertainty_ratio: Option<f64>,
    /// What the bar proves of the instrument.
    pub verdict: BarVerdict,
}

/// What a scale bar proves of the instrument.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum BarVerdict {
    /// Every distance is within the permissible error.
    Conforming,
    /// One is not.
    NotConforming,
    /// The certificate's uncertainty is more than a quarter of the permissible error.
    BarTooUncertain,
    /// The campaign states no uncertainty of the length.
    NoCertificate,
}

/// One ball that does not move, measured repeatedly: distances of the readings from their mean (thesis, eq. 2.7 to 2.10).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BallResult {
    /// Its name.
    pub name: String,
    /// Readings.
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
    /// One row a pose.
    pub rows: Vec<PoseRow>,
}

/// Mean errors of one pose.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PoseRow {
    /// Name of the pose.
    pub pose: PoseName,
    /// Commanded position of C in the base frame: what the nominal model makes of the joints.
    pub command_mm: [f64; 2],
    /// Commanded orientation.
    pub command_deg: f64,
    /// Repeats.
    pub count: usize,
    /// With nominal parameters in the geometric base frame.
    pub nominal: MeanError,
    /// With the geometric parameters.
    pub geometric: MeanError,
    /// With the identified parameters.
    pub identified: MeanError,
    /// Standard deviation of x or y over the repeats, the larger.
    pub standard_deviation_mm: f64,
}

/// Mean error of a pose: measured minus predicted.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MeanError {
    /// x.
    pub x_mm: f64,
    /// y.
    pub y_mm: f64,
    /// Length of both.
    pub position_mm: f64,
    /// Orientation.
    pub orientation_deg: f64,
}

/// Largest and root mean square of the mean errors.
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
    /// Which.
    pub name: String,
    /// Its area.
    pub area_mm2: f64,
    /// Its corners in the base frame, counterclockwise; z is zero.
    pub corners_mm: Vec<Vector>,
}
