//! Proposal for several files: the use of each file, and how the files are joined.

mod choice;
mod join;
mod keys;
mod names;
mod part;
mod poses;
mod tested;

pub(super) use choice::best_join;
pub(super) use keys::Keys;
pub(super) use part::Part;

use super::against::Remarks;
use super::motion::Meeting;
use super::sheets;
use super::statements::{Line, Lines, Section};
use etalon_base::message::Result;
use etalon_base::phrase;
use etalon_documents::FormatsDocument;
use etalon_robots::Robot;
pub use join::world_lines;
use join::{join_by_clock, join_by_keys, meeting};
use keys::Join;
use names::{Named, leave_stationary};
use part::seconds_per;
use poses::{TABLES_OF_POSES, poses};
use std::path::{Path, PathBuf};
use tested::by_robot;

/// Proposal for several files.
#[derive(Debug)]
pub struct FilesProposal {
    /// Proposal for each file.
    pub documents: Vec<FormatsDocument>,
    /// Lines of all files for campaign.toml.
    pub toml: String,
    /// Names of joints that do not move in the logs.
    pub still: Vec<String>,
}

/// Proposes uses of several files that belong to one campaign, and how they are joined.
///
/// # Errors
/// Fails if a file is missing, or is not a table.
pub fn propose_files(paths: &[PathBuf], robot: Option<&dyn Robot>) -> Result<FilesProposal> {
    let mut parts = Part::all(paths, robot)?;
    take_as_exports(&mut parts)?;
    compare_clocks(&mut parts);
    let exports: Vec<usize> = (0..parts.len()).filter(|i| parts[*i].document.kind == "export").collect();
    let (log, order) = ordered(robot, &mut parts, &exports);
    let mut found = Vec::new();
    for &at in &exports {
        let keys = Keys::new(&parts[at]);
        let join = log.and_then(|log| best_join(robot, &parts[at], &keys, &parts[log]));
        if let (Some(log), Some(robot), Some(join)) = (log, robot, &join) {
            by_robot(robot, &mut parts, at, log, join)?;
        }
        found.push((at, keys, join));
    }
    leave_stationary(&mut parts, &mut found)?;
    let Named { targets, stationary, joined } = Named::new(&mut parts, found);
    // a recorded table may have poses that join it; a recording of messages has times alone
    let timed = log.filter(|log| joined.is_empty() || parts[*log].is_recording_of_messages());
    let meeting = timed.and_then(|log| meeting(&parts, &exports, log, targets.len()));
    let by_time = meeting.is_some() || joined.iter().any(|(_, join)| join.by == "time");
    if !by_time && !exports.is_empty() {
        parts.iter_mut().filter(|part| part.document.kind == "log").for_each(Part::leave_clock);
    }
    let tail = match log {
        Some(log) if !exports.is_empty() => {
            let by_clock = meeting.as_ref().and_then(|meeting| join_by_clock(meeting, &mut parts, log, &targets));
            let standstills = if let Some(Meeting::Open { standstills }) = meeting { Some(standstills) } else { None };
            let join = by_clock.unwrap_or_else(|| join_by_keys(&mut parts, log, &joined, &targets, standstills));
            Lines(vec![Line::Blank]).followed_by(join).with_text(world_lines(robot, &stationary))
        }
        _ => Lines::default(),
    };
    let tests = poses(&mut parts);
    if let (Some(log), Some((_, Join { names_poses: true, .. }))) = (log, joined.first()) {
        let first = parts[log].lines.columns_mut().filter_map(|columns| columns.first_mut());
        first.filter(|(key, _)| key == "label").for_each(|(key, _)| *key = "pose".to_owned());
    }
    name_sections(&mut parts);
    let is_stated = |part: &&Part| tests.is_none() || !TABLES_OF_POSES.contains(&part.document.kind.as_str());
    let sections = order.iter().map(|at| &parts[*at]).filter(is_stated).map(|part| &part.lines).chain(&tests);
    let mut lines = Lines(parts.iter().map(|part| Line::Remark(part.summary())).collect());
    sections.for_each(|section| lines.0.extend(std::iter::once(&Line::Blank).chain(&section.0).cloned()));
    let toml = lines.followed_by(tail).to_string();
    let still = parts.iter().filter_map(Part::motion).flat_map(|motion| motion.still()).collect();
    Ok(FilesProposal { still, documents: parts.into_iter().map(Part::printed).collect(), toml })
}

/// `true` for a workbook with several sheets that contain a table.
pub fn has_several_tables(path: &Path) -> bool {
    sheets(path).len() > 1 && Part::all(&[path.to_owned()], None).is_ok_and(|parts| parts.len() > 1)
}

/// Takes points beside a log for an export: without a log they would be a recorded motion, or poses
/// of a test.
fn take_as_exports(parts: &mut [Part]) -> Result<()> {
    let has = |kind: &str| parts.iter().any(|part| part.document.kind == kind);
    if !has("log") || has("poses") && has("commanded") {
        return Ok(());
    }
    for part in parts.iter_mut().filter(|part| ["recording", "poses", "commanded"].contains(&&*part.document.kind)) {
        part.is_beside_log = true;
        part.again(&mut |_, _| Remarks::default())?;
    }
    Ok(())
}

/// Settles the unit of a clock that no heading gives by the duration of another file whose times
/// have a unit.
fn compare_clocks(parts: &mut [Part]) {
    let open = |part: &Part| part.read.as_ref().is_some_and(|(_, found)| found.clock.question.is_some());
    let duration = |times: &[f64]| Some(times.last()? - times.first()?).filter(|span| *span > 0.0);
    let known = |part: &Part| match &part.motion {
        Some(motion) => duration(motion.times_s()),
        None => duration(&part.times_s().filter(|_| !open(part))?),
    };
    let Some(known_s) = parts.iter().find_map(known) else { return };
    for part in parts.iter_mut().filter(|part| open(part)) {
        let Some(span) = part.times_s().and_then(|times| duration(&times)) else { continue };
        let fits = |unit: &&str| (0.1..10.0).contains(&(span * seconds_per(Some(unit)) / known_s));
        part.clock = ["s", "ms", "us", "ns"].into_iter().find(|unit| fits(unit));
        part.state_clock();
    }
}

/// Returns the log that is joined, and the order of the files in the proposal: of several logs,
/// the log that has a row for the most points is the first.
fn ordered(robot: Option<&dyn Robot>, parts: &mut [Part], exports: &[usize]) -> (Option<usize>, Vec<usize>) {
    let mut order: Vec<usize> = (0..parts.len()).collect();
    let logs: Vec<usize> = (0..parts.len()).filter(|i| parts[*i].document.kind == "log").collect();
    let matching = |log: usize| {
        let join = |at: &usize| best_join(robot, &parts[*at], &Keys::new(&parts[*at]), &parts[log]);
        exports.iter().filter_map(join).map(|join| join.matching).sum::<usize>()
    };
    let best = logs.iter().copied().reduce(|best, log| if matching(log) > matching(best) { log } else { best });
    if let (Some(first), Some(best), true) = (logs.first(), best, logs.len() > 1) {
        order.swap(*first, best);
        let file = parts[best].document.file.clone();
        parts[best].doubt(phrase!("doubt-several-logs", first = file, count = logs.len()));
    }
    (best, order)
}

/// Writes repeated sections as elements of a list; each log gets a name.
fn name_sections(parts: &mut [Part]) {
    for kind in ["log", "observations"] {
        let of_kind = parts.iter_mut().filter(|part| part.document.kind == kind);
        let mut several: Vec<(String, &mut Section)> =
            of_kind.filter_map(|part| Some((part.stem(), part.lines.section_mut(kind)?))).collect();
        if several.len() < 2 {
            continue;
        }
        for (number, (stem, section)) in (1..).zip(&mut several) {
            stem.retain(|c| c.is_ascii());
            section.is_listed = true;
            section.title = (kind == "log").then(|| format!("{stem}_{number}"));
        }
    }
}
