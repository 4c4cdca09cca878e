//! Where a robot stood while its log was recorded.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// An interval of a log in which the robot stands, as the campaign's limits say.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StandingInterval {
    /// Line of its first sample, from 1.
    pub line: usize,
    /// Time of its first sample by the log's clock.
    pub from_s: f64,
    /// Time of its last sample.
    pub to_s: f64,
    /// How many samples.
    pub samples: usize,
    /// What the joints did.
    pub joints: Vec<StandingJoint>,
}

/// A joint while it stands, in the unit of its column.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StandingJoint {
    /// Its column in the table of joint values.
    pub column: String,
    /// Mean of the samples: the value that counts.
    pub mean: f64,
    /// Standard deviation of the samples.
    pub standard_deviation: f64,
    /// Largest minus smallest.
    pub range: f64,
}
