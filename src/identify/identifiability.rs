//! Which parameters the data can tell apart: rank of the scaled Jacobian, and names for its null space.

use super::residuals::Residuals;
use crate::solve::{Factor, Problem, Svd, column_norms, svd};

/// Singular values of the scaled Jacobian below this fraction of the largest are zero: far above rounding (1e-15),
/// far below the condition that any useful set of poses has (about 100: Schröer, cited in Nahvi & Hollerbach 1996).
pub const RANK_TOLERANCE: f64 = 1e-9;
/// A column below this fraction of the largest is not seen by the data.
const UNSEEN: f64 = 1e-12;
/// Share of a null vector above which a parameter belongs to the group.
const MEMBER: f64 = 1e-4;

/// Parameters that the data cannot tell apart; the last of them is held.
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    /// Index of the parameter that is held at its nominal value.
    pub held: usize,
    /// Indices of the parameters it cannot be told apart from; empty where the data do not see `held` at all.
    pub with: Vec<usize>,
}

/// Rank and groups at one set of parameter values.
pub(super) struct Analysis {
    pub groups: Vec<Group>,
}

impl Analysis {
    /// Analyses the Jacobian of `problem` at `values` (all parameters of the robot).
    pub fn at(problem: &Residuals, values: &[f64]) -> Self {
        let free = &problem.free;
        let n = free.len();
        let m = problem.residual_count();
        let x: Vec<f64> = free.iter().map(|&i| values[i]).collect();
        let mut jacobian = vec![0.0; m * n];
        problem.jacobian(&x, &mut jacobian);
        let norms = column_norms(&jacobian, n);
        let is_seen = |j: &usize| jacobian.iter().skip(*j).step_by(n).any(|v| v.abs() > 0.0);
        let largest = (0..n).filter(is_seen).map(|j| norms[j]).fold(0.0, f64::max);
        let (seen, unseen): (Vec<usize>, Vec<usize>) =
            (0..n).partition(|j| is_seen(j) && norms[*j] > UNSEEN * largest);
        let reduced: Vec<f64> = jacobian.chunks_exact(n.max(1)).flat_map(|row| seen.iter().map(|&j| row[j])).collect();
        let scale: Vec<f64> = seen.iter().map(|&j| norms[j]).collect();
        let decomposition = svd(&Factor::new(&reduced, &vec![0.0; m], &scale));
        let mut groups: Vec<Group> = null_groups(&decomposition)
            .into_iter()
            .map(|g| Group { held: free[seen[g.held]], with: g.with.iter().map(|&k| free[seen[k]]).collect() })
            .collect();
        groups.extend(unseen.into_iter().map(|j| Group { held: free[j], with: Vec::new() }));
        groups.sort_by_key(|g| g.held);
        Self { groups }
    }

    /// Indices of the parameters that are held.
    pub fn held(&self) -> Vec<usize> {
        self.groups.iter().map(|g| g.held).collect()
    }
}

/// One group per null vector, in echelon form from the last parameter: each group holds a parameter of its own.
fn null_groups(decomposition: &Svd) -> Vec<Group> {
    let rank = decomposition.rank(RANK_TOLERANCE);
    let mut rows: Vec<Vec<f64>> = decomposition.vectors[rank..].to_vec();
    let n = decomposition.vectors.len();
    let mut done = 0;
    let mut pivots = Vec::new();
    for column in (0..n).rev() {
        let Some(best) = (done..rows.len()).max_by(|&i, &j| rows[i][column].abs().total_cmp(&rows[j][column].abs()))
        else {
            break;
        };
        if rows[best][column].abs() < MEMBER {
            continue;
        }
        rows.swap(done, best);
        let pivot = rows[done].clone();
        for (i, row) in rows.iter_mut().enumerate() {
            let factor = if i == done { 1.0 - 1.0 / pivot[column] } else { row[column] / pivot[column] };
            for (value, p) in row.iter_mut().zip(&pivot) {
                *value -= factor * p;
            }
        }
        pivots.push(column);
        done += 1;
    }
    let group = |(row, &held): (&Vec<f64>, &usize)| Group {
        held,
        with: (0..n).filter(|&k| k != held && row[k].abs() > MEMBER).collect(),
    };
    rows.iter().zip(&pivots).map(group).collect()
}
