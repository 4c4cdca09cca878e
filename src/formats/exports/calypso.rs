//! Zeiss Calypso table files, separated by tabs: characteristics (`_chr`), features (`_fet`), and
//! the head of a run (`_hdr`).
//!
//! Columns are found by their names; their order and number change with the version. A row may be
//! shorter than the header. The last row is the word `END`. In a `_chr` file, a point consists of
//! `xValue`, `yValue` and `zValue` of one feature in one run. The names of a `_fet` file are not
//! documented: `x`, `y`, `z` and `featureid` or `id` are read.

use super::pivot::{Pivot, Said};
use super::{
    About, ExportFormat, ExportRow, Recognised, Text, WriteError, Writing, decimal_comma, not_this_format, unit_agrees,
};
use crate::Point;
use crate::dialect::{Dialect, Unit};
use etalon_base::message::{Message, Place, Problems};
use etalon_base::{error, phrase};
use etalon_tables::Decimal;
use etalon_tables::lexer::{Row as Fields, number};
use std::borrow::Cow;

/// Table files of Zeiss Calypso.
pub(super) struct Calypso;

impl ExportFormat for Calypso {
    fn about(&self) -> About {
        About { name: "calypso", title: "Zeiss Calypso table", decimal_comma: true, ..About::default() }
    }

    fn recognise(&self, text: &str) -> Option<Recognised> {
        Recognised::by(text.starts_with("planid\tpartnb"), 1.0, phrase!("is-calypso"))
    }

    fn read(&self, text: &Text, dialect: &Dialect, unit: Unit) -> (Vec<Point>, Problems) {
        rows(text, dialect.form.decimal(), unit)
    }

    fn write(&self, rows: &[ExportRow], how: &Writing) -> Result<String, WriteError> {
        let unit = how.unit.name();
        let mut all = "planid\tpartnb\tid\tidsymbol\tactual\tfeatureid\tunit\tgroup1\t\n".to_owned();
        for ExportRow { label, xyz, .. } in rows {
            for (axis, value) in ["x", "y", "z"].into_iter().zip(xyz) {
                let value = how.number(*value);
                all += &format!("simulated\t1\t{label}_{axis}\t{axis}Value\t{value}\t{label}\t{unit}\n");
            }
        }
        Ok(all + "END\n")
    }
}

/// A table with a header.
struct Table<'a> {
    text: &'a Text<'a>,
    names: Fields<'a>,
    rows: Vec<Fields<'a>>,
}

impl<'a> Table<'a> {
    fn column(&self, name: &str) -> Option<usize> {
        self.names.fields.iter().position(|n| n == name)
    }

    /// Cell of a row; empty if the column does not exist.
    fn cell<'r>(&self, row: Option<&'r Fields>, column: Option<usize>) -> &'r str {
        row.zip(column).map_or("", |(row, at)| row.field(at))
    }

    fn place(&self, row: &Fields, at: usize) -> Place {
        row.cell(self.text.file, at)
    }
}

/// The points of a table.
fn rows(text: &Text, decimal: Decimal, unit: Unit) -> (Vec<Point>, Problems) {
    let mut problems = Problems::default();
    let table = table(text, &mut problems);
    let has = |names: &[&str]| names.iter().all(|name| table.column(name).is_some());
    if has(&["featureid", "idsymbol", "actual"]) {
        (characteristics(&table, decimal, unit, &mut problems), problems)
    } else if has(&["x", "y", "z"]) && (has(&["featureid"]) || has(&["id"])) {
        (features(&table, decimal, unit, &mut problems), problems)
    } else {
        problems.0.push(no_table(&table).at(text.place(1)));
        (Vec::new(), problems)
    }
}

/// Error for a file without points.
fn no_table(table: &Table) -> Message {
    let head = ["planid", "lengthunit", "temperatureworkpiece"];
    if head.iter().any(|name| table.column(name).is_none()) {
        let names = "`featureid`, `idsymbol`, `actual`; `featureid`, `x`, `y`, `z`";
        return not_this_format("calypso", &phrase!("header-in-tabs", names));
    }
    let stated = |name: &str| match table.cell(table.rows.first(), table.column(name)) {
        "" => "?".to_owned(),
        value => value.to_owned(),
    };
    let (unit, temperature) = (stated("lengthunit"), stated("temperatureworkpiece"));
    error!("no-measured-points", contents = phrase!("head-of-a-run"), records = "_chr, _fet").hint(phrase!(
        "calypso-head",
        unit,
        temperature
    ))
}

/// Splits the file; surplus fields and rows after the end are reported.
fn table<'a>(text: &'a Text, problems: &mut Problems) -> Table<'a> {
    let split = |line: usize| {
        let fields = text.line_text(line).split('\t').map(|f| f.trim().trim_matches('"'));
        Fields::new(line, text.line_text(line), fields)
    };
    let names = split(1);
    let again = |(at, name): &(usize, &Cow<str>)| !name.is_empty() && names.fields[..*at].contains(name);
    for (at, name) in names.fields.iter().enumerate().filter(again) {
        problems.0.push(error!("heading-twice", column = **name).at(names.cell(text.file, at)));
    }
    let mut table = Table { text, names, rows: Vec::new() };
    let mut ended = false;
    for (i, line) in text.lines.iter().enumerate().skip(1).filter(|(_, line)| !line.trim().is_empty()) {
        let row = split(i + 1);
        if ended {
            problems.0.push(error!("rows-after-end", end = "END").at(text.place(i + 1)));
            return table;
        }
        if line.trim() == "END" {
            ended = true;
        } else if row.fields.iter().skip(table.names.fields.len()).any(|f| !f.is_empty()) {
            let expected = phrase!("fields-like", like = "header", width = table.names.fields.len());
            problems.0.push(error!("row-field-count", fields = row.fields.len(), expected).at(text.place(i + 1)));
        } else {
            table.rows.push(row);
        }
    }
    table
}

/// One point for each feature and run that has the three coordinates.
fn characteristics(table: &Table, decimal: Decimal, unit: Unit, problems: &mut Problems) -> Vec<Point> {
    let column = |name: &str| table.column(name);
    let (feature, symbol, actual) = (column("featureid"), column("idsymbol"), column("actual"));
    let mut pivot = Pivot::default();
    for row in &table.rows {
        let cell = |at: Option<usize>| table.cell(Some(row), at);
        let (label, symbol) = (cell(feature), cell(symbol));
        let run = format!("{}\t{}", cell(column("planid")), cell(column("partnb")));
        if label.is_empty() || symbol.is_empty() {
            let column = if label.is_empty() { "featureid" } else { "idsymbol" };
            problems.0.push(error!("cell-empty", column).at(row.place(table.text.file)));
            continue;
        }
        let said = match ["xValue", "yValue", "zValue"].iter().position(|axis| *axis == symbol) {
            Some(axis) => match coordinate(table, row, actual, decimal) {
                Ok(value) => {
                    let stated = check_unit(table, row, unit);
                    problems.0.extend(stated.err());
                    Said::Coordinate(axis, value)
                }
                Err(message) => {
                    problems.0.push(message);
                    continue;
                }
            },
            None => Said::Other(symbol.to_owned()),
        };
        pivot.add(row.line, label, &run, said);
    }
    pivot.rows(table.text, unit)
}

/// One point for each row.
fn features(table: &Table, decimal: Decimal, unit: Unit, problems: &mut Problems) -> Vec<Point> {
    let label = table.column("featureid").or(table.column("id"));
    let axes = ["x", "y", "z"].map(|axis| table.column(axis));
    let mut points = Vec::new();
    for row in &table.rows {
        let name = table.cell(Some(row), label);
        if axes.iter().all(|at| table.cell(Some(row), *at).is_empty()) {
            points.push(table.text.no_point(row.line, name, phrase!("row-without-coordinates")));
            continue;
        }
        let xyz = axes.map(|at| {
            coordinate(table, row, at, decimal).unwrap_or_else(|message| {
                problems.0.push(message);
                f64::NAN
            })
        });
        problems.0.extend(check_unit(table, row, unit).err());
        points.push(table.text.point(row.line, name, xyz, unit));
    }
    points
}

fn coordinate(table: &Table, row: &Fields, at: Option<usize>, decimal: Decimal) -> Result<f64, Message> {
    let cell = table.cell(Some(row), at);
    number(cell, decimal).map_err(|message| {
        let place = match at {
            Some(at) if at < row.fields.len() => table.place(row, at),
            _ => row.place(table.text.file),
        };
        decimal_comma(message, cell, "calypso").at(place)
    })
}

/// Returns an error if the unit of the row differs from the unit of the campaign; older versions do
/// not state it.
fn check_unit(table: &Table, row: &Fields, stated: Unit) -> Result<(), Message> {
    let Some(at) = table.column("unit") else { return Ok(()) };
    let of_file = match row.field(at) {
        "" => return Ok(()),
        "mm" => Unit::Millimetre,
        "inch" | "in" => Unit::Inch,
        "m" => Unit::Metre,
        "um" | "µm" | "μm" => Unit::Micrometre,
        other => {
            let message = error!("unit-unknown", unit = other, units = ["mm", "m", "um", "inch"]);
            return Err(message.at(table.place(row, at)));
        }
    };
    unit_agrees(stated, of_file, &"unit", table.place(row, at))
}
