//! Errors over the workspace (thesis, figures 3.8 to 3.10): the colour of a mark is its error on one scale for before and after, its size
//! the error as a share of the largest of the picture. On a page the colours can have the picture's own scale.

use super::axis::{Axis, range};
use super::plane::{self, Plane, WIDTH};
use super::points;
use super::svg::{Place, Shape, Svg};
use super::view::{ASLANT, Paper, View};
use crate::model::Figure;
use crate::number::{self, Shown};
use crate::words::Words;
use etalon_base::pose::{Vector, minus};
use etalon_documents::PointError;
use std::cmp::Reverse;
use std::collections::BTreeMap;

/// Marks nearer than this, in units of the picture, lie on one another.
const NEAR: f64 = 2.0;

/// Colours from no error to the largest: classes `o0` to `o15` of the common scale, `w0` to `w15` of a picture's own.
const LEVELS: usize = 16;

/// How a map shows the workspace.
#[derive(Clone, Copy)]
enum Seen {
    Plane((usize, usize)),
    Space,
}

/// Before and after, side by side: every plane of the workspace, and space where it has a third dimension.
pub(crate) fn maps(errors: &[&PointError], planar: bool, words: &Words) -> Vec<Figure> {
    let planes = plane::planes(planar).iter().map(|&axes| Seen::Plane(axes));
    let all = planes.chain((!planar).then_some(Seen::Space));
    let largest = |size: fn(&PointError) -> f64| range(errors.iter().map(|p| size(p))).map_or(0.0, |r| r.1);
    let common_mm = largest(points::before_mm).max(largest(points::after_mm));
    all.flat_map(|seen| [false, true].map(|after| map(errors, seen, after, common_mm, words))).collect()
}

/// A scale of errors from zero, and the unit that it is in.
pub(super) struct Scale {
    axis: Axis,
    shown: Shown,
}

impl Scale {
    pub fn to(largest_mm: f64) -> Self {
        let shown = number::shown("mm", largest_mm);
        Self { axis: Axis::from_zero(largest_mm * shown.factor, 0.0, 1.0), shown }
    }

    pub fn share(&self, mm: f64) -> f64 {
        self.axis.at(mm * self.shown.factor)
    }

    pub fn top(&self) -> String {
        format!("{} {}", number::significant(self.axis.high(), 2), self.shown.unit)
    }
}

pub(super) fn level(share: f64) -> usize {
    (share.clamp(0.0, 1.0) * (LEVELS - 1) as f64).round() as usize
}

fn map(errors: &[&PointError], seen_from: Seen, after: bool, common_mm: f64, words: &Words) -> Figure {
    let size: fn(&PointError) -> f64 = if after { points::after_mm } else { points::before_mm };
    let places: Vec<_> = errors.iter().map(|p| p.at_mm).collect();
    let largest_mm = range(errors.iter().map(|p| size(p))).map_or(0.0, |r| r.1);
    let (common, own) = (Scale::to(common_mm), Scale::to(largest_mm));
    let name = match seen_from {
        Seen::Plane(axes) => words.fill("{0} plane", &[&plane::name(axes)]),
        Seen::Space => words.say("in space"),
    };
    let title = match after {
        false => words.fill("Position error before calibration, {0}", &[&name]),
        true => words.fill("Position error after calibration, {0}", &[&name]),
    };
    let largest = format!("{} {}", number::significant(largest_mm * own.shown.factor, 3), own.shown.unit);
    let description = words.fill(
        "Marks at the measured positions: colour from 0 to {0}, one scale before and after; size from 0 to {1}, that of this picture; largest error {2}.",
        &[&common.top(), &own.top(), &largest],
    );
    let key = match seen_from {
        Seen::Plane(axes) => plane::name(axes),
        Seen::Space => "space".to_owned(),
    };
    let id = format!("map-{}-{key}", if after { "after" } else { "before" });
    let class = |p: &PointError| format!("map o{} w{}", level(common.share(size(p))), level(own.share(size(p))));
    let (mut svg, drawn, seen, bottom) = match seen_from {
        Seen::Plane(axes) => {
            let plane = Plane::around(axes, &places);
            let mut svg = Svg::new(&id, WIDTH, plane.height() + 48.0, &title, &description);
            plane.draw(&mut svg, words);
            let (seen, drawn) = chosen(errors, size, |p| plane.at(p.at_mm));
            for p in &drawn {
                let tip = points::tooltip(p, words);
                svg.mark(points::shape(p), &class(p), plane.at(p.at_mm), radius(own.share(size(p))), "", &tip);
            }
            (svg, drawn.len(), seen, plane.height())
        }
        Seen::Space => {
            let space = Space::around(&places);
            let mut svg = Svg::new(&id, WIDTH, WIDTH + 48.0, &title, &description);
            space.draw(&mut svg);
            let (seen, drawn) = chosen(errors, size, |p| space.at(minus(p.at_mm, space.middle)));
            for p in &drawn {
                let (tip, place) = (points::tooltip(p, words), minus(p.at_mm, space.middle));
                let radius = radius(own.share(size(p)));
                svg.mark_in_space(points::shape(p), &class(p), space.at(place), radius, place, &tip);
            }
            space.name_ends(&mut svg);
            (svg, drawn.len(), seen, WIDTH)
        }
    };
    scales(&mut svg, [&common, &own], bottom);
    for (i, (shape, _, name)) in points::sets(errors).into_iter().enumerate() {
        let x = 30.0 + 120.0 * i as f64;
        svg.mark(shape, "map", (x, bottom + 36.0), 4.5, "#ffffff", "");
        svg.text("start", (x + 10.0, bottom + 40.0), &words.say(name));
    }
    let hidden = match seen < errors.len() && drawn == seen {
        true => {
            let counts: [&dyn std::fmt::Display; 2] = [&errors.len(), &seen];
            format!(" {}", words.fill("Of {0} errors the largest is drawn at each of {1} places.", &counts))
        }
        false => points::how_many(drawn, errors.len(), words),
    };
    Figure {
        title,
        pair: format!("map-{key}"),
        side: if after { "after" } else { "before" },
        scaled: true,
        svg: svg.finish(),
        caption: description + &hidden,
        ..Figure::default()
    }
}

/// How many errors no larger one hides, and those that are drawn, largest first: the small ones lie on top of the large ones.
fn chosen<'a>(
    errors: &[&'a PointError],
    size: fn(&PointError) -> f64,
    at: impl Fn(&PointError) -> Place,
) -> (usize, Vec<&'a PointError>) {
    let seen = seen(errors, size, at);
    let mut drawn = points::readable(&seen);
    largest_first(&mut drawn, size);
    (seen.len(), drawn)
}

fn largest_first(errors: &mut [&PointError], size: fn(&PointError) -> f64) {
    // bits of numbers that are not negative are in the order of the numbers
    errors.sort_by_cached_key(|p| Reverse(size(p).to_bits()));
}

/// The workspace from a direction, within a sphere, so that it can be turned.
pub(super) struct Space {
    pub middle: Vector,
    half: Vector,
    paper: Paper,
}

impl Space {
    const VIEW: View = ASLANT;

    pub fn around(places: &[Vector]) -> Self {
        let ends = [0, 1, 2].map(|i| range(places.iter().map(|p| p[i])).unwrap_or((0.0, 0.0)));
        let (middle, half) = (ends.map(|(a, b)| 0.5 * (a + b)), ends.map(|(a, b)| (0.5 * (b - a)).max(0.5)));
        let radius = half.iter().map(|v| v * v).sum::<f64>().sqrt();
        // a square around a sphere: whichever way it is turned
        let paper = Paper::square(radius, WIDTH, 44.0);
        Self { middle, half, paper }
    }

    pub fn at(&self, from_middle: Vector) -> Place {
        self.paper.at(Self::VIEW.flat(from_middle))
    }

    /// The box around all places.
    pub fn draw(&self, svg: &mut Svg) {
        svg.turns(Self::VIEW.azimuth_rad, Self::VIEW.elevation_rad, self.paper.scale);
        let corner = |signs: [f64; 3]| [0, 1, 2].map(|i| signs[i] * self.half[i]);
        for axis in 0..3 {
            let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
            for (sj, sk) in [(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0)] {
                let mut from = [0.0; 3];
                (from[axis], from[j], from[k]) = (-1.0, sj, sk);
                let mut to = from;
                to[axis] = 1.0;
                let ends = [corner(from), corner(to)];
                let class = if sj < 0.0 && sk < 0.0 { "axis" } else { "grid" };
                svg.line_in_space(class, self.at(ends[0]), self.at(ends[1]), ends);
            }
        }
    }

    /// The names of its axes with their ends in mm, after the marks, which would cover them.
    pub fn name_ends(&self, svg: &mut Svg) {
        for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
            let mut at = self.half.map(|v| -v);
            at[axis] = self.half[axis];
            let value = number::fixed(self.middle[axis] + at[axis], 0);
            let (x, y) = self.at(at);
            svg.text_in_space("mid over", (x, y + 4.0), at, &format!("{name} {value} mm"));
        }
    }
}

/// The errors largest first, without those that a larger one of the same set hides: repeats and orientations of a position.
fn seen<'a>(
    errors: &[&'a PointError],
    size: fn(&PointError) -> f64,
    at: impl Fn(&PointError) -> Place,
) -> Vec<&'a PointError> {
    let mut sorted = errors.to_vec();
    largest_first(&mut sorted, size);
    let mut taken: BTreeMap<(bool, i64, i64), Vec<Place>> = BTreeMap::new();
    sorted.retain(|p| {
        let (set, (x, y)) = (points::is_validation(p), at(p));
        let (column, row) = ((x / NEAR) as i64, (y / NEAR) as i64);
        let mut around = (column - 1..=column + 1).flat_map(|c| (row - 1..=row + 1).map(move |r| (set, c, r)));
        let hidden = |other: &Place| (other.0 - x).powi(2) + (other.1 - y).powi(2) < NEAR * NEAR;
        let free = !around.any(|cell| taken.get(&cell).is_some_and(|places| places.iter().any(hidden)));
        if free {
            taken.entry((set, column, row)).or_default().push((x, y));
        }
        free
    });
    sorted
}

/// Both scales, of which a page shows the chosen one, and paper the common one.
pub(super) fn scales(svg: &mut Svg, [common, own]: [&Scale; 2], top: f64) {
    for (scale, class, letter) in [(common, "common", 'o'), (own, "own", 'w')] {
        svg.begin(class);
        let ticks = scale.axis.ticks(5);
        let pitch = (WIDTH - 60.0) / ticks.len().max(1) as f64;
        for (i, (value, label)) in ticks.iter().enumerate() {
            let (x, share) = (30.0 + pitch * i as f64, scale.axis.at(*value));
            let size = if letter == 'w' { radius(share) } else { 5.0 };
            svg.mark(Shape::Circle, &format!("map {letter}{}", level(share)), (x, top + 14.0), size, "", "");
            svg.text("start", (x + 10.0, top + 18.0), label);
        }
        svg.text("end", (WIDTH - 4.0, top + 18.0), scale.shown.unit);
        svg.end();
    }
}

/// The mark's area grows with the error.
fn radius(share: f64) -> f64 {
    1.8 + 5.0 * share.sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::demo::point;

    #[test]
    fn larger_errors_are_darker_and_every_level_has_a_colour_on_both_scales() {
        let css = include_str!("../html/picture.css");
        let lightness = |i: usize| {
            let hex = css.split(&format!(".o{i} {{ fill: #")).nth(1).expect("a colour");
            assert!(include_str!("../html/style.html").contains(&format!(".w{i} {{ fill: #{}", &hex[..6])));
            let c = u32::from_str_radix(&hex[..6], 16).unwrap();
            0.2126 * f64::from(c >> 16) + 0.7152 * f64::from(c >> 8 & 255) + 0.0722 * f64::from(c & 255)
        };
        let steps: Vec<_> = (0..LEVELS).map(lightness).collect();
        assert!(steps.windows(2).all(|w| w[0] > w[1] + 1.0), "{steps:?}");
    }

    #[test]
    fn of_marks_at_one_place_the_largest_is_drawn_and_the_caption_says_so() {
        let size = |i: i64| 0.001 * (1 + i % 7) as f64;
        let mut errors: Vec<_> =
            (0..15).map(|i| point(i, [0.001 * i as f64, 0.0, 0.0], [1.0; 3], [size(i), 0.0, 0.0])).collect();
        errors.push(point(99, [100.0, 80.0, 0.0], [1.0; 3], [0.001, 0.0, 0.0]));
        let map = &maps(&errors.iter().collect::<Vec<_>>(), true, &Words::default())[1];
        assert_eq!(map.svg.matches("cycle 1").count(), 2);
        // 1.73 mm before: millimetres, to two digits of the error after
        assert!(map.svg.contains("1.7321 mm before, 0.0070 mm after"));
        assert!(map.caption.contains("Of 16 errors the largest is drawn at each of 2 places."), "{}", map.caption);
    }

    #[test]
    fn before_and_after_have_one_scale_of_colours_and_their_own_beside_it() {
        let errors = [point(1, [0.0; 3], [0.35, 0.0, 0.0], [0.002, 0.0, 0.0]), point(2, [9.0; 3], [1.2; 3], [0.0; 3])];
        let errors: Vec<_> = errors.iter().collect();
        let maps = maps(&errors, false, &Words::default());
        assert_eq!(maps.len(), 8);
        for map in &maps {
            assert!(map.caption.contains("colour from 0 to 2.5 mm"), "{}", map.caption);
        }
        assert!(maps[1].caption.contains("size from 0 to 2.0 µm"), "{}", maps[1].caption);
        assert!(maps[3].title.contains("xz") && maps[5].title.contains("yz") && maps[7].title.contains("in space"));
        assert_eq!(maps[0].svg.matches("pose 1, cycle 1").count(), 1);
        // 2 µm are the least of the common colours, and the darkest of the picture's own
        assert!(maps[1].svg.contains("class=\"map o0 w15\""), "{}", maps[1].svg);
        assert!(maps[7].svg.contains("data-turn=") && maps[7].svg.contains("data-at="));
        let (mark, name) = (maps[7].svg.rfind("</circle>"), maps[7].svg.find(">x 9 mm<"));
        assert!(mark < name && mark.is_some(), "no mark covers the name of an axis: {}", maps[7].svg);
    }

    #[test]
    fn of_several_errors_at_one_place_the_largest_is_drawn() {
        let at = |pose, x: f64, after: f64| point(pose, [x, 0.0, 0.0], [1.0; 3], [after, 0.0, 0.0]);
        let errors = [at(1, 5.0, 0.001), at(2, 5.0, 0.003), at(3, 5.0, 0.002), at(4, 9.0, 0.001)];
        let map = &maps(&errors.iter().collect::<Vec<_>>(), true, &Words::default())[1];
        let drawn = |pose: i64| map.svg.contains(&format!("pose {pose}, "));
        assert_eq!([1, 2, 3, 4].map(drawn), [false, true, false, true]);
        assert!(map.caption.contains("the largest is drawn") && !map.caption.contains("evenly chosen"));
    }
}
