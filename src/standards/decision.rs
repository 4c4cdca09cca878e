//! Decision rules: role of the uncertainty of a value when its limit is judged (JCGM 106:2012, ISO
//! 14253-1, ILAC-G8:09/2019).

use crate::iso9283::statistics::interval::Interval;

/// Decision rule.
///
/// # Examples
///
/// ```
/// use etalon_standards::decision::{Conformity, DecisionRule};
/// use etalon_standards::iso9283::statistics::interval::Interval;
///
/// // 0.39 mm ± 0.03 mm where 0.40 mm is the limit
/// let interval = Some(Interval { low_mm: 0.36, high_mm: 0.42 });
/// let judged = |rule: DecisionRule| rule.judge(0.39, interval, 0.40);
///
/// assert_eq!(judged(DecisionRule::SimpleAcceptance), Conformity::Conforming);
/// // 0.42 mm is beyond the limit
/// assert_eq!(judged(DecisionRule::Guarded), Conformity::Neither);
/// // 0.03 mm is less than a quarter of the limit
/// assert_eq!(judged(DecisionRule::SharedRisk), Conformity::Conforming);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum DecisionRule {
    /// Simple acceptance: the value alone is compared with the limit (ILAC-G8:09/2019, 4.2.1).
    SimpleAcceptance,
    /// Guard band of the expanded uncertainty on either side of the limit (ISO 14253-1;
    /// ILAC-G8:09/2019, 4.2.2 and 4.2.3).
    #[default]
    Guarded,
    /// Simple acceptance if the expanded uncertainty is at most a quarter of the limit (JCGM
    /// 106:2012, 8.2.1).
    SharedRisk,
}

/// Decision by a rule.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Conformity {
    /// Within the limit.
    Conforming,
    /// Beyond the limit.
    NotConforming,
    /// Undecided: the limit is within the uncertainty.
    Neither,
}

/// Largest ratio of expanded uncertainty to limit for shared risk.
const SHARED: f64 = 0.25;

impl DecisionRule {
    /// Judges a value against an upper limit; `interval` is its 95 % interval, if known. A guarded
    /// decision is wrong in at most 5 % of cases either way.
    pub fn judge(self, value: f64, interval: Option<Interval>, limit: f64) -> Conformity {
        let within = if value <= limit { Conformity::Conforming } else { Conformity::NotConforming };
        match (self, interval) {
            (Self::SimpleAcceptance, _) => within,
            (Self::Guarded, Some(i)) if i.high_mm <= limit => Conformity::Conforming,
            (Self::Guarded, Some(i)) if i.low_mm > limit => Conformity::NotConforming,
            (Self::SharedRisk, Some(i)) if i.high_mm - value <= SHARED * limit => within,
            _ => Conformity::Neither,
        }
    }
}

impl Conformity {
    /// Combines the conformities of several values that must all be within a limit.
    pub fn of_all(values: impl IntoIterator<Item = Self>) -> Self {
        values.into_iter().fold(Self::Conforming, |all, one| match (all, one) {
            (Self::NotConforming, _) | (_, Self::NotConforming) => Self::NotConforming,
            (Self::Conforming, Self::Conforming) => Self::Conforming,
            _ => Self::Neither,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use Conformity::{Conforming, Neither, NotConforming};

    #[test]
    fn each_rule_counts_the_uncertainty_in_its_way() {
        // value, U, then conformity by simple acceptance, guarded and shared risk; limit 0.40
        let cases = [
            (0.30, Some(0.03), [Conforming, Conforming, Conforming]),
            (0.39, Some(0.03), [Conforming, Neither, Conforming]),
            (0.41, Some(0.03), [NotConforming, Neither, NotConforming]),
            (0.50, Some(0.03), [NotConforming, NotConforming, NotConforming]),
            (0.30, Some(0.11), [Conforming, Neither, Neither]),
            (0.30, None, [Conforming, Neither, Neither]),
        ];
        for (value, u, expected) in cases {
            let rules = [DecisionRule::SimpleAcceptance, DecisionRule::Guarded, DecisionRule::SharedRisk];
            let interval = u.map(|u: f64| Interval { low_mm: value - u, high_mm: value + u });
            assert_eq!(rules.map(|rule| rule.judge(value, interval, 0.4)), expected, "{value} {u:?}");
        }
        assert_eq!(Conformity::of_all([Conforming, Neither]), Neither);
        assert_eq!(Conformity::of_all([Neither, NotConforming, Conforming]), NotConforming);
        assert_eq!(Conformity::of_all([]), Conforming);
    }
}
