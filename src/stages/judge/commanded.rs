//! Commanded coordinates instead of measured ones: the nominal robot computes them from the joint
//! values.

use etalon_base::message::Message;
use etalon_base::pose::{Vector, minus, norm};
use etalon_base::{error, phrase};
use etalon_identify::Observation;
use etalon_robots::Robot;

/// Minimum number of positions of a target for a proof: fewer are fitted by the positions of base
/// and targets.
const FEWEST: usize = 10;
/// Numbers of decimals (mm) in files.
const DIGITS: std::ops::RangeInclusive<i32> = 0..=6;
/// Allowance for the positions of base and targets, which are fitted to rounded coordinates.
const ALLOWANCE: f64 = 1.2;
/// Maximum difference (mm) of computed coordinates without rounding.
const COMPUTED_MM: f64 = 1e-6;

/// Returns an error if `robot` with these values (nominal, base and targets located) reproduces the
/// coordinates of a target from the joint values, to the rounding of the file: they were commanded.
pub(crate) fn commanded(robot: &dyn Robot, values: &[f64], observations: &[Observation]) -> Option<Message> {
    let names = robot.targets().iter().enumerate().filter_map(|(k, name)| {
        let measured: Vec<(Vector, Vector)> = observations
            .iter()
            .filter_map(|o| Some((o.targets.get(k).copied().flatten()?, robot.position(values, &o.joints, k))))
            .collect();
        Some((name, measured.len(), reproduced_mm(&measured)?))
    });
    let named: Vec<(&String, usize, f64)> = names.collect();
    let (_, _, largest_mm) = named.iter().copied().max_by(|a, b| a.2.total_cmp(&b.2))?;
    let target = |(name, count, _): &(&String, usize, f64)| phrase!("target-positions", target = name, count);
    let targets: Vec<_> = named.iter().map(target).collect();
    Some(error!("coordinates-commanded", targets, largest_mm))
}

/// Largest difference (mm) of positions from computed ones, if these reproduce all of them to their
/// rounding.
fn reproduced_mm(positions: &[(Vector, Vector)]) -> Option<f64> {
    if positions.len() < FEWEST {
        return None;
    }
    let differences = || positions.iter().map(|(at, computed)| norm(minus(*at, *computed)));
    let largest = differences().fold(0.0, f64::max);
    let step_mm = |digits: &i32| 10f64.powi(-digits);
    let rounded = |digits: &i32| {
        let step = step_mm(digits);
        positions.iter().flat_map(|(at, _)| at).all(|v| (v / step - (v / step).round()).abs() < 1e-4)
    };
    // half a step along each axis
    let allowed = DIGITS.into_iter().find(rounded).map_or(0.0, |digits| 0.5 * 3f64.sqrt() * step_mm(&digits));
    (largest <= ALLOWANCE * allowed.max(COMPUTED_MM)).then_some(largest)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_is_told_from_measuring() {
        let computed = |i: usize| [1000.0 + 7.31 * i as f64, -20.0 + 1.7777 * i as f64, 3.0 + 0.123456789 * i as f64];
        let at = |of: &dyn Fn(f64) -> f64| (0..20).map(|i| (computed(i).map(of), computed(i))).collect::<Vec<_>>();
        assert!(reproduced_mm(&at(&|v| (v * 10.0).round() / 10.0)).is_some_and(|mm| mm < 0.09));
        assert!(reproduced_mm(&at(&|v| v)).is_some_and(|mm| mm == 0.0));
        // an error of a hundredth in data of a thousandth, and of a micrometre in data of a tenth
        // of it
        assert_eq!(reproduced_mm(&at(&|v| ((v + 0.01) * 1000.0).round() / 1000.0)), None);
        assert_eq!(reproduced_mm(&at(&|v| ((v + 0.001) * 10_000.0).round() / 10_000.0)), None);
        assert_eq!(reproduced_mm(&at(&|v| v)[..9]), None);
    }
}
