//! Pose accuracy AP (ISO 9283:1998 7.2.1; thesis eq. 1.9 to 1.12).

use crate::iso9283::statistics::sample::{mean_position, spread, unwrapped, wrapped};
use etalon_base::message::Result;
use etalon_base::pose::{Vector, minus, norm};

/// Mean attained pose compared with the commanded pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PoseAccuracy {
    /// Barycentre of the attained positions.
    pub mean_mm: Vector,
    /// AP_x, AP_y, AP_z: barycentre minus commanded position.
    pub deviation_mm: Vector,
    /// AP_p: length of the deviation.
    pub ap_mm: f64,
}

/// Evaluates accuracy of position from at least one attained position.
///
/// # Examples
///
/// ```
/// use etalon_standards::iso9283::pose::accuracy::pose_accuracy;
///
/// // two cycles, whose barycentre is 0.03 mm in x and 0.04 mm in y from the commanded position
/// let commanded_mm = [100.0, 200.0, 300.0];
/// let attained_mm = [[100.02, 200.05, 300.0], [100.04, 200.03, 300.0]];
/// let accuracy = pose_accuracy(&attained_mm, commanded_mm)?;
/// assert!((accuracy.ap_mm - 0.05).abs() < 1e-12);
/// # Ok::<(), etalon_base::message::Problems>(())
/// ```
pub fn pose_accuracy(attained_mm: &[Vector], commanded_mm: Vector) -> Result<PoseAccuracy> {
    crate::iso9283::statistics::sample::positions(attained_mm, 1, "pose-accuracy")?;
    let mean_mm = mean_position(attained_mm);
    let deviation_mm = minus(mean_mm, commanded_mm);
    Ok(PoseAccuracy { mean_mm, deviation_mm, ap_mm: norm(deviation_mm) })
}

/// AP_a, AP_b or AP_c (rad), within half a turn; NaN without angles.
pub fn angle_accuracy_rad(attained_rad: &[f64], commanded_rad: f64) -> f64 {
    wrapped(spread(&unwrapped(attained_rad)).mean - commanded_rad)
}
