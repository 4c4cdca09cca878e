//! Errors of held-out poses without and with a residual field.

use super::by_pose::across;
use super::layer::*;
use etalon_documents::FieldHeldOut;

/// Figure of the errors; `None` without poses.
pub(crate) fn picture(held: &FieldHeldOut, words: &Words) -> Option<Figure> {
    let poses: Vec<PoseName> = held.poses.iter().map(|p| p.pose).collect();
    if poses.is_empty() {
        return None;
    }
    let most = largest(held.poses.iter().flat_map(|p| [p.without_mm, p.with_mm]));
    let axis = Axis::from_zero("mm", most);
    let name = tr!(words, "position-error-in", unit = axis.display_unit().unit);
    let mut chart = Chart::new(words, WIDE, [across(&poses), axis], [tr!(words, "pose"), name]);
    let before = Look { class: "before", ..CALIBRATION };
    let without = held.poses.iter().enumerate().map(|(i, p)| (before, i, p.pose, p.without_mm));
    let with = held.poses.iter().enumerate().map(|(i, p)| (CALIBRATION, i, p.pose, p.with_mm));
    for (look, i, pose, size_mm) in without.chain(with) {
        let tip = format!("{pose}: {} µm", words.significant(1e3 * size_mm, 3));
        chart.svg.mark(look, chart.at(i as f64, size_mm), 2.8, &tip);
    }
    chart.svg.legend(before, &tr!(words, "without-field"));
    chart.svg.legend(CALIBRATION, &tr!(words, "with-field"));
    let caption = tr!(words, "field-held-out-caption");
    let title = tr!(words, "field-held-out-title");
    Some(Figure { caption, ..chart.figure("field-held-out", title, tr!(words, "field-held-out-description")) })
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_documents::FieldPose;

    #[test]
    fn each_pose_has_a_mark_without_and_with_the_field() {
        let pose = |i: i64| FieldPose { pose: i.into(), without_mm: 0.3, with_mm: 0.04 };
        let held = FieldHeldOut {
            without_mm: 0.3,
            with_mm: 0.04,
            gain_over_u: 9.0,
            coverage: 0.95,
            factor: 1.0,
            poses: (1..=7).map(pose).collect(),
        };
        let svg = picture(&held, &Words::default()).unwrap().svg;
        assert_eq!((svg.matches(": 300 µm").count(), svg.matches(": 40.0 µm").count()), (7, 7), "{svg}");
        assert!(picture(&FieldHeldOut { poses: Vec::new(), ..held }, &Words::default()).is_none());
    }
}
