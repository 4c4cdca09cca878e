//! Static compliance (ISO 9283:1998 10, unverified against a bought copy): how far a loaded robot gives way, in mm/N, along
//! the force; forces in steps of 10 % up to the rated load, both ways along each axis, three times.

use crate::base::message::{Message, Result};
use crate::base::pose::{Vector, dot, minus};

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
    super::positions(&ends, 2, "static compliance")?;
    if readings.iter().any(|r| !(r.force_n > 0.0 && r.force_n.is_finite())) {
        let message = Message::error("static compliance: a force is not positive");
        return Err(message.expected("the size of the force; its direction gives the sign").into());
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
