//! Logs that are one table: a header row with names, and a row for each time.

use super::{About, Columns, Log, LogFormat, LogText, Values, Wanted, unit_agrees};
use crate::table::{ASSEMBLY, LABEL};
use etalon_base::catalogue::Phrase;
use etalon_base::message::{Message, Problems, Result};
use etalon_base::{error, phrase};
use etalon_documents::{Refused, Source};
use etalon_tables::lexer::{Row, pose_name};
use etalon_tables::sheet::{LeftOut, Sheet, column};
use etalon_tables::{ColumnSource, Expression};

/// Plain delimited text: the campaign contains everything.
pub(super) struct Delimited;

impl LogFormat for Delimited {
    fn about(&self) -> About {
        About {
            name: "delimited",
            title: "",
            description: "Delimited text; the campaign states its columns and units.",
        }
    }
}

/// Defines how the file of a log is read.
fn reading(log: &Log) -> Phrase {
    let format = log.kind().about().title;
    let form = log.read_form();
    let delimited = || phrase!("log-delimited", delimiter = form.delimiter().name(), decimal = form.decimal().name());
    let read = match &log.form.sheet {
        Some(topic) if form.is_topic() => return phrase!("log-of-topic", topic),
        Some(sheet) => phrase!("log-of-sheet", sheet),
        None if log.kind().0.has_arrays() => return phrase!("log-of-arrays", format),
        None => delimited(),
    };
    if format.is_empty() { read } else { phrase!("log-of-format", format, read) }
}

/// Reads the wanted columns.
pub(super) fn read(LogText { log, stated, text }: LogText, wanted: &[Wanted], source: &mut Source) -> Result<Columns> {
    source.read_as(reading(log));
    let form = log.read_form();
    let columns: Vec<&ColumnSource> = log.columns.values().map(|column| &column.at).collect();
    let split = Sheet::split(log.file.get_ref(), text, &form, &columns);
    let mut sheet = split.map_err(|more| more.at(&stated.place(&log.file)))?;
    let mut problems = Problems(sheet.field_counts().collect());
    source.rows_read = sheet.rows.len();
    log.kind().0.name_columns(&mut sheet, &mut problems);
    let left_out = sheet.filtered()?.into_iter();
    let mut left_out: Vec<Refused> =
        left_out.map(|LeftOut { row, reason }| Refused::new(row.line, row.text, reason)).collect();
    let mut placed: Vec<(Expression, &Wanted)> = Vec::new();
    for wanted in wanted {
        match column_source(log, wanted, &sheet) {
            Ok(from) => placed.push((from, wanted)),
            Err(message) => problems.0.push(message.at(stated.place(wanted.key))),
        }
    }
    if problems.0.is_empty() {
        let plain: Vec<(usize, &Wanted)> =
            placed.iter().filter_map(|(from, wanted)| Some((from.column()?, *wanted))).collect();
        source.refused = log.kind().0.cut(&mut sheet, &plain, &mut problems);
        left_out.extend(not_measured(&mut sheet, log, &placed)?);
    }
    let is_filtered = log.form.is_filtered() || !left_out.is_empty();
    source.refused.extend(left_out);
    source.refused.sort_by_key(|refused| refused.line);
    // messages of other joints do not count as rows
    let number = |(i, row): (i64, &Row)| if is_filtered { row.number as i64 } else { i };
    let mut columns = Columns {
        rows: (1..).zip(&sheet.rows).map(number).collect(),
        lines: sheet.rows.iter().map(|row| row.line as i64).collect(),
        ..Columns::default()
    };
    for (from, wanted) in placed {
        let values = cells(&sheet, log, wanted, &from, &mut problems);
        columns.columns.push((wanted.name.clone(), values));
    }
    // row by row, so that one cause in many rows is one message
    problems.0.sort_by_key(|m| m.place.as_ref().map(|p| (p.file != sheet.file, p.line, p.column)));
    problems.check()?;
    columns.said.extend(log.kind().0.remark(sheet.file, &columns));
    Ok(columns)
}

/// Leaves out the rows without a value of a joint, a time or a cycle, and lists them.
fn not_measured(sheet: &mut Sheet, log: &Log, placed: &[(Expression, &Wanted)]) -> Result<Vec<Refused>> {
    let mut needed: Vec<(usize, &str)> = Vec::new();
    for (from, wanted) in placed.iter().filter(|(_, wanted)| ![LABEL, "pose"].contains(&wanted.name.as_str())) {
        let mut columns = Vec::new();
        from.add_columns(&mut columns);
        needed.extend(columns.into_iter().map(|at| (at, wanted.key.get_ref().as_str())));
    }
    // a message definition has no mark of a missing value
    if log.form.is_topic() {
        return Ok(Vec::new());
    }
    let mut left_out = Vec::new();
    let mut last = None;
    let reason = |row: &Row, (at, column): &(usize, &'_ str)| log.form.missing.reason(column, row.field(*at));
    sheet.rows.retain(|row| match needed.iter().find_map(|one| Some((reason(row, one)?, one.1))) {
        Some((reason, column)) => {
            left_out.push(Refused::new(row.line, row.text, reason));
            last = Some(column);
            false
        }
        None => true,
    });
    match last.filter(|_| sheet.rows.is_empty()) {
        Some(column) => Err(error!("log-without-values", column).at(sheet.place()).into()),
        None => Ok(left_out),
    }
}

/// Returns the source of a column: a column of the file, or an expression of columns.
fn column_source(log: &Log, wanted: &Wanted, sheet: &Sheet) -> std::result::Result<Expression, Message> {
    let source = &wanted.column.at;
    let from = match occurrence(wanted, sheet)? {
        Some(at) => Expression::Column(at),
        None => {
            if let (ColumnSource::Number(_), false) = (source, log.kind().0.has_stable_order()) {
                return Err(error!("column-by-number", format = log.kind().about().name));
            }
            column(source, sheet.header.as_ref(), sheet.width())?
        }
    };
    if let Some(at) = from.column() {
        log.kind().0.statement(wanted).map_or(Ok(()), Err)?;
        sheet.headings().get(at).map_or(Ok(()), |heading| unit_agrees(log.kind(), wanted, heading))?;
    }
    Ok(from)
}

/// Returns the given one of several columns with the heading of a key; `None` if the header does
/// not have the heading.
fn occurrence(wanted: &Wanted, sheet: &Sheet) -> std::result::Result<Option<usize>, Message> {
    let ColumnSource::Heading(name) = &wanted.column.at else { return Ok(None) };
    let headings = sheet.headings();
    let places: Vec<usize> = (0..headings.len()).filter(|&i| headings[i] == *name).collect();
    select_occurrence(name, &places, wanted.column.occurrence)
}

/// Returns the given one of several columns with a name; `None` if there is no such column.
pub(super) fn select_occurrence<T: Copy>(
    name: &str,
    columns: &[T],
    occurrence: Option<usize>,
) -> std::result::Result<Option<T>, Message> {
    match (columns, occurrence) {
        ([], _) => Ok(None),
        ([one], None) => Ok(Some(*one)),
        (several, Some(n)) if (1..=several.len()).contains(&n) => Ok(Some(several[n - 1])),
        (several, _) => Err(error!("heading-repeated", column = name, times = several.len())),
    }
}

/// Returns the values of one column (mm, deg, s), and reports cells that cannot be read.
fn cells(sheet: &Sheet, log: &Log, wanted: &Wanted, from: &Expression, problems: &mut Problems) -> Values {
    let at = from.column().unwrap_or(usize::MAX);
    if wanted.name == LABEL {
        return Values::Text(sheet.rows.iter().map(|row| row.field(at).to_owned()).collect());
    }
    if wanted.name == "pose" {
        let name = |row: &Row| {
            let named =
                pose_name(row.field(at), log.form.decimal()).map_err(|m| problems.0.push(m.at(sheet.cell(row, at))));
            named.unwrap_or_default()
        };
        return Values::Poses(sheet.rows.iter().map(name).collect());
    }
    // whole nanoseconds of a cell; a computed number has the unit of its key
    let nanoseconds = wanted.key.get_ref() == "time_ns" && from.column().is_some();
    let before = problems.0.len();
    let mut read = Vec::with_capacity(sheet.rows.len());
    for row in &sheet.rows {
        let value = match from {
            Expression::Column(at) if nanoseconds => {
                seconds(row.field(*at)).map_err(|message| message.at(sheet.cell(row, *at)))
            }
            _ => sheet.measured(row, from, wanted.key.get_ref()),
        };
        match value {
            Ok(value) => read.push(value),
            Err(message) if message.hint.is_some() => problems.0.push(message),
            Err(message) => problems.0.push(message.hint(phrase!("log-row-needs-values"))),
        }
    }
    if problems.0.len() > before {
        return Values::Real(read);
    }
    if wanted.is_joint()
        && let Some(at) = from.column()
    {
        log.kind().0.check_joint(sheet, at, &read, problems);
    }
    let (whole, modes) = (wanted.name == "cycle", wanted.name == ASSEMBLY);
    for (value, row) in read.iter().zip(&sheet.rows) {
        let place = || sheet.cell(row, from.column().unwrap_or(usize::MAX));
        if modes && value.abs() != 1.0 {
            problems.0.push(error!("assembly-mode-invalid", value).at(place()));
        } else if whole && let Err(message) = sheet.whole(row, from, "cycle", *value) {
            problems.0.push(message);
        }
    }
    let value = |read: f64| if nanoseconds { read } else { wanted.value(read) };
    Values::Real(read.into_iter().map(value).collect())
}

/// Returns seconds of whole nanoseconds. Whole seconds are split off first, because an `f64` does
/// not hold nineteen digits.
fn seconds(cell: &str) -> std::result::Result<f64, Message> {
    let ns: i64 = cell.parse().map_err(|_| error!("not-whole-number", value = cell, column = "time_ns"))?;
    Ok(ns.div_euclid(1_000_000_000) as f64 + ns.rem_euclid(1_000_000_000) as f64 * 1e-9)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nineteen_digits_of_nanoseconds_keep_the_microsecond() {
        assert!((seconds("1651499784376123456").unwrap() - 1651499784.376123).abs() < 1e-6);
        assert_eq!(seconds("-1500000000").unwrap(), -1.5);
        assert!(seconds("1.5").is_err() && seconds("").is_err());
    }
}
