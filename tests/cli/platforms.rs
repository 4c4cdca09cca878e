//! Hexapod and delta on the command line: their samples, plans of their poses, and what is wrong with them.

use super::{etalon, text_of};
use crate::support::scratch::{Scratch, copy_sample, ends};
use etalon::campaign::read_robot;
use etalon::documents::PlanDocument;
use std::fmt::Write;

const SAMPLES: [&str; 2] = ["hexapod", "delta"];

/// The table of joint values of a sample under the names of its robot's joints, one row for each of three targets.
fn candidates(scratch: &Scratch, poses: usize) -> String {
    let robot = read_robot(&scratch.path().join("robot.toml")).unwrap().build(&["a".to_owned()]).unwrap();
    let columns: Vec<String> = robot.joints().iter().map(etalon::robots::Joint::column).collect();
    let mut csv = format!("pose,target,{}\n", columns.join(","));
    let log = std::fs::read_to_string(scratch.path().join("encoders.csv")).unwrap();
    let mut rows = log.lines().map(|line| line.split(',').collect::<Vec<&str>>());
    let header = rows.next().unwrap();
    let joints: Vec<usize> = (0..header.len()).filter(|&i| header[i].len() == 2).collect();
    for (pose, row) in rows.take(poses).enumerate() {
        for target in ["a", "b", "c"] {
            let values: Vec<&str> = joints.iter().map(|&i| row[i]).collect();
            let _ = writeln!(csv, "{},{target},{}", pose + 1, values.join(","));
        }
    }
    csv
}

#[test]
fn samples_of_platforms_are_calibrated() {
    for name in SAMPLES {
        let scratch = copy_sample(name);
        let before: Vec<u8> = std::fs::read(scratch.path().join("exports/poses.txt")).unwrap();
        ends(&scratch, "simulate", 0, &[]);
        assert_eq!(std::fs::read(scratch.path().join("exports/poses.txt")).unwrap(), before, "{name}");
        ends(&scratch, "run", 0, &[]);
        let read = |file: &str| -> serde_json::Value { scratch.document(file) };
        let parameters = read("parameters.json");
        let held = parameters["parameters"].as_array().unwrap().iter();
        assert_eq!(held.filter(|p| p["status"] == "not_identifiable").count(), 12, "{name}");
        // residuals agree with the stated noise, and fresh poses are predicted as well
        let chi_square = &parameters["residuals"]["chi_square"].as_f64().unwrap();
        let degrees = parameters["residuals"]["degrees_of_freedom"].as_f64().unwrap();
        assert!((chi_square / degrees - 1.0).abs() < 0.25, "{name}: {chi_square} of {degrees}");
    }
}

#[test]
fn poses_of_platforms_are_planned() {
    for (name, legs) in SAMPLES.into_iter().zip(["leg", "_"]) {
        let scratch = copy_sample(name);
        let folder = scratch.path();
        std::fs::write(folder.join("c.csv"), candidates(&scratch, 30)).unwrap();
        let arguments = ["--candidates", "c.csv", "--positions", "20", "--nodes", "0", "--starts", "1", "--json"];
        let answered = etalon(&folder, &[&["plan", "--robot", "robot.toml"], &arguments[..]].concat());
        assert!(answered.status.success(), "{}", text_of(&answered));
        let found: PlanDocument = serde_json::from_slice(&answered.stdout).unwrap();
        assert_eq!(found.choice.chosen.len(), 20);
        let held: Vec<&str> =
            found.prediction.parameters.iter().filter(|p| !p.identifiable).map(|p| p.name.as_str()).collect();
        assert!(held.len() == 12 && held.iter().any(|name| name.contains(legs)), "{name}: {held:?}");
        assert!(
            found.optimality.value >= found.optimality.greedy.value
                && found.optimality.at_most_below_percent.unwrap() < 20.0,
            "{name}"
        );
    }
}

/// A slip of the log is refused by name.
fn slip_is_refused(name: &str, [from, to]: [&str; 2], says: &str) {
    let scratch = copy_sample(name);
    scratch.replace("campaign.toml", from, to);
    let said = ends(&scratch, "run", 2, &[says]);
    assert!(!scratch.path().join("out").exists(), "{name} {to}: {said}");
}

#[test]
fn a_leg_in_metres_is_refused() {
    let slip = ["leg2_mm = \"L2\"", "leg2_m = \"L2\""];
    slip_is_refused("hexapod", slip, "all values are in range in millimetres instead of metres");
}

/// Of a delta whose arms are alike any two exchanged are the same as any others.
#[test]
fn exchanged_arms_are_refused() {
    let slip = ["theta1_deg = \"J1\"\ntheta2_deg = \"J2\"", "theta1_deg = \"J2\"\ntheta2_deg = \"J1\""];
    slip_is_refused("delta", slip, " swapped");
}

#[test]
fn wrong_platforms_are_refused() {
    for (name, [from, to], says) in [
        ("hexapod", ["    { base_mm", "    # { base_mm"], "[leg-count]"),
        ("hexapod", ["home_xyz_mm = [0.0, 0.0, 400.0]", "home_xyz_mm = [0.0, 0.0, 0.0]"], "[hexapod-singular]"),
        ("hexapod", ["home_xyz_mm", "# home_xyz_mm"], "[key-missing]"),
        ("hexapod", ["leg = [", "rod_mm = 800.0\nleg = ["], "[key-of-other-model]"),
        ("delta", ["rod_mm = 800.0", "rod_mm = -800.0"], "[key-not-positive]"),
        ("delta", ["upper_arm_mm", "# upper_arm_mm"], "[key-missing]"),
        ("delta", ["model = \"delta\"", "model = \"delta_linear\""], "[key-of-other-model]"),
    ] {
        let scratch = copy_sample(name);
        let file = scratch.path().join("robot.toml");
        let text = std::fs::read_to_string(&file).unwrap();
        assert!(text.contains(from), "{from}");
        std::fs::write(&file, text.replace(from, to)).unwrap();
        ends(&scratch, "check", 2, &[says]);
    }
}
