//! Tables, and their layout on a page, in a workbook and on the terminal.

use super::cell::Cell;
use super::columns::{Column, Columns, On};
use crate::words::Words;
use etalon_base::catalogue::Phrase;
use serde::{Serialize, Serializer};

/// Maximum number of rows of a table on a page; the workbook and the documents contain all rows.
const ROWS: usize = 500;
/// Maximum number of rows of a table on paper: `most` of `report.typ`.
pub(crate) const PAPER_ROWS: usize = 200;
/// Minimum length (characters) of texts whose columns share the width left by other columns.
const LONG: usize = 22;

/// A table: columns and typed cells.
#[derive(Debug, Default)]
pub(crate) struct Table {
    /// Name of the sheet of the workbook, if any. Tables of one sheet are placed below each other.
    pub sheet: Option<Phrase>,
    columns: Vec<Titled>,
    pub rows: Vec<Vec<Cell>>,
    /// Number of first columns that are repeated if a page is too narrow.
    lead: usize,
    /// Maximum number of rows on a page.
    most: usize,
    /// `true` if the table is too long for a page, but shown on the terminal.
    pub off_page: bool,
    /// `true` if a brief terminal omits the table.
    pub detail: bool,
}

/// Titles of a column.
#[derive(Clone, Debug)]
struct Titled {
    on: On,
    decisive: bool,
    group: String,
    title: String,
    /// Title in the workbook, with the unit in brackets.
    sheet: String,
    /// Title in the workbook in English, by which a chart finds its columns.
    key: String,
    unit: String,
}

impl Table {
    /// Creates a table with one row per record.
    pub fn new<'a, T: 'a>(
        words: &Words,
        records: impl IntoIterator<Item = &'a T>,
        Columns(columns): Columns<'a, T>,
    ) -> Self {
        let english = Words::default();
        let titled = |c: &Column<T>| {
            let behind = |unit: &str| if unit.is_empty() { String::new() } else { format!(", {unit}") };
            let in_workbook = |words: &Words| {
                let [group, title] = [&c.group, &c.title].map(|title| title.translated(words));
                let before = if group.is_empty() { String::new() } else { format!("{group}, ") };
                let unit = if c.unit.is_empty() { String::new() } else { format!(" [{}]", c.unit) };
                format!("{before}{title}{unit}")
            };
            Titled {
                on: c.on,
                decisive: c.decisive,
                group: c.group.translated(words),
                title: c.title.translated(words) + &behind(c.shown_in),
                sheet: in_workbook(words),
                key: in_workbook(&english),
                unit: c.unit.to_owned(),
            }
        };
        let row = |record: &'a T| columns.iter().map(|c| (c.cell)(record)).collect();
        Self {
            sheet: None,
            columns: columns.iter().map(titled).collect(),
            rows: records.into_iter().map(row).collect(),
            lead: 0,
            most: ROWS,
            off_page: false,
            detail: false,
        }
    }

    /// Limits the number of rows on a page.
    pub fn showing(self, most: usize) -> Self {
        Self { most, ..self }
    }

    /// Shows the table on the terminal instead of a page.
    pub fn not_on_page(self) -> Self {
        Self { off_page: true, ..self }
    }

    /// Omits the table on a brief terminal.
    pub fn detail(self) -> Self {
        Self { detail: true, ..self }
    }

    /// Places the table on a sheet of the workbook.
    pub fn on(self, sheet: Phrase) -> Self {
        Self { sheet: Some(sheet), ..self }
    }

    /// Splits the table if it is too wide, repeating its first columns.
    pub fn repeating(self, lead: usize) -> Self {
        Self { lead, ..self }
    }

    /// Removes columns in which every row is empty.
    pub fn without_empty_columns(mut self) -> Self {
        let kept: Vec<bool> =
            (0..self.columns.len()).map(|i| self.rows.iter().any(|row| !row[i].is_missing())).collect();
        fn keep<T>(all: &mut Vec<T>, kept: &[bool]) {
            let mut kept = kept.iter();
            all.retain(|_| kept.next() == Some(&true));
        }
        keep(&mut self.columns, &kept);
        self.rows.iter_mut().for_each(|row| keep(row, &kept));
        self
    }

    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// Index of each column in a workbook, with its title, its English title and its unit.
    pub fn sheet_columns(&self) -> Vec<(usize, [&str; 3])> {
        let all = self.columns.iter().enumerate().filter(|(_, c)| c.on != On::Page);
        all.map(|(i, c)| (i, [c.sheet.as_str(), &c.key, &c.unit])).collect()
    }

    /// Indices of the columns on a page.
    pub(super) fn on_page(&self) -> Vec<usize> {
        (0..self.columns.len()).filter(|i| self.columns[*i].on != On::Sheet).collect()
    }

    /// `true` if a page shows any part of the table.
    pub(super) fn is_visible(&self) -> bool {
        !self.off_page && !self.rows.is_empty() && !self.on_page().is_empty()
    }

    /// Layout for the terminal.
    pub fn laid(&self) -> Laid<'_> {
        self.laid_out(self.on_page())
    }

    /// Layout for a page: the deciding column follows the name.
    fn laid_on_page(&self) -> Laid<'_> {
        let mut places = self.on_page();
        if let Some(i) = places.iter().position(|i| self.columns[*i].decisive).filter(|i| *i > 1) {
            places[1..=i].rotate_right(1);
        }
        self.laid_out(places)
    }

    fn laid_out(&self, places: Vec<usize>) -> Laid<'_> {
        let rows: Vec<Vec<&Cell>> =
            self.rows.iter().take(self.most).map(|row| places.iter().map(|i| &row[*i]).collect()).collect();
        let any = |i: usize, is: &dyn Fn(&Cell) -> bool| rows.iter().any(|row| is(row[i]));
        let letters = |cell: &Cell| cell.plain().chars().count();
        let checksum = |cell: &Cell| is_checksum(&cell.plain());
        let numeric: Vec<bool> = (0..places.len()).map(|i| any(i, &Cell::is_number)).collect();
        let long = |i: usize| !numeric[i] && any(i, &|c| letters(c) > LONG) && !any(i, &checksum);
        let mut groups: Vec<(&str, usize)> = Vec::new();
        for i in &places {
            let group = self.columns[*i].group.as_str();
            match groups.last_mut().filter(|(title, _)| *title == group) {
                Some((_, count)) => *count += 1,
                None => groups.push((group, 1)),
            }
        }
        if groups.iter().all(|(title, _)| title.is_empty()) {
            groups.clear();
        }
        let all: usize = rows.iter().flatten().map(|cell| letters(cell)).sum();
        Laid {
            groups,
            header: places.iter().map(|i| self.columns[*i].title.as_str()).collect(),
            long: (0..places.len()).map(long).collect(),
            short: rows.len() <= 15 && all <= 2000,
            lead: self.lead,
            left_out: self.rows.len() - rows.len(),
            numeric,
            rows,
        }
    }
}

/// `true` for a SHA-256 in hexadecimal digits, which must not be broken, as it is copied.
pub(crate) fn is_checksum(word: &str) -> bool {
    word.len() == 64 && word.bytes().all(|b| b.is_ascii_hexdigit())
}

/// Layout of a table on a page.
#[derive(Serialize)]
pub(crate) struct Laid<'a> {
    /// Titles above several columns, with the number of columns; empty if none.
    pub groups: Vec<(&'a str, usize)>,
    pub header: Vec<&'a str>,
    pub numeric: Vec<bool>,
    /// `true` for texts that may need several lines.
    long: Vec<bool>,
    /// `true` if the table fits on part of a page.
    short: bool,
    lead: usize,
    pub rows: Vec<Vec<&'a Cell>>,
    pub left_out: usize,
}

impl Serialize for Table {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.laid_on_page().serialize(serializer)
    }
}
