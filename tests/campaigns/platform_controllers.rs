//! Controller files of hexapods, deltas and five-bars, read back by the formulas of the controllers' own sources.

use super::controllers::{disturbed, etalon, parameters};
use crate::support::controller_files::{Towers, after, five_bar, genhexkins, rotarydeltakins};
use crate::support::root;
use crate::support::scratch::Scratch;
use etalon::base::noise::Noise;
use etalon::base::pose::Pose;
use etalon::campaign::read_robot;
use etalon::robots::Robot;

/// The robot of an example with these values, and the file of a format.
fn exported(model: &str, format: &str, change: impl Fn(&dyn Robot) -> Vec<f64>) -> (Box<dyn Robot>, Vec<f64>, String) {
    let file = root().join(format!("docs/keys/robot-{model}.toml"));
    let robot = read_robot(&file).unwrap().build(&["tool".to_owned()]).unwrap();
    let values = change(robot.as_ref());
    let scratch = Scratch::with(&[]);
    let found = parameters(&scratch, robot.as_ref(), &values);
    let (file, to) = (file.display().to_string(), scratch.path().display().to_string());
    let (code, said) = etalon(&["export", &found, "--format", format, "--robot", &file, "--to", &to]);
    assert_eq!(code, Some(0), "{said}");
    let named = |e: std::fs::DirEntry| {
        e.path().extension().is_some_and(|e| e == "hal" || e == "cfg" || e == "g").then(|| e.path())
    };
    let path = std::fs::read_dir(scratch.path()).unwrap().find_map(|e| named(e.unwrap())).unwrap();
    let text = std::fs::read_to_string(path).unwrap();
    assert!(text.contains("Written by etalon") && text.contains("sha256 of parameters.json") && !text.contains("NaN"));
    (robot, values, text)
}

#[test]
fn genhexkins_has_the_struts_of_the_identified_hexapod() {
    let (robot, values, text) = exported("hexapod", "linuxcnc-hexapod", |r| disturbed(r, &[]));
    let mut noise = Noise::new(19, 5);
    for _ in 0..20 {
        let [x, y, z] = [0.0, 0.0, 400.0].map(|v| v + noise.uniform(50.0));
        let [a, b, c] = [0; 3].map(|_| noise.uniform(0.3));
        let pose = Pose::from_xyz_rpy([x, y, z], [a, b, c]);
        let ours = &robot.kinematics().unwrap().all_joints(&values, &pose)[0];
        for (q, found) in ours.iter().zip(genhexkins(&text, &pose)) {
            assert!((found - q).abs() < 1e-9, "{found} {q}");
        }
    }
}

#[test]
fn firmwares_move_the_carriages_of_the_identified_delta() {
    let upright = |robot: &dyn Robot| {
        let mut values = disturbed(robot, &[]);
        let tilts = robot.parameters().iter().zip(&mut values).filter(|(p, _)| p.name.starts_with("tower_r"));
        tilts.for_each(|(_, v)| *v = 0.0);
        values
    };
    for format in ["klipper-delta", "reprap-delta"] {
        let (robot, values, text) = exported("delta_linear", format, upright);
        assert!(!text.contains("not in this format"), "{text}");
        let towers = if format == "klipper-delta" { Towers::klipper(&text) } else { Towers::reprap(&text) };
        let mut noise = Noise::new(19, 6);
        for _ in 0..20 {
            let [x, y] = [0; 2].map(|_| noise.uniform(90.0));
            let z = 150.0 + noise.uniform(100.0);
            let pose = Pose { translation_mm: [x, y, z], ..Pose::identity() };
            let ours = &robot.kinematics().unwrap().all_joints(&values, &pose)[0];
            for (found, q) in towers.joints([x, y, z]).iter().zip(ours) {
                assert!((found - q).abs() < 2e-5, "{format}: {found} {q}");
            }
        }
        // lean has no place there
        let (_, _, text) = exported("delta_linear", format, |r| disturbed(r, &[]));
        assert!(text.contains("not in this format, whose towers are vertical: tower_ry_1"), "{text}");
    }
}

/// Joint values by the inverse kinematics of `rotarydeltakins-common.h`.
#[test]
fn linuxcnc_has_the_legs_of_a_delta() {
    let (robot, values, text) = exported("delta", "linuxcnc-delta", |r| r.nominal());
    for q in [[0.1, 0.5, -0.2], [0.9, 0.3, 0.6]] {
        let at = robot.kinematics().unwrap().tool_pose(&values, &q).unwrap().translation_mm;
        for (found, q) in rotarydeltakins(&text, at).iter().zip(q) {
            assert!((found - q).abs() < 1e-9, "{found} {q}");
        }
    }
    let (_, _, text) = exported("delta_linear", "linuxcnc-delta", |r| disturbed(r, &[]));
    assert!((after(&text, "setp lineardeltakins.R ") - 140.0).abs() < 3.0 && text.contains("# rod_1 "), "{text}");
}

/// A five-bar without a tool beside its link: elbows and tool as the firmware places them.
#[test]
fn m669_has_the_links_of_the_identified_five_bar() {
    let (robot, values, text) = exported("five_bar", "reprap-five-bar", |r| {
        let mut values = disturbed(r, &[]);
        values[r.index("gamma").unwrap()] = 0.0;
        values[r.index("l23").unwrap()] = values[r.index("l22").unwrap()] + 1.5;
        values[r.index("phi").unwrap()] = 0.1;
        values
    });
    let q = [1.6, 1.4f64];
    let tool = five_bar(&text, &q, 1.0);
    let ours = robot.position(&values, &[q[0], q[1], 1.0], 0);
    assert!((0..2).all(|i| (tool[i] - ours[i]).abs() < 1e-4), "{tool:?} {ours:?} {text}");
    let (_, _, text) = exported("five_bar", "reprap-five-bar", |r| disturbed(r, &[]));
    assert!(
        text.contains("; not in this format: gamma") && text.contains("the only working and assembly mode"),
        "{text}"
    );
}

#[test]
fn formats_of_other_robots_are_refused() {
    let scratch = Scratch::with(&[]);
    let file = root().join("docs/keys/robot-serial-dh.toml");
    let robot = read_robot(&file).unwrap().build(&["tool".to_owned()]).unwrap();
    let found = parameters(&scratch, robot.as_ref(), &robot.nominal());
    for format in ["linuxcnc-hexapod", "linuxcnc-delta", "klipper-delta", "reprap-delta", "reprap-five-bar"] {
        let (code, said) = etalon(&["export", &found, "--format", format, "--robot", &file.display().to_string()]);
        assert!(code == Some(2) && said.contains("error[format-for-other-robots]"), "{said}");
    }
}
