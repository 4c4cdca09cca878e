//! Covariance of predicted places.

use etalon_base::pose::Vector;
use etalon_identify::{Identification, Observation};
use etalon_robots::Robot;
use nalgebra::{DMatrix, DVector, Matrix3, SymmetricEigen};

/// Covariances (mm²) of the places of all targets at joint values, by the covariance of the
/// identified parameters (GUM 5.2.2); `None` without one.
pub(super) fn place_covariances(
    robot: &dyn Robot,
    found: &Identification,
    joints: &[f64],
) -> Option<Vec<Matrix3<f64>>> {
    let covariance = found.uncertainty.covariance.as_ref()?;
    let (n, d, m) = (found.values.len(), robot.dimension(), found.free.len());
    let mut jacobian = vec![0.0; d * robot.targets().len() * n];
    robot.jacobian(&found.values, joints, &mut jacobian);
    let place = |target: usize| {
        let mut all = Matrix3::zeros();
        let row = |axis: usize| -> Vec<f64> {
            let row = &jacobian[(target * d + axis) * n..][..n];
            found.free.iter().map(|&i| row[i]).collect()
        };
        let rows: Vec<Vec<f64>> = (0..d).map(row).collect();
        for (i, by) in rows.iter().enumerate() {
            let weighted: Vec<f64> =
                covariance.chunks_exact(m.max(1)).map(|line| line.iter().zip(by).map(|(c, j)| c * j).sum()).collect();
            for (k, other) in rows.iter().enumerate() {
                all[(i, k)] = other.iter().zip(&weighted).map(|(j, w)| j * w).sum();
            }
        }
        all
    };
    Some((0..robot.targets().len()).map(place).collect())
}

/// Standard uncertainty (mm) along the longest axis of the ellipsoid of a covariance (mm²).
pub(super) fn longest_axis_mm(covariance: &Matrix3<f64>) -> f64 {
    SymmetricEigen::new(*covariance).eigenvalues.max().max(0.0).sqrt()
}

/// Squared Mahalanobis distance of a difference (mm) under a covariance (mm²), along the axes of
/// the robot: two for a planar one.
pub(super) fn squared_distance(difference: Vector, covariance: &Matrix3<f64>, dimension: usize) -> Option<f64> {
    let v = DVector::from_iterator(dimension, difference.into_iter().take(dimension));
    let own = covariance.view((0, 0), (dimension, dimension)).into_owned();
    let solved = DMatrix::from(own).cholesky()?.solve(&v);
    Some(v.dot(&solved))
}

/// Derivatives of the places of the measured targets with respect to the identified parameters: a
/// row for each coordinate.
pub(super) fn rows(robot: &dyn Robot, found: &Identification, at: &Observation) -> DMatrix<f64> {
    let (n, d) = (found.values.len(), robot.dimension());
    let mut jacobian = vec![0.0; d * robot.targets().len() * n];
    robot.jacobian(&found.values, &at.joints, &mut jacobian);
    let measured: Vec<usize> =
        (0..robot.targets().len()).filter(|k| at.targets.get(*k).is_some_and(Option::is_some)).collect();
    let value = |row: usize, column: usize| {
        let target = measured[row / d];
        jacobian[(target * d + row % d) * n + found.free[column]]
    };
    DMatrix::from_fn(d * measured.len(), found.free.len(), value)
}

/// Returns the covariance of parameters after further readings with these derivatives and this
/// variance of a coordinate (mm²); `None` if the readings are singular.
pub(super) fn updated(covariance: &DMatrix<f64>, by: &DMatrix<f64>, variance: f64) -> Option<DMatrix<f64>> {
    let across = covariance * by.transpose();
    let readings = by * &across + DMatrix::identity(by.nrows(), by.nrows()) * variance;
    let gained = readings.cholesky()?.solve(&across.transpose());
    Some(covariance - across * gained)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Information adds: (C⁻¹ + JᵀJ/σ²)⁻¹.
    #[test]
    fn further_readings_add_their_information() {
        let covariance = DMatrix::from_row_slice(2, 2, &[4.0, 1.0, 1.0, 3.0]);
        let by = DMatrix::from_row_slice(3, 2, &[1.0, 0.5, -2.0, 1.0, 0.0, 3.0]);
        let information = covariance.clone().try_inverse().unwrap() + by.transpose() * &by / 0.25;
        let expected = information.try_inverse().unwrap();
        assert!((updated(&covariance, &by, 0.25).unwrap() - expected).amax() < 1e-12);
    }

    #[test]
    fn a_distance_is_in_standard_deviations_along_the_measured_axes() {
        let covariance = Matrix3::from_diagonal(&[4.0, 9.0, 1.0].into());
        assert!((squared_distance([2.0, 3.0, 2.0], &covariance, 3).unwrap() - 6.0).abs() < 1e-12);
        assert!((squared_distance([2.0, 3.0, 2.0], &covariance, 2).unwrap() - 2.0).abs() < 1e-12);
        assert!((longest_axis_mm(&covariance) - 3.0).abs() < 1e-12);
    }
}
