//! Answer of `etalon study`.

use super::Provenance;
use crate::worded::worded;
use etalon_base::worded::Worded;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Comparison of sets of poses under given noise.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StudiesDocument {
    /// Schema and version: `etalon/study/1`.
    pub schema: String,
    /// Model of the robot.
    pub robot: String,
    /// Definition of the errors `before` and `after`, in words.
    #[serde(flatten, with = "StudiesError")]
    pub error: Worded,
    /// Number of calibrations whose mean is evaluated.
    pub runs: u64,
    /// Number of such means, over which intervals are taken.
    pub draws: u64,
    /// One entry for each set and noise.
    pub designs: Vec<StudiedDesign>,
    /// Origin of the numbers.
    pub provenance: Provenance,
}

worded! {
    /// Definition of the errors `before` and `after`, in words.
    text StudiesError: error, error_phrase
}

/// A set of poses measured with one noise.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StudiedDesign {
    /// Name of the set.
    pub name: String,
    /// Standard deviation of the Gaussian noise of one coordinate.
    pub noise_um: f64,
    /// Number of measured configurations.
    pub configurations: usize,
    /// Parameters.
    pub parameters: Vec<DesignParameter>,
    /// Errors with nominal parameters.
    pub before: Vec<DesignError>,
    /// Errors with the identified parameters.
    pub after: Vec<DesignError>,
}

/// A parameter in repeated calibrations.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DesignParameter {
    /// Name of the parameter.
    pub name: String,
    /// `mm`, `deg` or `1`.
    pub unit: String,
    /// Nominal value.
    pub nominal: f64,
    /// True value.
    pub actual: f64,
    /// Mean over the runs of a draw.
    pub mean: Spread,
    /// Three standard deviations over the runs of a draw.
    pub three_standard_deviations: Spread,
}

/// Error of one quantity over the workspace.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DesignError {
    /// `position`, `x`, `y`, `z` or `orientation`.
    pub quantity: String,
    /// `mm` or `deg`.
    pub unit: String,
    /// Root mean square.
    pub rms: Spread,
    /// Largest.
    pub max: Spread,
}

/// Median of the draws and the interval that contains 95 % of them.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Spread {
    /// 2.5th percentile.
    pub low: f64,
    /// Median.
    pub median: f64,
    /// 97.5th percentile.
    pub high: f64,
}

impl Spread {
    /// Percentiles of `values`; NaN if there are none.
    pub fn new(values: impl IntoIterator<Item = f64>) -> Self {
        let mut values: Vec<f64> = values.into_iter().collect();
        values.sort_by(f64::total_cmp);
        let last = values.len().saturating_sub(1) as f64;
        let at = |share: f64| values.get((share * last).round() as usize).copied().unwrap_or(f64::NAN);
        Self { low: at(0.025), median: at(0.5), high: at(0.975) }
    }
}
