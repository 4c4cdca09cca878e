//! The triangular factor of a tall matrix by Householder reflections, block of rows by block of rows.
//!
//! Each block fits in the cache and is factored on its own (in parallel); the factors are stacked in the order of
//! the blocks, so the result has the same bytes for any number of threads (tall-skinny QR: Demmel et al. 2012).

use rayon::prelude::*;

/// Rows that one thread takes: fixed, so that the result does not depend on the number of threads.
const TASK_ROWS: usize = 1536;
/// Rows reduced at a time: with 50 columns they stay in the fastest cache.
const BLOCK_ROWS: usize = 96;

/// R and Qᵀb of a least-squares problem min ‖A x − b‖, with the sum of squares that no x removes.
#[derive(Clone, Debug)]
pub struct Factor {
    /// Number of columns of A.
    pub n: usize,
    /// Upper triangular R, column by column: n × n.
    r: Vec<f64>,
    /// The first n elements of Qᵀb.
    pub qtb: Vec<f64>,
    /// Sum of squares of the rest of Qᵀb.
    pub rest: f64,
}

impl Factor {
    /// Factors `a` (m × n, row by row) with its columns divided by `scale`, beside the right-hand side `b` (m).
    pub fn new(a: &[f64], b: &[f64], scale: &[f64]) -> Self {
        let n = scale.len();
        let inverse: Vec<f64> = scale.iter().map(|s| 1.0 / s).collect();
        let task = |(rows, b): (&[f64], &[f64])| {
            let mut factor = Self::zero(n);
            let mut columns = Vec::new();
            for (rows, b) in rows.chunks(BLOCK_ROWS * n.max(1)).zip(b.chunks(BLOCK_ROWS)) {
                let m = b.len();
                columns.clear();
                columns.resize(m * (n + 1), 0.0);
                for (i, row) in rows.chunks_exact(n).enumerate() {
                    for j in 0..n {
                        columns[j * m + i] = row[j] * inverse[j];
                    }
                }
                columns[n * m..].copy_from_slice(b);
                factor.absorb(&mut columns, m);
            }
            factor
        };
        let tasks: Vec<Self> = if b.len() <= TASK_ROWS {
            vec![task((a, b))]
        } else {
            a.par_chunks(TASK_ROWS * n.max(1)).zip(b.par_chunks(TASK_ROWS)).map(task).collect()
        };
        tasks.into_iter().reduce(Self::stack).unwrap_or_else(|| Self::zero(n))
    }

    /// The factor of no rows.
    fn zero(n: usize) -> Self {
        Self { n, r: vec![0.0; n * n], qtb: vec![0.0; n], rest: 0.0 }
    }

    /// The factor of the same problem from its normal equations by Cholesky: `normal` is AᵀA (n × n, row by row), with
    /// its columns divided by `scale`, `right` is Aᵀb and `squares` bᵀb. Half the digits are lost that the condition of A takes, so
    /// `None` where a pivot of the scaled matrix falls below `least_pivot`.
    pub fn from_normal(normal: &[f64], right: &[f64], squares: f64, scale: &[f64], least_pivot: f64) -> Option<Self> {
        let n = scale.len();
        let mut r = vec![0.0; n * n];
        for j in 0..n {
            for i in 0..=j {
                let known: f64 = (0..i).map(|k| r[i * n + k] * r[j * n + k]).sum();
                let left = normal[i * n + j] / scale[i] / scale[j] - known;
                if i < j {
                    r[j * n + i] = left / r[i * n + i];
                } else if left >= least_pivot {
                    r[j * n + j] = left.sqrt();
                } else {
                    return None;
                }
            }
        }
        let mut factor = Self { n, r, qtb: Vec::new(), rest: 0.0 };
        factor.qtb = factor.forward_substitute(right.iter().zip(scale).map(|(b, s)| b / s).collect())?;
        factor.rest = (squares - inner(&factor.qtb, &factor.qtb)).max(0.0);
        Some(factor)
    }

    /// The factor of the rows behind `self` and of those behind `other`.
    pub(crate) fn stack(mut self, mut other: Self) -> Self {
        let n = self.n;
        other.r.extend_from_slice(&other.qtb);
        self.absorb(&mut other.r, n);
        self.rest += other.rest;
        self
    }

    /// Takes up `m` more rows, given column by column with the right-hand side last: Householder reflections of
    /// [R; rows], in which the part above the rows is one element a column.
    fn absorb(&mut self, columns: &mut [f64], m: usize) {
        let n = self.n;
        for k in 0..n {
            let (head, tail) = columns.split_at_mut((k + 1) * m);
            let v = &head[k * m..];
            let top = self.r[k * n + k];
            let below = inner(v, v);
            if below == 0.0 {
                continue;
            }
            let length = (top * top + below).sqrt();
            let alpha = if top > 0.0 { -length } else { length };
            let v0 = top - alpha;
            let beta = -1.0 / (alpha * v0);
            self.r[k * n + k] = alpha;
            for (j, column) in (k + 1..).zip(tail.chunks_exact_mut(m)) {
                let above = if j < n { &mut self.r[j * n + k] } else { &mut self.qtb[k] };
                let factor = -beta * (*above * v0 + inner(v, column));
                *above += factor * v0;
                for (c, v) in column.iter_mut().zip(v) {
                    *c += factor * v;
                }
            }
        }
        let b = &columns[n * m..];
        self.rest += inner(b, b);
    }

    /// Element of R.
    pub fn r(&self, i: usize, j: usize) -> f64 {
        self.r[j * self.n + i]
    }

    /// Solves R x = Qᵀb; `None` where R is singular.
    pub fn solve(&self) -> Option<Vec<f64>> {
        self.back_substitute(self.qtb.clone())
    }

    /// Solves R x = b in place of `b`; `None` where R is singular.
    pub fn back_substitute(&self, mut b: Vec<f64>) -> Option<Vec<f64>> {
        for j in (0..self.n).rev() {
            let pivot = self.r(j, j);
            b[j] /= pivot;
            if pivot == 0.0 || !b[j].is_finite() {
                return None;
            }
            let x = b[j];
            for (b, r) in b[..j].iter_mut().zip(&self.r[j * self.n..]) {
                *b -= r * x;
            }
        }
        Some(b)
    }

    /// Solves Rᵀ x = b in place of `b`; `None` where R is singular.
    pub fn forward_substitute(&self, mut b: Vec<f64>) -> Option<Vec<f64>> {
        for j in 0..self.n {
            let known: f64 = (0..j).map(|i| self.r(i, j) * b[i]).sum();
            b[j] = (b[j] - known) / self.r(j, j);
            if !b[j].is_finite() {
                return None;
            }
        }
        Some(b)
    }

    /// R x.
    pub fn multiply(&self, x: &[f64]) -> Vec<f64> {
        (0..self.n).map(|i| (i..self.n).map(|j| self.r(i, j) * x[j]).sum()).collect()
    }

    /// Rᵀ x.
    pub fn multiply_transposed(&self, x: &[f64]) -> Vec<f64> {
        (0..self.n).map(|j| (0..=j).map(|i| self.r(i, j) * x[i]).sum()).collect()
    }

    /// The descent step −(RᵀR)⁻¹ Jᵀr for another Jacobian (row by row, columns divided by `scale` as this factor's
    /// were) and its residuals, in unscaled parameters; `None` where R is singular.
    pub fn solve_normal(&self, jacobian: &[f64], residuals: &[f64], scale: &[f64]) -> Option<Vec<f64>> {
        let mut g = vec![0.0; self.n];
        for (row, r) in jacobian.chunks_exact(self.n).zip(residuals) {
            for (g, j) in g.iter_mut().zip(row) {
                *g -= j * r;
            }
        }
        g.iter_mut().zip(scale).for_each(|(g, d)| *g /= d);
        let g = self.forward_substitute(g)?;
        let mut step = self.back_substitute(g)?;
        step.iter_mut().zip(scale).for_each(|(s, d)| *s /= d);
        Some(step)
    }

    /// The factor of the same problem with `damping` · I below it: the Levenberg-Marquardt step.
    pub fn damped(&self, damping: f64) -> Self {
        let n = self.n;
        let mut r = vec![0.0; n * n];
        for j in 0..n {
            r[j * n + j] = damping;
        }
        self.clone().stack(Self { r, ..Self::zero(n) })
    }

    /// (RᵀR)⁻¹ row by row, n × n; `None` where R is singular.
    pub fn inverse_normal(&self) -> Option<Vec<f64>> {
        let n = self.n;
        let mut inverse = vec![0.0; n * n]; // column by column: R⁻¹
        for j in 0..n {
            let mut e = vec![0.0; n];
            e[j] = 1.0;
            inverse[j * n..][..n].copy_from_slice(&self.back_substitute(e)?);
        }
        let mut product = vec![0.0; n * n];
        for i in 0..n {
            for j in i..n {
                let value: f64 = (j..n).map(|k| inverse[k * n + i] * inverse[k * n + j]).sum();
                product[i * n + j] = value;
                product[j * n + i] = value;
            }
        }
        Some(product)
    }
}

/// Scalar product in eight running sums: a fixed order that vectorises.
fn inner(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; 8];
    let (a8, b8) = (a.chunks_exact(8), b.chunks_exact(8));
    let tail: f64 = a8.remainder().iter().zip(b8.remainder()).map(|(x, y)| x * y).sum();
    for (x, y) in a8.zip(b8) {
        for i in 0..8 {
            sums[i] += x[i] * y[i];
        }
    }
    sums.iter().sum::<f64>() + tail
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_give_the_least_squares_solution() {
        // exact solution (1, -2, 3) with a residual orthogonal to the columns, over several blocks
        let m = 3 * TASK_ROWS + BLOCK_ROWS + 17;
        let (mut a, mut b) = (Vec::new(), Vec::new());
        for i in 0..m {
            let t = i as f64 / m as f64;
            let row = [1.0, t, (7.0 * t).sin()];
            a.extend(row);
            b.push(row[0] - 2.0 * row[1] + 3.0 * row[2]);
        }
        let factor = Factor::new(&a, &b, &[2.0, 1.0, 0.5]);
        let x = factor.solve().unwrap();
        for (x, expected) in x.iter().zip([2.0, -2.0, 1.5]) {
            assert!((x - expected).abs() < 1e-12, "{x} {expected}");
        }
        assert!(factor.rest < 1e-20);
        let product: f64 = (0..3).map(|k| factor.r(k, 0) * factor.r(k, 0)).sum();
        assert!((product - m as f64 / 4.0).abs() < 1e-9);
    }

    #[test]
    fn normal_equations_give_the_same_factor() {
        let rows = [[1.0, 2.0], [3.0, -1.0], [0.5, 4.0], [2.0, 2.5]];
        let (b, scale) = ([1.0, -2.0, 0.5, 3.0], [2.0, 4.0]);
        let column = |j: usize| rows.map(|row| row[j]);
        let normal: Vec<f64> = (0..4).map(|k| inner(&column(k / 2), &column(k % 2))).collect();
        let right = [inner(&column(0), &b), inner(&column(1), &b)];
        let cholesky = Factor::from_normal(&normal, &right, inner(&b, &b), &scale, 1e-9).unwrap();
        let householder = Factor::new(rows.as_flattened(), &b, &scale);
        for (x, y) in cholesky.solve().unwrap().iter().zip(householder.solve().unwrap()) {
            assert!((x - y).abs() < 1e-15, "{x} {y}");
        }
        assert!((cholesky.rest - householder.rest).abs() < 1e-14);
        assert!(Factor::from_normal(&[1.0, 1.0, 1.0, 1.0], &[0.0; 2], 0.0, &[1.0; 2], 1e-9).is_none());
    }

    #[test]
    fn a_zero_column_is_singular_and_not_a_panic() {
        let factor = Factor::new(&[1.0, 0.0, 2.0, 0.0, 3.0, 0.0], &[1.0, 1.0, 1.0], &[1.0, 1.0]);
        assert!(factor.solve().is_none() && factor.inverse_normal().is_none());
    }
}
