//! Attained poses that are far from all others of their pose (not in the standard, which excludes
//! no reading): exchanged labels, placeholders, a measurement in motion. AP and RP contain them.

use crate::iso9283::pose::test::{PoseTest, TestedPose};
use crate::outlying::{FarReading, Readings, far_readings};
use etalon_base::pose::{minus, norm};
use etalon_base::pose_name::PoseName;
use etalon_math::statistics::repeated_rows;

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

/// Attained pose that repeats an earlier one of its pose digit for digit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RepeatedReading {
    /// Name of the pose.
    pub pose: PoseName,
    /// Number of the cycle.
    pub cycle: i64,
    /// Number of the cycle that is repeated.
    pub first: i64,
}

/// Pose and cycles of the readings of one robot.
struct Visits {
    pose: PoseName,
    cycles: Vec<i64>,
}

/// Returns the readings that are far from the others of their pose and from the readings before and
/// after them, the farthest first. A drift moves neighbours alike.
pub fn outlying_readings(test: &PoseTest) -> Vec<OutlyingReading> {
    let mut found: Vec<OutlyingReading> = robots(test).iter().flat_map(|robot| by_robot(test, robot)).collect();
    found.sort_by(|a, b| b.distance_mm.total_cmp(&a.distance_mm));
    found
}

/// Returns the readings that repeat an earlier reading of their pose digit for digit: rows that a
/// table contains twice. Empty if rounding explains repeats.
pub fn repeated_readings(test: &PoseTest) -> Vec<RepeatedReading> {
    let of_pose = |(robot, pose): (&String, &TestedPose)| {
        let read: Vec<_> = pose.attained.iter().filter(|v| v.robot == *robot).collect();
        let positions: Vec<[f64; 3]> = read.iter().map(|v| v.position_mm).collect();
        let repeat = |[i, first]: [usize; 2]| RepeatedReading {
            pose: pose.pose,
            cycle: read[i].cycle,
            first: read[first].cycle,
        };
        repeated_rows(&positions).into_iter().map(repeat).collect::<Vec<_>>()
    };
    robots(test).iter().flat_map(|robot| test.poses.iter().map(move |pose| (robot, pose))).flat_map(of_pose).collect()
}

fn robots(test: &PoseTest) -> Vec<String> {
    test.robots().into_iter().map(str::to_owned).collect()
}

fn by_robot(test: &PoseTest, robot: &str) -> Vec<OutlyingReading> {
    let group = |pose: &TestedPose| {
        let read = || pose.attained.iter().filter(|v| v.robot == robot);
        let readings = Readings::new(read().map(|v| v.position_mm).collect())?;
        Some((Visits { pose: pose.pose, cycles: read().map(|v| v.cycle).collect() }, readings))
    };
    let (visits, groups): (Vec<Visits>, Vec<Readings>) = test.poses.iter().filter_map(group).unzip();
    let reading = |FarReading { group, reading, distance_mm, median_mm }: FarReading| {
        let away = |i: &usize| norm(minus(groups[group].positions_mm[reading], groups[*i].middle_mm));
        let nearest = (0..groups.len()).min_by(|a, b| away(a).total_cmp(&away(b)));
        let Visits { pose, ref cycles } = visits[group];
        let near = nearest.map(|other| visits[other].pose).filter(|other| *other != pose);
        OutlyingReading { pose, cycle: cycles[reading], distance_mm, median_mm, near }
    };
    far_readings(&groups, if test.spatial { 3 } else { 2 }).into_iter().map(reading).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::iso9283::pose::test::AttainedPose;
    use etalon_base::noise::Noise;
    use etalon_base::pose::Vector;

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

    #[test]
    fn rows_that_a_table_contains_twice_are_named_with_the_first() {
        let test = test(|_, _, p| p);
        assert_eq!(repeated_readings(&test), []);
        let mut twice = test.clone();
        for pose in &mut twice.poses {
            let again = pose.attained.clone();
            // counted as further cycles
            pose.attained.extend(again.into_iter().map(|v| AttainedPose { cycle: v.cycle + 30, ..v }));
        }
        let found = repeated_readings(&twice);
        assert_eq!(found.len(), 60);
        assert_eq!(found[0], RepeatedReading { pose: 1.into(), cycle: 31, first: 1 });
        // repeats that are rounded to 0.02 mm, of a scatter of 0.01 mm
        let rounded = |_, _, p: Vector| p.map(|v: f64| (50.0 * v).round() / 50.0);
        assert_eq!(repeated_readings(&self::test(rounded)), []);
    }
}
