//! Passes of a commanded path in a recorded motion: successive crossings of the normal planes of
//! the command points.

use crate::iso9283::motion::stream::Stream;
use crate::iso9283::path::commanded::CommandPoint;
use etalon_base::message::Result;
use etalon_base::pose::{Vector, dot, minus, norm};
use etalon_base::{error, phrase};
use std::ops::Range;

/// Crossing of an attained path with the plane of a command point, interpolated linearly between
/// two samples.
#[derive(Clone, Debug, PartialEq)]
pub struct Crossing {
    /// Time of the crossing.
    pub time_s: f64,
    /// Position of the crossing.
    pub position_mm: Vector,
    /// Angles at the crossing.
    pub angles_rad: Vec<f64>,
    /// First sample beyond the plane.
    sample: usize,
}

/// One pass, with a crossing for each command point.
#[derive(Clone, Debug, PartialEq)]
pub struct Pass {
    /// Crossings in the order of the command points.
    pub crossings: Vec<Crossing>,
}

impl Pass {
    /// Samples from crossing `first` to crossing `last`.
    pub fn samples(&self, first: usize, last: usize) -> Range<usize> {
        self.crossings[first].sample..self.crossings[last].sample
    }
}

/// Passes of a recording.
#[derive(Clone, Debug, PartialEq)]
pub struct Passes {
    /// Passes through all planes in order.
    pub complete: Vec<Pass>,
    /// Number of abandoned or unfinished passes.
    pub incomplete: usize,
}

/// Finds passes. A crossing counts only within `near_mm` of its command point, which must be less
/// than the distance between two parts of the path, and more than the deviation of the robot.
/// Crossing a plane backwards cancels its crossing, so that noise of a slow robot is harmless: the
/// last crossing counts.
pub fn passes(stream: &Stream, points: &[CommandPoint], near_mm: f64) -> Result<Passes> {
    if points.len() < 2 || near_mm.is_nan() || near_mm <= 0.0 {
        return Err(error!("passes-need-points").into());
    }
    let mut found = Passes { complete: Vec::new(), incomplete: 0 };
    // passes in progress, the oldest first: on a closed path a pass may start before the previous
    // one ends
    let mut begun: Vec<Vec<Crossing>> = Vec::new();
    for sample in 1..stream.len() {
        let crossing = |point: usize, forwards: bool| crossing(stream, sample, &points[point], forwards, near_mm);
        begun.extend(crossing(0, true).map(|first| vec![first]));
        for crossings in &mut begun {
            // one step may cross several planes
            while crossings.len() < points.len()
                && let Some(next) = crossing(crossings.len(), true)
            {
                crossings.push(next);
            }
            while !crossings.is_empty() && crossing(crossings.len() - 1, false).is_some() {
                crossings.pop();
            }
        }
        // a pass that a later pass has caught up with was abandoned
        let mut farthest = 0;
        for i in (0..begun.len()).rev() {
            if begun[i].len() > farthest {
                farthest = begun[i].len();
            } else {
                found.incomplete += usize::from(begun.remove(i).len() > 1);
            }
        }
        // the oldest pass is the farthest
        if farthest == points.len() {
            found.complete.push(Pass { crossings: begun.remove(0) });
        }
    }
    found.incomplete += begun.iter().filter(|crossings| crossings.len() > 1).count();
    Ok(found)
}

/// Crossing of a plane between the previous sample and this sample, in the direction of the path or
/// against it.
fn crossing(stream: &Stream, sample: usize, point: &CommandPoint, forwards: bool, near_mm: f64) -> Option<Crossing> {
    let (from, to) = (stream.positions_mm()[sample - 1], stream.positions_mm()[sample]);
    let beyond = |p: Vector| dot(minus(p, point.position_mm), point.tangent);
    let (a, b) = (beyond(from), beyond(to));
    if (a < 0.0) == (b < 0.0) || (b >= 0.0) != forwards {
        return None;
    }
    let share = a / (a - b);
    let between = |a: f64, b: f64| a + share * (b - a);
    let position_mm = [0, 1, 2].map(|k| between(from[k], to[k]));
    (norm(minus(position_mm, point.position_mm)) <= near_mm).then(|| Crossing {
        time_s: between(stream.time_s()[sample - 1], stream.time_s()[sample]),
        position_mm,
        angles_rad: stream.angles_rad().iter().map(|angle| between(angle[sample - 1], angle[sample])).collect(),
        sample,
    })
}

/// Rejects fewer than `least` passes, and passes of other command points.
pub(crate) fn check(passes: &[Pass], points: &[CommandPoint], least: usize, characteristic: &str) -> Result<()> {
    let of = || phrase!("characteristic", name = characteristic);
    if passes.len() < least {
        return Err(error!("too-few-passes", of = of(), count = passes.len(), least).into());
    }
    if points.is_empty() || passes.iter().any(|pass| pass.crossings.len() != points.len()) {
        return Err(error!("passes-of-other-path", of = of()).into());
    }
    Ok(())
}

/// Positions of all passes at one command point.
pub(crate) fn positions_at(passes: &[Pass], point: usize) -> Vec<Vector> {
    passes.iter().map(|pass| pass.crossings[point].position_mm).collect()
}

/// Angle number `angle` of all passes at one command point.
pub(crate) fn angles_at(passes: &[Pass], point: usize, angle: usize) -> Vec<f64> {
    passes.iter().filter_map(|pass| pass.crossings[point].angles_rad.get(angle).copied()).collect()
}
