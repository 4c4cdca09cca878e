//! `etalon validate`

use super::{Verdict, print_with, remark};
use crate::campaign::Campaign;
use crate::document::{AccuracyDocument, GivenFrames, Statistics, to_json};
use crate::run::documents::read_parameters;
use crate::run::validation::validate;
use crate::stages::validation::Validated;
use std::fmt::Write;
use std::path::PathBuf;

/// Judge given parameters on the data of a campaign
///
/// Parameters that were identified with one instrument are compared with what another has measured, or those of last year with
/// measurements of today. Nothing of the robot is identified, and nothing is written; limits of the campaign are judged.
#[derive(Debug, clap::Args)]
#[command(after_help = "Exit code 1 where a limit of the campaign is not met.")]
pub struct Validate {
    /// Folder of the campaign, or its campaign.toml
    campaign: PathBuf,
    /// Identified parameters; nominal ones without
    #[arg(long, value_name = "FILE")]
    parameters: Option<PathBuf>,
    /// Where base and targets come from
    #[arg(long, value_enum, default_value_t = GivenFrames::Refit)]
    frames: GivenFrames,
    /// Print accuracy.json
    #[arg(long)]
    json: bool,
}

impl Validate {
    pub(super) fn run(self) -> anyhow::Result<Verdict> {
        let campaign = Campaign::read(&self.campaign)?;
        let document = self.parameters.as_deref().map(read_parameters).transpose()?;
        let Validated { accuracy, messages } = validate(&campaign, document.as_ref(), self.frames)?;
        remark(&messages);
        let verdict = Verdict::of(accuracy.limits.iter().all(|limit| limit.met));
        let answer = if self.json { to_json(&accuracy)? } else { text(&accuracy).into_bytes() };
        print_with(answer, verdict)
    }
}

/// The errors for a terminal.
fn text(accuracy: &AccuracyDocument) -> String {
    let mut out = format!("errors of {}\n{}\n\n", accuracy.point, accuracy.definition);
    for set in &accuracy.sets {
        let _ = writeln!(out, "{}: {} poses, {} errors; before -> after", set.name, set.poses, set.count);
        for e in &set.errors {
            let pair = |pick: fn(&Statistics) -> f64| format!("{:.4} -> {:.4}", pick(&e.before), pick(&e.after));
            let [mean, rms, max] = [pair(|s| s.mean), pair(|s| s.rms), pair(|s| s.max)];
            let _ = writeln!(out, "  {:<12}{:<4} mean {mean}, RMS {rms}, max {max}", e.quantity, e.unit);
        }
    }
    if let Some(p) = accuracy.given.as_ref().and_then(|given| given.p_value) {
        let _ = writeln!(
            out,
            "probability of such errors by the uncertainty of parameters and measurement: {}",
            super::verify::shown(p)
        );
    }
    for limit in &accuracy.limits {
        let verdict = if limit.met { "met" } else { "NOT MET" };
        let _ = writeln!(out, "limit {} {} {}: {:.4}: {verdict}", limit.name, limit.limit, limit.unit, limit.value);
    }
    out
}
