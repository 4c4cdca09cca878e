//! `etalon formats --robot`: the nominal kinematics test the proposal. All data are synthetic.

use super::program;
use crate::support::said::Says;
use etalon::base::noise::Noise;
use etalon::base::phrase;
use etalon::documents::FormatsDocument;
use etalon::formats::propose_file_for;
use etalon::robots::Robot;
use std::fmt::Write;
use std::path::Path;

/// A UR5e, nominal.
pub fn robot(at: &Path) -> Box<dyn Robot> {
    assert_eq!(program(at, &["init", "nominal", "--robot", "ur5e"]).0, Some(0));
    etalon::campaign::read_robot(&at.join("nominal/robot.toml")).unwrap().build(&["target".to_owned()]).unwrap()
}

/// Joint values (rad) and points (mm) of an arm with errors of geometry of `scale` times some tenths of a millimetre.
pub fn measured(arm: &dyn Robot, count: usize, target: [f64; 3], scale: f64, seed: u64) -> Vec<(Vec<f64>, [f64; 3])> {
    let mut values = arm.nominal();
    for (p, value) in arm.parameters().iter().zip(&mut values) {
        *value += match p.name.as_str() {
            "base_x" => 1800.0,
            "base_z" => -300.0,
            "base_rz" => 0.4,
            "base_ry" => 0.2,
            "d_4" => 0.4 * scale,
            "theta_3" => 0.002 * scale,
            "target_x" => target[0],
            "target_y" => target[1],
            "target_z" => target[2],
            _ => 0.0,
        };
    }
    let mut noise = Noise::new(seed, 1);
    let mut one = || {
        let q: Vec<f64> = (0..6).map(|_| noise.uniform(1.4)).collect();
        let place = arm.position(&values, &q, 0).map(|v| v + noise.gaussian(0.01 * scale));
        (q, place)
    };
    (0..count).map(|_| one()).collect()
}

fn proposed(at: &Path, arm: &dyn Robot, text: &str) -> FormatsDocument {
    let path = at.join("f.csv");
    std::fs::write(&path, text).unwrap();
    propose_file_for(&path, Some(arm)).unwrap()
}

fn table(head: &str, rows: impl Iterator<Item = Vec<f64>>) -> String {
    let mut text = head.to_owned();
    for row in rows {
        let cells: Vec<String> = row.iter().map(|v| format!("{v:.5}")).collect();
        let _ = writeln!(text, "{}", cells.join(","));
    }
    text
}

const TARGET: [f64; 3] = [60.0, -40.0, 120.0];

#[test]
fn order_unit_and_direction_of_joints_and_the_unit_of_points_are_found() {
    let folder = tempfile::tempdir().unwrap();
    let (at, arm) = (folder.path(), robot(folder.path()));
    let rows = measured(arm.as_ref(), 60, TARGET, 1.0, 3);
    let deg = |q: &[f64]| q.iter().map(|v| v.to_degrees()).collect::<Vec<f64>>();
    // as they are, in degrees and millimetres, which no heading states
    let text = table("a1,a2,a3,a4,a5,a6,X,Y,Z\n", rows.iter().map(|(q, p)| deg(q).into_iter().chain(*p).collect()));
    let document = proposed(at, arm.as_ref(), &text);
    assert_eq!(document.kind, "export with joints", "{}", document.toml);
    assert!(document.toml.contains("q1_deg = \"a1\"") && document.toml.contains("unit = \"mm\""), "{}", document.toml);
    assert!(document.reasons.iter().any(|r| r.english().has_phrase("robot-reproduces points=`X`, `Y`, `Z` unit=mm")));
    assert!(!document.toml.contains("UNIT"), "{}", document.toml);
    // the second and the third column exchanged, the fifth against its direction, in rad and metres
    let text = table(
        "j1,j2,j3,j4,j5,j6,X,Y,Z\n",
        rows.iter().map(|(q, p)| {
            let q = [q[0], q[2], q[1], q[3], -q[4], q[5]];
            q.into_iter().chain(p.map(|v| v / 1000.0)).collect()
        }),
    );
    let document = proposed(at, arm.as_ref(), &text);
    for part in ["q2_rad = \"j3\"", "q3_rad = \"j2\"", "q5_rad = { name = \"j5\", per_count = -1 }", "unit = \"m\""] {
        assert!(document.toml.contains(part), "{part}: {}", document.toml);
    }
    assert!(document.reasons.iter().any(|r| r.english().has_phrase("robot-reverses column=`j5` joint=q5")));
    let columns = [1, 3, 2, 4, 5, 6].map(|k| format!("`j{k}`"));
    let contradicted = phrase!("robot-contradicts-order", columns = columns.to_vec()).into();
    assert!(document.doubts.contains(&contradicted), "{:?}", document.doubts);
    // headings that state another unit than the values have: the lines take the one that fits, and doubt it
    let text = table(
        "j1,j2,j3,j4,j5,j6,X [mm],Y [mm],Z [mm]\n",
        rows.iter().map(|(q, p)| q.iter().copied().chain(p.map(|v| v / 25.4)).collect()),
    );
    let document = proposed(at, arm.as_ref(), &text);
    assert!(document.toml.contains("unit = \"inch\""), "{}", document.toml);
    assert!(document.doubts.iter().any(|d| d.english().contains("`X [mm]` gives mm")), "{}", document.toml);
    // without a header the six joints are found behind the point
    let text = table("", rows.iter().map(|(q, p)| p.iter().copied().chain(deg(q)).collect()));
    let document = proposed(at, arm.as_ref(), &text);
    assert!(document.toml.contains("q1_deg = 4") && document.toml.contains("q6_deg = 9"), "{}", document.toml);
}

#[test]
fn joints_and_poses_in_another_encoding_state_it_and_ask_nothing_that_headings_state() {
    let folder = tempfile::tempdir().unwrap();
    let (at, arm) = (folder.path(), robot(folder.path()));
    let rows = measured(arm.as_ref(), 60, TARGET, 1.0, 3);
    let head = "J1 (deg),J2 (deg),J3 (deg),J4 (deg),J5 (deg),J6 (deg),X (mm),Y (mm),Z (mm),QW,QX,QY,QZ,T (\u{b0}C)\n";
    let row = |(q, p): &(Vec<f64>, [f64; 3])| {
        let length = q[..4].iter().map(|v| v * v).sum::<f64>().sqrt();
        let turned = q[..4].iter().map(|v| v / length);
        q.iter().map(|v| v.to_degrees()).chain(*p).chain(turned).chain([20.0 + 0.01 * q[0]]).collect()
    };
    let text = table(head, rows.iter().map(row));
    let path = at.join("f.csv");
    let bytes: Vec<u8> = text.chars().map(|c| u8::try_from(u32::from(c)).unwrap()).collect();
    std::fs::write(&path, bytes).unwrap();
    let document = propose_file_for(&path, None).unwrap();
    assert_eq!(document.kind, "observations", "{}", document.toml);
    assert!(document.toml.contains("f.csv\"\nencoding = \"windows-1252\"\n"), "{}", document.toml);
    assert!(!document.questions.contains(&phrase!("ask-joints").into()), "{:?}", document.questions);
    assert!(!document.toml.contains("UNIT"), "{}", document.toml);
}

#[test]
fn a_column_of_targets_is_found_by_the_kinematics() {
    let folder = tempfile::tempdir().unwrap();
    let (at, arm) = (folder.path(), robot(folder.path()));
    let mut text = "what,j1,j2,j3,j4,j5,j6,X,Y,Z\n".to_owned();
    for (name, target) in [("red", TARGET), ("blue", [-90.0, 30.0, 50.0]), ("green", [0.0, 130.0, 10.0])] {
        for (q, p) in measured(arm.as_ref(), 30, target, 1.0, 5) {
            let cells: Vec<String> = q.iter().map(|v| v.to_degrees()).chain(p).map(|v| format!("{v:.4}")).collect();
            let _ = writeln!(text, "{name},{}", cells.join(","));
        }
    }
    let document = proposed(at, arm.as_ref(), &text);
    assert_eq!(document.columns[0].taken_for.english(), "name of the target", "{}", document.toml);
    let found = phrase!("robot-finds-targets", column = "`what`").into();
    assert!(document.reasons.contains(&found), "{}", document.toml);
}

#[test]
fn commanded_coordinates_are_named_and_the_data_of_another_robot_are_not_explained() {
    let folder = tempfile::tempdir().unwrap();
    let (at, arm) = (folder.path(), robot(folder.path()));
    let head = "j1,j2,j3,j4,j5,j6,X,Y,Z,mX,mY,mZ\n";
    let rows = |scale: f64| {
        let computed = measured(arm.as_ref(), 60, TARGET, 0.0, 7);
        let real = measured(arm.as_ref(), 60, TARGET, scale, 7);
        computed.into_iter().zip(real)
    };
    // joints with all digits: coordinates that are computed from them
    let mut text = head[..head.len() - 10].to_owned() + "\n";
    for ((q, p), _) in rows(1.0) {
        let cells: Vec<String> = q.iter().map(f64::to_string).chain(p.map(|v| format!("{v:.3}"))).collect();
        let _ = writeln!(text, "{}", cells.join(","));
    }
    let document = proposed(at, arm.as_ref(), &text);
    assert!(document.doubts.iter().any(|d| d.english().has_phrase("points-commanded")), "{}", document.toml);
    assert_eq!(document.kind, "log", "{}", document.toml);
    // measured by a robot with errors of some hundredths: no such doubt
    let mut text = head[..head.len() - 10].to_owned() + "\n";
    for (_, (q, p)) in rows(0.1) {
        let cells: Vec<String> = q.iter().map(f64::to_string).chain(p.map(|v| format!("{v:.4}"))).collect();
        let _ = writeln!(text, "{}", cells.join(","));
    }
    let document = proposed(at, arm.as_ref(), &text);
    assert!(!document.doubts.iter().any(|d| d.english().contains("commanded")), "{}", document.toml);
    assert_eq!(document.kind, "export with joints", "{}", document.toml);
    // points that have nothing to do with the joints
    let mut noise = Noise::new(1, 1);
    let text = table(
        "j1,j2,j3,j4,j5,j6,X,Y,Z\n",
        rows(1.0).map(|((q, _), _)| q.into_iter().chain([0; 3].map(|_| noise.uniform(800.0))).collect()),
    );
    let document = proposed(at, arm.as_ref(), &text);
    assert!(document.doubts.iter().any(|d| d.english().contains("`X`, `Y`, `Z`")), "{}", document.toml);
    assert!(document.toml.contains("unit = \"?\"") && document.toml.contains("q1_UNIT"), "{}", document.toml);
    // too few rows test nothing
    let few: String = text.lines().take(10).map(|line| format!("{line}\n")).collect();
    let document = proposed(at, arm.as_ref(), &few);
    assert!(document.doubts.iter().any(|d| d.english().has_phrase("robot-not-tested")), "{}", document.toml);
}

#[test]
fn the_program_takes_a_robot() {
    let folder = tempfile::tempdir().unwrap();
    let (at, arm) = (folder.path(), robot(folder.path()));
    let text = table(
        "j1,j2,j3,j4,j5,j6,X,Y,Z\n",
        measured(arm.as_ref(), 40, TARGET, 1.0, 9).iter().map(|(q, p)| q.iter().copied().chain(*p).collect()),
    );
    std::fs::write(at.join("f.csv"), text).unwrap();
    let (code, said) = program(at, &["formats", "f.csv", "--robot", "nominal/robot.toml"]);
    assert!(code == Some(0) && said.has_phrase("robot-reproduces"), "{said}");
    let (code, said) = program(at, &["formats", "f.csv", "--robot", "none.toml"]);
    assert!(code == Some(2) && said.contains("none.toml"), "{said}");
}
