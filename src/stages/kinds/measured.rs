//! Rows of a table in which something was measured.

use super::row::fixed_rows;
use super::{NamedRows, orientations};
use etalon_base::catalogue::Phrase;
use etalon_base::message::{Message, Result};
use etalon_base::{phrase, warning};
use etalon_formats::table;
use etalon_robots::Robot;
use polars::prelude::{BooleanChunked, DataFrame, NewChunkedArray};
use std::borrow::Cow;

/// Rows that lack a joint value, or all coordinates of a point, with the reason; none in a table of
/// such rows alone.
pub fn unmeasured_rows(robot: &dyn Robot, observations: &DataFrame) -> Result<Vec<(usize, Phrase)>> {
    let (fixed, height) = (fixed_rows(observations)?, observations.height());
    let numbers = |name: &&str| table::numbers(observations, name);
    let names: Vec<&str> = observations.get_column_names().into_iter().map(|name| name.as_str()).collect();
    let mut joints: Vec<(&str, Vec<Vec<f64>>)> = Vec::new();
    for joint in robot.joints() {
        let columns: Vec<&&str> = names.iter().filter(|name| joint.factor(name).is_some()).collect();
        let Some(first) = columns.first() else { continue };
        joints.push((first, columns.iter().map(|name| numbers(name)).collect::<Result<_>>()?));
    }
    let places = table::XYZ.iter().filter(|name| observations.column(name).is_ok()).map(numbers);
    let places = places.collect::<Result<Vec<_>>>()?;
    let kinds = match observations.column("kind") {
        Ok(_) => table::texts(observations, "kind")?,
        Err(_) => vec![String::new(); height],
    };
    let oriented = orientations::are_in(observations);
    let is_point = |row: usize| kinds[row] == "point" || kinds[row].is_empty() && !oriented;
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
    observations: &'t DataFrame,
    messages: &mut Vec<Message>,
) -> Result<Cow<'t, DataFrame>> {
    let left_out = unmeasured_rows(robot, observations)?;
    if left_out.is_empty() {
        return Ok(Cow::Borrowed(observations));
    }
    let (line, poses) = (table::lines(observations)?, super::row_poses(observations)?);
    let named: Vec<_> = left_out.iter().map(|(row, _)| (line(*row), poses[*row])).collect();
    let NamedRows { by, rows, more } = NamedRows::from_lines_and_poses(&named);
    messages.push(warning!("rows-not-measured", count = left_out.len(), by, rows, more).routine());
    let is_kept = |row: usize| left_out.binary_search_by_key(&row, |(row, _)| *row).is_err();
    let kept = BooleanChunked::from_iter_values("kept".into(), (0..observations.height()).map(is_kept));
    Ok(Cow::Owned(observations.filter(&kept).map_err(table::failed)?))
}
