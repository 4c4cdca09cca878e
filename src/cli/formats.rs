//! Command `etalon formats`.

use super::{Verdict, next_step, print};
use etalon_campaign::read_robot;
use etalon_formats::{FilesProposal, propose_file_for, propose_files};
use std::path::PathBuf;

/// Propose how to read and join files, with reasons and doubts, as lines for campaign.toml.
#[derive(Debug, clap::Args)]
pub struct Formats {
    /// Files to read.
    #[arg(required = true)]
    files: Vec<PathBuf>,
    /// Robot file: its nominal kinematics test order, units and directions of joints.
    #[arg(long, value_name = "FILE")]
    robot: Option<PathBuf>,
    /// Print all readings as JSON, one document per file.
    #[arg(long)]
    json: bool,
}

impl Formats {
    pub(super) fn run(self) -> anyhow::Result<Verdict> {
        let robot = match &self.robot {
            Some(path) => Some(read_robot(path)?.build(&["target".to_owned()])?),
            None => None,
        };
        let robot = robot.as_deref();
        match &self.files[..] {
            [file] => {
                let document = propose_file_for(file, robot)?;
                let text = document.toml.clone().into_bytes();
                print(if self.json { etalon_documents::to_json(&document)? } else { text })?;
            }
            files => {
                let FilesProposal { documents, toml } = propose_files(files, robot)?;
                print(if self.json { etalon_documents::to_json(&documents)? } else { toml.into_bytes() })?;
            }
        }
        next_step(self.json, "paste these lines into campaign.toml; `etalon check FOLDER` tries them");
        Ok(Verdict::Met)
    }
}
