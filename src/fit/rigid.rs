//! Best-fit rigid transform between two sets of corresponding points.

use super::cloud::{Cloud, Source};
use etalon_base::message::{Message, Result};
use etalon_base::pose::{Pose, Vector, dot, minus, norm};
use etalon_base::{error, warning};
use etalon_math::statistics::mean;
use etalon_math::symmetric_eigen;

/// A rigid transform fitted by least squares, with its residuals.
#[derive(Clone, Debug, PartialEq)]
pub struct RigidFit {
    /// Pose of the `from` frame in the `to` frame: p_to ≈ to_T_from p_from.
    pub to_T_from: Pose,
    /// Residuals p_to − to_T_from p_from of each point, in the `to` frame.
    pub residuals_mm: Vec<Vector>,
    /// Degrees of freedom, 3 n − 6.
    pub degrees_of_freedom: usize,
    /// Standard uncertainty of each coordinate of the centroid of the points in `to`, from the
    /// residuals.
    pub centroid_uncertainty_mm: f64,
    /// Standard uncertainty of the rotation about its most uncertain axis, from the residuals.
    pub rotation_uncertainty_rad: f64,
    /// Warnings for users of the numbers.
    pub warnings: Vec<Message>,
}

impl RigidFit {
    /// Length of the residual of each point.
    pub fn distances_mm(&self) -> Vec<f64> {
        self.residuals_mm.iter().map(|&r| norm(r)).collect()
    }

    /// Root mean square of the distances.
    pub fn rms_mm(&self) -> f64 {
        mean(self.residuals_mm.iter().map(|&r| dot(r, r))).sqrt()
    }
}

/// Finds the rigid transform that maps `from` onto `to`, point by point; at least three
/// non-collinear points are needed.
///
/// The rotation is the unit quaternion of the largest eigenvalue of a symmetric 4 × 4 matrix, so it
/// is never a reflection (Horn 1987, J. Opt. Soc. Am. A 4, 629).
pub fn rigid(from: &[Vector], to: &[Vector]) -> Result<RigidFit> {
    if from.len() != to.len() {
        return Err(error!("point-counts-differ", from = from.len(), to = to.len()).into());
    }
    let a = Cloud::centred("rigid-transform", 3, Source::Space(from.into()))?;
    let b = Cloud::centred("rigid-transform", 3, Source::Space(to.into()))?;
    a.spans("rigid-transform", 2)?;
    b.spans("rigid-transform", 2)?;
    let (values, vectors) = quaternions(a.points().zip(b.points()));
    let largest = values[3].abs().max(f64::MIN_POSITIVE);
    if (values[3] - values[2]) <= 1e-12 * largest {
        return Err(error!("rotation-ambiguous").into());
    }
    let rotation = rotation_matrix(vectors[3]);
    let turn = Pose { rotation, translation_mm: [0.0; 3] };
    let translation_mm = minus(b.centre_mm, turn.rotate(a.centre_mm));
    // residuals about the centroids lose no digits far from the origin
    let residual = |(p, q): (Vector, Vector)| {
        let p = turn.rotate(p.map(|x| x * a.scale_mm));
        minus(q.map(|x| x * b.scale_mm), p)
    };
    let residuals_mm: Vec<Vector> = a.points().zip(b.points()).map(residual).collect();
    Ok(with_uncertainty(Pose { rotation, translation_mm }, residuals_mm, &a))
}

/// Rotation that best maps centred points onto others, pair by pair; one of several if it is not
/// unique.
pub fn rotation_onto(pairs: impl Iterator<Item = (Vector, Vector)>) -> [[f64; 3]; 3] {
    rotation_matrix(quaternions(pairs).1[3])
}

/// Eigenvalues and eigenvectors of Horn's N for pairs of centred points, ascending.
fn quaternions(pairs: impl Iterator<Item = (Vector, Vector)>) -> ([f64; 4], [[f64; 4]; 4]) {
    // S of Horn's section 4.A: sums of products of the coordinates
    let mut s = [[0.0; 3]; 3];
    for (p, q) in pairs {
        for (row, x) in s.iter_mut().zip(p) {
            for (s, y) in row.iter_mut().zip(q) {
                *s += x * y;
            }
        }
    }
    symmetric_eigen(horn(&s))
}

/// Horn's N, whose quadratic form is the sum of products after rotation by a quaternion.
fn horn(s: &[[f64; 3]; 3]) -> [[f64; 4]; 4] {
    let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = *s;
    [
        [xx + yy + zz, yz - zy, zx - xz, xy - yx],
        [yz - zy, xx - yy - zz, xy + yx, zx + xz],
        [zx - xz, xy + yx, yy - xx - zz, yz + zy],
        [xy - yx, zx + xz, yz + zy, zz - xx - yy],
    ]
}

/// Rotation matrix of a quaternion (w, x, y, z) (Horn 1987, 3.E).
fn rotation_matrix(q: [f64; 4]) -> [[f64; 3]; 3] {
    let length = q.iter().map(|x| x * x).sum::<f64>().sqrt();
    let [w, x, y, z] = q.map(|v| v / length);
    [
        [w * w + x * x - y * y - z * z, 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
        [2.0 * (x * y + w * z), w * w - x * x + y * y - z * z, 2.0 * (y * z - w * x)],
        [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), w * w - x * x - y * y + z * z],
    ]
}

#[allow(non_snake_case)]
fn with_uncertainty(to_T_from: Pose, residuals_mm: Vec<Vector>, from: &Cloud) -> RigidFit {
    let n = residuals_mm.len();
    let degrees_of_freedom = 3 * n - 6;
    let squares: f64 = residuals_mm.iter().map(|&r| dot(r, r)).sum();
    let sigma = (squares / degrees_of_freedom as f64).sqrt();
    // about the axis of smallest inertia: Σ of squared distances from the axis
    let inertia = from.spread[1].hypot(from.spread[2]) * from.scale_mm;
    let mut warnings = Vec::new();
    if sigma > 0.0 && sigma / inertia > 0.01 {
        warnings.push(warning!("rotation-uncertain", expanded_deg = (2.0 * sigma / inertia).to_degrees()));
    }
    RigidFit {
        to_T_from,
        residuals_mm,
        degrees_of_freedom,
        centroid_uncertainty_mm: sigma / (n as f64).sqrt(),
        rotation_uncertainty_rad: sigma / inertia,
        warnings,
    }
}
