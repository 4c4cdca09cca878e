//! Sign, zero and error motions of a joint from its sweep.

use super::noise::{NoiseMotion, noise_motion};
use super::{Sweep, SweepFit, SweepReading, smooth};
use crate::MeasuredRatio;
use etalon_base::angle::Turn;
use etalon_base::pose::{Pose, Vector, minus, norm};
use etalon_math::statistics::median;
use nalgebra::DMatrix;

/// Comparison of the motion of targets with the joint values. Each target has the weight of its
/// angle: a target near the axis says little.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Travel {
    /// Motion about or along the axis per unit of the joint value (rad/rad or mm/mm), positive; its
    /// uncertainty is by the readings along the path and by the axis.
    pub ratio: MeasuredRatio,
    /// Root mean square of the motion minus the joint value (rad or mm), after a common offset.
    pub rms: f64,
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

/// Difference of two motions: modulo a turn if the joint turns.
fn difference(fit: &SweepFit, to: f64, from: f64) -> f64 {
    if fit.prismatic { to - from } else { Turn::RADIANS.difference(to, from) }
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
            let step = difference(fit, pair[1].0, pair[0].0);
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
        (i, about + difference(fit, offset, about))
    };
    of.map(offset).collect()
}

/// Phase of each path, and the covariance of the parameters of the fit followed by the phases.
///
/// The error of a reading along the path is independent of its errors across, so that a phase adds
/// its own variance to the variance of the axis. `own` is the covariance of the parameters of the
/// fit.
pub(super) fn phases(sweep: &Sweep, fit: &SweepFit, u_mm: f64, own: &DMatrix<f64>) -> (Vec<f64>, DMatrix<f64>) {
    let with_values = sweep.readings.iter().all(|r| !r.joints.is_empty());
    let (n, paths) = (fit.cofactors.nrows(), fit.paths.len());
    let phase = |frame: &Pose, path: usize| {
        let mut all = offsets(sweep, fit, frame, path);
        all.truncate(if with_values { usize::MAX } else { 1 });
        all.iter().map(|(_, offset)| offset).sum::<f64>() / all.len().max(1) as f64
    };
    let phases: Vec<f64> = (0..paths).map(|path| phase(&fit.frame, path)).collect();
    let mut sensitivity = DMatrix::zeros(paths, n);
    for k in 0..fit.axis_parameter_count() {
        let step = if k < 2 { 1e-6 } else { 1e-4 };
        let at = |sign: f64, path: usize| {
            let mut change = vec![0.0; fit.axis_parameter_count()];
            change[k] = sign * step;
            phase(&fit.frame_changed(&change), path)
        };
        for path in 0..paths {
            sensitivity[(path, k)] = difference(fit, at(1.0, path), at(-1.0, path)) / (2.0 * step);
        }
    }
    let cross = &sensitivity * own;
    let of_phases = &cross * sensitivity.transpose();
    let mut all = DMatrix::zeros(n + paths, n + paths);
    all.view_mut((0, 0), (n, n)).copy_from(own);
    all.view_mut((n, 0), (paths, n)).copy_from(&cross);
    all.view_mut((0, n), (n, paths)).copy_from(&cross.transpose());
    all.view_mut((n, n), (paths, paths)).copy_from(&of_phases);
    for path in 0..paths {
        let lever = lever(fit, path);
        let count = if with_values { fit.paths[path].readings.max(1) } else { 1 };
        let noise = u_mm * u_mm / (lever * lever * count as f64);
        // what drives the joint may deviate smoothly, too
        let along = with_values.then(|| mean_along(sweep, fit, path)).flatten().unwrap_or_default();
        all[(n + path, n + path)] += noise.max(along);
    }
    (phases, all)
}

/// Length (mm) along the path of a unit of motion.
fn lever(fit: &SweepFit, path: usize) -> f64 {
    if fit.prismatic { 1.0 } else { fit.paths[path].radius_mm.max(f64::MIN_POSITIVE) }
}

/// Variance of the mean of motion minus joint value of a path.
fn mean_along(sweep: &Sweep, fit: &SweepFit, path: usize) -> Option<f64> {
    let all = offsets(sweep, fit, &fit.frame, path);
    let (rows, values): (Vec<usize>, Vec<f64>) = all.into_iter().unzip();
    let columns = vec![vec![1.0]; rows.len()];
    let trend = smooth::tangential(sweep, fit, &rows, &values, &columns).trend(0.0)?;
    Some(trend.covariance[(0, 0)])
}

/// Motions and joint values of a path about their means, in the order of the motion; each is within
/// half a turn of the previous one.
fn motions(sweep: &Sweep, fit: &SweepFit, frame: &Pose, rows: &[usize]) -> Option<[Vec<f64>; 2]> {
    let value = |&i: &usize| sweep.readings[i].joints.get(sweep.joint).copied();
    let values = rows.iter().map(value).collect::<Option<Vec<f64>>>()?;
    let travels: Vec<f64> = rows.iter().map(|&i| fit.travel(frame, sweep.readings[i].position_mm)).collect();
    let travels = if fit.prismatic { travels } else { Turn::RADIANS.followed(&travels) };
    let centred = |all: Vec<f64>| {
        let mean = all.iter().sum::<f64>() / all.len().max(1) as f64;
        all.into_iter().map(|v| v - mean).collect::<Vec<f64>>()
    };
    Some([centred(travels), centred(values)])
}

/// Slope of motion minus joint value over the joint value.
fn slope([travels, values]: &[Vec<f64>; 2]) -> f64 {
    let pairs = || travels.iter().zip(values);
    pairs().map(|(t, v)| (t - v) * v).sum::<f64>() / values.iter().map(|v| v * v).sum::<f64>()
}

/// Motion compared with the joint values; `None` without joint values or motion. `covariance` is
/// the covariance of the parameters of the fit.
pub(super) fn travel(sweep: &Sweep, fit: &SweepFit, u_mm: f64, covariance: &DMatrix<f64>) -> Option<Travel> {
    let rows: Vec<Vec<usize>> = fit.paths.iter().map(|p| smooth::rows(sweep, fit, p.target, false)).collect();
    let (mut weights, mut sum, mut degrees_of_freedom) = (Vec::new(), 0.0, 0.0f64);
    let (mut squares, mut levers) = (0.0, 0.0);
    for (path, rows) in rows.iter().enumerate() {
        let both = motions(sweep, fit, &fit.frame, rows)?;
        let (square, lever) = (both[1].iter().map(|v| v * v).sum::<f64>(), lever(fit, path));
        if square <= 0.0 {
            weights.push(0.0);
            continue;
        }
        let off: Vec<f64> = both[0].iter().zip(&both[1]).map(|(t, v)| t - v).collect();
        let columns: Vec<Vec<f64>> = both[1].iter().map(|v| vec![1.0, *v]).collect();
        let trend = smooth::tangential(sweep, fit, rows, &off, &columns).trend(0.0)?;
        // no angle is better known than by the noise of a coordinate
        let noise = u_mm * u_mm / (lever * lever * square);
        let weight = 1.0 / trend.covariance[(1, 1)].max(noise).max(f64::MIN_POSITIVE);
        sum += weight * trend.coefficients[1];
        degrees_of_freedom = degrees_of_freedom.max(trend.degrees_of_freedom);
        weights.push(weight);
        squares += lever * lever * off.iter().map(|d| d * d).sum::<f64>();
        levers += lever * lever * off.len() as f64;
    }
    let all: f64 = weights.iter().sum();
    if all <= 0.0 {
        return None;
    }
    let of_frame = |frame: &Pose| {
        let each = rows.iter().zip(&weights).filter(|(_, w)| **w > 0.0);
        each.filter_map(|(rows, w)| Some(w / all * slope(&motions(sweep, fit, frame, rows)?))).sum::<f64>()
    };
    let n = fit.axis_parameter_count();
    let by_axis = nalgebra::DVector::from_fn(n, |k, _| {
        let step = if k < 2 { 1e-6 } else { 1e-4 };
        let at = |sign: f64| {
            let mut change = vec![0.0; n];
            change[k] = sign * step;
            of_frame(&fit.frame_changed(&change))
        };
        (at(1.0) - at(-1.0)) / (2.0 * step)
    });
    let of_axis = (by_axis.transpose() * covariance.view((0, 0), (n, n)) * &by_axis)[(0, 0)].max(0.0);
    Some(Travel {
        ratio: MeasuredRatio {
            value: 1.0 + sum / all,
            standard_uncertainty: (1.0 / all + of_axis).sqrt(),
            degrees_of_freedom,
        },
        rms: (squares / levers).sqrt(),
    })
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
