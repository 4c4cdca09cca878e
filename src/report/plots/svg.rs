//! Inline SVG, one mark at a time; every text is escaped here and nowhere else.

use etalon_base::pose::Vector;
use std::fmt::Write;

/// Colours that every eye distinguishes (Okabe & Ito 2008).
pub(crate) const COLOURS: [&str; 6] = ["#0072b2", "#e69f00", "#009e73", "#cc79a7", "#d55e00", "#56b4e9"];

/// A place in the picture, in its own units.
pub(crate) type Place = (f64, f64);

/// Form of a mark: calibration and validation differ by more than colour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Shape {
    Circle,
    Diamond,
    Square,
    Triangle,
    /// A triangle on its corner.
    Inverted,
    Plus,
}

/// Forms of groups, which differ by more than their colour.
pub(crate) const SHAPES: [Shape; 6] =
    [Shape::Circle, Shape::Diamond, Shape::Square, Shape::Triangle, Shape::Inverted, Shape::Plus];

/// A picture being drawn.
pub(crate) struct Svg {
    out: String,
}

impl Svg {
    /// An empty picture with what it is and what it shows.
    pub fn new(id: &str, width: f64, height: f64, title: &str, description: &str) -> Self {
        let mut out = format!(
            "<svg viewBox=\"0 0 {width:.0} {height:.0}\" role=\"img\" aria-labelledby=\"{id}-title {id}-desc\">\n"
        );
        let _ = writeln!(out, "<title id=\"{id}-title\">{}</title>", escape(title));
        let _ = writeln!(out, "<desc id=\"{id}-desc\">{}</desc>", escape(description));
        Self { out }
    }

    /// A straight line.
    pub fn line(&mut self, class: &str, a: Place, b: Place) {
        let (x1, y1, x2, y2) = (px(a.0), px(a.1), px(b.0), px(b.1));
        let _ = writeln!(self.out, "<line class=\"{class}\" x1=\"{x1}\" y1=\"{y1}\" x2=\"{x2}\" y2=\"{y2}\"/>");
    }

    /// A rectangle with a tooltip.
    pub fn rect(&mut self, class: &str, corner: Place, size: Place, tooltip: &str) {
        let (x, y, w, h) = (px(corner.0), px(corner.1), px(size.0), px(size.1));
        let _ = write!(self.out, "<rect class=\"{class}\" x=\"{x}\" y=\"{y}\" width=\"{w}\" height=\"{h}\"");
        self.close("rect", tooltip);
    }

    /// A square of a colour of the program's own, with a tooltip.
    pub fn cell(&mut self, corner: Place, side: f64, fill: &str, tooltip: &str) {
        self.bar(corner, (side, side), fill, tooltip);
    }

    /// The same of a rectangle.
    pub fn bar(&mut self, corner: Place, size: Place, fill: &str, tooltip: &str) {
        let (x, y, w, h) = (px(corner.0), px(corner.1), px(size.0), px(size.1));
        let _ = write!(self.out, "<rect x=\"{x}\" y=\"{y}\" width=\"{w}\" height=\"{h}\" fill=\"{fill}\"");
        self.close("rect", tooltip);
    }

    /// A circle or diamond with a tooltip; `fill` is a colour of the program's own, empty to leave it to the class.
    pub fn mark(&mut self, shape: Shape, class: &str, at: Place, radius: f64, fill: &str, tooltip: &str) {
        let fill = if fill.is_empty() { String::new() } else { format!(" fill=\"{fill}\"") };
        self.shaped(shape, class, at, radius, &fill, tooltip);
    }

    /// A mark of a picture that turns, and its place from the middle in mm.
    pub fn mark_in_space(&mut self, shape: Shape, class: &str, at: Place, radius: f64, place: Vector, tooltip: &str) {
        self.shaped(shape, class, at, radius, &in_space(&[place]), tooltip);
    }

    /// A line of a picture that turns, and the places of its ends from the middle in mm.
    pub fn line_in_space(&mut self, class: &str, a: Place, b: Place, ends: [Vector; 2]) {
        let (x1, y1, x2, y2) = (px(a.0), px(a.1), px(b.0), px(b.1));
        let ends = in_space(&ends);
        let _ = writeln!(self.out, "<line class=\"{class}\" x1=\"{x1}\" y1=\"{y1}\" x2=\"{x2}\" y2=\"{y2}\"{ends}/>");
    }

    /// A text of a picture that turns.
    pub fn text_in_space(&mut self, class: &str, (x, y): Place, place: Vector, text: &str) {
        let (x, y, at) = (px(x), px(y), in_space(&[place]));
        let _ = writeln!(self.out, "<text class=\"{class}\" x=\"{x}\" y=\"{y}\"{at}>{}</text>", escape(text));
    }

    /// Lets a script turn the picture: azimuth and elevation in rad, units for each mm.
    pub fn turns(&mut self, azimuth_rad: f64, elevation_rad: f64, scale: f64) {
        let data = format!("<svg data-turn=\"{azimuth_rad} {elevation_rad} {scale:.6}\" ");
        self.out = self.out.replacen("<svg ", &data, 1);
    }

    /// What stands between these is shown where one of two ways to colour the marks is chosen.
    pub fn begin(&mut self, class: &str) {
        let _ = writeln!(self.out, "<g class=\"{class}\">");
    }

    pub fn end(&mut self) {
        self.out.push_str("</g>\n");
    }

    fn shaped(&mut self, shape: Shape, class: &str, (x, y): Place, radius: f64, fill: &str, tooltip: &str) {
        let corners: Vec<Place> = match shape {
            Shape::Circle => {
                let (x, y, r) = (px(x), px(y), px(radius));
                let _ = write!(self.out, "<circle class=\"{class}\" cx=\"{x}\" cy=\"{y}\" r=\"{r}\"{fill}");
                return self.close("circle", tooltip);
            }
            // all have about the area of the circle
            Shape::Diamond => {
                let half = 1.25 * radius;
                vec![(x, y - half), (x + half, y), (x, y + half), (x - half, y)]
            }
            Shape::Square => {
                let half = 0.89 * radius;
                vec![(x - half, y - half), (x + half, y - half), (x + half, y + half), (x - half, y + half)]
            }
            Shape::Triangle => {
                let half = 1.35 * radius;
                vec![(x, y - half), (x + half, y + 0.73 * half), (x - half, y + 0.73 * half)]
            }
            Shape::Inverted => {
                let half = 1.35 * radius;
                vec![(x, y + half), (x + half, y - 0.73 * half), (x - half, y - 0.73 * half)]
            }
            Shape::Plus => {
                let (arm, half) = (1.19 * radius, 0.4 * radius);
                let quarter = [(half, -arm), (half, -half), (arm, -half)];
                let turned = |k: u8, (u, v): Place| match k {
                    0 => (x + u, y + v),
                    1 => (x - v, y + u),
                    2 => (x - u, y - v),
                    _ => (x + v, y - u),
                };
                (0..4).flat_map(|k| quarter.map(|corner| turned(k, corner))).collect()
            }
        };
        let _ = write!(self.out, "<path class=\"{class}\" d=\"{}\"{fill}", outline(&corners));
        self.close("path", tooltip);
    }

    /// Arrows of one class as one path, each head shorter than its arrow.
    pub fn arrows(&mut self, class: &str, all: &[[Place; 2]]) {
        let mut path = String::new();
        for [a, b] in all {
            let length = (b.0 - a.0).hypot(b.1 - a.1);
            let _ = write!(path, "M{} {}L{} {}", px(a.0), px(a.1), px(b.0), px(b.1));
            if length > 0.5 {
                let (ux, uy, head) = ((b.0 - a.0) / length, (b.1 - a.1) / length, 4.5f64.min(0.6 * length));
                let back = |side: f64| (px(b.0 - head * ux - side * head * uy), px(b.1 - head * uy + side * head * ux));
                let ((x1, y1), (x2, y2)) = (back(0.4), back(-0.4));
                let _ = write!(path, "M{x1} {y1}L{} {}L{x2} {y2}", px(b.0), px(b.1));
            }
        }
        if !all.is_empty() {
            let _ = writeln!(self.out, "<path class=\"{class}\" fill=\"none\" d=\"{path}\"/>");
        }
    }

    /// An upright cross.
    pub fn cross(&mut self, class: &str, (x, y): Place, half: f64) {
        self.line(class, (x - half, y), (x + half, y));
        self.line(class, (x, y - half), (x, y + half));
    }

    /// An arrow from `a` to `b`, its head shorter than the arrow.
    pub fn arrow(&mut self, class: &str, a: Place, b: Place) {
        let (dx, dy) = (b.0 - a.0, b.1 - a.1);
        let length = dx.hypot(dy);
        if length > 0.0 {
            self.line(class, a, b);
        }
        if length > 0.5 {
            let (ux, uy) = (dx / length, dy / length);
            let head = 4.5f64.min(0.6 * length);
            let back = |side: f64| (b.0 - head * ux - side * head * uy, b.1 - head * uy + side * head * ux);
            self.line(class, b, back(0.4));
            self.line(class, b, back(-0.4));
        }
    }

    /// A text; the class states where it is anchored.
    pub fn text(&mut self, class: &str, (x, y): Place, text: &str) {
        let _ = writeln!(self.out, "<text class=\"{class}\" x=\"{}\" y=\"{}\">{}</text>", px(x), px(y), escape(text));
    }

    /// A text that reads upwards, around its middle.
    pub fn text_upwards(&mut self, (x, y): Place, text: &str) {
        let (x, y) = (px(x), px(y));
        let turn = format!("transform=\"rotate(-90 {x} {y})\"");
        let _ = writeln!(self.out, "<text class=\"mid\" x=\"{x}\" y=\"{y}\" {turn}>{}</text>", escape(text));
    }

    /// A text that reads upwards and ends here.
    pub fn text_below(&mut self, (x, y): Place, text: &str) {
        let (x, y) = (px(x), px(y));
        let turn = format!("transform=\"rotate(-90 {x} {y})\"");
        let _ = writeln!(self.out, "<text class=\"end\" x=\"{x}\" y=\"{y}\" {turn}>{}</text>", escape(text));
    }

    /// The whole element.
    pub fn finish(mut self) -> String {
        self.out.push_str("</svg>");
        self.out
    }

    fn close(&mut self, element: &str, tooltip: &str) {
        let _ = match tooltip {
            "" => writeln!(self.out, "/>"),
            _ => writeln!(self.out, "><title>{}</title></{element}>", escape(tooltip)),
        };
    }
}

/// Places from the middle, in whole millimetres or their tenths, which a script turns.
fn in_space(places: &[Vector]) -> String {
    let all: Vec<String> = places.iter().flatten().map(|v| px(*v)).collect();
    format!(" data-at=\"{}\"", all.join(" "))
}

/// A closed path, each corner from the one before it: a third shorter than with all places in full.
fn outline(corners: &[Place]) -> String {
    let mut out = String::new();
    for (i, corner) in corners.iter().enumerate() {
        let (mark, from) = match i.checked_sub(1).and_then(|before| corners.get(before)) {
            Some(before) => (if i == 1 { "l" } else { " " }, *before),
            None => ("M", (0.0, 0.0)),
        };
        let y = px(corner.1 - from.1);
        let gap = if y.starts_with('-') { "" } else { " " };
        let x = px(corner.0 - from.0);
        let mark = if mark == " " && x.starts_with('-') { "" } else { mark };
        out.extend([mark, &x, gap, &y]);
    }
    out + "z"
}

/// One decimal is a tenth of a dot of the screen.
fn px(value: f64) -> String {
    let value = crate::number::fixed(if value.is_finite() { value.clamp(-1e5, 1e5) } else { 0.0 }, 1);
    value.strip_suffix(".0").map_or_else(|| value.clone(), str::to_owned)
}

/// Text as it may stand between tags and in quotes; control characters replaced.
pub(crate) fn escape(text: &str) -> String {
    let printable: String = text.chars().map(|c| if c.is_control() { '\u{fffd}' } else { c }).collect();
    quick_xml::escape::escape(printable).into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_cannot_leave_their_element() {
        let hostile = "</title><script>alert(\"1\")</script>&'\0";
        let mut svg = Svg::new("p", 10.0, 10.0, hostile, hostile);
        svg.text("mid", (0.0, 0.0), hostile);
        svg.text_upwards((0.0, 0.0), hostile);
        svg.mark(Shape::Circle, "c", (0.0, 0.0), 1.0, "", hostile);
        svg.mark(Shape::Diamond, "c", (0.0, 0.0), 1.0, "#fff", hostile);
        svg.rect("bar", (0.0, 0.0), (1.0, 1.0), hostile);
        let out = svg.finish();
        let safe = "&lt;/title&gt;&lt;script&gt;alert(&quot;1&quot;)&lt;/script&gt;&amp;&apos;\u{fffd}";
        assert_eq!(out.matches(safe).count(), 7);
        assert!(!out.contains("<script") && !out.contains('\0'));
    }

    #[test]
    fn it_is_well_formed_xml() {
        let mut svg = Svg::new("p", 10.0, 10.0, "a & b", "<c>");
        svg.arrow("a", (0.0, 1.0), (1e300, 3.0));
        svg.line("a", (0.0, f64::NAN), (1.0, 1.0));
        svg.mark(Shape::Diamond, "c", (f64::INFINITY, 0.0), 1.0, "#fff", "tip");
        let text = svg.finish();
        let mut reader = quick_xml::Reader::from_str(&text);
        let mut elements = 0;
        loop {
            match reader.read_event().unwrap() {
                quick_xml::events::Event::Eof => break,
                quick_xml::events::Event::Empty(_) | quick_xml::events::Event::Start(_) => elements += 1,
                _ => {}
            }
        }
        assert_eq!(elements, 1 + 2 + 3 + 1 + 2);
        assert!(!text.contains("NaN") && !text.contains("inf") && !text.contains("xmlns"), "{text}");
    }
}
