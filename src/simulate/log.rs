//! Simulated log with the columns that the campaign reads.

use super::Scene;
use crate::stages::gather;
use etalon_base::message::Result;
use etalon_base::noise::Noise;
use etalon_base::{error, phrase};
use etalon_campaign::JoinBy;
use etalon_formats::table::ASSEMBLY;
use etalon_formats::tables::joints::stated_columns;
use etalon_formats::{JointLog, Log, LogRow};

/// Stream of the noise of the contact, distinct from the streams of files.
const CONTACT: u64 = 1 << 33;

/// Text of a log; an error if the import cannot read it.
pub(super) fn write(scene: &Scene, log: &Log) -> Result<String> {
    writable(scene, log)?;
    let robot = scene.robot;
    let joints = robot.joints().iter().map(|joint| joint.column());
    let mut values = JointLog { joints: joints.chain(stated_columns(robot)).collect(), ..JointLog::default() };
    values.columns.extend(robot.has_assembly_modes().then(|| ASSEMBLY.to_owned()));
    // a join by pose alone needs one row for all rounds
    let once = scene.campaign.file.join_by() == Some(JoinBy::Pose);
    let mut contact = Noise::new(scene.truth.seed, CONTACT);
    for turn in scene.turns(if once { 1 } else { scene.truth.cycles }) {
        let joints = scene.encoders(turn, &mut contact)?;
        let encoders = robot.joints().iter().zip(&joints).map(|(joint, q)| joint.quantity.outward(*q));
        let stated = scene.stated(turn, &scene.joints[turn.pose as usize - 1]);
        values.rows.push(LogRow {
            pose: Some(turn.pose.into()),
            cycle: Some(turn.cycle),
            time_s: Some(turn.time_s()),
            label: scene.truth.label_at_pose(turn.pose).map(str::to_owned),
            assembly: joints.last().copied(),
            joints: encoders.chain(stated).collect(),
            ..LogRow::default()
        });
    }
    let all = etalon_formats::write_log(scene.campaign.stated(), log, &values)?;
    gather::parse_log(scene.campaign, log, &all)?;
    Ok(all)
}

/// Rejects logs that cannot consist of rows of standing poses ten seconds apart.
fn writable(scene: &Scene, log: &Log) -> Result<()> {
    let timed = scene.campaign.file.join_by() == Some(JoinBy::Time);
    let kind = if log.format.has_channels() {
        "twincat"
    } else if log.standstill.is_some() {
        "moving-log"
    } else if log.period_s.is_some() && timed {
        "period-log"
    } else if log.columns.values().any(|column| column.occurrence.is_some()) {
        "repeated-columns"
    } else if !(scene.robot.circumstances().is_empty() || scene.robot.approached().is_empty()) {
        "circumstances"
    } else {
        return Ok(());
    };
    let message = error!("simulate-not-written", what = phrase!("simulated-kind", kind));
    Err(message.at(scene.campaign.place(&log.file)).into())
}
