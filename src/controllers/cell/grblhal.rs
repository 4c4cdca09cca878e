//! Settings of grblHAL's kinematics `RTCP_AC` (grblHAL core, `kinematics/rtcp_ac.c`, which calls
//! itself experimental): $640 to $642 are the centre of A in the machine, $643 to $645 the centre
//! of C from there (mm).
//!
//! Machine coordinates are a + Rx(A) (c + Rz(C) p): the axis C at A = 0 goes through a + c, the
//! axis A through a. c_z shifts the frame of the part alone, and is zero.

use super::machine::TwoAxes;
use super::{CellData, CellFormat, CellPart, CellText};
use crate::decimals::fixed;
use etalon_base::error;
use etalon_base::message::Result;
use std::fmt::Write;

/// Number of the first setting (`Setting_Kinematics0`).
const FIRST: usize = 640;
/// Machine axis along A.
const X: usize = 0;

pub(super) struct GrblHal;

impl CellFormat for GrblHal {
    fn name(&self) -> &'static str {
        "grblhal"
    }

    fn parts(&self) -> &'static [CellPart] {
        &[CellPart::Axis]
    }

    fn text(&self, data: &CellData) -> Result<CellText> {
        let axes = TwoAxes::new(data, X, self.name())?;
        if !axes.positive {
            return Err(error!("cell-axis-sense", maker = self.name(), axis = "x", sense = "negative").into());
        }
        let [table, pivot] = axes.points(X);
        let settings = [table[0], pivot[1], pivot[2], 0.0, table[1] - pivot[1], 0.0];
        let mut text: String = data.header.iter().map(|line| format!("; {line}\n")).collect();
        let tilts = [axes.tilting.tilt_line("A", X), axes.table.tilt_line("C", 2)];
        for line in [&tilts[0], &tilts[1], "mm, coordinates of the machine, C measured at A = 0; kinematics RTCP_AC"] {
            let _ = writeln!(text, "; {line}");
        }
        for (k, value) in settings.into_iter().enumerate() {
            let _ = writeln!(text, "${}={}", FIRST + k, fixed(value, 3));
        }
        let tilted = [axes.tilting.tilt_warning(X, self.name()), axes.table.tilt_warning(2, self.name())];
        Ok(CellText { text, messages: tilted.into_iter().flatten().collect() })
    }
}
