//! Whether a robot reaches the places of a test, within what its file states, and with which joint values.

use etalon_base::message::{Message, Result};
use etalon_base::pose::Vector;
use etalon_documents::{Iso9283Places, Iso9283PlanDocument, Iso9283Unreached};
use etalon_robots::{PlanarPose, Quantity, Robot};
use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};

/// Name of the assembly mode beside joint values.
const ASSEMBLY: &str = "assembly";

/// Fills in joint values of every place, and which places are not reached and why. Models without an inverse that holds
/// everywhere are refused.
pub fn reach(document: &mut Iso9283PlanDocument, robot: &dyn Robot) -> Result<()> {
    if robot.platform().is_none() && robot.inverse_all(&robot.nominal(), [0.0; 3]).is_none() {
        let message =
            Message::error(format!("what a robot of model `{}` reaches its file does not state", robot.model()));
        return Err(message.hint("leave --robot out, and try the places on the robot at low speed").into());
    }
    let mut unreached = Vec::new();
    for places in &mut document.places {
        let way = way(robot, places);
        for (i, (joints, point)) in way.iter().zip(&places.points).enumerate() {
            if joints.is_none() {
                let (places, reason) = (places.name.clone(), reason(robot, point));
                unreached.push(Iso9283Unreached { places, point: i + 1, reason });
            }
        }
        places.joints = way.iter().map(|q| q.as_ref().map(|q| named(robot, q))).collect();
    }
    document.conventions.pop();
    document.conventions.push(format!(
        "reach: nominal parameters and the limits of the robot file; of several working modes one is kept along a list, the one that \
         reaches most of it; {}",
        match document.places.iter().any(|p| p.name == "poses" && moves_all(robot, p)) {
            true => "all joints move between P1 to P5",
            false => "not all joints move between P1 to P5, as the standard asks",
        }
    ));
    document.unreached = unreached;
    Ok(())
}

/// Joint values of every way to a place that is within the limits.
fn ways(robot: &dyn Robot, point: &BTreeMap<String, f64>) -> Vec<Vec<f64>> {
    let within = |q: &Vec<f64>| robot.limit_violation(&robot.nominal(), q).is_none();
    match robot.platform() {
        Some(_) => at_pose(robot, point).filter(within).into_iter().collect(),
        None => robot.inverse_all(&robot.nominal(), position(point)).unwrap_or_default(),
    }
}

/// Joint values that bring a platform to a place, whatever their limits.
fn at_pose(robot: &dyn Robot, point: &BTreeMap<String, f64>) -> Option<Vec<f64>> {
    let (platform, parameters) = (robot.platform()?, robot.nominal());
    let [x, y, _] = position(point);
    let [x_mm, y_mm] = platform.in_base(&parameters, [x, y]);
    let theta_rad = point.get("c_deg").copied().unwrap_or_default().to_radians();
    let q = platform.joints_at(&parameters, PlanarPose { x_mm, y_mm, theta_rad });
    q.iter().all(|v| v.is_finite()).then_some(q)
}

fn position(point: &BTreeMap<String, f64>) -> Vector {
    ["x_mm", "y_mm", "z_mm"].map(|name| point.get(name).copied().unwrap_or_default())
}

fn reason(robot: &dyn Robot, point: &BTreeMap<String, f64>) -> String {
    let violation = at_pose(robot, point).and_then(|q| robot.limit_violation(&robot.nominal(), &q));
    violation.unwrap_or_else(|| "no working mode reaches it within the limits".to_owned())
}

/// Joint values along a list without leaving the working mode: of all ways to begin the one that misses least.
fn way(robot: &dyn Robot, places: &Iso9283Places) -> Vec<Option<Vec<f64>>> {
    let all: Vec<Vec<Vec<f64>>> = places.points.iter().map(|point| ways(robot, point)).collect();
    let starts = all.iter().find(|ways| !ways.is_empty()).cloned().unwrap_or_default();
    let follow = |start: Vec<f64>| -> Vec<Option<Vec<f64>>> {
        let mut last = start;
        let nearest = |ways: &Vec<Vec<f64>>| {
            let next = ways.iter().min_by(|a, b| apart(robot, a, &last).total_cmp(&apart(robot, b, &last)));
            // the other mode is another robot: it is reached through a singularity
            let next = next.filter(|q| same_mode(robot, q, &last)).cloned();
            last = next.clone().unwrap_or_else(|| last.clone());
            next
        };
        all.iter().map(nearest).collect()
    };
    let missed = |way: &Vec<Option<Vec<f64>>>| way.iter().filter(|q| q.is_none()).count();
    starts.into_iter().map(follow).min_by_key(missed).unwrap_or_else(|| vec![None; all.len()])
}

/// The largest difference of a joint, angles the shorter way round.
fn apart(robot: &dyn Robot, a: &[f64], b: &[f64]) -> f64 {
    let of = |(joint, (a, b)): (&etalon_robots::Joint, (&f64, &f64))| match joint.quantity {
        Quantity::Angle => ((a - b) - TAU * ((a - b) / TAU).round()).abs(),
        _ => (a - b).abs(),
    };
    robot.joints().iter().zip(a.iter().zip(b)).map(of).fold(0.0, f64::max)
}

/// Whether a robot gets from one to the other without changing its assembly mode or folding over.
fn same_mode(robot: &dyn Robot, a: &[f64], b: &[f64]) -> bool {
    !robot.has_assembly_modes() || (a.last() == b.last() && apart(robot, a, b) < PI / 2.0)
}

fn moves_all(robot: &dyn Robot, poses: &Iso9283Places) -> bool {
    let moves = |pair: &[Option<BTreeMap<String, f64>>]| match pair {
        [Some(a), Some(b)] => robot.joints().iter().all(|j| {
            let name = j.column();
            a.get(&name).zip(b.get(&name)).is_some_and(|(a, b)| (a - b).abs() > 1e-6)
        }),
        _ => false,
    };
    poses.joints.windows(2).all(moves)
}

fn named(robot: &dyn Robot, q: &[f64]) -> BTreeMap<String, f64> {
    let joints = robot.joints().iter().zip(q).map(|(j, v)| (j.column(), j.quantity.outward(*v)));
    let assembly = q.get(robot.joints().len()).map(|mode| (ASSEMBLY.to_owned(), *mode));
    joints.chain(assembly).collect()
}
