//! PC-DMIS `.xyz`: a first line `XYZIJK`, `METRIC` in its columns 11 to 16 (without it the file is in inch), then numbers
//! separated by commas: 3 are a point, 4 a point and a diameter, 6 a point and a vector, 7 both and a diameter; 5, 8 and more
//! have numbers that mean nothing. Source: PC-DMIS 2019 R1, "Notes on XYZ Files".

use super::{About, ExportFormat, ExportRow, Recognised, Text, Writing, unit_agrees};
use crate::Point;
use crate::dialect::{Decimal, Dialect, Unit};
use crate::lexer::{Row as Fields, number};
use etalon_base::message::{Message, Problems};

/// Files `.xyz` of PC-DMIS.
pub(super) struct PcdmisXyz;

impl ExportFormat for PcdmisXyz {
    fn about(&self) -> About {
        About { name: "pcdmis_xyz", title: "PC-DMIS xyz", ..About::default() }
    }

    fn recognise(&self, text: &str) -> Option<Recognised> {
        Recognised::by(text.starts_with("XYZIJK"), 1.0, "an .xyz file of PC-DMIS, by its first line")
    }

    fn read(&self, text: &Text, _dialect: &Dialect, unit: Unit) -> (Vec<Point>, Problems) {
        rows(text, unit)
    }

    fn write(&self, rows: &[ExportRow], how: &Writing) -> Result<String, Message> {
        let head = how.unit_in(&[(Unit::Millimetre, "XYZIJK    METRIC"), (Unit::Inch, "XYZIJK")])?;
        let points: String = rows.iter().map(|row| how.list(row, ",") + "\n").collect();
        Ok(format!("{head}\n{points}"))
    }
}

/// The points.
fn rows(text: &Text, unit: Unit) -> (Vec<Point>, Problems) {
    let mut problems = Problems::default();
    match head(text.shown(1)) {
        Ok((of_file, how)) => problems.0.extend(unit_agrees(unit, of_file, how, text.place(1)).err()),
        Err(message) => {
            problems.0.push(message.at(text.place(1)));
            return (Vec::new(), problems);
        }
    }
    let mut points = Vec::new();
    for (i, line) in text.lines.iter().enumerate().skip(1).filter(|(_, line)| !line.trim().is_empty()) {
        let row = Fields::of(i + 1, line, line.split(',').map(str::trim));
        if row.fields.len() < 3 {
            let message = Message::error(format!("the row has {} fields", row.fields.len())).at(text.place(i + 1));
            let message = message.expected("three to eight numbers separated by commas");
            problems.0.push(message.hint("a file with names or tabs is not a PC-DMIS xyz: state it as delimited text"));
            continue;
        }
        let mut values = Vec::new();
        for (at, field) in row.fields.iter().enumerate() {
            match number(field, Decimal::Point) {
                Ok(value) => values.push(value),
                Err(message) => problems.0.push(message.at(row.cell(text.file, at))),
            }
        }
        let xyz = if values.len() == row.fields.len() { [values[0], values[1], values[2]] } else { [f64::NAN; 3] };
        points.push(text.point(i + 1, "", xyz, unit));
    }
    (points, problems)
}

/// The unit of the file by its first line.
fn head(line: &str) -> Result<(Unit, &'static str), Message> {
    let expected = "`XYZIJK` in columns 1 to 6, and `METRIC` in columns 11 to 16 of a metric file";
    let Some(rest) = line.strip_prefix("XYZIJK") else {
        return Err(Message::error("this is not a PC-DMIS xyz file").expected(expected));
    };
    match (rest.get(..4), rest.get(4..).map(str::trim_end), rest.trim()) {
        (_, _, "") => Ok((Unit::Inch, "no METRIC in line 1")),
        (Some("    "), Some("METRIC"), _) => Ok((Unit::Millimetre, "METRIC in line 1")),
        (.., "METRIC") => Err(Message::error(
            "`METRIC` is not in columns 11 to 16: by PC-DMIS' rule the file is in inch, by its word in mm",
        )
        .expected(expected)
        .hint("ask who wrote it, then correct line 1, or state it as delimited text with its unit")),
        _ => Err(Message::error(format!("`{}` means nothing after `XYZIJK`", rest.trim())).expected(expected)),
    }
}
