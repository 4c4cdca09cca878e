//! Base and targets of a robot located by the data, wherever they are: the start of a hypothesis.

use super::data::Data;
use crate::Observation;
use crate::solution::start::located;
use crate::wanted_frames;
use etalon_base::pose::Vector;
use etalon_robots::{Quantity, Robot, Role};

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
    let (fit, _) = planar_fit(robot, &data.observations, &nominal, &most)?;
    fit.bring_near(robot, &nominal, anywhere, &mut data.observations);
    Some((data, nominal))
}

/// Rotation and shift of the base of a planar robot by its tolerances.
fn within_tolerances(robot: &dyn Robot) -> Similarity {
    let tolerance = |quantity: Quantity| {
        let base = robot.parameters().iter().filter(|p| p.role == Role::Base && p.quantity == quantity);
        base.map(|p| p.tolerance).fold(0.0, f64::max)
    };
    Similarity { angle: tolerance(Quantity::Angle), shift: [tolerance(Quantity::Length); 2] }
}

/// Rotation (rad) and shift (mm) of the base of a planar robot with which it fits the data best.
pub(super) fn elsewhere(robot: &dyn Robot, observations: &[Observation]) -> Option<(f64, [f64; 2])> {
    let (fit, _) = planar_fit(robot, observations, &robot.nominal(), &ANYWHERE)?;
    Some((fit.angle, fit.shift))
}

/// Distances (mm) of a planar robot at nominal parameters from the measurements, with its base
/// within its tolerances.
pub(super) fn planar_distances(robot: &dyn Robot, observations: &[Observation]) -> Option<Vec<f64>> {
    Some(planar_fit(robot, observations, &robot.nominal(), &within_tolerances(robot))?.1)
}

/// Shift and rotation that fit predicted positions to the measured ones, no larger than `most`, and
/// the residual distances (mm).
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

/// A shift of the plane, with or without a rotation.
#[derive(Default)]
struct Similarity {
    angle: f64,
    shift: [f64; 2],
}

impl Similarity {
    /// Motion from the first to the second point of each pair, by least squares, no larger than
    /// `most`.
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

    /// Sets the nearer assembly mode of observations, and moves them by `back` into the frame in
    /// which the base is nominal.
    fn bring_near(&self, robot: &dyn Robot, nominal: &[f64], back: bool, observations: &mut [Observation]) {
        for o in observations {
            let pairs = |joints: &[f64]| -> Vec<[[f64; 2]; 2]> {
                let seen = o.targets.iter().enumerate().filter_map(|(k, at)| Some((k, (*at)?)));
                let place = |(k, m): (usize, Vector)| {
                    let p = robot.position(nominal, joints, k);
                    [[p[0], p[1]], [m[0], m[1]]]
                };
                seen.map(place).collect()
            };
            if robot.has_assembly_modes() {
                let [here, mut other] = [&o.joints, &o.joints].map(Clone::clone);
                other.iter_mut().next_back().into_iter().for_each(|mode| *mode = -*mode);
                let [cost, other_cost] = [&here, &other].map(|joints| self.cost(&pairs(joints)));
                if other_cost < cost || cost.is_nan() {
                    o.joints = other;
                }
            }
            if back {
                o.targets.iter_mut().flatten().for_each(|p| *p = self.undo(*p));
            }
        }
    }

    /// The point that is moved to `p`.
    fn undo(&self, p: Vector) -> Vector {
        let (sin, cos) = self.angle.sin_cos();
        let [x, y] = [p[0] - self.shift[0], p[1] - self.shift[1]];
        [cos * x + sin * y, cos * y - sin * x, p[2]]
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
