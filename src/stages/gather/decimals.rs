//! Coordinates with a lost or misplaced decimal mark: far from all other rows of their target, and
//! among them after a power of ten.

use etalon_base::message::Message;
use etalon_base::warning;
use etalon_formats::Point;
use std::collections::BTreeMap;

/// Minimum number of rows of a target.
const FEWEST: usize = 10;
/// Distance from the other rows, in their range, from which a coordinate is questioned. Robots do
/// not leave their workspace.
const FAR: f64 = 4.0;
/// Smallest change (mm) that is worth a question.
const LEAST_MM: f64 = 10.0;
/// Largest power of ten between two positions of a decimal mark.
const DIGITS: i32 = 6;
/// Maximum number of rows of a target in question: more are another unit.
const MOST: usize = 3;

/// Warnings about coordinates whose decimal mark is wrong.
pub(super) fn misplaced_marks(points: &[Point]) -> Vec<Message> {
    let mut targets: BTreeMap<&str, Vec<&Point>> = BTreeMap::new();
    for point in points.iter().filter(|p| p.xyz_mm.iter().all(|v| v.is_finite())) {
        if let Some(target) = point.target.as_deref() {
            targets.entry(target).or_default().push(point);
        }
    }
    let of_target = |(target, rows): (&str, Vec<&Point>)| -> Vec<Message> {
        let wrong = (0..3).flat_map(|axis| wrong_on_axis(&rows, axis)).collect::<Vec<_>>();
        let message = |(point, axis, agrees_mm, [least_mm, most_mm]): &(&Point, usize, f64, [f64; 2])| {
            let (row, value_mm, axis) = (point.row, point.xyz_mm[*axis], ["x", "y", "z"][*axis]);
            let message = warning!("decimal-mark-wrong", row, target, axis, value_mm, agrees_mm, least_mm, most_mm);
            message.to_decide().at(point.place())
        };
        if wrong.len() > MOST { Vec::new() } else { wrong.iter().map(message).collect() }
    };
    targets.into_iter().flat_map(of_target).collect()
}

/// Rows of a target whose coordinate of this axis is far from the others: with the axis, the
/// coordinate that is among the others, and the range of these (mm).
fn wrong_on_axis<'a>(rows: &[&'a Point], axis: usize) -> Vec<(&'a Point, usize, f64, [f64; 2])> {
    let mut sorted: Vec<f64> = rows.iter().map(|p| p.xyz_mm[axis]).collect();
    sorted.sort_by(f64::total_cmp);
    let n = sorted.len();
    if n < FEWEST {
        return Vec::new();
    }
    // at most `MOST` rows are wrong: the others lie between these
    let (least, most) = (sorted[MOST.min(n / 4)], sorted[n - 1 - MOST.min(n / 4)]);
    let range = most - least;
    // a power of ten brings every number among those on both sides of zero
    if range <= 0.0 || least * most <= 0.0 {
        return Vec::new();
    }
    let is_among = |v: f64| v > least - range && v < most + range && v * least > 0.0;
    let changed = |p: &&'a Point| {
        let v = p.xyz_mm[axis];
        let is_far = (least - v).max(v - most) > FAR * range;
        let powers = (1..=DIGITS).flat_map(|k| [10f64.powi(-k), 10f64.powi(k)]);
        let agrees = powers.map(|power| v * power).find(|v| is_among(*v))?;
        (is_far && (v - agrees).abs() > LEAST_MM).then_some((*p, axis, agrees, [least, most]))
    };
    rows.iter().filter_map(changed).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_formats::Stated;

    fn rows() -> Vec<Point> {
        let at = |i: u32| [1450.0 + 13.0 * f64::from(i % 29), 3.0 * f64::from(i % 17) - 20.0, 40.0];
        let stated = || Some(Box::new(Stated { target: Some("P".into()), ..Stated::default() }));
        let point = |i: u32| Point { row: i, more: stated(), xyz_mm: at(i), ..Point::default() };
        (1..=60).map(point).collect()
    }

    #[test]
    fn a_lost_mark_is_named_by_its_row_and_no_other_coordinate_is() {
        assert!(misplaced_marks(&rows()).is_empty());
        for factor in [10.0, 1e4, 1e6] {
            let mut all = rows();
            all[32].xyz_mm[0] *= factor;
            let right_mm = rows()[32].xyz_mm[0];
            let found = misplaced_marks(&all);
            let [message] = &found[..] else { panic!("{factor}: {found:?}") };
            assert!(message.is("decimal-mark-wrong", &[("row", &33), ("axis", &"x"), ("target", &"P")]), "{message:?}");
            assert!(message.is("decimal-mark-wrong", &[("agrees_mm", &(right_mm * factor / factor))]), "{message:?}");
        }
        // a far place is no other mark, and another unit of many rows neither
        let mut far = rows();
        far[32].xyz_mm[1] = 900.0;
        assert!(misplaced_marks(&far).is_empty());
        let mut many = rows();
        many.iter_mut().take(10).for_each(|p| p.xyz_mm[0] *= 10.0);
        assert!(misplaced_marks(&many).is_empty());
    }
}
