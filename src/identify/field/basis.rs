//! Inducing points and covariance functions of a component.

use super::rows::Rows;
use super::{Component, FADE, FieldInput};
use nalgebra::{DMatrix, DVector};

/// Relative variance added to inducing points against rounding.
const JITTER: f64 = 1e-6;
/// Distance of neighbouring inducing points, relative to the radius.
const SPACING: f64 = 1.0 / 3.0;
/// Minimum number of intervals between inducing points along a joint.
const FEWEST_INTERVALS: f64 = 3.0;
/// Maximum number of inducing points of a component.
const MOST_CENTRES: usize = 40;

/// Wendland's function φ₃,₁(d) = (1 − d)⁴ (4 d + 1), 0 from d = 1; positive definite in up to three
/// dimensions (Wendland 1995).
pub(super) fn wendland(d: f64) -> f64 {
    if d >= 1.0 { 0.0 } else { (1.0 - d).powi(4) * (4.0 * d + 1.0) }
}

/// Cubic from 1 at d = 0 to 0 at d = 1, level at both ends.
pub(super) fn faded(d: f64) -> f64 {
    if d >= 1.0 { 0.0 } else { (1.0 - d).powi(2) * (1.0 + 2.0 * d) }
}

/// A component without weights; joint values are scaled.
#[derive(Clone, Debug)]
pub(super) struct Basis {
    /// Index of the joint that is off.
    pub joint: usize,
    /// Indices of the joints on which the error depends.
    pub inputs: Vec<usize>,
    radius: f64,
    centres: Vec<Vec<f64>>,
    /// Lower triangular root L of the correlations of the inducing points.
    root: DMatrix<f64>,
}

impl Basis {
    pub fn new(joint: usize, inputs: Vec<usize>, radius: f64, centres: Vec<Vec<f64>>) -> Self {
        let distance = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
        let count = centres.len();
        let of = |i: usize, j: usize| {
            wendland(distance(&centres[i], &centres[j]) / radius) + if i == j { JITTER } else { 0.0 }
        };
        let root = DMatrix::from_fn(count, count, of).cholesky().map(|root| root.unpack());
        let root = root.unwrap_or_else(|| DMatrix::identity(count, count));
        Self { joint, inputs, radius, centres, root }
    }

    /// Inducing points on a grid over the poses, each with a pose nearby; `None` if they are too
    /// many or too few.
    pub fn on_poses(rows: &Rows, joint: usize, inputs: Vec<usize>, radius: f64) -> Option<Self> {
        let step = SPACING * radius;
        let along = |&k: &usize| -> Vec<f64> {
            let [low, high] = rows.range(k);
            let count = ((high - low) / step).ceil().max(FEWEST_INTERVALS);
            (0..=count as usize).map(|i| low + (high - low) * i as f64 / count).collect()
        };
        let mut grid: Vec<Vec<f64>> = vec![Vec::new()];
        for values in inputs.iter().map(along) {
            grid = grid.iter().flat_map(|at| values.iter().map(move |v| [&at[..], &[*v]].concat())).collect();
            if grid.len() > 4 * MOST_CENTRES {
                return None;
            }
        }
        let near = |at: &Vec<f64>| {
            let distance = |o: &Vec<f64>| inputs.iter().zip(at).map(|(&k, a)| (o[k] - a).powi(2)).sum::<f64>().sqrt();
            rows.joints.iter().any(|o| distance(o) <= 1.5 * step)
        };
        grid.retain(near);
        (2..=MOST_CENTRES).contains(&grid.len()).then(|| Self::new(joint, inputs, radius, grid))
    }

    pub fn len(&self) -> usize {
        self.centres.len()
    }

    /// Covariances relative to the prior variance between scaled joint values and each centre.
    pub fn covariances(&self, at: &[f64]) -> Vec<f64> {
        let distance = |c: &Vec<f64>| c.iter().zip(at).map(|(c, q)| (c - q).powi(2)).sum::<f64>().sqrt();
        self.centres.iter().map(|c| wendland(distance(c) / self.radius)).collect()
    }

    /// Functions of independent weights with the prior variance: L⁻¹ k.
    pub fn independent(&self, covariances: &[f64]) -> DVector<f64> {
        let k = DVector::from_column_slice(covariances);
        self.root.solve_lower_triangular(&k).unwrap_or_else(|| DVector::zeros(covariances.len()))
    }

    /// Functions of independent weights at every observation, one row each.
    pub fn at_observations(&self, rows: &Rows) -> DMatrix<f64> {
        let of = |o: &Vec<f64>| self.covariances(&self.inputs.iter().map(|&k| o[k]).collect::<Vec<_>>());
        let all: Vec<f64> = rows.joints.iter().flat_map(of).collect();
        let all = DMatrix::from_column_slice(self.len(), rows.joints.len(), &all);
        let solved = self.root.solve_lower_triangular(&all);
        solved.map_or_else(|| DMatrix::zeros(rows.joints.len(), self.len()), |all| all.transpose())
    }

    /// Matrix from independent weights to weights of the covariance function: L⁻ᵀ.
    pub fn to_weights(&self) -> DMatrix<f64> {
        let identity = DMatrix::identity(self.len(), self.len());
        self.root.solve_lower_triangular(&identity).unwrap_or(identity).transpose()
    }

    /// Returns the component with these weights.
    pub fn component(&self, rows: &Rows, weights: &[f64], prior: f64) -> Component {
        let input = |&joint: &usize| {
            let (scale, [low, high]) = (rows.scales[joint], rows.range(joint));
            FieldInput { joint, scale, range: [low * scale, high * scale], fade: FADE * scale }
        };
        let inputs: Vec<FieldInput> = self.inputs.iter().map(input).collect();
        let centre = |c: &Vec<f64>| c.iter().zip(&inputs).map(|(c, i)| c * i.scale).collect();
        let centres = self.centres.iter().map(centre).collect();
        Component { joint: self.joint, centres, radius: self.radius, prior, weights: weights.to_vec(), inputs }
    }
}
