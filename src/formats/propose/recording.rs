//! Proposal for a recording of ROS 2 (MCAP): a log for the first topic of joint values, an export
//! for each topic of measured poses or points.

use super::Proposed;
use super::motion::Motion;
use super::statements::{Line, Lines, Target};
use crate::dialect::quoted;
use crate::mcap::Topic;
use crate::ros_bag::{self, Kind, POSITION, STAMP};
use etalon_base::message::Message;
use etalon_base::{error, phrase};
use etalon_documents::FormatsDocument;
use etalon_robots::{Joint, Quantity, Robot};

/// Name of the storage of a recording in MCAP.
const MCAP: &str = "mcap";

/// Proposes lines for the topics of a recording.
///
/// # Errors
/// Fails if the recording cannot be read, or has no topic of a known type.
pub(super) fn propose_recording(file: &str, bytes: &[u8], robot: Option<&dyn Robot>) -> Result<Proposed, Message> {
    let topics = ros_bag::topics(bytes)?;
    let known: Vec<(&Topic, Kind)> = topics.iter().filter_map(|topic| Some((topic, topic.kind()?))).collect();
    if known.is_empty() {
        let found: Vec<String> = topics.iter().map(|topic| format!("{} ({})", topic.name, topic.message)).collect();
        return Err(error!("recording-without-known-topics", found));
    }
    let mut document =
        FormatsDocument { schema: "etalon/formats/1".to_owned(), file: file.to_owned(), ..FormatsDocument::default() };
    let storage = if ros_bag::is_database(bytes) { "db3" } else { MCAP };
    document.format = Some(storage.to_owned());
    document.because(phrase!("because-recording", storage));
    let mut lines = Lines::default();
    let mut is_named = false;
    // joint values first: the document is a log if there are any
    let (logs, exports): (Vec<_>, Vec<_>) = known.into_iter().partition(|(_, kind)| *kind == Kind::JointState);
    let names: Vec<&str> = logs.iter().chain(&exports).map(|(topic, _)| topic.name.as_str()).collect();
    for ((topic, kind), text) in logs.iter().chain(&exports).zip(ros_bag::texts(bytes, &names)?) {
        let text = match text {
            Ok(text) => text,
            Err(message) => {
                document.doubt(phrase!("doubt-topic-unreadable", topic = topic.name, reason = message.phrase()));
                continue;
            }
        };
        let rows = text.lines().count() - 1;
        document.because(phrase!("because-topic", topic = topic.name, count = rows, message_type = topic.message));
        let is_log = *kind == Kind::JointState;
        if is_log && document.kind == "log" {
            document.doubt(phrase!("doubt-second-log", topic = topic.name));
            continue;
        }
        if document.kind.is_empty() {
            document.kind = if is_log { "log" } else { "export" }.to_owned();
            document.rows = rows;
        }
        let head = text.lines().next().unwrap_or_default();
        let named = robot.filter(|_| is_log).and_then(|robot| named_joints(robot, head));
        is_named |= named.is_some();
        lines = lines.followed_by(match is_log {
            true => log(file, topic, named.unwrap_or_else(|| joints(head))),
            false => export(file, topic, *kind),
        });
    }
    if is_named {
        document.because(phrase!("because-joints-named"));
        document.facts.joints_named = true;
    } else if document.kind == "log" {
        document.ask(phrase!("ask-joint-states"));
    }
    if !exports.is_empty() {
        document.ask(phrase!("ask-targets-of-topics"));
    }
    if document.kind.is_empty() {
        // the only topic of a known type cannot be read
        ros_bag::text(bytes, logs.first().or(exports.first()).map_or("", |(topic, _)| &topic.name))?;
    }
    Ok(Proposed::with_remarks(document, lines))
}

/// Returns the motion of the first topic of joint values.
pub(super) fn motion(bytes: &[u8]) -> Option<Motion> {
    let topics = ros_bag::topics(bytes).ok()?;
    let topic = topics.iter().find(|topic| topic.kind() == Some(Kind::JointState))?;
    let text = ros_bag::text(bytes, &topic.name).ok()?;
    let mut lines = text.lines();
    let head: Vec<&str> = lines.next()?.split('\t').collect();
    let time = head.iter().position(|name| *name == STAMP)?;
    let (mut times_s, mut joints) = (Vec::new(), Vec::new());
    for line in lines {
        let cells: Vec<&str> = line.split('\t').collect();
        let number = |at: usize| cells.get(at).and_then(|cell| cell.parse().ok()).unwrap_or(f64::NAN);
        times_s.push(number(time));
        joints.push((0..head.len()).filter(|at| head[*at].starts_with(POSITION)).map(number).collect());
    }
    let mut motion = Motion::new(times_s, joints)?;
    motion.names = head.iter().filter_map(|name| name.strip_prefix(POSITION)).map(str::to_owned).collect();
    Some(motion)
}

/// Columns of joints that the robot names.
fn named_joints(robot: &dyn Robot, head: &str) -> Option<Vec<(String, String)>> {
    let column = |joint: &Joint| {
        let unit = if joint.quantity == Quantity::Length { "m" } else { "rad" };
        let column = head.split('\t').find(|name| name.strip_prefix(POSITION) == Some(joint.name.as_str()))?;
        Some((format!("{}_{unit}", joint.name), column.to_owned()))
    };
    robot.joints().iter().map(column).collect()
}

/// Columns of joints by their order.
fn joints(head: &str) -> Vec<(String, String)> {
    let columns = head.split('\t').filter(|name| name.starts_with(POSITION));
    (1..).zip(columns).map(|(joint, column)| (format!("q{joint}_rad"), column.to_owned())).collect()
}

fn log(file: &str, topic: &Topic, joints: Vec<(String, String)>) -> Lines {
    let columns = std::iter::once(("time_s".to_owned(), STAMP.to_owned())).chain(joints);
    Lines::section("log")
        .with(Line::File(file.to_owned()))
        .with_text(format!("topic = {}\n", quoted(&topic.name)))
        .with(Line::Columns(columns.map(|(key, column)| (key, quoted(&column))).collect()))
}

fn export(file: &str, topic: &Topic, kind: Kind) -> Lines {
    let columns = match kind {
        Kind::PointStamped => "x = \"point.x\", y = \"point.y\", z = \"point.z\"",
        _ => {
            "x = \"pose.position.x\", y = \"pose.position.y\", z = \"pose.position.z\", qw = \"pose.orientation.w\", \
             qx = \"pose.orientation.x\", qy = \"pose.orientation.y\", qz = \"pose.orientation.z\""
        }
    };
    let topic = quoted(&topic.name);
    Lines::element("export")
        .with(Line::File(file.to_owned()))
        .with_text("unit = \"m\"                 # REP 103\n")
        .with(Line::Format(format!(
            "{{ topic = {topic}, header = 1, columns = {{ time_s = \"{STAMP}\", {columns} }} }}"
        )))
        .with(Line::Target(Target::Open))
}
