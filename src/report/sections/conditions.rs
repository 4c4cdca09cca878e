//! What the campaign states of its test: the list that ISO 9283 asks for (12, annex C).

use crate::document::{CampaignSummary, Characteristics, Iso9283Document};
use crate::report::Report;
use crate::report::model::{Block, Cell, Section};
use crate::report::number::stated;
use crate::report::words::Words;

pub(super) fn section(report: &Report, words: &Words) -> Option<Section> {
    let campaign = report.campaign;
    let mut section = Section::new("conditions", words.say("Robot, instrument, conditions"));
    for (what, said) in facts(campaign, report.tested, words) {
        section.summarise(what, said, "");
    }
    section.summarise(words.say("instrument's expanded uncertainty"), campaign.expanded_uncertainty_um, "µm");
    section.summarise(words.say("coverage factor"), campaign.coverage_factor, "");
    section.summarise(words.say("temperature"), campaign.temperature_c, "°C");
    section.push(Block::facts(facts(campaign, report.tested, words)));
    section.whole()
}

/// What a campaign states; a test report also lists what it does not state.
fn facts(campaign: &CampaignSummary, tested: &Characteristics, words: &Words) -> Vec<(String, Cell)> {
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
    let mut facts: Vec<(String, Cell)> =
        all.into_iter().map(|(what, text)| (what, text.or_else(not_stated).into())).collect();
    facts.push((words.say("contact"), contact(c, words).into()));
    facts.push((words.say("notes"), text(&c.notes).into()));
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::tests::demo::Documents;

    fn of(facts: &[(String, Cell)], what: &str) -> Option<String> {
        facts.iter().find(|(name, said)| name == what && !said.is_missing()).map(|(_, said)| said.plain())
    }

    #[test]
    fn a_test_report_lists_what_is_not_stated_and_a_calibration_does_not() {
        let campaign = Documents::demo().campaign;
        let test = facts(&campaign, &crate::report::tests::demo_iso9283::tested(), &Words::default());
        for what in ["robot", "controller", "mounting", "load", "warm-up before the test", "deviations from ISO 9283"] {
            assert_eq!(of(&test, what).as_deref(), Some("not stated"), "{what}");
        }
        assert_eq!(of(&test, "poses and cycles").as_deref(), Some("2 poses, 30 visits of each"));
        assert_eq!(of(&facts(&campaign, &Characteristics::default(), &Words::default()), "robot"), None);
        assert_eq!(
            of(&facts(&campaign, &Characteristics::default(), &Words::default()), "operator").as_deref(),
            Some("N. N.")
        );
    }

    #[test]
    fn what_is_stated_has_its_unit_and_no_deviation_is_not_an_unstated_one() {
        let mut campaign = Documents::demo().campaign;
        let c = &mut campaign.conditions;
        (c.load_kg, c.load_centre_mm) = (Some(0.5), Some([0.0, 1.5, 30.0]));
        (c.velocities_percent, c.velocities_mm_s) = (Some(vec![100.0, 50.0]), Some(vec![400.0]));
        c.deviations = Some(vec![]);
        let all = facts(&campaign, &Characteristics::default(), &Words::default());
        assert_eq!(of(&all, "load").as_deref(), Some("0.5 kg"));
        assert_eq!(
            of(&all, "centre of the load from the mechanical interface").as_deref(),
            Some("x 0, y 1.5, z 30 mm")
        );
        assert_eq!(of(&all, "velocities").as_deref(), Some("100, 50 % of the rated one; 400 mm/s"));
        assert_eq!(of(&all, "deviations from ISO 9283").as_deref(), Some("none"));
        assert_eq!(of(&all, "instrument's uncertainty").as_deref(), Some("U = 2.7 µm for one coordinate (k = 2)"));
    }
}
