//! The offsets d1 and d3, from one displacement of actuator 1 (thesis 2.6.4).

use super::base::Base;
use super::mobile::Mobile;
use super::uncertain::{Readings, Uncertain};
use crate::base::message::{Message, Result};
use crate::base::pose::Vector;

/// Balls K and L after homing and moving actuators 2 and 3 to mid-travel, and K after actuator 1 went to its end.
#[derive(Clone, Copy, Debug)]
pub struct OffsetMeasurements {
    /// Commanded displacement of actuator 2, in mm.
    pub rho2_mm: f64,
    /// Commanded displacement of actuator 3, in mm.
    pub rho3_mm: f64,
    /// Ball K with actuator 1 homed.
    pub k: Vector,
    /// Ball L with actuator 1 homed.
    pub l: Vector,
    /// Ball K with actuator 1 at its end.
    pub k_end: Vector,
}

/// d1 and d3 of one homing.
///
/// Eq. 2.11 takes actuators 2 and 3 as displaced equally; what their `leads` make of the commanded displacements is
/// taken off: d3 = s Δy/Δx − (δ3 ρ3 − δ2 ρ2).
pub fn offsets(
    readings: &mut Readings,
    base: &Base,
    mobile: &Mobile,
    s: &Uncertain,
    leads: [&Uncertain; 2],
    measured: &OffsetMeasurements,
) -> Result<[Uncertain; 2]> {
    let [k, l, k_end] = [measured.k, measured.l, measured.k_end].map(|p| base.plane.project(&readings.add_one(p)));
    let [d1, _] = base.express(&mobile.centre(&k, &l));
    let (from, to) = (base.express(&k), base.express(&k_end));
    let travelled = (to[0].value - from[0].value).abs();
    if travelled.is_nan() || travelled < 1.0 {
        return Err(Message::error("ball K has moved less than 1 mm along x while actuator 1 went to its end")
            .hint("measure K again after moving actuator 1 alone, as far as it goes")
            .into());
    }
    let (rho2, rho3) = (measured.rho2_mm, measured.rho3_mm);
    let inputs = [s, &from[0], &from[1], &to[0], &to[1], leads[0], leads[1]];
    let [d3] = Uncertain::of(inputs, |[s, x0, y0, x1, y1, delta2, delta3]| {
        [s * ((y1 - y0) / (x1 - x0)) - (delta3 * rho3 - delta2 * rho2)] // eq. 2.11
    });
    Ok([d1, d3])
}
