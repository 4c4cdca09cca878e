//! Kinematics of a robot with nominal or identified parameters.

use crate::run::documents::parse_parameters;
use crate::stages::verify::earlier_parameters::{other_nominal, robot_values};
use etalon_base::catalogue::Phrase;
use etalon_base::interruption::checkpoint;
use etalon_base::message::{Place, Result};
use etalon_base::pose::{Pose, Vector, cross, minus};
use etalon_base::{error, phrase};
use etalon_campaign::RobotFile;
use etalon_documents::ParametersDocument;
use etalon_robots::{Kinematics, Robot, Role};
use std::collections::BTreeMap;
use std::path::Path;

/// Kinematics of a robot.
///
/// # Errors
/// Fails for a robot without inverse kinematics of a whole pose.
pub fn whole_pose(robot: &dyn Robot) -> Result<&dyn Kinematics> {
    let none = || match robot.branches() {
        [] => error!("no-whole-pose", model = robot.model()).into(),
        links => error!("several-branches", links).into(),
    };
    robot.kinematics().ok_or_else(none)
}

/// Parameters of a `parameters.json`, if given; otherwise the nominal ones.
///
/// # Errors
/// Fails with parameters of another robot.
pub fn stated_parameters(robot: &dyn Robot, json: Option<&str>) -> Result<Vec<f64>> {
    let Some(json) = json else { return Ok(robot.nominal()) };
    let document = parse_parameters("parameters", json)?;
    match other_nominal(robot, &document) {
        Some(other) => Err(other.into()),
        None => identified(robot, &document, Path::new("parameters")),
    }
}

/// Solutions of the inverse kinematics of a pose (rad and mm), or the reason why it has none.
pub type Solutions = std::result::Result<Vec<Vec<f64>>, Phrase>;

/// Arm with the values of its parameters.
#[derive(Clone, Copy)]
pub struct Arm<'a> {
    /// Model.
    pub model: &'a dyn Kinematics,
    /// Values of the parameters (mm, rad).
    pub values: &'a [f64],
}

/// Joint values of poses: all solutions of each pose, or the `nearest` to its start.
///
/// `starts` are joint values for each pose, or for all poses; without them a search starts at the
/// solution of the previous pose.
///
/// # Errors
/// Fails if all solutions are infinitely many.
pub fn inverse(arm: Arm, poses: &[Pose], starts: &[Vec<f64>], nearest: bool) -> Result<Vec<Solutions>> {
    let Arm { model, values } = arm;
    let joints = model.joints().len();
    if !nearest && joints > 6 {
        return Err(error!("infinite-solutions", joints).into());
    }
    let mut last = vec![0.0; joints];
    let solutions = poses.iter().enumerate().map(|(row, pose)| {
        checkpoint();
        if !pose.translation_mm.iter().chain(&pose.quaternion()).all(|value| value.is_finite()) {
            return Err(phrase!("pose-not-finite"));
        }
        let start = if starts.len() == 1 { starts.first() } else { starts.get(row) }.unwrap_or(&last);
        let found = match nearest {
            true => model.nearest_joints(values, pose, start).map(|joints| vec![joints]),
            false => model.solutions(values, pose, start),
        };
        if let Ok([first, ..]) = found.as_deref() {
            last = first[..joints].to_vec();
        }
        found
    });
    Ok(solutions.collect())
}

/// Names of the points of a [`Twists`].
const POINTS: [&str; 3] = ["etalon_origin", "etalon_x", "etalon_y"];

/// Motion of the flange by its joints: the Jacobian of its pose in the base.
pub struct Twists {
    /// The robot with three targets at the flange: its origin, and 1 mm from it along x and y.
    robot: Box<dyn Robot>,
    /// Values of its parameters.
    values: Vec<f64>,
}

impl Twists {
    /// The robot of a file, with the parameters of a `parameters.json`, if given.
    ///
    /// # Errors
    /// Fails for a robot whose flange has no whole pose in space, and with parameters of another
    /// robot.
    pub fn new(file: &RobotFile, json: Option<&str>) -> Result<Self> {
        let robot = file.build(&POINTS.map(str::to_owned))?;
        let known = whole_pose(robot.as_ref())?;
        let spatial = known.dimension() == 3 && known.base_in_world(&known.nominal()).is_some();
        if !spatial || robot.targets() != POINTS {
            return Err(error!("no-whole-pose", model = robot.model()).into());
        }
        let mut values = stated_parameters(robot.as_ref(), json)?;
        let places: BTreeMap<String, f64> = POINTS
            .iter()
            .zip([[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
            .flat_map(|(point, place)| ["x", "y", "z"].map(|axis| format!("{point}_{axis}")).into_iter().zip(place))
            .collect();
        for (value, p) in values.iter_mut().zip(robot.parameters()) {
            *value = places.get(&p.name).copied().unwrap_or(if p.role == Role::Base { 0.0 } else { *value });
        }
        Ok(Self { robot, values })
    }

    /// Velocity (mm) of the flange's origin and its rotation vector (rad) per mm or rad of each
    /// joint, in the base: six rows of all joints.
    pub fn at(&self, joints: &[f64]) -> Vec<f64> {
        let (n, values) = (self.robot.joints().len(), &self.values);
        let (mut places, mut moves) = (vec![0.0; 9], vec![0.0; 9 * n]);
        self.robot.positions(values, joints, &mut places);
        self.robot.joint_jacobian(values, joints, &mut moves);
        let point = |k: usize| -> Vector { std::array::from_fn(|i| places[3 * k + i]) };
        let [x, y] = [1, 2].map(|k| minus(point(k), point(0)));
        let z = cross(x, y);
        let mut twists = vec![0.0; 6 * n];
        for joint in 0..n {
            let motion = |k: usize| -> Vector { std::array::from_fn(|i| moves[(3 * k + i) * n + joint]) };
            let [dx, dy] = [1, 2].map(|k| minus(motion(k), motion(0)));
            let (first, second) = (cross(dx, y), cross(x, dy));
            let dz: Vector = std::array::from_fn(|i| first[i] + second[i]);
            // the axes turn with ω: Σ e × (ω × e) = 2 ω
            let parts = [cross(x, dx), cross(y, dy), cross(z, dz)];
            for i in 0..3 {
                twists[i * n + joint] = motion(0)[i];
                twists[(3 + i) * n + joint] = 0.5 * parts.iter().map(|part| part[i]).sum::<f64>();
            }
        }
        twists
    }
}

/// Parameters of a run: of the robot, and of its base if identified. Targets have their nominal
/// positions.
pub(crate) fn identified(robot: &dyn Robot, document: &ParametersDocument, path: &Path) -> Result<Vec<f64>> {
    let values = robot_values(robot, document, &[Role::Robot, Role::Base]);
    values.map_err(|problems| problems.at(&Place::file(path.display().to_string())))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tasks::known_text;
    use etalon_base::pose::norm;
    use etalon_campaign::parse_robot;

    /// Differences of poses at joint values on either side.
    #[test]
    fn twists_are_derivatives_of_the_pose() {
        let file = parse_robot(Path::new("robot.toml"), &known_text("ur5e").unwrap()).unwrap();
        let (twists, robot) = (Twists::new(&file, None).unwrap(), file.build(&["tool".to_owned()]).unwrap());
        let (arm, q, step) = (whole_pose(robot.as_ref()).unwrap(), [0.2, -1.4, 1.2, -0.5, 0.7, 0.1], 1e-5);
        let found = twists.at(&q);
        for joint in 0..6 {
            let pose = |side: f64| {
                let mut q = q;
                q[joint] += side * step;
                arm.tool_pose(&arm.nominal(), &q).unwrap()
            };
            let (before, after) = (pose(-1.0), pose(1.0));
            let speed = minus(after.translation_mm, before.translation_mm).map(|v| v / (2.0 * step));
            let turn = after.then(&before.inverse()).rotation_vector_rad().map(|v| v / (2.0 * step));
            let column = |first: usize| -> Vector { std::array::from_fn(|i| found[(first + i) * 6 + joint]) };
            assert!(norm(minus(column(0), speed)) < 1e-5, "{joint}: {speed:?} {:?}", column(0));
            assert!(norm(minus(column(3), turn)) < 1e-8, "{joint}: {turn:?} {:?}", column(3));
        }
    }

    #[test]
    fn a_robot_in_the_plane_has_no_twists() {
        let file = parse_robot(Path::new("robot.toml"), &known_text("five-bar").unwrap()).unwrap();
        let refused = Twists::new(&file, None).err().unwrap();
        assert!(refused.0[0].is("no-whole-pose", &[]), "{refused}");
    }
}
