//! Data that look sound and are not, or are sound and too many: refused by name, or read in time and memory that grow with them.

use crate::support::root;
use crate::support::said::Says;
use crate::support::scratch::{Scratch, copy_sample, ends, said};

/// Replaces a cell of a table: `line` and `column` count from 1; gives the value that was there.
fn replace_cell(scratch: &Scratch, file: &str, line: usize, column: usize, value: &str) -> String {
    let path = scratch.path().join(file);
    let text = std::fs::read_to_string(&path).unwrap();
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    let mut cells: Vec<&str> = lines[line - 1].split(',').collect();
    let before = std::mem::replace(&mut cells[column - 1], value).to_owned();
    lines[line - 1] = cells.join(",");
    std::fs::write(path, lines.join("\n") + "\n").unwrap();
    before
}

/// What each command says of a table of observations and its robot.toml.
fn refused_everywhere(scratch: &Scratch, robot: &str, table: &str, more: &[&str], parts: &[&str]) {
    let given = ["--robot", robot, "--standard-uncertainty-um", "50"];
    for command in [
        &["check", "campaign"][..],
        &["run", "campaign"],
        &["validate", "campaign"],
        &[&["identify", "--observations", table][..], &given].concat(),
    ] {
        let (code, said) = said(scratch, &[command, more].concat());
        assert_eq!(code, Some(2), "{command:?}: {said}");
        for part in parts {
            assert!(said.says(part), "{command:?} lacks {part:?}: {said}");
        }
    }
}

#[test]
fn a_joint_value_without_its_decimal_mark_is_named() {
    let scratch = copy_sample("draw-wire");
    assert_eq!(replace_cell(&scratch, "observations.csv", 192, 4, "-83776534"), "-83.776534");
    let parts = ["pose 48", "`q1` = -83776534 deg", "observations.csv:192", "from -720 to 720 deg", "decimal mark"];
    refused_everywhere(&scratch, "campaign/robot.toml", "campaign/observations.csv", &[], &parts);
    assert!(!scratch.path().join("out").exists());
    // the pose may be left out, with a reason
    let exclude = "exclude = [{ poses = \"48\", reason = \"decimal mark lost\" }]\n\n[limits]";
    scratch.replace("campaign.toml", "\n[limits]", exclude);
    ends(&scratch, "check", 0, &[]);
}

#[test]
fn ten_turns_too_many_are_named() {
    let scratch = copy_sample("draw-wire");
    replace_cell(&scratch, "observations.csv", 192, 4, "3516.223466");
    let parts = ["`q1` = 3516.2235 deg", "observations.csv:192"];
    refused_everywhere(&scratch, "campaign/robot.toml", "campaign/observations.csv", &[], &parts);
    // limits that allow them are believed
    let stated = "theta_deg = 0, d_mm = 290, limits_deg = [-3600, 3600]";
    scratch.replace("robot.toml", "theta_deg = 0, d_mm = 290", stated);
    ends(&scratch, "check", 0, &[]);
    scratch.replace("robot.toml", "[-3600, 3600]", "[-170, 170]");
    let parts = ["`q1` = 3516.2235 deg", "from -170 to 170 deg", "correct its limits"];
    refused_everywhere(&scratch, "campaign/robot.toml", "campaign/observations.csv", &[], &parts);
}

#[test]
fn a_joint_value_of_a_log_beyond_the_limits_of_a_urdf_is_named() {
    let scratch = copy_sample("column-arm");
    ends(&scratch, "run", 0, &[]);
    for (name, value, of) in [("elbow", "12.5", 2), ("lift", "8.5", 3), ("wrist_2", "42.5", 8)] {
        let scratch = copy_sample("column-arm");
        replace_cell(&scratch, "encoders.csv", 7, of, value);
        for command in ["check", "run", "validate"] {
            ends(&scratch, command, 2, &[&format!("`{name}` = "), "encoders.csv:7", "error[joint-out-of-range]"]);
        }
    }
    // the observations of the sound run, for `verify`
    let table = std::fs::read_to_string(scratch.path().join("out/observations.csv")).unwrap();
    let column = table.lines().next().unwrap().split(',').position(|name| name == "elbow_deg").unwrap() + 1;
    let verify = ["verify", "campaign/out/observations.csv", "--robot", "campaign/robot.toml", "--parameters"];
    let verify = [&verify[..], &["campaign/out/parameters.json"]].concat();
    assert_ne!(said(&scratch, &verify).0, Some(2));
    replace_cell(&scratch, "out/observations.csv", 5, column, "716.2");
    let (code, error) = said(&scratch, &verify);
    assert!(code == Some(2) && error.contains("`elbow` = 716.2 deg") && error.contains("csv:5"), "{error}");
}

#[test]
fn candidates_and_poses_to_compute_have_joint_values_in_range() {
    let scratch = copy_sample("draw-wire");
    let rows = |value: &str| {
        format!("pose,target,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg\n1,ball,1,2,3,4,5,6\n2,ball,{value},3,4,5,6,7\n")
    };
    for (value, sound) in [("12.5", true), ("-700", true), ("12500000", false), ("3612.5", false)] {
        std::fs::write(scratch.path().join("t.csv"), rows(value)).unwrap();
        let robot = ["campaign/t.csv", "--robot", "campaign/robot.toml"];
        let (code, error) = said(&scratch, &[&["kinematics", "direct"][..], &robot].concat());
        assert_eq!((code == Some(0), error.contains("`q1` = ")), (sound, !sound), "{value}: {error}");
        let plan = ["plan", "--robot", "campaign/robot.toml", "--candidates", "campaign/t.csv", "--positions", "1"];
        let (_, error) = said(&scratch, &plan);
        assert_eq!(error.contains("`q1` = ") && error.contains("t.csv:3"), !sound, "{value}: {error}");
    }
}

#[test]
fn joint_names_of_any_length_fit_into_a_drawing() {
    for length in [56, 200] {
        let scratch = copy_sample("column-arm");
        let name = "j".repeat(length);
        for file in ["arm.urdf", "robot.toml", "truth.toml", "encoders.csv"] {
            let path = scratch.path().join(file);
            let text = std::fs::read_to_string(&path).unwrap();
            std::fs::write(path, text.replace("shoulder_lift", &name)).unwrap();
        }
        scratch.replace("campaign.toml", "shoulder_lift", &name);
        let said = ends(&scratch, "run", 0, &[]);
        assert!(!said.contains("panic"), "{length}: {said}");
    }
}

#[test]
fn one_rounded_column_of_an_export_is_told() {
    let scratch = copy_sample("prexyt-cmm");
    let said = ends(&scratch, "check", 0, &[]);
    assert!(!said.contains("[coordinates-rounded]"), "{said}");
    let path = scratch.path().join("exports/poses.txt");
    let rounded = |line: &str| {
        let mut cells: Vec<String> = line.split_whitespace().map(str::to_owned).collect();
        cells[2] = format!("{:.1}", cells[2].parse::<f64>().unwrap());
        cells.join(" ") + "\n"
    };
    let text: String = std::fs::read_to_string(&path).unwrap().lines().map(rounded).collect();
    std::fs::write(&path, text).unwrap();
    ends(&scratch, "check", 0, &["warning[coordinates-rounded] file=exports/poses.txt", "(y to 0.1 mm)"]);
}

#[test]
fn counts_are_bounded_before_anything_is_allocated() {
    let scratch = copy_sample("draw-wire");
    let table = "pose,target,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg\n1,ball,1,2,3,4,5,6\n2,ball,9,3,4,5,6,7\n";
    std::fs::write(scratch.path().join("t.csv"), table).unwrap();
    let plan = ["plan", "--robot", "campaign/robot.toml", "--candidates", "campaign/t.csv", "--positions", "1"];
    for option in ["--starts", "--nodes"] {
        for count in ["18446744073709551615", "1000000000000"] {
            let (code, error) = said(&scratch, &[&plan[..], &[option, count]].concat());
            let named = [option, count, "expected a whole number from 0 to "].iter().all(|part| error.contains(part));
            assert!(code == Some(2) && named, "{option} {count}: {error}");
        }
    }
    let simulate = |from: &str, to: &str, parts: &[&str]| {
        let scratch = copy_sample("prexyt-geometric");
        scratch.replace("truth.toml", from, to);
        ends(&scratch, "simulate", 2, parts);
    };
    for count in ["1000000000", "9223372036854775807"] {
        let parts = ["truth.toml:", count, "is not a count from 0 to 1000000"];
        simulate("cycles = 5", &format!("cycles = {count}"), &parts);
        simulate("count = 36", &format!("count = {count}"), &parts);
        simulate("repeats = 5", &format!("repeats = {count}"), &parts);
    }
    let study = std::fs::read_to_string(root().join("samples/prexyt-cmm/study.toml")).unwrap();
    for (from, to, part) in [
        ("draws = 100", "draws = 9223372036854775807", "9223372036854775807 is not a count from 0 to 1000000"),
        ("runs = 5", "runs = 9223372036854775807", "9223372036854775807 is not a count from 0 to 1000000"),
        (
            "count = 1000 }",
            "count = 1000000 }",
            "error[counts-too-large] of=positions in `workspace` counts=3000000 poses",
        ),
        ("draws = 100", "draws = 1000000", "error[counts-too-large] of=calibrations counts=1000000 draws × 5 runs"),
    ] {
        let scratch = copy_sample("prexyt-cmm");
        assert!(study.contains(from), "{from}");
        std::fs::write(scratch.path().join("study.toml"), study.replace(from, to)).unwrap();
        let (code, error) = said(&scratch, &["study", "campaign/study.toml"]);
        assert!(code == Some(2) && error.says(part), "{to}: {error}");
    }
}

/// A campaign of an arm with three targets at 60 poses, and `more` that are measured at validation poses alone.
fn with_unplaced_targets(more: usize) -> Scratch {
    let scratch = copy_sample("draw-wire");
    let robot = etalon::campaign::read_robot(&scratch.path().join("robot.toml")).unwrap();
    let names: Vec<String> = (0..3).map(|k| format!("S{k}")).chain((0..more).map(|k| format!("V{k}"))).collect();
    let robot = robot.build(&names).unwrap();
    let mut values = robot.nominal();
    for (i, p) in robot.parameters().iter().enumerate().filter(|(_, p)| p.role == etalon::robots::Role::Target) {
        values[i] = 60.0 + 50.0 * (1.7 * i as f64 + p.name.len() as f64).sin();
    }
    let mut rows = "pose,target,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm\n".to_owned();
    for pose in 0..60 {
        let wave = |k: usize| 60.0 * (0.37 * (pose * (k + 3)) as f64 + 1.3 * k as f64).sin();
        let deg: Vec<f64> = (0..6).map(wave).collect();
        let joints: Vec<f64> = deg.iter().map(|q| q.to_radians()).collect();
        let own = (3..names.len()).filter(|k| pose >= 40 && k % 20 == pose - 40);
        for target in (0..3).chain(own) {
            let at = robot.position(&values, &joints, target);
            let noise = |axis: usize| 0.02 * (12.9 * (pose * 97 + target * 31 + axis * 7) as f64).sin();
            let at: Vec<String> = (0..3).map(|axis| format!("{:.5}", at[axis] + noise(axis))).collect();
            let deg: Vec<String> = deg.iter().map(|q| format!("{q:.12}")).collect();
            rows += &format!("{},{},{},{}\n", pose + 1, names[target], deg.join(","), at.join(","));
        }
    }
    std::fs::write(scratch.path().join("observations.csv"), rows).unwrap();
    scratch.replace("campaign.toml", "calibration = \"1-60\"", "calibration = \"1-40\"");
    // its points have no distances
    scratch.replace("campaign.toml", "distance_max_mm = 0.4", "position_max_mm = 0.4");
    scratch
}

#[test]
fn targets_of_validation_poses_alone_are_not_judged() {
    let said = ends(&with_unplaced_targets(7), "run", 0, &[]);
    let parts = ["[placed-by-validation-unjudged]: 7 targets ", ": `V0`, `V1`, `V2`, `V3`, `V4`, ..."];
    assert!(parts.iter().all(|part| said.says(part)), "{said}");
    assert!(!said.contains("another campaign") && !said.contains("without-effect]"), "{said}");
    // all others as without these targets
    let accuracy = |more: usize| -> serde_json::Value {
        let scratch = with_unplaced_targets(more);
        ends(&scratch, "run", 0, &[]);
        scratch.document("accuracy.json")
    };
    let (with, without) = (accuracy(7), accuracy(0));
    assert_eq!(with["sets"][1]["count"], without["sets"][1]["count"]);
    let rms = |of: &serde_json::Value| of["sets"][1]["errors"][0]["after"]["rms"].as_f64().unwrap();
    assert!((rms(&with) / rms(&without) - 1.0).abs() < 1e-6, "{} {}", rms(&with), rms(&without));
    // where nothing else is measured there, nothing can be judged
    let scratch = with_unplaced_targets(7);
    let path = scratch.path().join("observations.csv");
    let alone = |line: &&str| {
        let mut cells = line.split(',');
        let (pose, target) = (cells.next().unwrap().parse::<usize>().unwrap_or(0), cells.next().unwrap());
        pose <= 40 || target.starts_with('V')
    };
    let text: Vec<String> = std::fs::read_to_string(&path).unwrap().lines().filter(alone).map(str::to_owned).collect();
    std::fs::write(path, text.join("\n") + "\n").unwrap();
    ends(&scratch, "run", 2, &["7 targets measured only at validation poses", "error[validation-leaves-nothing]"]);
}

#[test]
fn residuals_that_the_documents_do_not_state_are_not_read() {
    use polars::prelude::{DataFrame, NamedFrom, ParquetCompression, Series};
    let scratch = with_unplaced_targets(0);
    ends(&scratch, "run", 0, &[]);
    let out = scratch.path().join("out");
    let zeros = Series::new("x_mm".into(), vec![0.0f64; 2_000_000]);
    let mut table = DataFrame::new(2_000_000, vec![zeros.into()]).unwrap();
    let file = std::fs::File::create(out.join("residuals.parquet")).unwrap();
    let writer = polars_io::parquet::write::ParquetWriter::new(file);
    writer.with_compression(ParquetCompression::Snappy).finish(&mut table).unwrap();
    crate::support::scratch::stamp(&out);
    let (code, error) = said(&scratch, &["report", "campaign"]);
    let parts = ["error[stored-table-damaged]", "2000000 rows instead of 180", "residuals.parquet"];
    assert!(code == Some(2) && parts.iter().all(|part| error.says(part)), "{error}");
}

#[test]
fn parameters_json_grows_with_targets_and_not_with_their_square() {
    let bytes = |more: usize| {
        let scratch = with_unplaced_targets(more);
        // all poses calibrate: every target is placed
        scratch.replace("campaign.toml", "calibration = \"1-40\"", "calibration = \"1-40, 42-60\"");
        ends(&scratch, "run", 0, &[]);
        std::fs::metadata(scratch.path().join("out/parameters.json")).unwrap().len() as f64
    };
    let (few, many) = (bytes(100), bytes(400));
    assert!(many < 6.0 * few, "{few} bytes with 100 targets, {many} with 400");
}
