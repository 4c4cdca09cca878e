//! Task of `etalon iso230`.

use super::inputs::Table;
use super::text_format::TableFormat;
use crate::stages::table_file::TableFile;
use etalon_base::error;
use etalon_base::message::{Problems, Result};
use etalon_controllers::axis_tables::{self, Deviation};
use etalon_documents::AxisDocument;
use etalon_standards::iso230::{Approach, AxisPosition};

/// Evaluates the positioning of a linear axis (ISO 230-2:2014).
///
/// # Errors
/// Fails if a position has too few runs.
pub fn iso230(table: Table, format: &TableFormat) -> Result<AxisDocument> {
    Ok(evaluate(&format.read_other(table)?)?.0)
}

/// The answer from a table, and the deviations that a compensation table is made of.
pub(crate) fn evaluate(file: &TableFile) -> Result<(AxisDocument, Vec<Deviation>)> {
    let positions = positions(file).map_err(|problems| file.place(problems))?;
    let document = AxisDocument::new(&positions);
    let deviations: Vec<Deviation> = document.positions.iter().map(Deviation::from).collect();
    axis_tables::plausible(&deviations).map_err(|problems| file.place(problems))?;
    Ok((document, deviations))
}

/// Positions in ascending order, each with its runs in both directions.
fn positions(file: &TableFile) -> Result<Vec<AxisPosition>> {
    file.table.require(["position_mm", "measured_mm", "direction"])?;
    let column = |name: &str| file.table.numbers(name);
    let (programmed, measured, direction) = (column("position_mm")?, column("measured_mm")?, column("direction")?);
    let is_whole = |i: usize| programmed[i].is_finite() && measured[i].is_finite() && direction[i].abs() == 1.0;
    let incomplete = (0..programmed.len()).filter(|&i| !is_whole(i));
    Problems(incomplete.map(|i| error!("iso230-row-incomplete").at(file.table.place(i))).collect()).check()?;
    let mut all = programmed.clone();
    all.sort_by(f64::total_cmp);
    all.dedup();
    if all.is_empty() {
        return Err(error!("data-rows-missing").into());
    }
    let position = |at: f64| {
        let runs = |side: f64| {
            let rows = (0..programmed.len()).filter(|&i| programmed[i] == at && direction[i] == side);
            let approach = Approach::new(&rows.map(|i| measured[i] - at).collect::<Vec<_>>());
            let direction = format!("{side:+}");
            approach.ok_or_else(|| error!("iso230-few-runs", position = at, direction))
        };
        Ok(AxisPosition::new(at, runs(1.0)?, runs(-1.0)?))
    };
    all.into_iter().map(position).collect()
}
