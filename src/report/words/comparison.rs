//! Names of quantities and families of a comparison, and their changes in words.

use super::{Words, tr};
use crate::number;
use etalon_base::message::one_line;
use etalon_documents::{CompareChange, CompareFamily, CompareTrend, CompareValue};

/// Name of a family.
pub(crate) fn family(family: CompareFamily, words: &Words) -> String {
    match family {
        CompareFamily::Robot => tr!(words, "parameters-of-robot"),
        CompareFamily::SetUp => tr!(words, "parameters-of-set-up"),
        CompareFamily::MeanError => tr!(words, "accuracy"),
        CompareFamily::PoseAccuracy => tr!(words, "pose-accuracy-ap"),
        CompareFamily::MeanPosition => tr!(words, "mean-positions"),
        CompareFamily::PoseRepeatability => tr!(words, "pose-repeatability-rp"),
        CompareFamily::PathAccuracy => tr!(words, "path-accuracy-title"),
        CompareFamily::PathRepeatability => tr!(words, "path-repeatability-title"),
    }
}

/// Subject of a figure or row.
pub(crate) fn quantity(trend: &CompareTrend, words: &Words) -> String {
    let name = trend.name.phrase().map_or_else(|| one_line(trend.name.english()), |phrase| words.tr(phrase));
    match trend.family {
        CompareFamily::Robot => tr!(words, "parameter-named", name),
        CompareFamily::SetUp => tr!(words, "set-up-parameter-named", name),
        CompareFamily::MeanError => tr!(words, "mean-error-named", name),
        _ => name,
    }
}

/// A change in printable form; unknown values are empty.
pub(crate) struct Change {
    /// Later and earlier campaign.
    pub pair: String,
    /// Change with its unit, or ratio.
    pub change: String,
    /// Interval of the change.
    pub interval: String,
    /// Probability by chance.
    pub p: String,
    /// Probability corrected for the number of quantities.
    pub p_family: String,
}

/// Unit after a number.
pub(crate) fn unit(unit: &str) -> String {
    if unit == "1" { String::new() } else { one_line(unit) }
}

/// Half of the interval, which determines the digits of a value.
pub(crate) fn half(v: &CompareValue) -> Option<f64> {
    Some(0.5 * (v.high? - v.low?))
}

/// A value with its interval.
pub(crate) fn value(v: &CompareValue, words: &Words) -> String {
    let shown = |number: f64| number::with_uncertainty(number, half(v));
    match (v.value, v.low, v.high) {
        (None, ..) => tr!(words, "not-known"),
        (Some(value), Some(low), Some(high)) => format!("{} [{}, {}]", shown(value), shown(low), shown(high)),
        (Some(value), ..) => shown(value),
    }
}

/// Later and earlier campaign in words.
pub(crate) fn pair(c: &CompareChange, words: &Words) -> String {
    tr!(words, "campaign-from", to = c.to, from = c.from)
}

/// Printable form of a change.
pub(crate) fn change(t: &CompareTrend, c: &CompareChange, words: &Words) -> Change {
    let half = c.low.zip(c.high).map(|(low, high)| 0.5 * (high - low));
    let shown = |number: f64| number::with_uncertainty(number, half);
    let change = match c.ratio {
        Some(ratio) => format!("× {}", shown(ratio)),
        None => format!("{}{} {}", if c.change > 0.0 { "+" } else { "" }, shown(c.change), unit(&t.unit)),
    };
    let interval = c.low.zip(c.high).map(|(low, high)| tr!(words, "range", from = shown(low), to = shown(high)));
    let probability = |p: Option<f64>| p.map_or_else(String::new, number::probability);
    Change {
        pair: pair(c, words),
        change: change.trim_end().to_owned(),
        interval: interval.unwrap_or_default(),
        p: probability(c.p),
        p_family: probability(c.p_family),
    }
}
