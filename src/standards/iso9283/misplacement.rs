//! Attained positions that do not belong to the commanded ones: another unit, exchanged columns, or
//! another frame (not in the standard). Errors of a robot are a small share of the extent of its
//! test; a deviation as large as the extent is an error of the tables, and so is a deviation of
//! which one motion of all positions explains nearly all.

use crate::iso9283::motion::MotionSettings;
use crate::iso9283::motion::stream::Recording;
use crate::iso9283::path::commanded::CommandPoint;
use crate::iso9283::pose::test::PoseTest;
use crate::iso9283::statistics::sample::{mean_position, spread, unwrapped, wrapped};
use etalon_base::pose::{Vector, centroid, dot, minus, norm};
use etalon_base::pose_name::PoseName;
use etalon_fit::rigid;
use etalon_math::statistics::rms;
use etalon_math::symmetric_eigen;

/// Units that are taken for millimetres, with their length in mm.
const UNITS: [(&str, f64); 3] = [("m", 1000.0), ("cm", 10.0), ("inch", 25.4)];
/// Maximum deviation, as a share of the commanded coordinates, in the right unit.
const IN_UNIT: f64 = 0.05;
/// Minimum root mean square of one coordinate whose unit is judged, as a share of the root mean
/// square of all coordinates.
const LARGE: f64 = 0.1;
/// Deviation as a share of the extent that no robot has.
const AS_LARGE: f64 = 0.5;
/// Maximum deviation after a motion of the frame, as a share of the deviation before, if that is as
/// large as the extent.
const BY_FRAME: f64 = 0.1;
/// Maximum share after a motion that explains a smaller deviation. Independent errors of five poses
/// are reduced by this factor once in 10¹⁰ tests; errors of a robot vary over the poses more than
/// this.
const BY_FRAME_ALONE: f64 = 0.02;
/// Smallest deviation as a share of the extent that is compared with another frame.
const LEAST_BY_FRAME: f64 = 0.01;
/// Maximum ratio of a deviation and the largest one at poses that are named.
const NEAR_LARGEST: f64 = 0.1;

/// A table of a test.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum TestTable {
    /// Attained positions; of the robot with this name if there are several.
    Attained(String),
    /// Commanded positions.
    Commanded,
}

/// Reason why attained positions are not near the commanded positions.
#[derive(Clone, Debug, PartialEq)]
pub enum Misplacement {
    /// A table is in another unit than mm.
    Unit {
        /// The table.
        table: TestTable,
        /// The coordinates in the other unit: 0, 1, 2 for x, y, z.
        axes: Vec<usize>,
        /// The unit: m, cm or inch.
        unit: &'static str,
        /// Length of the unit (mm).
        length_mm: f64,
    },
    /// The angles of a table are radians, not degrees.
    AngleUnit {
        /// The table.
        table: TestTable,
        /// The angles: 0, 1, 2 for a, b, c.
        angles: Vec<usize>,
    },
    /// The attained angles are farther from the commanded ones than a robot turns by mistake.
    Angles {
        /// The angles: 0, 1, 2 for a, b, c.
        angles: Vec<usize>,
        /// Largest deviation (rad).
        largest_rad: f64,
        /// The poses with the largest deviations, largest first.
        poses: Vec<PoseName>,
    },
    /// The positions agree if the columns of one table are exchanged.
    Columns {
        /// Root mean square deviation (mm).
        deviation_mm: f64,
        /// Change of one table.
        change: ColumnChange,
        /// Root mean square deviation (mm) after the change.
        left_mm: f64,
    },
    /// One motion brings the commanded positions to the attained ones.
    Frame {
        /// Root mean square deviation (mm).
        deviation_mm: f64,
        /// Shift (mm) of the centre of the positions.
        shift_mm: Vector,
        /// Angle (rad) of the rotation, if enough poses show it.
        turn_rad: Option<f64>,
        /// Root mean square deviation (mm) after the motion.
        left_mm: f64,
    },
    /// The deviation is as large as the extent of the test.
    Large {
        /// Root mean square deviation (mm).
        deviation_mm: f64,
        /// Root mean square distance (mm) of the commanded positions from their centre, of a single
        /// position from the origin.
        extent_mm: f64,
        /// The poses with the largest deviations, largest first.
        poses: Vec<PoseName>,
    },
}

/// Mistake in the columns of a table: 0, 1, 2 for x, y, z.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ColumnChange {
    /// Two columns are swapped.
    Swapped([usize; 2]),
    /// x, y and z are in these columns of the attained positions.
    Order([usize; 3]),
    /// A column has the other sign.
    Sign(usize),
}

impl ColumnChange {
    /// All changes. Two other signs, or a swap with another sign, are rotations of the frame.
    const ALL: [Self; 8] = [
        Self::Swapped([0, 1]),
        Self::Swapped([0, 2]),
        Self::Swapped([1, 2]),
        Self::Order([1, 2, 0]),
        Self::Order([2, 0, 1]),
        Self::Sign(0),
        Self::Sign(1),
        Self::Sign(2),
    ];

    /// Attained position after the change.
    fn apply(self, p: Vector) -> Vector {
        let mut changed = p;
        match self {
            Self::Swapped([i, j]) => changed.swap(i, j),
            Self::Order(order) => changed = order.map(|k| p[k]),
            Self::Sign(k) => changed[k] = -p[k],
        }
        changed
    }
}

/// Angles of one pose, and their commanded values (rad).
struct AnglePair {
    pose: PoseName,
    attained_rad: Vec<f64>,
    commanded_rad: Vec<f64>,
}

/// Radians per degree.
const DEG: f64 = std::f64::consts::PI / 180.0;
/// Smallest root mean square (rad) of angles whose unit is judged.
const LEAST_ANGLE_RAD: f64 = DEG;
/// Deviation (rad) of an angle that no robot has.
const TURNED_RAD: f64 = 5.0 * DEG;

/// Returns the reason why the attained angles of a test are far from the commanded angles; `None`
/// if they are near, or not comparable. Poses whose angles are not separable are not compared.
pub fn misplaced_angles(test: &PoseTest) -> Option<Misplacement> {
    let first = test.first_robot_test();
    let compared = first.poses.iter().filter(|p| p.commanded_rad.len() == first.angles.len());
    let pairs: Vec<AnglePair> = compared
        .filter(|p| first.inseparable(p).is_none())
        .map(|p| AnglePair {
            pose: p.pose,
            attained_rad: (0..first.angles.len())
                .map(|k| spread(&unwrapped(&p.angles_rad(k, |_| true))).mean)
                .collect(),
            commanded_rad: p.commanded_rad.clone(),
        })
        .collect();
    let name = |k: &usize| first.angles[*k];
    let all = 0..first.angles.len();
    let sides = [(TestTable::Attained(String::new()), 1.0 / DEG, 1.0), (TestTable::Commanded, 1.0, 1.0 / DEG)];
    for (table, attained, commanded) in sides {
        let of_size = |k: &usize| rms(pairs.iter().map(|p| attained.max(commanded) * p.smaller(*k, attained)));
        let large: Vec<usize> = all.clone().filter(|k| of_size(k) > LEAST_ANGLE_RAD).collect();
        let away = |k: &usize, attained: f64, commanded: f64| {
            rms(pairs.iter().map(|p| wrapped(attained * p.attained_rad[*k] - commanded * p.commanded_rad[*k])))
        };
        let fits = |k: &usize| away(k, attained, commanded) <= IN_UNIT * of_size(k);
        if !large.is_empty() && large.iter().all(|k| fits(k) && away(k, 1.0, 1.0) > AS_LARGE * of_size(k)) {
            return Some(Misplacement::AngleUnit { table, angles: large.iter().map(name).collect() });
        }
    }
    let off = |p: &AnglePair, k: usize| wrapped(p.attained_rad[k] - p.commanded_rad[k]).abs();
    let angles: Vec<usize> = all.clone().filter(|&k| pairs.iter().any(|p| off(p, k) > TURNED_RAD)).collect();
    let worst = |p: &AnglePair| all.clone().map(|k| off(p, k)).fold(0.0, f64::max);
    let mut poses: Vec<(f64, PoseName)> = pairs.iter().map(|p| (worst(p), p.pose)).collect();
    poses.retain(|(largest, _)| *largest > TURNED_RAD);
    poses.sort_by(|a, b| b.0.total_cmp(&a.0));
    let largest_rad = poses.first()?.0;
    let poses = poses.into_iter().take(3).map(|(_, pose)| pose).collect();
    Some(Misplacement::Angles { angles: angles.iter().map(name).collect(), largest_rad, poses })
}

impl AnglePair {
    /// Angle of the table in radians, as it was read: the attained one if it is multiplied.
    fn smaller(&self, k: usize, attained: f64) -> f64 {
        if attained > 1.0 { self.attained_rad[k] } else { self.commanded_rad[k] }
    }
}

/// Positions of one pose or of one robot, and their correct values.
#[derive(Clone, Copy)]
struct Pair {
    attained_mm: Vector,
    commanded_mm: Vector,
}

/// Returns the reason why the attained positions of a test are far from the commanded positions, or
/// the positions of one robot far from the positions of the first; `None` if they are near, or not
/// comparable.
pub fn misplaced_poses(test: &PoseTest) -> Option<Misplacement> {
    let robots: Vec<String> = test.robots().into_iter().map(str::to_owned).collect();
    let mean = |pose: usize, robot: &str| {
        let positions = test.poses[pose].positions_mm(|v| v.robot == robot);
        (!positions.is_empty()).then(|| mean_position(&positions))
    };
    let first = robots.first()?;
    for robot in &robots {
        let table = TestTable::Attained(if robots.len() > 1 { robot.clone() } else { String::new() });
        let pair = |i: usize| {
            let reference = test.poses[i].commanded_mm.or_else(|| mean(i, first).filter(|_| robot != first))?;
            Some((test.poses[i].pose, Pair { attained_mm: mean(i, robot)?, commanded_mm: reference }))
        };
        let pairs: Vec<(PoseName, Pair)> = (0..test.poses.len()).filter_map(pair).collect();
        if let Some(found) = other_unit(&pairs, table) {
            return Some(found);
        }
        if test.poses.iter().any(|p| p.commanded_mm.is_some())
            && let Some(found) = elsewhere(&pairs)
        {
            return Some(found);
        }
    }
    None
}

/// Returns the unit in which all or some coordinates agree with the commanded coordinates, if there
/// is one.
fn other_unit(pairs: &[(PoseName, Pair)], attained: TestTable) -> Option<Misplacement> {
    let all = rms(pairs.iter().flat_map(|(_, p)| p.attained_mm.into_iter().chain(p.commanded_mm)));
    for (unit, length_mm) in UNITS {
        for (table, of_attained) in [(attained.clone(), true), (TestTable::Commanded, false)] {
            let judged = |&k: &usize| {
                let sides = pairs.iter().map(|(_, p)| match of_attained {
                    true => [p.attained_mm[k], p.commanded_mm[k]],
                    false => [p.commanded_mm[k], p.attained_mm[k]],
                });
                let size = rms(sides.clone().map(|[_, right]| right));
                let off = rms(sides.map(|[small, right]| length_mm * small - right));
                size > LARGE * all && off <= IN_UNIT * size
            };
            let axes: Vec<usize> = (0..3).filter(judged).collect();
            if !axes.is_empty() {
                return Some(Misplacement::Unit { table, axes, unit, length_mm });
            }
        }
    }
    scaled_elsewhere(pairs, attained)
}

/// Returns the unit in which the distances between all positions agree, if there is one. The
/// positions may be in different frames.
fn scaled_elsewhere(pairs: &[(PoseName, Pair)], attained: TestTable) -> Option<Misplacement> {
    let (from, to): (Vec<Vector>, Vec<Vector>) = pairs.iter().map(|(_, p)| (p.attained_mm, p.commanded_mm)).unzip();
    if pairs.len() < 3 {
        return None;
    }
    for (unit, length_mm) in UNITS {
        for (table, factor) in [(attained.clone(), length_mm), (TestTable::Commanded, 1.0 / length_mm)] {
            let scaled: Vec<Vector> = from.iter().map(|p| p.map(|v| v * factor)).collect();
            let Ok(fit) = rigid(&scaled, &to) else { continue };
            if fit.rms_mm() <= IN_UNIT * extent(&to) {
                return Some(Misplacement::Unit { table, axes: vec![0, 1, 2], unit, length_mm });
            }
        }
    }
    None
}

/// Root mean square distance from the centre.
fn extent(points: &[Vector]) -> f64 {
    let middle = centroid(points).unwrap_or_default();
    rms(points.iter().map(|p| norm(minus(*p, middle))))
}

/// Returns the change of the columns or the motion of the frame that explains the deviation, or a
/// deviation as large as the extent.
fn elsewhere(pairs: &[(PoseName, Pair)]) -> Option<Misplacement> {
    let off: Vec<Vector> = pairs.iter().map(|(_, p)| minus(p.attained_mm, p.commanded_mm)).collect();
    let (from, to): (Vec<Vector>, Vec<Vector>) = pairs.iter().map(|(_, p)| (p.attained_mm, p.commanded_mm)).unzip();
    let deviation_mm = rms(off.iter().map(|d| norm(*d)));
    let extent_mm = if to.len() > 1 { extent(&to) } else { norm(*to.first()?) };
    let size = Size { deviation_mm, extent_mm };
    if let Some(found) = exchanged_columns(pairs, size) {
        return Some(found);
    }
    let shift_mm = centroid(&off)?;
    let frame = |turn_rad, left_mm| Misplacement::Frame { deviation_mm, shift_mm, turn_rad, left_mm };
    let left_mm = rms(off.iter().map(|d| norm(minus(*d, shift_mm))));
    if to.len() > 1 && size.is_explained(left_mm) {
        return Some(frame(None, left_mm));
    }
    // a rotation fits three positions of one distance each: it takes a fourth to show it
    if let Some(fit) = rigid(&to, &from).ok().filter(|fit| to.len() > 3 && size.is_explained(fit.rms_mm())) {
        return Some(frame(Some(fit.to_T_from.angle_rad()), fit.rms_mm()));
    }
    if !size.is_large() {
        return None;
    }
    let mut largest: Vec<usize> = (0..off.len()).collect();
    largest.sort_by(|&i, &j| norm(off[j]).total_cmp(&norm(off[i])));
    let least_mm = NEAR_LARGEST * norm(off[largest[0]]);
    let named = largest.into_iter().take(3).filter(|&i| norm(off[i]) >= least_mm);
    Some(Misplacement::Large { deviation_mm, extent_mm, poses: named.map(|i| pairs[i].0).collect() })
}

/// Root mean square deviation of a test, and root mean square distance of its commanded positions
/// from their centre (mm).
#[derive(Clone, Copy)]
struct Size {
    deviation_mm: f64,
    extent_mm: f64,
}

impl Size {
    /// `true` if the deviation is as large as the extent.
    fn is_large(self) -> bool {
        self.extent_mm > 0.0 && self.deviation_mm >= AS_LARGE * self.extent_mm
    }

    /// `true` if a change of all positions after which this deviation remains is the cause. What
    /// remains must be an error that a robot can have.
    fn is_explained(self, left_mm: f64) -> bool {
        let share = if self.is_large() { BY_FRAME } else { BY_FRAME_ALONE };
        self.extent_mm > 0.0
            && self.deviation_mm >= LEAST_BY_FRAME * self.extent_mm
            && left_mm <= share * self.deviation_mm
            && left_mm <= IN_UNIT * self.extent_mm
    }
}

/// Returns the change of the columns of one table with which the positions agree, if there is one.
/// Unlike a motion of the frame, the change has no fitted parameter.
fn exchanged_columns(pairs: &[(PoseName, Pair)], size: Size) -> Option<Misplacement> {
    let left =
        |change: ColumnChange| rms(pairs.iter().map(|(_, p)| norm(minus(change.apply(p.attained_mm), p.commanded_mm))));
    let changes = ColumnChange::ALL.into_iter().map(|change| (change, left(change)));
    let (change, left_mm) = changes.min_by(|a, b| a.1.total_cmp(&b.1))?;
    let deviation_mm = size.deviation_mm;
    size.is_explained(left_mm).then_some(Misplacement::Columns { deviation_mm, change, left_mm })
}

/// Smallest eigenvalue, relative to the largest, of a direction in which points of a path show a
/// shift: a straight path shows none along itself.
const SHOWN: f64 = 1e-3;

/// Returns the common shift of the mean attained path, in the normal planes of its command points,
/// if this shift explains the deviation of the path.
pub fn misplaced_path(points: &[CommandPoint], means_mm: &[Vector]) -> Option<Misplacement> {
    let across = |v: Vector, tangent: Vector| {
        let along = dot(v, tangent);
        [0, 1, 2].map(|k| v[k] - along * tangent[k])
    };
    let commanded: Vec<Vector> = points.iter().map(|p| p.position_mm).collect();
    let off: Vec<Vector> = points.iter().zip(means_mm).map(|(p, m)| minus(*m, p.position_mm)).collect();
    let projected =
        |i: usize, j: usize| points.iter().map(move |p| f64::from(i == j) - p.tangent[i] * p.tangent[j]).sum::<f64>();
    let normal: [[f64; 3]; 3] = std::array::from_fn(|i| std::array::from_fn(|j| projected(i, j)));
    let right: Vector = std::array::from_fn(|i| points.iter().zip(&off).map(|(p, d)| across(*d, p.tangent)[i]).sum());
    let (values, vectors) = symmetric_eigen(normal);
    let most = values.iter().fold(0.0, |most: f64, v| most.max(*v));
    let shown = || values.iter().zip(&vectors).filter(|(value, _)| **value > SHOWN * most);
    let shift_mm: Vector = std::array::from_fn(|k| shown().map(|(value, v)| dot(*v, right) / value * v[k]).sum());
    let deviation_mm = rms(off.iter().map(|d| norm(*d)));
    let left = |(p, d): (&CommandPoint, &Vector)| norm(minus(*d, across(shift_mm, p.tangent)));
    let left_mm = rms(points.iter().zip(&off).map(left));
    let size = Size { deviation_mm, extent_mm: extent(&commanded) };
    size.is_explained(left_mm).then_some(Misplacement::Frame { deviation_mm, shift_mm, turn_rad: None, left_mm })
}

/// Returns the unit in which a recording passes the commanded poses or the commanded path, if it
/// does not in mm.
pub fn misplaced_motion(recording: &Recording, settings: &MotionSettings) -> Option<Misplacement> {
    let poses = settings.poses.iter().flatten().map(|p| p.position_mm);
    let path = settings.path.iter().flat_map(|p| p.path.command_points(PATH_POINTS)).map(|p| p.position_mm);
    let commanded: Vec<Vector> = poses.chain(path).collect();
    let step = recording.stream.len().div_ceil(SAMPLES).max(1);
    let samples: Vec<Vector> = recording.stream.positions_mm().iter().step_by(step).copied().collect();
    let size = rms(commanded.iter().map(|p| norm(*p)));
    // distance of the commanded positions from the samples in a unit
    let away = |of_samples: f64, of_commanded: f64| {
        let nearest = |p: &Vector| {
            let p = p.map(|v| v * of_commanded);
            let away = samples.iter().map(|q| norm(minus(q.map(|v| v * of_samples), p)));
            away.fold(f64::INFINITY, f64::min)
        };
        rms(commanded.iter().map(nearest))
    };
    if commanded.is_empty() || away(1.0, 1.0) <= AS_LARGE * size {
        return None;
    }
    for (unit, length_mm) in UNITS {
        let axes = vec![0, 1, 2];
        if away(length_mm, 1.0) <= IN_UNIT * size {
            let table = TestTable::Attained(String::new());
            return Some(Misplacement::Unit { table, axes, unit, length_mm });
        }
        if away(1.0, length_mm) <= IN_UNIT * size * length_mm {
            return Some(Misplacement::Unit { table: TestTable::Commanded, axes, unit, length_mm });
        }
    }
    None
}

/// Number of points of a commanded path that are compared.
const PATH_POINTS: usize = 20;
/// Maximum number of samples that are compared.
const SAMPLES: usize = 2000;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::iso9283::path::commanded::CommandedPath;
    use crate::iso9283::pose::test::{AttainedPose, TestedPose};

    const CUBE: [Vector; 5] = [
        [400.0, 0.0, 350.0],
        [500.0, 100.0, 450.0],
        [300.0, 100.0, 450.0],
        [300.0, -100.0, 250.0],
        [500.0, -100.0, 250.0],
    ];

    /// Three cycles of the poses of a cube, 0.1 mm off.
    fn cube_test(attained: impl Fn(Vector) -> Vector, commanded: impl Fn(Vector) -> Vector) -> PoseTest {
        let visit = |cycle: i64, p: Vector| AttainedPose {
            cycle,
            position_mm: p,
            angles_rad: Vec::new(),
            approach: None,
            robot: String::new(),
            readings_mm: vec![p],
            readings_rad: vec![Vec::new()],
        };
        let pose = |(i, p): (usize, &Vector)| TestedPose {
            pose: (i as i64 + 1).into(),
            commanded_mm: Some(commanded(*p)),
            commanded_rad: Vec::new(),
            attained: (1..4).map(|c| visit(c, attained([p[0] + 0.1, p[1], p[2] - 0.01 * c as f64]))).collect(),
        };
        let poses = CUBE.iter().enumerate().map(pose).collect();
        PoseTest { poses, spatial: true, angles: Vec::new(), rotation_order: None, warnings: Vec::new() }
    }

    #[test]
    fn a_unit_is_named_with_its_table_and_its_columns() {
        let same = |p: Vector| p;
        for (unit, length_mm) in UNITS {
            let small = |p: Vector| p.map(|v| v / length_mm);
            let found = misplaced_poses(&cube_test(small, same));
            let expected = |table, axes| Some(Misplacement::Unit { table, axes, unit, length_mm });
            assert_eq!(found, expected(TestTable::Attained(String::new()), vec![0, 1, 2]));
            assert_eq!(misplaced_poses(&cube_test(same, small)), expected(TestTable::Commanded, vec![0, 1, 2]));
            let one = |p: Vector| [p[0], p[1], p[2] / length_mm];
            assert_eq!(misplaced_poses(&cube_test(one, same)), expected(TestTable::Attained(String::new()), vec![2]));
            // in another frame as well
            let moved = |p: Vector| [(p[1] - 900.0) / length_mm, (-p[0] + 70.0) / length_mm, p[2] / length_mm];
            let found = misplaced_poses(&cube_test(moved, same));
            assert!(matches!(&found, Some(Misplacement::Unit { unit: u, .. }) if *u == unit), "{found:?}");
        }
    }

    /// The cube with angles (deg) of its poses, and the attained ones (deg) that `attained` makes
    /// of them.
    fn turned_test(attained: impl Fn(Vector) -> Vector) -> PoseTest {
        let commanded = [[10.0, 20.0, 30.0], [0.0, 0.0, 90.0], [5.0, 10.0, -20.0], [-10.0, 0.0, 15.0], [0.0, 5.0, 0.0]];
        let mut test = cube_test(|p| p, |p| p);
        test.angles = vec![0, 1, 2];
        for (pose, c) in test.poses.iter_mut().zip(commanded) {
            pose.commanded_rad = c.map(f64::to_radians).to_vec();
            pose.attained.iter_mut().for_each(|v| {
                let read = attained(c.map(|v| v + 0.01)).map(f64::to_radians).to_vec();
                (v.angles_rad, v.readings_rad) = (read.clone(), vec![read]);
            });
        }
        test
    }

    #[test]
    fn radians_in_columns_of_degrees_are_named_with_their_table() {
        let attained = TestTable::Attained(String::new());
        let found = misplaced_angles(&turned_test(|a| a.map(f64::to_radians)));
        assert_eq!(found, Some(Misplacement::AngleUnit { table: attained, angles: vec![0, 1, 2] }));
        let mut other = turned_test(|a| a);
        other.poses.iter_mut().for_each(|p| p.commanded_rad.iter_mut().for_each(|v| *v = v.to_radians()));
        let found = misplaced_angles(&other);
        assert_eq!(found, Some(Misplacement::AngleUnit { table: TestTable::Commanded, angles: vec![0, 1, 2] }));
    }

    #[test]
    fn exchanged_angles_are_far_and_errors_of_a_robot_are_not() {
        assert_eq!(misplaced_angles(&turned_test(|a| a)), None);
        assert_eq!(misplaced_angles(&turned_test(|a| a.map(|v| v + 2.0))), None);
        // whole turns
        assert_eq!(misplaced_angles(&turned_test(|[a, b, c]| [a + 360.0, b, c - 360.0])), None);
        let found = misplaced_angles(&turned_test(|[a, b, c]| [c, b, a])).unwrap();
        let Misplacement::Angles { angles, largest_rad, poses } = found else { panic!("{found:?}") };
        // where a and c alone cannot be told apart, they are not compared
        assert_eq!((angles, poses[0]), (vec![0, 2], 3.into()));
        assert!((largest_rad.to_degrees() - 25.01).abs() < 1e-9, "{largest_rad}");
        // angles that were not measured, and a test without commanded angles
        assert_eq!(misplaced_angles(&cube_test(|p| p, |p| p)), None);
    }

    #[test]
    fn a_frame_is_named_and_sound_tests_are_not() {
        let same = |p: Vector| p;
        assert_eq!(misplaced_poses(&cube_test(same, same)), None);
        // a robot whose lengths are 2 % too large, and one whose errors of 5 mm differ
        assert_eq!(misplaced_poses(&cube_test(|p| p.map(|v| 1.02 * v), same)), None);
        assert_eq!(misplaced_poses(&cube_test(|p| [p[0] + 0.0005 * p[1] * p[2] / 9.0, p[1] + 5.0, p[2]], same)), None);
        // a frame that is 5 mm off, a thirtieth of the extent
        let near = misplaced_poses(&cube_test(|p| [p[0] + 5.0, p[1], p[2]], same)).unwrap();
        assert!(
            matches!(near, Misplacement::Frame { turn_rad: None, shift_mm, .. } if (shift_mm[0] - 5.1).abs() < 1e-9)
        );
        let (sin, cos) = 2.0_f64.to_radians().sin_cos();
        let turned = |p: Vector| [cos * p[0] - sin * p[1], sin * p[0] + cos * p[1], p[2]];
        let near = misplaced_poses(&cube_test(turned, same)).unwrap();
        let Misplacement::Frame { turn_rad: Some(turn), .. } = near else { panic!("{near:?}") };
        assert!((turn.to_degrees() - 2.0).abs() < 0.05, "{turn}");
        let shifted = misplaced_poses(&cube_test(|p| [p[0] + 600.0, p[1], p[2] - 200.0], same)).unwrap();
        assert!(
            matches!(shifted, Misplacement::Frame { turn_rad: None, shift_mm, .. } if (shift_mm[0] - 600.1).abs() < 1e-9)
        );
        let turned = misplaced_poses(&cube_test(|p| [-p[1], p[0], p[2]], same)).unwrap();
        let Misplacement::Frame { turn_rad: Some(turn), left_mm, .. } = turned else { panic!("{turned:?}") };
        assert!((turn.to_degrees() - 90.0).abs() < 0.1 && left_mm < 0.2, "{turn} {left_mm}");
        // two poses swapped
        let exchanged = |p: Vector| {
            if p == CUBE[1] {
                CUBE[3]
            } else if p == CUBE[3] {
                CUBE[1]
            } else {
                p
            }
        };
        let found = misplaced_poses(&cube_test(same, exchanged)).unwrap();
        let Misplacement::Large { poses, .. } = found else { panic!("{found:?}") };
        assert!(poses.contains(&2.into()) && poses.contains(&4.into()), "{poses:?}");
        // repeats alone, without commanded poses
        let mut alone = cube_test(same, same);
        alone.poses.iter_mut().for_each(|p| p.commanded_mm = None);
        assert_eq!(misplaced_poses(&alone), None);
    }

    /// Poses in no plane, as a robot is tested.
    const GENERAL: [Vector; 5] = [
        [500.0, 0.0, 405.0],
        [337.0, -200.0, 280.0],
        [639.0, -200.0, 160.0],
        [810.0, 200.0, 611.0],
        [280.0, 200.0, 600.0],
    ];

    fn general_test(attained: impl Fn(Vector) -> Vector) -> PoseTest {
        let mut test = cube_test(|p| p, |p| p);
        for (pose, commanded) in test.poses.iter_mut().zip(GENERAL) {
            pose.commanded_mm = Some(commanded);
            for visit in &mut pose.attained {
                let p = attained([commanded[0] + 0.1, commanded[1], commanded[2] - 0.01 * visit.cycle as f64]);
                (visit.position_mm, visit.readings_mm) = (p, vec![p]);
            }
        }
        test
    }

    /// Change that is found if the attained positions are written with the opposite change.
    fn change(attained: impl Fn(Vector) -> Vector) -> Option<ColumnChange> {
        match misplaced_poses(&general_test(attained)) {
            Some(Misplacement::Columns { change, left_mm, deviation_mm }) => {
                assert!(left_mm < 0.11 && deviation_mm > 100.0, "{left_mm} {deviation_mm}");
                Some(change)
            }
            _ => None,
        }
    }

    #[test]
    fn exchanged_columns_are_named_and_no_frame() {
        assert_eq!(misplaced_poses(&general_test(|p| p)), None);
        assert_eq!(change(|[x, y, z]| [y, x, z]), Some(ColumnChange::Swapped([0, 1])));
        assert_eq!(change(|[x, y, z]| [x, z, y]), Some(ColumnChange::Swapped([1, 2])));
        assert_eq!(change(|[x, y, z]| [-x, y, z]), Some(ColumnChange::Sign(0)));
        assert_eq!(change(|[x, y, z]| [x, y, -z]), Some(ColumnChange::Sign(2)));
        // x is in the third column
        assert_eq!(change(|[x, y, z]| [y, z, x]), Some(ColumnChange::Order([2, 0, 1])));
        assert_eq!(change(|[x, y, z]| [z, x, y]), Some(ColumnChange::Order([1, 2, 0])));
        // rotations by half a turn and by a quarter
        for turned in [|[x, y, z]: Vector| [-x, -y, z], |[x, y, z]: Vector| [y, -x, z]] {
            let found = misplaced_poses(&general_test(turned));
            assert!(matches!(found, Some(Misplacement::Frame { turn_rad: Some(_), .. })), "{found:?}");
        }
    }

    #[test]
    fn a_motion_that_leaves_what_no_robot_leaves_is_no_cause() {
        // mirrored and moved: a rotation brings the positions near, and 50 mm remain
        let found = misplaced_poses(&general_test(|[x, y, z]| [y + 30.0, x - 40.0, z + 25.0]));
        let Some(Misplacement::Large { poses, .. }) = found else { panic!("{found:?}") };
        assert!(!poses.is_empty());
        // one pose under the name of another: the others are not named
        let found =
            misplaced_poses(&general_test(|p| if p[0] > 800.0 { [p[0] - 1000.0, p[1] - 300.0, p[2]] } else { p }));
        let Some(Misplacement::Large { poses, .. }) = found else { panic!("{found:?}") };
        assert_eq!(poses, [PoseName::from(4)]);
    }

    #[test]
    fn a_shift_of_a_path_is_seen_in_its_normal_planes() {
        let path = |corners: &[Vector]| CommandedPath::new(corners.to_vec(), &[]).unwrap().command_points(40);
        let attained = |points: &[CommandPoint], shift_mm: Vector, error_mm: f64| -> Vec<Vector> {
            let mean = |(i, p): (usize, &CommandPoint)| {
                let along = dot(shift_mm, p.tangent);
                let waves = error_mm * (i as f64).sin();
                [0, 1, 2]
                    .map(|k| p.position_mm[k] + shift_mm[k] - along * p.tangent[k] + if k == 2 { waves } else { 0.0 })
            };
            points.iter().enumerate().map(mean).collect()
        };
        let bent = path(&[[0.0, 0.0, 0.0], [300.0, 0.0, 0.0], [300.0, 200.0, 0.0]]);
        let found = misplaced_path(&bent, &attained(&bent, [8.0, -3.0, 2.0], 0.05));
        let Some(Misplacement::Frame { shift_mm, left_mm, .. }) = found else { panic!("{found:?}") };
        assert!(norm(minus(shift_mm, [8.0, -3.0, 2.0])) < 0.05 && left_mm < 0.05, "{shift_mm:?} {left_mm}");
        // a straight path shows no shift along itself
        let straight = path(&[[0.0, 0.0, 0.0], [300.0, 0.0, 0.0]]);
        let found = misplaced_path(&straight, &attained(&straight, [8.0, -3.0, 2.0], 0.05));
        let Some(Misplacement::Frame { shift_mm, .. }) = found else { panic!("{found:?}") };
        assert!(norm(minus(shift_mm, [0.0, -3.0, 2.0])) < 0.05, "{shift_mm:?}");
        // errors of a robot
        assert_eq!(misplaced_path(&bent, &attained(&bent, [0.3, 0.1, 0.0], 0.2)), None);
        assert_eq!(misplaced_path(&bent, &attained(&bent, [2.0, 1.0, 0.0], 0.2)), None);
    }
}
