//! A file of a proposal.

use crate::dialect::quoted;
use crate::export::Pattern;
use crate::exports::stamp_seconds;
use crate::input::read_bytes;
use crate::propose::against::{self, Remarks};
use crate::propose::labels::Labels;
use crate::propose::meaning::{Interpretation, Meaning};
use crate::propose::motion::Motion;
use crate::propose::statements::{Line, Lines};
use crate::propose::table::Table;
use crate::propose::{Correct, Proposed, files_beside, propose_corrected, recording, sheets};
use etalon_base::catalogue::Phrase;
use etalon_base::message::Result;
use etalon_base::phrase;
use etalon_base::worded::Worded;
use etalon_documents::FormatsDocument;
use etalon_robots::Robot;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// A file with its proposal and, of a table, its interpretation.
pub(in crate::propose) struct Part {
    pub path: PathBuf,
    /// Sheet of a workbook with several tables.
    pub sheet: Option<String>,
    pub document: FormatsDocument,
    pub lines: Lines,
    pub read: Option<(Table, Interpretation)>,
    /// Motion of a recording of messages.
    pub motion: Option<Motion>,
    /// Unit of the times, if the duration of another file shows it.
    pub clock: Option<&'static str>,
    /// `true` if the points are measured because a log of joints stands beside them.
    pub is_beside_log: bool,
}

impl Part {
    /// Reads files. Each sheet of a workbook that contains a table is a part; a file of numbers
    /// that belongs to another file is left out.
    pub fn all(paths: &[PathBuf], robot: Option<&dyn Robot>) -> Result<Vec<Self>> {
        let beside: Vec<PathBuf> = paths.iter().flat_map(|path| files_beside(path)).collect();
        let mut parts = Vec::new();
        for path in paths.iter().filter(|path| !beside.iter().any(|other| are_one(path, other))) {
            let sheets = sheets(path);
            let tables = sheets.iter().filter_map(|sheet| Self::new(path, Some(sheet), robot).ok());
            let tables: Vec<Self> = tables.filter(|part| part.document.kind != "unknown").collect();
            match tables.len() {
                0 | 1 => parts.push(Self::new(path, None, robot)?),
                _ => parts.extend(without_summary(tables)),
            }
        }
        Ok(parts)
    }

    fn new(path: &Path, sheet: Option<&str>, robot: Option<&dyn Robot>) -> Result<Self> {
        let mut read = None;
        let Proposed { document, lines } = propose_corrected(
            path,
            sheet,
            robot,
            Some(&mut |table, found| {
                // joints and points in different files are tested when they are joined
                let whole = !found.points.is_empty() && !found.joint_columns().is_empty();
                // columns of joints of several branches are known by their headings alone
                let by_headings = robot.is_some_and(|robot| !robot.branches().is_empty());
                // numbers without headings may be joints and a point
                let nameless = table.columns.iter().all(|column| column.name.is_none());
                let remarks = robot
                    .filter(|_| whole || by_headings || nameless)
                    .map(|robot| against::correct(robot, table, found));
                read = Some((table.clone(), found.clone()));
                remarks.unwrap_or_default()
            }),
        )?;
        let is_recording = matches!(document.format.as_deref(), Some("mcap" | "db3"));
        let motion = is_recording.then(|| read_bytes(path).ok().and_then(|bytes| recording::motion(&bytes))).flatten();
        let sheet = sheet.map(str::to_owned);
        let path = path.to_owned();
        Ok(Self { path, sheet, document, lines, read, motion, clock: None, is_beside_log: false })
    }

    /// Letters, digits and `_` of the name of the sheet, or of the file without its ending.
    pub fn stem(&self) -> String {
        let file = || Path::new(&self.document.file).file_stem().map(|stem| stem.to_string_lossy().into_owned());
        let stem = self.sheet.clone().or_else(file).unwrap_or_default();
        stem.chars().filter(|c| c.is_alphanumeric() || *c == '_').collect()
    }

    /// Returns the motion of a log with times.
    pub fn motion(&self) -> Option<Motion> {
        if self.motion.is_some() {
            return self.motion.clone();
        }
        let (table, found) = self.read.as_ref()?;
        let times = &table.columns[found.first(Meaning::Time)?].values;
        let factor = seconds_per(found.clock.unit);
        let columns = found.joint_columns();
        let joints = (0..table.rows).map(|row| columns.iter().map(|at| table.columns[*at].values[row]).collect());
        let mut motion = Motion::new(times.iter().map(|time| factor * time).collect(), joints.collect())?;
        motion.names = columns.iter().filter_map(|at| table.columns[*at].name.clone()).collect();
        Some(motion)
    }

    /// Returns the times of the points (s), in order.
    pub fn times_s(&self) -> Option<Vec<f64>> {
        let (table, found) = self.read.as_ref()?;
        let mut times: Vec<f64> = match found.first(Meaning::Time) {
            Some(at) => {
                let factor = seconds_per(found.clock.unit);
                table.columns[at].values.iter().map(|time| factor * time).collect()
            }
            None => {
                let at = found.first(Meaning::Clock).or(found.first(Meaning::TimeOfDay))?;
                let cells = table.columns[at].cells.iter();
                cells.map(|cell| stamp_seconds("", cell).unwrap_or(f64::NAN)).collect()
            }
        };
        times.retain(|time| time.is_finite());
        times.sort_by(f64::total_cmp);
        Some(times)
    }

    /// Writes the proposal again with another correction.
    pub fn again(&mut self, correct: Correct) -> Result<()> {
        let (mut read, is_beside_log) = (None, self.is_beside_log);
        let Proposed { document, lines } = propose_corrected(
            &self.path,
            self.sheet.as_deref(),
            None,
            Some(&mut |table, found| {
                found.is_beside_log = is_beside_log;
                let remarks = correct(table, found);
                read = Some((table.clone(), found.clone()));
                remarks
            }),
        )?;
        (self.document, self.lines, self.read) = (document, lines, read);
        self.state_clock();
        Ok(())
    }

    /// Writes the unit of the times that the duration of another file shows.
    pub fn state_clock(&mut self) {
        let (Some(unit), Some((_, found))) = (self.clock, &mut self.read) else { return };
        found.clock.unit = Some(unit);
        let question = found.clock.question.take();
        self.lines.state_time_unit(unit);
        self.withdraw(question.as_ref());
    }

    /// Leaves out the times of a log, whose unit is open, if no join needs them.
    pub fn leave_clock(&mut self) {
        let Some((table, found)) = self.read.as_ref().filter(|(_, found)| found.clock.question.is_some()) else {
            return;
        };
        let Some(at) = found.first(Meaning::Time) else { return };
        let question = found.clock.question.clone();
        let named = table.columns[at].name.as_deref().map(quoted).into_iter().chain([(at + 1).to_string()]);
        let (sources, called) = (named.collect::<Vec<String>>(), table.called(at));
        if self.lines.leave_open_times(&sources) {
            self.withdraw(question.as_ref());
            self.doubt(phrase!("doubt-columns-not-read", columns = vec![called], more = 0));
        }
    }

    /// Removes a question that is answered.
    fn withdraw(&mut self, answered: Option<&Phrase>) {
        let is_asked = |question: &Worded| answered.is_some() && question.phrase() == answered;
        self.lines.0.retain(|line| !matches!(line, Line::Question(question) if is_asked(question)));
        self.document.questions.retain(|question| !is_asked(question));
    }

    /// Adds a doubt above the lines.
    pub fn doubt(&mut self, doubt: Phrase) {
        self.lines.doubt(&doubt);
        self.document.doubt(doubt);
    }

    /// Returns use, number of rows and units of the file.
    pub fn summary(&self) -> String {
        let unit = |wanted: &dyn Fn(Meaning) -> bool| {
            let (table, found) = self.read.as_ref()?;
            let at = found.taken.iter().position(|taken| wanted(taken.meaning))?;
            Some(table.columns[at].heading.unit.unwrap_or("open").to_owned())
        };
        let coordinates = unit(&|meaning| matches!(meaning, Meaning::Point(..))).unwrap_or("none".to_owned());
        let joints = unit(&|meaning| matches!(meaning, Meaning::Joint(_))).unwrap_or("none".to_owned());
        let times = unit(&|meaning| meaning == Meaning::Time).unwrap_or("none".to_owned());
        let kind = &*self.document.kind;
        let sheet = self.sheet.as_ref().map(|sheet| format!(": {sheet}")).unwrap_or_default();
        let (file, rows) = (format!("{}{sheet}", self.document.file), self.document.rows);
        phrase!("file-is", file, kind, rows, coordinates, joints, times).to_string()
    }

    /// Names the points by the running number in front of them; `false` for points without one.
    pub fn name_by_count(&mut self) -> Result<bool> {
        let counted = self.read.as_ref().and_then(|(_, found)| found.first(Meaning::Count));
        let Some(at) = counted else { return Ok(false) };
        self.again(&mut |_, found| {
            found.take(at, Meaning::Label, phrase!("why-names-of-points"));
            Remarks::default()
        })?;
        Ok(true)
    }

    /// Returns the target of each row: of its column, or of its label.
    pub fn targets(&self) -> Option<Vec<String>> {
        let (table, found) = self.read.as_ref()?;
        if let Some(at) = found.first(Meaning::Target) {
            return Some(table.columns[at].texts());
        }
        let labels = table.columns[found.first(Meaning::Label)?].texts();
        let Labels { form, .. } = Labels::new(&labels)?;
        let pattern = Pattern::parse(&form).ok()?;
        let target = |label: &String| pattern.read(label, |_| false).and_then(|named| named.target).unwrap_or_default();
        Some(labels.iter().map(target).collect())
    }

    /// `true` for a recording of messages.
    pub fn is_recording_of_messages(&self) -> bool {
        matches!(self.document.format.as_deref(), Some("mcap" | "db3"))
    }

    /// The document with its lines.
    pub fn printed(self) -> FormatsDocument {
        FormatsDocument { toml: self.lines.to_string(), ..self.document }
    }
}

/// Leaves out a sheet whose rows of numbers are all in the other sheets of the workbook, with a
/// doubt.
fn without_summary(mut sheets: Vec<Part>) -> Vec<Part> {
    let rows = |part: &Part| -> BTreeSet<Vec<u64>> {
        let Some((table, _)) = &part.read else { return BTreeSet::new() };
        let numbers = |row: usize| {
            let values = table.columns.iter().filter_map(|column| column.values.get(row).copied());
            values.filter(|value| value.is_finite()).map(f64::to_bits).collect::<Vec<u64>>()
        };
        (0..table.rows).map(numbers).filter(|numbers| numbers.len() > 1).collect()
    };
    let all: Vec<BTreeSet<Vec<u64>>> = sheets.iter().map(rows).collect();
    let is_summary = |at: &usize| {
        let others = || all.iter().enumerate().filter(|(other, _)| other != at).map(|(_, rows)| rows);
        let is_largest = others().all(|rows| rows.len() < all[*at].len());
        let is_elsewhere = |row: &Vec<u64>| others().any(|rows| rows.contains(row));
        is_largest && others().filter(|rows| !rows.is_empty()).count() > 1 && all[*at].iter().all(is_elsewhere)
    };
    if let Some(at) = (0..all.len()).find(is_summary) {
        let sheet = sheets.remove(at).sheet.unwrap_or_default();
        sheets[0].doubt(phrase!("doubt-summary", sheet));
    }
    sheets
}

/// `true` for two paths to one file of a folder, whose name may be spelled in capitals.
fn are_one(path: &Path, other: &Path) -> bool {
    let names = path.file_name().zip(other.file_name());
    path.parent() == other.parent() && names.is_some_and(|(name, other)| name.eq_ignore_ascii_case(other))
}

/// Returns the unit of times in seconds; one second for an open unit.
pub(super) fn seconds_per(unit: Option<&str>) -> f64 {
    match unit {
        Some("ms") => 1e-3,
        Some("us") => 1e-6,
        Some("ns") => 1e-9,
        _ => 1.0,
    }
}
