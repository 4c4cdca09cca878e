//! Mitutoyo GEOPAK-Win scanning, `.gws`: records `#nn:` anywhere on a line.
//!
//! `#02:` name of the contour, `#04:` plane, `#05:` open or closed, `#06:` unit, `#03:` a point,
//! `#12:` a point with its probing direction. The plane gives the order of the coordinates: `YZ(X)`
//! has Y, Z, X. Heads are optional: without them the plane is XY(Z) and the unit MM. Source: format
//! sheet of R. Boesch, Mitutoyo, 1999.

use super::{About, ExportFormat, ExportRow, Recognised, Text, WriteError, Writing, not_this_format, unit_agrees};
use crate::Point;
use crate::dialect::{Dialect, Unit};
use etalon_base::message::{Message, Place, Problems};
use etalon_base::pose::Vector;
use etalon_base::{error, phrase};
use etalon_tables::Decimal;
use etalon_tables::lexer::number;

/// Scans of GEOPAK-Win.
pub(super) struct GeopakGws;

impl ExportFormat for GeopakGws {
    fn about(&self) -> About {
        About { name: "geopak_gws", title: "GEOPAK-Win scanning", ..About::default() }
    }

    fn recognise(&self, text: &str) -> Option<Recognised> {
        Recognised::by(text.starts_with("#00:GEOPAK"), 1.0, phrase!("is-geopak-scan"))
    }

    fn read(&self, text: &Text, _dialect: &Dialect, unit: Unit) -> (Vec<Point>, Problems) {
        rows(text, unit)
    }

    fn write(&self, rows: &[ExportRow], how: &Writing) -> Result<String, WriteError> {
        let length = how.unit_in(&[(Unit::Millimetre, "MM"), (Unit::Inch, "Inch")])?;
        let point = |row: &ExportRow| format!("#02:{}\n#03: {}\n", row.label, how.list(row, " "));
        let points: String = rows.iter().map(point).collect();
        Ok(format!("#00:GEOPAK-WIN Scanning\n#04:XY(Z)\n#05:Opn\n#06:{length}\n{points}"))
    }
}

/// Planes of contours in Cartesian coordinates.
const PLANES: [&str; 3] = ["XY(Z)", "YZ(X)", "ZX(Y)"];

/// Text between one `#nn:` and the next.
struct Record<'a> {
    code: &'a str,
    content: &'a str,
    line: usize,
    place: Place,
}

/// The points of all contours.
fn rows(text: &Text, unit: Unit) -> (Vec<Point>, Problems) {
    let mut problems = Problems::default();
    let mut points = Vec::new();
    let (mut label, mut order, mut unit_stated) = ("", [0, 1, 2], false);
    for record in records(text, &mut problems) {
        let content = record.content.trim();
        let mut wrong = |message: Message| problems.0.push(message.at(record.place.clone()));
        match record.code {
            "00" | "05" => {}
            "02" => label = content,
            "04" => match content {
                "XY(Z)" => order = [0, 1, 2],
                "YZ(X)" => order = [1, 2, 0],
                "ZX(Y)" => order = [2, 0, 1],
                "RZ(P)" | "PZ(R)" => {
                    wrong(error!("coordinates-not-cartesian", found = content, cartesian = PLANES));
                }
                _ => wrong(error!("record-invalid", text = content, format = "geopak_gws", valid = PLANES)),
            },
            "06" => {
                unit_stated = true;
                let of_file = match content {
                    "MM" => Ok(Unit::Millimetre),
                    "Inch" => Ok(Unit::Inch),
                    _ => Err(error!("unit-unknown", unit = content, units = ["MM", "Inch"])),
                };
                let agrees = of_file.and_then(|of_file| unit_agrees(unit, of_file, &"#06", record.place.clone()));
                agrees.err().into_iter().for_each(&mut wrong);
            }
            code @ ("03" | "12") => {
                let count = if code == "03" { 3 } else { 6 };
                let read: Vec<Result<f64, Message>> =
                    content.split_whitespace().map(|n| number(n, Decimal::Point)).collect();
                if read.len() != count {
                    wrong(error!(
                        "number-count-differs",
                        name = format!("#{code}:"),
                        found = read.len(),
                        counts = [count]
                    ));
                    continue;
                }
                let mut xyz: Vector = [f64::NAN; 3];
                let whole = read.iter().all(Result::is_ok);
                for (i, value) in read.into_iter().enumerate() {
                    match value {
                        Ok(value) if i < 3 && whole => xyz[order[i]] = value,
                        Ok(_) => {}
                        Err(message) => wrong(message),
                    }
                }
                points.push(text.point(record.line, label, xyz, unit));
            }
            code => {
                let valid = ["#00:", "#02:", "#03:", "#04:", "#05:", "#06:", "#12:"];
                wrong(error!("record-invalid", text = format!("#{code}:"), format = "geopak_gws", valid));
            }
        }
    }
    if !unit_stated && !points.is_empty() {
        // the default of the format
        let how = phrase!("default-of-format", record = "#06");
        let agrees = unit_agrees(unit, Unit::Millimetre, &how, text.place(1));
        problems.0.extend(agrees.err());
    }
    (points, problems)
}

/// The records in their order; text before the first is an error.
fn records<'a>(text: &Text<'a>, problems: &mut Problems) -> Vec<Record<'a>> {
    let whole = text.whole;
    let bytes = whole.as_bytes();
    let is_code = |i: usize| match bytes.get(i..i + 4) {
        Some([b'#', tens, ones, b':']) => tens.is_ascii_digit() && ones.is_ascii_digit(),
        _ => false,
    };
    let starts: Vec<usize> = whole.match_indices('#').map(|(i, _)| i).filter(|&i| is_code(i)).collect();
    if !whole[..starts.first().copied().unwrap_or(whole.len())].trim().is_empty() {
        let signature = phrase!("records-like", example = "#03: 1.0 2.0 3.0");
        problems.0.push(not_this_format("geopak_gws", &signature).at(text.place(1)));
        return Vec::new();
    }
    let mut lines = vec![0];
    lines.extend(whole.match_indices('\n').map(|(i, _)| i + 1));
    let record = |(k, &start): (usize, &usize)| {
        let end = starts.get(k + 1).copied().unwrap_or(whole.len());
        let line = lines.partition_point(|from| *from <= start);
        let from = lines.get(line.saturating_sub(1)).copied().unwrap_or(0);
        let content = &whole[start + 4..end];
        let width = 4 + content.trim_end().chars().count();
        Record { code: &whole[start + 1..start + 3], content, line, place: text.part(line, start - from, width) }
    };
    starts.iter().enumerate().map(record).collect()
}
