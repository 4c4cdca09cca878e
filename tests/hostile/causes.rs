//! What went wrong is told by its cause: units, assembly modes, exchanged targets, blunders, too few poses.

use super::{ends, etalon};
use crate::support::said::Says;
use crate::support::scratch::{Scratch, copy_sample};

/// Runs the campaign, which must end with `code`; all `parts` must be said.
fn run(scratch: &Scratch, code: i32, parts: &[&str]) -> String {
    ends(scratch, "run", code, parts)
}

/// Rewrites the lines of a file of the campaign.
fn rewrite(scratch: &Scratch, file: &str, line: impl Fn(&str) -> String) {
    let path = scratch.path().join(file);
    let text = std::fs::read_to_string(&path).unwrap();
    std::fs::write(path, text.lines().map(|l| line(l) + "\n").collect::<String>()).unwrap();
}

/// A label with K and L exchanged.
fn exchanged(line: &str) -> String {
    match (line.strip_prefix("K_"), line.strip_prefix("L_")) {
        (Some(rest), _) => format!("L_{rest}"),
        (_, Some(rest)) => format!("K_{rest}"),
        _ => line.to_owned(),
    }
}

#[test]
fn one_pose_shows_no_parameter() {
    let scratch = copy_sample("prexyt-cmm");
    assert_eq!(etalon(&scratch, "run").0, Some(0));
    let all = std::fs::read_to_string(scratch.path().join("out/observations.csv")).unwrap();
    let one: String =
        all.lines().filter(|l| l.starts_with("pose") || l.starts_with("1,")).map(|l| l.to_owned() + "\n").collect();
    std::fs::write(scratch.root().join("one.csv"), one).unwrap();
    scratch.replace("campaign.toml", "calibration = \"1-8\"", "calibration = \"1\"");
    // pose 1 is K and L at one place, five times
    let parts = ["[joints-do-not-move]", "measure poses with different values of every joint"];
    run(&scratch, 2, &parts);
    let output = std::process::Command::new(crate::support::program())
        .args(["identify", "--robot", "campaign/robot.toml", "--observations", "one.csv", "--prior", "none"])
        .current_dir(scratch.root())
        .output()
        .unwrap();
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.code() == Some(2) && parts.iter().all(|part| said.says(part)), "{said}");
    // nominal values do not replace motion
    scratch.replace("campaign.toml", "prior = \"none\"", "prior = \"tolerances\"");
    run(&scratch, 2, &parts);
}

#[test]
fn a_wrong_unit_is_told_by_the_spread_of_the_points() {
    for (unit, spread, named) in [
        ("in", "12146", "the measured points in millimetres instead of inches"),
        ("m", "478200", "the measured points in millimetres instead of metres"),
    ] {
        let scratch = copy_sample("prexyt-cmm");
        let before = "file = \"exports/poses.txt\"\nformat = \"polyworks\"\nunit = ";
        scratch.replace("campaign.toml", &format!("{before}\"mm\""), &format!("{before}\"{unit}\""));
        let spread = format!("the measured points span {} mm, the predicted points 478 mm", spread);
        run(&scratch, 2, &["[nothing-to-identify]", &spread, named, "`unit` of the export"]);
    }
}

#[test]
fn degrees_that_are_read_as_radians_reach_no_pose() {
    let scratch = copy_sample("dextar");
    scratch.replace("campaign.toml", "theta1_deg", "theta1_rad");
    scratch.replace("campaign.toml", "theta2_deg", "theta2_rad");
    run(
        &scratch,
        2,
        &[
            "error[joint-out-of-range]: pose 1: ",
            "error[joint-out-of-range] joint=theta1 value=3114.7848 unit=deg",
            "all values are in range in degrees instead of radians",
        ],
    );
}

#[test]
fn a_wrong_assembly_mode_is_told_by_its_pose_and_the_mode_that_fits() {
    let scratch = copy_sample("dextar");
    rewrite(&scratch, "encoders.csv", |line| {
        let cells: Vec<&str> = line.split(',').collect();
        match (cells[3], cells[0]) {
            ("5", "1") => format!("-{line}"),
            ("5", _) => line.trim_start_matches('-').to_owned(),
            _ => line.to_owned(),
        }
    });
    run(
        &scratch,
        2,
        &[
            "contradicts the assembly mode in pose 5",
            "the residual is 152.0 mm with the given mode -1",
            "6.4 mm with mode +1",
            "`assembly`",
        ],
    );
}

#[test]
fn targets_exchanged_everywhere_are_said_to_be() {
    let scratch = copy_sample("prexyt-cmm");
    rewrite(&scratch, "exports/poses.txt", exchanged);
    let said = run(&scratch, 1, &["error[ball-names-exchanged]", "is -146.02"]);
    assert!(!said.contains("[placement-unexplained]"), "{said}");
}

#[test]
fn targets_exchanged_at_one_pose_are_found_there() {
    let scratch = copy_sample("prexyt-cmm");
    let at_pose_3 = |line: &str| if line[1..].starts_with("_3_") { exchanged(line) } else { line.to_owned() };
    rewrite(&scratch, "exports/poses.txt", at_pose_3);
    let said = run(&scratch, 1, &["error[measurements-undescribed]", "of 80 readings are outliers"]);
    // about l_kl at both balls of pose 3, in all five cycles
    let most = said.split("robust fit: ").nth(1).unwrap().lines().next().unwrap();
    let first: Vec<&str> = most.split("), ").take(10).collect();
    for (ball, cycle) in (1..=5).flat_map(|cycle| [("K", cycle), ("L", cycle)]) {
        let named = format!(" mm ({ball}, pose 3, cycle {cycle}");
        assert!(first.iter().any(|reading| reading.starts_with("14") && reading.contains(&named)), "{named}: {most}");
    }
}

#[test]
fn a_blunder_of_one_ball_is_found_with_its_size() {
    let scratch = copy_sample("prexyt-cmm");
    rewrite(&scratch, "exports/poses.txt", |line| match line.strip_prefix("K_5_3 ") {
        Some(rest) => {
            let (x, rest) = rest.split_once(' ').unwrap();
            format!("K_5_3 {} {rest}", x.parse::<f64>().unwrap() + 1.0)
        }
        None => line.to_owned(),
    });
    let said = run(&scratch, 1, &["[residuals-exceed-uncertainty]", "1 of 80 readings is an outlier"]);
    let most = said.split("robust fit: ").nth(1).unwrap();
    assert!(most.starts_with("1.00") && most.contains(" mm (K, pose 5, cycle 3)"), "{most}");
}

#[test]
fn an_uncertainty_stated_ten_times_too_large_is_remarked() {
    let scratch = copy_sample("prexyt-cmm");
    assert!(!run(&scratch, 0, &[]).contains("[instrument-uncertainty-too-large]"));
    scratch.replace("campaign.toml", "expanded_uncertainty_um = 2.7", "expanded_uncertainty_um = 27");
    // and it leaves open whether the limits are met
    run(&scratch, 1, &["residuals are 0.10 times", "[instrument-uncertainty-too-large]"]);
}
