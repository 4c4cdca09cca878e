//! Facts about things that are fixed in the world, beside the observations of targets.

use super::{Surface, less_station, point, station_pose};
use etalon_base::pose::{Vector, minus, norm, unit};
use std::collections::BTreeMap;

/// Knowledge of fixed points beside the observations of targets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Known {
    /// Their place in the world.
    Place {
        /// First of the three coordinates of the point.
        point: usize,
        /// The place, mm.
        place_mm: Vector,
        /// Standard uncertainty of a coordinate, mm.
        standard_uncertainty_mm: f64,
    },
    /// A point as another station of the instrument measures it.
    Seen {
        /// First of the six parameters of the station: its pose in the world.
        station: usize,
        /// First of the three coordinates of the point.
        point: usize,
        /// Position in the frame of the station (mm).
        at_mm: Vector,
        /// Standard uncertainty of a coordinate, mm.
        standard_uncertainty_mm: f64,
    },
    /// Their distance from each other.
    Distance {
        /// First coordinate of one point.
        from: usize,
        /// First coordinate of the other.
        to: usize,
        /// The distance.
        distance_mm: f64,
        /// Its standard uncertainty.
        standard_uncertainty_mm: f64,
    },
    /// A place on a surface or line.
    On {
        /// Element that contains the point.
        surface: Surface,
        /// The parameters of that.
        unknowns: [usize; 4],
        /// The place, mm.
        place_mm: Vector,
        /// Standard uncertainty of its distance from it, mm.
        standard_uncertainty_mm: f64,
    },
    /// The radius of a sphere.
    Length {
        /// Its parameter.
        parameter: usize,
        /// The length.
        length_mm: f64,
        /// Its standard uncertainty.
        standard_uncertainty_mm: f64,
    },
}

impl Known {
    /// First coordinates of the points.
    pub(crate) fn points(&self) -> Vec<usize> {
        match *self {
            Self::Place { point, .. } => vec![point],
            Self::Distance { from, to, .. } => vec![from, to],
            Self::Seen { station, point, .. } => vec![station, point],
            Self::On { unknowns, .. } => vec![unknowns[0]],
            Self::Length { parameter, .. } => vec![parameter],
        }
    }

    /// Number of rows.
    pub(crate) fn rows(&self) -> usize {
        match self {
            Self::Place { .. } | Self::Seen { .. } => 3,
            Self::Distance { .. } | Self::Length { .. } => 1,
            Self::On { surface, .. } => surface.rows(),
        }
    }

    /// Writes its residuals at all parameters.
    pub(crate) fn residuals(&self, values: &[f64], out: &mut [f64]) {
        match *self {
            Self::Place { point: at, place_mm, standard_uncertainty_mm } => {
                out.copy_from_slice(&minus(point(values, at), place_mm).map(|v| v / standard_uncertainty_mm));
            }
            Self::Seen { station, point: seen, at_mm, standard_uncertainty_mm } => {
                let off = minus(point(values, seen), station_pose(values, station).apply(at_mm));
                out.copy_from_slice(&off.map(|v| v / standard_uncertainty_mm));
            }
            Self::Distance { from, to, distance_mm, standard_uncertainty_mm } => {
                out[0] = (norm(minus(point(values, to), point(values, from))) - distance_mm) / standard_uncertainty_mm;
            }
            Self::On { surface, unknowns, place_mm, standard_uncertainty_mm } => {
                let distances = surface.residuals(place_mm, unknowns.map(|i| values[i]));
                out.iter_mut().zip(distances).for_each(|(out, d)| *out = d / standard_uncertainty_mm);
            }
            Self::Length { parameter, length_mm, standard_uncertainty_mm } => {
                out[0] = (values[parameter] - length_mm) / standard_uncertainty_mm;
            }
        }
    }

    /// Writes their derivatives by all parameters, row by row.
    pub(crate) fn jacobian(&self, values: &[f64], out: &mut [f64]) {
        out.fill(0.0);
        let n = values.len();
        match *self {
            Self::Place { point: at, standard_uncertainty_mm, .. } => {
                (0..3).for_each(|i| out[i * n + at + i] = 1.0 / standard_uncertainty_mm);
            }
            Self::Seen { station, point, at_mm, standard_uncertainty_mm } => {
                (0..3).for_each(|i| out[i * n + point + i] = 1.0);
                less_station(values, station, at_mm, out);
                out.iter_mut().for_each(|d| *d /= standard_uncertainty_mm);
            }
            Self::Distance { from, to, standard_uncertainty_mm, .. } => {
                let along = unit(minus(point(values, to), point(values, from))).unwrap_or_default();
                for (i, along) in along.into_iter().enumerate() {
                    out[to + i] += along / standard_uncertainty_mm;
                    out[from + i] -= along / standard_uncertainty_mm;
                }
            }
            Self::On { surface, unknowns, place_mm, standard_uncertainty_mm } => {
                let gradients = surface.gradients(place_mm, unknowns.map(|i| values[i]));
                for (row, by) in out.chunks_exact_mut(n).zip(gradients) {
                    let by = unknowns.iter().zip(&by[3..]).take(surface.unknowns());
                    by.for_each(|(&j, by)| row[j] += by / standard_uncertainty_mm);
                }
            }
            Self::Length { parameter, standard_uncertainty_mm, .. } => out[parameter] = 1.0 / standard_uncertainty_mm,
        }
    }
}

/// Known places, by the first parameter of their point.
pub(crate) fn places(known: &[Known]) -> BTreeMap<usize, Vector> {
    let place = |k: &Known| match *k {
        Known::Place { point, place_mm, .. } => Some((point, place_mm)),
        Known::Distance { .. } | Known::Seen { .. } | Known::On { .. } | Known::Length { .. } => None,
    };
    known.iter().filter_map(place).collect()
}
