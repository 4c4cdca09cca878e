//! The errors as the pictures need them: what can be drawn, how much of it, and what a pointer reads off a mark.

use super::svg::Shape;
use crate::base::pose::norm;
use crate::document::PointError;
use crate::report::number::{self, Shown};
use crate::report::words::{Words, isolated};
use std::fmt::Display;

/// Places and errors beyond this are blunders that no picture can show, mm.
const DRAWABLE_MM: f64 = 1e7;

/// The errors that can be drawn, in their order.
pub(in crate::report) fn drawable(errors: &[PointError]) -> Vec<&PointError> {
    let small = |v: &f64| v.abs() < DRAWABLE_MM;
    let whole = |p: &&PointError| [p.at_mm, p.before_mm, p.after_mm].iter().flatten().all(small);
    errors.iter().filter(whole).collect()
}

/// Whether the points lie in a plane, as those of a planar robot do.
pub(in crate::report) fn planar(points: &[&PointError], world: bool) -> bool {
    let flat = |p: &&PointError| p.at_mm[2] == 0.0 && p.before_mm[2] == 0.0 && p.after_mm[2] == 0.0;
    world || points.iter().all(flat)
}

/// At most about `limit` points, evenly chosen; the largest is always among them.
pub(in crate::report) fn thin<'a>(
    points: &[&'a PointError],
    limit: usize,
    size: impl Fn(&PointError) -> f64,
) -> Vec<&'a PointError> {
    let stride = points.len().div_ceil(limit.max(1)).max(1);
    let largest = (0..points.len()).max_by(|&a, &b| size(points[a]).total_cmp(&size(points[b])));
    let chosen = |i: &usize| i.is_multiple_of(stride) || Some(*i) == largest;
    (0..points.len()).filter(chosen).map(|i| points[i]).collect()
}

/// A sentence on how many of the points are drawn; empty where all are.
pub(in crate::report) fn how_many(drawn: usize, all: usize, words: &Words) -> String {
    match drawn < all {
        true => {
            format!(
                " {}",
                words.fill("{0} of {1} points are drawn, evenly chosen, the largest among them.", &[&drawn, &all])
            )
        }
        false => String::new(),
    }
}

/// Size of the position error before.
pub(in crate::report) fn before_mm(p: &PointError) -> f64 {
    norm(p.before_mm)
}

/// Size of the position error after.
pub(in crate::report) fn after_mm(p: &PointError) -> f64 {
    norm(p.after_mm)
}

/// Validation poses are diamonds.
pub(in crate::report) fn is_validation(p: &PointError) -> bool {
    p.set == "validation"
}

/// Form of the mark of a point.
pub(in crate::report) fn shape(p: &PointError) -> Shape {
    if is_validation(p) { Shape::Diamond } else { Shape::Circle }
}

/// Style of the mark of a point.
pub(in crate::report) fn class(p: &PointError) -> &'static str {
    if is_validation(p) { "val" } else { "cal" }
}

/// Form and style of each set that occurs, for legends.
pub(in crate::report) fn sets(points: &[&PointError]) -> Vec<(Shape, &'static str, &'static str)> {
    let all = [(false, Shape::Circle, "cal", "calibration"), (true, Shape::Diamond, "val", "validation")];
    let occurs = |validation: bool| points.iter().any(|p| is_validation(p) == validation);
    all.into_iter().filter(|s| occurs(s.0)).map(|(_, shape, class, name)| (shape, class, name)).collect()
}

/// Which point, and its error before and after; the target's name is isolated from its surroundings (right-to-left).
pub(in crate::report) fn tooltip(p: &PointError, before: f64, after: f64, shown: Shown, words: &Words) -> String {
    let value = |v: f64| format!("{} {}", number::significant(v * shown.factor, 3), shown.unit);
    let target = isolated(&p.target);
    let set = words.say(if is_validation(p) { "validation" } else { "calibration" });
    let values: [&dyn Display; 6] = [&p.pose, &p.cycle, &target, &set, &value(before), &value(after)];
    words.fill("pose {0}, cycle {1}, {2} ({3}): {4} before, {5} after", &values)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::tests::demo::point;

    #[test]
    fn thinning_keeps_the_largest_and_no_more_than_asked() {
        let mut errors: Vec<_> = (0..1000).map(|i| point(i, [i as f64, 0.0, 0.0], [0.1; 3], [0.01; 3])).collect();
        errors[777].after_mm = [1.0; 3];
        let all: Vec<_> = errors.iter().collect();
        let few = thin(&all, 300, after_mm);
        assert!(few.len() <= 301 && few.iter().any(|p| p.pose == 777), "{}", few.len());
        assert_eq!(thin(&all, 1000, after_mm).len(), 1000);
        assert_eq!(thin(&[], 10, after_mm).len(), 0);
        let words = Words::default();
        assert_eq!((how_many(3, 3, &words), how_many(2, 3, &words).is_empty()), (String::new(), false));
    }

    #[test]
    fn what_is_not_a_number_is_not_drawn() {
        let fine = point(1, [0.0; 3], [0.1; 3], [0.01; 3]);
        let mut errors = vec![fine.clone(), fine.clone(), fine.clone(), fine];
        errors[0].at_mm[2] = f64::NAN;
        errors[1].before_mm[0] = f64::INFINITY;
        errors[2].after_mm[1] = 1e300;
        assert_eq!(drawable(&errors).len(), 1);
    }
}
