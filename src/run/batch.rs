//! Many campaigns in one process. An unchanged campaign is read back instead of run; all results
//! form one table.
//!
//! Documents of a batch are not synced one by one. On a restart, a campaign counts as done if all
//! files of its folder have the hashes of its manifest; after a power failure, the others are run
//! again.

use crate::run::documents::Documents;
use crate::run::output::current;
use crate::run::pipeline::{self, Wanted};
use crate::run::results;
use etalon_base::catalogue::{Argument, IntoArgument};
use etalon_base::files;
use etalon_base::folder::{self, Durability};
use etalon_base::message::{Problems, Rank, Result};
use etalon_base::worded::Worded;
use etalon_base::{error, phrase};
use etalon_campaign::Campaign;
use etalon_documents::{
    Acceptance, BatchCheck, BatchDocument, BatchEnd, BatchEntry, BatchFigures, BatchQuantity, IdentifiedDocuments,
    Iso9283Pose, LimitVerdict, ParametersDocument, PoseCharacteristic, Reason, Results, Role,
};
use etalon_formats::parquet::{RowGroups, frame};
use polars::prelude::{Column, DataFrame};
use rayon::{ThreadPoolBuildError, ThreadPoolBuilder};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::SystemTime;

/// Number of campaigns in memory at once; their results form one row group of the table.
const AT_ONCE: usize = 256;
/// Stack size of the thread of a campaign (bytes).
const STACK: usize = 8 << 20;

/// One result of one campaign.
#[derive(Debug, Default)]
struct Line {
    kind: &'static str,
    /// Name in the table; results that the page shows have a phrase.
    item: Worded,
    unit: String,
    value: f64,
    standard_uncertainty: Option<f64>,
    nominal: Option<f64>,
    limit: Option<f64>,
    met: Option<bool>,
}

/// All campaigns of a batch, in the order in which they were named.
#[derive(Debug)]
pub struct Batch {
    /// Outcome of each campaign.
    pub document: BatchDocument,
    /// Results that the page of the batch shows.
    pub figures: BatchFigures,
}

/// Runs campaigns on all cores and writes their results as Parquet. Campaigns that are unchanged
/// `since` are read back. Calls `ended` after each campaign.
pub fn batch<W: Write + Send>(
    folders: &[PathBuf],
    wanted: Wanted,
    since: Option<SystemTime>,
    parquet: W,
    ended: impl Fn(&BatchEntry) + Sync,
) -> Result<Batch> {
    let one = |folder: &PathBuf| {
        let mut entry = BatchEntry { campaign: folder.display().to_string(), ..BatchEntry::default() };
        let (rows, output) = campaign(folder, wanted, since, &mut entry).unwrap_or_else(|problems| {
            (entry.ended, entry.message) = (BatchEnd::Failed, Some(problems.to_string()));
            Default::default()
        });
        ended(&entry);
        ((entry, rows), output)
    };
    let (mut campaigns, mut figures) = (Vec::with_capacity(folders.len()), BatchFigures::default());
    let mut computed: Vec<PathBuf> = Vec::new();
    let mut written = RowGroups::new(parquet, &table(&[])?)?;
    for folders in folders.chunks(AT_ONCE) {
        let (found, outputs): (Vec<_>, Vec<_>) = on_all_cores(folders, one)?.into_iter().unzip();
        computed.extend(outputs.into_iter().flatten());
        written.add(&table(&found)?)?;
        for (entry, rows) in found {
            campaigns.push(entry);
            figures.add(page_figures(&rows));
        }
    }
    written.finish()?;
    let folders = computed.iter().map(PathBuf::as_path);
    folder::flush(folders).map_err(|e| error!("results-not-synced", reason = e.to_string()))?;
    Ok(Batch { document: BatchDocument::new(campaigns), figures })
}

/// Results of `work` for all items, in order. Each core has a thread with its own pool: in a common
/// pool, a waiting thread begins the next item deeper in its stack.
fn on_all_cores<I: Sync, T: Send>(items: &[I], work: impl Fn(&I) -> T + Sync) -> Result<Vec<T>> {
    let next = AtomicUsize::new(0);
    let some = || -> std::result::Result<Vec<(usize, T)>, ThreadPoolBuildError> {
        let pool = ThreadPoolBuilder::new().num_threads(1).stack_size(STACK).build()?;
        let taken = || Some(next.fetch_add(1, Ordering::Relaxed)).filter(|&i| i < items.len());
        Ok(pool.install(|| std::iter::from_fn(taken).map(|i| (i, work(&items[i]))).collect()))
    };
    let failed = |reason: &str| error!("threads-failed", reason);
    let mut all = Vec::with_capacity(items.len());
    std::thread::scope(|scope| -> Result<()> {
        let threads: Vec<_> = (0..rayon::current_num_threads()).map(|_| scope.spawn(some)).collect();
        for thread in threads {
            let made = thread.join().map_err(|_| failed("ended"))?;
            all.extend(made.map_err(|e| failed(&e.to_string()))?);
        }
        Ok(())
    })?;
    all.sort_unstable_by_key(|(i, _)| *i);
    Ok(all.into_iter().map(|(_, made)| made).collect())
}

/// Results of one campaign, and its output folder if it was written; completes `entry`.
fn campaign(
    folder: &Path,
    wanted: Wanted,
    since: Option<SystemTime>,
    entry: &mut BatchEntry,
) -> Result<(Vec<Line>, Option<PathBuf>)> {
    let campaign = Campaign::read(folder)?;
    if let Some(name) = campaign.missing_variable() {
        entry.ended = BatchEnd::Skipped;
        entry.message = Some(phrase!("data-elsewhere", name).to_string());
        return Ok(Default::default());
    }
    let output = campaign.written_output()?;
    entry.output = Some(output.display().to_string());
    let last = if wanted == Wanted::Reports { "report.html" } else { "import.json" };
    let recent = |documents: &Documents| since.is_none_or(|since| documents.written().is_ok_and(|at| at >= since));
    // documents of another version are written again
    let stored = current(&campaign, last).filter(recent).and_then(|documents| results::read(&documents).ok());
    let (results, written) = match stored {
        Some(results) => (results, None),
        None => (pipeline::run_for(&campaign, wanted, Durability::Later)?.results, Some(output)),
    };
    entry.computed = written.is_some();
    describe(entry, &results);
    entry.verdict = results.verdict.verdict;
    entry.checks = checks(&results);
    Ok((rows(&results), written))
}

fn describe(entry: &mut BatchEntry, results: &Results) {
    let campaign = &results.campaign;
    let parameters = results.identified.as_ref().map(|i| &i.parameters);
    entry.ended = if results.verdict.passes() { BatchEnd::Done } else { BatchEnd::NotMet };
    (entry.name, entry.date) = (campaign.name.clone(), campaign.measurements.date.clone());
    entry.valid_until = campaign.valid_until.clone();
    entry.synthetic = campaign.measurements.synthetic.is_some();
    entry.robot = campaign.robot.clone().or_else(|| parameters.map(|p| p.robot.clone()));
    let given = &campaign.conditions;
    let stated = given.robot.model.as_ref().map(|kind| match &given.robot.maker {
        Some(maker) => format!("{maker} {kind}"),
        None => kind.clone(),
    });
    entry.alike = stated.or_else(|| parameters.map(nominal)).or_else(|| entry.robot.clone());
}

/// Model with a checksum of the nominal parameters: equal for robots of one kind.
fn nominal(document: &ParametersDocument) -> String {
    let of_robot = document.parameters.iter().filter(|p| p.role == Role::Robot);
    let listed: String = of_robot.map(|p| format!("{} = {} {}\n", p.name, p.nominal, p.unit)).collect();
    format!("{} {}", document.robot, &files::sha256(listed.as_bytes())[..8])
}

/// Checks of a result, in the order of reading.
fn checks(results: &Results) -> Vec<BatchCheck> {
    let check =
        |name: &str, verdict| BatchCheck { name: name.to_owned(), verdict, value: None, limit: None, unit: None };
    let pass = |passed| if passed { Acceptance::Pass } else { Acceptance::Fail };
    let limit = |l: &LimitVerdict| BatchCheck {
        value: l.value,
        limit: Some(l.limit),
        unit: Some(l.unit.clone()),
        ..check(l.name.into(), l.acceptance)
    };
    let mut all: Vec<BatchCheck> = results.verdict.limits.iter().map(limit).collect();
    if let Some(IdentifiedDocuments { parameters, .. }) = &results.identified {
        all.push(check("solver", pass(parameters.solver.termination.is_success())));
        all.push(check("robot", pass(parameters.is_plausible())));
    }
    let others = || results.verdict.reasons.iter().filter(|r| is_precondition(r));
    if let Some(verdict) = others().map(Reason::acceptance).max() {
        all.push(BatchCheck { value: Some(others().count() as f64), ..check("preconditions", verdict) });
    }
    let decide = results.messages().filter(|m| m.rank == Rank::Decide).count();
    let verdict = if decide > 0 { Acceptance::Conditional } else { Acceptance::Pass };
    all.push(BatchCheck { value: Some(decide as f64), ..check("warnings", verdict) });
    all
}

/// `true` for a reason that no other check shows.
fn is_precondition(reason: &Reason) -> bool {
    !matches!(
        reason,
        Reason::NotConverged
            | Reason::Implausible
            | Reason::LimitNotMet { .. }
            | Reason::LimitUndecided { .. }
            | Reason::NotAssessable { .. }
            | Reason::WithinGuardBand { .. }
    )
}

fn rows(results: &Results) -> Vec<Line> {
    let mut rows = Vec::new();
    if let Some(IdentifiedDocuments { parameters, accuracy, .. }) = &results.identified {
        rows.extend(parameters.parameters.iter().map(|p| Line {
            kind: "parameter",
            item: p.name.as_str().into(),
            unit: p.unit.clone(),
            value: p.value,
            standard_uncertainty: p.standard_uncertainty,
            nominal: Some(p.nominal),
            ..Line::default()
        }));
        for set in &accuracy.sets {
            for errors in &set.errors {
                let (set, quantity) = (set.name, errors.quantity);
                let of = |(statistic, figure, value): (&str, Option<Argument>, f64)| Line {
                    kind: "error",
                    item: Worded::stored(
                        format!("{set} {quantity} {statistic}"),
                        figure.map(|figure| {
                            phrase!("figure-of-set", set = set.phrase(), quantity = quantity.phrase(), figure)
                        }),
                    ),
                    unit: errors.unit.clone(),
                    value,
                    ..Line::default()
                };
                let (before, after) = (&errors.before, &errors.after);
                let all = [
                    ("RMS before", None, before.rms),
                    ("max before", None, before.max),
                    ("RMS", Some("RMS".argument()), after.rms),
                    ("max", Some(phrase!("max").argument()), after.max),
                ];
                rows.extend(all.map(of));
            }
        }
        rows.extend(accuracy.limits.iter().map(|l| Line {
            kind: "limit",
            item: l.name.to_string().into(),
            unit: l.unit.clone(),
            value: l.value.unwrap_or(f64::NAN),
            limit: Some(l.limit),
            met: Some(l.met),
            ..Line::default()
        }));
    }
    let of_pose = |p: &Iso9283Pose| {
        let row = |kind, value| Line {
            kind,
            item: p.pose.to_string().into(),
            unit: "mm".to_owned(),
            value,
            ..Line::default()
        };
        PoseCharacteristic::ALL.iter().filter_map(|c| Some(row(c.symbol, (c.value)(p)?))).collect::<Vec<_>>()
    };
    rows.extend(results.tested.poses.iter().flat_map(|tested| &tested.poses).flat_map(of_pose));
    rows
}

/// Results that the page shows: errors after calibration, largest AP and RP, and parameters.
fn page_figures(rows: &[Line]) -> impl Iterator<Item = (BatchQuantity, f64, Option<f64>)> {
    let of = move |kind: &'static str| rows.iter().filter(move |row| row.kind == kind);
    let errors = of("error").filter(|row| row.item.phrase().is_some()).chain(of("parameter"));
    let quantity = |name: Worded, unit: &str| BatchQuantity { name, unit: unit.to_owned() };
    let largest = PoseCharacteristic::ALL.into_iter().filter_map(move |PoseCharacteristic { symbol: kind, .. }| {
        let value = of(kind).map(|row| row.value).max_by(f64::total_cmp)?;
        Some((quantity(kind.into(), "mm"), value, None))
    });
    let error = move |row: &Line| (quantity(row.item.clone(), &row.unit), row.value, row.standard_uncertainty);
    largest.chain(errors.map(error))
}

/// Table of results, one a row: parameters, errors before and after, limits, AP and RP by pose.
fn table(found: &[(BatchEntry, Vec<Line>)]) -> Result<DataFrame> {
    let all = || found.iter().flat_map(|(entry, rows)| rows.iter().map(move |row| (entry, row)));
    let text = |name: &str, of: fn(&BatchEntry, &Line) -> Option<String>| {
        Column::new(name.into(), all().map(|(entry, row)| of(entry, row)).collect::<Vec<_>>())
    };
    let number = |name: &str, of: fn(&Line) -> Option<f64>| {
        Column::new(name.into(), all().map(|(_, row)| of(row)).collect::<Vec<_>>())
    };
    let columns = vec![
        text("campaign", |entry, _| Some(entry.campaign.clone())),
        text("name", |entry, _| Some(entry.name.clone())),
        text("robot", |entry, _| entry.robot.clone()),
        text("date", |entry, _| entry.date.clone()),
        text("verdict", |entry, _| Some(entry.ended.name().to_owned())),
        text("kind", |_, row| Some(row.kind.to_owned())),
        text("item", |_, row| Some(row.item.english().to_owned())),
        text("unit", |_, row| Some(row.unit.clone())),
        number("value", |row| Some(row.value)),
        number("standard_uncertainty", |row| row.standard_uncertainty),
        number("nominal", |row| row.nominal),
        number("limit", |row| row.limit),
        Column::new("met".into(), all().map(|(_, row)| row.met).collect::<Vec<_>>()),
    ];
    frame(all().count(), columns)
}

/// Campaigns named by arguments: folders, their `campaign.toml`, folders of campaigns, and lists of
/// campaigns (one a line, remarks after `#`).
pub fn folders(named: &[PathBuf]) -> Result<Vec<PathBuf>> {
    let mut all = Vec::new();
    let mut problems = Problems::default();
    for path in named {
        let inside = if path.join("campaign.toml").exists() { Vec::new() } else { campaigns_in(path) };
        if !inside.is_empty() {
            all.extend(inside);
            continue;
        }
        if path.is_dir() || path.extension().is_some_and(|ending| ending == "toml") {
            all.push(path.clone());
            continue;
        }
        let Some(text) = problems.keep(etalon_base::files::read_text(path)) else { continue };
        let lines = text.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with('#'));
        // relative to the list, like paths in a campaign
        all.extend(lines.map(|line| path.parent().unwrap_or(Path::new("")).join(line)));
    }
    let mut sorted: Vec<&PathBuf> = all.iter().collect();
    sorted.sort();
    for pair in sorted.windows(2).filter(|pair| pair[0] == pair[1]) {
        problems.0.push(error!("campaign-twice", folder = pair[0].display().to_string()));
    }
    problems.check()?;
    Ok(all)
}

/// The campaigns in a folder, sorted by name.
fn campaigns_in(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path());
    let mut campaigns: Vec<PathBuf> = entries.filter(|path| path.join("campaign.toml").is_file()).collect();
    campaigns.sort();
    campaigns
}
