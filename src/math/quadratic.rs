//! Second-order model of a problem, for problems that differ by small errors of their readings.

use super::factor::add;
use super::{Linearised, Problem, Rows, norm};
use pulp::{Arch, Simd, WithSimd};

/// Maximum number of second derivatives.
const MOST: usize = 1 << 20;
/// Maximum ratio of the quadratic to the linear change of the residuals: the cubic change is then
/// about a millionth of the linear one.
const CURVED: f64 = 1e-3;

/// Residuals r(x + s) = r(x) + J s + ½ sᵀ T s about one point, with the linear part there.
#[derive(Clone, Debug)]
pub struct Quadratic {
    /// T: derivatives of the Jacobian with respect to one parameter after the other.
    second: Vec<f64>,
}

impl Quadratic {
    /// Second-order part of `problem` at `x` by central differences of its Jacobian; `None` with
    /// blocks, or with more than a million derivatives.
    pub fn new(problem: &impl Problem, x: &[f64], linearised: &Linearised) -> Option<Self> {
        let size = linearised.jacobian.len();
        if problem.blocks().is_some() || x.len() * size > MOST {
            return None;
        }
        let mut second = Vec::with_capacity(x.len() * size);
        for (k, scale) in linearised.scale.iter().enumerate() {
            // each residual changes by about one standard uncertainty
            let h = (problem.residual_count() as f64).sqrt() / scale;
            let [up, down] = [h, -h].map(|h| {
                let (mut x, mut jacobian) = (x.to_vec(), vec![0.0; size]);
                x[k] += h;
                problem.jacobian(&x, &mut jacobian);
                jacobian
            });
            second.extend(up.iter().zip(&down).map(|(up, down)| (up - down) / (2.0 * h)));
        }
        Some(Self { second })
    }

    /// Returns the step from the point to the solution of a problem with these derivatives and with
    /// `residuals` at the point: two undamped steps by the gradient and the factor of the linear
    /// part. `None` if the second step exceeds `near` times the first, or if the residuals are too
    /// curved.
    pub fn solve(&self, linearised: &Linearised, residuals: &[f64], near: f64) -> Option<Vec<f64>> {
        let Linearised { jacobian, factor, scale } = linearised;
        let n = scale.len();
        let descent = |numbers: &[f64], r: &[f64]| factor.solve_normal(Rows { numbers, n, blocks: None }, r, scale);
        let first = descent(jacobian, residuals)?;
        let mut change = vec![0.0; jacobian.len()];
        Arch::new().dispatch(Summing { parts: &self.second, weights: &first, sum: &mut change });
        let along = |numbers: &[f64]| -> Vec<f64> {
            numbers.chunks_exact(n).map(|row| row.iter().zip(&first).map(|(j, s)| j * s).sum()).collect()
        };
        let (linear, twice) = (along(jacobian), along(&change));
        let is_straight = 0.5 * norm(&twice) <= CURVED * norm(&linear);
        let there: Vec<f64> =
            residuals.iter().zip(&linear).zip(&twice).map(|((r, linear), twice)| r + linear + 0.5 * twice).collect();
        change.iter_mut().zip(jacobian).for_each(|(change, j)| *change += j);
        let second = descent(&change, &there)?;
        let length = |step: &[f64]| norm(&step.iter().zip(scale).map(|(s, d)| s * d).collect::<Vec<f64>>());
        let is_near = length(&second) <= near * length(&first);
        (is_straight && is_near).then(|| first.iter().zip(second).map(|(a, b)| a + b).collect())
    }
}

/// Weighted sum of vectors that are stored one after the other.
struct Summing<'a> {
    parts: &'a [f64],
    weights: &'a [f64],
    sum: &'a mut [f64],
}

impl WithSimd for Summing<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        for (part, weight) in self.parts.chunks_exact(self.sum.len().max(1)).zip(self.weights) {
            add(self.sum, *weight, part);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Options, solve};

    /// Fit of y = a exp(b t) to readings in units of their standard uncertainty, 1e-5.
    struct Exponential([f64; 5]);

    const UNIT: f64 = 1e-5;

    impl Problem for Exponential {
        fn residual_count(&self) -> usize {
            5
        }
        fn residuals(&self, x: &[f64], r: &mut [f64]) {
            let reading = |(i, r): (usize, &mut f64)| *r = (x[0] * (x[1] * i as f64).exp() - self.0[i]) / UNIT;
            r.iter_mut().enumerate().for_each(reading);
        }
        fn jacobian(&self, x: &[f64], j: &mut [f64]) {
            for (i, j) in j.chunks_exact_mut(2).enumerate() {
                let (t, e) = (i as f64, (x[1] * i as f64).exp());
                j.copy_from_slice(&[e / UNIT, x[0] * t * e / UNIT]);
            }
        }
    }

    #[test]
    fn small_errors_move_the_solution_as_a_new_solution_does() {
        let readings = [1.0, 1.64874, 2.71827, 4.48168, 7.38907];
        let solution = solve(&Exponential(readings), &[1.0, 0.5], Options::default());
        let linearised = Linearised::new(&Exponential(readings), &solution.x);
        let quadratic = Quadratic::new(&Exponential(readings), &solution.x, &linearised).unwrap();
        for (size, is_small) in [(1.0, true), (1e4, false)] {
            let errors = [1.0, -2.0, 0.5, 1.5, -1.0].map(|e| e * size);
            let moved = Exponential(std::array::from_fn(|i| readings[i] + UNIT * errors[i]));
            let residuals: Vec<f64> = solution.residuals.iter().zip(errors).map(|(r, e)| r - e).collect();
            let step = quadratic.solve(&linearised, &residuals, 1e-3);
            assert_eq!(step.is_some(), is_small);
            let expected = solve(&moved, &solution.x, Options::default()).x;
            for (k, step) in step.iter().flatten().enumerate() {
                let change = expected[k] - solution.x[k];
                assert!((step - change).abs() < 1e-6 * change.abs(), "{k}: {step} {change}");
            }
        }
    }
}
