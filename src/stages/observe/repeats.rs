//! Repeated values: readings and joint values that are identical, and repeats of a fixed point that
//! disagree.

use crate::stages::truncated;
use etalon_base::message::Message;
use etalon_base::pattern::matches_pattern;
use etalon_base::pose::{Vector, minus, norm};
use etalon_base::{error, phrase, warning};
use etalon_campaign::Campaign;
use etalon_formats::Point;
use etalon_identify::Observation;
use etalon_math::statistics::middle_pair;
use etalon_robots::Robot;
use std::collections::BTreeMap;

/// Minimum motion (mm) of a target by the nominal robot between two different poses.
const MOVED_MM: f64 = 1.0;
/// Maximum distance of repeats of one point, in standard uncertainties of a coordinate: the
/// instrument exceeds it in three coordinates fewer than once in ten thousand times.
const APART: f64 = 5.0;
/// Distance of a repeat from the others, in standard uncertainties, that falsifies the frame.
const SPOILS: f64 = 20.0;
/// Distance (mm) beyond which most points of a label are several points by design.
const SEVERAL_MM: f64 = 1.0;
/// Maximum number of named pairs or repeats.
const NAMED: usize = 5;

/// Warnings about measured positions, or joint values, that are identical to the last digit at
/// poses where the others differ: the reading belongs to another pose.
pub fn stale<'o>(robot: &dyn Robot, observations: &'o [Observation]) -> Vec<Message> {
    let nominal = robot.nominal();
    let targets = |o: &'o Observation| (0..).zip(&o.targets).filter_map(|(k, at)| Some((k, (*at)?.map(f64::to_bits))));
    let mut at_place: Vec<((usize, [u64; 3]), &Observation)> =
        observations.iter().flat_map(|o| targets(o).map(move |place| (place, o))).collect();
    at_place.sort_by_key(|(place, _)| *place);
    let places = || at_place.chunk_by(|a, b| a.0 == b.0);
    let repeated: Vec<_> = places().filter(|all| all.iter().any(|(_, o)| o.pose != all[0].1.pose)).collect();
    let mut points = Vec::new();
    // balls that are touched in several working modes are measured once, by design
    if 2 * repeated.len() < places().count() {
        for all in repeated {
            let ((k, _), first) = all[0];
            let moved = |o: &&Observation| {
                let shift = minus(robot.position(&nominal, &o.joints, k), robot.position(&nominal, &first.joints, k));
                o.pose != first.pose && norm(shift) > MOVED_MM
            };
            let pair = |o: &Observation| {
                phrase!("repeated-position", target = robot.targets()[k], first = first.pose, second = o.pose)
            };
            points.extend(all.iter().map(|(_, o)| *o).filter(moved).map(pair));
        }
    }
    let apart = |a: &Observation, b: &Observation| {
        let both = a.targets.iter().zip(&b.targets);
        both.filter_map(|(a, b)| Some(norm(minus((*a)?, (*b)?)))).fold(0.0, f64::max)
    };
    let joints = |o: &'o Observation| o.joints.iter().map(|q| q.to_bits());
    let mut at_joints: Vec<&Observation> = observations.iter().collect();
    at_joints.sort_by(|a, b| joints(a).cmp(joints(b)));
    let far = |all: &[&Observation]| -> Vec<_> {
        let pair = |o: &&Observation| {
            phrase!("repeated-joints", first = all[0].pose, second = o.pose, apart_mm = apart(o, all[0]))
        };
        all.iter().filter(|o| o.pose != all[0].pose && apart(o, all[0]) > MOVED_MM).map(pair).collect()
    };
    let logs: Vec<_> = at_joints.chunk_by(|a, b| joints(a).eq(joints(b))).flat_map(far).collect();
    let mut messages = Vec::new();
    if !points.is_empty() {
        messages.push(warning!("positions-repeat", count = points.len(), pairs = truncated(points, NAMED)));
    }
    if !logs.is_empty() {
        messages.push(warning!("joint-values-repeat", count = logs.len(), pairs = truncated(logs, NAMED)));
    }
    messages
}

/// Number of points of a label that show whether it is a scan.
const MOST_OF_SCAN: usize = 1000;

/// Median of each coordinate.
fn middle(points: &[&Point]) -> Vector {
    [0, 1, 2].map(|i| middle_pair(points.iter().map(|p| p.xyz_mm[i])).map_or(0.0, |[low, high]| 0.5 * (low + high)))
}

/// `true` if most points are further than `near_mm` from their middle, some of them far.
fn is_scan(points: &[&Point], near_mm: f64) -> bool {
    let middle = middle(points);
    let off = || points.iter().map(|p| norm(minus(p.xyz_mm, middle))).filter(|off| *off > near_mm);
    2 * off().count() > points.len() && off().fold(0.0, f64::max) > SEVERAL_MM
}

/// Messages about points of the same label whose repeats scatter more than the instrument explains,
/// for the labels of features and frames; `names` are those labels. An error if one repeat
/// falsifies the results.
pub fn fixed_points(campaign: &Campaign, points: &[Point], names: &[&str]) -> Vec<Message> {
    let instrument = &campaign.file.instrument;
    let mut repeats: BTreeMap<&str, Vec<&Point>> = BTreeMap::new();
    for point in points.iter().filter(|p| p.pose.is_none() && names.iter().any(|name| matches_pattern(name, &p.label)))
    {
        repeats.entry(&point.label).or_default().push(point);
    }
    let mut messages = Vec::new();
    for (label, all) in repeats {
        // a part of a long scan shows that it is one
        let some: Vec<&Point> = all.iter().step_by(all.len().div_ceil(MOST_OF_SCAN)).copied().collect();
        if some.len() < all.len() && is_scan(&some, APART * instrument.standard_uncertainty_at_mm(middle(&some))) {
            continue;
        }
        let middle = middle(&all);
        let u_mm = instrument.standard_uncertainty_at_mm(middle);
        let off = |p: &&&Point| norm(minus(p.xyz_mm, middle)) > APART * u_mm;
        let away: Vec<&&Point> = all.iter().filter(off).collect();
        let Some(worst) = away.iter().map(|p| norm(minus(p.xyz_mm, middle))).reduce(f64::max) else { continue };
        let most = 2 * away.len() > all.len();
        if most && worst > SEVERAL_MM {
            continue;
        }
        let (count, off_mm) = (all.len(), worst);
        let message = match most {
            true => warning!("repeats-scatter", label, off_mm, u_mm),
            false if all.len() > 2 && worst > SPOILS * u_mm => {
                error!("repeat-off", label, count, away = away.len(), off_mm, u_mm)
            }
            false => warning!("repeat-off", label, count, away = away.len(), off_mm, u_mm),
        };
        messages.push(message.at(away[0].place()));
    }
    messages
}
