//! Everything that is wrong with a campaign, found at once and without identifying anything; what was read is kept for the run.

use super::{names, statements};
use crate::stages::frames;
use crate::stages::gather::{self, Gathered};
use crate::stages::geometric;
use crate::stages::identification::{check_selections, preview};
use crate::stages::iso9283::{self, TestData};
use crate::stages::join;
use crate::stages::kinds;
use etalon_base::message::{Problems, Result, Severity};
use etalon_base::pattern::matches_pattern;
use etalon_base::pose_name::PoseName;
use etalon_campaign::Campaign;
use etalon_documents::{ImportDocument, Presentation, SourceKind};
use etalon_formats::Point;
use etalon_report::branding;
use etalon_robots::Robot;
use std::collections::BTreeSet;

/// A campaign whose files are read, each once.
pub struct Prepared {
    /// Points, joint values, and the list of inputs, with warnings.
    pub gathered: Gathered,
    /// The robot.
    pub robot: Box<dyn Robot>,
    /// Tables and recordings of tests by ISO 9283.
    pub tests: TestData,
    /// Measurements of the geometric calibration, where the campaign has one.
    pub geometric: Option<geometric::Gathered>,
    /// Language, logo and templates of the report.
    pub presentation: Presentation,
}

/// Checks what the stages cannot: statements, files, labels, targets and names. Gives what was read, or every error.
pub fn check(campaign: &Campaign) -> Result<Prepared> {
    let Found { gathered, robot, tests, geometric, presentation, problems, .. } = find(campaign);
    problems.clone().check()?;
    match (robot, presentation) {
        (Some(robot), Some(presentation)) => Ok(Prepared { gathered, robot, tests, geometric, presentation }),
        _ => Err(problems),
    }
}

/// Checks all that can stop a run before it identifies: the list of inputs with all warnings, and every error.
///
/// A stage is tried on what is left of its input, and skipped where what it needs is wrong already.
pub fn everything(campaign: &Campaign) -> (ImportDocument, Problems) {
    let mut found = find(campaign);
    // what reads, and what has a coordinate that does not
    let reads = |p: &Point| p.xyz_mm.iter().all(|v| v.is_finite());
    let unreadable: Vec<Point> = found.gathered.points.iter().filter(|p| !reads(p)).cloned().collect();
    // what is joined has none of those
    found.gathered.points.retain(reads);
    let points = &found.gathered.points;
    let unread = &campaign.unread;
    if unread.affects(&["export"]) {
        // the unit, or the list of points, is not known
        return (found.gathered.document, found.problems);
    }
    let present = |name: &str| points.iter().any(|p| matches_pattern(name, &p.label));
    let affected = |name: &str| unreadable.iter().any(|p| matches_pattern(name, &p.label));
    // features whose points all read
    let mut whole = campaign.clone();
    whole.file.features.retain(|_, feature| {
        let labels = feature.element().map_or(&[][..], |(_, labels)| labels);
        labels.iter().all(|label| present(label.get_ref()) && !affected(label.get_ref()))
    });
    let mut world = None;
    if let Some(features) = found.problems.keep(frames::fit_features(&whole, points)) {
        found.gathered.document.messages.extend(features.messages.clone());
        if found.named && !gather::used_labels(campaign).iter().any(|name| affected(name)) {
            let planar = found.robot.as_ref().is_some_and(|r| r.dimension() == 2);
            world = found.problems.keep(frames::make_frames(campaign, points, &features, planar));
        }
    }
    if !campaign.identifies() {
        return (found.gathered.document, found.problems);
    }
    let mut poses: BTreeSet<PoseName> = points.iter().filter_map(|p| p.pose).collect();
    if let (Some(robot), true) = (&mut found.robot, found.read) {
        match world {
            None => drop(found.problems.keep(join::counts(campaign, &found.gathered, robot.as_ref()))),
            Some(world) => {
                let joined = join::joined(campaign, &found.gathered, &world, robot.as_ref());
                if let Some(joined) = found.problems.keep(joined) {
                    let shown = found.problems.keep(preview(campaign, robot.as_mut(), &joined)).unwrap_or_default();
                    let (errors, warnings): (Vec<_>, Vec<_>) =
                        shown.into_iter().partition(|message| message.severity == Severity::Error);
                    found.problems.0.extend(errors);
                    found.gathered.document.messages.extend(warnings);
                    found.gathered.document.messages.extend(joined.messages);
                    let first = joined.observations.first();
                    poses = first.and_then(|(_, first)| first.poses().ok()).unwrap_or_default();
                }
            }
        }
    }
    // a join by time may find no pose before the log is read
    if !unread.affects(&["identify"]) && (found.read || !poses.is_empty()) {
        found.problems.keep(check_selections(campaign, &poses));
    }
    (found.gathered.document, found.problems)
}

struct Found {
    gathered: Gathered,
    robot: Option<Box<dyn Robot>>,
    tests: TestData,
    geometric: Option<geometric::Gathered>,
    presentation: Option<Presentation>,
    problems: Problems,
    /// all files read
    read: bool,
    /// features and frames are stated, and every label that they name is present
    named: bool,
}

fn find(campaign: &Campaign) -> Found {
    let mut problems = Problems::default();
    statements::check(campaign, &mut problems);
    statements::values(campaign, &mut problems);
    statements::conditions(campaign, &mut problems);
    let presentation = problems.keep(presentation(campaign));
    let before = problems.0.len();
    statements::frames(campaign, &mut problems);
    let (gathered, more) = gather::recover(campaign);
    let whole = |keys: &[&str]| !keys.iter().any(|key| campaign.unread.affects(&[key]));
    let mut read = more.0.is_empty() && whole(&["export", "log", "join"]);
    // a label that is missing may be in a file that did not read
    let opened = gathered.document.sources.iter().filter(|s| s.kind == SourceKind::Export && s.rows_read > 0).count();
    let complete = opened == campaign.file.exports.len();
    names::labels(campaign, &gathered, complete, &mut problems);
    let named = complete && problems.0.len() == before && whole(&["feature", "frame"]);
    let mut geometric = None;
    if let (Some(definition), true, true) = (&campaign.file.geometric, named && whole(&["geometric"]), read) {
        geometric = problems.keep(geometric::gather(campaign, definition, &gathered.points));
    }
    let (tests, wrong) = iso9283::read(campaign);
    if named && whole(&["repeatability"]) && read {
        problems.0.extend(iso9283::label_problems(campaign, &tests, &gathered).0);
    }
    problems.0.extend(more.0);
    problems.0.extend(wrong.0);
    let targets = gathered.observations.as_ref().map(|t| kinds::targets(&t.table).map_err(|more| t.place(more)));
    let targets = targets.and_then(|targets| problems.keep(targets)).unwrap_or_default();
    let robot = problems.keep(campaign.build_robot_with(&targets));
    if let Some(robot) = &robot {
        names::robot(campaign, robot.as_ref(), &mut problems);
        let before = problems.0.len();
        names::logs(campaign, robot.as_ref(), &mut problems);
        if complete && whole(&["join"]) && campaign.identifies() && campaign.file.observations.is_none() {
            names::targets(campaign, robot.as_ref(), &gathered, &mut problems);
        }
        // without its joints a log cannot be joined, nor can points without their targets
        read &= problems.0.len() == before;
    }
    Found { gathered, robot, tests, geometric, presentation, problems, read, named }
}

/// Language, logo and templates of the report, read and checked.
pub fn presentation(campaign: &Campaign) -> Result<Presentation> {
    let stated = &campaign.file.report;
    let mut presentation = Presentation { language: stated.language, ..Presentation::default() };
    if let Some(file) = &stated.logo {
        let logo = branding::logo(&campaign.resolve(file)?);
        presentation.logo = Some(logo.map_err(|more| more.at(&campaign.place(file)))?);
    }
    if let Some(folder) = &stated.templates {
        let read = branding::templates(&campaign.resolve(folder)?);
        presentation.templates = read.map_err(|more| more.at(&campaign.place(folder)))?;
    }
    etalon_report::check_templates(&presentation)?;
    Ok(presentation)
}
