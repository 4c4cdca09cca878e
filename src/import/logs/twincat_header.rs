//! The head of a TwinCAT 3 Scope export: start, names, scales and units of its channels.

use crate::base::message::{Message, Place, Problems, Result};
use crate::import::format::Decimal;
use crate::import::format::Delimiter;
use crate::import::format::Log;

/// Seconds from 1601-01-01, where a FILETIME begins, to 1970-01-01.
const FILETIME_TO_UNIX_S: i64 = 11_644_473_600;

/// The head of an export.
pub(super) struct Header {
    /// What separates fields.
    pub separator: char,
    /// Start of the export, FILETIME: 100 ns since 1601-01-01 UTC.
    pub start: Option<i64>,
    /// Columns that bring values.
    pub channels: Vec<Channel>,
    /// Fields of a full row.
    pub width: usize,
    /// Index of the first line with data.
    pub data: usize,
    /// The line that names the channels, from 1.
    pub names: usize,
}

/// A column of values.
pub(super) struct Channel {
    pub name: String,
    /// Its column.
    pub at: usize,
    /// The column of its times.
    pub time: usize,
    pub unit: String,
    /// Factor and offset of the channel: value = raw * factor + offset.
    pub scale: (f64, f64),
    /// Factor and offset of its unit, likewise.
    pub unit_scale: (f64, f64),
}

impl Header {
    /// Reads the head; a file that could be read in two ways is refused.
    pub fn read(file: &str, lines: &[&str], log: &Log) -> Result<Self> {
        let shown = |i: usize| Place::line(file, i + 1, lines.get(i).copied().unwrap_or(""));
        let separator = separator(lines, log).map_err(|m| m.at(shown(0)))?;
        let split = |i: usize| lines.get(i).map_or(Vec::new(), |line| line.split(separator).map(str::trim).collect());
        let names = (1..lines.len().min(100)).find(|&i| split(i).first() == Some(&"Name"));
        let Some(first) = names else {
            let message = Message::error("no row names the channels").at(shown(0));
            return Err(message.expected("a row that begins with `Name` after the start and end of the export").into());
        };
        let end = (first..lines.len().min(first + 100)).find(|&i| lines[i].trim().is_empty());
        let Some(end) = end else {
            let message = Message::error("the head of the channels does not end").at(shown(first));
            return Err(message.expected("an empty line before the data").into());
        };
        let head: Vec<Vec<&str>> = (first..end).map(split).collect();
        let width = head[0].len();
        // comments that are empty end their row early
        let fits = |row: &Vec<&str>| row.len() == width || row.len() < width && row[0] == "SymbolComment";
        let ragged = head.iter().enumerate().filter(|(_, row)| !fits(row)).map(|(i, row)| {
            let (here, wanted) = (row.len(), format!("{width}, as the row of names"));
            let reason = "a comma of the operating system's decimal mark, or a name, holds the separator";
            Message::error(format!("row `{}` of the head has {here} fields: {reason}", row[0]))
                .at(shown(first + i))
                .expected(wanted)
                .hint("export again, separated by tabs or semicolons")
        });
        Problems(ragged.collect()).check()?;
        let field = |key: &str, at: usize| {
            head.iter().find(|row| row[0] == key).map_or("", |row| row.get(at).copied().unwrap_or(""))
        };
        let mut channels = Vec::new();
        let mut time = None;
        let mut problems = Problems::default();
        for (at, name) in head[0].iter().enumerate() {
            if *name == "Name" {
                time = Some(at);
                continue;
            }
            let mut number = |key: &str, absent: f64| match field(key, at) {
                "" => absent,
                // the head keeps the decimal mark of the operating system, whatever the data have
                text => text.replace(',', ".").parse().unwrap_or_else(|_| {
                    let what = format!("`{key}` of channel `{name}` is `{text}`, no number");
                    problems.0.push(Message::error(what).at(shown(first)));
                    absent
                }),
            };
            let scale = (number("ScaleFactor", 1.0), number("Offset", 0.0));
            let unit_scale = (number("Unit ScaleFactor", 1.0), number("Unit Offset", 0.0));
            let unit = field("Unit", at).split(" (").next().unwrap_or("").trim().to_owned();
            // the first field is `Name`
            let time = time.unwrap_or(0);
            channels.push(Channel { name: (*name).to_owned(), at, time, unit, scale, unit_scale });
        }
        problems.check()?;
        let start = (0..first).find(|&i| split(i).first() == Some(&"Starttime of export"));
        let start = start.and_then(|i| split(i).get(1).and_then(|text| text.parse().ok()));
        Ok(Self { separator, start, channels, width, data: end + 1, names: first + 1 })
    }

    /// The start of the export in UTC, to the millisecond.
    pub fn start_utc(&self) -> Option<String> {
        let ms = self.start?.div_euclid(10_000) - FILETIME_TO_UNIX_S * 1000;
        let (days, in_day) = (ms.div_euclid(86_400_000), ms.rem_euclid(86_400_000));
        let (year, month, day) = civil(days);
        let (hour, minute) = (in_day / 3_600_000, in_day / 60_000 % 60);
        let (second, ms) = (in_day / 1000 % 60, in_day % 1000);
        Some(format!("{year:04}-{month:02}-{day:02}T{hour:02}:{minute:02}:{second:02}.{ms:03}Z"))
    }
}

/// The separator, which the first line shows after its first word; one that reads two ways is refused.
fn separator(lines: &[&str], log: &Log) -> std::result::Result<char, Message> {
    let after = lines.first().and_then(|line| line.strip_prefix("Name")).and_then(|rest| rest.chars().next());
    let again = "export again, separated by tabs or semicolons";
    let Some(separator) = after.filter(|c| ['\t', ' ', ':', ';', ','].contains(c)) else {
        let message = Message::error("this is no TwinCAT 3 Scope export");
        return Err(message.expected("a first line of `Name`, a separator, and the name of the export"));
    };
    if separator == ' ' {
        let what =
            "the export is separated by blanks, and a blank is also what stands for a missing value and in names";
        return Err(Message::error(what).hint(again));
    }
    if separator == ',' && log.decimal == Decimal::Comma {
        let message = Message::error("the export is separated by commas, and its decimal mark is a comma");
        return Err(message.hint(again));
    }
    let stated = log.delimiter.and_then(Delimiter::byte).map(char::from);
    if log.delimiter.is_some() && stated != Some(separator) {
        let message = Message::error(format!("the export is separated by {separator:?}"));
        return Err(message.hint("leave `delimiter` out of this log: the export says it itself"));
    }
    Ok(separator)
}

/// Year, month and day of a number of days since 1970-01-01 in the Gregorian calendar.
///
/// H. Hinnant, "chrono-Compatible Low-Level Date Algorithms", civil_from_days.
fn civil(days: i64) -> (i64, i64, i64) {
    let z = days + 719_468;
    let (era, day_of_era) = (z.div_euclid(146_097), z.rem_euclid(146_097));
    let year_of_era = (day_of_era - day_of_era / 1460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let shifted = (5 * day_of_year + 2) / 153;
    let day = day_of_year - (153 * shifted + 2) / 5 + 1;
    let month = if shifted < 10 { shifted + 3 } else { shifted - 9 };
    (year_of_era + era * 400 + i64::from(month <= 2), month, day)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn days_become_dates() {
        for (days, date) in [
            (0, (1970, 1, 1)),
            (-1, (1969, 12, 31)),
            (11_016, (2000, 2, 29)),
            (11_017, (2000, 3, 1)),
            (19_114, (2022, 5, 2)),
        ] {
            assert_eq!(civil(days), date);
        }
    }
}
