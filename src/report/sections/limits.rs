//! Limits of the campaign with measured values and verdicts.

use super::verdict::quantity;
use crate::model::{Block, Cell, Columns, Section, Table, Text, significant, strong_term, term};
use crate::number;
use crate::words::Words;
use crate::{Identified, Report};
use etalon_documents::{Acceptance, Characteristics, Conformity, DecisionRule, LimitVerdict};

pub(super) fn section(report: &Report, words: &Words) -> Option<Section> {
    of(&limits(report.identified.as_ref(), report.tested), report.campaign.decision_rule.is_none(), words)
}

/// Section of these limits; `default` if the decision rule was not chosen.
pub(crate) fn of(all: &[&LimitVerdict], default: bool, words: &Words) -> Option<Section> {
    let columns = Columns::<&LimitVerdict>::new()
        .sheet("limit", "", |l| l.name.to_string())
        .page("limit", "", |l| Text::from(quantity(l.name, words)))
        .both("allowed", "", |l| Cell::Number { value: l.limit, shown: l.limit.to_string() })
        .both("reached", "", |l| reached(l).map_or(Cell::Missing, |shown| Cell::Number { value: l.value.unwrap_or(f64::NAN), shown }))
        .both("U (k = 2)", "", |l| significant(l.expanded_uncertainty, 2))
        .both("unit", "", |l| l.unit.as_str())
        .both("margin", "", |l| significant(l.margin, 2))
        .both("risk", "%", |l| significant(l.risk().map(|risk| 100.0 * risk), 2))
        .both("verdict", "", |l| judged(l, words))
        .sheet("decision rule", "", |l| name(l.decision_rule, &Words::default()));
    let mut section = Section::new("limits", words.say("Limits"));
    section.table("", "", Table::of(words, all, columns).on("Limits"));
    if let Some(limit) = all.first() {
        section.push(Block::detail(rule(limit.decision_rule, default, words)));
    }
    section.on_terminal().whole()
}

/// Verdict on a limit.
pub(super) fn judged(l: &LimitVerdict, words: &Words) -> Cell {
    match l.acceptance {
        Acceptance::Pass => term(words, "pass"),
        Acceptance::Conditional => strong_term(words, "conditional"),
        Acceptance::Fail => strong_term(words, "fail"),
        Acceptance::Undecided if l.conformity == Conformity::NotAssessable => strong_term(words, "not assessable"),
        Acceptance::Undecided => strong_term(words, "undecided"),
    }
}

/// Name of a decision rule.
pub(super) fn name(rule: DecisionRule, words: &Words) -> String {
    match rule {
        DecisionRule::SimpleAcceptance => words.say("simple acceptance (ILAC-G8:09/2019, 4.2.1)"),
        DecisionRule::Guarded => words.say("guarded acceptance (ISO 14253-1)"),
        DecisionRule::SharedRisk => words.say("shared risk (JCGM 106:2012, 8.2.1)"),
    }
}

/// Decision rule with its meaning, and whether it was chosen.
fn rule(rule: DecisionRule, default: bool, words: &Words) -> String {
    let means = match rule {
        DecisionRule::SimpleAcceptance => {
            words.say("a limit is met where the value is within it, whatever its uncertainty U")
        }
        DecisionRule::Guarded => words.say("a limit is met where the value is within it by its expanded uncertainty U, not met where it is beyond it by U, and undecided between"),
        DecisionRule::SharedRisk => {
            words.say("a limit is met where the value is within it, and undecided where U exceeds a quarter of the limit")
        }
    };
    let named = words.fill("Decision rule: {0}: {1}.", &[&name(rule, words), &means]);
    let none = words.say("The campaign states no rule; this one then applies.");
    if default { format!("{named} {none}") } else { named }
}

/// All judged limits of the campaign.
pub(super) fn limits<'a>(identified: Option<&'a Identified>, tested: &'a Characteristics) -> Vec<&'a LimitVerdict> {
    identified.iter().flat_map(|i| &i.accuracy.limits).chain(tested.limits()).collect()
}

/// Value to the second digit of its uncertainty, or with as many digits as distinguish it from its
/// limit.
fn reached(l: &LimitVerdict) -> Option<String> {
    let least =
        l.expanded_uncertainty.and_then(|u| number::decimals(u, 2)).or(number::decimals(l.limit, 3)).unwrap_or(4);
    Some(number::apart(l.value?, l.limit, least))
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_documents::LimitQuantity;

    #[test]
    fn a_value_just_over_its_limit_does_not_look_equal_to_it() {
        let of =
            |value, u| reached(&LimitVerdict::of(LimitQuantity::PositionMaxMm, 0.05, value, u, DecisionRule::Guarded)).unwrap();
        assert_eq!(of(0.050_000_4, None), "0.0500004");
        assert_eq!(of(0.050_04, Some(0.0123)), "0.05004");
        assert_eq!(of(0.034_567, Some(0.0123)), "0.035");
        assert_eq!(of(0.05, Some(0.0123)), "0.050");
    }
}
