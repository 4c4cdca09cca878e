//! Reachability of the places of a test within the limits of the robot file, with joint values.

use crate::iso9283::plan::{CommandedPose, CommandedPoses, TestPlan};
use etalon_base::angle::Turn;
use etalon_base::catalogue::Phrase;
use etalon_base::phrase;
use etalon_robots::{PlanarPose, Quantity, Robot};
use std::f64::consts::PI;

/// Joint values of the places of a plan.
#[derive(Clone, Debug, PartialEq)]
pub struct Reachability {
    /// Joint values at each place of each list, followed by the assembly mode if the robot has
    /// several; `None` if out of reach.
    pub joints: Vec<Vec<Option<Vec<f64>>>>,
    /// Places out of reach.
    pub unreached: Vec<Unreached>,
    /// `true` if all joints move between the poses P1 to P5, as the standard requires.
    pub all_move: bool,
}

/// A place that the robot does not reach.
#[derive(Clone, Debug, PartialEq)]
pub struct Unreached {
    /// Name of the list.
    pub places: String,
    /// Number of the point in the list, from 1.
    pub point: usize,
    /// Reason.
    pub reason: Phrase,
}

/// Error: the model of the robot does not provide its reachability.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct UnknownReachability;

/// Finds joint values of every place, and places that are out of reach with the reasons. Fails for
/// models whose inverse is not valid everywhere. With several working modes, one is kept along a
/// list: the one that reaches most of its places.
pub fn reachability(plan: &TestPlan, robot: &dyn Robot) -> Result<Reachability, UnknownReachability> {
    if robot.platform().is_none() && robot.inverse_all(&robot.nominal(), [0.0; 3]).is_none() {
        return Err(UnknownReachability);
    }
    let joints: Vec<_> = plan.places.iter().map(|places| way(robot, places)).collect();
    let mut unreached = Vec::new();
    for (places, way) in plan.places.iter().zip(&joints) {
        for (i, point) in places.points.iter().enumerate().filter(|(i, _)| way[*i].is_none()) {
            unreached.push(Unreached { places: places.name.to_owned(), point: i + 1, reason: reason(robot, point) });
        }
    }
    let all_move = joints.first().is_some_and(|poses| moves_all(robot, poses));
    Ok(Reachability { joints, unreached, all_move })
}

/// Joint values of all solutions for a place within the limits.
fn ways(robot: &dyn Robot, point: &CommandedPose) -> Vec<Vec<f64>> {
    let within = |q: &Vec<f64>| robot.limit_violation(&robot.nominal(), q).is_none();
    match robot.platform() {
        Some(_) => at_pose(robot, point).filter(within).into_iter().collect(),
        None => robot.inverse_all(&robot.nominal(), point.position_mm).unwrap_or_default(),
    }
}

/// Joint values of a platform at a place, independent of their limits.
fn at_pose(robot: &dyn Robot, point: &CommandedPose) -> Option<Vec<f64>> {
    let (platform, parameters) = (robot.platform()?, robot.nominal());
    let [x, y, _] = point.position_mm;
    let [x_mm, y_mm] = platform.in_base(&parameters, [x, y]);
    let theta_rad = point.angles_deg.last().copied().unwrap_or_default().to_radians();
    let q = platform.joints_at(&parameters, PlanarPose { x_mm, y_mm, theta_rad });
    q.iter().all(|v| v.is_finite()).then_some(q)
}

fn reason(robot: &dyn Robot, point: &CommandedPose) -> Phrase {
    let violation = at_pose(robot, point).and_then(|q| robot.limit_violation(&robot.nominal(), &q));
    violation.unwrap_or_else(|| phrase!("no-working-mode-reaches"))
}

/// Joint values along a list in a single working mode, from the initial solution that misses the
/// fewest places.
fn way(robot: &dyn Robot, places: &CommandedPoses) -> Vec<Option<Vec<f64>>> {
    let all: Vec<Vec<Vec<f64>>> = places.points.iter().map(|point| ways(robot, point)).collect();
    let starts = all.iter().find(|ways| !ways.is_empty()).cloned().unwrap_or_default();
    let follow = |start: Vec<f64>| -> Vec<Option<Vec<f64>>> {
        let mut last = start;
        let nearest = |ways: &Vec<Vec<f64>>| {
            let next = ways
                .iter()
                .min_by(|a, b| largest_difference(robot, a, &last).total_cmp(&largest_difference(robot, b, &last)));
            // the other mode is beyond a singularity
            let next = next.filter(|q| same_mode(robot, q, &last)).cloned();
            last = next.clone().unwrap_or_else(|| last.clone());
            next
        };
        all.iter().map(nearest).collect()
    };
    let missed = |way: &Vec<Option<Vec<f64>>>| way.iter().filter(|q| q.is_none()).count();
    starts.into_iter().map(follow).min_by_key(missed).unwrap_or_else(|| vec![None; all.len()])
}

/// Largest difference of a joint, with angles the shorter way.
fn largest_difference(robot: &dyn Robot, a: &[f64], b: &[f64]) -> f64 {
    let of = |(joint, (a, b)): (&etalon_robots::Joint, (&f64, &f64))| match joint.quantity {
        Quantity::Angle => Turn::RADIANS.difference(*a, *b).abs(),
        _ => (a - b).abs(),
    };
    robot.joints().iter().zip(a.iter().zip(b)).map(of).fold(0.0, f64::max)
}

/// `true` if a robot moves from one configuration to the other without changing its assembly mode
/// or folding over.
fn same_mode(robot: &dyn Robot, a: &[f64], b: &[f64]) -> bool {
    !robot.has_assembly_modes() || (a.last() == b.last() && largest_difference(robot, a, b) < PI / 2.0)
}

fn moves_all(robot: &dyn Robot, poses: &[Option<Vec<f64>>]) -> bool {
    let moves = |pair: &[Option<Vec<f64>>]| match pair {
        [Some(a), Some(b)] => robot.joints().iter().zip(a.iter().zip(b)).all(|(j, (a, b))| {
            let outward = |v: &f64| j.quantity.outward(*v);
            (outward(a) - outward(b)).abs() > 1e-6
        }),
        _ => false,
    };
    poses.windows(2).all(moves)
}
