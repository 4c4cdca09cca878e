//! Answer of `etalon verify`: verdict on whether given parameters still apply.

use super::{CampaignReference, ErrorQuantity, Provenance};
use crate::worded::worded;
use etalon_base::message::{Message, Severity};
use etalon_base::pose_name::PoseName;
use etalon_base::worded::Worded;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Test of whether previously identified parameters explain today's observations.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct VerificationDocument {
    /// Schema and version: `etalon/verification/1`.
    pub schema: String,
    /// Model of the robot.
    pub robot: String,
    /// Campaign that identified the parameters; absent if their folder does not contain
    /// `campaign.json`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub calibration: Option<CampaignReference>,
    /// Verdict on the parameters.
    pub verdict: VerificationVerdict,
    /// Verdict in words.
    #[serde(flatten, with = "VerificationMeaning")]
    pub meaning: Worded,
    /// Test for changes, with the movements that may explain them.
    #[serde(flatten)]
    pub evidence: ChangeEvidence,
    /// Residuals, with the values that are expected if nothing has changed.
    #[serde(flatten)]
    pub residuals: VerifiedResiduals,
    /// Warnings, with remedies.
    pub messages: Vec<Message>,
    /// Origin of the numbers.
    pub provenance: Provenance,
}

worded! {
    /// Verdict in words.
    text VerificationMeaning: meaning, meaning_phrase
}

/// Test for changes, with the movements that may explain them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ChangeEvidence {
    /// Probability of residuals at least this large if nothing has changed.
    pub p_value: f64,
    /// Significance level: the robot counts as changed if the p-value is below it.
    pub significance: f64,
    /// Object that has moved, with its displacement, if a single movement explains the residuals.
    pub moved: Option<Movement>,
    /// Names of the other movements that explain the residuals about as well as `moved`.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub alike: Vec<String>,
    /// All single movements that may explain the residuals, the best explanation first.
    pub explanations: Vec<Movement>,
    /// Detection power of these observations.
    pub power: DetectionPower,
    /// Residuals that a movement of base and joints can produce.
    pub of_changes: SumOfSquares,
    /// All other residuals.
    pub of_rest: SumOfSquares,
}

fn is_zero(count: &usize) -> bool {
    *count == 0
}

/// Residuals, with the values that are expected if nothing has changed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct VerifiedResiduals {
    /// Number of observed poses.
    pub poses: usize,
    /// Number of measured positions.
    pub points: usize,
    /// Number of rows whose values are equal to values of the calibration: a copy of its readings
    /// verifies nothing.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub copies: usize,
    /// Root-mean-square residual of a coordinate (mm); zero without positions.
    pub rms_mm: f64,
    /// Expected root-mean-square residual if nothing has changed (mm).
    pub expected_rms_mm: f64,
    /// Root-mean-square residual of a position (mm).
    pub position_rms_mm: f64,
    /// Expected root-mean-square residual of a position if nothing has changed (mm).
    pub expected_position_rms_mm: f64,
    /// Residuals of each quantity other than positions of targets.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub conditions: Vec<VerifiedQuantity>,
    /// Standard uncertainty of a measured coordinate (mm).
    pub standard_uncertainty_mm: f64,
    /// Standard deviation of the calibrated model's error of a coordinate, in addition to the
    /// measurement (mm).
    pub model_mm: f64,
}

/// Residuals of the observations of one quantity.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct VerifiedQuantity {
    /// `position`, `orientation`, `distance`, `surface`, `contact` or `coordinate`.
    #[schemars(with = "String")]
    pub quantity: ErrorQuantity,
    /// Unit of the residuals: `mm` or `deg`.
    pub unit: String,
    /// Number of residuals.
    pub count: usize,
    /// Root mean square of the residuals.
    pub rms: f64,
    /// Expected root mean square if nothing has changed, by the uncertainty of the observed values
    /// and the model error of the calibration.
    pub expected_rms: f64,
}

/// Candidates to measure so that `etalon verify` detects the smallest possible changes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct VerificationPlanDocument {
    /// Schema and version: `etalon/verification-plan/1`.
    pub schema: String,
    /// Model of the robot.
    pub robot: String,
    /// Probability with which changes are detected.
    pub probability: f64,
    /// Probability with which the right joint is named.
    pub naming: f64,
    /// Poses in the order of the choice.
    pub steps: Vec<VerificationStep>,
    /// Standard uncertainty of a measured coordinate (mm).
    pub standard_uncertainty_mm: f64,
    /// Standard deviation of the calibrated model's error of a coordinate, in addition to the
    /// measurement (mm).
    pub model_mm: f64,
    /// Warnings, with remedies.
    pub messages: Vec<Message>,
    /// Origin of the numbers.
    pub provenance: Provenance,
}

/// A chosen pose.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct VerificationStep {
    /// Pose.
    pub pose: PoseName,
    /// Smallest changes that this pose and the poses before it detect together.
    pub least: Vec<LeastDetectable>,
}

/// Verdict on given parameters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum VerificationVerdict {
    /// The observations do not contradict the parameters.
    Valid,
    /// The base, or the world frame, has moved.
    BaseMoved,
    /// The zero of one joint has moved.
    Joint,
    /// Another change: a target, several joints, wrong readings, a repaired robot.
    Other,
}

/// A movement, and the remaining residuals.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Movement {
    /// `base`, or the name of the joint or of the target.
    pub name: String,
    /// Kind of the moved object.
    pub kind: MovementKind,
    /// Displacement. Base: shift of its origin and rotation vector, in the world. Joint: change of
    /// its zero. Target: shift on the moving part.
    pub by: Vec<MovementValue>,
    /// Probability of residuals at least as large as those left after the movement.
    pub p_left: f64,
    /// Share of the weighted sum of squared residuals that the movement explains.
    pub explained_share: f64,
}

/// Kind of an object that can move.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum MovementKind {
    /// Base in the world.
    Base,
    /// Zero of a joint.
    Joint,
    /// Target on the moving part.
    Target,
}

impl VerificationDocument {
    /// `true` if an error says that the parameters belong to another robot.
    pub fn is_refused(&self) -> bool {
        self.messages.iter().any(|message| message.severity == Severity::Error)
    }
}

/// One component of a movement.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MovementValue {
    /// `x`, `y`, `z`, `rx`, `ry`, `rz`, or the name of a joint.
    pub name: String,
    /// `mm` or `deg`.
    pub unit: String,
    /// Value of the component.
    pub value: f64,
    /// Standard uncertainty (k = 1); absent if the observations do not determine the component.
    pub standard_uncertainty: Option<f64>,
}

/// Smallest movements that the observations can detect.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DetectionPower {
    /// Probability of detection.
    pub probability: f64,
    /// Probability with which the right joint is named.
    pub naming: f64,
    /// One entry each for `shift` and `rotation` of the base in the least observable direction, and
    /// for every joint.
    pub least: Vec<LeastDetectable>,
}

/// Smallest detectable movement of one kind.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LeastDetectable {
    /// `base shift`, `base rotation`, or the name of a joint.
    pub name: String,
    /// `mm` or `deg`.
    pub unit: String,
    /// Smallest detectable movement; absent if the observations cannot show it.
    pub value: Option<f64>,
    /// Smallest movement of a joint that is detected and attributed to the right joint with the
    /// probability `naming`; absent if another joint moves all targets equally.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub named: Option<f64>,
}

/// Weighted sum of squared residuals.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SumOfSquares {
    /// Sum.
    pub value: f64,
    /// Degrees of freedom.
    pub degrees_of_freedom: usize,
    /// Probability of a larger sum if nothing has changed.
    pub p_value: f64,
}
