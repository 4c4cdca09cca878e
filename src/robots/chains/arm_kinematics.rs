//! Kinematics of serial arms: poses, formulas, and the solutions of a search.

use crate::inverse::Search;
use crate::serial::Serial;
use crate::{Kinematics, Robot, base_pose};
use etalon_base::catalogue::Phrase;
use etalon_base::expression::Formula;
use etalon_base::pose::Pose;

impl Serial {
    /// Inverse kinematics near `start`: joint values at which the flange has the pose
    /// `world_T_flange`.
    ///
    /// Returns `None` if the pose cannot be reached to within 1e-9 mm and 1e-12 rad on the branch
    /// of `start`.
    pub fn inverse(&self, parameters: &[f64], world_T_flange: &Pose, start: &[f64]) -> Option<Vec<f64>> {
        Search::new(self, parameters, *world_T_flange).solve(start)
    }

    /// Search for the joint values of a pose of the flange in the base.
    pub(crate) fn search<'a>(&'a self, parameters: &'a [f64], pose: &Pose) -> Search<'a> {
        Search::new(self, parameters, base_pose(parameters).then(pose))
    }
}

impl Kinematics for Serial {
    fn tool_pose(&self, parameters: &[f64], joints: &[f64]) -> Option<Pose> {
        let pose = base_pose(parameters).inverse().then(&self.direct(parameters, joints));
        pose.translation_mm.iter().all(|v| v.is_finite()).then_some(pose)
    }

    fn base_in_world(&self, parameters: &[f64]) -> Option<Pose> {
        Some(base_pose(parameters))
    }

    fn formulas(&self, parameters: &[f64]) -> Vec<Formula> {
        self.pose_formulas(parameters)
    }

    fn singularity_measures(&self, parameters: &[f64], joints: &[f64]) -> Vec<f64> {
        self.jacobian_determinant(parameters, joints)
    }

    /// Solutions from a search, one of each family; empty for redundant arms, with more joints than
    /// a pose has degrees of freedom.
    fn all_joints(&self, parameters: &[f64], pose: &Pose) -> Vec<Vec<f64>> {
        let zero = vec![0.0; self.joints().len()];
        if zero.len() > 6 { Vec::new() } else { self.search(parameters, pose).all(&zero).joints }
    }

    fn solutions(&self, parameters: &[f64], pose: &Pose, near: &[f64]) -> Result<Vec<Vec<f64>>, Phrase> {
        self.search(parameters, pose).solutions(near)
    }

    fn nearest_joints(&self, parameters: &[f64], pose: &Pose, near: &[f64]) -> Result<Vec<f64>, Phrase> {
        self.search(parameters, pose).nearest(near)
    }

    fn free_joints(&self, parameters: &[f64], joints: &[f64]) -> Vec<usize> {
        Search::new(self, parameters, self.direct(parameters, joints)).free_joints(joints)
    }
}
