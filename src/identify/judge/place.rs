//! Base and targets of a robot located by the data, wherever they are: the start of a hypothesis.

use super::data::Data;
use crate::Observation;
use crate::solution::start::located;
use crate::wanted_frames;
use etalon_base::pose::{Pose, Vector, centroid, minus};
use etalon_robots::{Quantity, Robot, Role};

/// Number of fits with assembly modes, each with the modes that are nearer after the previous one.
const MODE_FITS: usize = 4;

/// The data and all parameters with base, targets and fixtures located; `None` if the nominal robot
/// has no pose at the joint values. With `anywhere`, the base of a planar robot may be beyond its
/// tolerances.
pub(super) fn locate(robot: &dyn Robot, mut data: Data, anywhere: bool) -> Option<(Data, Vec<f64>)> {
    let nominal = robot.nominal();
    if let Some(arm) = robot.free_base() {
        let wanted = wanted_frames(robot, &data.observations, &data.settings).ok()?;
        let placed = located(robot, arm, &data.observations, &data.settings, &wanted).ok()??;
        return Some((data, placed.values));
    }
    let most = if anywhere { ANYWHERE } else { within_tolerances(robot) };
    let (moved, _) = planar_fit(robot, &data.observations, &nominal, most)?;
    for o in &mut data.observations {
        o.joints = nearest(robot, &nominal, &moved, o).map_or_else(|| o.joints.clone(), |(joints, _)| joints);
        // into the frame in which the base is nominal
        if anywhere {
            o.targets.iter_mut().flatten().for_each(|p| *p = moved.inverse().apply(*p));
        }
    }
    Some((data, nominal))
}

/// Largest rotation (rad) and shift (mm) of the base of a planar robot.
#[derive(Clone, Copy)]
struct Reach {
    rad: f64,
    mm: f64,
}

const ANYWHERE: Reach = Reach { rad: f64::INFINITY, mm: f64::INFINITY };

/// Rotation and shift of the base of a planar robot by its tolerances.
fn within_tolerances(robot: &dyn Robot) -> Reach {
    let tolerance = |quantity: Quantity| {
        let base = robot.parameters().iter().filter(|p| p.role == Role::Base && p.quantity == quantity);
        base.map(|p| p.tolerance).fold(0.0, f64::max)
    };
    Reach { rad: tolerance(Quantity::Angle), mm: tolerance(Quantity::Length) }
}

/// Rotation (rad) and shift (mm) of the base of a planar robot with which it fits the data best.
pub(super) fn elsewhere(robot: &dyn Robot, observations: &[Observation]) -> Option<(f64, [f64; 2])> {
    let (moved, _) = planar_fit(robot, observations, &robot.nominal(), ANYWHERE)?;
    let [x_mm, y_mm, _] = moved.translation_mm;
    Some((moved.rotation_vector_rad()[2], [x_mm, y_mm]))
}

/// Distances (mm) of a planar robot at nominal parameters from the measurements, with its base
/// within its tolerances.
pub(super) fn planar_distances(robot: &dyn Robot, observations: &[Observation]) -> Option<Vec<f64>> {
    Some(planar_fit(robot, observations, &robot.nominal(), within_tolerances(robot))?.1)
}

/// Predicted and measured position of a target of a planar robot.
type Pair = [Vector; 2];

/// Motion of the plane that brings predicted positions to the measured ones, no larger than `most`,
/// and the residual distances (mm).
fn planar_fit(
    robot: &dyn Robot,
    observations: &[Observation],
    nominal: &[f64],
    most: Reach,
) -> Option<(Pose, Vec<f64>)> {
    let (mut moved, mut left) = (Pose::identity(), Vec::new());
    for _ in 0..if robot.has_assembly_modes() { MODE_FITS } else { 1 } {
        let near = |o: &Observation| Some(nearest(robot, nominal, &moved, o)?.1);
        let pairs: Vec<Pair> = observations.iter().map(near).collect::<Option<Vec<_>>>()?.concat();
        moved = motion(&pairs, most)?;
        left = pairs.iter().map(|pair| cost(&moved, std::slice::from_ref(pair)).sqrt()).collect();
    }
    Some((moved, left))
}

/// Joint values of an observation, in the assembly mode that is nearer after a motion, and its
/// positions; `None` if the robot can be in neither.
fn nearest(robot: &dyn Robot, nominal: &[f64], moved: &Pose, o: &Observation) -> Option<(Vec<f64>, Vec<Pair>)> {
    let mut modes = vec![o.joints.clone()];
    if robot.has_assembly_modes() {
        modes.push(o.joints.clone());
        modes[1].iter_mut().next_back().into_iter().for_each(|mode| *mode = -*mode);
    }
    let seen = |joints: Vec<f64>| {
        let measured = o.targets.iter().enumerate().filter_map(|(k, at)| Some((k, (*at)?)));
        let pairs: Vec<Pair> = measured.map(|(k, at)| [robot.position(nominal, &joints, k), at]).collect();
        (joints, pairs)
    };
    let finite = modes.into_iter().map(seen).filter(|(_, pairs)| cost(moved, pairs).is_finite());
    finite.min_by(|a, b| cost(moved, &a.1).total_cmp(&cost(moved, &b.1)))
}

/// Motion of the plane from the first to the second point of each pair, by least squares, no larger
/// than `most`: the rotation about the origin of the base.
fn motion(pairs: &[Pair], most: Reach) -> Option<Pose> {
    let [from, to] = [0, 1].map(|side| centroid(&pairs.iter().map(|pair| pair[side]).collect::<Vec<_>>()));
    let (from, to) = (from?, to?);
    let (mut along, mut across) = (0.0, 0.0);
    for [p, m] in pairs {
        let (p, m) = (minus(*p, from), minus(*m, to));
        along += p[0] * m[0] + p[1] * m[1];
        across += p[0] * m[1] - p[1] * m[0];
    }
    let angle = Some(across.atan2(along)).filter(|angle| angle.abs() <= most.rad).unwrap_or(0.0);
    let turned = Pose::identity().turn_z(angle);
    let shift = minus(to, turned.apply(from)).map(|v| v.clamp(-most.mm, most.mm));
    Some(Pose { translation_mm: [shift[0], shift[1], 0.0], ..turned })
}

/// Sum of squared distances of the positions after a motion.
fn cost(moved: &Pose, pairs: &[Pair]) -> f64 {
    let distance = |[p, m]: &Pair| minus(moved.apply(*p), *m)[..2].iter().map(|v| v * v).sum::<f64>();
    pairs.iter().map(distance).sum()
}
