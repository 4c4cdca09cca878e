//! Derivatives of residuals with respect to quantities other than the parameters: joint values,
//! frames, and the scale of the measured lengths.

use super::Residuals;
use crate::model::kinds::Condition;
use etalon_base::pose::{Pose, Vector};
use etalon_base::pose_name::PoseName;
use etalon_math::Problem;
use etalon_robots::base_pose;

/// Step (mm or rad) of differences with respect to joint values and to the pose of the base.
const STEP: f64 = 1e-5;

impl Residuals<'_> {
    /// For pose residuals: sensitivity of each residual to the coordinates of both targets, three
    /// rows of four per pose.
    pub fn target_sensitivities(&self, x: &[f64]) -> Option<Vec<[[f64; 4]; 3]>> {
        self.coordinates.target_sensitivities(&self.all(x))
    }

    /// Derivatives of the predicted values with respect to the joint values at `x`, whitened like
    /// the residuals: rows of all joints. Derivatives of conditions are central differences.
    pub fn joint_jacobian(&self, x: &[f64]) -> Vec<f64> {
        let (all, dimension) = (self.all(x), self.robot.dimension());
        let n = self.robot.joints().len();
        let mut rows = Vec::with_capacity(self.residual_count() * n);
        let mut at = vec![0.0; dimension * self.robot.targets().len()];
        let mut full = vec![0.0; at.len() * n];
        let robot = self.robot.parametrised(&all);
        for (o, state) in self.coordinates.observed(0..self.coordinates.observations.len()) {
            robot.joint_jacobian(state, &mut at, &mut full);
            for (here, _) in full.chunks_exact(dimension * n).zip(&o.targets).filter(|(_, at)| at.is_some()) {
                rows.extend(here.iter().map(|v| v / self.unit));
            }
        }
        self.whiten(&mut rows, n);
        let moved = |c: &Condition, j: usize, by: f64| {
            let mut moved = c.clone();
            moved.joints[j] += by;
            let position = self.robot.position(&all, &moved.joints, c.target);
            let mut r = vec![0.0; c.kind.rows()];
            moved.residuals(&moved.at(self.robot.free_base(), &all, position), &mut r);
            r
        };
        self.conditions.items.iter().for_each(|c| rows.extend(differences(c, n, |j, by| moved(c, j, by))));
        rows
    }

    /// Derivatives of the predicted values at `x`, whitened like the residuals, with respect to a
    /// small shift (mm) and rotation (rad) of the robot's base about the origin of the world: rows
    /// of six. Points and surfaces that are fixed in the world stay. Derivatives of conditions are
    /// central differences.
    pub fn base_jacobian(&self, x: &[f64]) -> Vec<f64> {
        let (all, arm) = (self.all(x), self.robot.free_base());
        let moved = |c: &Condition, axis: usize, by: f64| {
            let along = |first: usize| std::array::from_fn(|i| if axis == first + i { by } else { 0.0 });
            let motion = Pose { translation_mm: along(0), ..Pose::from_rotation_vector(along(3)) };
            let mut values = all.clone();
            if arm.is_some() {
                let base = motion.then(&base_pose(&all));
                values[..3].copy_from_slice(&base.translation_mm);
                values[3..6].copy_from_slice(&base.rotation_vector_rad());
            }
            let position = motion.apply(self.robot.position(&all, &c.joints, c.target));
            let mut r = vec![0.0; c.kind.rows()];
            c.residuals(&c.at(arm, &values, position), &mut r);
            r
        };
        let mut rows = self.shifted_and_turned(x, None);
        self.conditions.items.iter().for_each(|c| rows.extend(differences(c, 6, |axis, by| moved(c, axis, by))));
        rows
    }

    /// Derivatives of the residuals of coordinates at `x`, whitened, with respect to a small shift
    /// (mm) and rotation (rad) of the frame of the observations of `pose` and cycle, or of all:
    /// rows of six.
    fn shifted_and_turned(&self, x: &[f64], pose: Option<(PoseName, i64)>) -> Vec<f64> {
        // a point p of a frame that shifts by t and turns by w is measured t + w × p less
        self.displaced::<6>(x, pose, |p| {
            let lever = [[0.0, p[2], -p[1]], [-p[2], 0.0, p[0]], [p[1], -p[0], 0.0]];
            let axis =
                |i: usize| std::array::from_fn(|c| if c < 3 { f64::from(u8::from(c == i)) } else { lever[i][c - 3] });
            [0, 1, 2].map(axis)
        })
    }

    /// Derivatives of the residuals at `x`, whitened, with respect to a small shift (mm) and
    /// rotation (rad) of the frame of the observations of `pose` and cycle, or of all: rows of six.
    pub fn frame_jacobian(&self, x: &[f64], pose: Option<(PoseName, i64)>) -> Vec<f64> {
        let mut rows = self.shifted_and_turned(x, pose);
        for c in self.conditions.items {
            // an orientation that turns by w is observed w less; other conditions are met in the
            // robot's own world, or in the frame of a station that is identified
            let turned = c.kind.is_world_orientation() && pose.is_none_or(|key| key == (c.pose, c.cycle));
            let one = if turned { 1.0 / c.standard_uncertainty } else { 0.0 };
            let row = |i: usize| (0..6).map(move |k| if k == 3 + i { one } else { 0.0 });
            rows.extend((0..c.kind.rows()).flat_map(row));
        }
        rows
    }

    /// Derivatives of the residuals of coordinates at `x`, whitened, with respect to a common
    /// relative error of all measured lengths.
    pub fn scale_jacobian(&self, x: &[f64]) -> Vec<f64> {
        let mut rows = self.displaced(x, None, |p| p.map(|v| [-v]));
        let all = self.all(x);
        for c in self.conditions.items {
            let change = c.kind.equation().by_scale(&all);
            rows.extend(change[..c.kind.rows()].iter().map(|v| v / c.standard_uncertainty));
        }
        rows
    }

    /// Derivatives of the residuals of coordinates at `x`, whitened, with respect to N errors that
    /// change a point of `pose` and cycle, or of all, by `moved`: rows of N.
    fn displaced<const N: usize>(
        &self,
        x: &[f64],
        pose: Option<(PoseName, i64)>,
        moved: impl Fn(&Vector) -> [[f64; N]; 3],
    ) -> Vec<f64> {
        let sensitivities = self.target_sensitivities(x);
        let mut poses = sensitivities.iter().flatten();
        let mut rows: Vec<f64> = Vec::with_capacity(N * self.residual_count());
        for o in self.coordinates.observations {
            let placed = pose.is_none_or(|key| key == (o.pose, o.cycle));
            let moved = |p: &Vector| if placed { moved(p) } else { [[0.0; N]; 3] };
            match self.coordinates.platform {
                Some(_) => {
                    let [Some(k), Some(l)] = &o.targets[..] else { continue };
                    let coordinates = [moved(k)[0], moved(k)[1], moved(l)[0], moved(l)[1]];
                    let Some(sensitivity) = poses.next() else { continue };
                    for row in sensitivity {
                        rows.extend((0..N).map(|c| -(0..4).map(|i| row[i] * coordinates[i][c]).sum::<f64>()));
                    }
                }
                None => {
                    for measured in o.targets.iter().flatten() {
                        let axes = moved(measured);
                        rows.extend(axes[..self.robot.dimension()].iter().flatten().map(|v| v / self.unit));
                    }
                }
            }
        }
        self.whiten(&mut rows, N);
        rows
    }
}

/// Central differences of the residuals of a condition with respect to `n` quantities: rows of `n`.
fn differences(c: &Condition, n: usize, moved: impl Fn(usize, f64) -> Vec<f64>) -> Vec<f64> {
    let mut rows = vec![0.0; c.kind.rows() * n];
    for k in 0..n {
        let (ahead, behind) = (moved(k, STEP), moved(k, -STEP));
        for (i, (a, b)) in ahead.iter().zip(&behind).enumerate() {
            rows[i * n + k] = (a - b) / (2.0 * STEP);
        }
    }
    rows
}
