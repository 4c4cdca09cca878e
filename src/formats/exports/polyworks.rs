//! PolyWorks point text: `[name] x y z [i j k]`, blank-separated, no header, decimal point.

use super::{About, ExportFormat, ExportRow, Plain, Text, WriteError, Writing};
use crate::dialect::{Dialect, Unit};
use crate::points::{Line, Names, Point, SharedText};
use etalon_base::message::Problems;
use etalon_base::{error, phrase};
use etalon_tables::lexer::{self, PlainColumn, lines, number};
use etalon_tables::{Decimal, Delimiter, Form};

/// Point text of PolyWorks.
pub(super) struct Polyworks;

impl ExportFormat for Polyworks {
    fn about(&self) -> About {
        About { name: "polyworks", title: "PolyWorks text", by_rows: true, ..About::default() }
    }

    fn read(&self, text: &Text, _dialect: &Dialect, unit: Unit) -> (Vec<Point>, Problems) {
        rows(text.file, text.whole, unit)
    }

    fn write(&self, rows: &[ExportRow], how: &Writing) -> Result<String, WriteError> {
        let line = |row: &ExportRow| format!("{} {}\n", lexer::blank(&row.label, false), how.list(row, " "));
        Ok(rows.iter().map(line).collect())
    }

    /// The first row determines whether rows have labels.
    fn plain(&self, _dialect: &Dialect, start: &str, _unit: Unit) -> Option<Plain> {
        let first = start.lines().find(|line| !line.trim().is_empty()).unwrap_or_default();
        let columns = match first.split_ascii_whitespace().count() {
            3 => &LABEL_AND_XYZ[1..],
            4 => &LABEL_AND_XYZ,
            _ => return None,
        };
        Some(Plain::new(Delimiter::Blank, Decimal::Point, columns))
    }
}

/// Columns of a row with a label.
const LABEL_AND_XYZ: [PlainColumn; 4] =
    [PlainColumn::Label, PlainColumn::Coordinate(0), PlainColumn::Coordinate(1), PlainColumn::Coordinate(2)];

/// Points of a PolyWorks text, and problems; directions are not read.
fn rows(file: &str, text: &SharedText, unit: Unit) -> (Vec<Point>, Problems) {
    let mut problems = Problems::default();
    let mut points = Vec::new();
    let mut names = Names::default();
    let form = Form::delimited(Delimiter::Blank);
    for (i, line) in lines(text, &form) {
        if let Some((label, xyz)) = lexer::plain_line(line, Delimiter::Blank, Decimal::Point, &LABEL_AND_XYZ) {
            points.push(Point::from_line(i, Line::from_part(text, line), names.shared(label), xyz, unit));
            continue;
        }
        let row = match lexer::row(file, i, line, &form) {
            Ok(row) => row,
            Err(message) => {
                problems.0.push(message);
                continue;
            }
        };
        let named = match row.fields.len() {
            3 | 6 => 0,
            4 | 7 => 1,
            n => {
                let message = error!("row-field-count", fields = n, expected = phrase!("polyworks-fields"));
                problems.0.push(message.hint(phrase!("quote-names")).at(row.place(file)));
                continue;
            }
        };
        let mut numbers = Vec::new();
        for (at, field) in row.fields.iter().enumerate().skip(named) {
            numbers.push(number(field, Decimal::Point).unwrap_or_else(|message| {
                problems.0.push(message.at(row.cell(file, at)));
                f64::NAN
            }));
        }
        let label = names.shared(if named == 1 { row.field(0) } else { "" });
        let xyz = [numbers[0], numbers[1], numbers[2]];
        points.push(Point::from_line(row.line, Line::from_part(text, row.text), label, xyz, unit));
    }
    (points, problems)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_and_directions_are_optional() {
        let (points, problems) =
            rows("f", &"K_1_2 1.5 -2 3e1\n4 5 6 0 0 1\r\n\n\"ball N\" 7 8 9 1 0 0\n".into(), Unit::Millimetre);
        assert!(problems.0.is_empty());
        let found: Vec<(&str, [f64; 3], u32)> = points.iter().map(|p| (&*p.label, p.xyz_mm, p.line)).collect();
        assert_eq!(found, [("K_1_2", [1.5, -2.0, 30.0], 1), ("", [4.0, 5.0, 6.0], 2), ("ball N", [7.0, 8.0, 9.0], 4)]);
    }

    #[test]
    fn every_wrong_row_is_reported() {
        let (points, problems) = rows("f", &"1 1 2\nL 1,5 2 3\nM 1 2 3,5\n1 2\n".into(), Unit::Millimetre);
        let lines: Vec<_> = problems.0.iter().map(|m| m.place.as_ref().and_then(|p| p.line)).collect();
        assert_eq!(lines, [Some(2), Some(3), Some(4)]);
        assert_eq!(problems.0[1].place.as_ref().and_then(|p| p.column), Some(7));
        assert_eq!(points.iter().map(|p| &*p.label).collect::<Vec<_>>(), ["", "L", "M"]);
    }
}
