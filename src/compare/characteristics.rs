//! ISO 9283 pose characteristics over campaigns.

use super::significance::{Estimate, Recovered, Scale, degrees_of_scale, ratio_of_scales, recovered};
use super::trend::{TrendName, changed, pairs, trend_from_estimates};
use etalon_base::catalogue::{IntoArgument, Phrase};
use etalon_base::message::Message;
use etalon_base::pose_name::PoseName;
use etalon_base::{phrase, warning};
use etalon_documents::*;
use etalon_standards::iso9283::statistics::sample::spread;
use std::collections::BTreeSet;

/// AP, mean position and RP of all poses that occur in every campaign, including homings.
pub(super) fn trends(all: &[&Iso9283Document], messages: &mut Vec<Message>) -> Vec<CompareTrend> {
    let Some(first) = all.first() else { return Vec::new() };
    let mut trends = Vec::new();
    let mut missing = Vec::new();
    let later: BTreeSet<PoseName> = all.iter().flat_map(|d| &d.poses).map(|p| p.pose).collect();
    missing.extend(later.into_iter().filter(|pose| first.poses.iter().all(|p| p.pose != *pose)).map(|p| p.argument()));
    for pose in &first.poses {
        let same: Vec<&Iso9283Pose> = all.iter().filter_map(|d| d.poses.iter().find(|p| p.pose == pose.pose)).collect();
        if same.len() < all.len() {
            missing.push(pose.pose.argument());
            continue;
        }
        let place = phrase!("pose-named", pose = pose.pose);
        trends.extend(accuracy(&place, &same));
        trends.extend(positions(&place, all, &same));
        trends.extend(repeatability(&place, &same));
    }
    let homings: Vec<&Iso9283Pose> = all.iter().filter_map(|d| d.robot.homing.as_ref()).collect();
    if homings.len() == all.len() {
        trends.extend(repeatability(&phrase!("homing"), &homings));
    } else if !homings.is_empty() {
        missing.push(phrase!("homing").argument());
    }
    if !missing.is_empty() {
        messages.push(warning!("poses-not-in-all", count = missing.len(), poses = missing));
    }
    trends.sort_by_key(|t| t.family);
    trends
}

fn accuracy(place: &Phrase, all: &[&Iso9283Pose]) -> Option<CompareTrend> {
    let known =
        |p: &&Iso9283Pose| Some(((PoseCharacteristic::AP.value)(p)?, p.ap_interval?.low_mm, p.ap_interval?.high_mm));
    let values = all.iter().map(known).collect::<Option<Vec<Recovered>>>()?;
    let change = |[from, to]: [usize; 2]| changed([from, to], &recovered(values[from], values[to]), None);
    let value =
        |v: &Recovered| CompareValue { value: Some(v.0), standard_uncertainty: None, low: Some(v.1), high: Some(v.2) };
    let changes = pairs(all.len()).into_iter().map(change).collect();
    let values = values.iter().map(value).collect();
    Some(TrendName::at("AP", place).trend(CompareFamily::PoseAccuracy, "mm", values, changes))
}

/// Mean of each coordinate: from the visits if all documents have them, otherwise from the
/// commanded position.
fn positions(place: &Phrase, documents: &[&Iso9283Document], all: &[&Iso9283Pose]) -> Vec<CompareTrend> {
    let visited = |(d, p): (&&Iso9283Document, &&Iso9283Pose)| {
        let of_pose = d.recorded.visits.iter().filter(|v| v.pose == p.pose).map(|v| v.attained_mm);
        of_pose.collect::<Vec<_>>()
    };
    let visits: Vec<_> = documents.iter().zip(all).map(visited).collect();
    let mut trends = Vec::new();
    for (axis, letter) in ["x", "y", "z"].into_iter().enumerate() {
        let estimates: Option<Vec<Option<Estimate>>> = match visits.iter().all(|v| v.len() > 1) {
            _ if axis == 2 && all.iter().any(|p| p.rp_z_mm.is_none()) => None,
            true => Some(
                visits
                    .iter()
                    .map(|v| {
                        let s = spread(&v.iter().map(|p| p[axis]).collect::<Vec<_>>());
                        Some(mean(s.mean, s.deviation, v.len()))
                    })
                    .collect(),
            ),
            false => all
                .iter()
                .map(|p| {
                    let (deviation, three) =
                        [(p.ap_x_mm, p.rp_x_mm), (p.ap_y_mm, p.rp_y_mm), (p.ap_z_mm, p.rp_z_mm)][axis];
                    Some(Some(mean(deviation?, three? / 3.0, p.cycles)))
                })
                .collect(),
        };
        let name = TrendName::at(phrase!("mean-of-axis", axis = letter), place);
        let family = CompareFamily::MeanPosition;
        trends.extend(estimates.map(|estimates| trend_from_estimates(family, name, "mm", &estimates)));
    }
    trends
}

fn mean(value: f64, deviation: f64, visits: usize) -> Estimate {
    let n = visits as f64;
    Estimate { value, standard_uncertainty: deviation / n.sqrt(), degrees: n - 1.0 }
}

fn repeatability(place: &Phrase, all: &[&Iso9283Pose]) -> Option<CompareTrend> {
    let known = |p: &&Iso9283Pose| {
        let visits = p.rp_approach.as_ref().map_or(p.cycles, |approach| approach.cycles);
        Some(((PoseCharacteristic::RP.value)(p)?, p.rp_interval_analytic?, visits as f64))
    };
    let values = all.iter().map(known).collect::<Option<Vec<_>>>()?;
    let change = |[from, to]: [usize; 2]| {
        let scale = |(rp, i, n): (f64, Iso9283Interval, f64)| {
            // radii about the sample mean are too small by the factor √(1 − 1/n)
            Some(Scale { value: rp * (n / (n - 1.0)).sqrt(), degrees: degrees_of_scale(i.low_mm, i.high_mm)? })
        };
        let found = ratio_of_scales(scale(values[from])?, scale(values[to])?)?;
        Some(changed([from, to], &found, Some(values[to].0 - values[from].0)))
    };
    let value = |v: &(f64, Iso9283Interval, f64)| CompareValue {
        value: Some(v.0),
        standard_uncertainty: None,
        low: Some(v.1.low_mm),
        high: Some(v.1.high_mm),
    };
    let changes = pairs(all.len()).into_iter().filter_map(change).collect();
    let values = values.iter().map(value).collect();
    Some(TrendName::at("RP", place).trend(CompareFamily::PoseRepeatability, "mm", values, changes))
}
