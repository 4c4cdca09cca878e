//! Relative accuracy in `accuracy.json`: errors of the distances between poses.

use crate::{PoseSet, Statistics};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Errors of the distances between poses: predicted minus measured distance of one target (or the
/// centre of a platform) at two different poses. The base has no effect on them; the target has
/// none where both poses have the same orientation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RelativeAccuracy {
    /// Set of poses: `validation`, or `calibration` in a campaign without validation poses.
    #[schemars(with = "String")]
    pub set: PoseSet,
    /// Number of pairs of readings of one target at different poses. Of more than 100 000 pairs an
    /// even selection is counted: `all.pairs`; the largest error is the largest in the selection.
    pub available: usize,
    /// All distances.
    pub all: DistanceStatistics,
    /// Distances by steps; steps without a pair are omitted.
    pub steps: Vec<DistanceStatistics>,
}

/// Errors of the distances within a range.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DistanceStatistics {
    /// Shortest measured distance of the range (mm).
    pub from_mm: f64,
    /// End of the range (mm), which is not part of it.
    pub to_mm: f64,
    /// Number of pairs that are counted.
    pub pairs: usize,
    /// Sizes of the errors with nominal parameters (mm).
    pub before: Statistics,
    /// Sizes of the errors with the judged parameters (mm).
    pub after: Statistics,
    /// Expanded uncertainty (mm, k = 2) of `after.rms` by instrument, frames and base; the judged
    /// parameters do not contribute. Absent without a given uncertainty.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub expanded_rms_mm: Option<f64>,
    /// Expanded uncertainty (mm, k = 2) of `after.p95`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub expanded_p95_mm: Option<f64>,
    /// Expanded uncertainty (mm, k = 2) of `after.max`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub expanded_max_mm: Option<f64>,
}
