//! What the campaign states of its test, for the head of a report: the list that ISO 9283 asks for (12, annex C).

use super::number;
use super::words::Words;
use crate::base::pose::centroid;
use crate::document::{CampaignSummary, Characteristics, Iso9283Document};
use serde::Serialize;
use std::collections::BTreeMap;

/// One line: what, and what is stated.
#[derive(Debug, PartialEq, Serialize)]
pub(super) struct Fact {
    pub what: String,
    pub text: String,
}

/// What a campaign states; a test report also says what it does not state.
pub(super) fn facts(campaign: &CampaignSummary, tested: &Characteristics, words: &Words) -> Vec<Fact> {
    let (c, given) = (campaign, &campaign.conditions);
    let text = |text: &Option<String>| text.clone();
    let centre = given.load_centre_mm.map(|[x, y, z]| format!("x {x}, y {y}, z {z} mm"));
    let list = |values: &Vec<f64>| values.iter().map(f64::to_string).collect::<Vec<_>>().join(", ");
    let shares = given.velocities_percent.as_ref().map(|v| words.fill("{0} % of the rated one", &[&list(v)]));
    let speeds = given.velocities_mm_s.as_ref().map(|v| format!("{} mm/s", list(v)));
    let velocities: Vec<String> = shares.into_iter().chain(speeds).collect();
    let velocities = (!velocities.is_empty()).then(|| velocities.join("; "));
    let mut all = vec![
        (words.say("date"), text(&c.date)),
        (words.say("laboratory"), text(&given.laboratory)),
        (words.say("operator"), text(&c.operator)),
        (words.say("robot"), text(&given.robot)),
        (words.say("controller"), text(&given.controller)),
        (words.say("mounting"), text(&given.mounting)),
        (words.say("measurement point"), text(&given.measurement_point)),
        (words.say("load"), given.load_kg.map(|v| format!("{v} kg"))),
        (words.say("centre of the load from the mechanical interface"), centre),
        (words.say("velocities"), velocities),
        (words.say("temperature"), c.temperature_c.map(|v| format!("{v} °C"))),
        (words.say("relative humidity"), given.humidity_percent.map(|v| format!("{v} %"))),
        (words.say("environment"), text(&given.environment)),
        (words.say("warm-up before the test"), given.warm_up_minutes.map(|v| format!("{v} min"))),
        (words.say("instrument"), text(&c.instrument)),
        (words.say("instrument's uncertainty"), uncertainty(c, words)),
        (words.say("instrument's calibration"), text(&given.instrument_calibration)),
    ];
    if let Some(test) = &tested.poses {
        all.push((words.say("poses and cycles"), Some(cycles(test, words))));
    }
    all.push((words.say("deviations from ISO 9283"), given.deviations.as_ref().map(|d| deviations(d, words))));
    // no load has no centre
    if given.load_kg == Some(0.0) && given.load_centre_mm.is_none() {
        all.retain(|(what, _)| *what != words.say("centre of the load from the mechanical interface"));
    }
    let not_stated = || (!tested.is_empty()).then(|| words.say("not stated"));
    let mut facts: Vec<Fact> =
        all.into_iter().filter_map(|(what, text)| Some(Fact { what, text: text.or_else(not_stated)? })).collect();
    let beside = [(words.say("contact"), contact(c, words)), (words.say("notes"), text(&c.notes))];
    facts.extend(beside.into_iter().filter_map(|(what, text)| Some(Fact { what, text: text? })));
    facts
}

fn uncertainty(c: &CampaignSummary, words: &Words) -> Option<String> {
    let u = c.expanded_uncertainty_um.map(stated)?;
    Some(match c.coverage_factor.map(stated) {
        Some(k) => words.fill("U = {0} µm for one coordinate (k = {1})", &[&u, &k]),
        None => words.fill("U = {0} µm for one coordinate (coverage factor not stated)", &[&u]),
    })
}

fn contact(c: &CampaignSummary, words: &Words) -> Option<String> {
    let contact = c.contact.as_ref()?;
    let (width, factor) = (stated(contact.repeatability_um), stated(contact.coverage_factor));
    let own = words
        .fill("± {0} µm for one coordinate ({1} standard deviations), of each observation its own", &[&width, &factor]);
    Some(format!("{own}; {}", words.say("the instrument's error of a point is common to all its observations")))
}

/// A number as the campaign states it.
pub(super) fn stated(value: f64) -> String {
    if value.is_finite() { value.to_string() } else { number::fixed(value, 0) }
}

fn deviations(stated: &[String], words: &Words) -> String {
    if stated.is_empty() { words.say("none") } else { stated.join("; ") }
}

/// How many poses, visited how often.
fn cycles(test: &Iso9283Document, words: &Words) -> String {
    let cycles = || test.poses.iter().map(|p| p.cycles);
    let (least, most) = (cycles().min().unwrap_or(0), cycles().max().unwrap_or(0));
    let visits = if least == most { most.to_string() } else { words.fill("{0} to {1}", &[&least, &most]) };
    words.fill("{0} poses, {1} visits of each", &[&test.poses.len(), &visits])
}

/// Where the poses are: number, visits, mean x, y and z of the attained positions, mm.
pub(super) fn places(test: &Iso9283Document) -> Vec<[String; 5]> {
    let mut by_pose: BTreeMap<i64, Vec<_>> = BTreeMap::new();
    for visit in &test.visits {
        by_pose.entry(visit.pose).or_default().push(visit.attained_mm);
    }
    let row = |(pose, places): (i64, Vec<_>)| {
        let [x, y, z] = centroid(&places)?.map(|v| number::fixed(v, 3));
        Some([pose.to_string(), places.len().to_string(), x, y, z])
    };
    by_pose.into_iter().filter_map(row).collect()
}

#[cfg(test)]
mod tests {
    use super::super::demo::Documents;
    use super::*;

    fn of<'a>(facts: &'a [Fact], what: &str) -> Option<&'a str> {
        facts.iter().find(|f| f.what == what).map(|f| f.text.as_str())
    }

    #[test]
    fn a_test_report_says_what_is_not_stated_and_a_calibration_does_not() {
        let campaign = Documents::demo().campaign;
        let test = facts(&campaign, &super::super::demo_iso9283::tested(), &Words::default());
        for what in ["robot", "controller", "mounting", "load", "warm-up before the test", "deviations from ISO 9283"] {
            assert_eq!(of(&test, what), Some("not stated"), "{what}");
        }
        assert_eq!(of(&test, "poses and cycles"), Some("2 poses, 30 visits of each"));
        assert_eq!(of(&facts(&campaign, &Characteristics::default(), &Words::default()), "robot"), None);
        assert_eq!(of(&facts(&campaign, &Characteristics::default(), &Words::default()), "operator"), Some("N. N."));
    }

    #[test]
    fn what_is_stated_stands_there_with_its_unit_and_no_deviation_is_not_an_unstated_one() {
        let mut campaign = Documents::demo().campaign;
        let c = &mut campaign.conditions;
        (c.load_kg, c.load_centre_mm) = (Some(0.5), Some([0.0, 1.5, 30.0]));
        (c.velocities_percent, c.velocities_mm_s) = (Some(vec![100.0, 50.0]), Some(vec![400.0]));
        c.deviations = Some(vec![]);
        let all = facts(&campaign, &Characteristics::default(), &Words::default());
        assert_eq!(of(&all, "load"), Some("0.5 kg"));
        assert_eq!(of(&all, "centre of the load from the mechanical interface"), Some("x 0, y 1.5, z 30 mm"));
        assert_eq!(of(&all, "velocities"), Some("100, 50 % of the rated one; 400 mm/s"));
        assert_eq!(of(&all, "deviations from ISO 9283"), Some("none"));
        assert_eq!(of(&all, "instrument's uncertainty"), Some("U = 2.7 µm for one coordinate (k = 2)"));
    }
}
