//! What the campaign states of its test, for the head of a report: the list that ISO 9283 asks for (12, annex C).

use super::number;
use crate::document::{CampaignSummary, Iso9283Document};
use crate::pose::centroid;
use serde::Serialize;
use std::collections::BTreeMap;

/// One line: what, and what is stated.
#[derive(Debug, PartialEq, Serialize)]
pub(super) struct Fact {
    pub what: String,
    pub text: String,
}

/// What a campaign states; a test report also says what it does not state.
pub(super) fn facts(campaign: &CampaignSummary, test: Option<&Iso9283Document>) -> Vec<Fact> {
    let (c, given) = (campaign, &campaign.conditions);
    let text = |text: &Option<String>| text.clone();
    let list = |values: &Option<Vec<f64>>, unit: &str| {
        let values: Vec<String> = values.as_ref()?.iter().map(f64::to_string).collect();
        Some(format!("{} {unit}", values.join(", ")))
    };
    let mut all = vec![
        ("date", text(&c.date)),
        ("laboratory", text(&given.laboratory)),
        ("operator", text(&c.operator)),
        ("robot", text(&given.robot)),
        ("controller", text(&given.controller)),
        ("mounting", text(&given.mounting)),
        ("measurement point", text(&given.measurement_point)),
        ("load", given.load_kg.map(|v| format!("{v} kg"))),
        (
            "centre of the load from the mechanical interface",
            given.load_centre_mm.map(|[x, y, z]| format!("x {x}, y {y}, z {z} mm")),
        ),
        ("velocities, share of the rated one", list(&given.velocities_percent, "%")),
        ("velocities", list(&given.velocities_mm_s, "mm/s")),
        ("temperature", c.temperature_c.map(|v| format!("{v} °C"))),
        ("relative humidity", given.humidity_percent.map(|v| format!("{v} %"))),
        ("environment", text(&given.environment)),
        ("warm-up before the test", given.warm_up_minutes.map(|v| format!("{v} min"))),
        ("instrument", text(&c.instrument)),
        ("instrument's uncertainty", uncertainty(c)),
        ("instrument's calibration", text(&given.instrument_calibration)),
    ];
    if let Some(test) = test {
        all.push(("poses and cycles", Some(cycles(test))));
    }
    all.push(("deviations from ISO 9283", given.deviations.as_ref().map(|d| deviations(d))));
    let not_stated = || test.map(|_| "not stated".to_owned());
    let mut facts: Vec<Fact> = all
        .into_iter()
        .filter_map(|(what, text)| Some(Fact { what: what.to_owned(), text: text.or_else(not_stated)? }))
        .collect();
    let beside = [("contact", contact(c)), ("notes", text(&c.notes))];
    facts.extend(beside.into_iter().filter_map(|(what, text)| Some(Fact { what: what.to_owned(), text: text? })));
    facts
}

fn uncertainty(c: &CampaignSummary) -> Option<String> {
    let u = c.expanded_uncertainty_um.map(stated)?;
    let factor =
        c.coverage_factor.map_or_else(|| "coverage factor not stated".to_owned(), |k| format!("k = {}", stated(k)));
    Some(format!("U = {u} µm for one coordinate ({factor})"))
}

fn contact(c: &CampaignSummary) -> Option<String> {
    let contact = c.contact.as_ref()?;
    Some(format!(
        "± {} µm for one coordinate ({} standard deviations), of each observation its own; the instrument's error of a \
         point is common to all its observations",
        stated(contact.repeatability_um),
        stated(contact.coverage_factor)
    ))
}

/// A number as the campaign states it.
pub(super) fn stated(value: f64) -> String {
    if value.is_finite() { value.to_string() } else { number::fixed(value, 0) }
}

fn deviations(stated: &[String]) -> String {
    if stated.is_empty() { "none".to_owned() } else { stated.join("; ") }
}

/// How many poses, visited how often.
fn cycles(test: &Iso9283Document) -> String {
    let cycles = || test.poses.iter().map(|p| p.cycles);
    let (least, most) = (cycles().min().unwrap_or(0), cycles().max().unwrap_or(0));
    let visits = if least == most { most.to_string() } else { format!("{least} to {most}") };
    format!("{} poses, {visits} visits of each", test.poses.len())
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
        let test = facts(&campaign, Some(&super::super::demo_iso9283::iso9283()));
        for what in ["robot", "controller", "mounting", "load", "warm-up before the test", "deviations from ISO 9283"] {
            assert_eq!(of(&test, what), Some("not stated"), "{what}");
        }
        assert_eq!(of(&test, "poses and cycles"), Some("2 poses, 30 visits of each"));
        assert_eq!(of(&facts(&campaign, None), "robot"), None);
        assert_eq!(of(&facts(&campaign, None), "operator"), Some("N. N."));
    }

    #[test]
    fn what_is_stated_stands_there_with_its_unit_and_no_deviation_is_not_an_unstated_one() {
        let mut campaign = Documents::demo().campaign;
        let c = &mut campaign.conditions;
        (c.load_kg, c.load_centre_mm) = (Some(0.5), Some([0.0, 1.5, 30.0]));
        (c.velocities_percent, c.deviations) = (Some(vec![100.0, 50.0]), Some(vec![]));
        let all = facts(&campaign, None);
        assert_eq!(of(&all, "load"), Some("0.5 kg"));
        assert_eq!(of(&all, "centre of the load from the mechanical interface"), Some("x 0, y 1.5, z 30 mm"));
        assert_eq!(of(&all, "velocities, share of the rated one"), Some("100, 50 %"));
        assert_eq!(of(&all, "deviations from ISO 9283"), Some("none"));
        assert_eq!(of(&all, "instrument's uncertainty"), Some("U = 2.7 µm for one coordinate (k = 2)"));
    }
}
