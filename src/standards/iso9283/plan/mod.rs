//! Layout of a test to ISO 9283 in a workspace: poses to command and number of cycles.

pub mod layout;
pub mod programme;
mod reachability;

pub use reachability::{Reachability, UnknownReachability, Unreached, reachability};

use crate::iso9283::plan::layout::{Layout, PLANES, layout};
use etalon_base::error;
use etalon_base::message::{Problems, Result};
use etalon_base::pose::Vector;

/// User's request for a test.
#[derive(Clone, Debug)]
pub struct TestRequest {
    /// Smallest and largest corner of the workspace; for planar robots with equal z.
    pub workspace_mm: [Vector; 2],
    /// Name of the test plane, one of [`PLANES`]; not applicable to planar robots.
    pub plane: Option<String>,
    /// Commanded angles a, b, c; for planar robots c alone; empty if no angles are commanded.
    pub orientation_deg: Vec<f64>,
    /// Change of the angles along the path with reorientation; empty if there is no such path.
    pub reorientation_deg: Vec<f64>,
}

/// A test laid out in a workspace.
#[derive(Clone, Debug, PartialEq)]
pub struct TestPlan {
    /// `true` for planar robots, which have neither z nor angles a and b.
    pub planar: bool,
    /// Cube, test plane and poses.
    pub layout: Layout,
    /// Lists of places to visit.
    pub places: Vec<CommandedPoses>,
}

/// A list of poses, or a path.
#[derive(Clone, Debug, PartialEq)]
pub struct CommandedPoses {
    /// Name of the list.
    pub name: &'static str,
    /// Characteristics for which the list is used.
    pub purpose: &'static str,
    /// Places in order.
    pub points: Vec<CommandedPose>,
}

/// Commanded pose.
#[derive(Clone, Debug, PartialEq)]
pub struct CommandedPose {
    /// Position; z is zero for planar robots.
    pub position_mm: Vector,
    /// Angles a, b, c; for planar robots c alone; empty if not given.
    pub angles_deg: Vec<f64>,
}

/// Names of the angles of a commanded pose.
const ANGLES: [&str; 3] = ["a_deg", "b_deg", "c_deg"];
/// Number of chords of a circle.
const CHORDS: usize = 72;

/// Reason why a test cannot be laid out.
#[derive(Clone, Debug)]
pub enum PlanError {
    /// Angles change along the path, but the orientation is not given.
    ReorientationAlone,
    /// The request cannot be met.
    Other(Problems),
}

impl From<Problems> for PlanError {
    fn from(problems: Problems) -> Self {
        Self::Other(problems)
    }
}

/// Lays out the test.
pub fn plan(request: &TestRequest) -> std::result::Result<TestPlan, PlanError> {
    let [low, high] = request.workspace_mm;
    let planar = low[2] == high[2];
    let number = plane(request.plane.as_deref(), planar)?;
    let angles: &[&str] = if planar { &ANGLES[2..] } else { &ANGLES };
    for (option, given) in [("orientation", &request.orientation_deg), ("reorientation", &request.reorientation_deg)] {
        if !(given.is_empty() || given.len() == angles.len()) || given.iter().any(|v| !v.is_finite()) {
            return Err(Problems::from(error!("angle-count", option, count = given.len(), angles)).into());
        }
    }
    if request.orientation_deg.is_empty() && !request.reorientation_deg.is_empty() {
        return Err(PlanError::ReorientationAlone);
    }
    let test = layout(low, high, number)?;
    let place = |p: Vector, turned: f64| {
        let change = |k: usize| request.reorientation_deg.get(k).copied().unwrap_or_default();
        let turn = |(k, angle): (usize, &f64)| angle + turned * change(k);
        let angles_deg = request.orientation_deg.iter().enumerate().map(turn).collect();
        CommandedPose { position_mm: if planar { [p[0], p[1], 0.0] } else { p }, angles_deg }
    };
    let still = |name, purpose, points: Vec<Vector>| {
        let points = points.into_iter().map(|p| place(p, 0.0)).collect();
        CommandedPoses { name, purpose, points }
    };
    let [large, small] = test.circles(CHORDS);
    let mut places = vec![
        still("poses", "P1 to P5", test.poses_mm.to_vec()),
        still("linear", "path accuracy, repeatability and velocity: P2 to P4", test.linear()),
        still("circle-large", "the same on a circle of 80 % of the side", large),
        still("circle-small", "the same on a circle of 10 % of that", small),
        still("rectangle", "cornering: E1 to E4 and back to E1", test.rectangle()),
        still("posing", "minimum posing time: steps along the diagonal", test.posing()),
    ];
    if !request.reorientation_deg.is_empty() {
        let [from, to] = [test.poses_mm[1], test.poses_mm[3]];
        let at = |(share, turned): (f64, f64)| place([0, 1, 2].map(|k| from[k] + share * (to[k] - from[k])), turned);
        let points = [(0.0, 0.0), (0.25, 1.0), (0.5, 0.0), (0.75, -1.0), (1.0, 0.0)].map(at).to_vec();
        let purpose = "path accuracy on reorientation: P2 to P4, turned there and back";
        places.push(CommandedPoses { name: "reorientation", purpose, points });
    }
    Ok(TestPlan { planar, layout: test, places })
}

fn plane(name: Option<&str>, planar: bool) -> Result<usize> {
    match name {
        Some(_) if planar => Err(error!("planar-test-plane").into()),
        Some(name) => PLANES
            .iter()
            .position(|(known, _)| *known == name)
            .ok_or_else(|| error!("test-plane-unknown", name, planes = PLANES.map(|(known, _)| known)).into()),
        None => Ok(0),
    }
}
