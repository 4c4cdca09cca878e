//! `etalon run`

use super::{Verdict, print, say};
use crate::base::message::Message;
use crate::campaign::Campaign;
use crate::document::{AccuracySet, Characteristics, LimitVerdict};
use crate::run::output::to_json;
use crate::run::pipeline::{self, Outcome};
use std::fmt::Write;
use std::path::PathBuf;

/// Run a campaign from its exports to the report
#[derive(Debug, clap::Args)]
pub struct Run {
    /// Folder of the campaign, or its campaign.toml
    campaign: PathBuf,
    /// Print accuracy.json (of a test by ISO 9283 alone iso9283.json, or what stands in its place) instead of a summary
    #[arg(long)]
    json: bool,
    /// Skip a campaign whose data hang on an environment variable that is not set
    #[arg(long)]
    skip_missing: bool,
}

impl Run {
    pub(super) fn run(self) -> anyhow::Result<Verdict> {
        let result = self.campaign();
        if let (Err(_), Some(report)) = (&result, self.earlier()) {
            let what =
                format!("nothing is written: `{}` and the files beside it are of an earlier run", report.display());
            say(format_args!(
                "{}\n",
                Message::warning(what).hint("do not load its controller files as if they were of this one")
            ));
        }
        result
    }

    /// The report of an earlier run, if there is one.
    fn earlier(&self) -> Option<PathBuf> {
        let (campaign, _) = Campaign::recover(&self.campaign).ok()?;
        Some(campaign?.output().ok()?.join("report.html")).filter(|report| report.is_file())
    }

    fn campaign(&self) -> anyhow::Result<Verdict> {
        let campaign = Campaign::read(&self.campaign)?;
        if let Some(name) = campaign.missing_variable().filter(|_| self.skip_missing) {
            say(format_args!("skipped: {} needs data below ${name}, which is not set", campaign.path));
            return Ok(Verdict::Met);
        }
        let Outcome { identified, tested, met, messages, .. } = pipeline::run(&campaign)?;
        for message in &messages {
            say(format_args!("{message}\n"));
        }
        if self.json {
            print(match (&identified, &tested.poses, &tested.streams) {
                (Some(found), ..) => to_json(&found.accuracy)?,
                (None, Some(poses), _) => to_json(poses)?,
                (None, None, Some(streams)) => to_json(streams)?,
                (None, None, None) => to_json(&tested.compliance)?,
            })?;
        } else {
            let mut text = format!("{}\n", campaign.file.name);
            if let Some(found) = &identified {
                found.accuracy.sets.iter().for_each(|set| text.push_str(&summary(set)));
                found.accuracy.limits.iter().for_each(|limit| text.push_str(&verdict(limit)));
            }
            text.push_str(&characteristics(&tested));
            let _ = writeln!(text, "report: {}", campaign.output()?.join("report.html").display());
            print(text)?;
        }
        if identified.is_some_and(|found| !found.parameters.is_plausible()) {
            say("no controller file is written: this result cannot be the robot");
        }
        Ok(if met { Verdict::Met } else { Verdict::LimitNotMet })
    }
}

/// What tests by ISO 9283 found; recorded motions each below its name.
fn characteristics(found: &Characteristics) -> String {
    let mut text = String::new();
    if let Some(document) = &found.poses {
        text.push_str(&super::iso9283::as_text(document, true));
        document.limits.iter().for_each(|limit| text.push_str(&verdict(limit)));
    }
    for s in found.streams.iter().flat_map(|d| &d.streams) {
        let _ = write!(text, "{}: {}", s.name, super::iso9283::stream_as_text(&s.stream, false));
    }
    let loads = found.compliance.iter().map(super::iso9283::compliance_as_text);
    loads.for_each(|told| told.lines().for_each(|line| text.push_str(&format!("compliance {line}\n"))));
    text
}

fn summary(set: &AccuracySet) -> String {
    let mut text = format!("{}: {} poses, {} errors, before -> after\n", set.name, set.poses, set.count);
    for e in &set.errors {
        let pair = |b: f64, a: f64| format!("{b:.4} -> {a:.4}");
        let _ = writeln!(
            text,
            "  {:<11} {:<3}  mean {}  rms {}  95 % {}  max {}",
            e.quantity,
            e.unit,
            pair(e.before.mean, e.after.mean),
            pair(e.before.rms, e.after.rms),
            pair(e.before.p95, e.after.p95),
            pair(e.before.max, e.after.max)
        );
    }
    text
}

fn verdict(limit: &LimitVerdict) -> String {
    let word = if limit.met { "met" } else { "NOT MET" };
    format!("limit {}: {word}, {:.4} of {} {}\n", limit.name, limit.value, limit.limit, limit.unit)
}
