//! Changes of the input that explain data which are not explained as they are.

use super::{Measure, Quality};
use statrs::distribution::{ContinuousCDF, FisherSnedecor};

/// Ratio of standard deviations from which a change explains the data.
const CLEAR: f64 = 5.0;
/// Probability of a ratio like this by noise, over all changes.
const CHANCE: f64 = 1e-4;
/// Ratio of standard deviations of changes that explain the data equally well.
const AS_GOOD: f64 = 3.0;
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

/// Mean ratio of the standard deviations of two solutions of the same equations, and their
/// redundancy.
fn ratio(stated: &Quality, other: &Quality) -> (f64, f64) {
    let (mut sum, mut redundancy) = (0.0, 0.0);
    for (a, b) in stated.components.iter().zip(&other.components) {
        let deviation = |v: f64| v.max(floor(a.measure));
        sum += a.redundancy * (deviation(a.deviation) / deviation(b.deviation)).ln();
        redundancy += a.redundancy;
    }
    if redundancy > 0.0 { ((sum / redundancy).exp(), redundancy) } else { (1.0, 0.0) }
}

/// Changes that explain data which cannot be explained as they are, best first; none if given
/// uncertainties agree with the data as they are, or if noise alone could leave such a ratio.
pub fn explained<T>(stated: &Quality, changes: Vec<AlternativeFit<T>>) -> Vec<AlternativeFit<T>> {
    if stated.components.iter().all(|c| c.agrees) {
        return Vec::new();
    }
    let count = changes.len().max(1) as f64;
    let mut all: Vec<(f64, AlternativeFit<T>)> = Vec::new();
    for change in changes {
        let (ratio, redundancy) = ratio(stated, &change.quality);
        // given uncertainties that the change contradicts are no explanation
        let stays = |i: usize| stated.components[i].agrees && !change.quality.components[i].agrees;
        let clear = FisherSnedecor::new(redundancy, redundancy)
            .is_ok_and(|f| ratio > CLEAR && f.sf(ratio * ratio) * count < CHANCE);
        if clear && !(0..stated.components.len().min(change.quality.components.len())).any(stays) {
            all.push((ratio, change));
        }
    }
    all.sort_by(|a, b| b.0.total_cmp(&a.0));
    let largest = all.first().map_or(0.0, |a| a.0);
    all.into_iter().filter(|a| a.0 * AS_GOOD >= largest).map(|a| a.1).collect()
}
