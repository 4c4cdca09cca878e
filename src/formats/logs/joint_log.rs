//! Joint values of a log, and the meaning of the columns of a log.

use crate::table::{ASSEMBLY, LABEL, Table, Values};
use crate::tables::joints::is_stated_column;
use etalon_base::angle::Turn;
use etalon_base::pose_name::PoseName;
use etalon_robots::{Joint, Quantity};

/// Keys of `columns` for the time, with their units (s).
const TIMES: [(&str, f64); 4] = [("time_s", 1.0), ("time_ms", 1e-3), ("time_us", 1e-6), ("time_ns", 1e-9)];

/// Suffix of columns of the directions from which joints came.
pub const DIRECTION: &str = "_direction";

/// Returns the factor from a unit to mm or deg.
fn factor(unit: &str, quantity: Quantity) -> Option<f64> {
    match (quantity, unit) {
        (Quantity::Length, "mm") | (Quantity::Angle, "deg") => Some(1.0),
        (Quantity::Length, "m") => Some(1000.0),
        (Quantity::Length, "um") => Some(0.001),
        (Quantity::Length, "inch") => Some(25.4),
        (Quantity::Angle, "rad") => Some(180.0 / std::f64::consts::PI),
        _ => None,
    }
}

/// Turn of a column of a log, if it has the angles of a joint: lengths and directions never wrap.
fn turn(column: &str) -> Option<Turn> {
    let is_joint = !column.ends_with(DIRECTION) && !is_stated_column(column);
    (is_joint && column.ends_with("_deg")).then_some(Turn::DEGREES)
}

/// Maximum step (deg) between rows that follow a motion.
const DENSE_DEG: f64 = 45.0;

/// `true` if nine of ten steps are small: the rows follow the motion.
fn is_dense(turn: Turn, values: &[f64]) -> bool {
    let steps = values.windows(2).map(|pair| turn.difference(pair[1], pair[0]).abs());
    let far = steps.filter(|step| *step > DENSE_DEG).count();
    10 * far < values.len()
}

/// `true` if a key of `columns` is this joint with a unit, such as `q1_deg` or `q1_rad`.
pub fn is_joint_column(key: &str, joint: &Joint) -> bool {
    key.rsplit_once('_').is_some_and(|(name, unit)| name == joint.name && factor(unit, joint.quantity).is_some())
}

/// `true` if the log of any robot can have this key of `columns`.
pub fn is_common_column(key: &str) -> bool {
    ["pose", "cycle", LABEL, ASSEMBLY].contains(&key) || TIMES.iter().any(|(name, _)| *name == key)
}

/// Returns the column of the table for a key of `columns`, and the factor of its values.
pub fn meaning(key: &str) -> Option<(String, f64)> {
    if let Some((_, seconds)) = TIMES.iter().find(|(name, _)| *name == key) {
        return Some(("time_s".to_owned(), *seconds));
    }
    if is_common_column(key) || key.ends_with(DIRECTION) || is_stated_column(key) {
        return Some((key.to_owned(), 1.0));
    }
    let (name, unit) = key.rsplit_once('_')?;
    let quantity = [Quantity::Length, Quantity::Angle].into_iter().find(|q| factor(unit, *q).is_some())?;
    Some((format!("{name}_{}", quantity.unit()), factor(unit, quantity)?))
}

/// Joint values of a log, row by row.
#[derive(Clone, Debug, Default)]
pub struct JointLog {
    /// Name of the log in the campaign.
    pub name: String,
    /// File as named in the campaign.
    pub file: String,
    /// Files of the exports with these joints, if there are several.
    pub files: Vec<String>,
    /// Columns of the table in order: `row line pose cycle time_s label` if given, and the joints.
    pub columns: Vec<String>,
    /// Columns of joints (mm or deg) and of directions of joints.
    pub joints: Vec<String>,
    /// Rows in the order of the file.
    pub rows: Vec<LogRow>,
}

/// Row of a log, or a standstill of the robot.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LogRow {
    /// Number of the data row, from 1.
    pub row: i64,
    /// Line of the file, from 1.
    pub line: usize,
    /// Number of the file in [`JointLog::files`], from 1.
    pub file: Option<i64>,
    /// Name of the pose.
    pub pose: Option<PoseName>,
    /// Number of the repeat.
    pub cycle: Option<i64>,
    /// Time; the middle of a standstill.
    pub time_s: Option<f64>,
    /// Beginning and end of a standstill.
    pub standing_s: Option<[f64; 2]>,
    /// Label of the point that the robot touches.
    pub label: Option<String>,
    /// Assembly mode, +1 or -1.
    pub assembly: Option<f64>,
    /// Joint values in the order of [`JointLog::joints`].
    pub joints: Vec<f64>,
}

impl JointLog {
    /// Values of a joint in the order of the rows, without the jumps of a controller that wraps
    /// angles. Between distant rows, such as rows of poses, a joint may really move by more than
    /// half a turn: such values are returned unchanged.
    pub fn motion(&self, joint: usize) -> Vec<f64> {
        let values: Vec<f64> = self.rows.iter().map(|row| row.joints[joint]).collect();
        match turn(&self.joints[joint]).filter(|turn| is_dense(*turn, &values)) {
            Some(turn) => turn.unwound(&values),
            None => values,
        }
    }

    /// `true` if the log has this column.
    pub fn has(&self, column: &str) -> bool {
        self.columns.iter().any(|c| c == column)
    }

    /// Returns the log as a table.
    pub fn table(&self) -> Table {
        let whole = |f: fn(&LogRow) -> Option<i64>| Values::Whole(self.rows.iter().map(f).collect());
        let real = |f: &dyn Fn(&LogRow) -> Option<f64>| Values::Numbers(self.rows.iter().map(f).collect());
        let mut table = Table::default();
        for name in &self.columns {
            let values = match (name.as_str(), self.joints.iter().position(|joint| joint == name)) {
                (_, Some(k)) => real(&|r| r.joints.get(k).copied()),
                ("row", _) => whole(|r| Some(r.row)),
                ("line", _) => whole(|r| Some(r.line as i64)),
                ("pose", _) => Values::Poses(self.rows.iter().map(|r| r.pose).collect()),
                ("cycle", _) => whole(|r| r.cycle),
                ("time_s", _) => real(&|r| r.time_s),
                ("from_s", _) => real(&|r| Some(r.standing_s?[0])),
                ("to_s", _) => real(&|r| Some(r.standing_s?[1])),
                (ASSEMBLY, _) => real(&|r| r.assembly),
                _ => Values::Texts(self.rows.iter().map(|r| r.label.clone()).collect()),
            };
            table.set(name, values);
        }
        table
    }
}
