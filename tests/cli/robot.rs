//! `etalon robot convert`: an arm in another convention moves alike, and what is lost is said.

use super::{etalon, text};
use etalon::base::noise::Noise;
use etalon::base::pose::{Pose, minus, norm};
use etalon::campaign::read_robot;
use std::path::{Path, PathBuf};

fn sample(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("samples").join(name).join("robot.toml")
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
    for id in ["table-flange-not-held", "table-tilt-not-held", "convert-left-out"] {
        assert!(said.contains(&format!("warning[{id}]")), "{id}: {said}");
    }
    let output = etalon(folder.path(), &["robot", "convert", sample("prexyt-cmm").to_str().unwrap(), "--to", "poe"]);
    let said = text(&output.stderr);
    assert!(output.status.code() == Some(2) && said.contains("error[convert-no-chain]"), "{said}");
}
