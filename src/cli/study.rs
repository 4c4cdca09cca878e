//! Command `etalon study`.

use super::{Output, Verdict};
use crate::simulate::study::StudyFile;
use etalon_base::{files, phrase};
use etalon_campaign::read_robot;
use etalon_documents::{Provenance, Spread, StudiesDocument, to_json};
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Compare sets of poses and instruments before measuring, by simulated calibrations.
#[derive(Debug, clap::Args)]
pub struct StudyCommand {
    /// Study file: robot, truth, noise, sets of poses, workspace.
    study: PathBuf,
    /// Print the answer as JSON.
    #[arg(long)]
    json: bool,
}

impl StudyCommand {
    pub(super) fn run(self, out: &Output) -> anyhow::Result<Verdict> {
        let file = StudyFile::read(&self.study)?;
        let folder = self.study.parent().unwrap_or(Path::new("."));
        let robot_path = folder.join(&file.robot);
        let robot = read_robot(&robot_path)?.build(&file.targets)?;
        let (mut begun, of) = (0, file.sets.len() * file.noise_um.len());
        let designs = file.run(robot.as_ref(), folder, |name| {
            begun += 1;
            out.say(format_args!("{begun} of {of}: {name}, {} draws", file.draws));
        })?;
        let tables = file.tables().map(|table| folder.join(table));
        let inputs: Vec<PathBuf> = [self.study.clone(), robot_path].into_iter().chain(tables).collect();
        let document = StudiesDocument {
            schema: "etalon/study/1".to_owned(),
            robot: robot.model().to_owned(),
            error: file.frame.error().into(),
            runs: file.runs,
            draws: file.draws,
            designs,
            provenance: Provenance {
                version: env!("CARGO_PKG_VERSION").to_owned(),
                inputs: files::sha256_by_name(&inputs)?,
                seed: Some(file.seed),
            },
        };
        out.print(if self.json { to_json(&document)? } else { text(&document).into_bytes() })?;
        Ok(Verdict::Met)
    }
}

/// Answer for a terminal: errors of all sets, then their parameters.
fn text(document: &StudiesDocument) -> String {
    let StudiesDocument { runs, draws, .. } = document;
    let mut out = format!("{}\n\n", phrase!("study-head", error = document.error, runs, draws));
    let [set, noise] = [phrase!("study-set"), phrase!("study-noise")].map(|head| head.to_string());
    let shown = |s: &Spread| format!("{:.4} [{:.4}, {:.4}]", s.median, s.low, s.high);
    let heads = [phrase!("study-error"), phrase!("study-rms-before"), phrase!("study-rms"), phrase!("study-largest")];
    let [error, before, rms, largest] = heads.map(|head| head.to_string());
    let _ = writeln!(out, "{set:<22}{noise:>9}  {error:<12}{:<5}{before:>12}  {rms:<28}{largest}", "");
    for d in &document.designs {
        for e in &d.after {
            let before = d.before.iter().find(|b| b.quantity == e.quantity).map_or(f64::NAN, |b| b.rms.median);
            let (rms, max) = (shown(&e.rms), shown(&e.max));
            let _ = writeln!(
                out,
                "{:<22}{:>9}  {:<12}{:<5}{before:>12.4}  {rms:<28}{max}",
                d.name, d.noise_um, e.quantity, e.unit
            );
        }
    }
    let heads = [phrase!("study-parameter"), phrase!("study-actual"), phrase!("study-mean"), phrase!("study-spread")];
    let [parameter, actual, mean, spread] = heads.map(|head| head.to_string());
    let _ = writeln!(out, "\n{set:<22}{noise:>9}  {parameter:<18}{:<5}{actual:>12}  {mean:<34}{spread}", "");
    for d in &document.designs {
        for p in &d.parameters {
            let (mean, three) = (shown(&p.mean), shown(&p.three_standard_deviations));
            let _ = writeln!(
                out,
                "{:<22}{:>9}  {:<18}{:<5}{:>12.4}  {mean:<34}{three}",
                d.name, d.noise_um, p.name, p.unit, p.actual
            );
        }
    }
    out
}
