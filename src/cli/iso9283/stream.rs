//! Command `etalon iso9283 path`.

use super::Evaluated;
use crate::tasks::{RecordingTables, StreamOptions, Table, evaluate_path};
use etalon_base::files;
use etalon_documents::{Characteristics, Iso9283NamedStream, Iso9283StreamDocument, Iso9283StreamsDocument, to_json};
use etalon_formats::table::{ANGLES, XYZ};
use etalon_standards::iso9283::motion::stream::Recording;
use std::path::{Path, PathBuf};

/// Options and files of a recorded motion.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Recorded motion")]
pub(super) struct Motion {
    #[command(flatten)]
    pub options: StreamOptions,
    /// Write the standstills as a table of poses for `etalon iso9283 FILE`.
    #[arg(long, value_name = "FILE", requires = "stream")]
    write_poses: Option<PathBuf>,
    /// Commanded path: the columns of the recording without time, with one row per point.
    #[arg(long, value_name = "FILE", requires = "stream")]
    path: Option<PathBuf>,
}

impl Motion {
    pub fn evaluate(&self, file: &Path, commanded: Option<&Path>, seed: u64) -> anyhow::Result<Evaluated> {
        let inputs = [Some(file), commanded, self.path.as_deref()].into_iter().flatten().map(Path::to_owned);
        files::refuse_overwriting(&self.write_poses, &inputs.collect::<Vec<_>>())?;
        let tables = RecordingTables {
            recording: Table::File(file),
            commanded: commanded.map(Table::File),
            path: self.path.as_deref().map(Table::File),
        };
        let (document, recording) = evaluate_path(&tables, &self.options, seed)?;
        if let Some(path) = &self.write_poses {
            files::write(path, csv(&document, &recording).as_bytes())?;
        }
        let (messages, json) = (document.messages.clone(), to_json(&document)?);
        let name = file.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let stream = Iso9283NamedStream {
            name,
            file: file.display().to_string(),
            band_mm: self.options.band_mm,
            stream: document,
        };
        let streams = Iso9283StreamsDocument { schema: String::new(), streams: vec![stream] };
        Ok(Evaluated {
            messages,
            tested: Characteristics { streams: Some(streams), ..Characteristics::default() },
            json,
        })
    }
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
