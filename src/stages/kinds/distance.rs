//! The distance of a target from a fixed point or from a target of another branch, or of two fixed
//! points.

use super::{Cells, Facts, Row, RowKind, Simulated};
use etalon_base::error;
use etalon_base::message::Result;
use etalon_base::pose::{Vector, minus, norm};
use etalon_identify::{Between, Fixture, Kind, Known, Separation};
use etalon_robots::Robot;

pub(super) struct Distance;

impl RowKind for Distance {
    fn facts(&self) -> Facts {
        Facts { name: "distance", numbers: vec!["distance_mm"], ..Facts::default() }
    }

    fn observed(&self, row: &Row, robot: &mut dyn Robot) -> Result<Vec<(Kind, f64)>> {
        if let Some(other) = row.cells.other_target("other", robot)? {
            let apart = Separation::Distance(row.cells.distance()?);
            return Ok(vec![(Kind::Between(Between { other, apart }), f64::NAN)]);
        }
        let to = row.cells.point("other", robot)?;
        let distance = etalon_identify::Distance { to, distance_mm: row.cells.distance()? };
        Ok(vec![(Kind::Distance(distance), f64::NAN)])
    }

    fn known(&self, row: &Row, standard_uncertainty_mm: f64, robot: &mut dyn Robot) -> Result<Known> {
        let name = &row.cells.target;
        let from = Fixture::Point(name).add_to(robot);
        let to = row.cells.point("other", robot)?;
        if to == from {
            return Err(error!("distance-to-itself", name).into());
        }
        Ok(Known::Distance { from, to, distance_mm: row.cells.distance()?, standard_uncertainty_mm })
    }

    fn simulated(&self, cells: &Cells, robot: &mut dyn Robot) -> Result<Simulated> {
        if let Some(other) = cells.other_target("other", robot)? {
            return Ok(Simulated::anywhere(move |at| {
                let distance = norm(minus(at.position, at.robot.position(at.values, at.joints, other)));
                Ok(vec![("distance_mm", at.length(distance))])
            }));
        }
        let to = cells.point("other", robot)?;
        Ok(Simulated::anywhere(move |at| {
            let distance = norm(minus(at.position, at.point(to)));
            Ok(vec![("distance_mm", at.length(distance))])
        }))
    }

    fn known_simulated(&self, cells: &Cells, near_mm: Option<Vector>, robot: &mut dyn Robot) -> Result<Simulated> {
        Simulated::fixed(self, cells, near_mm, robot)
    }
}
