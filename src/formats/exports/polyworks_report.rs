//! PolyWorks|Inspector report tables as CSV: one row for each control of a feature.
//!
//! Columns `Name,Control,Nom,Meas,Tol,Dev,Test,Out Tol`, found by their words: a report may begin
//! with title lines. The character after `Name` separates the columns. A point has the controls
//! `X`, `Y` and `Z`, or these controls of one kind (`Surface Point X`). Layout from a quoted report
//! and a vendor page; no complete real file was found.

use super::pivot::{Pivot, Said};
use super::{About, ExportFormat, ExportRow, Recognised, Text, WriteError, Writing, decimal_comma, not_this_format};
use crate::Point;
use crate::dialect::{Dialect, Unit};
use etalon_base::message::{Message, Place, Problems, Result};
use etalon_base::{error, phrase};
use etalon_tables::lexer;
use etalon_tables::lexer::{Row as Fields, number, parsed, split};
use etalon_tables::{Decimal, Delimiter, Form};

/// Report tables of PolyWorks|Inspector.
pub(super) struct PolyworksReport;

impl ExportFormat for PolyworksReport {
    fn about(&self) -> About {
        About { name: "polyworks_report", title: "PolyWorks report", decimal_comma: true, ..About::default() }
    }

    fn recognise(&self, text: &str) -> Option<Recognised> {
        Recognised::by(text.starts_with("Name,Control,Nom,Meas"), 1.0, phrase!("is-polyworks-report"))
    }

    fn read(&self, text: &Text, dialect: &Dialect, unit: Unit) -> (Vec<Point>, Problems) {
        rows(text, dialect.form.decimal(), unit)
    }

    fn write(&self, rows: &[ExportRow], how: &Writing) -> std::result::Result<String, WriteError> {
        // a decimal comma goes with semicolons
        let delimiter =
            if how.dialect.form.decimal() == Decimal::Comma { Delimiter::Semicolon } else { Delimiter::Comma };
        let line = |fields: [&str; 8]| lexer::line(&fields.map(str::to_owned), delimiter, None);
        let mut all = line(["Name", "Control", "Nom", "Meas", "Tol", "Dev", "Test", "Out Tol"])?;
        for ExportRow { label, xyz, .. } in rows {
            for (axis, value) in ["X", "Y", "Z"].into_iter().zip(xyz) {
                all += &line([label, axis, "", &how.number(*value), "±1", "", "", ""])?;
            }
        }
        Ok(all)
    }
}

/// A control of a feature: nominal and measured value in the unit of the report.
#[derive(Clone, Debug, PartialEq)]
pub struct Control {
    /// Its line, from 1.
    pub line: usize,
    /// The feature.
    pub name: String,
    /// `X`, `Diameter`, `Y Distance` ...
    pub control: String,
    /// Nominal value, if it is a number.
    pub nominal: Option<f64>,
    /// Measured value; `None` if there is a word instead.
    pub measured: Option<f64>,
    /// Upper and lower tolerance.
    pub tolerance: Option<(f64, f64)>,
}

/// Reads the controls of a report.
pub fn controls(file: &str, text: &str, decimal: Decimal) -> Result<Vec<Control>> {
    let text = text.into();
    let (controls, problems) = read(&Text::new(file, &text, false), decimal);
    problems.check().map(|_| controls)
}

/// The points of a report.
fn rows(text: &Text, decimal: Decimal, unit: Unit) -> (Vec<Point>, Problems) {
    let (controls, problems) = read(text, decimal);
    let mut pivot = Pivot::default();
    for control in controls {
        let (kind, axis) = control.control.rsplit_once(' ').unwrap_or(("", &control.control));
        let said = match (["X", "Y", "Z"].iter().position(|a| *a == axis), control.measured) {
            (Some(axis), Some(value)) => Said::Coordinate(axis, value),
            (Some(_), None) => Said::Other(format!("{} without a value", control.control)),
            (None, _) => Said::Other(control.control.clone()),
        };
        let kind = if axis.len() == 1 { kind } else { "" };
        pivot.add(control.line, &control.name, kind, said);
    }
    (pivot.rows(text, unit), problems)
}

/// Row of names: its line, the delimiter, and the indices of the columns that are read.
struct Columns {
    line: usize,
    delimiter: Delimiter,
    name: usize,
    control: usize,
    nominal: Option<usize>,
    measured: usize,
    tolerance: Option<usize>,
    width: usize,
}

fn read(text: &Text, decimal: Decimal) -> (Vec<Control>, Problems) {
    let mut problems = Problems::default();
    let Some(columns) = header(text) else {
        let signature = phrase!("header-with", names = "`Name`, `Control`, `Meas`");
        problems.0.push(not_this_format("polyworks_report", &signature).at(Place::file(text.file)));
        return (Vec::new(), problems);
    };
    if columns.delimiter == Delimiter::Comma && decimal == Decimal::Comma {
        problems.0.push(error!("comma-ambiguous").at(text.place(columns.line)));
        return (Vec::new(), problems);
    }
    let form = Form::delimited(columns.delimiter);
    let (rows, stray) = split(text.file, text.whole, &form);
    let behind = |message: &Message| message.place.as_ref().and_then(|p| p.line) > Some(columns.line);
    problems.0.extend(stray.0.into_iter().filter(behind));
    let names = rows.iter().find(|row| row.line == columns.line).map(|row| &row.fields);
    let mut controls = Vec::new();
    for row in rows.iter().filter(|row| row.line > columns.line) {
        // the names may be repeated on every page
        if row.fields.iter().all(|f| f.is_empty()) || Some(&row.fields) == names {
            continue;
        }
        controls.extend(control(text, &columns, row, decimal, &mut problems));
    }
    (controls, problems)
}

/// The first row that names the columns.
fn header(text: &Text) -> Option<Columns> {
    text.lines.iter().enumerate().take(1000).find_map(|(i, line)| {
        let after = line.trim_start_matches('"').strip_prefix("Name")?.trim_start_matches('"').chars().next()?;
        let delimiters = [Delimiter::Comma, Delimiter::Semicolon, Delimiter::Tab];
        let delimiter = delimiters.into_iter().find(|d| d.byte().map(char::from) == Some(after))?;
        let fields: Vec<&str> = line.split(after).map(|f| f.trim().trim_matches('"')).collect();
        let place = |name: &str| fields.iter().position(|f| *f == name);
        Some(Columns {
            line: i + 1,
            delimiter,
            name: place("Name")?,
            control: place("Control")?,
            nominal: place("Nom"),
            measured: place("Meas")?,
            tolerance: place("Tol"),
            width: fields.len(),
        })
    })
}

fn control(text: &Text, columns: &Columns, row: &Fields, decimal: Decimal, problems: &mut Problems) -> Option<Control> {
    let field = |at: usize| row.field(at);
    let place = |at: usize| row.cell(text.file, at);
    let surplus = row.fields.iter().skip(columns.width).any(|f| !f.is_empty());
    if surplus || row.fields.len() <= columns.measured {
        let expected = phrase!("fields-like", like = "header", width = columns.width);
        let message = error!("row-field-count", fields = row.fields.len(), expected).at(row.place(text.file));
        let commas = surplus && columns.delimiter == Delimiter::Comma;
        problems.0.push(if commas { message.hint(phrase!("commas-in-commas")) } else { message });
        return None;
    }
    if field(columns.name).is_empty() {
        problems.0.push(error!("cell-empty", column = "Name").at(row.place(text.file)));
        return None;
    }
    // a word instead of a value: not measured; a text that begins like a number must be a number
    let mut value = |at: usize| {
        let text = field(at);
        let numeric = text.starts_with(|c: char| c.is_ascii_digit() || "+-.,\u{2212}".contains(c)) && text != "-";
        match number(&text.replace('\u{2212}', "-"), decimal) {
            Ok(value) => Some(value),
            Err(message) if numeric && text.bytes().any(|b| b.is_ascii_digit()) => {
                problems.0.push(decimal_comma(message, text, "polyworks_report").at(place(at)));
                None
            }
            Err(_) => None,
        }
    };
    let (nominal, measured) = (columns.nominal.and_then(&mut value), value(columns.measured));
    let stated = columns.tolerance.map_or("", field);
    let tolerance = tolerance(stated, decimal);
    if let (None, false, Some(at)) = (tolerance, stated.is_empty(), columns.tolerance) {
        let valid = ["±0.5", "+0.5/-0.2"];
        let message = error!("record-invalid", text = stated, format = "polyworks_report", valid).at(place(at));
        let wrong_encoding = stated.contains('Â') || stated.contains('\u{fffd}');
        problems.0.push(if wrong_encoding { message.hint(phrase!("state-encoding")) } else { message });
    }
    let (name, control) = (field(columns.name).to_owned(), field(columns.control).to_owned());
    Some(Control { line: row.line, name, control, nominal, measured, tolerance })
}

/// Upper and lower tolerance: `±2.000`, `+0.5/-0.2`.
fn tolerance(text: &str, decimal: Decimal) -> Option<(f64, f64)> {
    let read = |text: &str| parsed(text.trim().trim_start_matches('+'), decimal, None);
    if let Some(both) = text.strip_prefix('±') {
        return read(both).map(|t| (t, -t));
    }
    let (upper, lower) = text.split_once('/')?;
    Some((read(upper)?, read(lower)?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tolerances_are_symmetric_or_have_two_sides() {
        assert_eq!(tolerance("±2.000", Decimal::Point), Some((2.0, -2.0)));
        assert_eq!(tolerance("+0,5/-0,25", Decimal::Comma), Some((0.5, -0.25)));
        for wrong in ["Â±2.000", "2.000", "±", "", "±1,5"] {
            assert_eq!(tolerance(wrong, Decimal::Point), None, "{wrong}");
        }
    }
}
