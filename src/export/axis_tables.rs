//! Compensation tables of a linear axis from its measured deviations (mean of each direction).

use crate::base::message::{Message, Result};
use crate::math::axis::AxisPosition;
use std::fmt::Write;

/// Most rows of LinuxCNC's `COMP_FILE`.
const MOST_ROWS: usize = 256;
/// Unit of Beckhoff's tables, mm.
const TENTH_UM: f64 = 1e-4;

/// LinuxCNC, `COMP_FILE` with `COMP_FILE_TYPE = 0`: programmed position, and the actual ones in positive and in negative direction. The file
/// holds no comment: reading ends at the first line that is not three numbers.
///
/// # Errors
/// More than 256 positions.
pub fn linuxcnc(positions: &[AxisPosition]) -> Result<String> {
    if positions.len() > MOST_ROWS {
        let message = Message::error(format!("{} positions are too many for LinuxCNC", positions.len()));
        return Err(message.expected("256 at most").into());
    }
    let row = |p: &AxisPosition| {
        let at = |deviation_mm: f64| p.position_mm + deviation_mm;
        format!("{:?} {:?} {:?}\n", p.position_mm, at(p.forward.mean_mm), at(p.backward.mean_mm))
    };
    Ok(positions.iter().map(row).collect())
}

/// Beckhoff CNC, list of an axis (`kw.ssfk`, bilateral), in 0.1 um: measured minus programmed position, rounded.
///
/// # Errors
/// Positions that have no constant distance of whole 0.1 um.
pub fn beckhoff(positions: &[AxisPosition], header: &str) -> Result<String> {
    let units = |mm: f64| (mm / TENTH_UM).round();
    let distance = positions.get(1).map_or(0.0, |p| units(p.position_mm - positions[0].position_mm));
    let expected = |i: usize| positions[0].position_mm + i as f64 * distance * TENTH_UM;
    let even = |(i, p): (usize, &AxisPosition)| (p.position_mm - expected(i)).abs() < 0.5 * TENTH_UM;
    if distance <= 0.0 || !positions.iter().enumerate().all(even) {
        let message = Message::error("the positions of a Beckhoff table have a constant distance of whole 0.1 um");
        return Err(message.hint("measure at equal distances, or use another table").into());
    }
    let mut out =
        format!("# {header}\nkw.ssfk.interval {distance}\nkw.ssfk.kw_startpos {}\n", units(positions[0].position_mm));
    let _ = writeln!(out, "kw.ssfk.kw_nr_max {}\nkw.ssfk.unit 1\nkw.ssfk.bilateral 1", positions.len() - 1);
    for (i, p) in positions.iter().enumerate() {
        let [setpoint, pos, neg] = [p.position_mm, p.forward.mean_mm, p.backward.mean_mm].map(units);
        let _ = writeln!(
            out,
            "kw.ssfk.table[{i}].setpoint {setpoint}\nkw.ssfk.table[{i}].pos {pos}\nkw.ssfk.table[{i}].neg {neg}"
        );
    }
    Ok(out + "End\n")
}
