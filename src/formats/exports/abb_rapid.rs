//! ABB RAPID modules (`.mod`, `.prg`): the robtargets in declarations and in move instructions, in
//! millimetres and in the work object of the instruction. They are taught or computed, not
//! measured.
//!
//! A robtarget is `[[x, y, z], [q1, q2, q3, q4], [configuration], [external axes]]` with the scalar
//! `q1` first. A jointtarget has no coordinates. Source: ABB, "RAPID instructions, functions and
//! data types" (3HAC16581-1).

use super::{About, ExportFormat, ExportRow, Recognised, Text, WriteError, Writing, head, unit_agrees};
use crate::Point;
use crate::dialect::{Dialect, Unit};
use etalon_base::message::{Message, Problems};
use etalon_base::pose::Vector;
use etalon_base::{error, phrase, warning};
use etalon_tables::Decimal;
use etalon_tables::lexer::parsed;
use std::fmt::Write as _;

/// Deepest brackets: an array of targets.
const DEEPEST: usize = 4;
/// Maximum difference of the length of a quaternion from 1: four digits are usual.
const UNIT_LENGTH: f64 = 2e-3;

/// Robtargets of a RAPID module.
pub(super) struct AbbRapid;

impl ExportFormat for AbbRapid {
    fn about(&self) -> About {
        About { name: "abb_rapid", title: "ABB RAPID", ..About::default() }
    }

    fn recognise(&self, text: &str) -> Option<Recognised> {
        let begins = |line: &str| line.trim_start().to_ascii_uppercase().starts_with("MODULE ");
        let is_module = head(text).lines().any(begins) && text.trim_end().to_ascii_uppercase().ends_with("ENDMODULE");
        let found = Recognised::by(is_module, 0.95, phrase!("is-abb-rapid"))?;
        Some(Recognised { unit: Some("mm"), ..found })
    }

    fn caution(&self) -> Option<Message> {
        Some(warning!("positions-of-program"))
    }

    fn read(&self, text: &Text, _dialect: &Dialect, unit: Unit) -> (Vec<Point>, Problems) {
        let (mut points, mut problems) = (Vec::new(), Problems::default());
        for (line, statement) in statements(text) {
            let Some((name, at)) = named(&statement, line) else { continue };
            let targets = value(&statement[at..], 0).map(|(value, _)| targets(&value)).unwrap_or_default();
            if targets.is_empty() {
                points.push(text.no_point(line, &name, phrase!("row-without-coordinates")));
            }
            let several = targets.len() > 1;
            for (i, (xyz, turned)) in targets.into_iter().enumerate() {
                let name = if several { format!("{name}{{{}}}", i + 1) } else { name.clone() };
                if (turned.iter().map(|q| q * q).sum::<f64>().sqrt() - 1.0).abs() > UNIT_LENGTH {
                    let invalid = error!("record-invalid", text = name, format = "abb_rapid", valid = "[q1,q2,q3,q4]");
                    problems.0.push(invalid.at(text.place(line)));
                }
                let mut point = text.point(line, &name, xyz, Unit::Millimetre);
                point.orientation = Some(turned);
                points.push(point);
            }
        }
        if let Some(first) = points.first() {
            let agrees = unit_agrees(unit, Unit::Millimetre, &"robtarget", text.place(first.line as usize));
            problems.0.extend(agrees.err());
        }
        (points, problems)
    }

    fn write(&self, rows: &[ExportRow], how: &Writing) -> Result<String, WriteError> {
        how.unit_in(&[(Unit::Millimetre, "mm")])?;
        let mut out = "MODULE Etalon\n".to_owned();
        for row in rows {
            let is_name = |c: char| c.is_ascii_alphanumeric() || c == '_';
            if row.label.len() > 32
                || !row.label.starts_with(|c: char| c.is_ascii_alphabetic())
                || !row.label.chars().all(is_name)
            {
                return Err(error!("record-invalid", text = row.label, format = "abb_rapid", valid = "K_1_1").into());
            }
            let axes = "9E+09,9E+09,9E+09,9E+09,9E+09,9E+09";
            let _ = writeln!(
                out,
                "    CONST robtarget {}:=[[{}],[1,0,0,0],[0,0,0,0],[{axes}]];",
                row.label,
                how.list(row, ",")
            );
        }
        Ok(out + "ENDMODULE\n")
    }
}

/// Statements with the line of their beginning; comments begin with `!`.
fn statements(text: &Text) -> Vec<(usize, String)> {
    let mut all = Vec::new();
    let mut open: Option<(usize, String)> = None;
    for (i, line) in text.lines.iter().enumerate() {
        let line = line.split('!').next().unwrap_or("").trim();
        if line.is_empty() {
            continue;
        }
        let lower = line.to_ascii_lowercase();
        if lower.contains("robtarget ") || lower.contains("jointtarget ") || lower.starts_with("move") {
            all.extend(open.take());
        }
        let (_, statement) = open.get_or_insert_with(|| (i + 1, String::new()));
        statement.push_str(line);
        statement.push(' ');
        let is_word = !line.contains(|c: char| !c.is_ascii_alphanumeric() && !" _()".contains(c));
        if line.ends_with(';') || is_word {
            all.extend(open.take());
        }
    }
    all.extend(open);
    all
}

/// Name of the position of a statement and where its value begins: of a declaration its own name,
/// and of a move instruction the instruction and its line.
fn named(statement: &str, line: usize) -> Option<(String, usize)> {
    let lower = statement.to_ascii_lowercase();
    let declared = ["robtarget ", "jointtarget "].iter().find_map(|kind| Some(lower.find(kind)? + kind.len()));
    if let Some(from) = declared {
        let at = from + statement[from..].find(":=")?;
        let name = statement[from..at].split('{').next().unwrap_or("").trim();
        return Some((name.to_owned(), at + 2));
    }
    let at = statement.find("[[")?;
    let instruction =
        statement.split_whitespace().next().filter(|word| word.to_ascii_lowercase().starts_with("move"))?;
    Some((format!("{instruction}_{line}"), at))
}

/// Number, or list in brackets.
enum Value {
    Number(f64),
    List(Vec<Value>),
}

/// Reads a value, and returns the number of its bytes; `None` for another text.
fn value(text: &str, depth: usize) -> Option<(Value, usize)> {
    let start = text.len() - text.trim_start().len();
    let rest = &text[start..];
    if !rest.starts_with('[') {
        let end = rest.find([',', ']']).unwrap_or(rest.len());
        let number = parsed(rest[..end].trim(), Decimal::Point, None)?;
        return Some((Value::Number(number), start + end));
    }
    if depth >= DEEPEST {
        return None;
    }
    let (mut values, mut at) = (Vec::new(), start + 1);
    loop {
        let (item, length) = value(&text[at..], depth + 1)?;
        values.push(item);
        at += length;
        let rest = text[at..].trim_start();
        at = text.len() - rest.len() + 1;
        match rest.as_bytes().first()? {
            b',' => {}
            b']' => return Some((Value::List(values), at)),
            _ => return None,
        }
    }
}

/// Positions and quaternions of a robtarget or of an array of them; none of a jointtarget.
fn targets(value: &Value) -> Vec<(Vector, [f64; 4])> {
    let Value::List(parts) = value else { return Vec::new() };
    if let [position, turned, ..] = &parts[..]
        && let (Some(position), Some(turned)) = (numbers::<3>(position), numbers::<4>(turned))
    {
        return vec![(position, turned)];
    }
    parts.iter().flat_map(targets).collect()
}

/// Returns the numbers of a list with `N` elements; `None` for any other value.
fn numbers<const N: usize>(value: &Value) -> Option<[f64; N]> {
    let Value::List(values) = value else { return None };
    let number = |value: &Value| if let Value::Number(number) = value { Some(*number) } else { None };
    values.iter().map(number).collect::<Option<Vec<f64>>>()?.try_into().ok()
}

#[cfg(test)]
mod tests {
    use crate::Format;
    use crate::dialect::Unit;

    const MODULE: &str = "%%%\n  VERSION:1\n%%%\nMODULE Cell\n    ! the points of the plate\n\
        CONST robtarget V1:=[[830,300.25,650],[0.6,0,0.8,0],[0,-1,0,2],[9E+09,9E+09,9E+09,9E+09,9E+09,9E+09]];\n\
        PERS robtarget Row{2} := [\n  [[1.5,2.5,3.5],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],\n\
        [[4.5,5.5,6.5],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]];\n\
        CONST jointtarget Home:=[[0,0,0,0,90,0],[9E9,9E9,9E9,9E9,9E9,9E9]];\n\
        PROC main()\n  MoveJ V1,v800,fine,tool0;\n  MoveL [[613.91,2326.15,1040.68],[0.5,0.5,0.5,0.5],[0,0,-2,0],\
        [9E9,9E9,9E9,9E9,9E9,9E9]]\\ID:=1,v100,fine,tool0;\nENDPROC\nENDMODULE\n";

    #[test]
    fn robtargets_of_a_module_are_points_and_poses_in_doubt() {
        let format = Format::named("abb_rapid").unwrap();
        let (points, problems) = format.read("c.mod", &MODULE.into(), Unit::Millimetre);
        assert!(problems.0.is_empty(), "{problems:?}");
        let labels: Vec<&str> = points.iter().map(|point| &*point.label).collect();
        assert_eq!(labels, ["V1", "Row{1}", "Row{2}", "Home", "MoveL_13"]);
        assert_eq!(points[0].xyz_mm, [830.0, 300.25, 650.0]);
        assert_eq!(points[0].orientation, Some([0.6, 0.0, 0.8, 0.0]));
        assert_eq!(points[2].xyz_mm, [4.5, 5.5, 6.5]);
        assert!(points[3].refused.as_ref().is_some_and(|reason| reason.id == "row-without-coordinates"));
        assert_eq!((points[4].xyz_mm, points[4].line), ([613.91, 2326.15, 1040.68], 13));
        let document = crate::propose("c.mod", MODULE);
        assert_eq!(document.format.as_deref(), Some("abb_rapid"), "{}", document.toml);
        let doubts = || document.doubts.iter().filter_map(|doubt| doubt.phrase());
        assert!(doubts().any(|doubt| doubt.id == "positions-of-program"), "{}", document.toml);
        let (_, problems) = format.read("c.mod", &MODULE.into(), Unit::Metre);
        assert!(problems.0[0].is("unit-differs", &[("of_file", &"mm"), ("stated", &"m")]), "{problems:?}");
        let wrong = MODULE.replace("0.6,0,0", "0.3,0,0");
        let (_, problems) = format.read("c.mod", &wrong.as_str().into(), Unit::Millimetre);
        assert!(problems.0[0].is("record-invalid", &[("text", &"V1")]), "{problems:?}");
        // brackets without an end
        let deep = format!("MODULE M\nCONST robtarget p:={};\nENDMODULE\n", "[".repeat(100_000));
        assert!(format.read("c.mod", &deep.as_str().into(), Unit::Millimetre).0[0].refused.is_some());
    }
}
