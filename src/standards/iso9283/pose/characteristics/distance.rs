//! Distance accuracy AD and repeatability RD between two poses (ISO 9283:1998 7.3, unverified
//! against a bought copy).

use crate::iso9283::pose::test::{PosePair, PoseTest};
use crate::iso9283::statistics::sample::{SampleSpread, coordinates, spread, unwrapped, wrapped};
use etalon_base::error;
use etalon_base::message::Result;
use etalon_base::pose::{Vector, minus, norm};
use etalon_base::pose_name::PoseName;

/// Accuracy and repeatability of a commanded distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DistanceAccuracy {
    /// Mean attained distance.
    pub mean_mm: f64,
    /// AD_p: mean attained minus commanded distance.
    pub ad_mm: f64,
    /// AD_x, AD_y, AD_z: mean attained minus commanded absolute coordinate differences.
    pub ad_axis_mm: Vector,
    /// RD_p: three standard deviations of the attained distance.
    pub rd_mm: f64,
    /// RD_x, RD_y, RD_z.
    pub rd_axis_mm: Vector,
}

/// Distance between two poses of a test.
#[derive(Clone, Debug, PartialEq)]
pub struct PairDistance {
    /// Names of the two poses.
    pub poses: [PoseName; 2],
    /// Number of cycles with both poses.
    pub cycles: usize,
    /// AD and RD of the position.
    pub position: DistanceAccuracy,
    /// AD of each angle of the test; empty if angles of a pose are not separable.
    pub ad_angles_rad: Vec<f64>,
    /// RD of each angle of the test.
    pub rd_angles_rad: Vec<f64>,
    /// AD and RD of the angle between the orientations, if angles of a pose are not separable and
    /// their order is given.
    pub rotation_rad: Option<[f64; 2]>,
    spatial: bool,
}

impl PairDistance {
    /// Selects the coordinates that the robot has from AD_x to RD_z.
    pub fn coordinates(&self, of: Vector) -> Vec<f64> {
        coordinates(of, self.spatial)
    }
}

/// Distances of all pairs of commanded poses, from the cycles with exactly one visit of each; at
/// least two cycles are needed.
pub fn distances(test: &PoseTest) -> Result<Vec<PairDistance>> {
    let mut all = Vec::new();
    for (i, p) in test.poses.iter().enumerate() {
        for q in &test.poses[i + 1..] {
            let (Some(from), Some(to)) = (p.commanded_mm, q.commanded_mm) else { continue };
            let pairs = p.pairs(q);
            if pairs.len() < 2 {
                continue;
            }
            let positions = |of: fn(&PosePair) -> Vector| pairs.iter().map(of).collect::<Vec<_>>();
            let (first, second) = (positions(|v| v.from.position_mm), positions(|v| v.to.position_mm));
            let position = distance(&first, &second, [from, to])?;
            let is_inseparable = [p, q].iter().any(|pose| test.inseparable(pose).is_some());
            let separable = if is_inseparable { 0 } else { test.angles.len() };
            let rotation_rad = is_inseparable.then(|| test.rotation_distance_rad(p, q)).flatten();
            let turned = (0..separable).map(|k| {
                let (a, b): (Vec<f64>, Vec<f64>) =
                    pairs.iter().map(|v| (v.from.angles_rad[k], v.to.angles_rad[k])).unzip();
                angle_distance_rad(&a, &b, [p.commanded_rad[k], q.commanded_rad[k]])
            });
            let (ad_angles_rad, rd_angles_rad) = turned.unzip();
            let (poses, cycles, spatial) = ([p.pose, q.pose], pairs.len(), test.spatial);
            all.push(PairDistance { poses, cycles, position, ad_angles_rad, rd_angles_rad, rotation_rad, spatial });
        }
    }
    Ok(all)
}

/// Evaluates the distance between two poses that were visited in the same cycles, in order; at
/// least two cycles are needed.
pub fn distance(first_mm: &[Vector], second_mm: &[Vector], commanded_mm: [Vector; 2]) -> Result<DistanceAccuracy> {
    crate::iso9283::statistics::sample::positions(first_mm, 2, "distance")?;
    crate::iso9283::statistics::sample::positions(second_mm, 2, "distance")?;
    if first_mm.len() != second_mm.len() {
        return Err(error!("distance-counts-differ", first = first_mm.len(), second = second_mm.len()).into());
    }
    let attained: Vec<Vector> = first_mm.iter().zip(second_mm).map(|(p, q)| minus(*p, *q)).collect();
    let commanded = minus(commanded_mm[0], commanded_mm[1]);
    let total = spread(&attained.iter().map(|&d| norm(d)).collect::<Vec<_>>());
    let axes: [SampleSpread; 3] = [0, 1, 2].map(|k| spread(&attained.iter().map(|d| d[k].abs()).collect::<Vec<_>>()));
    Ok(DistanceAccuracy {
        mean_mm: total.mean,
        ad_mm: total.mean - norm(commanded),
        ad_axis_mm: [0, 1, 2].map(|k| axes[k].mean - commanded[k].abs()),
        rd_mm: 3.0 * total.deviation,
        rd_axis_mm: axes.map(|axis| 3.0 * axis.deviation),
    })
}

/// AD_a and RD_a (rad) of the absolute differences of one angle; NaN with too few cycles.
pub fn angle_distance_rad(first_rad: &[f64], second_rad: &[f64], commanded_rad: [f64; 2]) -> (f64, f64) {
    let differences: Vec<f64> = first_rad.iter().zip(second_rad).map(|(a, b)| wrapped(a - b)).collect();
    let attained = spread(&unwrapped(&differences).iter().map(|d| d.abs()).collect::<Vec<_>>());
    (attained.mean - wrapped(commanded_rad[0] - commanded_rad[1]).abs(), 3.0 * attained.deviation)
}
