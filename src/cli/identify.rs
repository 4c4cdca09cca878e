//! Command `etalon identify`.

use super::{Output, Verdict};
use crate::tasks::{IdentifyOptions, Inputs, Table, identify};
use etalon_campaign::read_robot;
use etalon_documents::to_json;
use etalon_report::Renderer;
use std::path::PathBuf;

/// Identify the parameters of a robot from a table of observations, without a campaign.
#[derive(Debug, clap::Args)]
pub struct IdentifyCommand {
    /// Robot file.
    #[arg(long)]
    robot: PathBuf,
    /// Observations: CSV with pose,cycle,target,x_mm,y_mm[,z_mm] and one column per joint with its
    /// unit. The column `kind` adds poses, distances, contacts, surfaces and joint values
    /// (docs/observations.md).
    #[arg(long)]
    observations: PathBuf,
    #[command(flatten)]
    options: IdentifyOptions,
    /// Print parameters.json instead of a table.
    #[arg(long)]
    json: bool,
}

impl IdentifyCommand {
    pub(super) fn run(self, out: &Output) -> anyhow::Result<Verdict> {
        let robot = &read_robot(&self.robot)?;
        let (stated, table) = (Table::File(&self.robot), Table::File(&self.observations));
        let document = identify(&Inputs { robot, stated, table }, &self.options)?.document;
        if !self.json {
            out.remark(&document.messages);
        }
        out.answer(&Renderer::identification(&document), self.json.then(|| to_json(&document)).transpose()?)
    }
}
