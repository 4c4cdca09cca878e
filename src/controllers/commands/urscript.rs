//! URScript (Universal Robots): `p[x, y, z, rx, ry, rz]` in m with a rotation vector in rad; joints
//! are lists without `p`.

use super::{
    CommandLanguage, Freedoms, Program, ProgramTarget, assigned_name, bracketed, line_number, masked, word_before,
};
use etalon_base::message::Result;
use etalon_base::pose::Pose;
use std::fmt::Write;

pub(super) struct UrScript;

/// Functions whose poses are poses of the tool.
const MOVES: [&str; 5] = ["movej", "movel", "movep", "get_inverse_kin", "get_inverse_kin_has_solution"];
/// Functions that move along an arc.
const ARCS: [&str; 2] = ["movec", "servoc"];

impl CommandLanguage for UrScript {
    fn comment_mark(&self) -> char {
        '#'
    }

    fn is_calibrated(&self) -> bool {
        true
    }

    fn units(&self) -> &'static str {
        "m, rad"
    }

    fn numbers(&self, pose: &Pose, _freedoms: Freedoms) -> Vec<f64> {
        pose.translation_mm.map(|v| v / 1000.0).into_iter().chain(pose.rotation_vector_rad()).collect()
    }

    fn pose(&self, n: &[f64], _freedoms: Freedoms) -> Pose {
        let turned = Pose::from_rotation_vector([n[3], n[4], n[5]]);
        Pose { translation_mm: [n[0], n[1], n[2]].map(|v| v * 1000.0), ..turned }
    }

    fn decimals(&self, _freedoms: Freedoms) -> Vec<usize> {
        vec![9, 9, 9, 10, 10, 10]
    }

    fn list(&self, header: &[String], commands: &[(String, Vec<String>)], _freedoms: Freedoms) -> String {
        let mut out: String = header.iter().map(|line| format!("# {line}\n")).collect();
        for (name, n) in commands {
            let _ = writeln!(out, "{} = p[{}]", super::identifier(name, 60), n.join(", "));
        }
        out
    }

    fn targets(&self, program: &[u8], freedoms: Freedoms) -> Result<Program> {
        let text = masked(program, b'#');
        let readable = String::from_utf8_lossy(&text);
        let arcs = super::refused_movements(&text, |word| ARCS.contains(&word));
        super::none(arcs.collect())?;
        let mut found = Program::default();
        for (open, _) in text.iter().enumerate().filter(|(_, b)| **b == b'[') {
            let Some((numbers, _)) = bracketed(&text, open).filter(|(numbers, _)| numbers.len() == 6) else { continue };
            let is_pose = word_before(&text, open) == "p";
            let start = if is_pose { open - 1 } else { open };
            let called = call(&text, start);
            let name = assigned_name(&text, start, "=");
            let moved = |name: &str| {
                let call = |function: &&str| readable.contains(&format!("{function}({name}"));
                !name.contains(' ') && MOVES.iter().any(call)
            };
            let used = MOVES.contains(&called) || (called.is_empty() && moved(&name));
            match (is_pose, used) {
                (true, true) => found.targets.push(ProgramTarget::new(name, line_number(&text, open), &numbers)),
                (false, true) => found.joint_targets += 1,
                (true, false) if called == "set_tcp" => {
                    let name = readable[start..].lines().next().unwrap_or_default().to_owned();
                    let numbers: Vec<f64> = numbers.iter().map(|n| n.value).collect();
                    found.known.insert(name.clone(), self.pose(&numbers, freedoms));
                    found.tools.insert(name);
                }
                (true, false) => _ = found.computed.insert(if called.is_empty() { name } else { called.to_owned() }),
                (false, false) => {}
            }
        }
        Ok(found)
    }
}

/// Function of whose arguments a value is part, if any.
fn call(text: &[u8], at: usize) -> &str {
    let mut depth = 0;
    for (i, byte) in text[..at].iter().enumerate().rev() {
        match byte {
            b')' => depth += 1,
            b'(' if depth == 0 => return word_before(text, i),
            b'(' => depth -= 1,
            b'\n' => return "",
            _ => {}
        }
    }
    ""
}
