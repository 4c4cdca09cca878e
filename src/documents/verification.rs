//! What `etalon verify` answers: whether given parameters still hold.

use super::Provenance;
use etalon_base::message::Message;
use etalon_base::pose_name::PoseName;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Whether parameters that were identified before explain observations of today.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct VerificationDocument {
    /// `etalon/verification/1`
    pub schema: String,
    /// Model of the robot.
    pub robot: String,
    /// What the observations prove.
    pub verdict: VerificationVerdict,
    /// The same in words.
    pub meaning: String,
    /// Probability of residuals as large as these, if nothing has changed.
    pub p_value: f64,
    /// Below this p value the robot is called changed.
    pub significance: f64,
    /// What has moved and by how much, where one thing explains the residuals.
    pub moved: Option<Movement>,
    /// Each thing that may have moved, were it this alone; the best explanation first.
    pub explanations: Vec<Movement>,
    /// What these observations would have detected.
    pub power: DetectionPower,
    /// Residuals that a motion of base and joints can make.
    pub of_changes: SumOfSquares,
    /// All other residuals.
    pub of_rest: SumOfSquares,
    /// Poses of the observations.
    pub poses: usize,
    /// Measured positions.
    pub points: usize,
    /// Root mean square of a coordinate's residual, mm.
    pub rms_mm: f64,
    /// What is expected of it if nothing has changed, mm.
    pub expected_rms_mm: f64,
    /// Standard uncertainty of a measured coordinate, mm.
    pub standard_uncertainty_mm: f64,
    /// What the calibrated model leaves unexplained of a coordinate beside that (standard deviation), mm.
    pub model_mm: f64,
    /// Warnings, with remedies.
    pub messages: Vec<Message>,
    /// Where the numbers come from.
    pub provenance: Provenance,
}

/// Which of some candidates to measure, so that `etalon verify` detects the least changes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct VerificationPlanDocument {
    /// `etalon/verification-plan/1`
    pub schema: String,
    /// Model of the robot.
    pub robot: String,
    /// The probability with which changes are detected.
    pub probability: f64,
    /// The probability with which the right joint is named.
    pub naming: f64,
    /// The poses in the order of their choice.
    pub steps: Vec<VerificationStep>,
    /// Standard uncertainty of a measured coordinate, mm.
    pub standard_uncertainty_mm: f64,
    /// What the calibrated model leaves unexplained of a coordinate beside that (standard deviation), mm.
    pub model_mm: f64,
    /// Warnings, with remedies.
    pub messages: Vec<Message>,
    /// Where the numbers come from.
    pub provenance: Provenance,
}

/// A pose that was chosen.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct VerificationStep {
    /// The pose.
    pub pose: PoseName,
    /// What it would detect together with those before it.
    pub least: Vec<LeastDetectable>,
}

/// What observations prove of given parameters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum VerificationVerdict {
    /// The observations do not contradict the parameters.
    Valid,
    /// The base, or the world frame, has moved.
    BaseMoved,
    /// The zero of one joint has moved.
    Joint,
    /// Something else: a target, several joints, wrong readings, a robot that has been repaired.
    Other,
}

/// A motion, and what it leaves.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Movement {
    /// `base`, or the name of the joint or of the target.
    pub name: String,
    /// What it is.
    pub kind: MovementKind,
    /// By how much: of the base a shift at its origin and a rotation vector in the world, of a joint its value, of a target a shift on the
    /// moving part.
    pub by: Vec<MovementValue>,
    /// Probability of residuals as large as those that it leaves.
    pub p_left: f64,
}

/// What can move.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum MovementKind {
    /// The base in the world.
    Base,
    /// The zero of a joint.
    Joint,
    /// A target on the moving part.
    Target,
}

/// One number of a motion.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MovementValue {
    /// `x`, `y`, `z`, `rx`, `ry`, `rz`, or the name of a joint.
    pub name: String,
    /// `mm` or `deg`.
    pub unit: String,
    /// Its value.
    pub value: f64,
    /// Standard uncertainty (k = 1); absent where the observations do not show it.
    pub standard_uncertainty: Option<f64>,
}

/// The least motions that the observations would have detected.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DetectionPower {
    /// The probability with which they would.
    pub probability: f64,
    /// The probability with which the right joint is named.
    pub naming: f64,
    /// One each: `shift` and `rotation` of the base in the direction that shows least, and every joint.
    pub least: Vec<LeastDetectable>,
}

/// The least motion of one kind that would have been detected.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LeastDetectable {
    /// `base shift`, `base rotation`, or the name of a joint.
    pub name: String,
    /// `mm` or `deg`.
    pub unit: String,
    /// The motion; absent where the observations do not show it.
    pub value: Option<f64>,
    /// The least motion of a joint that is detected and attributed to this joint with the probability `naming`; absent where another
    /// joint moves all targets alike.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub named: Option<f64>,
}

/// A sum of squares of residuals over their variance.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SumOfSquares {
    /// The sum.
    pub value: f64,
    /// Its degrees of freedom.
    pub degrees_of_freedom: usize,
    /// Probability of a larger one if nothing has changed.
    pub p_value: f64,
}
