//! Drift of pose characteristics dAP, dRP (ISO 9283:1998 7.6, unverified against a bought copy):
//! sets of cycles from a cold start, each with its AP and RP.

use crate::iso9283::pose::accuracy::pose_accuracy;
use crate::iso9283::pose::repeatability::pose_repeatability;
use crate::iso9283::pose::test::{PoseTest, TestedPose};
use crate::iso9283::statistics::repeats::student_factor;
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
    /// Expanded uncertainty of dAP: scatter within the sets. Systematic errors of the instrument
    /// cancel.
    pub dap_expanded_uncertainty_mm: Option<f64>,
    /// dRP: |RP at the start − RP at the end|.
    pub drp_mm: f64,
    /// Number of sets until AP settled.
    pub settled_after: Option<usize>,
    /// `true` if dAP exceeds the scatter within the sets, at a significance level of 0.1 %.
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
    let (u, degrees) = dap_uncertainty(sets_mm, commanded_mm);
    Ok(Drift {
        pose,
        dap_mm,
        dap_expanded_uncertainty_mm: student_factor(degrees).map(|factor| factor * u),
        drp_mm: change(&rp_mm),
        settled_after: settled(&ap_mm),
        is_significant: is_significant(dap_mm, u, degrees),
        ap_mm,
        rp_mm,
    })
}

/// Student's test of dAP.
fn is_significant(dap_mm: f64, u: f64, degrees: f64) -> bool {
    let factor = StudentsT::new(0.0, 1.0, degrees).map(|t| t.inverse_cdf(1.0 - 0.5 * SIGNIFICANCE));
    factor.is_ok_and(|factor| dap_mm > factor * u)
}

/// Standard uncertainty of dAP, and its degrees of freedom: AP of a set has the variance s²/n, with
/// s² along the deviation, pooled over all sets (GUM 4.2.3, 4.2.4).
fn dap_uncertainty(sets_mm: &[Vec<Vector>], commanded_mm: Vector) -> (f64, f64) {
    let (mut squares, mut degrees) = (0.0, 0);
    for set in sets_mm {
        let Some(mean) = centroid(set) else { continue };
        let along = unit(minus(mean, commanded_mm)).unwrap_or([1.0, 0.0, 0.0]);
        squares += set.iter().map(|p| dot(minus(*p, mean), along).powi(2)).sum::<f64>();
        degrees += set.len() - 1;
    }
    let each = |set: Option<&Vec<Vector>>| set.map_or(f64::INFINITY, |set| 1.0 / set.len() as f64);
    let u = (squares / degrees as f64 * (each(sets_mm.first()) + each(sets_mm.last()))).sqrt();
    (u, degrees as f64)
}

/// Drift of all commanded poses of a test, in sets of `size` cycles in their order; an incomplete
/// last set does not count.
pub fn drifts(test: &PoseTest, size: usize) -> Result<Vec<Drift>> {
    test.poses.iter().filter_map(|p| pose_drift(p, size)).collect()
}

/// Drift of one pose, in sets of `size` cycles; `None` without a commanded position.
pub fn pose_drift(p: &TestedPose, size: usize) -> Option<Result<Drift>> {
    let commanded = p.commanded_mm?;
    let cycles: BTreeSet<i64> = p.attained.iter().map(|v| v.cycle).collect();
    let cycles: Vec<i64> = cycles.into_iter().collect();
    let sets: Vec<Vec<Vector>> =
        cycles.chunks_exact(size.max(1)).map(|set| p.positions_mm(|v| set.contains(&v.cycle))).collect();
    Some(drift(p.pose, &sets, commanded))
}

/// Largest significant change (mm) of the position of a pose from its first to its last cycle, with
/// the pose: a straight line through each coordinate over the cycles, and Student's test of its
/// slope at 0.1 %, corrected for the number of coordinates of all poses (Bonferroni).
pub fn largest_trend(test: &PoseTest) -> Option<(PoseName, f64)> {
    let level = 0.5 * SIGNIFICANCE / (3 * test.poses.len().max(1)) as f64;
    let change = |p: &TestedPose| {
        let cycles: Vec<f64> = p.attained.iter().map(|v| v.cycle as f64).collect();
        let (n, span) = (cycles.len(), cycles.iter().copied().fold(f64::NEG_INFINITY, f64::max) - cycles.first()?);
        let factor = StudentsT::new(0.0, 1.0, n.checked_sub(2)? as f64).ok()?.inverse_cdf(1.0 - level);
        let middle = cycles.iter().sum::<f64>() / n as f64;
        let squares: f64 = cycles.iter().map(|c| (c - middle).powi(2)).sum();
        let by_axis: [(f64, bool); 3] = std::array::from_fn(|axis| {
            let values = || p.attained.iter().map(|v| v.position_mm[axis]);
            let mean = values().sum::<f64>() / n as f64;
            let slope = cycles.iter().zip(values()).map(|(c, v)| (c - middle) * (v - mean)).sum::<f64>() / squares;
            let left: f64 = cycles.iter().zip(values()).map(|(c, v)| (v - mean - slope * (c - middle)).powi(2)).sum();
            let u = (left / (n - 2) as f64 / squares).sqrt();
            (slope * span, slope.abs() > factor * u)
        });
        let significant = by_axis.iter().any(|(_, is_significant)| *is_significant);
        let change_mm = by_axis.iter().map(|(change, _)| change.powi(2)).sum::<f64>().sqrt();
        (significant && change_mm.is_finite()).then_some((p.pose, change_mm))
    };
    test.poses.iter().filter_map(change).max_by(|a, b| a.1.total_cmp(&b.1))
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::iso9283::pose::test::AttainedPose;
    use etalon_base::noise::Noise;

    /// Thirty cycles of three poses with a scatter of 10 µm; pose 2 moves along y.
    fn test(moves_mm: f64, seed: u64) -> PoseTest {
        let mut noise = Noise::new(9283, seed);
        let mut attained = |pose: i64, cycle: i64| {
            let moved_mm = if pose == 2 { moves_mm * (cycle - 1) as f64 / 29.0 } else { 0.0 };
            let position_mm = [noise.gaussian(0.01), moved_mm + noise.gaussian(0.01), noise.gaussian(0.01)];
            AttainedPose {
                cycle,
                position_mm,
                angles_rad: Vec::new(),
                approach: None,
                robot: String::new(),
                readings_mm: vec![position_mm],
                readings_rad: Vec::new(),
            }
        };
        let pose = |pose: i64| TestedPose {
            pose: pose.into(),
            commanded_mm: None,
            commanded_rad: Vec::new(),
            attained: (1..=30).map(|cycle| attained(pose, cycle)).collect(),
        };
        let poses = [1, 2, 3].map(pose).into();
        PoseTest { poses, spatial: true, angles: Vec::new(), rotation_order: None, warnings: Vec::new() }
    }

    /// Coverage of 95.45 %: 1909 of 2000 intervals, with a standard deviation of 9.
    #[test]
    fn the_uncertainty_of_a_drift_covers_it() {
        let commanded = [0.0, -1.0, 0.0];
        let covers = |seed: u64| {
            let test = test(0.0, seed);
            let positions: Vec<Vector> = test.poses[0].attained.iter().map(|v| v.position_mm).collect();
            let sets: Vec<Vec<Vector>> = positions.chunks(5).map(<[Vector]>::to_vec).collect();
            let found = drift(1.into(), &sets, commanded).unwrap();
            found.dap_mm <= found.dap_expanded_uncertainty_mm.unwrap()
        };
        let covered = (0..2000).filter(|seed| covers(*seed)).count();
        assert!((1873..=1945).contains(&covered), "{covered}");
    }

    #[test]
    fn a_trend_is_found_in_its_size_and_scatter_alone_is_none() {
        let (pose, change_mm) = largest_trend(&test(0.1, 1)).unwrap();
        assert_eq!(pose, PoseName::from(2_i64));
        assert!((change_mm - 0.1).abs() < 0.02, "{change_mm}");
        // level 0.1 % for all poses together: 2 of 2000 are expected, and 9 or more once in 4000
        // such series
        let found = (0..2000).filter(|seed| largest_trend(&test(0.0, *seed)).is_some()).count();
        assert!(found < 9, "{found}");
    }
}
