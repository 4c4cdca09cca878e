//! Command `etalon formats`.

use super::{Output, Verdict};
use crate::tasks::start::refusal_of_lines;
use etalon_base::phrase;
use etalon_campaign::read_robot;
use etalon_formats::{FilesProposal, has_several_tables, propose_file_for, propose_files};
use std::path::{Path, PathBuf};

/// Propose how to read and join files, as lines for campaign.toml with reasons and doubts.
#[derive(Debug, clap::Args)]
pub struct Formats {
    /// Files to read.
    #[arg(required = true)]
    files: Vec<PathBuf>,
    /// Robot file, whose nominal kinematics shows the order, units and directions of the joints.
    #[arg(long, value_name = "FILE")]
    robot: Option<PathBuf>,
    /// Print all readings as JSON, one document per file.
    #[arg(long)]
    json: bool,
}

impl Formats {
    pub(super) fn run(self, out: &Output) -> anyhow::Result<Verdict> {
        let robot = match &self.robot {
            Some(path) => {
                let robot = read_robot(path)?;
                Some(robot.build(&robot.targets_or("target"))?)
            }
            None => None,
        };
        let robot = robot.as_deref();
        let mut refusal = None;
        let mut lines = String::new();
        match &self.files[..] {
            [file] if self.json || !has_several_tables(file) => {
                let mut document = propose_file_for(file, robot)?;
                document.toml = in_campaign(document.toml, std::slice::from_ref(file));
                let text = document.toml.clone().into_bytes();
                lines.clone_from(&document.toml);
                out.print(if self.json { etalon_documents::to_json(&document)? } else { text })?;
            }
            files => {
                let FilesProposal { documents, toml, .. } = propose_files(files, robot)?;
                if let (Some(path), false) = (&self.robot, self.json) {
                    refusal = refusal_of_lines(path, files, &toml);
                }
                let toml = in_campaign(toml, files);
                lines.clone_from(&toml);
                out.print(if self.json { etalon_documents::to_json(&documents)? } else { toml.into_bytes() })?;
            }
        }
        if toml::from_str::<toml::Table>(&lines).is_ok_and(|stated| stated.is_empty()) {
            // comments alone: there is nothing to paste
            return Ok(Verdict::Met);
        }
        let next = phrase!("next-paste");
        match refusal {
            Some(reasons) => out.next_step(self.json, phrase!("next-paste-refused", next, reasons)),
            None => out.next_step(self.json, next),
        }
        Ok(Verdict::Met)
    }
}

/// Lines with the paths of files as the campaign in one of their folders names them, if there is
/// such a campaign.
fn in_campaign(lines: String, files: &[PathBuf]) -> String {
    let quoted = |text: &str| toml::Value::from(text).to_string();
    let of_campaign = |file: &Path| {
        let folder = file.ancestors().skip(1).find(|folder| folder.join("campaign.toml").is_file())?;
        Some(file.strip_prefix(folder).ok()?.display().to_string())
    };
    files.iter().fold(lines, |lines, file| match of_campaign(file) {
        Some(name) => lines.replace(&quoted(&file.display().to_string()), &quoted(&name)),
        None => lines,
    })
}
