//! Task of `etalon iso230`.

use super::inputs::Table;
use super::text_format::TableFormat;
use crate::stages::table_file::TableFile;
use etalon_base::error;
use etalon_base::message::{Problems, Result};
use etalon_controllers::axis_tables::{self, Deviation};
use etalon_documents::AxisDocument;
use etalon_standards::iso230::{Approach, AxisPosition, Runs};
use std::collections::BTreeSet;

/// Evaluates the positioning of a linear axis (ISO 230-2:2014).
///
/// # Errors
/// Fails if a position has too few runs.
pub fn iso230(table: Table, format: &TableFormat) -> Result<AxisDocument> {
    Ok(evaluate(&format.read_other(table)?)?.0)
}

/// The answer from a table, and the deviations that a compensation table is made of.
pub(crate) fn evaluate(file: &TableFile) -> Result<(AxisDocument, Vec<Deviation>)> {
    let runs = runs(file).map_err(|problems| file.place(problems))?;
    let positions = positions(&runs).map_err(|problems| file.place(problems))?;
    let document = AxisDocument::new(&positions, &runs);
    let deviations: Vec<Deviation> = document.positions.iter().map(Deviation::from).collect();
    axis_tables::plausible(&deviations).map_err(|problems| file.place(problems))?;
    Ok((document, deviations))
}

/// Runs to each position in both directions, positions in ascending order; the positive direction
/// is first.
fn runs(file: &TableFile) -> Result<Vec<Runs>> {
    file.table.require(["position_mm", "measured_mm", "direction"])?;
    let column = |name: &str| file.table.numbers(name);
    let (programmed, measured, direction) = (column("position_mm")?, column("measured_mm")?, column("direction")?);
    let missing = |i: usize| {
        let wrong = [!programmed[i].is_finite(), !measured[i].is_finite(), direction[i].abs() != 1.0];
        let column = ["position_mm", "measured_mm", "direction"].into_iter().zip(wrong).find(|(_, wrong)| *wrong)?.0;
        Some(error!("iso230-row-incomplete", column).at(file.table.place(i)))
    };
    Problems((0..programmed.len()).filter_map(missing).collect()).check()?;
    let mut all = programmed.clone();
    all.sort_by(f64::total_cmp);
    all.dedup();
    if all.is_empty() {
        return Err(error!("data-rows-missing").into());
    }
    if are_exchanged(&programmed, &measured) {
        return Err(error!("iso230-columns-exchanged").into());
    }
    let side = |position_mm: f64, is_forward: bool| {
        let sign = if is_forward { 1.0 } else { -1.0 };
        let rows = (0..programmed.len()).filter(|&i| programmed[i] == position_mm && direction[i] == sign);
        Runs { position_mm, is_forward, deviations_mm: rows.map(|i| measured[i] - position_mm).collect() }
    };
    Ok(all.into_iter().flat_map(|at| [side(at, true), side(at, false)]).collect())
}

/// `true` if programmed positions all differ while measured positions repeat: the values of one
/// column are in the other.
fn are_exchanged(programmed: &[f64], measured: &[f64]) -> bool {
    let different = |values: &[f64]| values.iter().map(|v| v.to_bits()).collect::<BTreeSet<u64>>().len();
    // each position has two runs in each direction at least
    different(programmed) > programmed.len() / 2 && different(measured) <= measured.len() / 4
}

/// Positions in ascending order, each with its runs in both directions.
fn positions(runs: &[Runs]) -> Result<Vec<AxisPosition>> {
    let position = |pair: &[Runs]| {
        let approach = |r: &Runs| {
            let direction = if r.is_forward { "+1" } else { "-1" };
            Approach::new(&r.deviations_mm)
                .ok_or_else(|| error!("iso230-few-runs", position = r.position_mm, direction))
        };
        Ok(AxisPosition::new(pair[0].position_mm, approach(&pair[0])?, approach(&pair[1])?))
    };
    runs.chunks_exact(2).map(position).collect()
}
