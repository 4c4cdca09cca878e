//! Readings of every kind in documents and reports, known lengths, files that no controller loads, and the check of loaded files of
//! robots with two hands.

use crate::support::program;
use crate::support::said::Says;
use crate::support::scratch::{Scratch, copy_sample, ends, said};
use etalon::documents::{CampaignSummary, ErrorQuantity, LoadAnswer, LoadingCheck, VerdictDocument};
use std::process::Command;

/// Rows of a table whose cells in these columns satisfy a condition.
fn count(scratch: &Scratch, is_meant: impl Fn(&str, u32) -> bool) -> usize {
    let text = std::fs::read_to_string(scratch.path().join("observations.csv")).unwrap();
    let kind_and_pose = |line: &str| {
        let mut cells = line.split(',');
        Some((cells.next()?.to_owned(), cells.next()?.parse().ok()?))
    };
    text.lines().skip(1).filter_map(kind_and_pose).filter(|(kind, pose)| is_meant(kind, *pose)).count()
}

fn page(scratch: &Scratch, name: &str) -> String {
    std::fs::read_to_string(scratch.path().join(name)).unwrap()
}

fn certify(scratch: &Scratch) {
    let (code, answer) = said(scratch, &["report", "campaign", "--certificate"]);
    assert_eq!(code, Some(0), "{answer}");
}

/// The second encoders have a standard uncertainty of 0.001 deg, the camera of 50 µm a coordinate (truth.toml).
#[test]
fn values_of_second_encoders_have_a_row_of_residuals() {
    let scratch = copy_sample("second-encoders");
    ends(&scratch, "run", 0, &[]);
    let residuals = scratch.parameters().residuals;
    let encoders = residuals.conditions.iter().find(|c| c.quantity == ErrorQuantity::Joint).unwrap();
    let in_calibration = |pose: u32| (1..=40).contains(&pose) || (61..=100).contains(&pose);
    let readings = count(&scratch, |kind, pose| kind == "joints" && in_calibration(pose));
    assert_eq!((encoders.count, encoders.unit.as_str()), (readings, "deg"));
    let coordinates = residuals.position.coordinates.unwrap();
    assert_eq!(coordinates.count, 3 * count(&scratch, |kind, pose| kind == "point" && in_calibration(pose)));
    assert_eq!(coordinates.count + encoders.count, residuals.count);
    for (found, u) in [(encoders, 0.001), (&coordinates, 0.05)] {
        assert!((found.standard_uncertainty - u).abs() < 1e-12, "{found:?}");
        assert!((0.7..1.2).contains(&(found.rms / u)), "{found:?}");
    }
    // √((Σ n rms²/u²)/ν) is the ratio of all residuals
    let squares: f64 = [encoders, &coordinates]
        .map(|found| found.count as f64 * (found.rms / found.standard_uncertainty).powi(2))
        .iter()
        .sum();
    let chi_square = residuals.test.chi_square.unwrap();
    assert!(squares <= chi_square + 1e-6 && squares > 0.5 * chi_square, "{squares} {chi_square}");
    certify(&scratch);
    for name in ["out/report.html", "out/certificate.html"] {
        let html = page(&scratch, name);
        assert!(html.contains("joint value") && html.contains("coordinates of targets"), "{name}");
    }
}

/// Six distances of four sockets, 4 µm each (observations.csv).
#[test]
fn known_distances_are_listed_with_their_uncertainty_and_residual() {
    let scratch = copy_sample("contacts");
    ends(&scratch, "run", 0, &[]);
    let document = scratch.parameters();
    let known = &document.known;
    assert_eq!((known.len(), document.residuals.test.stated_values), (6, 6));
    let value = |name: &str| &document.parameters.iter().find(|p| p.name == name).unwrap().value;
    for k in known {
        let (from, to) = k.name.split_once(" – ").unwrap();
        let square = |axis: &str| (value(&format!("{to}_{axis}")) - value(&format!("{from}_{axis}"))).powi(2);
        let distance = ["x", "y", "z"].map(square).iter().sum::<f64>().sqrt();
        assert!((distance - k.stated_mm.unwrap() - k.residual_mm).abs() < 1e-9, "{k:?}");
        assert!((k.standard_uncertainty_mm - 0.004).abs() < 1e-12 && k.residual_mm.abs() < 0.016, "{k:?}");
    }
    assert_eq!(known[0].stated_mm.map(|mm| (1e3 * mm).round()), Some(317_175.0));
    certify(&scratch);
    for name in ["out/report.html", "out/certificate.html"] {
        assert!(page(&scratch, name).contains("317.175"), "{name}");
    }
}

/// The run of this sample answers to identify further effects first.
#[test]
fn files_of_a_run_that_loads_nothing_say_so_and_export_warns() {
    let scratch = copy_sample("field-arm");
    ends(&scratch, "run", 0, &[]);
    let verdict: VerdictDocument = scratch.document("verdict.json");
    assert_eq!(verdict.loading.unwrap().answer, LoadAnswer::IdentifyFurther);
    let is_marked = |name: &str| page(&scratch, name).contains("NOT TO BE LOADED: ");
    assert!(is_marked("out/controller.json"));
    let formats = ["csv", "c-header", "matlab"].map(|format| ["--format", format]).concat();
    let command = [&["export", "campaign/out/parameters.json", "--to", "files"][..], &formats].concat();
    let (code, exported) = said(&scratch, &command);
    assert_eq!(code, Some(0), "{exported}");
    assert!(exported.says("warning[nothing-to-load-by-run]"), "{exported}");
    for file in ["controller.csv", "etalon_parameters.h", "etalon_parameters.m"] {
        let text = std::fs::read_to_string(scratch.root().join("files").join(file)).unwrap();
        assert!(text.contains("NOT TO BE LOADED: "), "{file}: {text}");
    }
}

fn check_of(scratch: &Scratch) -> LoadingCheck {
    let campaign: CampaignSummary = scratch.document("campaign.json");
    campaign.controller_files.into_iter().find_map(|file| file.check).unwrap()
}

/// The announced pose of one hand is the pose of a chain that ends there.
#[test]
fn a_robot_with_two_hands_is_checked_at_one_of_them() {
    let scratch = copy_sample("two-hands");
    ends(&scratch, "run", 0, &[]);
    let check = check_of(&scratch);
    let link = check.link.clone().unwrap();
    let robot = "model = \"urdf\"\nfile = \"two_hands.urdf\"\nbase_link = \"base\"\n";
    std::fs::write(scratch.path().join("hand.toml"), format!("{robot}tool_link = \"{link}\"\n")).unwrap();
    let values: Vec<String> = check.joint_values.iter().map(f64::to_string).collect();
    let table = format!("pose,{}\n1,{}\n", check.joints.join(","), values.join(","));
    std::fs::write(scratch.path().join("joints.csv"), table).unwrap();
    let command = ["kinematics", "direct", "campaign/joints.csv", "--robot", "campaign/hand.toml"];
    let output = Command::new(program()).args(command).current_dir(scratch.root()).output().unwrap();
    let found = String::from_utf8(output.stdout).unwrap();
    let row = found.lines().find(|line| line.starts_with("1,")).unwrap();
    let at: Vec<f64> = row.split(',').skip(1).map(|cell| cell.parse().unwrap()).collect();
    assert!(at.iter().zip(check.before.xyz_mm).all(|(a, b)| (a - b).abs() < 1e-9), "{at:?} {check:?}");
    assert!(check.change_mm() > 0.5 && check.tolerance_mm.is_some(), "{check:?}");
    let links = scratch.parameters().links.unwrap();
    assert_eq!((links.base.as_str(), links.base_moves), ("base", false));
    assert!(links.ends.contains(&link), "{links:?}");
}

/// The base frame of this chain is a hand: no controller displays poses in it.
#[test]
fn a_base_that_joints_move_is_named() {
    let scratch = copy_sample("two-arms");
    ends(&scratch, "run", 0, &[]);
    let links = scratch.parameters().links.unwrap();
    assert_eq!((links.base.as_str(), links.ends.join(",").as_str()), ("left_hand", "right_hand"));
    assert!(links.base_moves);
    let html = page(&scratch, "out/report.html");
    assert!(html.contains("no controller displays these poses"), "the person who can check");
    assert!(!html.contains("The display must change from the first row to the second"), "no display");
}
