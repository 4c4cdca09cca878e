//! Axes with round ticks: steps of 1, 2 or 5 times a power of ten.

use crate::number::{self, DisplayUnit};

/// Scale of an axis. Values are in the unit of the documents; ends and labels are in the displayed
/// unit.
#[derive(Clone, Debug)]
pub(crate) struct Axis {
    low: f64,
    high: f64,
    shown: DisplayUnit,
    logarithmic: bool,
    /// Labels instead of round numbers.
    labels: Option<Vec<(f64, String)>>,
}

/// Maximum value that is drawn; larger values are blunders.
const DRAWABLE: f64 = 1e12;

/// `true` for values that can be drawn.
pub(crate) fn drawable(value: f64) -> bool {
    value.abs() < DRAWABLE
}

/// Smallest and largest of the finite values.
pub(crate) fn range(values: impl IntoIterator<Item = f64>) -> Option<[f64; 2]> {
    values.into_iter().filter(|v| v.is_finite()).fold(None, |range, v| match range {
        None => Some([v, v]),
        Some([low, high]) => Some([f64::min(low, v), f64::max(high, v)]),
    })
}

/// Largest of the finite values, at least zero.
pub(crate) fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    range(values).map_or(0.0, |[_, high]| high.max(0.0))
}

/// Round step that divides `span` into at most `count` parts.
pub(crate) fn step(span: f64, count: usize) -> f64 {
    let exact = span / count.max(1) as f64;
    let below = number::round_down_125(exact);
    // 1 → 2 → 5 → 10: the next round number after `below` is at most 2.5 times as large
    let next = if number::round_down_125(2.5 * below) > 2.2 * below { 2.5 * below } else { 2.0 * below };
    if below >= exact * (1.0 - 1e-9) { below } else { next }
}

impl Axis {
    /// Linear axis.
    pub fn linear(low: f64, high: f64) -> Self {
        let (low, high) = if high > low { (low, high) } else { (low - 1.0, low + 1.0) };
        Self { low, high, shown: number::display_unit("", 0.0), logarithmic: false, labels: None }
    }

    /// Linear axis with ends in the displayed unit.
    pub fn linear_in(shown: DisplayUnit, low: f64, high: f64) -> Self {
        Self { shown, ..Self::linear(low, high) }
    }

    /// Linear axis over values in a unit, with free margins relative to their range.
    pub fn over(unit: &str, [low, high]: [f64; 2], margin: f64) -> Self {
        let shown = number::display_unit(unit, low.abs().max(high.abs()));
        let margin = margin * (high - low).max(1e-9 * high.abs().max(low.abs()));
        Self::linear_in(shown, (low - margin) * shown.factor, (high + margin) * shown.factor)
    }

    /// Linear axis from zero to the first round tick at or above `largest`.
    pub fn from_zero(unit: &str, largest: f64) -> Self {
        Self::from_zero_in(number::display_unit(unit, largest), largest)
    }

    /// Linear axis from zero in a chosen unit.
    pub fn from_zero_in(shown: DisplayUnit, largest: f64) -> Self {
        let largest = if largest > 0.0 && largest.is_finite() { largest * shown.factor } else { 1.0 };
        let step = step(largest, 5);
        Self::linear_in(shown, 0.0, step * (largest / step - 1e-9).ceil().max(1.0))
    }

    /// Linear axis symmetrical about zero.
    pub fn both_ways(shown: DisplayUnit, largest: f64) -> Self {
        let high = Self::from_zero_in(shown, largest).high;
        Self::linear_in(shown, -high, high)
    }

    /// Logarithmic axis over whole decades, at most `most` of them below `largest`.
    pub fn decades(unit: &str, [smallest, largest]: [f64; 2], most: u8) -> Self {
        let shown = number::display_unit(unit, largest);
        let high = (largest * shown.factor).log10().ceil();
        let low = (smallest * shown.factor).log10().floor().clamp(high - f64::from(most.max(1)), high - 1.0);
        Self { low, high, shown, logarithmic: true, labels: None }
    }

    /// Axis of rows or columns, numbered from zero, with their labels and margins.
    pub fn rows(count: usize, labels: Vec<(f64, String)>, room: f64) -> Self {
        Self { labels: Some(labels), ..Self::linear(-room, count as f64 - 1.0 + room) }
    }

    /// Position of a value as a share of the axis; values beyond an end are drawn at that end.
    pub fn share(&self, value: f64) -> f64 {
        let value = value * self.shown.factor;
        let value = match self.logarithmic {
            true if value > 0.0 => value.log10(),
            true => self.low,
            false => value,
        };
        ((value - self.low) / (self.high - self.low)).clamp(0.0, 1.0)
    }

    /// `true` for values between the ends of the axis.
    pub fn contains(&self, value: f64) -> bool {
        let (low, high) = self.ends();
        (low..=high).contains(&value)
    }

    /// Ends of the axis in the unit of the values.
    pub fn ends(&self) -> (f64, f64) {
        let of = |end: f64| if self.logarithmic { 10f64.powf(end) } else { end } / self.shown.factor;
        (of(self.low), of(self.high))
    }

    /// Displayed unit and its factor.
    pub fn display_unit(&self) -> DisplayUnit {
        self.shown
    }

    /// Number of rows or columns, including margins.
    pub fn length(&self) -> f64 {
        self.high - self.low
    }

    /// `true` for an axis of rows or columns.
    pub fn is_labelled(&self) -> bool {
        self.labels.is_some()
    }

    /// Ticks with their labels: the given labels, or round numbers, at most about `count`.
    pub fn ticks(&self, count: usize) -> Vec<(f64, String)> {
        if let Some(labels) = &self.labels {
            return labels.clone();
        }
        let in_unit = |(v, label): (f64, String)| (v / self.shown.factor, label);
        if self.logarithmic {
            let decades = (self.high - self.low).round() as i32;
            let multiples: &[f64] = if decades <= 2 { &[1.0, 2.0, 5.0] } else { &[1.0] };
            let exponents = (0..=decades).step_by((decades as usize).div_ceil(2 * count.max(1)).max(1));
            let all = exponents.flat_map(|d| multiples.iter().map(move |m| m * 10f64.powi(self.low as i32 + d)));
            let end = 10f64.powf(self.high) * (1.0 + 1e-9);
            return all.filter(|&v| v <= end).map(|v| in_unit((v, number::significant(v, 1)))).collect();
        }
        let step = step(self.high - self.low, count);
        let decimals = number::decimals(step, 1).unwrap_or(0);
        let first = (self.low / step - 1e-9).ceil();
        let values = (0..=count + 1).map(|i| (first + i as f64) * step);
        let end = self.high + 1e-9 * step;
        let label = |v: f64| if v.abs() < 1e-9 * step { "0".to_owned() } else { number::fixed(v, decimals) };
        values.filter(|&v| v <= end).map(|v| in_unit((v, label(v)))).collect()
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
        assert_eq!(labels(&Axis::linear(-85.0, 85.0), 5), ["-50", "0", "50"]);
        assert_eq!(labels(&Axis::linear(0.1, 0.31), 5), ["0.10", "0.15", "0.20", "0.25", "0.30"]);
        assert_eq!(labels(&Axis::from_zero("", 43.9), 5), ["0", "10", "20", "30", "40", "50"]);
        assert_eq!(labels(&Axis::decades("", [0.3, 900.0], 6), 5), ["0.1", "1", "10", "100", "1000"]);
        assert_eq!(labels(&Axis::decades("", [3.0, 9.0], 6), 5), ["1", "2", "5", "10"]);
    }

    #[test]
    fn labels_are_in_the_displayed_unit() {
        let axis = Axis::from_zero("mm", 0.0439);
        assert_eq!(
            (labels(&axis, 5), axis.display_unit().unit),
            (["0", "10", "20", "30", "40", "50"].map(str::to_owned).to_vec(), "µm")
        );
        assert!((axis.share(0.025) - 0.5).abs() < 1e-12 && axis.contains(0.05) && !axis.contains(0.051));
        assert!((axis.ticks(5)[1].0 - 0.01).abs() < 1e-12 && (axis.ends().1 - 0.05).abs() < 1e-12);
    }

    #[test]
    fn every_value_has_a_place_on_the_axis() {
        let axes = [
            Axis::linear(3.0, 3.0),
            Axis::over("mm", [3.0, 3.0], 0.1),
            Axis::from_zero("mm", 0.0),
            Axis::from_zero("", f64::NAN),
            Axis::decades("deg", [1e-300, 10.0], 6),
            Axis::decades("", [10.0, 10.0], 6),
        ];
        for axis in axes {
            for value in [-1e9, 0.0, 3.0, 10.0, 1e9] {
                assert!((0.0..=1.0).contains(&axis.share(value)), "{axis:?} {value}");
            }
            assert!((1..20).contains(&axis.ticks(5).len()), "{axis:?}");
        }
    }

    #[test]
    fn a_range_passes_over_what_is_not_a_number() {
        assert_eq!(range([f64::NAN, 2.0, -1.0, f64::INFINITY]), Some([-1.0, 2.0]));
        assert_eq!((range([f64::NAN]), largest([f64::NAN]), largest([2.0])), (None, 0.0, 2.0));
    }
}
