//! Curves over one axis, with marks and a legend.

use super::axis::{Axis, left_margin, range};
use super::svg::{COLOURS, SHAPES, Shape, Svg};
use crate::model::Figure;
use crate::number;
use crate::words::Words;

const WIDTH: f64 = 760.0;
const RIGHT: f64 = 744.0;
const TOP: f64 = 16.0;
const BOTTOM: f64 = 250.0;
/// Values beyond this are blunders that no picture can show.
const DRAWABLE: f64 = 1e12;
/// More marks of a curve than this hide each other.
const LIMIT: usize = 300;
/// Curves that a legend names.
const NAMED: usize = 12;

pub(crate) struct Curve {
    pub name: String,
    pub points: Vec<(f64, f64)>,
}

/// A value that matters, with its interval.
pub(crate) struct Mark {
    pub at: (f64, f64),
    pub interval: Option<(f64, f64)>,
    pub name: String,
}

pub(crate) struct Chart {
    pub id: String,
    pub title: String,
    pub caption: String,
    pub across: String,
    pub up: String,
    pub curves: Vec<Curve>,
    pub marks: Vec<Mark>,
}

impl Chart {
    /// The picture with its numbers; `None` where no curve has a point that can be drawn.
    pub fn picture(self, words: &Words) -> Option<Figure> {
        let drawable = |p: &&(f64, f64)| p.0.abs() < DRAWABLE && p.1.abs() < DRAWABLE;
        let curves: Vec<(&Curve, Vec<(f64, f64)>)> = self
            .curves
            .iter()
            .map(|c| (c, c.points.iter().filter(drawable).copied().collect::<Vec<_>>()))
            .filter(|(_, points)| !points.is_empty())
            .collect();
        let points = || curves.iter().flat_map(|(_, points)| points);
        let (from, to) = range(points().map(|p| p.0))?;
        let ends = self.marks.iter().flat_map(|m| m.interval).flat_map(|(low, high)| [low, high]);
        let (_, largest) = range(points().map(|p| p.1).chain(ends.filter(|e| e.abs() < DRAWABLE)))?;
        let up = Axis::from_zero(largest, BOTTOM, TOP);
        let ticks = up.ticks(5);
        let left = left_margin(&ticks);
        let across = Axis::linear(from, to, left + 6.0, RIGHT - 6.0);
        let named = curves.len().min(NAMED);
        let height = BOTTOM + 46.0 + 20.0 * named.div_ceil(3) as f64;
        let mut svg = Svg::new(&self.id, WIDTH, height, &self.title, &self.caption);
        for (value, label) in &ticks {
            svg.line("grid", (left, up.at(*value)), (RIGHT, up.at(*value)));
            svg.text("end", (left - 5.0, up.at(*value) + 4.0), label);
        }
        for (value, label) in across.ticks(8) {
            svg.line("axis", (across.at(value), BOTTOM), (across.at(value), BOTTOM + 4.0));
            svg.text("mid", (across.at(value), BOTTOM + 17.0), &label);
        }
        svg.line("axis", (left, BOTTOM), (RIGHT, BOTTOM));
        svg.line("axis", (left, TOP), (left, BOTTOM));
        svg.text("mid", ((left + RIGHT) / 2.0, BOTTOM + 36.0), &self.across);
        svg.text_upwards((12.0, (TOP + BOTTOM) / 2.0), &self.up);
        for (i, (curve, points)) in curves.iter().enumerate() {
            let at = |p: &(f64, f64)| (across.at(p.0), up.at(p.1));
            let stride = points.len().div_ceil(LIMIT);
            let drawn: Vec<&(f64, f64)> = points.iter().step_by(stride).collect();
            for pair in drawn.windows(2) {
                svg.line("grid", at(pair[0]), at(pair[1]));
            }
            for p in drawn {
                let values = [number::significant(p.1, 4), number::significant(p.0, 4)];
                let tip = words.fill("{0}: {1} at {2}", &[&curve.name, &values[0], &values[1]]);
                svg.mark(SHAPES[i % SHAPES.len()], "map", at(p), 2.6, COLOURS[i % COLOURS.len()], &tip);
            }
        }
        for mark in &self.marks {
            let x = across.at(mark.at.0);
            for end in mark.interval.iter().flat_map(|(low, high)| [*low, *high]) {
                svg.line("axis", (x, up.at(mark.at.1)), (x, up.at(end)));
                svg.line("axis", (x - 5.0, up.at(end)), (x + 5.0, up.at(end)));
            }
            let value = words.number(&number::significant(mark.at.1, 4));
            let tip = format!("{}: {value} {}", mark.name, self.up);
            svg.mark(Shape::Diamond, "val", (x, up.at(mark.at.1)), 5.5, "", &tip);
            svg.text("over", (x + 8.0, up.at(mark.at.1) - 6.0), &mark.name);
        }
        for (i, (curve, _)) in curves.iter().take(NAMED).enumerate() {
            let (x, y) = (left + 240.0 * (i % 3) as f64, BOTTOM + 56.0 + 20.0 * (i / 3) as f64);
            svg.mark(SHAPES[i % SHAPES.len()], "map", (x, y), 4.5, COLOURS[i % COLOURS.len()], "");
            svg.text("start", (x + 10.0, y + 4.0), &curve.name);
        }
        let rows = curves.iter().flat_map(|(c, points)| {
            points.iter().map(|p| vec![c.name.clone(), number::significant(p.0, 5), number::significant(p.1, 4)])
        });
        let header = [words.say("curve"), self.across.clone(), self.up.clone()];
        Some(Figure {
            svg: svg.finish(),
            wide: true,
            table_title: words.say("Numbers of this picture"),
            header: header.to_vec(),
            rows: rows.take(2000).collect(),
            title: self.title,
            caption: self.caption,
            ..Figure::default()
        })
    }
}
