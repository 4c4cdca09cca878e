//! Loss of a residual: its square, or a smaller value that reduces the influence of outliers.
//!
//! The sum of ρ(r²) is minimised by weighting the rows of each linear problem such that its
//! gradient is the gradient of the robust cost, and its curvature the curvature of ρ (Triggs et al.
//! 2000, "Bundle adjustment - a modern synthesis", 4.3). Where the curvature of ρ would be smaller
//! or negative, it is kept at a hundredth of the weight, so that the linear problem has a minimum.

/// Loss ρ of a residual r in units of its standard uncertainty.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Loss {
    /// r²: least squares.
    #[default]
    Squares,
    /// c² ln(1 + r²/c²): the influence of large outliers tends to zero, and there may be several
    /// minima. The usual constant is 2.385.
    Cauchy(f64),
}

/// Minimum curvature relative to the weight; smaller values would make the weighted residuals of
/// outliers dominate the others.
const CURVATURE_KEPT: f64 = 0.01;

impl Loss {
    /// Loss ρ(r²); NaN if the constant of the loss is not positive.
    pub fn value(self, residual: f64) -> f64 {
        let square = residual * residual;
        match self {
            Self::Squares => square,
            Self::Cauchy(c) if c.is_nan() || c <= 0.0 => f64::NAN,
            Self::Cauchy(c) => c * c * (square / (c * c)).ln_1p(),
        }
    }

    /// Influence ψ of a residual: half the derivative of ρ with respect to r.
    pub fn influence(self, residual: f64) -> f64 {
        match self {
            Self::Squares => residual,
            Self::Cauchy(c) => residual / (1.0 + (residual / c).powi(2)),
        }
    }

    /// Derivative ψ′: half the second derivative of ρ with respect to r.
    pub fn curvature(self, residual: f64) -> f64 {
        match self {
            Self::Squares => 1.0,
            Self::Cauchy(c) => {
                let z = (residual / c).powi(2);
                (1.0 - z) / ((1.0 + z) * (1.0 + z))
            }
        }
    }

    /// Sum over `residuals`; the last `priors` residuals count as squares.
    pub(super) fn sum(self, residuals: &[f64], priors: usize) -> f64 {
        let (measured, priors) = residuals.split_at(residuals.len().saturating_sub(priors));
        let squares = |r: &[f64]| r.iter().map(|r| r * r).sum::<f64>();
        match self {
            Self::Squares => squares(residuals),
            _ => measured.iter().map(|&r| self.value(r)).sum::<f64>() + squares(priors),
        }
    }

    /// Weights `residuals` and the rows of the Jacobian, except for the last `priors` (Triggs et
    /// al. 2000, eq. 11).
    pub(super) fn weigh(self, residuals: &mut [f64], jacobian: &mut [f64], columns: usize, priors: usize) {
        let measured = residuals.len().saturating_sub(priors);
        if self == Self::Squares {
            return;
        }
        for (r, row) in residuals.iter_mut().zip(jacobian.chunks_exact_mut(columns.max(1))).take(measured) {
            let influence = self.influence(*r);
            let weight = if *r == 0.0 { 1.0 } else { influence / *r };
            let root = self.curvature(*r).max(CURVATURE_KEPT * weight).sqrt();
            row.iter_mut().for_each(|j| *j *= root);
            *r = influence / root;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn influence_and_curvature_are_the_derivatives_of_the_loss() {
        for loss in [Loss::Squares, Loss::Cauchy(2.385)] {
            for r in [-7.0, -1.0, -0.3, 0.0, 0.2, 1.1, 2.0, 30.0] {
                let h = 1e-5;
                let slope = (loss.value(r + h) - loss.value(r - h)) / (4.0 * h);
                assert!((slope - loss.influence(r)).abs() < 1e-8, "{loss:?} {r}");
                let bend = (loss.influence(r + h) - loss.influence(r - h)) / (2.0 * h);
                assert!((bend - loss.curvature(r)).abs() < 1e-8, "{loss:?} {r}");
            }
        }
    }

    #[test]
    fn a_constant_that_is_not_positive_has_no_value() {
        for loss in [Loss::Cauchy(0.0), Loss::Cauchy(-1.0), Loss::Cauchy(f64::NAN)] {
            assert!(loss.value(1.0).is_nan());
        }
    }
}
