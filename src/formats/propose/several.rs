//! Proposal for several files: the use of each file, and how the files are joined.

use super::against::{Remarks, described, name_joints};
use super::kinematics::{Outcome, Sample, test};
use super::labels::{ALONE, FEWER, Labels, MOST_TARGETS, NUMBER, are_numbers};
use super::meaning::{Interpretation, Meaning, PointSet};
use super::motion::{Meeting, Motion};
use super::table::{Column, Table};
use super::{FormatsDocument, against, files_beside, propose_corrected, recording, sheets, turned};
use crate::dialect::quoted;
use crate::export::Pattern;
use crate::exports::stamp_seconds;
use crate::input::read_bytes;
use etalon_base::catalogue::Phrase;
use etalon_base::message::{Result, printable};
use etalon_base::phrase;
use etalon_base::worded::Worded;
use etalon_documents::FormatsJoin;
use etalon_robots::Robot;
use etalon_tables::{Delimiter, Header};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Remark on an export of points that do not move with the robot.
const STATIONARY_LINE: &str = "# stationary points: the labels name no pose, and no row of the log belongs to them\n";
/// Line of a proposal for labels.
pub(super) const LABEL_LINE: &str =
    "label = \"{target}_{pose}_{cycle}\"   # how a label names target, pose and repeat, if it does\n";
/// Line of a proposal for labels of rows with several targets.
pub(super) const POSE_LABEL_LINE: &str =
    "label = \"{pose}\"              # each row has several targets: its label is the name of a pose\n";
/// Line of a proposal for the target of all rows.
pub(super) const TARGET_LINE: &str = "target = \"?\"               # which target the rows are of\n";

/// Line of a proposal for poses that are the rows of the file.
pub(super) const POSE_LINE: &str =
    "pose = \"row\"               # if the number of the row is the number of the pose\n";

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

/// A file with its proposal and, of a table, its interpretation.
pub(super) struct Part {
    path: PathBuf,
    /// Sheet of a workbook with several tables.
    sheet: Option<String>,
    pub document: FormatsDocument,
    pub read: Option<(Table, Interpretation)>,
    /// Motion of a recording of messages.
    motion: Option<Motion>,
    /// Unit of the times, if the duration of another file shows it.
    clock: Option<&'static str>,
    /// `true` if the points are measured because a log of joints stands beside them.
    is_beside_log: bool,
}

/// Minimum number of rows of a recorded motion per measured point.
const MORE: usize = 5;

/// Keys of the rows of a file by which it can be joined.
#[derive(Default)]
pub(super) struct Keys {
    rows: usize,
    poses: Option<Vec<String>>,
    /// `true` if the poses are the numbers of the rows.
    by_row: bool,
    cycles: Option<Vec<String>>,
    labels: Option<Vec<String>>,
    times: Option<Vec<f64>>,
    /// Form of the labels, and the targets that the labels name.
    form: Option<(String, Vec<String>)>,
    /// Labels of stationary points among the labels of targets.
    still: Vec<String>,
}

/// Join of an export with a log.
pub(super) struct Join {
    pub by: &'static str,
    /// Number of rows of the export with a key, and of those with a row of the log.
    pub keys: usize,
    pub matching: usize,
    /// Rows of export and log that belong together.
    pub pairs: Vec<(usize, usize)>,
    /// Form of the labels whose `{pose}` is the label of the log.
    form: Option<String>,
    /// `true` if the labels of the log are names of poses.
    names_poses: bool,
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
    let timed = log.filter(|log| joined.is_empty() || is_recording_of_messages(&parts[*log]));
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
            join + &world_lines(robot, &stationary)
        }
        _ => String::new(),
    };
    let tests = poses(&mut parts);
    if let (Some(log), Some((_, Join { names_poses: true, .. }))) = (log, joined.first()) {
        let toml = &mut parts[log].document.toml;
        *toml = toml.replace("columns = { label = ", "columns = { pose = ");
    }
    name_sections(&mut parts);
    let mut toml = String::new();
    for part in &parts {
        let _ = writeln!(toml, "# {}", printable(&part.summary()));
    }
    let in_order = order.iter().map(|at| &parts[*at]);
    for part in in_order.filter(|part| tests.is_none() || !TABLES_OF_POSES.contains(&part.document.kind.as_str())) {
        let _ = write!(toml, "\n{}", part.document.toml);
    }
    toml += &tests.unwrap_or_default();
    toml += &tail;
    let still = parts.iter().filter_map(Part::motion).flat_map(|motion| motion.still()).collect();
    Ok(FilesProposal { still, documents: parts.into_iter().map(|part| part.document).collect(), toml })
}

/// `true` for a workbook with several sheets that contain a table.
pub fn has_several_tables(path: &Path) -> bool {
    sheets(path).len() > 1 && Part::all(&[path.to_owned()], None).is_ok_and(|parts| parts.len() > 1)
}

/// Leaves out a sheet whose rows of numbers are all in the other sheets of the workbook, with a
/// doubt.
fn without_summary(mut sheets: Vec<Part>) -> Vec<Part> {
    let rows = |part: &Part| -> BTreeSet<Vec<u64>> {
        let Some((table, _)) = &part.read else { return BTreeSet::new() };
        let numbers = |row: usize| {
            let values = table.columns.iter().filter_map(|column| column.values.get(row).copied());
            values.filter(|value| value.is_finite()).map(f64::to_bits).collect::<Vec<u64>>()
        };
        (0..table.rows).map(numbers).filter(|numbers| numbers.len() > 1).collect()
    };
    let all: Vec<BTreeSet<Vec<u64>>> = sheets.iter().map(rows).collect();
    let is_summary = |at: &usize| {
        let others = || all.iter().enumerate().filter(|(other, _)| other != at).map(|(_, rows)| rows);
        let is_largest = others().all(|rows| rows.len() < all[*at].len());
        let is_elsewhere = |row: &Vec<u64>| others().any(|rows| rows.contains(row));
        is_largest && others().filter(|rows| !rows.is_empty()).count() > 1 && all[*at].iter().all(is_elsewhere)
    };
    if let Some(at) = (0..all.len()).find(is_summary) {
        let sheet = sheets.remove(at).sheet.unwrap_or_default();
        sheets[0].doubt(phrase!("doubt-summary", sheet));
    }
    sheets
}

/// `true` for two paths to one file of a folder, whose name may be spelled in capitals.
fn are_one(path: &Path, other: &Path) -> bool {
    let names = path.file_name().zip(other.file_name());
    path.parent() == other.parent() && names.is_some_and(|(name, other)| name.eq_ignore_ascii_case(other))
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

/// Names of the targets and of the stationary points, and the joins of the exports.
#[derive(Default)]
struct Named {
    targets: Vec<String>,
    stationary: Vec<String>,
    joined: Vec<(usize, Join)>,
}

impl Named {
    /// Names the targets of all exports, each with its keys and its join with the log.
    fn new(parts: &mut [Part], found: Vec<(usize, Keys, Option<Join>)>) -> Self {
        let mut named = Self::default();
        let is_joined = found.iter().any(|(.., join)| join.is_some());
        for (at, keys, join) in found {
            match (&join, keys.stationary()) {
                (None, Some(names)) if is_joined => {
                    let toml = &mut parts[at].document.toml;
                    *toml = toml.replace(LABEL_LINE, STATIONARY_LINE);
                    named.stationary.extend(names.iter().cloned());
                }
                _ => {
                    named.stationary.extend(keys.still.iter().cloned());
                    name_targets(&mut parts[at], &keys, join.as_ref(), &mut named.targets);
                }
            }
            named.joined.extend(join.map(|join| (at, join)));
        }
        for part in parts.iter_mut().filter(|part| part.document.kind == "export with joints") {
            let keys = Keys::new(part);
            name_targets(part, &keys, None, &mut named.targets);
        }
        named
    }
}

/// Removes the join of exports with a few points whose names look like poses, if another export has
/// many more poses of other targets: balls on the floor, or on the base of a parallel robot.
fn leave_stationary(parts: &mut [Part], found: &mut [(usize, Keys, Option<Join>)]) -> Result<()> {
    let by_pose = |join: &Option<Join>| join.as_ref().is_some_and(|join| join.by != "time");
    let joined = found.iter().filter(|(.., join)| by_pose(join));
    let Some((at_most, most, moving)) = joined
        .map(|(at, keys, _)| (*at, keys.pose_count(), keys.targets().to_vec()))
        .max_by_key(|(_, count, _)| *count)
    else {
        return Ok(());
    };
    for (at, keys, join) in found.iter_mut().filter(|(at, _, join)| *at != at_most && by_pose(join)) {
        let few = keys.pose_count() * FEWER <= most && keys.rows <= 3 * MOST_TARGETS && !moving.is_empty();
        let own = keys.targets().iter().all(|target| !moving.contains(target));
        if !few || !own || keys.labels.is_none() && !parts[*at].name_by_count()? {
            continue;
        }
        (*keys, *join) = (Keys::new(&parts[*at]), None);
        let names: BTreeSet<String> = keys.labels.iter().flatten().cloned().collect();
        parts[*at].doubt(phrase!("doubt-stationary-points", count = names.len(), poses = most));
        keys.form = Some((ALONE.to_owned(), names.into_iter().collect()));
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

/// Returns the unit of times in seconds; one second for an open unit.
fn seconds_per(unit: Option<&str>) -> f64 {
    match unit {
        Some("ms") => 1e-3,
        Some("us") => 1e-6,
        Some("ns") => 1e-9,
        _ => 1.0,
    }
}

/// Kinds of tables of a test to ISO 9283.
const TABLES_OF_POSES: [&str; 3] = ["poses", "commanded", "reference"];

/// Returns one section for attained and commanded poses and reference targets; it names headings
/// that differ from etalon's own.
fn poses(parts: &mut [Part]) -> Option<String> {
    let of_kind = |parts: &[Part], kind: &str| parts.iter().position(|part| part.document.kind == kind);
    let tables = tables_of_poses(parts);
    if let Some([attained, commanded]) = tables {
        parts[commanded].document.kind = "commanded".to_owned();
        parts[attained].document.kind = "poses".to_owned();
        let document = &mut parts[commanded].document;
        let settled = document.facts.without_attained.take();
        document.doubts.retain(|doubt| settled.is_none() || doubt.phrase() != settled.as_ref());
        for at in BTreeSet::from([attained, commanded]) {
            parts[at].document.because(phrase!("because-test-of-poses"));
        }
    }
    let other = || of_kind(parts, "poses").zip(of_kind(parts, "commanded")).map(|(a, c)| [a, c]);
    let [attained, commanded] = tables.or_else(other)?;
    let file = |at: usize| quoted(&parts[at].document.file);
    let is_foreign = |at: usize| tables.is_some_and(|tables| tables.contains(&at));
    let own = |at: usize| parts[at].read.as_ref().filter(|_| is_foreign(at));
    let set = |at: usize, is_commanded: bool| {
        let (table, found) = own(at)?;
        let set = if is_commanded { found.commanded_point().or(found.points.first()) } else { found.points.first() };
        Some(table_of_poses(table, found, set?, is_commanded))
    };
    let (of_attained, of_commanded) = (set(attained, false), set(commanded, true));
    let reference = of_kind(parts, "reference").map(|at| format!("reference = {}\n", file(at))).unwrap_or_default();
    let stated = |at: usize, form: &Option<Vec<String>>| match form {
        Some(keys) => format!("{{ file = {}, {} }}", file(at), keys.join(", ")),
        None => file(at),
    };
    let section = format!(
        "\n[poses]\nattained = {}\ncommanded = {}\n{reference}",
        stated(attained, &of_attained),
        stated(commanded, &of_commanded)
    );
    let foreign: Vec<usize> = [attained, commanded].into_iter().filter(|at| own(*at).is_some()).collect();
    for at in foreign {
        parts[at].document.toml = section.trim_start().to_owned();
    }
    Some(section)
}

/// Tables without a log that are a test of poses: poses that were attained in several cycles, and
/// each of these poses once, or a table that has both in each row.
fn tables_of_poses(parts: &[Part]) -> Option<[usize; 2]> {
    if parts.iter().any(|part| !["export", "commanded", "reference"].contains(&&*part.document.kind)) {
        return None;
    }
    let poses = |part: &Part| -> Option<(Vec<String>, bool)> {
        let (table, found) = part.read.as_ref().filter(|(_, found)| found.points.len() < 2)?;
        let [Some(_), Some(_), _] = found.points.first().or(found.commanded_point())?.columns else { return None };
        Some((texts(&table.columns[found.first(Meaning::Pose)?]), found.first(Meaning::Cycle).is_some()))
    };
    let tables: Vec<(usize, Vec<String>, bool)> = parts
        .iter()
        .enumerate()
        .filter(|(_, part)| ["export", "commanded"].contains(&&*part.document.kind))
        .map(|(at, part)| poses(part).map(|(names, cycles)| (at, names, cycles)))
        .collect::<Option<_>>()?;
    let has_both = |at: usize| {
        let found = parts[at].read.as_ref().map(|(_, found)| found);
        found.is_some_and(|found| !found.points.is_empty() && found.commanded_point().is_some())
    };
    if let [(at, names, true)] = &tables[..]
        && has_both(*at)
        && names.iter().collect::<BTreeSet<&String>>().len() < names.len()
    {
        return Some([*at, *at]);
    }
    let [(a, of_a, in_cycles), (b, of_b, again)] = &tables[..] else { return None };
    let (attained, commanded, order) = match (in_cycles, again) {
        (true, false) => (of_a, of_b, [*a, *b]),
        (false, true) => (of_b, of_a, [*b, *a]),
        _ => return None,
    };
    let once: BTreeSet<&String> = commanded.iter().collect();
    let all = attained.iter().all(|pose| once.contains(pose));
    (once.len() == commanded.len() && all && attained.len() > commanded.len()).then_some(order)
}

/// Keys of a table of poses whose headings differ from etalon's own: its form and the columns of
/// its attained or commanded point.
fn table_of_poses(table: &Table, found: &Interpretation, set: &PointSet, is_commanded: bool) -> Vec<String> {
    let form = &table.form;
    let mut keys: Vec<String> = match &form.sheet {
        Some(sheet) => vec![format!("sheet = {}", quoted(sheet))],
        None => vec![
            format!("delimiter = {:?}", form.delimiter.map_or(",", Delimiter::name)),
            format!("decimal = {:?}", form.decimal().name()),
        ],
    };
    keys.extend(form.thousands.map(|mark| format!("thousands = {:?}", mark.name())));
    if let Header::Rows(rows @ 2..) = form.header() {
        keys.push(format!("header = {rows}"));
    }
    let mut columns: Vec<String> = Vec::new();
    let mut column = |name: String, at: usize| {
        let source = table.columns[at].name.as_deref().map_or_else(|| (at + 1).to_string(), quoted);
        columns.push(format!("{name} = {source}"));
    };
    for (name, meaning) in [("pose", Meaning::Pose), ("cycle", Meaning::Cycle)] {
        let of_table = found.first(meaning).filter(|_| !is_commanded || meaning == Meaning::Pose);
        of_table.into_iter().for_each(|at| column(name.to_owned(), at));
    }
    let unit = |at: usize| table.columns[at].heading.unit.unwrap_or("UNIT");
    for (axis, at) in ["x", "y", "z"].into_iter().zip(set.columns) {
        at.into_iter().for_each(|at| column(format!("{axis}_{}", unit(at)), at));
    }
    let angles = if is_commanded && found.commanded.beside.is_some() { Vec::new() } else { found.rotation_columns() };
    for (name, at) in ["a", "b", "c"].into_iter().zip(angles) {
        column(format!("{name}_{}", unit(at)), at);
    }
    keys.push(format!("columns = {{ {} }}", columns.join(", ")));
    keys
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
    for (kind, section) in [("log", "[log]\n"), ("observations", "[observations]\n")] {
        let of_kind = |part: &&mut Part| part.document.kind == kind && part.document.toml.contains(section);
        let mut several: Vec<&mut Part> = parts.iter_mut().filter(of_kind).collect();
        if several.len() < 2 {
            continue;
        }
        for (number, part) in (1..).zip(&mut several) {
            let mut stem = part.stem();
            stem.retain(|c| c.is_ascii());
            let name = if kind == "log" { format!("name = \"{stem}_{number}\"\n") } else { String::new() };
            part.document.toml = part.document.toml.replacen(section, &format!("[{}]\n{name}", section.trim_end()), 1);
        }
    }
}

/// Returns the relation of the times of the points to the recording; `None` without times.
fn meeting(parts: &[Part], exports: &[usize], log: usize, targets: usize) -> Option<Meeting> {
    let motion = parts[log].motion();
    let motion = match motion {
        Some(motion) => motion,
        // rows without some joints, of a recording that is long enough
        None if !exports.is_empty() && exports.iter().all(|at| stands(&parts[*at], &parts[log])) => {
            return Some(Meeting::Standstills { count: 0, at_least_s: 1.0 });
        }
        None => return None,
    };
    let times: Vec<Vec<f64>> = exports.iter().map(|at| parts[*at].times_s()).collect::<Option<_>>()?;
    let mut times = times.concat();
    times.sort_by(f64::total_cmp);
    let long = || exports.iter().all(|at| stands(&parts[*at], &parts[log]));
    match motion.meeting(&times, targets) {
        _ if times.is_empty() => None,
        // the campaign shows how many standstills are missing
        Meeting::Open { standstills } if long() => Some(Meeting::Standstills { count: standstills, at_least_s: 1.0 }),
        found => Some(found),
    }
}

/// `true` if the points have times and the log is a recording of a motion with many more rows.
fn stands(export: &Part, log: &Part) -> bool {
    let timed = export.read.as_ref().is_some_and(|(_, found)| {
        [Meaning::Time, Meaning::Clock, Meaning::TimeOfDay].iter().any(|time| found.first(*time).is_some())
    });
    let recorded = is_recording_of_messages(log) || Keys::new(log).times.is_some();
    timed && recorded && log.document.rows > MORE * export.document.rows
}

fn is_recording_of_messages(log: &Part) -> bool {
    matches!(log.document.format.as_deref(), Some("mcap" | "db3"))
}

/// Tests joined rows against the robot, and writes the lines of both files again.
fn by_robot(robot: &dyn Robot, parts: &mut [Part], at: usize, log: usize, join: &Join) -> Result<()> {
    let Some((columns, outcome)) = tested(robot, &parts[at], &parts[log], join) else { return Ok(()) };
    let (Outcome::Reproduced(reading) | Outcome::Ambiguous(reading, _)) = &outcome else {
        if let Outcome::Contradicted(best) = outcome {
            let known = if best.is_some() { "yes" } else { "no" };
            let points = parts[at].document.file.clone();
            let doubt = phrase!("robot-contradicts", points, known, rms_mm = best.unwrap_or(0.0));
            parts[at].doubt(doubt);
        }
        return Ok(());
    };
    let mut flanges = vec![None; parts[at].read.as_ref().map_or(0, |(table, _)| table.rows)];
    if let Some((table, _)) = &parts[log].read {
        for (row, of_log) in &join.pairs {
            flanges[*row] = turned::flange(robot, reading, &|k| table.columns[columns[k]].values[*of_log]);
        }
    }
    let by_kinematics = parts[log].read.as_ref().is_some_and(|(_, found)| found.by_kinematics);
    if !by_kinematics {
        parts[log].again(&mut |table, found| name_joints(robot, &columns, reading, table, found))?;
    }
    parts[at].again(&mut |table, found| {
        let mut remarks = Remarks::default();
        let points = found.points.first().map(|set| set.columns);
        if let Some([Some(x), Some(y), Some(z)]) = points {
            described(table, [x, y, z], reading, true, &mut remarks);
            found.by_kinematics = true;
        }
        remarks.reasons.extend(turned::order(&flanges, &reading.base_R_world, table, found));
        remarks
    })
}

/// Tests the joints of the log with the points of an export; also returns the columns of joints.
fn tested(robot: &dyn Robot, export: &Part, log: &Part, join: &Join) -> Option<(Vec<usize>, Outcome)> {
    let ((points, of_export), (joints, of_log)) = (export.read.as_ref()?, log.read.as_ref()?);
    let set = of_export.points.first()?;
    let [Some(x), Some(y), Some(z)] = set.columns else { return None };
    let targets = target_numbers(export, join);
    let outcome = |columns: &[usize], thorough: bool| {
        let values = |c: &usize| join.pairs.iter().map(|(_, l)| joints.columns[*c].values[*l]).collect();
        let sample = Sample {
            joints: columns.iter().map(values).collect(),
            stated: columns.iter().map(|c| joints.columns[*c].heading.unit).collect(),
            points: [x, y, z].map(|c| join.pairs.iter().map(|(e, _)| points.columns[c].values[*e]).collect()),
            targets: targets.clone(),
        };
        test(robot, &sample.finite(), thorough)
    };
    let lists = against::joint_lists(robot, joints, of_log);
    let fits = |columns: &&Vec<usize>| matches!(outcome(columns, false), Outcome::Reproduced(_));
    let chosen = if lists.len() > 1 { lists.iter().find(fits) } else { None };
    let columns = chosen.or(lists.first()).cloned().unwrap_or_else(|| of_log.joint_columns());
    let outcome = outcome(&columns, true);
    Some((columns, outcome))
}

/// Returns the number of the target of each pair.
fn target_numbers(export: &Part, join: &Join) -> Vec<usize> {
    let names = export.targets();
    let mut known: Vec<String> = Vec::new();
    let mut number = |(row, _): &(usize, usize)| {
        let name = names.as_ref().map_or("", |names| names[*row].as_str());
        known.iter().position(|known| known == name).unwrap_or_else(|| {
            known.push(name.to_owned());
            known.len() - 1
        })
    };
    join.pairs.iter().map(&mut number).collect()
}

/// Returns the join by which the most rows of an export have a row of the log. Where a robot is
/// given, the join must not contradict its kinematics.
pub(super) fn best_join(robot: Option<&dyn Robot>, export: &Part, keys: &Keys, log: &Part) -> Option<Join> {
    let of_log = Keys::new(log);
    let both = |a: &Option<Vec<String>>, b: &Option<Vec<String>>| {
        a.iter().zip(b).map(|(a, b)| a.iter().zip(b).map(|(a, b)| format!("{a}\u{1}{b}")).collect()).next()
    };
    let by_key = |by: &'static str, mine: &Option<Vec<String>>, of_log: &Option<Vec<String>>| {
        let (mine, of_log) = (mine.as_ref()?, of_log.as_ref()?);
        let mut at: BTreeMap<&str, usize> = BTreeMap::new();
        for (i, key) in of_log.iter().enumerate() {
            if at.insert(key, i).is_some() {
                return None; // a key of the log names one row
            }
        }
        // a stationary point has no key
        let moves = |key: &&String| !key.trim_start_matches('\u{1}').is_empty();
        let pairs: Vec<(usize, usize)> =
            mine.iter().enumerate().filter_map(|(i, key)| Some((i, *at.get(key.as_str())?))).collect();
        let keys = mine.iter().filter(moves).count();
        Some(Join { by, keys, matching: pairs.len(), pairs, form: None, names_poses: false })
    };
    // labels of the log that name poses
    let by_name = |mine: &Option<Vec<String>>, form: Option<String>| {
        Some(Join { form, names_poses: true, ..by_key("pose", mine, &of_log.labels)? })
    };
    let rest = keys.labels.as_deref().and_then(behind_common_beginning);
    let (form, rest) = rest.map(|(form, rest)| (Some(form), Some(rest))).unwrap_or_default();
    let of_form = |(form, targets): &(String, Vec<String>)| form.contains("{pose}") && targets.len() > 1;
    let several_targets = keys.form.as_ref().is_some_and(of_form);
    let named = keys.poses.clone().filter(|_| !keys.by_row);
    let row = (keys.rows == of_log.rows && keys.still.is_empty()).then(|| Join {
        by: "row",
        keys: keys.rows,
        matching: keys.rows,
        pairs: (0..keys.rows).map(|i| (i, i)).collect(),
        form: None,
        names_poses: false,
    });
    let all = [
        by_key("pose, cycle", &both(&named, &keys.cycles), &both(&of_log.poses, &of_log.cycles)),
        by_key("pose", &named, &of_log.poses),
        by_name(&named, None),
        by_key("label", &keys.labels, &of_log.labels).filter(|_| several_targets),
        by_name(&keys.labels, Some(NUMBER.to_owned())),
        by_name(&rest, form),
        by_key("pose", &keys.poses, &of_log.poses),
        row,
        by_time(keys, &of_log),
    ];
    let enough = |join: &Join| join.matching * 2 > join.keys;
    let mut usable: Vec<Join> = all.into_iter().flatten().filter(enough).collect();
    let fits = |join: &Join| {
        robot.is_none_or(|robot| {
            tested(robot, export, log, join).is_none_or(|(_, outcome)| !matches!(outcome, Outcome::Contradicted(_)))
        })
    };
    let at = usable.iter().position(fits).unwrap_or(0);
    (!usable.is_empty()).then(|| usable.swap_remove(at))
}

/// Joins each time of an export with the nearest row of the log, as far as the times overlap.
fn by_time(keys: &Keys, log: &Keys) -> Option<Join> {
    let (mine, logged) = (keys.times.as_ref()?, log.times.as_ref()?);
    let (first, last) = (logged.first()?, logged.last()?);
    let nearest = |time: f64| {
        let after = logged.partition_point(|t| *t < time).min(logged.len() - 1);
        let before = after.saturating_sub(1);
        if (logged[before] - time).abs() < (logged[after] - time).abs() { before } else { after }
    };
    let within = |(_, time): &(usize, &f64)| (*first..=*last).contains(*time);
    let pairs: Vec<(usize, usize)> = mine.iter().enumerate().filter(within).map(|(i, t)| (i, nearest(*t))).collect();
    Some(Join { by: "time", keys: mine.len(), matching: pairs.len(), pairs, form: None, names_poses: false })
}

/// Returns the labels behind a beginning that all have (`A::`), and their form (`A::{pose}`).
fn behind_common_beginning(labels: &[String]) -> Option<(String, Vec<String>)> {
    let (first, others) = labels.split_first()?;
    let common = |other: &String| first.bytes().zip(other.bytes()).take_while(|(a, b)| a == b).count();
    let length = others.iter().map(common).min()?;
    let (at, separator) = first.char_indices().rfind(|(at, c)| *at < length && !c.is_alphanumeric())?;
    let beginning = &first[..at + separator.len_utf8()];
    let rest = labels.iter().map(|label| label.strip_prefix(beginning).map(str::to_owned)).collect::<Option<_>>()?;
    Some((format!("{beginning}{{pose}}"), rest))
}

/// Writes the targets of an export, and the form of its labels.
fn name_targets(part: &mut Part, keys: &Keys, join: Option<&Join>, targets: &mut Vec<String>) {
    let mut add = |name: &str| {
        if !targets.iter().any(|known| known == name) {
            targets.push(name.to_owned());
        }
    };
    let stem = part.stem();
    let stem = if stem.is_empty() || stem == "base" { "reflector".to_owned() } else { stem };
    let toml = &mut part.document.toml;
    // each point of a row is another target
    let open = toml.matches(TARGET_LINE).count();
    for number in 1..=open {
        let name = if open == 1 { stem.clone() } else { format!("{stem}_{number}") };
        let line = format!("target = {}           # named after the file: the file names no target\n", quoted(&name));
        *toml = toml.replacen(TARGET_LINE, &line, 1);
        add(&name);
    }
    // a format of its own gives no form of its labels
    if part.document.format.is_some() && keys.labels.is_some() && join.is_some() {
        *toml += LABEL_LINE;
    }
    if let Some(form) = join.and_then(|join| join.form.as_deref()) {
        let line = format!("label = {}   # all {} labels have this form\n", quoted(form), keys.rows);
        *toml = toml.replace(POSE_LABEL_LINE, &line);
    }
    if toml.contains(LABEL_LINE) {
        let by_row = join.is_some_and(|join| join.by == "row");
        // numbers that name no row of the log are names of points
        let of_join = join.and_then(|join| join.form.as_deref());
        let form = keys.form.as_ref().filter(|(form, _)| !(by_row && form == NUMBER));
        let form = form.filter(|_| of_join.is_none());
        let stated = of_join.or(form.map(|(form, _)| form.as_str()));
        let mut line = stated
            .map(|form| match keys.still.len() {
                0 => format!("label = {}   # all {} labels have this form\n", quoted(form), keys.rows),
                still => {
                    format!("label = {}   # the form of all labels but {still}: stationary points\n", quoted(form))
                }
            })
            .unwrap_or_default();
        if by_row && stated.is_none_or(|form| !form.contains("{pose}")) {
            line += POSE_LINE;
        }
        let named = form.iter().flat_map(|(_, targets)| targets);
        let mut any = part.read.as_ref().is_some_and(|(_, found)| found.first(Meaning::Target).is_some());
        for name in named {
            add(name);
            any = true;
        }
        if !any {
            line += &format!("target = \"{stem}\"           # the labels name no target\n");
            add(&stem);
        }
        *toml = toml.replace(LABEL_LINE, &line);
    }
    for line in toml.lines().filter_map(|line| line.strip_prefix("target = \"")) {
        line.split('"').next().into_iter().filter(|name| *name != "?").for_each(&mut add);
    }
    let of_column = part.read.as_ref().filter(|(_, found)| found.first(Meaning::Target).is_some());
    if of_column.is_some() {
        part.targets().unwrap_or_default().iter().for_each(|name| add(name));
    }
}

impl Part {
    /// Reads files. Each sheet of a workbook that contains a table is a part; a file of numbers
    /// that belongs to another file is left out.
    pub fn all(paths: &[PathBuf], robot: Option<&dyn Robot>) -> Result<Vec<Self>> {
        let beside: Vec<PathBuf> = paths.iter().flat_map(|path| files_beside(path)).collect();
        let mut parts = Vec::new();
        for path in paths.iter().filter(|path| !beside.iter().any(|other| are_one(path, other))) {
            let sheets = sheets(path);
            let tables = sheets.iter().filter_map(|sheet| Self::new(path, Some(sheet), robot).ok());
            let tables: Vec<Self> = tables.filter(|part| part.document.kind != "unknown").collect();
            match tables.len() {
                0 | 1 => parts.push(Self::new(path, None, robot)?),
                _ => parts.extend(without_summary(tables)),
            }
        }
        Ok(parts)
    }

    fn new(path: &Path, sheet: Option<&str>, robot: Option<&dyn Robot>) -> Result<Self> {
        let mut read = None;
        let document = propose_corrected(
            path,
            sheet,
            robot,
            Some(&mut |table, found| {
                // joints and points in different files are tested when they are joined
                let whole = !found.points.is_empty() && !found.joint_columns().is_empty();
                // columns of joints of several branches are known by their headings alone
                let by_headings = robot.is_some_and(|robot| !robot.branches().is_empty());
                // numbers without headings may be joints and a point
                let nameless = table.columns.iter().all(|column| column.name.is_none());
                let remarks = robot
                    .filter(|_| whole || by_headings || nameless)
                    .map(|robot| against::correct(robot, table, found));
                read = Some((table.clone(), found.clone()));
                remarks.unwrap_or_default()
            }),
        )?;
        let is_recording = matches!(document.format.as_deref(), Some("mcap" | "db3"));
        let motion = is_recording.then(|| read_bytes(path).ok().and_then(|bytes| recording::motion(&bytes))).flatten();
        let sheet = sheet.map(str::to_owned);
        Ok(Self { path: path.to_owned(), sheet, document, read, motion, clock: None, is_beside_log: false })
    }

    /// Letters, digits and `_` of the name of the sheet, or of the file without its ending.
    fn stem(&self) -> String {
        let file = || Path::new(&self.document.file).file_stem().map(|stem| stem.to_string_lossy().into_owned());
        let stem = self.sheet.clone().or_else(file).unwrap_or_default();
        stem.chars().filter(|c| c.is_alphanumeric() || *c == '_').collect()
    }

    /// Returns the motion of a log with times.
    fn motion(&self) -> Option<Motion> {
        if self.motion.is_some() {
            return self.motion.clone();
        }
        let (table, found) = self.read.as_ref()?;
        let times = &table.columns[found.first(Meaning::Time)?].values;
        let factor = seconds_per(found.clock.unit);
        let columns = found.joint_columns();
        let joints = (0..table.rows).map(|row| columns.iter().map(|at| table.columns[*at].values[row]).collect());
        let mut motion = Motion::new(times.iter().map(|time| factor * time).collect(), joints.collect())?;
        motion.names = columns.iter().filter_map(|at| table.columns[*at].name.clone()).collect();
        Some(motion)
    }

    /// Returns the times of the points (s), in order.
    fn times_s(&self) -> Option<Vec<f64>> {
        let (table, found) = self.read.as_ref()?;
        let mut times: Vec<f64> = match found.first(Meaning::Time) {
            Some(at) => {
                let factor = seconds_per(found.clock.unit);
                table.columns[at].values.iter().map(|time| factor * time).collect()
            }
            None => {
                let at = found.first(Meaning::Clock).or(found.first(Meaning::TimeOfDay))?;
                let cells = table.columns[at].cells.iter();
                cells.map(|cell| stamp_seconds("", cell).unwrap_or(f64::NAN)).collect()
            }
        };
        times.retain(|time| time.is_finite());
        times.sort_by(f64::total_cmp);
        Some(times)
    }

    /// Writes the proposal again with another correction.
    fn again(&mut self, correct: super::Correct) -> Result<()> {
        let (mut read, is_beside_log) = (None, self.is_beside_log);
        self.document = propose_corrected(
            &self.path,
            self.sheet.as_deref(),
            None,
            Some(&mut |table, found| {
                found.is_beside_log = is_beside_log;
                let remarks = correct(table, found);
                read = Some((table.clone(), found.clone()));
                remarks
            }),
        )?;
        self.read = read;
        self.state_clock();
        Ok(())
    }

    /// Writes the unit of the times that the duration of another file shows.
    fn state_clock(&mut self) {
        let (Some(unit), Some((_, found))) = (self.clock, &mut self.read) else { return };
        found.clock.unit = Some(unit);
        let question = found.clock.question.take();
        self.document.toml = self.document.toml.replace("time_UNIT", &format!("time_{unit}"));
        self.withdraw(question.as_ref());
    }

    /// Leaves out the times of a log, whose unit is open, if no join needs them.
    fn leave_clock(&mut self) {
        let Some((table, found)) = self.read.as_ref().filter(|(_, found)| found.clock.question.is_some()) else {
            return;
        };
        let Some(at) = found.first(Meaning::Time) else { return };
        let question = found.clock.question.clone();
        let named = table.columns[at].name.as_deref().map(quoted).into_iter().chain([(at + 1).to_string()]);
        let called = table.called(at);
        for source in named {
            let entry = format!("time_UNIT = {source}, ");
            self.document.toml = self.document.toml.replace(&entry, "");
        }
        if !self.document.toml.contains("time_UNIT") {
            self.withdraw(question.as_ref());
            self.doubt(phrase!("doubt-columns-not-read", columns = vec![called], more = 0));
        }
    }

    /// Removes a question that is answered.
    fn withdraw(&mut self, answered: Option<&Phrase>) {
        let is_asked = |question: &Worded| answered.is_some() && question.phrase() == answered;
        for question in self.document.questions.iter().filter(|question| is_asked(question)) {
            let line = format!("# QUESTION: {}\n", printable(&question.to_string()));
            self.document.toml = self.document.toml.replace(&line, "");
        }
        self.document.questions.retain(|question| !is_asked(question));
    }

    fn doubt(&mut self, doubt: Phrase) {
        self.document.toml.insert_str(0, &format!("# DOUBT: {}\n", printable(&doubt.to_string())));
        self.document.doubt(doubt);
    }

    /// Returns use, number of rows and units of the file.
    fn summary(&self) -> String {
        let unit = |wanted: &dyn Fn(Meaning) -> bool| {
            let (table, found) = self.read.as_ref()?;
            let at = found.taken.iter().position(|taken| wanted(taken.meaning))?;
            Some(table.columns[at].heading.unit.unwrap_or("open").to_owned())
        };
        let coordinates = unit(&|meaning| matches!(meaning, Meaning::Point(..))).unwrap_or("none".to_owned());
        let joints = unit(&|meaning| matches!(meaning, Meaning::Joint(_))).unwrap_or("none".to_owned());
        let times = unit(&|meaning| meaning == Meaning::Time).unwrap_or("none".to_owned());
        let kind = &*self.document.kind;
        let sheet = self.sheet.as_ref().map(|sheet| format!(": {sheet}")).unwrap_or_default();
        let (file, rows) = (format!("{}{sheet}", self.document.file), self.document.rows);
        phrase!("file-is", file, kind, rows, coordinates, joints, times).to_string()
    }

    /// Names the points by the running number in front of them; `false` for points without one.
    fn name_by_count(&mut self) -> Result<bool> {
        let counted = self.read.as_ref().and_then(|(_, found)| found.first(Meaning::Count));
        let Some(at) = counted else { return Ok(false) };
        self.again(&mut |_, found| {
            found.take(at, Meaning::Label, phrase!("why-names-of-points"));
            Remarks::default()
        })?;
        Ok(true)
    }

    /// Returns the target of each row: of its column, or of its label.
    pub fn targets(&self) -> Option<Vec<String>> {
        let (table, found) = self.read.as_ref()?;
        if let Some(at) = found.first(Meaning::Target) {
            return Some(texts(&table.columns[at]));
        }
        let labels = texts(&table.columns[found.first(Meaning::Label)?]);
        let Labels { form, .. } = Labels::new(&labels)?;
        let pattern = Pattern::parse(&form).ok()?;
        let target = |label: &String| pattern.read(label, |_| false).and_then(|named| named.target).unwrap_or_default();
        Some(labels.iter().map(target).collect())
    }
}

impl Keys {
    pub fn new(part: &Part) -> Self {
        let Some((table, found)) = &part.read else {
            return Self { rows: part.document.rows, ..Self::default() };
        };
        let column = |meaning: Meaning| found.first(meaning).map(|at| texts(&table.columns[at]));
        let labels = column(Meaning::Label);
        // of a column of targets, each may have the number of a pose once
        let of_targets = |labels: &Vec<String>| {
            let targets = column(Meaning::Target)?;
            let rows: BTreeSet<(&String, &String)> = targets.iter().zip(labels).collect();
            (are_numbers(labels) && rows.len() == labels.len()).then(|| (NUMBER.to_owned(), Vec::new()))
        };
        let mut still = Vec::new();
        let form = labels.as_ref().and_then(|labels| {
            of_targets(labels).or_else(|| {
                let found = Labels::new(labels)?;
                still = found.still;
                Some((found.form, found.targets))
            })
        });
        let pattern = form.as_ref().and_then(|(form, _)| Pattern::parse(form).ok());
        let of_labels = |of: &dyn Fn(crate::export::LabelNames) -> Option<String>| -> Option<Vec<String>> {
            let pattern = pattern.as_ref()?;
            let key = |label: &String| match still.contains(label) {
                true => Some(String::new()),
                false => of(pattern.read(label, |_| false)?),
            };
            labels.as_ref()?.iter().map(key).collect()
        };
        let is_log = part.document.kind == "log";
        // a log contains poses in a column
        let of_labels = |of: &dyn Fn(crate::export::LabelNames) -> Option<String>| of_labels(of).filter(|_| !is_log);
        let mut poses = column(Meaning::Pose).or_else(|| of_labels(&|named| Some(named.pose?.to_string())));
        let by_row = poses.is_none() && labels.is_none() && part.document.kind == "export";
        if by_row {
            poses = Some((1..=table.rows).map(|row| row.to_string()).collect());
        }
        let cycles = column(Meaning::Cycle).or_else(|| of_labels(&|named| Some(named.cycle?.to_string())));
        let ordered = |at: &usize| table.columns[*at].is_ordered();
        let times = found.first(Meaning::Time).filter(ordered).map(|at| table.columns[at].values.clone());
        Self { rows: table.rows, poses, by_row, cycles, labels, times, form, still }
    }

    /// Number of poses that the rows name.
    fn pose_count(&self) -> usize {
        self.poses.iter().flatten().filter(|pose| !pose.is_empty()).collect::<BTreeSet<&String>>().len()
    }

    /// Targets that the labels name.
    fn targets(&self) -> &[String] {
        self.form.as_ref().map_or(&[], |(_, targets)| targets)
    }

    /// Names of points that were measured several times, if the labels name no pose.
    fn stationary(&self) -> Option<&[String]> {
        let (form, names) = self.form.as_ref()?;
        (form == ALONE).then_some(names)
    }
}

/// Returns the cells of a column as keys.
pub(super) fn texts(column: &Column) -> Vec<String> {
    match column.is_numeric() {
        true => column.values.iter().map(f64::to_string).collect(),
        false => column.cells.iter().map(|cell| cell.trim().to_owned()).collect(),
    }
}

/// World frame of a robot whose base is identified.
const AS_EXPORTED: &str =
    "as_exported = true          # the base is found in the frame of the instrument; or targets that stay\n";
/// World frame of a robot whose model has the frame of the base.
const OWN_FRAME: &str = "as_exported = \"?\"           # true if the instrument measured in the frame of this robot model; \
     otherwise define that frame from points: plane, origin, x_axis or y_axis\n";

/// Lines of the world frame: a question if the model of the robot has no place of its base.
/// `stationary` are the names of points that do not move.
pub fn world_lines(robot: Option<&dyn Robot>, stationary: &[String]) -> String {
    let is_free = robot.is_none_or(|robot| robot.free_base().is_some() || !robot.branches().is_empty());
    let mut lines = format!("\n[frame.world]\n{}", if is_free { AS_EXPORTED } else { OWN_FRAME });
    if stationary.len() > 2 {
        // three points define a frame, and nobody but the user knows in which order
        let _ = match is_free {
            true => {
                writeln!(lines, "# targets = {stationary:?}   # in place of as_exported: a world from these points")
            }
            false => writeln!(lines, "# points for such a frame: {stationary:?}"),
        };
    }
    lines
}

/// Lines of a join of points and log by the relation of their times; `None` if the times show none.
fn join_by_clock(meeting: &Meeting, parts: &mut [Part], log: usize, targets: &[String]) -> Option<String> {
    let clock = match *meeting {
        Meeting::Open { .. } => return None,
        Meeting::Rows { offset_s, spread_s } => format!(
            "clock_offset_s = {offset_s:.4}   # each point has one row at this offset, within {spread_s:.4} s\n\
             tolerance_s = {:.3}\n",
            (2.0 * spread_s).max(0.01)
        ),
        Meeting::Moving { step_s } => format!(
            "clock_offset_s = \"motion\"   # the offset at which measured and computed speeds agree; 0 if both have one clock\n\
             interpolate = true          # the robot does not stand still\n\
             tolerance_s = {:.3}\n",
            (2.0 * step_s).max(0.01)
        ),
        Meeting::Standstills { at_least_s, .. } => {
            let _ = write!(
                parts[log].document.toml,
                "# the robot stands still at each point for so long, and no joint moves by more; within_mm for prismatic joints\n\
                 standstill = {{ at_least_s = {at_least_s:?}, within_deg = 0.02 }}\n"
            );
            "clock_offset_s = \"standstills\"   # the offset at which every point falls into a standstill\n\
             tolerance_s = 0.05          # a point may be so far outside of its standstill\n"
                .to_owned()
        }
    };
    if !matches!(meeting, Meeting::Rows { .. }) {
        // a point belongs to the row at its time: several targets share one pose
        for part in parts.iter_mut().filter(|part| part.document.kind == "export") {
            part.document.toml = part.document.toml.replace(POSE_LINE, "");
        }
    }
    Some(format!("\n[join]\nby = \"time\"\n{clock}targets = {targets:?}\n"))
}

/// Lines of a join by keys; `standstills` is the number of standstills of a recording whose times
/// show no relation.
fn join_by_keys(
    parts: &mut [Part],
    log: usize,
    joined: &[(usize, Join)],
    targets: &[String],
    standstills: Option<usize>,
) -> String {
    let log_file = parts[log].document.file.clone();
    let log_rows = parts[log].document.rows;
    let mut out = "\n[join]\n".to_owned();
    let by = joined.first().map(|(_, join)| join.by);
    for (at, join) in joined {
        let stated =
            FormatsJoin { log: log_file.clone(), by: join.by.to_owned(), keys: join.keys, matching: join.matching };
        let file = parts[*at].document.file.clone();
        let text =
            phrase!("files-join", file, log = &*log_file, by = join.by, keys = join.keys, matching = join.matching);
        let _ = writeln!(out, "# {}", printable(&text.to_string()));
        parts[*at].document.join = Some(stated);
    }
    match by {
        Some(by) if joined.iter().all(|(_, join)| join.by == by) => {
            let value = match by {
                "pose" => "[\"pose\"]".to_owned(),
                "pose, cycle" => "[\"pose\", \"cycle\"]".to_owned(),
                other => format!("\"{other}\""),
            };
            let _ = writeln!(out, "by = {value}");
            if by == "time" {
                out += "clock_offset_s = \"?\"      # time of the measurement minus time of the log, a number without quotes; \
                        or \"motion\", if both recorded one motion\n\
                        tolerance_s = \"?\"         # a number without quotes\n";
            }
        }
        _ => {
            let text = phrase!("files-not-joined", log = &*log_file, rows = log_rows);
            let _ = writeln!(out, "# DOUBT: {}", printable(&text.to_string()));
            for part in parts.iter().filter(|part| part.document.kind == "export") {
                let (file, rows) = (part.document.file.clone(), part.document.rows);
                let count = rows / log_rows.max(1);
                if rows == count * log_rows && (2..=MOST_TARGETS).contains(&count) {
                    let text = phrase!("rows-of-several-targets", file, rows, count, poses = log_rows);
                    let _ = writeln!(out, "# DOUBT: {}", printable(&text.to_string()));
                }
            }
            if let Some(standstills) = standstills {
                let text = phrase!("recording-not-joined", log = &*log_file, standstills);
                let _ = writeln!(out, "# DOUBT: {}", printable(&text.to_string()));
            }
            out += "by = \"?\"                 # [\"pose\"], [\"pose\", \"cycle\"], \"label\", \"time\" or \"row\"\n";
        }
    }
    let _ = writeln!(out, "targets = {targets:?}");
    out
}
