//! Other identifications of an open campaign: with other data, parameters or limits, and the text
//! of campaign.toml that gives them.

use crate::session::opened::{Opened, parameters};
use crate::session::scene::UM;
use crate::session::visits::Visit;
use crate::session::words;
use crate::stages::calibrate::identification::Unjudged;
use crate::stages::remedies::remedied;
use etalon_base::error;
use etalon_base::files::{self, Stamp};
use etalon_base::message::Result;
use etalon_base::pose::{minus, norm};
use etalon_base::pose_name::PoseName;
use etalon_campaign::{Campaign, Changes, Exclude, StatedPoses};
use etalon_documents::warning_messages;
use etalon_robots::Robot;
use etalon_view::{Changed, Maximum, Parameter, PointNow, WhatIf, WhatIfAsked};
use std::collections::BTreeMap;
use std::time::Instant;

/// Change of a parameter (standard uncertainties of the change) from which on it is named.
const NAMED: f64 = 2.0;

/// Reason of exclusions that are not written.
const UNREASONED: &str = "-";

/// Share of a variance below which a difference of variances is rounding.
const ROUNDING: f64 = 1e-4;

/// The campaign with the requested changes.
///
/// # Errors
/// Fails for unknown poses, targets and parameters, and if the text cannot be changed.
fn changed(opened: &Opened, text: &str, asked: &WhatIfAsked, reason: &str) -> Result<Campaign> {
    let text = changes(opened, asked, reason)?.apply(text)?;
    let stamp = Stamp::new(text.as_bytes());
    let (campaign, problems) = Campaign::recover_text(opened.campaign.location.clone(), text, stamp)?;
    campaign.filter(|_| problems.0.is_empty()).ok_or(problems)
}

/// The changes of the campaign that are asked for.
fn changes(opened: &Opened, asked: &WhatIfAsked, reason: &str) -> Result<Changes> {
    let robot = opened.robot.as_ref();
    let known = |names: &[String]| -> Result<()> {
        let all = || robot.parameters().iter().map(|p| p.name.clone());
        match names.iter().find(|name| all().all(|known| known != **name)) {
            Some(name) => {
                let (pattern, names) = (name.clone(), all().collect());
                Err(remedied(etalon_identify::Error::UnknownParameter { pattern, names }))
            }
            None => Ok(()),
        }
    };
    known(&asked.hold)?;
    known(&asked.free)?;
    let mut exclude = excluded_poses(opened, &asked.leave_out_poses, reason)?;
    for name in &asked.leave_out_targets {
        let target = robot.targets().iter().position(|target| target == name);
        let Some(target) = target else {
            let names = robot.targets().iter().map(String::as_str);
            return Err(error!("not-of-this-robot", name, kind = "target").hint_names(name, names).into());
        };
        let shows = opened.observations.iter().filter(|o| o.targets.get(target).is_some_and(Option::is_some));
        exclude.push(Exclude {
            poses: Some(ranges(shows.map(|o| o.pose))),
            target: Some(name.clone()),
            reason: reason.to_owned(),
            ..Exclude::default()
        });
    }
    let position_max_mm = asked.limit_um.map(|um| um / UM);
    let (calibration, validation) = (asked.calibration.clone(), asked.validation.clone());
    let (hold, free) = (asked.hold.clone(), asked.free.clone());
    Ok(Changes { exclude, hold, free, position_max_mm, calibration, validation })
}

/// Rules that exclude visits: one for whole poses, and one for each cycle.
fn excluded_poses(opened: &Opened, ids: &[String], reason: &str) -> Result<Vec<Exclude>> {
    let several = Visit::have_cycles(&opened.visits);
    let mut by_cycle: BTreeMap<Option<i64>, Vec<PoseName>> = BTreeMap::new();
    for id in ids {
        let visit = opened.visits.iter().find(|visit| visit.id(several) == *id);
        let Some(visit) = visit else { return Err(error!("view-pose-unknown", name = id).into()) };
        by_cycle.entry(several.then_some(visit.cycle)).or_default().push(visit.pose);
    }
    let rule = |(cycle, poses): (Option<i64>, Vec<PoseName>)| Exclude {
        poses: Some(ranges(poses)),
        cycle,
        reason: reason.to_owned(),
        ..Exclude::default()
    };
    Ok(by_cycle.into_iter().map(rule).collect())
}

/// Names of poses, in order and each once.
fn ranges(poses: impl IntoIterator<Item = PoseName>) -> StatedPoses {
    let mut all: Vec<PoseName> = poses.into_iter().collect();
    all.sort_unstable();
    all.dedup();
    StatedPoses::List(all)
}

/// The campaign without these visits.
///
/// # Errors
/// Fails if the text cannot be changed.
pub(super) fn without_visits(opened: &Opened, visits: &[Visit]) -> Result<Campaign> {
    let several = Visit::have_cycles(&opened.visits);
    let leave_out_poses = visits.iter().map(|visit| visit.id(several)).collect();
    changed(opened, &opened.campaign.text, &WhatIfAsked { leave_out_poses, ..WhatIfAsked::default() }, UNREASONED)
}

/// Identifies again as asked for, and compares with the first result.
///
/// # Errors
/// Fails like a run of the campaign that gives the changes.
pub(super) fn what_if(opened: &Opened, asked: &WhatIfAsked, language: &str) -> Result<WhatIf> {
    let begun = Instant::now();
    let campaign = changed(opened, &opened.campaign.text, asked, UNREASONED)?;
    let (robot, found) = opened.again(&campaign)?;
    let (first, (now, uncertainty)) = (Opened::largest_um(&opened.found).0, Opened::largest_um(&found));
    let parameters = parameters(robot.as_ref(), &found.solution.found, language);
    let changed = differences(&opened.parameters(language), &parameters);
    let messages = [warning_messages(&found.solution.found.warnings), found.messages.clone()].concat();
    Ok(WhatIf {
        verdict: Some(words::limits(&found.accuracy, language)),
        points: points(opened, robot.as_ref(), &found),
        maximum_um: Maximum { first, now, uncertainty },
        messages: words::shown(&messages, language),
        parameters,
        changed,
        seconds: begun.elapsed().as_secs_f64(),
    })
}

/// Errors of all measured places, including held-out ones.
fn points(opened: &Opened, robot: &dyn Robot, found: &Unjudged) -> Vec<PointNow> {
    let values = &found.solution.found.values;
    let mut all = Vec::new();
    for (pose, observation) in opened.observations.iter().enumerate() {
        let measured = observation.targets.iter().enumerate().filter_map(|(k, at)| Some((k, (*at)?)));
        for (k, at) in measured {
            let after = minus(at, robot.position(values, &observation.joints, k)).map(|mm| mm * UM);
            if after.iter().all(|v| v.is_finite()) {
                let target = robot.targets()[k].clone();
                all.push(PointNow { pose, target, after, magnitude_after_um: norm(after) });
            }
        }
    }
    all
}

/// Parameters that changed beyond the uncertainty of the change. If one result uses a part of the
/// data or of the parameters of another, the variance of their difference is the difference of
/// their variances (Hausman 1978).
fn differences(first: &[Parameter], now: &[Parameter]) -> Vec<Changed> {
    let change = |(first, now): (&Parameter, &Parameter)| {
        let by = now.identified - first.identified;
        let [u, other] = [first.uncertainty.unwrap_or(0.0), now.uncertainty.unwrap_or(0.0)].map(|u| u * u);
        let least = ROUNDING * u.max(other);
        let in_u = by.abs() / (u - other).abs().max(least).sqrt();
        (in_u.is_finite() && in_u > NAMED).then(|| Changed { name: now.name.clone(), by, in_u })
    };
    let paired = first.iter().filter_map(|p| Some((p, now.iter().find(|other| other.name == p.name)?)));
    let mut all: Vec<Changed> = paired.filter_map(change).collect();
    all.sort_by(|a, b| b.in_u.total_cmp(&a.in_u));
    all
}

/// Writes the requested changes into campaign.toml, and returns the difference of the text.
///
/// # Errors
/// Fails without a reason, if nothing is asked for, and like [`what_if`].
pub(super) fn keep(opened: &Opened, asked: &WhatIfAsked, reason: &str) -> Result<String> {
    if *asked == WhatIfAsked::default() {
        return Err(error!("view-nothing-asked").into());
    }
    if reason.trim().is_empty() {
        return Err(error!("view-reason-missing").into());
    }
    // what somebody wrote into the file meanwhile stays
    let before = files::read_text(&opened.campaign.location)?;
    let after = changed(opened, &before, asked, reason.trim())?;
    opened.again(&after)?;
    files::write(&opened.campaign.location, after.text.as_bytes())?;
    Ok(difference(&before, &after.text))
}

/// Difference of two texts of campaign.toml (unified format of diff).
pub(super) fn difference(before: &str, after: &str) -> String {
    let lines = similar::TextDiff::from_lines(before, after);
    lines.unified_diff().context_radius(2).header("campaign.toml", "campaign.toml").to_string()
}
