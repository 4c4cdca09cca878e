//! Nonlinear least squares on published test functions (Moré, Garbow & Hillstrom 1981, ACM TOMS 7,
//! 17: problems 1, 6, 8, 15, 16), with the derivatives of dual numbers.

use crate::run::selftest::data::{Data, Slip};
use crate::run::selftest::row::{Rows, Subject};
use etalon_base::phrase;
use etalon_base::scalar::{Dual, constants, duals};
use etalon_math::{Options, Problem, Solution, solve};

pub(crate) const SUBJECT: Subject = Subject {
    id: "solver",
    requirement: || phrase!("selftest-solver"),
    rows,
    slips: &[
        Slip::Digit("/published/least_squares/bard/y/6", 2),
        Slip::Swap("/published/least_squares/kowalik/u/2", "/published/least_squares/kowalik/u/5"),
        Slip::Unit("/published/least_squares/kowalik/y", 1e3),
    ],
};

type D = Dual<4>;

/// Residuals of a problem as a function of its parameters.
pub(crate) struct Function<F> {
    count: usize,
    residuals: F,
}

impl<F: Fn(&[D]) -> Vec<D>> Function<F> {
    /// A problem with `count` residuals of at most four parameters.
    pub fn new(count: usize, residuals: F) -> Self {
        Self { count, residuals }
    }

    /// The solution from `start`.
    pub fn solve(&self, start: &[f64]) -> Solution {
        solve(self, start, Options::default())
    }
}

impl<F: Fn(&[D]) -> Vec<D>> Problem for Function<F> {
    fn residual_count(&self) -> usize {
        self.count
    }

    fn residuals(&self, x: &[f64], r: &mut [f64]) {
        let all = (self.residuals)(&constants::<4>(x));
        r.iter_mut().zip(all).for_each(|(r, value)| *r = value.value);
    }

    fn jacobian(&self, x: &[f64], jacobian: &mut [f64]) {
        let all = (self.residuals)(&duals::<4>(x));
        for (row, value) in jacobian.chunks_exact_mut(x.len()).zip(all) {
            row.copy_from_slice(&value.gradient[..x.len()]);
        }
    }
}

/// Exponential function.
fn exp(x: D) -> D {
    let value = x.value.exp();
    Dual { value, gradient: x.gradient.map(|g| g * value) }
}

fn n(value: f64) -> D {
    D::from(value)
}

fn rows(data: &Data) -> Vec<Rows> {
    let mut rows = Rows::new("ACM TOMS 7 (1981) 17");
    let data = data.at("/published/least_squares");
    for (name, solve) in PROBLEMS {
        let data = data.at(&format!("/{name}"));
        let solution = solve(&data);
        let expected = data.number("/expected/cost");
        if expected.is_finite() {
            // six digits are published
            let tolerance = 1e-5 * expected;
            rows.add(phrase!("selftest-sum-of-squares", name), "", [expected, solution.cost], tolerance);
        }
        let x = data.numbers("/expected/x");
        if !x.is_empty() {
            rows.add_all(
                phrase!("selftest-solution", name),
                "",
                [&x, &solution.x],
                if name == "rosenbrock" { 1e-10 } else { 5e-5 },
            );
        }
    }
    vec![rows, linear(&data)]
}

/// Solves a problem with the numbers of the reference data.
type Solve = fn(&Data) -> Solution;

const PROBLEMS: [(&str, Solve); 5] = [
    ("rosenbrock", rosenbrock),
    ("bard", bard),
    ("kowalik", kowalik),
    ("brown_dennis", brown_dennis),
    ("jennrich_sampson", jennrich_sampson),
];

fn rosenbrock(data: &Data) -> Solution {
    Function::new(2, |x| vec![(x[1] - x[0] * x[0]) * 10.0, n(1.0) - x[0]]).solve(&data.numbers("/start"))
}

fn bard(data: &Data) -> Solution {
    let y = data.numbers("/y");
    let residual = |x: &[D], i: usize| {
        let u = i as f64 + 1.0;
        let v = 16.0 - u;
        n(y[i]) - (x[0] + n(u) / (x[1] * v + x[2] * u.min(v)))
    };
    Function::new(y.len(), |x| (0..y.len()).map(|i| residual(x, i)).collect()).solve(&data.numbers("/start"))
}

fn kowalik(data: &Data) -> Solution {
    let (y, u) = (data.numbers("/y"), data.numbers("/u"));
    let residual =
        |x: &[D], (y, u): (&f64, &f64)| n(*y) - x[0] * (n(u * u) + x[1] * *u) / (n(u * u) + x[2] * *u + x[3]);
    let all = |x: &[D]| y.iter().zip(&u).map(|pair| residual(x, pair)).collect();
    Function::new(y.len(), all).solve(&data.numbers("/start"))
}

fn brown_dennis(data: &Data) -> Solution {
    let count = data.number("/count") as usize;
    let residual = |x: &[D], i: usize| {
        let t = (i as f64 + 1.0) / 5.0;
        let [a, b] = [x[0] + x[1] * t - n(t.exp()), x[2] + x[3] * t.sin() - n(t.cos())];
        a * a + b * b
    };
    Function::new(count, |x| (0..count).map(|i| residual(x, i)).collect()).solve(&data.numbers("/start"))
}

fn jennrich_sampson(data: &Data) -> Solution {
    let count = data.number("/count") as usize;
    let residual = |x: &[D], i: usize| {
        let i = i as f64 + 1.0;
        n(2.0 + 2.0 * i) - (exp(x[0] * i) + exp(x[1] * i))
    };
    Function::new(count, |x| (0..count).map(|i| residual(x, i)).collect()).solve(&data.numbers("/start"))
}

/// A line through three points, whose covariance is known: (JᵀJ)⁻¹ = [[5/6, -1/2], [-1/2, 1/2]].
fn linear(_data: &Data) -> Rows {
    let mut rows = Rows::new("normal equations");
    let points = [[0.0, 1.0], [1.0, 3.0], [2.0, 4.0]];
    let line = |x: &[D]| points.iter().map(|[t, y]| x[0] + x[1] * *t - n(*y)).collect();
    let solution = Function::new(3, line).solve(&[0.0, 0.0]);
    let covariance = solution.covariance().unwrap_or_default();
    rows.add_all(phrase!("selftest-solution", name = "line"), "", [&[7.0 / 6.0, 1.5], &solution.x], 1e-12);
    rows.add_all(
        phrase!("selftest-covariance", name = "line"),
        "",
        [&[5.0 / 6.0, -0.5, -0.5, 0.5], &covariance],
        1e-12,
    );
    rows
}
