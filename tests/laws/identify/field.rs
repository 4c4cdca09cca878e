//! Residual fields: refused on noise alone, and of bending and harmonics that the model leaves out most of the error is recovered at
//! poses that were not measured, with an uncertainty that holds. Everything is drawn (synthetic); `ETALON_CAMPAIGNS` states how many.

use crate::identify::drawn::number;
use crate::support::arms::{SIX_AXES, serial};
use etalon::base::noise::Noise;
use etalon::base::pose::norm;
use etalon::base::pose_name::PoseName;
use etalon::identify::{
    Corrected, Effects, FieldRefusal, FieldTrial, Identification, JointField, Observation, Prior, Settings, identify,
    search_field,
};
use etalon::math::statistics::rms;
use etalon::robots::{Correction, Quantity, Robot, Role, Serial};
use rayon::prelude::*;

const NOISE_MM: f64 = 0.02;
const TARGETS: [&str; 3] = ["a", "b", "c"];

/// What the model leaves out.
#[derive(Clone, Copy, Debug, PartialEq)]
enum LeftOut {
    Nothing,
    /// Joints 2 and 3 bend: 1 mrad under their largest load.
    Bending,
    /// Joints 2, 3 and 4 are off by waves of one and two periods a turn.
    Harmonics,
}

/// A robot as it is, with its own wave of each joint.
struct Truth {
    robot: Serial,
    values: Vec<f64>,
    waves: Vec<(usize, f64, f64, f64)>,
}

impl Truth {
    fn drawn(left_out: LeftOut, noise: &mut Noise) -> Self {
        let robot = serial(&SIX_AXES, &TARGETS, if left_out == LeftOut::Bending { &[2, 3] } else { &[] });
        let value = |p: &etalon::robots::Parameter, noise: &mut Noise| match (p.role, p.quantity) {
            (Role::Base, Quantity::Length) => noise.uniform(1500.0),
            (Role::Base, _) => noise.uniform(1.0),
            (Role::Target, _) => noise.uniform(90.0),
            _ if p.name.starts_with("compliance") => 1e-3,
            (_, Quantity::Length) => p.nominal + noise.uniform(0.3),
            (_, Quantity::Angle) => p.nominal + noise.uniform(1e-3),
            (_, Quantity::Ratio) => p.nominal,
        };
        let values = robot.parameters().iter().map(|p| value(p, noise)).collect();
        let waves = match left_out {
            LeftOut::Harmonics => {
                let wave = |(joint, periods)| {
                    (joint, 2e-4 + noise.uniform(1e-4), periods, noise.uniform(std::f64::consts::PI))
                };
                [(1, 1.0), (1, 2.0), (2, 2.0), (3, 1.0)].map(wave).to_vec()
            }
            _ => Vec::new(),
        };
        Self { robot, values, waves }
    }

    fn observe(&self, poses: std::ops::Range<i64>, half_range: f64, noise: &mut Noise) -> Vec<Observation> {
        let observe = |pose: i64| {
            let joints: Vec<f64> = (0..6).map(|_| noise.uniform(half_range)).collect();
            let mut bent = joints.clone();
            for (joint, amplitude, periods, phase) in &self.waves {
                bent[*joint] += amplitude * (periods * joints[*joint] + phase).sin();
            }
            let mut seen = |k| Some(self.robot.position(&self.values, &bent, k).map(|v| v + noise.gaussian(NOISE_MM)));
            let targets = (0..TARGETS.len()).map(&mut seen).collect();
            Observation { pose: pose.into(), cycle: 1, joints, targets, ..Observation::default() }
        };
        poses.map(observe).collect()
    }
}

struct Campaign {
    model: Serial,
    found: Identification,
    trial: FieldTrial,
    fresh: Vec<Observation>,
}

fn campaign(left_out: LeftOut, poses: i64, seed: u64) -> Campaign {
    spoilt(left_out, poses, seed, &|_| {})
}

/// A campaign whose observations are changed before the identification.
fn spoilt(left_out: LeftOut, poses: i64, seed: u64, spoil: &dyn Fn(&mut [Observation])) -> Campaign {
    let mut noise = Noise::new(451, seed);
    let truth = Truth::drawn(left_out, &mut noise);
    let model = serial(&SIX_AXES, &TARGETS, &[]);
    let mut observations = truth.observe(1..poses + 1, 1.3, &mut noise);
    spoil(&mut observations);
    let settings = Settings {
        standard_uncertainty_mm: Some(NOISE_MM),
        prior: Prior::TOLERANCES,
        effects: Effects::Usual,
        ..Settings::default()
    };
    let found = identify(&model, &observations, &settings).expect("identified");
    let trial = search_field(&model, &observations, &settings, &found);
    let fresh = truth.observe(1000..1100, 1.3, &mut noise);
    Campaign { model, found, trial, fresh }
}

impl Campaign {
    /// Root mean square position error at fresh poses, without the field and with it.
    fn errors(&self, field: &JointField) -> [f64; 2] {
        let corrected = Corrected::new(&self.model, field);
        let error = |robot: &dyn Robot| {
            rms(self
                .fresh
                .iter()
                .flat_map(|o| o.misses(robot, &self.found.values).map(|(_, m)| norm(m)).collect::<Vec<_>>()))
        };
        [error(&self.model), error(&corrected)]
    }

    /// Coordinates at fresh poses within 1.96 standard uncertainties, and all of them.
    fn covered(&self, field: &JointField) -> [usize; 2] {
        let corrected = Corrected::new(&self.model, field);
        let mut counts = [0; 2];
        for o in &self.fresh {
            for (k, miss) in o.misses(&corrected, &self.found.values) {
                let covariance = field.covariance_mm2(&self.model, &self.found.values, &o.joints, k);
                for axis in 0..3 {
                    let u = (covariance[(axis, axis)] + NOISE_MM.powi(2)).sqrt();
                    counts[0] += usize::from(miss[axis].abs() <= 1.96 * u);
                    counts[1] += 1;
                }
            }
        }
        counts
    }
}

#[test]
#[ignore = "a long law: make laws"]
fn noise_alone_shows_no_field() {
    let count = number("ETALON_CAMPAIGNS", 200);
    for poses in [40, 80] {
        let refused = |seed: u64| campaign(LeftOut::Nothing, poses, seed).trial.refusal.is_some();
        let refused = (0..count).into_par_iter().filter(|&seed| refused(seed)).count();
        println!("{poses} poses, noise alone: a field is refused in {refused} of {count} synthetic campaigns");
        assert!(refused as f64 >= 0.95 * count as f64, "{poses} poses: refused in {refused} of {count}");
    }
}

#[test]
#[ignore = "a long law: make laws"]
fn most_of_what_the_model_leaves_out_is_recovered_with_its_uncertainty() {
    let count = number("ETALON_CAMPAIGNS", 40).min(40);
    for (left_out, poses, least) in
        [(LeftOut::Bending, 50, 0.5), (LeftOut::Bending, 100, 0.7), (LeftOut::Harmonics, 100, 0.6)]
    {
        let of = |seed: u64| {
            let campaign = campaign(left_out, poses, seed);
            let field = campaign.trial.field.as_ref()?;
            let held = campaign.trial.held_out.as_ref()?;
            Some((campaign.errors(field), campaign.covered(field), held.coverage, field.factor, field.components.len()))
        };
        let all: Vec<_> = (0..count).into_par_iter().filter_map(of).collect();
        let mean = |of: &dyn Fn(usize) -> f64| (0..all.len()).map(of).sum::<f64>() / all.len() as f64;
        let noise = 3.0 * NOISE_MM.powi(2);
        // beyond the noise of the fresh readings themselves
        let left = |i: usize| (all[i].0[1].powi(2) - noise).max(0.0) / (all[i].0[0].powi(2) - noise);
        let (before, after) = (mean(&|i| all[i].0[0]), mean(&|i| all[i].0[1]));
        let recovered = 1.0 - mean(&left).sqrt();
        let coverage =
            all.iter().map(|a| a.1[0]).sum::<usize>() as f64 / all.iter().map(|a| a.1[1]).sum::<usize>() as f64;
        println!(
            "{left_out:?}, {poses} poses, {} of {count} synthetic campaigns with a field of {:.1} components: {before:.4} mm → {after:.4} mm \
             at fresh poses, {recovered:.2} of the model's error recovered, coverage {coverage:.3} (held out {:.3}, factor {:.2})",
            all.len(),
            mean(&|i| all[i].4 as f64),
            mean(&|i| all[i].2),
            mean(&|i| all[i].3)
        );
        assert!(all.len() as u64 * 10 >= 9 * count, "{left_out:?}: a field in {} of {count}", all.len());
        assert!(recovered >= least, "{left_out:?}, {poses} poses: {recovered:.2} recovered");
        assert!((coverage - 0.95).abs() <= 0.03, "{left_out:?}, {poses} poses: coverage {coverage:.3}");
    }
}

/// A blunder, as a change of the observations.
type Blunder = (&'static str, fn(&mut [Observation], usize));

const BLUNDERS: [Blunder; 4] = [
    ("one pose moved by 1 mm", |all, k| {
        all[k].targets.iter_mut().flatten().for_each(|p| p[k % 3] += 1.0);
    }),
    ("one reading moved by 1 mm", |all, k| all[k].targets[0].iter_mut().for_each(|p| p[k % 3] += 1.0)),
    ("one exchanged label", |all, k| all[k].targets.swap(0, 1)),
    ("one joint value off by 0.3 deg", |all, k| all[k].joints[1] += 0.3f64.to_radians()),
];

/// No field is accepted, and a moved pose is named in most campaigns: a field has errors that neighbouring poses share.
#[test]
#[ignore = "a long law: make laws"]
fn a_blunder_is_named_and_no_field_describes_it() {
    let count = number("ETALON_CAMPAIGNS", 4).min(12);
    let left_out = [LeftOut::Nothing, LeftOut::Bending, LeftOut::Harmonics];
    for (what, blunder) in BLUNDERS {
        for left_out in left_out {
            let outcome = |seed: u64| {
                let k = 5 + 7 * seed as usize % 80;
                let trial = spoilt(left_out, 100, seed, &|all| blunder(all, k)).trial;
                let named = matches!(trial.refusal, Some(FieldRefusal::Suspect(pose, _)) if pose == PoseName::from(k as i64 + 1));
                (named, trial.field.is_some(), trial.refusal)
            };
            let all: Vec<_> = (0..count).into_par_iter().map(outcome).collect();
            let named = all.iter().filter(|(named, ..)| *named).count();
            let accepted = all.iter().filter(|(_, accepted, _)| *accepted).count();
            println!("{what}, left out {left_out:?}: pose named in {named} of {count}, a field in {accepted}");
            assert_eq!(accepted, 0, "{what}, {left_out:?}");
            // where nothing is left out, and where labels or joint values are wrong, the field has nothing to name: the
            // identification names outliers; where 1 mm of bending is left out, another pose may have a larger residual
            let is_moved = what.ends_with("moved by 1 mm") && left_out != LeftOut::Nothing;
            assert!(!is_moved || 4 * named as u64 >= 3 * count, "{what}, {left_out:?}: {all:?}");
        }
    }
}

#[test]
fn beyond_the_poses_a_field_fades_out_and_its_uncertainty_grows() {
    let campaign = campaign(LeftOut::Bending, 100, 7);
    let field = campaign.trial.field.as_ref().expect("a field");
    let values = &campaign.found.values;
    let u = |q: &[f64]| field.covariance_mm2(&campaign.model, values, q, 0).trace().sqrt();
    let (within, beyond) = (vec![0.1; 6], vec![0.0, 2.6, -2.9, 0.0, 0.0, 0.0]);
    assert_eq!((field.share(&within), field.share(&beyond)), (1.0, 0.0));
    let [plain, same] = [&beyond, &beyond].map(|q| campaign.model.position(values, q, 0));
    let corrected = Corrected::new(&campaign.model, field).position(values, &beyond, 0);
    assert_eq!(corrected, plain);
    assert_eq!(plain, same);
    assert!(u(&beyond) > 3.0 * u(&within), "{} {}", u(&beyond), u(&within));
}

#[test]
fn few_poses_are_refused_with_the_number_needed() {
    let campaign = campaign(LeftOut::Bending, 15, 1);
    let Some(FieldRefusal::TooFewPoses(15, needed)) = campaign.trial.refusal else {
        panic!("{:?}", campaign.trial.refusal)
    };
    assert!((20..=30).contains(&needed), "{needed}");
}
