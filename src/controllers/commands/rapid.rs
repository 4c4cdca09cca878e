//! RAPID (ABB): `robtarget` as `[[x, y, z], [q1, q2, q3, q4], [cf1, cf4, cf6, cfx], [eax ...]]`, in
//! mm with a quaternion (RAPID reference manual, data types `robtarget`, `jointtarget`,
//! `confdata`).

use super::{
    CommandLanguage, Configuration, Freedoms, Number, Program, ProgramTarget, assigned_name, bracketed, line_number,
    masked, skip_blanks,
};
use etalon_base::error;
use etalon_base::message::Result;
use etalon_base::pose::Pose;
use std::fmt::Write;

pub(super) struct Rapid;

/// Default values of a `robtarget` after the pose: no configuration, no external axes.
const OTHERS: &str = "[0,0,0,0],[9E+09,9E+09,9E+09,9E+09,9E+09,9E+09]";

/// Instructions that move along an arc.
const ARCS: [&str; 12] = [
    "MoveC",
    "MoveCAO",
    "MoveCDO",
    "MoveCGO",
    "MoveCSync",
    "TriggC",
    "SearchC",
    "CapC",
    "DispC",
    "ArcC",
    "ArcCStart",
    "ArcCEnd",
];

impl CommandLanguage for Rapid {
    fn comment_mark(&self) -> char {
        '!'
    }

    fn units(&self) -> &'static str {
        "mm, unit quaternion"
    }

    fn numbers(&self, pose: &Pose, _freedoms: Freedoms) -> Vec<f64> {
        pose.translation_mm.into_iter().chain(pose.quaternion()).collect()
    }

    fn pose(&self, n: &[f64], _freedoms: Freedoms) -> Pose {
        Pose { translation_mm: [n[0], n[1], n[2]], ..Pose::from_quaternion([n[3], n[4], n[5], n[6]]) }
    }

    fn decimals(&self, _freedoms: Freedoms) -> Vec<usize> {
        vec![6, 6, 6, 10, 10, 10, 10]
    }

    fn list(&self, header: &[String], commands: &[(String, Vec<String>)], _freedoms: Freedoms) -> String {
        let mut out: String = header.iter().map(|line| format!("! {line}\n")).collect();
        out += "MODULE EtalonTargets\n";
        for (name, n) in commands {
            let name = super::identifier(name, 32);
            let _ =
                writeln!(out, "  CONST robtarget {name}:=[[{}],[{}],{OTHERS}];", n[..3].join(","), n[3..].join(","));
        }
        out + "ENDMODULE\n"
    }

    fn targets(&self, program: &[u8], freedoms: Freedoms) -> Result<Program> {
        let text = masked(program, b'!');
        let (mut found, mut at, mut problems) = (Program::default(), 0, Vec::new());
        let mut tools = Vec::new();
        while let Some(next) = text[at..].iter().position(|b| *b == b'[').map(|i| at + i) {
            let Some((lists, end)) = lists(&text, next) else {
                at = next + 1;
                continue;
            };
            at = end;
            match lists.iter().map(Vec::len).collect::<Vec<_>>()[..] {
                [3, 4, 4, 6] => {
                    let numbers = lists[..2].concat();
                    let name = assigned_name(&text, next, ":=");
                    let length = numbers[3..].iter().map(|n| n.value * n.value).sum::<f64>().sqrt();
                    if (length - 1.0).abs() > 1e-3 {
                        let message = error!("quaternion-length", target = name, length);
                        problems.push(super::at_line(line_number(&text, next), message));
                    }
                    let cf = |i: usize| lists[2][i].value as i64;
                    found.targets.push(ProgramTarget {
                        configuration: Some(Configuration::Quadrants([cf(0), cf(1), cf(2)])),
                        ..ProgramTarget::new(name, line_number(&text, next), &numbers)
                    });
                }
                [6, 6] => found.joint_targets += 1,
                [3, 4] => {
                    let numbers: Vec<f64> = lists.concat().iter().map(|n| n.value).collect();
                    tools.extend(tool_declared(&text[..next]).zip(Some(self.pose(&numbers, freedoms))));
                }
                _ => {}
            }
        }
        let arcs = super::refused_movements(&text, |word| ARCS.iter().any(|arc| word.eq_ignore_ascii_case(arc)));
        problems.extend(arcs);
        moves(&text, &mut found);
        for (name, pose) in tools {
            // names have no case
            let named = found.tools.iter().find(|tool| tool.eq_ignore_ascii_case(&name));
            found.known.extend(named.map(|tool| (tool.clone(), pose)));
        }
        super::none(problems)?;
        Ok(found)
    }
}

/// Lists of numbers in nested brackets, and the position after them.
fn lists(text: &[u8], at: usize) -> Option<(Vec<Vec<Number>>, usize)> {
    let (mut all, mut at) = (Vec::new(), at);
    loop {
        let (numbers, end) = bracketed(text, at + 1)?;
        all.push(numbers);
        at = skip_blanks(text, end);
        match text.get(at)? {
            b',' => {}
            b']' => return Some((all, at + 1)),
            _ => return None,
        }
    }
}

/// Name of the tool on the robot whose `tooldata` is declared up to its frame.
fn tool_declared(before: &[u8]) -> Option<String> {
    let statement = before.rsplit(|b| *b == b';').next().and_then(|text| std::str::from_utf8(text).ok())?;
    let (declared, value) = statement.split_once(":=")?;
    let (kind, name) = declared.trim_end().rsplit_once(char::is_whitespace)?;
    let is_tool = kind.trim_end().to_ascii_lowercase().ends_with("tooldata");
    let is_held = value.split_whitespace().collect::<String>().eq_ignore_ascii_case("[TRUE,");
    (is_tool && is_held).then(|| name.to_owned())
}

/// A line up to its comment; a text in quotes may contain an exclamation mark.
fn without_comment(line: &str) -> &str {
    let mut quoted = false;
    let comment = line.char_indices().find(|(_, c)| {
        quoted ^= *c == '"';
        *c == '!' && !quoted
    });
    comment.map_or(line, |(at, _)| &line[..at])
}

/// Collects tools, work objects and functions of targets that movements name.
fn moves(text: &[u8], found: &mut Program) {
    let text = String::from_utf8_lossy(text);
    let text: Vec<&str> = text.lines().map(without_comment).collect();
    for statement in text.join("\n").split(';') {
        let lower = statement.to_ascii_lowercase();
        for function in ["offs", "reltool"] {
            if lower.contains(&format!("{function}(")) || lower.contains(&format!("{function} (")) {
                found.computed.insert(if function == "offs" { "Offs" } else { "RelTool" }.to_owned());
            }
        }
        // a movement may follow the head of a routine or a condition, which no semicolon ends
        let begins = |at: usize| !lower[..at].ends_with(|c: char| c.is_alphanumeric() || c == '_');
        let moves = ["movej", "movel", "movec"].iter().any(|name| lower.match_indices(name).any(|(at, _)| begins(at)));
        let Some((_, last)) = statement.rsplit_once(',').filter(|_| moves) else { continue };
        let mut parts = last.split('\\').map(str::trim);
        found.tools.extend(parts.next().filter(|tool| !tool.eq_ignore_ascii_case("tool0")).map(str::to_owned));
        let object =
            parts.find_map(|p| p.split_once(":=").filter(|(name, _)| name.trim().eq_ignore_ascii_case("wobj")));
        let object = object.map(|(_, object)| object.trim()).filter(|object| !object.eq_ignore_ascii_case("wobj0"));
        found.objects.extend(object.map(str::to_owned));
    }
}
