//! Join of points and log by time: with the nearest row, with the standstill at this time, or
//! between two rows.

use super::clock::Clock;
use super::unmatched::At;
use super::{Remarks, Row, Target, contradictions};
use etalon_base::catalogue::Phrase;
use etalon_base::message::{Problems, Result};
use etalon_base::{error, phrase, warning};
use etalon_documents::Unmatched;
use etalon_formats::{DIRECTION, JointLog};
use std::collections::{BTreeMap, BTreeSet};

/// Settings of a join by time.
#[derive(Clone, Copy, Debug)]
pub(super) struct Clocks {
    /// Clock of the measurement relative to the clock of the log.
    pub clock: Clock,
    /// Largest time (s) between a point and its rows.
    pub tolerance_s: f64,
    /// `true` if joint values are interpolated between the previous and the next row.
    pub interpolate: bool,
}

/// The rows of the log for a point: the nearer one, and the share of the other one for a point
/// between two.
#[derive(Clone, Copy)]
struct Met {
    row: usize,
    other: Option<(usize, f64)>,
}

/// Joins each point with the row of the log at its time. If no label names a pose, the row of the
/// log becomes the pose, or for interpolated rows the number of the time.
pub(super) fn by_time(targets: &[Target], log: &JointLog, clocks: Clocks, remarks: &mut Remarks) -> Result<Vec<Row>> {
    let name = &log.name;
    let times = targets.iter().map(|t| t.point.time_s.map(|time_s| clocks.clock.log_time_s(time_s)));
    let times = nanoseconds(times, "export")?;
    let spans = spans(log)?;
    let tolerance_ns = (clocks.tolerance_s * 1e9).round() as i64;
    let met: Vec<Option<Met>> = times
        .iter()
        .map(|&t| if clocks.interpolate { between(&spans, t, tolerance_ns) } else { nearest(&spans, t, tolerance_ns) })
        .collect();
    if !clocks.interpolate {
        let within = |t: i64| {
            let before = spans.partition_point(|s| s[1] < t.saturating_sub(tolerance_ns));
            spans.partition_point(|s| s[0] <= t.saturating_add(tolerance_ns)).saturating_sub(before)
        };
        let several = times.iter().map(|&t| within(t)).enumerate().filter(|(_, rows)| *rows > 1).collect();
        report_several(targets, several, clocks, name, remarks);
    }
    report_alone(targets, &met, clocks, name, remarks);
    let used: BTreeSet<usize> =
        met.iter().flatten().flat_map(|m| [Some(m.row), m.other.map(|(row, _)| row)]).flatten().collect();
    report_idle(log, &used, clocks, remarks);
    refuse_twice(targets, &times, &met, clocks, log)?;
    if !clocks.interpolate {
        let pairs = targets.iter().zip(&met).filter_map(|(t, met)| Some((t.point, &log.rows[met.as_ref()?.row])));
        contradictions(log, pairs)?;
    }
    Ok(joined(targets, log, &times, &met, clocks.interpolate))
}

/// First and last time of each row of the log (ns); they differ for standstills only.
fn spans(log: &JointLog) -> Result<Vec<[i64; 2]>> {
    let span = |end: usize| log.rows.iter().map(move |row| row.standing_s.map(|s| s[end]).or(row.time_s));
    let (from, to) = (nanoseconds(span(0), "log")?, nanoseconds(span(1), "log")?);
    if let Some(i) = from.windows(2).position(|w| w[1] <= w[0]) {
        return Err(error!("log-times-not-increasing", log = log.name, row = i + 2).into());
    }
    Ok(from.into_iter().zip(to).map(<[i64; 2]>::from).collect())
}

/// Times in whole nanoseconds; `of` names the file in the error about a missing time.
fn nanoseconds(times_s: impl Iterator<Item = Option<f64>>, of: &str) -> Result<Vec<i64>> {
    let whole = |t: Option<f64>| t.filter(|t| t.is_finite()).map(|t| (t * 1e9).round() as i64);
    let times: Option<Vec<i64>> = times_s.map(whole).collect();
    Ok(times.ok_or_else(|| error!("times-missing", of))?)
}

/// Time between a row and a time (ns).
fn distance_ns([first, last]: [i64; 2], t: i64) -> i64 {
    first.saturating_sub(t).max(t.saturating_sub(last)).max(0)
}

fn nearest(spans: &[[i64; 2]], t: i64, tolerance_ns: i64) -> Option<Met> {
    let after = spans.partition_point(|s| s[0] <= t);
    let beside = after.saturating_sub(1)..(after + 1).min(spans.len());
    let row = beside.min_by_key(|&i| distance_ns(spans[i], t))?;
    (distance_ns(spans[row], t) <= tolerance_ns).then_some(Met { row, other: None })
}

/// The previous and the next row, both within the tolerance.
fn between(spans: &[[i64; 2]], t: i64, tolerance_ns: i64) -> Option<Met> {
    let after = spans.partition_point(|s| s[0] < t);
    if spans.get(after).is_some_and(|s| s[0] == t) {
        return Some(Met { row: after, other: None });
    }
    let before = after.checked_sub(1)?;
    let (low, high) = (spans[before][0], spans.get(after)?[0]);
    if t - low > tolerance_ns || high - t > tolerance_ns {
        return None;
    }
    let share = (t - low) as f64 / (high - low) as f64;
    let (row, other) = if share <= 0.5 { (before, (after, share)) } else { (after, (before, 1.0 - share)) };
    Some(Met { row, other: Some(other) })
}

fn at(t: f64) -> String {
    format!("{t} s")
}

fn unmatched(target: &Target, reason: &Phrase) -> Unmatched {
    At::point(target.point).unmatched(at(target.point.time_s.unwrap_or(f64::NAN)), reason)
}

/// Indices of points with `several` possible rows, with the number of these rows.
fn report_several(targets: &[Target], several: Vec<(usize, usize)>, clocks: Clocks, name: &str, remarks: &mut Remarks) {
    let tolerance_s = clocks.tolerance_s;
    if several.is_empty() {
        return;
    }
    remarks.messages.push(warning!("several-rows-near", count = several.len(), log = name, tolerance_s));
    remarks.unmatched.extend(several.into_iter().map(|(i, rows)| {
        let reason = phrase!("row-of-several", rows, log = name, tolerance_s);
        unmatched(&targets[i], &reason)
    }));
}

/// Points without a row.
fn report_alone(targets: &[Target], met: &[Option<Met>], clocks: Clocks, name: &str, remarks: &mut Remarks) {
    let reason = match clocks.interpolate {
        true => phrase!("no-rows-around", log = name, tolerance_s = clocks.tolerance_s),
        false => phrase!("no-row-near", log = name, tolerance_s = clocks.tolerance_s),
    };
    let alone: Vec<usize> = (0..met.len()).filter(|&i| met[i].is_none()).collect();
    if !alone.is_empty() {
        let tolerance_s = clocks.tolerance_s;
        remarks.messages.push(warning!("points-without-row", count = alone.len(), log = name, tolerance_s));
    }
    remarks.unmatched.extend(alone.into_iter().map(|i| unmatched(&targets[i], &reason)));
}

/// Rows of the log without a point; many rows of a log without standstills have none.
fn report_idle(log: &JointLog, used: &BTreeSet<usize>, clocks: Clocks, remarks: &mut Remarks) {
    let idle: Vec<usize> = (0..log.rows.len()).filter(|i| !used.contains(i)).collect();
    if idle.is_empty() || clocks.interpolate {
        return;
    }
    remarks.messages.push(warning!("rows-without-point", count = idle.len(), log = log.name));
    let reason = &phrase!("no-point-nearest");
    let row = |i: usize| At::log(log, &log.rows[i]).unmatched(at(log.rows[i].time_s.unwrap_or(f64::NAN)), reason);
    remarks.unmatched.extend(idle.into_iter().map(row));
}

/// Returns an error about points of one target with the same row, or, for interpolated rows, the
/// same time.
fn refuse_twice(targets: &[Target], times: &[i64], met: &[Option<Met>], clocks: Clocks, log: &JointLog) -> Result<()> {
    let mut used: BTreeMap<(i64, &str), Vec<usize>> = BTreeMap::new();
    for (i, met) in met.iter().enumerate() {
        let Some(met) = met else { continue };
        let key = if clocks.interpolate { times[i] } else { log.rows[met.row].row };
        used.entry((key, targets[i].point.target.as_deref().unwrap_or_default())).or_default().push(i);
    }
    let errors = used.iter().filter(|(_, points)| points.len() > 1).map(|((key, target), points)| {
        let (count, name) = (points.len(), &log.name);
        let lines: Vec<usize> = points.iter().map(|&i| targets[i].point.line as usize).collect();
        let message = match clocks.interpolate {
            true => error!("target-time-twice", count, target, lines),
            false => error!("log-row-met-twice", row = key, log = name, count, target, lines),
        };
        message.at(At::point(targets[points[points.len() - 1]].point).place())
    });
    Problems(errors.collect()).check().map(|_| ())
}

/// The joined targets, in the order of their times, with the joint values of the log.
fn joined(targets: &[Target], log: &JointLog, times: &[i64], met: &[Option<Met>], interpolated: bool) -> Vec<Row> {
    let mut kept: Vec<(usize, Met)> = met.iter().enumerate().filter_map(|(i, met)| met.map(|met| (i, met))).collect();
    kept.sort_by_key(|(i, _)| times[*i]);
    let distinct: BTreeSet<i64> = kept.iter().map(|(i, _)| times[*i]).collect();
    let rank: BTreeMap<i64, i64> = distinct.into_iter().zip(1..).collect();
    let between = kept.iter().any(|(_, met)| met.other.is_some());
    let motions: Vec<Vec<f64>> = (0..log.joints.len()).filter(|_| between).map(|k| log.motion(k)).collect();
    let row = |(i, met): (usize, Met)| {
        let nearer = &log.rows[met.row];
        let mut row = Row::new(&targets[i], nearer);
        row.pose = row.pose.or(Some(if interpolated { rank[&times[i]] } else { nearer.row }.into()));
        let Some((other, share)) = met.other else { return row };
        row.line = None;
        for (k, (value, name)) in row.joints.iter_mut().zip(&log.joints).enumerate() {
            // directions are taken from the nearer row
            if !name.ends_with(DIRECTION) {
                *value += share * (motions[k][other] - motions[k][met.row]);
            }
        }
        row
    };
    kept.into_iter().map(row).collect()
}
