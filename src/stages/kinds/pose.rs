//! Position of a target and orientation of the body that carries it, in the world or as another
//! station of the instrument measures them.

use super::kind::{spatial_arm_message, xyz};
use super::point::in_station;
use super::{Cells, Facts, Row, RowKind, Simulated};
use crate::stages::orientations;
use etalon_base::message::Result;
use etalon_base::pose::Pose;
use etalon_identify::{Fixture, Kind, Orientation, Seen};
use etalon_robots::Robot;

pub(super) struct Body;

impl RowKind for Body {
    fn facts(&self) -> Facts {
        let numbers = orientations::columns().collect();
        Facts { name: "pose", numbers, has_position: true, has_stations: true, ..Facts::default() }
    }

    fn observed(&self, row: &Row, robot: &mut dyn Robot) -> Result<Vec<(Kind, f64)>> {
        let mounting = Fixture::Mounting(&row.cells.target).add_to(robot);
        let frame_T_body = row.orientation.pose(row.order)?;
        let station = row.cells.station(robot)?;
        let seen = station.map(|station| Kind::Seen(Seen { station, at_mm: row.xyz_mm }));
        let turned = Kind::Orientation(Orientation { frame_T_body, station, mounting });
        Ok(seen.into_iter().chain([turned]).map(|kind| (kind, f64::NAN)).collect())
    }

    fn simulated(&self, cells: &Cells, robot: &mut dyn Robot) -> Result<Simulated> {
        let mounting = Fixture::Mounting(&cells.target).add_to(robot);
        let station = cells.station(robot)?;
        Ok(Simulated::anywhere(move |at| {
            let frame_T_world = station.map_or_else(Pose::identity, |station| in_station(at, station));
            let mut numbers = xyz(at.place(frame_T_world.apply(at.position)));
            let arm = at.robot.free_base().ok_or_else(|| spatial_arm_message("poses", at.robot))?;
            let body =
                arm.flange(at.values, at.joints, at.target).then(&Pose::from_rotation_vector(at.point(mounting)));
            let sigma_rad = at.sigma_rad.clone()?;
            let off = Pose::from_rotation_vector([0.0; 3].map(|v| v + at.noise.gaussian(sigma_rad)));
            let seen = frame_T_world.then(&off.then(&body));
            numbers.extend(orientations::numbers(&seen, at.order, at.is_vector));
            Ok(numbers)
        }))
    }
}
