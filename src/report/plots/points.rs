//! Errors of points in figures: selection of the drawn points, style and tooltips of their marks.

use super::layer::*;
use crate::words::isolated;
use etalon_base::catalogue::Phrase;
use std::collections::BTreeMap;

/// Maximum position or error that is drawn (mm); larger ones are blunders.
const DRAWABLE_MM: f64 = 1e7;

/// Errors that can be drawn, in order.
pub(crate) fn drawable(errors: &[PointError]) -> Vec<&PointError> {
    let small = |v: &f64| v.abs() < DRAWABLE_MM;
    let whole = |p: &&PointError| [p.at_mm, p.before_mm, p.after_mm].iter().flatten().all(small);
    errors.iter().filter(whole).collect()
}

/// `true` if the points are coplanar, as for a planar robot.
pub(crate) fn planar(points: &[&PointError], world: bool) -> bool {
    let flat = |p: &&PointError| p.at_mm[2] == 0.0 && p.before_mm[2] == 0.0 && p.after_mm[2] == 0.0;
    world || points.iter().all(flat)
}

/// Selects at most about `limit` points evenly, always including the largest error.
pub(crate) fn thin<'a>(
    points: &[&'a PointError],
    limit: usize,
    size: impl Fn(&PointError) -> f64,
) -> Vec<&'a PointError> {
    let stride = points.len().div_ceil(limit.max(1)).max(1);
    let largest = (0..points.len()).max_by(|&a, &b| size(points[a]).total_cmp(&size(points[b])));
    let chosen = |i: &usize| i.is_multiple_of(stride) || Some(*i) == largest;
    (0..points.len()).filter(chosen).map(|i| points[i]).collect()
}

/// Maximum number of marks in a figure; more are illegible and make a page slow.
pub(crate) const MARKS: usize = 380;

/// Selects points for legible figures: all points if there are few. Otherwise each pose is
/// represented by its largest error after calibration, with validation poses first and calibration
/// poses evenly selected. All figures use the same selection.
pub(crate) fn readable<'a>(points: &[&'a PointError]) -> Vec<&'a PointError> {
    if points.len() <= MARKS {
        return points.to_vec();
    }
    let mut largest: BTreeMap<(bool, PoseName), &PointError> = BTreeMap::new();
    for p in points {
        let of_pose = largest.entry((is_validation(p), p.pose)).or_insert(p);
        if after_mm(p) > after_mm(of_pose) {
            *of_pose = p;
        }
    }
    let (validation, calibration): (Vec<&PointError>, Vec<&PointError>) =
        largest.into_values().partition(|p| is_validation(p));
    let validation = thin(&validation, MARKS.saturating_sub(calibration.len().min(MARKS / 5)), after_mm);
    let calibration = thin(&calibration, MARKS.saturating_sub(validation.len()), after_mm);
    [calibration, validation].concat()
}

/// Sentence on the number of drawn points; empty if all are drawn.
pub(crate) fn how_many(drawn: usize, all: usize, words: &Words) -> String {
    if drawn == all {
        return String::new();
    }
    format!(" {}", tr!(words, "errors-of-poses-drawn", drawn, total = all))
}

/// Name of a figure before or after calibration.
pub(crate) fn side(after: bool) -> &'static str {
    if after { "after" } else { "before" }
}

/// Size of the position error before or after calibration.
pub(crate) fn size(after: bool) -> fn(&PointError) -> f64 {
    if after { after_mm } else { before_mm }
}

/// Size of the position error before calibration (mm).
pub(crate) fn before_mm(p: &PointError) -> f64 {
    norm(p.before_mm)
}

/// Size of the position error after calibration (mm).
pub(crate) fn after_mm(p: &PointError) -> f64 {
    norm(p.after_mm)
}

/// `true` for a point of a validation pose.
pub(crate) fn is_validation(p: &PointError) -> bool {
    p.set == PoseSet::Validation
}

/// Errors of each quantity that occurs.
pub(crate) fn by_quantity<'a>(points: &[&'a PointError]) -> Vec<(ErrorQuantity, Vec<&'a PointError>)> {
    let of = |q: ErrorQuantity| (q, points.iter().copied().filter(|p| p.quantity == q).collect::<Vec<_>>());
    let all = [ErrorQuantity::Position].into_iter().chain(ErrorQuantity::OTHERS).map(of);
    all.filter(|(_, points)| !points.is_empty()).collect()
}

/// Identifier of a figure of a quantity, from the identifier of the same figure of positions.
pub(crate) fn quantity_key(quantity: ErrorQuantity, key: &str) -> String {
    match quantity {
        ErrorQuantity::Position => key.to_owned(),
        _ => format!("{quantity}-{key}"),
    }
}

/// Style of the mark of a point.
pub(crate) fn look(p: &PointError) -> Look<'static> {
    pose_set_look(p.set)
}

fn pose_set_look(set: PoseSet) -> Look<'static> {
    match set {
        PoseSet::Calibration => CALIBRATION,
        PoseSet::Validation => VALIDATION,
    }
}

/// Style and name of each set that occurs.
pub(crate) fn sets(points: &[&PointError]) -> Vec<(Look<'static>, Phrase)> {
    let there = PoseSet::ALL.into_iter().filter(|set| points.iter().any(|p| p.set == *set));
    there.map(|set| (pose_set_look(set), set.phrase())).collect()
}

/// Adds the sets that occur to the legend.
pub(crate) fn legend(svg: &mut Svg, points: &[&PointError], words: &Words) {
    sets(points).into_iter().for_each(|(look, name)| svg.legend(look, &words.tr(&name)));
}

/// Name of a point with its errors before and after calibration. All figures share this text, so
/// that a page holds it once. The target's name is isolated from its surroundings (right-to-left
/// scripts).
pub(crate) fn tooltip(p: &PointError, words: &Words) -> String {
    // a common unit and number of decimals make all lengths comparable: two digits of the error
    // after
    let (before, after) = (before_mm(p), after_mm(p));
    let shown = number::display_unit("mm", before.max(after));
    let places = decimals(after * shown.factor, before * shown.factor);
    let length = |mm: f64| words.fixed(mm * shown.factor, places);
    let [x, y, z] = p.after_mm.map(length);
    let [before, after] = [before, after].map(|mm| format!("{} {}", length(mm), shown.unit));
    let target = isolated(&p.target);
    let set = words.tr(&p.set.phrase());
    let text = tr!(words, "error-tooltip", pose = p.pose, cycle = p.cycle, target, set, before, after);
    let angle = |deg: Option<f64>| deg.filter(|d| d.is_finite()).map(f64::abs);
    let turned = match (angle(p.before_deg), angle(p.after_deg)) {
        (Some(before), Some(after)) => {
            let places = decimals(after, before);
            format!("; {} → {} deg", words.fixed(before, places), words.fixed(after, places))
        }
        _ => String::new(),
    };
    text + &format!(" (x {x}, y {y}, z {z} {}){turned}", shown.unit)
}

/// Number of decimals (at most five) that show two significant digits of the error after
/// calibration, or of the error before if it is zero.
fn decimals(after: f64, before: f64) -> usize {
    let of = |v: f64| if v > 0.0 { number::decimals(v, 2) } else { None };
    of(after).or_else(|| of(before)).unwrap_or(0).clamp(0, 5)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::demo::point;

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
    fn every_validation_pose_has_a_mark_and_the_largest_error_of_a_pose_is_it() {
        let mut errors: Vec<_> =
            (0..3000).map(|i| point(i / 3, [i as f64, 0.0, 0.0], [0.1; 3], [0.01 * (i % 3 + 1) as f64; 3])).collect();
        errors.iter_mut().filter(|p| p.pose > PoseName::Number(700)).for_each(|p| p.set = PoseSet::Validation);
        let few = readable(&errors.iter().collect::<Vec<_>>());
        assert_eq!(few.iter().filter(|p| is_validation(p)).count(), 299);
        assert!(few.len() <= MARKS + 1 && few.iter().all(|p| p.after_mm[0] == 0.03), "{}", few.len());
    }

    #[test]
    fn all_lengths_of_a_tooltip_have_one_unit_and_one_number_of_decimals() {
        let mut p = point(1, [0.0; 3], [3.18, 0.0, 0.0], [0.057, -0.109, 0.19]);
        (p.before_deg, p.after_deg) = (Some(0.383), Some(-0.0750));
        let text = tooltip(&p, &Words::default());
        assert!(
            text.ends_with(": 3.18 mm before, 0.23 mm after (x 0.06, y -0.11, z 0.19 mm); 0.383 → 0.075 deg"),
            "{text}"
        );
        let text = tooltip(&point(1, [0.0; 3], [0.16, 0.0, 0.0], [0.0, 0.0, -0.0034]), &Words::default());
        assert!(text.ends_with(": 160.0 µm before, 3.4 µm after (x 0.0, y 0.0, z -3.4 µm)"), "{text}");
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
