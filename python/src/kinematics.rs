//! Direct and inverse kinematics of arrays of joint values and poses.

use crate::computing::compute_long;
use crate::errors::refused;
use crate::robot::{Robot, kinematics};
use etalon::run::documents::parse_parameters;
use etalon::tasks::{self, Arm, stated_parameters};
use etalon_base::message::{Message, Problems};
use etalon_base::pose::Pose;
use etalon_robots::Robot as Model;
use numpy::{IntoPyArray, PyArray2, PyArrayMethods, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::prelude::*;

/// Numbers of a pose: x, y, z (mm), qw, qx, qy, qz.
const POSE: usize = 7;

/// Poses (n, 7) at joint values (n, joints) in mm and deg; NaN where the robot cannot be there.
#[pyfunction]
#[pyo3(signature = (robot, joints, parameters=None))]
pub fn direct<'py>(
    py: Python<'py>,
    robot: &Robot,
    joints: PyReadonlyArray2<'py, f64>,
    parameters: Option<&str>,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let model = robot.model()?;
    let values = stated_parameters(model.as_ref(), parameters).map_err(refused)?;
    let arm = kinematics(model.as_ref())?;
    let rows = inward(arm, &joints, "joints")?;
    let poses: Vec<f64> = py.detach(|| {
        let pose = |q: &Vec<f64>| match arm.tool_pose(&values, q) {
            Some(pose) => numbers(&pose),
            None => [f64::NAN; POSE],
        };
        rows.iter().flat_map(pose).collect()
    });
    poses.into_pyarray(py).reshape([rows.len(), POSE])
}

/// Positions (n, 3) in mm of a target at joint values (n, joints), and their covariances (n, 9) in
/// mm².
#[pyfunction]
pub fn predict<'py>(
    py: Python<'py>,
    robot: &Robot,
    parameters: &str,
    joints: PyReadonlyArray2<'py, f64>,
    target: &str,
) -> PyResult<(Rows<'py>, Rows<'py>)> {
    let model = robot.model()?;
    let rows = inward(model.as_ref(), &joints, "joints")?;
    let document = parse_parameters("parameters", parameters).map_err(refused)?;
    let found = py.detach(|| {
        let prediction = robot.prediction(&document, target)?;
        Ok::<_, Problems>(rows.iter().map(|q| prediction.at(q)).collect::<Vec<_>>())
    });
    let found = found.map_err(refused)?;
    let positions: Vec<f64> = found.iter().flat_map(|at| at.position_mm).collect();
    let covariances: Vec<f64> = found.iter().flat_map(|at| at.covariance_mm2.into_iter().flatten()).collect();
    let positions = positions.into_pyarray(py).reshape([rows.len(), 3])?;
    Ok((positions, covariances.into_pyarray(py).reshape([rows.len(), 9])?))
}

/// Jacobians of the flange (n, 6 * joints): velocity (mm) and rotation vector (deg) in the base
/// per unit of each joint.
#[pyfunction]
#[pyo3(signature = (robot, joints, parameters=None))]
pub fn jacobian<'py>(
    py: Python<'py>,
    robot: &Robot,
    joints: PyReadonlyArray2<'py, f64>,
    parameters: Option<&str>,
) -> PyResult<Rows<'py>> {
    let model = robot.model()?;
    let (rows, twists) = (inward(model.as_ref(), &joints, "joints")?, robot.twists(parameters)?);
    let units: Vec<f64> = model.joints().iter().map(|joint| joint.quantity.inward(1.0)).collect();
    let n = units.len();
    let row = |q: &Vec<f64>| {
        let mut all = twists.at(q);
        for (i, row) in all.chunks_exact_mut(n).enumerate() {
            let outward = if i < 3 { 1.0 } else { f64::to_degrees(1.0) };
            row.iter_mut().zip(&units).for_each(|(value, unit)| *value *= unit * outward);
        }
        all
    };
    let values: Vec<f64> = py.detach(|| rows.iter().flat_map(row).collect());
    values.into_pyarray(py).reshape([rows.len(), 6 * n])
}

/// Names of the parameters, and derivatives (n, 3 * parameters) of the position of a target with
/// respect to them, in mm per unit of each parameter.
#[pyfunction]
pub fn sensitivity<'py>(
    py: Python<'py>,
    robot: &Robot,
    parameters: &str,
    joints: PyReadonlyArray2<'py, f64>,
    target: &str,
) -> PyResult<(Vec<String>, Rows<'py>)> {
    let model = robot.model()?;
    let rows = inward(model.as_ref(), &joints, "joints")?;
    let document = parse_parameters("parameters", parameters).map_err(refused)?;
    let prediction = robot.prediction(&document, target).map_err(refused)?;
    let parameters = prediction.robot().parameters();
    let names: Vec<String> = parameters.iter().map(|p| p.name.clone()).collect();
    let units: Vec<f64> = parameters.iter().map(|p| p.quantity.inward(1.0)).collect();
    let row = |q: &Vec<f64>| {
        let mut all = prediction.sensitivity(q);
        all.iter_mut().zip(units.iter().cycle()).for_each(|(value, unit)| *value *= unit);
        all
    };
    let values: Vec<f64> = py.detach(|| rows.iter().flat_map(row).collect());
    Ok((names, values.into_pyarray(py).reshape([rows.len(), 3 * units.len()])?))
}

/// Rows of numbers.
type Rows<'py> = Bound<'py, PyArray2<f64>>;

/// How solutions are looked for.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Search<'py> {
    /// Joint values near which the solution is looked for; one row for all, or one for each pose.
    near: Option<PyReadonlyArray2<'py, f64>>,
    /// All solutions instead of the nearest.
    all: bool,
}

/// Row of a pose without solution, and the reason: id and text.
type Missing = (usize, String, String);

/// Row of the pose for each solution, the solutions, and the reason for each pose without one.
type Solutions<'py> = (Vec<usize>, Rows<'py>, Vec<Missing>);

/// Joint values in mm and deg at poses (n, 7).
#[pyfunction]
#[pyo3(signature = (robot, poses, search, parameters=None))]
pub fn inverse<'py>(
    py: Python<'py>,
    robot: &Robot,
    poses: PyReadonlyArray2<'py, f64>,
    search: Search<'py>,
    parameters: Option<&str>,
) -> PyResult<Solutions<'py>> {
    let model = robot.model()?;
    let values = stated_parameters(model.as_ref(), parameters).map_err(refused)?;
    let arm = kinematics(model.as_ref())?;
    let starts = search.near.as_ref().map(|near| inward(arm, near, "near")).transpose()?.unwrap_or_default();
    let poses: Vec<Pose> = crate::fit::rows::<POSE>(&poses)?.iter().map(pose).collect();
    let found = compute_long(py, None, |_| {
        tasks::inverse(Arm { model: arm, values: &values }, &poses, &starts, !search.all)
    })?
    .map_err(refused)?;
    let mut missing = Vec::new();
    let (mut rows, mut values) = (Vec::new(), Vec::new());
    let width = values_of(arm);
    for (row, solutions) in found.into_iter().enumerate() {
        match solutions {
            Err(reason) => missing.push((row, reason.id.clone().into_owned(), reason.to_string())),
            Ok(solutions) => {
                for joints in solutions {
                    rows.push(row);
                    let outward = arm.joints().iter().zip(&joints).map(|(joint, q)| joint.quantity.outward(*q));
                    values.extend(outward.chain(joints.get(arm.joints().len()).copied()));
                }
            }
        }
    }
    let values = values.into_pyarray(py).reshape([rows.len(), width])?;
    Ok((rows, values, missing))
}

/// The pose of a row of numbers.
fn pose(&[x, y, z, qw, qx, qy, qz]: &[f64; POSE]) -> Pose {
    Pose { translation_mm: [x, y, z], ..Pose::from_quaternion([qw, qx, qy, qz]) }
}

/// Numbers of a row of joint values: the assembly mode is behind the joints.
fn values_of(arm: &dyn Model) -> usize {
    arm.joints().len() + usize::from(arm.has_assembly_modes())
}

/// Rows of joint values in rad and mm, from the argument with this name.
fn inward(arm: &dyn Model, joints: &PyReadonlyArray2<f64>, name: &str) -> PyResult<Vec<Vec<f64>>> {
    let (shape, width) = (joints.shape(), values_of(arm));
    if shape[1] != width {
        let message = Message::error(format!("`{name}` has the shape ({}, {})", shape[0], shape[1]));
        let columns: Vec<String> = arm.joints().iter().map(|joint| joint.column()).collect();
        return Err(refused(message.expected(format!("(n, {width}): {}", columns.join(", "))).into()));
    }
    let array = joints.as_array();
    let row = |row: numpy::ndarray::ArrayView1<f64>| {
        let inward = arm.joints().iter().zip(row.iter()).map(|(joint, q)| joint.quantity.inward(*q));
        inward.chain(row.iter().skip(arm.joints().len()).copied()).collect()
    };
    Ok(array.rows().into_iter().map(row).collect())
}

fn numbers(pose: &Pose) -> [f64; POSE] {
    let [x, y, z] = pose.translation_mm;
    let [qw, qx, qy, qz] = pose.quaternion();
    [x, y, z, qw, qx, qy, qz]
}
