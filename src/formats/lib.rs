//! Import of files of measuring systems and controllers as points and joint values.
//!
//! No input is repaired without a message. A row that means "not measured" is rejected by a rule
//! and listed. Anything else that differs from the given format is an error with its place, and one
//! run reports all errors.
#![allow(non_snake_case)] // world_T_base: frames in names

#[cfg(not(feature = "schemas"))]
extern crate etalon_schemaless as schemars;

mod cloud;
mod containers;
pub mod dialect;
mod export;
pub mod exports;
mod input;
mod log_text;
mod logs;
mod magic;
pub mod mesh;
mod points;
mod propose;
pub mod table;
pub mod tables;
pub mod tracim;

pub(crate) use containers::ros_bag;
#[cfg(target_arch = "x86_64")]
use containers::wide;
pub use containers::{cdr, mcap, parquet, xml};
use containers::{sqlite, unpack, workbook};

pub use cloud::{Cloud, cloud, packed_points, rows};
pub use export::Export;
pub use export::{LabelNames, Pattern as LabelPattern};
pub use exports::{Format, qif};
pub use input::{file_text, into_text, only_sheet, read_bytes, read_text};
pub use log_text::LogFile;
pub use logs::{ChannelValues, JointLog, Log, LogKind, LogRow, StandstillCriterion, is_joint_column, standstill};
pub use logs::{DIRECTION, is_common_column, meaning as log_column, read as log, write as write_log};
pub use logs::{arrays, matlab, numpy};
pub use points::{Line, Names, Point, SharedText, Stated, to_parquet};
pub use propose::{
    FilesProposal, JOINTS_REMARK, TargetFit, files_beside, fit_targets, has_several_tables, heading_without_unit,
    label_form, propose, propose_file, propose_file_for, propose_files, world_lines,
};
pub use tables::observations::{TableReading, observations, observations_with};

use crate::dialect::Unit;
use etalon_base::catalogue::IntoArgument;
use etalon_base::message::{Message, Place, Problems, Result};
use etalon_base::pose::Vector;
use etalon_base::{error, warning};
use etalon_tables::Encoding;
use std::path::Path;
use table::{TIME, Table, Values, XYZ};

/// Reads a file in a format, without a campaign; rows that were not measured are `refused`.
///
/// # Errors
/// Reports all unreadable rows, with their lines.
pub fn read_file(path: &Path, encoding: Option<Encoding>, format: &Format, unit: Unit) -> Result<Vec<Point>> {
    let name = path.display().to_string();
    let here = |problems: Problems| problems.at(&Place::file(name.as_str()));
    let text = read_bytes(path).and_then(|bytes| into_text(path, bytes, encoding, format)).map_err(here)?;
    let (points, problems) = rows(format, &name, &text.into(), unit);
    here(problems).check()?;
    Ok(points)
}

/// Label and position (mm) of a point.
pub type Labelled = (String, Vector);

/// Returns labels and positions (mm) of a file: [`points_and_refused`] without the warning.
pub fn labelled_points(file: &str, text: &str, format: &Format, unit: Unit) -> Result<Vec<Labelled>> {
    points_and_refused(file, text, format, unit).map(|(points, _)| points)
}

/// Returns labels and positions (mm) of a file.
///
/// Rows that were not measured are omitted, with a warning that counts them.
pub fn points_and_refused(
    file: &str,
    text: &str,
    format: &Format,
    unit: Unit,
) -> Result<(Vec<Labelled>, Option<Message>)> {
    let (rows, problems) = format.read(file, &text.into(), unit);
    problems.check()?;
    let refused: Vec<&Point> = rows.iter().filter(|row| row.refused.is_some() && !row.is_left_out).collect();
    let said = refused.first().map(|first| {
        let reason = first.refused.as_deref().map_or_else(|| "".argument(), IntoArgument::argument);
        warning!("rows-left-out", count = refused.len(), reason).at(first.place_in(file))
    });
    let points = rows.iter().filter(|row| row.refused.is_none()).map(|row| (row.label.to_string(), row.xyz_mm));
    Ok((points.collect(), said))
}

/// Reads the text of a file in a format; for a binary format, one character for each byte.
pub fn text_in(path: &Path, format: &Format) -> Result<String> {
    into_text(path, read_bytes(path)?, None, format)
}

/// Returns the samples of a recording as a table `time_s x_mm y_mm z_mm`.
///
/// # Errors
/// Reports all rows that cannot be read or were not measured.
pub fn recorded_points(file: &str, text: &str, format: &Format, unit: Unit) -> Result<Table> {
    let (points, mut problems) = format.read(file, &text.into(), unit);
    let refused =
        points.iter().filter(|point| !point.is_left_out).filter_map(|point| Some((point, point.refused.as_ref()?)));
    problems.0.extend(refused.map(|(point, reason)| error!("row-without-point", reason).at(point.place_in(file))));
    problems.check()?;
    let samples: Vec<&Point> = points.iter().filter(|point| point.refused.is_none()).collect();
    let mut table = Table::from_file(file, samples.iter().map(|point| point.line as usize));
    table.set(TIME, Values::Numbers(samples.iter().map(|point| point.time_s).collect()));
    for (axis, name) in XYZ.into_iter().enumerate() {
        table.set(name, Values::Numbers(samples.iter().map(|point| Some(point.xyz_mm[axis])).collect()));
    }
    Ok(table)
}
