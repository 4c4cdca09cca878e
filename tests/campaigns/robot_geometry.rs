//! The robot file beside parameters is compared with the robot whose parameters were identified: its geometry, not its text.

use super::controllers::{etalon, parameters};
use crate::support::root;
use crate::support::said::Says;
use crate::support::scratch::Scratch;
use etalon::campaign::read_robot;
use etalon::documents::{ParametersDocument, ReferencePose};
use etalon::robots::Robot;
use etalon::stages::verify::earlier_parameters::{
    check_geometry, other_nominal, parameters_from_document, robot_values, unknown_geometry,
};
use std::path::{Path, PathBuf};

/// Robots of every model.
const ROBOTS: [&str; 14] = [
    "docs/keys/robot-delta.toml",
    "docs/keys/robot-delta_linear.toml",
    "docs/keys/robot-five_bar.toml",
    "docs/keys/robot-hexapod.toml",
    "docs/keys/robot-prexyt.toml",
    "docs/keys/robot-serial-dh.toml",
    "docs/keys/robot-serial-poe.toml",
    "docs/keys/robot-serial.toml",
    "docs/keys/robot-urdf-branches.toml",
    "docs/keys/robot-urdf.toml",
    "samples/hexapod/robot.toml",
    "samples/prexyt-cmm/robot.toml",
    "samples/column-arm/robot.toml",
    ELASTIC,
];

const ELASTIC: &str = "samples/elastic-arm/robot.toml";

fn path(robot: &str) -> PathBuf {
    root().join(robot)
}

fn build(file: &Path) -> Box<dyn Robot> {
    let file = read_robot(file).unwrap();
    file.build(&file.targets_or("tool")).unwrap()
}

/// Parameters of a run with the nominal values, as a file.
fn document(scratch: &Scratch, robot: &dyn Robot) -> (String, ParametersDocument) {
    let file = parameters(scratch, robot, &robot.nominal());
    let mut document: ParametersDocument = serde_json::from_slice(&std::fs::read(&file).unwrap()).unwrap();
    document.reference_poses = ReferencePose::all(robot);
    for (entry, p) in document.parameters.iter_mut().zip(robot.parameters()) {
        entry.role = p.role.into();
    }
    std::fs::write(&file, serde_json::to_vec(&document).unwrap()).unwrap();
    // as it is read
    (file.clone(), serde_json::from_slice(&std::fs::read(&file).unwrap()).unwrap())
}

#[test]
fn a_robot_of_any_model_is_the_one_of_its_own_parameters() {
    for name in ROBOTS {
        let scratch = Scratch::with(&[]);
        let robot = build(&path(name));
        let (_, document) = document(&scratch, robot.as_ref());
        let expected = 3 * robot.branches().len().max(1);
        assert_eq!(document.reference_poses.len(), expected, "{name}");
        let distance_mm = document.geometry_distance_mm(robot.as_ref()).unwrap();
        assert!(distance_mm < 1e-9, "{name}: {distance_mm}");
        // whatever base and targets are
        let moved = |(i, p): (usize, &etalon::robots::Parameter)| match p.role {
            etalon::robots::Role::Robot => p.nominal,
            _ => p.nominal + 0.1 * (i + 1) as f64,
        };
        let elsewhere: Vec<f64> = robot.parameters().iter().enumerate().map(moved).collect();
        let mut placed = build(&path(name));
        placed.definition_mut().set_nominal(&elsewhere);
        let distance_mm = document.geometry_distance_mm(placed.as_ref()).unwrap();
        assert!(distance_mm < 1e-6, "{name}: {distance_mm}");
    }
}

/// A change of a robot file: the sample, and what is replaced.
type Change = (&'static str, &'static str, &'static str);

/// The robot with the change, and parameters of the robot without.
fn changed((robot, from, to): Change) -> (Box<dyn Robot>, ParametersDocument) {
    let scratch = Scratch::with(&[]);
    let (_, document) = document(&scratch, build(&path(robot)).as_ref());
    let text = std::fs::read_to_string(path(robot)).unwrap();
    assert!(text.contains(from), "{robot}: {from}");
    let file = scratch.path().join("robot.toml");
    std::fs::write(&file, text.replacen(from, to, 1)).unwrap();
    (build(&file), document)
}

#[test]
fn texts_of_the_same_robot_are_no_other_robot() {
    for change in [
        (ELASTIC, "name = ", "# drawn in 2024\nname = "),
        (ELASTIC, "Six-axis arm", "Arm 7"),
        // keys in another order, lengths in metres, a direction that is not of unit length
        (ELASTIC, "direction = [0, 0, 1], point_mm = [0, 0, 0]", "point_m = [0, 0, 0], direction = [0, 0, 2]"),
        (ELASTIC, "point_mm = [0, 0, 290]", "point_m = [0, 0, 0.290]"),
        (ELASTIC, "model =", "tolerance = { length_mm = 3 }\nmodel ="),
        ("samples/prexyt-cmm/robot.toml", "model =", "# K\nmodel ="),
    ] {
        let (robot, document) = changed(change);
        let distance_mm = document.geometry_distance_mm(robot.as_ref()).unwrap();
        assert!(distance_mm < 1e-9, "{change:?}: {distance_mm}");
        check_geometry(robot.as_ref(), &document).unwrap();
    }
}

#[test]
fn another_geometry_is_refused_wherever_parameters_are_given() {
    for (change, expected_mm) in [
        // an axis that turns the flange is moved by 10 mm: at most 20 mm, where it has turned by half a turn
        (
            (
                ELASTIC,
                "direction = [1, 0, 0], point_mm = [0, 0, 630]",
                "direction = [1, 0, 0], point_mm = [0, 10, 630]",
            ),
            1.0..20.0,
        ),
        ((ELASTIC, "flange_xyz_mm = [374, 0, 630]", "flange_xyz_mm = [375, 0, 630]"), 0.999..1.001),
        // slips: a sign, a unit, two joints exchanged
        (
            (
                ELASTIC,
                "direction = [0, 1, 0], point_mm = [0, 0, 560]",
                "direction = [0, -1, 0], point_mm = [0, 0, 560]",
            ),
            100.0..4000.0,
        ),
        ((ELASTIC, "point_mm = [302, 0, 630] }", "point_mm = [302, 0, 6300] }"), 100.0..40000.0),
        ((ELASTIC, "flange_rpy_deg = [0, 90, 0]", "flange_rpy_deg = [90, 0, 0]"), 50.0..300.0),
        // effects of loads, which are nominally zero
        ((ELASTIC, "mass_kg = 7.0", "mass_kg = 70.0"), 1e-6..10.0),
    ] {
        let (robot, document) = changed(change);
        let distance_mm = document.geometry_distance_mm(robot.as_ref()).unwrap();
        assert!(expected_mm.contains(&distance_mm), "{change:?}: {distance_mm}");
        let robot_role = [etalon::robots::Role::Robot];
        for refused in [
            check_geometry(robot.as_ref(), &document).unwrap_err(),
            parameters_from_document(robot.as_ref(), &document).unwrap_err(),
            robot_values(robot.as_ref(), &document, &robot_role).unwrap_err(),
        ] {
            assert!(
                refused.0.iter().any(|m| m.is("robot-geometry-changed", &[("case", &"apart")])),
                "{change:?}: {refused:?}"
            );
        }
    }
}

/// Nominal values that are parameters are named, as before; verification takes the identified ones.
#[test]
fn a_changed_nominal_value_is_no_other_geometry() {
    let change = ("samples/abb-irb120/robot.toml", "a_mm = 270.0", "a_mm = 225.0");
    let (robot, document) = changed(change);
    assert!(other_nominal(robot.as_ref(), &document).unwrap().is("nominal-value-changed", &[]));
    let distance_mm = document.geometry_distance_mm(robot.as_ref()).unwrap();
    assert!(distance_mm < 1e-9, "{distance_mm}");
}

/// A document of an earlier version has no geometry: the hash of the robot file is all there is.
#[test]
fn without_geometry_another_file_is_said() {
    let (robot, mut document) = changed((ELASTIC, "flange_xyz_mm = [374, 0, 630]", "flange_xyz_mm = [375, 0, 630]"));
    document.provenance.inputs = [("robot.toml".to_owned(), "ab".to_owned())].into();
    assert!(unknown_geometry(&document, "cd").is_none());
    document.reference_poses.clear();
    check_geometry(robot.as_ref(), &document).unwrap();
    assert!(unknown_geometry(&document, "ab").is_none());
    assert!(unknown_geometry(&document, "cd").unwrap().is("robot-geometry-unknown", &[]));
}

#[test]
fn commands_refuse_the_other_robot() {
    let scratch = Scratch::with(&[]);
    let (parameters, _) = document(&scratch, build(&path(ELASTIC)).as_ref());
    let text = std::fs::read_to_string(path(ELASTIC)).unwrap();
    let file = |name: &str, text: &str| {
        std::fs::write(scratch.path().join(name), text).unwrap();
        scratch.path().join(name).display().to_string()
    };
    let same = file("same.toml", &text.replace("name = \"Six", "# edited\nname = \"Seven"));
    let other = file("other.toml", &text.replace("[374, 0, 630]", "[384, 0, 630]"));
    let targets = file("targets.csv", "pose,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg\n1,20,-30,40,-50,40,30\n");
    let to = scratch.path().join("exported").display().to_string();
    for arguments in [
        vec!["export", &parameters, "--format", "python-kinematics", "--to", &to],
        vec!["compensate", &targets, "--parameters", &parameters],
        vec!["kinematics", "direct", &targets, "--parameters", &parameters],
    ] {
        let with = |robot: &str| etalon(&[&arguments[..], &["--robot", robot]].concat());
        let (code, said) = with(&same);
        assert_eq!(code, Some(0), "{arguments:?}: {said}");
        let (code, said) = with(&other);
        assert!(code == Some(2) && said.says("error[robot-geometry-changed]"), "{arguments:?}: {said}");
    }
}
