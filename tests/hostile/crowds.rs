//! Many targets at one place, and wide tables: the answer takes a time in proportion to their number.

use crate::support::scratch::copy_sample;
use crate::support::{program, run_for};
use etalon::base::noise::Noise;
use std::process::Command;
use std::time::Duration;

/// Longest answer.
const LIMIT: Duration = Duration::from_secs(120);

/// Exit code and stderr of `etalon check` of the hexapod's sample with targets at the place of SMR_1 in each pose, also as a rigid
/// part.
fn check(targets: usize, scatter_mm: f64, rigid: bool) -> (Option<i32>, String) {
    let scratch = copy_sample("hexapod");
    let path = scratch.path().join("exports/poses.txt");
    let mut rows = std::fs::read_to_string(&path).unwrap();
    let own: Vec<String> = rows.lines().filter(|row| row.starts_with("SMR_1_")).map(str::to_owned).collect();
    let mut noise = Noise::new(59, targets as u64);
    for row in own.iter().filter(|row| row.split(',').next().unwrap().ends_with("_1")) {
        let cells: Vec<&str> = row.split(',').collect();
        let at: Vec<f64> = cells[1..4].iter().map(|cell| cell.parse().unwrap()).collect();
        for k in 0..targets {
            let at: Vec<String> = at.iter().map(|v| format!("{:.4}", v + noise.gaussian(scatter_mm))).collect();
            rows += &format!("{},{}\n", cells[0].replacen("SMR_1", &format!("D{k}"), 1), at.join(","));
        }
    }
    std::fs::write(&path, rows).unwrap();
    let names: Vec<String> = (0..targets).map(|k| format!("\"D{k}\"")).collect();
    scratch.replace("campaign.toml", "\"SMR_3\"]", &format!("\"SMR_3\", {}]", names.join(", ")));
    if rigid {
        let text = std::fs::read_to_string(scratch.path().join("campaign.toml")).unwrap();
        let part = format!("\n[[rigid]]\ntargets = [{}]\ntolerance_mm = 0.5\n", names.join(", "));
        std::fs::write(scratch.path().join("campaign.toml"), text + &part).unwrap();
    }
    let mut command = Command::new(program());
    command.args(["check", "campaign"]).current_dir(scratch.root());
    let ended = run_for(&mut command, LIMIT).expect("it takes too long");
    (ended.code, ended.stderr)
}

#[test]
fn targets_at_one_place_are_checked_in_time() {
    let (code, said) = check(334, 0.03, false);
    assert!(code == Some(0) && said.contains("[point-pairs-many]"), "{said}");
    assert!(said.len() < 100_000, "{} bytes", said.len());
    let (code, said) = check(334, 0.03, true);
    assert!(code == Some(0) && said.contains("[rigid-pairs-sampled]"), "{said}");
    // of few targets all pairs are compared
    let (code, said) = check(20, 0.0, true);
    assert!(code == Some(0) && !said.contains("[rigid-pairs-sampled]"), "{said}");
}

#[test]
fn the_format_of_a_wide_table_is_proposed_in_time() {
    let folder = tempfile::tempdir().unwrap();
    let head: Vec<String> = (0..50_000).map(|i| format!("q{i}")).collect();
    let row: Vec<String> = (0..50_000).map(|i| format!("{:.3}", f64::from(i) * 0.37 % 100.0)).collect();
    let text = [head.join(","), row.join(","), row.join(",")].join("\n");
    std::fs::write(folder.path().join("t.csv"), text).unwrap();
    let mut command = Command::new(program());
    command.args(["formats", "t.csv", "--json"]).current_dir(folder.path());
    let ended = run_for(&mut command, LIMIT).expect("it takes too long");
    assert!(
        ended.code == Some(0) && ended.stdout.contains("first 4096 of 50000 columns"),
        "{:?} {}",
        ended.code,
        ended.stderr
    );
}
