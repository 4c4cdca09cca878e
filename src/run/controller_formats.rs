//! Controller formats of a campaign: formats by their names, and templates of the campaign's own.

use crate::run::documents::is_file_of_run;
use etalon_base::catalogue::Phrase;
use etalon_base::files::{self, Stamp};
use etalon_base::message::{Place, Problems, Result};
use etalon_base::{error, phrase};
use etalon_campaign::Campaign;
use etalon_controllers::{Description, Exporter, TemplateFormat};
use etalon_documents::{Source, SourceKind};
use etalon_robots::Robot;
use std::path::Path;
use toml::Spanned;

/// The formats that a campaign names, or the usual ones.
#[derive(Default)]
pub struct ControllerFormats {
    formats: Vec<Format>,
    /// Files of the templates, and the controller's file before loading.
    pub sources: Vec<Source>,
}

enum Format {
    /// A format with the place where the campaign names it; `None` for a usual one.
    Known(&'static dyn Exporter, Option<Place>),
    Template(TemplateFormat),
}

/// `true` if an entry of `controllers` is the file of a template.
fn is_template(name: &str) -> bool {
    name.ends_with(".j2")
}

impl ControllerFormats {
    /// Finds the formats of a campaign, and reads its templates; reports unknown formats and
    /// templates that cannot be used.
    pub fn read(campaign: &Campaign, problems: &mut Problems) -> Self {
        let mut found =
            Self { sources: problems.keep(backup(campaign)).flatten().into_iter().collect(), ..Self::default() };
        let Some(stated) = &campaign.file.controllers else {
            found.formats.extend(etalon_controllers::usual().map(|format| Format::Known(format, None)));
            return found;
        };
        for name in stated {
            let place = campaign.place(name);
            if is_template(name.get_ref()) {
                let Some((format, source)) = problems.keep(template(campaign, name)) else { continue };
                found.sources.push(source);
                found.formats.push(Format::Template(format));
                continue;
            }
            match etalon_controllers::by_name(name.get_ref()) {
                Ok(format) => found.formats.push(Format::Known(format, Some(place))),
                Err(unknown) => problems.0.push(unknown.at(place)),
            }
        }
        found
    }

    /// Rejects formats that do not describe the robot of the campaign, before anything is computed.
    pub fn check(&self, campaign: &Campaign, robot: &dyn Robot, problems: &mut Problems) {
        let description = campaign.robot.description().map(|(file, text)| Description { file, text });
        for format in &self.formats {
            let Format::Known(exporter, Some(place)) = format else { continue };
            let unsuited = exporter.unsuited_to(robot, description);
            problems.0.extend(unsuited.map(|message| message.at(place.clone())));
        }
    }

    /// The formats with their names.
    pub fn all(&self) -> Vec<(&str, &dyn Exporter)> {
        self.formats.iter().map(Format::named).collect()
    }
}

impl Format {
    fn named(&self) -> (&str, &dyn Exporter) {
        match self {
            Self::Known(exporter, _) => (exporter.name(), *exporter),
            Self::Template(format) => (format.name(), format),
        }
    }
}

/// Reads the template of a format, whose file replaces no document of a run, and its bytes.
///
/// # Errors
///
/// Rejects a file that cannot be read, an invalid template, and the name of a document of a run.
pub fn template_format(path: &Path, name: &str, place: Place) -> Result<(TemplateFormat, Vec<u8>)> {
    let (text, bytes) = etalon_formats::read_text(path, None, &place)?;
    let format = TemplateFormat::new(name, text)?;
    match is_file_of_run(format.file_name()) {
        true => Err(error!("template-name-reserved", file = format.file_name()).at(place).into()),
        false => Ok((format, bytes)),
    }
}

/// Reads a template that a campaign names.
///
/// # Errors
///
/// Reports a template that cannot be read, or whose file replaces a document of the run.
fn template(campaign: &Campaign, name: &Spanned<String>) -> Result<(TemplateFormat, Source)> {
    let path = campaign.resolve(name)?;
    let (format, bytes) = template_format(&path, name.get_ref(), campaign.place(name))?;
    Ok((format, source(name.get_ref(), &bytes, SourceKind::Template, phrase!("controller-template"))))
}

/// Reads the controller's file before loading, if the campaign names one.
///
/// # Errors
///
/// Reports a file that cannot be read.
fn backup(campaign: &Campaign) -> Result<Option<Source>> {
    let (Some(name), Some(path)) = (&campaign.file.conditions.robot.controller_backup, campaign.controller_backup())
    else {
        return Ok(None);
    };
    let place = || campaign.key_place(&["conditions", "controller_backup"]);
    let bytes = files::read(&path?).map_err(|problems| problems.at(&place()))?;
    Ok(Some(source(name, &bytes, SourceKind::Backup, phrase!("source-backup"))))
}

/// Source without rows.
fn source(file: &str, bytes: &[u8], kind: SourceKind, read_as: Phrase) -> Source {
    let stamp = Stamp::new(bytes);
    Source {
        file: file.to_owned(),
        sha256: stamp.sha256,
        sha256_without_backup: None,
        bytes: stamp.size,
        kind,
        dialect: read_as.into(),
        rows_read: 0,
        refused: Vec::new(),
        standstills: Vec::new(),
    }
}
