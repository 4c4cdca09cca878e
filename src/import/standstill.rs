//! Where a robot stands, in a log that was recorded while it moved.
//!
//! A sample stands if it lies in some stretch of at least the stated time within which no joint moves by more than is
//! stated for its kind. The rule is the same read backwards, and knows no filter. What stands together is one interval:
//! stretches that share a sample are.

use crate::base::message::{Message, Place, Result, Stated};
use crate::base::table;
use crate::document::{Source, StandingInterval, StandingJoint};
use crate::import::format::Log;
use crate::import::format::Standstill;
use polars::prelude::{Column, DataFrame};
use std::collections::VecDeque;

/// A joint: its values, and how far they may lie apart where it stands, in the same unit.
#[derive(Clone, Copy, Debug)]
pub struct Watched<'a> {
    /// Values, one for each sample.
    pub values: &'a [f64],
    /// Largest difference of two values where the joint stands.
    pub within: f64,
}

/// First and last sample of each interval in which all joints stand, in order; times in seconds, increasing.
pub fn standing(times_s: &[f64], joints: &[Watched], at_least_s: f64) -> Vec<(usize, usize)> {
    let mut found: Vec<(usize, usize)> = Vec::new();
    for (first, last) in stretches(times_s.len(), joints) {
        if times_s[last] - times_s[first] < at_least_s {
            continue;
        }
        match found.last_mut() {
            Some(before) if first <= before.1 => before.1 = before.1.max(last),
            _ => found.push((first, last)),
        }
    }
    found
}

/// From each sample on, the longest stretch within which no joint leaves its range.
fn stretches(count: usize, joints: &[Watched]) -> Vec<(usize, usize)> {
    let mut ranges: Vec<Range> = joints.iter().map(|_| Range::default()).collect();
    let mut all = Vec::with_capacity(count);
    let mut end = 0;
    for first in 0..count {
        let fits = |ranges: &[Range], next: usize| {
            ranges.iter().zip(joints).all(|(range, joint)| range.with(joint.values, next) <= joint.within)
        };
        while end < count && (end == first || fits(&ranges, end)) {
            ranges.iter_mut().zip(joints).for_each(|(range, joint)| range.push(joint.values, end));
            end += 1;
        }
        all.push((first, end - 1));
        ranges.iter_mut().for_each(|range| range.forget(first));
    }
    all
}

/// Range of a stretch that grows at its end and shrinks at its start: indices of the values that are the largest
/// (smallest) from there to the end.
#[derive(Default)]
struct Range {
    largest: VecDeque<usize>,
    smallest: VecDeque<usize>,
}

impl Range {
    /// The range with one more value.
    fn with(&self, values: &[f64], next: usize) -> f64 {
        let high = self.largest.front().map_or(values[next], |&i| values[i].max(values[next]));
        let low = self.smallest.front().map_or(values[next], |&i| values[i].min(values[next]));
        high - low
    }

    fn push(&mut self, values: &[f64], next: usize) {
        while self.largest.back().is_some_and(|&i| values[i] <= values[next]) {
            self.largest.pop_back();
        }
        while self.smallest.back().is_some_and(|&i| values[i] >= values[next]) {
            self.smallest.pop_back();
        }
        self.largest.push_back(next);
        self.smallest.push_back(next);
    }

    /// Takes the first value out.
    fn forget(&mut self, first: usize) {
        for queue in [&mut self.largest, &mut self.smallest] {
            if queue.front() == Some(&first) {
                queue.pop_front();
            }
        }
    }
}

/// The log with one row for each interval in which the robot stands: mean joint values, and `from_s`, `to_s`.
///
/// Pose, cycle, label and assembly mode must not change within an interval.
pub(super) fn reduce(
    stated: Stated,
    log: &Log,
    still: &Standstill,
    table: &DataFrame,
    source: &mut Source,
) -> Result<DataFrame> {
    let place = || stated.place(&log.file);
    let limits = [Some(still.at_least_s), still.within_deg, still.within_mm];
    if limits.into_iter().flatten().any(|limit| limit <= 0.0 || !limit.is_finite()) {
        let message = Message::error("the limits of [log.standstill] must be positive").at(place());
        return Err(message.hint("they are what the robot does while it stands, as its encoders show it").into());
    }
    let Ok(times_s) = table::numbers(table, "time_s") else {
        let message = Message::error("[log.standstill] needs the times of the rows").at(place());
        return Err(message.hint("state `time_s`, `time_ms` or `time_ns` in `columns`, or `period_s`").into());
    };
    if let Some(i) = times_s.windows(2).position(|pair| pair[1] <= pair[0]) {
        let message = Message::error(format!("times of log `{}` do not increase at its row {}", log.name, i + 2));
        return Err(message.at(place()).hint("sort the log by time, and remove rows with equal times").into());
    }
    let is_joint = |name: &str| name.ends_with("_deg") || name.ends_with("_mm");
    let names: Vec<String> = table.get_column_names().iter().map(|name| name.to_string()).collect();
    let mut joints = Vec::new();
    for name in names.iter().filter(|name| is_joint(name)) {
        let (key, within) =
            if name.ends_with("_deg") { ("within_deg", still.within_deg) } else { ("within_mm", still.within_mm) };
        let Some(within) = within else {
            let message = Message::error(format!("[log.standstill] does not say when `{name}` stands")).at(place());
            return Err(message.hint(format!("add `{key}`: the largest movement that is none")).into());
        };
        joints.push((name, within, table::numbers(table, name)?));
    }
    let watched: Vec<Watched> = joints.iter().map(|(_, within, values)| Watched { values, within: *within }).collect();
    let found = standing(&times_s, &watched, still.at_least_s);
    if found.is_empty() {
        let longest = stretches(times_s.len(), &watched).into_iter().map(|(a, b)| times_s[b] - times_s[a]);
        let longest = longest.fold(0.0, f64::max);
        let message =
            Message::error(format!("the robot of log `{}` never stands for {} s", log.name, still.at_least_s));
        let hint =
            format!("the longest it stands within these limits is {longest:.3} s: check `at_least_s` and the limits");
        return Err(message.at(place()).hint(hint).into());
    }
    let lines = table::integers(table, "line")?;
    let mut columns = vec![
        Column::new("row".into(), (1..=found.len() as i64).collect::<Vec<_>>()),
        Column::new("line".into(), found.iter().map(|&(first, _)| lines[first]).collect::<Vec<_>>()),
        Column::new("time_s".into(), found.iter().map(|&(a, b)| 0.5 * (times_s[a] + times_s[b])).collect::<Vec<_>>()),
        Column::new("from_s".into(), found.iter().map(|&(first, _)| times_s[first]).collect::<Vec<_>>()),
        Column::new("to_s".into(), found.iter().map(|&(_, last)| times_s[last]).collect::<Vec<_>>()),
    ];
    for name in names.iter().filter(|name| !is_joint(name) && !["row", "line", "time_s"].contains(&name.as_str())) {
        if name == "pose" && log.pose.is_some() {
            columns.push(Column::new("pose".into(), (1..=found.len() as i64).collect::<Vec<_>>()));
            continue;
        }
        let texts = table::texts(table, name)?;
        for &(first, last) in &found {
            if let Some(i) = (first..=last).find(|&i| texts[i] != texts[first]) {
                let what = format!("`{name}` goes from {} to {} while the robot stands", texts[first], texts[i]);
                let place = Place { line: Some(lines[i] as usize), ..Place::file(log.file.get_ref()) };
                let message = Message::error(what).at(place);
                return Err(message
                    .hint("a standing robot is at one pose: leave the column out, or lower the limits")
                    .into());
            }
        }
        let column = table.column(name)?.as_materialized_series();
        let firsts: Vec<u32> = found.iter().map(|&(first, _)| first as u32).collect();
        columns.push(column.take_slice(&firsts)?.into());
    }
    let mut intervals: Vec<StandingInterval> = found
        .iter()
        .map(|&(first, last)| StandingInterval {
            line: lines[first] as usize,
            from_s: times_s[first],
            to_s: times_s[last],
            samples: last + 1 - first,
            joints: Vec::new(),
        })
        .collect();
    for (name, _, values) in &joints {
        for (interval, &(first, last)) in intervals.iter_mut().zip(&found) {
            interval.joints.push(spread(name, &values[first..=last]));
        }
        let means = |k: usize| intervals[k].joints.last().map_or(f64::NAN, |joint| joint.mean);
        columns.push(Column::new(name.as_str().into(), (0..found.len()).map(means).collect::<Vec<_>>()));
    }
    source.standstills = intervals;
    Ok(DataFrame::new(found.len(), columns)?)
}

/// Mean, standard deviation (n - 1) and range of a joint while it stands.
fn spread(name: &str, values: &[f64]) -> StandingJoint {
    let n = values.len() as f64;
    // about the first value, which is near: sums of large counts keep their digits
    let mean = values[0] + values.iter().map(|v| v - values[0]).sum::<f64>() / n;
    let squares: f64 = values.iter().map(|v| (v - mean).powi(2)).sum();
    let (low, high) = values.iter().fold((f64::MAX, f64::MIN), |(low, high), v| (low.min(*v), high.max(*v)));
    let standard_deviation = if n > 1.0 { (squares / (n - 1.0)).sqrt() } else { 0.0 };
    StandingJoint { column: name.to_owned(), mean, standard_deviation, range: high - low }
}
