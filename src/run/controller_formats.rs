//! Controller formats of a campaign: formats by their names, and templates of the campaign's own.

use crate::run::documents::is_file_of_run;
use etalon_base::files::Stamp;
use etalon_base::message::Result;
use etalon_base::{error, phrase};
use etalon_campaign::Campaign;
use etalon_controllers::{Exporter, OwnFormat};
use etalon_documents::{Source, SourceKind};
use toml::Spanned;

/// The formats that a campaign names, or the usual ones.
#[derive(Debug)]
pub struct ControllerFormats(Vec<Format>);

#[derive(Debug)]
enum Format {
    Named(&'static str),
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
        let Some(stated) = &campaign.file.controllers else {
            return Ok(Self(etalon_controllers::usual().map(Format::Named).collect()));
        };
        let mut formats = Vec::new();
        for name in stated {
            match is_template(name.get_ref()) {
                true => {
                    let (format, source) = template(campaign, name)?;
                    sources.push(source);
                    formats.push(Format::Own(format));
                }
                false => formats.extend(etalon_controllers::by_name(name.get_ref()).map(|e| Format::Named(e.name()))),
            }
        }
        Ok(Self(formats))
    }

    /// The formats with their names.
    pub fn all(&self) -> Vec<(&str, &dyn Exporter)> {
        self.0.iter().filter_map(Format::exporter).collect()
    }
}

impl Format {
    fn exporter(&self) -> Option<(&str, &dyn Exporter)> {
        match self {
            Self::Named(name) => Some((name, etalon_controllers::by_name(name)?)),
            Self::Own(own) => Some((own.name(), own)),
        }
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
    let format = OwnFormat::new(name.get_ref(), text)?;
    if is_file_of_run(format.file_name()) {
        return Err(error!("template-name-reserved", file = format.file_name()).at(campaign.place(name)).into());
    }
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
