//! Tests of poses (ISO 9283:1998 7): from attained poses to their characteristics.

pub mod accuracy;
pub mod coplanarity;
pub mod directions;
pub mod distance;
pub mod drift;
pub mod ellipsoid;
pub mod exchangeability;
pub mod noise_free;
pub mod reference;
pub mod repeatability;
pub mod rotations;
pub mod test;

use self::accuracy::{PoseAccuracy, angle_accuracy_rad, pose_accuracy};
use self::ellipsoid::{Ellipsoid, ellipsoid};
use self::noise_free::NoiseFree;
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

/// What the data do not say.
#[derive(Clone, Debug)]
pub struct PoseTestSettings {
    /// Expanded uncertainty of a measured coordinate (k = 2).
    pub expanded_uncertainty_mm: Option<f64>,
    /// Expanded uncertainty of a measured position (k = 2) where it is not that of its coordinates together.
    pub position_uncertainty_mm: Option<f64>,
    /// Cycles of one set of a drift test; without it there is none.
    pub drift_set: Option<usize>,
    /// Order of the rotations a, b, c, in words.
    pub rotation_order: Option<String>,
    /// Seed of the bootstrap.
    pub seed: u64,
    /// Simulated tests behind an interval, [`DRAWS`]; without any there are no intervals.
    pub draws: usize,
    /// Limit of AP, for conformity.
    pub ap_limit_mm: Option<f64>,
    /// Limit of RP likewise.
    pub rp_limit_mm: Option<f64>,
    /// How these limits are judged.
    pub decision_rule: DecisionRule,
}

/// Cycles that the standard asks for (read).
pub const CYCLES: usize = 30;
/// Simulated tests behind an interval.
pub const DRAWS: usize = 2000;

/// AP and RP of one pose with their intervals and verdicts; what its visits do not determine is
/// absent.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PoseCharacteristics {
    /// Name of the pose.
    pub pose: PoseName,
    /// Visits counted.
    pub cycles: usize,
    /// AP; absent without a commanded position.
    pub accuracy: Option<PoseAccuracy>,
    /// AP_a, AP_b, AP_c.
    pub angle_accuracy_rad: [Option<f64>; 3],
    /// RP; absent with a single visit.
    pub repeatability: Option<PoseRepeatability>,
    /// RP_a, RP_b, RP_c.
    pub angle_repeatability_rad: [Option<f64>; 3],
    /// What is known of AP beside its value.
    pub ap: Assessed,
    /// What is known of RP.
    pub rp: Assessed,
    /// Where the next position lies; absent with too few visits.
    pub ellipsoid: Option<Ellipsoid>,
    /// RP without the instrument's noise; absent where no visit was read twice.
    pub noise_free: Option<NoiseFree>,
    /// `true` if there is a z.
    pub spatial: bool,
}

/// A characteristic of a pose beside its value.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Assessed {
    /// Interval by bootstrap, with the instrument's uncertainty where that is stated; absent with
    /// fewer than three visits.
    pub interval: Option<Interval>,
    /// Interval in closed form, of the sampling alone.
    pub interval_analytic: Option<Interval>,
    /// Conformity with the limit, where there is one.
    pub conformity: Option<Conformity>,
    /// The instrument's uncertainty against the characteristic, where it is stated.
    pub uncertainty: Option<UncertaintyRatio>,
}

/// AP and RP of every pose of a test of one robot.
pub fn characteristics(test: &PoseTest, settings: &PoseTestSettings) -> Result<Vec<PoseCharacteristics>> {
    let mut bootstraps = BTreeMap::new();
    test.poses.iter().map(|p| of_pose(test, p, settings, &mut bootstraps)).collect()
}

fn of_pose(
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
        noise_free: noise_free::of_pose(p)?,
        spatial: test.spatial,
        ..PoseCharacteristics::default()
    };
    pose.accuracy = p.commanded_mm.map(|commanded| pose_accuracy(&positions, commanded)).transpose()?;
    for (k, &axis) in test.angles.iter().enumerate() {
        let attained = p.angles_rad(k, |_| true);
        let commanded = p.commanded_rad.get(k);
        pose.angle_accuracy_rad[axis] = commanded.map(|commanded| angle_accuracy_rad(&attained, *commanded));
        pose.angle_repeatability_rad[axis] = Some(angle_repeatability_rad(&attained)).filter(|rp| rp.is_finite());
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

    /// `true` if the instrument is good enough for all that it verifies here; `None` where its
    /// uncertainty is not stated.
    pub fn is_verified(&self) -> Option<bool> {
        let judged = || self.ap.uncertainty.iter().chain(&self.rp.uncertainty);
        judged().next().map(|_| judged().all(|q| q.met))
    }
}

impl Assessed {
    /// Conformity with the limit, and the instrument against the characteristic.
    fn judge(&mut self, value_mm: Option<f64>, limit_mm: Option<f64>, rule: DecisionRule, uncertainty_mm: Option<f64>) {
        // too few visits prove nothing
        let judge = |limit| value_mm.map_or(Conformity::Neither, |mm| rule.judge(mm, self.interval, limit));
        self.conformity = limit_mm.map(judge);
        self.uncertainty = uncertainty_mm.zip(value_mm).map(|(u, mm)| uncertainty_ratio(u, mm));
    }
}
