//! Eigenvectors of small symmetric matrices by cyclic Jacobi rotations (Golub & Van Loan, 4th ed., 8.5).

/// Eigenvalues in ascending order and, at the same index, their unit eigenvectors.
pub fn symmetric_eigen<const N: usize>(mut a: [[f64; N]; N]) -> ([f64; N], [[f64; N]; N]) {
    let mut v = [[0.0; N]; N];
    for (i, row) in v.iter_mut().enumerate() {
        row[i] = 1.0;
    }
    for _sweep in 0..50 {
        let mut rotated = false;
        for p in 0..N {
            for q in p + 1..N {
                if a[p][q].abs() <= f64::EPSILON * (a[p][p] * a[q][q]).abs().sqrt() || a[p][q] == 0.0 {
                    continue;
                }
                rotated = true;
                // rows of v are the eigenvectors: rotating them is rotating rows p and q
                let (sin, cos) = symmetric_schur(a[p][p], a[p][q], a[q][q]);
                rotate_rows(&mut v, p, q, sin, cos);
                rotate_rows(&mut a, p, q, sin, cos);
                for row in &mut a {
                    let (x, y) = (row[p], row[q]);
                    row[p] = cos * x - sin * y;
                    row[q] = sin * x + cos * y;
                }
                (a[p][q], a[q][p]) = (0.0, 0.0);
            }
        }
        if !rotated {
            break;
        }
    }
    let mut order: [usize; N] = std::array::from_fn(|i| i);
    order.sort_by(|&i, &j| a[i][i].total_cmp(&a[j][j]));
    (order.map(|i| a[i][i]), order.map(|i| v[i]))
}

/// Sine and cosine that make the off-diagonal element zero (Golub & Van Loan, algorithm 8.5.1).
pub(super) fn symmetric_schur(app: f64, apq: f64, aqq: f64) -> (f64, f64) {
    let tau = (aqq - app) / (2.0 * apq);
    // a square that overflows leaves an angle of zero, which is right; hypot would be slow
    let t = tau.signum() / (tau.abs() + (1.0 + tau * tau).sqrt());
    let cos = 1.0 / (1.0 + t * t).sqrt();
    (t * cos, cos)
}

fn rotate_rows<const N: usize>(m: &mut [[f64; N]; N], p: usize, q: usize, sin: f64, cos: f64) {
    let (head, tail) = m.split_at_mut(q);
    for (x, y) in head[p].iter_mut().zip(&mut tail[0]) {
        (*x, *y) = (cos * *x - sin * *y, sin * *x + cos * *y);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn eigenvectors_of_a_known_matrix() {
        // eigenvalues 1, 3 of [[2,1],[1,2]], and 5 alone
        let (values, vectors) = symmetric_eigen([[2.0, 1.0, 0.0], [1.0, 2.0, 0.0], [0.0, 0.0, 5.0]]);
        for (value, expected) in values.iter().zip([1.0, 3.0, 5.0]) {
            assert!((value - expected).abs() < 1e-15);
        }
        assert!((vectors[0][0] + vectors[0][1]).abs() < 1e-15 && (vectors[1][0] - vectors[1][1]).abs() < 1e-15);
    }

    #[test]
    fn a_planar_cloud_keeps_its_normal() {
        let (values, vectors) = symmetric_eigen([[1e6, 2e5, 0.0], [2e5, 3e6, 0.0], [0.0, 0.0, 0.0]]);
        assert_eq!(values[0], 0.0);
        assert_eq!(vectors[0], [0.0, 0.0, 1.0]);
    }
}
