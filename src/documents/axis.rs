//! Answer of `etalon iso230`.

use crate::mirror::mirror;
use etalon_base::catalogue::Phrase;
use etalon_base::message::Message;
use etalon_base::{phrase, warning};
use etalon_standards::iso230::{self, OutlyingRun, RUNS, Runs, outlying_runs, repeated_runs};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Positioning of a linear axis (ISO 230-2:2014).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AxisDocument {
    /// Schema and version: `etalon/iso230/1`.
    pub schema: String,
    /// Positioning of the axis.
    pub axis: AxisPositioning,
    /// Positions of the axis, ascending.
    pub positions: Vec<AxisPosition>,
    /// Warnings.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub messages: Vec<Message>,
}

mirror! {
    /// Runs to one position from one direction.
    #[derive(Copy)]
    struct Approach of iso230::Approach {
        /// Number of runs n.
        runs: usize,
        /// Mean unidirectional positioning deviation x̄i.
        mean_mm: f64,
        /// Estimator of the unidirectional positioning repeatability si, with n − 1.
        estimator_mm: f64,
        /// Unidirectional positioning repeatability Ri = 4 si.
        repeatability_mm: f64,
    }
}

mirror! {
    /// One position of the axis, approached from both directions.
    #[derive(Copy)]
    struct AxisPosition of iso230::AxisPosition {
        /// Programmed position.
        position_mm: f64,
        /// Approach in positive direction (↑).
        forward: Approach,
        /// Approach in negative direction (↓).
        backward: Approach,
        /// Mean bidirectional positioning deviation x̄i = (x̄i↑ + x̄i↓) / 2.
        mean_mm: f64,
        /// Reversal error Bi = x̄i↑ − x̄i↓.
        reversal_mm: f64,
        /// Bidirectional positioning repeatability Ri = max(2 si↑ + 2 si↓ + |Bi|, Ri↑, Ri↓).
        repeatability_mm: f64,
    }
}

mirror! {
    /// A quantity of both directions together, and of each direction.
    #[derive(Copy)]
    struct Directions of iso230::Directions {
        /// Bidirectional value.
        both_mm: f64,
        /// Unidirectional value in positive direction (↑).
        forward_mm: f64,
        /// Unidirectional value in negative direction (↓).
        backward_mm: f64,
    }
}

mirror! {
    /// Positioning of an axis.
    #[derive(Copy)]
    struct AxisPositioning of iso230::AxisPositioning {
        /// Reversal error B = max |Bi|.
        reversal_mm: f64,
        /// Mean reversal error B̄, the mean of all Bi.
        mean_reversal_mm: f64,
        /// Positioning repeatability R = max Ri.
        repeatability: Directions,
        /// Systematic positioning error E = max x̄i − min x̄i; the bidirectional value is over all
        /// x̄i↑ and x̄i↓.
        systematic: Directions,
        /// Mean bidirectional systematic positioning error M = max x̄i − min x̄i of the
        /// bidirectional means.
        mean_systematic_mm: f64,
        /// Positioning accuracy A = max (x̄i + 2 si) − min (x̄i − 2 si); the bidirectional value is
        /// over ↑ and ↓.
        accuracy: Directions,
    }
}

impl AxisDocument {
    /// Evaluates an axis that was measured at `positions`, ascending; `runs` are the deviations.
    pub fn new(positions: &[iso230::AxisPosition], runs: &[Runs]) -> Self {
        Self {
            schema: "etalon/iso230/1".to_owned(),
            axis: iso230::AxisPositioning::new(positions).into(),
            positions: positions.iter().map(|&position| position.into()).collect(),
            messages: [repeated(runs), outlying(runs), few(positions)].into_iter().flatten().collect(),
        }
    }
}

/// Maximum number of runs that a warning names.
const NAMED: usize = 5;

/// Sign of a direction, as in the table.
fn sign(is_forward: bool) -> &'static str {
    if is_forward { "+1" } else { "-1" }
}

/// Warning of runs that are far from all others of their position and direction.
fn outlying(runs: &[Runs]) -> Option<Message> {
    let found = outlying_runs(runs);
    let named = |v: &OutlyingRun| {
        let OutlyingRun { position_mm, run, distance_mm, median_mm, .. } = v;
        phrase!("outlying-run", position_mm, direction = sign(v.is_forward), run, distance_mm, median_mm)
    };
    let shown: Vec<Phrase> = found.iter().take(NAMED).map(named).collect();
    let more = found.len() - shown.len();
    (!found.is_empty()).then(|| warning!("runs-outlying", count = found.len(), runs = shown, more).to_decide())
}

/// Warning of runs that a table contains more than once.
fn repeated(runs: &[Runs]) -> Option<Message> {
    let times = repeated_runs(runs)?;
    Some(warning!("runs-repeated", times).to_decide())
}

/// Warning of fewer runs or positions than a test of an axis has.
fn few(positions: &[iso230::AxisPosition]) -> Option<Message> {
    let runs = positions.iter().flat_map(|p| [p.forward.runs, p.backward.runs]).min()?;
    let count = positions.len();
    (runs < RUNS || count < RUNS).then(|| warning!("axis-test-short", least = RUNS, runs, positions = count))
}
