//! What repeats and should not: readings and joint values that stayed where they were, and repeats of a fixed point that disagree.

use etalon_base::message::{Message, Place, count};
use etalon_base::pattern::matches_pattern;
use etalon_base::pose::{Vector, minus, norm};
use etalon_campaign::Campaign;
use etalon_formats::Point;
use etalon_identify::Observation;
use etalon_math::statistics::middle_pair;
use etalon_robots::Robot;
use std::collections::BTreeMap;

/// Two readings are of two poses where the nominal robot moves its target by this or more between them, mm.
const MOVED_MM: f64 = 1.0;
/// Repeats of a point that are further apart than this many standard uncertainties of a coordinate are not of one point: in three
/// coordinates the instrument does that fewer than once in ten thousand times.
const APART: f64 = 5.0;
/// A repeat further from the others than this many standard uncertainties spoils the frame: what follows would be wrong by many of its
/// own.
const SPOILS: f64 = 20.0;
/// Where most points of a label lie apart by more than this, they are several points by design, mm.
const SEVERAL_MM: f64 = 1.0;
/// Pairs, or repeats, that are named.
const NAMED: usize = 5;

/// Warnings about measured positions, or joint values, that are the same to the last digit at poses where the others are not: what
/// was read there is that of another pose.
pub fn stale(robot: &dyn Robot, observations: &[Observation]) -> Vec<Message> {
    let nominal = robot.nominal();
    let mut at_place: BTreeMap<(usize, [u64; 3]), Vec<&Observation>> = BTreeMap::new();
    let mut at_joints: BTreeMap<Vec<u64>, Vec<&Observation>> = BTreeMap::new();
    for o in observations {
        at_joints.entry(o.joints.iter().map(|q| q.to_bits()).collect()).or_default().push(o);
        for (k, measured) in o.targets.iter().enumerate() {
            let Some(measured) = measured else { continue };
            at_place.entry((k, measured.map(f64::to_bits))).or_default().push(o);
        }
    }
    let places = at_place.len();
    let repeated: Vec<_> = at_place.into_iter().filter(|(_, all)| all.iter().any(|o| o.pose != all[0].pose)).collect();
    let mut points = Vec::new();
    // balls that are touched in several working modes are measured once, by design
    if 2 * repeated.len() < places {
        for ((k, _), all) in repeated {
            let moved = |o: &&&Observation| {
                let shift = minus(robot.position(&nominal, &o.joints, k), robot.position(&nominal, &all[0].joints, k));
                o.pose != all[0].pose && norm(shift) > MOVED_MM
            };
            points.extend(
                all.iter()
                    .filter(moved)
                    .map(|o| format!("{} at poses {} and {}", robot.targets()[k], all[0].pose, o.pose)),
            );
        }
    }
    let apart = |a: &Observation, b: &Observation| {
        let both = a.targets.iter().zip(&b.targets);
        both.filter_map(|(a, b)| Some(norm(minus((*a)?, (*b)?)))).fold(0.0, f64::max)
    };
    let logs: Vec<String> = at_joints
        .values()
        .flat_map(|all| {
            all.iter().filter(|o| o.pose != all[0].pose && apart(o, all[0]) > MOVED_MM).map(|o| (all[0], *o))
        })
        .map(|(a, b)| format!("poses {} and {}, {:.3} mm apart", a.pose, b.pose, apart(a, b)))
        .collect();
    let mut messages = Vec::new();
    for (all, what, hint) in [
        (
            points,
            "measured positions repeat to the last digit while the joints move",
            "the export has a reading of another pose: measure these again, or leave them out",
        ),
        (
            logs,
            "joint values repeat to the last digit while the targets move",
            "the log has a reading of another pose: log these again, or leave them out",
        ),
    ] {
        if !all.is_empty() {
            let more = if all.len() > NAMED { ", ..." } else { "" };
            let named = all[..all.len().min(NAMED)].join("; ");
            messages.push(Message::warning(format!("{what}, {}: {named}{more}", count(all.len(), "time"))).hint(hint));
        }
    }
    messages
}

/// Messages about points of the same label whose repeats are further apart than the instrument explains, for the labels of features
/// and frames; `names` are those labels. An error where one repeat spoils what is made from them.
pub fn fixed_points(campaign: &Campaign, points: &[Point], names: &[&str]) -> Vec<Message> {
    let instrument = &campaign.file.instrument;
    let mut repeats: BTreeMap<&str, Vec<&Point>> = BTreeMap::new();
    for point in points.iter().filter(|p| p.pose.is_none() && names.iter().any(|name| matches_pattern(name, &p.label)))
    {
        repeats.entry(&point.label).or_default().push(point);
    }
    let mut messages = Vec::new();
    for (label, all) in repeats {
        let places: Vec<Vector> = all.iter().map(|p| p.xyz_mm).collect();
        let middle =
            [0, 1, 2].map(|i| middle_pair(places.iter().map(|p| p[i])).map_or(0.0, |[low, high]| 0.5 * (low + high)));
        let u_mm = instrument.standard_uncertainty_at_mm(middle);
        let off = |p: &&&Point| norm(minus(p.xyz_mm, middle)) > APART * u_mm;
        let away: Vec<&&Point> = all.iter().filter(off).collect();
        let Some(worst) = away.iter().map(|p| norm(minus(p.xyz_mm, middle))).reduce(f64::max) else { continue };
        let instrument = format!("the instrument's standard uncertainty is {u_mm:.4} mm");
        let most = 2 * away.len() > all.len();
        if most && worst > SEVERAL_MM {
            continue;
        }
        let (what, hint) = if most {
            (
                format!("repeats of `{label}` lie up to {worst:.4} mm from their median: {instrument}"),
                "check `unit` of the export and the instrument's uncertainty, and that the point did not move",
            )
        } else {
            let which = if away.len() == 1 { "one lies".to_owned() } else { format!("{} lie up to", away.len()) };
            (
                format!(
                    "of {} of `{label}` {which} {worst:.4} mm from their median: {instrument}",
                    count(all.len(), "repeat")
                ),
                "remove the wrong reading from the export, or measure the point again: every result depends on it",
            )
        };
        let spoilt = !most && all.len() > 2 && worst > SPOILS * u_mm;
        let message = if spoilt { Message::error(what) } else { Message::warning(what) };
        let message = message.at(Place::line(&*away[0].export, away[0].line, &away[0].text));
        messages.push(message.hint(hint));
    }
    messages
}
