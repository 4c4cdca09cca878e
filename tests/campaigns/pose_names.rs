//! Poses that have names: the same result as with numbers, and names that are mistaken.

use crate::support::scratch::{Scratch, copy_sample, ends, said};
use etalon::documents::{ParameterEntry, ParametersDocument};

/// The CMM sample with names of poses in exports and log; `written` is how the log writes them.
fn named(name: fn(i64) -> String, written: fn(i64) -> String) -> Scratch {
    let scratch = copy_sample("prexyt-cmm");
    let change = |file: &str, change: &dyn Fn(&str) -> String| {
        let path = scratch.path().join(file);
        let text = std::fs::read_to_string(&path).unwrap();
        std::fs::write(path, text.lines().map(|line| change(line) + "\n").collect::<String>()).unwrap();
    };
    change("exports/poses.txt", &|line| {
        let parts: Vec<&str> = line.splitn(3, '_').collect();
        format!("{}_{}_{}", parts[0], name(parts[1].parse().unwrap()), parts[2])
    });
    change("encoders.csv", &|line| {
        let parts: Vec<&str> = line.splitn(3, ',').collect();
        let pose = parts[1].parse().map_or_else(|_| parts[1].to_owned(), written);
        format!("{},{pose},{}", parts[0], parts[2])
    });
    scratch
}

/// Names of all kinds: poses 1 to 8 have the names of the calibration.
fn any(pose: i64) -> String {
    match pose {
        1 => "home".to_owned(),
        2 => "P_home".to_owned(),
        3 => "A-3".to_owned(),
        4 => "10b".to_owned(),
        5..=8 => pose.to_string(),
        9..=30 => format!("Q{pose}"),
        _ => format!("Prüf{pose}"),
    }
}

fn parameters(scratch: &Scratch) -> Vec<ParameterEntry> {
    let text = std::fs::read_to_string(scratch.path().join("out/parameters.json")).unwrap();
    serde_json::from_str::<ParametersDocument>(&text).unwrap().parameters
}

#[test]
fn names_of_poses_change_no_result() {
    let numbers = copy_sample("prexyt-cmm");
    ends(&numbers, "run", 0, &[]);
    let scratch = named(any, any);
    let selected = "calibration = [\"home\", \"P_home\", \"A-3\", \"10b\", \"5-8\"]";
    scratch.replace("campaign.toml", "calibration = \"1-8\"", selected);
    scratch.replace("campaign.toml", "validation = \"9-59\"", "validation = \"Q9-Q30, Prüf31-Prüf59\"");
    ends(&scratch, "check", 0, &[]);
    ends(&scratch, "run", 0, &[]);
    for (a, b) in parameters(&numbers).iter().zip(parameters(&scratch)) {
        let (of_numbers, of_names) = (a.value, b.value);
        assert!(
            (of_numbers - of_names).abs() < 1e-9 * of_numbers.abs().max(1.0),
            "{}: {of_numbers} {of_names}",
            a.name
        );
    }
    let table = std::fs::read_to_string(scratch.path().join("out/observations.csv")).unwrap();
    let mut order: Vec<&str> = table.lines().skip(1).map(|line| line.split(',').next().unwrap()).collect();
    order.dedup();
    assert_eq!(order[..10], ["5", "6", "7", "8", "10b", "A-3", "P_home", "Prüf31", "Prüf32", "Prüf33"]);
    assert_eq!(order[order.len() - 3..], ["Q29", "Q30", "home"]);
    // the table is what identify reads
    let identified = said(
        &scratch,
        &["identify", "--robot", "campaign/robot.toml", "--observations", "campaign/out/observations.csv", "--json"],
    );
    assert_eq!(identified.0, Some(0), "{}", identified.1);
    let report = std::fs::read_to_string(scratch.path().join("out/report.html")).unwrap();
    assert!(report.contains("P_home") && report.contains("Prüf59"));
}

#[test]
fn an_excluded_pose_has_a_name() {
    let scratch = named(any, any);
    let selected = "calibration = [\"home\", \"P_home\", \"A-3\", \"10b\", \"5-8\"]";
    scratch.replace("campaign.toml", "calibration = \"1-8\"", selected);
    scratch.replace(
        "campaign.toml",
        "validation = \"9-59\"",
        "validation = \"rest\"\n[[identify.exclude]]\nposes = [\"Q9\", \"Prüf31-Prüf33\"]\nreason = \"ball loose\"",
    );
    ends(&scratch, "run", 0, &["excluded: 40 readings, poses Q9, Prüf31-Prüf33: ball loose"]);
    scratch.replace("campaign.toml", "[\"Q9\", ", "[\"Q99\", ");
    ends(&scratch, "run", 2, &["error[exclusion-matches-nothing] of=poses name=Q99"]);
}

#[test]
fn mistaken_names_of_poses_are_named() {
    // a typo in a selection
    let scratch = named(any, any);
    scratch.replace("campaign.toml", "calibration = \"1-8\"", "calibration = \"hume, P_home, A-3, 10b, 5-8\"");
    scratch.replace("campaign.toml", "validation = \"9-59\"", "validation = \"rest\"");
    ends(&scratch, "check", 2, &["error[selected-pose-unmeasured]: `hume`", "did you mean `home`"]);
    // one pose in two spellings, in two files
    let scratch = named(|pose| format!("P{pose}"), |pose| format!("p0{pose}"));
    ends(&scratch, "check", 2, &["error[pose-name-two-spellings] first=P1 second=p01", "encoders.csv:2"]);
    // other names in the log
    let scratch = named(|pose| pose.to_string(), |pose| format!("P{pose}"));
    ends(
        &scratch,
        "check",
        2,
        &["error[pose-misspelt] of=log pose=P1 log=log", "encoders.csv:2", "use one of: 1, 10,"],
    );
    // a typo in the log: its pose has no partner
    let scratch = named(any, |pose| if pose == 1 { "hom".to_owned() } else { any(pose) });
    scratch.replace("campaign.toml", "calibration = \"1-8\"", "calibration = \"P_home, A-3, 10b, 5-8\"");
    scratch.replace("campaign.toml", "validation = \"9-59\"", "validation = \"rest\"");
    ends(
        &scratch,
        "check",
        2,
        &["error[pose-misspelt] of=log pose=hom log=log", "encoders.csv:2", "did you mean `home`"],
    );
}
