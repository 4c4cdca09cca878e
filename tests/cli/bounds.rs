//! The bound of the uncertainties of answers that may be loaded, and values that encoders do not have.

use super::{etalon, text};
use crate::support::said::Says;
use crate::support::scratch::{Scratch, copy_sample};
use std::fmt::Write;

/// A copy of a sample that was run.
fn run(sample: &str) -> Scratch {
    let folder = copy_sample(sample);
    let ran = etalon(&folder.path(), &["run", "."]);
    assert_eq!(ran.status.code(), Some(0), "{}", text(&ran.stderr));
    folder
}

/// Reflectors of the floor whose third one is 0.5 mm from the middle of the others (synthetic): the world may turn about their line.
const ON_A_LINE: &str = "floor_1,3.099999029,-1.199994971,-0.900026426\nfloor_2,1.622410586,0.691212193,-0.891637667\n\
    floor_3,2.3612048,-0.2543914,-0.8953320\n";

#[test]
fn a_world_by_collinear_balls_does_not_place_the_base() {
    let folder = copy_sample("column-arm");
    std::fs::write(folder.path().join("exports/world.txt"), ON_A_LINE).unwrap();
    let ran = etalon(&folder.path(), &["run", "."]);
    let said = text(&ran.stderr);
    assert_eq!(ran.status.code(), Some(1), "{said}");
    assert!(said.says("error[uncertainty-beyond-bound] source=default unit=deg"), "{said}");
    let out = folder.path().join("out");
    assert!(out.join("parameters.json").exists() && !out.join("controller.json").exists());
    // a larger bound may be stated
    let campaign = folder.path().join("campaign.toml");
    let stated = std::fs::read_to_string(&campaign).unwrap();
    std::fs::write(&campaign, format!("uncertainty_bound = \"100 mm, 10 deg\"\n{stated}")).unwrap();
    let ran = etalon(&folder.path(), &["run", "."]);
    assert_eq!(ran.status.code(), Some(0), "{}", text(&ran.stderr));
    std::fs::write(&campaign, format!("uncertainty_bound = \"100\"\n{stated}")).unwrap();
    let checked = etalon(&folder.path(), &["check", "."]);
    assert!(text(&checked.stderr).says("error[uncertainty-bound-unreadable] text=100"), "{}", text(&checked.stderr));
}

/// Rows of the observations with a changed value of a joint.
fn with_joint(table: &str, joint: &str, change: impl Fn(f64) -> f64) -> String {
    let mut lines = table.lines();
    let head = lines.next().unwrap();
    let at = head.split(',').position(|name| name == joint).unwrap();
    lines.fold(format!("{head}\n"), |mut out, line| {
        let cells = line.split(',').enumerate();
        let changed =
            cells.map(|(k, cell)| if k == at { change(cell.parse().unwrap()).to_string() } else { cell.to_owned() });
        let _ = writeln!(out, "{}", changed.collect::<Vec<_>>().join(","));
        out
    })
}

#[test]
fn identified_parameters_are_bounded_and_gains_of_encoders_known() {
    let folder = run("column-arm");
    let table = std::fs::read_to_string(folder.path().join("out/observations.csv")).unwrap();
    let identify = |table: &str, more: &[&str]| {
        std::fs::write(folder.path().join("o.csv"), table).unwrap();
        let given = ["identify", "--robot", "robot.toml", "--observations", "o.csv", "--standard-uncertainty-um", "15"];
        let done = etalon(&folder.path(), &[&given, more].concat());
        (done.status.code(), text(&done.stderr))
    };
    let (code, said) = identify(&table, &["--effects", "all"]);
    assert!(code == Some(0) && !said.contains("encoder-implausible"), "{said}");
    let (code, said) = identify(&table, &["--uncertainty-bound", "1 um"]);
    assert!(code == Some(1) && said.says("error[uncertainty-beyond-bound] source=stated unit=mm"), "{said}");
    // a log scaled by 1 %: the model takes it up, a real encoder has no such gain
    let scaled = with_joint(&table, "wrist_3_deg", |q| 1.01 * q);
    let (_, said) = identify(&scaled, &["--effects", "all"]);
    assert!(said.says("warning[encoder-implausible] count=1"), "{said}");
}

/// Candidates that differ by less than a tenth of a degree detect no rotation of the base.
#[test]
fn poses_to_verify_detect_changes_within_their_bound() {
    let folder = run("column-arm");
    let table = std::fs::read_to_string(folder.path().join("out/observations.csv")).unwrap();
    let (head, first) = (table.lines().next().unwrap(), table.lines().nth(1).unwrap());
    let cells: Vec<&str> = first.split(',').collect();
    let narrow = (0..12).fold(format!("{head}\n"), |mut out, i| {
        let joints = cells[7..].iter().enumerate().map(|(k, q)| {
            let q: f64 = q.parse().unwrap();
            (q + 0.02 * f64::from((i * (k as i32 + 2)) % 5)).to_string()
        });
        let row = [
            &[&*i.to_string(), "1", "SMR_1", "0", "0", "0", cells[6]].map(str::to_owned)[..],
            &joints.collect::<Vec<_>>(),
        ];
        let _ = writeln!(out, "{}", row.concat().join(","));
        out
    });
    std::fs::write(folder.path().join("narrow.csv"), narrow).unwrap();
    let plan = |candidates: &str, more: &[&str]| {
        let given =
            ["verify", "--robot", "robot.toml", "--parameters", "out/parameters.json", "--candidates", candidates];
        let done = etalon(&folder.path(), &[&given, more].concat());
        (done.status.code(), text(&done.stderr))
    };
    let (code, said) = plan("narrow.csv", &["--positions", "3"]);
    assert!(code == Some(1) && said.contains("error[changes-undetected]"), "{said}");
    let (code, said) = plan("out/observations.csv", &["--positions", "6"]);
    assert_eq!(code, Some(0), "{said}");
}
