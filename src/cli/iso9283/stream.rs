//! `etalon iso9283 --stream`

use super::super::table_file::TableFile;
use super::super::text_format::{TextFormat, word};
use super::super::{Verdict, print, say};
use crate::base::files;
use crate::base::message::Result;
use crate::base::pose::Vector;
use crate::base::table::ANGLES;
use crate::base::table::XYZ;
use crate::document::{Iso9283Interval, Iso9283Path, Iso9283StreamDocument};
use crate::import;
use crate::import::tables::recording::{commanded_path, commanded_poses, recording};
use crate::iso9283::motion::stream::Recording;
use crate::iso9283::motion::{Stated, evaluate};
use crate::iso9283::path::commanded::CommandedPath;
use crate::run::output;
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// A recorded motion.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Recorded motion")]
pub(super) struct StreamOptions {
    /// Recorded motion: time_s,x_mm,y_mm[,z_mm][,a_deg][,b_deg][,c_deg], or any text whose --columns and --unit are stated
    #[arg(long, value_name = "FILE")]
    pub stream: Option<PathBuf>,
    /// Format of the recording, e.g. spatialanalyzer: no columns are to be stated then, --unit and the rate are
    #[arg(long, value_name = "NAME", requires_all = ["stream", "rate_hz"], conflicts_with = "columns")]
    format: Option<String>,
    #[command(flatten)]
    text: TextFormat,
    /// Sampling rate of the recording, instead of its time stamps: those of some exports are full seconds
    #[arg(long, value_name = "HZ", requires = "stream")]
    rate_hz: Option<f64>,
    /// Standing: all positions within this distance of their mean
    #[arg(long, value_name = "MM", default_value_t = 0.1)]
    still_mm: f64,
    /// Standing: for at least this time
    #[arg(long, value_name = "S", default_value_t = 0.2)]
    still_s: f64,
    /// How near a standstill is to its pose, and an attained path to the commanded one
    #[arg(long, value_name = "MM", default_value_t = 10.0)]
    near_mm: f64,
    /// Limit band about the attained pose, for stabilisation time, overshoot, posing time; about a leg after its corner
    #[arg(long, value_name = "MM", requires = "stream")]
    band_mm: Option<f64>,
    /// Write the standstills as a table of poses, which `etalon iso9283 FILE` evaluates
    #[arg(long, value_name = "FILE", requires = "stream")]
    write_poses: Option<PathBuf>,
    /// Commanded path: the recording's columns without time, a row a point
    #[arg(long, value_name = "FILE", requires = "stream")]
    path: Option<PathBuf>,
    /// Command points on the path, at whose normal planes passes are compared
    #[arg(long, value_name = "N", default_value_t = 50)]
    path_points: usize,
    /// Commanded velocity on the path
    #[arg(long, value_name = "MM_S", requires = "path")]
    velocity_mm_s: Option<f64>,
    /// Central part of the path over which velocities are compared, in per cent
    #[arg(long, value_name = "PERCENT", default_value_t = 50.0)]
    central_percent: f64,
    /// The path is the centre line of a weave with this stroke from side to side
    #[arg(long, value_name = "MM", requires_all = ["path", "weave_hz", "weave_across"])]
    weave_stroke_mm: Option<f64>,
    /// Swings there and back by second
    #[arg(long, value_name = "HZ", requires = "weave_stroke_mm")]
    weave_hz: Option<f64>,
    /// The way it swings, e.g. 0,1,0
    #[arg(long, value_name = "X,Y,Z", value_delimiter = ',', allow_hyphen_values = true)]
    weave_across: Vec<f64>,
}

impl StreamOptions {
    pub fn run(&self, file: &Path, commanded: Option<&Path>, (seed, json): (u64, bool)) -> anyhow::Result<Verdict> {
        let stated = self.stated();
        stated.check(|key| format!("--{}", key.replace('_', "-")))?;
        let recording = self.recording(file)?;
        let poses = commanded.map(poses).transpose()?;
        let path = self.path.as_deref().map(|path| read_path(path, (file, &recording))).transpose()?;
        let settings = stated.settings(poses, path, seed);
        let document = evaluate(&recording, &settings)?;
        if let Some(path) = &self.write_poses {
            files::write(path, csv(&document, &recording).as_bytes())?;
        }
        for message in &document.messages {
            say(format_args!("{message}\n"));
        }
        print(if json { output::to_json(&document)? } else { as_text(&document, true).into_bytes() })?;
        Ok(Verdict::Met)
    }

    fn stated(&self) -> Stated<'_> {
        Stated {
            rate_hz: self.rate_hz,
            still_mm: self.still_mm,
            still_s: self.still_s,
            near_mm: self.near_mm,
            band_mm: self.band_mm,
            path: self.path.is_some(),
            path_points: self.path_points,
            velocity_mm_s: self.velocity_mm_s,
            central_percent: self.central_percent,
            weave_stroke_mm: self.weave_stroke_mm,
            weave_hz: self.weave_hz,
            weave_across: &self.weave_across,
        }
    }

    fn recording(&self, path: &Path) -> Result<Recording> {
        let stated = self.format.as_deref().map(|name| word("--format", name)).transpose()?;
        let stated = match stated {
            None if self.text.stated() => Some(self.text.format()?),
            stated => stated,
        };
        let recorded = match stated {
            Some(format) => {
                let unit = self.text.unit()?;
                TableFile::read_with(path, |file, text| import::recorded_points(file, text, &format, unit))?
            }
            None => TableFile::read(path)?,
        };
        recording(recorded.named(), self.rate_hz).map_err(|p| recorded.place(p))
    }
}

fn read_path(path: &Path, (of, recording): (&Path, &Recording)) -> Result<CommandedPath> {
    let table = TableFile::read(path)?;
    commanded_path(table.named(), &of.display().to_string(), recording).map_err(|p| table.place(p))
}

fn poses(path: &Path) -> Result<Vec<(i64, Vector)>> {
    let table = TableFile::read(path)?;
    commanded_poses(table.named()).map_err(|p| table.place(p))
}

/// Standstills at poses as a table of poses.
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

/// What a terminal shows; with `all`, a row for each standstill.
pub(in crate::cli) fn as_text(document: &Iso9283StreamDocument, all: bool) -> String {
    let mut text = format!("{} samples, {:.3} s\n", document.samples, document.duration_s);
    let number = |v: Option<f64>| v.map_or_else(|| "-".to_owned(), |v| format!("{v:.4}"));
    let whole = |v: Option<i64>| v.map_or_else(|| "-".to_owned(), |v| v.to_string());
    let standstills = if all { &document.standstills[..] } else { &[] };
    if !standstills.is_empty() {
        let _ = writeln!(
            text,
            "{:>5} {:>6} {:>10} {:>10} {:>9} {:>12} {:>12} {:>9}",
            "pose", "cycle", "from s", "to s", "noise mm", "settles s", "overshoot mm", "posing s"
        );
    }
    for s in standstills {
        let _ = writeln!(
            text,
            "{:>5} {:>6} {:>10.3} {:>10.3} {:>9} {:>12} {:>12} {:>9}",
            whole(s.pose),
            whole(s.cycle),
            s.from_s,
            s.to_s,
            number(s.noise_mm),
            number(s.stabilisation_s),
            number(s.overshoot_mm),
            number(s.posing_s)
        );
    }
    for s in &document.settling {
        let _ = writeln!(
            text,
            "pose {}: stabilisation time {:.4} s, overshoot {:.4} mm, {} arrivals",
            s.pose, s.stabilisation_s, s.overshoot_mm, s.arrivals
        );
    }
    for p in &document.posing {
        let _ = writeln!(
            text,
            "pose {} to {}: {:.3} mm in {:.4} s, {} moves",
            p.from, p.to, p.distance_mm, p.posing_s, p.moves
        );
    }
    if let Some(path) = &document.path {
        path_lines(&mut text, path);
    }
    if let Some(w) = &document.weaving {
        let _ = writeln!(
            text,
            "weaving: stroke {:.4} mm (WS {:+.3} %), frequency {:.4} Hz (WF {:+.3} %), {} passes",
            w.stroke_mm, w.ws_percent, w.frequency_hz, w.wf_percent, w.passes
        );
    }
    text
}

fn interval(i: &Option<Iso9283Interval>) -> String {
    i.map_or_else(String::new, |i| format!(" [{:.4}, {:.4}]", i.low_mm, i.high_mm))
}

fn path_lines(text: &mut String, path: &Iso9283Path) {
    let clause = if path.reorientation { " on reorientation" } else { "" };
    let left = if path.incomplete > 0 { format!(" ({} more not ended)", path.incomplete) } else { String::new() };
    let _ = write!(
        text,
        "path of {:.3} mm, {} passes{left}: AT{clause} {:.4} mm{} at {:.3} mm",
        path.length_mm,
        path.passes,
        path.at_mm,
        interval(&path.at_interval),
        path.at_along_mm
    );
    if let (Some(rt), Some(along)) = (path.rt_mm, path.rt_along_mm) {
        let _ = write!(text, ", RT {rt:.4} mm{} at {along:.3} mm", interval(&path.rt_interval));
    }
    text.push('\n');
    for (name, angles) in [("AT", &path.at_angles_deg), ("RT", &path.rt_angles_deg)] {
        if !angles.is_empty() {
            let angles: Vec<String> = angles.iter().map(|a| format!("{a:.5}")).collect();
            let _ = writeln!(text, "  {name} of angles: {} deg", angles.join(", "));
        }
    }
    if let Some(v) = &path.velocity {
        let rv = v.rv_percent.map(|rv| format!(", RV {rv:.3} %")).unwrap_or_default();
        let _ = writeln!(
            text,
            "  velocity {:.3} mm/s: AV {:+.3} %{rv}, FV {:.3} mm/s",
            v.mean_mm_s, v.av_percent, v.fv_mm_s
        );
    }
    for c in &path.corners {
        let at: Vec<String> = c.position_mm.iter().map(|x| format!("{x:.3}")).collect();
        let stable = c.stabilisation_mm.map(|s| format!(", stable after {s:.3} mm")).unwrap_or_default();
        let _ =
            writeln!(text, "  corner {}: round-off {:.4}, overshoot {:.4} mm{stable}", at.join(" "), c.cr_mm, c.co_mm);
    }
}
