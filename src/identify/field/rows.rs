//! Residuals of positions with their derivatives, and the linear fit of the parameters to a part of
//! the poses.

use super::{FEWEST_DEGREES, FEWEST_POSES};
use crate::{Identification, Observation};
use etalon_base::pose_name::PoseName;
use etalon_robots::{Quantity, Robot};
use nalgebra::{DMatrix, DVector};
use std::collections::BTreeMap;

/// Minimum diagonal of R, relative to the largest, of a regular fit.
const REGULAR: f64 = 1e-10;

/// Residuals of all positions.
pub(super) struct Rows {
    /// Poses with the indices of their rows.
    pub poses: Vec<(PoseName, Vec<usize>)>,
    /// Observation of each row.
    pub observation: Vec<usize>,
    /// Scaled joint values of each observation.
    pub joints: Vec<Vec<f64>>,
    /// Length (rad or mm) of one unit of each joint.
    pub scales: Vec<f64>,
    /// Measured minus predicted (mm).
    pub residuals: DVector<f64>,
    /// Derivatives by the free parameters.
    pub by_parameter: DMatrix<f64>,
    /// Derivatives by the joints.
    pub by_joint: DMatrix<f64>,
    /// Rows of nominal values: 1/s of each free parameter and the deviation (p₀ − p)/s; 0 without
    /// tolerance.
    nominal: Vec<[f64; 2]>,
    /// Standard deviation of a residual of the identification (mm).
    pub deviation_mm: f64,
    /// Indices of the free parameters.
    pub free: Vec<usize>,
    /// Number of all parameters of the robot.
    pub parameters: usize,
    /// Coordinates of a position.
    pub dimension: usize,
}

/// Linear fit of the parameters to some rows.
pub(super) struct Fit {
    /// Columns of the parameters that these rows determine.
    pub columns: Vec<usize>,
    /// Orthonormal basis of the columns: rows of the residuals, then of nominal values.
    basis: DMatrix<f64>,
    /// R⁻¹ of the QR decomposition.
    root: DMatrix<f64>,
    /// (XᵀX)⁻¹.
    pub inverse: DMatrix<f64>,
    /// Residuals after the fit; residuals of nominal values are at the end.
    pub residuals: DVector<f64>,
    /// Change of the parameters.
    pub change: DVector<f64>,
    /// Equations minus parameters.
    pub degrees: f64,
}

impl Rows {
    pub fn new(robot: &dyn Robot, observations: &[Observation], found: &Identification) -> Self {
        let (d, axes, all) = (robot.dimension(), robot.joints().len(), robot.parameters().len());
        let (free, values) = (found.free.clone(), &found.values);
        let count = d * robot.targets().len();
        let (mut by_parameter, mut by_joint) = (vec![0.0; count * all], vec![0.0; count * axes]);
        let (mut x, mut j, mut r, mut of) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        let mut poses: BTreeMap<PoseName, Vec<usize>> = BTreeMap::new();
        for (index, o) in observations.iter().enumerate() {
            robot.jacobian(values, &o.joints, &mut by_parameter);
            robot.joint_jacobian(values, &o.joints, &mut by_joint);
            for (target, miss) in o.misses(robot, values) {
                for (axis, miss) in miss.iter().enumerate().take(d) {
                    let row = target * d + axis;
                    x.extend(free.iter().map(|&k| by_parameter[row * all + k]));
                    j.extend_from_slice(&by_joint[row * axes..][..axes]);
                    poses.entry(o.pose).or_default().push(r.len());
                    r.push(*miss);
                    of.push(index);
                }
            }
        }
        let scales = scales(robot, observations);
        let scaled = |o: &Observation| scales.iter().zip(&o.joints).map(|(scale, q)| q / scale).collect();
        let nominal = |&k: &usize| match found.prior.uncertainty(robot, k) {
            Some(s) => [1.0 / s, (robot.parameters()[k].nominal - values[k]) / s],
            None => [0.0; 2],
        };
        let readings = found.residuals.count as f64;
        let deviation_mm = found.residuals.rms * (readings / found.residuals.degrees_of_freedom.max(1) as f64).sqrt();
        Self {
            deviation_mm: deviation_mm.max(f64::MIN_POSITIVE),
            poses: poses.into_iter().collect(),
            joints: observations.iter().map(scaled).collect(),
            by_parameter: DMatrix::from_row_slice(r.len(), free.len(), &x),
            by_joint: DMatrix::from_row_slice(r.len(), axes, &j),
            residuals: DVector::from_vec(r),
            nominal: free.iter().map(nominal).collect(),
            observation: of,
            parameters: all,
            dimension: d,
            scales,
            free,
        }
    }

    pub fn count(&self) -> usize {
        self.residuals.len()
    }

    /// Number of poses needed with as many readings a pose.
    pub fn poses_needed(&self) -> usize {
        let by_pose = self.count() as f64 / self.poses.len().max(1) as f64;
        let of_equations = ((self.free.len() + FEWEST_DEGREES) as f64 / by_pose.max(1.0)).ceil() as usize;
        // a fifth of the poses is held out
        FEWEST_POSES.max((1.25 * of_equations as f64).ceil() as usize)
    }

    /// Scaled range of a joint in the observations.
    pub fn range(&self, joint: usize) -> [f64; 2] {
        let end = |pick: fn(f64, f64) -> f64| self.joints.iter().map(|q| q[joint]).reduce(pick).unwrap_or(0.0);
        [end(f64::min), end(f64::max)]
    }

    /// Joint values of an observation (rad or mm).
    pub fn unscaled(&self, observation: usize) -> Vec<f64> {
        self.joints[observation].iter().zip(&self.scales).map(|(q, scale)| q * scale).collect()
    }

    /// Functions of one component at some rows: derivative by its joint times each function at the
    /// observation.
    pub fn columns(&self, joint: usize, functions: &DMatrix<f64>, some: &[usize]) -> DMatrix<f64> {
        let of = |i: usize, k: usize| self.by_joint[(some[i], joint)] * functions[(self.observation[some[i]], k)];
        DMatrix::from_fn(some.len(), functions.ncols(), of)
    }

    /// Fits the parameters linearly to some rows. Nominal values are weighted relative to residuals
    /// with the standard deviation `deviation_mm`. `None` if the equations are singular.
    pub fn fit(&self, some: &[usize], deviation_mm: f64) -> Option<Fit> {
        let count = some.len();
        let x = DMatrix::from_fn(count, self.free.len(), |i, k| self.by_parameter[(some[i], k)]);
        let columns: Vec<usize> = (0..self.free.len()).filter(|&k| x.column(k).amax() > 0.0).collect();
        let n = columns.len();
        let with_prior: Vec<usize> = columns.iter().copied().filter(|&k| self.nominal[k][0] > 0.0).collect();
        let total = count + with_prior.len();
        let mut all = DMatrix::zeros(total, n);
        let mut r = DVector::zeros(total);
        some.iter().enumerate().for_each(|(i, &row)| r[i] = self.residuals[row]);
        for (k, &column) in columns.iter().enumerate() {
            all.view_mut((0, k), (count, 1)).copy_from(&x.column(column));
            if let Some(row) = with_prior.iter().position(|&c| c == column) {
                [all[(count + row, k)], r[count + row]] = self.nominal[column].map(|v| deviation_mm * v);
            }
        }
        let norms: Vec<f64> = (0..n).map(|k| all.column(k).norm()).collect();
        (0..n).for_each(|k| all.column_mut(k).unscale_mut(norms[k]));
        if total <= n {
            return None;
        }
        let qr = all.qr();
        let (basis, upper) = (qr.q(), qr.r());
        let diagonal = || upper.diagonal().iter().map(|v| v.abs()).collect::<Vec<f64>>();
        let largest = diagonal().into_iter().fold(0.0, f64::max);
        if diagonal().into_iter().any(|v| v <= REGULAR * largest) {
            return None;
        }
        let mut root = upper.solve_upper_triangular(&DMatrix::identity(n, n))?;
        (0..n).for_each(|k| root.row_mut(k).unscale_mut(norms[k]));
        let parts = basis.tr_mul(&r);
        let residuals = &r - &basis * &parts;
        Some(Fit {
            change: &root * parts,
            inverse: &root * root.transpose(),
            degrees: (total - n) as f64,
            columns,
            basis,
            root,
            residuals,
        })
    }
}

impl Fit {
    /// Columns without what the parameters take up, with rows of nominal values at the end, and the
    /// parameters' change for each column.
    pub fn project(&self, columns: &DMatrix<f64>) -> (DMatrix<f64>, DMatrix<f64>) {
        let (some, total) = (columns.nrows(), self.basis.nrows());
        let parts = self.basis.rows(0, some).tr_mul(columns);
        let mut left = DMatrix::zeros(total, columns.ncols());
        left.rows_mut(0, some).copy_from(columns);
        left.gemm(-1.0, &self.basis, &parts, 1.0);
        (left, &self.root * parts)
    }
}

/// Length (rad or mm) of one unit of each joint: 1 rad, or half the range of a prismatic joint.
fn scales(robot: &dyn Robot, observations: &[Observation]) -> Vec<f64> {
    let scale = |(k, joint): (usize, &etalon_robots::Joint)| {
        let end = |pick: fn(f64, f64) -> f64| observations.iter().map(|o| o.joints[k]).reduce(pick).unwrap_or(0.0);
        let half = 0.5 * (end(f64::max) - end(f64::min));
        if joint.quantity == Quantity::Length && half > 0.0 { half } else { 1.0 }
    };
    robot.joints().iter().enumerate().map(scale).collect()
}
