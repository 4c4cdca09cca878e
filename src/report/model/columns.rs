//! Columns of tables: title, unit and content of a record.

use super::cell::{Cell, fixed, um};
use crate::words::Words;
use etalon_base::catalogue::Phrase;

/// Title of a column: a symbol or name that is the same in all languages, or a text of the
/// catalogue.
#[derive(Clone, Debug)]
pub(crate) enum Title<'a> {
    Symbol(&'a str),
    Text(Phrase),
}

impl Title<'_> {
    pub(super) fn translated(&self, words: &Words) -> String {
        match self {
            Self::Symbol(symbol) => (*symbol).to_owned(),
            Self::Text(phrase) => words.tr(phrase),
        }
    }
}

impl<'a> From<&'a str> for Title<'a> {
    fn from(symbol: &'a str) -> Self {
        Self::Symbol(symbol)
    }
}

impl From<Phrase> for Title<'_> {
    fn from(phrase: Phrase) -> Self {
        Self::Text(phrase)
    }
}

/// Renderers that show a column.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum On {
    Both,
    Page,
    Sheet,
}

/// A column of records of type `T`: title, unit and content.
pub(super) struct Column<'a, T> {
    pub title: Title<'a>,
    pub unit: &'a str,
    pub shown_in: &'a str,
    pub group: Title<'a>,
    pub decisive: bool,
    pub on: On,
    pub cell: Box<dyn Fn(&'a T) -> Cell + 'a>,
}

/// The columns of a table.
pub(crate) struct Columns<'a, T>(pub(super) Vec<Column<'a, T>>);

impl<'a, T> Columns<'a, T> {
    pub fn new() -> Self {
        Self(Vec::new())
    }

    fn with<C: Into<Cell>>(mut self, on: On, title: Title<'a>, unit: &'a str, cell: impl Fn(&'a T) -> C + 'a) -> Self {
        let cell = Box::new(move |record: &'a T| cell(record).into());
        self.0.push(Column { title, unit, shown_in: unit, group: "".into(), decisive: false, on, cell });
        self
    }

    /// Adds a column for all renderers.
    pub fn both<C: Into<Cell>>(
        self,
        title: impl Into<Title<'a>>,
        unit: &'a str,
        cell: impl Fn(&'a T) -> C + 'a,
    ) -> Self {
        self.with(On::Both, title.into(), unit, cell)
    }

    /// Adds a column that the workbook omits, because other columns contain the numbers separately.
    pub fn page<C: Into<Cell>>(
        self,
        title: impl Into<Title<'a>>,
        unit: &'a str,
        cell: impl Fn(&'a T) -> C + 'a,
    ) -> Self {
        self.with(On::Page, title.into(), unit, cell)
    }

    /// Adds a column for the workbook only.
    pub fn sheet<C: Into<Cell>>(
        self,
        title: impl Into<Title<'a>>,
        unit: &'a str,
        cell: impl Fn(&'a T) -> C + 'a,
    ) -> Self {
        self.with(On::Sheet, title.into(), unit, cell)
    }

    /// Adds a column of lengths in mm, shown in µm.
    pub fn micrometres<V: Into<Option<f64>>>(self, title: impl Into<Title<'a>>, mm: impl Fn(&'a T) -> V + 'a) -> Self {
        self.both(title, "mm", move |record| um(mm(record))).in_unit("µm")
    }

    /// Adds a workbook column for each existing coordinate.
    pub fn sheet_xyz(self, titles: [impl Into<Title<'a>>; 3], unit: &'a str, of: fn(&'a T) -> &'a [f64]) -> Self {
        let add = |columns: Self, (i, title)| columns.sheet(title, unit, move |record| of(record).get(i).copied());
        titles.into_iter().enumerate().fold(self, add)
    }

    /// Adds a page column for each angle.
    pub fn page_angles(self, titles: &'a [String], of: fn(&'a T) -> &'a [f64]) -> Self {
        let add = |columns: Self, (i, title): (usize, &'a String)| {
            columns.page(title.as_str(), "deg", move |record| fixed(of(record).get(i).copied(), 4))
        };
        titles.iter().enumerate().fold(self, add)
    }

    /// Adds the columns of another table with these titles to the page.
    pub fn page_columns(mut self, table: Self, titles: &[&str]) -> Self {
        let english = Words::default();
        let shown = table.0.into_iter().filter(|c| titles.contains(&c.title.translated(&english).as_str()));
        self.0.extend(shown.map(|c| Column { on: On::Page, ..c }));
        self
    }

    /// Restricts the columns to the workbook.
    pub fn in_workbook(mut self) -> Self {
        self.0.iter_mut().for_each(|c| c.on = On::Sheet);
        self
    }

    /// Shows the last column in another unit.
    pub fn in_unit(mut self, unit: &'a str) -> Self {
        self.0.iter_mut().rev().take(1).for_each(|c| c.shown_in = unit);
        self
    }

    /// Makes the last column the second one of a page, so that a narrow screen shows it.
    pub fn decisive(mut self) -> Self {
        self.0.iter_mut().rev().take(1).for_each(|c| c.decisive = true);
        self
    }

    /// Adds a common title above the last columns.
    pub fn below(mut self, columns: usize, group: impl Into<Title<'a>>) -> Self {
        let group = group.into();
        self.0.iter_mut().rev().take(columns).for_each(|c| c.group = group.clone());
        self
    }
}
