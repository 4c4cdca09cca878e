//! `etalon recommend`

use super::{Verdict, print, remark};
use crate::base::files;
use crate::base::message::{Message, Problems};
use crate::campaign::Campaign;
use crate::document::{LoadVerdict, RecommendationDocument, to_json};
use crate::run::validation::recommend;
use std::fmt::Write;
use std::path::PathBuf;

/// Which identified parameters deserve to be loaded into the controller
///
/// Effects (zeros, geometry, gains, coupling, bending) are tried on poses that are left out of the identification, and parameters by their
/// change over its uncertainty. Those that are recommended are identified again with all others at their nominal values.
#[derive(Debug, clap::Args)]
pub struct Recommend {
    /// Folder of the campaign, or its campaign.toml
    campaign: PathBuf,
    /// Write the recommended parameters as a new parameters.json, for `etalon export`
    #[arg(long, value_name = "FILE")]
    write: Option<PathBuf>,
    /// Print the answer as JSON
    #[arg(long)]
    json: bool,
}

impl Recommend {
    pub(super) fn run(self) -> anyhow::Result<Verdict> {
        if let Some(path) = self.write.as_deref().filter(|path| path.exists()) {
            let message = Message::error(format!("`{}` is there already: nothing is written over it", path.display()));
            return Err(Problems::from(message.hint("name another file, or remove it")).into());
        }
        let campaign = Campaign::read(&self.campaign)?;
        let answer = recommend(&campaign)?;
        remark(&answer.messages);
        if let Some(path) = &self.write {
            files::write(path, &to_json(&answer.recommended)?)?;
        }
        print(if self.json { to_json(&answer)? } else { text(&answer).into_bytes() })?;
        Ok(Verdict::of(answer.recommended.is_plausible()))
    }
}

/// The answer for a terminal.
fn text(answer: &RecommendationDocument) -> String {
    let mut out = answer.meaning.iter().map(|line| format!("{line}\n")).collect::<String>();
    let _ = writeln!(out, "\n{} poses in {} parts, {} times", answer.poses, answer.folds, answer.repeats);
    let _ = writeln!(
        out,
        "{:<20}{:>11}{:>12}{:>14}{:>10}{:>12}",
        "effect", "identified", "RMS mm", "left out mm", "gain/u", "p"
    );
    for step in &answer.steps {
        let name = step.effect.map_or_else(|| "base and targets".to_owned(), |e| format!("+ {e:?}").to_lowercase());
        let number = |v: Option<f64>| v.map_or_else(String::new, |v| format!("{v:.1}"));
        let p = step.p_value.map(super::verify::shown).unwrap_or_default();
        let verdict = if step.accepted { "" } else { "  not accepted" };
        let (rms, left_out) = (step.rms_mm, step.held_out_rms_mm);
        let _ = writeln!(
            out,
            "{name:<20}{:>11}{rms:>12.4}{left_out:>14.4}{:>10}{p:>12}{verdict}",
            step.identified,
            number(step.gain_over_u)
        );
    }
    let _ =
        writeln!(out, "\n{:<20}{:>14} {:<4}{:>10}{:>12}{:>12}", "parameter", "change", "", "over u", "p", "folds / u");
    for p in &answer.parameters {
        let verdict = if p.verdict == LoadVerdict::Load { "load" } else { "hold" };
        let _ = writeln!(
            out,
            "{:<20}{:>+14.6} {:<4}{:>10.1}{:>12}{:>12.1}  {verdict}",
            p.name,
            p.change,
            p.unit,
            p.change_over_u,
            super::verify::shown(p.p_value),
            p.fold_sd_over_u
        );
    }
    out
}
