//! Standard uncertainties that a column rounds to zero: each is taken as the resolution of its
//! column.

use etalon_base::message::{Message, Place, Result};
use etalon_base::warning;
use etalon_campaign::Campaign;
use etalon_formats::table::{COVARIANCES, Table, UNCERTAINTIES, Values};
use etalon_formats::{Export, Point};
use std::borrow::Cow;

/// Maximum number of decimals of a column with a resolution; numbers with more are not rounded.
const MOST_DECIMALS: i32 = 9;
/// Minimum standard uncertainty of a zero, in the unit of its column: 0.02 µm or 0.00002 degrees.
const LEAST: f64 = 2e-5;
/// Columns of standard uncertainties and covariances of a table of observations.
const COLUMNS: [&str; 11] =
    ["u_mm", "urot_deg", "ux_mm", "uy_mm", "uz_mm", "cxx_mm2", "cxy_mm2", "cxz_mm2", "cyy_mm2", "cyz_mm2", "czz_mm2"];
/// Covariances of two coordinates, which may be zero.
const MIXED: [&str; 3] = ["cxy_mm2", "cxz_mm2", "cyz_mm2"];

/// Largest power of ten, not above one, of which all numbers are multiples; `None` with more
/// decimals than these.
pub(crate) fn step(values: impl Iterator<Item = f64> + Clone, most_decimals: i32) -> Option<f64> {
    let whole = |digits: &i32| {
        let tens = 10f64.powi(*digits);
        values.clone().all(|v| (v * tens - (v * tens).round()).abs() < 1e-6)
    };
    (0..=most_decimals).find(whole).map(|digits| 10f64.powi(-digits))
}

/// Zeros of a column of standard uncertainties.
struct Zeros {
    count: usize,
    /// Standard uncertainty of the zeros: half of the last digit d as the half-width of a
    /// rectangular distribution, d/(2√3) (GUM 4.3.7); `None` if the column does not show its
    /// resolution.
    read_as: Option<f64>,
}

impl Zeros {
    /// Zeros among these numbers; `None` without a zero.
    fn new(values: &[f64]) -> Option<Self> {
        let count = values.iter().filter(|v| **v == 0.0).count();
        let others = values.iter().copied().filter(|v| v.is_finite() && *v != 0.0);
        let shown = others.clone().next().and_then(|_| step(others, MOST_DECIMALS));
        let read_as = shown.map(|d| d / 12f64.sqrt()).filter(|u| *u >= LEAST);
        (count > 0).then_some(Self { count, read_as })
    }

    /// A warning of the column `name`, of numbers in `unit`.
    fn message(&self, name: &str, unit: &str) -> Message {
        let count = self.count;
        match self.read_as {
            Some(u) => {
                let u = format!("{u:.1e}").parse().unwrap_or(u);
                warning!("uncertainty-zero-rounded", column = name, count, u, unit)
            }
            None => warning!("uncertainty-zero", column = name, count),
        }
    }
}

/// The table of observations with zeros of its standard uncertainties taken as their resolution,
/// which `messages` state.
pub fn replace_table_zeros<'t>(table: &'t Table, messages: &mut Vec<Message>) -> Result<Cow<'t, Table>> {
    let mut columns: Vec<(&str, Vec<f64>)> = Vec::new();
    for name in COLUMNS.into_iter().filter(|name| table.has(name)) {
        columns.push((name, table.numbers(name)?));
    }
    let mut are_zero = false;
    for group in [&UNCERTAINTIES[..], &COVARIANCES, &["u_mm"], &["urot_deg"]] {
        // a row contains all numbers of a group or none
        let mut unread = vec![false; table.height()];
        for (name, values) in columns.iter_mut().filter(|(name, _)| group.contains(name) && !MIXED.contains(name)) {
            let Some(zeros) = Zeros::new(values) else { continue };
            let unit = name.rsplit('_').next().unwrap_or_default();
            messages.push(zeros.message(name, unit).at(Place { line: Some(1), ..Place::default() }));
            are_zero = true;
            for (value, unread) in values.iter_mut().zip(&mut unread).filter(|(value, _)| **value == 0.0) {
                *value = zeros.read_as.unwrap_or(f64::NAN);
                *unread |= zeros.read_as.is_none();
            }
        }
        for (_, values) in columns.iter_mut().filter(|(name, _)| group.contains(name)) {
            values.iter_mut().zip(&unread).filter(|(_, unread)| **unread).for_each(|(value, _)| *value = f64::NAN);
        }
    }
    if !are_zero {
        return Ok(Cow::Borrowed(table));
    }
    let mut replaced = table.clone();
    for (name, values) in columns {
        replaced.set(name, Values::Numbers(values.into_iter().map(|v| Some(v).filter(|v| !v.is_nan())).collect()));
    }
    Ok(Cow::Owned(replaced))
}

/// Takes zeros of the standard uncertainties of an export as their resolution, or, if unknown, as
/// the uncertainty of the instrument.
pub(crate) fn replace_export_zeros(campaign: &Campaign, export: &Export, rows: &mut [Point]) -> Vec<Message> {
    let (mut messages, in_mm) = (Vec::new(), export.unit.in_mm());
    let instrument_mm = campaign.file.instrument.standard_uncertainty_mm();
    if rows.iter().all(|p| p.standard_uncertainty_mm.is_none()) {
        return messages;
    }
    for (axis, name) in ["u1", "u2", "u3"].into_iter().enumerate() {
        let of = |p: &Point| p.standard_uncertainty_mm.as_ref().map_or(f64::NAN, |u| u[axis] / in_mm);
        let values: Vec<f64> = rows.iter().map(of).collect();
        let Some(zeros) = Zeros::new(&values) else { continue };
        if rows.iter().all(|p| p.xyz_mm[axis] == 0.0) {
            // no coordinate was measured
            continue;
        }
        messages.push(zeros.message(name, export.unit.name()).at(campaign.place(&export.file)));
        let read_as = zeros.read_as.map_or(instrument_mm, |u| u * in_mm);
        for u in rows.iter_mut().filter_map(|p| p.standard_uncertainty_mm.as_mut()).filter(|u| u[axis] == 0.0) {
            u[axis] = read_as;
        }
    }
    messages
}
