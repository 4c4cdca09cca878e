//! PC-DMIS `.xyz`: a first line `XYZIJK` with `METRIC` in columns 11 to 16 (without it the file is
//! in inches), then numbers separated by commas.
//!
//! Three numbers are a point, four a point and a diameter, six a point and a vector, seven both and
//! a diameter; rows of five, eight and more numbers have numbers without meaning. Source: PC-DMIS
//! 2019 R1, "Notes on XYZ Files".

use super::{About, ExportFormat, ExportRow, Recognised, Text, WriteError, Writing, not_this_format, unit_agrees};
use crate::Point;
use crate::dialect::{Dialect, Unit};
use etalon_base::catalogue::{Argument, IntoArgument};
use etalon_base::message::{Message, Problems};
use etalon_base::{error, phrase};
use etalon_tables::Decimal;
use etalon_tables::lexer::{Row as Fields, number};

/// Files `.xyz` of PC-DMIS.
pub(super) struct PcdmisXyz;

impl ExportFormat for PcdmisXyz {
    fn about(&self) -> About {
        About { name: "pcdmis_xyz", title: "PC-DMIS xyz", ..About::default() }
    }

    fn recognise(&self, text: &str) -> Option<Recognised> {
        Recognised::by(text.starts_with("XYZIJK"), 1.0, phrase!("is-pcdmis"))
    }

    fn read(&self, text: &Text, _dialect: &Dialect, unit: Unit) -> (Vec<Point>, Problems) {
        rows(text, unit)
    }

    fn write(&self, rows: &[ExportRow], how: &Writing) -> Result<String, WriteError> {
        let head = how.unit_in(&[(Unit::Millimetre, "XYZIJK    METRIC"), (Unit::Inch, "XYZIJK")])?;
        let points: String = rows.iter().map(|row| how.list(row, ",") + "\n").collect();
        Ok(format!("{head}\n{points}"))
    }
}

/// The points.
fn rows(text: &Text, unit: Unit) -> (Vec<Point>, Problems) {
    let mut problems = Problems::default();
    match head(text.line_text(1)) {
        Ok((of_file, how)) => problems.0.extend(unit_agrees(unit, of_file, &how, text.place(1)).err()),
        Err(message) => {
            problems.0.push(message.at(text.place(1)));
            return (Vec::new(), problems);
        }
    }
    let mut points = Vec::new();
    for (i, line) in text.lines.iter().enumerate().skip(1).filter(|(_, line)| !line.trim().is_empty()) {
        let row = Fields::new(i + 1, line, line.split(',').map(str::trim));
        if row.fields.len() < 3 {
            let expected = phrase!("three-to-eight-numbers");
            let message = error!("row-field-count", fields = row.fields.len(), expected).at(text.place(i + 1));
            problems.0.push(message.hint(phrase!("state-as-delimited")));
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

/// Unit of the file from its first line.
fn head(line: &str) -> Result<(Unit, Argument), Message> {
    let Some(rest) = line.strip_prefix("XYZIJK") else {
        return Err(not_this_format("pcdmis_xyz", &phrase!("begins-with", text = "XYZIJK")));
    };
    match (rest.get(..4), rest.get(4..).map(str::trim_end), rest.trim()) {
        (_, _, "") => Ok((Unit::Inch, phrase!("default-of-format", record = "METRIC").argument())),
        (Some("    "), Some("METRIC"), _) => Ok((Unit::Millimetre, "METRIC".argument())),
        (.., "METRIC") => Err(error!("metric-misplaced")),
        (.., text) => Err(error!("record-invalid", text, format = "pcdmis_xyz", valid = "XYZIJK    METRIC")),
    }
}
