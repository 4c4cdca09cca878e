//! Identification of the report, and test conditions: lists required by ISO/IEC 17025:2017
//! (7.8.2.1) and ISO 9283:1998 (12, annex C).

use super::limits::name;
use crate::Report;
use crate::model::{Block, Cell, Section};
use crate::number;
use crate::words::Words;
use etalon_base::message::one_line;
use etalon_documents::{CampaignSummary, Characteristics, DecisionRule, Iso9283Document};

pub(super) fn section(report: &Report, words: &Words) -> Option<Section> {
    let campaign = report.campaign;
    let mut section = Section::new("conditions", words.say("Robot, instrument, conditions"));
    let (identity, conditions) = (identity(report, words), facts(campaign, report.tested, words));
    for (what, said) in identity.iter().chain(&conditions) {
        section.summarise(what, said.clone(), "");
    }
    section.summarise(words.say("instrument's expanded uncertainty"), campaign.expanded_uncertainty_um, "µm");
    section.summarise(words.say("coverage factor"), campaign.coverage_factor, "");
    section.summarise(words.say("temperature"), campaign.temperature_c, "°C");
    for (heading, facts) in [(None, identity), (Some(words.say("Conditions")), conditions)] {
        section.blocks.extend(heading.map(Block::heading));
        let not_stated = words.say("not stated");
        let (missing, given): (Vec<_>, Vec<_>) = facts.into_iter().partition(|(_, said)| said.plain() == not_stated);
        section.push(Block::facts(given));
        if !missing.is_empty() {
            let names: Vec<String> = missing.into_iter().map(|(what, _)| what).collect();
            section.push(Block::text(words.fill("Not stated: {0}.", &[&names.join(", ")])));
        }
    }
    section.whole()
}

/// Names with the statements of the campaign, or "not stated".
fn stated(all: Vec<(String, Option<String>)>, words: &Words) -> Vec<(String, Cell)> {
    all.into_iter().map(|(what, text)| (what, text.or_else(|| Some(words.say("not stated"))).into())).collect()
}

/// Identification of report, customer and item (ISO/IEC 17025:2017, 7.8.2.1).
fn identity(report: &Report, words: &Words) -> Vec<(String, Cell)> {
    let (c, given, issue) = (report.campaign, &report.campaign.conditions, &report.campaign.issue);
    let rule = c.decision_rule.map(|rule| name(rule, words));
    let default = || words.fill("{0}; the campaign states none", &[&name(DecisionRule::default(), words)]);
    let all = vec![
        (words.say("report number"), issue.number.clone()),
        (words.say("amends report"), Some(issue.amends.clone().unwrap_or_else(|| words.say("none")))),
        (words.say("laboratory"), given.laboratory.clone()),
        (words.say("place of the measurements"), given.place.clone()),
        (words.say("customer"), issue.customer.clone()),
        (words.say("robot"), robot_name(report)),
        (words.say("manufacturer"), given.robot_maker.clone()),
        (words.say("type"), given.robot_type.clone()),
        (words.say("serial number"), given.robot_serial_number.clone()),
        (words.say("state of the robot"), given.robot_state.clone()),
        (words.say("date of receipt"), given.robot_received.clone()),
        (words.say("date of the measurements"), c.date.clone()),
        (words.say("date of issue"), issue.issued.clone()),
        (words.say("method"), Some(method(report, words))),
        (words.say("decision rule"), rule.or_else(|| Some(default()))),
        (words.say("results of external providers"), issue.external_results.clone()),
        (words.say("authorised by"), issue.authorised_by.clone()),
    ];
    stated(all, words)
}

/// Statements of a certificate on report, customer, item, place, dates and traceability, including
/// those that are missing.
pub(super) fn of_certificate(report: &Report, words: &Words) -> Vec<(String, Cell)> {
    let conditions = facts(report.campaign, report.tested, words);
    let traced = [
        words.say("instrument"),
        words.say("instrument's uncertainty"),
        words.say("instrument's calibration"),
        words.say("traceability"),
        words.say("temperature"),
    ];
    identity(report, words)
        .into_iter()
        .chain(conditions.into_iter().filter(|(what, _)| traced.contains(what)))
        .collect()
}

/// Name of the robot in the campaign, which differs from its model.
pub(crate) fn robot_name(report: &Report) -> Option<String> {
    report.campaign.conditions.robot.clone().or_else(|| report.campaign.robot.clone())
}

/// Method by which the results were obtained.
fn method(report: &Report, words: &Words) -> String {
    let model = report.identified.map(|i| one_line(&i.parameters.robot));
    let identified = model.map(|model| {
        words.fill("identification of the parameters of the kinematic model {0} by least squares", &[&model])
    });
    let tested = (!report.tested.is_empty()).then(|| words.say("performance test by ISO 9283:1998"));
    let program = format!("etalon {}", report.provenance().version);
    identified.into_iter().chain(tested).chain([program]).collect::<Vec<_>>().join("; ")
}

/// Statements of a campaign on the conditions.
fn facts(campaign: &CampaignSummary, tested: &Characteristics, words: &Words) -> Vec<(String, Cell)> {
    let (c, given) = (campaign, &campaign.conditions);
    let text = |text: &Option<String>| text.clone();
    let in_unit = |value: Option<f64>, unit: &str| value.map(|v| words.number(&format!("{v} {unit}")));
    let centre = given.load_centre_mm.map(|[x, y, z]| words.number(&format!("x {x}, y {y}, z {z} mm")));
    let list = |values: &Vec<f64>| values.iter().map(f64::to_string).collect::<Vec<_>>().join(", ");
    let shares = given.velocities_percent.as_ref().map(|v| words.fill("{0} % of the rated one", &[&list(v)]));
    let speeds = given.velocities_mm_s.as_ref().map(|v| words.number(&format!("{} mm/s", list(v))));
    let velocities: Vec<String> = shares.into_iter().chain(speeds).collect();
    let velocities = (!velocities.is_empty()).then(|| velocities.join("; "));
    let mut all = vec![
        (words.say("operator"), text(&c.operator)),
        (words.say("controller"), text(&given.controller)),
        (words.say("mounting"), text(&given.mounting)),
        (words.say("measurement point"), text(&given.measurement_point)),
        (words.say("load"), in_unit(given.load_kg, "kg")),
        (words.say("centre of the load from the mechanical interface"), centre),
        (words.say("velocities"), velocities),
        (words.say("temperature"), in_unit(c.temperature_c, "°C")),
        (words.say("relative humidity"), in_unit(given.humidity_percent, "%")),
        (words.say("environment"), text(&given.environment)),
        (words.say("warm-up before the test"), in_unit(given.warm_up_minutes, "min")),
        (words.say("instrument"), text(&c.instrument)),
        (words.say("instrument's uncertainty"), uncertainty(c, words)),
        (words.say("instrument's calibration"), text(&given.instrument_calibration)),
        (words.say("traceability"), text(&given.traceability)),
    ];
    if let Some(test) = &tested.poses {
        all.push((words.say("poses and cycles"), Some(cycles(test, words))));
    }
    all.push((words.say("deviations from the method"), given.deviations.as_ref().map(|d| deviations(d, words))));
    // without a load there is no centre
    if given.load_kg == Some(0.0) && given.load_centre_mm.is_none() {
        all.retain(|(what, _)| *what != words.say("centre of the load from the mechanical interface"));
    }
    let mut facts = stated(all, words);
    facts.push((words.say("contact"), contact(c, words).into()));
    facts.push((words.say("notes"), text(&c.notes).into()));
    facts
}

fn uncertainty(c: &CampaignSummary, words: &Words) -> Option<String> {
    let u = c.expanded_uncertainty_um.map(number::stated)?;
    let of_coordinate = match c.coverage_factor.map(number::stated) {
        Some(k) => words.fill("U = {0} µm for one coordinate (k = {1})", &[&u, &k]),
        None => words.fill("U = {0} µm for one coordinate (coverage factor not stated)", &[&u]),
    };
    let of_position = c.expanded_position_uncertainty_um.map(number::stated);
    let of_position = of_position.map(|u| format!("; {}", words.fill("U = {0} µm for a position", &[&u])));
    Some(of_coordinate + &of_position.unwrap_or_default())
}

fn contact(c: &CampaignSummary, words: &Words) -> Option<String> {
    let contact = c.contact.as_ref()?;
    let (width, factor) = (number::stated(contact.repeatability_um), number::stated(contact.coverage_factor));
    let own = words
        .fill("± {0} µm for one coordinate ({1} standard deviations), of each observation its own", &[&width, &factor]);
    Some(format!("{own}; {}", words.say("the instrument's error of a point is common to all its observations")))
}

fn deviations(stated: &[String], words: &Words) -> String {
    if stated.is_empty() { words.say("none") } else { stated.join("; ") }
}

/// Number of poses and visits.
fn cycles(test: &Iso9283Document, words: &Words) -> String {
    let cycles = || test.poses.iter().map(|p| p.cycles);
    let (least, most) = (cycles().min().unwrap_or(0), cycles().max().unwrap_or(0));
    let visits = if least == most { most.to_string() } else { words.fill("{0} to {1}", &[&least, &most]) };
    words.fill("{0} poses, {1} visits of each", &[&test.poses.len(), &visits])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::demo::Documents;

    fn of(facts: &[(String, Cell)], what: &str) -> Option<String> {
        facts.iter().find(|(name, said)| name == what && !said.is_missing()).map(|(_, said)| said.plain())
    }

    #[test]
    fn reports_of_tests_and_calibrations_list_what_is_not_stated() {
        let campaign = Documents::demo().campaign;
        let test = facts(&campaign, &crate::tests::demo_iso9283::tested(), &Words::default());
        let calibration = facts(&campaign, &Characteristics::default(), &Words::default());
        for what in
            ["controller", "mounting", "load", "warm-up before the test", "deviations from the method", "traceability"]
        {
            assert_eq!(of(&test, what).as_deref(), Some("not stated"), "{what}");
            assert_eq!(of(&calibration, what).as_deref(), Some("not stated"), "{what}");
        }
        assert_eq!(of(&test, "poses and cycles").as_deref(), Some("2 poses, 30 visits of each"));
        assert_eq!(of(&calibration, "operator").as_deref(), Some("N. N."));
        let documents = Documents::demo();
        let identity = identity(&documents.report(), &Words::default());
        for what in ["report number", "customer", "robot", "serial number", "date of issue", "authorised by"] {
            assert_eq!(of(&identity, what).as_deref(), Some("not stated"), "{what}");
        }
        assert_eq!(of(&identity, "date of the measurements").as_deref(), Some("2011-05-12"));
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
        assert_eq!(of(&all, "deviations from the method").as_deref(), Some("none"));
        assert_eq!(of(&all, "instrument's uncertainty").as_deref(), Some("U = 2.7 µm for one coordinate (k = 2)"));
    }
}
