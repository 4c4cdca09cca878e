//! A simulated calibration with the chosen poses (thesis, section 4.6): errors of parameters and
//! positions relative to the truth.

use super::{Criterion, Plan, candidate_pool, search::Choice};
use crate::Result;
use crate::{Observation, Settings, ToolPoint, identify_from};
use etalon_base::catalogue::Phrase;
use etalon_base::error;
use etalon_base::noise::Noise;
use etalon_base::phrase;
use etalon_base::pose::{Vector, minus, norm};
use etalon_base::pose_name::PoseName;
use etalon_math::statistics::middle_pair;
use etalon_robots::Robot;
use rayon::prelude::*;
use std::collections::BTreeMap;

/// The true robot, the configurations at which its errors are evaluated, and the number of
/// simulated calibrations.
#[derive(Clone, Debug)]
pub struct Setting<'a> {
    /// True parameters of the robot (mm, rad, 1).
    pub truth: Vec<f64>,
    /// Configurations at which the errors are evaluated.
    pub everywhere: &'a [Observation],
    /// Number of identifications in a mean; the thesis has five.
    pub runs: u64,
    /// Number of means, whose median errors are reported.
    pub draws: u64,
    /// Seed of the noise.
    pub seed: u64,
}

/// Point to which the errors of a study refer.
pub fn reference_point(robot: &dyn Robot) -> Phrase {
    match robot.platform() {
        Some(_) => phrase!("platform-in-base"),
        None => phrase!("targets-in-world"),
    }
}

/// The largest error of one pose, among its configurations and targets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlaceError {
    /// Name of the pose.
    pub pose: PoseName,
    /// Nominal position (mm) of its first target in the first configuration.
    pub at_mm: Vector,
    /// With nominal parameters (mm).
    pub before_mm: f64,
    /// With the identified ones (mm).
    pub after_mm: f64,
}

/// Result for a number of positions.
#[derive(Clone, Debug)]
pub struct SizeStudy {
    /// Positions measured.
    pub positions: usize,
    /// Configurations in them.
    pub configurations: usize,
    /// Mean of the identified parameters, for the first draw.
    pub identified: Vec<f64>,
    /// Root mean square error of position over all configurations and targets, or of a platform's
    /// centre in the base frame, minus the commanded position: nominal, and identified as the
    /// median of all draws (mm).
    pub rms_mm: (f64, f64),
    /// Largest error, likewise.
    pub max_mm: (f64, f64),
    /// Errors of the first draw by pose.
    pub places: Vec<PlaceError>,
}

/// One study for every number of positions, from the smallest that identifies the robot to all of
/// the plan, in the order of fastest increase of the determinant (tables 4.2 and 4.3).
pub fn study(
    robot: &dyn Robot,
    plan: &Plan,
    candidates: &[Observation],
    settings: &Settings,
    setting: &Setting,
) -> Result<Vec<SizeStudy>> {
    let pool = candidate_pool(&plan.sensitivity, &plan.members, Criterion::D);
    let mut order: Vec<usize> = Vec::new();
    let mut studies = Vec::new();
    while order.len() < plan.chosen.len() {
        let with = |i: usize| Choice::new(&pool, [&order[..], &[i]].concat()).value;
        let left = plan.chosen.iter().copied().filter(|i| !order.contains(i)).map(|i| (with(i), i));
        let Some((_, next)) = left.max_by(|a, b| a.0.total_cmp(&b.0).then(b.1.cmp(&a.1))) else { break };
        order.push(next);
        let chosen: Vec<Observation> =
            order.iter().flat_map(|&c| plan.members[c].iter().map(|&k| candidates[k].clone())).collect();
        let draw = |draw: u64| {
            let identified = calibrate(robot, &chosen, settings, setting, draw)?;
            Ok(errors(robot, order.len(), chosen.len(), identified, setting))
        };
        match (0..setting.draws).into_par_iter().map(draw).collect::<Result<Vec<SizeStudy>>>() {
            Ok(drawn) => studies.extend(middle(drawn)),
            Err(more) if order.len() == plan.chosen.len() => return Err(more),
            Err(_) => {}
        }
    }
    Ok(studies)
}

/// The first of the draws, with the medians of all draws.
fn middle(drawn: Vec<SizeStudy>) -> Option<SizeStudy> {
    let median = |of: fn(&SizeStudy) -> f64| {
        middle_pair(drawn.iter().map(of)).map_or(f64::NAN, |[low, high]| 0.5 * (low + high))
    };
    let (rms, max) = (median(|s| s.rms_mm.1), median(|s| s.max_mm.1));
    let first = drawn.into_iter().next()?;
    Some(SizeStudy { rms_mm: (first.rms_mm.0, rms), max_mm: (first.max_mm.0, max), ..first })
}

/// Mean of the parameters identified in all runs of one draw; an error if not all are identifiable.
fn calibrate(
    robot: &dyn Robot,
    chosen: &[Observation],
    settings: &Settings,
    setting: &Setting,
    draw: u64,
) -> Result<Vec<f64>> {
    let sigma_mm = settings.standard_uncertainty_mm.unwrap_or(0.0);
    let mut mean = vec![0.0; setting.truth.len()];
    for run in 0..setting.runs {
        let mut noise = Noise::new(setting.seed, draw * setting.runs + run);
        let mut measure = |o: &Observation| {
            let mut seen = |(target, at): (usize, &Option<Vector>)| {
                at.as_ref()?;
                let mut p = robot.position(&setting.truth, &o.joints, target);
                p[..robot.dimension()].iter_mut().for_each(|v| *v += noise.gaussian(sigma_mm));
                Some(p)
            };
            let targets = o.targets.iter().enumerate().map(&mut seen).collect();
            Observation { targets, ..o.clone() }
        };
        let measured: Vec<Observation> = chosen.iter().map(&mut measure).collect();
        let found = identify_from(robot, &measured, settings, &robot.nominal())?;
        if found.identifiability.groups.iter().any(|g| g.useless_uncertainty.is_some()) {
            return Err(error!("study-too-few-positions", positions = chosen.len()).into());
        }
        mean.iter_mut().zip(&found.values).for_each(|(m, v)| *m += v / setting.runs as f64);
    }
    Ok(mean)
}

fn errors(
    robot: &dyn Robot,
    positions: usize,
    configurations: usize,
    identified: Vec<f64>,
    setting: &Setting,
) -> SizeStudy {
    let nominal = robot.nominal();
    let centre = ToolPoint::centre(robot);
    let mut places: BTreeMap<PoseName, PlaceError> = BTreeMap::new();
    let (mut squares, mut largest, mut count) = ((0.0, 0.0), (0.0f64, 0.0f64), 0.0);
    for o in setting.everywhere {
        let seen = (0..o.targets.len()).filter(|&t| o.targets[t].is_some());
        for target in seen.take(if centre.is_some() { 1 } else { usize::MAX }) {
            let position = |values: &[f64]| match &centre {
                Some(centre) => centre.in_base(robot, values, &o.joints).unwrap_or([f64::NAN; 3]),
                None => robot.position(values, &o.joints, target),
            };
            let at_mm = position(&setting.truth);
            let off = |values: &[f64]| norm(minus(position(values), at_mm));
            let (before_mm, after_mm) = (off(&nominal), off(&identified));
            // the true robot may be a little too short
            if !before_mm.is_finite() || !after_mm.is_finite() {
                continue;
            }
            squares = (squares.0 + before_mm.powi(2), squares.1 + after_mm.powi(2));
            largest = (largest.0.max(before_mm), largest.1.max(after_mm));
            count += 1.0;
            let planned_mm = robot.position(&nominal, &o.joints, target);
            let first = PlaceError { pose: o.pose, at_mm: planned_mm, before_mm, after_mm };
            let place = places.entry(o.pose).or_insert(first);
            (place.before_mm, place.after_mm) = (place.before_mm.max(before_mm), place.after_mm.max(after_mm));
        }
    }
    let rms = |sum: f64| (sum / f64::max(count, 1.0)).sqrt();
    SizeStudy {
        positions,
        configurations,
        identified,
        rms_mm: (rms(squares.0), rms(squares.1)),
        max_mm: largest,
        places: places.into_values().collect(),
    }
}
