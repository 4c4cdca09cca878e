//! Answers of commands that write no document of a campaign: `--json` of check, formats, report,
//! export, simulate, init.

use super::{ControllerErrors, LoadAnswer, Source, Uncontrolled};
use crate::worded::worded;
use etalon_base::catalogue::{Arguments, Entry, Phrase};
use etalon_base::message::{Message, Severity};
use etalon_base::worded::Worded;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Findings of `etalon check`. The exit code is 2 if there are errors, otherwise 0.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CheckDocument {
    /// Schema and version: `etalon/check/1`.
    pub schema: String,
    /// The campaign as the user named it.
    pub campaign: String,
    /// Errors that prevent the campaign from running.
    pub errors: Vec<Finding>,
    /// Warnings of a report.
    pub warnings: Vec<Finding>,
    /// Files read, and rows rejected by a rule; empty if reading found errors.
    pub sources: Vec<Source>,
    /// Travel of the joints in the calibration poses; empty if the poses are unknown.
    #[serde(default)]
    pub joints: Vec<JointTravel>,
    /// Errors that no reading of the campaign can show.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub not_controlled: Vec<Uncontrolled>,
}

/// Smallest and largest value of a joint.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct JointTravel {
    /// Column of the joint with its unit: `q1_deg`, `rho1_mm`.
    pub column: String,
    /// Smallest value.
    pub lowest: f64,
    /// Largest value.
    pub highest: f64,
}

/// One error or warning. Members that do not apply are null.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Finding {
    /// Id in the catalogue of messages; `etalon explain ID` explains it.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub id: String,
    /// Arguments of the text in the catalogue.
    #[serde(default, skip_serializing_if = "Arguments::is_empty")]
    pub arguments: Arguments,
    /// Problem, in one English sentence.
    pub what: String,
    /// File of the problem.
    pub file: Option<String>,
    /// Line of the problem, from 1.
    pub line: Option<usize>,
    /// Column of the problem in the line (characters, from 1).
    pub column: Option<usize>,
    /// Text of the line.
    pub text: Option<String>,
    /// Expected content at this place.
    pub expected: Option<String>,
    /// Next action.
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
    /// Separates messages into errors and warnings.
    pub fn new(campaign: String, messages: &[Message], sources: Vec<Source>) -> Self {
        let of = |severity| messages.iter().filter(|m| m.severity == severity).map(Finding::from).collect();
        Self {
            schema: "etalon/check/1".to_owned(),
            campaign,
            errors: of(Severity::Error),
            warnings: of(Severity::Warning),
            sources,
            joints: Vec::new(),
            not_controlled: Vec::new(),
        }
    }
}

/// Answer of `etalon explain`: explanations of messages.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ExplanationDocument {
    /// Schema and version: `etalon/explanation/1`.
    pub schema: String,
    /// Requested message, or all messages.
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
    /// Expected value or state; null if the text contains it.
    pub expected: Option<String>,
    /// Hint of the message; null if the message has no hint.
    pub hint: Option<String>,
    /// Meaning of the message.
    pub meaning: String,
    /// Consequence of the message.
    pub reason: String,
    /// Next action.
    pub action: String,
    /// Input that causes the message.
    pub example: String,
}

impl ExplanationDocument {
    /// Creates the explanations of these entries of the catalogue.
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

/// Proposals of `etalon formats` for reading a file.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FormatsDocument {
    /// Schema and version: `etalon/formats/1`.
    pub schema: String,
    /// The file as the user named it.
    pub file: String,
    /// Name of the format, if the file contains one. Such a file needs no proposal.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub format: Option<String>,
    /// Proposed use of the file: `export`, `export with joints`, `log`, `observations`, `poses`,
    /// `commanded`, `recording` ...
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub kind: String,
    /// Number of examined data rows.
    #[serde(default)]
    pub rows: usize,
    /// Proposed contents of each column of the first reading, with reasons.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub columns: Vec<FormatsColumn>,
    /// Readings that explain the file, the proposed one first.
    pub readings: Vec<Reading>,
    /// Reasons for the first proposal.
    #[serde(flatten, with = "FormatsReasons")]
    pub reasons: Vec<Worded>,
    /// Doubts about the first proposal.
    #[serde(flatten, with = "FormatsDoubts")]
    pub doubts: Vec<Worded>,
    /// Facts that the file cannot give and the campaign must.
    #[serde(flatten, with = "FormatsQuestions")]
    pub questions: Vec<Worded>,
    /// Join with a log, if several files were named.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub join: Option<FormatsJoin>,
    /// Proposal as lines for campaign.toml, with reasons, doubts and questions as comments.
    pub toml: String,
    /// Facts for the proposals of other files. Not in the file.
    #[serde(skip)]
    pub facts: ProposalFacts,
}

/// Facts about a proposal that other proposals need.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ProposalFacts {
    /// `true` if the robot's names of its joints name the columns.
    pub joints_named: bool,
    /// Largest residual (mm) of points that the nominal robot reproduces.
    pub reproduced_mm: Option<f64>,
    /// `true` if a reason says that only the first rows were examined.
    pub is_sampled: bool,
    /// Doubt about commanded poses that a table of attained poses resolves.
    pub without_attained: Option<Phrase>,
}

worded! {
    /// Reasons for the first proposal.
    list FormatsReasons: reasons, reason_phrases
}

worded! {
    /// Doubts about the first proposal.
    list FormatsDoubts: doubts, doubt_phrases
}

worded! {
    /// Facts that the file cannot give and the campaign must.
    list FormatsQuestions: questions, question_phrases
}

impl FormatsDocument {
    /// Adds a reason for the proposal.
    pub fn because(&mut self, reason: Phrase) {
        self.reasons.push(reason.into());
    }

    /// Adds a doubt about the proposal.
    pub fn doubt(&mut self, doubt: Phrase) {
        self.doubts.push(doubt.into());
    }

    /// Adds a question that the campaign has to answer.
    pub fn ask(&mut self, question: Phrase) {
        self.questions.push(question.into());
    }
}

/// Proposed join of an export with a log.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FormatsJoin {
    /// File of the log.
    pub log: String,
    /// Key of the join: `pose`, `pose, cycle`, `label`, `row` or `time`.
    pub by: String,
    /// Number of rows of the export.
    pub keys: usize,
    /// Number of these rows with a row of the log.
    pub matching: usize,
}

/// A column and its proposed contents.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FormatsColumn {
    /// Number of the column, from 1.
    pub number: usize,
    /// Heading in the file.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub heading: Option<String>,
    /// Unit in the heading.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub unit: Option<String>,
    /// Proposed contents of the column.
    #[serde(flatten, with = "FormatsColumnTakenFor")]
    pub taken_for: Worded,
    /// Evidence for the contents.
    #[serde(flatten, with = "FormatsColumnWhy")]
    pub why: Worded,
    /// Number of the joint, from 1, whose values the column has. Not in the file.
    #[serde(skip)]
    pub joint: Option<usize>,
}

worded! {
    /// Proposed contents of the column.
    text FormatsColumnTakenFor: taken_for, taken_for_phrase
}

worded! {
    /// Evidence for the contents.
    text FormatsColumnWhy: why, why_phrase
}

/// Interpretation of a delimited text, without the unit of lengths.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Reading {
    /// Value of the campaign's key `delimiter`; absent for a sheet of a workbook.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub delimiter: Option<String>,
    /// Value of the campaign's key `sheet`, for a workbook.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sheet: Option<String>,
    /// Value of the campaign's key `decimal`.
    pub decimal: String,
    /// Value of the campaign's key `thousands`, if digits are grouped.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub thousands: Option<String>,
    /// Number of rows before the data.
    pub header: usize,
    /// Value of the campaign's key `columns`.
    pub columns: Vec<String>,
    /// Share of the examined rows that have the most frequent number of fields, at least two of
    /// them numbers (0 to 1).
    pub share: f64,
}

/// Files that a command wrote: report, export, simulate and init.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WrittenDocument {
    /// Schema and version: `etalon/written/1`.
    pub schema: String,
    /// Files in the order of writing.
    pub files: Vec<String>,
    /// Position errors with the controller files that `etalon export` wrote, if the run measured
    /// them.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub controllers: Vec<WrittenController>,
    /// Answer of the run to the question of what a controller should load; absent without a run.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub loading: Option<LoadAnswer>,
}

/// One controller file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WrittenController {
    /// Name of the format.
    pub format: String,
    /// Identified parameters that the format cannot contain.
    pub left_out: Vec<String>,
    /// Errors at validation poses, or at calibration poses in a campaign without validation; null
    /// if they were not measured.
    pub errors: Option<ControllerErrors>,
    /// Warnings about this file.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub messages: Vec<Message>,
}

impl WrittenDocument {
    /// Creates the document of written files.
    pub fn new(files: Vec<String>) -> Self {
        Self { schema: "etalon/written/1".to_owned(), files, controllers: Vec::new(), loading: None }
    }
}
