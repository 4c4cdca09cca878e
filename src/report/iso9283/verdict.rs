//! What the first box of a test report says.

use crate::document::{Characteristics, Iso9283Conformity, Iso9283Document, Iso9283Pose};
use crate::report::number;
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
        let said = words.say("The accuracy is {0} µm, at pose {1}.");
        let accuracy: Judged = ("accuracy_max_mm", |p: &Iso9283Pose| p.ap_conformity);
        sentences.extend(worst(document, |p| p.ap_mm).map(|found| judged(&said, found, document, accuracy, words)));
        let said = words.say("The repeatability is {0} µm, at pose {1}.");
        let repeatability: Judged = ("repeatability_max_mm", |p: &Iso9283Pose| p.rp_conformity);
        sentences
            .extend(worst(document, |p| p.rp_mm).map(|found| judged(&said, found, document, repeatability, words)));
    }
    let met: Vec<bool> = tested.limits().map(|l| l.met).collect();
    if met.is_empty() {
        sentences.push(words.say("The campaign states no limit."));
    }
    let open = |p: &Iso9283Pose| [p.ap_conformity, p.rp_conformity].contains(&Some(Iso9283Conformity::Neither));
    let proved = !tested.poses.iter().flat_map(|d| &d.poses).any(open);
    let class = match (met.is_empty(), met.iter().all(|met| *met)) {
        (false, false) => "bad",
        (false, true) if proved => "good",
        _ => "open",
    };
    Verdict { class, sentences }
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
    said: &str,
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
    let found = words.fill(said, &[&um(worst_mm), &pose]);
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
        "By ISO 14253-1 and the intervals of 95 %: {0} poses conforming, {1} not conforming, of {2} neither is proved.",
        &[&conforming, &not, &neither],
    );
    let told = if conforming + not + neither > 0 { format!(" {told}") } else { String::new() };
    format!("{found} {within}{told}")
}
