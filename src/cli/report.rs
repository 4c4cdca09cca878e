//! Command `etalon report`.

use super::{Output, Verdict};
use crate::run::documents::{self, Documents};
use crate::run::output::changed_inputs;
use crate::run::results;
use crate::stages::truncated;
use etalon_base::files;
use etalon_base::message::{Problems, Result};
use etalon_base::{error, warning};
use etalon_controllers::CERTIFICATE;
use etalon_documents::{Language, Presentation};
use etalon_report::Renderer;
use etalon_report::branding;
use std::path::{Path, PathBuf};

/// Maximum number of changed inputs in a message.
const NAMED: usize = 5;

/// Write the report again from the documents of an output folder.
///
/// Language, logo and templates come from the campaign, unless an option sets them.
#[derive(Debug, clap::Args)]
pub struct ReportCommand {
    /// Folder that `etalon run` wrote, or its campaign.
    #[arg(required_unless_present = "write_templates")]
    folder: Option<PathBuf>,
    #[command(flatten)]
    branding: Branding,
    /// Write the certificate for the customer instead: certificate.html and certificate.pdf.
    #[arg(long, conflicts_with = "write_templates")]
    certificate: bool,
    /// Write the built-in templates to this folder instead.
    #[arg(long, value_name = "FOLDER", conflicts_with = "folder")]
    write_templates: Option<PathBuf>,
    /// Print the names of the files written as JSON.
    #[arg(long)]
    json: bool,
}

/// Language, logo and templates of a report.
#[derive(Debug, clap::Args)]
pub(super) struct Branding {
    /// Language of the report.
    #[arg(long, value_enum)]
    language: Option<Language>,
    /// Logo of the laboratory (SVG or PNG).
    #[arg(long, value_name = "FILE")]
    logo: Option<PathBuf>,
    /// Folder of templates that replace the built-in ones of the same name.
    #[arg(long, value_name = "FOLDER")]
    templates: Option<PathBuf>,
}

impl Branding {
    /// Presentation by the options, with defaults from `campaign`.
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

/// Reports of an answer.
#[derive(Debug, clap::Args)]
pub(super) struct Reports {
    /// Write a report in the format of the file extension: .html, .pdf or .xlsx; may be repeated.
    #[arg(long = "report", value_name = "FILE")]
    files: Vec<PathBuf>,
    #[command(flatten)]
    branding: Branding,
}

impl Reports {
    /// Checks files and their kinds before anything is computed: unknown extensions and input files
    /// are rejected.
    pub fn check<'a>(&'a self, inputs: impl IntoIterator<Item = &'a PathBuf, IntoIter: Clone>) -> Result<()> {
        let wrong = self.files.iter().filter_map(|path| kind(path).err());
        Problems(wrong.flat_map(|more| more.0).collect()).check()?;
        files::refuse_overwriting(&self.files, inputs.into_iter())
    }

    /// Presentation by the options, with defaults from `campaign`.
    pub fn over(&self, campaign: Presentation) -> Result<Presentation> {
        self.branding.over(campaign)
    }

    /// Writes the reports.
    pub fn write(&self, renderer: &Renderer) -> Result<()> {
        self.files.iter().try_for_each(|path| files::write(path, &renderer.file(&kind(path)?)?))
    }
}

/// Kind of a report by its file extension.
fn kind(path: &Path) -> Result<String> {
    let ending = path.extension().and_then(|e| e.to_str()).map(str::to_lowercase).unwrap_or_default();
    if etalon_report::kinds().any(|kind| kind == ending) {
        return Ok(ending);
    }
    let kinds: Vec<String> = etalon_report::kinds().map(|kind| format!(".{kind}")).collect();
    Err(error!("not-a-report", file = path.display().to_string(), endings = kinds).into())
}

impl ReportCommand {
    pub(super) fn run(self, out: &Output) -> anyhow::Result<Verdict> {
        let written = match &self.write_templates {
            Some(folder) => {
                let templates = etalon_report::templates().map(|(name, text)| (name, text.as_bytes().to_vec()));
                files::write_new(folder, &templates.collect::<Vec<_>>())?
            }
            None => self.report(out)?,
        };
        out.print_written(written, self.json)?;
        Ok(Verdict::Met)
    }

    /// Writes the report or the certificate; returns the paths.
    fn report(&self, out: &Output) -> Result<Vec<String>> {
        let folder = self.folder.as_deref().unwrap_or(Path::new(""));
        let documents = Documents::open(&documents::output_folder(folder)?)?;
        let mut results = results::read(&documents)?;
        let changed = changed_inputs(&documents)?;
        let changed = truncated(changed.iter().map(|name| format!("`{name}`")), NAMED);
        match (changed.is_empty(), self.certificate) {
            (true, _) => {}
            // a signature is for the present statements of the campaign
            (false, true) => return Err(error!("certificate-of-earlier-inputs", files = changed).into()),
            (false, false) => out.remark(&[warning!("report-of-earlier-inputs", files = changed)]),
        }
        // a hash in the report is the hash of the file in the folder; `export` writes a missing one
        let listed = results.campaign.controller_files.iter().filter(|file| file.sha256.is_some());
        let listed = listed.filter(|file| documents.path(&file.file).exists());
        let changed: Vec<_> = listed.filter_map(|file| documents.bytes(&file.file).err()).collect();
        Problems(changed.into_iter().flat_map(|more| more.0).collect()).check()?;
        results.campaign.report = self.branding.over(results.campaign.report)?;
        let exported = documents.manifest.files.contains_key(CERTIFICATE);
        let exported = exported.then(|| documents.bytes(CERTIFICATE)).transpose()?;
        let attached = |renderer: Renderer| renderer.with_certificate(CERTIFICATE, exported.as_deref());
        let files = match self.certificate {
            true => attached(Renderer::certificate(&results)?).certificate_files()?,
            false => attached(Renderer::campaign(&results)?).files()?,
        };
        documents.write(files.into_iter().map(|(name, bytes)| (name.to_owned(), bytes)).collect())
    }
}
