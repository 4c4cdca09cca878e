//! How far identified parameters are from the true ones after a simulated calibration (figure 4.8).

use super::axis::{Axis, range};
use super::svg::Svg;
use crate::model::Figure;
use crate::number::{self, Shown};
use crate::words::Words;
use etalon_documents::{StudiedParameter, StudyDocument};

const WIDTH: f64 = 380.0;
const HEIGHT: f64 = 300.0;
const LEFT: f64 = 58.0;
const RIGHT: f64 = 368.0;
const TOP: f64 = 14.0;
const BOTTOM: f64 = 262.0;

/// One picture for each unit that occurs.
pub(crate) fn pictures(study: &StudyDocument, words: &Words) -> Vec<Figure> {
    ["mm", "deg", "1"].into_iter().filter_map(|unit| picture(study, unit, words)).collect()
}

fn picture(study: &StudyDocument, unit: &str, words: &Words) -> Option<Figure> {
    let off = |p: &StudiedParameter| p.identified - p.actual;
    let all: Vec<_> = study.parameters.iter().filter(|p| p.unit == unit && off(p).is_finite()).collect();
    let largest = range(all.iter().map(|p| off(p).abs()))?.1;
    // an angle's error is some 1e-4 deg: thousandths leave room for the labels
    let shown = match unit {
        "deg" if largest < 0.05 => Shown { unit: "10⁻³ deg", factor: 1000.0 },
        _ => number::shown(unit, largest),
    };
    let reach = Axis::from_zero(largest * shown.factor, 0.0, 1.0).high();
    let up = Axis::linear(-reach, reach, BOTTOM, TOP);
    let title = words.fill("Errors of identified parameters, {0}", &[&shown.unit]);
    let description = words.say("One bar a parameter: identified minus true.");
    let mut svg = Svg::new(&format!("off-{unit}"), WIDTH, HEIGHT, &title, &description);
    for (value, label) in up.ticks(6) {
        svg.line("grid", (LEFT, up.at(value)), (RIGHT, up.at(value)));
        svg.text("end", (LEFT - 5.0, up.at(value) + 4.0), &label);
    }
    let pitch = (RIGHT - LEFT) / all.len() as f64;
    let zero = up.at(0.0);
    for (i, p) in all.iter().enumerate() {
        let (x, y) = (LEFT + pitch * (i as f64 + 0.5), up.at(off(p) * shown.factor));
        let value = format!("{} {}", number::significant(off(p) * shown.factor, 3), shown.unit);
        let wide = (0.6 * pitch).min(28.0);
        svg.rect(
            "cal",
            (x - 0.5 * wide, y.min(zero)),
            (wide, (y - zero).abs().max(0.5)),
            &format!("{}: {value}", p.name),
        );
        // names of many parameters would hide each other
        if all.len() <= 16 {
            svg.text("mid", (x, BOTTOM + 17.0), &p.name);
        }
    }
    svg.line("axis", (LEFT, zero), (RIGHT, zero));
    svg.line("axis", (LEFT, TOP), (LEFT, BOTTOM));
    svg.text_upwards((12.0, (TOP + BOTTOM) / 2.0), &words.fill("identified minus true in {0}", &[&shown.unit]));
    Some(Figure {
        title,
        svg: svg.finish(),
        caption: words.fill("Mean of {0} identifications; values are in the table above.", &[&study.runs]),
        ..Figure::default()
    })
}
