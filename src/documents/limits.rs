//! Limits of a campaign, judged with the uncertainty of what they limit by a decision rule that is stated by name.

use super::Iso9283Interval;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// How the uncertainty of a value counts when a limit is judged.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema, clap::ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum DecisionRule {
    /// Met where the value is within the limit, whatever its uncertainty (ILAC-G8:09/2019, 4.2.1)
    SimpleAcceptance,
    /// Met where the value is within the limit by its expanded uncertainty, not met where it is beyond it by as much (ISO 14253-1, ILAC-G8:09/2019, 4.2.2 and 4.2.3)
    #[default]
    Guarded,
    /// Simple acceptance where the expanded uncertainty is at most a quarter of the limit; otherwise undecided (JCGM 106:2012, 8.2.1)
    SharedRisk,
}

/// Largest expanded uncertainty over the limit with which a risk is shared.
const SHARED: f64 = 0.25;

/// What a decision rule says of a value and its limit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Conformity {
    /// Within the limit, as the rule asks for.
    Conforming,
    /// Beyond the limit, as the rule asks for.
    NotConforming,
    /// The uncertainty leaves it open.
    Neither,
}

impl Conformity {
    /// Of several values that all must be within a limit.
    pub fn of_all(values: impl IntoIterator<Item = Self>) -> Self {
        values.into_iter().fold(Self::Conforming, |all, one| match (all, one) {
            (Self::NotConforming, _) | (_, Self::NotConforming) => Self::NotConforming,
            (Self::Conforming, Self::Conforming) => Self::Conforming,
            _ => Self::Neither,
        })
    }
}

impl DecisionRule {
    /// Judges a value that may be at most `limit`; `interval` is that of 95 %, where it is known. A guarded decision is wrong in at most
    /// 5 % of cases either way.
    pub fn judge(self, value: f64, interval: Option<Iso9283Interval>, limit: f64) -> Conformity {
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

/// One limit of the campaign.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LimitVerdict {
    /// Name of the limit in the campaign.
    pub name: String,
    /// Unit of the numbers.
    pub unit: String,
    /// What the campaign allows.
    pub limit: f64,
    /// What was reached, on the validation poses if there are any.
    pub value: f64,
    /// Expanded uncertainty of the value (k = 2); null where it is not known.
    pub expanded_uncertainty: Option<f64>,
    /// The rule by which it is judged.
    pub decision_rule: DecisionRule,
    /// What the rule says.
    pub conformity: Conformity,
    /// Whether the limit is met by the rule.
    pub met: bool,
}

impl LimitVerdict {
    /// A value with its expanded uncertainty (k = 2), judged.
    pub fn of(name: &str, unit: &str, limit: f64, value: f64, expanded: Option<f64>, rule: DecisionRule) -> Self {
        let interval = expanded.map(|u| Iso9283Interval { low_mm: value - u, high_mm: value + u });
        let judged = Self {
            name: name.to_owned(),
            unit: unit.to_owned(),
            limit,
            value,
            expanded_uncertainty: expanded,
            decision_rule: rule,
            conformity: Conformity::Neither,
            met: false,
        };
        judged.with(rule.judge(value, interval, limit))
    }

    /// The same with another conformity.
    pub fn with(self, conformity: Conformity) -> Self {
        Self { conformity, met: conformity == Conformity::Conforming, ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use Conformity::{Conforming, Neither, NotConforming};

    #[test]
    fn each_rule_counts_the_uncertainty_in_its_way() {
        // value, U, then by simple acceptance, guarded, shared risk; limit 0.40
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
            let of = |rule| LimitVerdict::of("p", "mm", 0.4, value, u, rule);
            assert_eq!(rules.map(|rule| of(rule).conformity), expected, "{value} {u:?}");
            assert!(rules.iter().all(|rule| of(*rule).met == (of(*rule).conformity == Conforming)));
        }
        assert_eq!(Conformity::of_all([Conforming, Neither]), Neither);
        assert_eq!(Conformity::of_all([Neither, NotConforming, Conforming]), NotConforming);
        assert_eq!(Conformity::of_all([]), Conforming);
    }
}
