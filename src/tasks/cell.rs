//! Task of `etalon cell`.

use super::bound::BoundOption;
use super::checks::{angle_order, check_positive};
use super::inputs::Table;
use super::text_format::TableFormat;
use crate::stages::cell::{self, CellKind, CellMounting, CellStated};
use etalon_base::message::Result;
use etalon_documents::CellDocument;
use serde::Deserialize;

/// Options of a problem of a robot cell.
#[derive(Clone, Debug, clap::Args, Deserialize)]
pub struct CellOptions {
    /// Problem to solve.
    #[arg(long, value_enum, value_name = "KIND")]
    pub solve: CellKind,
    /// Order of the angles `flange_a_deg`, `flange_b_deg`, `flange_c_deg`: "zyx" (successively
    /// about the axes of the flange), "fixed xyz" ...
    #[arg(long, value_name = "ORDER")]
    pub orientation: Option<String>,
    /// Order of the angles `a_deg`, `b_deg`, `c_deg` of measured poses.
    #[arg(long, value_name = "ORDER")]
    pub measured_orientation: Option<String>,
    /// Part of the measuring system that is on the robot (hand-eye).
    #[arg(long, value_enum, value_name = "PART")]
    pub mounting: Option<CellMounting>,
    /// Standard uncertainty (k = 1) of a coordinate in micrometres, robot and measurement together;
    /// columns `ux_mm`, `uy_mm`, `uz_mm` add to it. By default from the residuals.
    #[arg(long, value_name = "UM")]
    pub standard_uncertainty_um: Option<f64>,
    /// Standard uncertainty (k = 1) of an orientation about any axis in degrees; by default from
    /// the residuals.
    #[arg(long, value_name = "DEG")]
    pub rotation_uncertainty_deg: Option<f64>,
    /// Bound of the uncertainties.
    #[command(flatten)]
    #[serde(flatten)]
    pub bound: BoundOption,
    /// Options for reading the table.
    #[command(flatten)]
    #[serde(flatten)]
    pub format: TableFormat,
}

/// Finds tool, work object, hand and eye, or an external axis.
///
/// # Errors
/// Fails if the table leaves a direction open.
pub fn cell(table: Table, options: &CellOptions) -> Result<CellDocument> {
    check_positive("--standard-uncertainty-um", options.standard_uncertainty_um)?;
    check_positive("--rotation-uncertainty-deg", options.rotation_uncertainty_deg)?;
    let stated = CellStated {
        solve: options.solve,
        order: angle_order("--orientation", options.orientation.as_deref())?,
        measured_order: angle_order("--measured-orientation", options.measured_orientation.as_deref())?,
        mounting: options.mounting,
        position_mm: options.standard_uncertainty_um.map(|u| u / 1000.0),
        rotation_rad: options.rotation_uncertainty_deg.map(f64::to_radians),
        columns: options.format.named()?,
        bound: options.bound.stated()?,
    };
    cell::cell(&options.format.read_poses(table)?, &stated)
}
