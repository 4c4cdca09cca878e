//! Simulated exports, logs and tables of observations of a robot with known parameters and given
//! noise, in the formats that a campaign reads.

mod export;
mod geometric;
mod log;
mod observed;
mod repeatability;
pub mod setup;
pub mod study;
mod table;
mod torques;
mod truth;
mod unmodelled;

pub use observed::{KnownRow, Observe};
pub use repeatability::{PoseScatter, Repeating};
pub use torques::{Mass, Torques};
pub use truth::{Circle, Drawn, LabelledPoint, Placement, Poses, Truth, true_values};
pub use unmodelled::{Interpolation, Unmodelled};

use etalon_base::catalogue::Phrase;
use etalon_base::cell::is_formula;
use etalon_base::error;
use etalon_base::files;
use etalon_base::message::{Problems, Result};
use etalon_base::noise::Noise;
use etalon_base::pose::{Pose, Vector};
use etalon_campaign::Campaign;
use etalon_robots::Robot;
#[cfg(all(test, feature = "schemas"))]
use study::StudyFile;

etalon_documents::schemas! {
    /// Name and JSON Schema of the input files of simulations.
    SCHEMAS in "../../schemas":
    "study.toml" StudyFile,
    "truth.toml" Truth,
}

/// Time between two poses in the log.
const INTERVAL_S: f64 = 10.0;
/// Maximum number of decimals that a double can represent.
const MOST_DECIMALS: usize = 17;

/// A robot with its true parameters and its poses.
struct Scene<'a> {
    campaign: &'a Campaign,
    truth: &'a Truth,
    robot: &'a dyn Robot,
    /// True parameters (mm, rad or 1).
    values: Vec<f64>,
    /// Joint values of each pose (mm or rad).
    joints: Vec<Vec<f64>>,
    /// Point on which the tool stands at each pose, if given.
    stands: Vec<Option<Vector>>,
    export_T_world: Pose,
}

/// One measurement; repeats are complete rounds of all poses.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Turn {
    pose: i64,
    cycle: i64,
    /// Number of the measurement over all rounds, from 1.
    number: i64,
}

impl Turn {
    /// Time in the log.
    fn time_s(self) -> f64 {
        INTERVAL_S * self.number as f64
    }
}

impl Scene<'_> {
    /// Rejects poses beyond the given limits of the robot file; all are reported.
    fn check_joint_limits(&self) -> Result<()> {
        // with the true parameters: near a limit, the nominal robot may be on its other side
        let violation = |(q, at): (&Vec<f64>, &Option<Vector>)| match at {
            Some(at) => self.robot.limit_violation(&self.values, &self.robot.inverse(&self.values, q, *at)?),
            None => self.robot.limit_violation(&self.values, q),
        };
        let beyond =
            (1..).zip(self.joints.iter().zip(&self.stands)).filter_map(|(pose, p)| Some((pose, violation(p)?)));
        let told = |(pose, why): (usize, Phrase)| error!("truth-pose-out-of-reach", pose, reason = why);
        Problems(beyond.map(told).collect()).check().map(|_| ())
    }

    /// Returns the measurement with this number, from 1.
    fn turn(&self, number: i64) -> Turn {
        let poses = (self.joints.len() as i64).max(1);
        Turn { pose: (number - 1) % poses + 1, cycle: (number - 1) / poses + 1, number }
    }

    /// All measurements of `cycles` rounds.
    fn turns(&self, cycles: i64) -> impl Iterator<Item = Turn> + '_ {
        (1..=cycles.saturating_mul(self.joints.len() as i64)).map(|number| self.turn(number))
    }

    /// Encoder values at a pose: as given, or of a point that is touched again with the contact's
    /// noise.
    fn encoders(&self, turn: Turn, contact: &mut Noise) -> Result<Vec<f64>> {
        let pose = turn.pose as usize - 1;
        let Some(at) = self.stands[pose] else { return Ok(self.joints[pose].clone()) };
        let stated = self.campaign.file.contact.map_or(0.0, |c| c.standard_uncertainty_mm());
        let sigma_mm = self.truth.contact_um.map_or(stated, |um| um / 1000.0);
        let found = at.map(|v| v + contact.gaussian(sigma_mm));
        let mut stated = self
            .robot
            .inverse(&self.values, &self.joints[pose], found)
            .ok_or_else(|| error!("truth-point-out-of-reach", pose = turn.pose, point = format!("{at:?}")))?;
        let errors = self.joint_errors(turn, &stated);
        stated.iter_mut().zip(errors).for_each(|(q, error)| *q -= error);
        Ok(stated)
    }

    /// Position of a target in the world at a pose.
    fn target(&self, turn: Turn, target: usize) -> Vector {
        let mut q = self.joints[turn.pose as usize - 1].clone();
        let errors = self.joint_errors(turn, &q);
        q.iter_mut().zip(errors).for_each(|(q, error)| *q += error);
        let mut p = self.robot.position(&self.values, &q, target);
        p[2] += self.truth.target_height_mm;
        self.truth.unmodelled.as_ref().map_or(p, |u| u.moved(self, p, turn.time_s() / 3600.0))
    }

    /// True minus given joint values; each joint comes from its position before its last motion.
    fn joint_errors(&self, turn: Turn, stated: &[f64]) -> Vec<f64> {
        let Some(unmodelled) = &self.truth.unmodelled else { return Vec::new() };
        let here = &self.joints[turn.pose as usize - 1];
        let first = (turn.number - self.joints.len() as i64).max(1);
        let before = |j: usize| {
            let mut earlier = (first..turn.number).rev().map(|n| self.joints[self.turn(n).pose as usize - 1][j]);
            earlier.find(|q| *q != here[j]).unwrap_or(stated[j])
        };
        let before: Vec<f64> = (0..stated.len()).map(before).collect();
        unmodelled.joint_errors(self, stated, &before)
    }
}

/// Rejects a truth that observes quantities which the campaign does not read, and an empty table.
fn check_table(campaign: &Campaign, truth: &Truth) -> Result<()> {
    let has_rows = !truth.observe.is_empty() || !truth.known.is_empty();
    match campaign.file.observations.first() {
        None if has_rows => Err(error!("observe-without-table").into()),
        Some(stated) if truth.observe.is_empty() => {
            Err(error!("table-without-observe").at(campaign.place(&stated.file)).into())
        }
        _ => Ok(()),
    }
}

/// Writes all exports, logs and tables of observations of `campaign` if all of them read back as
/// simulated; returns their names.
pub fn simulate(campaign: &Campaign, truth: &Truth) -> Result<Vec<String>> {
    if campaign.file.synthetic.is_none() {
        return Err(error!("campaign-not-synthetic").into());
    }
    if truth.decimals > MOST_DECIMALS {
        return Err(error!("truth-decimals", decimals = truth.decimals, most = MOST_DECIMALS).into());
    }
    if let Some(export) = campaign.file.exports.iter().find(|export| !export.joints.is_empty()) {
        return Err(error!("joints-and-points-together").at(campaign.place(&export.file)).into());
    }
    let table = campaign.file.observations.first();
    if let Some(second) = campaign.file.observations.get(1) {
        return Err(error!("several-tables").at(campaign.place(&second.file)).into());
    }
    check_table(campaign, truth)?;
    if let Some(point) = truth.points.iter().find(|point| is_formula(&point.label)) {
        return Err(error!("point-label-formula", label = point.label).into());
    }
    let mut robot = campaign.build_robot_with(&observed::targets(truth, &campaign.robot.branches()))?;
    let own = robot.parameters().len();
    let items = observed::items(truth, robot.as_mut())?;
    let known = observed::known(truth, robot.as_mut())?;
    let unstated = robot.parameters()[own..].iter().filter(|p| !truth.parameters.contains_key(&p.name));
    let unstated: Vec<String> = unstated.map(|p| format!("`{}`", p.name)).collect();
    if !unstated.is_empty() {
        return Err(error!("truth-parameters-missing", parameters = unstated).into());
    }
    let values = true_values(robot.as_ref(), &truth.parameters)?;
    let placed = &truth.export_T_world;
    let scene = Scene {
        campaign,
        truth,
        robot: robot.as_ref(),
        joints: truth.joint_values(robot.as_ref(), &values)?,
        values,
        stands: truth.stands()?,
        export_T_world: Pose::from_xyz_rpy(placed.xyz_mm, placed.rpy_deg.map(f64::to_radians)),
    };
    scene.check_joint_limits()?;
    truth.unmodelled.as_ref().map_or(Ok(()), |u| u.check(&scene))?;
    geometric::check(&scene)?;
    repeatability::check(&scene)?;
    let mut texts = Vec::new();
    for (stream, stated) in campaign.file.exports.iter().enumerate() {
        // one stream of noise per file, so that adding a file does not change others
        texts.push((&stated.file, export::write(&scene, stated, stream as u64)?));
    }
    for stated in &campaign.file.logs {
        texts.push((&stated.file, log::write(&scene, stated)?));
    }
    if let Some(stated) = table {
        texts.push((&stated.file, table::write(&scene, stated, &items, &known)?));
    }
    let paths = texts.iter().map(|(file, _)| campaign.written(file)).collect::<Result<Vec<_>>>()?;
    for (path, (_, text)) in paths.iter().zip(&texts) {
        files::write(path, text.as_bytes())?;
    }
    Ok(texts.iter().map(|(file, _)| file.get_ref().clone()).collect())
}
