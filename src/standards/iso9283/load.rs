//! Static compliance (ISO 9283:1998 10, unverified against a bought copy): displacement of a loaded
//! robot per force (mm/N), along the force. Forces increase in steps of 10 % up to the rated load,
//! in both directions along each axis, three times.

use crate::iso9283::statistics::sample::positions;
use etalon_base::error;
use etalon_base::message::Result;
use etalon_base::pose::{Vector, centroid, dot, minus};

/// Compliance of a robot under forces in one direction.
#[derive(Clone, Debug, PartialEq)]
pub struct Compliance {
    /// Slope of the displacement along the force over the force, for a line through the unloaded
    /// position.
    pub compliance_mm_n: f64,
    /// Standard uncertainty of the slope from the scatter about the line; NaN with fewer than two
    /// readings.
    pub standard_uncertainty_mm_n: f64,
    /// Largest displacement along the force.
    pub largest_mm: f64,
    /// Largest distance of a reading from the line: backlash and inelastic effects.
    pub off_line_mm: f64,
}

/// One reading under load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Loaded {
    /// Force in the given direction (positive).
    pub force_n: f64,
    /// Position under load.
    pub position_mm: Vector,
    /// Preceding position without load.
    pub unloaded_mm: Vector,
}

/// Evaluates compliance along `direction`, a unit vector; at least one reading with a force is
/// needed.
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

/// Names and directions of forces.
pub const DIRECTIONS: [(&str, Vector); 6] = [
    ("+x", [1.0, 0.0, 0.0]),
    ("-x", [-1.0, 0.0, 0.0]),
    ("+y", [0.0, 1.0, 0.0]),
    ("-y", [0.0, -1.0, 0.0]),
    ("+z", [0.0, 0.0, 1.0]),
    ("-z", [0.0, 0.0, -1.0]),
];
/// Number of repeats that the standard requires (unverified).
pub const CYCLES: usize = 3;

/// Position of a robot with or without load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoadReading {
    /// Direction of the force, an index of [`DIRECTIONS`].
    pub direction: usize,
    /// Number of the cycle.
    pub cycle: i64,
    /// Force; zero without load.
    pub force_n: f64,
    /// Position.
    pub position_mm: Vector,
}

/// Compliance in one direction.
#[derive(Clone, Debug, PartialEq)]
pub struct DirectionalCompliance {
    /// Name of the direction.
    pub direction: &'static str,
    /// Number of readings under load.
    pub readings: usize,
    /// Number of repeats.
    pub cycles: usize,
    /// Largest force.
    pub force_n: f64,
    /// Compliance along the direction.
    pub compliance: Compliance,
}

/// Evaluates every direction with readings. Each cycle holds one position without force, as the
/// reference, and readings under load.
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
