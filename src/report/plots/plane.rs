//! A plane of the workspace, drawn true to scale with its axes.

use super::axis::{Axis, range};
use super::svg::{Place, Svg};
use crate::words::Words;
use etalon_base::pose::Vector;

/// Width of a map, in units of the picture: that of a phone, so that letters keep their size there.
pub(crate) const WIDTH: f64 = 380.0;
const LEFT: f64 = 52.0;
const RIGHT: f64 = 12.0;
const TOP: f64 = 10.0;
/// room under the map for ticks and the axis' name
const UNDER: f64 = 40.0;
/// margin around the outermost points
const MARGIN: f64 = 14.0;

/// Two coordinates of the workspace on paper: one millimetre is as long across as up.
pub(crate) struct Plane {
    axes: (usize, usize),
    across: Axis,
    up: Axis,
    /// units of the picture per millimetre
    pub scale: f64,
    pub bottom: f64,
    /// what one unit of the places is called
    unit: &'static str,
}

/// The planes of a workspace: xy, and xz and yz where it has a third dimension.
pub(crate) fn planes(planar: bool) -> &'static [(usize, usize)] {
    if planar { &[(0, 1)] } else { &[(0, 1), (0, 2), (1, 2)] }
}

/// Name of a plane.
pub(crate) fn name(axes: (usize, usize)) -> String {
    format!("{}{}", axis_name(axes.0), axis_name(axes.1))
}

fn axis_name(axis: usize) -> &'static str {
    ["x", "y", "z"].get(axis).copied().unwrap_or("?")
}

impl Plane {
    /// A plane that shows all places (mm).
    pub fn around(axes: (usize, usize), places_mm: &[Vector]) -> Self {
        let coordinate = |axis: usize| range(places_mm.iter().map(|p| p[axis])).unwrap_or((0.0, 0.0));
        let ((x0, x1), (y0, y1)) = (coordinate(axes.0), coordinate(axes.1));
        // a lone point gets a millimetre around it
        let span = (x1 - x0).max(y1 - y0).max(1.0);
        let room = WIDTH - LEFT - RIGHT - 2.0 * MARGIN;
        let scale = room / (x1 - x0).max(0.75 * (y1 - y0)).max(0.2 * span);
        let height = ((y1 - y0) * scale).max(80.0) + 2.0 * MARGIN;
        let half = |pixels: f64| pixels / scale / 2.0;
        let (cx, cy) = ((x0 + x1) / 2.0, (y0 + y1) / 2.0);
        let (wx, wy) = (half(WIDTH - LEFT - RIGHT), half(height));
        let bottom = TOP + height;
        Self {
            axes,
            across: Axis::linear(cx - wx, cx + wx, LEFT, WIDTH - RIGHT),
            up: Axis::linear(cy - wy, cy + wy, bottom, TOP),
            scale,
            bottom,
            unit: "mm",
        }
    }

    /// The same plane where places are given in another unit than millimetres.
    pub fn in_unit(self, unit: &'static str) -> Self {
        Self { unit, ..self }
    }

    /// Height of map and axis names together: legends stand below.
    pub fn height(&self) -> f64 {
        self.bottom + UNDER
    }

    /// Where a point is drawn.
    pub fn at(&self, p_mm: Vector) -> Place {
        (self.across.at(p_mm[self.axes.0]), self.up.at(p_mm[self.axes.1]))
    }

    /// Whether a place is inside the map.
    pub fn contains(&self, p_mm: Vector) -> bool {
        let inside = |axis: &Axis, v: f64| (axis.low()..=axis.high()).contains(&v);
        inside(&self.across, p_mm[self.axes.0]) && inside(&self.up, p_mm[self.axes.1])
    }

    /// The last part of the way from the middle of the map to its edge, in the direction of a place outside.
    pub fn towards(&self, p_mm: Vector) -> (Place, Place) {
        let (x, y) = self.at(p_mm);
        let (cx, cy) = ((LEFT + WIDTH - RIGHT) / 2.0, (TOP + self.bottom) / 2.0);
        let (dx, dy) = (x - cx, y - cy);
        let out = ((cx - LEFT) / dx.abs().max(1e-9)).min((cy - TOP) / dy.abs().max(1e-9));
        let at = |share: f64| (cx + share * out * dx, cy + share * out * dy);
        (at(0.84), at(0.97))
    }

    /// Draws grid, ticks and names of the axes.
    pub fn draw(&self, svg: &mut Svg, words: &Words) {
        let right = WIDTH - RIGHT;
        for (value, label) in self.across.ticks(5) {
            let x = self.across.at(value);
            svg.line("grid", (x, TOP), (x, self.bottom));
            // a digit of the reports' font is 0.6 of its 12 px wide: the last label stays inside the picture
            let half = 3.7 * label.chars().count() as f64;
            svg.text("mid", (x.min(WIDTH - half), self.bottom + 15.0), &label);
        }
        for (value, label) in self.up.ticks(5) {
            let y = self.up.at(value);
            svg.line("grid", (LEFT, y), (right, y));
            svg.text("end", (LEFT - 5.0, y + 4.0), &label);
        }
        svg.line("axis", (LEFT, self.bottom), (right, self.bottom));
        svg.line("axis", (LEFT, TOP), (LEFT, self.bottom));
        let middle = ((LEFT + right) / 2.0, self.bottom + 32.0);
        let named = |axis: usize| words.fill("{0} in {1}", &[&axis_name(axis), &self.unit]);
        svg.text("mid", middle, &named(self.axes.0));
        svg.text_upwards((12.0, (TOP + self.bottom) / 2.0), &named(self.axes.1));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_millimetre_is_as_long_across_as_up_and_all_places_are_inside() {
        let places: [Vector; 3] = [[-85.0, -40.0, 0.0], [85.0, 30.0, 0.0], [0.0, 0.0, 500.0]];
        for axes in [(0, 1), (0, 2)] {
            let plane = Plane::around(axes, &places);
            let (origin, x) = (plane.at([0.0; 3]), plane.at([1.0, 0.0, 0.0]));
            let up = plane.at(if axes.1 == 1 { [0.0, 1.0, 0.0] } else { [0.0, 0.0, 1.0] });
            assert!((x.0 - origin.0 - (origin.1 - up.1)).abs() < 1e-9 && (x.0 - origin.0 - plane.scale).abs() < 1e-9);
            for place in places {
                let (x, y) = plane.at(place);
                assert!((LEFT..=WIDTH - RIGHT).contains(&x) && (TOP..=plane.bottom).contains(&y), "{x} {y}");
            }
        }
    }

    #[test]
    fn the_last_label_stays_inside_the_picture() {
        for end in (2600..3100).step_by(5).map(f64::from) {
            let mut svg = Svg::new("p", WIDTH, 400.0, "", "");
            Plane::around((0, 1), &[[1900.0, 0.0, 0.0], [end, 900.0, 0.0]]).draw(&mut svg, &Words::default());
            let svg = svg.finish();
            let Some((before, _)) = svg.split_once(">3000<") else { continue };
            let x: f64 = before.rsplit("x=\"").next().and_then(|rest| rest.split('"').next()).unwrap().parse().unwrap();
            assert!(x + 3.6 * 4.0 <= WIDTH, "{end}: {x}");
        }
    }

    #[test]
    fn one_place_or_none_still_make_a_plane() {
        for places in [&[][..], &[[5.0, 5.0, 5.0]], &[[1e6, 0.0, 0.0]; 2]] {
            let plane = Plane::around((0, 1), places);
            assert!(plane.scale.is_finite() && plane.scale > 0.0 && plane.height() < 1000.0);
        }
    }
}
