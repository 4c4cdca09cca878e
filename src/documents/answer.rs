//! What commands answer that make no document of a campaign: `--json` of check, formats, report, export, simulate, init.

use super::{ControllerErrors, Source};
use etalon_base::catalogue::{Arguments, Entry};
use etalon_base::message::{Message, Severity};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What `etalon check` found. Without errors the exit code is 0, with any it is 2.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CheckDocument {
    /// `etalon/check/1`
    pub schema: String,
    /// The campaign as the user named it.
    pub campaign: String,
    /// What must be put right before the campaign can run.
    pub errors: Vec<Finding>,
    /// What a report would warn of.
    pub warnings: Vec<Finding>,
    /// Files that were read, and the rows refused by rule; empty where reading found errors.
    pub sources: Vec<Source>,
    /// How far the joints move in the calibration poses; empty where these are not known.
    #[serde(default)]
    pub joints: Vec<JointTravel>,
}

/// Least and largest value of a joint.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct JointTravel {
    /// Column of the joint, which has its unit: `q1_deg`, `rho1_mm`.
    pub column: String,
    /// Least value.
    pub lowest: f64,
    /// Largest value.
    pub highest: f64,
}

/// One error or warning. What does not apply is null.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Finding {
    /// Id in the catalogue of messages; `etalon explain ID` explains it.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub id: String,
    /// Arguments of the text in the catalogue.
    #[serde(default, skip_serializing_if = "Arguments::is_empty")]
    pub arguments: Arguments,
    /// What is wrong, in one English sentence.
    pub what: String,
    /// In which file.
    pub file: Option<String>,
    /// In which line, from 1.
    pub line: Option<usize>,
    /// At which character of the line, from 1.
    pub column: Option<usize>,
    /// The line itself.
    pub text: Option<String>,
    /// What was expected there.
    pub expected: Option<String>,
    /// What to do.
    pub hint: Option<String>,
}

impl From<&Message> for Finding {
    fn from(message: &Message) -> Self {
        let place = message.place.as_deref();
        Self {
            id: message.id.clone().into_owned(),
            arguments: message.arguments.clone(),
            what: message.what.clone(),
            file: place.map(|p| p.file.clone()),
            line: place.and_then(|p| p.line),
            column: place.and_then(|p| p.column),
            text: place.and_then(|p| p.text.clone()),
            expected: message.expected.clone(),
            hint: message.hint.clone(),
        }
    }
}

impl CheckDocument {
    /// Errors and warnings apart.
    pub fn new(campaign: String, messages: &[Message], sources: Vec<Source>, joints: Vec<JointTravel>) -> Self {
        let of = |severity| messages.iter().filter(|m| m.severity == severity).map(Finding::from).collect();
        Self {
            schema: "etalon/check/1".to_owned(),
            campaign,
            errors: of(Severity::Error),
            warnings: of(Severity::Warning),
            sources,
            joints,
        }
    }
}

/// Explanations of messages: what `etalon explain` answers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ExplanationDocument {
    /// `etalon/explanation/1`
    pub schema: String,
    /// The message that was asked for, or all messages.
    pub messages: Vec<Explanation>,
}

/// Explanation of one message.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Explanation {
    /// Id of the message.
    pub id: String,
    /// English text; arguments are in braces.
    pub text: String,
    /// Expected value or state; null if the text says it.
    pub expected: Option<String>,
    /// Hint of the message; null if it has none of its own.
    pub hint: Option<String>,
    /// What the message means.
    pub meaning: String,
    /// Why it matters.
    pub reason: String,
    /// What to do.
    pub action: String,
    /// Input that causes the message.
    pub example: String,
}

impl ExplanationDocument {
    /// Explanations of these entries of the catalogue.
    pub fn new<'a>(entries: impl IntoIterator<Item = &'a Entry>) -> Self {
        let explanation = |entry: &Entry| Explanation {
            id: entry.id.to_owned(),
            text: entry.pattern(None).unwrap_or_default(),
            expected: entry.pattern(Some("expected")),
            hint: entry.pattern(Some("hint")),
            meaning: entry.meaning.clone(),
            reason: entry.reason.clone(),
            action: entry.action.clone(),
            example: entry.example.clone(),
        };
        let messages = entries.into_iter().map(explanation).collect();
        Self { schema: "etalon/explanation/1".to_owned(), messages }
    }
}

/// How a file could be read: what `etalon formats` proposes.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FormatsDocument {
    /// `etalon/formats/1`
    pub schema: String,
    /// The file as the user named it.
    pub file: String,
    /// Name of the format, where the file states it; it needs no reading then.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub format: Option<String>,
    /// What the file is proposed as: `export`, `export with joints`, `log`, `observations`, `poses`, `commanded`, `recording` ...
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub kind: String,
    /// Rows of data whose values were looked at.
    #[serde(default)]
    pub rows: usize,
    /// What each column of the first reading is taken for, and why.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub columns: Vec<FormatsColumn>,
    /// The reading that is proposed, then others that explain the file as well.
    pub readings: Vec<Reading>,
    /// Why the first is proposed.
    pub reasons: Vec<String>,
    /// Doubts about it.
    pub doubts: Vec<String>,
    /// What the file cannot state, and the campaign must.
    pub questions: Vec<String>,
    /// The proposal as lines for campaign.toml, with all that as comments.
    pub toml: String,
}

/// A column, and what it is taken for.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FormatsColumn {
    /// Number, from 1.
    pub number: usize,
    /// As the header has it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub heading: Option<String>,
    /// Unit that the heading states.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub unit: Option<String>,
    /// What the column is taken for.
    pub taken_for: String,
    /// What shows it.
    pub why: String,
}

/// One reading of a delimited text. The unit of lengths is not part of it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Reading {
    /// As `delimiter` states it in the campaign; of a sheet of a workbook none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub delimiter: Option<String>,
    /// As `sheet` states it, of a workbook.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sheet: Option<String>,
    /// As `decimal` states it.
    pub decimal: String,
    /// As `thousands` states it, where numbers have groups of digits.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub thousands: Option<String>,
    /// Rows before the data.
    pub header: usize,
    /// As `columns` states them.
    pub columns: Vec<String>,
    /// Share of the rows looked at that have as many fields as most, two of them numbers; from 0 to 1.
    pub share: f64,
}

/// Files that a command wrote: report, export, simulate and init.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WrittenDocument {
    /// `etalon/written/1`
    pub schema: String,
    /// Files in the order in which they were written.
    pub files: Vec<String>,
    /// Position errors with the controller files that `etalon export` wrote, as far as the run measured them.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub controllers: Vec<WrittenController>,
}

/// A controller file that was written.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WrittenController {
    /// Name of the format.
    pub format: String,
    /// Identified parameters that the format does not hold.
    pub left_out: Vec<String>,
    /// Errors at validation poses, otherwise at calibration poses; null if they were not measured.
    pub errors: Option<ControllerErrors>,
}

impl WrittenDocument {
    /// These files.
    pub fn new(files: Vec<String>) -> Self {
        Self { schema: "etalon/written/1".to_owned(), files, controllers: Vec::new() }
    }
}
