//! Coordinates that an export rounded away.

use etalon_base::message::Message;
use etalon_campaign::Campaign;
use etalon_formats::{Export, Point};
use std::collections::BTreeSet;

/// Fewest different values of a column: fewer may all be round by chance, or be commanded heights.
const FEWEST: usize = 8;
/// Most decimals of a step that is looked for.
const MOST_DECIMALS: i32 = 4;

/// A warning if columns of coordinates are rounded so that this alone is more uncertain than the instrument: a step has the
/// standard uncertainty step/√12 (JCGM 100:2008, 4.3.7).
pub(super) fn coarse(campaign: &Campaign, export: &Export, rows: &[Point]) -> Option<Message> {
    let dialect = &export.format.dialect;
    if dialect.angle_unit.is_some() || !dialect.types.is_empty() {
        return None;
    }
    let measured: Vec<&Point> =
        rows.iter().filter(|p| p.refused.is_none() && p.xyz_mm.iter().all(|v| v.is_finite())).collect();
    let in_mm = export.unit.in_mm();
    let columns = ["x", "y", "z"].into_iter().enumerate().filter_map(|(axis, name)| {
        let values = || measured.iter().map(move |p| p.xyz_mm[axis] / in_mm);
        let different: BTreeSet<u64> = values().map(f64::to_bits).collect();
        // a constant column is no coordinate that was measured
        (different.len() > 1).then(|| (name, step(values()).filter(|_| different.len() >= FEWEST)))
    });
    let columns: Vec<(&str, Option<f64>)> = columns.collect();
    let instrument_mm = campaign.file.instrument.standard_uncertainty_mm();
    let is_coarse = |step: f64| step * in_mm / 12f64.sqrt() > instrument_mm;
    let coarse: Vec<(&str, f64)> =
        columns.iter().filter_map(|(name, step)| Some((*name, step.filter(|step| is_coarse(*step))?))).collect();
    let (&(_, first), unit, file) = (coarse.first()?, export.unit.name(), export.file.get_ref());
    let what = if coarse.len() == columns.len() && coarse.iter().all(|(_, step)| *step == first) {
        format!("the coordinates of `{file}` are rounded to {first} {unit}, coarser than the instrument is uncertain")
    } else {
        let each: Vec<String> = coarse.iter().map(|(name, step)| format!("{name} of {step} {unit}")).collect();
        let each = each.join(", ");
        format!("columns of `{file}` hold multiples of a step that is coarser than the instrument is uncertain: {each}")
    };
    Some(Message::warning(what).at(campaign.place(&export.file)).hint("export them with more decimals"))
}

/// The largest step, a power of ten not above one, of which all values are multiples.
fn step(values: impl Iterator<Item = f64> + Clone) -> Option<f64> {
    let whole = |digits: &i32| {
        let tens = 10f64.powi(*digits);
        values.clone().all(|v| (v * tens - (v * tens).round()).abs() < 1e-6)
    };
    (0..=MOST_DECIMALS).find(whole).map(|digits| 10f64.powi(-digits))
}
