//! Least squares with outliers and prior knowledge.

#![allow(clippy::excessive_precision)] // digits as computed

use etalon::math::{Loss, Options, ParameterPrior, Problem, WithPriors, solve, svd};

/// y = a + b t.
struct Line {
    t: Vec<f64>,
    y: Vec<f64>,
}

impl Problem for Line {
    fn residual_count(&self) -> usize {
        self.t.len()
    }
    fn residuals(&self, x: &[f64], r: &mut [f64]) {
        for (r, (t, y)) in r.iter_mut().zip(self.t.iter().zip(&self.y)) {
            *r = x[0] + x[1] * t - y;
        }
    }
    fn jacobian(&self, _x: &[f64], jacobian: &mut [f64]) {
        for (row, t) in jacobian.chunks_exact_mut(2).zip(&self.t) {
            row.copy_from_slice(&[1.0, *t]);
        }
    }
}

/// Distances from a circle: centre and radius.
struct Circle {
    points: Vec<[f64; 2]>,
}

impl Problem for Circle {
    fn residual_count(&self) -> usize {
        self.points.len()
    }
    fn residuals(&self, x: &[f64], r: &mut [f64]) {
        for (r, p) in r.iter_mut().zip(&self.points) {
            *r = (p[0] - x[0]).hypot(p[1] - x[1]) - x[2];
        }
    }
    fn jacobian(&self, x: &[f64], jacobian: &mut [f64]) {
        for (row, p) in jacobian.chunks_exact_mut(3).zip(&self.points) {
            let d = (p[0] - x[0]).hypot(p[1] - x[1]);
            row.copy_from_slice(&[(x[0] - p[0]) / d, (x[1] - p[1]) / d, -1.0]);
        }
    }
}

/// A line of slope 1/2 with three outliers.
fn line() -> Line {
    let y = [
        1.7, 2.62, 2.88, 11.8, 4.06, 4.32, 5.24, 5.5, 5.76, 6.68, 6.94, 1.2, 8.12, 8.38, 9.3, 9.56, 9.82, 25.74, 11.0,
        11.26,
    ];
    Line { t: (0..20).map(f64::from).collect(), y: y.to_vec() }
}

/// A circle of radius 10 about (3, -2) with three outliers.
fn circle() -> Circle {
    let x = [
        12.95, 12.2721, 11.5711, 6.7935, 3.05, -0.8102, -4.0877, -6.2888, -6.9667, -6.2388, -4.1044, -0.7768, 3.0167,
        6.0602, 10.0211, 12.2721,
    ];
    let y = [
        -2.05, 1.8268, 5.1211, 7.2221, 8.0333, 7.2055, 5.0877, 1.7768, -2.0, -8.0268, -9.0877, -11.2055, -12.0333,
        -11.2221, -9.1211, -5.8268,
    ];
    Circle { points: x.into_iter().zip(y).map(|(x, y)| [x, y]).collect() }
}

fn robust(problem: &impl Problem, start: &[f64], loss: Loss, expected: &[f64], cost: f64) {
    let solution = solve(problem, start, Options { loss, ..Options::default() });
    assert!(solution.termination.is_success(), "{loss:?}: {}", solution.termination);
    for (x, e) in solution.x.iter().zip(expected) {
        assert!((x - e).abs() < 1e-12 * e.abs().max(1.0), "{loss:?}: {:?} {expected:?}", solution.x);
    }
    assert!((solution.cost / cost - 1.0).abs() < 1e-13, "{loss:?}: {} {cost}", solution.cost);
    // the slope of the robust cost, from the influence of the residuals
    let n = start.len();
    let mut jacobian = vec![0.0; n * problem.residual_count()];
    problem.jacobian(&solution.x, &mut jacobian);
    for k in 0..n {
        let terms = jacobian.chunks_exact(n).zip(&solution.residuals).map(|(row, r)| row[k] * loss.influence(*r));
        let (slope, size) = terms.fold((0.0, 0.0), |(s, a): (f64, f64), t| (s + t, a + t.abs()));
        assert!(slope.abs() < 1e-13 * size, "{loss:?}: slope {slope:e}");
    }
}

#[test]
fn robust_fits_match_scipy_polished_to_forty_digits() {
    // SciPy 1.17 least_squares(loss=..., f_scale=...) on these data, then the zero of the gradient in 40-digit
    // arithmetic (mpmath 1.3 findroot); the cost is the sum of rho, twice SciPy's
    let start = [0.0, 1.0];
    let cauchy = [1.975_750_848_759_201_6, 0.500_131_442_330_662_5];
    robust(&line(), &start, Loss::Cauchy(0.5), &cauchy, 4.843_555_351_754_58);
    let start = [0.0, 0.0, 8.0];
    let cauchy = [2.997_754_586_774_891_9, -1.997_042_118_469_923, 10.001_242_340_811_07];
    robust(&circle(), &start, Loss::Cauchy(0.1), &cauchy, 0.131_372_493_398_863_36);
}

#[test]
fn a_loss_that_no_residual_reaches_is_least_squares() {
    let plain = solve(&circle(), &[0.0, 0.0, 8.0], Options::default());
    let huge = solve(&circle(), &[0.0, 0.0, 8.0], Options { loss: Loss::Cauchy(1e12), ..Options::default() });
    for (plain, huge) in plain.x.iter().zip(&huge.x) {
        assert!((plain - huge).abs() < 1e-13, "{plain} {huge}");
    }
    let wrong = solve(&circle(), &[0.0, 0.0, 8.0], Options { loss: Loss::Cauchy(0.0), ..Options::default() });
    assert!(!wrong.termination.is_success());
}

#[test]
fn priors_are_rows_and_count_in_chi_square() {
    let line = line();
    let priors = [
        ParameterPrior { parameter: 0, value: 2.0, weight: 1.0 / 0.1 },
        ParameterPrior { parameter: 1, value: 0.4, weight: 1.0 / 0.02 },
    ];
    let solution = solve(&WithPriors::new(&line, &priors), &[0.0, 0.0], Options::default());
    // the closed solution: (JᵀJ + P)⁻¹ (Jᵀy + P p)
    let (mut a, mut b, mut c, mut g, mut h) = (100.0, 0.0, 2500.0, 200.0, 1000.0);
    for (t, y) in line.t.iter().zip(&line.y) {
        (a, b, c, g, h) = (a + 1.0, b + t, c + t * t, g + y, h + t * y);
    }
    let d = a * c - b * b;
    let exact = [(c * g - b * h) / d, (a * h - b * g) / d];
    for (x, e) in solution.x.iter().zip(exact) {
        assert!((x - e).abs() < 1e-13, "{x} {e}");
    }
    assert_eq!(solution.residuals.len(), 22);
    let measured: f64 = line.t.iter().zip(&line.y).map(|(t, y)| (exact[0] + exact[1] * t - y).powi(2)).sum();
    let known = ((exact[0] - 2.0) / 0.1).powi(2) + ((exact[1] - 0.4) / 0.02).powi(2);
    assert!((solution.cost - measured - known).abs() < 1e-10);
    let covariance = solution.covariance().unwrap();
    for (found, e) in covariance.iter().zip([c / d, -b / d, -b / d, a / d]) {
        assert!((found - e).abs() < 1e-15, "{covariance:?}");
    }
}

#[test]
fn no_loss_weighs_a_prior_down() {
    // the prior lies ten of its uncertainties away: with a loss on it, it would hardly count
    let flat = Line { t: vec![0.0, 0.0, 0.0], y: vec![0.0, 0.1, -0.1] };
    let priors = [
        ParameterPrior { parameter: 0, value: 10.0, weight: 1.0 },
        ParameterPrior { parameter: 1, value: 0.0, weight: 1.0 },
    ];
    let squares = solve(&WithPriors::new(&flat, &priors), &[0.0, 0.0], Options::default());
    assert!((squares.x[0] - 2.5).abs() < 1e-14);
    for loss in [Loss::Cauchy(2.385), Loss::Cauchy(3.0)] {
        let found = solve(&WithPriors::new(&flat, &priors), &[0.0, 0.0], Options { loss, ..Options::default() }).x[0];
        let slope: f64 = flat.y.iter().map(|y| loss.influence(found - y)).sum::<f64>() + found - 10.0;
        assert!(slope.abs() < 1e-12 && found > 2.5, "{loss:?}: {found}, slope {slope:e}");
    }
}

#[test]
fn a_prior_settles_what_the_residuals_leave_open() {
    let one = Line { t: vec![1.0, 1.0], y: vec![3.0, 3.0] };
    let open = solve(&one, &[0.0, 0.0], Options::default());
    assert_eq!(svd(open.factor.as_ref().unwrap()).rank(1e-13), 1);
    let prior = [ParameterPrior { parameter: 1, value: 2.0, weight: 1.0 / 0.5 }];
    let settled = solve(&WithPriors::new(&one, &prior), &[0.0, 0.0], Options::default());
    assert!((settled.x[0] - 1.0).abs() < 1e-14 && (settled.x[1] - 2.0).abs() < 1e-14);
    let settled = svd(settled.factor.as_ref().unwrap());
    assert_eq!(settled.rank(1e-13), 2);
    // sqrt(cond) of columns of length one: cosine 2 / sqrt(2 · 6)
    let cosine = 2.0 / 12f64.sqrt();
    let condition = ((1.0 + cosine) / (1.0 - cosine)).sqrt();
    assert!((settled.condition() - condition).abs() < 1e-13);
}
