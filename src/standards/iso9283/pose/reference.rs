//! Reference targets (not of the standard): targets that do not move, beside the robot, measured again and again, show how
//! instrument and foundation moved against each other; what is measured between is carried back.

use etalon_base::message::Result;
use etalon_base::pose::{Pose, Vector, minus, norm};
use etalon_base::{error, phrase};
use etalon_fit::rigid;

/// One measurement of the reference targets against the first.
#[derive(Clone, Debug, PartialEq)]
pub struct Epoch {
    /// Pose of the coordinates of this epoch in those of the first: carries back what is measured now.
    pub first_T_now: Pose,
    /// Largest movement of a target since the first epoch.
    pub moved_mm: f64,
    /// Root mean square distance of the targets from their first places after they are carried back.
    pub rms_mm: f64,
}

/// The epochs against the first of them: the same targets in the same order in each, at least three, not on one line.
pub fn epochs(targets_mm: &[Vec<Vector>]) -> Result<Vec<Epoch>> {
    let Some(first) = targets_mm.first() else {
        let of = phrase!("characteristic", name = "reference-targets");
        return Err(error!("too-few-of", of, sets = phrase!("epochs", count = 0), least = 1).into());
    };
    let against = |(i, now): (usize, &Vec<Vector>)| -> Result<Epoch> {
        crate::iso9283::statistics::sample::positions(now, 3, "reference-targets")?;
        let moved_mm = now.iter().zip(first).map(|(a, b)| norm(minus(*a, *b))).fold(0.0, f64::max);
        let fitted = rigid(now, first)?;
        // the first lies on itself, without rounding
        let first_T_now = if i == 0 { Pose::identity() } else { fitted.to_T_from };
        Ok(Epoch { first_T_now, moved_mm, rms_mm: fitted.rms_mm() })
    };
    targets_mm.iter().enumerate().map(against).collect()
}
