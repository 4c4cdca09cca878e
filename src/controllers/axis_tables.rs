//! Compensation tables of an axis or a plane from deviations, either measured (mean of each
//! direction) or computed. Positions and deviations are in mm for a linear axis, in deg for a
//! rotary axis.

use crate::decimals::fixed;
use etalon_base::error;
use etalon_base::files;
use etalon_base::message::Result;
use etalon_documents::AxisPosition;
use std::fmt::Write;

/// Maximum number of rows of LinuxCNC's `COMP_FILE`.
const MOST_ROWS: usize = 256;
/// Unit of Beckhoff's tables (mm or deg).
const UNIT: f64 = 1e-4;
/// Default number of entries of a plane in a Beckhoff control, if `max_points` is not given
/// (P-COMP-00061).
const PLANE_ENTRIES: usize = 10_201;

/// Attained minus programmed position at a programmed position, in positive and in negative
/// direction (mm or deg).
#[derive(Clone, Copy, Debug)]
pub struct Deviation {
    /// Programmed position.
    pub position: f64,
    /// Deviation in positive direction.
    pub forward: f64,
    /// Deviation in negative direction.
    pub backward: f64,
}

impl From<&AxisPosition> for Deviation {
    fn from(p: &AxisPosition) -> Self {
        Self { position: p.position_mm, forward: p.forward.mean_mm, backward: p.backward.mean_mm }
    }
}

impl Deviation {
    fn mean(&self) -> f64 {
        0.5 * (self.forward + self.backward)
    }
}

/// Maximum plausible change of a deviation per distance: the error of the worst transmission ratio.
const STEEPEST: f64 = 0.05;

/// Rejects implausible deviations of an axis.
///
/// # Errors
///
/// Fails if deviations change by more than 5 % of the distance between two positions, which happens
/// with deviations in µm or with measured positions in m.
pub fn plausible(positions: &[Deviation]) -> Result<()> {
    let change = |pair: &[Deviation]| {
        let [a, b] = [&pair[0], &pair[1]];
        (b.forward - a.forward).abs().max((b.backward - a.backward).abs())
    };
    let steep = |pair: &&[Deviation]| change(pair) > STEEPEST * (pair[1].position - pair[0].position).abs();
    let Some(pair) = positions.windows(2).find(steep) else { return Ok(()) };
    let [from, to] = [pair[0].position, pair[1].position];
    Err(error!("deviation-steep", change = change(pair), from, to).into())
}

/// Use of a table's value in a control, if its manufacturer does not publish it and it was observed
/// on the machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Sign {
    /// The control adds the value to the commanded position.
    Add,
    /// The control subtracts the value from the commanded position.
    Subtract,
}

impl Sign {
    /// Table value that compensates for a deviation, in the same unit.
    fn value(self, deviation: f64) -> f64 {
        if self == Self::Add { -deviation } else { deviation }
    }

    /// Remark in the header of a table.
    fn remark(self) -> String {
        let does = if self == Self::Add { "adds" } else { "subtracts" };
        format!(
            "values for a control that {does} them, as stated; the maker does not publish the sign. Check on the machine: at a \
             node, the axis moves by the value {}when the table is switched on",
            if self == Self::Add { "" } else { "times -1 " }
        )
    }
}

/// LinuxCNC, `COMP_FILE` with `COMP_FILE_TYPE = 0`: programmed position, and attained positions in
/// positive and in negative direction. The file contains no comments, because reading ends at the
/// first line without three numbers.
///
/// # Errors
///
/// Fails with more than 256 positions.
pub fn linuxcnc(positions: &[Deviation]) -> Result<String> {
    if positions.len() > MOST_ROWS {
        let positions = positions.len();
        return Err(error!("axis-table-too-long", positions, controller = "LinuxCNC", most = MOST_ROWS).into());
    }
    let row = |p: &Deviation| format!("{:?} {:?} {:?}\n", p.position, p.position + p.forward, p.position + p.backward);
    Ok(positions.iter().map(row).collect())
}

/// Beckhoff CNC, list of an axis (`kw.ssfk`, bilateral) at arbitrary positions, in 0.1 µm or 0.0001
/// deg: measured minus programmed position, as in the example of the documentation (TF5200, axis
/// compensation).
pub fn beckhoff(positions: &[Deviation], axis: &str, header: &[String]) -> String {
    let mut out = commented("#", header) + &format!("kopf.log_achs_name {axis}\nkw.ssfk.interval 0\n");
    let start = positions.first().map_or(0.0, |p| units(p.position));
    let _ = writeln!(out, "kw.ssfk.kw_startpos {start}\nkw.ssfk.kw_nr_max {}", positions.len());
    out += "kw.ssfk.unit 1\nkw.ssfk.bilateral 1\n";
    for (i, p) in positions.iter().enumerate() {
        let [setpoint, pos, neg] = [p.position, p.forward, p.backward].map(units);
        let _ = writeln!(
            out,
            "kw.ssfk.table[{i}].setpoint {setpoint}\nkw.ssfk.table[{i}].pos {pos}\nkw.ssfk.table[{i}].neg {neg}"
        );
    }
    out + "End\n"
}

/// SINUMERIK, measuring system error compensation of an axis (`$AA_ENC_COMP`), in mm or deg: mean
/// bidirectional deviations, because a positive value moves the axis in negative direction
/// (Function Manual Extended Functions, K3, 4.4.2). A single table applies to both directions.
///
/// # Errors
///
/// Fails if the positions are not equidistant.
pub fn sinumerik(positions: &[Deviation], axis: &str, header: &[String]) -> Result<String> {
    let [first, step, last] = even(positions)?;
    let mut out = format!("%_N_AX_EEC_INI\n{}CHANDATA(1)\n", commented(";", header));
    for (i, p) in positions.iter().enumerate() {
        let _ = writeln!(out, "$AA_ENC_COMP[0,{i},{axis}]={}", fixed(p.mean(), 6));
    }
    for (name, value) in [("STEP", step), ("MIN", first), ("MAX", last)] {
        let _ = writeln!(out, "$AA_ENC_COMP_{name}[0,{axis}]={}", fixed(value, 6));
    }
    Ok(out + &format!("$AA_ENC_COMP_IS_MODULO[0,{axis}]=0\nM17\n"))
}

/// Numbers of the axes of a table in the control.
#[derive(Clone, Copy, Debug)]
pub struct MachineAxes {
    /// Axes on whose positions the table depends; the second is used for planes only.
    pub base: [usize; 2],
    /// Corrected axis.
    pub corrected: usize,
}

/// SINUMERIK, sag and angularity error compensation of an axis by another axis or by itself
/// (`$AN_CEC`), in mm or deg, table `index` (Function Manual Extended Functions 03/2013, K3, 4.4.3,
/// and 802D sl 11/2012, K3, 11.3.3: table example). The sign of the values is not published.
///
/// # Errors
///
/// Fails if the positions are not equidistant.
pub fn sinumerik_cec(
    positions: &[Deviation],
    axes: MachineAxes,
    index: usize,
    sign: Sign,
    header: &[String],
) -> Result<String> {
    let [first, step, last] = even(positions)?;
    let MachineAxes { base: [base, _], corrected } = axes;
    let mut out = format!("%_N_NC_CEC_INI\n{}; {}\nCHANDATA(1)\n", commented(";", header), sign.remark());
    for (i, p) in positions.iter().enumerate() {
        let _ = writeln!(out, "$AN_CEC[{index},{i}]={}", fixed(sign.value(p.mean()), 6));
    }
    let _ = writeln!(out, "$AN_CEC_INPUT_AXIS[{index}]=(AX{base})\n$AN_CEC_OUTPUT_AXIS[{index}]=(AX{corrected})");
    for (name, value) in [("STEP", step), ("MIN", first), ("MAX", last)] {
        let _ = writeln!(out, "$AN_CEC_{name}[{index}]={}", fixed(value, 6));
    }
    for name in ["DIRECTION", "MULT_BY_TABLE", "IS_MODULO"] {
        let _ = writeln!(out, "$AN_CEC_{name}[{index}]=0");
    }
    Ok(out + "M17\n")
}

/// Deviations of an axis (mm) at the nodes of a grid over two other axes, or over itself and
/// another; rows are along the first axis.
#[derive(Clone, Debug)]
pub struct Plane {
    /// Positions of the first node.
    pub start: [f64; 2],
    /// Distances of the nodes along both axes.
    pub step: [f64; 2],
    /// One row per position of the second axis.
    pub rows: Vec<Vec<f64>>,
}

/// Beckhoff CNC, plane compensation of an axis (`kw.crosscomp2`) in 0.1 µm. The first index of the
/// table belongs to the second master axis (TF5200, axis compensation parameters, P-COMP-00008 to
/// 00016, and example). The sign of the values is not published.
///
/// # Errors
///
/// Fails if the cells of the grid are not squares.
pub fn beckhoff_plane(plane: &Plane, axes: MachineAxes, name: &str, sign: Sign, header: &[String]) -> Result<String> {
    let ([x, y], Plane { start, step, rows }) = (axes.base, plane);
    if (step[0] - step[1]).abs() > UNIT {
        return Err(error!("plane-steps-differ", step_mm = step[0]).into());
    }
    let columns = rows.first().map_or(0, Vec::len);
    let mut out = commented("#", header) + &format!("# {}\n", sign.remark());
    let _ = writeln!(out, "kopf.achs_nr {}\nkopf.log_achs_name {name}", axes.corrected);
    if rows.len() * columns > PLANE_ENTRIES {
        let _ = writeln!(out, "kw.crosscomp2.max_points {}", rows.len() * columns);
    }
    let [x_start, y_start, interval] = [start[0], start[1], step[0]].map(units);
    let _ = write!(
        out,
        "kw.crosscomp2.interval {interval}\nkw.crosscomp2.last_index_master1 {}\nkw.crosscomp2.last_index_master2 {}\n\
         kw.crosscomp2.start_position_master1 {x_start}\nkw.crosscomp2.start_position_master2 {y_start}\nkw.crosscomp2.unit 1\n\
         kw.crosscomp2.n_cycles 10\nkw.crosscomp2.master1_ax_nr {x}\nkw.crosscomp2.master2_ax_nr {y}\n",
        columns.saturating_sub(1),
        rows.len().saturating_sub(1)
    );
    for (j, row) in rows.iter().enumerate() {
        for (i, deviation) in row.iter().enumerate() {
            let _ = writeln!(out, "kw.crosscomp2.table[{j}][{i}].correction {}", units(sign.value(*deviation)));
        }
    }
    Ok(out + "End\n")
}

/// Value in units of Beckhoff's tables, without negative zero.
fn units(value: f64) -> f64 {
    (value / UNIT).round() + 0.0
}

/// First position, constant distance and last position.
fn even(positions: &[Deviation]) -> Result<[f64; 3]> {
    let [first, .., last] = positions else {
        return Err(error!("axis-table-too-short", positions = positions.len()).into());
    };
    let step = (last.position - first.position) / (positions.len() - 1) as f64;
    let off = |(i, p): (usize, &Deviation)| (p.position - first.position - i as f64 * step).abs() > UNIT;
    if positions.iter().enumerate().any(off) {
        return Err(error!("axis-positions-uneven").into());
    }
    Ok([first.position, step, last.position])
}

/// Header lines of a table that is not made from parameters: version, description of its campaign
/// (`about`), units and hash of its `source`, in characters that cannot end a comment.
pub fn header(about: impl IntoIterator<Item = String>, units: &str, source: &str, bytes: &[u8]) -> Vec<String> {
    let version = format!("Written by etalon {}", env!("CARGO_PKG_VERSION"));
    let ends = [format!("units: {units}"), format!("sha256 of {source}: {}", files::sha256(bytes))];
    std::iter::once(version).chain(about).chain(ends).map(|line| super::comment(&line)).collect()
}

/// Converts lines to comments with the given mark.
fn commented(mark: &str, lines: &[String]) -> String {
    lines.iter().map(|line| format!("{mark} {line}\n")).collect()
}
