//! Linear Chebyshev problem in any number of variables: step δ that minimises the spread of d + g·δ
//! over all rows.
//!
//! The problem is a linear program in δ and the upper and lower level: minimise u − l, subject to u
//! ≥ d + g·δ ≥ l for every row. The dual simplex method (Lemke 1954) keeps non-negative multipliers
//! and adds the most violated row, so that many rows cost only one pass. The final multipliers are
//! the proof (Karush-Kuhn-Tucker): they sum to one over the upper rows and over the lower rows, and
//! the weighted mean gradients of both sides are equal.

use etalon_math::{Factor, svd};
use nalgebra::{DMatrix, DVector};

/// Gradient and value of a row.
pub(crate) type Row<const N: usize> = ([f64; N], f64);

/// Solution of the linear problem.
pub(crate) struct Step<const N: usize> {
    pub step: [f64; N],
    /// Largest minus smallest value after the step, over the rows that determine it.
    pub spread: f64,
}

/// Constraint of the program.
#[derive(Clone, Copy, PartialEq)]
enum Bound {
    Upper(usize),
    Lower(usize),
    /// Bound of a component of the step by the reach: lower bound if `true`, otherwise upper bound.
    Box(usize, bool),
}

/// Maximum number of swaps; tens suffice in practice.
const EXCHANGES: usize = 400;
/// Tolerance for a row beyond its level, relative to the largest value: rounding.
const BEYOND: f64 = 4.0 * f64::EPSILON;

/// Finds the best step with components of at most `reach`; `None` without rows.
pub(crate) fn best_step<const N: usize>(rows: &[Row<N>], reach: f64) -> Option<Step<N>> {
    if rows.is_empty() {
        return None;
    }
    let size = rows.iter().fold(reach, |m, row| m.max(row.1.abs()));
    // one row as both levels and a corner of the box: multipliers 1, 1 and 0
    let mut basis = vec![Bound::Upper(0), Bound::Lower(0)];
    basis.extend((0..N).map(|k| Bound::Box(k, true)));
    let mut best = None;
    for _ in 0..EXCHANGES {
        let (matrix, right) = program(rows, &basis, reach);
        let solver = matrix.lu();
        let Some(x) = solver.solve(&right) else { break };
        let step: [f64; N] = std::array::from_fn(|k| x[k]);
        best = Some(Step { step, spread: x[N] - x[N + 1] });
        let (enters, beyond) = most_violated(rows, &step, [x[N], x[N + 1]], reach);
        if beyond <= BEYOND * size || basis.contains(&enters) {
            break;
        }
        let Some(leaves) = leaving(rows, &basis, enters, reach) else { break };
        basis[leaves] = enters;
    }
    best
}

/// Coefficients and right-hand side of a constraint: a x ≥ b for x = (δ, upper, lower).
fn coefficients<const N: usize>(rows: &[Row<N>], bound: Bound, reach: f64) -> (Vec<f64>, f64) {
    let mut a = vec![0.0; N + 2];
    let b = match bound {
        Bound::Upper(i) => {
            a.iter_mut().zip(rows[i].0).for_each(|(a, g)| *a = -g);
            a[N] = 1.0;
            rows[i].1
        }
        Bound::Lower(i) => {
            a.iter_mut().zip(rows[i].0).for_each(|(a, g)| *a = g);
            a[N + 1] = -1.0;
            -rows[i].1
        }
        Bound::Box(k, least) => {
            a[k] = if least { 1.0 } else { -1.0 };
            -reach
        }
    };
    (a, b)
}

fn program<const N: usize>(rows: &[Row<N>], basis: &[Bound], reach: f64) -> (DMatrix<f64>, DVector<f64>) {
    let mut matrix = DMatrix::zeros(basis.len(), N + 2);
    let mut right = DVector::zeros(basis.len());
    for (i, &bound) in basis.iter().enumerate() {
        let (a, b) = coefficients(rows, bound, reach);
        right[i] = b;
        a.iter().enumerate().for_each(|(k, a)| matrix[(i, k)] = *a);
    }
    (matrix, right)
}

/// Most violated constraint, and its violation.
fn most_violated<const N: usize>(rows: &[Row<N>], step: &[f64; N], levels: [f64; 2], reach: f64) -> (Bound, f64) {
    let [upper, lower] = levels;
    let mut worst = (Bound::Upper(0), f64::NEG_INFINITY);
    for (i, row) in rows.iter().enumerate() {
        let v = row.0.iter().zip(step).fold(row.1, |v, (g, s)| v + g * s);
        if v - upper > worst.1 {
            worst = (Bound::Upper(i), v - upper);
        }
        if lower - v > worst.1 {
            worst = (Bound::Lower(i), lower - v);
        }
    }
    for (k, s) in step.iter().enumerate() {
        if s.abs() - reach > worst.1 {
            worst = (Bound::Box(k, *s < 0.0), s.abs() - reach);
        }
    }
    worst
}

/// Position of the constraint whose multiplier vanishes first as the multiplier of `enters` grows;
/// among ties the one with the largest pivot.
fn leaving<const N: usize>(rows: &[Row<N>], basis: &[Bound], enters: Bound, reach: f64) -> Option<usize> {
    let (matrix, _) = program(rows, basis, reach);
    let solver = matrix.transpose().lu();
    let multipliers = solver.solve(&objective(N + 2))?;
    let pivots = solver.solve(&DVector::from_vec(coefficients(rows, enters, reach).0))?;
    let ratio = |i: usize| multipliers[i].max(0.0) / pivots[i];
    let possible = (0..basis.len()).filter(|&i| pivots[i] > 1e-11);
    let least = possible.clone().map(ratio).fold(f64::INFINITY, f64::min);
    possible.filter(|&i| ratio(i) <= least + 1e-14).max_by(|&i, &j| pivots[i].total_cmp(&pivots[j]))
}

/// Gradient of upper minus lower level with respect to the `n` unknowns, the last two of which are
/// the levels.
fn objective(n: usize) -> DVector<f64> {
    let mut c = DVector::zeros(n);
    c[n - 2] = 1.0;
    c[n - 1] = -1.0;
    c
}

/// Multipliers of the rows at the two levels that prove a minimum to first order.
#[derive(Debug)]
pub(crate) struct Certificate {
    pub upper: Vec<f64>,
    pub lower: Vec<f64>,
    /// Smallest growth of the spread per unit length of a step, over all directions.
    pub growth: f64,
}

/// Maximum number of contacts for which multipliers are computed.
const TOGETHER: usize = 200;
/// Minimum multiplier that counts as positive.
const POSITIVE: f64 = 1e-9;

/// Minimum-norm λ with Aᵀ λ = c, which treats equal rows equally, and smallest singular value of A;
/// `None` if the rows do not span all directions.
fn shortest_multipliers(matrix: &DMatrix<f64>) -> Option<(Vec<f64>, f64)> {
    let (count, n) = matrix.shape();
    let flat: Vec<f64> = matrix.row_iter().flat_map(|row| row.iter().copied().collect::<Vec<_>>()).collect();
    let decomposed = svd(&Factor::new(&flat, &vec![0.0; count], &vec![1.0; n]));
    let sigma = decomposed.values.last().copied()?;
    if sigma < POSITIVE {
        return None;
    }
    let mut multipliers = DVector::zeros(count);
    // the second pass corrects rounding
    for _ in 0..2 {
        let missed = objective(n) - matrix.transpose() * &multipliers;
        let mut x = DVector::zeros(n);
        for (v, s) in decomposed.vectors.iter().zip(&decomposed.values) {
            let v = DVector::from_column_slice(v);
            x += &v * (v.dot(&missed) / (s * s));
        }
        multipliers += matrix * x;
    }
    let missed = (objective(n) - matrix.transpose() * &multipliers).norm();
    (missed <= 1e-12).then(|| (multipliers.iter().copied().collect(), sigma))
}

/// Positive multipliers that sum to one on each side, with equal mean gradients and rows that span
/// all directions. The spread then grows in every direction by at least λ σ, where λ is the
/// smallest multiplier and σ the smallest singular value of the rows. (For a feasible step y of
/// step and levels, c·y = Σ λ (A y) ≥ λ |A y| ≥ λ σ |y|.) `None` if no such multipliers exist.
pub(crate) fn certificate<const N: usize>(upper: &[[f64; N]], lower: &[[f64; N]]) -> Option<Certificate> {
    let rows: Vec<Row<N>> = upper.iter().chain(lower).map(|g| (*g, 0.0)).collect();
    if upper.is_empty() || lower.is_empty() || rows.len() > TOGETHER {
        return None;
    }
    let bound = |i: usize| if i < upper.len() { Bound::Upper(i) } else { Bound::Lower(i) };
    let mut kept: Vec<usize> = (0..rows.len()).collect();
    while kept.len() >= N + 2 {
        let basis: Vec<Bound> = kept.iter().map(|&i| bound(i)).collect();
        let (multipliers, sigma) = shortest_multipliers(&program(&rows, &basis, 1.0).0)?;
        let (least_at, least) =
            multipliers.iter().enumerate().fold((0, f64::INFINITY), |m, (i, l)| if *l < m.1 { (i, *l) } else { m });
        if least > POSITIVE {
            let mut all = vec![0.0; rows.len()];
            kept.iter().zip(multipliers.iter()).for_each(|(&i, l)| all[i] = *l);
            let lower = all.split_off(upper.len());
            return Some(Certificate { upper: all, lower, growth: least * sigma });
        }
        kept.remove(least_at);
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_base::noise::Noise;

    #[test]
    fn the_step_of_two_variables_is_that_of_all_fours() {
        for trial in 0..200 {
            let mut noise = Noise::new(5, trial);
            let rows: Vec<Row<2>> =
                (0..30).map(|_| ([noise.gaussian(1.0), noise.gaussian(1.0)], noise.gaussian(1.0))).collect();
            let flat: Vec<[f64; 3]> = rows.iter().map(|(g, d)| [g[0], g[1], *d]).collect();
            let expected = crate::chebyshev::least_spread(&flat, f64::INFINITY).unwrap();
            let found = best_step(&rows, 1e3).unwrap();
            assert!((found.spread - expected.spread).abs() < 1e-12, "{} {}", found.spread, expected.spread);
        }
    }

    #[test]
    fn no_multipliers_where_a_direction_is_free_or_the_spread_falls() {
        // upper (±1, 0), lower (0, ±1): the growth is the distance of zero from the square (±1, ±1)
        let crossing = certificate(&[[1.0, 0.0], [-1.0, 0.0]], &[[0.0, 1.0], [0.0, -1.0]]).unwrap();
        assert!(crossing.growth > 0.0 && crossing.growth <= 1.0, "{crossing:?}");
        assert!(crossing.upper.iter().chain(&crossing.lower).all(|l| (l - 0.5).abs() < 1e-15), "{crossing:?}");
        assert!(certificate(&[[1.0, 0.0], [2.0, 0.0]], &[[0.0, 1.0], [0.0, -1.0]]).is_none());
        assert!(certificate(&[[1.0, 0.0], [-1.0, 0.0]], &[[2.0, 0.0], [-2.0, 0.0]]).is_none());
    }
}
