//! Delimited text in a stated dialect: rows of fields with their places, and numbers read strictly.

use crate::campaign::{Decimal, Delimiter, Dialect, Role, Unit};
use crate::import::points::Point;
use crate::message::{Message, Place, Problems, Result};

/// A row of fields.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Row {
    /// Line in the file, from 1.
    pub line: usize,
    /// The fields.
    pub fields: Vec<String>,
}

/// Splits a text into rows; empty lines and comment lines are no rows.
pub(super) fn rows(file: &str, text: &str, delimiter: Delimiter, comment: Option<&str>) -> Result<Vec<Row>> {
    let lines: Vec<&str> = text.lines().collect();
    let line_of = |line: usize| line.checked_sub(1).and_then(|i| lines.get(i)).copied().unwrap_or("");
    let is_comment = |line: &str| comment.is_some_and(|c| line.trim_start().starts_with(c));
    let Some(byte) = delimiter.byte() else {
        let row = |(i, line): (usize, &str)| Row { line: i + 1, fields: blank_fields(line) };
        let held = |(_, line): &(usize, &str)| !line.trim().is_empty() && !is_comment(line);
        return Ok(lines.iter().copied().enumerate().filter(held).map(row).collect());
    };
    let mut reader =
        csv::ReaderBuilder::new().delimiter(byte).has_headers(false).flexible(true).from_reader(text.as_bytes());
    let mut all = Vec::new();
    for record in reader.records() {
        let record = record.map_err(|e| {
            let line = e.position().map_or(0, |p| p.line() as usize);
            Message::error(format!("cannot split the row: {e}")).at(Place::line(file, line, line_of(line)))
        })?;
        let line = record.position().map_or(0, |p| p.line() as usize);
        // the reader's position is before blank lines that it skips
        let line = (line..=lines.len()).find(|&l| !line_of(l).trim().is_empty()).unwrap_or(line);
        if is_comment(line_of(line)) || record.iter().all(|f| f.trim().is_empty()) && line_of(line).trim().is_empty() {
            continue;
        }
        all.push(Row { line, fields: record.iter().map(|f| f.trim().to_owned()).collect() });
    }
    Ok(all)
}

/// Fields of a line separated by blanks; a name in double quotes may hold some.
pub(super) fn blank_fields(line: &str) -> Vec<String> {
    let mut fields = Vec::new();
    let mut rest = line.trim();
    while !rest.is_empty() {
        let (field, after) = match rest.strip_prefix('"').and_then(|r| r.split_once('"')) {
            Some((quoted, after)) => (quoted, after),
            None => rest.split_once(char::is_whitespace).unwrap_or((rest, "")),
        };
        fields.push(field.to_owned());
        rest = after.trim_start();
    }
    fields
}

/// The column at which each field stands in its line, in characters from 1.
pub(super) fn columns_of(line: &str, fields: &[String]) -> Vec<usize> {
    let mut from = 0;
    let place = |field: &String| {
        // a field with doubled quotes does not stand in the line as it reads
        let at = line[from..].find(field.as_str()).map(|byte| from + byte);
        let column = line[..at.unwrap_or(from)].chars().count() + 1;
        from = at.map_or(from, |at| at + field.len());
        column
    };
    fields.iter().map(place).collect()
}

/// Where the field of this index stands; `shown` is the line itself.
pub(super) fn cell_place(file: &str, row: &Row, shown: &str, index: usize) -> Place {
    let width = row.fields.get(index).map_or(1, |f| f.chars().count());
    let column = columns_of(shown, &row.fields).get(index).copied().unwrap_or(1);
    Place::line(file, row.line, shown).at(column, width)
}

/// Whole numbers up to here are exact.
pub(super) const WHOLE: f64 = 9e15;

/// A number in the stated decimal mark, nothing else around it.
pub(super) fn number(field: &str, decimal: Decimal) -> std::result::Result<f64, Message> {
    let wrong = || {
        Message::error(format!("`{field}` is no number"))
            .expected(format!("a number with decimal mark `{}`", decimal.name()))
    };
    let (text, other) = match decimal {
        Decimal::Point => (field.to_owned(), ','),
        Decimal::Comma => (field.replace(',', "."), '.'),
    };
    if field.contains(other) {
        let hint = if decimal == Decimal::Point {
            "a decimal comma? then state `decimal = \",\"`"
        } else {
            "a decimal point? then state `decimal = \".\"`"
        };
        return Err(wrong().hint(hint));
    }
    // words that `parse` would take for infinity or NaN are no measured values
    let digits = text.bytes().all(|b| b.is_ascii_digit() || matches!(b, b'+' | b'-' | b'.' | b'e' | b'E'));
    text.parse().ok().filter(|v: &f64| digits && v.is_finite()).ok_or_else(wrong)
}

/// Points of a delimited export, and what does not read.
pub(super) fn point_rows(file: &str, text: &str, dialect: &Dialect, unit: Unit) -> (Vec<Point>, Problems) {
    let mut problems = Problems::default();
    for role in [Role::X, Role::Y] {
        if !dialect.columns.contains(&role) {
            let message = Message::error(format!("the format of `{file}` has no column for {role:?}"));
            problems.0.push(message.expected("`columns` that name at least x and y"));
        }
    }
    let all = match rows(file, text, dialect.delimiter, dialect.comment.as_deref()) {
        Ok(all) if problems.0.is_empty() => all,
        Ok(_) => return (Vec::new(), problems),
        Err(more) => {
            problems.0.extend(more.0);
            return (Vec::new(), problems);
        }
    };
    let lines: Vec<&str> = text.lines().collect();
    let mut points = Vec::new();
    for row in all.into_iter().skip(dialect.header) {
        let shown = lines.get(row.line - 1).copied().unwrap_or("");
        let surplus = row.fields.iter().skip(dialect.columns.len()).any(|f| !f.is_empty());
        if surplus || row.fields.len() < dialect.columns.iter().rposition(|r| *r != Role::Skip).map_or(0, |i| i + 1) {
            problems.0.push(
                Message::error(format!("the row has {} columns", row.fields.len()))
                    .at(Place::line(file, row.line, shown))
                    .expected(format!("{} columns, as `columns` states", dialect.columns.len()))
                    .hint("`etalon formats FILE` proposes how to read the file"),
            );
            continue;
        }
        points.push(point(&row, dialect, unit, (file, shown), &mut problems));
    }
    (points, problems)
}

/// One point; numbers that do not read are reported and left as no numbers.
fn point(row: &Row, dialect: &Dialect, unit: Unit, (file, shown): (&str, &str), problems: &mut Problems) -> Point {
    let mut point = Point { line: row.line, text: shown.to_owned(), ..Point::default() };
    let coordinate = |role: &Role| matches!(role, Role::X | Role::Y | Role::Z);
    let pairs = || dialect.columns.iter().zip(&row.fields);
    let unmeasured = pairs().filter(|(r, _)| coordinate(r)).all(|(_, f)| f.is_empty());
    let before = problems.0.len();
    let mut xyz = [0.0; 3];
    for ((role, field), column) in pairs().zip(columns_of(shown, &row.fields)) {
        let mut wrong = |m: Message| {
            problems.0.push(m.at(Place::line(file, row.line, shown).at(column, field.chars().count())));
        };
        let mut value = || number(field, dialect.decimal).map_err(&mut wrong).unwrap_or(f64::NAN);
        match role {
            Role::Label => point.label.clone_from(field),
            Role::Target => point.target = Some(field.clone()),
            Role::TimeS => point.time_s = Some(value()),
            Role::Skip => {}
            Role::X | Role::Y | Role::Z if unmeasured => {}
            Role::X => xyz[0] = value(),
            Role::Y => xyz[1] = value(),
            Role::Z => xyz[2] = value(),
            Role::Pose | Role::Cycle => {
                let whole = field.parse().map_err(|_| wrong(Message::error(format!("`{field}` is no whole number"))));
                *(if *role == Role::Pose { &mut point.pose } else { &mut point.cycle }) = whole.ok();
            }
        }
    }
    if unmeasured {
        point.refused = Some("not measured: no coordinates".to_owned());
    }
    if problems.0.len() > before {
        xyz = [f64::NAN; 3];
    }
    point.xyz_mm = xyz.map(|v| v * unit.in_mm());
    point
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_read_strictly() {
        assert_eq!(number("-1.5e+003", Decimal::Point).unwrap(), -1500.0);
        assert_eq!(number("1,25", Decimal::Comma).unwrap(), 1.25);
        for (field, decimal) in [
            ("1,25", Decimal::Point),
            ("1.25", Decimal::Comma),
            ("nan", Decimal::Point),
            ("inf", Decimal::Point),
            ("1 000", Decimal::Point),
            ("", Decimal::Point),
            ("1.2.3", Decimal::Point),
        ] {
            assert!(number(field, decimal).is_err(), "{field}");
        }
    }

    #[test]
    fn the_same_rows_in_every_delimiter() {
        let expected = vec![Row { line: 2, fields: ["P 1", "1.5", "-2"].map(str::to_owned).to_vec() }];
        for (text, delimiter) in [
            ("# head\n\"P 1\"  1.5\t-2\n\n", Delimiter::Blank),
            ("# head\nP 1\t1.5\t-2\r\n", Delimiter::Tab),
            ("# head\nP 1, 1.5,-2\n", Delimiter::Comma),
            ("# head\nP 1;1.5;-2", Delimiter::Semicolon),
        ] {
            assert_eq!(rows("f", text, delimiter, Some("#")).unwrap(), expected, "{delimiter:?}");
        }
    }
}
