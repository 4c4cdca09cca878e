//! Eigenvectors of small symmetric matrices by cyclic Jacobi rotations (Golub & Van Loan, 4th ed.,
//! 8.5).

use etalon_base::pose::{cross, dot};

/// Eigenvalues in ascending order with their unit eigenvectors, at equal indices.
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
                // rows of v are the eigenvectors, so that rows p and q are rotated
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

/// Eigenvector of the smallest eigenvalue of a positive semidefinite 3 × 3 matrix. Faster than
/// [`symmetric_eigen`], which is the fallback if two eigenvalues are too close for a cross product
/// of rows.
pub fn smallest_eigenvector(a: [[f64; 3]; 3]) -> [f64; 3] {
    let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = a;
    let trace = xx + yy + zz;
    let minors = xx * yy - xy * xy + xx * zz - xz * xz + yy * zz - yz * yz;
    let determinant = xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
    // Newton's iteration from below all roots increases monotonically to the smallest
    let mut value = 0.0;
    for _ in 0..20 {
        let at = ((value - trace) * value + minors) * value - determinant;
        let slope = (3.0 * value - 2.0 * trace) * value + minors;
        let step = at / slope;
        if step.is_nan() || step >= -4.0 * f64::EPSILON * trace {
            break;
        }
        value -= step;
    }
    // the eigenvector is perpendicular to all rows, hence parallel to the largest cross product
    let rows = [[xx - value, xy, xz], [xy, yy - value, yz], [xz, yz, zz - value]];
    let products = [cross(rows[0], rows[1]), cross(rows[1], rows[2]), cross(rows[2], rows[0])];
    let squares = products.map(|p| dot(p, p));
    let largest = usize::from(squares[1] > squares[0]);
    let largest = if squares[2] > squares[largest] { 2 } else { largest };
    let length = squares[largest].sqrt();
    if length > 1e-5 * trace * trace { products[largest].map(|x| x / length) } else { symmetric_eigen(a).1[0] }
}

/// Sine and cosine that eliminate the off-diagonal element (Golub & Van Loan, algorithm 8.5.1).
pub(super) fn symmetric_schur(app: f64, apq: f64, aqq: f64) -> (f64, f64) {
    let tau = (aqq - app) / (2.0 * apq);
    // an overflowing square correctly gives an angle of zero; `hypot` would be slow
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
        // eigenvalues 1 and 3 of [[2, 1], [1, 2]], and a separate 5
        let (values, vectors) = symmetric_eigen([[2.0, 1.0, 0.0], [1.0, 2.0, 0.0], [0.0, 0.0, 5.0]]);
        for (value, expected) in values.iter().zip([1.0, 3.0, 5.0]) {
            assert!((value - expected).abs() < 1e-15);
        }
        assert!((vectors[0][0] + vectors[0][1]).abs() < 1e-15 && (vectors[1][0] - vectors[1][1]).abs() < 1e-15);
    }

    #[test]
    fn the_smallest_is_found_without_the_others() {
        let mut noise = etalon_base::noise::Noise::new(20_261_124, 0);
        for size in [1e-3, 1e-8, 0.0] {
            for _ in 0..200 {
                let mut a = [[0.0; 3]; 3];
                for stretch in [1.0, 0.3, size] {
                    let row = [0, 1, 2].map(|_| stretch * noise.gaussian(1.0));
                    for (i, j) in (0..9).map(|k| (k / 3, k % 3)) {
                        a[i][j] += row[i] * row[j];
                    }
                }
                let (expected, found) = (symmetric_eigen(a).1[0], smallest_eigenvector(a));
                assert!(dot(found, expected).abs() > 1.0 - 1e-14, "{a:?}: {found:?}, {expected:?}");
            }
        }
        // two equal eigenvalues, and a zero matrix
        for a in [[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 5.0]], [[0.0; 3]; 3]] {
            assert_eq!(smallest_eigenvector(a), symmetric_eigen(a).1[0]);
        }
    }

    #[test]
    fn a_planar_cloud_keeps_its_normal() {
        let (values, vectors) = symmetric_eigen([[1e6, 2e5, 0.0], [2e5, 3e6, 0.0], [0.0, 0.0, 0.0]]);
        assert_eq!(values[0], 0.0);
        assert_eq!(vectors[0], [0.0, 0.0, 1.0]);
    }
}
