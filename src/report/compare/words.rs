//! Changes in words, for the report and for the terminal.

use super::super::number;
use super::super::words::Words;
use crate::base::message::one_line;
use crate::document::{CompareChange, CompareTrend, CompareValue};

/// A change ready to print; what is not known is empty.
pub(crate) struct Change {
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
    pub verdict: String,
}

/// A unit as it stands behind a number.
pub(crate) fn unit(unit: &str) -> String {
    if unit == "1" { String::new() } else { one_line(unit) }
}

/// Half the interval: what the digits of a value follow.
pub(super) fn half(v: &CompareValue) -> Option<f64> {
    Some(0.5 * (v.high? - v.low?))
}

/// A value with its interval.
pub(crate) fn value(v: &CompareValue, words: &Words) -> String {
    let told = |number: f64| number::with_uncertainty(number, half(v));
    match (v.value, v.low, v.high) {
        (None, ..) => words.say("not told"),
        (Some(value), Some(low), Some(high)) => format!("{} [{}, {}]", told(value), told(low), told(high)),
        (Some(value), ..) => told(value),
    }
}

/// Which campaign from which.
pub(super) fn pair(c: &CompareChange, words: &Words) -> String {
    words.fill("{0} from {1}", &[&c.to, &c.from])
}

/// A change of a quantity.
pub(crate) fn change(t: &CompareTrend, c: &CompareChange, words: &Words) -> Change {
    let half = c.low.zip(c.high).map(|(low, high)| 0.5 * (high - low));
    let told = |number: f64| number::with_uncertainty(number, half);
    let change = match c.ratio {
        Some(ratio) => format!("× {}", told(ratio)),
        None => format!("{}{} {}", if c.change > 0.0 { "+" } else { "" }, told(c.change), unit(&t.unit)),
    };
    let interval = c.low.zip(c.high).map(|(low, high)| words.fill("{0} to {1}", &[&told(low), &told(high)]));
    let probability = |p: Option<f64>| p.map_or_else(String::new, |p| number::significant(p, 2));
    Change {
        pair: pair(c, words),
        change: change.trim_end().to_owned(),
        interval: interval.unwrap_or_default(),
        p: probability(c.p),
        p_holm: probability(c.p_holm),
        verdict: match c.significant {
            Some(true) => words.say("changed"),
            Some(false) => words.say("no significant change"),
            None => words.say("no uncertainty is known"),
        },
    }
}
