//! Table of one interpretation of a file: columns with all values.

use crate::propose::headings::{Heading, Word};
use etalon_robots::Robot;
use etalon_tables::Form;
use etalon_tables::guess::{Guess, is_time, names};
use etalon_tables::lexer::{Row, each_row, marked};
use std::collections::BTreeSet;

/// Maximum number of rows that are read; the proposal shows if the file has more.
pub(crate) const MOST_ROWS: usize = 200_000;

/// Maximum number of columns that are interpreted; the proposal shows if the file has more.
const MOST_COLUMNS: usize = 4096;

/// Table of one interpretation.
#[derive(Clone, Debug, Default)]
pub(crate) struct Table {
    pub columns: Vec<Column>,
    /// Number of rows that were read.
    pub rows: usize,
    /// `true` if there are more rows.
    pub sampled: bool,
    /// Number of columns of the file.
    pub width: usize,
    /// Form of the text.
    pub form: Form,
}

/// Column of a table.
#[derive(Clone, Debug, Default)]
pub(crate) struct Column {
    /// Name in the header.
    pub name: Option<String>,
    /// Words and unit of the name.
    pub heading: Heading,
    /// Name of the group of columns above the heading.
    pub group: Option<String>,
    /// Values of a column of numbers, NaN if not measured; empty for a column of texts.
    pub values: Vec<f64>,
    /// Distinct texts, at most [`TEXTS`].
    pub texts: Vec<String>,
    /// Text of each row; empty for a column of numbers.
    pub cells: Vec<Box<str>>,
    /// `true` if every text is a date or a time of day.
    pub clock: bool,
}

/// Maximum number of stored texts of a column.
const TEXTS: usize = 64;

impl Table {
    /// Reads the rows with the number of fields of the guess.
    pub fn read(text: &str, guess: &Guess) -> Self {
        let width = guess.numeric.len();
        let names = names(guess).unwrap_or_default();
        let unit = |i: usize| guess.named.head.units.get(i).copied().flatten();
        let mut columns: Vec<Column> = (0..width.min(MOST_COLUMNS))
            .map(|i| {
                let name = names.get(i).map(|name| name.trim().to_owned()).filter(|name| !name.is_empty());
                let mut heading = name.as_deref().map(Heading::parse).unwrap_or_default();
                if unit(i).is_some() {
                    (heading.unit, heading.bare_metre) = (unit(i), false);
                }
                heading.other_quantity |= guess.named.head.others.contains(&i);
                let group = guess.named.head.groups.get(i).cloned().flatten();
                Column { name, heading, group, clock: true, ..Column::default() }
            })
            .collect();
        let skipped = guess.header;
        let ends = |row: &Row| guess.form.end.as_ref().is_some_and(|end| row.field(0) == end);
        let filled = |row: &Row| row.fields.iter().rposition(|f| !f.is_empty()).map_or(0, |i| i + 1);
        let [least, most] = guess.widths;
        let fits = |row: &Row| {
            guess.form.sheet.is_some() || (least..=most).contains(&filled(row)) || row.fields.len() == width
        };
        let data = each_row("", text, &guess.form).flatten().skip(skipped).filter(|row| !ends(row) && fits(row));
        let (mut rows, mut sampled) = (0, false);
        for row in data {
            if rows == MOST_ROWS {
                sampled = true;
                break;
            }
            rows += 1;
            for (i, column) in columns.iter_mut().enumerate() {
                column.add(row.field(i), guess.numeric[i], guess);
            }
        }
        columns.iter_mut().for_each(Column::decide_grad);
        name_lettered_bodies(&mut columns);
        Self { columns, rows, sampled, width, form: guess.form.clone() }
    }

    /// Returns the heading of a column in backticks, or its number.
    pub fn called(&self, at: usize) -> String {
        match self.columns.get(at).and_then(|column| column.name.as_ref()) {
            Some(name) => format!("`{name}`"),
            None => format!("column {}", at + 1),
        }
    }

    /// Returns the values of these columns in rows where all of them are finite.
    pub fn finite_rows<const N: usize>(&self, at: [usize; N]) -> impl Iterator<Item = [f64; N]> + '_ {
        let get = move |row: usize| at.map(|i| self.columns[i].values.get(row).copied().unwrap_or(f64::NAN));
        (0..self.rows).map(get).filter(|values| values.iter().all(|v| v.is_finite()))
    }

    /// `true` if these columns are unit vectors in all rows; four zeros are a body that the
    /// instrument did not see.
    pub fn are_unit<const N: usize>(&self, at: [usize; N]) -> bool {
        let mut any = false;
        let seen = |values: &[f64; N]| N != 4 || values.iter().any(|v| *v != 0.0);
        self.finite_rows(at).filter(seen).all(|values| {
            any = true;
            (values.iter().map(|v| v * v).sum::<f64>().sqrt() - 1.0).abs() < UNIT
        }) && any
    }

    /// `true` if these nine columns are a rotation matrix (row by row) in all rows.
    pub fn are_rotations(&self, at: [usize; 9]) -> bool {
        let mut any = false;
        self.finite_rows(at).all(|m| {
            any = true;
            let row = |i: usize| [m[3 * i], m[3 * i + 1], m[3 * i + 2]];
            let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
            (0..3).all(|i| (i..3).all(|j| (dot(row(i), row(j)) - f64::from(u8::from(i == j))).abs() < 2.0 * UNIT))
        }) && any
    }
}

/// Names the bodies of headings that end in a letter for each body: `Xa`, `Ya`, `Za`, `q0a` .. and
/// `Xb`, `Yb`, `Zb` .. become `body_a x` and so on. One letter alone names nothing.
fn name_lettered_bodies(columns: &mut [Column]) {
    let joined: Vec<String> = columns.iter().map(|column| column.heading.joined().replace(' ', "")).collect();
    let has = |axis: char, letter: char| joined.iter().any(|name| *name == format!("{axis}{letter}"));
    let letters: Vec<char> =
        ('a'..='w').filter(|letter| ['x', 'y', 'z'].iter().all(|axis| has(*axis, *letter))).collect();
    if letters.len() < 2 {
        return;
    }
    for (column, name) in columns.iter_mut().zip(&joined) {
        let Some((letter, part)) = letters.iter().find_map(|letter| Some((letter, name.strip_suffix(*letter)?))) else {
            continue;
        };
        let part = match part {
            "q0" | "qo" | "qw" => "qw",
            "x" | "y" | "z" | "qx" | "qy" | "qz" => part,
            _ => continue,
        };
        column.heading.words = vec![format!("body_{letter}"), part.to_owned()];
    }
}

/// Returns the axis that a heading names, and its other words.
pub(crate) fn heading_axis(column: &Column) -> Option<(usize, String)> {
    const BEFORE: [&str; 10] = ["", "p", "pos", "t", "tcp", "pt", "c", "coord", "trans", "loc"];
    let words = &column.heading.words;
    let axis = |word: &str| {
        let last = word.chars().last()?;
        let at = ['x', 'y', 'z'].iter().position(|c| *c == last)?;
        let before = &word[..word.len() - 1];
        BEFORE.contains(&before).then(|| (at, before.to_owned()))
    };
    let places: Vec<usize> = (0..words.len()).filter(|i| axis(&words[*i]).is_some()).collect();
    let exact = places.iter().copied().find(|i| words[*i].len() == 1);
    let at = exact.or(places.first().copied())?;
    let (axis, before) = axis(&words[at])?;
    let mut rest = column.heading.without(at);
    if !before.is_empty() {
        rest.insert(0, before);
    }
    Some((axis, rest.join(" ")))
}

/// Columns that are headed by the joints of a robot, in its order; `None` if one is missing.
pub(crate) fn joint_columns(chain: &dyn Robot, table: &Table) -> Option<Vec<usize>> {
    let headed = |name: &str| {
        table.columns.iter().position(|column| {
            column.is_numeric() && column.name.as_deref().is_some_and(|heading| heading_without_unit(heading) == name)
        })
    };
    chain.joints().iter().map(|joint| headed(&joint.name)).collect()
}

/// Returns a heading without its unit: `elbow` of `elbow [rad]` and of `elbow_rad`.
pub fn heading_without_unit(heading: &str) -> &str {
    let name = heading.split(['[', '(']).next().unwrap_or(heading).trim();
    let units = ["_deg", "_rad", "_mm", "_m"];
    units.iter().find_map(|unit| name.strip_suffix(unit)).unwrap_or(name)
}

/// Maximum deviation from 1 of the length of a unit vector that is rounded to three digits.
const UNIT: f64 = 2e-3;

impl Column {
    /// Cells as keys of rows.
    pub fn texts(&self) -> Vec<String> {
        match self.is_numeric() {
            true => self.values.iter().map(f64::to_string).collect(),
            false => self.cells.iter().map(|cell| cell.trim().to_owned()).collect(),
        }
    }

    /// Decides whether `grad` of an angle of an instrument means gon: angles above 360 do. Others
    /// leave the unit open.
    fn decide_grad(&mut self) {
        let angles = [Word::Azimuth, Word::Zenith, Word::Elevation];
        if self.heading.grad && angles.into_iter().any(|word| self.heading.has(word)) {
            self.heading.unit = (self.largest() > 360.0).then_some("gon");
        }
    }

    fn add(&mut self, field: &str, numeric: bool, guess: &Guess) {
        if numeric {
            self.values.push(marked(field, guess.form.decimal(), guess.form.thousands).unwrap_or(f64::NAN));
            return;
        }
        self.clock &= is_time(field.trim_start_matches('\''));
        if self.texts.len() < TEXTS && !self.texts.iter().any(|known| known == field) {
            self.texts.push(field.to_owned());
        }
        self.cells.push(field.into());
    }

    /// Number of different texts in the rows with two and more numbers.
    pub fn distinct_in_rows(&self, table: &Table) -> usize {
        let numeric: Vec<&Column> = table.columns.iter().filter(|column| column.is_numeric()).collect();
        let holds = |row: usize| {
            let finite = |column: &&&Column| column.values.get(row).is_some_and(|value| value.is_finite());
            numeric.iter().filter(finite).take(2).count() == 2
        };
        let texts = self.cells.iter().enumerate().filter(|(row, _)| holds(*row));
        texts.map(|(_, text)| text).collect::<BTreeSet<&Box<str>>>().len()
    }

    /// Returns the letter at the end of the heading that is a unit or the component of a
    /// quaternion: `ori_s` (the scalar, or seconds), `q_k` (the third, or kelvin).
    pub fn component_letter(&self) -> Option<char> {
        let name = self.name.as_deref()?.trim_end();
        let letter = name.chars().last()?.to_ascii_lowercase();
        let is_unit = matches!((self.heading.unit, letter), (Some("s"), 's') | (Some("K"), 'k'));
        (is_unit && name[..name.len() - 1].ends_with(['_', ' ', '.', '-'])).then_some(letter)
    }

    /// `true` for a column of numbers.
    pub fn is_numeric(&self) -> bool {
        !self.values.is_empty()
    }

    /// Returns the finite values.
    pub fn numbers(&self) -> impl Iterator<Item = f64> + '_ {
        self.values.iter().copied().filter(|v| v.is_finite())
    }

    /// Returns the smallest and the largest value.
    pub fn range(&self) -> (f64, f64) {
        self.numbers().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)))
    }

    /// Returns the largest magnitude.
    pub fn largest(&self) -> f64 {
        self.numbers().fold(0.0, |most, v| most.max(v.abs()))
    }

    /// `true` if all values are whole numbers.
    pub fn is_whole(&self) -> bool {
        self.is_numeric() && self.numbers().all(|v| v.fract() == 0.0)
    }

    /// `true` if every value is larger than the one before.
    pub fn is_increasing(&self) -> bool {
        let values: Vec<f64> = self.numbers().collect();
        values.len() > 1 && values.windows(2).all(|pair| pair[1] > pair[0])
    }

    /// `true` for whole numbers that increase by one in all rows.
    pub fn is_counter(&self) -> bool {
        let values: Vec<f64> = self.numbers().collect();
        self.is_whole() && values.len() > 1 && values.windows(2).all(|pair| pair[1] - pair[0] == 1.0)
    }

    /// Returns the first two neighbours that a running number does not have: whole numbers that
    /// increase in steps of different sizes.
    pub fn first_gap(&self) -> Option<[f64; 2]> {
        let values: Vec<f64> = self.numbers().collect();
        let steps = || values.windows(2).filter_map(|pair| <[f64; 2]>::try_from(pair).ok());
        let least = steps().map(|[before, after]| after - before).fold(f64::INFINITY, f64::min);
        // beyond 2^53 numbers lose their last digits
        let running = self.is_whole() && self.is_increasing() && self.largest() < 9e15;
        steps().find(|[before, after]| running && after - before > least)
    }

    /// `true` if a running number increases by one in most of its steps.
    pub fn counts_mostly(&self) -> bool {
        let values: Vec<f64> = self.numbers().collect();
        let ones = values.windows(2).filter(|pair| pair[1] - pair[0] == 1.0).count();
        self.is_whole() && self.is_increasing() && 2 * ones + 1 >= values.len()
    }

    /// Returns the first two neighbours that are not in order, if the column has each of its whole
    /// numbers once and few others are between them.
    pub fn first_out_of_order(&self) -> Option<[f64; 2]> {
        let values: Vec<f64> = self.numbers().collect();
        let mut sorted = values.clone();
        sorted.sort_by(f64::total_cmp);
        let (low, high) = self.range();
        let once = self.is_whole() && sorted.windows(2).all(|pair| pair[0] != pair[1]);
        let dense = high - low < 4.0 * values.len() as f64;
        let mut steps = values.windows(2).filter_map(|pair| <[f64; 2]>::try_from(pair).ok());
        steps.find(|[before, after]| once && dense && after < before)
    }

    /// Returns the unit of times that count from 1970, by their size.
    pub fn epoch_unit(&self) -> Option<&'static str> {
        // from 2001 to 2096
        let since_1970 = |second: f64| self.numbers().all(|v| (1e9 * second..4e9 * second).contains(&v));
        let units = [("s", 1.0), ("ms", 1e3), ("us", 1e6), ("ns", 1e9)];
        units.into_iter().find(|(_, second)| self.is_numeric() && since_1970(*second)).map(|(unit, _)| unit)
    }

    /// Returns the median step between neighbouring values.
    pub fn usual_step(&self) -> f64 {
        let values: Vec<f64> = self.numbers().collect();
        let mut steps: Vec<f64> = values.windows(2).map(|pair| (pair[1] - pair[0]).abs()).collect();
        steps.sort_by(f64::total_cmp);
        steps.get(steps.len() / 2).copied().unwrap_or(0.0)
    }

    /// `true` if times with this step are seconds: in any smaller unit a clock of a robot or of an
    /// instrument has a step of one and more.
    pub fn has_step_of_seconds(&self) -> bool {
        let step = self.usual_step();
        let (low, high) = self.range();
        // days since 1900, as worksheets write them, of 2009 and later
        let days = low > 40_000.0 && high < 80_000.0 && step < 2e-3;
        let others = ["min", "minutes", "h", "hours", "d", "days", "tick", "ticks", "frame", "frames"];
        let other = self.heading.words.iter().any(|word| others.contains(&word.as_str()));
        step < 1.0 && !self.is_whole() && !days && !other
    }

    /// `true` if no value is smaller than the one before, and the last exceeds the first.
    pub fn is_ordered(&self) -> bool {
        let values: Vec<f64> = self.numbers().collect();
        values.len() > 1 && values.windows(2).all(|pair| pair[1] >= pair[0]) && values[0] < values[values.len() - 1]
    }

    /// `true` if all values are equal.
    pub fn is_constant(&self) -> bool {
        let (low, high) = self.range();
        self.is_numeric() && low == high
    }
}
