//! Mecaprol (DexTAR): `MoveC X.. Y..;`, mm. The working mode (`M`) is left to the program: it stays as it is.

use super::{Freedoms, Language};
use crate::base::pose::Pose;
use std::fmt::Write;

pub(super) struct Mecaprol;

impl Language for Mecaprol {
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
}
