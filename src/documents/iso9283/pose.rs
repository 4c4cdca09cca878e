//! Tests of poses (ISO 9283:1998 7).

use super::{all, degrees};
use crate::mirror::mirror;
use crate::worded::worded;
use crate::{Conformity, LimitQuantity, LimitVerdict};
use etalon_base::catalogue::Phrase;
use etalon_base::message::{Message, Result, one_line};
use etalon_base::pose::Vector;
use etalon_base::pose_name::PoseName;
use etalon_base::worded::Worded;
use etalon_base::{error, phrase, warning};
use etalon_standards::decision::DecisionRule;
use etalon_standards::iso9283::misplacement::{
    ColumnChange, Misplacement, TestTable, misplaced_angles, misplaced_poses,
};
use etalon_standards::iso9283::pose::coplanarity::flatness;
use etalon_standards::iso9283::pose::directions::{Approach, PoseVariation, variations};
use etalon_standards::iso9283::pose::distance::{PairDistance, distances};
use etalon_standards::iso9283::pose::drift::{Drift, drifts, largest_trend};
use etalon_standards::iso9283::pose::ellipsoid::Ellipsoid;
use etalon_standards::iso9283::pose::exchangeability::exchanged;
use etalon_standards::iso9283::pose::outlying::{
    OutlyingReading, RepeatedReading, outlying_readings, repeated_readings,
};
use etalon_standards::iso9283::pose::test::{PoseTest, from_pose};
use etalon_standards::iso9283::pose::{CYCLES, JudgedApproach, PoseCharacteristics, PoseTestSettings, characteristics};
use etalon_standards::iso9283::statistics::interval::Interval;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};

/// Characteristics of ISO 9283:1998 of one test.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283Document {
    /// Schema and version: `etalon/iso9283/1`.
    pub schema: String,
    /// Meaning of angles, evaluated cycles, and clauses that are not verified against the standard,
    /// in words.
    #[serde(flatten, with = "Iso9283Conventions")]
    pub conventions: Vec<Worded>,
    /// Frame of the positions.
    #[serde(flatten, with = "Iso9283Frame")]
    pub frame: Option<Worded>,
    /// One entry per pose, in the order of the commanded poses.
    pub poses: Vec<Iso9283Pose>,
    /// One entry per pair of poses that were visited in the same cycles.
    pub distances: Vec<Iso9283Distance>,
    /// One entry per pose that was approached in at least two ways.
    pub approaches: Vec<Iso9283Variation>,
    /// Texts of the catalogue that are names of approaches in English; names that a table contains
    /// are absent.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub approach_phrases: BTreeMap<String, Phrase>,
    /// Drift of each pose, if sets are given.
    pub drifts: Vec<Iso9283Drift>,
    /// Characteristics of the whole robot.
    #[serde(flatten)]
    pub robot: Iso9283Robot,
    /// Visits, and measurements of the reference targets.
    #[serde(flatten)]
    pub recorded: Iso9283Recorded,
    /// Limits that the campaign contains.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub limits: Vec<LimitVerdict>,
    /// Remarks and warnings.
    pub messages: Vec<Message>,
}

/// Visits of a test, and measurements of its reference targets.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Iso9283Recorded {
    /// All visits of a campaign; visits of one pose are in the order of recording.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub visits: Vec<Iso9283Visit>,
    /// Measurements of the reference targets for drift compensation, if any.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub reference: Vec<Iso9283Epoch>,
}

/// Characteristics of the whole robot, not of a pose.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Iso9283Robot {
    /// Largest distance between the barycentres of two robots at any pose, with several robots.
    pub exchangeability_mm: Option<f64>,
    /// Peak to valley of the mean positions about their plane, with z and at least four poses.
    pub coplanarity_mm: Option<f64>,
    /// Distances of the mean positions of four poses, each from the plane of the other three, if a
    /// campaign names four poses.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub coplanarity_of_four: Vec<Iso9283OutOfPlane>,
    /// Homings as visits of one pose with number 0, if a campaign has homings.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub homing: Option<Iso9283Pose>,
}

worded! {
    /// Meaning of angles, evaluated cycles, and clauses that are not verified against the standard,
    /// in words.
    list Iso9283Conventions: conventions, convention_phrases
}

worded! {
    /// Frame of the positions, in words; absent in documents of earlier programs.
    option Iso9283Frame: frame, frame_phrase
}

impl Iso9283Document {
    /// Evaluates all characteristics of attained poses. With several robots, they apply to the
    /// first robot by name, except for exchangeability.
    pub fn evaluate(robots: &PoseTest, settings: &PoseTestSettings) -> Result<Self> {
        let count = robots.robots().len();
        if count > 1 && settings.ap_limit_mm.or(settings.rp_limit_mm).is_some() {
            return Err(error!("limits-for-several-robots", robots = count).into());
        }
        let placed = [misplaced_poses(robots), misplaced_angles(robots)].into_iter().flatten();
        let placed: Vec<Message> = placed.map(|found| misplacement(&found)).collect::<Result<_>>()?;
        let test = &robots.first_robot_test();
        let poses: Vec<Iso9283Pose> = all(characteristics(test, settings)?);
        let drifts: Vec<Iso9283Drift> = match settings.drift_set {
            Some(size) => all(drifts(test, size)?),
            None => Vec::new(),
        };
        let mut conventions = conventions(robots, settings);
        let drifting: Vec<PoseName> = drifts.iter().filter(|d| d.is_significant).map(|d| d.pose).collect();
        if !drifting.is_empty() {
            conventions.push(phrase!("convention-interval-of-sets", count = drifting.len(), poses = drifting));
        }
        Ok(Self {
            schema: "etalon/iso9283/1".to_owned(),
            conventions: all(conventions),
            frame: None,
            distances: all(distances(test)?),
            approaches: all(variations(test)?),
            approach_phrases: approach_phrases(test),
            drifts,
            robot: Iso9283Robot {
                exchangeability_mm: exchanged(robots)?,
                coplanarity_mm: flatness(test)?,
                ..Iso9283Robot::default()
            },
            recorded: Iso9283Recorded::default(),
            limits: Vec::new(),
            messages: [placed, messages(test, &poses)]
                .into_iter()
                .flatten()
                .chain(outlying(robots))
                .chain(repeated(robots))
                .chain(unstated_drift(test, settings))
                .chain(without_instrument(settings))
                .collect(),
            poses,
        })
    }

    /// Adds a convention.
    pub fn agree(&mut self, convention: Phrase) {
        self.conventions.push(convention.into());
    }

    /// Keeps the characteristics of single poses only.
    pub fn keep_pose_characteristics(self) -> Self {
        Self {
            distances: Vec::new(),
            approaches: Vec::new(),
            approach_phrases: BTreeMap::new(),
            drifts: Vec::new(),
            robot: Iso9283Robot { exchangeability_mm: None, coplanarity_mm: None, ..self.robot },
            ..self
        }
    }
}

/// One measurement of the reference targets.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283Epoch {
    /// First cycle to which the measurement applies.
    pub cycle: i64,
    /// Largest displacement of a target since the first measurement.
    pub moved_mm: f64,
    /// Root mean square distance of the targets after drift compensation.
    pub rms_mm: f64,
}

/// A pose and its distance from the plane of three other poses (thesis, 2.4).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283OutOfPlane {
    /// Name of the pose.
    pub pose: PoseName,
    /// Distance from the plane.
    pub distance_mm: f64,
}

/// One visit of one pose.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Iso9283Visit {
    /// Name of the pose.
    pub pose: PoseName,
    /// Number of the cycle.
    pub cycle: i64,
    /// Approach to the pose; null if unknown: for the very first visit, or where the reading of the
    /// previous pose is missing.
    pub approach: Option<String>,
    /// Attained position.
    pub attained_mm: Vector,
}

mirror! {
    /// Two-sided 95 % interval.
    #[derive(Copy)]
    struct Iso9283Interval of Interval {
        /// Lower end.
        low_mm: f64,
        /// Upper end.
        high_mm: f64,
    }
}

mirror! {
    /// Accuracy and repeatability of one pose. Coordinates that the robot does not have are absent.
    #[derive(Default)]
    struct Iso9283Pose of PoseCharacteristics as p {
        /// Name of the pose.
        pose: PoseName,
        /// Number of evaluated visits.
        cycles: usize,
        /// AP_p (7.2.1); this and its coordinates are null if no position was commanded.
        ap_mm: Option<f64> = p.accuracy.map(|a| a.ap_mm),
        /// AP_x: mean minus commanded position.
        ap_x_mm: Option<f64> = p.accuracy.map(|a| a.deviation_mm[0]),
        /// AP_y.
        ap_y_mm: Option<f64> = p.accuracy.map(|a| a.deviation_mm[1]),
        /// AP_z.
        #[serde(skip_serializing_if = "Option::is_none")]
        ap_z_mm: Option<f64> = p.accuracy.filter(|_| p.spatial).map(|a| a.deviation_mm[2]),
        /// RP_l (7.2.2): mean radius plus three standard deviations; this and all further values
        /// are null with a single visit.
        rp_mm: Option<f64> = p.repeatability.map(|r| r.rp_mm),
        /// RP of the projections onto the xy plane (thesis, table 2.1).
        rp_xy_mm: Option<f64> = p.repeatability.map(|r| r.plane_mm),
        /// RP along x alone.
        rp_along_x_mm: Option<f64> = p.repeatability.map(|r| r.along_mm[0]),
        /// RP along y alone.
        rp_along_y_mm: Option<f64> = p.repeatability.map(|r| r.along_mm[1]),
        /// RP along z alone.
        #[serde(skip_serializing_if = "Option::is_none")]
        rp_along_z_mm: Option<f64> = p.repeatability.filter(|_| p.spatial).map(|r| r.along_mm[2]),
        /// Mean distance from the barycentre.
        mean_radius_mm: Option<f64> = p.repeatability.map(|r| r.mean_radius_mm),
        /// Standard deviation of the distance from the barycentre.
        sd_radius_mm: Option<f64> = p.repeatability.map(|r| r.sd_radius_mm),
        /// Radius of the smallest sphere (planar robots: circle) that encloses all positions.
        enclosing_radius_mm: Option<f64> = p.repeatability.map(|r| r.enclosing_radius_mm),
        /// Radius of the smallest circle that encloses the projections onto the xy plane.
        enclosing_circle_radius_mm: Option<f64> = p.repeatability.map(|r| r.enclosing_circle_radius_mm),
        /// RP_x: three standard deviations.
        rp_x_mm: Option<f64> = p.repeatability.map(|r| r.axis_mm[0]),
        /// RP_y.
        rp_y_mm: Option<f64> = p.repeatability.map(|r| r.axis_mm[1]),
        /// RP_z.
        #[serde(skip_serializing_if = "Option::is_none")]
        rp_z_mm: Option<f64> = p.repeatability.filter(|_| p.spatial).map(|r| r.axis_mm[2]),
        /// AP_a.
        #[serde(skip_serializing_if = "Option::is_none")]
        ap_a_deg: Option<f64> = p.angles.accuracy_rad[0].map(f64::to_degrees),
        /// AP_b.
        #[serde(skip_serializing_if = "Option::is_none")]
        ap_b_deg: Option<f64> = p.angles.accuracy_rad[1].map(f64::to_degrees),
        /// AP_c.
        #[serde(skip_serializing_if = "Option::is_none")]
        ap_c_deg: Option<f64> = p.angles.accuracy_rad[2].map(f64::to_degrees),
        /// RP_a: three standard deviations.
        #[serde(skip_serializing_if = "Option::is_none")]
        rp_a_deg: Option<f64> = p.angles.repeatability_rad[0].map(f64::to_degrees),
        /// RP_b.
        #[serde(skip_serializing_if = "Option::is_none")]
        rp_b_deg: Option<f64> = p.angles.repeatability_rad[1].map(f64::to_degrees),
        /// RP_c.
        #[serde(skip_serializing_if = "Option::is_none")]
        rp_c_deg: Option<f64> = p.angles.repeatability_rad[2].map(f64::to_degrees),
        /// Rotation from the commanded to the mean orientation about x, y and z of the table, as a
        /// rotation vector. It replaces AP_a, AP_b and AP_c if two rotations have nearly the same
        /// axis and their order is given.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        ap_rotation_deg: Option<Vector> =
            p.rotation.and_then(|r| r.deviation_rad).map(|v| v.map(f64::to_degrees)),
        /// Three standard deviations of the rotations from the mean orientation about x, y and z of
        /// the table, instead of RP_a, RP_b and RP_c.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        rp_rotation_deg: Option<Vector> =
            p.rotation.and_then(|r| r.repeatability_rad).map(|v| v.map(f64::to_degrees)),
        /// Approach to which interval and verdict of AP apply, if visits come from several: ISO
        /// 9283 defines AP for one approach.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        ap_approach: Option<Iso9283JudgedApproach> = p.ap.approach.clone().map(Into::into),
        /// Approach to which interval and verdict of RP apply, if visits come from several: ISO
        /// 9283 defines RP for one approach.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        rp_approach: Option<Iso9283JudgedApproach> = p.rp.approach.clone().map(Into::into),
        /// 95 % interval of AP by parametric bootstrap, including the instrument's uncertainty if
        /// given; null with fewer than three visits. If AP drifts significantly, the interval
        /// contains AP of every set of cycles.
        ap_interval: Option<Iso9283Interval> = p.ap.interval.map(Into::into),
        /// `true` if the interval of AP contains AP of every set of cycles: it is then no coverage
        /// interval.
        #[serde(default)]
        ap_interval_contains_sets: bool = p.ap.contains_sets,
        /// 95 % interval of RP by parametric bootstrap, including the instrument's uncertainty if
        /// given; null with fewer than three visits.
        rp_interval: Option<Iso9283Interval> = p.rp.interval.map(Into::into),
        /// 95 % interval of AP in closed form, from the sampling alone.
        ap_interval_analytic: Option<Iso9283Interval> = p.ap.interval_analytic.map(Into::into),
        /// 95 % interval of RP in closed form, from the sampling alone.
        rp_interval_analytic: Option<Iso9283Interval> = p.rp.interval_analytic.map(Into::into),
        /// Ellipsoid of all visits that contains the next position with a probability of 95 %; null
        /// with fewer than five visits (planar robots: four).
        ellipsoid: Option<Iso9283Ellipsoid> = p.ellipsoid.map(Into::into),
        /// RP of all visits without the instrument's noise, if visits were read several times.
        #[serde(skip_serializing_if = "Option::is_none")]
        rp_without_noise_mm: Option<f64> = p.noise_free.map(|n| n.rp_mm),
        /// Standard deviation of one reading along each coordinate.
        #[serde(skip_serializing_if = "Option::is_none")]
        noise_mm: Option<Vector> = p.noise_free.map(|n| n.noise_mm),
        /// Conformity of AP with the given limit.
        #[serde(skip_serializing_if = "Option::is_none")]
        ap_conformity: Option<Conformity> = p.ap.conformity.map(Into::into),
        /// Conformity of RP with the given limit.
        #[serde(skip_serializing_if = "Option::is_none")]
        rp_conformity: Option<Conformity> = p.rp.conformity.map(Into::into),
        /// Expanded uncertainty of the instrument for a position (k = 2), if given.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        position_uncertainty_mm: Option<f64> = p.ap.uncertainty.or(p.rp.uncertainty).map(|u| u.expanded_mm),
        /// Approach with the smallest AP, to which the 25 % rule applies, if visits come from
        /// several.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        ap_smallest_approach: Option<Iso9283JudgedApproach> = p.ap.smallest.clone().map(Into::into),
        /// Approach with the smallest RP, to which the 25 % rule applies, if visits come from
        /// several.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        rp_smallest_approach: Option<Iso9283JudgedApproach> = p.rp.smallest.clone().map(Into::into),
        /// Expanded uncertainty of the instrument for a position (k = 2) over AP, if given; the
        /// largest ratio of all approaches.
        #[serde(skip_serializing_if = "Option::is_none")]
        uncertainty_over_ap: Option<f64> = p.ap.uncertainty.map(|u| u.ratio).filter(|r| r.is_finite()),
        /// Expanded uncertainty of the instrument over RP; the largest ratio of all approaches.
        #[serde(skip_serializing_if = "Option::is_none")]
        uncertainty_over_rp: Option<f64> = p.rp.uncertainty.map(|u| u.ratio).filter(|r| r.is_finite()),
        /// `true` if both ratios are at most a quarter (clause 6).
        #[serde(skip_serializing_if = "Option::is_none")]
        quarter_rule_met: Option<bool> = p.is_verified(),
    }
}

mirror! {
    /// Approach of a pose whose visits come from several approaches: the judged approach has the
    /// worst decision and, among these, the largest value.
    struct Iso9283JudgedApproach of JudgedApproach as a {
        /// Value of the column `approach`, or the previous pose of the path.
        name: String,
        /// Number of visits.
        cycles: usize,
        /// AP or RP of these visits.
        value_mm: f64,
        /// Ellipsoid that contains the next position by this approach with a probability of 95 %;
        /// null with fewer than five visits (planar robots: four).
        #[serde(default, skip_serializing_if = "Option::is_none")]
        ellipsoid: Option<Iso9283Ellipsoid> = a.ellipsoid.map(Into::into),
        /// RP of these visits without the instrument's noise, if visits were read several times.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        rp_without_noise_mm: Option<f64>,
    }
}

impl Iso9283Pose {
    /// Expanded uncertainty of a position (mm); documents of earlier programs contain only its
    /// ratios to the values of all visits.
    pub fn expanded_uncertainty_mm(&self) -> Option<f64> {
        let ratios = [(self.uncertainty_over_rp, self.rp_mm), (self.uncertainty_over_ap, self.ap_mm)];
        self.position_uncertainty_mm.or_else(|| ratios.into_iter().find_map(|(ratio, mm)| Some(ratio? * mm?)))
    }
}

/// A pose characteristic that campaigns can limit.
#[derive(Clone, Copy, Debug)]
pub struct PoseCharacteristic {
    /// Symbol in the standard.
    pub symbol: &'static str,
    /// Limit of the largest value.
    pub limit: LimitQuantity,
    /// Value (mm) of all visits or, if they come from several approaches, of the judged approach.
    pub value: fn(&Iso9283Pose) -> Option<f64>,
    /// Approach that is judged, if visits come from several.
    pub approach: fn(&Iso9283Pose) -> Option<&Iso9283JudgedApproach>,
    /// 95 % interval.
    pub interval: fn(&Iso9283Pose) -> Option<Iso9283Interval>,
    /// `true` if the interval is no coverage interval, because the characteristic drifts.
    pub drifts: fn(&Iso9283Pose) -> bool,
    /// Approach to which the 25 % rule applies, if visits come from several.
    pub smallest: fn(&Iso9283Pose) -> Option<&Iso9283JudgedApproach>,
    /// Expanded uncertainty of a position over the smallest value; `None` if unknown or infinite.
    pub uncertainty_ratio: fn(&Iso9283Pose) -> Option<f64>,
    /// Conformity with the limit.
    pub conformity: fn(&Iso9283Pose) -> Option<Conformity>,
}

impl PoseCharacteristic {
    /// Pose accuracy (7.2.1).
    pub const AP: Self = Self {
        symbol: "AP",
        limit: LimitQuantity::AccuracyMaxMm,
        value: |p| p.ap_approach.as_ref().map(|a| a.value_mm).or(p.ap_mm),
        approach: |p| p.ap_approach.as_ref(),
        interval: |p| p.ap_interval,
        drifts: |p| p.ap_interval_contains_sets,
        smallest: |p| p.ap_smallest_approach.as_ref(),
        uncertainty_ratio: |p| p.uncertainty_over_ap,
        conformity: |p| p.ap_conformity,
    };
    /// Pose repeatability (7.2.2).
    pub const RP: Self = Self {
        symbol: "RP",
        limit: LimitQuantity::RepeatabilityMaxMm,
        value: |p| p.rp_approach.as_ref().map(|a| a.value_mm).or(p.rp_mm),
        approach: |p| p.rp_approach.as_ref(),
        interval: |p| p.rp_interval,
        drifts: |_| false,
        smallest: |p| p.rp_smallest_approach.as_ref(),
        uncertainty_ratio: |p| p.uncertainty_over_rp,
        conformity: |p| p.rp_conformity,
    };
    /// All characteristics in the order of the clauses.
    pub const ALL: [Self; 2] = [Self::AP, Self::RP];
}

mirror! {
    /// Ellipsoid about the mean position; flat in directions without scatter.
    #[derive(Copy)]
    struct Iso9283Ellipsoid of Ellipsoid {
        /// Semi-axes, descending.
        semi_axes_mm: Vector,
        /// Unit vectors of the semi-axes.
        axes: [Vector; 3],
    }
}

mirror! {
    /// Distance between two poses (7.3).
    #[derive(Default)]
    struct Iso9283Distance of PairDistance as d {
        /// The two poses.
        poses: [PoseName; 2],
        /// Number of cycles with both poses.
        cycles: usize,
        /// AD_p: mean attained minus commanded distance.
        ad_mm: f64 = d.position.ad_mm,
        /// AD_x, AD_y and, if spatial, AD_z.
        ad_axes_mm: Vec<f64> = d.coordinates(d.position.ad_axis_mm),
        /// RD_p: three standard deviations.
        rd_mm: f64 = d.position.rd_mm,
        /// RD_x, RD_y and, if spatial, RD_z.
        rd_axes_mm: Vec<f64> = d.coordinates(d.position.rd_axis_mm),
        /// AD of the measured angles, in the order a, b, c; empty if the angles of a pose are not
        /// separable.
        ad_angles_deg: Vec<f64> = degrees(&d.ad_angles_rad),
        /// RD of the measured angles.
        rd_angles_deg: Vec<f64> = degrees(&d.rd_angles_rad),
        /// AD of the angle between the two orientations, where angles are not separable and their
        /// order is given.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        ad_rotation_deg: Option<f64> = d.rotation_rad.map(|[ad, _]| ad.to_degrees()),
        /// RD of this angle.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        rd_rotation_deg: Option<f64> = d.rotation_rad.map(|[_, rd]| rd.to_degrees()),
    }
}

mirror! {
    /// A pose that was approached in several ways (7.2.3).
    struct Iso9283Variation of PoseVariation as v {
        /// Name of the pose.
        pose: PoseName,
        /// Barycentre of all visits of the pose; absent in documents of earlier programs.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        mean_mm: Option<Vector> = Some(v.mean_mm),
        /// vAP_p: largest distance between the barycentres of two approaches.
        vap_mm: f64,
        /// Approaches with the largest distance.
        between: [String; 2],
        /// vAP of the measured angles, in the order a, b, c; empty if they are not separable.
        vap_angles_deg: Vec<f64> = degrees(&v.angles_rad),
        /// Largest angle between the mean orientations of two approaches, where angles are not
        /// separable and their order is given.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        vap_rotation_deg: Option<f64> = v.rotation_rad.map(f64::to_degrees),
        /// Characteristics of each approach.
        approaches: Vec<Iso9283Approach> = all(v.approaches),
    }
}

mirror! {
    /// Visits by one approach.
    struct Iso9283Approach of Approach {
        /// Value of the column `approach`, or the previous pose of the path.
        name: String,
        /// Number of visits.
        cycles: usize,
        /// Barycentre.
        mean_mm: Vector,
        /// Barycentre minus commanded position; null if no position was commanded.
        deviation_mm: Option<Vector>,
        /// RP within this approach; null with a single visit.
        rp_mm: Option<f64>,
        /// Radius of the smallest sphere (planar robots: circle) that encloses the positions of
        /// this approach.
        enclosing_radius_mm: Option<f64>,
    }
}

mirror! {
    /// Drift of one pose (7.6).
    struct Iso9283Drift of Drift {
        /// Name of the pose.
        pose: PoseName,
        /// AP of each set.
        ap_mm: Vec<f64>,
        /// RP of each set.
        rp_mm: Vec<f64>,
        /// |AP at the start − AP at the end|.
        dap_mm: f64,
        /// Expanded uncertainty of `dap_mm`: scatter within the sets.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        dap_expanded_uncertainty_mm: Option<f64>,
        /// |RP at the start − RP at the end|.
        drp_mm: f64,
        /// Number of sets until AP settled.
        settled_after: Option<usize>,
        /// `true` if dAP exceeds the scatter within the sets, at a significance level of 0.1 %.
        #[serde(default)]
        is_significant: bool,
    }
}

impl Iso9283Drift {
    /// `true` if AP drifted significantly and has not settled.
    pub fn is_unsettled(&self) -> bool {
        self.is_significant && self.settled_after.is_none()
    }
}

/// Returns a warning if positions change over the cycles, and no sets of cycles are given for the
/// drift.
fn unstated_drift(test: &PoseTest, settings: &PoseTestSettings) -> Option<Message> {
    let (pose, change_mm) = largest_trend(test).filter(|_| settings.drift_set.is_none())?;
    Some(warning!("positions-drift", pose, change_mm).to_decide())
}

/// Returns a warning if limits are decided by the scatter of the cycles alone.
fn without_instrument(settings: &PoseTestSettings) -> Option<Message> {
    let limited = settings.ap_limit_mm.or(settings.rp_limit_mm).is_some();
    let decided = limited && settings.decision_rule != DecisionRule::SimpleAcceptance;
    (decided && settings.expanded_uncertainty_mm.is_none()).then(|| warning!("limits-without-instrument").to_decide())
}

/// Maximum number of readings that a warning names.
const NAMED: usize = 5;

/// Warning of readings that are far from all others of their pose.
fn outlying(test: &PoseTest) -> Option<Message> {
    let found = outlying_readings(test);
    let named = |v: &OutlyingReading| {
        let OutlyingReading { pose, cycle, distance_mm, median_mm, near } = v;
        match near {
            Some(near) => phrase!("outlying-reading-near", pose, cycle, distance_mm, median_mm, near),
            None => phrase!("outlying-reading", pose, cycle, distance_mm, median_mm),
        }
    };
    let readings: Vec<Phrase> = found.iter().take(NAMED).map(named).collect();
    let more = found.len() - readings.len();
    (!found.is_empty()).then(|| warning!("readings-outlying", count = found.len(), readings, more).to_decide())
}

/// Warning of readings that repeat an earlier reading of their pose.
fn repeated(test: &PoseTest) -> Option<Message> {
    let found = repeated_readings(test);
    let named = |v: &RepeatedReading| phrase!("repeated-reading", pose = v.pose, cycle = v.cycle, first = v.first);
    let readings: Vec<Phrase> = found.iter().take(NAMED).map(named).collect();
    let more = found.len() - readings.len();
    (!found.is_empty()).then(|| warning!("readings-repeated", count = found.len(), readings, more).to_decide())
}

/// Warnings of a test of poses.
fn messages(test: &PoseTest, poses: &[Iso9283Pose]) -> Vec<Message> {
    let mut messages = test.warnings.clone();
    messages.extend(several_ways(test));
    messages.extend(inseparable(test));
    let named = |wanted: fn(&Iso9283Pose) -> bool| {
        let names: Vec<PoseName> = poses.iter().filter(|p| wanted(p)).map(|p| p.pose).collect();
        (!names.is_empty()).then_some(names)
    };
    if let Some(short) = named(|p| p.cycles < CYCLES) {
        // one or two cycles have no interval
        let hint = match poses.iter().all(|p| p.cycles > 2) {
            true => phrase!("decide-by-intervals"),
            false => phrase!("measure-cycles"),
        };
        messages.push(warning!("few-cycles", least = CYCLES, count = short.len(), poses = short).hint(hint));
    }
    if let Some(coarse) = named(|p| p.quarter_rule_met == Some(false)) {
        messages.push(warning!("instrument-too-coarse", count = coarse.len(), poses = coarse));
    }
    messages
}

/// Warnings of poses whose angles are not separable, one for each two angles.
fn inseparable(test: &PoseTest) -> Vec<Message> {
    let mut named: BTreeMap<([usize; 2], bool), Vec<PoseName>> = BTreeMap::new();
    for p in &test.poses {
        if let Some(found) = test.inseparable(p) {
            named.entry((found.angles, found.is_stated)).or_default().push(p.pose);
        }
    }
    let place = |poses: Vec<PoseName>| phrase!("angles-of-poses", count = poses.len(), poses);
    named.into_iter().map(|((angles, stated), poses)| not_separable(angles, stated, place(poses))).collect()
}

/// Warning of positions or angles that do not belong to the commanded ones.
///
/// # Errors
/// A table in another unit is an error: no characteristic of it is true.
pub(super) fn misplacement(found: &Misplacement) -> Result<Message> {
    match found {
        Misplacement::Unit { table, axes, unit, length_mm } => {
            let axes: Vec<&str> = axes.iter().map(|&k| AXES[k]).collect();
            let (table, robot) = match table {
                TestTable::Attained(robot) if robot.is_empty() => ("attained", String::new()),
                TestTable::Attained(robot) => ("robot", one_line(robot)),
                TestTable::Commanded => ("commanded", String::new()),
            };
            let (count, unit) = (axes.len(), *unit);
            Err(error!("positions-in-other-unit", axes, count, table, robot, unit, length_mm).into())
        }
        Misplacement::AngleUnit { table, angles } => {
            let table = if *table == TestTable::Commanded { "commanded" } else { "attained" };
            Err(error!("angles-in-other-unit", count = angles.len(), angles = letters(angles), table).into())
        }
        Misplacement::Angles { angles, largest_rad, poses } => {
            let (angles, deviation_deg) = (letters(angles), largest_rad.to_degrees());
            Ok(warning!("angles-far-from-commanded", angles, deviation_deg, poses).to_decide())
        }
        Misplacement::Columns { deviation_mm, change, left_mm } => {
            let (change, columns) = match change {
                ColumnChange::Swapped(columns) => ("swapped", &columns[..]),
                ColumnChange::Order(columns) => ("order", &columns[..]),
                ColumnChange::Sign(column) => ("sign", std::slice::from_ref(column)),
            };
            let columns: Vec<&str> = columns.iter().map(|&k| AXES[k]).collect();
            Ok(warning!("coordinates-exchanged", deviation_mm, change, columns, left_mm).to_decide())
        }
        Misplacement::Frame { deviation_mm, shift_mm, turn_rad, left_mm } => {
            let turn_deg = turn_rad.unwrap_or(0.0).to_degrees();
            let (turned, [x_mm, y_mm, z_mm]) = (if turn_rad.is_some() { "turned" } else { "shifted" }, *shift_mm);
            Ok(warning!("poses-in-other-frame", deviation_mm, turned, turn_deg, x_mm, y_mm, z_mm, left_mm).to_decide())
        }
        Misplacement::Large { deviation_mm, extent_mm, poses } => {
            Ok(warning!("deviation-as-large-as-test", deviation_mm, extent_mm, poses).to_decide())
        }
    }
}

/// Names of the coordinates.
const AXES: [&str; 3] = ["x", "y", "z"];
/// Names of the angles.
const LETTERS: [&str; 3] = ["a", "b", "c"];

/// Names of angles by their numbers.
fn letters(angles: &[usize]) -> Vec<&'static str> {
    angles.iter().map(|&k| LETTERS[k]).collect()
}

/// Warning that two angles are not separable at a place of the test.
pub(super) fn not_separable(angles: [usize; 2], is_stated: bool, place: Phrase) -> Message {
    let [first, second] = angles.map(|k| LETTERS[k]);
    let order = if is_stated { "stated" } else { "unknown" };
    warning!("angles-not-separable", first, second, place, order)
}

/// Texts of the approaches that are named after the pose before.
fn approach_phrases(visits: &PoseTest) -> BTreeMap<String, Phrase> {
    let stated: BTreeSet<&str> =
        visits.poses.iter().flat_map(|p| &p.attained).filter_map(|v| v.approach.as_deref()).collect();
    let named = visits.poses.iter().map(|p| (from_pose(p.pose), phrase!("from-pose-named", pose = p.pose)));
    named.filter(|(name, _)| stated.contains(name.as_str())).collect()
}

fn conventions(visits: &PoseTest, settings: &PoseTestSettings) -> Vec<Phrase> {
    let mut conventions = vec![
        phrase!("convention-ap-rp"),
        match settings.expanded_uncertainty_mm {
            Some(u) => phrase!("convention-intervals-instrument", uncertainty_um = (u * 1e9).round() / 1e6),
            None => phrase!("convention-intervals-sampling"),
        },
        phrase!("convention-rp-clause"),
    ];
    if visits.poses.iter().all(|p| p.commanded_mm.is_none()) {
        conventions.push(phrase!("convention-no-commanded-poses"));
    }
    if settings.ap_limit_mm.or(settings.rp_limit_mm).is_some() {
        conventions.push(match settings.decision_rule {
            DecisionRule::Guarded => phrase!("convention-guarded-acceptance"),
            DecisionRule::SimpleAcceptance => phrase!("convention-simple-acceptance"),
            DecisionRule::SharedRisk => phrase!("convention-shared-risk"),
        });
    }
    let robots = visits.robots();
    if let (Some(first), true) = (robots.first(), robots.len() > 1) {
        conventions.push(phrase!("convention-first-robot", count = robots.len(), robot = one_line(first)));
    }
    if visits.poses.iter().flat_map(|p| &p.attained).any(|v| v.readings_mm.len() > 1) {
        conventions.push(phrase!("convention-readings-averaged"));
    }
    if !visits.angles.is_empty() {
        conventions.push(match &settings.rotation_order {
            Some(order) => phrase!("convention-angles", order),
            None => phrase!("convention-angles-of-unknown-order"),
        });
        if visits.order().is_some() && visits.poses.iter().any(|p| visits.inseparable(p).is_some()) {
            conventions.push(phrase!("convention-rotation-vectors"));
        }
    }
    conventions
}

/// Warning if visits of a pose come from several directions, because AP and RP of the standard
/// assume one direction (7.2.1, 7.2.2).
fn several_ways(visits: &PoseTest) -> Option<Message> {
    let several = visits.poses.iter().filter(|p| !p.repeated_approaches().is_empty());
    let poses: Vec<PoseName> = several.map(|p| p.pose).collect();
    (!poses.is_empty()).then(|| warning!("several-approaches", count = poses.len(), poses))
}
