//! Uncertainties of robots whose model is incomplete. Effects that no parameter describes are left out: bending, harmonics, cubic trends, a
//! bent link. Intervals hold the effective parameters (those of the noise-free campaign with many poses of the same region), predictions at
//! fresh poses hold, and uncertainties are continuous in the data. Everything is drawn (synthetic); `ETALON_CAMPAIGNS` states how many.

use crate::identify::drawn::number;
use crate::support::arms::{SIX_AXES, serial};
use etalon::base::noise::Noise;
use etalon::base::pose::norm;
use etalon::compare::significance::Estimate;
use etalon::identify::{
    Comparison, Effects, GivenParameters, Identification, Moved, Observation, Prior, Settings, Variance, Verification,
    identify,
};
use etalon::robots::{Quantity, Robot, Role, Serial};
use rayon::prelude::*;

const NOISE_MM: f64 = 0.02;
/// Poses of the campaign without noise.
const MANY: usize = 1200;
/// Fresh poses at which predictions are compared.
const FRESH: usize = 200;

/// An effect that the model leaves out.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Effect {
    Bending,
    Harmonics,
    Cubic,
    BentLink,
    /// Nothing is left out.
    None,
}

/// Effects that the model leaves out.
const LEFT_OUT: [Effect; 4] = [Effect::Bending, Effect::Harmonics, Effect::Cubic, Effect::BentLink];

impl Effect {
    /// Deflection of the joints, with a coefficient for each joint.
    fn deflected(self, q: &[f64], c: &[f64], amplitude: f64) -> Vec<f64> {
        let by = |j: usize| match (self, j) {
            (Self::Bending, 1) => c[0] * (q[1].sin() + (q[1] + q[2]).sin()),
            (Self::Bending, 2) => c[1] * (q[1] + q[2]).sin(),
            (Self::Bending, 4) => 0.5 * c[2] * (q[1] + q[2] + q[4]).cos(),
            (Self::Harmonics, _) => c[j] * (q[j] + c[6 + j]).sin() + 0.7 * c[12 + j] * (2.0 * q[j] + c[18 + j]).sin(),
            (Self::Cubic, _) => c[j] * q[j].powi(3) / 4.0 + c[6 + j] * q[j].powi(2) / 2.0,
            (Self::BentLink, 1) => c[0] * q[1].sin() * q[2].cos(),
            (Self::BentLink, 3) => c[1] * q[2].sin() * q[1].sin(),
            (Self::BentLink, 5) => c[2] * q[4].cos(),
            _ => 0.0,
        };
        q.iter().enumerate().map(|(j, q)| q + amplitude * by(j)).collect()
    }
}

/// A robot whose model lacks an effect, mounted anywhere.
struct Twin {
    robot: Serial,
    truth: Vec<f64>,
    effect: Effect,
    coefficients: Vec<f64>,
    amplitude: f64,
    middle: Vec<f64>,
    /// All parameters by the campaign without noise.
    effective: Vec<f64>,
    /// Standard deviation (mm) of the misfit of a coordinate.
    misfit_mm: f64,
}

impl Twin {
    /// A twin whose misfit is `ratio` times the noise.
    fn drawn(effect: Effect, ratio: f64, seed: u64) -> Self {
        let mut noise = Noise::new(60, seed);
        let robot = serial(&SIX_AXES, &["a"], &[]);
        let value = |p: &etalon::robots::Parameter| match (p.role, p.quantity) {
            (Role::Base, Quantity::Length) => noise.uniform(1500.0),
            (Role::Base, _) => noise.uniform(1.0),
            (Role::Target, _) => 40.0 + noise.uniform(60.0),
            (_, Quantity::Length) => p.nominal + noise.uniform(0.5),
            (_, Quantity::Angle) => p.nominal + noise.uniform(2e-3),
            (_, Quantity::Ratio) => p.nominal,
        };
        let truth = robot.parameters().iter().map(value).collect();
        let coefficients = (0..24).map(|_| noise.gaussian(1.0)).collect();
        let middle = (0..6).map(|_| noise.uniform(0.3)).collect();
        let mut twin = Self {
            robot,
            truth,
            effect,
            coefficients,
            amplitude: if effect == Effect::None { 0.0 } else { 2e-4 },
            middle,
            effective: Vec::new(),
            misfit_mm: 0.0,
        };
        if effect != Effect::None {
            twin.settle(seed);
            twin.amplitude *= ratio * NOISE_MM / twin.misfit_mm;
        }
        twin.settle(seed);
        twin
    }

    /// Effective parameters and misfit, from many poses without noise.
    fn settle(&mut self, seed: u64) {
        let all = self.observed(MANY, 0.0, &mut Noise::new(61, seed));
        let found = identify(&self.robot, &all, &settings()).expect("identified");
        (self.effective, self.misfit_mm) = (found.values, found.rms);
    }

    /// Observations at poses of the region.
    fn observed(&self, poses: usize, noise_mm: f64, noise: &mut Noise) -> Vec<Observation> {
        let mut observe = |pose: i64| {
            let joints: Vec<f64> = self.middle.iter().map(|q| q + noise.uniform(1.3)).collect();
            let bent = self.effect.deflected(&joints, &self.coefficients, self.amplitude);
            let at = self.robot.position(&self.truth, &bent, 0).map(|v| v + noise.gaussian(noise_mm));
            Observation { pose: pose.into(), cycle: 1, joints, targets: vec![Some(at)], ..Observation::default() }
        };
        (1..=poses as i64).map(&mut observe).collect()
    }

    fn own(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.truth.len()).filter(|&i| self.robot.parameters()[i].role == Role::Robot)
    }

    /// Share of the robot's parameters whose interval holds the effective value.
    fn held(&self, found: &Identification) -> (usize, usize) {
        let estimates = self.own().filter_map(|i| Some((i, estimate(found, i)?)));
        estimates.fold((0, 0), |(held, all), (i, e)| {
            let (low, high) = e.interval();
            (held + usize::from((low..=high).contains(&self.effective[i])), all + 1)
        })
    }

    /// Errors at fresh poses without noise: those within the 95 % interval of a coordinate, the sum of squared errors and of squared
    /// predicted uncertainties (parameters and misfit).
    fn predicted(&self, found: &Identification, noise: &mut Noise) -> (usize, f64, f64) {
        let (n, all) = (found.free.len(), self.truth.len());
        let covariance = found.covariance.as_ref().expect("a covariance");
        let share = (found.degrees_of_freedom as f64 / (found.degrees_of_freedom + n) as f64).sqrt();
        let misfit2 = ((found.rms / share).powi(2) - NOISE_MM.powi(2)).max(0.0);
        let (mut inside, mut errors, mut expected) = (0, 0.0, 0.0);
        for o in self.observed(FRESH, 0.0, noise) {
            let at = o.targets[0].expect("measured");
            let predicted = self.robot.position(&found.values, &o.joints, 0);
            let mut jacobian = vec![0.0; 3 * all];
            self.robot.jacobian(&found.values, &o.joints, &mut jacobian);
            for k in 0..3 {
                let row: Vec<f64> = found.free.iter().map(|&i| jacobian[k * all + i]).collect();
                let by = |(a, j): (usize, &f64)| {
                    j * covariance[a * n..][..n].iter().zip(&row).map(|(c, j)| c * j).sum::<f64>()
                };
                let variance = row.iter().enumerate().map(by).sum::<f64>() + misfit2;
                let error = at[k] - predicted[k];
                inside += usize::from(error.abs() < 1.96 * variance.sqrt());
                errors += error * error;
                expected += variance;
            }
        }
        (inside, errors, expected)
    }
}

fn settings() -> Settings {
    Settings {
        standard_uncertainty_mm: Some(NOISE_MM),
        prior: Prior::TOLERANCES,
        effects: Effects::Usual,
        ..Settings::default()
    }
}

fn estimate(found: &Identification, i: usize) -> Option<Estimate> {
    Some(Estimate {
        value: found.values[i],
        standard_uncertainty: found.standard_uncertainty(i)?,
        degrees: found.degrees_of_freedom(i).unwrap_or(f64::INFINITY),
    })
}

/// Figures of several campaigns of twins.
#[derive(Debug, Default)]
struct Figures {
    effective: (usize, usize),
    inside: usize,
    coordinates: usize,
    errors: f64,
    expected: f64,
}

fn figures(poses: usize, ratio: f64, count: u64) -> Figures {
    let one = |seed: u64| {
        let twin = Twin::drawn(LEFT_OUT[seed as usize % LEFT_OUT.len()], ratio, seed);
        let mut noise = Noise::new(62, seed);
        let found =
            identify(&twin.robot, &twin.observed(poses, NOISE_MM, &mut noise), &settings()).expect("identified");
        let (inside, errors, expected) = twin.predicted(&found, &mut noise);
        Figures { effective: twin.held(&found), inside, coordinates: 3 * FRESH, errors, expected }
    };
    let all: Vec<Figures> = (0..count).into_par_iter().map(one).collect();
    all.into_iter().fold(Figures::default(), |sum, f| Figures {
        effective: (sum.effective.0 + f.effective.0, sum.effective.1 + f.effective.1),
        inside: sum.inside + f.inside,
        coordinates: sum.coordinates + f.coordinates,
        errors: sum.errors + f.errors,
        expected: sum.expected + f.expected,
    })
}

#[test]
fn intervals_hold_effective_parameters_and_predictions_where_the_model_misfits() {
    let count = number("ETALON_CAMPAIGNS", 16);
    for (poses, ratio) in
        [(20, 20.0), (30, 10.0), (60, 1.0), (60, 3.0), (100, 10.0), (100, 20.0), (300, 10.0), (1000, 10.0)]
    {
        let found = figures(poses, ratio, count);
        let effective = found.effective.0 as f64 / found.effective.1 as f64;
        let inside = found.inside as f64 / found.coordinates as f64;
        let expected = (found.expected / found.errors).sqrt();
        println!(
            "{poses} poses, misfit {ratio} × noise, {count} synthetic campaigns: {effective:.3} hold the effective parameter, {inside:.3} \
             of predictions hold, predicted over seen {expected:.2}"
        );
        assert!(effective >= 0.90, "{poses} poses: {effective:.3} hold the effective parameter");
        assert!((0.92..=0.985).contains(&inside), "{poses} poses: {inside:.3} of predictions hold");
        assert!((0.8..=1.25).contains(&expected), "{poses} poses: predicted over seen {expected:.2}");
    }
}

#[test]
fn halves_of_a_region_agree_within_their_uncertainties() {
    let count = number("ETALON_CAMPAIGNS", 40);
    for poses in [60, 120, 400] {
        let one = |seed: u64| -> Vec<f64> {
            let twin = Twin::drawn(LEFT_OUT[seed as usize % LEFT_OUT.len()], 10.0, 100 + seed);
            let all = twin.observed(poses, NOISE_MM, &mut Noise::new(63, seed));
            let z = |key: &dyn Fn(&Observation) -> f64| -> Vec<f64> {
                let mut sorted = all.clone();
                sorted.sort_by(|a, b| key(a).total_cmp(&key(b)));
                let halves = [&sorted[..poses / 2], &sorted[poses / 2..]];
                let found = halves.map(|half| identify(&twin.robot, half, &settings()).expect("identified"));
                let of = |i: usize| {
                    let [Some(a), Some(b)] = found.each_ref().map(|found| estimate(found, i)) else { return None };
                    Some((a.value - b.value) / a.standard_uncertainty.hypot(b.standard_uncertainty))
                };
                twin.own().filter_map(of).collect()
            };
            let by_place = (0..3).flat_map(|axis| z(&move |o| o.targets[0].expect("measured")[axis]));
            by_place.chain((0..6).flat_map(|joint| z(&move |o| o.joints[joint]))).collect()
        };
        let all: Vec<f64> = (0..count).into_par_iter().flat_map_iter(one).collect();
        let rms = (all.iter().map(|z| z * z).sum::<f64>() / all.len() as f64).sqrt();
        println!("{poses} poses, {count} synthetic campaigns: z of halves by region {rms:.2} RMS");
        assert!((0.6..=1.5).contains(&rms), "{poses} poses: z of halves {rms:.2}");
    }
}

#[test]
fn uncertainties_are_continuous_and_fall_with_the_number_of_poses() {
    for (seed, effect) in LEFT_OUT.into_iter().enumerate() {
        let twin = Twin::drawn(effect, 10.0, 200 + seed as u64);
        let medians = |poses: usize| -> Vec<f64> {
            let campaign = |k: u64| {
                let found = identify(&twin.robot, &twin.observed(poses, NOISE_MM, &mut Noise::new(64, k)), &settings());
                let found = found.expect("identified");
                let mut all: Vec<f64> = twin.own().filter_map(|i| found.standard_uncertainty(i)).collect();
                let scale = |i: usize| if twin.robot.parameters()[i].quantity == Quantity::Angle { 300.0 } else { 1.0 };
                all.iter_mut().zip(twin.own()).for_each(|(u, i)| *u *= scale(i));
                norm([all.iter().map(|u| u * u).sum::<f64>().sqrt(), 0.0, 0.0])
            };
            (0..12).into_par_iter().map(campaign).collect()
        };
        let of = |all: &[f64], pick: fn(f64, f64) -> f64| all.iter().copied().reduce(pick).expect("campaigns");
        let [few, many] = [100, 400].map(medians);
        for (poses, all) in [(100, &few), (400, &many)] {
            let spread = of(all, f64::max) / of(all, f64::min);
            println!("{effect:?}, {poses} poses: largest over smallest of twelve {spread:.2}");
            assert!(spread < 1.5, "{effect:?}, {poses} poses: {spread:.2}");
        }
        let mean = |all: &[f64]| all.iter().sum::<f64>() / all.len() as f64;
        assert!(mean(&many) < 1.1 * mean(&few), "{effect:?}: {:.4} and {:.4}", mean(&few), mean(&many));
    }
}

/// Fresh observations compared with a calibration: parameters, and the misfit that its residuals show.
fn verified(twin: &Twin, found: &Identification, observations: &[Observation]) -> Verification {
    let degrees = found.degrees_of_freedom as f64;
    let shown2 = found.rms.powi(2) * (degrees + found.free.len() as f64) / degrees;
    let variance = shown2.max(NOISE_MM.powi(2));
    let covariance = [[variance, 0.0, 0.0], [0.0, variance, 0.0], [0.0, 0.0, variance]];
    let seen = |o: &Observation| Observation { covariances_mm2: vec![Some(covariance)], ..o.clone() };
    let observations: Vec<Observation> = observations.iter().map(seen).collect();
    let given = GivenParameters {
        values: found.values.clone(),
        free: found.free.clone(),
        covariance: found.covariance.clone().expect("a covariance"),
    };
    let settings = &Settings { standard_uncertainty_mm: Some(NOISE_MM), ..Settings::default() };
    let comparison = Comparison { robot: &twin.robot, observations: &observations, settings, given: &given };
    comparison.verify(Variance::Estimated(degrees)).expect("compared")
}

/// An unchanged robot is called changed in 5 % of all cases. A base that moved by ten times the misfit is always found.
#[test]
fn verification_expects_the_misfit_of_the_calibration() {
    let count = number("ETALON_CAMPAIGNS", 60);
    let (mut alarms, mut all) = (0.0, 0.0);
    for (poses, ratio, fresh) in [(60, 5.0, 8), (60, 10.0, 20), (200, 5.0, 20), (200, 20.0, 40), (700, 5.0, 20)] {
        let one = |seed: u64| {
            let twin = Twin::drawn(LEFT_OUT[seed as usize % LEFT_OUT.len()], ratio, 400 + seed);
            let mut noise = Noise::new(66, seed);
            let found = identify(&twin.robot, &twin.observed(poses, NOISE_MM, &mut noise), &settings());
            let found = found.expect("identified");
            let trial = |_| {
                let seen = twin.observed(fresh, NOISE_MM, &mut noise);
                let unchanged = verified(&twin, &found, &seen).is_changed();
                let mut moved = seen;
                moved
                    .iter_mut()
                    .flat_map(|o| o.targets.iter_mut().flatten())
                    .for_each(|at| at[0] += 10.0 * ratio * NOISE_MM);
                let moved = verified(&twin, &found, &moved);
                let named = moved.is_changed() && moved.cause().is_some_and(|cause| cause.moved == Moved::Base);
                [unchanged, moved.is_changed(), named].map(|is| f64::from(u8::from(is)))
            };
            (0..5).map(trial).fold([0.0; 3], |sum, one| [0, 1, 2].map(|k| sum[k] + one[k]))
        };
        let sums: Vec<[f64; 3]> = (0..count).into_par_iter().map(one).collect();
        let [unchanged, changed, named] =
            [0, 1, 2].map(|k| sums.iter().map(|s| s[k]).sum::<f64>() / (5 * count) as f64);
        println!(
            "{poses} poses, misfit {ratio} × noise, verified with {fresh}: {:.1} % false alarms, a moved base found in {:.1} %, named in \
             {:.1} %",
            100.0 * unchanged,
            100.0 * changed,
            100.0 * named
        );
        assert!(changed > 0.99 && named > 0.9, "{poses} poses: {changed} {named}");
        (alarms, all) = (alarms + unchanged, all + 1.0);
    }
    println!("{:.1} % false alarms", 100.0 * alarms / all);
    assert!((0.03..0.07).contains(&(alarms / all)), "{}", alarms / all);
}

#[test]
fn nothing_is_widened_where_the_model_fits() {
    let count = number("ETALON_CAMPAIGNS", 30);
    for poses in [40, 100, 300] {
        let one = |seed: u64| {
            let twin = Twin::drawn(Effect::None, 0.0, 300 + seed);
            let found = identify(&twin.robot, &twin.observed(poses, NOISE_MM, &mut Noise::new(65, seed)), &settings());
            let found = found.expect("identified");
            (twin.held(&found), found.inflation_factor)
        };
        let all: Vec<((usize, usize), f64)> = (0..count).into_par_iter().map(one).collect();
        let held = all.iter().map(|a| a.0.0).sum::<usize>() as f64 / all.iter().map(|a| a.0.1).sum::<usize>() as f64;
        let widened = all.iter().map(|a| a.1).sum::<f64>() / all.len() as f64;
        println!(
            "{poses} poses, no misfit, {count} synthetic campaigns: {held:.3} hold the truth, widened {widened:.3}"
        );
        // parameters of one campaign are correlated: a tenth of them counts
        let allowed = 0.015 + 3.0 * (0.95 * 0.05 / (2.4 * count as f64)).sqrt();
        assert!((held - 0.95).abs() < allowed, "{poses} poses: {held:.3} hold the truth");
        assert!(widened < 1.02, "{poses} poses: widened {widened:.3} times");
    }
}
