//! Universal Robots RTDE recordings: a row for each cycle of the controller, columns named after
//! the outputs of RTDE.
//!
//! Units (RTDE guide of Universal Robots): rad, m, s. A recording may name a column twice (a real
//! one has `target_current_0` to `_5` before and after `target_q`). Such a name is rejected unless
//! the campaign contains its occurrence.

use super::{About, LogFormat};
use crate::exports::Recognised;
use etalon_base::phrase;

/// Recordings of Universal Robots RTDE: rad, m, s.
pub(super) struct UrRtde;

impl LogFormat for UrRtde {
    fn about(&self) -> About {
        About {
            name: "ur_rtde",
            title: "UR RTDE",
            description: "Universal Robots RTDE recording: rad, m, s; names that occur twice.",
        }
    }

    fn recognise(&self, header: &[&str], _text: &str) -> Option<Recognised> {
        let joints = header.iter().any(|name| name.starts_with("actual_q_") || name.starts_with("target_q_"));
        let what = phrase!("is-ur-rtde");
        Recognised::by(joints, if header.contains(&"timestamp") { 0.9 } else { 0.7 }, what)
    }

    fn column_unit(&self, column: &str) -> Option<&'static str> {
        column_unit(column)
    }
}

/// Beginnings of names, and their units.
const UNITS: [(&str, &str); 22] = [
    ("timestamp", "s"),
    ("target_q_", "rad"),
    ("actual_q_", "rad"),
    ("target_qd_", "rad/s"),
    ("actual_qd_", "rad/s"),
    ("target_qdd_", "rad/s²"),
    ("target_current_", "A"),
    ("actual_current_", "A"),
    ("target_moment_", "Nm"),
    ("joint_control_output_", "A"),
    ("joint_temperatures_", "°C"),
    ("actual_TCP_pose_0", "m"),
    ("actual_TCP_pose_1", "m"),
    ("actual_TCP_pose_2", "m"),
    ("actual_TCP_pose_", "rad"),
    ("target_TCP_pose_0", "m"),
    ("target_TCP_pose_1", "m"),
    ("target_TCP_pose_2", "m"),
    ("target_TCP_pose_", "rad"),
    ("actual_TCP_speed_", "m/s"),
    ("target_TCP_speed_", "m/s"),
    ("actual_TCP_force_", "N"),
];

/// Returns the unit of a column.
fn column_unit(column: &str) -> Option<&'static str> {
    UNITS.iter().find(|(start, _)| column.starts_with(start)).map(|(_, unit)| *unit)
}
