//! A recorded motion: positions, and where there are angles, over time.

use crate::iso9283::statistics::sample::followed;
use etalon_base::message::{Message, Problems};
use etalon_base::pose::{Vector, minus, norm};
use etalon_base::{error, phrase};

/// Samples in the order of recording. Time goes on from each to the next, every number is finite, angles do not jump.
#[derive(Clone, Debug, PartialEq)]
pub struct Stream {
    time_s: Vec<f64>,
    positions_mm: Vec<Vector>,
    /// One list of all samples for each angle that exists.
    angles_rad: Vec<Vec<f64>>,
}

/// A motion as it was recorded.
#[derive(Clone, Debug, PartialEq)]
pub struct Recording {
    /// The samples that count.
    pub stream: Stream,
    /// Whether there is a z.
    pub spatial: bool,
    /// Which angles there are: of 0, 1, 2 for a, b, c.
    pub angles: Vec<usize>,
    /// Lines of samples that no robot reaches from the one before.
    pub left_out: Vec<usize>,
}

/// What makes a sample unusable.
#[derive(Clone, Debug, PartialEq)]
pub struct Unusable {
    /// Number of the sample, from 0; that of samples where there are too few.
    pub sample: usize,
    /// What is wrong.
    pub message: Message,
    /// `true` if its time stamp is not later than the one before: stamps may be coarser than the sampling rate.
    pub is_late: bool,
}

impl From<Unusable> for Problems {
    fn from(unusable: Unusable) -> Self {
        unusable.message.within(phrase!("in-sample", sample = unusable.sample + 1)).into()
    }
}

/// No robot's tool moves faster than this, in mm/s: what does is not a motion.
pub const FASTEST_MM_S: f64 = 20_000.0;

impl Stream {
    /// At least two samples; as many in each list of angles as there are positions.
    pub fn new(time_s: Vec<f64>, positions_mm: Vec<Vector>, angles_rad: &[Vec<f64>]) -> Result<Self, Unusable> {
        let n = positions_mm.len();
        let wrong = |sample: usize, message: Message| Err(Unusable { sample, message, is_late: false });
        if n < 2 || time_s.len() != n || angles_rad.iter().any(|a| a.len() != n) {
            return wrong(n, error!("stream-too-short"));
        }
        for i in 0..n {
            let angles = angles_rad.iter().map(|a| a[i]);
            // squares of more are not finite
            if !positions_mm[i].iter().copied().chain(angles).chain([time_s[i]]).all(|v| v.abs() < 1e100) {
                return wrong(i, error!("stream-value-missing"));
            }
            if i > 0 && time_s[i] <= time_s[i - 1] {
                let message = error!("time-not-increasing", later_s = time_s[i], earlier_s = time_s[i - 1]);
                return Err(Unusable { sample: i, message, is_late: true });
            }
        }
        Ok(Self { time_s, positions_mm, angles_rad: angles_rad.iter().map(|a| followed(a)).collect() })
    }

    /// The same without samples that no robot reaches from the one before (faster than [`FASTEST_MM_S`]), and their
    /// numbers.
    pub fn without_jumps(self) -> (Self, Vec<usize>) {
        let reached = |before: usize, i: usize| {
            let (from, to) = (self.positions_mm[before], self.positions_mm[i]);
            norm(minus(to, from)) <= FASTEST_MM_S * (self.time_s[i] - self.time_s[before])
        };
        // the first that leads to one of the next two: it may be a jump itself
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

    /// Never: there are two samples at least.
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

    /// Each angle that exists, over all samples, without jumps of a turn.
    pub fn angles_rad(&self) -> &[Vec<f64>] {
        &self.angles_rad
    }
}
