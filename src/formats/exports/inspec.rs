//! Micro-Vu InSpec export: rows `"feature: property",value`, and points
//! `"feature: 3D MCS Points",x,y,z` or this label alone, followed by unlabelled rows `x,y,z`.
//!
//! Measured points have the name of the feature; a location or centre that the machine computed has
//! the name with the property: `Circle OD: Center`. A real file has single values without a label:
//! they are rejected.

use super::pivot::{Pivot, Said};
use super::{About, ExportFormat, ExportRow, Text, WriteError, Writing};
use crate::Point;
use crate::dialect::{Dialect, Unit};
use etalon_base::message::{Message, Problems};
use etalon_base::pose::Vector;
use etalon_base::{error, phrase};
use etalon_tables::Decimal;
use etalon_tables::lexer::{Row as Fields, number, parsed};

/// Exports of Micro-Vu InSpec.
pub(super) struct Inspec;

impl ExportFormat for Inspec {
    fn about(&self) -> About {
        About { name: "inspec", title: "Micro-Vu InSpec", ..About::default() }
    }

    fn read(&self, text: &Text, _dialect: &Dialect, unit: Unit) -> (Vec<Point>, Problems) {
        rows(text, unit)
    }

    fn write(&self, rows: &[ExportRow], how: &Writing) -> Result<String, WriteError> {
        Ok(rows.iter().map(|row| format!("\"{}: 3D MCS Points\",{}\n", row.label, how.list(row, ","))).collect())
    }
}

/// The measured points, and the computed ones.
fn rows(text: &Text, unit: Unit) -> (Vec<Point>, Problems) {
    let mut problems = Problems::default();
    let (mut points, mut computed) = (Vec::new(), Pivot::default());
    // the feature whose points follow, and the coordinates they are in
    let (mut open, mut system) = (None::<&str>, None::<&str>);
    for (i, line) in text.lines.iter().enumerate().filter(|(_, line)| !line.trim().is_empty()) {
        let at = || text.place(i + 1);
        let Some((label, values)) = labelled(line) else {
            if parsed(line.trim(), Decimal::Point, None).is_some() {
                points.push(text.no_point(i + 1, "", phrase!("value-without-label")));
                continue;
            }
            match (open, numbers(text, i + 1, line)) {
                (Some(feature), Ok(xyz)) => points.push(text.point(i + 1, feature, xyz, unit)),
                (_, Err(more)) => problems.0.extend(more),
                (None, Ok(_)) => {
                    let needed = "\"feature: 3D MCS Points\"";
                    problems.0.push(error!("record-too-early", record = line.trim(), needed).at(at()));
                }
            }
            continue;
        };
        open = None;
        let Some((feature, property)) = label.rsplit_once(": ") else {
            let valid = "\"feature: property\"";
            problems.0.push(error!("record-invalid", text = label, format = "inspec", valid).at(at()));
            continue;
        };
        if let Some(kind) = property.strip_suffix(" Points") {
            let known = *system.get_or_insert(kind);
            if !kind.starts_with("3D ") || kind != known {
                let needed = known.replace("2D", "3D");
                problems.0.push(error!("coordinate-system-differs", feature, found = kind, needed).at(at()));
            } else if values.is_empty() {
                open = Some(feature);
            } else {
                match numbers(text, i + 1, values) {
                    Ok(xyz) => points.push(text.point(i + 1, feature, xyz, unit)),
                    Err(more) => problems.0.extend(more),
                }
            }
            continue;
        }
        let place = |axis: &str| ["X", "Y", "Z"].iter().position(|a| *a == axis);
        if let Some((kind, axis)) = property.rsplit_once(' ').and_then(|(kind, axis)| Some((kind, place(axis)?))) {
            match number(values.trim(), Decimal::Point) {
                Ok(value) => computed.add(i + 1, &format!("{feature}: {kind}"), "", Said::Coordinate(axis, value)),
                Err(message) => problems.0.push(message.at(at())),
            }
        }
    }
    points.extend(computed.rows(text, unit));
    points.sort_by_key(|point| point.line);
    (points, problems)
}

/// Label in quotes, and the text after its comma.
fn labelled(line: &str) -> Option<(&str, &str)> {
    let (label, rest) = line.trim().strip_prefix('"')?.split_once('"')?;
    Some((label, rest.trim().strip_prefix(',').unwrap_or(rest).trim()))
}

/// Three numbers separated by commas.
fn numbers(text: &Text, line: usize, values: &str) -> Result<Vector, Vec<Message>> {
    let row = Fields::new(line, text.line_text(line), values.split(',').map(str::trim));
    if row.fields.len() != 3 {
        let message = error!("row-field-count", fields = row.fields.len(), expected = "x, y, z");
        return Err(vec![message.at(text.place(line))]);
    }
    let read: Vec<Result<f64, Message>> = row.fields.iter().map(|f| number(f, Decimal::Point)).collect();
    if let [Ok(x), Ok(y), Ok(z)] = read[..] {
        return Ok([x, y, z]);
    }
    let wrong = read.into_iter().enumerate().filter_map(|(at, value)| value.err().map(|m| (at, m)));
    Err(wrong.map(|(at, message)| message.at(row.cell(text.file, at))).collect())
}
