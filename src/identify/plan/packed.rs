//! Symmetric matrices of one order, stored as upper triangles in one block.
//!
//! Sums and inner products over all candidates of a large pool are limited by memory: half the
//! numbers take half the time.

use nalgebra::DMatrix;
use rayon::prelude::*;

/// Number of sums that a product accumulates side by side.
const LANES: usize = 8;
/// Minimum number of products for which several threads are worthwhile.
const PARALLEL: usize = 200_000;

/// Symmetric matrices.
#[derive(Clone, Debug)]
pub struct Packed {
    order: usize,
    /// Upper triangles, column by column.
    numbers: Vec<f64>,
}

impl Packed {
    /// Packs symmetric matrices of one order.
    pub fn new<'a>(order: usize, matrices: impl Iterator<Item = &'a DMatrix<f64>>) -> Self {
        let numbers = matrices.flat_map(|matrix| pack(matrix, |_, v| v)).collect();
        Self { order, numbers }
    }

    /// Count of numbers of one matrix.
    pub fn width(&self) -> usize {
        self.order * (self.order + 1) / 2
    }

    fn at(&self, i: usize) -> &[f64] {
        &self.numbers[i * self.width()..(i + 1) * self.width()]
    }

    /// Weighted sum of matrices, given as pairs of index and weight.
    pub fn sum(&self, parts: impl Iterator<Item = (usize, f64)>) -> DMatrix<f64> {
        let mut sum = vec![0.0; self.width()];
        for (i, weight) in parts {
            sum.iter_mut().zip(self.at(i)).for_each(|(s, v)| *s += weight * v);
        }
        let mut numbers = sum.into_iter();
        let mut full = DMatrix::zeros(self.order, self.order);
        for column in 0..self.order {
            for (row, value) in (0..=column).zip(&mut numbers) {
                full[(row, column)] = value;
                full[(column, row)] = value;
            }
        }
        full
    }

    /// Inner products ⟨`by`, M⟩ of a symmetric matrix with each of the matrices M.
    pub fn products(&self, by: &DMatrix<f64>) -> Vec<f64> {
        let weights = packed_weights(by);
        if self.width() == 0 {
            return Vec::new();
        }
        match self.numbers.len() < PARALLEL {
            true => self.numbers.chunks_exact(self.width()).map(|m| product(&weights, m)).collect(),
            false => self.numbers.par_chunks_exact(self.width()).map(|m| product(&weights, m)).collect(),
        }
    }

    /// Inner product with the matrix at `i` of a symmetric matrix, given by its
    /// [`packed_weights`].
    pub fn product(&self, weights: &[f64], i: usize) -> f64 {
        product(weights, self.at(i))
    }
}

/// Weights of an upper triangle in inner products with a symmetric matrix.
pub fn packed_weights(matrix: &DMatrix<f64>) -> Vec<f64> {
    pack(matrix, |is_diagonal, v| if is_diagonal { v } else { 2.0 * v })
}

/// Upper triangle, column by column; `weigh` gets `true` on the diagonal.
fn pack(matrix: &DMatrix<f64>, weigh: impl Fn(bool, f64) -> f64) -> Vec<f64> {
    let order = matrix.nrows();
    let mut numbers = Vec::with_capacity(order * (order + 1) / 2);
    for column in 0..order {
        numbers.extend((0..=column).map(|row| weigh(row == column, matrix[(row, column)])));
    }
    numbers
}

/// Sum of the products of two lists, in an order that does not depend on the machine.
pub fn product(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; LANES];
    let (mut of_a, mut of_b) = (a.chunks_exact(LANES), b.chunks_exact(LANES));
    for (x, y) in (&mut of_a).zip(&mut of_b) {
        for (sum, (x, y)) in sums.iter_mut().zip(x.iter().zip(y)) {
            *sum += x * y;
        }
    }
    let rest: f64 = of_a.remainder().iter().zip(of_b.remainder()).map(|(x, y)| x * y).sum();
    sums.iter().sum::<f64>() + rest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_and_products_are_those_of_whole_matrices() {
        let matrix = |seed: f64| {
            let half = DMatrix::from_fn(5, 5, |i, j| (seed + 1.3 * i as f64 - 0.7 * (j * j) as f64).sin());
            &half + half.transpose()
        };
        let all = [matrix(1.0), matrix(2.0), matrix(3.0)];
        let packed = Packed::new(5, all.iter());
        let expected = &all[0] * 2.0 - &all[2] * 0.5;
        assert!((packed.sum([(0, 2.0), (2, -0.5)].into_iter()) - expected).amax() < 1e-14);
        let by = matrix(9.0);
        for (i, (product, m)) in packed.products(&by).into_iter().zip(&all).enumerate() {
            assert!((product - (&by * m).trace()).abs() < 1e-13);
            assert_eq!(product, packed.product(&packed_weights(&by), i));
        }
    }
}
