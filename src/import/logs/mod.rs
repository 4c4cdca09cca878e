//! Formats of logs, one file each: what is known of their columns, units and clocks.

mod galil;
mod kuka_rsi;
mod ros;
mod sheet;
mod twincat;
mod ur_rtde;
mod write;

pub(crate) use write::write;

use super::format::Column;
use super::log::{Log, is_common_column, meaning};
use crate::base::message::{Message, Problems, Result, Stated};
use crate::document::{Refused, Source};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Deserializer, Serialize, Serializer, de::Error};
use sheet::Sheet;
use std::borrow::Cow;
use std::fmt;
use toml::Spanned;

/// Every format. To add one: its file, and its line here.
const FORMATS: [&dyn LogFormat; 6] =
    [&sheet::Delimited, &galil::Galil, &ur_rtde::UrRtde, &kuka_rsi::KukaRsi, &twincat::TwinCat, &ros::Ros];

/// A format of logs: delimited text of which more is known than the campaign states.
pub(crate) trait LogFormat: Sync {
    /// As `format` of a campaign states it.
    fn name(&self) -> &'static str;

    /// In words; none of delimited text of which nothing is known.
    fn title(&self) -> &'static str;

    /// What it is, in a sentence.
    fn description(&self) -> &'static str;

    /// The unit in which it writes the column of this name, where that is known.
    fn unit_of(&self, _column: &str) -> Option<&'static str> {
        None
    }

    /// Why a column is not given by its number, if it is not.
    fn not_by_number(&self) -> Option<&'static str> {
        None
    }

    /// What is wrong with a statement on a column of this format.
    fn statement(&self, _wanted: &Wanted) -> Option<Message> {
        None
    }

    /// Names columns that the header does not name.
    fn name_columns(&self, _sheet: &mut Sheet, _problems: &mut Problems) {}

    /// Takes away rows that are none, once it is known where the wanted columns are.
    fn cut(&self, _sheet: &mut Sheet, _wanted: &[(usize, &Wanted)], _problems: &mut Problems) -> Vec<Refused> {
        Vec::new()
    }

    /// Checks the values of a joint as they are in the file.
    fn check_joint(&self, _sheet: &Sheet, _at: usize, _read: &[f64], _problems: &mut Problems) {}

    /// A warning about all that was read.
    fn remark(&self, _file: &str, _columns: &Columns) -> Option<Message> {
        None
    }

    /// Whether a file has channels that it names and scales itself: `values` then has a meaning, `header` none.
    fn has_channels(&self) -> bool {
        false
    }

    /// Reads the wanted columns.
    fn read(&self, stated: Stated, log: &Log, wanted: &[Wanted], text: &str, source: &mut Source) -> Result<Columns> {
        sheet::read(stated, log, wanted, text, source)
    }

    /// Whether its columns are in the order of their names.
    fn is_sorted(&self) -> bool {
        false
    }
}

/// Format of a log, as a campaign states it.
#[derive(Clone, Copy)]
pub struct LogKind(&'static dyn LogFormat);

impl LogKind {
    /// Whether a file has channels that it names and scales itself.
    pub(crate) fn has_channels(self) -> bool {
        self.0.has_channels()
    }
}

impl Default for LogKind {
    fn default() -> Self {
        Self(&sheet::Delimited)
    }
}

impl fmt::Debug for LogKind {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(self.0.name())
    }
}

impl Serialize for LogKind {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        serializer.serialize_str(self.0.name())
    }
}

impl JsonSchema for LogKind {
    fn schema_name() -> Cow<'static, str> {
        "LogFormat".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let one = |format: &&dyn LogFormat| json_schema!({ "description": format.description(), "type": "string", "const": format.name() });
        let all: Vec<Schema> = FORMATS.iter().map(one).collect();
        let description = "Who wrote a log: what is known of its columns, units and clock.";
        json_schema!({ "description": description, "oneOf": all })
    }
}

impl<'de> Deserialize<'de> for LogKind {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> std::result::Result<Self, D::Error> {
        let stated = String::deserialize(deserializer)?;
        FORMATS.into_iter().find(|format| format.name() == stated).map(Self).ok_or_else(|| {
            let names: Vec<String> = FORMATS.iter().map(|format| format!("`{}`", format.name())).collect();
            D::Error::custom(format!("unknown variant `{stated}`, expected one of {}", names.join(", ")))
        })
    }
}

/// Rows of a log, column by column.
#[derive(Debug, Default)]
pub(crate) struct Columns {
    /// Number of each data row in its file, from 1.
    pub rows: Vec<i64>,
    /// Line of each row, from 1.
    pub lines: Vec<i64>,
    /// Columns by their names in the table, in mm, deg and s.
    pub columns: Vec<(String, Values)>,
    /// What is to be said of it.
    pub said: Vec<Message>,
}

/// Values of a column.
#[derive(Debug)]
pub(crate) enum Values {
    /// Labels.
    Text(Vec<String>),
    /// Numbers, all finite.
    Real(Vec<f64>),
}

/// A column that the campaign wants.
pub(crate) struct Wanted<'a> {
    key: &'a Spanned<String>,
    column: &'a Column,
    /// Name in the table.
    name: String,
    /// From the key's unit to that of the table.
    factor: f64,
}

impl Wanted<'_> {
    /// A value of the file in the unit of the table.
    fn value(&self, read: f64) -> f64 {
        let Some(per_count) = self.column.per_count else { return read * self.factor };
        (read - self.column.zero_count.unwrap_or(0.0)) * per_count * self.factor
    }

    /// The unit that the key states: `rad` of `q1_rad`, `ms` of `time_ms`; none of `pose`.
    fn unit(&self) -> Option<&str> {
        let key = self.key.get_ref();
        let unitless = self.name == *key && matches!(key.as_str(), "pose" | "cycle" | "label" | "assembly");
        key.rsplit_once('_').map(|(_, unit)| unit).filter(|_| !unitless)
    }

    /// Whether it is a joint: all that is neither time, pose, cycle, label nor assembly mode.
    fn is_joint(&self) -> bool {
        !is_common_column(self.key.get_ref())
    }
}

/// Reads the columns that the campaign wants of a log.
pub(super) fn columns(stated: Stated, log: &Log, text: &str, source: &mut Source) -> Result<Columns> {
    let mut problems = Problems::default();
    let wanted = wanted(stated, log, &mut problems);
    match log.format.0.read(stated, log, &wanted, text, source) {
        Ok(columns) => problems.check().map(|_| columns),
        Err(more) => {
            problems.0.extend(more.0);
            Err(problems)
        }
    }
}

/// What each key of `columns` becomes.
fn wanted<'a>(stated: Stated, log: &'a Log, problems: &mut Problems) -> Vec<Wanted<'a>> {
    let mut wanted: Vec<Wanted> = Vec::new();
    let clock = log.period_s.is_some().then_some("time_s");
    let numbered = log.pose.is_some().then_some("pose");
    for (key, column) in &log.columns {
        let Some((name, factor)) = meaning(key.get_ref()) else {
            problems.0.push(
                Message::error(format!("`{}` states no unit that a joint can have", key.get_ref()))
                    .at(stated.place(key))
                    .expected(
                        "`pose`, `cycle`, `time_s`, `label`, or a joint with its unit like `q1_deg`, `q1_rad`, `rho1_mm`",
                    ),
            );
            continue;
        };
        if wanted.iter().any(|w| w.name == name) || [clock, numbered].contains(&Some(name.as_str())) {
            let message = Message::error(format!("`{}` states `{name}` once more", key.get_ref()));
            let hint = "a joint has one column; `pose = \"row\"` needs none for the pose, `period_s` none for the time";
            problems.0.push(message.at(stated.place(key)).hint(hint));
            continue;
        }
        let wants = Wanted { key, column, name, factor };
        if column.per_count.is_some() && !wants.is_joint() {
            let message = Message::error(format!("`per_count` means nothing for `{}`", key.get_ref()));
            problems.0.push(message.at(stated.place(key)).hint("it is what one count of a joint's encoder is worth"));
            continue;
        }
        wanted.push(wants);
    }
    if log.period_s.is_some_and(|period| period <= 0.0 || !period.is_finite()) {
        let message = Message::error("`period_s` must be positive").at(stated.place(&log.file));
        problems.0.push(message.hint("it is the time from one row of the log to the next, in seconds"));
    }
    if log.values.is_some() && !log.format.0.has_channels() {
        let message = Message::error("`values` means nothing for this log").at(stated.place(&log.file));
        problems.0.push(message.hint("it belongs to `format = \"twincat\"`"));
    }
    if !log.header && log.format.0.has_channels() {
        let message = Message::error("`header = false` means nothing for this log").at(stated.place(&log.file));
        problems.0.push(message.hint("a TwinCAT export names its channels: leave `header` out"));
    }
    wanted
}

/// An error where the key states another unit than the column has in files of this format.
fn unit_agrees(format: LogKind, wanted: &Wanted, column: &str) -> std::result::Result<(), Message> {
    let (Some(stated), Some(known)) = (wanted.unit(), format.0.unit_of(column)) else { return Ok(()) };
    other_unit(wanted, column, stated, known).map_or(Ok(()), Err)
}

/// The error about a column that is in another unit than its key states, if it is.
fn other_unit(wanted: &Wanted, column: &str, stated: &str, known: &str) -> Option<Message> {
    if stated == known {
        return None;
    }
    let key = wanted.key.get_ref();
    let message = Message::error(format!("`{key}` states {stated}, and `{column}` is in {known}"));
    let meant = key.rsplit_once('_').map_or_else(|| key.clone(), |(name, _)| format!("{name}_{known}"));
    Some(match meaning(&meant) {
        Some((name, _)) if (name == "time_s") == (wanted.name == "time_s") => {
            message.hint(format!("write `{meant} = \"{column}\"`"))
        }
        _ => message.expected(format!("a column in {stated}")),
    })
}
