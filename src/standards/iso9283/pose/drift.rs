//! Drift of pose characteristics dAP, dRP (ISO 9283:1998 7.6, unverified against a bought copy):
//! sets of cycles from a cold start, each with its AP and RP.

use crate::iso9283::pose::accuracy::pose_accuracy;
use crate::iso9283::pose::repeatability::pose_repeatability;
use crate::iso9283::pose::test::{PoseTest, TestedPose};
use etalon_base::message::Result;
use etalon_base::pose::{Vector, centroid, dot, minus, unit};
use etalon_base::pose_name::PoseName;
use etalon_base::{error, phrase};
use statrs::distribution::{ContinuousCDF, StudentsT};
use std::collections::BTreeSet;

/// Drift of one pose.
#[derive(Clone, Debug, PartialEq)]
pub struct Drift {
    /// Name of the pose.
    pub pose: PoseName,
    /// AP of each set.
    pub ap_mm: Vec<f64>,
    /// RP of each set.
    pub rp_mm: Vec<f64>,
    /// dAP: |AP at the start − AP at the end|.
    pub dap_mm: f64,
    /// dRP: |RP at the start − RP at the end|.
    pub drp_mm: f64,
    /// Number of sets until AP settled.
    pub settled_after: Option<usize>,
    /// `true` if dAP exceeds what the scatter within the sets explains, at a significance level of
    /// 0.1 %.
    pub is_significant: bool,
}

/// Number of consecutive quiet sets, and share of the largest change that counts as quiet.
const QUIET_SETS: usize = 5;
const QUIET: f64 = 0.1;
/// Significance level of a drift.
const SIGNIFICANCE: f64 = 0.001;

/// Evaluates drift over at least two sets of at least two positions of one pose.
pub fn drift(pose: PoseName, sets_mm: &[Vec<Vector>], commanded_mm: Vector) -> Result<Drift> {
    if sets_mm.len() < 2 {
        let of = phrase!("characteristic", name = "drift");
        return Err(error!("too-few-of", of, sets = phrase!("sets-of-cycles", count = sets_mm.len()), least = 2).into());
    }
    let ap_mm: Vec<f64> =
        sets_mm.iter().map(|set| Ok(pose_accuracy(set, commanded_mm)?.ap_mm)).collect::<Result<_>>()?;
    let rp_mm: Vec<f64> = sets_mm.iter().map(|set| Ok(pose_repeatability(set)?.rp_mm)).collect::<Result<_>>()?;
    let change = |values: &[f64]| (values[values.len() - 1] - values[0]).abs();
    let dap_mm = change(&ap_mm);
    Ok(Drift {
        pose,
        dap_mm,
        drp_mm: change(&rp_mm),
        settled_after: settled(&ap_mm),
        is_significant: is_significant(dap_mm, sets_mm, commanded_mm),
        ap_mm,
        rp_mm,
    })
}

/// Student's test of dAP: AP of a set has the variance s²/n, with s² along the deviation, pooled
/// over all sets.
fn is_significant(dap_mm: f64, sets_mm: &[Vec<Vector>], commanded_mm: Vector) -> bool {
    let (mut squares, mut degrees) = (0.0, 0);
    for set in sets_mm {
        let Some(mean) = centroid(set) else { continue };
        let along = unit(minus(mean, commanded_mm)).unwrap_or([1.0, 0.0, 0.0]);
        squares += set.iter().map(|p| dot(minus(*p, mean), along).powi(2)).sum::<f64>();
        degrees += set.len() - 1;
    }
    let each = |set: Option<&Vec<Vector>>| set.map_or(f64::INFINITY, |set| 1.0 / set.len() as f64);
    let u = (squares / degrees as f64 * (each(sets_mm.first()) + each(sets_mm.last()))).sqrt();
    let factor = StudentsT::new(0.0, 1.0, degrees as f64).map(|t| t.inverse_cdf(1.0 - 0.5 * SIGNIFICANCE));
    factor.is_ok_and(|factor| dap_mm > factor * u)
}

/// Drift of all commanded poses of a test, in sets of `size` cycles in their order; an incomplete
/// last set does not count.
pub fn drifts(test: &PoseTest, size: usize) -> Result<Vec<Drift>> {
    let drifting = |(p, commanded): (&TestedPose, Vector)| -> Result<Drift> {
        let cycles: BTreeSet<i64> = p.attained.iter().map(|v| v.cycle).collect();
        let cycles: Vec<i64> = cycles.into_iter().collect();
        let sets: Vec<Vec<Vector>> =
            cycles.chunks_exact(size.max(1)).map(|set| p.positions_mm(|v| set.contains(&v.cycle))).collect();
        drift(p.pose, &sets, commanded)
    };
    test.poses.iter().filter_map(|p| Some((p, p.commanded_mm?))).map(drifting).collect()
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
