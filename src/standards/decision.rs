//! Decision rules: role of the uncertainty of a value when its limit is judged (JCGM 106:2012,
//! ILAC-G8:09/2019), and the verdict that follows.

use crate::iso9283::statistics::interval::Interval;
use statrs::distribution::{ContinuousCDF, Normal};

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
    /// Guard band of the expanded uncertainty on either side of the limit (ILAC-G8:09/2019,
    /// 4.2.3).
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
    /// The limited quantity was not measured.
    NotAssessable,
}

/// Verdict on one limit or on everything that is judged, from the best to the worst.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Acceptance {
    /// Every limit is met, and nothing qualifies this.
    Pass,
    /// Every limit is met by its rule, with a given reservation: a value within the guard band, or
    /// a precondition that is not fulfilled.
    Conditional,
    /// A limit is within the uncertainty of its value, or its quantity was not measured.
    Undecided,
    /// A limit is not met, or the result must not be used.
    Fail,
}

/// Maximum ratio of expanded uncertainty to limit for shared risk.
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
    pub fn combine(values: impl IntoIterator<Item = Self>) -> Self {
        values.into_iter().fold(Self::Conforming, |all, one| match (all, one) {
            (Self::NotConforming, _) | (_, Self::NotConforming) => Self::NotConforming,
            (Self::Conforming, Self::Conforming) => Self::Conforming,
            _ => Self::Neither,
        })
    }

    /// Verdict on a limit. A value that is accepted although its guard band holds the limit is
    /// accepted with a reservation.
    pub fn acceptance(self, is_within_guard_band: bool) -> Acceptance {
        match self {
            Self::Conforming if is_within_guard_band => Acceptance::Conditional,
            Self::Conforming => Acceptance::Pass,
            Self::NotConforming => Acceptance::Fail,
            Self::Neither | Self::NotAssessable => Acceptance::Undecided,
        }
    }
}

impl Acceptance {
    /// `true` if the answer may be loaded: exit code 0.
    pub fn is_accepted(self) -> bool {
        self <= Self::Conditional
    }

    /// The worst of several verdicts; `None` if nothing was judged.
    pub fn worst(values: impl IntoIterator<Item = Self>) -> Option<Self> {
        values.into_iter().max()
    }
}

/// Probability that the true value is within an upper limit, by the measured value with its
/// standard uncertainty alone (JCGM 106:2012, 7.2, normal distribution). The specific risk of a
/// false acceptance is the complement (JCGM 106:2012, 9.3.2).
///
/// # Examples
///
/// ```
/// use etalon_standards::decision::conformity_probability;
///
/// // 0.121 mm against 0.122 mm with u = 0.0075 mm: hardly more than a toss of a coin
/// assert!((conformity_probability(0.121, 0.0075, 0.122) - 0.553).abs() < 5e-4);
/// ```
pub fn conformity_probability(value: f64, standard_uncertainty: f64, limit: f64) -> f64 {
    match standard_uncertainty > 0.0 {
        true => Normal::standard().cdf((limit - value) / standard_uncertainty),
        false => f64::from(u8::from(value <= limit)),
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
        assert_eq!(Conformity::combine([Conforming, Neither]), Neither);
        assert_eq!(Conformity::combine([Neither, NotConforming, Conforming]), NotConforming);
        assert_eq!(Conformity::combine([]), Conforming);
        assert_eq!(Conformity::combine([Conforming, Conformity::NotAssessable]), Neither);
    }

    #[test]
    fn a_value_within_its_guard_band_is_accepted_with_a_reservation() {
        assert_eq!(Conforming.acceptance(false), Acceptance::Pass);
        assert_eq!(Conforming.acceptance(true), Acceptance::Conditional);
        assert_eq!(NotConforming.acceptance(true), Acceptance::Fail);
        assert_eq!(Neither.acceptance(true), Acceptance::Undecided);
        assert_eq!(Conformity::NotAssessable.acceptance(false), Acceptance::Undecided);
        let all = [Acceptance::Conditional, Acceptance::Undecided, Acceptance::Pass];
        assert_eq!(Acceptance::worst(all), Some(Acceptance::Undecided));
        assert_eq!(Acceptance::worst([]), None);
        let accepted = [Acceptance::Pass, Acceptance::Conditional, Acceptance::Undecided, Acceptance::Fail];
        assert_eq!(accepted.map(Acceptance::is_accepted), [true, true, false, false]);
    }

    /// Standard normal distribution at 0, 1 and -1.644854.
    #[test]
    fn the_probability_of_conformity_is_that_of_a_normal_distribution() {
        for (value, expected) in [(0.40, 0.5), (0.37, 0.841_345), (0.40 + 0.03 * 1.644_854, 0.05)] {
            assert!((conformity_probability(value, 0.03, 0.40) - expected).abs() < 1e-6, "{value}");
        }
        assert_eq!([0.3, 0.5].map(|value| conformity_probability(value, 0.0, 0.4)), [1.0, 0.0]);
    }
}
