//! Coordinates that an export rounded away.

use etalon_base::message::Message;
use etalon_campaign::Campaign;
use etalon_formats::{Export, Point};

/// With fewer points all may be round by chance.
const FEWEST: usize = 8;

/// A warning if all coordinates of an export are rounded so that this alone is more uncertain than the instrument:
/// a step has the standard uncertainty step/√12 (JCGM 100:2008, 4.3.7).
pub(super) fn coarse(campaign: &Campaign, export: &Export, rows: &[Point]) -> Option<Message> {
    let dialect = &export.format.dialect;
    if dialect.angle_unit.is_some() || !dialect.types.is_empty() {
        return None;
    }
    let measured: Vec<&Point> =
        rows.iter().filter(|p| p.refused.is_none() && p.xyz_mm.iter().all(|v| v.is_finite())).collect();
    if measured.len() < FEWEST {
        return None;
    }
    let in_mm = export.unit.in_mm();
    let whole = |digits: &i32| {
        let tens = 10f64.powi(*digits);
        measured.iter().flat_map(|p| p.xyz_mm).all(|v| {
            let scaled = v / in_mm * tens;
            (scaled - scaled.round()).abs() < 1e-6
        })
    };
    let digits = (0..=4).find(whole)?;
    let step_mm = 10f64.powi(-digits) * in_mm;
    let instrument_mm = campaign.file.instrument.standard_uncertainty_mm();
    (step_mm / 12f64.sqrt() > instrument_mm).then(|| {
        let what = format!(
            "the coordinates of `{}` are rounded to {} {}, coarser than the instrument is uncertain",
            export.file.get_ref(),
            10f64.powi(-digits),
            export.unit.name()
        );
        Message::warning(what).at(campaign.place(&export.file)).hint("export them with more decimals")
    })
}
