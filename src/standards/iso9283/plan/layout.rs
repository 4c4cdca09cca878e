//! Test geometry: cube, test plane, poses P1 to P5 and paths (ISO 9283:1998 6; except for the poses
//! unverified against a bought copy) in a given workspace.

use etalon_base::error;
use etalon_base::message::Result;
use etalon_base::pose::{Vector, minus, norm, unit};
use std::f64::consts::TAU;

/// Diagonal planes of the cube that the standard offers, each with its corners in order.
pub const PLANES: [(&str, [usize; 4]); 4] = [
    ("C1-C2-C7-C8", [0, 1, 6, 7]),
    ("C2-C3-C8-C5", [1, 2, 7, 4]),
    ("C3-C4-C5-C6", [2, 3, 4, 5]),
    ("C4-C1-C6-C7", [3, 0, 5, 6]),
];

/// Distance of P2 to P5 from the ends of the diagonals, relative to the diagonal: (10 ± 2) %.
const FROM_END: f64 = 0.1;
/// Diameter of the large circle relative to the side of the cube, and of the small circle relative
/// to the large one.
const LARGE_CIRCLE: f64 = 0.8;
const SMALL_CIRCLE: f64 = 0.1;
/// Steps of the minimum posing time along the diagonal (mm); as many as fit are used.
const STEPS_MM: [f64; 7] = [-10.0, 20.0, -50.0, 100.0, -200.0, 500.0, -1000.0];

/// Layout of a test.
#[derive(Clone, Debug, PartialEq)]
pub struct Layout {
    /// Side of the cube; for planar robots, of the square.
    pub side_mm: f64,
    /// Corners C1 to C8. C1 to C4 go round the bottom from the smallest x and y, first along x; C5
    /// to C8 are above them. Planar robots have C1 to C4. The order in the standard's figure is
    /// unverified; the coordinates are unambiguous.
    pub corners_mm: Vec<Vector>,
    /// Corners of the test plane in order.
    pub plane: [usize; 4],
    /// Poses P1 to P5.
    pub poses_mm: [Vector; 5],
}

/// Lays out the largest cube in a box, with edges parallel to the axes; the test plane is one of
/// [`PLANES`]. A box without height is the workspace of a planar robot, with a square and no choice
/// of plane.
pub fn layout(low_mm: Vector, high_mm: Vector, plane: usize) -> Result<Layout> {
    let extent = minus(high_mm, low_mm);
    let planar = extent[2] == 0.0;
    let sides = if planar { &extent[..2] } else { &extent[..] };
    let side_mm = sides.iter().copied().fold(f64::INFINITY, f64::min);
    if !norm(extent).is_finite() || side_mm.is_nan() || side_mm <= 0.0 || plane >= PLANES.len() {
        return Err(error!("workspace-not-box").into());
    }
    let half = 0.5 * side_mm;
    let centre = [0, 1, 2].map(|k| 0.5 * (low_mm[k] + high_mm[k]));
    let ground = [[-half, -half], [half, -half], [half, half], [-half, half]];
    let corners_at = |z: f64| ground.map(|[x, y]| [centre[0] + x, centre[1] + y, centre[2] + z]);
    let corners_mm = if planar { corners_at(0.0).to_vec() } else { [corners_at(-half), corners_at(half)].concat() };
    let plane = if planar { [0, 1, 2, 3] } else { PLANES[plane].1 };
    let inner = |k: usize| {
        let (corner, opposite) = (corners_mm[plane[k]], corners_mm[plane[(k + 2) % 4]]);
        [0, 1, 2].map(|i| corner[i] + FROM_END * (opposite[i] - corner[i]))
    };
    Ok(Layout { side_mm, poses_mm: [centre, inner(0), inner(1), inner(2), inner(3)], corners_mm, plane })
}

impl Layout {
    /// Linear path from P2 to P4: 80 % of the diagonal.
    pub fn linear(&self) -> Vec<Vector> {
        vec![self.poses_mm[1], self.poses_mm[3]]
    }

    /// Closed rectangle E1-E2-E3-E4 for cornering: P2 to P5.
    pub fn rectangle(&self) -> Vec<Vector> {
        [1, 2, 3, 4, 1].map(|k| self.poses_mm[k]).to_vec()
    }

    /// Large and small circle about P1 in the test plane, each closed and made of `count` equal
    /// chords (at least 3).
    pub fn circles(&self, count: usize) -> [Vec<Vector>; 2] {
        let [a, b, _, d] = self.plane.map(|k| self.corners_mm[k]);
        let (u, v) = (unit(minus(b, a)).unwrap_or_default(), unit(minus(d, a)).unwrap_or_default());
        let count = count.max(3);
        [LARGE_CIRCLE, LARGE_CIRCLE * SMALL_CIRCLE].map(|share| {
            let radius = 0.5 * share * self.side_mm;
            let at = |i: usize| {
                let (sin, cos) = ((i % count) as f64 / count as f64 * TAU).sin_cos();
                [0, 1, 2].map(|k| self.poses_mm[0][k] + radius * (cos * u[k] + sin * v[k]))
            };
            (0..=count).map(at).collect()
        })
    }

    /// Poses of the minimum posing time: from P1 in fixed steps along the diagonal,
    /// as long as they stay between P2 and P4.
    pub fn posing(&self) -> Vec<Vector> {
        let [centre, p2, _, p4, _] = self.poses_mm;
        let Some(along) = unit(minus(p4, p2)) else { return Vec::new() };
        let reach = 0.5 * norm(minus(p4, p2));
        let mut place = 0.0;
        let mut poses = vec![centre];
        for step in STEPS_MM {
            place += step;
            if f64::abs(place) > reach {
                break;
            }
            poses.push([0, 1, 2].map(|k| centre[k] + place * along[k]));
        }
        poses
    }
}
