//! PolyWorks|Inspector project description: blocks `BEGIN OBJECT 1 ... END OBJECT 1` of lines
//! `KEY = values`, separated by tabs. Point primitives are its points; names that are not ASCII are
//! `UNICODE( hexadecimal UTF-16 )`.

use super::{About, ExportFormat, ExportRow, Recognised, Text, WriteError, Writing, head, not_this_format};
use crate::Point;
use crate::dialect::{Dialect, Unit};
use etalon_base::message::Problems;
use etalon_base::{error, phrase};
use etalon_tables::Decimal;
use etalon_tables::lexer::parsed;
use std::collections::BTreeMap;

/// Project descriptions of PolyWorks|Inspector.
pub(super) struct PolyworksProject;

impl ExportFormat for PolyworksProject {
    fn about(&self) -> About {
        About { name: "polyworks_project", title: "PolyWorks project description", ..About::default() }
    }

    fn recognise(&self, text: &str) -> Option<Recognised> {
        Recognised::by(
            head(text).contains("PolyWorks|Inspector project description"),
            0.9,
            phrase!("is-polyworks-project"),
        )
    }

    fn read(&self, text: &Text, _dialect: &Dialect, unit: Unit) -> (Vec<Point>, Problems) {
        rows(text, unit)
    }

    fn write(&self, rows: &[ExportRow], how: &Writing) -> Result<String, WriteError> {
        let object = |(i, row): (usize, &ExportRow)| {
            let (name, point) = (utf_16(&row.label), how.list(row, "\t"));
            format!(
                "BEGIN OBJECT {i}\nCLASS\t=\tPrimitive\nTYPE\t=\tPoint\nNAME\t=\t{name}\nPOINT\t=\t{point}\nEND OBJECT {i}\n\n"
            )
        };
        let objects: String = rows.iter().enumerate().map(object).collect();
        Ok(format!("# === PolyWorks|Inspector project description file ===\n\n{objects}"))
    }
}

/// Maximum nesting of blocks; real files have three levels.
const DEEPEST: usize = 32;

/// An open block: its name, its beginning, and the keys of an object.
struct Block<'a> {
    name: &'a str,
    line: usize,
    keys: BTreeMap<&'a str, (usize, &'a str)>,
}

/// The point primitives.
fn rows(text: &Text, unit: Unit) -> (Vec<Point>, Problems) {
    let mut problems = Problems::default();
    let mut points = Vec::new();
    if !text.lines.first().is_some_and(|line| line.contains("PolyWorks|Inspector project description file")) {
        let signature = phrase!("begins-with", text = "# === PolyWorks|Inspector project description file ===");
        problems.0.push(not_this_format("polyworks_project", &signature).at(text.place(1)));
        return (points, problems);
    }
    let mut open: Vec<Block> = Vec::new();
    for (i, line) in text.lines.iter().enumerate() {
        let at = || text.place(i + 1);
        let line = line.trim();
        if let Some(name) = line.strip_prefix("BEGIN ") {
            if open.len() == DEEPEST {
                let message = error!("nested-too-deep", name, depth = DEEPEST + 1, most = DEEPEST);
                problems.0.push(message.at(at()));
                return (points, problems);
            }
            open.push(Block { name, line: i + 1, keys: BTreeMap::new() });
        } else if let Some(name) = line.strip_prefix("END ") {
            let Some(block) = open.pop().filter(|block| block.name == name) else {
                let needed = format!("BEGIN {name}");
                problems.0.push(error!("record-too-early", record = line, needed).at(at()));
                return (points, problems);
            };
            if name.starts_with("OBJECT ") {
                points.extend(primitive(text, &block, unit, &mut problems));
            }
        } else if let (Some((key, value)), Some(block)) = (line.split_once('='), open.last_mut()) {
            block.keys.insert(key.trim(), (i + 1, value.trim()));
        }
    }
    if let Some(block) = open.first() {
        let missing = format!("`END {}`", block.name);
        problems.0.push(error!("file-cut-off", missing).at(text.place(block.line)));
    }
    (points, problems)
}

/// A point, or the reason why a primitive is not a point; other objects are not primitives.
fn primitive(text: &Text, block: &Block, unit: Unit, problems: &mut Problems) -> Option<Point> {
    let value = |key: &str| block.keys.get(key).map(|(_, value)| *value);
    if value("CLASS") != Some("Primitive") {
        return None;
    }
    let label = match block.keys.get("NAME") {
        Some((line, name)) => decode_name(name).unwrap_or_else(|| {
            let valid = phrase!("unicode-in-hexadecimal");
            let message = error!("record-invalid", text = name, format = "polyworks_project", valid);
            problems.0.push(message.at(text.place(*line)));
            String::new()
        }),
        None => String::new(),
    };
    let kind = value("TYPE").unwrap_or_default();
    let Some((line, stated)) = block.keys.get("POINT").filter(|_| kind == "Point") else {
        return Some(text.no_point(block.line, &label, phrase!("primitive-no-point", kind)));
    };
    let numbers: Vec<f64> = stated.split_whitespace().filter_map(|n| parsed(n, Decimal::Point, None)).collect();
    let scaled = value("SCALING_FACTOR").is_some_and(|factor| parsed(factor, Decimal::Point, None) != Some(1.0));
    let message = match (numbers[..].try_into(), stated.split_whitespace().count(), scaled) {
        (Ok(xyz), 3, false) => return Some(text.point(*line, &label, xyz, unit)),
        (_, _, true) => error!("element-unsupported", element = "SCALING_FACTOR"),
        _ => {
            error!("record-invalid", text = *stated, format = "polyworks_project", valid = phrase!("three-numbers"))
        }
    };
    problems.0.push(message.at(text.place(*line)));
    Some(text.point(*line, &label, [f64::NAN; 3], unit))
}

/// A name in the notation of PolyWorks: code units in hexadecimal if it is not ASCII.
fn utf_16(label: &str) -> String {
    if label.is_ascii() {
        return label.to_owned();
    }
    let units: String = label.encode_utf16().map(|unit| format!("{unit:04X}")).collect();
    format!("UNICODE( {units} )")
}

/// A name as plain text, or from its UTF-16 code units in hexadecimal, most significant first.
fn decode_name(text: &str) -> Option<String> {
    let Some(coded) = text.strip_prefix("UNICODE(") else { return Some(text.to_owned()) };
    let digits = coded.strip_suffix(')')?.trim();
    if !digits.is_ascii() || digits.len() % 4 != 0 {
        return None;
    }
    let unit = |i: usize| digits.get(4 * i..4 * i + 4).and_then(|hex| u16::from_str_radix(hex, 16).ok());
    let units: Vec<u16> = (0..digits.len() / 4).map(unit).collect::<Option<_>>()?;
    String::from_utf16(&units).ok()
}

#[cfg(test)]
mod tests {
    use super::decode_name;

    #[test]
    fn names_in_utf_16_are_read() {
        // "probed points 1" in Chinese, as a real file has it
        assert_eq!(decode_name("UNICODE( 63A26D4B768470B900200031 )").as_deref(), Some("探测的点 1"));
        assert_eq!(decode_name("pos1 -meas-").as_deref(), Some("pos1 -meas-"));
        for wrong in ["UNICODE( 63A )", "UNICODE( D800 )", "UNICODE( 63A2", "UNICODE( 63x2 )", "UNICODE( ßß )"] {
            assert_eq!(decode_name(wrong), None, "{wrong}");
        }
    }
}
