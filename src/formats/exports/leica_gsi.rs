//! Leica GSI-8 and GSI-16: a line for each measurement, of words with an index of two digits, their
//! information and a value with its sign. Lines of GSI-16 begin with `*`.
//!
//! Words 81, 82 and 83 are east, north and height of the point; without them 21, 22 and 31 are the
//! horizontal direction (clockwise from north), the zenith angle and the slope distance. The sixth
//! character of a word is its unit. Source: Leica Geosystems, "GSI Online for TPS and DNA".

use super::{About, ExportFormat, ExportRow, Recognised, Text, WriteError, Writing, unit_agrees};
use crate::Point;
use crate::dialect::{Dialect, Unit};
use etalon_base::message::{Message, Problems};
use etalon_base::pose::{Vector, minus, norm};
use etalon_base::{error, phrase};
use std::collections::BTreeMap;
use std::f64::consts::PI;

/// Leica GSI.
pub(super) struct LeicaGsi;

/// Distance (mm) of two measurements of one point by which they are from two set-ups.
const OTHER_PLACE_MM: f64 = 1000.0;

impl ExportFormat for LeicaGsi {
    fn about(&self) -> About {
        About { name: "leica_gsi", title: "Leica GSI", ..About::default() }
    }

    fn recognise(&self, text: &str) -> Option<Recognised> {
        let mut lines = text.lines().filter(|line| !line.trim().is_empty()).take(20).peekable();
        let is_gsi = |line: &str| {
            let words: Vec<Option<Word>> = words(line).map(Word::parse).collect();
            !words.is_empty() && words.iter().all(Option::is_some)
        };
        let all = lines.peek().is_some() && lines.all(is_gsi);
        let found = Recognised::by(all, 0.95, phrase!("is-leica-gsi"))?;
        Some(Recognised { unit: Some("m"), ..found })
    }

    fn read(&self, text: &Text, _dialect: &Dialect, unit: Unit) -> (Vec<Point>, Problems) {
        let (mut points, mut problems) = (Vec::new(), Problems::default());
        let mut set_ups = SetUps::default();
        for (i, line) in text.lines.iter().enumerate().filter(|(_, line)| !line.trim().is_empty()) {
            match row(text, i + 1, line) {
                Ok((kind, point)) => {
                    let again = set_ups.again(kind, i + 1, &point);
                    problems.0.extend(again.map(|line| error!("stations-several", line).at(text.place(line))));
                    points.push(point);
                }
                Err(message) => problems.0.push(message),
            }
        }
        if let Some(first) = points.first() {
            let agrees = unit_agrees(unit, Unit::Metre, &"GSI", text.place(first.line as usize));
            problems.0.extend(agrees.err());
        }
        (points, problems)
    }

    /// Lines of GSI-16 with a resolution of 0.01 mm.
    fn write(&self, rows: &[ExportRow], how: &Writing) -> Result<String, WriteError> {
        how.unit_in(&[(Unit::Metre, "m")])?;
        let word = |(index, value): (usize, &f64)| {
            let digits = (value.abs() * 1e5).round();
            format!("{index}..08{}{digits:016.0}", if *value < 0.0 { '-' } else { '+' })
        };
        let line = |(i, row): (usize, &ExportRow)| {
            if row.label.len() > 16 || row.label.contains(char::is_whitespace) {
                return Err(error!("record-invalid", text = row.label, format = "leica_gsi", valid = "K_1_1").into());
            }
            let values = [81, 82, 83].into_iter().zip(&row.xyz).map(word).collect::<Vec<String>>().join(" ");
            Ok(format!("*11{:04}+{:0>16} {values} \n", (i + 1) % 10_000, row.label))
        };
        rows.iter().enumerate().map(line).collect()
    }
}

/// A word of a line.
#[derive(Clone, Copy)]
struct Word<'a> {
    index: u8,
    /// Sixth character: the unit.
    unit: u8,
    negative: bool,
    value: &'a str,
}

impl<'a> Word<'a> {
    /// Splits a word of two digits, four characters, a sign, and 8 or 16 characters.
    fn parse(word: &'a str) -> Option<Self> {
        let bytes = word.as_bytes();
        let whole = word.is_ascii() && matches!(bytes.len(), 15 | 23) && matches!(bytes[6], b'+' | b'-');
        let index = word.get(..2)?.parse().ok()?;
        let info = bytes.get(2..6)?.iter().all(|b| b.is_ascii_digit() || matches!(b, b'.' | b'+'));
        (whole && info).then(|| Self { index, unit: bytes[5], negative: bytes[6] == b'-', value: &word[7..] })
    }

    /// `true` for dashes in place of a value: not measured.
    fn is_missing(self) -> bool {
        let value = self.value.trim_start_matches('0');
        !value.is_empty() && value.bytes().all(|b| b == b'-')
    }

    fn signed(self, of_digit: f64) -> Option<f64> {
        let digits: u64 = self.value.parse().ok()?;
        let value = digits as f64 / of_digit;
        Some(if self.negative { -value } else { value })
    }

    /// Length (m); `None` for feet.
    fn length_m(self) -> Option<f64> {
        match self.unit {
            b'0' => self.signed(1e3),
            b'6' => self.signed(1e4),
            b'8' => self.signed(1e5),
            _ => None,
        }
    }

    /// Angle (rad): gon, decimal degrees, sexagesimal degrees, or mils.
    fn angle_rad(self) -> Option<f64> {
        let turn = match self.unit {
            b'2' => self.signed(1e5)? / 400.0,
            b'3' => self.signed(1e5)? / 360.0,
            b'4' => {
                let digits: u64 = self.value.parse().ok()?;
                let (degrees, minutes, seconds) = (digits / 100_000, digits / 1000 % 100, digits % 1000);
                (degrees as f64 + minutes as f64 / 60.0 + seconds as f64 / 36_000.0) / 360.0
            }
            b'5' => self.signed(1e4)? / 6400.0,
            _ => return None,
        };
        Some(2.0 * PI * turn)
    }
}

/// Words of a line.
fn words(line: &str) -> impl Iterator<Item = &str> {
    line.trim().trim_start_matches('*').split_whitespace()
}

/// Kind of a line.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// Coordinates of the instrument.
    Station,
    /// A code of the user, which may name a set-up.
    Code,
    /// Coordinates of a point, or none.
    Point,
    /// Directions and distance of a point from the instrument.
    Polar,
}

/// Set-ups of the instrument; each has directions of its own.
#[derive(Default)]
struct SetUps {
    stations: usize,
    /// Line of a further set-up: coordinates of the instrument, or a code.
    further: Option<usize>,
    code: Option<usize>,
    places: BTreeMap<String, Vector>,
    is_reported: bool,
}

impl SetUps {
    /// Returns the line of a second set-up, once, at the first directions from it: behind the
    /// coordinates of the instrument, or behind a code if a point has moved.
    fn again(&mut self, kind: Kind, line: usize, point: &Point) -> Option<usize> {
        match kind {
            Kind::Station => {
                self.further = self.further.or((self.stations > 0).then_some(line));
                self.stations += 1;
            }
            Kind::Code => self.code = Some(line),
            Kind::Polar => {
                let place = self.places.entry(point.label.to_string()).or_insert(point.xyz_mm);
                let is_moved = norm(minus(*place, point.xyz_mm)) > OTHER_PLACE_MM;
                let found = self.further.or(self.code.filter(|_| is_moved)).filter(|_| !self.is_reported);
                self.is_reported |= found.is_some();
                return found;
            }
            Kind::Point => {}
        }
        None
    }
}

/// Kind of a line, and its point.
fn row(text: &Text, line: usize, content: &str) -> Result<(Kind, Point), Message> {
    let mut all: Vec<Word> = Vec::new();
    for word in words(content) {
        let invalid = || error!("record-invalid", text = word, format = "leica_gsi", valid = "81..00+00001234");
        all.push(Word::parse(word).ok_or_else(|| invalid().at(text.place(line)))?);
    }
    let word = |index: u8| all.iter().find(|word| word.index == index);
    let value = |index: u8, read: fn(Word) -> Option<f64>| -> Result<Option<f64>, Message> {
        let Some(word) = word(index).filter(|word| !word.is_missing()) else { return Ok(None) };
        let invalid = || match (word.unit, index) {
            (b'1' | b'7', 31 | 81..=83) => error!("gsi-feet"),
            _ => error!("record-invalid", text = word.value, format = "leica_gsi", valid = "81..00+00001234"),
        };
        read(*word).map(Some).ok_or_else(|| invalid().at(text.place(line)))
    };
    let label = word(11).map_or("", |word| word.value.trim_start_matches('0'));
    let label = if label.is_empty() && word(11).is_some() { "0" } else { label };
    let axes = [81, 82, 83].map(|index| value(index, |word| word.length_m()));
    if let [Ok(Some(x)), Ok(Some(y)), Ok(Some(z))] = axes {
        return Ok((Kind::Point, text.point(line, label, [x, y, z], Unit::Metre)));
    }
    axes.into_iter().collect::<Result<Vec<_>, _>>()?;
    let direction = value(21, |word| word.angle_rad())?.zip(value(22, |word| word.angle_rad())?);
    match direction.zip(value(31, |word| word.length_m())?) {
        Some(((horizontal, zenith), distance)) => {
            Ok((Kind::Polar, text.point(line, label, placed(horizontal, zenith, distance), Unit::Metre)))
        }
        None => {
            let is_station = word(84).is_some() && word(85).is_some();
            let kind = match () {
                () if is_station => Kind::Station,
                () if word(41).is_some() => Kind::Code,
                () => Kind::Point,
            };
            Ok((kind, text.no_point(line, label, phrase!("row-without-coordinates"))))
        }
    }
}

/// Position of a horizontal direction from north, a zenith angle and a distance: east, north,
/// height.
fn placed(horizontal: f64, zenith: f64, distance: f64) -> Vector {
    let flat = distance * zenith.sin();
    [flat * horizontal.sin(), flat * horizontal.cos(), distance * zenith.cos()]
}

#[cfg(test)]
mod tests {
    use crate::Format;
    use crate::dialect::Unit;

    #[test]
    fn words_of_both_lengths_are_coordinates_or_angles_and_a_distance() {
        let format = Format::named("leica_gsi").unwrap();
        let read = |text: &str| format.read("s.gsi", &text.into(), Unit::Metre);
        let text = "110001+00000012 81..00+00001234 82..00-00005736 83..06+00000915 \n\
            *110002+00000000000000K7 81..08+0000000000123456 82..08-0000000000573600 83..08+0000000000009150\n\
            110003+00000013 41....+00000001\n";
        let (points, problems) = read(text);
        assert!(problems.0.is_empty(), "{problems:?}");
        let near = |at: usize, xyz: [f64; 3]| (0..3).all(|k| (points[at].xyz_mm[k] - xyz[k]).abs() < 1e-9);
        assert!(&*points[0].label == "12" && near(0, [1234.0, -5736.0, 91.5]), "{points:?}");
        assert!(&*points[1].label == "K7" && near(1, [1234.56, -5736.0, 91.5]), "{points:?}");
        assert!(points[2].refused.is_some());
        // 100 gon is east; 150 gon from the zenith is 45° below the horizon
        let (points, _) = read("110001+00000001 21.102+10000000 22.102+15000000 31..00+00002000\n");
        let half = 2000.0 * 0.5f64.sqrt();
        assert!((0..3).all(|k| (points[0].xyz_mm[k] - [half, 0.0, -half][k]).abs() < 1e-9), "{points:?}");
        let (_, problems) = format.read("s.gsi", &text.into(), Unit::Millimetre);
        assert!(problems.0[0].is("unit-differs", &[("of_file", &"m"), ("stated", &"mm")]), "{problems:?}");
        // dashes are no value
        let text = "*110004+0000000000009003 81..10+0000000698434705 82..10+0000000173455362 83..10+00000000000-----\n";
        let (points, problems) = read(text);
        assert!(problems.0.is_empty() && points[0].refused.is_some(), "{problems:?}");
        // directions after a second set-up are in another frame
        let polar = "110002+00000001 21.102+10000000 22.102+15000000 31..00+00002000\n";
        let station = "110003+00000ST1 84..40+00519659 85..40+00465244 86..40-00000588\n";
        let (points, problems) = read(&format!("{station}{polar}"));
        assert!(problems.0.is_empty() && points.len() == 2, "{problems:?}");
        let (_, problems) = read(&format!("{station}{polar}{station}{polar}"));
        assert!(problems.0.len() == 1 && problems.0[0].is("stations-several", &[("line", &3)]), "{problems:?}");
        // a code alone is no set-up, unless a point is at another place behind it
        let code = "410003+00000021 42....+0000BP04\n";
        assert!(read(&format!("{polar}{code}{polar}")).1.0.is_empty());
        let other = "110004+00000001 21.102+30000000 22.102+10000000 31..00+00009000\n";
        let (_, problems) = read(&format!("{polar}{code}{other}{other}"));
        assert!(problems.0.len() == 1 && problems.0[0].is("stations-several", &[("line", &2)]), "{problems:?}");
        // feet are not said to be international or of the US survey
        assert!(read("110001+00000001 81..01+00001234 82..01+00001 83..01+0").1.0[0].is("record-invalid", &[]));
        let feet = "110001+00000001 81..07+00001234 82..07+00001234 83..07+00001234\n";
        assert!(read(feet).1.0[0].is("gsi-feet", &[]));
        let document = crate::propose("s.gsi", &feet.replace("..07", "..00"));
        assert_eq!(document.format.as_deref(), Some("leica_gsi"), "{}", document.toml);
        assert!(document.toml.contains("unit = \"m\""), "{}", document.toml);
        // without a point there is nothing to read
        assert!(!crate::propose("s.gsi", text).toml.contains("[[export]]"));
    }
}
