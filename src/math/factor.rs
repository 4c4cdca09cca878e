//! Triangular factor of a tall matrix by Householder reflections, in blocks of rows.
//!
//! Each block fits in the cache and is factored separately (in parallel). The factors are stacked
//! in the order of the blocks, so the result is bit-identical for any number of threads
//! (tall-skinny QR: Demmel et al. 2012).

use super::blocks::{Head, OWN, Rows, with_heads};
use pulp::{Arch, Simd, WithSimd};
use rayon::prelude::*;

/// Number of rows per task; constant, so that the result does not depend on the number of threads.
const TASK_ROWS: usize = 1536;
/// Number of rows reduced at a time; with 50 columns they fit in the first-level cache.
const BLOCK_ROWS: usize = 96;

/// R and Qᵀb of a least-squares problem min ‖A x − b‖, with the residual sum of squares.
///
/// If columns of A form blocks, these columns come first, block by block, followed by the common
/// columns.
#[derive(Clone, Debug)]
pub struct Factor {
    /// Number of common columns of A; all columns if there are no blocks.
    n: usize,
    /// Upper triangular R of the common columns, column by column: n × n.
    r: Vec<f64>,
    /// Elements of Qᵀb, one per column of A.
    pub qtb: Vec<f64>,
    /// Residual sum of squares: sum of squares of the remaining elements of Qᵀb.
    pub rest: f64,
    /// Rows of the blocks, above R.
    heads: Vec<Head>,
    /// Common columns of A; empty if there are no blocks.
    common: Vec<usize>,
}

impl Factor {
    /// Factors `a` (m × n, row by row) with columns divided by `scale`, together with the
    /// right-hand side `b` (m).
    pub fn new(a: &[f64], b: &[f64], scale: &[f64]) -> Self {
        let n = scale.len();
        let inverse: Vec<f64> = scale.iter().map(|s| 1.0 / s).collect();
        let task = |(rows, b): (&[f64], &[f64])| {
            let mut factor = Self::zero(n);
            let mut columns = Vec::new();
            for (rows, b) in rows.chunks(BLOCK_ROWS * n.max(1)).zip(b.chunks(BLOCK_ROWS)) {
                let m = b.len();
                columns.resize(m * (n + 1), 0.0);
                for (j, column) in columns.chunks_exact_mut(m).take(n).enumerate() {
                    let elements = rows[j..].iter().step_by(n);
                    column.iter_mut().zip(elements).for_each(|(to, element)| *to = element * inverse[j]);
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

    /// `true` if all elements are finite.
    pub(crate) fn is_finite(&self) -> bool {
        let heads = self.heads.iter().flat_map(|head| head.rows.iter().flatten().chain(&head.qtb));
        self.qtb.iter().chain(&self.r).chain(heads).all(|x| x.is_finite())
    }

    /// Factor of a matrix without rows.
    fn zero(n: usize) -> Self {
        Self { n, r: vec![0.0; n * n], qtb: vec![0.0; n], rest: 0.0, heads: Vec::new(), common: Vec::new() }
    }

    /// Factor from normal equations by Cholesky decomposition. `normal` is AᵀA (n × n, row by row),
    /// whose columns are divided by `scale`; `right` is Aᵀb and `squares` is bᵀb. The condition
    /// number is squared, so the result is `None` if a pivot of the scaled matrix is below
    /// `least_pivot`.
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
        let mut factor = Self { r, ..Self::zero(n) };
        factor.qtb = factor.forward_substitute(right.iter().zip(scale).map(|(b, s)| b / s).collect())?;
        factor.rest = (squares - inner(&factor.qtb, &factor.qtb)).max(0.0);
        Some(factor)
    }

    /// Factor of the combined rows of `self` and `other`.
    pub fn stack(mut self, mut other: Self) -> Self {
        let n = self.n;
        other.r.extend_from_slice(&other.qtb);
        self.absorb(&mut other.r, n);
        self.rest += other.rest;
        self
    }

    /// Factor of the same rows without blocks, with columns divided by their norms, and the norms.
    pub fn normalised(mut self) -> (Self, Vec<f64>) {
        let norms = self.column_norms();
        for (column, norm) in self.r.chunks_exact_mut(self.n.max(1)).zip(&norms) {
            column.iter_mut().for_each(|r| *r /= norm);
        }
        (self, norms)
    }

    /// Adds `m` rows, stored column by column with the right-hand side last.
    fn absorb(&mut self, columns: &mut [f64], m: usize) {
        Arch::new().dispatch(Absorbing { factor: self, columns, m });
    }

    /// Householder reflections of [R; rows], where each column has a single element above the rows.
    #[inline(always)]
    fn reflect(&mut self, columns: &mut [f64], m: usize) {
        let n = self.n;
        for k in 0..n {
            let (head, tail) = columns.split_at_mut((k + 1) * m);
            let v = &head[k * m..];
            let top = self.r[k * n + k];
            let below = inner(v, v);
            // a subnormal square has no finite inverse
            if below < f64::MIN_POSITIVE {
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
                add(column, factor, v);
            }
        }
        let b = &columns[n * m..];
        self.rest += inner(b, b);
    }

    /// Splits off the first rows as the rows of a block with the columns `own`.
    pub(super) fn split(self, own: &[usize]) -> (Head, Self) {
        let (w, n) = (own.len(), self.n);
        let row = |i: usize| (0..n).map(|j| if i <= j { self.r(i, j) } else { 0.0 }).collect();
        let head = Head { columns: own.to_vec(), rows: (0..w).map(row).collect(), qtb: self.qtb[..w].to_vec() };
        let mut rest = Self::zero(n - w);
        for j in w..n {
            rest.r[(j - w) * (n - w)..][..n - w].copy_from_slice(&self.r[j * n + w..(j + 1) * n]);
        }
        rest.qtb.copy_from_slice(&self.qtb[w..]);
        rest.rest = self.rest;
        (head, rest)
    }

    /// Places this factor of the `common` columns below the rows of blocks.
    pub(super) fn under(mut self, heads: Vec<Head>, common: Vec<usize>) -> Self {
        let own = heads.iter().flat_map(|h| &h.qtb).copied();
        self.qtb = own.chain(self.qtb).collect();
        Self { heads, common, ..self }
    }

    /// Columns of A that R covers; all columns if there are no blocks.
    pub fn common(&self) -> Vec<usize> {
        if self.heads.is_empty() { (0..self.n).collect() } else { self.common.clone() }
    }

    /// Columns of blocks.
    pub fn block_columns(&self) -> Vec<usize> {
        self.heads.iter().flat_map(|head| head.columns.iter().copied()).collect()
    }

    /// Number of columns of A.
    pub fn columns(&self) -> usize {
        self.qtb.len()
    }

    /// Element of R of the common columns.
    pub fn r(&self, i: usize, j: usize) -> f64 {
        self.r[j * self.n + i]
    }

    /// Columns of each block with their triangular factor.
    pub fn blocks(&self) -> impl Iterator<Item = (&[usize], Vec<Vec<f64>>)> {
        self.heads.iter().map(|head| {
            let w = head.columns.len();
            (&head.columns[..], (0..w).map(|k| head.rows.iter().map(|row| row[k]).collect()).collect())
        })
    }

    /// Columns of blocks as functions of the common columns such that the rows of the blocks remain
    /// zero; `None` if a block is singular.
    pub fn follow(&self, common: &[f64]) -> Option<Vec<(usize, f64)>> {
        let mut own = Vec::new();
        for head in &self.heads {
            own.extend(head.columns.iter().copied().zip(head.back(&[0.0; OWN], common)?));
        }
        Some(own)
    }

    /// Norm of each column.
    pub fn column_norms(&self) -> Vec<f64> {
        let mut squares = vec![0.0; self.columns()];
        let common = self.common();
        for head in &self.heads {
            for row in &head.rows {
                head.columns.iter().chain(&common).zip(row).for_each(|(&j, v)| squares[j] += v * v);
            }
        }
        for (k, &j) in common.iter().enumerate() {
            squares[j] += (0..=k).map(|i| self.r(i, k).powi(2)).sum::<f64>();
        }
        squares.into_iter().map(f64::sqrt).collect()
    }

    /// Factor of the same rows with the columns `kept` only, without right-hand side; common
    /// columns are in the order of `kept`.
    pub fn keeping(&self, kept: &[usize]) -> Self {
        let at = |column: &usize| kept.iter().position(|j| j == column);
        let number: Vec<Option<usize>> = (0..self.columns()).map(|j| at(&j)).collect();
        let place: Vec<(usize, usize)> =
            self.common().iter().enumerate().filter_map(|(k, &j)| Some((number[j]?, k))).collect();
        let mut place = place;
        place.sort_unstable();
        let some = |n: usize, rows: &mut dyn Iterator<Item = Vec<f64>>| {
            let rows: Vec<f64> = rows.flatten().collect();
            Self::new(&rows, &vec![0.0; rows.len() / n.max(1)], &vec![1.0; n])
        };
        let element = |i: usize, k: usize| if i <= k { self.r(i, k) } else { 0.0 };
        let mut below = (0..self.n).map(|i| place.iter().map(|&(_, k)| element(i, k)).collect());
        let mut common = some(place.len(), &mut below);
        let mut heads = Vec::new();
        for head in &self.heads {
            let w = head.columns.len();
            let own: Vec<usize> = (0..w).filter(|&k| number[head.columns[k]].is_some()).collect();
            let take =
                |row: &Vec<f64>| own.iter().copied().chain(place.iter().map(|p| w + p.1)).map(|k| row[k]).collect();
            let columns: Vec<usize> = own.iter().filter_map(|&k| number[head.columns[k]]).collect();
            let (head, rest) = some(own.len() + place.len(), &mut head.rows.iter().map(take)).split(&columns);
            common = common.stack(rest);
            heads.push(head);
        }
        match heads.is_empty() {
            true => common,
            false => common.under(heads, place.into_iter().map(|p| p.0).collect()),
        }
    }

    /// Solves R x = Qᵀb; `None` if R is singular.
    pub fn solve(&self) -> Option<Vec<f64>> {
        self.back_substitute(self.qtb.clone())
    }

    /// Solves R x = b instead of `b`; `None` if R is singular.
    pub fn back_substitute(&self, mut b: Vec<f64>) -> Option<Vec<f64>> {
        let mut own = b;
        b = own.split_off(self.columns() - self.n);
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
        if self.heads.is_empty() {
            return Some(b);
        }
        let mut x = vec![0.0; self.columns()];
        let mut own = &own[..];
        for head in &self.heads {
            let (here, rest) = own.split_at(head.columns.len());
            own = rest;
            head.columns.iter().zip(head.back(here, &b)?).for_each(|(&j, v)| x[j] = v);
        }
        self.common.iter().zip(b).for_each(|(&j, v)| x[j] = v);
        Some(x)
    }

    /// Solves Rᵀ x = b instead of `b`; `None` if R is singular.
    pub fn forward_substitute(&self, mut b: Vec<f64>) -> Option<Vec<f64>> {
        let mut x = Vec::new();
        if !self.heads.is_empty() {
            let mut common: Vec<f64> = self.common.iter().map(|&j| b[j]).collect();
            for head in &self.heads {
                x.extend(head.forward(|j| b[j], &mut common)?);
            }
            b = common;
        }
        for j in 0..self.n {
            let known: f64 = (0..j).map(|i| self.r(i, j) * b[i]).sum();
            b[j] = (b[j] - known) / self.r(j, j);
            if !b[j].is_finite() {
                return None;
            }
        }
        x.extend(b);
        Some(x)
    }

    /// Product R x.
    pub fn multiply(&self, x: &[f64]) -> Vec<f64> {
        let common = self.common();
        let of_row = |(columns, row): (&[usize], &Vec<f64>)| -> f64 {
            columns.iter().chain(&common).zip(row).map(|(&j, r)| r * x[j]).sum()
        };
        let own = self.heads.iter().flat_map(|head| head.rows.iter().map(|row| (&head.columns[..], row)));
        let below = |i: usize| (i..self.n).map(|j| self.r(i, j) * x[common[j]]).sum::<f64>();
        own.map(of_row).chain((0..self.n).map(below)).collect()
    }

    /// Product Rᵀ x.
    pub fn multiply_transposed(&self, x: &[f64]) -> Vec<f64> {
        let common = self.common();
        let (own, below) = x.split_at(self.columns() - self.n);
        let mut product = vec![0.0; self.columns()];
        for (j, &column) in common.iter().enumerate() {
            product[column] = (0..=j).map(|i| self.r(i, j) * below[i]).sum();
        }
        let rows = self.heads.iter().flat_map(|head| head.rows.iter().map(|row| (&head.columns, row)));
        for ((columns, row), x) in rows.zip(own) {
            columns.iter().chain(&common).zip(row).for_each(|(&j, r)| product[j] += r * x);
        }
        product
    }

    /// Returns the descent step −(RᵀR)⁻¹ Jᵀr in unscaled parameters for another Jacobian and its
    /// residuals; its columns are divided by `scale` as for this factor. `None` if R is singular.
    pub fn solve_normal(&self, jacobian: Rows, residuals: &[f64], scale: &[f64]) -> Option<Vec<f64>> {
        let g = jacobian.transposed_times::<1>(residuals);
        let g = self.forward_substitute(g.iter().zip(scale).map(|([g], d)| -g / d).collect())?;
        let mut step = self.back_substitute(g)?;
        step.iter_mut().zip(scale).for_each(|(s, d)| *s /= d);
        Some(step)
    }

    /// Factor with `damping` · I appended: the Levenberg-Marquardt step.
    pub fn damped(&self, damping: f64) -> Self {
        let n = self.n;
        let mut r = vec![0.0; n * n];
        for j in 0..n {
            r[j * n + j] = damping;
        }
        let own = self.columns() - n;
        let dense = Self { qtb: self.qtb[own..].to_vec(), heads: Vec::new(), common: Vec::new(), ..self.clone() };
        let mut common = dense.stack(Self { r, ..Self::zero(n) });
        if self.heads.is_empty() {
            return common;
        }
        let mut heads = Vec::with_capacity(self.heads.len());
        for head in &self.heads {
            let w = head.columns.len();
            let mut rows = head.rows.concat();
            for i in 0..w {
                rows.extend((0..w + n).map(|j| if i == j { damping } else { 0.0 }));
            }
            let b: Vec<f64> = head.qtb.iter().copied().chain(std::iter::repeat_n(0.0, w)).collect();
            let (head, rest) = Self::new(&rows, &b, &vec![1.0; w + n]).split(&head.columns);
            heads.push(head);
            common = common.stack(rest);
        }
        common.under(heads, self.common.clone())
    }

    /// (RᵀR)⁻¹ of all columns, row by row; `None` if R is singular.
    pub fn inverse_normal(&self) -> Option<Vec<f64>> {
        self.covariance_with(self.common_inverse()?, 1.0)
    }

    /// Covariance of all columns, row by row, where `of_common` is the covariance of the common
    /// columns and the rows of blocks have the given `variance`.
    pub fn covariance_with(&self, of_common: Vec<f64>, variance: f64) -> Option<Vec<f64>> {
        if self.heads.is_empty() {
            Some(of_common)
        } else {
            with_heads(&self.heads, &self.common, &of_common, variance)
        }
    }

    /// R⁻¹ of the common columns, column by column; `None` if their R is singular.
    pub fn common_root(&self) -> Option<Vec<f64>> {
        let n = self.n;
        let dense = Self { qtb: vec![0.0; n], heads: Vec::new(), common: Vec::new(), ..self.clone() };
        let mut inverse = vec![0.0; n * n];
        for j in 0..n {
            let mut e = vec![0.0; n];
            e[j] = 1.0;
            inverse[j * n..][..n].copy_from_slice(&dense.back_substitute(e)?);
        }
        Some(inverse)
    }

    /// (RᵀR)⁻¹ of the common columns, row by row; `None` if their R is singular.
    pub fn common_inverse(&self) -> Option<Vec<f64>> {
        let n = self.n;
        let inverse = self.common_root()?;
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

/// Rows on their way into a factor.
///
/// A type of its own, because a closure that borrows what it changes is called through a function
/// that the compiler does not inline: it would be compiled without the instructions of the machine.
struct Absorbing<'a> {
    factor: &'a mut Factor,
    columns: &'a mut [f64],
    m: usize,
}

impl WithSimd for Absorbing<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        self.factor.reflect(self.columns, self.m);
    }
}

/// Dot product in eight partial sums: a fixed order that vectorises.
#[inline(always)]
fn inner(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; 8];
    let ((a8, a), (b8, b)) = (a.as_chunks::<8>(), b.as_chunks::<8>());
    for k in 0..a8.len().min(b8.len()) {
        for i in 0..8 {
            sums[i] += a8[k][i] * b8[k][i];
        }
    }
    let mut tail = 0.0;
    for k in 0..a.len().min(b.len()) {
        tail += a[k] * b[k];
    }
    let mut sum = 0.0;
    for part in sums {
        sum += part;
    }
    sum + tail
}

/// Adds a multiple of `v` to `to`.
#[inline(always)]
pub(super) fn add(to: &mut [f64], factor: f64, v: &[f64]) {
    for k in 0..to.len().min(v.len()) {
        to[k] += factor * v[k];
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_give_the_least_squares_solution() {
        // exact solution (1, −2, 3) with a residual orthogonal to the columns, over several blocks
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
