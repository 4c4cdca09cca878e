//! RP without the instrument's noise (not in the standard), if visits were read several times.
//! Readings of one visit differ by the instrument's noise alone; means of visits differ by the
//! robot and the remaining noise.

use crate::iso9283::pose::repeatability::{PoseRepeatability, pose_repeatability};
use crate::iso9283::pose::test::TestedPose;
use crate::iso9283::statistics::sample::{covariance, mean_position};
use crate::iso9283::statistics::scatter::drawn_together;
use etalon_base::error;
use etalon_base::message::Result;
use etalon_base::pose::Vector;
use etalon_math::symmetric_eigen;

/// RP of the robot alone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NoiseFree {
    /// RP of the means of the visits, including the instrument.
    pub found: PoseRepeatability,
    /// RP of the robot: measured RP, times the ratio of the RP of Gaussian scatter without and with
    /// the noise; zero if the noise explains all scatter.
    pub rp_mm: f64,
    /// Standard deviation of one reading along each coordinate.
    pub noise_mm: Vector,
}

/// Evaluates at least three visits, at least one with several readings.
pub fn without_noise(visits_mm: &[Vec<Vector>]) -> Result<NoiseFree> {
    for readings in visits_mm {
        crate::iso9283::statistics::sample::positions(readings, 1, "reading-noise")?;
    }
    let means: Vec<Vector> = visits_mm.iter().map(|readings| mean_position(readings)).collect();
    crate::iso9283::statistics::sample::positions(&means, 3, "rp-without-noise")?;
    let repeated: Vec<&Vec<Vector>> = visits_mm.iter().filter(|readings| readings.len() > 1).collect();
    let degrees: usize = repeated.iter().map(|readings| readings.len() - 1).sum();
    if degrees == 0 {
        return Err(error!("visits-read-once").into());
    }
    let mut noise = [[0.0; 3]; 3];
    for readings in repeated {
        let share = (readings.len() - 1) as f64 / degrees as f64;
        add(&mut noise, &covariance(readings), share);
    }
    // mean over the visits of the variance share of noise that remains in a mean of readings
    let kept = visits_mm.iter().map(|readings| 1.0 / readings.len() as f64).sum::<f64>() / visits_mm.len() as f64;
    let with = covariance(&means);
    let mut without = with;
    add(&mut without, &noise, -kept);
    let n = means.len() as f64;
    let trace = |m: &[[f64; 3]; 3]| m[0][0] + m[1][1] + m[2][2];
    // Satterthwaite: effective degrees of freedom of a difference of variances
    let parts = trace(&with).powi(2) / (n - 1.0) + (kept * trace(&noise)).powi(2) / degrees as f64;
    let worth = (trace(&without).powi(2) / parts).clamp(2.0, n - 1.0);
    let expected = |m: [[f64; 3]; 3], degrees: f64| {
        let variances = symmetric_eigen(m).0.map(|v| v.max(0.0));
        repeatability_of_scatter(drawn_together(variances, degrees))
    };
    let found = pose_repeatability(&means)?;
    let (rest, all) = (expected(without, worth), expected(with, n - 1.0));
    Ok(NoiseFree {
        found,
        rp_mm: if all > 0.0 { found.rp_mm * (rest / all).min(1.0) } else { 0.0 },
        noise_mm: [0, 1, 2].map(|k| noise[k][k].sqrt()),
    })
}

/// RP without noise of a pose with at least three visits, if any visit was read twice.
pub fn repeatability_without_noise(pose: &TestedPose) -> Result<Option<NoiseFree>> {
    let read_again = pose.attained.iter().any(|v| v.readings_mm.len() > 1);
    let readings: Vec<Vec<Vector>> = pose.attained.iter().map(|v| v.readings_mm.clone()).collect();
    (read_again && readings.len() > 2).then(|| without_noise(&readings)).transpose()
}

fn add(to: &mut [[f64; 3]; 3], m: &[[f64; 3]; 3], factor: f64) {
    to.iter_mut().flatten().zip(m.iter().flatten()).for_each(|(a, b)| *a += factor * b);
}

/// Returns the mean + 3 s of the radius of Gaussian scatter with these principal variances.
///
/// E √Q = (1 / 2√π) ∫ t^(−3/2) (1 − φ(t)) dt, where φ(t) = Π (1 + 2 v t)^(−1/2) is the Laplace
/// transform of Q. With t = e^u the integrand falls off at both ends, and the trapezoidal rule is
/// exact to rounding.
pub fn repeatability_of_scatter(variances: Vector) -> f64 {
    let largest = variances.iter().copied().fold(0.0, f64::max);
    if largest == 0.0 {
        return 0.0;
    }
    const STEP: f64 = 0.125;
    let at = |i: i32| {
        let u = f64::from(i) * STEP;
        let logs: f64 = variances.iter().map(|v| (2.0 * v / largest * u.exp()).ln_1p()).sum();
        -(-0.5 * logs).exp_m1() * (-0.5 * u).exp()
    };
    let integral = STEP * (-640..=640).map(at).sum::<f64>();
    let mean = largest.sqrt() * integral / (2.0 * std::f64::consts::PI.sqrt());
    let square: f64 = variances.iter().sum();
    mean + 3.0 * (square - mean * mean).max(0.0).sqrt()
}
