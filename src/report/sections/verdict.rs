//! The first thing a reader wants to know: are the limits met, and how much better did the robot get.

use crate::document::{
    AccuracyDocument, AccuracySet, Characteristics, ErrorStatistics, Iso9283Conformity, Iso9283Document, Iso9283Pose,
    Statistics,
};
use crate::report::model::{Headline, Verdict};
use crate::report::number::{self, Shown};
use crate::report::words::Words;
use crate::report::{Identified, Report};

/// What the report is called: one of repeatability alone is called so.
pub(in crate::report) fn title(tested: &Characteristics, words: &Words) -> String {
    let repeatability = tested.poses.as_ref().is_some_and(|d| d.poses.iter().all(|p| p.ap_mm.is_none()));
    match repeatability && tested.compliance.is_none() {
        true => words.say("Report on repeatability"),
        false => words.say("Test report by ISO 9283"),
    }
}

/// Of every limit that the campaign states, whatever it is a limit of.
pub(in crate::report) fn verdict(report: &Report, words: &Words) -> Verdict {
    let (limits, alarm) = (report.limits(), report.identified.and_then(|i| alarm(&i, words)));
    let open = |p: &Iso9283Pose| [p.ap_conformity, p.rp_conformity].contains(&Some(Iso9283Conformity::Neither));
    let proved = !report.tested.poses.iter().flat_map(|d| &d.poses).any(open);
    let class = match (limits.is_empty(), limits.iter().all(|l| l.met)) {
        _ if alarm.is_some() => "bad",
        (false, false) => "bad",
        (false, true) if proved => "good",
        _ => "open",
    };
    let missed = limits.iter().filter(|l| !l.met).count();
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
    if report.identified.is_none() {
        sentences.extend(characteristics(report.tested, words));
    }
    // of a test alone, the sentences on its characteristics say whether a limit is met
    if report.identified.is_some() || limits.is_empty() {
        sentences.push(counted);
    }
    let set = report.identified.and_then(|i| headline_set(i.accuracy));
    let about = set.map(|s| words.fill("Errors before → after calibration, {0} poses:", &[&words.say(&s.name)]));
    Verdict {
        class,
        sentences,
        about: about.unwrap_or_default(),
        headlines: set.map_or_else(Vec::new, |set| headlines(set, words)),
    }
}

/// Why the numbers must not be used.
fn alarm(identified: &Identified, words: &Words) -> Option<String> {
    let termination = identified.parameters.solver.termination;
    match termination.is_success() {
        true if identified.parameters.is_plausible() => None,
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

fn headline(errors: &ErrorStatistics, what: String, number: fn(&Statistics) -> f64) -> Headline {
    let (before, after) = (number(&errors.before), number(&errors.after));
    let Shown { unit, factor } = number::shown(&errors.unit, errors.before.max);
    let text = |v: f64| number::significant(v * factor, 3);
    Headline { what, before: text(before), after: text(after), unit }
}

/// The worst accuracy and repeatability, whether they are within their limits, and what their intervals prove.
fn characteristics(tested: &Characteristics, words: &Words) -> Vec<String> {
    let Some(document) = &tested.poses else { return Vec::new() };
    let accuracy = worst(document, |p| p.ap_mm).map(|found| {
        let said = |um: &str, pose: i64| words.fill("The accuracy is {0} µm, at pose {1}.", &[&um, &pose]);
        judged(said, found, document, ("accuracy_max_mm", |p| p.ap_conformity), words)
    });
    let repeatability = worst(document, |p| p.rp_mm).map(|found| {
        let said = |um: &str, pose: i64| words.fill("The repeatability is {0} µm, at pose {1}.", &[&um, &pose]);
        judged(said, found, document, ("repeatability_max_mm", |p| p.rp_conformity), words)
    });
    accuracy.into_iter().chain(repeatability).collect()
}

/// The largest value of all poses in mm, and where.
fn worst(document: &Iso9283Document, value: fn(&Iso9283Pose) -> Option<f64>) -> Option<(f64, i64)> {
    let all = document.poses.iter().filter_map(|p| Some((value(p)?, p.pose)));
    all.max_by(|a, b| a.0.total_cmp(&b.0))
}

/// What a limit is called, and what the interval of a pose proves of it.
type Judged = (&'static str, fn(&Iso9283Pose) -> Option<Iso9283Conformity>);

/// What was found, whether it is within the limit, and what the intervals prove of that.
fn judged(
    said: impl Fn(&str, i64) -> String,
    (worst_mm, pose): (f64, i64),
    document: &Iso9283Document,
    (limit, proved): Judged,
    words: &Words,
) -> String {
    let limit = document.limits.iter().find(|l| l.name == limit);
    // with the digits that decide, also where it is close to the limit
    let apart_um = limit.map(|l| 1e3 * (l.limit - worst_mm).abs());
    let digits = apart_um.and_then(|apart| number::decimals(apart, 2)).unwrap_or(1).clamp(1, 6);
    let um = |mm: f64| number::fixed(1e3 * mm, digits);
    let found = said(&um(worst_mm), pose);
    let Some(limit) = limit else { return found };
    let allowed = um(limit.limit);
    let within = match limit.met {
        true => words.fill("This is within the limit of {0} µm.", &[&allowed]),
        false => words.fill("This is not within the limit of {0} µm.", &[&allowed]),
    };
    let count = |what| document.poses.iter().filter(|p| proved(p) == Some(what)).count();
    let [conforming, not, neither] =
        [Iso9283Conformity::Conforming, Iso9283Conformity::NotConforming, Iso9283Conformity::Neither].map(count);
    let told = words.fill(
        "By ISO 14253-1 and the intervals of 95 %: {0} poses conform, {1} do not, {2} are undecided.",
        &[&conforming, &not, &neither],
    );
    let told = if conforming + not + neither > 0 { format!(" {told}") } else { String::new() };
    format!("{found} {within}{told}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::solve::Termination;
    use crate::report::tests::demo::Documents;

    fn of(documents: &Documents) -> Verdict {
        verdict(&documents.report(), &Words::default())
    }

    #[test]
    fn limits_are_judged_as_stated() {
        let mut documents = Documents::demo();
        let good = of(&documents);
        assert_eq!((good.class, good.sentences[0].as_str()), ("good", "Both limits of the campaign are met."));
        documents.accuracy.limits[0].met = false;
        let bad = of(&documents);
        assert_eq!((bad.class, bad.sentences[0].as_str()), ("bad", "1 of 2 limits of the campaign is not met."));
        documents.accuracy.limits.clear();
        assert_eq!(of(&documents).class, "open");
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
