//! Criteria for a set of poses: observability indices (eq. 1.19 to 1.25) and the optimalities of
//! experimental design. Candidates are information matrices: their contributions to JᵀJ.
//!
//! Every criterion is the square of an index, larger is better, as a function of the information
//! JᵀJ.

use super::packed::Packed;
use etalon_base::catalogue::Phrase;
use etalon_base::phrase;
use nalgebra::{Cholesky, DMatrix, Dyn, SymmetricEigen};

/// A criterion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Criterion {
    /// (σ1…σm)^(1/m) / √n, n configurations (eq. 1.19 with m and n as in Sun & Hollerbach 2008).
    O1,
    /// σmin / σmax (eq. 1.20).
    O2,
    /// σmin (eq. 1.22).
    O3,
    /// σmin² / σmax (eq. 1.23).
    O4,
    /// 1 / Σ 1/σ (eq. 1.25).
    O5,
    /// det(JᵀJ)^(1/2m): smallest joint uncertainty of the parameters.
    D,
    /// 1 / √tr((JᵀJ)⁻¹): smallest sum of the parameters' variances, columns divided by their norms.
    A,
    /// σmin with columns divided by their norms: smallest uncertainty of the worst combination.
    E,
    /// 1 / predicted root mean square error of position over the candidates, per unit of noise.
    I,
}

/// Exponent of the power mean instead of the smallest or largest eigenvalue where a derivative is
/// needed.
const SHARP: f64 = 24.0;

/// A criterion near one information matrix: for any other choice, it is at most Σ above / Σ below.
pub struct Tangent {
    /// The smooth criterion at this matrix.
    pub value: f64,
    /// Derivative of its numerator, scaled so that ⟨above, M⟩ is an upper bound of the numerator at
    /// M.
    pub above: DMatrix<f64>,
    /// Numerator at this matrix, with the derivative above.
    pub numerator: f64,
    /// Divisor of the numerator.
    pub below: Below,
}

/// Denominator of a criterion, a sum over the chosen candidates.
pub enum Below {
    /// Number of configurations.
    Configurations,
    /// 1.
    One,
    /// ⟨P, M⟩, at most the largest eigenvalue.
    Largest(DMatrix<f64>),
}

impl Criterion {
    /// Every criterion.
    pub const ALL: [Self; 9] = [Self::O1, Self::O2, Self::O3, Self::O4, Self::O5, Self::D, Self::A, Self::E, Self::I];

    /// Name of the criterion in the literature and on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::O1 => "O1",
            Self::O2 => "O2",
            Self::O3 => "O3",
            Self::O4 => "O4",
            Self::O5 => "O5",
            Self::D => "D",
            Self::A => "A",
            Self::E => "E",
            Self::I => "I",
        }
    }

    /// `true` if columns are divided by their norms: otherwise the sum of variances mixes mm² and
    /// rad².
    pub fn scales_columns(self) -> bool {
        !matches!(self, Self::O2 | Self::O3 | Self::O4 | Self::O5)
    }

    /// Scaling of columns and maximised quantity, in words.
    pub fn definition(self) -> Phrase {
        match self {
            Self::O1 => phrase!("index-o1"),
            Self::O2 => phrase!("index-o2"),
            Self::O3 => phrase!("index-o3"),
            Self::O4 => phrase!("index-o4"),
            Self::O5 => phrase!("index-o5"),
            Self::D => phrase!("index-d"),
            Self::A => phrase!("index-a"),
            Self::E => phrase!("index-e"),
            Self::I => phrase!("index-i"),
        }
    }

    /// The index itself from its square in the scale of the pool.
    pub fn index(self, pool: &Pool, square: f64) -> f64 {
        let scale = match self {
            // a determinant keeps the scale of the columns as a factor
            Self::O1 | Self::D => (pool.scale.iter().map(|s| s.ln()).sum::<f64>() / pool.parameters as f64).exp(),
            _ => 1.0,
        };
        square.max(0.0).sqrt() * scale
    }

    /// The criterion of an information matrix from `configurations`; 0 where it is singular.
    pub fn value(self, pool: &Pool, information: DMatrix<f64>, configurations: usize) -> f64 {
        let m = pool.parameters as f64;
        let value = match self {
            Self::O1 | Self::D | Self::A | Self::I => pool.factor(information).map(|factor| match self {
                Self::O1 | Self::D => {
                    let mean = (factor.ln_determinant() / m).exp();
                    if self == Self::O1 { mean / configurations as f64 } else { mean }
                }
                Self::A => 1.0 / factor.inverse().trace(),
                _ => 1.0 / inner(&factor.inverse(), &pool.workspace),
            }),
            _ => {
                let values = SymmetricEigen::new(information).eigenvalues;
                let (least, most) = (values.min(), values.max());
                let sane = least > 0.0 && most.is_finite();
                sane.then(|| match self {
                    Self::O2 => least / most,
                    Self::O4 => least * least / most,
                    Self::O5 => values.iter().map(|v| v.sqrt().recip()).sum::<f64>().powi(-2),
                    _ => least,
                })
            }
        };
        value.filter(|v| v.is_finite()).unwrap_or(0.0)
    }

    /// Value and derivative at an information matrix; `None` if it is singular or no bound is
    /// known.
    ///
    /// The numerators are concave and homogeneous of degree one, so that their derivative G at any
    /// M bounds them anywhere: h(N) ≤ ⟨G, N⟩ (the equivalence theorem's inequality: Kiefer &
    /// Wolfowitz 1960, Pukelsheim 1993, chapter 7).
    pub fn tangent(self, pool: &Pool, information: &DMatrix<f64>, configurations: f64) -> Option<Tangent> {
        let m = pool.parameters as f64;
        let tangent = match self {
            Self::O1 | Self::D => {
                let factor = pool.factor(information.clone())?;
                let mean = (factor.ln_determinant() / m).exp();
                let below = if self == Self::O1 { Below::Configurations } else { Below::One };
                let value = if self == Self::O1 { mean / configurations } else { mean };
                Tangent { value, above: factor.inverse() * (mean / m), numerator: mean, below }
            }
            Self::A | Self::I => {
                let inverse = pool.factor(information.clone())?.inverse();
                let kernel = if self == Self::A { &inverse * &inverse } else { &inverse * &pool.workspace * &inverse };
                let value = if self == Self::A { inverse.trace() } else { inner(&inverse, &pool.workspace) }.recip();
                Tangent { value, above: kernel * (value * value), numerator: value, below: Below::One }
            }
            Self::O2 | Self::O3 | Self::E | Self::O5 => self.spectral_tangent(information)?,
            Self::O4 => return None,
        };
        tangent.value.is_finite().then_some(tangent)
    }

    fn spectral_tangent(self, information: &DMatrix<f64>) -> Option<Tangent> {
        let eigen = SymmetricEigen::new(information.clone());
        let (least, most) = (eigen.eigenvalues.min(), eigen.eigenvalues.max());
        if !(least > 0.0 && most.is_finite()) {
            return None;
        }
        let spectral = |f: &dyn Fn(f64) -> f64| {
            let mut scaled = eigen.eigenvectors.clone();
            for (mut column, value) in scaled.column_iter_mut().zip(eigen.eigenvalues.iter()) {
                column *= f(*value);
            }
            scaled * eigen.eigenvectors.transpose()
        };
        if self == Self::O5 {
            let sum: f64 = eigen.eigenvalues.iter().map(|v| v.sqrt().recip()).sum();
            let above = spectral(&|v| v.powf(-1.5) * sum.powi(-3));
            let value = sum.powi(-2);
            return Some(Tangent { value, above, numerator: value, below: Below::One });
        }
        // of trace 1 and not negative: its product with any N is at least the least eigenvalue of N
        let power = spectral(&|v| (least / v).powf(SHARP + 1.0));
        let above = &power / power.trace();
        let numerator = inner(&above, information);
        let mean = |sum: f64, p: f64| sum.powf(1.0 / p);
        let smooth_least = least / mean(eigen.eigenvalues.iter().map(|v| (least / v).powf(SHARP)).sum(), SHARP);
        if self == Self::O2 {
            let power = spectral(&|v| (v / most).powf(SHARP - 1.0));
            let smooth_most = most * mean(eigen.eigenvalues.iter().map(|v| (v / most).powf(SHARP)).sum(), SHARP);
            let below = Below::Largest(&power / power.trace());
            return Some(Tangent { value: smooth_least / smooth_most, above, numerator, below });
        }
        Some(Tangent { value: smooth_least, above, numerator, below: Below::One })
    }
}

/// One candidate: configurations that are measured together.
#[derive(Clone, Debug)]
pub struct Candidate {
    /// Rows of the Jacobian, k × m, with its columns divided by the pool's scale.
    pub rows: DMatrix<f64>,
    /// Rows as columns, m × k.
    pub columns: DMatrix<f64>,
    /// Number of configurations in it.
    pub configurations: usize,
}

/// All candidates.
#[derive(Clone, Debug)]
pub struct Pool {
    /// Criterion of the choice.
    pub criterion: Criterion,
    /// Number of parameters, m.
    pub parameters: usize,
    /// The candidates.
    pub candidates: Vec<Candidate>,
    /// Information JᵀJ of each candidate, m × m.
    pub contributions: Packed,
    /// Divisors of the columns of the Jacobian.
    pub scale: Vec<f64>,
    /// Mean of JᵀJ over all configurations: the effect of a set of parameters on the positions of
    /// the workspace.
    pub workspace: DMatrix<f64>,
    /// Term added to the diagonal of singular matrices to make them comparable.
    pub ridge: f64,
}

impl Pool {
    /// A pool of candidates given as blocks of rows (row by row, `scale.len()` numbers each) and
    /// their configurations.
    pub fn new(blocks: &[(Vec<f64>, usize)], scale: Vec<f64>, criterion: Criterion) -> Self {
        let m = scale.len();
        let candidate = |(rows, configurations): &(Vec<f64>, usize)| {
            let mut rows = DMatrix::from_row_slice(rows.len() / m.max(1), m, rows);
            for (mut column, s) in rows.column_iter_mut().zip(&scale) {
                column /= *s;
            }
            Candidate { columns: rows.transpose(), rows, configurations: *configurations }
        };
        let candidates: Vec<Candidate> = blocks.iter().map(candidate).collect();
        let contributions: Vec<DMatrix<f64>> = candidates.iter().map(|c| c.rows.tr_mul(&c.rows)).collect();
        let contributions = Packed::new(m, contributions.iter());
        let mut workspace = contributions.sum((0..candidates.len()).map(|i| (i, 1.0)));
        let ridge = 1e-12 * workspace.trace() / (m * candidates.len()).max(1) as f64;
        workspace /= candidates.iter().map(|c| c.configurations).sum::<usize>().max(1) as f64;
        Self { criterion, parameters: m, candidates, contributions, scale, workspace, ridge }
    }

    /// JᵀJ of chosen candidates.
    pub fn information(&self, chosen: &[usize]) -> DMatrix<f64> {
        self.contributions.sum(chosen.iter().map(|&i| (i, 1.0)))
    }

    /// Σ wᵢ JᵢᵀJᵢ.
    pub fn weighted(&self, weights: &[f64]) -> DMatrix<f64> {
        self.contributions.sum(weights.iter().copied().enumerate().filter(|(_, w)| *w > 0.0))
    }

    /// Number of products that value and derivative of the criterion at all candidates take.
    pub fn products(&self) -> usize {
        self.candidates.len() * self.contributions.width() + 3 * self.parameters.pow(3)
    }

    /// Configurations of chosen candidates.
    pub fn configurations(&self, chosen: &[usize]) -> usize {
        chosen.iter().map(|&i| self.candidates[i].configurations).sum()
    }

    /// Cholesky factor, with the smallest term added to the diagonal that makes singular matrices
    /// comparable.
    pub fn factor(&self, mut information: DMatrix<f64>) -> Option<Cholesky<f64, Dyn>> {
        (0..self.parameters).for_each(|i| information[(i, i)] += self.ridge);
        information.cholesky()
    }
}

/// Sum of the products of the elements of two matrices of the same shape: tr(AᵀB).
pub fn inner(a: &DMatrix<f64>, b: &DMatrix<f64>) -> f64 {
    a.as_slice().iter().zip(b.as_slice()).map(|(a, b)| a * b).sum()
}
