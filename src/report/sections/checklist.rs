//! Checklist before a report is signed: missing fields of ISO/IEC 17025:2017 (7.8.2.1, 7.8.4.1,
//! 7.8.6.2) and ISO 9283:1998 (6), with the keys that state them.

use crate::model::{Columns, Section, Table, Text};
use crate::words::{Words, tr};
use etalon_base::phrase;
use etalon_documents::{ReadingQuantity, Results};

/// A field that is not given.
pub(super) struct Missing {
    pub field: String,
    /// Key in campaign.toml.
    key: &'static str,
    clause: &'static str,
}

/// A field with its key and its clause, and `true` if it is given.
type Field = (String, &'static str, &'static str, bool);

const REPORT: &str = "ISO/IEC 17025:2017, 7.8.2.1";
const CALIBRATION: &str = "ISO/IEC 17025:2017, 7.8.4.1";
const CONFORMITY: &str = "ISO/IEC 17025:2017, 7.8.6.2";
const TEST: &str = "ISO 9283:1998, 6";

pub(super) fn section(results: &Results, words: &Words) -> Option<Section> {
    section_from_missing(&missing(results, words), words)
}

/// Section of missing fields; `None` if all are given.
pub(super) fn section_from_missing(missing: &[Missing], words: &Words) -> Option<Section> {
    let columns = Columns::<Missing>::new()
        .page(phrase!("checklist-field"), "", |m| Text::from(m.field.clone()))
        .page(phrase!("checklist-key"), "", |m| Text::code(m.key))
        .page(phrase!("checklist-clause"), "", |m| Text::from(m.clause));
    let mut section = Section::new("checklist", tr!(words, "checklist-title"));
    section.table("", tr!(words, "checklist-note", count = missing.len()), Table::new(words, missing, columns));
    section.whole()
}

/// Fields that are not given, in the order of the clauses.
pub(super) fn missing(results: &Results, words: &Words) -> Vec<Missing> {
    let mut all = general(results, words);
    match results.tested.is_empty() {
        true => all.extend(influences(results, CALIBRATION, words)),
        false => all.extend(test_fields(results, words)),
    }
    let missing = all.into_iter().filter(|(.., stated)| !stated);
    missing.map(|(field, key, clause, _)| Missing { field, key, clause }).collect()
}

/// Mark across a report that is a draft, or of synthetic data.
pub(crate) fn mark(results: &Results, words: &Words) -> Option<String> {
    match (results.campaign.measurements.synthetic.is_some(), missing(results, words).is_empty()) {
        (true, _) => Some(tr!(words, "synthetic-mark")),
        (false, false) => Some(tr!(words, "draft-mark")),
        (false, true) => None,
    }
}

fn is_stated(text: &Option<String>) -> bool {
    text.as_ref().is_some_and(|text| !text.trim().is_empty())
}

fn general(results: &Results, words: &Words) -> Vec<Field> {
    let (c, given, issue) = (&results.campaign, &results.campaign.conditions, &results.campaign.issue);
    let mut all = vec![
        (tr!(words, "laboratory"), "conditions.laboratory", REPORT, is_stated(&given.laboratory)),
        (tr!(words, "report-number"), "report.number", REPORT, is_stated(&issue.number)),
        (tr!(words, "customer"), "report.customer", REPORT, is_stated(&issue.customer)),
        (tr!(words, "manufacturer"), "conditions.robot_maker", REPORT, is_stated(&given.robot.maker)),
        (tr!(words, "type"), "conditions.robot_type", REPORT, is_stated(&given.robot.model)),
        (tr!(words, "serial-number"), "conditions.robot_serial_number", REPORT, is_stated(&given.robot.serial_number)),
        (tr!(words, "state-of-the-robot"), "conditions.robot_state", REPORT, is_stated(&given.robot.state)),
        (tr!(words, "measurement-dates"), "date", REPORT, is_stated(&c.measurements.date)),
        (tr!(words, "date-of-issue"), "report.issued", REPORT, is_stated(&issue.issued)),
        (tr!(words, "deviations-from-the-method"), "conditions.deviations", REPORT, given.deviations.is_some()),
        (tr!(words, "authorised-by"), "report.authorised_by", REPORT, is_stated(&issue.authorised_by)),
        (tr!(words, "instrument"), "instrument.name", CALIBRATION, is_stated(&c.instrument.name)),
        (
            tr!(words, "instrument-uncertainty"),
            "instrument.expanded_uncertainty_um",
            CALIBRATION,
            c.instrument.expanded_uncertainty_um.is_some() || c.instrument.expanded_position_uncertainty_um.is_some(),
        ),
        (
            tr!(words, "instrument-calibration"),
            "conditions.instrument_calibration",
            CALIBRATION,
            is_stated(&given.instrument_calibration),
        ),
        (tr!(words, "traceability"), "conditions.traceability", CALIBRATION, is_stated(&given.traceability)),
        (tr!(words, "temperature"), "temperature_c", CALIBRATION, c.temperature.stated_c.is_some()),
    ];
    if !results.verdict.limits.is_empty() {
        let limits = &c.limits;
        all.push((tr!(words, "decision-rule"), "limits.decision_rule", CONFORMITY, limits.decision_rule.is_some()));
        let specification = is_stated(&limits.specification);
        all.push((tr!(words, "limits-specification"), "limits.specification", CONFORMITY, specification));
    }
    all
}

/// Conditions that influence the results.
fn influences(results: &Results, clause: &'static str, words: &Words) -> Vec<Field> {
    let given = &results.campaign.conditions;
    // readings may give their own loads
    let sets = results.identified.iter().flat_map(|identified| &identified.accuracy.sets);
    let of_readings = sets.flat_map(|set| &set.readings).any(|v| v.quantity == ReadingQuantity::PayloadMass);
    let load = given.motion.load_kg.is_some() || of_readings;
    vec![
        (tr!(words, "controller"), "conditions.controller", clause, is_stated(&given.robot.controller)),
        (tr!(words, "load"), "conditions.load_kg", clause, load),
        (tr!(words, "warm-up-before-the-test"), "conditions.warm_up_minutes", clause, given.warm_up_minutes.is_some()),
    ]
}

/// Conditions of a test.
fn test_fields(results: &Results, words: &Words) -> Vec<Field> {
    let given = &results.campaign.conditions;
    let velocity = given.motion.velocities_percent.is_some() || given.motion.velocities_mm_s.is_some();
    let mut all = vec![
        (tr!(words, "mounting"), "conditions.mounting", TEST, is_stated(&given.robot.mounting)),
        (tr!(words, "measurement-point"), "conditions.measurement_point", TEST, is_stated(&given.measurement_point)),
        (tr!(words, "velocities"), "conditions.velocities_percent", TEST, velocity),
    ];
    all.extend(influences(results, TEST, words));
    all
}
