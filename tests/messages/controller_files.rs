//! Messages of files for controllers: parameters of a sample's run, with changed values.

use super::{ran, samples};
use etalon::base::message::Message;
use etalon::campaign::read_robot;
use etalon::controllers::commands::Galil;
use etalon::controllers::{Description, ExportInput, by_name};
use etalon::documents::ParametersDocument;

fn document(sample: &str) -> ParametersDocument {
    serde_json::from_slice(&std::fs::read(ran(sample).join("out/parameters.json")).unwrap()).unwrap()
}

fn set(document: &mut ParametersDocument, name: &str, value: f64) {
    document.parameters.iter_mut().find(|p| p.name == name).unwrap_or_else(|| panic!("no {name}")).value = value;
}

/// Messages of a format with a robot; none if the file is written.
fn written(sample: &str, format: &str, document: &ParametersDocument) -> Vec<Message> {
    let robot = read_robot(&samples().join(sample).join("robot.toml")).unwrap().build(&["ball".to_owned()]).unwrap();
    let given = ExportInput { robot: Some(robot.as_ref()), force: true, ..ExportInput::parameters(document) };
    let exporter = by_name(format).unwrap();
    let bytes = given.statement(exporter).and_then(|statement| exporter.write_stated(&given, &statement));
    bytes.err().map(|problems| problems.0).unwrap_or_default()
}

/// The format writes the parameters as they are; with the change it has the message.
fn hold(id: &str, (sample, format): (&str, &str), change: fn(&mut ParametersDocument)) {
    let mut document = document(sample);
    let before = written(sample, format, &document);
    assert!(before.is_empty(), "{id}: {before:?}");
    change(&mut document);
    let after = written(sample, format, &document);
    assert!(after.iter().any(|message| message.is(id, &[])), "{id}: {after:?}");
}

#[test]
fn of_values_that_a_format_cannot_hold() {
    hold("galil-value-too-large", ("prexyt-cmm", "galil"), |d| set(d, "s", 3e6));
    hold("galil-constant-too-large", ("prexyt-cmm", "galil"), |d| set(d, "beta", 10.0));
    hold("formula-constant-not-finite", ("dextar", "c-kinematics"), |d| set(d, "l11", 1e200));
}

#[test]
fn of_robots_that_a_format_cannot_describe() {
    hold("covariance-missing", ("draw-wire", "linuxcnc"), |d| d.covariance.clear());
    // every axis is the first one
    hold("axes-coincide", ("draw-wire", "linuxcnc"), |d| {
        let is_link = |name: &str| ["alpha_", "a_", "beta_"].iter().any(|link| name.starts_with(link));
        for p in &mut d.parameters {
            // gains, which the format does not hold, are nominal
            p.value = if is_link(&p.name) { 0.0 } else { p.nominal };
        }
    });
    hold("platform-out-of-reach", ("linear-delta", "klipper-delta"), |d| {
        (1..4).for_each(|i| set(d, &format!("rod_{i}"), 1.0));
    });
    hold("tower-order", ("linear-delta", "klipper-delta"), |d| set(d, "base_side_1", 300.0));
}

#[test]
fn of_targets_in_counts() {
    let document = document("prexyt-cmm");
    let given = ExportInput::parameters(&document);
    let list = |axes: usize, joint: f64| {
        let galil = Galil { counts_per_unit: vec![1000.0; axes] };
        galil.list(&given, &[("P1".to_owned(), vec![joint; axes])]).err().map(|problems| problems.0).unwrap_or_default()
    };
    let [many, far, sound] = [list(9, 1.0), list(3, 1e7), list(3, 1.0)];
    assert!(many[0].is("galil-axes", &[]) && far[0].is("galil-counts-out-of-range", &[]), "{many:?} {far:?}");
    assert!(sound.is_empty(), "{sound:?}");
}

#[test]
fn of_a_description_that_is_cut_off() {
    let document = document("column-arm");
    let robot = read_robot(&samples().join("column-arm/robot.toml")).unwrap().build(&["SMR_1".to_owned()]).unwrap();
    let text = std::fs::read_to_string(samples().join("column-arm/arm.urdf")).unwrap();
    let with = |text: &str| {
        let description = Some(Description { file: "arm.urdf", text });
        let given =
            ExportInput { robot: Some(robot.as_ref()), description, force: true, ..ExportInput::parameters(&document) };
        let exporter = by_name("urdf").unwrap();
        let bytes = given.statement(exporter).and_then(|statement| exporter.write_stated(&given, &statement));
        bytes.err().map(|problems| problems.0).unwrap_or_default()
    };
    let sound = with(&text);
    assert!(sound.is_empty(), "{sound:?}");
    let cut = with(&text.replace("</robot>", "</robo>"));
    assert!(cut[0].is("urdf-malformed", &[]), "{cut:?}");
}
