//! Observations of a campaign: measured positions with the joint values of a log, or a table of any
//! kinds.

use super::{Row, listed};
use crate::stages::kinds::{self, Observed, RowDefaults};
use crate::stages::observe::positions;
use etalon_base::message::{Message, Place, Result};
use etalon_base::pose_name::PoseName;
use etalon_base::{error, phrase, warning};
use etalon_formats::table::{ASSEMBLY, COVARIANCES, QUATERNION, TIME, Table, Values, XYZ};
use etalon_formats::tables::joints::{stated_columns, stated_mode, wrong_direction};
use etalon_formats::{JointLog, SharedText};
use etalon_identify::{Measured, Observation, Settings};
use etalon_robots::Robot;
use std::collections::BTreeSet;

/// Observations with one log, or of a table.
#[derive(Clone, Debug)]
pub enum Observations {
    /// Measured positions joined with a log.
    Log(JoinedLog),
    /// Rows of any kinds.
    Table(Table),
}

/// Measured positions joined with a log, sorted by pose, cycle and the robot's order of targets.
#[derive(Clone, Debug)]
pub struct JoinedLog {
    /// The positions.
    pub measured: Vec<Measured>,
    /// Joint values of each position from the log (mm or deg), then directions.
    logged: Vec<Vec<f64>>,
    /// Orientations of the bodies at each position, in the world, if they were measured.
    orientations: Vec<Option<[f64; 4]>>,
    /// Stations in whose frames the positions are, if it is not the world.
    stations: Vec<Option<SharedText>>,
    /// Columns of the joint values.
    joints: Vec<String>,
    targets: Vec<String>,
    dimension: usize,
    has_modes: bool,
}

/// Time of an observation.
#[derive(Clone, Debug)]
pub struct ObservationTime {
    /// Name of the pose.
    pub pose: PoseName,
    /// Number of the repeat.
    pub cycle: i64,
    /// Name of the target.
    pub target: String,
    /// The time (s).
    pub time_s: f64,
}

impl Observations {
    /// Observations of `robot` and settings of their identification; fixed points and surfaces in
    /// the rows of a table are added to the parameters of `robot`.
    pub fn observed(
        &self,
        robot: &mut dyn Robot,
        without: RowDefaults,
        settings: Settings,
        messages: &mut Vec<Message>,
    ) -> Result<Observed> {
        match self {
            Self::Table(table) => kinds::observed(robot, table, without, settings, messages),
            Self::Log(log) => {
                kinds::misspelt_targets(&log.measured, &log.targets)?;
                messages.extend(kinds::moving_base(robot));
                Ok(Observed { observations: log.observations(robot, messages)?, settings })
            }
        }
    }

    /// The positions alone, as observations of `robot`.
    pub fn positions(&self, robot: &dyn Robot, messages: &mut Vec<Message>) -> Result<Vec<Observation>> {
        match self {
            Self::Table(table) => positions::observations(robot, table, messages),
            Self::Log(log) => log.observations(robot, messages),
        }
    }

    /// Names of the poses.
    pub fn poses(&self) -> Result<BTreeSet<PoseName>> {
        match self {
            Self::Table(table) => kinds::poses(table),
            Self::Log(log) => Ok(log.measured.iter().map(|m| m.pose).collect()),
        }
    }

    /// Times of the observations; empty if not given.
    pub fn times(&self) -> Result<Vec<ObservationTime>> {
        match self {
            Self::Table(table) if !table.has(TIME) => Ok(Vec::new()),
            Self::Table(table) => {
                let (poses, cycles) = (table.poses()?, table.integers("cycle")?);
                let (targets, times) = (table.texts("target")?, table.numbers(TIME)?);
                let time = |row: usize| ObservationTime {
                    pose: poses[row],
                    cycle: cycles[row],
                    target: targets[row].to_string(),
                    time_s: times[row],
                };
                Ok((0..table.height()).map(time).collect())
            }
            Self::Log(log) => {
                let time = |m: &Measured| {
                    let target = log.targets[m.target].clone();
                    Some(ObservationTime { pose: m.pose, cycle: m.cycle, target, time_s: m.time_s? })
                };
                Ok(log.measured.iter().map(time).collect::<Option<_>>().unwrap_or_default())
            }
        }
    }

    /// The table to be written: `[line] pose cycle target x_mm y_mm [z_mm]` and the joints.
    pub fn into_table(self) -> Table {
        match self {
            Self::Table(table) => table.with_lines(),
            Self::Log(log) => log.table(),
        }
    }
}

impl JoinedLog {
    /// The rows of a join with `log`, each with a pose and a cycle.
    pub(super) fn new(mut rows: Vec<Row>, log: &JointLog, robot: &dyn Robot) -> Result<Self> {
        rows.sort_by_key(|row| (row.pose, row.cycle, row.target));
        let column = |name: &String| {
            let found = log.joints.iter().position(|other| other == name).ok_or_else(|| {
                error!("log-joint-missing", log = log.name, joint = name, column = name)
                    .hint_names(name, log.joints.iter().map(String::as_str))
            });
            Ok(found?)
        };
        let mut joints: Vec<String> = robot.joints().iter().map(|j| j.column()).collect();
        joints.extend(robot.approached().iter().map(|&k| robot.joints()[k].direction_column()));
        joints.extend(stated_columns(robot));
        let columns = joints.iter().map(column).collect::<Result<Vec<usize>>>()?;
        let factors = robot.joints().iter().map(|joint| joint.quantity.inward(1.0));
        let factors: Vec<f64> = factors.chain(joints[robot.joints().len()..].iter().map(|_| 1.0)).collect();
        let (mut measured, mut logged) = (Vec::with_capacity(rows.len()), Vec::with_capacity(rows.len()));
        let orientations = rows.iter().map(|row| row.orientation).collect();
        let stations = rows.iter().map(|row| row.station.clone()).collect();
        for row in rows {
            let (Some(pose), Some(cycle)) = (row.pose, row.cycle) else {
                let column = if row.pose.is_none() { "pose" } else { "cycle" };
                return Err(error!("column-empty", column).into());
            };
            let values: Vec<f64> = columns.iter().map(|&k| row.joints.get(k).copied().unwrap_or(f64::NAN)).collect();
            let [x, y, z] = row.world_mm;
            measured.push(Measured {
                pose,
                cycle,
                target: row.target,
                at_mm: [x, y, if robot.dimension() == 3 { z } else { 0.0 }],
                covariance_mm2: row.covariance_mm2,
                joints: values.iter().zip(&factors).map(|(value, factor)| factor * value).collect(),
                assembly: row.assembly,
                time_s: row.time_s,
            });
            logged.push(values);
        }
        let has_modes = robot.has_assembly_modes() && log.has(ASSEMBLY);
        let targets = robot.targets().to_vec();
        let dimension = robot.dimension();
        Ok(Self { measured, logged, orientations, stations, joints, targets, dimension, has_modes })
    }

    /// `true` if a further station measured positions.
    pub(super) fn has_stations(&self) -> bool {
        self.stations.iter().any(Option::is_some)
    }

    /// `true` if an orientation was measured.
    pub(super) fn has_orientations(&self) -> bool {
        self.orientations.iter().any(Option::is_some)
    }

    fn observations(&self, robot: &dyn Robot, messages: &mut Vec<Message>) -> Result<Vec<Observation>> {
        for (i, m) in self.measured.iter().enumerate() {
            let came = robot.approached().iter().zip(&m.joints[robot.joints().len()..]);
            if let Some(message) = came.filter_map(|(&k, d)| wrong_direction(&robot.joints()[k], *d)).next() {
                return Err(message.into());
            }
            if let Some(mode) = m.assembly.filter(|_| self.has_modes) {
                stated_mode(i, mode)?;
            }
        }
        positions::grouped(robot, &self.measured, messages, |_| Place::default())
    }

    /// The rows with the columns of a table of observations.
    pub(super) fn table(&self) -> Table {
        let rows = || self.measured.iter();
        let real = |number: &dyn Fn(&Measured) -> Option<f64>| Values::Numbers(rows().map(number).collect());
        let mut table = Table::default();
        if self.has_orientations() {
            let kind = |q: &Option<[f64; 4]>| Some(if q.is_some() { "pose" } else { "point" }.to_owned());
            table.set("kind", Values::Texts(self.orientations.iter().map(kind).collect()));
        }
        table.set("pose", Values::Poses(rows().map(|m| Some(m.pose)).collect()));
        table.set("cycle", Values::Whole(rows().map(|m| Some(m.cycle)).collect()));
        table.set("target", Values::Texts(rows().map(|m| Some(self.targets[m.target].clone())).collect()));
        if self.has_stations() {
            let name = |station: &Option<SharedText>| station.as_ref().map(ToString::to_string);
            table.set("station", Values::Texts(self.stations.iter().map(name).collect()));
        }
        for (axis, name) in XYZ[..self.dimension].iter().enumerate() {
            table.set(*name, real(&|m| Some(m.at_mm[axis])));
        }
        if self.has_orientations() {
            for (k, name) in QUATERNION.into_iter().enumerate() {
                table.set(name, Values::Numbers(self.orientations.iter().map(|q| q.map(|q| q[k])).collect()));
            }
        }
        if rows().any(|m| m.covariance_mm2.is_some()) {
            let elements = (0..3).flat_map(|i| (i..3).map(move |j| (i, j))).zip(COVARIANCES);
            for ((i, j), name) in elements.filter(|((_, j), _)| *j < self.dimension) {
                table.set(name, real(&|m| Some(m.covariance_mm2?[i][j])));
            }
        }
        for (k, name) in self.joints.iter().enumerate() {
            table.set(name, Values::Numbers(self.logged.iter().map(|values| Some(values[k])).collect()));
        }
        if rows().all(|m| m.time_s.is_some()) {
            table.set(TIME, real(&|m| m.time_s));
        }
        if self.has_modes {
            table.set(ASSEMBLY, real(&|m| m.assembly));
        }
        table
    }

    /// Returns a warning if some poses lack a target that others have. The cause may be a file of
    /// several targets whose rows are numbered as poses.
    pub(super) fn incomplete(&self, of_rows: Option<&str>) -> Option<Message> {
        // sorted by pose and cycle
        let seen = || self.measured.chunk_by(|a, b| (a.pose, a.cycle) == (b.pose, b.cycle));
        let lacking = seen().filter(|of| of.len() < self.targets.len());
        let poses: BTreeSet<PoseName> = lacking.map(|of| of[0].pose).collect();
        let alone = seen().all(|of| of.len() == 1);
        let message =
            (!poses.is_empty()).then(|| warning!("targets-missing", count = poses.len(), poses = listed(&poses)))?;
        Some(match of_rows.filter(|_| alone) {
            Some(file) => message.hint(phrase!("row-is-a-pose", file)),
            None => message,
        })
    }
}
