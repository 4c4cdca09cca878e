//! `[log]`: a file of a controller, and how it is to be read.

use super::{Column, Decimal, Delimiter, Encoding};
use serde::Deserialize;
use std::collections::BTreeMap;
use toml::Spanned;

/// A file of a controller.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Log {
    /// Name of the log where there are several.
    #[serde(default = "default_log")]
    pub name: String,
    /// The file.
    pub file: Spanned<String>,
    /// How its bytes become characters; UTF-8, or what its byte-order mark says, if it is absent.
    pub encoding: Option<Encoding>,
    /// Who wrote it; any delimited text if absent.
    #[serde(default)]
    pub format: LogFormat,
    /// `blank`, `tab`, `,`, `;` or `|`; a comma if absent.
    pub delimiter: Option<Delimiter>,
    /// Decimal mark.
    #[serde(default)]
    pub decimal: Decimal,
    /// The first row names the columns.
    #[serde(default = "yes")]
    pub header: bool,
    /// What stands in which column: `pose`, `cycle`, `time_s`, `time_ms`, `time_ns`, `label` of the point touched, and the
    /// joints with their units.
    pub columns: BTreeMap<Spanned<String>, Column>,
    /// `"row"`: the number of the data row is the number of the pose.
    pub pose: Option<FromRow>,
    /// Time from one row to the next, of a log without a clock: its first row is at 0.
    pub period_s: Option<f64>,
    /// Whether channels with a scale hold raw or scaled values (TwinCAT).
    pub values: Option<ChannelValues>,
    /// Of a log recorded while the robot moved: when it stands. Then each standstill is one row, of mean joint values.
    pub standstill: Option<Standstill>,
}

/// When a robot stands: no joint moves by more than is stated within the time that is stated.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Standstill {
    /// How long it stands at least.
    pub at_least_s: f64,
    /// Largest difference of two values of a turning joint that stands.
    pub within_deg: Option<f64>,
    /// Largest difference of two values of a sliding joint that stands.
    pub within_mm: Option<f64>,
}

impl Log {
    /// What separates the columns of a delimited log.
    pub fn delimiter(&self) -> Delimiter {
        self.delimiter.unwrap_or(Delimiter::Comma)
    }
}

/// Who wrote a log: what is known of its columns, units and clock.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
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
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
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
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum FromRow {
    /// Counted from 1 over the data rows of the file, refused ones included.
    Row,
}
