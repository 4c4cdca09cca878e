//! The first thing a reader wants to know: are the limits met, and how much better did the robot get.

use super::number::{self, Shown};
use super::words::Words;
use super::{Identified, Report};
use crate::document::{AccuracyDocument, AccuracySet, ErrorStatistics, LimitVerdict, Statistics};
use serde::Serialize;

#[derive(Debug, Serialize)]
pub(super) struct Verdict {
    /// `good`, `bad` or `open`: style of the box
    pub class: &'static str,
    pub sentence: String,
    /// why the numbers must not be used; empty if they may
    pub alarm: String,
    /// the set that the headlines are from
    pub set: String,
    pub headlines: Vec<Headline>,
    pub limits: Vec<Limit>,
}

/// One number before and after.
#[derive(Debug, Serialize)]
pub(super) struct Headline {
    pub what: String,
    pub before: String,
    pub after: String,
    pub unit: &'static str,
}

#[derive(Debug, Serialize)]
pub(super) struct Limit {
    pub name: String,
    pub unit: String,
    pub limit: String,
    pub value: String,
    pub met: bool,
}

pub(super) fn verdict(report: &Report, identified: &Identified, words: &Words) -> Verdict {
    let limits = report.limits();
    let missed = limits.iter().filter(|l| !l.met).count();
    let (class, sentence) = match (limits.len(), missed) {
        (0, _) => ("open", words.say("The campaign states no limits.")),
        (1, 0) => ("good", words.say("The limit of the campaign is met.")),
        (2, 0) => ("good", words.say("Both limits of the campaign are met.")),
        (n, 0) => ("good", words.fill("All {0} limits of the campaign are met.", &[&n])),
        (1, _) => ("bad", words.say("The limit of the campaign is not met.")),
        (n, 1) => ("bad", words.fill("1 of {0} limits of the campaign is not met.", &[&n])),
        (n, m) => ("bad", words.fill("{0} of {1} limits of the campaign are not met.", &[&m, &n])),
    };
    let termination = identified.parameters.solver.termination;
    let converged = termination.is_success() && identified.parameters.is_plausible();
    let alarm = match termination.is_success() {
        true if converged => String::new(),
        true => words.say("These parameters cannot be those of the robot: they must not be loaded."),
        false => words.fill("The identification failed: {0}.", &[&termination]),
    };
    let set = headline_set(identified.accuracy);
    Verdict {
        class: if converged { class } else { "bad" },
        sentence,
        alarm,
        set: set.map_or_else(String::new, |s| words.say(&s.name)),
        headlines: set.map_or_else(Vec::new, |set| headlines(set, words)),
        limits: limits.into_iter().map(limit).collect(),
    }
}

/// Validation poses were not used to fit: they tell the truth where there are any.
fn headline_set(accuracy: &AccuracyDocument) -> Option<&AccuracySet> {
    let counted = || accuracy.sets.iter().filter(|s| s.count > 0);
    counted().find(|s| s.name == "validation").or_else(|| counted().next())
}

fn headlines(set: &AccuracySet, words: &Words) -> Vec<Headline> {
    let whole = |e: &&ErrorStatistics| e.quantity == "position" || e.quantity == "orientation";
    set.errors
        .iter()
        .filter(whole)
        .flat_map(|e| {
            let (max, rms) =
                (words.fill("{0} max", &[&words.say(&e.quantity)]), words.fill("{0} RMS", &[&words.say(&e.quantity)]));
            [headline(e, max, |s| s.max), headline(e, rms, |s| s.rms)]
        })
        .collect()
}

fn headline(errors: &ErrorStatistics, what: String, number: fn(&Statistics) -> f64) -> Headline {
    let (before, after) = (number(&errors.before), number(&errors.after));
    let Shown { unit, factor } = number::shown(&errors.unit, errors.before.max);
    let text = |v: f64| number::significant(v * factor, 3);
    Headline { what, before: text(before), after: text(after), unit }
}

pub(super) fn limit(l: &LimitVerdict) -> Limit {
    // the value with the digits that decide, also where it is close to the limit
    let digits =
        number::decimals((l.limit - l.value).abs(), 2).unwrap_or(0).max(number::decimals(l.limit, 3).unwrap_or(4));
    let value = number::fixed(l.value, digits.min(9));
    Limit { name: l.name.clone(), unit: l.unit.clone(), limit: l.limit.to_string(), value, met: l.met }
}

#[cfg(test)]
mod tests {
    use super::super::demo::Documents;
    use super::*;
    use crate::math::solve::Termination;

    fn of(documents: &Documents) -> Verdict {
        verdict(&documents.report(), &documents.identified(), &Words::default())
    }

    #[test]
    fn limits_are_judged_as_stated() {
        let mut documents = Documents::demo();
        let good = of(&documents);
        assert_eq!((good.class, good.sentence.as_str()), ("good", "Both limits of the campaign are met."));
        documents.accuracy.limits[0].met = false;
        let bad = of(&documents);
        assert_eq!((bad.class, bad.sentence.as_str()), ("bad", "1 of 2 limits of the campaign is not met."));
        documents.accuracy.limits.clear();
        assert_eq!(of(&documents).class, "open");
    }

    #[test]
    fn a_solver_that_failed_is_never_good() {
        let mut documents = Documents::demo();
        documents.parameters.solver.termination = Termination::LostPatience;
        let verdict = of(&documents);
        assert!(verdict.class == "bad" && verdict.alarm.contains("not converged"), "{verdict:?}");
    }

    #[test]
    fn headlines_are_from_validation_where_there_is_any() {
        let mut documents = Documents::demo();
        assert_eq!(of(&documents).set, "validation");
        documents.accuracy.sets.iter_mut().for_each(|s| s.count *= usize::from(s.name == "calibration"));
        assert_eq!(of(&documents).set, "calibration");
        documents.accuracy.sets.clear();
        assert!(of(&documents).headlines.is_empty());
    }

    #[test]
    fn a_value_just_over_its_limit_does_not_look_equal_to_it() {
        let close = LimitVerdict { name: "p".into(), unit: "mm".into(), limit: 0.05, value: 0.050_000_4, met: false };
        assert_eq!(limit(&close).value, "0.05000040");
    }
}
