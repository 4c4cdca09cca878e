//! Inverse kinematics of every robot of `init --robot` at, near and away from its singularities.

use etalon::base::noise::Noise;
use etalon::base::pose::{Pose, minus, norm};
use etalon::campaign::parse_robot;
use etalon::robots::{FiveBar, JointRange, Kinematics, Quantity, Robot};
use etalon::tasks::{known_names, known_text};
use rayon::prelude::*;
use std::path::Path;

/// Distances from a singularity (rad).
const OFF: [f64; 7] = [0.0, 1e-12, 1e-10, 1e-8, 1e-6, 1e-4, 1e-3];

fn robots() -> Vec<(String, Box<dyn Robot>)> {
    let build = |name: String| {
        let robot = parse_robot(Path::new("robot.toml"), &known_text(&name).unwrap()).unwrap();
        let built = robot.build(&["tool".to_owned()]).or_else(|_| robot.build(&[])).unwrap();
        (name, built)
    };
    // a five-bar whose margins to singularities are rounding alone
    let bare: (String, Box<dyn Robot>) = ("five-bar without margins".to_owned(), Box::<FiveBar>::default());
    known_names().unwrap().into_iter().map(build).chain([bare]).collect()
}

/// Range from which a joint value is drawn (rad or mm).
fn range(arm: &dyn Kinematics, joint: usize) -> [f64; 2] {
    let angle = arm.joints()[joint].quantity == Quantity::Angle;
    match arm.joint_range(joint) {
        JointRange::Limits([lower, upper]) if !angle => [lower.max(upper - 500.0), upper],
        JointRange::Limits([lower, upper]) => [lower.max(-3.0), upper.min(3.0)],
        _ => [-3.0, 3.0],
    }
}

fn drawn(arm: &dyn Kinematics, noise: &mut Noise) -> Vec<f64> {
    let joint = |j: usize| {
        let [lower, upper] = range(arm, j);
        0.5 * (lower + upper) + noise.uniform(0.48 * (upper - lower))
    };
    let mut q: Vec<f64> = (0..arm.joints().len()).map(joint).collect();
    q.extend(arm.has_assembly_modes().then(|| noise.uniform(1.0).signum()));
    q
}

/// Measure whose sign changes at a singularity: determinant of the numeric derivatives of position and rotation by six joints, of
/// position by two or three. `None` where the links do not meet.
fn measure(arm: &dyn Kinematics, q: &[f64]) -> Option<f64> {
    let at = |q: &[f64]| arm.tool_pose(&arm.nominal(), q);
    let (here, n) = (at(q)?, arm.joints().len());
    let column = |j: usize| {
        let mut moved = q.to_vec();
        moved[j] += 1e-6;
        let there = at(&moved)?;
        let [x, y, z] = minus(there.translation_mm, here.translation_mm).map(|v| v / 1e-3);
        let [a, b, c] = there.then(&here.inverse()).rotation_vector_rad().map(|v| v / 1e-6);
        Some([x, y, z, a, b, c])
    };
    let columns = (0..n).map(column).collect::<Option<Vec<[f64; 6]>>>()?;
    (n <= 6).then(|| nalgebra::DMatrix::from_fn(n, n, |i, j| columns[j][i]).determinant())
}

/// Joint values at which the measure is zero, or beyond which the links do not meet (type 2), by bisection along joint `j`.
fn singular(arm: &dyn Kinematics, q: &[f64], j: usize) -> Option<Vec<f64>> {
    let at = |value: f64| {
        let mut q = q.to_vec();
        q[j] = value;
        q
    };
    let [lower, upper] = range(arm, j);
    let grid: Vec<f64> = (0..=40).map(|k| lower + (upper - lower) * f64::from(k) / 40.0).collect();
    // the side of a value: the sign of the measure, 0 where the links do not meet
    let side = |value: f64| measure(arm, &at(value)).map_or(0.0, f64::signum);
    let pair = grid.windows(2).find(|pair| side(pair[0]) != 0.0 && side(pair[0]) != side(pair[1]))?;
    let (mut low, mut high, own) = (pair[0], pair[1], side(pair[0]));
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        if side(middle) == own { low = middle } else { high = middle }
    }
    Some(at(low))
}

/// Distance of joint values in rad or m.
fn distance(arm: &dyn Kinematics, a: &[f64], b: &[f64]) -> f64 {
    let scale = |j: usize| if arm.joints()[j].quantity == Quantity::Angle { 1.0 } else { 1e-3 };
    (0..arm.joints().len()).map(|j| ((a[j] - b[j]) * scale(j)).powi(2)).sum::<f64>().sqrt()
}

/// Largest difference of joint values, whatever their full turns (rad or m).
fn apart(arm: &dyn Kinematics, a: &[f64], b: &[f64]) -> f64 {
    let turns = std::f64::consts::TAU;
    let joint = |j: usize| match arm.joints()[j].quantity {
        Quantity::Angle => ((a[j] - b[j]) - ((a[j] - b[j]) / turns).round() * turns).abs(),
        _ => (a[j] - b[j]).abs() * 1e-3,
    };
    (0..arm.joints().len()).map(joint).fold(0.0, f64::max)
}

/// Requires of the answers to a pose at joint values `truth` what holds for each robot.
fn check(name: &str, arm: &dyn Kinematics, truth: &[f64], noise: &mut Noise) {
    let p = arm.nominal();
    let Some(pose) = arm.tool_pose(&p, truth) else { return };
    // the inverse of towers has carriages above the platform alone
    if arm.model() == "delta_linear" && truth.iter().any(|rho| *rho < pose.translation_mm[2]) {
        return;
    }
    if arm.limit_violation(&p, truth).is_some() {
        // what a limit forbids is not called out of reach
        if let Err(why) = arm.solutions(&p, &pose, truth) {
            assert!(why.id != "out-of-reach", "{name}: {truth:?} {why}");
        }
        return;
    }
    // the start reaches the pose
    let own = arm.nearest_joints(&p, &pose, truth).unwrap();
    assert!(distance(arm, &own, truth) < 1e-9, "{name}: {truth:?} {own:?}");
    for size in [1e-6, 1e-3, 0.02] {
        let step = |j: usize| if arm.joints()[j].quantity == Quantity::Angle { size } else { 1e3 * size };
        let mut near: Vec<f64> = (0..arm.joints().len()).map(|j| truth[j] + noise.uniform(step(j))).collect();
        near.extend(&truth[arm.joints().len()..]);
        if arm.limit_violation(&p, &near).is_some() {
            continue;
        }
        let found = arm.nearest_joints(&p, &pose, &near).unwrap_or_else(|why| panic!("{name}: {truth:?} {why}"));
        let there = arm.tool_pose(&p, &found).unwrap();
        let off = norm(minus(there.translation_mm, pose.translation_mm));
        let turned = there.inverse().then(&pose).angle_rad();
        // joint values determine a platform at a singularity to the square root of their rounding
        let permitted = if arm.model() == "serial" { 2e-6 } else { 1e-3 };
        assert!(off < permitted && turned < 2e-9, "{name}: {truth:?} {found:?}: {off} mm {turned} rad");
        let (ours, theirs) = (distance(arm, &found, &near), distance(arm, truth, &near));
        // a pose determines a double solution to the square root of its permitted error
        assert!(ours <= theirs + 2e-5, "{name}: {truth:?} from {near:?}: {found:?}, {ours} > {theirs}");
        assert_eq!(arm.limit_violation(&p, &found), None);
    }
    if arm.joints().len() > 6 {
        return;
    }
    let all = arm.solutions(&p, &pose, &vec![0.0; truth.len()]).unwrap();
    assert!(all.len() <= 32, "{name}: {truth:?}: {} solutions", all.len());
    let close = all.iter().map(|q| apart(arm, q, truth)).fold(f64::INFINITY, f64::min);
    let family = all.iter().any(|q| !arm.free_joints(&p, q).is_empty());
    assert!(close < 1e-5 || family, "{name}: {truth:?} is {close} from {all:?}");
}

#[test]
fn every_robot_answers_at_and_near_its_singularities() {
    robots().par_iter().enumerate().for_each(|(stream, (name, robot))| {
        let arm = robot.kinematics().unwrap();
        let mut noise = Noise::new(59, stream as u64);
        for _ in 0..3 {
            let q = drawn(arm, &mut noise);
            check(name, arm, &q, &mut noise);
        }
        for (k, off) in OFF.into_iter().enumerate() {
            // shoulder, elbow and wrist of an arm; the joints of others in turn
            let joints = arm.joints().len();
            let along = if joints == 6 { [1, 2, 4][k % 3] } else { k % joints };
            let Some(mut q) = singular(arm, &drawn(arm, &mut noise), along) else { continue };
            // back to where the links meet
            q[along] -= off;
            check(name, arm, &q, &mut noise);
        }
    });
}

/// Poses at which the joints of a wrist coincide: the answer is the start, a family without a start.
#[test]
fn wrists_of_every_arm_are_families() {
    robots().par_iter().for_each(|(name, robot)| {
        let arm = robot.kinematics().unwrap();
        if arm.model() != "serial" || arm.joints().len() != 6 {
            return;
        }
        let (p, mut noise) = (arm.nominal(), Noise::new(59, 99));
        let mut q = drawn(arm, &mut noise);
        q[4] = 0.0;
        let pose = arm.tool_pose(&p, &q).unwrap();
        assert_eq!(arm.nearest_joints(&p, &pose, &q).unwrap(), q, "{name}");
        assert!(arm.free_joints(&p, &q).contains(&3) && arm.free_joints(&p, &q).contains(&5), "{name}");
        let all = arm.solutions(&p, &pose, &q).unwrap();
        assert!(all.iter().any(|found| apart(arm, found, &q) < 1e-6), "{name}: {q:?} {all:?}");
    });
}

/// Poses made from joint values within the limits, each solved from the solution before.
#[test]
fn poses_of_a_redundant_arm_within_its_limits_are_solved() {
    let text = "name = \"mobile\"\nmodel = \"serial\"\nconvention = \"poe\"\nflange_xyz_mm = [374.0, 0.0, 930.0]\n\
                flange_rpy_deg = [0.0, 90.0, 0.0]\njoint = [\n\
                { direction = [1.0, 0.0, 0.0], point_mm = [0.0, 0.0, 0.0], prismatic = true },\n\
                { direction = [0.0, 1.0, 0.0], point_mm = [0.0, 0.0, 0.0], prismatic = true },\n\
                { direction = [0.0, 0.0, 1.0], point_mm = [0.0, 0.0, 0.0] },\n\
                { direction = [0.0, 0.0, 1.0], point_mm = [0.0, 0.0, 300.0] },\n\
                { direction = [0.0, 1.0, 0.0], point_mm = [0.0, 0.0, 590.0], limits_deg = [-110.0, 110.0] },\n\
                { direction = [0.0, 1.0, 0.0], point_mm = [0.0, 0.0, 860.0], limits_deg = [-110.0, 70.0] },\n\
                { direction = [1.0, 0.0, 0.0], point_mm = [302.0, 0.0, 930.0], limits_deg = [-160.0, 160.0] },\n\
                { direction = [0.0, 1.0, 0.0], point_mm = [302.0, 0.0, 930.0], limits_deg = [-120.0, 120.0] },\n\
                { direction = [1.0, 0.0, 0.0], point_mm = [374.0, 0.0, 930.0] },\n]\n";
    let mobile = parse_robot(Path::new("robot.toml"), text).unwrap().build(&["tool".to_owned()]).unwrap();
    let panda = robots().into_iter().find(|(name, _)| name == "panda").unwrap();
    [panda, ("mobile".to_owned(), mobile)].par_iter().for_each(|(name, robot)| {
        let arm = robot.kinematics().unwrap();
        let (p, mut noise, mut last) = (arm.nominal(), Noise::new(59, 7), vec![0.0; arm.joints().len()]);
        for k in 0..60 {
            let mut q = drawn(arm, &mut noise);
            if arm.joints()[0].quantity == Quantity::Length {
                (0..2).for_each(|j| q[j] = noise.uniform(3000.0));
            }
            let pose = arm.tool_pose(&p, &q).unwrap();
            last = arm.nearest_joints(&p, &pose, &last).unwrap_or_else(|why| panic!("{name}: pose {k} {q:?}: {why}"));
            assert_eq!(arm.limit_violation(&p, &last), None, "{name}");
            assert!(same(&arm.tool_pose(&p, &last).unwrap(), &pose), "{name}: pose {k}");
        }
    });
}

fn same(a: &Pose, b: &Pose) -> bool {
    norm(minus(a.translation_mm, b.translation_mm)) < 2e-6 && a.inverse().then(b).angle_rad() < 2e-9
}

/// A tool on the axis of a motor, and stretched arms: a margin forbids them, they are not out of reach.
#[test]
fn singular_poses_of_a_five_bar_are_named() {
    let robot = etalon::robots::FiveBar::default();
    let arm = robot.kinematics().unwrap();
    let p = arm.nominal();
    let at = |x: f64, y: f64| Pose { translation_mm: [x, y, 0.0], ..Pose::identity() };
    // the tool on motor 2: arm 2 is folded (type 1)
    assert_eq!(arm.solutions(&p, &at(137.5, 0.0), &[0.0; 3]).unwrap_err().id, "singularity-near");
    // the tool 460 mm away from it: arm 2 is stretched, whatever the rounding
    for k in 0..50 {
        let (sin, cos) = (2.1 + 0.01 * f64::from(k)).sin_cos();
        let why = arm.solutions(&p, &at(137.5 + 460.0 * cos, 460.0 * sin), &[0.0; 3]).unwrap_err();
        assert_eq!(why.id, "singularity-near", "{k}: {why}");
    }
    let why = arm.solutions(&p, &at(137.5, 461.0), &[0.0; 3]).unwrap_err();
    assert_eq!(why.id, "out-of-reach");
}
