//! Command `etalon cell`.

use super::report::Reports;
use super::{Output, Verdict};
use crate::run::documents::read_cell;
use crate::tasks::{CellOptions, Table, cell};
use etalon_base::catalogue::Phrase;
use etalon_base::message::{Message, Result};
use etalon_base::pose::Vector;
use etalon_base::{error, phrase};
use etalon_controllers::cell::{self as controllers, CellText};
use etalon_documents::{CellDocument, CellFrameEntry, CellPointEntry, Presentation, to_json};
use etalon_report::{CellLines, Renderer};
use std::path::PathBuf;

/// Identify a tool, a work object, a camera (hand-eye) or an external axis from controller poses
/// and measurements.
#[derive(Debug, clap::Args)]
#[command(after_help = "Table, by --solve:
  tool-point      poses of the flange: flange_x_mm, flange_y_mm, flange_z_mm and an orientation
                  (flange_qw .. flange_qz, flange_rx_deg .., flange_a_deg .. with --orientation)
  tool-reflector  poses of the flange; x_mm, y_mm, z_mm of the reflector
  tool-axes       poses of the flange; point (tip, z, x)
  hand-eye        poses of the flange; measured poses: x_mm, y_mm, z_mm, qw .. (or rx_deg .., a_deg ..)
  object          nominal_x_mm, nominal_y_mm, nominal_z_mm; x_mm, y_mm, z_mm
  three-points    point (origin, x, xy or x1, x2, y1); x_mm, y_mm, z_mm
  linear-axis     axis_mm; x_mm, y_mm, z_mm; target
  rotary-axis     axis_deg; x_mm, y_mm, z_mm; target

Controllers, by answer:
  tool                  abb, kuka, fanuc, ur, yaskawa
  work object           abb, kuka, fanuc, ur
  base of the robot     abb-moc
  rotary axis           abb-moc, kuka, maxkins, 5axiskins
  two rotary axes       xyzac-trt-kins, xyzbc-trt-kins, grblhal")]
pub struct CellCommand {
    /// Table of the readings (CSV).
    table: PathBuf,
    #[command(flatten)]
    options: CellOptions,
    #[command(flatten)]
    data: ControllerOptions,
    #[command(flatten)]
    reports: Reports,
    /// Print the answer as JSON.
    #[arg(long)]
    json: bool,
}

/// Options of the data of a controller.
#[derive(Clone, Debug, clap::Args)]
struct ControllerOptions {
    /// Print the data of a controller instead of the text.
    #[arg(long, value_name = "MAKER", conflicts_with = "json", value_parser = etalon_controllers::cell::names().collect::<Vec<_>>())]
    controller: Option<String>,
    /// Name of the tool, object or mechanical unit in the data of the controller.
    #[arg(long, value_name = "NAME", requires = "controller", default_value = "etalon")]
    name: String,
    /// Number of the tool, base or external kinematic in the data of the controller.
    #[arg(long, value_name = "N", requires = "controller", default_value_t = 1)]
    number: u32,
    /// Answer of the second rotary axis of the same machine (JSON of this command).
    #[arg(long, value_name = "FILE", requires = "controller")]
    with: Option<PathBuf>,
    /// Length (mm) of the tool at whose end the first target is: a pivot length reaches to the
    /// gauge line.
    #[arg(long, value_name = "MM", requires = "controller")]
    tool_length_mm: Option<f64>,
    /// Write the data of an answer that must not be loaded; their header says so.
    #[arg(long, requires = "controller")]
    force: bool,
}

impl CellCommand {
    pub(super) fn run(self, out: &Output) -> anyhow::Result<Verdict> {
        self.check_tool_length()?;
        self.reports.check([Some(&self.table), self.data.with.as_ref()].into_iter().flatten())?;
        let document = cell(Table::File(&self.table), &self.options)?;
        let second = self.data.with.as_deref().map(read_cell).transpose()?;
        let of_second: Vec<Message> = second.iter().flat_map(CellDocument::errors).cloned().collect();
        let fit = document.errors().next().is_none() && of_second.is_empty();
        let lines = self.lines(&document, second)?.filter(|_| fit || self.data.force);
        if !self.json {
            out.remark(&document.messages);
            out.remark(&of_second);
            out.remark(lines.as_ref().map_or(&[], |lines| &lines.messages));
        }
        self.report(&document, lines.as_ref())?;
        match (lines, self.data.controller.as_deref()) {
            _ if self.json => out.print(to_json(&document)?)?,
            (Some(lines), _) => out.print(lines.text)?,
            (None, Some(maker)) => out.remark(&[error!("cell-data-withheld", maker)]),
            (None, None) => out.print_text(&text(&document))?,
        }
        Ok(Verdict::new(fit))
    }

    fn check_tool_length(&self) -> Result<()> {
        match self.data.tool_length_mm.is_none_or(|mm| mm >= 0.0 && mm.is_finite()) {
            true => Ok(()),
            false => Err(error!("option-not-positive", option = "--tool-length-mm").into()),
        }
    }

    /// Data of the given controller.
    fn lines(&self, document: &CellDocument, second: Option<CellDocument>) -> Result<Option<CellText>> {
        let Some(format) = self.data.controller.as_deref().and_then(controllers::by_name) else { return Ok(None) };
        let options = controllers::CellOptions {
            name: self.data.name.clone(),
            number: self.data.number,
            second,
            tool_length_mm: self.data.tool_length_mm,
        };
        controllers::write(format, document, &options).map(Some)
    }

    /// Writes the reports.
    fn report(&self, document: &CellDocument, lines: Option<&CellText>) -> Result<()> {
        let maker = self.data.controller.as_deref().unwrap_or_default();
        let lines = lines.map(|lines| CellLines { maker, text: &lines.text, messages: &lines.messages });
        let presentation = self.reports.over(Presentation::default())?;
        self.reports.write(&Renderer::cell(document, lines, presentation)?)
    }
}

fn vector(v: &[f64], decimals: usize) -> String {
    v.iter().map(|v| format!("{v:.decimals$}")).collect::<Vec<_>>().join(" ")
}

/// `yes` and standard uncertainties; `no` if they are unknown.
fn uncertainty(u: Option<Vector>, decimals: usize) -> (&'static str, String) {
    u.map_or(("no", String::new()), |u| ("yes", vector(&u, decimals)))
}

fn frame_lines(frame: &CellFrameEntry, lines: &mut Vec<Phrase>) {
    lines.push(phrase!("cell-frame", name = frame.name, reference = frame.reference));
    let (known, u) = uncertainty(frame.standard_uncertainty_mm, 4);
    lines.push(phrase!("cell-position", position = vector(&frame.xyz_mm, 4), known, u));
    let (known, u) = uncertainty(frame.standard_uncertainty_deg, 5);
    lines.push(phrase!("cell-quaternion", quaternion = vector(&frame.quaternion, 8), known, u));
}

fn point_lines(point: &CellPointEntry, lines: &mut Vec<Phrase>) {
    lines.push(phrase!("cell-point", name = point.name, reference = point.reference));
    let (known, u) = uncertainty(point.standard_uncertainty_mm, 4);
    lines.push(phrase!("cell-position", position = vector(&point.xyz_mm, 4), known, u));
}

/// The answer as text.
fn text(document: &CellDocument) -> String {
    let mut lines = Vec::new();
    document.frames.iter().for_each(|frame| frame_lines(frame, &mut lines));
    document.points.iter().for_each(|point| point_lines(point, &mut lines));
    if let Some(axis) = &document.axis {
        lines.push(phrase!("cell-axis", kind = if axis.prismatic { "linear" } else { "rotary" }));
        lines.push(phrase!("cell-direction", direction = vector(&axis.direction, 7)));
        let u = axis.scale_standard_uncertainty.map(|u| format!("{u:.7}"));
        let known = if u.is_some() { "yes" } else { "no" };
        lines.push(phrase!("cell-axis-scale", scale = format!("{:.7}", axis.scale), known, u = u.unwrap_or_default()));
    }
    for noise in &document.noise {
        let Some(deviation) = noise.standard_deviation else { continue };
        lines.push(phrase!(
            "cell-residuals",
            measure = noise.measure,
            deviation = format!("{deviation:.5}"),
            redundancy = format!("{:.0}", noise.redundancy),
            source = noise.uncertainties_from
        ));
    }
    for measure in ["position", "orientation"] {
        let own = document.residuals.iter().filter(|r| r.measure == measure);
        let worst = own.max_by(|a, b| a.length.total_cmp(&b.length));
        lines.extend(worst.map(|worst| {
            phrase!("cell-largest-residual", measure, length = format!("{:.5}", worst.length), line = worst.line)
        }));
    }
    lines.into_iter().map(|line| format!("{line}\n")).collect()
}
