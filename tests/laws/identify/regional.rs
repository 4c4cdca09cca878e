//! Uncertainties of robots whose model is incomplete. Effects that no parameter describes are left out: bending, harmonics, cubic trends, a
//! bent link. Intervals hold the effective parameters (of the noise-free campaign with many poses of the same region), predictions at
//! fresh poses hold, and uncertainties are continuous in the data. Everything is drawn (synthetic); `ETALON_CAMPAIGNS` states how many.

use crate::identify::drawn::number;
use crate::support::arms::{SIX_AXES, serial};
use etalon::base::noise::Noise;
use etalon::base::pose::{Pose, Vector, minus, norm};
use etalon::base::pose_name::PoseName;
use etalon::compare::significance::Estimate;
use etalon::documents::{ParametersDocument, VerificationVerdict, parameters_document};
use etalon::identify::{
    Condition, Contact, Effects, Fixture, Identification, Kind, Observation, Orientation, Prior, Settings, fit_frames,
    identify, identify_from,
};
use etalon::robots::{FreeBase, Quantity, Robot, Role, Serial};
use etalon::stages::calibrate::identification::state_positions;
use etalon::stages::kinds::Observed;
use etalon::stages::verify::expected_scatter::ExpectedScatter;
use etalon::stages::verify::verification::{EarlierCalibration, verify};
use nalgebra::{DMatrix, DVector};
use rayon::prelude::*;
use std::collections::BTreeMap;

const NOISE_MM: f64 = 0.02;
const NOISE_RAD: f64 = 5e-5;
/// Largest distance (rad) of a joint from the middle of the region.
const REGION_RAD: f64 = 1.3;
/// Poses of the campaign without noise.
const MANY: usize = 1200;
/// Fresh poses at which predictions are compared.
const FRESH: usize = 200;

/// An effect that the model leaves out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Effect {
    Bending,
    Harmonics,
    Cubic,
    BentLink,
    /// Nothing is left out.
    None,
}

/// Effects that the model leaves out.
pub(super) const LEFT_OUT: [Effect; 4] = [Effect::Bending, Effect::Harmonics, Effect::Cubic, Effect::BentLink];

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

/// What is measured at the poses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Measured {
    Positions,
    /// Positions of three targets.
    Targets,
    /// Positions and orientations.
    Poses,
    /// Positions at every other pose, and contacts with four sockets at the others.
    Contacts,
}

/// Observations and their settings.
#[derive(Clone)]
pub(super) struct Campaign {
    pub(super) observations: Vec<Observation>,
    pub(super) settings: Settings,
}

/// A robot whose model lacks an effect, mounted anywhere.
pub(super) struct Twin {
    pub(super) robot: Serial,
    pub(super) measured: Measured,
    /// First parameters of the mounting of the body, or of the sockets.
    pub(super) fixtures: Vec<usize>,
    truth: Vec<f64>,
    effect: Effect,
    coefficients: Vec<f64>,
    amplitude: f64,
    middle: Vec<f64>,
    /// All parameters by the campaign without noise.
    effective: Vec<f64>,
    /// Standard deviation (mm) of the misfit of a coordinate.
    pub(super) misfit_mm: f64,
}

impl Twin {
    /// A twin whose misfit is `ratio` times the noise.
    pub(super) fn drawn(measured: Measured, effect: Effect, ratio: f64, seed: u64) -> Self {
        let mut noise = Noise::new(60, seed);
        let targets: &[&str] = if measured == Measured::Targets { &["a", "b", "c"] } else { &["a"] };
        let mut robot = serial(&SIX_AXES, targets, &[]);
        let value = |p: &etalon::robots::Parameter| match (p.role, p.quantity) {
            (Role::Base, Quantity::Length) => noise.uniform(1500.0),
            (Role::Base, _) => noise.uniform(1.0),
            (Role::Target, _) => 40.0 + noise.uniform(60.0),
            (_, Quantity::Length) => p.nominal + noise.uniform(0.5),
            (_, Quantity::Angle) => p.nominal + noise.uniform(2e-3),
            (_, Quantity::Ratio) => p.nominal,
        };
        let mut truth: Vec<f64> = robot.parameters().iter().map(value).collect();
        let coefficients = (0..24).map(|_| noise.gaussian(1.0)).collect();
        let middle: Vec<f64> = (0..6).map(|_| noise.uniform(0.3)).collect();
        let fixtures: Vec<Fixture> = match measured {
            Measured::Positions | Measured::Targets => Vec::new(),
            Measured::Poses => vec![Fixture::Mounting("a")],
            Measured::Contacts => ["s1", "s2", "s3", "s4"].map(Fixture::Point).to_vec(),
        };
        let mut place = |fixture: Fixture| -> Vector {
            match fixture {
                Fixture::Point(_) => {
                    let joints: Vec<f64> = middle.iter().map(|q| q + noise.uniform(0.8)).collect();
                    robot.position(&truth, &joints, 0)
                }
                _ => [0.4, -1.1, 2.2],
            }
        };
        let places: Vec<Vector> = fixtures.iter().map(|f| place(*f)).collect();
        let mut add = |(fixture, place): (Fixture, Vector)| {
            let first = fixture.add_to(&mut robot);
            truth.truncate(first);
            truth.extend(place);
            first
        };
        let fixtures = fixtures.into_iter().zip(places).map(&mut add).collect();
        let mut twin = Self {
            robot,
            measured,
            fixtures,
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
        let found = self.identified(&all);
        self.misfit_mm = self.rms_mm(&all, &found.values);
        self.effective = found.values;
    }

    fn identified(&self, campaign: &Campaign) -> Identification {
        identify(&self.robot, &campaign.observations, &campaign.settings).expect("identified")
    }

    /// Root mean square (mm) of the residual of a coordinate.
    pub(super) fn rms_mm(&self, campaign: &Campaign, values: &[f64]) -> f64 {
        let off = |(o, target): (&Observation, usize)| {
            minus(o.targets[target].expect("measured"), self.robot.position(values, &o.joints, target))
                .map(|v| v * v / 3.0)
        };
        let targets = self.robot.targets().len();
        let readings = campaign.observations.iter().flat_map(|o| (0..targets).map(move |target| (o, target)));
        let squares = readings.flat_map(off).sum::<f64>();
        (squares / (targets * campaign.observations.len()) as f64).sqrt()
    }

    /// The joints of the robot, of which the target has the place `at` where it is given.
    fn joints(&self, at: Option<Vector>, noise: &mut Noise) -> Vec<f64> {
        loop {
            let mut q: Vec<f64> = self.middle.iter().map(|q| q + noise.uniform(REGION_RAD)).collect();
            let Some(at) = at else { return q };
            for _ in 0..30 {
                let left = |q: &[f64]| DVector::from(minus(self.position(q, 0), at).to_vec());
                let now = left(&q);
                if now.amax() < 1e-9 {
                    break;
                }
                let by = |j: usize, h: f64| {
                    let mut moved = q.clone();
                    moved[j] += h;
                    left(&moved)
                };
                let columns: Vec<DVector<f64>> = (0..6).map(|j| (by(j, 1e-5) - by(j, -1e-5)) / 2e-5).collect();
                let a = DMatrix::from_columns(&columns);
                let Some(inverse) = (&a * a.transpose()).try_inverse() else { break };
                let step = a.transpose() * inverse * now;
                let shorten = (0.3 / step.amax()).min(1.0);
                q.iter_mut().zip(step.iter()).for_each(|(q, s)| *q -= shorten * s);
            }
            let inside = q.iter().zip(&self.middle).all(|(q, middle)| (q - middle).abs() < REGION_RAD);
            if inside && norm(minus(self.position(&q, 0), at)) < 1e-6 {
                return q;
            }
        }
    }

    fn bent(&self, joints: &[f64]) -> Vec<f64> {
        self.effect.deflected(joints, &self.coefficients, self.amplitude)
    }

    /// Position of a target on the robot with the effect that the model leaves out.
    fn position(&self, joints: &[f64], target: usize) -> Vector {
        self.robot.position(&self.truth, &self.bent(joints), target)
    }

    /// Measurements at poses of the region; `noise_scale` multiplies their noise.
    pub(super) fn observed(&self, poses: usize, noise_scale: f64, noise: &mut Noise) -> Campaign {
        let mut campaign = Campaign { observations: Vec::new(), settings: settings() };
        for number in 1..=poses {
            let pose = PoseName::from(number as i64);
            let mut observe = |joints: Vec<f64>, kind, standard_uncertainty| {
                let condition = Condition { pose, cycle: 1, joints, target: 0, kind, standard_uncertainty };
                campaign.settings.conditions.push(condition);
            };
            if self.measured == Measured::Contacts && number % 2 == 0 {
                let socket = self.fixtures[number / 2 % self.fixtures.len()];
                let place: Vector = [0, 1, 2].map(|k| self.truth[socket + k]);
                let joints = self.joints(Some(place.map(|v| v + noise.gaussian(noise_scale * NOISE_MM))), noise);
                observe(joints, Kind::Contact(Contact { socket }), NOISE_MM);
                continue;
            }
            let joints = self.joints(None, noise);
            let see = |target| self.position(&joints, target).map(|v| v + noise.gaussian(noise_scale * NOISE_MM));
            let targets: Vec<Option<Vector>> = (0..self.robot.targets().len()).map(see).map(Some).collect();
            if self.measured == Measured::Poses {
                let mounting = self.fixtures[0];
                let turn = Pose::from_rotation_vector([0, 1, 2].map(|k| self.truth[mounting + k]));
                let off = Pose::from_rotation_vector([0; 3].map(|_| noise.gaussian(noise_scale * NOISE_RAD)));
                let flange = self.robot.flange(&self.truth, &self.bent(&joints), 0);
                let body = Pose { translation_mm: [0.0; 3], ..off.then(&flange).then(&turn) };
                observe(
                    joints.clone(),
                    Kind::Orientation(Orientation { frame_T_body: body, station: None, mounting }),
                    NOISE_RAD,
                );
            }
            campaign.observations.push(Observation { pose, cycle: 1, joints, targets, ..Observation::default() });
        }
        campaign
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
    fn predicted(&self, campaign: &Campaign, found: &Identification, noise: &mut Noise) -> (usize, f64, f64) {
        let (n, all) = (found.free.len(), self.truth.len());
        let covariance = found.uncertainty.covariance.as_ref().expect("a covariance");
        let share = found.residuals.degrees_of_freedom as f64 / (found.residuals.degrees_of_freedom + n) as f64;
        let misfit2 = (self.rms_mm(campaign, &found.values).powi(2) / share - NOISE_MM.powi(2)).max(0.0);
        let (mut inside, mut errors, mut expected) = (0, 0.0, 0.0);
        for _ in 0..FRESH {
            let joints = self.joints(None, noise);
            let at = self.position(&joints, 0);
            let predicted = self.robot.position(&found.values, &joints, 0);
            let mut jacobian = vec![0.0; 3 * all * self.robot.targets().len()];
            self.robot.jacobian(&found.values, &joints, &mut jacobian);
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

fn figures(measured: Measured, poses: usize, ratio: f64, count: u64) -> Figures {
    let one = |seed: u64| {
        let twin = Twin::drawn(measured, LEFT_OUT[seed as usize % LEFT_OUT.len()], ratio, seed);
        let mut noise = Noise::new(62, seed);
        let campaign = twin.observed(poses, 1.0, &mut noise);
        let found = twin.identified(&campaign);
        let (inside, errors, expected) = twin.predicted(&campaign, &found, &mut noise);
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
#[ignore = "a long law: make laws"]
fn intervals_hold_effective_parameters_and_predictions_where_the_model_misfits() {
    let count = number("ETALON_CAMPAIGNS", 10);
    use Measured::{Contacts, Poses, Positions, Targets};
    for (measured, poses, ratio) in [
        (Positions, 20, 20.0),
        (Positions, 30, 10.0),
        (Positions, 60, 1.0),
        (Positions, 60, 3.0),
        (Positions, 100, 10.0),
        (Positions, 100, 20.0),
        (Positions, 300, 10.0),
        (Positions, 1000, 10.0),
        (Targets, 60, 10.0),
        (Poses, 30, 10.0),
        (Poses, 100, 3.0),
        (Poses, 100, 10.0),
        (Poses, 300, 20.0),
        (Contacts, 60, 3.0),
        (Contacts, 100, 10.0),
        (Contacts, 300, 20.0),
    ] {
        let found = figures(measured, poses, ratio, count);
        let effective = found.effective.0 as f64 / found.effective.1 as f64;
        let inside = found.inside as f64 / found.coordinates as f64;
        let expected = (found.expected / found.errors).sqrt();
        println!(
            "{measured:?}, {poses} poses, misfit {ratio} × noise, {count} synthetic campaigns: {effective:.3} hold the effective parameter, {inside:.3} \
             of predictions hold, predicted over seen {expected:.2}"
        );
        assert!(effective >= 0.90, "{measured:?}, {poses} poses: {effective:.3} hold the effective parameter");
        assert!((0.92..=0.985).contains(&inside), "{measured:?}, {poses} poses: {inside:.3} of predictions hold");
        assert!((0.8..=1.25).contains(&expected), "{measured:?}, {poses} poses: predicted over seen {expected:.2}");
    }
}

/// Campaigns of one half of the values of a joint predict poses of the other half: the model lacks bending, harmonics or a trend, so that
/// residuals understate the errors there. Within the half, the residuals give the intervals.
#[test]
#[ignore = "a long law: make laws"]
fn intervals_hold_beyond_the_measured_values_of_a_joint() {
    let count = number("ETALON_CAMPAIGNS", 12);
    // coordinates, coordinates within intervals that grow, and within those that do not: beyond and inside the measured values
    let one = |seed: u64| -> [[usize; 3]; 2] {
        let twin = Twin::drawn(Measured::Positions, LEFT_OUT[seed as usize % LEFT_OUT.len()], 10.0, 300 + seed);
        let joint = 1 + seed as usize / LEFT_OUT.len() % 2;
        let mut noise = Noise::new(67, seed);
        let is_low = |o: &Observation| o.joints[joint] < twin.middle[joint];
        let mut campaign = twin.observed(240, 1.0, &mut noise);
        campaign.observations.retain(is_low);
        let found = twin.identified(&campaign);
        let document = parameters_document(&twin.robot, &campaign.settings, &found.values, &found, &BTreeMap::new());
        let expected = ExpectedScatter::from_document(&twin.robot, &document).expect("residuals");
        let covariance = found.uncertainty.covariance.as_ref().expect("a covariance");
        let (n, all) = (found.free.len(), twin.robot.parameters().len());
        let mut sums = [[0; 3]; 2];
        for o in twin.observed(FRESH, 1.0, &mut noise).observations {
            let mut jacobian = vec![0.0; 3 * all];
            twin.robot.jacobian(&found.values, &o.joints, &mut jacobian);
            let [growth, _] = expected.growth(&twin.robot, &o.joints);
            let error = minus(o.targets[0].expect("measured"), twin.robot.position(&found.values, &o.joints, 0));
            let sums = &mut sums[usize::from(is_low(&o))];
            for k in 0..3 {
                let row: Vec<f64> = found.free.iter().map(|&i| jacobian[k * all + i]).collect();
                let by = |(a, j): (usize, &f64)| {
                    j * covariance[a * n..][..n].iter().zip(&row).map(|(c, j)| c * j).sum::<f64>()
                };
                let own = row.iter().enumerate().map(by).sum::<f64>();
                let holds =
                    |growth: f64| error[k].abs() < 1.96 * (own + growth * expected.coordinate_mm.powi(2)).sqrt();
                let more = [1, usize::from(holds(growth)), usize::from(holds(1.0))];
                sums.iter_mut().zip(more).for_each(|(sum, more)| *sum += more);
            }
        }
        sums
    };
    let all: Vec<[[usize; 3]; 2]> = (0..count).into_par_iter().map(one).collect();
    let [beyond, inside] = [0, 1].map(|part| {
        let sum = |k: usize| all.iter().map(|sums| sums[part][k]).sum::<usize>() as f64;
        [1, 2].map(|k| sum(k) / sum(0))
    });
    println!("{count} synthetic campaigns: beyond {beyond:.3?}, inside {inside:.3?} hold with growth and without");
    assert!(beyond[1] < 0.85, "without growth {:.3} hold beyond the measured values", beyond[1]);
    assert!((0.88..=0.995).contains(&beyond[0]), "with growth {:.3} hold beyond the measured values", beyond[0]);
    assert!((0.92..=0.99).contains(&inside[0]) && inside[0] == inside[1], "inside {inside:?}");
}

#[test]
#[ignore = "a long law: make laws"]
fn halves_of_a_region_agree_within_their_uncertainties() {
    let count = number("ETALON_CAMPAIGNS", 40);
    for poses in [60, 120, 400] {
        let one = |seed: u64| -> Vec<f64> {
            let twin = Twin::drawn(Measured::Positions, LEFT_OUT[seed as usize % LEFT_OUT.len()], 10.0, 100 + seed);
            let all = twin.observed(poses, 1.0, &mut Noise::new(63, seed));
            let z = |key: &dyn Fn(&Observation) -> f64| -> Vec<f64> {
                let mut sorted = all.observations.clone();
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
#[ignore = "a long law: make laws"]
fn uncertainties_are_continuous_and_fall_with_the_number_of_poses() {
    for (seed, effect) in LEFT_OUT.into_iter().enumerate() {
        let twin = Twin::drawn(Measured::Positions, effect, 10.0, 200 + seed as u64);
        let medians = |poses: usize| -> Vec<f64> {
            let campaign = |k: u64| {
                let found = twin.identified(&twin.observed(poses, 1.0, &mut Noise::new(64, k)));
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

/// A calibration, as its document states it.
struct Calibration<'a> {
    twin: &'a Twin,
    document: ParametersDocument,
}

impl<'a> Calibration<'a> {
    fn new(twin: &'a Twin, campaign: &Campaign) -> Self {
        let Campaign { observations, settings } = campaign;
        let before = fit_frames(&twin.robot, observations, settings).expect("frames");
        let found = identify_from(&twin.robot, observations, settings, &before).expect("identified");
        let mut document = parameters_document(&twin.robot, settings, &before, &found, &BTreeMap::new());
        state_positions(&mut document, &twin.robot, observations, [&before, &found.values]);
        Self { twin, document }
    }

    /// Verdict on the calibration by new measurements, and the RMS of residuals over the expected one; a set-up that cannot be is another.
    fn verdict(&self, Campaign { observations, settings }: Campaign) -> (VerificationVerdict, f64) {
        let mut robot = self.twin.robot.clone();
        // nothing is identified: nominal values do not count
        let settings = Settings { conditions: settings.conditions, ..Settings::default() };
        let calibration = EarlierCalibration::new(&mut robot, &self.document, None).expect("a calibration");
        let found = verify(calibration, Observed { observations, settings }, BTreeMap::new());
        found.map_or((VerificationVerdict::Other, f64::NAN), |found| {
            (found.verdict, found.residuals.rms_mm / found.residuals.expected_rms_mm)
        })
    }
}

/// An unchanged robot is called changed in at most 5 % of all cases: its parameters' uncertainty also covers the scatter between regions,
/// which poses of the whole region do not show. A base that moved by ten times the misfit is always found.
#[test]
#[ignore = "a long law: make laws"]
fn verification_expects_the_misfit_of_the_calibration() {
    use Measured::{Poses, Positions, Targets};
    let count = number("ETALON_CAMPAIGNS", 16);
    let (mut alarms, mut all) = (0.0, 0.0);
    for (measured, poses, ratio, fresh) in [
        (Positions, 60, 5.0, 8),
        (Positions, 60, 10.0, 20),
        (Positions, 200, 5.0, 20),
        (Positions, 200, 20.0, 40),
        (Positions, 700, 5.0, 20),
        (Positions, 200, 10.0, 200),
        (Targets, 60, 5.0, 8),
        (Targets, 200, 10.0, 20),
        (Poses, 60, 10.0, 20),
        (Poses, 200, 10.0, 20),
    ] {
        let one = |seed: u64| {
            let twin = Twin::drawn(measured, LEFT_OUT[seed as usize % LEFT_OUT.len()], ratio, 400 + seed);
            let mut noise = Noise::new(66, seed);
            let calibration = Calibration::new(&twin, &twin.observed(poses, 1.0, &mut noise));
            let mut trial = || {
                let seen = twin.observed(fresh, 1.0, &mut noise);
                let (verdict, ratio) = calibration.verdict(seen.clone());
                (verdict != VerificationVerdict::Valid, ratio, seen)
            };
            let trials = [0; 5].map(|_| trial());
            let unchanged = trials.iter().filter(|trial| trial.0).count() as f64 / 5.0;
            let seen_over_expected = trials.iter().map(|trial| trial.1.powi(2)).sum::<f64>() / 5.0;
            let [(.., mut moved), ..] = trials;
            moved
                .observations
                .iter_mut()
                .flat_map(|o| o.targets.iter_mut().flatten())
                .for_each(|at| at[0] += 10.0 * ratio * NOISE_MM);
            let (moved, _) = calibration.verdict(moved);
            let is = |condition: bool| f64::from(u8::from(condition));
            let [found, named] = [moved != VerificationVerdict::Valid, moved == VerificationVerdict::BaseMoved].map(is);
            [unchanged, found, named, seen_over_expected]
        };
        let sums: Vec<[f64; 4]> = (0..count).into_par_iter().map(one).collect();
        let [unchanged, changed, named, ratio2] =
            [0, 1, 2, 3].map(|k| sums.iter().map(|s| s[k]).sum::<f64>() / count as f64);
        println!(
            "{measured:?}, {poses} poses, misfit {ratio} × noise, verified with {fresh}: {:.1} % false alarms, a moved base found in \
             {:.1} %, named in {:.1} %; RMS over expected {:.2}",
            100.0 * unchanged,
            100.0 * changed,
            100.0 * named,
            ratio2.sqrt()
        );
        assert!((0.7..1.2).contains(&ratio2.sqrt()), "{measured:?}, {poses} poses: {}", ratio2.sqrt());
        assert!(changed > 0.99 && named > 0.9, "{measured:?}, {poses} poses: {changed} {named}");
        assert!(unchanged < 0.065, "{measured:?}, {poses} poses: {unchanged}");
        (alarms, all) = (alarms + unchanged, all + 1.0);
    }
    println!("{:.1} % false alarms", 100.0 * alarms / all);
    assert!((0.01..0.05).contains(&(alarms / all)), "{}", alarms / all);
}

/// A campaign in three set-ups whose bases differ: intervals of the base hold the mean of many set-ups if the series are
/// stated.
#[test]
#[ignore = "a long law: make laws"]
fn the_scatter_between_series_is_in_the_uncertainties() {
    let count = number("ETALON_CAMPAIGNS", 40);
    let shift_mm = 0.3;
    let one = |seed: u64| {
        let twin = Twin::drawn(Measured::Positions, LEFT_OUT[seed as usize % LEFT_OUT.len()], 3.0, 500 + seed);
        let mut noise = Noise::new(67, seed);
        let mut campaign = twin.observed(120, 1.0, &mut noise);
        let series: Vec<Vec<PoseName>> =
            campaign.observations.chunks(40).map(|all| all.iter().map(|o| o.pose).collect()).collect();
        for part in campaign.observations.chunks_mut(40) {
            let by: Vector = [0; 3].map(|_| noise.gaussian(shift_mm));
            part.iter_mut()
                .flat_map(|o| o.targets.iter_mut().flatten())
                .for_each(|at| (0..3).for_each(|k| at[k] += by[k]));
        }
        let held = |found: &Identification| {
            let first = twin.robot.index("base_x").expect("a base");
            (first..first + 3)
                .filter(|&i| {
                    let (low, high) = estimate(found, i).expect("identified").interval();
                    (low..=high).contains(&twin.effective[i])
                })
                .count()
        };
        let without = held(&twin.identified(&campaign));
        campaign.settings.series = series;
        let found = twin.identified(&campaign);
        (without, held(&found), found.residuals.between_series.expect("three series").share)
    };
    let all: Vec<(usize, usize, f64)> = (0..count).into_par_iter().map(one).collect();
    let share =
        |of: &dyn Fn(&(usize, usize, f64)) -> usize| all.iter().map(of).sum::<usize>() as f64 / (3 * count) as f64;
    let (without, stated) = (share(&|a| a.0), share(&|a| a.1));
    let mean = all.iter().map(|a| a.2).sum::<f64>() / count as f64;
    println!(
        "three set-ups: {without:.3} hold without series, {stated:.3} with them; share of the variances {mean:.2}"
    );
    assert!(stated > 0.9, "{stated}");
}

#[test]
#[ignore = "a long law: make laws"]
fn nothing_is_widened_where_the_model_fits() {
    let count = number("ETALON_CAMPAIGNS", 30);
    for poses in [40, 100, 300] {
        let one = |seed: u64| {
            let twin = Twin::drawn(Measured::Positions, Effect::None, 0.0, 300 + seed);
            let found = twin.identified(&twin.observed(poses, 1.0, &mut Noise::new(65, seed)));
            (twin.held(&found), found.uncertainty.inflation_factor)
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
