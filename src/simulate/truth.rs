//! What is true in a simulation, and what is measured.

use super::setup::Setup;
use etalon_base::bounds::{MOST, at_most, product_at_most};
use etalon_base::error;
use etalon_base::files;
use etalon_base::message::{Place, Result};
use etalon_base::noise::Noise;
use etalon_base::pose::Vector;
use etalon_campaign::parse;
use etalon_robots::{PlanarPose, Robot};
use schemars::JsonSchema;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::Path;

/// Stream of the noise of drawn poses: no file has it.
const DRAWN: u64 = 1 << 40;
/// How often joint values are drawn that the robot cannot reach.
const ATTEMPTS: u64 = 1000;

/// `truth.toml`: what is true, and what is measured.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Truth {
    /// Seed of the noise.
    pub seed: u64,
    /// Repeats of every pose.
    #[serde(deserialize_with = "at_most::<_, _, MOST>")]
    pub cycles: i64,
    /// Gaussian noise of one coordinate (one standard deviation); by default the instrument's standard uncertainty. Over that it scales the
    /// noise of a whole table of observations: 0 is a table without noise.
    pub noise_um: Option<f64>,
    /// Gaussian noise with which a coordinate of a labelled point is found again; by default that of the contact.
    pub contact_um: Option<f64>,
    /// What columns hold that import skips, in their order; `-` where it is not stated.
    #[serde(default)]
    pub skipped: Vec<String>,
    /// Digits after the decimal mark in the exports.
    #[serde(default = "six")]
    pub decimals: usize,
    /// Height of the targets of a planar robot above the plane.
    #[serde(default)]
    pub target_height_mm: f64,
    /// Where the world is in the coordinates of the exports: there if absent, as tables of observations are in the world.
    #[serde(default)]
    pub export_T_world: Placement,
    /// True parameters by name, in mm, deg and 1; those not given are nominal.
    pub parameters: BTreeMap<String, f64>,
    /// Points of features, in the world.
    #[serde(default, rename = "point")]
    pub points: Vec<LabelledPoint>,
    /// The export that the geometric calibration goes to.
    pub geometric_export: Option<String>,
    /// Balls, shaft and carriages of the geometric calibration (thesis, chapter 2).
    pub geometric: Option<Setup>,
    /// How the robot repeats where a trajectory visits its poses again and again.
    pub repeatability: Option<super::Repeating>,
    /// Errors that no parameter describes; without them errors after calibration come out too good.
    pub unmodelled: Option<super::Unmodelled>,
    /// Rows of a table of observations at poses.
    #[serde(default)]
    pub observe: Vec<super::Observe>,
    /// Rows of a table of observations about fixed things.
    #[serde(default)]
    pub known: Vec<super::KnownRow>,
    /// Poses, numbered from 1 in the order given.
    pub poses: Vec<Poses>,
}

impl Truth {
    /// Reads `truth.toml`.
    pub fn read(path: &Path) -> Result<Self> {
        let file = path.display().to_string();
        let truth: Self = parse(&file, &files::read_text(path)?)?;
        truth.bounded().map_err(|problems| problems.at(&Place::file(file)))?;
        Ok(truth)
    }

    /// Checks that the counts together are not too many.
    fn bounded(&self) -> Result<()> {
        let sum = |counts: &mut dyn Iterator<Item = u64>| counts.fold(0u64, u64::saturating_add);
        let counts = [
            ("poses", sum(&mut self.poses.iter().map(|poses| poses.count() as u64))),
            ("cycles", self.cycles.max(0) as u64),
        ];
        product_at_most("poses to simulate", &counts, MOST)?;
        let repeats = sum(&mut self.points.iter().map(|point| point.repeats as u64));
        product_at_most("points to simulate", &[("repeats of [[point]]", repeats)], MOST)
    }
}

fn six() -> usize {
    6
}

/// Position and orientation (Rz Ry Rx).
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Placement {
    /// Position.
    pub xyz_mm: Vector,
    /// Angles about x, y, z.
    pub rpy_deg: Vector,
}

/// A point of a feature.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LabelledPoint {
    /// Its label.
    pub label: String,
    /// The export it goes to.
    pub export: String,
    /// Where it is in the world.
    pub at_mm: Vector,
    /// How often it is measured.
    #[serde(default = "once", deserialize_with = "at_most::<_, _, MOST>")]
    pub repeats: usize,
}

fn once() -> usize {
    1
}

/// A set of poses.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Poses {
    /// The labelled point that the tool stands on; `joints` then state which way it is reached, and the log what the encoders
    /// state of it.
    pub label: Option<String>,
    /// Joint values in mm or deg.
    #[serde(default)]
    pub joints: Vec<Vec<f64>>,
    /// Circles of platform positions in the base frame, commanded through the nominal inverse kinematics.
    #[serde(default)]
    pub circles: Vec<Circle>,
    /// Orientations at each of those positions.
    #[serde(default)]
    pub theta_deg: Vec<f64>,
    /// Joint values that are drawn.
    pub drawn: Option<Drawn>,
}

/// Poses whose joint values are drawn, evenly and each by itself, with the seed; where a pose touches something, they are drawn until they
/// come there.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Drawn {
    /// Number of poses.
    #[serde(deserialize_with = "at_most::<_, _, MOST>")]
    pub count: usize,
    /// Least joint values in mm or deg.
    pub from: Vec<f64>,
    /// Greatest ones.
    pub to: Vec<f64>,
}

/// Positions spread evenly on a circle, from its +x side counterclockwise.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Circle {
    /// Centre.
    pub center_mm: [f64; 2],
    /// Diameter.
    pub diameter_mm: f64,
    /// Number of positions.
    #[serde(deserialize_with = "at_most::<_, _, MOST>")]
    pub count: usize,
}

impl Circle {
    pub(super) fn positions(self) -> impl Iterator<Item = [f64; 2]> {
        let radius = 0.5 * self.diameter_mm;
        (0..self.count).map(move |i| {
            let angle = std::f64::consts::TAU * i as f64 / self.count as f64;
            [self.center_mm[0] + radius * angle.cos(), self.center_mm[1] + radius * angle.sin()]
        })
    }
}

/// Joint values in mm or deg, and the assembly mode behind them of robots that have several, in mm and rad.
pub(super) fn stated_joints(robot: &dyn Robot, q: &[f64]) -> Result<Vec<f64>> {
    let count = robot.joints().len() + usize::from(robot.has_assembly_modes());
    if q.len() != count {
        return Err(error!("truth-joint-count", values = q.len(), joints = count).into());
    }
    let inward = |(i, q): (usize, &f64)| robot.joints().get(i).map_or(*q, |j| j.quantity.inward(*q));
    Ok(q.iter().enumerate().map(inward).collect())
}

impl Poses {
    /// Number of poses.
    fn count(&self) -> usize {
        let drawn = self.drawn.as_ref().map_or(0, |drawn| drawn.count);
        let of_circles = self.circles.iter().map(|c| c.count.saturating_mul(self.theta_deg.len()));
        of_circles.fold(drawn.saturating_add(self.joints.len()), usize::saturating_add)
    }
}

impl Truth {
    /// Label of the point that the tool stands on at a pose, numbered from 1.
    pub(super) fn label_of(&self, pose: i64) -> Option<&str> {
        let mut labels = self.poses.iter().flat_map(|p| std::iter::repeat_n(p.label.as_deref(), p.count()));
        labels.nth(pose.max(1) as usize - 1).flatten()
    }

    /// The point that the tool stands on at each pose, where that is stated.
    pub(super) fn stands(&self) -> Result<Vec<Option<Vector>>> {
        let mut all = Vec::new();
        for poses in &self.poses {
            let at = match &poses.label {
                None => None,
                Some(_) if !poses.circles.is_empty() => {
                    return Err(error!("truth-label-with-circles").into());
                }
                Some(label) => {
                    Some(self.points.iter().find(|p| p.label == *label).map(|p| p.at_mm).ok_or_else(|| {
                        error!("truth-point-unknown", label)
                            .hint_names(label, self.points.iter().map(|p| p.label.as_str()))
                    })?)
                }
            };
            all.resize(all.len() + poses.count(), at);
        }
        Ok(all)
    }

    /// Number of poses.
    pub(super) fn pose_count(&self) -> usize {
        self.poses.iter().map(Poses::count).sum()
    }

    /// The range that a pose, numbered from 0, is drawn from.
    fn range(&self, mut pose: usize) -> Option<&Drawn> {
        for poses in &self.poses {
            let before = poses.count() - poses.drawn.as_ref().map_or(0, |drawn| drawn.count);
            if pose < poses.count() {
                return poses.drawn.as_ref().filter(|_| pose >= before);
            }
            pose -= poses.count();
        }
        None
    }

    /// Whether a pose, numbered from 0, is drawn.
    pub(super) fn is_drawn(&self, pose: usize) -> bool {
        self.range(pose).is_some()
    }

    /// Joint values of a pose, numbered from 0, in mm and rad; those of another attempt are others.
    pub(super) fn drawn(&self, robot: &dyn Robot, pose: usize, attempt: u64) -> Result<Vec<f64>> {
        let Some(range) = self.range(pose) else { return Ok(Vec::new()) };
        let (from, to) = (stated_joints(robot, &range.from)?, stated_joints(robot, &range.to)?);
        let mut noise = Noise::new(self.seed, DRAWN + ((pose as u64) << 20) + attempt);
        Ok(from.iter().zip(&to).map(|(a, b)| 0.5 * (a + b) + noise.uniform(0.5 * (b - a))).collect())
    }

    /// Whether joint values, in mm and rad, are in the range that the pose is drawn from.
    pub(super) fn is_within(&self, robot: &dyn Robot, pose: usize, q: &[f64]) -> bool {
        let Some(range) = self.range(pose) else { return true };
        let ends = stated_joints(robot, &range.from).ok().zip(stated_joints(robot, &range.to).ok());
        ends.is_some_and(|(from, to)| (0..q.len()).all(|j| from[j] <= q[j] && q[j] <= to[j]))
    }

    /// Joint values of all poses, in mm and rad; `values` are the true parameters.
    pub(super) fn joint_values(&self, robot: &dyn Robot, values: &[f64]) -> Result<Vec<Vec<f64>>> {
        let mut all = Vec::new();
        for poses in &self.poses {
            for q in &poses.joints {
                all.push(stated_joints(robot, q)?);
            }
            for circle in &poses.circles {
                let platform = robot.platform().ok_or_else(|| error!("truth-circles-not-planar"))?;
                for [x_mm, y_mm] in circle.positions() {
                    for theta in &poses.theta_deg {
                        let pose = PlanarPose { x_mm, y_mm, theta_rad: theta.to_radians() };
                        // what a controller logs: rounded to 0.1 um
                        let q = platform.joints_at(&robot.nominal(), pose);
                        all.push(q.iter().map(|q| (q * 1e4).round() / 1e4).collect());
                    }
                }
            }
            for _ in 0..poses.drawn.as_ref().map_or(0, |drawn| drawn.count) {
                let draw = |attempt: u64| self.drawn(robot, all.len(), attempt);
                let first = draw(0)?;
                let reachable = |q: &Vec<f64>| robot.limit_violation(values, q).is_none();
                let q = (0..ATTEMPTS).filter_map(|attempt| draw(attempt).ok()).find(reachable);
                all.push(q.unwrap_or(first));
            }
        }
        Ok(all)
    }
}

/// Values of all parameters of `robot`, in mm, rad and 1, from those given by name in mm, deg and 1; others are nominal.
pub fn true_values(robot: &dyn Robot, given: &BTreeMap<String, f64>) -> Result<Vec<f64>> {
    let mut values = robot.nominal();
    for (name, value) in given {
        let names = robot.parameters().iter().map(|p| p.name.as_str());
        let i = robot
            .index(name)
            .ok_or_else(|| error!("truth-parameter-unknown", parameter = name).hint_names(name, names))?;
        values[i] = robot.parameters()[i].quantity.inward(*value);
    }
    Ok(values)
}
