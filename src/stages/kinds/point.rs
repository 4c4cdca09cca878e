//! The position of a target (single coordinates, and positions from further stations, are
//! conditions), or the position of a fixed point.

use super::kind::Measurement;
use super::kind::xyz;
use super::{Cells, Facts, Row, RowKind, Simulated};
use etalon_base::error;
use etalon_base::message::Result;
use etalon_base::pose::{Pose, Vector};
use etalon_identify::{Coordinate, Fixture, Kind, Known, Seen};
use etalon_robots::Robot;

pub(super) struct Point;

impl RowKind for Point {
    fn facts(&self) -> Facts {
        Facts { name: "point", has_position: true, is_position: true, has_stations: true, ..Facts::default() }
    }

    fn observed(&self, row: &Row, robot: &mut dyn Robot) -> Result<Vec<(Kind, f64)>> {
        if row.is_partial {
            let given = (0..3).filter(|&axis| !row.xyz_mm[axis].is_nan());
            let coordinate = |axis| Kind::Coordinate(Coordinate { axis, at_mm: row.xyz_mm[axis] });
            return Ok(given.map(|axis| (coordinate(axis), row.u_axes_mm[axis])).collect());
        }
        let seen = |station| (Kind::Seen(Seen { station, at_mm: row.xyz_mm }), f64::NAN);
        Ok(row.cells.station(robot)?.map(seen).into_iter().collect())
    }

    fn known(&self, row: &Row, standard_uncertainty_mm: f64, robot: &mut dyn Robot) -> Result<Known> {
        let point = Fixture::Point(&row.cells.target).add_to(robot);
        let place_mm = row.fixed_place()?;
        Ok(match row.cells.station(robot)? {
            Some(station) => Known::Seen { station, point, at_mm: place_mm, standard_uncertainty_mm },
            None => Known::Place { point, place_mm, standard_uncertainty_mm },
        })
    }

    fn simulated(&self, cells: &Cells, robot: &mut dyn Robot) -> Result<Simulated> {
        if let Some(station) = cells.station(robot)? {
            return Ok(Simulated::anywhere(move |at| {
                let seen = in_station(at, station).apply(at.position);
                Ok(xyz(at.place(seen)))
            }));
        }
        let measured = coordinates(cells.text("coordinates").unwrap_or("xyz"))?;
        Ok(Simulated::anywhere(move |at| {
            let seen = xyz(at.place(at.position)).into_iter().zip(measured).take(at.robot.dimension());
            Ok(seen.filter(|(_, measured)| *measured).map(|(cell, _)| cell).collect())
        }))
    }

    fn known_simulated(&self, cells: &Cells, near_mm: Option<Vector>, robot: &mut dyn Robot) -> Result<Simulated> {
        Simulated::fixed(self, cells, near_mm, robot)
    }
}

/// Pose of the world in the frame of the station whose first parameter is `station`.
pub(super) fn in_station(at: &Measurement, station: usize) -> Pose {
    let turned = Pose::from_rotation_vector(at.point(station + 3));
    let world_T_station = Pose { translation_mm: at.point(station), ..turned };
    world_T_station.inverse()
}

/// The coordinates that a text names.
fn coordinates(text: &str) -> Result<[bool; 3]> {
    let known = text.chars().all(|c| "xyz".contains(c)) && !text.is_empty();
    let wrong = || error!("coordinates-unknown", text);
    if known { Ok(["x", "y", "z"].map(|axis| text.contains(axis))) } else { Err(wrong().into()) }
}
