//! Implausible joint values: a missing decimal mark, or too many turns. A gain absorbs such a value
//! unnoticed, because an angle far from all others has a larger weight.

use crate::stages::observe::exclusions::Exclusion;
use etalon_base::message::{Message, Place, Problems, Result};
use etalon_base::{error, phrase};
use etalon_formats::table::Table;
use etalon_formats::tables::joints::joint_values;
use etalon_robots::{Joint, JointRange, Quantity, Robot};
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// Allowance of a joint beyond its given limits, as a share of their distance: limits are nominal,
/// the zero of the joint has the error of homing, and a drive overshoots.
const OVERSHOOT: f64 = 0.01;
/// Maximum angle (rad) of a joint without given limits: joints of arms turn by up to 1.3 turns to
/// either side.
const LARGEST_ANGLE: f64 = 2.0 * TAU;
/// Maximum distance of a value from the middle half of its column, in widths of that half, for a
/// continuous joint.
const WIDTHS_OF_ANGLES: f64 = 3.0;
/// Maximum distance (mm) of a value of a prismatic joint without given limits from the middle
/// half: no machine has a longer axis.
const LARGEST_LENGTH: f64 = 1e5;
/// Maximum distance for such a joint, in widths of the middle half.
const WIDTHS_OF_LENGTHS: f64 = 100.0;
/// Minimum number of values of a column with a middle half.
const FEWEST: usize = 8;

/// Joint values of a row, and the name of the row.
#[derive(Clone, Debug)]
pub struct JointRow {
    /// Name of the pose; empty if unknown.
    pub pose: String,
    /// Values in the robot's order, mm or rad; NaN where missing.
    pub joints: Vec<f64>,
    /// Line of the row.
    pub place: Place,
}

/// Possible values of a joint (mm or rad), and their reason: `limits`, `turns` or `others`.
struct Expected {
    ends: [f64; 2],
    /// Allowance beyond the ends.
    allowance: f64,
    reason: &'static str,
}

/// Use of joint values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Joints {
    /// Measured values: a joint cannot have been beyond the given limits.
    Measured,
    /// Candidates, or values for computing poses: the caller reports values beyond the given
    /// limits.
    Proposed,
}

/// Checks the joint values of a table; rows that `exclusions` leave out do not count.
///
/// # Errors
/// Reports all joint values out of range, with their lines.
pub fn check_table(robot: &dyn Robot, table: &Table, exclusions: &[Exclusion], of: Joints) -> Result<()> {
    // columns that are missing or do not read are named where the table is read
    let Ok(values) = joint_values(robot, table, &[]) else { return Ok(()) };
    let poses = table.optional_poses().unwrap_or_else(|_| vec![None; values.len()]);
    let cycles = table.optional_integers("cycle").unwrap_or_else(|_| vec![None; values.len()]);
    let rules: Vec<_> = exclusions.iter().filter_map(Exclusion::covering).collect();
    let left_out = |row: usize| {
        let (cycle, target) = (cycles[row].unwrap_or(1), table.text(row, "target").unwrap_or_default());
        poses[row].is_some_and(|pose| rules.iter().any(|covers| covers(pose, cycle, target)))
    };
    let kept = values.into_iter().enumerate().filter(|(row, _)| rules.is_empty() || !left_out(*row));
    let rows = kept.map(|(row, joints)| JointRow {
        pose: poses[row].map_or_else(String::new, |pose| pose.to_string()),
        joints,
        place: table.place(row),
    });
    check(robot, &rows.collect::<Vec<_>>(), of)
}

/// Checks the joint values of rows.
///
/// # Errors
/// Reports all joint values out of range, with their places.
pub fn check(robot: &dyn Robot, rows: &[JointRow], of: Joints) -> Result<()> {
    let mut problems = Problems::default();
    for (k, joint) in robot.joints().iter().enumerate() {
        let column: Vec<f64> = rows.iter().map(|row| row.joints.get(k).copied().unwrap_or(f64::NAN)).collect();
        let Some(expected) = expected(robot, k, &column, of) else { continue };
        let [lower, upper] = expected.allowed();
        let out = rows.iter().zip(&column).filter(|(_, value)| **value < lower || **value > upper);
        let out: Vec<Message> = out.map(|(row, value)| out_of_range(joint, *value, &expected, row)).collect();
        match out.first() {
            Some(first) if 2 * out.len() > rows.len() => {
                problems.0.push(column_out_of_range(joint, &column, &expected, out.len(), first));
            }
            _ => problems.0.extend(out),
        }
    }
    // files in the order of their rows
    let mut files: BTreeMap<&str, usize> = BTreeMap::new();
    for (i, row) in rows.iter().enumerate() {
        files.entry(&row.place.file).or_insert(i);
    }
    let order = |place: &Place| (files.get(place.file.as_str()).copied(), place.line);
    problems.0.sort_by_key(|message| message.place.as_deref().map(order));
    problems.check().map(drop)
}

impl Expected {
    fn allowed(&self) -> [f64; 2] {
        [self.ends[0] - self.allowance, self.ends[1] + self.allowance]
    }
}

/// The possible values of joint `k`; `None` if all are possible.
fn expected(robot: &dyn Robot, k: usize, column: &[f64], of: Joints) -> Option<Expected> {
    let is_angle = robot.joints()[k].quantity == Quantity::Angle;
    // limits refer to the joint, logged values perhaps to its motor
    let gain = Some(robot.nominal_gain(k)).filter(|gain| gain.is_normal()).unwrap_or(1.0);
    match robot.joint_range(k) {
        JointRange::Limits(_) if of == Joints::Proposed => None,
        JointRange::Limits([lower, upper]) => {
            let mut ends = [lower, upper].map(|end| end / gain);
            ends.sort_by(f64::total_cmp);
            Some(Expected { ends, allowance: OVERSHOOT * (ends[1] - ends[0]), reason: "limits" })
        }
        JointRange::Unstated if is_angle => {
            let largest = LARGEST_ANGLE / gain.abs();
            Some(Expected { ends: [-largest, largest], allowance: 0.0, reason: "turns" })
        }
        JointRange::Unstated => around(column, LARGEST_LENGTH / gain.abs(), WIDTHS_OF_LENGTHS),
        JointRange::Endless => around(column, LARGEST_ANGLE / gain.abs(), WIDTHS_OF_ANGLES),
    }
}

/// Returns the range of values around the middle half of a column: wider by `least`, or by `widths`
/// times the width of this half, whichever is larger.
fn around(column: &[f64], least: f64, widths: f64) -> Option<Expected> {
    let mut sorted: Vec<f64> = column.iter().copied().filter(|value| value.is_finite()).collect();
    sorted.sort_by(f64::total_cmp);
    let (lower, upper) =
        (*sorted.get(sorted.len() / 4)?, *sorted.get(sorted.len().saturating_sub(1 + sorted.len() / 4))?);
    let far = least.max(widths * (upper - lower));
    let ends = [lower - far, upper + far];
    (sorted.len() >= FEWEST).then_some(Expected { ends, allowance: 0.0, reason: "others" })
}

/// One message for a joint if most of its values are out of range; `first` is the message of the
/// first one.
fn column_out_of_range(joint: &Joint, column: &[f64], expected: &Expected, out: usize, first: &Message) -> Message {
    let (factor, units) = match joint.quantity {
        Quantity::Angle => (1f64.to_radians(), "degrees"),
        _ => (1e-3, "millimetres"),
    };
    let [lower, upper] = expected.allowed();
    let fits = column.iter().filter(|value| value.is_finite()).all(|value| (lower..=upper).contains(&(factor * value)));
    let message = first.clone().within(phrase!("values-of-column", count = out, total = column.len()));
    if fits { message.hint(phrase!("check-column-unit", units)) } else { message }
}

fn out_of_range(joint: &Joint, value: f64, expected: &Expected, row: &JointRow) -> Message {
    let unit = joint.quantity.unit();
    let rounded = |value: f64| (1e4 * joint.quantity.outward(value)).round() / 1e4;
    let [lower, upper] = expected.ends.map(rounded);
    let (name, value, reason) = (&joint.name, rounded(value), expected.reason);
    let message = error!("joint-out-of-range", joint = name, value, unit, lower, upper, reason).at(row.place.clone());
    if row.pose.is_empty() { message } else { message.within(phrase!("at-pose", pose = row.pose)) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_base::catalogue::IntoArgument;
    use etalon_campaign::read_robot;

    const TABLE: &str = "model = \"serial\"\nconvention = \"dh\"\njoint = [\n\
        { theta_deg = 0, d_mm = 0, a_mm = 0, alpha_deg = -90, prismatic = true },\n\
        { theta_deg = 0, d_mm = 290, a_mm = 0, alpha_deg = -90 },\n]\n";
    const URDF: &str = "<robot name=\"r\"><link name=\"a\"/><link name=\"b\"/><link name=\"c\"/>\
        <joint name=\"lift\" type=\"prismatic\"><parent link=\"a\"/><child link=\"b\"/>\
        <limit lower=\"0\" upper=\"0.8\" effort=\"1\" velocity=\"1\"/></joint>\
        <joint name=\"table\" type=\"continuous\"><parent link=\"b\"/><child link=\"c\"/></joint></robot>";

    /// `true` if the values of a prismatic and of a revolute joint, mm and deg, are in range.
    fn in_range(robot: &str, rows: impl IntoIterator<Item = [f64; 2]>) -> bool {
        messages(robot, rows).is_empty()
    }

    fn messages(robot: &str, rows: impl IntoIterator<Item = [f64; 2]>) -> Vec<Message> {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("robot.toml");
        std::fs::write(&path, robot).unwrap();
        std::fs::write(folder.path().join("r.urdf"), URDF).unwrap();
        let robot = read_robot(&path).unwrap().build(&["ball".to_owned()]).unwrap();
        let row = |[mm, deg]: [f64; 2]| JointRow {
            pose: String::new(),
            joints: vec![mm, deg.to_radians()],
            place: Place::default(),
        };
        let rows: Vec<JointRow> = rows.into_iter().map(row).collect();
        check(robot.as_ref(), &rows, Joints::Measured).err().unwrap_or_default().0
    }

    /// Twenty rows of small motions, and one more.
    fn and(last: [f64; 2]) -> impl Iterator<Item = [f64; 2]> {
        (0..20).map(|i| [f64::from(i % 5), f64::from(i % 7)]).chain([last])
    }

    #[test]
    fn what_no_machine_reaches_is_out_of_range_and_a_lone_pose_far_out_is_not() {
        for (last, sound) in [
            ([99_000.0, 719.0], true),
            ([-99_000.0, -719.0], true),
            ([0.0, 721.0], false),
            ([123_456_789.0, 0.0], false),
            ([f64::NAN, f64::NAN], true),
        ] {
            assert_eq!(in_range(TABLE, and(last)), sound, "{last:?}");
        }
        // a few rows have no middle half
        assert!(in_range(TABLE, [[0.0, 0.0], [123_456_789.0, 0.0]]));
    }

    #[test]
    fn a_column_out_of_range_is_one_message_which_names_a_unit_where_it_explains_all() {
        let column = |factor: f64| (0..20).map(move |i| [0.0, factor * f64::from(i + 20)]);
        let hint = |factor: f64| match &messages(TABLE, column(factor))[..] {
            [one] => one.arguments.get("hint").cloned(),
            all => panic!("{all:?}"),
        };
        let unit = phrase!("check-column-unit", units = "degrees").argument();
        assert_eq!(hint(180.0 / std::f64::consts::PI), Some(unit));
        assert_eq!(hint(1e6), None);
    }

    #[test]
    fn values_of_motors_are_judged_by_what_they_move() {
        // 4096 counts a millimetre, 100 turns of the motor for one of the joint
        let geared = format!("{TABLE}[nominal]\ngain_1 = 2.44140625e-4\ngain_2 = -0.01\n");
        let rows = |last| (0..20).map(|i| [4096.0 * f64::from(i), 7200.0 * f64::from(i % 7)]).chain([last]);
        for (last, sound) in
            [([4096.0 * 9e4, 71_900.0], true), ([4096.0 * 9e9, 71_900.0], false), ([4096.0 * 9e4, 72_100.0], false)]
        {
            assert_eq!(in_range(&geared, rows(last)), sound, "{last:?}");
        }
        let limited = geared.replace("alpha_deg = -90 }", "alpha_deg = -90, limits_deg = [-170, 10] }");
        for (deg, sound) in [(17_100.0, true), (17_200.0, false), (-1_100.0, true), (-1_200.0, false)] {
            assert_eq!(in_range(&limited, [[0.0, deg]]), sound, "{deg}");
        }
    }

    #[test]
    fn stated_limits_count_with_an_allowance_and_a_joint_without_end_makes_turns() {
        let urdf = "model = \"urdf\"\nfile = \"r.urdf\"\nbase_link = \"a\"\ntool_link = \"c\"\n";
        for (last, sound) in [
            // the torso of a public humanoid: 0.18 mm beyond
            ([800.18, 0.0], true),
            ([-0.05, 700.0], true),
            ([809.0, 0.0], false),
            ([0.0, 3600.0], false),
            ([0.0, 5e7], false),
        ] {
            assert_eq!(in_range(urdf, and(last)), sound, "{last:?}");
        }
        // a turntable whose encoder counts on
        assert!(in_range(urdf, (0..200).map(|i| [0.0, 90.0 * f64::from(i)])));
    }
}
