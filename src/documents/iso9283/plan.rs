//! Plan of a test (ISO 9283:1998 6).

use super::all;
use crate::mirror::mirror;
use crate::worded::worded;
use etalon_base::catalogue::Phrase;
use etalon_base::phrase;
use etalon_base::pose::Vector;
use etalon_base::worded::Worded;
use etalon_robots::Robot;
use etalon_standards::iso9283::plan::programme::{Item, LOADS_PERCENT, programme};
use etalon_standards::iso9283::plan::{CommandedPose, CommandedPoses, Reachability, TestPlan, Unreached};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Layout of a test to ISO 9283:1998 in a workspace.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283PlanDocument {
    /// Schema and version: `etalon/iso9283-plan/1`.
    pub schema: String,
    /// Choices made, and clauses that are not verified against the standard, in words.
    #[serde(flatten, with = "Iso9283PlanConventions")]
    pub conventions: Vec<Worded>,
    /// Side of the cube; for planar robots, of the square.
    pub side_mm: f64,
    /// Corners C1 to C8; for planar robots, C1 to C4.
    pub corners_mm: Vec<Vector>,
    /// Corners of the test plane.
    pub test_plane: String,
    /// Named lists of places to visit in order: `poses` (P1 to P5), `linear`, `circle-large`, ...
    pub places: Vec<Iso9283Places>,
    /// Places that the given robot does not reach.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub unreached: Vec<Iso9283Unreached>,
    /// Test programme: one line for each characteristic.
    pub programme: Vec<Iso9283Item>,
    /// Loads (% of the rated load); the first is mandatory.
    pub loads_percent: Vec<u32>,
}

worded! {
    /// Choices made, and clauses that are not verified against the standard, in words.
    list Iso9283PlanConventions: conventions, convention_phrases
}

/// A list of poses, or a path.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283Places {
    /// Name of the list, and of its files.
    pub name: String,
    /// Purpose of the list.
    pub purpose: String,
    /// Coordinates of each place, numbered from 1: `x_mm`, `y_mm` and, if applicable, `z_mm`,
    /// `a_deg`, `b_deg`, `c_deg`.
    pub points: Vec<BTreeMap<String, f64>>,
    /// Joint values at each place if a robot is given; null if out of reach.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub joints: Vec<Option<BTreeMap<String, f64>>>,
}

mirror! {
    /// A place that the given robot does not reach.
    struct Iso9283Unreached of Unreached as unreached {
        /// Name of the list.
        places: String,
        /// Number of the point in the list, from 1.
        point: usize,
        /// Reason.
        #[serde(flatten, with = "Iso9283UnreachedReason")]
        reason: Worded,
    }
}

worded! {
    /// Reason.
    text Iso9283UnreachedReason: reason, reason_phrase
}

mirror! {
    /// One line of the test programme.
    struct Iso9283Item of Item {
        /// Tested characteristic.
        characteristic: String,
        /// Clause of the standard.
        clause: String,
        /// Poses of a cycle in order, or the path.
        visits: String,
        /// Velocities (% of the rated velocity).
        velocities_percent: Vec<u32>,
        /// Number of cycles for each velocity.
        cycles: u32,
        /// `true` if the line was verified against the standard's text, `false` if it is general
        /// knowledge.
        read: bool,
    }
}

/// Names of the coordinates and angles of a commanded pose.
const XYZ: [&str; 3] = ["x_mm", "y_mm", "z_mm"];
const ANGLES: [&str; 3] = ["a_deg", "b_deg", "c_deg"];
/// Name of the assembly mode among joint values.
const ASSEMBLY: &str = "assembly";

impl Iso9283PlanDocument {
    /// Creates the document of a plan, with joint values if a robot is given.
    pub fn new(plan: &TestPlan, reached: Option<(&dyn Robot, &Reachability)>) -> Self {
        let joints = |i: usize| match reached {
            Some((robot, reach)) => reach.joints[i].iter().map(|q| q.as_ref().map(|q| named(robot, q))).collect(),
            None => Vec::new(),
        };
        let places = |(i, places): (usize, &CommandedPoses)| Iso9283Places {
            name: places.name.to_owned(),
            purpose: places.purpose.to_owned(),
            points: places.points.iter().map(|place| columns(place, plan.planar)).collect(),
            joints: joints(i),
        };
        let reach = reached.map(|(_, reach)| reach);
        let conventions = conventions(plan.planar, reach);
        Self {
            schema: "etalon/iso9283-plan/1".to_owned(),
            conventions: all(conventions),
            side_mm: plan.layout.side_mm,
            test_plane: plan.layout.plane.map(|k| format!("C{}", k + 1)).join("-"),
            corners_mm: plan.layout.corners_mm.clone(),
            places: plan.places.iter().enumerate().map(places).collect(),
            unreached: reach.iter().flat_map(|reach| &reach.unreached).cloned().map(Into::into).collect(),
            programme: all(programme()),
            loads_percent: LOADS_PERCENT.to_vec(),
        }
    }
}

/// Coordinates and angles of a place, by column name.
fn columns(place: &CommandedPose, planar: bool) -> BTreeMap<String, f64> {
    let (axes, angles) = if planar { (&XYZ[..2], &ANGLES[2..]) } else { (&XYZ[..], &ANGLES[..]) };
    let position = axes.iter().zip(place.position_mm);
    let angles = angles.iter().zip(place.angles_deg.iter().copied());
    position.chain(angles).map(|(name, value)| ((*name).to_owned(), value)).collect()
}

/// Joint values by column name.
fn named(robot: &dyn Robot, q: &[f64]) -> BTreeMap<String, f64> {
    let joints = robot.joints().iter().zip(q).map(|(j, v)| (j.column(), j.quantity.outward(*v)));
    let assembly = q.get(robot.joints().len()).map(|mode| (ASSEMBLY.to_owned(), *mode));
    joints.chain(assembly).collect()
}

fn conventions(planar: bool, reach: Option<&Reachability>) -> Vec<Phrase> {
    let shape = if planar { "square" } else { "cube" };
    vec![
        phrase!("plan-cube", shape),
        phrase!("plan-poses"),
        phrase!("plan-clauses"),
        match reach {
            None => phrase!("plan-reach-not-examined"),
            Some(reach) => phrase!("plan-reach", moves = if reach.all_move { "all" } else { "some" }),
        },
    ]
}
