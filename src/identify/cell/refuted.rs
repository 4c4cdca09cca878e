//! Residuals that no plausible uncertainty explains: the answer is refuted.

use super::{Component, Measure, Quality, Stated, measure_index};
use crate::chi_square_exceeds;
use etalon_base::pose::{Pose, Vector, centroid, minus, norm};

/// Plausible standard uncertainties (mm, rad) of an uncalibrated robot and of its readings: they
/// are granted in addition to a given uncertainty.
const PLAUSIBLE: [f64; 2] = [2.0, 2.0 * std::f64::consts::PI / 180.0];
/// Minimum residual, as a share of the size of tool and motion, that refutes the data: residuals
/// are then as large as the data.
const SHARE: f64 = 0.1;

/// Size of the tool and of the motion.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Size {
    /// Length of the tool, or root mean square distance of the positions from their centroid (mm),
    /// whichever is larger.
    pub position_mm: f64,
    /// Root mean square angle between consecutive orientations (rad).
    pub rotation_rad: f64,
}

impl Size {
    /// Root mean square distance of points from their centroid, without rotation.
    pub fn from_points(points: &[Vector]) -> Self {
        let from = centroid(points).unwrap_or_default();
        Self { position_mm: root_mean_square(points.iter().map(|p| norm(minus(*p, from)))), rotation_rad: 0.0 }
    }

    /// Size of the motion of a tool through poses.
    pub fn from_poses(poses: &[Pose], tool_mm: Vector) -> Self {
        let positions: Vec<Vector> = poses.iter().map(|p| p.translation_mm).collect();
        let turns = poses.windows(2).map(|pair| pair[0].inverse().then(&pair[1]).angle_rad());
        Self {
            position_mm: Self::from_points(&positions).position_mm.max(norm(tool_mm)),
            rotation_rad: root_mean_square(turns),
        }
    }
}

fn root_mean_square(values: impl Iterator<Item = f64>) -> f64 {
    let (sum, count) = values.fold((0.0, 0.0), |(sum, count), v| (sum + v * v, count + 1.0));
    if count > 0.0 { f64::sqrt(sum / count) } else { 0.0 }
}

impl Quality {
    /// Measures whose residuals refute the answer.
    ///
    /// With a given uncertainty: chi-square exceeds the given and the plausible uncertainty
    /// together. In any case: residuals exceed the plausible uncertainty, and a tenth of the size
    /// of tool and motion.
    pub fn refuted<'a>(&'a self, stated: &'a Stated, size: Size) -> impl Iterator<Item = &'a Component> {
        self.components.iter().filter(move |component| {
            let k = measure_index(component.measure);
            let plausible = PLAUSIBLE[k];
            if component.agrees || component.redundancy < 0.5 || component.deviation <= plausible {
                return false;
            }
            let own = stated.largest(k).hypot(plausible);
            let squares = (component.deviation / own).powi(2) * component.redundancy;
            let exceeds = stated.is_stated(k) && chi_square_exceeds(squares, component.redundancy.round() as usize);
            let size = if component.measure == Measure::Position { size.position_mm } else { size.rotation_rad };
            exceeds || 3f64.sqrt() * component.deviation > SHARE * size
        })
    }
}
