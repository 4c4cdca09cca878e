//! What `etalon iso230` answers.

use etalon_math::axis::{AxisPosition, AxisPositioning};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Positioning of a linear axis (ISO 230-2:2014).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AxisDocument {
    /// `etalon/iso230/1`
    pub schema: String,
    /// The axis.
    pub axis: AxisPositioning,
    /// Its positions, ascending.
    pub positions: Vec<AxisPosition>,
}
