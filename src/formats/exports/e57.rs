//! E57 of laser scanners (ASTM E2807), in metres: the points of all scans, placed by the poses of
//! the scans, without labels.

use super::{About, ExportFormat, ExportRow, Recognised, Text, WriteError, Writing, not_this_format, unit_agrees};
use crate::Point;
use crate::dialect::{Dialect, Unit};
use ::e57::{CartesianCoordinate, E57Reader, Error};
use etalon_base::message::{Message, Problems};
use etalon_base::{error, phrase};
use std::io::Cursor;

/// First bytes of every file.
const MARK: &str = "ASTM-E57";

/// Scans of E57.
pub(super) struct E57;

impl ExportFormat for E57 {
    fn about(&self) -> About {
        About { name: "e57", title: "E57", binary: true, ..About::default() }
    }

    fn recognise(&self, text: &str) -> Option<Recognised> {
        let found = Recognised::by(text.starts_with(MARK), 1.0, phrase!("is-e57"))?;
        Some(Recognised { unit: Some("m"), ..found })
    }

    fn read(&self, text: &Text, _dialect: &Dialect, unit: Unit) -> (Vec<Point>, Problems) {
        let points = points(text, unit);
        let wrong = points.as_ref().err().cloned().map(|message| message.at(text.place(1)));
        (points.unwrap_or_default(), Problems(wrong.into_iter().collect()))
    }

    fn write(&self, _rows: &[ExportRow], _how: &Writing) -> Result<String, WriteError> {
        Err(WriteError::Unsupported(error!("format-not-simulated", kind = "e57")))
    }
}

/// Points of all scans.
fn points(text: &Text, unit: Unit) -> Result<Vec<Point>, Message> {
    let bytes = text.bytes().filter(|bytes| bytes.starts_with(MARK.as_bytes()));
    let bytes = bytes.ok_or_else(|| not_this_format("e57", &phrase!("begins-with", text = MARK)))?;
    unit_agrees(unit, Unit::Metre, &"E57", text.place(1))?;
    let unreadable = |e: Error| error!("cannot-read-file", file = text.file, reason = e.to_string());
    let mut reader = E57Reader::new(Cursor::new(bytes)).map_err(unreadable)?;
    let mut points = Vec::new();
    for (scan, cloud) in (1..).zip(reader.pointclouds()) {
        for (i, point) in (1..).zip(reader.pointcloud_simple(&cloud).map_err(unreadable)?) {
            let point = match point.map_err(unreadable)?.cartesian {
                CartesianCoordinate::Valid { x, y, z } if [x, y, z].iter().all(|v| v.is_finite()) => {
                    text.point(1, "", [x, y, z], unit)
                }
                _ => text.no_point(1, "", phrase!("row-without-coordinates")),
            };
            points.push(Point { text: format!("scan {scan}, point {i}").into(), ..point });
        }
    }
    match points.is_empty() {
        true => Err(error!("no-measured-points", contents = "none", records = "cartesianX")),
        false => Ok(points),
    }
}

#[cfg(test)]
mod tests {
    use crate::Format;
    use crate::dialect::Unit;
    use ::e57::{E57Writer, Record, RecordValue};
    use std::io::Cursor;

    /// Two points of one scan; one character for each byte.
    fn file() -> String {
        let mut bytes = Cursor::new(Vec::new());
        let mut writer = E57Writer::new(&mut bytes, "etalon").unwrap();
        let prototype = vec![Record::CARTESIAN_X_F64, Record::CARTESIAN_Y_F64, Record::CARTESIAN_Z_F64];
        let mut scan = writer.add_pointcloud("scan", prototype).unwrap();
        for xyz in [[1.25, -2.5, 0.0625], [0.5, 0.25, 3.0]] {
            scan.add_point(xyz.map(RecordValue::Double).to_vec()).unwrap();
        }
        scan.finalize().unwrap();
        writer.finalize().unwrap();
        drop(writer);
        bytes.into_inner().into_iter().map(char::from).collect()
    }

    #[test]
    fn points_of_a_scan_are_in_metres_and_damage_is_an_error() {
        let format = Format::named("e57").unwrap();
        let text = file();
        let (points, problems) = format.read("s.e57", &text.as_str().into(), Unit::Metre);
        assert!(problems.0.is_empty(), "{problems:?}");
        let xyz: Vec<[f64; 3]> = points.iter().map(|point| point.xyz_mm).collect();
        assert_eq!(xyz, [[1250.0, -2500.0, 62.5], [500.0, 250.0, 3000.0]]);
        let document = crate::propose("s.e57", &text);
        assert_eq!(document.format.as_deref(), Some("e57"), "{}", document.toml);
        assert!(document.toml.contains("unit = \"m\"                # the file states it"), "{}", document.toml);
        let (_, problems) = format.read("s.e57", &text.as_str().into(), Unit::Millimetre);
        assert!(problems.0[0].is("unit-differs", &[("of_file", &"m"), ("stated", &"mm")]), "{problems:?}");
        // a file cut at any length, or with any byte changed, is an error and no panic
        let characters: Vec<char> = text.chars().collect();
        for end in (8..characters.len()).step_by(7) {
            let cut: String = characters[..end].iter().collect();
            assert!(!format.read("s.e57", &cut.as_str().into(), Unit::Metre).1.0.is_empty(), "{end}");
        }
        for at in (8..characters.len()).step_by(5) {
            let mut changed = characters.clone();
            changed[at] = if changed[at] == 'a' { 'b' } else { 'a' };
            let changed: String = changed.into_iter().collect();
            let _ = format.read("s.e57", &changed.as_str().into(), Unit::Metre);
        }
    }
}
