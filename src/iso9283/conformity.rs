//! Conformity with a stated limit (ISO 14253-1's decision rule, unverified against a bought copy): proved only where the
//! whole interval is on one side of the limit.

use super::interval::Interval;

/// What is proved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Conformity {
    /// The whole interval is within the limit.
    Conforming,
    /// The whole interval is beyond it.
    NotConforming,
    /// The limit is within the interval: neither is proved.
    Neither,
}

/// The rule for a characteristic that may be at most `limit_mm`. With intervals of 95 % either verdict is wrong in at most
/// 5 % of tests: 2.5 % where scatter is alike in all directions, up to 4 % where it is not.
pub fn conformity(interval: &Interval, limit_mm: f64) -> Conformity {
    if interval.high_mm <= limit_mm {
        Conformity::Conforming
    } else if interval.low_mm > limit_mm {
        Conformity::NotConforming
    } else {
        Conformity::Neither
    }
}
