//! G-code (ISO 6983, LinuxCNC's dialect): words X Y Z A B C in mm and deg, with Rz(C) Ry(B) Rx(A)
//! as in LinuxCNC's kinematics modules. A planar robot has X, Y and, if it rotates, C.

use super::{CommandLanguage, Freedoms, Number, Program, ProgramTarget, Slot, at_line, number};
use etalon_base::error;
use etalon_base::message::{Message, Result};
use etalon_base::pose::Pose;
use std::fmt::Write;
use std::ops::Range;

pub(super) struct Gcode;

/// Codes of straight movements, and codes that change no coordinates.
const HARMLESS: [&str; 20] = [
    "0", "1", "4", "17", "18", "19", "21", "40", "49", "54", "55", "56", "57", "58", "59", "61", "64", "80", "90", "94",
];

fn letters(freedoms: Freedoms) -> &'static [&'static str] {
    match freedoms {
        Freedoms::Point => &["X", "Y"],
        Freedoms::Plane => &["X", "Y", "C"],
        Freedoms::Space => &["X", "Y", "Z", "A", "B", "C"],
    }
}

impl CommandLanguage for Gcode {
    fn comment_mark(&self) -> char {
        ';'
    }

    fn units(&self) -> &'static str {
        "mm, deg"
    }

    fn numbers(&self, pose: &Pose, freedoms: Freedoms) -> Vec<f64> {
        let ([x, y, z], [a, b, c]) = (pose.translation_mm, pose.rpy_rad().map(f64::to_degrees));
        match freedoms {
            Freedoms::Point => vec![x, y],
            Freedoms::Plane => vec![x, y, c],
            Freedoms::Space => vec![x, y, z, a, b, c],
        }
    }

    fn pose(&self, n: &[f64], freedoms: Freedoms) -> Pose {
        let all = match freedoms {
            Freedoms::Point => [n[0], n[1], 0.0, 0.0, 0.0, 0.0],
            Freedoms::Plane => [n[0], n[1], 0.0, 0.0, 0.0, n[2]],
            Freedoms::Space => [n[0], n[1], n[2], n[3], n[4], n[5]],
        };
        Pose::from_xyz_rpy([all[0], all[1], all[2]], [all[3], all[4], all[5]].map(f64::to_radians))
    }

    fn decimals(&self, freedoms: Freedoms) -> Vec<usize> {
        letters(freedoms).iter().map(|l| if "XYZ".contains(l) { 6 } else { 8 }).collect()
    }

    fn list(&self, header: &[String], commands: &[(String, Vec<String>)], freedoms: Freedoms) -> String {
        let mut out: String = header.iter().map(|line| format!("; {line}\n")).collect();
        out += "G21 G90\n";
        for (name, n) in commands {
            let words: Vec<String> = letters(freedoms).iter().zip(n).map(|(l, v)| format!("{l}{v}")).collect();
            let _ = writeln!(out, "G0 {} ; {}", words.join(" "), super::super::comment(name));
        }
        out + "M2\n"
    }

    fn targets(&self, program: &[u8], freedoms: Freedoms) -> Result<Program> {
        let letters = letters(freedoms);
        let (mut found, mut problems, mut at) = (Program::default(), Vec::new(), 0);
        let mut last = vec![None; letters.len()];
        for (i, line) in program.split(|b| *b == b'\n').enumerate() {
            let words = words(line);
            problems.extend(words.iter().filter_map(forbidden).map(|message| at_line(i + 1, message)));
            found.objects.extend(
                words.iter().filter(|w| w.letter == 'G' && w.value.floor() > 54.0 && w.value < 60.0).map(|w| w.text()),
            );
            let mine = |letter: &str| words.iter().find(|w| letter.starts_with(w.letter));
            if letters.iter().any(|letter| mine(letter).is_some()) {
                let end = letters.iter().filter_map(|l| mine(l)).map(|w| w.number.end).max().unwrap_or(0);
                for (known, letter) in last.iter_mut().zip(letters) {
                    *known = mine(letter).map(|w| w.value).or(*known);
                }
                if let Some(missing) = letters.iter().zip(&last).find(|(_, v)| v.is_none()) {
                    problems.push(at_line(i + 1, error!("coordinate-unknown", letter = missing.0)));
                }
                let slot = |letter: &&'static str| match mine(letter) {
                    Some(word) => Slot { range: at + word.number.start..at + word.number.end, prefix: "" },
                    None => Slot { range: at + end..at + end, prefix: added(letter) },
                };
                let slots = letters.iter().map(slot).collect();
                found.targets.push(ProgramTarget {
                    name: format!("line {}", i + 1),
                    line: i + 1,
                    numbers: last.iter().map(|v| v.unwrap_or(f64::NAN)).collect(),
                    slots,
                    configuration: None,
                });
            }
            at += line.len() + 1;
        }
        super::none(problems)?;
        Ok(found)
    }
}

fn added(letter: &str) -> &'static str {
    match letter {
        "X" => " X",
        "Y" => " Y",
        "Z" => " Z",
        "A" => " A",
        "B" => " B",
        _ => " C",
    }
}

/// A letter with its number.
struct Word {
    letter: char,
    value: f64,
    number: Range<usize>,
}

impl Word {
    fn text(&self) -> String {
        format!("{}{}", self.letter, self.value)
    }
}

/// Words of a block without comments; a letter without a number has none.
fn words(line: &[u8]) -> Vec<Word> {
    let (mut all, mut at, mut comment) = (Vec::new(), 0, false);
    while let Some(&byte) = line.get(at) {
        match byte {
            b';' => break,
            b'(' => comment = true,
            b')' => comment = false,
            _ => {}
        }
        at += 1;
        if !comment && (byte.is_ascii_alphabetic() || byte == b'#') {
            let none = Number { range: at..at, value: f64::NAN };
            let Number { range, value } = number(line, at).unwrap_or(none);
            at = range.end;
            all.push(Word { letter: byte.to_ascii_uppercase() as char, value, number: range });
        }
    }
    all
}

/// Reason why a word prevents compensation block by block.
fn forbidden(word: &Word) -> Option<Message> {
    match word.letter {
        'G' if HARMLESS.contains(&word.value.to_string().as_str()) => None,
        'G' => Some(error!("movement-not-compensated", command = word.text())),
        '#' | 'O' => Some(error!("subroutine-not-compensated")),
        letter if "XYZABC".contains(letter) && word.value.is_nan() => Some(error!("coordinate-not-number", letter)),
        _ => None,
    }
}
