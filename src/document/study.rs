//! A simulated calibration with chosen poses (thesis, section 4.6), and where candidates are.

use crate::base::pose::Vector;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// One candidate on the map of figure 4.7.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CandidatePlace {
    /// Number of the pose.
    pub pose: i64,
    /// Where the first target of the nominal robot is in its first configuration.
    pub at_mm: Vector,
    /// Number of configurations.
    pub configurations: usize,
    /// Whether it was chosen.
    pub chosen: bool,
}

/// A simulated calibration: tables 4.1 to 4.3, figures 4.8 and 4.9.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StudyDocument {
    /// Identifications whose mean counts.
    pub runs: u64,
    /// Such means drawn, whose errors' medians are told; parameters and places are those of the first.
    pub draws: u64,
    /// Standard deviation of the Gaussian noise of one coordinate.
    pub noise_um: f64,
    /// Configurations over which errors are told.
    pub configurations: usize,
    /// Nominal, true and identified parameters with all positions (table 4.1, figure 4.8).
    pub parameters: Vec<StudiedParameter>,
    /// Errors of position by the number of positions measured; the last is the plan (tables 4.2 and 4.3).
    pub steps: Vec<StudyStep>,
    /// Largest error of each pose with all positions measured (figure 4.9).
    pub places: Vec<StudiedPlace>,
}

/// One parameter of a simulated calibration.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StudiedParameter {
    /// Name as in the thesis.
    pub name: String,
    /// `mm`, `deg` or `1`.
    pub unit: String,
    /// Nominal value.
    pub nominal: f64,
    /// True value.
    pub actual: f64,
    /// Mean of the values identified.
    pub identified: f64,
}

/// Errors of position after a simulated calibration.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StudyStep {
    /// Positions measured.
    pub positions: usize,
    /// Configurations in them.
    pub configurations: usize,
    /// Root mean square with nominal parameters.
    pub rms_before_mm: f64,
    /// Largest with nominal parameters.
    pub max_before_mm: f64,
    /// Root mean square with the identified ones, median of the draws.
    pub rms_mm: f64,
    /// Largest with the identified ones, median of the draws.
    pub max_mm: f64,
}

/// Errors of position at one place.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StudiedPlace {
    /// Number of the pose.
    pub pose: i64,
    /// Where the first target is, nominal.
    pub at_mm: Vector,
    /// Largest among its configurations and targets, nominal.
    pub max_before_mm: f64,
    /// Largest with the identified parameters.
    pub max_mm: f64,
}
