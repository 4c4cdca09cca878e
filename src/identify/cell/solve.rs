//! Weighted least squares of frames: damped Gauss-Newton steps on rotations and translations, with
//! one variance component each of positions and orientations (Förstner 1979; Luhmann et al.,
//! Close-range photogrammetry and 3D imaging, 2.4.3).

use super::{CellResidual, Component, Measure, Quality, Stated, measure_index};
use crate::chi_square_exceeds;
use crate::judgement::bound::{ASSUMED_MM, ASSUMED_RAD};
use etalon_base::pose::{Pose, Vector, cross, dot, norm};
use etalon_math::{Factor, column_norms, symmetric_eigen};
use nalgebra::{DMatrix, Matrix3, Vector3};
use statrs::distribution::{ChiSquared, ContinuousCDF, FisherSnedecor};

/// Maximum number of damped steps.
const STEPS: usize = 100;
/// Maximum number of estimates of the variance components.
const ROUNDS: usize = 60;
/// Convergence tolerance: relative change of a variance component.
const SETTLED: f64 = 1e-9;
/// Convergence tolerance: length of a step relative to the norm of the residuals.
const SHORT: f64 = 1e-11;
/// Maximum damping relative to the unit columns.
const MOST_DAMPING: f64 = 1e6;
/// Minimum standard deviations (mm, rad): residuals of exact data are rounding errors.
const ROUNDING: [f64; 2] = [1e-9, 1e-12];
/// Starting values of standard deviations (mm, rad) that are not given.
const FIRST: [f64; 2] = [0.1, 1e-3];
/// Standard deviations (mm, rad) that are assumed where nothing shows them.
const ASSUMED: [f64; 2] = [ASSUMED_MM, ASSUMED_RAD];
/// Minimum eigenvalue of the share of a residual that its reading controls, for a test.
const CONTROLLED: f64 = 1e-6;
/// Relative singular value below which a combination of parameters is not determined.
const SINGULAR: f64 = 1e-10;

/// Three equations of one reading: measured minus predicted.
pub(super) struct Equation {
    pub reading: usize,
    pub measure: Measure,
    /// Measured minus predicted (mm or rad).
    pub residual: Vector,
    /// Derivatives of the prediction by parameters, by index.
    pub columns: Vec<(usize, Vector)>,
    /// Covariance, or its shape if no uncertainty is given.
    pub covariance: [[f64; 3]; 3],
}

/// Frames and points that predict measurements.
pub(super) trait CellModel: Clone {
    /// Number of parameters.
    fn parameters(&self) -> usize;
    /// Equations at the current values.
    fn equations(&self) -> Vec<Equation>;
    /// The model after a small step: translations add, rotations turn about the axes of the frame
    /// in which the pose is given.
    fn moved(&self, step: &[f64]) -> Self;
}

/// Minimum with its covariance.
pub(super) struct Solved<M> {
    pub model: M,
    pub covariance: DMatrix<f64>,
    pub quality: Quality,
}

/// A pose after a small step.
pub(super) fn moved(pose: &Pose, shift: &[f64], turn: &[f64]) -> Pose {
    let turned =
        Pose::from_rotation_vector([turn[0], turn[1], turn[2]]).then(&Pose { translation_mm: [0.0; 3], ..*pose });
    let t = pose.translation_mm;
    Pose { translation_mm: [t[0] + shift[0], t[1] + shift[1], t[2] + shift[2]], ..turned }
}

pub(super) const UNIT: [Vector; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// Columns of a matrix at consecutive parameters.
pub(super) fn columns(first: usize, of: impl Fn(usize) -> Vector) -> impl Iterator<Item = (usize, Vector)> {
    (0..3).map(|k| (first + k, of(k))).collect::<Vec<_>>().into_iter()
}

/// Applies the inverse of the right Jacobian of the rotation group at ε (Solà et al., "A micro Lie
/// theory", 2018, eq. 144).
pub(super) fn inverse_right_jacobian(epsilon: Vector, v: Vector) -> Vector {
    let angle = norm(epsilon);
    let second = if angle < 1e-4 {
        1.0 / 12.0 + angle * angle / 720.0
    } else {
        1.0 / (angle * angle) - (1.0 + angle.cos()) / (2.0 * angle * angle.sin())
    };
    let once = cross(epsilon, v);
    let twice = cross(epsilon, once);
    [0, 1, 2].map(|i| v[i] + 0.5 * once[i] + second * twice[i])
}

/// Equations divided by their standard uncertainties, at the current values.
struct Whitened {
    equations: Vec<Equation>,
    jacobian: Vec<f64>,
    residuals: Vec<f64>,
    parameters: usize,
}

impl Whitened {
    /// `None` if a residual is not finite or a covariance not positive definite.
    fn new(model: &impl CellModel, variances: [f64; 2]) -> Option<Self> {
        let (equations, n) = (model.equations(), model.parameters());
        let (mut jacobian, mut residuals) = (Vec::new(), Vec::new());
        for equation in &equations {
            let covariance =
                Matrix3::from_fn(|i, j| equation.covariance[i][j]) * variances[measure_index(equation.measure)];
            let root = covariance.cholesky()?.l();
            let white = |v: Vector| root.solve_lower_triangular(&Vector3::from(v));
            residuals.extend(white(equation.residual)?.iter());
            let mut rows = vec![0.0; 3 * n];
            for (column, v) in &equation.columns {
                let v = white(*v)?;
                (0..3).for_each(|i| rows[i * n + column] += v[i]);
            }
            jacobian.extend(rows);
        }
        let finite = residuals.iter().chain(&jacobian).all(|v| v.is_finite());
        finite.then_some(Self { equations, jacobian, residuals, parameters: n })
    }

    fn cost(&self) -> f64 {
        self.residuals.iter().map(|r| r * r).sum()
    }

    fn block(&self, i: usize) -> (DMatrix<f64>, Vector3<f64>) {
        let n = self.parameters;
        let rows = DMatrix::from_row_slice(3, n, &self.jacobian[3 * n * i..3 * n * (i + 1)]);
        (rows, Vector3::from_column_slice(&self.residuals[3 * i..3 * i + 3]))
    }

    /// (JᵀJ)⁻¹; `None` if a combination of parameters is not determined.
    fn cofactors(&self) -> Option<DMatrix<f64>> {
        let n = self.parameters;
        let norms = column_norms(&self.jacobian, n);
        let factor = Factor::new(&self.jacobian, &self.residuals, &norms);
        if etalon_math::svd(&factor).rank(SINGULAR) < n {
            return None;
        }
        let inverse = factor.inverse_normal()?;
        Some(DMatrix::from_fn(n, n, |i, j| inverse[i * n + j] / (norms[i] * norms[j])))
    }

    /// Sum of squares, redundancy and number of equations of each measure.
    fn sums(&self, cofactors: &DMatrix<f64>) -> [[f64; 3]; 2] {
        let mut sums = [[0.0; 3]; 2];
        for (i, equation) in self.equations.iter().enumerate() {
            let (rows, residual) = self.block(i);
            let taken = (&rows * cofactors * rows.transpose()).trace();
            let sum = &mut sums[measure_index(equation.measure)];
            sum[0] += residual.norm_squared();
            sum[1] += 3.0 - taken;
            sum[2] += 3.0;
        }
        sums
    }
}

/// Minimum for given variances.
fn minimum<M: CellModel>(mut model: M, variances: [f64; 2]) -> Option<M> {
    let mut at = Whitened::new(&model, variances)?;
    let mut damping = 0.0;
    for _ in 0..STEPS {
        let norms = column_norms(&at.jacobian, at.parameters);
        let factor = Factor::new(&at.jacobian, &at.residuals, &norms);
        loop {
            let step = if damping > 0.0 { factor.damped(damping).solve() } else { factor.solve() };
            let length = step.as_ref().map_or(f64::INFINITY, |step| etalon_math::norm(step));
            let unscaled: Vec<f64> = step.unwrap_or_default().iter().zip(&norms).map(|(s, d)| s / d).collect();
            let trial = (length.is_finite()).then(|| model.moved(&unscaled));
            let next = trial.as_ref().and_then(|trial| Whitened::new(trial, variances));
            if let (Some(trial), Some(next)) = (trial, next)
                && next.cost() < at.cost()
            {
                let short = length <= SHORT * at.cost().sqrt();
                (model, at) = (trial, next);
                damping = if damping > 1e-6 { 0.1 * damping } else { 0.0 };
                if short {
                    return Some(model);
                }
                break;
            }
            if length <= 1e-6 * at.cost().sqrt() || damping > MOST_DAMPING {
                return Some(model);
            }
            damping = (10.0 * damping).max(1e-3);
        }
    }
    Some(model)
}

/// Cost of the minimum from a start, with the first variances.
pub(super) fn rough<M: CellModel>(start: M, stated: &Stated) -> Option<(M, f64)> {
    let variances = first(stated);
    let model = minimum(start, variances)?;
    let cost = Whitened::new(&model, variances)?.cost();
    Some((model, cost))
}

fn first(stated: &Stated) -> [f64; 2] {
    [0, 1].map(|k| if stated.is_stated(k) { 1.0 } else { FIRST[k] * FIRST[k] })
}

/// Minimum from a start, with the standard deviations of the measures where they are not given or
/// contradict the residuals. `None` if the equations do not determine all parameters.
pub(super) fn solve<M: CellModel>(start: M, stated: &Stated) -> Option<Solved<M>> {
    let mut variances = first(stated);
    let mut estimated = [0, 1].map(|k| !stated.is_stated(k));
    let mut model = start;
    for _ in 0..ROUNDS {
        model = minimum(model, variances)?;
        let at = Whitened::new(&model, variances)?;
        let sums = at.sums(&at.cofactors()?);
        let mut change: f64 = 0.0;
        for k in 0..2 {
            let [squares, redundancy, count] = sums[k];
            if !estimated[k] && redundancy > 0.5 && chi_square_exceeds(squares, redundancy.round() as usize) {
                estimated[k] = true;
                change = 1.0;
            }
            if estimated[k] && count > 0.0 && redundancy > 1e-6 {
                let shape =
                    at.equations.iter().find(|e| measure_index(e.measure) == k).map_or(1.0, |e| e.covariance[0][0]);
                let next = (variances[k] * squares / redundancy).max(ROUNDING[k].powi(2) / shape);
                change = change.max((next / variances[k] - 1.0).abs());
                variances[k] = next;
            }
        }
        if change < SETTLED {
            break;
        }
    }
    let model = minimum(model, variances)?;
    let at = Whitened::new(&model, variances)?;
    // without redundancy and statement nothing shows the uncertainty
    let sums = at.sums(&at.cofactors()?);
    let is_unknown = |k: usize| estimated[k] && sums[k][1] <= 0.5;
    let variances = [0, 1].map(|k| if is_unknown(k) { ASSUMED[k] * ASSUMED[k] } else { variances[k] });
    let at = Whitened::new(&model, variances)?;
    let covariance = at.cofactors()?;
    let quality = quality(&at, &covariance, estimated, stated);
    Some(Solved { model, covariance, quality })
}

fn quality(at: &Whitened, covariance: &DMatrix<f64>, estimated: [bool; 2], stated: &Stated) -> Quality {
    let sums = at.sums(covariance);
    let mut components = Vec::new();
    for (k, measure) in [Measure::Position, Measure::Orientation].into_iter().enumerate() {
        let [_, redundancy, count] = sums[k];
        if count == 0.0 {
            continue;
        }
        let own = at.equations.iter().filter(|e| e.measure == measure);
        let squares: f64 = own.map(|e| dot(e.residual, e.residual)).sum();
        components.push(Component {
            measure,
            equations: count as usize,
            redundancy,
            deviation: if redundancy > 1e-6 { (squares / redundancy).sqrt() } else { 0.0 },
            agrees: stated.is_stated(k) && !estimated[k],
        });
    }
    let judged = |(i, equation): (usize, &Equation)| {
        let (rows, residual) = at.block(i);
        let k = measure_index(equation.measure);
        let free = estimated[k].then_some(sums[k][1]);
        CellResidual {
            reading: equation.reading,
            measure: equation.measure,
            value: equation.residual,
            probability: probability(&rows, residual, covariance, free),
        }
    };
    Quality { components, residuals: at.equations.iter().enumerate().map(judged).collect() }
}

/// Probability of a residual at least as large if its reading belongs to the others: F with the
/// variance of all others (externally studentized: Cook & Weisberg 1982, 2.2.2), or χ² with the
/// given variance. `None` without redundancy.
fn probability(
    rows: &DMatrix<f64>,
    residual: Vector3<f64>,
    covariance: &DMatrix<f64>,
    redundancy: Option<f64>,
) -> Option<f64> {
    let left = Matrix3::identity() - (rows * covariance * rows.transpose()).fixed_view::<3, 3>(0, 0).into_owned();
    let (values, _) = symmetric_eigen::<3>(std::array::from_fn(|i| std::array::from_fn(|j| left[(i, j)])));
    if values[0] < CONTROLLED {
        return None;
    }
    let square = (residual.transpose() * left.try_inverse()? * residual)[(0, 0)];
    match redundancy {
        None => ChiSquared::new(3.0).ok().map(|d| d.sf(square)),
        Some(all) if all - 3.0 >= 1.0 => {
            let others = ((all - square) / (all - 3.0)).max(1e-12);
            FisherSnedecor::new(3.0, all - 3.0).ok().map(|d| d.sf(square / 3.0 / others))
        }
        Some(_) => None,
    }
}
