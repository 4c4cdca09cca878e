//! `[log]`: a file of a controller, and how it is to be read.

use super::{Column, Decimal, Delimiter, Encoding};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use toml::Spanned;

/// A file of a controller.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Log {
    /// Name of the log, where there are several.
    #[serde(default = "default_log")]
    pub name: String,
    /// Name of the file.
    #[schemars(with = "String")]
    pub file: Spanned<String>,
    /// Encoding of its characters; UTF-8, or that of its byte-order mark, if absent.
    pub encoding: Option<Encoding>,
    /// Controller that wrote the log.
    #[serde(default)]
    pub format: LogFormat,
    /// What separates the columns; a comma if absent.
    pub delimiter: Option<Delimiter>,
    /// Decimal mark.
    #[serde(default)]
    pub decimal: Decimal,
    /// The first row names the columns.
    #[serde(default = "yes")]
    pub header: bool,
    /// The columns to read: `pose`, `cycle`, `time_s`, `time_ms`, `time_ns`, `label` (of the point touched), and the joints
    /// with their units.
    #[schemars(with = "BTreeMap<String, Column>")]
    pub columns: BTreeMap<Spanned<String>, Column>,
    /// `row`: the number of the data row is the number of the pose.
    pub pose: Option<FromRow>,
    /// Time from one row to the next, of a log without a clock; its first row is at 0.
    pub period_s: Option<f64>,
    /// Whether channels with a scale contain raw or scaled values (TwinCAT).
    pub values: Option<ChannelValues>,
    /// Reduces a log recorded during motion to one row of mean joint values for each standstill.
    pub standstill: Option<Standstill>,
}

/// A standstill: no joint moves by more than the stated difference for at least the stated time.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Standstill {
    /// Least duration of a standstill.
    pub at_least_s: f64,
    /// Largest difference of two values of a revolute joint in a standstill.
    pub within_deg: Option<f64>,
    /// Largest difference of two values of a prismatic joint in a standstill.
    pub within_mm: Option<f64>,
}

impl Log {
    /// What separates the columns of a delimited log.
    pub fn delimiter(&self) -> Delimiter {
        self.delimiter.unwrap_or(Delimiter::Comma)
    }
}

/// Who wrote a log: what is known of its columns, units and clock.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub enum LogFormat {
    /// Delimited text of which nothing is known but what the campaign states.
    #[default]
    #[serde(rename = "delimited")]
    Delimited,
    /// Galil array upload: encoder counts, arrays in alphabetical order, no clock.
    #[serde(rename = "galil")]
    Galil,
    /// Universal Robots RTDE recording: rad, m, s; names that occur twice.
    #[serde(rename = "ur_rtde")]
    UrRtde,
    /// KUKA RSI recording: mm, deg; `IPOC` in ms is the clock.
    #[serde(rename = "kuka_rsi")]
    KukaRsi,
    /// Beckhoff TwinCAT 3 Scope CSV: a time base for each channel.
    #[serde(rename = "twincat")]
    TwinCat,
    /// ROS messages as CSV: joints in any order, named by the header or by their rows.
    #[serde(rename = "ros")]
    Ros,
}

impl LogFormat {
    /// In words.
    pub fn name(self) -> &'static str {
        match self {
            Self::Delimited => "delimited text",
            Self::Galil => "Galil arrays",
            Self::UrRtde => "UR RTDE",
            Self::KukaRsi => "KUKA RSI",
            Self::TwinCat => "TwinCAT Scope",
            Self::Ros => "ROS CSV",
        }
    }
}

/// What the channels of a TwinCAT Scope export hold: an option of the export that the file does not tell.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum ChannelValues {
    /// As they were recorded: factor and offset of the header are still to be applied.
    Raw,
    /// Factor and offset are applied.
    Scaled,
}

fn default_log() -> String {
    "log".to_owned()
}

fn yes() -> bool {
    true
}

/// A number that is the number of its row.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum FromRow {
    /// Counted from 1 over the data rows of the file, refused ones included.
    Row,
}
