//! Errors over the workspace (thesis, figures 3.8 to 3.10): colour and size of each mark say how large the error is.

use super::axis::{Axis, range};
use super::plane::{self, Plane, WIDTH};
use super::points;
use super::svg::{Place, Svg};
use crate::document::PointError;
use crate::report::model::Figure;
use crate::report::number::{self, Shown};
use crate::report::words::Words;
use std::collections::BTreeMap;

/// More marks than this hide each other.
const LIMIT: usize = 1000;

/// Marks nearer than this, in units of the picture, lie on one another.
const NEAR: f64 = 2.0;

/// Colours of increasing error: lightness falls all the way, so that print and every eye can order them.
const RAMP: [[f64; 3]; 4] = [[250.0, 205.0, 100.0], [226.0, 110.0, 70.0], [150.0, 40.0, 100.0], [45.0, 10.0, 75.0]];

/// Before and after, side by side, for every plane of the workspace.
pub(in crate::report) fn maps(errors: &[&PointError], planar: bool, words: &Words) -> Vec<Figure> {
    let of_plane = |&axes: &(usize, usize)| [map(errors, axes, false, words), map(errors, axes, true, words)];
    plane::planes(planar).iter().flat_map(of_plane).collect()
}

fn map(errors: &[&PointError], axes: (usize, usize), after: bool, words: &Words) -> Figure {
    let size: fn(&PointError) -> f64 = if after { points::after_mm } else { points::before_mm };
    let places: Vec<_> = errors.iter().map(|p| p.at_mm).collect();
    let plane = Plane::around(axes, &places);
    let largest = range(errors.iter().map(|p| size(p))).map_or(0.0, |r| r.1);
    let shown = number::shown("mm", largest);
    let scale = Axis::from_zero(largest * shown.factor, 0.0, 1.0);
    let top = format!("{} {}", number::significant(scale.high(), 2), shown.unit);
    let title = match after {
        false => words.fill("Position error before calibration, {0} plane", &[&plane::name(axes)]),
        true => words.fill("Position error after calibration, {0} plane", &[&plane::name(axes)]),
    };
    let largest = format!("{} {}", number::significant(largest * shown.factor, 3), shown.unit);
    let description =
        words.fill("Marks at the measured positions; colour and size from 0 to {0}; largest {1}.", &[&top, &largest]);
    let id = format!("map-{}-{}", if after { "after" } else { "before" }, plane::name(axes));
    let mut svg = Svg::new(&id, WIDTH, plane.height() + 48.0, &title, &description);
    plane.draw(&mut svg, words);
    // largest first: the small ones lie on top of the large ones
    let seen = seen(errors, size, |p| plane.at(p.at_mm));
    let drawn = points::thin(&seen, LIMIT, size);
    for p in &drawn {
        let share = scale.at(size(p) * shown.factor);
        let tip = points::tooltip(p, points::before_mm(p), points::after_mm(p), shown, words);
        svg.mark(points::shape(p), "map", plane.at(p.at_mm), radius(share), &colour(share), &tip);
    }
    legend(&mut svg, errors, &scale, shown, plane.height(), words);
    let places = match seen.len() < errors.len() {
        true => {
            let counts: [&dyn std::fmt::Display; 2] = [&errors.len(), &seen.len()];
            format!(" {}", words.fill("Of {0} errors the largest is drawn at each of {1} places.", &counts))
        }
        false => String::new(),
    };
    Figure {
        title,
        pair: format!("map-{}", plane::name(axes)),
        side: if after { "after" } else { "before" },
        svg: svg.finish(),
        caption: words.fill(
            "Colour and size of the marks from 0 to {0}, a scale of this picture's own; largest error {1}.",
            &[&top, &largest],
        ) + &places
            + &points::how_many(drawn.len(), seen.len(), words),
        ..Figure::default()
    }
}

/// The errors largest first, without those that a larger one of the same set hides: repeats and orientations of a position.
fn seen<'a>(
    errors: &[&'a PointError],
    size: fn(&PointError) -> f64,
    at: impl Fn(&PointError) -> Place,
) -> Vec<&'a PointError> {
    let mut sorted = errors.to_vec();
    sorted.sort_by(|a, b| size(b).total_cmp(&size(a)));
    let mut taken: BTreeMap<(bool, i64, i64), Vec<Place>> = BTreeMap::new();
    sorted.retain(|p| {
        let (set, (x, y)) = (points::is_validation(p), at(p));
        let (column, row) = ((x / NEAR) as i64, (y / NEAR) as i64);
        let mut around = (column - 1..=column + 1).flat_map(|c| (row - 1..=row + 1).map(move |r| (set, c, r)));
        let hidden = |other: &Place| (other.0 - x).hypot(other.1 - y) < NEAR;
        let free = !around.any(|cell| taken.get(&cell).is_some_and(|places| places.iter().any(hidden)));
        if free {
            taken.entry((set, column, row)).or_default().push((x, y));
        }
        free
    });
    sorted
}

fn legend(svg: &mut Svg, errors: &[&PointError], scale: &Axis, shown: Shown, top: f64, words: &Words) {
    let ticks = scale.ticks(5);
    let pitch = (WIDTH - 60.0) / ticks.len().max(1) as f64;
    for (i, (value, label)) in ticks.iter().enumerate() {
        let (x, share) = (30.0 + pitch * i as f64, scale.at(*value));
        svg.mark(super::svg::Shape::Circle, "map", (x, top + 14.0), radius(share), &colour(share), "");
        svg.text("start", (x + 10.0, top + 18.0), label);
    }
    svg.text("end", (WIDTH - 4.0, top + 18.0), shown.unit);
    for (i, (shape, _, name)) in points::sets(errors).into_iter().enumerate() {
        let x = 30.0 + 120.0 * i as f64;
        svg.mark(shape, "map", (x, top + 36.0), 4.5, "#ffffff", "");
        svg.text("start", (x + 10.0, top + 40.0), &words.say(name));
    }
}

/// The mark's area grows with the error.
fn radius(share: f64) -> f64 {
    1.8 + 5.0 * share.sqrt()
}

fn colour(share: f64) -> String {
    let place = share.clamp(0.0, 1.0) * (RAMP.len() - 1) as f64;
    let below = (place as usize).min(RAMP.len() - 2);
    let part = place - below as f64;
    let mix = |c: usize| (RAMP[below][c] + part * (RAMP[below + 1][c] - RAMP[below][c])).round() as u8;
    format!("#{:02x}{:02x}{:02x}", mix(0), mix(1), mix(2))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::tests::demo::point;

    #[test]
    fn larger_errors_are_darker() {
        let lightness = |share: f64| {
            let c = u32::from_str_radix(&colour(share)[1..], 16).unwrap();
            0.2126 * f64::from(c >> 16) + 0.7152 * f64::from(c >> 8 & 255) + 0.0722 * f64::from(c & 255)
        };
        let steps: Vec<_> = (0..=20).map(|i| lightness(f64::from(i) / 20.0)).collect();
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
        assert!(map.svg.contains("7.00 µm after"));
        assert!(map.caption.contains("Of 16 errors the largest is drawn at each of 2 places."), "{}", map.caption);
    }

    #[test]
    fn before_and_after_have_their_own_scale() {
        let errors = [point(1, [0.0; 3], [0.35, 0.0, 0.0], [0.002, 0.0, 0.0]), point(2, [9.0; 3], [1.2; 3], [0.0; 3])];
        let errors: Vec<_> = errors.iter().collect();
        let maps = maps(&errors, false, &Words::default());
        assert_eq!(maps.len(), 4);
        assert!(maps[0].caption.contains("from 0 to 2.5 mm"), "{}", maps[0].caption);
        assert!(maps[1].caption.contains("from 0 to 2.0 µm"), "{}", maps[1].caption);
        assert!(maps[3].title.contains("xz"));
        assert_eq!(maps[0].svg.matches("pose 1, cycle 1").count(), 1);
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
