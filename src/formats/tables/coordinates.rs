//! Positions and angles of a table `x_mm,y_mm[,z_mm][,a_deg][,b_deg][,c_deg]`, checked.

use crate::table::{ANGLES, RADIANS, Table, XYZ, state_columns};
use etalon_base::message::{Message, Place, Problems, Result};
use etalon_base::pose::Vector;
use etalon_base::pose_name::{PoseName, two_spellings};
use etalon_base::{error, warning};

/// Coordinates of all rows.
#[derive(Clone, Debug, PartialEq)]
pub struct Coordinates {
    /// Positions; z is zero for planar robots.
    pub positions_mm: Vec<Vector>,
    /// Values of all rows for each angle.
    pub angles_rad: Vec<Vec<f64>>,
    /// `true` if there is a z.
    pub spatial: bool,
    /// Indices of the angles: 0, 1, 2 for a, b, c.
    pub angles: Vec<usize>,
}

/// Kinds of coordinates in a file.
#[derive(Clone, Copy, Debug)]
pub struct CoordinatesOf<'a> {
    /// File as named by the user.
    pub file: &'a str,
    /// `true` if there is a z.
    pub spatial: bool,
    /// Indices of the angles: 0, 1, 2 for a, b, c.
    pub angles: &'a [usize],
}

/// Checks that two tables have the same coordinates (z, angles).
pub fn like(here: CoordinatesOf, there: CoordinatesOf) -> Result<()> {
    if (here.spatial, here.angles) == (there.spatial, there.angles) {
        return Ok(());
    }
    Err(error!("coordinates-differ", file = there.file).at(Place::file(here.file)).into())
}

impl Table {
    /// Returns the names of poses, each in one spelling.
    pub fn pose_names(&self) -> Result<Vec<PoseName>> {
        let poses = self.poses().map_err(|p| self.in_file(p))?;
        match two_spellings(poses.iter().copied().map(Some)) {
            Some((message, row)) => Err(message.at(self.place(row)).into()),
            None => Ok(poses),
        }
    }

    /// `true` if there is a z that is not empty.
    pub fn is_spatial(&self) -> Result<bool> {
        let z = XYZ[2];
        Ok(self.has(z) && self.numbers(z)?.iter().any(|z| !z.is_nan()))
    }

    /// Returns the coordinates of all rows.
    ///
    /// # Errors
    /// Reports empty and non-finite cells, with their lines.
    pub fn coordinates(&self) -> Result<Coordinates> {
        let read = || -> Result<Coordinates> {
            self.require(self.coordinate_columns())?;
            let angles: Vec<usize> = (0..3).filter(|&k| self.has(ANGLES[k]) || self.has(RADIANS[k])).collect();
            let radians = |&k: &usize| match self.has(ANGLES[k]) {
                true => Ok(self.numbers(ANGLES[k])?.into_iter().map(f64::to_radians).collect()),
                false => self.numbers(RADIANS[k]),
            };
            Ok(Coordinates {
                positions_mm: self.positions()?,
                angles_rad: angles.iter().map(radians).collect::<Result<_>>()?,
                spatial: self.is_spatial()?,
                angles,
            })
        };
        let all = read().map_err(|p| self.in_file(p))?;
        // the square of a larger value overflows
        let usable = |v: &f64| v.abs() < 1e100;
        let sound = |i: usize| all.positions_mm[i].iter().all(usable) && all.angles_rad.iter().all(|a| usable(&a[i]));
        let bad = (0..all.positions_mm.len()).filter(|&i| !sound(i));
        let bad = bad.map(|i| error!("coordinate-missing").at(self.place(i)));
        Problems(bad.take(20).collect()).check()?;
        Ok(all)
    }

    /// Returns a warning about columns other than coordinates and those in `read`. If their
    /// headings name missing coordinates, the hint gives them.
    pub fn unread(&self, read: &[&str]) -> Option<Message> {
        let in_radians = |name: &&str| ANGLES.iter().zip(RADIANS).any(|(deg, rad)| rad == *name && !self.has(deg));
        let known: Vec<&str> = read.iter().chain(&XYZ).chain(&ANGLES).copied().collect();
        let others: Vec<&str> = self.names().filter(|name| !known.contains(name) && !in_radians(name)).collect();
        let first = *others.first()?;
        let columns: Vec<String> = others.iter().map(|name| format!("`{name}`")).collect();
        let message = warning!("columns-not-read", count = columns.len(), columns).routine();
        let message = message.at(Place::file(self.file()));
        let optional = XYZ[2..].iter().chain(&ANGLES).copied().filter(|name| !self.has(name));
        let meant: Vec<(&str, &str)> =
            optional.filter_map(|name| Some((name, self.heading_of_coordinate(name)?))).collect();
        let hint = state_columns(&meant);
        match meant.is_empty() {
            true => Some(message.hint_names(first, known.iter().copied())),
            false => Some(message.hint(hint)),
        }
    }

    /// Places problems without a place in the file of the table.
    pub fn in_file(&self, problems: impl Into<Problems>) -> Problems {
        problems.into().at(&Place::file(self.file()))
    }
}
