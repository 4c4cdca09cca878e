//! First box of a report: verdict, headlines and next steps.

use super::block::Figure;
use super::text::Text;
use etalon_documents::Acceptance;
use serde::Serialize;

/// Adds a capital at the beginning and a full stop at the end.
pub(crate) fn sentence(text: &str) -> String {
    let mut letters = text.chars();
    let first = letters.next().into_iter().flat_map(char::to_uppercase);
    let end =
        if text.ends_with(|c: char| c.is_alphanumeric() || matches!(c, ')' | ']' | '`' | '%')) { "." } else { "" };
    first.chain(letters).chain(end.chars()).collect()
}

/// First box: compliance with all limits, and improvement of the robot.
#[derive(Debug, Default, Serialize)]
pub(crate) struct Verdict {
    pub class: Grade,
    /// Basis of the exit code.
    #[serde(skip)]
    pub met: bool,
    pub sentences: Vec<String>,
    /// Subject of the headlines.
    pub about: String,
    pub headlines: Vec<Headline>,
    /// Limits and headlines in figures.
    pub graphs: Vec<Figure>,
    /// Next steps, the most useful first.
    pub steps: Vec<Step>,
    /// Fields to complete before signing.
    pub to_complete: Option<ToComplete>,
}

/// A next step with its reason.
#[derive(Debug, Serialize)]
pub(crate) struct Step {
    pub what: Text,
    pub reason: Text,
    /// Command to run in the folder of the campaign.
    pub command: Option<String>,
    /// File of the output folder.
    pub file: Option<StepFile>,
}

/// File of the output folder that a step uses.
#[derive(Debug, Serialize)]
pub(crate) struct StepFile {
    /// Name.
    pub name: String,
    /// Address relative to the report.
    pub address: String,
    /// SHA-256, if it is a controller file.
    pub sha256: Option<String>,
}

/// Fields without which a report is a draft.
#[derive(Debug, Serialize)]
pub(crate) struct ToComplete {
    pub title: String,
    pub fields: Vec<String>,
}

/// Style of a verdict.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Grade {
    Good,
    /// Accepted with a reservation.
    #[serde(rename = "warning")]
    Conditional,
    Bad,
    #[default]
    Open,
}

impl Grade {
    /// Good if `met`, otherwise bad.
    pub fn from_met(met: bool) -> Self {
        if met { Self::Good } else { Self::Bad }
    }

    /// Style of a verdict; open if nothing was judged.
    pub fn from_verdict(verdict: Option<Acceptance>) -> Self {
        match verdict {
            Some(Acceptance::Pass) => Self::Good,
            Some(Acceptance::Conditional) => Self::Conditional,
            Some(Acceptance::Fail) => Self::Bad,
            Some(Acceptance::Undecided) | None => Self::Open,
        }
    }
}

/// A number before and after calibration.
#[derive(Debug, Serialize)]
pub(crate) struct Headline {
    pub what: String,
    pub before: String,
    pub after: String,
    pub unit: &'static str,
    /// Unit of the documents, and both values in it.
    #[serde(skip)]
    pub in_documents: (&'static str, [f64; 2]),
}
