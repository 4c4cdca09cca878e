//! C3D of motion capture: the markers of each frame are points with the marker as label, the number
//! of the frame as pose, and its time. The parameter POINT:UNITS gives the unit.
//!
//! Blocks of 512 bytes: a header, parameters in groups, and frames of four numbers a marker: x, y,
//! z, and a fourth one that is negative for a marker that was not seen. Source: c3d.org, "The C3D
//! file format user guide".

use super::{About, ExportFormat, ExportRow, Recognised, Text, WriteError, Writing, not_this_format, unit_agrees};
use crate::Point;
use crate::dialect::{Dialect, Unit};
use crate::points::SharedText;
use etalon_base::message::{Message, Problems};
use etalon_base::{error, phrase};

/// Bytes of a block.
const BLOCK: usize = 512;
/// Second byte of every file.
const MARK: u8 = 0x50;
/// Byte of the parameters for numbers of Intel processors.
const INTEL: u8 = 84;
/// Maximum number of markers and of frames.
const MOST: usize = 1 << 20;

/// Markers of C3D.
pub(super) struct C3d;

impl ExportFormat for C3d {
    fn about(&self) -> About {
        About { name: "c3d", title: "C3D", binary: true, ..About::default() }
    }

    fn recognise(&self, text: &str) -> Option<Recognised> {
        let bytes = Text::start_bytes(text)?;
        let parameters = usize::from(*bytes.first()?).checked_sub(1)? * BLOCK;
        let is_c3d = bytes.get(1) == Some(&MARK) && bytes.get(parameters + 3).is_some_and(|p| (84..=86).contains(p));
        let unit = Header::new(&bytes).ok().and_then(|header| header.unit());
        let found = Recognised::by(is_c3d && parameters > 0, 1.0, phrase!("is-c3d"))?;
        Some(Recognised { unit: unit.map(Unit::name), ..found })
    }

    fn read(&self, text: &Text, _dialect: &Dialect, unit: Unit) -> (Vec<Point>, Problems) {
        let mut problems = Problems::default();
        let all = text.bytes().filter(|bytes| bytes.get(1) == Some(&MARK));
        let all = all.ok_or_else(|| not_this_format("c3d", &"C3D"));
        let points = all.and_then(|bytes| {
            let header = Header::new(&bytes)?;
            if let Some(of_file) = header.unit() {
                unit_agrees(unit, of_file, &"POINT:UNITS", text.place(1))?;
            }
            header.points(text, &bytes, unit)
        });
        problems.0.extend(points.as_ref().err().cloned().map(|message| message.at(text.place(1))));
        (points.unwrap_or_default(), problems)
    }

    fn write(&self, _rows: &[ExportRow], _how: &Writing) -> Result<String, WriteError> {
        Err(WriteError::Unsupported(error!("format-not-simulated", kind = "c3d")))
    }
}

/// Header and parameters.
struct Header {
    markers: usize,
    /// Numbers of the first and of the last frame.
    frames: [usize; 2],
    /// Bytes of a frame: markers, and readings of analogue channels.
    frame_bytes: usize,
    /// Factor of whole numbers; `None` for numbers of four bytes.
    scale: Option<f64>,
    /// First byte of the frames.
    start: usize,
    rate_hz: f64,
    labels: Vec<String>,
    units: String,
}

impl Header {
    fn new(bytes: &[u8]) -> Result<Self, Message> {
        let cut = |name: &str| error!("file-cut-off", missing = format!("`{name}`"));
        let word = |at: usize| {
            let pair = bytes.get(at..at + 2).and_then(|pair| pair.try_into().ok());
            pair.map(u16::from_le_bytes).map(usize::from).ok_or_else(|| cut("header"))
        };
        let real = |at: usize| {
            let four = bytes.get(at..at + 4).and_then(|four| four.try_into().ok());
            four.map(f32::from_le_bytes).map(f64::from).ok_or_else(|| cut("header"))
        };
        let parameters = usize::from(*bytes.first().ok_or_else(|| cut("header"))?).saturating_sub(1) * BLOCK;
        match bytes.get(parameters + 3) {
            Some(&INTEL) => {}
            Some(other) => return Err(error!("element-unsupported", element = format!("processor {other}"))),
            None => return Err(cut("POINT:LABELS")),
        }
        let (markers, analogue) = (word(2)?, word(4)?);
        let stated = real(12)?;
        let of_number = if stated < 0.0 { 4 } else { 2 };
        let found = Parameters::new(bytes, parameters);
        let (rate_hz, scale) = (real(20)?, found.real("POINT", "SCALE").unwrap_or(stated));
        // more than 65,535 frames are given as a parameter
        let last =
            found.real("POINT", "LONG_FRAMES").map_or(word(8)?, |count| word(6).unwrap_or(1) + count as usize - 1);
        let labels: Vec<String> = (1..)
            .map(|n| if n == 1 { "LABELS".to_owned() } else { format!("LABELS{n}") })
            .map_while(|name| found.texts("POINT", &name))
            .flatten()
            .collect();
        let header = Self {
            markers,
            frames: [word(6)?, last],
            frame_bytes: (4 * markers + analogue) * of_number,
            scale: (of_number == 2).then_some(scale.abs()),
            start: word(16)?.saturating_sub(1) * BLOCK,
            rate_hz,
            labels,
            units: found.texts("POINT", "UNITS").and_then(|units| units.into_iter().next()).unwrap_or_default(),
        };
        let [first, last] = header.frames;
        if header.markers == 0 || header.markers > MOST || first > last || last - first >= MOST {
            return Err(error!("no-measured-points", contents = "none", records = "POINT:LABELS"));
        }
        Ok(header)
    }

    /// Unit of the coordinates, if the file contains it.
    fn unit(&self) -> Option<Unit> {
        Unit::named(match self.units.to_lowercase().as_str() {
            "millimeter" | "millimeters" | "millimetre" | "millimetres" => "mm",
            "meter" | "meters" | "metre" | "metres" => "m",
            "in" | "inches" => "inch",
            other => other,
        })
    }

    /// Points of all frames.
    fn points(&self, text: &Text, bytes: &[u8], unit: Unit) -> Result<Vec<Point>, Message> {
        let [first, last] = self.frames;
        let names: Vec<SharedText> = (0..self.markers)
            .map(|at| {
                self.labels
                    .get(at)
                    .filter(|name| !name.is_empty())
                    .cloned()
                    .unwrap_or_else(|| format!("marker_{}", at + 1))
            })
            .map(SharedText::from)
            .collect();
        let there = bytes.get(self.start..).unwrap_or_default().len() / self.frame_bytes.max(1);
        if there < last - first + 1 {
            let missing = phrase!("item-of-count", name = "frame", number = there + 1, count = last - first + 1);
            return Err(error!("file-cut-off", missing));
        }
        let of_number = if self.scale.is_some() { 2 } else { 4 };
        let number = |bytes: &[u8]| match (bytes, self.scale) {
            ([a, b], Some(scale)) => f64::from(i16::from_le_bytes([*a, *b])) * scale,
            ([a, b, c, d], _) => f64::from(f32::from_le_bytes([*a, *b, *c, *d])),
            _ => f64::NAN,
        };
        let mut points = Vec::with_capacity((last - first + 1) * self.markers);
        let frames = bytes[self.start..].chunks_exact(self.frame_bytes);
        for (frame, numbers) in (first..=last).zip(frames) {
            for (name, marker) in names.iter().zip(numbers.chunks_exact(4 * of_number)) {
                let values: Vec<f64> = marker.chunks_exact(of_number).map(number).collect();
                let xyz = [values[0], values[1], values[2]];
                let is_seen = values[3] >= 0.0 && xyz.iter().all(|v| v.is_finite());
                let mut point = match is_seen {
                    true => text.point(1, "", xyz, unit),
                    false => text.no_point(1, "", phrase!("row-without-coordinates")),
                };
                point.label = name.clone();
                point.text = format!("frame {frame}").into();
                point.pose = Some((frame as i64).into());
                point.time_s = (self.rate_hz > 0.0).then(|| (frame - first) as f64 / self.rate_hz);
                points.push(point);
            }
        }
        Ok(points)
    }
}

/// A parameter with the name of its group.
struct Parameter<'a> {
    group: String,
    name: String,
    /// Bytes of an item; -1 for letters.
    kind: i8,
    dimensions: Vec<usize>,
    data: &'a [u8],
}

struct Parameters<'a>(Vec<Parameter<'a>>);

impl<'a> Parameters<'a> {
    /// Reads the parameters that begin at this byte, up to the first damaged one.
    fn new(bytes: &'a [u8], start: usize) -> Self {
        let (mut groups, mut all) = (Vec::<(i8, String)>::new(), Vec::new());
        let mut at = start + 4;
        while let Some((id, name, body, next)) = Self::record(bytes, at) {
            match id {
                ..0 => groups.push((-id, name)),
                0 => break,
                _ => {
                    if let Some((kind, dimensions, data)) = Self::content(bytes, body) {
                        all.push((id, name, kind, dimensions, data));
                    }
                }
            }
            let Some(next) = next else { break };
            at = next;
        }
        let group = |id: i8| groups.iter().find(|(of, _)| *of == id).map(|(_, name)| name.clone());
        let parameter =
            |(id, name, kind, dimensions, data)| Some(Parameter { group: group(id)?, name, kind, dimensions, data });
        Self(all.into_iter().filter_map(parameter).collect())
    }

    /// Number of the group (negative for a group), name, first byte of the content, and of the next
    /// record.
    fn record(bytes: &[u8], at: usize) -> Option<(i8, String, usize, Option<usize>)> {
        let length = usize::from((*bytes.get(at)? as i8).unsigned_abs());
        let id = *bytes.get(at + 1)? as i8;
        let name = bytes.get(at + 2..at + 2 + length)?;
        let offset = at + 2 + length;
        let next = u16::from_le_bytes(bytes.get(offset..offset + 2)?.try_into().ok()?);
        let next = (next > 0).then_some(offset + usize::from(next));
        Some((id, String::from_utf8_lossy(name).to_uppercase(), offset + 2, next))
    }

    /// Size of an item, dimensions and bytes of a parameter.
    fn content(bytes: &'a [u8], at: usize) -> Option<(i8, Vec<usize>, &'a [u8])> {
        let kind = *bytes.get(at)? as i8;
        let count = usize::from(*bytes.get(at + 1)?);
        let dimensions: Vec<usize> = bytes.get(at + 2..at + 2 + count)?.iter().map(|n| usize::from(*n)).collect();
        let items = dimensions.iter().try_fold(1usize, |all, n| all.checked_mul(*n))?;
        let from = at + 2 + count;
        let size = items.checked_mul(usize::from(kind.unsigned_abs()))?;
        Some((kind, dimensions, bytes.get(from..from.checked_add(size)?)?))
    }

    fn find(&self, group: &str, name: &str) -> Option<(i8, &[usize], &'a [u8])> {
        let found = self.0.iter().find(|own| own.group == group && own.name == name)?;
        Some((found.kind, &found.dimensions, found.data))
    }

    /// First number of a parameter.
    fn real(&self, group: &str, name: &str) -> Option<f64> {
        let (kind, _, data) = self.find(group, name)?;
        match kind {
            2 => Some(f64::from(i16::from_le_bytes(data.get(..2)?.try_into().ok()?))),
            4 => Some(f64::from(f32::from_le_bytes(data.get(..4)?.try_into().ok()?))),
            _ => None,
        }
    }

    /// Texts of a parameter.
    fn texts(&self, group: &str, name: &str) -> Option<Vec<String>> {
        let (kind, dimensions, data) = self.find(group, name)?;
        let width = dimensions.first().copied().filter(|width| *width > 0 && kind == -1)?;
        Some(data.chunks(width).map(|text| String::from_utf8_lossy(text).trim().to_owned()).collect())
    }
}

#[cfg(test)]
mod tests {
    use crate::Format;
    use crate::dialect::Unit;

    /// A group or a parameter with its content.
    fn record(id: i8, name: &str, content: &[u8]) -> Vec<u8> {
        let mut bytes = vec![name.len() as u8, id as u8];
        bytes.extend(name.bytes());
        bytes.extend((content.len() as u16 + 2).to_le_bytes());
        bytes.extend(content);
        bytes
    }

    /// Two markers in frames 5 and 6 at 100 Hz; the second marker is not seen in frame 6.
    fn file(whole_numbers: bool) -> String {
        let letters = |texts: &[&str]| {
            let mut content = vec![-1i8 as u8, 2, 8, texts.len() as u8];
            texts.iter().for_each(|text| content.extend(format!("{text:<8}").bytes()));
            content.push(0);
            content
        };
        let mut bytes = vec![0u8; 512];
        (bytes[0], bytes[1]) = (2, 0x50);
        let scale: f32 = if whole_numbers { 0.25 } else { -0.25 };
        for (at, word) in [(2, 2u16), (4, 0), (6, 5), (8, 6), (16, 3)] {
            bytes[at..at + 2].copy_from_slice(&word.to_le_bytes());
        }
        bytes[12..16].copy_from_slice(&scale.to_le_bytes());
        bytes[20..24].copy_from_slice(&100.0f32.to_le_bytes());
        let mut parameters = vec![1, 0x50, 1, 84];
        parameters.extend(record(-1, "POINT", &[0]));
        parameters.extend(record(1, "LABELS", &letters(&["ball", "flange"])));
        parameters.extend(record(1, "UNITS", &letters(&["mm"])));
        parameters.extend([0, 0]);
        parameters.resize(512, 0);
        bytes.extend(parameters);
        for values in [[12.5, -3.0, 4.25, 0.0, 1.0, 2.0, 3.0, 0.0], [13.5, -3.0, 4.25, 0.0, 0.0, 0.0, 0.0, -1.0]] {
            for (k, value) in values.into_iter().enumerate() {
                match whole_numbers {
                    true => bytes.extend(((if k % 4 == 3 { value } else { value / 0.25 }) as i16).to_le_bytes()),
                    false => bytes.extend((value as f32).to_le_bytes()),
                }
            }
        }
        bytes.into_iter().map(char::from).collect()
    }

    #[test]
    fn markers_of_each_frame_are_points_with_a_pose_and_a_time() {
        let format = Format::named("c3d").unwrap();
        for whole_numbers in [false, true] {
            let text = file(whole_numbers);
            let (points, problems) = format.read("w.c3d", &text.as_str().into(), Unit::Millimetre);
            assert!(problems.0.is_empty(), "{problems:?}");
            let labels: Vec<&str> = points.iter().map(|point| &*point.label).collect();
            assert_eq!(labels, ["ball", "flange", "ball", "flange"]);
            assert_eq!((points[0].xyz_mm, points[1].xyz_mm), ([12.5, -3.0, 4.25], [1.0, 2.0, 3.0]));
            assert_eq!(
                (points[2].xyz_mm, points[2].pose, points[2].time_s),
                ([13.5, -3.0, 4.25], Some(6.into()), Some(0.01))
            );
            assert!(points[3].refused.is_some());
            let (_, problems) = format.read("w.c3d", &text.as_str().into(), Unit::Metre);
            assert!(problems.0[0].is("unit-differs", &[("of_file", &"mm"), ("stated", &"m")]), "{problems:?}");
            let document = crate::propose("w.c3d", &text);
            assert_eq!(document.format.as_deref(), Some("c3d"), "{}", document.toml);
            assert!(document.toml.contains("unit = \"mm\"                # the file states it"), "{}", document.toml);
            let cut: String = text.chars().take(text.chars().count() - 4).collect();
            let (_, problems) = format.read("w.c3d", &cut.as_str().into(), Unit::Millimetre);
            assert!(problems.0[0].is("file-cut-off", &[]), "{problems:?}");
        }
    }
}
