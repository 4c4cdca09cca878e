//! Truth of a simulation, and its measurements.

use super::setup::Setup;
use etalon_base::bounds::{MOST, at_most, product_at_most};
use etalon_base::files;
use etalon_base::message::{Place, Result};
use etalon_base::noise::Noise;
use etalon_base::pose::Vector;
use etalon_base::{error, phrase};
use etalon_campaign::{parse, schema};
use etalon_robots::{Circumstance, PlanarPose, Robot};
use schemars::JsonSchema;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::Path;

/// Stream of the noise of drawn poses, distinct from the streams of files.
const DRAWN: u64 = 1 << 40;
/// Maximum number of draws for joint values that the robot cannot reach.
const ATTEMPTS: u64 = 1000;
/// Temperature of the robot (°C) if none is given.
const USUAL_C: f64 = 20.0;

/// `truth.toml`: true robot, and its measurements.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Truth {
    /// Seed of the noise.
    pub seed: u64,
    /// Number of repeats of every pose.
    #[serde(deserialize_with = "at_most::<_, _, MOST>")]
    pub cycles: i64,
    /// Gaussian noise of one coordinate (one standard deviation); the instrument's standard
    /// uncertainty by default. The ratio to that uncertainty scales the noise of a whole table of
    /// observations; 0 gives a table without noise.
    pub noise_um: Option<f64>,
    /// Gaussian noise of a coordinate when a labelled point is touched again; the noise of the
    /// contact by default.
    pub contact_um: Option<f64>,
    /// Contents of columns that import skips, in their order; `-` if not given.
    #[serde(default)]
    pub skipped: Vec<String>,
    /// Number of decimals in the exports.
    #[serde(default = "six")]
    pub decimals: usize,
    /// Height of the targets of a planar robot above the plane.
    #[serde(default)]
    pub target_height_mm: f64,
    /// Pose of the world in the coordinates of the exports; the identity if absent, as tables of
    /// observations are in the world.
    #[serde(default)]
    pub export_T_world: Placement,
    /// True parameters by name (mm, deg or 1); other parameters are nominal.
    pub parameters: BTreeMap<String, f64>,
    /// Points of features in the world.
    #[serde(default, rename = "point")]
    pub points: Vec<LabelledPoint>,
    /// Export of the geometric calibration.
    pub geometric_export: Option<String>,
    /// Balls, shaft and carriages of the geometric calibration (thesis, chapter 2).
    pub geometric: Option<Setup>,
    /// Repeatability of the robot when a trajectory visits its poses repeatedly.
    pub repeatability: Option<super::Repeating>,
    /// Errors that no parameter describes; without them the errors after calibration are too small.
    pub unmodelled: Option<super::Unmodelled>,
    /// Torques of the joints, for a robot with `torque`.
    #[serde(default)]
    pub torques: super::Torques,
    /// Rows of a table of observations at poses.
    #[serde(default)]
    pub observe: Vec<super::Observe>,
    /// Rows of a table of observations about fixed objects.
    #[serde(default)]
    pub known: Vec<super::KnownRow>,
    /// Poses, numbered from 1 in the given order.
    pub poses: Vec<Poses>,
}

impl Truth {
    /// Reads `truth.toml`.
    pub fn read(path: &Path) -> Result<Self> {
        let file = path.display().to_string();
        let truth: Self = parse(&file, &files::read_text(path)?, &schema("truth.toml", super::SCHEMAS))?;
        truth.bounded().map_err(|problems| problems.at(&Place::file(file)))?;
        Ok(truth)
    }

    /// Checks that the counts together are not too large.
    fn bounded(&self) -> Result<()> {
        let sum = |counts: &mut dyn Iterator<Item = u64>| counts.fold(0u64, u64::saturating_add);
        let counts = [
            ("poses", sum(&mut self.poses.iter().map(|poses| poses.count() as u64))),
            ("cycles", self.cycles.max(0) as u64),
        ];
        product_at_most(phrase!("poses-to-simulate"), &counts, MOST)?;
        let repeats = sum(&mut self.points.iter().map(|point| point.repeats as u64));
        product_at_most(phrase!("points-to-simulate"), &[("repeats", repeats)], MOST)
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
    /// Label of the point.
    pub label: String,
    /// Export of the point.
    pub export: String,
    /// Position in the world.
    pub at_mm: Vector,
    /// Number of measurements.
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
    /// Labelled point on which the tool stands. The key `joints` then selects the solution, and the
    /// log contains the encoder values at the point.
    pub label: Option<String>,
    /// Joint values (mm or deg).
    #[serde(default)]
    pub joints: Vec<Vec<f64>>,
    /// Circles of platform positions in the base frame, commanded through the nominal inverse
    /// kinematics.
    #[serde(default)]
    pub circles: Vec<Circle>,
    /// Orientations at each position of the circles.
    #[serde(default)]
    pub theta_deg: Vec<f64>,
    /// Random joint values.
    pub drawn: Option<Drawn>,
    /// Payload at these poses, for a robot with `payload` or `torque`; none by default.
    pub load: Option<Payload>,
    /// Temperature of the robot at the first and the last of these poses, for a robot with `drift`
    /// or `expansion`; it changes evenly. 20 °C by default.
    pub temperature_c: Option<[f64; 2]>,
}

/// Payload of the robot.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Payload {
    /// Mass.
    pub kg: f64,
    /// Centre of mass in the flange.
    pub xyz_mm: Vector,
}

/// Poses with uniformly distributed, independent random joint values; a pose with contacts is drawn
/// again until the joints reach them.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Drawn {
    /// Number of poses.
    #[serde(deserialize_with = "at_most::<_, _, MOST>")]
    pub count: usize,
    /// Smallest joint values (mm or deg).
    pub from: Vec<f64>,
    /// Largest joint values (mm or deg).
    pub to: Vec<f64>,
}

/// Positions evenly spread on a circle, counterclockwise from its +x side.
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

/// Converts joint values from mm and deg to mm and rad; for robots with several assembly modes, the
/// mode follows.
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
    /// Label of the point on which the tool stands at a pose, numbered from 1.
    pub(super) fn label_at_pose(&self, pose: i64) -> Option<&str> {
        let mut labels = self.poses.iter().flat_map(|p| std::iter::repeat_n(p.label.as_deref(), p.count()));
        labels.nth(pose.max(1) as usize - 1).flatten()
    }

    /// Point on which the tool stands at each pose, if given.
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

    /// Range of the random joint values of a pose, numbered from 0.
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

    /// `true` if the joint values of a pose, numbered from 0, are random.
    pub(super) fn is_drawn(&self, pose: usize) -> bool {
        self.range(pose).is_some()
    }

    /// Random joint values of a pose, numbered from 0 (mm or rad); each attempt gives different
    /// values.
    pub(super) fn drawn(&self, robot: &dyn Robot, pose: usize, attempt: u64) -> Result<Vec<f64>> {
        let Some(range) = self.range(pose) else { return Ok(Vec::new()) };
        let (from, to) = (stated_joints(robot, &range.from)?, stated_joints(robot, &range.to)?);
        let mut noise = Noise::new(self.seed, DRAWN + ((pose as u64) << 20) + attempt);
        let drawn = from.iter().zip(&to).map(|(a, b)| 0.5 * (a + b) + noise.uniform(0.5 * (b - a))).collect();
        Ok(self.with_circumstances(robot, pose, drawn))
    }

    /// Adds payload, torques and temperature of a pose, numbered from 0, to its joint values.
    fn with_circumstances(&self, robot: &dyn Robot, mut pose: usize, mut joints: Vec<f64>) -> Vec<f64> {
        if robot.circumstances().is_empty() || !robot.approached().is_empty() {
            return joints;
        }
        let (mut load, mut temperature_c) = (Payload::default(), USUAL_C);
        for poses in &self.poses {
            if pose < poses.count() {
                load = poses.load.unwrap_or_default();
                let [first, last] = poses.temperature_c.unwrap_or([USUAL_C; 2]);
                let steps = poses.count().saturating_sub(1).max(1);
                temperature_c = first + (last - first) * pose as f64 / steps as f64;
                break;
            }
            pose -= poses.count();
        }
        let torques = self.torques.at(robot, &joints, load);
        joints.extend(robot.circumstances().iter().map(|stated| match *stated {
            Circumstance::PayloadMass => load.kg,
            Circumstance::PayloadCentre(axis) => load.xyz_mm[axis],
            Circumstance::Torque(joint) => torques[joint],
            Circumstance::Temperature => temperature_c,
        }));
        joints
    }

    /// `true` if joint values (mm or rad) are in the range of the random pose.
    pub(super) fn is_within(&self, robot: &dyn Robot, pose: usize, q: &[f64]) -> bool {
        let Some(range) = self.range(pose) else { return true };
        let ends = stated_joints(robot, &range.from).ok().zip(stated_joints(robot, &range.to).ok());
        ends.is_some_and(|(from, to)| (0..from.len()).all(|j| from[j] <= q[j] && q[j] <= to[j]))
    }

    /// Joint values of all poses (mm or rad); `values` are the true parameters.
    pub(super) fn joint_values(&self, robot: &dyn Robot, values: &[f64]) -> Result<Vec<Vec<f64>>> {
        let mut all = Vec::new();
        for poses in &self.poses {
            for q in &poses.joints {
                all.push(self.with_circumstances(robot, all.len(), stated_joints(robot, q)?));
            }
            for circle in &poses.circles {
                let platform = robot.platform().ok_or_else(|| error!("truth-circles-not-planar"))?;
                for [x_mm, y_mm] in circle.positions() {
                    for theta in &poses.theta_deg {
                        let pose = PlanarPose { x_mm, y_mm, theta_rad: theta.to_radians() };
                        // controllers log values rounded to 0.1 µm
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

/// Values of all parameters of `robot` (mm, rad or 1) from values by name (mm, deg or 1); other
/// parameters are nominal.
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
