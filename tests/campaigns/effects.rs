//! Effects that the robot file does not describe, or the campaign does not identify, are named where they would prove themselves. Synthetic.

use super::apart::{Arm, cells};
use crate::support::scratch::{Scratch, copy_sample, ends};
use serde_json::Value;

/// A campaign of an arm whose joints 2 and 3 bend by `bent_rad` under the arm stretched out level; robot.toml states no bending.
fn campaign(bent_rad: f64) -> Scratch {
    let scratch = copy_sample("draw-wire");
    let plain = std::fs::read_to_string(scratch.path().join("robot.toml")).unwrap();
    let bending = plain.replace("joint = [", "bending = [2, 3]\njoint = [");
    std::fs::write(scratch.path().join("robot.toml"), bending).unwrap();
    let mut arm = Arm::new(&scratch, &["ball".to_owned()]);
    for name in ["compliance_2_2", "compliance_3_3"] {
        let index = arm.robot.index(name).unwrap();
        arm.values[index] = bent_rad;
    }
    let mut table = "pose,target,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm\n".to_owned();
    for pose in 1..=90 {
        let joints = arm.joints();
        let at = arm.at(&joints, 0);
        let [x, y, z] = arm.measured(at);
        table += &format!("{pose},ball,{},{x:.5},{y:.5},{z:.5}\n", cells(&joints));
    }
    std::fs::write(scratch.path().join("observations.csv"), table).unwrap();
    std::fs::write(scratch.path().join("robot.toml"), plain).unwrap();
    scratch.replace("campaign.toml", "[limits]\ndistance_max_mm = 0.4\n", "");
    scratch
}

#[test]
fn bending_that_robot_toml_does_not_describe_is_named_with_the_line_to_add() {
    let scratch = campaign(1e-3);
    let said = ends(
        &scratch,
        "run",
        0,
        &["[effect-would-prove] effect=bending joints=q2, q3", "add `bending = [2, 3]` to robot.toml"],
    );
    let accuracy = || -> Value { scratch.document("accuracy.json") };
    let effects = accuracy()["effects"].clone();
    let bending = effects.as_array().unwrap().iter().find(|e| e["effect"] == "bending").unwrap().clone();
    let [without, with] = ["without_mm", "with_mm"].map(|key| bending[key].as_f64().unwrap());
    assert!(with < 0.7 * without && said.contains(&format!("from {without:.3} to {with:.3} mm")), "{bending}\n{said}");
    // what is said becomes true
    scratch.replace("robot.toml", "joint = [", "bending = [2, 3]\njoint = [");
    let said = ends(&scratch, "run", 0, &[]);
    assert!(!said.contains("[effect-would-prove]"), "{said}");
    let after = accuracy()["sets"][1]["errors"][0]["after"]["rms"].as_f64().unwrap();
    assert!((after / with - 1.0).abs() < 0.25, "{after} {with}");
    // a stiff arm has nothing to prove
    let said = ends(&campaign(0.0), "run", 0, &[]);
    assert!(!said.contains("[effect-would-prove]"), "{said}");
}

/// Encoders of joints 1 and 4 err twice a turn (truth.toml), and robot.toml states no harmonics: they are named, and no
/// other effect that gains only because they are missing.
#[test]
fn harmonics_that_robot_toml_does_not_describe_are_named_alone() {
    let scratch = copy_sample("field-arm");
    scratch.replace("campaign.toml", "field = true", "field = false");
    let named = ["[effect-would-prove] effect=harmonics joints=q1, q4", "add `harmonics = [1, 4]` to robot.toml"];
    let said = ends(&scratch, "run", 0, &named);
    assert_eq!(said.matches("[effect-would-prove]").count(), 1, "{said}");
    let accuracy = || -> Value { scratch.document("accuracy.json") };
    let promised =
        accuracy()["effects"].as_array().unwrap().iter().find(|e| e["effect"] == "harmonics").unwrap()["with_mm"]
            .as_f64()
            .unwrap();
    scratch.replace("robot.toml", "joint = [", "harmonics = [1, 4]\njoint = [");
    let said = ends(&scratch, "run", 0, &[]);
    assert!(!said.contains("[effect-would-prove]"), "{said}");
    // what is said becomes true at the same left-out poses
    let reached = accuracy()["left_out"]["identified"]["rms"].as_f64().unwrap();
    assert!((reached / promised - 1.0).abs() < 0.1, "{reached} {promised}");
    let parameters = std::fs::read(scratch.path().join("out/parameters.json")).unwrap();
    let parameters: Value = serde_json::from_slice(&parameters).unwrap();
    for (name, amplitude_deg) in [("harmonic_1", 0.02), ("harmonic_4", 0.03)] {
        let part = |end: &str| {
            let all = parameters["parameters"].as_array().unwrap();
            let found = all.iter().find(|p| p["name"] == format!("{name}_{end}")).unwrap();
            found["value"].as_f64().unwrap()
        };
        let found_deg = part("sin2").hypot(part("cos2"));
        assert!((found_deg / amplitude_deg - 1.0).abs() < 0.1, "{name}: {found_deg}");
    }
}
