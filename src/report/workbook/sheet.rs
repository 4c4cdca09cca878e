//! A sheet: columns with their titles and units, and rows of cells.

use crate::base::message::{Message, Result};
use rust_xlsxwriter::{Color, Format, FormatAlign, FormatBorder, Workbook, Worksheet, XlsxError};

/// What Excel holds on one sheet, less the header and a line that says what is left out.
const ROWS: usize = 1_048_574;
/// What Excel holds in one cell, UTF-16 units.
const CELL: usize = 32_767;
const WIDTH: std::ops::RangeInclusive<usize> = 8..=60;
/// Rows that are looked at for the width of a column.
const LOOKED_AT: usize = 1000;

/// What stands in a cell. A text is written as text, also where it looks like a formula, a number or a link.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Cell {
    Empty,
    Number(f64),
    Text(String),
}

impl From<f64> for Cell {
    fn from(value: f64) -> Self {
        if value.is_finite() { Self::Number(value) } else { Self::Text("not a number".to_owned()) }
    }
}

impl From<usize> for Cell {
    fn from(value: usize) -> Self {
        Self::Number(value as f64)
    }
}

impl From<i64> for Cell {
    fn from(value: i64) -> Self {
        // beyond 2^53 a number of Excel would be another one
        if value.unsigned_abs() <= 1 << 53 { Self::Number(value as f64) } else { Self::Text(value.to_string()) }
    }
}

impl From<&str> for Cell {
    fn from(text: &str) -> Self {
        if text.is_empty() { Self::Empty } else { Self::Text(text.to_owned()) }
    }
}

impl From<String> for Cell {
    fn from(text: String) -> Self {
        text.as_str().into()
    }
}

impl<T: Into<Cell>> From<Option<T>> for Cell {
    fn from(value: Option<T>) -> Self {
        value.map_or(Self::Empty, Into::into)
    }
}

/// Title and unit of a column; the unit is empty for counts, names and what states its unit beside it.
pub(super) type Column = (String, String);

/// One table.
#[derive(Debug)]
pub(super) struct Sheet {
    pub name: &'static str,
    pub columns: Vec<Column>,
    pub rows: Vec<Vec<Cell>>,
}

/// A column of records of type `T`: title, unit, and what stands in it.
pub(super) type Field<T> = (&'static str, &'static str, fn(&T) -> Cell);

impl Sheet {
    /// One row for each record.
    pub fn of<'a, T: 'a>(name: &'static str, records: impl IntoIterator<Item = &'a T>, fields: &[Field<T>]) -> Self {
        Self {
            name,
            columns: fields.iter().map(|(title, unit, _)| ((*title).to_owned(), (*unit).to_owned())).collect(),
            rows: records.into_iter().map(|r| fields.iter().map(|(_, _, cell)| cell(r)).collect()).collect(),
        }
    }

    /// The same in every language, so that programs find it.
    fn title((title, unit): &Column) -> String {
        if unit.is_empty() { title.clone() } else { format!("{title} [{unit}]") }
    }

    /// Characters that column `i` needs.
    fn width(&self, i: usize) -> usize {
        let shown = |cell: &Cell| match cell {
            Cell::Empty => 0,
            Cell::Number(_) => 11,
            Cell::Text(text) => text.lines().map(|l| l.chars().count()).max().unwrap_or(0),
        };
        let rows = self.rows.iter().take(LOOKED_AT).filter_map(|row| row.get(i)).map(shown).max().unwrap_or(0);
        // room for the button of the filter
        let header = Self::title(&self.columns[i]).chars().count() + 3;
        rows.max(header).clamp(*WIDTH.start(), *WIDTH.end())
    }
}

/// A workbook of these sheets, those without columns left out, as bytes that depend on nothing else.
pub(super) fn write(title: &str, sheets: &[Sheet]) -> Result<Vec<u8>> {
    let fail = |e: XlsxError| Message::error(format!("cannot write the workbook: {e}"));
    let mut workbook = Workbook::new();
    let created = rust_xlsxwriter::ExcelDateTime::from_ymd(1980, 1, 1).map_err(fail)?;
    let properties = rust_xlsxwriter::DocProperties::new().set_creation_datetime(&created);
    workbook.set_properties(
        &properties.set_title(printable(title)).set_comment(concat!("etalon ", env!("CARGO_PKG_VERSION"))),
    );
    for sheet in sheets.iter().filter(|s| !s.columns.is_empty()) {
        fill(workbook.add_worksheet(), sheet).map_err(fail)?;
    }
    Ok(workbook.save_to_buffer().map_err(fail)?)
}

fn fill(page: &mut Worksheet, sheet: &Sheet) -> std::result::Result<(), XlsxError> {
    let head =
        Format::new().set_bold().set_background_color(Color::RGB(0x00F3_F5F8)).set_border_bottom(FormatBorder::Thin);
    let text = Format::new().set_num_format("@").set_align(FormatAlign::Top);
    page.set_name(sheet.name)?;
    let last = sheet.columns.len().saturating_sub(1) as u16;
    let mut numbers = Vec::new();
    for (i, column) in (0u16..).zip(&sheet.columns) {
        page.write_string_with_format(0, i, printable(&Sheet::title(column)), &head)?;
        page.set_column_width(i, sheet.width(usize::from(i)) as f64)?;
        numbers.push(Format::new().set_num_format(number_format(&column.1)).set_align(FormatAlign::Top));
    }
    for (i, row) in (1u32..).zip(sheet.rows.iter().take(ROWS)) {
        for ((j, cell), number) in (0u16..).zip(row).zip(&numbers) {
            match cell {
                Cell::Empty => continue,
                Cell::Number(value) => page.write_number_with_format(i, j, *value, number)?,
                Cell::Text(words) => page.write_string_with_format(i, j, printable(words), &text)?,
            };
        }
    }
    let written = sheet.rows.len().min(ROWS) as u32;
    if let Some(left_out) = sheet.rows.len().checked_sub(ROWS).filter(|n| *n > 0) {
        page.write_string(written + 1, 0, format!("{left_out} more rows are left out: the documents have all"))?;
    }
    page.set_freeze_panes(1, 0)?;
    page.autofilter(0, 0, written, last)?;
    page.set_landscape().set_print_fit_to_pages(1, 0).set_repeat_rows(0, 0)?;
    Ok(())
}

/// Digits that a reader wants to see; the cell holds all.
fn number_format(unit: &str) -> &'static str {
    match unit {
        "mm" => "0.00000",
        "deg" => "0.000000",
        "µm" => "0.00",
        _ => "General",
    }
}

/// Text that a workbook can hold: no character that XML forbids, and no more than a cell takes.
fn printable(text: &str) -> String {
    let allowed = |c: char| match c {
        '\n' | '\t' => c,
        '\u{fffe}' | '\u{ffff}' => '\u{fffd}',
        c if c.is_control() => '\u{fffd}',
        c => c,
    };
    let mut units = 0;
    let fits = |c: &char| {
        units += c.len_utf16();
        units <= CELL
    };
    text.chars().map(allowed).take_while(fits).collect()
}
