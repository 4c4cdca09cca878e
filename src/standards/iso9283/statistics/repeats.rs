//! Expanded uncertainty of values from few repeats.

use statrs::distribution::{ContinuousCDF, StudentsT};

/// Tail of a coverage probability of 95.45 %, for which k is 2 with many repeats (GUM G.1.3).
const TAIL: f64 = 0.022_75;
/// Degrees of freedom beyond which Student's factor is 2.00, as for a normal distribution.
const MANY: f64 = 1e4;

/// Student's factor for a coverage probability of 95.45 % (GUM G.3.2, table G.2).
pub(crate) fn student_factor(degrees: f64) -> Option<f64> {
    if degrees >= MANY {
        return Some(2.0);
    }
    let student = StudentsT::new(0.0, 1.0, degrees).ok()?;
    Some(student.inverse_cdf(1.0 - TAIL)).filter(|factor| factor.is_finite())
}

/// Expanded uncertainty of the mean of repeats: their scatter (GUM 4.2.3), and the resolution of
/// each as a difference of two readings, triangular with this half-width (GUM 4.3.9). Welch and
/// Satterthwaite give the degrees of freedom (GUM G.4.1). `None` for fewer than two repeats.
pub(crate) fn mean_uncertainty(repeats: &[f64], resolution: f64) -> Option<f64> {
    let n = repeats.len() as f64;
    if repeats.len() < 2 {
        return None;
    }
    let mean = repeats.iter().sum::<f64>() / n;
    let scatter = repeats.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / (n - 1.0) / n;
    let variance = scatter + resolution.powi(2) / 6.0;
    let degrees = if scatter > 0.0 { (n - 1.0) * (variance / scatter).powi(2) } else { MANY };
    Some(student_factor(degrees)? * variance.sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn few_repeats_have_the_factors_of_the_gum() {
        // GUM, table G.2, 95.45 %
        for (degrees, factor) in [(1.0, 13.97), (2.0, 4.53), (5.0, 2.65), (10.0, 2.28), (50.0, 2.05)] {
            assert!((student_factor(degrees).unwrap() - factor).abs() < 0.005, "{degrees}");
        }
        assert!((student_factor(f64::INFINITY).unwrap() - 2.0).abs() < 1e-4);
        // a standard deviation of 0.02: 4.53 · 0.02/√3
        assert!((mean_uncertainty(&[0.30, 0.32, 0.34], 0.0).unwrap() - 0.0523).abs() < 1e-4);
        // repeats that agree within the resolution: 2 · 0.01/√6
        assert!((mean_uncertainty(&[0.3; 3], 0.01).unwrap() - 0.008_165).abs() < 1e-6);
        assert_eq!(mean_uncertainty(&[0.3], 0.01), None);
    }
}
