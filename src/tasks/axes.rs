//! Task of `etalon axes`.

use super::bound::BoundOption;
use super::checks::check_positive;
use super::inputs::Table;
use super::text_format::TableFormat;
use crate::stages::sweeps::{self, SweepsStated, TableConvention};
use etalon_base::message::Result;
use etalon_documents::AxesDocument;
use etalon_formats::table::XYZ;
use serde::Deserialize;

/// Options of the axes of joints.
#[derive(Clone, Debug, Default, clap::Args, Deserialize)]
#[serde(default)]
pub struct AxesOptions {
    /// Joints from the base; by default in the order of their numbers (q1, q2 ...).
    #[arg(long, value_name = "NAME,...", value_delimiter = ',')]
    pub joints: Vec<String>,
    /// Prismatic joints without a column of joint values, whose unit shows the type; all others are
    /// revolute.
    #[arg(long, value_name = "NAME,...", value_delimiter = ',')]
    pub prismatic: Vec<String>,
    /// Joints that were swept in negative direction, without joint values.
    #[arg(long, value_name = "NAME,...", value_delimiter = ',')]
    pub backwards: Vec<String>,
    /// Standard uncertainty (k = 1) of a measured coordinate in micrometres; by default from the
    /// residuals of each sweep.
    #[arg(long, value_name = "UM")]
    pub standard_uncertainty_um: Option<f64>,
    /// Convention of robot.toml.
    #[arg(long, value_enum, default_value_t)]
    pub convention: TableConvention,
    /// Bound of the uncertainties.
    #[command(flatten)]
    #[serde(flatten)]
    pub bound: BoundOption,
    /// Write robot.toml of sweeps whose unit is named as wrong, or whose uncertainty exceeds its
    /// bound.
    #[arg(long)]
    pub force: bool,
    /// Options for reading the table.
    #[command(flatten)]
    #[serde(flatten)]
    pub format: TableFormat,
}

/// Finds the axes of joints from sweeps of one joint at a time.
///
/// # Errors
/// Fails if a sweep determines no axis.
pub fn axes(table: Table, options: &AxesOptions) -> Result<AxesDocument> {
    check_positive("--standard-uncertainty-um", options.standard_uncertainty_um)?;
    let stated = SweepsStated {
        joints: options.joints.clone(),
        prismatic: options.prismatic.clone(),
        backwards: options.backwards.clone(),
        standard_uncertainty_mm: options.standard_uncertainty_um.map(|u| u / 1000.0),
        convention: options.convention,
        source_of_x: options.format.source(XYZ[0])?,
        force: options.force,
        bound: options.bound.stated()?,
    };
    sweeps::axes(&options.format.read_poses(table)?, &stated)
}
