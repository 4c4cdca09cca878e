//! Ratio of the instrument's uncertainty to the verified characteristic, which may be at most a
//! quarter (ISO 9283:1998 6, unverified against a bought copy).

/// Verdict of the 25 % rule.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UncertaintyRatio {
    /// Expanded uncertainty of a position.
    pub expanded_mm: f64,
    /// Expanded uncertainty of a position over the characteristic.
    pub ratio: f64,
    /// `true` if the ratio is at most 0.25.
    pub met: bool,
}

/// Maximum permissible ratio.
const SHARE: f64 = 0.25;

/// Applies the rule to one characteristic (both in mm); a characteristic of zero never passes.
pub fn uncertainty_ratio(expanded_uncertainty_mm: f64, characteristic_mm: f64) -> UncertaintyRatio {
    let ratio = expanded_uncertainty_mm / characteristic_mm.abs();
    UncertaintyRatio { expanded_mm: expanded_uncertainty_mm, ratio, met: ratio <= SHARE }
}
