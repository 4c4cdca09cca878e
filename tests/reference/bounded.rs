//! Bounded least squares: problems of NIST StRD whose bounds leave the optimum out.
//!
//! The answers are of another making: SciPy 1.17 `least_squares(bounds=..., method="trf")` told which bounds hold, then
//! the problem without these parameters was solved in 40-digit arithmetic (mpmath 1.3, Gauss-Newton); 17 digits shown.

#![allow(clippy::excessive_precision)] // digits as computed

use super::nist_strd::{DataSet, log_relative_error};
use etalon::base::noise::Noise;
use etalon::math::solve::{Bounds, Options, Problem, Side, Solution, Step, StepKind, solve, solve_within};
use std::path::Path;

const FREE: (f64, f64) = (f64::NEG_INFINITY, f64::INFINITY);

fn below(upper: f64) -> (f64, f64) {
    (f64::NEG_INFINITY, upper)
}

fn above(lower: f64) -> (f64, f64) {
    (lower, f64::INFINITY)
}

fn bounds(all: &[(f64, f64)]) -> Bounds {
    let (lower, upper) = all.iter().copied().unzip();
    Bounds::new(lower, upper).unwrap()
}

fn gradient(problem: &DataSet, solution: &Solution) -> Vec<f64> {
    let n = solution.x.len();
    let mut jacobian = vec![0.0; problem.residual_count() * n];
    problem.jacobian(&solution.x, &mut jacobian);
    let slope = |k: usize| -> f64 {
        let rows = jacobian.chunks_exact(n);
        let length = rows.clone().map(|row| row[k] * row[k]).sum::<f64>().sqrt();
        rows.zip(&solution.residuals).map(|(row, r)| row[k] * r).sum::<f64>() / length
    };
    (0..n).map(slope).collect()
}

/// The Karush-Kuhn-Tucker conditions: inside, no slope of what is free, and outward slopes at the bounds.
fn is_stationary(problem: &DataSet, solution: &Solution, all: &[(f64, f64)]) {
    let limit = 1e-9 * solution.cost().sqrt();
    for (k, slope) in gradient(problem, solution).into_iter().enumerate() {
        let ((lower, upper), x) = (all[k], solution.x[k]);
        let what = format!("{} b{} = {x}, slope {slope:e}: {:?}", problem.name, k + 1, solution.sides);
        assert!(lower <= x && x <= upper, "{what}");
        match solution.sides[k] {
            Side::Free => assert!(slope.abs() <= limit, "{what}"),
            Side::Lower => assert!(x == lower && (slope >= 0.0 || lower == upper), "{what}"),
            Side::Upper => assert!(x == upper && slope <= 0.0, "{what}"),
        }
    }
}

/// Data set, bounds, sum of squares, parameters.
type Case = (&'static str, Vec<(f64, f64)>, f64, Vec<f64>);

fn cases() -> Vec<Case> {
    vec![
        ("Misra1a", vec![below(230.0), FREE], 0.247_621_969_906_334_61, vec![230.0, 0.000_575_225_772_150_151_59]),
        ("Misra1a", vec![FREE, above(6e-4)], 0.608_054_860_711_988_52, vec![221.944_079_019_078_55, 6e-4]),
        (
            "Rat42",
            vec![FREE, above(2.7), FREE],
            9.163_378_740_929_488_3,
            vec![71.782_707_521_085_924, 2.7, 0.069_944_716_486_503_079],
        ),
        (
            "Rat42",
            vec![below(70.0), FREE, below(0.06)],
            62.684_273_675_536_121,
            vec![70.0, 2.245_117_135_154_518_4, 0.06],
        ),
        (
            "Eckerle4",
            vec![FREE, FREE, above(452.0)],
            0.005_850_543_489_778_241_7,
            vec![1.550_943_207_987_183_7, 4.096_492_960_923_072_3, 452.0],
        ),
        (
            "Chwirut2",
            vec![above(0.2), FREE, below(0.0115)],
            519.819_713_174_603_99,
            vec![0.2, 0.005_631_292_734_960_345_4, 0.010_943_947_665_713_253],
        ),
        (
            "Gauss1",
            vec![FREE, FREE, FREE, below(66.5), FREE, FREE, FREE, above(20.0)],
            2_184.230_891_949_475_4,
            vec![
                97.584_210_140_829_42,
                0.010_673_549_326_677_8,
                101.154_093_297_646_15,
                66.5,
                23.535_429_787_676_061,
                69.828_897_467_195_822,
                178.969_181_985_201_54,
                20.0,
            ],
        ),
        (
            "Gauss1",
            vec![below(97.0), FREE, FREE, FREE, below(22.0), FREE, below(178.0), FREE],
            2_071.046_772_823_677_1,
            vec![
                97.0,
                0.009_969_742_956_028_321_7,
                101.841_535_544_815_07,
                67.350_133_956_581_448,
                22.0,
                70.929_863_128_736_432,
                178.0,
                18.015_614_714_423_604,
            ],
        ),
        (
            "Thurber",
            vec![above(1290.0), FREE, FREE, FREE, FREE, FREE, FREE],
            5_672.380_129_024_426_9,
            vec![
                1290.0,
                1_490.257_376_191_067_3,
                582.022_157_290_975_44,
                75.169_833_758_810_244,
                0.963_794_774_189_849_02,
                0.398_020_621_000_763_23,
                0.050_020_353_835_533_692,
            ],
        ),
        (
            "Thurber",
            vec![FREE, below(1450.0), FREE, FREE, FREE, FREE, below(0.045)],
            5_822.938_450_488_540_4,
            vec![
                1_288.541_577_438_375_9,
                1450.0,
                553.173_154_831_719_74,
                69.611_087_891_840_746,
                0.933_803_153_027_181_47,
                0.382_615_506_624_161_65,
                0.044_383_866_417_591_141,
            ],
        ),
        (
            "MGH09",
            vec![FREE, FREE, FREE, below(0.12)],
            0.000_310_061_595_956_047_25,
            vec![0.194_456_052_820_731_99, 0.157_267_481_658_214_62, 0.117_974_817_926_097_16, 0.12],
        ),
    ]
}

fn data(folder: &Path, name: &str) -> DataSet {
    DataSet::read(&folder.join(name).with_extension("dat"))
}

#[test]
fn optima_on_bounds_match_forty_digit_answers_and_satisfy_kkt() {
    let Some(folder) = crate::reference_data("nist_strd") else { return };
    for (name, all, cost, expected) in cases() {
        let set = data(&folder, name);
        for (k, start) in set.starts.iter().enumerate() {
            // from here SciPy runs along a valley to 1e10 too: the way there has no minimum
            if name == "MGH09" && k == 0 {
                continue;
            }
            let solution = solve_within(&set, start, &bounds(&all), Options::default());
            let digits = log_relative_error(&solution.x, &expected);
            println!("{name:<9} {digits:5.2} digits, {:3} steps, {}", solution.iterations, solution.termination);
            assert!(solution.termination.is_success(), "{name}: {}", solution.termination);
            assert!(digits >= 9.0, "{name}: {:?}", solution.x);
            assert!((solution.cost() / cost - 1.0).abs() < 1e-11, "{name}: {}", solution.cost());
            is_stationary(&set, &solution, &all);
            let covariance = solution.covariance().unwrap();
            let n = start.len();
            for i in 0..n {
                let variance = covariance[i * n + i];
                assert_eq!(variance == 0.0, solution.sides[i] != Side::Free, "{name} b{}: {variance}", i + 1);
            }
        }
    }
}

#[test]
fn bounds_that_hold_nothing_back_change_no_answer() {
    let Some(folder) = crate::reference_data("nist_strd") else { return };
    for name in ["Misra1a", "Chwirut1", "Gauss2", "Hahn1", "Kirby2", "Rat43", "Eckerle4", "ENSO", "Lanczos3", "BoxBOD"]
    {
        let set = data(&folder, name);
        for start in &set.starts {
            let wide: Vec<(f64, f64)> =
                set.certified.iter().zip(start).map(|(c, s)| (c.min(*s) - c.abs(), c.max(*s) + c.abs())).collect();
            let solution = solve_within(&set, start, &bounds(&wide), Options::default());
            let digits = log_relative_error(&solution.x, &set.certified);
            assert!(digits >= 9.0, "{name}: {digits} digits, {}", solution.termination);
            assert_eq!(solution.free().len(), start.len());
        }
    }
}

#[test]
fn random_boxes_end_where_no_feasible_direction_descends() {
    let Some(folder) = crate::reference_data("nist_strd") else { return };
    let mut noise = Noise::new(11, 0);
    let mut held = 0;
    for name in ["Misra1a", "Chwirut2", "Gauss1", "Rat42", "Roszman1", "Misra1d", "Nelson", "DanWood"] {
        let set = data(&folder, name);
        for _ in 0..25 {
            let near = |c: f64, noise: &mut Noise| {
                let (a, b) = (c * (1.0 + noise.gaussian(0.02)), c * (1.0 + noise.gaussian(0.02)));
                (a.min(b), a.max(b))
            };
            let all: Vec<(f64, f64)> = set.certified.iter().map(|&c| near(c, &mut noise)).collect();
            let solution = solve_within(&set, &set.starts[1], &bounds(&all), Options::default());
            assert!(solution.termination.is_success(), "{name}: {} {all:?}", solution.termination);
            is_stationary(&set, &solution, &all);
            held += solution.x.len() - solution.free().len();
        }
    }
    assert!(held > 300, "{held}");
}

#[test]
fn the_log_tells_every_step_and_is_the_same_again() {
    let Some(folder) = crate::reference_data("nist_strd") else { return };
    let set = data(&folder, "MGH10");
    let solution = solve(&set, &set.starts[0], Options::default());
    let taken: Vec<&Step> = solution.log.iter().filter(|s| s.kind != StepKind::Refused).collect();
    assert_eq!(taken.len(), solution.iterations);
    assert!(solution.log.iter().any(|s| s.kind == StepKind::Refused && s.damping > 0.0));
    assert!(solution.log.iter().any(|s| s.kind == StepKind::GaussNewton && s.radius.is_infinite()));
    for (k, step) in taken.iter().enumerate() {
        assert_eq!(step.iteration, k);
    }
    let damped = taken.iter().filter(|s| s.kind == StepKind::Damped);
    assert!(damped.clone().zip(damped.skip(1)).all(|(a, b)| b.cost < a.cost));
    let last = taken.last().unwrap();
    assert!(last.step < 1e-10 && (last.cost / solution.cost() - 1.0).abs() < 1e-10, "{last:?} {}", solution.cost());
    let again = solve(&set, &set.starts[0], Options::default());
    // bit by bit: a gradient that was not computed is no number
    assert_eq!(format!("{:?}", again.log), format!("{:?}", solution.log));
}
