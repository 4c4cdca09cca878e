//! Numbers with exactly the significant digits.

/// Text for a non-finite number, in every language.
const NOT_A_NUMBER: &str = "—";

/// `value` with a fixed number of decimals; never "-0".
pub(crate) fn fixed(value: f64, decimals: usize) -> String {
    if !value.is_finite() {
        return NOT_A_NUMBER.to_owned();
    }
    if value.abs() >= 1e15 {
        return format!("{value:e}");
    }
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(digits) if digits.bytes().all(|b| b == b'0' || b == b'.') => digits.to_owned(),
        _ => text,
    }
}

/// Power of ten of the first digit of `value` after rounding to `digits` significant digits.
fn magnitude(value: f64, digits: usize) -> Option<i32> {
    let text = format!("{value:.*e}", digits.saturating_sub(1));
    let exponent = text.split_once('e').and_then(|(_, exponent)| exponent.parse().ok());
    exponent.filter(|_| value.is_finite() && value != 0.0)
}

/// Number of decimals that show `digits` significant digits of `value`, at most 12.
pub(super) fn decimals(value: f64, digits: usize) -> Option<usize> {
    let last = digits as i32 - 1 - magnitude(value, digits)?;
    Some(last.clamp(0, 12) as usize)
}

/// `value` with `digits` significant digits; as a power of ten if very large or small.
pub(crate) fn significant(value: f64, digits: usize) -> String {
    match magnitude(value, digits) {
        Some(exponent) if !(-4..9).contains(&exponent) => format!("{value:.*e}", digits.saturating_sub(1)),
        _ => fixed(value, decimals(value, digits).unwrap_or(0)),
    }
}

/// A number as given by the user.
pub(super) fn stated(value: f64) -> String {
    if value.is_finite() { value.to_string() } else { fixed(value, 0) }
}

/// A quotient whose magnitude matters: one decimal, none from one hundred.
pub(crate) fn ratio(value: f64) -> String {
    fixed(value, if value.abs() < 99.95 { 1 } else { 0 })
}

/// A number computed from given numbers: at most four significant digits, without trailing zeros.
pub(super) fn derived(value: f64) -> String {
    let text = significant(value, 4);
    let (digits, power) = text.split_once('e').map_or((text.as_str(), None), |(digits, power)| (digits, Some(power)));
    let digits = if digits.contains('.') { digits.trim_end_matches('0').trim_end_matches('.') } else { digits };
    power.map_or_else(|| digits.to_owned(), |power| format!("{digits}e{power}"))
}

/// `value` to the second significant digit of its standard uncertainty; four decimals without
/// uncertainty.
pub(crate) fn with_uncertainty(value: f64, u: Option<f64>) -> String {
    fixed(value, u.and_then(|u| decimals(u, 2)).unwrap_or(4))
}

/// `value` with at least `decimals` decimals, and as many as distinguish it from its limit.
pub(super) fn distinct_from_limit(value: f64, limit: f64, decimals: usize) -> String {
    let alike = |n: &usize| value != limit && fixed(value, *n) == fixed(limit, *n);
    fixed(value, (decimals..9).find(|n| !alike(n)).unwrap_or(9))
}

/// Minimum probability that is shown; smaller ones are shown as an upper bound, because their
/// digits are meaningless.
const LEAST_PROBABILITY: f64 = 1e-3;

/// A probability: `0.012`, or `< 0.001`.
pub(crate) fn probability(p: f64) -> String {
    if p < LEAST_PROBABILITY { format!("< {LEAST_PROBABILITY}") } else { significant(p, 2) }
}

/// Minimum percentage that is shown.
const LEAST_PERCENTAGE: f64 = 0.1;

/// Percentage of a risk; small ones are shown as a bound, because their digits are meaningless.
pub(crate) fn percent(percentage: f64) -> String {
    if percentage < LEAST_PERCENTAGE { format!("< {LEAST_PERCENTAGE}") } else { significant(percentage, 2) }
}

/// A probability in a sentence: `p = 0.012`, or `p < 0.001`.
pub(crate) fn p_value(p: f64) -> String {
    let shown = probability(p);
    if shown.starts_with('<') { format!("p {shown}") } else { format!("p = {shown}") }
}

/// Applies a common notation to a column: decimals if no number is below 1e-9, otherwise powers of
/// ten. Other texts are unchanged.
pub(super) fn one_notation(column: Vec<&mut String>) {
    let power = |text: &str| text.split_once('e').and_then(|(_, exponent)| exponent.parse::<i32>().ok());
    let is_number = |text: &&mut String| text.parse::<f64>().is_ok_and(|v| v.is_finite() && v != 0.0);
    let numbers: Vec<&mut String> = column.into_iter().filter(is_number).collect();
    let powers: Vec<i32> = numbers.iter().filter_map(|text| power(text)).collect();
    if powers.len() == numbers.len() {
        return;
    }
    let decimal = powers.iter().all(|p| (-9..15).contains(p));
    for text in numbers {
        let (Ok(value), sign) = (text.parse::<f64>(), if text.starts_with('+') { "+" } else { "" }) else { continue };
        let digits = text.split('e').next().unwrap_or_default().trim_start_matches(['+', '-', '0', '.']);
        let digits = digits.bytes().filter(u8::is_ascii_digit).count().max(1);
        *text = match power(text) {
            Some(p) if decimal => sign.to_owned() + &fixed(value, (digits as i32 - 1 - p).max(0) as usize),
            None if !decimal => format!("{sign}{value:.*e}", digits - 1),
            _ => continue,
        };
    }
}

/// Largest value of the form 1, 2 or 5 times a power of ten up to `value`.
pub(super) fn round_down_125(value: f64) -> f64 {
    let Some(exponent) = magnitude(value, 17) else { return 1.0 };
    let decade = 10f64.powi(exponent);
    [5.0, 2.0].into_iter().map(|m| m * decade).find(|&m| m <= value * (1.0 + 1e-12)).unwrap_or(decade)
}

/// Unit of displayed lengths, and conversion factor from mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct DisplayUnit {
    pub unit: &'static str,
    pub factor: f64,
}

/// Displays lengths below 1 mm in µm; degrees and other units are unchanged.
pub(super) fn display_unit(unit: &str, largest: f64) -> DisplayUnit {
    match unit {
        "mm" if largest < 1.0 => DisplayUnit { unit: "µm", factor: 1000.0 },
        "mm" => DisplayUnit { unit: "mm", factor: 1.0 },
        "deg" => DisplayUnit { unit: "deg", factor: 1.0 },
        _ => DisplayUnit { unit: "", factor: 1.0 },
    }
}

pub(crate) fn quantile(values: impl Iterator<Item = f64>, share: f64) -> f64 {
    let mut sorted: Vec<f64> = values.collect();
    sorted.sort_by(f64::total_cmp);
    sorted.get((sorted.len() as f64 * share) as usize).copied().unwrap_or(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_column_has_one_notation() {
        let shown = |column: &[&str]| {
            let mut column: Vec<String> = column.iter().map(|&c| c.to_owned()).collect();
            one_notation(column.iter_mut().collect());
            column
        };
        assert_eq!(shown(&["0.83", "1.2e-6", "+4.70e-6", "", "—"]), ["0.83", "0.0000012", "+0.00000470", "", "—"]);
        assert_eq!(shown(&["2.882", "7.8e-16", "0", "-0.050"]), ["2.882e0", "7.8e-16", "0", "-5.0e-2"]);
        assert_eq!(shown(&["1.2e-6", "4e-16"]), ["1.2e-6", "4e-16"]);
        assert_eq!(shown(&["1.5", "set"]), ["1.5", "set"]);
    }

    #[test]
    fn values_show_the_second_digit_of_their_uncertainty() {
        assert_eq!(with_uncertainty(299.987_654_321, Some(0.001_234)), "299.9877");
        assert_eq!(with_uncertainty(299.987_654_321, Some(0.000_999)), "299.9877");
        assert_eq!(with_uncertainty(299.987_654_321, Some(0.000_994)), "299.98765");
        assert_eq!(with_uncertainty(299.987_654_321, Some(250.0)), "300");
        assert_eq!(with_uncertainty(299.987_654_321, None), "299.9877");
        assert_eq!(with_uncertainty(1.0, Some(0.0)), "1.0000");
        assert_eq!(with_uncertainty(1.0, Some(f64::NAN)), "1.0000");
    }

    #[test]
    fn a_probability_is_never_zero() {
        let cases =
            [(0.0, "p < 0.001"), (9.9e-4, "p < 0.001"), (0.001, "p = 0.0010"), (0.0123, "p = 0.012"), (1.0, "p = 1.0")];
        cases.iter().for_each(|(p, text)| assert_eq!(p_value(*p), *text));
        assert_eq!(distinct_from_limit(0.005_44, 0.005_40, 4), "0.00544");
        assert_eq!(distinct_from_limit(0.0054, 0.0054, 4), "0.0054");
    }

    #[test]
    fn zero_has_no_sign_and_nan_a_name() {
        assert_eq!(fixed(-0.000_01, 4), "0.0000");
        assert_eq!(fixed(-0.000_06, 4), "-0.0001");
        assert_eq!(fixed(f64::NAN, 2), "—");
        assert_eq!(significant(f64::INFINITY, 3), "—");
        assert_eq!(significant(0.0, 3), "0");
        assert_eq!(significant(f64::MAX, 3), "1.80e308");
    }

    #[test]
    fn significant_digits() {
        let cases = [(1432.2, "1432"), (93.46, "93.5"), (0.009_996, "0.0100"), (1.234e-7, "1.23e-7")];
        for (value, text) in cases {
            assert_eq!(significant(value, 3), text);
        }
    }

    #[test]
    fn quotients_have_no_more_digits_than_a_reader_wants() {
        let cases = [(0.013 / 3.0, "0.004333"), (0.006_365, "0.006365"), (0.05, "0.05"), (12.0, "12"), (2e-6, "2e-6")];
        cases.iter().for_each(|(value, text)| assert_eq!(derived(*value), *text));
        let cases = [(12_434.4, "12434"), (-588.3, "-588"), (99.96, "100"), (-99.9, "-99.9"), (0.04, "0.0")];
        cases.iter().for_each(|(value, text)| assert_eq!(ratio(*value), *text));
    }

    #[test]
    fn round_numbers_are_1_2_or_5() {
        let cases = [(1.0, 1.0), (1.99, 1.0), (2.0, 2.0), (4.9, 2.0), (7.0, 5.0), (2300.0, 2000.0), (0.06, 0.05)];
        for (value, round) in cases {
            assert!((round_down_125(value) / round - 1.0).abs() < 1e-12, "{value}");
        }
        assert_eq!(round_down_125(0.0), 1.0);
    }
}
