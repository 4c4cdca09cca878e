//! Errors that observations have in common: a ball measured once is as wrong for every working mode that touches it.

use super::{Observation, Settings};
use std::collections::BTreeMap;

/// Residuals whose measured positions are one reading, and what makes them independent.
///
/// k residuals of a coordinate have the covariance u² I + c² 11ᵀ, with u independent and c common. Divided by u, what
/// whitens them is I + (λ − 1) 11ᵀ/k, λ = u / √(u² + k c²): their mean shrinks, differences from it stay.
#[derive(Debug)]
pub(super) struct Common {
    /// First row of each residual of one reading, and λ − 1.
    readings: Vec<(Vec<usize>, f64)>,
    dimension: usize,
}

impl Common {
    /// Readings of `observations` (`dimension` rows per measured target): positions with the very same coordinates are
    /// one reading. `None` where the settings state no common uncertainty.
    pub fn new(observations: &[Observation], settings: &Settings, dimension: usize) -> Option<Self> {
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
        for (reading, shrink) in &self.readings {
            for offset in 0..self.dimension * width {
                let mean = reading.iter().map(|r| rows[r * width + offset]).sum::<f64>() / reading.len() as f64;
                reading.iter().for_each(|r| rows[r * width + offset] += shrink * mean);
            }
        }
    }

    /// For each of `count` rows the number of its reading.
    pub fn numbers(&self, count: usize) -> Vec<i64> {
        let mut numbers = vec![0; count];
        for (number, (reading, _)) in self.readings.iter().enumerate() {
            for row in reading {
                numbers[*row..][..self.dimension].fill(number as i64);
            }
        }
        numbers
    }
}
