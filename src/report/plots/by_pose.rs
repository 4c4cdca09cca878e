//! Error by pose, before and after in one picture.

use super::axis::{Axis, left_margin, range};
use super::limit_lines::LimitLines;
use super::points;
use super::svg::{Shape, Svg};
use crate::model::Figure;
use crate::number;
use crate::words::Words;
use etalon_base::pose_name::PoseName;
use etalon_documents::{LimitVerdict, PointError};
use std::collections::BTreeSet;

pub(crate) const WIDTH: f64 = 760.0;
pub(crate) const HEIGHT: f64 = 340.0;
/// room for half of the last label
pub(crate) const RIGHT: f64 = 22.0;
pub(crate) const TOP: f64 = 36.0;
pub(crate) const BOTTOM: f64 = 296.0;
const TICKS: usize = 5;
/// The axis is logarithmic where the largest error before is more than this many times the median after.
const RATIO: f64 = 20.0;

/// Position and, where there is one, orientation.
pub(crate) fn pictures(errors: &[&PointError], limits: &[LimitVerdict], words: &Words) -> Vec<Figure> {
    let position = |p: &PointError| Some((points::before_mm(p), points::after_mm(p)));
    let orientation = |p: &PointError| Some((p.before_deg?.abs(), p.after_deg?.abs()));
    let all = [
        picture(errors, "position", "mm", position, limits, words),
        picture(errors, "orientation", "deg", orientation, limits, words),
    ];
    all.into_iter().flatten().collect()
}

fn picture(
    errors: &[&PointError],
    quantity: &str,
    unit: &str,
    value: impl Fn(&PointError) -> Option<(f64, f64)>,
    limits: &[LimitVerdict],
    words: &Words,
) -> Option<Figure> {
    let sizes = |p: &PointError| value(p).filter(|(before, after)| before.is_finite() && after.is_finite());
    let all: Vec<_> = errors.iter().copied().filter(|p| sizes(p).is_some()).collect();
    let drawn = points::readable(&all);
    let pairs: Vec<_> = drawn.iter().filter_map(|p| sizes(p).map(|s| (*p, s))).collect();
    if pairs.is_empty() {
        return None;
    }
    let largest = range(pairs.iter().flat_map(|(_, s)| [s.0, s.1])).map_or(0.0, |r| r.1);
    let shown = number::shown(unit, largest);
    // a few errors that happen to be nearly zero must not squeeze all others
    let smallest = number::quantile(pairs.iter().map(|(_, s)| s.1), 0.02);
    let largest_before = range(pairs.iter().map(|(_, s)| s.0)).map_or(0.0, |r| r.1);
    let logarithmic = largest_before > RATIO * number::quantile(pairs.iter().map(|(_, s)| s.1), 0.5) && smallest > 0.0;
    let axis = match logarithmic {
        true => Axis::logarithmic(smallest * shown.factor, largest * shown.factor, BOTTOM, TOP),
        false => Axis::from_zero(largest * shown.factor, BOTTOM, TOP),
    };
    let (title, name) = match quantity {
        "orientation" => (
            words.say("Orientation error by pose, before and after calibration"),
            words.fill("orientation error in {0}", &[&shown.unit]),
        ),
        _ => (
            words.say("Position error by pose, before and after calibration"),
            words.fill("position error in {0}", &[&shown.unit]),
        ),
    };
    let description = match logarithmic {
        true => words.fill("One mark for each pose, cycle and target; logarithmic axis in {0}.", &[&shown.unit]),
        false => words.fill("One mark for each pose, cycle and target; linear axis in {0}.", &[&shown.unit]),
    };
    let on_axis =
        |v: f64| Some(v * shown.factor).filter(|v| (axis.low()..=axis.high()).contains(v)).map(|v| axis.at(v));
    let limits = LimitLines::new(&points::limits_of(limits, quantity), on_axis);
    let height = HEIGHT + limits.height(WIDTH);
    let mut svg = Svg::new(&format!("by-pose-{quantity}"), WIDTH, height, &title, &description);
    let poses: Vec<PoseName> = pairs.iter().map(|(p, _)| p.pose).collect::<BTreeSet<_>>().into_iter().collect();
    let left = left_margin(&axis.ticks(TICKS));
    let across = Axis::linear(-0.7, poses.len() as f64 - 0.3, left, WIDTH - RIGHT);
    draw_axes(&mut svg, left, (&across, &axis), &poses, [&name, &words.say("pose")]);
    limits.level(&mut svg, (left, WIDTH - RIGHT));
    limits.legend(&mut svg, HEIGHT, WIDTH);
    for after in [false, true] {
        for (p, s) in &pairs {
            let place = poses.binary_search(&p.pose).unwrap_or(0) as f64;
            let size = if after { s.1 } else { s.0 };
            let class = if after { points::class(p) } else { "before" };
            let at = (across.at(place), axis.at(size * shown.factor));
            svg.mark(points::shape(p), class, at, 2.8, "", &points::tooltip(p, words));
        }
    }
    legend(&mut svg, left, &drawn, words);
    let rule = match logarithmic {
        true => words.fill(
            "The error axis is logarithmic: the largest error before is more than {0} times the median after.",
            &[&RATIO],
        ),
        false => words.fill(
            "The error axis is linear: the largest error before is no more than {0} times the median after.",
            &[&RATIO],
        ),
    };
    let low = axis.low() / shown.factor;
    let lower = match pairs.iter().flat_map(|(_, s)| [s.0, s.1]).filter(|&v| v < low).count() {
        0 => String::new(),
        1 => format!(" {}", words.say("1 smaller error is drawn at the lower edge.")),
        n => format!(" {}", words.fill("{0} smaller errors are drawn at the lower edge.", &[&n])),
    };
    let caption = rule + &lower + &points::how_many(drawn.len(), all.len(), words);
    Some(Figure { title, svg: svg.finish(), caption, wide: true, ..Figure::default() })
}

/// An upright axis with its name, and the numbers of the poses along the other.
pub(crate) fn draw_axes(
    svg: &mut Svg,
    left: f64,
    (across, axis): (&Axis, &Axis),
    poses: &[PoseName],
    [up, along]: [&str; 2],
) {
    for (value, label) in axis.ticks(TICKS) {
        let y = axis.at(value);
        svg.line("grid", (left, y), (WIDTH - RIGHT, y));
        svg.text("end", (left - 6.0, y + 4.0), &label);
    }
    for (place, label) in pose_ticks(poses) {
        let x = across.at(place);
        svg.line("axis", (x, BOTTOM), (x, BOTTOM + 4.0));
        svg.text("mid", (x, BOTTOM + 17.0), &label);
    }
    svg.line("axis", (left, BOTTOM), (WIDTH - RIGHT, BOTTOM));
    svg.line("axis", (left, TOP), (left, BOTTOM));
    svg.text("mid", ((left + WIDTH - RIGHT) / 2.0, BOTTOM + 36.0), along);
    svg.text_upwards((14.0, (TOP + BOTTOM) / 2.0), up);
}

/// Labels along the poses: every one of few; of many round numbers, a number that is left out between its neighbours.
fn pose_ticks(poses: &[PoseName]) -> Vec<(f64, String)> {
    let numbers: Vec<i64> = poses.iter().filter_map(|pose| pose.number()).collect();
    let all = poses.iter().enumerate().map(|(i, pose)| (i as f64, pose.to_string()));
    if poses.len() <= 15 {
        return all.collect();
    }
    let (Some(first), Some(last)) = (numbers.first(), numbers.last()) else {
        return all.step_by(poses.len().div_ceil(8)).collect();
    };
    if numbers.len() < poses.len() {
        return all.step_by(poses.len().div_ceil(8)).collect();
    }
    let stride = (super::axis::step((last - first) as f64, 12) as i64).max(1);
    let round = (first.div_euclid(stride) * stride..=*last).step_by(stride as usize).filter(|n| n >= first);
    let place = |n: i64| {
        let at = numbers.partition_point(|m| *m < n);
        match numbers.get(at) {
            Some(m) if *m > n && at > 0 => {
                let before = numbers[at - 1];
                at as f64 - (m - n) as f64 / (m - before) as f64
            }
            _ => at as f64,
        }
    };
    round.map(|n| (place(n), n.to_string())).collect()
}

fn legend(svg: &mut Svg, left: f64, drawn: &[&PointError], words: &Words) {
    let sets = points::sets(drawn);
    let before = sets.iter().map(|&(shape, _, name)| (shape, "before", words.fill("{0}, before", &[&words.say(name)])));
    let after = sets.iter().map(|&(shape, class, name)| (shape, class, words.fill("{0}, after", &[&words.say(name)])));
    let entries: Vec<(Shape, &str, String)> = before.chain(after).collect();
    for (i, (shape, class, name)) in entries.iter().enumerate() {
        let x = left + 8.0 + 160.0 * i as f64;
        svg.mark(*shape, class, (x, 16.0), 4.0, "", "");
        svg.text("start", (x + 10.0, 20.0), name);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::demo::point;

    #[test]
    fn the_axis_follows_its_stated_rule() {
        let caption = |before: f64| {
            let errors: Vec<_> = (0..9).map(|i| point(i, [0.0; 3], [before, 0.0, 0.0], [0.01, 0.0, 0.0])).collect();
            pictures(&errors.iter().collect::<Vec<_>>(), &[], &Words::default())[0].caption.clone()
        };
        assert!(caption(0.19).starts_with("The error axis is linear: the largest error before is no more than 20"));
        assert!(caption(0.21).starts_with("The error axis is logarithmic: the largest error before is more than 20"));
        assert!(caption(0.0).contains("linear"));
    }

    #[test]
    fn errors_below_the_axis_are_counted() {
        let mut errors: Vec<_> = (0..99).map(|i| point(i, [0.0; 3], [0.5, 0.0, 0.0], [0.01, 0.0, 0.0])).collect();
        assert!(
            !pictures(&errors.iter().collect::<Vec<_>>(), &[], &Words::default())[0].caption.contains("lower edge")
        );
        errors[7].after_mm = [1e-9, 0.0, 0.0];
        assert!(
            pictures(&errors.iter().collect::<Vec<_>>(), &[], &Words::default())[0]
                .caption
                .contains(" 1 smaller error is drawn")
        );
    }

    #[test]
    fn the_name_of_the_axis_stays_clear_of_the_widest_label() {
        let mut errors: Vec<_> = (0..9).map(|i| point(i, [0.0; 3], [0.5; 3], [0.01; 3])).collect();
        for p in &mut errors {
            (p.before_deg, p.after_deg) = (Some(0.02), Some(0.000_13));
        }
        let svg = &pictures(&errors.iter().collect::<Vec<_>>(), &[], &Words::default())[1].svg;
        let labels = svg.lines().filter(|l| l.starts_with("<text class=\"end\"") && l.contains(">0.0001<"));
        let right: Vec<f64> = labels.filter_map(|l| l.split('"').nth(3)?.parse().ok()).collect();
        // the name is centred at 14 and 12 high, six characters are some 42 wide
        assert!(!right.is_empty() && right.iter().all(|x| x - 42.0 > 20.0), "{right:?}");
    }

    #[test]
    fn round_numbers_are_ticks_also_where_their_pose_is_missing() {
        let poses: Vec<PoseName> = (1..=1000).filter(|n| ![400, 700, 1000].contains(n)).map(PoseName::from).collect();
        let ticks = pose_ticks(&poses);
        let labels: Vec<&str> = ticks.iter().map(|(_, label)| label.as_str()).collect();
        assert_eq!(labels, ["100", "200", "300", "400", "500", "600", "700", "800", "900"]);
        // between poses 399 and 401, which are the 399th and 400th
        assert_eq!(ticks[3].0, 398.5);
    }

    #[test]
    fn a_limit_is_a_line_with_its_name() {
        let errors: Vec<_> = (0..9).map(|i| point(i, [0.0; 3], [0.15; 3], [0.1; 3])).collect();
        let limit = LimitVerdict::of("position_max_mm", "mm", 0.2, 0.17, None, Default::default());
        let all: Vec<_> = errors.iter().collect();
        let svg = &pictures(&all, std::slice::from_ref(&limit), &Words::default())[0].svg;
        assert!(svg.contains("class=\"limit\"") && svg.contains(">position_max_mm</text>"));
        // under the axis and its name, where there are no marks
        let name = svg.lines().find(|l| l.contains(">position_max_mm<")).unwrap();
        assert!(name.split('"').nth(5).unwrap().parse::<f64>().unwrap() > HEIGHT, "{name}");
        let far = LimitVerdict { limit: 20.0, ..limit };
        assert!(!pictures(&all, &[far], &Words::default())[0].svg.contains("class=\"limit\""));
    }

    #[test]
    fn orientation_is_drawn_where_there_is_one() {
        let mut errors = vec![point(1, [0.0; 3], [0.1; 3], [0.01; 3]); 3];
        assert_eq!(pictures(&errors.iter().collect::<Vec<_>>(), &[], &Words::default()).len(), 1);
        (errors[0].before_deg, errors[0].after_deg) = (Some(-0.1), Some(0.01));
        (errors[1].before_deg, errors[1].after_deg) = (Some(f64::NAN), Some(0.01));
        let both = pictures(&errors.iter().collect::<Vec<_>>(), &[], &Words::default());
        assert_eq!((both.len(), both[1].svg.matches("pose 1, ").count()), (2, 2));
        assert!(both[1].svg.contains("; 0.100 → 0.010 deg"));
    }
}
