//! Errors as tables: by set of poses, and by pose.

use super::number::{self, Shown};
use super::points;
use super::words::Words;
use crate::document::{AccuracyDocument, ErrorStatistics, PointError, Statistics};
use serde::Serialize;
use std::collections::BTreeMap;

/// More rows than this nobody reads; the documents have them all.
const LIMIT: usize = 500;

#[derive(Debug, Serialize)]
pub(super) struct Set {
    pub name: String,
    pub poses: usize,
    pub count: usize,
    pub rows: Vec<Row>,
}

/// One quantity: mean, RMS, 95 % and max.
#[derive(Debug, Serialize)]
pub(super) struct Row {
    pub quantity: String,
    pub unit: String,
    pub before: [String; 4],
    pub after: [String; 4],
    /// RMS before over RMS after
    pub ratio: String,
}

/// Errors of every set of poses.
pub(super) fn sets(accuracy: &AccuracyDocument, words: &Words) -> Vec<Set> {
    // one unit for all lengths, so that rows and sets can be compared
    let lengths = accuracy.sets.iter().flat_map(|s| &s.errors).filter(|e| e.unit == "mm");
    let largest_mm = lengths.map(|e| e.before.max.max(e.after.max)).fold(0.0, f64::max);
    let set = |s: &crate::document::AccuracySet| Set {
        name: words.say(&s.name),
        poses: s.poses,
        count: s.count,
        rows: s.errors.iter().map(|e| row(e, largest_mm, decimals(accuracy, &e.unit, largest_mm), words)).collect(),
    };
    accuracy.sets.iter().map(set).collect()
}

/// Decimals of all numbers in `unit`: the smallest error after that is not zero shows three digits.
fn decimals(accuracy: &AccuracyDocument, unit: &str, largest_mm: f64) -> usize {
    let factor = number::shown(unit, largest_mm).factor;
    let errors = accuracy.sets.iter().flat_map(|s| &s.errors).filter(|e| e.unit == unit);
    let after = errors.flat_map(|e| all(&e.after)).map(|v| v * factor).filter(|&v| v > 0.0);
    number::decimals(after.fold(f64::INFINITY, f64::min), 3).unwrap_or(1).clamp(1, 5)
}

fn all(s: &Statistics) -> [f64; 4] {
    [s.mean, s.rms, s.p95, s.max]
}

fn row(e: &ErrorStatistics, largest_mm: f64, decimals: usize, words: &Words) -> Row {
    let Shown { unit, factor } = number::shown(&e.unit, largest_mm);
    let text = |s: &Statistics| all(s).map(|v| number::fixed(v * factor, decimals));
    let ratio = e.before.rms / e.after.rms;
    Row {
        quantity: words.say(&e.quantity),
        unit: if unit.is_empty() { e.unit.clone() } else { unit.to_owned() },
        before: text(&e.before),
        after: text(&e.after),
        ratio: if ratio.is_finite() { number::significant(ratio, 2) } else { String::new() },
    }
}

#[derive(Debug, Serialize)]
pub(super) struct Poses {
    pub unit: &'static str,
    pub orientation: bool,
    pub rows: Vec<[String; 7]>,
    /// poses that the table leaves out
    pub left_out: usize,
}

/// Errors by their set and pose.
pub(super) fn by_pose(errors: &[PointError]) -> BTreeMap<(&str, i64), Vec<&PointError>> {
    let mut by_pose: BTreeMap<(&str, i64), Vec<&PointError>> = BTreeMap::new();
    for p in errors {
        by_pose.entry((&p.set, p.pose)).or_default().push(p);
    }
    by_pose
}

/// Largest and mean error of every pose.
pub(super) fn poses(errors: &[PointError], words: &Words) -> Poses {
    let by_pose = by_pose(errors);
    let largest =
        |points: &[&PointError], size: fn(&PointError) -> f64| points.iter().map(|p| size(p)).fold(0.0, f64::max);
    let all: Vec<&PointError> = errors.iter().collect();
    let Shown { unit, factor } =
        number::shown("mm", largest(&all, points::after_mm).max(largest(&all, points::before_mm)));
    let length = |v: f64| number::significant(v * factor, 3);
    let angle = |points: &[&PointError], angle: fn(&PointError) -> Option<f64>| {
        let largest = points.iter().filter_map(|p| angle(p)).map(f64::abs).reduce(f64::max);
        largest.map_or_else(String::new, |v| number::significant(v, 3))
    };
    let row = |(&(set, pose), points): (&(&str, i64), &Vec<&PointError>)| {
        let (before, after) = (largest(points, points::before_mm), largest(points, points::after_mm));
        let count = points.len().to_string();
        let angles = (angle(points, |p| p.before_deg), angle(points, |p| p.after_deg));
        [pose.to_string(), words.say(set), count, length(before), length(after), angles.0, angles.1]
    };
    Poses {
        unit,
        orientation: errors.iter().any(|p| p.before_deg.is_some() || p.after_deg.is_some()),
        rows: by_pose.iter().take(LIMIT).map(row).collect(),
        left_out: by_pose.len().saturating_sub(LIMIT),
    }
}

#[cfg(test)]
mod tests {
    use super::super::demo::point;
    use super::*;

    fn statistics(size: f64) -> Statistics {
        Statistics { mean: 0.8 * size, rms: size, p95: 1.8 * size, max: 2.0 * size }
    }

    fn accuracy(errors: Vec<ErrorStatistics>) -> AccuracyDocument {
        let set = |errors| crate::document::AccuracySet { name: "validation".into(), poses: 1, count: 1, errors };
        AccuracyDocument { schema: String::new(), definition: String::new(), sets: vec![set(errors)], limits: vec![] }
    }

    fn errors(quantity: &str, before_mm: f64, after_mm: f64) -> ErrorStatistics {
        let (quantity, unit) = (quantity.to_owned(), "mm".to_owned());
        ErrorStatistics { quantity, unit, before: statistics(before_mm), after: statistics(after_mm) }
    }

    #[test]
    fn small_lengths_are_in_micrometres_with_the_digits_of_the_smallest() {
        let shown = |before: f64, after: f64| {
            sets(&accuracy(vec![errors("position", before, after)]), &Words::default()).remove(0).rows
        };
        let small = &shown(0.4, 0.008)[0];
        assert_eq!((small.unit.as_str(), small.ratio.as_str()), ("µm", "50"));
        assert_eq!(small.before, ["320.00", "400.00", "720.00", "800.00"].map(str::to_owned));
        assert_eq!(small.after, ["6.40", "8.00", "14.40", "16.00"].map(str::to_owned));
        let large = &shown(4.0, 0.008)[0];
        assert_eq!((large.after[1].as_str(), large.unit.as_str()), ("0.00800", "mm"));
        assert_eq!(shown(0.4, 0.0)[0].ratio, "");
    }

    #[test]
    fn numbers_in_one_unit_have_the_same_decimals_and_three_digits_after() {
        // the case of a robot that is better along x than in all: 0.1366 against a limit of 0.137
        let rows = sets(&accuracy(vec![errors("position", 2.0, 0.1366), errors("x", 1.0, 0.0747)]), &Words::default())
            .remove(0)
            .rows;
        assert_eq!((rows[0].after[1].as_str(), rows[1].after[1].as_str()), ("0.1366", "0.0747"));
        assert_eq!(rows[0].before[1], "2.0000");
    }

    #[test]
    fn a_pose_has_the_largest_of_its_errors_and_long_tables_are_cut() {
        let two = [point(1, [0.0; 3], [0.3, 0.0, 0.0], [0.02, 0.0, 0.0]), point(1, [0.0; 3], [0.2; 3], [0.01; 3])];
        let table = poses(&two, &Words::default());
        assert_eq!(table.rows, [["1", "calibration", "2", "346", "20.0", "", ""].map(str::to_owned)]);
        let many: Vec<_> = (0..600).map(|i| point(i, [0.0; 3], [0.1; 3], [0.01; 3])).collect();
        assert_eq!((poses(&many, &Words::default()).rows.len(), poses(&many, &Words::default()).left_out), (500, 100));
        assert!(poses(&[], &Words::default()).rows.is_empty());
    }
}
