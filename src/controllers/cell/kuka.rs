//! Lines of `$config.dat` (KUKA): `TOOL_DATA` and `BASE_DATA` as `FRAME` in mm and deg, with
//! Rz(A) Ry(B) Rx(C) (KUKA System Software, operating and programming instructions), and
//! `MACHINE_DEF` of an external rotary axis.
//!
//! The layout of `MACHINE_DEF` follows public backups (`docs/cell.md` has the addresses); the first
//! axis of an external kinematic turns about z of `ROOT` where `$ET1_TA1KR` is null.

use super::{CellData, CellFormat, CellPart, CellText, identifier, roll_pitch_yaw_deg};
use crate::decimals::all_fixed;
use etalon_base::error;
use etalon_base::message::Result;

/// Types of external kinematics in the order of `$EX_KIN`; the robot itself is number 1.
const KINEMATICS: [&str; 6] = ["#EASYS", "#EBSYS", "#ECSYS", "#EDSYS", "#EESYS", "#EFSYS"];

pub(super) struct Kuka;

impl CellFormat for Kuka {
    fn name(&self) -> &'static str {
        "kuka"
    }

    fn parts(&self) -> &'static [CellPart] {
        &[CellPart::Tool, CellPart::Object, CellPart::Axis]
    }

    fn text(&self, data: &CellData) -> Result<CellText> {
        let header: String = data.header.iter().map(|line| format!("; {line}\n")).collect();
        let [x, y, z] = all_fixed(data.pose.translation_mm, 6);
        let [c, b, a] = all_fixed(roll_pitch_yaw_deg(&data.pose), 9);
        let frame = format!("{{X {x},Y {y},Z {z},A {a},B {b},C {c}}}");
        let (n, name) = (data.number, identifier(&data.name, 24));
        let text = match data.part {
            CellPart::Axis => format!("{header}{}", machine(n, &name, &frame)?),
            CellPart::Tool => format!(
                "{header}; load data (LOAD_DATA) are not identified\nTOOL_DATA[{n}]={frame}\n\
                 TOOL_NAME[{n},]=\"{name}\"\n"
            ),
            _ => format!("{header}BASE_DATA[{n}]={frame}\nBASE_NAME[{n},]=\"{name}\"\n"),
        };
        Ok(text.into())
    }
}

/// Definition of an external kinematic.
fn machine(number: u32, name: &str, root: &str) -> Result<String> {
    let kind = (number as usize).checked_sub(2).and_then(|k| KINEMATICS.get(k));
    let Some(kind) = kind else { return Err(error!("cell-machine-number", number).into()) };
    Ok(format!(
        "; in the frame of the measured points, which must be the world frame of the controller\n\
         ; z of ROOT is the axis: $ET1_TA1KR (or that of the kinematic) must be null\n\
         MACHINE_DEF[{number}]={{NAME[] \"{name}\",COOP_KRC_INDEX 1,PARENT[] \"WORLD\",ROOT {root},\
         MECH_TYPE {kind},GEOMETRY[] \" \"}}\n"
    ))
}
