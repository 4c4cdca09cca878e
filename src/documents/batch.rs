//! Answer of `etalon batch --json`.

use crate::Acceptance;
use etalon_base::worded::Worded;
use indexmap::IndexSet;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::hash::{Hash, Hasher};

/// Outcome of the campaigns of a batch.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BatchDocument {
    /// Schema and version: `etalon/batch/1`.
    pub schema: String,
    /// Number of campaigns that meet all limits or have none.
    pub done: usize,
    /// Number of campaigns that fail a limit, or whose result is implausible.
    pub not_met: usize,
    /// Number of campaigns that did not run.
    pub failed: usize,
    /// Number of campaigns that were skipped because an environment variable for their data is
    /// unset.
    pub skipped: usize,
    /// One entry per campaign, in the order of the command line.
    pub campaigns: Vec<BatchEntry>,
}

/// One campaign of a batch.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BatchEntry {
    /// Folder, as the user named it.
    pub campaign: String,
    /// Name of the campaign.
    pub name: String,
    /// Name of the robot, or of its model.
    pub robot: Option<String>,
    /// Date of the measurement.
    pub date: Option<String>,
    /// Last day on which the calibration is valid, as given: year-month-day.
    #[serde(default)]
    pub valid_until: Option<String>,
    /// Outcome.
    pub ended: BatchEnd,
    /// `true` if the campaign was run; `false` if nothing has changed since its last run.
    pub computed: bool,
    /// Output folder of the campaign.
    pub output: Option<String>,
    /// Reason of a failure or omission.
    pub message: Option<String>,
    /// Verdict on the result; null if it was not judged or the campaign did not run.
    #[serde(default)]
    pub verdict: Option<Acceptance>,
    /// Checks of the result: solver, robot, warnings, and each limit.
    #[serde(default)]
    pub checks: Vec<BatchCheck>,
    /// Robots that are alike have the same text: type as given, otherwise model and nominal
    /// parameters. Results are compared among robots that are alike.
    #[serde(default)]
    pub alike: Option<String>,
    /// `true` if the data are synthetic.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub synthetic: bool,
}

/// A check of a campaign's result.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BatchCheck {
    /// `solver` (convergence), `robot` (plausible parameters), `preconditions` (of the verdict),
    /// `warnings` (warnings that need a decision), or the name of a limit in campaigns.
    pub name: String,
    /// Verdict.
    pub verdict: Acceptance,
    /// Value in the unit of the limit, or number of warnings.
    pub value: Option<f64>,
    /// Largest permissible value.
    pub limit: Option<f64>,
    /// Unit of value and limit.
    pub unit: Option<String>,
}

/// Outcome of a campaign.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum BatchEnd {
    /// All limits are met, or no limit is given.
    Done,
    /// A limit is not met, or the result is implausible.
    NotMet,
    /// The campaign did not run.
    #[default]
    Failed,
    /// The data of the campaign are unavailable.
    Skipped,
}

impl BatchEnd {
    /// Name in documents.
    pub fn name(self) -> &'static str {
        match self {
            Self::Done => "done",
            Self::NotMet => "not_met",
            Self::Failed => "failed",
            Self::Skipped => "skipped",
        }
    }
}

/// A quantity on the overview page of all campaigns.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BatchQuantity {
    /// Name of the quantity; a parameter is named by its identifier.
    pub name: Worded,
    /// Unit of the quantity.
    pub unit: String,
}

impl Hash for BatchQuantity {
    fn hash<H: Hasher>(&self, state: &mut H) {
        (self.name.english(), &self.unit).hash(state);
    }
}

/// Results of the campaigns of a batch that the overview page shows.
#[derive(Debug, Default)]
pub struct BatchFigures {
    /// All quantities that occur in any campaign.
    pub quantities: IndexSet<BatchQuantity>,
    /// Values of each campaign.
    pub values: Vec<Vec<BatchValue>>,
}

/// A result of a campaign.
#[derive(Clone, Copy, Debug)]
pub struct BatchValue {
    /// Index of the quantity.
    pub quantity: usize,
    /// Value in the unit of the quantity.
    pub value: f64,
    /// Standard uncertainty of the value, if known.
    pub standard_uncertainty: Option<f64>,
}

impl BatchFigures {
    /// Adds the next campaign: quantities, values and their standard uncertainties.
    pub fn add(&mut self, figures: impl Iterator<Item = (BatchQuantity, f64, Option<f64>)>) {
        let value = |(quantity, value, standard_uncertainty)| BatchValue {
            quantity: self.quantities.insert_full(quantity).0,
            value,
            standard_uncertainty,
        };
        self.values.push(figures.map(value).collect());
    }
}

impl BatchDocument {
    /// Counts the outcomes of `campaigns`.
    pub fn new(campaigns: Vec<BatchEntry>) -> Self {
        let count = |end| campaigns.iter().filter(|c| c.ended == end).count();
        Self {
            schema: "etalon/batch/1".to_owned(),
            done: count(BatchEnd::Done),
            not_met: count(BatchEnd::NotMet),
            failed: count(BatchEnd::Failed),
            skipped: count(BatchEnd::Skipped),
            campaigns,
        }
    }
}
