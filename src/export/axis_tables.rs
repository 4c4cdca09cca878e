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

/// Beckhoff CNC, list of an axis (`kw.ssfk`, bilateral) at positions of its own, in 0.1 um: measured minus programmed position, as the
/// example of its documentation has it (TF5200, axis compensation).
pub fn beckhoff(positions: &[AxisPosition], axis: &str, header: &str) -> String {
    let units = |mm: f64| (mm / TENTH_UM).round();
    let mut out = format!("# {header}\nkopf.log_achs_name {axis}\nkw.ssfk.interval 0\n");
    let start = positions.first().map_or(0.0, |p| units(p.position_mm));
    let _ = writeln!(out, "kw.ssfk.kw_startpos {start}\nkw.ssfk.kw_nr_max {}", positions.len());
    out += "kw.ssfk.unit 1\nkw.ssfk.bilateral 1\n";
    for (i, p) in positions.iter().enumerate() {
        let [setpoint, pos, neg] = [p.position_mm, p.forward.mean_mm, p.backward.mean_mm].map(units);
        let _ = writeln!(
            out,
            "kw.ssfk.table[{i}].setpoint {setpoint}\nkw.ssfk.table[{i}].pos {pos}\nkw.ssfk.table[{i}].neg {neg}"
        );
    }
    out + "End\n"
}

/// SINUMERIK, measuring system error compensation of an axis (`$AA_ENC_COMP`), mm: mean bidirectional deviations, because a positive value
/// moves the axis in negative direction (Function Manual Extended Functions, K3, 4.4.2). One table serves both directions.
///
/// # Errors
/// Positions that have no constant distance.
pub fn sinumerik(positions: &[AxisPosition], axis: &str, header: &str) -> Result<String> {
    let [first, .., last] = positions else {
        return Err(Message::error("a table of a SINUMERIK has two positions at least").into());
    };
    let step = (last.position_mm - first.position_mm) / (positions.len() - 1) as f64;
    let even = |(i, p): (usize, &AxisPosition)| (p.position_mm - first.position_mm - i as f64 * step).abs() < TENTH_UM;
    if !positions.iter().enumerate().all(even) {
        let message = Message::error("the positions of a table of a SINUMERIK have a constant distance");
        return Err(message.hint("measure at equal distances, or use another table").into());
    }
    let mut out = format!("%_N_AX_EEC_INI\n; {header}\nCHANDATA(1)\n");
    for (i, p) in positions.iter().enumerate() {
        let _ = writeln!(out, "$AA_ENC_COMP[0,{i},{axis}]={:.6}", p.mean_mm);
    }
    for (name, value) in [("STEP", step), ("MIN", first.position_mm), ("MAX", last.position_mm)] {
        let _ = writeln!(out, "$AA_ENC_COMP_{name}[0,{axis}]={value:.6}");
    }
    Ok(out + &format!("$AA_ENC_COMP_IS_MODULO[0,{axis}]=0\nM17\n"))
}
