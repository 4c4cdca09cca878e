//! `etalon verify` of every sample with its own data, and of samples without a position.

use super::{etalon, text};
use crate::support::samples::{Ran, ran};
use crate::support::scratch::copy_sample;
use serde_json::Value;
use std::path::Path;

/// The answer about observations, and its exit code.
fn verified(folder: &Path, observations: &str) -> (Value, Option<i32>) {
    let verify = ["verify", observations, "--robot", "robot.toml", "--parameters", "out/parameters.json", "--json"];
    let output = etalon(folder, &verify);
    let answer = serde_json::from_slice(&output.stdout);
    let failed = |e| panic!("{} {observations}: {e}: {}", folder.display(), text(&output.stderr));
    (answer.unwrap_or_else(failed), output.status.code())
}

/// Synthetic samples with identified parameters.
fn identified() -> impl Iterator<Item = &'static Ran> {
    let is_identified = |sample: &&Ran| sample.folder.join("out/parameters.json").is_file();
    ran().iter().filter(is_identified).filter(|sample| !sample.document("campaign.json")["synthetic"].is_null())
}

/// The readings of the calibration, as campaign and as its table: the robot has not changed, and the exit code says that nothing new was measured.
#[test]
fn every_sample_is_valid_with_its_own_data() {
    for sample in identified() {
        for observations in ["out/observations.csv", "."] {
            let (answer, code) = verified(&sample.folder, observations);
            let said = format!("{} {observations}: {answer}", sample.name);
            assert!(answer["verdict"] == "valid" && code == Some(1), "{said}");
            let messages = answer["messages"].to_string();
            assert!(answer["copies"].as_u64() > Some(0) && messages.contains("readings-of-calibration"), "{said}");
        }
    }
    assert!(identified().count() > 20);
}

/// Contacts, distances, planes and closures show a zero that moved by 0.1 deg after the calibration.
#[test]
fn a_zero_that_moved_is_found_without_positions() {
    for (sample, joint) in
        [("contacts", "q3_deg"), ("draw-wire", "q3_deg"), ("surfaces", "q3_deg"), ("two-arms", "left_q3_deg")]
    {
        let scratch = copy_sample(sample);
        assert!(etalon(&scratch.path(), &["run", "."]).status.code() < Some(2), "{sample}");
        let observed = std::fs::read_to_string(scratch.path().join("out/observations.csv")).unwrap();
        let mut lines = observed.lines();
        let head = lines.next().unwrap();
        let column = head.split(',').position(|name| name == joint).unwrap_or_else(|| panic!("{sample}: {head}"));
        let moved = |line: &str| {
            let mut cells: Vec<String> = line.split(',').map(str::to_owned).collect();
            if let Ok(value) = cells[column].parse::<f64>() {
                cells[column] = (value + 0.1).to_string();
            }
            cells.join(",")
        };
        let table = std::iter::once(head.to_owned()).chain(lines.map(moved)).collect::<Vec<_>>().join("\n");
        std::fs::write(scratch.path().join("later.csv"), table + "\n").unwrap();
        let (answer, code) = verified(&scratch.path(), "later.csv");
        assert!(answer["verdict"] != "valid" && code == Some(1), "{sample}: {answer}");
        assert!(answer["copies"].is_null(), "{sample}: {answer}");
    }
}
