//! Random numbers from a given seed with one stream per trial, equal on all machines and for any
//! number of threads.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

/// A stream of random numbers.
///
/// # Examples
///
/// ```
/// use etalon_base::noise::Noise;
///
/// // trial 3 of seed 42, twice: ten thousand errors of standard deviation 2 µm
/// let draw = |trial| {
///     let mut noise = Noise::new(42, trial);
///     (0..10_000).map(|_| noise.gaussian(0.002)).collect::<Vec<f64>>()
/// };
/// let errors_mm = draw(3);
/// assert_eq!(errors_mm, draw(3));
/// assert_ne!(errors_mm, draw(4));
///
/// // the standard deviation of 10 000 errors scatters by 0.7 % (1 / √(2 n))
/// let mean_square = errors_mm.iter().map(|e| e * e).sum::<f64>() / 10_000.0;
/// assert!((mean_square.sqrt() / 0.002 - 1.0).abs() < 0.03);
/// ```
pub struct Noise(ChaCha8Rng);

impl Noise {
    /// Returns the stream `trial` of the generator with this seed.
    pub fn new(seed: u64, trial: u64) -> Self {
        let mut generator = ChaCha8Rng::seed_from_u64(seed);
        generator.set_stream(trial);
        Self(generator)
    }

    /// Uniform number in [0, 1).
    fn unit(&mut self) -> f64 {
        (self.0.next_u64() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Uniform number in [−half_width, half_width).
    pub fn uniform(&mut self, half_width: f64) -> f64 {
        (2.0 * self.unit() - 1.0) * half_width
    }

    /// Shuffles the items (Durstenfeld 1964, CACM 7, 420).
    pub fn shuffle<T>(&mut self, items: &mut [T]) {
        for i in (1..items.len()).rev() {
            let j = ((self.uniform(0.5) + 0.5) * (i + 1) as f64) as usize;
            items.swap(i, j.min(i));
        }
    }

    /// Radius and angle (rad) of a pair of independent standard normal numbers (Box & Muller 1958).
    fn polar(&mut self) -> (f64, f64) {
        ((-2.0 * (1.0 - self.unit()).ln()).sqrt(), std::f64::consts::TAU * self.unit())
    }

    /// Normal number with mean zero.
    pub fn gaussian(&mut self, standard_deviation: f64) -> f64 {
        let (radius, angle_rad) = self.polar();
        standard_deviation * radius * angle_rad.cos()
    }

    /// Two independent standard normal numbers, in two thirds of the time of two calls.
    pub fn gaussian_pair(&mut self) -> [f64; 2] {
        let (radius, angle_rad) = self.polar();
        let (sin, cos) = angle_rad.sin_cos();
        [radius * cos, radius * sin]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn moments_and_streams() {
        let mut noise = Noise::new(7, 0);
        let draws: Vec<f64> = (0..20_000).map(|_| noise.gaussian(2.0)).collect();
        let mean = draws.iter().sum::<f64>() / 20_000.0;
        let deviation = (draws.iter().map(|d| (d - mean).powi(2)).sum::<f64>() / 19_999.0).sqrt();
        assert!(mean.abs() < 0.06 && (deviation - 2.0).abs() < 0.04, "{mean} {deviation}");
        let pairs: Vec<[f64; 2]> = (0..20_000).map(|_| noise.gaussian_pair()).collect();
        for [i, j] in [[0, 0], [0, 1], [1, 1]] {
            let product = pairs.iter().map(|pair| pair[i] * pair[j]).sum::<f64>() / 20_000.0;
            assert!((product - f64::from(u8::from(i == j))).abs() < 0.03, "{i} {j}: {product}");
        }
        assert!((0..1000).all(|_| noise.uniform(0.5).abs() <= 0.5));
        assert_ne!(Noise::new(7, 0).uniform(1.0), Noise::new(7, 1).uniform(1.0));
        assert_eq!(Noise::new(7, 3).uniform(1.0), Noise::new(7, 3).uniform(1.0));
    }
}
