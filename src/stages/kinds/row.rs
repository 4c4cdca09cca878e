//! Rows of a table of observations of several kinds.

use super::cells::{ByColumn, Cell, Cells, STATION, check_fixed, names};
use super::kind::RowKind;
use super::{KINDS, Stated, kind};
use crate::stages::orientations::{AngleOrder, Written, written};
use etalon_base::message::{Message, Place, Problems, Result};
use etalon_base::pose::Vector;
use etalon_base::pose_name::PoseName;
use etalon_formats::table;
use etalon_formats::tables::joints::joint_values;
use etalon_identify::{Condition, Settings};
use etalon_robots::Robot;
use polars::prelude::DataFrame;
use std::collections::BTreeMap;

/// Columns of numbers beside those of positions and of single kinds.
const UNCERTAINTIES: [&str; 2] = ["u_mm", "urot_deg"];

/// Columns of numbers of single kinds, in the order in which they are written.
pub fn numbers() -> Vec<&'static str> {
    let mut all: Vec<&str> = Vec::new();
    for name in KINDS.iter().flat_map(|kind| kind.numbers()) {
        if !all.contains(&name) {
            all.push(name);
        }
    }
    all
}

/// Columns of all kinds beside those of positions, to which the target belongs.
pub fn columns<'a>() -> impl Iterator<Item = &'a str> {
    ["kind"].into_iter().chain(names()).chain(numbers()).chain(UNCERTAINTIES)
}

/// A row of a table; numbers that it does not state are NaN, and names empty.
pub struct Row {
    pub line: Option<usize>,
    /// What the row refers to; its kind as stated, or `pose` and `point` with and without an orientation.
    pub cells: Cells,
    /// `None` for rows about fixed things alone.
    pub pose: Option<PoseName>,
    pub cycle: i64,
    /// Joint values (mm or rad) and directions.
    pub joints: Vec<f64>,
    pub xyz_mm: Vector,
    /// Some coordinates of the target are given, and not all.
    pub is_partial: bool,
    pub orientation: Written,
    /// The order of three angles of an orientation.
    pub order: Option<AngleOrder>,
    /// Standard uncertainty of a length: the row's, or that of rows that state none.
    pub u_mm: f64,
    pub u_axes_mm: Vector,
    pub has_covariance: bool,
    /// Standard uncertainty of a rotation, likewise.
    pub u_rotation_rad: f64,
}

/// Columns of a table by name, as far as it has them.
struct Columns {
    numbers: BTreeMap<&'static str, Vec<f64>>,
    texts: BTreeMap<&'static str, Vec<String>>,
}

impl Columns {
    fn read(observations: &DataFrame) -> Result<Self> {
        let has = |name: &&str| observations.column(name).is_ok();
        let numbers = numbers()
            .into_iter()
            .chain(UNCERTAINTIES)
            .chain(table::XYZ)
            .chain(table::UNCERTAINTIES)
            .chain(table::COVARIANCES)
            .filter(has);
        let texts = table::TEXTS.into_iter().filter(has);
        Ok(Self {
            numbers: numbers.map(|name| Ok((name, table::numbers(observations, name)?))).collect::<Result<_>>()?,
            texts: texts.map(|name| Ok((name, table::texts(observations, name)?))).collect::<Result<_>>()?,
        })
    }

    fn number(&self, name: &str, row: usize) -> f64 {
        self.numbers.get(name).map_or(f64::NAN, |column| column[row])
    }

    fn text(&self, name: &str, row: usize) -> String {
        self.texts.get(name).map_or_else(String::new, |column| column[row].clone())
    }

    /// The cells of single kinds.
    fn cells(&self, row: usize) -> ByColumn {
        let names = self.texts.iter().filter(|(_, column)| !column[row].is_empty());
        let names = names.map(|(name, column)| ((*name).to_owned(), Cell::Text(column[row].clone())));
        let numbers = self.numbers.iter().map(|(name, column)| ((*name).to_owned(), Cell::Number(column[row])));
        names.chain(numbers).collect()
    }
}

impl Row {
    /// The rows of a table.
    pub fn read(robot: &dyn Robot, observations: &DataFrame, without: Stated) -> Result<Vec<Self>> {
        let columns = Columns::read(observations)?;
        let (poses, cycles) = (row_poses(observations)?, row_cycles(observations)?);
        table::texts(observations, "target")?;
        let orientations = written(observations)?;
        let joints = joint_values(robot, observations, &[])?;
        let height = observations.height();
        let x_mm: Vec<f64> = (0..height).map(|row| columns.number(table::XYZ[0], row)).collect();
        let stations = other_stations((0..height).map(|row| columns.text(STATION, row)).collect(), &x_mm);
        let partial = partial_rows(robot, observations)?;
        let lines =
            if observations.column("line").is_ok() { table::integers(observations, "line")? } else { Vec::new() };
        let length = if columns.numbers.contains_key("u_mm") { "u_mm" } else { "ux_mm" };
        let or = |stated: f64, other: Option<f64>| if stated.is_nan() { other.unwrap_or(f64::NAN) } else { stated };
        let rows = joints.into_iter().zip(orientations).zip(stations).enumerate();
        type Read = ((Vec<f64>, Written), Option<String>);
        let row = |(row, ((joints, orientation), station)): (usize, Read)| {
            let (number, text) = (|name: &str| columns.number(name, row), |name: &str| columns.text(name, row));
            Self {
                line: lines.get(row).map(|line| *line as usize),
                cells: Cells {
                    kind: match text("kind") {
                        kind if !kind.is_empty() => kind,
                        _ if orientation.is_given() => "pose".to_owned(),
                        _ => "point".to_owned(),
                    },
                    target: text("target"),
                    station,
                    by_column: columns.cells(row),
                    in_truth: false,
                },
                pose: poses[row],
                cycle: cycles[row],
                joints,
                xyz_mm: table::XYZ.map(number),
                is_partial: partial[row],
                orientation,
                order: without.order,
                u_mm: or(number(length), without.length_mm),
                u_axes_mm: table::UNCERTAINTIES.map(number),
                has_covariance: table::COVARIANCES.iter().any(|name| !number(name).is_nan()),
                u_rotation_rad: or(number("urot_deg").to_radians(), without.rotation_rad),
            }
        };
        Ok(rows.map(row).collect())
    }

    /// Line of the row.
    pub fn place(&self) -> Place {
        Place { line: self.line, ..Place::default() }
    }

    /// `true` if the row gives a position in the world, all of its coordinates.
    pub fn has_position(&self) -> bool {
        self.pose.is_some()
            && !self.is_partial
            && self.cells.station.is_none()
            && kind(&self.cells.kind).is_ok_and(|kind| kind.has_position())
            && self.xyz_mm.iter().any(|v| !v.is_nan())
    }

    /// Place of a fixed point, mm.
    pub(super) fn fixed_place(&self) -> Result<Vector> {
        if self.xyz_mm.iter().any(|v| !v.is_finite()) {
            let what = format!("the place of `{}` is missing or not a number", self.cells.target);
            return Err(Message::error(what).into());
        }
        Ok(self.xyz_mm)
    }

    /// Adds what the row states to `settings`, unless it is the position of a target alone.
    pub fn add_to(&self, settings: &mut Settings, robot: &mut dyn Robot) -> Result<()> {
        let kind = kind(&self.cells.kind)?;
        if let Some(name) = &self.cells.station {
            self.seen_whole(kind, name)?;
        }
        let Some(pose) = self.pose else {
            check_fixed(self.cells.name("target")?, robot)?;
            settings.known.push(kind.known(self, positive(self.u_mm, false)?, robot)?);
            return Ok(());
        };
        let observed = kind.observed(self, robot)?;
        if observed.is_empty() {
            return Ok(());
        }
        if self.joints.iter().any(|q| !q.is_finite()) {
            return Err(Message::error("a joint value is missing or not a number").into());
        }
        let target = target_of(kind, &self.cells.target, robot)?;
        for (kind, own) in observed {
            let of_row = if kind.is_angle() { self.u_rotation_rad } else { self.u_mm };
            let standard_uncertainty = positive(if own.is_nan() { of_row } else { own }, kind.is_angle())?;
            let (cycle, joints) = (self.cycle, self.joints.clone());
            settings.conditions.push(Condition { pose, cycle, joints, target, kind, standard_uncertainty });
        }
        Ok(())
    }

    /// An error where a row of another station is not a point with all coordinates and one uncertainty.
    fn seen_whole(&self, kind: &dyn RowKind, station: &str) -> Result<()> {
        let us = self.u_axes_mm;
        let what = match self.xyz_mm.iter().all(|v| v.is_finite()) {
            _ if !kind.is_position() => format!("a row of kind `{}` states the station `{station}`", kind.name()),
            false => format!("a coordinate of what station `{station}` measured is missing or not a number"),
            true if self.has_covariance => format!("what station `{station}` measured states a covariance"),
            true if us[1..].iter().any(|u| u.to_bits() != us[0].to_bits()) => {
                format!("the coordinates that station `{station}` measured have uncertainties of their own")
            }
            true => return Ok(()),
        };
        let expected =
            "rows of kind `point` with x_mm, y_mm, z_mm and one uncertainty `u_mm`, for stations other than the first";
        Err(Message::error(what).expected(expected).into())
    }
}

/// Index of the target of a row; 0 if the kind needs none.
pub fn target_of(kind: &dyn RowKind, name: &str, robot: &dyn Robot) -> Result<usize> {
    if name.is_empty() && !kind.has_target() {
        return Ok(0);
    }
    let found = robot.targets().iter().position(|target| target == name);
    Ok(found.ok_or_else(|| Message::error(format!("`{name}` is not a target of this robot")))?)
}

fn positive(standard_uncertainty: f64, is_angle: bool) -> Result<f64> {
    let (column, option) = match is_angle {
        true => ("urot_deg", "--rotation-uncertainty-deg"),
        false => ("u_mm", "--standard-uncertainty-um"),
    };
    match standard_uncertainty {
        u if u > 0.0 && u.is_finite() => Ok(u),
        u if !u.is_nan() => Err(Message::error(format!("`{column}` = {u} is not a standard uncertainty")).into()),
        _ => Err(Message::error("the row has no standard uncertainty")
            .hint(format!("state {option}, or a column `{column}`"))
            .into()),
    }
}

/// Rows that give some coordinates of a target, and not all.
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

/// The stations of rows that are not in the frame of the world: that of coordinates without a station, or else of the first with one.
fn other_stations(stations: Vec<String>, x_mm: &[f64]) -> Vec<Option<String>> {
    let of_points = || stations.iter().zip(x_mm).filter(|(_, x)| !x.is_nan()).map(|(name, _)| name);
    let world = of_points().find(|name| name.is_empty()).or_else(|| of_points().next()).cloned().unwrap_or_default();
    stations.into_iter().map(|name| Some(name).filter(|name| !name.is_empty() && *name != world)).collect()
}

/// The name of the pose of each row; `None` for rows about fixed things alone.
pub(super) fn row_poses(observations: &DataFrame) -> Result<Vec<Option<PoseName>>> {
    let name = |(name, fixed): (String, bool)| match name.as_str() {
        _ if fixed => Ok(None),
        "" => Ok(Some(PoseName::from(0))),
        name => PoseName::new(name).map(Some).map_err(Problems::from),
    };
    table::texts(observations, "pose")?.into_iter().zip(fixed_rows(observations)?).map(name).collect()
}

/// Numbers of repeats; 1 where none is stated.
fn row_cycles(observations: &DataFrame) -> Result<Vec<i64>> {
    match observations.column("cycle") {
        Ok(_) => {
            let cycles = table::optional_integers(observations, "cycle")?;
            Ok(cycles.into_iter().map(|cycle| cycle.unwrap_or(1)).collect())
        }
        Err(_) => Ok(vec![1; observations.height()]),
    }
}
