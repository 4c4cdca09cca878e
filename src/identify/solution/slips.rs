//! Slips of a set-up: what observations would be without each of them.

use crate::Observation;
use crate::warning::Origin;
use etalon_base::pose::Vector;
use etalon_base::pose_name::PoseName;
use etalon_robots::{Quantity, Robot};
use std::f64::consts::FRAC_PI_2;

const MM_PER_INCH: f64 = 25.4;
/// Factors of lengths whose unit is another, and which.
pub(crate) const LENGTHS: [(f64, &str); 4] = [
    (1000.0, "in metres instead of millimetres"),
    (0.001, "in millimetres instead of metres"),
    (MM_PER_INCH, "in inches instead of millimetres"),
    (1.0 / MM_PER_INCH, "in millimetres instead of inches"),
];

/// A slip, and the observations without it.
pub(crate) struct Change {
    /// The slip: "`q7` reversed".
    pub what: String,
    /// What states the part of the set-up that is wrong.
    pub origin: Origin,
    /// The observations without it.
    pub observations: Vec<Observation>,
    /// `true` if the base of a planar robot may then lie beyond its tolerances.
    pub anywhere: bool,
}

impl Change {
    fn named(what: String, observations: Vec<Observation>) -> Self {
        Self { what, origin: Origin::Named, observations, anywhere: false }
    }
}

/// Slips in joints and points, one at a time.
pub(crate) fn changes(robot: &dyn Robot, observations: &[Observation]) -> Vec<Change> {
    let named = changes_of_joints(robot, observations).into_iter().chain(changes_of_points(robot, observations));
    let mut all: Vec<Change> = named.map(|(what, changed)| Change::named(what, changed)).collect();
    // the frame may be in the right unit, and then lies elsewhere
    all.extend(LENGTHS.map(|(factor, how)| {
        let mut changed = observations.to_vec();
        changed.iter_mut().flat_map(|o| o.targets.iter_mut().flatten()).for_each(|p| *p = p.map(|v| v * factor));
        Change { origin: Origin::Unit, anywhere: true, ..Change::named(format!("the measured points {how}"), changed) }
    }));
    all
}

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
