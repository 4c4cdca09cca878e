//! PLY, text or binary: its vertices are points without labels. The file does not contain their
//! unit.

use super::{About, ExportFormat, ExportRow, Recognised, Text, WriteError, Writing, not_this_format};
use crate::Point;
use crate::dialect::{Dialect, Unit};
use etalon_base::catalogue::IntoArgument;
use etalon_base::message::{Message, Place, Problems};
use etalon_base::pose::Vector;
use etalon_base::{error, phrase};
use etalon_tables::Decimal;
use etalon_tables::lexer::{Row as Fields, number};

/// Vertices of PLY.
pub(super) struct Ply;

impl ExportFormat for Ply {
    fn about(&self) -> About {
        About { name: "ply", title: "PLY", binary: true, ..About::default() }
    }

    fn recognise(&self, text: &str) -> Option<Recognised> {
        Recognised::by(text.starts_with("ply\n") || text.starts_with("ply\r"), 1.0, phrase!("is-ply"))
    }

    fn read(&self, text: &Text, _dialect: &Dialect, unit: Unit) -> (Vec<Point>, Problems) {
        rows(text, unit)
    }

    fn write(&self, rows: &[ExportRow], how: &Writing) -> Result<String, WriteError> {
        let count = rows.len();
        let properties = "property double x\nproperty double y\nproperty double z\n";
        let vertices: String = rows.iter().map(|row| how.list(row, " ") + "\n").collect();
        Ok(format!("ply\nformat ascii 1.0\nelement vertex {count}\n{properties}end_header\n{vertices}"))
    }
}

/// The vertices. The text of a binary file has one character for each byte.
fn rows(text: &Text, unit: Unit) -> (Vec<Point>, Problems) {
    let (mut points, mut problems) = (Vec::new(), Problems::default());
    let Some(bytes) = text.bytes() else {
        problems.0.push(no_ply().at(Place::file(text.file)));
        return (points, problems);
    };
    let read = read(text.file, &bytes).and_then(|header| match header.encoding {
        Encoding::Ascii => ascii(text, &header, unit, &mut points, &mut problems),
        _ => binary(text, &header, &bytes[header.bytes..], unit, &mut points),
    });
    problems.0.extend(read.err());
    (points, problems)
}

/// The elements up to the vertices, and the positions of x, y and z in a vertex.
fn vertices(header: &Header, place: Place) -> Result<(&[Element], &Element, [usize; 3]), Message> {
    let Some(at) = header.elements.iter().position(|e| e.name == "vertex") else {
        return Err(error!("no-measured-points", contents = "none", records = "element vertex n").at(place));
    };
    let vertex = &header.elements[at];
    let axis = |name: &str| {
        let mut own = vertex.properties.iter().enumerate();
        let is = |(_, p): &(usize, &Property)| matches!(p, Property::Number(n, _) if n == name);
        let record = format!("property float {name}");
        let missing = || error!("record-missing", parent = "element vertex", record).at(place.clone());
        own.find(is).map(|(i, _)| i).ok_or_else(missing)
    };
    Ok((&header.elements[..at], vertex, [axis("x")?, axis("y")?, axis("z")?]))
}

fn cut_off(vertex: &Element, found: usize, place: Place) -> Message {
    let missing = phrase!("item-of-count", name = vertex.name, number = found + 1, count = vertex.count);
    error!("file-cut-off", missing).at(place)
}

/// Text: a line for each vertex.
fn ascii(
    text: &Text,
    header: &Header,
    unit: Unit,
    points: &mut Vec<Point>,
    problems: &mut Problems,
) -> Result<(), Message> {
    let (before, vertex, axes) = vertices(header, text.place(1))?;
    let skipped = before.iter().try_fold(0u64, |sum, element| sum.checked_add(element.count));
    let lines = || text.lines.iter().enumerate().skip(header.lines).filter(|(_, line)| !line.trim().is_empty());
    let skipped = skipped.and_then(|n| usize::try_from(n).ok()).unwrap_or(usize::MAX);
    let count = usize::try_from(vertex.count).unwrap_or(usize::MAX);
    for (i, line) in lines().skip(skipped).take(count) {
        let row = Fields::new(i + 1, line, line.split_whitespace());
        let lists = vertex.properties.iter().any(|p| matches!(p, Property::List(..)));
        if !lists && row.fields.len() != vertex.properties.len() {
            let (found, counts) = (row.fields.len(), [vertex.properties.len()]);
            problems.0.push(error!("number-count-differs", name = "vertex", found, counts).at(text.place(i + 1)));
        }
        if lists {
            return Err(list_of_vertex(text.place(vertex.line)));
        }
        let mut value = |at: usize| {
            number(row.field(at), Decimal::Point).unwrap_or_else(|message| {
                problems.0.push(message.at(row.cell(text.file, at)));
                f64::NAN
            })
        };
        let xyz: Vector = axes.map(&mut value);
        points.push(text.point(i + 1, "", xyz, unit));
    }
    match points.len() < count {
        true => Err(cut_off(vertex, points.len(), text.place(vertex.line))),
        false => Ok(()),
    }
}

/// Error for a list among the properties of a vertex.
fn list_of_vertex(place: Place) -> Message {
    error!("element-unsupported", element = "property list").at(place).hint(phrase!("export-without-lists"))
}

/// Error for a file that does not begin as PLY.
fn no_ply() -> Message {
    not_this_format("ply", &phrase!("begins-with", text = "ply"))
}

/// Numbers of fixed sizes, one vertex after the other.
fn binary(text: &Text, header: &Header, body: &[u8], unit: Unit, points: &mut Vec<Point>) -> Result<(), Message> {
    let (before, vertex, axes) = vertices(header, text.place(1))?;
    let place = || text.place(vertex.line);
    let mut at = 0usize;
    for element in before {
        at = skip(element, header.encoding, body, at).ok_or_else(|| cut_off(element, 0, text.place(element.line)))?;
    }
    let mut offsets = Vec::with_capacity(vertex.properties.len());
    let mut size = 0usize;
    for property in &vertex.properties {
        let Property::Number(_, kind) = property else {
            return Err(list_of_vertex(place()));
        };
        offsets.push((size, *kind));
        size += kind.size();
    }
    let body = body.get(at..).unwrap_or_default();
    let there = body.len() / size.max(1);
    // before any memory is asked for
    if vertex.count > there as u64 {
        return Err(cut_off(vertex, there, place()));
    }
    for (i, record) in body.chunks_exact(size.max(1)).take(vertex.count as usize).enumerate() {
        let value = |axis: usize| {
            let (from, kind) = offsets[axis];
            record.get(from..from + kind.size()).and_then(|bytes| kind.value(bytes, header.encoding))
        };
        let xyz = axes.map(|axis| value(axis).unwrap_or(f64::NAN));
        if xyz.iter().any(|v| !v.is_finite()) {
            return Err(error!("vertex-not-finite", number = i + 1, coordinates = xyz).at(place()));
        }
        points.push(Point { text: format!("vertex {}", i + 1).into(), ..text.point(vertex.line, "", xyz, unit) });
    }
    Ok(())
}

/// End of an element that is not read (bytes).
fn skip(element: &Element, encoding: Encoding, body: &[u8], mut at: usize) -> Option<usize> {
    let fixed: Option<usize> = element.properties.iter().try_fold(0usize, |sum, property| match property {
        Property::Number(_, kind) => Some(sum + kind.size()),
        Property::List(..) => None,
    });
    if let Some(size) = fixed {
        let bytes = usize::try_from(element.count).ok()?.checked_mul(size)?;
        return at.checked_add(bytes).filter(|end| *end <= body.len());
    }
    let number = |kind: Kind, at: usize| kind.value(body.get(at..at.checked_add(kind.size())?)?, encoding);
    for _ in 0..element.count {
        for property in &element.properties {
            at += match property {
                Property::Number(_, kind) => kind.size(),
                Property::List(length, item) => {
                    let count = number(*length, at).filter(|n| *n >= 0.0)? as usize;
                    length.size().checked_add(count.checked_mul(item.size())?)?
                }
            };
            if at > body.len() {
                return None;
            }
        }
    }
    Some(at)
}

/// Maximum number of lines of a head; real ones have some twenty.
const MOST_LINES: usize = 2000;

/// Encoding of numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Encoding {
    Ascii,
    LittleEndian,
    BigEndian,
}

/// A type of number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

/// Names of the types of numbers.
const TYPES: [&str; 8] = ["char", "uchar", "short", "ushort", "int", "uint", "float", "double"];

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
    fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }

    /// Returns the number in these bytes, whose length must be the length of its type.
    fn value(self, bytes: &[u8], encoding: Encoding) -> Option<f64> {
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

/// Property of an element: a number, or a list (type of its length, type of its numbers).
#[derive(Clone, Debug, PartialEq)]
enum Property {
    Number(String, Kind),
    List(Kind, Kind),
}

/// Items of one kind with their number.
#[derive(Clone, Debug, PartialEq)]
struct Element {
    pub name: String,
    pub count: u64,
    pub properties: Vec<Property>,
    /// The line that gives it.
    pub line: usize,
}

/// The head.
#[derive(Debug)]
struct Header {
    pub encoding: Encoding,
    pub elements: Vec<Element>,
    /// Bytes of the head.
    pub bytes: usize,
    /// Lines of the head.
    pub lines: usize,
}

/// Reads the head of a file.
fn read(file: &str, bytes: &[u8]) -> Result<Header, Message> {
    let (mut at, mut encoding, mut elements) = (0, None, Vec::<Element>::new());
    for line in 1..=MOST_LINES {
        let rest = bytes.get(at..).unwrap_or_default();
        let Some(end) = rest.iter().take(4096).position(|b| *b == b'\n') else { break };
        let text = String::from_utf8_lossy(&rest[..end]).trim().to_owned();
        at += end + 1;
        let place = || Place::line(file, line, text.as_str());
        let wrong = |text: &str, valid: &dyn IntoArgument| {
            error!("record-invalid", text, format = "ply", valid = valid.argument()).at(place())
        };
        let words: Vec<&str> = text.split_whitespace().collect();
        match (line, &words[..]) {
            (1, ["ply"]) => {}
            (1, _) => return Err(no_ply().at(place())),
            (_, [] | ["comment" | "obj_info", ..]) => {}
            (_, ["format", name, "1.0"]) => {
                encoding = match *name {
                    "ascii" => Some(Encoding::Ascii),
                    "binary_little_endian" => Some(Encoding::LittleEndian),
                    "binary_big_endian" => Some(Encoding::BigEndian),
                    _ => return Err(wrong(name, &["ascii", "binary_little_endian", "binary_big_endian"])),
                };
            }
            (_, ["element", name, count]) => {
                let count = count.parse().map_err(|_| wrong(count, &"element NAME COUNT"))?;
                elements.push(Element { name: (*name).to_owned(), count, properties: Vec::new(), line });
            }
            (_, ["property", stated @ ..]) => {
                let kind = |name: &str| Kind::named(name).ok_or_else(|| wrong(name, &TYPES));
                let property = match stated {
                    ["list", length, item, _] => Property::List(kind(length)?, kind(item)?),
                    [item, name] => Property::Number((*name).to_owned(), kind(item)?),
                    _ => return Err(wrong(&text, &["property TYPE NAME", "property list TYPE TYPE NAME"])),
                };
                let Some(element) = elements.last_mut() else {
                    return Err(error!("record-too-early", record = "property", needed = "element").at(place()));
                };
                element.properties.push(property);
            }
            (_, ["end_header"]) => {
                let missing = || error!("record-missing", parent = "ply", record = "format").at(place());
                let encoding = encoding.ok_or_else(missing)?;
                return Ok(Header { encoding, elements, bytes: at, lines: line });
            }
            _ => return Err(wrong(&text, &["format", "element", "property", "comment", "end_header"])),
        }
    }
    Err(error!("file-cut-off", missing = "`end_header`").at(Place::file(file)))
}
