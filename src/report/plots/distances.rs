//! Errors of the distances between poses, by distance: root mean square and maximum, before and
//! after calibration.

use super::layer::*;
use etalon_documents::{DistanceStatistics, RelativeAccuracy};

/// Number of decades below the largest error.
const DECADES: u8 = 4;

/// Value of a figure of the error (mm), with its expanded uncertainty.
struct Value {
    mm: f64,
    expanded_mm: Option<f64>,
}

/// A figure of the error: its name, its look and its value.
type Series<'a> = (String, Look<'static>, &'a dyn Fn(&DistanceStatistics) -> Value);

/// Returns the figure; `None` with fewer than two steps or without a positive error.
pub(crate) fn picture(relative: &RelativeAccuracy, words: &Words) -> Option<Figure> {
    let [rms, max] = [tr!(words, "rms"), tr!(words, "max")];
    let earlier = |name: &String| tr!(words, "before-named", name = name.as_str());
    let later = |name: &String| tr!(words, "after-named", name = name.as_str());
    let series: [Series; 4] = [
        (earlier(&max), before(CALIBRATION), &|s| Value { mm: s.before.max, expanded_mm: None }),
        (earlier(&rms), before(VALIDATION), &|s| Value { mm: s.before.rms, expanded_mm: None }),
        (later(&max), CALIBRATION, &|s| Value { mm: s.after.max, expanded_mm: s.expanded_max_mm }),
        (later(&rms), VALIDATION, &|s| Value { mm: s.after.rms, expanded_mm: s.expanded_rms_mm }),
    ];
    let steps = &relative.steps;
    let values: Vec<f64> = series.iter().flat_map(|(_, _, of)| steps.iter().map(|s| of(s).mm)).collect();
    let [low, high] = range(values.iter().copied().filter(|v| *v > 0.0 && drawable(*v)))?;
    let ends = range(steps.iter().flat_map(|s| [s.from_mm, s.to_mm]).filter(|v| drawable(*v)))?;
    if steps.len() < 2 {
        return None;
    }
    let up = Axis::decades("mm", [low, high], DECADES);
    let unit = up.display_unit().unit;
    let across = Axis::over("", ends, 0.0);
    let names = [tr!(words, "distance-between-poses-in-mm"), tr!(words, "error-in-unit", unit)];
    let mut chart = Chart::new(words, WIDE, [across, up], names);
    for (name, look, of) in &series {
        let at = |s: &DistanceStatistics| chart.at(0.5 * (s.from_mm + s.to_mm), of(s).mm);
        let places: Vec<Place> = steps.iter().map(at).collect();
        let ends: Vec<Vec<Place>> = steps.iter().map(|s| interval(&chart, s, &of(s))).collect();
        chart.svg.lines("leader", &places);
        for ((step, place), ends) in steps.iter().zip(places).zip(ends) {
            chart.svg.interval("axis", place, ends);
            chart.svg.mark(*look, place, 4.0, &tooltip(name, step, &of(step), words));
        }
        chart.svg.legend(*look, name);
    }
    let description = tr!(words, "distances-by-distance-description", pairs = relative.all.pairs);
    let title = tr!(words, "distances-by-distance-title");
    Some(chart.figure("distance-errors", title, description))
}

fn before(look: Look<'static>) -> Look<'static> {
    Look { class: "before", ..look }
}

/// Ends of the expanded uncertainty of a value.
fn interval(chart: &Chart, step: &DistanceStatistics, value: &Value) -> Vec<Place> {
    let ends = value.expanded_mm.map(|u| [value.mm - u, value.mm + u]);
    ends.iter().flatten().map(|v| chart.at(0.5 * (step.from_mm + step.to_mm), *v)).collect()
}

fn tooltip(name: &str, step: &DistanceStatistics, value: &Value, words: &Words) -> String {
    let um = |mm: f64| number::significant(1e3 * mm, 3);
    let [from, to] = [step.from_mm, step.to_mm].map(number::stated);
    let Value { mm, expanded_mm } = value;
    let value = um(*mm);
    match expanded_mm {
        Some(u) => {
            let u = um(*u);
            tr!(words, "distance-error-tooltip-u", name, value, u, from, to, pairs = step.pairs)
        }
        None => tr!(words, "distance-error-tooltip", name, value, from, to, pairs = step.pairs),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::demo::relative;

    #[test]
    fn each_step_has_four_marks_and_the_uncertainty_of_what_is_judged() {
        let document = relative();
        let steps = document.steps.len();
        let figure = picture(&document, &Words::default()).expect("a figure");
        // one mark of each shape in the legend, before and after
        assert_eq!(figure.svg.matches("<circle").count(), 2 * steps + 2);
        assert!(figure.svg.contains("RMS, after: 12.0 µm ± 1.00 µm (k = 2)"), "{}", figure.svg);
        assert!(figure.svg.contains("0 to 100 mm"), "{}", figure.svg);
        let mut one = document.clone();
        one.steps.truncate(1);
        assert!(picture(&one, &Words::default()).is_none(), "one step shows no dependence");
        let mut odd = document;
        for step in &mut odd.steps {
            (step.after.rms, step.after.max, step.before.rms, step.before.max) = (0.0, f64::NAN, 0.0, f64::NAN);
        }
        assert!(picture(&odd, &Words::default()).is_none(), "a logarithm needs a positive error");
    }
}
