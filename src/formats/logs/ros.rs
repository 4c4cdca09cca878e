//! ROS messages as CSV, or as a topic of a recording (MCAP).
//!
//! The order of joints in a JointState is arbitrary. Joints are found by name, in the header
//! (`lbr_joint_1,lbr_joint_2,...`), in the rows of `rostopic echo -p`
//! (`field.name0,...,field.position0,...`) or in the messages of a recording
//! (`position.lbr_joint_1`).

use super::{About, LogFormat, Wanted, other_unit};
use crate::exports::Recognised;
use crate::ros_bag::{POSITION, STAMP};
use etalon_base::message::{Message, Problems};
use etalon_base::{error, phrase};
use etalon_documents::Refused;
use etalon_tables::ColumnSource;
use etalon_tables::sheet::Sheet;

/// ROS messages: joints in any order, named by the header or by their rows.
pub(super) struct Ros;

impl LogFormat for Ros {
    fn about(&self) -> About {
        About {
            name: "ros",
            title: "ROS CSV",
            description: "ROS messages as CSV or a topic of a recording: joints in any order, by name.",
        }
    }

    fn recognise(&self, header: &[&str], _text: &str) -> Option<Recognised> {
        let echo = header.first() == Some(&"%time") && header.iter().any(|name| name.starts_with("field."));
        Recognised::by(echo, 0.9, phrase!("is-ros-messages"))
    }

    fn column_unit(&self, column: &str) -> Option<&'static str> {
        column_unit(column)
    }

    fn has_stable_order(&self) -> bool {
        false
    }

    fn statement(&self, wanted: &Wanted) -> Option<Message> {
        position_unit(wanted)
    }

    fn name_columns(&self, sheet: &mut Sheet, problems: &mut Problems) {
        name_joints(sheet, problems);
    }

    fn cut(&self, sheet: &mut Sheet, wanted: &[(usize, &Wanted)], _problems: &mut Problems) -> Vec<Refused> {
        remove_messages_of_other_joints(sheet, wanted).into_iter().collect()
    }
}

/// Returns the error of a joint value of a recording in another unit than rad or m
/// (JointState.msg).
fn position_unit(wanted: &Wanted) -> Option<Message> {
    let ColumnSource::Heading(column) = &wanted.column.at else { return None };
    let stated = wanted.unit().filter(|_| column.starts_with(POSITION) && wanted.column.per_count.is_none())?;
    let known = match stated {
        "deg" => "rad",
        "mm" | "um" | "inch" => "m",
        _ => return None,
    };
    other_unit(wanted, column, stated, known)
}

/// Leaves out messages without any wanted joint: several nodes publish to one topic, each its own
/// joints.
fn remove_messages_of_other_joints(sheet: &mut Sheet, wanted: &[(usize, &Wanted)]) -> Option<Refused> {
    let header = sheet.header.as_ref()?;
    let is_joint = |at: &usize| header.fields.get(*at).is_some_and(|name| name.starts_with(POSITION));
    let joints: Vec<usize> = wanted.iter().map(|(at, _)| *at).filter(is_joint).collect();
    let others =
        |row: &etalon_tables::lexer::Row| !joints.is_empty() && joints.iter().all(|at| row.field(*at).is_empty());
    let count = sheet.rows.iter().filter(|row| others(row)).count();
    let first = sheet.rows.iter().find(|row| others(row))?;
    let reason = phrase!("ros-messages-of-other-joints", count);
    let refused = Refused::new(first.line, first.text, reason);
    sheet.rows.retain(|row| !others(row));
    Some(refused)
}

/// Returns the unit of a column (REP 103: rad and m; times of `rostopic echo` in ns). Positions may
/// be in rad or m: the campaign shows which.
fn column_unit(column: &str) -> Option<&'static str> {
    match column {
        "%time" | "field.header.stamp" => Some("ns"),
        STAMP => Some("s"),
        _ if column.starts_with("field.velocity") || column.starts_with("velocity.") => Some("rad/s"),
        _ if column.starts_with("field.effort") || column.starts_with("effort.") => Some("Nm"),
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
