//! URScript (Universal Robots): `set_tcp` and a pose variable, in m with a rotation vector in rad
//! (The URScript programming language, `set_tcp`).

use super::{CellData, CellFormat, CellPart, CellText, identifier};
use crate::decimals::all_fixed;
use etalon_base::message::Result;

pub(super) struct UniversalRobots;

impl CellFormat for UniversalRobots {
    fn name(&self) -> &'static str {
        "ur"
    }

    fn parts(&self) -> &'static [CellPart] {
        &[CellPart::Tool, CellPart::Object]
    }

    fn text(&self, data: &CellData) -> Result<CellText> {
        let header: String = data.header.iter().map(|line| format!("# {line}\n")).collect();
        let at = all_fixed(data.pose.translation_mm.map(|v| v / 1000.0), 9).join(", ");
        let turned = all_fixed(data.pose.rotation_vector_rad(), 12).join(", ");
        let pose = format!("p[{at}, {turned}]");
        let text = match data.part {
            CellPart::Tool => format!("{header}# payload is not identified (set_payload)\nset_tcp({pose})\n"),
            _ => format!("{header}global {} = {pose}\n", identifier(&data.name, 32)),
        };
        Ok(text.into())
    }
}
