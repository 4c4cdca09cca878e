//! Changes of the input that explain data which are not explained as they are.

use super::{Measure, Quality};
use crate::judge::{explains_as_well, explains_better};

/// Deviations (mm, rad) below which data are exact.
const EXACT: [f64; 2] = [1e-5, 1e-7];

/// A change of the input, with the residuals that it leaves.
#[derive(Clone, Debug)]
pub struct AlternativeFit<T> {
    /// The change.
    pub change: T,
    /// Residuals after the change.
    pub quality: Quality,
}

fn floor(measure: Measure) -> f64 {
    if measure == Measure::Position { EXACT[0] } else { EXACT[1] }
}

/// Mean logarithm of the ratio of the standard deviations of two solutions of the same equations,
/// and their redundancy.
fn gain(stated: &Quality, other: &Quality) -> (f64, f64) {
    let (mut sum, mut redundancy) = (0.0, 0.0);
    for (a, b) in stated.components.iter().zip(&other.components) {
        let deviation = |v: f64| v.max(floor(a.measure));
        sum += a.redundancy * (deviation(a.deviation) / deviation(b.deviation)).ln();
        redundancy += a.redundancy;
    }
    if redundancy > 0.0 { (sum / redundancy, redundancy) } else { (0.0, 0.0) }
}

/// Changes that explain data which cannot be explained as they are, best first; none if given
/// uncertainties agree with the data as they are, or if noise alone could leave such a ratio.
pub fn explained<T>(stated: &Quality, changes: Vec<AlternativeFit<T>>) -> Vec<AlternativeFit<T>> {
    if stated.components.iter().all(|c| c.agrees) {
        return Vec::new();
    }
    let mut all: Vec<(f64, AlternativeFit<T>)> = Vec::new();
    for change in changes {
        let (gain, redundancy) = gain(stated, &change.quality);
        // given uncertainties that the change contradicts are no explanation
        let stays = |i: usize| stated.components[i].agrees && !change.quality.components[i].agrees;
        let components = stated.components.len().min(change.quality.components.len());
        if explains_better(gain, redundancy, 1) && !(0..components).any(stays) {
            all.push((gain, change));
        }
    }
    all.sort_by(|a, b| b.0.total_cmp(&a.0));
    let largest = all.first().map_or(0.0, |a| a.0);
    all.into_iter().filter(|a| explains_as_well(largest - a.0)).map(|a| a.1).collect()
}
