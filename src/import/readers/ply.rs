//! PLY, text or binary: its vertices are points without labels. Their unit is nowhere in the file.

use super::super::points::Point;
use super::Text;
use super::ply_header::{Element, Encoding, Header, Kind, Property, read};
use crate::base::message::{Message, Place, Problems};
use crate::base::pose::Vector;
use crate::import::delimited::{Row, cell_place, number};
use crate::import::format::Decimal;
use crate::import::format::Unit;

/// The vertices. The text of a binary file has one character for each byte.
pub(super) fn rows(text: &Text, whole: &str, unit: Unit) -> (Vec<Point>, Problems) {
    let (mut points, mut problems) = (Vec::new(), Problems::default());
    let Some(bytes) = whole.chars().map(|c| u8::try_from(u32::from(c)).ok()).collect::<Option<Vec<u8>>>() else {
        problems.0.push(Message::error("a PLY file has no such characters").at(Place::file(text.file)));
        return (points, problems);
    };
    let read = read(text.file, &bytes).and_then(|header| match header.encoding {
        Encoding::Ascii => ascii(text, &header, unit, &mut points, &mut problems),
        _ => binary(text, &header, &bytes[header.bytes..], unit, &mut points),
    });
    problems.0.extend(read.err());
    (points, problems)
}

/// The elements up to the vertices, and where x, y and z of a vertex are.
fn vertices(header: &Header, place: Place) -> Result<(&[Element], &Element, [usize; 3]), Message> {
    let Some(at) = header.elements.iter().position(|e| e.name == "vertex") else {
        return Err(Message::error("the file has no vertices").at(place).expected("`element vertex n`"));
    };
    let vertex = &header.elements[at];
    let axis = |name: &str| {
        let mut own = vertex.properties.iter().enumerate();
        let is = |(_, p): &(usize, &Property)| matches!(p, Property::Number(n, _) if n == name);
        let missing = || Message::error(format!("a vertex has no `{name}`")).at(place.clone());
        own.find(is).map(|(i, _)| i).ok_or_else(missing)
    };
    Ok((&header.elements[..at], vertex, [axis("x")?, axis("y")?, axis("z")?]))
}

fn cut_off(vertex: &Element, found: usize, place: Place) -> Message {
    Message::error(format!("the head states {} of `{}`, and the file ends after {found}", vertex.count, vertex.name))
        .at(place)
        .hint("it was cut off: export it again")
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
        let fields: Vec<&str> = line.split_whitespace().collect();
        let lists = vertex.properties.iter().any(|p| matches!(p, Property::List(..)));
        if !lists && fields.len() != vertex.properties.len() {
            let message = Message::error(format!("the vertex has {} values", fields.len())).at(text.place(i + 1));
            problems.0.push(message.expected(vertex.properties.len().to_string()));
        }
        if lists {
            let message = Message::error("a vertex with a list is not read").at(text.place(vertex.line));
            return Err(message.hint("export the points without lists"));
        }
        let mut value = |at: usize| {
            let field = fields.get(at).copied().unwrap_or("");
            number(field, Decimal::Point).unwrap_or_else(|message| {
                let row = Row { line: i + 1, fields: fields.iter().map(|f| (*f).to_owned()).collect() };
                problems.0.push(message.at(cell_place(text.file, &row, line, at)));
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

/// Numbers of fixed sizes, one vertex behind the other.
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
            let message = Message::error("a vertex with a list is not read").at(place());
            return Err(message.hint("export the points without lists"));
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
            let what = format!("vertex {} is {} {} {}: no point", i + 1, xyz[0], xyz[1], xyz[2]);
            return Err(Message::error(what).at(place()));
        }
        points.push(Point { text: format!("vertex {}", i + 1), ..text.point(vertex.line, "", xyz, unit) });
    }
    Ok(())
}

/// Where an element that is not wanted ends.
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
