//! ROS messages as CSV.
//!
//! The order of joints in a JointState is arbitrary. Joints are found by name, in the header
//! (`lbr_joint_1,lbr_joint_2,...`) or in the rows of `rostopic echo -p`
//! (`field.name0,...,field.position0,...`).

use super::sheet::Sheet;
use super::{About, LogFormat};
use crate::exports::Recognised;
use etalon_base::error;
use etalon_base::message::Problems;

/// ROS messages: joints in any order, named by the header or by their rows.
pub(super) struct Ros;

impl LogFormat for Ros {
    fn about(&self) -> About {
        About {
            name: "ros",
            title: "ROS CSV",
            description: "ROS messages as CSV: joints in any order, named by the header or by their rows.",
        }
    }

    fn recognise(&self, header: &[&str], _text: &str) -> Option<Recognised> {
        let echo = header.first() == Some(&"%time") && header.iter().any(|name| name.starts_with("field."));
        Recognised::by(echo, 0.9, "messages of ROS: its header is that of `rostopic echo -p`")
    }

    fn unit_of(&self, column: &str) -> Option<&'static str> {
        unit_of(column)
    }

    fn has_stable_order(&self) -> bool {
        false
    }

    fn name_columns(&self, sheet: &mut Sheet, problems: &mut Problems) {
        name_joints(sheet, problems);
    }
}

/// Returns the unit of a column (REP 103: rad and m; times of `rostopic echo` in ns). Positions may
/// be in rad or m: the campaign states which.
fn unit_of(column: &str) -> Option<&'static str> {
    match column {
        "%time" | "field.header.stamp" => Some("ns"),
        _ if column.starts_with("field.velocity") => Some("rad/s"),
        _ if column.starts_with("field.effort") => Some("Nm"),
        _ => None,
    }
}

/// Names each column `field.positionN` after the joint in the column `field.nameN`.
fn name_joints(sheet: &mut Sheet, problems: &mut Problems) {
    let Some(header) = &sheet.header else { return };
    let mut named = header.fields.clone();
    for (at, heading) in header.fields.iter().enumerate() {
        let Some(number) = heading.strip_prefix("field.name") else { continue };
        let position = format!("field.position{number}");
        let Some(to) = header.fields.iter().position(|h| *h == position) else { continue };
        let Some(first) = sheet.rows.first().and_then(|row| row.fields.get(at)) else { continue };
        named[to].clone_from(first);
        if let Some(row) = sheet.rows.iter().find(|row| row.fields.get(at) != Some(first)) {
            let message = error!("ros-joints-change", number, found = row.field(at), first = first.as_ref());
            problems.0.push(message.at(row.place(sheet.file)));
        }
    }
    if let Some(header) = &mut sheet.header {
        header.fields = named;
    }
}
