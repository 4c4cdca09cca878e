//! Jacobians in which most columns occur in few rows only, such as the coordinates of a target,
//! which occur only in the rows of this target.
//!
//! Such columns form blocks. The rows of a block are factored with the columns of the block first;
//! the remaining rows depend on the common columns only (Triggs et al. 2000, "Bundle adjustment - a
//! modern synthesis", 6.1; with orthogonal factors instead of normal equations, which preserves
//! accuracy). Memory and time grow linearly with the number of blocks.

use super::Factor;
use rayon::prelude::*;

/// Maximum number of columns of a block: the coordinates of a point.
pub const OWN: usize = 3;
/// Number of blocks per task; constant, so that the result does not depend on the number of
/// threads.
const TASK_BLOCKS: usize = 16;

/// Assignment of columns and rows to blocks.
///
/// A row of such a Jacobian has [`OWN`] numbers for its block, padded with zeros, followed by the
/// common columns.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Blocks {
    /// Columns that may occur in any row.
    pub common: Vec<usize>,
    /// Columns of each block, at most [`OWN`].
    pub own: Vec<Vec<usize>>,
    /// Block of each row.
    pub of_row: Vec<Option<usize>>,
}

impl Blocks {
    /// Number of elements of a row.
    pub fn width(&self) -> usize {
        OWN + self.common.len()
    }

    /// Block and position of a column in a row; the block is `None` for common columns.
    pub fn column_place(&self, column: usize) -> Option<(Option<usize>, usize)> {
        let of = |(block, own): (usize, &Vec<usize>)| Some((Some(block), own.iter().position(|&j| j == column)?));
        let common = || Some((None, OWN + self.common.iter().position(|&j| j == column)?));
        self.own.iter().enumerate().find_map(of).or_else(common)
    }

    /// Adds one row for each of `columns`, with that column as its only entry.
    pub fn with_single_rows(&self, columns: impl Iterator<Item = usize>) -> Self {
        let mut with = self.clone();
        with.of_row.extend(columns.map(|j| self.column_place(j).and_then(|place| place.0)));
        with
    }
}

/// Rows of a Jacobian with `n` columns, one after the other.
#[derive(Clone, Copy, Debug)]
pub struct Rows<'a> {
    /// Elements of the rows.
    pub numbers: &'a [f64],
    /// Number of columns.
    pub n: usize,
    /// Storage of the rows; `None` if all columns are stored.
    pub blocks: Option<&'a Blocks>,
}

impl<'a> Rows<'a> {
    /// Number of elements of a row.
    pub fn width(&self) -> usize {
        self.blocks.map_or(self.n, Blocks::width)
    }

    /// Elements of each row, with their columns.
    fn entries(&self) -> impl Iterator<Item = impl Iterator<Item = (usize, f64)> + 'a> + 'a {
        let (blocks, n) = (self.blocks, self.n);
        self.numbers.chunks_exact(self.width().max(1)).enumerate().map(move |(i, row)| {
            let own = blocks.and_then(|b| Some(&b.own[b.of_row[i]?])).map_or(&[][..], Vec::as_slice);
            let skipped = blocks.map_or(0, |_| OWN);
            let column = move |k: usize| blocks.map_or(k, |b| b.common[k]);
            let common = row[skipped..].iter().enumerate().map(move |(k, &v)| (column(k), v));
            debug_assert!(own.iter().all(|j| *j < n));
            own.iter().copied().zip(row.iter().copied()).chain(common)
        })
    }

    /// Norm of each column; 1 for a zero column.
    pub fn norms(&self) -> Vec<f64> {
        let mut squares = vec![0.0; self.n];
        match self.blocks {
            Some(_) => self.entries().for_each(|row| row.for_each(|(j, v)| squares[j] += v * v)),
            None => {
                for row in self.numbers.chunks_exact(self.n.max(1)) {
                    squares.iter_mut().zip(row).for_each(|(s, v)| *s += v * v);
                }
            }
        }
        squares.into_iter().map(|s: f64| if s > 0.0 { s.sqrt() } else { 1.0 }).collect()
    }

    /// Product of the transposed matrix and the columns of `by`, which has as many rows.
    pub fn transposed_times<const N: usize>(&self, by: &[f64]) -> Vec<[f64; N]> {
        let mut product = vec![[0.0; N]; self.n];
        let add = |p: &mut [f64; N], v: f64, by: &[f64]| p.iter_mut().zip(by).for_each(|(p, b)| *p += v * b);
        if self.blocks.is_some() {
            for (row, by) in self.entries().zip(by.chunks_exact(N)) {
                row.for_each(|(j, v)| add(&mut product[j], v, by));
            }
            return product;
        }
        for (row, by) in self.numbers.chunks_exact(self.n.max(1)).zip(by.chunks_exact(N)) {
            product.iter_mut().zip(row).for_each(|(p, &v)| add(p, v, by));
        }
        product
    }

    /// Product of the matrix and `x`, one number per row.
    pub fn multiply(&self, x: &[f64]) -> Vec<f64> {
        self.entries().map(|row| row.map(|(j, v)| v * x[j]).sum()).collect()
    }

    /// All columns of all rows.
    pub fn dense(&self) -> Vec<f64> {
        if self.blocks.is_none() {
            return self.numbers.to_vec();
        }
        let mut dense = vec![0.0; self.numbers.len() / self.width().max(1) * self.n];
        for (row, out) in self.entries().zip(dense.chunks_exact_mut(self.n.max(1))) {
            row.for_each(|(j, v)| out[j] = v);
        }
        dense
    }

    /// Factors the rows, with columns divided by `scale`, together with the right-hand side `b`.
    pub fn factor(&self, b: &[f64], scale: &[f64]) -> Factor {
        let Some(blocks) = self.blocks else { return Factor::new(self.numbers, b, scale) };
        let mut rows: Vec<Vec<usize>> = vec![Vec::new(); blocks.own.len() + 1];
        for (row, block) in blocks.of_row.iter().enumerate() {
            rows[block.unwrap_or(blocks.own.len())].push(row);
        }
        let task = |(own, rows): (&[Vec<usize>], &[Vec<usize>])| {
            let of = |(own, rows): (&Vec<usize>, &Vec<usize>)| self.eliminate(own, rows, b, scale);
            let (heads, rests): (Vec<Head>, Vec<Factor>) = own.iter().zip(rows).map(of).unzip();
            (heads, rests.into_iter().reduce(Factor::stack))
        };
        let tasks: Vec<_> = blocks.own.par_chunks(TASK_BLOCKS).zip(rows.par_chunks(TASK_BLOCKS)).map(task).collect();
        let (heads, rests): (Vec<Vec<Head>>, Vec<Option<Factor>>) = tasks.into_iter().unzip();
        let (_, free) = self.eliminate(&[], &rows[blocks.own.len()], b, scale);
        let common = rests.into_iter().flatten().fold(free, Factor::stack);
        common.under(heads.concat(), blocks.common.clone())
    }

    /// Factors the rows of a block with the columns `own`, and returns the remaining rows of the
    /// common columns.
    fn eliminate(&self, own: &[usize], rows: &[usize], b: &[f64], scale: &[f64]) -> (Head, Factor) {
        let common = self.blocks.map_or(&[][..], |blocks| &blocks.common);
        let width = self.width();
        let mut a = Vec::with_capacity(rows.len() * (own.len() + common.len()));
        for row in rows {
            let row = &self.numbers[row * width..][..width];
            a.extend_from_slice(&row[..own.len()]);
            a.extend_from_slice(&row[OWN..]);
        }
        let b: Vec<f64> = rows.iter().map(|&row| b[row]).collect();
        let scale: Vec<f64> = own.iter().chain(common).map(|&j| scale[j]).collect();
        Factor::new(&a, &b, &scale).split(own)
    }
}

/// Rows of a triangular factor for the columns of one block.
#[derive(Clone, Debug)]
pub(super) struct Head {
    /// Columns of the block.
    pub columns: Vec<usize>,
    /// One row per column: elements of the block's columns (upper triangular), followed by the
    /// common columns.
    pub rows: Vec<Vec<f64>>,
    /// Elements of Qᵀb for these rows.
    pub qtb: Vec<f64>,
}

impl Head {
    /// Back substitution for the columns of the block, given the solution `common` of the common
    /// columns and the right-hand side `b`.
    pub fn back(&self, b: &[f64], common: &[f64]) -> Option<Vec<f64>> {
        let w = self.columns.len();
        let mut x = vec![0.0; w];
        for i in (0..w).rev() {
            let known: f64 = (i + 1..w).map(|k| self.rows[i][k] * x[k]).sum();
            let side: f64 = self.rows[i][w..].iter().zip(common).map(|(r, x)| r * x).sum();
            x[i] = (b[i] - known - side) / self.rows[i][i];
            if !x[i].is_finite() {
                return None;
            }
        }
        Some(x)
    }

    /// Forward substitution with the transposed triangle; subtracts the contribution of the block
    /// to the common columns from `rest`.
    pub fn forward(&self, b: impl Fn(usize) -> f64, rest: &mut [f64]) -> Option<Vec<f64>> {
        let w = self.columns.len();
        let mut x = vec![0.0; w];
        for j in 0..w {
            let known: f64 = (0..j).map(|i| self.rows[i][j] * x[i]).sum();
            x[j] = (b(self.columns[j]) - known) / self.rows[j][j];
            if !x[j].is_finite() {
                return None;
            }
            rest.iter_mut().zip(&self.rows[j][w..]).for_each(|(rest, r)| *rest -= r * x[j]);
        }
        Some(x)
    }
}

/// Covariance of all columns, row by row, from the covariance of the common columns; the rows of
/// blocks have the given `variance`. `None` if a block is singular.
pub(super) fn with_heads(heads: &[Head], common: &[usize], of_common: &[f64], variance: f64) -> Option<Vec<f64>> {
    let p = common.len();
    // for each column: its dependence on the common columns, and the product with their inverse
    let mut follows: Vec<(usize, Vec<f64>, Vec<f64>)> = Vec::new();
    for head in heads {
        let w = head.columns.len();
        let mut answers = vec![vec![0.0; p]; w];
        for k in 0..p {
            let mut unit = vec![0.0; p];
            unit[k] = 1.0;
            let answer = head.back(&[0.0; OWN], &unit)?;
            answers.iter_mut().zip(answer).for_each(|(all, one)| all[k] = one);
        }
        for (&j, answer) in head.columns.iter().zip(answers) {
            let product = |k: usize| answer.iter().zip(&of_common[k * p..]).map(|(a, c)| a * c).sum();
            follows.push((j, (0..p).map(product).collect(), answer));
        }
    }
    let n = p + follows.len();
    let mut inverse = vec![0.0; n * n];
    let mut set = |i: usize, j: usize, value: f64| {
        inverse[i * n + j] += value;
        if i != j {
            inverse[j * n + i] += value;
        }
    };
    for (k, &i) in common.iter().enumerate() {
        common[k..].iter().enumerate().for_each(|(l, &j)| set(i, j, of_common[k * p + k + l]));
    }
    for (k, (i, product, _)) in follows.iter().enumerate() {
        common.iter().zip(product).for_each(|(&j, &value)| set(*i, j, value));
        for (j, _, answer) in &follows[k..] {
            set(*i, *j, product.iter().zip(answer).map(|(a, b)| a * b).sum());
        }
    }
    for head in heads {
        let w = head.columns.len();
        let column = |k: usize| head.back(&[0, 1, 2].map(|i| f64::from(u8::from(i == k))), &vec![0.0; p]);
        let inverse_r = (0..w).map(column).collect::<Option<Vec<_>>>()?;
        for (i, &a) in head.columns.iter().enumerate() {
            for (j, &b) in head.columns.iter().enumerate().skip(i) {
                set(a, b, variance * inverse_r.iter().map(|column| column[i] * column[j]).sum::<f64>());
            }
        }
    }
    Some(inverse)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Blocks of 3, 1 and 2 columns between common columns, with rows in arbitrary order and one
    /// block with too few rows.
    fn example() -> (Vec<f64>, Vec<f64>, Blocks) {
        let own = vec![vec![1, 2, 3], vec![6], vec![7, 5]];
        let mut blocks = Blocks { common: vec![0, 4, 8], own, of_row: Vec::new() };
        let (mut numbers, mut b) = (Vec::new(), Vec::new());
        for i in 0..60 {
            let t = f64::from(i);
            let block = [Some(0), Some(1), None, Some(2), Some(0)][i as usize % 5];
            let w = block.map_or(0, |k: usize| blocks.own[k].len());
            numbers.extend((0..3).map(|k| if k < w { (t * (0.3 + k as f64)).sin() } else { 0.0 }));
            numbers.extend((0..3).map(|k| (t * 1.1 + k as f64 * t * t).cos()));
            b.push((0.7 * t).cos());
            blocks.of_row.push(block);
        }
        (numbers, b, blocks)
    }

    #[test]
    fn blocks_give_the_factor_of_all_columns() {
        let (numbers, b, blocks) = example();
        let rows = Rows { numbers: &numbers, n: 9, blocks: Some(&blocks) };
        let dense = rows.dense();
        let whole = Rows { numbers: &dense, n: 9, blocks: None };
        let norms = rows.norms();
        let near = |a: &[f64], b: &[f64]| {
            assert_eq!(a.len(), b.len());
            a.iter().zip(b).for_each(|(a, b)| assert!((a - b).abs() < 1e-12 * (1.0 + b.abs()), "{a} {b}"));
        };
        near(&norms, &whole.norms());
        let (factor, expected) = (rows.factor(&b, &norms), whole.factor(&b, &norms));
        assert!((factor.rest - expected.rest).abs() < 1e-12);
        let x = expected.solve().unwrap();
        near(&factor.solve().unwrap(), &x);
        near(&factor.damped(0.3).solve().unwrap(), &expected.damped(0.3).solve().unwrap());
        near(&factor.inverse_normal().unwrap(), &expected.inverse_normal().unwrap());
        near(&factor.solve_normal(rows, &b, &norms).unwrap(), &expected.solve_normal(whole, &b, &norms).unwrap());
        near(&factor.column_norms(), &expected.column_norms());
        let square = |v: Vec<f64>| [v.iter().map(|v| v * v).sum::<f64>()];
        near(&square(factor.multiply(&x)), &square(expected.multiply(&x)));
        near(&factor.multiply_transposed(&factor.qtb), &expected.multiply_transposed(&expected.qtb));
        near(&square(factor.forward_substitute(x.clone()).unwrap()), &square(expected.forward_substitute(x).unwrap()));
        let kept = [0, 1, 3, 5, 6, 8];
        near(&factor.keeping(&kept).inverse_normal().unwrap(), &expected.keeping(&kept).inverse_normal().unwrap());
        near(&rows.transposed_times::<1>(&b).concat(), &whole.transposed_times::<1>(&b).concat());
    }
}
