//! Logs: `[log]` of a campaign, and what is read of it: pose, cycle or time, and the joints with the units that it states.

use super::format::{Column, Decimal, Delimiter, Encoding, FromRow};
use super::logs::{self, Columns, LogKind, Values};
use super::standstill;
use crate::base::message::{Message, Result, Stated};
use crate::base::table::{ASSEMBLY, LABEL};
use crate::document::Source;
use crate::math::robots::{Joint, Quantity};
use polars::prelude::{Column as Series, DataFrame};
use schemars::JsonSchema;
use serde::Deserialize;
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
    pub format: LogKind,
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

/// Keys of `columns` that bring the time, and seconds in one of their unit.
const TIMES: [(&str, f64); 3] = [("time_s", 1.0), ("time_ms", 1e-3), ("time_ns", 1e-9)];

/// Factor from a unit to mm or deg.
fn factor(unit: &str, quantity: Quantity) -> Option<f64> {
    match (quantity, unit) {
        (Quantity::Length, "mm") | (Quantity::Angle, "deg") => Some(1.0),
        (Quantity::Length, "m") => Some(1000.0),
        (Quantity::Length, "um") => Some(0.001),
        (Quantity::Angle, "rad") => Some(180.0 / std::f64::consts::PI),
        _ => None,
    }
}

/// Whether a key of `columns` states this joint, in whatever unit: `q1_deg`, `q1_rad`.
pub fn is_joint_column(key: &str, joint: &Joint) -> bool {
    key.rsplit_once('_').is_some_and(|(name, unit)| name == joint.name && factor(unit, joint.quantity).is_some())
}

/// Whether a key of `columns` is one that the log of any robot can have.
pub(crate) fn is_common_column(key: &str) -> bool {
    ["pose", "cycle", LABEL, ASSEMBLY].contains(&key) || TIMES.iter().any(|(name, _)| *name == key)
}

/// What a key of `columns` becomes: the name of the column in the table, and the factor of its values.
pub(crate) fn meaning(key: &str) -> Option<(String, f64)> {
    if let Some((_, seconds)) = TIMES.iter().find(|(name, _)| *name == key) {
        return Some(("time_s".to_owned(), *seconds));
    }
    if is_common_column(key) {
        return Some((key.to_owned(), 1.0));
    }
    let (name, unit) = key.rsplit_once('_')?;
    let quantity = [Quantity::Length, Quantity::Angle].into_iter().find(|q| factor(unit, *q).is_some())?;
    Some((format!("{name}_{}", quantity.unit()), factor(unit, quantity)?))
}

/// Joint values of a log, row by row.
#[derive(Clone, Debug, Default)]
pub struct JointLog {
    /// As the campaign calls the log.
    pub name: String,
    /// Its file, as the campaign names it.
    pub file: String,
    /// Columns of its table, in their order: `row line pose cycle time_s label` where stated, and the joints.
    pub columns: Vec<String>,
    /// The columns among them that are joints, in mm or deg.
    pub joints: Vec<String>,
    /// In the order of the file.
    pub rows: Vec<LogRow>,
}

/// A row of a log, or a standstill of the robot.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LogRow {
    /// Number among the data rows, from 1.
    pub row: i64,
    /// Line of the file, from 1.
    pub line: usize,
    /// Number of the pose.
    pub pose: Option<i64>,
    /// Number of the repeat.
    pub cycle: Option<i64>,
    /// Time; of a standstill its middle.
    pub time_s: Option<f64>,
    /// Beginning and end of a standstill.
    pub standing_s: Option<[f64; 2]>,
    /// Label of the point that the robot touches.
    pub label: Option<String>,
    /// Assembly mode, +1 or -1.
    pub assembly: Option<f64>,
    /// Joint values, in the order of the log's joints.
    pub joints: Vec<f64>,
}

impl JointLog {
    /// Whether the log has this column.
    pub fn has(&self, column: &str) -> bool {
        self.columns.iter().any(|c| c == column)
    }

    /// The log as a table.
    pub fn table(&self) -> Result<DataFrame> {
        let column = |name: &String| {
            let whole = |f: fn(&LogRow) -> Option<i64>| -> Series {
                Series::new(name.as_str().into(), self.rows.iter().map(f).collect::<Vec<_>>())
            };
            let real = |f: &dyn Fn(&LogRow) -> Option<f64>| -> Series {
                Series::new(name.as_str().into(), self.rows.iter().map(f).collect::<Vec<_>>())
            };
            match (name.as_str(), self.joints.iter().position(|joint| joint == name)) {
                (_, Some(k)) => real(&|r| r.joints.get(k).copied()),
                ("row", _) => whole(|r| Some(r.row)),
                ("line", _) => whole(|r| Some(r.line as i64)),
                ("pose", _) => whole(|r| r.pose),
                ("cycle", _) => whole(|r| r.cycle),
                ("time_s", _) => real(&|r| r.time_s),
                ("from_s", _) => real(&|r| Some(r.standing_s?[0])),
                ("to_s", _) => real(&|r| Some(r.standing_s?[1])),
                (ASSEMBLY, _) => real(&|r| r.assembly),
                _ => {
                    Series::new(name.as_str().into(), self.rows.iter().map(|r| r.label.as_deref()).collect::<Vec<_>>())
                }
            }
        };
        Ok(DataFrame::new(self.rows.len(), self.columns.iter().map(column).collect())?)
    }
}

/// Reads a log, and gives what is to be said of it. Where the campaign states when the robot stands, each standstill is one
/// row.
pub fn read(stated: Stated, log: &Log, text: &str, source: &mut Source) -> Result<(JointLog, Vec<Message>)> {
    let Columns { rows, lines, columns, said } = logs::columns(stated, log, text, source)?;
    let mut read = JointLog { name: log.name.clone(), file: log.file.get_ref().clone(), ..JointLog::default() };
    let mut names = vec!["row", "line"];
    names.extend(log.pose.map(|_| "pose"));
    names.extend(log.period_s.map(|_| "time_s"));
    read.columns = names.into_iter().map(str::to_owned).chain(columns.iter().map(|(name, _)| name.clone())).collect();
    read.rows = rows
        .iter()
        .zip(lines)
        .map(|(&row, line)| LogRow {
            row,
            line: line as usize,
            pose: log.pose.map(|_| row),
            time_s: log.period_s.map(|period_s| (row - 1) as f64 * period_s),
            ..LogRow::default()
        })
        .collect();
    for (name, values) in columns {
        let values = match values {
            Values::Text(texts) => {
                read.rows.iter_mut().zip(texts).for_each(|(row, text)| row.label = Some(text));
                continue;
            }
            Values::Real(values) => values,
        };
        let set: fn(&mut LogRow, f64) = match name.as_str() {
            "pose" => |row, v| row.pose = Some(v as i64),
            "cycle" => |row, v| row.cycle = Some(v as i64),
            "time_s" => |row, v| row.time_s = Some(v),
            ASSEMBLY => |row, v| row.assembly = Some(v),
            _ => {
                read.joints.push(name);
                |row, v| row.joints.push(v)
            }
        };
        read.rows.iter_mut().zip(values).for_each(|(row, value)| set(row, value));
    }
    Ok(match &log.standstill {
        Some(still) => (standstill::reduce(stated, log, still, read, source)?, said),
        None => (read, said),
    })
}
