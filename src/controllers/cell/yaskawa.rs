//! Tool file `TOOL.CND` (Yaskawa): name, X Y Z Rx Ry Rz in mm and deg with Rz(Rz) Ry(Ry) Rx(Rx),
//! then centre of gravity, mass, moments of inertia, and a line of unknown meaning.
//!
//! The layout follows backups of an SDA20D and of a GP88 (`docs/cell.md` has the addresses). The
//! lines behind the frame are copied from tools without load data there. The file has no comments.

use super::{CellData, CellFormat, CellPart, CellText, identifier, roll_pitch_yaw_deg};
use crate::decimals::all_fixed;
use etalon_base::message::Result;
use etalon_base::warning;

/// Lines of a tool without load data.
const WITHOUT_LOAD: &str = "0.000,0.000,0.000\n0.000\n0.000,0.000,0.000\n0.000,0,1\n";
/// Maximum length of a name.
const NAME: usize = 16;

pub(super) struct Yaskawa;

impl CellFormat for Yaskawa {
    fn name(&self) -> &'static str {
        "yaskawa"
    }

    fn parts(&self) -> &'static [CellPart] {
        &[CellPart::Tool]
    }

    fn text(&self, data: &CellData) -> Result<CellText> {
        let at = all_fixed(data.pose.translation_mm, 3).join(",");
        let turned = all_fixed(roll_pitch_yaw_deg(&data.pose), 4).join(",");
        let (n, name) = (data.number, identifier(&data.name, NAME));
        let text = format!("//TOOL {n}\n///NAME {name}\n{at},{turned}\n{WITHOUT_LOAD}");
        Ok(CellText { text, messages: vec![warning!("cell-loads-replaced", number = n)] })
    }
}
