//! A test by ISO 9283 laid into a workspace: what to command, and how often.

pub mod layout;
pub mod programme;
mod reach;

pub use reach::reach;

use crate::iso9283::plan::layout::{PLANES, layout};
use crate::iso9283::plan::programme::{LOADS_PERCENT, programme};
use etalon_base::message::{Message, Result};
use etalon_base::pose::Vector;
use etalon_documents::{Iso9283Places, Iso9283PlanDocument};
use std::collections::BTreeMap;

/// What the user states.
#[derive(Clone, Debug)]
pub struct Request {
    /// Smallest and largest corner of the workspace; of planar robots with the same z.
    pub workspace_mm: [Vector; 2],
    /// Name of the test plane, one of [`PLANES`]; planar robots have no choice.
    pub plane: Option<String>,
    /// Commanded angles a, b, c, of planar robots c alone; none where they are empty.
    pub orientation_deg: Vec<f64>,
    /// By how much they change along the path with reorientation; none where it is empty.
    pub reorientation_deg: Vec<f64>,
}

/// Coordinates of a commanded pose in the document.
const XYZ: [&str; 3] = ["x_mm", "y_mm", "z_mm"];

/// Angles of a commanded pose in the document.
const ANGLES: [&str; 3] = ["a_deg", "b_deg", "c_deg"];

/// Chords of a circle.
const CHORDS: usize = 72;

/// The test.
pub fn plan(request: &Request) -> Result<Iso9283PlanDocument> {
    let [low, high] = request.workspace_mm;
    let planar = low[2] == high[2];
    let number = plane(request.plane.as_deref(), planar)?;
    let angles: &[&str] = if planar { &ANGLES[2..] } else { &ANGLES };
    for (option, given) in [("orientation", &request.orientation_deg), ("reorientation", &request.reorientation_deg)] {
        if !(given.is_empty() || given.len() == angles.len()) || given.iter().any(|v| !v.is_finite()) {
            let message = Message::error(format!("the {option} has {} angles", given.len()));
            return Err(message.expected(angles.join(", ")).into());
        }
    }
    if request.orientation_deg.is_empty() && !request.reorientation_deg.is_empty() {
        let message = Message::error("a reorientation without an orientation to begin with");
        return Err(message.hint("state --orientation-deg as well").into());
    }
    let test = layout(low, high, number)?;
    let place = |p: Vector, turned: f64| {
        let position = XYZ.iter().take(if planar { 2 } else { 3 }).map(|name| name.to_string()).zip(p);
        let change = |k: usize| request.reorientation_deg.get(k).copied().unwrap_or_default();
        let turn = |(k, (name, angle)): (usize, (&&str, &f64))| (name.to_string(), angle + turned * change(k));
        let angles = angles.iter().zip(&request.orientation_deg).enumerate().map(turn);
        position.chain(angles).collect::<BTreeMap<String, f64>>()
    };
    let still = |name: &str, purpose: &str, points: Vec<Vector>| Iso9283Places {
        name: name.to_owned(),
        purpose: purpose.to_owned(),
        points: points.into_iter().map(|p| place(p, 0.0)).collect(),
        joints: Vec::new(),
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
        let purpose = "path accuracy on reorientation: P2 to P4, turned there and back".to_owned();
        places.push(Iso9283Places { name: "reorientation".to_owned(), purpose, points, joints: Vec::new() });
    }
    Ok(Iso9283PlanDocument {
        schema: "etalon/iso9283-plan/1".to_owned(),
        conventions: conventions(planar),
        side_mm: test.side_mm,
        test_plane: test.plane.map(|k| format!("C{}", k + 1)).join("-"),
        corners_mm: test.corners_mm,
        places,
        unreached: Vec::new(),
        programme: programme(),
        loads_percent: LOADS_PERCENT.to_vec(),
    })
}

fn plane(name: Option<&str>, planar: bool) -> Result<usize> {
    match name {
        Some(_) if planar => Err(Message::error("a planar robot has one test plane").hint("leave it out").into()),
        Some(name) => PLANES.iter().position(|(known, _)| *known == name).ok_or_else(|| {
            let message = Message::error(format!("`{name}` is not a test plane"));
            message.expected(PLANES.map(|(known, _)| known).join(", ")).into()
        }),
        None => Ok(0),
    }
}

fn conventions(planar: bool) -> Vec<String> {
    let cube = if planar { "square" } else { "cube" };
    vec![
        format!("the largest {cube} in the stated workspace, edges parallel to the axes; C1 to C4 from the smallest x and y"),
        "P1: centre; P2 to P5: 10 % of the diagonals from the corners of the test plane, in their order".to_owned(),
        "P1 to P5, loads, velocities and 30 cycles follow the standard's text; paths, other counts and the order of the \
         corners were not compared with a bought copy"
            .to_owned(),
        "whether all joints move between poses, and whether the robot reaches them, was not looked at".to_owned(),
    ]
}
