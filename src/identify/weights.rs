//! Readings that state an uncertainty of their own: their residuals are divided by it, instead of by that of the instrument.

use super::{Observation, Settings};
use etalon_base::message::{Message, Place, Result};
use etalon_base::pose::Vector;
use etalon_base::table::{self, COVARIANCES, UNCERTAINTIES};
use nalgebra::{DMatrix, Matrix3};
use polars::prelude::DataFrame;

/// Covariance of a position, mm².
pub type Covariance = [Vector; 3];

/// Column of a standard uncertainty that is that of every coordinate, mm.
const ANY_AXIS: &str = "u_mm";

/// Standard uncertainties that a coordinate can have, mm.
const PLAUSIBLE_MM: std::ops::RangeInclusive<f64> = 2e-5..=100.0;

/// The covariance of each row's position, by its columns `ux_mm uy_mm [uz_mm]` or `cxx_mm2 cxy_mm2 .. czz_mm2`; `None` in rows that
/// leave them empty.
///
/// # Errors
/// A row that states some of them, a value that no coordinate has, or a covariance that is not positive definite.
pub(super) fn covariances(table: &DataFrame, dimension: usize) -> Result<Vec<Option<Covariance>>> {
    let has = |names: &[&str]| names.iter().any(|name| table.column(name).is_ok());
    if has(&[ANY_AXIS]) && !has(&UNCERTAINTIES) && !has(&COVARIANCES) {
        let of = |name: &str| table.column(ANY_AXIS).cloned().map(|column| column.with_name(name.into()));
        let columns = UNCERTAINTIES[..dimension].iter().map(|name| of(name)).collect::<std::result::Result<_, _>>()?;
        let lines = table.column("line").ok().cloned();
        return covariances(&DataFrame::new(table.height(), [columns, Vec::from_iter(lines)].concat())?, dimension);
    }
    let (apart, whole) = (has(&UNCERTAINTIES), has(&COVARIANCES));
    if !apart && !whole {
        return Ok(vec![None; table.height()]);
    }
    if apart && whole {
        let message = Message::error("the table states both standard uncertainties and covariances of coordinates");
        return Err(message
            .at(Place { line: Some(1), ..Place::default() })
            .hint("leave `ux_mm uy_mm uz_mm` out")
            .into());
    }
    // rows and columns of the matrix by the order of the names
    let all: Vec<(&str, usize, usize)> = match apart {
        true => UNCERTAINTIES.iter().enumerate().map(|(i, name)| (*name, i, i)).collect(),
        false => {
            (0..3).flat_map(|i| (i..3).map(move |j| (i, j))).zip(COVARIANCES).map(|((i, j), n)| (n, i, j)).collect()
        }
    };
    let needed: Vec<_> = all.into_iter().filter(|(_, i, j)| *i.max(j) < dimension).collect();
    table::require(table, &needed.iter().map(|(name, ..)| (*name).to_owned()).collect::<Vec<_>>())?;
    let columns = needed.iter().map(|(name, ..)| table::numbers(table, name)).collect::<Result<Vec<_>>>()?;
    let lines = if table.column("line").is_ok() { table::integers(table, "line")? } else { Vec::new() };
    let of_row = |row: usize| -> Result<Option<Covariance>> {
        let at = || Place { line: lines.get(row).map(|l| *l as usize), ..Place::default() };
        let values: Vec<f64> = columns.iter().map(|column| column[row]).collect();
        if values.iter().all(|v| v.is_nan()) {
            return Ok(None);
        }
        let mut covariance = [[0.0; 3]; 3];
        for ((name, i, j), value) in needed.iter().zip(&values) {
            let squared = if apart { value * value } else { *value };
            if value.is_nan() || i == j && !(PLAUSIBLE_MM.contains(&squared.sqrt()) && *value > 0.0) {
                let message = Message::error(match value.is_nan() {
                    true => format!("the row states an uncertainty, but `{name}` is empty"),
                    false => format!("`{name}` = {value} is not the uncertainty of a coordinate"),
                });
                return Err(message.at(at()).expected("from 0.00002 to 100 mm, or all of them empty").into());
            }
            (covariance[*i][*j], covariance[*j][*i]) = (squared, squared);
        }
        match whitening(&covariance, dimension) {
            Some(_) => Ok(Some(covariance)),
            None => Err(Message::error("the covariance of the row is not positive definite").at(at()).into()),
        }
    };
    (0..table.height()).map(of_row).collect()
}

/// The inverse of the Cholesky factor of a covariance; `None` where it is not positive definite.
fn whitening(covariance: &Covariance, dimension: usize) -> Option<DMatrix<f64>> {
    let matrix = DMatrix::from_fn(dimension, dimension, |i, j| covariance[i][j]);
    matrix.cholesky()?.l().try_inverse()
}

/// The covariance in a frame that is turned by the rows of `rotation`.
pub fn turned(covariance: &Covariance, rotation: &[Vector; 3]) -> Covariance {
    let of = |rows: &[Vector; 3]| Matrix3::from_fn(|i, j| rows[i][j]);
    let turned = of(rotation) * of(covariance) * of(rotation).transpose();
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| turned[(i, j)]))
}

/// Residuals of readings with a covariance of their own.
#[derive(Debug)]
pub(super) struct Weights {
    /// First row of each such reading, and what its rows are multiplied by.
    readings: Vec<(usize, DMatrix<f64>)>,
}

impl Weights {
    /// Of observations with `dimension` rows for each measured target, divided by `unit` before; `None` where none states a covariance.
    pub fn new(observations: &[Observation], dimension: usize, unit: f64) -> Option<Self> {
        let mut readings = Vec::new();
        let mut row = 0;
        for o in observations {
            for target in (0..o.targets.len()).filter(|&k| o.targets[k].is_some()) {
                let stated = o.covariances_mm2.get(target).copied().flatten();
                readings.extend(stated.and_then(|c| Some((row, whitening(&c, dimension)? * unit))));
                row += dimension;
            }
        }
        (!readings.is_empty()).then_some(Self { readings })
    }

    /// Whitens rows of `width` numbers.
    pub fn whiten(&self, rows: &mut [f64], width: usize) {
        for (row, factor) in &self.readings {
            let here = &mut rows[row * width..][..factor.nrows() * width];
            let white = factor * DMatrix::from_row_slice(factor.nrows(), width, here);
            white.row_iter().zip(here.chunks_exact_mut(width)).for_each(|(white, row)| {
                row.iter_mut().zip(white.iter()).for_each(|(out, value)| *out = *value);
            });
        }
    }
}

/// Takes the uncertainty of readings that state none from `settings`, or where these state none either, makes it the root mean square of
/// those that are stated; and reports how readings are weighted.
///
/// # Errors
/// Where some readings have no uncertainty at all, or what the settings compare cannot be weighted.
pub fn weigh(observations: &[Observation], dimension: usize, settings: &mut Settings) -> Result<Option<Message>> {
    let readings = observations.iter().map(|o| o.targets.iter().flatten().count()).sum::<usize>();
    let stated: Vec<f64> = observations.iter().flat_map(|o| o.uncertainties_mm(dimension)).map(|(_, u)| u).collect();
    if stated.is_empty() {
        let lengths = settings.conditions.iter().filter(|c| !c.kind.is_angle()).map(|c| c.standard_uncertainty);
        if readings == 0 && settings.standard_uncertainty_mm.is_none() {
            settings.standard_uncertainty_mm = root_mean_square(lengths);
        }
        return Ok(None);
    }
    if settings.kind == super::ResidualKind::Pose || settings.common_uncertainty_mm.is_some() {
        let what = "readings with an uncertainty of their own weigh residuals of targets, without an uncertainty that rows have in common";
        return Err(Message::error(what).hint("compare targets, or leave the columns of uncertainties out").into());
    }
    if settings.standard_uncertainty_mm.is_none() && stated.len() < readings {
        let what = format!(
            "{} of {readings} readings state no uncertainty, and none is stated for them",
            readings - stated.len()
        );
        return Err(Message::error(what).hint("state it in every row, or with --standard-uncertainty-um").into());
    }
    settings.standard_uncertainty_mm = settings.standard_uncertainty_mm.or(root_mean_square(stated.iter().copied()));
    let [least, most] = stated.iter().fold([f64::INFINITY, 0.0], |[a, b], u| [u.min(a), u.max(b)]);
    let which = if stated.len() == readings {
        "all readings".to_owned()
    } else {
        format!("{} of {readings} readings", stated.len())
    };
    let what = format!("{which} weigh by their own standard uncertainties, {least:.4} to {most:.4} mm a coordinate");
    Ok(Some(Message::warning(what).routine()))
}

fn root_mean_square(all: impl Iterator<Item = f64> + Clone) -> Option<f64> {
    let count = all.clone().count();
    (count > 0).then(|| (all.map(|u| u * u).sum::<f64>() / count as f64).sqrt())
}
