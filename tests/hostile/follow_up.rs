//! Hints that lead on: what one does next is what the message says.

use super::{ends, etalon};
use crate::support::said::Says;
use crate::support::scratch::{Scratch, copy_sample};

/// What is said of a campaign that is refused; every error has its hint, and all `parts` are said.
fn hinted(scratch: &Scratch, parts: &[&str]) -> String {
    let said = ends(scratch, "check", 2, parts);
    for error in format!("\n{said}").split("\nerror").skip(1) {
        assert!(error.contains("hint: "), "no hint: {error}\nin:\n{said}");
    }
    said
}

/// The sample after one replacement.
fn changed(file: &str, from: &str, to: &str) -> Scratch {
    let scratch = copy_sample("prexyt-cmm");
    scratch.replace(file, from, to);
    scratch
}

#[test]
fn errors_about_files_say_what_to_do() {
    hinted(&changed("campaign.toml", "exports/world.txt", "exports/wrld.txt"), &["did you mean `world.txt`"]);
    hinted(&changed("campaign.toml", "\"encoders.csv\"", "\"q.csv\""), &["etalon simulate campaign"]);
    let scratch = changed("campaign.toml", "exports/world.txt", "exports");
    hinted(&scratch, &["[input-is-folder]: `campaign/exports`", "poses.txt"]);
    let scratch = copy_sample("prexyt-cmm");
    std::fs::write(scratch.path().join("exports/world.txt"), "").unwrap();
    hinted(&scratch, &["[export-empty]"]);
    let text =
        "[instrument]\nname = \"Mitutoyo BRIGHT-STRATO 7106\"\nexpanded_uncertainty_um = 2.7\ncoverage_factor = 2\n";
    hinted(&changed("campaign.toml", text, ""), &["[key-missing]", "`instrument`", "calibration certificate"]);
}

#[test]
fn errors_about_values_say_what_to_do() {
    let scratch = changed("campaign.toml", "validation = \"9-59\"", "validation = \"90-99\"");
    hinted(
        &scratch,
        &["error[selection-without-pose]: `validation`", "59 poses are measured and joined, from 1 to 59"],
    );
    for (cell, id) in [("x9", "[not-a-number]: `x9`"), ("1e", "[not-a-number]: `1e`")] {
        let scratch = copy_sample("prexyt-cmm");
        let text = std::fs::read_to_string(scratch.path().join("encoders.csv")).unwrap();
        let line = text.lines().nth(1).unwrap();
        let (head, _) = line.rsplit_once(',').unwrap();
        std::fs::write(scratch.path().join("encoders.csv"), text.replacen(line, &format!("{head},{cell}"), 1)).unwrap();
        hinted(&scratch, &[id, "encoders.csv:2"]);
    }
    hinted(&changed("campaign.toml", "by = [\"pose\", \"cycle\"]", "by = \"row\""), &["equal numbers of rows"]);
}

#[test]
fn an_assembly_mode_that_is_none_has_its_line() {
    let scratch = copy_sample("dextar");
    let text = std::fs::read_to_string(scratch.path().join("encoders.csv")).unwrap();
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    let column = lines[0].split(',').position(|name| name == "assembly").unwrap();
    let mut cells: Vec<&str> = lines[6].split(',').collect();
    cells[column] = "0";
    lines[6] = cells.join(",");
    std::fs::write(scratch.path().join("encoders.csv"), lines.join("\n") + "\n").unwrap();
    hinted(&scratch, &["error[assembly-mode-invalid]", "encoders.csv:7:", "expected: 1 or -1"]);
}

#[test]
fn a_pattern_that_no_label_has_points_at_the_pattern() {
    let scratch = changed("campaign.toml", "{target}_{pose}_{cycle}", "{target}-{pose}-{cycle}");
    let said = hinted(&scratch, &["[label-form-differs]", "`{target}-{pose}-{cycle}`", "campaign.toml:21", "`K_1_1`"]);
    assert_eq!(said.lines().filter(|l| l.starts_with("error")).count(), 1, "{said}");
}

#[test]
fn labels_of_poses_are_not_proposed_for_a_frame() {
    let scratch = changed("exports/world.txt", "R_end", "S_last");
    let said = hinted(&scratch, &["`R_end`", "R_home"]);
    assert!(!said.contains("K_1"), "{said}");
}

#[test]
fn a_run_that_fails_keeps_its_warnings_and_tells_of_the_run_before() {
    let scratch = copy_sample("prexyt-cmm");
    assert_eq!(etalon(&scratch, "run").0, Some(0));
    let log = std::fs::read_to_string(scratch.path().join("encoders.csv")).unwrap();
    let row = log.lines().nth(3).unwrap().to_owned() + "\n";
    std::fs::write(scratch.path().join("encoders.csv"), log.replacen(&row, "", 1)).unwrap();
    scratch.replace("campaign.toml", "[limits]", "hold = [\"*\"]\n[limits]");
    let (code, said) = etalon(&scratch, "run");
    assert_eq!(code, Some(2), "{said}");
    for part in ["warning[keys-unmatched] of=points count=1", "error", "warning[earlier-run-left]"] {
        assert!(said.says(part), "{part:?} is not said:\n{said}");
    }
}
