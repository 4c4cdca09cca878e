//! Everything that is wrong with a campaign, found at once and without identifying anything.

mod conditions;
mod names;
mod report;
mod statements;

pub use statements::selections;

use crate::base::message::{Problems, Result};
use crate::base::pattern::matches_pattern;
use crate::base::pose::Pose;
use crate::base::table;
use crate::campaign::Campaign;
use crate::import::Point;
use crate::math::robots::Robot;
use crate::stages::frames;
use crate::stages::gather::{self, Gathered};
use crate::stages::geometric;
use crate::stages::iso9283::characteristics;
use crate::stages::iso9283::repeatability;
use crate::stages::join;
use std::collections::BTreeSet;

/// Checks what the stages cannot: statements, files, labels, targets and names. Gives what was imported, with warnings, or
/// every error.
pub fn check(campaign: &Campaign) -> Result<Gathered> {
    let found = find(campaign);
    found.problems.check()?;
    Ok(found.imported)
}

/// Checks all that a run would stumble over before it identifies: what was imported, with all warnings, and every error.
///
/// A stage is tried on what is left of its input; where what it needs is wrong already, it is left out.
pub fn everything(campaign: &Campaign) -> (Gathered, Problems) {
    let mut found = find(campaign);
    // what reads, and what has a coordinate that does not
    let (points, unreadable): (Vec<Point>, Vec<Point>) =
        found.imported.points.iter().cloned().partition(|p| p.xyz_mm.iter().all(|v| v.is_finite()));
    let borne = |name: &str| points.iter().any(|p| matches_pattern(name, &p.label));
    let touched = |name: &str| unreadable.iter().any(|p| matches_pattern(name, &p.label));
    // features whose points all read
    let mut whole = campaign.clone();
    whole.file.features.retain(|_, feature| {
        let labels = feature.element().map_or(&[][..], |(_, labels)| labels);
        labels.iter().all(|label| borne(label.get_ref()) && !touched(label.get_ref()))
    });
    let mut world = None;
    let unread = &campaign.unread;
    if unread.affects(&["export"]) {
        // in which unit, or which points there are, is not known
        return (found.imported, found.problems);
    }
    match frames::fit_features(&whole, &points) {
        Err(more) => found.problems.0.extend(more.0),
        Ok(features) => {
            found.imported.document.messages.extend(features.messages.clone());
            if found.named && !gather::used_labels(campaign).iter().any(|name| touched(name)) {
                let planar = found.robot.as_ref().is_some_and(|r| r.dimension() == 2);
                let made = frames::make_frames(campaign, &points, &features, planar);
                world = made.map_err(|more| found.problems.0.extend(more.0)).ok();
            }
        }
    }
    if !campaign.identifies() {
        return (found.imported, found.problems);
    }
    let mut poses: BTreeSet<i64> = points.iter().filter_map(|p| p.pose).collect();
    if let (None, Some(robot), true) = (&world, &found.robot, found.read) {
        found
            .problems
            .0
            .extend(join::counts(campaign, &found.imported, robot.as_ref()).err().into_iter().flat_map(|p| p.0));
    }
    if let (Some(world), Some(robot), true) = (world, &found.robot, found.read) {
        match join::join(campaign, &found.imported, &world, robot.as_ref()) {
            Ok(joined) => {
                found.imported.document.messages.extend(joined.messages);
                let first = joined.observations.first().and_then(|(_, table)| table::integers(table, "pose").ok());
                poses = first.into_iter().flatten().collect();
            }
            Err(more) => found.problems.0.extend(more.0),
        }
    }
    // a join by time may find no pose before the log is read
    if !unread.affects(&["identify"]) && (found.read || !poses.is_empty()) {
        found.problems.0.extend(selections(campaign, &poses).err().into_iter().flat_map(|p| p.0));
    }
    (found.imported, found.problems)
}

struct Found {
    imported: Gathered,
    problems: Problems,
    /// all files read
    read: bool,
    /// features and frames are stated, and every label they name is borne
    named: bool,
    robot: Option<Box<dyn Robot>>,
}

fn find(campaign: &Campaign) -> Found {
    let mut problems = Problems::default();
    statements::check(campaign, &mut problems);
    conditions::check(campaign, &mut problems);
    report::check(campaign, &mut problems);
    let before = problems.0.len();
    statements::frames(campaign, &mut problems);
    let (imported, more) = gather::recover(campaign);
    let unread = &campaign.unread;
    let whole = |keys: &[&str]| !keys.iter().any(|key| unread.affects(&[key]));
    let mut read = more.0.is_empty() && whole(&["export", "log", "join"]);
    // a label that nothing bears may be borne by a file that is not there
    let opened = imported.document.sources.iter().filter(|s| s.kind == "export" && s.rows_read > 0).count();
    let complete = opened == campaign.file.exports.len();
    names::labels(campaign, &imported, complete, &mut problems);
    let named = complete && problems.0.len() == before && whole(&["feature", "frame"]);
    if let (Some(definition), true, true) = (&campaign.file.geometric, named && whole(&["geometric"]), read) {
        let missing = geometric::gather(campaign, definition, &imported.points).err();
        problems.0.extend(missing.into_iter().flat_map(|p| p.0));
    }
    if let Some(definition) = &campaign.file.repeatability {
        problems.0.extend(match named && whole(&["repeatability"]) && read {
            true => {
                repeatability::gather(campaign, definition, &imported.points, &Pose::identity())
                    .err()
                    .unwrap_or_default()
                    .0
            }
            false => repeatability::commanded_problems(campaign, definition).0,
        });
    }
    problems.0.extend(more.0);
    problems.0.extend(characteristics::problems(campaign).0);
    let robot = campaign.build_robot().map_err(|more| problems.0.extend(more.0)).ok();
    if let Some(robot) = &robot {
        names::robot(campaign, robot.as_ref(), &mut problems);
        let before = problems.0.len();
        names::logs(campaign, robot.as_ref(), &mut problems);
        if complete && whole(&["join"]) && campaign.identifies() {
            names::targets(campaign, robot.as_ref(), &imported, &mut problems);
        }
        // without its joints a log cannot be joined, nor can points without their targets
        read &= problems.0.len() == before;
    }
    Found { imported, problems, read, named, robot }
}
