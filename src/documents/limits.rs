//! Limits of a campaign, judged by a given decision rule with the uncertainty of the limited
//! value.

use crate::mirror::mirror;
use crate::{ErrorQuantity, Figure, Statistics};
use etalon_standards::decision;
use etalon_standards::iso9283::statistics::interval::Interval;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

mirror! {
    /// Rule by which the uncertainty of a value counts when a limit is judged.
    #[derive(Default, clap::ValueEnum)]
    #[serde(rename_all = "kebab-case")]
    enum DecisionRule of decision::DecisionRule {
        /// Pass if the value is within the limit, independent of its uncertainty (ILAC-G8:09/2019,
        /// 4.2.1).
        SimpleAcceptance,
        /// Pass if the value is within the limit by at least its expanded uncertainty, fail if it
        /// is beyond the limit by as much. Otherwise undecided (ILAC-G8:09/2019, 4.2.3).
        #[default]
        Guarded,
        /// Simple acceptance if the expanded uncertainty is at most a quarter of the limit,
        /// otherwise undecided (JCGM 106:2012, 8.2.1).
        SharedRisk,
    }
}

mirror! {
    /// Decision on a value and its limit.
    #[serde(rename_all = "snake_case")]
    enum Conformity of decision::Conformity {
        /// Within the limit, as required by the rule.
        Conforming,
        /// Beyond the limit, as required by the rule.
        NotConforming,
        /// Undecided because of the uncertainty.
        Neither,
        /// The limited quantity was not measured.
        NotAssessable,
    }
}

mirror! {
    /// Verdict on one limit or on everything that is judged, from the best to the worst.
    #[derive(strum::Display, strum::IntoStaticStr)]
    #[serde(rename_all = "snake_case")]
    #[strum(serialize_all = "snake_case")]
    enum Acceptance of decision::Acceptance {
        /// Every limit is met, and nothing qualifies this; exit code 0.
        Pass,
        /// Every limit is met by its rule, with a given reservation: a value within the guard
        /// band, or a precondition that is not fulfilled; exit code 0.
        Conditional,
        /// A limit is within the uncertainty of its value, or its quantity was not measured; exit
        /// code 1.
        Undecided,
        /// A limit is not met, or the result must not be used; exit code 1.
        Fail,
    }
}

impl Acceptance {
    /// `true` if the answer may be loaded: exit code 0.
    pub fn is_accepted(self) -> bool {
        decision::Acceptance::from(self).is_accepted()
    }
}

impl Conformity {
    /// Combines the conformities of several values that must all be within a limit.
    pub fn combine(values: impl IntoIterator<Item = Self>) -> Self {
        decision::Conformity::combine(values.into_iter().map(Into::into)).into()
    }
}

/// Quantity of a limit, by its key in campaigns.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, strum::Display, strum::IntoStaticStr, strum::VariantArray,
)]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "snake_case")]
pub enum LimitQuantity {
    /// Largest position error.
    PositionMaxMm,
    /// Mean position error.
    PositionMeanMm,
    /// Root mean square position error.
    PositionRmsMm,
    /// Largest orientation error.
    OrientationMaxDeg,
    /// Largest error of a distance between a target and a fixed point.
    DistanceMaxMm,
    /// Largest distance of a target from the plane, line or sphere that it touches.
    SurfaceMaxMm,
    /// Largest distance of a target from the socket that it touches.
    ContactMaxMm,
    /// Largest error of a coordinate that was measured singly.
    CoordinateMaxMm,
    /// Upper limit of pose repeatability RP, for every pose.
    RepeatabilityMaxMm,
    /// Upper limit of pose accuracy AP, for every pose.
    AccuracyMaxMm,
}

impl LimitQuantity {
    /// All quantities.
    pub const ALL: &[Self] = <Self as strum::VariantArray>::VARIANTS;

    /// Unit of the limit.
    pub fn unit(self) -> &'static str {
        match self {
            Self::OrientationMaxDeg => "deg",
            _ => "mm",
        }
    }

    /// Limited error with its figure; `None` for characteristics of ISO 9283.
    pub fn limited_error(self) -> Option<(ErrorQuantity, Figure)> {
        match self {
            Self::PositionMaxMm => Some((ErrorQuantity::Position, Figure::Max)),
            Self::PositionMeanMm => Some((ErrorQuantity::Position, Figure::Mean)),
            Self::PositionRmsMm => Some((ErrorQuantity::Position, Figure::Rms)),
            Self::OrientationMaxDeg => Some((ErrorQuantity::Orientation, Figure::Max)),
            Self::DistanceMaxMm => Some((ErrorQuantity::Distance, Figure::Max)),
            Self::SurfaceMaxMm => Some((ErrorQuantity::Surface, Figure::Max)),
            Self::ContactMaxMm => Some((ErrorQuantity::Contact, Figure::Max)),
            Self::CoordinateMaxMm => Some((ErrorQuantity::Coordinate, Figure::Max)),
            Self::RepeatabilityMaxMm | Self::AccuracyMaxMm => None,
        }
    }

    /// Error to which the limit applies one by one; `None` if it limits a statistic of several
    /// errors or a characteristic of ISO 9283.
    pub fn individually_limited_error(self) -> Option<ErrorQuantity> {
        self.limited_error().filter(|(_, figure)| *figure == Figure::Max).map(|(quantity, _)| quantity)
    }
}

impl Figure {
    /// The figure among these statistics.
    pub fn value_in(self, statistics: &Statistics) -> f64 {
        match self {
            Self::Mean => statistics.mean,
            Self::Rms => statistics.rms,
            Self::Max => statistics.max,
        }
    }
}

/// A limit of the campaign and its verdict.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LimitVerdict {
    /// Name of the limit in the campaign.
    #[schemars(with = "String")]
    pub name: LimitQuantity,
    /// Unit of the numbers.
    pub unit: String,
    /// Largest permissible value.
    pub limit: f64,
    /// Measured value, at the validation poses if there are any; null if the quantity was not
    /// measured.
    pub value: Option<f64>,
    /// Expanded uncertainty of the value (k = 2); null if unknown. If `interval` is given, the
    /// distance from the value to its upper end.
    pub expanded_uncertainty: Option<f64>,
    /// Ends of the 95 % interval of the value, if they are not symmetric to it; absent otherwise.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub interval: Option<[f64; 2]>,
    /// Decision rule.
    pub decision_rule: DecisionRule,
    /// Decision by the rule.
    pub conformity: Conformity,
    /// `true` if the limit is met by the rule.
    pub met: bool,
    /// Verdict: the conformity, with a reservation if the value was accepted within its guard band.
    pub acceptance: Acceptance,
    /// Limit minus value; absent without a value.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub margin: Option<f64>,
    /// Probability that the true value is within the limit, by the value with its uncertainty
    /// (JCGM 106:2012, 7.2); the risk of a false acceptance is the complement. Absent if the
    /// uncertainty is unknown, and if the interval of the value is no coverage interval because AP
    /// drifts.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub conformity_probability: Option<f64>,
}

/// Maximum difference of the two sides of an interval that counts as symmetric, over its width.
const SYMMETRIC: f64 = 0.05;

impl LimitVerdict {
    /// Judges a value with its expanded uncertainty (k = 2).
    pub fn judge(name: LimitQuantity, limit: f64, value: f64, expanded: Option<f64>, rule: DecisionRule) -> Self {
        let interval = expanded.map(|u| Interval { low_mm: value - u, high_mm: value + u });
        let probability = |u: f64| decision::conformity_probability(value, 0.5 * u, limit);
        let judged = Self {
            value: Some(value),
            expanded_uncertainty: expanded,
            margin: Some(limit - value),
            conformity_probability: expanded.map(probability),
            ..Self::not_assessable(name, limit, rule)
        };
        judged.with(decision::DecisionRule::from(rule).judge(value, interval, limit).into())
    }

    /// Adds the 95 % interval of the value, if its ends are not symmetric to the value.
    pub fn within_interval(self, low: f64, high: f64) -> Self {
        let asymmetric = |value: &f64| ((high - value) - (value - low)).abs() > SYMMETRIC * (high - low);
        Self { interval: self.value.filter(asymmetric).map(|_| [low, high]), ..self }
    }

    /// Removes the probability of conformity if the interval of the value is no coverage interval.
    pub fn without_coverage(self) -> Self {
        Self { conformity_probability: None, ..self }
    }

    /// `true` if an uncertainty is given, but its interval is no coverage interval: no risk follows
    /// from it.
    pub fn lacks_coverage(&self) -> bool {
        self.expanded_uncertainty.is_some() && self.conformity_probability.is_none()
    }

    /// Limit of a quantity that was not measured.
    pub fn not_assessable(name: LimitQuantity, limit: f64, rule: DecisionRule) -> Self {
        Self {
            name,
            unit: name.unit().to_owned(),
            limit,
            value: None,
            expanded_uncertainty: None,
            interval: None,
            decision_rule: rule,
            conformity: Conformity::NotAssessable,
            met: false,
            acceptance: Acceptance::Undecided,
            margin: None,
            conformity_probability: None,
        }
    }

    /// Replaces the conformity, and with it the verdict.
    pub fn with(self, conformity: Conformity) -> Self {
        let met = conformity == Conformity::Conforming;
        let acceptance = decision::Conformity::from(conformity).acceptance(self.is_reserved()).into();
        Self { conformity, met, acceptance, ..self }
    }

    /// `true` if the limit is less than an expanded uncertainty above the value, or the uncertainty
    /// is unknown.
    pub fn is_within_guard_band(&self) -> bool {
        let within = |(value, u): (f64, f64)| value + u > self.limit;
        self.value.zip(self.expanded_uncertainty).is_none_or(within)
    }

    /// `true` if an accepted value has a reservation: it is within the guard band. Simple
    /// acceptance has no guard band (ILAC-G8:09/2019, 4.2.1), but needs the uncertainty.
    fn is_reserved(&self) -> bool {
        let has_band = self.decision_rule != DecisionRule::SimpleAcceptance || self.expanded_uncertainty.is_none();
        has_band && self.is_within_guard_band()
    }

    /// Probability that an accepted value is beyond the limit (specific risk of a false acceptance,
    /// JCGM 106:2012, 9.3.2).
    pub fn risk(&self) -> Option<f64> {
        self.conformity_probability.map(|p| 1.0 - p)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_limit_is_met_where_its_rule_says_conforming() {
        for rule in [DecisionRule::SimpleAcceptance, DecisionRule::Guarded, DecisionRule::SharedRisk] {
            for (value, u) in [(0.30, Some(0.03)), (0.39, Some(0.03)), (0.41, Some(0.03)), (0.30, None)] {
                let of = LimitVerdict::judge(LimitQuantity::PositionMaxMm, 0.4, value, u, rule);
                assert_eq!(of.met, of.conformity == Conformity::Conforming, "{rule:?} {value} {u:?}");
                assert_eq!(of.met, of.acceptance.is_accepted(), "{rule:?} {value} {u:?}");
            }
        }
    }

    /// The mean error of the sample abb-irb120 compared with the figure of an independent fit.
    #[test]
    fn a_value_just_below_its_limit_is_undecided_or_accepted_with_its_risk() {
        let of = |rule| LimitVerdict::judge(LimitQuantity::PositionMeanMm, 0.122, 0.121, Some(0.015), rule);
        let guarded = of(DecisionRule::default());
        assert_eq!((guarded.conformity, guarded.acceptance), (Conformity::Neither, Acceptance::Undecided));
        let simple = of(DecisionRule::SimpleAcceptance);
        assert_eq!((simple.conformity, simple.acceptance), (Conformity::Conforming, Acceptance::Pass));
        // U is an eighth of the limit
        assert_eq!(of(DecisionRule::SharedRisk).acceptance, Acceptance::Conditional);
        assert!((simple.margin.unwrap() - 0.001).abs() < 1e-12);
        // Φ(0.001/0.0075) = 0.553, by a table of the normal distribution
        assert!((simple.risk().unwrap() - 0.447).abs() < 5e-4, "{simple:?}");
        let far = LimitVerdict { limit: 0.2, ..of(DecisionRule::SharedRisk) }.with(Conformity::Conforming);
        assert_eq!(far.acceptance, Acceptance::Pass);
    }

    /// RP and AP of pose 5 of the sample pose-test: 57.8 to 90.2 µm about 71.6 µm, 328.7 to 355.1
    /// µm about 342.0 µm.
    #[test]
    fn an_interval_is_kept_where_its_ends_are_not_symmetric() {
        let of = |value, [low, high]: [f64; 2]| {
            let rule = DecisionRule::Guarded;
            LimitVerdict::judge(LimitQuantity::RepeatabilityMaxMm, 0.4, value, Some(high - value), rule)
                .within_interval(low, high)
        };
        assert_eq!(of(0.0716, [0.0578, 0.0902]).interval, Some([0.0578, 0.0902]));
        assert_eq!(of(0.342, [0.3287, 0.3551]).interval, None);
    }

    #[test]
    fn a_quantity_that_was_not_measured_is_not_assessable() {
        let of = LimitVerdict::not_assessable(LimitQuantity::PositionMaxMm, 0.1, DecisionRule::SimpleAcceptance);
        assert_eq!((of.conformity, of.acceptance, of.met), (Conformity::NotAssessable, Acceptance::Undecided, false));
        assert_eq!(serde_json::to_value(&of).unwrap()["value"], serde_json::Value::Null);
    }
}
