//! A set-up that changed while it was measured: from one pose on, base or measuring system, or one
//! target on its carrier, is elsewhere, or a joint counts from another zero.
//!
//! All changes are tried at every pose, to first order about the identified parameters: the columns
//! of the change are zero before the pose, and the parameters are fitted again. Sums over the poses
//! give every pose in one pass. The misfit of the model is the standard deviation, and because it
//! is alike at neighbouring poses, a change must show between poses that are near in joint space.

use crate::model::residuals::Residuals;
use crate::{Identification, Observation, Settings};
use etalon_base::catalogue::Phrase;
use etalon_base::message::Message;
use etalon_base::pose::{Vector, centroid, cross, minus, norm};
use etalon_base::pose_name::PoseName;
use etalon_base::{phrase, warning};
use etalon_math::Problem;
use etalon_math::statistics::{median, standard_deviation};
use etalon_robots::{Quantity, Robot};
use nalgebra::{Cholesky, DMatrix, DVector};
use statrs::distribution::{ContinuousCDF, FisherSnedecor};
use std::collections::{BTreeMap, BTreeSet};

/// Minimum number of poses on either side of a change.
const FEWEST_ASIDE: usize = 5;
/// Probability of the largest of all changes by chance.
const CHANCE: f64 = 1e-6;
/// Minimum share of a change that must show between poses that are neighbours in joint space, and
/// its size in standard uncertainties there.
const BETWEEN_NEIGHBOURS: f64 = 0.5;
const SEEN: f64 = 3.0;
/// Maximum distance of a pose from its neighbour before the change, relative to that from its
/// neighbour after it.
const NEIGHBOURS: f64 = 1.1;
/// Shift, in standard deviations of the residuals with it, that the misfit of no model makes.
const LARGE: f64 = 8.0;
/// Minimum share of the residual sum of squares that is worth a decision.
const LEAST_SHARE: f64 = 0.05;
/// Minimum share of another zero of a joint, whose errors in the model are alike at many poses.
const LEAST_SHARE_OF_ZERO: f64 = 0.3;
/// Maximum residual sum of squares that another change leaves, relative to the best one, if it
/// explains the measurements as well.
const ALIKE: f64 = 1.1;
/// Minimum degrees of freedom of the residuals with a change.
const FEWEST_DEGREES: f64 = 5.0;
/// Minimum number of residuals for each parameter and each column of the usual misfit.
const REDUNDANT: usize = 2;
/// Residuals beyond this many robust standard deviations from those before and after them, of this
/// many poses, are wrong readings, and do not count.
const GROSS: f64 = 8.0;
const ASIDE: usize = 3;

/// Part of the set-up that is elsewhere from a pose on.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Part {
    /// Base or measuring system, shifted.
    Shifted,
    /// Base or measuring system, shifted and turned about the middle of the measured points.
    Turned,
    /// The target with this index, on its carrier.
    Target(usize),
    /// The zero of the joint with this index.
    Zero(usize),
}

/// A change at a pose.
struct Found {
    part: Part,
    /// Index of the first observation after it.
    at: usize,
    /// Shift (mm) of the measured points, or of the target on its carrier; zero for a joint.
    shift_mm: Vector,
    /// Standard uncertainty of the shift along its direction (mm), or of the zero (rad or mm).
    u: f64,
    /// Root mean square of the displacement (mm) of the measured points.
    size_mm: f64,
    /// Standard deviation (mm) of the residuals of a coordinate with the change.
    left_mm: f64,
    /// Logarithm of the probability by chance.
    chance: f64,
    /// Share of the residual sum of squares that it explains.
    share: f64,
    /// The change in its columns, and the influence of the parameters on it.
    change: DVector<f64>,
    absorbed: DVector<f64>,
}

/// A change at a pose, in its columns.
struct Step {
    /// Sum of squares that it explains.
    explained: f64,
    at: usize,
    change: DVector<f64>,
    /// Its covariance for residuals of unit variance.
    inverse: DMatrix<f64>,
    /// Influence of the parameters on it.
    absorbed: DVector<f64>,
}

/// Rows of one observation: residuals without the influence of the parameters.
struct Rows {
    residuals: DVector<f64>,
    /// Orthonormal basis of the influence of the parameters.
    basis: DMatrix<f64>,
    /// Columns of the change.
    columns: DMatrix<f64>,
}

/// Linear part of an identification, observation by observation.
struct Linear<'a> {
    robot: &'a dyn Robot,
    observations: &'a [Observation],
    values: &'a [f64],
    /// Residuals, orthogonal to the basis.
    residuals: DVector<f64>,
    basis: DMatrix<f64>,
    /// First row of each observation, and the number of rows.
    starts: Vec<usize>,
    /// Number of residuals of positions and conditions.
    measured: usize,
    /// Derivatives of the coordinates by the joints.
    by_joint: DMatrix<f64>,
    middle: Vector,
    /// Standard deviation (mm) of a coordinate that the residuals show: their unit.
    unit_mm: f64,
}

/// Returns a warning if base or measuring system, or a target, was elsewhere from a pose on;
/// `values` are the parameters about which the identification is linear.
pub fn moved_between(
    robot: &dyn Robot,
    observations: &[Observation],
    settings: &Settings,
    found: &Identification,
    values: &[f64],
) -> Option<Message> {
    let linear = Linear::new(robot, observations, settings, found, values)?;
    let mut parts = vec![Part::Shifted];
    if observations.len() > 4 * FEWEST_ASIDE {
        parts.push(Part::Turned);
    }
    if robot.targets().len() > 1 && robot.free_base().is_some() {
        parts.extend((0..robot.targets().len()).map(Part::Target));
    }
    parts.extend((0..robot.joints().len()).map(Part::Zero));
    let all: Vec<Found> = parts.into_iter().filter_map(|part| linear.changed(part)).collect();
    let best = all.iter().min_by(|a, b| a.chance.total_cmp(&b.chance))?;
    let least = if matches!(best.part, Part::Zero(_)) { LEAST_SHARE_OF_ZERO } else { LEAST_SHARE };
    let is_large = best.size_mm > LARGE * best.left_mm;
    let is_significant = best.chance <= CHANCE.ln() && best.share >= least;
    if !is_significant || !(is_large || linear.shows_between_neighbours(best)) {
        return None;
    }
    Some(linear.message(best, &all))
}

impl<'a> Linear<'a> {
    fn new(
        robot: &'a dyn Robot,
        observations: &'a [Observation],
        settings: &Settings,
        found: &Identification,
        values: &'a [f64],
    ) -> Option<Self> {
        // residuals of positions alone, and nominal values as the identification weighted them
        let plain: Vec<Observation> =
            observations.iter().map(|o| Observation { covariances_mm2: Vec::new(), ..o.clone() }).collect();
        let settings =
            Settings { kind: crate::ResidualKind::Targets, common_uncertainty_mm: None, ..settings.as_found(found) };
        let mut problem = Residuals::new(robot, &plain, &settings, &found.free, values).ok()?;
        problem.layout = None;
        let x: Vec<f64> = found.free.iter().map(|&i| values[i]).collect();
        let mut residuals = vec![0.0; problem.residual_count()];
        problem.residuals(&x, &mut residuals);
        let mut jacobian = jacobian_with_misfit(&problem, &x);
        let (dimension, measured) = (robot.dimension(), problem.measured_count());
        let mut by_joint = DMatrix::from_row_slice(measured, robot.joints().len(), &problem.joint_jacobian(&x));
        for row in wrong_rows(observations, &residuals[..problem.coordinate_count()], dimension)? {
            residuals[row] = 0.0;
            jacobian.row_mut(row).fill(0.0);
            by_joint.row_mut(row).fill(0.0);
        }
        let scales = misfits(&problem, &residuals)?;
        scales.iter().enumerate().for_each(|(row, scale)| {
            residuals[row] /= scale;
            jacobian.row_mut(row).unscale_mut(*scale);
        });
        by_joint.row_iter_mut().zip(&scales).for_each(|(mut row, scale)| row.unscale_mut(*scale));
        let n = jacobian.ncols();
        let norms: Vec<f64> = jacobian.column_iter().map(|c| c.norm().max(f64::MIN_POSITIVE)).collect();
        let basis =
            (&jacobian * DMatrix::from_diagonal(&DVector::from_iterator(n, norms.iter().map(|v| 1.0 / v)))).qr().q();
        let mut residuals = DVector::from_vec(residuals);
        residuals -= &basis * basis.tr_mul(&residuals);
        let mut starts = vec![0];
        for o in observations {
            starts.push(starts.last()? + dimension * o.targets.iter().flatten().count());
        }
        let points: Vec<Vector> = observations.iter().flat_map(|o| o.targets.iter().flatten().copied()).collect();
        let middle = centroid(&points)?;
        let unit_mm = problem.unit * scales.first()?;
        Some(Self { robot, observations, values, residuals, basis, starts, measured, by_joint, middle, unit_mm })
    }

    /// Variance of the mean residual of a pose relative to the variance of independent residuals:
    /// the misfit of the model is common to the targets and the repeats of a pose.
    fn common_to_a_pose(&self) -> f64 {
        let dimension = self.robot.dimension();
        // of each axis the number, the sum and the sum of squares
        let mut poses: BTreeMap<PoseName, [[f64; 3]; 3]> = BTreeMap::new();
        for (o, rows) in self.observations.iter().zip(self.starts.windows(2)) {
            let sums = poses.entry(o.pose).or_default();
            for (row, r) in self.residuals.as_slice()[rows[0]..rows[1]].iter().enumerate() {
                let [count, sum, squares] = &mut sums[row % dimension];
                (*count, *sum, *squares) = (*count + 1.0, *sum + r, *squares + r * r);
            }
        }
        let (mut of_means, mut each) = (0.0, 0.0);
        for [count, sum, squares] in poses.values().flatten().filter(|[count, ..]| *count > 0.0) {
            of_means += sum * sum / count;
            each += squares / count;
        }
        (of_means / each).max(1.0)
    }

    fn rows(&self, k: usize, part: Part) -> Rows {
        let (first, count) = (self.starts[k], self.starts[k + 1] - self.starts[k]);
        Rows {
            residuals: self.residuals.rows(first, count).into_owned(),
            basis: self.basis.rows(first, count).into_owned(),
            columns: self.columns(k, part),
        }
    }

    /// Derivatives of the residuals (predicted minus measured, in their unit) by the
    /// change of a part.
    fn columns(&self, k: usize, part: Part) -> DMatrix<f64> {
        if let Part::Zero(joint) = part {
            return self.by_joint.view((self.starts[k], joint), (self.starts[k + 1] - self.starts[k], 1)).into_owned();
        }
        let (o, dimension) = (&self.observations[k], self.robot.dimension());
        let seen: Vec<(usize, Vector)> = o.targets.iter().enumerate().filter_map(|(k, at)| Some((k, (*at)?))).collect();
        let count = match part {
            Part::Turned if dimension == 2 => 3,
            Part::Turned => 6,
            Part::Shifted => dimension,
            Part::Target(_) | Part::Zero(_) => 3,
        };
        let arm = self.robot.free_base();
        DMatrix::from_fn(dimension * seen.len(), count, |row, column| {
            let (target, at) = seen[row / dimension];
            let axis = row % dimension;
            let by: Vector = match part {
                Part::Target(moved) => match arm {
                    Some(arm) if moved == target => arm.flange(self.values, &o.joints, target).axis(column),
                    _ => [0.0; 3],
                },
                Part::Turned if column >= dimension => {
                    let about = if dimension == 2 { 2 } else { column - 3 };
                    cross([0, 1, 2].map(|i| f64::from(u8::from(i == about))), minus(at, self.middle)).map(|v| v / 100.0)
                }
                _ => [0, 1, 2].map(|i| f64::from(u8::from(i == column))),
            };
            by[axis]
        })
    }

    /// The most probable change of a part at any pose.
    fn changed(&self, part: Part) -> Option<Found> {
        let n = self.observations.len();
        let rows: Vec<Rows> = (0..n).map(|k| self.rows(k, part)).collect();
        let count = rows.first()?.columns.ncols();
        let measured = 0..self.measured;
        let total = self.residuals.rows_range(measured.clone()).norm_squared();
        // residuals that neither parameters nor a change can make zero
        let degrees = self.measured as f64 - self.basis.rows_range(measured).norm_squared() - count as f64;
        if degrees < FEWEST_DEGREES {
            return None;
        }
        // sums over the poses from the last one back
        let mut along = DMatrix::zeros(self.basis.ncols(), count);
        let (mut normal, mut right) = (DMatrix::zeros(count, count), DVector::zeros(count));
        let mut best: Option<Step> = None;
        for k in (1..n).rev() {
            along += rows[k].basis.tr_mul(&rows[k].columns);
            normal += rows[k].columns.tr_mul(&rows[k].columns);
            right += rows[k].columns.tr_mul(&rows[k].residuals);
            let is_between = self.observations[k].pose != self.observations[k - 1].pose;
            if !is_between || k < FEWEST_ASIDE || n - k < FEWEST_ASIDE {
                continue;
            }
            let left = &normal - along.tr_mul(&along);
            let Some(inverse) = Cholesky::new(left.clone()).map(|c| c.inverse()) else { continue };
            let regular = (0..count).all(|i| left[(i, i)] > 1e-6 * normal[(i, i)]);
            let change = &inverse * &right;
            let explained = right.dot(&change);
            if regular && best.as_ref().is_none_or(|best| explained > best.explained) {
                best = Some(Step { explained, at: k, absorbed: &along * &change, change, inverse });
            }
        }
        let Step { explained, at, change, inverse, absorbed } = best?;
        // a drift of the zero explains more than a step does
        if matches!(part, Part::Zero(_)) && self.explained_by_drift(&rows) >= explained {
            return None;
        }
        // residuals of the measurements with the change and the parameters fitted to it
        let mut left = self.residuals.rows(0, self.measured) + self.basis.rows(0, self.measured) * &absorbed;
        for (k, row) in rows.iter().enumerate().skip(at) {
            let mut here = left.rows_mut(self.starts[k], row.columns.nrows());
            here -= &row.columns * &change;
        }
        let left = left.norm_squared().max(f64::MIN_POSITIVE);
        let (variance, explained) = (left / degrees, (total - left).max(0.0));
        let common = self.common_to_a_pose();
        let f = FisherSnedecor::new(count as f64, (degrees / common).max(1.0)).ok()?;
        let chance = f.sf(explained / count as f64 / variance / common).max(1e-300).ln() + (n as f64).ln();
        let left_mm = self.unit_mm * variance.sqrt();
        let share = explained / total;
        if matches!(part, Part::Zero(_)) {
            let u = (common * variance * inverse[(0, 0)]).sqrt();
            let moved: f64 = rows[at..].iter().map(|row| (&row.columns * &change).norm_squared()).sum();
            let points = rows[at..].iter().map(|row| row.columns.nrows()).sum::<usize>() / self.robot.dimension();
            let size_mm = self.unit_mm * (moved / points as f64).sqrt();
            return Some(Found { part, at, shift_mm: [0.0; 3], u, size_mm, left_mm, chance, share, change, absorbed });
        }
        // residuals are predicted minus measured
        let dimension = if matches!(part, Part::Target(_)) { 3 } else { self.robot.dimension() };
        let shift_mm = [0, 1, 2].map(|i| if i < dimension { -self.unit_mm * change[i] } else { 0.0 });
        let along = DVector::from_fn(count, |i, _| if i < 3 { shift_mm.get(i).copied().unwrap_or(0.0) } else { 0.0 });
        let along = along.scale(1.0 / along.norm().max(f64::MIN_POSITIVE));
        let u = self.unit_mm * (common * variance * (along.transpose() * inverse * &along)[(0, 0)]).sqrt();
        let size_mm = norm(shift_mm);
        Some(Found { part, at, shift_mm, u, size_mm, left_mm, chance, share, change, absorbed })
    }

    /// Sum of squares that a change explains that grows with the number of the observation.
    fn explained_by_drift(&self, rows: &[Rows]) -> f64 {
        let count = rows.first().map_or(0, |row| row.columns.ncols());
        let mut along = DMatrix::zeros(self.basis.ncols(), count);
        let (mut normal, mut right) = (DMatrix::zeros(count, count), DVector::zeros(count));
        for (k, row) in rows.iter().enumerate() {
            let columns = &row.columns * (k as f64 / rows.len() as f64);
            along += row.basis.tr_mul(&columns);
            normal += columns.tr_mul(&columns);
            right += columns.tr_mul(&row.residuals);
        }
        let left = normal - along.tr_mul(&along);
        Cholesky::new(left).map_or(0.0, |c| right.dot(&c.solve(&right)))
    }

    /// Warning about the best of all changes, with the changes that explain the measurements as
    /// well. A motion of base, measuring system or target is more usual than another zero.
    fn message(&self, best: &Found, all: &[Found]) -> Message {
        let is_alike = |other: &&Found| 1.0 - other.share <= ALIKE * (1.0 - best.share);
        let alike: Vec<&Found> = all.iter().filter(is_alike).collect();
        let is_zero = |found: &Found| matches!(found.part, Part::Zero(_));
        let motions = alike.iter().copied().filter(|found| !is_zero(found));
        let named = motions.min_by(|a, b| a.chance.total_cmp(&b.chance)).unwrap_or(best);
        let others = alike.into_iter().filter(|other| is_zero(other) && other.part != named.part);
        // one target moves with the last joint whose axis it is not on
        let carrier = (is_zero(named) && self.robot.targets().len() == 1 && self.robot.free_base().is_some())
            .then(|| self.changed(Part::Target(0)))
            .flatten();
        let others = others.chain(carrier.iter().filter(is_alike));
        let others: Vec<Phrase> = others.map(|other| self.phrase(other.part)).collect();
        let (pose, previous) = (self.observations[named.at].pose, self.observations[named.at - 1].pose);
        let vector_mm = named.shift_mm.map(|v| (1e3 * v).round() / 1e3);
        let (shift_mm, expanded_mm) = (norm(named.shift_mm), 2.0 * named.u);
        let share_percent = 100.0 * named.share;
        let message = match named.part {
            Part::Zero(joint) => {
                let joint = &self.robot.joints()[joint];
                let [change, expanded] = [-named.change[0], 2.0 * named.u].map(|v| joint.quantity.outward(v));
                let (unit, joint) = (joint.quantity.unit(), &joint.name);
                warning!("joint-zero-shifted", joint, pose, previous, change, expanded, unit, share_percent)
            }
            Part::Target(k) => {
                let target = &self.robot.targets()[k];
                warning!("target-shifted", target, pose, previous, shift_mm, expanded_mm, vector_mm, share_percent)
            }
            _ => warning!("reference-moved", pose, previous, shift_mm, expanded_mm, vector_mm, share_percent),
        };
        let message = if others.is_empty() { message } else { message.within(phrase!("change-or-another", others)) };
        message.to_decide()
    }

    /// Name of a change.
    fn phrase(&self, part: Part) -> Phrase {
        match part {
            Part::Zero(joint) => phrase!("change-of-zero", joint = self.robot.joints()[joint].name),
            Part::Target(k) => phrase!("change-of-target", target = self.robot.targets()[k]),
            Part::Shifted | Part::Turned => phrase!("change-of-reference"),
        }
    }

    /// `true` if the change shows between poses before and after it that are neighbours in joint
    /// space: the misfit of the model is common to these.
    fn shows_between_neighbours(&self, found: &Found) -> bool {
        let n = self.observations.len();
        // share of the change in each observation: 0 before, 1 after
        let share = |k: usize| {
            let rows = self.rows(k, found.part);
            let expected = &rows.columns * &found.change;
            let seen = rows.residuals + rows.basis * &found.absorbed;
            Some(expected.dot(&seen) / expected.norm_squared()).filter(|share| share.is_finite())
        };
        let shares: Vec<Option<f64>> = (0..n).map(share).collect();
        let scatter: Vec<f64> = (0..self.observations[0].joints.len())
            .map(|j| standard_deviation(&self.observations.iter().map(|o| o.joints[j]).collect::<Vec<_>>()))
            .collect();
        let distance = |i: usize, k: usize| {
            let [a, b] = [i, k].map(|i| &self.observations[i].joints);
            let by = |(j, s): (usize, &f64)| if *s > 0.0 { ((a[j] - b[j]) / s).powi(2) } else { 0.0 };
            scatter.iter().enumerate().map(by).sum::<f64>()
        };
        let nearest = |k: usize, among: &mut dyn Iterator<Item = usize>| {
            let all = among.filter(|&i| self.observations[i].pose != self.observations[k].pose);
            all.filter(|&i| shares[i].is_some()).map(|i| (distance(i, k), i)).min_by(|a, b| a.0.total_cmp(&b.0))
        };
        let mut differences = Vec::new();
        for k in found.at..n {
            let (Some(after), Some((far, i))) = (shares[k], nearest(k, &mut (0..found.at))) else { continue };
            // a pose after the change that is nearer to one before it than to most of its own side
            if nearest(k, &mut (found.at..n)).is_some_and(|near| far.sqrt() <= NEIGHBOURS * near.0.sqrt()) {
                differences.extend(shares[i].map(|before| (i, after - before)));
            }
        }
        let partners: BTreeSet<usize> = differences.iter().map(|d| d.0).collect();
        let differences: Vec<f64> = differences.into_iter().map(|d| d.1).collect();
        let middle = median(differences.iter().copied()).unwrap_or(0.0);
        let error = standard_deviation(&differences) / (partners.len() as f64).sqrt();
        partners.len() >= FEWEST_ASIDE && middle >= BETWEEN_NEIGHBOURS && middle >= SEEN * error
    }
}

/// Standard deviation of each residual by the misfit of its quantity: coordinates, other lengths
/// and angles.
fn misfits(problem: &Residuals, residuals: &[f64]) -> Option<Vec<f64>> {
    let coordinates = problem.coordinate_count();
    let quantity =
        |(row, size): (usize, Option<f64>)| if row < coordinates { 0 } else { 1 + usize::from(size.is_none()) };
    let quantities: Vec<usize> = problem.sizes().enumerate().map(quantity).collect();
    let scale = |which: usize| {
        let sizes = quantities.iter().zip(residuals).filter(|(quantity, _)| **quantity == which);
        median(sizes.map(|(_, r)| r.abs())).map_or(1.0, |size| (crate::OF_MEDIAN * size).max(f64::MIN_POSITIVE))
    };
    let scales = [0, 1, 2].map(scale);
    let measured = quantities.iter().map(|&quantity| scales[quantity]);
    let stated = std::iter::repeat_n(scales[0], residuals.len() - quantities.len());
    Some(measured.chain(stated).collect()).filter(|_| coordinates > 0)
}

/// The Jacobian at `x`, with columns of the misfit that robots usually have, errors of each joint
/// that repeat with its turn, if the poses are enough for them: it is alike at poses that follow
/// each other.
pub(crate) fn jacobian_with_misfit(problem: &Residuals, x: &[f64]) -> DMatrix<f64> {
    let jacobian = problem.matrix_at(x);
    let joints = problem.robot.joints();
    let turning: Vec<usize> = (0..joints.len()).filter(|&j| joints[j].quantity == Quantity::Angle).collect();
    let harmonics: [fn(f64) -> f64; 4] = [f64::sin, f64::cos, |q| (2.0 * q).sin(), |q| (2.0 * q).cos()];
    let (count, first) = (turning.len() * harmonics.len(), jacobian.ncols());
    if turning.is_empty() || jacobian.nrows() < REDUNDANT * (first + count) {
        return jacobian;
    }
    let mut all = jacobian.resize_horizontally(first + count, 0.0);
    let by_joint = problem.joint_jacobian(x);
    let rows = problem.pose_rows().flat_map(|(_, q, rows)| std::iter::repeat_n(q, rows));
    for (row, (q, slopes)) in rows.zip(by_joint.chunks_exact(joints.len())).enumerate() {
        let errors = turning.iter().flat_map(|&j| harmonics.map(|harmonic| slopes[j] * harmonic(q[j])));
        errors.enumerate().for_each(|(k, error)| all[(row, first + k)] = error);
    }
    all
}

/// Rows of wrong readings: those far from the readings of their target before and after them, which
/// a change of the set-up shifts alike.
fn wrong_rows(observations: &[Observation], residuals: &[f64], dimension: usize) -> Option<Vec<usize>> {
    let mut of_target: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    let mut row = 0;
    for o in observations {
        for k in (0..o.targets.len()).filter(|&k| o.targets[k].is_some()) {
            of_target.entry(k).or_default().push(row);
            row += dimension;
        }
    }
    let mut off: Vec<(usize, f64)> = Vec::new();
    for rows in of_target.values() {
        for (i, &row) in rows.iter().enumerate() {
            let near = &rows[i.saturating_sub(ASIDE)..(i + ASIDE + 1).min(rows.len())];
            for axis in 0..dimension {
                let usual = median(near.iter().map(|&other| residuals[other + axis]))?;
                off.push((row + axis, (residuals[row + axis] - usual).abs()));
            }
        }
    }
    let limit = GROSS * crate::OF_MEDIAN * median(off.iter().map(|off| off.1))?;
    Some(off.into_iter().filter(|off| off.1 > limit).map(|off| off.0).collect())
}
