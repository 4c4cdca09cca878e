//! Command `etalon iso9283 path`.

use super::super::inputs::Table;
use super::super::table_file::TableFile;
use super::super::text_format::{TextForm, TextFormat, word};
use super::super::{Verdict, answer, remark};
use crate::stages::iso9283::stated::TestStatement;
use etalon_base::files;
use etalon_base::message::Result;
use etalon_documents::{Characteristics, Iso9283NamedStream, Iso9283StreamDocument, Iso9283StreamsDocument, to_json};
use etalon_formats::table::ANGLES;
use etalon_formats::table::XYZ;
use etalon_formats::tables::recording::{commanded_path, commanded_poses, recording};
use etalon_report::Renderer;
use etalon_standards::iso9283::motion::stream::Recording;
use etalon_standards::iso9283::path::commanded::CommandedPath;
use etalon_standards::iso9283::pose::test::CommandedPose;
use std::path::{Path, PathBuf};

/// Options of a recorded motion.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Recorded motion")]
pub(super) struct StreamOptions {
    /// Format of the recording, e.g. spatialanalyzer; replaces --columns, but needs --unit and
    /// --rate-hz.
    #[arg(long, value_name = "NAME", requires_all = ["stream", "rate_hz"], conflicts_with = "columns")]
    format: Option<String>,
    #[command(flatten)]
    text: TextFormat,
    /// Sampling rate of the recording, which replaces time stamps; some exports state full seconds
    /// only.
    #[arg(long, value_name = "HZ", requires = "stream")]
    rate_hz: Option<f64>,
    /// Standstill: largest distance of positions from their mean.
    #[arg(long, value_name = "MM", default_value_t = 0.1)]
    still_mm: f64,
    /// Standstill: minimum duration.
    #[arg(long, value_name = "S", default_value_t = 0.2)]
    still_s: f64,
    /// Largest distance of a standstill from its pose, and of an attained path from the commanded
    /// path.
    #[arg(long, value_name = "MM", default_value_t = 10.0)]
    near_mm: f64,
    /// Limit band about the attained pose, for stabilisation time, overshoot and posing time; about
    /// a leg after its corner.
    #[arg(long, value_name = "MM", requires = "stream")]
    band_mm: Option<f64>,
    /// Write the standstills as a table of poses for `etalon iso9283 FILE`.
    #[arg(long, value_name = "FILE", requires = "stream")]
    write_poses: Option<PathBuf>,
    #[command(flatten)]
    path_options: PathOptions,
}

/// Options of a commanded path, and of a weave about it.
#[derive(Clone, Debug, clap::Args)]
struct PathOptions {
    /// Commanded path: the columns of the recording without time, with one row per point.
    #[arg(long, value_name = "FILE", requires = "stream")]
    path: Option<PathBuf>,
    /// Number of command points on the path, in whose normal planes passes are compared.
    #[arg(long, value_name = "N", default_value_t = 50)]
    path_points: usize,
    /// Commanded velocity on the path.
    #[arg(long, value_name = "MM_S", requires = "path")]
    velocity_mm_s: Option<f64>,
    /// Central part of the path in which velocities are evaluated (%).
    #[arg(long, value_name = "PERCENT", default_value_t = 50.0)]
    central_percent: f64,
    /// Stroke of a weave from side to side; the path is then its centre line.
    #[arg(long, value_name = "MM", requires_all = ["path", "weave_hz", "weave_across"])]
    weave_stroke_mm: Option<f64>,
    /// Frequency of the weave in full swings per second.
    #[arg(long, value_name = "HZ", requires = "weave_stroke_mm")]
    weave_hz: Option<f64>,
    /// Direction of the weave, e.g. 0,1,0.
    #[arg(long, value_name = "X,Y,Z", value_delimiter = ',', allow_hyphen_values = true)]
    weave_across: Vec<f64>,
}

impl StreamOptions {
    pub fn run(&self, file: &Path, commanded: Option<&Path>, seed: u64, json: bool) -> anyhow::Result<Verdict> {
        let stated = self.stated();
        stated.check(|key| format!("--{}", key.replace('_', "-")))?;
        let inputs =
            [Some(file), commanded, self.path_options.path.as_deref()].into_iter().flatten().map(Path::to_owned);
        files::refuse_overwriting(&self.write_poses, &inputs.collect::<Vec<_>>())?;
        let recording = self.recording(file)?;
        // columns or a format in the form of another program are those of the recording alone
        let is_own = self.format.is_none() && !self.text.in_order();
        let read = |path: &Path| if is_own { self.form().read(path) } else { TableFile::read(path) };
        let poses = commanded.map(|path| poses(&read(path)?)).transpose()?;
        let of = file.display().to_string();
        let path =
            self.path_options.path.as_deref().map(|path| stated_path(&read(path)?, &of, &recording)).transpose()?;
        let settings = stated.settings(poses, path, seed);
        let document = Iso9283StreamDocument::evaluate(&recording, &settings)?;
        if let Some(path) = &self.write_poses {
            files::write(path, csv(&document, &recording).as_bytes())?;
        }
        remark(&document.messages);
        let json = json.then(|| to_json(&document)).transpose()?;
        let name = file.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let stream =
            Iso9283NamedStream { name, file: file.display().to_string(), band_mm: self.band_mm, stream: document };
        let streams = Iso9283StreamsDocument { schema: String::new(), streams: vec![stream] };
        answer(&Renderer::test(&Characteristics { streams: Some(streams), ..Characteristics::default() }), json)
    }

    /// Options of tables.
    pub fn form(&self) -> &TextForm {
        self.text.form()
    }

    /// The answer from a recording, commanded poses and a commanded path in memory.
    pub fn in_memory(
        &self,
        recorded: &Table,
        commanded: Option<&Table>,
        path: Option<&Table>,
        seed: u64,
    ) -> Result<Iso9283StreamDocument> {
        let stated = TestStatement { path: path.is_some(), ..self.stated() };
        stated.check(|key| format!("--{}", key.replace('_', "-")))?;
        let table = recorded.parse()?;
        let recording = recording(&table.table, self.rate_hz).map_err(|p| table.place(p))?;
        let poses = commanded.map(|table| poses(&table.parse()?)).transpose()?;
        let path = path.map(|path| stated_path(&path.parse()?, recorded.name, &recording)).transpose()?;
        Iso9283StreamDocument::evaluate(&recording, &stated.settings(poses, path, seed))
    }

    fn stated(&self) -> TestStatement<'_> {
        TestStatement {
            rate_hz: self.rate_hz,
            still_mm: self.still_mm,
            still_s: self.still_s,
            near_mm: self.near_mm,
            band_mm: self.band_mm,
            path: self.path_options.path.is_some(),
            path_points: self.path_options.path_points,
            velocity_mm_s: self.path_options.velocity_mm_s,
            central_percent: self.path_options.central_percent,
            weave_stroke_mm: self.path_options.weave_stroke_mm,
            weave_hz: self.path_options.weave_hz,
            weave_across: &self.path_options.weave_across,
        }
    }

    fn recording(&self, path: &Path) -> Result<Recording> {
        let stated = self.format.as_deref().map(|name| word("--format", name)).transpose()?;
        let stated = match stated {
            None if self.text.in_order() => Some(self.text.format()?),
            stated => stated,
        };
        let recorded = match stated {
            Some(format) => {
                let unit = self.text.unit()?;
                let text = self.text.text(path, &format)?;
                let points = |file: &str, text: &str| etalon_formats::recorded_points(file, text, &format, unit);
                TableFile::new(path, text, points)?
            }
            None => self.form().read(path)?,
        };
        recording(&recorded.table, self.rate_hz).map_err(|p| recorded.place(p))
    }
}

fn stated_path(table: &TableFile, of: &str, recording: &Recording) -> Result<CommandedPath> {
    commanded_path(&table.table, of, recording).map_err(|p| table.place(p))
}

fn poses(table: &TableFile) -> Result<Vec<CommandedPose>> {
    commanded_poses(&table.table).map_err(|p| table.place(p))
}

/// Table of poses from the standstills at poses.
fn csv(document: &Iso9283StreamDocument, recording: &Recording) -> String {
    let axes = if recording.spatial { 3 } else { 2 };
    let columns = XYZ[..axes].iter().copied().chain(recording.angles.iter().map(|&k| ANGLES[k]));
    let mut text = format!("pose,cycle,{}\n", columns.collect::<Vec<_>>().join(","));
    for s in &document.standstills {
        if let (Some(pose), Some(cycle)) = (s.pose, s.cycle) {
            let cells: Vec<String> = s.mean_mm.iter().chain(&s.mean_deg).map(f64::to_string).collect();
            text += &format!("{pose},{cycle},{}\n", cells.join(","));
        }
    }
    text
}
