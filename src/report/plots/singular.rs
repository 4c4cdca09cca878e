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
    let up = Axis::decades("", (smallest, largest), DECADES);
    let labels = (0..all.len()).step_by(all.len().div_ceil(LABELS)).map(|i| (i as f64, (i + 1).to_string()));
    let across = Axis::rows(all.len(), labels.collect(), 0.7);
    let names = [words.say("number of the singular value"), words.say("singular value")];
    let mut chart = Chart::new(WIDE, [across, up], names);
    if is_cut_drawn {
        chart.level("knee", cut);
        let (x, y) = chart.at(-0.7, cut);
        chart.svg.text("start", (x + 8.0, y - 6.0), &words.fill("rank cut {0}", &[&significant(cut, 2)]));
    }
    for (i, (s, held)) in all.iter().enumerate() {
        let at = chart.at(i as f64, s.value);
        let (look, radius) = if *held { (VALIDATION, 5.0) } else { (CALIBRATION, 4.0) };
        let tip = format!("{}: {} {}", i + 1, significant(s.value, 3), s.parameters.join(", "));
        chart.svg.mark(look, at, radius, tip.trim_end());
    }
    let row = |(i, (s, held)): (usize, &(&SingularValueEntry, bool))| {
        let direction = if *held { words.say("held") } else { words.say("identified") };
        vec![(i + 1).to_string(), significant(s.value, 4), direction, s.parameters.join(", ")]
    };
    let title = words.say("Singular values of the identification");
    let description = words.say("One mark for each singular value in descending order, on a logarithmic axis: high is well observable, low is badly observable.");
    Some(Figure {
        caption: caption(o, words),
        table_title: words.say("Numbers of this picture"),
        header: vec![words.say("number"), words.say("singular value"), words.say("direction"), words.say("parameters")],
        rows: all.iter().enumerate().map(row).collect(),
        ..chart.figure("singular-values", title, description)
    })
}

fn caption(o: &ObservabilitySummary, words: &Words) -> String {
    let scaled = words.fill(
        "Of the Jacobian at the solution, every column divided by its norm, as the identification scales it: rank {0}, condition number {1}, the largest over the smallest of the circles.",
        &[&o.rank, &significant(o.condition, 3)],
    );
    let cut = match o.held_singular_values.len() {
        0 => words.fill("None is held: no column lies within the rank cut of {0} of what the others span.", &[&significant(o.rank_cut, 2)]),
        held => words.fill(
            "Diamonds: the {0} smallest with all parameters; as many are held. About the line at {1} times the largest and below it the data do not determine a direction, above it hardly.",
            &[&held, &significant(o.rank_cut, 2)],
        ),
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
        assert!(!drawn.svg.contains("rank cut") && drawn.caption.contains("within the rank cut of 1.0e-9"));
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
