//! Singular values and right singular vectors, correct for rank-deficient matrices too.
//!
//! The dynamic decomposition of nalgebra 0.35 is wrong for such matrices (dimforge/nalgebra#1172).
//! One-sided Jacobi on the triangular factor has the best known relative accuracy for small
//! singular values (Demmel & Veselić 1992).

use super::Factor;

/// Singular values in descending order and their right singular vectors.
#[derive(Clone, Debug)]
pub struct Svd {
    /// Singular values, descending.
    pub values: Vec<f64>,
    /// Unit right singular vectors in the order of `values`.
    pub vectors: Vec<Vec<f64>>,
}

impl Svd {
    /// Number of singular values above `tolerance` times the largest.
    pub fn rank(&self, tolerance: f64) -> usize {
        let limit = tolerance * self.values.first().copied().unwrap_or(0.0);
        self.values.iter().filter(|&&v| v > limit).count()
    }

    /// Largest over smallest singular value; infinite if the smallest is zero.
    pub fn condition(&self) -> f64 {
        match (self.values.first(), self.values.last()) {
            (Some(largest), Some(smallest)) => largest / smallest,
            _ => f64::NAN,
        }
    }
}

/// Decomposes the triangular factor R of a matrix, which has the singular values and right singular
/// vectors of the matrix; for a matrix with blocks, of its common columns after elimination of the
/// blocks.
pub fn svd(factor: &Factor) -> Svd {
    let n = factor.common().len();
    // columns of R are rotated to be orthogonal: R V = U S
    let mut columns: Vec<Vec<f64>> = (0..n).map(|j| (0..n).map(|i| factor.r(i, j)).collect()).collect();
    let mut v: Vec<Vec<f64>> = (0..n).map(|j| (0..n).map(|i| f64::from(u8::from(i == j))).collect()).collect();
    let scale = columns.iter().flatten().fold(0.0f64, |s, x| s.max(x.abs()));
    let negligible = (scale * f64::EPSILON).powi(2) * 1e-4;
    for _sweep in 0..60 {
        let mut rotated = false;
        for p in 0..n {
            for q in p + 1..n {
                let (app, aqq, apq) = products(&columns[p], &columns[q]);
                if apq.abs() <= f64::EPSILON * (app * aqq).sqrt() || app.min(aqq) <= negligible {
                    continue;
                }
                rotated = true;
                let (sin, cos) = super::eigen::symmetric_schur(app, apq, aqq);
                for set in [&mut columns, &mut v] {
                    let (head, tail) = set.split_at_mut(q);
                    for (x, y) in head[p].iter_mut().zip(&mut tail[0]) {
                        (*x, *y) = (cos * *x - sin * *y, sin * *x + cos * *y);
                    }
                }
            }
        }
        if !rotated {
            break;
        }
    }
    let values: Vec<f64> = columns.iter().map(|c| c.iter().map(|x| x * x).sum::<f64>().sqrt()).collect();
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by(|&i, &j| values[j].total_cmp(&values[i]));
    Svd {
        values: order.iter().map(|&i| values[i]).collect(),
        vectors: order.iter().map(|&i| std::mem::take(&mut v[i])).collect(),
    }
}

fn products(p: &[f64], q: &[f64]) -> (f64, f64, f64) {
    p.iter().zip(q).fold((0.0, 0.0, 0.0), |(pp, qq, pq), (x, y)| (pp + x * x, qq + y * y, pq + x * y))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn decompose(a: &[f64], n: usize) -> Svd {
        svd(&Factor::new(a, &vec![0.0; a.len() / n], &vec![1.0; n]))
    }

    #[test]
    fn singular_values_of_a_known_matrix() {
        // [[3, 0], [4, 5]] has the singular values √45 and √5
        let s = decompose(&[3.0, 0.0, 4.0, 5.0], 2);
        assert!((s.values[0] - 45f64.sqrt()).abs() < 1e-14 && (s.values[1] - 5f64.sqrt()).abs() < 1e-14);
    }

    #[test]
    fn an_exactly_planar_cloud_has_the_trace_of_its_gram_matrix() {
        // nalgebra's decomposition is wrong by up to 16 % here
        for seed in 0..200u32 {
            let mut a = Vec::new();
            for i in 0..40u32 {
                let t = f64::from(i * 7919 + seed * 104_729);
                let (x, y) = ((t * 0.37).sin() * 250.0, (t * 0.91).cos() * 120.0);
                a.extend([x, y, 0.3 * x - 0.2 * y]);
            }
            let s = decompose(&a, 3);
            let total: f64 = a.iter().map(|x| x * x).sum();
            let squares: f64 = s.values.iter().map(|x| x * x).sum();
            assert!((squares / total - 1.0).abs() < 1e-13);
            assert_eq!(s.rank(1e-12), 2);
            let normal = &s.vectors[2];
            assert!((normal[0] * 250.0 + normal[2] * 0.3 * 250.0).abs() < 1e-10, "{normal:?}");
        }
    }

    #[test]
    fn a_dependent_column_gives_its_null_vector() {
        let a: Vec<f64> = (0..30)
            .flat_map(|i| {
                let t = f64::from(i);
                [t.sin(), t.cos(), 2.0 * t.sin()]
            })
            .collect();
        let s = decompose(&a, 3);
        assert_eq!(s.rank(1e-12), 2);
        let v = &s.vectors[2];
        assert!((v[0] + 2.0 * v[2]).abs() < 1e-14 && v[1].abs() < 1e-14);
    }
}
