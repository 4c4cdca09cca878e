//! Joins by row and by time: what has no partner, or two, is said.

use crate::support::documents_of;
use crate::support::said::Says;
use crate::support::scratch::{Scratch, copy_sample};
use etalon::base::catalogue::IntoArgument;
use etalon::base::message::Problems;
use etalon::campaign::Campaign;
use etalon::run::pipeline::{self, Outcome};

const DELIMITED: &str = "format = { delimiter = \";\", columns = [\"target\", \"time_s\", \"x\", \"y\", \"z\"] }";

/// The CMM sample with its first cycle in the plane of the world, a time in every row, and a log by time or row.
fn timed(join: &str, clock_offset_s: f64, drop_log_row: Option<usize>, measured_twice: bool) -> Scratch {
    let scratch = copy_sample("prexyt-cmm");
    let campaign = Campaign::read(&scratch.path()).unwrap();
    let robot = campaign.build_robot().unwrap();
    let truth = etalon::simulate::Truth::read(&scratch.path().join("truth.toml")).unwrap();
    let value = |p: &etalon::robots::Parameter| p.quantity.inward(truth.parameters[&p.name]);
    let values: Vec<f64> = robot.parameters().iter().map(value).collect();
    let log = std::fs::read_to_string(scratch.path().join("encoders.csv")).unwrap();
    let mut export = String::new();
    let mut rows = String::from("t,RP1,RP2,RP3\n");
    // columns of the sample's log are in the order of their keys: cycle, pose, rho1, rho2, rho3
    for (i, line) in log.lines().skip(1).take(59).enumerate() {
        let cells: Vec<f64> = line.split(',').map(|c| c.parse().unwrap()).collect();
        let q = &cells[2..];
        let time = 10.0 * (i + 1) as f64;
        for k in 0..2 {
            let p = robot.position(&values, q, k);
            export += &format!("{};{};{};{};0\n", robot.targets()[k], time + clock_offset_s + 0.2, p[0], p[1]);
            if measured_twice && i == 4 && k == 0 {
                export += &format!("K;{};{};{};0\n", time + clock_offset_s + 0.3, p[0], p[1]);
            }
        }
        if drop_log_row != Some(i) {
            rows += &format!("{time},{},{},{}\n", q[0], q[1], q[2]);
        }
    }
    std::fs::write(scratch.path().join("exports/poses.txt"), export).unwrap();
    std::fs::write(scratch.path().join("encoders.csv"), rows).unwrap();
    let text = std::fs::read_to_string(scratch.path().join("campaign.toml")).unwrap();
    let start = text.find("[join]").unwrap();
    let poses = "file = \"exports/poses.txt\"\n";
    let text = format!(
        "name = \"timed\"\nrobot = \"robot.toml\"\n[instrument]\nname = \"i\"\nexpanded_uncertainty_um = 2\ncoverage_factor = 2\n\
         [[export]]\n{poses}{DELIMITED}\nunit = \"mm\"\n\
         [log]\nfile = \"encoders.csv\"\ncolumns = {{ time_s = \"t\", rho1_mm = \"RP1\", rho2_mm = \"RP2\", rho3_mm = \"RP3\" }}\n\
         [join]\n{join}\n[frame.world]\nas_exported = true\n[identify]\nprior = \"none\"\ncalibration = \"1-8\"\nvalidation = \"rest\"\n"
    );
    assert!(start > 0);
    std::fs::write(scratch.path().join("campaign.toml"), text).unwrap();
    scratch
}

fn run(scratch: &Scratch) -> Result<Outcome, Problems> {
    documents_of(&Campaign::read(&scratch.path())?)
}

#[test]
fn by_time_with_the_stated_offset() {
    let outcome =
        run(&timed("by = \"time\"\nclock_offset_s = 1000.0\ntolerance_s = 1.0", 1000.0, None, false)).unwrap();
    assert_eq!(outcome.results.identified.as_ref().unwrap().accuracy.sets[0].poses, 8);
    assert!(
        outcome.results.identified.as_ref().unwrap().accuracy.sets[1].errors[0].after.max < 1e-9,
        "{:?}",
        outcome.results.identified.as_ref().unwrap().accuracy.sets
    );
}

#[test]
fn a_wrong_offset_finds_no_partner() {
    let problems =
        run(&timed("by = \"time\"\nclock_offset_s = 0.0\ntolerance_s = 1.0", 1000.0, None, false)).unwrap_err();
    let said = problems.to_string();
    assert!(said.contains("error[join-by-time-empty]") && said.has_phrase("join-by-time-empty"), "{said}");
    assert!(!said.contains("error[join-empty]"), "{said}");
}

#[test]
fn points_without_a_log_row_are_counted() {
    let outcome = run(&timed("by = \"time\"\nclock_offset_s = 0.0\ntolerance_s = 1.0", 0.0, Some(20), false)).unwrap();
    let said = outcome.results.messages().any(|m| m.is("points-without-row", &[("count", &2), ("log", &"log")]));
    assert!(said, "{:?}", outcome.results.import.messages);
    assert_eq!(outcome.results.identified.as_ref().unwrap().accuracy.sets[1].poses, 50);
}

#[test]
fn two_points_for_one_log_row_are_an_error() {
    let problems = run(&timed("by = \"time\"\nclock_offset_s = 0.0\ntolerance_s = 1.0", 0.0, None, true)).unwrap_err();
    let twice = [("row", &5 as &dyn IntoArgument), ("log", &"log"), ("count", &2), ("target", &"K")];
    assert!(problems.0.iter().any(|m| m.is("log-row-met-twice", &twice)), "{problems}");
    let said = problems.to_string();
    assert!(said.contains("exports/poses.txt:10"), "{said}");
}

#[test]
fn a_join_by_time_needs_offset_and_tolerance() {
    let problems = run(&timed("by = \"time\"", 0.0, None, false)).unwrap_err();
    assert!(problems.to_string().contains("clock_offset_s"), "{problems}");
}

#[test]
fn by_row_only_where_the_counts_agree() {
    let problems = run(&timed("by = \"row\"", 0.0, None, false)).unwrap_err();
    assert!(problems.0[0].is("row-counts-differ", &[("rows", &118), ("log_rows", &59)]), "{problems}");
}

/// The rows that `import.json` lists as unmatched: file, line, key.
fn unmatched(scratch: &Scratch) -> Vec<(String, usize, String)> {
    let text = std::fs::read_to_string(scratch.path().join("out/import.json")).unwrap();
    let document: etalon::documents::ImportDocument = serde_json::from_str(&text).unwrap();
    document.unmatched.into_iter().map(|u| (u.file, u.line, u.key)).collect()
}

#[test]
fn every_row_without_a_partner_in_time_is_listed_with_its_line() {
    let scratch = timed("by = \"time\"\nclock_offset_s = 0.0\ntolerance_s = 1.0", 0.0, Some(20), false);
    run(&scratch).unwrap();
    // measurement 21 is on lines 41 and 42
    let expected = [41, 42].map(|line| ("exports/poses.txt".to_owned(), line, "210.2 s".to_owned()));
    assert_eq!(unmatched(&scratch), expected);
}

/// Labels and log number the poses, but for the fifth row of the log: what meets by time contradicts itself there.
#[test]
fn points_and_log_rows_that_meet_and_bear_different_poses_are_an_error() {
    let scratch = timed("by = \"time\"\nclock_offset_s = 0.0\ntolerance_s = 1.0", 0.0, None, false);
    scratch.replace("campaign.toml", "\"x\", \"y\", \"z\"]", "\"x\", \"y\", \"z\", \"pose\"]");
    scratch.replace("campaign.toml", "columns = { time_s", "columns = { pose = \"P\", time_s");
    let numbered = |file: &str, number: &dyn Fn(usize) -> String| {
        let path = scratch.path().join(file);
        let text = std::fs::read_to_string(&path).unwrap();
        let lines: String = text.lines().enumerate().map(|(i, line)| line.to_owned() + &number(i) + "\n").collect();
        std::fs::write(path, lines).unwrap();
    };
    numbered("exports/poses.txt", &|i| format!(";{}", i / 2 + 1));
    let pose = |wrong: i64| {
        move |i: usize| match i {
            0 => ",P".to_owned(),
            5 => format!(",{wrong}"),
            _ => format!(",{i}"),
        }
    };
    let log = std::fs::read_to_string(scratch.path().join("encoders.csv")).unwrap();
    numbered("encoders.csv", &pose(99));
    let said = run(&scratch).unwrap_err().to_string();
    let expected = "error[join-contradicts] count=2 column=pose log=log measured=5 logged=99 line=6";
    assert!(said.says(expected) && said.contains("exports/poses.txt:9"), "{said}");
    std::fs::write(scratch.path().join("encoders.csv"), log).unwrap();
    numbered("encoders.csv", &pose(5));
    run(&scratch).unwrap();
}

#[test]
fn every_key_without_a_partner_is_listed_with_its_line() {
    let scratch = copy_sample("prexyt-cmm");
    let log = std::fs::read_to_string(scratch.path().join("encoders.csv")).unwrap();
    // poses 10 to 20 of cycle 1 are on lines 11 to 21; they leave, and a row that nobody measured comes
    let kept = log.lines().enumerate().filter(|(i, _)| !(10..21).contains(i)).map(|(_, l)| l.to_owned() + "\n");
    std::fs::write(scratch.path().join("encoders.csv"), kept.collect::<String>() + "9,1,0,0,0\n").unwrap();
    let outcome = run(&scratch).unwrap();
    assert!(outcome.results.messages().any(|m| m.is("keys-unmatched", &[("count", &11), ("of", &"points")])));
    let listed = unmatched(&scratch);
    let export = std::fs::read_to_string(scratch.path().join("exports/poses.txt")).unwrap();
    let lines: Vec<&str> = export.lines().collect();
    let mut labels: Vec<String> = Vec::new();
    for (file, line, key) in &listed[..22] {
        assert_eq!(file, "exports/poses.txt");
        let label = lines[line - 1].split(' ').next().unwrap();
        let pose = label.split('_').nth(1).unwrap();
        assert_eq!(key, &format!("pose {pose}, cycle 1"));
        labels.push(label.to_owned());
    }
    let expected: Vec<String> = (10..21).flat_map(|p| [format!("K_{p}_1"), format!("L_{p}_1")]).collect();
    assert_eq!(labels, expected);
    assert_eq!(listed[22..], [("encoders.csv".to_owned(), 296 - 11 + 1, "pose 1, cycle 9".to_owned())]);
}

#[test]
fn every_key_that_the_log_has_twice_is_said_with_its_lines() {
    let scratch = copy_sample("prexyt-cmm");
    let log = std::fs::read_to_string(scratch.path().join("encoders.csv")).unwrap();
    std::fs::write(scratch.path().join("encoders.csv"), log + "1,3,0,0,0\n2,7,0,0,0\n").unwrap();
    let said = run(&scratch).unwrap_err().to_string();
    assert!(
        said.says(
            "error[log-key-twice] log=log count=2 keys=pose 3, cycle 1 (lines 4, 297), pose 7, cycle 2 (lines 67, 298)"
        ),
        "{said}"
    );
}

#[test]
fn two_files_of_one_target_number_their_rows_apart() {
    let scratch = copy_sample("prexyt-cmm");
    let text = std::fs::read_to_string(scratch.path().join("exports/poses.txt")).unwrap();
    let log = std::fs::read_to_string(scratch.path().join("encoders.csv")).unwrap();
    let first_cycle: Vec<&str> = log.lines().filter(|line| line.starts_with("run") || line.starts_with("1,")).collect();
    std::fs::write(scratch.path().join("encoders.csv"), first_cycle.join("\n")).unwrap();
    let mut exports = String::new();
    for target in ["K", "L"] {
        let row = |pose: i64| text.lines().find(|line| line.starts_with(&format!("{target}_{pose}_1 "))).unwrap();
        for (part, poses, number) in [("a", 1..=30, "row"), ("b", 31..=59, "row + 30")] {
            let file = format!("exports/{target}_{part}.txt");
            let rows = poses.map(|pose| row(pose).to_owned() + "\n").collect::<String>();
            std::fs::write(scratch.path().join(&file), rows).unwrap();
            exports += &format!(
                "[[export]]\nfile = \"{file}\"\nformat = \"polyworks\"\nunit = \"mm\"\ntarget = \"{target}\"\npose = \"{number}\"\n"
            );
        }
    }
    let stated = "[[export]]\nfile = \"exports/poses.txt\"\nformat = \"polyworks\"\nunit = \"mm\"\nlabel = \"{target}_{pose}_{cycle}\"\n";
    scratch.replace("campaign.toml", stated, &exports);
    scratch.replace("campaign.toml", "by = [\"pose\", \"cycle\"]", "by = \"pose\"");
    let outcome = pipeline::evaluate(&Campaign::read(&scratch.path()).unwrap()).unwrap();
    let found = outcome.results.identified.as_ref().unwrap();
    assert_eq!((found.parameters.residuals.count, found.accuracy.sets[1].poses), (8 * 4, 51));
    assert!(outcome.results.verdict.passes());
    // without the offset they collide, and the message states the remedy
    scratch.replace("campaign.toml", "row + 30", "row");
    let problems = pipeline::evaluate(&Campaign::read(&scratch.path()).unwrap()).err().unwrap().to_string();
    assert!(problems.contains("error[target-twice]") && problems.contains("`pose = \"row + 100\"`"), "{problems}");
    scratch.replace("campaign.toml", "pose = \"row\"", "pose = \"row - 1\"");
    let problems = Campaign::read(&scratch.path()).unwrap_err().to_string();
    assert!(problems.contains("`row - 1` is unknown"), "{problems}");
}

/// A log of an hour with a standstill of two seconds at each pose, and points measured at the start of every other standstill
/// and at the end of the rest, by a clock of this rate.
fn drifting(rate: f64, join: &str) -> Scratch {
    let scratch = timed(join, 0.0, None, false);
    let path = |name: &str| scratch.path().join(name);
    let read = |name: &str| std::fs::read_to_string(path(name)).unwrap();
    let start = |i: usize| (90 * i + 7 * (i * i % 11)) as f64;
    let mut log = String::from("t,RP1,RP2,RP3\n");
    for (i, line) in read("encoders.csv").lines().skip(1).enumerate() {
        let joints = line.split_once(',').unwrap().1;
        (0..3).for_each(|k| log += &format!("{},{joints}\n", start(i) + f64::from(k)));
    }
    let mut export = String::new();
    for (row, line) in read("exports/poses.txt").lines().enumerate() {
        // two targets a pose
        let i = row / 2;
        let logged = start(i) + [0.05, 1.95][i % 2];
        let cells: Vec<&str> = line.split(';').collect();
        let measured = logged + 500.0 + rate * (logged - 2000.0);
        export += &format!("{};{measured};{};{};{}\n", cells[0], cells[2], cells[3], cells[4]);
    }
    let stated = read("campaign.toml");
    let stated = stated
        .replace("columns = { time_s", "standstill = { at_least_s = 1.0, within_mm = 0.001 }\ncolumns = { time_s");
    std::fs::write(path("encoders.csv"), log).unwrap();
    std::fs::write(path("exports/poses.txt"), export).unwrap();
    std::fs::write(path("campaign.toml"), stated).unwrap();
    scratch
}

#[test]
fn the_rate_of_the_clocks_comes_from_the_standstills_within_that_of_crystals() {
    let offset = "by = \"time\"\nclock_offset_s = \"standstills\"\ntolerance_s = 0";
    let both = format!("{offset}\nclock_rate = \"standstills\"");
    let alone = run(&drifting(60e-6, offset)).unwrap_err();
    assert!(alone.0.iter().any(|m| m.is("clock-offset-none", &[])), "{alone}");
    let outcome = run(&drifting(60e-6, &both)).unwrap_or_else(|e| panic!("{e}"));
    let said = outcome.results.messages().find(|m| m.is("clock-rate-from-standstills", &[("log", &"log")]));
    println!("{}", said.unwrap_or_else(|| panic!("{:?}", outcome.results.import.messages)));
    let errors = &outcome.results.identified.as_ref().unwrap().accuracy.sets[1].errors[0];
    assert!(errors.after.max < 1e-9, "{errors:?}");
    // equal rates: the offset alone is used, and that is said
    let outcome = run(&drifting(0.0, &both)).unwrap_or_else(|e| panic!("{e}"));
    assert!(
        outcome.results.messages().any(|m| m.is("clock-rate-insignificant", &[])),
        "{:?}",
        outcome.results.import.messages
    );
    // no crystal drifts so far
    let wrong = run(&drifting(400e-6, &both)).unwrap_err();
    assert!(wrong.0.iter().any(|m| m.is("clock-rate-none", &[])), "{wrong}");
}

#[test]
fn a_rate_of_the_clocks_needs_their_offset_from_standstills() {
    let stated = "by = \"time\"\nclock_offset_s = 0.0\ntolerance_s = 1.0\nclock_rate = \"standstills\"";
    let problems = run(&timed(stated, 0.0, None, false)).unwrap_err();
    assert!(problems.0.iter().any(|m| m.is("clock-rate-without-offset", &[])), "{problems}");
    let problems = run(&timed("by = \"row\"\nclock_rate = \"standstills\"", 0.0, None, false)).unwrap_err();
    assert!(problems.0.iter().any(|m| m.is("key-of-other-join", &[("key", &"clock_rate")])), "{problems}");
}

/// A robot that never stands still: the log at 50 Hz, and the points of an instrument at 10 Hz on a clock with this offset and rate.
fn moving(offset_s: f64, rate: f64, join: &str) -> Scratch {
    let scratch = timed(join, 0.0, None, false);
    let campaign = Campaign::read(&scratch.path()).unwrap();
    let robot = campaign.build_robot().unwrap();
    let truth = etalon::simulate::Truth::read(&scratch.path().join("truth.toml")).unwrap();
    let value = |p: &etalon::robots::Parameter| p.quantity.inward(truth.parameters[&p.name]);
    let values: Vec<f64> = robot.parameters().iter().map(value).collect();
    let joints = |t: f64| {
        let swing = 40.0 * (0.21 * t + (0.05 * t).sin()).sin();
        [80.0 + swing, 85.0 + swing + 15.0 * (0.53 * t).sin(), 90.0 + 25.0 * (0.37 * t).cos()]
    };
    let mut log = String::from("t,RP1,RP2,RP3\n");
    for i in 0..6000 {
        let t = 0.02 * f64::from(i);
        let [a, b, c] = joints(t);
        log += &format!("{t:.4},{a},{b},{c}\n");
    }
    let mut export = String::new();
    for i in 0..1000 {
        let t = 10.0 + 0.1 * f64::from(i);
        for k in 0..2 {
            let p = robot.position(&values, &joints(t), k);
            let measured = t + offset_s + rate * (t - 60.0);
            export += &format!("{};{measured:.6};{};{};0\n", robot.targets()[k], p[0], p[1]);
        }
    }
    std::fs::write(scratch.path().join("exports/poses.txt"), export).unwrap();
    std::fs::write(scratch.path().join("encoders.csv"), log).unwrap();
    scratch
}

#[test]
fn clocks_are_compared_by_a_motion_without_standstills() {
    let offset = "by = \"time\"\nclock_offset_s = \"motion\"\ntolerance_s = 0.02\ninterpolate = true";
    let outcome = run(&moving(512.25, 0.0, offset)).unwrap_or_else(|e| panic!("{e}"));
    let said = outcome.results.messages().find(|m| m.is("clock-from-motion", &[("log", &"log")]));
    let said = said.unwrap_or_else(|| panic!("{:?}", outcome.results.import.messages)).to_string();
    assert!(said.contains("offset 512.25"), "{said}");
    // nominal parameters: 0.1 mm, and with another offset 20 mm for each second
    let errors = &outcome.results.identified.as_ref().unwrap().accuracy.sets[1].errors[0];
    assert!(errors.before.max < 0.15, "{errors:?}");
    let stated = format!("{offset}\nclock_rate = \"standstills\"");
    let problems = run(&moving(0.0, 0.0, &stated)).unwrap_err();
    assert!(problems.0.iter().any(|m| m.is("clock-rate-without-offset", &[])), "{problems}");
}
