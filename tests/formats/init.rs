//! `etalon init --from`: a stranger's files become a campaign that runs, after the questions that `check` lists.

use super::program;
use super::recordings::{Cdr, JOINTS, recording};
use crate::support::root;
use crate::support::said::Says;
use etalon::base::noise::Noise;
use etalon::base::pose::Pose;
use etalon::documents::ParametersDocument;
use std::fmt::Write;
use std::path::Path;

/// Joint values (rad), the place of a reflector and the orientation of its body of a UR5e with small errors.
pub(super) fn measured(at: &Path, count: usize) -> Vec<(Vec<f64>, [f64; 3], [f64; 4])> {
    assert_eq!(program(at, &["init", "nominal", "--robot", "ur5e"]).0, Some(0));
    let names = ["o", "a", "b", "c"].map(str::to_owned);
    let arm = etalon::campaign::read_robot(&at.join("nominal/robot.toml")).unwrap().build(&names).unwrap();
    let mut values = arm.nominal();
    for (p, value) in arm.parameters().iter().zip(&mut values) {
        *value += match p.name.as_str() {
            "base_x" => 1800.0,
            "base_rz" => 0.4,
            "d_4" => 0.4,
            "theta_3" => 0.003,
            "a_x" | "b_y" | "c_z" => 100.0,
            _ => 0.0,
        };
    }
    let mut noise = Noise::new(23, 1);
    let mut one = || {
        let q: Vec<f64> = (0..6).map(|_| noise.uniform(1.4)).collect();
        let [o, a, b, c] = [0, 1, 2, 3].map(|k| arm.position(&values, &q, k));
        let axis = |p: [f64; 3]| [0, 1, 2].map(|i| (p[i] - o[i]) / 100.0);
        let [x, y, z] = [a, b, c].map(axis);
        let rotation = [0, 1, 2].map(|i| [x[i], y[i], z[i]]);
        let place = c.map(|v| v + noise.gaussian(0.01));
        (q, place, Pose { rotation, ..Pose::identity() }.quaternion())
    };
    (0..count).map(|_| one()).collect()
}

/// Answers what `check` asks until it has nothing left to ask; gives the keys that it asked for.
pub(super) fn answer(at: &Path, answers: &[(&str, &str)]) -> Vec<String> {
    let mut asked = Vec::new();
    for _ in 0..20 {
        let (code, said) = program(at, &["check", "mine"]);
        if code == Some(0) {
            return asked;
        }
        let path = at.join("mine/campaign.toml");
        let text = std::fs::read_to_string(&path).unwrap();
        let stated = |line: &str| !line.starts_with('#') && (line.contains("= \"?\"") || line.contains("_UNIT ="));
        let open = text.lines().filter(|line| stated(line)).count();
        assert!(open > 0 && said.matches("-open]").count() == open, "all questions at once: {said}");
        assert_eq!(said.matches("error[").count(), open, "{said}");
        let number = said.split("campaign.toml:").nth(1).unwrap();
        let number: usize = number.split(|c: char| !c.is_ascii_digit()).next().unwrap().parse().unwrap();
        let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
        let line = &mut lines[number - 1];
        let key = if line.contains("_UNIT") { "UNIT" } else { line.split('=').next().unwrap().trim() }.to_owned();
        let (_, value) = answers.iter().find(|(of, _)| *of == key).unwrap_or_else(|| panic!("{key}: {said}"));
        *line = line.replace("_UNIT", &format!("_{value}")).replacen("\"?\"", value, 1);
        asked.push(key);
        std::fs::write(path, lines.join("\n") + "\n").unwrap();
    }
    panic!("the questions have no end: {asked:?}");
}

pub(super) fn found(at: &Path) -> ParametersDocument {
    let (code, said) = program(at, &["run", "mine"]);
    assert_eq!(code, Some(0), "{said}");
    crate::support::document(&at.join("mine/out/parameters.json"))
}

/// Values of the true errors, within what a calibration of forty poses determines.
pub(super) fn is_calibrated(document: &ParametersDocument) {
    let value = |name: &str| document.parameters.iter().find(|p| p.name == name).map(|p| p.value - p.nominal).unwrap();
    assert!((value("d_4") - 0.4).abs() < 0.1, "{}", value("d_4"));
    assert!(document.residuals.rms < 0.03, "{}", document.residuals.rms);
}

#[test]
fn one_semicolon_file_with_joints_is_a_campaign() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let mut text = "Pose;J1 [deg];J2 [deg];J3 [deg];J4 [deg];J5 [deg];J6 [deg];X [mm];Y [mm];Z [mm]\n".to_owned();
    for (i, (q, p, _)) in (1..).zip(measured(at, 60)) {
        let cells: Vec<String> =
            q.iter().map(|v| v.to_degrees()).chain(p).map(|v| format!("{v:.5}").replace('.', ",")).collect();
        let _ = writeln!(text, "{i};{}", cells.join(";"));
    }
    std::fs::write(at.join("messung.csv"), text).unwrap();
    let (code, said) = program(at, &["init", "mine", "--robot", "ur5e", "--from", "messung.csv"]);
    assert_eq!(code, Some(0), "{said}");
    // the file states its units: the instrument alone is asked for
    assert_eq!(
        answer(at, &[("name", "\"tracker\""), ("expanded_uncertainty_um", "20")]),
        ["name", "expanded_uncertainty_um"]
    );
    is_calibrated(&found(at));
}

/// Headings of the quaternion in a mixed spelling; rows without an uncertainty are one message.
#[test]
fn a_quaternion_under_any_headings_is_read_with_the_joints() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let joints = (1..=6).map(|k| format!("Achse {k} [°]")).collect::<Vec<_>>().join(";");
    let mut text = format!("Messpunkt;{joints};X-Ist [mm];Y-Ist [mm];Z-Ist [mm];Q0;Qx;Qy;Qz;Güte;Bemerkung\n");
    for (i, (q, p, o)) in (1..).zip(measured(at, 60)) {
        let cells = q.iter().map(|v| v.to_degrees()).chain(p).chain(o).chain([0.5 + f64::from(i % 7)]);
        let cells: Vec<String> = cells.map(|v| format!("{v:.6}").replace('.', ",")).collect();
        let _ = writeln!(text, "{i};{};", cells.join(";"));
    }
    std::fs::write(at.join("messung.csv"), text).unwrap();
    let (code, said) = program(at, &["init", "mine", "--robot", "ur5e", "--from", "messung.csv"]);
    assert_eq!(code, Some(0), "{said}");
    let path = at.join("mine/campaign.toml");
    let proposed = std::fs::read_to_string(&path).unwrap();
    assert!(!proposed.contains("commanded"), "{proposed}");
    assert!(proposed.contains("qw") && proposed.has_phrase("doubt-columns-not-read columns=15 `Güte`"), "{proposed}");
    let answers =
        [("name", "\"tracker\""), ("expanded_uncertainty_um", "20"), ("expanded_rotation_uncertainty_deg", "0.01")];
    let asked = answer(at, &answers);
    assert_eq!(asked, ["name", "expanded_uncertainty_um", "expanded_rotation_uncertainty_deg"]);
    is_calibrated(&found(at));

    let complete = std::fs::read_to_string(&path).unwrap();
    let without: Vec<&str> = complete.lines().filter(|l| !l.starts_with("expanded_rotation_uncertainty_deg")).collect();
    std::fs::write(&path, without.join("\n")).unwrap();
    let (code, said) = program(at, &["check", "mine", "--json"]);
    assert_eq!(code, Some(2), "{said}");
    let document: serde_json::Value = serde_json::from_str(&said).unwrap();
    let errors = document["errors"].as_array().unwrap();
    assert_eq!(errors.len(), 1, "{said}");
    assert_eq!(errors[0]["id"], "uncertainty-missing");
    assert_eq!(errors[0]["arguments"]["count"], 60);
    assert_eq!(errors[0]["arguments"]["rows"].as_array().map(Vec::len), Some(3), "{said}");
    assert!(errors[0]["hint"].as_str().unwrap().starts_with("set `expanded_rotation_uncertainty_deg` in [instrument]"));
}

#[test]
fn a_log_and_an_export_of_six_degrees_of_freedom_are_a_campaign() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let mut log = "t,joint_2,joint_1,joint_3,joint_4,joint_5,joint_6\n".to_owned();
    let mut export = "X  [mm],Y  [mm],Z  [mm],U(95) X  [mm],U(95) Y  [mm],U(95) Z  [mm],Q0 ,Q1 ,Q2 ,Q3\n".to_owned();
    for (i, (q, p, o)) in (0..).zip(measured(at, 60)) {
        let _ = writeln!(log, "{},{},{},{},{},{},{}", 5 * i, q[1], q[0], q[2], q[3], q[4], q[5]);
        let cells: Vec<String> = p.iter().chain(&[0.02; 3]).chain(&o).map(f64::to_string).collect();
        let _ = writeln!(export, "{}", cells.join(","));
    }
    std::fs::write(at.join("joints.csv"), log).unwrap();
    std::fs::write(at.join("probe.csv"), export).unwrap();
    let (code, said) = program(at, &["init", "mine", "--robot", "ur5e", "--from", "joints.csv", "probe.csv"]);
    assert_eq!(code, Some(0), "{said}");
    let answers =
        [("name", "\"tracker\""), ("expanded_uncertainty_um", "20"), ("expanded_rotation_uncertainty_deg", "0.01")];
    // the unit of the joints follows from the kinematics of the nominal robot
    let asked = answer(at, &answers);
    assert_eq!(asked.len(), 3, "{asked:?}");
    is_calibrated(&found(at));
}

/// Points of an instrument are named in a group of its own, the rows of the log without it; two
/// poses were not measured, and the points are in another order.
#[test]
fn names_of_poses_join_an_export_of_spatialanalyzer_and_a_log() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let mut log = "Point;J1;J2;J3;J4;J5;J6\n".to_owned();
    let mut rows = Vec::new();
    for (i, (q, p, _)) in (1..).zip(measured(at, 60)) {
        let cells: Vec<String> = q.iter().map(|v| format!("{:.3}", v.to_degrees()).replace('.', ",")).collect();
        let _ = writeln!(log, "P{i:03};{}", cells.join(";"));
        rows.push(format!("A::P{i:03}, {:.4}, {:.4}, {:.4}\n", p[0], p[1], p[2]));
    }
    rows.remove(29);
    rows.remove(6);
    rows.reverse();
    std::fs::write(at.join("log.csv"), log).unwrap();
    let write = |unit: &str, name: &str| {
        std::fs::write(at.join(name), format!("// SpatialAnalyzer\n// Units: {unit}\n{}", rows.concat())).unwrap();
    };
    write("mm", "points.txt");
    let (code, said) = program(at, &["init", "mine", "--robot", "ur5e", "--from", "points.txt", "log.csv"]);
    assert_eq!(code, Some(0), "{said}");
    let answers = [("name", "\"tracker\""), ("expanded_uncertainty_um", "20")];
    assert_eq!(answer(at, &answers).len(), 2);
    let text = std::fs::read_to_string(at.join("mine/campaign.toml")).unwrap();
    assert!(text.contains("label = \"A::{pose}\"") && text.contains("pose = \"Point\""), "{text}");
    assert!(!text.contains("thousands mark"), "{text}");
    is_calibrated(&found(at));
    // the file states another unit than the campaign
    write("inches", "mine/points.txt");
    let (code, said) = program(at, &["check", "mine", "--json"]);
    assert_eq!(code, Some(2), "{said}");
    let document: serde_json::Value = serde_json::from_str(&said).unwrap();
    assert_eq!(document["errors"][0]["id"], "unit-differs", "{said}");
}

#[test]
fn labels_and_poses_join_an_export_and_a_log() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let (mut log, mut export) = ("pose;J1;J2;J3;J4;J5;J6\n".to_owned(), "Name,X,Y,Z\n".to_owned());
    for (i, (q, p, _)) in (1..).zip(measured(at, 60)) {
        let cells: Vec<String> = q.iter().map(|v| format!("{:.5}", v.to_degrees())).collect();
        let _ = writeln!(log, "{i};{}", cells.join(";"));
        let _ = writeln!(export, "SMR-{i},{:.4},{:.4},{:.4}", p[0], p[1], p[2]);
    }
    std::fs::write(at.join("log.csv"), log).unwrap();
    std::fs::write(at.join("points.csv"), export).unwrap();
    let (code, said) = program(at, &["init", "mine", "--robot", "ur5e", "--from", "points.csv", "log.csv"]);
    assert_eq!(code, Some(0), "{said}");
    // units follow from the kinematics of the nominal robot
    let answers = [("name", "\"tracker\""), ("expanded_uncertainty_um", "20")];
    assert_eq!(answer(at, &answers).len(), 2);
    let text = std::fs::read_to_string(at.join("mine/campaign.toml")).unwrap();
    assert!(text.contains("label = \"{target}-{pose}\"") && text.contains("by = [\"pose\"]"), "{text}");
    assert!(!text.contains("UNIT deg, rad"), "{text}");
    is_calibrated(&found(at));
    // a file of which nothing is known, and a folder that is there
    std::fs::write(at.join("notes.txt"), "no numbers here\n").unwrap();
    let (code, said) = program(at, &["init", "other", "--robot", "ur5e", "--from", "notes.txt"]);
    assert!(code == Some(2) && !at.join("other").exists(), "{said}");
    let (code, said) = program(at, &["init", "mine", "--robot", "ur5e", "--from", "points.csv"]);
    assert!(code == Some(2) && said.contains("error[file-exists]"), "{said}");
}

/// Writes `arm.urdf`, `run.mcap`, a recording of the joints in motion, and `tracker.csv`, points with the times of another
/// clock in the format of `stamp`; gives the parameters of the arm. All data are synthetic.
fn record(at: &Path, targets: &[&str], stamp: &dyn Fn(f64) -> String) -> Vec<(String, f64)> {
    record_rows(at, targets, stamp, (5, &|pose| 8 + (pose * 7) % 5))
}

/// Writes the files of [`record`] with this number of messages between two poses, and at each pose.
fn record_rows(
    at: &Path,
    targets: &[&str],
    stamp: &dyn Fn(f64) -> String,
    (moves, stands): (i32, &dyn Fn(i32) -> i32),
) -> Vec<(String, f64)> {
    let names = ["elbow", "pan", "shoulder", "wrist_1", "wrist_2", "wrist_3"];
    let mut urdf = "<robot name=\"arm\"><link name=\"root\"/>\n".to_owned();
    let origins = [
        ("0 0 0.3", "0 0 0"),
        ("0.1 0 0.1", "-1.57 0 0"),
        ("0.45 0 0", "0 0 0"),
        ("0.4 0 0.1", "0 0 0"),
        ("0 0.1 0", "1.57 0 0"),
        ("0 0 0.1", "-1.57 0 0"),
    ];
    let order = ["pan", "shoulder", "elbow", "wrist_1", "wrist_2", "wrist_3"];
    for (k, (xyz, rpy)) in origins.iter().enumerate() {
        let parent = if k == 0 { "root".to_owned() } else { format!("l{k}") };
        let _ = writeln!(
            urdf,
            "<link name=\"l{0}\"/><joint name=\"{1}\" type=\"revolute\"><parent link=\"{parent}\"/><child link=\"l{0}\"/>\
             <origin xyz=\"{xyz}\" rpy=\"{rpy}\"/><axis xyz=\"0 0 1\"/><limit lower=\"-3\" upper=\"3\"/></joint>",
            k + 1,
            order[k]
        );
    }
    std::fs::write(at.join("arm.urdf"), urdf + "</robot>\n").unwrap();
    assert_eq!(program(at, &["init", "nominal", "--urdf", "arm.urdf"]).0, Some(0));
    let arm = etalon::campaign::read_robot(&at.join("nominal/robot.toml")).unwrap();
    let arm = arm.build(&targets.iter().map(|name| (*name).to_owned()).collect::<Vec<_>>()).unwrap();
    let mut values = arm.nominal();
    for (p, value) in arm.parameters().iter().zip(&mut values) {
        *value += match p.name.as_str() {
            "base_x" => 900.0,
            "elbow_x" => 1.0,
            _ => 0.0,
        };
    }
    for (k, (name, axis)) in targets.iter().zip(["x", "y", "z"]).enumerate() {
        let place = arm.parameters().iter().position(|p| p.name == format!("{name}_{axis}")).unwrap();
        values[place] += 60.0 + 10.0 * k as f64;
    }
    let mut noise = Noise::new(24, 1);
    let (mut messages, mut csv, mut time, mut q) = (Vec::new(), "Time;Point;X;Y;Z\n".to_owned(), 0.0, vec![0.0; 6]);
    let mut emit = |q: &[f64], time: f64| {
        // the message names its joints in another order than the chain
        let positions: Vec<f64> = names.iter().map(|name| q[order.iter().position(|o| o == name).unwrap()]).collect();
        let stamp = (1000 + time as i32, ((time % 1.0) * 1e9) as u32);
        messages.push(("/joint_states", JOINTS, Cdr::joints(stamp, &names, &positions)));
    };
    for pose in 0..36 {
        let next: Vec<f64> = (0..6).map(|_| noise.uniform(1.4)).collect();
        for step in 1..=moves {
            time += 0.2;
            let share = f64::from(step) / f64::from(moves);
            emit(&q.iter().zip(&next).map(|(a, b)| a + (b - a) * share).collect::<Vec<_>>(), time);
        }
        q = next;
        let stand = stands(pose);
        for (k, name) in targets.iter().enumerate() {
            let p = arm.position(&values, &q, k).map(|v| v + noise.gaussian(0.01));
            let share = (k + 1) as f64 / (targets.len() + 1) as f64;
            let at = stamp(36_000.0 + time + 0.2 * share * f64::from(stand));
            let _ = writeln!(csv, "{at};{name};{:.4};{:.4};{:.4}", p[0], p[1], p[2]);
        }
        for _ in 0..stand {
            time += 0.2;
            emit(&q, time);
        }
    }
    std::fs::write(at.join("run.mcap"), recording(&messages)).unwrap();
    std::fs::write(at.join("tracker.csv"), csv).unwrap();
    arm.parameters().iter().map(|p| p.name.clone()).zip(values).collect()
}

/// A recording and points with times in the format of `stamp` become a campaign without questions about the join.
fn recorded(targets: &[&str], stamp: &dyn Fn(f64) -> String) {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let truth = record(at, targets, stamp);
    let (code, said) = program(at, &["init", "mine", "--urdf", "arm.urdf", "--from", "tracker.csv", "run.mcap"]);
    assert_eq!(code, Some(0), "{said}");
    let said = one_line(&said);
    assert!(said.ends_with("asks for name, expanded_uncertainty_um, unit"), "{said}");
    let text = std::fs::read_to_string(at.join("mine/campaign.toml")).unwrap();
    assert!(text.contains("clock_offset_s = \"standstills\"") && !text.contains("pose = \"row\""), "{text}");
    let answers = [("name", "\"tracker\""), ("expanded_uncertainty_um", "20"), ("unit", "\"mm\"")];
    assert_eq!(answer(at, &answers).len(), 3);
    let (_, said) = program(at, &["check", "mine"]);
    assert!(said.contains("(ROS recording, topic `/") && !said.contains("delimited by `tab`"), "{said}");
    let document = found(at);
    assert!(document.residuals.rms < 0.03, "{}", document.residuals.rms);
    let name = format!("{}_x", targets[0]);
    let found = document.parameters.iter().find(|p| p.name == name).unwrap().value;
    let (_, expected) = truth.iter().find(|(of, _)| *of == name).unwrap();
    assert!((found - expected).abs() < 0.2, "{found}");
}

/// Hours, minutes and seconds of a time of day.
fn clock(time: f64) -> String {
    let minutes = (time / 60.0).floor();
    format!("{:02}:{:02}:{:06.3}", (minutes / 60.0).floor(), minutes % 60.0, time - 60.0 * minutes)
}

#[test]
fn a_recording_and_points_with_times_are_a_campaign() {
    recorded(&["SMR"], &|time| format!("{time:.3}"));
}

#[test]
fn a_recording_and_points_with_dates_are_a_campaign() {
    recorded(&["A", "B"], &|time| format!("2026-03-12T{}", clock(time)));
}

#[test]
fn a_recording_and_one_target_with_dates_of_an_instrument_are_a_campaign() {
    recorded(&["SMR"], &|time| format!("'12.03.2026 {}", clock(time)));
}

/// Lines of a message are broken at the width of a page.
fn one_line(said: &str) -> String {
    said.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
fn rows_numbered_as_poses_are_named_as_the_cause_of_missing_targets() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    record(at, &["A", "B"], &|time| format!("2026-03-12T{}", clock(time)));
    let (code, said) = program(at, &["init", "mine", "--urdf", "arm.urdf", "--from", "tracker.csv", "run.mcap"]);
    assert_eq!(code, Some(0), "{said}");
    answer(at, &[("name", "\"tracker\""), ("expanded_uncertainty_um", "20"), ("unit", "\"mm\"")]);
    let path = at.join("mine/campaign.toml");
    let sound = std::fs::read_to_string(&path).unwrap();
    let (_, said) = program(at, &["check", "mine"]);
    assert!(!said.contains("[targets-missing]"), "{said}");
    std::fs::write(&path, sound.replace("unit = \"mm\"", "unit = \"mm\"\npose = \"row\"")).unwrap();
    let (_, said) = program(at, &["check", "mine"]);
    let said = one_line(&said);
    assert!(said.contains("[targets-missing]") && said.contains("pose = \"row\""), "{said}");
    // without standstills there is no offset of the clocks to find
    let line = sound.lines().find(|line| line.starts_with("standstill = ")).unwrap();
    std::fs::write(&path, sound.replace(line, "")).unwrap();
    let (code, said) = program(at, &["check", "mine"]);
    let said = one_line(&said);
    assert!(code == Some(2) && said.contains("error[standstills-missing]") && said.contains(line), "{said}");
    assert_eq!(said.matches("error[").count(), 1, "{said}");
}

/// Two files whose labels are the numbers of the poses of the log, which has more poses, and a robot file of one's own.
#[test]
fn labels_that_are_numbers_join_poses_of_the_own_robot() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let rows = measured(at, 60);
    std::fs::rename(at.join("nominal/robot.toml"), at.join("own.toml")).unwrap();
    let mut log = "Pose;J1 [deg];J2 [deg];J3 [deg];J4 [deg];J5 [deg];J6 [deg]\n".to_owned();
    let mut export = "Point,X [mm],Y [mm],Z [mm]\n".to_owned();
    // numbers of two digits with gaps
    for (i, (q, p, _)) in (0..).zip(rows).map(|(i, row)| (11 + i + i / 7, row)) {
        let cells: Vec<String> = q.iter().map(|v| format!("{:.5}", v.to_degrees())).collect();
        let _ = writeln!(log, "{i};{}", cells.join(";"));
        if i % 11 != 5 {
            let _ = writeln!(export, "{i},{:.4},{:.4},{:.4}", p[0], p[1], p[2]);
        }
    }
    std::fs::write(at.join("log.csv"), log).unwrap();
    std::fs::write(at.join("points.csv"), export).unwrap();
    let (code, said) = program(at, &["init", "mine", "--robot", "own.toml", "--from", "points.csv", "log.csv"]);
    assert_eq!(code, Some(0), "{said}");
    // the proposal is tried: nothing is refused once the instrument is stated
    let said = one_line(&said);
    assert!(said.ends_with("`etalon check mine` asks for name, expanded_uncertainty_um"), "{said}");
    let text = std::fs::read_to_string(at.join("mine/campaign.toml")).unwrap();
    assert!(text.contains("label = \"{pose}\"") && text.contains("by = [\"pose\"]"), "{text}");
    assert_eq!(answer(at, &[("name", "\"tracker\""), ("expanded_uncertainty_um", "20")]).len(), 2);
    is_calibrated(&found(at));
    // a folder with a robot.toml, and files without --from
    let (code, said) = program(at, &["init", "again", "--robot", "mine"]);
    assert!(code == Some(0) && at.join("again/robot.toml").exists(), "{said}");
    let (code, said) = program(at, &["init", "other", "--robot", "none.toml", "--from", "points.csv"]);
    assert!(code == Some(2) && said.contains("none.toml"), "{said}");
}

/// A joint that is off by 90 deg contradicts the robot: the proposal gives the cause that the judge of the set-up finds.
#[test]
fn a_proposal_that_contradicts_the_robot_gives_the_cause() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let mut log = "Pose;J1 [deg];J2 [deg];J3 [deg];J4 [deg];J5 [deg];J6 [deg]\n".to_owned();
    let mut export = "Point,X [mm],Y [mm],Z [mm]\n".to_owned();
    for (i, (mut q, p, _)) in (1..).zip(measured(at, 60)) {
        q[2] += std::f64::consts::FRAC_PI_2;
        let cells: Vec<String> = q.iter().map(|v| format!("{:.5}", v.to_degrees())).collect();
        let _ = writeln!(log, "{i};{}", cells.join(";"));
        let _ = writeln!(export, "{i},{:.4},{:.4},{:.4}", p[0], p[1], p[2]);
    }
    std::fs::write(at.join("log.csv"), log).unwrap();
    std::fs::write(at.join("points.csv"), export).unwrap();
    let (code, said) = program(at, &["init", "mine", "--robot", "nominal", "--from", "points.csv", "log.csv"]);
    let said = one_line(&said);
    assert!(code == Some(0) && said.contains("nominal-robot-far: "), "{said}");
    let cause = etalon::base::phrase!("slip-offset", degrees = "-90", joint = "`q3`").to_string();
    assert!(said.contains(&cause), "{said}");
}

/// Labels that are numbers of points, which the log does not have: rows meet rows.
#[test]
fn labels_that_name_no_pose_of_the_log_join_by_row() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let (mut log, mut export) = ("pose;J1;J2;J3;J4;J5;J6\n".to_owned(), "Point,X,Y,Z\n".to_owned());
    for (i, (q, p, _)) in (1..).zip(measured(at, 60)) {
        let cells: Vec<String> = q.iter().map(|v| format!("{:.5}", v.to_degrees())).collect();
        let _ = writeln!(log, "{i};{}", cells.join(";"));
        let _ = writeln!(export, "{},{:.4},{:.4},{:.4}", 5000 + i, p[0], p[1], p[2]);
    }
    std::fs::write(at.join("log.csv"), log).unwrap();
    std::fs::write(at.join("points.csv"), export).unwrap();
    let (code, said) = program(at, &["init", "mine", "--robot", "ur5e", "--from", "points.csv", "log.csv"]);
    assert_eq!(code, Some(0), "{said}");
    let text = std::fs::read_to_string(at.join("mine/campaign.toml")).unwrap();
    assert!(text.contains("pose = \"row\"") && text.contains("by = \"row\""), "{text}");
    assert_eq!(answer(at, &[("name", "\"tracker\""), ("expanded_uncertainty_um", "20")]).len(), 2);
    is_calibrated(&found(at));
}

/// Two to four messages at each pose: standstills join them all the same, by their duration.
#[test]
fn a_recording_with_few_messages_at_each_point_is_joined() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    record_rows(at, &["SMR"], &|time| format!("{time:.3}"), (1, &|pose| 2 + (pose * 7) % 3));
    let (code, said) = program(at, &["init", "mine", "--urdf", "arm.urdf", "--from", "tracker.csv", "run.mcap"]);
    assert_eq!(code, Some(0), "{said}");
    let text = std::fs::read_to_string(at.join("mine/campaign.toml")).unwrap();
    assert!(text.contains("clock_offset_s = \"standstills\"") && text.contains("at_least_s = 0.2"), "{text}");
    let answers = [("name", "\"tracker\""), ("expanded_uncertainty_um", "20"), ("unit", "\"mm\"")];
    assert_eq!(answer(at, &answers).len(), 3);
    assert!(found(at).residuals.rms < 0.03);
    // one message at each point states the offset of the clocks; without a point it is open
    let other = tempfile::tempdir().unwrap();
    let at = other.path();
    record_rows(at, &["SMR"], &|time| format!("{time:.3}"), (1, &|_| 0));
    let lines = |file: &str| {
        let (code, said) = program(at, &["formats", file, "run.mcap"]);
        assert_eq!(code, Some(0), "{said}");
        said
    };
    let said = lines("tracker.csv");
    assert!(said.contains("by = \"time\"\nclock_offset_s = ") && said.contains("tolerance_s = 0.01"), "{said}");
    let whole = std::fs::read_to_string(at.join("tracker.csv")).unwrap();
    let (first, _) = whole.trim_end().rsplit_once('\n').unwrap();
    std::fs::write(at.join("part.csv"), format!("{first}\n")).unwrap();
    let said = lines("part.csv");
    assert!(said.contains("by = \"?\"") && said.has_phrase("recording-not-joined"), "{said}");
}

/// Two logs of the same poses are sections with names of their own; the first identifies.
#[test]
fn two_logs_are_two_sections() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let head = "pose;J1;J2;J3;J4;J5;J6\n".to_owned();
    let (mut first, mut second, mut export) = (head.clone(), head, "Name,X,Y,Z\n".to_owned());
    for (i, (q, p, _)) in (1..).zip(measured(at, 60)) {
        let cells =
            |added: f64| q.iter().map(|v| format!("{:.5}", v.to_degrees() + added)).collect::<Vec<_>>().join(";");
        let _ = writeln!(first, "{i};{}", cells(0.0));
        // the second log lacks some poses
        if i % 9 != 0 {
            let _ = writeln!(second, "{i};{}", cells(0.002));
        }
        let _ = writeln!(export, "SMR-{i},{:.4},{:.4},{:.4}", p[0], p[1], p[2]);
    }
    for (file, text) in [("motor.csv", second), ("load.csv", first), ("points.csv", export)] {
        std::fs::write(at.join(file), text).unwrap();
    }
    let from = ["init", "mine", "--robot", "ur5e", "--from", "motor.csv", "load.csv", "points.csv"];
    let (code, said) = program(at, &from);
    assert_eq!(code, Some(0), "{said}");
    let text = std::fs::read_to_string(at.join("mine/campaign.toml")).unwrap();
    // the log of all poses is the first
    let place = |part: &str| text.find(part).unwrap_or_else(|| panic!("{part}: {text}"));
    assert!(
        text.matches("\n[[log]]\n").count() == 2 && place("name = \"load_2\"") < place("name = \"motor_1\""),
        "{text}"
    );
    let mut answers = vec![("name", "\"tracker\""), ("expanded_uncertainty_um", "20")];
    answers.push(("UNIT", "deg"));
    answer(at, &answers);
    is_calibrated(&found(at));
    let (code, said) = program(at, &["init", "logs", "--robot", "ur5e", "--from", "motor.csv", "load.csv"]);
    assert!(code == Some(0) && at.join("logs/campaign.toml").exists(), "{said}");
}

/// Adds a flange, a tool frame and the finger of a gripper to the arm of [`record`].
fn with_gripper(at: &Path) {
    let urdf = std::fs::read_to_string(at.join("arm.urdf")).unwrap();
    let more = "<link name=\"finger\"/><joint name=\"grip\" type=\"prismatic\"><parent link=\"l6\"/><child link=\"finger\"/>\
                <axis xyz=\"1 0 0\"/><limit lower=\"0\" upper=\"0.05\"/></joint>\
                <link name=\"tool0\"/><joint name=\"mount\" type=\"fixed\"><parent link=\"l6\"/><child link=\"tool0\"/></joint></robot>";
    std::fs::write(at.join("arm.urdf"), urdf.replace("</robot>", more)).unwrap();
}

/// Rows of joints of the arm and points of a reflector on its flange, or on the finger, which moves.
fn rows_of_arm(at: &Path, tool_link: &str, grip: &dyn Fn(u32) -> f64) -> String {
    let robot = format!("model = \"urdf\"\nfile = \"arm.urdf\"\nbase_link = \"root\"\ntool_link = \"{tool_link}\"\n");
    std::fs::write(at.join("true.toml"), robot).unwrap();
    let arm = etalon::campaign::read_robot(&at.join("true.toml")).unwrap().build(&["SMR".to_owned()]).unwrap();
    let mut values = arm.nominal();
    for (p, value) in arm.parameters().iter().zip(&mut values) {
        *value += match p.name.as_str() {
            "base_x" => 900.0,
            "SMR_x" => 60.0,
            "elbow_x" => 0.5,
            _ => 0.0,
        };
    }
    let mut noise = Noise::new(31, 1);
    let mut text = "pan [rad],shoulder [rad],elbow [rad],wrist_1 [rad],wrist_2 [rad],wrist_3 [rad],grip [m],X [mm],Y [mm],Z [mm]\n".to_owned();
    for row in 0..60 {
        let q: Vec<f64> = (0..6).map(|_| noise.uniform(1.4)).collect();
        let mut joints = q.clone();
        if tool_link == "finger" {
            joints.push(1000.0 * grip(row));
        }
        let p = arm.position(&values, &joints, 0).map(|v| v + noise.gaussian(0.01));
        let cells: Vec<String> = q.iter().chain(&[grip(row)]).chain(&p).map(|v| format!("{v:.6}")).collect();
        let _ = writeln!(text, "{}", cells.join(","));
    }
    text
}

#[test]
fn the_tool_link_is_that_of_the_measured_points() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    record(at, &["SMR"], &|time| format!("{time:.3}"));
    with_gripper(at);
    let chosen = |file: &str, log: &str| {
        let _ = std::fs::remove_dir_all(at.join("mine"));
        let from = ["init", "mine", "--urdf", "arm.urdf", "--from", file, log];
        let (code, said) = program(at, if log.is_empty() { &from[..6] } else { &from });
        assert_eq!(code, Some(0), "{said}");
        std::fs::read_to_string(at.join("mine/robot.toml")).unwrap()
    };
    // the recording has no finger
    let robot = chosen("tracker.csv", "run.mcap");
    assert!(robot.contains("tool_link = \"tool0\"") && robot.has_phrase("tool-link-by-names"), "{robot}");
    // a finger that stands still, and one that carries the reflector and moves
    std::fs::write(at.join("flange.csv"), rows_of_arm(at, "tool0", &|_| 0.01)).unwrap();
    let robot = chosen("flange.csv", "");
    assert!(robot.contains("tool_link = \"tool0\"") && robot.has_phrase("tool-link-shortest"), "{robot}");
    let moving = |row: u32| 0.001 * f64::from(row * 17 % 50);
    std::fs::write(at.join("finger.csv"), rows_of_arm(at, "finger", &moving)).unwrap();
    let robot = chosen("finger.csv", "");
    assert!(robot.contains("tool_link = \"finger\"") && robot.has_phrase("tool-link-by-residual"), "{robot}");
    // joints alone, with a finger that moves: the files do not decide
    let log: String = rows_of_arm(at, "finger", &moving)
        .lines()
        .map(|line| line.splitn(8, ',').take(7).collect::<Vec<_>>().join(",") + "\n")
        .collect();
    std::fs::write(at.join("joints.csv"), log).unwrap();
    let robot = chosen("joints.csv", "");
    assert!(robot.contains("tool_link = \"?\"") && robot.matches("fits the files").count() == 2, "{robot}");
    // two fingers of a tool, of which one mimics the other: two chains with the same joints, and no other end
    let urdf = std::fs::read_to_string(at.join("arm.urdf")).unwrap();
    let grip = "<parent link=\"l6\"/><child link=\"finger\"/>";
    let second = "<link name=\"other\"/><joint name=\"grip_2\" type=\"prismatic\"><parent link=\"tool0\"/><child link=\"other\"/>\
                  <axis xyz=\"-1 0 0\"/><limit lower=\"0\" upper=\"0.05\"/><mimic joint=\"grip\"/></joint></robot>";
    let two = urdf.replace(grip, &grip.replace("l6", "tool0")).replace("</robot>", second);
    std::fs::write(at.join("arm.urdf"), two).unwrap();
    let still: String = rows_of_arm(at, "finger", &|_| 0.01)
        .lines()
        .map(|line| line.splitn(8, ',').take(7).collect::<Vec<_>>().join(",") + "\n")
        .collect();
    std::fs::write(at.join("still.csv"), still).unwrap();
    let robot = chosen("still.csv", "");
    assert!(robot.contains("tool_link = \"?\"") && robot.matches("fits the files").count() == 2, "{robot}");
    std::fs::write(at.join("arm.urdf"), urdf).unwrap();
    // a finger that moves, and a reflector on the flange
    std::fs::write(at.join("both.csv"), rows_of_arm(at, "tool0", &moving)).unwrap();
    let robot = chosen("both.csv", "");
    assert!(robot.contains("tool_link = \"tool0\""), "{robot}");
}

/// Points of both hands of the sample two-hands, with names of their own: rows of a table with all joints.
fn rows_of_hands(rename: &dyn Fn(&str) -> String, keep: &dyn Fn(usize, &str) -> bool) -> String {
    let sample = root().join("samples/two-hands/observations.csv");
    let text = std::fs::read_to_string(sample).unwrap();
    let mut lines = text.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let header = lines.next().unwrap();
    let at = |name: &str| header.iter().position(|column| *column == name).unwrap();
    let joints: Vec<usize> = (0..header.len()).filter(|i| header[*i].ends_with("_deg")).collect();
    let named: Vec<String> = joints.iter().map(|i| format!("{} [deg]", header[*i].trim_end_matches("_deg"))).collect();
    let mut out = format!("Pose,Reflector,{},X [mm],Y [mm],Z [mm]\n", named.join(","));
    for row in lines.filter(|row| row[0] == "point") {
        let (pose, target) = (row[at("pose")], row[at("target")]);
        if keep(pose.parse().unwrap(), target) {
            let cells = joints.iter().copied().chain(["x_mm", "y_mm", "z_mm"].map(at)).map(|i| row[i]);
            let _ = writeln!(out, "{pose},{},{}", rename(target), cells.collect::<Vec<_>>().join(","));
        }
    }
    out
}

#[test]
fn points_of_two_hands_are_branches() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let urdf = root().join("samples/two-hands/two_hands.urdf");
    std::fs::copy(urdf, at.join("body.urdf")).unwrap();
    let renamed = |target: &str| format!("SMR{}", ["L1", "R2", "L2", "R1"].iter().position(|t| *t == target).unwrap());
    let proposed = |rows: String| {
        let _ = std::fs::remove_dir_all(at.join("mine"));
        std::fs::write(at.join("rows.csv"), rows).unwrap();
        let (code, said) = program(at, &["init", "mine", "--urdf", "body.urdf", "--from", "rows.csv"]);
        assert_eq!(code, Some(0), "{said}");
        ["robot.toml", "campaign.toml"].map(|name| std::fs::read_to_string(at.join("mine").join(name)).unwrap())
    };
    let [robot, campaign] = proposed(rows_of_hands(&renamed, &|_, _| true));
    for branch in [
        "tool_link = \"left_hand\"\ntargets = [\"SMR0\", \"SMR2\"]",
        "tool_link = \"right_hand\"\ntargets = [\"SMR1\", \"SMR3\"]",
    ] {
        assert!(robot.contains(branch), "{branch}: {robot}");
    }
    assert!(campaign.contains("joints = {") && campaign.contains("right_6_deg = \"right_6 [deg]\""), "{campaign}");
    // the proposal identifies both hands
    let complete = campaign.replace("name = \"?\"", "name = \"tracker\"").replace("um = \"?\"", "um = 20");
    std::fs::write(at.join("mine/campaign.toml"), complete).unwrap();
    let (code, said) = program(at, &["run", "mine"]);
    assert_eq!(code, Some(0), "{said}");
    // a target that changes hands fits neither; its link is a question
    let changes = |target: &str| if target == "R1" { "SMR9".to_owned() } else { renamed(target) };
    let mixed = rows_of_hands(&changes, &|_, _| true).replace(",SMR2,", ",SMR9,");
    let [robot, _] = proposed(mixed);
    assert!(
        robot.matches("[[branch]]").count() == 2
            && robot.lines().any(|line| line.starts_with("# QUESTION: ") && line.contains("`SMR9`")),
        "{robot}"
    );
    assert!(!robot.contains("\"SMR9\""), "{robot}");
    // few rows test no chain, and points of one hand need no branches
    for [robot, _] in [
        proposed(rows_of_hands(&renamed, &|pose, _| pose < 7)),
        proposed(rows_of_hands(&renamed, &|_, target| target.starts_with('L'))),
    ] {
        assert!(!robot.contains("[[branch]]") && robot.contains("tool_link = "), "{robot}");
    }
}

/// Four numbers without a named scalar: the nominal robot decides the order, a wrong one remains a question.
#[test]
fn the_robot_decides_the_order_of_a_quaternion() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let rows = measured(at, 40);
    let proposed = |order: &dyn Fn([f64; 4]) -> [f64; 4]| {
        let mut text =
            "J1 [deg],J2 [deg],J3 [deg],J4 [deg],J5 [deg],J6 [deg],X [mm],Y [mm],Z [mm],q1,q2,q3,q4\n".to_owned();
        for (q, p, o) in &rows {
            let cells = q.iter().map(|v| v.to_degrees()).chain(*p).chain(order(*o));
            let _ = writeln!(text, "{}", cells.map(|v| format!("{v:.6}")).collect::<Vec<_>>().join(","));
        }
        std::fs::write(at.join("rows.csv"), text).unwrap();
        let (code, said) = program(at, &["formats", "rows.csv", "--robot", "nominal/robot.toml"]);
        assert_eq!(code, Some(0), "{said}");
        said
    };
    let first = proposed(&|o| o);
    assert!(first.contains("qw = \"q1\"") && !first.has_phrase("ask-quaternion-order"), "{first}");
    let last = proposed(&|[w, x, y, z]| [x, y, z, w]);
    assert!(
        last.contains("qw = \"q4\"") && last.contains("qx = \"q1\"") && !last.has_phrase("ask-quaternion-order"),
        "{last}"
    );
    // the sign of a quaternion has no meaning
    let signs = proposed(&|[w, x, y, z]| if x > 0.0 { [-x, -y, -z, -w] } else { [x, y, z, w] });
    assert!(signs.contains("qw = \"q4\"") && !signs.has_phrase("ask-quaternion-order"), "{signs}");
    // two components exchanged, and the orientation of the instrument in the body
    for slip in [proposed(&|[w, x, y, z]| [w, y, x, z]), proposed(&|[w, x, y, z]| [w, -x, -y, -z])] {
        assert!(slip.has_phrase("ask-quaternion-order columns=`q1`, `q2`, `q3`, `q4`"), "{slip}");
    }
}

/// Half of the poses from a second place of the tracker: with `station` its pose is identified, without it the points contradict.
#[test]
fn an_export_of_a_second_station_is_joined() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let [mut first, mut second] = ["pose,x,y,z\n", "pose,x,y,z\n"].map(str::to_owned);
    let mut log = "pose,J1,J2,J3,J4,J5,J6\n".to_owned();
    let turned = Pose::from_rotation_vector([0.1, -0.2, 0.7]);
    let seen = Pose { translation_mm: [400.0, -900.0, 150.0], ..turned };
    for (i, (q, p, _)) in (1..).zip(measured(at, 60)) {
        let cells: Vec<String> = q.iter().map(|v| format!("{:.6}", v.to_degrees())).collect();
        let _ = writeln!(log, "{i},{}", cells.join(","));
        let (text, p) = if i % 2 == 0 { (&mut second, seen.apply(p)) } else { (&mut first, p) };
        let _ = writeln!(text, "{i},{:.5},{:.5},{:.5}", p[0], p[1], p[2]);
    }
    assert_eq!(program(at, &["init", "mine", "--robot", "ur5e"]).0, Some(0));
    for (file, text) in [("a.csv", first), ("b.csv", second), ("log.csv", log)] {
        std::fs::write(at.join("mine").join(file), text).unwrap();
    }
    let export = |file: &str, station: &str| {
        format!(
            "[[export]]\nfile = \"{file}\"\nunit = \"mm\"\ntarget = \"SMR\"\n{station}\
             format = {{ delimiter = \",\", header = 1, columns = [\"pose\", \"x\", \"y\", \"z\"] }}\n"
        )
    };
    let joints: Vec<String> = (1..=6).map(|i| format!("q{i}_deg = \"J{i}\"")).collect();
    let campaign = |station: &str| {
        let text = format!(
            "name = \"s\"\nrobot = \"robot.toml\"\n[instrument]\nname = \"t\"\nexpanded_uncertainty_um = 20\ncoverage_factor = 2\n\
             {}{}[log]\nfile = \"log.csv\"\ncolumns = {{ pose = \"pose\", {} }}\n[join]\nby = [\"pose\"]\ntargets = [\"SMR\"]\n\
             [frame.world]\nas_exported = true\n[identify]\ncalibration = \"all\"\n",
            export("a.csv", ""),
            export("b.csv", station),
            joints.join(", ")
        );
        std::fs::write(at.join("mine/campaign.toml"), text).unwrap();
        program(at, &["run", "mine"])
    };
    let (code, said) = campaign("station = \"B\"\n");
    assert_eq!(code, Some(0), "{said}");
    let document = found(at);
    is_calibrated(&document);
    let place = seen.inverse().translation_mm;
    let value = |name: &str| document.parameters.iter().find(|p| p.name == name).map(|p| p.value);
    let close = ["B_x", "B_y", "B_z"]
        .iter()
        .zip(place)
        .all(|(name, right)| value(name).is_some_and(|v| (v - right).abs() < 0.1));
    let names: Vec<&str> = document.parameters.iter().map(|p| p.name.as_str()).collect();
    assert!(close, "{place:?}: {names:?}");
    let (code, said) = campaign("");
    assert!(code != Some(0), "{said}");
}

#[test]
fn several_logs_and_several_tables_are_lists() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let rows = |columns: &str, more: &str| format!("pose,{columns}q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg{more}\n");
    let log = rows("", "") + "1,0,0,0,0,0,0\n2,1,2,3,4,5,6\n";
    let table = rows("target,", ",x_mm,y_mm,z_mm") + "1,A,0,0,0,0,0,0,1,2,3\n2,A,10,0,0,0,0,0,1,2,3\n";
    for (section, text) in [("log", log), ("observations", table)] {
        ["a.csv", "b.csv"].iter().for_each(|name| std::fs::write(at.join(name), &text).unwrap());
        let (code, said) = program(at, &["init", section, "--robot", "ur5e", "--from", "a.csv", "b.csv"]);
        assert_eq!(code, Some(0), "{said}");
        let text = std::fs::read_to_string(at.join(section).join("campaign.toml")).unwrap();
        let stated: toml::Table = toml::from_str(&text).unwrap();
        let files: Vec<&str> =
            stated[section].as_array().unwrap().iter().filter_map(|part| part["file"].as_str()).collect();
        assert_eq!(files, ["a.csv", "b.csv"], "{text}");
    }
}

/// Reflectors on the floor, measured without a pose, are stationary: they are no targets of the robot. A campaign without
/// `[frame.world]` has the world of its exports.
#[test]
fn points_without_a_pose_are_stationary_and_the_world_is_optional() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let (mut poses, mut log) = (String::new(), "pose,J1,J2,J3,J4,J5,J6\n".to_owned());
    for (i, (q, p, _)) in (1..).zip(measured(at, 40)) {
        let cells: Vec<String> = q.iter().map(|v| format!("{:.6}", v.to_degrees())).collect();
        let _ = writeln!(log, "{i},{}", cells.join(","));
        let _ = writeln!(poses, "SMR_{i}_1,{:.5},{:.5},{:.5}", p[0], p[1], p[2]);
    }
    let floor: String =
        (0..9).map(|i| format!("floor_{},{}.5,{}.25,-400.0\n", i % 3 + 1, 900 * (i % 3), 70 * i)).collect();
    for (file, text) in [("floor.csv", floor), ("poses.csv", poses), ("log.csv", log)] {
        std::fs::write(at.join(file), text).unwrap();
    }
    let (code, said) = program(at, &["init", "mine", "--robot", "ur5e", "--from", "floor.csv", "poses.csv", "log.csv"]);
    assert_eq!(code, Some(0), "{said}");
    let path = at.join("mine/campaign.toml");
    let proposed = std::fs::read_to_string(&path).unwrap();
    assert!(proposed.contains("\ntargets = [\"SMR\"]\n"), "{proposed}");
    let floor = "# targets = [\"floor_1\", \"floor_2\", \"floor_3\"]";
    assert!(proposed.contains(floor) && proposed.matches("floor_2").count() == 1, "{proposed}");
    answer(at, &[("name", "\"t\""), ("expanded_uncertainty_um", "20"), ("unit", "\"mm\"")]);
    let answered = std::fs::read_to_string(&path).unwrap();
    let line = answered.lines().find(|line| line.starts_with("as_exported")).unwrap();
    let frames = |text: String| {
        std::fs::write(&path, text).unwrap();
        found(at);
        std::fs::read_to_string(at.join("mine/out/frames.json")).unwrap()
    };
    let omitted = answered.replace(&format!("[frame.world]\n{line}\n"), "");
    assert!(omitted.len() < answered.len());
    assert_eq!(frames(answered), frames(omitted));
}

/// Lines that are proposed for files beside the log of a sample of a parallel robot.
fn proposed(at: &Path, sample: &str, files: &[(&str, String)]) -> String {
    let mut paths: Vec<std::path::PathBuf> = files.iter().map(|(name, _)| at.join(name)).collect();
    paths.iter().zip(files).for_each(|(path, (_, text))| std::fs::write(path, text).unwrap());
    paths.push(Path::new(env!("CARGO_MANIFEST_DIR")).join("samples").join(sample).join("encoders.csv"));
    etalon::formats::propose_files(&paths, None).unwrap().toml
}

/// Balls on the floor do not become targets of a parallel robot: as the samples have them, each measured once, with names that could
/// be poses, in a file of their own or among the points of the platform.
#[test]
fn balls_on_the_floor_of_a_parallel_robot_are_no_targets() {
    let scratch = tempfile::tempdir().unwrap();
    let read = |sample: &str, file: &str| {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("samples").join(sample).join("exports").join(file);
        std::fs::read_to_string(path).unwrap()
    };
    for (sample, targets) in [
        ("hexapod", "targets = [\"SMR_1\", \"SMR_2\", \"SMR_3\"]"),
        ("delta", "targets = [\"SMR_1\", \"SMR_2\", \"SMR_3\"]"),
        ("prexyt-cmm", "targets = [\"K\", \"L\"]"),
    ] {
        let files = ["world.txt", "poses.txt"].map(|file| (file, read(sample, file)));
        let text = proposed(scratch.path(), sample, &files);
        assert!(text.contains(targets) && text.contains("by = [\"pose\", \"cycle\"]"), "{sample}: {text}");
        assert!(text.contains("# stationary points: the labels name no pose"), "{sample}: {text}");
    }
    let poses = read("hexapod", "poses.txt");
    let once: String = ["floor_1", "floor_2", "floor_3"]
        .iter()
        .map(|name| read("hexapod", "world.txt").lines().find(|line| line.starts_with(name)).unwrap().to_owned() + "\n")
        .collect();
    for (floor, poses) in [
        (once.clone(), poses.clone()),
        (once.replace("floor_", "B"), poses.clone()),
        (once.replace("floor_", ""), poses.clone()),
    ] {
        for apart in [true, false] {
            let files = match apart {
                true => vec![("floor.txt", floor.clone()), ("platform.txt", poses.clone())],
                // numbers without a name among other labels are names of nothing
                false if floor.starts_with('1') => continue,
                false => vec![("all.txt", floor.clone() + &poses)],
            };
            let text = proposed(scratch.path(), "hexapod", &files);
            let lines: String =
                text.lines().filter(|line| !line.starts_with('#')).map(|line| line.to_owned() + "\n").collect();
            assert!(lines.contains("targets = [\"SMR_1\", \"SMR_2\", \"SMR_3\"]"), "{apart} {floor}: {text}");
            assert!(lines.contains("by = [\"pose\""), "{apart} {floor}: {text}");
            let said = if apart { "as points that do not move" } else { "stationary points" };
            assert!(text.contains(said), "{apart} {floor}: {text}");
        }
    }
}
