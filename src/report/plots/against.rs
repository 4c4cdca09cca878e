//! The error after calibration against what may explain it: the value of each joint, and the distance from the base.

use super::axis::{Axis, left_margin, range};
use super::limit_lines::LimitLines;
use super::points;
use super::svg::Svg;
use crate::model::Figure;
use crate::number;
use crate::words::Words;
use etalon_base::pose::{Vector, minus, norm};
use etalon_documents::{LimitVerdict, PointError};

const WIDTH: f64 = 380.0;
const HEIGHT: f64 = 250.0;
const RIGHT: f64 = 360.0;
const TOP: f64 = 14.0;
const BOTTOM: f64 = 206.0;

/// A quantity of a pose.
type Quantity<'a> = Box<dyn Fn(&PointError) -> Option<f64> + 'a>;

/// What errors are drawn against.
struct Along<'a> {
    id: String,
    name: String,
    of: Quantity<'a>,
}

/// One picture for each joint, and one for the distance from the base.
pub(crate) fn pictures(
    errors: &[&PointError],
    joints: &[String],
    base_mm: Option<Vector>,
    limits: &[LimitVerdict],
    words: &Words,
) -> Vec<Figure> {
    let of_joint = |(k, column): (usize, &String)| {
        let (name, unit) = column.rsplit_once('_').unwrap_or((column, ""));
        let name = words.fill("{0} in {1}", &[&name, &unit]);
        Along { id: format!("joint-{k}"), name, of: Box::new(move |p| p.joints.get(k).copied()) }
    };
    let reach = base_mm.map(|base| Along {
        id: "reach".to_owned(),
        name: words.say("distance from the base in mm"),
        of: Box::new(move |p| Some(norm(minus(p.at_mm, base)))),
    });
    let all = joints.iter().enumerate().map(of_joint).chain(reach);
    all.filter_map(|along| picture(errors, &along, limits, words)).collect()
}

fn picture(errors: &[&PointError], along: &Along, limits: &[LimitVerdict], words: &Words) -> Option<Figure> {
    let known: Vec<&PointError> =
        errors.iter().copied().filter(|p| (along.of)(p).is_some_and(f64::is_finite)).collect();
    let drawn = points::readable(&known);
    let (low, high) = range(drawn.iter().filter_map(|p| (along.of)(p))).filter(|(low, high)| high > low)?;
    let largest = range(drawn.iter().map(|p| points::after_mm(p)))?.1;
    let shown = number::shown("mm", largest);
    let up = Axis::from_zero(largest * shown.factor, BOTTOM, TOP);
    let ticks = up.ticks(5);
    let left = left_margin(&ticks);
    let margin = 0.02 * (high - low);
    let across = Axis::linear(low - margin, high + margin, left, RIGHT);
    let title = words.fill("Position error after calibration against {0}", &[&along.name]);
    let description = words.say(
        "One mark for each error: circles calibration, diamonds validation poses. A trend is what the model lacks.",
    );
    let on_axis = |v: f64| Some(v * shown.factor).filter(|v| *v <= up.high()).map(|v| up.at(v));
    let limits = LimitLines::new(&points::limits_of(limits, "position"), on_axis);
    let height = HEIGHT + limits.height(WIDTH);
    let mut svg = Svg::new(&format!("against-{}", along.id), WIDTH, height, &title, &description);
    for (value, label) in &ticks {
        svg.line("grid", (left, up.at(*value)), (RIGHT, up.at(*value)));
        svg.text("end", (left - 5.0, up.at(*value) + 4.0), label);
    }
    for (value, label) in across.ticks(6) {
        svg.line("axis", (across.at(value), BOTTOM), (across.at(value), BOTTOM + 4.0));
        svg.text("mid", (across.at(value), BOTTOM + 17.0), &label);
    }
    svg.line("axis", (left, BOTTOM), (RIGHT, BOTTOM));
    svg.line("axis", (left, TOP), (left, BOTTOM));
    svg.text("mid", ((left + RIGHT) / 2.0, BOTTOM + 36.0), &along.name);
    svg.text_upwards((12.0, (TOP + BOTTOM) / 2.0), &words.fill("position error in {0}", &[&shown.unit]));
    for p in &drawn {
        let at = (across.at((along.of)(p)?), up.at(points::after_mm(p) * shown.factor));
        svg.mark(points::shape(p), points::class(p), at, 2.4, "", &points::tooltip(p, words));
    }
    limits.level(&mut svg, (left, RIGHT));
    limits.legend(&mut svg, HEIGHT, WIDTH);
    let caption = description + &points::how_many(drawn.len(), known.len(), words);
    Some(Figure { title, svg: svg.finish(), caption, ..Figure::default() })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::demo::point;

    #[test]
    fn every_joint_that_moves_and_the_distance_from_the_base_have_a_picture() {
        let mut errors: Vec<_> = (0..9).map(|i| point(i, [30.0 * i as f64, 40.0, 0.0], [0.1; 3], [0.01; 3])).collect();
        errors.iter_mut().enumerate().for_each(|(i, p)| p.joints = vec![i as f64, 5.0]);
        let all: Vec<_> = errors.iter().collect();
        let joints = ["q1_deg", "q2_deg"].map(str::to_owned);
        let figures = pictures(&all, &joints, Some([0.0; 3]), &[], &Words::default());
        let titles: Vec<&str> = figures.iter().map(|f| f.title.as_str()).collect();
        assert_eq!(titles.len(), 2, "a joint that stands still explains nothing: {titles:?}");
        assert!(titles[0].ends_with("against q1 in deg") && titles[1].ends_with("distance from the base in mm"));
        assert_eq!(figures[0].svg.matches("<circle").count(), 9);
        assert!(pictures(&all, &[], None, &[], &Words::default()).is_empty());
    }
}
