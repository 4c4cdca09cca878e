//! Region of validity: ranges of the joint values of calibration and validation poses.

use crate::model::{Block, Columns, Section, Table, numbers};
use crate::number::significant;
use crate::words::{Words, tr};
use etalon_base::phrase;
use etalon_documents::{IdentifiedDocuments, PoseSet, Results};

/// Values of a joint at the measured poses.
struct Range<'a> {
    joint: &'a str,
    calibration: Option<[f64; 2]>,
    validation: Option<[f64; 2]>,
}

/// Column of the times of readings.
const TIME: &str = "time_s";
/// Digits of joint values (mm or deg).
const DIGITS: usize = 4;

pub(super) fn section(results: &Results, words: &Words) -> Option<Section> {
    let identified = results.identified.as_ref()?;
    let ranges = ranges(identified);
    let shown = |range: Option<[f64; 2]>| {
        let [from, to] = range?.map(|value| significant(value, DIGITS));
        Some(tr!(words, "range", from, to))
    };
    let columns = Columns::<Range>::new()
        .page(phrase!("quantity"), "", |r| r.joint)
        .page(phrase!("calibration"), "", move |r| numbers(shown(r.calibration)))
        .page(phrase!("validation"), "", move |r| numbers(shown(r.validation)));
    let table = Table::new(words, &ranges, columns).without_empty_columns();
    let mut section = Section::new("region", tr!(words, "region-of-validity"));
    section.table("", tr!(words, "region-note"), table);
    if let Some(distance) = &identified.accuracy.validation_distance {
        section.push(Block::text(super::errors::validation_region(distance, words)));
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
        joint,
        calibration: range(PoseSet::Calibration, k),
        validation: range(PoseSet::Validation, k),
    };
    let names = identified.accuracy.joints.iter().map(String::as_str);
    // results do not apply to times alone
    let names = names.enumerate().filter(|(_, name)| *name != TIME);
    names.map(named).filter(|range| range.calibration.or(range.validation).is_some()).collect()
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
        assert_eq!((all[1].joint, all[1].validation), ("q2_mm", Some([-10.5; 2])));
        let words = Words::default();
        let text = serde_json::to_string(&section(&documents.results(), &words).unwrap()).unwrap();
        let distance = documents.accuracy.validation_distance.as_ref().unwrap();
        // three of 51 poses have a joint outside its range
        let sentence = super::super::errors::validation_region(distance, &words);
        assert!(text.contains("-10.5") && sentence.starts_with("Some validation poses are outside"), "{text}");
        documents.errors.iter_mut().for_each(|error| error.joints.clear());
        documents.accuracy.validation_distance = None;
        assert!(section(&documents.results(), &words).is_none());
    }
}
