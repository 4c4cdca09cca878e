//! Exports: texts whose coordinates are known, and every format written and read again.

use super::data::{Data, Slip};
use super::row::{Rows, Subject, not_made};
use etalon_base::phrase;
use etalon_base::pose::Vector;
use etalon_formats::dialect::Unit;
use etalon_formats::exports::{ExportRow, WriteError};
use etalon_formats::{Format, rows as read_rows};

pub(super) const SUBJECT: Subject = Subject {
    id: "formats",
    requirement: || phrase!("selftest-formats"),
    rows,
    slips: &[
        Slip::Digit("/published/formats/0/expected_mm/1", 7),
        Slip::Swap("/published/formats/2/expected_mm/0", "/published/formats/2/expected_mm/1"),
        Slip::Unit("/published/formats/1/expected_mm", 1.0 / 25.4),
    ],
};

/// Coordinates (mm) to write.
const POINTS_MM: [Vector; 4] =
    [[0.0625, -12.5, 1000.125], [357.15901, 493.95605, -138.80533], [-0.00125, 25.4, 63.5], [1234.5, -0.5, 7.25]];
/// Digits behind the decimal mark, and the rounding of the last one (mm) in inches.
const DECIMALS: usize = 7;
const ROUNDING: f64 = 25.4 * 0.5e-7 * 1.01;

fn rows(data: &Data) -> Vec<Rows> {
    let mut known = Rows::new("SI, 1 inch = 25.4 mm");
    for item in data.at("/published/formats").items() {
        let (name, unit) = (item.text("/format"), item.text("/unit"));
        let found = read(name, unit, item.text("/text"));
        let found: Vec<f64> = found.into_iter().flatten().flatten().collect();
        known.add_all(phrase!("selftest-read", name, unit), "mm", [&item.numbers("/expected_mm"), &found], 1e-9);
    }
    let mut again = Rows::new("round trip");
    for name in Format::names() {
        for unit in [Unit::Millimetre, Unit::Inch] {
            written(name, unit, &mut again);
        }
    }
    vec![known, again]
}

/// Coordinates of a text in a format.
fn read(name: &str, unit: &str, text: &str) -> Option<Vec<Vector>> {
    let (format, unit) = (Format::named(name)?, Unit::named(unit)?);
    let (points, problems) = read_rows(&format, name, &text.into(), unit);
    problems.0.is_empty().then(|| points.iter().map(|p| p.xyz_mm).collect())
}

/// Writes points and reads them; formats that etalon does not write, or that cannot have the unit,
/// are omitted.
fn written(name: &str, unit: Unit, rows: &mut Rows) {
    let Some(format) = Format::named(name) else { return };
    let row = |(i, p): (usize, &Vector)| ExportRow {
        label: format!("ball_{}", i + 1),
        target: "ball".to_owned(),
        pose: (i as i64 + 1).into(),
        cycle: 1,
        time_s: i as f64,
        xyz: p.map(|v| v / unit.in_mm()),
    };
    let all: Vec<ExportRow> = POINTS_MM.iter().enumerate().map(row).collect();
    // four halves are a unit quaternion
    let not_read = vec!["0.5".to_owned(); 24];
    let text = match format.write(&all, unit, DECIMALS, &not_read) {
        Ok(text) => text,
        Err(WriteError::Unsupported(_)) => return,
        Err(WriteError::Row(message)) => return rows.failed(not_made(name, &message)),
    };
    // a file whose headings give another unit is rejected, as it must be
    if format.heading_unit().is_some_and(|stated| stated != unit) {
        return;
    }
    let (points, problems) = read_rows(&format, name, &text.as_str().into(), unit);
    if !problems.0.is_empty() {
        return rows.failed(not_made(name, &problems));
    }
    let expected: Vec<f64> = POINTS_MM.into_iter().flatten().collect();
    let found: Vec<f64> = points.iter().flat_map(|p| p.xyz_mm).collect();
    rows.add_all(phrase!("selftest-written-read", name, unit = unit.name()), "mm", [&expected, &found], ROUNDING);
}
