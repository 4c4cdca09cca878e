//! Coordinates that an export rounded too coarsely.

use crate::stages::observe::resolution::step;
use etalon_base::message::Message;
use etalon_base::{phrase, warning};
use etalon_campaign::Campaign;
use etalon_formats::{Export, Point};
use std::collections::BTreeSet;

/// Minimum number of different values of a column: fewer may be round by chance, or be commanded
/// heights.
const FEWEST: usize = 8;
/// Minimum number if other columns have more decimals.
const FEW: usize = 3;
/// Probability below which values are not round by chance.
const BY_CHANCE: f64 = 1e-6;
/// Maximum number of decimals for the resolution of a column, and the step of a column with more.
const ALL_DECIMALS: i32 = 9;
const LEAST_STEP: f64 = 1e-10;
/// Maximum number of decimals of a step.
const MOST_DECIMALS: i32 = 4;

/// Returns a warning if the uncertainty of the rounding exceeds the uncertainty of the instrument:
/// a step has the standard uncertainty step/√12 (JCGM 100:2008, 4.3.7).
pub(super) fn coarse(campaign: &Campaign, export: &Export, rows: &[Point]) -> Option<Message> {
    let dialect = &export.format.dialect;
    if dialect.angle_unit.is_some() || !dialect.types.is_empty() {
        return None;
    }
    let measured = || rows.iter().filter(|p| p.refused.is_none() && p.xyz_mm.iter().all(|v| v.is_finite()));
    let in_mm = export.unit.in_mm();
    let columns = ["x", "y", "z"].into_iter().enumerate().filter_map(|(axis, name)| {
        let values = || measured().map(move |p| p.xyz_mm[axis] / in_mm);
        // more than are needed are not counted
        let mut different = BTreeSet::new();
        for bits in values().map(f64::to_bits) {
            different.insert(bits);
            if different.len() >= FEWEST {
                break;
            }
        }
        // a constant column is no coordinate that was measured
        let all = || step(values(), ALL_DECIMALS).unwrap_or(LEAST_STEP);
        (different.len() > 1).then(|| (name, different.len(), step(values(), MOST_DECIMALS), all()))
    });
    let columns: Vec<(&str, usize, Option<f64>, f64)> = columns.collect();
    // of few values each is a multiple by chance with the ratio of the finest step to its own
    let finest = columns.iter().map(|column| column.3).fold(f64::INFINITY, f64::min);
    let by_chance = |count: usize, step: f64| (finest / step).powi(count as i32);
    let is_shown = |count: usize, step: f64| count >= FEWEST || count >= FEW && by_chance(count, step) < BY_CHANCE;
    let columns: Vec<(&str, Option<f64>)> =
        columns.iter().map(|(name, count, step, _)| (*name, step.filter(|step| is_shown(*count, *step)))).collect();
    let instrument_mm = campaign.file.instrument.standard_uncertainty_mm();
    let is_coarse = |step: f64| step * in_mm / 12f64.sqrt() > instrument_mm;
    let coarse: Vec<(&str, f64)> =
        columns.iter().filter_map(|(name, step)| Some((*name, step.filter(|step| is_coarse(*step))?))).collect();
    let (unit, file) = (export.unit.name(), export.file.get_ref());
    let largest = coarse.iter().map(|(_, step)| *step).max_by(f64::total_cmp)?;
    let columns: Vec<_> = coarse.iter().map(|(column, step)| phrase!("column-step", column, step, unit)).collect();
    let (rounding_um, instrument_um) = (1e3 * largest * in_mm / 12f64.sqrt(), 1e3 * instrument_mm);
    let message = warning!("coordinates-rounded", file, columns, rounding_um, instrument_um);
    Some(message.at(campaign.place(&export.file)))
}
