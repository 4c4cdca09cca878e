//! `etalon formats A B ...`: the printed lines run as they are. All data are synthetic.

use super::program;
use super::robot::{measured, robot};
use crate::support::root;
use crate::support::said::Says;
use std::fmt::Write;
use std::path::Path;

const HEAD: &str = "name = \"c\"\nrobot = \"nominal/robot.toml\"\n[instrument]\nname = \"i\"\nexpanded_uncertainty_um = 20\ncoverage_factor = 2\n\n";
const TARGET: [f64; 3] = [60.0, -40.0, 120.0];

/// Prints the lines of files, and runs them as a campaign.
fn run(at: &Path, files: &[&str], parts: &[&str]) {
    let arguments = [&["formats"], files, &["--robot", "nominal/robot.toml"]].concat();
    let output =
        std::process::Command::new(crate::support::program()).args(&arguments).current_dir(at).output().unwrap();
    let lines = String::from_utf8(output.stdout).unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    for part in parts {
        assert!(lines.contains(part), "{part}: {lines}");
    }
    let campaign = format!("{HEAD}{lines}\n[identify]\ncalibration = \"all\"\n");
    std::fs::write(at.join("campaign.toml"), campaign).unwrap();
    let (code, said) = program(at, &["run", "."]);
    assert_eq!(code, Some(0), "{said}\n{lines}");
    let document: etalon::documents::ParametersDocument = crate::support::document(&at.join("out/parameters.json"));
    assert!(document.residuals.rms < 0.03, "{}", document.residuals.rms);
}

#[test]
fn the_lines_of_an_export_and_a_log_run_as_they_are() {
    let folder = tempfile::tempdir().unwrap();
    let (at, arm) = (folder.path(), robot(folder.path()));
    let rows = measured(arm.as_ref(), 60, TARGET, 1.0, 3);
    // by row: the log in rad with the fourth joint against its direction, the points in metres
    let (mut log, mut points) = ("j1,j2,j3,j4,j5,j6\n".to_owned(), "X;Y;Z\n".to_owned());
    for (q, p) in &rows {
        let _ = writeln!(log, "{},{},{},{},{},{}", q[0], q[1], q[2], -q[3], q[4], q[5]);
        let cells: Vec<String> = p.iter().map(|v| format!("{:.7}", v / 1000.0).replace('.', ",")).collect();
        let _ = writeln!(points, "{}", cells.join(";"));
    }
    std::fs::write(at.join("log.csv"), log).unwrap();
    std::fs::write(at.join("points.csv"), points).unwrap();
    let parts = [
        "# `points.csv`: export, 60 rows, coordinates in m",
        "# `log.csv`: log, 60 rows, joints in rad",
        "60 of 60 rows of `points.csv` match a row of `log.csv` by row",
        "q4_rad = { name = \"j4\", per_count = -1 }",
    ];
    run(at, &["points.csv", "log.csv"], &parts);
    // by pose in labels, of a log in another order with poses that were not measured
    let (mut log, mut points) = ("pose,j1,j2,j3,j4,j5,j6\n".to_owned(), "Name,X,Y,Z\n".to_owned());
    for (i, (q, p)) in (1..).zip(&rows) {
        if i <= 50 {
            let _ = writeln!(points, "SMR-{i},{:.4},{:.4},{:.4}", p[0], p[1], p[2]);
        }
        let q: Vec<String> = q.iter().map(|v| v.to_degrees().to_string()).collect();
        let _ = writeln!(log, "{i},{}", q.join(","));
    }
    let (head, body) = log.split_once('\n').unwrap();
    let turned: Vec<&str> = body.lines().rev().collect();
    std::fs::write(at.join("log.csv"), format!("{head}\n{}\n", turned.join("\n"))).unwrap();
    std::fs::write(at.join("points.csv"), points).unwrap();
    let parts = [
        "50 of 50 rows of `points.csv` match a row of `log.csv` by pose",
        "by = [\"pose\"]",
        "label = \"{target}-{pose}\"   # all 50 labels have this form",
        "targets = [\"SMR\"]",
        "`X`, `Y`, `Z`",
    ];
    run(at, &["log.csv", "points.csv"], &parts);
}

#[test]
fn files_that_nothing_joins_and_rows_of_other_poses_are_doubted() {
    let folder = tempfile::tempdir().unwrap();
    let (at, arm) = (folder.path(), robot(folder.path()));
    let rows = measured(arm.as_ref(), 60, TARGET, 1.0, 3);
    let (mut log, mut points) = ("j1,j2,j3,j4,j5,j6\n".to_owned(), "X,Y,Z\n".to_owned());
    for (i, (q, _)) in rows.iter().enumerate() {
        let cells: Vec<String> = q.iter().map(f64::to_string).collect();
        let _ = writeln!(log, "{}", cells.join(","));
        // the rows of the points are in another order
        let p = rows[(i * 7 + 3) % 60].1;
        let _ = writeln!(points, "{:.4},{:.4},{:.4}", p[0], p[1], p[2]);
    }
    std::fs::write(at.join("log.csv"), &log).unwrap();
    std::fs::write(at.join("points.csv"), &points).unwrap();
    let (code, said) = program(at, &["formats", "points.csv", "log.csv", "--robot", "nominal/robot.toml"]);
    assert!(code == Some(0) && said.contains("# DOUBT"), "{said}");
    // other numbers of rows, and no other key
    let short: String = points.lines().take(50).map(|line| format!("{line}\n")).collect();
    std::fs::write(at.join("points.csv"), short).unwrap();
    let (code, said) = program(at, &["formats", "points.csv", "log.csv"]);
    assert!(code == Some(0) && said.contains("by = \"?\"") && said.has_phrase("files-not-joined"), "{said}");
}

#[test]
fn attained_and_commanded_poses_are_one_section() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let corpus = root().join("tests/formats/corpus");
    for name in ["own-poses.csv", "own-commanded.csv"] {
        std::fs::copy(corpus.join(name), at.join(name)).unwrap();
    }
    let (code, said) = program(at, &["formats", "own-poses.csv", "own-commanded.csv"]);
    let section = "[poses]\nattained = \"own-poses.csv\"\ncommanded = \"own-commanded.csv\"\n";
    assert!(code == Some(0) && said.contains(section) && !said.contains("\"?\""), "{said}");
}
