//! What a text could be: how its rows could be split into numbers, every delimiter with every pair of marks, weighed; and
//! what its columns may contain, by their names or by their values.

use super::lexer::{Row, marked, split};
use crate::dialect::{ColumnRole, Columns, Decimal, Delimiter, Dialect, Header, Missing, Thousands};
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
    /// Of each column, whether it holds numbers alone (or cells that mean "not measured").
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
    vec![ColumnRole::X, ColumnRole::Y].into()
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

/// Roles by the names of the header, where it names every column and x and y; else by position: leading texts are the
/// label, the first numbers x, y, z, and a direction behind them i, j, k. A whole number before numbers with a decimal mark is
/// none of them.
pub(super) fn roles(guess: &Guess) -> Vec<ColumnRole> {
    let named: Vec<ColumnRole> = names(guess).into_iter().flatten().map(role_of).collect();
    let once = |role| named.iter().filter(|r| **r == role).count() == 1;
    match once(ColumnRole::X) && once(ColumnRole::Y) {
        true => single(named),
        false => by_position(guess),
    }
}

/// Roles of which each but the label is there once; what is there again is not read.
fn single(roles: Vec<ColumnRole>) -> Vec<ColumnRole> {
    let again = |i: usize| roles[..i].contains(&roles[i]) && roles[i] != ColumnRole::Skip;
    let axes = [ColumnRole::I, ColumnRole::J, ColumnRole::K].iter().all(|r| roles.contains(r));
    let partial = |role: ColumnRole| matches!(role, ColumnRole::I | ColumnRole::J | ColumnRole::K) && !axes;
    (0..roles.len()).map(|i| if again(i) || partial(roles[i]) { ColumnRole::Skip } else { roles[i] }).collect()
}

/// The names of all columns, if the header has as many as the data.
pub(super) fn names<'g>(guess: &'g Guess) -> Option<Vec<&'g str>> {
    let names = guess.names.as_ref()?.fields.iter().map(AsRef::as_ref);
    let names: Vec<&str> = names.collect();
    // a header of words, not of numbers
    (names.len() >= guess.numeric.len() && names.iter().any(|n| n.contains(char::is_alphabetic)))
        .then(|| names[..guess.numeric.len()].to_vec())
}

/// A name without its unit, in small letters: `X [mm]`, `x_mm` and `X` are one.
fn plain(name: &str) -> String {
    let name = name.split(['[', '(']).next().unwrap_or("").trim().to_lowercase();
    let name = ["_mm", "_m", "_inch", " mm"].iter().find_map(|unit| name.strip_suffix(unit)).unwrap_or(&name);
    name.to_owned()
}

fn role_of(name: &str) -> ColumnRole {
    match plain(name).as_str() {
        "x" => ColumnRole::X,
        "y" => ColumnRole::Y,
        "z" => ColumnRole::Z,
        "i" | "nx" => ColumnRole::I,
        "j" | "ny" => ColumnRole::J,
        "k" | "nz" => ColumnRole::K,
        "label" | "name" | "point" | "point_name" | "point name" | "id" => ColumnRole::Label,
        "target" => ColumnRole::Target,
        "pose" => ColumnRole::Pose,
        "cycle" | "run" | "repeat" => ColumnRole::Cycle,
        "time_s" => ColumnRole::TimeS,
        _ => ColumnRole::Skip,
    }
}

fn by_position(guess: &Guess) -> Vec<ColumnRole> {
    let count = guess.numeric.iter().filter(|n| **n).count();
    let directed = count == 6 && direction(guess);
    let mut axes = [ColumnRole::X, ColumnRole::Y, ColumnRole::Z].iter().chain(if directed {
        &[ColumnRole::I, ColumnRole::J, ColumnRole::K][..]
    } else {
        &[]
    });
    let mut before = usize::from(count % 3 == 1 && counted(guess));
    let leading = guess.numeric.iter().position(|n| *n).unwrap_or(0);
    let role = |(i, numeric): (usize, &bool)| match numeric {
        true if before > 0 => {
            before -= 1;
            ColumnRole::Skip
        }
        true => axes.next().copied().unwrap_or(ColumnRole::Skip),
        false if i < leading && !guess.first.fields.get(i).is_some_and(|field| is_time(field)) => ColumnRole::Label,
        false => ColumnRole::Skip,
    };
    guess.numeric.iter().enumerate().map(role).collect()
}

/// Whether the first number is whole, and the next three are not.
fn counted(guess: &Guess) -> bool {
    let mark = if guess.dialect.decimal == Decimal::Point { '.' } else { ',' };
    let numbers = guess.first.fields.iter().zip(&guess.numeric).filter(|(_, numeric)| **numeric);
    let marked: Vec<bool> = numbers.map(|(field, _)| field.contains(mark)).take(4).collect();
    marked == [false, true, true, true]
}

/// A date or a time of day.
fn is_time(cell: &str) -> bool {
    let digits = cell.bytes().filter(u8::is_ascii_digit).count();
    digits >= 4
        && cell.bytes().all(|b| b.is_ascii_digit() || matches!(b, b':' | b'-' | b'.' | b'/' | b' ' | b'T' | b'Z'))
}

/// Whether the last three numbers of the first row are a direction.
fn direction(guess: &Guess) -> bool {
    let number = |field: &Cow<str>| marked(field, guess.dialect.decimal, guess.dialect.thousands).ok();
    let numbers: Vec<f64> = guess.first.fields.iter().filter_map(number).collect();
    let [.., i, j, k] = numbers[..] else { return false };
    (etalon_base::pose::norm([i, j, k]) - 1.0).abs() < 0.01
}

/// Whether the rows are joint values rather than points, and by what one sees it.
pub(super) fn looks_like_a_log(guess: &Guess) -> Option<String> {
    let names = names(guess).unwrap_or_default();
    let joints: Vec<&str> = names.iter().copied().filter(|name| is_joint(name)).collect();
    if joints.len() >= 2 {
        return Some(format!("the header names joints: {}", joints[..joints.len().min(6)].join(", ")));
    }
    let only_numbers = guess.numeric.iter().all(|n| *n) && names.is_empty();
    match guess.numeric.len() {
        n @ (6 | 7) if only_numbers && !direction(guess) => {
            Some(format!("every row is {n} numbers, and no direction among them"))
        }
        _ => None,
    }
}

/// `q1`, `J2`, `A3`, `joint_4`, `lbr_joint_0`, `actual_q_5`, `RP1`, `theta1`, `enc 2` and the like.
pub(super) fn is_joint(name: &str) -> bool {
    let name = name.split(['[', '(']).next().unwrap_or("").trim().to_lowercase();
    let name = ["_deg", "_rad", "_mm"].iter().find_map(|unit| name.strip_suffix(unit)).unwrap_or(&name);
    let stem = name.trim_end_matches(|c: char| c.is_ascii_digit());
    let word = stem.trim_end_matches(['_', ' ', '-', '.']);
    let stems = ["q", "j", "a", "rp", "rho", "theta", "axis", "enc", "encoder", "motor"];
    stem.len() < name.len() && (stems.contains(&word) || word.ends_with("joint") || word.ends_with("_q"))
}
