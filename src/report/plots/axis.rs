//! Axes with round ticks: steps of 1, 2 or 5 times a power of ten.

use crate::number;

/// An axis between two places of the picture.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Axis {
    low: f64,
    high: f64,
    from: f64,
    to: f64,
    logarithmic: bool,
}

/// Smallest and largest of the finite values.
pub(crate) fn range(values: impl IntoIterator<Item = f64>) -> Option<(f64, f64)> {
    values.into_iter().filter(|v| v.is_finite()).fold(None, |range, v| match range {
        None => Some((v, v)),
        Some((low, high)) => Some((f64::min(low, v), f64::max(high, v))),
    })
}

/// The round step that cuts `span` into at most `count` parts.
pub(crate) fn step(span: f64, count: usize) -> f64 {
    let exact = span / count.max(1) as f64;
    let below = number::round_down_125(exact);
    // 1 → 2 → 5 → 10: the next round number after `below` is at most 2.5 times it
    let next = if number::round_down_125(2.5 * below) > 2.2 * below { 2.5 * below } else { 2.0 * below };
    if below >= exact * (1.0 - 1e-9) { below } else { next }
}

/// Room at the left of an upright axis for its name and these labels, the widest of which decides.
pub(crate) fn left_margin(ticks: &[(f64, String)]) -> f64 {
    const NAME: f64 = 24.0;
    const GAP: f64 = 10.0;
    // a digit of the reports' font is 0.6 of its 12 px wide
    const DIGIT: f64 = 7.2;
    let widest = ticks.iter().map(|(_, label)| label.chars().count()).max().unwrap_or(0);
    NAME + GAP + DIGIT * widest as f64
}

impl Axis {
    /// A linear axis from `low` (drawn at `from`) to `high` (drawn at `to`).
    pub fn linear(low: f64, high: f64, from: f64, to: f64) -> Self {
        let (low, high) = if high > low { (low, high) } else { (low - 1.0, low + 1.0) };
        Self { low, high, from, to, logarithmic: false }
    }

    /// A linear axis from zero to the first round tick at or over `largest`.
    pub fn from_zero(largest: f64, from: f64, to: f64) -> Self {
        let largest = if largest > 0.0 && largest.is_finite() { largest } else { 1.0 };
        let step = step(largest, 5);
        Self::linear(0.0, step * (largest / step - 1e-9).ceil().max(1.0), from, to)
    }

    /// A logarithmic axis over whole decades, at most six below `largest`.
    pub fn logarithmic(smallest: f64, largest: f64, from: f64, to: f64) -> Self {
        Self::decades(smallest, largest, 6, from, to)
    }

    /// The same with at most `most` decades.
    pub fn decades(smallest: f64, largest: f64, most: u8, from: f64, to: f64) -> Self {
        let top = largest.log10().ceil();
        let bottom = smallest.log10().floor().clamp(top - f64::from(most.max(1)), top - 1.0);
        Self { low: bottom, high: top, from, to, logarithmic: true }
    }

    /// Where a value is drawn; values off the axis are drawn at its end.
    pub fn at(&self, value: f64) -> f64 {
        let value = match self.logarithmic {
            true if value > 0.0 => value.log10(),
            true => self.low,
            false => value,
        };
        let share = ((value - self.low) / (self.high - self.low)).clamp(0.0, 1.0);
        self.from + share * (self.to - self.from)
    }

    /// The least value on the axis.
    pub fn low(&self) -> f64 {
        if self.logarithmic { 10f64.powf(self.low) } else { self.low }
    }

    /// The largest value on the axis.
    pub fn high(&self) -> f64 {
        if self.logarithmic { 10f64.powf(self.high) } else { self.high }
    }

    /// Round values on the axis with their labels, at most about `count`.
    pub fn ticks(&self, count: usize) -> Vec<(f64, String)> {
        if self.logarithmic {
            let decades = (self.high - self.low).round() as i32;
            let low = self.low as i32;
            let multiples: &[f64] = if decades <= 2 { &[1.0, 2.0, 5.0] } else { &[1.0] };
            let all = (0..=decades).flat_map(|d| multiples.iter().map(move |m| m * 10f64.powi(low + d)));
            let end = self.high() * (1.0 + 1e-9);
            return all.filter(|&v| v <= end).map(|v| (v, number::significant(v, 1))).collect();
        }
        let step = step(self.high - self.low, count);
        let decimals = number::decimals(step, 1).unwrap_or(0);
        let first = (self.low / step - 1e-9).ceil();
        let values = (0..=count + 1).map(|i| (first + i as f64) * step);
        let end = self.high + 1e-9 * step;
        values.filter(|&v| v <= end).map(|v| (v, number::fixed(v, decimals))).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(axis: &Axis, count: usize) -> Vec<String> {
        axis.ticks(count).into_iter().map(|(_, label)| label).collect()
    }

    #[test]
    fn ticks_are_round() {
        assert_eq!(labels(&Axis::linear(-85.0, 85.0, 0.0, 1.0), 5), ["-50", "0", "50"]);
        assert_eq!(labels(&Axis::linear(0.1, 0.31, 0.0, 1.0), 5), ["0.10", "0.15", "0.20", "0.25", "0.30"]);
        assert_eq!(labels(&Axis::from_zero(43.9, 0.0, 1.0), 5), ["0", "10", "20", "30", "40", "50"]);
        assert_eq!(labels(&Axis::logarithmic(0.3, 900.0, 0.0, 1.0), 5), ["0.1", "1", "10", "100", "1000"]);
        assert_eq!(labels(&Axis::logarithmic(3.0, 9.0, 0.0, 1.0), 5), ["1", "2", "5", "10"]);
    }

    #[test]
    fn every_value_has_a_place_on_the_axis() {
        let axes = [
            Axis::linear(3.0, 3.0, 0.0, 100.0),
            Axis::from_zero(0.0, 0.0, 100.0),
            Axis::from_zero(f64::NAN, 0.0, 100.0),
            Axis::logarithmic(1e-300, 10.0, 0.0, 100.0),
            Axis::logarithmic(10.0, 10.0, 0.0, 100.0),
        ];
        for axis in axes {
            for value in [-1e9, 0.0, 3.0, 10.0, 1e9] {
                assert!((0.0..=100.0).contains(&axis.at(value)), "{axis:?} {value}");
            }
            assert!((1..20).contains(&axis.ticks(5).len()), "{axis:?}");
        }
    }

    #[test]
    fn a_range_passes_over_what_is_not_a_number() {
        assert_eq!(range([f64::NAN, 2.0, -1.0, f64::INFINITY]), Some((-1.0, 2.0)));
        assert_eq!(range([f64::NAN]), None);
    }
}
