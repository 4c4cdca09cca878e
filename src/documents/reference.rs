//! Reference poses of `parameters.json`: they show whether a robot is the one whose parameters were
//! identified.

use crate::{ParameterEntry, ParametersDocument, Role};
use etalon_base::pose::{Vector, minus, norm};
use etalon_robots::{Parameter, Robot, reference_pose, reference_poses};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;

/// Three points of the flange at joint values, in the frame of the base, by the nominal geometry.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ReferencePose {
    /// Link at the end of the branch, for a robot with several branches.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub branch: Option<String>,
    /// Joint values (mm or deg), in the order of the joints.
    pub joints: Vec<f64>,
    /// Flange origin, and the points 100 mm along its x and y axes, at nominal parameters (mm).
    pub nominal_mm: [[f64; 3]; 3],
    /// These points with each parameter of the robot 0.1 mm, 0.1 deg or 0.0001 above its nominal
    /// value (mm): this shows effects whose nominal values are zero.
    pub varied_mm: [[f64; 3]; 3],
}

impl ReferencePose {
    /// Reference poses of a robot with its nominal parameters.
    pub fn all(robot: &dyn Robot) -> Vec<Self> {
        let convert = |pose: etalon_robots::ReferencePose| {
            let joints = robot.joints().iter().zip(&pose.joints);
            Self {
                branch: robot.branches().get(pose.branch).cloned(),
                joints: joints.map(|(joint, q)| joint.quantity.outward(*q)).collect(),
                nominal_mm: pose.points_mm,
                varied_mm: pose.varied_mm,
            }
        };
        reference_poses(robot, &robot.nominal()).into_iter().map(convert).collect()
    }

    /// Largest distance (mm) between these points and the points of a robot with the nominal values
    /// of the document. Infinite if the robot does not have the branch, the joints or the pose;
    /// zero for a branch without targets.
    fn distance_mm(&self, robot: &dyn Robot, nominal: &[f64], with_varied: bool) -> f64 {
        let branch = match &self.branch {
            Some(link) => robot.branches().iter().position(|known| known == link),
            None => robot.branches().is_empty().then_some(0),
        };
        let Some(branch) = branch.filter(|_| self.joints.len() == robot.joints().len()) else { return f64::INFINITY };
        let is_seen =
            robot.branches().is_empty() || (0..robot.targets().len()).any(|k| robot.target_branch(k) == branch);
        if !is_seen {
            return 0.0;
        }
        let joints = robot.joints().iter().zip(&self.joints).map(|(joint, q)| joint.quantity.inward(*q)).collect();
        let Some(found) = reference_pose(robot, nominal, branch, joints) else { return f64::INFINITY };
        let largest =
            |a: &[Vector; 3], b: &[Vector; 3]| a.iter().zip(b).map(|(a, b)| norm(minus(*a, *b))).fold(0.0, f64::max);
        let varied = if with_varied { largest(&found.varied_mm, &self.varied_mm) } else { 0.0 };
        largest(&found.points_mm, &self.nominal_mm).max(varied)
    }
}

impl ParametersDocument {
    /// Returns the largest distance (mm) between the flange of a robot and the flange of the robot
    /// whose parameters were identified, both with the nominal values of this document; `None` if
    /// it cannot be compared.
    ///
    /// Nominal values that differ between the two robots are thus not part of it. Loads follow from
    /// the robot's own nominal values: where these differ and effects of loads are not nominally
    /// zero, nothing is compared.
    pub fn geometry_distance_mm(&self, robot: &dyn Robot) -> Option<f64> {
        let entry = |p: &Parameter| self.parameters.iter().find(|entry| entry.name == p.name);
        let value = |p: &Parameter| match entry(p) {
            Some(entry) if p.role == etalon_robots::Role::Robot => p.quantity.inward(entry.nominal),
            _ => p.nominal,
        };
        let nominal: Vec<f64> = robot.parameters().iter().map(value).collect();
        let same_nominal =
            robot.parameters().iter().zip(&nominal).all(|(p, v)| (p.nominal - v).abs() <= ROUNDING * v.abs().max(1.0));
        let is_loaded = robot.parameters().iter().zip(&nominal).any(|(p, v)| !p.effect.is_rigid() && *v != 0.0);
        if self.reference_poses.is_empty() || (is_loaded && !same_nominal) {
            return None;
        }
        let of_robot = |entry: &&ParameterEntry| entry.role == Role::Robot;
        let identified: BTreeSet<&str> =
            self.parameters.iter().filter(of_robot).map(|entry| entry.name.as_str()).collect();
        let stated = robot.parameters().iter().filter(|p| p.role == etalon_robots::Role::Robot);
        let with_varied = same_nominal && identified == stated.map(|p| p.name.as_str()).collect();
        let distances = self.reference_poses.iter().map(|pose| pose.distance_mm(robot, &nominal, with_varied));
        Some(distances.fold(0.0, f64::max))
    }
}

/// Maximum relative difference of a value that counts as rounding.
const ROUNDING: f64 = 1e-9;
