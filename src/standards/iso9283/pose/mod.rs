//! Tests of poses (ISO 9283:1998 7): from attained poses to their characteristics.

pub mod approach;
mod characteristics;
pub mod coplanarity;
pub mod ellipsoid;
pub mod noise_free;
pub mod orientation;
pub mod outlying;
pub mod reference;
pub mod rotations;
pub mod test;

pub use characteristics::{accuracy, directions, distance, drift, exchangeability, repeatability};

use self::accuracy::{PoseAccuracy, angle_accuracy_rad, pose_accuracy};
use self::drift::pose_drift;
use self::ellipsoid::{Ellipsoid, ellipsoid};
use self::noise_free::NoiseFree;
use self::orientation::{Inseparable, RotationCharacteristics};
use self::repeatability::{PoseRepeatability, angle_repeatability_rad, pose_repeatability};
use self::test::{PoseTest, TestedPose};
use crate::decision::{Conformity, DecisionRule};
use crate::iso9283::statistics::bootstrap::Bootstrap;
use crate::iso9283::statistics::interval::{Interval, accuracy_interval, repeatability_interval};
use crate::iso9283::statistics::uncertainty_ratio::{UncertaintyRatio, uncertainty_ratio};
use etalon_base::message::Result;
use etalon_base::pose::Vector;
use etalon_base::pose_name::PoseName;
use std::collections::btree_map::{BTreeMap, Entry};

/// Settings that the data do not contain.
#[derive(Clone, Debug)]
pub struct PoseTestSettings {
    /// Expanded uncertainty of a measured coordinate (k = 2).
    pub expanded_uncertainty_mm: Option<f64>,
    /// Expanded uncertainty of a measured position (k = 2), if it does not follow from the
    /// coordinates.
    pub position_uncertainty_mm: Option<f64>,
    /// Number of cycles per set of a drift test; `None` without a drift test.
    pub drift_set: Option<usize>,
    /// Order of the rotations a, b, c, in words.
    pub rotation_order: Option<String>,
    /// Seed of the bootstrap.
    pub seed: u64,
    /// Number of simulated tests for an interval, usually [`DRAWS`]; 0 for no intervals.
    pub draws: usize,
    /// Limit of AP, for conformity.
    pub ap_limit_mm: Option<f64>,
    /// Limit of RP, for conformity.
    pub rp_limit_mm: Option<f64>,
    /// Decision rule for these limits.
    pub decision_rule: DecisionRule,
}

/// Number of cycles that the standard requires (read).
pub const CYCLES: usize = 30;
/// Number of simulated tests for an interval.
pub const DRAWS: usize = 2000;

/// AP and RP of one pose, with intervals and verdicts. Values that the visits do not determine are
/// absent.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PoseCharacteristics {
    /// Name of the pose.
    pub pose: PoseName,
    /// Number of evaluated visits.
    pub cycles: usize,
    /// AP; absent without a commanded position.
    pub accuracy: Option<PoseAccuracy>,
    /// RP; absent with a single visit.
    pub repeatability: Option<PoseRepeatability>,
    /// AP and RP of each angle.
    pub angles: AngleCharacteristics,
    /// Angles that are not separable; AP and RP of all angles are then absent.
    pub inseparable: Option<Inseparable>,
    /// Orientation by rotation vectors, where angles are not separable and their order is given.
    pub rotation: Option<RotationCharacteristics>,
    /// Assessment of AP.
    pub ap: Assessed,
    /// Assessment of RP.
    pub rp: Assessed,
    /// Region of the next position; absent with too few visits.
    pub ellipsoid: Option<Ellipsoid>,
    /// RP without the instrument's noise; absent if no visit was read twice.
    pub noise_free: Option<NoiseFree>,
    /// `true` if z was measured.
    pub spatial: bool,
}

/// AP and RP of the angles; absent angles were not measured, or are not separable.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AngleCharacteristics {
    /// AP_a, AP_b, AP_c.
    pub accuracy_rad: [Option<f64>; 3],
    /// RP_a, RP_b, RP_c.
    pub repeatability_rad: [Option<f64>; 3],
}

/// Approach of a pose whose visits come from several approaches, with a characteristic of its
/// visits.
#[derive(Clone, Debug, PartialEq)]
pub struct JudgedApproach {
    /// Value of the column `approach`, or the previous pose of the path.
    pub name: String,
    /// Number of visits.
    pub cycles: usize,
    /// AP or RP of these visits.
    pub value_mm: f64,
    /// Region of the next visit by this approach; absent with too few visits.
    pub ellipsoid: Option<Ellipsoid>,
    /// RP of these visits without the instrument's noise; absent if no visit was read twice.
    pub rp_without_noise_mm: Option<f64>,
}

impl JudgedApproach {
    fn new(name: &str, found: &PoseCharacteristics, value_mm: f64) -> Self {
        Self {
            name: name.to_owned(),
            cycles: found.cycles,
            value_mm,
            ellipsoid: found.ellipsoid,
            rp_without_noise_mm: found.noise_free.map(|n| n.rp_mm),
        }
    }
}

/// Assessment of a characteristic of a pose. If visits come from several approaches, it applies to
/// one approach, for which ISO 9283 defines AP and RP (7.2.1, 7.2.2).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Assessed {
    /// Approach with the worst decision and, among these, the largest value; absent if all visits
    /// count.
    pub approach: Option<JudgedApproach>,
    /// Bootstrap interval, including the instrument's uncertainty if given; absent with fewer than
    /// three visits. If AP drifts significantly, the interval contains AP of every set of cycles.
    pub interval: Option<Interval>,
    /// `true` if the interval contains AP of every set of cycles: it is then no coverage interval.
    pub contains_sets: bool,
    /// Interval in closed form, from the sampling alone.
    pub interval_analytic: Option<Interval>,
    /// Conformity with the limit, if any.
    pub conformity: Option<Conformity>,
    /// Ratio of the instrument's uncertainty to the characteristic, if given; the largest ratio of
    /// all approaches.
    pub uncertainty: Option<UncertaintyRatio>,
    /// Approach with this largest ratio; absent if all visits count.
    pub smallest: Option<JudgedApproach>,
}

/// AP and RP of all poses in a test of one robot.
pub fn characteristics(test: &PoseTest, settings: &PoseTestSettings) -> Result<Vec<PoseCharacteristics>> {
    let mut bootstraps = BTreeMap::new();
    let mut found = |p: &TestedPose| pose_characteristics(test, p, settings, &mut bootstraps);
    let judged = |p: &TestedPose| -> Result<PoseCharacteristics> {
        let by_approach = |name: &str| -> Result<(String, PoseCharacteristics)> {
            Ok((name.to_owned(), found(&p.approached(name))?))
        };
        let approaches: Vec<_> = p.repeated_approaches().into_iter().map(by_approach).collect::<Result<_>>()?;
        let mut pose = found(p)?;
        pose.judge_approaches(&approaches);
        Ok(pose)
    };
    test.poses.iter().map(judged).collect()
}

/// Characteristics of all visits together.
fn pose_characteristics(
    test: &PoseTest,
    p: &TestedPose,
    settings: &PoseTestSettings,
    bootstraps: &mut BTreeMap<usize, Bootstrap>,
) -> Result<PoseCharacteristics> {
    let positions = p.positions_mm(|_| true);
    let n = positions.len();
    let mut pose = PoseCharacteristics {
        pose: p.pose,
        cycles: n,
        ellipsoid: ellipsoid(&positions).ok(),
        noise_free: noise_free::repeatability_without_noise(p)?,
        spatial: test.spatial,
        ..PoseCharacteristics::default()
    };
    pose.accuracy = p.commanded_mm.map(|commanded| pose_accuracy(&positions, commanded)).transpose()?;
    pose.inseparable = test.inseparable(p);
    match pose.inseparable {
        Some(_) => pose.rotation = test.rotation(p),
        None => pose.evaluate_angles(test, p),
    }
    pose.repeatability = (n >= 2).then(|| pose_repeatability(&positions)).transpose()?;
    if n >= 3 && settings.draws > 0 {
        let bootstrap = match bootstraps.entry(n) {
            Entry::Occupied(shared) => shared.into_mut(),
            Entry::Vacant(place) => place.insert(Bootstrap::new(n, settings.draws, settings.seed)?),
        };
        pose.intervals(&positions, bootstrap)?;
    }
    let drift = settings.drift_set.and_then(|size| pose_drift(p, size)?.ok()).filter(|d| d.is_significant);
    if let Some(drift) = drift {
        pose.ap.interval = pose.ap.interval.map(|interval| interval.containing(&drift.ap_mm));
        pose.ap.contains_sets = pose.ap.interval.is_some();
    }
    if let Some(expanded_mm) = settings.expanded_uncertainty_mm {
        let ap = pose.ap.interval.zip(pose.accuracy);
        pose.ap.interval = ap.map(|(interval, found)| interval.with_instrument(found.ap_mm, expanded_mm));
        pose.rp.interval = pose.rp.interval.map(|interval| interval.without_noise(expanded_mm, test.spatial));
    }
    let of_coordinates = |u: f64| u * if test.spatial { 3f64 } else { 2.0 }.sqrt();
    let uncertainty_mm =
        settings.position_uncertainty_mm.or_else(|| settings.expanded_uncertainty_mm.map(of_coordinates));
    let (ap_mm, rp_mm) = (pose.accuracy.map(|a| a.ap_mm), pose.repeatability.map(|r| r.rp_mm));
    pose.ap.judge(ap_mm, settings.ap_limit_mm, settings.decision_rule, uncertainty_mm);
    pose.rp.judge(rp_mm, settings.rp_limit_mm, settings.decision_rule, uncertainty_mm);
    Ok(pose)
}

impl PoseCharacteristics {
    /// Evaluates AP and RP of each angle.
    fn evaluate_angles(&mut self, test: &PoseTest, p: &TestedPose) {
        for (k, &axis) in test.angles.iter().enumerate() {
            let attained = p.angles_rad(k, |_| true);
            let commanded = p.commanded_rad.get(k);
            self.angles.accuracy_rad[axis] = commanded.map(|commanded| angle_accuracy_rad(&attained, *commanded));
            self.angles.repeatability_rad[axis] = Some(angle_repeatability_rad(&attained)).filter(|rp| rp.is_finite());
        }
    }

    fn intervals(&mut self, positions: &[Vector], bootstrap: &Bootstrap) -> Result<()> {
        if let Some(found) = &self.accuracy {
            self.ap.interval = Some(bootstrap.accuracy(positions, found)?);
            self.ap.interval_analytic = Some(accuracy_interval(positions, found)?);
        }
        if let Some(found) = &self.repeatability {
            self.rp.interval = Some(bootstrap.repeatability(positions, found)?);
            self.rp.interval_analytic = Some(repeatability_interval(positions, found)?);
        }
        Ok(())
    }

    /// Replaces the assessments of all visits by the assessments of single approaches.
    fn judge_approaches(&mut self, approaches: &[(String, Self)]) {
        if approaches.is_empty() {
            return;
        }
        let worst = |assessed: fn(&Self) -> &Assessed, value: fn(&Self) -> Option<f64>| {
            Assessed::worst_approach(approaches.iter().filter_map(|(name, found)| {
                let judged = JudgedApproach::new(name, found, value(found)?);
                Some(Assessed { approach: Some(judged), ..assessed(found).clone() })
            }))
        };
        self.ap = worst(|found| &found.ap, |found| found.accuracy.map(|a| a.ap_mm));
        self.rp = worst(|found| &found.rp, |found| found.repeatability.map(|r| r.rp_mm));
    }

    /// `true` if the instrument is sufficient for AP and RP; `None` if its uncertainty is not
    /// given.
    pub fn is_verified(&self) -> Option<bool> {
        let judged = || self.ap.uncertainty.iter().chain(&self.rp.uncertainty);
        judged().next().map(|_| judged().all(|q| q.met))
    }
}

impl Assessed {
    /// Assessment of the approach with the worst decision and, among these, the largest value.
    fn worst_approach(all: impl Iterator<Item = Self>) -> Self {
        let all: Vec<Self> = all.collect();
        let ratios = all.iter().filter_map(|found| Some((found.uncertainty?, found.approach.clone())));
        let (uncertainty, smallest) = ratios.max_by(|a, b| a.0.ratio.total_cmp(&b.0.ratio)).unzip();
        let smallest = smallest.flatten();
        let rank = |found: &Self| match found.conformity {
            Some(Conformity::NotConforming) => 2,
            Some(Conformity::Neither | Conformity::NotAssessable) => 1,
            Some(Conformity::Conforming) | None => 0,
        };
        let value_mm = |found: &Self| found.approach.as_ref().map_or(0.0, |approach| approach.value_mm);
        let worse = |a: &Self, b: &Self| rank(a).cmp(&rank(b)).then(value_mm(a).total_cmp(&value_mm(b)));
        let worst = all.into_iter().max_by(worse).unwrap_or_default();
        Self { uncertainty, smallest, ..worst }
    }

    /// Judges conformity with the limit, and the instrument's uncertainty relative to the
    /// characteristic.
    fn judge(&mut self, value_mm: Option<f64>, limit_mm: Option<f64>, rule: DecisionRule, uncertainty_mm: Option<f64>) {
        // too few visits leave the decision open
        let judge = |limit| value_mm.map_or(Conformity::Neither, |mm| rule.judge(mm, self.interval, limit));
        self.conformity = limit_mm.map(judge);
        self.uncertainty = uncertainty_mm.zip(value_mm).map(|(u, mm)| uncertainty_ratio(u, mm));
    }
}

#[cfg(test)]
mod tests {
    use super::test::AttainedPose;
    use super::*;
    use etalon_base::noise::Noise;

    const SETTINGS: PoseTestSettings = PoseTestSettings {
        expanded_uncertainty_mm: None,
        position_uncertainty_mm: None,
        drift_set: None,
        rotation_order: None,
        seed: 1,
        draws: 200,
        ap_limit_mm: None,
        rp_limit_mm: None,
        decision_rule: DecisionRule::Guarded,
    };

    /// Thirty cycles of one pose with a scatter of 10 µm, one visit from each approach; the pose
    /// moves along y. Each approach has its own x.
    fn visited(approaches_mm: &[(&str, f64)], moves_mm: f64) -> PoseTest {
        let mut noise = Noise::new(9283, 4);
        let mut attained = Vec::new();
        for cycle in 1..=30 {
            for (name, x_mm) in approaches_mm {
                let moved_mm = moves_mm * (cycle - 1) as f64 / 29.0;
                let position_mm =
                    [x_mm + noise.gaussian(0.01), 0.3 + moved_mm + noise.gaussian(0.01), noise.gaussian(0.01)];
                attained.push(AttainedPose {
                    cycle,
                    position_mm,
                    angles_rad: Vec::new(),
                    approach: Some((*name).to_owned()),
                    robot: String::new(),
                    readings_mm: vec![position_mm],
                    readings_rad: Vec::new(),
                });
            }
        }
        let pose = TestedPose { pose: 1.into(), commanded_mm: Some([0.0; 3]), commanded_rad: Vec::new(), attained };
        PoseTest { poses: vec![pose], spatial: true, angles: Vec::new(), rotation_order: None, warnings: Vec::new() }
    }

    /// Two approaches 0.2 mm apart: all visits scatter by 0.1 mm, and the visits of one approach
    /// have RP = 3.615 × 10 µm.
    #[test]
    fn each_approach_is_judged_by_itself() {
        let test = visited(&[("east", 0.1), ("west", -0.1)], 0.0);
        let settings = PoseTestSettings { rp_limit_mm: Some(0.06), position_uncertainty_mm: Some(0.006), ..SETTINGS };
        let pose = characteristics(&test, &settings).unwrap().remove(0);
        let all_mm = pose.repeatability.unwrap().rp_mm;
        let judged = pose.rp.approach.clone().unwrap();
        assert!(all_mm > 0.1 && (0.025..0.047).contains(&judged.value_mm), "{all_mm} {judged:?}");
        assert_eq!((judged.cycles, pose.cycles, pose.rp.conformity), (30, 60, Some(Conformity::Conforming)));
        let interval = pose.rp.interval.unwrap();
        assert!(interval.low_mm < judged.value_mm && interval.high_mm < 0.06, "{interval:?}");
        // of one approach, without the distance between the two: the semi-axis of 30 visits with a
        // scatter of 10 µm is 31 µm (Hotelling's T² of three coordinates), of all visits 0.30 mm
        let of_approach_mm = judged.ellipsoid.unwrap().semi_axes_mm[0];
        assert!((0.025..0.05).contains(&of_approach_mm), "{of_approach_mm}");
        assert!(pose.ellipsoid.unwrap().semi_axes_mm[0] > 0.2);
        // the 25 % rule applies to the smallest RP
        let single =
            ["east", "west"].map(|name| pose_repeatability(&test.poses[0].approached(name).positions_mm(|_| true)));
        let smallest = single.map(|rp| rp.unwrap().rp_mm).into_iter().fold(f64::INFINITY, f64::min);
        assert!((pose.rp.uncertainty.unwrap().ratio - 0.006 / smallest).abs() < 1e-12);
        let finest = pose.rp.smallest.clone().unwrap();
        assert!(finest.value_mm == smallest && finest.name != judged.name, "{finest:?}");
        // an approach with the worst decision is judged
        let beyond = PoseTestSettings { rp_limit_mm: Some(0.02), ..SETTINGS };
        let pose = characteristics(&test, &beyond).unwrap().remove(0);
        assert_eq!(pose.rp.conformity, Some(Conformity::NotConforming));
        let one = characteristics(&visited(&[("east", 0.1)], 0.0), &SETTINGS).unwrap().remove(0);
        assert!(one.rp.approach.is_none() && one.ap.approach.is_none());
    }

    #[test]
    fn the_interval_of_a_drifting_pose_contains_its_sets() {
        let settings = PoseTestSettings { drift_set: Some(5), ..SETTINGS };
        let assessed = |moves_mm: f64, settings: &PoseTestSettings| {
            characteristics(&visited(&[("east", 0.0)], moves_mm), settings).unwrap().remove(0).ap
        };
        let interval = |moves_mm: f64, settings: &PoseTestSettings| assessed(moves_mm, settings).interval.unwrap();
        // the means of the first and the last set are 0.069 mm apart
        let found = interval(0.08, &settings);
        let sets = pose_drift(&visited(&[("east", 0.0)], 0.08).poses[0], 5).unwrap().unwrap();
        assert!(sets.is_significant && sets.ap_mm.iter().all(|ap| (found.low_mm..=found.high_mm).contains(ap)));
        assert!(interval(0.08, &SETTINGS).low_mm > sets.ap_mm[0]);
        assert_eq!(interval(0.0, &settings), interval(0.0, &SETTINGS));
        assert!(assessed(0.08, &settings).contains_sets && !assessed(0.0, &settings).contains_sets);
    }
}
