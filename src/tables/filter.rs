//! Filters of rows by the cells of their columns, for tables of every kind.

use crate::lexer::{Row, column_index, parsed};
use crate::{Cells, Form};
use etalon_base::catalogue::Phrase;
use etalon_base::message::{Message, Place};
use etalon_base::{error, phrase};

/// Place of a header, or of a file without one.
fn header_place(file: &str, header: Option<&Row>) -> Place {
    header.map_or_else(|| Place::file(file), |row| row.place(file))
}

/// Returns the error that the filters of a file leave no row.
pub fn no_row_selected(file: &str, header: Option<&Row>) -> Message {
    error!("no-row-selected").at(header_place(file, header))
}

/// Rows that are omitted by the cells of their columns.
pub struct Filter<'a> {
    /// Column, its name, its cells, and whether a row with one of them is read.
    cells: Vec<(usize, &'a str, &'a Cells, bool)>,
    form: &'a Form,
}

impl<'a> Filter<'a> {
    /// Returns the filter that `only` and `without` of a form state.
    ///
    /// # Errors
    /// Columns that the file lacks, at its header.
    pub fn new(file: &str, form: &'a Form, header: Option<&Row>) -> Result<Self, Vec<Message>> {
        let (mut cells, mut wrong) = (Vec::new(), Vec::new());
        for (stated, read) in [(&form.only, true), (&form.without, false)] {
            for (name, of) in stated {
                match column_index(name, header) {
                    Ok(column) => cells.push((column, name.as_str(), of, read)),
                    Err(message) => wrong.push(message.at(header_place(file, header))),
                }
            }
        }
        if wrong.is_empty() { Ok(Self { cells, form }) } else { Err(wrong) }
    }

    /// Returns the reason for leaving out a row.
    pub fn refuses(&self, row: &Row) -> Option<Phrase> {
        let number = |text: &str| parsed(text, self.form.decimal(), self.form.thousands);
        let fails = |(column, _, cells, read): &&(usize, &str, &Cells, bool)| {
            cells.contain(row.field(*column), number) != *read
        };
        let (column, name, ..) = self.cells.iter().find(fails)?;
        Some(phrase!("row-left-out-by-cell", column = name, cell = row.field(*column)))
    }
}
