//! VDA-FS (DIN 66301): measured points as `POINT/x,y,z`, `PSET/n,x1,y1,z1,...` and `MDI/n,x1,y1,z1,i1,j1,k1,...`. Curves and
//! surfaces are geometry, no points.
//!
//! A line may end in its number, eight digits in columns 73 to 80: they are taken away where they are the number of the
//! line. `$$` begins a comment; the file ends with `NAME = END`. Checked with geometry files of others; of measured points no
//! real file was found.

use super::{About, ExportFormat, ExportRow, Recognised, Text, Writing, head};
use crate::Point;
use crate::dialect::{Decimal, Dialect, Unit};
use crate::lexer::number;
use etalon_base::message::{Message, Problems};
use std::collections::BTreeMap;

/// Points of VDA-FS.
pub(super) struct VdaFs;

impl ExportFormat for VdaFs {
    fn about(&self) -> About {
        About { name: "vda_fs", title: "VDA-FS", ..About::default() }
    }

    fn recognise(&self, text: &str) -> Option<Recognised> {
        Recognised::by(head(text).contains("= HEADER /"), 0.9, "a VDA-FS file, by its header")
    }

    fn read(&self, text: &Text, _dialect: &Dialect, unit: Unit) -> (Vec<Point>, Problems) {
        rows(text, unit)
    }

    fn write(&self, rows: &[ExportRow], how: &Writing) -> Result<String, Message> {
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
    /// Numbers of each point: its coordinates, of an MDI its direction too.
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
                let stated = count.parse::<usize>().ok().and_then(|n| n.checked_mul(per_point));
                if stated != Some(fields.len()) {
                    let what = format!("`{}` states {count} points, and has {} numbers", entity.name, fields.len());
                    let message = Message::error(what).at(text.part(*line, *byte, count.len()));
                    problems.0.push(message.expected(format!("{per_point} numbers a point")));
                }
                points.extend(coordinates(text, entity, fields, unit, &mut problems));
            }
            "HEADER" | "END" => {}
            kind => *others.entry(kind).or_default() += 1,
        }
    }
    if points.is_empty() {
        let found: Vec<String> = others.iter().map(|(kind, n)| format!("{n} {kind}")).collect();
        let found = if found.is_empty() { "nothing else".to_owned() } else { found.join(", ") };
        let message = Message::error(format!("the file holds no measured points, but {found}")).at(text.place(1));
        let message = message.expected("POINT, PSET or MDI");
        problems.0.push(message.hint("export the measured points, not the geometry of the part"));
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
            let message = Message::error(format!("the last point of `{}` has {} numbers", entity.name, chunk.len()));
            problems.0.push(message.at(text.place(line)).expected(per_point.to_string()).hint("was the file cut off?"));
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
                let message = Message::error("this is no VDA-FS file").at(text.place(i + 1));
                problems.0.push(message.expected("`NAME = HEADER / n`"));
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
    let message = Message::error("the file has no end").at(text.place(text.lines.len()));
    problems.0.push(
        message.expected("`NAME = END`").hint("export it again if it was cut off; if it is whole, add that line"),
    );
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
    let message = Message::error(format!("columns 73 to 80 hold `{digits}`: a number of the line, or a value?"));
    Err(message
        .expected(format!("{number:08}, the number of this line"))
        .hint("write the file without numbers of lines"))
}
