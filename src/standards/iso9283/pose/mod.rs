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

use self::accuracy::{angle_accuracy_rad, pose_accuracy};
use self::coplanarity::coplanarity;
use self::directions::{angle_variation_rad, variation};
use self::distance::{angle_distance_rad, distance};
use self::drift::drift;
use self::ellipsoid::ellipsoid;
use self::exchangeability::exchangeability;
use self::noise_free::without_noise;
use self::repeatability::{angle_repeatability_rad, pose_repeatability};
use self::test::{Pair, PoseTest, TestedPose};
use crate::iso9283::statistics::bootstrap::Bootstrap;
use crate::iso9283::statistics::interval::{accuracy_interval, repeatability_interval};
use crate::iso9283::statistics::uncertainty_ratio::uncertainty_ratio;
use etalon_base::message::{Message, Result, one_line};
use etalon_base::pose::{Vector, minus};
use etalon_documents::{
    Conformity, DecisionRule, Iso9283Approach, Iso9283Distance, Iso9283Document, Iso9283Drift, Iso9283Interval,
    Iso9283Pose, Iso9283Variation,
};
use std::collections::BTreeSet;
use std::collections::btree_map::{BTreeMap, Entry};

/// What the data do not say.
#[derive(Clone, Debug)]
pub struct Settings {
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
const CYCLES: usize = 30;
/// Simulated tests behind an interval.
pub const DRAWS: usize = 2000;

/// All characteristics of attained poses. Of several robots it is the first by name, and what exchanging them does.
pub fn evaluate(all: &PoseTest, settings: &Settings) -> Result<Iso9283Document> {
    let count = all.robots().len();
    if count > 1 && settings.ap_limit_mm.or(settings.rp_limit_mm).is_some() {
        let message = Message::error(format!("limits are of one robot, and the table holds {count}"));
        return Err(message.hint("test each robot by itself; together they give the exchangeability").into());
    }
    let visits = &all.of_first_robot();
    let poses = poses(visits, settings)?;
    let mut messages = visits.warnings.clone();
    messages.extend(several_ways(visits));
    let short: Vec<String> = poses.iter().filter(|p| p.cycles < CYCLES).map(|p| p.pose.to_string()).collect();
    if !short.is_empty() {
        let message = Message::warning(format!("fewer than {CYCLES} cycles at pose {}", short.join(", ")));
        messages.push(message.hint("ISO 9283 asks for 30; the intervals show what fewer leave open"));
    }
    let coarse: Vec<String> =
        poses.iter().filter(|p| p.quarter_rule_met == Some(false)).map(|p| p.pose.to_string()).collect();
    if !coarse.is_empty() {
        let at = coarse.join(", ");
        let message = Message::warning(format!(
            "the instrument's uncertainty exceeds a quarter of what it verifies at pose {at}"
        ));
        messages.push(message.hint("the values are upper bounds of the robot's; measure with a better instrument"));
    }
    Ok(Iso9283Document {
        schema: "etalon/iso9283/1".to_owned(),
        conventions: conventions(all, settings),
        distances: distances(visits)?,
        approaches: approaches(visits)?,
        drifts: drifts(visits, settings.drift_set)?,
        exchangeability_mm: exchanged(all)?,
        coplanarity_mm: flatness(visits)?,
        coplanarity_of_four: Vec::new(),
        homing: None,
        visits: Vec::new(),
        limits: Vec::new(),
        reference: Vec::new(),
        poses,
        messages,
    })
}

fn conventions(visits: &PoseTest, settings: &Settings) -> Vec<String> {
    let mut conventions = vec![
        "AP: mean minus commanded; RP: mean radius + 3 s, s with n - 1; intervals 95 %, Gaussian scatter".to_owned(),
        match settings.expanded_uncertainty_mm {
            Some(u) => format!(
                "intervals contain the sampling and the instrument's expanded uncertainty of a coordinate, {} um (k = 2)",
                (u * 1e9).round() / 1e6
            ),
            None => "intervals contain the sampling alone: no uncertainty of the instrument is stated".to_owned(),
        },
        "RP follows the standard's text (7.2.2); the other clauses were not compared with a bought copy".to_owned(),
    ];
    if visits.poses.iter().all(|p| p.commanded_mm.is_none()) {
        conventions.push("no commanded poses: AP, distances and drift are not determined, and null".to_owned());
    }
    if settings.ap_limit_mm.or(settings.rp_limit_mm).is_some() {
        conventions.push(match settings.decision_rule {
            DecisionRule::Guarded => {
                "conformity: guarded acceptance (ISO 14253-1) with the interval of 95 %: proven only where all of it is on one side"
            }
            DecisionRule::SimpleAcceptance => "conformity: simple acceptance (ILAC-G8:09/2019, 4.2.1)",
            DecisionRule::SharedRisk => {
                "conformity: shared risk (JCGM 106:2012, 8.2.1): decided where the expanded uncertainty is at most a quarter of the limit"
            }
        }.to_owned());
    }
    let robots = visits.robots();
    if let (Some(first), true) = (robots.first(), robots.len() > 1) {
        let one = one_line(first);
        conventions.push(format!("of {} robots: all is of `{one}`, but for exchangeability", robots.len()));
    }
    if visits.poses.iter().flat_map(|p| &p.attained).any(|v| v.readings_mm.len() > 1) {
        conventions.push("readings of one visit are averaged; their scatter is the instrument's noise".to_owned());
    }
    if !visits.angles.is_empty() {
        let order = settings.rotation_order.as_deref().unwrap_or("not stated");
        conventions.push(format!("angles a, b, c are unwrapped and treated each alone; order of rotations: {order}"));
    }
    conventions
}

/// A warning where visits of a pose come from several directions: the standard's AP and RP are of one (7.2.1, 7.2.2).
fn several_ways(visits: &PoseTest) -> Option<Message> {
    let several = visits.poses.iter().filter(|p| p.approaches().values().filter(|count| **count > 1).count() > 1);
    let poses: Vec<String> = several.map(|p| p.pose.to_string()).collect();
    let what = format!(
        "approached in several ways: pose {}; AP, RP and their intervals are of all visits together",
        poses.join(", ")
    );
    let hint = "what the standard calls RP is that of each approach, listed beside it; together they hold vAP as well, and their scatter is not Gaussian";
    (!poses.is_empty()).then(|| Message::warning(what).hint(hint))
}

fn poses(visits: &PoseTest, settings: &Settings) -> Result<Vec<Iso9283Pose>> {
    let mut bootstraps: BTreeMap<usize, Bootstrap> = BTreeMap::new();
    let mut all = Vec::new();
    for p in &visits.poses {
        let positions = p.positions_mm(|_| true);
        let n = positions.len();
        let mut pose = Iso9283Pose { pose: p.pose, cycles: n, ..Iso9283Pose::default() };
        let accuracy = p.commanded_mm.map(|commanded| pose_accuracy(&positions, commanded)).transpose()?;
        if let Some(found) = &accuracy {
            pose.ap_mm = Some(found.ap_mm);
            pose.ap_x_mm = Some(found.deviation_mm[0]);
            pose.ap_y_mm = Some(found.deviation_mm[1]);
            pose.ap_z_mm = visits.spatial.then_some(found.deviation_mm[2]);
        }
        angles(&mut pose, visits, p);
        if n >= 2 {
            let found = pose_repeatability(&positions)?;
            pose.rp_mm = Some(found.rp_mm);
            pose.rp_xy_mm = Some(found.plane_mm);
            pose.rp_along_x_mm = Some(found.along_mm[0]);
            pose.rp_along_y_mm = Some(found.along_mm[1]);
            pose.rp_along_z_mm = visits.spatial.then_some(found.along_mm[2]);
            pose.mean_radius_mm = Some(found.mean_radius_mm);
            pose.sd_radius_mm = Some(found.sd_radius_mm);
            pose.enclosing_radius_mm = Some(found.enclosing_radius_mm);
            pose.enclosing_circle_radius_mm = Some(found.enclosing_circle_radius_mm);
            pose.rp_x_mm = Some(found.axis_mm[0]);
            pose.rp_y_mm = Some(found.axis_mm[1]);
            pose.rp_z_mm = visits.spatial.then_some(found.axis_mm[2]);
            if n >= 3 && settings.draws > 0 {
                let bootstrap = match bootstraps.entry(n) {
                    Entry::Occupied(shared) => shared.into_mut(),
                    Entry::Vacant(place) => place.insert(Bootstrap::new(n, settings.draws, settings.seed)?),
                };
                if let Some(accuracy) = &accuracy {
                    pose.ap_interval = Some(bootstrap.accuracy(&positions, accuracy)?);
                    pose.ap_interval_analytic = Some(accuracy_interval(&positions, accuracy)?);
                }
                pose.rp_interval = Some(bootstrap.repeatability(&positions, &found)?);
                pose.rp_interval_analytic = Some(repeatability_interval(&positions, &found)?);
            }
        }
        if let Some(expanded_mm) = settings.expanded_uncertainty_mm {
            pose.ap_interval =
                pose.ap_interval.zip(pose.ap_mm).map(|(i, ap_mm)| with_instrument(i, ap_mm, expanded_mm));
            pose.rp_interval = pose.rp_interval.map(|interval| without_noise_of(interval, expanded_mm, visits.spatial));
        }
        beyond(&mut pose, p, &positions, settings)?;
        let of_coordinates =
            || settings.expanded_uncertainty_mm.map(|u| u * if visits.spatial { 3f64 } else { 2.0 }.sqrt());
        if let Some(uncertainty) = settings.position_uncertainty_mm.or_else(of_coordinates) {
            let ap = pose.ap_mm.map(|ap| uncertainty_ratio(uncertainty, ap));
            let rp = pose.rp_mm.map(|rp| uncertainty_ratio(uncertainty, rp));
            // over nothing there is no ratio
            pose.uncertainty_over_ap = ap.map(|a| a.ratio).filter(|r| r.is_finite());
            pose.uncertainty_over_rp = rp.map(|r| r.ratio).filter(|r| r.is_finite());
            let judged = || ap.iter().chain(&rp);
            pose.quarter_rule_met = judged().next().map(|_| judged().all(|q| q.met));
        }
        all.push(pose);
    }
    Ok(all)
}

/// The interval of AP with the instrument's expanded uncertainty (k = 2) of a coordinate beside the sampling's: both halves as the
/// root of the sum of squares (GUM 5.1.2). A mean of many readings is wrong by what all of them have in common.
fn with_instrument(sampling: Iso9283Interval, ap_mm: f64, expanded_mm: f64) -> Iso9283Interval {
    Iso9283Interval {
        low_mm: (ap_mm - (ap_mm - sampling.low_mm).hypot(expanded_mm)).max(0.0),
        high_mm: ap_mm + (sampling.high_mm - ap_mm).hypot(expanded_mm),
    }
}

/// The interval of the robot's RP where readings scatter with the instrument's expanded uncertainty (k = 2) of a coordinate: the noise
/// only adds, so that the upper end stays, and the lower one is what is left if all of the uncertainty is noise (mean + 3 s of the
/// radius of Gaussian noise: 3.615 standard deviations in space, 3.219 in the plane; Maxwell and Rayleigh distribution).
fn without_noise_of(found: Iso9283Interval, expanded_mm: f64, spatial: bool) -> Iso9283Interval {
    let noise_mm = if spatial { 3.615 } else { 3.219 } * expanded_mm / 2.0;
    Iso9283Interval { low_mm: (found.low_mm.powi(2) - noise_mm.powi(2)).max(0.0).sqrt(), ..found }
}

/// What the standard does not ask for: ellipsoid, conformity with limits, RP without the instrument's noise.
fn beyond(pose: &mut Iso9283Pose, p: &TestedPose, positions: &[Vector], settings: &Settings) -> Result<()> {
    // too few visits have none
    pose.ellipsoid = ellipsoid(positions).ok();
    // too few visits prove nothing
    let judged = |mm: Option<f64>, interval: Option<Iso9283Interval>, limit_mm: Option<f64>| {
        let judge = |limit| mm.map_or(Conformity::Neither, |mm| settings.decision_rule.judge(mm, interval, limit));
        limit_mm.map(judge)
    };
    pose.ap_conformity = judged(pose.ap_mm, pose.ap_interval, settings.ap_limit_mm);
    pose.rp_conformity = judged(pose.rp_mm, pose.rp_interval, settings.rp_limit_mm);
    if p.attained.len() > 2 && p.attained.iter().any(|v| v.readings_mm.len() > 1) {
        let readings: Vec<Vec<Vector>> = p.attained.iter().map(|v| v.readings_mm.clone()).collect();
        let free = without_noise(&readings)?;
        (pose.rp_without_noise_mm, pose.noise_mm) = (Some(free.rp_mm), Some(free.noise_mm));
    }
    Ok(())
}

fn angles(pose: &mut Iso9283Pose, visits: &PoseTest, p: &TestedPose) {
    let Iso9283Pose { ap_a_deg, ap_b_deg, ap_c_deg, rp_a_deg, rp_b_deg, rp_c_deg, .. } = pose;
    let (ap, rp) = ([ap_a_deg, ap_b_deg, ap_c_deg], [rp_a_deg, rp_b_deg, rp_c_deg]);
    for (k, &axis) in visits.angles.iter().enumerate() {
        let attained = p.angles_rad(k, |_| true);
        *ap[axis] = p.commanded_rad.get(k).map(|commanded| angle_accuracy_rad(&attained, *commanded).to_degrees());
        *rp[axis] = Some(angle_repeatability_rad(&attained).to_degrees()).filter(|rp| rp.is_finite());
    }
}

/// Distances of every pair of poses, by the cycles that have each of them once.
fn distances(visits: &PoseTest) -> Result<Vec<Iso9283Distance>> {
    let mut all = Vec::new();
    for (i, p) in visits.poses.iter().enumerate() {
        for q in &visits.poses[i + 1..] {
            let (Some(from), Some(to)) = (p.commanded_mm, q.commanded_mm) else { continue };
            let pairs = p.pairs(q);
            if pairs.len() < 2 {
                continue;
            }
            let positions = |of: fn(&Pair) -> Vector| pairs.iter().map(of).collect::<Vec<_>>();
            let (first, second) = (positions(|v| v.from.position_mm), positions(|v| v.to.position_mm));
            let found = distance(&first, &second, [from, to])?;
            let axes = if visits.spatial { 3 } else { 2 };
            let turned = (0..visits.angles.len()).map(|k| {
                let (a, b): (Vec<f64>, Vec<f64>) =
                    pairs.iter().map(|v| (v.from.angles_rad[k], v.to.angles_rad[k])).unzip();
                angle_distance_rad(&a, &b, [p.commanded_rad[k], q.commanded_rad[k]])
            });
            let (ad, rd): (Vec<f64>, Vec<f64>) = turned.map(|(ad, rd)| (ad.to_degrees(), rd.to_degrees())).unzip();
            all.push(Iso9283Distance {
                poses: [p.pose, q.pose],
                cycles: pairs.len(),
                ad_mm: found.ad_mm,
                ad_axes_mm: found.ad_axis_mm[..axes].to_vec(),
                rd_mm: found.rd_mm,
                rd_axes_mm: found.rd_axis_mm[..axes].to_vec(),
                ad_angles_deg: ad,
                rd_angles_deg: rd,
            });
        }
    }
    Ok(all)
}

fn approaches(visits: &PoseTest) -> Result<Vec<Iso9283Variation>> {
    let mut all = Vec::new();
    for p in &visits.poses {
        let counts = p.approaches();
        if counts.len() < 2 {
            continue;
        }
        let by = |name: &&str| p.positions_mm(|v| v.approach.as_deref() == Some(*name));
        let groups: Vec<Vec<Vector>> = counts.keys().map(by).collect();
        let found = variation(&groups)?;
        let names: Vec<&str> = counts.keys().copied().collect();
        let turned = (0..visits.angles.len()).map(|k| {
            let by = |name: &&str| p.angles_rad(k, |v| v.approach.as_deref() == Some(*name));
            angle_variation_rad(&names.iter().map(by).collect::<Vec<_>>()).to_degrees()
        });
        let approach = |(i, name): (usize, &&str)| Iso9283Approach {
            name: (*name).to_owned(),
            cycles: groups[i].len(),
            mean_mm: found.means_mm[i],
            deviation_mm: p.commanded_mm.map(|commanded| minus(found.means_mm[i], commanded)),
            rp_mm: found.within[i].map(|w| w.rp_mm),
            enclosing_radius_mm: found.within[i].map(|w| w.enclosing_radius_mm),
        };
        all.push(Iso9283Variation {
            pose: p.pose,
            vap_mm: found.vap_mm,
            between: [names[found.between.0].to_owned(), names[found.between.1].to_owned()],
            vap_angles_deg: turned.collect(),
            approaches: names.iter().enumerate().map(approach).collect(),
        });
    }
    Ok(all)
}

/// Drift of every commanded pose, in sets of so many cycles; too few of them are an error.
pub fn drifts(visits: &PoseTest, set: Option<usize>) -> Result<Vec<Iso9283Drift>> {
    let Some(size) = set else { return Ok(Vec::new()) };
    let drifting = |(p, commanded): (&TestedPose, Vector)| -> Result<Iso9283Drift> {
        // in the order of cycles; a set that was cut short does not count
        let cycles: BTreeSet<i64> = p.attained.iter().map(|v| v.cycle).collect();
        let cycles: Vec<i64> = cycles.into_iter().collect();
        let sets: Vec<Vec<Vector>> =
            cycles.chunks_exact(size.max(1)).map(|set| p.positions_mm(|v| set.contains(&v.cycle))).collect();
        drift(p.pose, &sets, commanded)
    };
    visits.poses.iter().filter_map(|p| Some((p, p.commanded_mm?))).map(drifting).collect()
}

fn exchanged(visits: &PoseTest) -> Result<Option<f64>> {
    let robots = visits.robots();
    if robots.len() < 2 {
        return Ok(None);
    }
    let lacks =
        |robot: &&str| visits.poses.iter().find(|p| p.attained.iter().all(|v| v.robot != *robot)).map(|p| p.pose);
    if let Some((robot, pose)) = robots.iter().find_map(|robot| Some((robot, lacks(robot)?))) {
        let message = Message::error(format!("exchangeability: robot `{}` did not visit pose {pose}", one_line(robot)));
        return Err(message.expected("every robot at every pose").into());
    }
    let of = |robot: &&str| visits.poses.iter().map(|p| p.positions_mm(|v| v.robot == *robot)).collect::<Vec<_>>();
    let attained: Vec<Vec<Vec<Vector>>> = robots.iter().map(of).collect();
    Ok(Some(exchangeability(&attained)?.e_mm))
}

fn flatness(visits: &PoseTest) -> Result<Option<f64>> {
    if !visits.spatial || visits.poses.len() < 4 {
        return Ok(None);
    }
    let means: Vec<Vec<Vector>> = visits.poses.iter().map(|p| p.positions_mm(|_| true)).collect();
    // poses on a line have no plane
    Ok(coplanarity(&means).ok().map(|c| c.flatness_mm))
}
