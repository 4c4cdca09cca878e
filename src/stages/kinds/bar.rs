//! A bar of constant length that targets of two branches hold between them.

use super::{Cells, Facts, Row, RowKind, Simulated};
use etalon_base::error;
use etalon_base::message::Result;
use etalon_base::pose::Vector;
use etalon_identify::{Between, Fixture, Kind, Known, Separation};
use etalon_robots::Robot;

pub(super) struct Bar;

impl Bar {
    /// The other target, and the parameter of the length.
    fn other_target_and_length(cells: &Cells, robot: &mut dyn Robot) -> Result<(usize, usize)> {
        let name = cells.name("other")?;
        let missing = || error!("bar-without-other-hand", name, target = cells.target);
        let other = cells.other_target("other", robot)?.ok_or_else(missing)?;
        Ok((other, Fixture::Bar([&cells.target, name]).add_to(robot)))
    }
}

impl RowKind for Bar {
    fn facts(&self) -> Facts {
        Facts { name: "bar", numbers: vec!["distance_mm"], is_of_targets: true, ..Facts::default() }
    }

    fn observed(&self, row: &Row, robot: &mut dyn Robot) -> Result<Vec<(Kind, f64)>> {
        let (other, length) = Self::other_target_and_length(&row.cells, robot)?;
        if row.cells.number("distance_mm").is_some_and(|distance| !distance.is_nan()) {
            return Err(error!("bar-length-at-pose").into());
        }
        Ok(vec![(Kind::Between(Between { other, apart: Separation::Bar(length) }), f64::NAN)])
    }

    fn known(&self, row: &Row, standard_uncertainty_mm: f64, robot: &mut dyn Robot) -> Result<Known> {
        let (_, parameter) = Self::other_target_and_length(&row.cells, robot)?;
        Ok(Known::Length { parameter, length_mm: row.cells.distance()?, standard_uncertainty_mm })
    }

    fn simulated(&self, cells: &Cells, robot: &mut dyn Robot) -> Result<Simulated> {
        let (other, length) = Self::other_target_and_length(cells, robot)?;
        let touches = Some(Kind::Between(Between { other, apart: Separation::Bar(length) }));
        Ok(Simulated { touches, ..Simulated::anywhere(|_| Ok(Vec::new())) })
    }

    fn known_simulated(&self, cells: &Cells, near_mm: Option<Vector>, robot: &mut dyn Robot) -> Result<Simulated> {
        if near_mm.is_some() {
            return Err(error!("near-without-surface").into());
        }
        let (_, length) = Self::other_target_and_length(cells, robot)?;
        Ok(Simulated::anywhere(move |at| Ok(vec![("distance_mm", at.length(at.values[length]))])))
    }
}
