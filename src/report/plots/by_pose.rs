//! Errors by pose, before and after calibration in one figure.

use super::layer::*;
use std::collections::BTreeSet;

/// Ratio of the largest error before to the median error after, above which the axis is
/// logarithmic.
const RATIO: f64 = 20.0;
/// Number of decades below the largest error.
const DECADES: u8 = 6;

/// Figures of position or other lengths and, if measured, orientation; one quantity a figure.
pub(crate) fn pictures(errors: &[&PointError], limits: &[LimitVerdict], words: &Words) -> Vec<Figure> {
    let position = |p: &PointError| Some([points::before_mm(p), points::after_mm(p)]);
    let orientation = |p: &PointError| Some([p.before_deg?.abs(), p.after_deg?.abs()]);
    let lengths = points::by_quantity(errors).into_iter();
    let lengths = lengths.filter_map(|(quantity, errors)| picture(&errors, quantity, position, limits, words));
    lengths.chain(picture(errors, ErrorQuantity::Orientation, orientation, limits, words)).collect()
}

fn picture(
    errors: &[&PointError],
    quantity: ErrorQuantity,
    sizes: impl Fn(&PointError) -> Option<[f64; 2]>,
    limits: &[LimitVerdict],
    words: &Words,
) -> Option<Figure> {
    let finite = |p: &PointError| sizes(p).filter(|s| s.iter().all(|v| v.is_finite()));
    let all: Vec<_> = errors.iter().copied().filter(|p| finite(p).is_some()).collect();
    // each error has a mark before and after
    let drawn = points::thin(&points::readable(&all), points::MARKS / 2, points::after_mm);
    let pairs: Vec<_> = drawn.iter().filter_map(|p| Some((*p, finite(p)?))).collect();
    if pairs.is_empty() {
        return None;
    }
    let of = |k: usize| pairs.iter().map(move |(_, s)| s[k]);
    // a few tiny errors must not compress all others
    let ends = [crate::number::quantile(of(1), 0.02), largest(of(0).chain(of(1)))];
    let logarithmic = largest(of(0)) > RATIO * crate::number::quantile(of(1), 0.5) && ends[0] > 0.0;
    let is_angle = quantity == ErrorQuantity::Orientation;
    let unit = if is_angle { "deg" } else { "mm" };
    let axis = if logarithmic { Axis::decades(unit, ends, DECADES) } else { Axis::from_zero(unit, ends[1]) };
    let (low, unit) = (axis.ends().0, axis.display_unit().unit);
    let of_quantity = || tr!(words, "error-by-pose", quantity = words.tr(&quantity.phrase()));
    let (title, name) = match quantity {
        ErrorQuantity::Orientation => {
            (tr!(words, "orientation-error-by-pose"), tr!(words, "orientation-error-in", unit))
        }
        ErrorQuantity::Position => (tr!(words, "position-error-by-pose"), tr!(words, "position-error-in", unit)),
        _ => (of_quantity(), tr!(words, "error-in-unit", unit)),
    };
    let poses = poses(&drawn);
    let mut chart = Chart::new(words, WIDE, [across(&poses), axis], [tr!(words, "pose"), name]);
    let before = |look: Look<'static>| Look { class: "before", ..look };
    for (k, (p, s)) in [0, 1].into_iter().flat_map(|k| pairs.iter().map(move |pair| (k, pair))) {
        let look = if k == 0 { before(points::look(p)) } else { points::look(p) };
        chart.svg.mark(look, chart.at(place(&poses, p), s[k]), 2.8, &points::tooltip(p, words));
    }
    for (look, name) in points::sets(&drawn) {
        chart.svg.legend(before(look), &tr!(words, "before-named", name = words.tr(&name)));
    }
    for (look, name) in points::sets(&drawn) {
        chart.svg.legend(look, &tr!(words, "after-named", name = words.tr(&name)));
    }
    chart.limit(limits, quantity, false, words);
    let (description, rule) = match logarithmic {
        true => (tr!(words, "errors-by-pose-logarithmic", unit), tr!(words, "error-axis-logarithmic", factor = RATIO)),
        false => (tr!(words, "errors-by-pose-linear", unit), tr!(words, "error-axis-linear", factor = RATIO)),
    };
    let lower = match of(0).chain(of(1)).filter(|v| *v < low).count() {
        0 => String::new(),
        n => format!(" {}", tr!(words, "errors-below-axis", count = n)),
    };
    let caption = rule + &lower + &points::how_many(drawn.len(), all.len(), words);
    Some(Figure { caption, ..chart.figure(&format!("by-pose-{quantity}"), title, description) })
}

/// Poses of the points, in order.
pub(super) fn poses(points: &[&PointError]) -> Vec<PoseName> {
    points.iter().map(|p| p.pose).collect::<BTreeSet<_>>().into_iter().collect()
}

/// Column of a point's pose.
pub(super) fn place(poses: &[PoseName], p: &PointError) -> f64 {
    poses.binary_search(&p.pose).unwrap_or(0) as f64
}

/// Axis with a column for each pose.
pub(super) fn across(poses: &[PoseName]) -> Axis {
    Axis::rows(poses.len(), pose_ticks(poses), 0.7)
}

/// Labels of the poses: all of a few; round numbers of many, where a missing pose is labelled
/// between its neighbours.
fn pose_ticks(poses: &[PoseName]) -> Vec<(f64, String)> {
    let numbers: Vec<i64> = poses.iter().filter_map(|pose| pose.number()).collect();
    if poses.len() <= 15 || numbers.len() < poses.len() {
        let stride = if poses.len() <= 15 { 1 } else { poses.len().div_ceil(8) };
        return poses.iter().enumerate().step_by(stride).map(|(i, pose)| (i as f64, pose.to_string())).collect();
    }
    let (first, last) = (numbers[0], numbers[numbers.len() - 1]);
    let stride = (super::axis::step((last - first) as f64, 12) as i64).max(1);
    let round = (first.div_euclid(stride) * stride..=last).step_by(stride as usize).filter(|n| *n >= first);
    let place = |n: i64| {
        let at = numbers.partition_point(|m| *m < n);
        let missing = |m: i64, before: i64| (m - n) as f64 / (m - before) as f64;
        at as f64 - if at > 0 { missing(numbers[at], numbers[at - 1]) } else { 0.0 }
    };
    round.map(|n| (place(n), n.to_string())).collect()
}

#[cfg(test)]
mod tests {
    use super::super::svg::numbers;
    use super::*;
    use crate::tests::demo::point;

    fn drawn(errors: &[PointError], limits: &[LimitVerdict]) -> Vec<Figure> {
        pictures(&errors.iter().collect::<Vec<_>>(), limits, &Words::default())
    }

    #[test]
    fn the_axis_follows_its_stated_rule() {
        let caption = |before: f64| {
            let errors: Vec<_> = (0..9).map(|i| point(i, [0.0; 3], [before, 0.0, 0.0], [0.01, 0.0, 0.0])).collect();
            drawn(&errors, &[])[0].caption.clone()
        };
        let linear = tr!(Words::default(), "error-axis-linear", factor = 20);
        assert!(caption(0.19).starts_with(&linear));
        assert!(caption(0.21).starts_with(&tr!(Words::default(), "error-axis-logarithmic", factor = 20)));
        assert!(caption(0.0).starts_with(&linear));
    }

    #[test]
    fn errors_below_the_axis_are_counted() {
        let mut errors: Vec<_> = (0..99).map(|i| point(i, [0.0; 3], [0.5, 0.0, 0.0], [0.01, 0.0, 0.0])).collect();
        let below = tr!(Words::default(), "errors-below-axis", count = 1);
        assert!(!drawn(&errors, &[])[0].caption.contains(&below));
        errors[7].after_mm = [1e-9, 0.0, 0.0];
        assert!(drawn(&errors, &[])[0].caption.contains(&below));
    }

    #[test]
    fn the_name_of_the_axis_stays_clear_of_the_widest_label() {
        let mut errors: Vec<_> = (0..9).map(|i| point(i, [0.0; 3], [0.5; 3], [0.01; 3])).collect();
        for p in &mut errors {
            (p.before_deg, p.after_deg) = (Some(0.02), Some(0.000_13));
        }
        let svg = &drawn(&errors, &[])[1].svg;
        let labels = svg.lines().filter(|l| l.contains("class=\"end\"") && l.contains(">0.0001<"));
        let right: Vec<f64> = labels.flat_map(|l| numbers(l, "text", "x")).collect();
        // the name is centred at 13 and 12 high; six characters are about 42 wide
        assert!(!right.is_empty() && right.iter().all(|x| x - 42.0 > 20.0), "{right:?}");
    }

    #[test]
    fn round_numbers_are_ticks_also_where_their_pose_is_missing() {
        let poses: Vec<PoseName> = (1..=1000).filter(|n| ![400, 700, 1000].contains(n)).map(PoseName::from).collect();
        let ticks = pose_ticks(&poses);
        let labels: Vec<&str> = ticks.iter().map(|(_, label)| label.as_str()).collect();
        assert_eq!(labels, ["100", "200", "300", "400", "500", "600", "700", "800", "900"]);
        // between poses 399 and 401, which are number 399 and 400
        assert_eq!(ticks[3].0, 398.5);
    }

    #[test]
    fn a_limit_is_a_line_with_its_name() {
        let errors: Vec<_> = (0..9).map(|i| point(i, [0.0; 3], [0.15; 3], [0.1; 3])).collect();
        let limit =
            LimitVerdict::judge(etalon_documents::LimitQuantity::PositionMaxMm, 0.2, 0.17, None, Default::default());
        let svg = &drawn(&errors, std::slice::from_ref(&limit))[0].svg;
        assert!(svg.contains("class=\"limit\"") && svg.contains(">limit: largest position error 200 µm</text>"));
        // below the axis and its name, where there are no marks
        let [name, pose] = [">limit: largest position error 200 µm<", ">pose<"]
            .map(|text| svg.lines().find(|l| l.contains(text)).unwrap());
        let [name, pose] = [name, pose].map(|line| numbers(line, "text", "y")[0]);
        assert!(name > pose, "{svg}");
        let far = LimitVerdict { limit: 20.0, ..limit };
        assert!(!drawn(&errors, &[far])[0].svg.contains("class=\"limit\""));
    }

    #[test]
    fn orientation_is_drawn_where_there_is_one() {
        let mut errors = vec![point(1, [0.0; 3], [0.1; 3], [0.01; 3]); 3];
        assert_eq!(drawn(&errors, &[]).len(), 1);
        (errors[0].before_deg, errors[0].after_deg) = (Some(-0.1), Some(0.01));
        (errors[1].before_deg, errors[1].after_deg) = (Some(f64::NAN), Some(0.01));
        let both = drawn(&errors, &[]);
        assert_eq!((both.len(), both[1].svg.matches("pose 1, ").count()), (2, 2));
        assert!(both[1].svg.contains("; 0.100 → 0.010 deg"));
    }
}
