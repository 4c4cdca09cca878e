//! RAPID data `tooldata` and `wobjdata` (ABB, RAPID reference manual, data types): positions in mm,
//! unit quaternion with the scalar first. The work object has the identified frame as user frame,
//! and an object frame at its origin.

use super::{CellData, CellFormat, CellPart, CellText, identifier};
use crate::decimals::all_fixed;
use etalon_base::message::Result;

pub(super) struct Abb;

impl CellFormat for Abb {
    fn name(&self) -> &'static str {
        "abb"
    }

    fn parts(&self) -> &'static [CellPart] {
        &[CellPart::Tool, CellPart::Object]
    }

    fn text(&self, data: &CellData) -> Result<CellText> {
        let mut text: String = data.header.iter().map(|line| format!("! {line}\n")).collect();
        let name = identifier(&data.name, 32);
        let at = all_fixed(data.pose.translation_mm, 6).join(",");
        let q = all_fixed(data.pose.quaternion(), 12).join(",");
        let frame = format!("[[{at}],[{q}]]");
        text += "MODULE EtalonCell\n";
        text += &match data.part {
            CellPart::Tool => format!(
                "  ! load data are not identified: replace the mass (kg) and the centre of gravity (mm) before use\n  \
                 PERS tooldata {name}:=[TRUE,{frame},[-1,[0,0,0],[1,0,0,0],0,0,0]];\n"
            ),
            _ => {
                format!("  PERS wobjdata {name}:=[FALSE,TRUE,\"\",{frame},[[0,0,0],[1,0,0,0]]];\n")
            }
        };
        Ok((text + "ENDMODULE\n").into())
    }
}
