//! Rows of a table in which something was measured.

use super::row::fixed_rows;
use super::{NamedRows, orientations};
use etalon_base::message::{Message, Result};
use etalon_base::warning;
use etalon_formats::table;
use etalon_robots::Robot;
use polars::prelude::{BooleanChunked, DataFrame, NewChunkedArray};
use std::borrow::Cow;

/// Observations without the rows that lack a joint value, or all coordinates of a point; a remark
/// names these rows. A table that would keep no row is unchanged.
pub(super) fn measured_rows<'t>(
    robot: &dyn Robot,
    observations: &'t DataFrame,
    messages: &mut Vec<Message>,
) -> Result<Cow<'t, DataFrame>> {
    let (fixed, height) = (fixed_rows(observations)?, observations.height());
    let numbers = |name: &&str| table::numbers(observations, name);
    let names: Vec<&str> = observations.get_column_names().into_iter().map(|name| name.as_str()).collect();
    let mut joints: Vec<Vec<Vec<f64>>> = Vec::new();
    for joint in robot.joints() {
        let columns = names.iter().filter(|name| joint.factor(name).is_some()).map(numbers);
        joints.push(columns.collect::<Result<_>>()?);
    }
    joints.retain(|columns| !columns.is_empty());
    let places = table::XYZ.iter().filter(|name| observations.column(name).is_ok()).map(numbers);
    let places = places.collect::<Result<Vec<_>>>()?;
    let kinds = match observations.column("kind") {
        Ok(_) => table::texts(observations, "kind")?,
        Err(_) => vec![String::new(); height],
    };
    let oriented = orientations::are_in(observations);
    let is_point = |row: usize| kinds[row] == "point" || kinds[row].is_empty() && !oriented;
    let lacks = |row: usize| {
        let joint = joints.iter().any(|columns| columns.iter().all(|column| column[row].is_nan()));
        let place = is_point(row) && !places.is_empty() && places.iter().all(|axis| axis[row].is_nan());
        !fixed[row] && (joint || place)
    };
    let left_out: Vec<usize> = (0..height).filter(|row| lacks(*row)).collect();
    if left_out.is_empty() || left_out.len() == height {
        return Ok(Cow::Borrowed(observations));
    }
    let (line, poses) = (table::lines(observations)?, super::row_poses(observations)?);
    let named: Vec<_> = left_out.iter().map(|row| (line(*row), poses[*row])).collect();
    let NamedRows { by, rows, more } = NamedRows::from_lines_and_poses(&named);
    messages.push(warning!("rows-not-measured", count = left_out.len(), by, rows, more).routine());
    let kept =
        BooleanChunked::from_iter_values("kept".into(), (0..height).map(|row| left_out.binary_search(&row).is_err()));
    Ok(Cow::Owned(observations.filter(&kept).map_err(table::failed)?))
}
