//! `etalon identify` for a five-bar: working modes share a pose, assembly modes come from the measurement.

use super::{etalon, text, text_of};
use crate::laws::five_bar::{SEVEN, measure, robot, truth};
use std::fmt::Write;

const ROBOT: &str = "model = \"five_bar\"\n[nominal]\nx_o = 263.0\ny_o = 75.0\n";

fn table(with_mode: bool) -> String {
    let mut csv =
        format!("pose,cycle,target,x_mm,y_mm,theta1_deg,theta2_deg{}\n", if with_mode { ",assembly" } else { "" });
    for o in measure(&robot(), &truth(), &SEVEN, &mut || 0.0) {
        let [x, y, _] = o.targets[0].unwrap();
        let (q1, q2) = (o.joints[0].to_degrees(), o.joints[1].to_degrees());
        let mode = if with_mode { format!(",{}", o.joints[2]) } else { String::new() };
        let _ = writeln!(csv, "{},1,tool,{x},{y},{q1:.15},{q2:.15}{mode}", o.pose);
    }
    csv
}

#[test]
fn assembly_modes_are_read_or_taken_from_the_measurement_and_told() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("robot.toml"), ROBOT).unwrap();
    let run = |csv: &str| {
        std::fs::write(folder.path().join("o.csv"), csv).unwrap();
        etalon(folder.path(), &["identify", "--robot", "robot.toml", "--observations", "o.csv", "--json"])
    };
    for with_mode in [true, false] {
        let answered = run(&table(with_mode));
        assert!(answered.status.success(), "{}", text_of(&answered));
        let document: etalon::document::ParametersDocument = serde_json::from_slice(&answered.stdout).unwrap();
        for (p, truth) in document.parameters.iter().zip(truth()) {
            let truth = if p.unit == "deg" { truth.to_degrees() } else { truth };
            assert!((p.value - truth).abs() < 1e-9, "{} {} {truth}", p.name, p.value);
        }
        let told = document.messages.iter().any(|m| m.what.contains("assembly mode"));
        assert_eq!(told, !with_mode, "{:?}", document.messages);
    }
    let wrong = run(&table(true).replacen(",-1\n", ",2\n", 1).replacen(",1\n", ",2\n", 1));
    assert_eq!(wrong.status.code(), Some(2));
    assert!(text_of(&wrong).contains("assembly mode 2"), "{}", text_of(&wrong));
}

#[test]
fn a_position_between_both_assembly_modes_is_an_error() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("robot.toml"), ROBOT).unwrap();
    let lines = table(false);
    // the line from elbow to elbow is as far from one as from the other
    let at = robot().direct(&etalon::robots::Robot::nominal(&robot()), [1.6, 1.4], 1.0);
    let middle = [0.5 * (at.b1[0] + at.b2[0]) + 263.0, 0.5 * (at.b1[1] + at.b2[1]) + 75.0];
    let row = format!("99,1,tool,{},{},{},{}\n", middle[0], middle[1], 1.6f64.to_degrees(), 1.4f64.to_degrees());
    std::fs::write(folder.path().join("o.csv"), lines + &row).unwrap();
    let refused = etalon(folder.path(), &["identify", "--robot", "robot.toml", "--observations", "o.csv"]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(
        text(&refused.stderr).contains("pose 99 cycle 1: both assembly modes fit equally well"),
        "{}",
        text_of(&refused)
    );
}
