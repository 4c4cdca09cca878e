//! Limits of the campaign with measured values and verdicts.

use crate::model::{Block, Cell, Columns, Section, Table, Text, number_cell, significant, strong_term, term};
use crate::number;
use crate::words::{Words, names, tr};
use etalon_base::phrase;
use etalon_documents::{Acceptance, Conformity, DecisionRule, LimitVerdict, Results};

pub(super) fn section(results: &Results, words: &Words) -> Option<Section> {
    let all: Vec<&LimitVerdict> = results.verdict.limits.iter().collect();
    let mut section = section_from_verdicts(&all, results.campaign.limits.decision_rule.is_none(), words)?;
    if let Some(file) = &results.verdict.judged_file {
        section.push(Block::text(tr!(words, "limits-are-of-file", file)));
    }
    let specification = results.campaign.limits.specification.clone();
    let specification = specification.unwrap_or_else(|| tr!(words, "not-stated"));
    section.push(Block::facts(vec![(tr!(words, "limits-specification"), specification.into())]));
    Some(section)
}

/// Returns the section of these limits; `default` if the decision rule was not chosen.
pub(crate) fn section_from_verdicts(all: &[&LimitVerdict], default: bool, words: &Words) -> Option<Section> {
    let columns = Columns::<&LimitVerdict>::new()
        .page(phrase!("limit"), "", |l| Text::from(words.tr(&names::limit(l.name))))
        .sheet(phrase!("limit"), "", |l| l.name.to_string())
        .both(phrase!("allowed"), "", |l| Cell::Number { value: l.limit, shown: l.limit.to_string() })
        .both(phrase!("reached"), "", |l| {
            let shown = l.value.and_then(|value| match l.interval {
                Some(_) => Some(reached_within(l, value, 1.0, words)),
                None => reached(l),
            });
            shown.map_or(Cell::Missing, |shown| Cell::Number { value: l.value.unwrap_or(f64::NAN), shown })
        })
        .both("U (k = 2)", "", |l| significant(l.expanded_uncertainty.filter(|_| l.interval.is_none()), 2));
    let columns = match all.iter().any(|l| l.interval.is_some()) {
        true => columns.sheet(phrase!("interval-from"), "", |l| l.interval.map(|[from, _]| from)).sheet(
            phrase!("interval-to"),
            "",
            |l| l.interval.map(|[_, to]| to),
        ),
        false => columns,
    };
    let columns = columns
        .both(phrase!("unit"), "", |l| l.unit.as_str())
        .both(phrase!("margin"), "", |l| significant(l.margin, 2))
        .both(phrase!("risk"), "%", |l| number_cell(l.risk().map(|risk| 100.0 * risk), number::percent))
        .both(phrase!("verdict"), "", |l| judged(l, words))
        .decisive()
        .sheet(phrase!("decision-rule"), "", |l| name(l.decision_rule, &Words::default()));
    let mut section = Section::new("limits", tr!(words, "limits"));
    section.table("", "", Table::new(words, all, columns).on(phrase!("limits")));
    if let Some(limit) = all.first() {
        section.push(Block::detail(rule(limit.decision_rule, default, words)));
        let has_interval = all.iter().any(|l| l.interval.is_some());
        section.push(Block::detail(if has_interval { tr!(words, "limits-by-interval") } else { String::new() }));
        if all.iter().any(|l| l.lacks_coverage()) {
            section.push(Block::text(tr!(words, "risk-without-coverage")));
        }
    }
    section.on_terminal().whole()
}

/// Ends of the interval of a limited value, each `factor` times as large.
fn interval(l: &LimitVerdict, ends: [f64; 2], factor: f64, words: &Words) -> String {
    let decimals = l.expanded_uncertainty.and_then(|u| number::decimals(u * factor, 2)).unwrap_or(1);
    let [from, to] = ends.map(|end| number::fixed(end * factor, decimals));
    tr!(words, "range", from, to)
}

/// Value of a limited quantity with its uncertainty, each `factor` times as large: the value ± U,
/// or the value with the ends of an asymmetric interval.
pub(crate) fn reached_within(l: &LimitVerdict, value: f64, factor: f64, words: &Words) -> String {
    let u = l.expanded_uncertainty.map(|u| u * factor);
    let decimals = u.and_then(|u| number::decimals(u, 2)).or(number::decimals(value * factor, 3)).unwrap_or(1);
    let reached = number::distinct_from_limit(value * factor, l.limit * factor, decimals);
    match (l.interval, u) {
        (Some(ends), _) => format!("{reached} ({})", interval(l, ends, factor, words)),
        (None, Some(u)) => format!("{reached} ± {}", number::fixed(u, decimals)),
        (None, None) => reached,
    }
}

/// Verdict on a limit.
pub(crate) fn judged(l: &LimitVerdict, words: &Words) -> Cell {
    match l.acceptance {
        Acceptance::Pass => term(words, phrase!("pass")),
        Acceptance::Conditional => strong_term(words, phrase!("conditional")),
        Acceptance::Fail => strong_term(words, phrase!("fail")),
        Acceptance::Undecided if l.conformity == Conformity::NotAssessable => {
            strong_term(words, phrase!("not-assessable"))
        }
        Acceptance::Undecided => strong_term(words, phrase!("undecided")),
    }
}

/// Name of a decision rule.
pub(super) fn name(rule: DecisionRule, words: &Words) -> String {
    match rule {
        DecisionRule::SimpleAcceptance => tr!(words, "simple-acceptance"),
        DecisionRule::Guarded => tr!(words, "guarded-acceptance"),
        DecisionRule::SharedRisk => tr!(words, "shared-risk"),
    }
}

/// Decision rule with its meaning, and whether it was chosen.
fn rule(rule: DecisionRule, default: bool, words: &Words) -> String {
    let means = match rule {
        DecisionRule::SimpleAcceptance => {
            tr!(words, "simple-acceptance-explained")
        }
        DecisionRule::Guarded => tr!(words, "guarded-acceptance-explained"),
        DecisionRule::SharedRisk => {
            tr!(words, "shared-risk-explained")
        }
    };
    let named = tr!(words, "decision-rule-explained", rule = name(rule, words), explanation = means);
    let none = tr!(words, "decision-rule-by-default");
    if default { format!("{named} {none}") } else { named }
}

/// Value to the second digit of its uncertainty, or with as many digits as distinguish it from its
/// limit.
fn reached(l: &LimitVerdict) -> Option<String> {
    let least =
        l.expanded_uncertainty.and_then(|u| number::decimals(u, 2)).or(number::decimals(l.limit, 3)).unwrap_or(4);
    Some(number::distinct_from_limit(l.value?, l.limit, least))
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_documents::LimitQuantity;

    #[test]
    fn the_verdict_is_beside_the_name_where_a_narrow_screen_shows_it() {
        let limit = LimitVerdict::judge(LimitQuantity::PositionMaxMm, 0.05, 0.04, Some(0.02), DecisionRule::Guarded);
        let section = section_from_verdicts(&[&limit], false, &Words::default()).unwrap();
        let page = serde_json::to_value(&section).unwrap();
        let heads = page["blocks"][0]["header"].as_array().unwrap();
        assert_eq!((heads[0].as_str(), heads[1].as_str(), heads.len()), (Some("limit"), Some("verdict"), 8));
        assert_eq!(page["blocks"][0]["rows"][0][1]["text"][0]["text"], "undecided");
    }

    #[test]
    fn an_interval_that_is_no_coverage_interval_gives_no_risk() {
        let limit = LimitVerdict::judge(LimitQuantity::AccuracyMaxMm, 0.4, 0.342, Some(0.026), DecisionRule::Guarded);
        let drifting = limit.clone().without_coverage();
        assert_eq!((limit.risk().is_some(), drifting.risk(), drifting.met), (true, None, true));
        let words = Words::default();
        let text = |limit: &LimitVerdict| {
            serde_json::to_string(&section_from_verdicts(&[limit], false, &Words::default()).unwrap()).unwrap()
        };
        let reason = tr!(words, "risk-without-coverage");
        assert!(!text(&limit).contains(&reason) && text(&limit).contains("< 0.1"), "{}", text(&limit));
        assert!(text(&drifting).contains(&reason) && !text(&drifting).contains("< 0.1"), "{}", text(&drifting));
    }

    #[test]
    fn a_value_just_over_its_limit_does_not_look_equal_to_it() {
        let of = |value, u| {
            reached(&LimitVerdict::judge(LimitQuantity::PositionMaxMm, 0.05, value, u, DecisionRule::Guarded)).unwrap()
        };
        assert_eq!(of(0.050_000_4, None), "0.0500004");
        assert_eq!(of(0.050_04, Some(0.0123)), "0.05004");
        assert_eq!(of(0.034_567, Some(0.0123)), "0.035");
        assert_eq!(of(0.05, Some(0.0123)), "0.050");
    }
}
