//! Controller files of hexapods, deltas and five-bars, read back by the formulas of the controllers' own sources.

use super::controllers::{disturbed, etalon, parameters};
use crate::support::scratch::Scratch;
use etalon::base::noise::Noise;
use etalon::base::pose::Pose;
use etalon::campaign::read_robot;
use etalon::robots::Robot;
use std::path::Path;

/// The robot of an example with these values, and the file of a format.
fn exported(model: &str, format: &str, change: impl Fn(&dyn Robot) -> Vec<f64>) -> (Box<dyn Robot>, Vec<f64>, String) {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("docs/keys/robot-{model}.toml"));
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

/// The number behind a text.
fn after(text: &str, key: &str) -> f64 {
    let rest = text.split_once(key).unwrap_or_else(|| panic!("{key}: {text}")).1;
    rest.split(|c: char| !"0123456789.-+e".contains(c)).find(|v| !v.is_empty()).unwrap().parse().unwrap()
}

/// Numbers of a letter of a line of G-code, between colons.
fn letter(text: &str, code: &str, letter: char) -> Vec<f64> {
    let line = text.lines().find(|l| l.starts_with(code)).unwrap();
    let word = line.split(' ').skip(1).find(|w| w.starts_with(letter)).unwrap();
    word[1..].split(':').map(|v| v.parse().unwrap()).collect()
}

#[test]
fn genhexkins_has_the_struts_of_the_identified_hexapod() {
    let (robot, values, text) = exported("hexapod", "linuxcnc-hexapod", |r| disturbed(r, &[]));
    let mut noise = Noise::new(19, 5);
    for _ in 0..20 {
        let [x, y, z] = [0.0, 0.0, 400.0].map(|v| v + noise.uniform(50.0));
        let [a, b, c] = [0; 3].map(|_| noise.uniform(0.3));
        // genhexkins: |t + Rz(c) Ry(b) Rx(a) platform - base|
        let pose = Pose::from_xyz_rpy([x, y, z], [a, b, c]);
        let ours = &robot.kinematics().unwrap().all_joints(&values, &pose)[0];
        for (leg, q) in ours.iter().enumerate() {
            let end =
                |end: &str| ["x", "y", "z"].map(|axis| after(&text, &format!("setp genhexkins.{end}.{leg}.{axis} ")));
            let (on_platform, on_base) = (pose.apply(end("platform")), end("base"));
            let strut = (0..3).map(|i| (on_platform[i] - on_base[i]).powi(2)).sum::<f64>().sqrt();
            let zero = after(&text, &format!("# joint {leg}: its position in LinuxCNC is the joint value + "));
            assert!((strut - q - zero).abs() < 1e-9, "{strut} {q} {zero}");
        }
    }
}

/// Carriages of three upright towers: z + √(L² − level distance²), as `delta.py` and `LinearDeltaKinematics.cpp` have them.
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
        let (radius, directions, rods, heights): (f64, Vec<f64>, Vec<f64>, Vec<f64>) = if format == "klipper-delta" {
            let sections: Vec<&str> = text.split("[stepper_").skip(1).collect();
            let all = |key: &str| sections.iter().map(|s| after(s, key)).collect();
            (after(&text, "delta_radius: "), all("angle: "), all("arm_length: "), all("position_endstop: "))
        } else {
            let number = |code, l| letter(&text, code, l)[0];
            let mean = after(&text, "homed height (H): ");
            let directions = vec![210.0 + number("M665", 'X'), 330.0 + number("M665", 'Y'), 90.0 + number("M665", 'Z')];
            let heights = ['X', 'Y', 'Z'].map(|l| mean + number("M666", l)).to_vec();
            (number("M665", 'R'), directions, letter(&text, "M665", 'L'), heights)
        };
        let (x0, y0) = (after(&text, "in the base: x "), after(&text, " mm, y "));
        let turned = after(&text, "turned by ").to_radians();
        let mut noise = Noise::new(19, 6);
        for _ in 0..20 {
            let [x, y] = [0; 2].map(|_| noise.uniform(90.0));
            let z = 150.0 + noise.uniform(100.0);
            let (sin, cos) = turned.sin_cos();
            let at = [x0 + cos * x - sin * y, y0 + sin * x + cos * y, z];
            let pose = Pose { translation_mm: at, ..Pose::identity() };
            let ours = &robot.kinematics().unwrap().all_joints(&values, &pose)[0];
            for i in 0..3 {
                let (sin, cos) = directions[i].to_radians().sin_cos();
                let level = (x - radius * cos).powi(2) + (y - radius * sin).powi(2);
                let carriage = z + (rods[i].powi(2) - level).sqrt();
                let zero = heights[i] + (rods[i].powi(2) - radius.powi(2)).sqrt();
                assert!((carriage - zero - ours[i]).abs() < 2e-5, "{format} {i}: {} {}", carriage - zero, ours[i]);
            }
        }
        // lean has no place there
        let (_, _, text) = exported("delta_linear", format, |r| disturbed(r, &[]));
        assert!(text.contains("not in this format, towers are upright: tower_ry_1"), "{text}");
    }
}

/// Knees of joints 0, 1 and 2 in directions 270, 150 and 30 deg, as the direct kinematics of `rotarydeltakins-common.h` have them, are a
/// shin from the tool: of our first leg, and the others clockwise.
#[test]
fn linuxcnc_has_the_legs_of_a_delta() {
    let (robot, values, text) = exported("delta", "linuxcnc-delta", |r| r.nominal());
    let pin = |name: &str| after(&text, &format!("setp rotarydeltakins.{name} "));
    let legs = [(270.0, 0), (150.0, 2), (30.0, 1)];
    for q in [[0.1, 0.5, -0.2], [0.9, 0.3, 0.6]] {
        let [x, y, z] = robot.kinematics().unwrap().tool_pose(&values, &q).unwrap().translation_mm;
        // our first leg is in direction x
        let tool = [y, -x, z];
        for (direction, leg) in legs {
            let (sin, cos) = f64::to_radians(direction).sin_cos();
            let out = pin("platformradius") - pin("footradius") + pin("thighlength") * q[leg].cos();
            let knee = [out * cos, out * sin, -pin("thighlength") * q[leg].sin()];
            let shin = (0..3).map(|i| (tool[i] - knee[i]).powi(2)).sum::<f64>().sqrt();
            assert!((shin - pin("shinlength")).abs() < 1e-9, "{direction} {shin}");
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
    let of = |l: char| letter(&text, "M669", l);
    let (x, y, p, d, home) = (of('X'), of('Y'), of('P'), of('D'), of('B'));
    let q = [1.6, 1.4f64];
    let elbow = |i: usize| {
        let (sin, cos) = (q[i] + home[i].to_radians()).sin_cos();
        [x[i] + p[i] * cos, y[i] + p[i] * sin]
    };
    // where the distal links of these lengths meet, above the line of the elbows
    let (a, b) = (elbow(0), elbow(1));
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    let square = dx * dx + dy * dy;
    let along = (d[0] * d[0] - d[1] * d[1] + square) / (2.0 * square);
    let across = (d[0] * d[0] / square - along * along).sqrt();
    let meet = [a[0] + along * dx - across * dy, a[1] + along * dy + across * dx];
    let tool = [0, 1].map(|i| b[i] + (meet[i] - b[i]) * (d[1] + d[3]) / d[1]);
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
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/keys/robot-serial-dh.toml");
    let robot = read_robot(&file).unwrap().build(&["tool".to_owned()]).unwrap();
    let found = parameters(&scratch, robot.as_ref(), &robot.nominal());
    for format in ["linuxcnc-hexapod", "linuxcnc-delta", "klipper-delta", "reprap-delta", "reprap-five-bar"] {
        let (code, said) = etalon(&["export", &found, "--format", format, "--robot", &file.display().to_string()]);
        assert!(code == Some(2) && said.contains("error[format-for-other-robots]"), "{said}");
    }
}
