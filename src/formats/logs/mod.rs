//! Logs of controllers: the section `[log]` of a campaign, the reader, and the formats (one file
//! each).

pub mod arrays;
mod galil;
mod joint_log;
mod kuka_rsi;
mod kuka_trace;
pub mod matlab;
pub mod numpy;
mod ros;
mod sheet;
pub mod standstill;
mod twincat;
mod ur_rtde;
mod write;

pub(crate) use arrays::{ArrayFile, ArrayParts};
pub use joint_log::{DIRECTION, is_common_column, meaning};
pub use joint_log::{JointLog, LogRow, is_joint_column};
pub use write::write;

use super::dialect::Column;
use super::exports::Recognised;
use crate::table::{ASSEMBLY, LABEL};
use etalon_base::message::{Message, Problems, Result, SourceText};
use etalon_base::pose_name::PoseName;
use etalon_base::{error, phrase};
use etalon_documents::{Refused, Source};
use etalon_tables::sheet::Sheet;
use etalon_tables::{Constant, Delimiter, Form, FromRow, Header};
use schemars::JsonSchema;
use serde::{Deserialize, Deserializer, Serialize, Serializer, de::Error};
use std::collections::BTreeMap;
use std::fmt;
use std::path::Path;
use toml::Spanned;

/// A file of a controller.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(transform = etalon_tables::schema::accept_topic)]
pub struct Log {
    /// Name of the log, if there are several.
    #[serde(default = "default_log")]
    pub name: String,
    /// Name of the file.
    #[schemars(with = "String")]
    pub file: Spanned<String>,
    /// Controller that wrote the log.
    #[serde(default)]
    pub format: LogKind,
    /// Form of its text. Rows without a value of a joint or a time are omitted.
    #[serde(flatten)]
    pub form: Form,
    /// Columns to read: `pose`, `cycle`, `time_s`, `time_ms`, `time_us`, `time_ns`, `label` (of the
    /// touched point), and the joints with their units. Effects of a robot need the payload
    /// (`load_kg`, `load_x_mm`, `load_y_mm`, `load_z_mm`), torques (`tau1_nm`) or the temperature
    /// (`temperature_c`). Backlash needs the direction from which a joint came (`q1_direction`: +1
    /// from below, -1 from above).
    #[schemars(with = "BTreeMap<String, Column>")]
    pub columns: BTreeMap<Spanned<String>, Column>,
    /// Columns with the same value in all rows, e.g. `q7_mm = 0`; `cycle = "visit"` counts the
    /// rows of each pose.
    #[serde(default)]
    #[schemars(with = "BTreeMap<String, Constant>")]
    pub constants: BTreeMap<Spanned<String>, Constant>,
    /// Pose number from the number of the data row: `row`, or `row + 100` with an offset for a
    /// second file of the same targets.
    pub pose: Option<FromRow>,
    /// Time from one row to the next (s) for a log without a clock; the first row is at 0.
    pub period_s: Option<f64>,
    /// Kind of values in channels with a scale: raw or scaled (TwinCAT).
    pub values: Option<ChannelValues>,
    /// Reduces a log recorded during motion to one row of mean joint values for each standstill.
    pub standstill: Option<StandstillCriterion>,
}

/// A standstill: no joint moves by more than the given difference for at least the given time.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StandstillCriterion {
    /// Minimum duration of a standstill (s).
    pub at_least_s: f64,
    /// Upper limit for the difference of two values of a revolute joint in a standstill (deg).
    pub within_deg: Option<f64>,
    /// Upper limit for the difference of two values of a prismatic joint in a standstill (mm).
    pub within_mm: Option<f64>,
}

impl Log {
    /// Returns the form of the text: the numbers of arrays become a text with tabs.
    pub fn read_form(&self) -> Form {
        let delimiter = self.form.delimiter.or(self.format.0.has_arrays().then_some(Delimiter::Tab));
        Form { delimiter, ..self.form.clone() }
    }

    /// Returns the format: topics of a recording are messages of ROS.
    fn kind(&self) -> LogKind {
        if self.form.is_topic() { LogKind(&ros::Ros) } else { self.format }
    }

    /// Returns the keys of the columns and of the constants.
    pub fn keys(&self) -> impl Iterator<Item = &Spanned<String>> {
        self.columns.keys().chain(self.constants.keys())
    }

    /// `true` if a row names the columns.
    pub fn has_header(&self) -> bool {
        self.form.header() != Header::Rows(0)
    }
}

/// Values in the channels of a TwinCAT Scope export: an option of the export that the file does not
/// contain.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum ChannelValues {
    /// Recorded values: factor and offset of the header are not yet applied.
    Raw,
    /// Scaled values: factor and offset are applied.
    Scaled,
}

fn default_log() -> String {
    "log".to_owned()
}

/// All formats. A new format needs its file and a line here.
const FORMATS: [&dyn LogFormat; 9] = [
    &sheet::Delimited,
    &galil::Galil,
    &ur_rtde::UrRtde,
    &kuka_rsi::KukaRsi,
    &kuka_trace::KukaTrace,
    &twincat::TwinCat,
    &ros::Ros,
    &numpy::Numpy,
    &matlab::Matlab,
];

/// Log of a campaign, and the text of its file.
#[derive(Clone, Copy)]
pub(crate) struct LogText<'a> {
    pub log: &'a Log,
    /// Places of the statements on the log.
    pub stated: SourceText<'a>,
    pub text: &'a str,
}

/// Names of a format.
#[derive(Clone, Copy)]
pub(crate) struct About {
    /// Value of `format` in campaign.toml.
    pub name: &'static str,
    /// Title; empty for plain delimited text.
    pub title: &'static str,
    /// Description in one sentence.
    #[cfg_attr(not(feature = "schemas"), expect(dead_code))]
    pub description: &'static str,
}

/// Format of logs: delimited text with known columns, units or clocks.
pub(crate) trait LogFormat: Sync {
    /// Returns the names of the format.
    fn about(&self) -> About;

    /// Returns the evidence that a text has this format; `header` has the names in its first row.
    fn recognise(&self, _header: &[&str], _text: &str) -> Option<Recognised> {
        None
    }

    /// Returns the unit of the column with this name, if the format fixes it.
    fn column_unit(&self, _column: &str) -> Option<&'static str> {
        None
    }

    /// `true` if a column keeps its number from file to file.
    fn has_stable_order(&self) -> bool {
        true
    }

    /// Returns the error of a statement about a column of this format.
    fn statement(&self, _wanted: &Wanted) -> Option<Message> {
        None
    }

    /// Names columns that the header leaves unnamed.
    fn name_columns(&self, _sheet: &mut Sheet, _problems: &mut Problems) {}

    /// Removes rows without data; `wanted` has the indices of the wanted columns.
    fn cut(&self, _sheet: &mut Sheet, _wanted: &[(usize, &Wanted)], _problems: &mut Problems) -> Vec<Refused> {
        Vec::new()
    }

    /// Checks the values of a joint in the unit of the file.
    fn check_joint(&self, _sheet: &Sheet, _at: usize, _read: &[f64], _problems: &mut Problems) {}

    /// Returns a warning about the columns that were read.
    fn remark(&self, _file: &str, _columns: &Columns) -> Option<Message> {
        None
    }

    /// `true` if a file names and scales its channels: `values` applies, `header` does not.
    fn has_channels(&self) -> bool {
        false
    }

    /// `true` if files contain arrays instead of text: `table` reads them.
    fn has_arrays(&self) -> bool {
        false
    }

    /// `true` if bytes begin like a file of arrays of this format.
    fn holds(&self, _bytes: &[u8]) -> bool {
        false
    }

    /// Returns the names of the files beside a file of arrays that contain its numbers.
    fn files_beside(&self, _bytes: &[u8]) -> Vec<String> {
        Vec::new()
    }

    /// Returns the arrays of a file, with the text of each part that can be a column.
    fn arrays(&self, _file: &ArrayFile) -> std::result::Result<Vec<ArrayParts>, Message> {
        Ok(Vec::new())
    }

    /// Returns the wanted parts of the arrays of a file as a text with tabs.
    fn table(&self, _file: &ArrayFile, _wanted: &[&str]) -> Option<std::result::Result<String, Message>> {
        None
    }

    /// Reads the wanted columns.
    fn read(&self, log: LogText, wanted: &[Wanted], source: &mut Source) -> Result<Columns> {
        sheet::read(log, wanted, source)
    }

    /// `true` if columns are sorted by name.
    fn is_sorted(&self) -> bool {
        false
    }
}

/// Format of a log.
#[derive(Clone, Copy)]
pub struct LogKind(&'static dyn LogFormat);

impl LogKind {
    /// Returns the most likely format of a text, and its evidence.
    pub(crate) fn recognise(text: &str) -> Option<(Self, Recognised)> {
        let first = text.lines().find(|line| !line.trim().is_empty()).unwrap_or_default();
        let header: Vec<&str> = first.split([',', ';', '\t']).map(|name| name.trim().trim_matches('"')).collect();
        let all = FORMATS.into_iter().filter_map(|format| Some((Self(format), format.recognise(&header, text)?)));
        all.reduce(|best, other| if other.1.score > best.1.score { other } else { best })
    }

    pub(crate) fn about(self) -> About {
        self.0.about()
    }

    /// Returns the format of a file of arrays.
    pub(crate) fn from_array_file(bytes: &[u8]) -> Option<Self> {
        FORMATS.into_iter().find(|format| format.holds(bytes)).map(Self)
    }

    /// Adds the files in the same folder that contain the numbers of a file of arrays.
    ///
    /// # Errors
    /// A file that is missing or cannot be read.
    pub(crate) fn array_file<'a>(self, path: &Path, bytes: &'a [u8]) -> Result<ArrayFile<'a>> {
        ArrayFile::read(path, bytes, &self.0.files_beside(bytes))
    }

    /// Returns the wanted parts of the arrays of a file as a text with tabs; `None` for files of
    /// text.
    pub(crate) fn table(self, file: &ArrayFile, wanted: &[&str]) -> Option<std::result::Result<String, Message>> {
        self.0.table(file, wanted)
    }

    /// Returns the arrays of a file, with the text of each part that can be a column.
    pub(crate) fn arrays(self, file: &ArrayFile) -> std::result::Result<Vec<ArrayParts>, Message> {
        self.0.arrays(file)
    }

    /// Returns an array of a file, and all other arrays of the same length, as the cells of a
    /// sheet: their parts are the columns, which the first row names.
    ///
    /// # Errors
    /// Fails if the file cannot be read, or has no such array.
    pub(crate) fn sheet(self, file: &ArrayFile, name: &str) -> std::result::Result<String, Message> {
        let arrays = self.arrays(file)?;
        // the array of an `.npy` file has no name
        let is_meant = |array: &&ArrayParts| array.name == name || array.name.is_empty();
        let Some(meant) = arrays.iter().find(is_meant) else {
            let known = arrays.iter().map(|array| array.name.as_str());
            return Err(error!("array-missing", column = name).hint_names(name, known));
        };
        let beside = arrays.iter().filter(|array| array.count == meant.count && array.name != meant.name);
        let parts: Vec<&str> =
            std::iter::once(meant).chain(beside).flat_map(|array| &array.parts).map(String::as_str).collect();
        self.0.table(file, &parts).unwrap_or_else(|| Err(error!("array-missing", column = name)))
    }

    /// Returns the unit of the column with this name, if the format fixes it.
    pub(crate) fn column_unit(self, column: &str) -> Option<&'static str> {
        self.0.column_unit(column)
    }

    /// `true` if a file names and scales its channels.
    pub fn has_channels(self) -> bool {
        self.0.has_channels()
    }
}

impl Default for LogKind {
    fn default() -> Self {
        Self(&sheet::Delimited)
    }
}

impl fmt::Debug for LogKind {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(self.about().name)
    }
}

impl Serialize for LogKind {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        serializer.serialize_str(self.about().name)
    }
}

etalon_base::schema_by_hand!(@ LogKind, "LogFormat", false, _ => {
    let one = |About { name, description, .. }| schemars::json_schema!({ "description": description, "type": "string", "const": name });
    let all: Vec<schemars::Schema> = FORMATS.iter().map(|format| format.about()).map(one).collect();
    let description = "Who wrote a log: what is known of its columns, units and clock.";
    schemars::json_schema!({ "description": description, "oneOf": all })
});

impl<'de> Deserialize<'de> for LogKind {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> std::result::Result<Self, D::Error> {
        let stated = String::deserialize(deserializer)?;
        FORMATS.into_iter().find(|format| format.about().name == stated).map(Self).ok_or_else(|| {
            let names: Vec<String> = FORMATS.iter().map(|format| format!("`{}`", format.about().name)).collect();
            D::Error::custom(format!("unknown variant `{stated}`, expected one of {}", names.join(", ")))
        })
    }
}

/// Columns of a log.
#[derive(Debug, Default)]
pub(crate) struct Columns {
    /// Number of each data row, from 1.
    pub rows: Vec<i64>,
    /// Line of each row, from 1.
    pub lines: Vec<i64>,
    /// Columns with their names in the table (mm, deg, s).
    pub columns: Vec<(String, Values)>,
    /// Warnings.
    pub said: Vec<Message>,
}

/// Values of a column.
#[derive(Debug)]
pub(crate) enum Values {
    /// Labels.
    Text(Vec<String>),
    /// Names of poses.
    Poses(Vec<PoseName>),
    /// Finite numbers.
    Real(Vec<f64>),
}

/// Column to read.
pub(crate) struct Wanted<'a> {
    key: &'a Spanned<String>,
    column: &'a Column,
    /// Name in the table.
    name: String,
    /// Factor from the unit of the key to the unit of the table.
    factor: f64,
}

impl Wanted<'_> {
    /// Returns a value of the file in the unit of the table.
    fn value(&self, read: f64) -> f64 {
        let Some(per_count) = self.column.per_count else { return read * self.factor };
        (read - self.column.zero_count.unwrap_or(0.0)) * per_count * self.factor
    }

    /// Returns the unit in the key: `rad` of `q1_rad`, `ms` of `time_ms`; `None` of `pose`.
    fn unit(&self) -> Option<&str> {
        let key = self.key.get_ref();
        let unitless = self.name == *key
            && (matches!(key.as_str(), "pose" | "cycle" | "label" | "assembly") || key.ends_with(DIRECTION));
        key.rsplit_once('_').map(|(_, unit)| unit).filter(|_| !unitless)
    }

    /// `true` for a joint: not a time, pose, cycle, label, direction or assembly mode.
    fn is_joint(&self) -> bool {
        !is_common_column(self.key.get_ref()) && !self.name.ends_with(DIRECTION)
    }
}

/// Reads a log, with its warnings. If the campaign contains `standstill`, each standstill is one
/// row.
pub fn read(stated: SourceText, log: &Log, text: &str, source: &mut Source) -> Result<(JointLog, Vec<Message>)> {
    let Columns { rows, lines, columns, said } = columns(stated, log, text, source)?;
    let mut read = JointLog { name: log.name.clone(), file: log.file.get_ref().clone(), ..JointLog::default() };
    let mut names = vec!["row", "line"];
    names.extend(log.pose.map(|_| "pose"));
    names.extend(log.period_s.map(|_| "time_s"));
    read.columns = names.into_iter().map(str::to_owned).chain(columns.iter().map(|(name, _)| name.clone())).collect();
    read.rows = rows
        .iter()
        .zip(lines)
        .map(|(&row, line)| LogRow {
            row,
            line: line as usize,
            pose: log.pose.map(|from| from.number(row).into()),
            time_s: log.period_s.map(|period_s| (row - 1) as f64 * period_s),
            ..LogRow::default()
        })
        .collect();
    for (name, values) in columns {
        let values = match values {
            Values::Text(texts) => {
                read.rows.iter_mut().zip(texts).for_each(|(row, text)| row.label = Some(text));
                continue;
            }
            Values::Poses(poses) => {
                read.rows.iter_mut().zip(poses).for_each(|(row, pose)| row.pose = Some(pose));
                continue;
            }
            Values::Real(values) => values,
        };
        let set: fn(&mut LogRow, f64) = match name.as_str() {
            "pose" => |row, v| row.pose = Some((v as i64).into()),
            "cycle" => |row, v| row.cycle = Some(v as i64),
            "time_s" => |row, v| row.time_s = Some(v),
            ASSEMBLY => |row, v| row.assembly = Some(v),
            _ => {
                read.joints.push(name);
                |row, v| row.joints.push(v)
            }
        };
        read.rows.iter_mut().zip(values).for_each(|(row, value)| set(row, value));
    }
    Ok(match &log.standstill {
        Some(still) => (standstill::reduce(stated, log, still, read, source)?, said),
        None => (read, said),
    })
}

/// Reads the columns of a log that the campaign names.
pub(super) fn columns(stated: SourceText, log: &Log, text: &str, source: &mut Source) -> Result<Columns> {
    let mut problems = Problems::default();
    let wanted = wanted(stated, log, &mut problems);
    match log.kind().0.read(LogText { log, stated, text }, &wanted, source) {
        Ok(mut columns) => {
            for (key, constant) in &log.constants {
                let Some((name, factor)) = meaning(key.get_ref()) else { continue };
                let values = constant_values(&columns, &name, constant, factor).map_err(|m| m.at(stated.place(key)));
                columns.columns.extend(problems.keep(values.map_err(Problems::from)).map(|values| (name, values)));
            }
            problems.check().map(|_| columns)
        }
        Err(more) => {
            problems.0.extend(more.0);
            Err(problems)
        }
    }
}

/// Cell of the constant `cycle` of a log whose rows are in the order of measurement: the n-th row
/// of a pose is cycle n.
const VISIT: &str = "visit";

/// Returns the values of a constant column with a factor, one for each row.
fn constant_values(
    log: &Columns,
    name: &str,
    constant: &Constant,
    factor: f64,
) -> std::result::Result<Values, Message> {
    let count = log.rows.len();
    let invalid = || error!("log-constant-invalid", column = name, value = constant.cell());
    Ok(match (name, constant) {
        (LABEL, constant) => Values::Text(vec![constant.cell(); count]),
        ("pose", constant) => {
            let pose = PoseName::new(&constant.cell()).map_err(|_| invalid())?;
            Values::Poses(vec![pose; count])
        }
        ("cycle", Constant::Text(text)) if text == VISIT => {
            let poses = log.columns.iter().find_map(|(_, values)| match values {
                Values::Poses(poses) => Some(poses),
                _ => None,
            });
            Values::Real(visits(poses.ok_or_else(invalid)?))
        }
        ("cycle", Constant::Number(number)) if number.fract() != 0.0 => return Err(invalid()),
        (ASSEMBLY, Constant::Number(number)) if number.abs() != 1.0 => return Err(invalid()),
        (_, Constant::Number(number)) if number.is_finite() => Values::Real(vec![factor * number; count]),
        _ => return Err(invalid()),
    })
}

/// Returns the number of each row among the rows of its pose, from 1.
fn visits(poses: &[PoseName]) -> Vec<f64> {
    let mut counts: BTreeMap<PoseName, f64> = BTreeMap::new();
    let visit = |pose: &PoseName| {
        let count = counts.entry(*pose).or_insert(0.0);
        *count += 1.0;
        *count
    };
    poses.iter().map(visit).collect()
}

/// Returns the column to read for each key of `columns`.
fn wanted<'a>(stated: SourceText, log: &'a Log, problems: &mut Problems) -> Vec<Wanted<'a>> {
    let mut wanted: Vec<Wanted> = Vec::new();
    let clock = log.period_s.is_some().then_some("time_s");
    let numbered = log.pose.is_some().then_some("pose");
    for (key, column) in &log.columns {
        let Some((name, factor)) = meaning(key.get_ref()) else {
            problems.0.push(error!("log-column-unknown", key = key.get_ref()).at(stated.place(key)));
            continue;
        };
        if wanted.iter().any(|w| w.name == name) || [clock, numbered].contains(&Some(name.as_str())) {
            problems.0.push(error!("log-column-twice", key = key.get_ref(), name).at(stated.place(key)));
            continue;
        }
        let wants = Wanted { key, column, name, factor };
        if column.per_count.is_some() && !wants.is_joint() {
            let message = error!("log-key-inapplicable", key = "per_count", column = key.get_ref());
            problems.0.push(message.at(stated.place(key)));
            continue;
        }
        wanted.push(wants);
    }
    check_constants(stated, log, &wanted, problems);
    let here = |message: Message| message.at(stated.place(&log.file));
    if log.period_s.is_some_and(|period| period <= 0.0 || !period.is_finite()) {
        problems.0.push(here(error!("key-not-positive", key = "period_s")));
    }
    if log.values.is_some() && !log.kind().0.has_channels() {
        problems.0.push(here(inapplicable("values")));
    }
    let form = &log.form;
    if let Some(key) = form.meaningless_beside_sheet() {
        problems.0.push(here(error!("key-of-text-table", key)));
    }
    let text = [
        ("delimiter", form.delimiter.is_some()),
        ("widths", !form.widths.is_empty()),
        ("decimal", form.decimal.is_some()),
        ("encoding", form.encoding.is_some()),
        ("comment", form.comment.is_some()),
        ("sheet", form.sheet.is_some()),
        ("thousands", form.thousands.is_some()),
    ];
    let rows = [("only", !form.only.is_empty()), ("without", !form.without.is_empty()), ("end", form.end.is_some())];
    for (key, _) in rows.iter().filter(|(_, stated)| *stated && log.kind().0.has_channels()) {
        problems.0.push(here(inapplicable(key)));
    }
    for (key, _) in text.iter().filter(|(_, stated)| *stated && log.kind().0.has_arrays()) {
        problems.0.push(here(inapplicable(key)));
    }
    if !log.has_header() && (log.kind().0.has_channels() || log.kind().0.has_arrays()) {
        problems.0.push(here(inapplicable("header")));
    }
    wanted
}

/// Checks that each constant is a known column, and given once.
fn check_constants(stated: SourceText, log: &Log, wanted: &[Wanted], problems: &mut Problems) {
    let mut names: Vec<String> = wanted.iter().map(|wanted| wanted.name.clone()).collect();
    names.extend(log.period_s.map(|_| "time_s".to_owned()));
    names.extend(log.pose.map(|_| "pose".to_owned()));
    for key in log.constants.keys() {
        let Some((name, _)) = meaning(key.get_ref()) else {
            problems.0.push(error!("log-column-unknown", key = key.get_ref()).at(stated.place(key)));
            continue;
        };
        if names.contains(&name) {
            problems.0.push(error!("log-column-twice", key = key.get_ref(), name).at(stated.place(key)));
        }
        names.push(name);
    }
}

/// Returns the error that a key means nothing for logs of this format.
fn inapplicable(key: &str) -> Message {
    error!("log-key-inapplicable", key, column = "none")
}

/// Checks that the key gives the unit that the column has in files of this format.
fn unit_agrees(format: LogKind, wanted: &Wanted, column: &str) -> std::result::Result<(), Message> {
    let (Some(stated), Some(known)) = (wanted.unit(), format.0.column_unit(column)) else { return Ok(()) };
    other_unit(wanted, column, stated, known).map_or(Ok(()), Err)
}

/// Returns the error that a column has another unit than its key gives, if it has.
fn other_unit(wanted: &Wanted, column: &str, stated: &str, known: &str) -> Option<Message> {
    if stated == known {
        return None;
    }
    let key = wanted.key.get_ref();
    let message = error!("column-unit-differs", key, stated, column, known);
    let meant = key.rsplit_once('_').map_or_else(|| key.clone(), |(name, _)| format!("{name}_{known}"));
    Some(match meaning(&meant) {
        Some((name, _)) if (name == "time_s") == (wanted.name == "time_s") => {
            message.hint(phrase!("write-column", key = meant, column))
        }
        _ => message.expected(phrase!("column-in-unit", unit = stated)),
    })
}
