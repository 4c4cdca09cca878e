//! How rows of a text could be split into numbers: every delimiter with every pair of marks, weighed.

use super::lexer::marked;
use super::lexer::{Row, split};
use crate::import::format::Columns;
use crate::import::format::Decimal;
use crate::import::format::Delimiter;
use crate::import::format::Dialect;
use crate::import::format::Header;
use crate::import::format::Missing;
use crate::import::format::Thousands;
use std::borrow::Cow;

/// Rows that are weighed; a proposal is then tried on all.
const SAMPLE: usize = 2000;
/// Lines that start like this may be comments.
const COMMENTS: [&str; 4] = ["//", "#", "%", "$$"];
/// Words that end files.
const ENDS: [&str; 3] = ["END", "EOF", "End"];
/// What is weighed between fields.
const DELIMITERS: [Delimiter; 5] =
    [Delimiter::Tab, Delimiter::Semicolon, Delimiter::Bar, Delimiter::Comma, Delimiter::Blank];
/// Marks that are weighed: numbers with groups of digits last.
const MARKS: [(Decimal, Option<Thousands>); 7] = [
    (Decimal::Point, None),
    (Decimal::Comma, None),
    (Decimal::Point, Some(Thousands::Comma)),
    (Decimal::Comma, Some(Thousands::Point)),
    (Decimal::Point, Some(Thousands::Apostrophe)),
    (Decimal::Point, Some(Thousands::Blank)),
    (Decimal::Comma, Some(Thousands::Blank)),
];

/// One way to split a text.
#[derive(Clone, Debug)]
pub(super) struct Guess<'t> {
    /// Without columns.
    pub dialect: Dialect,
    /// Rows before the data.
    pub header: usize,
    /// The last of them.
    pub names: Option<Row<'t>>,
    /// Rows of data that were looked at, and those that have as many fields as most, two of them numbers.
    pub rows: usize,
    pub read: usize,
    /// Line of the first one that has not.
    pub unread: Option<usize>,
    /// Of each column, whether it holds numbers alone (or cells that say "not measured").
    pub numeric: Vec<bool>,
    /// The first row of data.
    pub first: Row<'t>,
    /// Numbers, those with a decimal mark, and those with it before exactly three digits.
    pub numbers: usize,
    pub fractions: usize,
    pub threes: usize,
    score: f64,
}

impl Guess<'_> {
    /// Share of the rows that read this way.
    pub fn share(&self) -> f64 {
        self.read as f64 / self.rows.max(1) as f64
    }
}

/// Ways to split the text, or the cells of a sheet, that explain it nearly as well as the best one, which is the first.
pub(super) fn guesses<'t>(text: &'t str, sheet: Option<&str>) -> Vec<Guess<'t>> {
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
        .map(|(delimiter, decimal, thousands)| Dialect {
            delimiter,
            sheet: sheet.map(str::to_owned),
            decimal,
            thousands,
            comment: comment.map(str::to_owned),
            end: end.map(str::to_owned),
            ..Dialect::default()
        })
        .filter(|dialect| Dialect { columns: some_columns(), ..dialect.clone() }.check().is_empty())
        .filter_map(|dialect| guess(sample, dialect))
        .collect();
    guesses.sort_by(|a, b| b.score.total_cmp(&a.score));
    let best = guesses.first().map_or(0.0, |g| g.score);
    guesses.retain(|g| g.score > 0.99 * best);
    guesses
}

/// Columns against which marks and delimiter can be checked.
fn some_columns() -> Columns {
    vec![crate::import::format::Role::X, crate::import::format::Role::Y].into()
}

fn guess(sample: &str, mut dialect: Dialect) -> Option<Guess<'_>> {
    let (all, _) = split("", sample, &dialect);
    let missing = Missing::default();
    let is_number = |field: &Cow<str>| marked(field, dialect.decimal, dialect.thousands).is_ok();
    let numbers = |row: &Row| row.fields.iter().filter(|f| is_number(f)).count();
    let header = all.iter().position(|row| numbers(row) >= 2)?;
    let end = dialect.end.as_ref().and_then(|end| all.iter().position(|row| row.field(0) == end));
    let data = &all[header..end.unwrap_or(all.len()).max(header)];
    // fields behind the last one that holds something are none
    let width = |row: &Row| row.fields.iter().rposition(|f| !f.is_empty()).map_or(0, |i| i + 1);
    let of_sheet = dialect.sheet.is_some();
    // cells behind the last one of a row are empty, and not written
    let columns = if of_sheet { data.iter().map(width).max() } else { most_common(data.iter().map(width)) }?;
    let fits = |row: &Row| {
        (of_sheet || width(row) == columns)
            && (numbers(row) >= 2 || row.fields.iter().any(|f| !f.is_empty() && missing.says(f)))
    };
    let good: Vec<&Row> = data.iter().filter(|row| fits(row)).collect();
    let first = (*good.first()?).clone();
    let used: Vec<&Cow<str>> = good.iter().flat_map(|row| &row.fields).filter(|f| is_number(f)).collect();
    let mark = if dialect.decimal == Decimal::Point { '.' } else { ',' };
    let fractions = used.iter().filter(|f| f.contains(mark)).count();
    let three = |field: &&&Cow<str>| {
        field.split_once(mark).is_some_and(|(_, after)| after.len() == 3 && after.bytes().all(|b| b.is_ascii_digit()))
    };
    let threes = used.iter().filter(three).count();
    // a reading that splits decimal numbers in two has whole numbers everywhere: prefer those with fractions
    let plain = if dialect.thousands.is_some() { 0.95 } else { 1.0 };
    // rows before the data that hold numbers may be data
    let worded = |row: &&Row| {
        !row.fields.iter().any(|f| f.trim_start_matches(['+', '-', '.']).starts_with(|c: char| c.is_ascii_digit()))
    };
    let passed = all[..header].iter().filter(|row| !worded(row)).count();
    let taken = good.len() as f64 / (data.len() + passed) as f64;
    let score = plain * taken * (0.5 + 0.5 * fractions as f64 / used.len().max(1) as f64);
    let holds = |field: &Cow<str>| is_number(field) || missing.says(field);
    let numeric = (0..columns)
        .map(|c| good.iter().filter_map(move |row| row.fields.get(c)))
        .map(|fields| fields.clone().all(holds) && fields.clone().any(is_number));
    dialect.header = Header::Rows(header);
    Some(Guess {
        header,
        names: header.checked_sub(1).map(|i| all[i].clone()),
        rows: data.len(),
        read: good.len(),
        unread: data.iter().find(|row| !fits(row)).map(|row| row.line),
        numeric: numeric.collect(),
        numbers: used.len(),
        fractions,
        threes,
        score,
        first,
        dialect,
    })
}

/// The count that occurs most often; of several the largest.
fn most_common(counts: impl Iterator<Item = usize>) -> Option<usize> {
    let mut times = std::collections::BTreeMap::new();
    counts.for_each(|count| *times.entry(count).or_insert(0usize) += 1);
    times.into_iter().max_by_key(|&(count, times)| (times, count)).map(|(count, _)| count)
}
