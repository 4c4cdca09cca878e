//! RAPID data `tooldata` and `wobjdata` (ABB, RAPID reference manual, data types): positions in mm,
//! unit quaternion with the scalar first. The work object has the identified frame as user frame,
//! and an object frame at its origin.

use super::{CellData, CellFormat, CellPart, identifier};

pub(super) struct Abb;

impl CellFormat for Abb {
    fn name(&self) -> &'static str {
        "abb"
    }

    fn text(&self, data: &CellData) -> String {
        let mut text: String = data.header.iter().map(|line| format!("! {line}\n")).collect();
        let name = identifier(&data.name, 32);
        let [x, y, z] = data.pose.translation_mm;
        let q = data.pose.quaternion().map(|v| format!("{v:.12}")).join(",");
        let frame = format!("[[{x:.6},{y:.6},{z:.6}],[{q}]]");
        text += "MODULE EtalonCell\n";
        text += &match data.part {
            CellPart::Tool => format!(
                "  ! load data are not identified: replace the mass (kg) and the centre of gravity (mm) before use\n  \
                 PERS tooldata {name}:=[TRUE,{frame},[-1,[0,0,0],[1,0,0,0],0,0,0]];\n"
            ),
            CellPart::Object => {
                format!("  PERS wobjdata {name}:=[FALSE,TRUE,\"\",{frame},[[0,0,0],[1,0,0,0]]];\n")
            }
        };
        text + "ENDMODULE\n"
    }
}
