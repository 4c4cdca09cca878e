//! Rows of a table of observations of several kinds.

use super::Stated;
use crate::stages::orientations::{Written, written};
use etalon_base::message::{Place, Problems, Result};
use etalon_base::pose::Vector;
use etalon_base::pose_name::PoseName;
use etalon_formats::table;
use etalon_formats::tables::joints::joint_values;
use etalon_robots::Robot;
use polars::prelude::DataFrame;
use std::collections::BTreeMap;

/// Columns of numbers of all kinds beside those of positions.
const NUMBERS: [&str; 22] = [
    "qw",
    "qx",
    "qy",
    "qz",
    "rx_deg",
    "ry_deg",
    "rz_deg",
    "rx_rad",
    "ry_rad",
    "rz_rad",
    "a_deg",
    "b_deg",
    "c_deg",
    "a_rad",
    "b_rad",
    "c_rad",
    "value_deg",
    "value_mm",
    "distance_mm",
    "offset_mm",
    "u_mm",
    "urot_deg",
];
/// Column of the name of a line: `line` are the lines of the file.
pub(super) const LINE: &str = "line_name";
/// Column of the name of the station of the instrument that measured a point.
pub(super) const STATION: &str = "station";
/// Columns of all kinds beside those of positions, to which the target belongs.
pub fn columns<'a>() -> impl Iterator<Item = &'a str> {
    table::TEXTS.into_iter().filter(|name| *name != "target").chain(NUMBERS)
}

/// A row of a table; numbers that it does not state are NaN, and names empty.
pub(super) struct Row {
    pub line: Option<usize>,
    /// Kind as stated, or `pose` and `point` with and without an orientation.
    pub kind: String,
    /// `None` for rows about fixed things alone.
    pub pose: Option<PoseName>,
    pub cycle: i64,
    /// Joint values (mm or rad) and directions.
    pub joints: Vec<f64>,
    pub target: String,
    pub xyz_mm: Vector,
    /// Some coordinates of the target are given, and not all.
    pub is_partial: bool,
    pub orientation: Written,
    /// Station other than the one whose frame is the world.
    pub station: Option<String>,
    /// The row names its station.
    pub has_station: bool,
    pub socket: String,
    pub other: String,
    pub plane: String,
    pub line_name: String,
    pub sphere: String,
    pub axis: String,
    pub joint: String,
    pub value_rad: f64,
    pub value_mm: f64,
    pub distance_mm: f64,
    pub offset_mm: f64,
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
        let numbers = ["value_deg", "value_mm", "distance_mm", "offset_mm", "u_mm", "urot_deg"].into_iter();
        let numbers = numbers.chain(table::XYZ).chain(table::UNCERTAINTIES).chain(table::COVARIANCES).filter(has);
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
        let line = table::lines(observations)?;
        let length = if columns.numbers.contains_key("u_mm") { "u_mm" } else { "ux_mm" };
        let or = |stated: f64, other: Option<f64>| if stated.is_nan() { other.unwrap_or(f64::NAN) } else { stated };
        let rows = joints.into_iter().zip(orientations).zip(stations).enumerate();
        type Read = ((Vec<f64>, Written), Option<String>);
        let row = |(row, ((joints, orientation), station)): (usize, Read)| {
            let (number, text) = (|name: &str| columns.number(name, row), |name: &str| columns.text(name, row));
            Self {
                line: line(row),
                kind: match text("kind") {
                    kind if !kind.is_empty() => kind,
                    _ if orientation.is_given() => "pose".to_owned(),
                    _ => "point".to_owned(),
                },
                pose: poses[row],
                cycle: cycles[row],
                joints,
                target: text("target"),
                xyz_mm: table::XYZ.map(number),
                is_partial: partial[row],
                orientation,
                station,
                has_station: !text(STATION).is_empty(),
                socket: text("socket"),
                other: text("other"),
                plane: text("plane"),
                line_name: text(LINE),
                sphere: text("sphere"),
                axis: text("axis"),
                joint: text("joint"),
                value_rad: number("value_deg").to_radians(),
                value_mm: number("value_mm"),
                distance_mm: number("distance_mm"),
                offset_mm: if columns.numbers.contains_key("offset_mm") { number("offset_mm") } else { 0.0 },
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
            && self.station.is_none()
            && matches!(self.kind.as_str(), "point" | "pose")
            && self.xyz_mm.iter().any(|v| !v.is_nan())
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
