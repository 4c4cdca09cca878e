//! Common layer of figures with two axes: frame, grid, labels, names, the limit and legend.
//! Figures add their marks.

use super::axis::Axis;
use super::svg::{Look, NARROW, Place, ROW, Svg, widest, width};
use crate::model::Figure;
use crate::number;
use crate::words::{Words, names, tr};
use etalon_documents::{ErrorQuantity, LimitVerdict};

/// Height of the frame.
const HEIGHT: f64 = 240.0;
/// Margin above the frame.
const TOP: f64 = 16.0;
/// Margin at the right of the frame for half of a label.
const RIGHT: f64 = 20.0;
/// Margin below the frame for the labels and the name of the axis.
pub(super) const UNDER: f64 = 42.0;

/// Two axes with their positions.
#[derive(Clone, Debug)]
pub(crate) struct Frame {
    pub across: Axis,
    pub up: Axis,
    pub left: f64,
    pub right: f64,
    pub top: f64,
    pub bottom: f64,
}

impl Frame {
    /// Position of a pair of values; rows count from the top.
    pub fn at(&self, across: f64, up: f64) -> Place {
        (self.left + self.across.share(across) * (self.right - self.left), self.level(&self.up, up))
    }

    /// Height of a value on a vertical axis.
    pub fn level(&self, axis: &Axis, value: f64) -> f64 {
        let share = axis.share(value) * (self.bottom - self.top);
        if axis.is_labelled() { self.top + share } else { self.bottom - share }
    }

    /// Draws the axes; `grid` draws grid lines of both, otherwise of the axis of values only.
    pub fn draw(&self, svg: &mut Svg, [along, upwards]: [&str; 2], grid: bool) {
        let Self { left, right, top, bottom, .. } = *self;
        let rows = self.up.is_labelled();
        for (value, label) in upright_ticks(&self.up) {
            let y = self.level(&self.up, value);
            if !rows {
                svg.line("grid", (left, y), (right, y));
            }
            tick(svg, &self.up, "end", (left - 6.0, y + 4.0), &label);
        }
        for (value, label) in self.level_ticks() {
            let x = self.at(value, 0.0).0;
            match grid || rows {
                true => svg.line("grid", (x, top), (x, bottom)),
                false => svg.line("axis", (x, bottom), (x, bottom + 4.0)),
            }
            // the last label stays inside the figure
            let middle = x.min(svg.width - 0.5 * width(&label));
            tick(svg, &self.across, "mid", (middle, bottom + 17.0), &label);
        }
        svg.line("axis", (left, bottom), (right, bottom));
        svg.line("axis", (left, top), (left, bottom));
        if !along.is_empty() {
            svg.text("mid", (0.5 * (left + right), bottom + 35.0), along);
        }
        if !upwards.is_empty() {
            svg.text_upwards("mid", (13.0, 0.5 * (top + bottom)), upwards);
        }
    }

    /// Ticks of the horizontal axis: as many as fit, at least two.
    fn level_ticks(&self) -> Vec<(f64, String)> {
        let room = self.right - self.left;
        let fits = |ticks: &Vec<(f64, String)>| {
            let wide = widest(ticks.iter().map(|(_, label)| label.as_str())) + 6.0;
            ticks.windows(2).all(|pair| (self.across.share(pair[1].0) - self.across.share(pair[0].0)) * room > wide)
        };
        let most = if room < NARROW { 6 } else { 8 };
        let counts = if self.across.is_labelled() { 1..2 } else { 2..most + 1 };
        let mut all: Vec<_> = counts.map(|count| self.across.ticks(count)).filter(|ticks| ticks.len() > 1).collect();
        let most = all.iter().rposition(fits).unwrap_or(0);
        if all.is_empty() { self.across.ticks(2) } else { all.swap_remove(most) }
    }
}

/// Writes the label of a tick: a name or a number.
fn tick(svg: &mut Svg, axis: &Axis, class: &str, at: Place, label: &str) {
    match axis.is_labelled() {
        true => svg.text(class, at, label),
        false => svg.number(class, at, label),
    }
}

/// A figure with two axes.
pub(crate) struct Chart {
    pub svg: Svg,
    pub frame: Frame,
}

impl Chart {
    /// Draws the axes with their names, the horizontal axis first.
    pub fn new(words: &Words, width: f64, axes: [Axis; 2], names: [impl AsRef<str>; 2]) -> Self {
        Self::with_room(words, RIGHT, axes, width, names)
    }

    /// Draws the axes with the given margin at the right.
    pub fn with_room(
        words: &Words,
        room: f64,
        [across, up]: [Axis; 2],
        width: f64,
        names: [impl AsRef<str>; 2],
    ) -> Self {
        let names = [names[0].as_ref(), names[1].as_ref()];
        let height = if up.is_labelled() { ROW * up.length() } else { HEIGHT };
        let left = left_margin(&up, names[1]);
        let frame = Frame { across, up, left, right: width - room, top: TOP, bottom: TOP + height };
        let mut svg = Svg::new(words, width, frame.bottom + UNDER);
        frame.draw(&mut svg, names, false);
        Self { svg, frame }
    }

    /// Position of a pair of values.
    pub fn at(&self, across: f64, up: f64) -> Place {
        self.frame.at(across, up)
    }

    /// Draws a vertical line at a value of the horizontal axis.
    pub fn upright(&mut self, class: &str, value: f64) {
        let x = self.at(value, 0.0).0;
        self.svg.line(class, (x, self.frame.top), (x, self.frame.bottom));
    }

    /// Draws a horizontal line at a value of the vertical axis.
    pub fn level(&mut self, class: &str, value: f64) {
        let y = self.at(0.0, value).1;
        self.svg.line(class, (self.frame.left, y), (self.frame.right, y));
    }

    /// Draws a second vertical axis at the right.
    pub fn second(&mut self, axis: &Axis, name: &str) {
        let Frame { right, top, bottom, .. } = self.frame;
        for (value, label) in upright_ticks(axis) {
            tick(&mut self.svg, axis, "start", (right + 5.0, self.frame.level(axis, value) + 4.0), &label);
        }
        self.svg.line("axis", (right, top), (right, bottom));
        self.svg.text_upwards("mid", (self.svg.width - 6.0, 0.5 * (top + bottom)), name);
    }

    /// Draws a horizontal bar in a row between two values.
    pub fn bar_along(&mut self, look: Look, row: usize, ends: [f64; 2], tooltip: &str) {
        let [(left, y), (right, _)] = ends.map(|v| self.at(v, row as f64));
        self.svg.rect(look, (left, y - 0.35 * ROW), ((right - left).max(0.5), 0.7 * ROW), tooltip);
    }

    /// Draws a vertical bar of the given width at `x`, from zero to a value.
    pub fn bar_up(&mut self, look: Look, (x, width): Place, value: f64, tooltip: &str) {
        let [zero, end] = [0.0, value].map(|v| self.at(0.0, v).1);
        self.svg.rect(look, (x, end.min(zero)), (width, (end - zero).abs().max(0.5)), tooltip);
    }

    /// Draws the limit of single errors of a quantity, on the horizontal axis if `across`. Limits
    /// of a mean or a root mean square are not drawn: the marks are single errors. The name is in
    /// the legend so that it covers no marks.
    pub fn limit(&mut self, limits: &[LimitVerdict], quantity: ErrorQuantity, across: bool, words: &Words) {
        let axis = if across { &self.frame.across } else { &self.frame.up };
        let drawn = |l: &&LimitVerdict| l.name.individually_limited_error() == Some(quantity) && axis.contains(l.limit);
        let Some(limit) = limits.iter().find(drawn) else { return };
        let shown = axis.display_unit();
        match across {
            true => self.upright("limit", limit.limit),
            false => self.level("limit", limit.limit),
        }
        let unit = if shown.unit.is_empty() { &limit.unit } else { shown.unit };
        let quantity = words.tr(&names::limit(limit.name));
        let value = &number::derived(limit.limit * shown.factor);
        self.svg.legend_line("limit", &tr!(words, "limit-of", quantity, value, unit));
    }

    /// Returns the figure with its description, which is also its caption.
    pub fn figure(self, id: &str, title: String, description: String) -> Figure {
        self.svg.figure(id, title, description)
    }
}

/// Margin at the left of a vertical axis for its name and labels; letters are wider than digits.
pub(super) fn left_margin(up: &Axis, name: &str) -> f64 {
    let ticks = upright_ticks(up);
    let labels = widest(ticks.iter().map(|(_, label)| label.as_str()));
    let wider = if up.is_labelled() { 1.17 } else { 1.0 };
    wider * labels + if name.is_empty() { 18.0 } else { 34.0 }
}

fn upright_ticks(up: &Axis) -> Vec<(f64, String)> {
    up.ticks(if up.ends().0 < 0.0 { 6 } else { 5 })
}

#[cfg(test)]
mod tests {
    use super::super::svg::{WIDE, numbers};
    use super::*;
    use etalon_documents::LimitQuantity;

    /// Limits of a mean, a root mean square and a largest error within an axis to 0.1 mm.
    fn limits(across: bool, names: &[LimitQuantity]) -> String {
        let limit = |name| LimitVerdict::judge(name, 0.04, 0.0, None, Default::default());
        let limits: Vec<_> = names.iter().copied().map(limit).collect();
        let axis = || Axis::from_zero("mm", 0.1);
        let mut chart = Chart::new(&Words::default(), NARROW, [axis(), axis()], ["a", "b"]);
        chart.limit(&limits, ErrorQuantity::Position, across, &Words::default());
        chart.figure("p", String::new(), String::new()).svg
    }

    #[test]
    fn a_limit_is_drawn_over_the_quantity_that_it_limits() {
        let statistics =
            [LimitQuantity::PositionMeanMm, LimitQuantity::PositionRmsMm, LimitQuantity::OrientationMaxDeg];
        for across in [false, true] {
            assert!(!limits(across, &statistics).contains("class=\"limit\""), "marks are single errors");
            let svg = limits(across, &[&statistics[..], &[LimitQuantity::PositionMaxMm]].concat());
            // the line, and its mark in the legend
            assert_eq!(svg.matches("class=\"limit\"").count(), 2, "{svg}");
            assert!(svg.contains(">limit: largest position error 40 µm</text>") && !svg.contains("_max"), "{svg}");
            // below the axis and its name, where there are no marks
            let name = svg.lines().find(|l| l.contains(">limit: ")).unwrap();
            assert!(numbers(name, "text", "y")[0] > TOP + HEIGHT + UNDER, "{svg}");
        }
    }

    #[test]
    fn numbers_have_the_decimal_mark_of_the_language_and_names_keep_their_point() {
        let words = Words::new(etalon_documents::Language::De);
        let rows = Axis::rows(1, vec![(0.0, "ball 1.5".to_owned()), (1.0, "1.5".to_owned())], 0.5);
        let mut chart = Chart::new(&words, WIDE, [Axis::from_zero("", 1.0), rows], ["", ""]);
        chart.svg.legend(Look::group(0), "2.5");
        let svg = chart.figure("p", String::new(), String::new()).svg;
        for shown in [">ball 1.5<", ">1.5<", ">2.5<", ">0,2<"] {
            assert!(svg.contains(shown), "{shown}: {svg}");
        }
    }

    #[test]
    fn labels_keep_their_distance() {
        let across = Axis::both_ways(crate::number::display_unit("deg", 0.0), 0.000_27);
        let chart = |left| Frame {
            across: across.clone(),
            up: Axis::linear(0.0, 1.0),
            left,
            right: 296.0,
            top: 0.0,
            bottom: 9.0,
        };
        for left in [121.0, 138.0] {
            let labels: Vec<String> = chart(left).level_ticks().into_iter().map(|(_, label)| label).collect();
            assert_eq!(labels, ["-0.0002", "0", "0.0002"]);
        }
    }
}
