//! The log says which measured point the robot touches: a plate measured once, then encoders alone.

use super::unmatched::Rows;
use super::{Log, Said};
use crate::base::message::{Message, Place, Problems, Result};
use crate::base::pose::Vector;
use crate::base::table::{self, LABEL, XYZ};
use crate::campaign::Campaign;
use crate::document::FramesDocument;
use crate::math::robots::Robot;
use polars::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

/// One observation for every row of the log: the robot's only target is at the point that the row names. The mean counts
/// of a point that was measured several times; all its observations then have the very same coordinates.
pub(super) fn by_label(
    campaign: &Campaign,
    points: &DataFrame,
    frames: &FramesDocument,
    log: Log,
    robot: &dyn Robot,
    said: &mut Said,
) -> Result<DataFrame> {
    let Log { name, file, rows: log } = log;
    let [target] = robot.targets() else {
        let what = format!("a join by label is for robots with one target, this has {}", robot.targets().len());
        return Err(Message::error(what).into());
    };
    let Some(frame) = frames.world.poses.iter().find(|f| f.pose.is_none()) else {
        let message = Message::error("a join by label needs a world frame that stays the same for all poses");
        return Err(message.hint("make it of points that do not move").into());
    };
    let measured = means(points)?;
    let world_T_export = frame.export_T_world.inverse();
    let (touched, lines) = (table::texts(log, LABEL)?, table::integers(log, "line")?);
    let (mut problems, mut at) = (Problems::default(), Vec::<Vector>::new());
    for (label, line) in touched.iter().zip(lines) {
        match measured.get(label) {
            Some(p) => at.push(world_T_export.apply(*p)),
            None => {
                let place = Place { line: Some(line as usize), ..Place::file(file) };
                let message = Message::error(format!("no measured point bears the label `{label}`")).at(place);
                problems.0.push(message.hint_names(label, measured.keys().map(String::as_str)));
            }
        }
    }
    problems.check()?;
    let used: BTreeSet<&String> = touched.iter().collect();
    let frame_points: BTreeSet<&str> = crate::stages::gather::used_labels(campaign).into_iter().collect();
    let idle = |label: &&String| !used.contains(label) && !frame_points.contains(label.as_str());
    let idle: Vec<&str> = measured.keys().filter(idle).map(String::as_str).collect();
    if let Some(first) = idle.first() {
        let what = format!("points that no row of log `{name}` touches: {}, the first is `{first}`", idle.len());
        said.messages.push(Message::warning(what));
        let places = Rows::points(points)?;
        for (row, label) in table::texts(points, LABEL)?.into_iter().enumerate() {
            if idle.contains(&label.as_str()) {
                said.unmatched.push(places.unmatched(row, label, &format!("no row of log `{name}` touches it")));
            }
        }
    }
    let mut joined = log.clone();
    let rows = joined.height();
    for (axis, column) in XYZ.into_iter().enumerate() {
        joined.with_column(Column::new(column.into(), at.iter().map(|p| p[axis]).collect::<Vec<f64>>()))?;
    }
    if joined.column("cycle").is_err() {
        joined.with_column(Column::new("cycle".into(), vec![1i64; rows]))?;
    }
    joined.with_column(Column::new("target".into(), vec![target.as_str(); rows]))?;
    joined.with_column(Column::new("order".into(), vec![0i64; rows]))?;
    Ok(joined)
}

/// Mean of each label's points, in the coordinates of the exports.
fn means(points: &DataFrame) -> Result<BTreeMap<String, Vector>> {
    let mut sums: BTreeMap<String, (Vector, f64)> = BTreeMap::new();
    for (label, xyz) in table::texts(points, LABEL)?.into_iter().zip(table::coordinates(points)?) {
        let (sum, count) = sums.entry(label).or_default();
        sum.iter_mut().zip(xyz).for_each(|(s, v)| *s += v);
        *count += 1.0;
    }
    Ok(sums.into_iter().map(|(label, (sum, count))| (label, sum.map(|s| s / count))).collect())
}
