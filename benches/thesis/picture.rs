//! Pictures as SVG: marks, bars and polygons over two linear axes.

use crate::page::escape;
use std::fmt::Write;

const COLOURS: [&str; 5] = ["#0072b2", "#e69f00", "#009e73", "#cc79a7", "#d55e00"];
const WIDTH: f64 = 720.0;
const LEFT: f64 = 70.0;
const TOP: f64 = 34.0;

/// How a series is drawn.
#[derive(Clone, Copy, PartialEq)]
pub enum Form {
    Marks,
    Line,
    Closed,
    /// From zero up to each point.
    Bars,
}

pub struct Series {
    pub name: String,
    pub points: Vec<[f64; 2]>,
    pub form: Form,
}

pub struct Picture {
    pub title: String,
    pub across: &'static str,
    pub up: &'static str,
    /// One unit is as long along both axes.
    pub equal: bool,
    pub series: Vec<Series>,
}

impl Picture {
    pub fn svg(&self) -> String {
        let all = || self.series.iter().flat_map(|s| &s.points);
        let bars = self.series.iter().any(|s| s.form == Form::Bars);
        let range = |k: usize| {
            let (low, high) =
                all().map(|p| p[k]).fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
            let low = if k == 1 && bars { low.min(0.0) } else { low };
            let margin = 0.04 * (high - low).max(1e-9);
            [low - margin * f64::from(!(k == 1 && bars)), high + margin]
        };
        let (x, y) = (range(0), range(1));
        let wide = WIDTH - LEFT - 16.0;
        let high = if self.equal { (wide * (y[1] - y[0]) / (x[1] - x[0])).clamp(120.0, 620.0) } else { 260.0 };
        let scale = if self.equal { (high / (y[1] - y[0])).min(wide / (x[1] - x[0])) } else { wide / (x[1] - x[0]) };
        let up = if self.equal { scale } else { high / (y[1] - y[0]) };
        let axes = Axes { origin: [x[0], y[0]], scale: [scale, up], floor: TOP + high };
        let at = |p: &[f64; 2]| axes.at(p);
        let height = TOP + high + 46.0 + 20.0;
        let mut out = format!(
            "<svg viewBox=\"0 0 {WIDTH:.0} {height:.0}\" role=\"img\"><title>{}</title>\n",
            escape(&self.title)
        );
        let _ = writeln!(out, "<text x=\"{LEFT}\" y=\"20\" font-weight=\"600\">{}</text>", escape(&self.title));
        for v in ticks(y) {
            let (_, py) = at(&[x[0], v]);
            let _ = writeln!(
                out,
                "<line class=\"grid\" x1=\"{LEFT}\" x2=\"{:.1}\" y1=\"{py:.1}\" y2=\"{py:.1}\"/>",
                WIDTH - 16.0
            );
            let _ = writeln!(
                out,
                "<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"end\">{}</text>",
                LEFT - 6.0,
                py + 4.0,
                short(v)
            );
        }
        for v in ticks(x) {
            let (px, _) = at(&[v, y[0]]);
            let _ = writeln!(
                out,
                "<text x=\"{px:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{}</text>",
                TOP + high + 17.0,
                short(v)
            );
        }
        let _ = writeln!(
            out,
            "<line class=\"axis\" x1=\"{LEFT}\" x2=\"{:.1}\" y1=\"{1:.1}\" y2=\"{1:.1}\"/>",
            WIDTH - 16.0,
            TOP + high
        );
        let _ = writeln!(
            out,
            "<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"end\">{}</text>",
            WIDTH - 16.0,
            TOP + high + 36.0,
            escape(self.across)
        );
        let middle = TOP + high / 2.0;
        let _ = writeln!(
            out,
            "<text transform=\"rotate(-90 14 {middle:.1})\" x=\"14\" y=\"{middle:.1}\" text-anchor=\"middle\">{}</text>",
            escape(self.up)
        );
        for (i, series) in self.series.iter().enumerate() {
            let colour = COLOURS[i % COLOURS.len()];
            draw(&mut out, series, colour, (i, self.series.len()), &axes);
            let (lx, ly) = (LEFT + 170.0 * i as f64, TOP + high + 36.0);
            let _ = writeln!(
                out,
                "<rect x=\"{lx:.1}\" y=\"{:.1}\" width=\"10\" height=\"10\" fill=\"{colour}\"/>",
                ly - 9.0
            );
            let _ = writeln!(out, "<text x=\"{:.1}\" y=\"{ly:.1}\">{}</text>", lx + 15.0, escape(&series.name));
        }
        out + "</svg>\n"
    }
}

/// The two axes on the page.
struct Axes {
    /// Values where the axes meet.
    origin: [f64; 2],
    /// Length on the page of a unit along each axis.
    scale: [f64; 2],
    /// Height on the page of the axis that goes across.
    floor: f64,
}

impl Axes {
    /// The place of a point on the page.
    fn at(&self, p: &[f64; 2]) -> (f64, f64) {
        let [x, y] = [0, 1].map(|k| (p[k] - self.origin[k]) * self.scale[k]);
        (LEFT + x, self.floor - y)
    }
}

fn draw(out: &mut String, series: &Series, colour: &str, (i, of): (usize, usize), axes: &Axes) {
    let places: Vec<(f64, f64)> = series.points.iter().map(|p| axes.at(p)).collect();
    let path = places.iter().map(|(x, y)| format!("{x:.1},{y:.1}")).collect::<Vec<_>>().join(" ");
    match series.form {
        Form::Closed => drop_result(writeln!(
            out,
            "<polygon points=\"{path}\" fill=\"{colour}\" fill-opacity=\"0.12\" stroke=\"{colour}\"/>"
        )),
        Form::Line => drop_result(writeln!(
            out,
            "<polyline points=\"{path}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"1.6\"/>"
        )),
        Form::Marks => places.iter().for_each(|(x, y)| {
            let _ = writeln!(
                out,
                "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"2.8\" fill=\"{colour}\" fill-opacity=\"0.75\"/>"
            );
        }),
        Form::Bars => places.iter().for_each(|(x, y)| {
            let width = 7.0 / of as f64 + 1.0;
            let left = x + (i as f64 - of as f64 / 2.0) * width;
            let _ = writeln!(
                out,
                "<rect x=\"{left:.1}\" y=\"{y:.1}\" width=\"{width:.1}\" height=\"{:.1}\" fill=\"{colour}\"/>",
                (axes.floor - y).max(0.0)
            );
        }),
    }
}

/// Writing to a text cannot fail.
fn drop_result(_: std::fmt::Result) {}

fn ticks([low, high]: [f64; 2]) -> Vec<f64> {
    let rough = (high - low) / 5.0;
    let power = 10f64.powf(rough.log10().floor());
    let step = [1.0, 2.0, 5.0, 10.0].into_iter().map(|s| s * power).find(|s| *s >= rough).unwrap_or(10.0 * power);
    let first = (low / step).ceil() as i64;
    (first..).map(|i| i as f64 * step).take_while(|v| *v <= high).collect()
}

fn short(value: f64) -> String {
    let text = format!("{value:.4}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}
