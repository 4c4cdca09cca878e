//! KRL (KUKA): `{X 1, Y 2, Z 3, A 4, B 5, C 6, S 2, T 35}` in mm and deg, with Rz(A) Ry(B) Rx(C);
//! `E6POS`, `POS`, and `{A1 .., A6 ..}` for joints (KUKA System Software, operating and programming
//! instructions).

use super::{
    CommandLanguage, Configuration, Freedoms, Number, Program, ProgramTarget, assigned_name, at_line, line_number,
    masked, number, word_before,
};
use etalon_base::message::{Message, Result};
use etalon_base::pose::Pose;
use etalon_base::{error, phrase};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::ops::Range;

pub(super) struct Krl;

const NAMES: [&str; 6] = ["X", "Y", "Z", "A", "B", "C"];
/// Arcs and relative movements.
const REFUSED: [&str; 8] = ["CIRC", "SCIRC", "CIRC_REL", "SCIRC_REL", "LIN_REL", "SLIN_REL", "PTP_REL", "SPTP_REL"];
/// Frames of the flange and of the base.
const NULL: [&str; 2] = ["$NULLFRAME", "$WORLD"];
/// Movements of the tool to a pose.
const MOVES: [&str; 6] = ["PTP", "LIN", "CIRC", "SPTP", "SLIN", "SCIRC"];

impl CommandLanguage for Krl {
    fn comment_mark(&self) -> char {
        ';'
    }

    fn units(&self) -> &'static str {
        "mm, deg"
    }

    fn numbers(&self, pose: &Pose, _freedoms: Freedoms) -> Vec<f64> {
        let [rx, ry, rz] = pose.rpy_rad().map(f64::to_degrees);
        pose.translation_mm.into_iter().chain([rz, ry, rx]).collect()
    }

    fn pose(&self, n: &[f64], _freedoms: Freedoms) -> Pose {
        Pose::from_xyz_rpy([n[0], n[1], n[2]], [n[5], n[4], n[3]].map(f64::to_radians))
    }

    fn decimals(&self, _freedoms: Freedoms) -> Vec<usize> {
        vec![6, 6, 6, 8, 8, 8]
    }

    fn list(&self, header: &[String], commands: &[(String, Vec<String>)], _freedoms: Freedoms) -> String {
        let mut out = "DEFDAT ETALON_TARGETS PUBLIC\n".to_owned();
        header.iter().for_each(|line| out += &format!("; {line}\n"));
        for (name, n) in commands {
            let cells: Vec<String> = NAMES.iter().zip(n).map(|(name, v)| format!("{name} {v}")).collect();
            let _ = writeln!(out, "GLOBAL DECL POS {}={{{}}}", super::identifier(name, 24), cells.join(","));
        }
        out + "ENDDAT\n"
    }

    fn targets(&self, program: &[u8], _freedoms: Freedoms) -> Result<Program> {
        let text = masked(program, b';');
        let (mut found, mut problems) = (Program::default(), Vec::new());
        for (open, _) in text.iter().enumerate().filter(|(_, b)| **b == b'{') {
            let inside =
                open + 1..open + 1 + text[open + 1..].iter().position(|b| matches!(b, b'{' | b'}')).unwrap_or(0);
            if text.get(inside.end) == Some(&b'}') {
                problems.extend(aggregate(&text, inside, &mut found));
            }
        }
        problems.extend(super::refused_movements(&text, |word| REFUSED.iter().any(|r| word.eq_ignore_ascii_case(r))));
        problems.extend(frames(&text, &mut found));
        problems.sort_by_key(|message| message.place.as_ref().and_then(|place| place.line));
        super::none(problems)?;
        Ok(found)
    }
}

/// A field of an aggregate.
struct Field {
    name: String,
    value: Number,
}

/// Adds an aggregate to the program by its kind; returns an error for a target that cannot be
/// compensated.
fn aggregate(text: &[u8], inside: Range<usize>, found: &mut Program) -> Option<Message> {
    let open = inside.start - 1;
    let colon = text[inside.clone()].iter().position(|b| *b == b':').map(|i| inside.start + i);
    let kind = colon.map_or("", |colon| word_before(text, colon)).to_ascii_uppercase();
    let mut fields = Vec::new();
    let mut at = colon.map_or(inside.start, |colon| colon + 1);
    for part in text[at..inside.end].split(|b| *b == b',') {
        let name_at = super::skip_blanks(part, 0);
        let end = part[name_at..].iter().position(u8::is_ascii_whitespace).map_or(part.len(), |i| name_at + i);
        if let Some(Number { range, value }) = number(part, end) {
            let name = String::from_utf8_lossy(&part[name_at..end]).to_ascii_uppercase();
            fields.push(Field { name, value: Number { range: at + range.start..at + range.end, value } });
        }
        at += part.len() + 1;
    }
    let field = |name: &str| fields.iter().find(|f| f.name == name);
    if (1..=6).all(|i| field(&format!("A{i}")).is_some()) {
        found.joint_targets += 1;
        return None;
    }
    let numbers: Vec<_> = NAMES.iter().filter_map(|name| field(name)).map(|f| f.value.clone()).collect();
    let before = text[..open].trim_ascii_end();
    let line_start = before.iter().rposition(|b| *b == b'\n').map_or(0, |i| i + 1);
    let statement = String::from_utf8_lossy(&before[line_start..]).to_ascii_uppercase();
    let statement = statement.trim_start();
    let moves = MOVES
        .iter()
        .any(|m| statement.strip_prefix(m).is_some_and(|rest| rest.is_empty() || rest.starts_with([' ', '{'])));
    let frame =
        kind == "FRAME" || ["$", "BASE_DATA", "TOOL_DATA", "LOAD_DATA"].iter().any(|s| statement.starts_with(s));
    if frame || statement.contains("FRAME ") || numbers.is_empty() || statement.contains("_REL") {
        return None;
    }
    let line = line_number(text, open);
    if numbers.len() < NAMES.len() {
        let command = format!("{{{}}}", String::from_utf8_lossy(&text[inside]).trim());
        let coordinates = phrase!("pose-of-six");
        return moves.then(|| at_line(line, error!("move-incomplete", command, coordinates)));
    }
    found.targets.push(ProgramTarget {
        configuration: field("T").map(|f| Configuration::Negative(f.value.value as i64)),
        ..ProgramTarget::new(assigned_name(text, open, "="), line, &numbers)
    });
    None
}

/// Collects the tools and bases of a program; returns an error for each tool or base with missing
/// coordinates.
fn frames(text: &[u8], found: &mut Program) -> Vec<Message> {
    let text = String::from_utf8_lossy(text).to_ascii_uppercase();
    for (key, into) in [("TOOL_NO ", &mut found.tools), ("BASE_NO ", &mut found.objects)] {
        let numbers = text.split(key).skip(1).map(|rest| rest.split([',', '}']).next().unwrap_or_default().trim());
        into.extend(numbers.filter(|n| *n != "0").map(|n| format!("{key}{n}")));
    }
    let mut problems = Vec::new();
    for (name, into) in [("$TOOL", &mut found.tools), ("$BASE", &mut found.objects)] {
        for (line, value) in assigned(&text, name) {
            let pose = match value.strip_prefix('{').and_then(|rest| rest.strip_suffix('}')) {
                Some(fields) => numbers(fields),
                None if NULL.contains(&value) => Some(Some(Pose::identity())),
                None => None,
            };
            let is_part = name.len() < value.len() && value.starts_with(name);
            if is_part || matches!(pose, Some(None)) {
                let command = if is_part { value.to_owned() } else { format!("{name}={value}") };
                let coordinates = phrase!("pose-of-six");
                problems.push(at_line(line, error!("move-incomplete", command, coordinates)));
                continue;
            }
            found.known.extend(pose.flatten().map(|pose| (value.to_owned(), pose)));
            into.insert(value.to_owned());
        }
    }
    problems
}

/// Lines with the values that they assign to `$TOOL` or `$BASE`, or the assignment itself if it is
/// of one coordinate. A value that the next assignments replace before anything else happens is
/// omitted.
fn assigned<'t>(text: &'t str, name: &str) -> Vec<(usize, &'t str)> {
    let (mut all, mut is_replaced) = (Vec::new(), false);
    for (i, line) in text.lines().map(str::trim).enumerate() {
        let rest = line.strip_prefix(name).map(str::trim_start);
        if let Some(value) = rest.and_then(|rest| rest.strip_prefix('=')) {
            if is_replaced {
                all.pop();
            }
            all.push((i + 1, value.trim()));
            is_replaced = true;
        } else if rest.is_some_and(|rest| rest.starts_with('.') && rest.contains('=')) {
            all.push((i + 1, line));
            is_replaced = false;
        } else if !line.is_empty() && !line.starts_with('$') {
            is_replaced = false;
        }
    }
    all
}

/// Pose of the fields of a frame, if all are numbers; `Some(None)` if some coordinates are missing.
fn numbers(fields: &str) -> Option<Option<Pose>> {
    let fields = fields.split_once(':').map_or(fields, |(_, fields)| fields);
    let field = |field: &str| {
        let (name, value) = field.trim().split_once(char::is_whitespace)?;
        Some((name.to_owned(), value.trim().parse::<f64>().ok().filter(|v| v.is_finite())?))
    };
    let stated = fields.split(',').map(field).collect::<Option<BTreeMap<String, f64>>>()?;
    let six: Option<Vec<f64>> = NAMES.iter().map(|name| stated.get(*name).copied()).collect();
    Some(six.map(|n| Krl.pose(&n, Freedoms::Space)))
}
