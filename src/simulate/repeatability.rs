//! Visits of a repeatability test (thesis, 2.4), where the attained position depends on the
//! previous pose.

use super::{Scene, Turn};
use crate::stages::geometric;
use etalon_base::bounds::{MOST, at_most};
use etalon_base::error;
use etalon_base::message::Result;
use etalon_base::noise::Noise;
use etalon_base::pose::{Vector, minus};
use etalon_formats::Export;
use schemars::JsonSchema;
use serde::Deserialize;

/// Stream of the noise of the robot, distinct from the streams of files.
const VISITS: u64 = 1 << 34;
/// Shortest move that changes the side of the play (mm).
const MOVED_MM: f64 = 1e-6;

/// `[repeatability]` of a truth: repeatability of the robot.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Repeating {
    /// Export of the visits.
    pub export: String,
    /// Measured ball, one of the robot's targets.
    pub target: String,
    /// Play along x: difference between the positions after moves along −x and along +x (µm); the
    /// robot lags behind its motion.
    pub play_x_um: Vector,
    /// Play along y: difference between the positions after moves along −y and along +y (µm); the
    /// robot lags behind its motion.
    pub play_y_um: Vector,
    /// Repeatability of each pose of the trajectory, from pose 1.
    pub pose: Vec<PoseScatter>,
    /// Joint values of the home position (mm or deg).
    pub home: Vec<f64>,
    /// Number of homings.
    #[serde(default, deserialize_with = "at_most::<_, _, MOST>")]
    pub homings: i64,
    /// Standard deviation of each coordinate after homing.
    #[serde(default)]
    pub homing_um: f64,
}

/// Repeatability of a single pose.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PoseScatter {
    /// Standard deviations of x, y and z.
    pub scatter_um: Vector,
    /// Lift by warping of the mechanism.
    #[serde(default)]
    pub lift_um: f64,
}

/// Labelled visits for `export`; `measure` returns the reading of a point in the world.
pub(super) fn points(
    scene: &Scene,
    export: &Export,
    mut measure: impl FnMut(Vector) -> Vector,
) -> Result<Vec<(String, Vector)>> {
    let (Some(truth), Some(definition)) = (&scene.truth.repeatability, &scene.campaign.file.repeatability) else {
        return Ok(Vec::new());
    };
    if truth.export != *export.file.get_ref() {
        return Ok(Vec::new());
    }
    let target = scene.robot.targets().iter().position(|t| *t == truth.target).ok_or_else(|| {
        let message = error!("truth-target-unknown", target = truth.target);
        message.hint_names(&truth.target, scene.robot.targets().iter().map(String::as_str))
    })?;
    let mut robot = Noise::new(scene.truth.seed, VISITS);
    let mut scattered = |um: Vector| um.map(|um| robot.gaussian(um / 1e3));
    let home: Vec<f64> = scene.robot.joints().iter().zip(&truth.home).map(|(j, q)| j.quantity.inward(*q)).collect();
    let mut home_mm = scene.robot.position(&scene.values, &home, target);
    home_mm[2] += scene.truth.target_height_mm;
    let mut rows = Vec::new();
    let (mut before, mut play) = (home_mm, [0.0; 2]);
    for cycle in 1..=scene.truth.cycles {
        for &name in definition.trajectory.get_ref() {
            let pose = name.number().filter(|pose| (1..=scene.joints.len() as i64).contains(pose)).unwrap_or_default();
            let scatter = usize::try_from(pose - 1).ok().and_then(|i| truth.pose.get(i));
            let Some(scatter) = scatter else {
                return Err(error!("truth-pose-missing", pose = name).into());
            };
            let at = scene.target(Turn { pose, cycle, number: pose }, target);
            // side of the play after the last move along an axis
            for (side, d) in play.iter_mut().zip(minus(at, before)) {
                if d.abs() > MOVED_MM {
                    *side = -0.5 * d.signum();
                }
            }
            let noise = scattered(scatter.scatter_um);
            let lagging = |k: usize| (play[0] * truth.play_x_um[k] + play[1] * truth.play_y_um[k]) / 1e3;
            let lift = [0.0, 0.0, scatter.lift_um / 1e3];
            let stands = [0, 1, 2].map(|k| at[k] + lagging(k) + lift[k] + noise[k]);
            rows.push((geometric::label(definition.label.get_ref(), &truth.target, name, cycle), measure(stands)));
            before = at;
        }
    }
    for (cycle, pattern) in (1..=truth.homings).flat_map(|cycle| definition.homing.iter().map(move |p| (cycle, p))) {
        let noise = scattered([truth.homing_um; 3]);
        let stands = [0, 1, 2].map(|k| home_mm[k] + noise[k]);
        rows.push((geometric::label(pattern.get_ref(), &truth.target, 0.into(), cycle), measure(stands)));
    }
    Ok(rows)
}

/// Rejects a truth that the campaign cannot name.
pub(super) fn check(scene: &Scene) -> Result<()> {
    let Some(truth) = &scene.truth.repeatability else { return Ok(()) };
    if scene.campaign.file.repeatability.is_none() {
        return Err(error!("truth-repeatability-without-campaign").into());
    }
    if truth.home.len() != scene.robot.joints().len() {
        let (values, joints) = (truth.home.len(), scene.robot.joints().len());
        return Err(error!("truth-home-count", values, joints).into());
    }
    Ok(())
}
