//! Rows of a table in its form. Every reader of a table takes them from here: header, columns,
//! filters and numbers have one meaning in exports, logs and tables.

use crate::filter::{Filter, no_row_selected};
use crate::guess::{guesses, two_commas_in};
use crate::lexer::{self, Row, WHOLE, marked, parsed};
use crate::{ColumnSource, Decimal, Delimiter, Expression, Form, Header};
use etalon_base::catalogue::Phrase;
use etalon_base::message::{Message, Place, Problems, Result};
use etalon_base::{error, phrase};
use std::borrow::Cow;
use std::result;

/// Row that is omitted, and why.
#[derive(Clone, Debug)]
pub struct LeftOut<'t> {
    /// The row.
    pub row: Row<'t>,
    /// Reason for leaving it out.
    pub reason: Phrase,
}

/// Data rows of a text, below the row that names their columns.
pub struct Sheet<'t> {
    /// Name of the file, for places.
    pub file: &'t str,
    /// Form of the text.
    pub form: &'t Form,
    /// Row that names the columns.
    pub header: Option<Row<'t>>,
    /// Rows that are read, each with its number among the data rows, from 1.
    pub rows: Vec<Row<'t>>,
}

impl<'t> Sheet<'t> {
    /// Splits a text into header and data rows; of these, each has its number.
    ///
    /// # Errors
    /// Marks with two meanings, quotes that do not match, a header or data rows that are missing, a
    /// delimiter that leaves one column where `columns` are given, a header of numbers.
    pub fn split(file: &'t str, text: &'t str, form: &'t Form, columns: &[&ColumnSource]) -> Result<Self> {
        if (form.delimiter(), form.decimal()) == (Delimiter::Comma, Decimal::Comma) {
            return Err(two_commas_in(text).into());
        }
        form.ambiguous_marks(Some(form.delimiter())).map_or(Ok(()), Err)?;
        let (mut all, stray) = lexer::split(file, text, form);
        stray.check()?;
        let mut rows = all.drain(..);
        let header = header(&mut rows, &form.header())?;
        let mut rows: Vec<Row> = rows.collect();
        if let Some(end) = &form.end
            && let Some(at) = rows.iter().position(|row| row.ends(end))
        {
            let behind = rows.get(at + 1).map(|row| error!("rows-after-end", end).at(row.place(file)));
            behind.map_or(Ok(()), Err)?;
            rows.truncate(at);
        }
        rows.iter_mut().zip(1..).for_each(|(row, number)| row.number = number);
        let mut sheet = Self { file, form, header, rows };
        if sheet.rows.is_empty() {
            return Err(error!("data-rows-missing").into());
        }
        if form.sheet.is_some() {
            sheet.pad();
        }
        sheet.check_delimiter(text, columns.len())?;
        sheet.check_header(columns)?;
        Ok(sheet)
    }

    /// Adds the empty cells behind the last one of a row, which a sheet omits.
    fn pad(&mut self) {
        let width = self.header.iter().chain(&self.rows).map(|row| row.fields.len()).max().unwrap_or(0);
        self.header.iter_mut().chain(&mut self.rows).for_each(|row| row.fields.resize(width, Cow::Borrowed("")));
    }

    /// Checks that the delimiter of the form splits the rows, where several columns are given or
    /// another delimiter would split them.
    fn check_delimiter(&self, text: &str, columns: usize) -> Result<()> {
        if self.width() != 1 || !self.form.widths.is_empty() {
            return Ok(());
        }
        let delimiter = self.form.delimiter();
        let other = guesses(text, None).first().and_then(|guess| {
            let form = &guess.form;
            Some((form.delimiter.filter(|other| *other != delimiter)?, form.decimal()))
        });
        let message = error!("delimiter-does-not-split", delimiter = delimiter.name());
        match other {
            None if columns < 2 => Ok(()),
            None => Err(message.hint(phrase!("state-delimiter-of-rows")).at(self.place()).into()),
            Some((other, decimal)) => {
                let hint = phrase!("state-delimiter", delimiter = other.name(), decimal = decimal.name());
                Err(message.hint(hint).at(self.place()).into())
            }
        }
    }

    /// Checks that the row which should name the columns contains no numbers.
    fn check_header(&self, columns: &[&ColumnSource]) -> Result<()> {
        let numbers = self.header.as_ref().and_then(|header| header_of_numbers(header, self.form, columns));
        numbers.map_or(Ok(()), |message| Err(message.at(self.place()).into()))
    }

    /// Place of the header, or of the first row.
    pub fn place(&self) -> Place {
        self.header.as_ref().or(self.rows.first()).map_or_else(|| Place::file(self.file), |row| row.place(self.file))
    }

    /// Place of a cell; of the row, if the index is beyond its cells.
    pub fn cell(&self, row: &Row, index: usize) -> Place {
        if index < row.fields.len() { row.cell(self.file, index) } else { row.place(self.file) }
    }

    /// Headings of the columns; none without a header.
    pub fn headings(&self) -> &[Cow<'t, str>] {
        self.header.as_ref().map_or(&[], |header| &header.fields)
    }

    /// `true` if a heading is neither in the header nor an expression of its headings.
    pub fn lacks(&self, source: &ColumnSource) -> bool {
        let ColumnSource::Heading(name) = source else { return false };
        !Expression::is_likely(name) && self.headings().iter().all(|heading| heading.trim() != name)
    }

    /// Number of columns.
    pub fn width(&self) -> usize {
        self.header.as_ref().or(self.rows.first()).map_or(0, |row| row.fields.len())
    }

    /// Errors of the rows that have another number of fields than the header or the first row.
    pub fn field_counts(&self) -> impl Iterator<Item = Message> {
        let width = self.width();
        let like = if self.header.is_some() { "header" } else { "first-row" };
        let odd = self.rows.iter().filter(move |row| row.fields.len() != width);
        odd.map(move |row| field_count(self.file, row, width, like))
    }

    /// Leaves out the rows that `only` and `without` reject, and lists them.
    ///
    /// # Errors
    /// A column of a filter that the table lacks, or filters that leave no row.
    pub fn filtered(&mut self) -> Result<Vec<LeftOut<'t>>> {
        let mut left_out = Vec::new();
        if !self.form.is_filtered() {
            return Ok(left_out);
        }
        let filter = Filter::new(self.file, self.form, self.header.as_ref()).map_err(Problems)?;
        let mut read = Vec::with_capacity(self.rows.len());
        for row in std::mem::take(&mut self.rows) {
            match filter.refuses(&row) {
                Some(reason) => left_out.push(LeftOut { row, reason }),
                None => read.push(row),
            }
        }
        self.rows = read;
        match self.rows.is_empty() {
            true => Err(no_row_selected(self.file, self.header.as_ref()).into()),
            false => Ok(left_out),
        }
    }

    /// Number that a column or an expression has in a row; `None` if a cell was not measured.
    ///
    /// # Errors
    /// A cell that is not a number, or a result that is not finite, at its place.
    pub fn number(&self, row: &Row, from: &Expression, name: &str) -> result::Result<Option<f64>, Message> {
        self.evaluate(row, from, name, &|at| number(self.form, row.field(at)))
    }

    /// Number that a column or an expression has in a row in which every cell was measured.
    ///
    /// # Errors
    /// As [`Self::number`], also of a cell that means "not measured".
    pub fn measured(&self, row: &Row, from: &Expression, name: &str) -> result::Result<f64, Message> {
        let number = |at: usize| marked(row.field(at), self.form.decimal(), self.form.thousands).map(Some);
        self.evaluate(row, from, name, &number).map(|value| value.unwrap_or(f64::NAN))
    }

    /// Value of an expression whose cells are read by `cell`.
    fn evaluate(
        &self,
        row: &Row,
        from: &Expression,
        name: &str,
        cell: &dyn Fn(usize) -> result::Result<Option<f64>, Message>,
    ) -> result::Result<Option<f64>, Message> {
        let at = from.column().unwrap_or(usize::MAX);
        match from.value(cell) {
            Ok(Some(value)) if !value.is_finite() => {
                Err(error!("computed-not-finite", column = name, value).at(self.cell(row, at)))
            }
            Ok(value) => Ok(value),
            Err((at, message)) => Err(message.at(self.cell(row, at))),
        }
    }

    /// Whole number from a number of a row.
    ///
    /// # Errors
    /// A fraction, or a number that has lost digits, at its place.
    pub fn whole(&self, row: &Row, from: &Expression, name: &str, value: f64) -> result::Result<i64, Message> {
        if value.fract() == 0.0 && value.abs() <= WHOLE {
            return Ok(value as i64);
        }
        let at = from.column().unwrap_or(usize::MAX);
        let shown = row.fields.get(at).map_or_else(|| value.to_string(), ToString::to_string);
        Err(error!("not-whole-number", value = shown, column = name).at(self.cell(row, at)))
    }
}

/// Returns the error that a row has another number of fields than the header or first row.
pub fn field_count(file: &str, row: &Row, width: usize, like: &str) -> Message {
    let expected = phrase!("fields-like", width, like);
    error!("row-field-count", fields = row.fields.len(), expected).at(row.place(file))
}

/// Takes the rows before the data, and returns the last one.
///
/// # Errors
/// No row has the words of the header.
pub fn header<'t>(
    rows: &mut impl Iterator<Item = Row<'t>>,
    stated: &Header,
) -> result::Result<Option<Row<'t>>, Message> {
    match stated {
        Header::Rows(count) => Ok(rows.take(*count).last()),
        Header::Words(words) => {
            let found = rows.find(|row| words.iter().all(|word| row.text.contains(word.as_str())));
            found.map(Some).ok_or_else(|| error!("header-words-missing", words))
        }
    }
}

/// Error if the row which should name the columns contains numbers, none of which is given as a
/// heading.
pub fn header_of_numbers(header: &Row, form: &Form, columns: &[&ColumnSource]) -> Option<Message> {
    let is_number = |field: &&Cow<str>| parsed(field.trim(), form.decimal(), form.thousands).is_some();
    let stated = |field: &Cow<str>| {
        columns.iter().any(|source| matches!(source, ColumnSource::Heading(heading) if heading == field.trim()))
    };
    let numbers = header.fields.iter().filter(is_number).count();
    (2 * numbers > header.fields.len() && !header.fields.iter().any(stated)).then(|| error!("header-holds-numbers"))
}

/// Returns the column of a table of this width, or an expression of its columns.
///
/// # Errors
/// A heading that the table lacks or has more than once, a number beyond its columns, an expression
/// that does not read.
pub fn column(source: &ColumnSource, header: Option<&Row>, width: usize) -> result::Result<Expression, Message> {
    let name = match source {
        ColumnSource::Number(number) if (1..=width).contains(number) => return Ok(Expression::Column(number - 1)),
        ColumnSource::Number(number) => return Err(error!("column-number-unknown", number, columns = width)),
        ColumnSource::Heading(name) => name,
    };
    let headings = header.map_or(&[][..], |header| &header.fields);
    let places: Vec<usize> = (0..headings.len()).filter(|i| headings[*i].trim() == name).collect();
    match places[..] {
        [one] => Ok(Expression::Column(one)),
        [] if Expression::is_likely(name) => {
            let from = Expression::parse(name, headings)?;
            from.check_columns(width).map(|()| from)
        }
        [] if header.is_none() => Err(error!("header-not-stated", column = name)),
        [] => Err(error!("column-unknown", column = name).hint_names(name, headings.iter().map(Cow::as_ref))),
        _ => Err(error!("heading-twice", column = name).hint(phrase!("state-column-number"))),
    }
}

/// Number in a cell; `None` if the cell means "not measured".
///
/// # Errors
/// A cell that is not a number with the marks of the table.
pub fn number(form: &Form, cell: &str) -> result::Result<Option<f64>, Message> {
    if form.missing.says(cell) { Ok(None) } else { marked(cell, form.decimal(), form.thousands).map(Some) }
}
