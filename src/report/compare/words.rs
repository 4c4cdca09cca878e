//! Changes in words, for the report and for the terminal.

use super::super::number;
use crate::document::{CompareChange, CompareTrend, CompareValue};

/// A change ready to print; what is not known is empty.
pub(crate) struct Words {
    /// Which campaign from which.
    pub pair: String,
    /// The change with its unit, or the ratio.
    pub change: String,
    /// Its interval.
    pub interval: String,
    /// Probability by chance.
    pub p: String,
    /// The same, corrected for the number of quantities.
    pub p_holm: String,
    /// What follows.
    pub verdict: &'static str,
}

/// A unit as it stands behind a number.
pub(crate) fn unit(unit: &str) -> &str {
    if unit == "1" { "" } else { unit }
}

/// Half the interval: what the digits of a value follow.
pub(crate) fn half(v: &CompareValue) -> Option<f64> {
    Some(0.5 * (v.high? - v.low?))
}

/// A value with its interval.
pub(crate) fn value(v: &CompareValue) -> String {
    let told = |number: f64| number::with_uncertainty(number, half(v));
    match (v.value, v.low, v.high) {
        (None, ..) => "not told".to_owned(),
        (Some(value), Some(low), Some(high)) => format!("{} [{}, {}]", told(value), told(low), told(high)),
        (Some(value), ..) => told(value),
    }
}

/// A change of a quantity.
pub(crate) fn change(t: &CompareTrend, c: &CompareChange) -> Words {
    let half = c.low.zip(c.high).map(|(low, high)| 0.5 * (high - low));
    let told = |number: f64| number::with_uncertainty(number, half);
    let change = match c.ratio {
        Some(ratio) => format!("× {}", told(ratio)),
        None => format!("{}{} {}", if c.change > 0.0 { "+" } else { "" }, told(c.change), unit(&t.unit)),
    };
    let probability = |p: Option<f64>| p.map_or_else(String::new, |p| number::significant(p, 2));
    Words {
        pair: format!("{} from {}", c.to, c.from),
        change: change.trim_end().to_owned(),
        interval: c.low.zip(c.high).map_or_else(String::new, |(low, high)| format!("{} to {}", told(low), told(high))),
        p: probability(c.p),
        p_holm: probability(c.p_holm),
        verdict: match c.significant {
            Some(true) => "changed",
            Some(false) => "no significant change",
            None => "no uncertainty is known",
        },
    }
}
