//! Limits of a campaign, judged by a stated decision rule with the uncertainty of the limited
//! value.

use crate::mirror::mirror;
use crate::{ErrorQuantity, Statistics};
use etalon_standards::decision;
use etalon_standards::iso9283::statistics::interval::Interval;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

mirror! {
    /// Rule by which the uncertainty of a value counts when a limit is judged.
    #[derive(Default, clap::ValueEnum)]
    #[serde(rename_all = "kebab-case")]
    enum DecisionRule of decision::DecisionRule {
        /// Pass if the value is within the limit, whatever its uncertainty (ILAC-G8:09/2019,
        /// 4.2.1).
        SimpleAcceptance,
        /// Pass if the value is within the limit by at least its expanded uncertainty, fail if it
        /// is beyond the limit by as much, otherwise undecided (ISO 14253-1; ILAC-G8:09/2019, 4.2.2
        /// and 4.2.3).
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
    }
}

impl Conformity {
    /// Combines the conformities of several values that must all be within a limit.
    pub fn of_all(values: impl IntoIterator<Item = Self>) -> Self {
        decision::Conformity::of_all(values.into_iter().map(Into::into)).into()
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
    /// Largest repeatability RP of all poses.
    RepeatabilityMaxMm,
    /// Largest accuracy AP of all poses.
    AccuracyMaxMm,
}

/// Selects one of the statistics of errors.
pub type StatisticOf = fn(&Statistics) -> f64;

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

    /// Limited error and statistic; `None` for characteristics of ISO 9283.
    pub fn of_errors(self) -> Option<(ErrorQuantity, StatisticOf)> {
        match self {
            Self::PositionMaxMm => Some((ErrorQuantity::Position, |s| s.max)),
            Self::PositionMeanMm => Some((ErrorQuantity::Position, |s| s.mean)),
            Self::PositionRmsMm => Some((ErrorQuantity::Position, |s| s.rms)),
            Self::OrientationMaxDeg => Some((ErrorQuantity::Orientation, |s| s.max)),
            Self::RepeatabilityMaxMm | Self::AccuracyMaxMm => None,
        }
    }

    /// Error that the limit holds for one by one; `None` if it limits a statistic of several errors
    /// or a characteristic of ISO 9283.
    pub fn of_each_error(self) -> Option<ErrorQuantity> {
        match self {
            Self::PositionMaxMm => Some(ErrorQuantity::Position),
            Self::OrientationMaxDeg => Some(ErrorQuantity::Orientation),
            Self::PositionMeanMm | Self::PositionRmsMm | Self::RepeatabilityMaxMm | Self::AccuracyMaxMm => None,
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
    /// Measured value, at the validation poses if there are any.
    pub value: f64,
    /// Expanded uncertainty of the value (k = 2); null if unknown.
    pub expanded_uncertainty: Option<f64>,
    /// Decision rule.
    pub decision_rule: DecisionRule,
    /// Decision by the rule.
    pub conformity: Conformity,
    /// `true` if the limit is met by the rule.
    pub met: bool,
}

impl LimitVerdict {
    /// Judges a value with its expanded uncertainty (k = 2).
    pub fn of(name: LimitQuantity, limit: f64, value: f64, expanded: Option<f64>, rule: DecisionRule) -> Self {
        let interval = expanded.map(|u| Interval { low_mm: value - u, high_mm: value + u });
        let judged = Self {
            name,
            unit: name.unit().to_owned(),
            limit,
            value,
            expanded_uncertainty: expanded,
            decision_rule: rule,
            conformity: Conformity::Neither,
            met: false,
        };
        judged.with(decision::DecisionRule::from(rule).judge(value, interval, limit).into())
    }

    /// Replaces the conformity.
    pub fn with(self, conformity: Conformity) -> Self {
        Self { conformity, met: conformity == Conformity::Conforming, ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_limit_is_met_where_its_rule_says_conforming() {
        for rule in [DecisionRule::SimpleAcceptance, DecisionRule::Guarded, DecisionRule::SharedRisk] {
            for (value, u) in [(0.30, Some(0.03)), (0.39, Some(0.03)), (0.41, Some(0.03)), (0.30, None)] {
                let of = LimitVerdict::of(LimitQuantity::PositionMaxMm, 0.4, value, u, rule);
                assert_eq!(of.met, of.conformity == Conformity::Conforming, "{rule:?} {value} {u:?}");
            }
        }
    }
}
