//! Formats of exports, one file each: name, signature, reader and writer.
//!
//! A file that gives its unit must give the unit of the campaign; a file without a unit is read
//! in the unit of the campaign.

mod abb_rapid;
mod aqdef;
mod c3d;
mod calypso;
pub(crate) mod delimited;
pub mod dmis;
mod e57;
mod fanuc_ls;
mod geopak_gws;
mod inspec;
mod leica_at960;
mod leica_emscon;
mod leica_gsi;
mod pcd;
mod pcdmis_report;
mod pcdmis_xyz;
mod pivot;
mod ply;
mod polyworks;
mod polyworks_project;
pub mod polyworks_report;
mod ptx;
pub mod qif;
mod sdss_plate;
mod spatialanalyzer;
mod stamps;
pub(crate) mod stl;
mod vda_fs;

pub(crate) use stamps::seconds as stamp_seconds;

use super::points::{Line, Point, SharedText, Stated, has_frame_on_points};
use crate::dialect::{Columns, Dialect, Unit};
use etalon_base::catalogue::{Argument, IntoArgument, Phrase};
use etalon_base::message::{Message, Place, Problems};
use etalon_base::pose::Vector;
use etalon_base::pose_name::PoseName;
use etalon_base::{error, phrase};
use etalon_tables::lexer::{PlainColumn, written};
use etalon_tables::{ColumnSource, Decimal, Delimiter, Form};
use serde::de::{self, MapAccess, Visitor};
use serde::{Deserialize, Deserializer};
use std::fmt;

/// Every named format. To add one: its file, and its line here.
const FORMATS: [&dyn ExportFormat; 30] = [
    &polyworks::Polyworks,
    &qif::Qif,
    &spatialanalyzer::SpatialAnalyzer,
    &polyworks_report::PolyworksReport,
    &polyworks_project::PolyworksProject,
    &calypso::Calypso,
    &aqdef::Aqdef,
    &dmis::DMIS,
    &dmis::GEOPAK,
    &pcdmis_xyz::PcdmisXyz,
    &pcdmis_report::PcdmisReport,
    &geopak_gws::GeopakGws,
    &inspec::Inspec,
    &vda_fs::VdaFs,
    &ply::Ply,
    &ptx::Ptx,
    &stl::Stl,
    &pcd::Pcd,
    &e57::E57,
    &c3d::C3d,
    &fanuc_ls::FanucLs,
    &abb_rapid::AbbRapid,
    &delimited::XYZ,
    &delimited::XYZIJK,
    &delimited::NAME_XYZ,
    &delimited::TRACKER,
    &leica_at960::LEICA_AT960,
    &leica_emscon::LEICA_EMSCON,
    &leica_gsi::LeicaGsi,
    &sdss_plate::SDSS_PLATE,
];

/// A format of exports.
pub(crate) trait ExportFormat: Sync {
    /// Name and properties.
    fn about(&self) -> About;

    /// Returns the evidence that a text is in this format.
    fn recognise(&self, _text: &str) -> Option<Recognised> {
        None
    }

    /// Unit of lengths that a text contains.
    fn unit(&self, text: &str, _dialect: &Dialect) -> Option<Unit> {
        self.recognise(text).and_then(|found| Unit::named(found.unit?))
    }

    /// Warning about the points of such files, if they are not measured ones.
    fn caution(&self) -> Option<Message> {
        None
    }

    /// Dialect of the name, for delimited text.
    fn dialect(&self) -> Dialect {
        Dialect::default()
    }

    /// Rows of an export, with their problems.
    fn read(&self, text: &Text, dialect: &Dialect, unit: Unit) -> (Vec<Point>, Problems);

    /// Returns the text of an export of these rows.
    fn write(&self, rows: &[ExportRow], how: &Writing) -> Result<String, WriteError>;

    /// Returns the layout for the fast reader of a file with this beginning, if the fast reader may
    /// read it.
    fn plain(&self, _dialect: &Dialect, _start: &str, _unit: Unit) -> Option<Plain> {
        None
    }

    /// Frame to which the points refer, as given by the file.
    fn frame<'t>(&self, _text: &'t str) -> Option<&'t str> {
        None
    }
}

/// Layout of a table of plain rows for the fast reader.
#[derive(Clone, Debug)]
pub(crate) struct Plain {
    /// None: blanks and tabs.
    pub delimiter: Option<u8>,
    pub decimal: Decimal,
    /// Columns that are read, from the left, each behind the number of cells that are passed before
    /// it; their contents are a label or a coordinate.
    pub read: Vec<(usize, PlainColumn)>,
    /// Maximum number of filled cells behind the last of them.
    pub behind: usize,
    /// Bytes and lines above the data.
    pub above: (usize, u32),
    /// `true` if the strict reader decides whether columns x, y, z hold two angles and a distance.
    pub may_be_angles: bool,
}

impl Plain {
    /// Returns the layout of rows with these columns, without lines above them.
    pub fn new(delimiter: Delimiter, decimal: Decimal, columns: &[PlainColumn]) -> Self {
        let (mut read, mut behind) = (Vec::new(), 0);
        for column in columns {
            match column {
                PlainColumn::Skipped => behind += 1,
                column => read.push((std::mem::take(&mut behind), *column)),
            }
        }
        Self { delimiter: delimiter.byte(), decimal, read, behind, above: (0, 0), may_be_angles: false }
    }

    /// `true` if rows have labels.
    pub fn is_labelled(&self) -> bool {
        self.read.iter().any(|(_, column)| *column == PlainColumn::Label)
    }

    /// Layout of rows of only a label, if any, and x, y, z with a decimal point.
    pub fn bare(&self) -> Option<Bare> {
        let numbers = self.read.strip_prefix(&[(0, PlainColumn::Label)]).unwrap_or(&self.read);
        let in_order = numbers.iter().enumerate().all(|(axis, column)| *column == (0, PlainColumn::Coordinate(axis)));
        let bare = Bare { delimiter: self.delimiter.unwrap_or(b' '), labelled: self.is_labelled() };
        (in_order && self.behind == 0 && self.decimal == Decimal::Point).then_some(bare)
    }
}

/// Layout of rows of an optional label and x, y, z.
#[derive(Clone, Copy)]
pub(crate) struct Bare {
    /// Byte between the cells.
    pub delimiter: u8,
    pub labelled: bool,
}

/// Label and coordinates of a plain row, and where the next row begins.
pub(crate) type PlainRow<'a> = (&'a [u8], [f64; 3], usize);

/// Name and properties of a format.
#[derive(Clone, Copy, Default)]
pub(crate) struct About {
    /// Name, as in `format` of a campaign.
    pub name: &'static str,
    /// Name in words; empty for delimited text, which its dialect describes.
    pub title: &'static str,
    /// `true` if a campaign may contain `NAME, decimal comma`.
    pub decimal_comma: bool,
    /// `true` if files may be binary: a character of the text is then a byte.
    pub binary: bool,
    /// `true` if the format reads row by row, without the list of all lines.
    pub by_rows: bool,
}

/// Evidence that a text is in a format.
#[derive(Clone)]
pub(crate) struct Recognised {
    /// From 0 to 1: 1 for a signature at a fixed place.
    pub score: f64,
    /// Kind of file, and the feature by which it is recognised.
    pub what: Phrase,
    /// The unit that the file contains.
    pub unit: Option<&'static str>,
}

impl Recognised {
    /// Returns a text with this mark.
    pub fn by(mark: bool, score: f64, what: Phrase) -> Option<Self> {
        mark.then_some(Self { score, what, unit: None })
    }
}

/// Number of bytes that show the binary format of a file.
const START: usize = 8192;

/// Returns the name of the format of a file with this beginning, if its files may be binary.
pub(crate) fn binary_format(bytes: &[u8]) -> Option<&'static str> {
    let start: String = bytes.iter().take(START).map(|byte| char::from(*byte)).collect();
    let binary = FORMATS.iter().filter(|format| format.about().binary);
    binary.filter(|format| format.recognise(&start).is_some()).map(|format| format.about().name).next()
}

/// First characters of a text, where a document contains its kind.
pub(crate) fn head(text: &str) -> &str {
    let end = text.char_indices().nth(4000).map_or(text.len(), |(i, _)| i);
    &text[..end]
}

/// The most probable format of a text, and the evidence.
pub(super) fn recognise(text: &str) -> Option<(&'static str, Recognised)> {
    let all = FORMATS.iter().filter_map(|format| Some((format.about().name, format.recognise(text)?)));
    all.reduce(|best, other| if other.1.score > best.1.score { other } else { best })
}

/// Format of an export: a name, or a dialect of delimited text.
///
/// # Examples
///
/// ```
/// use etalon_formats::Format;
/// use etalon_formats::dialect::Unit;
///
/// let format = Format::named("polyworks").expect("a known format");
/// let text = "K_1 1.0 2.0 3.0\nL_1 1.0 2.0".into();
/// let (points, problems) = format.read("balls.txt", &text, Unit::Inch);
///
/// // an inch is 25.4 mm
/// assert_eq!(&*points[0].label, "K_1");
/// assert!((points[0].xyz_mm[0] - 25.4).abs() < 1e-12);
///
/// // the second row lacks a number
/// let place = problems.0[0].place.as_ref().expect("a place in the file");
/// assert_eq!((place.file.as_str(), place.line), ("balls.txt", Some(2)));
/// ```
#[derive(Clone)]
pub struct Format {
    kind: &'static dyn ExportFormat,
    /// Dialect of delimited text; for other formats only its decimal mark applies.
    pub dialect: Box<Dialect>,
}

impl Format {
    /// Returns the format of this name, optionally followed by `, decimal comma`.
    pub fn named(stated: &str) -> Option<Self> {
        let (name, decimal) = match stated.split_once(',') {
            Some((name, comma)) if comma.trim() == "decimal comma" => (name, Decimal::Comma),
            Some(_) => return None,
            None => (stated, Decimal::Point),
        };
        let kind = FORMATS.into_iter().find(|format| format.about().name == name)?;
        let mut dialect = kind.dialect();
        if decimal == Decimal::Comma {
            dialect.form.decimal = Some(decimal);
        }
        (decimal == Decimal::Point || kind.about().decimal_comma).then(|| Self { kind, dialect: Box::new(dialect) })
    }

    /// Returns the unit of lengths that a text in this format gives.
    pub fn stated_unit(&self, text: &str) -> Option<Unit> {
        self.kind.unit(text, &self.dialect)
    }

    /// Warning about the points of files of the format, if they are not measured ones.
    pub fn caution(&self) -> Option<Message> {
        self.kind.caution()
    }

    /// Names of all formats.
    pub fn names() -> impl Iterator<Item = &'static str> {
        FORMATS.iter().map(|format| format.about().name)
    }

    /// Name of the format, or the dialect as a campaign gives it.
    pub fn title(&self) -> Argument {
        match (self.about().title, self.dialect.form.decimal()) {
            ("", _) => self.dialect.to_string().argument(),
            (title, Decimal::Point) => title.argument(),
            (title, Decimal::Comma) => phrase!("read-with-decimal-comma", format = title).argument(),
        }
    }

    /// `true` if coordinates that are all zero mean "not measured" in these rows.
    ///
    /// Trackers write such rows for a lost target in tables of rows. Formats of elements list
    /// measured elements only, and a frame that is built on measured points has its origin at one
    /// of them.
    pub fn origin_is_missing(&self, rows: &[Point]) -> bool {
        self.dialect.form.missing.origin() && self.about().by_rows && !has_frame_on_points(rows)
    }

    pub(crate) fn about(&self) -> About {
        self.kind.about()
    }

    /// Rows of a text, with their problems.
    pub fn read(&self, file: &str, text: &SharedText, unit: Unit) -> (Vec<Point>, Problems) {
        self.kind.read(&Text::new(file, text, self.about().by_rows), &self.dialect, unit)
    }

    /// Length unit that the headings of the dialect state, as `X [mm]` does.
    pub fn heading_unit(&self) -> Option<Unit> {
        let Columns::Named(named) = &self.dialect.columns else { return None };
        let mut lengths = named.iter().filter(|(role, _)| role.is_coordinate() && !role.is_angle());
        lengths.find_map(|(_, source)| match source {
            ColumnSource::Heading(heading) => Unit::from_heading(heading),
            ColumnSource::Number(_) => None,
        })
    }

    /// The text of an export.
    ///
    /// # Errors
    /// Fails if the format cannot be written with these settings, or a row cannot be written.
    pub fn write(
        &self,
        rows: &[ExportRow],
        unit: Unit,
        decimals: usize,
        skipped: &[String],
    ) -> Result<String, WriteError> {
        let about = self.about();
        self.kind.write(rows, &Writing { about, dialect: &self.dialect, unit, decimals, skipped })
    }

    /// Returns the layout for the fast reader of a text that begins with these lines; `None` if
    /// only the strict reader may read it.
    pub(super) fn plain(&self, start: &str, unit: Unit) -> Option<Plain> {
        self.kind.plain(&self.dialect, start, unit)
    }

    /// Frame to which the points of a text of the format refer.
    pub fn frame<'t>(&self, text: &'t str) -> Option<&'t str> {
        self.kind.frame(text)
    }
}

impl Default for Format {
    /// PolyWorks text, the default.
    fn default() -> Self {
        Self { kind: &polyworks::Polyworks, dialect: Box::default() }
    }
}

impl From<Dialect> for Format {
    fn from(dialect: Dialect) -> Self {
        Self { kind: &delimited::Delimited, dialect: Box::new(dialect) }
    }
}

impl From<Form> for Format {
    fn from(form: Form) -> Self {
        Dialect { form, ..Dialect::default() }.into()
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match (self.about().title, self.dialect.form.decimal()) {
            ("", _) => write!(f, "{}", self.dialect),
            (title, Decimal::Point) => f.write_str(title),
            (title, Decimal::Comma) => write!(f, "{title}, decimal `,`"),
        }
    }
}

impl fmt::Debug for Format {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{self}")
    }
}

etalon_base::schema_by_hand!(Format, generator => {
    let commas = FORMATS.iter().map(|format| format.about()).filter(|about| about.decimal_comma);
    let commas = commas.map(|about| format!("{}, decimal comma", about.name));
    let names: Vec<String> = Self::names().map(str::to_owned).chain(commas).collect();
    schemars::json_schema!({ "anyOf": [{ "enum": names }, generator.subschema_for::<Dialect>()] })
});

impl<'de> Deserialize<'de> for Format {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct NameOrDialect;
        impl<'de> Visitor<'de> for NameOrDialect {
            type Value = Format;
            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                Format::names().try_for_each(|name| write!(f, "\"{name}\", "))?;
                f.write_str("or { delimiter = .., decimal = .., columns = [..] }")
            }
            fn visit_str<E: de::Error>(self, name: &str) -> Result<Format, E> {
                Format::named(name).ok_or_else(|| E::invalid_value(de::Unexpected::Str(name), &self))
            }
            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Format, A::Error> {
                Ok(Dialect::deserialize(de::value::MapAccessDeserializer::new(map))?.into())
            }
        }
        deserializer.deserialize_any(NameOrDialect)
    }
}

/// A row to write, in the unit of the export.
#[derive(Clone, Debug)]
pub struct ExportRow {
    /// Label of the point.
    pub label: String,
    /// Target of the robot that was measured.
    pub target: String,
    /// Pose of the robot.
    pub pose: PoseName,
    /// Repeat of the pose.
    pub cycle: i64,
    /// Time of the measurement (s).
    pub time_s: f64,
    /// Coordinates, in the unit of the export.
    pub xyz: Vector,
}

/// Reason why an export cannot be written.
#[derive(Clone, Debug)]
pub enum WriteError {
    /// The format has no such unit, or its writer does not support the dialect.
    Unsupported(Message),
    /// A row cannot be written.
    Row(Message),
}

impl WriteError {
    /// The reason as a message.
    pub fn into_message(self) -> Message {
        match self {
            Self::Unsupported(message) | Self::Row(message) => message,
        }
    }
}

impl From<Message> for WriteError {
    fn from(message: Message) -> Self {
        Self::Row(message)
    }
}

/// Settings of an export to write.
pub(crate) struct Writing<'a> {
    pub about: About,
    pub dialect: &'a Dialect,
    pub unit: Unit,
    /// Digits behind the decimal mark.
    pub decimals: usize,
    /// Contents of the columns that are not read; further columns contain `-`.
    pub skipped: &'a [String],
}

impl Writing<'_> {
    /// A coordinate.
    pub fn number(&self, value: f64) -> String {
        written(value, self.decimals, self.dialect.form.decimal())
    }

    /// The coordinates of a row.
    pub fn list(&self, row: &ExportRow, separator: &str) -> String {
        row.xyz.map(|value| self.number(value)).join(separator)
    }

    /// Name of the unit in the format; an error if the format cannot have the unit.
    pub fn unit_in(&self, known: &[(Unit, &'static str)]) -> Result<&'static str, WriteError> {
        let words = known.iter().find(|(unit, _)| *unit == self.unit).map(|(_, words)| *words);
        words.ok_or_else(|| {
            let units: Vec<&str> = known.iter().map(|(unit, _)| unit.name()).collect();
            let message = error!("format-without-unit", format = self.about.name, unit = self.unit.name(), units);
            WriteError::Unsupported(message)
        })
    }
}

/// The text of an export by lines.
pub(crate) struct Text<'a> {
    file: &'a str,
    whole: &'a SharedText,
    lines: Vec<&'a str>,
}

impl<'a> Text<'a> {
    fn new(file: &'a str, whole: &'a SharedText, by_rows: bool) -> Self {
        Self { file, whole, lines: if by_rows { Vec::new() } else { whole.lines().collect() } }
    }

    /// Bytes of a binary file, whose text has one character for each byte; `None` for other text.
    fn bytes(&self) -> Option<Vec<u8>> {
        self.whole.chars().map(|c| u8::try_from(u32::from(c)).ok()).collect()
    }

    /// Bytes at the beginning of the text of a binary file; `None` for other text.
    fn start_bytes(text: &str) -> Option<Vec<u8>> {
        text.chars().take(START).map(|c| u8::try_from(u32::from(c)).ok()).collect()
    }

    /// A line, from 1.
    fn place(&self, line: usize) -> Place {
        Place::line(self.file, line, self.line_text(line))
    }

    /// A part of a line, which starts at a byte of it.
    fn part(&self, line: usize, byte: usize, width: usize) -> Place {
        let text = self.line_text(line);
        let before = text.get(..byte.min(text.len())).unwrap_or("");
        self.place(line).at(before.chars().count() + 1, width)
    }

    /// Text of a line, from 1; empty beyond the last line.
    fn line_text(&self, line: usize) -> &'a str {
        line.checked_sub(1).and_then(|i| self.lines.get(i)).copied().unwrap_or("")
    }

    /// A row at a line, in millimetres.
    fn point(&self, line: usize, label: &str, xyz: Vector, unit: Unit) -> Point {
        Point::from_line(line, Line::from_part(self.whole, self.line_text(line)), label.into(), xyz, unit)
    }

    /// A row at a line that is not a point, with the reason.
    fn no_point(&self, line: usize, label: &str, reason: Phrase) -> Point {
        Point {
            more: Stated { refused: Some(Box::new(reason)), ..Stated::default() }.boxed(),
            ..self.point(line, label, [0.0; 3], Unit::Millimetre)
        }
    }
}

/// Error if the unit of the file differs from the unit of the campaign; `how` is the record of the
/// file that gives it.
fn unit_agrees(stated: Unit, of_file: Unit, how: &impl IntoArgument, place: Place) -> Result<(), Message> {
    if stated == of_file {
        return Ok(());
    }
    Err(error!("unit-differs", of_file = of_file.name(), how, stated = stated.name()).at(place))
}

/// Error for a file that is not in its given format; `signature` is the beginning of files of the
/// format.
fn not_this_format(format: &str, signature: &impl IntoArgument) -> Message {
    error!("format-differs", format, signature)
}

/// Adds to the error of a number the hint that the format has a variant with decimal commas.
fn decimal_comma(message: Message, number: &str, format: &str) -> Message {
    if number.contains(',') { message.hint(phrase!("format-with-decimal-comma", format)) } else { message }
}
