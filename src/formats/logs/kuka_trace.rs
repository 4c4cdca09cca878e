//! Traces of KUKA: a data set of DIAdem. Its header (`.dat`) lists the channels; its numbers are in
//! a second file (`.r64`) of the same folder.
//!
//! A header is a list of `code,value`: 112 order of bytes; of a channel 200 name, 202 unit, 210
//! `IMPLICIT` or `EXPLICIT` (controllers write `IMPLIZIT` and `EXPLIZIT`), 211 file, 213 `BLOCK`
//! (interleaved) or `CHANNEL`, 214 type, 220 count, 221 place of the first value from 1, 240 offset
//! and 241 factor. Source: National Instruments, "DIAdem header file" (codes 1 to 302).
//!
//! `..._KRCIpo.dat` has the axes of the robot in degrees: `AxisPos_Act1` (measured) and
//! `AxisPos_CmdIpo1` (commanded). `..._NextGenDrive#1.dat` has the motor of one axis.

use super::arrays::{self, Array, ArrayFile, ArrayParts, LARGEST, Numbers, Spelling};
use super::{About, LogFormat, Wanted};
use crate::magic;
use etalon_base::error;
use etalon_base::message::Message;
use etalon_tables::ColumnSource;
use std::collections::BTreeMap;

/// Traces of KUKA.
pub(super) struct KukaTrace;

/// Channels have no parts: their text is their name.
const SPELLING: Spelling = Spelling { open: '\0', close: '\0', first: 0 };

/// Beginning of the names of the measured axes.
const MEASURED: &str = "AxisPos_Act";

impl LogFormat for KukaTrace {
    fn about(&self) -> About {
        About {
            name: "kuka_trace",
            title: "KUKA.Trace",
            description: "KUKA trace: the header (.dat) of a data set of DIAdem, with its numbers in a second file (.r64).",
        }
    }

    fn column_unit(&self, column: &str) -> Option<&'static str> {
        match column {
            "Zeit" => Some("s"),
            _ if column.starts_with("AxisPos_") => Some("deg"),
            _ => None,
        }
    }

    fn statement(&self, wanted: &Wanted) -> Option<Message> {
        let ColumnSource::Heading(name) = &wanted.column.at else { return None };
        (wanted.is_joint() && is_of_motor(name)).then(|| error!("trace-of-motor"))
    }

    fn holds(&self, bytes: &[u8]) -> bool {
        magic::arrays(bytes) == Some("kuka_trace")
    }

    fn has_arrays(&self) -> bool {
        true
    }

    fn files_beside(&self, bytes: &[u8]) -> Vec<String> {
        let mut names: Vec<String> = Header::parse(bytes).channels.into_iter().map(|channel| channel.file).collect();
        names.retain(|name| !name.is_empty());
        names.sort();
        names.dedup();
        names
    }

    fn arrays(&self, file: &ArrayFile) -> Result<Vec<ArrayParts>, Message> {
        let arrays = arrays(file)?;
        if arrays.iter().any(|array| is_of_motor(&array.name)) {
            return Err(error!("trace-of-motor"));
        }
        Ok(grouped(&arrays))
    }

    fn table(&self, file: &ArrayFile, wanted: &[&str]) -> Option<Result<String, Message>> {
        Some(arrays(file).and_then(|arrays| {
            let is_named = |name: &str| arrays.iter().filter(|array| array.name == name).count();
            match wanted.iter().find(|name| is_named(name) > 1) {
                Some(column) => Err(error!("heading-twice", column = *column)),
                None => arrays::table(&arrays, wanted, SPELLING),
            }
        }))
    }
}

/// `true` for the position of a motor, before the gear: its values are no joint values.
fn is_of_motor(channel: &str) -> bool {
    ["Istposition", "Sollposition"].contains(&channel)
}

/// Groups numbered channels (`AxisPos_Act1` to `6`) as the parts of one array; measured axes last.
fn grouped(arrays: &[Array]) -> Vec<ArrayParts> {
    let stem = |name: &str| name.trim_end_matches(|c: char| c.is_ascii_digit()).to_owned();
    let mut groups: Vec<ArrayParts> = Vec::new();
    for array in arrays {
        let (name, count) = (stem(&array.name), array.shape[0]);
        let is_numbered = name != array.name;
        match groups.iter_mut().find(|group| is_numbered && group.name == name && group.count == count) {
            Some(group) => group.parts.push(array.name.clone()),
            None => {
                let name = if is_numbered { name } else { array.name.clone() };
                groups.push(ArrayParts { name, count, parts: vec![array.name.clone()] });
            }
        }
    }
    groups.sort_by_key(|group| group.name == MEASURED);
    groups
}

/// Reads a number from its bytes in ascending order.
type Read = fn(&[u8]) -> f64;

/// Channel of a header.
#[derive(Debug, Default)]
struct Channel {
    name: String,
    /// `true` if its values are computed from offset and factor.
    is_implicit: bool,
    /// Name of the file with its values.
    file: String,
    /// `true` if values of several channels alternate.
    is_interleaved: bool,
    kind: String,
    count: usize,
    /// Place of the first value among the values of its type, from 1.
    first: usize,
    offset: f64,
    factor: f64,
}

/// Header of a data set.
#[derive(Debug, Default)]
struct Header {
    is_big_endian: bool,
    channels: Vec<Channel>,
}

impl Header {
    /// Reads a header; lines without a known code are left out.
    fn parse(bytes: &[u8]) -> Self {
        // letters beyond ASCII occur in units and comments alone
        let text = String::from_utf8_lossy(bytes);
        let mut header = Self::default();
        let mut open: Option<BTreeMap<&str, &str>> = None;
        for line in text.lines().map(str::trim) {
            match (line, &mut open) {
                ("#BEGINCHANNELHEADER", _) => open = Some(BTreeMap::new()),
                ("#ENDCHANNELHEADER", _) => header.channels.extend(open.take().map(|codes| Channel::new(&codes))),
                (_, Some(codes)) => codes.extend(line.split_once(',')),
                (_, None) => {
                    header.is_big_endian |= line.split_once(',').is_some_and(|(code, value)| {
                        code == "112" && value.trim_start().to_ascii_lowercase().starts_with("high")
                    });
                }
            }
        }
        header
    }
}

impl Channel {
    fn new(codes: &BTreeMap<&str, &str>) -> Self {
        let text = |code: &str| codes.get(code).map_or("", |value| value.trim());
        let whole = |code: &str| text(code).parse::<usize>().unwrap_or(0);
        let number = |code: &str, absent: f64| match text(code) {
            "" => absent,
            stated => stated.parse().unwrap_or(f64::NAN),
        };
        Self {
            name: text("200").to_owned(),
            is_implicit: text("210").starts_with("IMPLI"),
            // a path names a folder of the controller
            file: text("211").rsplit(['/', '\\']).next().unwrap_or_default().to_owned(),
            is_interleaved: text("213") == "BLOCK",
            kind: text("214").to_owned(),
            count: whole("220"),
            first: whole("221"),
            offset: number("240", 0.0),
            factor: number("241", 1.0),
        }
    }

    /// Returns the size (bytes) of a number, and the number of its bytes in ascending order.
    fn number(&self) -> Option<(usize, Read)> {
        fn read<const N: usize>(bytes: &[u8]) -> [u8; N] {
            bytes.try_into().unwrap_or([0; N])
        }
        Some(match self.kind.as_str() {
            "REAL64" => (8, |b| f64::from_le_bytes(read(b))),
            "REAL32" => (4, |b| f64::from(f32::from_le_bytes(read(b)))),
            "INT32" => (4, |b| f64::from(i32::from_le_bytes(read(b)))),
            "INT16" => (2, |b| f64::from(i16::from_le_bytes(read(b)))),
            "WORD32" => (4, |b| f64::from(u32::from_le_bytes(read(b)))),
            "WORD16" => (2, |b| f64::from(u16::from_le_bytes(read(b)))),
            _ => return None,
        })
    }

    /// Returns the values of the channel, of which `step` alternate in its file.
    fn values(&self, data: &[u8], step: usize, is_big_endian: bool) -> Result<Vec<f64>, Message> {
        let stored = || error!("trace-storage-unknown", channel = &self.name, storage = &self.kind);
        let (size, number) = self.number().ok_or_else(stored)?;
        let missing = || error!("trace-values-missing", channel = &self.name, count = self.count);
        let first = self.first.checked_sub(1).ok_or_else(missing)?;
        let last = self.count.checked_sub(1).and_then(|last| last.checked_mul(step)?.checked_add(first + 1));
        if last.and_then(|last| last.checked_mul(size)).is_none_or(|end| end > data.len()) {
            return Err(missing());
        }
        let value = |bytes: &[u8]| match is_big_endian {
            true => number(&bytes.iter().rev().copied().collect::<Vec<u8>>()),
            false => number(bytes),
        };
        let stored = data.chunks_exact(size).skip(first).step_by(step).take(self.count);
        Ok(stored.map(|bytes| self.offset + self.factor * value(bytes)).collect())
    }
}

/// Returns the channels of a data set.
fn arrays(file: &ArrayFile) -> Result<Vec<Array>, Message> {
    let header = Header::parse(file.bytes);
    let Some(longest) = header.channels.iter().map(|channel| channel.count).max() else {
        return Err(error!("arrays-unreadable", format = "kuka_trace"));
    };
    if (longest as u64).saturating_mul(8 * header.channels.len() as u64) > LARGEST {
        return Err(error!("unpacked-too-large", kind = "arrays", most_mib = LARGEST >> 20));
    }
    let mut all = Vec::new();
    for channel in &header.channels {
        let beside = |other: &&Channel| other.is_interleaved && other.file == channel.file;
        let step = if channel.is_interleaved { header.channels.iter().filter(beside).count() } else { 1 };
        let values = match channel.is_implicit {
            true => (0..channel.count).map(|i| channel.offset + i as f64 * channel.factor).collect(),
            false => channel.values(file.beside(&channel.file), step, header.is_big_endian)?,
        };
        let numbers = Numbers::Real(values);
        all.push(Array { name: channel.name.clone(), shape: vec![channel.count], numbers, by_columns: false });
    }
    Ok(all)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Header by the codes of DIAdem.
    fn header(channels: &[&str], storage: &str, order: &str) -> String {
        let mut text = format!("DIAEXTENDED  {{@:ENGLISH\n#BEGINGLOBALHEADER\n1,WINDOWS 32Bit\n112,{order}\n");
        text += "#ENDGLOBALHEADER\n\n#BEGINCHANNELHEADER\n200,Zeit\n202,s\n210,IMPLIZIT\n220,3\n240,0\n241,0.012\n\
                 #ENDCHANNELHEADER\n";
        for (name, place) in channels.iter().zip(1..) {
            text += &format!(
                "#BEGINCHANNELHEADER\n200,{name}\n202,deg\n210,EXPLIZIT\n211,C:\\TRACE\\t.r64\n213,BLOCK\n214,{storage}\n\
                 220,3\n221,{place}\n240,0.5\n241,2\n#ENDCHANNELHEADER\n"
            );
        }
        text
    }

    fn table(text: &str, data: Vec<u8>, wanted: &[&str]) -> Result<String, Message> {
        let file = ArrayFile { bytes: text.as_bytes(), beside: vec![("T.R64".to_owned(), data)] };
        KukaTrace.table(&file, wanted).unwrap()
    }

    const AXES: [&str; 4] = ["AxisPos_Act1", "AxisPos_Act2", "AxisPos_CmdIpo1", "AxisPos_CmdIpo2"];

    #[test]
    fn interleaved_channels_are_scaled_in_either_order_of_bytes() {
        let values = (1..=12).map(f64::from);
        let little: Vec<u8> = values.clone().flat_map(f64::to_le_bytes).collect();
        let big: Vec<u8> = values.flat_map(f64::to_be_bytes).collect();
        let text = header(&AXES, "REAL64", "Low -> High");
        assert!(KukaTrace.holds(text.as_bytes()) && KukaTrace.files_beside(text.as_bytes()) == ["t.r64"]);
        // values 2, 6, 10 of the file, each doubled, plus a half
        let right = "Zeit\tAxisPos_Act2\n0\t4.5\n0.012\t12.5\n0.024\t20.5\n";
        let wanted = ["Zeit", "AxisPos_Act2"];
        assert_eq!(table(&text, little, &wanted).unwrap(), right);
        assert_eq!(table(&header(&AXES, "REAL64", "High -> Low"), big, &wanted).unwrap(), right);
        let whole: Vec<u8> = (1..=12i16).flat_map(i16::to_le_bytes).collect();
        assert_eq!(table(&header(&AXES, "INT16", "Low -> High"), whole, &wanted).unwrap(), right);
    }

    #[test]
    fn measured_axes_are_the_last_group() {
        let text = header(&AXES, "REAL64", "Low -> High");
        let file = ArrayFile { bytes: text.as_bytes(), beside: vec![("t.r64".to_owned(), vec![0; 96])] };
        let groups = KukaTrace.arrays(&file).unwrap();
        let shown: Vec<(&str, usize)> = groups.iter().map(|of| (of.name.as_str(), of.parts.len())).collect();
        assert_eq!(shown, [("Zeit", 1), ("AxisPos_CmdIpo", 2), ("AxisPos_Act", 2)]);
        let motor = header(&["Istposition", "Istmoment"], "REAL64", "Low -> High");
        let file = ArrayFile { bytes: motor.as_bytes(), beside: vec![("t.r64".to_owned(), vec![0; 48])] };
        assert!(KukaTrace.arrays(&file).unwrap_err().is("trace-of-motor", &[]));
    }

    #[test]
    fn what_cannot_be_read_is_named() {
        let text = header(&AXES, "REAL64", "Low -> High");
        let short = table(&text, vec![0; 95], &["AxisPos_Act1"]).unwrap_err();
        assert!(short.is("trace-values-missing", &[("channel", &"AxisPos_CmdIpo2"), ("count", &3)]), "{short}");
        let ascii = table(&header(&AXES, "ASCII", "Low -> High"), vec![0; 96], &["AxisPos_Act1"]).unwrap_err();
        assert!(ascii.is("trace-storage-unknown", &[("channel", &"AxisPos_Act1"), ("storage", &"ASCII")]), "{ascii}");
        let twice = header(&["AxisPos_Act1", "AxisPos_Act1"], "REAL64", "Low -> High");
        let twice = table(&twice, vec![0; 48], &["AxisPos_Act1"]).unwrap_err();
        assert!(twice.is("heading-twice", &[("column", &"AxisPos_Act1")]), "{twice}");
        assert!(table("#BEGINCHANNELHEADER\n", Vec::new(), &["Zeit"]).unwrap_err().is("arrays-unreadable", &[]));
        let huge = text.replace("220,3", "220,9999999999999999");
        assert!(table(&huge, vec![0; 96], &["AxisPos_Act1"]).unwrap_err().is("unpacked-too-large", &[]));
        for at in 0..text.len() {
            let _ = table(&text[..at], vec![0; 96], &["AxisPos_Act1"]);
            let _ = table(&(text[..at].to_owned() + "9,1\n" + &text[at..]), vec![0; 96], &["Zeit"]);
        }
    }
}
