//! Command `etalon iso230`.

use super::{Output, Verdict};
use crate::tasks::{Table, TableFormat, evaluate_axis};
use etalon_base::phrase;
use etalon_controllers::axis_tables;
use etalon_documents::{AxisPositioning, to_json};
use std::path::PathBuf;

/// Evaluate positioning accuracy and repeatability of a linear axis (ISO 230-2:2014), or write its
/// compensation table.
#[derive(Debug, clap::Args)]
#[command(after_help = "Table:
  position_mm (programmed), measured_mm, direction (approach: +1 or -1);
  each position at least twice in each direction (five times to ISO 230-2)")]
pub struct Iso230 {
    /// Table of measured positions (CSV).
    #[arg(value_name = "TABLE")]
    table: PathBuf,
    /// Options for reading the table.
    #[command(flatten)]
    format: TableFormat,
    /// Print this compensation table instead.
    #[arg(long, value_name = "CONTROLLER", conflicts_with = "json")]
    compensation: Option<Controller>,
    /// Name of the axis in the compensation table.
    #[arg(long, value_name = "NAME", default_value = "X1", value_parser = axis_name)]
    axis: String,
    /// Print JSON.
    #[arg(long)]
    json: bool,
}

/// Checks that a name consists of letters and digits, so that it cannot end a line of a table.
fn axis_name(name: &str) -> std::result::Result<String, String> {
    let word = !name.is_empty() && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
    word.then(|| name.to_owned()).ok_or_else(|| phrase!("axis-name-expected").to_string())
}

#[derive(Clone, Copy, Debug, clap::ValueEnum)]
enum Controller {
    /// LinuxCNC: COMP_FILE with COMP_FILE_TYPE = 0.
    Linuxcnc,
    /// Beckhoff CNC: kw.ssfk; its sign is not confirmed on a control.
    Beckhoff,
    /// SINUMERIK: $AA_ENC_COMP; not tried on a control.
    Sinumerik,
}

impl Iso230 {
    pub(super) fn run(self, out: &Output) -> anyhow::Result<Verdict> {
        let file = self.format.read_other(Table::File(&self.table))?;
        let (document, deviations) = evaluate_axis(&file)?;
        out.remark(&document.messages);
        let header = |units: &str| axis_tables::header([], units, "the measured positions", file.text().as_bytes());
        match self.compensation {
            Some(Controller::Linuxcnc) => out.print(axis_tables::linuxcnc(&deviations)?)?,
            Some(Controller::Beckhoff) => {
                let header = header("measured minus programmed in 0.1 um");
                out.print(axis_tables::beckhoff(&deviations, &self.axis, &header))?;
            }
            Some(Controller::Sinumerik) => {
                let reversal = document.axis.mean_reversal_mm;
                let units = format!("mm, mean of both directions; without the mean reversal error of {reversal:.6} mm");
                out.print(axis_tables::sinumerik(&deviations, &self.axis, &header(&units))?)?;
            }
            None if self.json => out.print(to_json(&document)?)?,
            None => out.print(text(&document.axis))?,
        }
        Ok(Verdict::Met)
    }
}

fn text(axis: &AxisPositioning) -> String {
    let rows = [
        (phrase!("iso230-accuracy"), axis.accuracy),
        (phrase!("iso230-systematic"), axis.systematic),
        (phrase!("iso230-repeatability"), axis.repeatability),
    ];
    let heads = [phrase!("iso230-both"), phrase!("iso230-positive"), phrase!("iso230-negative")];
    let [both, positive, negative] = heads.map(|head| head.to_string());
    let mut out = format!("{:<32}{both:>14}{positive:>14}{negative:>14}\n", "ISO 230-2:2014, mm");
    for (name, of) in rows.map(|(name, of)| (name.to_string(), of)) {
        out += &format!("{name:<32}{:>14.6}{:>14.6}{:>14.6}\n", of.both_mm, of.forward_mm, of.backward_mm);
    }
    let single = [
        (phrase!("iso230-mean-systematic"), axis.mean_systematic_mm),
        (phrase!("iso230-reversal"), axis.reversal_mm),
        (phrase!("iso230-mean-reversal"), axis.mean_reversal_mm),
    ];
    for (name, value) in single.map(|(name, value)| (name.to_string(), value)) {
        out += &format!("{name:<32}{value:>14.6}\n");
    }
    out
}
