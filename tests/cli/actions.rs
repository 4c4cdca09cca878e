//! Next steps of reports: their files exist, and their commands run.

use crate::support::samples::{Ran, ran};
use crate::support::scratch::{copy_sample, ends};
use serde_json::Value;
use std::path::Path;
use std::process::Command;

/// Checks the files of the actions in a campaign's folder, and runs their commands.
fn check(name: &str, folder: &Path, verdict: &Value) -> usize {
    let none = Vec::new();
    let actions = verdict["actions"].as_array().unwrap_or(&none);
    assert!(actions.len() <= 5, "{name}: {actions:#?}");
    let mut commands = 0;
    for action in actions {
        assert!(action["what"].as_str().is_some_and(|t| !t.is_empty()), "{name}: {action}");
        assert!(action["reason"].as_str().is_some_and(|t| !t.is_empty()), "{name}: {action}");
        if action["action"] == "load" {
            let file = folder.join("out").join(action["file"].as_str().unwrap());
            assert!(file.is_file(), "{name}: {action}");
        }
        let Some(command) = action["command"].as_str() else { continue };
        let mut words = command.split(' ');
        assert_eq!(words.next(), Some("etalon"), "{name}: {action}");
        let ended = Command::new(crate::support::program()).args(words).current_dir(folder).output().unwrap();
        assert!(ended.status.code() < Some(2), "{name}: {command}: {}", String::from_utf8_lossy(&ended.stderr));
        commands += 1;
    }
    commands
}

#[test]
fn steps_of_every_sample_are_true_and_their_commands_run() {
    let mut loaded = 0;
    for Ran { name, folder } in ran() {
        let of = Ran { name: name.clone(), folder: folder.clone() };
        let verdict = of.document("verdict.json");
        check(name, folder, &verdict);
        let steps = verdict["actions"].as_array().cloned().unwrap_or_default();
        loaded += steps.iter().filter(|a| a["action"] == "load").count();
        // the step repeats the numbers of the errors
        for step in steps.iter().filter(|a| a["action"] == "load") {
            let accuracy = of.document("accuracy.json");
            let sets = accuracy["sets"].as_array().unwrap();
            let errors = &sets.last().unwrap()["errors"][0];
            let gain = errors["before"]["rms"].as_f64().unwrap() - errors["after"]["rms"].as_f64().unwrap();
            // a format may leave parameters out
            assert!(step["gain_mm"].as_f64().unwrap() <= gain + 1e-9, "{name}: {step}");
        }
    }
    assert!(ran().len() >= 18 && loaded >= 10, "{} samples, {loaded} to load", ran().len());
}

/// A limit far below what the sample reaches: nothing is to be loaded, and the search for the cause
/// begins with a command.
#[test]
fn the_steps_of_a_failed_calibration_run() {
    let scratch = copy_sample("prexyt-cmm");
    scratch.replace("campaign.toml", "position_max_mm = 0.044", "position_max_mm = 0.001");
    ends(&scratch, "run", 1, &[]);
    let verdict: Value = scratch.document("verdict.json");
    let actions = verdict["actions"].as_array().unwrap();
    assert!(actions.iter().all(|a| a["action"] != "load"), "{actions:#?}");
    assert!(actions.iter().any(|a| a["action"] == "meet_limit"), "{actions:#?}");
    assert!(check("prexyt-cmm", &scratch.path(), &verdict) > 0);
}

/// A last day of validity is a date that follows the measurements.
#[test]
fn a_last_day_of_validity_is_a_date_after_the_measurements() {
    let name = "name = \"PreXYT, CMM (synthetic)\"";
    for (stated, id) in [
        ("date = \"2026-03-02\"\nreport = { issued = \"2026-02-27\" }", "dates-out-of-order"),
        ("date = \"2026-03-02\"\nconditions = { robot_received = \"2026-03-03\" }", "dates-out-of-order"),
        ("conditions = { robot_received = \"2026-02-30\" }", "date-invalid"),
        ("valid_until = \"next year\"", "valid-until-no-date"),
        ("date = \"2026-03-02\"\nvalid_until = \"2026-03-01\"", "valid-until-before-measurements"),
        ("date = \"2026-03-02\"\nvalid_until = \"2027-03-01\"\nvalid_for_months = 12", "valid-stated-twice"),
        ("valid_for_months = 12", "valid-months-without-date"),
        ("date = \"in spring\"\nvalid_for_months = 12", "valid-months-without-date"),
        ("date = \"2026-03-02\"\nvalid_for_months = 365", "valid-months-implausible"),
        ("date = \"2026-03-02\"\nvalid_for_months = 0", "valid-months-implausible"),
    ] {
        let scratch = copy_sample("prexyt-cmm");
        scratch.replace("campaign.toml", name, &format!("{name}\n{stated}"));
        ends(&scratch, "check", 2, &[id]);
    }
    let scratch = copy_sample("prexyt-cmm");
    scratch.replace("campaign.toml", name, &format!("{name}\ndate = \"2026-03-02\"\nvalid_until = \"2027-03-02\""));
    ends(&scratch, "run", 0, &[]);
    let campaign = std::fs::read_to_string(scratch.path().join("out/campaign.json")).unwrap();
    assert!(campaign.contains("\"valid_until\": \"2027-03-02\""), "{campaign}");
}

/// Parameters state their last day of validity, and commands that use them compare it with today.
/// Nothing that is written depends on today.
#[test]
fn commands_warn_of_parameters_whose_validity_has_passed() {
    let scratch = copy_sample("prexyt-cmm");
    let name = "name = \"PreXYT, CMM (synthetic)\"";
    scratch.replace("campaign.toml", name, &format!("{name}\ndate = \"2026-03-31\"\nvalid_for_months = 11"));
    ends(&scratch, "run", 0, &[]);
    let out = scratch.path().join("out");
    let parameters: Value = crate::support::document(&out.join("parameters.json"));
    assert_eq!(parameters["valid_until"], "2027-02-28");
    // seconds of 2027-02-28 and 2027-03-01, both at noon (`date -u -d`)
    let exported = |seconds: &str| {
        let mut command = Command::new(crate::support::program());
        command.args(["export", "out/parameters.json", "--format", "c-header"]).current_dir(scratch.path());
        let ended = command.env("SOURCE_DATE_EPOCH", seconds).output().unwrap();
        let header = std::fs::read_dir(&out).unwrap().flatten().map(|file| file.path());
        let header = header.into_iter().find(|path| path.extension().is_some_and(|e| e == "h")).expect("a header");
        assert_eq!(ended.status.code(), Some(0));
        (String::from_utf8_lossy(&ended.stderr).into_owned(), std::fs::read_to_string(header).unwrap())
    };
    let (in_time, late) = (exported("1803816000"), exported("1803902400"));
    assert!(!in_time.0.contains("parameters-expired") && late.0.contains("parameters-expired"), "{late:?}");
    assert_eq!(in_time.1, late.1);
    assert!(late.1.contains("valid until: 2027-02-28"), "{}", late.1);
}
