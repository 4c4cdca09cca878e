//! What a campaign states of itself, and how residuals compare with that.

use crate::math::identify::{ResidualKind, UncertaintyFrom};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Residuals of the identification.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ResidualSummary {
    /// Residuals of targets or of the pose.
    pub kind: ResidualKind,
    /// Number of residuals.
    pub count: usize,
    /// Root mean square in mm (pose residuals: mm and rad mixed, eq. 3.26).
    pub rms: f64,
    /// Largest, likewise.
    pub max: f64,
    /// Residuals minus identified parameters.
    pub degrees_of_freedom: usize,
    /// Standard uncertainty of one coordinate that is stated, in mm: the instrument's, or the contact's where that is
    /// stated apart.
    pub stated_standard_uncertainty_mm: Option<f64>,
    /// Standard uncertainty in mm that observations of the very same coordinates have in common beside that: the
    /// instrument's, where the contact's is stated apart.
    pub common_standard_uncertainty_mm: Option<f64>,
    /// Chi-square against both.
    pub chi_square: Option<f64>,
    /// What standard uncertainties rest on.
    pub uncertainties_from: UncertaintyFrom,
    /// By how much standard uncertainties are larger than the instrument's alone makes them (median); 1 where chi-square
    /// does not reject the model, or no uncertainty is stated.
    pub uncertainties_enlarged_by: f64,
}

/// What the campaign says about itself, for the head of a report.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CampaignSummary {
    /// Name of the campaign.
    pub name: String,
    /// Name of the robot, where its file states one.
    #[serde(default)]
    pub robot: Option<String>,
    /// Whether its data are synthetic, and what that means; absent for measured data.
    pub synthetic: Option<String>,
    /// Remarks.
    pub notes: Option<String>,
    /// Date as stated.
    pub date: Option<String>,
    /// Operator as stated.
    pub operator: Option<String>,
    /// Measuring instrument.
    pub instrument: Option<String>,
    /// Expanded uncertainty of one coordinate.
    pub expanded_uncertainty_um: Option<f64>,
    /// Its coverage factor.
    pub coverage_factor: Option<f64>,
    /// How well the robot finds a measured point again, where stated.
    pub contact: Option<ContactSummary>,
    /// Temperature during the campaign.
    pub temperature_c: Option<f64>,
    /// Conditions of a test.
    #[serde(default)]
    pub conditions: super::Conditions,
    /// How the report is dressed.
    #[serde(default)]
    pub report: super::Presentation,
}

/// How well the robot finds a measured point again.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ContactSummary {
    /// Half width of what one coordinate repeats within.
    pub repeatability_um: f64,
    /// How many standard deviations that is.
    pub coverage_factor: f64,
}
