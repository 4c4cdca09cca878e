//! Static compliance (ISO 9283:1998 10, unverified against a bought copy): how far a loaded robot gives way, in mm/N, along
//! the force; forces in steps of 10 % up to the rated load, both ways along each axis, three times.

use crate::iso9283::statistics::sample::positions;
use etalon_base::error;
use etalon_base::message::Result;
use etalon_base::pose::{Vector, centroid, dot, minus};

/// A robot pulled along one direction.
#[derive(Clone, Debug, PartialEq)]
pub struct Compliance {
    /// Displacement along the force by force, as a line through the unloaded position fits it.
    pub compliance_mm_n: f64,
    /// Standard uncertainty of it from the scatter about the line; NaN with fewer than two readings.
    pub standard_uncertainty_mm_n: f64,
    /// Largest displacement along the force.
    pub largest_mm: f64,
    /// Largest distance of a reading from the line: backlash and what is not elastic.
    pub off_line_mm: f64,
}

/// One reading under load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Loaded {
    /// Force in the stated direction, positive.
    pub force_n: f64,
    /// Position under it.
    pub position_mm: Vector,
    /// Position without load before it.
    pub unloaded_mm: Vector,
}

/// Compliance along `direction`, a unit vector; at least one reading with a force.
pub fn compliance(readings: &[Loaded], direction: Vector) -> Result<Compliance> {
    let ends: Vec<Vector> = readings.iter().flat_map(|r| [r.position_mm, r.unloaded_mm]).collect();
    positions(&ends, 2, "static-compliance")?;
    if readings.iter().any(|r| !(r.force_n > 0.0 && r.force_n.is_finite())) {
        return Err(error!("force-not-positive").into());
    }
    let given: Vec<f64> = readings.iter().map(|r| dot(minus(r.position_mm, r.unloaded_mm), direction)).collect();
    let squares: f64 = readings.iter().map(|r| r.force_n * r.force_n).sum();
    let slope = readings.iter().zip(&given).map(|(r, d)| r.force_n * d).sum::<f64>() / squares;
    let off: Vec<f64> = readings.iter().zip(&given).map(|(r, d)| d - slope * r.force_n).collect();
    let variance = off.iter().map(|o| o * o).sum::<f64>() / (readings.len() as f64 - 1.0);
    Ok(Compliance {
        compliance_mm_n: slope,
        standard_uncertainty_mm_n: (variance / squares).sqrt(),
        largest_mm: given.iter().fold(0.0, |a: f64, d| if d.abs() > a.abs() { *d } else { a }),
        off_line_mm: off.iter().fold(0.0, |a, o| a.max(o.abs())),
    })
}

/// Directions of forces, and their names.
pub const DIRECTIONS: [(&str, Vector); 6] = [
    ("+x", [1.0, 0.0, 0.0]),
    ("-x", [-1.0, 0.0, 0.0]),
    ("+y", [0.0, 1.0, 0.0]),
    ("-y", [0.0, -1.0, 0.0]),
    ("+z", [0.0, 0.0, 1.0]),
    ("-z", [0.0, 0.0, -1.0]),
];
/// Repeats that the standard asks for (unverified).
pub const CYCLES: usize = 3;

/// The position of a robot that may be loaded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoadReading {
    /// The direction of the force, one of [`DIRECTIONS`].
    pub direction: usize,
    /// Number of the cycle.
    pub cycle: i64,
    /// The force; zero without load.
    pub force_n: f64,
    /// The position.
    pub position_mm: Vector,
}

/// Compliance in one direction.
#[derive(Clone, Debug, PartialEq)]
pub struct DirectionalCompliance {
    /// Name of the direction.
    pub direction: &'static str,
    /// Readings under load.
    pub readings: usize,
    /// Repeats.
    pub cycles: usize,
    /// Largest force.
    pub force_n: f64,
    /// Compliance along the direction.
    pub compliance: Compliance,
}

/// Compliance in every direction that has readings: in each cycle one without force, the position
/// that the others are compared with, and readings under load.
pub fn evaluate(readings: &[LoadReading]) -> Result<Vec<DirectionalCompliance>> {
    let mut directions = Vec::new();
    for (k, (name, direction)) in DIRECTIONS.iter().enumerate() {
        let of: Vec<&LoadReading> = readings.iter().filter(|r| r.direction == k).collect();
        let mut loaded = Vec::new();
        for r in of.iter().filter(|r| r.force_n > 0.0) {
            let without = of.iter().filter(|o| o.cycle == r.cycle && o.force_n == 0.0).map(|o| o.position_mm);
            let Some(unloaded_mm) = centroid(&without.collect::<Vec<_>>()) else {
                return Err(error!("unloaded-position-missing", direction = name, cycle = r.cycle).into());
            };
            loaded.push(Loaded { force_n: r.force_n, position_mm: r.position_mm, unloaded_mm });
        }
        if loaded.is_empty() {
            continue;
        }
        let mut cycles: Vec<i64> = of.iter().filter(|r| r.force_n > 0.0).map(|r| r.cycle).collect();
        cycles.sort_unstable();
        cycles.dedup();
        directions.push(DirectionalCompliance {
            direction: name,
            readings: loaded.len(),
            cycles: cycles.len(),
            force_n: loaded.iter().map(|l| l.force_n).fold(0.0, f64::max),
            compliance: compliance(&loaded, *direction)?,
        });
    }
    if directions.is_empty() {
        return Err(error!("force-missing").into());
    }
    Ok(directions)
}
