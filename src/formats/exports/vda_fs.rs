//! VDA-FS (DIN 66301): measured points as `POINT/x,y,z`, `PSET/n,x1,y1,z1,...` and
//! `MDI/n,x1,y1,z1,i1,j1,k1,...`. Curves and surfaces are geometry, not points.
//!
//! A line may end in its number, eight digits in columns 73 to 80; they are removed if they are the
//! number of the line. `$$` begins a comment; the file ends with `NAME = END`. Checked with
//! geometry files of other authors; no real file of measured points was found.

use super::{About, ExportFormat, ExportRow, Recognised, Text, WriteError, Writing, head, not_this_format};
use crate::Point;
use crate::dialect::{Dialect, Unit};
use etalon_base::catalogue::IntoArgument;
use etalon_base::message::{Message, Problems};
use etalon_base::{error, phrase};
use etalon_tables::Decimal;
use etalon_tables::lexer::number;
use std::collections::BTreeMap;

/// Points of VDA-FS.
pub(super) struct VdaFs;

impl ExportFormat for VdaFs {
    fn about(&self) -> About {
        About { name: "vda_fs", title: "VDA-FS", ..About::default() }
    }

    fn recognise(&self, text: &str) -> Option<Recognised> {
        Recognised::by(head(text).contains("= HEADER /"), 0.9, phrase!("is-vda-fs"))
    }

    fn read(&self, text: &Text, _dialect: &Dialect, unit: Unit) -> (Vec<Point>, Problems) {
        rows(text, unit)
    }

    fn write(&self, rows: &[ExportRow], how: &Writing) -> Result<String, WriteError> {
        let point = |row: &ExportRow| format!("{} = POINT / {}\n", row.label, how.list(row, ", "));
        let points: String = rows.iter().map(point).collect();
        Ok(format!("SIMULATED = HEADER / 0\n{points}SIMULATED = END\n"))
    }
}

/// An entity: `name = KIND / parameters`, with the line and byte of each parameter.
struct Entity<'a> {
    name: &'a str,
    kind: &'a str,
    line: usize,
    fields: Vec<(usize, usize, &'a str)>,
}

impl Entity<'_> {
    /// Numbers of each point: its coordinates, and the direction of an MDI.
    fn per_point(&self) -> usize {
        if self.kind == "MDI" { 6 } else { 3 }
    }
}

/// The points; a label is the name of the entity.
fn rows(text: &Text, unit: Unit) -> (Vec<Point>, Problems) {
    let mut problems = Problems::default();
    let entities = entities(text, &mut problems);
    let (mut points, mut others) = (Vec::new(), BTreeMap::<&str, usize>::new());
    for entity in &entities {
        match entity.kind {
            "POINT" => points.extend(coordinates(text, entity, &entity.fields, unit, &mut problems)),
            "PSET" | "MDI" => {
                let per_point = entity.per_point();
                let Some(((line, byte, count), fields)) = entity.fields.split_first() else { continue };
                let at = || text.part(*line, *byte, count.len());
                match count.parse::<usize>() {
                    Ok(count) if count.saturating_mul(per_point) == fields.len() => {}
                    Ok(count) => {
                        let (stated, found) = (count.saturating_mul(per_point), fields.len());
                        problems.0.push(error!("stated-count-differs", name = entity.name, stated, found).at(at()));
                    }
                    Err(_) => {
                        let valid = phrase!("whole-number");
                        let message = error!("record-invalid", text = *count, format = "vda_fs", valid);
                        problems.0.push(message.at(at()));
                    }
                }
                points.extend(coordinates(text, entity, fields, unit, &mut problems));
            }
            "HEADER" | "END" => {}
            kind => *others.entry(kind).or_default() += 1,
        }
    }
    if points.is_empty() {
        let contents: Vec<String> = others.iter().map(|(kind, n)| format!("{n} {kind}")).collect();
        let contents = if contents.is_empty() { "none".argument() } else { contents.argument() };
        let message = error!("no-measured-points", contents, records = "POINT, PSET, MDI").at(text.place(1));
        problems.0.push(message.hint(phrase!("export-measured-points")));
    }
    (points, problems)
}

/// The points of an entity whose numbers are `fields`.
fn coordinates(
    text: &Text,
    entity: &Entity,
    fields: &[(usize, usize, &str)],
    unit: Unit,
    problems: &mut Problems,
) -> Vec<Point> {
    let (mut points, per_point) = (Vec::new(), entity.per_point());
    for chunk in fields.chunks(per_point) {
        let mut values = Vec::with_capacity(chunk.len());
        for (line, byte, field) in chunk {
            // Fortran writes an exponent with D
            match number(&field.replace(['D', 'd'], "E"), Decimal::Point) {
                Ok(value) => values.push(value),
                Err(message) => problems.0.push(message.at(text.part(*line, *byte, field.chars().count()))),
            }
        }
        let line = chunk.first().map_or(entity.line, |field| field.0);
        if chunk.len() < per_point {
            let (found, counts) = (chunk.len(), [per_point]);
            let message = error!("number-count-differs", name = entity.name, found, counts);
            problems.0.push(message.at(text.place(line)));
        }
        let whole = values.len() == per_point;
        let xyz = if whole { [values[0], values[1], values[2]] } else { [f64::NAN; 3] };
        points.push(text.point(line, entity.name, xyz, unit));
    }
    points
}

/// All entities up to the end.
fn entities<'a>(text: &'a Text, problems: &mut Problems) -> Vec<Entity<'a>> {
    let mut all: Vec<Entity> = Vec::new();
    let mut prose = 0usize;
    for (i, line) in text.lines.iter().enumerate() {
        if prose > 0 {
            prose -= 1;
            continue;
        }
        let line = match without_number(line, i + 1) {
            Ok(line) => line,
            Err(message) => {
                problems.0.push(message.at(text.place(i + 1)));
                continue;
            }
        };
        let line = line.split("$$").next().unwrap_or("");
        let mut from = 0;
        if let Some((name, rest)) = line.split_once('=') {
            let kind = rest.split('/').next().unwrap_or("").trim();
            all.push(Entity { name: name.trim(), kind, line: i + 1, fields: Vec::new() });
            from = line.find('/').map_or(line.len(), |slash| slash + 1);
            if kind == "END" {
                return all;
            }
            if kind == "HEADER" {
                prose = line[from..].trim().parse().unwrap_or(0);
                continue;
            }
        }
        let Some(entity) = all.last_mut() else {
            if !line.trim().is_empty() {
                let signature = phrase!("begins-with", text = "NAME = HEADER / n");
                problems.0.push(not_this_format("vda_fs", &signature).at(text.place(i + 1)));
                return all;
            }
            continue;
        };
        for field in line[from..].split(',') {
            let byte = from + field.len() - field.trim_start().len();
            entity.fields.extend(Some((i + 1, byte, field.trim())).filter(|f| !f.2.is_empty()));
            from += field.len() + 1;
        }
    }
    let message = error!("file-cut-off", missing = "`NAME = END`").at(text.place(text.lines.len()));
    problems.0.push(message.hint(phrase!("export-again-or-add", line = "NAME = END")));
    all
}

/// A line without its number in columns 73 to 80.
fn without_number(line: &str, number: usize) -> Result<&str, Message> {
    let (Some(text), Some(digits)) = (line.get(..72), line.get(72..)) else { return Ok(line) };
    if digits.len() != 8 || !digits.bytes().all(|b| b.is_ascii_digit()) {
        return Ok(line);
    }
    if digits.parse() == Ok(number) {
        return Ok(text);
    }
    Err(error!("line-number-differs", digits, number = format!("{number:08}")))
}
