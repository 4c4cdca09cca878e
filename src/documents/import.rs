//! `import.json`: what was read, and what was refused and why.

use etalon_base::message::Message;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What was read, what was refused and why.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ImportDocument {
    /// `etalon/import/1`
    pub schema: String,
    /// Name of the campaign.
    pub campaign: String,
    /// Every file that was read.
    pub sources: Vec<Source>,
    /// What blunder rules found, and other messages.
    pub messages: Vec<Message>,
    /// Rows that the join of points and logs found no partner for, or more than one.
    #[serde(default)]
    pub unmatched: Vec<Unmatched>,
}

/// A row without a partner in the join, or with more than one.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Unmatched {
    /// Its file, as the campaign names it.
    pub file: String,
    /// Line in the file, from 1.
    pub line: usize,
    /// Its key in words: pose and cycle, row, or time.
    pub key: String,
    /// What it has no partner in, or how many partners it has.
    pub reason: String,
}

/// One file that was read.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Source {
    /// File as the campaign names it.
    pub file: String,
    /// SHA-256 of its bytes, as `sha256sum` prints it.
    pub sha256: String,
    /// Its size.
    pub bytes: usize,
    /// `export`, `log`, `campaign` or `robot`.
    #[schemars(with = "String")]
    pub kind: SourceKind,
    /// How it was read: format, delimiter, decimal mark, unit.
    pub dialect: String,
    /// Rows that hold data.
    pub rows_read: usize,
    /// Rows that were refused.
    pub refused: Vec<Refused>,
    /// Standstills of a log recorded during motion, one row of the joint values each.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub standstills: Vec<StandingInterval>,
}

/// What a file that was read is.
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
}

impl SourceKind {
    /// Name of the kind.
    pub fn name(self) -> &'static str {
        self.into()
    }
}

/// A row that was refused.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Refused {
    /// Line in the file, from 1.
    pub line: usize,
    /// The line itself.
    pub text: String,
    /// The rule that refused it.
    pub reason: String,
}

/// A standstill in a log, by the limits of the campaign.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StandingInterval {
    /// Line of its first sample, from 1.
    pub line: usize,
    /// Time of its first sample by the log's clock.
    pub from_s: f64,
    /// Time of its last sample.
    pub to_s: f64,
    /// How many samples.
    pub samples: usize,
    /// The joints.
    pub joints: Vec<StandingJoint>,
}

/// A joint in a standstill, in the unit of its column.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StandingJoint {
    /// Its column in the table of joint values.
    pub column: String,
    /// Mean of the samples: the joint value used.
    pub mean: f64,
    /// Standard deviation of the samples.
    pub standard_deviation: f64,
    /// Largest minus smallest.
    pub range: f64,
}
