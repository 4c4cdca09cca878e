//! What a campaign states of errors that its readings have in common: carried to the parameters, and refused where it means nothing.

use crate::support::scratch::{Scratch, copy_sample, ends};
use etalon::documents::{AccuracyDocument, ErrorQuantity, ParametersDocument, UncertaintySource};

const STATED: &str = "\n[expansion]\nexpanded_temperature_uncertainty_c = 1.0\ncoverage_factor = 2\nrobot_per_c = 11.5e-6\n\n\
    [homing]\nexpanded_uncertainty_um = 10\ncoverage_factor = 2\n";
const FACTOR: &str = "coverage_factor = 2\n";

/// The CMM sample with more in `[instrument]` and at its end.
fn with(instrument: &str, end: &str) -> Scratch {
    let scratch = copy_sample("prexyt-cmm");
    scratch.replace("campaign.toml", FACTOR, &format!("{FACTOR}{instrument}\n"));
    let path = scratch.path().join("campaign.toml");
    std::fs::write(&path, std::fs::read_to_string(&path).unwrap() + end).unwrap();
    scratch
}

#[test]
fn contributions_add_up_to_the_uncertainty_of_every_parameter() {
    let scratch = with("expanded_scale_uncertainty_um_per_m = 3", STATED);
    ends(&scratch, "run", 0, &[]);
    let found: ParametersDocument = scratch.document("parameters.json");
    let sources: Vec<UncertaintySource> = found.budget.iter().map(|b| b.source).collect();
    use UncertaintySource::{Frame, Homing, Instrument, Scale, Temperature};
    for source in [Instrument, Frame, Scale, Temperature, Homing] {
        assert!(sources.contains(&source), "{source:?} {sources:?}");
    }
    for (k, p) in found.identified().enumerate() {
        let sum: f64 = found.budget.iter().map(|b| b.standard_uncertainties[k].powi(2)).sum();
        let u = p.standard_uncertainty.unwrap();
        assert!((sum.sqrt() / u - 1.0).abs() < 1e-6, "{}: {} {u}", p.name, sum.sqrt());
    }
    // homed at other places of the switches, the base is elsewhere by as much, and the third rail against the second
    let of = |source, name: &str| {
        let k = found.identified().position(|p| p.name == name).unwrap();
        found.budget.iter().find(|b| b.source == source).unwrap().standard_uncertainties[k]
    };
    for (name, expected) in [("y_o", 0.005), ("d3", 0.005 * 2f64.sqrt()), ("d", 0.005), ("beta", 0.0)] {
        assert!((of(Homing, name) - expected).abs() < 2e-5, "{name}: {}", of(Homing, name));
    }
    let accuracy: AccuracyDocument = scratch.document("accuracy.json");
    for figure in &accuracy.budget {
        let sum: f64 = figure.contributions.iter().map(|c| c.standard_uncertainty_mm.powi(2)).sum();
        assert!((sum.sqrt() / figure.standard_uncertainty_mm - 1.0).abs() < 1e-9);
    }
    let positions = accuracy.budget.iter().filter(|b| b.quantity == ErrorQuantity::Position);
    assert_eq!(positions.count(), 3);
    // nothing of it changes a value
    let plain = copy_sample("prexyt-cmm");
    ends(&plain, "run", 0, &[]);
    let before: ParametersDocument = plain.document("parameters.json");
    for (a, b) in found.parameters.iter().zip(&before.parameters) {
        assert_eq!(a.value, b.value, "{}", a.name);
        assert!(a.standard_uncertainty >= b.standard_uncertainty, "{}", a.name);
    }
}

#[test]
fn range_and_angles_weigh_the_readings_by_their_distance() {
    let polar = "polar = { station_mm = [4000, 0, 0], expanded_range_uncertainty_um = 1, expanded_angle_uncertainty_um_per_m = 2 }";
    let scratch = with(polar, "");
    ends(&scratch, "run", 0, &["[readings-weighted]"]);
}

#[test]
fn what_means_nothing_is_refused_by_its_key() {
    let homing = |of: &str| format!("\n[homing]\n{of}\ncoverage_factor = 2\n");
    let expansion = |per_c: &str| {
        format!("\n[expansion]\nexpanded_temperature_uncertainty_c = 1\ncoverage_factor = 2\nrobot_per_c = {per_c}\n")
    };
    let cases = [
        ("", expansion("11.5"), "[key-out-of-range] key=robot_per_c value=11.5 least=0 most=0.0002"),
        ("", homing("expanded_uncertainty_deg = 0.01"), "[homing-incomplete] key=expanded_uncertainty_um joint=rho1"),
        ("", homing("expanded_uncertainty_um = -1"), "`expanded_uncertainty_um` = -1 is outside"),
        (
            "expanded_scale_uncertainty_um_per_m = 5e4",
            String::new(),
            "`expanded_scale_uncertainty_um_per_m` = 50000 is outside",
        ),
        (
            "polar = { station_mm = [0, 0, 0], expanded_angle_uncertainty_um_per_m = nan }",
            String::new(),
            "expanded_angle_uncertainty_um_per_m",
        ),
    ];
    for (instrument, end, message) in cases {
        let scratch = with(instrument, &end);
        ends(&scratch, "check", 2, &[message]);
    }
}

#[test]
fn what_nothing_would_use_is_refused() {
    let scratch = copy_sample("contacts");
    let polar = "polar = { station_mm = [0, 0, 0], expanded_range_uncertainty_um = 10 }";
    scratch.replace("campaign.toml", FACTOR, &format!("{FACTOR}{polar}\n"));
    ends(&scratch, "check", 2, &["[polar-with-observations]"]);
    let scratch = copy_sample("pose-test");
    let path = scratch.path().join("campaign.toml");
    std::fs::write(&path, std::fs::read_to_string(&path).unwrap() + STATED).unwrap();
    let parts = ["[section-without-identify]: [expansion]", "[section-without-identify]: [homing]"];
    ends(&scratch, "check", 2, &parts);
}
