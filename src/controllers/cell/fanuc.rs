//! TP program (FANUC, ASCII) that sets `UTOOL` or `UFRAME` through a position register, in mm and
//! deg, with Rz(R) Ry(P) Rx(W) (R-30iB operator's manual).

use super::{CellData, CellFormat, CellPart, CellText, identifier, roll_pitch_yaw_deg};
use crate::decimals::fixed;
use etalon_base::message::Result;
use std::fmt::Write;

pub(super) struct Fanuc;

/// Constant of a TP program: negative ones are in parentheses.
fn constant(value: f64) -> String {
    let text = fixed(value, 6);
    if text.starts_with('-') { format!("({text})") } else { text }
}

impl CellFormat for Fanuc {
    fn name(&self) -> &'static str {
        "fanuc"
    }

    fn parts(&self) -> &'static [CellPart] {
        &[CellPart::Tool, CellPart::Object]
    }

    fn text(&self, data: &CellData) -> Result<CellText> {
        let n = data.number;
        let name = identifier(&data.name, 32).to_uppercase();
        let kind = if data.part == CellPart::Tool { "UTOOL" } else { "UFRAME" };
        // remarks of TP programs are short: each line of the header has several
        let mut lines: Vec<String> = Vec::new();
        for line in &data.header {
            let characters: Vec<char> = line.chars().collect();
            lines.extend(characters.chunks(32).map(|part| format!("!{}", part.iter().collect::<String>())));
        }
        lines.push(format!("!PR[{n}] is overwritten"));
        // the current position makes the register Cartesian
        lines.push(format!("PR[{n}]=LPOS"));
        let numbers = data.pose.translation_mm.into_iter().chain(roll_pitch_yaw_deg(&data.pose));
        lines.extend((1..).zip(numbers).map(|(i, v)| format!("PR[{n},{i}]={}", constant(v))));
        lines.push(format!("{kind}[{n}]=PR[{n}]"));
        let mut text = format!("/PROG {name}\n/ATTR\nCOMMENT = \"etalon cell\";\n/MN\n");
        for (number, line) in (1..).zip(lines) {
            let _ = writeln!(text, "{number:4}:  {line} ;");
        }
        Ok((text + "/POS\n/END\n").into())
    }
}
