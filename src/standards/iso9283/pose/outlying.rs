//! Attained poses that are far from all others of their pose (not in the standard, which excludes
//! no reading): exchanged labels, placeholders, a measurement in motion. AP and RP contain them.

use crate::iso9283::pose::test::{PoseTest, TestedPose};
use etalon_base::pose::{Vector, centroid, minus, norm};
use etalon_base::pose_name::PoseName;
use etalon_math::statistics::median;

/// Distance from the other readings, in standard deviations of a coordinate, beyond which a reading
/// is outlying: normal scatter exceeds it once in 10¹² readings.
const FAR: f64 = 8.0;
/// Smallest standard deviation (mm) of a coordinate, for readings that are rounded to equal values.
const LEAST_MM: f64 = 5e-4;
/// Median distance of normal readings from their centre, in standard deviations of a coordinate, in
/// the plane and in space (Rayleigh and Maxwell distribution).
const MEDIAN_DISTANCE: [f64; 2] = [1.177, 1.538];
/// Minimum number of readings of a pose, and of all poses.
const FEWEST: [usize; 2] = [3, 10];
/// Maximum share of outlying readings of a pose; more of them come from another approach.
const SHARE: f64 = 0.1;

/// Attained pose that is far from the others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutlyingReading {
    /// Name of the pose.
    pub pose: PoseName,
    /// Number of the cycle.
    pub cycle: i64,
    /// Distance (mm) from the median position of the pose.
    pub distance_mm: f64,
    /// Median distance (mm) of the readings of the pose.
    pub median_mm: f64,
    /// Pose to whose readings the reading is nearer than to its own, if there is one.
    pub near: Option<PoseName>,
}

/// Readings of one pose by one robot.
struct Group {
    pose: PoseName,
    cycles: Vec<i64>,
    positions_mm: Vec<Vector>,
    middle_mm: Vector,
    distances_mm: Vec<f64>,
}

/// Returns the readings that are far from the others of their pose and from the readings before and
/// after them, the farthest first. A drift moves neighbours alike.
pub fn outlying_readings(test: &PoseTest) -> Vec<OutlyingReading> {
    let robots: Vec<String> = test.robots().into_iter().map(str::to_owned).collect();
    let mut found: Vec<OutlyingReading> = robots.iter().flat_map(|robot| by_robot(test, robot)).collect();
    found.sort_by(|a, b| b.distance_mm.total_cmp(&a.distance_mm));
    found
}

fn by_robot(test: &PoseTest, robot: &str) -> Vec<OutlyingReading> {
    let group = |pose: &TestedPose| {
        let read = pose.attained.iter().filter(|v| v.robot == robot);
        Group::new(pose.pose, read.map(|v| (v.cycle, v.position_mm)).collect())
    };
    let groups: Vec<Group> = test.poses.iter().filter_map(group).collect();
    let all = || groups.iter().flat_map(|group| group.distances_mm.iter().copied());
    if all().count() < FEWEST[1] {
        return Vec::new();
    }
    let (common, factor) = (median(all()).unwrap_or(0.0), MEDIAN_DISTANCE[usize::from(test.spatial)]);
    let of_group = |group: &Group| {
        let own = median(group.distances_mm.iter().copied()).unwrap_or(0.0);
        let least = FAR * (own.max(common) / factor).max(LEAST_MM);
        group.beyond(least).into_iter().map(move |i| (i, own)).collect::<Vec<_>>()
    };
    let reading = |group: &Group, (i, median_mm): (usize, f64)| {
        let away = |other: &Group| norm(minus(group.positions_mm[i], other.middle_mm));
        let nearest = groups.iter().min_by(|a, b| away(a).total_cmp(&away(b)));
        OutlyingReading {
            pose: group.pose,
            cycle: group.cycles[i],
            distance_mm: group.distances_mm[i],
            median_mm,
            near: nearest.map(|other| other.pose).filter(|other| *other != group.pose),
        }
    };
    groups.iter().flat_map(|group| of_group(group).into_iter().map(move |i| reading(group, i))).collect()
}

impl Group {
    /// Readings of a pose; `None` if they are too few for a median.
    fn new(pose: PoseName, read: Vec<(i64, Vector)>) -> Option<Self> {
        if read.len() < FEWEST[0] {
            return None;
        }
        let (cycles, positions_mm): (Vec<i64>, Vec<Vector>) = read.into_iter().unzip();
        let middle = |k: usize| median(positions_mm.iter().map(|p: &Vector| p[k])).unwrap_or(f64::NAN);
        let middle_mm = [0, 1, 2].map(middle);
        let distances_mm = positions_mm.iter().map(|p| norm(minus(*p, middle_mm))).collect();
        Some(Self { pose, cycles, positions_mm, middle_mm, distances_mm })
    }

    /// Indices of the readings that are farther than `least_mm` from the middle and from their
    /// neighbours; none if they are many.
    fn beyond(&self, least_mm: f64) -> Vec<usize> {
        let far: Vec<usize> = (0..self.cycles.len()).filter(|&i| self.distances_mm[i] > least_mm).collect();
        let most = (SHARE * self.cycles.len() as f64).max(1.0);
        if far.len() as f64 > most {
            return Vec::new();
        }
        far.into_iter().filter(|&i| self.deviation_from_neighbours(i) > least_mm).collect()
    }

    /// Distance (mm) from the centre of the two nearest readings in time.
    fn deviation_from_neighbours(&self, i: usize) -> f64 {
        let last = self.cycles.len() - 1;
        let beside = match i {
            0 => [1, 2],
            i if i == last => [last - 1, last - 2],
            i => [i - 1, i + 1],
        };
        let centre = centroid(&beside.map(|k| self.positions_mm[k])).unwrap_or(self.middle_mm);
        norm(minus(self.positions_mm[i], centre))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::iso9283::pose::test::AttainedPose;
    use etalon_base::noise::Noise;

    /// Thirty cycles of two poses with a scatter of 0.01 mm, of which `change` changes positions.
    fn test(change: impl Fn(usize, i64, Vector) -> Vector) -> PoseTest {
        let mut noise = Noise::new(3, 1);
        let mut visit = |pose: usize, cycle: i64, p: Vector| {
            let p = change(pose, cycle, p.map(|v| v + noise.gaussian(0.01)));
            AttainedPose {
                cycle,
                position_mm: p,
                angles_rad: Vec::new(),
                approach: None,
                robot: String::new(),
                readings_mm: vec![p],
                readings_rad: vec![Vec::new()],
            }
        };
        let places = [[500.0, 0.0, 500.0], [650.0, -150.0, 650.0]];
        let poses = places.into_iter().enumerate().map(|(i, p)| TestedPose {
            pose: (i as i64 + 1).into(),
            commanded_mm: None,
            commanded_rad: Vec::new(),
            attained: (1..31).map(|cycle| visit(i, cycle, p)).collect(),
        });
        PoseTest {
            poses: poses.collect(),
            spatial: true,
            angles: Vec::new(),
            rotation_order: None,
            warnings: Vec::new(),
        }
    }

    fn named(found: &[OutlyingReading]) -> Vec<(PoseName, i64, Option<PoseName>)> {
        found.iter().map(|v| (v.pose, v.cycle, v.near)).collect()
    }

    #[test]
    fn a_blunder_is_named_with_its_cycle() {
        let found = outlying_readings(&test(
            |pose, cycle, p| if (pose, cycle) == (0, 9) { [p[0] + 2.0, p[1], p[2]] } else { p },
        ));
        assert_eq!(named(&found), [(1.into(), 9, None)]);
        assert!((found[0].distance_mm - 2.0).abs() < 0.05 && found[0].median_mm < 0.03, "{found:?}");
        // a placeholder in two cycles, and the first and the last reading
        let wrong = |pose, cycle: i64, p| if pose == 1 && [1, 30].contains(&cycle) { [-9999.0; 3] } else { p };
        assert_eq!(outlying_readings(&test(wrong)).len(), 2);
    }

    #[test]
    fn exchanged_labels_are_named_with_the_other_pose() {
        let found = outlying_readings(&test(|pose, cycle, p| match (pose, cycle) {
            (0, 7) => [650.0, -150.0, 650.0],
            (1, 7) => [500.0, 0.0, 500.0],
            _ => p,
        }));
        let mut found = named(&found);
        found.sort_unstable_by_key(|reading| reading.0);
        assert_eq!(found, [(1.into(), 7, Some(2.into())), (2.into(), 7, Some(1.into()))]);
    }

    #[test]
    fn scatter_drift_and_approaches_are_no_blunders() {
        assert_eq!(outlying_readings(&test(|_, _, p| p)), []);
        // a robot that warms up by 0.3 mm within a few cycles
        let warm = |_, cycle: i64, p: Vector| [p[0] + 0.3 * (-(cycle as f64) / 6.0).exp(), p[1], p[2]];
        assert_eq!(outlying_readings(&test(warm)), []);
        // every fourth reading from the other side
        let sides = |_, cycle: i64, p: Vector| [p[0] + if cycle % 4 == 0 { 0.4 } else { 0.0 }, p[1], p[2]];
        assert_eq!(outlying_readings(&test(sides)), []);
        // equal readings, one of them rounded to the next digit
        let rounded = |_, cycle, p: Vector| p.map(|v: f64| v.round() + if cycle == 3 { 0.001 } else { 0.0 });
        assert_eq!(outlying_readings(&test(rounded)), []);
    }
}
