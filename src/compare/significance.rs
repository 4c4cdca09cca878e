//! Significance of changes.

use etalon_base::noise::Noise;
pub use etalon_identify::holm;
use nalgebra::{DMatrix, DVector};
use statrs::distribution::{ChiSquared, ContinuousCDF, FisherSnedecor, Normal, StudentsT};

/// Significance level of a change.
pub const LEVEL: f64 = 0.05;
/// Seed of the draws of [`step_down`].
const SEED: u64 = 93;
/// Degrees of freedom above which Student's t and the normal distribution agree to five digits.
const MANY: f64 = 1e5;

/// A value with its standard uncertainty and degrees of freedom.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// Value.
    pub value: f64,
    /// Standard uncertainty (k = 1).
    pub standard_uncertainty: f64,
    /// Degrees of freedom; infinite if the uncertainty is given rather than estimated.
    pub degrees: f64,
}

/// A change with its 95 % interval, and the probability of a change at least as large by chance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Difference {
    /// Later minus earlier value; for scales, later over earlier value.
    pub change: f64,
    /// Lower end of the interval.
    pub low: f64,
    /// Upper end of the interval.
    pub high: f64,
    /// Two-sided probability.
    pub p: f64,
}

impl Estimate {
    /// 95 % interval by Student's t.
    pub fn interval(&self) -> (f64, f64) {
        let half = student(self.degrees).1 * self.standard_uncertainty;
        (self.value - half, self.value + half)
    }

    /// Later minus earlier over √(u1² + u2²), by Student's t with Welch and Satterthwaite's degrees
    /// of freedom (GUM G.4).
    pub fn change_to(&self, later: &Self) -> Difference {
        let change = later.value - self.value;
        let (a, b) = (self.standard_uncertainty.powi(2), later.standard_uncertainty.powi(2));
        let degrees = (a + b).powi(2) / (a * a / self.degrees + b * b / later.degrees);
        // 0/0 without scatter; x/0 if uncertainties are given
        let (tail, factor) = student(if degrees.is_nan() { f64::INFINITY } else { degrees });
        let u = (a + b).sqrt();
        Difference { change, low: change - factor * u, high: change + factor * u, p: chance(change, u, &tail) }
    }
}

/// Probability of a change by chance; NaN without an uncertainty.
fn chance(change: f64, u: f64, tail: &dyn Fn(f64) -> f64) -> f64 {
    match change.abs() / u {
        _ if change == 0.0 => 1.0,
        ratio if ratio.is_nan() => f64::NAN,
        ratio if ratio.is_infinite() => 0.0,
        ratio => tail(ratio),
    }
}

/// Two-sided tail probability beyond t, and the t of a 95 % interval.
fn student(degrees: f64) -> (Box<dyn Fn(f64) -> f64>, f64) {
    match StudentsT::new(0.0, 1.0, degrees) {
        Ok(t) if degrees < MANY => (Box::new(move |x| 2.0 * t.sf(x)), t.inverse_cdf(1.0 - LEVEL / 2.0)),
        _ => {
            let gauss = Normal::standard();
            (Box::new(move |x| 2.0 * gauss.sf(x)), gauss.inverse_cdf(1.0 - LEVEL / 2.0))
        }
    }
}

/// Value, and lower and upper end of its 95 % interval, which may be asymmetrical.
pub type Recovered = (f64, f64, f64);

/// Difference of two values with known intervals. Variances are recovered from the intervals on the
/// relevant side (MOVER, Zou & Donner 2008); for the probability the end of the interval counts as
/// 1.96 standard uncertainties.
pub fn recovered(earlier: Recovered, later: Recovered) -> Difference {
    let change = later.0 - earlier.0;
    let below = (later.0 - later.1).hypot(earlier.2 - earlier.0);
    let above = (later.2 - later.0).hypot(earlier.0 - earlier.1);
    let (tail, factor) = student(f64::INFINITY);
    let towards_nothing = if change > 0.0 { below } else { above };
    Difference { change, low: change - below, high: change + above, p: chance(change, towards_nothing / factor, &tail) }
}

/// Degrees of freedom of an interval of a scale by chi-square; the ratio of its ends determines
/// them.
pub fn degrees_of_scale(low: f64, high: f64) -> Option<f64> {
    let ratio = |degrees: f64| {
        let chi = ChiSquared::new(degrees).ok()?;
        Some((chi.inverse_cdf(1.0 - LEVEL / 2.0) / chi.inverse_cdf(LEVEL / 2.0)).sqrt())
    };
    let wanted = Some(high / low).filter(|r| r.is_finite() && *r > 1.0)?;
    let (mut few, mut many) = (0.1f64, MANY);
    for _ in 0..50 {
        let middle = (few * many).sqrt();
        if ratio(middle)? > wanted { few = middle } else { many = middle }
    }
    Some((few * many).sqrt())
}

/// Standard deviation, or a quantity proportional to one.
#[derive(Clone, Copy, Debug)]
pub struct Scale {
    /// Value.
    pub value: f64,
    /// Degrees of freedom.
    pub degrees: f64,
}

/// Ratio of two scales (standard deviations, RP) by the F test of their squares.
pub fn ratio_of_scales(earlier: Scale, later: Scale) -> Option<Difference> {
    let f = FisherSnedecor::new(later.degrees, earlier.degrees).ok()?;
    let change = later.value / earlier.value;
    let squared = Some(change * change).filter(|s| s.is_finite())?;
    let end = |share: f64| change / f.inverse_cdf(share).sqrt();
    let p = (2.0 * f.cdf(squared).min(f.sf(squared))).min(1.0);
    Some(Difference { change, low: end(1.0 - LEVEL / 2.0), high: end(LEVEL / 2.0), p })
}

/// Number of draws for a family; a probability of 5 % has a standard deviation of 0.2 %.
const DRAWS: usize = 10_000;

/// Step-down correction like [`holm`] for normal estimates with known correlation. Each step uses
/// the probability that the largest remaining statistic is as large by chance (Westfall & Young
/// 1993, 2.8). Holm uses the sum of probabilities instead, which is too large for correlated
/// estimates. The draws have a fixed seed; `None` for a single estimate, and if the correlation is
/// not positive definite.
pub fn step_down(p: &[f64], correlation: DMatrix<f64>) -> Option<Vec<f64>> {
    let several = p.len() > 1 && correlation.nrows() == p.len();
    let lower = correlation.cholesky().filter(|_| several)?.unpack();
    let gauss = Normal::standard();
    let sizes: Vec<f64> = p.iter().map(|p| -gauss.inverse_cdf(0.5 * p)).collect();
    let mut order: Vec<usize> = (0..p.len()).collect();
    order.sort_by(|&a, &b| sizes[a].total_cmp(&sizes[b]));
    let mut noise = Noise::new(SEED, 0);
    let mut counts = vec![0; p.len()];
    for _ in 0..DRAWS {
        let drawn = &lower * DVector::from_fn(p.len(), |_, _| noise.gaussian(1.0));
        let mut largest = 0.0f64;
        for &i in &order {
            largest = largest.max(drawn[i].abs());
            counts[i] += usize::from(largest >= sizes[i]);
        }
    }
    // never more than Holm's correction, which is exact where draws are too few
    let mut corrected = holm(p);
    let mut last = 0.0f64;
    for &i in order.iter().rev() {
        last = last.max((counts[i] + 1) as f64 / (DRAWS + 1) as f64);
        corrected[i] = corrected[i].min(last);
    }
    Some(corrected)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn close(found: f64, expected: f64, tolerance: f64) {
        assert!((found - expected).abs() < tolerance, "{found} instead of {expected}");
    }

    /// Holm's rule by hand: 0.01 · 3, then 0.02 · 2, then 0.04 · 1, which must not decrease.
    #[test]
    fn holm_multiplies_by_what_is_left_and_never_falls() {
        let corrected = holm(&[0.04, 0.01, 0.02]);
        [0.04, 0.03, 0.04].iter().zip(&corrected).for_each(|(e, f)| close(*f, *e, 1e-15));
        assert_eq!(holm(&[0.9, 0.6]), [1.0, 1.0]);
        assert_eq!(holm(&[]), Vec::<f64>::new());
    }

    /// For independent estimates 1 − (1 − p)^m for the smallest p; for identical estimates p
    /// itself; Holm's correction for tiny p.
    #[test]
    fn the_largest_of_correlated_estimates_counts_as_often_as_it_is_by_chance() {
        let independent = step_down(&[0.9, 0.02, 0.5], DMatrix::identity(3, 3)).unwrap();
        close(independent[1], 1.0 - 0.98f64.powi(3), 0.005);
        close(independent[2], 1.0 - 0.5f64.powi(2), 0.015);
        close(independent[0], 0.9, 0.01);
        let one = step_down(&[0.04; 4], DMatrix::from_fn(4, 4, |i, j| if i == j { 1.0 } else { 1.0 - 1e-9 })).unwrap();
        one.iter().for_each(|p| close(*p, 0.04, 0.006));
        let tiny = step_down(&[1e-9, 0.5], DMatrix::identity(2, 2)).unwrap();
        close(tiny[0], 2e-9, 1e-15);
        assert!(step_down(&[0.1, 0.1], DMatrix::from_element(2, 2, -1.0)).is_none());
    }

    /// Tables: t(0.975; 10) = 2.228, z(0.975) = 1.960, F(0.95; 3, 10) = 3.708, F(0.975; 10, 10) =
    /// 3.717.
    #[test]
    fn a_change_by_hand() {
        let known = |value, u| Estimate { value, standard_uncertainty: u, degrees: f64::INFINITY };
        let d = known(1.0, 3.0).change_to(&known(11.0, 4.0));
        close(d.change, 10.0, 1e-12);
        close(d.p, 0.0455, 5e-5);
        close(d.low, 10.0 - 5.0 * 1.960, 1e-3);
        let few = |value| Estimate { value, standard_uncertainty: 1.0, degrees: 5.0 };
        let d = few(0.0).change_to(&few(2.228 * 2f64.sqrt()));
        close(d.p, 0.05, 1e-4);
        close(d.low, 0.0, 1e-3);
        let same = known(2.0, 0.0).change_to(&known(2.0, 0.0));
        assert!(same.p == 1.0 && same.low == 0.0 && same.high == 0.0);
        assert!(known(2.0, 0.0).change_to(&known(2.1, 0.0)).p == 0.0);
        let scale = |value| Scale { value, degrees: 10.0 };
        let r = ratio_of_scales(scale(1.0), scale(3.717f64.sqrt())).unwrap();
        close(r.p, 0.05, 1e-4);
        close(r.low, 1.0, 1e-3);
        assert!(ratio_of_scales(scale(0.0), scale(1.0)).is_none());
    }

    #[test]
    fn the_interval_of_a_scale_tells_its_degrees_of_freedom() {
        for degrees in [1.5, 10.0, 29.0, 60.0, 1000.0] {
            let chi = ChiSquared::new(degrees).unwrap();
            let end = |share: f64| (degrees / chi.inverse_cdf(share)).sqrt();
            close(degrees_of_scale(end(0.975), end(0.025)).unwrap() / degrees, 1.0, 1e-6);
        }
        assert!(degrees_of_scale(0.0, 1.0).is_none() && degrees_of_scale(1.0, 1.0).is_none());
    }

    /// Symmetrical intervals give the root of the sum of squares; for asymmetrical ones the
    /// relevant side counts.
    #[test]
    fn intervals_of_a_difference_are_recovered() {
        let d = recovered((1.0, 0.7, 1.3), (2.0, 1.6, 2.4));
        close(d.low, 0.5, 1e-12);
        close(d.high, 1.5, 1e-12);
        let d = recovered((1.0, 0.0, 1.3), (2.0, 1.6, 9.0));
        close(d.low, 0.5, 1e-12);
        close(d.high, 1.0 + 50f64.sqrt(), 1e-12);
    }
}
