//! Knowledge of fixed points and surfaces, in addition to the observations of targets.

use super::{Surface, less_station, point, station_pose};
use etalon_base::pose::{Vector, minus, norm, unit};
use std::collections::BTreeMap;

/// Knowledge of fixed points, in addition to the observations of targets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Known {
    /// Position of a point in the world.
    Place {
        /// First of the three coordinates of the point.
        point: usize,
        /// Position (mm).
        place_mm: Vector,
        /// Standard uncertainty of a coordinate, mm.
        standard_uncertainty_mm: f64,
    },
    /// A point measured by another station of the instrument.
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
    /// Distance of two points.
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
    /// A point on a surface or line.
    On {
        /// Element that contains the point.
        surface: Surface,
        /// Parameters of the element.
        unknowns: [usize; 4],
        /// Position (mm).
        place_mm: Vector,
        /// Standard uncertainty (mm) of the distance from the element.
        standard_uncertainty_mm: f64,
    },
    /// The radius of a sphere.
    Length {
        /// Parameter of the radius.
        parameter: usize,
        /// Radius (mm).
        length_mm: f64,
        /// Standard uncertainty of the radius (mm).
        standard_uncertainty_mm: f64,
    },
}

/// Stated value (mm) of fixed points with its residual.
#[derive(Clone, Debug, PartialEq)]
pub struct KnownResidual {
    /// Parameters that the value concerns: of two points, the first coordinates.
    pub parameters: Vec<usize>,
    /// Stated value; `None` for a point of a surface.
    pub stated_mm: Option<f64>,
    /// Position (mm) of a point of a surface.
    pub place_mm: Option<Vector>,
    /// Standard uncertainty.
    pub standard_uncertainty_mm: f64,
    /// Identified minus stated value.
    pub residual_mm: f64,
}

impl Known {
    /// Standard uncertainty (mm) of each row.
    fn standard_uncertainty_mm(&self) -> f64 {
        match *self {
            Self::Place { standard_uncertainty_mm, .. }
            | Self::Seen { standard_uncertainty_mm, .. }
            | Self::Distance { standard_uncertainty_mm, .. }
            | Self::On { standard_uncertainty_mm, .. }
            | Self::Length { standard_uncertainty_mm, .. } => standard_uncertainty_mm,
        }
    }

    /// Stated values with their residuals at all parameters, a row each; none for a point that a
    /// station measured.
    pub fn stated(&self, values: &[f64]) -> Vec<KnownResidual> {
        if matches!(self, Self::Seen { .. }) {
            return Vec::new();
        }
        let (standard_uncertainty_mm, mut left) = (self.standard_uncertainty_mm(), vec![0.0; self.rows()]);
        self.residuals(values, &mut left);
        let row = |(row, left): (usize, f64)| {
            let (parameters, stated_mm) = match *self {
                Self::Place { point, place_mm, .. } => (vec![point + row], Some(place_mm[row])),
                Self::Seen { point, .. } => (vec![point + row], None),
                Self::Distance { from, to, distance_mm, .. } => (vec![from, to], Some(distance_mm)),
                Self::On { unknowns, .. } => (vec![unknowns[0]], None),
                Self::Length { parameter, length_mm, .. } => (vec![parameter], Some(length_mm)),
            };
            let residual_mm = left * standard_uncertainty_mm;
            let place_mm = if let Self::On { place_mm, .. } = *self { Some(place_mm) } else { None };
            KnownResidual { parameters, stated_mm, place_mm, standard_uncertainty_mm, residual_mm }
        };
        left.into_iter().enumerate().map(row).collect()
    }

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

    /// Writes the residuals at all parameters.
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

    /// Writes the derivatives of the residuals with respect to all parameters, row by row.
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

/// Known positions, by the first parameter of their point.
pub(crate) fn places(known: &[Known]) -> BTreeMap<usize, Vector> {
    let place = |k: &Known| match *k {
        Known::Place { point, place_mm, .. } => Some((point, place_mm)),
        Known::Distance { .. } | Known::Seen { .. } | Known::On { .. } | Known::Length { .. } => None,
    };
    known.iter().filter_map(place).collect()
}
