//! Mecaprol (DexTAR): `MoveC X.. Y..;` in mm. The working mode (`M`) of the program is kept. In
//! published programs (oKermorgant/ecn_Dextar), `WCS X.. Y.. W..` is the frame of the targets,
//! `TCS Z..` is the tool, and `!` starts a comment.

use super::{CommandLanguage, Freedoms, Number, Program, ProgramTarget, at_line, masked, number};
use etalon_base::message::Result;
use etalon_base::pose::Pose;
use etalon_base::{error, phrase};
use std::collections::BTreeSet;
use std::fmt::Write;

pub(super) struct Mecaprol;

impl CommandLanguage for Mecaprol {
    fn comment_mark(&self) -> char {
        '!'
    }

    fn units(&self) -> &'static str {
        "mm"
    }

    fn numbers(&self, pose: &Pose, _freedoms: Freedoms) -> Vec<f64> {
        pose.translation_mm[..2].to_vec()
    }

    fn pose(&self, n: &[f64], _freedoms: Freedoms) -> Pose {
        Pose { translation_mm: [n[0], n[1], 0.0], ..Pose::identity() }
    }

    fn decimals(&self, _freedoms: Freedoms) -> Vec<usize> {
        vec![6, 6]
    }

    fn list(&self, header: &[String], commands: &[(String, Vec<String>)], _freedoms: Freedoms) -> String {
        let mut out: String = header.iter().map(|line| format!("! {line}\n")).collect();
        out += "START;\n";
        for (name, n) in commands {
            let _ = writeln!(out, "MoveC X{} Y{}; ! {}", n[0], n[1], super::super::comment(name));
        }
        out + "END;\n"
    }

    fn targets(&self, program: &[u8], _freedoms: Freedoms) -> Result<Program> {
        let text = masked(program, b'!');
        let (mut found, mut problems, mut modes, mut at) = (Program::default(), Vec::new(), BTreeSet::new(), 0);
        for (i, line) in text.split(|b| *b == b'\n').enumerate() {
            for command in line.split(|b| *b == b';') {
                let words = command.trim_ascii();
                let end = words.iter().position(u8::is_ascii_whitespace).unwrap_or(words.len());
                let value = |letter| Some(word(command, letter)?.value);
                let shifted = |letters: &[u8]| letters.iter().any(|l| value(*l).is_some_and(|v| v != 0.0));
                let written = || String::from_utf8_lossy(words).into_owned();
                modes.extend(value(b'M').map(|mode| mode.to_string()));
                match &words[..end] {
                    b"MoveJ" => found.joint_targets += 1,
                    b"WCS" if shifted(b"XYW") => _ = found.objects.insert(written()),
                    b"TCS" if shifted(b"XY") => _ = found.tools.insert(written()),
                    b"MoveC" | b"MoveL" => match [b'X', b'Y'].map(|letter| word(command, letter)) {
                        [Some(x), Some(y)] => {
                            let numbers = [x, y].map(|n| Number { range: at + n.range.start..at + n.range.end, ..n });
                            found.targets.push(ProgramTarget::new(format!("line {}", i + 1), i + 1, &numbers));
                        }
                        _ => problems.push(at_line(
                            i + 1,
                            error!("move-incomplete", command = written(), coordinates = phrase!("x-and-y")),
                        )),
                    },
                    _ => {}
                }
                at += command.len() + 1;
            }
        }
        if modes.len() > 1 {
            problems.push(at_line(1, error!("working-mode-changes")));
        }
        super::none(problems)?;
        Ok(found)
    }
}

/// Number after a letter at the start of a word.
fn word(command: &[u8], letter: u8) -> Option<Number> {
    let begins = |pair: &[u8]| pair[0].is_ascii_whitespace() && pair[1] == letter;
    let at = command.windows(2).position(begins)?;
    number(command, at + 2).filter(|number| number.range.start == at + 2)
}
