//! Tasks of `etalon run` and `etalon validate`.

use super::validity::later_than_today;
use crate::run::documents::{parse_field, parse_parameters, read_parameters};
use crate::run::pipeline::{Outcome, Wanted, run_for};
use crate::run::validation;
use crate::stages::verify::validation::{Validated, Validation};
use etalon_base::files;
use etalon_base::folder::Durability;
use etalon_base::message::{Message, Result};
use etalon_campaign::Campaign;
use etalon_documents::{FieldDocument, FrameOrigin, ParametersDocument, Results, to_json};
use etalon_report::Renderer;
use serde::Deserialize;
use std::borrow::Cow;
use std::path::{Path, PathBuf};

/// A campaign that has run.
#[derive(Debug)]
pub struct Ran {
    /// Output folder.
    pub folder: PathBuf,
    /// Results.
    pub results: Results,
    /// The report, if requested.
    pub renderer: Option<Renderer>,
    /// Messages of the results, and of dates later than today.
    pub messages: Vec<Message>,
}

/// Runs a campaign, and writes its output folder.
///
/// # Errors
/// Reports everything that is wrong with the campaign; nothing is written.
pub fn run(campaign: &Campaign, wanted: Wanted) -> Result<Ran> {
    let Outcome { results, renderer, .. } = run_for(campaign, wanted, Durability::Now)?;
    let messages = results.messages().cloned().chain(later_than_today(campaign)).collect();
    Ok(Ran { folder: campaign.output()?, results, renderer, messages })
}

/// A JSON document.
#[derive(Clone, Copy, Debug)]
pub enum Document<'a> {
    /// A file.
    File(&'a Path),
    /// A text in memory.
    Text {
        /// Name for messages and for the list of inputs.
        name: &'a str,
        /// JSON text.
        text: &'a str,
    },
}

/// Parameters that are judged.
#[derive(Clone, Copy, Debug)]
pub struct GivenParameters<'a> {
    /// `parameters.json`.
    pub parameters: Document<'a>,
    /// Residual field that belongs to the parameters: `field.json`.
    pub field: Option<Document<'a>>,
}

/// Options of a validation.
#[derive(Clone, Debug, Default, clap::Args, Deserialize)]
#[serde(default)]
pub struct ValidateOptions {
    /// Origin of base and targets.
    #[arg(long, value_enum, default_value_t = FrameOrigin::Refit)]
    pub frames: FrameOrigin,
}

/// Judges given parameters on the data of a campaign; nominal parameters if none are given.
///
/// # Errors
/// Fails for a campaign or a document that cannot be read, and for parameters of another robot.
pub fn validate(campaign: &Campaign, given: Option<GivenParameters>, options: &ValidateOptions) -> Result<Validated> {
    let (document, field) = match &given {
        Some(given) => (Some(given.parameters.parameters()?), given.read_field()?),
        None => (None, None),
    };
    let judged = Validation { document: document.as_ref(), field: field.as_ref(), frames: options.frames };
    let mut found = validation::validate(campaign, judged)?;
    if let (Some(provenance), Some(GivenParameters { parameters, field })) = (&mut found.accuracy.provenance, given) {
        for document in [parameters].into_iter().chain(field) {
            provenance.inputs.insert(document.path().display().to_string(), files::sha256(&document.bytes()?));
        }
    }
    Ok(found)
}

impl GivenParameters<'_> {
    /// Reads the residual field, which belongs to the parameters as written or as in memory.
    fn read_field(&self) -> Result<Option<FieldDocument>> {
        let Some(field) = &self.field else { return Ok(None) };
        let written = match self.parameters {
            Document::File(path) => files::read(path)?,
            Document::Text { .. } => to_json(&self.parameters.parameters()?)?,
        };
        parse_field(field.path(), &field.bytes()?, self.parameters.path(), &files::sha256(&written)).map(Some)
    }
}

impl Document<'_> {
    fn parameters(&self) -> Result<ParametersDocument> {
        match self {
            Self::File(path) => read_parameters(path),
            Self::Text { name, text } => parse_parameters(name, text),
        }
    }

    fn path(&self) -> &Path {
        match self {
            Self::File(path) => path,
            Self::Text { name, .. } => Path::new(name),
        }
    }

    fn bytes(&self) -> Result<Cow<'_, [u8]>> {
        match self {
            Self::File(path) => files::read(path).map(Cow::Owned),
            Self::Text { text, .. } => Ok(text.as_bytes().into()),
        }
    }
}
