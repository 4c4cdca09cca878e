//! Positions and angles of a table `x_mm,y_mm[,z_mm][,a_deg][,b_deg][,c_deg]`, checked.

use crate::base::message::{Message, Place, Problems, Result, count};
use crate::base::pose::Vector;
use crate::base::table;
use polars::prelude::DataFrame;

/// Columns of the angles, in degrees: rotations about the axes named in the rotation order that the user states.
pub const ANGLES: [&str; 3] = ["a_deg", "b_deg", "c_deg"];

/// Coordinates of all rows.
#[derive(Clone, Debug, PartialEq)]
pub struct Coordinates {
    /// Positions; z is zero for planar robots.
    pub positions_mm: Vec<Vector>,
    /// One list of all rows for each angle that exists.
    pub angles_rad: Vec<Vec<f64>>,
    /// Whether there is a z.
    pub spatial: bool,
    /// Which angles there are: of 0, 1, 2 for a, b, c.
    pub angles: Vec<usize>,
}

/// Whether a table has a z that is not empty.
pub fn spatial(frame: &DataFrame) -> Result<bool> {
    let z = table::XYZ[2];
    Ok(frame.column(z).is_ok() && table::numbers(frame, z)?.iter().any(|z| !z.is_nan()))
}

/// Refuses a table whose coordinates (z, angles) are others than those of a second one.
pub fn like(here: (bool, &[usize]), there: (bool, &[usize]), (file, other): (&str, &str)) -> Result<()> {
    if here == there {
        return Ok(());
    }
    let message = Message::error("attained and commanded poses have different coordinates");
    let message = message.at(Place::file(file)).expected(format!("those of `{other}`"));
    Err(message.hint("planar robots leave out z_mm in both tables").into())
}

/// Coordinates of a table with its file's name; a cell that is empty or no finite number is an error at its line.
pub fn coordinates((file, frame): (&str, &DataFrame)) -> Result<Coordinates> {
    let read = || -> Result<Coordinates> {
        let has = |name: &str| frame.column(name).is_ok();
        let angles: Vec<usize> = (0..3).filter(|&k| has(ANGLES[k])).collect();
        let radians = |&k: &usize| Ok(table::numbers(frame, ANGLES[k])?.into_iter().map(f64::to_radians).collect());
        Ok(Coordinates {
            positions_mm: table::coordinates(frame)?,
            angles_rad: angles.iter().map(radians).collect::<Result<_>>()?,
            spatial: spatial(frame)?,
            angles,
        })
    };
    let all = read().map_err(|p| in_file(p, file))?;
    // beyond this squares of millimetres are no numbers
    let usable = |v: &f64| v.abs() < 1e100;
    let sound = |i: usize| all.positions_mm[i].iter().all(usable) && all.angles_rad.iter().all(|a| usable(&a[i]));
    let bad = (0..all.positions_mm.len())
        .filter(|&i| !sound(i))
        .map(|i| at_row(Message::error("a coordinate is missing or is not a finite number"), (file, frame), i));
    Problems(bad.take(20).collect()).check()?;
    Ok(all)
}

/// A warning about columns that nothing reads: a typing error would else be told nowhere.
pub fn unread((file, frame): (&str, &DataFrame), read: &[&str]) -> Option<Message> {
    let known: Vec<&str> = read.iter().chain(&table::XYZ).chain(&ANGLES).copied().collect();
    let names = frame.get_column_names().into_iter().map(|name| name.as_str());
    let others: Vec<&str> = names.filter(|name| *name != "line" && !known.contains(name)).collect();
    let quoted: Vec<String> = others.iter().map(|name| format!("`{name}`")).collect();
    let message = Message::warning(format!("not read: {} {}", count(others.len(), "column"), quoted.join(", ")));
    let first = *others.first()?;
    Some(message.at(Place::file(file)).hint_names(first, known.iter().copied()))
}

/// The same messages about this file, where they name no place.
pub fn in_file(problems: Problems, file: &str) -> Problems {
    problems.at(&Place::file(file))
}

/// The message at the line of a row, which the column `line` tells.
pub fn at_row(message: Message, (file, frame): (&str, &DataFrame), row: usize) -> Message {
    let line = table::integers(frame, "line").ok().and_then(|lines| usize::try_from(*lines.get(row)?).ok());
    message.at(Place { file: file.to_owned(), line, ..Place::default() })
}
