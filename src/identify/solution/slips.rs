//! Slips of a set-up, and the observations without each of them.

use crate::Observation;
use crate::solution::placing::readings;
use crate::warning::Origin;
use etalon_base::catalogue::Phrase;
use etalon_base::phrase;
use etalon_base::pose::Vector;
use etalon_base::pose_name::PoseName;
use etalon_robots::{Quantity, Robot};
use std::f64::consts::FRAC_PI_2;

const MM_PER_INCH: f64 = 25.4;
/// Factors between units of length, with the slip that each corrects.
pub(crate) const LENGTHS: [(f64, &str); 4] =
    [(1000.0, "m-mm"), (0.001, "mm-m"), (MM_PER_INCH, "inch-mm"), (1.0 / MM_PER_INCH, "mm-inch")];

/// A slip, and the observations without it.
pub(crate) struct Change {
    /// The slip: "`q7` reversed".
    pub what: Phrase,
    /// Statement of the wrong part of the set-up.
    pub origin: Origin,
    /// The observations without it.
    pub observations: Vec<Observation>,
    /// `true` if the base of a planar robot may be beyond its tolerances without the slip.
    pub anywhere: bool,
}

impl Change {
    fn named(what: Phrase, observations: Vec<Observation>) -> Self {
        Self { what, origin: Origin::Named, observations, anywhere: false }
    }
}

/// Slips in joints and points, one at a time.
pub(crate) fn changes(robot: &dyn Robot, observations: &[Observation]) -> Vec<Change> {
    let named = changes_of_joints(robot, observations).into_iter().chain(changes_of_points(robot, observations));
    let mut all: Vec<Change> = named.map(|(what, changed)| Change::named(what, changed)).collect();
    // the frame may be in the right unit, and then lies elsewhere
    all.extend(LENGTHS.map(|(factor, slip)| {
        let mut changed = observations.to_vec();
        changed.iter_mut().flat_map(|o| o.targets.iter_mut().flatten()).for_each(|p| *p = p.map(|v| v * factor));
        let what = phrase!("slip-unit", quantity = "points", slip);
        Change { origin: Origin::Unit, anywhere: true, ..Change::named(what, changed) }
    }));
    all.extend(exchanged_branches(robot, observations).into_iter().map(|(what, changed)| Change::named(what, changed)));
    all.extend(units_of_targets(robot, observations).into_iter().map(|(what, changed)| Change::named(what, changed)));
    all
}

/// Minimum number of readings of a target whose unit is questioned: its place has three unknown
/// coordinates, which fewer readings fit in any unit.
const FEWEST_READINGS: usize = 4;

/// Observations with the points of some targets in another unit, and the change: each target alone,
/// and all targets but one. Exports of a measuring system hold targets of their own.
fn units_of_targets(robot: &dyn Robot, observations: &[Observation]) -> Vec<(Phrase, Vec<Observation>)> {
    let seen = readings(robot, observations);
    let often: Vec<usize> = seen.iter().filter(|(_, count)| *count >= FEWEST_READINGS).map(|(k, _)| *k).collect();
    if seen.len() < 2 {
        return Vec::new();
    }
    let mut groups: Vec<Vec<usize>> = often.iter().map(|&k| vec![k]).collect();
    if seen.len() > 2 && often.len() == seen.len() {
        groups.extend(often.iter().map(|k| often.iter().copied().filter(|other| other != k).collect()));
    }
    let mut all = Vec::new();
    for group in groups.into_iter().take(MOST_GROUPS) {
        let names: Vec<String> = group.iter().map(|&k| format!("`{}`", robot.targets()[k])).collect();
        for (factor, slip) in LENGTHS {
            let mut changed = observations.to_vec();
            let points = changed.iter_mut().flat_map(|o| o.targets.iter_mut().enumerate());
            let points = points.filter(|(k, _)| group.contains(k)).filter_map(|(_, point)| point.as_mut());
            points.for_each(|p| *p = p.map(|v| v * factor));
            all.push((phrase!("slip-unit-of-targets", targets = names, slip), changed));
        }
    }
    all
}

/// Observations with the targets of two branches exchanged, in their order, and the change.
fn exchanged_branches(robot: &dyn Robot, observations: &[Observation]) -> Vec<(Phrase, Vec<Observation>)> {
    let links = robot.branches();
    let seen = readings(robot, observations);
    let of = |branch: usize| -> Vec<usize> {
        seen.iter().map(|(k, _)| *k).filter(|&k| robot.target_branch(k) == branch).collect()
    };
    let pairs = (0..links.len()).flat_map(|b| (0..b).map(move |a| (a, b)));
    let exchanged = |(a, b): (usize, usize)| {
        let (first, second) = (of(a), of(b));
        if first.is_empty() || first.len() != second.len() {
            return None;
        }
        let mut changed = observations.to_vec();
        for o in &mut changed {
            first.iter().zip(&second).for_each(|(&i, &j)| o.targets.swap(i, j));
        }
        let [first, second] = [a, b].map(|branch| format!("`{}`", links[branch]));
        Some((phrase!("slip-branches-exchanged", first, second), changed))
    };
    pairs.filter_map(exchanged).collect()
}

/// Maximum number of targets, or groups of targets, whose unit or exchange is questioned.
const MOST_GROUPS: usize = 12;

/// Observations with one property of the joints changed, and the change.
fn changes_of_joints(robot: &dyn Robot, observations: &[Observation]) -> Vec<(Phrase, Vec<Observation>)> {
    let mut all: Vec<(Phrase, Vec<Observation>)> = Vec::new();
    let mut change = |what: Phrase, how: &dyn Fn(&mut Observation)| {
        let mut changed = observations.to_vec();
        changed.iter_mut().for_each(how);
        all.push((what, changed));
    };
    let joints = robot.joints();
    let n = joints.len();
    let of = |quantity: Quantity| (0..n).filter(|&i| joints[i].quantity == quantity).collect::<Vec<usize>>();
    let name = |i: usize| format!("`{}`", joints[i].name);
    for i in 0..n {
        change(phrase!("slip-reversed", joint = name(i)), &|o| o.joints[i] = -o.joints[i]);
        for j in i + 1..n {
            if joints[i].quantity == joints[j].quantity {
                change(phrase!("slip-exchanged", first = name(i), second = name(j)), &|o| o.joints.swap(i, j));
            }
        }
    }
    if n > 2 && joints.iter().all(|j| j.quantity == joints[0].quantity) {
        change(phrase!("slip-joint-order", order = "reversed"), &|o| o.joints[..n].reverse());
        change(phrase!("slip-joint-order", order = "left"), &|o| o.joints[..n].rotate_left(1));
        change(phrase!("slip-joint-order", order = "right"), &|o| o.joints[..n].rotate_right(1));
    }
    let turning = of(Quantity::Angle);
    for &i in &turning {
        for (offset, degrees) in [(FRAC_PI_2, "90"), (-FRAC_PI_2, "-90"), (2.0 * FRAC_PI_2, "180")] {
            change(phrase!("slip-offset", degrees, joint = name(i)), &|o| o.joints[i] += offset);
        }
    }
    let mut scale = |which: &[usize], factor: f64, slip: &str| {
        let quantity = match which {
            [] => return,
            [one] => name(*one),
            _ if which.len() == n => "all-joints".to_owned(),
            _ => "joints-of-kind".to_owned(),
        };
        change(phrase!("slip-unit", quantity, slip), &|o| which.iter().for_each(|&i| o.joints[i] *= factor));
    };
    let rad = 1f64.to_degrees();
    let (radians, degrees) = ("rad-deg", "deg-rad");
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

/// Observations with one property of the measured points changed, and the change.
fn changes_of_points(robot: &dyn Robot, observations: &[Observation]) -> Vec<(Phrase, Vec<Observation>)> {
    let mut all: Vec<(Phrase, Vec<Observation>)> = Vec::new();
    let mut change = |what: Phrase, how: &dyn Fn(&mut Observation)| {
        let mut changed = observations.to_vec();
        changed.iter_mut().for_each(how);
        all.push((what, changed));
    };
    let mut points = |what: Phrase, how: &dyn Fn(&mut Vector)| {
        change(what, &|o| o.targets.iter_mut().flatten().for_each(how));
    };
    if robot.dimension() == 3 {
        points(phrase!("slip-points", change = "mirrored"), &|p| p[0] = -p[0]);
    } else {
        points(phrase!("slip-points", change = "exchanged"), &|p| p.swap(0, 1));
        points(phrase!("slip-points", change = "x"), &|p| p[0] = -p[0]);
        points(phrase!("slip-points", change = "y"), &|p| p[1] = -p[1]);
    }
    let targets = robot.targets();
    if robot.free_base().is_none() {
        // of many targets those with the most readings: the pairs of all grow with their square
        let mut seen = readings(robot, observations);
        seen.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
        let mut some: Vec<usize> = seen.into_iter().map(|(k, _)| k).take(MOST_GROUPS).collect();
        some.sort_unstable();
        for (at, &i) in some.iter().enumerate() {
            for &j in &some[at + 1..] {
                let what = phrase!("slip-targets", first = targets[i], second = targets[j]);
                change(what, &|o| o.targets.swap(i, j));
            }
        }
    }
    all
}

/// Observations with the joints of the previous or next pose, in the order of the poses.
pub(crate) fn shifted(observations: &[Observation], shift: isize) -> Vec<Observation> {
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
