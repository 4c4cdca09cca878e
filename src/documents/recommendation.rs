//! What `etalon recommend` answers: which effects the data prove, and which parameters deserve to be loaded.

use super::{Effect, ParametersDocument, Statistics};
use etalon_base::message::Message;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Which of the parameters that a campaign can identify make the robot better at poses that were not used.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RecommendationDocument {
    /// `etalon/recommendation/1`
    pub schema: String,
    /// Model of the robot.
    pub robot: String,
    /// The recommendation in words.
    pub meaning: Vec<String>,
    /// Calibration poses.
    pub poses: usize,
    /// Parts into which they are cut: each is predicted from the others.
    pub folds: usize,
    /// How often, with other parts.
    pub repeats: usize,
    /// Effects in the order in which they were tried; those that were accepted are in every later one.
    pub steps: Vec<EffectStep>,
    /// Every identified parameter of the robot itself.
    pub parameters: Vec<ParameterVerdict>,
    /// Position errors at poses that were left out, mm.
    pub held_out: HeldOutErrors,
    /// The recommended parameters, identified again with all others at their nominal values.
    pub recommended: ParametersDocument,
    /// Warnings, with remedies.
    pub messages: Vec<Message>,
}

/// An effect that was tried beside those accepted before it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct EffectStep {
    /// The effect; absent of base and targets alone, with which it begins.
    pub effect: Option<Effect>,
    /// Parameters that are identified with it.
    pub identified: usize,
    /// Root mean square position error of all calibration poses, from which it is identified, mm: the measure of `held_out_rms_mm`.
    pub rms_mm: f64,
    /// F statistic of what it explains more than the step before.
    pub f: Option<f64>,
    /// Its p value, if residuals were independent.
    pub p_value: Option<f64>,
    /// Root mean square position error at poses that were left out, mm.
    pub held_out_rms_mm: f64,
    /// By how much their mean square became smaller, over its standard uncertainty.
    pub gain_over_u: Option<f64>,
    /// Whether it is part of the recommended model.
    pub accepted: bool,
}

/// Whether a parameter deserves to be loaded.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ParameterVerdict {
    /// Its name.
    pub name: String,
    /// Its unit.
    pub unit: String,
    /// What it describes.
    pub effect: Effect,
    /// Identified minus nominal value, with all parameters.
    pub change: f64,
    /// The change over its standard uncertainty.
    pub change_over_u: f64,
    /// Probability of such a change of a parameter that has its nominal value, corrected for their number (Holm 1979).
    pub p_value: f64,
    /// Standard deviation over the folds, over the standard uncertainty that a fold has.
    pub fold_sd_over_u: f64,
    /// Value by part of the poses minus value by all, over the standard deviation that chance gives it (√(u_part² − u_all²)), without sign: the
    /// largest of the parts; absent outside the recommended model, and where no part determines the parameter.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub part_change_over_sd: Option<f64>,
    /// What chance explains of that, with a probability of 99 % for all parameters together: beyond it the parameter is not stable.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub part_change_limit: Option<f64>,
    /// Load or hold.
    pub verdict: LoadVerdict,
}

/// What to do with a parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum LoadVerdict {
    /// It differs from its nominal value.
    Load,
    /// It is not proven to differ, or depends on which poses it is identified from: its nominal value stays.
    Hold,
}

/// Errors at poses that were left out of the identification, which chose its parameters without them.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HeldOutErrors {
    /// With nominal parameters, base and targets fitted.
    pub none: Statistics,
    /// With all parameters.
    pub all: Statistics,
    /// With those that are recommended.
    pub recommended: Statistics,
}
