//! Reference targets (not in the standard): stationary targets near the robot that are measured
//! repeatedly. They show relative movements of instrument and foundation, for which measurements
//! are compensated.

use etalon_base::message::Result;
use etalon_base::pose::{Pose, Vector, minus, norm};
use etalon_base::{error, phrase};
use etalon_fit::rigid;

/// One measurement of the reference targets, compared with the first.
#[derive(Clone, Debug, PartialEq)]
pub struct Epoch {
    /// Transformation from the coordinates of this epoch to the coordinates of the first, which
    /// compensates for the drift.
    pub first_T_now: Pose,
    /// Largest movement of a target since the first epoch.
    pub moved_mm: f64,
    /// Root mean square distance of the targets from their first positions after drift
    /// compensation.
    pub rms_mm: f64,
}

/// Compares epochs with the first epoch. Each has the same targets in the same order, at least
/// three and non-collinear.
pub fn epochs(targets_mm: &[Vec<Vector>]) -> Result<Vec<Epoch>> {
    let Some(first) = targets_mm.first() else {
        let of = phrase!("characteristic", name = "reference-targets");
        return Err(error!("too-few-of", of, sets = phrase!("epochs", count = 0), least = 1).into());
    };
    let against = |(i, now): (usize, &Vec<Vector>)| -> Result<Epoch> {
        crate::iso9283::statistics::sample::positions(now, 3, "reference-targets")?;
        let moved_mm = now.iter().zip(first).map(|(a, b)| norm(minus(*a, *b))).fold(0.0, f64::max);
        let fitted = rigid(now, first)?;
        // the first epoch coincides with itself, without rounding
        let first_T_now = if i == 0 { Pose::identity() } else { fitted.to_T_from };
        Ok(Epoch { first_T_now, moved_mm, rms_mm: fitted.rms_mm() })
    };
    targets_mm.iter().enumerate().map(against).collect()
}
