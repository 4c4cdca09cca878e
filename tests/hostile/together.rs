//! No problem hides another: each case breaks a campaign in several places, and `etalon check` says all of them.

use super::{broken, ends, etalon};
use crate::support::said::Says;
use crate::support::scratch::{Scratch, copy_sample};

/// Checks the campaign; all `parts` must be said.
fn said(scratch: &Scratch, parts: &[&str]) -> String {
    ends(scratch, "check", 2, parts)
}

#[test]
fn a_robot_file_that_does_not_read_hides_nothing() {
    let scratch = copy_sample("prexyt-cmm");
    scratch.replace("robot.toml", "[nominal]", "[nominal");
    scratch.replace("campaign.toml", "[join]", "[join]\ncolour = 1");
    scratch.replace("campaign.toml", "\"rail2_a\",", "\"rail2_x\",");
    said(&scratch, &["robot.toml:5", "[unknown-key]", "`colour`", "[label-unknown]", "`rail2_x`"]);
    scratch.replace("campaign.toml", "robot = \"robot.toml\"", "robot = \"robto.toml\"");
    said(&scratch, &["robto.toml`", "campaign.toml:2:9", "[unknown-key]", "`colour`", "`rail2_x`"]);
    scratch.replace("campaign.toml", "robot = \"robto.toml\"", "robot = \"../robot.toml\"");
    said(&scratch, &["[path-outside]", "[unknown-key]", "`colour`", "`rail2_x`"]);
}

#[test]
fn a_wrong_label_hides_no_poor_feature_and_no_unequal_count() {
    let scratch = copy_sample("prexyt-cmm");
    let rails = "plane = [\"rail2_a\", \"rail2_b\", \"rail3_a\"]";
    scratch.replace("campaign.toml", rails, "plane = [\"rail2_a\", \"rail2_b\"]\n[feature.rod]\nline = [\"R_no\"]");
    scratch.replace("campaign.toml", "towards = \"rail3_a\"", "towards = \"rail9_a\"");
    scratch.replace("campaign.toml", "y_axis = [\"R_home\", \"R_end\"]", "y_axis = [\"R_home\"]");
    scratch.replace("campaign.toml", "by = [\"pose\", \"cycle\"]", "by = \"row\"");
    let parts = [
        "[label-unknown]",
        "`R_no`",
        "[point-or-feature-unknown]",
        "`rail9_a`",
        "feature `rails`: ",
        "error[frame-axis-without-direction]",
        "[row-counts-differ]",
    ];
    let said = said(&scratch, &parts);
    for part in parts {
        assert_eq!(said.matches(part).count(), 1, "{part:?} once:\n{said}");
    }
    assert!(said.says("[row-counts-differ] file=exports/poses.txt rows=590 log=log log_rows=295"), "{said}");
}

#[test]
fn rules_on_rigid_parts_are_checked_beside_unreadable_rows() {
    let scratch = copy_sample("prexyt-cmm");
    scratch.replace("encoders.csv", "\n1,1,0.000000", "\n1,1,x");
    let rigid = "[[rigid]]\ntargets = [\"K\", \"L\"]\ntolerance_mm = -0.1\n[[rigid]]\ntargets = [\"K\", \"K\"]\ntolerance_mm = 1.0\n[log]";
    scratch.replace("campaign.toml", "[log]", rigid);
    said(
        &scratch,
        &[
            "[not-a-number]: `x`",
            "tolerance_mm = -0.1",
            "error[limit-not-positive]: `tolerance_mm`",
            "error[rigid-targets]",
        ],
    );
}

#[test]
fn every_log_is_joined_and_its_problems_said() {
    let scratch = copy_sample("prexyt-cmm");
    let log = std::fs::read_to_string(scratch.path().join("encoders.csv")).unwrap();
    let row = log.lines().nth(3).unwrap().to_owned() + "\n";
    std::fs::write(scratch.path().join("encoders.csv"), log + &row).unwrap();
    let text = std::fs::read_to_string(scratch.path().join("campaign.toml")).unwrap();
    let (head, rest) = text.split_once("[log]").unwrap();
    let (body, tail) = rest.split_once("[join]").unwrap();
    let logs = format!("{head}[[log]]\nname = \"one\"{body}[[log]]\nname = \"two\"{body}[join]{tail}");
    std::fs::write(scratch.path().join("campaign.toml"), logs).unwrap();
    said(&scratch, &["log `one` has 1 key", "log `two` has 1 key", "pose 3, cycle 1 (lines 4, 297)"]);
}

#[test]
fn the_output_folder_is_no_folder_of_inputs_however_it_is_written() {
    for output in ["exports", "./exports/.", ".", "encoders.csv", "exports/poses.txt"] {
        let to = format!("robot = \"robot.toml\"\noutput = \"{output}\"");
        broken("campaign.toml", "robot = \"robot.toml\"", &to, &["[input-in-output-folder]", "campaign.toml:3:10"]);
    }
    let scratch = copy_sample("prexyt-cmm");
    scratch.replace("campaign.toml", "robot = \"robot.toml\"", "robot = \"robot.toml\"\noutput = \".\"");
    let output = std::process::Command::new(crate::support::program())
        .args(["check", "campaign.toml"])
        .current_dir(scratch.path())
        .output()
        .unwrap();
    assert!(String::from_utf8_lossy(&output.stderr).contains("[input-in-output-folder]"), "{output:?}");
}

#[test]
fn statements_that_count_for_nothing_are_refused() {
    let campaign = |from: &str, to: &str, parts: &[&str]| broken("campaign.toml", from, to, parts);
    campaign("\"cycle\"]", "\"cycle\"]\ntargets = [\"K\"]", &["[targets-incomplete] target=L", "campaign.toml:"]);
    campaign("\"cycle\"]", "\"cycle\"]\ntolerance_s = 1.0", &["[key-of-other-join]: `tolerance_s`", "campaign.toml:"]);
    campaign(
        "\"cycle\"]",
        "\"cycle\"]\nclock_offset_s = 1.0",
        &["[key-of-other-join]: `clock_offset_s`", "campaign.toml:"],
    );
    campaign("\"rail2_a\", ", "\"rail2_a\", \"rail2_a\", ", &["[feature-label-twice]", ":31:21"]);
    campaign("calibration = \"1-8\"", "calibration = \"1-8, 13\"", &["[sets-overlap]", "13", ":43:14"]);
    let series = |stated: &str| format!("calibration = \"1-8\"\nseries = {stated}");
    campaign("calibration = \"1-8\"", &series("[\"1-9\", \"8-59\"]"), &["[series-overlap]", "8, 9", ":43:18"]);
    let none = ["error[selection-without-pose]: `series`", ":43:19"];
    campaign("calibration = \"1-8\"", &series("[\"rest\", \"90-99\"]"), &none);
    campaign("calibration = \"1-8\"", &series("[\"1-4\", \"6-59\"]"), &["[series-incomplete]", "5", ":43:11"]);
    campaign("calibration = \"1-8\"", &series("[\"all\"]"), &["[series-single]", ":43:11"]);
    campaign("calibration = \"1-8\"", &series("[\"1-8\", \"rest\"]"), &["[series-single]", ":43:11"]);
    campaign("by = [\"pose\", \"cycle\"]", "by = \"time\"", &["[join-clock-missing]", "campaign.toml:28:6"]);
    campaign("plane = [\"rail2_a\"", "line = [\"rail2_b\"]\nplane = [\"rail2_a\"", &["[feature-element]", ".toml:3"]);
    let delimited = "format = { delimiter = \"blank\", columns = [\"pose\", \"target\", \"x\", \"y\", \"z\"] }\ntarget = \"K\"\npose = \"row\"";
    campaign(
        "format = \"polyworks\"",
        delimited,
        &["[key-and-column]", "`pose`", "[key-and-column]", "`target`", "campaign.toml:"],
    );
}

#[test]
fn a_target_that_nobody_measured_points_at_the_campaign() {
    let scratch = copy_sample("prexyt-cmm");
    scratch.replace("exports/poses.txt", "L_", "M_");
    said(&scratch, &["[target-not-exported]", "`L`", "--> campaign/campaign.toml"]);
}

#[test]
fn a_log_in_another_dialect_is_told_which() {
    let scratch = copy_sample("prexyt-cmm");
    let text = std::fs::read_to_string(scratch.path().join("encoders.csv")).unwrap();
    std::fs::write(scratch.path().join("encoders.csv"), text.replace('.', "#").replace(',', ";").replace('#', ","))
        .unwrap();
    said(
        &scratch,
        &["error[delimiter-does-not-split]", "hint: set `delimiter = \";\"` and `decimal = \",\"`", "encoders.csv:1"],
    );
}

#[test]
fn a_numbered_column_beyond_the_width_is_said_once() {
    let scratch = copy_sample("prexyt-cmm");
    scratch.replace("campaign.toml", "rho3_mm = \"RP3\"", "rho3_mm = 9");
    let said = said(&scratch, &["error[column-number-unknown]", "campaign.toml:25"]);
    assert_eq!(said.lines().filter(|l| l.starts_with("error")).count(), 1, "{said}");
}

#[test]
fn names_with_quotes_and_accents_are_read() {
    let scratch = copy_sample("prexyt-cmm");
    std::fs::write(scratch.path().join("exports/more.txt"), "\"a\"\"éa\";1;2;3\n").unwrap();
    let more = "[[export]]\nfile = \"exports/more.txt\"\nunit = \"mm\"\nformat = { delimiter = \";\", columns = [\"label\", \"x\", \"y\", \"z\"] }\n[log]";
    scratch.replace("campaign.toml", "[log]", more);
    let (code, said) = etalon(&scratch, "check");
    assert_eq!(code, Some(0), "{said}");
    assert!(said.says("[labels-unused] count=1 label=a\"éa"), "{said}");
}

const PREXYT: &str = "model = \"prexyt\"\n[nominal]\ns = 394.0\nd = 116.0\n";

/// What `etalon identify` says about a table of observations that it refuses.
fn refused(robot: &str, table: &str) -> String {
    let scratch = copy_sample("prexyt-cmm");
    std::fs::write(scratch.root().join("robot.toml"), robot).unwrap();
    std::fs::write(scratch.root().join("observations.csv"), table).unwrap();
    let output = std::process::Command::new(crate::support::program())
        .args(["identify", "--robot", "robot.toml", "--observations", "observations.csv"])
        .current_dir(scratch.root())
        .output()
        .unwrap();
    let said = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{said}");
    said
}

#[test]
fn tables_of_observations_are_refused_with_the_line_itself() {
    let head = "pose,cycle,target,x_mm,y_mm,rho1_mm,rho2_mm,rho3_mm\n";
    let good = "1,1,K,1,2,3,4,5\n";
    for (rows, parts) in [
        ("1.5,1,L,1,2,3,4,5\n", ["observations.csv:3:1", "| 1.5,1,L,1,2,3,4,5", "[not-whole-number]: `1.5`"]),
        ("1e300,1,L,1,2,3,4,5\n", ["observations.csv:3:1", "| 1e300,1,L,1,2,3,4,5", "[not-whole-number]: `1e300`"]),
        ("\n\n1,1,L,1,x,3,4,5\n", ["observations.csv:5:9", "| 1,1,L,1,x,3,4,5", "[not-a-number]: `x`"]),
        ("1,1,L,inf,2,3,4,5\n", ["observations.csv:3:7", "| 1,1,L,inf,2,3,4,5", "[not-a-number]: `inf`"]),
        ("1,1,L,1,2,3,4\n", ["observations.csv:3", "| 1,1,L,1,2,3,4", "error[row-field-count] fields=7"]),
        ("1,1,L,1,2,3,4,5,6\n", ["observations.csv:3", "| 1,1,L,1,2,3,4,5,6", "error[row-field-count] fields=9"]),
        ("1,1,K,1,2,3,4,5\n", ["observations.csv:3", "| 1,1,K,1,2,3,4,5", "[target-repeated]"]),
    ] {
        let said = refused(PREXYT, &format!("{head}{good}{rows}"));
        assert!(parts.iter().all(|part| said.says(part)), "{parts:?}:\n{said}");
    }
    // all of a table's problems at once
    let said = refused(PREXYT, &format!("{head}{good}1.5,1,L,1,2,3,4,5\n2,1,K,1,x,3,4,5\n"));
    assert!(said.contains("observations.csv:3") && said.contains("observations.csv:4"), "{said}");
    let said = refused(PREXYT, &(head.replace("rho2_mm", "rho2").replace("x_mm", "x") + good));
    for part in ["[column-unknown]", "[column-unknown]", "observations.csv:1", "| pose,cycle,target,x,"] {
        assert!(said.says(part), "{part:?} is not said:\n{said}");
    }
    // repeats in a column of another name are readings of one target that occur twice
    let said = refused(PREXYT, &(head.replace("cycle", "run") + good + "1,2,K,1.01,2,3,4,5\n"));
    assert!(
        said.contains("observations.csv:3") && said.contains("[target-repeated]") && said.contains("column `cycle`"),
        "{said}"
    );
    let said = refused(PREXYT, &(head.replace("rho2_mm", "rho1_mm") + good));
    assert!(said.contains("error[heading-twice]") && said.contains("observations.csv:1"), "{said}");
}

#[test]
fn no_target_of_an_arm_is_called_base() {
    let joint = "[[joint]]\nalpha_deg = 0.0\na_mm = 0.0\ntheta_deg = 0.0\nd_mm = 290.0\n";
    let robot = format!("model = \"serial\"\n{joint}{joint}");
    let said = refused(&robot, "pose,cycle,target,x_mm,y_mm,z_mm,q1_deg,q2_deg\n1,1,base,1,2,3,4,5\n");
    assert!(said.contains("[target-called-base]"), "{said}");
}
