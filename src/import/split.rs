//! Text of rows and columns: fields with their places.

pub(super) use super::number::{WHOLE, number};
use crate::base::message::{Message, Place, Problems, Result};
use crate::import::format::Delimiter;
use crate::import::format::Dialect;

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
    let dialect = Dialect { delimiter: Some(delimiter), comment: comment.map(str::to_owned), ..Dialect::default() };
    let (rows, problems) = split(file, text, &dialect);
    problems.check()?;
    Ok(rows)
}

/// The rows of a text in a dialect, and those that do not split.
pub(super) fn split(file: &str, text: &str, dialect: &Dialect) -> (Vec<Row>, Problems) {
    let mut problems = Problems::default();
    let mut rows = Vec::new();
    let is_comment = |line: &str| dialect.comment.as_ref().is_some_and(|c| line.trim_start().starts_with(c.as_str()));
    for (i, line) in text.lines().enumerate().filter(|(_, line)| !line.trim().is_empty() && !is_comment(line)) {
        match fields(line, dialect) {
            Ok(fields) => rows.push(Row { line: i + 1, fields }),
            Err((what, column)) => {
                let message = Message::error(what).at(Place::line(file, i + 1, line).at(column, 1));
                problems.0.push(message.hint("a quote inside a quoted field is written twice"));
            }
        }
    }
    (rows, problems)
}

/// Fields of a line; or what is wrong with it, and the column from 1.
fn fields(line: &str, dialect: &Dialect) -> std::result::Result<Vec<String>, (&'static str, usize)> {
    if !dialect.widths.is_empty() {
        return Ok(fixed(line, &dialect.widths));
    }
    // a sheet was written with tabs
    match dialect.delimiter.unwrap_or(Delimiter::Tab).byte() {
        Some(byte) => separated(line, char::from(byte)),
        None => Ok(blank_fields(line)),
    }
}

/// Fields of so many characters each; what comes behind them is one more.
fn fixed(line: &str, widths: &[usize]) -> Vec<String> {
    let mut rest = line;
    let mut take = |width: usize| {
        let end = rest.char_indices().nth(width).map_or(rest.len(), |(i, _)| i);
        let (field, after) = rest.split_at(end);
        rest = after;
        field.trim().to_owned()
    };
    let mut fields: Vec<String> = widths.iter().map(|width| take(*width)).collect();
    let behind = take(usize::MAX);
    if !behind.is_empty() {
        fields.push(behind);
    }
    fields
}

/// Fields between separators; one in double quotes may hold some, and a quote as two.
fn separated(line: &str, separator: char) -> std::result::Result<Vec<String>, (&'static str, usize)> {
    let blank = |c: char| c.is_whitespace() && c != separator;
    let mut fields = Vec::new();
    let mut rest = line;
    loop {
        let start = rest.trim_start_matches(blank);
        if !start.starts_with('"') {
            let (field, after) = match start.split_once(separator) {
                Some((field, after)) => (field, Some(after)),
                None => (start, None),
            };
            fields.push(field.trim_end().to_owned());
            match after {
                Some(after) => rest = after,
                None => return Ok(fields),
            }
            continue;
        }
        let column = |at: &str| line[..line.len() - at.len()].chars().count() + 1;
        let (field, after) =
            quoted(&start[1..]).ok_or(("a quote is opened and not closed on its line", column(start)))?;
        fields.push(field);
        let after = after.trim_start_matches(blank);
        match after.strip_prefix(separator) {
            Some(next) => rest = next,
            None if after.is_empty() => return Ok(fields),
            None => return Err(("there is text behind a closing quote", column(after))),
        }
    }
}

/// The text up to the closing quote, and what is behind it.
fn quoted(text: &str) -> Option<(String, &str)> {
    let mut field = String::new();
    let mut rest = text;
    loop {
        let (before, after) = rest.split_once('"')?;
        field.push_str(before);
        match after.strip_prefix('"') {
            Some(more) => {
                field.push('"');
                rest = more;
            }
            None => return Some((field.trim().to_owned(), after)),
        }
    }
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_same_rows_in_every_delimiter() {
        let expected = vec![Row { line: 2, fields: ["P 1", "1.5", "-2"].map(str::to_owned).to_vec() }];
        for (text, delimiter) in [
            ("# head\n\"P 1\"  1.5\t-2\n\n", Delimiter::Blank),
            ("# head\nP 1\t1.5\t-2\r\n", Delimiter::Tab),
            ("# head\nP 1, 1.5,-2\n", Delimiter::Comma),
            ("# head\nP 1;1.5;-2", Delimiter::Semicolon),
            ("# \"head\n\"P 1\" | 1.5|\"-2\"", Delimiter::Bar),
        ] {
            assert_eq!(rows("f", text, delimiter, Some("#")).unwrap(), expected, "{delimiter:?}");
        }
    }

    #[test]
    fn quotes_that_do_not_match_are_told_on_their_line_and_hide_no_row() {
        let dialect = Dialect { delimiter: Some(Delimiter::Comma), ..Dialect::default() };
        let (rows, problems) = split("f", "\"a,1\n\"b \"\"c\"\"\",2\n\"d\" e,3\n1.5\" ball,4\n", &dialect);
        let lines: Vec<_> = problems.0.iter().map(|m| m.place.as_ref().map(|p| (p.line, p.column))).collect();
        assert_eq!(lines, [Some((Some(1), Some(1))), Some((Some(3), Some(5)))]);
        let fields: Vec<&str> = rows.iter().flat_map(|r| &r.fields).map(String::as_str).collect();
        assert_eq!(fields, ["b \"c\"", "2", "1.5\" ball", "4"]);
    }

    #[test]
    fn fixed_widths_count_characters() {
        assert_eq!(fixed("µ 1  2.5 rest", &[3, 5]), ["µ 1".trim(), "2.5", "rest"].map(str::to_owned));
        assert_eq!(fixed("ab", &[1, 3, 2]), ["a", "b", ""].map(str::to_owned));
    }
}
