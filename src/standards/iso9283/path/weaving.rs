//! Weaving deviations (ISO 9283:1998 11, unverified against a bought copy): stroke WS and frequency
//! WF of a path that oscillates about its centre line.

use crate::iso9283::motion::stream::Stream;
use crate::iso9283::statistics::sample::spread;
use etalon_base::error;
use etalon_base::message::Result;
use etalon_base::pose::{Vector, dot, minus, unit};
use std::ops::Range;

/// Weaving deviations of one pass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Weaving {
    /// Mean distance between successive turns on opposite sides, across the centre line.
    pub stroke_mm: f64,
    /// Number of full swings per second.
    pub frequency_hz: f64,
    /// WS: attained minus commanded stroke (% of the commanded stroke).
    pub ws_percent: f64,
    /// WF: attained minus commanded frequency (% of the commanded frequency).
    pub wf_percent: f64,
    /// Number of turns.
    pub turns: usize,
}

/// Weaving deviations, means of all passes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WeaveCharacteristics {
    /// Number of passes of the centre line.
    pub passes: usize,
    /// Number of turns in all passes.
    pub turns: usize,
    /// Commanded stroke from side to side.
    pub commanded_stroke_mm: f64,
    /// Attained stroke.
    pub stroke_mm: f64,
    /// Commanded frequency: full swings per second.
    pub commanded_frequency_hz: f64,
    /// Attained frequency.
    pub frequency_hz: f64,
    /// WS (% of the commanded stroke).
    pub ws_percent: f64,
    /// WF (% of the commanded frequency).
    pub wf_percent: f64,
}

impl WeaveCharacteristics {
    /// Means over at least one pass of the centre line.
    pub(crate) fn new(weave: &Weave, passes: &[Weaving]) -> Self {
        let mean = |of: fn(&Weaving) -> f64| passes.iter().map(of).sum::<f64>() / passes.len() as f64;
        Self {
            passes: passes.len(),
            turns: passes.iter().map(|w| w.turns).sum(),
            commanded_stroke_mm: weave.stroke_mm,
            stroke_mm: mean(|w| w.stroke_mm),
            commanded_frequency_hz: weave.frequency_hz,
            frequency_hz: mean(|w| w.frequency_hz),
            ws_percent: mean(|w| w.ws_percent),
            wf_percent: mean(|w| w.wf_percent),
        }
    }
}

/// Commanded weave.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Weave {
    /// Direction of the weave across the centre line.
    pub across: Vector,
    /// Stroke from side to side.
    pub stroke_mm: f64,
    /// Full swings per second.
    pub frequency_hz: f64,
}

/// Evaluates the weave in samples of a recorded motion about a centre line in the direction
/// `along`. A turn counts if the path returns by a quarter of the commanded stroke, which noise
/// does not reach. The first and the last turn may belong to a standing robot and do not count; at
/// least three others are needed.
pub fn weaving(stream: &Stream, samples: Range<usize>, along: Vector, weave: &Weave) -> Result<Weaving> {
    let positive = |v: f64| v > 0.0 && v.is_finite();
    let along = unit(along).ok_or_else(|| error!("weave-direction"))?;
    let part = dot(weave.across, along);
    let across = unit([0, 1, 2].map(|k| weave.across[k] - part * along[k]));
    let across = across.ok_or_else(|| error!("weave-direction"))?;
    if !positive(weave.stroke_mm) || !positive(weave.frequency_hz) {
        return Err(error!("weave-command").into());
    }
    if samples.end > stream.len() || samples.is_empty() {
        return Err(error!("weave-without-samples").into());
    }
    let origin = stream.positions_mm()[samples.start];
    let points = &stream.positions_mm()[samples.clone()];
    let swing: Vec<f64> = points.iter().map(|p| dot(minus(*p, origin), across)).collect();
    let turns = turns(&swing, 0.25 * weave.stroke_mm);
    let inner = turns.get(1..turns.len().saturating_sub(1)).unwrap_or_default();
    if inner.len() < 3 {
        return Err(error!("weave-too-few-turns", turns = turns.len()).into());
    }
    let strokes: Vec<f64> = inner.windows(2).map(|t| (swing[t[1]] - swing[t[0]]).abs()).collect();
    let time_s = |turn: usize| stream.time_s()[samples.start + turn];
    let stroke_mm = spread(&strokes).mean;
    let frequency_hz = 0.5 * (inner.len() - 1) as f64 / (time_s(inner[inner.len() - 1]) - time_s(inner[0]));
    Ok(Weaving {
        stroke_mm,
        frequency_hz,
        ws_percent: (stroke_mm - weave.stroke_mm) / weave.stroke_mm * 100.0,
        wf_percent: (frequency_hz - weave.frequency_hz) / weave.frequency_hz * 100.0,
        turns: inner.len(),
    })
}

/// Indices of turning points: alternating extremes followed by a change of more than `dead`.
fn turns(values: &[f64], dead: f64) -> Vec<usize> {
    let mut found: Vec<usize> = Vec::new();
    let (mut low, mut high, mut upwards) = (0, 0, None);
    for (i, &v) in values.iter().enumerate() {
        if v > values[high] {
            high = i;
        }
        if v < values[low] {
            low = i;
        }
        if upwards != Some(false) && values[high] - v > dead {
            found.push(high);
            (low, upwards) = (i, Some(false));
        } else if upwards != Some(true) && v - values[low] > dead {
            found.push(low);
            (high, upwards) = (i, Some(true));
        }
    }
    found
}
