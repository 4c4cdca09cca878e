//! Relative accuracy: distances between poses as any reader computes them from positions, and their uncertainty as it scatters
//! over measurements that are made again.

use crate::support::arms::{SIX_AXES, serial};
use etalon::base::noise::Noise;
use etalon::base::pose::{Vector, minus, norm};
use etalon::identify::{
    DistanceErrors, JudgedErrors, Observation, RelativeErrors, Settings, Systematic, fit_frames, refit_frames,
    wanted_frames,
};
use etalon::math::statistics::SizeStatistics;
use etalon::robots::{Prexyt, Quantity, Robot, Role};

const U_MM: f64 = 0.002;

/// A robot with a truth, and joint values.
struct Case {
    robot: Box<dyn Robot>,
    truth: Vec<f64>,
    poses: Vec<Vec<f64>>,
}

/// Draws joint values.
type Joints = Box<dyn FnMut(&mut Noise) -> Vec<f64>>;

fn cases() -> [Case; 2] {
    let mut noise = Noise::new(45, 1);
    let mut case = |robot: Box<dyn Robot>, mut q: Joints| {
        let off = |quantity| match quantity {
            Quantity::Length => 0.3,
            Quantity::Angle => 2e-3,
            Quantity::Ratio => 1e-3,
        };
        let truth = robot.parameters().iter().map(|p| p.nominal + noise.gaussian(off(p.quantity))).collect();
        let poses = (0..36).map(|_| q(&mut noise)).collect();
        Case { robot, truth, poses }
    };
    let slide = |n: &mut Noise| vec![85.0 + n.uniform(85.0), 150.0 + n.uniform(100.0), 150.0 + n.uniform(100.0)];
    let turn = |n: &mut Noise| (0..6).map(|_| n.uniform(1.2)).collect();
    let arm = Box::new(serial(&SIX_AXES, &["one", "two"], &[]));
    [case(Box::<Prexyt>::default(), Box::new(slide)), case(arm, Box::new(turn))]
}

impl Case {
    fn measure(&self, mut off: impl FnMut() -> f64) -> Vec<Observation> {
        let mut of = |(i, q): (usize, &Vec<f64>)| {
            let mut target = |k: usize| {
                let moved = self.robot.position(&self.truth, q, k).map(|v| v + off());
                Some(if self.robot.dimension() == 2 { [moved[0], moved[1], 0.0] } else { moved })
            };
            Observation {
                // the first two measure one pose
                pose: (i.max(1) as i64).into(),
                cycle: if i == 0 { 2 } else { 1 },
                targets: (0..self.robot.targets().len()).map(&mut target).collect(),
                joints: q.clone(),
                ..Observation::default()
            }
        };
        self.poses.iter().enumerate().map(&mut of).collect()
    }

    fn distances(&self, measured: &[Observation], before: &[f64], values: &[f64]) -> Option<RelativeErrors> {
        let robot = self.robot.as_ref();
        let (calibration, observations) = measured.split_at(24);
        let set_up = wanted_frames(robot, calibration, &settings()).unwrap();
        let errors = JudgedErrors {
            robot,
            values,
            set_up: &set_up,
            calibration,
            observations,
            conditions: &[],
            position_mm: None,
        };
        errors.distances(robot, before, &settings(), &Systematic::default()).unwrap()
    }

    /// Positions of all readings: of a platform its centre in the base.
    fn positions(&self, o: &Observation, values: &[f64]) -> Vec<[Vector; 2]> {
        if let Some(platform) = self.robot.platform() {
            let [k, l] = [0, 1].map(|i| o.targets[i].map(|p| [p[0], p[1]]).unwrap());
            let measured = platform.measured_pose(values, [k, l]);
            let predicted = platform.pose(values, &o.joints);
            return vec![[[measured.x_mm, measured.y_mm, 0.0], [predicted.x_mm, predicted.y_mm, 0.0]]];
        }
        let of = |(k, at): (usize, &Option<Vector>)| [at.unwrap(), self.robot.position(values, &o.joints, k)];
        o.targets.iter().enumerate().map(of).collect()
    }
}

fn settings() -> Settings {
    Settings { standard_uncertainty_mm: Some(U_MM), ..Settings::default() }
}

fn figures(errors: &DistanceErrors) -> [f64; 3] {
    let [_, after] = errors.sizes_mm;
    [after.rms, after.p95, after.max]
}

/// Number of sizes, their mean, root mean square, 95th percentile and maximum.
fn by_hand(mut sizes: Vec<f64>) -> (usize, [f64; 4]) {
    sizes.sort_by(f64::total_cmp);
    let count = sizes.len();
    let rank = 0.95 * (count - 1) as f64;
    let low = sizes[rank.floor() as usize];
    let p95 = low + rank.fract() * (sizes[rank.floor() as usize + 1] - low);
    let mean = sizes.iter().sum::<f64>() / count as f64;
    let rms = (sizes.iter().map(|e| e * e).sum::<f64>() / count as f64).sqrt();
    (count, [mean, rms, p95, sizes[count - 1]])
}

#[test]
fn distances_are_those_of_the_positions_and_the_base_has_no_effect() {
    for case in cases() {
        let mut noise = Noise::new(3, 0);
        let measured = case.measure(|| noise.gaussian(0.05));
        let robot = case.robot.as_ref();
        let before = fit_frames(robot, &measured[..24], &settings()).unwrap();
        let found = case.distances(&measured, &before, &case.truth).expect("distances");
        let judged = &measured[24..];
        let of = |values: &[f64]| {
            let all: Vec<_> = judged.iter().map(|o| case.positions(o, values)).collect();
            let mut sizes = Vec::new();
            for k in 0..all[0].len() {
                for j in 0..all.len() {
                    for i in 0..j {
                        let length = |which: usize| norm(minus(all[j][k][which], all[i][k][which]));
                        sizes.push((length(1) - length(0)).abs());
                    }
                }
            }
            by_hand(sizes)
        };
        let close = |errors: &DistanceErrors, side: usize, (count, expected): (usize, [f64; 4])| {
            let SizeStatistics { mean, rms, p95, max } = errors.sizes_mm[side];
            let worst = [mean, rms, p95, max].iter().zip(expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(errors.pairs == count && worst < 1e-9, "{} {worst}", robot.model());
        };
        close(&found.all, 0, of(&before));
        close(&found.all, 1, of(&case.truth));
        assert_eq!(found.steps.iter().map(|s| s.pairs).sum::<usize>(), found.available);
        let mut elsewhere = case.truth.clone();
        for (value, p) in elsewhere.iter_mut().zip(robot.parameters()) {
            if p.role == Role::Base {
                *value += if p.quantity == Quantity::Length { 700.0 } else { 0.4 };
            }
        }
        assert_ne!(elsewhere, case.truth);
        close(&case.distances(&measured, &before, &elsewhere).expect("distances").all, 1, of(&case.truth));
        // repeats of one pose are no distance
        let again: Vec<Observation> = measured[..24].iter().chain(&measured[..2]).cloned().collect();
        assert!(case.distances(&again, &before, &case.truth).is_none(), "the two readings measure one pose");
    }
}

#[test]
fn uncertainties_are_the_scatter_of_measurements_that_are_made_again() {
    for case in cases() {
        let robot = case.robot.as_ref();
        // what no parameter explains makes figures smooth functions of the noise
        let wave: Vec<f64> = {
            let mut noise = Noise::new(9, 1);
            (0..1000).map(|_| noise.gaussian(0.05)).collect()
        };
        let draw = |trial: u64| {
            let (mut noise, mut k) = (Noise::new(11, trial), 0);
            let measured = case.measure(|| {
                k += 1;
                wave[k % wave.len()] + if trial > 0 { noise.gaussian(U_MM) } else { 0.0 }
            });
            let judged = refit_frames(robot, &measured[..24], &settings(), &case.truth).unwrap();
            case.distances(&measured, &case.truth, &judged).expect("distances").all
        };
        let stated = draw(0).standard_uncertainties_mm.expect("a stated uncertainty");
        let drawn: Vec<[f64; 3]> = (1..=300).map(|trial| figures(&draw(trial))).collect();
        for k in 0..3 {
            let all: Vec<f64> = drawn.iter().map(|f| f[k]).collect();
            let scatter = etalon::math::statistics::standard_deviation(&all);
            println!("{} {k}: {stated:?} {scatter:.6}", robot.model());
            // quantiles change from pair to pair
            let within = if k == 0 { 0.9..1.12 } else { 0.7..1.4 };
            assert!(within.contains(&(scatter / stated[k])), "{} {k}: {} {scatter}", robot.model(), stated[k]);
        }
    }
}
