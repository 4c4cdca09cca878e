//! `plan.json`: the poses to measure, and a simulated calibration with them (thesis, chapter 4).

use super::{ObservabilitySummary, Provenance};
use etalon_base::message::Message;
use etalon_base::pose::Vector;
use etalon_base::pose_name::PoseName;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Which poses to measure, and how good that is.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PlanDocument {
    /// `etalon/plan/1`
    pub schema: String,
    /// Model of the robot.
    pub robot: String,
    /// `O1` to `O5`, `D`, `A`, `E` or `I`.
    pub index: String,
    /// What the index is, with the scaling of the Jacobian; larger is better.
    pub definition: String,
    /// All configurations of a pose come together; otherwise one by one.
    pub grouped: bool,
    /// Number of candidates.
    pub candidates: usize,
    /// Number of configurations in them.
    pub configurations: usize,
    /// What to measure.
    pub chosen: Vec<PlannedPose>,
    /// The index of the chosen poses.
    pub value: f64,
    /// No choice of as many candidates has a larger index; absent where there is no bound (O4).
    pub bound: Option<f64>,
    /// By how many per cent at most the choice is below the best possible.
    pub at_most_below_percent: Option<f64>,
    /// Whether the choice is proven to be the best possible.
    pub proven_optimal: bool,
    /// By how many per cent at most it is below, by the continuous relaxation alone.
    pub at_most_below_percent_by_relaxation: Option<f64>,
    /// Nodes of branch and bound that were looked at.
    pub nodes: usize,
    /// The thesis' way: candidates added one after the other.
    pub greedy: GreedySummary,
    /// Poses to compare with, where any were stated.
    pub compared: Option<ComparedPoses>,
    /// Observability of the chosen poses; absent where it is not a number.
    pub observability: Option<ObservabilitySummary>,
    /// Parameters, with their predicted uncertainties from the chosen poses.
    pub parameters: Vec<PlannedParameter>,
    /// Standard uncertainty of position over all candidates that the parameters would leave; absent where the uncertainty
    /// of the instrument is not stated.
    pub workspace: Option<WorkspaceUncertainty>,
    /// Where the candidates are (figure 4.7).
    pub places: Vec<CandidatePlace>,
    /// A simulated calibration with the chosen poses, where a truth is given (section 4.6).
    pub study: Option<StudyDocument>,
    /// Parameters that are not separately identifiable, and other messages.
    pub messages: Vec<Message>,
    /// Where the numbers come from.
    pub provenance: Provenance,
}

/// One pose to measure.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PlannedPose {
    /// Number of the pose in the candidates.
    pub pose: PoseName,
    /// Joint values of each configuration, by column.
    pub configurations: Vec<BTreeMap<String, f64>>,
}

/// The thesis' way.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GreedySummary {
    /// Poses in the order of choosing.
    pub poses: Vec<PoseName>,
    /// Their index.
    pub value: f64,
    /// Index and condition while candidates are added, beyond the number asked for.
    pub curve: Vec<CurvePoint>,
    /// Configurations from which on the index hardly grows: where the curve is farthest above its chord.
    pub knee_configurations: Option<usize>,
}

/// One point of the curve.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CurvePoint {
    /// Candidates chosen.
    pub positions: usize,
    /// Configurations in them.
    pub configurations: usize,
    /// The index.
    pub value: f64,
    /// Condition number with columns divided by their norms.
    pub condition: f64,
}

/// Other poses and their index.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ComparedPoses {
    /// The poses.
    pub poses: Vec<PoseName>,
    /// Their index.
    pub value: f64,
    /// By how many per cent the chosen poses are better.
    pub better_by_percent: f64,
}

/// One parameter and its predicted uncertainty.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PlannedParameter {
    /// Name as in the thesis.
    pub name: String,
    /// `mm`, `deg` or `1`.
    pub unit: String,
    /// Whether it is identifiable from the candidates.
    pub identifiable: bool,
    /// Predicted standard uncertainty; absent where the uncertainty of the instrument is not stated.
    pub standard_uncertainty: Option<f64>,
    /// Parameters that are not, or hardly, separable from this one by the chosen poses.
    pub confounded_with: Vec<String>,
}

/// Uncertainty of position over the candidates.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WorkspaceUncertainty {
    /// Root mean square.
    pub rms_mm: f64,
    /// Largest.
    pub max_mm: f64,
}

/// One candidate on the map of figure 4.7.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CandidatePlace {
    /// Name of the pose.
    pub pose: PoseName,
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
    /// Identifications whose mean is evaluated.
    pub runs: u64,
    /// Such means, of whose errors the median is reported; parameters and places are those of the first.
    pub draws: u64,
    /// Standard deviation of the Gaussian noise of one coordinate.
    pub noise_um: f64,
    /// Configurations at which errors are evaluated.
    pub configurations: usize,
    /// The point whose errors of position these are, in words.
    #[serde(default)]
    pub point: String,
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
    /// Name of the pose.
    pub pose: PoseName,
    /// Where the first target is, nominal.
    pub at_mm: Vector,
    /// Largest among its configurations and targets, nominal.
    pub max_before_mm: f64,
    /// Largest with the identified parameters.
    pub max_mm: f64,
}
