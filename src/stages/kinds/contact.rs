//! A target in a socket, or at a target of another branch.

use super::{Cells, Facts, Row, RowKind, Simulated};
use etalon_base::message::Result;
use etalon_identify::{Between, Kind, Separation};
use etalon_robots::Robot;

pub(super) struct Contact;

impl Contact {
    fn contact_kind(cells: &Cells, robot: &mut dyn Robot) -> Result<Kind> {
        if let Some(other) = cells.other_target("socket", robot)? {
            return Ok(Kind::Between(Between { other, apart: Separation::Touching }));
        }
        Ok(Kind::Contact(etalon_identify::Contact { socket: cells.point("socket", robot)? }))
    }
}

impl RowKind for Contact {
    fn facts(&self) -> Facts {
        Facts { name: "contact", ..Facts::default() }
    }

    fn observed(&self, row: &Row, robot: &mut dyn Robot) -> Result<Vec<(Kind, f64)>> {
        Ok(vec![(Self::contact_kind(&row.cells, robot)?, f64::NAN)])
    }

    fn simulated(&self, cells: &Cells, robot: &mut dyn Robot) -> Result<Simulated> {
        Ok(Simulated { touches: Some(Self::contact_kind(cells, robot)?), ..Simulated::anywhere(|_| Ok(Vec::new())) })
    }
}
