//! Position of a target and orientation of the body that carries it.

use super::kind::{not_of, xyz};
use super::{Cells, Facts, Row, RowKind, Simulated};
use crate::stages::orientations;
use etalon_base::message::Result;
use etalon_base::pose::Pose;
use etalon_identify::{Fixture, Kind, Orientation};
use etalon_robots::Robot;

pub(super) struct Body;

impl RowKind for Body {
    fn facts(&self) -> Facts {
        let numbers = orientations::columns().collect();
        Facts { name: "pose", numbers, has_position: true, ..Facts::default() }
    }

    fn observed(&self, row: &Row, robot: &mut dyn Robot) -> Result<Vec<(Kind, f64)>> {
        let mounting = Fixture::Mounting(&row.cells.target).add_to(robot);
        let world_T_body = row.orientation.pose(row.order)?;
        Ok(vec![(Kind::Orientation(Orientation { world_T_body, mounting }), f64::NAN)])
    }

    fn simulated(&self, cells: &Cells, robot: &mut dyn Robot) -> Result<Simulated> {
        let mounting = Fixture::Mounting(&cells.target).add_to(robot);
        Ok(Simulated::anywhere(move |at| {
            let mut numbers = xyz(at.place(at.position));
            let arm = at.robot.free_base().ok_or_else(|| not_of("poses", at.robot))?;
            let body = arm.flange(at.values, at.joints).then(&Pose::from_rotation_vector(at.point(mounting)));
            let sigma_rad = at.sigma_rad.clone()?;
            let off = Pose::from_rotation_vector([0.0; 3].map(|v| v + at.noise.gaussian(sigma_rad)));
            numbers.extend(orientations::numbers(&off.then(&body), at.order, at.is_vector));
            Ok(numbers)
        }))
    }
}
