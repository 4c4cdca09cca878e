//! Answer of `etalon recommend`: effects that the data prove, and parameters that should be loaded.

use super::{CampaignReference, Effect, Loading, ParametersDocument, Statistics};
use crate::worded::worded;
use etalon_base::message::Message;
use etalon_base::worded::Worded;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Parameters whose identification makes the robot more accurate at poses that were not used.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RecommendationDocument {
    /// Schema and version: `etalon/recommendation/1`.
    pub schema: String,
    /// Model of the robot.
    pub robot: String,
    /// Campaign whose data recommend the parameters.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub campaign: Option<CampaignReference>,
    /// Answer of the run to what a controller should load.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub loading: Option<Loading>,
    /// Recommendation in words.
    #[serde(flatten, with = "RecommendationMeaning")]
    pub meaning: Vec<Worded>,
    /// Extent of the cross-validation.
    #[serde(flatten)]
    pub extent: CrossValidationExtent,
    /// Effects in the order of trial. Accepted effects are part of every later step.
    pub steps: Vec<EffectStep>,
    /// Every identified parameter of the robot itself.
    pub parameters: Vec<ParameterVerdict>,
    /// Position errors at poses that were excluded from the identification (mm).
    pub held_out: HeldOutErrors,
    /// Parameters of the answer: the parameters of the run; with further effects, if these are to
    /// be identified first; or nominal ones.
    pub recommended: ParametersDocument,
    /// Warnings, with remedies.
    pub messages: Vec<Message>,
}

/// Extent of a cross-validation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct CrossValidationExtent {
    /// Number of calibration poses.
    pub poses: usize,
    /// Number of folds; each is predicted from the others.
    pub folds: usize,
    /// Number of repetitions with other folds.
    pub repeats: usize,
}

worded! {
    /// Recommendation in words.
    list RecommendationMeaning: meaning, meaning_phrases
}

/// Trial of an effect in addition to the effects accepted before.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct EffectStep {
    /// Effect; absent in the first step, with base and targets alone.
    pub effect: Option<Effect>,
    /// Number of identified parameters in this step.
    pub identified: usize,
    /// Root-mean-square position error of the calibration poses, all of which are used for
    /// identification (mm); comparable with `held_out_rms_mm`.
    pub rms_mm: f64,
    /// F statistic of the improvement over the previous step.
    pub f: Option<f64>,
    /// Probability of the F statistic if residuals were independent.
    pub p_value: Option<f64>,
    /// Root-mean-square position error at poses that were excluded (mm).
    pub held_out_rms_mm: f64,
    /// Decrease of the mean square error at poses that were excluded, over its standard
    /// uncertainty.
    pub gain_over_u: Option<f64>,
    /// `true` if the effect is part of the recommended model.
    pub accepted: bool,
}

/// Part of a parameter in the answer, and the evidence for its change.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ParameterVerdict {
    /// Name of the parameter.
    pub name: String,
    /// Unit of the parameter.
    pub unit: String,
    /// Effect that the parameter describes.
    pub effect: Effect,
    /// Identified minus nominal value, in the model with all parameters.
    pub change: f64,
    /// Displacement by the change (mm) of the measured point that it moves most; absent if the run
    /// does not identify the parameter.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub displacement_mm: Option<f64>,
    /// Change over its standard uncertainty.
    pub change_over_u: f64,
    /// Probability of such a change if the true value is nominal, corrected for the number of
    /// parameters (Holm 1979).
    pub p_value: f64,
    /// Standard deviation over the folds, relative to the standard uncertainty of one fold.
    pub fold_sd_over_u: f64,
    /// Largest absolute difference between the value from part of the poses and the value from all
    /// poses, over its standard deviation by chance √(u_part² − u_all²). Absent outside the
    /// recommended model, and if no part determines the parameter.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub part_change_over_sd: Option<f64>,
    /// Limit of `part_change_over_sd` by chance, with a probability of 99 % for all parameters
    /// together; beyond it the parameter is unstable.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub part_change_limit: Option<f64>,
    /// Verdict: load the parameters, or do not load them.
    pub verdict: LoadVerdict,
}

/// Verdict on a parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum LoadVerdict {
    /// Load: the parameter is part of the answer.
    Load,
    /// Hold at nominal: the parameter is not part of the answer.
    Hold,
}

/// Errors at poses that were excluded from the identification of parameters.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HeldOutErrors {
    /// Errors with nominal parameters; base and targets are fitted.
    pub none: Statistics,
    /// Errors with all parameters that the run identifies.
    pub all: Statistics,
    /// Errors with the recommended parameters.
    pub recommended: Statistics,
}
