//! Kinematics of each model against an independent program with 60 digits
//! (`tests/selftest/make.py`), against its own inverse and numeric derivatives, and against the
//! code that etalon exports.

use crate::run::selftest::code::Function;
use crate::run::selftest::data::{Data, Slip};
use crate::run::selftest::row::{Rows, Subject, not_made};
use crate::run::selftest::sample::{document, inward, positions, robot};
use etalon_base::message::Problems;
use etalon_base::phrase;
use etalon_base::pose::{Pose, Vector, minus, norm};
use etalon_controllers::{ExportInput, by_name};
use etalon_robots::{Kinematics, Robot};

pub(crate) const SUBJECT: Subject = Subject {
    id: "kinematics",
    requirement: || phrase!("selftest-kinematics"),
    rows,
    slips: &[
        Slip::Digit("/kinematics/0/targets_mm/0/1", 11),
        Slip::Swap("/kinematics/6/joints/0/0", "/kinematics/6/joints/0/1"),
        Slip::Unit("/kinematics/2/joints", std::f64::consts::PI / 180.0),
    ],
};

/// Permissible deviation of a position (mm).
const POSITION: f64 = 1e-9;

fn rows(data: &Data) -> Vec<Rows> {
    data.at("/kinematics").items().iter().flat_map(model_rows).collect()
}

fn model_rows(item: &Data) -> [Rows; 2] {
    let (mut outside, mut own) = (Rows::new("tests/selftest/make.py"), Rows::new("own inverse"));
    let name = item.text("/model");
    let targets: &[&str] = if name == "prexyt" { &["K", "L"] } else { &["ball"] };
    let robot = match robot(item.text("/robot"), item.text("/urdf"), targets) {
        Ok(robot) => robot,
        Err(problems) => {
            outside.failed(not_made(name, &problems));
            return [outside, own];
        }
    };
    let robot = robot.as_ref();
    let joints: Vec<Vec<f64>> = item.at("/joints").items().iter().map(|q| inward(robot, &q.numbers(""))).collect();
    let nominal = robot.nominal();
    let found: Vec<f64> = joints.iter().flat_map(|q| positions(robot, &nominal, q)).collect();
    outside.add_all(phrase!("selftest-positions", name), "mm", [&item.numbers("/targets_mm"), &found], POSITION);
    own.add(phrase!("selftest-jacobian", name), "", [0.0, jacobian_error(robot, &joints)], 1e-6);
    if let Some(arm) = robot.kinematics() {
        back(name, arm, &joints, &mut own);
        code(name, arm, &joints, &mut own);
    }
    [outside, own]
}

/// direct(inverse(pose)) and the joint values of the inverse.
fn back(name: &str, arm: &dyn Kinematics, joints: &[Vec<f64>], rows: &mut Rows) {
    let nominal = arm.nominal();
    let count = arm.joints().len();
    let (mut position, mut joint) = (0.0f64, 0.0f64);
    for q in joints {
        let pose = arm.tool_pose(&nominal, q);
        let near: Vec<f64> = q.iter().enumerate().map(|(i, q)| if i < count { q + 0.01 } else { *q }).collect();
        let found = pose.as_ref().and_then(|pose| arm.nearest_joints(&nominal, pose, &near).ok());
        let again = found.as_ref().and_then(|q| arm.tool_pose(&nominal, q));
        let (Some(pose), Some(found), Some(again)) = (pose, found, again) else {
            return rows.failed(phrase!("selftest-inverse-none", name));
        };
        position = position.max(norm(minus(pose.translation_mm, again.translation_mm)));
        // a chain of fewer than six joints reaches its poses alone
        joint = q.iter().zip(&found).map(|(a, b)| (a - b).abs()).fold(joint, f64::max);
    }
    rows.add(phrase!("selftest-direct-of-inverse", name), "mm", [0.0, position], 1e-8);
    rows.add(phrase!("selftest-inverse-of-direct", name), "mm, rad", [0.0, joint], 1e-8);
}

/// Largest difference of the Jacobian from numeric derivatives (fourth-order central differences),
/// with respect to parameters and joints.
fn jacobian_error(robot: &dyn Robot, joints: &[Vec<f64>]) -> f64 {
    let nominal = robot.nominal();
    let (n, rows) = (nominal.len(), robot.dimension() * robot.targets().len());
    let mut worst = 0.0f64;
    for q in joints {
        let at = |p: &[f64], q: &[f64]| {
            let mut out = vec![0.0; rows];
            robot.positions(p, q, &mut out);
            out
        };
        let slope = |shifted: &dyn Fn(f64) -> Vec<f64>, h: f64| -> Vec<f64> {
            let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(|k| shifted(k * h));
            (0..rows).map(|i| (a[i] - 8.0 * b[i] + 8.0 * c[i] - d[i]) / (12.0 * h)).collect()
        };
        let (mut by_parameters, mut by_joints) = (vec![0.0; rows * n], vec![0.0; rows * robot.joints().len()]);
        robot.jacobian(&nominal, q, &mut by_parameters);
        robot.joint_jacobian(&nominal, q, &mut by_joints);
        let moved = |values: &[f64], j: usize, by: f64| {
            let mut values = values.to_vec();
            values[j] += by;
            values
        };
        let mut compare = |analytic: &[f64], columns: usize, j: usize, numeric: Vec<f64>| {
            for (i, numeric) in numeric.into_iter().enumerate() {
                worst = worst.max((analytic[i * columns + j] - numeric).abs());
            }
        };
        for j in 0..n {
            compare(&by_parameters, n, j, slope(&|by| at(&moved(&nominal, j, by), q), 1e-4));
        }
        let count = robot.joints().len();
        for j in 0..count {
            compare(&by_joints, count, j, slope(&|by| at(&nominal, &moved(q, j, by)), 1e-4));
        }
    }
    worst
}

/// Position by the functions of the exported code, evaluated from their text.
fn code(name: &str, arm: &dyn Kinematics, joints: &[Vec<f64>], rows: &mut Rows) {
    let nominal = arm.nominal();
    let document = match document(arm, &nominal) {
        Ok(document) => document,
        Err(problems) => return rows.failed(not_made(name, &problems)),
    };
    let given = ExportInput { robot: Some(arm), ..ExportInput::parameters(&document) };
    let planar = arm.dimension() == 2;
    for format in ["c-kinematics", "python-kinematics"] {
        let text = match by_name(format).map_err(Problems::from).and_then(|exporter| exporter.write(&given)) {
            Ok(bytes) => String::from_utf8_lossy(&bytes).into_owned(),
            Err(problems) => return rows.failed(not_made(format, &problems)),
        };
        let [expected, found]: [Vec<f64>; 2] = [true, false].map(|own| {
            let one = |q: &Vec<f64>| match own {
                true => arm.tool_pose(&nominal, q).map_or([f64::NAN; 3], |pose| pose.translation_mm),
                false => direct(&text, q, planar).unwrap_or([f64::NAN; 3]),
            };
            joints.iter().flat_map(one).collect()
        });
        rows.add_all(phrase!("selftest-code", name, format), "mm", [&expected, &found], POSITION);
    }
}

/// Position by the direct kinematics of a program.
fn direct(text: &str, q: &[f64], planar: bool) -> Option<Vector> {
    if let Some(direct) = Function::find(text, "direct") {
        let out = direct.at(q)?;
        return Some([*out.first()?, *out.get(1)?, if planar { 0.0 } else { *out.get(2)? }]);
    }
    // Newton's method of the program, from the home pose of the test
    let step = Function::find(text, "step")?;
    let home = Pose { translation_mm: [0.0, 0.0, 400.0], ..Pose::identity() };
    let mut pose: Vec<f64> = home.translation_mm.iter().chain(home.rotation.as_flattened()).copied().collect();
    for _ in 0..100 {
        let inputs: Vec<f64> = pose.iter().chain(q).copied().collect();
        let out = step.at(&inputs)?;
        let (size, next) = out.split_last()?;
        pose = next.to_vec();
        if *size < 1e-10 {
            return Some([pose[0], pose[1], pose[2]]);
        }
    }
    None
}
