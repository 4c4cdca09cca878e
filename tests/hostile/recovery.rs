//! What is missing or does not read hides nothing else, and nobody draws conclusions from it.

use super::{ends, etalon};
use crate::support::scratch::{Scratch, copy_sample};

/// What `check` says of a campaign that it refuses; all `parts` are said.
fn refused(scratch: &Scratch, parts: &[&str]) -> String {
    ends(scratch, "check", 2, parts)
}

fn errors(said: &str) -> usize {
    said.lines().filter(|l| l.starts_with("error")).count()
}

#[test]
fn a_missing_key_hides_nothing_behind_it() {
    let scratch = copy_sample("prexyt-cmm");
    scratch.replace("campaign.toml", "coverage_factor", "coverage_facter");
    scratch.replace("campaign.toml", "towards = \"rail3_a\"", "towards = \"rail9_a\"");
    scratch.replace("campaign.toml", "\"RP3\"", "\"RP33\"");
    scratch.replace("campaign.toml", "exports/world.txt", "exports/word.txt");
    scratch.replace("robot.toml", "\nd3 = ", "\nd33 = ");
    let parts = [
        "[unknown-key]",
        "`coverage_facter`",
        "[key-missing]",
        "`coverage_factor`",
        "`instrument`",
        "`rail9_a`",
        "error[column-unknown]",
        "`RP33`",
        "[input-missing]",
        "`campaign/exports/word.txt`",
        "did you mean `world.txt`",
        "[nominal] contains `d33`",
    ];
    let said = refused(&scratch, &parts);
    assert_eq!(errors(&said), 5, "{said}");
}

#[test]
fn every_section_and_key_that_can_be_missing_leaves_the_rest_to_check() {
    let whole = copy_sample("prexyt-cmm");
    let text = std::fs::read_to_string(whole.path().join("campaign.toml")).unwrap();
    let keys = text.lines().filter(|l| l.contains(" = ") && !l.starts_with([' ', '#']));
    for line in keys.filter(|l| !["synthetic", "label", "validation"].iter().any(|k| l.starts_with(k))) {
        let scratch = copy_sample("prexyt-cmm");
        scratch.replace("robot.toml", "\nd3 = ", "\nd33 = ");
        let without = text.replacen(&format!("{line}\n"), "", 1);
        std::fs::write(scratch.path().join("campaign.toml"), without).unwrap();
        // where the name of the robot's file is missing nothing is known of it
        let (code, said) = etalon(&scratch, "check");
        assert!(code == Some(2) && !said.contains("panicked"), "{line}:\n{said}");
        assert!(said.contains("[nominal] contains `d33`") || line.starts_with("robot"), "{line}:\n{said}");
    }
}

#[test]
fn a_wrong_unit_is_one_error() {
    let scratch = copy_sample("prexyt-cmm");
    scratch.replace(
        "campaign.toml",
        "file = \"exports/world.txt\"\nformat = \"polyworks\"\nunit = \"mm\"",
        "file = \"exports/world.txt\"\nformat = \"polyworks\"\nunit = \"mmm\"",
    );
    assert_eq!(errors(&refused(&scratch, &["`mmm`"])), 1);
}

#[test]
fn a_column_for_a_joint_that_the_robot_does_not_have() {
    let scratch = copy_sample("prexyt-cmm");
    scratch.replace("campaign.toml", "rho3_mm = \"RP3\"", "rho4_mm = \"RP3\"");
    let parts =
        ["error[log-joint-unknown]: `rho4_mm`", "campaign.toml:25:77", "error[log-joint-missing]", "`log`", "`rho3`"];
    let said = refused(&scratch, &parts);
    assert_eq!(errors(&said), 2, "{said}");
}

const ARM: &str = "model = \"serial\"\ncoupling = [[2, 1], [3, 1]]\n\n";

/// Errors about an arm whose text is changed.
fn arm(change: impl Fn(String) -> String) -> String {
    let joint = "[[joint]]\nalpha_deg = 90.0\na_mm = 1.0\ntheta_deg = 0.0\nd_mm = 290.0\n";
    let scratch = copy_sample("prexyt-cmm");
    let robot = change(format!("{ARM}{joint}{joint}{joint}"));
    std::fs::write(scratch.root().join("robot.toml"), robot).unwrap();
    std::fs::write(scratch.root().join("o.csv"), "pose,cycle,target,x_mm,y_mm,z_mm,q1_deg\n").unwrap();
    let output = std::process::Command::new(crate::support::program())
        .args(["identify", "--robot", "robot.toml", "--observations", "o.csv"])
        .current_dir(scratch.root())
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(2));
    // the campaign's robot, too
    std::fs::copy(scratch.root().join("robot.toml"), scratch.path().join("robot.toml")).unwrap();
    let (_, said) = etalon(&scratch, "check");
    assert!(!said.contains("[joint-reference-wrong]"), "{said}");
    said
}

#[test]
fn a_joint_that_does_not_read_is_still_a_joint() {
    let said = arm(|text| text.replacen("a_mm = 1.0\n", "", 1));
    assert!(said.contains("[joint-key-missing]"), "{said}");
    // of the third joint, at its own place
    let said = arm(|text| text.trim_end().strip_suffix("d_mm = 290.0").unwrap().to_owned());
    assert!(said.contains("[joint-key-missing]") && said.contains("robot.toml:14:1"), "{said}");
    let said = arm(|text| text + "d_m = 0.29\n");
    assert!(said.contains("error[keys-state-the-same]: `d_mm`, `d_m` ") && said.contains("robot.toml:14:1"), "{said}");
    let said = arm(|text| text.replacen("a_mm = 1.0\n", "a_mm = \"one\"\n", 1));
    assert!(!said.contains("is missing"), "{said}");
}

#[test]
fn a_joint_without_its_head_is_one_error() {
    for nth in [1, 2] {
        let said = arm(|text| {
            text.split("[[joint]]\n")
                .enumerate()
                .map(|(i, part)| match i {
                    0 => part.to_owned(),
                    i if i == nth => part.to_owned(),
                    _ => format!("[[joint]]\n{part}"),
                })
                .collect()
        });
        assert_eq!(errors(&said), 1, "{said}");
        assert!(said.contains("[[joint]]"), "{said}");
    }
}

#[test]
fn geometry_of_the_robot_is_never_filled_in() {
    let scratch = copy_sample("prexyt-cmm");
    scratch.replace("robot.toml", "\ns = 394.0", "");
    refused(&scratch, &["[nominal-missing]", "`s`", "robot.toml", "hint: give the geometry"]);
    let scratch = copy_sample("prexyt-cmm");
    std::fs::write(scratch.path().join("robot.toml"), "model = \"prexyt\"\n").unwrap();
    refused(&scratch, &["[nominal-missing]", "`s`", "`d`"]);
    assert_eq!(etalon(&scratch, "run").0, Some(2));
}

#[test]
fn a_key_of_the_top_level_in_a_section_is_told_where_it_stands() {
    let scratch = copy_sample("prexyt-cmm");
    scratch.replace("campaign.toml", "coverage_factor = 2", "coverage_factor = 2\ntemperature_c = 20.0");
    assert_eq!(errors(&refused(&scratch, &["[unknown-key]", "`temperature_c`", "belongs at the top"])), 1);
}
