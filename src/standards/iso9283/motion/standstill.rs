//! Standstills in a recorded motion, and the poses that they visit. The standard measures poses
//! after stabilisation, but does not define how a standstill differs from motion. Both thresholds
//! are therefore set by the user and reported.

use crate::iso9283::motion::stream::Stream;
use crate::iso9283::pose::orientation::seen_together;
use crate::iso9283::statistics::sample::{mean_position, spread, wrapped};
use etalon_base::error;
use etalon_base::message::Result;
use etalon_base::pose::{Vector, minus, norm};
use std::ops::Range;

/// Criterion for standstill: all positions are within `radius_mm` of their mean for at least
/// `duration_s`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stillness {
    /// Largest distance from the mean.
    pub radius_mm: f64,
    /// Minimum duration.
    pub duration_s: f64,
}

/// A standstill of the robot.
#[derive(Clone, Debug, PartialEq)]
pub struct Standstill {
    /// Samples of the standstill.
    pub samples: Range<usize>,
    /// Mean position of the middle half of the samples, which excludes arrival and departure.
    pub mean_mm: Vector,
    /// Mean of each angle over the middle half of the samples, within half a turn; angles of the
    /// middle sample if two of them are not separable.
    pub angles_rad: Vec<f64>,
    /// Angles that are seen to vary together and are not separable: two of 0, 1, 2 for a, b, c.
    pub inseparable: Option<[usize; 2]>,
}

impl Standstill {
    fn new(stream: &Stream, samples: Range<usize>) -> Self {
        let middle = middle(&samples);
        let angles: Vec<Vec<f64>> = stream.angles_rad().iter().map(|a| a[middle.clone()].to_vec()).collect();
        let inseparable = seen_together(&angles, &[]);
        let means = angles.iter().map(|a| wrapped(spread(a).mean));
        Self {
            mean_mm: mean_position(&stream.positions_mm()[middle.clone()]),
            angles_rad: match inseparable {
                None => means.collect(),
                Some(_) => angles.iter().map(|a| wrapped(a[a.len() / 2])).collect(),
            },
            inseparable,
            samples,
        }
    }

    /// Samples of the middle half.
    pub fn middle(&self) -> Range<usize> {
        middle(&self.samples)
    }
}

fn middle(samples: &Range<usize>) -> Range<usize> {
    let quarter = samples.len() / 4;
    samples.start + quarter..samples.end - quarter
}

/// All standstills in the order of time; both thresholds must be positive.
pub fn standstills(stream: &Stream, still: &Stillness) -> Result<Vec<Standstill>> {
    if !(still.radius_mm > 0.0 && still.duration_s > 0.0) {
        return Err(error!("standstill-thresholds").into());
    }
    let (time_s, points) = (stream.time_s(), stream.positions_mm());
    let mut found: Vec<Range<usize>> = Vec::new();
    let (mut from, mut last) = (0, 0);
    while from < points.len() {
        while last < points.len() && time_s[last] - time_s[from] < still.duration_s {
            last += 1;
        }
        if last == points.len() {
            break;
        }
        match stands(points, from..last + 1, still.radius_mm) {
            None => from += 1,
            Some(end) => {
                // a few distant samples at the end of the arrival do not divide a standstill
                match found.last_mut().filter(|before| {
                    let gap = time_s[from] - time_s[before.end - 1];
                    let apart =
                        || norm(minus(mean_position(&points[middle(before)]), mean_position(&points[from..end])));
                    gap < still.duration_s && apart() <= still.radius_mm
                }) {
                    Some(before) => before.end = end,
                    None => found.push(from..end),
                }
                (from, last) = (end, last.max(end));
            }
        }
    }
    Ok(found.into_iter().map(|samples| Standstill::new(stream, samples)).collect())
}

/// Returns the end of the standstill that starts with these samples, if all of them are within the
/// radius of their mean.
fn stands(points: &[Vector], window: Range<usize>, radius_mm: f64) -> Option<usize> {
    // quick check: two points in a ball are at most a diameter apart
    if norm(minus(points[window.start], points[window.end - 1])) > 2.0 * radius_mm {
        return None;
    }
    let mut mean = mean_position(&points[window.clone()]);
    if points[window.clone()].iter().any(|p| norm(minus(*p, mean)) > radius_mm) {
        return None;
    }
    let mut end = window.end;
    while end < points.len() && norm(minus(points[end], mean)) <= radius_mm {
        end += 1;
        let n = (end - window.start) as f64;
        mean = [0, 1, 2].map(|k| mean[k] + (points[end - 1][k] - mean[k]) / n);
    }
    Some(end)
}

/// Pose that each standstill visits: the nearest of `poses_mm` within `near_mm`.
pub fn visited(standstills: &[Standstill], poses_mm: &[Vector], near_mm: f64) -> Vec<Option<usize>> {
    let away = |s: &Standstill, i: usize| norm(minus(s.mean_mm, poses_mm[i]));
    let nearest = |s: &Standstill| {
        let nearest = (0..poses_mm.len()).min_by(|&i, &j| away(s, i).total_cmp(&away(s, j)));
        nearest.filter(|&i| away(s, i) <= near_mm)
    };
    standstills.iter().map(nearest).collect()
}

/// Places of standstills, for unknown poses: every place at its first visit, if it is farther than
/// `near_mm` from all previous places.
pub fn places_mm(standstills: &[Standstill], near_mm: f64) -> Vec<Vector> {
    let mut places: Vec<Vector> = Vec::new();
    for s in standstills {
        if places.iter().all(|p| norm(minus(*p, s.mean_mm)) > near_mm) {
            places.push(s.mean_mm);
        }
    }
    places
}
