//! Limits in a picture of errors: a line each, their names in rows under the axis, where they cover no mark.

use super::points::Limit;
use super::svg::Svg;

/// Height of a row of names.
const ROW: f64 = 18.0;
/// A line before a name, with the space around it.
const SAMPLE: f64 = 34.0;
/// Width of a letter of 12 px.
const LETTER: f64 = 7.2;
/// Numbers at the ends of lines are this far from each other, at least: their height with a gap, their width with a gap.
const APART: f64 = 12.0;

/// The limits that lie on the axis of a picture, each with its place on it.
pub(super) struct LimitLines<'a> {
    all: Vec<(Limit<'a>, f64)>,
}

impl<'a> LimitLines<'a> {
    /// The limits, each with its place; none for those off the axis.
    pub fn new(limits: &[Limit<'a>], place: impl Fn(f64) -> Option<f64>) -> Self {
        Self { all: limits.iter().filter_map(|l| Some((*l, place(l.value)?))).collect() }
    }

    /// Height that the names need under a picture of this width.
    pub fn height(&self, width: f64) -> f64 {
        self.names(width).last().map_or(0.0, |last| last.1 + ROW)
    }

    /// Lines from `left` to `right`, where the axis is upright; at their ends a number where there are several.
    pub fn level(&self, svg: &mut Svg, (left, right): (f64, f64)) {
        self.all.iter().for_each(|(_, y)| svg.line("limit", (left, *y), (right, *y)));
        for (number, y) in self.numbers() {
            svg.text("start", (right + 3.0, y + 4.0), &number);
        }
    }

    /// Lines from `top` to `bottom`, where the axis is level.
    pub fn upright(&self, svg: &mut Svg, (top, bottom): (f64, f64)) {
        self.all.iter().for_each(|(_, x)| svg.line("limit", (*x, top), (*x, bottom)));
        for (number, x) in self.numbers() {
            svg.text("mid", (x, top - 2.0), &number);
        }
    }

    /// The names in rows from `top` on, in a picture of this width.
    pub fn legend(&self, svg: &mut Svg, top: f64, width: f64) {
        for (i, (x, y)) in self.names(width).into_iter().enumerate() {
            let y = top + y;
            svg.line("limit", (x, y + 8.0), (x + SAMPLE - 12.0, y + 8.0));
            svg.text("start", (x + SAMPLE - 6.0, y + 12.0), &self.name(i));
        }
    }

    fn name(&self, i: usize) -> String {
        let name = self.all[i].0.name;
        if self.all.len() > 1 { format!("{} {name}", i + 1) } else { name.to_owned() }
    }

    /// Place of each name from the left and from the first row.
    fn names(&self, width: f64) -> Vec<(f64, f64)> {
        const LEFT: f64 = 24.0;
        let (mut x, mut y) = (LEFT, 0.0);
        let place = |i| {
            let wide = SAMPLE + LETTER * self.name(i).chars().count() as f64;
            if x > LEFT && x + wide > width {
                (x, y) = (LEFT, y + ROW);
            }
            let at = (x, y);
            x += wide + 12.0;
            at
        };
        (0..self.all.len()).map(place).collect()
    }

    /// The numbers of several limits, spread so that they can be read.
    fn numbers(&self) -> Vec<(String, f64)> {
        if self.all.len() < 2 {
            return Vec::new();
        }
        let mut order: Vec<usize> = (0..self.all.len()).collect();
        order.sort_by(|&a, &b| self.all[a].1.total_cmp(&self.all[b].1));
        let mut spread: Vec<(String, f64)> = order.iter().map(|&i| ((i + 1).to_string(), self.all[i].1)).collect();
        for i in 1..spread.len() {
            let gap = spread[i].1 - spread[i - 1].1;
            if gap < APART {
                // half to either side of two, the rest behind them
                let shift = if i == 1 { 0.5 * (APART - gap) } else { 0.0 };
                spread[i - 1].1 -= shift;
                spread[i].1 = spread[i - 1].1 + APART;
            }
        }
        spread
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn close_limits_have_numbers_that_stay_apart_and_names_below_the_picture() {
        let limits = ["position_mean_mm", "position_rms_mm", "position_max_mm"]
            .map(|name| Limit { name, value: name.len() as f64 });
        let lines = LimitLines::new(&limits, |value| Some(100.0 + value));
        let numbers = lines.numbers();
        assert!(numbers.windows(2).all(|pair| pair[1].1 - pair[0].1 >= APART - 1e-9), "{numbers:?}");
        assert_eq!((lines.height(380.0), lines.height(1000.0)), (2.0 * ROW, ROW));
        let one = LimitLines::new(&limits[..1], Some);
        assert!(one.numbers().is_empty() && one.name(0) == "position_mean_mm");
        assert_eq!(LimitLines::new(&limits, |_| None).height(380.0), 0.0);
    }
}
