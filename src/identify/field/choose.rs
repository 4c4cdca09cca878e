//! Choice of components by the restricted likelihood.

use super::basis::Basis;
use super::rows::{Fit, Rows};
use super::solve::{Solved, solve, white_improbability};
use nalgebra::{DMatrix, DVector};
use rayon::prelude::*;

/// Candidate radii (rad; for prismatic joints, share of half the range) of the error as a function
/// of one joint, and of two.
const RADII: [&[f64]; 2] = [&[1.5, 3.0, 6.0], &[3.0, 6.0]];
/// Maximum number of components.
const MOST: usize = 6;
/// Number of candidates of largest score whose likelihood is computed.
const COMPARED: usize = 6;
/// 99 % quantile of chi-square with one degree of freedom.
const SIGNIFICANT: f64 = 6.635;
/// Minimum number of equations for each inducing point.
const EQUATIONS_EACH: usize = 3;

/// Chosen components and their weights.
pub(super) struct Chosen {
    pub bases: Vec<Basis>,
    pub solved: Solved,
    /// Fit of the parameters together with the components.
    pub fit: Fit,
    /// Change of the parameters for each independent weight, with the opposite sign.
    pub follow: DMatrix<f64>,
}

/// Chooses components from some rows; the error is the largest fall of −2 ln L and its threshold.
pub(super) fn choose(rows: &Rows, fit: &Fit, some: &[usize]) -> Result<Chosen, (f64, f64)> {
    let candidates = candidates(rows);
    // the best of many candidates falls by 2 ln(number) more
    let threshold = SIGNIFICANT + 2.0 * (candidates.len().max(1) as f64).ln();
    let mut last = white_improbability(fit.residuals.norm_squared(), fit.degrees);
    let (mut bases, mut solved): (Vec<Basis>, Option<Solved>) = (Vec::new(), None);
    let mut projected = DMatrix::zeros(fit.residuals.len(), 0);
    let mut most = 0.0;
    for _ in 0..MOST {
        let trial = Trial { rows, fit, some, projected: &projected, bases: &bases, solved: solved.as_ref() };
        let Some((basis, better, columns)) = best(&trial, &candidates) else { break };
        let fall = last - better.improbability;
        most = f64::max(most, fall);
        if fall <= threshold {
            break;
        }
        last = better.improbability;
        projected = beside(&projected, &columns);
        bases.push(basis);
        solved = Some(better);
    }
    let chosen = solved.and_then(|solved| refined(rows, some, bases, &solved));
    chosen.ok_or((most, threshold))
}

/// Minimum mean variance of a component, relative to the variance of a white residual.
const NEGLIGIBLE: f64 = 0.01;

/// Weights, with nominal values weighted relative to the residuals of the field, and without
/// components that later ones have made negligible.
fn refined(rows: &Rows, some: &[usize], mut bases: Vec<Basis>, solved: &Solved) -> Option<Chosen> {
    let fit = rows.fit(some, solved.white.sqrt())?;
    let mut columns = DMatrix::zeros(some.len(), 0);
    for basis in &bases {
        columns = beside(&columns, &rows.columns(basis.joint, &basis.at_observations(rows), some));
    }
    let (projected, follow) = fit.project(&columns);
    let sizes: Vec<usize> = bases.iter().map(Basis::len).collect();
    let solved = solve(&projected, &sizes, &fit.residuals, fit.degrees)?;
    if solved.effects.iter().any(|effect| *effect < NEGLIGIBLE) {
        let mut effects = solved.effects.iter();
        bases.retain(|_| effects.next().is_some_and(|effect| *effect >= NEGLIGIBLE));
        return if bases.is_empty() { None } else { refined(rows, some, bases, &solved) };
    }
    Some(Chosen { bases, solved, fit, follow })
}

/// All candidates, grouped by their functions: joints on which the error depends, and radius.
fn candidates(rows: &Rows) -> Vec<Basis> {
    let moves = |k: &usize| {
        let [low, high] = rows.range(*k);
        high - low > 0.1
    };
    let moving: Vec<usize> = (0..rows.scales.len()).filter(moves).collect();
    let pairs = moving.iter().enumerate().flat_map(|(i, &a)| moving[i + 1..].iter().map(move |&b| vec![a, b]));
    let inputs: Vec<Vec<usize>> = moving.iter().map(|&k| vec![k]).chain(pairs).collect();
    let radii = inputs.iter().flat_map(|inputs| RADII[inputs.len() - 1].iter().map(move |radius| (inputs, *radius)));
    let of = |(inputs, radius): (&Vec<usize>, f64)| {
        let on = |joint: usize| Basis::on_poses(rows, joint, inputs.clone(), radius);
        (0..rows.scales.len()).filter_map(on).collect::<Vec<Basis>>()
    };
    radii.flat_map(of).collect()
}

/// Components so far, and the data to which they are fitted.
struct Trial<'a> {
    rows: &'a Rows,
    fit: &'a Fit,
    some: &'a [usize],
    projected: &'a DMatrix<f64>,
    bases: &'a [Basis],
    solved: Option<&'a Solved>,
}

type Best = (Basis, Solved, DMatrix<f64>);

/// The candidate with which the likelihood is largest.
fn best(trial: &Trial, candidates: &[Basis]) -> Option<Best> {
    let Trial { rows, fit, some, projected, bases, .. } = trial;
    let used = projected.ncols();
    let fits = |basis: &&Basis| EQUATIONS_EACH * (used + basis.len()) <= fit.degrees as usize;
    let mut scored: Vec<(f64, usize)> = candidates
        .par_iter()
        .enumerate()
        .filter(|(_, basis)| fits(basis))
        .filter_map(|(i, basis)| Some((trial.score(basis)?, i)))
        .collect();
    scored.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    let sizes: Vec<usize> = bases.iter().map(Basis::len).collect();
    let of = |&(_, i): &(f64, usize)| -> Option<Best> {
        let basis = candidates[i].clone();
        let columns = rows.columns(basis.joint, &basis.at_observations(rows), some);
        let (columns, _) = fit.project(&columns);
        let sizes = [&sizes[..], &[basis.len()]].concat();
        let solved = solve(&beside(projected, &columns), &sizes, &fit.residuals, fit.degrees)?;
        Some((basis, solved, columns))
    };
    scored.truncate(COMPARED);
    let all: Vec<Best> = scored.par_iter().filter_map(of).collect();
    all.into_iter().min_by(|a, b| a.1.improbability.total_cmp(&b.1.improbability))
}

impl Trial<'_> {
    /// Standardised score of the variance of a candidate at zero (Rao 1948; Harville 1977): |Bᵀ V⁻¹
    /// r|² less its expectation, over its standard deviation.
    fn score(&self, basis: &Basis) -> Option<f64> {
        let columns = self.rows.columns(basis.joint, &basis.at_observations(self.rows), self.some);
        let (columns, _) = self.fit.project(&columns);
        let residuals = &self.fit.residuals;
        let (left, information) = match self.solved {
            None => (columns.tr_mul(residuals), columns.tr_mul(&columns)),
            Some(solved) => {
                let across = self.projected.tr_mul(&columns);
                let left: DVector<f64> = columns.tr_mul(residuals) - across.tr_mul(&solved.weights);
                let known = across.tr_mul(&(&solved.covariance * &across)) / solved.white;
                (left, columns.tr_mul(&columns) - known)
            }
        };
        let white = self.solved.map_or(residuals.norm_squared() / self.fit.degrees, |solved| solved.white);
        let spread = (2.0 * information.norm_squared()).sqrt();
        let score = (left.norm_squared() / white - information.trace()) / spread;
        score.is_finite().then_some(score)
    }
}

/// Both matrices side by side.
pub(super) fn beside(a: &DMatrix<f64>, b: &DMatrix<f64>) -> DMatrix<f64> {
    let mut all = DMatrix::zeros(b.nrows(), a.ncols() + b.ncols());
    all.columns_mut(0, a.ncols()).copy_from(a);
    all.columns_mut(a.ncols(), b.ncols()).copy_from(b);
    all
}
