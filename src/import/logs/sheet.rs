//! Logs that are one table: a header of names, a row for each time.

use super::super::propose::propose;
use super::super::split::{Row, cell_place, rows};
use super::{Columns, Wanted, cells, galil, kuka_rsi, ros, unit_agrees};
use crate::base::message::{Message, Place, Problems, Result, Stated};
use crate::document::Source;
use crate::import::format::ColumnAt;
use crate::import::format::Decimal;
use crate::import::format::Delimiter;
use crate::import::format::Log;
use crate::import::format::LogFormat;
use crate::import::format::two_commas;

/// The rows of a log.
pub(super) struct Sheet<'a> {
    pub file: &'a str,
    /// All lines of the file.
    pub lines: Vec<&'a str>,
    pub header: Option<Row>,
    pub rows: Vec<Row>,
}

impl<'a> Sheet<'a> {
    /// A line as it stands in the file, from 1.
    pub fn line(&self, line: usize) -> &'a str {
        line.checked_sub(1).and_then(|i| self.lines.get(i)).copied().unwrap_or("")
    }

    /// Where a cell stands.
    pub fn cell(&self, row: &Row, index: usize) -> Place {
        cell_place(self.file, row, self.line(row.line), index)
    }

    /// Number of columns.
    fn width(&self) -> usize {
        self.header.as_ref().or(self.rows.first()).map_or(0, |row| row.fields.len())
    }
}

/// A line of the log, from 1.
pub(super) fn row_place(sheet: &Sheet, line: usize) -> Place {
    Place::line(sheet.file, line, sheet.line(line))
}

/// Reads the wanted columns.
pub(super) fn read(stated: Stated, log: &Log, wanted: &[Wanted], text: &str, source: &mut Source) -> Result<Columns> {
    if log.delimiter() == Delimiter::Comma && log.decimal == Decimal::Comma {
        return Err(two_commas().at(stated.place(&log.file)).into());
    }
    source.dialect = format!(
        "{}delimited by `{}`, decimal `{}`",
        if log.format == LogFormat::Delimited { String::new() } else { format!("{}, ", log.format.name()) },
        log.delimiter().name(),
        log.decimal.name()
    );
    let mut problems = Problems::default();
    let mut sheet = split(stated, log, text, &mut problems)?;
    source.rows_read = sheet.rows.len();
    if log.format == LogFormat::Ros {
        ros::name_joints(&mut sheet, &mut problems);
    }
    let mut placed = Vec::new();
    for wanted in wanted {
        match place_of(log, wanted, &sheet) {
            Ok(at) => placed.push((at, wanted)),
            Err(message) => problems.0.push(message.at(stated.place(wanted.key))),
        }
    }
    if log.format == LogFormat::Galil && problems.0.is_empty() {
        source.refused = galil::cut(&mut sheet, &placed, &mut problems);
    }
    let mut columns = Columns {
        rows: (1..=sheet.rows.len() as i64).collect(),
        lines: sheet.rows.iter().map(|row| row.line as i64).collect(),
        ..Columns::default()
    };
    for (at, wanted) in placed {
        let values = cells::read(&sheet, log, wanted, at, &mut problems);
        columns.columns.push((wanted.name.clone(), values));
    }
    problems.check()?;
    if log.format == LogFormat::KukaRsi {
        columns.said.extend(kuka_rsi::gaps(sheet.file, &columns));
    }
    Ok(columns)
}

/// Splits the text into a header and rows of one width.
fn split<'a>(stated: Stated, log: &'a Log, text: &'a str, problems: &mut Problems) -> Result<Sheet<'a>> {
    let file = log.file.get_ref().as_str();
    let mut all = rows(file, text, log.delimiter(), None)?;
    let header = if log.header && !all.is_empty() { Some(all.remove(0)) } else { None };
    if all.is_empty() {
        return Err(Message::error(format!("log `{file}` holds no rows"))
            .at(stated.place(&log.file))
            .hint("record it again, or state `header = false` if its only row holds values")
            .into());
    }
    let sheet = Sheet { file, lines: text.lines().collect(), header, rows: all };
    let width = sheet.width();
    for row in sheet.rows.iter().filter(|row| row.fields.len() != width) {
        problems.0.push(
            Message::error(format!("the row has {} fields", row.fields.len()))
                .at(row_place(&sheet, row.line))
                .expected(format!("{width}, as the first row"))
                .hint("a decimal comma in a file separated by commas? then state `delimiter` and `decimal`"),
        );
    }
    if width == 1 && log.columns.len() > 1 {
        let what = format!("log `{file}` has one column, of which the campaign names {}", log.columns.len());
        let delimiter = log.delimiter().name();
        let expected = format!("columns separated by `{delimiter}`, decimal `{}`", log.decimal.name());
        let hint = match propose(file, text).readings.first() {
            Some(r) => {
                format!("`delimiter = {:?}` and `decimal = {:?}` read its rows: state them", r.delimiter, r.decimal)
            }
            None => "state `delimiter` and `decimal` of the log, as its rows have them".to_owned(),
        };
        return Err(Message::error(what).at(row_place(&sheet, 1)).expected(expected).hint(hint).into());
    }
    if let Some(header) = sheet.header.as_ref().filter(|h| h.fields.iter().all(|f| cells::is_number(f, log.decimal))) {
        let message = Message::error("the row that should name the columns holds numbers alone");
        let hint = "the file has no header: state `header = false` and give columns by number; with it as a header every \
                    row would be one off";
        problems.0.push(message.at(row_place(&sheet, header.line)).hint(hint));
    }
    Ok(sheet)
}

/// Index of a column, by its number or by its name in the header.
fn place_of(log: &Log, wanted: &Wanted, sheet: &Sheet) -> std::result::Result<usize, Message> {
    if log.format == LogFormat::Galil {
        galil::states_counts(wanted).map_or(Ok(()), Err)?;
    }
    let by_name = match log.format {
        LogFormat::Galil => Some("arrays stand in alphabetical order, whatever joints they belong to"),
        LogFormat::Ros => Some("the order of joints is arbitrary"),
        _ => None,
    };
    let index = match (&wanted.column.at, &sheet.header, by_name) {
        (ColumnAt::Number(_), _, Some(why)) => {
            let format = log.format.name();
            return Err(
                Message::error(format!("a column of {format} is not given by its number: {why}")).hint("give its name")
            );
        }
        (ColumnAt::Number(n), _, None) if *n > sheet.width() => {
            let width = sheet.width();
            return Err(Message::error(format!("the log has {width} columns, none of them is number {n}")));
        }
        (ColumnAt::Number(n), _, None) => n - 1,
        (ColumnAt::Name(name), Some(header), _) => named(name, wanted.column.occurrence, &header.fields)?,
        (ColumnAt::Name(name), None, _) => {
            return Err(Message::error(format!("the log has no header that could name `{name}`"))
                .hint("give the number of the column instead of its name, or remove `header = false`"));
        }
    };
    let heading = sheet.header.as_ref().and_then(|header| header.fields.get(index));
    heading.map_or(Ok(()), |heading| unit_agrees(log.format, wanted, heading))?;
    Ok(index)
}

/// Index of the column with this name; of several the stated one.
fn named(name: &str, occurrence: Option<usize>, header: &[String]) -> std::result::Result<usize, Message> {
    let places: Vec<usize> = (0..header.len()).filter(|&i| header[i] == *name).collect();
    let at: Vec<String> = places.iter().map(|i| (i + 1).to_string()).collect();
    match (&places[..], occurrence) {
        ([], _) => Err(Message::error(format!("the header has no column `{name}`"))
            .hint_names(name, header.iter().map(String::as_str))),
        ([one], None) => Ok(*one),
        (several, Some(n)) if n <= several.len() => Ok(several[n - 1]),
        (several, Some(n)) => {
            Err(Message::error(format!("the header names `{name}` {} times, there is no number {n}", several.len())))
        }
        (several, None) => Err(Message::error(format!("the header names `{name}` {} times", several.len()))
            .expected(format!("which of columns {} is meant", at.join(" and ")))
            .hint(format!("state it: `{{ name = \"{name}\", occurrence = 1 }}`, or give the number of the column"))),
    }
}
