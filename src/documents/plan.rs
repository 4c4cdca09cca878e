//! `plan.json`: the poses to measure, and a simulated calibration with them (thesis, chapter 4).

use super::{ObservabilitySummary, Provenance};
use crate::worded::worded;
use etalon_base::message::Message;
use etalon_base::pose::Vector;
use etalon_base::pose_name::PoseName;
use etalon_base::worded::Worded;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Poses to measure, and quality of the choice.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PlanDocument {
    /// Schema and version: `etalon/plan/1`.
    pub schema: String,
    /// Model of the robot.
    pub robot: String,
    /// `O1` to `O5`, `D`, `A`, `E` or `I`.
    pub index: String,
    /// Definition of the index, with the scaling of the Jacobian; larger is better.
    #[serde(flatten, with = "PlanDefinition")]
    pub definition: Worded,
    /// `true` if the configurations of a pose are chosen together, `false` if one by one.
    pub grouped: bool,
    /// Candidates and the poses that are chosen from them.
    #[serde(flatten)]
    pub choice: PlanChoice,
    /// Index of the chosen poses, compared with its bounds and with other choices.
    #[serde(flatten)]
    pub optimality: PlanOptimality,
    /// Predictions for a calibration with the chosen poses.
    #[serde(flatten)]
    pub prediction: PlanPrediction,
    /// Positions of the candidates (thesis, fig. 4.7).
    pub places: Vec<CandidatePlace>,
    /// Simulated calibration with the chosen poses, if true parameters are given (thesis, section
    /// 4.6).
    pub study: Option<StudyDocument>,
    /// Parameters that are not separately identifiable, and other messages.
    pub messages: Vec<Message>,
    /// Origin of the numbers.
    pub provenance: Provenance,
}

worded! {
    /// Definition of the index, with the scaling of the Jacobian; larger is better.
    text PlanDefinition: definition, definition_phrase
}

/// Candidates and the poses that are chosen from them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct PlanChoice {
    /// Number of candidates.
    pub candidates: usize,
    /// Number of configurations of all candidates.
    pub configurations: usize,
    /// Poses to measure.
    pub chosen: Vec<PlannedPose>,
    /// Order of `chosen` that shortens the motion of the joints.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub order: Option<MeasuringOrder>,
    /// Limits within which the candidates were drawn, if they were generated.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub generated: Option<GeneratedCandidates>,
    /// Measuring program, if one is written. `chosen` contains the joint values that it commands.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub program: Option<PlannedProgram>,
}

/// Index of the chosen poses, compared with its bounds and with other choices.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct PlanOptimality {
    /// Index of the chosen poses.
    pub value: f64,
    /// Upper bound of the index for any choice of as many candidates; absent for O4, which has no
    /// bound.
    pub bound: Option<f64>,
    /// Largest possible shortfall of the choice from the optimum (%).
    pub at_most_below_percent: Option<f64>,
    /// `true` if the choice is proved to be optimal.
    pub proven_optimal: bool,
    /// Largest possible shortfall from the optimum by the continuous relaxation alone (%).
    pub at_most_below_percent_by_relaxation: Option<f64>,
    /// Number of nodes examined by branch and bound.
    pub nodes: usize,
    /// Greedy choice of the thesis: candidates are added one after the other.
    pub greedy: GreedySummary,
    /// Poses for comparison, if given.
    pub compared: Option<ComparedPoses>,
}

/// Predictions for a calibration with the chosen poses.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct PlanPrediction {
    /// Observability of the chosen poses; absent if not finite.
    pub observability: Option<ObservabilitySummary>,
    /// Parameters, with their predicted uncertainties from the chosen poses.
    pub parameters: Vec<PlannedParameter>,
    /// Predicted standard uncertainty of position over all candidates; absent if the instrument's
    /// uncertainty is not given.
    pub workspace: Option<WorkspaceUncertainty>,
}

impl PlanDocument {
    /// Poses in the order of measurement; in the order of `chosen` if none is given.
    pub fn in_order(&self) -> Vec<&PlannedPose> {
        let PlanChoice { order, chosen, .. } = &self.choice;
        match order.as_ref().filter(|order| order.indices.len() == chosen.len()) {
            Some(order) => order.indices.iter().filter_map(|&i| chosen.get(i)).collect(),
            None => chosen.iter().collect(),
        }
    }
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

/// Order in which poses are measured: nearest neighbour and swaps of legs (2-opt).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MeasuringOrder {
    /// Indices of `chosen`, from 0, in the order of measurement.
    pub indices: Vec<usize>,
    /// Length of the motion: sum over the legs of the largest motion of a joint, as a share of the
    /// joint's span over all candidates.
    pub motion: f64,
    /// Length of the motion in the order of `chosen`.
    pub motion_as_listed: f64,
}

/// Candidates drawn within limits, and numbers of rejected draws by reason.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GeneratedCandidates {
    /// Number of wanted poses.
    pub wanted: usize,
    /// Number of draws.
    pub draws: usize,
    /// Draws beyond limits of joints or links, or without a pose.
    pub beyond_limits: usize,
    /// Draws with a target outside the box.
    pub outside_box: usize,
    /// Draws with a reflector that faces away from the instrument.
    pub facing_away: usize,
    /// Bodies in the way of the instrument, with the draws that each hides first.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub obstacles: Vec<PlannedObstacle>,
    /// Smallest and largest value of each joint, by column.
    pub ranges: BTreeMap<String, [f64; 2]>,
    /// Box of the targets in the base of the robot: smallest and largest `x`, `y`, `z` as given.
    pub box_mm: BTreeMap<String, [f64; 2]>,
    /// Position of the instrument in the base of the robot.
    pub instrument_mm: Option<Vector>,
    /// Reflectors on the flange.
    pub reflectors: Vec<PlannedReflector>,
}

/// A reflector on the flange.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PlannedReflector {
    /// Name of the target.
    pub name: String,
    /// Nominal position in the frame of the flange.
    pub at_mm: Vector,
    /// Outward axis in the frame of the flange, if given.
    pub axis: Option<Vector>,
    /// Largest angle between the axis and the direction to the instrument, if given.
    pub acceptance_deg: Option<f64>,
}

/// A program that drives to the chosen poses.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PlannedProgram {
    /// Name of the file.
    pub file: String,
    /// Language.
    pub language: String,
    /// Waiting time at each pose.
    pub dwell_s: f64,
    /// Digital output that is on during the second half of the waiting time, if given.
    pub trigger: Option<String>,
}

/// A body in the way of the instrument.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PlannedObstacle {
    /// Name; for a link, the name of its joint.
    pub name: String,
    /// `true` if the body is a link of the arm, which moves with the joint of this name.
    pub is_link: bool,
    /// Shape and size (mm), as given.
    pub stated: String,
    /// Draws in which the body hides a reflector, and no earlier one in the list does.
    pub hidden: usize,
}

/// Greedy choice of the thesis.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GreedySummary {
    /// Poses in the order of the choice.
    pub poses: Vec<PoseName>,
    /// Index of the poses.
    pub value: f64,
    /// Index and condition number while candidates are added, beyond the required number.
    pub curve: Vec<CurvePoint>,
    /// Number of configurations at the knee of the curve, where it is farthest above its chord.
    pub knee_configurations: Option<usize>,
}

/// One point of the curve.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CurvePoint {
    /// Number of candidates chosen.
    pub positions: usize,
    /// Number of configurations of these candidates.
    pub configurations: usize,
    /// Index.
    pub value: f64,
    /// Condition number with columns scaled to unit length.
    pub condition: f64,
}

/// Poses for comparison, and their index.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ComparedPoses {
    /// Poses.
    pub poses: Vec<PoseName>,
    /// Index of the poses.
    pub value: f64,
    /// Improvement of the chosen poses over these poses (%).
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
    /// `true` if the parameter is identifiable from the candidates.
    pub identifiable: bool,
    /// Predicted standard uncertainty; absent if the instrument's uncertainty is not given.
    pub standard_uncertainty: Option<f64>,
    /// Parameters that the chosen poses separate from this parameter poorly or not at all.
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

/// One candidate on the map (thesis, fig. 4.7).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CandidatePlace {
    /// Name of the pose.
    pub pose: PoseName,
    /// Position of the first target of the nominal robot in the first configuration.
    pub at_mm: Vector,
    /// Number of configurations.
    pub configurations: usize,
    /// `true` if the candidate was chosen.
    pub chosen: bool,
}

/// Simulated calibration (thesis, tables 4.1 to 4.3, figs. 4.8 and 4.9).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StudyDocument {
    /// Number of identifications whose mean is evaluated.
    pub runs: u64,
    /// Number of such means. The median of their errors is reported; `parameters` and `places` are
    /// from the first.
    pub draws: u64,
    /// Standard deviation of the Gaussian noise of one coordinate.
    pub noise_um: f64,
    /// Number of configurations at which errors are evaluated.
    pub configurations: usize,
    /// Point whose position errors are evaluated, in words.
    #[serde(flatten, with = "StudyPoint")]
    pub point: Worded,
    /// Nominal, true and identified parameters with all positions (thesis, table 4.1, fig. 4.8).
    pub parameters: Vec<StudiedParameter>,
    /// Position errors by the number of measured positions; the last entry is the plan (thesis,
    /// tables 4.2 and 4.3).
    pub steps: Vec<StudyStep>,
    /// Largest error of each pose with all positions measured (thesis, fig. 4.9).
    pub places: Vec<StudiedPlace>,
}

worded! {
    /// Point whose position errors are evaluated, in words.
    text or empty StudyPoint: point, point_phrase
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
    /// Mean of the identified values.
    pub identified: f64,
}

/// Position errors after a simulated calibration.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StudyStep {
    /// Number of positions measured.
    pub positions: usize,
    /// Number of configurations of these positions.
    pub configurations: usize,
    /// Root mean square with nominal parameters.
    pub rms_before_mm: f64,
    /// Largest error with nominal parameters.
    pub max_before_mm: f64,
    /// Root mean square with the identified parameters, median of the draws.
    pub rms_mm: f64,
    /// Largest error with the identified parameters, median of the draws.
    pub max_mm: f64,
}

/// Position errors at one place.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StudiedPlace {
    /// Name of the pose.
    pub pose: PoseName,
    /// Nominal position of the first target.
    pub at_mm: Vector,
    /// Largest nominal error over all configurations and targets of the pose.
    pub max_before_mm: f64,
    /// Largest error with the identified parameters.
    pub max_mm: f64,
}
