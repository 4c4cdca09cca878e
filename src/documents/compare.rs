//! What `etalon compare` answers.

use super::UncertaintyFrom;
use super::{Conditions, Provenance};
use etalon_base::message::Message;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Several campaigns of one robot side by side, in the order in which they were named.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CompareDocument {
    /// `etalon/compare/1`
    pub schema: String,
    /// Model of the robot; null where none of the campaigns identifies.
    pub robot: Option<String>,
    /// By which rules changes are judged, and their limitations, in words.
    pub conventions: Vec<String>,
    /// The campaigns.
    pub campaigns: Vec<ComparedCampaign>,
    /// Every quantity over the campaigns.
    pub trends: Vec<CompareTrend>,
    /// Whether the robot's parameters changed at all, all of them together, for each pair of campaigns.
    pub together: Vec<CompareTogether>,
    /// What differs between two campaigns beyond their uncertainties, for each pair of which one or both misfit.
    #[serde(default)]
    pub between_series: Vec<CompareBetween>,
    /// Remarks and warnings.
    pub messages: Vec<Message>,
    /// Version, and the documents that were compared.
    pub provenance: Provenance,
}

/// One campaign.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ComparedCampaign {
    /// Folder as the user named it.
    pub folder: String,
    /// Name of the campaign.
    pub name: String,
    /// Name of the robot, where its file states one.
    #[serde(default)]
    pub robot: Option<String>,
    /// Date as stated.
    pub date: Option<String>,
    /// Conditions as stated.
    #[serde(default)]
    pub conditions: Conditions,
    /// Parameters of the robot that were identified.
    #[serde(default)]
    pub identified: Vec<String>,
    /// Measuring instrument.
    pub instrument: Option<String>,
    /// Expanded uncertainty of one coordinate.
    pub expanded_uncertainty_um: Option<f64>,
    /// Its coverage factor.
    pub coverage_factor: Option<f64>,
    /// Whether its data are synthetic.
    pub synthetic: Option<String>,
    /// What standard uncertainties of parameters rest on.
    pub uncertainties_from: Option<UncertaintyFrom>,
    /// Degrees of freedom of these; null where they are stated and not estimated.
    pub degrees_of_freedom: Option<f64>,
}

/// Quantities that are tested together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum CompareFamily {
    /// Parameters of the robot.
    Robot,
    /// Parameters of base and targets: they change with every set-up.
    SetUp,
    /// Mean errors before and after calibration.
    MeanError,
    /// AP of each pose.
    PoseAccuracy,
    /// Coordinates of the mean position of each pose.
    MeanPosition,
    /// RP of each pose.
    PoseRepeatability,
    /// AT of each recorded path.
    PathAccuracy,
    /// RT of each recorded path.
    PathRepeatability,
}

/// One quantity over the campaigns.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CompareTrend {
    /// With which others it is tested.
    pub family: CompareFamily,
    /// Name of the parameter, or the quantity in words.
    pub name: String,
    /// `mm`, `deg` or `1`.
    pub unit: String,
    /// One for each campaign.
    pub values: Vec<CompareValue>,
    /// Every campaign against the first and against the previous one, where both have the quantity.
    pub changes: Vec<CompareChange>,
}

/// The quantity in one campaign; null where it has none.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CompareValue {
    /// The value.
    pub value: Option<f64>,
    /// Its standard uncertainty (k = 1); null where there is only an interval.
    pub standard_uncertainty: Option<f64>,
    /// Lower end of the 95 % interval.
    pub low: Option<f64>,
    /// Upper end of the 95 % interval.
    pub high: Option<f64>,
}

/// How a quantity changed between two campaigns.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CompareChange {
    /// Number of the earlier campaign, from 1.
    pub from: usize,
    /// Number of the later one.
    pub to: usize,
    /// Later minus earlier.
    pub change: f64,
    /// Later over earlier, for quantities whose intervals are those of the ratio (RP, and RT, of which it is that of the
    /// middles of both intervals); null for others.
    pub ratio: Option<f64>,
    /// Lower end of the 95 % interval of the change, or of the ratio where there is one; null where there is none.
    pub low: Option<f64>,
    /// Upper end.
    pub high: Option<f64>,
    /// Probability of a change at least as large where nothing changed; null without uncertainties.
    pub p: Option<f64>,
    /// The same, corrected for the number of quantities in the family (parameters: Westfall & Young; others: Holm).
    pub p_family: Option<f64>,
    /// Whether the corrected probability is below 5 %.
    pub significant: Option<bool>,
}

/// All robot parameters of two campaigns together.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CompareTogether {
    /// Number of the earlier campaign, from 1.
    pub from: usize,
    /// Number of the later one.
    pub to: usize,
    /// Parameters that both identified.
    pub parameters: usize,
    /// Δᵀ (C₁ + C₂)⁻¹ Δ over the number of parameters: about 1 where nothing changed.
    pub f: f64,
    /// Degrees of freedom of the covariances; null where they are stated and not estimated.
    pub degrees_of_freedom: Option<f64>,
    /// Probability of a value at least as large where nothing changed.
    pub p: f64,
    /// Whether that is below 5 %.
    pub significant: bool,
}

/// Between-series component of two campaigns in which the model misfits.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CompareBetween {
    /// Number of the earlier campaign, from 1.
    pub from: usize,
    /// Number of the later one.
    pub to: usize,
    /// Robot parameters that both identified.
    pub parameters: usize,
    /// Birge ratio √(Δᵀ (C₁ + C₂)⁻¹ Δ over the number of parameters), at least 1: intervals of changes of parameters are enlarged by it.
    pub birge_ratio: f64,
}
