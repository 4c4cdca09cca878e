//! Readings with their own uncertainties: their residuals are divided by these uncertainties
//! instead of the instrument's.

use crate::{Error, Result};
use crate::{Observation, Settings};
use etalon_base::message::Message;
use etalon_base::pose::Vector;
use etalon_base::warning;
use etalon_math::statistics::rms;
use nalgebra::{DMatrix, Matrix3};

/// Covariance of a position, mm².
pub type Covariance = [Vector; 3];

/// The inverse of the Cholesky factor of a covariance; `None` if it is not positive definite.
fn whitening(covariance: &Covariance, dimension: usize) -> Option<DMatrix<f64>> {
    let matrix = DMatrix::from_fn(dimension, dimension, |i, j| covariance[i][j]);
    matrix.cholesky()?.l().try_inverse()
}

/// `true` if the covariance of the first `dimension` coordinates is positive definite.
pub fn is_positive_definite(covariance: &Covariance, dimension: usize) -> bool {
    whitening(covariance, dimension).is_some()
}

/// The covariance in a frame that is rotated by the rows of `rotation`.
pub fn turned(covariance: &Covariance, rotation: &[Vector; 3]) -> Covariance {
    let of = |rows: &[Vector; 3]| Matrix3::from_fn(|i, j| rows[i][j]);
    let turned = of(rotation) * of(covariance) * of(rotation).transpose();
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| turned[(i, j)]))
}

/// Residuals of readings with their own covariance.
#[derive(Debug)]
pub(crate) struct Weights {
    /// First row of each such reading, and the factor of its rows.
    readings: Vec<(usize, DMatrix<f64>)>,
}

impl Weights {
    /// Weights of observations with `dimension` rows per measured target, which are first divided
    /// by `unit`; `None` if no reading gives a covariance.
    pub fn new(observations: &[Observation], dimension: usize, unit: f64) -> Option<Self> {
        let mut readings = Vec::new();
        let mut row = 0;
        for o in observations {
            for target in (0..o.targets.len()).filter(|&k| o.targets[k].is_some()) {
                let stated = o.covariances_mm2.get(target).copied().flatten();
                readings.extend(stated.and_then(|c| Some((row, whitening(&c, dimension)? * unit))));
                row += dimension;
            }
        }
        (!readings.is_empty()).then_some(Self { readings })
    }

    /// Whitens rows of `width` numbers.
    pub fn whiten(&self, rows: &mut [f64], width: usize) {
        for (row, factor) in &self.readings {
            let here = &mut rows[row * width..][..factor.nrows() * width];
            let white = factor * DMatrix::from_row_slice(factor.nrows(), width, here);
            white.row_iter().zip(here.chunks_exact_mut(width)).for_each(|(white, row)| {
                row.iter_mut().zip(white.iter()).for_each(|(out, value)| *out = *value);
            });
        }
    }
}

/// Completes missing uncertainties of readings from `settings` or, without one there, by the root
/// mean square of the given uncertainties. Reports the weights of readings.
///
/// # Errors
/// Fails if readings have no uncertainty, or if the settings do not permit a weighted comparison.
pub fn weigh(observations: &[Observation], dimension: usize, settings: &mut Settings) -> Result<Option<Message>> {
    let readings = observations.iter().map(|o| o.targets.iter().flatten().count()).sum::<usize>();
    let stated: Vec<f64> = observations.iter().flat_map(|o| o.uncertainties_mm(dimension)).map(|(_, u)| u).collect();
    if stated.is_empty() {
        let lengths = settings.conditions.iter().filter(|c| !c.kind.is_angle()).map(|c| c.standard_uncertainty);
        if readings == 0 && settings.standard_uncertainty_mm.is_none() {
            settings.standard_uncertainty_mm = root_mean_square(lengths);
        }
        return Ok(None);
    }
    if settings.kind == crate::ResidualKind::Pose || settings.common_uncertainty_mm.is_some() {
        return Err(Error::OwnUncertainties);
    }
    if settings.standard_uncertainty_mm.is_none() && stated.len() < readings {
        return Err(Error::ReadingsWithoutUncertainty { without: readings - stated.len(), readings });
    }
    settings.standard_uncertainty_mm = settings.standard_uncertainty_mm.or(root_mean_square(stated.iter().copied()));
    let [least_mm, most_mm] = stated.iter().fold([f64::INFINITY, 0.0], |[a, b], u| [u.min(a), u.max(b)]);
    Ok(Some(warning!("readings-weighted", own = stated.len(), readings, least_mm, most_mm).routine()))
}

fn root_mean_square(all: impl Iterator<Item = f64> + Clone) -> Option<f64> {
    let count = all.clone().count();
    (count > 0).then(|| rms(all))
}
