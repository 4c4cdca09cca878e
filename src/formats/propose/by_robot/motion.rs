//! Motion of a recording compared with the times of measured points: its standstills, and the
//! offset of the clocks.

use etalon_base::angle::Turn;

/// Times (s) and joint values of a recording, a row each.
#[derive(Clone, Debug, Default)]
pub(crate) struct Motion {
    times_s: Vec<f64>,
    joints: Vec<Vec<f64>>,
    /// Names of the joints, as far as the file has them.
    pub names: Vec<String>,
}

/// Relation of the times of points to a recording.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Meeting {
    /// At least as many standstills of this duration as points.
    Standstills { count: usize, at_least_s: f64 },
    /// One row for each point, at a constant offset of the clocks (s).
    Rows { offset_s: f64, spread_s: f64 },
    /// Many points of a motion that both recorded, with this time from one row to the next (s).
    Moving { step_s: f64 },
    /// None of these.
    Open { standstills: usize },
}

/// Durations of standstills that are tried (s).
const DURATIONS_S: [f64; 3] = [1.0, 0.5, 0.2];
/// Maximum difference of joint values in a standstill (deg, or mm).
const WITHIN: f64 = 0.02;
/// Maximum value of a joint in rad: a turn, as for the units of columns.
const LARGEST_RAD: f64 = 6.6;
/// Minimum number of points whose times state an offset.
const FEWEST: usize = 5;
/// Minimum number of points of a target in a recorded motion.
const RECORDED: usize = 50;
/// Largest mean time (s) between neighbouring points of a target, and between rows, in a recorded
/// motion.
const DENSE_S: f64 = 0.5;
/// Largest spread of the offset, as a share of the smallest distance of two rows or points in time:
/// otherwise the next row is as near.
const SPREAD: f64 = 0.5;

impl Motion {
    /// Returns the motion of these rows; `None` if a time or a joint value is missing, or the
    /// times do not increase.
    pub fn new(times_s: Vec<f64>, joints: Vec<Vec<f64>>) -> Option<Self> {
        let complete = joints.iter().flatten().chain(&times_s).all(|value| value.is_finite());
        let ordered = times_s.windows(2).all(|pair| pair[0] <= pair[1]);
        (complete && ordered && times_s.len() == joints.len() && times_s.len() > 1).then(|| Self {
            times_s,
            joints,
            names: Vec::new(),
        })
    }

    /// Returns the times of the rows (s).
    pub fn times_s(&self) -> &[f64] {
        &self.times_s
    }

    /// Returns the names of the joints that do not move in the whole recording.
    pub fn still(&self) -> Vec<String> {
        let within = self.within();
        let is_still = |at: &usize| {
            let values: Vec<f64> = self.joints.iter().filter_map(|row| row.get(*at).copied()).collect();
            let values = self.turn().unwound(&values);
            let low = values.iter().fold(f64::INFINITY, |low, value| low.min(*value));
            values.iter().all(|value| value - low <= within)
        };
        (0..self.names.len()).filter(is_still).map(|at| self.names[at].clone()).collect()
    }

    /// `true` if the file has angles in radians, by their size.
    fn in_radians(&self) -> bool {
        self.joints.iter().flatten().all(|value| value.abs() <= LARGEST_RAD)
    }

    /// Returns the largest difference in a standstill, in the unit of the file.
    fn within(&self) -> f64 {
        if self.in_radians() { WITHIN.to_radians() } else { WITHIN }
    }

    fn turn(&self) -> Turn {
        if self.in_radians() { Turn::RADIANS } else { Turn::DEGREES }
    }

    /// Joint values row by row, without the jumps of a controller that wraps angles.
    fn unwound(&self) -> Vec<Vec<f64>> {
        let (turn, width) = (self.turn(), self.joints.iter().map(Vec::len).min().unwrap_or(0));
        let column = |k: usize| turn.unwound(&self.joints.iter().map(|row| row[k]).collect::<Vec<f64>>());
        let columns: Vec<Vec<f64>> = (0..width).map(column).collect();
        (0..self.joints.len()).map(|i| columns.iter().map(|column| column[i]).collect()).collect()
    }

    /// Returns beginning and end of each longest interval in which no joint moves.
    fn standstills(&self) -> Vec<[f64; 2]> {
        let within = self.within();
        let mut found = Vec::new();
        let mut from = 0;
        let unwound = self.unwound();
        let mut range: Vec<[f64; 2]> = unwound[0].iter().map(|value| [*value; 2]).collect();
        for (row, joints) in unwound.iter().enumerate() {
            let wider: Vec<[f64; 2]> =
                range.iter().zip(joints).map(|([low, high], value)| [low.min(*value), high.max(*value)]).collect();
            if wider.iter().all(|[low, high]| high - low <= within) {
                range = wider;
                continue;
            }
            found.push([self.times_s[from], self.times_s[row - 1]]);
            (from, range) = (row, joints.iter().map(|value| [*value; 2]).collect());
        }
        found.push([self.times_s[from], self.times_s[self.times_s.len() - 1]]);
        found
    }

    /// Returns the relation of the sorted times of points, each measured at `targets` targets, to
    /// the recording.
    pub fn meeting(&self, points_s: &[f64], targets: usize) -> Meeting {
        let needed = points_s.len().div_ceil(targets.max(1)).max(1);
        let standstills = self.standstills();
        let lasting = |at_least_s: f64| standstills.iter().filter(|[from, to]| to - from >= at_least_s).count();
        let enough = DURATIONS_S.into_iter().find(|at_least_s| lasting(*at_least_s) >= needed);
        if let Some(at_least_s) = enough {
            return Meeting::Standstills { count: lasting(at_least_s), at_least_s };
        }
        let mean_step = |times: &[f64]| match times {
            [first, .., last] => (last - first) / (times.len() - 1) as f64,
            _ => f64::INFINITY,
        };
        let step_s = mean_step(&self.times_s);
        let is_dense = needed >= RECORDED && mean_step(points_s) * targets.max(1) as f64 <= DENSE_S;
        match offset(points_s, &self.times_s) {
            Some([offset_s, spread_s]) => Meeting::Rows { offset_s, spread_s },
            None if is_dense && step_s <= DENSE_S => Meeting::Moving { step_s },
            None => Meeting::Open { standstills: lasting(DURATIONS_S[0]) },
        }
    }
}

/// Returns the offset of the clocks at which the n-th point belongs to the n-th row, and half of
/// its spread; `None` if the counts differ, or another row is nearly as near.
fn offset(points_s: &[f64], rows_s: &[f64]) -> Option<[f64; 2]> {
    if points_s.len() != rows_s.len() || points_s.len() < FEWEST {
        return None;
    }
    let offsets = points_s.iter().zip(rows_s).map(|(point, row)| point - row);
    let [low, high] = offsets.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], v| [low.min(v), high.max(v)]);
    let gaps = [points_s, rows_s].into_iter().flat_map(|times| times.windows(2).map(|pair| pair[1] - pair[0]));
    let smallest = gaps.fold(f64::INFINITY, f64::min);
    (high - low < SPREAD * smallest).then_some([(low + high) / 2.0, (high - low) / 2.0])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Poses of two joints (deg): `rows` rows at each, `step_s` apart, and two rows between poses.
    fn motion(poses: usize, rows: usize, step_s: f64) -> Motion {
        let mut joints = Vec::new();
        for pose in 0..poses {
            let at = |share: f64| vec![10.0 * (pose as f64 + share), 30.0 - 7.0 * (pose as f64 + share)];
            joints.extend((0..rows).map(|_| at(0.0)));
            joints.extend([at(0.3), at(0.7)]);
        }
        Motion::new((0..joints.len()).map(|row| row as f64 * step_s).collect(), joints).unwrap()
    }

    #[test]
    fn three_rows_a_pose_are_standstills() {
        let points: Vec<f64> = (0..20).map(|pose| 500.0 + 2.5 * f64::from(pose)).collect();
        let meeting = motion(20, 3, 0.5).meeting(&points, 1);
        assert_eq!(meeting, Meeting::Standstills { count: 20, at_least_s: 1.0 });
        // shorter ones are proposed by their duration
        let meeting = motion(20, 3, 0.25).meeting(&points, 1);
        assert_eq!(meeting, Meeting::Standstills { count: 20, at_least_s: 0.5 });
        // two targets of a pose have times of their own
        let twice: Vec<f64> = points.iter().flat_map(|time| [*time, time + 0.1]).collect();
        assert!(matches!(motion(20, 3, 0.5).meeting(&twice, 2), Meeting::Standstills { .. }));
        assert_eq!(motion(20, 3, 0.5).meeting(&twice, 1), Meeting::Open { standstills: 20 });
    }

    #[test]
    fn one_row_a_point_states_the_offset_of_the_clocks() {
        let rows: Vec<f64> = (0..12).map(|i| 3.0 * f64::from(i) + 0.2 * f64::from(i % 3)).collect();
        let joints = (0..12).map(|i| vec![10.0 * f64::from(i)]).collect();
        let motion = Motion::new(rows.clone(), joints).unwrap();
        let points: Vec<f64> = rows.iter().enumerate().map(|(i, row)| row + 77.0 + 0.01 * (i % 4) as f64).collect();
        let Meeting::Rows { offset_s, spread_s } = motion.meeting(&points, 1) else { panic!("no offset") };
        assert!((offset_s - 77.015).abs() < 1e-9 && (spread_s - 0.015).abs() < 1e-9, "{offset_s} {spread_s}");
        // a point that was omitted, and another rhythm
        assert_eq!(motion.meeting(&points[1..], 1), Meeting::Open { standstills: 0 });
        let other: Vec<f64> = (0..12).map(|i| 5.0 * f64::from(i)).collect();
        assert_eq!(motion.meeting(&other, 1), Meeting::Open { standstills: 0 });
    }

    /// Two targets at 10 Hz and joints at 50 Hz that never stand still, on other clocks; points at
    /// rest in groups are no motion.
    #[test]
    fn many_points_of_a_motion_are_compared_by_speeds() {
        let rows: Vec<f64> = (0..3000).map(|i| 0.02 * f64::from(i)).collect();
        let joints = rows.iter().map(|t| vec![40.0 * t.sin(), 10.0 * t]).collect();
        let motion = Motion::new(rows, joints).unwrap();
        let points: Vec<f64> = (0..800).map(|i| 512.0 + 0.1 * f64::from(i / 2)).collect();
        let Meeting::Moving { step_s } = motion.meeting(&points, 2) else { panic!("no motion") };
        assert!((step_s - 0.02).abs() < 1e-12, "{step_s}");
        let groups: Vec<f64> = (0..180).map(|i| 512.0 + 20.0 * f64::from(i / 3) + 0.1 * f64::from(i % 3)).collect();
        assert_eq!(motion.meeting(&groups, 3), Meeting::Open { standstills: 0 });
        assert_eq!(motion.meeting(&points[..60], 2), Meeting::Open { standstills: 0 });
    }
}
