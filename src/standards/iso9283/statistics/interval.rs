//! Intervals of AP and RP in closed form for Gaussian scatter: after 30 cycles the uncertainty of
//! RP is a quarter of its value.

use crate::iso9283::pose::accuracy::PoseAccuracy;
use crate::iso9283::pose::repeatability::PoseRepeatability;
use crate::iso9283::statistics::scatter::{FARTHEST, Scatter, dimensions};
use etalon_base::message::Result;
use etalon_base::pose::{Vector, minus, norm};
use statrs::distribution::{ChiSquared, ContinuousCDF, StudentsT};

/// Two-sided 95 % interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// Lower end.
    pub low_mm: f64,
    /// Upper end.
    pub high_mm: f64,
}

impl Interval {
    /// Extends the interval to contain these values.
    pub fn containing(self, values_mm: &[f64]) -> Self {
        values_mm.iter().fold(self, |i, v| Self { low_mm: i.low_mm.min(*v), high_mm: i.high_mm.max(*v) })
    }

    /// Adds the instrument's expanded uncertainty (k = 2) of a coordinate to an interval of AP:
    /// each half is the root of the sum of squares (GUM 5.1.2). Errors common to all readings
    /// remain in their mean.
    pub fn with_instrument(self, ap_mm: f64, expanded_mm: f64) -> Self {
        Self {
            low_mm: (ap_mm - (ap_mm - self.low_mm).hypot(expanded_mm)).max(0.0),
            high_mm: ap_mm + (self.high_mm - ap_mm).hypot(expanded_mm),
        }
    }

    /// Interval of the robot's RP if the instrument's expanded uncertainty (k = 2) of a coordinate
    /// may be noise. Noise can only increase RP: the upper end is unchanged, and the lower end is
    /// the RP that remains if all of the uncertainty is noise. (Mean + 3 s of the radius of
    /// Gaussian noise: 3.615 standard deviations in space, 3.219 in the plane; Maxwell and Rayleigh
    /// distribution.)
    pub fn without_noise(self, expanded_mm: f64, spatial: bool) -> Self {
        let noise_mm = if spatial { 3.615 } else { 3.219 } * expanded_mm / 2.0;
        Self { low_mm: (self.low_mm.powi(2) - noise_mm.powi(2)).max(0.0).sqrt(), ..self }
    }
}

/// Probability beyond either end of a 95 % interval.
pub(crate) const TAIL: f64 = 0.025;

/// 95 % interval of AP from at least three positions: the nearest and the farthest plausible
/// barycentre by Student's t, minus the mean contribution of the scatter across the deviation.
///
/// If AP is within four standard uncertainties of zero, its direction is random and the lower end
/// is zero.
pub fn accuracy_interval(attained_mm: &[Vector], accuracy: &PoseAccuracy) -> Result<Interval> {
    crate::iso9283::statistics::sample::positions(attained_mm, 3, "ap-interval")?;
    let n = attained_mm.len() as f64;
    let scatter = Scatter::new(attained_mm);
    let mean = scatter.along(accuracy.deviation_mm);
    let limit = StudentsT::new(0.0, 1.0, n - 1.0).map_or(f64::NAN, |t| t.inverse_cdf(1.0 - TAIL)) / n.sqrt();
    let end = |sign: f64| {
        let (mut near, mut far) = (0.0, sign * FARTHEST);
        for _ in 0..60 {
            let middle = 0.5 * (near + far);
            if units(minus(scatter.plausible(mean, middle), mean), scatter.found) > limit {
                far = middle
            } else {
                near = middle
            }
        }
        norm(scatter.plausible(mean, near))
    };
    let total = scatter.found.iter().sum::<f64>() / n;
    let along = (0..3).map(|k| scatter.found[k] * mean[k].powi(2)).sum::<f64>() / n / accuracy.ap_mm.powi(2);
    let across = if accuracy.ap_mm > 0.0 { total - along } else { 0.0 };
    let less = |ap_mm: f64| (ap_mm.powi(2) - across).max(0.0).sqrt();
    let chance = accuracy.ap_mm < 4.0 * total.sqrt();
    Ok(Interval { low_mm: if chance { 0.0 } else { less(end(1.0)) }, high_mm: less(end(-1.0)) })
}

/// Length in units of the scatter; directions without scatter do not count.
fn units(d: Vector, variances: Vector) -> f64 {
    (0..3).filter(|&k| variances[k] > 0.0).map(|k| d[k].powi(2) / variances[k]).sum::<f64>().sqrt()
}

/// 95 % interval of RP from at least three positions: chi-square with the degrees of freedom that
/// match the relative variance of mean + 3 s.
pub fn repeatability_interval(attained_mm: &[Vector], repeatability: &PoseRepeatability) -> Result<Interval> {
    crate::iso9283::statistics::sample::positions(attained_mm, 3, "rp-interval")?;
    let n = attained_mm.len() as f64;
    let degrees = (n - 1.0) * worth(Scatter::new(attained_mm).drawn_together);
    // radii about the sample mean are too small by the factor √(1 − 1/n)
    let rp_mm = repeatability.rp_mm * (n / (n - 1.0)).sqrt();
    let end = |probability: f64| match ChiSquared::new(degrees) {
        Ok(chi) => rp_mm * (degrees / chi.inverse_cdf(probability)).sqrt(),
        Err(_) => rp_mm,
    };
    Ok(Interval { low_mm: end(1.0 - TAIL), high_mm: end(TAIL) })
}

/// Degrees of freedom per cycle: 1 / 2v, where v / n is the relative variance of mean + 3 s of the
/// radius.
///
/// Exact by the delta method if 1, 2 or 3 variances are equal and the others zero (moments of
/// half-normal, Rayleigh and Maxwell distribution); interpolated by a parabola, and reduced for
/// unequal variances. Within 5 % of the delta method throughout.
fn worth(variances: Vector) -> f64 {
    const WORTH: [f64; 3] = [0.895, 1.519, 2.002];
    const UNEQUAL: f64 = 2.2;
    let d = dimensions(variances);
    let t = d - 2.0;
    let equal = WORTH[1] + t * (WORTH[2] - WORTH[0]) / 2.0 + t * t * (WORTH[2] + WORTH[0] - 2.0 * WORTH[1]) / 2.0;
    let cubes: f64 = variances.iter().map(|v| v.powi(3)).sum();
    let skew = d * (cubes / variances.iter().sum::<f64>().powi(3)).sqrt() - 1.0;
    equal * (1.0 - UNEQUAL * skew)
}
