//! Residual fields of whole campaigns: an arm that bends, calibrated by a model without bending. Synthetic.

use crate::support::said::Says;
use crate::support::scratch::{Scratch, copy_sample, ends, said};
use crate::support::tracker::{self, Reflectors};
use serde_json::Value;
use std::process::Command;

/// A simulated campaign of an arm of which joints 2 and 3 may bend, whose robot.toml states no bending and whose identification asks for
/// a field. The first 60 poses calibrate.
fn campaign(bends: bool) -> Scratch {
    let scratch = tracker::campaign(Reflectors::Before, 80, bends);
    let (code, said) = said(&scratch, &["simulate", "campaign"]);
    assert_eq!(code, Some(0), "{said}");
    if bends {
        scratch.replace("robot.toml", "bending = [2, 3]\n", "");
    }
    scratch.replace(
        "campaign.toml",
        "calibration = \"all\"\n",
        "calibration = \"1-60\"\nvalidation = \"rest\"\nfield = true\n",
    );
    scratch
}

fn json(scratch: &Scratch, file: &str) -> Value {
    serde_json::from_slice(&std::fs::read(scratch.path().join(file)).unwrap()).unwrap()
}

/// Root mean square position error of the validation poses, before and after.
fn validation(accuracy: &Value) -> [f64; 2] {
    let sets = accuracy["sets"].as_array().unwrap();
    let of = sets.iter().find(|set| set["name"] == "validation").unwrap();
    ["before", "after"].map(|key| of["errors"][0][key]["rms"].as_f64().unwrap())
}

fn answer(scratch: &Scratch, arguments: &[&str]) -> (Option<i32>, String, String) {
    let output = Command::new(crate::support::program()).args(arguments).current_dir(scratch.root()).output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (output.status.code(), text(output.stdout), text(output.stderr))
}

const JUDGE: [&str; 4] = ["validate", "campaign", "--parameters", "campaign/out/parameters.json"];

#[test]
fn a_field_describes_bending_that_the_model_lacks() {
    let scratch = campaign(true);
    let (code, stderr) = said(&scratch, &["run", "campaign"]);
    assert!(code < Some(2), "{stderr}");
    let accuracy = json(&scratch, "out/accuracy.json");
    assert_eq!(accuracy["field"]["accepted"], true, "{} {stderr}", accuracy["field"]);
    let held = &accuracy["field"]["held_out"];
    let [without, with] = ["without_mm", "with_mm"].map(|key| held[key].as_f64().unwrap());
    assert!(with < 0.5 * without, "{without} {with}");

    // poses in no order of a joint
    assert!(!stderr.says("[field-follows-order]"), "{stderr}");
    // the report names where the field holds, and is written again from the documents
    let report = std::fs::read_to_string(scratch.path().join("out/report.html")).unwrap();
    assert!(report.contains("id=\"field\"") && report.contains("field-held-out"));

    // poses of the same campaign that were not used: better with the field, and judged by validate
    let [_, plain] = validation(&accuracy);
    let (code, stdout, stderr) =
        answer(&scratch, &[&JUDGE[..], &["--field", "campaign/out/field.json", "--json"]].concat());
    assert!(code < Some(2), "{stderr}");
    let [_, corrected] = validation(&serde_json::from_str(&stdout).unwrap());
    assert!(corrected < 0.6 * plain, "{plain} {corrected}");

    // with a narrower range the poses beyond are counted
    let mut narrow = json(&scratch, "out/field.json");
    narrow["components"][0]["inputs"][0]["range"] = serde_json::json!([0.0, 10.0]);
    std::fs::write(scratch.root().join("narrow.json"), narrow.to_string()).unwrap();
    let (_, _, stderr) = answer(&scratch, &[&JUDGE[..], &["--field", "narrow.json"]].concat());
    assert!(stderr.says("[poses-beyond-field] total=80"), "{stderr}");

    compensates(&scratch);
    code_agrees(&scratch);

    // a field belongs to its parameters
    scratch.replace("out/parameters.json", "\"schema\"", " \"schema\"");
    let run: Vec<&str> = [&JUDGE[..], &["--field", "campaign/out/field.json"]].concat();
    std::fs::copy(scratch.path().join("out/field.json"), scratch.root().join("field.json")).unwrap();
    std::fs::copy(scratch.path().join("out/parameters.json"), scratch.root().join("other.json")).unwrap();
    assert_eq!(answer(&scratch, &run).0, Some(2));
    let (code, _, stderr) =
        answer(&scratch, &["validate", "campaign", "--parameters", "other.json", "--field", "field.json"]);
    assert!(code == Some(2) && stderr.says("[field-of-other-parameters]"), "{stderr}");
}

#[test]
fn the_sample_has_a_field_of_what_its_model_leaves_out() {
    let scratch = copy_sample("field-arm");
    let files = ["exports/poses.txt", "exports/world.txt", "encoders.csv"];
    let read = || files.map(|file| std::fs::read_to_string(scratch.path().join(file)).unwrap());
    let before = read();
    ends(&scratch, "simulate", 0, &[]);
    assert!(read() == before, "other files than those of the sample");
    ends(&scratch, "run", 0, &["[residuals-exceed-uncertainty]"]);
    let field = json(&scratch, "out/field.json");
    // the encoders of joints 1 and 4 err twice a turn; their zeros are parameters
    for (k, amplitude_deg) in [(0, 0.02), (3, 0.03)] {
        let off = |q_deg: f64| {
            let mut q = [0.0; 6];
            q[k] = q_deg;
            let truth = amplitude_deg * (2.0 * q_deg).to_radians().sin();
            joint_error(&field, &format!("q{}_deg", k + 1), &q) - truth
        };
        let off: Vec<f64> = (-14..=14).map(|i| off(10.0 * f64::from(i))).collect();
        let mean = off.iter().sum::<f64>() / off.len() as f64;
        let largest = off.iter().map(|v| (v - mean).abs()).fold(0.0, f64::max);
        assert!(largest < 0.2 * amplitude_deg, "joint {}: {largest} of {amplitude_deg} deg", k + 1);
    }
    let [_, plain] = validation(&json(&scratch, "out/accuracy.json"));
    let document = |arguments: &[&str]| -> Value { serde_json::from_str(&answer(&scratch, arguments).1).unwrap() };
    let judged = document(&[&JUDGE[..], &["--field", "campaign/out/field.json", "--json"]].concat());
    let [_, corrected] = validation(&judged);
    // 20 µm a coordinate
    assert!(corrected < 0.05 && plain > 0.1, "{plain} {corrected}");
    // distances between the validation poses follow the field too
    let relative = |of: &Value| of["relative"]["all"]["after"]["rms"].as_f64().unwrap();
    let [without, with] = [document(&[&JUDGE[..], &["--json"]].concat()), judged].map(|document| relative(&document));
    assert!(with < 0.5 * without && with < 0.05, "{without} {with}");
}

/// A point of the sample with pose 21 read elsewhere: the field is refused, and the reading is named. A reading of 3 mm changes parameters by
/// several standard uncertainties, and is an error of its own; at 0.5 mm the field's own errors at held-out poses show it.
#[test]
fn a_wrong_point_is_not_absorbed_by_a_field() {
    for (off_mm, decides) in [(0.5, false), (3.0, true)] {
        let scratch = copy_sample("field-arm");
        let text = std::fs::read_to_string(scratch.path().join("exports/poses.txt")).unwrap();
        let line = text.lines().find(|line| line.starts_with("SMR_21,")).unwrap();
        let mut cells: Vec<String> = line.split(',').map(str::to_owned).collect();
        cells[1] = (cells[1].parse::<f64>().unwrap() + off_mm).to_string();
        scratch.replace("exports/poses.txt", line, &cells.join(","));
        let (_, said) = said(&scratch, &["run", "campaign"]);
        assert!(said.says("[field-refused]") && said.says("[outliers]"), "{said}");
        assert_eq!(said.says("[readings-decide]"), decides, "{off_mm}: {said}");
        let field = &json(&scratch, "out/accuracy.json")["field"];
        let reason = &field["reason_phrase"];
        let expected = if decides { "field-parameters-wrong" } else { "field-readings-suspect" };
        assert_eq!((&field["accepted"], &reason["id"]), (&false.into(), &expected.into()), "{off_mm}: {field}");
        if !decides {
            assert_eq!(reason["arguments"]["pose"], "21", "{reason}");
            let error_mm = reason["arguments"]["error_mm"].as_f64().unwrap();
            assert!((error_mm - off_mm).abs() < 0.1, "{error_mm} {off_mm}");
        }
        assert!(!scratch.path().join("out/field.json").exists());
    }
}

#[test]
fn a_field_over_poses_in_the_order_of_a_joint_says_so() {
    // a sound set-up, whose field is accepted, and one in which the tracker drifts by a millimetre
    for drift_mm in [0.0, 1.0] {
        let scratch = copy_sample("field-arm");
        let mut noise = etalon::base::noise::Noise::new(45, 1);
        let ranges = [160.0, 60.0, 60.0, 150.0, 110.0, 170.0];
        let mut poses: Vec<Vec<f64>> = (0..160).map(|_| ranges.iter().map(|r| noise.uniform(*r)).collect()).collect();
        poses[..120].sort_by(|a, b| a[0].total_cmp(&b[0]));
        let truth = std::fs::read_to_string(scratch.path().join("truth.toml")).unwrap();
        let drawn = truth.lines().find(|line| line.starts_with("drawn = ")).unwrap();
        scratch.replace("truth.toml", drawn, &format!("joints = {poses:?}"));
        ends(&scratch, "simulate", 0, &[]);
        let text = std::fs::read_to_string(scratch.path().join("exports/poses.txt")).unwrap();
        let drifted = text.lines().enumerate().map(|(i, line)| {
            let mut cells: Vec<String> = line.split(',').map(str::to_owned).collect();
            if let Some(Ok(x)) = cells.get(1).map(|x| x.parse::<f64>()) {
                cells[1] = (x + drift_mm * i.min(119) as f64 / 119.0).to_string();
            }
            cells.join(",") + "\n"
        });
        std::fs::write(scratch.path().join("exports/poses.txt"), drifted.collect::<String>()).unwrap();
        let (_, said) = said(&scratch, &["run", "campaign"]);
        let accepted = json(&scratch, "out/accuracy.json")["field"]["accepted"] == true;
        assert_eq!(said.says("[field-follows-order] joint=q1"), accepted, "{drift_mm}: {said}");
        assert!(accepted || drift_mm > 0.0 && said.says("[reference-moved]"), "{drift_mm}: {said}");
    }
}

/// Error of a joint by the definition in the document.
fn joint_error(field: &Value, joint: &str, q: &[f64]) -> f64 {
    let index = |name: &Value| field["joints"].as_array().unwrap().iter().position(|joint| joint == name).unwrap();
    let of_component = |component: &Value| -> f64 {
        let inputs = component["inputs"].as_array().unwrap();
        let of_centre = |centre: &Value| -> f64 {
            let along = |(input, at): (&Value, &Value)| {
                let scale = input["scale"].as_f64().unwrap() * component["radius"].as_f64().unwrap();
                ((q[index(&input["joint"])] - at.as_f64().unwrap()) / scale).powi(2)
            };
            let d = inputs.iter().zip(centre["at"].as_array().unwrap()).map(along).sum::<f64>().sqrt().min(1.0);
            centre["weight"].as_f64().unwrap() * (1.0 - d).powi(4) * (4.0 * d + 1.0)
        };
        component["centres"].as_array().unwrap().iter().map(of_centre).sum()
    };
    let all = field["components"].as_array().unwrap();
    all.iter().filter(|component| component["joint"] == joint).map(of_component).sum()
}

/// Targets inside and beyond the poses: the latter are named, and their commands fade to those without a field.
fn compensates(scratch: &Scratch) {
    let table = "pose,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg\nin,10,-20,15,5,30,0\nout,10,-20,170,5,30,0\n";
    std::fs::write(scratch.root().join("targets.csv"), table).unwrap();
    let options = [
        "compensate",
        "targets.csv",
        "--robot",
        "campaign/robot.toml",
        "--parameters",
        "campaign/out/parameters.json",
        "--json",
    ];
    let (_, plain, _) = answer(scratch, &options);
    let (code, with, stderr) = answer(scratch, &[&options[..], &["--field", "campaign/out/field.json"]].concat());
    assert!(code < Some(2) && stderr.says("[targets-beyond-field]"), "{stderr}");
    let joints = |text: &str, i: usize| -> Vec<f64> {
        let document: Value = serde_json::from_str(text).unwrap();
        document["targets"][i]["joints"].as_array().unwrap().iter().map(|q| q.as_f64().unwrap()).collect()
    };
    let off = |i: usize| joints(&plain, i).iter().zip(joints(&with, i)).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(off(0) > 1e-3, "{}", off(0));
    assert!(off(1) < 1e-9, "{}", off(1));
    let residual =
        |text: &str| serde_json::from_str::<Value>(text).unwrap()["targets"][0]["residual_mm"].as_f64().unwrap();
    assert!(residual(&with) < 1e-6, "{}", residual(&with));
}

/// The Python code computes the errors of the joints that the document states.
fn code_agrees(scratch: &Scratch) {
    let field = json(scratch, "out/field.json");
    let q = [10.0, -20.0, 15.0, 5.0, 30.0, 0.0];
    let columns: Vec<String> = (1..=6).map(|k| format!("q{k}_deg")).collect();
    let expected: Vec<f64> = q.iter().zip(&columns).map(|(q0, joint)| q0 + joint_error(&field, joint, &q)).collect();
    let program = format!("import etalon_field as f\nprint(*f.corrected({q:?}), f.share({q:?}))");
    let python =
        Command::new("python3").args(["-c", &program]).current_dir(scratch.path().join("out")).output().unwrap();
    let text = String::from_utf8(python.stdout).unwrap();
    let numbers: Vec<f64> = text.split_whitespace().map(|v| v.parse().unwrap()).collect();
    assert_eq!(numbers.len(), 7, "{}", String::from_utf8_lossy(&python.stderr));
    assert_eq!(numbers[6], 1.0);
    assert!(expected.iter().zip(&numbers).all(|(a, b)| (a - b).abs() < 1e-9), "{expected:?} {numbers:?}");

    // C gives the same
    let main = format!(
        "#include <stdio.h>\ndouble etalon_field(const double *, double *);\nint main(void) {{ double q[6] = {{ {} }}, c[6]; \
         double s = etalon_field(q, c); for (int k = 0; k < 6; k++) printf(\"%.17g \", c[k]); printf(\"%.17g\\n\", s); }}\n",
        q.map(|v: f64| format!("{v:?}")).join(", ")
    );
    let out = scratch.path().join("out");
    std::fs::write(scratch.root().join("main.c"), main).unwrap();
    let (source, binary) = (scratch.root().join("main.c"), scratch.root().join("field"));
    let mut cc = Command::new("cc");
    cc.args(["-std=c99", "-Wall", "-Werror", "-o"]).arg(&binary).arg(source).arg(out.join("etalon_field.c")).arg("-lm");
    assert!(cc.status().unwrap().success());
    let text = String::from_utf8(Command::new(binary).output().unwrap().stdout).unwrap();
    let of_c: Vec<f64> = text.split_whitespace().map(|v| v.parse().unwrap()).collect();
    assert!(of_c.iter().zip(&numbers).all(|(a, b)| (a - b).abs() < 1e-12), "{of_c:?} {numbers:?}");
}

#[test]
fn a_model_that_fits_leaves_no_field() {
    let scratch = campaign(false);
    ends(&scratch, "run", 0, &["[field-refused]"]);
    assert_eq!(json(&scratch, "out/accuracy.json")["field"]["accepted"], false);
    assert!(!scratch.path().join("out/field.json").exists());
}

#[test]
fn a_wrong_set_up_is_not_repaired_by_a_field() {
    let scratch = campaign(true);
    // joint 3 is logged with the opposite sign
    let log = std::fs::read_to_string(scratch.path().join("encoders.csv")).unwrap();
    let reversed = |line: &str| {
        let mut cells: Vec<String> = line.split(',').map(str::to_owned).collect();
        let column = cells.len() - 4;
        if let Ok(q) = cells[column].parse::<f64>() {
            cells[column] = (-q).to_string();
        }
        cells.join(",") + "\n"
    };
    std::fs::write(scratch.path().join("encoders.csv"), log.lines().map(reversed).collect::<String>()).unwrap();
    let (_, stderr) = said(&scratch, &["run", "campaign"]);
    assert!(!scratch.path().join("out/field.json").exists(), "{stderr}");
}
