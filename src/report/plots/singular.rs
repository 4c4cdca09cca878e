//! Singular values of the identification in descending order on a logarithmic axis: well and poorly
//! determined directions.

use super::layer::*;
use crate::number::significant;
use etalon_documents::{ObservabilitySummary, SingularValueEntry};

/// Number of decades below the largest value; smaller values are rounding errors.
const DECADES: u8 = 18;
/// Maximum number of legible labels of an axis.
const LABELS: usize = 20;

/// Figure of the singular values; `None` if no value can be drawn.
pub(crate) fn picture(o: &ObservabilitySummary, words: &Words) -> Option<Figure> {
    let identified = o.singular_values.iter().map(|s| (s, false));
    let all: Vec<(&SingularValueEntry, bool)> =
        identified.chain(o.held_singular_values.iter().map(|s| (s, true))).collect();
    let values = || all.iter().map(|(s, _)| s.value);
    let largest = super::axis::largest(values().filter(|v| *v < 1e300));
    if !(largest > 0.0 && values().all(|v| (0.0..1e300).contains(&v))) {
        return None;
    }
    let cut = o.rank_cut * largest;
    let is_cut_drawn = cut > 0.0 && cut < largest && !o.held_singular_values.is_empty();
    let smallest = values().fold(if is_cut_drawn { cut } else { largest }, f64::min);
    let up = Axis::decades("", [smallest, largest], DECADES);
    let labels = (0..all.len()).step_by(all.len().div_ceil(LABELS)).map(|i| (i as f64, (i + 1).to_string()));
    let across = Axis::rows(all.len(), labels.collect(), 0.7);
    let names = [tr!(words, "singular-value-number"), tr!(words, "singular-value")];
    let mut chart = Chart::new(words, WIDE, [across, up], names);
    if is_cut_drawn {
        chart.level("knee", cut);
        let (x, y) = chart.at(-0.7, cut);
        chart.svg.text("start", (x + 8.0, y - 6.0), &tr!(words, "rank-cut", value = significant(cut, 2)));
    }
    for (i, (s, held)) in all.iter().enumerate() {
        let at = chart.at(i as f64, s.value);
        let (look, radius) = if *held { (VALIDATION, 5.0) } else { (CALIBRATION, 4.0) };
        let tip = format!("{}: {} {}", i + 1, words.significant(s.value, 3), s.parameters.join(", "));
        chart.svg.mark(look, at, radius, tip.trim_end());
    }
    let row = |(i, (s, held)): (usize, &(&SingularValueEntry, bool))| {
        let direction = if *held { tr!(words, "held") } else { tr!(words, "identified") };
        vec![(i + 1).to_string(), words.significant(s.value, 4), direction, s.parameters.join(", ")]
    };
    let title = tr!(words, "singular-values-title");
    let description = tr!(words, "singular-values-description");
    Some(Figure {
        caption: caption(o, words),
        table_title: tr!(words, "numbers-of-this-picture"),
        header: vec![
            tr!(words, "number"),
            tr!(words, "singular-value"),
            tr!(words, "direction"),
            tr!(words, "parameters"),
        ],
        rows: all.iter().enumerate().map(row).collect(),
        ..chart.figure("singular-values", title, description)
    })
}

fn caption(o: &ObservabilitySummary, words: &Words) -> String {
    let scaled = tr!(words, "singular-values-caption", rank = o.rank, condition = significant(o.condition, 3));
    let cut = match o.held_singular_values.len() {
        0 => tr!(words, "nothing-held", cut = significant(o.rank_cut, 2)),
        held => tr!(words, "held-singular-values", count = held, cut = significant(o.rank_cut, 2)),
    };
    format!("{scaled} {cut}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::demo::Documents;

    #[test]
    fn every_singular_value_has_a_mark_and_a_row_and_the_cut_is_stated() {
        let mut o = Documents::demo().parameters.observability.unwrap();
        let drawn = picture(&o, &Words::default()).unwrap();
        assert_eq!((drawn.svg.matches("<circle").count(), drawn.rows.len()), (11, 12));
        assert!(drawn.svg.contains("rank cut 2.3e-9") && drawn.svg.contains("11: 0.0500 beta, x_o"), "{}", drawn.svg);
        assert!(drawn.caption.contains("rank 11, condition number 46.9"), "{}", drawn.caption);
        o.held_singular_values.clear();
        let drawn = picture(&o, &Words::default()).unwrap();
        let nothing_held = tr!(Words::default(), "nothing-held", cut = "1.0e-9");
        assert!(!drawn.svg.contains("rank cut") && drawn.caption.contains(&nothing_held), "{}", drawn.caption);
    }

    #[test]
    fn nothing_and_numbers_that_are_none_do_no_harm() {
        let mut o = Documents::demo().parameters.observability.unwrap();
        for value in [0.0, 1e-300, 1e299, f64::NAN, f64::INFINITY, -1.0] {
            o.singular_values[3].value = value;
            if let Some(drawn) = picture(&o, &Words::default()) {
                assert!(!drawn.svg.contains("NaN") && !drawn.svg.contains("inf"), "{value}");
            }
        }
        o.singular_values.clear();
        o.held_singular_values.clear();
        assert!(picture(&o, &Words::default()).is_none());
    }
}
