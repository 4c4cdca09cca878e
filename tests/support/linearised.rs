//! The thesis' own identification (eq. 4.25 to 4.30), a second implementation to compare with.

use etalon::identify::Observation;
use etalon::robots::Robot;
use nalgebra::{DMatrix, DVector};

/// Newton on the linearised model with scaled columns, until the RMSE changes by less than 1e-16 mm or no more. Gives
/// the parameters and the number of steps.
///
/// Eq. 4.30 sums x and y over 2n rows, which counts every residual twice; here it is the root mean square of the 2n
/// residuals. Eq. 4.27 is solved by orthogonal factors of the scaled Jacobian instead of its normal matrix.
pub fn linearised(robot: &dyn Robot, observations: &[Observation]) -> (Vec<f64>, usize) {
    let m = robot.parameters().len();
    let rows = 2 * observations.len();
    let mut v = robot.nominal();
    let errors = |v: &[f64]| {
        let of = |o: &Observation| {
            let estimated = robot.position(v, &o.joints, 0);
            let measured = o.targets[0].expect("measured");
            [measured[0] - estimated[0], measured[1] - estimated[1]]
        };
        DVector::from_iterator(rows, observations.iter().flat_map(of))
    };
    let rmse = |v: &[f64]| (errors(v).norm_squared() / rows as f64).sqrt();
    let mut last = rmse(&v);
    for iteration in 1..=50 {
        let mut jacobian = DMatrix::zeros(rows, m);
        for (k, o) in observations.iter().enumerate() {
            let mut block = vec![0.0; 2 * m];
            robot.jacobian(&v, &o.joints, &mut block);
            jacobian.rows_mut(2 * k, 2).copy_from(&DMatrix::from_row_slice(2, m, &block));
        }
        let d: Vec<f64> = jacobian.column_iter().map(|c| c.norm()).collect();
        for (mut column, d) in jacobian.column_iter_mut().zip(&d) {
            column /= *d;
        }
        let qr = jacobian.qr();
        let scaled = qr.r().solve_upper_triangular(&(qr.q().transpose() * errors(&v))).expect("full rank");
        v.iter_mut().zip(scaled.iter()).zip(&d).for_each(|((v, s), d)| *v += s / d);
        let now = rmse(&v);
        if (now - last).abs() < 1e-16 || (now < 1e-12 && last < 1e-12) {
            return (v, iteration);
        }
        last = now;
    }
    (v, 50)
}
