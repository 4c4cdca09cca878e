//! A measured ratio against an expected one.

use statrs::distribution::{ContinuousCDF, StudentsT};

/// Probability of a ratio beyond its uncertainty by noise alone.
const CHANCE: f64 = 1e-5;

/// Measured ratio with its uncertainty.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeasuredRatio {
    /// Value.
    pub value: f64,
    /// Standard uncertainty.
    pub standard_uncertainty: f64,
    /// Degrees of freedom of the uncertainty; infinite if it is given.
    pub degrees_of_freedom: f64,
}

impl MeasuredRatio {
    /// `true` if the ratio differs from `expected` by more than this share of it and more than its
    /// uncertainty: noise alone exceeds the limit once in 100 000 times.
    ///
    /// A correct ratio may differ by this share: a significant difference alone is no mistake.
    pub fn differs(&self, expected: f64, share: f64) -> bool {
        let distribution = StudentsT::new(0.0, 1.0, self.degrees_of_freedom.clamp(1.0, 1e6));
        let factor = distribution.map_or(f64::INFINITY, |t| t.inverse_cdf(1.0 - 0.5 * CHANCE));
        (self.value - expected).abs() > share * expected + factor * self.standard_uncertainty
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ratio_counts_with_its_uncertainty() {
        let ratio = |value, standard_uncertainty, degrees_of_freedom| MeasuredRatio {
            value,
            standard_uncertainty,
            degrees_of_freedom,
        };
        // the 0.999995 quantile of the normal distribution is 4.417
        assert!(!ratio(1.063, 0.01, f64::INFINITY).differs(1.0, 0.02));
        assert!(ratio(1.066, 0.01, f64::INFINITY).differs(1.0, 0.02));
        assert!(!ratio(1.03, 0.16, 12.0).differs(1.0, 0.005) && ratio(57.3, 0.16, 3.0).differs(1.0, 0.005));
        // few degrees of freedom say little of the uncertainty
        assert!(!ratio(1.2, 0.01, 1.0).differs(1.0, 0.02));
        // significance alone is no mistake
        assert!(!ratio(1.004, 1e-6, 100.0).differs(1.0, 0.005));
    }
}
