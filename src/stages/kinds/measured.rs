//! Rows of a table in which something was measured.

use super::row::fixed_rows;
use super::{NamedRows, orientations};
use etalon_base::catalogue::Phrase;
use etalon_base::message::{Message, Result};
use etalon_base::{phrase, warning};
use etalon_formats::table::{Table, XYZ};
use etalon_robots::Robot;
use std::borrow::Cow;

/// Rows without a joint value, or all coordinates of a point, with the reason; none in a table of
/// such rows alone.
pub fn unmeasured_rows(robot: &dyn Robot, table: &Table) -> Result<Vec<(usize, Phrase)>> {
    let (fixed, height) = (fixed_rows(table)?, table.height());
    let numbers = |name: &&str| table.numbers(name);
    let mut joints: Vec<(&str, Vec<Vec<f64>>)> = Vec::new();
    for joint in robot.joints() {
        let columns: Vec<&str> = table.names().filter(|name| joint.factor(name).is_some()).collect();
        let Some(first) = columns.first() else { continue };
        joints.push((*first, columns.iter().map(numbers).collect::<Result<_>>()?));
    }
    let places = XYZ.iter().filter(|name| table.has(name)).map(numbers).collect::<Result<Vec<_>>>()?;
    let oriented = orientations::are_in(table);
    let is_point = |row: usize| table.text(row, "kind").map_or(!oriented, |kind| kind == "point");
    let reason = |row: usize| {
        let lacks = |(_, columns): &&(&str, Vec<Vec<f64>>)| columns.iter().all(|column| column[row].is_nan());
        let joint = joints.iter().find(lacks).map(|(column, _)| phrase!("row-cell-empty", column));
        let placed = !is_point(row) || places.is_empty() || places.iter().any(|axis| !axis[row].is_nan());
        joint.or_else(|| (!placed).then(|| phrase!("row-without-coordinates")))
    };
    let rows = (0..height).filter(|row| !fixed[*row]).filter_map(|row| Some((row, reason(row)?)));
    let rows: Vec<(usize, Phrase)> = rows.collect();
    Ok(if rows.len() == height { Vec::new() } else { rows })
}

/// Observations without the rows in which nothing was measured; a remark names these rows.
pub(super) fn measured_rows<'t>(
    robot: &dyn Robot,
    table: &'t Table,
    messages: &mut Vec<Message>,
) -> Result<Cow<'t, Table>> {
    let left_out = unmeasured_rows(robot, table)?;
    if left_out.is_empty() {
        return Ok(Cow::Borrowed(table));
    }
    let poses = table.optional_poses()?;
    let NamedRows { by, rows, more } = NamedRows::new(table, left_out.iter().map(|(row, _)| (*row, poses[*row])));
    messages.push(warning!("rows-not-measured", count = left_out.len(), by, rows, more).routine());
    let is_kept = |row: usize| left_out.binary_search_by_key(&row, |(row, _)| *row).is_err();
    Ok(Cow::Owned(table.rows(is_kept)))
}
