//! Region of validity: ranges of the joint values of calibration and validation poses.

use crate::model::{Block, Columns, Section, Table, numbers};
use crate::number::{self, derived, significant};
use crate::words::{Words, tr};
use etalon_base::phrase;
use etalon_documents::{AccuracyDocument, IdentifiedDocuments, PoseSet, ReadingValues, Results, ValidationDistance};

/// Values of a joint, or of another column of the readings, at the measured poses.
struct Range<'a> {
    column: &'a str,
    calibration: Option<[f64; 2]>,
    validation: Option<[f64; 2]>,
}

/// Row of the table: a column of the readings, with its values at the poses of each set.
struct Row<'a> {
    column: &'a str,
    calibration: Option<String>,
    validation: Option<String>,
}

/// Column of the times of readings.
const TIME: &str = "time_s";
/// Digits of joint values (mm or deg).
const DIGITS: usize = 4;

pub(super) fn section(results: &Results, words: &Words) -> Option<Section> {
    let identified = results.identified.as_ref()?;
    let shown = |[from, to]: [f64; 2]| {
        let [from, to] = [from, to].map(|value| significant(value, DIGITS));
        tr!(words, "range", from, to)
    };
    let joints = ranges(identified).into_iter().map(|r| Row {
        column: r.column,
        calibration: r.calibration.map(shown),
        validation: r.validation.map(shown),
    });
    let rows: Vec<Row> = joints.chain(readings(identified, words)).collect();
    let columns = Columns::<Row>::new()
        .page(phrase!("quantity"), "", |r| r.column)
        .page(phrase!("calibration"), "", |r| numbers(r.calibration.clone()))
        .page(phrase!("validation"), "", |r| numbers(r.validation.clone()));
    let table = Table::new(words, &rows, columns).without_empty_columns();
    let mut section = Section::new("region", tr!(words, "region-of-validity"));
    section.table("", tr!(words, "region-note"), table);
    if let Some(distance) = &identified.accuracy.validation_distance {
        section.push(Block::text(validation_region(distance, words)));
    }
    section.whole()
}

/// Ranges of all joints over the measured errors.
fn ranges(identified: &IdentifiedDocuments) -> Vec<Range<'_>> {
    let range = |set: PoseSet, k: usize| {
        let of_set = identified.errors.iter().filter(|error| error.set == set);
        let values = of_set.filter_map(|error| error.joints.get(k).copied());
        values.map(|value| [value; 2]).reduce(|[low, high], [value, _]| [low.min(value), high.max(value)])
    };
    let named = |(k, joint)| Range {
        column: joint,
        calibration: range(PoseSet::Calibration, k),
        validation: range(PoseSet::Validation, k),
    };
    let names = identified.accuracy.joints.iter().map(String::as_str);
    // results do not apply to times alone
    let names = names.enumerate().filter(|(_, name)| *name != TIME);
    names.map(named).filter(|range| range.calibration.or(range.validation).is_some()).collect()
}

/// Loads, torques and temperatures of the readings.
fn readings<'a>(identified: &'a IdentifiedDocuments, words: &Words) -> Vec<Row<'a>> {
    let values = |name: PoseSet| {
        let sets = identified.accuracy.sets.iter().filter(move |set| set.name == name);
        sets.flat_map(|set| &set.readings)
    };
    let column = |all: &'a ReadingValues| {
        let shown = |name| values(name).find(|v| v.column == all.column).map(|v| listed(v, words));
        Row { column: &all.column, calibration: shown(PoseSet::Calibration), validation: shown(PoseSet::Validation) }
    };
    let first = identified.accuracy.sets.iter().find(|set| !set.readings.is_empty());
    first.into_iter().flat_map(|set| &set.readings).map(column).collect()
}

/// Sentence on the validation poses outside the region of the calibration poses.
pub(super) fn validation_region(distance: &ValidationDistance, words: &Words) -> String {
    let number = |v: f64| number::fixed(v, 2);
    tr!(
        words,
        "errors-hold-among",
        region = if distance.is_within() { "within" } else { "beyond" },
        ratio = number(distance.median),
        largest = number(distance.largest),
        outside = distance.outside,
        total = distance.poses
    )
}

/// Sentence on the loads, torques and temperatures of the calibration readings; empty without them.
pub(super) fn readings_sentence(accuracy: &AccuracyDocument, words: &Words) -> String {
    let set = accuracy.sets.iter().find(|set| set.name == PoseSet::Calibration && !set.readings.is_empty());
    let column = |values: &ReadingValues| format!("{} {}", values.column, listed(values, words));
    let all = set.map(|set| set.readings.iter().map(column).collect::<Vec<_>>().join(", "));
    all.map_or_else(String::new, |values| tr!(words, "region-of-readings", values))
}

/// Few distinct values as a list, otherwise their range.
pub(super) fn listed(values: &ReadingValues, words: &Words) -> String {
    match values.distinct.as_slice() {
        [] => range(values, words),
        // the decimal mark may be a comma
        distinct => distinct.iter().map(|value| words.decimal(derived(*value))).collect::<Vec<_>>().join("; "),
    }
}

/// Range of values, or their common value.
pub(super) fn range(values: &ReadingValues, words: &Words) -> String {
    let [from, to] = [values.lowest, values.highest].map(|value| words.decimal(derived(value)));
    if from == to { from } else { tr!(words, "range", from, to) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::demo::Documents;

    #[test]
    fn ranges_are_of_the_measured_joint_values() {
        let mut documents = Documents::demo();
        documents.accuracy.joints = vec!["q1_deg".to_owned(), "q2_mm".to_owned()];
        for (i, error) in documents.errors.iter_mut().enumerate() {
            error.joints = vec![i as f64, -10.5];
        }
        let identified = documents.identified();
        let all = ranges(&identified);
        let of_set = |set: PoseSet| documents.errors.iter().filter(move |e| e.set == set).count() as f64;
        let (first, all_errors) = (of_set(PoseSet::Calibration), documents.errors.len() as f64);
        assert_eq!(all[0].calibration, Some([0.0, first - 1.0]));
        assert_eq!(all[0].validation, Some([first, all_errors - 1.0]));
        assert_eq!((all[1].column, all[1].validation), ("q2_mm", Some([-10.5; 2])));
        let words = Words::default();
        let text = serde_json::to_string(&section(&documents.results(), &words).unwrap()).unwrap();
        let distance = documents.accuracy.validation_distance.as_ref().unwrap();
        // three of 51 poses have a joint outside its range
        let sentence = validation_region(distance, &words);
        assert!(text.contains("-10.5") && sentence.starts_with("Some validation poses are outside"), "{text}");
        documents.errors.iter_mut().for_each(|error| error.joints.clear());
        documents.accuracy.validation_distance = None;
        assert!(section(&documents.results(), &words).is_none());
    }
}
