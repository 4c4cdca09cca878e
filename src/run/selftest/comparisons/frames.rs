//! Orientations by hand, and the transform between two sets of points.

use crate::run::selftest::data::{Data, Slip};
use crate::run::selftest::row::{Rows, Subject, not_made};
use etalon_base::phrase;
use etalon_base::pose::{Pose, Vector};
use etalon_fit::rigid;

pub(crate) const SUBJECT: Subject = Subject {
    id: "frames",
    requirement: || phrase!("selftest-frames"),
    rows,
    slips: &[
        Slip::Digit("/published/frames/rpy/expected/matrix/1", 6),
        Slip::Swap("/published/frames/rpy/angles_deg/0", "/published/frames/rpy/angles_deg/2"),
        Slip::Unit("/published/frames/rotation_vector/angle_deg", 180.0 / std::f64::consts::PI),
    ],
};

fn rows(data: &Data) -> Vec<Rows> {
    let mut rows = Rows::new("geometry");
    let data = data.at("/published/frames");
    let turned = data.at("/rotation_vector");
    let (axis, angle) = (turned.numbers("/axis"), turned.number("/angle_deg").to_radians());
    let size = axis.iter().map(|v| v * v).sum::<f64>().sqrt();
    let vector: Vector = std::array::from_fn(|i| axis.get(i).map_or(f64::NAN, |v| v / size * angle));
    let pose = Pose::from_rotation_vector(vector);
    let [w, x, y, z] = pose.quaternion();
    let sign = w.signum();
    let quaternion = [w, x, y, z].map(|v| sign * v);
    rows.add_all(phrase!("selftest-quaternion"), "", [&turned.numbers("/expected/quaternion"), &quaternion], 1e-14);
    rows.add_all(phrase!("selftest-rotation-vector"), "", [&turned.numbers("/expected/matrix"), &cells(&pose)], 1e-14);
    rows.add_all(phrase!("selftest-rotation-vector-back"), "rad", [&vector, &pose.rotation_vector_rad()], 1e-14);
    let back = Pose::from_quaternion(pose.quaternion());
    rows.add_all(phrase!("selftest-quaternion-back"), "", [&cells(&pose), &cells(&back)], 1e-14);

    let rpy = data.numbers("/rpy/angles_deg");
    let angles: Vector = std::array::from_fn(|i| rpy.get(i).map_or(f64::NAN, |v| v.to_radians()));
    let pose = Pose::from_xyz_rpy([10.0, 20.0, 30.0], angles);
    rows.add_all(phrase!("selftest-rpy"), "", [&data.numbers("/rpy/expected/matrix"), &cells(&pose)], 1e-14);
    rows.add_all(phrase!("selftest-rpy-back"), "rad", [&angles, &pose.rpy_rad()], 1e-14);
    // x of the moved frame is y here: (5, 0, 0) goes to (10, 25, 30)
    rows.add_all(phrase!("selftest-apply"), "mm", [&[10.0, 25.0, 30.0], &pose.apply([5.0, 0.0, 0.0])], 1e-12);
    let [expected, found] = [Pose::identity(), pose.then(&pose.inverse())].map(|p| with_place(&p));
    rows.add_all(phrase!("selftest-inverse"), "mm", [&expected, &found], 1e-12);
    moved(&data.at("/rigid"), &mut rows);
    vec![rows]
}

/// The transform that moved known points.
fn moved(data: &Data, rows: &mut Rows) {
    let numbers = |pointer: &str| -> Vector {
        let all = data.numbers(pointer);
        std::array::from_fn(|i| all.get(i).copied().unwrap_or(f64::NAN))
    };
    let pose = Pose::from_xyz_rpy(numbers("/shift_mm"), numbers("/turn_deg").map(f64::to_radians));
    let from = data.points("/points_mm");
    let to: Vec<Vector> = from.iter().map(|p| pose.apply(*p)).collect();
    match rigid(&from, &to) {
        Ok(fit) => {
            let [expected, found] = [&pose, &fit.to_T_from].map(with_place);
            rows.add_all(phrase!("selftest-rigid"), "mm", [&expected, &found], 1e-10);
            rows.add(phrase!("selftest-rigid-rms"), "mm", [0.0, fit.rms_mm()], 1e-10);
        }
        Err(problems) => rows.failed(not_made("rigid", &problems)),
    }
}

/// Rotation matrix, row by row.
fn cells(pose: &Pose) -> Vec<f64> {
    pose.rotation.as_flattened().to_vec()
}

/// Rotation matrix and translation.
fn with_place(pose: &Pose) -> Vec<f64> {
    [&cells(pose)[..], &pose.translation_mm].concat()
}
