//! `etalon export`

use super::{Verdict, print_written};
use crate::base::files;
use crate::base::message::{Message, Problems};
use crate::export::{self, Exporter};
use crate::run::documents::{Documents, read_parameters};
use std::path::{Path, PathBuf};

/// Write identified parameters as a file that a controller or another program loads
#[derive(Debug, clap::Args)]
pub struct Export {
    /// parameters.json of a run
    parameters: PathBuf,
    /// Format; all if none is named; may be repeated
    #[arg(long, value_name = "NAME")]
    format: Vec<String>,
    /// Folder to write to; the one of parameters.json by default
    #[arg(long, value_name = "FOLDER")]
    to: Option<PathBuf>,
    /// Print the names of the files written as JSON
    #[arg(long)]
    json: bool,
}

impl Export {
    pub(super) fn run(self) -> anyhow::Result<Verdict> {
        let folder = self.parameters.parent().unwrap_or(Path::new("")).to_owned();
        let parameters = read_parameters(&self.parameters)?;
        let wanted =
            if self.format.is_empty() { export::names().map(str::to_owned).collect::<Vec<_>>() } else { self.format };
        let to = self.to.unwrap_or(folder);
        let exporter = |name: &String| {
            let wrong = || Message::error(format!("`{name}` is not a controller format"));
            export::by_name(name).ok_or_else(|| Problems::from(wrong().hint_names(name, export::names())))
        };
        let exporters = wanted.iter().map(exporter).collect::<Result<Vec<_>, _>>()?;
        let file = |e: &dyn Exporter| Ok((e.file_name().to_owned(), e.write(&parameters)?));
        let files = exporters.into_iter().map(file).collect::<Result<Vec<_>, Problems>>()?;
        let written = match Documents::open(&to) {
            Ok(run) => run.write(files)?,
            Err(_) => files::write_all(&to, &files)?,
        };
        print_written(written, self.json)?;
        Ok(Verdict::Met)
    }
}
