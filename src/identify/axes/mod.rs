//! Axes of joints from sweeps of one joint at a time, and a robot without a nominal model
//! (circle-point analysis: Mooring, Roth and Driels, Fundamentals of manipulator calibration, 1991,
//! chapter 4).
//!
//! Each sweep gives one axis by geometry alone: joint values set the sign and the zero of a joint,
//! they do not bend its circle. Axes are then moved to joint values zero, where they describe the
//! arm as a product of exponentials.

mod checks;
mod derived;
mod motion;
mod noise;
mod smooth;
mod sweep;
mod table;
#[cfg(test)]
mod tests;

pub use checks::{Agreement, Change, CheckedPose, Slip, axis_slip, compared, joint_slip, start_gap};
pub use derived::{AxesModel, BaseRule, Predicted};
pub use motion::{ErrorMotion, Travel};
pub use noise::{ByNoise, NoiseMotion};
pub use smooth::Smooth;
pub use sweep::{Path, SweepFault, SweepFit, fit_sweep};
pub use table::DerivedParameters;

use etalon_base::angle::Turn;
use etalon_base::pose::Vector;
use nalgebra::DMatrix;

/// Position of a target in a sweep.
#[derive(Clone, Debug, PartialEq)]
pub struct SweepReading {
    /// Number of the row in its table.
    pub row: usize,
    /// Index of the target.
    pub target: usize,
    /// Position in the frame of the measuring system (mm).
    pub position_mm: Vector,
    /// Values of all joints (rad or mm); empty if they are unknown.
    pub joints: Vec<f64>,
}

/// Readings while one joint moves.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sweep {
    /// Index of the joint.
    pub joint: usize,
    /// Readings in the order of the motion.
    pub readings: Vec<SweepReading>,
}

impl Sweep {
    /// Removes the jumps of a controller that wraps angles from the values of the joints `turning`:
    /// from reading to reading they turn by less than half a turn. Joints that wind keep their
    /// turns.
    pub fn unwind(&mut self, turning: &[usize]) {
        for &joint in turning {
            let values: Option<Vec<f64>> = self.readings.iter().map(|r| r.joints.get(joint).copied()).collect();
            let Some(values) = values.filter(|values| !Turn::RADIANS.winds(values)) else { continue };
            let unwound = Turn::RADIANS.followed(&values);
            self.readings.iter_mut().zip(unwound).for_each(|(r, value)| r.joints[joint] = value);
        }
    }
}

/// Statements about joints and readings in addition to the sweeps.
#[derive(Clone, Debug, Default)]
pub struct AxesSettings {
    /// Standard uncertainty of a coordinate (mm); by default from the residuals of each sweep.
    pub standard_uncertainty_mm: Option<f64>,
    /// Prismatic or revolute, for each joint; `None` to judge by the path.
    pub prismatic: Vec<Option<bool>>,
    /// `true` for joints that were swept in the negative direction; without joint values only.
    pub backwards: Vec<bool>,
}

/// Axis of a joint by its sweep.
#[derive(Clone, Debug)]
pub struct JointAxis {
    /// Index of the joint.
    pub joint: usize,
    /// Fit of its paths; z is the positive direction.
    pub fit: SweepFit,
    /// Standard uncertainty of a coordinate (mm).
    pub standard_uncertainty_mm: f64,
    /// Degrees of freedom of the standard deviation; infinite if it is given.
    pub degrees_of_freedom: f64,
    /// Angle (rad) or position (mm) of each path at joint value zero; without joint values, at the
    /// first reading.
    pub phases: Vec<f64>,
    /// Covariance of the parameters of [`SweepFit::cofactors`], followed by the phases.
    pub covariance: DMatrix<f64>,
    /// Values of all joints, the mean of the sweep; empty if they are unknown.
    pub rest: Vec<f64>,
    /// Comparison of the motion with the joint values, if they are known.
    pub travel: Option<Travel>,
    /// Error motions of the axis.
    pub error_motion: ErrorMotion,
    /// Smooth deviations of the paths, such as run-out, if the readings show them.
    pub smooth: Option<Smooth>,
}

impl JointAxis {
    /// Standard uncertainties of the direction about x and y (rad), and of the point along x and y
    /// (mm; zero for a prismatic joint), in the frame of the fit.
    pub fn standard_uncertainties(&self) -> ([f64; 2], [f64; 2]) {
        let u = |k: usize| self.covariance[(k, k)].max(0.0).sqrt();
        ([u(0), u(1)], if self.fit.prismatic { [0.0; 2] } else { [u(2), u(3)] })
    }

    /// Standard uncertainty of the radius of a path (mm).
    pub fn radius_uncertainty_mm(&self, path: usize) -> f64 {
        let k = self.fit.axis_parameter_count() + 2 * path;
        if self.fit.prismatic { 0.0 } else { self.covariance[(k, k)].max(0.0).sqrt() }
    }

    /// Covariance of point (mm) and direction of the axis, 6 × 6.
    pub fn point_direction_covariance(&self) -> [[f64; 6]; 6] {
        let [x, y] = [self.fit.frame.axis(0), self.fit.frame.axis(1)];
        let n = self.fit.axis_parameter_count();
        let mut jacobian = DMatrix::zeros(6, n);
        for i in 0..3 {
            jacobian[(3 + i, 0)] = x[i];
            jacobian[(3 + i, 1)] = y[i];
            if n == 4 {
                jacobian[(i, 2)] = x[i];
                jacobian[(i, 3)] = y[i];
            }
        }
        let own = self.covariance.view((0, 0), (n, n));
        let all = &jacobian * own * jacobian.transpose();
        std::array::from_fn(|i| std::array::from_fn(|j| all[(i, j)]))
    }
}

/// Axis of the joint of a sweep.
///
/// # Errors
/// Fails with too few readings, and if the paths do not determine an axis.
pub fn joint_axis(sweep: &Sweep, settings: &AxesSettings) -> Result<JointAxis, SweepFault> {
    let stated = settings.prismatic.get(sweep.joint).copied().flatten();
    let mut fit = match stated {
        Some(prismatic) => fit_sweep(&sweep.readings, prismatic)?,
        None => sweep::fit_any(&sweep.readings)?,
    };
    let backwards = settings.backwards.get(sweep.joint).copied().unwrap_or_default();
    if motion::is_reversed(sweep, &fit) != (backwards && sweep.readings.iter().all(|r| r.joints.is_empty())) {
        fit.reverse();
    }
    // the given uncertainty if chi-square agrees, otherwise the uncertainty from the residuals
    let own = (fit.deviation_mm, fit.degrees_of_freedom as f64);
    let (u, mut degrees_of_freedom) = match settings.standard_uncertainty_mm {
        None => own,
        Some(u) if fit.degrees_of_freedom == 0 => (u, f64::INFINITY),
        Some(u) if crate::chi_square_exceeds((own.0 / u).powi(2) * own.1, fit.degrees_of_freedom) => own,
        Some(u) => (u, f64::INFINITY),
    };
    let mut covariance = &fit.cofactors * (u * u);
    let (mut deviations, mut noise_mm) = (None, settings.standard_uncertainty_mm.unwrap_or(fit.deviation_mm));
    if let Some(smooth) = smooth::smooth_fit(sweep, &fit, settings.standard_uncertainty_mm) {
        (fit, covariance) = (smooth.fit, smooth.covariance);
        degrees_of_freedom = smooth.deviations.degrees_of_freedom();
        deviations = smooth.deviations.reported(&fit);
        // error motions are judged by noise alone
        noise_mm = settings.standard_uncertainty_mm.or(deviations.map(|d| d.noise_mm)).unwrap_or(noise_mm);
    }
    let travel = motion::travel(sweep, &fit, u, &covariance);
    let (phases, covariance) = motion::phases(sweep, &fit, u, &covariance);
    let known = sweep.readings.first().map_or(0, |r| r.joints.len());
    let mean = |j: usize| {
        sweep.readings.iter().filter_map(|r| r.joints.get(j)).sum::<f64>() / sweep.readings.len().max(1) as f64
    };
    Ok(JointAxis {
        joint: sweep.joint,
        standard_uncertainty_mm: u,
        degrees_of_freedom,
        phases,
        covariance,
        rest: (0..known).map(mean).collect(),
        travel,
        error_motion: motion::error_motion(sweep, &fit, noise_mm),
        smooth: deviations,
        fit,
    })
}
