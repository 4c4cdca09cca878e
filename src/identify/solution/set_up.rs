//! Errors of the set-up: a reversed joint, a unit, exchanged columns, a convention. Each is tried on the nominal robot, with base and
//! targets placed anew; the one with which it explains the measurements is the one to look for.

use crate::Observation;
use crate::model::residuals::Residuals;
use crate::solution::placing::{PLAIN, UNEXPLAINED, place, spread_mm, spread_over};
use crate::warning::{Origin, SetUpError, Subject, Warning};
use etalon_base::message::Message;
use etalon_base::pose::{Vector, centroid, minus, norm};
use etalon_base::pose_name::PoseName;
use etalon_math::statistics::{median, rms};
use etalon_math::{Options, factor_at};
use etalon_robots::{Quantity, Robot, Role};
use std::f64::consts::{FRAC_PI_2, TAU};

/// Poses on which changes are tried.
const SUBSET: usize = 32;
/// A change explains the data where the nominal robot then misses by less than this share of what it missed before.
const EXPLAINS: f64 = 0.5;
/// The same where the change is a value found from the data: that alone lowers what is missed.
const EXPLAINS_FITTED: f64 = 0.25;
/// Below this share no other explanation is looked for.
const CLEARLY: f64 = 0.05;
/// Changes that come this near to the best one are named beside it.
const AS_GOOD: f64 = 1.2;
/// Standard uncertainties of a coordinate that noise may leave, where poses are few.
const NOISE: f64 = 3.0;
/// Changes that are named.
const NAMED: usize = 3;
const MM_PER_INCH: f64 = 25.4;
/// Factors of lengths whose unit is another, and which.
const LENGTHS: [(f64, &str); 4] = [
    (1000.0, "in metres instead of millimetres"),
    (0.001, "in millimetres instead of metres"),
    (MM_PER_INCH, "in inches instead of millimetres"),
    (1.0 / MM_PER_INCH, "in millimetres instead of inches"),
];

/// A message with the change of the set-up that explains it, where there is one, in place of its hint.
pub(crate) fn explained(message: Message, robot: &dyn Robot, observations: &[Observation]) -> Warning {
    let Some(found) = set_up_error(robot, observations) else { return message.into() };
    Warning { message: message.hint(found.hint(|_| "")), subject: Subject::SetUp(found) }
}

/// Root mean square, in mm, of the errors of a nominal robot whose parameters are as far from nominal as their tolerances, taken
/// as half-widths of rectangular distributions (GUM 4.3.7), allow; base and targets, at `values`, take up what they can.
///
/// `noise_mm` is the standard uncertainty of a coordinate. What is allowed is never more than a tenth of the spread of the
/// measurements: with nominal values that are wrong themselves the Jacobian allows anything.
pub fn allowed_mm(robot: &dyn Robot, observations: &[Observation], values: &[f64], noise_mm: f64) -> Option<f64> {
    let of = |role: fn(Role) -> bool| (0..values.len()).filter(move |&i| role(robot.parameters()[i].role));
    let places: Vec<usize> = of(|role| role != Role::Robot).collect();
    let free: Vec<usize> = places.iter().copied().chain(of(|role| role == Role::Robot)).collect();
    let problem = Residuals::new(robot, observations, &PLAIN, &free, values).ok()?;
    let x: Vec<f64> = free.iter().map(|&i| values[i]).collect();
    let (factor, norms) = factor_at(&problem, &x);
    // what of a column base and targets do not take up lies below their rows
    let common = factor.common();
    let first = common.iter().take_while(|&&j| j < places.len()).count();
    let left = |k: usize| (first..=k).map(|i| factor.r(i, k).powi(2)).sum::<f64>() * norms[common[k]].powi(2);
    let variance = |k: usize| left(k) * robot.parameters()[free[common[k]]].tolerance.powi(2) / 3.0;
    let points = observations.iter().flat_map(|o| o.targets.iter().flatten()).count();
    let sum: f64 = (first..common.len()).map(variance).sum();
    let noise = robot.dimension() as f64 * (NOISE * noise_mm).powi(2);
    let most = (UNEXPLAINED * spread_mm(observations)).max(noise.sqrt());
    Some((sum / points.max(1) as f64 + noise).sqrt().min(most)).filter(|v| v.is_finite())
}

/// An error where no place of base and targets brings the nominal robot as near to the measurements as its tolerances allow, with the
/// change of the set-up that would.
///
/// A few wrong readings are no wrong set-up: half of all readings must be as far.
pub fn set_up_problem(robot: &dyn Robot, observations: &[Observation], noise_mm: f64) -> Option<Warning> {
    let subset = spread_over(observations, SUBSET);
    let nominal = robot.nominal();
    let stated = misfit(robot, &subset, &nominal, false);
    let [stated_mm, median_mm] = stated.map_or([f64::INFINITY; 2], |m| [m.rms_mm, m.median_mm]);
    let allowed_mm = allowed_mm(robot, &subset, &nominal, noise_mm)?;
    (median_mm > allowed_mm).then(|| far_from_nominal(robot, observations, stated_mm, allowed_mm))
}

/// That the nominal robot misses the measurements by more than its tolerances allow.
pub fn far_from_nominal(robot: &dyn Robot, observations: &[Observation], left_mm: f64, allowed_mm: f64) -> Warning {
    let what = if left_mm.is_finite() {
        format!(
            "the nominal robot misses the measurements by {left_mm:.3} mm (root mean square), with base and targets where they explain \
             them best; parameters within their tolerances explain {allowed_mm:.3} mm"
        )
    } else {
        "the nominal robot cannot be where the joints put it".to_owned()
    };
    let message = Message::error(what)
        .hint("check signs, units and order of the joints, the nominal values, and how log and points are joined");
    explained(message, robot, observations)
}

/// The change of the set-up with which the nominal robot explains the measurements, where there is one.
pub fn set_up_error(robot: &dyn Robot, observations: &[Observation]) -> Option<SetUpError> {
    let subset = spread_over(observations, SUBSET);
    let nominal = robot.nominal();
    let stated_mm = misfit(robot, &subset, &nominal, false).map_or(f64::INFINITY, |m| m.rms_mm);
    let mut found: Vec<Change> = Vec::new();
    let mut add = |what: String, observations: Vec<Observation>, robot: &dyn Robot, anywhere: bool| {
        let Some(misfit) = misfit(robot, &observations, &robot.nominal(), anywhere) else { return };
        let allowed = || allowed_mm(robot, &observations, &robot.nominal(), CLEARLY * stated_mm.min(1e9));
        if misfit.rms_mm < EXPLAINS * stated_mm && allowed().is_none_or(|allowed_mm| misfit.rms_mm <= allowed_mm) {
            let origin = if anywhere { Origin::Unit } else { Origin::Named };
            found.push(Change { what, origin, left_mm: misfit.rms_mm });
        }
    };
    for (what, changed) in changes_of_joints(robot, &subset) {
        add(what, changed, robot, false);
    }
    for (what, changed) in changes_of_points(robot, &subset) {
        add(what, changed, robot, false);
    }
    // the frame may be in the right unit, and then lies elsewhere
    for (factor, how) in LENGTHS {
        let mut changed = subset.clone();
        changed.iter_mut().flat_map(|o| o.targets.iter_mut().flatten()).for_each(|p| *p = p.map(|v| v * factor));
        add(format!("the measured points {how}"), changed, robot, true);
    }
    for (shift, which) in [(-1, "previous"), (1, "next")] {
        let what = format!("the joints of each pose taken from the {which} one");
        // the first or last pose has no neighbour: it must not be what was wrong
        let shifted = spread_over(&shifted(observations, shift), SUBSET);
        let same: Vec<Observation> = shifted
            .iter()
            .filter_map(|s| {
                observations.iter().find(|o| o.pose == s.pose && o.cycle == s.cycle && o.targets == s.targets)
            })
            .cloned()
            .collect();
        let as_stated = misfit(robot, &same, &nominal, false).map_or(f64::INFINITY, |m| m.rms_mm);
        if as_stated > 0.5 * stated_mm {
            add(what, shifted, robot, false);
        }
    }
    for (what, other) in robot.other_conventions() {
        add(what, subset.clone(), other.as_ref(), false);
    }
    let best = found.iter().map(|f| f.left_mm).fold(f64::INFINITY, f64::min);
    if robot.free_base().is_none() {
        found.extend(
            elsewhere(robot, &subset, &nominal).filter(|f| f.left_mm < EXPLAINS_FITTED * stated_mm.min(2.0 * best)),
        );
    }
    if best > CLEARLY * stated_mm {
        // a value found from the data must explain clearly more than a change that has none
        let mut fitted = wrong_nominal(robot, &subset, &nominal, stated_mm);
        let allowed_mm = allowed_mm(robot, &subset, &nominal, 0.0).unwrap_or(f64::INFINITY);
        fitted.retain(|f| f.left_mm <= allowed_mm);
        fitted.retain(|f| f.left_mm < EXPLAINS_FITTED * stated_mm.min(2.0 * best));
        if !fitted.is_empty() {
            found = fitted;
        }
    }
    found.sort_by(|a, b| a.left_mm.total_cmp(&b.left_mm));
    let changed_mm = found.first()?.left_mm;
    let near = found.into_iter().take_while(|f| f.left_mm <= AS_GOOD * changed_mm).take(NAMED);
    Some(SetUpError { changes: near.map(|f| (f.what, f.origin)).collect(), stated_mm, changed_mm })
}

/// The base of a planar robot wherever the measurements have it.
fn elsewhere(robot: &dyn Robot, observations: &[Observation], nominal: &[f64]) -> Option<Change> {
    let (fit, left) = planar_fit(robot, observations, nominal, &ANYWHERE)?;
    let what = format!(
        "the world frame turned by {:.1} deg and shifted by ({:.1}, {:.1}) mm",
        fit.angle.to_degrees(),
        fit.shift[0],
        fit.shift[1]
    );
    Some(Change { what, origin: Origin::WorldFrame, left_mm: rms(left) })
}

/// A change, and the root mean square distance that it leaves, mm.
struct Change {
    what: String,
    origin: Origin,
    left_mm: f64,
}

/// What the nominal robot leaves of the measurements.
struct Misfit {
    /// Root mean square of the distances.
    rms_mm: f64,
    /// Their median.
    median_mm: f64,
    values: Vec<f64>,
}

/// Base and targets placed by the measurements, and what is left; `None` where the robot cannot be where the joints put it.
/// With `anywhere` the base of a planar robot may be beyond its tolerances.
fn misfit(robot: &dyn Robot, observations: &[Observation], nominal: &[f64], anywhere: bool) -> Option<Misfit> {
    if let Some(arm) = robot.free_base() {
        let places: Vec<usize> = (0..nominal.len()).filter(|&i| robot.parameters()[i].role != Role::Robot).collect();
        let placed = place(robot, arm, observations, nominal, &places).ok()??;
        let misses = observations.iter().flat_map(|o| o.misses(robot, &placed.values));
        let left: Vec<f64> = misses.map(|(_, miss)| norm(miss)).collect();
        let found = Misfit { rms_mm: placed.rms_mm, median_mm: median(left).unwrap_or(0.0), values: placed.values };
        return Some(found).filter(|m| m.rms_mm.is_finite());
    }
    planar_misfit(robot, observations, nominal, anywhere)
}

/// The same in the plane: predicted positions are brought to the measured ones by a shift, and by a turn where the base has an
/// angle, both within the tolerances of the base; of two assembly modes the nearer is taken.
fn planar_misfit(robot: &dyn Robot, observations: &[Observation], nominal: &[f64], anywhere: bool) -> Option<Misfit> {
    let tolerance = |quantity: Quantity| {
        let base = robot.parameters().iter().filter(|p| p.role == Role::Base && p.quantity == quantity);
        base.map(|p| p.tolerance).fold(0.0, f64::max)
    };
    let within = Similarity { angle: tolerance(Quantity::Angle), shift: [tolerance(Quantity::Length); 2] };
    let most = if anywhere { ANYWHERE } else { within };
    let (_, left) = planar_fit(robot, observations, nominal, &most)?;
    Some(Misfit { rms_mm: rms(left.iter().copied()), median_mm: median(left).unwrap_or(0.0), values: nominal.to_vec() })
}

/// Shift and turn that bring predicted positions to the measured ones, no further than `most`, and the distances that they leave, mm.
fn planar_fit(
    robot: &dyn Robot,
    observations: &[Observation],
    nominal: &[f64],
    most: &Similarity,
) -> Option<(Similarity, Vec<f64>)> {
    let modes: &[Option<f64>] = if robot.has_assembly_modes() { &[Some(1.0), Some(-1.0)] } else { &[None] };
    let mut fit = Similarity::default();
    let mut left = Vec::new();
    for _ in 0..if modes.len() > 1 { 4 } else { 1 } {
        let mut pairs: Vec<[[f64; 2]; 2]> = Vec::new();
        for o in observations {
            let mut joints = o.joints.clone();
            let of = |mode: &Option<f64>| {
                if let (Some(mode), Some(last)) = (mode, joints.last_mut()) {
                    *last = *mode;
                }
                let mut pairs = Vec::new();
                for (k, measured) in o.targets.iter().enumerate() {
                    let (Some(m), p) = (measured, robot.position(nominal, &joints, k)) else { continue };
                    pairs.push([[p[0], p[1]], [m[0], m[1]]]);
                }
                pairs
            };
            let all = modes.iter().map(of).filter(|pairs| pairs.iter().flatten().flatten().all(|v| v.is_finite()));
            pairs.extend(all.min_by(|a, b| fit.cost(a).total_cmp(&fit.cost(b)))?);
        }
        fit = Similarity::between(&pairs, most)?;
        left = pairs.iter().map(|pair| fit.cost(std::slice::from_ref(pair)).sqrt()).collect();
    }
    Some((fit, left))
}

const ANYWHERE: Similarity = Similarity { angle: f64::INFINITY, shift: [f64::INFINITY; 2] };

/// A shift, and perhaps a turn, of the plane.
#[derive(Default)]
struct Similarity {
    angle: f64,
    shift: [f64; 2],
}

impl Similarity {
    /// From the first to the second point of each pair, by least squares, no further than `most`.
    fn between(pairs: &[[[f64; 2]; 2]], most: &Self) -> Option<Self> {
        let n = Some(pairs.len() as f64).filter(|n| *n > 0.0)?;
        let mean = |side: usize| [0, 1].map(|i| pairs.iter().map(|p| p[side][i]).sum::<f64>() / n);
        let (from, to) = (mean(0), mean(1));
        let (mut along, mut across) = (0.0, 0.0);
        for [p, m] in pairs {
            let (p, m) = ([p[0] - from[0], p[1] - from[1]], [m[0] - to[0], m[1] - to[1]]);
            along += p[0] * m[0] + p[1] * m[1];
            across += p[0] * m[1] - p[1] * m[0];
        }
        let angle = Some(across.atan2(along)).filter(|angle| angle.abs() <= most.angle).unwrap_or(0.0);
        let turned = Self { angle, shift: [0.0; 2] };
        // what the base is off by: the turn is about its origin
        let moved = turned.apply(from);
        let within = |i: usize| (to[i] - moved[i]).clamp(-most.shift[i], most.shift[i]);
        Some(Self { shift: [within(0), within(1)], ..turned })
    }

    fn apply(&self, p: [f64; 2]) -> [f64; 2] {
        let (sin, cos) = self.angle.sin_cos();
        [cos * p[0] - sin * p[1] + self.shift[0], sin * p[0] + cos * p[1] + self.shift[1]]
    }

    /// Sum of squared distances.
    fn cost(&self, pairs: &[[[f64; 2]; 2]]) -> f64 {
        let distance = |[p, m]: &[[f64; 2]; 2]| {
            let q = self.apply(*p);
            (q[0] - m[0]).powi(2) + (q[1] - m[1]).powi(2)
        };
        pairs.iter().map(distance).sum()
    }
}

/// Where, in the order of the observations, measured positions begin to lie elsewhere than the robot at `values`: base or measuring
/// system has moved. A warning where one shift explains most of what is left, and chance would not.
pub fn moved_between(robot: &dyn Robot, observations: &[Observation], values: &[f64]) -> Option<Message> {
    let left = |o: &Observation| centroid(&o.misses(robot, values).map(|(_, miss)| miss).collect::<Vec<_>>());
    let all: Vec<(PoseName, Vector)> = observations.iter().filter_map(|o| Some((o.pose, left(o)?))).collect();
    let n = all.len();
    let sum = all.iter().fold([0.0; 3], |s, (_, r)| [0, 1, 2].map(|i| s[i] + r[i]));
    let middle = sum.map(|s| s / n as f64);
    let total: f64 = all.iter().map(|(_, r)| norm(minus(*r, middle)).powi(2)).sum();
    let (mut first, mut best) = ([0.0; 3], (0.0, 0, [0.0; 3]));
    for k in 1..n {
        first = [0, 1, 2].map(|i| first[i] + all[k - 1].1[i]);
        if k < FEWEST_ASIDE || n - k < FEWEST_ASIDE || all[k - 1].0 == all[k].0 {
            continue;
        }
        let (before, after) = (first.map(|s| s / k as f64), [0, 1, 2].map(|i| (sum[i] - first[i]) / (n - k) as f64));
        let shift = minus(after, before);
        let explained = (k * (n - k)) as f64 / n as f64 * norm(shift).powi(2) / total;
        if explained > best.0 {
            best = (explained, k, shift);
        }
    }
    let (explained, k, shift) = best;
    (explained > MOVED_SHARE).then(|| {
        let what = format!(
            "from pose {} on, the measured positions lie {:.3} mm off from those until pose {} ({:.3}, {:.3}, {:.3} mm): this one shift \
             explains {:.0} % of what is left",
            all[k].0,
            norm(shift),
            all[k - 1].0,
            shift[0],
            shift[1],
            shift[2],
            100.0 * explained
        );
        Message::warning(what).to_decide().hint("base or measuring system has moved in between: identify the parts by themselves, or measure again")
    })
}

/// Observations on either side of a move, at least.
const FEWEST_ASIDE: usize = 5;
/// Share of the squares that are left which one move must explain: of errors that follow no order it is a few percent.
const MOVED_SHARE: f64 = 0.4;

/// The observations as they would be with one thing of the joints changed, and what that is.
fn changes_of_joints(robot: &dyn Robot, observations: &[Observation]) -> Vec<(String, Vec<Observation>)> {
    let mut all: Vec<(String, Vec<Observation>)> = Vec::new();
    let mut change = |what: String, how: &dyn Fn(&mut Observation)| {
        let mut changed = observations.to_vec();
        changed.iter_mut().for_each(how);
        all.push((what, changed));
    };
    let joints = robot.joints();
    let n = joints.len();
    let of = |quantity: Quantity| (0..n).filter(|&i| joints[i].quantity == quantity).collect::<Vec<usize>>();
    let name = |i: usize| format!("`{}`", joints[i].name);
    for i in 0..n {
        change(format!("{} reversed", name(i)), &|o| o.joints[i] = -o.joints[i]);
        for j in i + 1..n {
            if joints[i].quantity == joints[j].quantity {
                change(format!("{} and {} exchanged", name(i), name(j)), &|o| o.joints.swap(i, j));
            }
        }
    }
    if n > 2 && joints.iter().all(|j| j.quantity == joints[0].quantity) {
        change("the joints in reverse order".into(), &|o| o.joints[..n].reverse());
        change("the joints shifted by one column".into(), &|o| o.joints[..n].rotate_left(1));
        change("the joints shifted by one column to the other side".into(), &|o| o.joints[..n].rotate_right(1));
    }
    let turning = of(Quantity::Angle);
    for &i in &turning {
        for (offset, deg) in [(FRAC_PI_2, "90"), (-FRAC_PI_2, "-90"), (2.0 * FRAC_PI_2, "180")] {
            change(format!("{deg} deg added to {}", name(i)), &|o| o.joints[i] += offset);
        }
    }
    let mut scale = |which: &[usize], factor: f64, how: &str| {
        let what = match which {
            [] => return,
            [one] => format!("{} {how}", name(*one)),
            _ if which.len() == n => format!("all joints {how}"),
            _ => format!("all joints of this kind {how}"),
        };
        change(what, &|o| which.iter().for_each(|&i| o.joints[i] *= factor));
    };
    let rad = 1f64.to_degrees();
    let (radians, degrees) = ("in radians instead of degrees", "in degrees instead of radians");
    let sliding = of(Quantity::Length);
    let single = |which: &[usize]| if which.len() > 1 { which.to_vec() } else { Vec::new() };
    for which in std::iter::once(turning.clone()).chain(single(&turning).into_iter().map(|i| vec![i])) {
        scale(&which, rad, radians);
        scale(&which, 1.0 / rad, degrees);
    }
    for which in std::iter::once(sliding.clone()).chain(single(&sliding).into_iter().map(|i| vec![i])) {
        LENGTHS.iter().for_each(|&(factor, how)| scale(&which, factor, how));
    }
    all
}

/// The same with one thing of the measured points changed.
fn changes_of_points(robot: &dyn Robot, observations: &[Observation]) -> Vec<(String, Vec<Observation>)> {
    let mut all: Vec<(String, Vec<Observation>)> = Vec::new();
    let mut change = |what: String, how: &dyn Fn(&mut Observation)| {
        let mut changed = observations.to_vec();
        changed.iter_mut().for_each(how);
        all.push((what, changed));
    };
    let mut points = |what: String, how: &dyn Fn(&mut Vector)| {
        change(what, &|o| o.targets.iter_mut().flatten().for_each(how));
    };
    if robot.dimension() == 3 {
        let what = "the measured points mirrored (a left-handed frame, or two coordinates exchanged)";
        points(what.into(), &|p| p[0] = -p[0]);
    } else {
        points("x and y of the measured points exchanged".into(), &|p| p.swap(0, 1));
        points("x of the measured points reversed".into(), &|p| p[0] = -p[0]);
        points("y of the measured points reversed".into(), &|p| p[1] = -p[1]);
    }
    let targets = robot.targets();
    if robot.free_base().is_none() {
        for i in 0..targets.len() {
            for j in i + 1..targets.len() {
                let what = format!("the targets {} and {} exchanged", targets[i], targets[j]);
                change(what, &|o| o.targets.swap(i, j));
            }
        }
    }
    all
}

/// The observations with the joints of the pose before or after, in the order in which poses come.
fn shifted(observations: &[Observation], shift: isize) -> Vec<Observation> {
    let mut poses: Vec<(PoseName, &Observation)> = Vec::new();
    for o in observations {
        if poses.last().is_none_or(|(pose, _)| *pose != o.pose) {
            poses.push((o.pose, o));
        }
    }
    let mut at = 0;
    let mut all = Vec::new();
    for o in observations {
        while poses[at].0 != o.pose {
            at += 1;
        }
        let other = at.checked_add_signed(shift).and_then(|k| poses.get(k));
        all.extend(other.map(|(_, other)| Observation { joints: other.joints.clone(), ..o.clone() }));
    }
    all
}

/// For each length and angle of the robot the value with which the nominal robot explains the data best, where that is beyond its
/// tolerance.
fn wrong_nominal(robot: &dyn Robot, observations: &[Observation], nominal: &[f64], stated_mm: f64) -> Vec<Change> {
    let Some(placed) = misfit(robot, observations, nominal, false) else { return Vec::new() };
    let parameters = robot.parameters();
    let places =
        || (0..nominal.len()).filter(|&i| parameters[i].role == Role::Base || parameters[i].tolerance.is_infinite());
    let points = observations.iter().flat_map(|o| o.targets.iter().flatten()).count().max(1) as f64;
    let with = |i: usize| {
        let p = &parameters[i];
        let mut free: Vec<usize> = places().chain([i]).collect();
        free.sort_unstable();
        let problem = Residuals::new(robot, observations, &PLAIN, &free, &placed.values).ok()?;
        let x: Vec<f64> = free.iter().map(|&i| placed.values[i]).collect();
        let solution = etalon_math::solve(&problem, &x, Options { iterations: 30, step: 1e-6, ..Options::default() });
        let mut value = problem.all(&solution.x)[i];
        if p.quantity == Quantity::Angle {
            value -= ((value - p.nominal) / TAU).round() * TAU;
        }
        let rms_mm = (solution.cost / points).sqrt();
        let beyond = (value - p.nominal).abs() > p.tolerance;
        (rms_mm < EXPLAINS_FITTED * stated_mm && beyond).then(|| {
            let (unit, outward) = (p.quantity.unit(), |v| p.quantity.outward(v));
            let what =
                format!("`{}` = {:.2} {unit} instead of {:.2} {unit}", p.name, outward(value), outward(p.nominal));
            Change { what, origin: Origin::Named, left_mm: rms_mm }
        })
    };
    let lengths_and_angles =
        (0..nominal.len()).filter(|&i| parameters[i].role == Role::Robot && parameters[i].quantity != Quantity::Ratio);
    lengths_and_angles.filter_map(with).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_base::noise::Noise;
    use etalon_robots::Prexyt;

    /// Forty poses, measured with 3 um, from pose 22 on with a shift.
    fn measured(robot: &Prexyt, shift_mm: f64) -> Vec<Observation> {
        let (nominal, mut noise) = (robot.nominal(), Noise::new(16, 4));
        let pose = |i: i64| {
            let joints = vec![85.0 + noise.uniform(80.0), 150.0 + noise.uniform(100.0), 150.0 + noise.uniform(100.0)];
            let by = if i < 22 { 0.0 } else { shift_mm };
            let mut seen = |[x, y]: [f64; 2]| Some([x + by + noise.gaussian(0.003), y + noise.gaussian(0.003), 0.0]);
            let targets = robot.balls(&nominal, &joints).map(&mut seen).to_vec();
            Observation { pose: i.into(), cycle: 1, joints, targets, ..Observation::default() }
        };
        (1..=40).map(pose).collect()
    }

    #[test]
    fn a_move_is_found_where_it_happens_and_nowhere_else() {
        let robot = Prexyt::default();
        let moved = moved_between(&robot, &measured(&robot, 0.05), &robot.nominal()).expect("moved");
        assert!(moved.what.starts_with("from pose 22 on") && moved.what.contains("until pose 21"), "{}", moved.what);
        assert!(moved.what.contains("lie 0.05") && moved.what.contains("(0.05"), "{}", moved.what);
        assert_eq!(moved_between(&robot, &measured(&robot, 0.0), &robot.nominal()), None);
        // a single wrong reading, at an end or between others, is not a move
        for wrong in [0, 20, 39] {
            let mut observations = measured(&robot, 0.0);
            observations[wrong].targets[0].as_mut().unwrap()[0] += 0.5;
            assert_eq!(moved_between(&robot, &observations, &robot.nominal()), None, "{wrong}");
        }
    }
}
