//! Candidates as information matrices: what each would add to JᵀJ.

use nalgebra::{Cholesky, DMatrix, Dyn};

/// One candidate: everything that is measured together.
#[derive(Clone, Debug)]
pub struct Candidate {
    /// Rows of the Jacobian, k × m, with its columns divided by the pool's scale.
    pub rows: DMatrix<f64>,
    /// Its information JᵀJ, m × m.
    pub information: DMatrix<f64>,
    /// Number of configurations in it.
    pub configurations: usize,
}

/// All candidates.
#[derive(Clone, Debug)]
pub struct Pool {
    /// Number of parameters, m.
    pub parameters: usize,
    /// The candidates.
    pub candidates: Vec<Candidate>,
    /// What the columns of the Jacobian are divided by.
    pub scale: Vec<f64>,
    /// Mean of JᵀJ over all configurations: what a set of parameters means for the positions of the workspace.
    pub workspace: DMatrix<f64>,
    /// Added to the diagonal of singular matrices so that they can be compared.
    pub ridge: f64,
}

impl Pool {
    /// A pool of candidates given as blocks of rows (row by row, `scale.len()` numbers each) and their configurations.
    pub fn new(blocks: &[(Vec<f64>, usize)], scale: Vec<f64>) -> Self {
        let m = scale.len();
        let candidate = |(rows, configurations): &(Vec<f64>, usize)| {
            let mut rows = DMatrix::from_row_slice(rows.len() / m.max(1), m, rows);
            for (mut column, s) in rows.column_iter_mut().zip(&scale) {
                column /= *s;
            }
            Candidate { information: rows.tr_mul(&rows), rows, configurations: *configurations }
        };
        let candidates: Vec<Candidate> = blocks.iter().map(candidate).collect();
        let mut workspace = DMatrix::zeros(m, m);
        candidates.iter().for_each(|c| workspace += &c.information);
        let ridge = 1e-12 * workspace.trace() / (m * candidates.len()).max(1) as f64;
        workspace /= candidates.iter().map(|c| c.configurations).sum::<usize>().max(1) as f64;
        Self { parameters: m, candidates, scale, workspace, ridge }
    }

    /// JᵀJ of chosen candidates.
    pub fn information(&self, chosen: &[usize]) -> DMatrix<f64> {
        let mut sum = DMatrix::zeros(self.parameters, self.parameters);
        chosen.iter().for_each(|&i| sum += &self.candidates[i].information);
        sum
    }

    /// Σ wᵢ JᵢᵀJᵢ.
    pub fn weighted(&self, weights: &[f64]) -> DMatrix<f64> {
        let mut sum = DMatrix::zeros(self.parameters, self.parameters);
        for (w, c) in weights.iter().zip(&self.candidates).filter(|(w, _)| **w > 0.0) {
            sum.zip_apply(&c.information, |s, v| *s += w * v);
        }
        sum
    }

    /// Configurations of chosen candidates.
    pub fn configurations(&self, chosen: &[usize]) -> usize {
        chosen.iter().map(|&i| self.candidates[i].configurations).sum()
    }

    /// Cholesky factor, with just so much added to the diagonal that singular matrices can be compared.
    pub fn factor(&self, mut information: DMatrix<f64>) -> Option<Cholesky<f64, Dyn>> {
        (0..self.parameters).for_each(|i| information[(i, i)] += self.ridge);
        information.cholesky()
    }
}

/// Sum of the products of the elements of two matrices of the same shape: tr(AᵀB).
pub fn inner(a: &DMatrix<f64>, b: &DMatrix<f64>) -> f64 {
    a.as_slice().iter().zip(b.as_slice()).map(|(a, b)| a * b).sum()
}
