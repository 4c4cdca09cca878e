//! Kinematics of a robot with nominal or identified parameters.

use crate::run::documents::parse_parameters;
use crate::stages::verify::earlier_parameters::robot_values;
use etalon_base::catalogue::Phrase;
use etalon_base::error;
use etalon_base::message::{Place, Result};
use etalon_base::pose::Pose;
use etalon_documents::ParametersDocument;
use etalon_robots::{Kinematics, Robot, Role};
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

/// Uses the parameters of a `parameters.json`, if stated, as the nominal ones.
///
/// # Errors
/// Fails with parameters of another robot.
pub fn set_parameters(robot: &mut dyn Robot, json: Option<&str>) -> Result<()> {
    let Some(json) = json else { return Ok(()) };
    let values = identified(robot, &parse_parameters("parameters", json)?, Path::new("parameters"))?;
    robot.definition_mut().set_nominal(&values);
    Ok(())
}

/// Solutions of the inverse kinematics of a pose (rad and mm), or the reason why it has none.
pub type Solutions = std::result::Result<Vec<Vec<f64>>, Phrase>;

/// Joint values of poses: all solutions of each pose, or the `nearest` to its start.
///
/// `starts` are joint values for each pose, or for all poses; without them a search starts at the
/// solution of the previous pose.
///
/// # Errors
/// Fails if all solutions are infinitely many.
pub fn inverse(arm: &dyn Kinematics, poses: &[Pose], starts: &[Vec<f64>], nearest: bool) -> Result<Vec<Solutions>> {
    let (joints, nominal) = (arm.joints().len(), arm.nominal());
    if !nearest && joints > 6 {
        return Err(error!("infinite-solutions", joints).into());
    }
    let mut last = vec![0.0; joints];
    let solutions = poses.iter().enumerate().map(|(row, pose)| {
        let start = if starts.len() == 1 { starts.first() } else { starts.get(row) }.unwrap_or(&last);
        let found = match nearest {
            true => arm.nearest_joints(&nominal, pose, start).map(|joints| vec![joints]),
            false => arm.solutions(&nominal, pose, start),
        };
        if let Ok([first, ..]) = found.as_deref() {
            last = first[..joints].to_vec();
        }
        found
    });
    Ok(solutions.collect())
}

/// Parameters of a run: those of the robot, and of its base if identified. Targets have their
/// nominal positions.
pub(crate) fn identified(robot: &dyn Robot, document: &ParametersDocument, path: &Path) -> Result<Vec<f64>> {
    let values = robot_values(robot, document, &[Role::Robot, Role::Base]);
    values.map_err(|problems| problems.at(&Place::file(path.display().to_string())))
}
