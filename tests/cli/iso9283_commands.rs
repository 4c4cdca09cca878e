//! `etalon iso9283 pose | path | compliance | plan`: the same as by options, and repeatability without commanded poses.

use super::{etalon, text, text_of};
use crate::support::root;
use crate::support::said::Says;
use serde_json::Value;
use std::path::PathBuf;

fn sample() -> PathBuf {
    root().join("samples/pose-test")
}

fn json(arguments: &[&str]) -> Value {
    let output = etalon(&sample(), arguments);
    assert_eq!(output.status.code(), Some(0), "{arguments:?}: {}", text_of(&output));
    serde_json::from_slice(&output.stdout).unwrap()
}

#[test]
fn commands_by_what_they_test_are_those_by_options() {
    let poses = ["poses.csv", "--commanded", "commanded.csv", "--json"];
    let by_command = json(&[&["iso9283", "pose"], &poses[..]].concat());
    assert_eq!(by_command, json(&[&["iso9283"], &poses[..]].concat()));
    assert!(by_command[0]["ap_mm"].is_f64());
    assert_eq!(
        json(&["iso9283", "compliance", "loads.csv", "--json"]),
        json(&["iso9283", "--compliance", "loads.csv", "--json"])
    );
    let workspace = ["--workspace-mm", "300,-250,100,900,350,500", "--json"];
    assert_eq!(
        json(&[&["iso9283", "plan"], &workspace[..]].concat()),
        json(&[&["iso9283", "--plan"], &workspace[..]].concat())
    );
    // 1 s at each of two places, and 0.2 s between them
    let at = |i: usize| 100.0 * (((i % 240) as f64 - 100.0) / 20.0).clamp(0.0, 1.0);
    let row =
        |i: usize| format!("{},{},{}\n", i as f64 / 100.0, at(i) + 0.001 * (i % 3) as f64, 0.001 * (i % 2) as f64);
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("motion.csv");
    std::fs::write(&file, format!("time_s,x_mm,y_mm\n{}", (0..230).map(row).collect::<String>())).unwrap();
    let motion = [file.to_str().unwrap(), "--band-mm", "0.1", "--json"];
    assert_eq!(
        json(&[&["iso9283", "path"], &motion[..]].concat()),
        json(&[&["iso9283", "--stream"], &motion[..]].concat())
    );
}

#[test]
fn repeatability_needs_no_commanded_poses() {
    let both = json(&["iso9283", "pose", "poses.csv", "--commanded", "commanded.csv", "--json"]);
    let alone = json(&["iso9283", "pose", "poses.csv", "--json"]);
    assert_eq!(both.as_array().unwrap().len(), alone.as_array().unwrap().len());
    for (both, alone) in both.as_array().unwrap().iter().zip(alone.as_array().unwrap()) {
        for key in ["pose", "cycles", "rp_mm", "mean_radius_mm", "sd_radius_mm", "rp_interval", "rp_a_deg"] {
            assert_eq!(both[key], alone[key], "{key}");
        }
        for key in ["ap_mm", "ap_x_mm", "ap_y_mm", "ap_interval"] {
            assert!(alone[key].is_null() && !both[key].is_null(), "{key}");
        }
        assert!(alone.get("ap_a_deg").is_none());
    }
    let output = etalon(&sample(), &["iso9283", "pose", "poses.csv", "--all", "--json"]);
    assert!(text_of(&output).contains("warning[commanded-missing]"), "{}", text_of(&output));
    // thirty cycles from a cold start, and no sets of cycles are stated
    assert!(text_of(&output).contains("warning[positions-drift]"), "{}", text_of(&output));
    let stated = etalon(
        &sample(),
        &["iso9283", "pose", "poses.csv", "--commanded", "commanded.csv", "--all", "--drift-set", "5"],
    );
    assert!(!text_of(&stated).contains("[positions-drift]"), "{}", text_of(&stated));
    let all: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert!(all["distances"].as_array().unwrap().is_empty() && all["drifts"].as_array().unwrap().is_empty());
    assert!(all["conventions"].to_string().has_phrase("convention-no-commanded-poses"));
    let printed = etalon(&sample(), &["iso9283", "pose", "poses.csv", "--rp-limit-mm", "0.5"]);
    assert_eq!(printed.status.code(), Some(0), "{}", text_of(&printed));
    assert!(text(&printed.stdout).contains("RP"));
}

#[test]
fn options_that_contradict_are_refused() {
    for (arguments, part) in [
        (&["iso9283", "pose", "poses.csv", "--ap-limit-mm", "0.5"][..], "--commanded"),
        (&["iso9283", "pose"], "<POSES>"),
        (&["iso9283"], "<POSES|--stream"),
        (&["iso9283", "plan"], "error[workspace-numbers] count=0"),
        (&["iso9283", "pose", "poses.csv", "--stream", "poses.csv"], "--stream"),
        (&["iso9283", "poses.csv", "--workspace-mm", "1,2,3,4"], "--workspace-mm"),
        (&["iso9283", "path", "nothing.csv"], "nothing.csv"),
    ] {
        let output = etalon(&sample(), arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(text_of(&output).says(part), "{arguments:?}: {}", text_of(&output));
    }
}
