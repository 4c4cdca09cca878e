//! Workspace to scale: a plane with its axes, or space in a box that a script rotates.

use super::axis::{Axis, range};
use super::chart::{Frame, UNDER, left_margin};
use super::svg::{NARROW, Place, Spot, Svg};
use super::view::{ASLANT, Paper};
use crate::model::Figure;
use crate::number;
use crate::words::{Words, tr};
use etalon_base::pose::{Vector, minus, norm};

const RIGHT: f64 = NARROW - 12.0;
const TOP: f64 = 10.0;
/// Margin around the outermost points.
const MARGIN: f64 = 14.0;
const AXES: [&str; 3] = ["x", "y", "z"];

/// Two coordinates of the workspace, or all three.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Seen {
    Plane([usize; 2]),
    Space,
}

pub(crate) const XY: Seen = Seen::Plane([0, 1]);

impl Seen {
    /// Planes of a workspace: xy, and xz and yz if three-dimensional.
    pub fn planes(planar: bool) -> &'static [Self] {
        if planar { &[XY] } else { &[XY, Self::Plane([0, 2]), Self::Plane([1, 2])] }
    }

    /// Short name, for titles and identifiers.
    pub fn name(self) -> String {
        match self {
            Self::Plane(axes) => axes.map(|axis| AXES[axis]).concat(),
            Self::Space => "space".to_owned(),
        }
    }

    /// Length of a vector in the view.
    pub fn length(self, v: Vector) -> f64 {
        match self {
            Self::Plane([a, b]) => v[a].hypot(v[b]),
            Self::Space => norm(v),
        }
    }
}

enum Projection {
    Plane([usize; 2], Frame),
    Space { middle: Vector, half: Vector, paper: Paper },
}

/// Figure of the workspace.
pub(crate) struct Workspace {
    pub svg: Svg,
    /// Units of the figure per unit of the positions.
    pub scale: f64,
    projection: Projection,
}

impl Workspace {
    /// Draws the axes or the box around all positions (mm).
    pub fn new(seen: Seen, places_mm: &[Vector], words: &Words) -> Self {
        Self::with_unit(seen, places_mm, "mm", words)
    }

    /// Draws the axes or the box around positions in a unit.
    pub fn with_unit(seen: Seen, places: &[Vector], unit: &str, words: &Words) -> Self {
        match seen {
            Seen::Plane(axes) => Self::plane(axes, places, unit, words),
            Seen::Space => Self::space(places, words),
        }
    }

    /// Draws the axes of a square plane that shows all positions in a unit.
    fn plane(axes: [usize; 2], places: &[Vector], unit: &str, words: &Words) -> Self {
        let [[x0, x1], [y0, y1]] = axes.map(|axis| range(places.iter().map(|p| p[axis])).unwrap_or_default());
        // a single point gets one unit around it
        let span = (x1 - x0).max(y1 - y0).max(1.0);
        let fitted = |left: f64| {
            let room = RIGHT - left - 2.0 * MARGIN;
            let scale = room / (x1 - x0).max(0.75 * (y1 - y0)).max(0.2 * span);
            let height = ((y1 - y0) * scale).max(80.0) + 2.0 * MARGIN;
            let axis = |low: f64, high: f64, units: f64| {
                let (middle, half) = (0.5 * (low + high), 0.5 * units / scale);
                Axis::linear(middle - half, middle + half)
            };
            let (across, up) = (axis(x0, x1, RIGHT - left), axis(y0, y1, height));
            (scale, Frame { across, up, left, right: RIGHT, top: TOP, bottom: TOP + height })
        };
        // the labels of the vertical axis determine its position, and conversely
        let (_, first) = fitted(52.0);
        let (scale, frame) = fitted(left_margin(&first.up, AXES[axes[1]]));
        let mut svg = Svg::new(words, NARROW, frame.bottom + UNDER);
        let [along, upwards] = axes.map(|axis| tr!(words, "quantity-in-unit", quantity = AXES[axis], unit));
        frame.draw(&mut svg, [&along, &upwards], true);
        Self { svg, scale, projection: Projection::Plane(axes, frame) }
    }

    /// Draws the box around all positions. The drawing area encloses the sphere around this box, so
    /// that the box fits at any rotation.
    fn space(places: &[Vector], words: &Words) -> Self {
        let ends = [0, 1, 2].map(|i| range(places.iter().map(|p| p[i])).unwrap_or_default());
        let (middle, half) = (ends.map(|[a, b]| 0.5 * (a + b)), ends.map(|[a, b]| (0.5 * (b - a)).max(0.5)));
        let radius = norm(half);
        let paper = Paper::around(&[(-radius, -radius), (radius, radius)], NARROW, NARROW, 44.0);
        let mut svg = Svg::new(words, NARROW, NARROW);
        svg.turns(ASLANT.azimuth_rad, ASLANT.elevation_rad, paper.scale);
        let mut all = Self { svg, scale: paper.scale, projection: Projection::Space { middle, half, paper } };
        for axis in 0..3 {
            for (sj, sk) in [(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0)] {
                let mut signs = [-1.0; 3];
                (signs[(axis + 1) % 3], signs[(axis + 2) % 3]) = (sj, sk);
                let from = all.at([0, 1, 2].map(|i| middle[i] + signs[i] * half[i]));
                signs[axis] = 1.0;
                let to = all.at([0, 1, 2].map(|i| middle[i] + signs[i] * half[i]));
                all.svg.line(if sj + sk < 0.0 && sj == sk { "axis" } else { "grid" }, from, to);
            }
        }
        all
    }

    /// Position of a point.
    pub fn at(&self, p: Vector) -> Spot {
        match &self.projection {
            Projection::Plane([a, b], frame) => frame.at(p[*a], p[*b]).into(),
            Projection::Space { middle, paper, .. } => {
                let from_middle = minus(p, *middle);
                Spot { at: paper.at(ASLANT.flat(from_middle)), space: Some(from_middle) }
            }
        }
    }

    /// Last part of the line from the middle of a plane to its edge, towards a point outside;
    /// `None` for a point inside.
    pub fn towards(&self, p: Vector) -> Option<[Place; 2]> {
        let Projection::Plane([a, b], frame) = &self.projection else { return None };
        if frame.across.contains(p[*a]) && frame.up.contains(p[*b]) {
            return None;
        }
        let (x, y) = frame.at(p[*a], p[*b]);
        let (cx, cy) = (0.5 * (frame.left + frame.right), 0.5 * (frame.top + frame.bottom));
        let (dx, dy) = (x - cx, y - cy);
        let out = ((cx - frame.left) / dx.abs().max(1e-9)).min((cy - frame.top) / dy.abs().max(1e-9));
        Some([0.84, 0.97].map(|share| (cx + share * out * dx, cy + share * out * dy)))
    }

    /// Returns the figure. The axes of space are labelled last, so that marks do not cover the
    /// labels.
    pub fn figure(mut self, id: &str, title: String, description: String) -> Figure {
        if let Projection::Space { middle, half, .. } = self.projection {
            for (axis, name) in AXES.into_iter().enumerate() {
                let mut end = minus(middle, half);
                end[axis] = middle[axis] + half[axis];
                let spot = self.at(end).beside(0.0, 4.0);
                self.svg.text("mid over", spot, &format!("{name} {} mm", number::fixed(end[axis], 0)));
            }
        }
        self.svg.figure(id, title, description)
    }
}

#[cfg(test)]
mod tests {
    use super::super::svg::width;
    use super::*;

    fn frame(axes: [usize; 2], places: &[Vector]) -> (f64, Frame) {
        let drawn = Workspace::plane(axes, places, "mm", &Words::default());
        let Projection::Plane(_, frame) = drawn.projection else { panic!() };
        (drawn.scale, frame)
    }

    #[test]
    fn a_millimetre_is_as_long_across_as_up_and_all_places_are_inside() {
        let places: [Vector; 3] = [[-85.0, -40.0, 0.0], [85.0, 30.0, 0.0], [0.0, 0.0, 500.0]];
        for axes in [[0, 1], [0, 2]] {
            let (scale, frame) = frame(axes, &places);
            let (origin, x, up) = (frame.at(0.0, 0.0), frame.at(1.0, 0.0), frame.at(0.0, 1.0));
            assert!((x.0 - origin.0 - (origin.1 - up.1)).abs() < 1e-9 && (x.0 - origin.0 - scale).abs() < 1e-9);
            for place in places {
                let (x, y) = frame.at(place[axes[0]], place[axes[1]]);
                assert!(x > frame.left && x < RIGHT && y > TOP && y < frame.bottom, "{x} {y}");
            }
        }
    }

    #[test]
    fn the_last_label_stays_inside_the_picture() {
        for end in (2600..3100).step_by(5).map(f64::from) {
            let places = [[1900.0, 0.0, 0.0], [end, 900.0, 0.0]];
            let svg = Workspace::plane([0, 1], &places, "mm", &Words::default()).figure("p", "".into(), "".into()).svg;
            let Some((before, _)) = svg.split_once(">3000<") else { continue };
            let x: f64 =
                before.rsplit(" x=\"").next().and_then(|rest| rest.split('"').next()).unwrap().parse().unwrap();
            assert!(x + 0.5 * width("3000") <= NARROW + 0.05, "{end}: {x}");
        }
    }

    #[test]
    fn one_place_or_none_still_make_a_plane() {
        for places in [&[][..], &[[5.0, 5.0, 5.0]], &[[1e6, 0.0, 0.0]; 2]] {
            let (scale, frame) = frame([0, 1], places);
            assert!(scale.is_finite() && scale > 0.0 && frame.bottom < 960.0);
        }
    }
}
