//! `etalon robot convert`: an arm in another convention moves alike, and what is lost is said.

use super::{etalon, text};
use crate::support::root;
use etalon::base::noise::Noise;
use etalon::base::pose::{Pose, minus, norm};
use etalon::campaign::read_robot;
use std::path::{Path, PathBuf};

fn sample(name: &str) -> PathBuf {
    root().join("samples").join(name).join("robot.toml")
}

/// Pose of the flange at joint values.
fn pose(robot: &Path, joints: &[f64]) -> Pose {
    let robot = read_robot(robot).unwrap().build(&["tool".to_owned()]).unwrap();
    robot.kinematics().unwrap().tool_pose(&robot.nominal(), joints).unwrap()
}

/// Converts a robot file into `folder` and returns the new robot file and what was said.
fn converted(folder: &Path, robot: &Path, to: &str) -> (PathBuf, String) {
    let output = etalon(folder, &["robot", "convert", robot.to_str().unwrap(), "--to", to]);
    let said = text(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{said}");
    let path = folder.join(format!("{to}.toml"));
    if to == "urdf" {
        std::fs::write(folder.join("arm.urdf"), &output.stdout).unwrap();
        let file = "model = \"urdf\"\nfile = \"arm.urdf\"\nbase_link = \"base_link\"\ntool_link = \"tool\"\n";
        std::fs::write(&path, file).unwrap();
    } else {
        std::fs::write(&path, &output.stdout).unwrap();
    }
    (path, said)
}

#[test]
fn a_converted_arm_moves_alike() {
    let folder = tempfile::tempdir().unwrap();
    // screw axes whose base and flange a modified table holds too
    let screws = sample("probe-poses");
    let mut noise = Noise::new(3, 0);
    for to in ["poe", "mdh", "urdf"] {
        let (path, said) = converted(folder.path(), &screws, to);
        assert!(to == "mdh" || said.is_empty(), "{said}");
        for _ in 0..20 {
            let q: Vec<f64> = (0..6).map(|_| noise.uniform(2.0)).collect();
            let (one, two) = (pose(&screws, &q), pose(&path, &q));
            let moved = one.inverse().then(&two);
            let off = norm(minus(two.translation_mm, one.translation_mm)).max(1000.0 * moved.angle_rad());
            assert!(off < 1e-6 || to == "mdh" && said.contains("not-held"), "{to}: {off}, {said}");
        }
        // and back
        let (back, _) = converted(folder.path(), &path, "poe");
        let q = [0.3, -0.5, 0.7, 1.1, -0.2, 0.9];
        let off = norm(minus(pose(&back, &q).translation_mm, pose(&path, &q).translation_mm));
        assert!(off < 1e-6, "{to}: {off}");
    }
}

#[test]
fn what_a_convention_cannot_hold_is_said() {
    let folder = tempfile::tempdir().unwrap();
    let file = "model = \"serial\"\nconvention = \"poe\"\nbending = [1]\nflange_xyz_mm = [700, 30, 50]\n\
                flange_rpy_deg = [10, 20, 30]\njoint = [\n  { direction = [0, 0, 1], point_mm = [100, 0, 0] },\n  \
                { direction = [0.001, 0, 1], point_mm = [400, 0, 0] },\n]\n";
    let robot = folder.path().join("robot.toml");
    std::fs::write(&robot, file).unwrap();
    let (_, said) = converted(folder.path(), &robot, "mdh");
    for id in ["table-flange-not-held", "convert-left-out"] {
        assert!(said.contains(&format!("warning[{id}]")), "{id}: {said}");
    }
    let output = etalon(folder.path(), &["robot", "convert", sample("prexyt-cmm").to_str().unwrap(), "--to", "poe"]);
    let said = text(&output.stderr);
    assert!(output.status.code() == Some(2) && said.contains("error[convert-no-chain]"), "{said}");
}

/// A constant frame in a comment of a converted table; identity without the comment.
fn stated(text: &str, name: &str) -> Pose {
    let Some(line) = text.lines().find(|line| line.starts_with(&format!("# {name} in the "))) else {
        return Pose::identity();
    };
    let v: Vec<f64> = line.split([' ', ',']).filter_map(|v| v.parse().ok()).collect();
    Pose::from_xyz_rpy([v[0], v[1], v[2]], [v[3], v[4], v[5]].map(f64::to_radians))
}

/// Largest difference (mm; rad on a metre) of a converted arm from its original at joint values, apart from the frames that it states.
fn off(original: &Path, converted: &Path, noise: &mut Noise, size: f64) -> f64 {
    let text = std::fs::read_to_string(converted).unwrap();
    let base = stated(&text, "base of the table");
    let flange = stated(&text, "flange of the robot");
    let differ = |_| {
        let q: Vec<f64> = (0..6).map(|_| noise.uniform(size)).collect();
        let (one, two) = (pose(original, &q), base.then(&pose(converted, &q)).then(&flange));
        norm(minus(one.translation_mm, two.translation_mm)).max(1000.0 * one.inverse().then(&two).angle_rad())
    };
    (0..5).map(differ).fold(0.0, f64::max)
}

/// A drawn table of six rows; some axes meet, some are parallel or nearly so.
fn table(convention: &str, seed: u64) -> String {
    let mut noise = Noise::new(59, seed);
    let mut text = format!("name = \"R\"\nmodel = \"serial\"\nconvention = \"{convention}\"\n");
    for i in 0..6 {
        let alpha = match i % 3 {
            0 => 90.0 + noise.uniform(0.2),
            1 => noise.uniform(if seed.is_multiple_of(2) { 0.05 } else { 0.0 }),
            _ => noise.uniform(150.0),
        };
        let a = if i % 3 == 1 || noise.uniform(1.0) > 0.0 { 300.0 + noise.uniform(150.0) } else { 0.0 };
        let [theta, d] = [noise.uniform(180.0), noise.uniform(300.0)];
        text += &format!("[[joint]]\nalpha_deg = {alpha:?}\na_mm = {a:?}\ntheta_deg = {theta:?}\nd_mm = {d:?}\n");
    }
    text
}

#[test]
fn every_pair_of_conventions_moves_alike_apart_from_the_frames_that_are_stated() {
    for seed in 0..8 {
        let folder = tempfile::tempdir().unwrap();
        let mut noise = Noise::new(60, seed);
        let robot = folder.path().join("robot.toml");
        std::fs::write(&robot, table(if seed % 4 < 2 { "dh" } else { "mdh" }, seed)).unwrap();
        for from in ["poe", "mdh", "dh", "urdf"] {
            let one = folder.path().join(from);
            std::fs::create_dir(&one).unwrap();
            let (first, _) = converted(&one, &robot, from);
            assert!(off(&robot, &first, &mut noise, 3.0) < 1e-5, "{seed} {from}");
            for to in ["poe", "mdh", "dh", "urdf"] {
                let two = one.join(to);
                std::fs::create_dir(&two).unwrap();
                let (second, said) = converted(&two, &first, to);
                assert!(off(&first, &second, &mut noise, 3.0) < 1e-5, "{seed} {from} {to}");
                // what a table states as a comment, it says
                let text = std::fs::read_to_string(&second).unwrap();
                let moved = stated(&text, "flange of the robot") != Pose::identity();
                assert_eq!(moved, said.contains("table-flange-not-held"), "{said}");
                assert!(!said.contains("table-tilt-not-held"), "{said}");
            }
        }
    }
}

/// Calibrated parameters of near-parallel axes: link offsets of 574 m that cancel each other.
const FAR: &str = "name = \"R\"\nmodel = \"serial\"\nconvention = \"dh\"\njoint = [\n\
    { alpha_rad = 1.5703, a_mm = 0.28, theta_rad = -9.6e-06, d_mm = 88.88 },\n\
    { alpha_rad = -0.00073389, a_mm = -56.69, theta_rad = -1.4371, d_mm = 574241.38 },\n\
    { alpha_rad = 0.0032561, a_mm = -326.467, theta_rad = 2.02543, d_mm = -507363.4 },\n\
    { alpha_rad = 1.5704, a_mm = 0.0149, theta_rad = -0.58825, d_mm = -66767.68 },\n\
    { alpha_rad = -1.57101, a_mm = 0.000224, theta_rad = 4.1e-05, d_mm = 94.97 },\n\
    { alpha_rad = 0.0, a_mm = 0.0, theta_rad = 8.2e-06, d_mm = 82.56 },\n]\n";

#[test]
fn a_calibrated_arm_with_far_origins_is_written_near_the_arm() {
    let folder = tempfile::tempdir().unwrap();
    let robot = folder.path().join("robot.toml");
    std::fs::write(&robot, FAR).unwrap();
    let mut noise = Noise::new(61, 0);
    for to in ["poe", "mdh", "dh", "urdf"] {
        let (path, said) = converted(folder.path(), &robot, to);
        assert!(said.is_empty(), "{to}: {said}");
        // lengths of 574 m leave ten digits
        assert!(off(&robot, &path, &mut noise, 3.0) < 1e-5, "{to}");
        let text = std::fs::read_to_string(if to == "urdf" { folder.path().join("arm.urdf") } else { path }).unwrap();
        let numbers = text.split(|c: char| !(c.is_ascii_digit() || ".-".contains(c))).filter_map(|v| v.parse().ok());
        let largest = numbers.fold(0.0, |most: f64, v: f64| most.max(v.abs()));
        assert!(largest < 1000.0, "{to}: {largest}, {text}");
    }
}

/// DH parameters of a UR5 (Universal Robots): a table of the maker's own convention is itself, the flange included.
#[test]
fn a_table_of_a_maker_keeps_its_flange() {
    let folder = tempfile::tempdir().unwrap();
    let robot = folder.path().join("robot.toml");
    let rows = [
        [90.0, 0.0, 0.0, 89.159],
        [0.0, -425.0, 0.0, 0.0],
        [0.0, -392.25, 0.0, 0.0],
        [90.0, 0.0, 0.0, 109.15],
        [-90.0, 0.0, 0.0, 94.65],
        [0.0, 0.0, 0.0, 82.3],
    ];
    let row = |[alpha, a, theta, d]: [f64; 4]| {
        format!("[[joint]]\nalpha_deg = {alpha:?}\na_mm = {a:?}\ntheta_deg = {theta:?}\nd_mm = {d:?}\n")
    };
    let text = "model = \"serial\"\nconvention = \"dh\"\n".to_owned() + &rows.map(row).concat();
    std::fs::write(&robot, text).unwrap();
    for to in ["poe", "dh", "urdf"] {
        let (path, said) = converted(folder.path(), &robot, to);
        assert!(said.is_empty(), "{to}: {said}");
        assert!(off(&robot, &path, &mut Noise::new(62, 0), 3.0) < 1e-6, "{to}");
        let (back, said) = converted(folder.path(), &path, "dh");
        assert!(said.is_empty() && std::fs::read_to_string(&back).unwrap().contains("d_mm = 82.3 }"), "{to}: {said}");
    }
}
