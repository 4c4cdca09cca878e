//! Files for controllers of one kind of robot: what an independent reader makes of them is the identified robot.

use crate::support::controller_files::{genserkins, universal_robots};
use crate::support::root;
use crate::support::scratch::{Scratch, copy_sample};
use etalon::base::catalogue::Argument;
use etalon::base::pose::{Pose, minus, norm};
use etalon::campaign::{Campaign, read_robot};
use etalon::controllers::{self, Description, ExportInput};
use etalon::documents::{AccuracyDocument, CampaignSummary, ErrorQuantity, ParametersDocument, PointError};
use etalon::math::statistics::rms;
use etalon::robots::{PUBLISHED, Robot, Role};
use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;

pub fn etalon(arguments: &[&str]) -> (Option<i32>, String) {
    let output = Command::new(crate::support::program()).args(arguments).output().unwrap();
    (output.status.code(), String::from_utf8(output.stderr).unwrap())
}

/// Parameters of a run that found these values (mm, rad, 1).
pub fn parameters(scratch: &Scratch, robot: &dyn Robot, values: &[f64]) -> String {
    let entry = |(p, value): (&etalon::robots::Parameter, &f64)| {
        serde_json::json!({
            "name": p.name, "unit": p.quantity.unit(), "nominal": p.quantity.outward(p.nominal), "before": p.quantity.outward(p.nominal),
            "value": p.quantity.outward(*value), "standard_uncertainty": null, "degrees_of_freedom": null,
            "status": "fixed", "confounded_with": []
        })
    };
    let all: Vec<_> = robot.parameters().iter().zip(values).map(entry).collect();
    let document = serde_json::json!({
        "schema": "etalon/parameters/2", "robot": robot.model(), "parameters": all, "covariance": [],
        "residuals": {
            "kind": "targets", "count": 0, "rms": 0.0, "max": 0.0, "degrees_of_freedom": 0, "stated_standard_uncertainty_mm": null,
            "common_standard_uncertainty_mm": null, "chi_square": null, "uncertainties_from": "instrument", "uncertainties_enlarged_by": 1.0
        },
        "observability": null,
        "solver": { "method": "lm", "iterations": 1, "termination": "step_vanished", "meaning": "" },
        "messages": [], "provenance": { "version": "0.1.0", "inputs": {}, "seed": null }
    });
    let _: ParametersDocument = serde_json::from_value(document.clone()).unwrap();
    let path = scratch.path().join("found.json");
    std::fs::write(&path, document.to_string()).unwrap();
    path.display().to_string()
}

/// Values off by what a calibration finds; gains only of joints that `gains` names.
pub fn disturbed(robot: &dyn Robot, gains: &[&str]) -> Vec<f64> {
    let mut noise = etalon::base::noise::Noise::new(19, 1);
    let mut value = |p: &etalon::robots::Parameter| match p.name.as_str() {
        _ if p.role != Role::Robot => p.nominal,
        name if name.starts_with("compliance") || name.starts_with("coupling") => p.nominal,
        name if name.starts_with("gain") && !gains.contains(&name) => 1.0,
        name if name.starts_with("gain") => 1.0 + noise.uniform(1e-3),
        _ if p.quantity.unit() == "mm" => p.nominal + noise.uniform(2.0),
        _ => p.nominal + noise.uniform(0.01),
    };
    robot.parameters().iter().map(&mut value).collect()
}

/// Direct kinematics of the URDF in Python, which shares nothing with the program.
fn reads_as_the_identified_robot(urdf: &Path, robot: &dyn Robot, values: &[f64]) {
    let arm = robot.kinematics().unwrap();
    let mut noise = etalon::base::noise::Noise::new(19, 10);
    let cases: Vec<Vec<f64>> = (0..50)
        .map(|_| (0..7).map(|i| if i == 0 { 400.0 + noise.uniform(390.0) } else { noise.uniform(2.0) }).collect())
        .collect();
    let line = |q: &Vec<f64>| {
        let value = |(joint, q): (&etalon::robots::Joint, &f64)| {
            let metres = joint.quantity.unit() == "mm";
            (joint.name.clone(), serde_json::Value::from(if metres { q / 1000.0 } else { *q }))
        };
        serde_json::Value::Object(arm.joints().iter().zip(q).map(value).collect()).to_string() + "\n"
    };
    let input = urdf.with_file_name("joints.jsonl");
    std::fs::write(&input, cases.iter().map(line).collect::<String>()).unwrap();
    let script = root().join("tests/support/urdf_direct.py");
    let mut reader = Command::new("python3");
    let reader = reader.arg("-B").arg(script).arg(urdf).args(["base_link", "tool"]);
    let Ok(output) = reader.stdin(std::fs::File::open(input).unwrap()).output() else {
        return crate::support::skipped("python3");
    };
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let read = String::from_utf8(output.stdout).unwrap();
    assert_eq!(read.lines().count(), cases.len());
    for (line, q) in read.lines().zip(&cases) {
        let at: Vec<f64> = line.split(' ').map(|v| v.parse().unwrap()).collect();
        let ours = arm.tool_pose(values, q).unwrap().translation_mm;
        assert!(norm(minus([at[0], at[1], at[2]], ours)) < 1e-9, "{at:?} {ours:?}");
    }
}

#[test]
fn a_urdf_with_calibrated_origins_is_the_identified_robot() {
    let scratch = copy_sample("column-arm");
    let file = scratch.path().join("robot.toml").display().to_string();
    let robot = Campaign::read(&scratch.path()).unwrap().robot.build(&["tool".to_owned()]).unwrap();
    let values = disturbed(robot.as_ref(), &["gain_column_lower_joint", "gain_column_upper_joint"]);
    let found = parameters(&scratch, robot.as_ref(), &values);
    let out = scratch.path().join("exported");
    let (code, said) =
        etalon(&["export", &found, "--format", "urdf", "--robot", &file, "--to", &out.display().to_string()]);
    assert_eq!(code, Some(0), "{said}");
    let text = std::fs::read_to_string(out.join("calibrated.urdf")).unwrap();
    let original = std::fs::read_to_string(scratch.path().join("arm.urdf")).unwrap();
    // comments are kept, and all that has no place in the kinematics
    for part in [
        "<!-- the arm hangs forward from the column -->",
        "<mass value=\"20\"/>",
        "velocity=\"0.2\"",
        "Drawn for this sample",
    ] {
        assert!(text.contains(part) && original.contains(part), "{part}");
    }
    for part in ["Written by etalon", "units: m, rad", "sha256 of parameters.json: "] {
        assert!(text.contains(part), "{part}: {text}");
    }
    scratch.replace("robot.toml", "arm.urdf", "exported/calibrated.urdf");
    let exported = read_robot(&scratch.path().join("robot.toml")).unwrap().build(&["tool".to_owned()]).unwrap();
    let mut noise = etalon::base::noise::Noise::new(19, 2);
    for _ in 0..50 {
        let joints: Vec<f64> =
            (0..7).map(|i| if i == 0 { 400.0 + noise.uniform(390.0) } else { noise.uniform(2.0) }).collect();
        for at in [[0.0; 3], [30.0, -40.0, 100.0]] {
            let place = |robot: &dyn Robot, values: &[f64]| {
                let mut values = values.to_vec();
                values[6..9].copy_from_slice(&at);
                robot.position(&values, &joints, 0)
            };
            let off = norm(minus(place(robot.as_ref(), &values), place(exported.as_ref(), &exported.nominal())));
            assert!(off < 1e-9, "{off}");
        }
    }
    reads_as_the_identified_robot(&out.join("calibrated.urdf"), robot.as_ref(), &values);
    // what failed its checks is written by force alone, and says so
    let (folder, lost) = (out.display().to_string(), std::fs::read_to_string(&found).unwrap());
    std::fs::write(&found, lost.replace("step_vanished", "lost_patience")).unwrap();
    scratch.replace("robot.toml", "exported/calibrated.urdf", "arm.urdf");
    let arguments = ["export", &found, "--format", "urdf", "--robot", &file, "--to", &folder, "--force"];
    let (code, said) = etalon(&arguments[..8]);
    assert!(code == Some(2) && said.contains("error[parameters-not-converged]"), "{said}");
    assert_eq!(etalon(&arguments).0, Some(0));
    let forced = std::fs::read_to_string(out.join("calibrated.urdf")).unwrap();
    assert!(forced.contains("NOT FIT FOR A CONTROLLER, written by force: "), "{forced}");
    // gains of other joints have no place in a URDF: the file says so
    let found = parameters(&scratch, robot.as_ref(), &disturbed(robot.as_ref(), &["gain_elbow"]));
    assert_eq!(
        etalon(&["export", &found, "--format", "urdf", "--robot", &file, "--to", &out.display().to_string()]).0,
        Some(0)
    );
    let text = std::fs::read_to_string(out.join("calibrated.urdf")).unwrap();
    assert!(text.contains("not in this format: joint elbow moves"), "{text}");
}

#[test]
fn a_universal_robots_calibration_is_the_identified_arm() {
    let root = root();
    for file in ["docs/keys/robot-serial-dh.toml", "samples/abb-irb120/robot.toml"] {
        let file = root.join(file);
        let robot = read_robot(&file).unwrap().build(&["tool".to_owned()]).unwrap();
        let values = disturbed(robot.as_ref(), &[]);
        let scratch = Scratch::with(&[]);
        let found = parameters(&scratch, robot.as_ref(), &values);
        let to = scratch.path().display().to_string();
        let (code, said) = etalon(&[
            "export",
            &found,
            "--format",
            "universal-robots",
            "--robot",
            &file.display().to_string(),
            "--to",
            &to,
        ]);
        assert_eq!(code, Some(0), "{said}");
        let text = std::fs::read_to_string(scratch.path().join("universal_robots_calibration.yaml")).unwrap();
        assert!(text.starts_with("# Written by etalon") && text.contains("  hash: calib_"), "{text}");
        let reach = |q: &[f64]| universal_robots(&text, q);
        // a point that the last joint carries stays at one place of the frame that the file gives it
        let mut noise = etalon::base::noise::Noise::new(19, 3);
        let places: Vec<[f64; 3]> = (0..20)
            .map(|_| {
                let q: Vec<f64> = (0..6).map(|_| noise.uniform(2.5)).collect();
                reach(&q).inverse().apply(robot.position(&values, &q, 0))
            })
            .collect();
        let off = places.iter().map(|p| norm(minus(*p, places[0]))).fold(0.0, f64::max);
        assert!(off < 1e-9, "{off}");
    }
    // not for a robot of other joints
    let scratch = copy_sample("column-arm");
    let file = scratch.path().join("robot.toml").display().to_string();
    let robot = read_robot(&scratch.path().join("robot.toml")).unwrap().build(&["tool".to_owned()]).unwrap();
    let found = parameters(&scratch, robot.as_ref(), &robot.nominal());
    let (code, said) = etalon(&["export", &found, "--format", "universal-robots", "--robot", &file]);
    assert!(code == Some(2) && said.contains("error[format-for-other-robots]"), "{said}");
    let (code, said) = etalon(&["export", &found, "--format", "urdf"]);
    assert!(code == Some(2) && said.contains("--robot FILE"), "{said}");
}

/// Difference from arms of Universal Robots that the export of a robot.toml names.
fn difference(scratch: &Scratch, robot: &str) -> Option<String> {
    let file = scratch.path().join("of-structure.toml");
    std::fs::write(&file, robot).unwrap();
    let robot = read_robot(&file).unwrap_or_else(|p| panic!("{p}\n{robot}")).build(&["tool".to_owned()]).unwrap();
    let parameters: ParametersDocument =
        serde_json::from_slice(&std::fs::read(parameters(scratch, robot.as_ref(), &robot.nominal())).unwrap()).unwrap();
    let given = ExportInput { robot: Some(robot.as_ref()), ..ExportInput::parameters(&parameters) };
    let exporter = controllers::by_name("universal-robots").unwrap();
    // the file is written either way
    assert!(exporter.write(&given).is_ok(), "{}", file.display());
    exporter.concern(&given).map(|message| {
        assert!(message.is("file-of-other-structure", &[("format", &"universal-robots")]), "{message}");
        match &message.arguments["difference"] {
            Argument::Phrase(phrase) => phrase.id.to_string(),
            other => panic!("{other:?}"),
        }
    })
}

/// robot.toml of a table of parameters: alpha (deg), a (mm), theta (deg), d (mm).
fn table(convention: &str, rows: &[[f64; 4]]) -> String {
    let rows: Vec<String> = rows
        .iter()
        .map(|[alpha, a, theta, d]| {
            format!("{{ alpha_deg = {alpha:?}, a_mm = {a:?}, theta_deg = {theta:?}, d_mm = {d:?} }}")
        })
        .collect();
    format!("name = \"arm\"\nmodel = \"serial\"\nconvention = \"{convention}\"\njoint = [{}]\n", rows.join(", "))
}

/// Tables of Universal Robots, as `etalon init --robot` has them: name and rows.
fn tables_of_the_maker() -> impl Iterator<Item = (&'static str, Vec<[f64; 4]>)> {
    PUBLISHED.iter().filter(|arm| arm.name.starts_with("ur")).map(|arm| (arm.name, arm.rows.to_vec()))
}

/// Arms of six screw axes, as `etalon init --robot` has them: name and robot.
fn screw_axes() -> Vec<(String, toml::Value)> {
    let text = std::fs::read_to_string(root().join("src/tasks/known_robots.toml")).unwrap();
    let all: toml::Table = text.parse().unwrap();
    let has_six = |robot: &&toml::Value| robot.get("poe").is_some_and(|poe| poe.as_array().unwrap().len() == 6);
    let named = |robot: &toml::Value| (robot["name"].as_str().unwrap().to_owned(), robot.clone());
    all["robot"].as_array().unwrap().iter().filter(has_six).map(named).collect()
}

#[test]
fn arms_of_universal_robots_are_known_by_their_axes() {
    let scratch = Scratch::with(&[]);
    let of = |convention: &str, rows: &[[f64; 4]]| difference(&scratch, &table(convention, rows));
    assert_eq!(tables_of_the_maker().count(), 8);
    for (name, rows) in tables_of_the_maker() {
        assert_eq!(of("dh", &rows), None, "{name}");
        // a calibrated arm: its parallel axes have distant common normals, its zeros are elsewhere
        let mut noise = etalon::base::noise::Noise::new(19, 7);
        let mut calibrated = rows.clone();
        for row in &mut calibrated {
            *row = [row[0] + noise.uniform(0.5), row[1] + noise.uniform(3.0), noise.uniform(180.0), row[3]];
        }
        (calibrated[1][3], calibrated[2][3]) = (250.0, -248.0);
        assert_eq!(of("dh", &calibrated), None, "{name}");
        // the other hand, and the offset of the shoulder in another row
        let mut other = rows.clone();
        other.iter_mut().for_each(|row| (row[0], row[1]) = (-row[0], -row[1]));
        (other[1][3], other[3][3]) = (rows[3][3], 0.0);
        assert_eq!(of("dh", &other), None, "{name}");
        // modified parameters: twist and length of the row before
        let mut modified = rows.clone();
        for i in 0..6 {
            [modified[i][0], modified[i][1]] = if i == 0 { [0.0; 2] } else { [rows[i - 1][0], rows[i - 1][1]] };
        }
        assert_eq!(of("mdh", &modified), None, "{name}");
        slips(name, &rows, of);
    }
    // arms of other makers
    let others: Vec<String> = screw_axes()
        .iter()
        .map(|(name, robot)| {
            let axes = toml::Table::from_iter([("joint".to_owned(), robot["poe"].clone())]);
            let flange = ["flange_xyz_mm", "flange_rpy_deg"].map(|key| format!("{key} = {}\n", robot[key])).concat();
            let text = format!("name = \"arm\"\nmodel = \"serial\"\nconvention = \"poe\"\n{flange}{axes}");
            format!("{name} {}", difference(&scratch, &text).unwrap_or_default())
        })
        .collect();
    let angle =
        ["irb120", "kr6-r900-sixx", "lrmate-200ic", "tx60", "m1013"].map(|name| format!("{name} structure-angle"));
    assert_eq!(others, angle);
}

/// Slips in the table of an arm.
fn slips(name: &str, rows: &[[f64; 4]], of: impl Fn(&str, &[[f64; 4]]) -> Option<String>) {
    let changed = |change: &dyn Fn(&mut Vec<[f64; 4]>)| {
        let mut rows = rows.to_vec();
        change(&mut rows);
        of("dh", &rows)
    };
    let is = |id: &str| Some(id.to_owned());
    assert_eq!(of("mdh", rows), is("structure-angle"), "{name}: standard parameters as modified ones");
    assert_eq!(changed(&|rows| rows.swap(0, 1)), is("structure-angle"), "{name}: rows exchanged");
    assert_eq!(changed(&|rows| rows[3][0] = 0.0), is("structure-angle"), "{name}: a twist left out");
    assert_eq!(changed(&|rows| rows[1][1] /= 1000.0), is("structure-no-link"), "{name}: metres");
    assert_eq!(changed(&|rows| rows[3][1] = 80.0), is("structure-apart"), "{name}: a length in the row below");
    assert_eq!(changed(&|rows| rows[4][3] = 0.0), is("structure-wrist-meets"), "{name}: a spherical wrist");
    assert_eq!(changed(&|rows| rows[3][3] = 0.0), is("structure-wrist-in-plane"), "{name}: no offset of the shoulder");
}

/// Default calibration of a UR5e in ur_description (`config/ur5e/default_kinematics.yaml`): xyz (m) and rpy (rad) of each joint.
const UR5E: [[&str; 2]; 6] = [
    ["0 0 0.1625", "0 0 0"],
    ["0 0 0", "1.570796327 0 0"],
    ["-0.425 0 0", "0 0 0"],
    ["-0.3922 0 0.1333", "0 0 0"],
    ["0 -0.0997 0", "1.570796327 0 0"],
    ["0 0.0996 0", "1.570796326589793 3.141592653589793 3.141592653589793"],
];

#[test]
fn a_universal_robots_arm_is_known_as_a_urdf() {
    let scratch = Scratch::with(&[]);
    // sound: as published, and with joints that turn about other axes of their frames; slip: a forearm in the wrong direction
    let cases = [("0 0 1", "-0.425 0 0", None), ("0 0 -1", "-0.425 0 0", None)];
    for (axis, forearm, expected) in cases.into_iter().chain([("0 0 1", "0 0 -0.425", Some("structure-no-link"))]) {
        let mut urdf = "<robot name=\"ur\"><link name=\"l0\"/>".to_owned();
        for (i, [xyz, rpy]) in UR5E.into_iter().enumerate() {
            let xyz = if i == 2 { forearm } else { xyz };
            urdf += &format!(
                "<link name=\"l{}\"/><joint name=\"j{i}\" type=\"revolute\"><parent link=\"l{i}\"/><child link=\"l{}\"/>\
                 <origin xyz=\"{xyz}\" rpy=\"{rpy}\"/><axis xyz=\"{axis}\"/>\
                 <limit lower=\"-6\" upper=\"6\" effort=\"9\" velocity=\"3\"/></joint>",
                i + 1,
                i + 1
            );
        }
        std::fs::write(scratch.path().join("ur.urdf"), urdf + "</robot>").unwrap();
        let robot = "name = \"arm\"\nmodel = \"urdf\"\nfile = \"ur.urdf\"\nbase_link = \"l0\"\ntool_link = \"l6\"\n";
        assert_eq!(difference(&scratch, robot).as_deref(), expected, "{axis} {forearm}");
    }
}

#[test]
fn an_export_for_universal_robots_names_an_arm_of_another_maker() {
    let root = root();
    for (file, named) in [("docs/keys/robot-serial-dh.toml", false), ("samples/abb-irb120/robot.toml", true)] {
        let file = root.join(file);
        let robot = read_robot(&file).unwrap().build(&["tool".to_owned()]).unwrap();
        let scratch = Scratch::with(&[]);
        let found = parameters(&scratch, robot.as_ref(), &disturbed(robot.as_ref(), &[]));
        let (file, to) = (file.display().to_string(), scratch.path().display().to_string());
        let (code, said) = etalon(&["export", &found, "--format", "universal-robots", "--robot", &file, "--to", &to]);
        assert_eq!(code, Some(0), "{said}");
        assert_eq!(said.contains("warning[file-of-other-structure]"), named, "{said}");
        let text = std::fs::read_to_string(scratch.path().join("universal_robots_calibration.yaml")).unwrap();
        assert_eq!(text.contains("# the axes of this arm differ from Universal Robots arms"), named, "{text}");
        // other formats of six axes hold any arm
        let (_, said) = etalon(&["export", &found, "--format", "linuxcnc", "--robot", &file, "--to", &to]);
        assert!(!said.contains("file-of-other-structure"), "{said}");
    }
}

/// Frames of the joints in the maker's description, by its Denavit-Hartenberg table: link i - 1, then d of joint i.
fn makers_frames(rows: &[[f64; 4]]) -> Vec<Pose> {
    let mut link = Pose::identity();
    let frame = |[alpha, a, _, d]: &[f64; 4]| {
        let frame = link.shift(2, *d);
        link = Pose::identity().shift(0, *a).turn_x(alpha.to_radians());
        frame
    };
    rows.iter().map(frame).collect()
}

/// Frames of the joints in a calibration.
fn written_frames(yaml: &str) -> Vec<Pose> {
    let numbers: Vec<f64> =
        yaml.lines().filter_map(|line| line.strip_prefix("    ")?.split_once(": ")?.1.parse().ok()).collect();
    numbers
        .chunks_exact(6)
        .map(|f| Pose::from_xyz_rpy([f[0], f[1], f[2]].map(|m| 1000.0 * m), [f[3], f[4], f[5]]))
        .collect()
}

/// An arm on a pedestal, in the world of the pedestal: the file has the frames of the maker's own description, and the header where its base is.
#[test]
fn a_universal_robots_file_has_the_frames_of_the_maker_wherever_the_arm_stands() {
    let scratch = Scratch::with(&[]);
    let mount = Pose::from_xyz_rpy([120.0, -80.0, 900.0], [0.0, 0.0, std::f64::consts::FRAC_PI_2]);
    for (name, rows) in tables_of_the_maker() {
        let (mut pose, mut axes) = (mount, Vec::new());
        for (frame, slide) in makers_frames(&rows).iter().zip([40.0, -700.0, 0.0, 1300.0, 12.0, -50.0]) {
            pose = pose.then(frame);
            let point = pose.shift(2, slide).translation_mm;
            axes.push(format!("{{ direction = {:?}, point_mm = {point:?} }}", pose.axis(2)));
        }
        let rpy_deg = pose.rpy_rad().map(f64::to_degrees);
        let text = format!(
            "model = \"serial\"\nconvention = \"poe\"\nflange_xyz_mm = {:?}\nflange_rpy_deg = {rpy_deg:?}\njoint = [{}]\n",
            pose.translation_mm,
            axes.join(", ")
        );
        let path = scratch.path().join("mounted.toml");
        std::fs::write(&path, text).unwrap();
        let robot = read_robot(&path).unwrap().build(&["tool".to_owned()]).unwrap();
        let values = disturbed(robot.as_ref(), &[]);
        for values in [robot.nominal(), values] {
            let found: ParametersDocument =
                serde_json::from_slice(&std::fs::read(parameters(&scratch, robot.as_ref(), &values)).unwrap()).unwrap();
            let given = ExportInput { robot: Some(robot.as_ref()), ..ExportInput::parameters(&found) };
            let yaml = controllers::by_name("universal-robots").unwrap().write(&given).unwrap();
            let yaml = String::from_utf8(yaml).unwrap();
            assert!(yaml.contains("# frame: base of the maker"), "{yaml}");
            let nominal = values == robot.nominal();
            for (written, maker) in written_frames(&yaml).iter().zip(makers_frames(&rows)) {
                let moved = maker.inverse().then(written);
                let off = norm(moved.translation_mm).max(1000.0 * moved.angle_rad());
                assert!(off < if nominal { 1e-6 } else { 60.0 }, "{name}: {off}, {yaml}");
            }
            // the shoulder is above the base of the maker, whatever was identified
            let shoulder = written_frames(&yaml)[0];
            assert!(shoulder.translation_mm[..2] == [0.0; 2] && shoulder.axis(2) == [0.0, 0.0, 1.0], "{yaml}");
            let mut noise = etalon::base::noise::Noise::new(59, 4);
            for _ in 0..10 {
                let q: Vec<f64> = (0..6).map(|_| noise.uniform(2.5)).collect();
                let reached = robot.kinematics().unwrap().tool_pose(&values, &q).unwrap();
                let moved = reached.inverse().then(&universal_robots(&yaml, &q));
                assert!(norm(moved.translation_mm) < 1e-7 && moved.angle_rad() < 1e-9, "{name}: {moved:?}, {yaml}");
            }
        }
    }
}

#[test]
fn genserkins_has_the_axes_of_the_identified_arm() {
    let root = root();
    // with errors, and without: parallel axes have no common normal of their own
    for (file, errors) in [
        ("samples/abb-irb120/robot.toml", true),
        ("samples/abb-irb120/robot.toml", false),
        ("docs/keys/robot-serial-dh.toml", true),
    ] {
        let file = root.join(file);
        let robot = read_robot(&file).unwrap().build(&["tool".to_owned()]).unwrap();
        let values = if errors { disturbed(robot.as_ref(), &[]) } else { robot.nominal() };
        let scratch = Scratch::with(&[]);
        let found = parameters(&scratch, robot.as_ref(), &values);
        let (file, to) = (file.display().to_string(), scratch.path().display().to_string());
        let (code, said) = etalon(&["export", &found, "--format", "linuxcnc", "--robot", &file, "--to", &to]);
        assert_eq!(code, Some(0), "{said}");
        let text = std::fs::read_to_string(scratch.path().join("genserkins.hal")).unwrap();
        // what genserkins does not have is said, with its consequence
        assert!(said.contains("warning[linuxcnc-joint-offsets]") && text.contains("# NOT IN GENSERKINS"), "{said}");
        assert!(!errors || said.contains("warning[linuxcnc-distant-normal]"), "{said}");
        assert!(text.contains("# frame: the world of LinuxCNC is the first frame"), "{text}");
        assert!(text.lines().all(|l| l.starts_with("# ") || l.starts_with("setp genserkins.")), "{text}");
        let mut noise = etalon::base::noise::Noise::new(19, 4);
        for _ in 0..20 {
            let q: Vec<f64> = (0..6).map(|_| noise.uniform(2.5)).collect();
            let reached = genserkins(&text, &q);
            let off = norm(minus(reached.translation_mm, robot.position(&values, &q, 0)));
            assert!(off < 1e-9, "{off}: {text}");
        }
    }
}

/// A robot that a format holds.
fn robot_of(format: &str) -> &'static str {
    match format {
        "urdf" => "samples/column-arm/robot.toml",
        "linuxcnc-hexapod" => "samples/hexapod/robot.toml",
        "linuxcnc-delta" | "klipper-delta" | "reprap-delta" => "docs/keys/robot-delta_linear.toml",
        "reprap-five-bar" => "samples/dextar/robot.toml",
        "galil" => "samples/prexyt-cmm/robot.toml",
        _ => "samples/abb-irb120/robot.toml",
    }
}

/// Error of one measured point of a target.
fn point_error(target: &str) -> PointError {
    let error = serde_json::json!({
        "set": "calibration", "pose": 1, "cycle": 1, "target": target, "at_mm": [300.0, 0.0, 500.0],
        "before_mm": [0.3, 0.0, 0.4], "after_mm": [0.03, 0.0, 0.04], "before_deg": null, "after_deg": null
    });
    serde_json::from_value(error).unwrap()
}

/// What a format writes of its robot with nominal parameters, for a campaign and a robot of these names.
fn written(format: &str, campaign: &str, robot_name: &str) -> Vec<u8> {
    let scratch = Scratch::with(&[]);
    let file = root().join(robot_of(format));
    let file = read_robot(&file).unwrap();
    let robot = file.build(&["tool".to_owned()]).unwrap();
    let found = parameters(&scratch, robot.as_ref(), &robot.nominal());
    let found: ParametersDocument = serde_json::from_str(&std::fs::read_to_string(found).unwrap()).unwrap();
    let summary = serde_json::json!({
        "name": campaign, "robot": null, "synthetic": null, "notes": null, "date": "2026-03-02", "operator": null,
        "instrument": "CMM", "expanded_uncertainty_um": 2.7, "coverage_factor": 2.0, "contact": null, "temperature_c": 20.0
    });
    let summary: CampaignSummary = serde_json::from_value(summary).unwrap();
    let given = ExportInput {
        summary: Some(&summary),
        name: Some(robot_name),
        robot: Some(robot.as_ref()),
        description: file.description().map(|(file, text)| Description { file, text }),
        errors: Some(&[point_error(robot_name)]),
        ..ExportInput::parameters(&found)
    };
    controllers::by_name(format).unwrap().write(&given).unwrap_or_else(|problems| panic!("{format}: {problems}"))
}

/// Letters of arrays have more than one byte.
fn letters(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).replace('\0', "")
}

#[test]
fn every_format_begins_with_version_campaign_robot_units_and_hash() {
    for format in controllers::names() {
        let text = letters(&written(format, "Spring check 3", "Arm 7"));
        // tables have the same as columns, arrays anywhere
        let anywhere = ["csv", "numpy", "mat"].contains(&format);
        let head: String = text.chars().take(if anywhere { usize::MAX } else { 1800 }).collect();
        assert!(head.contains("etalon") && head.contains(env!("CARGO_PKG_VERSION")), "{format}: {head}");
        assert!(head.contains("Spring check 3") && head.contains("Arm 7"), "{format}: {head}");
        assert!([" mm", "\"mm\"", ",mm,", "units: "].iter().any(|unit| head.contains(unit)), "{format}: {head}");
        let words = |text: &str| -> Vec<String> {
            text.split(|c: char| !c.is_ascii_alphanumeric()).map(str::to_lowercase).collect()
        };
        let hash = |word: &String| word.get(..64).is_some_and(|hash| hash.chars().all(|c| c.is_ascii_hexdigit()));
        assert!(words(&head).iter().any(hash), "{format}: {head}");
        assert!(!words(&text).iter().any(|word| ["nan", "inf", "infinity"].contains(&word.as_str())), "{format}");
    }
}

/// A name that ends comments, strings and lines of every language is the same with `_` in their places; the files are sound with signs that a
/// header writes out, too.
#[test]
fn names_end_no_comment_and_no_string() {
    let hostile = "x */ --> *) ]]> \"\"\" ''' # // \\ ${y} \n\rEND_VAR\u{202e}\u{e9} ??/";
    let safe = |c: char| if c.is_ascii_alphanumeric() || " .,-_:()=+".contains(c) { c } else { '_' };
    let harmless: String = hostile.chars().map(safe).collect();
    let folder = tempfile::tempdir().unwrap();
    for format in controllers::names() {
        let [as_named, as_harmless] = [hostile, &harmless].map(|name| written(format, name, name));
        let with_signs = format!("{hostile} ; `z` %}}");
        std::fs::write(folder.path().join(format), written(format, &with_signs, &with_signs)).unwrap();
        match format {
            "json" => {
                let read: serde_json::Value = serde_json::from_slice(&as_named).unwrap();
                assert_eq!([&read["campaign"], &read["name"]], [hostile, hostile]);
            }
            "csv" => {
                let mut reader = csv::Reader::from_reader(&as_named[..]);
                assert!(reader.records().all(|row| [7, 8].iter().all(|&i| row.as_ref().unwrap()[i] == *hostile)));
            }
            // the robot is an element of a certificate
            "dcc" | "qif" => {
                let tags = |bytes: &[u8]| bytes.iter().filter(|byte| [b'<', b'>'].contains(byte)).count();
                assert_eq!(tags(&as_named), tags(&as_harmless), "{format}");
            }
            _ => assert!(as_named == as_harmless, "{format}: {}", letters(&as_named)),
        }
    }
    let script = "import ast, xml.etree.ElementTree as E\n\
                  for name in ['urdf', 'plcopen', 'dcc', 'qif', 'twincat']: E.parse(name)\n\
                  for name in ['python', 'python-kinematics']: ast.parse(open(name).read())\n";
    match Command::new("python3").args(["-c", script]).current_dir(folder.path()).output() {
        Ok(output) => assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr)),
        Err(_) => crate::support::skipped("python3"),
    }
    for (format, kind) in [("c-header", "c-header"), ("c-kinematics", "c")] {
        let flags = ["-fsyntax-only", "-Wall", "-Wextra", "-Werror", "-x", kind, format];
        match Command::new("cc").args(flags).current_dir(folder.path()).output() {
            Ok(output) => assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr)),
            Err(_) => crate::support::skipped("cc"),
        }
    }
}

/// Coordinates (mm) of all points of topics that begin with `start`, by topic.
fn recorded(bytes: &[u8], start: &str) -> BTreeMap<String, Vec<[f64; 3]>> {
    let mut points = BTreeMap::<String, Vec<[f64; 3]>>::new();
    for message in mcap::MessageStream::new(bytes).unwrap() {
        let message = message.unwrap();
        let Some(target) = message.channel.topic.strip_prefix(start) else { continue };
        assert_eq!(message.channel.schema.as_ref().unwrap().name, "geometry_msgs/msg/PointStamped");
        // three numbers behind the header, to the end
        let numbers = message.data.last_chunk::<24>().unwrap();
        let metres = |i: usize| f64::from_le_bytes(numbers[8 * i..][..8].try_into().unwrap());
        points.entry(target.to_owned()).or_default().push([0, 1, 2].map(|i| metres(i) * 1e3));
    }
    points
}

#[test]
fn a_recording_has_the_errors_of_the_report() {
    let scratch = copy_sample("column-arm");
    let folder = scratch.path();
    let (code, said) = etalon(&["run", folder.to_str().unwrap()]);
    assert!(code != Some(2), "{said}");
    let [robot, parameters] = ["robot.toml", "out/parameters.json"].map(|file| folder.join(file).display().to_string());
    let (code, said) = etalon(&["export", &parameters, "--robot", &robot, "--format", "mcap"]);
    assert_eq!(code, Some(0), "{said}");
    let bytes = std::fs::read(folder.join("out/measured.mcap")).unwrap();
    let (measured, predicted) = (recorded(&bytes, "/measured/"), recorded(&bytes, "/predicted/"));
    let errors = measured.iter().flat_map(|(target, points)| points.iter().zip(&predicted[target]));
    let errors: Vec<f64> = errors.map(|(a, b)| norm(minus(*a, *b))).collect();
    let text = std::fs::read_to_string(folder.join("out/accuracy.json")).unwrap();
    let accuracy: AccuracyDocument = serde_json::from_str(&text).unwrap();
    let positions = accuracy.sets.iter().map(|set| {
        let error = set.errors.iter().find(|e| e.quantity == ErrorQuantity::Position).unwrap();
        (error.count as f64, error.after.rms)
    });
    let (count, squares) = positions.fold((0.0, 0.0), |(n, s), (count, rms)| (n + count, s + count * rms * rms));
    assert_eq!(errors.len() as f64, count);
    assert!((rms(errors.iter().copied()) / (squares / count).sqrt() - 1.0).abs() < 1e-9);
}

/// The centre of a platform is called `C`, and is in the base; a target of this name is in the world.
#[test]
fn a_target_of_any_name_is_recorded_in_the_world() {
    let scratch = copy_sample("probe-poses");
    let folder = scratch.path();
    scratch.replace("observations.csv", ",probe,", ",C,");
    let (code, said) = etalon(&["run", folder.to_str().unwrap()]);
    assert!(code != Some(2), "{said}");
    let [robot, parameters] = ["robot.toml", "out/parameters.json"].map(|file| folder.join(file).display().to_string());
    for with_robot in [&["--robot", &robot][..], &[]] {
        let (code, said) = etalon(&[&["export", &parameters, "--format", "mcap"][..], with_robot].concat());
        assert_eq!(code, Some(0), "{said}");
        let bytes = std::fs::read(folder.join("out/measured.mcap")).unwrap();
        let mut points = 0;
        for message in mcap::MessageStream::new(&bytes).unwrap().map(Result::unwrap) {
            if message.channel.topic == "/measured/C" {
                // behind encapsulation and time: length and text of the frame
                let length = u32::from_le_bytes(message.data[12..16].try_into().unwrap()) as usize;
                assert_eq!(&message.data[16..16 + length], b"world\0");
                points += 1;
            }
        }
        assert!(points > 0);
    }
}

#[test]
fn a_recording_without_measured_points_is_refused() {
    let scratch = Scratch::with(&[]);
    let file = read_robot(&root().join("samples/column-arm/robot.toml")).unwrap();
    let robot = file.build(&["tool".to_owned()]).unwrap();
    let found = parameters(&scratch, robot.as_ref(), &robot.nominal());
    let (code, said) = etalon(&["export", &found, "--format", "mcap"]);
    assert!(code == Some(2) && said.contains("[positions-not-measured]"), "{said}");
}
