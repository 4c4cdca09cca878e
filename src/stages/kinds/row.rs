//! Rows of a table of observations of several kinds.

use super::cells::{Cells, Others, STATION, check_fixed, names};
use super::{KINDS, RowDefaults, RowKind, kind};
use crate::stages::orientations::{AngleOrder, Written, written};
use etalon_base::error;
use etalon_base::message::{Problems, Result};
use etalon_base::pose::Vector;
use etalon_base::pose_name::PoseName;
use etalon_formats::table::{COVARIANCES, Table, UNCERTAINTIES, XYZ};
use etalon_formats::tables::joints::joint_values;
use etalon_identify::{Condition, Settings};
use etalon_robots::Robot;

/// Column of the uncertainty of all coordinates.
const OF_LENGTH: &str = "u_mm";
/// Column of the uncertainty of all rotations.
const OF_ROTATION: &str = "urot_deg";

/// Numeric columns that only some kinds need, in the order in which they are written.
pub fn numbers() -> Vec<&'static str> {
    let mut all = Vec::new();
    for name in KINDS.iter().flat_map(|kind| kind.facts().numbers) {
        all.retain(|other| *other != name);
        all.push(name);
    }
    all
}

/// Columns of all kinds, except the columns of positions. The target is one of these columns.
pub fn columns<'a>() -> Vec<&'a str> {
    ["kind"].into_iter().chain(names()).chain(numbers()).chain([OF_LENGTH, OF_ROTATION]).collect()
}

/// Reason why a row is no observation.
pub(super) enum RowError {
    /// Its standard uncertainty is missing, in the column of this name.
    Unstated(&'static str),
    /// Its cells are wrong.
    Wrong(Problems),
}

impl From<Problems> for RowError {
    fn from(problems: Problems) -> Self {
        Self::Wrong(problems)
    }
}

/// A row of a table; missing numbers are NaN, and missing names empty.
pub struct Row<'t> {
    /// Index of the row in the table.
    pub(super) index: usize,
    /// References of the row; its kind as given, or `pose` and `point` with and without an
    /// orientation.
    pub(super) cells: Cells<'t>,
    /// Name of the pose; `None` for rows about fixed points and surfaces alone.
    pub(super) pose: Option<PoseName>,
    pub(super) cycle: i64,
    /// Joint values (mm or rad) and directions.
    pub(super) joints: Vec<f64>,
    pub(super) xyz_mm: Vector,
    /// `true` if only some coordinates of the target are given.
    pub(super) is_partial: bool,
    pub(super) orientation: Written,
    /// The order of three angles of an orientation.
    pub(super) order: Option<AngleOrder>,
    /// Standard uncertainty of a length (mm): the row's own, or the one given for all rows.
    pub(super) u_mm: f64,
    pub(super) u_axes_mm: Vector,
    /// Standard uncertainty of a rotation (rad), likewise.
    pub(super) u_rotation_rad: f64,
}

impl<'t> Row<'t> {
    /// Axes of the target's coordinates that the row does not have, if it has others.
    pub(super) fn missing_axes(&self) -> Vec<&'static str> {
        let axes = ["x", "y", "z"].into_iter().zip(self.xyz_mm);
        axes.filter(|(_, value)| self.is_partial && value.is_nan()).map(|(axis, _)| axis).collect()
    }

    /// The rows of a table.
    pub fn read(robot: &dyn Robot, table: &'t Table, without: RowDefaults) -> Result<Vec<Self>> {
        let (poses, cycles) = (table.optional_poses()?, row_cycles(table)?);
        table.texts("target")?;
        let orientations = written(table)?;
        let joints = joint_values(robot, table, &[])?;
        let stations = other_stations(table);
        let partial = partial_rows(robot, table)?;
        let or = |stated: f64, other: Option<f64>| if stated.is_nan() { other.unwrap_or(f64::NAN) } else { stated };
        let rows = joints.into_iter().zip(orientations).zip(stations).enumerate();
        let rows = rows.map(|(index, ((joints, orientation), station))| {
            let unstated = if orientation.is_stated() { "pose" } else { "point" };
            let kind = table.text(index, "kind").unwrap_or(unstated).to_owned();
            let target = table.text(index, "target").unwrap_or_default().to_owned();
            let cells = Cells { kind, target, station, others: Others::Row(table, index) };
            let number = |column: &str| cells.number(column).unwrap_or(f64::NAN);
            Self {
                index,
                pose: poses[index],
                cycle: cycles[index],
                joints,
                xyz_mm: XYZ.map(number),
                is_partial: partial[index],
                orientation,
                order: orientation.order.or(without.order),
                u_mm: or(or(number("u_mm"), cells.number("ux_mm")), without.length_mm),
                u_axes_mm: UNCERTAINTIES.map(number),
                u_rotation_rad: or(number("urot_deg").to_radians(), without.rotation_rad),
                cells,
            }
        });
        Ok(rows.collect())
    }

    /// `true` if the row gives a complete position in the world.
    pub fn has_position(&self) -> bool {
        self.pose.is_some()
            && !self.is_partial
            && self.cells.station.is_none()
            && kind(&self.cells.kind).is_ok_and(|kind| kind.facts().has_position)
            && self.xyz_mm.iter().any(|v| !v.is_nan())
    }

    /// Position of a fixed point (mm).
    pub(super) fn fixed_place(&self) -> Result<Vector> {
        if self.xyz_mm.iter().any(|v| !v.is_finite()) {
            return Err(error!("place-missing", point = self.cells.target).into());
        }
        Ok(self.xyz_mm)
    }

    /// Adds the data of the row to `settings`, unless it is only the position of a target.
    pub(super) fn add_to(&self, settings: &mut Settings, robot: &mut dyn Robot) -> std::result::Result<(), RowError> {
        let kind = kind(&self.cells.kind)?;
        if let Some(name) = &self.cells.station {
            self.seen_whole(kind, name)?;
        }
        let Some(pose) = self.pose else {
            let name = self.cells.name("target")?;
            if !kind.facts().is_of_targets {
                check_fixed(name, robot)?;
            }
            settings.known.push(kind.known(self, positive(self.u_mm, OF_LENGTH)?, robot)?);
            return Ok(());
        };
        let observed = kind.observed(self, robot)?;
        if observed.is_empty() {
            return Ok(());
        }
        if self.joints.iter().any(|q| !q.is_finite()) {
            return Err(Problems::from(error!("joint-value-missing")).into());
        }
        let target = target_index(kind, &self.cells.target, robot)?;
        for (kind, own) in observed {
            let (of_row, column) =
                if kind.is_angle() { (self.u_rotation_rad, OF_ROTATION) } else { (self.u_mm, OF_LENGTH) };
            let standard_uncertainty = positive(if own.is_nan() { of_row } else { own }, column)?;
            let (cycle, joints) = (self.cycle, self.joints.clone());
            settings.conditions.push(Condition { pose, cycle, joints, target, kind, standard_uncertainty });
        }
        Ok(())
    }

    /// An error where a row of another station is not a point or a pose with all coordinates and
    /// one uncertainty.
    fn seen_whole(&self, kind: &dyn RowKind, station: &str) -> Result<()> {
        let us = self.u_axes_mm;
        let has_covariance = COVARIANCES.iter().any(|name| self.cells.number(name).is_some_and(|v| !v.is_nan()));
        let fault = match self.xyz_mm.iter().all(|v| v.is_finite()) {
            _ if !kind.facts().has_stations => "kind",
            false => "coordinate",
            true if has_covariance => "covariance",
            true if us[1..].iter().any(|u| u.to_bits() != us[0].to_bits()) => "uncertainties",
            true => return Ok(()),
        };
        Err(error!("station-row-unsupported", station, fault, kind = kind.facts().name).into())
    }
}

/// Index of the target of a row; 0 if the kind needs none.
pub fn target_index(kind: &dyn RowKind, name: &str, robot: &dyn Robot) -> Result<usize> {
    if name.is_empty() && kind.facts().is_of_robot {
        return Ok(0);
    }
    let found = robot.targets().iter().position(|target| target == name);
    Ok(found.ok_or_else(|| error!("not-of-this-robot", name, kind = "target"))?)
}

/// Returns the standard uncertainty in a column if it is positive.
fn positive(standard_uncertainty: f64, column: &'static str) -> std::result::Result<f64, RowError> {
    match standard_uncertainty {
        u if u > 0.0 && u.is_finite() => Ok(u),
        u if !u.is_nan() => Err(Problems::from(error!("uncertainty-not-positive", column, value = u)).into()),
        _ => Err(RowError::Unstated(column)),
    }
}

/// Rows with only some coordinates of a target.
pub(super) fn partial_rows(robot: &dyn Robot, table: &Table) -> Result<Vec<bool>> {
    let columns = XYZ[..robot.dimension()].iter().filter(|name| table.has(name));
    let columns = columns.map(|name| table.numbers(name)).collect::<Result<Vec<_>>>()?;
    let given = |row: usize| columns.iter().filter(|column| !column[row].is_nan()).count();
    // a column that is missing is a mistake
    let whole = columns.len() == robot.dimension();
    Ok((0..table.height()).map(|row| whole && (1..robot.dimension()).contains(&given(row))).collect())
}

/// Rows without a pose.
pub(super) fn fixed_rows(table: &Table) -> Result<Vec<bool>> {
    if !table.has("pose") {
        return Ok(vec![false; table.height()]);
    }
    Ok(table.optional_poses()?.iter().map(Option::is_none).collect())
}

/// The stations of rows outside the frame of the world. The world is the frame of coordinates
/// without a station, otherwise of the first station.
fn other_stations(table: &Table) -> Vec<Option<String>> {
    let rows = 0..table.height();
    let x = table.values(XYZ[0]);
    let measured = |row: &usize| x.is_some_and(|x| !x.number(*row).is_nan());
    let station = |row: usize| table.text(row, STATION);
    let of_points = || rows.clone().filter(measured).map(station);
    let world = of_points().find(Option::is_none).or_else(|| of_points().next()).flatten();
    rows.clone().map(|row| station(row).filter(|name| Some(*name) != world).map(str::to_owned)).collect()
}

/// Numbers of repeats; 1 if none is given.
fn row_cycles(table: &Table) -> Result<Vec<i64>> {
    if !table.has("cycle") {
        return Ok(vec![1; table.height()]);
    }
    Ok(table.optional_integers("cycle")?.into_iter().map(|cycle| cycle.unwrap_or(1)).collect())
}
