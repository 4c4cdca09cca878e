//! What `etalon uncertainty` answers: distributions of a campaign's results.

use super::{Provenance, UncertaintyFrom};
use etalon_base::message::Message;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Distributions by Monte Carlo (JCGM 101) and bootstrap beside the linear uncertainties.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct UncertaintyDocument {
    /// `etalon/uncertainty/1`
    pub schema: String,
    /// Model of the robot.
    pub robot: String,
    /// Draws of the whole campaign: frames, readings, what they have in common.
    pub draws: usize,
    /// Whether two digits of every standard uncertainty and of the ends of the intervals are reached (JCGM 101, 7.9.4).
    pub two_digits_reached: bool,
    /// Resamples of poses and cycles; 0 where these do not determine the parameters.
    pub resamples: usize,
    /// What the standard uncertainties of the identification rest on. Draws contain what is stated, not what the model leaves out.
    pub uncertainties_from: UncertaintyFrom,
    /// The identified parameters.
    pub parameters: Vec<DistributionEntry>,
    /// Mean, root mean square and largest position error of the validation poses (`mean`, `rms`, `max`).
    pub errors: Vec<DistributionEntry>,
    /// Warnings of the identification.
    pub messages: Vec<Message>,
    /// Where the numbers come from; seed of the draws.
    pub provenance: Provenance,
}

/// The distribution of one result.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DistributionEntry {
    /// Name of the parameter or figure.
    pub name: String,
    /// `mm`, `deg` or `1`.
    pub unit: String,
    /// The result of the campaign.
    pub value: f64,
    /// Standard uncertainty by linear propagation of what is stated: what the draws are compared with.
    pub linear: Option<f64>,
    /// Standard uncertainty that the report states, which contains what the model leaves out.
    pub standard_uncertainty: Option<f64>,
    /// Mean of the draws; absent for errors, which are sizes: draws add their scatter to the readings', and sizes grow by it.
    pub mean: Option<f64>,
    /// Their standard deviation.
    pub standard_deviation: f64,
    /// 2.5 % of the draws are below, 2.5 % above; absent for errors.
    pub interval_95: Option<[f64; 2]>,
    /// Whether value ± 1.96 times the linear uncertainty has the same ends, to half of its second digit (JCGM 101, 8.1) and twice the standard
    /// deviation of an end by so many draws.
    pub agrees: Option<bool>,
    /// Standard deviation over the resamples; absent where there are none.
    pub bootstrap: Option<f64>,
}
