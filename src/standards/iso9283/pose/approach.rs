//! Approach of each visit: the previous pose of the programmed path, by the order of the poses in
//! most cycles. A cycle that does not have the reading of a pose does not change the path.

use etalon_base::pose_name::PoseName;
use std::collections::{BTreeMap, BTreeSet};

/// Number of different orders of a cycle that are compared, the most frequent ones.
const ORDERS: usize = 8;

/// Origin of a visit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CameFrom {
    /// Nothing was recorded before.
    Start,
    /// The previous pose of the path.
    Pose(PoseName),
    /// The path has a pose in between, whose reading is missing in this cycle.
    Unread,
}

/// Origin of each row of one robot, in the order of recording. Consecutive rows
/// with the same cycle and pose are readings of one visit.
///
/// A cycle is incomplete if a more frequent order of poses contains all its poses in their order,
/// and further ones. Its visits have a known approach only where no order has a pose in between.
pub fn came_from(rows: &[(i64, PoseName)]) -> Vec<CameFrom> {
    let row_before = |i: usize| i.checked_sub(1).map_or(CameFrom::Start, |k| CameFrom::Pose(rows[k].1));
    let mut found: Vec<CameFrom> = (0..rows.len()).map(row_before).collect();
    let cycles: Vec<Vec<usize>> = cycles(rows);
    let distinct: BTreeSet<i64> = cycles.iter().map(|visits| rows[visits[0]].0).collect();
    if distinct.len() < cycles.len() {
        return found; // cycles are mixed: their rows are in no order of a path
    }
    let sequences: Vec<Vec<PoseName>> =
        cycles.iter().map(|visits| visits.iter().map(|&i| rows[i].1).collect()).collect();
    let orders = Orders::new(&sequences);
    let possible: Vec<Vec<&[PoseName]>> = sequences.iter().map(|s| orders.possible_orders(s)).collect();
    for (c, visits) in cycles.iter().enumerate() {
        let first = possible[c].iter().all(|order| order.first() == sequences[c].first());
        let last = c == 0 || possible[c - 1].iter().all(|order| order.last() == sequences[c - 1].last());
        if c > 0 && !(first && last) {
            found[visits[0]] = CameFrom::Unread;
        }
        for (pair, &visit) in sequences[c].windows(2).zip(&visits[1..]) {
            if !possible[c].iter().all(|order| order.windows(2).any(|step| step == pair)) {
                found[visit] = CameFrom::Unread;
            }
        }
    }
    found
}

/// Rows of each cycle, without repeated readings.
fn cycles(rows: &[(i64, PoseName)]) -> Vec<Vec<usize>> {
    let mut cycles: Vec<Vec<usize>> = Vec::new();
    for (i, row) in rows.iter().enumerate() {
        match cycles.last_mut() {
            Some(visits) if rows[i - 1].0 == row.0 => {
                if rows[i - 1] != *row {
                    visits.push(i);
                }
            }
            _ => cycles.push(vec![i]),
        }
    }
    cycles
}

/// Orders of the poses in a cycle, with the number of cycles, the most frequent first.
struct Orders<'a>(Vec<(&'a [PoseName], usize)>, BTreeMap<&'a [PoseName], usize>);

impl<'a> Orders<'a> {
    fn new(sequences: &'a [Vec<PoseName>]) -> Self {
        let mut counts: BTreeMap<&[PoseName], usize> = BTreeMap::new();
        sequences.iter().for_each(|sequence| *counts.entry(sequence.as_slice()).or_default() += 1);
        let mut frequent: Vec<(&[PoseName], usize)> = counts.iter().map(|(order, count)| (*order, *count)).collect();
        frequent.sort_by_key(|(order, count)| std::cmp::Reverse((*count, order.len())));
        frequent.truncate(ORDERS);
        Self(frequent, counts)
    }

    /// Orders that a cycle may have had: the more frequent ones that contain it, or its own.
    fn possible_orders(&self, cycle: &'a [PoseName]) -> Vec<&'a [PoseName]> {
        let own = self.1.get(cycle).copied().unwrap_or(1);
        let contains = |order: &[PoseName]| {
            let mut poses = order.iter();
            order.len() > cycle.len() && cycle.iter().all(|pose| poses.any(|p| p == pose))
        };
        // a single cycle proves no path of its own
        let longer = self.0.iter().filter(|(order, count)| (*count > own || own == 1) && contains(order));
        let longer: Vec<&[PoseName]> = longer.map(|(order, _)| *order).collect();
        if longer.is_empty() { vec![cycle] } else { longer }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows(cycles: &[&[i64]]) -> Vec<(i64, PoseName)> {
        let of_cycle = |(c, poses): (usize, &&[i64])| poses.iter().map(|p| (c as i64, (*p).into())).collect::<Vec<_>>();
        cycles.iter().enumerate().flat_map(of_cycle).collect()
    }

    /// Previous poses: 0 for the start, -1 for an unknown one.
    fn found(rows: &[(i64, PoseName)]) -> Vec<String> {
        let name = |from: &CameFrom| match from {
            CameFrom::Start => "start".to_owned(),
            CameFrom::Pose(pose) => pose.to_string(),
            CameFrom::Unread => "?".to_owned(),
        };
        came_from(rows).iter().map(name).collect()
    }

    const WHOLE: &[i64] = &[1, 2, 3, 4, 5];

    #[test]
    fn a_missing_reading_is_no_approach() {
        // in the middle, at the end, at the beginning, two at once
        let cycles = [WHOLE, &[1, 2, 4, 5], WHOLE, &[1, 2, 3, 4], WHOLE, &[2, 3, 4, 5], &[1, 4, 5], WHOLE];
        let expected = "start 1 2 3 4 5 1 ? 4 5 1 2 3 4 5 1 2 3 ? 1 2 3 4 ? 2 3 4 5 ? 4 5 1 2 3 4";
        assert_eq!(found(&rows(&cycles)).join(" "), expected);
    }

    #[test]
    fn true_approaches_remain() {
        // both ways, from two poses in turn, by a shorter way as often, and a recording that begins
        // and ends in a cycle
        let ways: [&[i64]; 2] = [WHOLE, &[5, 4, 3, 2, 1]];
        assert_eq!(found(&rows(&[ways[0], ways[1], ways[0]])).join(" "), "start 1 2 3 4 5 5 4 3 2 1 1 2 3 4");
        let two: [&[i64]; 4] = [&[1, 3], &[2, 3], &[1, 3], &[2, 3]];
        assert_eq!(found(&rows(&two)).join(" "), "start 1 3 2 3 1 3 2");
        let short: [&[i64]; 4] = [&[1, 2, 3], &[1, 3], &[1, 2, 3], &[1, 3]];
        assert_eq!(found(&rows(&short)).join(" "), "start 1 2 3 1 3 1 2 3 1");
        assert_eq!(found(&rows(&[&[3, 4, 5], WHOLE, WHOLE, &[1, 2]])).join(" "), "start 3 4 5 1 2 3 4 5 1 2 3 4 5 1");
        // one visit of one pose in every cycle
        assert_eq!(found(&rows(&[&[1], &[1], &[1]])).join(" "), "start 1 1");
    }

    #[test]
    fn a_gap_in_one_of_two_ways_may_be_of_either() {
        let cycles = [WHOLE, &[5, 4, 3, 2, 1], WHOLE, &[5, 4, 2, 1], WHOLE, &[5, 4, 3, 2, 1]];
        let found = found(&rows(&cycles));
        assert_eq!(found[15..20].join(" "), "5 5 ? 2 1");
        assert_eq!(found.iter().filter(|from| *from == "?").count(), 1);
    }

    #[test]
    fn readings_and_mixed_cycles_are_kept() {
        let twice: Vec<_> = rows(&[WHOLE, &[1, 2, 4, 5], WHOLE]).into_iter().flat_map(|row| [row, row]).collect();
        let of_visits: Vec<String> = found(&twice).into_iter().step_by(2).collect();
        assert_eq!(of_visits.join(" "), "start 1 2 3 4 5 1 ? 4 5 1 2 3 4");
        // sorted by pose
        let mut sorted = rows(&[WHOLE, WHOLE]);
        sorted.sort_by_key(|row| row.1);
        assert_eq!(found(&sorted).join(" "), "start 1 1 2 2 3 3 4 4 5");
    }
}
