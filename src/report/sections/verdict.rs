//! Verdict at the start of a report: compliance with the limits, and improvement of the robot.

use super::limits::{judged, limits, name};
use super::repeatability::quarter_sentence;
use crate::Identified;
use crate::model::{Grade, Headline, Verdict};
use crate::number::{self, Shown};
use crate::words::{Words, names, tr};
use etalon_base::pose_name::PoseName;
use etalon_documents::{
    AccuracyDocument, AccuracySet, Characteristics, Conformity, DecisionRule, ErrorQuantity, ErrorStatistics,
    Iso9283Document, Iso9283Variation, LimitQuantity, LimitVerdict, ParametersDocument, PoseCharacteristic, PoseSet,
    ResidualSummary, Statistics, ToolAccuracy,
};

/// Title of the report; a test of repeatability alone has its own title.
pub(crate) fn title(tested: &Characteristics, words: &Words) -> String {
    let repeatability = tested.poses.as_ref().is_some_and(|d| d.poses.iter().all(|p| p.ap_mm.is_none()));
    match repeatability && tested.compliance.is_none() {
        true => tr!(words, "repeatability-report"),
        false => tr!(words, "iso9283-report"),
    }
}

/// Verdict on everything that is judged: plausibility of the result, characteristics of ISO 9283,
/// instrument, and all limits of the campaign.
pub(crate) fn verdict(identified: Option<&Identified>, tested: &Characteristics, words: &Words) -> Verdict {
    let (limits, alarm) = (limits(identified, tested), identified.and_then(|i| alarm(i.parameters, words)));
    let class = match Conformity::of_all(limits.iter().map(|l| l.conformity)) {
        _ if alarm.is_some() => Grade::Bad,
        Conformity::NotConforming => Grade::Bad,
        Conformity::Conforming if !limits.is_empty() => Grade::Good,
        _ => Grade::Open,
    };
    let set = identified.and_then(|i| headline_set(i.accuracy));
    let mut sentences: Vec<String> = alarm.into_iter().collect();
    sentences.extend(identified.zip(set).and_then(|(i, set)| largest_error(i.accuracy, set, words)));
    sentences.extend(identified.and_then(|i| unexplained(&i.parameters.residuals, words)));
    sentences.extend(characteristics(tested, words));
    // in a test alone, the sentences on characteristics state whether a limit is met
    sentences.extend((identified.is_some() || limits.is_empty()).then(|| counted(&limits, words)));
    let point = identified
        .map(|i| words.worded(&i.accuracy.point, i.accuracy.point_phrase.as_ref()))
        .filter(|point| !point.is_empty());
    let about = set.map(|s| match &point {
        Some(point) => {
            tr!(words, "errors-before-after-of", point, set = words.tr(&names::set(s.name)))
        }
        None => tr!(words, "errors-before-after", set = words.tr(&names::set(s.name))),
    });
    let tool = identified.and_then(|i| i.accuracy.tool.as_ref()).map(|tool| headline_at_tool(tool, words));
    Verdict {
        class,
        met: met(identified, tested),
        sentences,
        about: about.unwrap_or_default(),
        headlines: set.map_or_else(Vec::new, |set| headlines(set, words)).into_iter().chain(tool).collect(),
    }
}

/// Number of limits met, undecided limits, and decision rule.
fn counted(limits: &[&LimitVerdict], words: &Words) -> String {
    let missed = limits.iter().filter(|l| l.conformity == Conformity::NotConforming).count();
    let undecided: Vec<String> = limits
        .iter()
        .filter(|l| l.conformity == Conformity::Neither)
        .map(|l| words.tr(&names::limit(l.name)))
        .collect();
    let sentence = match (limits.len(), missed) {
        (0, _) => return tr!(words, "the-campaign-states-no-limits"),
        (_, 0) if !undecided.is_empty() => String::new(),
        (1, 0) => tr!(words, "limit-met-sentence"),
        (2, 0) => tr!(words, "limits-both-met"),
        (n, 0) => tr!(words, "limits-all-met", count = n),
        (1, _) => tr!(words, "limit-not-met-sentence"),
        (n, m) => tr!(words, "limits-not-met", count = m, total = n),
    };
    let open = match &undecided[..] {
        [] => String::new(),
        names => {
            tr!(words, "limits-undecided", limits = names.join(", "))
        }
    };
    let rule = limits.first().map(|l| tr!(words, "decision-rule-named", rule = name(l.decision_rule, words)));
    let said = [sentence, open, rule.unwrap_or_default()];
    said.into_iter().filter(|s| !s.is_empty()).collect::<Vec<_>>().join(" ")
}

/// Change of the largest error, with its uncertainty and limit.
fn largest_error(accuracy: &AccuracyDocument, set: &AccuracySet, words: &Words) -> Option<String> {
    let e = set.of(ErrorQuantity::Position)?;
    let Shown { unit, factor } = number::shown(&e.unit, e.before.max);
    let limit = accuracy.limits.iter().find(|l| l.name == LimitQuantity::PositionMaxMm);
    let u = e.expanded_uncertainty.map(|u| u * factor);
    let (before, after) = (e.before.max * factor, e.after.max * factor);
    let decimals = u.and_then(|u| number::decimals(u, 2)).or(number::decimals(after, 3)).unwrap_or(1);
    let reached =
        limit.map_or_else(|| number::fixed(after, decimals), |l| number::apart(after, l.limit * factor, decimals));
    let reached = u.map_or(reached.clone(), |u| format!("{reached} ± {}", number::fixed(u, decimals)));
    let (n, set) = (set.poses, words.tr(&names::set(set.name)));
    let changed = match after <= before {
        true => tr!(
            words,
            "largest-error-fell",
            count = n,
            set,
            before = number::fixed(before, decimals),
            after = reached,
            unit
        ),
        false => tr!(
            words,
            "largest-error-rose",
            count = n,
            set,
            before = number::fixed(before, decimals),
            after = reached,
            unit
        ),
    };
    let judged = limit.map(|l| {
        let allowed = number::stated((1e9 * l.limit * factor).round() / 1e9);
        let verdict = judged(l.conformity, words).shown().plain();
        tr!(words, "limit-in-parentheses", limit = allowed, unit, verdict)
    });
    Some(judged.map_or_else(|| format!("{changed}."), |judged| format!("{changed} {judged}.")))
}

/// Size of the residuals relative to the measurement uncertainty.
fn unexplained(r: &ResidualSummary, words: &Words) -> Option<String> {
    let ratio = (r.chi_square? / r.degrees_of_freedom as f64).sqrt();
    let times = number::significant(ratio, 3);
    let of = match r.common_standard_uncertainty_mm {
        Some(_) => tr!(words, "uncertainty-of-instrument-and-contact"),
        None => tr!(words, "uncertainty-of-instrument"),
    };
    ratio.is_finite().then(|| match r.chi_square_rejected {
        true => tr!(words, "model-leaves-residuals", ratio = times, uncertainty = of),
        false => tr!(words, "model-explains-residuals", ratio = times, uncertainty = of),
    })
}

/// `true` if all limits are met and proved, and the result is plausible.
pub(crate) fn met(identified: Option<&Identified>, tested: &Characteristics) -> bool {
    limits(identified, tested).iter().all(|l| l.met)
        && proven(tested)
        && identified.is_none_or(|i| i.parameters.is_plausible())
}

/// Verdict on given parameters, judged on the data of a campaign.
pub(crate) fn of_validation(accuracy: &AccuracyDocument, words: &Words) -> Verdict {
    let limits: Vec<&LimitVerdict> = accuracy.limits.iter().collect();
    let largest = headline_set(accuracy).and_then(|set| largest_error(accuracy, set, words));
    let sentences = largest.into_iter().chain([counted(&limits, words)]).collect();
    let met = limits.iter().all(|l| l.met);
    Verdict { met, class: Grade::of(met), sentences, ..Verdict::default() }
}

/// Verdict of a test without a campaign.
pub(crate) fn of_test(tested: &Characteristics, words: &Words) -> Verdict {
    Verdict { met: proven(tested), sentences: characteristics(tested, words), ..Verdict::default() }
}

/// `true` if the intervals of all poses prove all limits. The intervals contain the instrument's
/// uncertainty; that it exceeds a quarter of a characteristic is a warning.
fn proven(tested: &Characteristics) -> bool {
    conformities(tested).all(|c| c == Conformity::Conforming)
}

/// Verdict of an identification without a campaign.
pub(crate) fn of_identification(document: &ParametersDocument, words: &Words) -> Verdict {
    let sentences = alarm(document, words).into_iter().collect();
    Verdict { met: document.is_plausible(), sentences, ..Verdict::default() }
}

/// Conformities of all poses with all limits.
fn conformities(tested: &Characteristics) -> impl Iterator<Item = Conformity> {
    let poses = tested.poses.iter().flat_map(|d| &d.poses);
    poses.flat_map(|p| PoseCharacteristic::ALL.map(|c| (c.conformity)(p))).flatten()
}

/// Reason why the numbers must not be used.
fn alarm(document: &ParametersDocument, words: &Words) -> Option<String> {
    let termination = document.solver.termination;
    match termination.is_success() {
        true if document.is_plausible() => None,
        true => Some(tr!(words, "parameters-implausible")),
        false => Some(tr!(words, "identification-ended", reason = termination.phrase())),
    }
}

/// Set of the headlines: validation poses, which were not used in the fit, are decisive if there
/// are any.
fn headline_set(accuracy: &AccuracyDocument) -> Option<&AccuracySet> {
    let counted = || accuracy.sets.iter().filter(|s| s.count > 0);
    counted().find(|s| s.name == PoseSet::Validation).or_else(|| counted().next())
}

fn headlines(set: &AccuracySet, words: &Words) -> Vec<Headline> {
    [ErrorQuantity::Position, ErrorQuantity::Orientation]
        .into_iter()
        .filter_map(|quantity| set.of(quantity))
        .flat_map(|e| {
            let name = words.tr(&names::quantity(e.quantity));
            let (max, rms) = (tr!(words, "max-of", quantity = name), tr!(words, "rms-of", quantity = name));
            [headline(e, max, |s| s.max), headline(e, rms, |s| s.rms)]
        })
        .collect()
}

/// Headline of the expected error at the tool point.
fn headline_at_tool(tool: &ToolAccuracy, words: &Words) -> Headline {
    let Shown { unit, factor } = number::shown("mm", tool.before.max);
    let text = |v: f64| number::significant(v * factor, 3);
    let what = tr!(words, "tool-point-headline");
    Headline { what, before: text(tool.before.rms), after: text(tool.after.rms), unit }
}

fn headline(errors: &ErrorStatistics, what: String, number: fn(&Statistics) -> f64) -> Headline {
    let (before, after) = (number(&errors.before), number(&errors.after));
    let Shown { unit, factor } = number::shown(&errors.unit, errors.before.max);
    let by_uncertainty = errors.expanded_uncertainty.and_then(|u| number::decimals(u * factor, 2));
    let text = |v: f64| match by_uncertainty {
        Some(decimals) => number::fixed(v * factor, decimals),
        None => number::significant(v * factor, 3),
    };
    Headline { what, before: text(before), after: text(after), unit }
}

/// Sentences on the worst accuracy and repeatability: their limits, the evidence of their
/// intervals, and the sufficiency of the instrument.
fn characteristics(tested: &Characteristics, words: &Words) -> Vec<String> {
    let Some(document) = &tested.poses else { return Vec::new() };
    let of = |of: PoseCharacteristic, sentence: fn(&str, &PoseName, &Words) -> String| {
        let all = document.poses.iter().filter_map(|p| Some(((of.value)(p)?, p.pose)));
        let (mm, pose) = all.max_by(|a, b| a.0.total_cmp(&b.0))?;
        let limit = document.limits.iter().find(|l| l.name == of.limit);
        // with the decisive digits, even close to the limit
        let apart_um = limit.map(|l| 1e3 * (l.limit - mm).abs());
        let digits = apart_um.and_then(|apart| number::decimals(apart, 2)).unwrap_or(1).clamp(1, 6);
        let um = |mm: f64| number::fixed(1e3 * mm, digits);
        let within = limit.map(|l| within(mm <= l.limit, &um(l.limit), words));
        let said = [Some(sentence(&um(mm), &pose, words)), within, conformity(document, of, words)];
        Some(said.into_iter().flatten().collect::<Vec<_>>().join(" "))
    };
    let accuracy = of(PoseCharacteristic::AP, |accuracy, pose, words| tr!(words, "accuracy-at-pose", accuracy, pose));
    let repeatability = of(PoseCharacteristic::RP, |repeatability, pose, words| {
        tr!(words, "repeatability-at-pose", repeatability, pose)
    });
    let by_approach = pooled(document, words);
    let instrument = Some(quarter_sentence(document, words)).filter(|sentence| !sentence.is_empty());
    [accuracy, by_approach, repeatability, instrument].into_iter().flatten().collect()
}

/// RP of each approach, if a pose has several, because ISO 9283 visits a pose from one direction.
fn pooled(document: &Iso9283Document, words: &Words) -> Option<String> {
    let several = document.approaches.iter().filter(|v| v.approaches.len() > 1);
    let of_pose = |v: &Iso9283Variation| {
        let all: Vec<f64> = v.approaches.iter().filter_map(|a| a.rp_mm).collect();
        let pooled = document.poses.iter().find(|p| p.pose == v.pose)?.rp_mm?;
        let (low, high) = all.iter().fold((f64::INFINITY, 0.0f64), |(a, b), v| (a.min(*v), b.max(*v)));
        (!all.is_empty()).then_some((v.pose, all.len(), low, high, pooled))
    };
    let (pose, count, low, high, pooled) = several.filter_map(of_pose).max_by(|a, b| a.3.total_cmp(&b.3))?;
    let um = |mm: f64| number::fixed(1e3 * mm, 1);
    Some(tr!(
        words,
        "repeatability-from-one-approach",
        smallest = um(low),
        largest = um(high),
        pose,
        approaches = count,
        together = um(pooled)
    ))
}

fn within(within: bool, allowed: &str, words: &Words) -> String {
    match within {
        true => tr!(words, "limit-kept-sentence", limit = allowed),
        false => tr!(words, "limit-exceeded-sentence", limit = allowed),
    }
}

/// Conformity of the poses by ISO 14253-1, if a limit is stated.
fn conformity(document: &Iso9283Document, of: PoseCharacteristic, words: &Words) -> Option<String> {
    let poses = |what| -> Vec<String> {
        document.poses.iter().filter(|p| (of.conformity)(p) == Some(what)).map(|p| p.pose.to_string()).collect()
    };
    let conforming = poses(Conformity::Conforming);
    let (not, neither) = (poses(Conformity::NotConforming), poses(Conformity::Neither));
    let all = conforming.len() + not.len() + neither.len();
    let first = match conforming.len() {
        0 => None,
        1 if all == 1 => Some(tr!(words, "pose-conforms", pose = conforming[0])),
        n if n == all => Some(tr!(words, "all-poses-conform", count = all)),
        n => Some(tr!(words, "poses-conform", count = n, total = all)),
    };
    let second =
        (!not.is_empty()).then(|| tr!(words, "poses-not-conforming", count = not.len(), poses = not.join(", ")));
    let third =
        (!neither.is_empty()).then(|| tr!(words, "poses-undecided", count = neither.len(), poses = neither.join(", ")));
    let said: Vec<String> = [first, second, third].into_iter().flatten().collect();
    let rule = document.limits.first().map_or_else(DecisionRule::default, |l| l.decision_rule);
    (all > 0).then(|| tr!(words, "conformity-by-rule", rule = name(rule, words), results = said.join("; ")))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::demo::Documents;
    use crate::tests::demo_iso9283::whole;
    use etalon_documents::Termination;

    fn of(documents: &Documents) -> Verdict {
        let report = documents.report();
        verdict(report.identified.as_ref(), report.tested, &Words::default())
    }

    #[test]
    fn limits_are_judged_as_stated() {
        let mut documents = Documents::demo();
        let good = of(&documents);
        let expected = [
            "The largest position error at 51 validation poses fell from 2.0895 to 0.0442 ± 0.0038 mm (limit 0.05 mm: met).",
            "What is left is 1.19 times the instrument's uncertainty: the model does not explain everything.",
            "Both limits of the campaign are met. Decision rule: guarded acceptance (ISO 14253-1).",
        ];
        assert_eq!((good.class, &good.sentences[..]), (Grade::Good, &expected.map(str::to_owned)[..]));
        let limit = |u| LimitVerdict::of(LimitQuantity::PositionMaxMm, 0.05, 0.0442, u, DecisionRule::Guarded);
        documents.accuracy.limits[0] = limit(Some(0.038));
        let open = of(&documents);
        assert!(
            open.class == Grade::Open && !open.met && open.sentences[0].ends_with("(limit 0.05 mm: undecided)."),
            "{open:?}"
        );
        assert!(
            open.sentences[2]
                .starts_with("Within its uncertainty it is undecided whether the limit is met: largest position error")
        );
        documents.accuracy.limits[0] = LimitVerdict { limit: 0.04, ..limit(None) }.with(Conformity::NotConforming);
        let bad = of(&documents);
        assert_eq!(bad.class, Grade::Bad);
        assert!(bad.sentences[2].starts_with("1 of 2 limits of the campaign is not met. Decision rule"), "{bad:?}");
        documents.accuracy.limits.clear();
        assert_eq!(of(&documents).class, Grade::Open);
    }

    #[test]
    fn every_verdict_counts_beside_an_identification() {
        let mut documents = Documents::demo();
        documents.tested = whole();
        let open = of(&documents);
        let expected = [
            "The accuracy is 51.20 µm, at pose 2. This is within the limit of 52.00 µm. By guarded acceptance (ISO \
             14253-1): poses 1, 2 are undecided.",
            "From one approach the repeatability is 11.1 to 11.1 µm, at pose 1 with 2 approaches; all of them together: 21.7 µm.",
            "The repeatability is 21.7 µm, at pose 2. This is within the limit of 30.0 µm. By guarded acceptance \
             (ISO 14253-1): all 2 poses conform.",
            "The instrument is good enough for every pose.",
            "Within its uncertainty it is undecided whether the limit is met: largest accuracy AP. Decision rule: guarded acceptance \
             (ISO 14253-1).",
        ];
        assert_eq!(
            (open.class, open.met, &open.sentences[2..]),
            (Grade::Open, false, &expected.map(str::to_owned)[..])
        );
        let poses = documents.tested.poses.as_mut().unwrap();
        poses.poses[0].ap_conformity = Some(Conformity::Conforming);
        poses.limits[0] = poses.limits[0].clone().with(Conformity::Conforming);
        poses.limits[1] = LimitVerdict { limit: 0.02, ..poses.limits[1].clone() }.with(Conformity::NotConforming);
        poses.poses[1].rp_conformity = Some(Conformity::NotConforming);
        let bad = of(&documents);
        assert_eq!((bad.class, bad.met), (Grade::Bad, false));
        assert!(bad.sentences[6].starts_with("1 of 4 limits of the campaign is not met."), "{bad:?}");
        assert!(bad.sentences[2].ends_with("1 of 2 poses conforms; pose 2 is undecided."), "{bad:?}");
        assert!(bad.sentences[4].ends_with("1 of 2 poses conforms; pose 2 does not conform."), "{bad:?}");
    }

    #[test]
    fn a_solver_that_failed_is_never_good() {
        let mut documents = Documents::demo();
        documents.parameters.solver.termination = Termination::IterationLimit;
        let verdict = of(&documents);
        assert!(verdict.class == Grade::Bad && verdict.sentences[0].contains("not converged"), "{verdict:?}");
    }

    #[test]
    fn headlines_are_from_validation_where_there_is_any() {
        let mut documents = Documents::demo();
        assert!(of(&documents).about.contains("validation poses"));
        documents.accuracy.sets.iter_mut().for_each(|s| s.count *= usize::from(s.name == PoseSet::Calibration));
        assert!(of(&documents).about.contains("calibration poses"));
        documents.accuracy.sets.clear();
        assert!(of(&documents).headlines.is_empty());
    }
}
