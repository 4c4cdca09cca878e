//! Recorded motion: positions and, if measured, angles over time.

use crate::iso9283::statistics::sample::followed;
use etalon_base::message::{Message, Problems};
use etalon_base::pose::{Vector, minus, norm};
use etalon_base::{error, phrase};

/// Samples in the order of recording. Times increase, all numbers are finite, and angles are
/// continuous.
#[derive(Clone, Debug, PartialEq)]
pub struct Stream {
    time_s: Vec<f64>,
    positions_mm: Vec<Vector>,
    /// Samples of each measured angle.
    angles_rad: Vec<Vec<f64>>,
}

/// A motion as it was recorded.
#[derive(Clone, Debug, PartialEq)]
pub struct Recording {
    /// Valid samples.
    pub stream: Stream,
    /// `true` if z was measured.
    pub spatial: bool,
    /// Measured angles: 0, 1, 2 for a, b, c.
    pub angles: Vec<usize>,
    /// Lines of samples that no robot reaches from the previous sample in time.
    pub left_out: Vec<usize>,
}

/// Reason why a sample is unusable.
#[derive(Clone, Debug, PartialEq)]
pub struct Unusable {
    /// Number of the sample, from 0; number of samples if there are too few.
    pub sample: usize,
    /// Description of the error.
    pub message: Message,
    /// `true` if the time stamps are coarser than the sampling: they repeat at other positions, and
    /// never decrease.
    pub is_coarse: bool,
}

impl From<Unusable> for Problems {
    fn from(unusable: Unusable) -> Self {
        unusable.message.within(phrase!("in-sample", sample = unusable.sample + 1)).into()
    }
}

/// `true` if time stamps repeat at other positions and never decrease. Rows in another order have
/// decreasing stamps, repeated rows have equal positions.
fn are_coarse(time_s: &[f64], positions_mm: &[Vector]) -> bool {
    let steps = || time_s.windows(2).zip(positions_mm.windows(2));
    !steps().any(|(time, _)| time[1] < time[0]) && steps().any(|(time, p)| time[1] == time[0] && p[1] != p[0])
}

/// Highest plausible velocity of a robot's tool (mm/s); faster samples are not motion.
pub const FASTEST_MM_S: f64 = 20_000.0;

impl Stream {
    /// Checks at least two samples; each list of angles is as long as the list of positions.
    pub fn new(time_s: Vec<f64>, positions_mm: Vec<Vector>, angles_rad: &[Vec<f64>]) -> Result<Self, Unusable> {
        let n = positions_mm.len();
        let wrong = |sample: usize, message: Message| Err(Unusable { sample, message, is_coarse: false });
        if n < 2 || time_s.len() != n || angles_rad.iter().any(|a| a.len() != n) {
            return wrong(n, error!("stream-too-short"));
        }
        for i in 0..n {
            let angles = angles_rad.iter().map(|a| a[i]);
            // larger values have non-finite squares
            if !positions_mm[i].iter().copied().chain(angles).chain([time_s[i]]).all(|v| v.abs() < 1e100) {
                return wrong(i, error!("stream-value-missing"));
            }
            if i > 0 && time_s[i] <= time_s[i - 1] {
                let message = error!("time-not-increasing", later_s = time_s[i], earlier_s = time_s[i - 1]);
                let is_coarse = are_coarse(&time_s, &positions_mm);
                return Err(Unusable { sample: i, message, is_coarse });
            }
        }
        Ok(Self { time_s, positions_mm, angles_rad: angles_rad.iter().map(|a| followed(a)).collect() })
    }

    /// Removes samples that no robot reaches from the previous sample (faster than
    /// [`FASTEST_MM_S`]); also returns their numbers.
    pub fn without_jumps(self) -> (Self, Vec<usize>) {
        let reached = |before: usize, i: usize| {
            let (from, to) = (self.positions_mm[before], self.positions_mm[i]);
            norm(minus(to, from)) <= FASTEST_MM_S * (self.time_s[i] - self.time_s[before])
        };
        // start with the first sample that leads to one of the next two, as the very first may be a
        // jump
        let leads = |i: &usize| (i + 1..(i + 3).min(self.len())).any(|next| reached(*i, next));
        let first = (0..self.len()).find(leads).unwrap_or(0);
        let mut kept = vec![first];
        let mut jumps: Vec<usize> = (0..first).collect();
        for i in first + 1..self.len() {
            if kept.last().is_some_and(|&before| reached(before, i)) { kept.push(i) } else { jumps.push(i) }
        }
        let of = |values: &[f64]| kept.iter().map(|&i| values[i]).collect::<Vec<_>>();
        let stream = Self {
            time_s: of(&self.time_s),
            positions_mm: kept.iter().map(|&i| self.positions_mm[i]).collect(),
            angles_rad: self.angles_rad.iter().map(|a| of(a)).collect(),
        };
        (stream, jumps)
    }

    /// Number of samples.
    pub fn len(&self) -> usize {
        self.positions_mm.len()
    }

    /// Always `false`: there are at least two samples.
    pub fn is_empty(&self) -> bool {
        self.positions_mm.is_empty()
    }

    /// Time of each sample.
    pub fn time_s(&self) -> &[f64] {
        &self.time_s
    }

    /// Position at each sample.
    pub fn positions_mm(&self) -> &[Vector] {
        &self.positions_mm
    }

    /// Samples of each measured angle, without jumps by full turns.
    pub fn angles_rad(&self) -> &[Vec<f64>] {
        &self.angles_rad
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Samples of a motion along x with these time stamps.
    fn refused(time_s: &[f64], x_mm: impl Fn(usize) -> f64) -> Unusable {
        let positions = (0..time_s.len()).map(|i| [x_mm(i), 0.0, 0.0]).collect();
        Stream::new(time_s.to_vec(), positions, &[]).unwrap_err()
    }

    #[test]
    fn coarse_time_stamps_repeat_and_never_decrease() {
        let moving = |i: usize| i as f64;
        let coarse = refused(&[0.0, 0.0, 0.01, 0.01, 0.02], moving);
        assert!(coarse.is_coarse && coarse.sample == 1, "{coarse:?}");
        // the second half of a recording before the first
        let exchanged = refused(&[0.002, 0.003, 0.0, 0.001], moving);
        assert!(!exchanged.is_coarse && exchanged.sample == 2, "{exchanged:?}");
        // in full seconds as well: a sampling rate would make a motion of it
        let both = refused(&[0.0, 0.0, 2.0, 1.0], moving);
        assert!(!both.is_coarse && both.sample == 1, "{both:?}");
        // a row twice
        let repeated = refused(&[0.0, 0.001, 0.001, 0.002], |i| [0.0, 1.0, 1.0, 2.0][i]);
        assert!(!repeated.is_coarse && repeated.sample == 2, "{repeated:?}");
        assert!(exchanged.message.is("time-not-increasing", &[("later_s", &0.0), ("earlier_s", &0.003)]));
        let short = Stream::new(vec![0.0], vec![[0.0; 3]], &[]).unwrap_err();
        assert!(!short.is_coarse && short.message.is("stream-too-short", &[]));
    }
}
