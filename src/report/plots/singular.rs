//! What the data determine well and what badly: the singular values of the identification, in order, on a logarithmic axis.

use super::axis::{Axis, left_margin};
use super::svg::{Shape, Svg};
use crate::model::Figure;
use crate::number::significant;
use crate::words::Words;
use etalon_documents::{ObservabilitySummary, SingularValueEntry};

const WIDTH: f64 = 760.0;
const RIGHT: f64 = 744.0;
const TOP: f64 = 16.0;
const BOTTOM: f64 = 250.0;
/// Decades below the largest that are drawn: beyond is rounding.
const DECADES: u8 = 18;
/// Labels of an axis that do not run into each other.
const LABELS: usize = 20;

/// `None` where the document has no singular value that could be drawn.
pub(crate) fn picture(o: &ObservabilitySummary, words: &Words) -> Option<Figure> {
    let identified = o.singular_values.iter().map(|s| (s, false));
    let all: Vec<(&SingularValueEntry, bool)> =
        identified.chain(o.held_singular_values.iter().map(|s| (s, true))).collect();
    let drawable = |(s, _): &&(&SingularValueEntry, bool)| s.value >= 0.0 && s.value < 1e300;
    let largest = all.iter().filter(drawable).map(|(s, _)| s.value).fold(0.0, f64::max);
    if !(largest > 0.0 && all.iter().all(|s| drawable(&s))) {
        return None;
    }
    let cut = o.rank_cut * largest;
    let is_cut_drawn = cut > 0.0 && cut < largest && !o.held_singular_values.is_empty();
    let smallest = all.iter().map(|(s, _)| s.value).fold(if is_cut_drawn { cut } else { largest }, f64::min);
    let up = Axis::decades(smallest, largest, DECADES, BOTTOM, TOP);
    let title = words.say("Singular values of the identification");
    let description = words.say("One mark for each singular value in descending order, on a logarithmic axis: high is well observable, low is badly observable.");
    let mut svg = Svg::new("singular-values", WIDTH, BOTTOM + 46.0, &title, &description);
    let ticks = up.ticks(6);
    let left = left_margin(&ticks);
    let across = Axis::linear(0.3, all.len() as f64 + 0.7, left, RIGHT);
    for (value, label) in ticks.iter().step_by(ticks.len().div_ceil(LABELS / 2)) {
        svg.line("grid", (left, up.at(*value)), (RIGHT, up.at(*value)));
        svg.text("end", (left - 5.0, up.at(*value) + 4.0), label);
    }
    for i in (0..all.len()).step_by(all.len().div_ceil(LABELS)) {
        svg.text("mid", (across.at(i as f64 + 1.0), BOTTOM + 17.0), &(i + 1).to_string());
    }
    svg.line("axis", (left, BOTTOM), (RIGHT, BOTTOM));
    svg.line("axis", (left, TOP), (left, BOTTOM));
    svg.text("mid", ((left + RIGHT) / 2.0, BOTTOM + 36.0), &words.say("number of the singular value"));
    svg.text_upwards((12.0, (TOP + BOTTOM) / 2.0), &words.say("singular value"));
    if is_cut_drawn {
        svg.line("knee", (left, up.at(cut)), (RIGHT, up.at(cut)));
        let label = words.fill("rank cut {0}", &[&significant(cut, 2)]);
        svg.text("start", (left + 8.0, up.at(cut) - 6.0), &label);
    }
    for (i, (s, held)) in all.iter().enumerate() {
        let at = (across.at(i as f64 + 1.0), up.at(s.value));
        let tip = format!("{}: {} {}", i + 1, significant(s.value, 3), s.parameters.join(", "));
        match held {
            true => svg.mark(Shape::Diamond, "val", at, 5.0, "", tip.trim_end()),
            false => svg.mark(Shape::Circle, "cal", at, 4.0, "", tip.trim_end()),
        }
    }
    let row = |(i, (s, held)): (usize, &(&SingularValueEntry, bool))| {
        let direction = if *held { words.say("held") } else { words.say("identified") };
        vec![(i + 1).to_string(), significant(s.value, 4), direction, s.parameters.join(", ")]
    };
    Some(Figure {
        title,
        svg: svg.finish(),
        caption: caption(o, words),
        wide: true,
        table_title: words.say("Numbers of this picture"),
        header: vec![words.say("number"), words.say("singular value"), words.say("direction"), words.say("parameters")],
        rows: all.iter().enumerate().map(row).collect(),
        ..Figure::default()
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
