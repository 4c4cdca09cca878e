//! Rows of given values after the rows of the measurements: shapes of rigid parts, fixed points,
//! and nominal values.

use super::columns::Columns;
use crate::model::kinds::Known;
use crate::model::prior::Nominal;
use crate::model::rigid_part::{At, Shape};

/// Given values; their rows come last, in this order.
pub(super) struct Priors<'a> {
    /// Given shapes of rigid parts.
    pub shapes: Vec<Shape>,
    /// Knowledge of fixed points.
    pub known: &'a [Known],
    /// Nominal values.
    pub nominals: Vec<Nominal>,
    /// Standard deviation of a row of a nominal value.
    pub weight: f64,
}

impl Priors<'_> {
    /// Number of rows.
    pub fn count(&self) -> usize {
        self.shape_count() + self.known.iter().map(Known::rows).sum::<usize>() + self.nominals.len()
    }

    /// Number of rows of the shapes.
    fn shape_count(&self) -> usize {
        self.shapes.iter().map(Shape::rows).sum()
    }

    /// The shapes, each with its first row; `first` is the first row of all.
    pub fn shapes(&self, first: usize) -> impl Iterator<Item = (usize, &Shape)> {
        let mut row = first;
        self.shapes.iter().map(move |shape| {
            row += shape.rows();
            (row - shape.rows(), shape)
        })
    }

    /// Knowledge of fixed points, each with its first row; `first` is the first row of all.
    pub fn known(&self, first: usize) -> impl Iterator<Item = (usize, &Known)> {
        let mut row = first + self.shape_count();
        self.known.iter().map(move |known| {
            row += known.rows();
            (row - known.rows(), known)
        })
    }

    /// Residuals at `at` with all parameters; `first` is the first row.
    pub fn residuals(&self, at: &At, first: usize, r: &mut [f64]) {
        for (row, shape) in self.shapes(first) {
            shape.residuals(at, &mut r[row..][..shape.rows()]);
        }
        for (row, known) in self.known(first) {
            known.residuals(at.values, &mut r[row..][..known.rows()]);
        }
        let end = first + self.count();
        let nominals = &mut r[end - self.nominals.len()..end];
        nominals.iter_mut().zip(&self.nominals).for_each(|(r, nominal)| *r = nominal.residual(at.values));
    }

    /// Derivatives with respect to the free parameters; `first` is the first row.
    pub fn jacobian(&self, at: &At, columns: Columns, first: usize, jacobian: &mut [f64]) {
        let (n, width, all) = (columns.free.len(), columns.width(), at.values.len());
        for (row, shape) in self.shapes(first) {
            shape.jacobian(at, &mut jacobian[row * n..][..shape.rows() * n]);
        }
        for (row, known) in self.known(first) {
            let mut full = vec![0.0; known.rows() * all];
            known.jacobian(at.values, &mut full);
            let out = jacobian[row * width..][..known.rows() * width].chunks_exact_mut(width);
            for (i, (full, out)) in full.chunks_exact(all).zip(out).enumerate() {
                columns.write(row + i, |parameter| full[parameter], out);
            }
        }
        let end = first + self.count();
        for (row, nominal) in (end - self.nominals.len()..end).zip(&self.nominals) {
            let by = |parameter| if parameter == nominal.parameter { nominal.derivative() } else { 0.0 };
            columns.write(row, by, &mut jacobian[row * width..][..width]);
        }
    }
}
