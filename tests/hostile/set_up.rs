//! Set-ups of campaigns that are wrong: units, fixed points, excluded readings, tolerances.

use super::{ends, etalon};
use crate::support::said::Says;
use crate::support::scratch::{Scratch, copy_sample};
use etalon::base::catalogue::IntoArgument;
use etalon::base::phrase;
use etalon::campaign::Campaign;

/// Adds text to a file of the campaign.
fn add(scratch: &Scratch, file: &str, text: &str) {
    let path = scratch.path().join(file);
    let whole = std::fs::read_to_string(&path).unwrap() + text;
    std::fs::write(path, whole).unwrap();
}

#[test]
fn the_world_export_in_another_unit_is_refused_and_named() {
    let scratch = copy_sample("prexyt-cmm");
    let world = "file = \"exports/world.txt\"\nformat = \"polyworks\"\nunit = ";
    scratch.replace("campaign.toml", &format!("{world}\"mm\""), &format!("{world}\"in\""));
    let parts = ["[nominal-robot-far]", "the world frame rotated by", "`unit`"];
    ends(&scratch, "check", 2, &parts);
    ends(&scratch, "run", 1, &["`x_o` = -7829", "no controller file is written"]);
    assert!(!scratch.path().join("out/controller.json").exists());
}

#[test]
fn a_repeat_of_a_fixed_point_that_lies_elsewhere_is_named_with_its_line() {
    let scratch = copy_sample("prexyt-cmm");
    scratch.replace("exports/world.txt", "R_home 312.63723 ", "R_home 313.63723 ");
    for command in ["check", "run"] {
        let said = ends(&scratch, command, 2, &["error[repeat-off]", "`R_home`", "0.99", "exports/world.txt:16"]);
        assert!(said.starts_with("error"), "{said}");
    }
    // ten micrometres: the instrument does not explain them, and the result is not spoilt
    scratch.replace("exports/world.txt", "R_home 313.63723 ", "R_home 312.64723 ");
    ends(&scratch, "check", 0, &["warning[repeat-off]", "`R_home`", "0.0"]);
}

#[test]
fn an_uncertainty_in_millimetres_is_not_one_in_micrometres() {
    let scratch = copy_sample("prexyt-cmm");
    scratch.replace("campaign.toml", "expanded_uncertainty_um = 2.7", "expanded_uncertainty_um = 0.0027");
    ends(
        &scratch,
        "check",
        2,
        &[
            "error[key-uncertainty-implausible]: `expanded_uncertainty_um` = 0.0027",
            "campaign.toml:7:27",
            "0.0027 mm is 2.7 µm",
        ],
    );
}

#[test]
fn excluded_readings_have_a_reason_that_the_report_repeats() {
    let scratch = copy_sample("prexyt-cmm");
    let rule = "\n[[identify.exclude]]\nposes = \"3\"\ncycle = 2\ntarget = \"K\"\nreason = \"stylus slipped\"\n";
    assert_eq!(etalon(&scratch, "run").0, Some(0));
    let all = scratch.parameters().residuals.count;
    add(&scratch, "campaign.toml", rule);
    ends(&scratch, "run", 0, &["[excluded-readings] count=1 of=pose 3, cycle 2, target `K` reason=stylus slipped"]);
    assert_eq!(scratch.parameters().residuals.count, all - 2);
    assert!(std::fs::read_to_string(scratch.path().join("out/report.html")).unwrap().contains("stylus slipped"));
    for (from, to, said) in [
        ("poses = \"3\"", "poses = \"333\"", "error[exclusion-matches-nothing] of=poses name=333"),
        ("poses = \"333\"", "poses = \"3, 777\"", "error[exclusion-matches-nothing] of=poses name=777"),
        ("poses = \"3, 777\"", "poses = \"all\"", "error[exclusion-names-nothing]: `all`"),
        ("poses = \"all\"\ncycle = 2\ntarget = \"K\"", "poses = \"1-59\"", "error[exclusions-leave-nothing]"),
        ("reason = \"stylus slipped\"", "reason = \" \"", "error[exclusion-without-reason]"),
    ] {
        scratch.replace("campaign.toml", from, to);
        ends(&scratch, "check", 2, &[said]);
    }
}

#[test]
fn exclusions_that_overlap_are_each_counted_by_what_was_measured() {
    let scratch = copy_sample("prexyt-cmm");
    for poses in ["3", "2-4"] {
        let rule = format!("\n[[identify.exclude]]\nposes = \"{poses}\"\ncycle = 2\nreason = \"stylus slipped\"\n");
        add(&scratch, "campaign.toml", &rule);
    }
    ends(&scratch, "run", 0, &["excluded: 2 readings, pose 3, cycle 2", "excluded: 6 readings, poses 2-4, cycle 2"]);
    assert_eq!(scratch.parameters().residuals.count, 160 - 12);
}

#[test]
fn outliers_are_left_out_where_the_campaign_says_so() {
    let scratch = copy_sample("prexyt-cmm");
    scratch.replace("campaign.toml", "calibration = \"1-8\"", "calibration = \"1-40\"\noutliers = \"exclude\"");
    scratch.replace("campaign.toml", "validation = \"9-59\"", "validation = \"41-59\"");
    assert_eq!(etalon(&scratch, "run").0, Some(0));
    let clean = scratch.parameters();
    let path = scratch.path().join("exports/poses.txt");
    let text = std::fs::read_to_string(&path).unwrap();
    // three rows of four hundred are 2 mm off
    let spoil = |line: &str| match ["K_5_3 ", "L_17_1 ", "K_33_4 "].iter().any(|label| line.starts_with(label)) {
        true => {
            let mut cells: Vec<String> = line.split(' ').map(str::to_owned).collect();
            cells[1] = (cells[1].parse::<f64>().unwrap() + 2.0).to_string();
            cells.join(" ") + "\n"
        }
        false => line.to_owned() + "\n",
    };
    std::fs::write(&path, text.lines().map(spoil).collect::<String>()).unwrap();
    let parts = [
        "[outliers-excluded]",
        "3 of 400 readings",
        "(K, pose 5, cycle 3)",
        "(L, pose 17, cycle 1)",
        "(K, pose 33, cycle 4)",
    ];
    ends(&scratch, "run", 0, &parts);
    let found = scratch.parameters();
    assert_eq!(found.residuals.count, clean.residuals.count - 6);
    for (p, q) in found.parameters.iter().zip(&clean.parameters) {
        let Some(u) = q.standard_uncertainty else { continue };
        assert!((p.value - q.value).abs() < u, "{}: {} {}", p.name, p.value, q.value);
    }
}

#[test]
fn a_tolerance_is_checked_and_kept() {
    for (text, said) in [
        ("tolerance = { length_mm = -1 }", "[tolerance-not-positive]"),
        ("tolerance = { a_99 = 1 }", "[tolerance-unknown]"),
    ] {
        let scratch = copy_sample("prexyt-cmm");
        scratch.replace("robot.toml", "model = \"prexyt\"", &format!("model = \"prexyt\"\n{text}"));
        ends(&scratch, "check", 2, &[said]);
    }
    // the table's d3 is 0.85 mm from its drawing
    let scratch = copy_sample("prexyt-cmm");
    scratch.replace("robot.toml", "model = \"prexyt\"", "model = \"prexyt\"\ntolerance = { d3 = 0.5 }");
    let said = ends(&scratch, "run", 1, &["error[tolerance-exceeded]", "`d3`", "0.85", "tolerance 0.500 mm"]);
    assert!(said.has_phrase("no-controller-files"), "{said}");
}

#[test]
fn nominal_values_ten_times_too_large_are_refused() {
    let scratch = copy_sample("prexyt-cmm");
    scratch.replace("robot.toml", "\ns = 394.0", "\ns = 3940.0");
    ends(&scratch, "check", 2, &["[nominal-robot-far]", "`s` = 39"]);
    let mirrored = copy_sample("dextar");
    mirrored.replace("robot.toml", "l12 = 230.0", "l12 = -230.0");
    ends(&mirrored, "check", 2, &["[nominal-length-not-positive]", "`l12`", "robot.toml:7:7"]);
    assert_ne!(etalon(&scratch, "run").0, Some(0));
}

#[test]
fn a_reversed_joint_that_reaches_no_pose_is_named_before_the_run() {
    let scratch = copy_sample("dextar");
    let path = scratch.path().join("encoders.csv");
    let text = std::fs::read_to_string(&path).unwrap();
    let column = text.lines().next().unwrap().split(',').position(|name| name == "T2").unwrap();
    let reversed = |(i, line): (usize, &str)| {
        let mut cells: Vec<String> = line.split(',').map(str::to_owned).collect();
        if i > 0 {
            cells[column] = (-cells[column].parse::<f64>().unwrap()).to_string();
        }
        cells.join(",") + "\n"
    };
    std::fs::write(&path, text.lines().enumerate().map(reversed).collect::<String>()).unwrap();
    let slip = phrase!("slip-reversed", joint = "`theta2`").to_string();
    let parts = ["error[nominal-robot-not-at-joints]", &slip, "out of reach"];
    let said = ends(&scratch, "check", 2, &parts);
    assert!(!said.contains("inf mm"), "{said}");
}

#[test]
fn a_ball_that_bears_the_coordinates_of_another_is_named() {
    let plate = copy_sample("dextar");
    let text = std::fs::read_to_string(plate.path().join("exports/plate.txt")).unwrap();
    let balls: Vec<&str> = text.lines().filter(|line| line.starts_with("DexTAR,")).collect();
    let cells = |line: &str| line.split(',').map(str::to_owned).collect::<Vec<_>>();
    for (i, ball) in balls.iter().enumerate() {
        let (ball, other) = (cells(ball), cells(balls[(i + 5) % balls.len()]));
        let scratch = copy_sample("dextar");
        scratch.replace("exports/plate.txt", &ball.join(","), &[&ball[..3], &other[3..]].concat().join(","));
        let (found, _) = etalon::run::walk::everything(&Campaign::read(&scratch.path()).unwrap());
        let said: String = found.messages.iter().map(|m| m.what.clone() + "\n").collect();
        let named = |a: &str, b: &str| {
            let arguments: [(&str, &dyn IntoArgument); 2] = [("point", &a), ("other", &b)];
            found.messages.iter().any(|m| m.is("point-lies-at-another", &arguments))
        };
        assert!(named(&ball[2], &other[2]) || named(&other[2], &ball[2]), "{}: {said}", ball[2]);
    }
}

/// Nothing checks six parameters from six coordinates: least squares alone gives no result, and beside tolerances the robot stays nominal.
#[test]
fn as_many_parameters_as_coordinates_are_said_to_be_unchecked() {
    let scratch = copy_sample("pose-test");
    let rows = ["SMR_1,374,0,630", "SMR_2,374,0,500"].map(|row| format!("1,1,{row},0,0,0,0,0,0\n")).concat();
    let header = "pose,cycle,target,x_mm,y_mm,z_mm,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg\n";
    std::fs::write(scratch.path().join("o.csv"), header.to_owned() + &rows).unwrap();
    for (prior, code) in [("none", 1), ("tolerances", 0)] {
        let done = std::process::Command::new(crate::support::program())
            .args(["identify", "--robot", "robot.toml", "--observations", "o.csv", "--prior", prior])
            .current_dir(scratch.path())
            .output()
            .unwrap();
        let said = String::from_utf8(done.stderr).unwrap();
        assert_eq!(done.status.code(), Some(code), "{prior}: {said}");
        let unchecked = "[no-coordinates-to-check] count=6 parameters=6";
        assert!(said.says(unchecked), "{prior}: {said}");
    }
}

#[test]
fn targets_of_a_table_that_leave_its_plane_are_named() {
    let scratch = copy_sample("prexyt-cmm");
    let path = scratch.path().join("exports/poses.txt");
    let text = std::fs::read_to_string(&path).unwrap();
    // the heights are in inches
    let inches = |line: &str| {
        let (rest, z) = line.rsplit_once(' ').unwrap();
        format!("{rest} {:.5}\n", z.parse::<f64>().unwrap() / 25.4)
    };
    std::fs::write(&path, text.lines().map(inches).collect::<String>()).unwrap();
    ends(&scratch, "check", 0, &["warning[targets-out-of-plane]", "heights from -92.03", " to -90.28"]);
}

#[test]
fn reference_targets_that_make_poses_scatter_more_are_named() {
    let scratch = copy_sample("pose-test");
    let path = scratch.path().join("reference.csv");
    let text = std::fs::read_to_string(&path).unwrap();
    let raised = |line: &str| match line.strip_prefix("21,").and_then(|_| line.rsplit_once(',')) {
        Some((rest, z)) => format!("{rest},{:.4}\n", z.parse::<f64>().unwrap() + 0.1),
        None => format!("{line}\n"),
    };
    std::fs::write(&path, text.lines().map(raised).collect::<String>()).unwrap();
    let (_, said) = etalon(&scratch, "run");
    assert!(said.says("warning[compensation-scatters] after_mm=0.0458"), "{said}");
    // one of the four alone
    let raised = |line: &str| match line.strip_prefix("21,N2").and_then(|_| line.rsplit_once(',')) {
        Some((rest, z)) => format!("{rest},{:.4}\n", z.parse::<f64>().unwrap() + 0.1),
        None => format!("{line}\n"),
    };
    std::fs::write(&path, text.lines().map(raised).collect::<String>()).unwrap();
    let (_, said) = etalon(&scratch, "run");
    assert!(said.says("warning[reference-targets-misshapen] cycle=21"), "{said}");
}

#[test]
fn the_log_of_another_campaign_is_named() {
    let scratch = copy_sample("prexyt-cmm");
    let other = copy_sample("prexyt-geometric");
    std::fs::copy(other.path().join("encoders.csv"), scratch.path().join("encoders.csv")).unwrap();
    ends(&scratch, "run", 1, &["a log of another campaign", "no controller file is written"]);
}
