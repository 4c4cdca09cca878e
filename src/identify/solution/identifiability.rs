//! Separately identifiable parameters: rank of the scaled Jacobian, column by column in the model's
//! order.

use crate::model::prior::Prior;
use crate::model::residuals::Residuals;
use etalon_math::{Factor, factor_at};

/// Maximum distance of a column of the scaled Jacobian from the span of the previous columns at
/// which it is dependent: far above rounding (1e-15), far below that of any useful set of poses
/// (1/condition, about 1/100: Schröer, cited in Nahvi & Hollerbach 1996).
pub const RANK_TOLERANCE: f64 = 1e-9;
/// Fraction of the largest column below which a column is unobservable.
const UNSEEN: f64 = 1e-12;
/// Share of a dependence above which a parameter belongs to the group.
const MEMBER: f64 = 1e-4;
/// Absolute correlation above which a parameter is named beside a parameter with a uselessly large
/// uncertainty.
const CORRELATED: f64 = 0.5;

/// Parameters that are not separately identifiable; the last of them is held.
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    /// Index of the parameter that is held at its nominal value.
    pub held: usize,
    /// Indices of the parameters from which it is not separable; empty if the data do not depend on
    /// `held`.
    pub with: Vec<usize>,
    /// Standard uncertainty (mm, rad, 1) that `held` would have if it were identified, if this is
    /// merely useless: the parameters would be separable with less noise.
    pub useless_uncertainty: Option<f64>,
}

/// Rank and groups at one set of parameter values.
pub(crate) struct Analysis {
    pub groups: Vec<Group>,
}

/// Rule for choosing the held one of linearly dependent columns.
#[derive(Clone, Copy)]
enum Choice<'a> {
    /// The last.
    Last,
    /// The one whose nominal value is most accurate relative to its effect: by the standard
    /// uncertainty of each column, infinite without a nominal value.
    BestKnown(&'a [f64]),
}

impl Analysis {
    /// Analyses the Jacobian of `problem`, without nominal values, at `values`. Among dependent
    /// parameters, the one whose tolerance moves the targets least is held, so that the others
    /// hardly change; the last one if tolerances are alike.
    pub fn by_prior(problem: &Residuals, values: &[f64]) -> Self {
        let s = |&i: &usize| Prior::TOLERANCES.uncertainty(problem.robot, i).unwrap_or(f64::INFINITY);
        let known: Vec<f64> = problem.free.iter().map(s).collect();
        Self::choosing(problem, values, 0.0, Choice::BestKnown(&known))
    }

    /// Analyses the Jacobian of `problem` at `values` (all parameters of the robot), for residuals
    /// of the standard deviation `noise` (in the unit of the residuals; 0 if unknown).
    pub fn at(problem: &Residuals, values: &[f64], noise: f64) -> Self {
        Self::choosing(problem, values, noise, Choice::Last)
    }

    fn choosing(problem: &Residuals, values: &[f64], noise: f64, choice: Choice) -> Self {
        let free = &problem.free;
        let x: Vec<f64> = free.iter().map(|&i| values[i]).collect();
        let (mut factor, norms) = factor_at(problem, &x);
        // a column of zeros has the norm 1 and a factor of zeros
        let sizes: Vec<f64> = factor.column_norms().iter().zip(&norms).map(|(size, norm)| size * norm).collect();
        let largest = sizes.iter().copied().fold(0.0, f64::max);
        let unseen = |j: usize| sizes[j] <= UNSEEN * largest;
        // columns of the factor: those of a block are independent by themselves, the common ones
        // beside all of them
        let mut columns: Vec<usize> = (0..free.len()).collect();
        let mut groups = Vec::new();
        let group = |held: usize, with: Vec<usize>| Group {
            held: free[held],
            with: with.into_iter().map(|j| free[j]).collect(),
            useless_uncertainty: None,
        };
        for (own, r) in factor.blocks() {
            let found = independent(&r, |j| unseen(own[j]), |_| f64::INFINITY);
            let with = |weights: Vec<(usize, f64)>| weights.into_iter().map(|(k, _)| own[k]).collect();
            groups.extend(found.dependent.into_iter().map(|(j, weights)| group(own[j], with(weights))));
        }
        if !groups.is_empty() {
            columns.retain(|&j| groups.iter().all(|g| g.held != free[j]));
            factor = factor.keeping(&columns);
        }
        let common = factor.common();
        let size = common.len();
        let r: Vec<Vec<f64>> = (0..size).map(|j| (0..size).map(|i| factor.r(i, j)).collect()).collect();
        // effect of a column within its tolerance
        let effect = |k: usize| match choice {
            Choice::Last => f64::INFINITY,
            Choice::BestKnown(known) => norms[columns[common[k]]] * known[columns[common[k]]],
        };
        let found = independent(&r, |k| unseen(columns[common[k]]), effect);
        for (j, weights) in &found.dependent {
            let mut with: Vec<usize> = weights.iter().map(|&(k, _)| columns[common[k]]).collect();
            let mut moved = vec![0.0; size];
            weights.iter().for_each(|&(k, weight)| moved[k] = -weight);
            moved[*j] = 1.0;
            let own = factor.follow(&moved).filter(|_| !unseen(columns[common[*j]])).unwrap_or_default();
            with.extend(own.into_iter().filter(|(_, weight)| weight.abs() > MEMBER).map(|(k, _)| columns[k]));
            groups.push(group(columns[common[*j]], with));
        }
        let mut kept = factor.own();
        kept.extend(found.basis.iter().map(|b| common[b.0]));
        if noise > 0.0 {
            groups.extend(useless(problem, (&factor, &columns), &norms, kept, noise));
        }
        Self { groups }
    }

    /// Indices of the parameters that are held.
    pub fn held(&self) -> Vec<usize> {
        self.groups.iter().map(|g| g.held).collect()
    }
}

/// Columns that are independent of the previous ones, by their orthonormal basis, and dependent
/// ones, each with its share of the independent ones.
struct Independent {
    basis: Vec<(usize, Vec<f64>)>,
    dependent: Vec<(usize, Vec<(usize, f64)>)>,
}

/// Relative difference below which effects are alike.
const ALIKE: f64 = 1e-6;

/// Takes columns by their `effect` relative to the previous ones, the largest first, and in their
/// order if the effect is infinite or alike.
fn independent(columns: &[Vec<f64>], unseen: impl Fn(usize) -> bool, effect: impl Fn(usize) -> f64) -> Independent {
    let mut found = Independent { basis: Vec::new(), dependent: Vec::new() };
    let mut left: Vec<usize> = (0..columns.len()).collect();
    while !left.is_empty() {
        let size = |&j: &usize| {
            let effect = effect(j);
            if effect.is_infinite() { effect } else { effect * norm(&split(&columns[j], &found.basis).1) }
        };
        let first = left.iter().enumerate().map(|(k, j)| (k, size(j)));
        let first = first.reduce(|a, b| if b.1 > a.1 * (1.0 + ALIKE) { b } else { a }).map_or(0, |first| first.0);
        let j = left.remove(first);
        let column = &columns[j];
        if unseen(j) {
            found.dependent.push((j, Vec::new()));
            continue;
        }
        let (shares, rest) = split(column, &found.basis);
        let distance = norm(&rest);
        if distance > RANK_TOLERANCE {
            found.basis.push((j, rest.into_iter().map(|v| v / distance).collect()));
            continue;
        }
        let weights = weights(&shares, &found.basis, columns);
        let members = found.basis.iter().map(|b| b.0).zip(weights).filter(|(_, w)| w.abs() > MEMBER);
        found.dependent.push((j, members.collect()));
    }
    found
}

fn norm(column: &[f64]) -> f64 {
    column.iter().map(|v| v * v).sum::<f64>().sqrt()
}

/// Removes from the columns `kept` of a factor those whose parameters would be less accurate than
/// before, the worst first.
fn useless(
    problem: &Residuals,
    (factor, columns): (&Factor, &[usize]),
    norms: &[f64],
    mut kept: Vec<usize>,
    noise: f64,
) -> Vec<Group> {
    let mut groups = Vec::new();
    let parameter = |column: usize| problem.free[columns[column]];
    loop {
        let Some(inverse) = factor.keeping(&kept).inverse_normal() else { return groups };
        let n = kept.len();
        let u = |k: usize| noise * inverse[k * n + k].sqrt() / norms[columns[kept[k]]];
        let excess = |k: usize| u(k) / problem.robot.parameters()[parameter(kept[k])].known_within();
        let worst = (0..n).filter(|&k| excess(k) > 1.0).max_by(|&a, &b| excess(a).total_cmp(&excess(b)));
        let Some(worst) = worst else { return groups };
        let correlation = |k: usize| inverse[worst * n + k] / (inverse[worst * n + worst] * inverse[k * n + k]).sqrt();
        groups.push(Group {
            held: parameter(kept[worst]),
            with: (0..n)
                .filter(|&k| k != worst && correlation(k).abs() > CORRELATED)
                .map(|k| parameter(kept[k]))
                .collect(),
            useless_uncertainty: Some(u(worst)),
        });
        kept.remove(worst);
    }
}

/// Components of `column` along the orthonormal `basis`, and the remainder (Gram-Schmidt, done
/// twice: Giraud et al. 2005).
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

/// This column as a sum of the columns of the basis: back substitution in their triangular matrix.
fn weights(shares: &[f64], basis: &[(usize, Vec<f64>)], columns: &[Vec<f64>]) -> Vec<f64> {
    let element = |i: usize, k: usize| -> f64 { basis[i].1.iter().zip(&columns[basis[k].0]).map(|(q, r)| q * r).sum() };
    let mut weights = shares.to_vec();
    for k in (0..basis.len()).rev() {
        weights[k] /= element(k, k);
        for i in 0..k {
            weights[i] -= element(i, k) * weights[k];
        }
    }
    weights
}
