//! Numbers with a fixed count of decimals, as controllers read them.

/// Decimal text; a value that rounds to zero has no sign.
pub(crate) fn fixed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(digits) if digits.bytes().all(|b| matches!(b, b'0' | b'.')) => digits.to_owned(),
        _ => text,
    }
}

/// Decimal texts of several values.
pub(crate) fn all_fixed<const N: usize>(values: [f64; N], decimals: usize) -> [String; N] {
    values.map(|value| fixed(value, decimals))
}

#[cfg(test)]
mod tests {
    use super::fixed;

    #[test]
    fn zero_has_no_sign_after_rounding() {
        let texts = [(-1e-12, 9, "0.000000000"), (-0.0, 3, "0.000"), (-0.4, 0, "0"), (0.0, 1, "0.0")];
        texts.into_iter().for_each(|(value, decimals, text)| assert_eq!(fixed(value, decimals), text, "{value}"));
        // a digit that is left keeps its sign
        let texts = [(-5.1e-10, 9, "-0.000000001"), (-0.6, 0, "-1"), (-120.0, 3, "-120.000"), (2.5e-4, 3, "0.000")];
        texts.into_iter().for_each(|(value, decimals, text)| assert_eq!(fixed(value, decimals), text, "{value}"));
        assert_eq!(fixed(f64::NEG_INFINITY, 2), "-inf");
    }
}
