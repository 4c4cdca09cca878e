//! Controller formats of a campaign: formats by their names, and templates of the campaign's own.

use crate::run::documents::is_file_of_run;
use etalon_base::files::Stamp;
use etalon_base::message::{Place, Result};
use etalon_base::{error, phrase};
use etalon_campaign::Campaign;
use etalon_controllers::{Exporter, OwnFormat};
use etalon_documents::{Source, SourceKind};
use toml::Spanned;

/// The formats that a campaign names, or the usual ones.
pub struct ControllerFormats(Vec<Format>);

enum Format {
    Known(&'static dyn Exporter),
    Own(OwnFormat),
}

/// `true` if an entry of `controllers` is the file of a template.
pub fn is_template(name: &str) -> bool {
    name.ends_with(".j2")
}

impl ControllerFormats {
    /// Reads the templates of a campaign, and adds them to its sources.
    ///
    /// # Errors
    ///
    /// Reports a template that cannot be used.
    pub fn read(campaign: &Campaign, sources: &mut Vec<Source>) -> Result<Self> {
        let known = |name: &str| etalon_controllers::by_name(name).map(Format::Known);
        let Some(stated) = &campaign.file.controllers else {
            return Ok(Self(etalon_controllers::usual().filter_map(known).collect()));
        };
        let mut formats = Vec::new();
        for name in stated {
            match is_template(name.get_ref()) {
                true => {
                    let (format, source) = template(campaign, name)?;
                    sources.push(source);
                    formats.push(Format::Own(format));
                }
                false => formats.extend(known(name.get_ref())),
            }
        }
        Ok(Self(formats))
    }

    /// The formats with their names.
    pub fn all(&self) -> Vec<(&str, &dyn Exporter)> {
        self.0.iter().map(Format::named).collect()
    }
}

impl Format {
    fn named(&self) -> (&str, &dyn Exporter) {
        match self {
            Self::Known(exporter) => (exporter.name(), *exporter),
            Self::Own(own) => (own.name(), own),
        }
    }
}

/// A format from the text of its template, whose file replaces no document of a run.
///
/// # Errors
///
/// Rejects an invalid template, and the name of a document of a run.
pub fn own_format(path: &str, text: String, place: Place) -> Result<OwnFormat> {
    let format = OwnFormat::new(path, text)?;
    match is_file_of_run(format.file_name()) {
        true => Err(error!("template-name-reserved", file = format.file_name()).at(place).into()),
        false => Ok(format),
    }
}

/// Reads a template that a campaign names.
///
/// # Errors
///
/// Reports a template that cannot be read, or whose file replaces a document of the run.
pub fn template(campaign: &Campaign, name: &Spanned<String>) -> Result<(OwnFormat, Source)> {
    let path = campaign.resolve(name)?;
    let (text, bytes) = etalon_formats::read_text(&path, None, &campaign.place(name))?;
    let format = own_format(name.get_ref(), text, campaign.place(name))?;
    let (stamp, holds) = (Stamp::of(&bytes), phrase!("controller-template"));
    let source = Source {
        file: name.get_ref().clone(),
        sha256: stamp.sha256,
        bytes: stamp.size,
        kind: SourceKind::Template,
        dialect: holds.to_string(),
        dialect_phrase: Some(holds),
        rows_read: 0,
        refused: Vec::new(),
        standstills: Vec::new(),
    };
    Ok((format, source))
}
