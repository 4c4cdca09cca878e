//! Measurements meet joint values: one tidy table of observations per log, and every row without a partner reported.

mod by_label;
mod by_time;
pub mod clock;
mod unmatched;

use crate::base::message::{Message, Problems, Result, count};
use crate::base::pose::{Pose, Vector};
use crate::base::table;
use crate::campaign::{Campaign, ClockOffset, JoinBy};
use crate::document::{FramesDocument, Unmatched};
use crate::math::robots::Robot;
use crate::stages::gather::Gathered;
use by_label::by_label;
use by_time::{Clocks, by_time};
use polars::prelude::*;
use std::collections::{BTreeMap, BTreeSet};
use unmatched::{Rows, key_in_words};

/// Observations by log, and what found no partner.
#[derive(Clone, Debug)]
pub struct Joined {
    /// Name of each log and its observations: `pose cycle target x_mm y_mm [z_mm]` and the joints.
    pub observations: Vec<(String, DataFrame)>,
    /// What found no partner or two, in short.
    pub messages: Vec<Message>,
    /// The same row by row.
    pub unmatched: Vec<Unmatched>,
}

/// What a join says beside its observations.
#[derive(Default)]
struct Said {
    messages: Vec<Message>,
    unmatched: Vec<Unmatched>,
}

/// A log: its name, its file and its rows.
#[derive(Clone, Copy)]
struct Log<'a> {
    name: &'a str,
    file: &'a str,
    rows: &'a DataFrame,
}

/// Joins the targets of `robot`, expressed in the world, with every log of the campaign.
pub fn join(campaign: &Campaign, imported: &Gathered, frames: &FramesDocument, robot: &dyn Robot) -> Result<Joined> {
    let (mut said, mut problems) = (Said::default(), Problems::default());
    let points = targets_in_world(imported, frames, robot, &mut said)?;
    let mut observations = Vec::new();
    for ((name, rows), stated) in imported.logs.iter().zip(&campaign.file.logs) {
        let log = Log { name, file: stated.file.get_ref(), rows };
        let joined = match campaign.file.join.by {
            JoinBy::Label => by_label(campaign, &imported.points, frames, log, robot, &mut said),
            _ => with_log(campaign, imported, &points, log, &mut said),
        };
        match joined.and_then(|joined| tidy(joined, robot)) {
            Ok(table) => {
                if observations.is_empty() {
                    said.messages.extend(incomplete(&table, robot)?);
                }
                observations.push((name.clone(), table));
            }
            Err(more) => problems.0.extend(more.at(&campaign.place_of(&["join", "by"])).0),
        }
    }
    problems.check()?;
    Ok(Joined { observations, messages: said.messages, unmatched: said.unmatched })
}

/// Joins targets in the world with one log, by the key that the campaign states.
fn with_log(
    campaign: &Campaign,
    imported: &Gathered,
    points: &DataFrame,
    log: Log,
    said: &mut Said,
) -> Result<DataFrame> {
    let joined = match campaign.file.join.by {
        JoinBy::PoseAndCycle => by_keys(points, log, &["pose", "cycle"], said)?,
        JoinBy::Pose => by_keys(points, log, &["pose"], said)?,
        JoinBy::Row => {
            equal_counts(campaign, imported, points, log.rows, log.name)?;
            by_keys(points, log, &["row"], said)?
        }
        JoinBy::Time => {
            let join = &campaign.file.join;
            let offset_s = offset_s(campaign, points, log, said)?;
            let tolerance_s = join.tolerance_s.unwrap_or(0.0);
            by_time(points, log, Clocks { offset_s, tolerance_s, interpolate: join.interpolate }, said)?
        }
        // what the log touches has no partner among the robot's targets
        JoinBy::Label => DataFrame::empty(),
    };
    if joined.height() == 0 {
        let message = Message::error(format!("no measured point has a partner in log `{}`", log.name));
        if campaign.file.join.by == JoinBy::Time {
            let apart =
                apart_s(campaign, points, log.rows)?.map_or_else(String::new, |s| format!(" are {s:.3} s apart"));
            let hint = format!(
                "with this `clock_offset_s` the two nearest times{apart}: check its value and sign; it is the time of the \
                 measurement minus that of the log"
            );
            return Err(message.at(campaign.place_of(&["join", "clock_offset_s"])).hint(hint).into());
        }
        let hint = "compare the poses and cycles of exports and log, or choose another key with `by` in [join]";
        return Err(message.hint(hint).into());
    }
    Ok(joined)
}

/// The offset of the clocks: as stated, or from the standstills of the log, which is said.
fn offset_s(campaign: &Campaign, points: &DataFrame, log: Log, said: &mut Said) -> Result<f64> {
    let join = &campaign.file.join;
    if join.clock_offset_s != Some(ClockOffset::Standstills) {
        return Ok(join.stated_offset_s().unwrap_or(0.0));
    }
    let (from, to) = (table::numbers(log.rows, "from_s")?, table::numbers(log.rows, "to_s")?);
    let standstills: Vec<(f64, f64)> = from.into_iter().zip(to).collect();
    let place = || campaign.place_of(&["join", "clock_offset_s"]);
    let found = clock::offset(&table::numbers(points, "time_s")?, &standstills).map_err(|m| m.at(place()))?;
    let what = format!(
        "the clock of log `{}` is set by its {}: offset {:.3} s, at most {:.3} s off",
        log.name,
        count(standstills.len(), "standstill"),
        found.offset_s,
        found.half_width_s
    );
    said.messages.push(Message::warning(what).at(place()).hint("every measured point falls into a standstill so"));
    Ok(found.offset_s)
}

/// The smallest difference of the times of a point and of a row of the log, clocks set by the campaign's offset.
fn apart_s(campaign: &Campaign, points: &DataFrame, log: &DataFrame) -> Result<Option<f64>> {
    let offset_s = campaign.file.join.stated_offset_s().unwrap_or(0.0);
    let mut logged = table::numbers(log, "time_s")?;
    logged.sort_by(f64::total_cmp);
    let nearest = |time_s: f64| {
        let after = logged.partition_point(|l| *l < time_s);
        let beside = logged.get(after.saturating_sub(1)..(after + 1).min(logged.len())).unwrap_or_default();
        beside.iter().map(|l| (l - time_s).abs()).min_by(f64::total_cmp)
    };
    let times = table::numbers(points, "time_s")?;
    Ok(times.into_iter().filter_map(|t| nearest(t - offset_s)).min_by(f64::total_cmp))
}

/// What the counts of rows say against a join by row, before anything is known of targets and frames.
pub fn counts(campaign: &Campaign, imported: &Gathered, robot: &dyn Robot) -> Result<()> {
    if campaign.file.join.by != JoinBy::Row {
        return Ok(());
    }
    let names = table::texts(&imported.points, "target")?;
    let keep: BooleanChunked = names.iter().map(|name| Some(robot.targets().contains(name))).collect();
    let points = imported.points.filter(&keep)?;
    let found = imported.logs.iter().map(|(name, log)| equal_counts(campaign, imported, &points, log, name));
    Problems(found.filter_map(Result::err).flat_map(|p| p.0).collect()).check().map(|_| ())
}

/// The targets of the robot in the world; targets of poses without a world frame are reported.
fn targets_in_world(
    imported: &Gathered,
    frames: &FramesDocument,
    robot: &dyn Robot,
    said: &mut Said,
) -> Result<DataFrame> {
    let points = &imported.points;
    let names = table::texts(points, "target")?;
    let xyz = table::coordinates(points)?;
    let (poses, cycles) = (table::optional_integers(points, "pose")?, table::optional_integers(points, "cycle")?);
    let mut by_pose: BTreeMap<(i64, i64), Pose> = BTreeMap::new();
    let mut for_all = None;
    for frame in &frames.world.poses {
        match (frame.pose, frame.cycle) {
            (Some(pose), Some(cycle)) => drop(by_pose.insert((pose, cycle), frame.export_T_world.inverse())),
            _ => for_all = Some(frame.export_T_world.inverse()),
        }
    }
    let (mut keep, mut order, mut world) = (Vec::new(), Vec::new(), Vec::<Vector>::new());
    let mut lost = BTreeSet::new();
    let places = Rows::points(points)?;
    for i in 0..points.height() {
        let Some(target) = robot.targets().iter().position(|t| *t == names[i]) else { continue };
        let key = poses[i].zip(cycles[i]);
        let Some(world_T_export) = for_all.or_else(|| by_pose.get(&key?).copied()) else {
            lost.extend(poses[i]);
            let key = poses[i].map_or_else(String::new, |pose| format!("pose {pose}"));
            said.unmatched.push(places.unmatched(i, key, "its pose has no world frame"));
            continue;
        };
        keep.push(i as IdxSize);
        order.push(target as i64);
        world.push(world_T_export.apply(xyz[i]));
    }
    if !lost.is_empty() {
        said.messages.push(
            Message::warning(format!(
                "{} without a world frame, left out: {}",
                count(lost.len(), "pose"),
                listed(&lost)
            ))
            .hint("their frame targets were refused or not measured: see import.json"),
        );
    }
    let mut kept = points.take(&IdxCa::from_vec("i".into(), keep))?;
    for (axis, name) in table::XYZ.iter().enumerate() {
        kept.with_column(Column::new((*name).into(), world.iter().map(|p| p[axis]).collect::<Vec<f64>>()))?;
    }
    kept.with_column(Column::new("order".into(), order))?;
    Ok(kept)
}

/// Joins on equal keys. A key that occurs twice in the log is an error, one without a partner a warning.
fn by_keys(points: &DataFrame, log: Log, keys: &[&str], said: &mut Said) -> Result<DataFrame> {
    let measured = key_rows(points, keys)?;
    let logged = key_rows(log.rows, keys)?;
    let (name, log_rows) = (log.name, Rows::log(log.rows, log.file)?);
    let twice: Vec<String> = logged
        .iter()
        .filter(|(_, rows)| rows.len() > 1)
        .map(|(key, rows)| {
            let at: Vec<String> = rows.iter().map(|&row| log_rows.line(row).to_string()).collect();
            format!("{} in lines {}", key_in_words(keys, key), at.join(", "))
        })
        .collect();
    if !twice.is_empty() {
        let what = format!("log `{name}` has {} more than once: {}", count(twice.len(), "key"), twice.join("; "));
        return Err(Message::error(what).hint("add `cycle` to the key, or remove the rows that do not count").into());
    }
    let mut report = |one: &str, many: &str, rows: Rows, here: &Keys, there: &Keys, reason: String| {
        let alone: Vec<&Vec<i64>> = here.keys().filter(|key| !there.contains_key(*key)).collect();
        let what = if alone.len() == 1 { one } else { many };
        if !alone.is_empty() {
            let shown: Vec<String> = alone.iter().take(8).map(|k| format!("{k:?}")).collect();
            let more = if alone.len() > 8 { ", ... (all are in import.json)" } else { "" };
            let text = format!(
                "{} {what} `{name}` without a partner ({}): {}{more}",
                alone.len(),
                keys.join(", "),
                shown.join(", ")
            );
            said.messages.push(Message::warning(text));
        }
        for key in alone {
            let at = here[key].iter().map(|&row| rows.unmatched(row, key_in_words(keys, key), &reason));
            said.unmatched.extend(at);
        }
    };
    let lone = format!("no row of log `{name}` has this key");
    report(
        "measured key is beside log",
        "measured keys are beside log",
        Rows::points(points)?,
        &measured,
        &logged,
        lone,
    );
    report("key of log", "keys of log", log_rows, &logged, &measured, "no measured point has this key".to_owned());
    let by_row = keys == ["row"];
    let pairs = measured.iter().filter(|_| by_row).filter_map(|(key, rows)| Some((rows, *logged.get(key)?.first()?)));
    contradictions(points, log, pairs.flat_map(|(rows, logged)| rows.iter().map(move |&row| (row, logged))))?;
    let met = measured.iter().filter_map(|(key, rows)| Some((rows, *logged.get(key)?.first()?)));
    let mut met: Vec<(usize, usize)> = met.flat_map(|(rows, logged)| rows.iter().map(move |&r| (r, logged))).collect();
    met.sort_unstable();
    let (here, there): (Vec<IdxSize>, Vec<IdxSize>) =
        met.into_iter().map(|(row, logged)| (row as IdxSize, logged as IdxSize)).unzip();
    let mut joined = points.take(&IdxCa::from_vec("i".into(), here))?;
    let there = IdxCa::from_vec("i".into(), there);
    for column in log.rows.columns() {
        if joined.column(column.name()).is_err() {
            joined.with_column(column.take(&there)?)?;
        }
    }
    Ok(joined)
}

/// An error where points and the rows of the log that they meet bear different poses or cycles.
fn contradictions(points: &DataFrame, log: Log, pairs: impl Iterator<Item = (usize, usize)> + Clone) -> Result<()> {
    let mut problems = Problems::default();
    let (here, there) = (Rows::points(points)?, Rows::log(log.rows, log.file)?);
    for column in ["pose", "cycle"] {
        if log.rows.column(column).is_err() {
            continue;
        }
        let (stated, logged) = (table::optional_integers(points, column)?, table::optional_integers(log.rows, column)?);
        let differs = |&(i, j): &(usize, usize)| matches!((stated[i], logged[j]), (Some(a), Some(b)) if a != b);
        let all: Vec<(usize, usize)> = pairs.clone().filter(differs).collect();
        let Some(&(i, j)) = all.first() else { continue };
        let number = |n: Option<i64>| n.map_or_else(String::new, |n| n.to_string());
        let what = format!(
            "{} with another {column} than the row of log `{}` that it meets: {} and {} (line {} of the log)",
            count(all.len(), "measured point"),
            log.name,
            number(stated[i]),
            number(logged[j]),
            there.line(j)
        );
        let hint =
            format!("join by pose; or leave `{column}` out of `columns` of the log, if it counts something else there");
        problems.0.push(Message::error(what).at(here.place(i)).hint(hint));
    }
    problems.check().map(|_| ())
}

/// Rows by their key.
type Keys = BTreeMap<Vec<i64>, Vec<usize>>;

fn key_rows(frame: &DataFrame, keys: &[&str]) -> Result<Keys> {
    let columns: Vec<Vec<i64>> =
        keys.iter()
            .map(|key| {
                table::integers(frame, key).map_err(|_| {
                    Problems::from(Message::error(format!("the join needs `{key}`, which some rows do not have")).hint(
                        "name it in `label` of the exports and in `columns` of the log, or change `by` in [join]",
                    ))
                })
            })
            .collect::<Result<_>>()?;
    let mut rows = Keys::new();
    for i in 0..frame.height() {
        rows.entry(columns.iter().map(|c| c[i]).collect()).or_default().push(i);
    }
    Ok(rows)
}

/// A join by row is only allowed where every export that brings targets has as many data rows as the log.
fn equal_counts(
    campaign: &Campaign,
    imported: &Gathered,
    points: &DataFrame,
    log: &DataFrame,
    name: &str,
) -> Result<()> {
    let targets: BTreeSet<String> = table::texts(points, "export")?.into_iter().collect();
    let mut problems = Problems::default();
    for source in imported.document.sources.iter().filter(|s| s.kind == "export" && targets.contains(&s.file)) {
        if source.rows_read != log.height() {
            let what = format!("`{}` has {} rows, log `{name}` has {}", source.file, source.rows_read, log.height());
            let message = Message::error(what).expected("equal counts for a join by row");
            let message = message.hint(
                "one row of the log for each row of the export; else name pose and cycle in both, and join by them",
            );
            let place = campaign
                .file
                .exports
                .iter()
                .find(|e| *e.file.get_ref() == source.file)
                .map(|e| Box::new(campaign.place(&e.file)));
            problems.0.push(Message { place, ..message });
        }
    }
    problems.check().map(|_| ())
}

/// The columns of observations, sorted by pose, cycle and the robot's order of targets.
fn tidy(joined: DataFrame, robot: &dyn Robot) -> Result<DataFrame> {
    let sorted = joined.sort(["pose", "cycle", "order"], SortMultipleOptions::default().with_maintain_order(true))?;
    let mut columns = vec!["pose".to_owned(), "cycle".to_owned(), "target".to_owned()];
    columns.extend(table::XYZ[..robot.dimension()].iter().map(|c| (*c).to_owned()));
    columns.extend(robot.joints().iter().map(|j| j.column()));
    if robot.has_assembly_modes() && sorted.column(table::ASSEMBLY).is_ok() {
        columns.push(table::ASSEMBLY.to_owned());
    }
    Ok(sorted.select(columns)?)
}

/// A warning where some poses lack a target that others have.
fn incomplete(observations: &DataFrame, robot: &dyn Robot) -> Result<Option<Message>> {
    let (poses, cycles) = (table::integers(observations, "pose")?, table::integers(observations, "cycle")?);
    let mut seen: BTreeMap<(i64, i64), usize> = BTreeMap::new();
    for key in poses.into_iter().zip(cycles) {
        *seen.entry(key).or_default() += 1;
    }
    let lacking = |(_, n): &(&(i64, i64), &usize)| **n < robot.targets().len();
    let poses: BTreeSet<i64> = seen.iter().filter(lacking).map(|(key, _)| key.0).collect();
    let what = format!("poses that lack a target: {}", listed(&poses));
    let hint = "their other targets still count; a pose or an orientation needs all of them";
    Ok((!poses.is_empty()).then(|| Message::warning(what).hint(hint)))
}

fn listed(numbers: &BTreeSet<i64>) -> String {
    let shown: Vec<String> = numbers.iter().take(20).map(i64::to_string).collect();
    shown.join(", ") + if numbers.len() > 20 { ", ..." } else { "" }
}
