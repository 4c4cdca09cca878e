//! Columns of the Jacobian of residuals.

use crate::model::elimination::Layout;

/// Columns of the Jacobian: the free parameters, or the layout in which unknowns are eliminated.
#[derive(Clone, Copy)]
pub(super) struct Columns<'r> {
    pub free: &'r [usize],
    pub layout: Option<&'r Layout>,
}

impl Columns<'_> {
    /// Number of elements of a row.
    pub fn width(self) -> usize {
        self.layout.map_or(self.free.len(), |layout| layout.blocks.width())
    }

    /// Writes the derivatives of a residual with respect to the free parameters into its row.
    pub fn write(self, row: usize, derivative: impl Fn(usize) -> f64, out: &mut [f64]) {
        let Some(layout) = self.layout else {
            return self.free.iter().zip(out).for_each(|(&i, out)| *out = derivative(i));
        };
        out.fill(0.0);
        self.free.iter().for_each(|&i| layout.add(layout.blocks.of_row[row], i, derivative(i), out));
    }

    /// Element of a row at which the derivative with respect to each of all `count` parameters is;
    /// `None` if it is held.
    pub fn places(self, count: usize) -> Vec<Option<usize>> {
        let mut places = vec![None; count];
        for (column, &i) in self.free.iter().enumerate() {
            places[i] = self.layout.map_or(Some(column), |layout| Some(layout.places[i]?.1));
        }
        places
    }
}
