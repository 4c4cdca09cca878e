//! Poses of a test in space or, for planar robots, in their plane, with the cube of ISO 9283:1998,
//! 6, if the poses lie in one.

use super::layer::*;
use super::visits::pose_visits;
use etalon_documents::Iso9283Document;

/// Distance of P2 to P5 from the centre relative to half the diagonal: (10 ± 2) % of a diagonal
/// from its ends.
const FROM_CENTRE: f64 = 0.8;
/// Tolerance of the coordinates relative to the centre: 2 % of the diagonal over 80 % of its half.
const TOLERANCE: f64 = 0.05;
/// Maximum height of coplanar poses relative to their extent.
const FLAT: f64 = 0.01;
/// Maximum number of legible names.
const NAMED: usize = 12;

/// Commanded position of each pose or, without one, mean of its visits.
fn places(document: &Iso9283Document) -> Vec<(PoseName, Vector)> {
    let place = |p: &etalon_documents::Iso9283Pose| {
        let mean = centroid(&pose_visits(document, p.pose).map(|v| v.attained_mm).collect::<Vec<_>>())?;
        let off = [p.ap_x_mm, p.ap_y_mm, p.ap_z_mm].map(Option::unwrap_or_default);
        let at = minus(mean, off);
        at.iter().all(|v| v.is_finite()).then_some((p.pose, at))
    };
    document.poses.iter().filter_map(place).collect()
}

/// Centre and half side of the cube (for planar robots the square) with P1 in the centre and P2 to
/// P5 on the diagonals of a plane through it; `None` for other poses.
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

/// All poses, and the cube if applicable.
pub(crate) fn picture(document: &Iso9283Document, words: &Words) -> Option<Figure> {
    let places = places(document);
    let extent = |axis: usize| range(places.iter().map(|(_, p)| p[axis])).map_or(0.0, |[low, high]| high - low);
    let planar = extent(2) < FLAT * extent(0).max(extent(1));
    let cube = cube(&places, planar);
    let mut around: Vec<Vector> = places.iter().map(|(_, p)| *p).collect();
    if places.len() < 2 || !around.iter().flatten().all(|v| v.abs() < 1e7) {
        return None;
    }
    if let Some((centre, half)) = cube {
        around = [-half, half].iter().map(|d| centre.map(|v| v + d)).collect();
    }
    let mut map = Workspace::new(if planar { XY } else { Seen::Space }, &around, words);
    // the square around coplanar poses, the test plane through spatial poses
    let (class, corners) = match (cube, &around[..]) {
        (None, _) => ("axis", Vec::new()),
        (_, [low, high]) if planar => ("axis", vec![*low, [high[0], low[1], 0.0], *high, [low[0], high[1], 0.0]]),
        _ => ("arrow-cal", places.iter().skip(1).map(|(_, p)| *p).collect()),
    };
    for (from, to) in corners.iter().zip(corners.iter().cycle().skip(1)) {
        map.svg.line(class, map.at(*from), map.at(*to));
    }
    for (pose, p) in &places {
        let [x, y, z] = p.map(|v| number::fixed(v, 3));
        let tip = tr!(words, "pose-tooltip", pose, x, y, z);
        map.svg.mark(CALIBRATION, map.at(*p), 4.0, &tip);
        if places.len() <= NAMED {
            let name = pose.to_string();
            // a number without a letter could be taken for a value
            let label = if name.parse::<i64>().is_ok() { format!("P{name}") } else { name };
            map.svg.text("start over", map.at(*p).beside(7.0, -5.0), &label);
        }
    }
    let description = match cube {
        Some((_, half)) if planar => tr!(words, "test-square", size = number::fixed(2.0 * half, 1)),
        Some((_, half)) => tr!(words, "test-cube", size = number::fixed(2.0 * half, 1)),
        None => tr!(words, "box-of-poses"),
    };
    Some(map.figure("poses", tr!(words, "poses-of-the-test"), description))
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
