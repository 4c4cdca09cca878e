//! What calibration leaves: every component by pose, and those of the calibration poses against a normal distribution.

use super::axis::{Axis, range};
use super::by_pose::{self, BOTTOM, HEIGHT, RIGHT, TOP, WIDTH};
use super::points;
use super::svg::{COLOURS, SHAPES, Shape, Svg};
use crate::model::Figure;
use crate::number::{self, Shown};
use crate::words::Words;
use etalon_base::pose_name::PoseName;
use etalon_documents::PointError;
use statrs::distribution::{ContinuousCDF, Normal};
use std::collections::BTreeSet;

const AXES: [&str; 3] = ["x", "y", "z"];
/// More marks than this hide each other.
const LIMIT: usize = 300;
/// Fewer residuals say nothing of their distribution.
const FEWEST: usize = 10;

/// By pose, and against the normal distribution.
pub(crate) fn pictures(errors: &[&PointError], planar: bool, words: &Words) -> Vec<Figure> {
    let axes = if planar { 2 } else { 3 };
    let largest = range(errors.iter().flat_map(|p| &p.after_mm[..axes]).map(|v| v.abs())).map_or(0.0, |r| r.1);
    if largest <= 0.0 {
        return vec![];
    }
    let shown = number::shown("mm", largest);
    let reach = Axis::from_zero(largest * shown.factor, 0.0, 1.0).high();
    [Some(by_poses(errors, axes, shown, reach, words)), quantiles(errors, axes, shown, reach, words)]
        .into_iter()
        .flatten()
        .collect()
}

fn by_poses(errors: &[&PointError], axes: usize, shown: Shown, reach: f64, words: &Words) -> Figure {
    let drawn = points::readable(errors);
    let title = words.say("Residuals by pose after calibration");
    let name = words.fill("measured minus predicted in {0}", &[&shown.unit]);
    let description = words.say("One mark for each pose, cycle, target and axis.");
    let mut svg = Svg::new("residuals", WIDTH, HEIGHT, &title, &description);
    let poses: Vec<PoseName> = drawn.iter().map(|p| p.pose).collect::<BTreeSet<_>>().into_iter().collect();
    let up = Axis::linear(-reach, reach, BOTTOM, TOP);
    let left = super::axis::left_margin(&up.ticks(6));
    let across = Axis::linear(-0.7, poses.len() as f64 - 0.3, left, WIDTH - RIGHT);
    by_pose::draw_axes(&mut svg, left, (&across, &up), &poses, [&name, &words.say("pose")]);
    svg.line("axis", (left, up.at(0.0)), (WIDTH - RIGHT, up.at(0.0)));
    for (axis, shape) in SHAPES.into_iter().enumerate().take(axes) {
        // beside each other
        let aside = 0.22 * (axis as f64 - 0.5 * (axes - 1) as f64);
        for p in &drawn {
            let place = poses.binary_search(&p.pose).unwrap_or(0) as f64 + aside;
            let at = (across.at(place), up.at(p.after_mm[axis] * shown.factor));
            svg.mark(shape, "map", at, 2.6, COLOURS[axis], &points::tooltip(p, words));
        }
        let x = left + 8.0 + 60.0 * axis as f64;
        svg.mark(shape, "map", (x, 16.0), 4.0, COLOURS[axis], "");
        svg.text("start", (x + 10.0, 20.0), AXES[axis]);
    }
    let note = words.say("What follows a pattern is not noise: the model lacks something.");
    Figure {
        title,
        svg: svg.finish(),
        caption: note + &points::how_many(drawn.len(), errors.len(), words),
        wide: true,
        ..Figure::default()
    }
}

/// Sorted residuals over the quantiles of a normal distribution: on a line where they are noise.
fn quantiles(errors: &[&PointError], axes: usize, shown: Shown, reach: f64, words: &Words) -> Option<Figure> {
    const WIDTH: f64 = 380.0;
    let calibration = errors.iter().filter(|p| !points::is_validation(p));
    let mut all: Vec<(&PointError, usize)> = calibration.flat_map(|p| (0..axes).map(move |axis| (*p, axis))).collect();
    let value = |(p, axis): &(&PointError, usize)| p.after_mm[*axis] * shown.factor;
    all.sort_by(|a, b| value(a).total_cmp(&value(b)));
    let (count, normal) = (all.len(), Normal::new(0.0, 1.0).ok()?);
    if count < FEWEST {
        return None;
    }
    let mean = all.iter().map(value).sum::<f64>() / count as f64;
    let deviation = (all.iter().map(|r| (value(r) - mean).powi(2)).sum::<f64>() / (count - 1) as f64).sqrt();
    // plotting positions of Blom (1958)
    let quantile = |i: usize| normal.inverse_cdf((i as f64 + 0.625) / (count as f64 + 0.25));
    let title = words.say("Residuals of the calibration poses against a normal distribution");
    let description =
        words.say("Sorted residuals over the quantiles of a normal distribution; the line is that of noise.");
    let mut svg = Svg::new("quantiles", WIDTH, HEIGHT, &title, &description);
    let (up, widest) = (Axis::linear(-reach, reach, BOTTOM, TOP), Axis::from_zero(-quantile(0), 0.0, 1.0).high());
    let left = super::axis::left_margin(&up.ticks(6));
    let across = Axis::linear(-widest, widest, left, WIDTH - RIGHT);
    for (value, label) in up.ticks(6) {
        svg.line("grid", (left, up.at(value)), (WIDTH - RIGHT, up.at(value)));
        svg.text("end", (left - 6.0, up.at(value) + 4.0), &label);
    }
    for (value, label) in across.ticks(6) {
        svg.line("axis", (across.at(value), BOTTOM), (across.at(value), BOTTOM + 4.0));
        svg.text("mid", (across.at(value), BOTTOM + 17.0), &label);
    }
    svg.line("axis", (left, BOTTOM), (WIDTH - RIGHT, BOTTOM));
    svg.line("axis", (left, TOP), (left, BOTTOM));
    svg.text("mid", ((left + WIDTH - RIGHT) / 2.0, BOTTOM + 36.0), &words.say("quantile of the normal distribution"));
    let name = words.fill("measured minus predicted in {0}", &[&shown.unit]);
    svg.text_upwards((14.0, (TOP + BOTTOM) / 2.0), &name);
    let on_line = |q: f64| (across.at(q), up.at((mean + deviation * q).clamp(-reach, reach)));
    // cut where it leaves the picture
    let end = |q: f64| if deviation > 0.0 { q.signum() * q.abs().min((reach - mean.abs()) / deviation) } else { q };
    svg.line("knee", on_line(end(-widest)), on_line(end(widest)));
    let stride = count.div_ceil(LIMIT);
    for (i, r) in all.iter().enumerate().filter(|(i, _)| i % stride == 0 || *i + 1 == count) {
        let at = (across.at(quantile(i)), up.at(value(r)));
        svg.mark(Shape::Circle, "cal", at, 2.4, "", &points::tooltip(r.0, words));
    }
    let decimals = number::decimals(deviation, 2).unwrap_or(0);
    let [mean, deviation] = [mean, deviation].map(|v| format!("{} {}", number::fixed(v, decimals), shown.unit));
    Some(Figure {
        title,
        svg: svg.finish(),
        caption: words.fill(
            "{0} residuals, mean {1}, standard deviation {2}; the line is that of noise alone.",
            &[&count, &mean, &deviation],
        ),
        ..Figure::default()
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::demo::point;

    fn places(svg: &str, class: &str) -> Vec<(f64, f64)> {
        let number = |mark: &str, name: &str| mark.split(name).nth(1)?.split('"').next()?.parse().ok();
        let mark = format!("<circle class=\"{class}\"");
        svg.lines()
            .filter(|l| l.starts_with(&mark))
            .filter_map(|l| Some((number(l, " cx=\"")?, number(l, " cy=\"")?)))
            .collect()
    }

    #[test]
    fn normal_residuals_lie_on_the_line_and_a_blunder_does_not() {
        let normal = Normal::new(0.0, 1.0).unwrap();
        let drawn = |i: i64| 0.003 * normal.inverse_cdf((i as f64 + 0.625) / 40.25);
        let mut errors: Vec<_> =
            (0..20).map(|i| point(i, [0.0; 3], [0.1; 3], [drawn(2 * i), drawn(2 * i + 1), 0.0])).collect();
        let off = |errors: &[PointError]| {
            let all: Vec<_> = errors.iter().collect();
            let svg = pictures(&all, true, &Words::default()).remove(1).svg;
            let line = svg.lines().find(|l| l.contains("class=\"knee\"")).unwrap();
            let end = |name: &str| line.split(name).nth(1).unwrap().split('"').next().unwrap().parse::<f64>().unwrap();
            let slope = (end(" y2=\"") - end(" y1=\"")) / (end(" x2=\"") - end(" x1=\""));
            let below = |(x, y): (f64, f64)| (end(" y1=\"") + slope * (x - end(" x1=\"")) - y).abs();
            places(&svg, "cal").into_iter().map(below).fold(0.0, f64::max)
        };
        assert!(off(&errors) < 4.0, "{}", off(&errors));
        errors[7].after_mm[0] = 0.03;
        assert!(off(&errors) > 40.0, "{}", off(&errors));
    }

    #[test]
    fn signs_are_kept_and_nothing_to_draw_draws_nothing() {
        let errors =
            [point(1, [0.0; 3], [0.1; 3], [0.004, 0.0, 0.0]), point(2, [0.0; 3], [0.1; 3], [-0.004, 0.0, 0.0])];
        let pictures = pictures(&errors.iter().collect::<Vec<_>>(), true, &Words::default());
        assert_eq!(pictures.len(), 1);
        assert!(pictures[0].svg.contains("(x 4.0, ") && pictures[0].svg.contains("(x -4.0, "));
        assert!(super::pictures(&[], true, &Words::default()).is_empty());
    }
}
