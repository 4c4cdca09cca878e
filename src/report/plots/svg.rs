//! Inline SVG, element by element; texts are escaped only here.

use crate::model::Figure;
use crate::words::Words;
use etalon_base::pose::Vector;
use std::fmt::Write;

/// Colours distinguishable by colour-blind readers (Okabe & Ito 2008).
pub(crate) const COLOURS: [&str; 6] = ["#0072b2", "#e69f00", "#009e73", "#cc79a7", "#d55e00", "#56b4e9"];

/// Position in the figure, in its own units.
pub(crate) type Place = (f64, f64);

/// Position on paper and, in a rotatable figure, in space (mm from the middle).
#[derive(Clone, Copy, Debug)]
pub(crate) struct Spot {
    pub at: Place,
    pub space: Option<Vector>,
}

impl From<Place> for Spot {
    fn from(at: Place) -> Self {
        Self { at, space: None }
    }
}

impl Spot {
    /// Moves the position on paper; its position in space is unchanged.
    pub fn beside(self, right: f64, down: f64) -> Self {
        Self { at: (self.at.0 + right, self.at.1 + down), ..self }
    }
}

/// Shape of a mark.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Shape {
    Circle,
    Diamond,
    Square,
    Triangle,
    /// Triangle on its corner.
    Inverted,
    Plus,
}

const SHAPES: [Shape; 6] =
    [Shape::Circle, Shape::Diamond, Shape::Square, Shape::Triangle, Shape::Inverted, Shape::Plus];

/// Shape, class and colour of a mark; an empty colour leaves it to the class.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Look<'a> {
    pub shape: Shape,
    pub class: &'a str,
    pub fill: &'a str,
}

/// Style of calibration poses.
pub(crate) const CALIBRATION: Look<'static> = Look::new(Shape::Circle, "cal");
/// Style of validation poses, and of highlighted marks.
pub(crate) const VALIDATION: Look<'static> = Look::new(Shape::Diamond, "val");

impl<'a> Look<'a> {
    pub const fn new(shape: Shape, class: &'a str) -> Self {
        Self { shape, class, fill: "" }
    }

    /// Style of a group by its number; groups differ by shape as well as colour.
    pub fn group(i: usize) -> Self {
        Self { shape: SHAPES[i % SHAPES.len()], class: "map", fill: COLOURS[i % COLOURS.len()] }
    }

    /// Style of a coloured square without a class.
    pub fn colour(fill: &'a str) -> Self {
        Self { shape: Shape::Square, class: "", fill }
    }

    fn attributes(self) -> String {
        [("class", self.class), ("fill", self.fill)]
            .iter()
            .filter(|(_, value)| !value.is_empty())
            .map(|(name, value)| format!("{name}=\"{value}\" "))
            .collect()
    }

    /// Corners of the mark, whose area is about the area of the circle; a circle has no corners.
    fn corners(self, (x, y): Place, radius: f64) -> Vec<Place> {
        let triangle = |up: f64| vec![(0.0, -1.35 * up), (1.35, 0.9855 * up), (-1.35, 0.9855 * up)];
        let unit = match self.shape {
            Shape::Circle => vec![],
            Shape::Diamond => vec![(0.0, -1.25), (1.25, 0.0), (0.0, 1.25), (-1.25, 0.0)],
            Shape::Square => vec![(-0.89, -0.89), (0.89, -0.89), (0.89, 0.89), (-0.89, 0.89)],
            Shape::Triangle => triangle(1.0),
            Shape::Inverted => triangle(-1.0),
            Shape::Plus => {
                let arm = [(0.4, -1.19), (0.4, -0.4), (1.19, -0.4)];
                let turned = |arm: &[Place; 3]| Some(arm.map(|(u, v)| (-v, u)));
                std::iter::successors(Some(arm), turned).take(4).flatten().collect()
            }
        };
        unit.into_iter().map(|(u, v)| (x + radius * u, y + radius * v)).collect()
    }
}

/// Width of a figure (units of the figure): the width of a phone, so that letters keep their size
/// there.
pub(crate) const NARROW: f64 = 380.0;
/// Width of a figure that occupies a whole row.
pub(crate) const WIDE: f64 = 760.0;
/// Height of a row of a legend or of bars.
pub(crate) const ROW: f64 = 20.0;
/// Width of a letter: 0.6 of its size (12 px).
pub(crate) const LETTER: f64 = 7.2;
/// Left end of a legend.
const LEGEND: f64 = 30.0;

/// Width of a text.
pub(crate) fn width(text: &str) -> f64 {
    LETTER * text.chars().count() as f64
}

/// Width of a text in a wide proportional font (DejaVu Sans, 12 px), for texts that may fill their
/// room.
pub(crate) fn proportional(text: &str) -> f64 {
    let of = |c: char| match c {
        ' ' | '\u{a0}' | '\u{202f}' | '.' | ',' | ':' | ';' | '\'' | '|' | 'i' | 'j' | 'l' | 'I' => 0.34,
        'f' | 't' | 'r' | '(' | ')' | '-' | '/' => 0.42,
        'm' | 'w' | 'M' | 'W' | '%' | '…' => 1.0,
        '±' | '<' | '>' | '=' | '+' | '→' => 0.84,
        _ => 0.64,
    };
    12.0 * text.chars().map(of).sum::<f64>()
}

/// Width of the longest text.
pub(crate) fn widest<'a>(texts: impl IntoIterator<Item = &'a str>) -> f64 {
    texts.into_iter().map(width).fold(0.0, f64::max)
}

/// A figure being drawn, with its legend below.
pub(crate) struct Svg {
    words: Words,
    out: String,
    /// Attribute that lets a script rotate the figure.
    turn: String,
    pub width: f64,
    height: f64,
    /// Left end of the next legend entry in the last row.
    next: f64,
}

impl Svg {
    pub fn new(words: &Words, width: f64, height: f64) -> Self {
        Self { words: *words, out: String::new(), turn: String::new(), width, height, next: f64::INFINITY }
    }

    /// Draws a straight line.
    pub fn line(&mut self, class: &str, a: impl Into<Spot>, b: impl Into<Spot>) {
        let spots = [a.into(), b.into()];
        let [(x1, y1), (x2, y2)] = spots.map(|s| (px(s.at.0), px(s.at.1)));
        let attributes = format!("class=\"{class}\" x1=\"{x1}\" y1=\"{y1}\" x2=\"{x2}\" y2=\"{y2}\"");
        self.element("line", &attributes, &spots, "");
    }

    /// Draws lines between consecutive positions.
    pub fn lines(&mut self, class: &str, places: &[Place]) {
        places.windows(2).for_each(|pair| self.line(class, pair[0], pair[1]));
    }

    /// Draws a rectangle with a tooltip.
    pub fn rect(&mut self, look: Look, corner: Place, size: Place, tooltip: &str) {
        let [x, y, w, h] = [corner.0, corner.1, size.0, size.1].map(px);
        let attributes = format!("{}x=\"{x}\" y=\"{y}\" width=\"{w}\" height=\"{h}\"", look.attributes());
        self.element("rect", &attributes, &[], tooltip);
    }

    /// Draws a mark with a tooltip.
    pub fn mark(&mut self, look: Look, spot: impl Into<Spot>, radius: f64, tooltip: &str) {
        let (spot, look_of) = (spot.into(), look.attributes());
        if look.shape == Shape::Circle {
            let [x, y, r] = [spot.at.0, spot.at.1, radius].map(px);
            return self.element("circle", &format!("{look_of}cx=\"{x}\" cy=\"{y}\" r=\"{r}\""), &[spot], tooltip);
        }
        let path = outline(&look.corners(spot.at, radius));
        self.element("path", &format!("{look_of}d=\"{path}\""), &[spot], tooltip);
    }

    /// Draws arrows of one class as a single path; each head is shorter than its arrow.
    pub fn arrows(&mut self, class: &str, all: &[[Place; 2]]) {
        let mut path = String::new();
        let to = |(x, y): Place| format!("{} {}", px(x), px(y));
        for [a, b] in all {
            let length = (b.0 - a.0).hypot(b.1 - a.1);
            let _ = write!(path, "M{}L{}", to(*a), to(*b));
            if length > 0.5 {
                let (ux, uy, head) = ((b.0 - a.0) / length, (b.1 - a.1) / length, 4.5f64.min(0.6 * length));
                let back = |side: f64| to((b.0 - head * (ux + side * uy), b.1 - head * (uy - side * ux)));
                let _ = write!(path, "M{}L{}L{}", back(0.4), to(*b), back(-0.4));
            }
        }
        if !all.is_empty() {
            self.element("path", &format!("class=\"{class}\" fill=\"none\" d=\"{path}\""), &[], "");
        }
    }

    /// Draws an upright cross.
    pub fn cross(&mut self, class: &str, (x, y): Place, half: f64) {
        self.line(class, (x - half, y), (x + half, y));
        self.line(class, (x, y - half), (x, y + half));
    }

    /// Draws the interval of a mark, if any, with a bar across each end.
    pub fn interval(&mut self, class: &str, at: Place, ends: impl IntoIterator<Item = Place>) {
        for (x, y) in ends {
            self.line(class, at, (x, y));
            self.line(class, (x - 4.0, y), (x + 4.0, y));
        }
    }

    /// Writes a text; the class gives its anchor.
    pub fn text(&mut self, class: &str, spot: impl Into<Spot>, text: &str) {
        let spot = spot.into();
        let (x, y, at) = (px(spot.at.0), px(spot.at.1), in_space(&[spot]));
        let _ = writeln!(self.out, "<text class=\"{class}\" x=\"{x}\" y=\"{y}\"{at}>{}</text>", escape(text));
    }

    /// Writes a number with the decimal mark of the language; the class gives its anchor.
    pub fn number(&mut self, class: &str, spot: impl Into<Spot>, number: &str) {
        let number = self.words.decimal(number.to_owned());
        self.text(class, spot, &number);
    }

    /// Writes a text that reads upwards.
    pub fn text_upwards(&mut self, class: &str, (x, y): Place, text: &str) {
        let (x, y, text) = (px(x), px(y), escape(text));
        let turn = format!("transform=\"rotate(-90 {x} {y})\"");
        let _ = writeln!(self.out, "<text class=\"{class}\" x=\"{x}\" y=\"{y}\" {turn}>{text}</text>");
    }

    /// Adds a mark with its name to the legend.
    pub fn legend(&mut self, look: Look, name: &str) {
        self.legend_mark(look, 4.5, name);
    }

    /// Adds a mark of this radius with its name to the legend.
    pub fn legend_mark(&mut self, look: Look, radius: f64, name: &str) {
        let (x, y) = self.entry(30.0, name);
        self.mark(look, (x, y), radius, "");
        self.text("start", (x + 10.0, y + 4.0), name);
    }

    /// Adds a line with its name to the legend.
    pub fn legend_line(&mut self, class: &str, name: &str) {
        let (x, y) = self.entry(48.0, name);
        self.line(class, (x - 5.0, y), (x + 17.0, y));
        self.text("start", (x + 24.0, y + 4.0), name);
    }

    /// Adds a row below the figure and returns its middle.
    pub fn row(&mut self) -> f64 {
        self.height += ROW;
        self.next = f64::INFINITY;
        self.height - 0.5 * ROW
    }

    /// Position of the next legend entry, in a new row if it does not fit.
    fn entry(&mut self, around: f64, name: &str) -> Place {
        let wide = around + width(name);
        if self.next + wide > self.width + 10.0 {
            self.row();
            self.next = LEGEND;
        }
        let x = self.next;
        self.next += wide;
        (x, self.height - 0.5 * ROW)
    }

    /// Draws a group of elements that a page shows or hides together.
    pub fn group(&mut self, class: &str, draw: impl FnOnce(&mut Self)) {
        let _ = writeln!(self.out, "<g class=\"{class}\">");
        draw(self);
        self.out.push_str("</g>\n");
    }

    /// Lets a script rotate the figure: azimuth and elevation (rad), units of the figure per mm.
    pub fn turns(&mut self, azimuth_rad: f64, elevation_rad: f64, scale: f64) {
        self.turn = format!("data-turn=\"{azimuth_rad} {elevation_rad} {scale:.6}\" ");
    }

    /// Returns the figure with its description, which is also its caption.
    pub fn figure(self, id: &str, title: String, description: String) -> Figure {
        let Self { out, turn, width, .. } = self;
        // margin below the last row of the legend
        let height = self.height + 4.0;
        let svg = format!(
            "<svg {turn}viewBox=\"0 0 {width:.0} {height:.0}\" role=\"img\" aria-labelledby=\"{id}-title {id}-desc\">\n\
             <title id=\"{id}-title\">{}</title>\n<desc id=\"{id}-desc\">{}</desc>\n{out}</svg>",
            escape(&title),
            escape(&description)
        );
        Figure { title, svg, caption: description, wide: width > NARROW, ..Figure::default() }
    }

    fn element(&mut self, name: &str, attributes: &str, spots: &[Spot], tooltip: &str) {
        let at = in_space(spots);
        let _ = match tooltip {
            "" => writeln!(self.out, "<{name} {attributes}{at}/>"),
            _ => writeln!(self.out, "<{name} {attributes}{at}><title>{}</title></{name}>", escape(tooltip)),
        };
    }
}

/// Attribute with positions in space for rotation by a script: mm from the middle, to 0.1 mm.
fn in_space(spots: &[Spot]) -> String {
    let all: Vec<String> = spots.iter().filter_map(|s| s.space).flatten().map(px).collect();
    if all.is_empty() { String::new() } else { format!(" data-at=\"{}\"", all.join(" ")) }
}

/// Closed path in relative coordinates, which are a third shorter than absolute ones.
fn outline(corners: &[Place]) -> String {
    let steps = corners.windows(2).map(|pair| format!("{} {}", px(pair[1].0 - pair[0].0), px(pair[1].1 - pair[0].1)));
    let steps = steps.collect::<Vec<_>>().join(" ").replace(" -", "-");
    corners.first().map_or_else(String::new, |(x, y)| format!("M{} {}l{steps}z", px(*x), px(*y)))
}

/// Coordinate with one decimal, a tenth of a screen pixel.
fn px(value: f64) -> String {
    let value = crate::number::fixed(if value.is_finite() { value.clamp(-1e5, 1e5) } else { 0.0 }, 1);
    value.strip_suffix(".0").map_or_else(|| value.clone(), str::to_owned)
}

/// Text escaped for element content and quoted attributes; control characters are replaced.
pub(crate) fn escape(text: &str) -> String {
    let printable: String = text.chars().map(|c| if c.is_control() { '\u{fffd}' } else { c }).collect();
    quick_xml::escape::escape(printable).into_owned()
}

/// Numbers of an attribute in all elements of a name, in order.
#[cfg(test)]
pub(crate) fn numbers(svg: &str, element: &str, attribute: &str) -> Vec<f64> {
    let number = |l: &str| l.split(&format!(" {attribute}=\"")).nth(1)?.split('"').next()?.parse().ok();
    svg.lines().filter(|l| l.starts_with(&format!("<{element}"))).filter_map(number).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_cannot_leave_their_element() {
        let hostile = "</title><script>alert(\"1\")</script>&'\0";
        let mut svg = Svg::new(&Words::default(), 10.0, 10.0);
        svg.text("mid", (0.0, 0.0), hostile);
        svg.text_upwards("mid", (0.0, 0.0), hostile);
        svg.mark(CALIBRATION, (0.0, 0.0), 1.0, hostile);
        svg.mark(Look::group(1), (0.0, 0.0), 1.0, hostile);
        svg.rect(CALIBRATION, (0.0, 0.0), (1.0, 1.0), hostile);
        let out = svg.figure("p", hostile.to_owned(), hostile.to_owned()).svg;
        let safe = "&lt;/title&gt;&lt;script&gt;alert(&quot;1&quot;)&lt;/script&gt;&amp;&apos;\u{fffd}";
        assert_eq!(out.matches(safe).count(), 7);
        assert!(!out.contains("<script") && !out.contains('\0'));
    }

    #[test]
    fn it_is_well_formed_xml() {
        let mut svg = Svg::new(&Words::default(), 10.0, 10.0);
        svg.arrows("a", &[[(0.0, 1.0), (1e300, 3.0)]]);
        svg.line("a", (0.0, f64::NAN), (1.0, 1.0));
        (0..6).for_each(|i| svg.mark(Look::group(i), (f64::INFINITY, 0.0), 1.0, "tip"));
        svg.group("own", |svg| svg.text("mid", (0.0, 0.0), "a < b"));
        let text = svg.figure("p", "a & b".to_owned(), "<c>".to_owned()).svg;
        let mut reader = quick_xml::Reader::from_str(&text);
        let mut elements = 0;
        loop {
            match reader.read_event().unwrap() {
                quick_xml::events::Event::Eof => break,
                quick_xml::events::Event::Empty(_) | quick_xml::events::Event::Start(_) => elements += 1,
                _ => {}
            }
        }
        assert_eq!(elements, 1 + 2 + 1 + 1 + 6 * 2 + 2);
        assert!(!text.contains("NaN") && !text.contains("inf") && !text.contains("xmlns"), "{text}");
    }
}
