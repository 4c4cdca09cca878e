//! Tables of `etalon cell`: poses of the flange, measured points or poses, known points, values of
//! an external axis.

use super::CellKind;
use crate::stages::orientations::{self, AngleOrder, Written};
use crate::stages::table_file::TableFile;
use etalon_base::error;
use etalon_base::message::{Problems, Result};
use etalon_base::pose::{Pose, Vector};
use etalon_formats::table::{FLANGE, Table, UNCERTAINTIES, XYZ};
use etalon_robots::{Joint, Quantity};

/// Poses of a table, as they are written.
pub(super) struct WrittenPoses {
    pub positions_mm: Vec<Vector>,
    pub orientations: Vec<Written>,
    pub order: Option<AngleOrder>,
}

/// Line of a row in its file.
pub(super) fn line(file: &TableFile, row: usize) -> usize {
    file.table.line(row).unwrap_or(row + 1)
}

/// Values of a column in any unit of its quantity (mm or rad); `None` without a column.
pub(super) fn values(table: &Table, name: &str, quantity: Quantity) -> Result<Option<Vec<f64>>> {
    let joint = Joint { name: name.to_owned(), quantity };
    let found = table.names().find_map(|name| Some((name, joint.factor(name)?)));
    let values =
        |(name, factor)| -> Result<Vec<f64>> { Ok(table.numbers(name)?.into_iter().map(|v| v * factor).collect()) };
    found.map(values).transpose()
}

/// Three coordinates (mm) whose columns begin with `prefix`.
///
/// # Errors
/// Reports missing columns and cells.
pub(super) fn coordinates(file: &TableFile, prefix: &str) -> Result<Vec<Vector>> {
    let (mut columns, mut problems) = (Vec::new(), Problems::default());
    for (axis, whole) in ["x", "y", "z"].into_iter().zip(XYZ) {
        let found = values(&file.table, &format!("{prefix}{axis}"), Quantity::Length).and_then(|found| {
            let missing = found.is_none().then(|| format!("{prefix}{whole}"));
            file.table.require(missing).map(|()| found)
        });
        columns.extend(problems.keep(found).flatten());
    }
    problems.check()?;
    let rows: Vec<Vector> = (0..file.table.height()).map(|i| [0, 1, 2].map(|k| columns[k][i])).collect();
    let bad = |p: &Vector| !p.iter().all(|v| v.is_finite());
    let missing =
        (0..rows.len()).filter(|&i| bad(&rows[i])).map(|i| error!("table-value-missing").at(file.table.place(i)));
    Problems(missing.collect()).check()?;
    Ok(rows)
}

/// Standard uncertainties of the measured coordinates (mm); empty without columns.
pub(super) fn uncertainties(file: &TableFile) -> Result<Vec<Vector>> {
    if UNCERTAINTIES.iter().all(|name| !file.table.has(name)) {
        return Ok(Vec::new());
    }
    file.table.require(UNCERTAINTIES)?;
    let [x, y, z] = UNCERTAINTIES.map(|name| file.table.numbers(name));
    let (x, y, z) = (x?, y?, z?);
    let rows: Vec<Vector> = (0..x.len()).map(|i| [x[i], y[i], z[i]]).collect();
    let bad = |u: &Vector| !u.iter().all(|v| v.is_finite() && *v > 0.0);
    let wrong = (0..rows.len()).filter(|&i| bad(&rows[i]));
    let wrong = wrong.map(|i| error!("cell-uncertainty-not-positive").at(file.table.place(i)));
    Problems(wrong.collect()).check()?;
    Ok(rows)
}

/// Both values, or the problems of both.
pub(super) fn both<A, B>(first: Result<A>, second: Result<B>) -> Result<(A, B)> {
    let mut problems = Problems::default();
    match (problems.keep(first), problems.keep(second)) {
        (Some(first), Some(second)) => Ok((first, second)),
        _ => Err(problems),
    }
}

/// Orientations whose columns begin with `prefix`.
fn orientations(file: &TableFile, prefix: &str, order: Option<AngleOrder>) -> Result<Vec<Written>> {
    let table = file.table.without_prefix(prefix);
    if !orientations::are_in(&table) {
        return Err(error!("cell-orientation-missing", prefix).at(table.header()).into());
    }
    let all = orientations::written(&table)?;
    if order.is_none() && all.iter().any(|o| o.angles().is_some()) {
        let option = if prefix.is_empty() { "--measured-orientation" } else { "--orientation" };
        return Err(error!("cell-order-missing", prefix, option).into());
    }
    Ok(all)
}

/// Poses of the flange (`flange_x_mm` ...), or measured ones (`x_mm` ...).
///
/// # Errors
/// Reports missing columns, and three angles without their order.
pub(super) fn poses(file: &TableFile, prefix: &str, order: Option<AngleOrder>) -> Result<WrittenPoses> {
    let (positions_mm, orientations) = both(coordinates(file, prefix), orientations(file, prefix, order))?;
    let all = WrittenPoses { positions_mm, orientations, order };
    let wrong = (0..all.orientations.len()).filter_map(|i| {
        all.orientations[i].pose(all.order).err().map(|problems| problems.0.into_iter().map(move |m| (i, m)))
    });
    Problems(wrong.flatten().map(|(i, message)| message.at(file.table.place(i))).collect()).check()?;
    Ok(all)
}

impl WrittenPoses {
    /// Poses as they are written; they were read before.
    pub fn poses(&self) -> Vec<Pose> {
        let both = self.positions_mm.iter().zip(&self.orientations);
        let pose = |(p, o): (&Vector, &Written)| Some(Pose { translation_mm: *p, ..o.pose(self.order).ok()? });
        both.map(pose).collect::<Option<_>>().unwrap_or_default()
    }
}

/// `true` if a problem reads the column.
pub(super) fn is_read(solve: CellKind, column: &str) -> bool {
    use CellKind::{HandEye, LinearAxis, Object, RotaryAxis, ThreePoints, ToolAxes, ToolPoint, ToolReflector};
    let is_axis = matches!(solve, LinearAxis | RotaryAxis);
    let has_flange = matches!(solve, ToolPoint | ToolReflector | ToolAxes | HandEye);
    let has_points = matches!(solve, ToolReflector | HandEye | Object | ThreePoints) || is_axis;
    let of = |prefix: &str| column.starts_with(prefix);
    match column {
        "line" => true,
        "point" => matches!(solve, ToolAxes | ThreePoints),
        "target" => is_axis,
        _ if of(FLANGE) => has_flange,
        _ if of("nominal_") => solve == Object,
        _ if of("axis_") => is_axis,
        _ if ["x_", "y_", "z_", "ux_", "uy_", "uz_"].into_iter().any(of) => has_points,
        _ => solve == HandEye && orientations::columns().any(|own| own == column),
    }
}

/// Poses of the flange.
pub(super) fn flange(file: &TableFile, order: Option<AngleOrder>) -> Result<WrittenPoses> {
    poses(file, FLANGE, order)
}
