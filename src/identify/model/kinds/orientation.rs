//! Orientation of the body that carries the target, in the world or as another station measures it.

use super::{At, Condition, Equation, Kind, point, station_pose};
use etalon_base::pose::{Pose, Vector, norm, turning_axes};
use etalon_fit::rotation_onto;
use etalon_robots::{FreeBase, Robot};
use nalgebra::{Matrix3, Vector3};
use std::collections::BTreeMap;

/// Orientation of the body that carries the target; three parameters are the rotation vector that
/// turns the flange to the body. Residuals: the rotation vector from the observed orientation to
/// the model's, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Orientation {
    /// The body in the frame of the measurement, by its rotation alone.
    pub frame_T_body: Pose,
    /// First of the six parameters of the station whose frame is the frame of the measurement;
    /// `None` for the world.
    pub station: Option<usize>,
    /// First parameter of the rotation vector.
    pub mounting: usize,
}

impl Orientation {
    /// The observed body in the world, by its rotation alone.
    fn world_T_body(&self, values: &[f64]) -> Pose {
        self.station.map_or(self.frame_T_body, |station| station_pose(values, station).then(&self.frame_T_body))
    }
}

impl Equation for Orientation {
    fn rows(&self) -> usize {
        3
    }

    fn unknowns(&self) -> Vec<usize> {
        let station = self.station.into_iter().flat_map(|first| first..first + 6);
        (self.mounting..self.mounting + 3).chain(station).collect()
    }

    fn residuals(&self, at: &At, out: &mut [f64]) {
        let turned = at.arm.map(|arm| {
            let mounted = Pose::from_rotation_vector(point(at.values, self.mounting));
            let body = arm.flange(at.values, at.joints, at.target).then(&mounted);
            body.then(&self.world_T_body(at.values).inverse()).rotation_vector_rad()
        });
        out.copy_from_slice(&turned.unwrap_or_default());
    }

    fn jacobian(&self, at: &At, _: &[f64], out: &mut [f64]) {
        let Some(arm) = at.arm else { return };
        let (n, mounting) = (at.values.len(), self.mounting);
        let mut left = [0.0; 3];
        self.residuals(at, &mut left);
        let axes = turning_axes(left.map(|v| v / at.standard_uncertainty * at.standard_uncertainty));
        let back = Matrix3::from_fn(|i, k| axes[k][i]).try_inverse().unwrap_or_else(Matrix3::identity);
        let mut turns = vec![0.0; 3 * n];
        arm.flange_turns(at.values, at.joints, at.target, &mut turns);
        let flange = arm.flange(at.values, at.joints, at.target);
        for (k, axis) in turning_axes(point(at.values, mounting)).into_iter().enumerate() {
            let axis = flange.rotate(axis);
            (0..3).for_each(|i| turns[i * n + mounting + k] += axis[i]);
        }
        if let Some(station) = self.station {
            // model · observed⁻¹ turns against the station: its axes, turned by the residual
            let left = Pose::from_rotation_vector(left);
            for (k, axis) in turning_axes(point(at.values, station + 3)).into_iter().enumerate() {
                let axis = left.rotate(axis);
                (0..3).for_each(|i| turns[i * n + station + 3 + k] -= axis[i]);
            }
        }
        for j in 0..n {
            let turn = back * Vector3::new(turns[j], turns[n + j], turns[2 * n + j]);
            (0..3).for_each(|i| out[i * n + j] = turn[i]);
        }
    }

    fn is_angle(&self) -> bool {
        true
    }

    fn is_in_world(&self) -> bool {
        self.station.is_none()
    }

    fn depends_on_target(&self) -> bool {
        false
    }

    fn moving(&self, _: usize) -> Option<usize> {
        Some(self.mounting)
    }
}

/// Orientations of bodies on the flange: the mean from their observed orientations.
pub(crate) fn mount(arm: &dyn FreeBase, conditions: &[Condition], wanted: &[usize], values: &mut [f64]) {
    let mut bodies: BTreeMap<usize, Vec<(Vector, Vector)>> = BTreeMap::new();
    for c in conditions {
        if let Kind::Orientation(observed) = c.kind {
            let body = arm.flange(values, &c.joints, c.target).inverse().then(&observed.world_T_body(values));
            let axes = (0..3).map(|k| (Pose::identity().axis(k), body.axis(k)));
            bodies.entry(observed.mounting).or_default().extend(axes);
        }
    }
    for (mounting, all) in bodies.into_iter().filter(|body| wanted.contains(&body.0)) {
        // the least sum of squares of the chordal distances (Moakher 2002)
        let mean = Pose { rotation: rotation_onto(all.into_iter()), translation_mm: [0.0; 3] };
        values[mounting..mounting + 3].copy_from_slice(&mean.rotation_vector_rad());
    }
}

/// Root mean square angle (rad) between observed orientations and the orientations of the robot
/// with `values`, for the best mounting of the bodies; not a number without orientations.
pub fn mounted_misfit_rad(robot: &dyn Robot, conditions: &[Condition], values: &[f64]) -> f64 {
    let misfits = mounted_misfits_rad(robot, conditions, values);
    (misfits.iter().map(|angle| angle * angle).sum::<f64>() / misfits.len() as f64).sqrt()
}

/// Angles (rad) between observed orientations and the orientations of the robot with `values`, for
/// the best mounting of the bodies.
pub fn mounted_misfits_rad(robot: &dyn Robot, conditions: &[Condition], values: &[f64]) -> Vec<f64> {
    let Some(arm) = robot.free_base() else { return Vec::new() };
    let mut values = values.to_vec();
    let all: Vec<usize> = (0..values.len()).collect();
    mount(arm, conditions, &all, &mut values);
    conditions.iter().map(|c| norm(c.error(robot, &values))).collect()
}
