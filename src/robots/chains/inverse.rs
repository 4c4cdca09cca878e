//! Inverse kinematics of arms: damped Newton steps from the start, and a search from many starts.
//!
//! The steps follow Levenberg and Marquardt, damped in proportion to the squared error: they
//! converge quadratically to isolated solutions and to families of solutions alike (Yamashita &
//! Fukushima 2001; for inverse kinematics: Sugihara 2011). Errors and steps are dimensionless: 1
//! rad, or 1 m.

use crate::Robot;
use crate::chain::TURNED_MM;
use crate::serial::{JointScale, Serial, WithParameters};
use etalon_base::catalogue::Phrase;
use etalon_base::noise::Noise;
use etalon_base::phrase;
use etalon_base::pose::{Pose, minus, norm};
use etalon_math::{Factor, svd};
use nalgebra::{DMatrix, DVector};

/// Maximum error of an attained pose: 1e-9 mm and 1e-12 rad.
const ATTAINED: f64 = 1e-12;
/// Error, and step (rad or m), that rounding leaves.
const ROUNDING: f64 = 1e-15;
/// Error of a pose (1e-6 mm, 1e-9 rad) that is not worth a motion longer than [`LONG`].
const RESOLUTION: f64 = 1e-9;
/// Motion (rad or m) that a singular pose asks for to remove an error below [`RESOLUTION`].
const LONG: f64 = 1e-3;
/// Maximum number of steps from a start.
const STEPS: usize = 80;
/// Longest step of a joint (rad or m).
const LONGEST: f64 = 0.7;
/// Damping at the start, in squared errors.
const DAMPING: f64 = 0.05;
/// Minimum damping, which keeps the steps of redundant arms finite.
const LEAST_DAMPING: f64 = 1e-13;
/// Number of steps with little progress that end a search.
const STALLED: usize = 8;

/// Number of starts without a new solution that end the search for all solutions.
const WITHOUT_NEW: usize = 120;
/// Maximum number of starts.
const MOST_STARTS: usize = 1024;
/// Number of solutions among which the nearest of a redundant arm is chosen.
const CHOICE: usize = 12;
const SEARCH_SEED: u64 = 19;
/// Distance from the start within which a solution may be the nearest without a search (rad or m).
const NEAR: f64 = 0.5;
/// Minimum singular value of the Jacobian, per distance from the start, for which no other
/// solution is as near: the second derivatives of an arm of some metres are below it.
const ALONE: f64 = 4.0;
/// Number of starts about the start where several solutions may be near.
const AROUND: usize = 6;

/// Maximum difference between joint values of the same solution (rad or m).
const SAME: f64 = 1e-6;
/// Singular values below this share of the largest are zero.
const DEPENDENT: f64 = 1e-9;
/// Motions that move the flange by less than this share may be left to the resolution.
const FAINT: f64 = 1e-7;
/// Step along a family of solutions (rad or m).
const ALONG: f64 = 0.1;
/// Maximum number of steps along a valley from the start to either side.
const MOST_AROUND: usize = 8;
/// Maximum number of steps along a family.
const MOST_ALONG: usize = 400;
/// Motion along a family (rad or m) below which the nearest member is found.
const SETTLED: f64 = 1e-8;
/// Error, and share of the singular values, below which a nearly singular arm may be in a valley.
const SHALLOW: f64 = 1e-2;
/// Distance from a member of a traced family within which a solution belongs to the family.
const MEMBER: f64 = 0.08;

/// Search for the joint values of a pose.
pub(crate) struct Search<'a> {
    serial: &'a Serial,
    parameters: &'a [f64],
    arm: WithParameters<'a>,
    /// Pose of the flange in the world.
    place: Pose,
    joints: Vec<JointScale>,
}

/// Error of a pose at joint values, and its derivatives (row by row).
struct Linearised {
    error: [f64; 6],
    jacobian: Vec<f64>,
    /// Norm of the error.
    size: f64,
}

/// Range of the joints on the way to a pose.
#[derive(Clone, Copy, PartialEq)]
enum Travel {
    /// Inside the limits of the joints.
    Limited,
    /// Beyond the limits too.
    Free,
}

/// End of the steps from a start.
struct Attempt {
    joints: Vec<f64>,
    is_attained: bool,
    /// Norm of the error.
    size: f64,
}

/// Point of a curve along the direction in which a nearly singular arm hardly moves its flange;
/// only the error in the direction that the arm hardly reaches is left.
struct Valley {
    joints: Vec<f64>,
    /// Direction of the curve (rad or m).
    along: DVector<f64>,
    /// Direction of the error that is left, and the error.
    across: DVector<f64>,
    left: f64,
}

/// All solutions of a pose, one of each family, and the number of starts of the search.
pub(crate) struct Solutions {
    pub joints: Vec<Vec<f64>>,
    pub starts: usize,
}

impl<'a> Search<'a> {
    pub fn new(serial: &'a Serial, parameters: &'a [f64], place: Pose) -> Self {
        let joints = serial.joint_scales(parameters);
        Self { serial, parameters, arm: serial.with(parameters), place, joints }
    }

    /// Unit of a joint value: motion by 1 rad or 1 m. Values behind the joints do not move.
    fn unit(&self, joint: usize) -> f64 {
        self.joints.get(joint).map_or(1.0, |joint| joint.unit)
    }

    /// `q` + `share` · `step`, inside the limits if `travel` is limited.
    fn moved(&self, q: &[f64], step: &[f64], share: f64, travel: Travel) -> Vec<f64> {
        let mut next: Vec<f64> =
            q.iter().zip(step).enumerate().map(|(j, (q, step))| q + share * step * self.unit(j)).collect();
        if travel == Travel::Limited {
            self.clamp(&mut next);
        }
        next
    }

    fn clamp(&self, q: &mut [f64]) {
        for (q, joint) in q.iter_mut().zip(&self.joints) {
            if let Some([lower, upper]) = joint.limits {
                *q = q.clamp(lower, upper);
            }
        }
    }

    fn linearise(&self, q: &[f64]) -> Linearised {
        let (reached, mut jacobian) = self.arm.flange_jacobian(q);
        for row in jacobian.chunks_exact_mut(q.len()) {
            row.iter_mut().enumerate().for_each(|(j, v)| *v *= self.unit(j) / TURNED_MM);
        }
        let gap = minus(self.place.translation_mm, reached.translation_mm).map(|v| v / TURNED_MM);
        let turn = self.place.then(&reached.inverse()).rotation_vector_rad();
        let error = [gap[0], gap[1], gap[2], turn[0], turn[1], turn[2]];
        let size = error.iter().map(|v| v * v).sum::<f64>().sqrt();
        Linearised { error, jacobian, size }
    }

    /// Damped step (rad or m); joints at a limit that block the way stand still if `travel` is
    /// limited.
    fn step(&self, q: &[f64], at: &Linearised, damping: f64, travel: Travel) -> Option<Vec<f64>> {
        let n = q.len();
        let mut a = at.jacobian.clone();
        if travel == Travel::Limited {
            for (j, joint) in self.joints.iter().enumerate() {
                let Some([lower, upper]) = joint.limits else { continue };
                let towards: f64 = (0..6).map(|i| a[i * n + j] * at.error[i]).sum::<f64>() * joint.unit;
                if (q[j] <= lower && towards < 0.0) || (q[j] >= upper && towards > 0.0) {
                    (0..6).for_each(|i| a[i * n + j] = 0.0);
                }
            }
        }
        let damping = (damping.sqrt() * at.size).max(LEAST_DAMPING);
        a.resize((6 + n) * n, 0.0);
        (0..n).for_each(|j| a[(6 + j) * n + j] = damping);
        let mut right = vec![0.0; 6 + n];
        right[..6].copy_from_slice(&at.error);
        Factor::new(&a, &right, &vec![1.0; n]).solve()
    }

    /// Follows damped steps from a start, inside the limits if `travel` is limited. An error below
    /// `tolerance` is left if only a long motion removes it.
    fn attempt(&self, start: &[f64], travel: Travel, tolerance: f64) -> Attempt {
        let mut q = start.to_vec();
        if travel == Travel::Limited {
            self.clamp(&mut q);
        }
        let (mut at, mut damping, mut stalled) = (self.linearise(&q), DAMPING, 0);
        let mut is_attained = false;
        for _ in 0..STEPS {
            let Some(step) = self.step(&q, &at, damping, travel).filter(|_| at.size.is_finite()) else { break };
            let longest = step.iter().fold(0.0f64, |most, s| most.max(s.abs()));
            let long = longest > LONG && at.size <= tolerance;
            if long || (at.size <= ATTAINED && longest <= ROUNDING) {
                is_attained = true;
                break;
            }
            let next = self.moved(&q, &step, (LONGEST / longest).min(1.0), travel);
            let there = self.linearise(&next);
            if there.size < at.size {
                stalled = if there.size > 0.95 * at.size { stalled + 1 } else { 0 };
                (q, at, damping) = (next, there, (0.25 * damping).max(1e-6));
            } else {
                damping *= 8.0;
                stalled += 1;
            }
            if stalled > STALLED || (stalled > 0 && at.size <= ATTAINED) {
                break;
            }
        }
        Attempt { joints: q, is_attained: is_attained || at.size <= ATTAINED, size: at.size }
    }

    /// Joint values that attain the pose on the branch of the start.
    pub fn solve(&self, start: &[f64]) -> Option<Vec<f64>> {
        self.attained(start, Travel::Free, ATTAINED)
    }

    fn attained(&self, start: &[f64], travel: Travel, tolerance: f64) -> Option<Vec<f64>> {
        let Attempt { joints, is_attained, .. } = self.attempt(start, travel, tolerance);
        is_attained.then_some(joints)
    }

    /// `true` if joint values attain the pose to rounding, or if the remaining error is below the
    /// resolution and only a long motion could remove it.
    fn is_attained(&self, q: &[f64]) -> bool {
        let at = self.linearise(q);
        let long = || self.step(q, &at, DAMPING, Travel::Free).is_none_or(|step| step.iter().any(|s| s.abs() > LONG));
        at.size <= ROUNDING || (at.size <= RESOLUTION && long())
    }

    fn is_within(&self, q: &[f64]) -> bool {
        self.serial.limit_violation(self.parameters, q).is_none()
    }

    /// Distance of joint values (rad or m); joints without limits take the shorter way round.
    fn distance(&self, a: &[f64], b: &[f64]) -> f64 {
        let apart = |(joint, (a, b)): (&JointScale, (&f64, &f64))| {
            let apart = match (joint.limits, joint.turn) {
                (None, Some(turn)) => (a - b) - ((a - b) / turn).round() * turn,
                _ => a - b,
            };
            (apart / joint.unit).powi(2)
        };
        self.joints.iter().zip(a.iter().zip(b)).map(apart).sum::<f64>().sqrt()
    }

    /// Largest difference of joint values (rad or m), independent of their full turns.
    fn largest_difference(&self, a: &[f64], b: &[f64]) -> f64 {
        let apart = |(joint, (a, b)): (&JointScale, (&f64, &f64))| {
            let apart = joint.turn.map_or(a - b, |turn| (a - b) - ((a - b) / turn).round() * turn);
            (apart / joint.unit).abs()
        };
        self.joints.iter().zip(a.iter().zip(b)).map(apart).fold(0.0, f64::max)
    }

    /// Shifts each revolute joint by full turns: into its limits, nearest to `near`; without limits
    /// to within half a turn of zero, or of a start beyond. Returns `None` if joint values that are
    /// not motions of single axes (coupling, harmonics) leave no solution.
    fn represent(&self, q: Vec<f64>, near: &[f64]) -> Option<Vec<f64>> {
        let mut turned = q.clone();
        for ((v, near), joint) in turned.iter_mut().zip(near).zip(&self.joints) {
            let Some(turn) = joint.turn else { continue };
            let nearest = *v - ((*v - near) / turn).round() * turn;
            let [lower, upper] = joint.limits.unwrap_or([-0.5 * turn, 0.5 * turn]);
            let slack = 1e-9 * joint.unit.abs();
            let inside = |v: &f64| (lower - slack..=upper + slack).contains(v);
            let beyond = joint.limits.is_none() && !inside(near);
            let all = [nearest, nearest - turn, nearest + turn];
            let best = all.into_iter().filter(inside).min_by(|a, b| (a - near).abs().total_cmp(&(b - near).abs()));
            *v = if beyond { nearest } else { best.unwrap_or(nearest) };
        }
        if turned == q || self.linearise(&turned).size <= ATTAINED { Some(turned) } else { self.solve(&turned) }
    }

    /// Singular values of the Jacobian and its right singular vectors, the largest first.
    fn decompose(&self, q: &[f64]) -> (DVector<f64>, Vec<DVector<f64>>) {
        decomposed(&self.linearise(q).jacobian, q.len())
    }

    /// Lower bound of the smallest singular value of the Jacobian, at least 1/√6 of it.
    fn least_value(&self, q: &[f64]) -> f64 {
        let (a, n) = (self.linearise(q).jacobian, q.len());
        let (a, m, n) = if n <= 6 {
            (a, 6, n)
        } else {
            ((0..n).flat_map(|j| (0..6).map(move |i| (i, j))).map(|(i, j)| a[i * n + j]).collect(), n, 6)
        };
        let inverse = Factor::new(&a, &vec![0.0; m], &vec![1.0; n]).inverse_normal();
        let trace = inverse.map(|inverse| (0..n).map(|i| inverse[i * n + i]).sum::<f64>());
        trace.filter(|trace| trace.is_finite()).map_or(0.0, |trace| 1.0 / trace.sqrt())
    }

    /// Part of a motion that does not move the flange.
    fn still(&self, q: &[f64], motion: &[f64]) -> DVector<f64> {
        let (values, rows) = self.decompose(q);
        let mut still = DVector::from_column_slice(motion);
        let moving = values.iter().zip(&rows).filter(|(value, _)| **value > FAINT * values[0]);
        moving.for_each(|(_, row)| still -= row * row.dot(&still));
        still
    }

    /// Moves a solution along its family, or along the freedom of a redundant arm, to the member
    /// nearest to `near`.
    fn slide(&self, mut q: Vec<f64>, near: &[f64], travel: Travel) -> Vec<f64> {
        for _ in 0..40 {
            let way: Vec<f64> =
                near.iter().zip(&q).enumerate().map(|(j, (near, q))| (near - q) / self.unit(j)).collect();
            let still = self.still(&q, &way);
            let length = still.amax();
            let before = self.distance(&q, near);
            let shorter = |half: i32| {
                let share = (3.0 * ALONG / length).min(1.0) * 0.5f64.powi(half);
                let next = self.attained(&self.moved(&q, still.as_slice(), share, travel), travel, RESOLUTION)?;
                (self.distance(&next, near) < before).then_some(next)
            };
            match (0..6).filter(|_| length > SETTLED).find_map(shorter) {
                Some(next) => q = next,
                None => break,
            }
        }
        q
    }

    /// Directions along which a solution belongs to a family, as motions of the joints.
    fn family(&self, q: &[f64]) -> Vec<DVector<f64>> {
        let (values, rows) = self.decompose(q);
        let leads = |row: &DVector<f64>| {
            [0.5 * ALONG, -0.5 * ALONG].iter().any(|&by| {
                let there = self.attained(&self.moved(q, row.as_slice(), by, Travel::Free), Travel::Free, RESOLUTION);
                let moved = |there: Vec<f64>| {
                    there.iter().zip(q).enumerate().map(|(j, (a, b))| (a - b) / self.unit(j) * row[j]).sum::<f64>()
                };
                there.is_some_and(|there| moved(there) * by.signum() > 0.25 * ALONG)
            })
        };
        let most = values.max();
        let zero = values.iter().zip(rows).filter(|(value, _)| **value <= DEPENDENT * most);
        zero.map(|(_, row)| row).filter(leads).collect()
    }

    /// Joints that move along the family of a solution; empty if the solution is isolated.
    pub fn free_joints(&self, q: &[f64]) -> Vec<usize> {
        if self.joints.len() > 6 {
            return (0..self.joints.len()).collect();
        }
        let along = self.family(q);
        (0..self.joints.len()).filter(|&j| along.iter().any(|row| row[j].abs() > SAME)).collect()
    }

    /// Members of a family from a member on, in steps of [`ALONG`].
    fn trace(&self, q: &[f64], along: &DVector<f64>) -> Vec<Vec<f64>> {
        let mut all = vec![q.to_vec()];
        for sign in [1.0, -1.0] {
            let (mut at, mut direction) = (q.to_vec(), along * sign);
            for k in 0..MOST_ALONG {
                let next = self.moved(&at, direction.as_slice(), ALONG, Travel::Free);
                let Some(next) = self.attained(&next, Travel::Free, RESOLUTION) else { break };
                let still = self.still(&next, direction.as_slice());
                if self.distance(&next, &at) < 0.25 * ALONG || still.norm() < 0.1 {
                    break;
                }
                if k > 1 && self.largest_difference(&next, q) < MEMBER {
                    return all;
                }
                (at, direction) = (next, &still / still.norm());
                all.push(at.clone());
            }
        }
        all
    }

    /// Draws a start inside the limits.
    fn draw(&self, noise: &mut Noise, near: &[f64]) -> Vec<f64> {
        let mut q = near.to_vec();
        for (q, joint) in q.iter_mut().zip(&self.joints) {
            let [lower, upper] = match (joint.limits, joint.turn) {
                (Some(limits), None) => limits,
                (Some([lower, upper]), Some(turn)) if upper - lower < turn => [lower, upper],
                (_, Some(turn)) => [-0.5 * turn, 0.5 * turn],
                (None, None) => [*q - joint.unit, *q + joint.unit],
            };
            *q = 0.5 * (lower + upper) + noise.uniform(0.5 * (upper - lower));
        }
        q
    }

    /// Nearest permissible of some joint values, or the first if none is permissible.
    fn nearest_permissible(&self, all: impl IntoIterator<Item = Vec<f64>>, near: &[f64]) -> Option<Vec<f64>> {
        let key = |q: &Vec<f64>| (!self.is_within(q), self.distance(q, near));
        all.into_iter()
            .map(|q| (key(&q), q))
            .min_by(|a, b| a.0.0.cmp(&b.0.0).then(a.0.1.total_cmp(&b.0.1)))
            .map(|b| b.1)
    }

    /// All solutions of an arm of at most six joints; of each family the member nearest to `near`.
    pub fn all(&self, near: &[f64]) -> Solutions {
        let (mut all, mut families, mut noise) = (Vec::<Vec<f64>>::new(), Vec::new(), Noise::new(SEARCH_SEED, 0));
        let (mut starts, mut without_new, mut valleys) = (0, 0, Vec::new());
        while starts < MOST_STARTS && without_new < WITHOUT_NEW {
            let start = if starts == 0 { near.to_vec() } else { self.draw(&mut noise, near) };
            (starts, without_new) = (starts + 1, without_new + 1);
            let ended = self.attempt(&start, Travel::Free, ATTAINED);
            let in_valley = !ended.is_attained && ended.size < SHALLOW;
            let mut found = if in_valley { self.in_new_valley(&ended.joints, &mut valleys) } else { Vec::new() };
            found.extend(ended.is_attained.then_some(ended.joints));
            while let Some(q) = found.pop() {
                let Some(q) = self.represent(q, near) else { continue };
                let Some(new) = self.new_solution(q, near, &all, &mut families) else { continue };
                // another solution may be near along the direction that the arm hardly moves
                let (values, _) = self.decompose(&new);
                if values.min() > DEPENDENT * values.max() {
                    found.extend(self.in_new_valley(&new, &mut valleys));
                }
                all.push(new);
                without_new = 0;
            }
        }
        all.sort_by(|a, b| a.partial_cmp(b).unwrap_or(std::cmp::Ordering::Equal));
        Solutions { joints: all, starts }
    }

    /// Solutions in the valley near joint values, if the valley is not among the known ones.
    fn in_new_valley(&self, q: &[f64], valleys: &mut Vec<Vec<Vec<f64>>>) -> Vec<Vec<f64>> {
        let known = |members: &Vec<Vec<f64>>| members.iter().any(|member| self.largest_difference(member, q) <= MEMBER);
        match (!valleys.iter().any(known)).then(|| self.valley(q, None)).flatten() {
            Some(bottom) => {
                let (found, members) = self.search_valley(&bottom, MOST_ALONG);
                valleys.push(members);
                found
            }
            None => Vec::new(),
        }
    }

    /// Bottom of the valley near joint values; `None` if the arm is not nearly singular there.
    fn valley(&self, q: &[f64], before: Option<&Valley>) -> Option<Valley> {
        let mut q = q.to_vec();
        for _ in 0..8 {
            let at = self.linearise(&q);
            let error = DVector::from_column_slice(&at.error);
            let (values, v) = decomposed(&at.jacobian, q.len());
            let last = values.len() - 1;
            if values[last] > SHALLOW * values[0] {
                return None;
            }
            let jacobian = DMatrix::from_row_slice(6, q.len(), &at.jacobian);
            let mut step = DVector::zeros(q.len());
            for (value, v) in values.iter().zip(&v).take(last) {
                step += v * ((&jacobian * v).dot(&error) / value.powi(2));
            }
            if step.amax() < SETTLED || (step.amax() < SAME && at.size < RESOLUTION) {
                let sign = |new: &DVector<f64>, old: Option<&DVector<f64>>| {
                    if old.is_some_and(|old| old.dot(new) < 0.0) { -1.0 } else { 1.0 }
                };
                // where its value is zero, the last left vector does not follow from the right one
                let (_, mut u) = decomposed(jacobian.as_slice(), 6);
                let (along, across) = (v[last].clone(), u.swap_remove(last));
                let along = &along * sign(&along, before.map(|b| &b.along));
                let across = &across * sign(&across, before.map(|b| &b.across));
                return Some(Valley { joints: q, left: across.dot(&error), along, across });
            }
            q = self.moved(&q, step.as_slice(), (LONGEST / step.amax()).min(1.0), Travel::Free);
        }
        None
    }

    /// Follows a valley from a point in both directions, `most` steps each at most. Returns the
    /// solutions in it, where the error that is left changes its sign, and the points.
    fn search_valley(&self, bottom: &Valley, most: usize) -> (Vec<Vec<f64>>, Vec<Vec<f64>>) {
        let (mut found, mut members) = (Vec::new(), vec![bottom.joints.clone()]);
        for sign in [1.0, -1.0] {
            let along = &bottom.along * sign;
            let mut at = Valley { along, joints: bottom.joints.clone(), across: bottom.across.clone(), ..*bottom };
            for k in 0..most {
                let next = self.moved(&at.joints, at.along.as_slice(), ALONG, Travel::Free);
                let Some(next) = self.valley(&next, Some(&at)) else { break };
                if self.largest_difference(&next.joints, &at.joints) < 0.25 * ALONG {
                    break;
                }
                if at.left * next.left <= 0.0 {
                    found.extend(self.between(&at, &next));
                }
                if k > 1 && self.largest_difference(&next.joints, &bottom.joints) < MEMBER {
                    return (found, members);
                }
                members.push(next.joints.clone());
                at = next;
            }
        }
        (found, members)
    }

    /// Solution between two points of a valley with errors of opposite signs (regula falsi, with
    /// halved errors of a point that stays: Dowell & Jarratt 1971).
    fn between(&self, a: &Valley, b: &Valley) -> Option<Vec<f64>> {
        let (mut q, mut ends) = ([a.joints.clone(), b.joints.clone()], [a.left, b.left]);
        let mut last = 2;
        for _ in 0..60 {
            let share = if ends[0] == ends[1] { 0.5 } else { ends[0] / (ends[0] - ends[1]) };
            let start: Vec<f64> = q[0].iter().zip(&q[1]).map(|(a, b)| a + share * (b - a)).collect();
            let middle = self.valley(&start, Some(a))?;
            if middle.left.abs() < 0.1 * ATTAINED || self.largest_difference(&q[0], &q[1]) < SETTLED {
                return self.attained(&middle.joints, Travel::Free, RESOLUTION);
            }
            let side = usize::from(middle.left * ends[0] < 0.0);
            ends[side] = middle.left;
            q[side] = middle.joints;
            if last == side {
                ends[1 - side] *= 0.5;
            }
            last = side;
        }
        None
    }

    /// Returns a solution that is not among the known ones, or the nearest member of its family.
    fn new_solution(
        &self,
        found: Vec<f64>,
        near: &[f64],
        known: &[Vec<f64>],
        families: &mut Vec<Vec<Vec<f64>>>,
    ) -> Option<Vec<f64>> {
        let is_among =
            |all: &[Vec<f64>], tolerance: f64| all.iter().any(|q| self.largest_difference(&found, q) <= tolerance);
        if is_among(known, SAME) || families.iter().any(|members| is_among(members, MEMBER)) {
            return None;
        }
        // near a singularity the pose determines the joint values less well
        let (values, _) = self.decompose(&found);
        if is_among(known, (0.2 * ATTAINED / values.min()).clamp(SAME, MEMBER)) {
            return None;
        }
        let Some(along) = self.family(&found).into_iter().next() else { return Some(found) };
        let members = self.trace(&found, &along);
        let shown = members.iter().filter_map(|member| self.represent(member.clone(), near));
        let nearest = self.nearest_permissible(shown, near);
        families.push(members);
        nearest.map(|member| self.slide_within(member, near))
    }

    /// Slides a solution to the nearest member of its family, inside the limits if possible.
    fn slide_within(&self, q: Vec<f64>, near: &[f64]) -> Vec<f64> {
        let travel = if self.is_within(&q) { Travel::Limited } else { Travel::Free };
        self.slide(q, near, travel)
    }

    /// Permissible solution nearest to `near`.
    pub fn nearest(&self, near: &[f64]) -> Result<Vec<f64>, Phrase> {
        if self.is_within(near) && self.is_attained(near) {
            return Ok(near.to_vec());
        }
        let close = self.closest(near, near);
        if let Some(q) = close.iter().find(|q| self.is_within(q) && self.distance(q, near) < NEAR) {
            let alone = self.least_value(q) > ALONE * self.distance(q, near);
            return Ok(if alone { q.clone() } else { self.nearest_around(q.clone(), near) });
        }
        let Solutions { joints, starts } = match self.joints.len() {
            ..=6 => self.all(near),
            _ => self.redundant(near),
        };
        let best = self.nearest_permissible(joints.into_iter().chain(close), near);
        let Some(best) = best else { return Err(self.unreached(starts)) };
        match self.serial.limit_violation(self.parameters, &best) {
            None => Ok(best),
            Some(_) if self.joints.len() > 6 => Err(self.unreached(starts)),
            Some(why) => Err(why),
        }
    }

    /// Solutions on the branch of a start, or in the valley near it; of families the nearest
    /// members. The nearest comes first.
    fn closest(&self, start: &[f64], near: &[f64]) -> Vec<Vec<f64>> {
        let redundant = self.joints.len() > 6;
        let travel = if redundant { Travel::Limited } else { Travel::Free };
        let slid = |q: Vec<f64>| {
            let free = redundant || self.least_value(&q) <= FAINT;
            if free { self.slide(q, near, travel) } else { q }
        };
        let ended = self.attempt(start, travel, RESOLUTION);
        let found = ended.is_attained.then(|| self.represent(ended.joints, near)).flatten().map(slid);
        let found: Vec<Vec<f64>> = found.into_iter().collect();
        if redundant || found.iter().any(|q| self.distance(q, near) < NEAR) {
            return found;
        }
        let valley = self.valley(near, None).map(|bottom| self.search_valley(&bottom, MOST_AROUND).0);
        let valley = valley.into_iter().flatten().filter_map(|q| self.represent(q, near));
        let mut all: Vec<Vec<f64>> = found.into_iter().chain(valley).collect();
        all.sort_by(|a, b| self.distance(a, near).total_cmp(&self.distance(b, near)));
        all
    }

    /// Nearest solution to a start that is near `found`, where others may be as near.
    fn nearest_around(&self, found: Vec<f64>, near: &[f64]) -> Vec<f64> {
        let (mut noise, mut best) = (Noise::new(SEARCH_SEED, 1), found);
        for k in 0..AROUND {
            let distance = self.distance(&best, near);
            let radius = distance * [0.25, 1.0][k % 2];
            let step: Vec<f64> = near.iter().map(|_| noise.uniform(radius)).collect();
            let start = match k {
                // the mirror image of the solution about the start
                0 => near.iter().zip(&best).map(|(near, q)| 2.0 * near - q).collect(),
                _ => self.moved(near, &step, 1.0, Travel::Free),
            };
            let others = self.closest(&start, near).into_iter().filter(|q| self.is_within(q));
            if let Some(other) = self.nearest_permissible(others, near).filter(|q| self.distance(q, near) < distance) {
                best = other;
            }
        }
        best
    }

    /// Solutions of a redundant arm inside its limits, from starts at growing distances.
    fn redundant(&self, near: &[f64]) -> Solutions {
        let (mut all, mut noise, mut starts) = (Vec::new(), Noise::new(SEARCH_SEED, 2), 0);
        while starts < MOST_STARTS && all.len() < CHOICE {
            starts += 1;
            let share = (starts as f64 / CHOICE as f64).min(1.0);
            let drawn = self.draw(&mut noise, near);
            let start: Vec<f64> = near.iter().zip(&drawn).map(|(near, q)| near + share * (q - near)).collect();
            all.extend(self.closest(&start, near).into_iter().filter(|q| self.is_within(q)));
        }
        Solutions { joints: all, starts }
    }

    /// Reason for a pose without solution: beyond the workspace, or not found.
    fn unreached(&self, starts: usize) -> Phrase {
        let (from, reach_mm) = self.serial.extent(self.parameters);
        let away_mm = norm(minus(self.place.translation_mm, from));
        match reach_mm.filter(|reach| away_mm > *reach) {
            Some(reach_mm) => phrase!("out-of-reach-by", away_mm, reach_mm),
            None => phrase!("no-solution-found", starts),
        }
    }

    /// Permissible solutions, or the reason why none exists.
    pub fn solutions(&self, near: &[f64]) -> Result<Vec<Vec<f64>>, Phrase> {
        let Solutions { joints, starts } = self.all(near);
        let forbidden = joints.iter().find_map(|q| self.serial.limit_violation(self.parameters, q));
        let within: Vec<Vec<f64>> = joints.into_iter().filter(|q| self.is_within(q)).collect();
        if within.is_empty() { Err(forbidden.unwrap_or_else(|| self.unreached(starts))) } else { Ok(within) }
    }
}

/// Singular values, at most six, of a matrix with `n` columns and its right singular vectors, the
/// largest first.
fn decomposed(rows: &[f64], n: usize) -> (DVector<f64>, Vec<DVector<f64>>) {
    let m = rows.len() / n;
    let mut square = rows.to_vec();
    square.resize(m.max(n) * n, 0.0);
    let svd = svd(&Factor::new(&square, &vec![0.0; m.max(n)], &vec![1.0; n]));
    let vectors = svd.vectors.into_iter().map(DVector::from_vec).take(6).collect();
    (DVector::from_iterator(n.min(6), svd.values.into_iter().take(6)), vectors)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{AxisLine, Kinematics, PUBLISHED, SerialJoint, TableConvention};
    use std::f64::consts::PI;

    fn table(convention: TableConvention, rows: &[[f64; 4]], limits: Option<f64>) -> Serial {
        let joint = |&[alpha, a_mm, theta, d_mm]: &[f64; 4]| SerialJoint {
            alpha_rad: f64::to_radians(alpha),
            a_mm,
            theta_rad: f64::to_radians(theta),
            d_mm,
            prismatic: false,
            parallel: false,
        };
        let joints: Vec<SerialJoint> = rows.iter().map(joint).collect();
        let arm = Serial::from_axis_table(convention, &joints, &["tool".to_owned()]);
        arm.with_limits(vec![limits.map(|limit| [-limit, limit]); rows.len()])
    }

    fn published(name: &str, limits: Option<f64>) -> Serial {
        let arm = PUBLISHED.iter().find(|arm| arm.name == name).unwrap();
        table(arm.convention, arm.rows, limits)
    }

    fn ur5e(limits: Option<f64>) -> Serial {
        published("ur5e", limits)
    }

    fn panda() -> Serial {
        let limits = [
            [-2.8973, 2.8973],
            [-1.7628, 1.7628],
            [-2.8973, 2.8973],
            [-3.0718, -0.0698],
            [-2.8973, 2.8973],
            [-0.0175, 3.7525],
            [-2.8973, 2.8973],
        ];
        published("panda", None).with_limits(limits.map(Some).to_vec())
    }

    fn irb120() -> Serial {
        let line = |direction, point_mm| AxisLine { direction, point_mm, prismatic: false };
        let axes = [
            line([0.0, 0.0, 1.0], [0.0, 0.0, 0.0]),
            line([0.0, 1.0, 0.0], [0.0, 0.0, 290.0]),
            line([0.0, 1.0, 0.0], [0.0, 0.0, 560.0]),
            line([1.0, 0.0, 0.0], [302.0, 0.0, 630.0]),
            line([0.0, 1.0, 0.0], [302.0, 0.0, 630.0]),
            line([1.0, 0.0, 0.0], [374.0, 0.0, 630.0]),
        ];
        let home = Pose { translation_mm: [374.0, 0.0, 630.0], ..Pose::identity() };
        let limits = [165.0, 110.0, 110.0, 160.0, 120.0, 400.0].map(|l: f64| Some([-l.to_radians(), l.to_radians()]));
        Serial::from_axes(&axes, &home, &["tool".to_owned()]).with_limits(limits.to_vec())
    }

    /// Distance of joint values.
    fn joint_distance(a: &[f64], b: &[f64]) -> f64 {
        a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
    }

    /// Joint values `q` with joint `joint` where the Jacobian is singular, if it is there.
    fn singular(search: &Search, mut q: Vec<f64>, joint: usize) -> Option<Vec<f64>> {
        let mut determinant = |value: f64| {
            q[joint] = value;
            DMatrix::from_row_slice(6, 6, &search.linearise(&q).jacobian).determinant()
        };
        let grid: Vec<f64> = (0..60).map(|k| -2.0 + f64::from(k) / 15.0).collect();
        let pair = grid.windows(2).find(|pair| determinant(pair[0]) * determinant(pair[1]) < 0.0)?;
        let (mut low, mut high) = (pair[0], pair[1]);
        for _ in 0..80 {
            let middle = 0.5 * (low + high);
            if determinant(low) * determinant(middle) <= 0.0 { high = middle } else { low = middle }
        }
        q[joint] = low;
        Some(q)
    }

    /// Shoulder, elbow and wrist singularities, and poses near them: the nearest solution reaches
    /// the pose, no farther from the start than the joint values that the pose is made from.
    #[test]
    fn solutions_near_singular_poses_are_the_nearest() {
        for arm in [ur5e(Some(2.0 * PI)), irb120()] {
            let (p, mut noise) = (arm.nominal(), Noise::new(5, 6));
            for (k, off) in [0.0, 1e-12, 1e-10, 1e-8, 1e-6, 1e-4, 1e-3].into_iter().enumerate() {
                for joint in [1, 2, 4] {
                    let drawn = (0..6).map(|_| noise.uniform(1.5)).collect();
                    let search = arm.search(&p, &Pose::identity());
                    let Some(mut q) = singular(&search, drawn, joint) else { continue };
                    q[joint] += off;
                    let search = arm.search(&p, &arm.tool_pose(&p, &q).unwrap());
                    let size = [1e-3, 0.02][k % 2];
                    let near: Vec<f64> = q.iter().map(|q| q + noise.uniform(size)).collect();
                    if !search.is_within(&q) || !search.is_within(&near) {
                        continue;
                    }
                    let found = search.nearest(&near).unwrap();
                    assert!(search.linearise(&found).size <= RESOLUTION);
                    assert!(
                        joint_distance(&found, &near) <= joint_distance(&q, &near) + 1e-6,
                        "{joint} {off}: {q:?} {near:?} {found:?}"
                    );
                    assert_eq!(search.nearest(&q).unwrap(), q);
                }
            }
        }
    }

    /// With q5 = 0 the axes of joints 4 and 6 coincide: there are only a few solutions, and the
    /// solution of the pose is a family in which both joints are free.
    #[test]
    fn a_wrist_singularity_is_one_family() {
        let arm = irb120();
        let p = arm.nominal();
        let q = [0.3, -0.2, 0.4, 0.7, 0.0, -1.1];
        let search = arm.search(&p, &arm.tool_pose(&p, &q).unwrap());
        let all = search.all(&[0.0; 6]).joints;
        let families: Vec<_> = all.iter().filter(|q| search.free_joints(q) == [3, 5]).collect();
        assert!(families.len() == 1 && all.len() == 7, "{all:?}");
        // the member nearest to zero: q4 + q6 is the sum at the pose
        let [a, b] = [families[0][3], families[0][5]];
        assert!((a + b - (0.7 - 1.1)).abs() < 1e-9 && (a - b).abs() < 1e-6, "{families:?}");
    }

    #[test]
    fn all_poses_within_the_limits_of_a_redundant_arm_are_solved() {
        let arm = panda();
        let (p, mut noise, mut last) = (arm.nominal(), Noise::new(5, 7), vec![0.0; 7]);
        let scales = arm.joint_scales(&p);
        for _ in 0..20 {
            let draw = |joint: &JointScale| {
                let [lower, upper] = joint.limits.unwrap();
                0.5 * (lower + upper) + noise.uniform(0.5 * (upper - lower))
            };
            let q: Vec<f64> = scales.iter().map(draw).collect();
            last = arm.nearest_joints(&p, &arm.tool_pose(&p, &q).unwrap(), &last).unwrap();
            assert_eq!(arm.limit_violation(&p, &last), None);
        }
    }

    #[test]
    fn joints_without_limits_stay_within_half_a_turn() {
        let arm = ur5e(None);
        let (p, mut noise, mut last) = (arm.nominal(), Noise::new(5, 8), vec![0.0; 6]);
        for _ in 0..20 {
            let q: Vec<f64> = (0..6).map(|_| noise.uniform(2.6)).collect();
            last = arm.nearest_joints(&p, &arm.tool_pose(&p, &q).unwrap(), &last).unwrap();
            assert!(last.iter().all(|q| q.abs() <= PI + 1e-9), "{last:?}");
        }
        // a start beyond half a turn keeps its turns
        let q = [3.5, -1.0, 1.2, 0.3, 0.8, -4.0];
        let near: Vec<f64> = q.iter().map(|q| q + 0.01).collect();
        let found = arm.nearest_joints(&p, &arm.tool_pose(&p, &q).unwrap(), &near).unwrap();
        assert!(joint_distance(&found, &q) < 1e-9, "{found:?}");
    }

    #[test]
    fn a_pose_beyond_the_arm_is_too_far_by_a_distance() {
        let arm = ur5e(None);
        let far = Pose { translation_mm: [2000.0, 0.0, 162.5], ..Pose::identity() };
        let why = arm.nearest_joints(&arm.nominal(), &far, &[0.0; 6]).unwrap_err();
        assert_eq!(why.id, "out-of-reach-by");
    }
}
