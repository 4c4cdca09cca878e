//! Points meet the log by the clock.

use super::unmatched::Rows;
use super::{Log, Said};
use crate::document::Unmatched;
use crate::message::{Message, Result, count};
use crate::table;
use polars::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

/// Joins each point with the nearest row of the log in time; the log's row becomes the pose where no label names one.
pub(super) fn by_time(
    points: &DataFrame,
    log: Log,
    offset_s: f64,
    tolerance_s: f64,
    said: &mut Said,
) -> Result<DataFrame> {
    let name = log.name;
    let nanoseconds = |frame: &DataFrame, offset: f64, whose: &str| -> Result<Vec<i64>> {
        let times = table::numbers(frame, "time_s")?;
        if times.iter().any(|t| !t.is_finite()) {
            return Err(Message::error(format!("{whose} has rows without a time"))
                .hint("a join by time needs `time_s` in the columns of exports and log")
                .into());
        }
        Ok(times.into_iter().map(|t| ((t - offset) * 1e9).round() as i64).collect())
    };
    let times = nanoseconds(points, offset_s, "the export")?;
    let log_times = nanoseconds(log.rows, 0.0, "the log")?;
    if let Some(i) = log_times.windows(2).position(|w| w[1] <= w[0]) {
        let what = format!("times of log `{name}` do not increase at its row {}", i + 2);
        return Err(Message::error(what).hint("sort the log by time, and remove rows with equal times").into());
    }
    let tolerance_ns = (tolerance_s * 1e9).round() as i64;
    let within = |t: &i64| {
        let first = log_times.partition_point(|l| *l < t.saturating_sub(tolerance_ns));
        log_times.partition_point(|l| *l <= t.saturating_add(tolerance_ns)) - first
    };
    let (stated_s, places) = (table::numbers(points, "time_s")?, Rows::points(points)?);
    let at = |t: f64| format!("{t} s");
    let several: Vec<Unmatched> = (0..times.len())
        .filter(|&i| within(&times[i]) > 1)
        .map(|i| {
            let reason =
                format!("{} rows of log `{name}` are within {tolerance_s} s: the nearest counts", within(&times[i]));
            places.unmatched(i, at(stated_s[i]), &reason)
        })
        .collect();
    let ambiguous = several.len();
    said.unmatched.extend(several);
    if ambiguous > 0 {
        let what = format!(
            "{} with several rows of log `{name}` within {tolerance_s} s: the nearest counts",
            count(ambiguous, "measured point")
        );
        said.messages.push(Message::warning(what).hint("lower `tolerance_s` to less than half the period of the log"));
    }
    let group = |n: usize| Column::new("all".into(), vec![1i64; n]);
    let mut left = points.clone();
    left.with_column(Column::new("t_ns".into(), times))?.with_column(group(points.height()))?;
    let left = left.sort(["t_ns"], SortMultipleOptions::default().with_maintain_order(true))?;
    let mut right = log.rows.clone();
    right.with_column(Column::new("t_ns".into(), log_times))?.with_column(group(log.rows.height()))?;
    right.rename("row", "log_row".into())?;
    for column in ["line", "pose", "cycle", "time_s"] {
        if right.column(column).is_ok() {
            right = right.drop(column)?;
        }
    }
    let tolerance = AnyValue::Int64(tolerance_ns);
    let (by, nearest) = (["all"], AsofStrategy::Nearest);
    let joined = left.join_asof_by(&right, "t_ns", "t_ns", by, by, nearest, Some(tolerance), true, false)?;
    let log_rows = table::optional_integers(&joined, "log_row")?;
    let targets = table::texts(&joined, "target")?;
    let (stated_s, places) = (table::numbers(&joined, "time_s")?, Rows::points(&joined)?);
    let reason = format!("no row of log `{name}` is within {tolerance_s} s");
    let alone = (0..joined.height()).filter(|&i| log_rows[i].is_none());
    let alone: Vec<Unmatched> = alone.map(|i| places.unmatched(i, at(stated_s[i]), &reason)).collect();
    if !alone.is_empty() {
        let alone = alone.len();
        said.messages.push(Message::warning(format!(
            "{} without a row of log `{name}` within {tolerance_s} s",
            count(alone, "measured point")
        )));
    }
    said.unmatched.extend(alone);
    let mut used: BTreeMap<(i64, &str), Vec<usize>> = BTreeMap::new();
    for (i, (row, target)) in log_rows.iter().zip(&targets).enumerate() {
        if let Some(row) = row {
            used.entry((*row, target)).or_default().push(i);
        }
    }
    let rows_used: BTreeSet<i64> = used.keys().map(|(row, _)| *row).collect();
    let (numbers, times_s) = (table::integers(log.rows, "row")?, table::numbers(log.rows, "time_s")?);
    let log_places = Rows::log(log.rows, log.file)?;
    let idle: Vec<usize> = (0..numbers.len()).filter(|&i| !rows_used.contains(&numbers[i])).collect();
    if !idle.is_empty() {
        let what = format!("{} of log `{name}` without a measured point", count(idle.len(), "row"));
        said.messages.push(Message::warning(what));
    }
    let reason = "no measured point is nearest to it";
    said.unmatched.extend(idle.into_iter().map(|i| log_places.unmatched(i, at(times_s[i]), reason)));
    let twice: Vec<String> = used
        .iter()
        .filter(|(_, points)| points.len() > 1)
        .map(|((row, target), points)| {
            let lines: Vec<String> = points.iter().map(|&i| places.line(i).to_string()).collect();
            let (n, lines) = (points.len(), lines.join(", "));
            format!("row {row} of log `{name}` is nearest to {n} points of target `{target}` (lines {lines})")
        })
        .collect();
    if !twice.is_empty() {
        return Err(Message::error(twice.join("; ")).hint("lower `tolerance_s`, or check `clock_offset_s`").into());
    }
    let keep: BooleanChunked = log_rows.iter().map(|r| Some(r.is_some())).collect();
    let poses = table::optional_integers(&joined, "pose")?;
    let pose: Vec<Option<i64>> = poses.iter().zip(&log_rows).map(|(pose, row)| pose.or(*row)).collect();
    let mut joined = joined;
    joined.with_column(Column::new("pose".into(), pose))?;
    Ok(joined.filter(&keep)?)
}
