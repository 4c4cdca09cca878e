//! Logs that are one table: a header row with names, and a row for each time.

use super::{About, Columns, Log, LogFormat, LogText, Values, Wanted, unit_agrees};
use crate::dialect::{ColumnAt, Decimal, Delimiter, Dialect, Expression, Header, ambiguous_thousands};
use crate::filter::{Filter, no_row_selected};
use crate::guess::{guesses, two_commas_in};
use crate::lexer::{Row, WHOLE, marked, parsed, pose_name, split as split_rows};
use crate::ros_bag;
use crate::table::{ASSEMBLY, LABEL};
use etalon_base::catalogue::Phrase;
use etalon_base::message::{Message, Place, Problems, Result, SourceText};
use etalon_base::{error, phrase};
use etalon_documents::{Refused, Source};
use std::borrow::Cow;

/// Plain delimited text: the campaign states everything.
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

/// Rows of a log.
pub(crate) struct Sheet<'a> {
    pub file: &'a str,
    pub header: Option<Row<'a>>,
    pub rows: Vec<Row<'a>>,
}

impl Sheet<'_> {
    /// Returns the place of the first row.
    pub fn place(&self) -> Place {
        self.header.as_ref().or(self.rows.first()).map_or_else(|| Place::file(self.file), |row| row.place(self.file))
    }

    /// Returns the place of a cell.
    pub fn cell(&self, row: &Row, index: usize) -> Place {
        row.cell(self.file, index)
    }

    /// Returns the header if all its fields are numbers: no column has a name.
    fn header_of_numbers(&self, decimal: Decimal) -> Option<&Row<'_>> {
        self.header.as_ref().filter(|header| header.fields.iter().all(|field| is_number(field, decimal)))
    }

    /// Returns the number of columns.
    fn width(&self) -> usize {
        self.header.as_ref().or(self.rows.first()).map_or(0, |row| row.fields.len())
    }
}

/// States how the file of a log is read.
fn reading(log: &Log) -> Phrase {
    let format = log.kind().about().title;
    let delimited = || phrase!("log-delimited", delimiter = log.delimiter().name(), decimal = log.decimal.name());
    let read = match &log.sheet {
        Some(topic) if ros_bag::is_topic(topic) => return phrase!("log-of-topic", topic),
        Some(sheet) => phrase!("log-of-sheet", sheet),
        None if log.kind().0.has_arrays() => return phrase!("log-of-arrays", format),
        None => delimited(),
    };
    if format.is_empty() { read } else { phrase!("log-of-format", format, read) }
}

/// Reads the wanted columns.
pub(super) fn read(LogText { log, stated, text }: LogText, wanted: &[Wanted], source: &mut Source) -> Result<Columns> {
    if log.delimiter() == Delimiter::Comma && log.decimal == Decimal::Comma {
        return Err(two_commas_in(text).at(stated.place(&log.file)).into());
    }
    if let Some(message) = ambiguous_thousands(Some(log.delimiter()), log.decimal, log.thousands) {
        return Err(message.at(stated.place(&log.file)).into());
    }
    source.read_as(reading(log));
    let mut problems = Problems::default();
    let mut sheet = split(stated, log, text, &mut problems)?;
    if sheet.header_of_numbers(log.decimal).is_some() {
        return Err(problems);
    }
    source.rows_read = sheet.rows.len();
    log.kind().0.name_columns(&mut sheet, &mut problems);
    let lines: Vec<usize> = sheet.rows.iter().map(|row| row.line).collect();
    let is_filtered = !(log.only.is_empty() && log.without.is_empty());
    let mut left_out = if is_filtered { filtered(&mut sheet, log)? } else { Vec::new() };
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
    let is_filtered = is_filtered || !left_out.is_empty();
    source.refused.extend(left_out);
    source.refused.sort_by_key(|refused| refused.line);
    let number = |row: &Row| lines.binary_search(&row.line).ok().map(|i| i as i64 + 1);
    let of_row = |(i, row): (i64, &Row)| if is_filtered { number(row) } else { Some(i) };
    let mut columns = Columns {
        rows: (1..).zip(&sheet.rows).filter_map(of_row).collect(),
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

/// Leaves out the rows that `only` and `without` refuse, and lists them.
fn filtered(sheet: &mut Sheet, log: &Log) -> Result<Vec<Refused>> {
    let filter =
        Filter::new(sheet.file, [&log.only, &log.without], sheet.header.as_ref(), (log.decimal, log.thousands))
            .map_err(Problems)?;
    let mut left_out = Vec::new();
    sheet.rows.retain(|row| match filter.refuses(row) {
        Some(reason) => {
            left_out.push(Refused::new(row.line, row.text, reason));
            false
        }
        None => true,
    });
    if sheet.rows.is_empty() {
        return Err(no_row_selected(sheet.file, sheet.header.as_ref()).into());
    }
    Ok(left_out)
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
    if log.sheet.as_deref().is_some_and(ros_bag::is_topic) {
        return Ok(Vec::new());
    }
    let mut left_out = Vec::new();
    let mut last = None;
    let reason = |row: &Row, (at, column): &(usize, &'_ str)| log.missing.reason(column, row.field(*at));
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

/// Splits the text into a header and rows of one width.
fn split<'a>(stated: SourceText, log: &'a Log, text: &'a str, problems: &mut Problems) -> Result<Sheet<'a>> {
    let file = log.file.get_ref().as_str();
    let dialect = Dialect { delimiter: Some(log.delimiter()), comment: log.comment.clone(), ..Dialect::default() };
    let (mut all, wrong) = split_rows(file, text, &dialect);
    wrong.check()?;
    let before = match &log.header {
        Header::Rows(count) => Some(*count),
        Header::Words(words) => {
            all.iter().position(|row| words.iter().all(|word| row.text.contains(word.as_str()))).map(|at| at + 1)
        }
    };
    let Some(before) = before else {
        return Err(words_missing(&log.header).at(stated.place(&log.file)).into());
    };
    let header = all.drain(..before.min(all.len())).next_back();
    if log.sheet.is_some() {
        // a sheet omits trailing empty cells
        let width = header.iter().chain(&all).map(|row| row.fields.len()).max().unwrap_or(0);
        all.iter_mut().for_each(|row| row.fields.resize(width, Cow::Borrowed("")));
    }
    if all.is_empty() {
        return Err(error!("data-rows-missing").at(stated.place(&log.file)).into());
    }
    let sheet = Sheet { file, header, rows: all };
    let width = sheet.width();
    for row in sheet.rows.iter().filter(|row| row.fields.len() != width) {
        problems.0.push(row_width(file, row, width, "first-row"));
    }
    if width == 1 && log.columns.len() > 1 {
        let guesses = guesses(text, None);
        return Err(one_column(log.delimiter(), guesses.first().map(|guess| &guess.dialect)).at(sheet.place()).into());
    }
    if let Some(header) = sheet.header_of_numbers(log.decimal) {
        problems.0.push(error!("header-holds-numbers").at(header.place(file)));
    }
    Ok(sheet)
}

/// Returns the error that no line holds the words of the header.
pub(crate) fn words_missing(header: &Header) -> Message {
    let words = if let Header::Words(words) = header { &words[..] } else { &[] };
    error!("header-words-missing", words)
}

/// Returns the error that a row has another number of fields than the header or first row.
pub(crate) fn row_width(file: &str, row: &Row, width: usize, like: &str) -> Message {
    let expected = phrase!("fields-like", width, like);
    error!("row-field-count", fields = row.fields.len(), expected).at(row.place(file))
}

/// Returns the error that the delimiter leaves each row in one column. The hint states the
/// delimiter and the decimal mark that split the rows, if any.
pub(crate) fn one_column(delimiter: Delimiter, guess: Option<&Dialect>) -> Message {
    let message = error!("delimiter-does-not-split", delimiter = delimiter.name());
    match guess.and_then(|dialect| Some((dialect.delimiter?, dialect.decimal))) {
        Some((other, decimal)) => {
            message.hint(phrase!("state-delimiter", delimiter = other.name(), decimal = decimal.name()))
        }
        None => message.hint(phrase!("state-delimiter-of-rows")),
    }
}

/// Returns the source of a column: a column of the file, or an expression of columns.
fn column_source(log: &Log, wanted: &Wanted, sheet: &Sheet) -> std::result::Result<Expression, Message> {
    let headings = sheet.header.as_ref().map_or(&[][..], |header| &header.fields);
    match &wanted.column.at {
        ColumnAt::Name(text) if Expression::is_likely(text) && headings.iter().all(|heading| heading != text) => {
            let from = Expression::parse(text, headings)?;
            from.check_columns(sheet.width())?;
            Ok(from)
        }
        _ => wanted_column_index(log, wanted, sheet).map(Expression::Column),
    }
}

/// Returns the index of a column given by number or heading.
fn wanted_column_index(log: &Log, wanted: &Wanted, sheet: &Sheet) -> std::result::Result<usize, Message> {
    log.kind().0.statement(wanted).map_or(Ok(()), Err)?;
    let index = match (&wanted.column.at, &sheet.header) {
        (ColumnAt::Number(_), _) if !log.kind().0.has_stable_order() => {
            return Err(error!("column-by-number", format = log.kind().about().name));
        }
        (ColumnAt::Number(number), _) if *number > sheet.width() => {
            return Err(error!("column-number-unknown", number, columns = sheet.width()));
        }
        (ColumnAt::Number(number), _) => number - 1,
        (ColumnAt::Name(name), Some(header)) => named(name, wanted.column.occurrence, &header.fields)?,
        (ColumnAt::Name(name), None) => return Err(error!("header-not-stated", column = name)),
    };
    let heading = sheet.header.as_ref().and_then(|header| header.fields.get(index));
    heading.map_or(Ok(()), |heading| unit_agrees(log.kind(), wanted, heading))?;
    Ok(index)
}

/// Returns the index of the column with this heading; of several, the stated one.
fn named(name: &str, occurrence: Option<usize>, header: &[Cow<str>]) -> std::result::Result<usize, Message> {
    let places: Vec<usize> = (0..header.len()).filter(|&i| header[i] == *name).collect();
    match select_occurrence(name, &places, occurrence)? {
        Some(index) => Ok(index),
        None => Err(error!("column-unknown", column = name).hint_names(name, header.iter().map(Cow::as_ref))),
    }
}

/// Returns the stated one of several columns with a name; `None` if there is no such column.
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

/// `true` if a field is a number with this decimal mark.
fn is_number(field: &str, decimal: Decimal) -> bool {
    parsed(field, decimal, None).is_some()
}

/// Returns the values of one column (mm, deg, s), and reports cells that cannot be read.
fn cells(sheet: &Sheet, log: &Log, wanted: &Wanted, from: &Expression, problems: &mut Problems) -> Values {
    let at = from.column().unwrap_or(usize::MAX);
    if wanted.name == LABEL {
        return Values::Text(sheet.rows.iter().map(|row| row.field(at).to_owned()).collect());
    }
    if wanted.name == "pose" {
        let name = |row: &Row| {
            let named = pose_name(row.field(at), log.decimal).map_err(|m| problems.0.push(m.at(sheet.cell(row, at))));
            named.unwrap_or_default()
        };
        return Values::Poses(sheet.rows.iter().map(name).collect());
    }
    // whole nanoseconds of a cell; a computed number has the unit of its key
    let nanoseconds = wanted.key.get_ref() == "time_ns" && from.column().is_some();
    let before = problems.0.len();
    let mut read = Vec::with_capacity(sheet.rows.len());
    for row in &sheet.rows {
        let number = |at: usize| marked(row.field(at), log.decimal, log.thousands).map(Some);
        let value = match from {
            Expression::Column(at) if nanoseconds => {
                seconds(row.field(*at)).map(Some).map_err(|message| (*at, message))
            }
            _ => from.value(&number),
        };
        match value {
            Ok(Some(value)) if value.is_finite() => read.push(value),
            Ok(value) => {
                let value = value.unwrap_or(f64::NAN);
                let message = error!("computed-not-finite", column = wanted.key.get_ref(), value);
                problems.0.push(message.at(row.place(sheet.file)));
            }
            Err((at, message)) => {
                let has_hint = message.hint.is_some();
                let message = if has_hint { message } else { message.hint(phrase!("log-row-needs-values")) };
                problems.0.push(message.at(sheet.cell(row, at)));
            }
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
        let place = || from.column().map_or_else(|| row.place(sheet.file), |at| sheet.cell(row, at));
        let message = if modes && value.abs() != 1.0 {
            error!("assembly-mode-invalid", value)
        } else if whole && (value.fract() != 0.0 || value.abs() > WHOLE) {
            let shown = from.column().map_or_else(|| value.to_string(), |at| row.field(at).to_owned());
            error!("not-whole-number", value = shown, column = "cycle")
        } else {
            continue;
        };
        problems.0.push(message.at(place()));
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
