//! The first thing a reader wants to know: are the limits met, and how much better did the robot get.

use super::limits::limits;
use super::repeatability::quarter_sentence;
use crate::document::{
    AccuracyDocument, AccuracySet, Characteristics, ErrorStatistics, Iso9283Conformity, Iso9283Document, Iso9283Pose,
    ParametersDocument, Statistics, ToolAccuracy,
};
use crate::report::Identified;
use crate::report::model::{Headline, Verdict};
use crate::report::number::{self, Shown};
use crate::report::words::Words;

/// What the report is called: one of repeatability alone is called so.
pub(in crate::report) fn title(tested: &Characteristics, words: &Words) -> String {
    let repeatability = tested.poses.as_ref().is_some_and(|d| d.poses.iter().all(|p| p.ap_mm.is_none()));
    match repeatability && tested.compliance.is_none() {
        true => words.say("Report on repeatability"),
        false => words.say("Test report by ISO 9283"),
    }
}

/// Of everything that is judged: the result itself, the characteristics of ISO 9283, the instrument, and every limit that the
/// campaign states.
pub(in crate::report) fn verdict(identified: Option<&Identified>, tested: &Characteristics, words: &Words) -> Verdict {
    let (limits, alarm) = (limits(identified, tested), identified.and_then(|i| alarm(i.parameters, words)));
    let (within, missed) = (limits.iter().all(|l| l.met), limits.iter().filter(|l| !l.met).count());
    let class = match limits.is_empty() {
        _ if alarm.is_some() || limits.iter().any(|l| l.value > l.limit) => "bad",
        false if within && proven(tested) => "good",
        _ => "open",
    };
    let counted = match (limits.len(), missed) {
        (0, _) => words.say("The campaign states no limits."),
        (1, 0) => words.say("The limit of the campaign is met."),
        (2, 0) => words.say("Both limits of the campaign are met."),
        (n, 0) => words.fill("All {0} limits of the campaign are met.", &[&n]),
        (1, _) => words.say("The limit of the campaign is not met."),
        (n, 1) => words.fill("1 of {0} limits of the campaign is not met.", &[&n]),
        (n, m) => words.fill("{0} of {1} limits of the campaign are not met.", &[&m, &n]),
    };
    let mut sentences: Vec<String> = alarm.into_iter().collect();
    sentences.extend(characteristics(tested, words));
    // of a test alone, the sentences on its characteristics say whether a limit is met
    sentences.extend((identified.is_some() || limits.is_empty()).then_some(counted));
    let set = identified.and_then(|i| headline_set(i.accuracy));
    let point = identified.map(|i| words.say(&i.accuracy.point)).filter(|point| !point.is_empty());
    let about = set.map(|s| match &point {
        Some(point) => {
            words.fill("Errors of {0} before → after calibration, {1} poses:", &[point, &words.say(&s.name)])
        }
        None => words.fill("Errors before → after calibration, {0} poses:", &[&words.say(&s.name)]),
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

/// Whether every limit is met and proven, and the result can be that of a robot.
pub(in crate::report) fn met(identified: Option<&Identified>, tested: &Characteristics) -> bool {
    limits(identified, tested).iter().all(|l| l.met)
        && proven(tested)
        && identified.is_none_or(|i| i.parameters.is_plausible())
}

/// Of a test without a campaign.
pub(in crate::report) fn of_test(tested: &Characteristics, words: &Words) -> Verdict {
    Verdict { met: proven(tested), sentences: characteristics(tested, words), ..Verdict::default() }
}

/// Whether the intervals of every pose prove every limit. They contain the instrument's uncertainty: that it exceeds a quarter of what
/// it verifies is a warning.
fn proven(tested: &Characteristics) -> bool {
    judged(tested).all(|c| c == Iso9283Conformity::Conforming)
}

/// Of an identification without a campaign.
pub(in crate::report) fn of_identification(document: &ParametersDocument, words: &Words) -> Verdict {
    let sentences = alarm(document, words).into_iter().collect();
    Verdict { met: document.is_plausible(), sentences, ..Verdict::default() }
}

/// What the intervals prove of every limit of every pose.
fn judged(tested: &Characteristics) -> impl Iterator<Item = Iso9283Conformity> {
    tested.poses.iter().flat_map(|d| &d.poses).flat_map(|p| [p.ap_conformity, p.rp_conformity]).flatten()
}

/// Why the numbers must not be used.
fn alarm(document: &ParametersDocument, words: &Words) -> Option<String> {
    let termination = document.solver.termination;
    match termination.is_success() {
        true if document.is_plausible() => None,
        true => Some(words.say("These parameters cannot be those of the robot: they must not be loaded.")),
        false => Some(words.fill("The identification failed: {0}.", &[&termination])),
    }
}

/// Validation poses were not used to fit: they decide where there are any.
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

/// The error to expect at the tool point.
fn headline_at_tool(tool: &ToolAccuracy, words: &Words) -> Headline {
    let Shown { unit, factor } = number::shown("mm", tool.before.max);
    let text = |v: f64| number::significant(v * factor, 3);
    let what = words.say("tool point RMS, expected");
    Headline { what, before: text(tool.before.rms), after: text(tool.after.rms), unit }
}

fn headline(errors: &ErrorStatistics, what: String, number: fn(&Statistics) -> f64) -> Headline {
    let (before, after) = (number(&errors.before), number(&errors.after));
    let Shown { unit, factor } = number::shown(&errors.unit, errors.before.max);
    let text = |v: f64| number::significant(v * factor, 3);
    Headline { what, before: text(before), after: text(after), unit }
}

/// The worst accuracy and repeatability, whether they are within their limits and what their intervals prove, and whether the
/// instrument is good enough.
fn characteristics(tested: &Characteristics, words: &Words) -> Vec<String> {
    let Some(document) = &tested.poses else { return Vec::new() };
    let of = |sentence: &str, limit: &str, value: fn(&Iso9283Pose) -> Option<f64>, proved: Proved| {
        let all = document.poses.iter().filter_map(|p| Some((value(p)?, p.pose)));
        let (mm, pose) = all.max_by(|a, b| a.0.total_cmp(&b.0))?;
        let limit = document.limits.iter().find(|l| l.name == limit);
        // with the digits that decide, also where it is close to the limit
        let apart_um = limit.map(|l| 1e3 * (l.limit - mm).abs());
        let digits = apart_um.and_then(|apart| number::decimals(apart, 2)).unwrap_or(1).clamp(1, 6);
        let um = |mm: f64| number::fixed(1e3 * mm, digits);
        let within = limit.map(|l| within(mm <= l.limit, &um(l.limit), words));
        let said = [Some(words.fill(sentence, &[&um(mm), &pose])), within, conformity(document, proved, words)];
        Some(said.into_iter().flatten().collect::<Vec<_>>().join(" "))
    };
    let accuracy = words.say("The accuracy is {0} µm, at pose {1}.");
    let accuracy = of(&accuracy, "accuracy_max_mm", |p| p.ap_mm, |p| p.ap_conformity);
    let repeatability = words.say("The repeatability is {0} µm, at pose {1}.");
    let repeatability = of(&repeatability, "repeatability_max_mm", |p| p.rp_mm, |p| p.rp_conformity);
    let instrument = Some(quarter_sentence(document, words)).filter(|sentence| !sentence.is_empty());
    [accuracy, repeatability, instrument].into_iter().flatten().collect()
}

fn within(within: bool, allowed: &str, words: &Words) -> String {
    match within {
        true => words.fill("This is within the limit of {0} µm.", &[&allowed]),
        false => words.fill("This is not within the limit of {0} µm.", &[&allowed]),
    }
}

/// What the interval of a pose proves of a limit.
type Proved = fn(&Iso9283Pose) -> Option<Iso9283Conformity>;

/// Which poses conform by ISO 14253-1, where a limit is stated.
fn conformity(document: &Iso9283Document, proved: Proved, words: &Words) -> Option<String> {
    let of = |what| -> Vec<String> {
        document.poses.iter().filter(|p| proved(p) == Some(what)).map(|p| p.pose.to_string()).collect()
    };
    let conforming = of(Iso9283Conformity::Conforming);
    let (not, neither) = (of(Iso9283Conformity::NotConforming), of(Iso9283Conformity::Neither));
    let all = conforming.len() + not.len() + neither.len();
    let first = match conforming.len() {
        0 => None,
        1 if all == 1 => Some(words.fill("pose {0} conforms", &[&conforming[0]])),
        1 => Some(words.fill("1 of {0} poses conforms", &[&all])),
        n if n == all => Some(words.fill("all {0} poses conform", &[&all])),
        n => Some(words.fill("{0} of {1} poses conform", &[&n, &all])),
    };
    let second = match &not[..] {
        [] => None,
        [one] => Some(words.fill("pose {0} does not conform", &[one])),
        several => Some(words.fill("poses {0} do not conform", &[&several.join(", ")])),
    };
    let third = match &neither[..] {
        [] => None,
        [one] => Some(words.fill("pose {0} is undecided", &[one])),
        several => Some(words.fill("poses {0} are undecided", &[&several.join(", ")])),
    };
    let said: Vec<String> = [first, second, third].into_iter().flatten().collect();
    (all > 0).then(|| words.fill("By ISO 14253-1 and the intervals of 95 %: {0}.", &[&said.join("; ")]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::solve::Termination;
    use crate::report::tests::demo::Documents;
    use crate::report::tests::demo_iso9283::whole;

    fn of(documents: &Documents) -> Verdict {
        let report = documents.report();
        verdict(report.identified.as_ref(), report.tested, &Words::default())
    }

    #[test]
    fn limits_are_judged_as_stated() {
        let mut documents = Documents::demo();
        let good = of(&documents);
        assert_eq!((good.class, good.sentences[0].as_str()), ("good", "Both limits of the campaign are met."));
        let limit = &mut documents.accuracy.limits[0];
        (limit.met, limit.limit) = (false, 0.9 * limit.value);
        let bad = of(&documents);
        assert_eq!((bad.class, bad.sentences[0].as_str()), ("bad", "1 of 2 limits of the campaign is not met."));
        documents.accuracy.limits.clear();
        assert_eq!(of(&documents).class, "open");
    }

    #[test]
    fn every_verdict_counts_beside_an_identification() {
        let mut documents = Documents::demo();
        documents.tested = whole();
        // within the limit, and not proven to be
        documents.tested.poses.as_mut().unwrap().limits[0].met = false;
        let open = of(&documents);
        let expected = [
            "The accuracy is 51.20 µm, at pose 2. This is within the limit of 52.00 µm. By ISO 14253-1 and the intervals of \
             95 %: poses 1, 2 are undecided.",
            "The repeatability is 21.7 µm, at pose 2. This is within the limit of 30.0 µm. By ISO 14253-1 and the intervals \
             of 95 %: all 2 poses conform.",
            "The instrument is good enough for every pose.",
            "1 of 4 limits of the campaign is not met.",
        ];
        assert_eq!((open.class, open.met, &open.sentences[..]), ("open", false, &expected.map(str::to_owned)[..]));
        let poses = documents.tested.poses.as_mut().unwrap();
        (poses.limits[0].met, poses.poses[0].ap_conformity) = (true, Some(Iso9283Conformity::Conforming));
        (poses.limits[1].met, poses.limits[1].limit) = (false, 0.02);
        poses.poses[1].rp_conformity = Some(Iso9283Conformity::NotConforming);
        let bad = of(&documents);
        assert_eq!((bad.class, bad.met), ("bad", false));
        assert_eq!(bad.sentences.last().unwrap(), "1 of 4 limits of the campaign is not met.");
        assert!(bad.sentences[0].ends_with("1 of 2 poses conforms; pose 2 is undecided."), "{bad:?}");
        assert!(bad.sentences[1].ends_with("1 of 2 poses conforms; pose 2 does not conform."), "{bad:?}");
    }

    #[test]
    fn a_solver_that_failed_is_never_good() {
        let mut documents = Documents::demo();
        documents.parameters.solver.termination = Termination::LostPatience;
        let verdict = of(&documents);
        assert!(verdict.class == "bad" && verdict.sentences[0].contains("not converged"), "{verdict:?}");
    }

    #[test]
    fn headlines_are_from_validation_where_there_is_any() {
        let mut documents = Documents::demo();
        assert!(of(&documents).about.contains("validation poses"));
        documents.accuracy.sets.iter_mut().for_each(|s| s.count *= usize::from(s.name == "calibration"));
        assert!(of(&documents).about.contains("calibration poses"));
        documents.accuracy.sets.clear();
        assert!(of(&documents).headlines.is_empty());
    }
}
