//! `etalon man`.

use super::{Output, Verdict};
use clap::Command;
use etalon_base::files;
use std::path::PathBuf;

/// Write the manual pages.
#[derive(Debug, clap::Args)]
pub struct Man {
    /// Folder of the pages: etalon.1, and etalon-COMMAND.1 of each command.
    folder: PathBuf,
    /// Print the names of the files written as JSON.
    #[arg(long)]
    json: bool,
}

impl Man {
    pub(super) fn run(self, out: &Output) -> anyhow::Result<Verdict> {
        let mut command = super::command().disable_help_subcommand(true).disable_help_flag(true);
        command.build();
        let mut files = Vec::new();
        pages(&command, &mut files)?;
        out.print_written(files::write_all(&self.folder, &files)?, self.json)?;
        Ok(Verdict::Met)
    }
}

/// The page of a command, then the pages of its subcommands.
fn pages(command: &Command, files: &mut Vec<(String, Vec<u8>)>) -> anyhow::Result<()> {
    let page = clap_mangen::Man::new(command.clone());
    let mut text = Vec::new();
    page.render(&mut text)?;
    files.push((page.get_filename(), text));
    // the command line is built, so each command with subcommands has a `help`, which has no page
    let mut inner = command.get_subcommands().filter(|inner| !inner.is_hide_set() && inner.get_name() != "help");
    inner.try_for_each(|inner| pages(inner, files))
}
