//! Import: exports and logs become points and joint values; nothing else leaves this room.
//!
//! No input is repaired in silence: a row that means "not measured" is refused by rule and listed, anything else that
//! does not read as stated is an error with its place, and one run reports all of them.

mod blunders;
mod delimited;
mod formats;
mod label;
mod log;
mod points;
mod polyworks;

pub use formats::propose;
pub use log::is_joint_column;
pub(crate) use log::meaning as log_column;
pub(crate) use points::Point;

use crate::campaign::{Campaign, Export, Format, Log, Unit};
use crate::document::{ImportDocument, Source};
use crate::files;
use crate::message::{Message, Problems, Result};
use crate::pose::Vector;
use points::{PointColumns, PointRow};
use polars::prelude::DataFrame;

/// What a campaign's files hold.
#[derive(Clone, Debug)]
pub struct Imported {
    /// One row per measured point: `export row line label target pose cycle time_s x_mm y_mm z_mm`.
    pub points: DataFrame,
    /// Joint values of each log, by its name: `row line pose cycle time_s` and the joints in mm or deg.
    pub logs: Vec<(String, DataFrame)>,
    /// What was read and refused.
    pub document: ImportDocument,
}

/// Reads all exports and logs of a campaign.
pub fn import(campaign: &Campaign) -> Result<Imported> {
    let mut problems = Problems::default();
    let mut sources = vec![
        statement("campaign", campaign.file_name(), campaign.text.as_bytes()),
        statement("robot", campaign.file.robot.get_ref(), campaign.robot_text.as_bytes()),
    ];
    let mut columns = PointColumns::default();
    for export in &campaign.file.exports {
        let read = campaign.resolve(&export.file).and_then(|path| read_text(&path, campaign.place(&export.file)));
        match read.and_then(|(text, bytes)| {
            let mut source = statement("export", export.file.get_ref(), &bytes);
            source.dialect = format!("{}, unit {}", export.format, export.unit.name());
            let rows = point_rows(export.file.get_ref(), &text, &export.format)?;
            columns.add(campaign, export, rows, &mut source)?;
            Ok(source)
        }) {
            Ok(source) => sources.push(source),
            Err(more) => problems.0.extend(more.0),
        }
    }
    let mut logs = Vec::new();
    for stated in &campaign.file.logs {
        let read = campaign.resolve(&stated.file).and_then(|path| read_text(&path, campaign.place(&stated.file)));
        match read.and_then(|(text, bytes)| {
            let mut source = statement("log", stated.file.get_ref(), &bytes);
            let table = log::read(campaign, stated, &text, &mut source)?;
            Ok((source, table))
        }) {
            Ok((source, table)) => {
                sources.push(source);
                logs.push((stated.name.clone(), table));
            }
            Err(more) => problems.0.extend(more.0),
        }
    }
    problems.0.extend(columns.measured_twice());
    problems.check()?;
    let mut messages = blunders::refuse(campaign, &mut columns, &mut sources)?;
    messages.extend(columns.unused_labels(campaign));
    let document = ImportDocument {
        schema: "etalon/import/1".to_owned(),
        campaign: campaign.file.name.clone(),
        sources,
        messages,
    };
    Ok(Imported { points: columns.table()?, logs, document })
}

/// The points that an export brings if this is its text, before rules about blunders.
pub(crate) fn points_of(campaign: &Campaign, export: &Export, text: &str) -> Result<Vec<Point>> {
    let mut columns = PointColumns::default();
    let file = export.file.get_ref();
    columns.add(campaign, export, point_rows(file, text, &export.format)?, &mut statement("export", file, b""))?;
    Ok(columns.points)
}

/// The table of a log if this is its text.
pub(crate) fn log_of(campaign: &Campaign, stated: &Log, text: &str) -> Result<DataFrame> {
    log::read(campaign, stated, text, &mut statement("log", stated.file.get_ref(), b""))
}

/// Labels and points of a file, in millimetres; every row counts, none is refused.
pub fn labelled_points(file: &str, text: &str, format: &Format, unit: Unit) -> Result<Vec<(String, Vector)>> {
    let rows = point_rows(file, text, format)?;
    Ok(rows.into_iter().map(|row| (row.label, row.xyz.map(|v| v * unit.in_mm()))).collect())
}

/// Rows of an export in the stated format.
fn point_rows(file: &str, text: &str, format: &Format) -> Result<Vec<PointRow>> {
    match format {
        Format::Polyworks => polyworks::rows(file, text),
        Format::Delimited(dialect) => delimited::point_rows(file, text, dialect),
    }
}

fn statement(kind: &str, file: &str, bytes: &[u8]) -> Source {
    Source {
        file: file.to_owned(),
        sha256: files::sha256(bytes),
        bytes: bytes.len(),
        kind: kind.to_owned(),
        dialect: if kind == "export" || kind == "log" { String::new() } else { "TOML".to_owned() },
        rows_read: 0,
        refused: Vec::new(),
    }
}

/// Text of an input file and its bytes; where it cannot be read the message points at the campaign.
fn read_text(path: &std::path::Path, place: crate::message::Place) -> Result<(String, Vec<u8>)> {
    if !path.is_file() {
        return Err(Message::error(format!("there is no file `{}`", path.display())).at(place).into());
    }
    let bytes = files::read(path)?;
    let text = std::str::from_utf8(&bytes).map_err(|e| {
        Message::error(format!("`{}` is not UTF-8 text (byte {})", path.display(), e.valid_up_to()))
            .at(place)
            .hint("export it as UTF-8 or plain ASCII text")
    })?;
    Ok((text.strip_prefix('\u{feff}').unwrap_or(text).to_owned(), bytes))
}
