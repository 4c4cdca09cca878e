//! Identification of the report, and test conditions: lists required by ISO/IEC 17025:2017
//! (7.8.2.1) and ISO 9283:1998 (12, annex C).

use super::checklist;
use super::fit::measures_coordinates;
use super::limits::name;
use super::{region, streams};
use crate::model::{Block, Cell, Section};
use crate::number::{self, DisplayUnit};
use crate::words::{Words, tr};
use etalon_documents::{
    AccuracySet, CampaignSummary, Conditions, DecisionRule, ErrorQuantity, Iso9283Document, PoseSet, QuantityResiduals,
    ReadingQuantity, ReadingValues, Results,
};

pub(super) fn section(results: &Results, words: &Words) -> Option<Section> {
    let campaign = &results.campaign;
    let mut section = Section::new("conditions", tr!(words, "robot-instrument-conditions"));
    let (identity, conditions) = (identity(results, words), facts(results, words));
    for (what, said) in identity.iter().chain(&conditions) {
        section.summarise(what, said.clone(), "");
    }
    section.summarise(tr!(words, "instrument-expanded-uncertainty"), campaign.instrument.expanded_uncertainty_um, "µm");
    section.summarise(tr!(words, "coverage-factor"), campaign.instrument.coverage_factor, "");
    section.summarise(tr!(words, "temperature"), campaign.temperature.stated_c, "°C");
    let to_complete: Vec<String> = checklist::missing(results, words).into_iter().map(|m| m.field).collect();
    for (heading, facts) in [(None, identity), (Some(tr!(words, "conditions")), conditions)] {
        section.blocks.extend(heading.map(Block::heading));
        let not_stated = tr!(words, "not-stated");
        let (missing, given): (Vec<_>, Vec<_>) = facts.into_iter().partition(|(_, said)| said.plain() == not_stated);
        section.push(Block::facts(given));
        // page one lists the fields to complete
        let names: Vec<String> =
            missing.into_iter().map(|(what, _)| what).filter(|what| !to_complete.contains(what)).collect();
        if !names.is_empty() {
            section.push(Block::text(tr!(words, "not-stated-items", items = names.join(", "))));
        }
    }
    section.whole()
}

/// Names with the data of the campaign, or "not stated".
fn stated(all: Vec<(String, Option<String>)>, words: &Words) -> Vec<(String, Cell)> {
    all.into_iter().map(|(what, text)| (what, text.or_else(|| Some(tr!(words, "not-stated"))).into())).collect()
}

/// Place of measurements without another one: `place` is for measurements outside the laboratory.
fn in_laboratory(given: &Conditions, words: &Words) -> Option<String> {
    given.laboratory.as_ref().map(|_| tr!(words, "in-the-laboratory"))
}

/// Identification of report, customer and item (ISO/IEC 17025:2017, 7.8.2.1).
fn identity(results: &Results, words: &Words) -> Vec<(String, Cell)> {
    let (c, given, issue) = (&results.campaign, &results.campaign.conditions, &results.campaign.issue);
    let rule = c.limits.decision_rule.map(|rule| name(rule, words));
    let default = || tr!(words, "rule-not-stated", rule = name(DecisionRule::default(), words));
    let all = vec![
        (tr!(words, "report-number"), issue.number.clone()),
        (tr!(words, "amends-report"), Some(issue.amends.clone().unwrap_or_else(|| tr!(words, "none")))),
        (tr!(words, "laboratory"), given.laboratory.clone()),
        (tr!(words, "measurement-place"), given.place.clone().or_else(|| in_laboratory(given, words))),
        (tr!(words, "customer"), issue.customer.clone()),
        (tr!(words, "robot"), robot_name(results)),
        (tr!(words, "manufacturer"), given.robot.maker.clone()),
        (tr!(words, "type"), given.robot.model.clone()),
        (tr!(words, "serial-number"), given.robot.serial_number.clone()),
        (tr!(words, "state-of-the-robot"), given.robot.state.clone()),
        (tr!(words, "date-of-receipt"), given.robot.received.clone()),
        (tr!(words, "measurement-dates"), c.measurements.date.clone()),
        (tr!(words, "date-of-issue"), issue.issued.clone()),
        (tr!(words, "method"), Some(method(results, words))),
        (tr!(words, "decision-rule"), rule.or_else(|| Some(default()))),
        (tr!(words, "results-of-external-providers"), issue.external_results.clone()),
        (tr!(words, "authorised-by"), issue.authorised_by.clone()),
    ];
    // a recalibration interval is agreed with the customer (ISO/IEC 17025:2017, 7.8.4.3)
    let until = c.valid_until.clone().map(|date| (tr!(words, "valid-until"), Some(date).into()));
    stated(all, words).into_iter().chain(until).collect()
}

/// Data of a certificate on report, customer, item, place, dates, conditions, traceability and
/// deviations, including those that are missing.
pub(super) fn certificate_facts(results: &Results, words: &Words) -> Vec<(String, Cell)> {
    let remarks = [tr!(words, "contact"), tr!(words, "notes")];
    let conditions = facts(results, words).into_iter().filter(|(what, _)| !remarks.contains(what));
    let until = tr!(words, "valid-until");
    let agreed = |(what, said): (String, Cell)| match what == until {
        true => (tr!(words, "valid-until-agreed"), said),
        false => (what, said),
    };
    identity(results, words).into_iter().map(agreed).chain(conditions).collect()
}

/// Name of the robot in the campaign, which differs from its model.
pub(crate) fn robot_name(results: &Results) -> Option<String> {
    results.campaign.conditions.robot.description.clone().or_else(|| results.campaign.robot.clone())
}

/// Method by which the results were obtained.
fn method(results: &Results, words: &Words) -> String {
    let model = results.identified.as_ref().map(|i| words.model(&i.parameters.robot));
    let identified = model.map(|model| tr!(words, "method-identification", model));
    let tested = (!results.tested.is_empty()).then(|| tr!(words, "method-iso9283"));
    let program = format!("etalon {}", results.provenance().version);
    identified.into_iter().chain(tested).chain([program]).collect::<Vec<_>>().join("; ")
}

/// Values of a quantity that the readings of each set give; `None` if they give none.
fn readings_text(quantity: ReadingQuantity, results: &Results, words: &Words) -> Option<String> {
    let sets = &results.identified.as_ref()?.accuracy.sets;
    let of_set = |set: &AccuracySet| {
        let columns: Vec<&ReadingValues> = set.readings.iter().filter(|v| v.quantity == quantity).collect();
        let values = match columns.as_slice() {
            [] => return None,
            [one] => region::listed(one, words),
            all => all
                .iter()
                .map(|v| format!("{} {}", label(&v.column), region::range(v, words)))
                .collect::<Vec<_>>()
                .join(", "),
        };
        Some((set.name, format!("{values} {}", quantity.unit())))
    };
    let all: Vec<(PoseSet, String)> = sets.iter().filter_map(of_set).collect();
    let (_, first) = all.first()?;
    if all.iter().all(|(_, values)| values == first) {
        return Some(tr!(words, "readings-give", values = first));
    }
    let named = |(set, values): &(PoseSet, String)| tr!(words, "readings-of-set-give", set = set.name(), values);
    Some(all.iter().map(named).collect::<Vec<_>>().join("; "))
}

/// Name of a column without its unit: `x` of `load_x_mm`.
fn label(column: &str) -> &str {
    let column = column.strip_prefix("load_").unwrap_or(column);
    column.rsplit_once('_').map_or(column, |(name, _)| name)
}

/// A statement of the campaign and the values of the readings.
fn with_readings(stated: Option<String>, readings: Option<String>) -> Option<String> {
    let all: Vec<String> = stated.into_iter().chain(readings).collect();
    (!all.is_empty()).then(|| all.join("; "))
}

/// Given temperature, and the range that the exports contain.
fn temperature(campaign: &CampaignSummary, words: &Words) -> Option<String> {
    let stated = campaign.temperature.stated_c.map(|value| format!("{} °C", words.unrounded(value)));
    let measured = campaign.temperature.range_c.map(|[lowest, highest]| {
        let [lowest, highest] = [lowest, highest].map(|value| words.unrounded(value));
        tr!(words, "temperature-range", lowest, highest)
    });
    with_readings(stated, measured)
}

/// Data of a campaign on the conditions.
fn facts(results: &Results, words: &Words) -> Vec<(String, Cell)> {
    let (c, given, tested) = (&results.campaign, &results.campaign.conditions, &results.tested);
    let text = |text: &Option<String>| text.clone();
    let in_unit = |value: Option<f64>, unit: &str| value.map(|v| format!("{} {unit}", words.unrounded(v)));
    let centre = given.motion.load_centre_mm.map(|centre| {
        let [x, y, z] = centre.map(|v| words.unrounded(v));
        format!("x {x}, y {y}, z {z} mm")
    });
    let list = |values: &Vec<f64>| values.iter().map(|v| words.unrounded(*v)).collect::<Vec<_>>().join(", ");
    let shares = given.motion.velocities_percent.as_ref().map(|v| tr!(words, "percent-of-rated", percent = list(v)));
    let speeds = given.motion.velocities_mm_s.as_ref().map(|v| format!("{} mm/s", list(v)));
    let velocities: Vec<String> = shares.into_iter().chain(speeds).collect();
    let of_test = (!velocities.is_empty()).then(|| velocities.join("; "));
    let recorded = tested.streams.as_ref().and_then(|streams| streams::velocities(streams, words));
    // recordings have velocities of their own
    let of_test = match (&recorded, &tested.poses) {
        (Some(_), Some(_)) => of_test.map(|velocity| tr!(words, "velocity-of-poses", velocity)),
        _ => of_test,
    };
    let velocities: Vec<String> = of_test.into_iter().chain(recorded).collect();
    let velocities = (!velocities.is_empty()).then(|| velocities.join("; "));
    let readings = |quantity| readings_text(quantity, results, words);
    let load = with_readings(in_unit(given.motion.load_kg, "kg"), readings(ReadingQuantity::PayloadMass));
    let mut all = vec![
        (tr!(words, "operator"), text(&c.measurements.operator)),
        (tr!(words, "controller"), text(&given.robot.controller)),
        (tr!(words, "mounting"), text(&given.robot.mounting)),
        (tr!(words, "measurement-point"), text(&given.measurement_point)),
        (tr!(words, "load"), load),
        (tr!(words, "load-centre"), with_readings(centre, readings(ReadingQuantity::PayloadCentre))),
        (tr!(words, "velocities"), velocities),
        (tr!(words, "temperature"), temperature(c, words)),
        (tr!(words, "relative-humidity"), in_unit(given.humidity_percent, "%")),
        (tr!(words, "environment"), text(&given.environment)),
        (tr!(words, "warm-up-before-the-test"), in_unit(given.warm_up_minutes, "min")),
        (tr!(words, "instrument"), text(&c.instrument.name)),
        (tr!(words, "instrument-uncertainty"), uncertainty(results, words)),
        (tr!(words, "instrument-calibration"), text(&given.instrument_calibration)),
        (tr!(words, "traceability"), text(&given.traceability)),
    ];
    if let Some(test) = &tested.poses {
        all.push((tr!(words, "poses-and-cycles"), Some(cycles(test, words))));
    }
    all.push((tr!(words, "deviations-from-the-method"), given.deviations.as_ref().map(|d| deviations(d, words))));
    // without a load there is no centre
    if given.motion.load_kg == Some(0.0) && given.motion.load_centre_mm.is_none() {
        all.retain(|(what, _)| *what != tr!(words, "load-centre"));
    }
    let mut facts = stated(all, words);
    let torques = readings(ReadingQuantity::Torque);
    facts.extend(torques.map(|torques| (tr!(words, "torques-of-joints"), Some(torques).into())));
    facts.extend(robot_temperature(results, words).map(|text| (tr!(words, "temperature-of-robot"), Some(text).into())));
    facts.push((tr!(words, "contact"), contact(c, words).into()));
    facts.push((tr!(words, "notes"), text(&c.measurements.notes).into()));
    facts
}

/// Temperatures of the robot in the readings, and the temperature to which the model refers.
fn robot_temperature(results: &Results, words: &Words) -> Option<String> {
    let reference_c = results.identified.as_ref()?.parameters.reference_temperature_c;
    let reference = reference_c.map(|value| tr!(words, "reference-temperature", value = words.unrounded(value)));
    with_readings(readings_text(ReadingQuantity::Temperature, results, words), reference)
}

/// Expanded uncertainties (k = 2) of the readings of each quantity other than positions.
fn quantity_uncertainties(found: &[QuantityResiduals], words: &Words) -> Vec<String> {
    let of = |c: &QuantityResiduals| {
        let DisplayUnit { unit, factor } = number::display_unit(&c.unit, c.standard_uncertainty);
        let uncertainty = number::derived(2.0 * factor * c.standard_uncertainty);
        let quantity = words.tr(&c.quantity.phrase());
        tr!(words, "expanded-uncertainty-of-quantity", quantity, uncertainty, unit)
    };
    found.iter().map(of).collect()
}

/// Stated uncertainty of the instrument: of a coordinate, or of a reading if no position was
/// measured. Readings of several quantities each have their own.
fn uncertainty(results: &Results, words: &Words) -> Option<String> {
    let c = &results.campaign;
    let u = c.instrument.expanded_uncertainty_um.map(number::stated)?;
    let residuals = results.identified.as_ref().map(|i| &i.parameters.residuals);
    let others = residuals.map_or_else(Vec::new, |r| quantity_uncertainties(&r.conditions, words));
    if !others.is_empty() && !residuals.is_some_and(measures_coordinates) {
        return Some(others.join("; "));
    }
    let sets = results.identified.as_ref().map_or(&[][..], |i| &i.accuracy.sets);
    let positions = sets.is_empty() || sets.iter().any(|s| s.error_statistics(ErrorQuantity::Position).is_some());
    let of_coordinate = match (c.instrument.coverage_factor.map(number::stated), positions) {
        (Some(k), true) => tr!(words, "instrument-uncertainty-with-k", uncertainty = u, k),
        (Some(k), false) => tr!(words, "reading-uncertainty-with-k", uncertainty = u, k),
        (None, true) => tr!(words, "instrument-uncertainty-without-k", uncertainty = u),
        (None, false) => tr!(words, "reading-uncertainty-without-k", uncertainty = u),
    };
    let of_position = c.instrument.expanded_position_uncertainty_um.map(number::stated);
    let of_position =
        of_position.map(|u| format!("; {}", tr!(words, "instrument-uncertainty-of-position", uncertainty = u)));
    let all = [of_coordinate + &of_position.unwrap_or_default()].into_iter().chain(others);
    Some(all.collect::<Vec<_>>().join("; "))
}

fn contact(c: &CampaignSummary, words: &Words) -> Option<String> {
    let contact = c.contact.as_ref()?;
    let (width, factor) = (number::stated(contact.repeatability_um), number::stated(contact.coverage_factor));
    let own = tr!(words, "uncertainty-for-outliers", uncertainty = width, factor);
    Some(format!("{own}; {}", tr!(words, "point-error-in-common")))
}

fn deviations(stated: &[String], words: &Words) -> String {
    if stated.is_empty() { tr!(words, "none") } else { stated.join("; ") }
}

/// Number of poses and visits.
fn cycles(test: &Iso9283Document, words: &Words) -> String {
    let cycles = || test.poses.iter().map(|p| p.cycles);
    let (least, most) = (cycles().min().unwrap_or(0), cycles().max().unwrap_or(0));
    let visits = if least == most { most.to_string() } else { tr!(words, "range", from = least, to = most) };
    tr!(words, "poses-and-visits", poses = test.poses.len(), visits)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::demo::Documents;

    fn fact(facts: &[(String, Cell)], what: &str) -> Option<String> {
        facts.iter().find(|(name, said)| name == what && !said.is_missing()).map(|(_, said)| said.plain())
    }

    #[test]
    fn reports_of_tests_and_calibrations_list_what_is_not_stated() {
        let mut documents = Documents::demo();
        documents.tested = Default::default();
        let calibration = facts(&documents.results(), &Words::default());
        documents.tested = crate::tests::demo_iso9283::tested();
        let test = facts(&documents.results(), &Words::default());
        for what in
            ["controller", "mounting", "load", "warm-up before the test", "deviations from the method", "traceability"]
        {
            assert_eq!(fact(&test, what).as_deref(), Some("not stated"), "{what}");
            assert_eq!(fact(&calibration, what).as_deref(), Some("not stated"), "{what}");
        }
        assert_eq!(fact(&test, "poses and cycles").as_deref(), Some("2 poses, 30 visits each"));
        assert_eq!(fact(&calibration, "operator").as_deref(), Some("N. N."));
        let documents = Documents::demo();
        let identity = identity(&documents.results(), &Words::default());
        for what in ["report number", "customer", "robot", "serial number", "date of issue", "authorised by"] {
            assert_eq!(fact(&identity, what).as_deref(), Some("not stated"), "{what}");
        }
        assert_eq!(fact(&identity, "date of the measurements").as_deref(), Some("2011-05-12"));
    }

    /// The demo has poses, and a path recorded at 100 mm/s.
    #[test]
    fn each_velocity_has_the_tests_to_which_it_applies() {
        let (mut documents, words) = (Documents::demo(), Words::default());
        documents.campaign.conditions.motion.velocities_mm_s = Some(vec![400.0]);
        documents.tested = crate::tests::demo_iso9283::tested();
        let velocities = |documents: &Documents| fact(&facts(&documents.results(), &words), "velocities").unwrap();
        assert_eq!(velocities(&documents), "400 mm/s");
        documents.tested.streams = Some(crate::tests::demo_streams::streams());
        let of_poses = tr!(words, "velocity-of-poses", velocity = "400 mm/s");
        let of_path = tr!(words, "velocity-of-recording", value = "100", name = crate::words::isolated("square"));
        assert_eq!(velocities(&documents), format!("{of_poses}; {of_path}"));
    }

    #[test]
    fn loads_and_temperatures_of_readings_are_conditions() {
        let mut documents = Documents::demo();
        let values =
            |column: &str, quantity, all: &[f64]| ReadingValues::new(column.to_owned(), quantity, all.to_vec());
        let hot: Vec<f64> = (0..8).map(f64::from).map(|k| 19.5 + k).collect();
        let load = [
            values("load_kg", ReadingQuantity::PayloadMass, &[0.0, 1.5, 3.0, 0.0]),
            values("load_x_mm", ReadingQuantity::PayloadCentre, &[0.0, 10.0]),
            values("load_y_mm", ReadingQuantity::PayloadCentre, &[0.0]),
        ];
        let load: Vec<ReadingValues> = load.into_iter().flatten().collect();
        let temperature = |all: &[f64]| values("temperature_c", ReadingQuantity::Temperature, all);
        let sets = &mut documents.accuracy.sets;
        sets[0].readings = load.iter().cloned().chain(temperature(&hot)).collect();
        sets[1].readings = load.into_iter().chain(temperature(&[23.0])).collect();
        documents.parameters.reference_temperature_c = Some(20.0);
        documents.campaign.conditions.motion.load_kg = Some(1.0);
        let all = facts(&documents.results(), &Words::default());
        assert_eq!(fact(&all, "load").as_deref(), Some("1 kg; readings: 0; 1.5; 3 kg"));
        let centre = fact(&all, "load centre (from the mechanical interface)");
        assert_eq!(centre.as_deref(), Some("readings: x 0 to 10, y 0 mm"));
        let robot = "calibration readings: 19.5 to 26.5 °C; validation readings: 23 °C; model refers to 20 °C";
        assert_eq!(fact(&all, "temperature of the robot").as_deref(), Some(robot));
        assert_eq!(fact(&all, "torques of the joints"), None);
        // readings that give loads leave nothing to complete
        documents.campaign.conditions.motion.load_kg = None;
        let is_missing = |documents: &Documents| {
            let missing = checklist::missing(&documents.results(), &Words::default());
            missing.iter().any(|m| m.field == "load")
        };
        assert!(!is_missing(&documents) && is_missing(&Documents::demo()));
        let region = serde_json::to_string(&region::section(&documents.results(), &Words::default())).unwrap();
        assert!(region.contains("load_x_mm") && region.contains("19.5 to 26.5"), "{region}");
        let sentence = region::readings_sentence(&documents.accuracy, &Words::default());
        assert!(sentence.contains("load_kg 0; 1.5; 3, load_x_mm 0; 10") && sentence.contains("19.5"), "{sentence}");
        assert_eq!(region::readings_sentence(&Documents::demo().accuracy, &Words::default()), "");
    }

    #[test]
    fn a_certificate_shows_what_a_signer_has_to_add() {
        let facts = certificate_facts(&Documents::demo().results(), &Words::default());
        for what in [
            "controller",
            "mounting",
            "measurement point",
            "load",
            "load centre (from the mechanical interface)",
            "velocities",
            "relative humidity",
            "environment",
            "warm-up before the test",
            "instrument's calibration",
            "traceability",
        ] {
            assert_eq!(fact(&facts, what).as_deref(), Some("not stated"), "{what}");
        }
        assert_eq!(fact(&facts, "operator").as_deref(), Some("N. N."));
        assert!(facts.iter().all(|(name, _)| name != "notes"), "{facts:?}");
    }

    #[test]
    fn what_is_stated_has_its_unit_and_no_deviation_is_not_an_unstated_one() {
        let mut documents = Documents::demo();
        let c = &mut documents.campaign.conditions;
        (c.motion.load_kg, c.motion.load_centre_mm) = (Some(0.5), Some([0.0, 1.5, 30.0]));
        (c.motion.velocities_percent, c.motion.velocities_mm_s) = (Some(vec![100.0, 50.0]), Some(vec![400.0]));
        c.deviations = Some(vec![]);
        let all = facts(&documents.results(), &Words::default());
        assert_eq!(fact(&all, "load").as_deref(), Some("0.5 kg"));
        assert_eq!(fact(&all, "load centre (from the mechanical interface)").as_deref(), Some("x 0, y 1.5, z 30 mm"));
        assert_eq!(fact(&all, "velocities").as_deref(), Some("100, 50 % of the rated velocity; 400 mm/s"));
        assert_eq!(fact(&all, "deviations from the method").as_deref(), Some("none"));
        assert_eq!(fact(&all, "instrument's uncertainty").as_deref(), Some("U = 2.7 µm per coordinate (k = 2)"));
        for set in &mut documents.accuracy.sets {
            set.errors.retain(|e| e.quantity == ErrorQuantity::Position);
            set.errors.iter_mut().for_each(|e| e.quantity = ErrorQuantity::Distance);
        }
        let distances = facts(&documents.results(), &Words::default());
        assert_eq!(fact(&distances, "instrument's uncertainty").as_deref(), Some("U = 2.7 µm per reading (k = 2)"));
    }
}
