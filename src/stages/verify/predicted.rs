//! Predicted positions of a target by identified parameters, with their covariance.

use crate::stages::verify::earlier_parameters::{other_nominal, parameters_from_document};
use etalon_base::error;
use etalon_base::message::Result;
use etalon_base::pose::{Pose, Vector, turning_axes};
use etalon_campaign::RobotFile;
use etalon_documents::ParametersDocument;
use etalon_identify::Fixture;
use etalon_robots::Robot;
use nalgebra::{Cholesky, DMatrix, DVector};

/// Predicted position of a target.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PredictedPosition {
    /// Position (mm) in the world; NaN where the robot cannot be there.
    pub position_mm: Vector,
    /// Covariance (mm²) by the identified parameters, without errors that the model leaves out; it
    /// is zero for z of planar robots.
    pub covariance_mm2: [[f64; 3]; 3],
}

/// Predicted orientation of the body that carries a target.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PredictedOrientation {
    /// The body in the world, by its rotation alone.
    pub world_T_body: Pose,
    /// Covariance (rad²) of a small rotation about the axes of the world, by the identified
    /// parameters.
    pub covariance_rad2: [[f64; 3]; 3],
}

/// A robot with a target and identified parameters.
pub struct Prediction {
    robot: Box<dyn Robot>,
    target: usize,
    /// First parameter of the rotation vector from the flange to the body of the target, if the
    /// calibration observed orientations.
    mounting: Option<usize>,
    values: Vec<f64>,
    free: Vec<usize>,
    covariance: Vec<f64>,
}

impl Prediction {
    /// The robot of a file with the parameters of a document.
    ///
    /// # Errors
    /// Fails with parameters of another robot, and without this target among them.
    pub fn new(file: &RobotFile, document: &ParametersDocument, target: &str) -> Result<Self> {
        let mut targets = file.targets_or(target);
        if !targets.iter().any(|name| name == target) {
            targets.push(target.to_owned());
        }
        let mut robot = file.build(&targets)?;
        let turned = format!("{target}_rx");
        let is_mounted = document.parameters.iter().any(|entry| entry.name == turned);
        let mounting = is_mounted.then(|| Fixture::Mounting(target).add_to(robot.as_mut()));
        let found = parameters_from_document(robot.as_ref(), document)?;
        if let Some(other) = other_nominal(robot.as_ref(), document) {
            return Err(other.into());
        }
        let index = robot.targets().iter().position(|name| name == target);
        let target = index.ok_or_else(|| error!("calibrated-targets-missing", names = [target]))?;
        Ok(Self { robot, target, mounting, values: found.values, free: found.free, covariance: found.covariance })
    }

    /// Prediction with readings of `factor` times the stated variance: C = (C₀⁻¹ − P) / factor + P,
    /// inverted, where P is the information of the tolerances. Unchanged if `factor` is 1, or if
    /// the covariance is singular.
    pub fn with_variance_factor(mut self, document: &ParametersDocument, factor: f64) -> Self {
        let n = self.free.len();
        let tolerance = |k: &usize| {
            let name = &self.robot.parameters()[*k].name;
            let entry = document.parameters.iter().find(|entry| entry.name == *name)?;
            let u = self.robot.parameters()[*k].quantity.inward(entry.standard_uncertainty?);
            Some((1.0 - entry.determined?).max(0.0) / u.powi(2)).filter(|information| information.is_finite())
        };
        let prior = DVector::from_iterator(n, self.free.iter().map(|k| tolerance(k).unwrap_or(0.0)));
        let prior = DMatrix::from_diagonal(&prior);
        let followed = || {
            let all = Cholesky::new(DMatrix::from_row_slice(n, n, &self.covariance))?.inverse();
            Some(Cholesky::new((all - &prior) / factor + &prior)?.inverse())
        };
        if let Some(covariance) = (factor != 1.0).then(followed).flatten() {
            self.covariance = covariance.as_slice().to_vec();
        }
        self
    }

    /// The robot.
    pub fn robot(&self) -> &dyn Robot {
        self.robot.as_ref()
    }

    /// Derivatives of the target's position with respect to all parameters (mm per mm or rad):
    /// three rows.
    pub fn sensitivity(&self, joints: &[f64]) -> Vec<f64> {
        let Self { robot, target, values, .. } = self;
        let (d, n) = (robot.dimension(), values.len());
        let mut full = vec![0.0; d * robot.targets().len() * n];
        robot.jacobian(values, joints, &mut full);
        let mut rows = full[target * d * n..(target + 1) * d * n].to_vec();
        rows.resize(3 * n, 0.0);
        rows
    }

    /// Position at joint values (rad, mm), and its covariance J C Jᵀ (GUM 5.2.2).
    pub fn at(&self, joints: &[f64]) -> PredictedPosition {
        let Self { robot, target, values, .. } = self;
        let (d, n) = (robot.dimension(), values.len());
        let mut full = vec![0.0; d * robot.targets().len() * n];
        robot.jacobian(values, joints, &mut full);
        let rows = &full[target * d * n..][..d * n];
        PredictedPosition {
            position_mm: robot.position(values, joints, *target),
            covariance_mm2: self.propagated(rows),
        }
    }

    /// Orientation of the body that carries the target at joint values (rad, mm), and its
    /// covariance J C Jᵀ; `None` if the calibration observed no orientation of the body.
    pub fn orientation_at(&self, joints: &[f64]) -> Option<PredictedOrientation> {
        let Self { robot, target, values, .. } = self;
        let (arm, mounting) = (robot.free_base()?, self.mounting?);
        let n = values.len();
        let flange = arm.flange(values, joints, *target);
        let mounted = [0, 1, 2].map(|k| values[mounting + k]);
        let mut turns = vec![0.0; 3 * n];
        arm.flange_turns(values, joints, *target, &mut turns);
        for (k, axis) in turning_axes(mounted).into_iter().enumerate() {
            let axis = flange.rotate(axis);
            (0..3).for_each(|i| turns[i * n + mounting + k] += axis[i]);
        }
        let body = flange.then(&Pose::from_rotation_vector(mounted));
        let world_T_body = Pose { translation_mm: [0.0; 3], ..body };
        Some(PredictedOrientation { world_T_body, covariance_rad2: self.propagated(&turns) })
    }

    /// Covariance J C Jᵀ (GUM 5.2.2) from rows of derivatives with respect to all parameters; zero
    /// for missing rows.
    fn propagated(&self, rows: &[f64]) -> [[f64; 3]; 3] {
        let Self { values, free, covariance, .. } = self;
        let (n, m) = (values.len(), free.len());
        let column = |i: usize, k: usize| rows.get(i * n + free[k]).copied().unwrap_or(0.0);
        std::array::from_fn(|i| {
            let weighted = |l: usize| (0..m).map(|k| column(i, k) * covariance[k * m + l]).sum::<f64>();
            let row: Vec<f64> = (0..m).map(weighted).collect();
            std::array::from_fn(|j| row.iter().enumerate().map(|(l, by)| by * column(j, l)).sum())
        })
    }
}
