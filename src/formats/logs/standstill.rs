//! Standstills in a log that was recorded during motion.
//!
//! A sample belongs to a standstill if it lies in a stretch of at least the given duration within
//! which no joint moves by more than the limit of its kind. The rule is symmetric in time and uses
//! no filter. Stretches with a common sample form one standstill. Angles that a controller wraps
//! are compared and averaged modulo a turn.

use super::joint_log::{DIRECTION, JointLog, LogRow};
use super::{Log, StandstillCriterion};
use crate::table::{ASSEMBLY, LABEL};
use crate::tables::joints::is_stated_column;
use etalon_base::error;
use etalon_base::message::{Message, Place, Problems, Result, SourceText};
use etalon_documents::{Source, StandingInterval, StandingJoint};
use etalon_standards::iso9283::statistics::sample::{self, SampleSpread};
use std::collections::VecDeque;

/// Joint with its values and its limit at a standstill, in one unit.
#[derive(Clone, Copy, Debug)]
pub struct Watched<'a> {
    /// Value at each sample.
    pub values: &'a [f64],
    /// Largest difference of two values at a standstill.
    pub within: f64,
}

/// Returns the first and last sample of each standstill of all joints. Times increase (s).
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

/// Returns for each sample the longest stretch from it within which no joint exceeds its limit.
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

/// Range of a stretch that grows at its end and shrinks at its start: indices of the values that
/// are the largest (smallest) from their place to the end.
#[derive(Default)]
struct Range {
    largest: VecDeque<usize>,
    smallest: VecDeque<usize>,
}

impl Range {
    /// Returns the range with one more value.
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

    /// Removes the first value.
    fn forget(&mut self, first: usize) {
        for queue in [&mut self.largest, &mut self.smallest] {
            if queue.front() == Some(&first) {
                queue.pop_front();
            }
        }
    }
}

/// Returns the log with one row of mean joint values for each standstill.
///
/// Pose, cycle, label and assembly mode must not change within a standstill.
pub(super) fn reduce(
    stated: SourceText,
    log: &Log,
    still: &StandstillCriterion,
    read: JointLog,
    source: &mut Source,
) -> Result<JointLog> {
    let place = || stated.place(&log.file);
    let (times_s, within) = limits(log, still, &read).map_err(|message| Problems::from(message).at(&place()))?;
    let values: Vec<Vec<f64>> = (0..read.joints.len()).map(|k| read.motion(k)).collect();
    let watched: Vec<Watched> = values.iter().zip(within).map(|(values, within)| Watched { values, within }).collect();
    let found = standing(&times_s, &watched, still.at_least_s);
    if found.is_empty() {
        let longest = stretches(times_s.len(), &watched).into_iter().map(|(a, b)| times_s[b] - times_s[a]);
        let (longest_s, at_least_s) = (longest.fold(0.0, f64::max), still.at_least_s);
        let message = error!("standstill-missing", log = &log.name, at_least_s, longest_s);
        return Err(message.at(place()).into());
    }
    let mut rows = Vec::with_capacity(found.len());
    let mut intervals = Vec::with_capacity(found.len());
    for (number, &(first, last)) in (1..).zip(&found) {
        let within = &read.rows[first..=last];
        unchanged(log, within)?;
        let joint = |(k, values): (usize, &Vec<f64>)| {
            // the mean has the turn of the recording
            let turns = within[0].joints[k] - values[first];
            let own = spread(&read.joints[k], &values[first..=last]);
            StandingJoint { mean: own.mean + turns, ..own }
        };
        let joints: Vec<StandingJoint> = values.iter().enumerate().map(joint).collect();
        let [from_s, to_s] = [times_s[first], times_s[last]];
        rows.push(LogRow {
            row: number,
            pose: log.pose.map(|from| from.number(number).into()).or(within[0].pose),
            time_s: Some(0.5 * (from_s + to_s)),
            standing_s: Some([from_s, to_s]),
            joints: joints.iter().map(|joint| joint.mean).collect(),
            ..within[0].clone()
        });
        intervals.push(StandingInterval { line: within[0].line, from_s, to_s, samples: within.len(), joints });
    }
    source.standstills = intervals;
    let others =
        read.columns.iter().filter(|c| !["row", "line", "time_s"].contains(&c.as_str()) && !read.joints.contains(c));
    let columns = ["row", "line", "time_s", "from_s", "to_s"].into_iter().map(str::to_owned);
    let columns = columns.chain(others.cloned()).chain(read.joints.iter().cloned()).collect();
    Ok(JointLog { columns, rows, ..read })
}

/// Returns the times of the rows and the limit of each joint, or the error of the statement.
fn limits(
    log: &Log,
    still: &StandstillCriterion,
    read: &JointLog,
) -> std::result::Result<(Vec<f64>, Vec<f64>), Message> {
    let limits =
        [("at_least_s", Some(still.at_least_s)), ("within_deg", still.within_deg), ("within_mm", still.within_mm)];
    let wrong = |(_, limit): &(&str, Option<f64>)| limit.is_some_and(|limit| limit <= 0.0 || !limit.is_finite());
    if let Some((key, _)) = limits.into_iter().find(wrong) {
        return Err(error!("key-not-positive", key));
    }
    let Some(times_s) = read.rows.iter().map(|row| row.time_s).collect::<Option<Vec<f64>>>() else {
        return Err(error!("standstill-time-missing"));
    };
    if let Some(i) = times_s.windows(2).position(|pair| pair[1] <= pair[0]) {
        let message = error!("time-not-increasing", later_s = times_s[i + 1], earlier_s = times_s[i]);
        let line = Some(read.rows[i + 1].line);
        return Err(message.at(Place { line, ..Place::file(log.file.get_ref()) }));
    }
    let within = |name: &String| {
        if name.ends_with(DIRECTION) || is_stated_column(name) {
            return Ok(f64::INFINITY);
        }
        let (key, within) =
            if name.ends_with("_deg") { ("within_deg", still.within_deg) } else { ("within_mm", still.within_mm) };
        within.ok_or_else(|| error!("standstill-limit-missing", column = name, key))
    };
    Ok((times_s, read.joints.iter().map(within).collect::<std::result::Result<_, _>>()?))
}

/// Checks that pose, cycle, label and assembly mode do not change within a standstill.
fn unchanged(log: &Log, rows: &[LogRow]) -> Result<()> {
    type Value<'a> = dyn Fn(&LogRow) -> String + 'a;
    let of: [(&str, &Value); 4] = [
        (ASSEMBLY, &|row| row.assembly.map_or_else(String::new, |v| format!("{v:.1}"))),
        ("cycle", &|row| row.cycle.map_or_else(String::new, |cycle| cycle.to_string())),
        (LABEL, &|row| row.label.clone().unwrap_or_default()),
        ("pose", &|row| row.pose.map_or_else(String::new, |pose| pose.to_string())),
    ];
    for (name, value) in of.into_iter().filter(|(name, _)| *name != "pose" || log.pose.is_none()) {
        let first = value(&rows[0]);
        if let Some(row) = rows.iter().find(|row| value(row) != first) {
            let place = Place { line: Some(row.line), ..Place::file(log.file.get_ref()) };
            let message = error!("changes-at-standstill", column = name, from = first, to = value(row));
            return Err(message.at(place).into());
        }
    }
    Ok(())
}

/// Returns mean, standard deviation (n - 1) and range of a joint within a standstill.
fn spread(name: &str, values: &[f64]) -> StandingJoint {
    let SampleSpread { mean, deviation } = sample::spread(values);
    let (low, high) = values.iter().fold((f64::MAX, f64::MIN), |(low, high), v| (low.min(*v), high.max(*v)));
    let standard_deviation = if values.len() > 1 { deviation } else { 0.0 };
    StandingJoint { column: name.to_owned(), mean, standard_deviation, range: high - low }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A joint that stands at 180 deg within the noise of its encoder, and that the controller
    /// wraps, stands still; a length that jumps by 360 mm does not.
    #[test]
    fn a_joint_at_half_a_turn_stands_still() {
        let stands = [-20.0, 180.0, 60.0, 180.0, -179.999];
        let values = stands.iter().flat_map(|at| (0..30).map(move |i| at + 0.002 * f64::from(i % 3 - 1)));
        let wrapped: Vec<f64> = values.map(|v: f64| v - 360.0 * ((v + 180.0) / 360.0).floor()).collect();
        let row = |v: &f64| LogRow { joints: vec![*v, *v], ..LogRow::default() };
        let joints = vec!["q4_deg".to_owned(), "lift_mm".to_owned()];
        let log = JointLog { joints, rows: wrapped.iter().map(row).collect(), ..JointLog::default() };
        let times_s: Vec<f64> = (0..wrapped.len()).map(|i| 0.1 * i as f64).collect();
        let count = |k: usize| standing(&times_s, &[Watched { values: &log.motion(k), within: 0.02 }], 1.5).len();
        // the last two stand at one angle
        assert_eq!(count(0), 4, "{:?}", log.motion(0));
        assert!(count(1) < 4);
        assert_eq!(log.motion(1), wrapped);
    }
}
