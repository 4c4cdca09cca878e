//! Task of `etalon iso9283 path`.

use super::inputs::Table;
use super::text_format::{TextFormat, word};
use crate::stages::iso9283::stated::TestStatement;
use crate::stages::table_file::TableFile;
use etalon_base::message::Result;
use etalon_documents::Iso9283StreamDocument;
use etalon_formats::tables::recording::{commanded_path, commanded_poses, recording};
use etalon_standards::iso9283::motion::stream::Recording;
use etalon_standards::iso9283::path::commanded::CommandedPath;
use etalon_standards::iso9283::pose::test::CommandedPose;
use serde::Deserialize;
use std::path::Path;

/// Options of a recorded motion.
#[derive(Clone, Debug, clap::Args, Deserialize)]
#[serde(default)]
pub struct StreamOptions {
    /// Format of the recording, e.g. spatialanalyzer; replaces --columns, but needs --rate-hz, and
    /// --unit if the file does not contain its unit.
    #[arg(long, value_name = "NAME", requires_all = ["stream", "rate_hz"], conflicts_with = "columns")]
    pub format: Option<String>,
    /// Options for reading the tables.
    #[command(flatten)]
    #[serde(flatten)]
    pub text: TextFormat,
    /// Sampling rate of the recording, which replaces time stamps; some exports contain full
    /// seconds only.
    #[arg(long, value_name = "HZ", requires = "stream")]
    pub rate_hz: Option<f64>,
    /// Standstill: largest distance of positions from their mean.
    #[arg(long, value_name = "MM", default_value_t = Self::default().still_mm)]
    pub still_mm: f64,
    /// Standstill: minimum duration.
    #[arg(long, value_name = "S", default_value_t = Self::default().still_s)]
    pub still_s: f64,
    /// Largest distance of a standstill from its pose, and of an attained path from the commanded
    /// path.
    #[arg(long, value_name = "MM", default_value_t = Self::default().near_mm)]
    pub near_mm: f64,
    /// Limit band about the attained pose, for stabilisation time, overshoot and posing time; about
    /// a leg after its corner.
    #[arg(long, value_name = "MM", requires = "stream")]
    pub band_mm: Option<f64>,
    /// Commanded path.
    #[command(flatten)]
    #[serde(flatten)]
    pub path: PathOptions,
}

/// Options of a commanded path, and of a weave about it.
#[derive(Clone, Debug, clap::Args, Deserialize)]
#[serde(default)]
pub struct PathOptions {
    /// Number of command points on the path, in whose normal planes passes are compared.
    #[arg(long, value_name = "N", default_value_t = Self::default().path_points)]
    pub path_points: usize,
    /// Commanded velocity on the path.
    #[arg(long, value_name = "MM_S", requires = "path")]
    pub velocity_mm_s: Option<f64>,
    /// Central part of the path in which velocities are evaluated (%).
    #[arg(long, value_name = "PERCENT", default_value_t = Self::default().central_percent)]
    pub central_percent: f64,
    /// Stroke of a weave from side to side; the path is then its centre line.
    #[arg(long, value_name = "MM", requires_all = ["path", "weave_hz", "weave_across"])]
    pub weave_stroke_mm: Option<f64>,
    /// Frequency of the weave in full swings per second.
    #[arg(long, value_name = "HZ", requires = "weave_stroke_mm")]
    pub weave_hz: Option<f64>,
    /// Direction of the weave, e.g. 0,1,0.
    #[arg(long, value_name = "X,Y,Z", value_delimiter = ',', allow_hyphen_values = true)]
    pub weave_across: Vec<f64>,
}

impl Default for StreamOptions {
    fn default() -> Self {
        Self {
            format: None,
            text: TextFormat::default(),
            rate_hz: None,
            still_mm: 0.1,
            still_s: 0.2,
            near_mm: 10.0,
            band_mm: None,
            path: PathOptions::default(),
        }
    }
}

impl Default for PathOptions {
    fn default() -> Self {
        Self {
            path_points: 50,
            velocity_mm_s: None,
            central_percent: 50.0,
            weave_stroke_mm: None,
            weave_hz: None,
            weave_across: Vec::new(),
        }
    }
}

/// Tables of a recorded motion.
#[derive(Clone, Copy, Debug)]
pub struct RecordingTables<'a> {
    /// Recorded motion.
    pub recording: Table<'a>,
    /// Commanded poses at the standstills.
    pub commanded: Option<Table<'a>>,
    /// Commanded path.
    pub path: Option<Table<'a>>,
}

/// Evaluates a recorded motion (ISO 9283); `seed` is the seed of the bootstrap intervals.
///
/// # Errors
/// Fails if the recording does not contain the commanded motion.
pub fn iso9283_path(tables: &RecordingTables, options: &StreamOptions, seed: u64) -> Result<Iso9283StreamDocument> {
    Ok(evaluate(tables, options, seed)?.0)
}

/// Characteristics of a recorded motion, and the recording.
pub(crate) fn evaluate(
    tables: &RecordingTables,
    options: &StreamOptions,
    seed: u64,
) -> Result<(Iso9283StreamDocument, Recording)> {
    let statement = options.statement(tables.path.is_some());
    statement.check(|key| format!("--{}", key.replace('_', "-")))?;
    let recording = options.recording(tables.recording)?;
    let poses = tables.commanded.map(|table| poses(&options.beside(table)?)).transpose()?;
    let name = tables.recording.name();
    let path = tables.path.map(|table| stated_path(&options.beside(table)?, &name, &recording)).transpose()?;
    let document = Iso9283StreamDocument::evaluate(&recording, &statement.settings(poses, path, seed))?;
    Ok((document, recording))
}

impl StreamOptions {
    /// Reads a table that belongs to a recording. If columns or a format of another program are
    /// given, they apply to the recording alone.
    fn beside(&self, table: Table) -> Result<TableFile> {
        match self.format.is_none() && !self.text.in_order() {
            true => self.text.form().read(table),
            false => table.read(),
        }
    }

    fn statement(&self, path: bool) -> TestStatement<'_> {
        TestStatement {
            rate_hz: self.rate_hz,
            still_mm: self.still_mm,
            still_s: self.still_s,
            near_mm: self.near_mm,
            band_mm: self.band_mm,
            path,
            path_points: self.path.path_points,
            velocity_mm_s: self.path.velocity_mm_s,
            central_percent: self.path.central_percent,
            weave_stroke_mm: self.path.weave_stroke_mm,
            weave_hz: self.path.weave_hz,
            weave_across: &self.path.weave_across,
        }
    }

    fn recording(&self, table: Table) -> Result<Recording> {
        let stated = self.format.as_deref().map(|name| word("--format", name)).transpose()?;
        let stated = match stated {
            None if self.text.in_order() => Some(self.text.format()?),
            stated => stated,
        };
        let recorded = match stated {
            Some(format) => {
                let text = self.text.text(table, &format)?;
                let unit = self.text.unit(&format, &text)?;
                let points = |file: &str, text: &str| etalon_formats::recorded_points(file, text, &format, unit);
                TableFile::new(Path::new(&table.name()), text, points)?
            }
            None => self.text.form().read(table)?,
        };
        recording(&recorded.table, self.rate_hz).map_err(|p| recorded.place(p))
    }
}

fn stated_path(table: &TableFile, name: &str, recording: &Recording) -> Result<CommandedPath> {
    commanded_path(&table.table, name, recording).map_err(|p| table.place(p))
}

fn poses(table: &TableFile) -> Result<Vec<CommandedPose>> {
    commanded_poses(&table.table).map_err(|p| table.place(p))
}
