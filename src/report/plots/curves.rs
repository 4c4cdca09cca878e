//! Curves with marks over a common axis.

use super::layer::*;

/// Maximum number of legible marks of a curve.
const LIMIT: usize = 300;
/// Maximum number of curves in a legend.
const NAMED: usize = 12;
/// Maximum number of rows in the table of numbers.
const ROWS: usize = 2000;

pub(crate) struct Curve {
    pub name: String,
    pub points: Vec<(f64, f64)>,
}

/// An important value with its interval.
pub(crate) struct Mark {
    pub at: (f64, f64),
    pub interval: Option<(f64, f64)>,
    pub name: String,
}

pub(crate) struct Curves {
    pub id: String,
    pub title: String,
    pub caption: String,
    pub across: String,
    pub up: String,
    pub curves: Vec<Curve>,
    pub marks: Vec<Mark>,
}

impl Curves {
    /// Returns the figure with its numbers; `None` if no curve has a point that can be drawn.
    pub fn picture(mut self, words: &Words) -> Option<Figure> {
        self.curves.iter_mut().for_each(|c| c.points.retain(|p| drawable(p.0) && drawable(p.1)));
        self.curves.retain(|c| !c.points.is_empty());
        let points = || self.curves.iter().flat_map(|c| &c.points);
        let ends = self.marks.iter().flat_map(|m| m.interval).flat_map(|(low, high)| [low, high]);
        let [_, largest] = range(points().map(|p| p.1).chain(ends.filter(|e| drawable(*e))))?;
        // numbers of cycles or sets have no decimals
        let whole = points().all(|p| p.0.fract() == 0.0);
        let place = |x: f64, digits: usize| if whole { format!("{x:.0}") } else { number::significant(x, digits) };
        let across = Axis::over("", range(points().map(|p| p.0))?, 0.01);
        let mut chart = Chart::new(words, WIDE, [across, Axis::from_zero("", largest)], [&self.across, &self.up]);
        for (i, curve) in self.curves.iter().enumerate() {
            let stride = curve.points.len().div_ceil(LIMIT);
            let drawn: Vec<(f64, f64)> = curve.points.iter().step_by(stride).copied().collect();
            let places: Vec<_> = drawn.iter().map(|(x, y)| chart.at(*x, *y)).collect();
            chart.svg.lines("leader", &places);
            for ((x, y), at) in drawn.into_iter().zip(places) {
                let values = [number::significant(y, 4), place(x, 4)];
                let tip = tr!(words, "curve-point-tooltip", curve = curve.name, value = values[0], at = values[1]);
                chart.svg.mark(Look::group(i), at, 2.6, &tip);
            }
            if i < NAMED {
                chart.svg.legend(Look::group(i), &curve.name);
            }
        }
        for mark in &self.marks {
            let at = chart.at(mark.at.0, mark.at.1);
            let ends = mark.interval.iter().flat_map(|(low, high)| [*low, *high]).map(|v| chart.at(mark.at.0, v));
            chart.svg.interval("axis", at, ends.collect::<Vec<_>>());
            let value = words.significant(mark.at.1, 4);
            chart.svg.mark(VALIDATION, at, 5.5, &format!("{}: {value} {}", mark.name, self.up));
            chart.svg.text("over", (at.0 + 8.0, at.1 - 6.0), &mark.name);
        }
        let rows = self.curves.iter().flat_map(|c| {
            let numbers = |p: &(f64, f64)| [place(p.0, 5), number::significant(p.1, 4)].map(|v| words.decimal(v));
            let row = |p: &(f64, f64)| std::iter::once(c.name.clone()).chain(numbers(p)).collect::<Vec<_>>();
            c.points.iter().map(row).collect::<Vec<_>>()
        });
        Some(Figure {
            table_title: tr!(words, "numbers-of-this-picture"),
            rows: rows.take(ROWS).collect(),
            header: vec![tr!(words, "curve"), self.across, self.up],
            ..chart.figure(&self.id, self.title, self.caption)
        })
    }
}
