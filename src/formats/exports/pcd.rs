//! PCD of the Point Cloud Library, text or binary: the fields x, y and z of its points, without
//! labels. NaN is a direction without an echo. The file does not contain their unit.
//!
//! Source: pointclouds.org, "The PCD (Point Cloud Data) file format", version 0.7.

use super::{About, ExportFormat, ExportRow, Recognised, Text, WriteError, Writing, not_this_format};
use crate::Point;
use crate::dialect::{Dialect, Unit};
use etalon_base::message::{Message, Problems};
use etalon_base::pose::Vector;
use etalon_base::{error, phrase};
use etalon_tables::Decimal;
use etalon_tables::lexer::{Row as Fields, parsed};

/// Maximum number of lines of a head.
const MOST_LINES: usize = 100;

/// Points of PCD.
pub(super) struct Pcd;

impl ExportFormat for Pcd {
    fn about(&self) -> About {
        About { name: "pcd", title: "PCD", binary: true, ..About::default() }
    }

    fn recognise(&self, text: &str) -> Option<Recognised> {
        let mut words = text.lines().take(MOST_LINES).map(|line| line.split_whitespace().next().unwrap_or(""));
        let is_pcd = words.clone().any(|word| word == "FIELDS") && words.any(|word| word == "DATA");
        Recognised::by(is_pcd, 0.95, phrase!("is-pcd"))
    }

    fn read(&self, text: &Text, _dialect: &Dialect, unit: Unit) -> (Vec<Point>, Problems) {
        let mut problems = Problems::default();
        let points = Head::new(text).and_then(|head| match (head.data.as_str(), text.bytes()) {
            ("ascii", _) => Ok(head.ascii(text, unit, &mut problems)),
            ("binary", Some(bytes)) => head.binary(text, bytes.get(head.bytes..).unwrap_or_default(), unit),
            (other, _) => {
                Err(error!("element-unsupported", element = format!("DATA {other}")).at(text.place(head.lines)))
            }
        });
        let points = points.unwrap_or_else(|message| {
            problems.0.push(message);
            Vec::new()
        });
        (points, problems)
    }

    fn write(&self, rows: &[ExportRow], how: &Writing) -> Result<String, WriteError> {
        let count = rows.len();
        let points: String = rows.iter().map(|row| how.list(row, " ") + "\n").collect();
        Ok(format!(
            "VERSION .7\nFIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nCOUNT 1 1 1\nWIDTH {count}\nHEIGHT 1\n\
             VIEWPOINT 0 0 0 1 0 0 0\nPOINTS {count}\nDATA ascii\n{points}"
        ))
    }
}

/// Head of a file.
struct Head {
    /// Number of each coordinate among the numbers of a point, its first byte, and its size.
    axes: [[usize; 3]; 3],
    /// Count of numbers and of bytes of a point.
    size: [usize; 2],
    points: usize,
    data: String,
    /// Lines and bytes of the head.
    lines: usize,
    bytes: usize,
}

impl Head {
    fn new(text: &Text) -> Result<Self, Message> {
        let mut stated: Vec<(&str, Vec<&str>, usize)> = Vec::new();
        let mut bytes = 0;
        for (i, line) in text.lines.iter().enumerate().take(MOST_LINES) {
            let mut words = line.split_whitespace();
            let Some(key) = words.next().filter(|key| !key.starts_with('#')) else { continue };
            stated.push((key, words.collect(), i + 1));
            if key == "DATA" {
                // a character of a binary file is a byte
                let end = (line.as_ptr() as usize).wrapping_sub(text.whole.as_ptr() as usize) + line.len();
                let after = if text.whole.get(end..).is_some_and(|rest| rest.starts_with('\r')) { 2 } else { 1 };
                bytes = text.whole.get(..end).map_or(0, |head| head.chars().count() + after);
                break;
            }
        }
        let find = |key: &str| {
            let missing = || error!("record-missing", parent = "pcd", record = key).at(text.place(1));
            stated.iter().find(|(of, ..)| *of == key).map(|(_, words, line)| (words, *line)).ok_or_else(missing)
        };
        if stated.is_empty() {
            return Err(not_this_format("pcd", &"PCD").at(text.place(1)));
        }
        let whole = |key: &str| -> Result<Vec<usize>, Message> {
            let (words, line) = find(key)?;
            let invalid =
                |word: &str| error!("record-invalid", text = word, format = "pcd", valid = "4").at(text.place(line));
            words.iter().map(|word| word.parse().map_err(|_| invalid(word))).collect()
        };
        let (fields, _) = find("FIELDS")?;
        let (sizes, (types, line)) = (whole("SIZE")?, find("TYPE")?);
        let counts = if find("COUNT").is_ok() { whole("COUNT")? } else { vec![1; fields.len()] };
        let (data, lines) = find("DATA")?;
        let [points] = whole("POINTS")?[..] else {
            return Err(error!("record-missing", parent = "pcd", record = "POINTS").at(text.place(1)));
        };
        let (mut axes, mut size) = ([[0; 3]; 3], [0, 0]);
        let mut found = 0;
        for (k, field) in fields.iter().enumerate() {
            let (Some(bytes), Some(count)) = (sizes.get(k), counts.get(k)) else { break };
            if let Some(axis) = ["x", "y", "z"].iter().position(|axis| axis == field) {
                if types.get(k) != Some(&"F") || !matches!(bytes, 4 | 8) {
                    let valid = ["F 4", "F 8"];
                    return Err(error!("record-invalid", text = *field, format = "pcd", valid).at(text.place(line)));
                }
                (axes[axis], found) = ([size[0], size[1], *bytes], found + 1);
            }
            size = [size[0].saturating_add(*count), size[1].saturating_add(bytes.saturating_mul(*count))];
        }
        if found != 3 {
            return Err(error!("record-missing", parent = "pcd", record = "FIELDS x y z").at(text.place(1)));
        }
        Ok(Self { axes, size, points, data: data.first().copied().unwrap_or("").to_owned(), lines, bytes })
    }

    /// A point, or a direction without an echo.
    fn point(text: &Text, line: usize, xyz: Vector, unit: Unit) -> Point {
        match xyz.iter().all(|v| v.is_finite()) {
            true => text.point(line, "", xyz, unit),
            false => text.no_point(line, "", phrase!("row-without-coordinates")),
        }
    }

    fn cut_off(&self, text: &Text, there: usize) -> Message {
        let missing = phrase!("item-of-count", name = "POINTS", number = there + 1, count = self.points);
        error!("file-cut-off", missing).at(text.place(self.lines))
    }

    fn ascii(&self, text: &Text, unit: Unit, problems: &mut Problems) -> Vec<Point> {
        let lines = text.lines.iter().enumerate().skip(self.lines).filter(|(_, line)| !line.trim().is_empty());
        let mut points = Vec::new();
        for (i, line) in lines.take(self.points) {
            let row = Fields::new(i + 1, line, line.split_whitespace());
            if row.fields.len() != self.size[0] {
                let (found, counts) = (row.fields.len(), [self.size[0]]);
                problems.0.push(error!("number-count-differs", name = "POINTS", found, counts).at(text.place(i + 1)));
                continue;
            }
            let value = |at: usize| match row.field(at) {
                "nan" | "NaN" | "-nan" => f64::NAN,
                word => parsed(word, Decimal::Point, None).unwrap_or(f64::NAN),
            };
            points.push(Self::point(text, i + 1, self.axes.map(|[at, ..]| value(at)), unit));
        }
        if points.len() < self.points && problems.0.is_empty() {
            problems.0.push(self.cut_off(text, points.len()));
        }
        points
    }

    fn binary(&self, text: &Text, body: &[u8], unit: Unit) -> Result<Vec<Point>, Message> {
        let there = body.len() / self.size[1].max(1);
        if there < self.points {
            return Err(self.cut_off(text, there));
        }
        let value = |record: &[u8], [_, from, size]: [usize; 3]| match record.get(from..from + size) {
            Some([a, b, c, d]) => f64::from(f32::from_le_bytes([*a, *b, *c, *d])),
            Some(eight) => eight.try_into().map_or(f64::NAN, f64::from_le_bytes),
            None => f64::NAN,
        };
        let read = |(i, record): (usize, &[u8])| {
            let point = Self::point(text, self.lines, self.axes.map(|axis| value(record, axis)), unit);
            Point { text: format!("point {}", i + 1).into(), ..point }
        };
        Ok(body.chunks_exact(self.size[1].max(1)).take(self.points).enumerate().map(read).collect())
    }
}

#[cfg(test)]
mod tests {
    use crate::Format;
    use crate::dialect::Unit;

    /// Three points, the second without an echo; a colour and padding stand before x.
    fn file(data: &str) -> String {
        let head = format!(
            "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS rgb _ x y z\nSIZE 4 1 4 4 4\nTYPE F U F F F\n\
             COUNT 1 2 1 1 1\nWIDTH 3\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 3\nDATA {data}\n"
        );
        let points = [[1.5f32, 2.5, -3.5], [f32::NAN; 3], [0.0, 0.25, 0.5]];
        if data == "ascii" {
            return head + &points.map(|[x, y, z]| format!("7 0 0 {x} {y} {z}\n")).concat();
        }
        let mut bytes: Vec<u8> = Vec::new();
        for point in points {
            bytes.extend([9, 200, 10, 13, 1, 2]);
            point.iter().for_each(|v| bytes.extend(v.to_le_bytes()));
        }
        head + &bytes.into_iter().map(char::from).collect::<String>()
    }

    #[test]
    fn points_of_text_and_binary_files_are_the_same() {
        let format = Format::named("pcd").unwrap();
        for data in ["ascii", "binary"] {
            let text = file(data);
            let (points, problems) = format.read("c.pcd", &text.as_str().into(), Unit::Metre);
            assert!(problems.0.is_empty(), "{data}: {problems:?}");
            assert_eq!(
                (points[0].xyz_mm, points[2].xyz_mm),
                ([1500.0, 2500.0, -3500.0], [0.0, 250.0, 500.0]),
                "{data}"
            );
            assert!(points[1].refused.is_some() && points.len() == 3);
            assert_eq!(crate::propose("c.pcd", &text).format.as_deref(), Some("pcd"));
            let cut: String = text.chars().take(text.chars().count() - 12).collect();
            let (_, problems) = format.read("c.pcd", &cut.as_str().into(), Unit::Metre);
            assert!(
                problems.0[0].is("file-cut-off", &[]) || problems.0[0].is("number-count-differs", &[]),
                "{problems:?}"
            );
        }
        let (_, problems) = format.read("c.pcd", &file("binary_compressed").as_str().into(), Unit::Metre);
        assert!(problems.0[0].is("element-unsupported", &[("element", &"DATA binary_compressed")]), "{problems:?}");
        let without = file("ascii").replace("x y z", "u v w");
        assert!(format.read("c.pcd", &without.as_str().into(), Unit::Metre).1.0[0].is("record-missing", &[]));
    }
}
