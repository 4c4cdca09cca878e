//! Recordings in MCAP: messages of topics, as their encoded bytes.
//!
//! Source: MCAP specification (records, chunks).

use crate::unpack::Budget;
use ::mcap::records::{MessageHeader, Metadata};
use ::mcap::{McapResult, WriteOptions};
use etalon_base::error;
use etalon_base::message::Message;
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::io::{Cursor, Read as _};

/// First bytes of an MCAP file.
pub(crate) const MAGIC: &[u8] = b"\x89MCAP0\r\n";
/// Maximum unpacked size of a chunk (bytes).
const LARGEST_CHUNK: usize = 256 << 20;
/// Maximum unpacked size of all chunks (bytes), which are unpacked one by one.
const LARGEST_CHUNKS: u64 = 8 << 30;

/// Topic of a recording.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Topic {
    pub name: String,
    /// Message type, such as `sensor_msgs/msg/JointState`.
    pub message: String,
    /// Encoding of the messages, such as `cdr`.
    pub encoding: String,
}

/// Receiver of the topic and the data of each message.
pub(crate) type EachMessage<'a> = dyn FnMut(&Topic, &[u8]) -> Result<(), Message> + 'a;

/// Calls `each` with the topic and the data of each message, in the order of the file.
pub(crate) fn each_message(bytes: &[u8], each: &mut EachMessage) -> Result<(), Message> {
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
                    known.take(kind, body, each)?;
                }
            }
            _ => known.take(kind, body, each)?,
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
    fn take(&mut self, kind: u8, mut body: &[u8], each: &mut EachMessage) -> Result<(), Message> {
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
                self.channels.insert(id, Topic { name, message, encoding });
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

/// Type of the messages of a topic.
pub struct MessageType {
    /// Name, such as `sensor_msgs/msg/JointState`.
    pub name: &'static str,
    /// Definition with the definitions of all types of its fields, as rosbag2 stores it.
    pub definition: String,
}

/// Writer of a recording of ROS 2 in memory, without compression.
pub struct RecordingWriter {
    writer: ::mcap::Writer<Cursor<Vec<u8>>>,
    /// Numbers of the channels by topic.
    channels: BTreeMap<String, u16>,
}

impl RecordingWriter {
    /// Begins a recording with texts about it.
    pub fn new(about: BTreeMap<String, String>) -> McapResult<Self> {
        let options = WriteOptions::new().compression(None).profile("ros2").library("etalon");
        let mut writer = options.create(Cursor::new(Vec::new()))?;
        writer.write_metadata(&Metadata { name: "etalon".to_owned(), metadata: about })?;
        Ok(Self { writer, channels: BTreeMap::new() })
    }

    /// Adds a message in CDR. The type is stored with the first message of a topic.
    pub fn write(&mut self, topic: &str, kind: impl Fn() -> MessageType, time_s: f64, data: &[u8]) -> McapResult<()> {
        let channel_id = match self.channels.get(topic) {
            Some(channel) => *channel,
            None => {
                let MessageType { name, definition } = kind();
                let schema = self.writer.add_schema(name, "ros2msg", definition.as_bytes())?;
                let channel = self.writer.add_channel(schema, topic, "cdr", &BTreeMap::new())?;
                self.channels.insert(topic.to_owned(), channel);
                channel
            }
        };
        let time = (time_s * 1e9).round() as u64;
        let header = MessageHeader { channel_id, sequence: 0, log_time: time, publish_time: time };
        self.writer.write_to_known_channel(&header, data)
    }

    /// Ends the recording and returns its bytes.
    pub fn finish(mut self) -> McapResult<Vec<u8>> {
        self.writer.finish()?;
        Ok(self.writer.into_inner().into_inner())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_base::noise::Noise;

    #[test]
    fn drawn_messages_read_back_byte_for_byte() {
        let mut noise = Noise::new(7, 1);
        let mut draw = |count: f64| (noise.uniform(count / 2.0) + count / 2.0) as usize;
        for _ in 0..50 {
            let mut writer = RecordingWriter::new(BTreeMap::new()).unwrap();
            let mut messages: Vec<(String, Vec<u8>)> = Vec::new();
            for i in 0..draw(40.0) {
                let (topic, size) = (format!("/topic_{}", draw(5.0)), draw(3000.0));
                let data: Vec<u8> = (0..size).map(|_| draw(256.0) as u8).collect();
                let kind = || MessageType { name: "std_msgs/msg/String", definition: "string data\n".to_owned() };
                writer.write(&topic, kind, i as f64, &data).unwrap();
                messages.push((topic, data));
            }
            let mut read = Vec::new();
            let mut each = |topic: &Topic, data: &[u8]| {
                assert_eq!([topic.message.as_str(), &topic.encoding], ["std_msgs/msg/String", "cdr"]);
                read.push((topic.name.clone(), data.to_vec()));
                Ok(())
            };
            each_message(&writer.finish().unwrap(), &mut each).unwrap();
            assert_eq!(read, messages);
        }
    }
}
