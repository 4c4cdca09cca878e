//! Command `etalon cell`.

use super::text_format::TableFormat;
use super::{Verdict, check_positive, print, print_text, remark};
use crate::stages::cell::{self, CellKind, CellMounting, CellStated};
use crate::stages::orientations::AngleOrder;
use etalon_base::error;
use etalon_base::message::{Message, Place, Problems, Result};
use etalon_base::pose::Vector;
use etalon_controllers::cell::{CellData, CellFormat};
use etalon_documents::{CellDocument, CellFrameEntry, CellPointEntry, to_json};
use std::fmt::Write;
use std::path::PathBuf;

/// Find tool, work object, hand and eye, or an external axis from controller poses and
/// measurements.
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
  rotary-axis     axis_deg; x_mm, y_mm, z_mm; target")]
pub struct CellCommand {
    /// Table of the readings (CSV).
    table: PathBuf,
    /// Problem to solve.
    #[arg(long, value_enum, value_name = "KIND")]
    solve: CellKind,
    /// Order of the angles `flange_a_deg`, `flange_b_deg`, `flange_c_deg`: "zyx" (successively
    /// about the axes of the flange), "fixed xyz" ...
    #[arg(long, value_name = "ORDER")]
    orientation: Option<String>,
    /// Order of the angles `a_deg`, `b_deg`, `c_deg` of measured poses.
    #[arg(long, value_name = "ORDER")]
    measured_orientation: Option<String>,
    /// Part of the measuring system that is on the robot (hand-eye).
    #[arg(long, value_enum, value_name = "PART")]
    mounting: Option<CellMounting>,
    /// Standard uncertainty (k = 1) of a coordinate in micrometres, robot and measurement together;
    /// columns `ux_mm`, `uy_mm`, `uz_mm` add to it. By default from the residuals.
    #[arg(long, value_name = "UM")]
    standard_uncertainty_um: Option<f64>,
    /// Standard uncertainty (k = 1) of an orientation about any axis in degrees; by default from
    /// the residuals.
    #[arg(long, value_name = "DEG")]
    rotation_uncertainty_deg: Option<f64>,
    /// Print the data of a controller instead of the text.
    #[arg(long, value_name = "MAKER", conflicts_with = "json", value_parser = etalon_controllers::cell::names().collect::<Vec<_>>())]
    controller: Option<String>,
    /// Name of the tool or object in the data of the controller.
    #[arg(long, value_name = "NAME", requires = "controller", default_value = "etalon")]
    name: String,
    /// Number of the tool or base in the data of the controller.
    #[arg(long, value_name = "N", requires = "controller", default_value_t = 1)]
    number: u32,
    #[command(flatten)]
    format: TableFormat,
    /// Print the answer as JSON.
    #[arg(long)]
    json: bool,
}

/// Order of angles of an option.
fn order(option: &str, text: Option<&str>) -> Result<Option<AngleOrder>> {
    let order = text.map(str::parse).transpose();
    order.map_err(|m: Message| Problems::from(m.at(Place::file(option))))
}

impl CellCommand {
    pub(super) fn run(self) -> anyhow::Result<Verdict> {
        check_positive("--standard-uncertainty-um", self.standard_uncertainty_um)?;
        check_positive("--rotation-uncertainty-deg", self.rotation_uncertainty_deg)?;
        let stated = CellStated {
            solve: self.solve,
            order: order("--orientation", self.orientation.as_deref())?,
            measured_order: order("--measured-orientation", self.measured_orientation.as_deref())?,
            mounting: self.mounting,
            position_mm: self.standard_uncertainty_um.map(|u| u / 1000.0),
            rotation_rad: self.rotation_uncertainty_deg.map(f64::to_radians),
        };
        let file = self.format.read_poses(&self.table)?;
        let document = cell::cell(&file, &stated)?;
        if !self.json {
            remark(&document.messages);
        }
        match self.controller.as_deref().and_then(etalon_controllers::cell::by_name) {
            _ if self.json => print(to_json(&document)?)?,
            Some(format) => print(self.data(format, &document)?)?,
            None => print_text(&text(&document))?,
        }
        Ok(Verdict::Met)
    }

    /// Data of a controller.
    fn data(&self, format: &dyn CellFormat, document: &CellDocument) -> Result<String> {
        CellData::new(document, &self.name, self.number)
            .map(|data| format.text(&data))
            .ok_or_else(|| error!("cell-no-controller-data", solve = document.solve).into())
    }
}

fn vector(v: &[f64], decimals: usize) -> String {
    v.iter().map(|v| format!("{v:.decimals$}")).collect::<Vec<_>>().join(" ")
}

/// Standard uncertainties in parentheses, if they are known.
fn uncertain(u: Option<Vector>, decimals: usize, unit: &str) -> String {
    u.map_or(String::new(), |u| format!("  (u = {} {unit})", vector(&u, decimals)))
}

fn frame_text(frame: &CellFrameEntry, text: &mut String) {
    let _ = writeln!(text, "{} in {}", frame.name, frame.reference);
    let u = uncertain(frame.standard_uncertainty_mm, 4, "mm");
    let _ = writeln!(text, "  position     {} mm{u}", vector(&frame.xyz_mm, 4));
    let u = uncertain(frame.standard_uncertainty_deg, 5, "deg about x y z");
    let _ = writeln!(text, "  quaternion   {}{u}", vector(&frame.quaternion, 8));
}

fn point_text(point: &CellPointEntry, text: &mut String) {
    let u = uncertain(point.standard_uncertainty_mm, 4, "mm");
    let _ = writeln!(
        text,
        "{} point in {}\n  position     {} mm{u}",
        point.name,
        point.reference,
        vector(&point.xyz_mm, 4)
    );
}

/// The answer as text.
fn text(document: &CellDocument) -> String {
    let mut text = String::new();
    document.frames.iter().for_each(|frame| frame_text(frame, &mut text));
    document.points.iter().for_each(|point| point_text(point, &mut text));
    if let Some(axis) = &document.axis {
        let _ = writeln!(text, "{} axis", if axis.prismatic { "linear" } else { "rotary" });
        let _ = writeln!(text, "  direction    {}", vector(&axis.direction, 7));
        let u = axis.scale_standard_uncertainty.map_or(String::new(), |u| format!("  (u = {u:.7})"));
        let _ = writeln!(text, "  scale        {:.7} x axis value{u}", axis.scale);
    }
    for noise in &document.noise {
        let unit = if noise.measure == "position" { "mm" } else { "deg" };
        let Some(deviation) = noise.standard_deviation else { continue };
        let (from, redundancy) = (&noise.uncertainties_from, noise.redundancy);
        let _ = writeln!(
            text,
            "{} residuals: standard deviation {deviation:.5} {unit}, redundancy {redundancy:.0}; uncertainties from {from}",
            noise.measure
        );
    }
    let worst = |measure: &str| {
        let own = document.residuals.iter().filter(|r| r.measure == measure);
        own.max_by(|a, b| a.length.total_cmp(&b.length)).map(|r| (r.line, r.length))
    };
    for (measure, unit) in [("position", "mm"), ("orientation", "deg")] {
        if let Some((line, length)) = worst(measure) {
            let _ = writeln!(text, "largest {measure} residual: {length:.5} {unit}, line {line}");
        }
    }
    text
}
