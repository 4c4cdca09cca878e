//! Distributions of the results of a campaign: by simulated errors of all given uncertainties of
//! its readings, propagated through frames and identification (JCGM 101:2008, Monte Carlo), and by
//! resampling of measured poses and cycles (bootstrap).

use crate::stages::calibrate::identification::Identified;
use crate::stages::evaluate::accuracy::summarise;
use crate::stages::observe::frames;
use etalon_base::error;
use etalon_base::message::Result;
use etalon_base::noise::Noise;
use etalon_base::pose::{Pose, Vector, minus, norm};
use etalon_base::pose_name::PoseName;
use etalon_campaign::Campaign;
use etalon_documents::{
    DistributionEntry, ErrorQuantity, Figure, FigureBudget, FramePose, FramesDocument, Provenance, UncertaintyDocument,
};
use etalon_formats::Point;
use etalon_identify::{Condition, ErrorKind, Identification, Observation, Repeated, Settings};
use etalon_math::statistics::{mean, standard_deviation};
use etalon_robots::{Quantity, Robot, State};
use nalgebra::{Matrix3, Vector3};
use rayon::prelude::*;
use statrs::distribution::{ContinuousCDF, Normal};
use std::collections::BTreeMap;

/// Number and seed of the draws.
#[derive(Clone, Copy, Debug)]
pub struct Draws {
    /// Maximum number of draws; fewer if every standard uncertainty has two significant digits
    /// before.
    pub most: usize,
    /// Number of resamples of the bootstrap.
    pub resamples: usize,
    /// Seed of both: each trial has its own stream.
    pub seed: u64,
}

/// Number of draws in one sequence of the adaptive procedure (JCGM 101, 7.9.4 asks for 10⁴; fewer
/// need more sequences).
const SEQUENCE: usize = 2_000;
/// Maximum share of failed resamples.
const MOST_FAILED: f64 = 0.05;
/// Significance level of a difference between draws.
const APART_BY_CHANCE: f64 = 0.01;
/// Standard deviations of a normal distribution to either side of its mean that hold 95 %.
const NORMAL_95: f64 = 1.959_963_985;

/// Standard deviation of an end of the 95 % interval by one draw of a normal distribution, in its
/// standard deviations: √(p(1 − p)) / φ.
const OF_END: f64 = 2.671;

/// Length of a vector (mm). `hypot`, which avoids overflow, takes a tenth of the time of a draw.
fn length([x, y]: [f64; 2]) -> f64 {
    (x * x + y * y).sqrt()
}

/// Input of the draws of a campaign.
pub struct Trials<'a> {
    campaign: &'a Campaign,
    robot: &'a dyn Robot,
    settings: &'a Settings,
    found: &'a Identification,
    frames: MeasuredFrames,
    /// Mean height (mm) of the targets in the world, for a planar robot.
    height_mm: Option<f64>,
    readings: Readings,
    systematic: etalon_identify::Systematic,
    /// Budgets of the figures of the validation errors.
    budget: &'a [FigureBudget],
    /// Root of the covariance of the identified parameters from the model error, row by row.
    model_root: Option<Vec<f64>>,
    seed: u64,
}

/// Frames as measured.
struct MeasuredFrames {
    /// Points that define the frames.
    points: Vec<Point>,
    /// Pose of the world in the frame of the export, by pose and cycle.
    export_T_world: BTreeMap<Option<(PoseName, i64)>, Pose>,
}

/// Readings of the targets.
struct Readings {
    calibration: Vec<Reading>,
    validation: Vec<Reading>,
    /// Number of readings; a reading that is common to several targets counts once.
    count: usize,
    /// Readings of the validation that are not positions of targets.
    conditions: Vec<Condition>,
    /// Index of the largest error of each quantity, among its errors.
    largest: BTreeMap<ErrorKind, usize>,
}

/// An observation, and the scatter of its targets.
struct Reading {
    observation: Observation,
    /// Root of the covariance of each target, by which independent normal numbers are multiplied;
    /// `None` if not measured.
    scatter: Vec<Option<Matrix3<f64>>>,
    /// The number of the reading of each target, if one reading is common to several targets.
    numbers: Vec<usize>,
}

impl<'a> Trials<'a> {
    /// Creates trials of a campaign with these `points` and `frames`, from which the parameters
    /// were `identified`.
    pub fn new(
        campaign: &'a Campaign,
        robot: &'a dyn Robot,
        points: &[Point],
        frames: &FramesDocument,
        identified: &'a Identified,
    ) -> Self {
        let Identified { documents, solution } = identified;
        let settings = &solution.settings;
        let key = |f: &FramePose| (f.pose.zip(f.cycle), f.export_T_world);
        let export_T_world: BTreeMap<_, _> = frames.world.poses.iter().map(key).collect();
        let height_mm = (robot.dimension() == 2).then(|| frames::target_height_mm(&frames.world, points));
        let mut numbers = BTreeMap::new();
        let mut readings = |of: &[Observation]| -> Vec<Reading> {
            of.iter().map(|o| reading(o, settings, robot.dimension(), &mut numbers)).collect()
        };
        let [calibration, validation] = [&solution.sets.calibration, &solution.sets.validation].map(|of| readings(of));
        let mut trials = Self {
            frames: MeasuredFrames { points: frames::defining(campaign, points), export_T_world },
            readings: Readings {
                calibration,
                validation,
                count: numbers.len(),
                conditions: solution.sets.validation_conditions.clone(),
                largest: BTreeMap::new(),
            },
            systematic: campaign.systematic(robot, Vec::new()),
            found: &solution.found,
            campaign,
            robot,
            settings,
            height_mm,
            budget: &documents.accuracy.budget,
            model_root: solution.found.uncertainty.budget.model_root(),
            seed: 0,
        };
        let largest = |(kind, sizes): (ErrorKind, Vec<f64>)| {
            sizes.iter().enumerate().max_by(|a, b| a.1.total_cmp(b.1)).map(|(i, _)| (kind, i))
        };
        trials.readings.largest = trials.measured_errors().into_iter().filter_map(largest).collect();
        trials
    }

    /// Sizes (mm) of the errors of each quantity as measured.
    fn measured_errors(&self) -> BTreeMap<ErrorKind, Vec<f64>> {
        self.errors(&self.found.values, self.readings.validation.iter().map(|r| &r.observation), None)
    }

    /// The distributions of the results, without input files; `report` is called with the number of
    /// draws and their maximum.
    pub fn distributions(self, draws: Draws, report: &mut dyn FnMut(usize, usize)) -> Result<UncertaintyDocument> {
        let trials = Self { seed: draws.seed, ..self };
        let Self { robot, found, settings, .. } = trials;
        let positions_alone = settings.conditions.is_empty();
        if !positions_alone && trials.systematic.is_stated() {
            return Err(error!("common-errors-of-conditions").into());
        }
        let (monte_carlo, digits) = trials.monte_carlo(draws.most, report);
        let bootstrap = trials.bootstrap(draws.resamples);
        let n = found.free.len();
        let linear = |k: usize| -> Option<f64> {
            let parts = found.uncertainty.budget.parameter_contributions(k);
            (!parts.is_empty()).then(|| parts.iter().map(|(_, v)| v).sum::<f64>().sqrt())
        };
        // so far do ends of intervals go apart by the number of draws alone, of all parameters in
        // one of a hundred campaigns
        let normal = Normal::standard();
        let by_chance = normal.inverse_cdf(1.0 - APART_BY_CHANCE / (4.0 * n as f64));
        let entry = |k: usize| {
            let p = &robot.parameters()[found.free[k]];
            let out = |v: f64| p.quantity.outward(v);
            let drawn = Distribution::new(monte_carlo.iter().map(|trial| trial[k]).collect());
            let value = found.values[found.free[k]];
            let (u, tolerance) = (linear(k), numerical_tolerance(drawn.sd));
            let of_end = OF_END * drawn.sd / (monte_carlo.len() as f64).sqrt();
            let agrees = |u: f64| {
                let ends = [value - NORMAL_95 * u, value + NORMAL_95 * u];
                (0..2).all(|i| (ends[i] - drawn.interval[i]).abs() <= tolerance + by_chance * of_end)
            };
            DistributionEntry {
                name: p.name.clone(),
                quantity: None,
                unit: p.quantity.unit().to_owned(),
                value: out(value),
                linear: u.map(out),
                standard_uncertainty: found.standard_uncertainty(found.free[k]).map(out),
                mean: Some(out(drawn.mean)),
                standard_deviation: out(drawn.sd),
                interval_95: Some(drawn.interval.map(out)),
                agrees: u.map(agrees),
                bootstrap: bootstrap.as_ref().map(|all| out(Distribution::new(all.iter().map(|t| t[k]).collect()).sd)),
            }
        };
        let measured: Vec<(ErrorKind, [f64; 3])> = trials.figures(trials.measured_errors()).collect();
        let figure = |(i, figure): (usize, Figure)| {
            let (kind, values) = measured[i / 3];
            let quantity = ErrorQuantity::from(kind);
            let drawn = Distribution::new(monte_carlo.iter().map(|trial| trial[n + i]).collect());
            let of_budget = trials.budget.iter().find(|b| b.figure == figure && b.quantity == quantity);
            let reported = of_budget.map(|b| b.standard_uncertainty_mm);
            // a standard deviation of this many draws has about this one itself
            let by_chance = by_chance * drawn.sd / (2.0 * monte_carlo.len() as f64).sqrt();
            DistributionEntry {
                name: format!("{figure:?}").to_lowercase(),
                quantity: Some(quantity),
                unit: Quantity::Length.unit().to_owned(),
                value: values[i % 3],
                linear: None,
                standard_uncertainty: reported,
                mean: None,
                standard_deviation: drawn.sd,
                interval_95: None,
                agrees: reported.map(|u| drawn.sd <= u + numerical_tolerance(drawn.sd) + by_chance),
                bootstrap: None,
            }
        };
        let figures = measured.iter().flat_map(|_| [Figure::Mean, Figure::Rms, Figure::Max]).enumerate().map(figure);
        Ok(UncertaintyDocument {
            schema: "etalon/uncertainty/1".to_owned(),
            robot: robot.model().to_owned(),
            campaign: None,
            draws: monte_carlo.len(),
            two_digits_reached: digits,
            resamples: bootstrap.as_ref().map_or(0, Vec::len),
            uncertainties_from: found.uncertainty.from.into(),
            parameters: (0..n).map(entry).collect(),
            errors: figures.collect(),
            messages: etalon_documents::warning_messages(&found.warnings),
            provenance: Provenance {
                version: env!("CARGO_PKG_VERSION").to_owned(),
                inputs: BTreeMap::new(),
                seed: Some(draws.seed),
            },
        })
    }

    /// Parameters and figures of each draw; `true` if all standard uncertainties have two
    /// significant digits.
    fn monte_carlo(&self, most: usize, report: &mut dyn FnMut(usize, usize)) -> (Vec<Vec<f64>>, bool) {
        let measured = |of: &[Reading]| of.iter().map(|r| r.observation.clone()).collect::<Vec<_>>();
        let Readings { calibration, validation, .. } = &self.readings;
        let room = || [measured(calibration), measured(validation)];
        let again = Repeated::new(self.robot, &measured(calibration), self.settings, self.found);
        let mut all: Vec<Vec<f64>> = Vec::new();
        let mut sequences: Vec<Vec<[f64; 4]>> = Vec::new();
        while all.len() < most {
            let count = SEQUENCE.min(most - all.len());
            let first = all.len() as u64;
            let drawn: Vec<Vec<f64>> = (0..count as u64)
                .into_par_iter()
                .map_init(room, |room, i| self.trial(&again, first + i, room))
                .flatten()
                .collect();
            if drawn.is_empty() {
                break;
            }
            let columns = drawn[0].len();
            let summary = |k: usize| {
                let d = Distribution::new(drawn.iter().map(|t| t[k]).collect());
                [d.mean, d.sd, d.interval[0], d.interval[1]]
            };
            sequences.push((0..columns).map(summary).collect());
            all.extend(drawn);
            report(all.len(), most);
            if sequences.len() > 1 && stable(&sequences) {
                return (all, true);
            }
        }
        (all, false)
    }

    /// One simulated repetition of the campaign, in the `room` for its observations: its
    /// parameters, then figures of the validation; `None` if the solver fails.
    fn trial(&self, again: &Repeated, number: u64, room: &mut [Vec<Observation>; 2]) -> Option<Vec<f64>> {
        let mut noise = Noise::new(self.seed, number);
        let moved = self.moved_frames(&mut noise)?;
        let scale = 1.0 + noise.gaussian(self.systematic.scale) + noise.gaussian(self.systematic.expansion);
        let homing: Vec<f64> = self.systematic.homing.iter().map(|u| noise.gaussian(*u)).collect();
        let mut common: Vec<Option<Vector>> = vec![None; self.readings.count];
        let common_mm = self.settings.common_uncertainty_mm;
        let [calibration, validation] = room;
        let measured = [&self.readings.calibration, &self.readings.validation];
        for (readings, room) in measured.into_iter().zip([&mut *calibration, &mut *validation]) {
            for (r, o) in readings.iter().zip(room) {
                let to_frame = moved.get(&Some((o.pose, o.cycle))).or_else(|| moved.get(&None));
                for (k, target) in o.targets.iter_mut().enumerate() {
                    let (Some(at), Some(scatter)) = (r.observation.targets[k], r.scatter[k]) else { continue };
                    let [x, y] = noise.gaussian_pair();
                    let off =
                        scatter * Vector3::new(x, y, if self.height_mm.is_some() { 0.0 } else { noise.gaussian(1.0) });
                    let mut shared =
                        |u_mm: f64| *common[r.numbers[k]].get_or_insert_with(|| [0; 3].map(|_| noise.gaussian(u_mm)));
                    let shared = common_mm.map_or([0.0; 3], &mut shared);
                    let mut p: Vector = std::array::from_fn(|i| (at[i] + off[i] + shared[i]) * scale);
                    if let Some(height_mm) = self.height_mm {
                        p[2] = height_mm;
                    }
                    if let Some(world_T_before) = to_frame {
                        p = world_T_before.apply(p);
                    }
                    *target = Some(if self.height_mm.is_some() { [p[0], p[1], 0.0] } else { p });
                }
                let joints = r.observation.joints.iter().zip(&homing);
                o.joints.iter_mut().zip(joints).for_each(|(q, (measured, shift))| *q = measured + shift);
            }
        }
        let drawn = again.stated().iter().map(|u| noise.gaussian(*u)).collect();
        let values = again.identify(calibration, drawn)?;
        let mut all: Vec<f64> = self.found.free.iter().map(|&i| values[i]).collect();
        if let Some(root) = &self.model_root {
            // another sample of the region has other effective parameters
            let z: Vec<f64> = all.iter().map(|_| noise.gaussian(1.0)).collect();
            let by_row = all.iter_mut().zip(root.chunks_exact(z.len()));
            by_row.for_each(|(value, row)| *value += row.iter().zip(&z).map(|(l, z)| l * z).sum::<f64>());
        }
        let errors = self.errors(&values, validation.iter(), Some(&mut noise));
        all.extend(self.figures(errors).flat_map(|(_, figures)| figures));
        Some(all)
    }

    /// For each frame, the transform from the measured world to the world of the repetition; empty
    /// if no frame is measured.
    fn moved_frames(&self, noise: &mut Noise) -> Option<BTreeMap<Option<(PoseName, i64)>, Pose>> {
        if self.frames.points.is_empty() {
            return Some(BTreeMap::new());
        }
        let mut points = self.frames.points.clone();
        for p in &mut points {
            let u = p.standard_uncertainty_mm;
            let u = u.unwrap_or_else(|| self.campaign.file.instrument.standard_uncertainties_mm(p.xyz_mm));
            p.xyz_mm = std::array::from_fn(|i| p.xyz_mm[i] + noise.gaussian(u[i]));
        }
        let poses = frames::place(self.campaign, &points).ok()?;
        let of = |f: &FramePose| {
            let key = f.pose.zip(f.cycle);
            Some((key, f.export_T_world.inverse().then(self.frames.export_T_world.get(&key)?)))
        };
        Some(poses.iter().filter_map(of).collect())
    }

    /// Sizes (mm) of the errors of each quantity: of the positions in these observations, and of
    /// the other readings of the validation, measured again with `noise`.
    fn errors<'o>(
        &self,
        values: &[f64],
        observations: impl Iterator<Item = &'o Observation>,
        mut noise: Option<&mut Noise>,
    ) -> BTreeMap<ErrorKind, Vec<f64>> {
        let mut all = BTreeMap::from([(ErrorKind::Position, self.sizes(values, observations))]);
        for c in &self.readings.conditions {
            let Some(kind) = c.kind.error_kind() else { continue };
            // noise along the error, and across it in each further direction
            let mut size = norm(c.error(self.robot, values));
            if let Some(noise) = &mut noise {
                size += noise.gaussian(c.standard_uncertainty);
                for _ in 1..c.kind.rows() {
                    size = size.hypot(noise.gaussian(c.standard_uncertainty));
                }
            }
            all.entry(kind).or_default().push(size.abs());
        }
        all.retain(|_, sizes| !sizes.is_empty());
        all
    }

    /// Returns the size (mm) of each position error of these observations.
    fn sizes<'o>(&self, values: &[f64], observations: impl Iterator<Item = &'o Observation>) -> Vec<f64> {
        let (robot, loads) = (self.robot.parametrised(values), self.robot.loads());
        let d = self.robot.dimension();
        let mut predicted = vec![0.0; d * self.robot.targets().len()];
        let mut sizes = Vec::new();
        for o in observations {
            match (self.robot.platform(), &o.targets[..]) {
                (Some(platform), [Some(k), Some(l)]) => {
                    let e = platform.pose_error(values, &o.joints, [[k[0], k[1]], [l[0], l[1]]]);
                    sizes.push(length([e[0], e[1]]));
                }
                (Some(_), _) => {}
                (None, _) => {
                    let loads = loads.as_ref().map_or_else(Vec::new, |at| at(&o.joints));
                    robot.positions(State { joints: &o.joints, loads: &loads }, &mut predicted);
                    let measured = predicted.chunks_exact(d).zip(&o.targets).filter_map(|(p, at)| Some((p, (*at)?)));
                    sizes.extend(measured.map(|(p, at)| match *p {
                        [x, y] => length([at[0] - x, at[1] - y]),
                        [x, y, z] => norm(minus(at, [x, y, z])),
                        _ => f64::NAN,
                    }));
                }
            }
        }
        sizes
    }

    /// Mean and root mean square of the errors of each quantity (mm), and the error of the reading
    /// that is largest in the data.
    ///
    /// The largest error of each draw would be that of other readings, and vary less than any of
    /// them: its limit is about the true error of one reading.
    fn figures(&self, errors: BTreeMap<ErrorKind, Vec<f64>>) -> impl Iterator<Item = (ErrorKind, [f64; 3])> {
        errors.into_iter().map(|(kind, sizes)| {
            let index = self.readings.largest.get(&kind).copied().unwrap_or_default();
            let largest = sizes.get(index).copied().unwrap_or(f64::NAN);
            let found = summarise(sizes);
            (kind, [found.mean, found.rms, largest])
        })
    }

    /// Parameters identified from poses, and cycles of each pose, that are drawn from the measured
    /// ones with replacement (Efron & Tibshirani 1993); `None` if readings are common to several or
    /// of other kinds, or too many resamples do not determine the parameters.
    fn bootstrap(&self, resamples: usize) -> Option<Vec<Vec<f64>>> {
        let other_kinds = !self.settings.conditions.is_empty();
        if self.settings.common_uncertainty_mm.is_some() || other_kinds || resamples == 0 {
            return None;
        }
        let mut poses: BTreeMap<PoseName, BTreeMap<i64, Vec<&Observation>>> = BTreeMap::new();
        for r in &self.readings.calibration {
            let o = &r.observation;
            poses.entry(o.pose).or_default().entry(o.cycle).or_default().push(o);
        }
        let poses: Vec<Vec<Vec<&Observation>>> =
            poses.into_values().map(|cycles| cycles.into_values().collect()).collect();
        let one = |trial: u64| {
            let mut noise = Noise::new(self.seed ^ u64::MAX, trial);
            let mut any = |n: usize| ((0.5 + noise.uniform(0.5)) * n as f64) as usize;
            let mut drawn: Vec<Observation> = Vec::new();
            for _ in 0..poses.len() {
                let cycles = &poses[any(poses.len()).min(poses.len() - 1)];
                for _ in 0..cycles.len() {
                    drawn.extend(cycles[any(cycles.len()).min(cycles.len() - 1)].iter().copied().cloned());
                }
            }
            let values = etalon_identify::identify_again(self.robot, &drawn, self.settings, self.found)?;
            Some(self.found.free.iter().map(|&i| values[i]).collect::<Vec<f64>>())
        };
        let all: Vec<Vec<f64>> = (0..resamples as u64).into_par_iter().filter_map(one).collect();
        (all.len() as f64 >= (1.0 - MOST_FAILED) * resamples as f64).then_some(all)
    }
}

/// A reading, and its scatter by its own covariance or the given uncertainty.
fn reading(
    o: &Observation,
    settings: &Settings,
    dimension: usize,
    numbers: &mut BTreeMap<(usize, [u64; 3]), usize>,
) -> Reading {
    let u = settings.standard_uncertainty_mm.unwrap_or(0.0);
    let root = |k: usize| {
        o.targets[k]?;
        let own = o.covariances_mm2.get(k).copied().flatten();
        let mut root = match own.map(|c| Matrix3::from_fn(|i, j| c[i][j])) {
            Some(covariance) => covariance.cholesky()?.l(),
            None => Matrix3::identity() * u,
        };
        if dimension == 2 {
            root[(2, 2)] = 0.0;
        }
        Some(root)
    };
    let mut number = |k: usize| {
        let next = numbers.len();
        let at = o.targets[k].unwrap_or_default().map(f64::to_bits);
        *numbers.entry((k, at)).or_insert(next)
    };
    Reading {
        observation: o.clone(),
        scatter: (0..o.targets.len()).map(root).collect(),
        numbers: (0..o.targets.len()).map(&mut number).collect(),
    }
}

/// Mean, standard deviation, and the ends of the probabilistically symmetric interval of 95 % (JCGM
/// 101, 7.6, 7.7).
pub(crate) struct Distribution {
    /// Mean of the draws.
    pub mean: f64,
    /// Standard deviation of the draws.
    pub sd: f64,
    /// Ends of the interval.
    pub interval: [f64; 2],
}

impl Distribution {
    /// Summarises the draws.
    pub fn new(mut drawn: Vec<f64>) -> Self {
        drawn.sort_by(f64::total_cmp);
        let (mean, sd) = (mean(drawn.iter().copied()), standard_deviation(&drawn));
        let at = |p: f64| drawn.get((p * drawn.len() as f64) as usize).or(drawn.last()).copied().unwrap_or(f64::NAN);
        Self { mean, sd, interval: [at(0.025), at(0.975)] }
    }
}

/// Half a unit in the second digit of a standard uncertainty (JCGM 101, 7.9.2).
fn numerical_tolerance(u: f64) -> f64 {
    if u > 0.0 { 0.5 * 10f64.powi(u.log10().floor() as i32 - 1) } else { 0.0 }
}

/// `true` if twice the standard deviation of the mean over sequences is below the numerical
/// tolerance, for all results (JCGM 101, 7.9.4).
fn stable(sequences: &[Vec<[f64; 4]>]) -> bool {
    let h = sequences.len() as f64;
    (0..sequences[0].len()).all(|k| {
        let mean = |i: usize| sequences.iter().map(|s| s[k][i]).sum::<f64>() / h;
        let tolerance = numerical_tolerance(mean(1));
        (0..4).all(|i| {
            let squares: f64 = sequences.iter().map(|s| (s[k][i] - mean(i)).powi(2)).sum();
            2.0 * (squares / (h * (h - 1.0))).sqrt() <= tolerance
        })
    })
}
