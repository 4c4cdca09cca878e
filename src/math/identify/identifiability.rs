//! Which parameters are separately identifiable: rank of the scaled Jacobian, column by column in the model's order.

use super::residuals::Residuals;
use crate::math::solve::{Factor, Problem, column_norms};

/// A column of the scaled Jacobian that lies this near to the span of the columns before it adds nothing: far above
/// rounding (1e-15), far below what any useful set of poses has (1/condition, about 1/100: Schröer, cited in
/// Nahvi & Hollerbach 1996).
pub const RANK_TOLERANCE: f64 = 1e-9;
/// A column below this fraction of the largest is not seen by the data.
const UNSEEN: f64 = 1e-12;
/// Share of a dependence above which a parameter belongs to the group.
const MEMBER: f64 = 1e-4;
/// Correlation, by size, above which a parameter is named beside one that is known uselessly badly.
const CORRELATED: f64 = 0.5;

/// Parameters that are not separately identifiable; the last of them is held.
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    /// Index of the parameter that is held at its nominal value.
    pub held: usize,
    /// Indices of the parameters it is not separable from; empty where the data do not depend on `held` at all.
    pub with: Vec<usize>,
    /// Standard uncertainty (mm, rad, 1) that `held` would have if it were identified, where that is merely useless: the
    /// parameters would be separable with less noise.
    pub useless_uncertainty: Option<f64>,
}

/// Rank and groups at one set of parameter values.
pub(super) struct Analysis {
    pub groups: Vec<Group>,
}

impl Analysis {
    /// Analyses the Jacobian of `problem` at `values` (all parameters of the robot), where a residual has the standard
    /// deviation `noise` (in the residuals' own unit; 0 where it is not known).
    pub fn at(problem: &Residuals, values: &[f64], noise: f64) -> Self {
        let free = &problem.free;
        let n = free.len();
        let m = problem.residual_count();
        let x: Vec<f64> = free.iter().map(|&i| values[i]).collect();
        let mut jacobian = vec![0.0; m * n];
        problem.jacobian(&x, &mut jacobian);
        let norms = column_norms(&jacobian, n);
        let factor = Factor::new(&jacobian, &vec![0.0; m], &norms);
        // column_norms gives 1 for a column of zeros: its R is zero too
        let size = |j: usize| (0..=j).map(|i| factor.r(i, j).powi(2)).sum::<f64>().sqrt() * norms[j];
        let largest = (0..n).map(size).fold(0.0, f64::max);
        let mut basis: Vec<(usize, Vec<f64>)> = Vec::new();
        let mut groups = Vec::new();
        for j in 0..n {
            if size(j) <= UNSEEN * largest {
                groups.push(Group { held: free[j], with: Vec::new(), useless_uncertainty: None });
                continue;
            }
            let column: Vec<f64> = (0..n).map(|i| factor.r(i, j)).collect();
            let (shares, rest) = split(&column, &basis);
            let distance = rest.iter().map(|v| v * v).sum::<f64>().sqrt();
            if distance > RANK_TOLERANCE {
                basis.push((j, rest.into_iter().map(|v| v / distance).collect()));
                continue;
            }
            let weights = weights(&shares, &basis, &factor);
            let member = |(k, w): (usize, &f64)| (w.abs() > MEMBER).then_some(free[basis[k].0]);
            groups.push(Group {
                held: free[j],
                with: weights.iter().enumerate().filter_map(member).collect(),
                useless_uncertainty: None,
            });
        }
        let kept = basis.into_iter().map(|(j, _)| j).collect();
        groups.extend(useless(problem, &factor, &norms, kept, noise));
        Self { groups }
    }

    /// Indices of the parameters that are held.
    pub fn held(&self) -> Vec<usize> {
        self.groups.iter().map(|g| g.held).collect()
    }
}

/// Of the columns `kept`, those whose parameters would be known worse than they are before: the worst is held, until none is left.
fn useless(problem: &Residuals, factor: &Factor, norms: &[f64], mut kept: Vec<usize>, noise: f64) -> Vec<Group> {
    let mut groups = Vec::new();
    loop {
        let rows: Vec<f64> = (0..norms.len()).flat_map(|i| kept.iter().map(move |&j| factor.r(i, j))).collect();
        let some = Factor::new(&rows, &vec![0.0; norms.len()], &vec![1.0; kept.len()]);
        let Some(inverse) = some.inverse_normal() else { return groups };
        let n = kept.len();
        let u = |k: usize| noise * inverse[k * n + k].sqrt() / norms[kept[k]];
        let excess = |k: usize| u(k) / problem.robot.parameters()[problem.free[kept[k]]].known_within();
        let worst = (0..n).filter(|&k| excess(k) > 1.0).max_by(|&a, &b| excess(a).total_cmp(&excess(b)));
        let Some(worst) = worst else { return groups };
        let correlation = |k: usize| inverse[worst * n + k] / (inverse[worst * n + worst] * inverse[k * n + k]).sqrt();
        groups.push(Group {
            held: problem.free[kept[worst]],
            with: (0..n)
                .filter(|&k| k != worst && correlation(k).abs() > CORRELATED)
                .map(|k| problem.free[kept[k]])
                .collect(),
            useless_uncertainty: Some(u(worst)),
        });
        kept.remove(worst);
    }
}

/// Shares of `column` along the orthonormal `basis` and what is left of it (Gram-Schmidt, done twice: Giraud et al. 2005).
fn split(column: &[f64], basis: &[(usize, Vec<f64>)]) -> (Vec<f64>, Vec<f64>) {
    let mut rest = column.to_vec();
    let mut shares = vec![0.0; basis.len()];
    for _ in 0..2 {
        for ((_, q), share) in basis.iter().zip(&mut shares) {
            let along: f64 = q.iter().zip(&rest).map(|(q, r)| q * r).sum();
            rest.iter_mut().zip(q).for_each(|(r, q)| *r -= along * q);
            *share += along;
        }
    }
    (shares, rest)
}

/// The same column as a sum of the columns behind the basis: back substitution in their triangular matrix.
fn weights(shares: &[f64], basis: &[(usize, Vec<f64>)], factor: &Factor) -> Vec<f64> {
    let element = |i: usize, k: usize| -> f64 {
        let column = basis[k].0;
        basis[i].1.iter().enumerate().map(|(row, q)| q * factor.r(row, column)).sum()
    };
    let mut weights = shares.to_vec();
    for k in (0..basis.len()).rev() {
        weights[k] /= element(k, k);
        for i in 0..k {
            weights[i] -= element(i, k) * weights[k];
        }
    }
    weights
}
