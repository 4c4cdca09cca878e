//! DMIS output (ISO 22093): measured features `FA(label) = FEAT/kind, ...`; sizes are diameters.
//!
//! The dialect of Mitutoyo GEOPAK writes the three angles (deg) of a direction instead of a unit
//! vector. Their cosines are the vector, so that a file shows its notation; the campaign must give
//! the same notation.

use super::{About, ExportFormat, ExportRow, Recognised, Text, WriteError, Writing, unit_agrees};
use crate::Point;
use crate::dialect::{Dialect, Unit};
use etalon_base::catalogue::IntoArgument;
use etalon_base::message::{Message, Place, Problems, Result};
use etalon_base::pose::{Vector, norm};
use etalon_base::{error, phrase};
use etalon_tables::Decimal;
use etalon_tables::lexer::number;

/// DMIS output, by its notation of directions.
pub(super) struct Dmis {
    name: &'static str,
    title: &'static str,
    directions: DirectionNotation,
}

/// Unit vectors, as in ISO 22093.
pub(super) const DMIS: Dmis = Dmis { name: "dmis", title: "DMIS output", directions: DirectionNotation::Vectors };

/// The dialect of Mitutoyo GEOPAK.
pub(super) const GEOPAK: Dmis = Dmis {
    name: "geopak_dmis",
    title: "DMIS output of GEOPAK (direction angles)",
    directions: DirectionNotation::Angles,
};

impl ExportFormat for Dmis {
    fn about(&self) -> About {
        About { name: self.name, title: self.title, ..About::default() }
    }

    fn recognise(&self, text: &str) -> Option<Recognised> {
        // GEOPAK writes the same records
        Recognised::by(
            self.directions == DirectionNotation::Vectors && text.starts_with("FILNAM/"),
            1.0,
            phrase!("is-dmis"),
        )
    }

    fn read(&self, text: &Text, _dialect: &Dialect, unit: Unit) -> (Vec<Point>, Problems) {
        rows(text, self.directions, unit)
    }

    fn write(&self, rows: &[ExportRow], how: &Writing) -> std::result::Result<String, WriteError> {
        let length = how.unit_in(&[(Unit::Millimetre, "MM"), (Unit::Metre, "M"), (Unit::Inch, "INCH")])?;
        // upwards
        let direction = if self.directions == DirectionNotation::Vectors { "0, 0, 1" } else { "90, 90, 0" };
        let feature = |row: &ExportRow| {
            format!("FA({}) = FEAT/POINT, CART, $\n  {}, {direction}\n", row.label, how.list(row, ", "))
        };
        let features: String = rows.iter().map(feature).collect();
        Ok(format!("FILNAM/'simulated'\nUNITS/{length}, ANGDEC\n{features}ENDFIL\n"))
    }
}

/// Notation of directions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DirectionNotation {
    /// Unit vectors, as ISO 22093 has them.
    Vectors,
    /// Angles to the axes in degrees, as written by GEOPAK.
    Angles,
}

/// A measured feature.
#[derive(Clone, Debug, PartialEq)]
pub struct DmisFeature {
    /// First line of its record.
    pub line: usize,
    /// Its label.
    pub label: String,
    /// `POINT`, `CIRCLE`, `PLANE` ...
    pub kind: String,
    /// Position (mm): a point, or the centre of a round feature.
    pub point_mm: Vector,
    /// Its direction, if it has one.
    pub direction: Option<Vector>,
    /// Diameter of a circle, sphere or cylinder in millimetres.
    pub diameter_mm: Option<f64>,
}

/// Meaning of the numbers of a kind of feature.
struct Kind {
    name: &'static str,
    /// Possible numbers of numbers.
    counts: &'static [usize],
    /// A direction follows the point.
    directed: bool,
    /// Index of the diameter.
    diameter: Option<usize>,
    /// `true` if the point is the position of the feature.
    located: bool,
}

impl Kind {
    const fn new(name: &'static str, counts: &'static [usize], diameter: Option<usize>, located: bool) -> Self {
        Self { name, counts, directed: !matches!(diameter, Some(3)), diameter, located }
    }
}

const KINDS: [Kind; 8] = [
    Kind::new("POINT", &[3, 6], None, true),
    Kind::new("EDGEPT", &[3, 6, 9], None, true),
    Kind::new("CIRCLE", &[7], Some(6), true),
    Kind::new("SPHERE", &[4, 7], Some(3), true),
    Kind::new("PLANE", &[6], None, false),
    Kind::new("LINE", &[6, 9], None, false),
    Kind::new("CYLNDR", &[7, 8], Some(6), false),
    Kind::new("CONE", &[7], None, false),
];

/// The measured features of a file; `unit` is the default of files without a unit.
pub fn features(file: &str, text: &str, directions: DirectionNotation, unit: Unit) -> Result<Vec<DmisFeature>> {
    let text = text.into();
    let (features, _, problems) = read(&Text::new(file, &text, false), directions, unit);
    problems.check().map(|_| features)
}

/// A row for each measured feature; a feature whose point is arbitrary is not a point.
fn rows(text: &Text, directions: DirectionNotation, unit: Unit) -> (Vec<Point>, Problems) {
    let (features, unknown, mut problems) = read(text, directions, unit);
    let row = |feature: &DmisFeature| {
        if KINDS.iter().any(|kind| kind.name == feature.kind && kind.located) {
            return text.point(feature.line, &feature.label, feature.point_mm, Unit::Millimetre);
        }
        let reason = phrase!("feature-of-no-point", kind = feature.kind);
        text.no_point(feature.line, &feature.label, reason)
    };
    let mut points: Vec<Point> = features.iter().map(row).chain(unknown).collect();
    points.sort_by_key(|point| point.line);
    if points.is_empty() && problems.0.is_empty() {
        let program = text.lines.iter().find(|line| line.trim_start().to_uppercase().starts_with("MEAS/"));
        let contents = match program {
            Some(_) => phrase!("measuring-program").argument(),
            None => "none".argument(),
        };
        let message = error!("no-measured-points", contents, records = "FA(label) = FEAT/kind, ...");
        problems.0.push(message.hint(phrase!("output-of-program")).at(text.place(1)));
    }
    (points, problems)
}

fn read(text: &Text, directions: DirectionNotation, unit: Unit) -> (Vec<DmisFeature>, Vec<Point>, Problems) {
    let (mut features, mut unknown, mut problems) = (Vec::new(), Vec::new(), Problems::default());
    for record in records(text) {
        let (label, major, fields) = record.parts();
        match (major.to_ascii_uppercase().as_str(), label, &fields[..]) {
            ("UNITS", _, [length, ..]) => problems.0.extend(units(&record, length, unit).err()),
            ("FEAT", Some(label), [kind, rest @ ..]) => {
                let Some(name) = actual(label.text) else { continue };
                let kind = kind.text.to_ascii_uppercase();
                match KINDS.iter().find(|known| known.name == kind) {
                    Some(known) => match feature(&record, known, rest, directions, unit) {
                        Ok(found) => features.push(DmisFeature { label: name.to_owned(), ..found }),
                        Err(more) => problems.0.extend(more.0),
                    },
                    None => unknown.push(text.no_point(record.line(), name, phrase!("feature-not-read", kind))),
                }
            }
            _ => {}
        }
    }
    (features, unknown, problems)
}

/// The label of an actual: `FA(label)`.
fn actual(label: &str) -> Option<&str> {
    let (kind, name) = label.split_once('(')?;
    kind.trim().eq_ignore_ascii_case("FA").then(|| name.strip_suffix(')'))?
}

/// Returns an error if the unit of the file differs from the unit of the campaign.
fn units(record: &Record, length: &Part, stated: Unit) -> std::result::Result<(), Message> {
    let place = record.place(length);
    let of_file = match length.text.to_ascii_uppercase().as_str() {
        "MM" => Unit::Millimetre,
        "M" => Unit::Metre,
        "INCH" => Unit::Inch,
        other => {
            return Err(error!("unit-unknown", unit = other, units = ["MM", "M", "INCH"]).at(place));
        }
    };
    unit_agrees(stated, of_file, &"UNITS", place)
}

/// A feature from the fields after its kind, without its label.
fn feature(
    record: &Record,
    kind: &Kind,
    fields: &[Part],
    directions: DirectionNotation,
    unit: Unit,
) -> Result<DmisFeature> {
    let is_word = |part: &&Part| part.text.starts_with(|c: char| c.is_ascii_alphabetic());
    let words: Vec<&Part> = fields.iter().take_while(is_word).collect();
    if let Some(word) = words.iter().find(|word| word.text.eq_ignore_ascii_case("POL")) {
        let message = error!("coordinates-not-cartesian", found = word.text, cartesian = "CART");
        return Err(message.at(record.place(word)).into());
    }
    let mut problems = Problems::default();
    let mut numbers = Vec::new();
    for part in &fields[words.len()..] {
        match number(part.text, Decimal::Point) {
            Ok(value) => numbers.push(value),
            Err(message) => problems.0.push(message.at(record.place(part))),
        }
    }
    problems.check()?;
    if !kind.counts.contains(&numbers.len()) {
        let message = error!("number-count-differs", name = kind.name, found = numbers.len(), counts = kind.counts);
        return Err(message.hint(phrase!("dmis-continuation")).at(record.start()).into());
    }
    let written = [3, 4, 5].map(|i| numbers.get(i).copied().unwrap_or(0.0));
    let direction = match kind.directed {
        true => direction(written, directions).map_err(|message| {
            let at = fields.get(words.len() + 3);
            message.at(at.map_or_else(|| record.start(), |part| record.place(part)))
        })?,
        false => None,
    };
    Ok(DmisFeature {
        line: record.line(),
        label: String::new(),
        kind: kind.name.to_owned(),
        point_mm: [numbers[0], numbers[1], numbers[2]].map(|v| v * unit.in_mm()),
        direction,
        diameter_mm: kind.diameter.and_then(|i| numbers.get(i)).map(|d| d * unit.in_mm()),
    })
}

/// Direction in the given notation; `None` for three zeros.
fn direction(written: Vector, directions: DirectionNotation) -> std::result::Result<Option<Vector>, Message> {
    if written == [0.0; 3] {
        return Ok(None);
    }
    let cosines = written.map(|angle| angle.to_radians().cos());
    // a unit vector as angles would be three cosines near 1; no three numbers are both
    let (vector, angles) = ((norm(written) - 1.0).abs() < 0.01, (norm(cosines) - 1.0).abs() < 0.01);
    match (directions, vector, angles) {
        (DirectionNotation::Vectors, true, _) => Ok(Some(written)),
        (DirectionNotation::Angles, false, true) => Ok(Some(cosines)),
        (DirectionNotation::Vectors, false, true) => {
            Err(error!("direction-notation-differs", found = "angles", format = "geopak_dmis"))
        }
        (DirectionNotation::Angles, true, _) => {
            Err(error!("direction-notation-differs", found = "vector", format = "dmis"))
        }
        _ => {
            let [i, j, k] = written;
            Err(error!("direction-not-unit", i, j, k, length = norm(written)))
        }
    }
}

/// A record: `label = MAJOR/field, field, ...`.
struct Record<'t> {
    file: &'t Text<'t>,
    text: String,
    /// Places of its pieces: byte of the record, line, byte of the line.
    pieces: Vec<(usize, usize, usize)>,
}

/// A part of a record, with the byte at which it begins.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Part<'a> {
    text: &'a str,
    at: usize,
}

impl Part<'_> {
    fn trimmed(text: &str, at: usize) -> Part<'_> {
        Part { text: text.trim(), at: at + text.len() - text.trim_start().len() }
    }
}

/// All records of a file.
fn records<'t>(file: &'t Text<'t>) -> Vec<Record<'t>> {
    let mut all = Vec::new();
    let empty = || Record { file, text: String::new(), pieces: Vec::new() };
    let mut open = empty();
    for (i, line) in file.lines.iter().enumerate() {
        if line.trim_start().starts_with("$$") {
            continue;
        }
        let end = line.trim_end();
        let goes_on = end.strip_suffix('$');
        open.pieces.push((open.text.len(), i + 1, 0));
        open.text.push_str(goes_on.unwrap_or(end));
        if goes_on.is_none() {
            all.extend(Some(std::mem::replace(&mut open, empty())).filter(|record| !record.text.trim().is_empty()));
        }
    }
    all.extend(Some(open).filter(|record| !record.text.trim().is_empty()));
    all
}

impl Record<'_> {
    /// First line of the record.
    fn line(&self) -> usize {
        self.pieces.first().map_or(1, |piece| piece.1)
    }

    /// Label (the text before `=`), major word and fields.
    fn parts(&self) -> (Option<Part<'_>>, &str, Vec<Part<'_>>) {
        let slash = self.text.find('/').unwrap_or(self.text.len());
        let (head, tail) = self.text.split_at(slash);
        let (label, major) = match head.split_once('=') {
            Some((label, major)) => (Some(Part::trimmed(label, 0)), major),
            None => (None, head),
        };
        let fields = tail.strip_prefix('/').map_or(Vec::new(), |fields| split(fields, slash + 1));
        (label, major.trim(), fields)
    }

    /// Place of the beginning of the record.
    fn start(&self) -> Place {
        self.file.place(self.line())
    }

    /// Place of a part.
    fn place(&self, part: &Part) -> Place {
        let before = self.pieces.partition_point(|piece| piece.0 <= part.at);
        let (start, line, byte) = self.pieces.get(before.saturating_sub(1)).copied().unwrap_or((0, 1, 0));
        self.file.part(line, byte + part.at - start.min(part.at), part.text.chars().count())
    }
}

/// Fields between commas outside quotes.
fn split(text: &str, at: usize) -> Vec<Part<'_>> {
    let (mut fields, mut start, mut quoted) = (Vec::new(), 0, false);
    for (i, c) in text.char_indices() {
        match c {
            '\'' => quoted = !quoted,
            ',' if !quoted => {
                fields.push(Part::trimmed(&text[start..i], at + start));
                start = i + 1;
            }
            _ => {}
        }
    }
    fields.push(Part::trimmed(&text[start..], at + start));
    fields
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn records_continue_over_lines_and_know_the_places_of_their_fields() {
        let lines = vec!["$$ FA(X)=1/2 $", "FA(A 1) = FEAT/CIRCLE, 'a,b', $", "  50.5,$", "-1", "", "ENDFIL"];
        let text = Text { file: "f", whole: &"".into(), lines };
        let all = records(&text);
        assert_eq!(all.len(), 2);
        let (label, major, fields) = all[0].parts();
        assert_eq!((label.map(|l| l.text), major), (Some("FA(A 1)"), "FEAT"));
        assert_eq!(fields.iter().map(|f| f.text).collect::<Vec<_>>(), ["CIRCLE", "'a,b'", "50.5", "-1"]);
        let place = all[0].place(&fields[2]);
        assert_eq!((place.line, place.column, place.width), (Some(3), Some(3), 4));
        assert_eq!(all[1].parts().1, "ENDFIL");
    }
}
