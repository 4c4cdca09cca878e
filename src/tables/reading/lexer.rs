//! Delimited text: one scanner without copies. A campaign reads rows of fields, each with its
//! place; clouds of points take labels and numbers directly from the scanner. Lines are also
//! written here.

use crate::{Decimal, Delimiter, Form, Thousands};
use etalon_base::message::{Message, Place, Problems};
use etalon_base::pose_name::PoseName;
use etalon_base::{error, phrase};
use std::borrow::Cow;

/// A row of fields, which borrow from its line.
#[derive(Clone, Debug, PartialEq)]
pub struct Row<'t> {
    /// Line in the file, from 1.
    pub line: usize,
    /// Number among the data rows, from 1; 0 before the data.
    pub number: usize,
    /// Text of the line before it is split.
    pub text: &'t str,
    /// The fields.
    pub fields: Vec<Cow<'t, str>>,
}

impl<'t> Row<'t> {
    /// A row whose fields are already cut.
    pub fn new(line: usize, text: &'t str, fields: impl Iterator<Item = &'t str>) -> Self {
        Self { line, number: 0, text, fields: fields.map(Cow::Borrowed).collect() }
    }

    /// Returns the field of this index; empty beyond the last field.
    pub fn field(&self, index: usize) -> &str {
        self.fields.get(index).map_or("", Cow::as_ref)
    }

    /// `true` if the row has this word alone, in its first field.
    pub fn ends(&self, word: &str) -> bool {
        self.field(0) == word && self.fields[1..].iter().all(|field| field.is_empty())
    }

    /// Its line.
    pub fn place(&self, file: &str) -> Place {
        Place::line(file, self.line, self.text)
    }

    /// Returns the place of the field of this index.
    pub fn cell(&self, file: &str, index: usize) -> Place {
        let mut from = 0;
        let mut column = 1;
        for field in self.fields.iter().take(index + 1) {
            // a field with doubled quotes is not in the line as it reads
            let at = self.text[from..].find(field.as_ref()).map(|byte| from + byte);
            column = self.text[..at.unwrap_or(from)].chars().count() + 1;
            from = at.map_or(from, |at| at + field.len());
        }
        let width = self.fields.get(index).map_or(1, |f| f.chars().count());
        self.place(file).at(if index < self.fields.len() { column } else { 1 }, width)
    }
}

/// Index of a column by its heading, or by `$3`.
pub fn column_index(name: &str, header: Option<&Row>) -> std::result::Result<usize, Message> {
    let by_heading = header.and_then(|row| row.fields.iter().position(|field| field.trim() == name));
    let by_number = || name.strip_prefix('$')?.parse::<usize>().ok()?.checked_sub(1);
    by_heading.or_else(by_number).ok_or_else(|| {
        let names = header.map(|row| row.fields.iter().map(AsRef::as_ref).collect::<Vec<&str>>()).unwrap_or_default();
        error!("column-unknown", column = name).hint_names(name, names)
    })
}

/// Rows of a text in a form, with the errors of rows that cannot be split. Empty lines and
/// comments are not rows.
pub fn split<'t>(file: &str, text: &'t str, form: &Form) -> (Vec<Row<'t>>, Problems) {
    let mut problems = Problems::default();
    let rows = each_row(file, text, form).filter_map(|row| row.map_err(|message| problems.0.push(message)).ok());
    (rows.collect(), problems)
}

/// Rows of a text one after the other: all rows together would need several times the memory of the
/// text.
pub fn each_row<'t>(
    file: &str,
    text: &'t str,
    form: &Form,
) -> impl Iterator<Item = std::result::Result<Row<'t>, Message>> {
    lines(text, form).map(|(number, line)| row(file, number, line, form))
}

/// Lines with their numbers, from 1; empty lines and comments are omitted.
pub fn lines<'t>(text: &'t str, form: &Form) -> impl Iterator<Item = (usize, &'t str)> + Clone {
    let is_comment = |line: &str| form.comment.as_ref().is_some_and(|c| line.trim_start().starts_with(c.as_str()));
    let is_blank = |line: &str| match line.as_bytes().first() {
        Some(b'!'..0x80) => false,
        _ => line.trim().is_empty(),
    };
    let is_row = move |(_, line): &(usize, &str)| !is_blank(line) && !is_comment(line);
    let delimiter = form.delimiter().byte().filter(|_| form.widths.is_empty());
    Lines { rest: text, number: 0, delimiter, comment: form.comment.as_deref() }.filter(is_row)
}

/// Lines of a text with their numbers; a line break within quotation marks belongs to its cell.
#[derive(Clone)]
struct Lines<'t, 'f> {
    rest: &'t str,
    /// Number of the last line that was passed.
    number: usize,
    /// None: blanks, beside which a quotation mark is a part of a word.
    delimiter: Option<u8>,
    comment: Option<&'f str>,
}

impl<'t> Iterator for Lines<'t, '_> {
    type Item = (usize, &'t str);

    fn next(&mut self) -> Option<Self::Item> {
        if self.rest.is_empty() {
            return None;
        }
        let number = self.number + 1;
        let mut end = self.rest.find('\n').unwrap_or(self.rest.len());
        let is_comment = || self.comment.is_some_and(|mark| self.rest.trim_start().starts_with(mark));
        let has_quote = || self.rest.as_bytes()[..end].contains(&b'"') && !is_comment();
        if let Some(delimiter) = self.delimiter.filter(|_| has_quote())
            && let Some(far) = end_of_row(self.rest.as_bytes(), delimiter).filter(|far| *far > end)
        {
            self.number += self.rest.as_bytes()[end..far].iter().filter(|byte| **byte == b'\n').count();
            end = far;
        }
        self.number += 1;
        let (line, rest) = self.rest.split_at(end);
        self.rest = rest.strip_prefix('\n').unwrap_or(rest);
        // as `str::lines` does
        let line = if rest.is_empty() { line } else { line.strip_suffix('\r').unwrap_or(line) };
        Some((number, line))
    }
}

/// Maximum number of lines of a cell in quotation marks.
const MOST_LINES: usize = 50;

/// Index of the end of the first row, whose quoted cells may contain line breaks; `None` if a
/// quotation mark is not closed, or other text than a delimiter follows it.
fn end_of_row(bytes: &[u8], delimiter: u8) -> Option<usize> {
    let (mut at, mut breaks) = (0, 0);
    let skip_blanks = |mut at: usize| {
        while matches!(bytes.get(at), Some(b' ' | b'\t' | b'\r')) && bytes[at] != delimiter {
            at += 1;
        }
        at
    };
    loop {
        at = skip_blanks(at);
        if bytes.get(at) == Some(&b'"') {
            loop {
                at += 1;
                match *bytes.get(at)? {
                    b'"' if bytes.get(at + 1) == Some(&b'"') => at += 1,
                    b'"' => break,
                    b'\n' if breaks == MOST_LINES => return None,
                    b'\n' => breaks += 1,
                    _ => {}
                }
            }
            at = skip_blanks(at + 1);
        } else {
            at += bytes[at..].iter().take_while(|byte| **byte != delimiter && **byte != b'\n').count();
        }
        match bytes.get(at) {
            None | Some(b'\n') => return Some(at),
            Some(byte) if *byte == delimiter => at += 1,
            Some(_) => return None,
        }
    }
}

/// The fields of a line.
pub fn row<'t>(file: &str, number: usize, line: &'t str, form: &Form) -> std::result::Result<Row<'t>, Message> {
    let mut row = Row { line: number, number: 0, text: line, fields: Vec::new() };
    if line.contains('\n') {
        // a cell of several lines
        row.text = line.lines().next().unwrap_or_default();
        let (plain, mut cells) = (line.replace("\r\n", " ").replace('\n', " "), Vec::new());
        if fields(&plain, form.delimiter(), &mut cells).is_err() {
            return Err(error!("quote-unmatched", fault = "open").at(row.place(file)));
        }
        row.fields = cells.into_iter().map(|cell| Cow::Owned(cell.into_owned())).collect();
    } else if !form.widths.is_empty() {
        row.fields = fixed(line, &form.widths);
    } else if let Err(stray) = fields(line, form.delimiter(), &mut row.fields) {
        let column = line[..stray.at].chars().count() + 1;
        return Err(error!("quote-unmatched", fault = stray.fault).at(row.place(file).at(column, 1)));
    }
    Ok(row)
}

/// Fields of these widths (characters); the rest of the line is one more field.
fn fixed<'t>(line: &'t str, widths: &[usize]) -> Vec<Cow<'t, str>> {
    let mut rest = line;
    let mut take = |width: usize| {
        let end = rest.char_indices().nth(width).map_or(rest.len(), |(i, _)| i);
        let (field, after) = rest.split_at(end);
        rest = after;
        Cow::Borrowed(field.trim())
    };
    let mut fields: Vec<Cow<str>> = widths.iter().map(|width| take(*width)).collect();
    let behind = take(usize::MAX);
    if !behind.is_empty() {
        fields.push(behind);
    }
    fields
}

/// The fields of a line; a field in double quotes may contain separators.
fn fields<'t>(line: &'t str, delimiter: Delimiter, fields: &mut Vec<Cow<'t, str>>) -> std::result::Result<(), Stray> {
    let mut scanner = Scanner { bytes: line.as_bytes(), at: 0, delimiter: delimiter.byte() };
    loop {
        let cell = scanner.cell()?;
        let text = line.get(cell.start..cell.end).unwrap_or_default();
        fields.push(match (cell.quoted, delimiter) {
            (false, _) | (true, Delimiter::Blank) => Cow::Borrowed(text),
            (true, _) if text.contains('"') => Cow::Owned(text.replace("\"\"", "\"").trim().to_owned()),
            (true, _) => Cow::Borrowed(text.trim()),
        });
        if cell.last {
            return Ok(());
        }
    }
}

/// Content of a column of a plain line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PlainColumn {
    /// Column that is not read.
    Skipped,
    /// Label of the point.
    Label,
    /// Coordinate of this index.
    Coordinate(usize),
}

/// Returns label and coordinates of a line that has just these columns, each coordinate a number of
/// digits and a mark: most lines of an export are plain. `None` for any other line, which the
/// reader of rows takes.
pub fn plain_line<'t>(
    line: &'t str,
    delimiter: Delimiter,
    decimal: Decimal,
    columns: &[PlainColumn],
) -> Option<(&'t str, [f64; 3])> {
    let read = columns.iter().rposition(|column| *column != PlainColumn::Skipped).map_or(0, |last| last + 1);
    let mut scanner = Scanner { bytes: line.as_bytes(), at: 0, delimiter: delimiter.byte() };
    let (mut label, mut coordinates) = ("", [0.0; 3]);
    for (i, column) in columns[..read].iter().enumerate() {
        if let PlainColumn::Coordinate(at) = column {
            scanner.skip_blanks();
            coordinates[*at] = scanner.exact(decimal.byte())?;
            if !scanner.separator() {
                return None;
            }
            continue;
        }
        let may_be_last = |cell: &Cell| i + 1 == read && cell.start < cell.end;
        let cell = scanner.cell().ok().filter(|cell| !cell.quoted && (!cell.last || may_be_last(cell)))?;
        if *column == PlainColumn::Label {
            label = line.get(cell.start..cell.end)?;
        }
    }
    scanner.pass_rest(columns.len() - read)?;
    scanner.is_end().then_some((label, coordinates))
}

/// Whole numbers up to here are exact.
pub const WHOLE: f64 = 9e15;

/// Maximum length of a number (characters): the smallest double written out is shorter.
const LONGEST: usize = 1100;

/// A number in the given decimal mark, without other text.
pub fn number(field: &str, decimal: Decimal) -> std::result::Result<f64, Message> {
    marked(field, decimal, None)
}

/// Name of a pose. A text of digits and a decimal mark alone (`7`, `7.0`) is a number, and must be
/// whole.
pub fn pose_name(field: &str, decimal: Decimal) -> std::result::Result<PoseName, Message> {
    let numeric = |c: char| c.is_ascii_digit() || matches!(c, '+' | '-' | '.' | ',' | '\u{2212}');
    match number(field, decimal) {
        Ok(value) if value.fract() != 0.0 || value.abs() > WHOLE => {
            Err(error!("not-whole-number", value = field, column = "pose").expected(phrase!("pose-number-or-name")))
        }
        Ok(value) if field.chars().all(numeric) => Ok((value as i64).into()),
        // of letters as well, like `3E1`
        _ => PoseName::new(field),
    }
}

/// Reads a number in the given decimal and thousands marks, correctly rounded. Exponents may be
/// `e+003`, `E001` or Fortran's `D+01`; the minus may be U+2212.
pub fn marked(field: &str, decimal: Decimal, thousands: Option<Thousands>) -> std::result::Result<f64, Message> {
    if field.len() > LONGEST {
        let start: String = field.chars().take(40).collect();
        return Err(error!("number-too-long", start, characters = field.len(), most = LONGEST));
    }
    parsed(field, decimal, thousands).ok_or_else(|| wrong(field, decimal, thousands))
}

/// A finite number in the given marks; `None` for any other text.
pub fn parsed(field: &str, decimal: Decimal, thousands: Option<Thousands>) -> Option<f64> {
    if field.len() > LONGEST {
        return None;
    }
    let mut scanner = Scanner { bytes: field.as_bytes(), at: 0, delimiter: None };
    let exact = scanner.exact(decimal.byte()).filter(|_| thousands.is_none() && scanner.at == field.len());
    let value = exact.or_else(|| unmarked(field, decimal, thousands)?.parse().ok());
    value.filter(|v: &f64| v.is_finite())
}

/// The number as Rust reads it, if it has no characters but its marks, digits and an exponent.
fn unmarked(field: &str, decimal: Decimal, thousands: Option<Thousands>) -> Option<String> {
    let mark = if decimal == Decimal::Point { '.' } else { ',' };
    let (whole, rest) = field.split_at(field.find([mark, 'e', 'E', 'd', 'D']).unwrap_or(field.len()));
    let whole = match thousands {
        Some(thousands) => ungrouped(whole, thousands)?,
        None => whole.to_owned(),
    };
    let plain = |c: char| match c {
        '\u{2212}' => Some('-'),
        'd' | 'D' => Some('e'),
        c if c == mark => Some('.'),
        // words that `parse` would take for infinity or NaN are not measured values
        '0'..='9' | '+' | '-' | 'e' | 'E' => Some(c),
        _ => None,
    };
    whole.chars().chain(rest.chars()).map(plain).collect()
}

/// The whole part without its marks, which must stand between groups of three digits.
fn ungrouped(whole: &str, thousands: Thousands) -> Option<String> {
    let mut groups = whole.split(|c| thousands.is(c));
    let first = groups.next()?;
    let rest: Vec<&str> = groups.collect();
    let digits = |text: &str| text.bytes().filter(u8::is_ascii_digit).count();
    let three = |group: &&str| group.len() == 3 && digits(group) == 3;
    let grouped = rest.iter().all(three) && (rest.is_empty() || matches!(digits(first), 1..=3));
    grouped.then(|| [&[first], &rest[..]].concat().concat())
}

fn wrong(field: &str, decimal: Decimal, thousands: Option<Thousands>) -> Message {
    let stated = thousands.map_or("none", Thousands::name);
    if field.is_empty() {
        return error!("number-empty", decimal = decimal.name(), thousands = stated);
    }
    let message = error!("not-a-number", text = field, decimal = decimal.name(), thousands = stated);
    if field.starts_with('=') {
        return message.hint(phrase!("save-computed-workbook"));
    }
    if thousands.is_some() {
        return message;
    }
    let other = if decimal == Decimal::Point { "," } else { "." };
    let decimal_mark = field.contains(other).then(|| format!("`decimal = \"{other}\"`"));
    let all = [Thousands::Comma, Thousands::Point, Thousands::Apostrophe, Thousands::Blank];
    let marks = all.into_iter().filter(|mark| mark.name() != decimal.name() && field.contains(|c| mark.is(c)));
    let grouped = marks.filter(|mark| parsed(field, decimal, Some(*mark)).is_some());
    let marks = decimal_mark.into_iter().chain(grouped.map(|mark| format!("`thousands = \"{}\"`", mark.name())));
    match &marks.collect::<Vec<_>>()[..] {
        [] => message,
        [first] => message.hint(phrase!("number-marks", first, second = "none")),
        [first, second, ..] => message.hint(phrase!("number-marks", first, second)),
    }
}

/// Maximum length of a line of a cloud of points.
pub const LONGEST_LINE: usize = 4096;
/// Powers of ten that are exact.
const TENS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20,
    1e21, 1e22,
];

const WHOLE_TENS: [u64; 9] = [1, 10, 100, 1_000, 10_000, 100_000, 1_000_000, 10_000_000, 100_000_000];

/// Scanner of delimited text: takes cells and numbers of a line one after the other.
pub struct Scanner<'a> {
    /// Text.
    pub bytes: &'a [u8],
    /// Index of the next byte.
    pub at: usize,
    /// None: blanks and tabs.
    pub delimiter: Option<u8>,
}

/// Place of the text of a cell.
struct Cell {
    start: usize,
    end: usize,
    /// In double quotes, which are not part of it; a quote within it may be doubled.
    quoted: bool,
    /// `true` for the last cell of its line.
    last: bool,
}

/// Unmatched quote of a line.
struct Stray {
    /// `open` or `behind`: see the message `quote-unmatched`.
    fault: &'static str,
    /// Position in the line (bytes).
    at: usize,
}

impl<'a> Scanner<'a> {
    #[inline(always)]
    fn peek(&self) -> Option<u8> {
        self.bytes.get(self.at).copied()
    }

    /// Returns the length of the blank at this place (bytes), or 0. Delimiters and line ends are
    /// not blanks.
    #[inline(always)]
    fn blank(&self) -> usize {
        match self.peek() {
            Some(b' ') => 1,
            Some(b'!'..0x80) | None => 0,
            Some(b'\t' | 0x0b | 0x0c) => usize::from(self.peek() != self.delimiter),
            Some(0x80..) => self.wide_blank(),
            Some(_) => 0,
        }
    }

    /// Length of a blank outside ASCII (bytes), or 0.
    #[cold]
    fn wide_blank(&self) -> usize {
        let four = &self.bytes[self.at..self.bytes.len().min(self.at + 4)];
        let first = four.utf8_chunks().next().and_then(|chunk| chunk.valid().chars().next());
        first.filter(|c| c.is_whitespace()).map_or(0, char::len_utf8)
    }

    #[inline(always)]
    fn skip_blanks(&mut self) {
        loop {
            match self.blank() {
                0 => return,
                width => self.at += width,
            }
        }
    }

    /// `true` at the end of the line; a carriage return alone does not end a line.
    #[inline(always)]
    fn is_end(&self) -> bool {
        match self.peek() {
            None | Some(b'\n') => true,
            Some(b'\r') => matches!(self.bytes.get(self.at + 1), None | Some(b'\n')),
            _ => false,
        }
    }

    /// Passes the separator at this place; `true` also at the end of the line.
    #[inline(always)]
    fn separator(&mut self) -> bool {
        match self.delimiter {
            Some(_) => {
                self.skip_blanks();
                let here = self.peek() == self.delimiter;
                self.at += usize::from(here);
                here || self.is_end()
            }
            None => self.blank() > 0 || self.is_end(),
        }
    }

    /// The next cell, without blanks around it, and its separator from the next cell.
    fn cell(&mut self) -> std::result::Result<Cell, Stray> {
        self.skip_blanks();
        let mut cell = Cell { start: self.at, end: self.at, quoted: false, last: false };
        match if self.peek() == Some(b'"') { self.quoted()? } else { None } {
            Some(end) => {
                cell = Cell { start: self.at + 1, end, quoted: true, last: false };
                self.at = end + 1;
            }
            None => {
                while !self.is_end() && self.peek() != self.delimiter {
                    match self.blank() {
                        0 => {
                            self.at += 1;
                            cell.end = self.at;
                        }
                        _ if self.delimiter.is_none() => break,
                        width => self.at += width,
                    }
                }
            }
        }
        self.skip_blanks();
        cell.last = self.is_end();
        if self.delimiter.is_some() && !cell.last {
            if self.peek() != self.delimiter {
                return Err(Stray { fault: "behind", at: self.at });
            }
            self.at += 1;
        }
        Ok(cell)
    }

    /// Place of the closing quote. If blanks separate fields, an unclosed quote is part of a word.
    fn quoted(&self) -> std::result::Result<Option<usize>, Stray> {
        let mut end = self.at + 1;
        loop {
            match self.bytes[end..].iter().position(|b| matches!(b, b'"' | b'\n')) {
                Some(count) if self.bytes[end + count] == b'"' => end += count,
                _ if self.delimiter.is_none() => return Ok(None),
                _ => return Err(Stray { fault: "open", at: self.at }),
            }
            if self.delimiter.is_none() || self.bytes.get(end + 1) != Some(&b'"') {
                return Ok(Some(end));
            }
            end += 2;
        }
    }

    /// The label, and its separator from the next field; `None` if it may need the slower reader.
    #[inline]
    pub fn label(&mut self) -> Option<&'a [u8]> {
        self.skip_blanks();
        self.short_label().or_else(|| {
            let cell = self.cell().ok()?;
            let label = &self.bytes[cell.start..cell.end];
            // byte-order marks, NULs and carriage returns are left to the strict reader
            let plain = !cell.quoted && !label.starts_with(b"\xef\xbb\xbf");
            (plain && !label.iter().any(|b| matches!(b, 0 | b'\r'))).then_some(label)
        })
    }

    /// A label of fewer than sixteen ASCII letters directly before its separator.
    #[inline]
    fn short_label(&mut self) -> Option<&'a [u8]> {
        let rest = &self.bytes[self.at..];
        let separator = self.delimiter.unwrap_or(b' ');
        let [first, second] =
            [0, 8].map(|from| rest.get(from..)?.first_chunk().map(|word| first_stop(*word, separator)));
        let length = match first? {
            8 => 8 + second?,
            length => length,
        };
        let plain = !matches!(rest.first(), None | Some(b'"')) && (1..16).contains(&length);
        if !plain || rest.get(length) != Some(&separator) {
            return None;
        }
        self.at += length + usize::from(self.delimiter.is_some());
        Some(&rest[..length])
    }

    /// Appends digits to `value` and returns their number; with more than 19 the value is lost.
    #[inline(always)]
    fn digits(&mut self, mut value: u64) -> (u64, usize) {
        let start = self.at;
        loop {
            let (more, count) = eight(&self.bytes[self.at..]);
            value = value.wrapping_mul(WHOLE_TENS[count]).wrapping_add(more);
            self.at += count;
            if count < 8 {
                return (value, self.at - start);
            }
        }
    }

    /// A number of digits and a mark, if it is exact or one rounding away from that.
    #[inline(always)]
    fn exact(&mut self, mark: u8) -> Option<f64> {
        let negative = self.peek() == Some(b'-');
        self.at += usize::from(negative);
        let (whole, before) = self.digits(0);
        let (mantissa, behind) = match self.peek() == Some(mark) {
            true => {
                self.at += 1;
                self.digits(whole)
            }
            false => (whole, 0),
        };
        // both operands are exact
        // (W. D. Clinger, How to read floating point numbers accurately, 1990)
        ((1..=19).contains(&(before + behind)) && mantissa <= 1 << 53).then(|| {
            let value = mantissa as f64 / TENS[behind];
            // the sign is unpredictable, so this is branch-free
            f64::from_bits(value.to_bits() | u64::from(negative) << 63)
        })
    }

    /// A number, and its separator from the next field, if any.
    #[inline(always)]
    pub fn number(&mut self, decimal: Decimal) -> Option<f64> {
        self.skip_blanks();
        let start = self.at;
        match self.exact(decimal.byte()) {
            Some(value) if self.separator() => Some(value),
            _ => {
                self.at = start;
                self.any_number(decimal)
            }
        }
    }

    /// Reads any number and its separator.
    fn any_number(&mut self, decimal: Decimal) -> Option<f64> {
        let cell = self.cell().ok()?;
        parsed(std::str::from_utf8(&self.bytes[cell.start..cell.end]).ok()?, decimal, None)
    }

    /// Passes cells that are not read; `None` if no further cell follows them.
    pub fn pass(&mut self, count: usize) -> Option<()> {
        (0..count).try_for_each(|_| self.cell().ok().filter(|cell| !cell.last).map(|_| ()))
    }

    /// Passes the cells up to the end of the line; `None` if more than `most` of them are filled.
    pub fn pass_rest(&mut self, most: usize) -> Option<()> {
        self.skip_blanks();
        let mut passed = 0;
        while !self.is_end() {
            let cell = self.cell().ok()?;
            passed += 1;
            if passed > most && (cell.start < cell.end || cell.quoted) {
                return None;
            }
        }
        Some(())
    }

    /// Passes the end of the line; `false` before other text. Without a line feed, a line ends only
    /// at the end of the file (`last`).
    pub fn end(&mut self, last: bool) -> bool {
        self.skip_blanks();
        if !self.is_end() {
            return false;
        }
        self.at += usize::from(self.peek() == Some(b'\r'));
        let ends = self.peek().is_some() || last;
        self.at += usize::from(self.peek().is_some());
        ends
    }
}

/// Line feeds in a text: counted in bytes, which take an eighth of the registers that words would.
#[inline(always)]
pub fn line_feeds(text: &[u8]) -> usize {
    // at most 255: a check of each sum would keep the loop from the vector registers
    let few = |bytes: &[u8]| bytes.iter().fold(0u8, |count, b| count.wrapping_add(u8::from(*b == b'\n')));
    text.chunks(255).map(|bytes| usize::from(few(bytes))).sum()
}

/// Bytes in front of the first separator, blank, control character or letter beyond ASCII.
#[inline(always)]
fn first_stop(word: [u8; 8], separator: u8) -> usize {
    let ones = u64::from_le_bytes([1; 8]);
    let high = ones << 7;
    let word = u64::from_le_bytes(word);
    let parted = word ^ (ones * u64::from(separator));
    // correct up to the first stop; borrows may mark bytes behind it
    let stops = (word.wrapping_sub(ones * 0x21) | word | parted.wrapping_sub(ones) & !parted) & high;
    (stops.trailing_zeros() / 8) as usize
}

/// Number of up to eight leading digits, and their count: all bytes of a word at once
/// (D. Lemire, Number parsing at a gigabyte per second, Software: Practice and Experience 51,
/// 2021).
#[inline(always)]
fn eight(bytes: &[u8]) -> (u64, usize) {
    let word = match bytes.first_chunk() {
        Some(word) => *word,
        None => std::array::from_fn(|i| bytes.get(i).copied().unwrap_or_default()),
    };
    // digits become 0 to 9; carries may mark bytes behind the first other character
    let word = u64::from_le_bytes(word) ^ 0x3030_3030_3030_3030;
    let other = (word.wrapping_add(0x7676_7676_7676_7676) | word) & 0x8080_8080_8080_8080;
    let count = other.trailing_zeros() / 8;
    if count == 0 {
        return (0, 0);
    }
    let digits = word << (64 - 8 * count);
    let pairs = digits.wrapping_mul(10).wrapping_add(digits >> 8) & 0x00ff_00ff_00ff_00ff;
    let fours = pairs.wrapping_mul(100).wrapping_add(pairs >> 16) & 0x0000_ffff_0000_ffff;
    let all = fours.wrapping_mul(10_000).wrapping_add(fours >> 32) & 0xffff_ffff;
    (all, count as usize)
}

/// One line; if it would be read as a comment, its first field is quoted.
pub fn line(fields: &[String], delimiter: Delimiter, comment: Option<&str>) -> std::result::Result<String, Message> {
    let joined = |quote_first: bool| {
        let field = |(i, field): (usize, &String)| match delimiter.byte() {
            Some(byte) => quoted_between(field, char::from(byte), quote_first && i == 0),
            None => blank(field, quote_first && i == 0),
        };
        let separator = delimiter.byte().map_or(' ', char::from).to_string();
        fields.iter().enumerate().map(field).collect::<Vec<_>>().join(&separator) + "\n"
    };
    let is_comment = |text: &str| comment.is_some_and(|c| text.trim_start().starts_with(c));
    let text = joined(false);
    if !is_comment(&text) {
        return Ok(text);
    }
    let quoted = joined(true);
    if is_comment(&quoted) {
        return Err(error!("row-is-comment", row = text.trim_end()));
    }
    Ok(quoted)
}

/// A field between separators.
fn quoted_between(field: &str, separator: char, quote: bool) -> String {
    if quote || field.contains([separator, '"', '\n', '\r']) || field.trim() != field {
        format!("\"{}\"", field.replace('"', "\"\""))
    } else {
        field.to_owned()
    }
}

/// A field between blanks.
pub fn blank(field: &str, quote: bool) -> String {
    if quote || field.is_empty() || field.contains(char::is_whitespace) {
        format!("\"{field}\"")
    } else {
        field.to_owned()
    }
}

/// A number with all its digits and the given decimal mark.
pub fn written_out(value: f64, decimal: Decimal) -> String {
    let text = value.to_string();
    if decimal == Decimal::Comma { text.replace('.', ",") } else { text }
}

/// A number with the given decimal mark.
pub fn written(value: f64, digits: usize, decimal: Decimal) -> String {
    let text = format!("{value:.digits$}");
    if decimal == Decimal::Comma { text.replace('.', ",") } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_same_rows_in_every_delimiter() {
        let expected = ["P 1", "1.5", "-2"];
        for (text, delimiter) in [
            ("# head\n\"P 1\"  1.5\t-2\n\n", Delimiter::Blank),
            ("# head\nP 1\t1.5\t-2\r\n", Delimiter::Tab),
            ("# head\nP 1, 1.5,-2\n", Delimiter::Comma),
            ("# head\nP 1;1.5;-2", Delimiter::Semicolon),
            ("# \"head\n\"P 1\" | 1.5|\"-2\"", Delimiter::Bar),
        ] {
            let comment = Some("#".to_owned());
            let (rows, problems) = split("f", text, &Form { delimiter: Some(delimiter), comment, ..Form::default() });
            let found: Vec<_> = rows.iter().map(|row| (row.line, &row.fields[..])).collect();
            assert!(problems.0.is_empty() && found == [(2, &expected.map(Cow::from)[..])], "{delimiter:?}: {rows:?}");
            let borrowed = |row: &Row| row.fields.iter().all(|f| matches!(f, Cow::Borrowed(_)));
            assert!(rows.iter().all(borrowed), "{rows:?}");
        }
    }

    #[test]
    fn quotes_that_do_not_match_are_reported_on_their_line_and_hide_no_row() {
        let form = Form::default();
        let (rows, problems) = split("f", "\"a,1\n\"b \"\"c\"\"\",2\n\"d\" e,3\n1.5\" ball,4\n", &form);
        let lines: Vec<_> = problems.0.iter().map(|m| m.place.as_ref().map(|p| (p.line, p.column))).collect();
        assert_eq!(lines, [Some((Some(1), Some(1))), Some((Some(3), Some(5)))]);
        let fields: Vec<&str> = rows.iter().flat_map(|r| &r.fields).map(Cow::as_ref).collect();
        assert_eq!(fields, ["b \"c\"", "2", "1.5\" ball", "4"]);
    }

    #[test]
    fn a_line_break_within_quotation_marks_belongs_to_its_cell() {
        let form = Form { comment: Some("#".to_owned()), ..Form::default() };
        let text = "# a \"b\nName,\"X\r\n[mm]\"\r\n\"P \"\"1\"\"\n\nleft\",1.5\nP2,2.5\n\"open,3.5\nP4,4.5\n";
        let (rows, problems) = split("f", text, &form);
        let found: Vec<(usize, Vec<&str>)> =
            rows.iter().map(|row| (row.line, row.fields.iter().map(AsRef::as_ref).collect())).collect();
        let expected = [
            (2, vec!["Name", "X [mm]"]),
            (4, vec!["P \"1\"  left", "1.5"]),
            (7, vec!["P2", "2.5"]),
            (9, vec!["P4", "4.5"]),
        ];
        assert_eq!(found, expected);
        assert!(problems.0.len() == 1 && problems.0[0].is("quote-unmatched", &[("fault", &"open")]), "{problems}");
        // words that blanks divide may contain a quotation mark
        let blanks = Form { delimiter: Some(Delimiter::Blank), ..form };
        assert_eq!(split("f", "\"P1 1.5\nP2 \"2.5\n", &blanks).0.len(), 2);
        // lines without quotation marks end as those of `str::lines`
        for text in ["", "\n", "a\r\n\nb\r", "a\nb\n", "\r\n"] {
            let plain: Vec<&str> = text.lines().filter(|line| !line.trim().is_empty()).collect();
            assert_eq!(lines(text, &Form::default()).map(|(_, line)| line).collect::<Vec<_>>(), plain, "{text:?}");
        }
    }

    #[test]
    fn fixed_widths_count_characters() {
        assert_eq!(fixed("µ 1  2.5 rest", &[3, 5]), ["µ 1", "2.5", "rest"]);
        assert_eq!(fixed("ab", &[1, 3, 2]), ["a", "b", ""]);
    }

    #[test]
    fn eight_takes_the_digits_in_front_whatever_follows() {
        for digits in ["", "0", "7", "09", "123", "0045", "99999", "123456", "9876543", "98765432", "00000001"] {
            for behind in ["", ".", " 5", "/", ":", "\u{e9}", "\0", "\n12", "a1234567", "\u{10ffff}99999"] {
                let text = format!("{digits}{behind}");
                let expected = (digits.parse().unwrap_or(0), digits.len());
                assert_eq!(eight(text.as_bytes()), expected, "{text:?}");
            }
        }
        assert_eq!(eight(b"1234567890"), (12_345_678, 8));
    }

    #[test]
    fn poses_are_whole_numbers_or_names() {
        for (field, number) in [("12", 12), ("012", 12), ("12.0", 12), ("-1", -1)] {
            assert_eq!(pose_name(field, Decimal::Point).unwrap(), number);
        }
        assert_eq!(pose_name("7,0", Decimal::Comma).unwrap(), 7);
        for name in ["home", "P1", "P1a", "3E1", "10b"] {
            assert_eq!(pose_name(name, Decimal::Point).unwrap().to_string(), name);
        }
        for wrong in ["1.5", "1e300", "99999999999999999999", "", "=A1"] {
            assert!(pose_name(wrong, Decimal::Point).is_err(), "{wrong}");
        }
    }

    #[test]
    fn numbers_are_read_strictly() {
        assert_eq!(number("1,25", Decimal::Comma).unwrap(), 1.25);
        for (field, decimal) in [
            ("1,25", Decimal::Point),
            ("1.25", Decimal::Comma),
            ("nan", Decimal::Point),
            ("inf", Decimal::Point),
            ("1 000", Decimal::Point),
            ("", Decimal::Point),
            ("1.2.3", Decimal::Point),
            ("1,2,3", Decimal::Comma),
            ("1e999", Decimal::Point),
            ("±2.000", Decimal::Point),
            ("d5", Decimal::Point),
            ("0x1p3", Decimal::Point),
        ] {
            assert!(number(field, decimal).is_err(), "{field}");
        }
    }

    #[test]
    fn endless_digits_are_not_a_number_and_take_no_time() {
        let begun = std::time::Instant::now();
        let error = number(&"7".repeat(50_000_000), Decimal::Point).unwrap_err();
        assert!(error.is("number-too-long", &[("characters", &50_000_000)]), "{error}");
        assert!(error.to_string().len() < 300, "{error}");
        assert!(begun.elapsed().as_secs() < 60);
        let smallest = format!("{}", f64::from_bits(1));
        assert_eq!(number(&smallest, Decimal::Point).unwrap().to_bits(), 1);
    }

    #[test]
    fn trap_5_exponents_and_trap_6_unicode_minus() {
        for (field, value) in [
            ("-1.5e+003", -1500.0),
            ("-4.30052E001", -43.0052),
            ("1.5D+01", 15.0),
            ("1.5d-2", 0.015),
            ("\u{2212}2.5", -2.5),
            ("0.", 0.0),
            ("-.5E0", -0.5),
        ] {
            assert_eq!(number(field, Decimal::Point).unwrap().to_bits(), f64::to_bits(value), "{field}");
        }
    }

    #[test]
    fn trap_4_thousands_only_between_groups_of_three() {
        use Thousands::*;
        let (point, comma) = (Decimal::Point, Decimal::Comma);
        for (field, decimal, mark) in [
            ("1,234.5", point, Comma),
            ("1.234,5", comma, Point),
            ("1'234.5", point, Apostrophe),
            ("1 234,5", comma, Blank),
            ("1\u{a0}234.5", point, Blank),
            ("1\u{202f}234.5", point, Blank),
            ("1234.5", point, Comma),
        ] {
            assert_eq!(marked(field, decimal, Some(mark)).unwrap(), 1234.5, "{field}");
        }
        for (field, decimal, mark) in [
            ("1,23.5", point, Comma),
            (",234.5", point, Comma),
            ("1234,567.0", point, Comma),
            ("1.234,5", comma, Comma),
            ("1,234.5,6", point, Comma),
        ] {
            assert!(marked(field, decimal, Some(mark)).is_err(), "{field}");
        }
        let error = number("3 000", point).unwrap_err();
        let hint = phrase!("number-marks", first = "`thousands = \" \"`", second = "none");
        assert!(error.is("not-a-number", &[("text", &"3 000"), ("hint", &hint)]), "{error}");
        // a decimal comma or groups of three digits
        let hint = phrase!("number-marks", first = "`decimal = \",\"`", second = "`thousands = \",\"`");
        assert!(number("3,000", point).unwrap_err().is("not-a-number", &[("hint", &hint)]));
        assert_eq!(number("x", point).unwrap_err().hint, None);
    }
}
