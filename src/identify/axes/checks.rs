//! Mistakes that sweeps reveal: joints that move together, units, moved targets, swapped joints.

use super::{AxesModel, JointAxis, Sweep, SweepFit, SweepReading, motion, smooth};
use crate::MeasuredRatio;
use etalon_base::pose::{Vector, minus, norm};
use etalon_math::statistics::rms;

/// Maximum motion of another joint during a sweep, as a share of the sweep.
const LEAST_MOTION: f64 = 0.01;
/// Motion (rad or mm) below which a joint is at rest.
const AT_REST: f64 = 1e-4;
/// Difference of the ratio of motion and joint value from one beside its uncertainty: gains of real
/// transmissions are within a per cent, and the nearest confusion of units is a tenth away (gon).
const RATIO: f64 = 0.02;
/// Known factors between units of joint values, with their names.
const UNITS: [(f64, &str); 5] = [
    (std::f64::consts::PI / 180.0, "deg-as-rad"),
    (180.0 / std::f64::consts::PI, "rad-as-deg"),
    (25.4, "inch-as-mm"),
    (1000.0, "m-as-mm"),
    (0.001, "mm-as-m"),
];
/// Share of excluded readings above which they no longer count as isolated outliers.
const MANY: f64 = 0.1;
/// Ratio of residuals to the usual noise from point to point that noise alone does not reach.
const JUMPS: f64 = 3.0;
/// Logarithm of the ratio of likelihoods from which a step explains the residuals better than a
/// smooth deviation, over all places of the step; run-out reaches 11.
const STEP: f64 = 20.0;
/// A change explains the readings if it reduces residuals to this share.
const EXPLAINS: f64 = 1.0 / 3.0;
/// Maximum number of places of a sweep that are tried for a move of a target.
const SPLITS: usize = 60;
/// Fewest readings before and behind a move.
const LEAST_PART: usize = 4;
/// Number of readings of a sweep for comparisons between sweeps.
const COMPARED: usize = 9;
/// Misfit (standard uncertainties) beyond which sweeps or check poses disagree.
const DISAGREE: f64 = 5.0;

/// Mistake in a sweep.
#[derive(Clone, Debug, PartialEq)]
pub enum Slip {
    /// Another joint moves instead of the joint of the sweep.
    OtherJoint {
        /// Joint that moves.
        moved: usize,
    },
    /// Another joint moves too.
    TwoJoints {
        /// The other joint.
        also: usize,
        /// Its motion (rad or mm).
        by: f64,
    },
    /// The ratio of motion and joint value differs from one.
    Ratio {
        /// Motion per unit of the joint value.
        ratio: MeasuredRatio,
        /// Confusion of units that has this ratio.
        unit: Option<&'static str>,
    },
    /// A target, or the measuring system, moved during the sweep.
    TargetMoved {
        /// Index of the target.
        target: usize,
        /// First row after the move.
        row: usize,
        /// Standard deviation of the readings from the paths (mm), without and with the move.
        deviations_mm: [f64; 2],
    },
    /// Many readings are far from the path of the others.
    Many {
        /// Number of excluded readings.
        aside: usize,
        /// Number of readings.
        readings: usize,
    },
}

/// Comparison of a position with its prediction, at a check pose or by another sweep.
#[derive(Clone, Debug, PartialEq)]
pub struct CheckedPose {
    /// Row of the reading.
    pub row: usize,
    /// Index of the target.
    pub target: usize,
    /// Distance of the reading from the predicted position (mm).
    pub distance_mm: f64,
    /// Standard uncertainty of a component of the difference (mm).
    pub standard_uncertainty_mm: f64,
}

/// Motion of a joint in a sweep: largest minus smallest value.
fn spread(sweep: &Sweep, joint: usize) -> f64 {
    let values = || sweep.readings.iter().filter_map(|r| r.joints.get(joint).copied());
    let [low, high] = values().fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], v| [a.min(v), b.max(v)]);
    (high - low).max(0.0)
}

/// Mistake of the joint values of a sweep, before any fit.
pub fn joint_slip(sweep: &Sweep) -> Option<Slip> {
    let joints = sweep.readings.first()?.joints.len();
    let own = spread(sweep, sweep.joint);
    let others = (0..joints).filter(|j| *j != sweep.joint).map(|j| (j, spread(sweep, j)));
    let (moved, by) = others.max_by(|a, b| a.1.total_cmp(&b.1))?;
    match (own > AT_REST, by > AT_REST.max(LEAST_MOTION * own)) {
        (false, true) => Some(Slip::OtherJoint { moved }),
        (true, true) => Some(Slip::TwoJoints { also: moved, by }),
        _ => None,
    }
}

/// Mistake that the axis of a sweep shows.
pub fn axis_slip(sweep: &Sweep, axis: &JointAxis) -> Option<Slip> {
    let fit = &axis.fit;
    let aside = fit.used.iter().filter(|used| !**used).count();
    let many = aside as f64 > MANY * fit.used.len() as f64;
    if (many || axis.smooth.is_some() || jumps(sweep, fit))
        && let Some(moved) = target_moved(sweep, fit)
    {
        return Some(moved);
    }
    if let Some(travel) = axis.travel {
        let ratio = travel.ratio;
        if ratio.differs(1.0, RATIO) {
            let mut near = UNITS.iter().filter(|(factor, _)| !ratio.differs(*factor, RATIO));
            let unit = near.next().map(|u| u.1).filter(|_| near.next().is_none());
            return Some(Slip::Ratio { ratio, unit });
        }
    }
    many.then_some(Slip::Many { aside, readings: fit.used.len() })
}

/// `true` if residuals are much larger than most differences of neighbours, as where a target moves
/// once.
fn jumps(sweep: &Sweep, fit: &SweepFit) -> bool {
    let used = fit.residuals_mm.iter().zip(&fit.used).filter(|(_, used)| **used);
    let rms_mm = rms(used.flat_map(|(residual, _)| *residual));
    motion::usual_noise_mm(sweep, fit).is_some_and(|noise_mm| rms_mm > JUMPS * noise_mm && rms_mm > 1e-6)
}

/// `true` if a step of a path from this place on is likelier than a smooth deviation.
fn is_step(sweep: &Sweep, fit: &SweepFit, rows: &[usize], at: usize) -> bool {
    let likelihood = |k: usize, step: Option<usize>| smooth::series(sweep, fit, rows, k, step).likelihood();
    let gain = |k: usize| Some(likelihood(k, Some(at))? - likelihood(k, None)?);
    [0, 1].iter().filter_map(|k| gain(*k)).sum::<f64>() > STEP
}

/// Root mean square of residuals of all readings (mm).
fn deviation_mm(fit: &SweepFit) -> f64 {
    let squares: f64 = fit.residuals_mm.iter().map(|[a, b]| a * a + b * b).sum();
    (squares / fit.residuals_mm.len().max(1) as f64).sqrt()
}

/// Move of the target that explains the readings, if there is one.
fn target_moved(sweep: &Sweep, fit: &SweepFit) -> Option<Slip> {
    let new = sweep.readings.iter().map(|r| r.target).max()? + 1;
    let before = deviation_mm(fit);
    let mut best: Option<(f64, usize, usize)> = None;
    for path in &fit.paths {
        let rows = smooth::rows(sweep, fit, path.target, true);
        let step = rows.len().div_ceil(SPLITS).max(1);
        let inside = rows.len().saturating_sub(LEAST_PART);
        for at in (LEAST_PART..=inside).step_by(step) {
            let mut readings = sweep.readings.clone();
            rows[at..].iter().for_each(|i| readings[*i].target = new);
            let Some(split) = fit.again(&readings) else { continue };
            let after = deviation_mm(&split);
            if best.is_none_or(|(least, ..)| after < least) {
                best = Some((after, path.target, at));
            }
        }
    }
    let (after, target, at) = best?;
    let rows = smooth::rows(sweep, fit, target, true);
    let row = sweep.readings[rows[at]].row;
    let moved = after < EXPLAINS * before && is_step(sweep, fit, &rows, at);
    moved.then_some(Slip::TargetMoved { target, row, deviations_mm: [before, after] })
}

/// Change of the order or the signs of joints that brings readings into agreement.
#[derive(Clone, Debug, PartialEq)]
pub enum Change {
    /// Two joints are swapped.
    Exchanged([usize; 2]),
    /// A joint was swept in negative direction.
    Reversed(usize),
}

/// Agreement of a model with readings at joint values.
#[derive(Clone, Debug, PartialEq)]
pub struct Agreement {
    /// Differences by reading.
    pub poses: Vec<CheckedPose>,
    /// Largest difference in standard uncertainties; 0 without readings.
    pub worst: f64,
    /// The one change that explains the readings, if they disagree.
    pub explained: Option<(Change, f64)>,
}

impl AxesModel {
    /// Compares the model with readings: check poses, or some readings of each sweep.
    pub fn agreement(&self, readings: &[SweepReading], u_mm: f64) -> Agreement {
        let one = |r: &SweepReading| {
            let predicted = self.predict(&r.joints, r.target);
            let c = predicted.covariance_mm2;
            let variance = (c[0][0] + c[1][1] + c[2][2]) / 3.0 + u_mm * u_mm;
            CheckedPose {
                row: r.row,
                target: r.target,
                distance_mm: norm(minus(r.position_mm, predicted.position_mm)),
                standard_uncertainty_mm: variance.sqrt(),
            }
        };
        let poses: Vec<CheckedPose> = readings.iter().map(one).collect();
        let ratio = |p: &CheckedPose| p.distance_mm / p.standard_uncertainty_mm.max(f64::MIN_POSITIVE);
        let worst = poses.iter().map(ratio).fold(0.0, f64::max);
        let explained = (worst > DISAGREE).then(|| self.explained(readings, &poses)).flatten();
        Agreement { poses, worst, explained }
    }

    /// The one change of order or sign that explains readings, with the remaining distance (mm).
    fn explained(&self, readings: &[SweepReading], poses: &[CheckedPose]) -> Option<(Change, f64)> {
        let n = self.measured.len();
        let exchanged = (0..n).flat_map(|a| (a + 1..n).map(move |b| Change::Exchanged([a, b])));
        // joint values state the sign
        let by_motion = self.measured.iter().all(|m| m.rest.is_empty());
        let changes = exchanged.chain((0..n).filter(|_| by_motion).map(Change::Reversed));
        let mut all: Vec<(f64, Change)> =
            changes.filter_map(|change| Some((self.misfit_with(&change, readings)?, change))).collect();
        all.sort_by(|a, b| a.0.total_cmp(&b.0));
        let stated = rms(poses.iter().map(|p| p.distance_mm));
        let u = rms(poses.iter().map(|p| p.standard_uncertainty_mm));
        let (left, change) = all.first()?.clone();
        let alone = all.get(1).is_none_or(|(second, _)| *second > 2.0 * left);
        (alone && left < 2.0 * u * 3f64.sqrt() && left < EXPLAINS * stated).then_some((change, left))
    }

    /// Root mean square distance (mm) of readings from the model after a change.
    fn misfit_with(&self, change: &Change, readings: &[SweepReading]) -> Option<f64> {
        let mut measured = self.measured.clone();
        let order = |joints: &[f64]| {
            let mut joints = joints.to_vec();
            if let Change::Exchanged([a, b]) = change
                && joints.len() > *b
            {
                joints.swap(*a, *b);
            }
            joints
        };
        match change {
            Change::Exchanged([a, b]) => {
                measured.swap(*a, *b);
                measured.iter_mut().for_each(|m| m.rest = order(&m.rest));
            }
            Change::Reversed(_) => {}
        }
        let model = Self::new(measured, self.targets_mm.len())?;
        let distance = |r: &SweepReading| {
            let mut joints = order(&r.joints);
            if let Change::Reversed(j) = change {
                joints[*j] = -joints[*j];
            }
            norm(minus(r.position_mm, model.position(&joints, r.target)))
        };
        Some(rms(readings.iter().map(distance)))
    }
}

/// Readings for comparisons between sweeps: some of each path, if joint values are known.
pub fn compared(sweeps: &[Sweep], axes: &[JointAxis]) -> Vec<SweepReading> {
    let mut all = Vec::new();
    for (sweep, axis) in sweeps.iter().zip(axes) {
        for path in &axis.fit.paths {
            let own = sweep.readings.iter().zip(&axis.fit.used);
            let used: Vec<&SweepReading> =
                own.filter(|(r, used)| **used && r.target == path.target).map(|(r, _)| r).collect();
            let step = used.len().div_ceil(COMPARED).max(1);
            all.extend(used.into_iter().step_by(step).filter(|r| !r.joints.is_empty()).cloned());
        }
    }
    all
}

/// Largest distance (mm) between the first readings of one target in two sweeps without joint
/// values, which must start from the same pose; with the two sweeps and the target.
pub fn start_gap(sweeps: &[Sweep]) -> Option<(f64, [usize; 2], usize)> {
    let mut worst: Option<(f64, [usize; 2], usize)> = None;
    let first = |s: &Sweep, t: usize| s.readings.iter().find(|r| r.target == t).map(|r| r.position_mm);
    let targets = sweeps.iter().flat_map(|s| s.readings.iter().map(|r| r.target)).max()? + 1;
    for t in 0..targets {
        let starts: Vec<(usize, Vector)> = sweeps.iter().filter_map(|s| Some((s.joint, first(s, t)?))).collect();
        for (i, a) in starts.iter().enumerate() {
            for b in &starts[i + 1..] {
                let gap = norm(minus(a.1, b.1));
                if worst.is_none_or(|(most, ..)| gap > most) {
                    worst = Some((gap, [a.0, b.0], t));
                }
            }
        }
    }
    worst
}
