//! Whitening of residuals: readings with a common error, and readings with their own covariance.

use crate::model::weights::Weights;
use crate::{Observation, Settings};
use etalon_base::pose_name::PoseName;
use std::collections::BTreeMap;

/// Makes the residuals of coordinates independent and of equal variance.
pub(crate) struct Whitening {
    /// Readings with a common error.
    pub common: Option<Common>,
    /// Uncertainties given for single readings.
    pub(super) weights: Option<Weights>,
}

impl Whitening {
    /// Whitens rows of `width` numbers, divided by the unit.
    pub(super) fn whiten(&self, rows: &mut [f64], width: usize) {
        if let Some(common) = &self.common {
            common.whiten(rows, width);
        }
        if let Some(weights) = &self.weights {
            weights.whiten(rows, width);
        }
    }
}

/// Residuals whose measured positions are one reading, and their whitening.
///
/// k residuals of a coordinate have the covariance u² I + c² 11ᵀ, with u independent and c common.
/// Divided by u, what whitens them is I + (λ − 1) 11ᵀ/k, λ = u / √(u² + k c²): their mean shrinks,
/// differences from it stay.
#[derive(Clone, Debug)]
pub(crate) struct Common {
    /// First row of each residual of one reading, and λ − 1.
    readings: Vec<(Vec<usize>, f64)>,
    dimension: usize,
}

impl Common {
    /// Readings of `observations` (`dimension` rows per measured target): positions with the very
    /// same coordinates are one reading. `None` where the settings state no common uncertainty.
    pub(super) fn new(observations: &[Observation], settings: &Settings, dimension: usize) -> Option<Self> {
        let (u, c) = (settings.standard_uncertainty_mm?, settings.common_uncertainty_mm?);
        let mut readings: BTreeMap<(usize, [u64; 3]), Vec<usize>> = BTreeMap::new();
        let mut row = 0;
        for observation in observations {
            for (target, at) in observation.targets.iter().enumerate() {
                let Some(at) = at else { continue };
                readings.entry((target, at.map(f64::to_bits))).or_default().push(row);
                row += dimension;
            }
        }
        let shrinks = |rows: Vec<usize>| {
            let shrunk = u / (u * u + rows.len() as f64 * c * c).sqrt();
            (rows, shrunk - 1.0)
        };
        Some(Self { readings: readings.into_values().map(shrinks).collect(), dimension })
    }

    /// Whitens rows of `width` numbers that were divided by u.
    pub fn whiten(&self, rows: &mut [f64], width: usize) {
        let length = self.dimension * width;
        let mut common = vec![0.0; length];
        for (reading, shrink) in &self.readings {
            common.fill(0.0);
            for row in reading {
                common.iter_mut().zip(&rows[row * width..][..length]).for_each(|(sum, v)| *sum += v);
            }
            common.iter_mut().for_each(|sum| *sum = shrink * (*sum / reading.len() as f64));
            for row in reading {
                rows[row * width..][..length].iter_mut().zip(&common).for_each(|(v, common)| *v += common);
            }
        }
    }

    /// For each of `count` rows the number of its reading.
    pub(super) fn numbers(&self, count: usize) -> Vec<PoseName> {
        let mut numbers = vec![PoseName::default(); count];
        for (number, (reading, _)) in self.readings.iter().enumerate() {
            for row in reading {
                numbers[*row..][..self.dimension].fill((number as i64).into());
            }
        }
        numbers
    }
}
