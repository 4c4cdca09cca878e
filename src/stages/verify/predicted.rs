//! Predicted positions of a target by identified parameters, with their covariance.

use crate::stages::verify::earlier_parameters::{other_nominal, parameters_from_document};
use etalon_base::error;
use etalon_base::message::Result;
use etalon_base::pose::Vector;
use etalon_campaign::RobotFile;
use etalon_documents::ParametersDocument;
use etalon_robots::Robot;

/// Predicted position of a target.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PredictedPosition {
    /// Position (mm) in the world; NaN where the robot cannot be there.
    pub position_mm: Vector,
    /// Covariance (mm²) by the identified parameters, without errors that the model leaves out;
    /// that of z is zero for planar robots.
    pub covariance_mm2: [[f64; 3]; 3],
}

/// A robot with a target and identified parameters.
pub struct Prediction {
    robot: Box<dyn Robot>,
    target: usize,
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
        let robot = file.build(&targets)?;
        let found = parameters_from_document(robot.as_ref(), document)?;
        if let Some(other) = other_nominal(robot.as_ref(), document) {
            return Err(other.into());
        }
        let index = robot.targets().iter().position(|name| name == target);
        let target = index.ok_or_else(|| error!("calibrated-targets-missing", names = [target]))?;
        Ok(Self { robot, target, values: found.values, free: found.free, covariance: found.covariance })
    }

    /// The robot.
    pub fn robot(&self) -> &dyn Robot {
        self.robot.as_ref()
    }

    /// Derivatives of the target's position with respect to all parameters (mm per mm or rad): three
    /// rows.
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
        let Self { robot, target, values, free, covariance } = self;
        let (d, n, m) = (robot.dimension(), values.len(), free.len());
        let mut full = vec![0.0; d * robot.targets().len() * n];
        robot.jacobian(values, joints, &mut full);
        let column = |i: usize, k: usize| if i < d { full[(target * d + i) * n + free[k]] } else { 0.0 };
        let covariance_mm2 = std::array::from_fn(|i| {
            let weighted = |l: usize| (0..m).map(|k| column(i, k) * covariance[k * m + l]).sum::<f64>();
            let row: Vec<f64> = (0..m).map(weighted).collect();
            std::array::from_fn(|j| row.iter().enumerate().map(|(l, by)| by * column(j, l)).sum())
        });
        PredictedPosition { position_mm: robot.position(values, joints, *target), covariance_mm2 }
    }
}
