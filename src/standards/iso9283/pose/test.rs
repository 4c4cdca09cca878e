//! Attained and commanded poses of a test (ISO 9283:1998 7.2), and their grouping.

use crate::iso9283::pose::rotations::RotationOrder;
use crate::iso9283::statistics::sample::wrapped;
use etalon_base::message::Message;
use etalon_base::pose::{Vector, centroid};
use etalon_base::pose_name::PoseName;
use std::collections::{BTreeMap, BTreeSet};

/// One attained pose; poses are in the order of recording.
#[derive(Clone, Debug, PartialEq)]
pub struct AttainedPose {
    /// Number of the cycle.
    pub cycle: i64,
    /// Attained position; z is zero for planar robots.
    pub position_mm: Vector,
    /// Attained angles, in the order of [`PoseTest::angles`].
    pub angles_rad: Vec<f64>,
    /// Approach: value in the column `approach`, or the previous pose of the path; `None` if
    /// unknown: at the first row, or where the reading of the previous pose is missing.
    pub approach: Option<String>,
    /// Value in the column `robot`.
    pub robot: String,
    /// Readings whose mean is the position; a single one if it was read once.
    pub readings_mm: Vec<Vector>,
    /// Angles of each reading.
    pub readings_rad: Vec<Vec<f64>>,
}

/// A commanded pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CommandedPose {
    /// Name of the pose.
    pub pose: PoseName,
    /// Commanded position.
    pub position_mm: Vector,
}

/// A pose of the test with all its attained poses.
#[derive(Clone, Debug, PartialEq)]
pub struct TestedPose {
    /// Name of the pose.
    pub pose: PoseName,
    /// Commanded position; without it accuracy and distance are not determined.
    pub commanded_mm: Option<Vector>,
    /// Commanded angles.
    pub commanded_rad: Vec<f64>,
    /// Attained poses, at least one.
    pub attained: Vec<AttainedPose>,
}

/// A test of poses.
#[derive(Clone, Debug, PartialEq)]
pub struct PoseTest {
    /// Measured poses, in order.
    pub poses: Vec<TestedPose>,
    /// `true` if z was measured.
    pub spatial: bool,
    /// Measured angles: 0, 1, 2 for a, b, c.
    pub angles: Vec<usize>,
    /// Order of the rotations a, b, c, if given.
    pub rotation_order: Option<RotationOrder>,
    /// Warnings about unusual data.
    pub warnings: Vec<Message>,
}

impl AttainedPose {
    /// Adds another reading of the same visit to the means.
    pub fn read_again(&mut self, reading: &Self) {
        self.readings_mm.push(reading.position_mm);
        self.readings_rad.push(reading.angles_rad.clone());
        let n = self.readings_mm.len() as f64;
        self.position_mm = centroid(&self.readings_mm).unwrap_or(self.position_mm);
        for (mean, angle) in self.angles_rad.iter_mut().zip(&reading.angles_rad) {
            *mean += wrapped(angle - *mean) / n;
        }
    }
}

impl TestedPose {
    /// Attained positions selected by `wanted`.
    pub fn positions_mm(&self, wanted: impl Fn(&AttainedPose) -> bool) -> Vec<Vector> {
        self.attained.iter().filter(|v| wanted(v)).map(|v| v.position_mm).collect()
    }

    /// Attained angles number `k` selected by `wanted`.
    pub fn angles_rad(&self, k: usize, wanted: impl Fn(&AttainedPose) -> bool) -> Vec<f64> {
        self.attained.iter().filter(|v| wanted(v)).filter_map(|v| v.angles_rad.get(k).copied()).collect()
    }

    /// Number of attained poses for each approach, in alphabetical order.
    pub fn approaches(&self) -> BTreeMap<&str, usize> {
        let mut counts = BTreeMap::new();
        for name in self.attained.iter().filter_map(|v| v.approach.as_deref()) {
            *counts.entry(name).or_default() += 1;
        }
        counts
    }

    /// Approaches with at least two visits, if there are several: ISO 9283 defines AP and RP for
    /// one approach (7.2.1, 7.2.2).
    pub fn repeated_approaches(&self) -> Vec<&str> {
        let repeated = self.approaches().into_iter().filter(|(_, count)| *count > 1);
        let names: Vec<&str> = repeated.map(|(name, _)| name).collect();
        if names.len() > 1 { names } else { Vec::new() }
    }

    /// Visits by one approach.
    pub fn approached(&self, name: &str) -> Self {
        let mut visits = self.clone();
        visits.attained.retain(|v| v.approach.as_deref() == Some(name));
        visits
    }
}

/// Name of the approach from a pose.
pub fn from_pose(pose: PoseName) -> String {
    format!("from pose {pose}")
}

/// Two poses that were attained in the same cycle.
#[derive(Clone, Copy, Debug)]
pub struct PosePair<'a> {
    /// First pose.
    pub from: &'a AttainedPose,
    /// Second pose.
    pub to: &'a AttainedPose,
}

impl TestedPose {
    /// Pairs with another pose, from the cycles with exactly one visit of each.
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

    /// Test of the first robot by name.
    pub fn first_robot_test(&self) -> Self {
        let mut first = self.clone();
        let Some(robot) = self.robots().first().map(|r| (*r).to_owned()) else { return first };
        first.poses.iter_mut().for_each(|p| p.attained.retain(|v| v.robot == robot));
        first.poses.retain(|p| !p.attained.is_empty());
        first
    }
}
