//! What `etalon iso230` answers.

use etalon_math::axis;
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

/// The runs to one position from one side.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Approach {
    /// Runs, n.
    pub runs: usize,
    /// Mean unidirectional positioning deviation x̄i.
    pub mean_mm: f64,
    /// Estimator of the unidirectional positioning repeatability si, with n − 1.
    pub estimator_mm: f64,
    /// Unidirectional positioning repeatability Ri = 4 si.
    pub repeatability_mm: f64,
}

/// One position of the axis, approached from both sides.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AxisPosition {
    /// Programmed position.
    pub position_mm: f64,
    /// In positive direction (↑).
    pub forward: Approach,
    /// In negative direction (↓).
    pub backward: Approach,
    /// Mean bidirectional positioning deviation x̄i = (x̄i↑ + x̄i↓) / 2.
    pub mean_mm: f64,
    /// Reversal error Bi = x̄i↑ − x̄i↓.
    pub reversal_mm: f64,
    /// Bidirectional positioning repeatability Ri = max(2 si↑ + 2 si↓ + |Bi|, Ri↑, Ri↓).
    pub repeatability_mm: f64,
}

/// A quantity of both directions together, and of each.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Directions {
    /// Bidirectional.
    pub both_mm: f64,
    /// Unidirectional, in positive direction (↑).
    pub forward_mm: f64,
    /// Unidirectional, in negative direction (↓).
    pub backward_mm: f64,
}

/// Positioning of an axis.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AxisPositioning {
    /// Reversal error B = max |Bi|.
    pub reversal_mm: f64,
    /// Mean reversal error B̄, the mean of all Bi.
    pub mean_reversal_mm: f64,
    /// Positioning repeatability R = max Ri.
    pub repeatability: Directions,
    /// Systematic positioning error E = max x̄i − min x̄i, of both directions together over all x̄i↑ and x̄i↓.
    pub systematic: Directions,
    /// Mean bidirectional systematic positioning error M = max x̄i − min x̄i of the bidirectional means.
    pub mean_systematic_mm: f64,
    /// Positioning accuracy A = max (x̄i + 2 si) − min (x̄i − 2 si), of both directions together over ↑ and ↓.
    pub accuracy: Directions,
}

impl AxisDocument {
    /// The document of an axis measured at `positions`, ascending.
    pub fn new(positions: &[axis::AxisPosition]) -> Self {
        Self {
            schema: "etalon/iso230/1".to_owned(),
            axis: axis::AxisPositioning::new(positions).into(),
            positions: positions.iter().map(|&position| position.into()).collect(),
        }
    }
}

impl From<axis::Approach> for Approach {
    fn from(value: axis::Approach) -> Self {
        let axis::Approach { runs, mean_mm, estimator_mm, repeatability_mm } = value;
        Self { runs, mean_mm, estimator_mm, repeatability_mm }
    }
}

impl From<axis::AxisPosition> for AxisPosition {
    fn from(value: axis::AxisPosition) -> Self {
        let axis::AxisPosition { position_mm, forward, backward, mean_mm, reversal_mm, repeatability_mm } = value;
        let (forward, backward) = (forward.into(), backward.into());
        Self { position_mm, forward, backward, mean_mm, reversal_mm, repeatability_mm }
    }
}

impl From<axis::Directions> for Directions {
    fn from(value: axis::Directions) -> Self {
        let axis::Directions { both_mm, forward_mm, backward_mm } = value;
        Self { both_mm, forward_mm, backward_mm }
    }
}

impl From<axis::AxisPositioning> for AxisPositioning {
    fn from(value: axis::AxisPositioning) -> Self {
        Self {
            reversal_mm: value.reversal_mm,
            mean_reversal_mm: value.mean_reversal_mm,
            repeatability: value.repeatability.into(),
            systematic: value.systematic.into(),
            mean_systematic_mm: value.mean_systematic_mm,
            accuracy: value.accuracy.into(),
        }
    }
}
