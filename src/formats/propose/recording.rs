//! Proposal for a recording of ROS 2 (MCAP): a log for the first topic of joint values, an export
//! for each topic of measured poses or points.

use super::with_remarks;
use crate::dialect::quoted;
use crate::ros_bag::{self, Kind, POSITION, STAMP, Topic};
use etalon_base::error;
use etalon_base::message::{Message, count};
use etalon_documents::FormatsDocument;
use std::fmt::Write as _;

/// Proposes lines for the topics of a recording.
///
/// # Errors
/// Fails if the recording cannot be read, or has no topic of a known type.
pub(super) fn of_recording(file: &str, bytes: &[u8]) -> Result<FormatsDocument, Message> {
    let topics = ros_bag::topics(bytes)?;
    let known: Vec<(&Topic, Kind)> = topics.iter().filter_map(|topic| Some((topic, topic.kind?))).collect();
    if known.is_empty() {
        let found: Vec<String> = topics.iter().map(|topic| format!("{} ({})", topic.name, topic.message)).collect();
        return Err(error!("recording-without-known-topics", found));
    }
    let mut document =
        FormatsDocument { schema: "etalon/formats/1".to_owned(), file: file.to_owned(), ..FormatsDocument::default() };
    document.format = Some("mcap".to_owned());
    document.reasons.push("it is a recording of ROS 2: it begins like an MCAP file".to_owned());
    let mut lines = String::new();
    // joint values first: the document is a log if there are any
    let (logs, exports): (Vec<_>, Vec<_>) = known.into_iter().partition(|(_, kind)| *kind == Kind::JointState);
    for (topic, kind) in logs.iter().chain(&exports) {
        let text = match ros_bag::text(bytes, &topic.name) {
            Ok(text) => text,
            Err(message) => {
                document.doubts.push(format!("topic `{}` cannot be read: {message}", topic.name));
                continue;
            }
        };
        let rows = text.lines().count() - 1;
        let messages = count(rows, "message");
        document.reasons.push(format!("topic `{}` has {messages} of type {}", topic.name, topic.message));
        let is_log = *kind == Kind::JointState;
        if is_log && document.kind == "log" {
            document.doubts.push(format!("topic `{}` has joint values too", topic.name));
            continue;
        }
        if document.kind.is_empty() {
            document.kind = if is_log { "log" } else { "export" }.to_owned();
            document.rows = rows;
        }
        let head = text.lines().next().unwrap_or_default();
        lines += &if is_log { log(file, topic, head) } else { export(file, topic, *kind) };
    }
    if document.kind == "log" {
        document.questions.push(
            "which joint of the robot each column is; JointState has rad for revolute joints, m for prismatic ones: \
             write `q1_m` for a prismatic joint"
                .to_owned(),
        );
    }
    if !exports.is_empty() {
        document.questions.push("which target each topic of poses or points is".to_owned());
    }
    if document.kind.is_empty() {
        // the only topic of a known type cannot be read
        ros_bag::text(bytes, logs.first().or(exports.first()).map_or("", |(topic, _)| &topic.name))?;
    }
    document.toml = with_remarks(&document, &lines);
    Ok(document)
}

fn log(file: &str, topic: &Topic, head: &str) -> String {
    let mut columns = format!("time_s = {}", quoted(STAMP));
    for (joint, column) in (1..).zip(head.split('\t').filter(|name| name.starts_with(POSITION))) {
        let _ = write!(columns, ", q{joint}_rad = {}", quoted(column));
    }
    format!("[log]\nfile = {}\ntopic = {}\ncolumns = {{ {columns} }}\n", quoted(file), quoted(&topic.name))
}

fn export(file: &str, topic: &Topic, kind: Kind) -> String {
    let columns = match kind {
        Kind::PointStamped => "x = \"point.x\", y = \"point.y\", z = \"point.z\"",
        _ => {
            "x = \"pose.position.x\", y = \"pose.position.y\", z = \"pose.position.z\", qw = \"pose.orientation.w\", \
             qx = \"pose.orientation.x\", qy = \"pose.orientation.y\", qz = \"pose.orientation.z\""
        }
    };
    format!(
        "[[export]]\nfile = {}\nunit = \"m\"                 # REP 103\nformat = {{ topic = {}, header = 1, columns = {{ \
         time_s = \"{STAMP}\", {columns} }} }}\ntarget = \"?\"               # which target the rows are of\n",
        quoted(file),
        quoted(&topic.name)
    )
}
