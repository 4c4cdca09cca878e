//! Pivots of LinuxCNC's `xyzac-trt-kins` and `xyzbc-trt-kins`: a rotary table on a tilting table
//! (LinuxCNC, `src/emc/kinematics/trtfuncs.c`), as HAL commands.
//!
//! The joints are R + D + Rx(A) (Rz(C) (w − R) − D) with R = (x-rot-point, y-rot-point,
//! z-rot-point) and D = (x-offset, y-offset, z-offset + tool-offset): the axis C at A = 0 goes
//! through x-rot-point, y-rot-point, and the tilting axis through R + D for a tool of length zero.
//! z-rot-point and z-offset have one effect, so that z-offset is zero.

use super::machine::TwoAxes;
use super::{CellData, CellFormat, CellPart, CellText};
use crate::decimals::fixed;
use etalon_base::message::Result;
use std::fmt::Write;

/// Kinematics of a rotary table on a tilting table.
pub(super) struct TiltingTable {
    name: &'static str,
    /// Letter of the tilting axis.
    letter: &'static str,
    /// Machine axis (0 or 1) along the tilting axis.
    tilting: usize,
}

impl TiltingTable {
    pub const XYZAC: Self = Self { name: "xyzac-trt-kins", letter: "A", tilting: 0 };
    pub const XYZBC: Self = Self { name: "xyzbc-trt-kins", letter: "B", tilting: 1 };
}

impl CellFormat for TiltingTable {
    fn name(&self) -> &'static str {
        self.name
    }

    fn parts(&self) -> &'static [CellPart] {
        &[CellPart::Axis]
    }

    fn text(&self, data: &CellData) -> Result<CellText> {
        let (kins, tilting) = (self.name, self.tilting);
        let axes = TwoAxes::new(data, tilting, kins)?;
        let [table, pivot] = axes.points(tilting);
        let mut offset = [pivot[0] - table[0], pivot[1] - table[1], 0.0];
        offset[tilting] = 0.0;
        let rot_point = [table[0], table[1], pivot[2]];
        let mut text: String = data.header.iter().map(|line| format!("# {line}\n")).collect();
        let tilts = [axes.tilting.tilt_line(self.letter, tilting), axes.table.tilt_line("C", 2)];
        for line in [
            &tilts[0],
            &tilts[1],
            "mm; coordinates of the machine for a tool of length zero, C measured at zero of the tilting axis",
            "tool-offset is not set: net it to motion.tooloffset.z",
        ] {
            let _ = writeln!(text, "# {line}");
        }
        for (pin, value) in ["x", "y", "z"].into_iter().zip(rot_point) {
            let _ = writeln!(text, "setp {kins}.{pin}-rot-point {}", fixed(value, 6));
        }
        for (pin, value) in ["x", "y", "z"].into_iter().zip(offset) {
            let _ = writeln!(text, "setp {kins}.{pin}-offset {}", fixed(value, 6));
        }
        if !axes.positive {
            text += "# the table turns in the conventional sense: this pin needs a LinuxCNC that has it\n";
            let _ = writeln!(text, "setp {kins}.conventional-directions 1");
        }
        let tilted = [axes.tilting.tilt_warning(tilting, kins), axes.table.tilt_warning(2, kins)];
        Ok(CellText { text, messages: tilted.into_iter().flatten().collect() })
    }
}
