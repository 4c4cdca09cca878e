//! Many campaigns in one process: each is run, or read back where nothing of it has changed, and their results are one table.

use crate::base::message::{Message, Problems, Result};
use crate::base::table;
use crate::campaign::Campaign;
use crate::document::{BatchDocument, BatchEnd, BatchEntry, Iso9283Pose};
use crate::run::documents::{Documents, Run};
use crate::run::output::current;
use crate::run::pipeline::{self, Wanted};
use polars::prelude::{Column, DataFrame};
use rayon::prelude::*;
use std::path::{Path, PathBuf};

/// One result of one campaign.
#[derive(Clone, Debug, Default)]
struct Row {
    kind: &'static str,
    item: String,
    unit: String,
    value: f64,
    standard_uncertainty: Option<f64>,
    nominal: Option<f64>,
    limit: Option<f64>,
    met: Option<bool>,
}

/// All campaigns of a batch, in the order in which they were named.
pub struct Batch {
    /// How each ended.
    pub document: BatchDocument,
    rows: Vec<Vec<Row>>,
}

/// Runs campaigns on all cores, without those of which nothing has changed; `ended` is called after each.
pub fn batch(folders: &[PathBuf], wanted: Wanted, ended: impl Fn(&BatchEntry) + Sync) -> Batch {
    let one = |folder: &PathBuf| {
        let mut entry = BatchEntry { campaign: folder.display().to_string(), ..BatchEntry::default() };
        let rows = match campaign(folder, wanted, &mut entry) {
            Ok(rows) => rows,
            Err(problems) => {
                (entry.ended, entry.message) = (BatchEnd::Failed, Some(problems.to_string()));
                Vec::new()
            }
        };
        ended(&entry);
        (entry, rows)
    };
    let (campaigns, rows) = folders.par_iter().map(one).unzip();
    Batch { document: BatchDocument::new(campaigns), rows }
}

/// Results of one campaign; what `entry` says of it is filled in.
fn campaign(folder: &Path, wanted: Wanted, entry: &mut BatchEntry) -> Result<Vec<Row>> {
    let campaign = Campaign::read(folder)?;
    if let Some(name) = campaign.missing_variable() {
        entry.ended = BatchEnd::Skipped;
        entry.message = Some(format!("its data are below ${name}, which is not set"));
        return Ok(Vec::new());
    }
    let output = campaign.output()?;
    let last = if wanted == Wanted::Reports { "report.html" } else { "import.json" };
    let documents = match current(&campaign, last) {
        Some(documents) => documents,
        None => {
            pipeline::run_for(&campaign, wanted)?;
            entry.computed = true;
            Documents::open(&output)?
        }
    };
    let run = Run::read(&documents)?;
    entry.ended = if run.faces()?.is_met() { BatchEnd::Done } else { BatchEnd::NotMet };
    (entry.name, entry.date) = (run.campaign.name.clone(), run.campaign.date.clone());
    entry.robot = run.campaign.robot.clone().or_else(|| run.identified.as_ref().map(|i| i.parameters.robot.clone()));
    entry.output = Some(output.display().to_string());
    Ok(rows(&run))
}

fn rows(run: &Run) -> Vec<Row> {
    let mut rows = Vec::new();
    if let Some(identified) = &run.identified {
        rows.extend(identified.parameters.parameters.iter().map(|p| Row {
            kind: "parameter",
            item: p.name.clone(),
            unit: p.unit.clone(),
            value: p.value,
            standard_uncertainty: p.standard_uncertainty,
            nominal: Some(p.nominal),
            ..Row::default()
        }));
        for set in &identified.accuracy.sets {
            for errors in &set.errors {
                let of = |(statistic, value): (&str, f64)| Row {
                    kind: "error",
                    item: format!("{} {} {statistic}", set.name, errors.quantity),
                    unit: errors.unit.clone(),
                    value,
                    ..Row::default()
                };
                let (before, after) = (&errors.before, &errors.after);
                let all =
                    [("RMS before", before.rms), ("max before", before.max), ("RMS", after.rms), ("max", after.max)];
                rows.extend(all.map(of));
            }
        }
        rows.extend(identified.accuracy.limits.iter().map(|l| Row {
            kind: "limit",
            item: l.name.clone(),
            unit: l.unit.clone(),
            value: l.value,
            limit: Some(l.limit),
            met: Some(l.met),
            ..Row::default()
        }));
    }
    let of_pose = |p: &Iso9283Pose| {
        let row = |kind, value| Row { kind, item: p.pose.to_string(), unit: "mm".to_owned(), value, ..Row::default() };
        [p.ap_mm.map(|ap| row("AP", ap)), p.rp_mm.map(|rp| row("RP", rp))].into_iter().flatten().collect::<Vec<_>>()
    };
    rows.extend(run.tested.poses.iter().flat_map(|tested| &tested.poses).flat_map(of_pose));
    rows
}

impl Batch {
    /// One row a result: parameters, errors before and after, limits, AP and RP by pose.
    pub fn table(&self) -> Result<DataFrame> {
        let all = || {
            let of =
                |(entry, rows): (_, &'_ Vec<Row>)| rows.iter().map(move |row| (entry, row.clone())).collect::<Vec<_>>();
            self.document.campaigns.iter().zip(&self.rows).flat_map(of)
        };
        let of_entry = |name: &str, f: fn(&BatchEntry) -> Option<String>| {
            Column::new(name.into(), all().map(|(entry, _)| f(entry)).collect::<Vec<_>>())
        };
        let text =
            |name: &str, f: fn(Row) -> String| Column::new(name.into(), all().map(|(_, r)| f(r)).collect::<Vec<_>>());
        let number = |name: &str, f: fn(Row) -> Option<f64>| {
            Column::new(name.into(), all().map(|(_, row)| f(row)).collect::<Vec<_>>())
        };
        let columns = vec![
            of_entry("campaign", |e| Some(e.campaign.clone())),
            of_entry("name", |e| Some(e.name.clone())),
            of_entry("robot", |e| e.robot.clone()),
            of_entry("date", |e| e.date.clone()),
            of_entry("verdict", |e| Some(e.ended.name().to_owned())),
            text("kind", |r| r.kind.to_owned()),
            text("item", |r| r.item),
            text("unit", |r| r.unit),
            number("value", |r| Some(r.value)),
            number("standard_uncertainty", |r| r.standard_uncertainty),
            number("nominal", |r| r.nominal),
            number("limit", |r| r.limit),
            Column::new("met".into(), all().map(|(_, row)| row.met).collect::<Vec<_>>()),
        ];
        Ok(DataFrame::new(all().count(), columns)?)
    }

    /// The same as Parquet.
    pub fn parquet(&self) -> Result<Vec<u8>> {
        table::to_parquet(&mut self.table()?)
    }
}

/// The campaigns that arguments name: folders, their `campaign.toml`, and lists of them, one a line, `#` before a remark.
pub fn folders(named: &[PathBuf]) -> Result<Vec<PathBuf>> {
    let mut all = Vec::new();
    let mut problems = Problems::default();
    for path in named {
        if path.is_dir() || path.extension().is_some_and(|ending| ending == "toml") {
            all.push(path.clone());
            continue;
        }
        let Some(text) = problems.keep(crate::base::files::read_text(path)) else { continue };
        let lines = text.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with('#'));
        // beside the list, as paths in a campaign are beside it
        all.extend(lines.map(|line| path.parent().unwrap_or(Path::new("")).join(line)));
    }
    let mut sorted: Vec<&PathBuf> = all.iter().collect();
    sorted.sort();
    for pair in sorted.windows(2).filter(|pair| pair[0] == pair[1]) {
        problems.0.push(Message::error(format!("`{}` is named twice", pair[0].display())));
    }
    problems.check()?;
    Ok(all)
}
