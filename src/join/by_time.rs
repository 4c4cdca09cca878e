//! Points meet the log by the clock.

use crate::message::{Message, Result, count};
use crate::table;
use polars::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

/// Joins each point with the nearest row of the log in time; the log's row becomes the pose where no label names one.
pub(super) fn by_time(
    points: &DataFrame,
    log: &DataFrame,
    name: &str,
    offset_s: f64,
    tolerance_s: f64,
    messages: &mut Vec<Message>,
) -> Result<DataFrame> {
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
    let log_times = nanoseconds(log, 0.0, "the log")?;
    if let Some(i) = log_times.windows(2).position(|w| w[1] <= w[0]) {
        let what = format!("times of log `{name}` do not increase at its row {}", i + 2);
        return Err(Message::error(what).hint("sort the log by time, and remove rows with equal times").into());
    }
    let tolerance_ns = (tolerance_s * 1e9).round() as i64;
    let within = |t: &i64| {
        let first = log_times.partition_point(|l| *l < t.saturating_sub(tolerance_ns));
        log_times.partition_point(|l| *l <= t.saturating_add(tolerance_ns)) - first
    };
    let ambiguous = times.iter().filter(|t| within(t) > 1).count();
    if ambiguous > 0 {
        let what = format!(
            "{} with several rows of log `{name}` within {tolerance_s} s: the nearest counts",
            count(ambiguous, "measured point")
        );
        messages.push(Message::warning(what).hint("lower `tolerance_s` to less than half the period of the log"));
    }
    let group = |n: usize| Column::new("all".into(), vec![1i64; n]);
    let mut left = points.clone();
    left.with_column(Column::new("t_ns".into(), times))?.with_column(group(points.height()))?;
    let left = left.sort(["t_ns"], SortMultipleOptions::default().with_maintain_order(true))?;
    let mut right = log.clone();
    right.with_column(Column::new("t_ns".into(), log_times))?.with_column(group(log.height()))?;
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
    let alone = log_rows.iter().filter(|r| r.is_none()).count();
    if alone > 0 {
        messages.push(Message::warning(format!(
            "{} without a row of log `{name}` within {tolerance_s} s",
            count(alone, "measured point")
        )));
    }
    let mut used: BTreeMap<(i64, &str), usize> = BTreeMap::new();
    for (row, target) in log_rows.iter().zip(&targets) {
        if let Some(row) = row {
            *used.entry((*row, target)).or_default() += 1;
        }
    }
    let rows_used: BTreeSet<i64> = used.keys().map(|(row, _)| *row).collect();
    if rows_used.len() < log.height() {
        let what = format!("{} of log `{name}` without a measured point", count(log.height() - rows_used.len(), "row"));
        messages.push(Message::warning(what));
    }
    if let Some(((row, target), n)) = used.iter().find(|(_, n)| **n > 1) {
        let what = format!("row {row} of log `{name}` is nearest to {n} points of target `{target}`");
        return Err(Message::error(what).hint("lower `tolerance_s`, or check `clock_offset_s`").into());
    }
    let keep: BooleanChunked = log_rows.iter().map(|r| Some(r.is_some())).collect();
    let poses = table::optional_integers(&joined, "pose")?;
    let pose: Vec<Option<i64>> = poses.iter().zip(&log_rows).map(|(pose, row)| pose.or(*row)).collect();
    let mut joined = joined;
    joined.with_column(Column::new("pose".into(), pose))?;
    Ok(joined.filter(&keep)?)
}
