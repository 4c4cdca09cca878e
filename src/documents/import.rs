//! `import.json`: rows that were read, and rows that were rejected with the reasons.

use crate::worded::worded;
use etalon_base::catalogue::Phrase;
use etalon_base::message::Message;
use etalon_base::worded::Worded;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Rows that were read, and rows that were rejected with the reasons.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ImportDocument {
    /// Schema and version: `etalon/import/1`.
    pub schema: String,
    /// Name of the campaign.
    pub campaign: String,
    /// All files read.
    pub sources: Vec<Source>,
    /// Findings of the blunder rules, and other messages.
    pub messages: Vec<Message>,
    /// Rows without a partner in the join of points and logs, or with more than one, and points
    /// that no target, feature or frame uses.
    #[serde(default)]
    pub unmatched: Vec<Unmatched>,
}

/// A row without a partner in the join, or with more than one; or a point that nothing uses.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Unmatched {
    /// File, as in the campaign.
    pub file: String,
    /// Line in the file, from 1.
    pub line: usize,
    /// Join key of the row in words: pose and cycle, row, or time; the label of a point.
    pub key: String,
    /// Reason: the table without a partner, the number of partners, or that nothing uses the point.
    #[serde(flatten, with = "UnmatchedReason")]
    pub reason: Worded,
}

worded! {
    /// Reason: the table without a partner, the number of partners, or that nothing uses the point.
    text UnmatchedReason: reason, reason_phrase
}

/// A file that was read.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Source {
    /// File, as in the campaign.
    pub file: String,
    /// SHA-256 of the file, as `sha256sum` prints it.
    pub sha256: String,
    /// SHA-256 of the campaign without its line `controller_backup`; absent without this line.
    /// Results refer to this hash, because the way back does not change them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sha256_without_backup: Option<String>,
    /// Size of the file.
    pub bytes: usize,
    /// `export`, `log`, `campaign` or `robot`.
    #[schemars(with = "String")]
    pub kind: SourceKind,
    /// Dialect of the file: format, delimiter, decimal mark, unit.
    #[serde(flatten, with = "SourceDialect")]
    pub dialect: Worded,
    /// Number of data rows.
    pub rows_read: usize,
    /// Rejected rows.
    pub refused: Vec<Refused>,
    /// Standstills of a log that was recorded during motion; each yields one row of joint values.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub standstills: Vec<StandingInterval>,
}

worded! {
    /// Dialect of the file: format, delimiter, decimal mark, unit.
    text SourceDialect: dialect, dialect_phrase
}

/// Kind of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, strum::IntoStaticStr)]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "snake_case")]
pub enum SourceKind {
    /// The campaign.
    Campaign,
    /// A robot file.
    Robot,
    /// An export of a measuring system.
    Export,
    /// A log of a controller.
    Log,
    /// A table.
    Table,
    /// A recorded motion.
    Stream,
    /// A template of a controller format.
    Template,
    /// A file of the controller before loading.
    Backup,
}

impl Source {
    /// States how the file was read.
    pub fn read_as(&mut self, dialect: Phrase) {
        self.dialect = dialect.into();
    }
}

impl SourceKind {
    /// Name of the kind.
    pub fn name(self) -> &'static str {
        self.into()
    }
}

/// A rejected row.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Refused {
    /// Line in the file, from 1.
    pub line: usize,
    /// Text of the line.
    pub text: String,
    /// Rule that rejected the row.
    #[serde(flatten, with = "RefusedReason")]
    pub reason: Worded,
}

worded! {
    /// Rule that rejected the row.
    text RefusedReason: reason, reason_phrase
}

impl Refused {
    /// A rejected row.
    pub fn new(line: usize, text: impl Into<String>, reason: Phrase) -> Self {
        Self { line, text: text.into(), reason: reason.into() }
    }
}

/// A standstill in a log, by the limits of the campaign.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StandingInterval {
    /// Line of the first sample, from 1.
    pub line: usize,
    /// Time of the first sample, by the log's clock.
    pub from_s: f64,
    /// Time of the last sample.
    pub to_s: f64,
    /// Number of samples.
    pub samples: usize,
    /// Joints during the standstill.
    pub joints: Vec<StandingJoint>,
}

/// A joint during a standstill, in the unit of its column.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StandingJoint {
    /// Column in the table of joint values.
    pub column: String,
    /// Mean of the samples, which is used as the joint value.
    pub mean: f64,
    /// Standard deviation of the samples.
    pub standard_deviation: f64,
    /// Largest minus smallest sample.
    pub range: f64,
}
