//! What the first box of a test report says.

use super::um;
use crate::document::{Characteristics, Iso9283Conformity, Iso9283Document, Iso9283Pose};
use crate::report::words::Words;

/// Style of the box (`good`, `bad` or `open`) and its sentences.
#[derive(Debug)]
pub(in crate::report) struct Verdict {
    pub class: &'static str,
    pub sentences: Vec<String>,
}

/// What the report is called: one of repeatability alone is called so.
pub(in crate::report) fn title(tested: &Characteristics, words: &Words) -> String {
    let repeatability = tested.poses.as_ref().is_some_and(|d| d.poses.iter().all(|p| p.ap_mm.is_none()));
    match repeatability && tested.compliance.is_none() {
        true => words.say("Report on repeatability"),
        false => words.say("Test report by ISO 9283"),
    }
}

pub(in crate::report) fn verdict(tested: &Characteristics, words: &Words) -> Verdict {
    let mut sentences = Vec::new();
    if let Some(document) = &tested.poses {
        let found = worst(document, |p| p.ap_mm)
            .map(|(ap, pose)| words.fill("The accuracy is {0} µm, at pose {1}.", &[&ap, &pose]));
        sentences.extend(judged(found, document, "accuracy_max_mm", |p| p.ap_conformity, words));
        let found = worst(document, |p| p.rp_mm)
            .map(|(rp, pose)| words.fill("The repeatability is {0} µm, at pose {1}.", &[&rp, &pose]));
        sentences.extend(judged(found, document, "repeatability_max_mm", |p| p.rp_conformity, words));
    }
    let met: Vec<bool> = tested.limits().map(|l| l.met).collect();
    if met.is_empty() {
        sentences.push(words.say("The campaign states no limit."));
    }
    let class = match (met.is_empty(), met.iter().all(|met| *met)) {
        (true, _) => "open",
        (false, true) => "good",
        (false, false) => "bad",
    };
    Verdict { class, sentences }
}

/// The largest value of all poses in µm, and where.
fn worst(document: &Iso9283Document, value: fn(&Iso9283Pose) -> Option<f64>) -> Option<(String, i64)> {
    let all = document.poses.iter().filter_map(|p| Some((value(p)?, p.pose)));
    all.max_by(|a, b| a.0.total_cmp(&b.0)).map(|(value, pose)| (um(Some(value)), pose))
}

/// What was found, whether it is within the limit, and what the intervals prove of that.
fn judged(
    found: Option<String>,
    document: &Iso9283Document,
    limit: &str,
    proved: fn(&Iso9283Pose) -> Option<Iso9283Conformity>,
    words: &Words,
) -> Option<String> {
    let found = found?;
    let Some(limit) = document.limits.iter().find(|l| l.name == limit) else { return Some(found) };
    let allowed = um(Some(limit.limit));
    let within = match limit.met {
        true => words.fill("This is within the limit of {0} µm.", &[&allowed]),
        false => words.fill("This is not within the limit of {0} µm.", &[&allowed]),
    };
    let count = |what| document.poses.iter().filter(|p| proved(p) == Some(what)).count();
    let [conforming, not, neither] =
        [Iso9283Conformity::Conforming, Iso9283Conformity::NotConforming, Iso9283Conformity::Neither].map(count);
    let told = words.fill(
        "By ISO 14253-1 and the intervals of 95 %: {0} poses conforming, {1} not conforming, of {2} neither is proved.",
        &[&conforming, &not, &neither],
    );
    let told = if conforming + not + neither > 0 { format!(" {told}") } else { String::new() };
    Some(format!("{found} {within}{told}"))
}
