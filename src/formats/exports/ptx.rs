//! PTX of Leica Cyclone: scans one after the other, each with ten lines of head (columns, rows,
//! position and axes of the scanner, and the 4×4 matrix that places the points) and a line
//! `x y z intensity [r g b]` for each direction. `0 0 0` is a direction without an echo.
//!
//! The matrix multiplies row vectors from the right: its last row is the translation.

use super::{About, ExportFormat, ExportRow, Recognised, Text, WriteError, Writing, not_this_format};
use crate::Point;
use crate::dialect::{Dialect, Unit};
use etalon_base::message::{Message, Problems};
use etalon_base::pose::Vector;
use etalon_base::{error, phrase};
use etalon_tables::Decimal;
use etalon_tables::lexer::{Row as Fields, number, parsed};

/// Number of lines of the head of a scan.
const HEAD: usize = 10;

/// PTX scans.
pub(super) struct Ptx;

impl ExportFormat for Ptx {
    fn about(&self) -> About {
        About { name: "ptx", title: "PTX", ..About::default() }
    }

    fn recognise(&self, text: &str) -> Option<Recognised> {
        let lines: Vec<&str> = text.lines().take(HEAD).collect();
        Recognised::by(head(&lines).is_some(), 0.95, phrase!("is-ptx"))
    }

    fn read(&self, text: &Text, _dialect: &Dialect, unit: Unit) -> (Vec<Point>, Problems) {
        let (mut points, mut problems) = (Vec::new(), Problems::default());
        let mut at = 0;
        while text.lines.get(at).is_some_and(|line| !line.trim().is_empty()) {
            let Some(scan) = text.lines.get(at..at + HEAD).and_then(head) else {
                let signature = phrase!("begins-with", text = "4 4 0 0 0");
                problems.0.push(not_this_format("ptx", &signature).at(text.place(at + 1)));
                return (points, problems);
            };
            at += HEAD;
            let end = at.saturating_add(scan.count).min(text.lines.len());
            for line in at..end {
                match point(text, line + 1) {
                    Ok([0.0, 0.0, 0.0]) => points.push(text.no_point(line + 1, "", phrase!("row-at-origin"))),
                    Ok(xyz) => points.push(text.point(line + 1, "", scan.placed(xyz), unit)),
                    Err(message) => problems.0.push(message),
                }
            }
            if end - at < scan.count {
                let missing = phrase!("item-of-count", name = "ptx", number = end - at + 1, count = scan.count);
                problems.0.push(error!("file-cut-off", missing).at(text.place(end)));
            }
            at = end;
        }
        (points, problems)
    }

    /// One scan in the frame of the file.
    fn write(&self, rows: &[ExportRow], how: &Writing) -> Result<String, WriteError> {
        let axes = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n";
        let points: String = rows.iter().map(|row| how.list(row, " ") + " 0.5\n").collect();
        Ok(format!("1\n{}\n{axes}{points}", rows.len()))
    }
}

/// Head of a scan.
struct Scan {
    /// Number of its lines.
    count: usize,
    /// Matrix that places its points, row by row.
    matrix: [[f64; 4]; 4],
}

impl Scan {
    /// Position of a point in the frame of the file.
    fn placed(&self, [x, y, z]: Vector) -> Vector {
        let [a, b, c, d] = &self.matrix;
        std::array::from_fn(|k| x * a[k] + y * b[k] + z * c[k] + d[k])
    }
}

/// Head of a scan in ten lines; `None` for other lines.
fn head(lines: &[&str]) -> Option<Scan> {
    let numbers = |line: &str| -> Option<Vec<f64>> {
        line.split_whitespace().map(|word| parsed(word, Decimal::Point, None)).collect()
    };
    let [columns, rows, scanner @ .., a, b, c, d] = lines else { return None };
    let count = |line: &str| line.trim().parse::<usize>().ok();
    let whole = lines.len() == HEAD && scanner.iter().all(|line| numbers(line).is_some_and(|row| row.len() == 3));
    let row = |line: &str| <[f64; 4]>::try_from(numbers(line)?).ok();
    let matrix = [row(a)?, row(b)?, row(c)?, row(d)?];
    whole.then_some(Scan { count: count(columns)?.checked_mul(count(rows)?)?, matrix })
}

/// Coordinates of a line.
fn point(text: &Text, line: usize) -> Result<Vector, Message> {
    let row = Fields::new(line, text.line_text(line), text.line_text(line).split_whitespace());
    if row.fields.len() < 3 {
        let expected = phrase!("fields-of-columns", count = 4);
        return Err(error!("row-field-count", fields = row.fields.len(), expected).at(text.place(line)));
    }
    let value = |at: usize| number(row.field(at), Decimal::Point).map_err(|m| m.at(row.cell(text.file, at)));
    Ok([value(0)?, value(1)?, value(2)?])
}

#[cfg(test)]
mod tests {
    use crate::Format;
    use crate::dialect::Unit;

    /// Two scans; the second is turned by 90° about z.
    const SCANS: &str = "2\n1\n1000 -300 50\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n1000 -300 50 1\n\
        272.5 -45.25 40.75 0.5\n0 0 0 0.5\n1\n1\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 1 0 0\n-1 0 0 0\n0 0 1 0\n10 20 30 1\n1 2 3 0.5 9 8 7\n";

    #[test]
    fn the_matrix_of_each_scan_places_its_points() {
        let format = Format::named("ptx").unwrap();
        let (points, problems) = format.read("s.ptx", &SCANS.into(), Unit::Millimetre);
        assert!(problems.0.is_empty(), "{problems:?}");
        assert_eq!(points[0].xyz_mm, [1272.5, -345.25, 90.75]);
        assert!(points[1].refused.as_ref().is_some_and(|reason| reason.id == "row-at-origin"));
        assert_eq!(points[2].xyz_mm, [8.0, 21.0, 33.0]);
        assert_eq!(crate::propose("s.ptx", SCANS).format.as_deref(), Some("ptx"));
        let short = &SCANS[..SCANS.find("0 0 0 0.5").unwrap()];
        assert!(format.read("s.ptx", &short.into(), Unit::Millimetre).1.0[0].is("file-cut-off", &[]));
        let cut = SCANS.replace("1 0 0 0\n", "1 0 0\n");
        let (_, problems) = format.read("s.ptx", &cut.into(), Unit::Millimetre);
        assert!(problems.0[0].is("format-differs", &[]), "{problems:?}");
    }
}
