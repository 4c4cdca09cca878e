//! Positions and angles of a table `x_mm,y_mm[,z_mm][,a_deg][,b_deg][,c_deg]`, checked.

use crate::table::{self, ANGLES};
use etalon_base::message::{Message, Place, Problems, Result};
use etalon_base::pose::Vector;
use etalon_base::pose_name::{PoseName, two_spellings};
use etalon_base::{error, warning};
use polars::prelude::DataFrame;

/// A table with the name of its file, for messages.
#[derive(Clone, Copy, Debug)]
pub struct NamedTable<'a> {
    /// File as named by the user.
    pub file: &'a str,
    /// Columns of the table, and `line` with the line of each row.
    pub frame: &'a DataFrame,
}

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

impl NamedTable<'_> {
    /// `true` if there is a column of this name.
    pub fn has(&self, column: &str) -> bool {
        self.frame.column(column).is_ok()
    }

    /// Returns the names of poses, each in one spelling.
    pub fn poses(&self) -> Result<Vec<PoseName>> {
        let poses = table::poses(self.frame).map_err(|p| self.place(p))?;
        match two_spellings(poses.iter().copied().map(Some)) {
            Some((message, row)) => Err(self.at_row(message, row).into()),
            None => Ok(poses),
        }
    }

    /// Returns a column of whole numbers without gaps.
    pub fn integers(&self, column: &str) -> Result<Vec<i64>> {
        table::integers(self.frame, column).map_err(|p| self.place(p))
    }

    /// Returns a column as text; missing values are empty.
    pub fn texts(&self, column: &str) -> Result<Vec<String>> {
        table::texts(self.frame, column).map_err(|p| self.place(p))
    }

    /// `true` if there is a z that is not empty.
    pub fn spatial(&self) -> Result<bool> {
        let z = table::XYZ[2];
        Ok(self.has(z) && table::numbers(self.frame, z)?.iter().any(|z| !z.is_nan()))
    }

    /// Returns the coordinates of all rows.
    ///
    /// # Errors
    /// Reports empty and non-finite cells, with their lines.
    pub fn coordinates(&self) -> Result<Coordinates> {
        let read = || -> Result<Coordinates> {
            let angles: Vec<usize> = (0..3).filter(|&k| self.has(ANGLES[k])).collect();
            let radians =
                |&k: &usize| Ok(table::numbers(self.frame, ANGLES[k])?.into_iter().map(f64::to_radians).collect());
            Ok(Coordinates {
                positions_mm: table::coordinates(self.frame)?,
                angles_rad: angles.iter().map(radians).collect::<Result<_>>()?,
                spatial: self.spatial()?,
                angles,
            })
        };
        let all = read().map_err(|p| self.place(p))?;
        // the square of a larger value overflows
        let usable = |v: &f64| v.abs() < 1e100;
        let sound = |i: usize| all.positions_mm[i].iter().all(usable) && all.angles_rad.iter().all(|a| usable(&a[i]));
        let bad = (0..all.positions_mm.len()).filter(|&i| !sound(i));
        let bad = bad.map(|i| self.at_row(error!("coordinate-missing"), i));
        Problems(bad.take(20).collect()).check()?;
        Ok(all)
    }

    /// Returns a warning about columns other than coordinates and those in `read`.
    pub fn unread(&self, read: &[&str]) -> Option<Message> {
        let known: Vec<&str> = read.iter().chain(&table::XYZ).chain(&ANGLES).copied().collect();
        let names = self.frame.get_column_names().into_iter().map(|name| name.as_str());
        let others: Vec<&str> = names.filter(|name| *name != "line" && !known.contains(name)).collect();
        let first = *others.first()?;
        let columns: Vec<String> = others.iter().map(|name| format!("`{name}`")).collect();
        let message = warning!("columns-not-read", count = columns.len(), columns).routine();
        Some(message.at(Place::file(self.file)).hint_names(first, known.iter().copied()))
    }

    /// Places problems without a place in this file.
    pub fn place(&self, problems: impl Into<Problems>) -> Problems {
        problems.into().at(&Place::file(self.file))
    }

    /// Places a message at the line of a row.
    pub fn at_row(&self, message: Message, row: usize) -> Message {
        let line = table::integers(self.frame, "line").ok();
        let line = line.and_then(|lines| usize::try_from(*lines.get(row)?).ok());
        message.at(Place { file: self.file.to_owned(), line, ..Place::default() })
    }
}
