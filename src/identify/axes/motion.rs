//! Sign, zero and error motions of a joint from its sweep.

use super::noise::{NoiseMotion, noise_motion};
use super::{Sweep, SweepFit, SweepReading};
use etalon_base::pose::{Pose, Vector, minus, norm};
use etalon_math::statistics::median;
use nalgebra::DMatrix;
use std::f64::consts::{PI, TAU};

/// Comparison of the motion of targets with the joint values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Travel {
    /// Motion about or along the axis per unit of the joint value (rad/rad or mm/mm), positive.
    pub ratio: f64,
    /// Root mean square of the motion minus the joint value (rad or mm), after a common offset.
    pub rms: f64,
    /// Largest of these differences.
    pub largest: f64,
}

/// Error motions of an axis (ISO 230-7:2015). They include the noise of the measuring system.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ErrorMotion {
    /// Radial error motion of each path, peak to valley (mm): perpendicular to the axis, or along x
    /// of a prismatic joint.
    pub radial_mm: Vec<f64>,
    /// Face error motion of each path at its radius, peak to valley (mm): along the axis, or along
    /// y of a prismatic joint.
    pub face_mm: Vec<f64>,
    /// Axial error motion, peak to valley (mm): along the axis at the axis; from three targets.
    pub axial_mm: Option<f64>,
    /// Tilt error motion, largest angle between the axis and its mean (rad); from three targets.
    pub tilt_rad: Option<f64>,
    /// Error motions that noise alone gives.
    pub noise: NoiseMotion,
}

/// Difference of angles in −π to π.
pub(super) fn wrapped(angle: f64) -> f64 {
    (angle + PI).rem_euclid(TAU) - PI
}

/// Travels of the used readings of a path with their joint values, in the order of the motion.
fn travels(sweep: &Sweep, fit: &SweepFit, path: usize) -> Vec<(f64, Option<f64>)> {
    let of = sweep.readings.iter().zip(&fit.used).filter(|(r, used)| **used && r.target == fit.paths[path].target);
    of.map(|(r, _)| (fit.travel(&fit.frame, r.position_mm), r.joints.get(sweep.joint).copied())).collect()
}

/// `true` if the joint moves opposite to the axis of its fit, by the joint values or by the order
/// of the readings.
pub(super) fn is_reversed(sweep: &Sweep, fit: &SweepFit) -> bool {
    let mut sum = 0.0;
    for path in 0..fit.paths.len() {
        let all = travels(sweep, fit, path);
        let weight = if fit.prismatic { 1.0 } else { fit.paths[path].radius_mm };
        for pair in all.windows(2) {
            let step = pair[1].0 - pair[0].0;
            let step = if fit.prismatic { step } else { wrapped(step) };
            let sign = pair[0].1.zip(pair[1].1).map_or(1.0, |(a, b)| (b - a).signum() * f64::from(u8::from(a != b)));
            sum += step * sign * weight;
        }
    }
    sum < 0.0
}

/// Travel minus joint value of each used reading of a path, continuous about the first.
fn offsets(sweep: &Sweep, fit: &SweepFit, frame: &Pose, path: usize) -> Vec<(usize, f64)> {
    let of = sweep.readings.iter().enumerate().filter(|(i, r)| fit.used[*i] && r.target == fit.paths[path].target);
    let mut first = None;
    let offset = |(i, r): (usize, &SweepReading)| {
        let offset = fit.travel(frame, r.position_mm) - r.joints.get(sweep.joint).copied().unwrap_or_default();
        let about = *first.get_or_insert(offset);
        (i, if fit.prismatic { offset } else { about + wrapped(offset - about) })
    };
    of.map(offset).collect()
}

/// Phase of each path, and the covariance of the parameters of the fit followed by the phases.
///
/// The error of a reading along the path is independent of its errors across, so that a phase adds
/// its own variance to that of the axis.
pub(super) fn phases(sweep: &Sweep, fit: &SweepFit, u_mm: f64) -> (Vec<f64>, DMatrix<f64>) {
    let with_values = sweep.readings.iter().all(|r| !r.joints.is_empty());
    let (n, paths) = (fit.cofactors.nrows(), fit.paths.len());
    let phase = |frame: &Pose, path: usize| {
        let mut all = offsets(sweep, fit, frame, path);
        all.truncate(if with_values { usize::MAX } else { 1 });
        all.iter().map(|(_, offset)| offset).sum::<f64>() / all.len().max(1) as f64
    };
    let phases: Vec<f64> = (0..paths).map(|path| phase(&fit.frame, path)).collect();
    let mut sensitivity = DMatrix::zeros(paths, n);
    for k in 0..fit.of_axis() {
        let step = if k < 2 { 1e-6 } else { 1e-4 };
        let at = |sign: f64, path: usize| {
            let mut change = vec![0.0; fit.of_axis()];
            change[k] = sign * step;
            phase(&fit.frame_changed(&change), path)
        };
        for path in 0..paths {
            let moved = at(1.0, path) - at(-1.0, path);
            sensitivity[(path, k)] = if fit.prismatic { moved } else { wrapped(moved) } / (2.0 * step);
        }
    }
    let variance = u_mm * u_mm;
    let own = &fit.cofactors * variance;
    let cross = &sensitivity * &own;
    let of_phases = &cross * sensitivity.transpose();
    let mut all = DMatrix::zeros(n + paths, n + paths);
    all.view_mut((0, 0), (n, n)).copy_from(&own);
    all.view_mut((n, 0), (paths, n)).copy_from(&cross);
    all.view_mut((0, n), (n, paths)).copy_from(&cross.transpose());
    all.view_mut((n, n), (paths, paths)).copy_from(&of_phases);
    for (path, p) in fit.paths.iter().enumerate() {
        let lever = if fit.prismatic { 1.0 } else { p.radius_mm };
        let count = if with_values { p.readings.max(1) } else { 1 };
        all[(n + path, n + path)] += variance / (lever * lever * count as f64);
    }
    (phases, all)
}

/// Motion compared with the joint values; `None` without joint values or motion.
pub(super) fn travel(sweep: &Sweep, fit: &SweepFit) -> Option<Travel> {
    let (mut above, mut below) = (0.0, 0.0);
    let mut differences = Vec::new();
    for path in 0..fit.paths.len() {
        let all = travels(sweep, fit, path);
        let mut at = all.first()?.0;
        let mut unwound = Vec::new();
        for (travel, value) in &all {
            let step = travel - at;
            at += if fit.prismatic { step } else { wrapped(step) };
            unwound.push((at, (*value)?));
        }
        let count = unwound.len().max(1) as f64;
        let mean = |of: &dyn Fn(&(f64, f64)) -> f64| unwound.iter().map(of).sum::<f64>() / count;
        let (motion, value) = (mean(&|p| p.0), mean(&|p| p.1));
        above += unwound.iter().map(|p| (p.0 - motion) * (p.1 - value)).sum::<f64>();
        below += unwound.iter().map(|p| (p.1 - value).powi(2)).sum::<f64>();
        let offsets = offsets(sweep, fit, &fit.frame, path);
        let mean = offsets.iter().map(|o| o.1).sum::<f64>() / offsets.len().max(1) as f64;
        differences.extend(offsets.iter().map(|o| o.1 - mean));
    }
    let largest = differences.iter().map(|d| d.abs()).fold(0.0, f64::max);
    let rms = (differences.iter().map(|d| d * d).sum::<f64>() / differences.len().max(1) as f64).sqrt();
    (below > 0.0).then_some(Travel { ratio: above / below, rms, largest })
}

/// Peak to valley.
fn range(values: impl Iterator<Item = f64>) -> f64 {
    let [low, high] = values.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], v| [a.min(v), b.max(v)]);
    (high - low).max(0.0)
}

/// Error motions of the paths, and of the axis itself where three targets were read together;
/// `noise_mm` is the noise of a coordinate.
pub(super) fn error_motion(sweep: &Sweep, fit: &SweepFit, noise_mm: f64) -> ErrorMotion {
    let of = |path: usize, k: usize| {
        let all = sweep.readings.iter().zip(&fit.residuals_mm).zip(&fit.used);
        let own = all.filter(move |((r, _), used)| **used && r.target == fit.paths[path].target);
        range(own.map(move |((_, residual), _)| residual[k]))
    };
    let axis = (!fit.prismatic).then(|| rigid_motion(sweep, fit)).flatten();
    ErrorMotion {
        radial_mm: (0..fit.paths.len()).map(|path| of(path, 0)).collect(),
        face_mm: (0..fit.paths.len()).map(|path| of(path, 1)).collect(),
        axial_mm: axis.as_ref().map(|a| a.axial_mm),
        tilt_rad: axis.as_ref().map(|a| a.tilt_rad),
        noise: noise_motion(sweep, fit, axis.as_ref().map(|a| (&a.body[..], a.steps)), noise_mm),
    }
}

/// Motion of the axis itself.
struct RigidMotion {
    axial_mm: f64,
    tilt_rad: f64,
    /// Targets at a mean place; the axis is z.
    body: Vec<Vector>,
    steps: usize,
}

/// Axial and tilt error motion, from the rigid body of three targets or more.
fn rigid_motion(sweep: &Sweep, fit: &SweepFit) -> Option<RigidMotion> {
    let inverse = fit.frame.inverse();
    // steps at which every target was read, in the order of the motion
    let paths: Vec<Vec<Vector>> = fit
        .paths
        .iter()
        .map(|p| {
            let own = sweep.readings.iter().zip(&fit.used).filter(|(r, _)| r.target == p.target);
            own.filter(|(_, used)| **used).map(|(r, _)| inverse.apply(r.position_mm)).collect()
        })
        .collect();
    let steps = paths.first()?.len();
    if paths.len() < 3 || steps < 3 || paths.iter().any(|p| p.len() != steps) {
        return None;
    }
    let bodies: Vec<Vec<Vector>> = (0..steps).map(|i| paths.iter().map(|p| p[i]).collect()).collect();
    // the body at a mean place: the first one, its paths' radii and heights
    let first = &bodies[0];
    let mean: Vec<Vector> = first
        .iter()
        .zip(&fit.paths)
        .map(|(p, path)| {
            let (sin, cos) = p[1].atan2(p[0]).sin_cos();
            [path.radius_mm * cos, path.radius_mm * sin, path.height_mm]
        })
        .collect();
    let (a, b) = (minus(mean[1], mean[0]), minus(mean[2], mean[0]));
    let area = norm(etalon_base::pose::cross(a, b));
    if area < 1e-3 * norm(a) * norm(b) {
        return None;
    }
    let mut axial = Vec::new();
    let mut tilts = Vec::new();
    for body in &bodies {
        let placed = etalon_fit::rigid(&mean, body).ok()?.to_T_from;
        // the axis of the body where it is now
        axial.push(placed.apply([0.0; 3])[2]);
        tilts.push(placed.axis(2));
    }
    let count = tilts.len() as f64;
    let centre = [0, 1].map(|k| tilts.iter().map(|t| t[k]).sum::<f64>() / count);
    let tilt_rad = tilts.iter().map(|t| (t[0] - centre[0]).hypot(t[1] - centre[1])).fold(0.0, f64::max);
    Some(RigidMotion { axial_mm: range(axial.into_iter()), tilt_rad, body: mean, steps })
}

/// Second differences of the residuals of the used readings of each target (mm).
fn second_differences(sweep: &Sweep, fit: &SweepFit) -> Vec<[f64; 2]> {
    let mut all = Vec::new();
    for path in &fit.paths {
        let own = sweep.readings.iter().zip(&fit.residuals_mm).zip(&fit.used);
        let own: Vec<[f64; 2]> =
            own.filter(|((r, _), used)| **used && r.target == path.target).map(|((_, res), _)| *res).collect();
        all.extend(own.windows(3).map(|w| [0, 1].map(|k| w[0][k] - 2.0 * w[1][k] + w[2][k])));
    }
    all
}

/// Noise from point to point (mm) by the median of the second differences, which a few jumps do not
/// change. The median of the squared length of two normal components is 2 ln 2 times their
/// variance.
pub(super) fn usual_noise_mm(sweep: &Sweep, fit: &SweepFit) -> Option<f64> {
    let squares = second_differences(sweep, fit).into_iter().map(|[a, b]| (a * a + b * b) / 6.0);
    Some((median(squares)? / (2.0 * std::f64::consts::LN_2)).sqrt())
}

/// Root mean square of residuals, and noise from point to point, of the used readings (mm).
///
/// Neighbours differ by noise alone where the deviation is smooth (von Neumann 1941): the second
/// differences of equally spaced readings have six times the variance of a reading.
pub(super) fn smoothness(sweep: &Sweep, fit: &SweepFit) -> Option<[f64; 2]> {
    let used = fit.residuals_mm.iter().zip(&fit.used).filter(|(_, used)| **used).map(|(residual, _)| *residual);
    let root = |all: Vec<[f64; 2]>| (all.iter().flatten().map(|v| v * v).sum::<f64>() / (2 * all.len()) as f64).sqrt();
    let seconds = second_differences(sweep, fit);
    (seconds.len() >= 6).then(|| [root(used.collect()), root(seconds) / 6f64.sqrt()])
}
