//! A piece of a section that page and print show alike: what it says, its table, its pictures.

use super::points::Picture;
use serde::Serialize;

/// One piece; what is empty is not shown.
#[derive(Debug, Default, Serialize)]
pub(super) struct Part {
    pub heading: String,
    /// what a reader wants to know first
    pub strong: String,
    pub sentences: Vec<String>,
    pub note: String,
    /// said in English in every language
    pub conventions: Vec<String>,
    pub columns: Vec<Column>,
    pub rows: Vec<Vec<String>>,
    pub pictures: Vec<Picture>,
}

/// Title of a column; numbers stand at the right.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Column {
    pub title: String,
    pub number: bool,
}

/// A column of numbers.
pub(super) fn number(title: impl Into<String>) -> Column {
    Column { title: title.into(), number: true }
}

/// A column of texts.
pub(super) fn text(title: impl Into<String>) -> Column {
    Column { title: title.into(), number: false }
}

impl Part {
    /// A table below a heading.
    pub fn table(heading: String, note: String, columns: Vec<Column>, rows: Vec<Vec<String>>) -> Self {
        Self { heading, note, columns, rows, ..Self::default() }
    }

    /// The same without the columns in which no row says anything.
    pub fn without_empty_columns(mut self) -> Self {
        let said: Vec<bool> = (0..self.columns.len())
            .map(|i| self.rows.iter().any(|row| row.get(i).is_some_and(|c| !c.is_empty())))
            .collect();
        let kept = |i: usize| said.get(i).copied().unwrap_or(true);
        self.columns = self.columns.into_iter().enumerate().filter(|(i, _)| kept(*i)).map(|(_, c)| c).collect();
        let row = |row: Vec<String>| row.into_iter().enumerate().filter(|(i, _)| kept(*i)).map(|(_, c)| c).collect();
        self.rows = self.rows.into_iter().map(row).collect();
        self
    }

    /// Whether there is something to show.
    pub fn has_rows(&self) -> bool {
        !self.rows.is_empty()
    }
}
