//! Answer of `etalon compare`.

use super::UncertaintyFrom;
use super::{Conditions, Provenance};
use crate::worded::worded;
use etalon_base::message::Message;
use etalon_base::worded::Worded;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Comparison of several campaigns of one robot, in the order of the command line.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CompareDocument {
    /// Schema and version: `etalon/compare/1`.
    pub schema: String,
    /// Model of the robot; null if no campaign identifies parameters.
    pub robot: Option<String>,
    /// Rules for judging changes, and their limitations, in words.
    #[serde(flatten, with = "CompareConventions")]
    pub conventions: Vec<Worded>,
    /// Compared campaigns.
    pub campaigns: Vec<ComparedCampaign>,
    /// Every quantity over the campaigns.
    pub trends: Vec<CompareTrend>,
    /// Joint test of all robot parameters for each pair of campaigns.
    pub together: Vec<CompareTogether>,
    /// Between-series components for each pair of campaigns with a misfit in at least one.
    #[serde(default)]
    pub between_series: Vec<CompareBetween>,
    /// Remarks and warnings.
    pub messages: Vec<Message>,
    /// Version, and the compared documents.
    pub provenance: Provenance,
}

worded! {
    /// Rules for judging changes, and their limitations, in words.
    list CompareConventions: conventions, convention_phrases
}

/// One campaign.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ComparedCampaign {
    /// Folder as the user named it.
    pub folder: String,
    /// Name of the campaign.
    pub name: String,
    /// Name of the robot, if its file contains one.
    #[serde(default)]
    pub robot: Option<String>,
    /// Date as given.
    pub date: Option<String>,
    /// Conditions as given.
    #[serde(default)]
    pub conditions: Conditions,
    /// Identified parameters of the robot.
    #[serde(default)]
    pub identified: Vec<String>,
    /// Measuring instrument.
    pub instrument: Option<String>,
    /// Expanded uncertainty of one coordinate.
    pub expanded_uncertainty_um: Option<f64>,
    /// Coverage factor of `expanded_uncertainty_um`.
    pub coverage_factor: Option<f64>,
    /// Explanation of synthetic data; absent for measured data.
    pub synthetic: Option<String>,
    /// Basis of the standard uncertainties of the parameters.
    pub uncertainties_from: Option<UncertaintyFrom>,
    /// Degrees of freedom of the standard uncertainties; null if the uncertainties are given
    /// rather than estimated.
    pub degrees_of_freedom: Option<f64>,
}

/// Quantities that are tested together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum CompareFamily {
    /// Parameters of the robot.
    Robot,
    /// Parameters of base and targets, which change with every set-up.
    SetUp,
    /// Mean errors before and after calibration.
    MeanError,
    /// AP of each pose.
    PoseAccuracy,
    /// Coordinates of the mean attained position of each pose.
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
    /// Family with which the quantity is tested.
    pub family: CompareFamily,
    /// Name of the parameter, or the quantity in words.
    #[serde(flatten, with = "CompareTrendName")]
    pub name: Worded,
    /// `mm`, `deg` or `1`.
    pub unit: String,
    /// One value per campaign.
    pub values: Vec<CompareValue>,
    /// Changes of every campaign from the first and from the previous campaign, where both have the
    /// quantity.
    pub changes: Vec<CompareChange>,
}

worded! {
    /// Name of the parameter, or the quantity in words.
    text CompareTrendName: name,
    /// Text of the catalogue that is `name` in English; absent for a parameter.
    name_phrase
}

/// Value of the quantity in one campaign; null if absent.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CompareValue {
    /// Value.
    pub value: Option<f64>,
    /// Standard uncertainty (k = 1); null if only an interval is known.
    pub standard_uncertainty: Option<f64>,
    /// Lower end of the 95 % interval.
    pub low: Option<f64>,
    /// Upper end of the 95 % interval.
    pub high: Option<f64>,
}

/// Change of a quantity between two campaigns.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CompareChange {
    /// Number of the earlier campaign, from 1.
    pub from: usize,
    /// Number of the later campaign.
    pub to: usize,
    /// Later minus earlier value.
    pub change: f64,
    /// Later over earlier value, for quantities with an interval for the ratio (RP and RT; for RT
    /// the ratio of the interval midpoints). Null for other quantities.
    pub ratio: Option<f64>,
    /// Lower end of the 95 % interval of the ratio, or of the change if there is no ratio; null if
    /// unknown.
    pub low: Option<f64>,
    /// Upper end of the interval.
    pub high: Option<f64>,
    /// Probability of a change at least this large if nothing changed; null without uncertainties.
    pub p: Option<f64>,
    /// Probability `p`, corrected for the number of quantities in the family (parameters: Westfall
    /// & Young; others: Holm).
    pub p_family: Option<f64>,
    /// `true` if the corrected probability is below 5 %.
    pub significant: Option<bool>,
}

/// Joint test of all robot parameters of two campaigns.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CompareTogether {
    /// Number of the earlier campaign, from 1.
    pub from: usize,
    /// Number of the later campaign.
    pub to: usize,
    /// Number of parameters that both campaigns identified.
    pub parameters: usize,
    /// Δᵀ (C₁ + C₂)⁻¹ Δ divided by the number of parameters; about 1 if nothing changed.
    pub f: f64,
    /// Degrees of freedom of the covariances; null if the uncertainties are given rather than
    /// estimated.
    pub degrees_of_freedom: Option<f64>,
    /// Probability of a value at least this large if nothing changed.
    pub p: f64,
    /// `true` if `p` is below 5 %.
    pub significant: bool,
}

/// Between-series component of two campaigns in which the model misfits.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CompareBetween {
    /// Number of the earlier campaign, from 1.
    pub from: usize,
    /// Number of the later campaign.
    pub to: usize,
    /// Number of robot parameters that both campaigns identified.
    pub parameters: usize,
    /// Birge ratio √(Δᵀ (C₁ + C₂)⁻¹ Δ / m) for m parameters, at least 1, by which intervals of
    /// changes of parameters are enlarged.
    pub birge_ratio: f64,
}
