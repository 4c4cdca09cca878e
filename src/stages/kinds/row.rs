//! Rows of a table of observations of several kinds.

use super::cells::{ByColumn, Cell, Cells, STATION, check_fixed, names, text};
use super::{KINDS, RowDefaults, RowKind, kind};
use crate::stages::orientations::{AngleOrder, Written, written};
use etalon_base::error;
use etalon_base::message::{Place, Problems, Result};
use etalon_base::pose::Vector;
use etalon_base::pose_name::PoseName;
use etalon_formats::table;
use etalon_formats::tables::joints::joint_values;
use etalon_identify::{Condition, Settings};
use etalon_robots::Robot;
use polars::prelude::DataFrame;

/// Columns of uncertainties.
const UNCERTAINTIES: [&str; 2] = ["u_mm", "urot_deg"];

/// Columns of numbers of single kinds, in the order in which they are written.
pub fn numbers() -> Vec<&'static str> {
    let mut all = Vec::new();
    for name in KINDS.iter().flat_map(|kind| kind.facts().numbers) {
        all.retain(|other| *other != name);
        all.push(name);
    }
    all
}

/// Columns of all kinds in addition to the columns of positions (the target is one).
pub fn columns<'a>() -> Vec<&'a str> {
    ["kind"].into_iter().chain(names()).chain(numbers()).chain(UNCERTAINTIES).collect()
}

/// A row of a table; missing numbers are NaN, and missing names empty.
pub struct Row {
    pub(super) line: Option<usize>,
    /// References of the row; its kind as stated, or `pose` and `point` with and without an
    /// orientation.
    pub(super) cells: Cells,
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
    /// Standard uncertainty of a length (mm): the row's own, or the one stated for all rows.
    pub(super) u_mm: f64,
    pub(super) u_axes_mm: Vector,
    /// Standard uncertainty of a rotation (rad), likewise.
    pub(super) u_rotation_rad: f64,
}

/// The cells of each row: numbers, and non-empty texts.
fn cells(observations: &DataFrame) -> Result<Vec<ByColumn>> {
    let mut rows = vec![ByColumn::new(); observations.height()];
    let has = |name: &&str| observations.column(name).is_ok();
    for name in table::TEXTS.into_iter().filter(has) {
        let texts = table::texts(observations, name)?.into_iter();
        for (row, text) in rows.iter_mut().zip(texts).filter(|(_, text)| !text.is_empty()) {
            row.insert(name.to_owned(), Cell::Text(text));
        }
    }
    let of_positions = table::XYZ.into_iter().chain(table::UNCERTAINTIES).chain(table::COVARIANCES);
    for name in numbers().into_iter().chain(UNCERTAINTIES).chain(of_positions).filter(has) {
        for (row, number) in rows.iter_mut().zip(table::numbers(observations, name)?) {
            row.insert(name.to_owned(), Cell::Number(number));
        }
    }
    Ok(rows)
}

impl Row {
    /// Axes of the target's coordinates that the row lacks, if it has others.
    pub(super) fn missing_axes(&self) -> Vec<&'static str> {
        let axes = ["x", "y", "z"].into_iter().zip(self.xyz_mm);
        axes.filter(|(_, value)| self.is_partial && value.is_nan()).map(|(axis, _)| axis).collect()
    }

    /// The rows of a table.
    pub fn read(robot: &dyn Robot, observations: &DataFrame, without: RowDefaults) -> Result<Vec<Self>> {
        let cells = cells(observations)?;
        let (poses, cycles) = (row_poses(observations)?, row_cycles(observations)?);
        table::texts(observations, "target")?;
        let orientations = written(observations)?;
        let joints = joint_values(robot, observations, &[])?;
        let stations = other_stations(&cells);
        let partial = partial_rows(robot, observations)?;
        let line = table::lines(observations)?;
        let or = |stated: f64, other: Option<f64>| if stated.is_nan() { other.unwrap_or(f64::NAN) } else { stated };
        let rows = cells.into_iter().zip(joints).zip(orientations).zip(stations).enumerate();
        let rows = rows.map(|(row, (((by_column, joints), orientation), station))| {
            let owned = |column: &str| text(&by_column, column).map(str::to_owned);
            let unstated = if orientation.is_stated() { "pose" } else { "point" };
            let kind = owned("kind").unwrap_or_else(|| unstated.to_owned());
            let target = owned("target").unwrap_or_default();
            let cells = Cells { kind, target, station, by_column, in_truth: false };
            let number = |column: &str| cells.number(column).unwrap_or(f64::NAN);
            Self {
                line: line(row),
                pose: poses[row],
                cycle: cycles[row],
                joints,
                xyz_mm: table::XYZ.map(number),
                is_partial: partial[row],
                orientation,
                order: orientation.order.or(without.order),
                u_mm: or(or(number("u_mm"), cells.number("ux_mm")), without.length_mm),
                u_axes_mm: table::UNCERTAINTIES.map(number),
                u_rotation_rad: or(number("urot_deg").to_radians(), without.rotation_rad),
                cells,
            }
        });
        Ok(rows.collect())
    }

    /// Line of the row.
    pub fn place(&self) -> Place {
        Place { line: self.line, ..Place::default() }
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

    /// Adds the statements of the row to `settings`, unless it is only the position of a target.
    pub fn add_to(&self, settings: &mut Settings, robot: &mut dyn Robot) -> Result<()> {
        let kind = kind(&self.cells.kind)?;
        if let Some(name) = &self.cells.station {
            self.seen_whole(kind, name)?;
        }
        let Some(pose) = self.pose else {
            let name = self.cells.name("target")?;
            if !kind.facts().is_of_targets {
                check_fixed(name, robot)?;
            }
            settings.known.push(kind.known(self, positive(self.u_mm, false)?, robot)?);
            return Ok(());
        };
        let observed = kind.observed(self, robot)?;
        if observed.is_empty() {
            return Ok(());
        }
        if self.joints.iter().any(|q| !q.is_finite()) {
            return Err(error!("joint-value-missing").into());
        }
        let target = target_index(kind, &self.cells.target, robot)?;
        for (kind, own) in observed {
            let of_row = if kind.is_angle() { self.u_rotation_rad } else { self.u_mm };
            let standard_uncertainty = positive(if own.is_nan() { of_row } else { own }, kind.is_angle())?;
            let (cycle, joints) = (self.cycle, self.joints.clone());
            settings.conditions.push(Condition { pose, cycle, joints, target, kind, standard_uncertainty });
        }
        Ok(())
    }

    /// An error where a row of another station is not a point or a pose with all coordinates and
    /// one uncertainty.
    fn seen_whole(&self, kind: &dyn RowKind, station: &str) -> Result<()> {
        let us = self.u_axes_mm;
        let has_covariance = table::COVARIANCES.iter().any(|name| self.cells.number(name).is_some_and(|v| !v.is_nan()));
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

fn positive(standard_uncertainty: f64, is_angle: bool) -> Result<f64> {
    let column = if is_angle { "urot_deg" } else { "u_mm" };
    match standard_uncertainty {
        u if u > 0.0 && u.is_finite() => Ok(u),
        u if !u.is_nan() => Err(error!("uncertainty-not-positive", column, value = u).into()),
        _ => {
            Err(error!("uncertainty-missing", column, count = 1, by = "pose", rows = Vec::<String>::new(), more = 0)
                .into())
        }
    }
}

/// Rows with only some coordinates of a target.
pub(super) fn partial_rows(robot: &dyn Robot, observations: &DataFrame) -> Result<Vec<bool>> {
    let columns = table::XYZ[..robot.dimension()].iter().filter(|name| observations.column(name).is_ok());
    let columns = columns.map(|name| table::numbers(observations, name)).collect::<Result<Vec<_>>>()?;
    let given = |row: usize| columns.iter().filter(|column| !column[row].is_nan()).count();
    // a column that is missing is a mistake
    let whole = columns.len() == robot.dimension();
    Ok((0..observations.height()).map(|row| whole && (1..robot.dimension()).contains(&given(row))).collect())
}

/// Rows without a pose.
pub(super) fn fixed_rows(observations: &DataFrame) -> Result<Vec<bool>> {
    let Ok(poses) = observations.column("pose") else { return Ok(vec![false; observations.height()]) };
    Ok(poses.is_null().iter().map(|null| null == Some(true)).collect())
}

/// The stations of rows outside the frame of the world, which is that of coordinates without a
/// station, or else of the first station.
fn other_stations(rows: &[ByColumn]) -> Vec<Option<String>> {
    let measured = |row: &&ByColumn| matches!(row.get(table::XYZ[0]), Some(Cell::Number(x)) if !x.is_nan());
    let of_points = || rows.iter().filter(measured).map(|row| text(row, STATION));
    let world = of_points().find(Option::is_none).or_else(|| of_points().next()).flatten();
    rows.iter().map(|row| text(row, STATION).filter(|name| Some(*name) != world).map(str::to_owned)).collect()
}

/// The name of the pose of each row; `None` for rows about fixed points and surfaces alone.
pub(super) fn row_poses(observations: &DataFrame) -> Result<Vec<Option<PoseName>>> {
    let name = |(name, fixed): (String, bool)| match name.as_str() {
        _ if fixed => Ok(None),
        "" => Ok(Some(PoseName::from(0))),
        name => PoseName::new(name).map(Some).map_err(Problems::from),
    };
    table::texts(observations, "pose")?.into_iter().zip(fixed_rows(observations)?).map(name).collect()
}

/// Numbers of repeats; 1 if none is stated.
fn row_cycles(observations: &DataFrame) -> Result<Vec<i64>> {
    match observations.column("cycle") {
        Ok(_) => {
            let cycles = table::optional_integers(observations, "cycle")?;
            Ok(cycles.into_iter().map(|cycle| cycle.unwrap_or(1)).collect())
        }
        Err(_) => Ok(vec![1; observations.height()]),
    }
}
