//! Answer of `etalon uncertainty`: distributions of a campaign's results.

use super::{CampaignReference, ErrorQuantity, Provenance, UncertaintyFrom};
use etalon_base::message::Message;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Distributions by Monte Carlo (JCGM 101) and bootstrap, in addition to the linear uncertainties.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct UncertaintyDocument {
    /// Schema and version: `etalon/uncertainty/1`.
    pub schema: String,
    /// Model of the robot.
    pub robot: String,
    /// The campaign.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub campaign: Option<CampaignReference>,
    /// Number of Monte Carlo draws of the whole campaign: frames, readings, common errors.
    pub draws: usize,
    /// `true` if two significant digits of all standard uncertainties and interval ends are stable
    /// (JCGM 101, 7.9.4).
    pub two_digits_reached: bool,
    /// Number of bootstrap resamples of poses and cycles; 0 if resamples do not determine the
    /// parameters.
    pub resamples: usize,
    /// Basis of the standard uncertainties of the identification. Draws of parameters contain the
    /// given uncertainties and the model error; draws of errors contain the given uncertainties.
    pub uncertainties_from: UncertaintyFrom,
    /// Identified parameters.
    pub parameters: Vec<DistributionEntry>,
    /// Mean, root-mean-square and largest error of the validation poses (`mean`, `rms`, `max`), of
    /// each quantity that was measured.
    pub errors: Vec<DistributionEntry>,
    /// Warnings of the identification.
    pub messages: Vec<Message>,
    /// Origin of the numbers, and seed of the draws.
    pub provenance: Provenance,
}

/// Distribution of one result.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DistributionEntry {
    /// Name of the parameter or statistic.
    pub name: String,
    /// Quantity of an error; absent for parameters.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Option<String>")]
    pub quantity: Option<ErrorQuantity>,
    /// `mm`, `deg` or `1`.
    pub unit: String,
    /// Result of the campaign.
    pub value: f64,
    /// Standard uncertainty by linear propagation of the same contributions as in the draws, for
    /// comparison.
    pub linear: Option<f64>,
    /// Standard uncertainty in the report, including unmodelled errors.
    pub standard_uncertainty: Option<f64>,
    /// Mean of the draws. Absent for errors: draws add scatter to the scatter of the readings,
    /// which increases sizes.
    pub mean: Option<f64>,
    /// Standard deviation of the draws.
    pub standard_deviation: f64,
    /// 2.5th and 97.5th percentiles of the draws; absent for errors.
    pub interval_95: Option<[f64; 2]>,
    /// `true` if value ± 1.96 linear uncertainties agrees with the interval of the draws. The
    /// tolerance is half of the second significant digit (JCGM 101, 8.1) plus twice the standard
    /// deviation of an interval end.
    /// Of an error, `true` if the draws do not have the larger standard uncertainty, within this
    /// tolerance. Otherwise the draws decide (JCGM 101, clause 8).
    pub agrees: Option<bool>,
    /// Standard deviation over the resamples; absent without resamples.
    pub bootstrap: Option<f64>,
}
