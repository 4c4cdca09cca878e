//! Attained and commanded poses of a test (ISO 9283:1998 7.2), and how they are grouped.

use crate::iso9283::statistics::sample::wrapped;
use etalon_base::message::Message;
use etalon_base::pose::{Vector, centroid};
use etalon_base::pose_name::PoseName;
use std::collections::{BTreeMap, BTreeSet};

/// A pose as it was attained once, in the order of recording.
#[derive(Clone, Debug, PartialEq)]
pub struct AttainedPose {
    /// Number of the cycle.
    pub cycle: i64,
    /// Attained position; z is zero for planar robots.
    pub position_mm: Vector,
    /// Attained angles, in the order of [`PoseTest::angles`].
    pub angles_rad: Vec<f64>,
    /// How it was approached: the value in the column `approach`, or the pose visited before; `None` for the first row.
    pub approach: Option<String>,
    /// The value in the column `robot`.
    pub robot: String,
    /// Readings whose mean the position is; one where it was read once.
    pub readings_mm: Vec<Vector>,
}

/// A pose as it is commanded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CommandedPose {
    /// Name of the pose.
    pub pose: PoseName,
    /// Commanded position.
    pub position_mm: Vector,
}

/// A pose of the test with all that was attained of it.
#[derive(Clone, Debug, PartialEq)]
pub struct TestedPose {
    /// Name of the pose.
    pub pose: PoseName,
    /// Commanded position; without it there is neither accuracy nor distance.
    pub commanded_mm: Option<Vector>,
    /// Commanded angles.
    pub commanded_rad: Vec<f64>,
    /// Attained poses, at least one.
    pub attained: Vec<AttainedPose>,
}

/// A test of poses.
#[derive(Clone, Debug, PartialEq)]
pub struct PoseTest {
    /// Its poses that were measured, in their order.
    pub poses: Vec<TestedPose>,
    /// Whether there is a z.
    pub spatial: bool,
    /// Which angles there are: of 0, 1, 2 for a, b, c.
    pub angles: Vec<usize>,
    /// What is odd, but no error.
    pub warnings: Vec<Message>,
}

impl AttainedPose {
    /// Takes one more reading of the same visit into its means.
    pub fn read_again(&mut self, reading: &Self) {
        self.readings_mm.push(reading.position_mm);
        let n = self.readings_mm.len() as f64;
        self.position_mm = centroid(&self.readings_mm).unwrap_or(self.position_mm);
        for (mean, angle) in self.angles_rad.iter_mut().zip(&reading.angles_rad) {
            *mean += wrapped(angle - *mean) / n;
        }
    }
}

impl TestedPose {
    /// Attained positions that `wanted` takes.
    pub fn positions_mm(&self, wanted: impl Fn(&AttainedPose) -> bool) -> Vec<Vector> {
        self.attained.iter().filter(|v| wanted(v)).map(|v| v.position_mm).collect()
    }

    /// Attained angles number `k` that `wanted` takes.
    pub fn angles_rad(&self, k: usize, wanted: impl Fn(&AttainedPose) -> bool) -> Vec<f64> {
        self.attained.iter().filter(|v| wanted(v)).filter_map(|v| v.angles_rad.get(k).copied()).collect()
    }

    /// Numbers of attained poses by approach, in alphabetical order.
    pub fn approaches(&self) -> BTreeMap<&str, usize> {
        let mut counts = BTreeMap::new();
        for name in self.attained.iter().filter_map(|v| v.approach.as_deref()) {
            *counts.entry(name).or_default() += 1;
        }
        counts
    }
}

/// What an approach is called by the pose before.
pub fn from_pose(pose: PoseName) -> String {
    format!("from pose {pose}")
}

/// A pair of poses that were attained in the same cycle.
#[derive(Clone, Copy, Debug)]
pub struct PosePair<'a> {
    /// Of the first pose.
    pub from: &'a AttainedPose,
    /// Of the second.
    pub to: &'a AttainedPose,
}

impl TestedPose {
    /// Pairs with another pose, of the cycles that have each of the two once.
    pub fn pairs<'a>(&'a self, other: &'a Self) -> Vec<PosePair<'a>> {
        let once = |p: &'a Self| {
            let mut by_cycle: BTreeMap<(&str, i64), Vec<&AttainedPose>> = BTreeMap::new();
            p.attained.iter().for_each(|v| by_cycle.entry((v.robot.as_str(), v.cycle)).or_default().push(v));
            by_cycle.retain(|_, attained| attained.len() == 1);
            by_cycle
        };
        let others = once(other);
        once(self).into_iter().filter_map(|(key, v)| Some(PosePair { from: v[0], to: others.get(&key)?[0] })).collect()
    }
}

impl PoseTest {
    /// Names of the robots, in alphabetical order.
    pub fn robots(&self) -> BTreeSet<&str> {
        self.poses.iter().flat_map(|p| &p.attained).map(|v| v.robot.as_str()).collect()
    }

    /// The test of the robot that comes first by name.
    pub fn of_first_robot(&self) -> Self {
        let mut first = self.clone();
        let Some(robot) = self.robots().first().map(|r| (*r).to_owned()) else { return first };
        first.poses.iter_mut().for_each(|p| p.attained.retain(|v| v.robot == robot));
        first.poses.retain(|p| !p.attained.is_empty());
        first
    }
}
