//! What `etalon batch --json` answers.

use indexmap::IndexSet;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// How the campaigns of a batch ended.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BatchDocument {
    /// `etalon/batch/1`
    pub schema: String,
    /// Campaigns whose limits are met, or that state none.
    pub done: usize,
    /// Campaigns with a limit that is not met, or a result that cannot be the robot.
    pub not_met: usize,
    /// Campaigns that did not run.
    pub failed: usize,
    /// Campaigns whose data are not there, by a variable of the environment.
    pub skipped: usize,
    /// One each, in the order in which they were named.
    pub campaigns: Vec<BatchEntry>,
}

/// One campaign of a batch.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BatchEntry {
    /// The folder as the user named it.
    pub campaign: String,
    /// The campaign's name.
    pub name: String,
    /// Name of the robot, or of its model.
    pub robot: Option<String>,
    /// When it was measured.
    pub date: Option<String>,
    /// How it ended.
    pub ended: BatchEnd,
    /// Whether it was run; else nothing of it has changed since its last run.
    pub computed: bool,
    /// Its output folder.
    pub output: Option<String>,
    /// Why it failed or was skipped.
    pub message: Option<String>,
}

/// How a campaign ended.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum BatchEnd {
    /// All limits are met, or none is stated.
    Done,
    /// A limit is not met, or the result cannot be the robot.
    NotMet,
    /// It did not run.
    #[default]
    Failed,
    /// Its data are not there.
    Skipped,
}

impl BatchEnd {
    /// As documents spell it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Done => "done",
            Self::NotMet => "not_met",
            Self::Failed => "failed",
            Self::Skipped => "skipped",
        }
    }
}

/// A quantity that the page over all campaigns shows.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Serialize)]
pub struct BatchQuantity {
    /// Its name.
    pub name: String,
    /// Its unit.
    pub unit: String,
}

/// Results of the campaigns of a batch, as far as its page shows them.
#[derive(Debug, Default)]
pub struct BatchFigures {
    /// Every quantity that a campaign has.
    pub quantities: IndexSet<BatchQuantity>,
    /// By campaign.
    pub values: Vec<Vec<BatchValue>>,
}

/// A result of a campaign.
#[derive(Clone, Copy, Debug)]
pub struct BatchValue {
    /// Index of its quantity.
    pub quantity: usize,
    /// In the unit of the quantity.
    pub value: f64,
    /// Its standard uncertainty, where it has one.
    pub standard_uncertainty: Option<f64>,
}

impl BatchFigures {
    /// Adds the next campaign: names, units, values and their standard uncertainties.
    pub fn add<'a>(&mut self, figures: impl Iterator<Item = (&'a str, &'a str, f64, Option<f64>)>) {
        let mut place = |name: &str, unit: &str| {
            self.quantities.insert_full(BatchQuantity { name: name.to_owned(), unit: unit.to_owned() }).0
        };
        let value = |(name, unit, value, standard_uncertainty)| BatchValue {
            quantity: place(name, unit),
            value,
            standard_uncertainty,
        };
        self.values.push(figures.map(value).collect());
    }
}

impl BatchDocument {
    /// Of these campaigns.
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
