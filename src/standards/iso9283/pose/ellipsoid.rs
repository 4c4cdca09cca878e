//! Error ellipsoid (not in the standard): region of the next position with a probability of 95 %.

use crate::iso9283::statistics::scatter::Scatter;
use etalon_base::message::Result;
use etalon_base::pose::Vector;
use etalon_base::{error, phrase};
use statrs::distribution::{ContinuousCDF, FisherSnedecor};

/// Ellipsoid about the mean position; flat in directions without scatter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ellipsoid {
    /// Semi-axes, descending.
    pub semi_axes_mm: Vector,
    /// Unit vectors of the semi-axes.
    pub axes: [Vector; 3],
}

/// Probability that a future position is in the ellipsoid.
const HELD: f64 = 0.95;

/// Prediction ellipsoid for Gaussian scatter: Hotelling's T² of one more position, d (n − 1)(n + 1)
/// / n (n − d) times the quantile of F(d, n − d), where d is the number of directions with scatter.
/// At least d + 2 positions are needed.
pub fn ellipsoid(attained_mm: &[Vector]) -> Result<Ellipsoid> {
    crate::iso9283::statistics::sample::positions(attained_mm, 3, "error-ellipsoid")?;
    let scatter = Scatter::new(attained_mm);
    let directions = scatter.found.iter().filter(|&&v| v > 1e-12 * scatter.found[2]).count();
    let [c, b, a] = scatter.axes;
    if directions == 0 {
        return Ok(Ellipsoid { semi_axes_mm: [0.0; 3], axes: [a, b, c] });
    }
    if attained_mm.len() < directions + 2 {
        let of = phrase!("characteristic", name = "error-ellipsoid");
        return Err(error!("too-few-positions", of, count = attained_mm.len(), least = directions + 2).into());
    }
    let (n, d) = (attained_mm.len() as f64, directions as f64);
    let quantile = FisherSnedecor::new(d, n - d).map_or(f64::NAN, |f| f.inverse_cdf(HELD));
    let squared = d * (n - 1.0) * (n + 1.0) / (n * (n - d)) * quantile;
    let [short, middle, long] = scatter.found.map(|v| (v * squared).sqrt());
    Ok(Ellipsoid { semi_axes_mm: [long, middle, short], axes: [a, b, c] })
}
