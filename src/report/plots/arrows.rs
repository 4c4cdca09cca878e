//! Error vectors before and after calibration, enlarged by a stated factor.

use super::axis::range;
use super::plane::{self, Plane, WIDTH};
use super::points;
use super::svg::{Place, Svg};
use crate::model::Figure;
use crate::number::{self, round_down_125};
use crate::words::Words;
use etalon_base::pose::Vector;
use etalon_documents::PointError;

/// More arrows than this cannot be read.
const LIMIT: usize = 120;
/// The longest arrow takes about this share of the workspace.
const SHARE: f64 = 0.16;

/// Before and after, side by side, for every plane of the workspace.
pub(crate) fn arrows(errors: &[&PointError], planar: bool, words: &Words) -> Vec<Figure> {
    let of_plane = |&axes: &(usize, usize)| [false, true].map(|after| in_plane(errors, axes, after, words));
    let mut all: Vec<Figure> = plane::planes(planar).iter().flat_map(of_plane).collect();
    if let Some(figure) = all.get_mut(1) {
        (figure.table_title, figure.header, figure.rows) = table(&drawn(errors, true), words);
    }
    all
}

fn drawn<'a>(errors: &[&'a PointError], after: bool) -> Vec<&'a PointError> {
    points::thin(errors, LIMIT, if after { points::after_mm } else { points::before_mm })
}

fn in_plane(errors: &[&PointError], axes: (usize, usize), after: bool, words: &Words) -> Figure {
    let drawn = drawn(errors, after);
    let error = |p: &PointError| if after { p.after_mm } else { p.before_mm };
    let in_plane = |v: Vector| v[axes.0].hypot(v[axes.1]);
    let longest_mm = range(drawn.iter().map(|p| in_plane(error(p)))).map_or(0.0, |r| r.1);
    let factor = enlargement(&drawn, axes, longest_mm);
    let tip_mm = |p: &PointError| [0, 1, 2].map(|i| p.at_mm[i] + factor * error(p)[i]);
    let places: Vec<_> = drawn.iter().flat_map(|p| [p.at_mm, tip_mm(p)]).collect();
    let plane = Plane::around(axes, &places);
    let shown = number::shown("mm", longest_mm);
    let times = number::significant(factor, 1);
    let name = plane::name(axes);
    let title = match after {
        true => words.fill("Error vectors after calibration, {0} plane", &[&name]),
        false => words.fill("Error vectors before calibration, {0} plane", &[&name]),
    };
    let description = words
        .fill("At each measured position an arrow of measured minus predicted, arrows enlarged {0} times.", &[&times]);
    let id = format!("arrows-{}-{name}", if after { "after" } else { "before" });
    let mut svg = Svg::new(&id, WIDTH, plane.height() + 44.0, &title, &description);
    plane.draw(&mut svg, words);
    for (class, validation) in [("arrow-cal", false), ("arrow-val", true)] {
        let of_set = drawn.iter().filter(|p| points::is_validation(p) == validation);
        let all: Vec<[Place; 2]> = of_set.map(|p| [plane.at(p.at_mm), plane.at(tip_mm(p))]).collect();
        svg.arrows(class, &all);
    }
    for p in &drawn {
        let tip = points::tooltip(p, words);
        svg.mark(points::shape(p), points::class(p), plane.at(p.at_mm), 2.0, "", &tip);
    }
    // the scale arrow: a round length as long as the picture's own arrows
    let round = round_down_125(longest_mm * shown.factor);
    if longest_mm > 0.0 {
        let length = round / shown.factor * factor * plane.scale;
        let y = plane.height() + 10.0;
        svg.arrow("arrow-scale", (30.0, y), (30.0 + length, y));
        svg.text("start", (36.0 + length, y + 4.0), &format!("{} {}", number::significant(round, 1), shown.unit));
    }
    for (i, (shape, class, name)) in points::sets(errors).into_iter().enumerate() {
        let x = 30.0 + 120.0 * i as f64;
        svg.mark(shape, class, (x, plane.height() + 32.0), 3.5, "", "");
        svg.text("start", (x + 10.0, plane.height() + 36.0), &words.say(name));
    }
    let longest = format!("{} {}", number::significant(longest_mm * shown.factor, 3), shown.unit);
    let few = match drawn.len() < errors.len() {
        true => format!(
            " {}",
            words.fill(
                "{0} of {1} points are drawn, evenly chosen, the largest among them.",
                &[&drawn.len(), &errors.len()]
            )
        ),
        false => String::new(),
    };
    let caption = words.fill("Arrows enlarged {0} times; the longest is {1}.", &[&times, &longest]) + &few;
    Figure {
        title,
        pair: format!("arrows-{name}"),
        side: if after { "after" } else { "before" },
        svg: svg.finish(),
        caption,
        ..Figure::default()
    }
}

/// The round factor that makes the longest arrow a readable share of the workspace.
fn enlargement(drawn: &[&PointError], axes: (usize, usize), longest_mm: f64) -> f64 {
    let span = |axis: usize| range(drawn.iter().map(|p| p.at_mm[axis])).map_or(0.0, |(low, high)| high - low);
    let workspace = span(axes.0).max(span(axes.1)).max(1.0);
    if longest_mm > 0.0 { round_down_125(SHARE * workspace / longest_mm) } else { 1.0 }
}

fn table(drawn: &[&PointError], words: &Words) -> (String, Vec<String>, Vec<Vec<String>>) {
    let shown = number::shown("mm", range(drawn.iter().map(|p| points::after_mm(p))).map_or(0.0, |r| r.1));
    let column = |axis: &str| words.fill("error {0} in {1}", &[&axis, &shown.unit]);
    let mut header = vec![words.say("set"), words.say("pose"), words.say("cycle"), words.say("target")];
    header.extend(["x", "y", "z"].map(|axis| words.fill("{0} in {1}", &[&axis, &"mm"])));
    header.extend(["x", "y", "z"].map(column));
    let row = |p: &&PointError| {
        let mut row = vec![words.say(&p.set), p.pose.to_string(), p.cycle.to_string(), p.target.clone()];
        row.extend(p.at_mm.map(|v| number::fixed(v, 3)));
        row.extend(p.after_mm.map(|v| number::fixed(v * shown.factor, if shown.factor > 1.0 { 2 } else { 4 })));
        row
    };
    (words.fill("Numbers of the {0} arrows", &[&drawn.len()]), header, drawn.iter().map(row).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::demo::point;

    #[test]
    fn arrows_are_enlarged_by_a_round_factor_that_is_stated() {
        let errors = [
            point(1, [0.0; 3], [0.1; 3], [0.003, 0.0, 0.0]),
            point(2, [100.0, 50.0, 0.0], [0.1; 3], [0.0, 0.006, 0.0]),
        ];
        let errors: Vec<_> = errors.iter().collect();
        let [before, after] = &arrows(&errors, true, &Words::default())[..] else { panic!() };
        // 16 % of 100 mm over 6 µm is 2667, over 141 µm 113
        assert!(after.caption.starts_with("Arrows enlarged 2000 times; the longest is 6.00 µm."));
        assert!(before.caption.starts_with("Arrows enlarged 100 times; the longest is 141 µm."), "{}", before.caption);
        assert!(after.svg.contains(">5 µm</text>"));
        assert_eq!((after.rows.len(), before.rows.len()), (2, 0));
        assert_eq!(after.rows[1][8], "6.00");
    }

    #[test]
    fn perfect_points_have_no_arrows() {
        let errors = [point(1, [0.0; 3], [0.0; 3], [0.0; 3])];
        let picture = &arrows(&errors.iter().collect::<Vec<_>>(), true, &Words::default())[1];
        assert!(!picture.svg.contains("<line class=\"arrow") && picture.caption.contains("longest is 0 µm"));
    }
}
