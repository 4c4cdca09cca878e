//! Lines of `$config.dat` (KUKA): `TOOL_DATA` and `BASE_DATA` as `FRAME` in mm and deg, with
//! Rz(A) Ry(B) Rx(C) (KUKA System Software, operating and programming instructions).

use super::{CellData, CellFormat, CellPart, identifier, roll_pitch_yaw_deg};

pub(super) struct Kuka;

impl CellFormat for Kuka {
    fn name(&self) -> &'static str {
        "kuka"
    }

    fn text(&self, data: &CellData) -> String {
        let text: String = data.header.iter().map(|line| format!("; {line}\n")).collect();
        let [x, y, z] = data.pose.translation_mm;
        let [c, b, a] = roll_pitch_yaw_deg(&data.pose);
        let (n, name) = (data.number, identifier(&data.name, 24));
        let kind = if data.part == CellPart::Tool { "TOOL" } else { "BASE" };
        let load = match data.part {
            CellPart::Tool => "; load data (LOAD_DATA) are not identified\n",
            CellPart::Object => "",
        };
        format!(
            "{text}{load}{kind}_DATA[{n}]={{X {x:.6},Y {y:.6},Z {z:.6},A {a:.9},B {b:.9},C {c:.9}}}\n\
             {kind}_NAME[{n},]=\"{name}\"\n"
        )
    }
}
