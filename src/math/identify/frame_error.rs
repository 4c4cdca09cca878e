//! The uncertainty of frames: what is wrong with a frame is common to all observations that it places.

use super::residuals::Residuals;
use crate::math::solve::Solution;

/// The uncertainty of the frame in which observations are stated.
#[derive(Clone, Debug, PartialEq)]
pub struct FrameError {
    /// Pose and cycle that it places; `None`: all.
    pub pose: Option<(i64, i64)>,
    /// Covariance of a small shift (mm) and then a small rotation (rad) of the frame along and about its own axes, at its origin.
    pub covariance: [[f64; 6]; 6],
}

/// Adds what the uncertainty of `frames` contributes to a covariance: S C Sᵀ for each, where S is the derivative of the parameters
/// by shift and rotation of the frame (law of propagation of uncertainty, GUM 5.2.2).
pub(super) fn carry<'a>(
    frames: impl Iterator<Item = &'a FrameError>,
    (problem, solution, jacobian): (&Residuals, &Solution, &[f64]),
    total: &mut [f64],
) {
    let n = solution.x.len();
    let Some(inverse) = solution.covariance() else { return };
    for frame in frames {
        let by_frame = problem.frame_jacobian(&solution.x, frame.pose);
        // Jᵀ D, then S = -(JᵀJ)⁻¹ Jᵀ D: its sign drops out
        let mut moved = vec![0.0; n * 6];
        for (row, d) in jacobian.chunks_exact(n).zip(by_frame.chunks_exact(6)) {
            for (j, moved) in row.iter().zip(moved.chunks_exact_mut(6)) {
                moved.iter_mut().zip(d).for_each(|(m, d)| *m += j * d);
            }
        }
        let sensitivity: Vec<[f64; 6]> = inverse
            .chunks_exact(n)
            .map(|row| std::array::from_fn(|c| row.iter().zip(moved.chunks_exact(6)).map(|(a, m)| a * m[c]).sum()))
            .collect();
        for (i, a) in sensitivity.iter().enumerate() {
            let by_c: [f64; 6] = std::array::from_fn(|c| (0..6).map(|k| a[k] * frame.covariance[k][c]).sum());
            for (k, b) in sensitivity.iter().enumerate() {
                total[i * n + k] += by_c.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
            }
        }
    }
}
