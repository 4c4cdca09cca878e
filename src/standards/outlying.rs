//! Readings that are far from all others of their group (not in the standards, which exclude no
//! reading): exchanged labels, placeholders, a measurement in motion.

use etalon_base::pose::{Vector, centroid, minus, norm};
use etalon_math::statistics::median;

/// Distance from the other readings, in standard deviations of a coordinate, beyond which a reading
/// is outlying: normal scatter exceeds it once in 10¹² readings.
const FAR: f64 = 8.0;
/// Smallest standard deviation (mm) of a coordinate, for readings that are rounded to equal values.
const LEAST_MM: f64 = 5e-4;
/// Median distance of normal readings from their centre, in standard deviations of a coordinate, on
/// a line, in the plane and in space (half-normal, Rayleigh and Maxwell distribution).
const MEDIAN_DISTANCE: [f64; 3] = [0.6745, 1.177, 1.538];
/// Minimum number of readings of a group, and of all groups.
const FEWEST: [usize; 2] = [3, 10];
/// Maximum share of outlying readings of a group; more of them come from another approach.
const SHARE: f64 = 0.1;

/// Readings of one place, in the order of recording.
pub(crate) struct Readings {
    /// Measured positions (mm).
    pub positions_mm: Vec<Vector>,
    /// Median position.
    pub middle_mm: Vector,
    distances_mm: Vec<f64>,
}

/// Reading that is far from the others of its group.
pub(crate) struct FarReading {
    /// Index of the group.
    pub group: usize,
    /// Index of the reading in the group.
    pub reading: usize,
    /// Distance (mm) from the median position of the group.
    pub distance_mm: f64,
    /// Median distance (mm) of the readings of the group.
    pub median_mm: f64,
}

/// Returns the readings that are far from the others of their group and from the readings before
/// and after them. A drift moves neighbours alike. Coordinates scatter in `dimensions` directions,
/// one to three.
pub(crate) fn far_readings(groups: &[Readings], dimensions: usize) -> Vec<FarReading> {
    let all = || groups.iter().flat_map(|group| group.distances_mm.iter().copied());
    if all().count() < FEWEST[1] {
        return Vec::new();
    }
    let (common, factor) = (median(all()).unwrap_or(0.0), MEDIAN_DISTANCE[dimensions.clamp(1, 3) - 1]);
    let of_group = |(group, readings): (usize, &Readings)| {
        let median_mm = median(readings.distances_mm.iter().copied()).unwrap_or(0.0);
        let least_mm = FAR * (median_mm.max(common) / factor).max(LEAST_MM);
        let far = |reading: usize| {
            let distance_mm = readings.distances_mm[reading];
            FarReading { group, reading, distance_mm, median_mm }
        };
        readings.beyond(least_mm).into_iter().map(far).collect::<Vec<_>>()
    };
    groups.iter().enumerate().flat_map(of_group).collect()
}

impl Readings {
    /// Readings of a place; `None` if they are too few for a median.
    pub fn new(positions_mm: Vec<Vector>) -> Option<Self> {
        if positions_mm.len() < FEWEST[0] {
            return None;
        }
        let middle = |k: usize| median(positions_mm.iter().map(|p: &Vector| p[k])).unwrap_or(f64::NAN);
        let middle_mm = [0, 1, 2].map(middle);
        let distances_mm = positions_mm.iter().map(|p| norm(minus(*p, middle_mm))).collect();
        Some(Self { positions_mm, middle_mm, distances_mm })
    }

    /// Indices of the readings that are farther than `least_mm` from the middle and from their
    /// neighbours; none if they are many.
    fn beyond(&self, least_mm: f64) -> Vec<usize> {
        let count = self.positions_mm.len();
        let far: Vec<usize> = (0..count).filter(|&i| self.distances_mm[i] > least_mm).collect();
        let most = (SHARE * count as f64).max(1.0);
        if far.len() as f64 > most {
            return Vec::new();
        }
        far.into_iter().filter(|&i| self.deviation_from_neighbours(i) > least_mm).collect()
    }

    /// Distance (mm) from the centre of the two nearest readings in time.
    fn deviation_from_neighbours(&self, i: usize) -> f64 {
        let last = self.positions_mm.len() - 1;
        let beside = match i {
            0 => [1, 2],
            i if i == last => [last - 1, last - 2],
            i => [i - 1, i + 1],
        };
        let centre = centroid(&beside.map(|k| self.positions_mm[k])).unwrap_or(self.middle_mm);
        norm(minus(self.positions_mm[i], centre))
    }
}
