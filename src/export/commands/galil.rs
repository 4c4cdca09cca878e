//! Galil DMC: absolute positions of the axes in counts, `PA n,n,n`.

use super::Given;
use crate::base::message::{Message, Result};
use std::fmt::Write;

/// Counts of each axis for a mm or deg of its joint.
#[derive(Clone, Debug, PartialEq)]
pub struct Galil {
    /// One an axis.
    pub counts_per_unit: Vec<f64>,
}

/// Largest position of an axis (DMC-21x3 command reference, PA).
const LARGEST: f64 = 2_147_483_647.0;

impl Galil {
    /// Counts of joint values in mm and deg.
    pub fn counts(&self, joints: &[f64]) -> Vec<f64> {
        joints.iter().zip(&self.counts_per_unit).map(|(q, counts)| (q * counts).round()).collect()
    }

    /// Joint values of counts, mm and deg.
    pub fn joints(&self, counts: &[f64]) -> Vec<f64> {
        counts.iter().zip(&self.counts_per_unit).map(|(n, counts)| n / counts).collect()
    }

    /// A program that goes to joint values (mm, deg) one after the other.
    ///
    /// # Errors
    /// More axes than a controller has, or counts that it cannot hold.
    pub fn list(&self, given: &Given, targets: &[(String, Vec<f64>)]) -> Result<String> {
        let axes = "ABCDEFGH".get(..self.counts_per_unit.len());
        let axes = axes.ok_or_else(|| Message::error("a Galil controller has eight axes at most"))?;
        let mut out: String = given.header("counts")?.iter().map(|line| format!("REM {line}\n")).collect();
        out += "#TARGETS\n";
        for (name, joints) in targets {
            let counts = self.counts(joints);
            if counts.iter().any(|n| n.is_nan() || n.abs() > LARGEST) {
                let message = Message::error(format!("target {name}: {counts:?} counts are out of range"));
                return Err(message.expected(format!("at most {LARGEST} counts")).into());
            }
            let cells: Vec<String> = counts.iter().map(|n| format!("{n}")).collect();
            let _ = writeln!(out, "REM {}\nPA {};BG {axes};AM {axes}", super::super::comment(name), cells.join(","));
        }
        Ok(out + "EN\n")
    }
}
