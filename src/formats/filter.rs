//! Filters of rows by the cells of their columns, for tables of every kind.

use crate::dialect::Cells;
use crate::lexer::{Row, column_index};
use etalon_base::catalogue::Phrase;
use etalon_base::message::{Message, Place};
use etalon_base::phrase;
use std::collections::BTreeMap;

/// Rows that are left out by the cells of their columns.
#[derive(Default)]
pub(crate) struct Filter<'a> {
    /// Column, its name, its cells, and whether a row with one of them is read.
    cells: Vec<(usize, &'a str, &'a Cells, bool)>,
}

impl<'a> Filter<'a> {
    /// Returns the filter that `only` and `without` state.
    ///
    /// # Errors
    /// Columns that the file lacks, at its header.
    pub fn of(
        file: &str,
        [only, without]: [&'a BTreeMap<String, Cells>; 2],
        header: Option<&Row>,
    ) -> Result<Self, Vec<Message>> {
        let at = || header.map_or_else(|| Place::file(file), |row| row.place(file));
        let (mut cells, mut wrong) = (Vec::new(), Vec::new());
        for (stated, read) in [(only, true), (without, false)] {
            for (name, of) in stated {
                match column_index(name, header) {
                    Ok(column) => cells.push((column, name.as_str(), of, read)),
                    Err(message) => wrong.push(message.at(at())),
                }
            }
        }
        if wrong.is_empty() { Ok(Self { cells }) } else { Err(wrong) }
    }

    /// Returns the reason for leaving out a row.
    pub fn refuses(&self, row: &Row) -> Option<Phrase> {
        let fails =
            |(column, _, cells, read): &&(usize, &str, &Cells, bool)| cells.contain(row.field(*column)) != *read;
        let (column, name, ..) = self.cells.iter().find(fails)?;
        Some(phrase!("row-left-out-by-cell", column = name, cell = row.field(*column)))
    }
}
