//! Errors over the workspace (thesis, figs. 3.8 to 3.10). Colour and size of a mark are its error
//! on one scale, common to before and after. A page can also show both on the figure's own scale.

use super::layer::*;
use std::cmp::Reverse;
use std::collections::BTreeMap;

/// Distance within which marks coincide (units of the figure).
const NEAR: f64 = 2.0;
/// Number of colours from zero to the largest error: classes `o0` to `o15` of the common scale,
/// `w0` to `w15` of the figure's own scale.
const LEVELS: usize = 16;

/// Errors of one quantity with the scale that is common to before and after.
struct Mapped<'a> {
    quantity: ErrorQuantity,
    errors: &'a [&'a PointError],
    common: Axis,
}

/// Figures before and after calibration for every quantity, for every plane of the workspace, and
/// for space if three-dimensional.
pub(crate) fn maps(errors: &[&PointError], planar: bool, words: &Words) -> Vec<Vec<Figure>> {
    let of_quantity = |(quantity, errors): (ErrorQuantity, Vec<&PointError>)| {
        let common = scale(errors.iter().flat_map(|p| [points::before_mm(p), points::after_mm(p)]));
        let mapped = Mapped { quantity, errors: &errors, common };
        let all = Seen::planes(planar).iter().copied().chain((!planar).then_some(Seen::Space));
        all.flat_map(|seen| [false, true].map(|after| map(&mapped, seen, after, words))).collect()
    };
    points::by_quantity(errors).into_iter().map(of_quantity).collect()
}

/// Colour scale from zero to the largest length (mm).
pub(super) fn scale(lengths_mm: impl IntoIterator<Item = f64>) -> Axis {
    Axis::from_zero("mm", largest(lengths_mm))
}

/// Largest length of a scale, with its unit.
pub(super) fn top(scale: &Axis) -> String {
    let shown = scale.display_unit();
    format!("{} {}", number::significant(scale.ends().1 * shown.factor, 2), shown.unit)
}

/// Class of a length on the common scale and on the figure's own scale.
pub(super) fn class([common, own]: [&Axis; 2], mm: f64) -> String {
    format!("map o{} w{}", level(common.share(mm)), level(own.share(mm)))
}

fn level(share: f64) -> usize {
    (share.clamp(0.0, 1.0) * (LEVELS - 1) as f64).round() as usize
}

fn map(mapped: &Mapped, seen: Seen, after: bool, words: &Words) -> Figure {
    let Mapped { quantity, errors, common } = mapped;
    let size = points::size(after);
    let own = scale(errors.iter().map(|p| size(p)));
    let mut map = Workspace::new(seen, &errors.iter().map(|p| p.at_mm).collect::<Vec<_>>(), words);
    let (visible, drawn) = chosen(errors, size, |p| map.at(p.at_mm).at);
    for p in &drawn {
        let class = class([common, &own], size(p));
        let look = Look::new(points::look(p).shape, &class);
        map.svg.mark(look, map.at(p.at_mm), radius(common.share(size(p))), &points::tooltip(p, words));
    }
    scales(&mut map.svg, Shape::Circle, [common, &own]);
    for (look, name) in points::sets(errors) {
        map.svg.legend(Look { class: "map", fill: "#ffffff", ..look }, &words.tr(&name));
    }
    let name = match seen {
        Seen::Plane(_) => tr!(words, "plane-named", plane = seen.name()),
        Seen::Space => tr!(words, "in-space"),
    };
    let of = words.tr(&quantity.phrase());
    let title = match (*quantity, after) {
        (ErrorQuantity::Position, false) => tr!(words, "position-error-before", plane = name),
        (ErrorQuantity::Position, true) => tr!(words, "position-error-after", plane = name),
        (_, false) => tr!(words, "error-before-in-plane", quantity = of, plane = name),
        (_, true) => tr!(words, "error-after-in-plane", quantity = of, plane = name),
    };
    let (largest_mm, own_top) = (length(largest(errors.iter().map(|p| size(p)))), top(&own));
    let description = tr!(words, "error-map-description", top = top(common), largest = largest_mm.clone());
    let of_own = tr!(words, "error-map-own-scale", top = own_top, largest = largest_mm);
    let hidden = match visible < errors.len() && drawn.len() == visible {
        true => {
            format!(" {}", tr!(words, "largest-errors-drawn", total = errors.len(), places = visible))
        }
        false => points::how_many(drawn.len(), errors.len(), words),
    };
    let (key, side) = (points::quantity_key(*quantity, &seen.name()), points::side(after));
    Figure {
        pair: format!("map-{key}"),
        side,
        scaled: true,
        caption: description.clone() + &hidden,
        caption_own: of_own + &hidden,
        ..map.figure(&format!("map-{side}-{key}"), title, description)
    }
}

/// Length with three significant digits and its unit.
pub(super) fn length(mm: f64) -> String {
    let shown = number::display_unit("mm", mm);
    format!("{} {}", number::significant(mm * shown.factor, 3), shown.unit)
}

/// Drawn errors, the largest first so that small marks lie on large ones, and number of visible
/// errors: errors hidden by a larger error of the same set (repeats and orientations of a position)
/// do not count.
fn chosen<'a>(
    errors: &[&'a PointError],
    size: fn(&PointError) -> f64,
    at: impl Fn(&PointError) -> Place,
) -> (usize, Vec<&'a PointError>) {
    // the bit patterns of non-negative numbers are in the order of the numbers
    let largest_first = |errors: &mut [&PointError]| errors.sort_by_cached_key(|p| Reverse(size(p).to_bits()));
    let mut visible = errors.to_vec();
    largest_first(&mut visible);
    let mut taken: BTreeMap<(bool, i64, i64), Vec<Place>> = BTreeMap::new();
    visible.retain(|p| {
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
    let mut drawn = points::readable(&visible);
    largest_first(&mut drawn);
    (visible.len(), drawn)
}

/// Draws both scales. A page shows the selected scale, paper the common scale.
pub(super) fn scales(svg: &mut Svg, shape: Shape, [common, own]: [&Axis; 2]) {
    let y = svg.row();
    for (scale, class, letter) in [(common, "common", 'o'), (own, "own", 'w')] {
        svg.group(class, |svg| {
            let ticks = scale.ticks(5);
            let pitch = (NARROW - 60.0) / ticks.len().max(1) as f64;
            for (i, (value, label)) in ticks.iter().enumerate() {
                let (x, share) = (30.0 + pitch * i as f64, scale.share(*value));
                let class = format!("map {letter}{}", level(share));
                svg.mark(Look::new(shape, &class), (x, y), radius(share), "");
                svg.number("start", (x + 10.0, y + 4.0), label);
            }
            svg.text("end", (NARROW - 4.0, y + 4.0), scale.display_unit().unit);
        });
    }
}

/// Radius of a mark; its area grows with the error, in the steps of the colours.
fn radius(share: f64) -> f64 {
    1.8 + 5.0 * (level(share) as f64 / (LEVELS - 1) as f64).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::demo::point;
    use crate::tests::luminance;

    /// Colours of a palette of the page.
    fn palette(css: &str, of: impl Fn(usize) -> String) -> Vec<[f64; 3]> {
        let colour = |i: usize| {
            let hex = &css.split(&of(i)).nth(1).expect("a colour")[..6];
            let c = u32::from_str_radix(hex, 16).unwrap();
            [c >> 16, c >> 8 & 255, c & 255].map(f64::from)
        };
        (0..LEVELS).map(colour).collect()
    }

    #[test]
    fn larger_errors_have_more_contrast_on_a_light_and_on_a_dark_page() {
        let (picture, page) = (include_str!("../html/picture.css"), include_str!("../html/style.html"));
        let (light, dark) = page.split_once("prefers-color-scheme: dark").unwrap();
        let paper = palette(picture, |i| format!(".o{i} {{ fill: #"));
        assert_eq!(paper, palette(light, |i| format!("--m{i}: #")), "paper and page have one palette");
        let light: Vec<f64> = paper.iter().map(luminance).collect();
        let dark: Vec<f64> = palette(dark, |i| format!("--m{i}: #")).iter().map(luminance).collect();
        assert!(light.windows(2).all(|w| w[0] > w[1] + 0.001), "{light:?}");
        assert!(dark.windows(2).all(|w| w[0] < w[1] - 0.001), "{dark:?}");
        // graphics have a contrast of three or more (WCAG 2.2, 1.4.11)
        let page = luminance(&[21.0, 24.0, 28.0]);
        assert!(dark.iter().all(|colour| (colour + 0.05) / (page + 0.05) >= 3.0), "{dark:?}");
        assert!((1.05 / (light[LEVELS - 1] + 0.05)) > 10.0);
    }

    #[test]
    fn sizes_of_the_page_are_those_of_the_marks() {
        let page = include_str!("../html/style.html");
        for i in 0..LEVELS {
            let size = radius(i as f64 / (LEVELS - 1) as f64);
            let rule = format!(".o{i} {{ --c: {size:.2} }} .w{i} {{ --w: {size:.2} }}");
            assert!(page.contains(&rule), "{rule}");
        }
    }

    #[test]
    fn of_marks_at_one_place_the_largest_is_drawn_and_the_caption_says_so() {
        let size = |i: i64| 0.001 * (1 + i % 7) as f64;
        let mut errors: Vec<_> =
            (0..15).map(|i| point(i, [0.001 * i as f64, 0.0, 0.0], [1.0; 3], [size(i), 0.0, 0.0])).collect();
        errors.push(point(99, [100.0, 80.0, 0.0], [1.0; 3], [0.001, 0.0, 0.0]));
        let map = &maps(&errors.iter().collect::<Vec<_>>(), true, &Words::default())[0][1];
        assert_eq!(map.svg.matches("cycle 1").count(), 2);
        // 1.73 mm before calibration: in mm, to two digits of the error after
        assert!(map.svg.contains("1.7321 mm before, 0.0070 mm after"));
        let largest = tr!(Words::default(), "largest-errors-drawn", places = 2, total = 16);
        assert!(map.caption.contains(&largest), "{}", map.caption);
    }

    #[test]
    fn before_and_after_have_one_scale_of_colours_and_one_each_beside_it() {
        let errors = [point(1, [0.0; 3], [0.35, 0.0, 0.0], [0.002, 0.0, 0.0]), point(2, [9.0; 3], [1.2; 3], [0.0; 3])];
        let errors: Vec<_> = errors.iter().collect();
        let maps = maps(&errors, false, &Words::default()).remove(0);
        assert_eq!(maps.len(), 8);
        for map in &maps {
            assert!(map.caption.contains("colour and size from 0 to 2.5 mm"), "{}", map.caption);
        }
        assert!(maps[1].caption_own.contains("colour and size from 0 to 2.0 µm"), "{}", maps[1].caption_own);
        let size = |map: &Figure, pose: i64| {
            let mark = map.svg.lines().find(|l| l.contains(&format!("pose {pose}, "))).unwrap();
            super::super::svg::numbers(mark, "circle", "r")[0]
        };
        assert!(size(&maps[0], 2) > 2.0 * size(&maps[1], 1), "sizes are on the scale of the colours");
        assert!(maps[3].title.contains("xz") && maps[5].title.contains("yz") && maps[7].title.contains("in space"));
        assert_eq!(maps[0].svg.matches("pose 1, cycle 1").count(), 1);
        // 2 µm has the lightest colour on the common scale, and the darkest on the figure's own
        assert!(maps[1].svg.contains("class=\"map o0 w15\""), "{}", maps[1].svg);
        assert!(maps[7].svg.contains("data-turn=") && maps[7].svg.contains("data-at="));
        let (mark, name) = (maps[7].svg.rfind("</circle>"), maps[7].svg.find(">x 9 mm<"));
        assert!(mark < name && mark.is_some(), "no mark covers the name of an axis: {}", maps[7].svg);
    }

    #[test]
    fn each_quantity_has_its_name_and_its_scale() {
        let mut errors = vec![point(1, [0.0; 3], [2.0, 0.0, 0.0], [0.1, 0.0, 0.0]); 2];
        errors[0].quantity = ErrorQuantity::Distance;
        errors[1].quantity = ErrorQuantity::Contact;
        errors[1].before_mm = [0.02, 0.0, 0.0];
        errors[1].after_mm = [0.01, 0.0, 0.0];
        let maps = maps(&errors.iter().collect::<Vec<_>>(), true, &Words::default());
        let titles: Vec<&str> = maps.iter().map(|of_one| of_one[1].title.as_str()).collect();
        assert_eq!(
            titles,
            ["Error after calibration: distance, xy plane", "Error after calibration: contact, xy plane"]
        );
        assert!(maps[0][0].caption.contains("from 0 to 2.0 mm") && maps[1][0].caption.contains("from 0 to 20 µm"));
        assert_ne!(maps[0][0].pair, maps[1][0].pair);
    }

    #[test]
    fn of_several_errors_at_one_place_the_largest_is_drawn() {
        let at = |pose, x: f64, after: f64| point(pose, [x, 0.0, 0.0], [1.0; 3], [after, 0.0, 0.0]);
        let errors = [at(1, 5.0, 0.001), at(2, 5.0, 0.003), at(3, 5.0, 0.002), at(4, 9.0, 0.001)];
        let map = &maps(&errors.iter().collect::<Vec<_>>(), true, &Words::default())[0][1];
        let drawn = |pose: i64| map.svg.contains(&format!("pose {pose}, "));
        assert_eq!([1, 2, 3, 4].map(drawn), [false, true, false, true]);
        assert!(map.caption.contains(&tr!(Words::default(), "largest-errors-drawn", places = 2, total = 4)));
    }
}
