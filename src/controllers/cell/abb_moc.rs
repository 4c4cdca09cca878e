//! Base frame of a mechanical unit in the system parameters (ABB, topic Motion, `MOC.cfg`):
//! position in m, unit quaternion with the scalar first. A robot is an instance of `ROBOT`, an
//! external rotary axis one of `SINGLE`, which turns about z of its base frame.
//!
//! Names of attributes, units and layout come from public backups and programs (`docs/cell.md` has
//! the addresses). The lines are attributes of an existing instance, and no file to load: an
//! instance has many more attributes.

use super::{CellData, CellFormat, CellPart, CellText, identifier};
use crate::decimals::all_fixed;
use etalon_base::message::Result;

pub(super) struct AbbMoc;

impl CellFormat for AbbMoc {
    fn name(&self) -> &'static str {
        "abb-moc"
    }

    fn parts(&self) -> &'static [CellPart] {
        &[CellPart::Axis, CellPart::Base]
    }

    fn text(&self, data: &CellData) -> Result<CellText> {
        let mut text: String = data.header.iter().map(|line| format!("# {line}\n")).collect();
        text += "# in the frame of the measured points, which must be the world frame of the controller\n\
                 # attributes of the existing instance: enter them there; do not load this text alone\n";
        let kind = if data.part == CellPart::Axis { "SINGLE" } else { "ROBOT" };
        let name = identifier(&data.name, 32);
        let [x, y, z] = all_fixed(data.pose.translation_mm.map(|v| v / 1000.0), 7);
        let [u0, u1, u2, u3] = all_fixed(data.pose.quaternion(), 10);
        text += &format!(
            "{kind}:\n\n      -name \"{name}\" -base_frame_pos_x {x}\\\n      \
             -base_frame_pos_y {y} -base_frame_pos_z {z}\\\n      \
             -base_frame_orient_u0 {u0} -base_frame_orient_u1 {u1}\\\n      \
             -base_frame_orient_u2 {u2} -base_frame_orient_u3 {u3}\n"
        );
        Ok(text.into())
    }
}
