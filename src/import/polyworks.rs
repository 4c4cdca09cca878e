//! PolyWorks point text: `[name] x y z [i j k]`, blank-separated, no header, decimal point.

use super::delimited::{blank_fields, number};
use super::points::PointRow;
use crate::campaign::Decimal;
use crate::message::{Message, Place, Problems, Result};

/// Points of a PolyWorks text; directions are not read.
pub(super) fn rows(file: &str, text: &str) -> Result<Vec<PointRow>> {
    let mut problems = Problems::default();
    let mut points = Vec::new();
    for (i, line) in text.lines().enumerate() {
        if line.trim().is_empty() {
            continue;
        }
        let place = || Place::line(file, i + 1, line);
        let fields = blank_fields(line);
        let (label, numbers) = match fields.len() {
            3 | 6 => ("", &fields[..]),
            4 | 7 => (fields[0].as_str(), &fields[1..]),
            n => {
                problems.0.push(
                    Message::error(format!("the row has {n} fields"))
                        .at(place())
                        .expected("`x y z`, `x y z i j k`, or the same with a name before it")
                        .hint("quote names that hold blanks, or describe the file with `format = { delimiter = .. }`"),
                );
                continue;
            }
        };
        let parsed: std::result::Result<Vec<f64>, Message> =
            numbers.iter().map(|f| number(f, Decimal::Point)).collect();
        match parsed {
            Ok(n) => points.push(PointRow {
                line: i + 1,
                text: line.to_owned(),
                label: label.to_owned(),
                xyz: [n[0], n[1], n[2]],
                ..PointRow::default()
            }),
            Err(message) => problems.0.push(message.at(place())),
        }
    }
    problems.check()?;
    Ok(points)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_and_directions_are_optional() {
        let points = rows("f", "K_1_2 1.5 -2 3e1\n4 5 6 0 0 1\r\n\n\"ball N\" 7 8 9 1 0 0\n").unwrap();
        let found: Vec<(&str, [f64; 3], usize)> = points.iter().map(|p| (p.label.as_str(), p.xyz, p.line)).collect();
        assert_eq!(found, [("K_1_2", [1.5, -2.0, 30.0], 1), ("", [4.0, 5.0, 6.0], 2), ("ball N", [7.0, 8.0, 9.0], 4)]);
    }

    #[test]
    fn every_wrong_row_is_reported() {
        let problems = rows("f", "K 1 2\nL 1,5 2 3\nM 1 2 3\n1 2\n").unwrap_err();
        let lines: Vec<_> = problems.0.iter().map(|m| m.place.as_ref().and_then(|p| p.line)).collect();
        assert_eq!(lines, [Some(1), Some(2), Some(4)]);
    }
}
