//! Logs by who wrote them: what is known of their columns, units and clocks. One file a format.

mod cells;
mod galil;
mod kuka_rsi;
mod ros;
mod sheet;
mod twincat;
mod twincat_header;
mod ur_rtde;

use super::log::meaning;
use crate::base::message::{Message, Problems, Result, Stated};
use crate::document::Source;
use crate::import::format::Column;
use crate::import::format::Log;
use crate::import::format::LogFormat;
use toml::Spanned;

/// Rows of a log, column by column.
#[derive(Debug, Default)]
pub(super) struct Columns {
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
pub(super) enum Values {
    /// Labels.
    Text(Vec<String>),
    /// Numbers, all finite.
    Real(Vec<f64>),
}

/// A column that the campaign wants.
struct Wanted<'a> {
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
        !super::log::is_common_column(self.key.get_ref())
    }
}

/// Reads the columns that the campaign wants of a log.
pub(super) fn columns(stated: Stated, log: &Log, text: &str, source: &mut Source) -> Result<Columns> {
    let mut problems = Problems::default();
    let wanted = wanted(stated, log, &mut problems);
    let read = match log.format {
        LogFormat::TwinCat => twincat::read(stated, log, &wanted, text, source),
        _ => sheet::read(stated, log, &wanted, text, source),
    };
    match read {
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
    if log.values.is_some() && log.format != LogFormat::TwinCat {
        let message = Message::error("`values` means nothing for this log").at(stated.place(&log.file));
        problems.0.push(message.hint("it belongs to `format = \"twincat\"`"));
    }
    if !log.header && log.format == LogFormat::TwinCat {
        let message = Message::error("`header = false` means nothing for this log").at(stated.place(&log.file));
        problems.0.push(message.hint("a TwinCAT export names its channels: leave `header` out"));
    }
    wanted
}

/// The unit in which a format writes the column of this name, where that is known.
fn unit_of(format: LogFormat, column: &str) -> Option<&'static str> {
    match format {
        LogFormat::UrRtde => ur_rtde::unit_of(column),
        LogFormat::KukaRsi => kuka_rsi::unit_of(column),
        LogFormat::Ros => ros::unit_of(column),
        LogFormat::Delimited | LogFormat::Galil | LogFormat::TwinCat => None,
    }
}

/// An error where the key states another unit than the column has in files of this format.
fn unit_agrees(format: LogFormat, wanted: &Wanted, column: &str) -> std::result::Result<(), Message> {
    let (Some(stated), Some(known)) = (wanted.unit(), unit_of(format, column)) else { return Ok(()) };
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
