//! Head of a PLY file: its encoding, its elements and their properties.

use crate::base::message::{Message, Place};

/// Lines of a head; real ones have some twenty.
const MOST_LINES: usize = 2000;

/// How numbers are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Encoding {
    Ascii,
    LittleEndian,
    BigEndian,
}

/// A type of number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Kind {
    fn named(name: &str) -> Option<Self> {
        Some(match name {
            "char" | "int8" => Self::I8,
            "uchar" | "uint8" => Self::U8,
            "short" | "int16" => Self::I16,
            "ushort" | "uint16" => Self::U16,
            "int" | "int32" => Self::I32,
            "uint" | "uint32" => Self::U32,
            "float" | "float32" => Self::F32,
            "double" | "float64" => Self::F64,
            _ => return None,
        })
    }

    /// Bytes of a number.
    pub fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }

    /// The number in these bytes, which must be as many as its size.
    pub fn value(self, bytes: &[u8], encoding: Encoding) -> Option<f64> {
        macro_rules! read {
            ($kind:ty) => {{
                let bytes = bytes.try_into().ok()?;
                let big = encoding == Encoding::BigEndian;
                f64::from(if big { <$kind>::from_be_bytes(bytes) } else { <$kind>::from_le_bytes(bytes) })
            }};
        }
        Some(match self {
            Self::I8 => read!(i8),
            Self::U8 => read!(u8),
            Self::I16 => read!(i16),
            Self::U16 => read!(u16),
            Self::I32 => read!(i32),
            Self::U32 => read!(u32),
            Self::F32 => read!(f32),
            Self::F64 => read!(f64),
        })
    }
}

/// What an element has: a number, or a list (type of its length, type of its numbers).
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Property {
    Number(String, Kind),
    List(Kind, Kind),
}

/// So many of a kind.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Element {
    pub name: String,
    pub count: u64,
    pub properties: Vec<Property>,
    /// The line that states it.
    pub line: usize,
}

/// The head.
#[derive(Debug)]
pub(super) struct Header {
    pub encoding: Encoding,
    pub elements: Vec<Element>,
    /// Bytes of the head.
    pub bytes: usize,
    /// Lines of the head.
    pub lines: usize,
}

/// Reads the head of a file.
pub(super) fn read(file: &str, bytes: &[u8]) -> Result<Header, Message> {
    let (mut at, mut encoding, mut elements) = (0, None, Vec::<Element>::new());
    for line in 1..=MOST_LINES {
        let rest = bytes.get(at..).unwrap_or_default();
        let Some(end) = rest.iter().take(4096).position(|b| *b == b'\n') else { break };
        let text = String::from_utf8_lossy(&rest[..end]).trim().to_owned();
        at += end + 1;
        let wrong = |what: String| Message::error(what).at(Place::line(file, line, text.as_str()));
        let words: Vec<&str> = text.split_whitespace().collect();
        match (line, &words[..]) {
            (1, ["ply"]) => {}
            (1, _) => return Err(wrong("this is no PLY file".to_owned()).expected("a first line `ply`")),
            (_, [] | ["comment" | "obj_info", ..]) => {}
            (_, ["format", name, "1.0"]) => {
                encoding = match *name {
                    "ascii" => Some(Encoding::Ascii),
                    "binary_little_endian" => Some(Encoding::LittleEndian),
                    "binary_big_endian" => Some(Encoding::BigEndian),
                    _ => return Err(wrong(format!("`{name}` is no encoding of PLY"))),
                };
            }
            (_, ["element", name, count]) => {
                let count = count.parse().map_err(|_| wrong(format!("`{count}` is no number of elements")))?;
                elements.push(Element { name: (*name).to_owned(), count, properties: Vec::new(), line });
            }
            (_, ["property", stated @ ..]) => {
                let kind =
                    |name: &str| Kind::named(name).ok_or_else(|| wrong(format!("`{name}` is no type of number")));
                let property = match stated {
                    ["list", length, item, _] => Property::List(kind(length)?, kind(item)?),
                    [item, name] => Property::Number((*name).to_owned(), kind(item)?),
                    _ => return Err(wrong("the property has neither a type and a name nor a list of them".to_owned())),
                };
                let Some(element) = elements.last_mut() else {
                    return Err(wrong("a property before any element".to_owned()));
                };
                element.properties.push(property);
            }
            (_, ["end_header"]) => {
                let encoding = encoding.ok_or_else(|| wrong("the head states no format".to_owned()))?;
                return Ok(Header { encoding, elements, bytes: at, lines: line });
            }
            _ => return Err(wrong("the line means nothing in the head of a PLY file".to_owned())),
        }
    }
    let message = Message::error("the head of the PLY file has no end").at(Place::file(file));
    Err(message.expected("a line `end_header`").hint("was the file cut off?"))
}
