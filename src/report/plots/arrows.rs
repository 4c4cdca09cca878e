//! Error vectors before and after calibration, enlarged by a given factor.

use super::layer::*;
use crate::number::round_down_125;

/// Maximum number of legible arrows.
const LIMIT: usize = 120;
/// Length of the longest arrow relative to the workspace.
const SHARE: f64 = 0.16;

/// Figures before and after calibration for every plane of the workspace: one axis and one
/// magnification for both. A page can also show each with its own magnification.
pub(crate) fn arrows(errors: &[&PointError], planar: bool, words: &Words) -> Vec<Figure> {
    let of_plane = |&seen: &Seen| {
        let plane = Plane::new(errors, seen);
        [false, true].map(|after| plane.picture(after, words))
    };
    let mut all: Vec<Figure> = Seen::planes(planar).iter().flat_map(of_plane).collect();
    if let Some(figure) = all.get_mut(1) {
        (figure.table_title, figure.header, figure.rows) = table(&points::thin(errors, LIMIT, points::after_mm), words);
    }
    all
}

/// Errors in a plane, before and after calibration.
struct Plane<'a> {
    seen: Seen,
    errors: &'a [&'a PointError],
    /// Drawn errors, length of the longest arrow (mm) and magnification of each side alone.
    sides: [(Vec<&'a PointError>, f64, f64); 2],
    /// Magnification of both.
    common: f64,
    /// Positions that both figures show (mm).
    places: Vec<Vector>,
}

fn error(p: &PointError, after: bool) -> Vector {
    if after { p.after_mm } else { p.before_mm }
}

fn tip_mm(p: &PointError, after: bool, factor: f64) -> Vector {
    let error = error(p, after);
    [0, 1, 2].map(|i| p.at_mm[i] + factor * error[i])
}

impl<'a> Plane<'a> {
    fn new(errors: &'a [&'a PointError], seen: Seen) -> Self {
        let sides = [false, true].map(|after| {
            let drawn = points::thin(errors, LIMIT, |p| seen.length(error(p, after)));
            let longest_mm = largest(drawn.iter().map(|p| seen.length(error(p, after))));
            let factor = enlargement(&drawn, seen, longest_mm);
            (drawn, longest_mm, factor)
        });
        let common = if sides[0].1 > sides[1].1 { sides[0].2 } else { sides[1].2 };
        let ends = |after: bool| {
            let (drawn, _, own) = &sides[usize::from(after)];
            drawn.iter().flat_map(move |p| [p.at_mm, tip_mm(p, after, common), tip_mm(p, after, *own)])
        };
        let places = ends(false).chain(ends(true)).collect();
        Self { seen, errors, sides, common, places }
    }

    fn picture(&self, after: bool, words: &Words) -> Figure {
        let (drawn, longest_mm, own) = &self.sides[usize::from(after)];
        let mut map = Workspace::new(self.seen, &self.places, words);
        let y = map.svg.row();
        for (class, factor) in [("common", self.common), ("own", *own)] {
            let at: Vec<(bool, [Place; 2])> = drawn
                .iter()
                .map(|p| (points::is_validation(p), [p.at_mm, tip_mm(p, after, factor)].map(|p| map.at(p).at)))
                .collect();
            let scale = map.scale;
            map.svg.group(class, |svg| {
                for (class, validation) in [("arrow-cal", false), ("arrow-val", true)] {
                    let of_set = at.iter().filter(|(set, _)| *set == validation);
                    svg.arrows(class, &of_set.map(|(_, arrow)| *arrow).collect::<Vec<_>>());
                }
                scale_arrow(svg, y, factor * scale, if class == "own" { *longest_mm } else { self.longest_mm() });
            });
        }
        for p in drawn {
            map.svg.mark(points::look(p), map.at(p.at_mm), 2.0, &points::tooltip(p, words));
        }
        points::legend(&mut map.svg, self.errors, words);
        let (name, times) = (self.seen.name(), number::significant(self.common, 1));
        let title = match after {
            true => tr!(words, "error-vectors-after", plane = name.clone()),
            false => tr!(words, "error-vectors-before", plane = name.clone()),
        };
        let description = tr!(words, "arrows-description", factor = times.clone());
        let shown = number::display_unit("mm", *longest_mm);
        let longest = format!("{} {}", number::significant(longest_mm * shown.factor, 3), shown.unit);
        let few = match drawn.len() < self.errors.len() {
            true => {
                format!(" {}", tr!(words, "points-drawn", drawn = drawn.len(), total = self.errors.len()))
            }
            false => String::new(),
        };
        let common = tr!(words, "arrows-common", factor = times, longest = longest.clone());
        let of_own = number::significant(*own, 1);
        let of_own = tr!(words, "arrows-longest", factor = of_own, longest);
        let (pair, side) = (format!("arrows-{name}"), points::side(after));
        Figure {
            pair,
            side,
            scaled: true,
            caption: common + &few,
            caption_own: of_own + &few,
            ..map.figure(&format!("arrows-{side}-{name}"), title, description)
        }
    }

    /// Length of the longest arrow of both figures (mm).
    fn longest_mm(&self) -> f64 {
        self.sides[0].1.max(self.sides[1].1)
    }
}

/// Draws a round length of about the size of the longest arrow; `scale` is its units of the figure
/// per mm.
fn scale_arrow(svg: &mut Svg, y: f64, scale: f64, longest_mm: f64) {
    if longest_mm > 0.0 {
        let shown = number::display_unit("mm", longest_mm);
        let round = round_down_125(longest_mm * shown.factor);
        let right = 30.0 + round / shown.factor * scale;
        svg.arrows("arrow-scale", &[[(30.0, y), (right, y)]]);
        svg.number("start", (right + 6.0, y + 4.0), &format!("{} {}", number::significant(round, 1), shown.unit));
    }
}

/// Round factor that makes the longest arrow a legible share of the workspace.
fn enlargement(drawn: &[&PointError], seen: Seen, longest_mm: f64) -> f64 {
    let spans = [0, 1, 2].map(|i| range(drawn.iter().map(|p| p.at_mm[i])).map_or(0.0, |[low, high]| high - low));
    let workspace =
        (0..3).map(|i| seen.length([0, 1, 2].map(|j| if i == j { spans[i] } else { 0.0 }))).fold(1.0, f64::max);
    if longest_mm > 0.0 { round_down_125(SHARE * workspace / longest_mm) } else { 1.0 }
}

fn table(drawn: &[&PointError], words: &Words) -> (String, Vec<String>, Vec<Vec<String>>) {
    let shown = number::display_unit("mm", largest(drawn.iter().map(|p| points::after_mm(p))));
    let column = |axis: &str| tr!(words, "error-in", quantity = axis, unit = shown.unit);
    let mut header = vec![tr!(words, "set"), tr!(words, "pose"), tr!(words, "cycle"), tr!(words, "target")];
    header.extend(["x", "y", "z"].map(|axis| tr!(words, "quantity-in-unit", quantity = axis, unit = "mm")));
    header.extend(["x", "y", "z"].map(column));
    let row = |p: &&PointError| {
        let mut row = vec![words.tr(&p.set.phrase()), p.pose.to_string(), p.cycle.to_string(), p.target.clone()];
        let decimals = if shown.factor > 1.0 { 2 } else { 4 };
        row.extend(p.at_mm.map(|v| words.fixed(v, 3)));
        row.extend(p.after_mm.map(|v| words.fixed(v * shown.factor, decimals)));
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
        let own = tr!(Words::default(), "arrows-longest", factor = "2000", longest = "6.00 µm");
        assert!(after.caption_own.starts_with(&own), "{}", after.caption_own);
        for (figure, longest) in [(before, "141 µm"), (after, "6.00 µm")] {
            let common = tr!(Words::default(), "arrows-common", factor = "100", longest);
            assert!(figure.caption.starts_with(&common), "{}", figure.caption);
        }
        assert!(after.svg.contains(">5 µm</text>"));
        // one axis, one arrow of 100 µm and equal lengths of equal errors
        let scale = |figure: &Figure| {
            let group = figure.svg.split("<g class=\"common\">").nth(1).unwrap().split("</g>").next().unwrap();
            let arrow = group.lines().find(|l| l.contains("arrow-scale")).unwrap().to_owned();
            assert!(group.contains(">100 µm</text>"), "{group}");
            arrow
        };
        assert_eq!(scale(before), scale(after));
        let axes =
            |figure: &Figure| figure.svg.lines().filter(|l| l.starts_with("<line") || l.starts_with("<circle")).count();
        assert_eq!(axes(before), axes(after));
        let first = |figure: &Figure| figure.svg.lines().find(|l| l.starts_with("<circle")).unwrap().to_owned();
        assert_eq!(first(before), first(after), "the same position at the same place");
        assert_eq!((after.rows.len(), before.rows.len()), (2, 0));
        assert_eq!(after.rows[1][8], "6.00");
    }

    /// The largest error in space is along z, and another one is the largest in the xy plane.
    #[test]
    fn a_selection_contains_the_largest_error_in_its_plane() {
        let mut errors: Vec<_> = (0..300).map(|i| point(i, [i as f64, 0.0, 0.0], [0.1; 3], [0.01, 0.0, 0.0])).collect();
        errors[101].after_mm = [0.0, 0.05, 0.0];
        errors[200].after_mm = [0.0, 0.0, 0.08];
        let all = arrows(&errors.iter().collect::<Vec<_>>(), false, &Words::default());
        for (plane, longest) in [("xy", "50.0 µm"), ("xz", "80.0 µm")] {
            let figure = all.iter().find(|f| f.pair == format!("arrows-{plane}") && f.side == "after").unwrap();
            assert!(figure.caption_own.contains(longest), "{plane}: {}", figure.caption_own);
        }
    }

    #[test]
    fn perfect_points_have_no_arrows() {
        let errors = [point(1, [0.0; 3], [0.0; 3], [0.0; 3])];
        let picture = &arrows(&errors.iter().collect::<Vec<_>>(), true, &Words::default())[1];
        assert!(!picture.svg.contains("class=\"arrow-scale\"") && picture.caption.contains(": 0 µm"));
    }
}
