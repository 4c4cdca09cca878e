//! Drift of pose characteristics dAP, dRP (ISO 9283:1998 7.6, unverified against a bought copy): sets of cycles from cold
//! start, each with its own AP and RP.

use crate::iso9283::pose::accuracy::pose_accuracy;
use crate::iso9283::pose::repeatability::pose_repeatability;
use etalon_base::message::{Message, Result};
use etalon_base::pose::Vector;
use etalon_base::pose_name::PoseName;
use etalon_documents::Iso9283Drift;

/// Sets in a row that must be quiet, and the share of the largest change that counts as quiet.
const QUIET_SETS: usize = 5;
const QUIET: f64 = 0.1;

/// Drift over at least two sets of at least two positions of one pose.
pub fn drift(pose: PoseName, sets_mm: &[Vec<Vector>], commanded_mm: Vector) -> Result<Iso9283Drift> {
    if sets_mm.len() < 2 {
        let message = Message::error(format!("drift: {} sets of cycles", sets_mm.len()));
        return Err(message.expected("at least two").into());
    }
    let ap_mm: Vec<f64> =
        sets_mm.iter().map(|set| Ok(pose_accuracy(set, commanded_mm)?.ap_mm)).collect::<Result<_>>()?;
    let rp_mm: Vec<f64> = sets_mm.iter().map(|set| Ok(pose_repeatability(set)?.rp_mm)).collect::<Result<_>>()?;
    let change = |values: &[f64]| (values[values.len() - 1] - values[0]).abs();
    Ok(Iso9283Drift {
        pose,
        dap_mm: change(&ap_mm),
        drp_mm: change(&rp_mm),
        settled_after: settled(&ap_mm),
        ap_mm,
        rp_mm,
    })
}

fn settled(ap_mm: &[f64]) -> Option<usize> {
    let (mut largest, mut quiet) = (0.0f64, 0);
    for (i, pair) in ap_mm.windows(2).enumerate() {
        let change = (pair[1] - pair[0]).abs();
        largest = largest.max(change);
        quiet = if change <= QUIET * largest { quiet + 1 } else { 0 };
        if quiet == QUIET_SETS {
            return Some(i + 2);
        }
    }
    None
}
