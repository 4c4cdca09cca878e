//! STL, text or binary: the vertices of its triangles are points without labels, each once. They
//! are the points of a mesh. The file does not contain their unit.

use super::{About, ExportFormat, ExportRow, Recognised, Text, WriteError, Writing};
use crate::Point;
use crate::dialect::{Dialect, Unit};
use etalon_base::message::{Message, Problems};
use etalon_base::pose::Vector;
use etalon_base::{error, phrase, warning};
use etalon_tables::Decimal;
use etalon_tables::lexer::{Row as Fields, number};
use std::collections::BTreeSet;

/// Bytes before the triangles of a binary file: a comment and their number.
const HEAD: usize = 84;
/// Bytes of a binary triangle: its normal, three vertices, and two bytes that programs use freely.
const TRIANGLE: usize = 50;
/// Number of triangles by which a binary file is recognised.
const SHOWN: usize = 100;

/// Vertices of STL.
pub(super) struct Stl;

impl ExportFormat for Stl {
    fn about(&self) -> About {
        About { name: "stl", title: "STL", binary: true, ..About::default() }
    }

    fn recognise(&self, text: &str) -> Option<Recognised> {
        let start: String = text.chars().take(HEAD + SHOWN * TRIANGLE).collect();
        let is_stl = is_text(&start) || Text::start_bytes(&start).is_some_and(|bytes| is_binary(&bytes));
        Recognised::by(is_stl, 0.95, phrase!("is-stl"))
    }

    fn caution(&self) -> Option<Message> {
        Some(warning!("vertices-of-mesh"))
    }

    fn read(&self, text: &Text, _dialect: &Dialect, unit: Unit) -> (Vec<Point>, Problems) {
        let (mut vertices, mut problems) = (Vertices::default(), Problems::default());
        let read = match text.bytes().filter(|_| !is_text(text.whole)) {
            Some(bytes) => binary(text, &bytes, unit, &mut vertices),
            None => {
                ascii(text, unit, &mut vertices, &mut problems);
                Ok(())
            }
        };
        problems.0.extend(read.err());
        if vertices.points.is_empty() && problems.0.is_empty() {
            problems
                .0
                .push(error!("no-measured-points", contents = "none", records = "vertex x y z").at(text.place(1)));
        }
        (vertices.points, problems)
    }

    fn write(&self, _rows: &[ExportRow], _how: &Writing) -> Result<String, WriteError> {
        Err(WriteError::Unsupported(error!("format-not-simulated", kind = "stl")))
    }
}

/// Vertices, each once: neighbouring triangles share them.
#[derive(Default)]
struct Vertices {
    seen: BTreeSet<[u64; 3]>,
    points: Vec<Point>,
}

impl Vertices {
    /// `true` for a vertex that is not among the points.
    fn is_new(&mut self, xyz: Vector) -> bool {
        // 0 and -0 are one coordinate
        self.seen.insert(xyz.map(|v| (v + 0.0).to_bits()))
    }
}

/// `true` for the beginning of a file of text.
pub(crate) fn is_text(start: &str) -> bool {
    let mut lines = start.lines().filter(|line| !line.trim().is_empty());
    let named = lines.next().is_some_and(|line| line.trim_start().starts_with("solid"));
    named && lines.next().is_some_and(|line| line.trim_start().starts_with("facet"))
}

/// `true` for the beginning of a binary file: its first triangles have normals of length 1 or 0.
fn is_binary(bytes: &[u8]) -> bool {
    let Some(count) = bytes.get(HEAD - 4..HEAD).and_then(|count| count.try_into().ok()) else { return false };
    let triangles = || bytes[HEAD..].chunks_exact(TRIANGLE).take(SHOWN);
    let whole = triangles().len();
    let is_triangle = |triangle: &[u8]| {
        let values: Vec<f64> = numbers(triangle).map(f64::from).collect();
        let length = values[..3].iter().map(|v| v * v).sum::<f64>().sqrt();
        values.iter().all(|v| v.is_finite() && v.abs() < 1e7) && (length == 0.0 || (length - 1.0).abs() < 0.02)
    };
    let any = || triangles().any(|triangle| triangle[..48].iter().any(|byte| *byte != 0));
    whole > 0 && u32::from_le_bytes(count) as usize >= whole && triangles().all(is_triangle) && any()
}

/// The twelve numbers of a triangle: its normal and three vertices.
fn numbers(triangle: &[u8]) -> impl Iterator<Item = f32> + '_ {
    triangle[..48].chunks_exact(4).map(|b| f32::from_le_bytes([b[0], b[1], b[2], b[3]]))
}

/// Stated number of triangles of a binary file, and the corners of those that are there.
pub(crate) fn triangles(bytes: &[u8]) -> (usize, impl ExactSizeIterator<Item = [[f32; 3]; 3]> + '_) {
    let count = bytes.get(HEAD - 4..HEAD).and_then(|count| count.try_into().ok()).map_or(0, u32::from_le_bytes);
    let triangles = bytes.get(HEAD..).unwrap_or_default().chunks_exact(TRIANGLE);
    let corners = |triangle: &[u8]| {
        let mut values = numbers(triangle).skip(3);
        std::array::from_fn(|_| std::array::from_fn(|_| values.next().unwrap_or(f32::NAN)))
    };
    (count as usize, triangles.map(corners))
}

fn binary(text: &Text, bytes: &[u8], unit: Unit, vertices: &mut Vertices) -> Result<(), Message> {
    let (count, triangles) = triangles(bytes);
    let there = triangles.len();
    if count == 0 || count > there {
        let missing = phrase!("item-of-count", name = "triangle", number = there + 1, count);
        return Err(error!("file-cut-off", missing).at(text.place(1)));
    }
    for (i, corners) in triangles.take(count).enumerate() {
        for xyz in corners.map(|corner| corner.map(f64::from)) {
            if xyz.iter().any(|v| !v.is_finite()) {
                return Err(error!("vertex-not-finite", number = i + 1, coordinates = xyz).at(text.place(1)));
            }
            if vertices.is_new(xyz) {
                let line = format!("triangle {}", i + 1).into();
                vertices.points.push(Point { text: line, ..text.point(1, "", xyz, unit) });
            }
        }
    }
    Ok(())
}

/// Text: a line for each vertex.
fn ascii(text: &Text, unit: Unit, vertices: &mut Vertices, problems: &mut Problems) {
    for (i, line) in text.lines.iter().enumerate() {
        let row = Fields::new(i + 1, line, line.split_whitespace());
        if row.field(0) != "vertex" {
            continue;
        }
        if row.fields.len() != 4 {
            let (found, counts) = (row.fields.len() - 1, [3]);
            problems.0.push(error!("number-count-differs", name = "vertex", found, counts).at(text.place(i + 1)));
            continue;
        }
        let value = |at: usize| number(row.field(at), Decimal::Point).map_err(|m| m.at(row.cell(text.file, at)));
        match (value(1), value(2), value(3)) {
            (Ok(x), Ok(y), Ok(z)) if vertices.is_new([x, y, z]) => {
                vertices.points.push(text.point(i + 1, "", [x, y, z], unit));
            }
            (Ok(_), Ok(_), Ok(_)) => {}
            (x, y, z) => problems.0.extend([x, y, z].into_iter().filter_map(Result::err)),
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::Format;
    use crate::dialect::Unit;

    /// Two triangles that share an edge; the second has the two free bytes of a colour.
    fn binary() -> String {
        let mut bytes = vec![b' '; 80];
        bytes.extend(2u32.to_le_bytes());
        for (third, colour) in [([0.0f32, 25.4, 0.0], [0, 0]), ([0.0, -25.4, 0.0], [0x77, 0x1e])] {
            for corner in [[0.0, 0.0, 1.0], [0.0, 0.0, 0.0], [12.5, 0.0, 0.5], third] {
                corner.iter().for_each(|v: &f32| bytes.extend(v.to_le_bytes()));
            }
            bytes.extend(colour);
        }
        bytes.into_iter().map(char::from).collect()
    }

    const TEXT: &str = "solid part\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 12.5 0 0.5\n   \
        vertex 0 25.4 0\n  endloop\n endfacet\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   \
        vertex 12.5 0 0.5\n   vertex 0 -25.4 -0.0\n  endloop\n endfacet\nendsolid part\n";

    #[test]
    fn each_vertex_of_a_mesh_is_one_point() {
        let format = Format::named("stl").unwrap();
        for text in [TEXT.to_owned(), binary()] {
            let (points, problems) = format.read("p.stl", &text.as_str().into(), Unit::Inch);
            assert!(problems.0.is_empty(), "{problems:?}");
            let xyz: Vec<[f64; 3]> =
                points.iter().map(|point| point.xyz_mm.map(|v| (v / 25.4 * 1e5).round() / 1e5)).collect();
            assert_eq!(xyz, [[0.0, 0.0, 0.0], [12.5, 0.0, 0.5], [0.0, 25.4, 0.0], [0.0, -25.4, 0.0]]);
            let document = crate::propose("p.stl", &text);
            assert_eq!(document.format.as_deref(), Some("stl"), "{}", document.toml);
            let warned =
                document.doubts.iter().filter_map(|doubt| doubt.phrase()).any(|doubt| doubt.id == "vertices-of-mesh");
            assert!(warned, "{}", document.toml);
        }
        let cut: String = binary().chars().take(84 + 60).collect();
        assert!(format.read("p.stl", &cut.as_str().into(), Unit::Inch).1.0[0].is("file-cut-off", &[]));
        let short = TEXT.replace("12.5 0 0.5", "12.5 0");
        assert!(format.read("p.stl", &short.as_str().into(), Unit::Inch).1.0[0].is("number-count-differs", &[]));
    }
}
