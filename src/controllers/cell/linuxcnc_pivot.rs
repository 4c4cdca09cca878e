//! Pivot lengths of LinuxCNC's `maxkins` and `5axiskins`: a tilting head, from an axis B along y
//! of the machine (LinuxCNC, `src/emc/kinematics/maxkins.c`, `5axiskins.c`), as HAL commands.
//!
//! Both place the end of the tool at the pivot minus L (sin B, 0, cos B) for C = 0 and the
//! unconventional sense of B; at B = 0 the tool is L below the pivot.

use super::machine::below_and_beside;
use super::{CellData, CellFormat, CellPart, CellText};
use crate::decimals::{all_fixed, fixed};
use etalon_base::error;
use etalon_base::message::Result;
use std::fmt::Write;

/// Machine axis along the tilting axis.
const Y: usize = 1;

/// Kinematics of a tilting head.
pub(super) struct Pivot {
    name: &'static str,
    /// `true` if a pin gives the sense of B.
    has_sense: bool,
}

impl Pivot {
    pub const MAX: Self = Self { name: "maxkins", has_sense: true };
    pub const FIVE_AXIS: Self = Self { name: "5axiskins", has_sense: false };
}

impl CellFormat for Pivot {
    fn name(&self) -> &'static str {
        self.name
    }

    fn parts(&self) -> &'static [CellPart] {
        &[CellPart::Axis]
    }

    fn text(&self, data: &CellData) -> Result<CellText> {
        let kins = self.name;
        let Some(axis) = data.axes.first() else {
            return Err(error!("cell-no-controller-data", solve = "rotary-axis", maker = kins).into());
        };
        axis.check(Y, kins)?;
        let Some(tool_mm) = data.tool_length_mm else {
            return Err(error!("cell-tool-length-missing", maker = kins).into());
        };
        let [along, across] = below_and_beside(axis);
        if along <= tool_mm {
            return Err(error!("cell-pivot-above", along_mm = along, tool_mm).into());
        }
        let conventional = axis.is_positive(Y);
        if conventional && !self.has_sense {
            return Err(error!("cell-axis-sense", maker = kins, axis = "y", sense = "positive").into());
        }
        let [below, beside, tool] = all_fixed([along, across, tool_mm], 6);
        let mut text: String = data.header.iter().map(|line| format!("# {line}\n")).collect();
        for line in [
            axis.tilt_line("B", Y),
            format!("mm; first target at B = 0: {below} below the pivot, {beside} beside it, tool {tool}"),
            "pivot to the gauge line; the length of a tool adds to it".to_owned(),
        ] {
            let _ = writeln!(text, "# {line}");
        }
        let _ = writeln!(text, "setp {kins}.pivot-length {}", fixed(along - tool_mm, 6));
        if conventional {
            text += "# the head turns in the conventional sense: this pin needs a LinuxCNC that has it\n";
            let _ = writeln!(text, "setp {kins}.conventional-directions 1");
        }
        Ok(CellText { text, messages: axis.tilt_warning(Y, kins).into_iter().collect() })
    }
}
