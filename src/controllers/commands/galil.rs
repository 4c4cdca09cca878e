//! Galil DMC: absolute positions of the axes in counts, `PA n,n,n`.

use super::{ExportInput, Number, Program, ProgramTarget, at_line, masked, number, skip_blanks};
use etalon_base::message::Result;
use etalon_base::{error, phrase};
use std::fmt::Write;

/// Counts of each axis per mm or deg of its joint.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Galil {
    /// One factor per axis.
    pub counts_per_unit: Vec<f64>,
}

/// Maximum position of an axis (DMC-21x3 command reference, PA).
const LARGEST: f64 = 2_147_483_647.0;

impl Galil {
    /// Converts joint values (mm or deg) to counts.
    pub fn counts(&self, joints: &[f64]) -> Vec<f64> {
        joints.iter().zip(&self.counts_per_unit).map(|(q, counts)| (q * counts).round()).collect()
    }

    /// Converts counts to joint values (mm or deg).
    pub fn joints(&self, counts: &[f64]) -> Vec<f64> {
        counts.iter().zip(&self.counts_per_unit).map(|(n, counts)| n / counts).collect()
    }

    /// Program that moves to a sequence of joint values (mm or deg).
    ///
    /// # Errors
    ///
    /// Fails with more axes than a controller has, or if counts exceed its range.
    pub fn list(&self, given: &ExportInput, targets: &[(String, Vec<f64>)]) -> Result<String> {
        let axes = "ABCDEFGH".get(..self.counts_per_unit.len());
        let axes = axes.ok_or_else(|| error!("galil-axes", joints = self.counts_per_unit.len()))?;
        let mut out: String = given.header("counts")?.iter().map(|line| format!("REM {line}\n")).collect();
        out += "#TARGETS\n";
        for (name, joints) in targets {
            let counts = self.counts(joints);
            if counts.iter().any(|n| n.is_nan() || n.abs() > LARGEST) {
                return Err(error!("galil-counts-out-of-range", target = name, counts, most = LARGEST).into());
            }
            let cells: Vec<String> = counts.iter().map(|n| format!("{n}")).collect();
            let _ = writeln!(out, "REM {}\nPA {};BG {axes};AM {axes}", super::super::comment(name), cells.join(","));
        }
        Ok(out + "EN\n")
    }

    /// Targets of a program: absolute positions of all axes, `PA n,n,n`, in counts.
    ///
    /// # Errors
    ///
    /// Reports positions of some axes only or by variables, and relative and coordinated movements.
    pub fn targets(&self, program: &[u8]) -> Result<Program> {
        let text = masked(program, b'\'');
        let (mut found, mut problems, mut at) = (Program::default(), Vec::new(), 0);
        for (i, line) in text.split(|b| *b == b'\n').enumerate() {
            let remark = line.trim_ascii_start().starts_with(b"REM");
            for command in line.split(|b| *b == b';') {
                let start = at;
                at += command.len() + 1;
                let words = command.trim_ascii();
                let written = String::from_utf8_lossy(words);
                // a name with further letters is a variable, except for a command with an axis and
                // `=`
                let (name, rest) = words.split_at(words.len().min(2));
                let of_axis = matches!(rest, [axis, b'=', ..] if axis.is_ascii_uppercase());
                if remark || !of_axis && rest.first().is_some_and(|b| b.is_ascii_alphanumeric() && !b.is_ascii_digit())
                {
                    continue;
                }
                match name {
                    b"PA" if rest.trim_ascii().starts_with(b"?") => {}
                    b"PA" => match self.positions(&text[..start + command.len()], skip_blanks(&text, start) + 2) {
                        Some(numbers) => {
                            found.targets.push(ProgramTarget::new(format!("line {}", i + 1), i + 1, &numbers))
                        }
                        None => problems.push(at_line(
                            i + 1,
                            error!(
                                "move-incomplete",
                                command = written.as_ref(),
                                coordinates = phrase!("position-of-every-axis"),
                            ),
                        )),
                    },
                    b"PR" | b"IP" | b"LI" | b"VP" | b"CR" => {
                        let message = error!("movement-not-compensated", command = written.as_ref());
                        problems.push(at_line(i + 1, message));
                    }
                    _ => {}
                }
            }
        }
        super::none(problems)?;
        Ok(found)
    }

    /// One number per axis up to the end of the text, without anything else.
    fn positions(&self, text: &[u8], from: usize) -> Option<Vec<Number>> {
        let (mut at, mut all) = (from, Vec::new());
        while all.len() < self.counts_per_unit.len() {
            let next = number(text, at)?;
            at = skip_blanks(text, next.range.end);
            all.push(next);
            if all.len() < self.counts_per_unit.len() {
                at = (text.get(at) == Some(&b',')).then_some(at + 1)?;
            }
        }
        (at == text.len()).then_some(all)
    }
}
