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

/// Assessment of a characteristic of a pose.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Assessed {
    /// Bootstrap interval, including the instrument's uncertainty if given; absent with fewer than
    /// three visits.
    pub interval: Option<Interval>,
    /// Interval in closed form, from the sampling alone.
    pub interval_analytic: Option<Interval>,
    /// Conformity with the limit, if any.
    pub conformity: Option<Conformity>,
    /// Ratio of the instrument's uncertainty to the characteristic, if given.
    pub uncertainty: Option<UncertaintyRatio>,
}

/// AP and RP of all poses in a test of one robot.
pub fn characteristics(test: &PoseTest, settings: &PoseTestSettings) -> Result<Vec<PoseCharacteristics>> {
    let mut bootstraps = BTreeMap::new();
    test.poses.iter().map(|p| pose_characteristics(test, p, settings, &mut bootstraps)).collect()
}

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

    /// `true` if the instrument is sufficient for AP and RP; `None` if its uncertainty is not
    /// given.
    pub fn is_verified(&self) -> Option<bool> {
        let judged = || self.ap.uncertainty.iter().chain(&self.rp.uncertainty);
        judged().next().map(|_| judged().all(|q| q.met))
    }
}

impl Assessed {
    /// Judges conformity with the limit, and the instrument's uncertainty relative to the
    /// characteristic.
    fn judge(&mut self, value_mm: Option<f64>, limit_mm: Option<f64>, rule: DecisionRule, uncertainty_mm: Option<f64>) {
        // too few visits leave the decision open
        let judge = |limit| value_mm.map_or(Conformity::Neither, |mm| rule.judge(mm, self.interval, limit));
        self.conformity = limit_mm.map(judge);
        self.uncertainty = uncertainty_mm.zip(value_mm).map(|(u, mm)| uncertainty_ratio(u, mm));
    }
}
