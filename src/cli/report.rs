//! `etalon report`

use super::{Verdict, print_written};
use crate::base::files;
use crate::base::message::{Message, Problems, Result};
use crate::base::table;
use crate::document::{AccuracyDocument, CampaignSummary, Characteristics, Language, ParametersDocument, Presentation};
use crate::report;
use crate::report::branding;
use crate::stages::evaluate;
use serde::de::DeserializeOwned;
use std::path::{Path, PathBuf};

/// Write the report again from the documents of an output folder
///
/// Language, logo and templates are those of the campaign, unless they are stated here.
#[derive(Debug, clap::Args)]
pub struct Report {
    /// Folder that `etalon run` wrote
    #[arg(required_unless_present = "write_templates")]
    folder: Option<PathBuf>,
    #[command(flatten)]
    dressed: Dressed,
    /// Write the built-in templates to this folder instead
    #[arg(long, value_name = "FOLDER", conflicts_with = "folder")]
    write_templates: Option<PathBuf>,
    /// Print the names of the files written as JSON
    #[arg(long)]
    json: bool,
}

/// Language, logo and templates of a report.
#[derive(Debug, clap::Args)]
pub(super) struct Dressed {
    /// Language of the report
    #[arg(long, value_enum)]
    language: Option<Language>,
    /// Logo of the laboratory, SVG or PNG
    #[arg(long, value_name = "FILE")]
    logo: Option<PathBuf>,
    /// Templates that replace the built-in ones of the same name
    #[arg(long, value_name = "FOLDER")]
    templates: Option<PathBuf>,
}

impl Dressed {
    /// The options, and for the rest the statements of `campaign`.
    pub fn over(&self, campaign: Presentation) -> Result<Presentation> {
        let logo = self.logo.as_deref().map(branding::logo).transpose()?;
        let templates = self.templates.as_deref().map(branding::templates).transpose()?;
        Ok(Presentation {
            language: self.language.unwrap_or(campaign.language),
            logo: logo.or(campaign.logo),
            templates: templates.unwrap_or(campaign.templates),
        })
    }
}

impl Report {
    pub(super) fn run(self) -> anyhow::Result<Verdict> {
        let written = match (&self.folder, &self.write_templates) {
            (_, Some(folder)) => write_templates(folder)?,
            (Some(folder), None) => write_report(folder, &self.dressed)?,
            (None, None) => return Err(Problems::from(Message::error("no folder is stated")).into()),
        };
        print_written(written, self.json)?;
        Ok(Verdict::Met)
    }
}

fn write_report(folder: &Path, dressed: &Dressed) -> Result<Vec<String>> {
    let optional = |name: &str| folder.join(name).is_file();
    let tested = Characteristics {
        poses: optional("iso9283.json").then(|| document(folder, "iso9283.json")).transpose()?,
        streams: optional("iso9283-streams.json").then(|| document(folder, "iso9283-streams.json")).transpose()?,
        compliance: optional("iso9283-compliance.json")
            .then(|| document(folder, "iso9283-compliance.json"))
            .transpose()?,
    };
    let mut campaign: CampaignSummary = document(folder, "campaign.json")?;
    campaign.report = dressed.over(campaign.report)?;
    let import = document(folder, "import.json")?;
    let (features, frames) = (document(folder, "features.json")?, document(folder, "frames.json")?);
    // a campaign that only tests has no parameters
    let documents = match optional("parameters.json") || tested.is_empty() {
        false => None,
        true => Some((
            document::<ParametersDocument>(folder, "parameters.json")?,
            document::<AccuracyDocument>(folder, "accuracy.json")?,
            evaluate::from_table(&table::read_parquet(&folder.join("residuals.parquet"))?)?,
            optional("geometric.json").then(|| document(folder, "geometric.json")).transpose()?,
        )),
    };
    let identified = documents.as_ref().map(|(parameters, accuracy, errors, geometric)| report::Identified {
        parameters,
        accuracy,
        errors,
        geometric: geometric.as_ref(),
    });
    let faces = report::Faces::campaign(&report::Report {
        campaign: &campaign,
        import: &import,
        features: &features,
        frames: &frames,
        identified,
        tested: &tested,
    })?;
    let write = |(name, bytes): (&str, Vec<u8>)| {
        let path = folder.join(name);
        files::write(&path, &bytes)?;
        Ok(path.display().to_string())
    };
    faces.files()?.into_iter().map(write).collect()
}

/// Writes the built-in templates, over none that is there.
fn write_templates(folder: &Path) -> Result<Vec<String>> {
    let named: Vec<(PathBuf, &str)> = report::templates().map(|(name, text)| (folder.join(name), text)).collect();
    if let Some((path, _)) = named.iter().find(|(path, _)| path.exists()) {
        let message = Message::error(format!("`{}` is there already", path.display()));
        return Err(message.hint("name a new folder").into());
    }
    for (path, text) in &named {
        files::write(path, text.as_bytes())?;
    }
    Ok(named.iter().map(|(path, _)| path.display().to_string()).collect())
}

/// A document that an earlier stage wrote.
pub(super) fn document<T: DeserializeOwned>(folder: &Path, name: &str) -> Result<T> {
    let path = folder.join(name);
    let bytes = files::read(&path)?;
    serde_json::from_slice(&bytes).map_err(|e| {
        let what = format!("`{}` is not the document that this version writes: {e}", path.display());
        Message::error(what).hint("run the campaign again").into()
    })
}
