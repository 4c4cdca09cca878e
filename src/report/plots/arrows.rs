//! Error vectors before and after calibration, enlarged by a stated factor.

use super::layer::*;
use crate::number::round_down_125;

/// Maximum number of legible arrows.
const LIMIT: usize = 120;
/// Length of the longest arrow relative to the workspace.
const SHARE: f64 = 0.16;

/// Figures before and after calibration for every plane of the workspace.
pub(crate) fn arrows(errors: &[&PointError], planar: bool, words: &Words) -> Vec<Figure> {
    let of_plane = |&seen: &Seen| [false, true].map(|after| in_plane(errors, seen, after, words));
    let mut all: Vec<Figure> = Seen::planes(planar).iter().flat_map(of_plane).collect();
    if let Some(figure) = all.get_mut(1) {
        (figure.table_title, figure.header, figure.rows) = table(&points::thin(errors, LIMIT, points::after_mm), words);
    }
    all
}

fn in_plane(errors: &[&PointError], seen: Seen, after: bool, words: &Words) -> Figure {
    let drawn = points::thin(errors, LIMIT, points::size(after));
    let error = |p: &PointError| if after { p.after_mm } else { p.before_mm };
    let longest_mm = largest(drawn.iter().map(|p| seen.length(error(p))));
    let factor = enlargement(&drawn, seen, longest_mm);
    let tip_mm = |p: &PointError| [0, 1, 2].map(|i| p.at_mm[i] + factor * error(p)[i]);
    let places: Vec<Vector> = drawn.iter().flat_map(|p| [p.at_mm, tip_mm(p)]).collect();
    let mut map = Workspace::new(seen, &places, words);
    for (class, validation) in [("arrow-cal", false), ("arrow-val", true)] {
        let of_set = drawn.iter().filter(|p| points::is_validation(p) == validation);
        let all: Vec<[Place; 2]> = of_set.map(|p| [p.at_mm, tip_mm(p)].map(|p| map.at(p).at)).collect();
        map.svg.arrows(class, &all);
    }
    for p in &drawn {
        map.svg.mark(points::look(p), map.at(p.at_mm), 2.0, &points::tooltip(p, words));
    }
    // scale arrow: a round length of about the size of the other arrows
    let shown = number::shown("mm", longest_mm);
    if longest_mm > 0.0 {
        let round = round_down_125(longest_mm * shown.factor);
        let (y, right) = (map.svg.row(), 30.0 + round / shown.factor * factor * map.scale);
        map.svg.arrows("arrow-scale", &[[(30.0, y), (right, y)]]);
        let length = format!("{} {}", number::significant(round, 1), shown.unit);
        map.svg.text("start", (right + 6.0, y + 4.0), &length);
    }
    points::legend(&mut map.svg, errors, words);
    let (times, name) = (number::significant(factor, 1), seen.name());
    let title = match after {
        true => tr!(words, "error-vectors-after", plane = name),
        false => tr!(words, "error-vectors-before", plane = name),
    };
    let description = tr!(words, "arrows-description", factor = times);
    let longest = format!("{} {}", number::significant(longest_mm * shown.factor, 3), shown.unit);
    let mut caption = tr!(words, "arrows-longest", factor = times, longest);
    if drawn.len() < errors.len() {
        caption += " ";
        caption += &tr!(words, "points-drawn", drawn = drawn.len(), total = errors.len());
    }
    let (pair, side) = (format!("arrows-{name}"), points::side(after));
    Figure { pair, side, caption, ..map.figure(&format!("arrows-{side}-{name}"), title, description) }
}

/// Round factor that makes the longest arrow a legible share of the workspace.
fn enlargement(drawn: &[&PointError], seen: Seen, longest_mm: f64) -> f64 {
    let spans = [0, 1, 2].map(|i| range(drawn.iter().map(|p| p.at_mm[i])).map_or(0.0, |(low, high)| high - low));
    let workspace =
        (0..3).map(|i| seen.length([0, 1, 2].map(|j| if i == j { spans[i] } else { 0.0 }))).fold(1.0, f64::max);
    if longest_mm > 0.0 { round_down_125(SHARE * workspace / longest_mm) } else { 1.0 }
}

fn table(drawn: &[&PointError], words: &Words) -> (String, Vec<String>, Vec<Vec<String>>) {
    let shown = number::shown("mm", largest(drawn.iter().map(|p| points::after_mm(p))));
    let column = |axis: &str| tr!(words, "error-in", quantity = axis, unit = shown.unit);
    let mut header = vec![tr!(words, "set"), tr!(words, "pose"), tr!(words, "cycle"), tr!(words, "target")];
    header.extend(["x", "y", "z"].map(|axis| tr!(words, "quantity-in-unit", quantity = axis, unit = "mm")));
    header.extend(["x", "y", "z"].map(column));
    let row = |p: &&PointError| {
        let mut row = vec![words.tr(&names::set(p.set)), p.pose.to_string(), p.cycle.to_string(), p.target.clone()];
        row.extend(p.at_mm.map(|v| number::fixed(v, 3)));
        row.extend(p.after_mm.map(|v| number::fixed(v * shown.factor, if shown.factor > 1.0 { 2 } else { 4 })));
        row
    };
    (tr!(words, "numbers-of-arrows", count = drawn.len()), header, drawn.iter().map(row).collect())
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
        assert!(!picture.svg.contains("class=\"arrow-scale\"") && picture.caption.contains("longest is 0 µm"));
    }
}
