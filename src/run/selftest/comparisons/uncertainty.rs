//! Uncertainties: published examples of the GUM (JCGM 100:2008, annex H) with dual numbers, the
//! solver and the statistics of the program, and of JCGM 101:2008 (clause 9) with its random
//! numbers.

use crate::run::selftest::data::{Data, Slip};
use crate::run::selftest::row::{Rows, Subject};
use crate::run::selftest::solver::Function;
use crate::stages::uncertainty::monte_carlo::Distribution;
use etalon_base::noise::Noise;
use etalon_base::phrase;
use etalon_base::scalar::{Dual, Scalar, duals};
use etalon_identify::Variance;
use etalon_math::statistics::{mean, standard_deviation};
use etalon_standards::decision::conformity_probability;
use rayon::prelude::*;
use statrs::distribution::{ContinuousCDF, StudentsT};
use std::f64::consts::TAU;

pub(crate) const SUBJECT: Subject = Subject {
    id: "uncertainty",
    requirement: || phrase!("selftest-uncertainty"),
    rows,
    slips: &[
        Slip::Digit("/published/gum_h3/correction_c/0", 3),
        Slip::Swap("/published/gum_h2/voltage_v/0", "/published/gum_h2/voltage_v/1"),
        Slip::Unit("/published/gum_h2/current_a", 1e3),
        Slip::Unit("/published/jcgm101/gauge/alpha_s", 1e3),
    ],
};

fn rows(data: &Data) -> Vec<Rows> {
    let monte_carlo = data.at("/published/jcgm101");
    vec![
        gauge_block(&data.at("/published/gum_h1")),
        impedance(&data.at("/published/gum_h2")),
        thermometer(&data.at("/published/gum_h3")),
        additive(&monte_carlo),
        mass(&monte_carlo),
        mismatch(&monte_carlo),
        gauge(&monte_carlo),
        tables(&data.at("/published")),
    ]
}

type D = Dual<4>;

/// Length of a gauge block by comparison.
fn gauge_block(data: &Data) -> Rows {
    let mut rows = Rows::new("JCGM 100:2008, H.1");
    let n = |name: &str| data.number(&format!("/{name}"));
    // standard, difference, difference of the expansion coefficients, difference of temperatures
    let x = duals::<4>(&[n("standard_nm"), n("difference_nm"), 0.0, 0.0]);
    let length: D = x[0] + x[1] - x[0] * (x[2] * n("theta_k") + x[3] * n("alpha_s_per_k"));
    let u_difference = n("u_observations_nm").hypot(n("u_random_nm")).hypot(n("u_systematic_nm"));
    let (by_alpha, by_theta) =
        (length.gradient[2].abs() * n("u_delta_alpha_per_k"), length.gradient[3].abs() * n("u_delta_theta_k"));
    let parts =
        [n("u_standard_nm"), n("u_observations_nm"), n("u_random_nm"), n("u_systematic_nm"), by_alpha, by_theta];
    let u = parts.iter().map(|u| u * u).sum::<f64>().sqrt();
    let degrees = data.numbers("/degrees");
    // Welch and Satterthwaite (JCGM 100:2008, G.4.1), truncated
    let effective = (u.powi(4) / parts.iter().zip(&degrees).map(|(u, nu)| u.powi(4) / nu).sum::<f64>()).floor();
    let t_99 = StudentsT::new(0.0, 1.0, effective).map_or(f64::NAN, |t| t.inverse_cdf(0.995));
    let mut add = |name: &str, found: f64, permissible: f64| {
        rows.add(
            phrase!("selftest-gum", name),
            unit_from_name(name),
            [n(&format!("expected/{name}")), found],
            permissible,
        );
    };
    add("length_nm", length.value, 0.5);
    add("u_difference_nm", u_difference, 0.05);
    add("c_delta_alpha_nm", by_alpha, 0.05);
    add("c_delta_theta_nm", by_theta, 0.1);
    add("u_nm", u, 0.5);
    add("degrees", effective, 0.0);
    add("t_99", t_99, 0.005);
    // published from the rounded uncertainty
    add("expanded_nm", t_99 * u, 1.0);
    rows
}

fn unit_from_name(name: &str) -> &'static str {
    if name.ends_with("_nm") { "nm" } else { "" }
}

/// Resistance, reactance and impedance from simultaneous readings.
fn impedance(data: &Data) -> Rows {
    let mut rows = Rows::new("JCGM 100:2008, H.2");
    let readings = ["/voltage_v", "/current_a", "/phase_rad"].map(|name| data.numbers(name));
    let count = readings[0].len() as f64;
    let means = [0, 1, 2].map(|i| mean(readings[i].iter().copied()));
    let u = [0, 1, 2].map(|i| standard_deviation(&readings[i]) / count.sqrt());
    let covariance = |i: usize, j: usize| {
        let products = readings[i].iter().zip(&readings[j]).map(|(a, b)| (a - means[i]) * (b - means[j]));
        products.sum::<f64>() / (count * (count - 1.0))
    };
    let r = |i: usize, j: usize| covariance(i, j) / (u[i] * u[j]);
    let x = duals::<4>(&[means[0], means[1], means[2]]);
    let (sin, cos) = x[2].sin_cos();
    let z = x[0] / x[1];
    let outputs = [z * cos, z * sin, z];
    let cross = |a: &D, b: &D| -> f64 {
        let pairs = (0..3).flat_map(|i| (0..3).map(move |j| (i, j)));
        pairs.map(|(i, j)| a.gradient[i] * covariance(i, j) * b.gradient[j]).sum()
    };
    let u_out = outputs.map(|o| cross(&o, &o).sqrt());
    let r_out = [(0, 1), (0, 2), (1, 2)].map(|(i, j)| cross(&outputs[i], &outputs[j]) / (u_out[i] * u_out[j]));
    let mut add = |name: &'static str, unit: &'static str, found: &[f64], permissible: f64| {
        let expected = data.numbers(&format!("/expected/{name}"));
        rows.add_all(phrase!("selftest-gum", name), unit, [&expected, found], permissible);
    };
    add("means", "V, A, rad", &means, 5e-5);
    add("u_means", "V, A, rad", &u, 5e-5);
    add("r_inputs", "", &[r(0, 1), r(0, 2), r(1, 2)], 5.1e-3);
    add("values_ohm", "Ω", &outputs.map(|o| o.value), 5e-4);
    // one unit of the last published digit: 0.2956 is published as 0.295
    add("u_ohm", "Ω", &u_out, 1e-3);
    add("r_outputs", "", &r_out, 5.1e-4);
    rows
}

/// Calibration curve of a thermometer, by the solver of the program.
fn thermometer(data: &Data) -> Rows {
    let mut rows = Rows::new("JCGM 100:2008, H.3");
    let (t, b) = (data.numbers("/reading_c"), data.numbers("/correction_c"));
    let (reference, at) = (data.number("/reference_c"), data.number("/at_c"));
    let residual = |x: &[D], (t, b): (&f64, &f64)| x[0] + x[1] * (t - reference) - D::from(*b);
    let line = |x: &[D]| t.iter().zip(&b).map(|pair| residual(x, pair)).collect();
    let solution = Function::new(t.len(), line).solve(&[0.0, 0.0]);
    let variance = solution.cost / (t.len() as f64 - 2.0);
    let covariance: Vec<f64> =
        solution.covariance().unwrap_or_else(|| vec![f64::NAN; 4]).iter().map(|c| c * variance).collect();
    let (u, away) = ([covariance[0].sqrt(), covariance[3].sqrt()], at - reference);
    let at_variance = covariance[0] + 2.0 * away * covariance[1] + away * away * covariance[3];
    let mut add = |name: &str, found: f64, permissible: f64| {
        let expected = data.number(&format!("/expected/{name}"));
        rows.add(phrase!("selftest-gum", name), if name == "r" { "" } else { "°C" }, [expected, found], permissible);
    };
    add("y1", solution.x[0], 5e-5);
    add("y2", solution.x[1], 5e-6);
    add("u_y1", u[0], 5e-5);
    add("u_y2", u[1], 5e-6);
    add("r", covariance[1] / (u[0] * u[1]), 5e-4);
    add("s", variance.sqrt(), 5e-5);
    add("correction", solution.x[0] + solution.x[1] * away, 5e-5);
    add("u_correction", at_variance.sqrt(), 5e-5);
    rows
}

/// Draws of a model; each has a stream of its own.
fn draws(data: &Data, model: impl Fn(&mut Noise) -> f64 + Sync) -> Vec<f64> {
    let (count, seed) = (data.number("/draws") as u64, data.number("/seed") as u64);
    (0..count).into_par_iter().map(|trial| model(&mut Noise::new(seed, trial))).collect()
}

/// Permissible deviations of mean and standard uncertainty, and of an end of a 95 % interval: half
/// a unit of the last published digit, and three standard deviations by the number of draws.
fn by_draws(u: f64, draws: f64, half_digit: f64) -> [f64; 2] {
    [half_digit + 3.0 * u / draws.sqrt(), half_digit + 3.0 * OF_END * u / draws.sqrt()]
}

/// Standard deviation of an end of a 95 % interval by one draw, in standard deviations of a normal
/// distribution.
const OF_END: f64 = 2.671;

/// Sums of four quantities: normal, rectangular, and one that dominates.
fn additive(data: &Data) -> Rows {
    let mut rows = Rows::new("JCGM 101:2008, 9.2");
    for name in ["normal", "rectangular", "dominant"] {
        let u = data.numbers(&format!("/{name}/u"));
        let one = |noise: &mut Noise, u: f64| {
            if name == "normal" { noise.gaussian(u) } else { noise.uniform(3f64.sqrt() * u) }
        };
        let found = Distribution::new(draws(data, |noise| u.iter().map(|u| one(noise, *u)).sum()));
        let expected = data.number(&format!("/{name}/expected/u"));
        let half_digit = if name == "dominant" { 0.06 } else { 0.006 };
        let [of_u, of_end] = by_draws(expected, data.number("/draws"), half_digit);
        rows.add(phrase!("selftest-draws-u", name), "", [expected, found.sd], of_u);
        let ends = data.numbers(&format!("/{name}/expected/interval"));
        rows.add_all(phrase!("selftest-draws-interval", name, percent = 95), "", [&ends, &found.interval], of_end);
    }
    rows
}

/// Mass of a weight by comparison in air.
fn mass(data: &Data) -> Rows {
    let mut rows = Rows::new("JCGM 101:2008, 9.3");
    let d = data.at("/mass");
    let pair = |name: &str| pair(&d, name);
    let (reference, difference) = (pair("/reference_mg"), pair("/difference_mg"));
    let bounds = ["/air", "/weight", "/standard"].map(pair);
    let (middle, half) = (|b: [f64; 2]| 0.5 * (b[0] + b[1]), |b: [f64; 2]| 0.5 * (b[1] - b[0]));
    let nominal = reference[0];
    let found = Distribution::new(draws(data, |noise| {
        let [air, weight, standard] = bounds.map(|b| middle(b) + noise.uniform(half(b)));
        let sum = reference[0] + noise.gaussian(reference[1]) + difference[0] + noise.gaussian(difference[1]);
        sum * (1.0 + (air - d.number("/air_0")) * (1.0 / weight - 1.0 / standard)) - nominal
    }));
    let expected = d.at("/expected");
    let [of_u, of_end] = by_draws(expected.number("/u"), data.number("/draws"), 5e-5);
    rows.add(phrase!("selftest-draws-mean", name = "mass"), "mg", [expected.number("/y"), found.mean], of_u);
    rows.add(phrase!("selftest-draws-u", name = "mass"), "mg", [expected.number("/u"), found.sd], of_u);
    // the published interval is the shortest one
    let ends = expected.numbers("/interval");
    rows.add_all(
        phrase!("selftest-draws-interval", name = "mass", percent = 95),
        "mg",
        [&ends, &found.interval],
        of_end + 2e-3,
    );
    let linear = reference[1].hypot(difference[1]);
    rows.add(phrase!("selftest-linear-u", name = "mass"), "mg", [expected.number("/u_linear"), linear], 5e-5);
    rows
}

/// Two numbers of the reference data.
fn pair(data: &Data, name: &str) -> [f64; 2] {
    let all = data.numbers(name);
    [0, 1].map(|i| all.get(i).copied().unwrap_or(f64::NAN))
}

/// Mismatch of a microwave power meter: X1² + X2².
fn mismatch(data: &Data) -> Rows {
    let mut rows = Rows::new("JCGM 101:2008, 9.4");
    let d = data.at("/mismatch");
    let u = d.number("/u");
    let shortest = d.numbers("/expected/shortest_1e6");
    let count = data.number("/draws");
    for (i, x1) in d.numbers("/x1").into_iter().enumerate() {
        let squares = |noise: &mut Noise| 1e6 * ((x1 + noise.gaussian(u)).powi(2) + noise.gaussian(u).powi(2));
        let mut drawn = draws(data, squares);
        let interval = shortest_interval(&mut drawn, 0.95);
        let found = Distribution::new(drawn);
        let name = format!("x1 = {x1}");
        let at = |name: &str| d.numbers(name).get(i).copied().unwrap_or(f64::NAN);
        let [of_u, of_end] = by_draws(at("/expected/u_1e6"), count, 0.5);
        rows.add(phrase!("selftest-draws-mean", name), "1e-6", [at("/expected/y_1e6"), found.mean], of_u);
        rows.add(phrase!("selftest-draws-u", name), "1e-6", [at("/expected/u_1e6"), found.sd], of_u);
        let ends = shortest.get(2 * i..2 * i + 2).unwrap_or_default();
        // the position of a shortest interval is known by the cube root of the number of draws
        let permissible = of_end + 0.03 * at("/expected/u_1e6");
        rows.add_all(phrase!("selftest-draws-shortest", name, percent = 95), "1e-6", [ends, &interval], permissible);
    }
    rows
}

/// Length of a gauge block: t, normal, arc sine and curvilinear trapezoidal distributions.
fn gauge(data: &Data) -> Rows {
    let mut rows = Rows::new("JCGM 101:2008, 9.5");
    let d = data.at("/gauge");
    let triple = |name: &str| {
        let all = d.numbers(name);
        [0, 1, 2].map(|i| all.get(i).copied().unwrap_or(f64::NAN))
    };
    let scaled = ["/standard_nm", "/difference_nm", "/random_nm", "/systematic_nm"].map(triple);
    let (alpha, theta, cyclic) = (pair(&d, "/alpha_s"), pair(&d, "/theta_0"), pair(&d, "/cyclic"));
    let (delta_alpha, delta_theta) = (triple("/delta_alpha"), triple("/delta_theta"));
    let nominal = d.number("/nominal_nm");
    let mut drawn = draws(data, |noise| {
        let [standard, difference, random, systematic] = scaled.map(|s| student(noise, s));
        let expansion = between(noise, alpha);
        let turn = noise.uniform(0.5) * TAU;
        let wave = 0.5 * (cyclic[0] + cyclic[1]) + 0.5 * (cyclic[1] - cyclic[0]) * turn.sin();
        let temperature = theta[0] + noise.gaussian(theta[1]) + wave;
        let by_alpha = trapezoidal(noise, delta_alpha) * temperature;
        let by_theta = expansion * trapezoidal(noise, delta_theta);
        standard + difference + random + systematic - standard * (by_alpha + by_theta) - nominal
    });
    let interval = shortest_interval(&mut drawn, 0.99);
    let found = Distribution::new(drawn);
    let expected = d.at("/expected");
    let [of_u, of_end] = by_draws(expected.number("/u"), data.number("/draws"), 0.5);
    rows.add(phrase!("selftest-draws-mean", name = "gauge"), "nm", [expected.number("/y"), found.mean], of_u);
    rows.add(phrase!("selftest-draws-u", name = "gauge"), "nm", [expected.number("/u"), found.sd], of_u);
    let permissible = of_end + 0.06 * expected.number("/u");
    let ends = expected.numbers("/shortest_99");
    rows.add_all(
        phrase!("selftest-draws-shortest", name = "gauge", percent = 99),
        "nm",
        [&ends, &interval],
        permissible,
    );
    rows
}

/// Scaled and shifted t distribution: normal over the root of chi-square (JCGM 101:2008, 6.4.9).
fn student(noise: &mut Noise, [at, scale, degrees]: [f64; 3]) -> f64 {
    let chi_square: f64 = (0..degrees as usize).map(|_| noise.gaussian(1.0).powi(2)).sum();
    at + scale * noise.gaussian(1.0) / (chi_square / degrees).sqrt()
}

/// Rectangular distribution between two limits.
fn between(noise: &mut Noise, [low, high]: [f64; 2]) -> f64 {
    0.5 * (low + high) + noise.uniform(0.5 * (high - low))
}

/// Rectangular distribution with inexact limits (JCGM 101:2008, 6.4.3).
fn trapezoidal(noise: &mut Noise, [low, high, inexact]: [f64; 3]) -> f64 {
    let from = low + noise.uniform(inexact);
    let to = low + high - from;
    between(noise, [from, to])
}

/// Shortest interval that holds this share of the draws (JCGM 101:2008, 7.7.4).
fn shortest_interval(drawn: &mut [f64], share: f64) -> [f64; 2] {
    drawn.sort_by(f64::total_cmp);
    let held = (share * drawn.len() as f64) as usize;
    let width = |i: &usize| drawn[i + held] - drawn[*i];
    let first = (0..drawn.len() - held).min_by(|a, b| width(a).total_cmp(&width(b))).unwrap_or(0);
    [drawn[first], drawn[first + held]]
}

/// Distributions that decide: chi-square, F, and the probability of conformity.
fn tables(data: &Data) -> Rows {
    let mut rows = Rows::new("R 4: qchisq, qf");
    let expected = data.numbers("/chi_square/expected");
    let bounds: Vec<f64> =
        data.numbers("/chi_square/degrees").iter().map(|k| Variance::Stated.bound(0.05, *k as usize)).collect();
    rows.add_all(phrase!("selftest-chi-square-table"), "", [&expected, &bounds], 1e-7);
    let degrees = data.number("/chi_square/f_degrees");
    let bound = Variance::Estimated(degrees).bound(0.05, 1);
    rows.add(phrase!("selftest-f-table"), "", [data.number("/chi_square/f_expected"), bound], 1e-7);
    let d = data.at("/decision");
    let probability = conformity_probability(d.number("/value"), d.number("/u"), d.number("/limit"));
    rows.add(phrase!("selftest-conformity"), "", [d.number("/expected"), probability], 5e-4);
    rows
}
