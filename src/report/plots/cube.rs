//! The poses of a test in space or, of planar robots, in their plane; with the cube of ISO 9283:1998, 6, where they are laid into one.

use super::axis::range;
use super::map::Space;
use super::plane::{Plane, WIDTH};
use super::svg::{Shape, Svg};
use super::visits::of_pose;
use crate::model::Figure;
use crate::number;
use crate::words::Words;
use etalon_base::pose::{Vector, centroid, minus};
use etalon_base::pose_name::PoseName;
use etalon_documents::Iso9283Document;

/// Distance of P2 to P5 from the centre over half the diagonal: (10 ± 2) % of a diagonal from its ends.
const FROM_CENTRE: f64 = 0.8;
/// How far the coordinates of a pose from the centre may differ: 2 % of the diagonal over 80 % of its half.
const TOLERANCE: f64 = 0.05;
/// Height of poses in a plane over their extent.
const FLAT: f64 = 0.01;
/// More names than this hide each other.
const NAMED: usize = 12;

/// Where each pose was commanded or, where it was not, the mean of its visits.
fn places(document: &Iso9283Document) -> Vec<(PoseName, Vector)> {
    let place = |p: &etalon_documents::Iso9283Pose| {
        let mean = centroid(&of_pose(document, p.pose).map(|v| v.attained_mm).collect::<Vec<_>>())?;
        let off = [p.ap_x_mm, p.ap_y_mm, p.ap_z_mm].map(Option::unwrap_or_default);
        let at = minus(mean, off);
        at.iter().all(|v| v.is_finite()).then_some((p.pose, at))
    };
    document.poses.iter().filter_map(place).collect()
}

/// Centre and half the side of the cube (of planar robots the square) in which P1 is the centre and P2 to P5 are on the diagonals of
/// a plane through it; `None` where the poses are others.
fn cube(places: &[(PoseName, Vector)], planar: bool) -> Option<(Vector, f64)> {
    let [(_, centre), around @ ..] = places else { return None };
    let axes = if planar { 2 } else { 3 };
    let sizes: Vec<f64> = around.iter().flat_map(|(_, p)| minus(*p, *centre)[..axes].to_vec()).map(f64::abs).collect();
    let mean = sizes.iter().sum::<f64>() / sizes.len() as f64;
    let alike = around.len() == 4 && mean > 0.0 && sizes.iter().all(|v| (v / mean - 1.0).abs() < TOLERANCE);
    let middle = centroid(&around.iter().map(|(_, p)| *p).collect::<Vec<_>>())?;
    let opposite = (0..axes).all(|k| (middle[k] - centre[k]).abs() < TOLERANCE * mean);
    (alike && opposite).then_some((*centre, mean / FROM_CENTRE))
}

/// All poses, and the cube where there is one.
pub(crate) fn picture(document: &Iso9283Document, words: &Words) -> Option<Figure> {
    let places = places(document);
    let extent = |axis: usize| range(places.iter().map(|(_, p)| p[axis])).map_or(0.0, |(low, high)| high - low);
    let planar = extent(2) < FLAT * extent(0).max(extent(1));
    let cube = cube(&places, planar);
    let mut around: Vec<Vector> = places.iter().map(|(_, p)| *p).collect();
    if places.len() < 2 || !around.iter().flatten().all(|v| v.abs() < 1e7) {
        return None;
    }
    let title = words.say("Poses of the test");
    let caption = match cube {
        Some((_, half)) if planar => words.fill(
            "P1 is the centre of a square of {0} mm, P2 to P5 are on its diagonals (ISO 9283:1998, 6).",
            &[&number::fixed(2.0 * half, 1)],
        ),
        Some((_, half)) => words.fill(
            "P1 is the centre of a cube of {0} mm, P2 to P5 are on the diagonals of the test plane (ISO 9283:1998, 6).",
            &[&number::fixed(2.0 * half, 1)],
        ),
        None => words.say("The box is that of the poses, its edges are parallel to the axes."),
    };
    if let Some((centre, half)) = cube {
        around = [-half, half].iter().map(|d| centre.map(|v| v + d)).collect();
    }
    let tip = |(pose, p): &(PoseName, Vector)| {
        let [x, y, z] = p.map(|v| number::fixed(v, 3));
        words.fill("pose {0}: x {1}, y {2}, z {3} mm", &[pose, &x, &y, &z])
    };
    let named = |pose: &PoseName| if places.len() > NAMED { String::new() } else { format!("P{pose}") };
    // round the test plane
    let sides = || (1..5).map(|k| [places[k].1, places[k % 4 + 1].1]);
    let mut svg;
    if planar {
        let plane = Plane::around((0, 1), &around);
        svg = Svg::new("poses", WIDTH, plane.height(), &title, &caption);
        plane.draw(&mut svg, words);
        if let (Some(_), [low, high]) = (cube, &around[..]) {
            let corners = [*low, [high[0], low[1], 0.0], *high, [low[0], high[1], 0.0]];
            (0..4).for_each(|k| svg.line("axis", plane.at(corners[k]), plane.at(corners[(k + 1) % 4])));
        }
        for place in &places {
            let (x, y) = plane.at(place.1);
            svg.mark(Shape::Circle, "cal", (x, y), 4.0, "", &tip(place));
            svg.text("start over", (x + 7.0, y - 5.0), &named(&place.0));
        }
    } else {
        let space = Space::around(&around);
        svg = Svg::new("poses", WIDTH, WIDTH, &title, &caption);
        space.draw(&mut svg);
        let from_middle = |p: Vector| minus(p, space.middle);
        if cube.is_some() {
            for ends in sides().map(|ends| ends.map(from_middle)) {
                svg.line_in_space("arrow-cal", space.at(ends[0]), space.at(ends[1]), ends);
            }
        }
        for place in &places {
            let from = from_middle(place.1);
            let (x, y) = space.at(from);
            svg.mark_in_space(Shape::Circle, "cal", (x, y), 4.0, from, &tip(place));
            svg.text_in_space("start over", (x + 7.0, y - 5.0), from, &named(&place.0));
        }
        space.name_ends(&mut svg);
    }
    Some(Figure { title, svg: svg.finish(), caption, ..Figure::default() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cube_is_that_in_which_the_poses_were_laid_out() {
        let half = 300.0;
        let diagonals: [([[f64; 3]; 2], bool); 3] = [
            ([[-1.0, -1.0, -1.0], [1.0, -1.0, -1.0]], false),
            ([[1.0, -1.0, -1.0], [1.0, 1.0, -1.0]], false),
            ([[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0]], true),
        ];
        for ([a, b], planar) in diagonals {
            let corners = [[0.0; 3], a, b, a.map(|v| -v), b.map(|v| -v)];
            let at = |c: [f64; 3]| [0, 1, 2].map(|k| [50.0, 60.0, 70.0][k] + FROM_CENTRE * half * c[k]);
            let mut places: Vec<_> = (1..).zip(corners).map(|(i, c)| (PoseName::from(i), at(c))).collect();
            let (centre, found) = cube(&places, planar).unwrap();
            assert!((found - half).abs() < 1e-9 && centre == [50.0, 60.0, 70.0]);
            places[2].1[0] += 0.1 * half;
            assert_eq!(cube(&places, planar), None, "a pose elsewhere is not part of a cube");
            assert_eq!(cube(&places[..4], planar), None);
        }
    }
}
