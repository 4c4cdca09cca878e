//! Controller files of formats that leave identified parameters out: what they hold is as accurate as they say.

use super::{etalon, text};
use crate::support::arms::{SIX_AXES, serial};
use crate::support::controller_files::universal_robots;
use crate::support::said::Says;
use crate::support::scratch::Scratch;
use etalon::base::noise::Noise;
use etalon::base::pose::{Vector, minus, norm};
use etalon::robots::{Kinematics, Robot, Role, Serial};
use serde_json::Value;
use std::fmt::Write;
use std::path::Path;

const FORMATS: [&str; 6] = ["json", "csv", "c-header", "universal-robots", "linuxcnc", "c-kinematics"];
const CALIBRATION: usize = 60;
const VALIDATION: usize = 30;
/// Standard uncertainty of a coordinate, mm.
const U_MM: f64 = 0.01;
const SAMPLE_OF_FILE: &str = "universal_robots_calibration.yaml";

/// Measured positions by their joint values (deg).
struct Twin {
    folder: Scratch,
    poses: Vec<(Vec<f64>, Vector)>,
}

/// A six-axis arm.
struct Arm {
    /// What is added to the gains.
    gains: [f64; 6],
    /// Joint value (deg) at which zeros are right.
    homed_at: f64,
    /// Middle of all joints and how far they reach (deg), at calibration and validation poses.
    poses: [[f64; 2]; 2],
}

/// Simulated measurements of the arm.
fn twin(arm: &Arm) -> Twin {
    let robot = serial(&SIX_AXES, &["tool"], &[]);
    let mut noise = Noise::new(5, 0);
    let mut truth = robot.nominal();
    for (i, p) in robot.parameters().iter().enumerate() {
        truth[i] = match (p.role, p.name.strip_prefix("gain_"), p.quantity.unit()) {
            (Role::Base, _, "mm") => 800.0 + noise.uniform(100.0),
            (Role::Base, ..) => noise.uniform(0.3),
            (Role::Target, ..) => 60.0 + noise.uniform(40.0),
            (_, Some(joint), _) => 1.0 + arm.gains[joint.parse::<usize>().unwrap() - 1],
            (_, None, "mm") => p.nominal + noise.uniform(0.05),
            _ => p.nominal,
        };
    }
    for joint in 1..=6 {
        let place = |name: &str| robot.index(&format!("{name}_{joint}")).unwrap();
        truth[place("theta")] -= (truth[place("gain")] - 1.0) * arm.homed_at.to_radians();
    }
    let mut table = "pose,target,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm\n".to_owned();
    let mut poses = Vec::new();
    for pose in 0..CALIBRATION + VALIDATION {
        let [middle, reach] = arm.poses[usize::from(pose >= CALIBRATION)];
        let q: Vec<f64> = (0..6).map(|_| middle + noise.uniform(reach)).collect();
        let q_rad: Vec<f64> = q.iter().map(|q| q.to_radians()).collect();
        let at = robot.position(&truth, &q_rad, 0).map(|v| v + noise.gaussian(U_MM));
        let row: Vec<String> = q.iter().chain(&at).map(f64::to_string).collect();
        let _ = writeln!(table, "{},tool,{}", pose + 1, row.join(","));
        poses.push((q, at));
    }
    let mut drawing = "name = \"arm\"\nmodel = \"serial\"\n".to_owned();
    for [alpha, a, theta, d] in SIX_AXES {
        let _ =
            writeln!(drawing, "[[joint]]\nalpha_deg = {alpha:?}\na_mm = {a:?}\ntheta_deg = {theta:?}\nd_mm = {d:?}");
    }
    let campaign = format!(
        "name = \"arm\"\nrobot = \"robot.toml\"\ncontrollers = {FORMATS:?}\nsynthetic = \"drawn for a test\"\n\
         [instrument]\nname = \"tracker\"\nexpanded_uncertainty_um = {}\ncoverage_factor = 2\n\
         [observations]\nfile = \"observations.csv\"\n\
         [identify]\neffects = \"all\"\ncalibration = \"1-{CALIBRATION}\"\nvalidation = \"rest\"\n",
        2000.0 * U_MM
    );
    let files = [("campaign.toml", campaign.as_str()), ("robot.toml", &drawing), ("observations.csv", &table)];
    Twin { folder: Scratch::with(&files), poses }
}

fn json(folder: &Path, name: &str) -> Value {
    crate::support::document(&folder.join("out").join(name))
}

/// Values of the robot's parameters (mm, rad, 1) in a list of a document.
fn values(robot: &dyn Robot, list: &Value) -> Vec<f64> {
    let value = |name: &str| list.as_array().unwrap().iter().find(|v| v["name"] == name).unwrap()["value"].as_f64();
    robot.parameters().iter().map(|p| p.quantity.inward(value(&p.name).unwrap())).collect()
}

/// The number before "mm" behind these words.
fn stated(text: &str, words: &str) -> f64 {
    let line = text.lines().find(|line| line.contains("validation poses: nominal ")).expect("a line of errors");
    line.split_once(words).unwrap().1.trim().split(' ').next().unwrap().parse().unwrap()
}

fn rms(twin: &Twin, position: impl Fn(&[f64]) -> Vector) -> f64 {
    let squares = twin.poses[CALIBRATION..].iter().map(|(q, at)| {
        let q: Vec<f64> = q.iter().map(|q| q.to_radians()).collect();
        norm(minus(*at, position(&q))).powi(2)
    });
    (squares.sum::<f64>() / VALIDATION as f64).sqrt()
}

/// The recommended parameters are identified again for a format that does not hold all of them, like the parameters of a run.
#[test]
fn a_file_of_recommended_parameters_is_identified_again_like_that_of_a_run() {
    let gains = [1e-3, -1e-3, 1e-3, 1e-3, -1e-3, 1e-3];
    let twin = twin(&Arm { gains, homed_at: 60.0, poses: [[60.0, 60.0]; 2] });
    let folder = twin.folder.path();
    assert_eq!(etalon(&folder, &["run", "."]).status.code(), Some(0));
    let arguments =
        ["export", ".", "--parameters", "recommended", "--format", "universal-robots", "--to", "recommended"];
    let exported = etalon(&folder, &arguments);
    let said = text(&exported.stderr);
    assert!(exported.status.code() == Some(0) && !said.contains("controller-error-not-measured"), "{said}");
    let [run, recommended] =
        ["out", "recommended"].map(|of| std::fs::read_to_string(folder.join(of).join(SAMPLE_OF_FILE)).unwrap());
    assert!(recommended.contains("# identified again without: gain_"), "{recommended}");
    let [run_mm, recommended_mm] = [run, recommended].map(|yaml| stated(&yaml, "this file "));
    assert!((recommended_mm / run_mm - 1.0).abs() < 0.1, "{recommended_mm} {run_mm}");
}

/// Position of the target with the six joints of a calibration of Universal Robots, and these base and target.
fn position_by_file(robot: &Serial, yaml: &str, values: &[f64], q: &[f64]) -> Vector {
    let base = robot.base_in_world(values).unwrap();
    let target = robot.parameters().iter().zip(values).filter(|(p, _)| p.role == Role::Target).map(|(_, v)| *v);
    let target: Vec<f64> = target.collect();
    base.then(&universal_robots(yaml, q)).apply([target[0], target[1], target[2]])
}

#[test]
fn a_file_without_gains_is_as_accurate_as_it_says_and_better_than_nominal() {
    let gains = [1e-3, -1e-3, 1e-3, 1e-3, -1e-3, 1e-3];
    let twin = twin(&Arm { gains, homed_at: 60.0, poses: [[60.0, 60.0]; 2] });
    let (folder, robot) = (twin.folder.path(), serial(&SIX_AXES, &["tool"], &[]));
    let ran = etalon(&folder, &["run", "."]);
    assert_eq!(ran.status.code(), Some(0), "{}", text(&ran.stderr));
    let yaml = std::fs::read_to_string(folder.join("out").join(SAMPLE_OF_FILE)).unwrap();
    assert!(yaml.contains("# identified again without: gain_1, gain_2, gain_3, gain_4, gain_5"), "{yaml}");
    assert!(yaml.contains("ur_robot_driver reports a mismatch") && yaml.contains("ur_description reads"), "{yaml}");
    let [nominal, identified, file] = ["nominal ", "identified ", "this file "].map(|words| stated(&yaml, words));
    // the file read back, by an evaluation that shares nothing with it but base and target
    let document = json(&folder, "controllers.json");
    let entry = &document["files"][0];
    assert_eq!(entry["formats"], serde_json::json!(["universal-robots", "linuxcnc"]));
    let written = values(&robot, &entry["values"]);
    let read_back = rms(&twin, |q| position_by_file(&robot, &yaml, &written, q));
    assert!((read_back / file - 1.0).abs() < 0.02, "{read_back} {file}");
    assert!(identified < file && file < nominal, "{identified} {file} {nominal}");
    assert_eq!(format!("{file:.3}"), format!("{:.3}", entry["errors"][1]["written"]["rms_mm"].as_f64().unwrap()));
    // gains dropped without identifying again: worse than nominal
    let parameters = json(&folder, "parameters.json");
    let mut dropped = values(&robot, &parameters["parameters"]);
    for (value, p) in dropped.iter_mut().zip(robot.parameters()) {
        *value = if p.name.starts_with("gain_") { 1.0 } else { *value };
    }
    assert!(rms(&twin, |q| robot.position(&dropped, q, 0)) > nominal);
    // formats that hold gains have them
    let controller = json(&folder, "controller.json");
    for p in parameters["parameters"].as_array().unwrap() {
        assert_eq!(controller["parameters"][p["name"].as_str().unwrap()]["value"], p["value"]);
    }
    let code = std::fs::read_to_string(folder.join("out/etalon_kinematics.c")).unwrap();
    assert_eq!([stated(&code, "this file "), stated(&code, "nominal ")], [identified, nominal]);
    the_same_files_by_export(&folder);
    without_the_run(&twin, &robot, &entry["values"]);
}

/// `export` writes what `run` wrote.
fn the_same_files_by_export(folder: &Path) {
    let mut arguments = vec!["export", "out/parameters.json", "--robot", "robot.toml", "--to", "again", "--json"];
    arguments.extend(FORMATS.iter().flat_map(|format| ["--format", format]));
    let exported = etalon(folder, &arguments);
    assert_eq!(exported.status.code(), Some(0), "{}", text(&exported.stderr));
    let names: Vec<_> = std::fs::read_dir(folder.join("again")).unwrap().map(|e| e.unwrap().file_name()).collect();
    assert_eq!(names.len(), FORMATS.len());
    for name in names {
        let [run, export] = ["out", "again"].map(|of| std::fs::read(folder.join(of).join(&name)).unwrap());
        assert!(run == export, "{}", name.display());
    }
    let said: Value = serde_json::from_slice(&exported.stdout).unwrap();
    let document = json(folder, "controllers.json");
    let of = |format: &str| said["controllers"].as_array().unwrap().iter().find(|c| c["format"] == format).unwrap();
    assert_eq!(of("universal-robots")["errors"], document["files"][0]["errors"][1]);
    assert_eq!(of("json")["errors"]["written"], of("json")["errors"]["identified"]);
    let arguments = ["export", "out/parameters.json", "--robot", "robot.toml", "--to", "again", "--format"];
    let hash = ["universal-robots", "--controller-hash", "calib_123"];
    assert_eq!(etalon(folder, &[&arguments[..], &hash].concat()).status.code(), Some(0));
    let yaml = std::fs::read_to_string(folder.join("again").join(SAMPLE_OF_FILE)).unwrap();
    assert!(yaml.ends_with("  hash: calib_123\n") && !yaml.contains("mismatch"), "{yaml}");
    let other = etalon(folder, &[&arguments[..], &["json", "--controller-hash", "calib_123"]].concat());
    let said = text(&other.stderr);
    assert!(other.status.code() == Some(2) && said.contains("error[hash-of-other-format]"), "{said}");
}

/// Parameters alone are conditioned by their covariance: near what was identified again.
fn without_the_run(twin: &Twin, robot: &Serial, again: &Value) {
    let folder = twin.folder.path();
    std::fs::create_dir(folder.join("alone")).unwrap();
    std::fs::copy(folder.join("out/parameters.json"), folder.join("alone/parameters.json")).unwrap();
    let arguments = ["export", "alone/parameters.json", "--robot", "robot.toml", "--format", "universal-robots"];
    let exported = etalon(&folder, &arguments);
    assert!(exported.status.success() && text(&exported.stderr).contains("[controller-error-not-measured]"));
    let yaml = std::fs::read_to_string(folder.join("alone").join(SAMPLE_OF_FILE)).unwrap();
    assert!(yaml.contains("# conditioned on nominal values of: gain_1"), "{yaml}");
    let document = std::fs::read(folder.join("alone/parameters.json")).unwrap();
    let document: etalon::documents::ParametersDocument = serde_json::from_slice(&document).unwrap();
    let gains: Vec<&str> =
        robot.parameters().iter().map(|p| p.name.as_str()).filter(|n| n.starts_with("gain_")).collect();
    let identified: Vec<&str> = document.identified().map(|p| p.name.as_str()).collect();
    let gains: Vec<&str> = gains.into_iter().filter(|name| identified.contains(name)).collect();
    let conditioned = document.conditioned(&gains).unwrap();
    // with the gains held, residuals are larger, and nominal values weigh more than in the covariance of the document:
    // parameters differ where the data say little, positions do not
    let of = |document: &etalon::documents::ParametersDocument| {
        let written = serde_json::to_value(&document.parameters).unwrap();
        values(robot, &written)
    };
    let (before, conditioned) = (of(&document), of(&conditioned));
    let again = values(robot, again);
    let moved = rms(twin, |q| robot.position(&before, q, 0));
    let errors = [&conditioned, &again].map(|values| rms(twin, |q| robot.position(values, q, 0)));
    assert!(errors[0] < 1.1 * errors[1], "{errors:?} {moved}");
}

#[test]
fn a_file_that_is_worse_than_nominal_is_refused() {
    // gains matter at the calibration poses; zeros that take their place are wrong at the validation poses
    let gains = [0.0, 0.0, 0.0, 3e-3, 3e-3, 3e-3];
    let twin = twin(&Arm { gains, homed_at: 0.0, poses: [[60.0, 60.0], [0.0, 5.0]] });
    let folder = twin.folder.path();
    let ran = etalon(&folder, &["run", "."]);
    let said = text(&ran.stderr);
    assert_eq!(ran.status.code(), Some(1), "{said}");
    for words in ["[file-worse-than-nominal]", "gain_4", "--force"] {
        assert!(said.says(words), "{words}: {said}");
    }
    assert!(!folder.join("out").join(SAMPLE_OF_FILE).exists() && folder.join("out/controller.json").exists());
    let page = std::fs::read_to_string(folder.join("out/report.html")).unwrap();
    assert!(page.has_phrase("reservation-file-not-written") && page.contains("Controller files"));
    let arguments =
        ["export", "out/parameters.json", "--robot", "robot.toml", "--format", "universal-robots", "--force"];
    let refused = etalon(&folder, &arguments[..6]);
    assert!(refused.status.code() == Some(2) && text(&refused.stderr).contains("error[file-worse-than-nominal]"));
    assert_eq!(etalon(&folder, &arguments).status.code(), Some(0));
    let yaml = std::fs::read_to_string(folder.join("out").join(SAMPLE_OF_FILE)).unwrap();
    assert!(yaml.contains("NOT FIT FOR A CONTROLLER, written by force: "), "{yaml}");
    assert!(stated(&yaml, "this file ") > stated(&yaml, "nominal "));
}

/// A format of other robots is a mistake of campaign.toml, not a failed verdict of the robot.
#[test]
fn a_format_of_other_robots_is_rejected_before_anything_is_computed() {
    let scratch = crate::support::scratch::copy_sample("hexapod");
    let path = scratch.path().join("campaign.toml");
    let mut campaign: toml::Table = std::fs::read_to_string(&path).unwrap().parse().unwrap();
    for (format, is_suited) in [("linuxcnc", false), ("urdf", false), ("linuxcnc-hexapod", true)] {
        campaign.insert("controllers".to_owned(), vec![format].into());
        std::fs::write(&path, toml::to_string(&campaign).unwrap()).unwrap();
        for command in ["check", "run"] {
            let ended = etalon(scratch.root(), &[command, "campaign"]);
            let said = text(&ended.stderr);
            assert_eq!(ended.status.code(), Some(if is_suited { 0 } else { 2 }), "{command} {format}: {said}");
            assert_eq!(said.contains("error[format-for-other-robots]"), !is_suited, "{command} {format}: {said}");
        }
    }
}

/// Zeros make up for gains at the calibration poses, and miss on the other side at the validation poses.
#[test]
fn a_file_that_is_hardly_better_than_nominal_says_so() {
    let twin =
        twin(&Arm { gains: [0.0, 0.0, 0.0, 3e-3, 3e-3, 3e-3], homed_at: 0.0, poses: [[60.0, 60.0], [9.0, 5.0]] });
    let folder = twin.folder.path();
    let ran = etalon(&folder, &["run", "."]);
    let said = text(&ran.stderr);
    assert!(ran.status.code() == Some(0) && said.contains("warning[file-near-nominal]"), "{said}");
    let yaml = std::fs::read_to_string(folder.join("out").join(SAMPLE_OF_FILE)).unwrap();
    let [nominal, file] = ["nominal ", "this file "].map(|words| stated(&yaml, words));
    assert!(0.9 * nominal < file && file < nominal, "{yaml}");
    assert!(yaml.contains("# the position error is not clearly smaller than with nominal parameters"), "{yaml}");
    // formats that hold gains are not meant, and both formats share a warning
    let near = |messages: &Value| -> Vec<Value> {
        let all = messages.as_array().unwrap().iter().filter(|m| m["id"] == "file-near-nominal");
        all.map(|m| m["arguments"]["formats"].clone()).collect()
    };
    let document = json(&folder, "controllers.json");
    assert_eq!(near(&document["messages"]), [serde_json::json!(["universal-robots", "linuxcnc"])], "{document}");
    let code = std::fs::read_to_string(folder.join("out/etalon_kinematics.c")).unwrap();
    assert!(!code.contains("not clearly smaller"), "{code}");
    let arguments =
        ["export", "out/parameters.json", "--robot", "robot.toml", "--json", "--format", "json", "--format"];
    let exported = etalon(&folder, &[&arguments[..], &["linuxcnc"]].concat());
    assert_eq!(exported.status.code(), Some(0), "{}", text(&exported.stderr));
    let answer: Value = serde_json::from_slice(&exported.stdout).unwrap();
    let [whole, reduced] = [0, 1].map(|i| &answer["controllers"][i]["messages"]);
    assert!(whole.is_null() && near(reduced) == [serde_json::json!(["linuxcnc"])], "{answer}");
}

/// Parameters that only the format's own model would determine are held too: towers are upright, and legs equal.
#[test]
fn files_of_deltas_are_better_than_nominal_and_the_same_by_export() {
    let scratch = crate::support::scratch::copy_sample("linear-delta");
    let formats = ["linuxcnc-delta", "klipper-delta", "reprap-delta"];
    scratch.replace("campaign.toml", "[\"json\"]", &format!("{formats:?}"));
    let folder = scratch.path();
    let ran = etalon(&folder, &["run", "."]);
    // the best of these files leaves 0.18 mm, where all parameters meet the limit of 0.1 mm
    assert_eq!(ran.status.code(), Some(1), "{}", text(&ran.stderr));
    let verdict = json(&folder, "verdict.json");
    assert_eq!(verdict["judged_file"], "klipper_delta.cfg", "{verdict}");
    let mut arguments = vec!["export", "out/parameters.json", "--robot", "robot.toml", "--to", "again"];
    arguments.extend(formats.iter().flat_map(|format| ["--format", format]));
    assert_eq!(etalon(&folder, &arguments).status.code(), Some(0));
    for name in ["deltakins.hal", "klipper_delta.cfg", "reprap_delta.g"] {
        let [run, export] = ["out", "again"].map(|of| std::fs::read_to_string(folder.join(of).join(name)).unwrap());
        assert_eq!(run, export);
        assert!(stated(&run, "identified ") < stated(&run, "this file "), "{run}");
        assert!(stated(&run, "this file ") < stated(&run, "nominal "), "{run}");
        let lost = run.lines().filter(|line| line.contains("tower_") && !line.contains("again without"));
        assert_eq!(lost.count(), 0, "{run}");
    }
    // towers alone, and equal legs
    assert_eq!(json(&folder, "controllers.json")["files"].as_array().unwrap().len(), 2);
}

/// CRC-32 of a text bit by bit (ISO 3309, reflected polynomial EDB88320).
fn crc32(text: &str) -> u32 {
    let bit = |sum: u32| (sum >> 1) ^ if sum & 1 == 1 { 0xEDB8_8320 } else { 0 };
    !text.bytes().fold(!0, |sum, byte| (0..8).fold(sum ^ u32::from(byte), |sum, _| bit(sum)))
}

#[test]
fn a_template_holds_what_it_states_and_is_as_accurate_as_it_says() {
    const TEMPLATE: &str = "{# holds: theta_* #}\n{% for line in header %}\n; {{ line }}\n{% endfor %}\n{% set body %}\n\
        {% for p in parameters %}\n{{ p.name }}={{ p.value | fixed(9) }}\n{% endfor %}\n{% endset %}\n\
        {{ body }};{{ body | crc32 }}\n";
    // gains act as zeros where all joints stand near one value
    let twin = twin(&Arm { gains: [1e-3; 6], homed_at: 90.0, poses: [[0.0, 60.0]; 2] });
    let (folder, robot) = (twin.folder.path(), serial(&SIX_AXES, &["tool"], &[]));
    std::fs::write(folder.join("zeros.txt.j2"), TEMPLATE).unwrap();
    twin.folder.replace("campaign.toml", &format!("{FORMATS:?}"), "[\"json\", \"zeros.txt.j2\"]");
    let ran = etalon(&folder, &["run", "."]);
    assert_eq!(ran.status.code(), Some(0), "{}", text(&ran.stderr));
    let zeros = std::fs::read_to_string(folder.join("out/zeros.txt")).unwrap();
    let (body, sum) = zeros.trim_end().rsplit_once(';').unwrap();
    let body: String = body.lines().filter(|line| !line.starts_with(';')).map(|line| format!("{line}\n")).collect();
    assert_eq!(u32::from_str_radix(sum, 16), Ok(crc32(&body)), "{zeros}");
    // the file read back: its zeros, base and target identified with them, all else nominal
    let again = json(&folder, "controllers.json");
    let entry = &again["files"][0];
    assert_eq!(entry["formats"], serde_json::json!(["zeros.txt"]));
    let mut written = robot.nominal();
    let frames = values(&robot, &entry["values"]);
    for (i, p) in robot.parameters().iter().enumerate() {
        let of_file = body.lines().find_map(|line| line.strip_prefix(&format!("{}=", p.name))?.parse::<f64>().ok());
        written[i] = match p.role {
            Role::Robot => of_file.map_or(p.nominal, f64::to_radians),
            _ => frames[i],
        };
        assert_eq!(of_file.is_some(), p.name.starts_with("theta_"), "{}", p.name);
    }
    let [nominal, file] = ["nominal ", "this file "].map(|words| stated(&zeros, words));
    let read_back = rms(&twin, |q| robot.position(&written, q, 0));
    assert!((read_back / file - 1.0).abs() < 0.02 && file < nominal, "{read_back} {file} {nominal}");
    // the template is an input of the run
    let import = json(&folder, "import.json");
    let is_source = |s: &Value| s["file"] == "zeros.txt.j2" && s["kind"] == "template";
    assert!(import["sources"].as_array().unwrap().iter().any(is_source), "{import}");
    let arguments = ["export", "out/parameters.json", "--robot", "robot.toml", "--template", "zeros.txt.j2"];
    assert_eq!(etalon(&folder, &arguments).status.code(), Some(0));
    assert_eq!(std::fs::read_to_string(folder.join("out/zeros.txt")).unwrap(), zeros);
    // beside a run it replaces nothing
    std::fs::write(folder.join("zeros.txt"), "mine").unwrap();
    let refused = etalon(&folder, &[&arguments[..], &["--to", "."]].concat());
    assert!(refused.status.code() == Some(2) && text(&refused.stderr).contains("error[file-exists]"));
}

#[test]
fn names_of_all_files_of_a_run_are_reserved() {
    for sample in ["linear-delta", "pose-test", "prexyt-geometric"] {
        let scratch = crate::support::scratch::copy_sample(sample);
        assert!(etalon(&scratch.path(), &["run", "."]).status.code() < Some(2));
        let files = std::fs::read_dir(scratch.path().join("out")).unwrap();
        for name in files.map(|file| file.unwrap().file_name().into_string().unwrap()) {
            assert!(etalon::run::documents::is_file_of_run(&name), "{name}");
        }
    }
}
