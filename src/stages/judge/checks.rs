//! Checks of the model from its residuals: trends, mutual control of readings, and influential
//! poses; and of targets against their given positions.

use crate::stages::truncated;
use etalon_base::message::{AnsweredBy, Message};
use etalon_base::pose::{Vector, minus, norm};
use etalon_base::pose_name::PoseName;
use etalon_base::{phrase, warning};
use etalon_documents::{
    InfluenceEntry, PointError, PoseSet, ReadingReliability, ReliabilitySummary, ResidualTrend, RobustParameter,
    RobustPose, RobustSummary,
};
use etalon_identify::{
    ALPHA_0, BETA_0, CRITICAL_W, Identification, PoseInfluence, PoseWeight, Reliability, RobustChange,
    RobustComparison, Variance, holm,
};
use etalon_math::statistics::median;
use etalon_robots::{Robot, Role};
use nalgebra::DVector;
use std::collections::BTreeMap;

/// Maximum number of poses in a summary.
const NAMED: usize = 5;
/// Distance (mm) of an identified target from its given position that a drawing of a tool explains.
const DRAWN_MM: f64 = 10.0;
/// Standard uncertainties of the identified position within which it is not far.
const CERTAIN: f64 = 3.0;
/// Minimum number of poses for a test of trends.
const FEWEST: usize = 10;

/// Warnings of targets that are far from their given positions. A target at the origin of the
/// flange has no given position.
pub(crate) fn far_targets(robot: &dyn Robot, found: &Identification) -> Vec<Message> {
    let parameters = robot.parameters();
    let target = |target: &String| {
        let index = |axis: &str| robot.index(&format!("{target}_{axis}"));
        let axes = [index("x")?, index("y")?, index("z")?];
        if robot.free_base().is_none() || axes.iter().any(|&i| parameters[i].role != Role::Target) {
            return None;
        }
        let (stated, identified) = (axes.map(|i| parameters[i].nominal), axes.map(|i| found.values[i]));
        let uncertainty = norm(axes.map(|i| found.standard_uncertainty(i).unwrap_or(0.0)));
        let distance_mm = norm(minus(identified, stated));
        let is_far = norm(stated) > 0.0 && distance_mm > DRAWN_MM.max(CERTAIN * uncertainty);
        let ([x_mm, y_mm, z_mm], [sx_mm, sy_mm, sz_mm]) = (identified, stated);
        is_far.then(|| warning!("target-far-from-given", target, distance_mm, x_mm, y_mm, z_mm, sx_mm, sy_mm, sz_mm))
    };
    robot.targets().iter().filter_map(target).collect()
}

/// Reliability in the form of a document.
pub fn reliability_summary(robot: &dyn Robot, found: &Reliability) -> Option<ReliabilitySummary> {
    let readings: Vec<_> = found.readings.iter().flatten().flatten().collect();
    let least = readings.iter().map(|r| r.redundancy).reduce(f64::min)?;
    let detectable = || readings.iter().map(|r| r.detectable_mm);
    let entry = |p: &PoseInfluence| InfluenceEntry {
        pose: p.pose,
        cooks_distance: Some(p.cooks_distance).filter(|d| d.is_finite()),
        parameter: robot.parameters()[p.parameter].name.clone(),
        change_over_u: p.change_over_u,
    };
    Some(ReliabilitySummary {
        significance: ALPHA_0,
        power: BETA_0,
        sigma_mm: found.sigma_mm,
        readings: readings.len(),
        least_redundancy: least,
        median_detectable_mm: median(detectable()).filter(|d| d.is_finite()),
        largest_detectable_mm: detectable().reduce(f64::max).filter(|d| d.is_finite()),
        critical_w: CRITICAL_W,
        beyond: readings.iter().filter(|r| r.w > CRITICAL_W).count(),
        influential: found.influential,
        poses: found.poses.iter().take(NAMED).map(entry).collect(),
    })
}

/// Robust fit in the form of a document.
pub fn robust_summary(robot: &dyn Robot, found: &RobustComparison) -> RobustSummary {
    let parameter = |c: &RobustChange| {
        let p = &robot.parameters()[c.parameter];
        RobustParameter {
            name: p.name.clone(),
            unit: p.quantity.unit().to_owned(),
            value: p.quantity.outward(found.values[c.parameter]),
            difference: p.quantity.outward(c.difference),
            difference_over_u: c.over_u(),
        }
    };
    let pose =
        |p: &PoseWeight| RobustPose { pose: p.pose, weight: p.weight, residual_over_sigma: p.residual_over_sigma };
    RobustSummary {
        constant: RobustComparison::CONSTANT,
        sigma_mm: found.sigma_mm,
        parameters: found.changes.iter().map(parameter).collect(),
        critical: found.critical,
        poses: found.poses.iter().take(NAMED).map(pose).collect(),
        critical_residual: found.critical_residual,
        disagreeing: found.disagreeing().len(),
    }
}

/// Returns a warning if a robust fit differs from the plain one by more than chance.
pub fn robust_message(robot: &dyn Robot, found: &RobustComparison) -> Option<Message> {
    let change = found.significant()?;
    let name = &robot.parameters()[change.parameter].name;
    let (over_u, limit) = (change.over_u(), found.critical);
    let poses: Vec<_> = found.disagreeing().iter().map(|p| p.pose).collect();
    Some(match poses.is_empty() {
        true => warning!("robust-fit-disagrees", parameter = name, over_u, limit),
        false => {
            warning!("robust-fit-disagrees-at-poses", parameter = name, over_u, limit, poses = truncated(poses, NAMED))
                .to_decide()
                .answered_by(AnsweredBy::NextStep)
                .hint(phrase!("check-readings"))
        }
    })
}

/// Adds the reliability of its readings to each calibration error; the centre of a platform has the
/// worse one of its two.
pub fn with_reliability(robot: &dyn Robot, found: &Reliability, errors: &mut [PointError]) {
    let mut errors = errors.iter_mut().filter(|e| e.set == PoseSet::Calibration);
    for readings in &found.readings {
        if robot.platform().is_none() {
            for reading in readings.iter().flatten() {
                errors.by_ref().take(1).for_each(|e| e.control.reliability = Some((*reading).into()));
            }
            continue;
        }
        let [Some(a), Some(b)] = readings[..] else { continue };
        errors.by_ref().take(1).for_each(|e| {
            e.control.reliability = Some(ReadingReliability {
                redundancy: a.redundancy.min(b.redundancy),
                w: a.w.max(b.w),
                detectable_mm: a.detectable_mm.max(b.detectable_mm),
            });
        });
    }
}

/// A pose: its mean error, and the quantities on which it may depend.
#[derive(Default)]
struct Mean {
    error_mm: Vector,
    against: Vec<f64>,
    count: f64,
}

/// Dependence of the mean calibration errors after identification on each joint, on the distance
/// from `base_mm` and on the order of the measurement. F tests compare a parabola with a constant,
/// all coordinates together; p values are corrected for the number of tests.
pub fn trends(errors: &[PointError], joints: &[String], base_mm: Vector) -> Vec<ResidualTrend> {
    let mut poses: BTreeMap<PoseName, Mean> = BTreeMap::new();
    for (order, e) in errors.iter().filter(|e| e.set == PoseSet::Calibration).enumerate() {
        let pose = poses.entry(e.pose).or_default();
        let reach = norm(minus(e.at_mm, base_mm));
        let against = e.joints.iter().copied().chain([reach, order as f64]);
        pose.against.resize(e.joints.len() + 2, 0.0);
        pose.against.iter_mut().zip(against).for_each(|(sum, v)| *sum += v);
        pose.error_mm.iter_mut().zip(e.after_mm).for_each(|(sum, v)| *sum += v);
        pose.count += 1.0;
    }
    let names = joints.iter().map(String::as_str).chain(["reach_mm", "order"]);
    let tested = names.enumerate().filter_map(|(k, name)| Some((name, trend(&poses, k)?)));
    let (names, found): (Vec<&str>, Vec<Trend>) = tested.unzip();
    let corrected = holm(&found.iter().map(|t| t.p_value).collect::<Vec<_>>());
    let entry = |((name, t), p_value): ((&str, Trend), f64)| ResidualTrend {
        against: name.to_owned(),
        explained_mm: t.explained_mm,
        f: t.f,
        p_value,
    };
    names.into_iter().zip(found).zip(corrected).map(entry).collect()
}

struct Trend {
    explained_mm: f64,
    f: f64,
    p_value: f64,
}

/// Test against the quantity `k`; `None` if poses are too few or do not differ in it.
fn trend(poses: &BTreeMap<PoseName, Mean>, k: usize) -> Option<Trend> {
    let count = poses.len();
    if count < FEWEST {
        return None;
    }
    let of = |f: &dyn Fn(&Mean) -> f64| DVector::from_iterator(count, poses.values().map(|p| f(p) / p.count));
    let z = of(&|p| *p.against.get(k).unwrap_or(&f64::NAN));
    let (mean, largest) = (z.mean(), z.amax().max(1e-300));
    let constant = DVector::repeat(count, 1.0 / (count as f64).sqrt());
    // orthonormal polynomials of the quantity: those that these poses determine
    let mut basis = vec![constant];
    for power in 1..=2 {
        let column = z.map(|v| ((v - mean) / largest).powi(power));
        let rest = basis.iter().fold(column.clone(), |rest, u| &rest - u * u.dot(&rest));
        if rest.norm() > 1e-6 * column.norm() && rest.norm() > 1e-12 {
            basis.push(rest.normalize());
        }
    }
    let columns = basis.len() - 1;
    let (mut explained, mut left, mut dimension) = (0.0, 0.0, 0);
    for axis in 0..3 {
        let r = of(&|p| p.error_mm[axis]);
        let part: Vec<f64> = basis.iter().map(|u| u.dot(&r).powi(2)).collect();
        let squares = r.norm_squared();
        dimension += usize::from(squares > 0.0);
        explained += part[1..].iter().sum::<f64>();
        left += (squares - part.iter().sum::<f64>()).max(0.0);
    }
    let (above, below) = (dimension * columns, dimension * (count - 1 - columns));
    let f = explained / above as f64 / (left / below as f64);
    f.is_finite().then(|| Trend {
        explained_mm: (explained / count as f64).sqrt(),
        f,
        p_value: Variance::Estimated(below as f64).exceedance(above as f64 * f, above),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_base::noise::Noise;

    /// Errors of 40 poses with two repeats, and the contribution of a wave of joint 2 (mm).
    fn errors(trial: u64, wave_mm: f64) -> Vec<PointError> {
        let mut noise = Noise::new(20, trial);
        let mut pose = |i: i64| {
            let joints = vec![noise.uniform(90.0), noise.uniform(90.0)];
            let bent = wave_mm * (joints[1].to_radians()).cos();
            [1, 2].map(|cycle| PointError {
                quantity: Default::default(),
                set: PoseSet::Calibration,
                pose: i.into(),
                cycle,
                target: "T".to_owned(),
                at_mm: [joints[0], 200.0, 0.3 * i as f64],
                before_mm: [0.0; 3],
                after_mm: [noise.gaussian(0.01) + bent, noise.gaussian(0.01), noise.gaussian(0.01)],
                before_deg: None,
                after_deg: None,
                joints: joints.clone(),
                control: Default::default(),
            })
        };
        (0..40).flat_map(&mut pose).collect()
    }

    #[test]
    fn trends_are_found_where_they_are_and_nowhere_else() {
        let names = ["q1_deg", "q2_deg"].map(str::to_owned);
        let found = |trial, wave_mm| -> Vec<String> {
            let all = trends(&errors(trial, wave_mm), &names, [0.0; 3]);
            assert_eq!(all.len(), 4);
            all.into_iter().filter(|t| t.p_value < 0.05).map(|t| t.against).collect()
        };
        let alarms = (0..400).filter(|&trial| !found(trial, 0.0).is_empty()).count();
        // 5 %, with a standard deviation of 1.1 %
        assert!((6..=34).contains(&alarms), "{alarms} of 400");
        let right = (0..50).filter(|&trial| found(trial, 0.03) == ["q2_deg"]).count();
        assert!(right >= 44, "{right} of 50");
    }
}
