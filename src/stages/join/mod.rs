//! Join of measurements and joint values: measured positions for each log, and a report of every
//! row without a partner.

mod by_key;
mod by_label;
mod by_time;
pub mod clock;
mod clock_motion;
mod observations;
mod unmatched;

pub use observations::{JoinedLog, ObservationTime, Observations};

use crate::stages::gather::{Gathered, Stationed};
use crate::stages::observe::exclusions::Exclusion;
use crate::stages::observe::joint_range::{self, JointRow, Joints};
use by_key::by_key;
use by_label::by_label;
use by_time::{Clocks, by_time};
use clock::Clock;
use clock_motion::{Track, Way, offset_by_motion};
use etalon_base::message::{Message, Place, Problems, Result};
use etalon_base::pose::{Pose, Vector};
use etalon_base::pose_name::PoseName;
use etalon_base::{error, phrase, warning};
use etalon_campaign::{Campaign, ClockOffset, ClockRate, Join, JoinBy};
use etalon_documents::{FramesDocument, SourceKind, Unmatched};
use etalon_formats::table::Table;
use etalon_formats::tables::joints::{missing_column, stated_columns, wrong_value};
use etalon_formats::{JointLog, LogRow, Point, SharedText};
use etalon_identify::{Covariance, directions, turned};
use etalon_robots::{Quantity, Robot, Role};
use std::borrow::Cow;
use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};
use unmatched::At;

/// Observations by log, and rows without a partner.
#[derive(Clone, Debug)]
pub struct Joined {
    /// Name of each log and its observations, or the observations of the table.
    pub observations: Vec<(String, Observations)>,
    /// Summary of the rows without a partner, or with two.
    pub messages: Vec<Message>,
    /// Rows without a partner, or with two.
    pub unmatched: Vec<Unmatched>,
}

impl Joined {
    /// Observations of a table, which need no join.
    pub fn from_table(table: Table) -> Self {
        let observations = vec![("observations".to_owned(), Observations::Table(table))];
        Self { observations, messages: Vec::new(), unmatched: Vec::new() }
    }
}

/// Remarks of a join, in addition to its observations.
#[derive(Default)]
struct Remarks {
    messages: Vec<Message>,
    unmatched: Vec<Unmatched>,
}

impl Remarks {
    fn extend(&mut self, more: Self) {
        self.messages.extend(more.messages);
        self.unmatched.extend(more.unmatched);
    }
}

/// A target of the robot in the world.
struct Target<'a> {
    point: &'a Point,
    /// Its index among the robot's targets.
    index: usize,
    world_mm: Vector,
    covariance_mm2: Option<Covariance>,
    /// Orientation of the body in the world, as a quaternion.
    orientation: Option<[f64; 4]>,
    /// Station in whose frame position and orientation are, if it is not the world.
    station: Option<SharedText>,
}

/// A target with the joint values at which it was measured.
struct Row {
    pose: Option<PoseName>,
    cycle: Option<i64>,
    target: usize,
    world_mm: Vector,
    covariance_mm2: Option<Covariance>,
    orientation: Option<[f64; 4]>,
    station: Option<SharedText>,
    /// Time of the export or, if the export has none, of the log (s).
    time_s: Option<f64>,
    assembly: Option<f64>,
    joints: Vec<f64>,
    /// Line of the log; none for an interpolated row.
    line: Option<usize>,
}

impl Row {
    /// A target and its row of the log.
    fn new(target: &Target, met: &LogRow) -> Self {
        Self {
            pose: target.point.pose,
            cycle: target.point.cycle,
            target: target.index,
            world_mm: target.world_mm,
            covariance_mm2: target.covariance_mm2,
            orientation: target.orientation,
            station: target.station.clone(),
            time_s: target.point.time_s.or(met.time_s),
            assembly: met.assembly,
            joints: met.joints.clone(),
            line: Some(met.line),
        }
    }
}

/// The observations of a campaign: its table, or the targets of `robot` joined with every log.
pub fn joined(campaign: &Campaign, imported: &Gathered, frames: &FramesDocument, robot: &dyn Robot) -> Result<Joined> {
    match &imported.observations {
        Some(file) => Ok(Joined::from_table(file.table.clone())),
        None => join(campaign, imported, frames, robot),
    }
}

/// Joins the targets of `robot`, expressed in the world, with every log of the campaign.
fn join(campaign: &Campaign, imported: &Gathered, frames: &FramesDocument, robot: &dyn Robot) -> Result<Joined> {
    let Some(definition) = &campaign.file.join else {
        let message = error!("key-missing", key = "join", has_section = "no", section = "");
        return Err(message.at(Place::file(campaign.path.as_str())).into());
    };
    check_stations(campaign, imported)?;
    let (mut remarks, mut problems) = (Remarks::default(), Problems::default());
    let targets = targets_in_world(campaign, imported, frames, robot, &mut remarks);
    let mut observations = Vec::new();
    for log in &imported.logs {
        check_stated(log, robot)?;
        let log = &*with_directions(log, robot)?;
        let recorded = Recorded { log, robot };
        let joined = match definition.by {
            JoinBy::Label => by_label(campaign, &imported.points, frames, log, robot).map(|(rows, more)| {
                remarks.extend(more);
                rows
            }),
            JoinBy::Row => equal_counts(campaign, imported, targets.iter().map(|t| t.point), log)
                .and_then(|()| with_log(campaign, definition, &targets, &recorded, &mut remarks)),
            _ => with_log(campaign, definition, &targets, &recorded, &mut remarks),
        };
        let joined = joined.map(|rows| leave_out_unknown(rows, log, &mut remarks));
        let moved_out = joined.as_ref().ok().and_then(|rows| out_of_plane(rows, robot));
        let joined = joined.and_then(|rows| {
            joint_range::check(robot, &joint_rows(campaign, &rows, log, robot), Joints::Measured)?;
            Ok(rows)
        });
        match joined.and_then(|rows| JoinedLog::new(rows, log, robot)) {
            Ok(joined) => {
                if observations.is_empty() {
                    remarks.messages.extend(moved_out);
                    remarks.messages.extend(joined.incomplete(export_numbered_by_row(campaign, &targets)));
                }
                // poses, and points of further stations, are rows of a table of observations
                let observed = if joined.has_orientations() || joined.has_stations() {
                    Observations::Table(joined.table())
                } else {
                    Observations::Log(joined)
                };
                observations.push((log.name.clone(), observed));
            }
            Err(more) => problems.0.extend(more.at(&campaign.key_place(&["join", "by"])).0),
        }
    }
    problems.check()?;
    Ok(Joined { observations, messages: remarks.messages, unmatched: remarks.unmatched })
}

/// Export with several targets whose rows are numbered as poses: each row is a pose of its own.
fn export_numbered_by_row<'a>(campaign: &'a Campaign, targets: &[Target]) -> Option<&'a str> {
    let numbered = campaign.file.exports.iter().filter(|export| export.pose.is_some());
    let mut files = numbered.map(|export| export.file.get_ref().as_str());
    files.find(|file| {
        let mut of = targets.iter().filter(|target| *target.point.export == **file).map(|target| target.index);
        let first = of.next();
        of.any(|index| Some(index) != first)
    })
}

/// A log, and the robot whose joints it recorded.
struct Recorded<'a> {
    log: &'a JointLog,
    robot: &'a dyn Robot,
}

/// Joins targets in the world with one log, by the key that the campaign contains.
fn with_log(
    campaign: &Campaign,
    join: &Join,
    targets: &[Target],
    recorded: &Recorded,
    remarks: &mut Remarks,
) -> Result<Vec<Row>> {
    let log = recorded.log;
    let joined = match join.by {
        JoinBy::PoseAndCycle => by_key(targets, log, &["pose", "cycle"], remarks)?,
        JoinBy::Pose => by_key(targets, log, &["pose"], remarks)?,
        JoinBy::Row => by_key(targets, log, &["row"], remarks)?,
        JoinBy::Time => {
            let clock = match join.clock_offset_s {
                Some(ClockOffset::Motion) => clock_by_motion(campaign, join, targets, recorded, remarks)?,
                _ => clock(campaign, join, targets, log, remarks)?,
            };
            let tolerance_s = join.tolerance_s.unwrap_or(0.0);
            by_time(targets, log, Clocks { clock, tolerance_s, interpolate: join.interpolate }, remarks)?
        }
        // what the log touches has no partner among the robot's targets
        JoinBy::Label => Vec::new(),
    };
    if joined.is_empty() {
        let log_name = &log.name;
        if join.by == JoinBy::Time {
            let gap_s = smallest_gap_s(join, targets, log).unwrap_or(f64::NAN);
            let message = error!("join-by-time-empty", log = log_name, apart_s = gap_s);
            // between two rows that are farther apart than the tolerance no offset of the clocks
            // helps
            return Err(match join.interpolate && join.tolerance_s.is_some_and(|tolerance_s| gap_s <= tolerance_s) {
                true => message.hint(phrase!("both-rows-near")).at(campaign.key_place(&["join", "tolerance_s"])),
                false => message.at(campaign.key_place(&["join", "clock_offset_s"])),
            }
            .into());
        }
        let shown = |pose: Option<PoseName>| pose.map_or_else(|| "-".to_owned(), |pose| pose.to_string());
        let measured = shown(targets.first().and_then(|t| t.point.pose));
        let logged = shown(log.rows.first().and_then(|row| row.pose));
        return Err(error!("join-empty", log = log_name, measured, logged).into());
    }
    Ok(joined)
}

/// The clocks: as given, or from the standstills of the log, with a remark.
fn clock(campaign: &Campaign, join: &Join, targets: &[Target], log: &JointLog, remarks: &mut Remarks) -> Result<Clock> {
    if join.clock_offset_s != Some(ClockOffset::Standstills) {
        return Ok(Clock::with_offset(join.stated_offset_s().unwrap_or(0.0)));
    }
    let standstills: Vec<(f64, f64)> = log.rows.iter().filter_map(|row| row.standing_s.map(|[a, b]| (a, b))).collect();
    let place = || campaign.key_place(&["join", "clock_offset_s"]);
    let times: Vec<f64> = targets.iter().filter_map(|t| t.point.time_s).collect();
    if join.clock_rate == Some(ClockRate::Standstills) {
        let found = clock::offset_and_rate(&times, &standstills).map_err(|m| m.at(place()))?;
        let [low_ppm, high_ppm] = found.rates.map(|rate| 1e6 * rate);
        let clock = found.clock;
        let message = match clock.rate == 0.0 {
            true => warning!("clock-rate-insignificant", log = log.name, low_ppm, high_ppm),
            false => warning!(
                "clock-rate-from-standstills",
                log = log.name,
                rate_ppm = 1e6 * clock.rate,
                u_ppm = 1e6 * found.rate_uncertainty,
                low_ppm,
                high_ppm,
                offset_s = clock.offset_s,
                u_s = found.offset_uncertainty_s,
                reference_s = clock.reference_s
            ),
        };
        remarks.messages.push(message.at(campaign.key_place(&["join", "clock_rate"])));
        if clock.rate != 0.0 {
            return Ok(clock);
        }
    }
    let found = clock::offset(&times, &standstills).map_err(|m| m.at(place()))?;
    let message = warning!(
        "clock-from-standstills",
        log = log.name,
        count = standstills.len(),
        offset_s = found.offset_s,
        half_width_s = found.half_width_s
    );
    remarks.messages.push(message.at(place()));
    Ok(Clock::with_offset(found.offset_s))
}

/// The clocks from the speeds of a motion, with a remark.
fn clock_by_motion(
    campaign: &Campaign,
    join: &Join,
    targets: &[Target],
    recorded: &Recorded,
    remarks: &mut Remarks,
) -> Result<Clock> {
    let Recorded { log, robot } = recorded;
    let place = || campaign.key_place(&["join", "clock_offset_s"]);
    let columns: Option<Vec<(usize, Quantity)>> = robot
        .joints()
        .iter()
        .map(|joint| Some((log.joints.iter().position(|name| *name == joint.column())?, joint.quantity)))
        .collect();
    let rows: Vec<(f64, Vec<f64>)> = columns.map_or(Vec::new(), |columns| {
        let joints = |row: &LogRow| columns.iter().map(|(k, quantity)| quantity.inward(row.joints[*k])).collect();
        log.rows.iter().filter_map(|row| Some((row.time_s?, joints(row)))).collect()
    });
    let measured: Vec<Track> = (0..robot.targets().len()).map(|index| track(targets, index)).collect();
    let logged: Vec<Way> = (0..robot.targets().len()).map(|index| way(*robot, &rows, index)).collect();
    let rate = join.clock_rate == Some(ClockRate::Motion);
    let found = offset_by_motion(&measured, &logged, rate).map_err(|m| m.at(place()))?;
    let clock = found.clock;
    let message = warning!(
        "clock-from-motion",
        log = log.name,
        offset_s = clock.offset_s,
        u_s = found.offset_uncertainty_s,
        reference_s = clock.reference_s,
        rate_ppm = 1e6 * clock.rate,
        u_ppm = 1e6 * if rate { found.rate_uncertainty } else { 0.0 },
        correlation = found.correlation
    );
    remarks.messages.push(message.at(place()));
    Ok(clock)
}

/// Measured positions of a target, in the order of their times.
fn track(targets: &[Target], index: usize) -> Track {
    let of_target = targets.iter().filter(|target| target.index == index);
    let mut points: Vec<(f64, Vector)> = of_target.filter_map(|t| Some((t.point.time_s?, t.world_mm))).collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (times_s, positions_mm) = points.into_iter().unzip();
    Track { times_s, positions_mm }
}

/// Positions of a target by the nominal robot at times and joint values of a log.
fn way(robot: &dyn Robot, rows: &[(f64, Vec<f64>)], index: usize) -> Way {
    let (nominal, parameters) = (robot.nominal(), robot.parameters());
    let derivatives = |joints: &[f64], of: &[usize]| {
        let mut found = vec![[0.0; 3]; of.len()];
        robot.target_derivatives(&nominal, joints, &[index], &mut |_, parameter, by: Vector| {
            if let Some(place) = of.iter().position(|i| *i == parameter) {
                (0..3).for_each(|k| found[place][k] += by[k]);
            }
        });
        found
    };
    // the columns of a rotation: none is zero
    let of_targets: Vec<usize> = (0..parameters.len()).filter(|i| parameters[*i].role == Role::Target).collect();
    let first = rows.first().map(|(_, joints)| derivatives(joints, &of_targets)).unwrap_or_default();
    let of_target = of_targets.iter().zip(first).filter(|(_, by)| *by != [0.0; 3]);
    let places: Vec<usize> = of_target.map(|(i, _)| *i).collect();
    Way {
        track: Track {
            times_s: rows.iter().map(|(time_s, _)| *time_s).collect(),
            positions_mm: rows.iter().map(|(_, joints)| robot.position(&nominal, joints, index)).collect(),
        },
        by_place: rows.iter().map(|(_, joints)| derivatives(joints, &places)).collect(),
        // a tolerance is the half width of a rectangular distribution (GUM 4.3.7)
        place_uncertainties_mm: places.iter().map(|i| parameters[*i].tolerance / 3f64.sqrt()).collect(),
    }
}

/// The smallest time difference between a point and a row of the log, with the campaign's clock
/// offset.
fn smallest_gap_s(join: &Join, targets: &[Target], log: &JointLog) -> Option<f64> {
    let offset_s = join.stated_offset_s().unwrap_or(0.0);
    let mut logged: Vec<f64> = log.rows.iter().filter_map(|row| row.time_s).collect();
    logged.sort_by(f64::total_cmp);
    let nearest = |time_s: f64| {
        let after = logged.partition_point(|l| *l < time_s);
        let beside = logged.get(after.saturating_sub(1)..(after + 1).min(logged.len())).unwrap_or_default();
        beside.iter().map(|l| (l - time_s).abs()).min_by(f64::total_cmp)
    };
    targets.iter().filter_map(|t| nearest(t.point.time_s? - offset_s)).min_by(f64::total_cmp)
}

/// Compares the numbers of rows for a join by row, before targets and frames are known.
pub fn counts(campaign: &Campaign, imported: &Gathered, robot: &dyn Robot) -> Result<()> {
    if campaign.file.join_by() != Some(JoinBy::Row) {
        return Ok(());
    }
    let index = target_index(robot);
    let points = || imported.all_points().filter(|p| p.target.as_deref().is_some_and(|t| index.contains_key(t)));
    let found = imported.logs.iter().map(|log| equal_counts(campaign, imported, points(), log));
    Problems(found.filter_map(Result::err).flat_map(|p| p.0).collect()).check().map(|_| ())
}

/// Index of each target of the robot.
fn target_index(robot: &dyn Robot) -> BTreeMap<&str, usize> {
    // the first of equal names, which are reported elsewhere
    robot.targets().iter().enumerate().map(|(k, target)| (target.as_str(), k)).rev().collect()
}

/// The targets of the robot in the world; targets of poses without a world frame are reported.
fn targets_in_world<'a>(
    campaign: &Campaign,
    imported: &'a Gathered,
    frames: &FramesDocument,
    robot: &dyn Robot,
    remarks: &mut Remarks,
) -> Vec<Target<'a>> {
    let mut by_pose: BTreeMap<(PoseName, i64), Pose> = BTreeMap::new();
    let mut for_all = None;
    for frame in &frames.world.poses {
        match (frame.pose, frame.cycle) {
            (Some(pose), Some(cycle)) => drop(by_pose.insert((pose, cycle), frame.export_T_world.inverse())),
            _ => for_all = Some(frame.export_T_world.inverse()),
        }
    }
    let mut targets = Vec::new();
    let mut lost = BTreeSet::new();
    let known = target_index(robot);
    for point in &imported.points {
        let Some(&index) = point.target.as_deref().and_then(|target| known.get(target)) else { continue };
        let key = point.pose.zip(point.cycle);
        let Some(world_T_export) = for_all.or_else(|| by_pose.get(&key?).copied()) else {
            lost.extend(point.pose);
            let key = point.pose.map_or_else(String::new, |pose| format!("pose {pose}"));
            remarks.unmatched.push(At::point(point).unmatched(key, &phrase!("row-of-unframed-pose")));
            continue;
        };
        let covariance_mm2 = export_covariance(campaign, point).map(|c| turned(&c, &world_T_export.rotation));
        let turned = |q: &[f64; 4]| world_T_export.then(&Pose::from_quaternion(*q)).quaternion();
        let orientation = point.orientation.as_ref().map(turned);
        targets.push(Target {
            point,
            index,
            world_mm: world_T_export.apply(point.xyz_mm),
            covariance_mm2,
            orientation,
            station: None,
        });
    }
    targets.extend(stationed(imported, robot, remarks));
    if !lost.is_empty() {
        remarks.messages.push(warning!("pose-without-frame", count = lost.len(), poses = listed(&lost)));
    }
    targets
}

/// The targets that further stations measured, in the frames of the stations.
fn stationed<'a>(imported: &'a Gathered, robot: &dyn Robot, remarks: &mut Remarks) -> Vec<Target<'a>> {
    let mut targets = Vec::new();
    let known = target_index(robot);
    for Stationed { station, point } in &imported.stationed {
        let Some(&index) = point.target.as_deref().and_then(|target| known.get(target)) else {
            let reason = phrase!("row-of-station-unused", station = &**station);
            remarks.unmatched.push(At::point(point).unmatched(point.label.to_string(), &reason));
            continue;
        };
        let (world_mm, orientation, station) = (point.xyz_mm, point.orientation, Some(station.clone()));
        targets.push(Target { point, index, world_mm, covariance_mm2: None, orientation, station });
    }
    targets
}

/// Checks that rows of further stations have one uncertainty.
fn check_stations(campaign: &Campaign, imported: &Gathered) -> Result<()> {
    let mut problems = Problems::default();
    for export in campaign.file.exports.iter().filter(|export| export.station.is_some()) {
        let name = export.station.as_ref().map_or("", |station| station.get_ref());
        let mut own = imported.stationed.iter().map(|of| &of.point).filter(|p| *p.export == **export.file.get_ref());
        if let Some(point) = own.find(|point| export_covariance(campaign, point).is_some()) {
            let fault = if point.standard_uncertainty_mm.is_some() { "uncertainties" } else { "covariance" };
            let message = error!("station-row-unsupported", station = name, fault, kind = "point");
            problems.0.push(message.at(At::point(point).place()));
        }
    }
    problems.check().map(|_| ())
}

/// The covariance of a point along the axes of its export, if its row contains one or the
/// instrument measures range and angles.
fn export_covariance(campaign: &Campaign, point: &Point) -> Option<Covariance> {
    let Some(u) = point.standard_uncertainty_mm.as_ref() else {
        return campaign.file.instrument.covariance_mm2(point.xyz_mm);
    };
    Some([0, 1, 2].map(|i| [0, 1, 2].map(|j| if i == j { u[i] * u[i] } else { 0.0 })))
}

/// Returns an error if points and their rows of the log have different poses or cycles.
fn contradictions<'a>(log: &JointLog, pairs: impl Iterator<Item = (&'a Point, &'a LogRow)> + Clone) -> Result<()> {
    type Number = (fn(&Point) -> Option<PoseName>, fn(&LogRow) -> Option<PoseName>);
    let mut problems = Problems::default();
    let cycle: Number = (|p| p.cycle.map(PoseName::from), |r| r.cycle.map(PoseName::from));
    let of: [(&str, Number); 2] = [("pose", (|p| p.pose, |r| r.pose)), ("cycle", cycle)];
    for (column, (stated, logged)) in of {
        let differs = pairs.clone().filter_map(|(point, row)| Some((point, row, stated(point)?, logged(row)?)));
        let all: Vec<(&Point, &LogRow, PoseName, PoseName)> = differs.filter(|(.., a, b)| a != b).collect();
        let Some((point, row, here, there)) = all.first() else { continue };
        let message = error!(
            "join-contradicts",
            count = all.len(),
            column,
            log = log.name,
            measured = here,
            logged = there,
            line = row.line
        );
        problems.0.push(message.at(At::point(point).place()));
    }
    problems.check().map(|_| ())
}

/// Checks a join by row: every export with targets must have as many data rows as the log.
fn equal_counts<'a>(
    campaign: &Campaign,
    imported: &Gathered,
    points: impl Iterator<Item = &'a Point>,
    log: &JointLog,
) -> Result<()> {
    let exports: BTreeSet<&str> = points.map(|p| &*p.export).collect();
    let mut problems = Problems::default();
    for source in
        imported.document.sources.iter().filter(|s| s.kind == SourceKind::Export && exports.contains(s.file.as_str()))
    {
        let own = log.files.iter().position(|file| *file == source.file).map(|i| Some(i as i64 + 1));
        let rows = log.rows.iter().filter(|row| own.is_none_or(|own| row.file == own)).count();
        if source.rows_read != rows {
            let (file, name) = (&source.file, &log.name);
            let message = error!("row-counts-differ", file, rows = source.rows_read, log = name, log_rows = rows);
            let stated = campaign.file.exports.iter().find(|e| e.file.get_ref() == file);
            problems.0.push(Message { place: stated.map(|e| Box::new(campaign.place(&e.file))), ..message });
        }
    }
    problems.check().map(|_| ())
}

/// Maximum motion (mm or deg) of the encoder of a stationary joint.
const STILL: f64 = 0.01;

/// A log with the directions of approach of the joints with backlash: given directions, or
/// directions from the order of its times.
fn with_directions<'a>(log: &'a JointLog, robot: &dyn Robot) -> Result<Cow<'a, JointLog>> {
    let mut log = Cow::Borrowed(log);
    for joint in robot.approached().iter().map(|&k| &robot.joints()[k]) {
        let name = joint.direction_column();
        let column = log.joints.iter().position(|column| *column == joint.column());
        let Some(column) = column.filter(|_| !log.joints.contains(&name)) else { continue };
        let mut order: Vec<usize> = (0..log.rows.len()).collect();
        order.sort_by(|&a, &b| log.rows[a].time_s.partial_cmp(&log.rows[b].time_s).unwrap_or(Ordering::Equal));
        if log.rows.iter().any(|row| row.time_s.is_none()) {
            let message = error!("approach-direction-unknown", log = log.name, joint = joint.name, column = name);
            return Err(message.into());
        }
        let motion = log.motion(column);
        let found = directions(order.iter().map(|&i| motion[i]), STILL);
        let log = log.to_mut();
        order.into_iter().zip(found).for_each(|(i, d)| log.rows[i].joints.push(d.unwrap_or(f64::NAN)));
        log.joints.push(name);
    }
    Ok(log)
}

/// Checks the payload and other values that each row of a log contains.
fn check_stated(log: &JointLog, robot: &dyn Robot) -> Result<()> {
    for (&stated, column) in robot.circumstances().iter().zip(&stated_columns(robot)) {
        let found = log.joints.iter().position(|name| name == column);
        let found = found.ok_or_else(|| missing_column(robot, stated))?;
        for (i, row) in log.rows.iter().enumerate() {
            let value = row.joints.get(found).copied().unwrap_or(f64::NAN);
            if let Some(message) = wrong_value(robot, stated, value) {
                return Err(message.within(phrase!("in-row", row = i + 1)).into());
            }
        }
    }
    Ok(())
}

/// The rows without those before the first motion of a joint with backlash.
fn leave_out_unknown(mut rows: Vec<Row>, log: &JointLog, remarks: &mut Remarks) -> Vec<Row> {
    let is_known = |row: &Row| row.joints.iter().all(|q| !q.is_nan());
    if !rows.iter().all(is_known) {
        let lost: Vec<Row> = rows.extract_if(.., |row| !is_known(row)).collect();
        let poses: BTreeSet<PoseName> = lost.iter().filter_map(|row| row.pose).collect();
        remarks.messages.push(warning!("backlash-direction-unknown", log = log.name, poses = listed(&poses)));
    }
    rows
}

/// The joint values of the rows that are not excluded; there are no values for joints that the log
/// does not contain.
fn joint_rows(campaign: &Campaign, rows: &[Row], log: &JointLog, robot: &dyn Robot) -> Vec<JointRow> {
    let columns: Vec<Option<(usize, Quantity)>> = robot
        .joints()
        .iter()
        .map(|joint| Some((log.joints.iter().position(|name| *name == joint.column())?, joint.quantity)))
        .collect();
    let value = |row: &Row, column: Option<(usize, Quantity)>| -> Option<f64> {
        let (k, quantity) = column?;
        Some(quantity.inward(*row.joints.get(k)?))
    };
    let exclusions = campaign.file.identify.as_ref().map(|stated| Exclusion::from_campaign(campaign, stated));
    let exclusions = exclusions.unwrap_or_default();
    let rules: Vec<_> = exclusions.iter().filter_map(Exclusion::covering).collect();
    let target = |row: &Row| robot.targets()[row.target].as_str();
    let left_out = |row: &&Row| {
        let of = |pose| rules.iter().any(|covers| covers(pose, row.cycle.unwrap_or(1), target(row)));
        row.pose.is_some_and(of)
    };
    let joint_row = |row: &Row| JointRow {
        pose: row.pose.map_or_else(String::new, |pose| pose.to_string()),
        joints: columns.iter().map(|column| value(row, *column).unwrap_or(f64::NAN)).collect(),
        place: Place { line: row.line, ..Place::file(&log.file) },
    };
    rows.iter().filter(|row| !left_out(row)).map(joint_row).collect()
}

/// Maximum difference in height (mm) of the targets of a planar robot: more is a tilt against the
/// world's plane that distorts the projection.
const OUT_OF_PLANE_MM: f64 = 0.5;

/// Returns a warning if the targets of a planar robot do not move parallel to the plane of the
/// world frame.
fn out_of_plane(rows: &[Row], robot: &dyn Robot) -> Option<Message> {
    let heights = rows.iter().filter(|_| robot.dimension() == 2).map(|row| row.world_mm[2]);
    let [low, high] = heights.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], z| [low.min(z), high.max(z)]);
    (high - low > OUT_OF_PLANE_MM).then(|| warning!("targets-out-of-plane", low_mm = low, high_mm = high))
}

fn listed(numbers: &BTreeSet<PoseName>) -> String {
    let shown: Vec<String> = numbers.iter().take(20).map(PoseName::to_string).collect();
    shown.join(", ") + if numbers.len() > 20 { ", ..." } else { "" }
}
