//! Guesses of the dialect of a text: every delimiter with every pair of marks gets a score.

use crate::head::{Head, StatedUnit, filled_width, first_data_row, is_worded, most_common, stated_units};
use crate::lexer::{Row, parsed, split};
use crate::{Decimal, Delimiter, Form, Header, Missing, Thousands, two_commas};
use etalon_base::message::Message;
use etalon_base::phrase;
use std::borrow::Cow;

/// Number of lines of the first ranking.
const SAMPLE: usize = 2000;
/// Number of lines on which the best guesses are ranked again.
const MOST: usize = 200_000;
/// Possible beginnings of comment lines.
const COMMENTS: [&str; 4] = ["//", "#", "%", "$$"];
/// Words that end files.
const ENDS: [&str; 3] = ["END", "EOF", "End"];
/// Maximum number of last fields that most rows do not have.
const MOST_SPARSE: usize = 4;
/// Delimiters that are tried.
const DELIMITERS: [Delimiter; 5] =
    [Delimiter::Tab, Delimiter::Semicolon, Delimiter::Bar, Delimiter::Comma, Delimiter::Blank];
/// Decimal and thousands marks that are tried.
const MARKS: [(Decimal, Option<Thousands>); 8] = [
    (Decimal::Point, None),
    (Decimal::Comma, None),
    (Decimal::Point, Some(Thousands::Comma)),
    (Decimal::Comma, Some(Thousands::Point)),
    (Decimal::Point, Some(Thousands::Apostrophe)),
    (Decimal::Comma, Some(Thousands::Apostrophe)),
    (Decimal::Point, Some(Thousands::Blank)),
    (Decimal::Comma, Some(Thousands::Blank)),
];

/// Returns the error about two commas in a text; the hint gives the marks that split its rows.
pub fn two_commas_in(text: &str) -> Message {
    let guess = guesses(text, None).into_iter().next().map(|guess| guess.form);
    match guess.and_then(|form| Some((form.delimiter?, form.decimal()))) {
        Some((delimiter, decimal)) if (delimiter, decimal) != (Delimiter::Comma, Decimal::Comma) => {
            two_commas().hint(phrase!("state-delimiter", delimiter = delimiter.name(), decimal = decimal.name()))
        }
        _ => two_commas(),
    }
}

/// One form of a text, with its evidence.
#[derive(Clone, Debug)]
pub struct Guess<'t> {
    /// Form of the text.
    pub form: Form,
    /// Number of rows before the data.
    pub header: usize,
    /// Names of the columns.
    pub named: Named<'t>,
    /// Units of lengths that the lines above the data state.
    pub stated_units: Vec<StatedUnit>,
    /// Smallest and largest number of fields of a row that is read: the last fields of a row may be
    /// missing.
    pub widths: [usize; 2],
    /// Line of the first data row.
    pub first: usize,
    /// Number of data rows.
    pub rows: usize,
    /// Number of data rows with the usual number of fields and at least two numbers.
    pub read: usize,
    /// Line of the first row that does not fit.
    pub unread: Option<usize>,
    /// For each column `true` if all its cells are numbers or mean "not measured".
    pub numeric: Vec<bool>,
    /// Evidence of the numbers for the decimal mark.
    pub numbers: NumberCounts,
    score: f64,
}

/// Counts of the numbers of a text.
#[derive(Clone, Copy, Debug)]
pub struct NumberCounts {
    /// Count of numbers.
    pub all: usize,
    /// Count of numbers with a decimal mark.
    pub fractions: usize,
    /// Count of numbers with exactly three digits behind the decimal mark.
    pub threes: usize,
}

impl Guess<'_> {
    /// Share of the rows that fit the dialect.
    pub fn share(&self) -> f64 {
        self.read as f64 / self.rows.max(1) as f64
    }
}

/// Returns the dialects whose score is within 1 % of the best, best first. The text may be the
/// cells of a sheet.
pub fn guesses<'t>(text: &'t str, sheet: Option<&str>) -> Vec<Guess<'t>> {
    let sample = &text[..text.split_inclusive('\n').take(SAMPLE).map(str::len).sum()];
    let starts = |mark: &&str| sample.lines().any(|line| line.trim_start().starts_with(*mark));
    let comment = COMMENTS.into_iter().find(starts);
    let last = text.lines().rev().find(|line| !line.trim().is_empty()).unwrap_or("").trim();
    let end = ENDS.into_iter().find(|end| last.trim_end_matches([',', ';', '\t', '|']) == *end);
    let delimiters: &[Option<Delimiter>] = match sheet {
        Some(_) => &[None],
        None => &DELIMITERS.map(Some),
    };
    let all =
        delimiters.iter().flat_map(|delimiter| MARKS.map(|(decimal, thousands)| (*delimiter, decimal, thousands)));
    let mut guesses: Vec<Guess> = all
        .map(|(delimiter, decimal, thousands)| Form {
            delimiter,
            sheet: sheet.map(str::to_owned),
            decimal: Some(decimal),
            thousands,
            comment: comment.map(str::to_owned),
            end: end.map(str::to_owned),
            ..Form::default()
        })
        .filter(|form| form.ambiguous_marks(form.delimiter).is_none())
        .filter_map(|form| guess(sample, form))
        .collect();
    guesses.sort_by(|a, b| b.score.total_cmp(&a.score));
    let best = guesses.first().map_or(0.0, |g| g.score);
    guesses.retain(|g| g.score > 0.99 * best);
    if sample.len() < text.len() {
        let more = &text[..text.split_inclusive('\n').take(MOST).map(str::len).sum()];
        guesses = guesses.into_iter().filter_map(|g| guess(more, Form { header: None, ..g.form })).collect();
        guesses.sort_by(|a, b| b.score.total_cmp(&a.score));
    }
    prefer_tabs(&mut guesses);
    for guess in &mut guesses {
        guess.stated_units = stated_units(text, &guess.form, guess.first, &|at| guess.numeric.get(at) == Some(&true));
    }
    guesses
}

/// Removes the dialects with blanks if tabs divide the same rows into as many columns of numbers:
/// blanks also divide labels such as `EU3 NE`.
fn prefer_tabs(guesses: &mut Vec<Guess>) {
    let count = |guess: &Guess| guess.numeric.iter().filter(|is| **is).count();
    let of = |guess: &Guess, delimiter: Delimiter| guess.form.delimiter == Some(delimiter);
    let by_tabs = guesses.iter().filter(|guess| of(guess, Delimiter::Tab));
    let Some([columns, read]) = by_tabs.map(|guess| [count(guess), guess.read]).max() else { return };
    // a few rows may be typed with blanks
    let most = read + read / 50;
    guesses.retain(|guess| !of(guess, Delimiter::Blank) || count(guess) > columns || guess.read > most);
}

fn guess(sample: &str, mut form: Form) -> Option<Guess<'_>> {
    let (all, _) = split("", sample, &form);
    let missing = Missing::default();
    // a formula of a workbook without a value stands for a number
    let is_gap = |field: &str| missing.says(field) || field.starts_with('=');
    let (decimal, thousands) = (form.decimal(), form.thousands);
    let is_number = |field: &Cow<str>| parsed(field, decimal, thousands).is_some();
    let is_plain = |field: &Cow<str>| parsed(field, decimal, None).is_some();
    let numbers = |row: &Row| row.fields.iter().filter(|f| is_number(f)).count();
    let of_sheet = form.sheet.is_some();
    let number = |field: &str| parsed(field, decimal, thousands).is_some();
    let header = first_data_row(&all, of_sheet, &number, &is_gap)?;
    let end = form.end.as_ref().and_then(|end| all.iter().position(|row| row.field(0) == end));
    let data = &all[header..end.unwrap_or(all.len()).max(header)];
    // a sheet omits trailing empty cells
    let widths = data.iter().map(filled_width);
    let least = if of_sheet { widths.max() } else { most_common(widths) }?;
    let holds = |field: &Cow<str>| is_number(field) || is_gap(field);
    // the headings may name fields that only some rows have
    let named = header.checked_sub(1).map_or(0, |at| filled_width(&all[at]));
    let most = if of_sheet { least } else { sparse_width(data, [least, named.max(least)], &holds) };
    let columns = if (least..=most).contains(&named) { named } else { least };
    let fits = |row: &Row| {
        (of_sheet || (least..=most).contains(&filled_width(row)))
            && (numbers(row) >= 2 || row.fields.iter().any(|f| !f.is_empty() && is_gap(f)))
    };
    let of_width: Vec<&Row> = data.iter().filter(|row| fits(row)).collect();
    let mark = if decimal == Decimal::Point { '.' } else { ',' };
    let fractional: Vec<usize> = (0..columns)
        .filter(|at| has_few_texts(&of_width, *at, &holds, &|f| is_number(f) && f.contains(mark)))
        .collect();
    // a text in a column of fractions is a fault of its row
    let is_read = |row: &Row| fits(row) && fractional.iter().all(|at| row.fields.get(*at).is_none_or(holds));
    let fitting = of_width.len();
    let good: Vec<&Row> = of_width.into_iter().filter(|row| is_read(row)).collect();
    let first = good.first()?.line;
    let used: Vec<&Cow<str>> = good.iter().flat_map(|row| &row.fields).filter(|f| is_number(f)).collect();
    let fractions = used.iter().filter(|f| f.contains(mark)).count();
    let threes = used.iter().filter(|field| has_three_digits(field, mark)).count();
    // a dialect that splits decimal numbers in two finds whole numbers only: prefer fractions
    let grouped = thousands.is_some() && used.iter().any(|field| !is_plain(field));
    let plain = if thousands.is_some() && !grouped { 0.95 } else { 1.0 };
    // a number in other marks contradicts these marks
    let contradicted = good.iter().flat_map(|row| &row.fields).filter(|f| has_marks(f) && !is_number(f)).count();
    let plain = plain * used.len() as f64 / (used.len() + contradicted).max(1) as f64;
    // rows with numbers before the data may be data
    let passed = all[..header].iter().filter(|row| !is_worded(row)).count();
    let taken = fitting as f64 / (data.len() + passed) as f64;
    let score = plain * taken * (0.5 + 0.5 * fractions as f64 / used.len().max(1) as f64);
    let numeric = (0..columns)
        .map(|c| good.iter().filter_map(move |row| row.fields.get(c)))
        .map(|fields| fields.clone().all(holds) && fields.clone().any(is_number));
    form.header = Some(Header::Rows(header));
    let numeric: Vec<bool> = numeric.collect();
    Some(Guess {
        header,
        named: Named::new(sample, &form, &all[..header], first, numeric.len()),
        stated_units: Vec::new(),
        widths: [least, most],
        first,
        rows: data.len(),
        read: good.len(),
        unread: data.iter().find(|row| !is_read(row)).map(|row| row.line),
        numeric,
        numbers: NumberCounts { all: used.len(), fractions, threes },
        score,
        form,
    })
}

/// Names of the columns.
#[derive(Clone, Debug)]
pub struct Named<'t> {
    /// Last row before the data, or the last comment before the data if it has a word for each
    /// column.
    pub row: Option<Row<'t>>,
    /// `true` if the names are in a comment.
    pub commented: bool,
    /// Names and units of the columns, of all rows that state them.
    pub head: Head,
}

impl<'t> Named<'t> {
    /// Reads the names from the rows above the data, which begin at line `first`.
    fn new(sample: &'t str, form: &Form, above: &[Row<'t>], first: usize, columns: usize) -> Self {
        let names = above.last().cloned();
        let blanks = form.delimiter == Some(Delimiter::Blank);
        let head = Head::new(above, columns, blanks);
        let worded = names.as_ref().is_some_and(|row| row.fields.len() >= columns);
        let comment = form.comment.as_deref().filter(|_| !worded && head.names.is_none());
        match comment.and_then(|comment| named_by_comment(sample, form, comment, first, columns)) {
            Some(row) => {
                let head = Head::new(std::slice::from_ref(&row), columns, blanks);
                Self { row: Some(row), commented: true, head }
            }
            None => Self { row: names, commented: false, head },
        }
    }
}

/// `true` if a column has fractions in most rows, and a text in a few.
fn has_few_texts(
    rows: &[&Row],
    at: usize,
    holds: &dyn Fn(&Cow<str>) -> bool,
    is_fraction: &dyn Fn(&Cow<str>) -> bool,
) -> bool {
    let fields = || rows.iter().filter_map(|row| row.fields.get(at));
    let texts = fields().filter(|field| !holds(field)).count();
    let fractions = fields().filter(|field| is_fraction(field)).count();
    // a number in other marks is evidence about the marks
    let in_other_marks = fields().any(|field| !holds(field) && has_marks(field));
    texts > 0 && !in_other_marks && 20 * texts <= rows.len() && 2 * fractions > rows.len()
}

/// `true` if exactly three digits follow a mark: it may be a thousands mark, unless it follows a
/// zero.
fn has_three_digits(field: &str, mark: char) -> bool {
    field.split_once(mark).is_some_and(|(before, after)| {
        let whole = before.trim_start_matches(['+', '-']);
        !whole.starts_with('0') && after.len() == 3 && after.bytes().all(|b| b.is_ascii_digit())
    })
}

/// Largest number of fields of the rows, if rows with more fields than the usual number continue
/// the usual ones: readings under a heading and remarks that are missing in most rows. `holds` is
/// `true` for a number or a gap; a number without a heading may be the second half of another one.
fn sparse_width(data: &[Row], [usual, named]: [usize; 2], holds: &dyn Fn(&Cow<str>) -> bool) -> usize {
    let of_usual = || data.iter().filter(|row| filled_width(row) == usual).take(SAMPLE);
    let numeric: Vec<usize> =
        (0..usual).filter(|at| of_usual().all(|row| row.fields.get(*at).is_some_and(holds))).collect();
    let wider = || data.iter().filter(|row| filled_width(row) > usual);
    let is_remark = |field: &Cow<str>| field.is_empty() || !holds(field);
    let continues = |row: &Row| {
        numeric.iter().all(|at| row.fields.get(*at).is_some_and(holds)) && row.fields.iter().skip(named).all(is_remark)
    };
    let most = wider().map(filled_width).max().unwrap_or(usual);
    // a text in front of some rows shifts their numbers
    let is_sparse = numeric.len() >= 2 && most <= usual + MOST_SPARSE && wider().all(continues);
    if is_sparse { most } else { usual }
}

/// `true` for a number in some marks: digits with marks between them, and a sign.
fn has_marks(field: &str) -> bool {
    let digits = field.trim_start_matches(['+', '-', '\u{2212}']);
    let is_mark = |c: char| MARKS.iter().filter_map(|marks| marks.1).any(|mark| mark.is(c));
    let ends = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit());
    let inside = digits.chars().all(|c| c.is_ascii_digit() || is_mark(c));
    inside && digits.contains(is_mark) && ends(digits.chars().next()) && ends(digits.chars().next_back())
}

/// Returns the last comment with words before the data, which begin at line `first`, if it has a
/// word for each of `columns`. Below it are only lines without words, such as the number of rows.
fn named_by_comment<'t>(text: &'t str, form: &Form, comment: &str, first: usize, columns: usize) -> Option<Row<'t>> {
    let lines: Vec<(usize, &str)> = text.lines().take(first.saturating_sub(1)).enumerate().collect();
    let (at, line) = lines.into_iter().rev().find(|(_, line)| line.contains(char::is_alphabetic))?;
    let words = line.trim_start().strip_prefix(comment)?;
    let plain = Form { comment: None, ..form.clone() };
    let (mut rows, _) = split("", words, &plain);
    let blanks = form.delimiter == Some(Delimiter::Blank);
    let bracketed = |row: &Row| row.fields.iter().filter(|field| field.starts_with(['[', '('])).count();
    let width = |row: &Row| row.fields.len() - if blanks { bracketed(row) } else { 0 };
    let mut row = rows.pop().filter(|row| row.fields.len() == columns || width(row) == columns)?;
    let is_number = |field: &Cow<str>| parsed(field, form.decimal(), form.thousands).is_some();
    let worded =
        row.fields.iter().any(|field| field.contains(char::is_alphabetic)) && !row.fields.iter().any(is_number);
    row.line = at + 1;
    worded.then_some(row)
}

/// Returns the names of all columns, if the head has a name for each.
pub fn names(guess: &Guess) -> Option<Vec<String>> {
    guess.named.head.names.clone()
}

/// Splits a time of day from the difference of its zone from UTC in minutes (ISO 8601: `+02:00`).
pub fn split_zone(time: &str) -> Option<(&str, i32)> {
    let (before, zone) = time.split_at(time.len().checked_sub(6).filter(|at| time.is_char_boundary(*at))?);
    let sign = match zone.as_bytes()[0] {
        b'+' => 1,
        b'-' => -1,
        _ => return None,
    };
    let (hours, minutes) = zone[1..].split_once(':')?;
    let number =
        |text: &str| text.parse::<u8>().ok().filter(|_| text.len() == 2 && text.bytes().all(|b| b.is_ascii_digit()));
    before.contains(':').then_some((before, sign * (60 * i32::from(number(hours)?) + i32::from(number(minutes)?))))
}

/// `true` for a date or a time of day: numbers with a colon, a `T`, or two of the marks of a date
/// between them.
pub fn is_time(cell: &str) -> bool {
    let cell = split_zone(cell).map_or(cell, |(time, _)| time);
    let bytes = cell.as_bytes();
    let is_digit = |at: usize| bytes.get(at).is_some_and(u8::is_ascii_digit);
    let between = |at: &usize| *at > 0 && is_digit(at - 1) && is_digit(at + 1);
    let marks = (0..bytes.len()).filter(|at| matches!(bytes[*at], b'-' | b'.' | b'/')).filter(between).count();
    let plain = bytes.iter().all(|b| b.is_ascii_digit() || matches!(b, b':' | b'-' | b'.' | b'/' | b' ' | b'T' | b'Z'));
    let digits = bytes.iter().filter(|b| b.is_ascii_digit()).count();
    // three numbers with one mark between them; a version has more
    let is_date = ['-', '.', '/'].into_iter().any(|mark| {
        let parts: Vec<&str> = cell.split(mark).collect();
        let lengths: Vec<usize> = parts.iter().map(|part| part.trim().len()).collect();
        matches!(lengths[..], [1..=2, 1..=2, 1..=4] | [4, 1..=2, 1..=2])
    });
    digits >= 4 && plain && (marks >= 2 && is_date || bytes.contains(&b':') || bytes.contains(&b'T'))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Cells that only some rows have: under a heading, or texts. A number without a heading may be
    /// the second half of a number in groups of three.
    #[test]
    fn last_cells_may_be_missing_in_most_rows() {
        let rows = |last: &str| -> String {
            let row = |i: usize| format!("P{i};{i}.5;{i}.25;{i}.75{}\n", if i % 5 == 4 { last } else { "" });
            (0..30).map(row).collect()
        };
        for (head, last, widths, columns) in [
            ("Name;X;Y;Z;Temp\n", ";20.5", [4, 5], 5),
            ("Name;X;Y;Z\n", ";moved", [4, 5], 4),
            ("", ";moved", [4, 5], 4),
            ("Name;X;Y;Z\n", ";20.5", [4, 4], 4),
            ("", ";20.5", [4, 4], 4),
        ] {
            let text = head.to_owned() + &rows(last);
            let best = &guesses(&text, None)[0];
            assert_eq!((best.widths, best.numeric.len()), (widths, columns), "{head}{last}");
            assert_eq!(best.read, if widths == [4, 4] { 24 } else { 30 }, "{head}{last}");
        }
    }

    #[test]
    fn a_number_with_its_sign_behind_it_is_no_date() {
        for time in [
            "2022-10-11",
            "11.10.2022",
            "02/12/25 16:52:45",
            "16:52:45.125",
            "20221011T150648Z",
            "2026-10-03 19:36:34.73-07:00",
        ] {
            assert!(is_time(time), "{time}");
        }
        for number in ["345.6780-", "-345.6780", "12345", "1234.5 678", "2.5.3.50294", "1.272.619"] {
            assert!(!is_time(number), "{number}");
        }
    }
}
