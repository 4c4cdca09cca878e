//! `etalon identify` for a five-bar: working modes share a pose, assembly modes come from the measurement.

use super::{etalon, text, text_of};
use crate::support::five_bar::{SEVEN, measure, robot, truth};
use crate::support::said::Says;
use std::fmt::Write;

const ROBOT: &str = "model = \"five_bar\"\n[nominal]\nl11 = 230.0\nl12 = 230.0\nl21 = 230.0\nl22 = 230.0\nd = 275.0\nl23 = 230.0\nx_o = 263.0\ny_o = 75.0\n";

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
        let document: etalon::documents::ParametersDocument = serde_json::from_slice(&answered.stdout).unwrap();
        for (p, truth) in document.parameters.iter().zip(truth()) {
            let truth = if p.unit == "deg" { truth.to_degrees() } else { truth };
            assert!((p.value - truth).abs() < 1e-9, "{} {} {truth}", p.name, p.value);
        }
        let told = document.messages.iter().any(|m| m.is("assembly-modes-assumed", &[]));
        assert_eq!(told, !with_mode, "{:?}", document.messages);
    }
    let wrong = run(&table(true).replacen(",-1\n", ",2\n", 1).replacen(",1\n", ",2\n", 1));
    assert_eq!(wrong.status.code(), Some(2));
    assert!(
        text_of(&wrong).says("error[assembly-mode-invalid] value=2") && text_of(&wrong).contains(" row 1: "),
        "{}",
        text_of(&wrong)
    );
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
    assert!(text(&refused.stderr).contains("error[assembly-mode-ambiguous]: pose 99 cycle 1"), "{}", text_of(&refused));
}

#[test]
fn a_plate_measured_once_calibrates_from_encoders_alone_with_its_errors_kept_apart() {
    let sample = crate::support::scratch::copy_sample("dextar");
    let answered = etalon(&sample.path(), &["run", "."]);
    assert!(answered.status.success(), "{}", text_of(&answered));
    let read = std::fs::read_to_string(sample.path().join("out/parameters.json")).unwrap();
    let document: etalon::documents::ParametersDocument = serde_json::from_str(&read).unwrap();
    let r = &document.residuals;
    assert_eq!(
        (r.test.stated_standard_uncertainty_mm, r.test.common_standard_uncertainty_mm),
        (Some(0.005), Some(0.00135))
    );
    assert_eq!(r.uncertainties_from, etalon::documents::UncertaintyFrom::Instrument);
    let spread = r.test.chi_square.unwrap() / r.degrees_of_freedom as f64;
    assert!((0.75..1.25).contains(&spread), "{spread}");
    // table 4.4; the world is that of three measured balls, so that base parameters may be off by their errors
    let truth = [
        229.7063, 229.8971, 229.8540, 229.7552, 274.8051, 230.1718, 0.0217, -0.0625, 0.2399, 263.0115, 74.5904, -0.3655,
    ];
    for (p, truth) in document.parameters.iter().zip(truth) {
        let u = p.standard_uncertainty.unwrap();
        assert!((p.value - truth).abs() < 4.0 * u, "{} {} {truth} {u}", p.name, p.value);
    }
}

#[test]
fn a_touched_point_that_nobody_measured_is_told_with_its_line() {
    let sample = crate::support::scratch::copy_sample("dextar");
    sample.replace("encoders.csv", "1,1,P2,4,", "1,1,P22,4,");
    let refused = etalon(&sample.path(), &["run", "."]);
    assert_eq!(refused.status.code(), Some(2));
    let said = text_of(&refused);
    assert!(said.contains("[label-not-measured]") && said.contains("encoders.csv:5"), "{said}");
    let sample = crate::support::scratch::copy_sample("dextar");
    sample.replace("campaign.toml", "label = \"ball\", ", "");
    let said = text_of(&etalon(&sample.path(), &["check", "."]));
    assert!(said.contains("[join-label-missing]"), "{said}");
    let sample = crate::support::scratch::copy_sample("dextar");
    sample.replace("campaign.toml", "by = \"label\"", "by = [\"pose\", \"cycle\"]");
    let said = text_of(&etalon(&sample.path(), &["check", "."]));
    assert!(said.contains("[key-of-other-join]: `label`"), "{said}");
    let sample = crate::support::scratch::copy_sample("dextar");
    sample.replace("campaign.toml", "repeatability_um = 15.0", "repeatability_um = 0.0");
    let said = text_of(&etalon(&sample.path(), &["check", "."]));
    assert!(said.contains("[key-not-positive]: `repeatability_um`"), "{said}");
}

#[test]
fn joints_are_read_in_the_unit_that_their_column_names() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("robot.toml"), ROBOT).unwrap();
    let run = |csv: &str| {
        std::fs::write(folder.path().join("o.csv"), csv).unwrap();
        etalon(folder.path(), &["identify", "--robot", "robot.toml", "--observations", "o.csv", "--json"])
    };
    let mut csv = "pose,cycle,target,x_mm,y_mm,theta1_rad,theta2_deg\n".to_owned();
    for o in measure(&robot(), &truth(), &SEVEN, &mut || 0.0) {
        let [x, y, _] = o.targets[0].unwrap();
        let _ = writeln!(csv, "{},1,tool,{x},{y},{:.17},{:.15}", o.pose, o.joints[0], o.joints[1].to_degrees());
    }
    let answered = run(&csv);
    assert!(answered.status.success(), "{}", text_of(&answered));
    let document: etalon::documents::ParametersDocument = serde_json::from_slice(&answered.stdout).unwrap();
    assert!((document.parameters[0].value - truth()[0]).abs() < 1e-9, "{:?}", document.parameters[0]);
    let twice = run(&csv.replace("theta2_deg", "theta1_deg"));
    assert_eq!(twice.status.code(), Some(2));
    assert!(text_of(&twice).contains("[joint-column-twice]"), "{}", text_of(&twice));
    // the name of another unit is no misspelling
    let other = run(&csv.replace("theta2_deg", "theta2_mrad"));
    assert!(text_of(&other).contains("`theta2_mrad`: 1 deg is 17.45329252 mrad"), "{}", text_of(&other));
}
