//! One coordinate of the target in the world, for example from a dial gauge.

use super::{At, Equation};
use etalon_base::pose::Vector;

/// One coordinate of the target in the world. Residual: its coordinate by the model minus the
/// measured one (mm).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coordinate {
    /// 0, 1 or 2 for x, y or z.
    pub axis: usize,
    /// Measured coordinate.
    pub at_mm: f64,
}

impl Equation for Coordinate {
    fn residuals(&self, at: &At, out: &mut [f64]) {
        out[0] = at.position[self.axis] - self.at_mm;
    }

    fn jacobian(&self, at: &At, moved: &[f64], out: &mut [f64]) {
        let n = at.values.len();
        out.copy_from_slice(&moved[self.axis * n..][..n]);
    }

    fn in_world(&self, _: &At, residuals: Vector) -> Vector {
        [0, 1, 2].map(|i| if i == self.axis { residuals[0] } else { 0.0 })
    }

    fn by_scale(&self, _: &[f64]) -> Vector {
        [-self.at_mm, 0.0, 0.0]
    }

    fn has_length(&self) -> bool {
        true
    }

    fn is_in_world(&self) -> bool {
        true
    }
}
