//! The position of the target measured by another station of the instrument.

use super::{At, Equation, Kind, Known, onto, place, places, point};
use crate::Settings;
use etalon_base::pose::{Pose, Vector, centroid, cross, minus, turning_axes};
use etalon_robots::FreeBase;
use std::collections::{BTreeMap, BTreeSet};

/// The position of the target measured by another station of the instrument. Residuals: the three
/// coordinates of the target minus the measured ones (mm).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Seen {
    /// First of the six parameters of the station: its pose in the world.
    pub station: usize,
    /// Position in the frame of the station (mm).
    pub at_mm: Vector,
}

impl Equation for Seen {
    fn rows(&self) -> usize {
        3
    }

    fn unknowns(&self) -> Vec<usize> {
        (self.station..self.station + 6).collect()
    }

    fn residuals(&self, at: &At, out: &mut [f64]) {
        out.copy_from_slice(&minus(at.position, station_pose(at.values, self.station).apply(self.at_mm)));
    }

    fn jacobian(&self, at: &At, moved: &[f64], out: &mut [f64]) {
        out.copy_from_slice(moved);
        less_station(at.values, self.station, self.at_mm, out);
    }

    fn by_scale(&self, values: &[f64]) -> Vector {
        let station = station_pose(values, self.station);
        minus(station.apply([0.0; 3]), station.apply(self.at_mm))
    }

    fn has_length(&self) -> bool {
        true
    }
}

/// Pose in the world of the station whose first parameter is `first`.
pub(crate) fn station_pose(values: &[f64], first: usize) -> Pose {
    Pose { translation_mm: point(values, first), ..Pose::from_rotation_vector(point(values, first + 3)) }
}

/// Subtracts from three rows of derivatives the derivatives of the position `at_mm` by a station.
pub(crate) fn less_station(values: &[f64], station: usize, at_mm: Vector, rows: &mut [f64]) {
    let n = values.len();
    let lever = station_pose(values, station).rotate(at_mm);
    for (k, axis) in turning_axes(point(values, station + 3)).into_iter().enumerate() {
        rows[k * n + station + k] -= 1.0;
        let turned = cross(axis, lever);
        (0..3).for_each(|i| rows[i * n + station + 3 + k] -= turned[i]);
    }
}

/// Poses of stations at which their measurements of targets and points agree with the world; then
/// targets and points that only these stations measured.
pub(crate) fn locate_stations(
    arm: &dyn FreeBase,
    settings: &Settings,
    seen: &BTreeSet<usize>,
    wanted: &[usize],
    values: &mut [f64],
) {
    let known = places(&settings.known);
    let mut stations: BTreeMap<usize, Vec<(Vector, Vector)>> = BTreeMap::new();
    for c in settings.conditions.iter().filter(|c| seen.contains(&c.target)) {
        if let Kind::Seen(Seen { station, at_mm }) = c.kind {
            stations.entry(station).or_default().push((at_mm, place(arm, c, values)));
        }
    }
    for k in &settings.known {
        if let Known::Seen { station, point, at_mm, .. } = *k
            && let Some(place) = known.get(&point)
        {
            stations.entry(station).or_default().push((at_mm, *place));
        }
    }
    for (first, pairs) in stations.into_iter().filter(|s| wanted.contains(&s.0)) {
        let Some(pose) = onto(&pairs) else { continue };
        values[first..first + 3].copy_from_slice(&pose.translation_mm);
        values[first + 3..first + 6].copy_from_slice(&pose.rotation_vector_rad());
    }
    let mut alone: BTreeMap<usize, Vec<Vector>> = BTreeMap::new();
    for c in settings.conditions.iter().filter(|c| !seen.contains(&c.target)) {
        if let Kind::Seen(Seen { station, at_mm }) = c.kind {
            let at =
                arm.flange(values, &c.joints, c.target).inverse().apply(station_pose(values, station).apply(at_mm));
            alone.entry(arm.target_place(c.target)).or_default().push(at);
        }
    }
    for k in &settings.known {
        if let Known::Seen { station, point, at_mm, .. } = *k
            && !known.contains_key(&point)
        {
            alone.entry(point).or_default().push(station_pose(values, station).apply(at_mm));
        }
    }
    for (first, all) in alone.into_iter().filter(|a| wanted.contains(&a.0)) {
        values[first..first + 3].copy_from_slice(&centroid(&all).unwrap_or_default());
    }
}
