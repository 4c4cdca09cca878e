//! Topics of a recording of ROS 2, MCAP or a database of rosbag2 (`.db3`), as rows of text: cells
//! separated by tabs, a row for each message, columns named after the fields of the message
//! definition.
//!
//! Sources: `sensor_msgs/msg/JointState.msg` (position in rad or m); REP 103 (m, s).

use crate::cdr::CdrReader;
use crate::mcap::{self, EachMessage, Topic};
use crate::sqlite::{self, Database, Value};
use etalon_base::error;
use etalon_base::message::Message;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;

/// Maximum number of cells of the table of a topic.
const MOST_CELLS: usize = 1 << 28;
/// Maximum size of the messages of a topic (bytes).
const LARGEST_TOPIC: usize = 2 << 30;

/// Column of the time stamp of a message (s).
pub(crate) const STAMP: &str = "header.stamp";
/// Beginning of the columns of joint values.
pub(crate) const POSITION: &str = "position.";

/// `true` if the bytes begin like a recording: MCAP, or a database of rosbag2.
pub(crate) fn is_recording(bytes: &[u8]) -> bool {
    bytes.starts_with(mcap::MAGIC) || is_database(bytes)
}

/// `true` if the bytes begin like a database.
pub(crate) fn is_database(bytes: &[u8]) -> bool {
    bytes.starts_with(sqlite::MAGIC)
}

/// Type of messages that can be read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// Names and values of joints.
    JointState,
    /// Position and orientation in a frame.
    PoseStamped,
    /// Position in a frame.
    PointStamped,
}

impl Kind {
    const ALL: [(&str, Self); 3] = [
        ("sensor_msgs/JointState", Self::JointState),
        ("geometry_msgs/PoseStamped", Self::PoseStamped),
        ("geometry_msgs/PointStamped", Self::PointStamped),
    ];

    /// Returns the columns behind the header of a message with a fixed set of numbers.
    fn fields(self) -> &'static [&'static str] {
        const POSE: [&str; 7] = [
            "pose.position.x",
            "pose.position.y",
            "pose.position.z",
            "pose.orientation.x",
            "pose.orientation.y",
            "pose.orientation.z",
            "pose.orientation.w",
        ];
        match self {
            Self::JointState => &[],
            Self::PoseStamped => &POSE,
            Self::PointStamped => &["point.x", "point.y", "point.z"],
        }
    }
}

impl Topic {
    /// Kind of its messages, whose type is in the spelling of ROS 2 or ROS 1.
    pub fn kind(&self) -> Option<Kind> {
        let parts = self.message.split_once("/msg/").or(self.message.split_once('/'));
        Kind::ALL.into_iter().find(|(name, _)| name.split_once('/') == parts).map(|(_, kind)| kind)
    }
}

/// Calls `each` with the topic and the data of each message, in the order of the file.
fn each_message(bytes: &[u8], mut each: impl FnMut(&Topic, &[u8]) -> Result<(), Message>) -> Result<(), Message> {
    match is_database(bytes) {
        true => each_row(bytes, &mut each),
        false => mcap::each_message(bytes, &mut each),
    }
}

/// Returns the topics of a recording, by name.
pub(crate) fn topics(bytes: &[u8]) -> Result<Vec<Topic>, Message> {
    let mut topics = BTreeMap::new();
    each_message(bytes, |topic, _| {
        if !topics.contains_key(&topic.name) {
            topics.insert(topic.name.clone(), topic.clone());
        }
        Ok(())
    })?;
    Ok(topics.into_values().collect())
}

/// Returns the messages of a topic as a table.
///
/// # Errors
/// Fails if the recording cannot be read, lacks the topic, or the messages are of another type or
/// encoding.
pub(crate) fn text(bytes: &[u8], wanted: &str) -> Result<String, Message> {
    texts(bytes, &[wanted])?.pop().unwrap_or_else(|| Err(error!("topic-missing", topic = wanted)))
}

/// Returns the messages of several topics, each as a table like [`text`]; the recording is unpacked
/// once.
///
/// # Errors
/// Fails if the recording cannot be read; a topic that cannot be read has an error of its own.
pub(crate) fn texts(bytes: &[u8], wanted: &[&str]) -> Result<Vec<Result<String, Message>>, Message> {
    let mut names = BTreeMap::new();
    let mut tables: BTreeMap<&str, Result<Table, Message>> =
        wanted.iter().map(|topic| (*topic, Ok(Table::default()))).collect();
    each_message(bytes, |topic, data| {
        if !names.contains_key(&topic.name) {
            names.insert(topic.name.clone(), topic.kind().is_some());
        }
        if let Some(table) = tables.get_mut(topic.name.as_str())
            && let Ok(rows) = table
            && let Err(wrong) = rows.take(topic, data)
        {
            *table = Err(wrong);
        }
        Ok(())
    })?;
    let readable = || names.iter().filter(|(_, readable)| **readable).map(|(name, _)| name.as_str());
    let text = |topic: &&str| match tables.get(topic) {
        Some(Ok(rows)) if rows.rows.is_empty() => {
            Err(error!("topic-missing", topic = *topic).hint_names(topic, readable()))
        }
        Some(Ok(rows)) => rows.text(topic),
        Some(Err(wrong)) => Err(wrong.clone()),
        None => Err(error!("topic-missing", topic = *topic)),
    };
    Ok(wanted.iter().map(text).collect())
}

/// Rows with the columns that they have.
#[derive(Default)]
struct Table {
    columns: Vec<String>,
    /// Index of each column.
    index: BTreeMap<String, usize>,
    rows: Vec<Vec<(usize, String)>>,
    joints_without_positions: bool,
    /// Size of the messages (bytes).
    size: usize,
}

/// Fault of a message.
enum Wrong {
    /// The data end before the last field, or are of another encoding.
    Cut,
    Lengths {
        names: usize,
        positions: usize,
    },
    Twice(String),
}

impl Table {
    /// Adds a message of a topic.
    fn take(&mut self, topic: &Topic, data: &[u8]) -> Result<(), Message> {
        let wanted = topic.name.as_str();
        self.size = self.size.saturating_add(data.len());
        if self.size > LARGEST_TOPIC {
            return Err(too_large(wanted));
        }
        let Some(kind) = topic.kind() else {
            let known = Kind::ALL.map(|(name, _)| name);
            return Err(error!("topic-type-unknown", topic = wanted, message = topic.message, known));
        };
        if topic.encoding != "cdr" {
            return Err(error!("topic-encoding-unknown", topic = wanted, encoding = topic.encoding));
        }
        let number = self.rows.len() + 1;
        self.add(kind, data).map_err(|reason| match reason {
            Wrong::Cut => error!("ros-message-malformed", topic = wanted, number),
            Wrong::Lengths { names, positions } => {
                error!("joint-state-lengths-differ", topic = wanted, number, names, positions)
            }
            Wrong::Twice(joint) => error!("joint-state-name-twice", topic = wanted, number, joint),
        })
    }

    /// Adds the row of a message.
    fn add(&mut self, kind: Kind, data: &[u8]) -> Result<(), Wrong> {
        let mut from = CdrReader::new(data).ok_or(Wrong::Cut)?;
        let row = self.row(kind, &mut from)?;
        self.rows.push(row);
        Ok(())
    }

    fn row(&mut self, kind: Kind, from: &mut CdrReader) -> Result<Vec<(usize, String)>, Wrong> {
        let (seconds, nanoseconds) = (from.i32().ok_or(Wrong::Cut)?, from.u32().ok_or(Wrong::Cut)?);
        let frame = from.string().ok_or(Wrong::Cut)?;
        let mut row = vec![
            (self.column(STAMP), decimal_seconds(seconds, nanoseconds)),
            (self.column("header.frame_id"), one_cell(&frame)),
        ];
        for name in kind.fields() {
            let value = from.f64().ok_or(Wrong::Cut)?;
            row.push((self.column(name), value.to_string()));
        }
        if kind != Kind::JointState {
            return Ok(row);
        }
        let names = from.list(CdrReader::string).ok_or(Wrong::Cut)?;
        let mut known = BTreeSet::new();
        if let Some(twice) = names.iter().find(|name| !known.insert(name.as_str())) {
            return Err(Wrong::Twice(twice.clone()));
        }
        for quantity in ["position", "velocity", "effort"] {
            let values = from.list(CdrReader::f64).ok_or(Wrong::Cut)?;
            // JointState.msg: an array is as long as the names, or empty
            if quantity == "position" && !values.is_empty() && values.len() != names.len() {
                return Err(Wrong::Lengths { names: names.len(), positions: values.len() });
            }
            self.joints_without_positions |= quantity == "position" && values.is_empty();
            for (name, value) in names.iter().zip(values) {
                row.push((self.column(&format!("{quantity}.{}", one_cell(name))), value.to_string()));
            }
        }
        Ok(row)
    }

    /// Returns the index of a column, which is new if no message before had it.
    fn column(&mut self, name: &str) -> usize {
        if let Some(at) = self.index.get(name) {
            return *at;
        }
        self.index.insert(name.to_owned(), self.columns.len());
        self.columns.push(name.to_owned());
        self.columns.len() - 1
    }

    fn text(&self, topic: &str) -> Result<String, Message> {
        if self.joints_without_positions && !self.columns.iter().any(|name| name.starts_with(POSITION)) {
            return Err(error!("topic-without-positions", topic, count = self.rows.len()));
        }
        // messages that name other joints each make a table of blanks
        if self.rows.len().saturating_mul(self.columns.len()) > MOST_CELLS {
            return Err(too_large(topic));
        }
        let mut text = self.columns.join("\t");
        text.push('\n');
        let mut cells = vec![""; self.columns.len()];
        for row in &self.rows {
            cells.fill("");
            row.iter().for_each(|(at, cell)| cells[*at] = cell);
            text.push_str(&cells.join("\t"));
            text.push('\n');
        }
        Ok(text)
    }
}

fn too_large(topic: &str) -> Message {
    error!("topic-too-large", topic, most_mib = LARGEST_TOPIC >> 20)
}

/// Returns whole seconds and nanoseconds as a decimal number.
fn decimal_seconds(seconds: i32, nanoseconds: u32) -> String {
    let all = i64::from(seconds) * 1_000_000_000 + i64::from(nanoseconds);
    let mut text = String::from(if all < 0 { "-" } else { "" });
    let _ = write!(text, "{}.{:09}", all.unsigned_abs() / 1_000_000_000, all.unsigned_abs() % 1_000_000_000);
    text
}

/// Returns a name as one cell: control characters become blanks.
fn one_cell(name: &str) -> String {
    name.replace(char::is_control, " ")
}

/// Calls `each` with the topic and the data of each message of a database, in the order of the
/// file.
///
/// Tables of rosbag2: `topics` (id, name, type, serialization_format, ..), `messages` (id,
/// topic_id, timestamp, data).
fn each_row(bytes: &[u8], each: &mut EachMessage) -> Result<(), Message> {
    let database = Database::new(bytes)?;
    let foreign = || error!("database-unreadable", fault = "tables");
    let (Some(topics), Some(messages)) = (database.table("topics")?, database.table("messages")?) else {
        return Err(foreign());
    };
    let mut known: BTreeMap<i64, Topic> = BTreeMap::new();
    database.each_row(topics, &mut |(id, values)| {
        let text = |at: usize| values.get(at).and_then(Value::text);
        let (Some(name), Some(message), Some(encoding)) = (text(1), text(2), text(3)) else { return Err(foreign()) };
        let [name, message, encoding] = [name, message, encoding].map(str::to_owned);
        known.insert(id, Topic { name, message, encoding });
        Ok(())
    })?;
    database.each_row(messages, &mut |(_, values)| {
        let topic = values.get(1).and_then(Value::whole).and_then(|id| known.get(&id));
        match (topic, values.get(3)) {
            (Some(topic), Some(Value::Bytes(data))) => each(topic, data),
            _ => Err(foreign()),
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_base::phrase;

    /// A message in CDR: values are put at multiples of their size behind the encapsulation.
    struct Written {
        data: Vec<u8>,
        big: bool,
    }

    impl Written {
        fn put(&mut self, bytes: &[u8]) -> &mut Self {
            while !(self.data.len() - 4).is_multiple_of(bytes.len()) {
                self.data.push(0);
            }
            match self.big {
                true => self.data.extend(bytes.iter().rev()),
                false => self.data.extend(bytes),
            }
            self
        }

        fn text(&mut self, text: &str) -> &mut Self {
            self.put(&(text.len() as u32 + 1).to_le_bytes());
            self.data.extend(text.bytes().chain([0]));
            self
        }

        fn list(&mut self, values: &[f64]) -> &mut Self {
            self.put(&(values.len() as u32).to_le_bytes());
            for value in values {
                self.put(&value.to_le_bytes());
            }
            self
        }

        fn header(big: bool, seconds: i32, nanoseconds: u32) -> Self {
            let mut new = Self { data: vec![0, u8::from(!big), 0, 0], big };
            new.put(&seconds.to_le_bytes()).put(&nanoseconds.to_le_bytes()).text("base");
            new
        }
    }

    fn joints(mut message: Written, names: &[&str], position: &[f64], velocity: &[f64]) -> Vec<u8> {
        message.put(&(names.len() as u32).to_le_bytes());
        for name in names {
            message.text(name);
        }
        message.list(position).list(velocity).list(&[]);
        message.data
    }

    fn pose(values: [f64; 7]) -> Vec<u8> {
        let mut message = Written::header(false, 12, 5_000_000);
        for value in values {
            message.put(&value.to_le_bytes());
        }
        message.data
    }

    const JOINTS: &str = "sensor_msgs/msg/JointState";

    fn record(kind: u8, body: &[u8]) -> Vec<u8> {
        [&[kind][..], &(body.len() as u64).to_le_bytes(), body].concat()
    }

    fn named(text: &str) -> Vec<u8> {
        [&(text.len() as u32).to_le_bytes(), text.as_bytes()].concat()
    }

    /// Topic, type, encoding and data of each message, in a recording by the specification of
    /// MCAP.
    fn archive(compression: &str, messages: &[(&str, &str, &str, Vec<u8>)]) -> Vec<u8> {
        let mut inside = Vec::new();
        for (i, (topic, message, encoding, data)) in (1_u16..).zip(messages) {
            let id = i.to_le_bytes();
            inside.extend(record(3, &[&id[..], &named(message), &named("ros2msg"), &named("")].concat()));
            inside.extend(record(4, &[&id[..], &id, &named(topic), &named(encoding), &[0; 4]].concat()));
            inside.extend(record(5, &[&id[..], &[0; 20], data].concat()));
        }
        let packed = match compression {
            "" => inside.clone(),
            "zstd" => zstd::encode_all(&*inside, 3).unwrap(),
            _ => {
                let mut encoder = lz4::EncoderBuilder::new().build(Vec::new()).unwrap();
                std::io::Write::write_all(&mut encoder, &inside).unwrap();
                encoder.finish().0
            }
        };
        let [size, length] = [inside.len(), packed.len()].map(|n| (n as u64).to_le_bytes());
        let checksum = crc32fast::hash(&inside).to_le_bytes();
        let chunk = [&[0; 16][..], &size, &checksum, &named(compression), &length, &packed].concat();
        let head = record(1, &[named("ros2"), named("test")].concat());
        [mcap::MAGIC, &head, &record(6, &chunk), &record(15, &[0; 4]), &record(2, &[0; 20]), mcap::MAGIC].concat()
    }

    fn sample(compression: &str) -> Vec<u8> {
        let header = Written::header;
        archive(
            compression,
            &[
                (
                    "/js",
                    JOINTS,
                    "cdr",
                    joints(header(false, 1_700_000_000, 5), &["a", "bee"], &[0.5, -0.25], &[1.0, 2.0]),
                ),
                ("/tf", "tf2_msgs/msg/TFMessage", "cdr", vec![0, 1, 0, 0]),
                ("/js", JOINTS, "cdr", joints(header(true, 1_700_000_001, 0), &["bee", "a"], &[0.1, 3.0], &[])),
                ("/js", JOINTS, "cdr", joints(header(false, 1_700_000_001, 7), &["gripper"], &[0.04], &[])),
                ("/p", "geometry_msgs/msg/PoseStamped", "cdr", pose([1.0, 2.0, 3.0, 0.0, 0.6, 0.0, 0.8])),
            ],
        )
    }

    #[test]
    fn joints_are_found_by_name_in_any_order_byte_order_and_compression() {
        let expected = "header.stamp\theader.frame_id\tposition.a\tposition.bee\tvelocity.a\tvelocity.bee\tposition.gripper\n\
                        1700000000.000000005\tbase\t0.5\t-0.25\t1\t2\t\n\
                        1700000001.000000000\tbase\t3\t0.1\t\t\t\n\
                        1700000001.000000007\tbase\t\t\t\t\t0.04\n";
        for compression in ["", "lz4", "zstd"] {
            let bytes = sample(compression);
            assert_eq!(text(&bytes, "/js").unwrap(), expected);
            let pose = text(&bytes, "/p").unwrap();
            assert!(pose.ends_with("12.005000000\tbase\t1\t2\t3\t0\t0.6\t0\t0.8\n"), "{pose}");
        }
        assert_eq!(decimal_seconds(-1, 500_000_000), "-0.500000000");
    }

    #[test]
    fn topics_and_messages_that_cannot_be_read_are_refused() {
        let error = |bytes: &[u8], topic| text(bytes, topic).unwrap_err();
        let bytes = sample("");
        let missing = error(&bytes, "/jss");
        let hint = phrase!("did-you-mean", name = "/js");
        assert!(missing.is("topic-missing", &[("topic", &"/jss"), ("hint", &hint)]), "{missing}");
        assert!(error(&bytes, "/tf").is("topic-type-unknown", &[("message", &"tf2_msgs/msg/TFMessage")]));
        let one = |encoding, data| archive("", &[("/js", JOINTS, encoding, data)]);
        let at = || Written::header(false, 1, 0);
        let empty = one("cdr", joints(at(), &["a", "b"], &[], &[1.0, 2.0]));
        assert!(error(&empty, "/js").is("topic-without-positions", &[("count", &1)]));
        let short = one("cdr", joints(at(), &["a", "b"], &[1.0], &[]));
        assert!(error(&short, "/js").is("joint-state-lengths-differ", &[("names", &2), ("positions", &1)]));
        let twice = one("cdr", joints(at(), &["a", "a"], &[1.0, 2.0], &[]));
        assert!(error(&twice, "/js").is("joint-state-name-twice", &[("joint", &"a")]));
        let ros1 = one("ros1", joints(at(), &["a"], &[1.0], &[]));
        assert!(error(&ros1, "/js").is("topic-encoding-unknown", &[("encoding", &"ros1")]));
        let mut cut = joints(at(), &["a"], &[1.0], &[]);
        cut.truncate(40);
        assert!(error(&one("cdr", cut), "/js").is("ros-message-malformed", &[("number", &1)]));
        let mut huge = joints(at(), &[], &[], &[]);
        huge.truncate(20);
        huge.extend([0xff; 4]);
        assert!(error(&one("cdr", huge), "/js").is("ros-message-malformed", &[]));
        assert!(error(&bytes[..bytes.len() / 3], "/js").is("recording-unreadable", &[]));
    }

    #[test]
    fn damaged_recordings_end_in_an_error_or_in_fewer_rows_never_in_a_panic() {
        for compression in ["", "lz4", "zstd"] {
            let bytes = sample(compression);
            for at in 0..bytes.len() {
                let mut damaged = bytes.clone();
                damaged[at] ^= 0xff;
                let _ = (text(&damaged, "/js"), topics(&damaged), text(&bytes[..at], "/js"));
            }
        }
    }
}
