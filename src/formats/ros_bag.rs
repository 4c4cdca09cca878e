//! Topics of a recording of ROS 2, MCAP or a database of rosbag2 (`.db3`), as rows of text: cells
//! separated by tabs, a row for each message, columns named after the fields of the message
//! definition.
//!
//! Sources: MCAP specification (records, chunks); OMG DDS-XTypes 1.3, 7.4 (CDR version 1: 4 bytes
//! of encapsulation, primitive types aligned to their size); `sensor_msgs/msg/JointState.msg`
//! (position in rad or m); REP 103 (m, s).

use crate::sqlite::{self, Database, Value};
use crate::unpack::Budget;
use etalon_base::error;
use etalon_base::message::Message;
use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::io::Read as _;

/// First bytes of an MCAP file.
pub(crate) const MAGIC: &[u8] = b"\x89MCAP0\r\n";
/// Maximum unpacked size of a chunk (bytes).
const LARGEST_CHUNK: usize = 256 << 20;
/// Maximum unpacked size of all chunks (bytes), which are unpacked one by one.
const LARGEST_CHUNKS: u64 = 8 << 30;
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
    bytes.starts_with(MAGIC) || is_database(bytes)
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

    /// Returns the kind of a message type, in the spelling of ROS 2 or ROS 1.
    fn named(name: &str) -> Option<Self> {
        let short = name.replacen("/msg/", "/", 1);
        Self::ALL.into_iter().find(|(known, _)| *known == short).map(|(_, kind)| kind)
    }

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

/// Topic of a recording.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Topic {
    pub name: String,
    /// Message type, such as `sensor_msgs/msg/JointState`.
    pub message: String,
    /// Encoding of the messages, such as `cdr`.
    pub encoding: String,
    pub kind: Option<Kind>,
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
            names.insert(topic.name.clone(), topic.kind.is_some());
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
        let Some(kind) = topic.kind else {
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
        let mut from = Cdr::new(data).ok_or(Wrong::Cut)?;
        let row = self.row(kind, &mut from)?;
        self.rows.push(row);
        Ok(())
    }

    fn row(&mut self, kind: Kind, from: &mut Cdr) -> Result<Vec<(usize, String)>, Wrong> {
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
        let names = from.list(Cdr::string).ok_or(Wrong::Cut)?;
        let mut known = BTreeSet::new();
        if let Some(twice) = names.iter().find(|name| !known.insert(name.as_str())) {
            return Err(Wrong::Twice(twice.clone()));
        }
        for quantity in ["position", "velocity", "effort"] {
            let values = from.list(Cdr::f64).ok_or(Wrong::Cut)?;
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

/// Receiver of the topic and the data of each message.
type EachMessage<'a> = dyn FnMut(&Topic, &[u8]) -> Result<(), Message> + 'a;

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
        let kind = Kind::named(message);
        let topic = Topic { name: name.to_owned(), message: message.to_owned(), encoding: encoding.to_owned(), kind };
        known.insert(id, topic);
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

/// Calls `each` with the topic and the data of each message, in the order of the file.
fn each_message(bytes: &[u8], mut each: impl FnMut(&Topic, &[u8]) -> Result<(), Message>) -> Result<(), Message> {
    if is_database(bytes) {
        return each_row(bytes, &mut each);
    }
    check_chunks(bytes)?;
    let mut known = Known::default();
    let mut left = bytes.strip_prefix(MAGIC).ok_or_else(|| unreadable("end"))?;
    loop {
        let (kind, body) = record(&mut left).ok_or_else(|| unreadable("end"))?;
        match kind {
            // the summary behind the data repeats channels
            DATA_END => return Ok(()),
            CHUNK => {
                let unpacked = unpacked(body)?;
                let mut inside = &*unpacked;
                while !inside.is_empty() {
                    let (kind, body) = record(&mut inside).ok_or_else(|| unreadable("end"))?;
                    known.take(kind, body, &mut each)?;
                }
            }
            _ => known.take(kind, body, &mut each)?,
        }
    }
}

/// Checks the sizes that the chunks declare before the first is unpacked.
fn check_chunks(bytes: &[u8]) -> Result<(), Message> {
    let budget = Budget::new("recording", bytes.len(), LARGEST_CHUNKS);
    let mut left = bytes.strip_prefix(MAGIC).unwrap_or_default();
    let mut declared = 0_u64;
    // a record that ends early is reported when it is read
    while let Some((kind, mut body)) = record(&mut left).filter(|(kind, _)| *kind != DATA_END) {
        if kind == CHUNK
            && let Some((size, ..)) = chunk_head(&mut body)
        {
            declared = declared.saturating_add(size as u64);
            budget.check(declared)?;
        }
    }
    Ok(())
}

/// Kinds of records.
const SCHEMA: u8 = 0x03;
const CHANNEL: u8 = 0x04;
const MESSAGE: u8 = 0x05;
const CHUNK: u8 = 0x06;
const DATA_END: u8 = 0x0f;

fn unreadable(fault: &str) -> Message {
    error!("recording-unreadable", fault)
}

/// Takes a record off the bytes: its kind, and its content behind the length.
fn record<'a>(left: &mut &'a [u8]) -> Option<(u8, &'a [u8])> {
    let kind = *left.first()?;
    let mut behind = &left[1..];
    let length = usize::try_from(u64::from_le_bytes(*taken(&mut behind)?)).ok()?;
    let (body, rest) = behind.split_at_checked(length)?;
    *left = rest;
    Some((kind, body))
}

/// Takes a number of bytes off the bytes.
fn taken<'a, const N: usize>(left: &mut &'a [u8]) -> Option<&'a [u8; N]> {
    let (first, rest) = left.split_first_chunk()?;
    *left = rest;
    Some(first)
}

/// Takes a text with its length off the bytes.
fn named(left: &mut &[u8]) -> Option<String> {
    let length = u32::from_le_bytes(*taken(left)?) as usize;
    let (text, rest) = left.split_at_checked(length)?;
    *left = rest;
    String::from_utf8(text.to_vec()).ok()
}

/// Takes unpacked size, checksum, compression and packed records of a chunk off the bytes.
fn chunk_head<'a>(left: &mut &'a [u8]) -> Option<(usize, u32, String, &'a [u8])> {
    let (_from, _to) = (taken::<8>(left)?, taken::<8>(left)?);
    let size = usize::try_from(u64::from_le_bytes(*taken(left)?)).ok()?;
    let checksum = u32::from_le_bytes(*taken(left)?);
    let compression = named(left)?;
    let length = usize::try_from(u64::from_le_bytes(*taken(left)?)).ok()?;
    let data: &'a [u8] = left;
    Some((size, checksum, compression, data.get(..length)?))
}

/// Returns the records of a chunk, after a check of their size and checksum.
fn unpacked(body: &[u8]) -> Result<Cow<'_, [u8]>, Message> {
    let mut left = body;
    let (size, checksum, compression, packed) = chunk_head(&mut left).ok_or_else(|| unreadable("end"))?;
    if size > LARGEST_CHUNK {
        return Err(unreadable("size"));
    }
    let most = size as u64 + 1;
    let mut out = Vec::new();
    let records = match compression.as_str() {
        "" => Cow::Borrowed(packed),
        "lz4" => {
            let decoder = lz4::Decoder::new(packed).map_err(|_| unreadable("unpack"))?;
            decoder.take(most).read_to_end(&mut out).map_err(|_| unreadable("unpack"))?;
            Cow::Owned(out)
        }
        "zstd" => {
            let decoder = zstd::Decoder::new(packed).map_err(|_| unreadable("unpack"))?;
            decoder.take(most).read_to_end(&mut out).map_err(|_| unreadable("unpack"))?;
            Cow::Owned(out)
        }
        _ => return Err(unreadable("compression")),
    };
    // a checksum of 0 means that there is no checksum
    if records.len() != size || checksum != 0 && crc32fast::hash(&records) != checksum {
        return Err(unreadable("checksum"));
    }
    Ok(records)
}

/// Schemas and channels of a recording.
#[derive(Default)]
struct Known {
    /// Message type of each schema.
    schemas: BTreeMap<u16, String>,
    channels: BTreeMap<u16, Topic>,
}

impl Known {
    /// Takes a schema or channel in, and calls `each` with a message.
    fn take(
        &mut self,
        kind: u8,
        mut body: &[u8],
        each: &mut impl FnMut(&Topic, &[u8]) -> Result<(), Message>,
    ) -> Result<(), Message> {
        let cut = || unreadable("end");
        if !matches!(kind, SCHEMA | CHANNEL | MESSAGE) {
            return Ok(());
        }
        let left = &mut body;
        let id = u16::from_le_bytes(*taken(left).ok_or_else(cut)?);
        match kind {
            SCHEMA => {
                self.schemas.insert(id, named(left).ok_or_else(cut)?);
            }
            CHANNEL => {
                let schema = u16::from_le_bytes(*taken(left).ok_or_else(cut)?);
                let name = named(left).ok_or_else(cut)?;
                let encoding = named(left).ok_or_else(cut)?;
                let message = self.schemas.get(&schema).cloned().unwrap_or_default();
                let kind = Kind::named(&message);
                self.channels.insert(id, Topic { name, message, encoding, kind });
            }
            _ => {
                let (_sequence, _logged, _published) = (taken::<4>(left), taken::<8>(left), taken::<8>(left));
                let topic = self.channels.get(&id).ok_or_else(|| unreadable("channel"))?;
                each(topic, left)?;
            }
        }
        Ok(())
    }
}

/// Reader of a message in CDR version 1.
struct Cdr<'a> {
    /// Data behind the encapsulation: alignment counts from here.
    data: &'a [u8],
    at: usize,
    is_big_endian: bool,
}

impl<'a> Cdr<'a> {
    /// Returns a reader behind the encapsulation: 0 is big endian, 1 little endian.
    fn new(message: &'a [u8]) -> Option<Self> {
        let (start, data) = message.split_at_checked(4)?;
        let is_big_endian = match start[..2] {
            [0, 0] => true,
            [0, 1] => false,
            _ => return None,
        };
        Some(Self { data, at: 0, is_big_endian })
    }

    fn bytes<const N: usize>(&mut self) -> Option<[u8; N]> {
        let start = self.at.next_multiple_of(N);
        let mut bytes: [u8; N] = self.data.get(start..start + N)?.try_into().ok()?;
        self.at = start + N;
        if self.is_big_endian {
            bytes.reverse();
        }
        Some(bytes)
    }

    fn i32(&mut self) -> Option<i32> {
        self.bytes().map(i32::from_le_bytes)
    }

    fn u32(&mut self) -> Option<u32> {
        self.bytes().map(u32::from_le_bytes)
    }

    fn f64(&mut self) -> Option<f64> {
        self.bytes().map(f64::from_le_bytes)
    }

    /// Returns a text, whose length counts its closing zero.
    fn string(&mut self) -> Option<String> {
        let length = self.u32()? as usize;
        let bytes = self.data.get(self.at..self.at.checked_add(length)?)?;
        self.at += length;
        let bytes = bytes.strip_suffix(b"\0").unwrap_or(bytes);
        String::from_utf8(bytes.to_vec()).ok()
    }

    /// Returns a sequence; a count that the data cannot hold is no count.
    fn list<T>(&mut self, each: fn(&mut Self) -> Option<T>) -> Option<Vec<T>> {
        let count = self.u32()? as usize;
        if count > self.data.len() {
            return None;
        }
        (0..count).map(|_| each(self)).collect()
    }
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

    fn joints(big: bool, stamp: (i32, u32), names: &[&str], position: &[f64], velocity: &[f64]) -> Vec<u8> {
        let mut message = Written::header(big, stamp.0, stamp.1);
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
        [MAGIC, &head, &record(6, &chunk), &record(15, &[0; 4]), &record(2, &[0; 20]), MAGIC].concat()
    }

    fn sample(compression: &str) -> Vec<u8> {
        archive(
            compression,
            &[
                ("/js", JOINTS, "cdr", joints(false, (1_700_000_000, 5), &["a", "bee"], &[0.5, -0.25], &[1.0, 2.0])),
                ("/tf", "tf2_msgs/msg/TFMessage", "cdr", vec![0, 1, 0, 0]),
                ("/js", JOINTS, "cdr", joints(true, (1_700_000_001, 0), &["bee", "a"], &[0.1, 3.0], &[])),
                ("/js", JOINTS, "cdr", joints(false, (1_700_000_001, 7), &["gripper"], &[0.04], &[])),
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
        let at = (1, 0);
        let empty = one("cdr", joints(false, at, &["a", "b"], &[], &[1.0, 2.0]));
        assert!(error(&empty, "/js").is("topic-without-positions", &[("count", &1)]));
        let short = one("cdr", joints(false, at, &["a", "b"], &[1.0], &[]));
        assert!(error(&short, "/js").is("joint-state-lengths-differ", &[("names", &2), ("positions", &1)]));
        let twice = one("cdr", joints(false, at, &["a", "a"], &[1.0, 2.0], &[]));
        assert!(error(&twice, "/js").is("joint-state-name-twice", &[("joint", &"a")]));
        let ros1 = one("ros1", joints(false, at, &["a"], &[1.0], &[]));
        assert!(error(&ros1, "/js").is("topic-encoding-unknown", &[("encoding", &"ros1")]));
        let mut cut = joints(false, at, &["a"], &[1.0], &[]);
        cut.truncate(40);
        assert!(error(&one("cdr", cut), "/js").is("ros-message-malformed", &[("number", &1)]));
        let mut huge = joints(false, at, &[], &[], &[]);
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
