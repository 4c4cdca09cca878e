//! The uncertainty of frames: an error of a frame is common to all observations in it.

use crate::model::solved::Solved;
use etalon_base::pose_name::PoseName;
use etalon_math::Rows;

/// The uncertainty of the frame in which observations are given.
#[derive(Clone, Debug, PartialEq)]
pub struct FrameError {
    /// Pose and cycle of the frame; `None`: all.
    pub pose: Option<(PoseName, i64)>,
    /// Covariance of a small shift (mm) and then a small rotation (rad) of the frame along and
    /// about its own axes, at its origin.
    pub covariance: [[f64; 6]; 6],
}

/// Adds the contribution of the uncertainty of `frames` to a covariance: S C Sᵀ for each, where S
/// is the derivative of the parameters with respect to shift and rotation of the frame (law of
/// propagation of uncertainty, GUM 5.2.2).
pub(crate) fn carry<'a>(frames: impl Iterator<Item = &'a FrameError>, solved: Solved, total: &mut [f64]) {
    let Solved { problem, solution, .. } = solved;
    let n = solution.x.len();
    let jacobian = solved.rows();
    let Some(inverse) = solution.covariance() else { return };
    for frame in frames {
        let by_frame = problem.frame_jacobian(&solution.x, frame.pose);
        // S = -(JᵀJ)⁻¹ Jᵀ D: its sign drops out
        let sensitivity = response::<6>(&inverse, jacobian, &by_frame);
        for (i, a) in sensitivity.iter().enumerate() {
            let by_c: [f64; 6] = std::array::from_fn(|c| (0..6).map(|k| a[k] * frame.covariance[k][c]).sum());
            for (k, b) in sensitivity.iter().enumerate() {
                total[i * n + k] += by_c.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
            }
        }
    }
}

/// (JᵀJ)⁻¹ Jᵀ D: response of parameters with the Jacobian J to the columns of D.
pub(crate) fn response<const N: usize>(inverse: &[f64], jacobian: Rows, by: &[f64]) -> Vec<[f64; N]> {
    let moved = jacobian.transposed_times::<N>(by);
    let answer = |row: &[f64]| std::array::from_fn(|c| row.iter().zip(&moved).map(|(a, m)| a * m[c]).sum());
    inverse.chunks_exact(jacobian.n.max(1)).map(answer).collect()
}
